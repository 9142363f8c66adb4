//! A body among several planes: closed forms, and worlds that are turned.

use crate::bodies;

use carom_motion::spatial::{
    Body, Budget, End, Friction, Mode, Options, Plane, Run, Samples, State, Supports, World, run,
};
use carom_num::elementary::{atan2, cos, sin};
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::spatial::{Groove, Ladder};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

const G: f64 = 9.81;

fn among(body: Body, gravity: Vec3, friction: f64, planes: Vec<Plane>) -> World {
    let world = World::new(body, gravity).unwrap().with_friction(Friction::new(friction)).unwrap();
    world.among(planes).unwrap()
}

/// A world as somebody sees it who has turned, and stands elsewhere.
fn seen(world: &World, start: &State, turn: Rotation, from: Vec3) -> (World, State) {
    let plane = |plane: &Plane| {
        let normal = turn.apply(plane.normal());
        Plane::new(normal, normal.dot(from) - plane.height(Vec3::ZERO)).unwrap()
    };
    let planes = world.planes().iter().map(plane).collect();
    let friction = world.friction().unwrap().clone();
    let image = World::new(world.body().clone(), turn.apply(world.gravity())).unwrap();
    let image = image.with_friction(friction).unwrap().among(planes).unwrap();
    let state = State {
        centre: turn.apply(start.centre) + from,
        attitude: turn.after(start.attitude),
        velocity: turn.apply(start.velocity),
        spin: start.spin,
    };
    (image, state)
}

/// How far the end of a run is from that of the same run seen from elsewhere: places in units of the reach, velocities in those of its fall.
fn apart(world: &World, run: &Run, image: &Run, turn: Rotation, from: Vec3) -> f64 {
    let scales = world.scales();
    let (a, b) = (run.state, image.state);
    let place = (turn.apply(a.centre) + from - b.centre).norm() / scales.length;
    let moves = (turn.apply(a.velocity) - b.velocity).norm() / scales.speed;
    let spins = (a.spin - b.spin).norm() * scales.time;
    place.max(moves).max(spins)
}

#[test]
fn a_floor_that_is_turned_and_moved_is_the_same_floor() {
    let mut rng = Pcg64::seed_from_u64(3);
    let (mut strikes, mut worst) = (0, 0.0_f64);
    for case in 0..100 {
        let (world, start) = bodies::drawn(case);
        let friction = Friction::new(rng.random_range(0.0..1.0)).with_restitution(0.4);
        let world = world.with_friction(friction).unwrap();
        let mut one = || rng.random_range(-2.0..2.0);
        let (turn, from) = (Rotation::by(Vec3::new(one(), one(), one())), Vec3::new(one(), one(), one()));
        let options = Options { most_impacts: 6, most_time: 1.0, ..Options::default() };
        let own = run(&world, &start, &options, &mut ()).unwrap();
        let (image, state) = seen(&world, &start, turn, from);
        let other = run(&image, &state, &options, &mut ()).unwrap();
        assert_eq!((own.end, own.impacts.len()), (other.end, other.impacts.len()), "case {case}");
        let far = apart(&world, &own, &other, turn, from);
        assert!(far < 1e-9, "case {case}: {far:e} after {} impacts, {:?}", own.impacts.len(), own.end);
        (strikes, worst) = (strikes + own.impacts.len(), worst.max(far));
    }
    assert!(strikes > 200, "{strikes}");
}

#[test]
fn a_ladder_leaves_the_wall_at_two_thirds_of_its_height() {
    let (mass, length) = (2.0, 1.5);
    let across = mass * length * length / 12.0;
    let half = Vec3::X * (0.5 * length);
    let body = Body::new(mass, Mat3::diagonal(1e-3, across, across), vec![-half, half]).unwrap();
    let walls = vec![Plane::FLOOR, Plane::new(-Vec3::X, 0.0).unwrap()];
    let world = among(body, Vec3::Z * -G, 0.0, walls);
    let first: f64 = 1.1;
    // The upper end is at the wall x = 0; the lower one on the floor.
    let centre = Vec3::new(-0.5 * length * cos(first), 0.0, 0.5 * length * sin(first));
    let attitude = Rotation::by(Vec3::Y * -first);
    let start = State { centre, attitude, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    let mut samples = Samples::default();
    let options = Options { most_impacts: 1, ..Options::default() };
    let end = run(&world, &start, &options, &mut samples).unwrap();
    let slid = samples.pieces[0];
    let leaves = Ladder { length, start: first, gravity: G }.leaves_the_wall().unwrap();
    let sine = slid.end.centre.z / (0.5 * length);
    assert!((sine - leaves.sine).abs() < 1e-10, "it leaves the wall at {sine}, not {}", leaves.sine);
    assert!((slid.end.spin.norm() - leaves.spin).abs() < 1e-9, "{} {leaves:?}", slid.end.spin.norm());
    let after = -samples.pieces[1].end.velocity.x;
    assert!((after - leaves.speed).abs() < 1e-9, "{after} {leaves:?}");
    assert!(end.drift < 1e-12 && end.impacts.len() == 1, "{end:?}");
}

/// Two flanks that rise by `flank` from the groove's bottom, which descends along x by `slope`: in axes of the groove.
fn groove(flank: f64, slope: f64) -> (Vec<Plane>, Vec3) {
    let side = |sign: f64| Plane::new(Vec3::new(0.0, sign * sin(flank), cos(flank)), 0.0).unwrap();
    (vec![side(1.0), side(-1.0)], Vec3::new(G * sin(slope), 0.0, -G * cos(slope)))
}

/// A bar with the cross-section of a square, an edge of which looks down, that lies in a groove of two flanks on four points.
fn bar(flank: f64) -> (Body, State) {
    let corner = |x: f64, side: f64| Vec3::new(0.4 * x, -0.1 * side * cos(flank), -0.3 + 0.1 * sin(flank));
    let corners = [(-1.0, 1.0), (1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, side)| corner(x, side));
    let body = Body::new(1.3, Mat3::diagonal(0.02, 0.09, 0.08), corners.to_vec()).unwrap();
    let centre = Vec3::Z * 0.3;
    (body, State { centre, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO })
}

#[test]
fn a_bar_slides_down_a_groove_by_the_angle_of_its_flanks() {
    for (flank, slope, friction) in [(0.7_f64, 0.5_f64, 0.2_f64), (0.3, 0.4, 0.1), (1.0, 0.9, 0.3)] {
        let (planes, gravity) = groove(flank, slope);
        let (body, start) = bar(flank);
        let world = among(body, gravity, friction, planes);
        let options = Options { most_time: 0.3, ..Options::default() };
        let end = run(&world, &start, &options, &mut ()).unwrap();
        let braking = Groove { flank, friction }.braking().unwrap();
        let acceleration = G * (sin(slope) - braking * cos(slope));
        let (way, speed) = (0.5 * acceleration * 0.09, acceleration * 0.3);
        assert!(acceleration > 0.0 && (end.state.centre.x - way).abs() < 1e-12, "{end:?} {way}");
        assert!((end.state.velocity - Vec3::X * speed).norm() < 1e-12, "{end:?} {speed}");
        assert!(end.state.spin.norm() < 1e-12, "{end:?}");
        let taken = -braking * 1.3 * G * cos(slope) * way;
        assert!((end.friction_work - taken).abs() < 1e-11, "{} {taken}", end.friction_work);
    }
}

/// What the law says of a bar in a groove that is let go.
fn let_go(flank: f64, slope: f64, friction: f64) -> End {
    let (planes, gravity) = groove(flank, slope);
    let (body, start) = bar(flank);
    let world = among(body, gravity, friction, planes);
    let options = Options { most_time: 0.05, ..Options::default() };
    run(&world, &start, &options, &mut ()).unwrap().end
}

/// Up to the slope of the braking it rests; from there on it could slide too, and rests on up to the most that friction across the groove lets it hold.
#[test]
fn a_bar_rests_in_a_groove_as_far_as_friction_across_it_can_press() {
    let all: Supports = (0..2).chain(6..8).collect();
    let (rests, slides) = (End::AtRest { held: all }, End::BudgetSpent(Budget::Time));
    let off = 1e-6;
    for (flank, friction) in [(0.7_f64, 0.25_f64), (0.4, 0.6), (1.0, 0.3)] {
        let groove = Groove { flank, friction };
        let (braking, holding) = (groove.braking().unwrap(), groove.holding().unwrap());
        let keeps = |tangent: f64| let_go(flank, atan2(tangent, 1.0), friction);
        assert_eq!([braking - off, braking + off, holding - off].map(keeps), [rests; 3], "{groove:?}");
        assert_eq!(keeps(holding + off), slides, "{groove:?}");
    }
    // Beyond the wedging angle it hangs in a groove that falls almost straight down.
    let wedged = Groove { flank: 1.2, friction: 0.5 };
    assert_eq!(wedged.holding().unwrap(), f64::INFINITY);
    assert_eq!(let_go(1.2, 1.55, 0.5), rests);
}

#[test]
fn a_bar_that_falls_into_a_groove_comes_to_rest_on_both_flanks() {
    let flank: f64 = 0.6;
    let (planes, gravity) = groove(flank, 0.1);
    let (body, start) = bar(flank);
    let world = among(body, gravity, 0.4, planes);
    for (case, turn) in
        [Vec3::ZERO, Vec3::new(0.2, 0.0, 0.0), Vec3::new(0.1, -0.15, 0.2)].into_iter().enumerate()
    {
        let thrown = State { centre: start.centre + Vec3::Z * 0.2, attitude: Rotation::by(turn), ..start };
        let end = run(&world, &thrown, &Options::default(), &mut ()).unwrap();
        assert!(
            matches!(end.end, End::AtRest { held } if held.len() >= 3),
            "{case}: {:?} {:?}",
            end.end,
            end.impacts.len()
        );
        assert!(end.drift < 1e-11 && end.friction_work <= 0.0, "{case}: {:e}", end.drift);
    }
}

/// The supports of two floors in one place share what those of one would carry, whatever they do.
#[test]
fn a_floor_that_is_given_twice_is_one_floor() {
    let (mut strikes, mut slides) = (0, 0);
    for case in 0..150 {
        let (world, start) = bodies::drawn(case);
        let mut rng = Pcg64::seed_from_u64(case);
        let restitution = if case % 2 == 0 { 0.0 } else { 0.4 };
        let friction = Friction::new(rng.random_range(0.0..1.0)).with_restitution(restitution);
        let world = world.with_friction(friction).unwrap();
        let options = Options { most_impacts: 6, most_time: 1.0, ..Options::default() };
        let mut samples = Samples::default();
        let own = run(&world, &start, &options, &mut samples).unwrap();
        let twice = world.clone().among(vec![Plane::FLOOR; 2]).unwrap();
        let other = run(&twice, &start, &options, &mut ()).unwrap();
        let far = apart(&world, &own, &other, Rotation::NONE, Vec3::ZERO);
        assert!(far < 1e-9, "case {case}: {far:e}, {:?} {:?}", own.end, other.end);
        slides += samples.pieces.iter().filter(|p| matches!(p.mode, Mode::Slides { .. })).count();
        strikes += own.impacts.len();
    }
    assert!(strikes > 300 && slides > 100, "{strikes} {slides}");
}

/// A cube flies and turns along a wall that it touches with a face: what touches on without being pressed is seen at once, not looked for in ten million places of a step.
#[test]
fn what_goes_along_a_wall_takes_no_search() {
    let sign = |k: u32, bit: u32| if k >> bit & 1 == 1 { 0.6 } else { -0.6 };
    let corners = (0..8).map(|k| Vec3::new(sign(k, 0), sign(k, 1), sign(k, 2))).collect();
    let body = Body::new(1.0, Mat3::diagonal(0.5, 0.5, 0.5), corners).unwrap();
    let walls = [Vec3::X, Vec3::Y, Vec3::Z].map(|normal| Plane::new(normal, 0.0).unwrap()).to_vec();
    let world = among(body, Vec3::Z * -G, 0.3, walls);
    let high = 0.6 * std::f64::consts::SQRT_2;
    let start = State {
        centre: Vec3::new(high, 0.6, high),
        attitude: Rotation::by(Vec3::Y * (-0.75 * std::f64::consts::PI)),
        velocity: Vec3::X * 4.9585589,
        spin: Vec3::Y * 3.99643,
    };
    let options = Options { most_time: 0.3, ..Options::default() };
    let out = run(&world, &start, &options, &mut ()).unwrap();
    assert!(out.effort.steps > 2 && out.effort.event_evaluations < 20_000, "{:?}", out.effort);
    assert!((out.state.centre.y - 0.6).abs() < 1e-12, "{:?}", out.state);
}
