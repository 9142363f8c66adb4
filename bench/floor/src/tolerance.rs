//! Every tolerance of this program, in the rod's own units: half its length, and the time in which gravity gets it through that.

/// Part of the tolerance below which the last coefficient of a series is as good as none.
pub(crate) const LEAST_COEFFICIENT: f64 = 1e-3;
/// A step of Newton's method below this is the last but one: the next would be of its square.
pub(crate) const NEWTON_DONE: f64 = 1e-8;
/// An end that is about to be down again sooner than this has hardly lifted off: which of the two is rounding.
pub(crate) const HARDLY_LIFTS: f64 = 1e-6;
/// A centre lower than this above the plate strikes with both ends at once.
pub(crate) const BOTH_ENDS: f64 = 1e-9;
/// An approach slower than this is none.
pub(crate) const NO_APPROACH: f64 = 1e-9;
/// A slip, or what a sign hangs on, smaller than this is zero but for rounding.
pub(crate) const ZERO: f64 = 1e-12;
