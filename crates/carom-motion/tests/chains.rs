//! Parts and obstacles that are chains of arcs and segments, against closed forms.

use crate::walk;

use carom_impact::Law;
use carom_impact::planar::Slip;
use carom_motion::planar::trace::PieceEnd;
use carom_motion::planar::{
    Body, ChainPoint, Happening, MassProperties, Obstacle, Options, Pose, Recorder, Shape, State, Twist,
    Walker, World,
};
use carom_num::Vec2;
use carom_num::elementary::{atan2, cos, sin};
use carom_theory::bridged_hollow::RodInHollow;
use carom_theory::circular_chute::CircularChute;
use carom_theory::disc_on_disc::DiscOnDisc;
use carom_theory::eccentric_disc::EccentricDisc;
use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
use std::f64::consts::{FRAC_PI_2, PI};
use walk::followed;

const GRAVITY: f64 = 9.81;
/// What is asked of the engine beside a closed form [m, rad, m/s].
const AS_THEORY: f64 = 1e-10;
/// How well a body keeps touching what it rolls on [m].
const KEEPS_TOUCH: f64 = 1e-12;
/// Rounding of sums of a few terms of size 1.
const ROUNDING: f64 = 1e-13;

fn at(x: f64, y: f64) -> ChainPoint {
    ChainPoint::straight(Vec2::new(x, y))
}

fn bent(x: f64, y: f64, sweep: f64) -> ChainPoint {
    ChainPoint { at: Vec2::new(x, y), sweep }
}

fn disc(radius: f64) -> Body {
    let shape = Shape::new(vec![Vec2::ZERO], radius).unwrap();
    Body { shape, mass: 1.0, inertia: 0.5 * radius * radius }
}

fn resting(x: f64, y: f64) -> State {
    State { pose: Pose { centre: Vec2::new(x, y), angle: 0.0 }, twist: Twist::default() }
}

fn world(body: Body, obstacles: Vec<Obstacle>) -> World {
    World::of_one(Vec2::new(0.0, -GRAVITY), body, obstacles, Law::Poisson)
}

/// A block with a half circle that is open upwards, about the origin.
fn bowl(radius: f64, friction: f64) -> Obstacle {
    let far = 2.0 * radius;
    let block = [
        bent(radius, 0.0, -PI),
        at(-radius, 0.0),
        at(-far, 0.0),
        at(-far, -far),
        at(far, -far),
        at(far, 0.0),
    ];
    Obstacle::of_shape(Shape::of_chain(&block).unwrap(), friction, 0.0)
}

/// The walk up to a time.
fn walk(world: &World, start: State, until: f64) -> (State, carom_motion::planar::trace::Trace, Happening) {
    followed(world, start, vec![], until)
}

/// Angle of a place from straight below the origin, counter-clockwise.
fn from_below(place: Vec2) -> f64 {
    atan2(place.x, -place.y)
}

fn chute(own: f64, outer: f64) -> CircularChute {
    CircularChute { mass: 1.0, inertia: 0.5 * own * own, radius: own, chute_radius: outer, gravity: GRAVITY }
}

#[test]
fn a_disc_rolls_to_and_fro_in_a_circular_chute_like_a_pendulum() {
    let (outer, own, amplitude) = (0.5, 0.1, 0.6);
    let (theory, length) = (chute(own, outer), outer - own);
    for (friction, period) in
        [(0.9, theory.rolling_period(amplitude).unwrap()), (0.0, theory.smooth_period(amplitude).unwrap())]
    {
        let world = world(disc(own), vec![bowl(outer, friction)]);
        let start = resting(length * sin(amplitude), -length * cos(amplitude));
        for (part, expected) in [(0.5, -amplitude), (1.0, amplitude)] {
            let (end, trace, _) = walk(&world, start, part * period);
            let angle = from_below(end.pose.centre);
            assert!((angle - expected).abs() < AS_THEORY, "{angle} after {part} periods");
            assert!((end.pose.centre.norm() - length).abs() < KEEPS_TOUCH);
            assert_eq!(trace.impacts.len(), 0);
        }
    }
}

#[test]
fn a_walk_that_is_asked_to_ends_once_a_disc_has_rolled_or_slid_to_and_fro() {
    let (own, outer, amplitude) = (0.1, 0.5, 1.0);
    let theory = chute(own, outer);
    // What slides spins on: so slowly that its slip stops on the way, or so fast that it never does.
    for (friction, spin) in [(1.0, 0.0), (0.0, 0.0), (0.0, 3.0), (0.0, -80.0)] {
        let world = world(disc(own), vec![bowl(outer, friction)]);
        let mut start = resting((outer - own) * sin(amplitude), -(outer - own) * cos(amplitude));
        start.twist.spin = spin;
        let walker = Walker::new(&world, start, vec![], Options::default()).unwrap();
        let mut walker = walker.ending_at_swings();
        let mut recorder = Recorder::default();
        let end = loop {
            match walker.advance(&mut recorder).unwrap() {
                Happening::Moves => {}
                other => break other,
            }
        };
        assert_eq!(end, Happening::Swings, "nothing ends a swing without loss");
        assert_eq!(walker.advance(&mut ()).unwrap(), Happening::Swings, "it stays the end");
        let ended = recorder.into_trace().pieces.last().map(|piece| piece.ended_by);
        assert_eq!(ended, Some(PieceEnd::Swings), "the last piece says so");
        let periods = [theory.smooth_period(amplitude), theory.rolling_period(amplitude)];
        let period = periods[usize::from(friction > 0.0)].unwrap();
        let share = walker.time() / period;
        assert!(
            share > 0.9 && share < 1.5,
            "it has been at both ends: {share} periods, friction {friction}, spin {spin}"
        );
    }
}

#[test]
fn a_disc_slips_in_a_chute_from_the_amplitude_that_theory_names() {
    let (outer, own, friction) = (0.5, 0.1, 0.2);
    let (theory, length) = (chute(own, outer), outer - own);
    let largest = theory.largest_amplitude(friction);
    for (amplitude, slips) in [(largest - 1e-6, false), (largest + 1e-6, true)] {
        let world = world(disc(own), vec![bowl(outer, friction)]);
        let start = resting(length * sin(amplitude), -length * cos(amplitude));
        let (_, trace, _) = walk(&world, start, 1e-3);
        assert_eq!(trace.pieces[0].held[0].slip != Slip::Sticks, slips, "{amplitude} beside {largest}");
    }
    // Where it slides, friction against the slip all the way: the square of its rate is a closed form.
    let amplitude = largest + 0.4;
    let world = world(disc(own), vec![bowl(outer, friction)]);
    let (end, trace, _) = walk(&world, resting(length * sin(amplitude), -length * cos(amplitude)), 0.05);
    assert_eq!(trace.pieces.len(), 1);
    let (angle, rate) = (from_below(end.pose.centre), end.twist.velocity.norm() / length);
    // It slips down, along −t: the drag is negative.
    let squared = theory.sliding_rate_squared([amplitude, 0.0], angle, -friction);
    assert!((squared - rate * rate).abs() < AS_THEORY, "{squared} not {}", rate * rate);
}

#[test]
fn a_disc_leaves_the_disc_it_rolls_down_where_theory_says() {
    let (fixed, own) = (0.3, 0.1);
    let apart = fixed + own;
    let theory = DiscOnDisc { mass: 1.0, inertia: 0.005, radius: own, fixed_radius: fixed, gravity: GRAVITY };
    for friction in [0.0, 0.1, 0.5, 2.0] {
        let below = Obstacle::of_shape(Shape::new(vec![Vec2::ZERO], fixed).unwrap(), friction, 0.0);
        let world = world(disc(own), vec![below]);
        let first = 0.05;
        let start = resting(apart * sin(first), apart * cos(first));
        let mut walker = Walker::new(&world, start, vec![], Options::default()).unwrap();
        while walker.held().count() > 0 || walker.time() == 0.0 {
            walker.advance(&mut ()).unwrap();
        }
        let expected = theory.lift_off([first, 0.0], friction).unwrap();
        let (centre, speed) = (walker.state().pose.centre, walker.state().twist.velocity.norm());
        let angle = atan2(centre.x, centre.y);
        assert!((angle - expected.angle).abs() < AS_THEORY, "{friction}: {angle} not {}", expected.angle);
        assert!((speed - apart * expected.rate).abs() < AS_THEORY);
        assert!((centre.norm() - apart).abs() < KEEPS_TOUCH);
    }
}

#[test]
fn a_flat_part_rolls_over_a_rounded_edge_as_theory_says() {
    // A plate whose end is bent down: a segment, and half a turn about an edge of 20 mm.
    let (edge, half, thick): (f64, f64, f64) = (0.02, 0.1, 0.01);
    let inertia = (half * half + thick * thick) / 3.0;
    let theory = RoundEdge { mass: 1.0, inertia, half_thickness: thick, edge_radius: edge, gravity: GRAVITY };
    let plate = [at(-1.0, edge), bent(0.0, edge, -PI), at(0.0, -edge)];
    let plate = Obstacle::of_shape(Shape::of_open_chain(&plate).unwrap(), 0.9, 0.0);
    let corners =
        [(-half, -thick), (half, -thick), (half, thick), (-half, thick)].map(|(x, y)| Vec2::new(x, y));
    let body = Body { shape: Shape::new(corners.to_vec(), 0.0).unwrap(), mass: 1.0, inertia };
    let world = world(body, vec![plate]);
    // It is let go level, its centre beyond where the edge begins.
    let offset = theory.largest_returning_offset().unwrap() + 0.005;
    let (end, trace, _) = walk(&world, resting(offset, edge + thick), 0.12);
    assert!(trace.impacts.is_empty());
    assert_eq!(trace.pieces.len(), 1, "it neither slips nor leaves yet");
    let start = RoundEdgeState { offset, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    let tilt = end.pose.angle;
    assert!(tilt < -0.1, "{tilt}");
    let squared = theory.rolling_rate_squared(&start, tilt);
    assert!((end.twist.spin * end.twist.spin - squared).abs() < AS_THEORY * squared.max(1.0));
    let (n, t) = (Vec2::new(-sin(tilt), cos(tilt)), Vec2::new(cos(tilt), sin(tilt)));
    let place = n * (edge + thick) + t * theory.rolling_offset(&start, tilt);
    assert!((end.pose.centre - place).norm() < AS_THEORY, "{:?} not {place:?}", end.pose.centre);
    // Let go nearer, it rocks to and fro and stays.
    let (end, trace, _) = walk(&world, resting(offset - 0.01, edge + thick), 3.0);
    assert!(trace.impacts.is_empty() && end.pose.angle.abs() < 0.5, "{}", end.pose.angle);
}

#[test]
fn a_rod_swings_with_both_ends_in_a_round_hollow() {
    let (half, hollow) = (0.3, 0.5);
    let theory = RodInHollow::uniform(1.0, half, hollow, GRAVITY);
    let rod = Shape::new(vec![Vec2::new(-half, 0.0), Vec2::new(half, 0.0)], 0.0).unwrap();
    let body = Body { shape: rod, mass: 1.0, inertia: half * half / 3.0 };
    let world = world(body, vec![bowl(hollow, 0.0)]);
    let (amplitude, depth) = (0.4, theory.depth());
    let centre = Vec2::new(depth * sin(amplitude), -depth * cos(amplitude));
    let start = State { pose: Pose { centre, angle: amplitude }, twist: Twist::default() };
    let (end, trace, _) = walk(&world, start, 0.5 * theory.period(amplitude).unwrap());
    assert!((end.pose.angle + amplitude).abs() < AS_THEORY, "{}", end.pose.angle);
    assert_eq!((trace.impacts.len(), trace.pieces.len()), (0, 1));
    // With friction it rests up to a tilt, and slides from there on.
    let steepest = theory.resting_tilt(0.2).unwrap();
    let rough = World { obstacles: vec![bowl(hollow, 0.2)], ..world };
    for (tilt, rests) in [(steepest - 1e-6, true), (steepest + 1e-6, false)] {
        let centre = Vec2::new(depth * sin(tilt), -depth * cos(tilt));
        let start = State { pose: Pose { centre, angle: tilt }, twist: Twist::default() };
        let (_, _, end) = walk(&rough, start, 0.1);
        assert_eq!(end == Happening::Rests, rests, "{tilt} beside {steepest}");
    }
}

#[test]
fn a_disc_rolls_from_plate_to_arc_to_plate_without_loss() {
    // Down at 45°, a quarter of a circle to the left about the origin, and up at 45°.
    let (own, bend): (f64, f64) = (0.05, 0.4);
    let (c, up) = (0.5f64.sqrt() * bend, Vec2::new(0.5f64.sqrt(), 0.5f64.sqrt()));
    let chain = [at(-c - 1.0, 1.0 - c), bent(-c, -c, FRAC_PI_2), at(c, -c), at(c + 1.0, 1.0 - c)];
    let chute = Obstacle::of_shape(Shape::of_open_chain(&chain).unwrap(), 0.9, 0.5);
    let world = world(disc(own), vec![chute]);
    let start = resting(-c - 0.6 + own * up.x, 0.6 - c + own * up.y);
    let rest = walk(&world, start, 10.0).1;
    let energy = |s: &State| world.energy(&[*s]);
    for piece in &rest.pieces {
        assert!((energy(&piece.end) - energy(&start)).abs() < AS_THEORY, "{:?}", piece.ended_by);
    }
    assert_eq!(rest.impacts.len(), 0, "smooth joints");
    assert!(rest.pieces.len() > 6, "{} pieces", rest.pieces.len());
}

/// The area and second moment of a ring sector by closed form: outer and inner radius, half turn.
#[test]
fn a_half_ring_has_its_textbook_moments() {
    let (outer, inner): (f64, f64) = (2.0, 1.0);
    let chain = [bent(outer, 0.0, PI), at(-outer, 0.0), bent(-inner, 0.0, -PI), at(inner, 0.0)];
    let ring = MassProperties::of(&Shape::of_chain(&chain).unwrap());
    let area = 0.5 * PI * (outer.powi(2) - inner.powi(2));
    let height = 4.0 / (3.0 * PI) * (outer.powi(3) - inner.powi(3)) / (outer.powi(2) - inner.powi(2));
    let polar = 0.5 * (outer.powi(2) + inner.powi(2)) - height * height;
    assert!((ring.area - area).abs() < ROUNDING);
    assert!((ring.centroid - Vec2::new(0.0, height)).norm() < ROUNDING);
    assert!((ring.gyration_squared - polar).abs() < ROUNDING);
}

/// Speed² with which a disc leaves a quarter circle and the floor behind it that it slides down without friction.
fn leaves_quarter_with(chain: &[ChainPoint], own: f64, start: Vec2) -> f64 {
    let chute = Obstacle::of_shape(Shape::of_open_chain(chain).unwrap(), 0.0, 0.0);
    let (end, _, happening) = walk(&world(disc(own), vec![chute]), resting(start.x, start.y), 0.7);
    assert_eq!(happening, Happening::BudgetSpent, "it is still on the floor");
    end.twist.velocity.dot(end.twist.velocity)
}

#[test]
fn chutes_of_many_plates_converge_to_the_arc_that_they_are_drawn_around() {
    let (outer, own, first): (f64, f64, f64) = (0.5, 0.01, 80f64.to_radians());
    let away = |distance: f64| Vec2::new(-distance * sin(first), -distance * cos(first));
    let end = at(2.0, -outer);
    let arc = [bent(-outer, 0.0, FRAC_PI_2), at(0.0, -outer), end];
    let smooth = leaves_quarter_with(&arc, own, away(outer - own));
    let fall = (outer - own) * (1.0 - cos(first));
    assert!((smooth - 2.0 * GRAVITY * fall).abs() < AS_THEORY, "{smooth}");
    // Each of n kinks of π/2n takes sin² of it from the energy: all of them a part that falls like 1/n.
    let lost = |n: u32| {
        let each = FRAC_PI_2 / f64::from(n);
        let corner = |i: u32| at(-outer * cos(each * f64::from(i)), -outer * sin(each * f64::from(i)));
        let chain: Vec<_> = (0..=n).map(corner).chain([end]).collect();
        let lowest = outer * cos(0.5 * each) - own;
        1.0 - leaves_quarter_with(&chain, own, away(lowest)) / smooth
    };
    let lost = [16, 32, 64].map(lost);
    let theory = |n: f64| FRAC_PI_2 * FRAC_PI_2 / n;
    assert!(lost[0] < theory(16.0) && lost[0] > 0.0, "{lost:?}");
    for ratio in [lost[0] / lost[1], lost[1] / lost[2]] {
        assert!((ratio - 2.0).abs() < 0.3, "{ratio} of {lost:?}");
    }
}

/// A corner of a box that stands on the slope before a bend, a little within the bend, reaches into it as the chord of the bend does.
#[test]
fn what_reaches_into_a_bent_plate_is_measured() {
    let (bend, beyond) = (0.06, 0.25e-3);
    // Level up to the origin, then up by a quarter circle.
    let plate = Shape::of_open_chain(&[at(-1.0, 0.0), bent(0.0, 0.0, FRAC_PI_2), at(bend, bend)]).unwrap();
    let half = Vec2::new(0.015, 0.002);
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let shape = Shape::new(corners.map(|(x, y)| Vec2::new(x * half.x, y * half.y)).to_vec(), 0.0).unwrap();
    let body = Body { shape, mass: 1.0, inertia: 1e-4 };
    let world = world(body, vec![Obstacle::of_shape(plate, 0.3, 0.0)]);
    let deep = |x: f64| world.overlap(0, &resting(x - half.x, half.y), 0);
    // The arc enters through the lower side and leaves through the front, at this height.
    let height = bend - (bend * bend - beyond * beyond).sqrt();
    assert!(deep(beyond) > 0.2 * height && deep(beyond) <= height, "{} of {height}", deep(beyond));
    assert!(deep(0.0).abs() < ROUNDING, "it lies before the bend: {}", deep(0.0));
    assert!(deep(-0.1).abs() < ROUNDING, "and anywhere before: {}", deep(-0.1));
    let flies = world.overlap(0, &resting(-0.5, 0.01), 0);
    assert!((flies + 0.008).abs() < ROUNDING, "it is 8 mm above: {flies}");
}

#[test]
fn a_cam_rolls_as_its_energy_says_until_friction_no_longer_holds_it() {
    let (radius, e, mass, inertia, friction) = (0.2, 0.12, 1.2, 0.02, 0.9);
    let theory = EccentricDisc { mass, inertia, radius, eccentricity: e, gravity: GRAVITY };
    let shape = Shape::new(vec![Vec2::new(0.0, e)], radius).unwrap();
    let floor = Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), friction, 0.0);
    let world = world(Body { shape, mass, inertia }, vec![floor]);
    for (spin, too_fast) in [(4.0, false), (30.0, true)] {
        // It rolls to the left, its mass centre at the lowest place.
        let mut start = resting(0.0, radius - e);
        start.twist = Twist { velocity: Vec2::new(-spin * (radius - e), 0.0), spin };
        let (_, trace, _) = walk(&world, start, 0.7);
        let (end, ended_by) = (trace.pieces[0].end, trace.pieces[0].ended_by);
        let (angle, found) = (end.pose.angle, end.twist.spin);
        let place = Vec2::new(-radius * angle + e * sin(angle), radius - e * cos(angle));
        assert!((end.pose.centre - place).norm() < AS_THEORY, "it rolls: {:?}, {place:?}", end.pose.centre);
        let expected = theory.spin(angle, (0.0, spin)).unwrap().unwrap();
        assert!((found.abs() - expected).abs() < AS_THEORY * spin, "{found} at {angle}, not {expected}");
        assert_eq!(matches!(ended_by, PieceEnd::StickLimit(_)), too_fast, "{ended_by:?}");
        if too_fast {
            let [normal, tangential] = theory.forces(angle, found).unwrap();
            let room = (friction * normal - tangential.abs()) / (mass * GRAVITY);
            assert!(room.abs() < AS_THEORY, "as much as friction holds: {room} of the weight are left");
        }
    }
}
