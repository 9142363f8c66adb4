//! Round parts with hollows on curved plates: energy never grows and nothing overlaps.

use carom_impact::Law;
use carom_motion::planar::trace::Trace;
use carom_motion::planar::{
    Body, ChainPoint, Happening, MassProperties, Obstacle, Options, Pose, Recorder, Shape, State, Twist,
    Walker, World,
};
use carom_num::Vec2;
use carom_num::elementary::sin_cos;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;
use std::f64::consts::PI;

const GRAVITY: f64 = 9.81;
/// Parts of the test.
const PARTS: u64 = 400;
/// Overlap, of the part's size, and growth of energy, of its weight times that, which are rounding.
const NOTHING: f64 = 1e-9;
/// What of that a series of impacts may add that is closed at its limit: it ends when so little time is left of it.
const CLOSED: f64 = 1e-6;
/// Points of a plate at which it is asked how deep they lie in the part.
const PLACES: u32 = 400;

fn at(p: Vec2, sweep: f64) -> ChainPoint {
    ChainPoint { at: p, sweep }
}

/// A star of random rays whose edges are bent either way, about its mass centre; `None` where its edges cross.
fn part(of: &mut impl FnMut(f64, f64) -> f64) -> Option<Body> {
    let rays = of(4.0, 9.0).floor();
    let mut points = vec![];
    let mut ray = 0.0;
    while ray < rays {
        let (sin, cos) = sin_cos(2.0 * PI * (ray + of(-0.3, 0.3)) / rays);
        let sweep = if of(0.0, 1.0) < 0.5 { 0.0 } else { of(-0.6, 0.6) };
        points.push(at(Vec2::new(cos, sin) * of(0.04, 0.1), sweep));
        ray += 1.0;
    }
    let drawn = MassProperties::of(&Shape::of_chain(&points).ok()?);
    points.iter_mut().for_each(|p| p.at -= drawn.centroid);
    let shape = Shape::of_chain(&points).ok()?;
    // Bent edges may cross: then its outline goes through itself, and some of it is deep inside.
    let on_outline = (0..points.len()).all(|i| shape.depth_of(points[i].at).abs() < NOTHING);
    on_outline.then_some(Body { shape, mass: 1.0, inertia: drawn.gyration_squared })
}

/// A segment, an arc that goes on smoothly, and another segment, from a place in a direction.
fn chute(start: Vec2, along: f64, [first, sweep, radius, second]: [f64; 4]) -> Vec<ChainPoint> {
    let direction = |angle: f64| {
        let (sin, cos) = sin_cos(angle);
        Vec2::new(cos, sin)
    };
    let (a, b) = (start, start + direction(along) * first);
    let chord = 2.0 * radius * sin_cos(0.5 * sweep.abs()).0;
    let c = b + direction(along + 0.5 * sweep) * chord;
    vec![at(a, 0.0), at(b, sweep), at(c, 0.0), at(c + direction(along + sweep) * second, 0.0)]
}

/// Points along an open chain.
fn places(chain: &[ChainPoint]) -> Vec<Vec2> {
    let piece = |i: usize, s: f64| {
        let (from, to) = (chain[i].at, chain[i + 1].at);
        match chain[i].arc_to(to) {
            None => from + (to - from) * s,
            Some((centre, _)) => {
                let (sin, cos) = sin_cos(chain[i].sweep * s);
                centre + (from - centre).rotated(cos, sin)
            }
        }
    };
    (0..chain.len() - 1)
        .flat_map(|i| (0..=PLACES).map(move |j| (i, f64::from(j) / f64::from(PLACES))))
        .map(|(i, s)| piece(i, s))
        .collect()
}

/// Where a run grows its energy, or where the part lies in a plate.
fn fault_in(world: &World, trace: &Trace, chains: &[Vec<ChainPoint>], seed: u64) -> Option<String> {
    let size = world.bodies[0].shape.size();
    let plates: Vec<Vec2> = chains.iter().flat_map(|c| places(c)).collect();
    let (mut energy, mut before) = (f64::INFINITY, 0.0);
    for piece in &trace.pieces {
        let closed = trace.accumulations.iter().any(|s| s.1 >= before && s.1 <= piece.end_time);
        let growth = if closed { CLOSED } else { NOTHING } * size * GRAVITY;
        before = piece.start_time;
        for state in [&piece.start, &piece.end] {
            let here = world.energy(&[*state]);
            if here > energy + growth {
                return Some(format!("{seed}: energy grows by {:e} at {}", here - energy, piece.start_time));
            }
            energy = here;
        }
        for sample in &piece.samples {
            let pose = sample.state.pose;
            let (sin, cos) = sin_cos(pose.angle);
            let seen = |p: &Vec2| (*p - pose.centre).rotated(cos, -sin);
            let near = plates.iter().filter(|p| (**p - pose.centre).norm() < size);
            let depth =
                near.map(|p| world.bodies[0].shape.depth_of(seen(p))).fold(f64::NEG_INFINITY, f64::max);
            if depth > NOTHING * size {
                return Some(format!("{seed}: overlaps by {depth:e} at {}", sample.time));
            }
        }
    }
    None
}

#[test]
fn energy_never_grows_and_nothing_overlaps_on_curved_plates() {
    let fault = |seed: u64| -> Option<String> {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let mut of = |low: f64, high: f64| random.random_range(low..high);
        let body = part(&mut of)?;
        let upper = chute(
            Vec2::new(of(-0.4, -0.2), of(0.0, 0.2)),
            of(-0.9, 0.0),
            [of(0.05, 0.2), of(-1.0, 1.4), of(0.05, 0.4), of(0.05, 0.3)],
        );
        let lower = chute(Vec2::new(-1.5, -0.6), of(-0.3, 0.0), [1.0, of(0.1, 0.6), of(0.3, 1.0), 1.0]);
        let (friction, restitution) = (of(0.0, 0.9), of(0.0, 0.5));
        let chains = [upper, lower];
        let obstacles = chains
            .iter()
            .map(|c| Obstacle::of_shape(Shape::of_open_chain(c).unwrap(), friction, restitution))
            .collect();
        let world = World::of_one(Vec2::new(0.0, -GRAVITY), body, obstacles, Law::Poisson);
        let start = State {
            pose: Pose { centre: Vec2::new(of(-0.2, 0.1), 0.45), angle: of(-PI, PI) },
            twist: Twist { velocity: Vec2::new(of(-0.5, 0.5), of(-1.0, 0.0)), spin: of(-8.0, 8.0) },
        };
        let mut walker =
            Walker::new(&world, start, vec![], Options { most_time: 2.0, ..Options::default() }).unwrap();
        let mut recorder = Recorder::default();
        loop {
            match walker.advance(&mut recorder) {
                Ok(Happening::Moves) => {}
                Ok(_) => break,
                Err(error) => return Some(format!("{seed}: {error}")),
            }
        }
        fault_in(&world, &recorder.into_trace(), &chains, seed)
    };
    let faults: Vec<String> = (0..PARTS).into_par_iter().filter_map(fault).collect();
    assert!(faults.is_empty(), "{} of {PARTS}: {:#?}", faults.len(), &faults[..faults.len().min(12)]);
}
