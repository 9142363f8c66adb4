//! Every tolerance of this crate, with its unit and its reason. Those of the motion stand in carom-motion.

use std::f64::consts::PI;

/// A plate or wall shorter than this fraction of the part's size has no length: its direction would be rounding.
pub(crate) const NO_LENGTH: f64 = 1e-9;
/// A first plate whose ends are beside each other by less than this fraction of its length is vertical: no part lies on it.
pub(crate) const VERTICAL: f64 = 1e-9;
/// Sizes of the part from the origin beyond which the rounding of a position exceeds the gap at which features meet.
pub(crate) const FARTHEST: f64 = 4000.0;
/// A plate or wall reaches into the part where it starts by more than this fraction of the part's size: less is rounding of the drawing.
pub(crate) const CROSSES_START: f64 = 1e-9;
/// Plates that overlap by less than this fraction of the longer one touch, and do not cross.
pub(crate) const PLATES_TOUCH: f64 = 1e-9;
/// The end of a plate nearer to a wall than this fraction of the part's size lies on it.
pub(crate) const ON_WALL: f64 = 1e-9;
/// How far such a plate then goes on behind the wall, as a fraction of the part's size: ends that only touch would leave a way for a part without thickness.
pub(crate) const BEHIND_WALL: f64 = 1e-6;
/// Lengths that differ by less than this share of the part are the same: rounding of its corners and of its pose.
pub(crate) const SAME_LENGTH: f64 = 1e-9;
/// Sine of an angle between two stretches of a bent sheet below which they go on smoothly: rounding of a drawing's digits.
pub(crate) const SMOOTH_BEND: f64 = 1e-5;
/// Unit normals of two faces whose sum is no longer than this look opposite ways: rounding of a drawing's digits.
pub(crate) const OPPOSITE: f64 = 1e-6;
/// A face lies on a plate whose normal differs by no more than this from that of the face, as a unit vector: contacts are met to 1e-12 of the part.
pub(crate) const FLAT_FACE: f64 = 1e-6;
/// Contacts are on one line where no triangle of them has an area above this share of the square of the part's reach.
pub(crate) const ON_ONE_LINE: f64 = 1e-6;
/// Sizes of the part that a plate or wall across the drawing is wide where the drawing gives no width.
pub(crate) const WIDE: f64 = 400.0;
/// A plate reaches this far under the walls along its sides, and they below its upper side, in units of the part's size: where a part touches wall and plate at once, neither has an edge.
pub(crate) const UNDER_WALLS: f64 = 1e-3;
/// The least and the largest angle between the flanks of a groove [rad], 10° and 170°: beyond them what one flank carries is hardly told from what the other does.
pub(crate) const V_ANGLES: [f64; 2] = [PI / 18.0, 17.0 * PI / 18.0];
/// Corners of one face of a box are on its plane to this share of the box's diagonal: rounding.
pub(crate) const BOX_HULL: f64 = 1e-12;
/// Places of a surface that is drawn are of one face within this part of the body's reach.
pub(crate) const DRAWN_FLAT: f64 = 1e-9;
/// What is no farther from the plane of a face than this, in units of the part's reach, is on that face.
pub(crate) const ON_FACE: f64 = 1e-6;
/// A corner of pieces no farther than this from one of their hull, in units of the reach, is that one: digits of a file, and what faces move by to be plane.
pub(crate) const SAME_CORNER: f64 = 1e-3;
