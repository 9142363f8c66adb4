//! Every tolerance of the tasks, with its unit and its reason. Those of what they ask stand in their own crates.

/// Numbers of a body that differ by less than this share are meant to be one.
pub const SAME_NUMBER: f64 = 1e-12;
/// The engine and a closed form agree to this share.
pub const NON_SLIDING_AGREES: f64 = 1e-9;
/// Spins, as a fraction of the spin before, and normal impulses, as a fraction of the largest, agree where they differ by less: the engine carries a
/// spin from strike to strike to about 1e-13, a normal impulse is a difference of larger ones.
pub const CLOSED_FORM_AGREES: f64 = 1e-9;
/// What may be seen of a turn about another line, as a fraction of the spin.
pub const OFF_LINE: f64 = 1e-9;
/// What may be seen of a turn about another line than the edge, as a fraction of the spin.
pub const OFF_EDGE: f64 = 1e-9;
/// Where the corner does not slip at all, the type is that of the least slip along t: types 2 and 3 fill a line, not a region.
pub const LEAST_INCIDENCE: f64 = 1e-12;
/// Every point is a whole run: boundaries of runs are located as those of a map.
pub const RUN_ACCURACY: f64 = 1e-7;
/// How far apart the two points are at most between which a critical height is located, as a share of the axis.
pub const BRACKET: f64 = 1e-13;
/// How far from a closed-form curve the engine's outcome must have changed, as a share of the ranges: what a boundary is located to.
pub const REGION_ACCURACY: f64 = 1e-9;
/// A velocity after that is smaller than this share of the largest before is the rounding of zero.
pub const STILL_AFTER_IMPACT: f64 = 1e-12;
/// Share of the plane below which an outcome fills no region.
pub const ON_A_LINE: f64 = 1e-7;
/// How finely the boundaries of a map are located, as a share of the axes, where nothing is asked: finer than a picture shows.
pub const MAP_ACCURACY: f64 = 1e-7;
/// How finely changes between two feed intervals are located \[s\], where nothing is asked.
pub const INTERVAL_ACCURACY: f64 = 1e-6;
/// Smaller shares than this round to 0.0 %, and are told as less than 0.1 %.
pub const SHARE_SHOWN: f64 = 5e-4;
