//! What a run leaves behind for tables and pictures.

use crate::planar::geometry::{Feature, Pose, State, Twist};
use carom_impact::planar::{ContactState, ImpactType, Slip, StageEnd};
use carom_impact::{Law, Phase};
use carom_num::Vec2;

/// One contact at one instant of a smooth motion.
///
/// # Example
/// A ball of 1 kg that slides at g = 10 m/s² and μ = 0.3 presses with 10 N and is braked with 3 N.
/// ```
/// use carom_motion::planar::{Options, Recorder, Walker, examples};
/// use carom_num::Vec2;
/// let (world, start) = examples::sliding_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let contact = recorder.trace().pieces[0].samples[0].contacts[0];
/// assert!((contact.normal_force - 10.0).abs() < 1e-12 && (contact.tangential_force + 3.0).abs() < 1e-12);
/// assert_eq!((contact.point, contact.slip), (Vec2::ZERO, 3.0));
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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
///
/// # Example
/// A ball that slides to a stop of its slip loses speed at `μ g`, 3 m/s².
/// ```
/// use carom_motion::planar::{Options, Recorder, Walker, examples, trace};
/// let (world, start) = examples::sliding_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let trace::Sample { time, state, .. } = recorder.trace().pieces[0].samples[1];
/// assert!((state.twist.velocity.x - (3.0 - 3.0 * time)).abs() < 1e-9);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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
///
/// # Example
/// A ball slides on the upper face of a floor, to the right.
/// ```
/// use carom_impact::planar::Slip;
/// use carom_motion::planar::{Feature, Obstacle, Options, Recorder, Walker, examples};
/// let (world, start) = examples::sliding_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let held = recorder.trace().pieces[0].held[0];
/// assert_eq!((held.obstacle, held.slip), (0, Slip::Forward));
/// assert_eq!(held.feature, Feature::VertexOnFace { vertex: 0, face: Obstacle::LEFT });
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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
///
/// # Example
/// A disc that starts to slide with v slips until `v/(3 μ g)`, then it rolls.
/// ```
/// use carom_impact::planar::Slip;
/// use carom_motion::planar::{Options, Recorder, Walker, examples, trace};
/// let (world, start) = examples::sliding_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let slide = &recorder.trace().pieces[0];
/// assert!(matches!(slide.ended_by, trace::PieceEnd::SlipZero(held) if held.slip == Slip::Forward));
/// assert!((slide.end_time - 1.0 / 3.0).abs() < 1e-9);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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
    /// It swings to and fro without loss, and nothing is left that could end it.
    Swings,
    /// Something happened to another body that it touches, and the two of them ask again what they do.
    Elsewhere,
    /// The time asked for is over.
    TimeUp,
}

/// One smooth piece of motion: one mode from one event to the next.
///
/// # Example
/// A disc that slides until it rolls keeps two thirds of its speed.
/// ```
/// use carom_motion::planar::{Options, Recorder, Walker, examples};
/// let (world, start) = examples::sliding_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let slide = &recorder.trace().pieces[0];
/// let (before, after) = (slide.start.twist, slide.end.twist);
/// assert!((after.velocity.x / before.velocity.x - 2.0 / 3.0).abs() < 1e-9);
/// assert!((after.velocity.x + after.spin * 0.1).abs() < 1e-9);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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
///
/// # Example
/// A ball falls on a floor: its lowest point approaches with 2 m/s and leaves with 1 m/s, without slip.
/// ```
/// use carom_motion::planar::{Options, Recorder, Walker, examples};
/// let (world, start) = examples::falling_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let contact = recorder.trace().impacts[0].contacts[0];
/// assert!((contact.before.normal + 2.0).abs() < 1e-12 && (contact.after.normal - 1.0).abs() < 1e-12);
/// assert_eq!((contact.before.slip, contact.after.slip), (0.0, 0.0));
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactVelocity {
    /// Along t.
    pub slip: f64,
    /// Along n; an approach is negative.
    pub normal: f64,
}

/// One contact's part in an impact.
///
/// # Example
/// A ball of 1 kg that strikes with 2 m/s and e = 1/2 takes the impulse `m (1 + e) v` and loses `m (1 − e²)
/// v²/2`.
/// ```
/// use carom_motion::planar::{Options, Recorder, Walker, examples};
/// let (world, start) = examples::falling_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let contact = recorder.trace().impacts[0].contacts[0];
/// assert!((contact.normal_impulse - 3.0).abs() < 1e-12);
/// assert!((contact.normal_work + 1.5).abs() < 1e-12);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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
///
/// # Example
/// In compression a ball of 1 kg and 2 m/s takes 2 N s.
/// ```
/// use carom_motion::planar::{Options, Recorder, Walker, examples};
/// let (world, start) = examples::falling_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let compression = recorder.trace().impacts[0].stages[0].contacts[0];
/// assert_eq!((compression.normal_impulse[0], compression.normal_velocity[1]), (0.0, 0.0));
/// assert!((compression.normal_impulse[1] - 2.0).abs() < 1e-12);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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
///
/// # Example
/// A ball without slip is compressed and then rebounds.
/// ```
/// use carom_impact::{Phase, planar::StageEnd};
/// use carom_motion::planar::{Options, Recorder, Walker, examples};
/// let (world, start) = examples::falling_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let stages: Vec<_> = recorder.trace().impacts[0].stages.iter().map(|s| (s.phase, s.ended_by)).collect();
/// let rebound = (Phase::Restitution, StageEnd::RestitutionEnds);
/// assert_eq!(stages, [(Phase::Compression, StageEnd::CompressionEnds), rebound]);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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
///
/// # Example
/// A ball that strikes with e = 1/2 and without slip keeps a quarter of its energy.
/// ```
/// use carom_motion::planar::{Options, Recorder, Walker, examples};
/// let (world, start) = examples::falling_ball();
/// let mut recorder = Recorder::default();
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut recorder)?;
/// let impact = &recorder.trace().impacts[0];
/// assert!((impact.energy_before - 2.0).abs() < 1e-12);
/// assert!((impact.energy_after / impact.energy_before - 0.25).abs() < 1e-12);
/// assert!(!impact.gained_energy && !impact.without_approach);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
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
    /// Largest number of consistent ways on met at a stage: above 1 the impact chose.
    pub branches: usize,
    /// True where the share of compression is open, and another share leaves another motion.
    pub open_share: bool,
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
///
/// # Example
/// A ball strikes first after 0.2 s; its bounces last 0.2 s, 0.1 s, … and are over at 0.6 s. The last few
/// millionths of the world's time, 0.1 s, are not waited for.
/// ```
/// use carom_motion::planar::{Happening, Options, Recorder, Walker, examples};
/// let (world, start) = examples::falling_ball();
/// let mut recorder = Recorder::default();
/// let mut walker = Walker::new(&world, start, vec![], Options::default())?;
/// while walker.advance(&mut recorder)? == Happening::Moves {}
/// let trace = recorder.into_trace();
/// assert!((trace.impacts[1].time - 0.4).abs() < 1e-12 && (trace.impacts[2].time - 0.5).abs() < 1e-12);
/// assert!((trace.accumulations[0].1 - 0.6).abs() < 1e-6);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// Smooth pieces.
    pub pieces: Vec<Piece>,
    /// Impacts.
    pub impacts: Vec<Impact>,
    /// Accumulations of infinitely many impacts that were closed: time [s] of the first impact counted, and of the limit to a millionth of the world's time.
    pub accumulations: Vec<(f64, f64)>,
}
