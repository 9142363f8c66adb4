//! Which layout of a scene makes drops end as wanted: the study of `carom design`.

mod designed;
mod report;
mod said;
mod winner;

pub use designed::{Designed, Leaving, RunOf};
pub use said::unit;
pub use winner::Winner;

use super::StudyError;
use carom_scene::{DesignSpace, Scene};
use carom_study::Device;
use carom_study::design::{Aim, Found, Goal, Layout, Limits, Looked, Space, Varying, search};
use carom_study::yields::REPETITIONS;
use carom_words::part;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How a search is made.
///
/// # Example
/// ```
/// use carom::{scene::Scene, tasks::design::DesignPlan};
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let quick = DesignPlan { scan: 256, ..DesignPlan::usual(&scene) };
/// assert_eq!((quick.samples, quick.seed), (16_384, 1));
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DesignPlan {
    /// Layouts of the first look.
    pub scan: u64,
    /// Drops that confirm the winner.
    pub samples: u64,
    /// What every random number comes from.
    pub seed: u64,
}

impl DesignPlan {
    /// What is usual for a scene: fewer drops in space, where each costs more.
    pub fn usual<S: Designed>(_: &S) -> Self {
        let pace = S::Feeder::PACE;
        Self { scan: pace.scanned, samples: pace.winner, seed: 1 }
    }
}

/// A search and what it is of.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks::design::{DesignPlan, DesignStudy, design_space}};
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let space = design_space(&scene).unwrap();
/// let plan = DesignPlan { scan: 64, samples: 64, seed: 1 };
/// let found = DesignStudy::searched(&scene, &space, plan, || {}, |_| {}).unwrap();
/// assert!(found.winner.is_some_and(|winner| winner.yields.share > 0.5));
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone)]
pub struct DesignStudy<'s, S: Designed = Scene> {
    /// The scene.
    pub scene: &'s S,
    /// What it leaves open.
    pub space: &'s DesignSpace<'s, S>,
    /// What a layout must keep.
    pub limits: Limits,
    /// What it is to be best at.
    pub aim: Aim,
    /// What the search found.
    pub found: Found,
    /// The best layout, in values that a workshop can keep.
    pub winner: Option<Winner<S>>,
    /// What every random number came from.
    pub seed: u64,
    /// Drops in all.
    pub drops: usize,
}

/// What a scene leaves open, where its limits can be judged.
///
/// # Errors
/// See [`StudyError`].
pub fn design_space<S: Designed>(scene: &S) -> Result<DesignSpace<'_, S>, StudyError> {
    let space = DesignSpace::of(scene)?;
    blind(scene)?;
    Ok(space)
}

/// A feeder with plates as long as needed has no height and no width to keep or to aim at.
fn blind(scene: &impl Designed) -> Result<(), StudyError> {
    let (limits, aim) = limits(scene);
    let asked = limits.height.is_some() || limits.width.is_some() || aim == Aim::Height;
    let endless = scene.feeder().plate_ends().iter().position(Option::is_none);
    match endless {
        Some(plate) if asked => Err(StudyError::Asked(format!(
            "{}: plate \"{}\" is as long as needed: without its length (gap or length) the feeder's height and width are not known",
            scene.name(),
            part::obstacle(scene.feeder(), plate)
        ))),
        _ => Ok(()),
    }
}

/// The limits that a scene writes.
fn limits(scene: &impl Designed) -> (Limits, Aim) {
    scene.design().map(|design| (design.limits(), design.aim)).unwrap_or_default()
}

/// A space that counts the drops it is asked for, and says so.
struct Watched<'w, 's, S: Designed> {
    space: &'s DesignSpace<'s, S>,
    drops: AtomicUsize,
    step: &'w (dyn Fn() + Sync),
    looked: &'w (dyn Fn(&Looked<'_>) + Sync),
}

impl<S: Designed> Watched<'_, '_, S> {
    fn step(&self) {
        self.drops.fetch_add(1, Ordering::Relaxed);
        (self.step)();
    }
}

impl<S: Designed> Space for Watched<'_, '_, S> {
    type Feeder = S::Feeder;

    fn dimensions(&self) -> usize {
        self.space.dimensions()
    }

    fn varying(&self) -> usize {
        self.space.varying()
    }

    fn layout(&self, point: &[f64]) -> Option<Layout<S::Feeder>> {
        self.step();
        self.space.layout(point)
    }

    fn met(&self, point: &[f64], run: &RunOf<S>) -> bool {
        self.space.met(point, run)
    }

    fn varied(&self, point: &[f64], widened: f64) -> Option<Varying<'_, S::Feeder>> {
        let varied = self.space.varied(point, widened)?;
        Some(Box::new(move |point: &[f64]| {
            self.step();
            varied(point)
        }))
    }

    fn looked(&self, looked: &Looked<'_>) {
        (self.looked)(looked);
    }
}

impl<'s, S: Designed> DesignStudy<'s, S> {
    /// Searches the space of a scene; `step` is called after each drop, `looked` after each look.
    ///
    /// # Errors
    /// More quantities are free than there are dimensions for; a drop of the winner that cannot be computed.
    pub fn searched(
        scene: &'s S,
        space: &'s DesignSpace<'s, S>,
        plan: DesignPlan,
        step: impl Fn() + Sync,
        looked: impl Fn(&Looked<'_>) + Sync,
    ) -> Result<Self, StudyError> {
        let (limits, aim) = limits(scene);
        let confirming = plan.samples.div_ceil(REPETITIONS as u64).min(S::Feeder::PACE.confirming);
        let goal = Goal { limits, aim, seed: plan.seed, scanned: plan.scan, confirming };
        let watched = Watched { space, drops: AtomicUsize::new(0), step: &step, looked: &looked };
        let found = search(&watched, &goal).ok_or_else(|| {
            StudyError::Asked(format!(
                "{}: {} quantities are free: too many",
                scene.name(),
                space.dimensions()
            ))
        })?;
        let winner = match &found.winner {
            Some(design) => winner::of(&watched, &goal, design, plan.samples)?,
            None => None,
        };
        let drops = watched.drops.into_inner();
        Ok(Self { scene, space, limits, aim, found, winner, seed: plan.seed, drops })
    }
}
