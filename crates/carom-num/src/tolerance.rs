//! Every tolerance of this crate: what it is measured in, its value, and why it has that value.
//!
//! A unit of [1] is a fraction; the sentence says of what.

// Pivots.

/// Coefficients below this fraction of the largest are no pivots [1], in linear programmes and in Lemke's method. Some hundred exchanges leave
/// rounding of this size, growth included: to divide by it would blow it up.
pub(crate) const PIVOT: f64 = 1e-11;
/// Lemke's covering variable is zero below this fraction of the largest constant [1]: it comes from as many exchanges as any pivot.
pub(crate) const LEMKE_COVERED: f64 = 1e-11;
/// A difference below this fraction of its terms is zero in Lemke's tableau [1]. Hundreds of roundings, and no more: an entry that cancels must be
/// exactly zero, or its rounding decides ties and the method cycles.
pub(crate) const LEMKE_CANCELS: f64 = 1e-13;
/// Ratios that differ by less than this fraction of their sum are one [1] but for some tens of roundings, and the lexicographic rule decides.
pub(crate) const LEMKE_TIE: f64 = 1e-14;
/// Pivots below this fraction of the largest entry refuse a step of the implicit method [1]. Its matrix is regular: only one that is singular to the
/// last digits is refused.
pub(crate) const RADAU_RANK: f64 = 1e-14;
/// The same of the equations of a step through known states [1]: below it two of the states are at one place.
pub(crate) const THROUGH_RANK: f64 = 1e-12;

// Iterations that have arrived.

/// Newton's method of the implicit step has arrived where it moves every stage by less than this fraction of the tolerance that was asked for [1].
/// What is left of the iteration is then small beside the error of the step itself.
pub(crate) const RADAU_ARRIVED: f64 = 0.03;
/// A quantile has arrived where it moves by less than this fraction of itself [1]: a few units in the last place, below which steps go to and fro.
pub(crate) const QUANTILE_ARRIVED: f64 = 1e-15;
/// A root of a quartic is found where it moves by less than this fraction of its interval [1]. The next step would be of its square; callers correct
/// the place by a step of their own method.
pub(crate) const QUARTIC_ARRIVED: f64 = 1e-9;
/// Newton's step to a root of a series is the last below this fraction of the interval [1]: the next one would be of its square, which is rounding.
pub(crate) const TAYLOR_ARRIVED: f64 = 1e-8;
/// Steps of a march along a series are at least this fraction of the interval [1]: the dip that they pass over is of its square, which is rounding.
pub(crate) const TAYLOR_SHORTEST: f64 = 1e-8;

// Events.

/// A highest term of an interpolant below this fraction of the function's size shows its shape well enough [1].
pub(crate) const RESOLVED_SHAPE: f64 = 1e-3;
/// Where the second point of the first secant lies, as a fraction of a step [1].
pub(crate) const FIRST_SECANT: f64 = 1e-4;
/// Secants are done where the place changes by less than this fraction of a step [1]: the dense output is not more exact.
pub(crate) const SECANT_DONE: f64 = 1e-12;
/// Corrections of a step's length below this fraction of it are short enough for a method of order 4 [1]: its error is of the fifth power.
pub(crate) const SHORT_SHIFT: f64 = 1e-4;
/// Corrections below this fraction of a step are too short for the curvature of a course to count [1]: their square is lost.
pub(crate) const STRAIGHT: f64 = 1e-8;
/// Corrections below this fraction of the clock cannot be written [1].
pub(crate) const LAST_DIGIT: f64 = 1e-16;

// Roots on the circle.

/// Half-arcs below this are not cut any further [rad]. At a double root the function is below rounding as far as √ε = 1.5e-8 beside it: whether it
/// touches zero or crosses it twice cannot be told.
pub(crate) const CIRCLE_NARROW: f64 = 2e-8;
/// Arcs reach beyond their ends by this [rad], lest rounding puts a root at an end into neither of two arcs. Less than the narrowest arc.
pub(crate) const CIRCLE_OVERLAP: f64 = 1e-9;
/// Double roots nearer than this are one [rad]: several of the narrowest arcs beside it see it.
pub(crate) const CIRCLE_SAME: f64 = 1e-6;
/// A function whose coefficients are below this fraction of the terms they come from is zero everywhere [1]: some tens of roundings.
pub(crate) const CIRCLE_ZERO: f64 = 1e-14;

// Cones.

/// The least opening is found where the bound and the member's own cones differ by less than this fraction [1]: a tenth of what the answer promises.
pub(crate) const CONES_CLOSE: f64 = 1e-10;
/// Parts of a Newton step below this are not tried [1]: a barrier that does not fall over ten decades of steps is at its least, up to rounding.
pub(crate) const CONES_SHORTEST: f64 = 1e-10;
/// A Newton step that lowers the barrier by less than this is the last to a centre [1]. The next step of the method starts near the centre, not at
/// it: more digits are wasted.
pub(crate) const CONES_CENTRED: f64 = 1e-4;
/// Third components below this fraction of the largest vector are zero in all members [1]: the linear programme that lifts them errs by less.
pub(crate) const CONES_FLAT: f64 = 1e-9;

// Series in place of a quotient.

/// Below this half angle a rotation takes the series of sin x / x [rad]: the first term left out, x⁴/120, is below rounding.
pub(crate) const SMALL_ANGLE: f64 = 1e-4;
