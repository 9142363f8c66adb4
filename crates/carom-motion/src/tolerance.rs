//! Every tolerance of this crate, with its unit and its reason.
//!
//! Lengths are fractions of a body's size (its reach in space). Times, speeds, rates and energies are in the world's own units, which
//! [`Scales`](crate::planar::Scales) holds. Where a constant has another unit, it says so. No tolerance is absolute.
//! Numbers that shape a method but decide nothing (how long a first step is, how many secants are tried) stand where the method is.

// Bodies and features in the plane.

/// Two vertices of a shape nearer than this coincide: the face between them has no direction.
pub(crate) const COINCIDENT_VERTICES: f64 = 1e-12;
/// A corner of a shape that turns by less than this sine is straight: its vertex is no corner.
pub(crate) const STRAIGHT_CORNER_SINE: f64 = 1e-12;
/// Edges of a chain that meet at less than this angle \[rad\] go on smoothly: drawings give both by rounded numbers.
pub(crate) const SMOOTH_JOINT: f64 = 1e-9;
/// Two segments of an outline that meet at a smaller angle \[rad\] are one: what the contacts of a face may be off its direction must not take one for the other.
pub(crate) const STRAIGHT_JOINT: f64 = 1e-8;
/// A segment of a chain that meets an arc at less than this angle \[rad\] touches it: drawings round points to some digits, and a segment can give way.
pub(crate) const TANGENT_JOINT: f64 = 1e-5;
/// Points nearer than this part of a shape's size are one where it is asked what it can lie on: no side is so short.
pub(crate) const SHORTEST_SIDE: f64 = 1e-6;
/// Two sides of a shape that are equally far from a point but for this part of its size are the two sides of a sheet without thickness.
pub(crate) const THINNEST: f64 = 1e-12;
/// A straight side looks in a direction where the angle between its normal and that has a sine below this.
pub(crate) const SAME_SIDE_SINE: f64 = 1e-4;
/// Half the thickness that rods without any have against each other, so that the end of one can push the end of another.
pub(crate) const ROD_SKIN: f64 = 1e-6;
/// An end of an obstacle nearer to another obstacle than this lies on it: drawings give both by rounded numbers.
pub(crate) const JOINED_ENDS: f64 = 1e-9;
/// Obstacles that bend by less than this sine are in line: the speed at which a body that slides along one strikes the other is rounding.
pub(crate) const IN_LINE_SINE: f64 = 1e-9;
/// Directions whose angle has less than this sine are one: unit vectors are known to some 1e-16, and a few sums are made of them.
pub(crate) const ONE_DIRECTION_SINE: f64 = 1e-12;
/// Directions whose angle has more than this cosine are the same.
pub(crate) const SAME_DIRECTION_COSINE: f64 = 1.0 - 1e-12;
/// A face that another contact keeps on the obstacle lies on it below this sine.
pub(crate) const FLAT_SINE: f64 = 1e-5;
/// Up to this angle \[rad\] a turn is its tangent, to the last digit: the square of it is lost beside 1.
pub(crate) const TINY_TURN: f64 = 1e-9;
/// Contacts of a body nearer to each other than this are at one point: poses are projected onto their contacts far more exactly.
pub(crate) const SAME_POINT: f64 = 1e-9;
/// Two points that make a contact's normal coincide where they are nearer than this: the line between them is rounding.
pub(crate) const COINCIDENT_POINTS: f64 = 1e-13;
/// Contacts nearer to each other than this do not keep a body's angle.
pub(crate) const KEEPS_ANGLE_ARM: f64 = 1e-3;
/// A body whose centre is farther than this from the line of an obstacle is on one side of it.
pub(crate) const OFF_THE_LINE: f64 = 1e-9;

// Touching in the plane.

/// Gaps below this are rounding: the features touch.
pub(crate) const TOUCHING_GAP: f64 = 1e-11;
/// Features nearer than this are met. It is below [`TOUCHING_GAP`], so that what is met touches.
pub(crate) const MET_GAP: f64 = 1e-12;
/// Farther apart than this nothing is met, whatever rounding does.
pub(crate) const CLEAR_GAP: f64 = 1e-9;
/// At the limit of a series of impacts what is about to be met is searched farther than rounding reaches, but not so far behind: a body may start overlapping by
/// [`CLEAR_GAP`], and its levers make more of it.
pub(crate) const DEEPEST_TOUCH: f64 = 1e-8;
/// A pair that has opened by this much has clearly opened, and is no longer watched on its own.
pub(crate) const CLEARLY_OPEN: f64 = 1e-5;
/// Segments without thickness that are apart by less than this along every normal may still be apart along their line.
pub(crate) const THIN_TOUCHES: f64 = 1e-12;
/// By how much features may lie past their extents or behind a tangent, and distances differ, before one pair counts as nearer than another.
pub(crate) const FEATURE_SLACK: f64 = 1e-9;
/// Speeds below this are rounding.
pub(crate) const STILL_SPEED: f64 = 1e-9;
/// Approaches below this are about to end where a series of impacts does.
pub(crate) const SLOW_APPROACH: f64 = 1e-5;

// What contacts do, in the plane.

/// A scaled slack below this is a tie of rounding, and no margin.
pub(crate) const MARGIN_TIE: f64 = 1e-12;
/// A body at rest has no acceleration above this fraction of gravity.
pub(crate) const RESTING_ACCELERATION: f64 = 1e-9;
/// Accelerations below this fraction of what the contact forces would give one by one are rounding: forces that wedge a body almost cancel.
pub(crate) const WEDGED_ACCELERATION: f64 = 1e-10;
/// A contact that carries less than this fraction of the weight carries nothing (in space too).
pub(crate) const WEIGHTLESS: f64 = 1e-9;
/// By how much the equations of a mode may contradict each other, as a fraction of the largest. Contacts that depend on each other (two in one corner,
/// say) agree in the mode's states; in states that an integration tries they agree only as nearly as it keeps to the mode.
pub(crate) const MODE_CONTRADICTION: f64 = 1e-3;
/// Pivots of a mode's equations below this fraction of the matrix count as zero: contacts that say the same (in space too).
pub(crate) const MODE_RANK: f64 = 1e-9;
/// Pivots of what the supports of a body in space are asked for together, below this fraction of the largest entry: the motions that are asked for are more than this part of the largest one,
/// since they are told from the others by the root of [`MODE_RANK`].
pub(crate) const SPANNED_RANK: f64 = 1e-12;
/// What is left of a support's push is nothing new below this fraction of its square: rounding.
pub(crate) const NOTHING_NEW: f64 = 1e-16;
/// What takes rounding back is at most so many times as large as it.
pub(crate) const STEEPEST: f64 = 1e5;
/// How near to Painlevé's edge, scaled, a motion comes whose normal force grows without bound.
pub(crate) const PAINLEVE_EDGE: f64 = 1e-6;
/// Forces that a mode leaves open are known up to this, in units of the weight: a contact that just transmits none still holds.
pub(crate) const OPEN_FORCES_ROUNDING: f64 = 1e-10;

// Keeping bodies on their contacts, in the plane.

/// What is left of a row of constraints below this fraction of it is rounding: the row says nothing new.
pub(crate) const DEPENDENT_ROW: f64 = 1e-12;
/// Residuals below this are left as they are.
pub(crate) const NEGLIGIBLE_RESIDUAL: f64 = 1e-15;
/// Pivots of a projection, as a fraction of the matrix, down to which its rows are solved as they stand.
pub(crate) const REGULAR_PROJECTION: f64 = 1e-10;
/// Pivots of a projection, as a fraction of the matrix, below which a row counts as dependent once rows are known to be.
pub(crate) const PROJECTION_RANK: f64 = 1e-6;
/// A shift this many times the residual that it takes away comes from rows that are almost dependent, and is not made.
pub(crate) const MOST_AMPLIFIED: f64 = 1e4;
/// Speeds along held contacts above this are projected once more.
pub(crate) const PROJECTED_RATE: f64 = 1e-13;
/// Rows that almost say the same may stop motions up to this speed: a millionth of the world's energy.
pub(crate) const MOST_STOPPED_RATE: f64 = 1e-3;

// Series of impacts in the plane.

/// A series is closed when less than this time is left of it.
pub(crate) const SERIES_LEFT: f64 = 1e-6;
/// The later half of the impacts that show a series takes less than this time: bounces that can be seen are not closed.
pub(crate) const LATE_SERIES: f64 = 1e-3;
/// Intervals that shrink by less than this ratio are no series: the limit of one would not be known.
pub(crate) const MOST_SERIES_RATIO: f64 = 0.9999;
/// The turns of a body that rocks on two contacts are closed once this time is left of them: with less left the gaps between them are rounding.
pub(crate) const ROCKING_LEFT: f64 = 1e-3;
/// Their limit is known to this time.
pub(crate) const ROCKING_ERROR: f64 = 1e-8;
/// To lie on both contacts a body that rocks is moved by no more than this.
pub(crate) const ROCKING_MOVE: f64 = 1e-8;

// Integration in the plane.

/// Relative tolerance of the integration where nobody asks for another.
pub(crate) const PLANAR_TOLERANCE: f64 = 1e-11;
/// Relative tolerance for which the lengths of first steps are given.
pub(crate) const FIRST_STEP_TOLERANCE: f64 = 1e-11;
/// Relative tolerance from which on a short series is enough.
pub(crate) const COARSE_SERIES_TOLERANCE: f64 = 1e-9;
/// A shorter step than this is a fault of the numbers.
pub(crate) const SHORTEST_STEP: f64 = 1e-14;
/// Times that differ by no more than this are one instant: nothing moves between them.
pub(crate) const SAME_INSTANT: f64 = 1e-13;
/// A stretch this short is an instant, in which nothing can be met; no step towards a touch is shorter.
pub(crate) const INSTANT: f64 = 1e-15;
/// Rates below this are rounding, at least.
pub(crate) const SIGNIFICANT_RATE: f64 = 1e-9;
/// Rates above this are never taken for the error of a coarse integration.
pub(crate) const MOST_SIGNIFICANT_RATE: f64 = 1e-4;
/// Bounds on how two bodies accelerate towards each other have at least this room: they are differences of rounded speeds.
pub(crate) const LEAST_ACCELERATION: f64 = 1e-9;

// Events in the plane.

/// A quantity below this has not yet left zero.
pub(crate) const NOT_YET_LEFT: f64 = 1e-10;
/// A quantity that left zero within this fraction of a step has just left it.
pub(crate) const JUST_LEFT: f64 = 1e-3;
/// A quantity leaves zero downwards where its first rate is below this fraction of its largest, negative: the rest is rounding.
pub(crate) const LEAVES_DOWNWARD: f64 = 1e-6;
/// A time long enough for a difference to show, and short enough for what it shows to be a rate.
pub(crate) const MOMENT: f64 = 1e-6;
/// Steps of a march towards an obstacle are at least this fraction of the stretch, so that it comes to an end.
pub(crate) const APPROACH_PART: f64 = 1e-13;
/// Steps past a pair that touches and opens, or grazes, are at least this time.
pub(crate) const STEP_PAST_TOUCH: f64 = 1e-12;
/// The same as a fraction of the stretch, where that is longer.
pub(crate) const GRAZING_PART: f64 = 1e-15;
/// Steps along what grazes for long are at least this time: short enough for the very moment of a touch to be found from there. They double as the
/// grazing goes on, and so stay a thousandth of the time that it has taken.
pub(crate) const GRAZING_STEP: f64 = 5e-4;
/// A correction of Newton's method longer than this time has lost the touch that it looks for.
pub(crate) const NEWTON_ASTRAY: f64 = 1e-3;
/// A correction of Newton's method below this, as a time or as a fraction of a stretch, is rounding.
pub(crate) const NEWTON_DONE: f64 = 1e-16;

// Bodies in space.

/// Supports closer than this are one point.
pub(crate) const ONE_SUPPORT: f64 = 1e-9;
/// Places of two pieces of a body no farther apart than this, in units of the reach, are one: a file has seven digits.
pub(crate) const ONE_CORNER: f64 = 1e-6;
/// A corner that is asked for by its place is the one no farther from there than this, in units of the reach: digits of a file, and what faces move by to be plane.
pub(crate) const NAMED_CORNER: f64 = 1e-4;
/// An edge at which pieces of a body take up half a turn but for this angle is none \[rad\]: they share a face there.
pub(crate) const HALF_TURN: f64 = 1e-6;
/// A corner all of whose edges lie to one side of a plane by less than this, as a sine, is none.
pub(crate) const POINTED: f64 = 1e-6;
/// Room of the principal moments, as a fraction of them: their closed form is exact to half the digits where two of them are equal.
pub(crate) const PRINCIPAL_SPARE: f64 = 1e-6;
/// A body thinner than this part of its length is flat: nothing that a plane does to it could be told from rounding of its places.
pub(crate) const THINNEST_BODY: f64 = 1e-6;
/// Vertices this close to their faces are on them: two units in the last place.
pub(crate) const VERTEX_ON_FACE: f64 = 4e-16;
/// A mass centre that is inside a side of a face by less than this part of the reach is over the side: the body is balanced there, and does not stay.
pub(crate) const OVER_A_SIDE: f64 = 1e-9;
/// Places that span less than this, in units of the reach, hold neither an edge nor a face.
pub(crate) const LEAST_SPAN: f64 = 1e-6;
/// Corners of a plate are on one plane within this part of its size, and turn by more.
pub(crate) const FLAT_PLATE: f64 = 1e-9;
/// What is deeper than this behind a face that has ends, or beyond an edge, in units of the body's reach, is beside it.
pub(crate) const BESIDE: f64 = 1e-10;
/// Edges whose directions have no larger sine between them are parallel: their ends touch instead.
pub(crate) const PARALLEL_EDGES: f64 = 1e-9;
/// A place is on a face or an edge up to this beyond its end, in units of the body's reach.
pub(crate) const BEYOND_END: f64 = 1e-12;
/// A plane without ends carries nothing whose normal points upwards by no more than this, as a sine.
pub(crate) const CARRIES: f64 = 1e-12;
/// What is nearer to touching than this, in units of the reach, is looked at closely: heights of a hop are counted, not measured.
pub(crate) const CLEAR_OF_ROUNDING: f64 = 1e-9;
/// An obstacle farther from the mass centre than this, in units of the reach, is far: what the body has besides points is not measured against it.
pub(crate) const FAR: f64 = 1.1;
/// Rounded edges have at least this radius, in units of the reach, where obstacles have ends: within a smaller one two edges could pass each other between two looks.
pub(crate) const LEAST_ROUNDING: f64 = 1e-5;
/// Contacts no farther apart than this, in units of the reach, whose normals differ by no more, are one.
pub(crate) const ONE_PLACE: f64 = 1e-9;
/// An edge may touch another in a direction this far, as a sine, from those between its faces.
pub(crate) const BETWEEN_FACES: f64 = 1e-9;
/// Three normals whose determinant is smaller leave the place of their common point open.
pub(crate) const INDEPENDENT_NORMALS: f64 = 1e-6;
/// A volume below this part of that of the box around is rounding.
pub(crate) const EMPTY_VOLUME: f64 = 1e-12;
/// What the length of an axis that somebody gives may differ from 1 by.
pub(crate) const UNIT_LENGTH: f64 = 1e-9;
/// A point this close to an edge lies on it.
pub(crate) const ON_EDGE: f64 = 1e-11;

// Supports in space that touch, strike and stay.

/// Supports no higher than this touch: on one plane with others they are so but for rounding.
pub(crate) const SUPPORT_TOUCHES: f64 = 4e-15;
/// At the start supports touch up to this height: whoever gives a start computes it too.
pub(crate) const TOUCHES_AT_START: f64 = 1e-12;
/// At the start speeds below this, of the world or of the motion, are rounding.
pub(crate) const AT_REST_AT_START: f64 = 1e-12;
/// Supports that come down within this fraction of a stretch's length come down at once.
pub(crate) const COMES_DOWN_AT_ONCE: f64 = 1e-11;
/// So do those that come down within this fraction of the world's time: the corners of an edge whose turn is nothing but what many strikes have rounded.
pub(crate) const ROUNDING_OF_TIME: f64 = 1e-12;
/// Supports that come down slower than this fraction of the motion's speeds graze the plane.
pub(crate) const GRAZING_SPEED: f64 = 1e-13;
/// Supports that strike slower than this, in units of the world's speed, do not rebound: their hops would be lower than 1e-14 of the body, and gaps
/// of edges are measured to 1e-15 of it.
pub(crate) const FAINT_STRIKE: f64 = 1e-7;
/// After an impact a support that rises slower than this fraction of the speeds before stays on the plane.
pub(crate) const SUPPORT_STAYS: f64 = 1e-11;
/// After an impact a slip below this fraction of the speeds before is rest.
pub(crate) const SUPPORT_STICKS: f64 = 1e-11;
/// Approaches, as fractions of the motion's speeds, that press on a support whose slip is about to be stopped at once: the least that stops it is taken.
pub(crate) const PRESSING_APPROACHES: [f64; 5] = [1e-12, 1e-11, 1e-10, 1e-9, 1e-8];
/// Before an impact a slip below this fraction of the motion's speeds is rounding.
pub(crate) const SLIP_ROUNDING: f64 = 1e-13;

// Friction in space.

/// Slips below this speed, of the world or of the motion, are rest.
pub(crate) const RESTING_SLIP: f64 = 1e-11;
/// Held supports of several planes take the friction of smaller coefficients than this as of this.
pub(crate) const LEAST_GRIP: f64 = 1e-6;
/// How far ahead, in the world's time, it is asked which supports slip once held ones can no longer hold: far enough for their cones to be clearly left.
pub(crate) const SLIPS_AHEAD: f64 = 1e-6;
/// A support that stays within this of its plane for a whole step, and does not leave it faster, in units of the reach and of the world's speed, goes along it.
pub(crate) const SKIMS: f64 = 1e-14;
/// The same of what has ends: how near, and how slow.
pub(crate) const SKIMS_BESIDE: f64 = 1e-9;
/// How slow that is, and up to what difference a gap is counted on.
pub(crate) const SKIMS_MEASURED: f64 = 1e-12;
/// A circle whose axis is off the plane's normal by no more than this sine lies flat.
pub(crate) const FLAT: f64 = 1e-9;
/// Two supports that are within this fraction of the edges of their cones come there at once.
pub(crate) const CONES_LEFT_AT_ONCE: f64 = 1e-9;
/// A force outside its cone by this fraction of it is inside but for rounding.
pub(crate) const INSIDE_CONE: f64 = 1e-11;
/// The end of an edge slips across it where its direction has no more than this along it.
pub(crate) const SLIPS_ACROSS: f64 = 1e-6;
/// A slip that falls below this speed has come to its end.
pub(crate) const SLIP_STOPPED: f64 = 1e-12;
/// A slip that has been above this speed may come to its end: it is above [`SLIP_STOPPED`], so that none ends at its start.
pub(crate) const SLIP_GROWN: f64 = 1e-11;
/// Where a stretch begins, a slip that starts is zero but for rounding below this speed.
pub(crate) const SLIP_SPECK: f64 = 1e-14;
/// A slip at its limiting direction, in the own units of its guess.
pub(crate) const SLIP_STARTED: f64 = 1e-9;
/// A slip is turned by this angle \[rad\] to see how friction turns it back.
pub(crate) const SLIP_TURN: f64 = 1e-4;
/// Slips are moved by this fraction of themselves, and everything else by this, to see how forces change with them.
pub(crate) const FORCE_DIFFERENCE: f64 = 1e-6;
/// A guess of a slip's growth is at least this fraction of what friction decelerates by, at the end of a step of the world's time.
pub(crate) const LEAST_SLIP_GROWTH: f64 = 1e-3;

// Integration and events in space.

/// Tolerance of a step where nobody asks for another.
pub(crate) const SPATIAL_TOLERANCE: f64 = 1e-14;
/// Events within this fraction of the world's time are at one instant.
pub(crate) const ONE_INSTANT: f64 = 1e-10;
/// No explicit step is shorter than this.
pub(crate) const SHORTEST_SPATIAL_STEP: f64 = 1e-15;
/// No implicit step is shorter than this.
pub(crate) const SHORTEST_IMPLICIT_STEP: f64 = 1e-12;
/// An implicit step whose error is below this part of what is allowed is followed by one of twice its length.
pub(crate) const EASY_STEP: f64 = 1e-3;
/// Tolerance of implicit steps to an event.
pub(crate) const IMPLICIT_EVENT_TOLERANCE: f64 = 1e-14;
/// Heights below this are counted on from stretch to stretch: computed anew from the pose they would lose their digits.
pub(crate) const SMALL_HEIGHT: f64 = 1e-3;
/// Accelerations below this are rounding.
pub(crate) const STILL_ACCELERATION: f64 = 1e-13;
/// Room for the rounding of the energy, in m g |s|.
pub(crate) const ENERGY_ROOM: f64 = 1e-9;
/// A march towards a touch makes steps of at least this fraction of the step that it looks at: what grazes the plane is passed over in finitely many, and
/// is then below it by no more than the bound on its acceleration times the square of this.
pub(crate) const LEAST_MARCH: f64 = 1e-7;
/// Steps of a march are not so short that what grazes its plane in one of them comes less deep below it than this, in units of the reach.
pub(crate) const GRAZES: f64 = 1e-12;
/// Where a height was seen to fall through zero between nodes it does so, as a fraction of what was looked at: a thousand times what the nodes tell it to.
pub(crate) const FALLS_WITHIN: f64 = 1e-6;
/// Corrections of an event below this fraction of a step's length are rounding.
pub(crate) const CORRECTION_ROUNDING: f64 = 4e-16;

// Series of impacts in space.

/// A series is closed once this time is left of it, where nobody asks for another.
pub(crate) const SPATIAL_CLOSING: f64 = 1e-5;
/// The last impact moves the limit of a series by no more than this fraction of the time that may be left for a closing.
pub(crate) const CLOSING_ERROR: f64 = 1e-3;
/// The turns of supports that strike one after the other are closed with so many times as much left of them: where each chatters, closing that leaves traces in the later ones.
pub(crate) const TURNS_EARLIER: f64 = 1000.0;
/// But not before: rocking that can be seen is not closed.
pub(crate) const MOST_TURNS_LEFT: f64 = 1e-2;
/// Periods that shrink by no more than this ratio are none of a series.
pub(crate) const MOST_PERIOD_RATIO: f64 = 0.999;
/// The ratio of a series changes by no more than this from period to period: limits of others may agree by chance.
pub(crate) const STEADY_RATIO: f64 = 0.01;
/// Kinetic energies below this fraction of m g × reach do not lift a body by what rounding leaves of heights.
pub(crate) const FAINT_ENERGY: f64 = 1e-15;
/// Supports this close to the plane on which a body rests lie on it: what a closed series leaves, and rounding.
pub(crate) const LIES_ON_PLANE: f64 = 1e-9;
/// What a closed series leaves of the way to the plane is no more than this.
pub(crate) const MOST_LAID: f64 = 1e-6;
/// Turns by more than this angle \[rad\] are neither rounding nor what a closed series leaves, and are not made.
pub(crate) const MOST_SETTLING_TURN: f64 = 1e-4;
