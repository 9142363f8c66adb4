//! Numbers drawn from wide ranges.

use carom_impact::Law;
use carom_impact::planar::Touch;
use carom_num::Vec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// The random numbers of one case: they depend on the seed and its number alone.
pub(crate) fn numbers(seed: u64, case: u64) -> Pcg64 {
    Pcg64::seed_from_u64(seed ^ case.wrapping_mul(0x9e37_79b9_7f4a_7c15))
}

pub(crate) fn between(rng: &mut Pcg64, a: f64, b: f64) -> f64 {
    rng.random_range(a..b)
}

/// Evenly in the logarithm.
pub(crate) fn across(rng: &mut Pcg64, a: f64, b: f64) -> f64 {
    carom_num::elementary::exp(between(rng, carom_num::elementary::ln(a), carom_num::elementary::ln(b)))
}

/// 0 in one of eight cases, up to 10 in the others, mostly below 1.
pub(crate) fn friction(rng: &mut Pcg64) -> f64 {
    match rng.random_range(0..8) {
        0 => 0.0,
        1 => between(rng, 1.0, 10.0),
        _ => between(rng, 0.0, 1.0),
    }
}

/// 0 and 1 among them.
pub(crate) fn restitution(rng: &mut Pcg64) -> f64 {
    match rng.random_range(0..6) {
        0 => 0.0,
        1 => 1.0,
        _ => between(rng, 0.0, 1.0),
    }
}

/// A law under which energy cannot grow.
pub(crate) fn law(rng: &mut Pcg64) -> Law {
    if rng.random_bool(0.5) { Law::Poisson } else { Law::Stronge }
}

/// A speed from 1 mm/s to 100 m/s, either way.
pub(crate) fn speed(rng: &mut Pcg64) -> f64 {
    let size = across(rng, 1e-3, 100.0);
    if rng.random_bool(0.5) { size } else { -size }
}

/// A slender or a stout body: mass from 1e-9 to 1e6 kg, thickness from 1e-4 of its half length, and its inertia as a box.
pub(crate) struct Box2 {
    pub(crate) mass: f64,
    pub(crate) inertia: f64,
    pub(crate) half: Vec2,
}

pub(crate) fn slender(rng: &mut Pcg64) -> Box2 {
    let (mass, long) = (across(rng, 1e-9, 1e6), across(rng, 1e-3, 10.0));
    let half = Vec2::new(long, long * across(rng, 1e-4, 1.0));
    Box2 { mass, inertia: mass * half.dot(half) / 3.0, half }
}

/// A place on the body's outline and a normal that points inwards there.
pub(crate) fn touch(rng: &mut Pcg64, body: &Box2) -> Touch {
    let corner = |rng: &mut Pcg64| if rng.random_bool(0.5) { 1.0 } else { -1.0 };
    let (x, y) = (corner(rng), corner(rng));
    // At a corner, in any direction that keeps the box on one side; or along a long face.
    let arm = if rng.random_bool(0.6) { Vec2::new(x, y) } else { Vec2::new(between(rng, -1.0, 1.0), y) };
    let turn = if arm.x.abs() == 1.0 { between(rng, 0.0, std::f64::consts::FRAC_PI_2) } else { 0.0 };
    let normal = Vec2::at_angle(turn);
    let normal = Vec2::new(-x * normal.y, -y * normal.x);
    let arm = Vec2::new(arm.x * body.half.x, arm.y * body.half.y);
    Touch { arm, normal, friction: friction(rng), restitution: restitution(rng) }
}
