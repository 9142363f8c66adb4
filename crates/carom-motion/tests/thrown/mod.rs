//! Polyhedra that are thrown on the plane, read from a file of throws.

use carom_motion::spatial::{Body, Friction, Polyhedron, State, Supports, World};
use carom_num::{Rotation, Vec3};

const G: f64 = 9.81;
/// Corners closer to a face than this, in units of the largest coordinate, lie in it: what is left of decimal digits.
const FLAT: f64 = 1e-10;

/// How a body is thrown.
#[derive(Clone, Debug)]
pub(crate) struct Throw {
    pub(crate) friction: f64,
    pub(crate) restitution: f64,
    pub(crate) mass: f64,
    pub(crate) attitude: Rotation,
    pub(crate) height: f64,
    pub(crate) velocity: Vec3,
    pub(crate) spin: Vec3,
    pub(crate) corners: Vec<Vec3>,
}

/// A throw as it is followed.
pub(crate) struct Thrown {
    pub(crate) hull: Polyhedron,
    pub(crate) world: World,
    pub(crate) start: State,
}

impl Throw {
    /// One of the throws of `data/thrown.txt`.
    pub(crate) fn named(name: &str) -> Self {
        let line = include_str!("../data/thrown.txt").lines().find(|line| line.starts_with(name)).unwrap();
        let mut numbers = line.split_whitespace().skip(1).map(|word| word.parse::<f64>().unwrap());
        let mut next = || numbers.next();
        let mut one = || next().unwrap();
        let (friction, restitution, mass) = (one(), one(), one());
        let mut triple = || Vec3::new(one(), one(), one());
        let axis = triple().unit().unwrap();
        let attitude = Rotation::by(axis * one());
        let height = one();
        let mut triple = || Vec3::new(one(), one(), one());
        let (velocity, spin) = (triple(), triple());
        let mut corners = vec![];
        while let (Some(x), Some(y), Some(z)) = (next(), next(), next()) {
            corners.push(Vec3::new(x, y, z));
        }
        Self { friction, restitution, mass, attitude, height, velocity, spin, corners }
    }

    /// The same body, its corners numbered from another one on, and backwards where that is odd.
    pub(crate) fn renumbered(mut self, from: usize) -> Self {
        let count = self.corners.len();
        self.corners.rotate_left(from % count);
        if from % 2 == 1 {
            self.corners.reverse();
        }
        self
    }

    pub(crate) fn ready(&self) -> Thrown {
        let largest = self.corners.iter().flat_map(|r| r.to_array()).map(f64::abs).fold(0.0, f64::max);
        let hull = Polyhedron::of_points(&self.corners, FLAT * largest).unwrap();
        let solid = hull.solid().unwrap();
        let supports: Vec<Vec3> = hull.vertices().iter().map(|r| *r - solid.centre).collect();
        let inertia = solid.inertia * (self.mass / solid.volume);
        let lowest = supports.iter().map(|r| self.attitude.apply(*r).z).fold(f64::INFINITY, f64::min);
        let body = Body::new(self.mass, inertia, supports).unwrap();
        let friction = Friction::new(self.friction).with_restitution(self.restitution);
        let start = State {
            centre: Vec3::Z * (self.height - lowest),
            attitude: self.attitude,
            velocity: self.velocity,
            spin: self.spin,
        };
        Thrown {
            hull,
            world: World::new(body, Vec3::Z * -G).unwrap().with_friction(friction).unwrap(),
            start,
        }
    }
}

impl Thrown {
    /// The places, in the axes of the drawing, of supports: the same however they are numbered.
    pub(crate) fn places(&self, held: Supports) -> Vec<[f64; 3]> {
        let mut places: Vec<[f64; 3]> = held.iter().map(|i| self.hull.vertices()[i].to_array()).collect();
        places.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2])));
        places
    }
}
