//! Parts with hollows touch with their convex hull: every answer says so, and no part starts on a line across a hollow.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use carom_scene::{Approximation, ApproximationKind, Problems, RunReport, Scene};

/// A part from a file of the folder of drawings, on two plates.
fn read(file: &str, face: &str) -> Result<Scene, Problems> {
    let text = format!(
        "[part]\nshape = \"outline\"\nfile = \"{file}\"\nmass = \"0.1 kg\"\n[contact]\nfriction = 0.2\n[start]\nto_edge = \"60 mm\"\n{face}\n[[plate]]\nslope = \"25 deg\"\n[[plate]]\nslope = \"20 deg\"\nbelow = {{ x = \"20 mm\", y = \"-120 mm\" }}\n"
    );
    Scene::parse("tests/outlines/scene.toml", &text)
}

fn scene(file: &str) -> Scene {
    read(file, "").unwrap_or_else(|problems| panic!("{problems}"))
}

fn hull_of(scene: &Scene) -> &Approximation {
    let hull = scene.approximations().iter().find(|found| found.kind == ApproximationKind::ConvexHull);
    hull.expect("the part has hollows")
}

/// A bar of 40 by 6 mm on a stem of 6 by 24: 384 mm². Its hull adds two triangles of 17 by 24: 408 mm².
#[test]
fn the_hull_of_a_tee_more_than_doubles_its_area() {
    let tee = scene("tee.svg");
    let hull = hull_of(&tee);
    assert!((hull.amount - 408.0 / 384.0).abs() < 1e-12, "added area {}", hull.amount);
    assert_eq!((hull.of, hull.unit), ("part", "1"), "a share of the part's area");
    // From the long side counter-clockwise: bar, its right end, a line to the stem, the stem's end, a line back, the left end.
    assert_eq!(hull.faces, [2, 4], "the lines across the hollows");
    assert!(hull.text.contains("faces 2, 4 are lines across hollows"), "{}", hull.text);
    let warning = tee.warning().expect("a verdict about a hull says so");
    assert!(warning.contains("CONVEX HULL") && warning.contains("+106 %"), "{warning}");
    let run = tee.feeder().run().unwrap();
    let json = serde_json::to_value(RunReport::new(&tee, &run, None)).unwrap();
    assert_eq!(json["approximations"][0]["kind"], "convex_hull", "a program reads it too");
}

/// The line across the hollow of an angle of 40 mm is 34·√2 + … mm long, the longest of all: face 0 is a leg all the same.
#[test]
fn no_line_across_a_hollow_is_the_face_to_start_on() {
    let ell = scene("ell.svg");
    let (a, b) = ell.feeder().part.body.shape.face(0);
    assert!(((b - a).norm() - 0.04).abs() < 1e-12, "face 0 is a leg: {}", (b - a).norm());
    let line = hull_of(&ell).faces.clone();
    assert_eq!(line, [2], "one line, from tip to tip");
    let problems = read("ell.svg", "face = 2").expect_err("the part cannot start on it");
    let text = problems.to_string();
    assert!(text.contains("start.face") && text.contains("its sides are faces 0, 1, 3, 4"), "{text}");
    for side in [0, 1, 3, 4] {
        assert!(read("ell.svg", &format!("face = {side}")).is_ok(), "face {side} is a side");
    }
}

#[test]
fn a_convex_part_is_no_approximation() {
    let disc = scene("unitless.dxf\"\nunit = \"mm");
    assert!(disc.approximations().is_empty() && disc.warning().is_none(), "{:?}", disc.approximations());
    let run = disc.feeder().run().unwrap();
    let json = serde_json::to_value(RunReport::new(&disc, &run, None)).unwrap();
    assert!(json.get("approximations").is_none(), "nothing is said where nothing is left out");
}

/// Chords are as near as the scene asks: data, and a note, but no warning.
#[test]
fn chords_are_told_with_their_distance() {
    let scene = scene("plate.svg\"\nchord = \"0.1 mm");
    let chords = scene.approximations().iter().find(|found| found.kind == ApproximationKind::Chords);
    let chords = chords.expect("the plate's curves are chords");
    assert!(chords.unit == "m" && chords.amount > 0.0 && chords.amount <= 1e-4, "{chords:?}");
    assert_eq!(chords.warning(), None, "as near as asked");
}
