//! A body in space that rolls or is thrown, followed and told: what `carom roll` says of it.

mod closed_form;
mod figure;
pub mod words;

pub use figure::{drawing, notes};

use carom_figure::{LiveSolid, live_solid};
use carom_motion::MotionError;
use carom_scene::{SpatialRollProblem, SpatialRollReport, SpatialRollRun};

/// A body in space, its motion, and what a program is told of it.
///
/// # Example
/// ```
/// use carom::{scene::{SpatialRollKind, SpatialRollProblem}, tasks::solid::SolidStudy};
/// let cube = SpatialRollProblem::parse(SpatialRollKind::Stool, "cube.toml", "axis = [1, 1, 0]", &[])?;
/// assert!(SolidStudy::of(cube)?.page("cube").contains("Tilt against time"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct SolidStudy {
    /// What moves.
    pub problem: SpatialRollProblem,
    /// Its motion.
    pub run: SpatialRollRun,
    /// The same as data; where a closed form covers a strike, what it says.
    pub report: SpatialRollReport,
}

impl SolidStudy {
    /// Follows it.
    ///
    /// # Errors
    /// A fault of the numbers.
    pub fn of(problem: SpatialRollProblem) -> Result<Self, MotionError> {
        let run = problem.follow()?;
        Ok(Self::of_run(problem, run))
    }

    /// What a run that is there already says.
    pub fn of_run(problem: SpatialRollProblem, run: SpatialRollRun) -> Self {
        let mut report = SpatialRollReport::new(&problem, &run);
        for (shown, strike) in report.strikes.iter_mut().zip(&run.strikes) {
            shown.closed_form = closed_form::of(&problem, strike);
        }
        Self { problem, run, report }
    }

    /// Its report, one HTML page.
    pub fn page(&self, name: &str) -> String {
        figure::shown(self, name, carom_figure::solid_report)
    }

    /// The report piece by piece, for a page that stays open.
    pub fn live(&self) -> LiveSolid {
        figure::shown(self, "", live_solid)
    }
}
