//! Random parts with hollows among random plates: energy never grows, nothing overlaps, and an independent method sees the same touches.

use carom_impact::Law;
use carom_motion::MotionError;
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
/// Parts of one test.
const PARTS: u64 = 1000;
/// Overlap, of the part's size, and growth of energy, of its weight times that, which are rounding.
const NOTHING: f64 = 1e-9;
/// What of that a series of impacts may add that is closed at its limit: it ends when so little time is left of it.
const CLOSED: f64 = 1e-6;
/// How nearly mirrored and scaled copies agree, of sizes and of times, until what rounding differs by has grown.
const ALIKE: f64 = 1e-9;

/// A part, plates, and a start above them.
#[derive(Clone)]
struct Case {
    points: Vec<Vec2>,
    plates: Vec<[Vec2; 2]>,
    start: State,
    friction: f64,
    restitution: f64,
    law: Law,
}

impl Case {
    /// A star of random rays, which is often hollow between them, over plates that it falls on.
    fn random(seed: u64) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let mut of = |low: f64, high: f64| random.random_range(low..high);
        let rays = of(4.0, 10.0).floor();
        let mut points = vec![];
        let mut ray = 0.0;
        while ray < rays {
            let (sin, cos) = sin_cos(2.0 * PI * (ray + of(-0.35, 0.35)) / rays);
            points.push(Vec2::new(cos, sin) * of(0.02, 0.1));
            ray += 1.0;
        }
        let slope = of(-0.6, 0.6);
        let (sin, cos) = sin_cos(slope);
        let (along, middle) = (Vec2::new(cos, sin), Vec2::new(of(-0.1, 0.1), 0.0));
        let (left, right) = (of(0.05, 0.4), of(0.05, 0.4));
        let below = Vec2::new(of(-0.5, 0.5), -of(0.3, 0.6));
        let (sin, cos) = sin_cos(of(-0.6, 0.6));
        let under = Vec2::new(cos, sin);
        let start = State {
            pose: Pose { centre: Vec2::new(0.0, 0.35), angle: of(-PI, PI) },
            twist: Twist { velocity: Vec2::new(of(-0.5, 0.5), of(-1.0, 0.0)), spin: of(-8.0, 8.0) },
        };
        let law = if of(0.0, 1.0) < 0.5 { Law::Poisson } else { Law::Stronge };
        let plates =
            vec![[middle - along * left, middle + along * right], [below - under * 0.6, below + under * 0.6]];
        Self { points, plates, start, friction: of(0.0, 0.9), restitution: of(0.0, 0.6), law }
    }

    /// The same, as large and as slow as lengths `scale` times as long make it, and mirrored where that is asked.
    fn like(&self, scale: f64, mirrored: bool) -> Self {
        let side = if mirrored { -1.0 } else { 1.0 };
        let of = |v: Vec2| Vec2::new(v.x * side, v.y) * scale;
        let mut points: Vec<Vec2> = self.points.iter().map(|p| of(*p)).collect();
        if mirrored {
            points.reverse();
        }
        let speed = scale.sqrt();
        let (pose, twist) = (self.start.pose, self.start.twist);
        let start = State {
            pose: Pose { centre: of(pose.centre), angle: pose.angle * side },
            twist: Twist { velocity: of(twist.velocity) * (speed / scale), spin: twist.spin * side / speed },
        };
        Self { points, plates: self.plates.iter().map(|p| p.map(of)).collect(), start, ..self.clone() }
    }

    /// The world, and the points of the part about its mass centre.
    fn world(&self) -> (World, Vec<Vec2>) {
        let chain = |points: &[Vec2]| points.iter().map(|p| ChainPoint::straight(*p)).collect::<Vec<_>>();
        let drawn = MassProperties::of(&Shape::of_chain(&chain(&self.points)).unwrap());
        let points: Vec<Vec2> = self.points.iter().map(|p| *p - drawn.centroid).collect();
        let shape = Shape::of_chain(&chain(&points)).unwrap();
        let body = Body { shape, mass: 1.0, inertia: drawn.gyration_squared };
        let plate = |[a, b]: &[Vec2; 2]| Obstacle::new(*a, *b, self.friction, self.restitution);
        (
            World::of_one(Vec2::new(0.0, -GRAVITY), body, self.plates.iter().map(plate).collect(), self.law),
            points,
        )
    }

    fn run(&self, until: f64) -> (World, Vec<Vec2>, Result<(Trace, Happening), MotionError>) {
        let (world, points) = self.world();
        let walk = || {
            let options = Options { most_time: until, ..Options::default() };
            let mut walker = Walker::new(&world, self.start, vec![], options)?;
            let mut recorder = Recorder::default();
            loop {
                let happening = walker.advance(&mut recorder)?;
                if happening != Happening::Moves {
                    return Ok((recorder.into_trace(), happening));
                }
            }
        };
        let walked = walk();
        (world, points, walked)
    }
}

/// How deep a segment lies in a triangle [m], by the axes that can part the two: an independent method.
fn depth(triangle: [Vec2; 3], [from, to]: [Vec2; 2]) -> f64 {
    let mut axes: Vec<Vec2> = (0..3).map(|i| (triangle[(i + 1) % 3] - triangle[i]).turned_right()).collect();
    axes.extend([(to - from).turned_right(), (from - to).turned_right()]);
    let parted = |axis: &Vec2| {
        let axis = *axis / axis.norm();
        let inside = triangle.iter().map(|p| axis.dot(*p)).fold(f64::NEG_INFINITY, f64::max);
        inside - axis.dot(from).min(axis.dot(to))
    };
    axes.iter().map(parted).fold(f64::INFINITY, f64::min)
}

/// How deep a part, cut into triangles about its rays' middle, lies in a plate.
fn deepest(points: &[Vec2], middle: Vec2, pose: &Pose, plate: [Vec2; 2]) -> f64 {
    let (sin, cos) = sin_cos(pose.angle);
    let placed = |p: Vec2| pose.centre + p.rotated(cos, sin);
    let corner = |i: usize| placed(points[i % points.len()]);
    (0..points.len())
        .map(|i| depth([placed(middle), corner(i), corner(i + 1)], plate))
        .fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn energy_never_grows_and_nothing_overlaps() {
    let faults: Vec<String> = (0..PARTS)
        .into_par_iter()
        .filter_map(|seed| {
            let case = Case::random(seed);
            let (world, points, walked) = case.run(3.0);
            let (trace, _) = match walked {
                Ok(walked) => walked,
                Err(error) => return Some(format!("{seed}: {error}")),
            };
            let size = world.bodies[0].shape.size();
            let middle = points[0] - case.points[0];
            let (mut energy, mut before) = (f64::INFINITY, 0.0);
            for piece in &trace.pieces {
                let closes = |to: f64| to >= before && to <= piece.end_time;
                let closed = trace.accumulations.iter().any(|series| closes(series.1));
                let growth = if closed { CLOSED } else { NOTHING } * size * GRAVITY;
                before = piece.start_time;
                for state in [&piece.start, &piece.end] {
                    let here = world.energy(&[*state]);
                    if here > energy + growth {
                        return Some(format!(
                            "{seed}: energy grows by {:e} at {}",
                            here - energy,
                            piece.start_time
                        ));
                    }
                    energy = here;
                }
                for sample in &piece.samples {
                    for plate in &case.plates {
                        let depth = deepest(&points, middle, &sample.state.pose, *plate);
                        if depth > NOTHING * size {
                            return Some(format!("{seed}: overlaps by {depth:e} at {}", sample.time));
                        }
                    }
                }
            }
            // Where a contact is held, the independent method sees a touch.
            for piece in trace.pieces.iter().filter(|p| !p.held.is_empty()) {
                let touches = piece.held.iter().all(|h| {
                    deepest(&points, middle, &piece.start.pose, case.plates[h.obstacle]) > -NOTHING * size
                });
                if !touches {
                    return Some(format!("{seed}: holds what does not touch at {}", piece.start_time));
                }
            }
            None
        })
        .collect();
    assert!(faults.is_empty(), "{} of {PARTS}: {:#?}", faults.len(), &faults[..faults.len().min(12)]);
}

#[test]
fn mirrored_and_scaled_copies_do_the_same() {
    let faults: Vec<String> = (0..PARTS)
        .into_par_iter()
        .filter_map(|seed| {
            let case = Case::random(seed);
            let (_, _, own) = case.run(3.0);
            let (own, _) = own.ok()?;
            for (scale, mirrored) in [(1.0, true), (4.0, false)] {
                let (_, _, other) = case.like(scale, mirrored).run(3.0 * scale.sqrt());
                let (other, _) = other.ok()?;
                // Each impact doubles what rounding has made different, or more: the first ones are compared.
                for (i, (a, b)) in own.impacts.iter().zip(&other.impacts).take(4).enumerate() {
                    let time = (a.time - b.time / scale.sqrt()).abs();
                    let side = if mirrored { -1.0 } else { 1.0 };
                    let spin = (a.after.spin - side * b.after.spin * scale.sqrt()).abs();
                    if time > ALIKE || spin > 1e3 * ALIKE * (1.0 + a.after.spin.abs()) {
                        return Some(format!(
                            "{seed} × {scale} {mirrored}: impact {i} differs by {time:e} s, {spin:e}/s"
                        ));
                    }
                }
            }
            None
        })
        .collect();
    assert!(faults.is_empty(), "{} of {PARTS}: {:#?}", faults.len(), &faults[..faults.len().min(12)]);
}
