//! The impulse plane as SVG.

use crate::FIGURE_CSS;
use crate::impulse::{ImpulsePlane, ImpulsePoint};
use crate::labels::Labels;
use crate::markup::{Markup, document, html, joined};
use crate::svg::{self, line, text};
use crate::text::{fixed, px};
use crate::ticks::ticks;
use crate::tolerance::UNSEEN;
use carom_impact::Phase;
use carom_num::Vec2;

const WIDTH: f64 = 460.0;
const LEFT: f64 = 64.0;
const RIGHT: f64 = 20.0;
const TOP: f64 = 26.0;
const PLANE: f64 = 236.0;
const LINE: f64 = 16.0;
/// From the base line of a text to its middle [px].
const MIDDLE: f64 = 4.0;

struct Scale {
    half: f64,
    normal: f64,
}

impl Scale {
    fn x(&self, normal: f64) -> f64 {
        LEFT + normal / self.normal * (WIDTH - LEFT - RIGHT)
    }

    fn y(&self, tangential: f64) -> f64 {
        TOP + 0.5 * PLANE * (1.0 - tangential / self.half)
    }
}

/// The impulse plane of one contact as a stand-alone SVG: tangential impulse over normal impulse, the friction cone, the line of
/// sticking, the line of maximum compression, and the walked line with its stages. Empty where there is no impulse to draw.
///
/// # Example
/// Two stages are two lines of the walk; without an impulse there is nothing to draw.
/// ```
/// # use carom_figure::{ImpulsePlane, ImpulsePoint};
/// # use carom_impact::Phase;
/// # let point = |normal, tangential, label: &str| ImpulsePoint {
/// #     normal, tangential, phase: Phase::Compression, label: label.to_owned(),
/// # };
/// # let plane = ImpulsePlane {
/// #     operator: Some([3.5, 0.0, 1.0]), slip: 1.05, approach: -2.0, friction: 0.3,
/// #     points: vec![point(1.0, -0.3, "its slip stops"), point(2.0, -0.3, "compression ends")],
/// # };
/// use carom_figure::impulse_svg;
/// assert_eq!(impulse_svg(&plane).matches("<line class=\"walk\"").count(), 2);
/// assert_eq!(impulse_svg(&ImpulsePlane { points: vec![], ..plane }), "");
/// ```
pub fn impulse_svg(plane: &ImpulsePlane) -> String {
    drawing(plane, true).map(document).unwrap_or_default()
}

/// The drawing, with its style inside where it stands alone.
pub(crate) fn drawing(plane: &ImpulsePlane, alone: bool) -> Option<Markup> {
    if !plane.can_be_drawn() {
        return None;
    }
    let (half, normal) = plane.extent();
    let scale = Scale { half, normal };
    let height = TOP + PLANE + 34.0 + LINE * plane.points.len() as f64 + 6.0;
    // The numbers of the stages stand at their dots, those of the axis left of it, and names give way to both.
    let mut labels = Labels::within(Vec2::new(LEFT, 0.0), Vec2::new(WIDTH, TOP + PLANE));
    let numbers = numbers_at(&plane.points, &scale);
    for (i, [x, y]) in numbers.iter().copied().enumerate() {
        let room = Labels::room(&(i + 1).to_string(), Vec2::new(1.0, 0.0));
        labels.keep_off(Vec2::new(x, y - room.y), Vec2::new(x + room.x, y));
    }
    let inside = html! {
        @if alone { (svg::styled([WIDTH, height], &[FIGURE_CSS])) }
        (axes(&scale))
        (cone(plane, &scale, &mut labels))
        (deciding_lines(plane, &scale, &mut labels))
        (walk(plane, &numbers, &scale))
        (legend(plane))
    };
    Some(svg::drawing("fig impulse", [WIDTH, height], "Impulse plane", inside))
}

/// Where the walk is at the start and at the end of each stage.
pub(crate) fn track(plane: &ImpulsePlane) -> Vec<[f64; 2]> {
    let (half, normal) = plane.extent();
    let scale = Scale { half, normal };
    let ends = plane.points.iter().map(|p| [p.normal, p.tangential]);
    std::iter::once([0.0; 2]).chain(ends).map(|[n, t]| [scale.x(n), scale.y(t)]).collect()
}

fn axes(scale: &Scale) -> Markup {
    let (x0, x1, base) = (scale.x(0.0), WIDTH - RIGHT, TOP + PLANE);
    let mut out: Vec<Markup> = vec![];
    let t = ticks(-scale.half, scale.half, 5);
    for v in &t.at {
        let y = scale.y(*v);
        out.push(line(if *v == 0.0 { "zero" } else { "grid" }, [x0, y], [x1, y]));
        out.push(text("tick", [x0 - 6.0, y + 3.8], "end", &fixed(*v, t.decimals)));
    }
    let n = ticks(0.0, scale.normal, 5);
    for v in &n.at {
        let x = scale.x(*v);
        out.push(line("axis", [x, base], [x, base + 4.0]));
        out.push(text("tick", [x, base + 16.0], "middle", &fixed(*v, n.decimals)));
    }
    out.push(svg::path("axis", &format!("M{} {}V{}H{}", px(x0), px(TOP), px(base), px(x1))));
    out.push(text("name", [x0, 15.0], "start", "tangential impulse p\u{209c} [N s]"));
    out.push(text("name", [x1, base + 29.0], "end", "normal impulse p\u{2099} [N s]"));
    joined(out)
}

/// Where the first letter, the last one or the middle of a text may stand.
type Place = ([f64; 2], &'static str);

/// A text at the first of these places that is clear of others.
fn placed(class: &str, label: &str, places: &[Place], labels: &mut Labels) -> Markup {
    let room = Labels::room(label, Vec2::new(1.0, 0.0));
    let middle = |&([x, y], anchor): &Place| {
        let aside = match anchor {
            "start" => 0.5 * room.x,
            "end" => -0.5 * room.x,
            _ => 0.0,
        };
        Vec2::new(x + aside, y - MIDDLE)
    };
    let at = labels.place(room, places.iter().map(middle));
    let own = places.iter().find(|place| middle(place) == at).copied();
    let (at, anchor) = own.unwrap_or(([at.x, at.y + MIDDLE], "middle"));
    text(class, at, anchor, label)
}

fn cone(plane: &ImpulsePlane, scale: &Scale, labels: &mut Labels) -> Markup {
    let mu = plane.friction;
    // Where the cone leaves the shown plane.
    let reach = if mu * scale.normal > scale.half { scale.half / mu } else { scale.normal };
    let (o, base) = (px(scale.x(0.0)), px(scale.y(0.0)));
    let (x, corner) = (px(scale.x(reach)), px(scale.x(scale.normal)));
    let [up, down] = [mu * reach, -mu * reach].map(|tangential| px(scale.y(tangential)));
    // Beside an edge of the cone, nearer to its point or farther.
    let places = [0.46, 0.8].map(|share| {
        let (tx, ty) = (scale.x(share * reach), share * mu * reach);
        [([tx - 4.0, scale.y(-ty) + 19.0], "end"), ([tx - 4.0, scale.y(ty) - 12.0], "end")]
    });
    html! {
        path.cone d=(format!("M{o} {base}L{x} {up}H{corner}V{down}H{x}Z")) {}
        path.cone-edge d=(format!("M{o} {base}L{x} {up}M{o} {base}L{x} {down}")) {}
        (placed("small", "cone p\u{209c} = ±μ p\u{2099}", places.as_flattened(), labels))
    }
}

/// The two ends of `a p_t + b p_n + c = 0` inside the shown plane, as (p_n, p_t).
fn ends(line: [f64; 3], scale: &Scale) -> Option<[(f64, f64); 2]> {
    let [a, b, c] = line;
    let mut found = vec![];
    for normal in [0.0, scale.normal] {
        let t = -(b * normal + c) / a;
        if t.is_finite() && t.abs() <= scale.half {
            found.push((normal, t));
        }
    }
    for t in [-scale.half, scale.half] {
        let normal = -(a * t + c) / b;
        if normal.is_finite() && (0.0..=scale.normal).contains(&normal) {
            found.push((normal, t));
        }
    }
    let first = *found.first()?;
    let far = |p: &(f64, f64)| ((p.0 - first.0) / scale.normal).abs() + ((p.1 - first.1) / scale.half).abs();
    let last = found.iter().copied().max_by(|p, q| far(p).total_cmp(&far(q)))?;
    (far(&last) > UNSEEN).then_some([first, last])
}

fn deciding_lines(plane: &ImpulsePlane, scale: &Scale, labels: &mut Labels) -> Markup {
    let sticking = (plane.line_of_sticking(), "sticking", "sticking u\u{209c} = 0");
    let compression = (plane.line_of_compression(), "compression", "max. compression u\u{2099} = 0");
    let mut out: Vec<Markup> = vec![];
    for (line, class, label) in [sticking, compression] {
        let Some([p, q]) = line.and_then(|line| ends(line, scale)) else {
            if line.is_some() && class == "sticking" {
                let outside = "sticking u\u{209c} = 0: outside";
                out.push(text("sticking", [LEFT + 8.0, TOP + 12.0], "start", outside));
            }
            continue;
        };
        let [from, to] = [p, q].map(|(normal, tangential)| [scale.x(normal), scale.y(tangential)]);
        out.push(svg::line(class, from, to));
        // Where the walk and the cone seldom come: sticking at the upper end, compression at the lower; else along the line.
        let (low, high) = if p.1 < q.1 { (p, q) } else { (q, p) };
        let upper = class == "sticking";
        let between = |share: f64| (low.0 + share * (high.0 - low.0), low.1 + share * (high.1 - low.1));
        let shares = if upper { [1.0, 0.75, 0.5, 0.25, 0.0] } else { [0.0, 0.25, 0.5, 0.75, 1.0] };
        // On its own side of the line first, else on the other.
        let sides = [upper, !upper].map(|upper| shares.map(|share| beside(between(share), upper, scale)));
        out.push(placed(class, label, sides.as_flattened(), labels));
    }
    joined(out)
}

/// Beside a point of a line: below a point of sticking, above one of compression, on the side where there is room.
fn beside(at: (f64, f64), upper: bool, scale: &Scale) -> Place {
    let (x, y) = (scale.x(at.0), scale.y(at.1));
    let left = x > WIDTH - 170.0;
    let (dx, anchor) = match (upper, left || x > 0.45 * WIDTH) {
        (true, true) => (-30.0, "end"),
        (false, _) if left => (-8.0, "end"),
        _ => (8.0, "start"),
    };
    ([x + dx, y + if upper { 11.0 } else { -6.0 }], anchor)
}

/// Where the number of a stage stands: beside the dot at its end, away from the middle.
fn number_at(p: &ImpulsePoint, scale: &Scale) -> [f64; 2] {
    let below = if p.tangential < 0.0 { 15.0 } else { -7.0 };
    [scale.x(p.normal) + 6.0, scale.y(p.tangential) + below]
}

/// The same of every stage; of dots that almost coincide, the numbers stand in a row.
fn numbers_at(points: &[ImpulsePoint], scale: &Scale) -> Vec<[f64; 2]> {
    let mut placed: Vec<[f64; 2]> = vec![];
    for (i, p) in points.iter().enumerate() {
        let [mut x, y] = number_at(p, scale);
        let width = Labels::room(&i.to_string(), Vec2::new(1.0, 0.0)).x + 2.0;
        while placed.iter().any(|[a, b]| (a - x).abs() < width && (b - y).abs() < LINE) {
            x += width;
        }
        placed.push([x, y]);
    }
    placed
}

fn walk(plane: &ImpulsePlane, numbers: &[[f64; 2]], scale: &Scale) -> Markup {
    let mut lines: Vec<Markup> = vec![];
    let mut at = [scale.x(0.0), scale.y(0.0)];
    // Dots come after all lines, which would run over them.
    let mut dots = vec![svg::circle("dot", at, 3.0)];
    for (i, (p, number)) in plane.points.iter().zip(numbers).enumerate() {
        let to = [scale.x(p.normal), scale.y(p.tangential)];
        let class = if p.phase == Phase::Compression { "walk" } else { "walk restitution" };
        lines.push(line(class, at, to));
        dots.push(svg::circle("dot", to, 3.4));
        dots.push(text("walk", *number, "start", &(i + 1).to_string()));
        at = to;
    }
    joined(lines.into_iter().chain(dots))
}

fn legend(plane: &ImpulsePlane) -> Markup {
    let mut y = TOP + PLANE + 34.0 + 12.0;
    let mut out: Vec<Markup> = vec![];
    for (i, p) in plane.points.iter().enumerate() {
        out.push(text("walk", [LEFT - 14.0, y], "end", &(i + 1).to_string()));
        out.push(text("small", [LEFT - 6.0, y], "start", &p.label));
        y += LINE;
    }
    joined(out)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;

    /// A letter is at least so wide, and a line so high [px].
    const LETTER: f64 = 5.0;
    const LINE: f64 = 9.0;

    /// The texts of a drawing with the places of their first letters.
    fn texts(svg: &str) -> Vec<(f64, f64, f64, String)> {
        let one = |part: &str| {
            let value = |key: &str| {
                let from = part.find(&format!(" {key}=\"")).unwrap() + key.len() + 3;
                part[from..].split('"').next().unwrap().to_owned()
            };
            let number = |key: &str| value(key).parse::<f64>().unwrap();
            let inner = part.split("</text>").next().unwrap().split_once('>').unwrap().1;
            let letters: String = inner.split('<').map(|piece| piece.rsplit('>').next().unwrap()).collect();
            let letters: String = letters.chars().filter(|c| *c != '\u{200b}').collect();
            let width = LETTER * letters.chars().count() as f64;
            let aside = match value("text-anchor").as_str() {
                "end" => width,
                "middle" => 0.5 * width,
                _ => 0.0,
            };
            (number("x") - aside, number("y"), width, letters)
        };
        svg.split("<text").skip(1).map(one).collect()
    }

    #[test]
    fn texts_stay_within_the_drawing_where_impulses_are_small() {
        let point = |tangential: f64| ImpulsePoint {
            normal: 1.0e-3,
            tangential,
            phase: Phase::Compression,
            label: "compression: slips +, until slip stops at K".to_owned(),
        };
        let plane = ImpulsePlane {
            operator: None,
            slip: 1.0,
            approach: -1.0,
            friction: 0.5,
            points: vec![point(-4.9e-4), point(-4.91e-4)],
        };
        let texts = texts(&impulse_svg(&plane));
        assert!(texts.iter().any(|(.., text)| text == "−0.0005" || text == "−0.00050"), "{texts:?}");
        for (x, .., text) in &texts {
            // A tick is at 11 px: a digit is 6.4 px wide in the widest of the fonts.
            let wider = (6.4 - LETTER) * text.chars().count() as f64;
            let begins = if text.starts_with('−') { x - wider } else { *x };
            assert!(begins >= 0.0, "{text} begins at {begins}");
        }
        let numbers: Vec<_> =
            texts.iter().filter(|(_, y, _, text)| text == "2" && *y < TOP + PLANE).collect();
        let first = texts.iter().find(|(.., text)| text == "1").unwrap();
        assert!(numbers.iter().all(|number| number.0 > first.0 + LETTER), "{first:?} {numbers:?}");
    }

    /// A rod of 1 kg and 2 m that slides at 60° into its lean with friction 1.6 (Painlevé), and a strike whose lines cross the cone.
    #[test]
    fn no_text_of_an_impulse_plane_lies_on_another() {
        let point = |normal: f64, tangential: f64| ImpulsePoint {
            normal,
            tangential,
            phase: Phase::Compression,
            label: "compression: slips +, until slip stops at K".to_owned(),
        };
        let rod = ImpulsePlane {
            operator: Some([3.25, 1.299_038_105_676_658, 1.75]),
            slip: 1.0,
            approach: 0.0,
            friction: 1.6,
            points: vec![point(0.256_331, -0.410_13), point(0.324_76, -0.4375)],
        };
        let strike = ImpulsePlane {
            operator: Some([3.5, 0.0, 1.0]),
            slip: 1.05,
            approach: -2.0,
            friction: 0.3,
            points: vec![point(1.0, -0.3), point(2.0, -0.3), point(3.0, -0.3)],
        };
        for plane in [rod, strike] {
            let texts = texts(&impulse_svg(&plane));
            assert!(texts.len() > 10, "{texts:?}");
            for (i, (x, y, width, text)) in texts.iter().enumerate() {
                for (other_x, other_y, other_width, other) in &texts[..i] {
                    let apart =
                        x + width <= *other_x || other_x + other_width <= *x || (y - other_y).abs() >= LINE;
                    assert!(apart, "{text:?} at {x}, {y} lies on {other:?} at {other_x}, {other_y}");
                }
            }
        }
    }
}
