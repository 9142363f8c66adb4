//! Feeders in space: against the engine of the plane, and against closed forms.

#![allow(clippy::print_stdout, reason = "how far two engines differ is a measurement")]

use crate::extruded::in_space;
use carom_feeder::spatial::{self, CrossSection, Exit, Wall, WallForm, examples};
use carom_feeder::{
    Feeder, FeederProblem, Form, Outcome, Part, PartKind, Plate, RunError, StageName, Start, Stop,
};
use carom_motion::planar::Shape;
use carom_motion::spatial::{Options, Polyhedron, State};
use carom_num::elementary::{atan2, sin_cos, tan};
use carom_num::{Rotation, Vec2, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

const SCENES: u64 = 1000;
const IN_A_GROOVE: u64 = 100;
const TRIPPING: u64 = 200;
const ROUNDED: u64 = 300;
const ANYHOW: u64 = 200;
/// Looks at the motion of one drop, in search of its events.
const MOST_LOOKS: u64 = 1_000_000;
/// Where no series of impacts is closed the two engines agree so far [s].
const SAME_TIME: f64 = 1e-9;
/// A series is closed at its limit, in each engine at another impact. Rocking whose turns follow no ratio ends where rounding takes its gaps away [s].
const AFTER_SERIES: f64 = 1e-5;
/// Three in four of those whose turns follow one are alike to this [s].
const AFTER_MOST_SERIES: f64 = 2e-8;

/// A box slides down a plate, over its end and onto another plate.
struct Scene {
    edges: [f64; 3],
    slopes: [f64; 2],
    friction: f64,
    restitution: f64,
    speed: f64,
    lower: Vec2,
    /// Of the box's edges; its faces stay where they are.
    radius: f64,
    /// Of the plates' edges.
    sheet: f64,
}

impl Scene {
    fn drawn(case: u64) -> Self {
        let mut rng = Pcg64::seed_from_u64(case);
        let edges =
            [rng.random_range(0.03..0.06), rng.random_range(0.005..0.025), rng.random_range(0.01..0.03)];
        let slopes: [f64; 2] = [rng.random_range(0.17..0.52), rng.random_range(0.09..0.44)];
        let friction = rng.random_range(0.05..0.6 * tan(slopes[0]));
        let restitution = if case.is_multiple_of(2) { 0.0 } else { rng.random_range(0.0..0.4) };
        let lower = Vec2::new(rng.random_range(-0.2..-0.1), -rng.random_range(0.1..0.2));
        Self { edges, slopes, friction, restitution, speed: 0.0, lower, radius: 0.0, sheet: 0.0 }
    }

    /// Uphill ends and free edges.
    fn plates(&self) -> [(&'static str, Vec2, Vec2); 2] {
        let [upper, lower] = self.slopes;
        let rises = self.lower + Vec2::new(0.4, 0.4 * tan(lower));
        [("upper", Vec2::new(-0.25, 0.25 * tan(upper)), Vec2::ZERO), ("lower", rises, self.lower)]
    }

    fn in_the_plane(&self) -> Feeder {
        let plate = |(name, uphill, edge): (&str, Vec2, Vec2)| Plate {
            name: name.to_owned(),
            uphill,
            edge,
            friction: self.friction,
            restitution: self.restitution,
            unbounded: false,
            form: Form { edge_radius: self.sheet, ..Form::default() },
        };
        let [length, height, _] = self.edges;
        let inertia = 0.05 * (length * length + height * height) / 12.0;
        let mut part = Part::rectangle(length, height, 0.05, inertia).unwrap();
        let [a, b] = [length, height].map(|edge| 0.5 * edge - self.radius);
        let corners = [(-a, -b), (a, -b), (a, b), (-a, b)].map(|(x, y)| Vec2::new(x, y));
        part.body.shape = Shape::new(corners.to_vec(), self.radius).unwrap();
        Feeder {
            gravity: 9.81,
            stop: Stop::Landed,
            law: Default::default(),
            // Its faces by their numbers: in space no face is an end.
            part: Part { kind: PartKind::Polygon, ..part },
            start: Start { to_edge: 0.12, speed: self.speed, face: 0 },
            plates: self.plates().map(plate).to_vec(),
            walls: vec![],
        }
    }

    fn in_space(&self, walls: Vec<Wall>) -> spatial::Feeder {
        let [x, y, z] = self.edges;
        let part = examples::block(Vec3::new(x, y, z), 0.05);
        let part = if self.radius > 0.0 { self.rounded(&part) } else { part };
        spatial::Feeder { walls, ..in_space(&self.in_the_plane(), part) }
    }
}

impl Scene {
    /// The same box with round edges, with the same mass and inertia.
    fn rounded(&self, part: &spatial::Part) -> spatial::Part {
        let inwards = |r: &Vec3| {
            let [x, y, z] = r.to_array().map(|x| x - self.radius.copysign(x));
            Vec3::new(x, y, z)
        };
        let corners: Vec<Vec3> = part.body.supports().iter().map(inwards).collect();
        let inner = Polyhedron::of_points(&corners, 1e-9).unwrap();
        let heft = (part.body.mass(), part.body.inertia());
        spatial::Part::about((&inner, self.radius), Vec3::ZERO, heft).unwrap()
    }
}

/// The direction of a face of a box in the plane, by its number.
fn direction(face: usize) -> Vec3 {
    [-Vec3::Y, Vec3::X, Vec3::Y, -Vec3::X][face]
}

/// Outcome and face are the same; how far the times of landing differ, or of coming to rest without one, and whether a series was closed.
fn differ(case: u64, scene: &Scene, walls: Vec<Wall>) -> (f64, bool) {
    let plane = scene.in_the_plane().run().unwrap();
    let feeder = scene.in_space(walls);
    let space = feeder.run().unwrap();
    assert_eq!(space.outcome, plane.outcome, "{case}");
    let series = !space.closings.is_empty() || !plane.trace.accumulations.is_empty();
    let (Some(own), Some(other)) = (space.final_landing(), plane.final_landing()) else {
        // What misses a plate ends where the run does.
        let stuck = space.outcome == Outcome::Stuck;
        return (if stuck { (space.end_time - plane.end_time).abs() } else { 0.0 }, series);
    };
    let normal = feeder.part.faces[own.face.unwrap()].normal;
    assert!((normal - direction(other.face.unwrap())).norm() < 1e-9, "{case}: {own:?}, not {other:?}");
    ((own.flat.unwrap() - other.flat.unwrap()).abs(), series)
}

fn told(what: &str, mut found: Vec<(f64, bool)>) {
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (series, most) in [(false, SAME_TIME), (true, AFTER_SERIES)] {
        let times: Vec<f64> =
            found.iter().filter(|(_, closed)| *closed == series).map(|(time, _)| *time).collect();
        let (half, worst) = (times[times.len() / 2], times[times.len() - 1]);
        let kind = if series { "with a series of impacts" } else { "without" };
        let most_of = times[times.len() * 3 / 4];
        println!(
            "{what}, {} {kind}: half within {half:.1e} s, three in four {most_of:.1e} s, the worst {worst:.1e} s",
            times.len()
        );
        assert!(worst <= most && most_of <= AFTER_MOST_SERIES, "{what}: {most_of} s, {worst} s");
    }
}

#[test]
fn boxes_go_through_feeders_as_in_the_plane() {
    let found = (0..SCENES).into_par_iter().map(|case| differ(case, &Scene::drawn(case), vec![]));
    told("1000 feeders", found.collect());
}

/// They roll over the ends of the plates, and over their own edges.
#[test]
fn rounded_boxes_go_through_feeders_as_in_the_plane() {
    let one = |case: u64| {
        let scene = Scene::drawn(case);
        let thin = scene.edges.into_iter().fold(f64::INFINITY, f64::min);
        let radius = thin * Pcg64::seed_from_u64(2000 + case).random_range(0.05..0.45);
        differ(case, &Scene { radius, ..scene }, vec![])
    };
    told("300 rounded boxes", (0..ROUNDED).into_par_iter().map(one).collect());
}

/// They roll over the round ends of sheets, sharp ones and rounded ones.
#[test]
fn boxes_go_over_round_sheets_as_in_the_plane() {
    let one = |case: u64| {
        let scene = Scene::drawn(case);
        let thin = scene.edges.into_iter().fold(f64::INFINITY, f64::min);
        let mut rng = Pcg64::seed_from_u64(3000 + case);
        let sheet = rng.random_range(0.0005..0.01);
        let radius = if case.is_multiple_of(3) { thin * rng.random_range(0.05..0.45) } else { 0.0 };
        differ(case, &Scene { radius, sheet, ..scene }, vec![])
    };
    told("300 boxes on round sheets", (0..ROUNDED).into_par_iter().map(one).collect());
}

/// With a friction of 1 to 6 a box that starts at a speed trips: over its front edge, by an impact without approach where no motion is consistent (Painlevé's paradox).
#[test]
fn boxes_that_trip_do_as_in_the_plane() {
    let one = |case: u64| {
        let mut rng = Pcg64::seed_from_u64(1000 + case);
        let (friction, speed) = (rng.random_range(1.0..6.0), rng.random_range(0.2..1.0));
        differ(case, &Scene { friction, speed, ..Scene::drawn(case) }, vec![])
    };
    told("200 boxes that trip", (0..TRIPPING).into_par_iter().map(one).collect());
}

/// Two walls beside a box, so far from it on either side.
fn groove(scene: &Scene, apart: f64) -> Vec<Wall> {
    let beside = |side: f64| Wall {
        name: "groove".to_owned(),
        form: WallForm::Beside { z: side * (0.5 * scene.edges[2] + apart) },
        friction: 0.0,
        restitution: 0.0,
    };
    vec![beside(1.0), beside(-1.0)]
}

#[test]
fn a_smooth_groove_changes_nothing() {
    let one = |case: u64| {
        let scene = Scene::drawn(case);
        differ(case, &scene, groove(&scene, 1e-3))
    };
    told("100 feeders in a groove", (0..IN_A_GROOVE).into_par_iter().map(one).collect());
}

/// However near the walls are, the box is not searched along them in least steps.
#[test]
fn a_tight_groove_takes_no_longer() {
    let looks = |apart: f64| {
        let one = |case: u64| {
            let scene = Scene::drawn(case);
            scene.in_space(groove(&scene, apart)).run_untraced().unwrap().effort.event_evaluations
        };
        (0..IN_A_GROOVE).into_par_iter().map(one).max().unwrap()
    };
    let found = [1e-3, 1e-6, 1e-9, 1e-12].map(|apart| (apart, looks(apart)));
    println!("most looks of {IN_A_GROOVE} feeders in a groove so far apart [m]: {found:?}");
    assert!(found.iter().all(|(_, looks)| *looks < 4 * found[0].1), "{found:?}");
}

/// On a plate that is turned about its downhill line a box slides down the steepest line of it, `½ g (sin α − μ cos α) t²` far, with `cos α` the height of the plate's normal.
#[test]
fn a_box_slides_down_the_steepest_line_of_a_plate_that_is_rolled() {
    for (roll, friction) in [(0.1, 0.15), (-0.3, 0.0), (0.25, 0.3)] {
        let mut feeder = examples::two_plates();
        feeder.plates.iter_mut().for_each(|plate| plate.friction = friction);
        feeder.plates[0].roll = roll;
        feeder.start.to_edge = 0.2;
        let start = feeder.start_state();
        let run = feeder.run().unwrap();
        let slide = &run.stages[0];
        assert_eq!(slide.name, StageName::Slide, "{roll}");
        // The first piece is over where the first corner reaches the plate's end.
        let piece = run.samples.pieces[0];
        let down = Vec3::new(0.29, -0.08, 0.0).unit().unwrap();
        let left = Vec3::new(-down.y, down.x, 0.0);
        let normal = Rotation::by(down * roll).apply(left);
        let (cosine, sine) = (normal.y, (1.0 - normal.y * normal.y).sqrt());
        let steepest = (-Vec3::Y - normal * -normal.y).unit().unwrap();
        let time = piece.end_time - piece.start_time;
        let far = 0.5 * 9.81 * (sine - friction * cosine) * time * time;
        let off = (piece.end.centre - start.centre - steepest * far).norm();
        assert!(time > 0.1 && off < 1e-10, "{roll}, {friction}: {off} m off after {time} s");
        assert!((piece.end.velocity - steepest * (2.0 * far / time)).norm() < 1e-10, "{roll}, {friction}");
        // The side towards whoever looks is lowered by a positive roll.
        assert_eq!(steepest.z > 0.0, roll > 0.0, "{steepest:?}");
    }
}

#[test]
fn side_walls_keep_a_part_on_its_plate() {
    let mut feeder = examples::two_plates();
    feeder.plates[0] = spatial::Plate {
        width: Some(0.06),
        cross_section: CrossSection::Walled { height: 0.03 },
        roll: 0.3,
        ..feeder.plates[0].clone()
    };
    feeder.start.to_edge = 0.25;
    let run = feeder.run().unwrap();
    let down = Vec3::new(0.29, -0.08, 0.0).unit().unwrap();
    let across = Rotation::by(down * 0.3).apply(Vec3::Z);
    let on_plate = run.stages.iter().filter(|stage| stage.obstacle == Some(0)).map(|stage| stage.end_time);
    let until = on_plate.fold(0.0, f64::max);
    let mut widest: f64 = 0.0;
    for (_, _, state) in run.samples.instants.iter().filter(|(time, ..)| *time <= until) {
        for corner in feeder.part.body.supports() {
            let place = state.place(*corner);
            // Beyond the end of the plate its walls end too.
            if down.dot(place) <= 0.0 {
                widest = widest.max(across.dot(place).abs());
            }
        }
    }
    assert!(
        (widest - 0.03).abs() < 1e-9,
        "it slides along the wall, half of 60 mm from the middle: {widest}"
    );
    let free = spatial::Feeder {
        plates: vec![
            spatial::Plate { cross_section: CrossSection::Flat, ..feeder.plates[0].clone() },
            feeder.plates[1].clone(),
        ],
        ..feeder
    };
    assert_ne!(free.run().unwrap().end, run.end, "without walls it goes over the side");
}

fn tetrahedron() -> spatial::Part {
    let corners = [[-15.4, 2.8, 23.4], [-22.8, -17.8, 9.8], [-13.2, 14.4, -14.3], [22.9, -19.0, 3.7]];
    let corners = corners.map(|[x, y, z]| Vec3::new(x, y, z) * 1e-3);
    let hull = Polyhedron::of_points(&corners, 1e-9).unwrap();
    spatial::Part::of(&hull, &hull.solid().unwrap(), 7850.0).unwrap()
}

/// Two of its edges cross the end of the plate as a corner runs off: where the uphill corner lifts off, the second edge, which has carried nothing, takes its load.
#[test]
fn tetrahedra_without_friction_leave_their_plates() {
    let part = tetrahedron();
    for case in 0..24_u32 {
        let mut feeder = examples::two_plates();
        feeder.part = part.clone();
        feeder.start.face = usize::try_from(case % 4).unwrap();
        feeder.start.turn = f64::from(case / 4);
        feeder.stop = Stop::Delivered;
        for plate in &mut feeder.plates {
            plate.friction = 0.0;
        }
        let run = feeder.run_untraced().unwrap();
        assert_eq!(run.outcome, Outcome::Delivered, "{case}");
    }
}

/// Three places that carry come together where the last corner of a face runs off: it has tipped before, and that there are no forces there is no fault of the run.
#[test]
fn tetrahedra_that_are_fast_leave_their_plates() {
    let part = tetrahedron();
    for case in 0..150_u32 {
        let mut feeder = examples::two_plates();
        feeder.part = part.clone();
        (feeder.start.face, feeder.start.speed) = (2 + usize::try_from(case % 2).unwrap(), 1.0);
        feeder.start.turn = f64::from(case / 2) * 0.0419;
        (feeder.plates[0].roll, feeder.plates[0].friction) = (0.1, 0.03);
        let run = feeder.run_untraced();
        assert!(run.is_ok(), "{case}: {:?}", run.err());
    }
}

/// It lies on three corners and on an edge over the end; as its mass centre comes out between two of them another edge, which lies there too, takes over.
#[test]
fn a_box_slides_askew_over_an_end_without_friction() {
    for turn in [3.81284_f64, 7.0, -3.3, 2.2, -8.7] {
        let mut feeder = examples::two_plates();
        feeder.part = examples::block(Vec3::new(0.037952, 0.014518, 0.042746), 0.185);
        feeder.plates.iter_mut().for_each(|plate| (plate.friction, plate.width) = (0.0, None));
        let down = Vec2::at_angle(-40f64.to_radians());
        (feeder.plates[0].uphill, feeder.plates[0].edge) = (-down * 0.2, Vec2::ZERO);
        feeder.start = spatial::Start { to_edge: 0.03, turn: turn.to_radians(), ..feeder.start };
        feeder.stop = Stop::Delivered;
        let run = feeder.run().unwrap();
        assert_ne!(run.outcome, Outcome::Jammed, "{turn}");
        let first = run.stages.iter().find(|stage| stage.name == StageName::Flight).unwrap();
        let until = first.start_time;
        let slid = run.stages.iter().filter(|stage| stage.start_time < until);
        let names: Vec<StageName> = slid.map(|stage| stage.name).collect();
        assert!(names.windows(2).all(|two| two != [StageName::Tip, StageName::Slide]), "{turn}: {names:?}");
    }
}

/// As its lower corner comes to the end of the plate, the edge beside it that carries there comes to the corner: the corner lifts off before, when the edge takes all. It was said to lift
/// off where both are one, where its force has grown without bound, and the part went on with another spin.
#[test]
fn what_lifts_off_before_two_carriers_meet_is_seen() {
    let corners = [
        [0.0177, 1.7986, 2.8091],
        [0.1484, -2.2067, 0.7484],
        [1.023, -0.9011, -2.1727],
        [-1.1861, 1.2955, -1.4148],
    ];
    let corners = corners.map(|[x, y, z]| Vec3::new(x, y, z) * 1e-3);
    let hull = Polyhedron::of_points(&corners, 1e-9).unwrap();
    let part = spatial::Part::of(&hull, &hull.solid().unwrap(), 7850.0).unwrap();
    let plate = spatial::Plate {
        uphill: Vec2::new(-0.026, 0.00204),
        edge: Vec2::ZERO,
        width: Some(0.0198),
        roll: 0.1817,
        friction: 0.459,
        restitution: 0.225,
        ..examples::two_plates().plates[0].clone()
    };
    let start = spatial::Start { to_edge: 6.87e-3, aside: -6.2e-4, turn: -1.942, speed: 0.921, face: 1 };
    let feeder = spatial::Feeder { start, part, plates: vec![plate], ..examples::two_plates() };
    let prepared = feeder.prepare(Options::default()).unwrap();
    let run = prepared.run().unwrap();
    let energy = |state: &State| state.kinetic(prepared.world().body()) + state.potential(prepared.world());
    let mut least = f64::INFINITY;
    for (time, _, state) in &run.samples.instants {
        let now = energy(state);
        assert!(now <= least + 1e-9 * state.kinetic(prepared.world().body()), "{time}: {now} after {least}");
        least = least.min(now);
    }
}

/// Friction strikes it at once, and again after every impact that it forces: that ends, and by name.
#[test]
fn a_tetrahedron_that_friction_strikes_without_end_jams() {
    let corners = [[-3.76, -0.61, 0.35], [2.68, -1.95, -1.82], [0.49, 0.49, 3.57], [0.59, 2.07, -2.1]];
    let corners = corners.map(|[x, y, z]| Vec3::new(x, y, z) * 1e-3);
    let hull = Polyhedron::of_points(&corners, 1e-9).unwrap();
    let part = spatial::Part::of(&hull, &hull.solid().unwrap(), 7850.0).unwrap();
    let steep =
        spatial::Plate { friction: 4.6, restitution: 0.5, ..examples::two_plates().plates[0].clone() };
    let steep = spatial::Plate { uphill: Vec2::new(-0.02, 0.018), edge: Vec2::ZERO, ..steep };
    let start = spatial::Start { to_edge: 8.5e-3, aside: 0.0, turn: 0.15, speed: 0.33, face: 0 };
    let feeder = spatial::Feeder { start, part, plates: vec![steep], ..examples::two_plates() };
    assert_eq!(feeder.run_untraced().unwrap().outcome, Outcome::Jammed);
}

/// One corner sticks, and a second comes down so slowly that it is held at once: where friction then lets no motion go on, its approach is what the impact starts with.
#[test]
fn a_corner_that_comes_down_slowly_beside_one_that_sticks_comes_to_rest() {
    for case in [1, 12, 18, 27, 48, 58] {
        let mut rng = Pcg64::seed_from_u64(case);
        let (friction, restitution) = (rng.random_range(1.5..8.0), rng.random_range(0.0..0.9));
        let (turn, speed) = (rng.random_range(0.0..6.0), rng.random_range(0.2..1.0));
        let start = spatial::Start { to_edge: 0.05, aside: 0.0, turn, speed, face: 0 };
        let mut feeder = spatial::Feeder { part: tetrahedron(), start, ..examples::two_plates() };
        for plate in &mut feeder.plates {
            (plate.friction, plate.restitution) = (friction, restitution);
        }
        assert_eq!(feeder.run_untraced().unwrap().outcome, Outcome::Stuck, "case {case}");
    }
}

#[test]
fn runs_end_as_in_the_plane() {
    let with = |friction: f64, lower: Vec2, stop: Stop| {
        let mut feeder = examples::two_plates();
        feeder.stop = stop;
        feeder.plates.iter_mut().for_each(|plate| plate.friction = friction);
        feeder.plates[1].uphill += lower;
        feeder.plates[1].edge += lower;
        feeder
    };
    let run = |feeder: &spatial::Feeder| feeder.run_untraced().unwrap();
    assert_eq!(run(&with(0.5, Vec2::ZERO, Stop::Landed)).outcome, Outcome::Stuck, "tan 15.4° is 0.28");
    assert_eq!(run(&with(0.15, Vec2::new(-2.0, 0.0), Stop::Landed)).outcome, Outcome::Missed, "far away");
    let delivered = run(&with(0.0, Vec2::ZERO, Stop::Delivered));
    assert_eq!(delivered.outcome, Outcome::Delivered);
    let Exit { time, state } = delivered.exit.unwrap();
    assert!(
        time > delivered.landings[0].flat.unwrap() && state.velocity.x < 0.0,
        "down to the left: {state:?}"
    );
    let free = spatial::Feeder { walls: vec![], ..with(0.15, Vec2::ZERO, Stop::Landed) };
    let narrow = spatial::Plate { width: Some(0.012), ..free.plates[1].clone() };
    let off = spatial::Feeder { plates: vec![free.plates[0].clone(), narrow], ..free };
    let off = spatial::Feeder { start: spatial::Start { aside: 0.02, ..off.start }, ..off };
    assert!(matches!(run(&off).outcome, Outcome::Escaped | Outcome::Missed), "beside a narrow plate");
}

#[test]
fn every_problem_of_a_feeder_is_told() {
    let mut feeder = examples::two_plates();
    feeder.gravity = 0.0;
    feeder.plates[0].roll = 2.0;
    feeder.plates[1].friction = -1.0;
    feeder.start.face = 9;
    feeder.start.to_edge = 1.0;
    let Err(RunError::Problems(problems)) = feeder.run() else { panic!("it is no feeder") };
    let path = |problem: &FeederProblem| match problem {
        FeederProblem::OutOfRange { path, .. } => path.clone(),
        other => other.to_string(),
    };
    let paths: Vec<String> = problems.iter().map(path).collect();
    assert_eq!(paths, ["gravity", "plate.upper.roll", "plate.lower.friction", "start.face", "start.to_edge"]);
    let mut feeder = examples::two_plates();
    feeder.walls.push(Wall {
        name: "front".to_owned(),
        form: WallForm::Beside { z: 0.005 },
        friction: 0.0,
        restitution: 0.0,
    });
    let crosses = FeederProblem::CrossesStart { path: "wall.front".to_owned() };
    assert_eq!(feeder.run().unwrap_err(), RunError::Problems(vec![crosses]), "the bar is 20 mm wide");
}

/// However the part is turned on the first plate, it lies on the face that it starts on.
#[test]
fn a_part_starts_on_its_face() {
    let mut feeder = examples::two_plates();
    for face in 0..6 {
        for turn in [0.0, 1.0, -2.5] {
            feeder.start.face = face;
            feeder.start.turn = turn;
            let start = feeder.start_state();
            let (sine, cosine) = sin_cos(atan2(0.08, 0.29));
            let normal = Vec3::new(sine, cosine, 0.0);
            let down = start.attitude.apply(feeder.part.faces[face].normal);
            assert!((down + normal).norm() < 1e-14, "{face}, {turn}: {down:?}");
            let height = normal.dot(start.centre);
            assert!((height - feeder.part.faces[face].depth).abs() < 1e-15, "{face}, {turn}: {height}");
        }
    }
}

/// A feeder that is drawn by chance, with a box that is set down anyhow; or its image in the plane of the drawing.
fn drawn_anyhow(case: u64, mirrored: bool) -> spatial::Feeder {
    let scene = Scene::drawn(case);
    let mut feeder = scene.in_space(vec![]);
    let mut rng = Pcg64::seed_from_u64(case ^ 0x5eed);
    let side = if mirrored { -1.0 } else { 1.0 };
    let (turn, aside) = (rng.random_range(-3.0..3.0), rng.random_range(-0.01..0.01));
    let face = rng.random_range(0..6);
    let face = if mirrored { image(&feeder.part, face) } else { face };
    feeder.start = spatial::Start { turn: side * turn, aside: side * aside, face, ..feeder.start };
    for plate in &mut feeder.plates {
        plate.roll = side * rng.random_range(-0.1_f64..0.1);
    }
    let lower = &mut feeder.plates[1];
    lower.width = rng.random_bool(0.5).then(|| rng.random_range(0.06..0.12));
    if lower.width.is_some() && rng.random_bool(0.5) {
        lower.cross_section = CrossSection::Walled { height: 0.02 };
    }
    feeder
}

/// The face that is another one's image.
fn image(part: &spatial::Part, face: usize) -> usize {
    let normal = part.faces[face].normal;
    part.facing(Vec3::new(normal.x, normal.y, -normal.z)).unwrap()
}

#[test]
fn the_image_of_a_drop_is_the_drop_of_the_image() {
    let one = |case: u64| {
        let [feeder, other] = [false, true].map(|mirrored| drawn_anyhow(case, mirrored));
        let [run, mirrored] = [&feeder, &other].map(|feeder| feeder.run_untraced().unwrap());
        assert_eq!(run.outcome, mirrored.outcome, "{case}");
        let face = |run: &spatial::Run| run.final_landing().and_then(|landing| landing.face);
        assert_eq!(face(&run).map(|face| image(&feeder.part, face)), face(&mirrored), "{case}");
        // What takes long is one search among others: a drop that needs many times the work of the others is stuck in it.
        let looks = run.effort.event_evaluations.max(mirrored.effort.event_evaluations);
        (looks, (run.end_time - mirrored.end_time).abs())
    };
    let found: Vec<(u64, f64)> = (0..ANYHOW).into_par_iter().map(one).collect();
    let looks = found.iter().map(|(looks, _)| *looks).max().unwrap();
    let mut apart: Vec<f64> = found.iter().map(|(_, apart)| *apart).collect();
    apart.sort_by(f64::total_cmp);
    let (half, worst) = (apart[apart.len() / 2], apart[apart.len() - 1]);
    println!(
        "{ANYHOW} feeders and their images: half end within {half:.1e} s, the worst {worst:.1e} s; at most {looks} looks"
    );
    assert!(half < SAME_TIME && looks < MOST_LOOKS, "{half} s, {looks} looks");
}
