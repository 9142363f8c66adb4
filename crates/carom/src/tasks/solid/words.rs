//! What is said of a body in space, in words that the text, the page and the studio share.

use carom_scene::{RestingReport, SpatialRollReport, SpatialStrikeReport, ThrownBodyReport};
use carom_words::number::{ascii, with_sign};
use carom_words::roll_space::EndName;

/// Corners of a face that are named.
const MOST_CORNERS: usize = 12;

/// How it ends; of a single strike that was asked for, what it does.
pub fn headline(report: &SpatialRollReport) -> String {
    match (&report.strikes[..], report.end.state.0) {
        ([only], EndName::StrikesReached) => only.state.clone(),
        _ => format!("{} at {:.6} s", report.end.state, report.end.t_s),
    }
}

/// How many strikes, what the first one is, and how much friction not to slide takes.
pub fn lead(report: &SpatialRollReport) -> Vec<String> {
    let face = report.resting.as_ref().and_then(on_face);
    let mut parts: Vec<String> = face.map(|face| format!("on {face}")).into_iter().collect();
    parts.push(match report.strikes.len() {
        0 => "no strike".to_owned(),
        1 => "one strike".to_owned(),
        n => format!("{n} strikes"),
    });
    if let Some(first) = report.strikes.first() {
        if headline(report) != first.state {
            let which = if report.strikes.len() > 1 { "first: " } else { "" };
            parts.push(format!("{which}{}", first.state));
        }
        // What the first of several takes is not what the whole way does.
        let of = if report.strikes.len() > 1 { " in the first strike" } else { "" };
        parts.extend(change(first).map(|change| format!("{change} energy{of}")));
    }
    parts.extend(report.friction_demand.map(|mu| takes(mu, report.friction_is_bound, 4)));
    parts
}

/// How much friction not to slide takes.
pub fn takes(friction: f64, is_bound: bool, digits: usize) -> String {
    let less = if is_bound { " or less" } else { "" };
    format!("not to slide takes friction {}{less}", ascii(friction, digits))
}

/// How much of its energy a strike takes.
pub fn change(strike: &SpatialStrikeReport) -> Option<String> {
    let left = strike.energy_after? / strike.energy_before;
    let shown = match 100.0 * (left - 1.0) {
        change if !change.is_finite() => return None,
        // A little is left, which is not none.
        change if left > 0.0 && change < -99.95 => format!("×{left:.1e}"),
        change => format!("{} %", with_sign(change, 1)),
    };
    Some(shown)
}
/// Shape, mass and moments, in sentences.
pub fn about(body: &ThrownBodyReport) -> Vec<String> {
    let stable = body.faces.iter().filter(|face| face.stable).count();
    let from = match &body.file {
        Some(file) => format!("{file}: {} points", body.points),
        None => format!("{}: {} points", body.shape, body.points),
    };
    let mut lines = vec![format!(
        "{from}, a hull of {} vertices and {} faces, stable on {stable} of them",
        body.vertices.len(),
        body.faces.len()
    )];
    if !body.convex {
        lines.push("the surface is not convex: the plane is touched by its hull, mass centre and inertia are those of the surface".to_owned());
    } else if body.points > body.vertices.len() {
        let inside = body.points - body.vertices.len();
        lines.push(format!(
            "{inside} of the points are no vertices of the hull: they lie within it, or on a face or side"
        ));
    }
    if body.moved_m > 0.0 {
        lines.push(format!("vertices were moved by {:.1e} m at most, onto their faces", body.moved_m));
    }
    let [a, b, c] = body.principal_moments_kg_m2;
    let [x, y, z] = body.centre_m.map(|x| ascii(1e3 * x, 4));
    lines.push(format!(
        "volume {:.6e} m³, mass {:.6} kg, mass centre ({x}, {y}, {z}) mm, principal moments {a:.6e}, {b:.6e}, {c:.6e} kg m²",
        body.volume_m3,
        body.density_kg_m3 * body.volume_m3
    ));
    lines
}

/// "face 2 (vertices 0, 1, 5, 4), normal (0, 0, −1)"; what is said of a body that rests on none is `None`.
pub fn on_face(resting: &RestingReport) -> Option<String> {
    let (face, normal) = (resting.face?, resting.normal?);
    Some(format!("face {face} (vertices {}), normal {}", named(&resting.vertices), direction(normal)))
}

/// The first of many corners.
pub fn named(vertices: &[String]) -> String {
    let more = if vertices.len() > MOST_CORNERS { ", …" } else { "" };
    format!("{}{more}", vertices.iter().take(MOST_CORNERS).cloned().collect::<Vec<_>>().join(", "))
}

/// A direction, with four digits.
pub fn direction(normal: [f64; 3]) -> String {
    // Adding zero leaves no −0.
    let [x, y, z] = normal.map(|x| ascii((x * 1e6).round() / 1e6 + 0.0, 4));
    format!("({x}, {y}, {z})")
}
