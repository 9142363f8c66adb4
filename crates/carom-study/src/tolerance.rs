//! Every tolerance of this crate, with its unit and its reason. Those of motion and impacts stand in their crates.
//!
//! [`LEAST_ACCURACY`](crate::regions::LEAST_ACCURACY), which whoever asks for regions needs, stands there.

// Accuracies where nobody asks for another.

/// How finely changes between intervals of a feed are located \[s\].
pub(crate) const FEEDS_ACCURACY: f64 = 1e-6;
/// The least accuracy that may be asked for \[s\]: the clock of a feed runs up to an hour, of which doubles know 5e-13 s.
pub(crate) const LEAST_FEEDS_ACCURACY: f64 = 1e-9;
/// Accuracy of crossings and junctions, as a share of the range.
pub(crate) const REGIONS_ACCURACY: f64 = 1e-9;

// Regions.

/// Step of the central differences along a curve, as a share of the range: between the rounding of the function and its curvature.
pub(crate) const CURVE_DIFFERENCE: f64 = 1e-6;
/// How finely the crossings on a side are told apart, as a share of the window's smaller side: through a long narrow window lines pass close to each other.
pub(crate) const CROSSING_FINENESS: f64 = 1.0 / 1024.0;
/// The least fineness, as a share of the accuracy: a sliver that is thinner may be rounding, and leads astray.
pub(crate) const BLURRED: f64 = 0.02;

// Strikes.

/// A velocity or roll rate after a strike that is smaller than this share of the one before is the rounding of zero. It must stay far below the accuracy of
/// a diagram, or a velocity that changes its sign would show a band of zero between.
pub(crate) const STILL_AFTER_STRIKE: f64 = 1e-12;
/// All velocities together smaller than this share of those before: a body that has jammed. Contacts that hold it between them lose up to six digits, and
/// velocities vanish together at the border of rest alone.
pub(crate) const JAMMED_AT_REST: f64 = 1e-9;
/// A velocity of a touching contact smaller than this share of the largest is the rounding of zero.
pub(crate) const TOUCHING_VELOCITY: f64 = 1e-14;

// Feeds and yields.

/// Poses of a part's way that are closer than this share of its size touch.
pub(crate) const POSES_TOUCH: f64 = 1e-9;
/// Values whose spread is below this share of the largest differ by rounding only.
pub(crate) const ALIKE: f64 = 1e-9;
