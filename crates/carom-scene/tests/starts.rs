//! Faces on which parts start: one, several, or those on which they can rest.

use carom_num::elementary::atan2;
use carom_scene::Scene;
use std::f64::consts::PI;

/// Rounding of shares.
const ROUNDING: f64 = 1e-14;

/// A box of 30 by 12 mm that starts as `face` says.
fn text(face: &str, speed: &str) -> String {
    format!(
        "[part]\nshape = \"box\"\nlength = \"30 mm\"\nheight = \"12 mm\"\nmass = \"0.02 kg\"\n[contact]\nfriction = 0.2\nrestitution = 0.1\n[start]\nto_edge = \"60 mm\"\n{face}\n{speed}\n[[plate]]\nslope = \"25 deg\"\n[[plate]]\nslope = \"20 deg\"\nbelow = {{ x = \"20 mm\", y = \"-120 mm\" }}\n"
    )
}

fn scene(face: &str) -> Scene {
    Scene::parse("starts.toml", &text(face, "")).unwrap_or_else(|problems| panic!("{problems}"))
}

#[test]
fn a_part_rests_on_its_faces_by_the_angles_that_lead_to_them() {
    let scene = scene("face = \"resting\"");
    assert_eq!(scene.feeder().start.face, 0, "a single drop starts on the most probable face");
    let varied = scene.varied().unwrap();
    assert_eq!((varied.dimensions(), varied.paths()), (1, vec!["start.face".to_owned()]));
    // A long side is seen from the centre under the angle 2 atan(30/12), each corner being the highest place in between.
    let long = 2.0 * atan2(30.0, 12.0) / (2.0 * PI);
    for ((face, share), expected) in varied.faces().iter().zip([long, 0.5 - long, long, 0.5 - long]) {
        assert!((share - expected).abs() < ROUNDING, "face {face}: {share}, {expected}");
    }
}

#[test]
fn a_list_of_faces_is_mixed_by_its_shares() {
    let scene = scene("face = [{ face = 2, share = 3 }, { face = 0, share = 1 }]");
    assert_eq!(scene.feeder().start.face, 2, "the more probable one");
    let varied = scene.varied().unwrap();
    assert_eq!(varied.faces(), [(2, 0.75), (0, 0.25)]);
    let faces: Vec<usize> = [0.0, 0.7499, 0.7501, 0.9999].iter().map(|u| varied.face(&[*u])).collect();
    assert_eq!(faces, [2, 2, 0, 0]);
    assert_eq!(varied.feeder(&[0.9]).unwrap().start.face, 0, "the feeder follows");
    let saved = Scene::parse("saved.toml", &varied.text(&[0.9]).unwrap()).unwrap();
    assert_eq!(saved.feeder(), &varied.feeder(&[0.9]).unwrap(), "and so does what is saved");
    assert!(saved.varied().is_err(), "in which nothing varies");
}

#[test]
fn speed_and_place_of_the_start_may_have_tolerances() {
    let text = text("face = \"resting\"", "speed = { low = \"0 m/s\", high = \"0.2 m/s\" }");
    let text = text.replace("\"60 mm\"", "\"60 ± 5 mm\"");
    let scene = Scene::parse("starts.toml", &text).unwrap();
    let varied = scene.varied().unwrap();
    assert_eq!(varied.paths(), ["start.to_edge", "start.speed", "start.face"]);
    let feeder = varied.feeder(&[0.5, 0.5, 0.0]).unwrap();
    assert!((feeder.start.speed - 0.1).abs() < ROUNDING && (feeder.start.to_edge - 0.06).abs() < ROUNDING);
}

#[test]
fn what_is_wrong_with_faces_is_said() {
    let refused = |face: &str| Scene::parse("starts.toml", &text(face, "")).unwrap_err().to_string();
    assert!(refused("face = 4").contains("start.face: 4 is no face of this part: its faces are 0 to 3"));
    let both = refused("face = [{ face = 7, share = 1 }, { face = 1, share = 1 }, { face = 1, share = 2 }]");
    assert!(both.contains("start.face.0.face: 7 is no face"), "{both}");
    assert!(both.contains("start.face.2.face: face 1 is named twice"), "{both}");
    let word = refused("face = \"restin\"");
    assert!(word.contains("did you mean \"resting\""), "{word}");
    let share = refused("face = [{ face = 1, share = -1 }]");
    assert!(share.contains("start.face.0.share"), "{share}");
    assert!(refused("face = []").contains("start.face"), "an empty list");
}

#[test]
fn of_a_part_whose_faces_go_by_number_a_side_is_not_wanted() {
    let of = |want: &str| {
        let part =
            "shape = \"bracket\"\nlegs = [\"30 mm\", \"20 mm\"]\nthickness = \"4 mm\"\nmass = \"30 g\"";
        let plates = format!("[[plate]]\nslope = \"20 deg\"\nwant = {want}\n");
        let rest = "[contact]\nfriction = 0.2\n[start]\nto_edge = \"60 mm\"\n";
        Scene::parse("starts.toml", &format!("[part]\n{part}\n{rest}{plates}"))
    };
    for side in ["\"same\"", "\"turned\""] {
        let said = of(side).unwrap_err().to_string();
        let expected = "only a rod or a box lands same or turned: of this part write a face, 0 to 4";
        assert!(said.contains(expected), "{side}: {said}");
    }
    assert!(of("4").is_ok() && of("\"any\"").is_ok(), "a number is one, and any is allowed");
    assert!(of("5").is_err(), "there is no sixth face");
}
