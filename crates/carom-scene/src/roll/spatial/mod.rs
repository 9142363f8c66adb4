//! Strikes of bodies in space, sliding where a friction is written: a pyramid that rolls over its lateral edges, a stool that rocks and wobbles on its supports.
//!
//! A kind only *builds* a body on points over a plane, names the points and says on which faces it may lie; what happens comes from the engine.
//! World axes: z is the plane's normal, the plane is z = 0. Spins are in body axes, velocities and impulses in world axes.

mod body;
mod body_report;
mod body_shape;
mod follow;
mod homogeneous;
mod pose_report;
mod pyramid;
mod read;
mod report;
mod rough;
mod rough_strike;
mod setup;
mod states;
mod stl;
mod stool;
mod strike_report;
mod throws;

pub(crate) use body::heft as read_mass;
pub use body::{Throw, ThrownBody};
pub use body_report::{RestingReport, ThrownBodyReport, ThrownFaceReport, ThrownVertexReport};
pub use body_shape::ThrownShape;
pub(crate) use body_shape::read as read_shape;
pub use follow::{SpatialRollRun, SpatialStrike};
pub use pose_report::{PoseEndReport, PoseReport, PoseThrowReport, ThrowRangeReport};
pub(crate) use read::grammar_of;
pub use report::{
    SpatialEndReport, SpatialRollPoseReport, SpatialRollReport, SpatialSeriesReport, SpatialStageReport,
    TiltReport,
};
pub use setup::SpatialDrawing;
pub use strike_report::{
    ClosedFormReport, SpatialContactReport, SpatialEndStateReport, SpatialForkReport, SpatialRejectedReport,
    SpatialStrikeReport,
};
pub use throws::THROW_DIMENSIONS;
pub(crate) use throws::{lying, options_of_throws};

use super::RollProblems;
use super::poses::{PosesError, shown};
use crate::input::{Disk, Files};
use carom_motion::MotionError;
use carom_motion::spatial::{Choice, Options, Overturning, State, Supports, World};
use carom_num::Vec3;

/// Steps after which a body is no longer followed: some come of each strike, and what takes more makes no way.
const MOST_STEPS: u64 = 100_000;

/// What moves over a plane in space.
///
/// # Example
/// ```
/// use carom_words::Words;
/// assert_eq!(carom_scene::SpatialRollKind::words(), ["pyramid", "stool", "body"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpatialRollKind {
    /// A pyramid on a regular base that turns about a lateral edge until the next face strikes.
    Pyramid,
    /// A body on supports on a circle.
    Stool,
    /// A polyhedron that is thrown.
    Body,
}

carom_words::words! {
    SpatialRollKind {
        Pyramid = "pyramid",
        Stool = "stool",
        Body = "body",
    }
}

/// A body on points over a plane, ready to be followed.
///
/// # Example
/// A stool where nothing else is written stands on four supports.
/// ```
/// use carom_scene::*;
/// let cube = SpatialRollProblem::parse(SpatialRollKind::Stool, "cube.toml", "axis = [1, 1, 0]", &[])?;
/// let run = cube.follow()?;
/// assert_eq!((cube.points.len(), cube.world.body().supports().len()), (4, 4));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpatialRollProblem {
    /// What moves.
    pub kind: SpatialRollKind,
    /// The body over its plane, SI.
    pub world: World,
    /// Where it starts.
    pub start: State,
    /// Name of each of the points on which it stands.
    pub points: Vec<String>,
    /// What is drawn.
    pub drawing: SpatialDrawing,
    /// Unit normals, into the body and in its axes, of the faces on which it may lie: its tilt is the angle of the nearest one from flat.
    pub faces: Vec<Vec3>,
    /// The pyramid's shape, where it is one.
    pub pyramid: Option<PyramidShape>,
    /// The polyhedron, where one is thrown.
    pub thrown: Option<ThrownBody>,
    /// Strikes to follow, where that is written.
    pub strikes: Option<u32>,
    /// Time to follow it at most \[s\].
    pub most_time: f64,
    /// What is done where the law allows several ways on.
    pub choice: Choice,
    /// True: the run ends where it leans over its support.
    pub overturns: bool,
    /// The file as written, and the overrides after it.
    pub source: String,
}

/// The shape of a pyramid on a regular base.
///
/// # Example
/// ```
/// use carom_scene::*;
/// let text = "sides = 6\ncircumradius = 0.1\nheight = 0.15\nmass = 1";
/// let pyramid = SpatialRollProblem::parse(SpatialRollKind::Pyramid, "pyramid.toml", text, &[])?;
/// let PyramidShape { sides, height, circumradius, homogeneous } = pyramid.pyramid.unwrap();
/// assert_eq!((sides, height, circumradius, homogeneous), (6, 0.15, 0.1, true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PyramidShape {
    /// Sides of the base.
    pub sides: u32,
    /// \[m\].
    pub height: f64,
    /// Circumradius of the base \[m\].
    pub circumradius: f64,
    /// True where mass centre and inertia are those of the solid.
    pub homogeneous: bool,
}

impl SpatialRollProblem {
    /// The names of some of its points.
    pub(super) fn names_of(&self, points: Supports) -> Vec<String> {
        carom_words::roll_space::points(&self.points, points)
    }

    /// Reads the TOML text of a roll file and the overrides `key=value` on top of it, as [`super::RollProblem::parse`].
    ///
    /// # Errors
    /// Every problem found: of the file, then of the overrides.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{SpatialRollKind, SpatialRollProblem};
    /// let cube = SpatialRollProblem::parse(SpatialRollKind::Stool, "cube.toml", "axis = [1, 1, 0]", &[])?;
    /// let run = cube.follow()?;
    /// // A cube that is let go on its edge rocks: each impact leaves a sixteenth of its energy.
    /// let first = &run.strikes[0].impact;
    /// assert!((first.kinetic_after / first.kinetic_before - 1.0 / 16.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parse(
        kind: SpatialRollKind,
        file: &str,
        source: &str,
        overrides: &[String],
    ) -> Result<Self, RollProblems> {
        Self::parse_with(kind, file, source, overrides, &Disk)
    }

    /// As [`SpatialRollProblem::parse`], with the files that it names from elsewhere than the disk: see [`Files`].
    ///
    /// # Errors
    /// As [`SpatialRollProblem::parse`].
    pub fn parse_with(
        kind: SpatialRollKind,
        file: &str,
        source: &str,
        overrides: &[String],
        files: &dyn Files,
    ) -> Result<Self, RollProblems> {
        read::parse(kind, file, source, overrides, files)
    }

    /// How exactly and how long it is followed.
    pub fn options(&self) -> Options {
        Options {
            most_time: self.most_time,
            most_steps: MOST_STEPS,
            choice: self.choice,
            overturning: self.overturns.then_some(Overturning::Beyond),
            ..Options::default()
        }
    }

    /// Follows the body through its strikes.
    ///
    /// # Errors
    /// A fault of the numbers.
    ///
    /// # Example
    /// Each strike of a cube leaves a sixteenth of its energy.
    /// ```
    /// use carom_scene::*;
    /// let cube = SpatialRollProblem::parse(SpatialRollKind::Stool, "cube.toml", "axis = [1, 1, 0]", &[])?;
    /// let run = cube.follow()?;
    /// let impact = &run.strikes[1].impact;
    /// assert!((impact.kinetic_after / impact.kinetic_before - 1.0 / 16.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn follow(&self) -> Result<SpatialRollRun, MotionError> {
        follow::follow(self, None).map(|(run, _)| run)
    }

    /// As [`SpatialRollProblem::follow`], and keeps its poses at all multiples of an interval \[s\] and at every strike.
    ///
    /// # Errors
    /// A fault of the numbers, or too many poses.
    pub fn follow_showing(&self, interval: f64) -> Result<SpatialRollRun, PosesError<MotionError>> {
        shown(follow::follow(self, Some(interval)), |run| run.end_time)
    }

    /// The angle from flat of the face that is nearest to the plane \[rad\].
    pub fn tilt(&self, state: &State) -> f64 {
        self.faces.iter().map(|face| state.tilt(*face)).fold(f64::INFINITY, f64::min)
    }
}
