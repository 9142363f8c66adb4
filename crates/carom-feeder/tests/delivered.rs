//! *Delivered* means that the part is past the last plate: no contact with that plate follows.

#![allow(clippy::print_stdout, reason = "how many are delivered is a measurement")]

use carom_feeder::{Feeder, JamKind, Outcome, Part, PartKind, Plate, Run, Start, Stop, Wall};
use carom_impact::Law;
use carom_motion::planar::{Body, Shape};
use carom_num::Vec2;
use carom_num::elementary::tan;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Channels that are drawn.
const CHANNELS: u64 = 400;
/// How far below the last edge a part that is delivered is caught [m]: too far to be thrown back up.
const CAUGHT: f64 = 0.6;

/// A channel of two walls with a plate at each, lengths in metres and angles in degrees.
struct Channel {
    /// Length and height of the part.
    part: [f64; 2],
    width: f64,
    friction: f64,
    slopes: [f64; 2],
    /// From each plate's edge to the wall it slopes to.
    gaps: [f64; 2],
    drop: f64,
}

impl Channel {
    fn feeder(&self) -> Feeder {
        let [a, b] = self.part.map(|side| 0.5 * side);
        let corners = [(-a, -b), (a, -b), (a, b), (-a, b)].map(|(x, y)| Vec2::new(x, y));
        let shape = Shape::new(corners.to_vec(), 0.0).unwrap();
        let mass = 0.3;
        let body = Body { shape, mass, inertia: mass * (a * a + b * b) / 3.0 };
        let plate = |name: &str, uphill: Vec2, edge: Vec2| Plate {
            name: name.to_owned(),
            uphill,
            edge,
            friction: self.friction,
            restitution: 0.5,
            unbounded: false,
            form: Default::default(),
        };
        let fall = |k: usize| (self.width - self.gaps[k]) * tan(self.slopes[k].to_radians());
        let upper = plate("upper", Vec2::ZERO, Vec2::new(self.width - self.gaps[0], -fall(0)));
        let hinge = Vec2::new(self.width, -self.drop);
        let lower = plate("lower", hinge, Vec2::new(self.gaps[1], -self.drop - fall(1)));
        let wall = |name: &str, x: f64| Wall {
            name: name.to_owned(),
            from: Vec2::new(x, 1.0),
            to: Vec2::new(x, -self.drop - 1.5),
            friction: self.friction,
            restitution: 0.5,
            form: Default::default(),
        };
        Feeder {
            gravity: 9.81,
            stop: Stop::Delivered,
            law: Law::Poisson,
            part: Part { kind: PartKind::Box, body },
            start: Start { to_edge: 0.04, speed: 0.0, face: 0 },
            plates: vec![upper, lower],
            walls: vec![wall("left wall", 0.0), wall("right wall", self.width)],
        }
    }

    fn drawn(seed: u64) -> Self {
        let rng = &mut Pcg64::seed_from_u64(seed);
        let mut draw = |low: f64, high: f64| rng.random_range(low..high);
        Self {
            part: [0.06, draw(0.004, 0.06)],
            width: draw(0.16, 0.26),
            friction: draw(0.05, 0.25),
            slopes: [draw(20.0, 35.0), draw(12.0, 35.0)],
            gaps: [draw(0.07, 0.11), draw(0.02, 0.11)],
            drop: draw(0.14, 0.24),
        }
    }
}

/// The same channel above a floor: the run goes on where the part is delivered.
fn caught(feeder: &Feeder) -> Run {
    let mut longer = feeder.clone();
    let edge = feeder.plates.last().unwrap().edge;
    let ends = [-1.0, 1.0].map(|x| Vec2::new(x, edge.y - CAUGHT - 0.001 * x));
    longer.plates.push(Plate {
        name: "floor".to_owned(),
        uphill: ends[0],
        edge: ends[1],
        friction: 0.5,
        restitution: 0.0,
        unbounded: false,
        form: Default::default(),
    });
    longer.stop = Stop::Landed;
    longer.run().unwrap()
}

/// Whether a run touches the second plate after a time: strikes it, or moves on it.
fn touches_again(run: &Run, after: f64) -> bool {
    let struck = run.trace.impacts.iter().filter(|impact| impact.time > after);
    let held = run.trace.pieces.iter().filter(|piece| piece.start_time > after);
    struck.flat_map(|impact| &impact.contacts).any(|contact| contact.obstacle == 1)
        || held.flat_map(|piece| &piece.held).any(|contact| contact.obstacle == 1)
}

/// Two boxes in gaps that they do not fit through: they bounce beyond the edge, and come to rest wedged above the gap.
#[test]
fn a_part_that_bounces_over_a_gap_it_cannot_pass_is_not_delivered() {
    let first = Channel {
        part: [0.06, 0.047_536],
        width: 0.224_146,
        friction: 0.070,
        slopes: [29.829, 12.990],
        gaps: [0.102_335, 0.039_301],
        drop: 0.179_115,
    };
    let second = Channel {
        part: [0.06, 0.035_355],
        width: 0.218_412,
        friction: 0.243,
        slopes: [22.393, 12.604],
        gaps: [0.090_450, 0.030_818],
        drop: 0.217_674,
    };
    for channel in [first, second] {
        let run = channel.feeder().run().unwrap();
        assert_eq!(run.outcome, Outcome::Jammed, "wedged between the edge and the wall");
        assert!(run.exit.is_none(), "it has not left");
        let jam = run.jam.unwrap();
        assert_eq!(jam.kind, JamKind::Wedged, "it rests");
        let on = |obstacles: &[usize]| jam.contacts.iter().any(|touch| obstacles.contains(&touch.obstacle));
        assert!(on(&[1]) && on(&[2, 3]), "between the last plate and a wall: {:?}", jam.contacts);
    }
}

#[test]
fn what_is_delivered_never_touches_the_last_plate_again() {
    let (mut delivered, mut jammed) = (0, 0);
    for seed in 0..CHANNELS {
        let channel = Channel::drawn(seed);
        let feeder = channel.feeder();
        let Ok(run) = feeder.run() else { continue };
        jammed += u64::from(run.outcome == Outcome::Jammed);
        if run.outcome != Outcome::Delivered {
            assert!(run.exit.is_none(), "seed {seed}: only what is delivered leaves");
            continue;
        }
        delivered += 1;
        let exit = run.exit.expect("how it left").time;
        assert!(exit <= run.end_time, "seed {seed}: it leaves before that is certain");
        let goes_on = caught(&feeder);
        assert!(!touches_again(&goes_on, exit), "seed {seed}: it comes back after {exit} s");
    }
    println!("{CHANNELS} channels: {delivered} delivered, {jammed} jammed");
    assert!(delivered > CHANNELS / 4 && jammed > CHANNELS / 20, "both are there: {delivered}, {jammed}");
}

/// Without walls nothing brings a part back that flies past the edge: it is delivered when it leaves the plate.
#[test]
fn an_open_feeder_delivers_at_the_edge() {
    let mut open = Channel { gaps: [0.1, 0.1], ..Channel::drawn(1) }.feeder();
    open.walls.clear();
    open.plates[0].friction = 0.05;
    open.plates[1].friction = 0.05;
    let run = open.run().unwrap();
    assert_eq!(run.outcome, Outcome::Delivered, "it slides off");
    assert_eq!(run.exit.map(|exit| exit.time), Some(run.end_time), "and that is certain at once");
}
