//! On which sides parts in the plane come to rest.

#![allow(clippy::print_stdout, reason = "how often parts rest on which side is a measurement")]

use carom_impact::Law;
use carom_motion::planar::{
    Body, ChainPoint, MassProperties, Obstacle, Options, Pose as Place, Shape, State, World,
};
use carom_num::Vec2;
use carom_num::elementary::{cos, sin};
use carom_study::poses::{Plan, Pose, Poses, sample, thrown_in_plane};
use std::f64::consts::TAU;
use std::sync::atomic::{AtomicU64, Ordering};

struct Thrown {
    shape: Shape,
    world: World,
}

impl Thrown {
    /// A part of these corners on rough ground that gives nothing back.
    fn new(corners: &[(f64, f64)], friction: f64, restitution: f64) -> Self {
        let chain: Vec<ChainPoint> =
            corners.iter().map(|(x, y)| ChainPoint::straight(Vec2::new(*x, *y))).collect();
        let drawn = Shape::of_chain(&chain).unwrap();
        let mass = MassProperties::of(&drawn);
        let shape = drawn.shifted(-mass.centroid);
        let body = Body { shape: shape.clone(), mass: mass.area, inertia: mass.area * mass.gyration_squared };
        let ground = Obstacle::new(Vec2::new(-1e3, 0.0), Vec2::new(1e3, 0.0), friction, restitution);
        Self { shape, world: World::of_one(Vec2::new(0.0, -9.81), body, vec![ground], Law::Poisson) }
    }

    /// Throws in any attitude, and how many of them do not come to rest where a part that rolls on rough ground does.
    fn thrown(&self, throws: u64, height: f64) -> (Poses, u64) {
        let unlike = AtomicU64::new(0);
        let throw = |point: &[f64]| {
            let down = Vec2::at_angle(TAU * point[0]);
            let centre = Vec2::new(0.0, height + self.shape.centre_height(down));
            let pose = Place { centre, angle: 0.75 * TAU - TAU * point[0] };
            let thrown =
                thrown_in_plane((&self.world, &Options::default()), &State { pose, ..State::default() });
            if thrown.pose != Pose::Face(self.rolls_to(down)) {
                unlike.fetch_add(1, Ordering::Relaxed);
            }
            thrown
        };
        let faces: Vec<usize> = (0..self.shape.rests().len()).collect();
        let found = sample(&Plan { dimensions: 1, throws, seed: 1 }, throw, &faces, || ()).unwrap();
        (found, unlike.into_inner())
    }
}

impl Thrown {
    /// The side on which the part comes to rest when it is let go in touch with rough ground that gives nothing back: it turns about a corner until the
    /// next one strikes. There the angular momentum about the corner that strikes stays, ω′ (I + m b²) = ω (I + m a·b), with a and b from the corners to the
    /// mass centre; the part rolls on where what is left lifts its mass centre over the new corner.
    fn rolls_to(&self, down: Vec2) -> usize {
        let (rests, body) = (self.shape.rests(), &self.world.bodies[0]);
        let (inertia, mass) = (body.inertia, body.mass);
        let weight = mass * 9.81;
        // Down lies between the normals of two sides that meet in the corner on which the part stands.
        let after = (0..rests.len()).find(|i| {
            let before = rests[(i + rests.len() - 1) % rests.len()].normal;
            before.cross(down) >= 0.0 && down.cross(rests[*i].normal) >= 0.0
        });
        let after = after.unwrap();
        let forward = -rests[after].from.dot(down.turned_left()) > 0.0;
        let mut side = if forward { after } else { (after + rests.len() - 1) % rests.len() };
        let mut energy = weight * self.shape.centre_height(down);
        loop {
            let rest = rests[side];
            let (left, strikes) = if forward { (rest.from, rest.to) } else { (rest.to, rest.from) };
            let [of_left, of_strikes] = [left, strikes].map(|corner| inertia + mass * corner.dot(corner));
            let kept = (inertia + mass * left.dot(strikes)).max(0.0);
            let moving = (energy - weight * rest.depth) * kept * kept / (of_left * of_strikes);
            energy = moving + weight * rest.depth;
            // Where the mass centre is beyond that corner already nothing keeps it.
            if rest.inside()[usize::from(forward)] > 0.0 && energy <= weight * strikes.norm() {
                return side;
            }
            side = (side + if forward { 1 } else { rests.len() - 1 }) % rests.len();
        }
    }
}

const BAR: [(f64, f64); 4] = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)];
const L: [(f64, f64); 6] = [(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];

#[test]
fn what_is_let_go_gently_rolls_until_it_rests() {
    let hexagon: Vec<(f64, f64)> =
        (0..6).map(|i| TAU * f64::from(i) / 6.0).map(|a| (cos(a), 1.4 * sin(a))).collect();
    for (name, corners) in [("bar", &BAR[..]), ("L", &L[..]), ("hexagon", &hexagon)] {
        let part = Thrown::new(corners, 20.0, 0.0);
        let (found, unlike) = part.thrown(64, 0.0);
        assert_eq!(found.resting.count, found.throws, "{name}: every throw comes to rest");
        for (end, rest) in found.ends.iter().zip(part.shape.rests()) {
            println!("{name} {:?}: {:.4}, by its basin {:.4}", end.pose, end.probability.share, rest.share());
        }
        assert_eq!(unlike, 0, "{name}: each throw where the closed form brings it");
    }
}

/// From a height a bar comes to rest on its long sides more often than it is turned towards them, on both of them alike.
#[test]
fn a_bar_that_falls_prefers_its_long_sides() {
    let part = Thrown::new(&BAR, 0.3, 0.5);
    let (found, _) = part.thrown(64, 4.0);
    let shares: Vec<f64> = found.ends.iter().map(|end| end.probability.share).collect();
    println!("bar from twice its length: {shares:.3?}");
    assert_eq!(found.resting.count, found.throws, "every throw comes to rest");
    assert!(shares[0] + shares[2] > 2.0 * part.shape.rests()[0].share(), "{shares:?}");
    assert!((shares[0] - shares[2]).abs() < 0.05, "a half turn changes nothing: {shares:?}");
}
