//! What crosses as plain numbers: structs and enums with the layout of C.

use std::ffi::c_int;

/// Most contacts that an impact may have.
pub const MOST_CONTACTS: usize = 24;

/// Up to so many contacts an impact is walked through compression and restitution, and every end
/// state is found. Of more contacts one end state is found.
pub const MOST_WALKED: usize = 6;

/// How a call ended.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It was done. Several answers, or none, are results: the answer says so.
    Ok = 0,
    /// What was given has problems; the message lists all of them.
    BadInput = 1,
    /// What was given is good, but no answer could be computed; the message says why.
    Undone = 2,
    /// A fault of Carom itself. Please report it, with the message.
    Fault = 3,
}

/// How restitution is measured.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Normal impulse of restitution = e times that of compression.
    Poisson = 0,
    /// Work of the normal impulse in restitution = e squared times its work in compression.
    Stronge = 1,
    /// Normal velocity after = -e times that before. It can create energy where the slip stops or
    /// reverses.
    Newton = 2,
}

/// Whether an impact has one answer.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// One end state is consistent, and the walk ends in it without a choice.
    Unique = 0,
    /// Several end states are consistent, or the walk had to choose.
    Several = 1,
    /// The walk chose nothing, and ends in none of the end states: the end depends on the way
    /// there.
    PathDependent = 2,
    /// No end state is consistent.
    None = 3,
    /// End states are consistent, but the walk that tells which of them is reached has no answer.
    Unresolved = 4,
    /// One answer was found; others were not searched for.
    Found = 5,
    /// No end state was found; that there is none is not known.
    NotFound = 6,
}

/// What a contact does at the end of an impact.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactState {
    /// It opens, or takes no impulse.
    Separates = 0,
    /// Normal velocity and slip after are zero.
    Sticks = 1,
    /// Normal velocity after is zero, the slip is not.
    Slips = 2,
}

/// How a drop of a feeder ends.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DropOutcome {
    /// Flat on the last plate.
    Landed = 0,
    /// It left over the edge of the last plate.
    Delivered = 1,
    /// Friction holds it.
    Stuck = 2,
    /// It rests on an end.
    OnEnd = 3,
    /// It is wedged between obstacles, or no impact resolves its contacts.
    Jammed = 4,
    /// It fell past the last plate.
    Missed = 5,
    /// It touched the last plate and left it before it lay flat.
    Escaped = 6,
    /// The budget of events or of time ran out, or it swings for ever.
    NeverFlat = 7,
    /// More contacts met at once than can be resolved.
    Unresolved = 8,
    /// Another part stood in its place. Only in a feed.
    Blocked = 9,
}

/// Which face of the part is down at the end, against the start.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It does not lie flat at the end, or it is a disc.
    None = 0,
    /// The same face.
    Same = 1,
    /// The opposite face: the part was turned.
    Turned = 2,
    /// Another face; `face` has its number.
    Face = 3,
}

/// A free rigid body in the plane, before the impact.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Mass [kg]; above 0.
    pub mass: f64,
    /// Moment of inertia about the mass centre [kg m^2]; above 0.
    pub inertia: f64,
    /// Velocity of the mass centre (x, y) [m/s].
    pub velocity: [f64; 2],
    /// Spin, counter-clockwise [rad/s].
    pub spin: f64,
}

/// Where the body is touched.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The point, from the mass centre (x, y) [m].
    pub point: [f64; 2],
    /// Normal out of the obstacle into the body (x, y); of any length but 0.
    pub normal: [f64; 2],
    /// Coulomb's coefficient of friction; 0 or more.
    pub friction: f64,
    /// Coefficient of restitution; 0 to 1.
    pub restitution: f64,
}

/// An impact of one body.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactProblem {
    /// The body before.
    pub body: Body,
    /// The contacts: an array of `contact_count`. It stays the caller's.
    pub contacts: *const Contact,
    /// How many contacts there are: 1 to `CAROM_MOST_CONTACTS`.
    pub contact_count: usize,
    /// The law of restitution: a value of `carom_law`.
    pub law: c_int,
}

/// What an impact does.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactResult {
    /// Whether this is the only answer.
    pub outcome: Outcome,
    /// The law that was obeyed: Poisson's where several contacts close at once.
    pub law: Law,
    /// True where the impact was walked to an end. Where it is false the numbers below, but for the
    /// energy before and the count, are NaN: read the end states.
    pub walked: bool,
    /// Velocity of the mass centre after (x, y) [m/s].
    pub velocity: [f64; 2],
    /// Spin after, counter-clockwise [rad/s].
    pub spin: f64,
    /// Kinetic energy before [J].
    pub energy_before: f64,
    /// Kinetic energy after [J].
    pub energy_after: f64,
    /// How many end states are consistent; of more than `CAROM_MOST_WALKED` contacts, 1 where one
    /// was found, else 0.
    pub end_state_count: usize,
}

/// One contact at the end of an impact. The tangent is the normal turned a quarter clockwise.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactEnd {
    /// What it does.
    pub state: ContactState,
    /// Impulse on the body along the normal [N s].
    pub normal_impulse: f64,
    /// Impulse on the body along the tangent [N s].
    pub tangential_impulse: f64,
    /// Velocity of the point along the normal after [m/s].
    pub normal_velocity: f64,
    /// Velocity of the point along the tangent after [m/s].
    pub slip: f64,
}

/// One consistent end state.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndState {
    /// Velocity of the mass centre after (x, y) [m/s].
    pub velocity: [f64; 2],
    /// Spin after, counter-clockwise [rad/s].
    pub spin: f64,
    /// Kinetic energy after [J].
    pub energy_after: f64,
    /// The smallest slack of its inequalities, divided by the sum of their terms' sizes; infinite
    /// where nothing was decided.
    pub margin: f64,
    /// True where many impulses give this motion; those of the answer are one choice.
    pub indeterminate: bool,
    /// True where restitution created energy.
    pub gained_energy: bool,
    /// How many contacts there are.
    pub contact_count: usize,
}

/// How a drop of a feeder ended.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DropResult {
    /// How it ended.
    pub outcome: DropOutcome,
    /// Which face is down at the end.
    pub verdict: Verdict,
    /// Number of the face that is down at the end, from 0; -1 where the verdict is
    /// `CAROM_VERDICT_NONE`.
    pub face: c_int,
    /// When it ended [s].
    pub end_time: f64,
    /// How many strikes there were. Series of ever smaller ones are closed at their limit, and
    /// count as far as they were followed.
    pub strikes: u64,
    /// On how many plates the part came to lie flat on its way.
    pub landings: usize,
    /// The smallest inequality that decided, divided by the sum of its terms' sizes; infinite where
    /// nothing was decided.
    pub margin: f64,
}
