//! Bodies that rock on feet of unequal friction.

use carom_impact::Load;
use carom_impact::spatial::{ContactSet, RateProblem, RigidBody, Touch};
use carom_num::elementary::exp;
use carom_num::{Mat3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::f64::consts::LN_10;

/// Velocities that are zero but for rounding, as a share of the largest.
pub(crate) const ROUNDING: f64 = 1e-13;

/// A body over a plane: mass, principal moments, velocity and spin, height of the mass centre, and of each foot where it is and its friction.
pub(crate) fn on_feet<const N: usize>(
    mass: f64,
    [moments, velocity, spin]: [[f64; 3]; 3],
    height: f64,
    feet: &[[f64; 3]],
) -> ContactSet<N> {
    let [a, b, c] = moments;
    let [velocity, spin] = [velocity, spin].map(Vec3::from_array);
    let body = RigidBody { mass, inertia: Mat3::diagonal(a, b, c), velocity, spin };
    let touch = |&[x, y, friction]: &[f64; 3]| Touch {
        arm: Vec3::new(x, y, -height),
        normal: Vec3::Z,
        friction,
        restitution: 0.0,
    };
    ContactSet::of_free_body(&body, &feet.iter().map(touch).collect::<Vec<_>>()).unwrap()
}

/// What the first stage of an impact asks.
pub(crate) fn first_question<const N: usize>(set: &ContactSet<N>) -> RateProblem<'_, N> {
    let touches = |i: usize| i < set.count && set.velocity[i].z <= 0.0;
    RateProblem {
        count: set.count,
        operator: &set.operator,
        friction: &set.friction,
        drive: set.velocity.map(|u| Vec3::Z * u.z.min(0.0)),
        slip: set.velocity.map(|u| [u.x, u.y]),
        load: std::array::from_fn(|i| if touches(i) { Load::Touching(0.0) } else { Load::Absent }),
    }
}

pub(crate) fn without_rounding<const N: usize>(mut set: ContactSet<N>) -> ContactSet<N> {
    let fastest = set.velocity.iter().map(|u| u.norm()).fold(0.0, f64::max);
    let zero = |u: f64| if u.abs() <= ROUNDING * fastest { 0.0 } else { u };
    set.velocity = set.velocity.map(|u| Vec3::new(zero(u.x), zero(u.y), zero(u.z)));
    set
}

/// A body that turns about two feet, or about one, as the third strikes and others rise or strike as well; frictions differ by up to 25 times.
pub(crate) fn rocking<const N: usize>(seed: u64) -> ContactSet<N> {
    let mut random = Pcg64::seed_from_u64(seed);
    let mut number = |low: f64, high: f64| random.random_range(low..high);
    let (a, b, share) = (number(0.03, 0.4), number(0.03, 0.4), number(0.05, 0.95));
    let c = (a - b).abs() + (a + b - (a - b).abs()) * share;
    let (mass, height) = (number(0.3, 1.0), number(0.1, 1.2));
    let feet: [[f64; 3]; N] =
        std::array::from_fn(|_| [number(-1.5, 1.5), number(-1.5, 1.5), exp(LN_10 * number(-1.0, 0.4))]);
    let arm = |i: usize| Vec3::new(feet[i][0], feet[i][1], -height);
    let about_two = number(0.0, 1.0) < 0.7;
    let any = Vec3::new(number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 1.0));
    let spin = if about_two { (arm(1) - arm(0)) * number(0.3, 2.0) } else { any };
    let strikes = spin.cross(arm(2) - arm(0)).z < 0.0;
    let spin = if strikes { spin } else { -spin };
    let velocity = -spin.cross(arm(0));
    without_rounding(on_feet(mass, [[a, b, c], velocity.to_array(), spin.to_array()], height, &feet))
}
