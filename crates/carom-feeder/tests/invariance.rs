//! The same feeder seen in a mirror, turned, in other units, with its obstacles in another order: the same run.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_feeder::{Feeder, Outcome, PartKind, Run};
use carom_motion::planar::trace::{PieceEnd, Trace};
use carom_motion::planar::{
    Body, Happening, Obstacle, Options, Pose, Recorder, Shape, State, Twist, Walker, World,
};
use carom_num::Vec2;

/// Impacts up to which rounding cannot have grown to something that shows.
const FEW_IMPACTS: u64 = 8;
/// Margin below which rounding may decide otherwise.
const CLEAR: f64 = 1e-6;

fn runs(seeds: std::ops::Range<u64>) -> impl Iterator<Item = (u64, Feeder, Run)> {
    seeds.filter_map(|seed| {
        let feeder = random::feeder(seed);
        let run = feeder.run().ok()?;
        (run.effort.impacts <= FEW_IMPACTS && run.margin > CLEAR).then_some((seed, feeder, run))
    })
}

fn mirrored(feeder: &Feeder) -> Feeder {
    let flip = |v: Vec2| Vec2::new(-v.x, v.y);
    let mut out = feeder.clone();
    let shape = &feeder.part.body.shape;
    // Vertices run counter-clockwise again; face f becomes face k − 2 − f.
    let vertices: Vec<Vec2> = shape.vertices().iter().rev().map(|v| flip(*v)).collect();
    let k = vertices.len();
    out.part.body.shape = Shape::new(vertices, shape.radius()).unwrap();
    if feeder.part.kind != PartKind::Disc {
        out.start.face = (2 * k - 2 - feeder.start.face) % k;
    }
    for plate in &mut out.plates {
        (plate.uphill, plate.edge) = (flip(plate.uphill), flip(plate.edge));
    }
    for wall in &mut out.walls {
        (wall.from, wall.to) = (flip(wall.from), flip(wall.to));
    }
    out
}

#[test]
fn a_mirror_image_runs_like_its_original() {
    let mut compared = 0;
    for (seed, feeder, run) in runs(0..600) {
        if feeder.part.kind == PartKind::Box {
            // Its faces are numbered by kind; the mirror renumbers them.
            continue;
        }
        let image = mirrored(&feeder).run().unwrap();
        assert_eq!(run.outcome, image.outcome, "seed {seed}");
        assert!(
            (run.end_time - image.end_time).abs() < 1e-7 * run.end_time.max(1.0),
            "seed {seed}: {} {}",
            run.end_time,
            image.end_time
        );
        assert_eq!(run.landings.len(), image.landings.len(), "seed {seed}");
        let k = feeder.part.body.shape.vertices().len();
        for (a, b) in run.landings.iter().zip(&image.landings) {
            assert_eq!(a.face.map(|f| (2 * k - 2 - f) % k), b.face, "seed {seed}");
        }
        compared += 1;
    }
    println!("{compared} mirror images run like their originals");
    assert!(compared > 200, "{compared}");
}

#[test]
fn units_scale_out_to_the_last_bit() {
    // Lengths by 4 and times by 2 leave gravity as it is and only change exponents.
    let mut compared = 0;
    for seed in 0..400 {
        let feeder = random::feeder(seed);
        let Ok(run) = feeder.run_untraced() else { continue };
        let mut large = feeder.clone();
        let four = |v: Vec2| v * 4.0;
        let vertices = feeder.part.body.shape.vertices().iter().map(|v| four(*v)).collect();
        let shape = Shape::new(vertices, 4.0 * feeder.part.body.shape.radius()).unwrap();
        large.part.body =
            Body { shape, mass: 8.0 * feeder.part.body.mass, inertia: 128.0 * feeder.part.body.inertia };
        large.start.to_edge *= 4.0;
        large.start.speed *= 2.0;
        for plate in &mut large.plates {
            (plate.uphill, plate.edge) = (four(plate.uphill), four(plate.edge));
        }
        for wall in &mut large.walls {
            (wall.from, wall.to) = (four(wall.from), four(wall.to));
        }
        let other = large.run_untraced().unwrap();
        assert_eq!(run.outcome, other.outcome, "seed {seed}");
        assert_eq!(2.0 * run.end_time, other.end_time, "seed {seed}");
        assert_eq!(run.effort, other.effort, "seed {seed}");
        compared += 1;
    }
    println!("{compared} feeders run alike in other units, to the last bit");
    assert!(compared > 300, "{compared}");
}

fn walk(world: &World, start: State) -> (Trace, Happening) {
    let up = -world.gravity;
    let sides = world.obstacles.iter().map(|o| o.direction().turned_left().dot(up) > 0.0).collect();
    let mut walker = Walker::new(world, start, sides, Options::default()).unwrap();
    let mut recorder = Recorder::default();
    loop {
        let happening = walker.advance(&mut recorder).unwrap();
        if happening != Happening::Moves {
            return (recorder.into_trace(), happening);
        }
    }
}

fn ends(trace: &Trace) -> impl Iterator<Item = (f64, PieceEnd)> + '_ {
    trace.pieces.iter().map(|p| (p.end_time, p.ended_by))
}

fn few(trace: &Trace) -> bool {
    trace.impacts.len() <= 8
}

#[test]
fn a_turned_world_runs_like_the_upright_one() {
    let mut compared = 0;
    for (seed, feeder, _) in runs(0..300) {
        let prepared = feeder.prepare(Options::default()).unwrap();
        let (world, start) = (prepared.world().clone(), feeder.start_state());
        let (original, end) = walk(&world, start);
        let (angle, by) = (1.234, Vec2::new(0.3, -0.7));
        let axis = Vec2::at_angle(angle);
        let turn = |v: Vec2| v.rotated(axis.x, axis.y);
        let obstacles = world
            .obstacles
            .iter()
            .map(|o| Obstacle::new(turn(o.from()) + by, turn(o.to()) + by, o.friction, o.restitution))
            .collect();
        let turned = World { gravity: turn(world.gravity), obstacles, ..world };
        let pose = Pose { centre: turn(start.pose.centre) + by, angle: start.pose.angle + angle };
        let twist = Twist { velocity: turn(start.twist.velocity), spin: start.twist.spin };
        let (image, other_end) = walk(&turned, State { pose, twist });
        if !few(&original) {
            continue;
        }
        assert_eq!(end, other_end, "seed {seed}");
        for ((t, _), (u, _)) in ends(&original).zip(ends(&image)) {
            // The step control looks at components, which turn: its error is amplified by the impacts.
            assert!((t - u).abs() < 1e-6 * t.max(1.0), "seed {seed}: {t} {u}");
        }
        compared += 1;
    }
    println!("{compared} turned worlds run like the upright ones");
    assert!(compared > 100, "{compared}");
}

#[test]
fn the_order_of_obstacles_does_not_matter() {
    let mut compared = 0;
    for (seed, feeder, run) in runs(0..300) {
        if run.outcome == Outcome::NeverFlat {
            continue;
        }
        let prepared = feeder.prepare(Options::default()).unwrap();
        let (world, start) = (prepared.world().clone(), feeder.start_state());
        let (original, end) = walk(&world, start);
        let mut reversed = world.clone();
        reversed.obstacles.reverse();
        let (image, other_end) = walk(&reversed, start);
        assert_eq!(end, other_end, "seed {seed}");
        for ((t, _), (u, _)) in ends(&original).zip(ends(&image)) {
            assert!((t - u).abs() < 1e-8 * t.max(1.0), "seed {seed}: {t} {u}");
        }
        compared += 1;
    }
    println!("{compared} worlds run alike with their obstacles in reverse order");
    assert!(compared > 100, "{compared}");
}
