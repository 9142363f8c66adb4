//! Round pins and rounded plates, against closed forms.

use crate::bodies::ran;
use carom_motion::spatial::{
    Body, End, Feature, Friction, Mode, Obstacle, Options, PieceEnd, Plane, State, Touch, World, run,
};
use carom_num::elementary::{cos, sin};
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::spatial::{BlockOnCylinder, RoundOverEdge};

const G: f64 = 9.81;

fn among(body: Body, friction: f64, obstacles: Vec<Obstacle>) -> World {
    let world = World::new(body, Vec3::Z * -G).unwrap().with_friction(Friction::new(friction)).unwrap();
    world.among(obstacles).unwrap()
}

/// A uniform box, its edges rounded by a radius within its faces.
fn block([a, b, c]: [f64; 3], rounding: f64) -> Body {
    let moment = |p: f64, q: f64| (p * p + q * q) / 3.0;
    let half = |i: u32, bit: u32, half: f64| {
        let within = half - rounding;
        if i >> bit & 1 == 1 { within } else { -within }
    };
    let corner = |i: u32| Feature::point(Vec3::new(half(i, 0, a), half(i, 1, b), half(i, 2, c)));
    let corners = (0..8).map(|i| corner(i).rounded(rounding)).collect();
    Body::of(1.0, Mat3::diagonal(moment(b, c), moment(a, c), moment(a, b)), corners).unwrap()
}

/// A block on a pin along y whose axis is the y axis, tipped by an angle so that it goes down where x is positive.
fn tipped(theory: &BlockOnCylinder, angle: f64) -> State {
    let [aside, above] = theory.centre(angle).unwrap();
    State {
        centre: Vec3::new(aside, 0.0, above),
        attitude: Rotation::by(Vec3::Y * angle),
        velocity: Vec3::ZERO,
        spin: Vec3::ZERO,
    }
}

#[test]
fn a_block_rocks_on_a_pin_as_its_theory_says() {
    let half = [0.25, 0.1, 0.04];
    let radius = 0.1;
    let gyration = ((half[0] * half[0] + half[2] * half[2]) / 3.0_f64).sqrt();
    let theory = BlockOnCylinder { radius, height: half[2], gyration, gravity: G };
    // The pin reaches out on both sides of the block, on none, on one: edges cross it, or its ends are below the face.
    for (ends, rounding) in
        [([-0.3, 0.2], 0.0), ([-0.06, 0.08], 0.0), ([-0.05, 0.3], 0.0), ([-0.3, 0.2], 0.01)]
    {
        let pin = Obstacle::pin(ends.map(|y| Vec3::Y * y), radius).unwrap();
        let world = among(block(half, rounding), 5.0, vec![pin]);
        let angle = 0.3;
        let quarter = theory.quarter(angle).unwrap();
        let (end, samples) = ran(&world, &tipped(&theory, angle), quarter);
        assert!(end.impacts.is_empty() && samples.pieces.len() == 1, "{ends:?}: {:?}", samples.pieces);
        let level = end.state.attitude.apply(Vec3::X);
        assert!(level.z.abs() < 1e-9, "{ends:?}: {level:?} after a quarter of its period");
        assert!(end.state.centre.x.abs() < 1e-9, "{ends:?}: {:?}", end.state.centre);
        let rate = theory.square([angle, 0.0], 0.0).unwrap().sqrt();
        assert!((end.state.spin + Vec3::Y * rate).norm() < 1e-9, "{ends:?}: {:?} {rate}", end.state.spin);
    }
}

#[test]
fn a_block_slips_on_a_pin_where_its_theory_says() {
    let (half, radius, friction) = ([0.25, 0.1, 0.04], 0.1, 0.2);
    let gyration = ((half[0] * half[0] + half[2] * half[2]) / 3.0_f64).sqrt();
    let theory = BlockOnCylinder { radius, height: half[2], gyration, gravity: G };
    let pin = Obstacle::pin([Vec3::Y * -0.3, Vec3::Y * 0.3], radius).unwrap();
    let world = among(block(half, 0.0), friction, vec![pin]);
    // Level, and turning so fast that it tips until friction gives way.
    let rate = 2.5;
    let start = State { spin: Vec3::Y * rate, velocity: Vec3::X * (rate * half[2]), ..tipped(&theory, 0.0) };
    let (_, samples) = ran(&world, &start, 0.5);
    let first = samples.pieces.first().unwrap();
    let both = |mode: &Mode| matches!(mode, Mode::Slides { slipping, .. } if slipping.is_empty());
    assert!(both(&first.mode), "{:?}", samples.pieces);
    let lies = first.end.attitude.apply(Vec3::X);
    let angle = carom_num::elementary::atan2(-lies.z, lies.x);
    let [_, along, out] = theory.forces([0.0, rate], angle).unwrap();
    assert!((along.abs() - friction * out).abs() < 1e-9, "{along} {out} at {angle}");
    let square = theory.square([0.0, rate], angle).unwrap();
    assert!((first.end.spin.y - square.sqrt()).abs() < 1e-9, "{:?} {square}", first.end.spin);
}

#[test]
fn a_ball_rolls_off_a_ball_and_off_a_pin() {
    let (own, other) = (0.05, 0.12);
    let theory = RoundOverEdge { radius: own + other, share: 0.4, gravity: G };
    let moment = 0.4 * own * own;
    let ball = || {
        let features = vec![Feature::point(Vec3::ZERO).rounded(own)];
        Body::of(1.0, Mat3::diagonal(moment, moment, moment), features).unwrap()
    };
    for ends in [[Vec3::ZERO; 2], [Vec3::Y * -0.4, Vec3::Y * 0.3]] {
        let world = among(ball(), 20.0, vec![Obstacle::pin(ends, other).unwrap()]);
        let angle = 0.1;
        let start = State {
            centre: Vec3::new(sin(angle), 0.0, cos(angle)) * (own + other),
            attitude: Rotation::NONE,
            velocity: Vec3::ZERO,
            spin: Vec3::ZERO,
        };
        let (end, samples) = ran(&world, &start, 1.0);
        assert!(matches!(end.end, End::FliesAway), "{:?}", end.end);
        // Near where it leaves it slips: what it pushes with goes to zero.
        let rolls = samples.pieces[0];
        let (at, turns) = (rolls.end.centre, rolls.end.spin.y);
        let there = carom_num::elementary::atan2(at.x, at.z);
        let square = theory.square([angle, 0.0], there).unwrap();
        let spin = square.sqrt() * (own + other) / own;
        assert!((turns - spin).abs() < 1e-9, "{ends:?}: {turns} {spin}");
        let [along, out] = theory.forces([angle, 0.0], there).unwrap();
        assert!((along - 20.0 * out).abs() < 1e-9, "{ends:?}: {along} {out}");
    }
}

/// Sharp on rounded and rounded on sharp are one: the radii add up.
#[test]
fn a_ball_on_a_rounded_plate_goes_as_a_larger_one_on_a_thin_plate() {
    let corner = |x: f64, y: f64| Vec3::new(x, y, 0.0);
    let plate = || {
        Obstacle::plate(&[corner(-2.0, -0.3), corner(0.0, -0.3), corner(0.0, 0.3), corner(-2.0, 0.3)])
            .unwrap()
    };
    let ball = |radius: f64| {
        let moment = 1e-3;
        let features = vec![Feature::point(Vec3::ZERO).rounded(radius)];
        Body::of(1.0, Mat3::diagonal(moment, moment, moment), features).unwrap()
    };
    let start = State {
        centre: Vec3::new(-0.02, 0.25, 0.3),
        attitude: Rotation::NONE,
        velocity: Vec3::new(0.3, 0.1, 0.0),
        spin: Vec3::new(1.0, -2.0, 3.0),
    };
    // Without friction no arm matters, but that of the middle.
    let ends = [(0.1, 0.0), (0.06, 0.04)].map(|(own, other)| {
        let plate = if other > 0.0 { plate().rounded(other).unwrap() } else { plate() };
        let floor = Plane::new(Vec3::Z, -1.0 + other).unwrap();
        let world = World::new(ball(own), Vec3::Z * -G).unwrap();
        let friction = Friction::new(0.0).with_restitution(0.5);
        let world = world.with_friction(friction).unwrap().among(vec![plate, floor.into()]).unwrap();
        let options = Options { most_time: 1.2, ..Options::default() };
        run(&world, &start, &options, &mut ()).unwrap()
    });
    let [thin, thick] = &ends;
    let strikes = ends.each_ref().map(|run| run.impacts.len());
    assert!(strikes[0] >= 3 && strikes[0] == strikes[1], "{strikes:?}");
    for (a, b) in thin.impacts.iter().zip(&thick.impacts) {
        assert!((a.time - b.time).abs() < 1e-11, "{} {}", a.time, b.time);
    }
    assert!((thin.state.centre - thick.state.centre).norm() < 1e-10);
}

#[test]
fn a_thrown_block_comes_to_rest_on_a_rounded_plate_and_in_nothing() {
    let corner = |x: f64, y: f64| Vec3::new(x, y, 0.0);
    let plate =
        Obstacle::plate(&[corner(-0.3, -0.2), corner(0.3, -0.2), corner(0.3, 0.2), corner(-0.3, 0.2)]);
    let pin = Obstacle::pin([Vec3::new(0.1, 0.0, 0.0), Vec3::new(0.1, 0.02, 0.12)], 0.02).unwrap();
    let obstacles =
        vec![plate.unwrap().rounded(0.01).unwrap(), pin, Plane::new(Vec3::Z, -0.3).unwrap().into()];
    let (mut rests, mut strikes) = (0, 0);
    for k in 0..12_u32 {
        let world =
            among(block([0.04, 0.03, 0.02], if k % 3 == 0 { 0.004 } else { 0.0 }), 0.3, obstacles.clone());
        let turn = Vec3::new(f64::from(k), 0.7 * f64::from(k % 5), 0.3);
        let start = State {
            centre: Vec3::new(0.012 * f64::from(k), 0.01 * f64::from(k % 4), 0.25),
            attitude: Rotation::by(turn),
            velocity: Vec3::new(0.2, -0.1, 0.0),
            spin: turn * 3.0,
        };
        let run = run(&world, &start, &Options { most_time: 5.0, ..Options::default() }, &mut ()).unwrap();
        let deep = world.reaches_into(&run.state, 1e-9);
        assert!(deep.is_empty(), "{k}: {deep:?}");
        assert!(run.drift < 1e-8, "{k}: {:e}", run.drift);
        rests += u32::from(matches!(run.end, End::AtRest { .. }));
        strikes += run.impacts.len();
    }
    assert!(rests >= 10 && strikes > 40, "{rests} {strikes}");
}

/// A block on its edge on top of a ball, or of a bar's end, falls back onto its face: there the ball's middle is farther from the block than its own corners are.
#[test]
fn a_block_that_falls_from_its_edge_onto_its_face_stays_on_the_ball() {
    let (half, radius) = ([0.04, 0.03, 0.02], 0.05);
    let bars = [[Vec3::ZERO; 2], [Vec3::ZERO, Vec3::new(0.0, 0.3, -0.1)]];
    for (ends, k) in bars.into_iter().flat_map(|ends| (0..12_u32).map(move |k| (ends, k))) {
        let world = among(block(half, 0.0), 2.0, vec![Obstacle::pin(ends, radius).unwrap()]);
        let (top, attitude) = (Vec3::Z * radius, Rotation::by(Vec3::Y * (0.1 + 0.013 * f64::from(k))));
        let spin = Vec3::Y * -1.0;
        let arm = attitude.apply(Vec3::new(half[0], 0.001 * f64::from(k), -half[2]));
        let start = State { centre: top - arm, attitude, velocity: spin.cross(-arm), spin };
        let (_, samples) = ran(&world, &start, 0.12);
        let [edge, face] = [samples.pieces[0], samples.pieces[1]];
        assert!(matches!(edge.ended_by, PieceEnd::RunsOff { .. }), "{edge:?}");
        let on = face.mode.held(&world).iter().map(|support| world.touch(support)).collect::<Vec<_>>();
        assert!(matches!(on[..], [Some(Touch::Face { corner: 0, .. })]), "{on:?}");
        for (time, _, state) in &samples.instants {
            let deep = world.reaches_into(state, 1e-9);
            assert!(deep.is_empty(), "at {time} s: {deep:?}");
        }
    }
}
