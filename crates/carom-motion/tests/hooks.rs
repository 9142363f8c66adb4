//! Inner corners against closed forms: an L that an edge has entered, and a disc that spins in a corner of a chute.

use crate::on_edge;
use crate::walk;

use carom_impact::Law;
use carom_impact::planar::Slip;
use carom_motion::planar::trace::{Impact, Piece, PieceEnd, Sample, Trace};
use carom_motion::planar::{
    Body, ChainPoint, Feature, Happening, MassProperties, Obstacle, Pose, Shape, State, Twist, World,
};
use carom_num::Vec2;
use carom_num::elementary::{cos, sin};
use carom_theory::hooked_part::HookedPart;
use carom_theory::incline::{Arrival, Incline};
use on_edge::{follow, pose};
use walk::followed;

const GRAVITY: f64 = 9.81;
const MASS: f64 = 0.3;
/// Of both legs [m].
const THICK: f64 = 0.008;
/// What is asked of the engine beside a closed form [m, rad, m/s, s, N, N s].
const AS_THEORY: f64 = 1e-10;
/// The same of spins, which are some 12 rad/s where angles are some 1 rad [rad/s].
const SPIN_AS_THEORY: f64 = 1e-9;
/// A face that carries a billionth of the weight carries nothing to the engine: by so much earlier it lets go [rad].
const LETS_GO: f64 = 1e-9;
/// Rounding of moments of an area of size 1e-3.
const ROUNDING: f64 = 1e-15;
/// How near to a border an L is let go [rad].
const BESIDE: f64 = 1e-6;

/// The L of [`HookedPart::of_l`], drawn as there, with its moments from its outline.
fn l([p, q]: [f64; 2]) -> Body {
    let w = THICK;
    let corners = [(0.0, -q), (w, -q), (w, w), (-p, w), (-p, 0.0), (0.0, 0.0)];
    let chain = |to: Vec2| corners.map(|(x, y)| ChainPoint::straight(Vec2::new(x, y) - to));
    let drawn = MassProperties::of(&Shape::of_chain(&chain(Vec2::ZERO)).unwrap());
    let shape = Shape::of_chain(&chain(drawn.centroid)).unwrap();
    Body { shape, mass: MASS, inertia: MASS * drawn.gyration_squared }
}

fn theory(legs: [f64; 2]) -> HookedPart {
    HookedPart::of_l(MASS, legs, THICK, GRAVITY)
}

/// The L with its corner on the edge at the origin, at a tilt and a rate.
fn hanging(part: &HookedPart, [tilt, rate]: [f64; 2]) -> State {
    let across = Vec2::new(cos(tilt), sin(tilt));
    State {
        pose: Pose { centre: across.turned_right() * part.arm, angle: tilt + part.normals[0] },
        twist: Twist { velocity: across * (part.arm * rate), spin: rate },
    }
}

/// Tilt and rate of a state in which the corner is on the edge.
fn swing(part: &HookedPart, state: &State) -> [f64; 2] {
    [state.pose.angle - part.normals[0], state.twist.spin]
}

fn same(ours: &State, expected: &State, what: &str) {
    let apart = [
        (ours.pose.centre - expected.pose.centre).norm(),
        ours.pose.angle - expected.pose.angle,
        (ours.twist.velocity - expected.twist.velocity).norm(),
    ];
    let spin = ours.twist.spin - expected.twist.spin;
    assert!(apart.iter().all(|d| d.abs() < AS_THEORY), "{what}: {ours:?} not {expected:?}");
    assert!(spin.abs() < SPIN_AS_THEORY, "{what}: {ours:?} not {expected:?}");
}

/// A thin plate that runs from the edge at the origin at an angle, counter-clockwise from straight down.
fn plate(angle: f64, friction: f64) -> Obstacle {
    Obstacle::new(Vec2::new(sin(angle), -cos(angle)), Vec2::ZERO, friction, 0.0)
}

fn world(legs: [f64; 2], obstacle: Obstacle) -> World {
    World::of_one(Vec2::new(0.0, -GRAVITY), l(legs), vec![obstacle], Law::Poisson)
}

fn walk(world: &World, start: State, until: f64) -> (State, Trace, Happening) {
    followed(world, start, vec![], until)
}

/// The inner faces' normal forces, and the force of the edge along u and e.
fn forces(sample: &Sample) -> ([f64; 2], [f64; 2]) {
    let (mut faces, mut sum) = ([0.0; 2], Vec2::ZERO);
    for c in &sample.contacts {
        // The face before the corner is the left one.
        let Feature::FaceOnEnd { face, .. } = c.feature else { panic!("{c:?} is not in the corner") };
        faces[face - 4] += c.normal_force;
        sum += c.normal * c.normal_force + c.normal.turned_right() * c.tangential_force;
    }
    // From the centre to the edge, and that turned to the right.
    let u = -sample.state.pose.centre.unit().unwrap();
    (faces, [sum.dot(u), sum.dot(u.turned_right())])
}

fn edge_carries_as_theory(part: &HookedPart, piece: &Piece, friction: f64) {
    assert!(piece.samples.len() > 4, "{} samples", piece.samples.len());
    for sample in &piece.samples {
        let (faces, force) = forces(sample);
        let expected = part.edge_force(swing(part, &sample.state));
        let near = |a: [f64; 2], b: [f64; 2]| (0..2).all(|i| (a[i] - b[i]).abs() < AS_THEORY);
        assert!(near(force, expected), "{force:?} not {expected:?} at {}", sample.time);
        // With friction the faces' shares are open.
        let shares = part.face_forces(expected);
        assert!(friction > 0.0 || near(faces, shares), "{faces:?} not {shares:?} at {}", sample.time);
    }
}

#[test]
fn an_l_has_the_moments_of_its_outline() {
    for legs in [[0.06, 0.06], [0.05, 0.09], [0.09, 0.02]] {
        let (part, body) = (theory(legs), l(legs));
        let corner = body.shape.vertices()[5];
        assert!((part.inertia - body.inertia).abs() < ROUNDING, "{legs:?}");
        assert!((part.arm - corner.norm()).abs() < ROUNDING, "{legs:?}");
        let at = hanging(&part, [0.0, 0.0]).pose;
        let on_edge = at.centre + corner.rotated(cos(at.angle), sin(at.angle));
        assert!(on_edge.norm() < ROUNDING, "its corner hangs on the edge: {on_edge:?}");
        assert!(body.shape.is_hollow(5), "it is an inner corner");
    }
}

#[test]
fn an_l_swings_about_the_edge_in_its_corner_like_a_pendulum() {
    for (legs, at, amplitudes) in
        [([0.06, 0.06], 0.0, [1e-4, 0.3, 0.7]), ([0.05, 0.09], -0.3, [1e-4, 0.1, 0.3])]
    {
        let part = theory(legs);
        let [lowest, highest] = part.lying_tilts(at);
        for (friction, amplitude) in amplitudes.into_iter().flat_map(|a| [(0.0, a), (0.3, a)]) {
            assert!(lowest < -amplitude && amplitude < highest, "the plate has room");
            assert!(amplitude < part.largest_amplitude(friction).unwrap(), "the edge stays");
            let world = world(legs, plate(at, friction));
            let period = part.period(amplitude).unwrap();
            for (share, back) in [(0.5, -amplitude), (1.0, amplitude), (2.0, amplitude)] {
                let start = hanging(&part, [amplitude, 0.0]);
                let (end, trace, _) = walk(&world, start, share * period);
                same(&end, &hanging(&part, [back, 0.0]), "after whole and half periods");
                assert!(trace.impacts.is_empty(), "nothing strikes");
                assert_eq!(trace.pieces.len(), 1, "with friction {friction}, amplitude {amplitude}");
                edge_carries_as_theory(&part, &trace.pieces[0], friction);
            }
        }
        let (_, _, end) = walk(&world(legs, plate(at, 0.0)), hanging(&part, [0.0, 0.0]), 1.0);
        assert_eq!(end, Happening::Rests, "straight down");
    }
}

#[test]
fn an_l_is_let_go_to_swing_or_to_slip_out_as_theory_says() {
    // Plates that leave room for such amplitudes: to the right, and to the left.
    for (legs, face) in [([0.05, 0.09], 0), ([0.09, 0.05], 1), ([0.06, 0.06], 0), ([0.06, 0.06], 1)] {
        let (part, side) = (theory(legs), [-1.0, 1.0][face]);
        for friction in [0.0, 0.1, 0.25] {
            let largest = part.largest_amplitude(friction).unwrap();
            let lying = part.lying_tilts(0.0)[face];
            // The plate stands off the face that would lie on it by 0.3 rad at the turn.
            let world = world(legs, plate(side * (largest + 0.3) - lying, friction));
            for (amplitude, stays) in [(largest - BESIDE, true), (largest + BESIDE, false)] {
                let (_, trace, _) = walk(&world, hanging(&part, [side * amplitude, 0.0]), 1e-3);
                assert_eq!(trace.pieces[0].held.len() == 2, stays, "{legs:?} {friction} {amplitude}");
                let sliding = Feature::FaceOnEnd { face: 4 + face, end: 1 };
                assert!(trace.pieces[0].held.iter().any(|h| h.feature == sliding), "it carries on");
            }
        }
    }
}

/// An L that lies on a plate with one inner face and slides down it until the corner is at the edge.
struct SlidesIn {
    legs: [f64; 2],
    /// The face that lies on the plate: the left one on a plate that falls to the left, or the right one.
    face: usize,
    slope: f64,
    friction: f64,
    speed: f64,
    way: f64,
}

impl SlidesIn {
    fn side(&self) -> f64 {
        [-1.0, 1.0][self.face]
    }

    /// Tilt while it lies on the plate.
    fn tilt(&self) -> f64 {
        self.side() * (theory(self.legs).normals[self.face] - self.slope)
    }

    fn downhill(&self) -> Vec2 {
        Vec2::new(self.side() * cos(self.slope), -sin(self.slope))
    }

    /// Time and speed with which the corner is there, and the state after it has struck.
    fn arrival(&self) -> (Arrival, State, [f64; 2]) {
        let plate = Incline { slope: self.slope, friction: self.friction, gravity: GRAVITY };
        let arrival = plate.slide(self.speed, self.way).unwrap().unwrap();
        let (part, velocity) = (theory(self.legs), self.downhill() * arrival.speed);
        let normal = part.normals[self.face];
        let back = part.arm * (sin(normal) - self.friction * cos(normal));
        assert!(back > self.way, "the plate carries it before its edge: it lies flat");
        let caught = part.caught(self.tilt(), [velocity.x, velocity.y], 0.0);
        assert!(part.holds(caught.impulse, self.friction), "the impulse is between the faces");
        (arrival, hanging(&part, [self.tilt(), caught.tilt_rate]), caught.impulse)
    }

    fn walk(&self, until: f64) -> (State, Trace, Happening) {
        let at = self.side() * (std::f64::consts::FRAC_PI_2 - self.slope);
        let mut start = hanging(&theory(self.legs), [self.tilt(), 0.0]);
        start.pose.centre -= self.downhill() * self.way;
        start.twist.velocity = self.downhill() * self.speed;
        walk(&world(self.legs, plate(at, self.friction)), start, until)
    }
}

/// Impulse of the edge along u and e.
fn impulse(impact: &Impact) -> [f64; 2] {
    let of = |c: &carom_motion::planar::trace::ImpactContact| {
        c.normal * c.normal_impulse + c.normal.turned_right() * c.tangential_impulse
    };
    let sum = impact.contacts.iter().map(of).fold(Vec2::ZERO, |a, b| a + b);
    let u = -impact.pose.centre.unit().unwrap();
    [sum.dot(u), sum.dot(u.turned_right())]
}

const SWINGS: [SlidesIn; 4] = [
    SlidesIn { legs: [0.06, 0.06], face: 0, slope: 0.5, friction: 0.0, speed: 0.0, way: 0.008 },
    SlidesIn { legs: [0.06, 0.06], face: 0, slope: 0.5, friction: 0.2, speed: 0.0, way: 0.008 },
    SlidesIn { legs: [0.06, 0.06], face: 1, slope: 0.5, friction: 0.2, speed: 0.3, way: 0.008 },
    SlidesIn { legs: [0.09, 0.05], face: 1, slope: 0.5, friction: 0.1, speed: 0.0, way: 0.002 },
];

#[test]
fn an_l_slides_until_its_corner_strikes_swings_out_and_comes_back() {
    for case in SWINGS {
        let part = theory(case.legs);
        let (arrival, after, struck) = case.arrival();
        let (_, trace, _) = case.walk(1.0);
        let [slides, swings] = &trace.pieces[..2] else { panic!("{:?}", trace.pieces) };
        assert!((slides.end_time - arrival.time).abs() < AS_THEORY, "{} {arrival:?}", slides.end_time);
        assert!((slides.end.twist.velocity.norm() - arrival.speed).abs() < AS_THEORY, "{arrival:?}");
        let ours = impulse(&trace.impacts[0]);
        assert!((0..2).all(|i| (ours[i] - struck[i]).abs() < AS_THEORY), "{ours:?} not {struck:?}");
        same(&swings.start, &after, "struck");
        // It turns before the edge slips out, and strikes the plate with its leg.
        let begins = swing(&part, &after);
        assert_eq!(part.slipping_tilts(begins, case.friction), [None; 2], "it turns before");
        let back = arrival.time + part.time_to_return(begins).unwrap();
        assert!((swings.end_time - back).abs() < AS_THEORY, "{} not {back}", swings.end_time);
        same(&swings.end, &hanging(&part, [begins[0], -begins[1]]), "back on the plate");
        assert!(matches!(swings.ended_by, PieceEnd::Closes { .. }), "{:?}", swings.ended_by);
        edge_carries_as_theory(&part, swings, case.friction);
    }
}

const SLIPS: [SlidesIn; 4] = [
    SlidesIn { legs: [0.05, 0.09], face: 0, slope: 0.5, friction: 0.0, speed: 0.0, way: 0.004 },
    SlidesIn { legs: [0.05, 0.09], face: 0, slope: 0.5, friction: 0.1, speed: 0.5, way: 0.002 },
    SlidesIn { legs: [0.09, 0.05], face: 1, slope: 0.5, friction: 0.1, speed: 0.5, way: 0.002 },
    SlidesIn { legs: [0.06, 0.06], face: 0, slope: 0.5, friction: 0.2, speed: 1.3, way: 0.008 },
];

#[test]
fn an_l_that_is_struck_harder_slips_out_of_its_corner_and_slides_on_one_face() {
    for case in SLIPS {
        let part = theory(case.legs);
        let (arrival, after, _) = case.arrival();
        let begins = swing(&part, &after);
        let tilt = part.slipping_tilts(begins, case.friction)[case.face].unwrap();
        let slips = arrival.time + part.time_between(begins, tilt).unwrap();
        let (_, trace, _) = case.walk(slips + 0.05);
        assert_eq!(trace.impacts.len(), 1, "nothing else strikes");
        assert!(trace.pieces.len() <= 4, "{} pieces", trace.pieces.len());
        // In the last piece one face slides.
        let piece = trace.pieces.last().unwrap();
        let sliding = Feature::FaceOnEnd { face: 4 + case.face, end: 1 };
        let along = if case.face == 0 { Slip::Forward } else { Slip::Backward };
        let held: Vec<_> = piece.held.iter().map(|h| (h.feature, h.slip)).collect();
        assert_eq!(held, [(sliding, along)], "away from the corner");
        assert!((piece.start_time - slips).abs() < AS_THEORY, "{} not {slips}", piece.start_time);
        let [out, _] = swing(&part, &piece.start);
        assert!((out - tilt).abs() < LETS_GO, "{out} not {tilt}");
        let rate = part.rate_squared(begins, out).sqrt().copysign(begins[1]);
        same(&piece.start, &hanging(&part, [out, rate]), "slips out");
        slides_as_theory(&part, (case.face, case.friction), piece, [out, rate]);
    }
}

/// From the corner on, one face slides on the edge as the equations of motion say.
fn slides_as_theory(part: &HookedPart, (face, friction): (usize, f64), piece: &Piece, out: [f64; 2]) {
    let (board, start) = part.slipping(face, out, friction);
    // The left face is level as drawn, the right one after a quarter turn.
    let drawn = [0.0, std::f64::consts::FRAC_PI_2][face];
    assert!(piece.samples.len() > 4, "{} samples", piece.samples.len());
    for sample in &piece.samples {
        let state = follow(&board, start, sample.time - piece.start_time);
        let (place, ours) = (pose(&board, &state, face == 1), sample.state.pose);
        assert!((place.centre - ours.centre).norm() < AS_THEORY, "{ours:?} not {place:?}");
        assert!((place.angle + drawn - ours.angle).abs() < AS_THEORY, "{ours:?} not {place:?}");
        let (force, expected) = (sample.contacts[0].normal_force, board.motion(&state).normal_force);
        assert!((force - expected).abs() < AS_THEORY, "{force} not {expected}");
    }
}

#[test]
fn a_disc_that_spins_in_an_inner_corner_stops_when_friction_has_used_up_its_spin() {
    // Both faces at 45°: N₁(1 − μ) = N₂(1 + μ) and N₁ + N₂ = √2 mg/(1 + μ²), so that ω̇ = −√2 μmgR/((1 + μ²)J).
    let (radius, friction, spin) = (0.05, 0.3, 30.0);
    let chute = [(-1.0, 1.0), (0.0, 0.0), (1.0, 1.0)].map(|(x, y)| ChainPoint::straight(Vec2::new(x, y)));
    let chute = Obstacle::of_shape(Shape::of_open_chain(&chute).unwrap(), friction, 0.0);
    let shape = Shape::new(vec![Vec2::ZERO], radius).unwrap();
    let body = Body { shape, mass: MASS, inertia: 0.5 * MASS * radius * radius };
    let world = World::of_one(Vec2::new(0.0, -GRAVITY), body, vec![chute], Law::Poisson);
    let start = State {
        pose: Pose { centre: Vec2::new(0.0, 2f64.sqrt() * radius), angle: 0.0 },
        twist: Twist { velocity: Vec2::ZERO, spin },
    };
    let (end, trace, happening) = walk(&world, start, 10.0);
    let brakes = 8f64.sqrt() * friction * GRAVITY / ((1.0 + friction * friction) * radius);
    assert_eq!((happening, trace.pieces[0].held.len()), (Happening::Rests, 2), "on both faces");
    let stops = trace.pieces[0].end_time;
    assert!((stops - spin / brakes).abs() < AS_THEORY, "{stops} not {}", spin / brakes);
    assert!((end.pose.angle - 0.5 * spin * spin / brakes).abs() < AS_THEORY, "{end:?}");
}
