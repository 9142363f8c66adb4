//! Plates that are V grooves: against closed forms, against plates with walls, and against their mirror images.

#![allow(clippy::print_stdout, reason = "how deep parts are is a measurement")]

use carom_feeder::spatial::{CrossSection, Feeder, Part, Plate, Run, Start, examples};
use carom_feeder::{FeederProblem, Outcome, RunError, StageName, Stop};
use carom_motion::spatial::{Options, Polyhedron, State};
use carom_num::elementary::{atan2, cos, sin};
use carom_num::{Vec2, Vec3};
use carom_theory::spatial::Groove;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;
use std::f64::consts::PI;

const G: f64 = 9.81;
const FALLING: u64 = 60;

/// One groove that opens so far, down a slope to the origin, and a box that starts in it.
fn groove(angle: f64, slope: f64, friction: f64) -> Feeder {
    let mut feeder = examples::two_plates();
    feeder.plates.truncate(1);
    feeder.stop = Stop::Delivered;
    let plate = &mut feeder.plates[0];
    (plate.uphill, plate.edge) = (Vec2::new(-cos(slope), sin(slope)), Vec2::ZERO);
    (plate.cross_section, plate.friction) = (CrossSection::Groove { angle }, friction);
    feeder.start.to_edge = 0.5;
    feeder
}

/// The state before the first strike.
fn before_strike(run: &Run) -> State {
    run.samples.pieces.iter().rfind(|piece| piece.end_time <= run.impacts[0].time).unwrap().end
}

/// The state after the first piece, and how long that took.
fn first_piece(run: &Run) -> (State, f64) {
    let piece = run.samples.pieces[0];
    (piece.end, piece.end_time - piece.start_time)
}

#[test]
fn a_box_slides_down_a_groove_as_the_closed_form_says() {
    for (degrees, slope, friction) in
        [(90.0_f64, 0.5, 0.2), (60.0, 0.6, 0.15), (120.0, 0.3, 0.1), (40.0, 0.9, 0.25), (150.0, 0.4, 0.0)]
    {
        let angle = degrees.to_radians();
        let feeder = groove(angle, slope, friction);
        let start = feeder.start_state();
        let run = feeder.run().unwrap();
        assert_eq!(run.stages[0].name, StageName::Slide, "{degrees}");
        assert_eq!(run.outcome, Outcome::Delivered, "{degrees}");
        let (end, time) = first_piece(&run);
        let braking = Groove { flank: 0.5 * (PI - angle), friction }.braking().unwrap();
        let far = 0.5 * G * (sin(slope) - braking * cos(slope)) * time * time;
        let down = Vec3::new(cos(slope), -sin(slope), 0.0);
        let off = (end.centre - start.centre - down * far).norm();
        assert!(time > 0.2 && off < 1e-10, "{degrees}°: {off} m off after {time} s");
        assert!((end.velocity - down * (2.0 * far / time)).norm() < 1e-10, "{degrees}°");
    }
}

/// It rests where friction on both flanks holds it and slides where it does not; from the wedging angle on it stays on any slope.
#[test]
fn a_box_rests_in_a_groove_up_to_the_slope_that_flanks_hold() {
    let angle = 1.2;
    let flank = 0.5 * (PI - angle);
    let gentle = 0.3;
    let limit = atan2(Groove { flank, friction: gentle }.braking().unwrap(), 1.0);
    let below = groove(angle, limit - 1e-6, gentle).run().unwrap();
    assert_eq!((below.outcome, below.end_time), (Outcome::Stuck, 0.0));
    let holding = atan2(Groove { flank, friction: gentle }.holding().unwrap(), 1.0);
    let above = groove(angle, holding + 1e-3, gentle).run().unwrap();
    assert_eq!((above.outcome, above.stages[0].name), (Outcome::Delivered, StageName::Slide));
    let narrow = groove(0.5, 1.2, 0.3).run().unwrap();
    assert_eq!(Groove { flank: 0.5 * (PI - 0.5), friction: 0.3 }.holding().unwrap(), f64::INFINITY);
    assert_eq!((narrow.outcome, narrow.end_time), (Outcome::Stuck, 0.0));
}

/// One corner sticks in the bottom while the box turns about it, until friction cannot hold it there: it slides on, and lies along the groove.
#[test]
fn a_box_that_starts_askew_turns_into_the_groove() {
    for degrees in [-20.0_f64, -10.0, 5.0, 10.0, 15.0, 20.0] {
        let mut feeder = groove(0.5 * PI, 0.35, 0.2);
        feeder.part = examples::block(Vec3::new(0.03, 0.012, 0.012), 0.034);
        feeder.start.turn = degrees.to_radians();
        let run = feeder.run().unwrap();
        assert_eq!(run.outcome, Outcome::Delivered, "{degrees}°");
        let long = run
            .samples
            .pieces
            .iter()
            .max_by(|a, b| (a.end_time - a.start_time).total_cmp(&(b.end_time - b.start_time)));
        let along = long.unwrap().end.attitude.apply(Vec3::X);
        let down = Vec3::new(cos(0.35), -sin(0.35), 0.0);
        assert!(along.cross(down).norm() < 1e-9, "{degrees}°: {along:?}");
    }
}

/// Rolled by half of its right angle it is a level plate with a wall along one side. They are compared until the part strikes the plate below: there two of its corners strike at once, or not.
#[test]
fn a_right_groove_on_its_side_is_a_plate_beside_a_wall() {
    let mut walled = examples::two_plates();
    let half = 0.04;
    walled.plates[0] = Plate {
        width: Some(2.0 * half),
        cross_section: CrossSection::Walled { height: 0.1 },
        ..walled.plates[0].clone()
    };
    // Its long side along the wall that is towards whoever looks.
    walled.start.aside = half - 0.01;
    let mut grooved = walled.clone();
    let plate = &mut grooved.plates[0];
    (plate.cross_section, plate.width) = (CrossSection::Groove { angle: 0.5 * PI }, None);
    plate.roll = -0.25 * PI;
    grooved.start.aside = 0.0;
    let [own, other] = [&grooved, &walled].map(|feeder| feeder.run().unwrap());
    let moved = Vec3::Z * half;
    let apart = grooved.start_state().centre + moved - walled.start_state().centre;
    assert!(apart.norm() < 1e-12, "{apart:?}");
    let [a, b] = [&own, &other].map(before_strike);
    let names = |run: &Run| run.stages.iter().take(2).map(|stage| stage.name).collect::<Vec<_>>();
    assert_eq!((names(&own), names(&other)), (vec![StageName::Slide, StageName::Flight], names(&own)));
    assert!((own.impacts[0].time - other.impacts[0].time).abs() < 1e-11);
    assert!((a.centre + moved - b.centre).norm() < 1e-11 && (a.spin - b.spin).norm() < 1e-9, "{a:?} {b:?}");
}

/// Where everything is drawn the other way round behind the drawing, all happens there as it did before it.
#[test]
fn a_groove_catches_what_falls_as_its_mirror_image_does() {
    for case in 0..20_u32 {
        let k = f64::from(case);
        let drawn = |side: f64| {
            let mut feeder = examples::two_plates();
            feeder.start =
                Start { aside: side * 0.004 * sin(k), turn: side * 0.3 * cos(2.0 * k), ..feeder.start };
            feeder.plates[0].roll = side * 0.05 * sin(3.0 * k);
            let lower = &mut feeder.plates[1];
            lower.cross_section = CrossSection::Groove { angle: (70.0 + 4.0 * k).to_radians() };
            (lower.width, lower.edge_radius) = (Some(0.1), if case % 2 == 0 { 0.0 } else { 0.002 });
            lower.roll = side * 0.2 * cos(k);
            feeder
        };
        let [own, other] = [drawn(1.0), drawn(-1.0)].map(|feeder| feeder.run().unwrap());
        assert_eq!(own.outcome, other.outcome, "{case}");
        assert!(own.walls_touched.is_empty() && own.struck.contains(&1), "{case}");
        let mirrored = |v: Vec3| Vec3::new(v.x, v.y, -v.z);
        // Before its strikes grow any difference.
        let first = (&own.impacts[0], &other.impacts[0]);
        assert!((first.0.time - first.1.time).abs() < 1e-12, "{case}");
        let [a, b] = [&own, &other].map(before_strike);
        assert!((a.centre - mirrored(b.centre)).norm() < 1e-12, "{case}");
        let faces = [&own, &other].map(|run| run.final_landing().and_then(|landing| landing.face));
        let normals = faces.map(|face| face.map(|face| examples::two_plates().part.faces[face].normal));
        if let [Some(a), Some(b)] = normals {
            assert!((a - mirrored(b)).norm() < 1e-9, "{case}: {a:?} {b:?}");
        }
    }
}

/// A tetrahedron or a box falls off a plate into a groove, narrow or wide.
fn falls_into_a_groove(case: u64) -> Feeder {
    let mut rng = Pcg64::seed_from_u64(case);
    let mut near = |far: f64| rng.random_range(-far..far);
    let mut feeder = examples::two_plates();
    if case.is_multiple_of(2) {
        let corners = [(1.0, 0.0, 1.0), (-1.0, 0.0, 1.0), (0.0, 1.0, -1.0), (0.0, -1.0, -0.5)];
        let corner = |(x, y, z): (f64, f64, f64)| {
            (Vec3::new(x, y, z) + Vec3::new(near(0.3), near(0.3), near(0.3))) * 0.015
        };
        let hull = Polyhedron::of_points(&corners.map(corner), 1e-9).unwrap();
        feeder.part = Part::of(&hull, &hull.solid().unwrap(), 2700.0).unwrap();
        feeder.start.face = usize::try_from(case / 2 % 4).unwrap();
    }
    (feeder.start.turn, feeder.start.aside) = (near(3.0), near(0.01));
    feeder.stop = Stop::Delivered;
    let lower = &mut feeder.plates[1];
    lower.cross_section = CrossSection::Groove { angle: 1.2 + near(0.7) };
    (lower.friction, lower.restitution, lower.roll) = (0.4 + near(0.35), 0.3 + near(0.3), near(0.2));
    lower.edge = Vec2::new(-0.12 + near(0.03), -0.22);
    feeder
}

/// Whatever strikes, wedges and runs off there, no part reaches into a plate: hops are counted, and the place of the part follows.
#[test]
fn nothing_sinks_into_a_groove() {
    let deepest = |case: u64| {
        let feeder = falls_into_a_groove(case);
        let prepared =
            feeder.prepare(Options { most_steps: 4000, most_impacts: 400, ..Options::default() }).unwrap();
        let (run, world) = (prepared.run().unwrap(), prepared.world());
        let states = run.samples.instants.iter().map(|(_, _, state)| state);
        let depth = |state: &State| world.reaches_into(state, 0.0).into_iter().map(|(_, depth)| depth);
        states.flat_map(depth).fold(0.0, f64::max) / world.body().reach()
    };
    let found: Vec<f64> = (0..FALLING).into_par_iter().map(deepest).collect();
    let worst = found.iter().copied().fold(0.0, f64::max);
    println!("{FALLING} parts that fall into grooves: the deepest is {worst:.1e} of its size in a flank");
    assert!(
        worst < 1e-9,
        "{:?}",
        found.iter().enumerate().filter(|(_, deep)| **deep > 1e-9).collect::<Vec<_>>()
    );
}

#[test]
fn what_no_groove_can_be_is_told() {
    let told = |change: &dyn Fn(&mut Feeder)| {
        let mut feeder = groove(1.5, 0.4, 0.2);
        change(&mut feeder);
        let Err(RunError::Problems(problems)) = feeder.run() else { return vec![] };
        let path = |problem: &FeederProblem| match problem {
            FeederProblem::OutOfRange { path, .. } => path.clone(),
            other => other.to_string(),
        };
        problems.iter().map(path).collect::<Vec<_>>()
    };
    let angle = |angle: f64| CrossSection::Groove { angle };
    for degrees in [f64::NAN, -90.0, 0.0, 9.9, 170.1] {
        let problems = told(&|feeder| feeder.plates[0].cross_section = angle(degrees.to_radians()));
        assert_eq!(problems, ["plate.upper.v_angle"], "{degrees}");
    }
    assert_eq!(told(&|feeder| feeder.start.aside = 0.01), ["start.aside"]);
}
