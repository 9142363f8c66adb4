//! The units of each dimension, the SI unit first.

use super::{PI, Unit};

const fn unit(symbol: &'static str, numerator: f64, denominator: f64) -> Unit {
    Unit { symbol, numerator, denominator }
}

pub(super) const LENGTH: &[Unit] = &[
    unit("m", 1.0, 1.0),
    unit("mm", 1.0, 1e3),
    unit("cm", 1.0, 1e2),
    unit("um", 1.0, 1e6),
    unit("in", 127.0, 5e3),
    unit("ft", 1524.0, 5e3),
];
pub(super) const ANGLE: &[Unit] = &[unit("rad", 1.0, 1.0), unit("deg", PI, 180.0)];
pub(super) const MASS: &[Unit] = &[unit("kg", 1.0, 1.0), unit("g", 1.0, 1e3), unit("lb", 45_359_237.0, 1e8)];
pub(super) const TIME: &[Unit] = &[unit("s", 1.0, 1.0), unit("ms", 1.0, 1e3), unit("min", 60.0, 1.0)];
pub(super) const SPEED: &[Unit] = &[
    unit("m/s", 1.0, 1.0),
    unit("mm/s", 1.0, 1e3),
    unit("cm/s", 1.0, 1e2),
    unit("in/s", 127.0, 5e3),
    unit("ft/s", 1524.0, 5e3),
];
pub(super) const SPIN: &[Unit] = &[unit("rad/s", 1.0, 1.0), unit("deg/s", PI, 180.0), unit("rpm", PI, 30.0)];
pub(super) const ACCELERATION: &[Unit] = &[
    unit("m/s^2", 1.0, 1.0),
    unit("mm/s^2", 1.0, 1e3),
    unit("cm/s^2", 1.0, 1e2),
    unit("in/s^2", 127.0, 5e3),
    unit("ft/s^2", 1524.0, 5e3),
];
pub(super) const INERTIA: &[Unit] = &[
    unit("kg m^2", 1.0, 1.0),
    unit("kg mm^2", 1.0, 1e6),
    unit("kg cm^2", 1.0, 1e4),
    unit("g m^2", 1.0, 1e3),
    unit("g mm^2", 1.0, 1e9),
    unit("g cm^2", 1.0, 1e7),
];
pub(super) const DENSITY: &[Unit] = &[
    unit("kg/m^3", 1.0, 1.0),
    unit("g/cm^3", 1e3, 1.0),
    unit("g/mm^3", 1e6, 1.0),
    unit("kg/mm^3", 1e9, 1.0),
];

pub(super) const FORCE: &[Unit] =
    &[unit("N", 1.0, 1.0), unit("mN", 1.0, 1e3), unit("kN", 1e3, 1.0), unit("lbf", 4.448_221_615_260_5, 1.0)];
pub(super) const TORQUE: &[Unit] =
    &[unit("N m", 1.0, 1.0), unit("N mm", 1.0, 1e3), unit("N cm", 1.0, 1e2), unit("mN m", 1.0, 1e3)];

/// Sizes that anything computed with may have, smallest and largest, SI: squares and products of what lies between stay far from the ends of
/// doubles, and whatever lies outside was meant otherwise.
pub(super) const NUMBER_SIZES: [f64; 2] = [1e-30, 1e30];
pub(super) const COUNT_SIZES: [f64; 2] = [1.0, 1e9];
/// Of lengths, speeds and angles.
pub(super) const LENGTH_SIZES: [f64; 2] = [1e-12, 1e6];
/// Of masses, forces and torques.
pub(super) const MASS_SIZES: [f64; 2] = [1e-15, 1e15];
/// Of times, spins and accelerations.
pub(super) const TIME_SIZES: [f64; 2] = [1e-9, 1e9];
pub(super) const DENSITY_SIZES: [f64; 2] = [1e-6, 1e9];
