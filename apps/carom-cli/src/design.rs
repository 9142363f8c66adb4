//! `carom design`: which layout makes drops end as wanted.

mod report;

use crate::args::{DesignOptions, Format, Output};
use crate::failure::Failure;
use crate::progress::Progress;
use carom_feeder::{Feeder, Run};
use carom_scene::unit::Dimension;
use carom_scene::{DesignSpace, Problem, ProblemKind, Problems, Scene, Want};
use carom_study::design::{Aim, Design, Found, Goal, Judged, Layout, Limits, Space, search};
use carom_study::yields::{Estimate, Plan, Points, REPETITIONS, sample};
use std::io::Write;

/// Drops of a repetition for each design that is compared in the end; the winner has more.
const MOST_CONFIRMING: u64 = 256;

/// A design and what it is of.
struct Designed<'s> {
    scene: &'s Scene,
    space: &'s DesignSpace<'s>,
    limits: Limits,
    aim: Aim,
    found: Found,
    winner: Option<Winner>,
    seed: u64,
    drops: usize,
    seconds: f64,
}

/// The best layout, in values that a workshop can keep.
struct Winner {
    values: Vec<f64>,
    text: String,
    scene: Scene,
    run: Run,
    judged: Judged,
    yields: Estimate,
    doubled: Estimate,
}

/// A space that counts the drops it is asked for.
struct Counted<'s> {
    space: &'s DesignSpace<'s>,
    progress: &'s Progress,
}

impl Space for Counted<'_> {
    fn dimensions(&self) -> usize {
        self.space.dimensions()
    }

    fn varying(&self) -> usize {
        self.space.varying()
    }

    fn layout(&self, point: &[f64]) -> Option<Layout> {
        self.progress.step();
        self.space.layout(point)
    }

    fn varied(
        &self,
        point: &[f64],
        widened: f64,
    ) -> Option<Box<dyn Fn(&[f64]) -> Option<Feeder> + Sync + '_>> {
        let varied = self.space.varied(point, widened)?;
        Some(Box::new(move |point: &[f64]| {
            self.progress.step();
            varied(point)
        }))
    }
}

pub(crate) fn design(options: &DesignOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let space = scene.design_space()?;
    if !scene.wants().iter().flatten().any(|want| *want != Want::Any) {
        let problem = Problem::new(ProblemKind::MissingKey, "plate", "nothing is wanted on any plate", None);
        let problem = problem.with_help("write want = \"turned\" (or same, or a face) on a plate");
        let file = options.scene.display().to_string();
        return Err(Failure::from(Problems::new(&file, scene.source(), vec![problem])));
    }
    let designed = designed(&scene, &space, options)?;
    report::deliver(&designed, output, output.format == Format::Json, out)
}

/// The limits that a scene writes.
fn limits(scene: &Scene) -> (Limits, Aim) {
    let Some(design) = scene.design() else { return (Limits::default(), Aim::default()) };
    let value = |quantity: &Option<carom_scene::quantity::Quantity>| quantity.as_ref().map(|q| q.value);
    let aim = match design.aim {
        carom_scene::Aim::Yield => Aim::Yield,
        carom_scene::Aim::Height => Aim::Height,
        carom_scene::Aim::Time => Aim::Time,
    };
    let limits = Limits {
        impact_speed: value(&design.max_impact_speed),
        sliding_speed: value(&design.max_sliding_speed),
        height: value(&design.max_height),
        width: value(&design.max_width),
        time: value(&design.max_time),
    };
    (limits, aim)
}

fn designed<'s>(
    scene: &'s Scene,
    space: &'s DesignSpace<'s>,
    options: &DesignOptions,
) -> Result<Designed<'s>, Failure> {
    let (limits, aim) = limits(scene);
    let wanted = |run: &Run| scene.ends_as_wanted(run).unwrap_or(true);
    let confirming = options.samples.div_ceil(REPETITIONS as u64).min(MOST_CONFIRMING);
    let goal = Goal { wanted: &wanted, limits, aim, seed: options.seed, scanned: options.scan, confirming };
    let progress = Progress::new("drops", None);
    let counted = Counted { space, progress: &progress };
    let found = search(&counted, &goal).ok_or_else(|| {
        Failure::Usage(format!("{}: {} quantities are free: too many", scene.name(), space.dimensions()))
    })?;
    let winner = found.winner.as_ref().map(|design| winner(&counted, &goal, design, options.samples));
    let winner = winner.transpose()?.flatten();
    let (drops, seconds) = (progress.count(), progress.seconds());
    drop(progress);
    Ok(Designed { scene, space, limits, aim, found, winner, seed: options.seed, drops, seconds })
}

/// A tenth of a millimetre, a twentieth of a degree, else three digits.
fn rounded(value: f64, dimension: Dimension) -> f64 {
    let step = match dimension {
        Dimension::Length => 1e-4,
        Dimension::Angle => std::f64::consts::PI / 3600.0,
        Dimension::Count => 1.0,
        _ => 10_f64.powi(value.abs().max(1e-12).log10().floor() as i32 - 2),
    };
    (value / step).round() * step
}

/// The winner in round values, confirmed with drops of its own; as it was found where the round one fails.
fn winner(
    counted: &Counted<'_>,
    goal: &Goal<'_>,
    design: &Design,
    samples: u64,
) -> Result<Option<Winner>, Failure> {
    let space = counted.space;
    let exact = space.values(&design.point);
    let round: Vec<f64> =
        exact.iter().zip(space.quantities()).map(|(value, q)| rounded(*value, q.kind.dimension)).collect();
    for values in [round, exact] {
        let Ok(text) = space.text(&values) else { continue };
        let scene = Scene::parse("design.toml", &text)?;
        let run = scene.feeder().run().map_err(|error| Failure::Undone(error.to_string()))?;
        let judged = goal.judged(carom_scene::extent(scene.feeder()), &run);
        if !judged.failed.is_empty() {
            continue;
        }
        let yields = |widened: f64| -> Result<Estimate, Failure> {
            let varied = scene.widened(widened)?;
            let plan = Plan {
                dimensions: varied.quantities().len(),
                samples: samples.div_ceil(REPETITIONS as u64),
                // Other drops than those it was chosen by.
                seed: !goal.seed,
                points: Points::Sobol,
                plates: scene.feeder().plates.len(),
                plate: 0,
            };
            let feeder = |point: &[f64]| {
                counted.progress.step();
                varied.feeder(point)
            };
            let found = sample(&plan, feeder, |run| goal.good(run));
            found.map(|found| found.wanted).map_err(|error| Failure::Undone(error.to_string()))
        };
        let (yields, doubled) = (yields(1.0)?, yields(2.0)?);
        return Ok(Some(Winner { values, text, scene, run, judged, yields, doubled }));
    }
    Ok(None)
}
