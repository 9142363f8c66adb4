//! Every tolerance of this crate, with its unit and its reason. Those of the engine stand in its own crates.

/// Contacts nearer than this share of the part's size are touches, not crossings.
pub(crate) const OBSTACLES_TOUCH: f64 = 1e-9;
/// A velocity after that is smaller than this share of the largest before is the rounding of zero.
pub(crate) const STILL_IN_SPACE: f64 = 1e-11;
/// Work below this fraction of its terms is rounding.
pub(crate) const WORK_ROUNDING: f64 = 1e-12;
/// Largest share of its size by which an arc may miss a circle and still be one.
pub(crate) const ROUND_EDGE: f64 = 1e-9;
/// Curves are followed to this share of the outline's size, where no chord tolerance is written.
pub(crate) const CHORD: f64 = 1e-3;
/// The finest chord tolerance, as a share of the size.
pub(crate) const FINEST_CHORD: f64 = 1e-6;
/// Smallest and largest outline [m]: fourth powers of lengths keep their digits, and a wrong unit is found.
pub(crate) const SMALLEST_OUTLINE: f64 = 1e-6;
/// Ends nearer than this share of the size are at one place: what rounding of a file's numbers leaves.
pub(crate) const OUTLINE_ROUNDING: f64 = 1e-9;
/// Loops of less than this share of the size squared enclose nothing.
pub(crate) const NO_AREA: f64 = 1e-9;
/// Bulges below this are straight: the sagitta is bulge × chord / 2.
pub(crate) const STRAIGHT_BULGE: f64 = 1e-15;
/// Entries of a matrix that should be equal may differ by this share of the largest entry, and pivots that should not be negative may be.
pub(crate) const MATRIX_ROUNDING: f64 = 1e-9;
/// How far the rod's drawing reaches beyond the last support, in lengths: a sharp end exactly over a sharp support rests on nothing.
pub(crate) const ROD_OVERHANG: f64 = 1e-4;
/// A mass centre that is over a face's edge within this part of the body's reach is over it: it balances.
pub(crate) const BALANCED: f64 = 1e-9;
/// What counts as flat, in units of the largest coordinate: of vertices that are written; of a file, whose numbers have 24 binary digits.
pub(crate) const FLAT_AS_WRITTEN: f64 = 1e-9;
/// A surface whose volume is below that of its hull by less than this part is convex.
pub(crate) const CONVEX: f64 = 1e-5;
/// Contacts that touch no higher than this, in units of the body's reach, belong to a strike that has no way on.
pub(crate) const SUPPORT_TOUCHES: f64 = 1e-9;
/// Velocities below this part of the fastest contact's, are rounding: the contact rests.
pub(crate) const CONTACT_RESTS: f64 = 1e-12;
/// Turning below this share of the body's own rate (its speed of a fall over its size) is none.
pub(crate) const ROLL_STILL: f64 = 1e-9;
/// A corner may lie so far below the plane at the start, in distances from A to the mass centre: rounding.
pub(crate) const EDGE_TOUCHES: f64 = 1e-9;
/// A component of a DXF entity's normal below this is zero: directions are written with some ten digits.
pub(crate) const DXF_NORMAL: f64 = 1e-9;
/// An ellipse whose angles are less than this \[rad\] from a whole turn is closed: 2π as the digits of a file have it.
pub(crate) const DXF_WHOLE_TURN: f64 = 1e-9;
/// The two ends of an arc may be so far from equally far from its centre, as a share of its radius: digits of a drawing.
pub(crate) const ARC_RADII: f64 = 1e-3;
/// An arc that turns by less than this [rad] is a straight line.
pub(crate) const STRAIGHT_ARC: f64 = 1e-9;
/// Unit normals that differ by less than this are of one face.
pub(crate) const ONE_FACE: f64 = 1e-6;
/// Shares of faces that differ by less than this part of themselves are equal: faces that are alike are seen alike but for the rounding of solid angles.
pub(crate) const EQUAL_SHARES: f64 = 1e-12;
