//! What a run says: its impacts, the series it closed, and how it ended.

use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::mode::Mode;
use crate::spatial::terms::Effort;
use carom_impact::spatial::{Conclusion, Freedom};
use carom_num::{Rotation, Vec3};

/// An impact.
///
/// # Example
/// A cube of 1 kg falls flat through 0.2 m and stops: its corners take 2 N s together.
/// ```
/// use carom_motion::spatial::{Options, examples, run};
/// use carom_num::Vec3;
/// let (world, start) = examples::falling_cube();
/// let fallen = run(&world, &start, &Options::default(), &mut ())?;
/// let impact = &fallen.impacts[0];
/// assert!((impact.time - 0.2).abs() < 1e-13 && (impact.kinetic_before - 2.0).abs() < 1e-12);
/// let sum = impact.impulses.iter().fold(Vec3::ZERO, |sum, (_, impulse)| sum + *impulse);
/// assert!((sum - Vec3::Z * 2.0).norm() < 1e-12);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Impact {
    /// Time \[s\].
    pub time: f64,
    /// The supports that touch their planes.
    pub touching: Supports,
    /// Those of them that come down on it.
    pub striking: Supports,
    /// Those that were held before it.
    pub held: Supports,
    /// Those that stay on their planes after it.
    pub kept: Supports,
    /// Those of them that slide; without friction none does.
    pub sliding: Supports,
    /// The rotation of the body's axes into the world's.
    pub attitude: Rotation,
    /// Angular velocity before, body axes [rad/s].
    pub spin_before: Vec3,
    /// Angular velocity after, body axes [rad/s].
    pub spin_after: Vec3,
    /// Kinetic energy before \[J\].
    pub kinetic_before: f64,
    /// Kinetic energy after \[J\].
    pub kinetic_after: f64,
    /// Potential energy, zero with the mass centre at the world's origin \[J\].
    pub potential: f64,
    /// The impulse on each touching support, world axes [N s]; where they are a family, that of equal springs, or one that does not pull.
    pub impulses: Vec<(usize, Vec3)>,
    /// The least friction coefficient with which no contact slides. Of a family of impulses it is that of the member which needs least; with friction in the
    /// world, that of these impulses.
    pub friction_demand: f64,
    /// What sharing among the supports leaves open. Where that is the motion, the impulses are one choice: at each moment what
    /// equal springs make of the load, or, where that breaks a cone, the impulses deepest within the cones.
    pub open: Freedom,
    /// How many different motions the law allows: of several, [`crate::spatial::terms::Options::choice`] has chosen.
    pub conclusion: Conclusion,
}

impl Impact {
    /// The supports that touch and leave their planes.
    pub fn opened(&self) -> Supports {
        self.touching.difference(self.kept)
    }
}

/// A series of infinitely many impacts in finite time, closed at its limit.
///
/// # Example
/// Each impact of a cube that rocks leaves a quarter of the spin, and so of the time to the next one, once it
/// lies almost flat.
/// ```
/// use carom_motion::spatial::{Closing, Options, examples, run};
/// let (world, start) = examples::rocking_cube();
/// let rocked = run(&world, &start, &Options::default(), &mut ())?;
/// let Closing { period, ratio, kept, .. } = rocked.closings[0];
/// let impacts = i32::try_from(period).unwrap_or_default();
/// assert!((ratio / 0.25f64.powi(impacts) - 1.0).abs() < 1e-3);
/// assert_eq!(kept.len(), 4);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closing {
    /// Time of the last impact that was resolved \[s\].
    pub time: f64,
    /// Time of the limit \[s\].
    pub limit: f64,
    /// How many impacts make a period.
    pub period: usize,
    /// The ratio of the lengths of successive periods.
    pub ratio: f64,
    /// The supports that rest after it.
    pub kept: Supports,
}

/// A stretch of motion between two events.
///
/// # Example
/// A cube falls through 0.2 m in 0.2 s at g = 10 m/s².
/// ```
/// use carom_motion::spatial::{Mode, Options, Samples, examples, run};
/// let (world, start) = examples::falling_cube();
/// let mut samples = Samples::default();
/// run(&world, &start, &Options::default(), &mut samples)?;
/// let fall = samples.pieces[0];
/// assert_eq!((fall.mode, fall.start_time), (Mode::Flight, 0.0));
/// assert!((fall.end_time - 0.2).abs() < 1e-13 && (fall.end.velocity.z + 2.0).abs() < 1e-12);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// What the body does.
    pub mode: Mode,
    /// Start \[s\].
    pub start_time: f64,
    /// End \[s\].
    pub end_time: f64,
    /// State at the start.
    pub start: State,
    /// State at the end.
    pub end: State,
    /// What ended it.
    pub ended_by: PieceEnd,
}

/// What ends a stretch of motion.
///
/// # Example
/// A cube falls until one of its corners touches the plane.
/// ```
/// use carom_motion::spatial::{Options, PieceEnd, Samples, examples, run};
/// let (world, start) = examples::falling_cube();
/// let mut samples = Samples::default();
/// run(&world, &start, &Options::default(), &mut samples)?;
/// assert!(matches!(samples.pieces[0].ended_by, PieceEnd::Touches { .. }));
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PieceEnd {
    /// A support comes to touch.
    Touches {
        /// Which one.
        support: usize,
    },
    /// The normal force on a support has come to zero.
    LiftsOff {
        /// Which one.
        support: usize,
    },
    /// Friction holds as much as it can.
    FrictionGivesWay,
    /// A slip has come to its end.
    SlipStops,
    /// The place where a support touches has come to the end of a face or of an edge.
    RunsOff {
        /// Which one.
        support: usize,
    },
    /// A circle has come to lie flat.
    Flattens,
    /// A normal force grows without bound: Painlevé's paradox.
    Jams,
    /// It leans over as far as [`crate::spatial::terms::Overturning`] says.
    Overturns,
    /// It flies, and nothing is left that could carry it.
    FliesAway,
    /// A budget is used up.
    BudgetSpent,
}

/// Which clock a question was asked on.
///
/// # Example
/// The foot of a rod that topples fast can press no more once `g (1 − ¾ sin² θ) = ω² cos θ`. Friction would
/// still hold it back, so that without sliding no motion is consistent.
/// ```
/// use carom_motion::spatial::{Clock, End, Options, State, World, examples, run};
/// use carom_num::{Rotation, Vec3};
/// let rod = examples::rod();
/// let start = State::standing(&rod, 0, Rotation::by(Vec3::Y * 0.3), Vec3::Y * 2.9);
/// let world = World::new(rod, Vec3::Z * -10.0).unwrap();
/// let toppled = run(&world, &start, &Options::default(), &mut ())?;
/// assert_eq!(toppled.end, End::NoConsistentOutcome(Clock::Motion));
/// let (sine, cosine) = toppled.state.tilt(Vec3::Z).sin_cos();
/// let force = 10.0 * (1.0 - 0.75 * sine * sine) - toppled.state.spin.y.powi(2) * cosine;
/// assert!(force.abs() < 1e-9);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// In an impact.
    Impact,
    /// In motion: which of the supports that touch at rest are held.
    Motion,
}

/// Which budget was spent.
///
/// # Example
/// Half of a fall of 0.2 s.
/// ```
/// use carom_motion::spatial::{Budget, End, Options, examples, run};
/// let (world, start) = examples::falling_cube();
/// let options = Options { most_time: 0.1, ..Options::default() };
/// let fallen = run(&world, &start, &options, &mut ())?;
/// assert_eq!((fallen.end, fallen.time), (End::BudgetSpent(Budget::Time), 0.1));
/// assert!((fallen.state.centre.z - 0.65).abs() < 1e-15);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Budget {
    /// Of time.
    Time,
    /// Of steps; or a thousand events within 10⁻¹⁰ of the world's time.
    Steps,
    /// Of impacts.
    Impacts,
}

/// How a run ended.
///
/// # Example
/// A rod that stands upright on its foot is in an equilibrium that does not last; a cube that falls flat
/// rests.
/// ```
/// use carom_motion::spatial::{Body, End, Options, State, Supports, World, examples, run};
/// use carom_num::{Mat3, Rotation, Vec3};
/// let (world, start) = examples::falling_cube();
/// let rod = Body::new(1.0, Mat3::diagonal(1.0 / 3.0, 1.0 / 3.0, 1e-3), vec![-Vec3::Z]).unwrap();
/// let upright = State::standing(&rod, 0, Rotation::NONE, Vec3::ZERO);
/// let pole = World::new(rod, Vec3::Z * -10.0).unwrap();
/// let balanced = run(&pole, &upright, &Options::default(), &mut ())?;
/// assert_eq!(balanced.end, End::Balanced { held: Supports::one(0) });
/// let fallen = run(&world, &start, &Options::default(), &mut ())?;
/// assert_eq!(fallen.end, End::AtRest { held: (0..4).collect() });
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// It rests on these supports.
    AtRest {
        /// Three or more, not on one line: all that lie on planes.
        held: Supports,
    },
    /// It stands still on a support or an edge, in an equilibrium that a touch ends. A ball or a capsule that lies still does so too: a touch rolls it on.
    Balanced {
        /// What it stands on.
        held: Supports,
    },
    /// A circle of it has come to lie flat on its plane: all of it touches at once, and what follows is not known.
    Flat {
        /// The supports that touch.
        touching: Supports,
    },
    /// It leans over as far as [`crate::spatial::terms::Overturning`] says.
    Overturned,
    /// It flies and is below all obstacles that have ends, and no plane without ends faces upwards: nothing can carry it any more. It may still brush along upright planes.
    FliesAway,
    /// Without sliding there is no way on.
    NoConsistentOutcome(Clock),
    /// There are several ways on, and [`crate::spatial::terms::Choice::End`] takes none of them.
    Several(Clock),
    /// The budget is used up.
    BudgetSpent(Budget),
    /// The observer has seen enough.
    Stopped,
}

/// A run, from its start to its end.
///
/// # Example
/// A cube falls flat through 0.2 m and lies still from then on.
/// ```
/// use carom_motion::spatial::{Options, examples, run};
/// use carom_num::Vec3;
/// let (world, start) = examples::falling_cube();
/// let fallen = run(&world, &start, &Options::default(), &mut ())?;
/// assert!((fallen.time - 0.2).abs() < 1e-13 && (fallen.state.centre.z - 0.5).abs() < 1e-13);
/// assert_eq!((fallen.state.velocity, fallen.impacts.len()), (Vec3::ZERO, 1));
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// How it ended.
    pub end: End,
    /// When it ended \[s\].
    pub time: f64,
    /// State at the end.
    pub state: State,
    /// All impacts, in their order.
    pub impacts: Vec<Impact>,
    /// All series that were closed.
    pub closings: Vec<Closing>,
    /// The largest change of the energy between two events, in units of m g × reach plus the kinetic energy; without the integration's error it
    /// were 0.
    pub drift: f64,
    /// Work of friction between impacts \[J\]: it is never positive.
    pub friction_work: f64,
    /// Work done.
    pub effort: Effort,
}
