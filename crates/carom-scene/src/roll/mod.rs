//! Strikes of bodies that roll, rock and pivot: a cylinder at a step, a prism that turns about its edges, a rod on two supports.
//!
//! A kind only *builds* a body among fixed obstacles and names its contacts; what happens comes from the engine.
//! Rolling is forward, to +x, where the roll rate is > 0 (clockwise); angles and spins elsewhere are counter-clockwise.

mod bodies;
mod cylinder;
mod overrides;
mod paper;
pub(crate) mod poses;
mod prism;
mod read;
mod report;
mod rod;
pub(crate) mod spatial;
mod strike;
mod walk;

pub use poses::{MOST_POSES, PoseAt, PoseMark, PosesError, RollPose, RollPoseReport, pose_interval};
pub(crate) use read::grammar_of;
pub use report::{RollEndReport, RollReport, RollStrikeReport};
pub use walk::{RollEnd, RollRun};

use crate::problem::Problems;
use carom_motion::MotionError;
use carom_motion::planar::{State, World};
use carom_num::Vec2;
use std::fmt;

/// The friction coefficient by which the walk holds to the papers' non-sliding law: contacts that keep do not slide.
///
/// End states are asked with friction without bound; the walk needs a finite coefficient: a slip then dies within a share of 1/1000 of an impact. A thousand is the largest that was found
/// to work: with 10⁴ and more the products of the coefficients at two contacts that stick reach the rounding of their equations, and bodies
/// that rest on both are said to slide.
pub(crate) const NON_SLIDING: f64 = 1e3;

/// What rolls.
///
/// # Example
/// ```
/// use carom_words::Words;
/// assert_eq!(carom_scene::RollKind::words(), ["cylinder", "prism", "rod"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RollKind {
    /// A cylinder, hoop or ball that meets a step or a second surface.
    Cylinder,
    /// A prism that turns about an edge until the next one strikes.
    Prism,
    /// A rod on two point supports.
    Rod,
}

carom_words::words! {
    RollKind {
        Cylinder = "cylinder",
        Prism = "prism",
        Rod = "rod",
    }
}

/// A body that rolls, ready to be followed.
///
/// # Example
/// A square that strikes with its next edge keeps a quarter of its spin, and a sixteenth of its energy.
/// ```
/// use carom_scene::*;
/// let square = RollProblem::parse(RollKind::Prism, "square.toml", "sides = 4\nstrikes = 1", &[])?;
/// let run = square.follow()?;
/// let impact = &run.trace.impacts[0];
/// assert!((impact.after.spin / impact.before.spin - 0.25).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RollProblem {
    /// What rolls.
    pub kind: RollKind,
    /// The body among its obstacles, SI.
    pub world: World,
    /// Where it starts.
    pub start: State,
    /// Friction coefficient; `None` for the non-sliding law.
    pub friction: Option<f64>,
    /// Coefficient of restitution of every obstacle.
    pub restitution: f64,
    /// Name of each obstacle.
    pub obstacles: Vec<String>,
    /// Segments that belong to the picture and are never reached.
    pub unreached: Vec<[Vec2; 2]>,
    /// Strikes to follow, where that is written.
    pub strikes: Option<u32>,
    /// Time to follow it at most [s].
    pub most_time: f64,
    /// The file as written, and the overrides after it.
    pub source: String,
}

impl RollProblem {
    /// Reads the TOML text of a roll file and the overrides `key=value` on top of it. `file` is the name its problems are reported under;
    /// those of the overrides are reported under `--set`.
    ///
    /// # Errors
    /// Every problem found: of the file, then of the overrides.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{RollKind, RollProblem};
    /// let ball = RollProblem::parse(RollKind::Cylinder, "ball.toml", "inertia_ratio = 0.4", &["gamma=20 deg".into()])?;
    /// let run = ball.follow()?;
    /// // It separates from the ground and rolls up the second surface, at (b + cos 2γ)/(1 + b) of its rate.
    /// let share = run.trace.impacts[0].after.spin / run.trace.impacts[0].before.spin;
    /// assert!((share - 0.832889).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parse(
        kind: RollKind,
        file: &str,
        source: &str,
        overrides: &[String],
    ) -> Result<Self, RollProblems> {
        read::parse(kind, file, source, overrides)
    }

    /// Follows the body through its strikes.
    ///
    /// # Errors
    /// A fault of the numbers.
    ///
    /// # Example
    /// As many strikes as are asked for.
    /// ```
    /// use carom_scene::*;
    /// let square = RollProblem::parse(RollKind::Prism, "square.toml", "sides = 4\nstrikes = 1", &[])?;
    /// let run = square.follow()?;
    /// assert_eq!((run.trace.impacts.len(), run.end), (1, RollEnd::StrikesReached));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn follow(&self) -> Result<RollRun, MotionError> {
        walk::follow(self, None).map(|(run, _)| run)
    }

    /// Name of an obstacle.
    pub fn obstacle_name(&self, obstacle: usize) -> &str {
        self.obstacles.get(obstacle).map_or("?", String::as_str)
    }
}

/// Every problem of a roll file and of the overrides on top of it: at least one of the two has some.
///
/// # Example
/// What is wrong with a file and what is wrong with an override is told at once.
/// ```
/// use carom_scene::{RollKind, RollProblem};
/// let set = ["strikes=none".to_owned()];
/// let problems = RollProblem::parse(RollKind::Prism, "mine.toml", "sides = 'many'", &set).unwrap_err();
/// assert_eq!(problems.0.len(), 2);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RollProblems(pub Vec<Problems>);

impl fmt::Display for RollProblems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, problems) in self.0.iter().enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            write!(f, "{problems}")?;
        }
        Ok(())
    }
}

impl std::error::Error for RollProblems {}
