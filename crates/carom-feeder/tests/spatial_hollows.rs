//! Parts with hollows in space: against the engine of the plane.

#![allow(clippy::print_stdout, reason = "how far two engines differ is a measurement")]

use crate::extruded::in_space;
use carom_feeder::{Feeder, Form, Outcome, Part, PartKind, Plate, Start, Stop, spatial};
use carom_motion::planar::{Body, ChainPoint, Shape};
use carom_motion::spatial::Polyhedron;
use carom_num::elementary::tan;
use carom_num::{Mat3, Vec2, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

const SCENES: u64 = 1000;
const MASS: f64 = 0.05;
/// Half of its width \[m\].
const HALF: f64 = 0.01;
/// Where no series of impacts is closed the two engines agree so far \[s\].
const SAME_TIME: f64 = 1e-9;
/// A series is closed at its limit, in each engine at another impact \[s\].
const AFTER_SERIES: f64 = 1e-5;

/// An L of two blocks, in the axes of its mass centre.
struct Bracket {
    outline: Vec<Vec2>,
    blocks: [Vec<Vec2>; 2],
    inertia: f64,
}

impl Bracket {
    /// Legs of two lengths, from their common outer corner, and of one thickness \[m\].
    fn new([along, across]: [f64; 2], thick: f64) -> Self {
        let block = |[x, y]: [f64; 2], [u, v]: [f64; 2]| {
            [(x, y), (u, y), (u, v), (x, v)].map(|(x, y)| Vec2::new(x, y)).to_vec()
        };
        let blocks = [block([0.0, 0.0], [along, thick]), block([0.0, thick], [thick, across])];
        let area = |block: &[Vec2]| (block[2].x - block[0].x) * (block[2].y - block[0].y);
        let middle = |block: &[Vec2]| (block[0] + block[2]) * 0.5;
        let whole: f64 = blocks.iter().map(|block| area(block)).sum();
        let centre = blocks.iter().fold(Vec2::ZERO, |sum, block| sum + middle(block) * (area(block) / whole));
        let about = |block: &Vec<Vec2>| {
            let ([own, size], share) = ([middle(block) - centre, block[2] - block[0]], area(block) / whole);
            share * (own.dot(own) + size.dot(size) / 12.0)
        };
        let inertia = MASS * blocks.iter().map(about).sum::<f64>();
        let outline =
            [(0.0, 0.0), (along, 0.0), (along, thick), (thick, thick), (thick, across), (0.0, across)];
        let outline = outline.map(|(x, y)| Vec2::new(x, y) - centre).to_vec();
        let blocks = blocks.map(|block| block.into_iter().map(|r| r - centre).collect());
        Self { outline, blocks, inertia }
    }

    fn in_the_plane(&self) -> Part {
        let chain: Vec<ChainPoint> = self.outline.iter().map(|r| ChainPoint::straight(*r)).collect();
        let shape = Shape::of_chain(&chain).unwrap();
        Part { body: Body { shape, mass: MASS, inertia: self.inertia }, kind: PartKind::Polygon }
    }

    fn in_space(&self) -> spatial::Part {
        let deep = |profile: &[Vec2]| {
            let places = profile.iter().flat_map(|r| [-HALF, HALF].map(|z| Vec3::new(r.x, r.y, z)));
            Polyhedron::of_points(&places.collect::<Vec<_>>(), 1e-12).unwrap()
        };
        let inertia = Mat3::diagonal(self.inertia, 0.8 * self.inertia, self.inertia);
        let pieces = [deep(&self.blocks[0]), deep(&self.blocks[1])];
        spatial::Part::of_pieces((&deep(&self.outline), &pieces), Vec3::ZERO, (MASS, inertia)).unwrap()
    }
}

/// A bracket that starts on one of the sides of its hull, on the upper of two plates.
fn drawn(case: u64) -> (Feeder, spatial::Feeder) {
    let mut rng = Pcg64::seed_from_u64(case);
    let legs = [rng.random_range(0.025..0.05), rng.random_range(0.015..0.04)];
    let bracket = Bracket::new(legs, rng.random_range(0.002..0.008));
    let slopes: [f64; 2] = [rng.random_range(0.17..0.52), rng.random_range(0.09..0.44)];
    let friction = rng.random_range(0.05..0.98 * tan(slopes[0]));
    let restitution = if case.is_multiple_of(2) { 0.0 } else { rng.random_range(0.0..0.4) };
    let end = Vec2::new(rng.random_range(-0.2..-0.1), -rng.random_range(0.1..0.2));
    let plate = |name: &str, uphill: Vec2, edge: Vec2| Plate {
        name: name.to_owned(),
        uphill,
        edge,
        friction,
        restitution,
        unbounded: false,
        form: Form::default(),
    };
    let upper = plate("upper", Vec2::new(-0.25, 0.25 * tan(slopes[0])), Vec2::ZERO);
    let lower = plate("lower", end + Vec2::new(0.4, 0.4 * tan(slopes[1])), end);
    let part = bracket.in_the_plane();
    let sides = part.body.shape.hull().vertices().to_vec();
    let face = rng.random_range(0..sides.len());
    let (to_edge, speed) = (rng.random_range(0.03..0.06), rng.random_range(0.0..0.1));
    let feeder = Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Default::default(),
        part,
        start: Start { to_edge, speed, face },
        plates: vec![upper, lower],
        walls: vec![],
    };
    let corner = |k: usize| sides[k % sides.len()];
    let out = (corner(face + 1) - corner(face)).turned_right().unit().unwrap();
    let mut space = in_space(&feeder, bracket.in_space());
    space.start.face = space.part.facing(Vec3::new(out.x, out.y, 0.0)).unwrap();
    (feeder, space)
}

/// Ends are the same; how far the times are apart, whether a series was closed, and whether something in the hollow was held on the way.
fn differ(case: u64) -> Option<(f64, [bool; 2])> {
    let (plane, space) = drawn(case);
    let plane = plane.run().unwrap();
    let prepared = space.prepare(Default::default()).unwrap();
    let run = prepared.run().unwrap();
    let several = run.forks > 0;
    if several {
        return None;
    }
    assert_eq!(run.outcome, plane.outcome, "{case}");
    let series = !run.closings.is_empty() || !plane.trace.accumulations.is_empty();
    let world = prepared.world();
    // What touches deep within the hull, as it is drawn, does so in the hollow.
    let sides = || space.part.faces.iter().filter(|face| face.normal.z.abs() < 0.5);
    let inside = |place: Vec3| sides().all(|face| face.normal.dot(place) < face.depth - 1e-4);
    let entered = run.samples.pieces.iter().any(|piece| {
        let held = piece.mode.held(world);
        held.iter().any(|support| inside(world.touches_at(support, &piece.end).unwrap()))
    });
    let flat = |landing: Option<f64>, end: f64| landing.unwrap_or(end);
    let own = flat(run.final_landing().and_then(|landing| landing.flat), run.end_time);
    let other = flat(plane.final_landing().and_then(|landing| landing.flat), plane.end_time);
    let ended = matches!(run.outcome, Outcome::Landed | Outcome::Stuck);
    Some((if ended { (own - other).abs() } else { 0.0 }, [series, entered]))
}

#[test]
fn brackets_go_through_feeders_as_in_the_plane() {
    let found: Vec<(f64, [bool; 2])> = (0..SCENES).into_par_iter().filter_map(differ).collect();
    let entered = found.iter().filter(|(_, [_, entered])| *entered).count();
    for (series, most) in [(false, SAME_TIME), (true, AFTER_SERIES)] {
        let mut times: Vec<f64> =
            found.iter().filter(|(_, [closed, _])| *closed == series).map(|(time, _)| *time).collect();
        times.sort_by(f64::total_cmp);
        let (half, worst) = (times[times.len() / 2], times[times.len() - 1]);
        println!(
            "{} brackets, series {series}: half within {half:.1e} s, the worst {worst:.1e} s",
            times.len()
        );
        assert!(worst <= most, "{worst}");
    }
    println!("{entered} of {} hold something in their hollow", found.len());
    assert!(found.len() > 900 && entered > 80, "{} {entered}", found.len());
}
