//! Random bodies, drawn from a seeded stream.

use carom_num::elementary::pow;
use carom_theory::rocking::{Cylinder, Prism, SupportedRod};
use rand::RngExt;
use rand_pcg::Pcg64;

pub fn restitution(rng: &mut Pcg64) -> f64 {
    match rng.random_range(0..8) {
        0 | 1 => 0.0,
        2 => 1.0,
        _ => rng.random_range(0.0..1.0),
    }
}

pub fn cylinder(rng: &mut Pcg64) -> Cylinder {
    Cylinder {
        mass: pow(10.0, rng.random_range(-1.0..1.0)),
        radius: pow(10.0, rng.random_range(-1.0..1.0)),
        inertia_ratio: [1.0, 0.5, 0.4, rng.random_range(0.02..1.0)][rng.random_range(0..4)],
        friction: rng.random_range(0.0..2.0) * [0.3, 1.0][rng.random_range(0..2)],
        half_angle: rng.random_range(0.5f64..89.5).to_radians(),
    }
}

pub fn prism(rng: &mut Pcg64) -> Prism {
    Prism {
        mass: rng.random_range(0.1..10.0),
        inertia: pow(10.0, rng.random_range(-2.0..1.0)),
        to_centre: rng.random_range(0.05..2.0),
        to_k: rng.random_range(0.05..2.0),
        height: rng.random_range(0.05..2.0),
        friction: rng.random_range(0.0..2.0),
    }
}

pub fn rod(rng: &mut Pcg64) -> SupportedRod {
    SupportedRod {
        mass: rng.random_range(0.1..10.0),
        inertia: pow(10.0, rng.random_range(-2.0..1.0)),
        to_a: rng.random_range(0.0..1.0),
        to_b: rng.random_range(0.01..1.0),
    }
}

/// A factor at or beside 1: none one time in five, else off by 1e-16 to 1e-6.
pub fn beside(rng: &mut Pcg64) -> f64 {
    let sign = [-1.0, 1.0][rng.random_range(0..2)];
    if rng.random_range(0..5) == 0 { 1.0 } else { 1.0 + sign * pow(10.0, rng.random_range(-16.0..-6.0)) }
}
