//! Moments of inertia of solids on a regular polygon.

use carom_num::elementary::sin;
use std::f64::consts::PI;

/// Moments about the mass centre across and along the axis [kg m²].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moments {
    pub(super) across: f64,
    pub(super) along: f64,
}

/// q = 1 − (2/3) sin²(π/n): a regular polygon of area A and circumradius a has the second moment A a² q/4 about every axis in its plane through
/// its middle; q is 1 for a circle.
fn polygon(sides: u32) -> f64 {
    let sin = sin(PI / f64::from(sides));
    1.0 - 2.0 / 3.0 * sin * sin
}

/// Of a prism on a polygon: `m a² q/4 + m H²/12` and `m a² q/2`.
pub(super) fn prism(mass: f64, sides: u32, circumradius: f64, height: f64) -> Moments {
    let base = mass * circumradius * circumradius * polygon(sides);
    Moments { across: 0.25 * base + mass * height * height / 12.0, along: 0.5 * base }
}

/// Of a pyramid on a polygon, whose mass centre is at a quarter of its height: `3 m a² q/20 + 3 m h²/80` and `3 m a² q/10`.
pub(super) fn pyramid(mass: f64, sides: u32, circumradius: f64, height: f64) -> Moments {
    let base = mass * circumradius * circumradius * polygon(sides);
    Moments { across: 0.15 * base + 0.0375 * mass * height * height, along: 0.3 * base }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cube_and_a_regular_tetrahedron_have_one_moment() {
        // Circumradius and height for the edge 1: m/6 and m/20.
        let cube = prism(6.0, 4, 0.5_f64.sqrt(), 1.0);
        let tetrahedron = pyramid(20.0, 3, (1.0_f64 / 3.0).sqrt(), (2.0_f64 / 3.0).sqrt());
        for moment in [cube.across, cube.along, tetrahedron.across, tetrahedron.along] {
            assert!((moment - 1.0).abs() < 4.0 * f64::EPSILON, "{moment}");
        }
    }
}
