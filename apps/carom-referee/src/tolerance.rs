//! Every tolerance of the crate, with its unit and its reason.

/// How far an answer may be off and still agree: the share of the kinetic energy's root that the difference of two motions has. Closed
/// forms and engine differ by less than 1e-12; an engine in 32-bit floats is not refused for its last digits alone by its users, who read
/// `difference` for that, but it does not agree exactly.
pub(crate) const AGREES: f64 = 1e-9;

/// Two motions that differ by less are one answer: what several hypotheses or laws say alike is told once. A share as above.
pub(crate) const SAME: f64 = 1e-9;

/// Energy that an impact may gain before it is said to have gained some: rounding of a 32-bit engine. A share of the energy before.
pub(crate) const GAINED: f64 = 1e-6;
