//! Faces of solid parts: how a part rests on each, and starts that are mixed by it.

use carom_num::elementary::atan2;
use carom_scene::{Drawn, SolidFaceReport, SolidThrows, SpaceScene, Thrown};
use carom_study::poses::Plan;
use std::f64::consts::PI;

/// Some operations on numbers of about 1.
const ROUNDING: f64 = 1e-13;

/// A scene with this part, which starts as `start` says.
fn scene(part: &str, start: &str) -> SpaceScene {
    let text = format!(
        "part = {{ {part} }}\ncontact = {{ friction = 0.4 }}\nstart = {{ to_edge = 0.1{start} }}\n[[plate]]\nslope = \"15 deg\"\n"
    );
    SpaceScene::parse("some.toml", &text).unwrap_or_else(|problems| panic!("{problems}"))
}

const BOX: &str = "box = [0.04, 0.01, 0.02], mass = 0.06";

/// A rectangle of a × b seen from over its middle at the height h, as a share of all directions: `atan(a b / (4 h √(h² + (a² + b²)/4)))/π`.
fn seen(a: f64, b: f64, h: f64) -> f64 {
    atan2(a * b, 4.0 * h * (h * h + 0.25 * (a * a + b * b)).sqrt()) / PI
}

fn sum(faces: &[SolidFaceReport]) -> f64 {
    faces.iter().map(|face| face.quasi_static_share).sum()
}

#[test]
fn a_box_rests_by_the_solid_angles_of_its_faces() {
    let faces = SolidFaceReport::of(&scene(BOX, ""));
    let [low, end, front] = [seen(0.04, 0.02, 0.005), seen(0.01, 0.02, 0.02), seen(0.04, 0.01, 0.01)];
    for (face, share) in faces.iter().zip([low, end, low, end, front, front]) {
        assert!((face.quasi_static_share - share).abs() < ROUNDING, "{face:?}: {share}");
        assert!(face.stable && (face.solid_angle_share - share).abs() < ROUNDING, "{face:?}");
    }
    assert!((sum(&faces) - 1.0).abs() < ROUNDING, "{faces:?}");
    // The lower face, 5 mm below the mass centre, tips over a long side, 10 mm away, onto the front or the back.
    assert!((faces[0].tips_after_rad - atan2(2.0, 1.0)).abs() < ROUNDING, "{:?}", faces[0]);
    assert!([4, 5].contains(&faces[0].tips_onto) && [0, 2].contains(&faces[1].tips_onto), "{faces:?}");
}

#[test]
fn a_part_starts_on_its_faces_as_it_rests_on_them() {
    let resting = scene(BOX, ", face = \"resting\"");
    assert_eq!(resting.feeder().start.face, 0, "of equally probable faces the first");
    let varied = resting.varied().unwrap();
    assert_eq!((varied.dimensions(), varied.paths()), (1, vec!["start.face".to_owned()]));
    let faces = SolidFaceReport::of(&resting);
    assert_eq!(resting.start_faces().len(), 6);
    for (face, share) in resting.start_faces() {
        assert!((share - faces[face].quasi_static_share).abs() < ROUNDING, "{face}: {share}");
    }
    assert_eq!(varied.feeder(&[0.8]).unwrap().start.face, 4, "two large faces and two ends: 0.738 of all");
}

#[test]
fn faces_on_which_a_part_does_not_stay_are_no_start() {
    // A prism of height 1 whose upper end is 2 to the right of the lower one: it leans over.
    let corners = "shape = \"solid\", vertices = [[0,0,0],[1,0,0],[0,1,0],[1,1,0],[2,0,1],[3,0,1],[2,1,1],[3,1,1]], mass = 1";
    let leaning = scene(corners, ", face = \"resting\"");
    let faces = SolidFaceReport::of(&leaning);
    let ends: Vec<&SolidFaceReport> = faces.iter().filter(|face| face.normal[2].abs() > 0.999).collect();
    assert_eq!(ends.len(), 2);
    for end in ends {
        assert!(!end.stable && end.quasi_static_share == 0.0 && end.tips_after_rad == 0.0, "{end:?}");
        assert!((end.margin_m + 0.5).abs() < ROUNDING && end.solid_angle_share > 0.0, "{end:?}");
        let next = &faces[end.tips_onto];
        let both = next.solid_angle_share + end.solid_angle_share;
        assert!((next.quasi_static_share - both).abs() < ROUNDING, "{end:?}, {next:?}");
        assert!(leaning.start_faces().iter().all(|(face, _)| *face != end.face), "{end:?}");
    }
    assert!((sum(&faces) - 1.0).abs() < ROUNDING, "{faces:?}");
}

#[test]
fn numbers_of_vertices_change_nothing() {
    let points = ["[0,0,0]", "[0.05,0,0]", "[0,0.03,0]", "[0.01,0.01,0.02]", "[0.04,0.02,0.01]"];
    let of = |order: [usize; 5]| {
        let all = order.map(|k| points[k]).join(",");
        SolidFaceReport::of(&scene(&format!("shape = \"solid\", vertices = [{all}], mass = 0.1"), ""))
    };
    let (one, other) = (of([0, 1, 2, 3, 4]), of([3, 1, 4, 0, 2]));
    assert_eq!(one.len(), other.len());
    for face in &one {
        let apart =
            |of: &&SolidFaceReport| (0..3).map(|k| (of.normal[k] - face.normal[k]).abs()).sum::<f64>();
        let same = other.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap();
        assert!(apart(&same) < 1e-9, "{face:?}");
        assert!((same.quasi_static_share - face.quasi_static_share).abs() < ROUNDING, "{face:?}, {same:?}");
        assert!(same.stable == face.stable, "{face:?}, {same:?}");
    }
}

#[test]
fn a_rounded_part_tips_over_its_balls() {
    // Balls of 2 mm: what is plane of the lower face is 36 × 16 mm, and the middles of the balls are 3 mm below the mass centre.
    let lower = &SolidFaceReport::of(&scene(&format!("{BOX}, corner_radius = 0.002"), ""))[0];
    assert!(
        (lower.centre_height_m - 0.005).abs() < ROUNDING && (lower.margin_m - 0.008).abs() < ROUNDING,
        "{lower:?}"
    );
    assert!((lower.tips_after_rad - atan2(8.0, 3.0)).abs() < ROUNDING, "{lower:?}");
    assert!((lower.quasi_static_share - seen(0.036, 0.016, 0.003)).abs() < ROUNDING, "{lower:?}");
}

#[test]
fn the_bolt_of_the_examples_lies_on_its_head_and_shank() {
    let bolt = SpaceScene::parse(
        "../../examples/solid_bolt.toml",
        &std::fs::read_to_string("../../examples/solid_bolt.toml").unwrap(),
    )
    .unwrap();
    let faces = SolidFaceReport::of(&bolt);
    assert!((sum(&faces) - 1.0).abs() < ROUNDING, "{faces:?}");
    // Two ends, and six ways to lie on two sides of the head and the end of the shank: these are alike.
    let stable: Vec<f64> =
        faces.iter().filter(|face| face.stable).map(|face| face.quasi_static_share).collect();
    assert_eq!(stable.len(), 8, "{stable:?}");
    let alike = stable.iter().filter(|share| (**share - stable[1]).abs() < 1e-6).count();
    assert_eq!(alike, 6, "the file's numbers have some seven digits: {stable:?}");
}

#[test]
fn throws_of_a_solid_end_on_its_faces() {
    let cube = scene("box = [0.02, 0.02, 0.02], mass = 0.06", "");
    let throws = SolidThrows::new(&cube, 0, ["5 ± 1 mm", "0.1 m/s", "0 rad/s"]).unwrap();
    let plan = Plan { dimensions: SolidThrows::DIMENSIONS, throws: 8, seed: 3 };
    let found = throws.throws(&plan, || ()).unwrap();
    assert_eq!((found.throws, found.ends.len(), found.resting.count), (128, 6, 128));
    for end in &found.ends {
        let Some([low, high]) = end.of_resting.map(|of| [of.low, of.high]) else { panic!("{end:?}") };
        assert!(low < 1.0 / 6.0 && 1.0 / 6.0 < high, "a cube lies on each of its faces alike: {end:?}");
    }
    let state = throws.resting_on(2).unwrap();
    assert!(
        (state.attitude.apply(carom_num::Vec3::Y) + carom_num::Vec3::Z).norm() < ROUNDING,
        "its upper face is down"
    );
    assert_eq!(throws.resting_on(6), None);
    let wrong = SolidThrows::new(&cube, 0, ["5", "0.1 m/s", "-1 rad/s"]).unwrap_err();
    assert_eq!(wrong.iter().map(|(place, _)| *place).collect::<Vec<_>>(), [0, 2], "{wrong:?}");
}
