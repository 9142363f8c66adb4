//! What a run is given, and why there may be none.

use crate::MotionError;
use crate::tolerance::{SPATIAL_CLOSING, SPATIAL_TOLERANCE, UNIT_LENGTH};
use carom_impact::spatial::Preference;
use carom_num::Vec3;

/// What is done where the law of impact, or of motion, allows several ways on.
///
/// # Example
/// Of several ways on, the one that keeps the most contacts is followed where nothing else is said.
/// ```
/// use carom_impact::spatial::Preference;
/// use carom_motion::spatial::{Choice, Options};
/// assert_eq!(Options::default().choice.preference(), Preference::MostKept);
/// assert_eq!(Choice::KeepFewest.preference(), Preference::MostOpen);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Choice {
    /// The way on that keeps the most contacts is followed; among equals the first, in the order of [`carom_impact::spatial::StatesOfKeeping`].
    #[default]
    KeepMost,
    /// The way on that keeps the fewest contacts is followed; among equals the last.
    KeepFewest,
    /// The run ends.
    End,
}

impl Choice {
    /// What it says where several ways on are consistent with friction.
    ///
    /// # Example
    /// Where a run ends at a fork, the state that is shown is that of the most contacts.
    /// ```
    /// use carom_motion::spatial::Choice;
    /// assert_eq!(Choice::End.preference(), Choice::KeepMost.preference());
    /// assert_ne!(Choice::KeepFewest.preference(), Choice::KeepMost.preference());
    /// ```
    pub fn preference(self) -> Preference {
        match self {
            Self::KeepMost | Self::End => Preference::MostKept,
            Self::KeepFewest => Preference::MostOpen,
        }
    }
}

/// When a body counts as overturned.
///
/// # Example
/// A cube that is pushed over an edge is overturned where its centre is above that edge: at 45°.
/// ```
/// use carom_motion::spatial::{End, Options, Overturning, State, World, examples, run};
/// use carom_num::{Rotation, Vec3};
/// let cube = examples::cube();
/// let start = State::standing(&cube, 1, Rotation::by(Vec3::Y * 0.1), Vec3::Y * 2.5);
/// let world = World::new(cube, Vec3::Z * -10.0).unwrap();
/// let options = Options { overturning: Some(Overturning::Beyond), ..Options::default() };
/// let over = run(&world, &start, &options, &mut ())?;
/// assert_eq!(over.end, End::Overturned);
/// assert!((over.state.tilt(Vec3::Z) - std::f64::consts::FRAC_PI_4).abs() < 1e-12);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Overturning {
    /// When an axis of the body leans by this much from the normal of the plane that its foot is on, in flight of the first plane.
    Tilt {
        /// A unit vector of the body's axes, upright at first.
        axis: Vec3,
        /// In (0, π] \[rad\].
        angle: f64,
    },
    /// When the mass centre, seen from above, passes over the support or the edge that the body turns about, away from the middle of its supports.
    Beyond,
}

/// How exactly and how long to run.
///
/// # Example
/// A rod that topples from 0.1 to 0.5 rad gains `m g (cos 0.1 − cos 0.5)`; about its foot it has `½ (4/3)
/// ω²`.
/// ```
/// use carom_motion::spatial::{End, Options, Overturning, State, World, examples, run};
/// use carom_num::{Rotation, Vec3};
/// let rod = examples::rod();
/// let start = State::standing(&rod, 0, Rotation::by(Vec3::Y * 0.1), Vec3::ZERO);
/// let world = World::new(rod, Vec3::Z * -10.0).unwrap();
/// let overturning = Some(Overturning::Tilt { axis: Vec3::Z, angle: 0.5 });
/// let options = Options { overturning, ..Options::default() };
/// let toppled = run(&world, &start, &options, &mut ())?;
/// assert_eq!(toppled.end, End::Overturned);
/// let gained = 10.0 * (0.1f64.cos() - 0.5f64.cos());
/// assert!((toppled.state.spin.y.powi(2) / 1.5 - gained).abs() < 1e-11);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Tolerance of a step: of the attitude as it is, of the spin in its own size or the world's unit, whichever is larger.
    pub tolerance: f64,
    /// Time after which the run ends \[s\].
    pub most_time: f64,
    /// Steps after which the run ends.
    pub most_steps: u64,
    /// Impacts after which the run ends.
    pub most_impacts: u64,
    /// A series of impacts is closed at its limit once this much of the world's time is left of it, and what three successive ratios of its periods differ by moves
    /// the limit by less than a thousandth of that.
    pub closing: f64,
    /// Several ways on.
    pub choice: Choice,
    /// Ends the run where the body leans over.
    pub overturning: Option<Overturning>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            tolerance: SPATIAL_TOLERANCE,
            most_time: 600.0,
            most_steps: 1_000_000,
            most_impacts: 10_000,
            closing: SPATIAL_CLOSING,
            choice: Choice::KeepMost,
            overturning: None,
        }
    }
}

/// Counts of the work done: the same for the same input, on any machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
    /// Accepted steps.
    pub steps: u64,
    /// Steps that were made again, shorter.
    pub refused_steps: u64,
    /// Heights and event functions looked at.
    pub event_evaluations: u64,
    /// Questions which supports are held, between impacts.
    pub questions: u64,
    /// Impacts.
    pub impacts: u64,
}

impl Options {
    /// # Errors
    /// The first option that is outside its domain.
    ///
    /// # Example
    /// No time is no budget.
    /// ```
    /// use carom_motion::spatial::Options;
    /// assert!(Options::default().check().is_ok());
    /// let error = Options { most_time: 0.0, ..Options::default() }.check().unwrap_err();
    /// assert_eq!(error.to_string(), "most time is 0: allowed is finite and > 0");
    /// ```
    pub fn check(&self) -> Result<(), MotionError> {
        let positive =
            [("tolerance", self.tolerance), ("most time", self.most_time), ("closing", self.closing)];
        for (option, value) in positive {
            if !(value > 0.0 && value.is_finite()) {
                return Err(MotionError::Option { option, value, allowed: "finite and > 0" });
            }
        }
        let Some(Overturning::Tilt { axis, angle }) = self.overturning else { return Ok(()) };
        if !(angle > 0.0 && angle <= std::f64::consts::PI) {
            return Err(MotionError::Option { option: "angle", value: angle, allowed: "> 0 and <= pi" });
        }
        let length = axis.norm();
        if (length - 1.0).abs() > UNIT_LENGTH || length.is_nan() {
            return Err(MotionError::Option { option: "length of the axis", value: length, allowed: "1" });
        }
        Ok(())
    }
}
