//! Every tolerance of this crate: what it is measured in, its value, and why it has that value.
//!
//! A unit of [1] is a fraction; the sentence says of what. None is a velocity, an impulse or a mass: each is scaled by those of the impact, so that
//! no choice of units decides. Grids, starting steps and budgets of searches are no tolerances; they stand with their searches.

// The rate problem: which inequality holds, which motions are one.

/// A slack above minus this fraction of its terms is not negative [1]. Responses of six contacts are sums of a few dozen products of solved rates:
/// the solution of their equations multiplies rounding by the condition of the operator, of which five decades are allowed for.
pub(crate) const SLACK_TOLERANCE: f64 = 1e-11;
/// A slack of the motion below minus this fraction of its terms is no rounding [1], from whichever member of a family of forces it was computed:
/// members far from the middle have larger terms.
pub(crate) const CLEARLY_BROKEN: f64 = 1e-9;
/// A slack of a state of the non-sliding law above minus this is rounding [1]: a fraction of all impulses, or of all velocities before, which may be
/// small beside the terms of the slack.
pub(crate) const KEEPING_SLACK: f64 = 1e-10;
/// Pivots below this fraction of the largest entry count as zero [1]: forces are then a family. Between the rounding of a system of 36 unknowns and
/// operators that are nearly singular but are meant.
pub(crate) const RANK: f64 = 1e-9;
/// Motions that differ by less than this fraction of the largest velocity are one [1]. Two hypotheses reach one motion by different equations, each
/// known to about its rank.
pub(crate) const SAME_MOTION: f64 = 1e-8;
/// Margins that differ by less are equal [1]: of hypotheses with the same motion, rounding must not choose which one is named.
pub(crate) const EQUAL_MARGINS: f64 = 5e-13;
/// A motion along a free direction of rates below this fraction of what its parts do is rounding [1]: free directions are known to the rank only, and
/// their parts cancel.
pub(crate) const NO_MOTION: f64 = 1e-7;
/// Rates whose lengths differ by less than this fraction are as long as each other [1]: what is symmetric differs by rounding.
pub(crate) const SAME_LENGTH: f64 = 1e-9;
/// Where contacts are solved by hand, a difference counts from this fraction of its terms on [1]: it has lost no more than three digits. Below,
/// elimination with pivots decides.
pub(crate) const CLEAR: f64 = 1e-3;
/// Responses below this fraction of their terms are none where contacts hold all motion [1]: ten times what a slack may be broken by.
pub(crate) const NO_RESPONSE: f64 = 1e-10;
/// A margin above this, or an inequality broken by more, is far from any rounding [1]: one hypothesis may speak for others that have the same motion.
pub(crate) const CLEARLY: f64 = 1e-6;
/// A velocity of a contact counts as independent of others where it is beyond this fraction of its length from what they make [1] …
pub(crate) const INDEPENDENT: f64 = 1e-3;
/// … and as made by them where it is nearer than this fraction [1]. What lies between is independent, and never counts as held.
pub(crate) const MADE_BY_OTHERS: f64 = 1e-12;
/// Normal rates of one contact that differ by less than this fraction of the ample rate are one [1]: its share is not open.
pub(crate) const SAME_RATE: f64 = 1e-9;
/// A rate that may grow by so many ample rates is without bound [1]: contacts wedge the body.
pub(crate) const NO_BOUND: f64 = 1e6;
/// In space, the smallest slack of a family is known where the cutting planes promise no more than this above it, in ample rates [1]: further planes
/// would only follow rounding.
pub(crate) const KNOWN_SLACK: f64 = 1e-13;
/// A slip that starts may differ in direction from its response by this fraction of the terms of the response [1]: its direction is a root that was
/// searched for.
pub(crate) const ALONG_ITS_RESPONSE: f64 = 1e-10;

// Complementary pivoting.

/// Pivots below this fraction of the largest entry are rounding [1]: only asked whether impulses are open.
pub(crate) const PIVOTING_RANK: f64 = 1e-10;
/// Velocities below this fraction of all that was added to them are zero [1]: ten times the smallest pivot of Lemke's method.
pub(crate) const PIVOTING_REST: f64 = 1e-10;
/// Rates below this fraction of the problem's scale are zero where a vertex is read as a hypothesis [1]. The hypothesis is then solved and judged
/// like any other, so that a wrong reading costs a solution but never makes one.
pub(crate) const PIVOTED_ZERO: f64 = 1e-9;
/// A separation of this fraction of the largest velocity or rate is none [1]. Contacts that can wedge leave a problem at the edge of having a
/// solution; rounding puts it beyond, and a lift of this size brings it back. As small as what a slack may be broken by.
pub(crate) const SPECK: f64 = 1e-11;

// Bodies and their contacts, as given.

/// Meetings of the same bodies nearer than this fraction of the largest lever coincide [1], and so do normals that differ by less: their equations
/// would be one.
pub(crate) const COINCIDE: f64 = 1e-12;
/// A velocity below this fraction of the velocities at the contact is zero, where contacts under forces are given [1]: decimals that are written
/// cancel no better.
pub(crate) const TOUCHING_VELOCITY: f64 = 1e-9;
/// What rounding leaves of an equality between moments of inertia [1]: bodies are given in decimals, and a flat body is at the limit of the
/// inequality.
pub(crate) const INERTIA_EQUALITY: f64 = 1e-9;
/// What the length of a unit normal may differ from 1 by [1]: normals are given in decimals too.
pub(crate) const UNIT_LENGTH: f64 = 1e-9;

// Straight stages, in the plane and in space.

/// A velocity that comes within this fraction of its terms of zero is zero [1]. Contacts of one face stop and close together: rounding, which is some
/// hundred times less than this, must not tell them apart.
pub(crate) const STAGE_ZERO: f64 = 1e-13;
/// An approach below this fraction of all that was added to velocities is rounding [1]: bodies that come to rest between several contacts cancel
/// large terms.
pub(crate) const AT_REST: f64 = 1e-12;
/// Terms that are one over this times the fastest motion before hide it [1]: one rounding of them leaves less than four digits of the motion.
pub(crate) const DROWNED: f64 = 1e-12;
/// Contacts that are driven in, or approach, as fast as each other up to this fraction do so together [1].
pub(crate) const AS_FAST: f64 = 1e-9;
/// Velocities below this fraction of all that was added to them are rest where no way on is consistent [1]. A hundred times more generous than
/// [`AT_REST`]: else the walk would be refused for what is rounding of a wedge.
pub(crate) const REST_IN_PARADOX: f64 = 1e-10;
/// Work above this fraction of its terms is a gain of energy [1]; below it is the rounding of a sum.
pub(crate) const WORK_GAINED: f64 = 1e-12;
/// The same in space, where works are integrated along curves [1].
pub(crate) const WORK_GAINED_IN_SPACE: f64 = 1e-11;
/// Velocities differ from what the impulses make of those before by no more than this fraction of the terms [1]: a walk of thousands of stages adds
/// up its roundings.
pub(crate) const BALANCE: f64 = 1e-9;
/// The same in space [1]: so small a slip is taken from its own equation and not from the impulses.
pub(crate) const BALANCE_IN_SPACE: f64 = SMALL_SLIP;
/// Nor may they differ by more than this fraction of the fastest motion before [1]: the terms may be larger by far, and the result must tell five
/// digits.
pub(crate) const LOST: f64 = 1e-5;
/// Works differ from what the impulses did on the velocities by no more than this fraction of the terms [1]: they are products of both, and add up
/// over all stages.
pub(crate) const ACCOUNTED: f64 = 1e-7;
/// The same in space [1].
pub(crate) const ACCOUNTED_IN_SPACE: f64 = SMALL_SLIP;

// Series and circles of stages.

/// Two rounds are of one series where the second differs from ρ times the first by no more than this fraction of the largest [1]. The limit is the
/// last round times ρ/(1 − ρ): an error of the ratio is multiplied.
pub(crate) const SAME_ROUND: f64 = 1e-10;
/// A velocity below this fraction of its change along the series is zero at the limit [1]: ten times what the ratio may be wrong by.
pub(crate) const AT_LIMIT: f64 = 1e-9;
/// A round repeats the one before where it changes velocities by the same, but for this fraction of the largest [1] …
pub(crate) const SAME_PLACE: f64 = 1e-13;
/// … or for this fraction of all that was added to them [1]: one rounding of the sum and one of its last term. A velocity below it is rounding, too.
pub(crate) const ADDED_ROUNDING: f64 = 2.0 * f64::EPSILON;
/// Such a round needs the same impulses, but for this fraction of the largest [1]: how often it may be repeated follows from how well they agree.
pub(crate) const SAME_IMPULSE: f64 = 1e-6;
/// Impulses of all rounds that are passed over may be wrong by this fraction of them [1]: as motions that are one.
pub(crate) const PASSED_OVER: f64 = 1e-8;

// Conventions on sharing.

/// An approach below this fraction of the largest velocity before ends a sequence of single impacts [1]: sequences that converge would never end.
pub(crate) const SEQUENCE_OVER: f64 = 1e-13;
/// Outcomes that differ in a velocity by more than this fraction of the largest are two [1]: of a sample, outcomes that are nearer tell nothing new.
pub(crate) const OTHER_OUTCOME: f64 = 1e-6;
/// Bodies that rest between contacts that wedge them keep rounding below this fraction of the fastest velocity before [1]: it makes no outcome of its
/// own.
pub(crate) const WEDGED_STILL: f64 = 1e-10;
/// No closing contact is loaded by less than this share of another [1]: a sample loads every contact that closes.
pub(crate) const LEAST_SHARE: f64 = 1e-3;

// Contacts as springs.

/// Velocities below this fraction of the largest before are zero, and springs below this fraction of the deepest are slack [1]: the error of a step.
pub(crate) const SPRING_STILL: f64 = 1e-12;
/// Error of a step, in the units of the impact [1]: results are promised to 1e-9, and an impact takes up to a thousand steps.
pub(crate) const SPRING_STEP_ERROR: f64 = 1e-12;
/// Velocities at the end below this fraction of the largest before are zero [1]: the errors of all steps.
pub(crate) const SPRING_REST: f64 = 1e3 * SPRING_STILL;
/// Energy gained by more than this fraction of the impact's is no error of steps [1].
pub(crate) const SPRING_GAIN: f64 = 1e-9;
/// How far ahead a contact that is about to be loaded is looked at, in the duration of an impact [1]: without a force it would not tell which way it
/// slips.
pub(crate) const SPRING_SOON: f64 = 1e-6;
/// Contacts stick until friction is beyond its cone by this fraction [1]: ten times [`SLACK_TOLERANCE`], by which the rate problem lets a cone be
/// broken. It must not say again, where they let go, that they stick.
pub(crate) const SPRING_CONE: f64 = 10.0 * SLACK_TOLERANCE;
/// Steps below this fraction of the duration are refused [1]: numbers have overflowed, or the springs are out of reach.
pub(crate) const SPRING_SHORTEST: f64 = 1e-13;

// Slips that turn, in space.

/// A slip below this fraction of the largest velocity is none at the end of a stage [1]: what others hold does not slip but for rounding.
pub(crate) const NO_SLIP: f64 = 1e-11;
/// A slip below this fraction of the largest velocity is taken from its own equation [1]: of the sum of impulses too few digits are left to tell its
/// direction.
pub(crate) const SMALL_SLIP: f64 = 1e-6;
/// A slip goes straight where friction turns it by less than this, in units of the largest response [1]: some twenty roundings.
pub(crate) const STRAIGHT_TURN: f64 = 4e-15;
/// What rounding leaves of a response across a line to which others hold a slip [1]: rates are known to their rank.
pub(crate) const ON_LINE: f64 = 1e-9;
/// Along a curve a slip goes straight once what friction still turns of it, in units of the largest velocity, is less than this [1].
pub(crate) const SETTLED_TURN: f64 = 1e-13;
/// How far beside a direction friction is asked whether it turns a slip back to it [rad].
pub(crate) const BESIDE: f64 = 1e-4;
/// Error of one step along a curve, in the units of its quantities [1]: rounding of a step of order 8 is not much less.
pub(crate) const CURVE_STEP_ERROR: f64 = 1e-14;
/// Steps shorter than this share of the first step have errors of rounding alone [1] …
pub(crate) const CURVE_SHORT: f64 = 0.1;
/// … which of many contacts that share a load are as large as this, in units of the error allowed [1]: shorter steps would not help.
pub(crate) const CURVE_NOISE: f64 = 1e6;
/// Slips below this fraction of the largest velocity have stopped [1]: they are rounding of it.
pub(crate) const STOPPED: f64 = 1e-15;
/// A slip below this fraction of the largest velocity is near its stop [1]: it may go straight there, if it turns little enough.
pub(crate) const NEAR_STOP: f64 = 1e-9;
/// It does where it turns by less than this fraction of its fall [1], and no other slip changes by more meanwhile: the error is of the product with
/// [`NEAR_STOP`], rounding.
pub(crate) const SETTLED_FALL: f64 = 1e-7;
/// Slips that turn and change by less than this, on the walk's own clock, stand [1]: friction holds them, and nothing would ever end the stage.
pub(crate) const NEUTRAL: f64 = 1e-9;
/// The slowest of such slips has stopped where it is below this fraction of the largest velocity [1]: larger ones are slips that go on as they are.
pub(crate) const STANDING: f64 = 1e-7;
/// A slip that starts begins with this fraction of the largest velocity [1]: small enough that the impulse it would have taken to grow so far is
/// rounding.
pub(crate) const BIRTH: f64 = 1e-12;
/// A slip that starts at the edge of its cone and has fallen by this in its logarithm does not start [1].
pub(crate) const FALLEN: f64 = 0.01;
/// A contact of a face begins or ceases to carry at an event only if its rate is there within this fraction of all rates [1]: an event is found to
/// some 1e-12 of its stage, and rates are steep where friction nearly jams a face.
pub(crate) const BARELY_CARRIES: f64 = 1e-6;
/// An inequality that is met by less than this at the start of a curve is broken only below minus this, in its own units [1]: a hypothesis may be at
/// its edge by [`SLACK_TOLERANCE`], and rounding must not end its stage at once.
pub(crate) const AT_EDGE_OF_CURVE: f64 = 1e-10;
/// The same of normal velocities, as a fraction of the largest velocity [1]: those that touch are exactly zero.
pub(crate) const TOUCHING_EDGE: f64 = 1e-13;
/// A clock that is held up to within this, in units of the impact's impulse, is held up [1]: the equations of the paradox are singular there.
pub(crate) const CLOCK_HELD_UP: f64 = 1e-7;
/// A slip that starts and stops within this fraction of the clock has not started [1]: the walk would ask the same question without end.
pub(crate) const NOT_STARTED: f64 = 1e-7;
/// Solutions with smaller margins than this are at the edge of the hypothesis that has ended [1]: they are not the way on.
pub(crate) const AT_FOLD: f64 = 1e-8;
/// A stage that adds this many times the largest velocity leaves nothing to be said of any [1].
pub(crate) const WEDGED_STAGE: f64 = 1e9;

// Slips that start, in space.

/// A slip that grows by less than this, in units of the largest response, starts smoothly [1]: with the square of the impulse, not with the impulse.
pub(crate) const SMOOTH_START: f64 = 1e-3;
/// A start is steep where friction turns the slip away by this many times its growth [1]: on the way from nothing, twelve decades, rounding gains
/// half as many.
pub(crate) const TURNED_AWAY: f64 = 0.5;
/// The same of a direction that friction turns the slip back to [1]: explicit steps would be this many for each e-fold of the slip.
pub(crate) const TURNED_BACK: f64 = 1e3;
/// A slip of this fraction of the largest velocity has started [1]: from there on the curve's own clock is fast enough.
pub(crate) const STARTED: f64 = 1e-4;
/// The step of an onset, in units of the impulse of the impact [1]; its cube is what a step may err by, and its square what the onset does.
pub(crate) const ONSET_STEP: f64 = 2e-4;
/// Difference quotients along an onset are taken over this [rad]: near the cube root of rounding, where central differences err least.
pub(crate) const ONSET_DIFFERENCE: f64 = 1e-5;
/// Turns below this are none along an onset [rad].
pub(crate) const ONSET_ARRIVED: f64 = 1e-14;
/// A response of a contact below this fraction of its own alone is none: the others hold it [1].
pub(crate) const HELD: f64 = 1e-9;
/// Newton's method for directions has arrived where it moves by less [rad].
pub(crate) const START_ARRIVED: f64 = 1e-13;
/// Steps below this that do not shrink are rounding [rad]: contacts that hardly hold make equations of large numbers.
pub(crate) const START_ROUNDING: f64 = 1e-8;
/// Difference quotients for directions are taken over this [rad]: near the cube root of rounding; the root does not depend on it.
pub(crate) const START_DIFFERENCE: f64 = 1e-6;
/// Pivots below this fraction of the largest slope end Newton's method for directions [1].
pub(crate) const START_RANK: f64 = 1e-12;
/// Directions nearer than this are one [rad]: more than Newton's method may be off where its steps are rounding.
pub(crate) const SAME_DIRECTION: f64 = 1e-7;
/// A rate that pulls by less than this fraction of all may push beside [1]: the search keeps triangles in which none pulls by more.
pub(crate) const MAY_PUSH_BESIDE: f64 = 0.05;
