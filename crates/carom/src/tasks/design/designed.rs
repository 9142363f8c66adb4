//! What a design asks of a scene beyond what every study does: in the plane and in space.

use crate::tasks::{design_page, drawings, space};
use carom_feeder::{Run, RunError, spatial};
use carom_num::Vec2;
use carom_num::elementary::atan2;
use carom_scene::{DesignExitReport, Drawn, Scene, SpaceScene};
use carom_study::Device;

/// What is told of how a part leaves the last plate.
#[derive(Clone, Debug, PartialEq)]
pub struct Leaving {
    /// When [s].
    pub time: f64,
    /// How fast [m/s].
    pub speed: f64,
    /// How far its velocity points below the horizontal [rad].
    pub below: f64,
    /// How it is turned and turns, in words.
    pub turned: String,
    /// The same for a program.
    pub report: DesignExitReport,
}

/// A scene whose layout may be chosen.
///
/// # Example
/// ```
/// use carom::{scene::Scene, tasks::design::Designed};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let run = scene.traced()?;
/// assert!(Scene::leaving(&run).is_none(), "it stays on the lower plate");
/// # Ok::<(), carom::Error>(())
/// ```
pub trait Designed: Drawn {
    /// Its run, with stages, strikes and samples.
    ///
    /// # Errors
    /// A feeder that cannot be run, a fault of the numbers.
    fn traced(&self) -> Result<RunOf<Self>, RunError>;
    /// How many strikes of a run are on a plate or wall, by its number: plates first.
    fn strikes(run: &RunOf<Self>, obstacle: usize) -> usize;
    /// How the part leaves the last plate; `None` where it does not.
    fn leaving(run: &RunOf<Self>) -> Option<Leaving>;
    /// The files that show a layout, with what is said of it; the page comes last.
    fn shown(&self, run: &RunOf<Self>, said: Vec<String>) -> Vec<(&'static str, String)>;
}

/// What a drop of a scene says.
pub type RunOf<S> = <<S as Drawn>::Feeder as Device>::Run;

impl Designed for Scene {
    fn traced(&self) -> Result<Run, RunError> {
        self.feeder().run()
    }

    fn strikes(run: &Run, obstacle: usize) -> usize {
        let on = |impact: &&carom_motion::planar::trace::Impact| {
            impact.contacts.iter().any(|contact| contact.obstacle == obstacle)
        };
        run.trace.impacts.iter().filter(on).count()
    }

    fn leaving(run: &Run) -> Option<Leaving> {
        let exit = run.exit.as_ref()?;
        let (velocity, state) = (exit.state.twist.velocity, &exit.state);
        Some(Leaving {
            time: exit.time,
            speed: velocity.norm(),
            below: atan2(-velocity.y, velocity.x.abs()),
            turned: format!(
                "its drawing turned by {:.1}°, turning at {:.3} 1/s",
                state.pose.angle.to_degrees(),
                state.twist.spin
            ),
            report: DesignExitReport::Plane(carom_scene::exit_report(exit)),
        })
    }

    fn shown(&self, run: &Run, said: Vec<String>) -> Vec<(&'static str, String)> {
        let mut files = drawings(self).to_vec();
        files.push(("report.html", design_page(self, run, said)));
        files
    }
}

impl Designed for SpaceScene {
    fn traced(&self) -> Result<spatial::Run, RunError> {
        self.feeder().run()
    }

    fn strikes(run: &spatial::Run, obstacle: usize) -> usize {
        run.struck.iter().filter(|struck| **struck == obstacle).count()
    }

    fn leaving(run: &spatial::Run) -> Option<Leaving> {
        let exit = run.exit.as_ref()?;
        let velocity = exit.state.velocity;
        Some(Leaving {
            time: exit.time,
            speed: velocity.norm(),
            below: atan2(-velocity.y, Vec2::new(velocity.x, velocity.z).norm()),
            turned: format!("turning at {:.3} 1/s", exit.state.spin.norm()),
            report: DesignExitReport::Space(exit.into()),
        })
    }

    fn shown(&self, run: &spatial::Run, said: Vec<String>) -> Vec<(&'static str, String)> {
        vec![("report.html", space::design_page(self, run, said))]
    }
}
