//! Every tolerance of the command, with its unit and its reason. Those of what it runs stand in their own crates.

/// Angles \[deg\] and lengths \[m\] of the paper's cases are written exactly: what differs by less is the rounding of their units.
pub(crate) const SAME_AS_PRINTED: f64 = 1e-6;
/// The shortest time \[s\] by which a rate is divided: a clock may not have moved.
pub(crate) const SHORTEST_SPENT: f64 = 1e-3;
/// Numbers below this are shown with a power of ten: five decimals would lose digits.
pub(crate) const PLAIN_FROM: f64 = 1e-3;
