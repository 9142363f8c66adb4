//! How runs in space begin and end, each against what one can say by hand.

use crate::bodies;

use carom_motion::MotionError;
use carom_motion::spatial::{
    Body, BodyProblem, Budget, Choice, Clock, End, Impact, Mode, Observer, Options, Overturning, Run,
    Samples, State, Supports, World, run,
};
use carom_num::elementary::{atan, cos, sin};
use carom_num::{Mat3, Rotation, Vec3};
use std::ops::ControlFlow;

/// What a run at the tolerance 1e-14 leaves of angles [rad], spins [rad/s], times [s] and shares of a size.
const FOLLOWED: f64 = 1e-12;
const G: f64 = 9.81;

/// A cube of 1 m and 1 kg, its lower corners as supports.
fn cube() -> Body {
    let corner = |x: f64, y: f64| Vec3::new(x, y, -0.5);
    let corners = vec![corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
    Body::new(1.0, Mat3::diagonal(1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0), corners).unwrap()
}

/// A rod of 2 m and 1 kg along its axis z, by its ends.
fn rod() -> Body {
    let third = 1.0 / 3.0;
    Body::new(1.0, Mat3::diagonal(third, third, 1e-3), vec![-Vec3::Z, Vec3::Z]).unwrap()
}

fn over(body: Body) -> World {
    World::new(body, Vec3::Z * -G).unwrap()
}

fn walked(world: &World, start: &State, options: &Options) -> (Run, Samples) {
    let mut samples = Samples::default();
    let run = run(world, start, options, &mut samples).unwrap();
    (run, samples)
}

#[test]
fn a_cube_that_is_dropped_flat_stops_after_the_time_of_its_fall() {
    let world = over(cube());
    let start =
        State { centre: Vec3::Z * 0.8, ..State::standing(world.body(), 0, Rotation::NONE, Vec3::ZERO) };
    let (run, samples) = walked(&world, &start, &Options::default());
    assert_eq!(run.end, End::AtRest { held: (0..4).collect() });
    assert!((run.time - (0.6 / G).sqrt()).abs() < 1e-15, "{}", run.time);
    assert_eq!((samples.pieces.len(), samples.pieces[0].mode), (1, Mode::Flight));
    assert_eq!(run.impacts[0].striking.len(), 4);
}

#[test]
fn a_flight_keeps_its_momentum_and_its_path() {
    for case in (0..200).step_by(2) {
        let (world, start) = bodies::drawn(case);
        let options = Options { most_impacts: 1, most_time: 0.3, ..Options::default() };
        let (_, samples) = walked(&world, &start, &options);
        let momentum = |s: &State| s.attitude.apply(world.body().inertia() * s.spin);
        let size = momentum(&start).norm();
        for (time, _, state) in samples.instants.iter().filter(|(_, mode, _)| *mode == Mode::Flight) {
            let apart = (momentum(state) - momentum(&start)).norm();
            assert!(apart < FOLLOWED * size, "case {case} at {time}: {apart:e} of {size}");
            let path = start.centre + start.velocity * *time + world.gravity() * (0.5 * time * time);
            assert!((state.centre - path).norm() < 1e-14, "case {case} at {time}");
        }
    }
}

#[test]
fn a_cube_tips_over_its_edge_once_its_centre_is_beyond() {
    let world = over(cube());
    // About the edge of corners 1 and 2, which lies in the direction of y: the centre is above it at 45°.
    let start = State::standing(world.body(), 1, Rotation::by(Vec3::Y * 0.1), Vec3::Y * 2.3);
    let options = Options { overturning: Some(Overturning::Beyond), ..Options::default() };
    let (run, _) = walked(&world, &start, &options);
    assert_eq!(run.end, End::Overturned);
    let tilt = run.state.tilt(Vec3::Z);
    assert!((tilt - atan(1.0)).abs() < FOLLOWED, "{tilt}");
    let angle = 0.7;
    let options = Options { overturning: Some(Overturning::Tilt { axis: Vec3::Z, angle }), ..options };
    let (run, _) = walked(&world, &start, &options);
    assert_eq!(run.end, End::Overturned);
    assert!((run.state.tilt(Vec3::Z) - angle).abs() < FOLLOWED, "{}", run.state.tilt(Vec3::Z));
    // By energy: J ω²/2 with J = 2/3, the centre √½ from the edge.
    let height = |tilt: f64| 0.5 * sin(tilt) + 0.5 * cos(tilt);
    let rate = (2.3 * 2.3 - 2.0 * G * (height(angle) - height(0.1)) / (2.0 / 3.0)).sqrt();
    assert!((run.state.spin.norm() - rate).abs() < FOLLOWED, "{} {rate}", run.state.spin.norm());
}

#[test]
fn what_stands_on_a_point_above_itself_is_balanced() {
    let world = over(rod());
    let start = State::standing(world.body(), 0, Rotation::NONE, Vec3::ZERO);
    let (run, _) = walked(&world, &start, &Options::default());
    assert_eq!(run.end, End::Balanced { held: Supports::one(0) });
}

/// The foot of a rod that leans by θ and turns about it presses with `N = m (g − L (θ̈ sin θ + θ̇² cos θ))`, `θ̈ = (3 g/4 L) sin θ`. Where that is zero a
/// force along the plane still holds the foot back; without it the foot would sink at ¾ g sin² θ. Only sliding could go on.
#[test]
fn a_foot_that_is_held_back_cannot_be_let_go() {
    let (lean, rate) = (0.3, 2.9);
    let squared = |tilt: f64| rate * rate + 1.5 * G * (cos(lean) - cos(tilt));
    let normal = |tilt: f64| G - 0.75 * G * sin(tilt) * sin(tilt) - squared(tilt) * cos(tilt);
    let (mut low, mut high) = (lean, 1.0);
    assert!(normal(low) > 0.0 && normal(high) < 0.0, "{} {}", normal(low), normal(high));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if normal(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let world = over(rod());
    let start = State::standing(world.body(), 0, Rotation::by(Vec3::Y * lean), Vec3::Y * rate);
    let (run, samples) = walked(&world, &start, &Options::default());
    assert_eq!(run.end, End::NoConsistentOutcome(Clock::Motion));
    assert_eq!(samples.pieces.len(), 1);
    let tilt = run.state.tilt(Vec3::Z);
    assert!((tilt - low).abs() < FOLLOWED, "{tilt} {low}");
}

#[test]
fn what_is_let_go_rises() {
    let mut seen = 0;
    for case in 0..600 {
        let (world, start) = bodies::drawn(case);
        let (run, samples) = walked(&world, &start, &Options { most_time: 2.0, ..Options::default() });
        let struck = |time: f64| run.impacts.iter().any(|i| i.time == time);
        for pair in samples.pieces.windows(2).filter(|p| !struck(p[1].start_time)) {
            let held = pair[1].mode.held(&world);
            let gone = pair[0].mode.held(&world).difference(held);
            seen += gone.len();
            let within = |t: f64| t > pair[1].start_time && t < pair[1].end_time;
            let mut states = samples.instants.iter().filter(|(t, ..)| within(*t)).map(|(_, _, s)| s);
            let lowest = |s: &State| {
                gone.iter().map(|i| s.place(world.body().supports()[i]).z).fold(f64::INFINITY, f64::min)
            };
            assert!(states.all(|s| lowest(s) > -1e-13), "case {case}: {:?}", pair[1]);
            assert!(
                (pair[1].start.spin - pair[0].end.spin).norm() < FOLLOWED,
                "case {case}: no jump {:?} {:?} {:?}",
                pair[0],
                pair[1],
                run.closings
            );
        }
    }
    assert!(seen > 3, "supports are let go: {seen}");
}

#[test]
fn supports_between_others_change_nothing() {
    let corners = cube();
    let mut supports = corners.supports().to_vec();
    supports.extend((0..4).map(|i| (corners.supports()[i] + corners.supports()[(i + 1) % 4]) * 0.5));
    let more = Body::new(1.0, corners.inertia(), supports).unwrap();
    for tilt in [Vec3::X * 0.2, Vec3::new(0.2, -0.13, 0.0)] {
        let attitude = Rotation::by(tilt);
        let low = (0..4).min_by(|a, b| {
            let z = |i: usize| attitude.apply(corners.supports()[i]).z;
            z(*a).total_cmp(&z(*b))
        });
        let start = |body: &Body| State::standing(body, low.unwrap(), attitude, Vec3::ZERO);
        let few = run(&over(corners.clone()), &start(&corners), &Options::default(), &mut ()).unwrap();
        let many = run(&over(more.clone()), &start(&more), &Options::default(), &mut ()).unwrap();
        assert!((few.time - many.time).abs() < 1e-9, "{} {}", few.time, many.time);
        assert_eq!(few.end, End::AtRest { held: (0..4).collect() });
        assert_eq!(many.end, End::AtRest { held: (0..8).collect() });
        for (a, b) in few.impacts.iter().zip(&many.impacts).take(10) {
            assert!(
                (a.time - b.time).abs() < FOLLOWED && (a.spin_after - b.spin_after).norm() < 1e-11,
                "{b:?}"
            );
        }
    }
}

/// On a slope steeper than its corners a body that does not slide rolls on for ever, on a gentler one it stops.
#[test]
fn a_cube_stops_on_a_gentle_slope_and_tumbles_down_a_steep_one() {
    let start = |world: &World| State::standing(world.body(), 1, Rotation::NONE, Vec3::ZERO);
    let on = |slope: f64| World::new(cube(), Vec3::new(G * sin(slope), 0.0, -G * cos(slope))).unwrap();
    let gentle = on(0.7);
    let (run, _) = walked(&gentle, &start(&gentle), &Options::default());
    assert_eq!(run.end, End::AtRest { held: (0..4).collect() });
    let steep = on(0.9);
    let options =
        Options { overturning: Some(Overturning::Tilt { axis: Vec3::Z, angle: 0.3 }), ..Options::default() };
    let (run, samples) = walked(&steep, &start(&steep), &options);
    assert_eq!((run.end, run.impacts.len()), (End::Overturned, 0));
    assert!(
        matches!(samples.pieces[0].mode, Mode::Edge { ends: [1, 2], .. }),
        "{:?}",
        samples.pieces[0].mode
    );
}

#[test]
fn where_the_law_leaves_several_ways_the_choice_is_obeyed() {
    let mut several = 0;
    for case in 0..400 {
        let (world, start) = bodies::drawn(case);
        let with = |choice: Choice| {
            let options = Options { choice, most_time: 2.0, most_impacts: 200, ..Options::default() };
            run(&world, &start, &options, &mut ()).unwrap()
        };
        let ended = with(Choice::End);
        let End::Several(clock) = ended.end else { continue };
        several += 1;
        let (most, fewest) = (with(Choice::KeepMost), with(Choice::KeepFewest));
        let next = ended.impacts.len();
        assert_eq!(most.impacts[..next], ended.impacts[..], "the same until then");
        if clock == Clock::Impact {
            let (most, fewest) = (&most.impacts[next], &fewest.impacts[next]);
            assert!(most.kept.len() >= fewest.kept.len() && most.kept != fewest.kept, "{most:?} {fewest:?}");
        }
    }
    assert!(several > 10, "the law leaves several ways now and then: {several}");
}

struct Stops(usize);

impl Observer for Stops {
    fn impact(&mut self, _: &Impact) -> ControlFlow<()> {
        self.0 -= 1;
        if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn budgets_and_observers_end_a_run() {
    let world = over(cube());
    let start = State::standing(world.body(), 0, Rotation::by(Vec3::X * 0.2), Vec3::ZERO);
    let ends = |options: Options| walked(&world, &start, &options).0;
    let default = Options::default();
    let time = ends(Options { most_time: 0.1, ..default });
    assert_eq!((time.end, time.time), (End::BudgetSpent(Budget::Time), 0.1));
    let impacts = ends(Options { most_impacts: 3, ..default });
    assert_eq!((impacts.end, impacts.impacts.len()), (End::BudgetSpent(Budget::Impacts), 3));
    let steps = ends(Options { most_steps: 4, ..default });
    assert_eq!((steps.end, steps.effort.steps), (End::BudgetSpent(Budget::Steps), 4));
    let stopped = run(&world, &start, &default, &mut Stops(2)).unwrap();
    assert_eq!((stopped.end, stopped.impacts.len()), (End::Stopped, 2));
}

#[test]
fn impossible_starts_are_named() {
    let world = over(cube());
    let begin = |state: &State, options: &Options| run(&world, state, options, &mut ()).unwrap_err();
    let flat = State::standing(world.body(), 0, Rotation::NONE, Vec3::ZERO);
    let (below, slides) = (State { centre: Vec3::Z * 0.4, ..flat }, State { velocity: Vec3::X, ..flat });
    let default = Options::default();
    assert!(
        matches!(begin(&below, &default), MotionError::Below { support: 0, depth } if (depth - 0.1).abs() < 1e-15)
    );
    assert!(matches!(begin(&slides, &default), MotionError::Slides { speed, .. } if speed == 1.0));
    let nowhere = State { centre: Vec3::Z * f64::NAN, ..flat };
    assert_eq!(begin(&nowhere, &default), MotionError::NotFinite { time: 0.0 });
    let options = Options { tolerance: 0.0, ..default };
    assert!(matches!(begin(&flat, &options), MotionError::Option { option: "tolerance", .. }));
    let crooked = Overturning::Tilt { axis: Vec3::Z * 2.0, angle: 1.0 };
    let options = Options { overturning: Some(crooked), ..default };
    assert!(matches!(begin(&flat, &options), MotionError::Option { option: "length of the axis", .. }));
}

#[test]
fn impossible_bodies_are_told_everything_that_is_wrong() {
    let twice = vec![Vec3::X, Vec3::X, Vec3::Y * f64::INFINITY];
    let problems = Body::new(-1.0, Mat3::IDENTITY, twice).unwrap_err();
    assert!(matches!(problems[0], BodyProblem::Mass(_)), "{problems:?}");
    assert!(problems.contains(&BodyProblem::NotFinite { support: 2 }), "{problems:?}");
    let alone = Body::new(1.0, Mat3::IDENTITY, vec![Vec3::ZERO]).unwrap_err();
    assert_eq!(alone, [BodyProblem::Central]);
    let one = Body::new(1.0, Mat3::IDENTITY, vec![Vec3::X, Vec3::X]).unwrap_err();
    assert_eq!(one, [BodyProblem::Together { first: 0, second: 1, distance: 0.0 }]);
    assert!(World::new(cube(), Vec3::ZERO).is_err(), "no gravity, no scale of time");
}
