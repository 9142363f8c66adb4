//! The impulse plane as SVG.

use crate::FIGURE_CSS;
use crate::impulse::ImpulsePlane;
use crate::text::{escape, fixed, px};
use crate::ticks::ticks;
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
    drawing(plane, true)
}

/// The drawing, with its style inside where it stands alone.
pub(crate) fn drawing(plane: &ImpulsePlane, alone: bool) -> String {
    if !plane.can_be_drawn() {
        return String::new();
    }
    let (half, normal) = plane.extent();
    let scale = Scale { half, normal };
    let height = TOP + PLANE + 34.0 + LINE * plane.points.len() as f64 + 6.0;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig impulse\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"Impulse plane\">",
        px(WIDTH),
        px(height)
    );
    if alone {
        out += &format!(
            "<style>{FIGURE_CSS}</style><rect class=\"paper\" width=\"{}\" height=\"{}\"/>",
            px(WIDTH),
            px(height)
        );
    }
    out += &axes(&scale);
    out += &cone(plane, &scale);
    out += &deciding_lines(plane, &scale);
    out += &walk(plane, &scale);
    out += &legend(plane);
    out + "</svg>"
}

fn axes(scale: &Scale) -> String {
    let (x0, x1, base) = (scale.x(0.0), WIDTH - RIGHT, TOP + PLANE);
    let mut out = String::new();
    let t = ticks(-scale.half, scale.half, 5);
    for v in &t.at {
        let y = scale.y(*v);
        let class = if *v == 0.0 { "zero" } else { "grid" };
        out += &format!(
            "<line class=\"{class}\" x1=\"{}\" x2=\"{}\" y1=\"{2}\" y2=\"{2}\"/>",
            px(x0),
            px(x1),
            px(y)
        );
        out += &text("tick", x0 - 6.0, y + 3.8, "end", &fixed(*v, t.decimals));
    }
    let n = ticks(0.0, scale.normal, 5);
    for v in &n.at {
        let x = scale.x(*v);
        out += &format!(
            "<line class=\"axis\" x1=\"{0}\" x2=\"{0}\" y1=\"{1}\" y2=\"{2}\"/>",
            px(x),
            px(base),
            px(base + 4.0)
        );
        out += &text("tick", x, base + 16.0, "middle", &fixed(*v, n.decimals));
    }
    out += &format!("<path class=\"axis\" d=\"M{0} {1}V{2}H{3}\"/>", px(x0), px(TOP), px(base), px(x1));
    out += &text("name", x0, 15.0, "start", "tangential impulse p\u{209c} [N s]");
    out + &text("name", x1, base + 29.0, "end", "normal impulse p\u{2099} [N s]")
}

fn text(class: &str, x: f64, y: f64, anchor: &str, text: &str) -> String {
    format!(
        "<text class=\"{class}\" x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\">{}</text>",
        px(x),
        px(y),
        lowered(&escape(text))
    )
}

/// Lowered letters as small `tspan`s: few fonts have the characters.
fn lowered(text: &str) -> String {
    let small =
        |c: &str| format!("<tspan dy=\"3\" font-size=\"78%\">{c}</tspan><tspan dy=\"-3\">\u{200b}</tspan>");
    text.replace('\u{209c}', &small("t")).replace('\u{2099}', &small("n"))
}

fn cone(plane: &ImpulsePlane, scale: &Scale) -> String {
    let mu = plane.friction;
    // Where the cone leaves the shown plane.
    let reach = if mu * scale.normal > scale.half { scale.half / mu } else { scale.normal };
    let (x, y) = (scale.x(reach), mu * reach);
    let (o, corner) = (scale.x(0.0), scale.x(scale.normal));
    let area = format!(
        "<path class=\"cone\" d=\"M{0} {1}L{2} {3}H{4}V{5}H{2}Z\"/>",
        px(o),
        px(scale.y(0.0)),
        px(x),
        px(scale.y(y)),
        px(corner),
        px(scale.y(-y))
    );
    let edge = format!(
        "<path class=\"cone-edge\" d=\"M{0} {1}L{2} {3}M{0} {1}L{2} {4}\"/>",
        px(o),
        px(scale.y(0.0)),
        px(x),
        px(scale.y(y)),
        px(scale.y(-y))
    );
    let (tx, ty) = (scale.x(0.46 * reach), 0.46 * y);
    area + &edge + &text("small", tx - 4.0, scale.y(-ty) + 19.0, "end", "cone p\u{209c} = ±μ p\u{2099}")
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
    (far(&last) > 1e-6).then_some([first, last])
}

fn deciding_lines(plane: &ImpulsePlane, scale: &Scale) -> String {
    let sticking = (plane.line_of_sticking(), "sticking", "sticking u\u{209c} = 0");
    let compression = (plane.line_of_compression(), "compression", "max. compression u\u{2099} = 0");
    let mut out = String::new();
    for (line, class, label) in [sticking, compression] {
        let Some([p, q]) = line.and_then(|line| ends(line, scale)) else {
            if line.is_some() && class == "sticking" {
                let outside = "sticking u\u{209c} = 0: outside";
                out += &text("sticking", LEFT + 8.0, TOP + 12.0, "start", outside);
            }
            continue;
        };
        out += &format!(
            "<line class=\"{class}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>",
            px(scale.x(p.0)),
            px(scale.y(p.1)),
            px(scale.x(q.0)),
            px(scale.y(q.1))
        );
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
        out += &text(class, x + dx, scale.y(at.1) + if upper { 11.0 } else { -6.0 }, anchor, label);
    }
    out
}

fn walk(plane: &ImpulsePlane, scale: &Scale) -> String {
    let mut out = String::new();
    let (mut x, mut y) = (scale.x(0.0), scale.y(0.0));
    let mut dots = format!("<circle class=\"dot\" cx=\"{}\" cy=\"{}\" r=\"3\"/>", px(x), px(y));
    for (i, p) in plane.points.iter().enumerate() {
        let (u, v) = (scale.x(p.normal), scale.y(p.tangential));
        let class = if p.phase == Phase::Compression { "walk" } else { "walk restitution" };
        out += &format!(
            "<line class=\"{class}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>",
            px(x),
            px(y),
            px(u),
            px(v)
        );
        dots += &format!("<circle class=\"dot\" cx=\"{}\" cy=\"{}\" r=\"3.4\"/>", px(u), px(v));
        dots += &text(
            "walk",
            u + 6.0,
            v + if p.tangential < 0.0 { 15.0 } else { -7.0 },
            "start",
            &(i + 1).to_string(),
        );
        (x, y) = (u, v);
    }
    out + &dots
}

fn legend(plane: &ImpulsePlane) -> String {
    let mut y = TOP + PLANE + 34.0 + 12.0;
    let mut out = String::new();
    for (i, p) in plane.points.iter().enumerate() {
        out += &text("walk", LEFT - 14.0, y, "end", &(i + 1).to_string());
        out += &text("small", LEFT - 6.0, y, "start", &p.label);
        y += LINE;
    }
    out
}
