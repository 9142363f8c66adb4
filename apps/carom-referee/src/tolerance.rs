//! Every tolerance of the crate, with its unit and its reason.

/// How far an answer may be off and still agree: the root of the kinetic energy of the difference, as a share of that before. Closed forms
/// and engine differ by less than 1e-15; what is computed with 64 bits by another way loses some digits where numbers cancel.
pub(crate) const AGREES: f64 = 1e-9;

/// Two motions that differ by less are one answer: what several hypotheses or laws say alike is told once. A share as above.
pub(crate) const SAME: f64 = 1e-9;

/// Energy that an impact may gain before it is said to have gained some: rounding of a 32-bit engine. A share of the energy before.
pub(crate) const GAINED: f64 = 1e-6;
