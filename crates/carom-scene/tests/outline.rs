//! Parts drawn in files of their own: what a user reads, and the bodies that come of them.

use carom_feeder::PartKind;
use carom_num::Vec2;
use carom_scene::{ProblemKind, Problems, Scene};
use std::f64::consts::PI;
use std::path::Path;

/// A scene in the folder of the drawings, with these lines under `shape = "outline"`.
fn parse(part: &str) -> Result<Scene, Problems> {
    let rest = "[contact]\nfriction = 0.2\n\n[start]\nto_edge = \"60 mm\"\n\n[[plate]]\nslope = \"20 deg\"\n";
    let text = format!("[part]\nshape = \"outline\"\n{part}mass = \"0.1 kg\"\n\n{rest}");
    Scene::parse("tests/outlines/scene.toml", &text)
}

fn scene(part: &str) -> Scene {
    parse(part).unwrap_or_else(|problems| panic!("{problems}"))
}

fn problems(part: &str) -> Problems {
    parse(part).expect_err("this scene has problems")
}

macro_rules! says {
    ($($name:ident: $problems:expr;)*) => { $(
        #[test]
        fn $name() {
            insta::assert_snapshot!($problems.to_string());
        }
    )* };
}

says! {
    open_ends: problems("file = \"open.dxf\"\n");
    loops_that_cross_or_repeat: problems("file = \"crossing.dxf\"\n");
    separate_outlines: problems("file = \"apart.svg\"\n");
    entities_that_are_not_read: problems("file = \"unread.dxf\"\n");
    elements_that_are_not_read: problems("file = \"unread.svg\"\n");
    a_file_that_breaks_off: problems("file = \"broken.dxf\"\nunit = \"mm\"\n");
    no_file: problems("");
    a_file_that_is_not_there: problems("file = \"nowhere.dxf\"\n");
    a_file_of_another_kind: problems("file = \"bracket.step\"\n");
    no_unit: problems("file = \"unitless.dxf\"\n");
    two_units: problems("file = \"open.dxf\"\nunit = \"in\"\n");
    no_such_layer: problems("file = \"obround.dxf\"\nlayer = \"contour\"\n");
    layer_of_an_svg: problems("file = \"plate.svg\"\nlayer = \"outline\"\n");
    bad_keys: problems("file = \"plate.svg\"\nunit = \"furlong\"\nscale = 0\nchord = \"3 kg\"\ncorner_radius = \"1 mm\"\n");
    chord_too_large: problems("file = \"plate.svg\"\nchord = \"10 mm\"\n");
    notes_of_an_obround: scene("file = \"obround.dxf\"\nlayer = \"outline\"\n").notes().join("\n");
    notes_of_a_plate: scene("file = \"plate.svg\"\nchord = \"0.1 mm\"\n").notes().join("\n");
    notes_of_a_disc: scene("file = \"unitless.dxf\"\nunit = \"mm\"\n").notes().join("\n");
}

/// The last digits of some hundred operations, each rounded.
fn close(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{what}: {found} is not {expected}");
}

#[test]
fn the_bracket_weighs_what_it_is() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/bracket.toml");
    let scene = Scene::read(&path).unwrap_or_else(|problems| panic!("{problems}"));
    let part = &scene.feeder().part;
    // Two legs of 40 by 8 and 8 by 22, a fillet of 4, a hole of 5 [mm²]; 7.8 g/cm³, 20 mm deep.
    let area = 40.0 * 8.0 + 8.0 * 22.0 + (16.0 - 4.0 * PI) - 6.25 * PI;
    close(part.body.mass, 7800.0 * 0.02 * area * 1e-6, "mass");
    assert_eq!(part.kind, PartKind::Polygon);
    // It has the legs' outer corners, and a fillet between them; face 0 is the long leg's lower side.
    let shape = &part.body.shape;
    assert_eq!(shape.vertices().len(), 6, "five corners and a fillet");
    let hollow: Vec<usize> = (0..6).filter(|v| shape.is_hollow(*v)).collect();
    assert_eq!(hollow, [3]);
    close(shape.radius_of(3), -0.004, "radius of the fillet");
    let rests = shape.rests();
    let expected = [(40.0, 0.0), (0.0, 8.0), (-32.0, 22.0), (-8.0, 0.0), (0.0, -30.0)];
    assert_eq!(rests.iter().map(|rest| rest.is_face()).collect::<Vec<_>>(), [true, true, false, true, true]);
    for (rest, (x, y)) in rests.iter().zip(expected) {
        let run = (rest.to - rest.from) * 1e3;
        assert!((run - Vec2::new(x, y)).norm() < 1e-12, "{run:?} is not ({x}, {y})");
    }
    assert!(scene.approximations().is_empty());
}

#[test]
fn an_obround_with_a_hole_keeps_its_ends_and_moves_its_mass_centre() {
    let scene = scene("file = \"obround.dxf\"\nlayer = \"outline\"\n");
    let body = &scene.feeder().part.body;
    assert_eq!((body.shape.faces(), body.shape.radius()), (2, 0.005));
    // The plate's centre is at 15 mm, the hole's at 0.
    let (plate, hole) = (300.0 + 25.0 * PI, 4.0 * PI);
    let centre = 15.0 * plate / (plate - hole);
    close(body.shape.vertices()[1].x, (30.0 - centre) * 1e-3, "the front end from the mass centre");
    // Rectangle and two half discs (r = 5, centroid 20/3π from the diameter), less the hole.
    let c = 20.0 / (3.0 * PI);
    let ends = 25.0 * PI * (12.5 - c * c + (15.0 + c) * (15.0 + c));
    let polar = 300.0 * (900.0 + 100.0) / 12.0 + ends - hole * (2.0 + 225.0);
    let shift = centre - 15.0;
    let gyration = polar / (plate - hole) - shift * shift;
    close(body.inertia, 0.1 * gyration * 1e-6, "inertia");
}

#[test]
fn scale_is_a_quantity_of_the_scene() {
    let plain = scene("file = \"obround.dxf\"\nlayer = \"outline\"\n");
    let inches = plain.with("part.scale", 25.4).unwrap();
    let (small, large) = (&plain.feeder().part.body, &inches.feeder().part.body);
    close(large.inertia, small.inertia * 25.4 * 25.4, "inertia of the same mass");
    close(large.shape.radius(), 0.127, "radius");
    assert_eq!(
        scene("file = \"obround.dxf\"\nlayer = \"outline\"\nscale = 25.4\n").feeder(),
        inches.feeder()
    );
}

#[test]
fn a_problem_of_a_drawing_is_about_its_file() {
    let found = problems("file = \"open.dxf\"\n");
    assert!(found.list.iter().all(|problem| problem.path == "part.file"), "{found}");
    assert!(found.list.iter().all(|problem| problem.kind == ProblemKind::Geometry), "{found}");
    assert_eq!(found.value(&found.list[0]), Some("\"open.dxf\""));
    let missing = problems("file = \"nowhere.dxf\"\n");
    assert_eq!(missing.list[0].kind, ProblemKind::File);
}
