//! Several bodies: they meet, push, part and go on, as closed forms say.

use carom_impact::Law;
use carom_impact::planar::{ContactSet6, Meeting, RigidBody, staged, struck};
use carom_motion::planar::trace::Trace;
use carom_motion::planar::{
    Body, Crowd, Happening, Obstacle, Options, Pose, Recorder, Shape, State, Surface, Twist, Walker, World,
};
use carom_num::Vec2;
use carom_num::elementary::{cos, sin};

/// What flights and impacts leave of places [m], times [s] and shares of an energy.
const FLOWN: f64 = 1e-12;
/// What a glide at the tolerance 1e-11 leaves of forces [N], energies [J] and times [s] of order 1 to 10.
const GLIDED: f64 = 1e-9;
/// Two balls on a line fly and strike in closed form: a few roundings of times [s] and speeds [m/s] of order 1.
const CLOSED_FORM: f64 = 1e-14;
const G: f64 = 9.81;

fn disc(radius: f64, mass: f64) -> Body {
    Body { shape: Shape::new(vec![Vec2::ZERO], radius).unwrap(), mass, inertia: 0.5 * mass * radius * radius }
}

fn rectangle(width: f64, height: f64, mass: f64) -> Body {
    let (x, y) = (0.5 * width, 0.5 * height);
    let corners = [(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| Vec2::new(x, y));
    let shape = Shape::new(corners.to_vec(), 0.0).unwrap();
    Body { shape, mass, inertia: mass * (width * width + height * height) / 12.0 }
}

fn world(gravity: f64, bodies: Vec<Body>, obstacles: Vec<Obstacle>, between: (f64, f64)) -> World {
    let between = Surface { friction: between.0, restitution: between.1 };
    World { gravity: Vec2::new(0.0, -gravity), bodies, obstacles, between, law: Law::Poisson }
}

fn state(centre: Vec2, angle: f64, velocity: Vec2, spin: f64) -> State {
    State { pose: Pose { centre, angle }, twist: Twist { velocity, spin } }
}

/// Walks all bodies up to a time; their states there, and what was recorded.
fn walk(world: &World, starts: &[State], until: f64) -> (Vec<State>, Vec<Trace>) {
    let options = Options::default();
    let mut crowd = Crowd::new(world, options);
    for (body, start) in starts.iter().enumerate() {
        crowd.enter(body, *start, vec![true; world.obstacles.len()]).unwrap();
    }
    let mut recorders = vec![Recorder::default(); starts.len()];
    while crowd.time() < until {
        let step = crowd.advance(until, &mut recorders).unwrap();
        assert_ne!(step.happening, Happening::BudgetSpent, "at {} s", crowd.time());
    }
    crowd.pause(&mut recorders).unwrap();
    let at_end = (0..starts.len()).map(|body| *crowd.member(body).unwrap().state()).collect();
    (at_end, recorders.into_iter().map(Recorder::into_trace).collect())
}

#[test]
fn two_discs_meet_head_on() {
    let world = world(0.0, vec![disc(0.1, 1.0), disc(0.2, 3.0)], vec![], (0.3, 0.5));
    let starts = [
        state(Vec2::ZERO, 0.0, Vec2::new(2.0, 0.0), 0.0),
        state(Vec2::new(1.3, 0.0), 0.0, Vec2::new(0.0, 0.0), 0.0),
    ];
    let (end, traces) = walk(&world, &starts, 1.0);
    // They meet after 1 m at 2 m/s; 2 m/s before, half of it after, the mass centre at 0.5 m/s.
    assert_eq!(traces[0].impacts.len(), 1);
    assert!((traces[0].impacts[0].time - 0.5).abs() < CLOSED_FORM);
    let after = [end[0].twist.velocity.x, end[1].twist.velocity.x];
    assert!((after[0] + 0.25).abs() < CLOSED_FORM && (after[1] - 0.75).abs() < CLOSED_FORM, "{after:?}");
    assert!((end[1].pose.centre.x - 1.3 - 0.375).abs() < 1e-13);
}

/// A slope that descends to the right from the origin.
fn slope(angle: f64, friction: f64, restitution: f64) -> Obstacle {
    Obstacle::new(Vec2::at_angle(-angle) * -3.0, Vec2::at_angle(-angle) * 20.0, friction, restitution)
}

/// A body whose lowest point is `height` below its centre, on that slope.
fn on_slope(angle: f64, along: f64, height: f64, speed: f64, spin: f64) -> State {
    let down = Vec2::at_angle(-angle);
    state(down * along + down.turned_left() * height, -angle, down * speed, spin)
}

#[test]
fn a_disc_that_rolls_into_a_box_pushes_it() {
    let (angle, friction, radius) = (0.5, 0.3, 0.05);
    let bodies = vec![disc(radius, 2.0), rectangle(0.2, 0.1, 1.0)];
    let world = world(G, bodies, vec![slope(angle, friction, 0.0)], (0.0, 0.0));
    let starts = [on_slope(angle, 0.0, 0.05, 0.5, -10.0), on_slope(angle, 0.3, 0.05, 0.2, 0.0)];
    let (_, traces) = walk(&world, &starts, 1.0);
    // Together: the disc rolls (its inertia counts half as much again), the box slides.
    let (pull, held) = (G * sin(angle), friction * G * cos(angle));
    let together = (2.0 * pull + (pull - held)) / (1.5 * 2.0 + 1.0);
    let push = together - (pull - held);
    let piece = traces[1].pieces.last().unwrap();
    assert_eq!(piece.held.len(), 3, "{piece:?}");
    for sample in &piece.samples {
        let contact = sample.contacts.iter().find(|c| c.obstacle == 1).unwrap();
        assert!((contact.normal_force - push).abs() < GLIDED, "{} {push}", contact.normal_force);
    }
    let gained = (piece.end.twist.velocity.norm() - piece.start.twist.velocity.norm())
        / (piece.end_time - piece.start_time);
    assert!((gained - together).abs() < GLIDED, "{gained} {together}");
    // Before they met, both moved alone: from 5 cm apart at 0.3 m/s, one as a rolling disc, the other as a sliding box.
    let (met, gap) = (traces[1].impacts[0].time, 0.3 - 0.1 - radius);
    let closed = gap - 0.3 * met - 0.5 * (pull / 1.5 - (pull - held)) * met * met;
    assert!(closed.abs() < 1e-11, "{closed}");
}

#[test]
fn a_body_that_meets_no_other_moves_as_if_alone() {
    let plates = vec![slope(0.3, 0.2, 0.4), slope(-0.4, 0.1, 0.2)];
    let part = rectangle(0.2, 0.05, 0.3);
    let world = world(G, vec![part.clone(), part.clone()], plates.clone(), (0.2, 0.5));
    let alone = World::of_one(world.gravity, part, plates, Law::Poisson);
    let thrown = |x: f64| state(Vec2::new(x, 0.8), 0.7, Vec2::new(0.3, 0.0), 3.0);
    let (_, traces) = walk(&world, &[thrown(-1.0), thrown(1.5)], 0.6);
    for (trace, x) in traces.iter().zip([-1.0, 1.5]) {
        let mut recorder = Recorder::default();
        let mut walker = Walker::new(&alone, thrown(x), vec![true; 2], Options::default()).unwrap();
        while walker.time() < 0.6 {
            walker.advance(&mut recorder).unwrap();
        }
        assert!(trace.impacts.len() > 1, "{x}");
        let own = recorder.into_trace();
        for (a, b) in trace.pieces.iter().zip(&own.pieces).filter(|(a, _)| a.end_time < 0.6) {
            assert_eq!(a, b);
        }
    }
}

#[test]
fn a_ball_comes_to_rest_on_a_box_that_rests() {
    let bodies = vec![rectangle(0.4, 0.2, 2.0), disc(0.05, 0.1)];
    let world = world(
        G,
        bodies,
        vec![Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::new(1.0, 0.0), 0.5, 0.0)],
        (0.4, 0.5),
    );
    let starts = [
        state(Vec2::new(0.0, 0.1), 0.0, Vec2::ZERO, 0.0),
        state(Vec2::new(0.0, 0.25 + 0.3), 0.0, Vec2::ZERO, 0.0),
    ];
    let (end, traces) = walk(&world, &starts, 2.0);
    // It falls for √(2h/g), then infinitely many hops, each half as long as the one before: 1 + 2 (1/2 + 1/4 + …) falls.
    let stops = 3.0 * (2.0 * 0.3 / G).sqrt();
    let (_, limit) = traces[1].accumulations[0];
    assert!((limit - stops).abs() < GLIDED, "{limit} {stops}");
    assert!(traces[1].impacts.len() > 15 && end[1].twist == Twist::default(), "{end:?}");
    assert!((end[1].pose.centre.y - 0.25).abs() < FLOWN, "{end:?}");
}

#[test]
fn what_two_equal_boxes_do_on_a_slope_is_what_their_faces_do() {
    // The rear one is faster. Without restitution both go on with the mean speed, face to face, and nothing is between them; with it they part.
    let (angle, friction) = (0.5, 0.3);
    let pull = G * (sin(angle) - friction * cos(angle));
    for restitution in [0.0, 0.5, 1.0] {
        let part = rectangle(0.2, 0.1, 1.0);
        let world = world(G, vec![part.clone(), part], vec![slope(angle, friction, 0.0)], (0.2, restitution));
        let starts = [on_slope(angle, 0.0, 0.05, 0.9, 0.0), on_slope(angle, 0.3, 0.05, 0.4, 0.0)];
        let (end, traces) = walk(&world, &starts, 0.6);
        assert!((traces[0].impacts[0].time - 0.2).abs() < FLOWN);
        assert_eq!(traces[0].impacts.len(), 1, "{restitution}");
        let falls = pull * 0.6;
        let speeds = [0, 1].map(|i: usize| end[i].twist.velocity.norm() - falls);
        let expected = [0.65 - 0.25 * restitution, 0.65 + 0.25 * restitution];
        for (speed, expected) in speeds.iter().zip(expected) {
            assert!((speed - expected).abs() < 1e-11, "{restitution}: {speeds:?}");
        }
    }
}

#[test]
fn a_box_slides_off_a_box() {
    // On a lower box that stays, the upper one slides as on a plate, until the point at which its weight and friction press on it is over the edge:
    // friction at its base presses the front, μ times half the height before the centre.
    let (angle, friction) = (0.4, 0.2);
    let bodies = vec![rectangle(0.6, 0.1, 5.0), rectangle(0.2, 0.1, 1.0)];
    let world = world(G, bodies, vec![slope(angle, 2.0, 0.0)], (friction, 0.0));
    let starts = [on_slope(angle, 0.0, 0.05, 0.0, 0.0), on_slope(angle, 0.05, 0.15, 0.0, 0.0)];
    let (end, traces) = walk(&world, &starts, 0.6);
    let pull = G * (sin(angle) - friction * cos(angle));
    let leaves = (2.0 * (0.3 - 0.05 - friction * 0.05) / pull).sqrt();
    let tips = traces[1].pieces.iter().find(|p| p.held.len() == 1).unwrap();
    assert!((tips.start_time - leaves).abs() < 1e-10, "{} {leaves}", tips.start_time);
    assert!(traces.iter().all(|t| t.impacts.is_empty()), "they touch from the start");
    assert!((end[0].pose.centre - starts[0].pose.centre).norm() < FLOWN, "the lower one stays: {end:?}");
}

#[test]
fn a_strike_goes_through_all_balls_that_touch() {
    // One ball strikes a row of three: what their contacts do together is for the impact kernel to say.
    let row = vec![disc(0.1, 1.0); 4];
    let world = world(0.0, row.clone(), vec![], (0.0, 1.0));
    let at = |x: f64, v: f64| state(Vec2::new(x, 0.0), 0.0, Vec2::new(v, 0.0), 0.0);
    let (end, traces) = walk(&world, &[at(-0.5, 1.0), at(0.0, 0.0), at(0.2, 0.0), at(0.4, 0.0)], 1.0);
    let bodies = [(-0.2, 1.0), (0.0, 0.0), (0.2, 0.0), (0.4, 0.0)].map(|(x, v)| RigidBody {
        mass: 1.0,
        inertia: row[0].inertia,
        centre: Vec2::new(x, 0.0),
        velocity: Vec2::new(v, 0.0),
        spin: 0.0,
    });
    let meetings = [0, 1, 2].map(|i: usize| Meeting {
        into: i + 1,
        out_of: i,
        point: (bodies[i].centre + bodies[i + 1].centre) * 0.5,
        normal: Vec2::new(1.0, 0.0),
        friction: 0.0,
        restitution: 1.0,
    });
    let set = ContactSet6::of_bodies(&bodies, &meetings).unwrap();
    let after = struck(&bodies, &meetings, &staged::resolve(&set, Law::Poisson).unwrap().impulse).unwrap();
    for (i, (state, body)) in end.iter().zip(&after).enumerate() {
        assert_eq!(traces[i].impacts.len(), 1);
        assert!((state.twist.velocity - body.velocity).norm() < 1e-13, "{i}: {state:?} {body:?}");
    }
}

/// Mass, moment of momentum and energy of free bodies.
fn totals(world: &World, states: &[State]) -> [f64; 4] {
    let mut out = [0.0; 4];
    for (b, s) in world.bodies.iter().zip(states) {
        out[0] += b.mass * s.twist.velocity.x;
        out[1] += b.mass * s.twist.velocity.y;
        out[2] += b.mass * s.pose.centre.cross(s.twist.velocity) + b.inertia * s.twist.spin;
        out[3] += b.kinetic_energy(&s.twist);
    }
    out
}

#[test]
#[allow(clippy::print_stdout, reason = "how often they meet is a measurement")]
fn momentum_is_kept_and_energy_does_not_grow() {
    let mut random = Random(1);
    let (mut impacts, mut pieces) = (0, 0);
    for _ in 0..300 {
        let friction = random.between(0.0, 1.0);
        let restitution = random.between(0.0, 1.0);
        let bodies: Vec<Body> = (0..3).map(|_| random.body()).collect();
        let world = world(0.0, bodies, vec![], (friction, restitution));
        // From three sides towards the middle.
        let starts: Vec<State> = (0..3)
            .map(|i| {
                let out = Vec2::at_angle(2.1 * f64::from(i) + random.between(-0.2, 0.2));
                let aim = out.turned_left() * random.between(-0.3, 0.3);
                state(
                    out * 0.5,
                    random.between(0.0, 6.0),
                    aim - out * random.between(0.5, 1.5),
                    random.between(-5.0, 5.0),
                )
            })
            .collect();
        let before = totals(&world, &starts);
        let (end, traces) = walk(&world, &starts, 1.5);
        impacts += traces.iter().map(|t| t.impacts.len()).sum::<usize>();
        pieces += traces.iter().map(|t| t.pieces.len()).sum::<usize>();
        let after = totals(&world, &end);
        for i in 0..3 {
            assert!((before[i] - after[i]).abs() < 1e-10, "{i}: {before:?} {after:?}");
        }
        assert!(after[3] <= before[3] * (1.0 + FLOWN), "{before:?} {after:?}");
    }
    println!("{impacts} impacts, {pieces} pieces");
    assert!(impacts > 500);
}

/// A small generator of numbers, the same everywhere.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// A triangle, a rectangle, a disc or a rounded rod.
    fn body(&mut self) -> Body {
        let size = self.between(0.05, 0.15);
        let (vertices, radius) = match self.between(0.0, 4.0) as u32 {
            0 => (vec![(-1.0, -0.6), (0.9, -0.7), (0.1, 1.0)], 0.0),
            1 => (vec![(-1.0, -0.4), (1.0, -0.4), (1.0, 0.4), (-1.0, 0.4)], 0.1 * size),
            2 => (vec![(0.0, 0.0)], size),
            _ => (vec![(-1.0, 0.0), (1.0, 0.0)], 0.2 * size),
        };
        let vertices = vertices.into_iter().map(|(x, y)| Vec2::new(x * size, y * size)).collect();
        let mass = self.between(0.5, 2.0);
        Body { shape: Shape::new(vertices, radius).unwrap(), mass, inertia: 0.4 * mass * size * size }
    }
}
