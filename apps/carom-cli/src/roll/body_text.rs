//! A polyhedron that is thrown, for a person: what it is, its faces, and on which it rests.

use crate::table::{fixed, signed};
use carom::tasks::solid::words::{about, direction, named};
use carom_scene::{RestingReport, ThrownBodyReport, ThrownFaceReport};
use carom_words::aligned;
use std::fmt::Write as _;

/// Faces in the table.
const MOST_FACES: usize = 24;

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

fn energy(resting: &RestingReport) -> String {
    let [start, end] = [resting.energy_start, resting.energy_end].map(|e| fixed(e, 6));
    let change = 100.0 * (resting.energy_end - resting.energy_start) / resting.energy_start;
    let change = if change.is_finite() { format!(" ({} %)", signed(change, 1)) } else { String::new() };
    format!("energy above the plane {start} → {end} J{change}")
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
