//! Scenes that are right, and the feeders they stand for.

use carom_feeder::{Feeder, PartKind, Stop};
use carom_num::{
    Vec2,
    elementary::{atan2, cos, tan},
};
use carom_scene::{
    AnyImpact, AnyScene, RollKind, RollProblem, Scene, SpatialRollKind, SpatialRollProblem, Want,
    quantity::Tolerance,
};
use carom_words::Words;
use std::f64::consts::PI;
use std::path::Path;

fn example(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    Scene::read(&path).unwrap_or_else(|problems| panic!("{problems}"))
}

fn scene(text: &str) -> Scene {
    Scene::parse("scene.toml", text).unwrap_or_else(|problems| panic!("{problems}"))
}

const ROD: &str = "[part]\nshape = \"rod\"\nlength = \"100 mm\"\nmass = \"0.3 kg\"\n[contact]\nfriction = 0.15\n[start]\nto_edge = \"100 mm\"\n";

fn rod(rest: &str) -> Scene {
    scene(&format!("{ROD}{rest}"))
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-14 * (1.0 + b.abs()), "{a} is not {b}");
}

fn at(point: Vec2, x: f64, y: f64) {
    assert!((point - Vec2::new(x, y)).norm() < 1e-14, "{point:?} is not ({x}, {y})");
}

/// Slope of a plate below the horizontal [deg].
fn slope(feeder: &Feeder, plate: usize) -> f64 {
    let run = feeder.plates[plate].edge - feeder.plates[plate].uphill;
    atan2(-run.y, run.x.abs()) * 180.0 / PI
}

/// Distance of a plate's line from a point.
fn miss(feeder: &Feeder, plate: usize, point: Vec2) -> f64 {
    let plate = &feeder.plates[plate];
    (plate.edge - plate.uphill).unit().unwrap().cross(point - plate.uphill).abs()
}

#[test]
fn every_example_can_be_read() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut names: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    names.sort();
    assert!(names.len() >= 9, "found {names:?}");
    for path in names {
        let text = std::fs::read_to_string(&path).unwrap();
        let name = path.file_stem().unwrap().to_str().unwrap();
        if let Some(kind) =
            RollKind::ALL.iter().copied().find(|kind| name.starts_with(&format!("roll_{}", kind.word())))
        {
            RollProblem::parse(kind, name, &text, &[]).unwrap_or_else(|problems| panic!("{problems}"));
            continue;
        }
        if let Some(kind) = SpatialRollKind::ALL
            .iter()
            .copied()
            .find(|kind| name.starts_with(&format!("roll_{}", kind.word())))
        {
            SpatialRollProblem::parse(kind, path.to_str().unwrap(), &text, &[])
                .unwrap_or_else(|problems| panic!("{problems}"));
            continue;
        }
        if name.starts_with("impact_") || name.starts_with("contact_") {
            AnyImpact::parse("impact", &text).unwrap_or_else(|problems| panic!("{problems}"));
            continue;
        }
        match AnyScene::read(&path).unwrap_or_else(|problems| panic!("{problems}")) {
            AnyScene::Plane(scene) => assert!(scene.feeder().start_state().is_finite(), "{}", scene.name()),
            AnyScene::Space(scene) => assert!(scene.feeder().start_state().is_finite(), "{}", scene.name()),
        }
    }
}

#[test]
fn the_papers_lines_have_the_papers_slopes() {
    for (name, upper, lower, along, normal) in
        [("case_1.toml", 15.0, 15.0, 0.347, 0.2), ("case_2.toml", 10.0, 25.0, 0.428, 0.3)]
    {
        let feeder = example(name).to_feeder();
        close(slope(&feeder, 0), upper);
        // The printed intercepts have three digits: the slopes follow to a twentieth of a degree.
        assert!((slope(&feeder, 1) - lower).abs() < 0.05, "{}", slope(&feeder, 1));
        let alpha = upper * PI / 180.0;
        let (x, y) = (Vec2::at_angle(-alpha), Vec2::at_angle(-alpha - 0.5 * PI));
        assert!(miss(&feeder, 1, along * x) < 1e-14 && miss(&feeder, 1, normal * y) < 1e-14, "{name}");
        let plate = &feeder.plates[1];
        assert!(plate.edge.x < plate.uphill.x && plate.unbounded, "descends to the left, as long as needed");
        assert!(plate.edge.x < -5.0 && plate.uphill.x > 0.5, "reaches well past where a part can fall");
    }
}

#[test]
fn the_start_lies_on_the_first_plate() {
    let feeder = example("case_1.toml").to_feeder();
    let pose = feeder.start_state().pose;
    let down = Vec2::at_angle(-PI / 12.0);
    at(pose.centre, -0.1 * down.x, -0.1 * down.y);
    close(pose.angle, -PI / 12.0);
    let vertex = feeder.part.body.shape.vertices()[1].rotated(down.x, down.y);
    assert!(vertex.dot(down) > 0.0, "vertex 1 is the front");

    let feeder = example("case_1_box.toml").to_feeder();
    let pose = feeder.start_state().pose;
    let normal = down.turned_left();
    at(pose.centre, -0.1 * down.x + 5e-4 * normal.x, -0.1 * down.y + 5e-4 * normal.y);

    let left = rod("[[plate]]\nslope = \"15 deg\"\ndownhill = \"left\"\n").to_feeder();
    close(left.start_state().pose.angle, PI / 12.0);
}

#[test]
fn a_designers_plates_hang_on_the_walls() {
    let feeder = example("designer.toml").to_feeder();
    let [upper, lower] = &feeder.plates[..] else { panic!("two plates") };
    at(upper.uphill, 0.0, 0.0);
    close(upper.edge.x, 0.2);
    close(upper.edge.y, -0.2 * tan(10.0 * PI / 180.0));
    at(lower.uphill, 0.4, -0.18);
    close(lower.edge.x, 0.06);
    close(slope(&feeder, 1), 25.0);
    let [left, right] = &feeder.walls[..] else { panic!("two walls") };
    assert_eq!((left.from.x, left.to.x, right.from.x, right.to.x), (0.0, 0.0, 0.4, 0.4));
    assert!(left.from.y > 1.0 && left.to.y < lower.edge.y - 1.0, "{left:?}");
    assert_eq!(example("designer.toml").wants(), [None, Some(Want::Turned)]);
}

#[test]
fn a_zigzag_alternates() {
    let scene = example("zigzag.toml");
    let feeder = scene.feeder();
    assert_eq!((feeder.plates.len(), feeder.stop), (5, Stop::Delivered));
    let hinges: Vec<f64> = feeder.plates.iter().map(|plate| plate.uphill.x).collect();
    assert_eq!(hinges, [0.0, 0.22, 0.0, 0.22, 0.0]);
    close(feeder.plates[4].uphill.y, -0.44);
    close(feeder.plates[1].edge.x, 0.08);
    let body = &feeder.part.body;
    close(body.mass, 7800.0 * 0.06 * 0.003 * 0.025);
    close(body.inertia, body.mass * (0.06 * 0.06 + 0.003 * 0.003) / 12.0);
    let taller = scene.with("zigzag.plates", 7.0).unwrap();
    assert_eq!(taller.feeder().plates.len(), 7);
    assert!(scene.with("zigzag.plates", 2.5).is_err(), "half a plate");
}

#[test]
fn plates_by_a_point_below_the_edge() {
    let feeder = rod(
        "[[plate]]\nslope = \"15 deg\"\n[[plate]]\nslope = \"20 deg\"\nbelow = { x = \"120 mm\", y = \"-150 mm\" }\n",
    )
    .to_feeder();
    close(slope(&feeder, 1), 20.0);
    assert!(miss(&feeder, 1, Vec2::new(0.12, -0.15)) < 1e-14, "{feeder:?}");
    assert!(feeder.plates[1].edge.x < 0.0, "downhill is back, unless said otherwise");
    let on = "[[plate]]\nslope = \"15 deg\"\n[[plate]]\nslope = \"20 deg\"\ndownhill = \"right\"\nbelow = [0.12, -0.15]\n";
    let feeder = rod(on).to_feeder();
    let plate = &feeder.plates[1];
    assert!(plate.edge.x > 1.0 && plate.uphill.y <= 1e-15, "stays below the edge it is measured from");
}

#[test]
fn absolute_places() {
    let feeder = rod(
        "[[plate]]\nedge = [\"10 mm\", \"20 mm\"]\nslope = \"30 deg\"\nlength = \"200 mm\"\n[[plate]]\nfrom = [0.4, -0.2]\nto = [-0.1, -0.3]\nfriction = 0.2\n[[wall]]\nname = \"stop\"\nfrom = [-0.2, 0]\nto = [-0.2, -0.4]\n",
    )
    .to_feeder();
    at(feeder.plates[0].edge, 0.01, 0.02);
    at(feeder.plates[0].uphill, 0.01 - 0.2 * cos(PI / 6.0), 0.12);
    at(feeder.plates[1].edge, -0.1, -0.3);
    assert_eq!((feeder.plates[0].friction, feeder.plates[1].friction), (0.15, 0.2));
    assert_eq!(feeder.walls[0].name, "stop");
}

#[test]
fn rounded_corners_keep_the_straight_sides() {
    let feeder = example("hexagon.toml").to_feeder();
    let shape = &feeder.part.body.shape;
    assert_eq!((feeder.part.kind, shape.faces()), (PartKind::Polygon, 6));
    assert!((shape.radius() - 1e-3).abs() < 1e-17, "{}", shape.radius());
    for i in 0..6 {
        let height = shape.face(i).0.dot(shape.face_normal(i)) + shape.radius();
        assert!((height - 0.01).abs() < 1e-7, "face {i} is {height} from the middle");
    }
    let boxed = scene(
        &ROD.replace("shape = \"rod\"", "shape = \"box\"\nheight = 0.02\ncorner_radius = 0.004")
            .replace("[contact]", "[[plate]]\nslope = 0.2\n[contact]"),
    );
    let shape = &boxed.feeder().part.body.shape;
    at(shape.vertices()[2], 0.046, 0.006);
}

#[test]
fn clockwise_corners_are_reversed_and_it_is_said() {
    let triangle = |vertices: &str| {
        scene(&format!(
            "[part]\nshape = \"polygon\"\nmass = 1\nvertices = {vertices}\n[contact]\nfriction = 0.1\n[start]\nto_edge = 0.1\n[[plate]]\nslope = 0.3\n"
        ))
    };
    let (forth, back) = (triangle("[[0, 0], [0.3, 0], [0, 0.6]]"), triangle("[[0, 0], [0, 0.6], [0.3, 0]]"));
    assert_eq!(forth.feeder(), back.feeder());
    assert_eq!((forth.notes().len(), back.notes().len()), (0, 1));
    at(forth.feeder().part.body.shape.vertices()[0], -0.1, -0.2);
    close(forth.feeder().part.body.inertia, (0.09 + 0.36) / 18.0);
}

#[test]
fn quantities_are_listed_and_set_by_path() {
    let scene = example("designer.toml");
    let quantities = scene.quantities();
    let find = |path: &str| quantities.iter().find(|quantity| quantity.path == path).unwrap();
    assert_eq!(find("plate.lower.drop").value, 0.18);
    assert_eq!(find("contact.friction").tolerance, Some(Tolerance::Limits { half_width: 0.03 }));
    assert!(!find("gravity").written && find("part.mass").written, "defaults are not written");

    let other = scene.with("plate.1.slope", 0.5).unwrap();
    close(slope(other.feeder(), 1), 0.5 * 180.0 / PI);
    assert_eq!(other, scene.with("plate.lower.slope", 0.5).unwrap());
    assert_eq!(scene.with("contact.friction", 0.3).unwrap().feeder().plates[1].friction, 0.3);
    for (path, value, says) in [
        ("contact.friction", -1.0, "must be 0 or more"),
        ("contact.friction", f64::NAN, "must be a finite number"),
        ("contact.friction", 1e11, "must be at most 1000000"),
        ("gravity", 1e-200, "must be at least 1e-9 m/s^2"),
        ("start.speed", 1e12, "must be at most 1000000 m/s"),
        ("plate.lower.slop", 0.1, "did you mean \"plate.lower.slope\"?"),
        ("channel.width", 0.05, "leaves no plate"),
    ] {
        let problems = scene.with(path, value).expect_err(path).to_string();
        assert!(problems.contains(says), "{problems}");
    }
}

/// Examples whose parts and plates are of different kinds.
const OF_EACH_KIND: [&str; 6] =
    ["designer.toml", "zigzag.toml", "hexagon.toml", "disc.toml", "bracket.toml", "chute.toml"];

#[test]
fn setting_a_quantity_to_its_value_changes_nothing() {
    for name in ["case_1.toml"].into_iter().chain(OF_EACH_KIND) {
        let scene = example(name);
        for quantity in scene.quantities() {
            let same = scene.with(&quantity.path, quantity.value).unwrap();
            assert_eq!(same.feeder(), scene.feeder(), "{name}: {}", quantity.path);
        }
    }
}

#[test]
fn designs_are_kept() {
    let scene = example("designer.toml");
    let design = scene.design().unwrap();
    let free: Vec<(&str, f64, f64)> =
        design.free.iter().map(|free| (free.path.as_str(), free.low, free.high)).collect();
    let deg = |x: f64| x * PI / 180.0;
    assert_eq!(free, [("plate.lower.slope", deg(10.0), deg(40.0)), ("plate.lower.drop", 0.12, 0.26)]);
    assert_eq!(design.max_impact_speed.as_ref().map(|speed| speed.value), Some(3.0));
    let fed = rod("[[plate]]\nslope = 0.3\n[feed]\nparts = 3\ninterval = \"1.2 s\"\n");
    assert_eq!(fed.feed().map(|feed| (feed.parts, feed.interval)), Some((3, 1.2)));
}

/// Every number of a feeder.
fn numbers(feeder: &Feeder) -> Vec<f64> {
    let body = &feeder.part.body;
    let mut all = vec![feeder.gravity, body.mass, body.inertia, feeder.start.to_edge, feeder.start.speed];
    all.extend(body.shape.vertices().iter().flat_map(|v| [v.x, v.y]));
    for plate in &feeder.plates {
        all.extend([
            plate.uphill.x,
            plate.uphill.y,
            plate.edge.x,
            plate.edge.y,
            plate.friction,
            plate.restitution,
            plate.form.edge_radius,
        ]);
        all.extend(plate.form.course.iter().flat_map(|point| [point.at.x, point.at.y, point.sweep]));
    }
    for wall in &feeder.walls {
        all.extend([wall.from.x, wall.from.y, wall.to.x, wall.to.y, wall.friction, wall.restitution]);
    }
    all
}

#[test]
fn extreme_quantities_are_finite_feeders_or_problems() {
    let extremes = [0.0, -0.0, 1e-320, 1e-200, 1e-12, 1.5, 1e3, 1e12, 1e200, f64::MAX, f64::INFINITY, -1.0];
    for name in ["case_2.toml"].into_iter().chain(OF_EACH_KIND) {
        let scene = example(name);
        for quantity in scene.quantities() {
            for value in extremes {
                match scene.with(&quantity.path, value) {
                    Ok(changed) => {
                        let all = numbers(changed.feeder());
                        assert!(all.iter().all(|x| x.is_finite()), "{name}: {} = {value}", quantity.path);
                    }
                    Err(problems) => assert!(!problems.list.is_empty(), "{name}: {}", quantity.path),
                }
            }
        }
    }
}

#[test]
fn a_scene_is_written_anew_with_other_values() {
    let source = std::fs::read_to_string("../../examples/designer.toml").unwrap();
    let scene = Scene::parse("designer.toml", &source).unwrap();
    let varied = scene.varied().unwrap();
    let paths: Vec<String> = varied.quantities().map(|q| q.path.clone()).collect();
    assert!(!paths.is_empty());
    let point: Vec<f64> = (0..paths.len()).map(|i| 0.1 + 0.7 * (i as f64 * 0.618).fract()).collect();
    let text = varied.text(&point).unwrap();
    let again = Scene::parse("again.toml", &text).unwrap();
    // To the last bit: what a worst case is saved as must end as it did.
    assert_eq!(again.feeder(), &varied.feeder(&point).unwrap());
    assert!(again.varied().is_err(), "nothing varies any more");
    let middle = vec![0.5; paths.len()];
    for (value, quantity) in varied.values(&middle).iter().zip(varied.quantities()) {
        assert!((value - quantity.value).abs() < 1e-14 * quantity.value.abs(), "{}", quantity.path);
    }
}
