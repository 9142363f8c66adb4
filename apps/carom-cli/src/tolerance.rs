//! Every tolerance of the command, with its unit and its reason. Those of what it runs stand in their own crates.

/// Numbers of a body that differ by less than this share are meant to be one.
pub(crate) const SAME_NUMBER: f64 = 1e-12;
/// The engine and a closed form agree to this share.
pub(crate) const NON_SLIDING_AGREES: f64 = 1e-9;
/// Spins, as a fraction of the spin before, and normal impulses, as a fraction of the largest, agree where they differ by less: the engine carries a
/// spin from strike to strike to about 1e-13, a normal impulse is a difference of larger ones.
pub(crate) const CLOSED_FORM_AGREES: f64 = 1e-9;
/// What may be seen of a turn about another line, as a fraction of the spin.
pub(crate) const OFF_LINE: f64 = 1e-9;
/// What may be seen of a turn about another line than the edge, as a fraction of the spin.
pub(crate) const OFF_EDGE: f64 = 1e-9;
/// Where the corner does not slip at all, the type is that of the least slip along t: types 2 and 3 fill a line, not a region.
pub(crate) const LEAST_INCIDENCE: f64 = 1e-12;
/// Every point is a whole run: boundaries of runs are located as those of a map.
pub(crate) const RUN_ACCURACY: f64 = 1e-7;
/// How far apart the two points are at most between which a critical height is located, as a share of the axis.
pub(crate) const BRACKET: f64 = 1e-13;
/// How far from a closed-form curve the engine's outcome must have changed, as a share of the ranges: what a boundary is located to.
pub(crate) const REGION_ACCURACY: f64 = 1e-9;
/// A velocity after that is smaller than this share of the largest before is the rounding of zero.
pub(crate) const STILL_AFTER_IMPACT: f64 = 1e-12;
/// Share of the plane below which an outcome fills no region.
pub(crate) const ON_A_LINE: f64 = 1e-7;
/// How finely the boundaries of a map are located, as a share of the axes, where nothing is asked: finer than a picture shows.
pub(crate) const MAP_ACCURACY: f64 = 1e-7;
/// How finely changes between two feed intervals are located \[s\], where nothing is asked.
pub(crate) const INTERVAL_ACCURACY: f64 = 1e-6;
/// Angles \[deg\] and lengths \[m\] of the paper's cases are written exactly: what differs by less is the rounding of their units.
pub(crate) const SAME_AS_PRINTED: f64 = 1e-6;
/// The shortest time \[s\] by which a rate is divided: a clock may not have moved.
pub(crate) const SHORTEST_SPENT: f64 = 1e-3;
/// Smaller shares than this round to 0.0 %, and are told as less than 0.1 %.
pub(crate) const SHARE_SHOWN: f64 = 5e-4;
/// Numbers below this are shown with a power of ten: five decimals would lose digits.
pub(crate) const PLAIN_FROM: f64 = 1e-3;
