//! The impulse plane as SVG.

use crate::FIGURE_CSS;
use crate::impulse::ImpulsePlane;
use crate::markup::{Markup, document, html, joined};
use crate::svg::{self, line, text};
use crate::text::{fixed, px};
use crate::ticks::ticks;
use crate::tolerance::UNSEEN;
use carom_impact::planar::Phase;

const WIDTH: f64 = 460.0;
const LEFT: f64 = 54.0;
const RIGHT: f64 = 20.0;
const TOP: f64 = 26.0;
const PLANE: f64 = 236.0;
const LINE: f64 = 16.0;

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
/// # use {carom_figure::{ImpulsePlane, ImpulsePoint}, carom_impact::planar::Phase};
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
    let inside = html! {
        @if alone { (svg::styled([WIDTH, height], &[FIGURE_CSS])) }
        (axes(&scale))
        (cone(plane, &scale))
        (deciding_lines(plane, &scale))
        (walk(plane, &scale))
        (legend(plane))
    };
    Some(svg::drawing("fig impulse", [WIDTH, height], "Impulse plane", inside))
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

fn cone(plane: &ImpulsePlane, scale: &Scale) -> Markup {
    let mu = plane.friction;
    // Where the cone leaves the shown plane.
    let reach = if mu * scale.normal > scale.half { scale.half / mu } else { scale.normal };
    let (o, base) = (px(scale.x(0.0)), px(scale.y(0.0)));
    let (x, corner) = (px(scale.x(reach)), px(scale.x(scale.normal)));
    let [up, down] = [mu * reach, -mu * reach].map(|tangential| px(scale.y(tangential)));
    let (tx, ty) = (scale.x(0.46 * reach), scale.y(-0.46 * mu * reach));
    html! {
        path.cone d=(format!("M{o} {base}L{x} {up}H{corner}V{down}H{x}Z")) {}
        path.cone-edge d=(format!("M{o} {base}L{x} {up}M{o} {base}L{x} {down}")) {}
        (text("small", [tx - 4.0, ty + 19.0], "end", "cone p\u{209c} = ±μ p\u{2099}"))
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

fn deciding_lines(plane: &ImpulsePlane, scale: &Scale) -> Markup {
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
        // Each label stands where the walk and the cone seldom come: sticking at the upper end, compression at the lower.
        let (low, high) = if p.1 < q.1 { (p, q) } else { (q, p) };
        let upper = class == "sticking";
        let at = if upper { high } else { low };
        let x = scale.x(at.0);
        let left = x > WIDTH - 170.0;
        let (dx, anchor) = match (upper, left || x > 0.45 * WIDTH) {
            (true, true) => (-30.0, "end"),
            (false, _) if left => (-8.0, "end"),
            _ => (8.0, "start"),
        };
        let y = scale.y(at.1) + if upper { 11.0 } else { -6.0 };
        out.push(text(class, [x + dx, y], anchor, label));
    }
    joined(out)
}

fn walk(plane: &ImpulsePlane, scale: &Scale) -> Markup {
    let mut lines: Vec<Markup> = vec![];
    let mut at = [scale.x(0.0), scale.y(0.0)];
    // Dots come after all lines, which would run over them.
    let mut dots = vec![svg::circle("dot", at, 3.0)];
    for (i, p) in plane.points.iter().enumerate() {
        let to = [scale.x(p.normal), scale.y(p.tangential)];
        let class = if p.phase == Phase::Compression { "walk" } else { "walk restitution" };
        lines.push(line(class, at, to));
        dots.push(svg::circle("dot", to, 3.4));
        let below = if p.tangential < 0.0 { 15.0 } else { -7.0 };
        dots.push(text("walk", [to[0] + 6.0, to[1] + below], "start", &(i + 1).to_string()));
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
