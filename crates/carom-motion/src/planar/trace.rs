//! What a run leaves behind for tables and pictures.

use super::{Feature, Pose, State, Twist};
use carom_impact::planar::{ContactState, ImpactType, Law, Phase, Slip, StageEnd};
use carom_num::Vec2;

/// One contact at one instant of a smooth motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSample {
    /// Number of the obstacle; another body's number counts on after the obstacles.
    pub obstacle: usize,
    /// The features that touch.
    pub feature: Feature,
    /// Where they touch [m], world frame.
    pub point: Vec2,
    /// Unit normal out of the obstacle into the body.
    pub normal: Vec2,
    /// Normal force on the body [N].
    pub normal_force: f64,
    /// Tangential force on the body along t (the normal turned clockwise) [N].
    pub tangential_force: f64,
    /// Slip velocity along t [m/s].
    pub slip: f64,
}

/// One instant of a smooth motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Time [s].
    pub time: f64,
    /// Pose and velocity.
    pub state: State,
    /// The contacts that transmit force.
    pub contacts: Vec<ContactSample>,
}

/// A contact that is held in a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HeldContact {
    /// Number of the obstacle; another body's number counts on after the obstacles.
    pub obstacle: usize,
    /// The features that touch.
    pub feature: Feature,
    /// How it slips.
    pub slip: Slip,
}

/// Why a smooth piece of motion ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PieceEnd {
    /// An open contact closed: an impact follows.
    Closes {
        /// The obstacle.
        obstacle: usize,
        /// The features that met.
        feature: Feature,
    },
    /// A normal force came to zero.
    ForceZero(HeldContact),
    /// A slip came to zero.
    SlipZero(HeldContact),
    /// A sticking contact reached the friction limit.
    StickLimit(HeldContact),
    /// A contact ran off its feature.
    RunsOff(HeldContact),
    /// `W_nn − sμW_nt` came to zero: the edge of Painlevé's paradox.
    PainleveEdge(HeldContact),
    /// It rests: nothing changes any more.
    Rests,
    /// It flies and can meet nothing any more.
    FliesAway,
    /// Something happened to another body that it touches, and the two of them ask again what they do.
    Elsewhere,
    /// The time asked for is over.
    TimeUp,
}

/// One smooth piece of motion: one mode from one event to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The contacts held, in the order of the samples' contacts; none in flight.
    pub held: Vec<HeldContact>,
    /// Start [s].
    pub start_time: f64,
    /// End [s].
    pub end_time: f64,
    /// Pose and velocity at the start.
    pub start: State,
    /// Pose and velocity at the end.
    pub end: State,
    /// Why it ended.
    pub ended_by: PieceEnd,
    /// Instants between, the first at the start and the last at the end.
    pub samples: Vec<Sample>,
}

/// Velocity of a contact point of the body relative to the obstacle, contact frame [m/s].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactVelocity {
    /// Along t.
    pub slip: f64,
    /// Along n; an approach is negative.
    pub normal: f64,
}

/// One contact's part in an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactContact {
    /// Number of the obstacle; another body's number counts on after the obstacles.
    pub obstacle: usize,
    /// The features that touch.
    pub feature: Feature,
    /// Where they touch [m], world frame.
    pub point: Vec2,
    /// Unit normal out of the obstacle into the body.
    pub normal: Vec2,
    /// Coulomb friction coefficient.
    pub friction: f64,
    /// Coefficient of restitution.
    pub restitution: f64,
    /// Velocity of the contact point before.
    pub before: ContactVelocity,
    /// Velocity of the contact point after.
    pub after: ContactVelocity,
    /// What it does at the end.
    pub state: ContactState,
    /// Normal impulse on the body [N s].
    pub normal_impulse: f64,
    /// Tangential impulse on the body [N s].
    pub tangential_impulse: f64,
    /// Work of the normal impulse [J].
    pub normal_work: f64,
    /// Work of the tangential impulse [J].
    pub tangential_work: f64,
}

/// One contact during one straight stage of an impact: impulses [N s] and velocities [m/s] at its two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactStage {
    /// What it does.
    pub slip: Slip,
    /// Normal impulse so far, at the stage's start and end.
    pub normal_impulse: [f64; 2],
    /// Tangential impulse so far, at the stage's start and end.
    pub tangential_impulse: [f64; 2],
    /// Slip velocity at the stage's start and end.
    pub slip_velocity: [f64; 2],
    /// Normal velocity at the stage's start and end.
    pub normal_velocity: [f64; 2],
}

/// One straight stage of an impact.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactStage {
    /// Compression or restitution.
    pub phase: Phase,
    /// Why it ended.
    pub ended_by: StageEnd,
    /// Each contact, in the order of the impact's contacts.
    pub contacts: Vec<ContactStage>,
}

/// One impact.
#[derive(Clone, Debug, PartialEq)]
pub struct Impact {
    /// Time [s].
    pub time: f64,
    /// Pose of the body, which does not change.
    pub pose: Pose,
    /// Velocity before.
    pub before: Twist,
    /// Velocity after.
    pub after: Twist,
    /// Restitution law used.
    pub law: Law,
    /// Type, where one contact acts.
    pub kind: Option<ImpactType>,
    /// True where no contact approached: an impact forced by friction (Painlevé's paradox).
    pub without_approach: bool,
    /// Each contact that closes or touches, the striking one first.
    pub contacts: Vec<ImpactContact>,
    /// The straight stages.
    pub stages: Vec<ImpactStage>,
    /// Kinetic energy before [J].
    pub energy_before: f64,
    /// Kinetic energy after [J].
    pub energy_after: f64,
    /// True where the law created energy (possible under Newton's).
    pub gained_energy: bool,
    /// Common factor on the restitution coefficients that kept energy from growing; 1 where none was needed.
    pub restitution_scaled: f64,
    /// The normal force [N] that holding the struck contact would need right after, where it is negative: the part lifts off at once.
    pub holding_would_need: Option<f64>,
}

/// Everything a run left behind, in order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// Smooth pieces.
    pub pieces: Vec<Piece>,
    /// Impacts.
    pub impacts: Vec<Impact>,
    /// Accumulations of infinitely many impacts that were closed at their limit: time [s] of the first impact counted and of the limit.
    pub accumulations: Vec<(f64, f64)>,
}
