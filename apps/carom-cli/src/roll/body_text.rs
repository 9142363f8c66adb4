//! A polyhedron that is thrown, for a person: what it is, its faces, and on which it rests.

use crate::side_by_side::aligned;
use crate::table::{fixed, signed};
use carom_scene::{RestingReport, ThrownBodyReport, ThrownFaceReport};
use std::fmt::Write as _;

/// Faces in the table.
const MOST_FACES: usize = 24;
/// Corners of a face that are named.
const MOST_CORNERS: usize = 12;

/// What it is, its faces, and what became of its energy.
pub(super) fn text(law: &str, body: &ThrownBodyReport, resting: Option<&RestingReport>) -> String {
    let mut text = String::new();
    if let Some(resting) = resting {
        let _ = writeln!(text, "{}", energy(resting));
    }
    let _ = writeln!(text, "{law}\n");
    for line in about(body) {
        let _ = writeln!(text, "{line}");
    }
    let _ = write!(text, "\n{}", faces(body, resting.and_then(|r| r.face)));
    text
}

/// Shape, mass and moments, in sentences.
pub(super) fn about(body: &ThrownBodyReport) -> Vec<String> {
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
    let [x, y, z] = body.centre_m.map(|x| fixed(1e3 * x, 4));
    lines.push(format!(
        "volume {:.6e} m³, mass {:.6} kg, mass centre ({x}, {y}, {z}) mm, principal moments {a:.6e}, {b:.6e}, {c:.6e} kg m²",
        body.volume_m3,
        body.density_kg_m3 * body.volume_m3
    ));
    lines
}

/// "face 2 (vertices 0, 1, 5, 4), normal (0, 0, −1)"; what is said of a body that rests on none is `None`.
pub(super) fn on_face(resting: &RestingReport) -> Option<String> {
    let (face, normal) = (resting.face?, resting.normal?);
    Some(format!("face {face} (vertices {}), normal {}", named(&resting.vertices), direction(normal)))
}

fn energy(resting: &RestingReport) -> String {
    let [start, end] = [resting.energy_start, resting.energy_end].map(|e| fixed(e, 6));
    let change = 100.0 * (resting.energy_end - resting.energy_start) / resting.energy_start;
    let change = if change.is_finite() { format!(" ({} %)", signed(change, 1)) } else { String::new() };
    format!("energy above the plane {start} → {end} J{change}")
}

pub(super) fn named(vertices: &[String]) -> String {
    let more = if vertices.len() > MOST_CORNERS { ", …" } else { "" };
    format!("{}{more}", vertices.iter().take(MOST_CORNERS).cloned().collect::<Vec<_>>().join(", "))
}

pub(super) fn direction(normal: [f64; 3]) -> String {
    // Adding zero leaves no −0.
    let [x, y, z] = normal.map(|x| fixed((x * 1e6).round() / 1e6 + 0.0, 4));
    format!("({x}, {y}, {z})")
}

fn faces(body: &ThrownBodyReport, resting: Option<usize>) -> String {
    let head = ["face", "vertices", "normal", "centre over it mm", "inside by mm", ""];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(body.faces.iter().take(MOST_FACES).map(|face| row(face, resting == Some(face.face))));
    let mut text = aligned(&rows);
    if let Some(more) = body.faces.len().checked_sub(MOST_FACES).filter(|more| *more > 0) {
        let _ = writeln!(text, "… {more} more, all with --format json");
    }
    text
}

fn row(face: &ThrownFaceReport, rests: bool) -> Vec<String> {
    let word = match (rests, face.stable) {
        (true, _) => "RESTS",
        (false, true) => "stable",
        (false, false) => "rolls off",
    };
    vec![
        face.face.to_string(),
        named(&face.vertices),
        direction(face.normal),
        fixed(1e3 * face.centre_height_m, 3),
        fixed(1e3 * face.margin_m, 3),
        word.to_owned(),
    ]
}
