//! Bodies that fall flat on four to six feet while they slide: they have one way on, and it does not hang on how feet are numbered.

use carom_impact::Law;
use carom_impact::spatial::{ContactSet, Preference, RigidBody, Touch, staged};
use carom_num::elementary::sin_cos;
use carom_num::{Mat3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::f64::consts::TAU;

const BODIES: u64 = 24;
/// Feet in another order end in the same motion but for rounding, as a share of the fall.
const SAME: f64 = 1e-9;

struct Falling {
    body: RigidBody,
    feet: Vec<Touch>,
}

/// A body on feet around a circle, no two alike, that falls with 1 m/s, slides and spins about the vertical.
fn falling(seed: u64) -> Falling {
    let mut random = Pcg64::seed_from_u64(seed);
    let count = [4, 5, 6][random.random_range(0..3)];
    let height = random.random_range(0.05..0.3);
    let friction = random.random_range(0.1..0.6);
    let feet = (0..count).map(|k| {
        let (sin, cos) = sin_cos(TAU * (f64::from(k) + random.random_range(-0.2..0.2)) / f64::from(count));
        let radius = random.random_range(0.2..0.3);
        Touch {
            arm: Vec3::new(radius * cos, radius * sin, -height),
            normal: Vec3::Z,
            friction,
            restitution: 0.0,
        }
    });
    let feet = feet.collect();
    let mut across = || random.random_range(-1.0..1.0);
    let velocity = Vec3::new(across(), across(), -1.0);
    let spin = Vec3::Z * (5.0 * across());
    Falling { body: RigidBody { mass: 1.0, inertia: Mat3::diagonal(0.02, 0.03, 0.04), velocity, spin }, feet }
}

/// The body's velocity and spin after the impact, and how many ways on there were; `None` where it is refused.
fn after(falling: &Falling, order: &[usize], preference: Preference) -> Option<([Vec3; 2], usize)> {
    let feet: Vec<Touch> = order.iter().map(|k| falling.feet[*k]).collect();
    let set = ContactSet::<6>::of_free_body(&falling.body, &feet).unwrap();
    let out = staged::resolve_observed(&set, Law::Poisson, preference, &mut |_| {}).ok()?;
    let RigidBody { mass, inertia, mut velocity, mut spin } = falling.body;
    for (touch, (frame, impulse)) in feet.iter().zip(set.frame.iter().zip(&out.impulse)) {
        let impulse = frame.transposed() * *impulse;
        velocity += impulse / mass;
        spin += inertia.inverse().unwrap() * touch.arm.cross(impulse);
    }
    Some(([velocity, spin], out.branches))
}

#[test]
fn bodies_that_fall_flat_do_not_know_how_their_feet_are_numbered() {
    for seed in 0..BODIES {
        let falling = falling(seed);
        let n = falling.feet.len();
        for preference in [Preference::MostOpen, Preference::MostKept] {
            let own: Vec<usize> = (0..n).collect();
            let first = after(&falling, &own, preference);
            for from in 0..n {
                let turned: Vec<usize> = (0..n).map(|k| (k + from) % n).collect();
                let back: Vec<usize> = turned.iter().rev().copied().collect();
                for order in [turned, back] {
                    let other = after(&falling, &order, preference);
                    assert_eq!(first.is_some(), other.is_some(), "seed {seed}, {order:?}: one is refused");
                    let (Some((a, _)), Some((b, _))) = (first, other) else { continue };
                    let off = (a[0] - b[0]).norm() + (a[1] - b[1]).norm() * 0.2;
                    assert!(off < SAME, "seed {seed}, {preference:?}, {order:?}: {a:?} is not {b:?}");
                }
            }
            let branches = first.map(|(_, branches)| branches);
            assert_eq!(branches, Some(1), "seed {seed}: how a face shares its load is no way on");
        }
    }
}
