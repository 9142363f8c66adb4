//! Below what a number is drawn and told as zero, or two as equal: one name, one value. None of them decides what happened: the engine has.

/// Share of the numbers a difference is formed of below which it is their rounding \[1\]: times, velocities and energies of a run are good to
/// some 10⁻¹¹ of their size, and the steps of an axis to 10⁻¹⁵.
pub(crate) const ROUNDING: f64 = 1e-9;
/// The same of what a linear system of a few unknowns solves \[1\]: a contact that is kept has no velocity but this share of the fastest one's.
pub(crate) const SOLVED: f64 = 1e-12;
/// Share of a size below which a length or the speed of a rim cannot be seen, and has no direction \[1\]: a drawing has a thousand pixels.
pub(crate) const UNSEEN: f64 = 1e-6;
/// Share of a curve's largest value below which its changes are drawn as none \[1\]: its axis shows four digits at most.
pub(crate) const CONSTANT: f64 = 1e-7;
/// Share of a plane below which a region is no region \[1\]: an outcome at equality, or the accuracy with which boundaries are located.
pub(crate) const NO_REGION: f64 = 1e-7;
/// Share of a plane that is told as less than 0.1 % \[1\]: half of that digit.
pub(crate) const LEAST_SHARE: f64 = 5e-4;
/// A spin that is told as none \[rad/s\]: half of the last digit of the smallest spins that a feeder's tables tell apart.
pub(crate) const NO_SPIN: f64 = 5e-5;
/// The least width of what a view shows \[m\]: a scene of one point has none, and a scale divides by it.
pub(crate) const LEAST_WIDTH: f64 = 1e-9;
/// Share of the energy of height that strikes may take which a closed series leaves out \[1\]: it is closed when they are a small part of what is left.
pub(crate) const SERIES_LEAVES_OUT: f64 = 1e-6;
/// A face of a part whose picture is smaller than this share of the square of the part's reach is seen edge on: rounding leaves so much of it.
pub(crate) const EDGE_ON: f64 = 1e-9;
/// What has no length on a drawing is drawn as a sheet this many times its thickness long \[1\]: none is shorter than it is thick.
pub(crate) const LEAST_SHEET: f64 = 1.001;
