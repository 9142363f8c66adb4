//! Parts with hollows are computed as they are drawn, and lie on their sides and across their hollows.

use carom_scene::{ApproximationKind, Problems, RunReport, Scene};

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

/// A bar of 40 by 6 mm on a stem of 6 by 24: six lines that it can lie on, two of them from the bar's tips to the stem's.
#[test]
fn a_tee_lies_on_its_sides_and_across_its_hollows() {
    let tee = scene("tee.svg");
    assert!(tee.approximations().is_empty(), "{:?}", tee.approximations());
    // From the long side counter-clockwise: bar, its right end, a line to the stem, the stem's end, a line back, the left end.
    let rests = tee.feeder().part.body.shape.rests();
    assert_eq!(
        rests.iter().map(|rest| rest.is_face()).collect::<Vec<_>>(),
        [true, true, false, true, false, true]
    );
    let across = (rests[2].to - rests[2].from).norm();
    assert!((across - 0.001 * (17.0f64 * 17.0 + 24.0 * 24.0).sqrt()).abs() < 1e-12, "{across}");
    assert!(tee.notes().iter().any(|note| note.contains("across hollows on 2, 4")), "{:?}", tee.notes());
    let run = tee.feeder().run().unwrap();
    let json = serde_json::to_value(RunReport::new(&tee, &run, None)).unwrap();
    assert!(json.get("approximations").is_none(), "nothing is left out");
}

/// The line across the hollow of an angle of 40 mm is 34·√2 + … mm long, the longest of all: face 0 is a leg all the same. The angle may start on
/// any of its faces.
#[test]
fn an_angle_starts_on_its_leg_or_across_its_hollow() {
    let ell = scene("ell.svg");
    let rests = ell.feeder().part.body.shape.rests();
    let long = (rests[0].to - rests[0].from).norm();
    assert!((long - 0.04).abs() < 1e-12, "face 0 is a leg: {long}");
    assert!(!rests[2].is_face(), "from tip to tip");
    for face in 0..rests.len() {
        let scene = read("ell.svg", &format!("face = {face}")).unwrap();
        let start = scene.feeder().start_state();
        let world = scene.feeder().prepare(Default::default()).unwrap();
        assert!(world.world().clearance(0, &start, 0).abs() < 1e-12, "face {face} lies on the plate");
    }
    assert!(read("ell.svg", "face = 5").is_err(), "it has five");
}

#[test]
fn a_part_of_lines_and_arcs_is_no_approximation() {
    let disc = scene("unitless.dxf\"\nunit = \"mm");
    assert!(disc.approximations().is_empty(), "{:?}", disc.approximations());
    let run = disc.feeder().run().unwrap();
    let json = serde_json::to_value(RunReport::new(&disc, &run, None)).unwrap();
    assert!(json.get("approximations").is_none(), "nothing is said where nothing is left out");
}

/// Chords are as near as the scene asks.
#[test]
fn chords_are_told_with_their_distance() {
    let scene = scene("oval.svg\"\nchord = \"0.1 mm");
    let chords = scene.approximations().iter().find(|found| found.kind == ApproximationKind::Chords);
    let chords = chords.expect("its curve is chords");
    assert!(chords.unit == "m" && chords.amount > 0.0 && chords.amount <= 1e-4, "{chords:?}");
}
