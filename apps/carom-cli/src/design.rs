//! `carom design`: which layout makes drops end as wanted.

mod report;

use crate::args::{DesignOptions, Format, Output};
use crate::failure::Failure;
use crate::progress::Progress;
use carom_feeder::Run;
use carom_scene::unit::Dimension;
use carom_scene::{DesignSpace, Problem, ProblemKind, Problems, Scene, Want};
use carom_study::design::{
    Aim, Design, Extremes, Found, Goal, Judged, Layout, Limits, Space, Varying, Worst, search, to_the_end,
};
use carom_study::yields::{Estimate, Plan, Points, REPETITIONS, sample};
use carom_words::part;
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
    /// The run followed as far as the part goes.
    to_the_end: Run,
    judged: Judged,
    yields: Estimate,
    doubled: Estimate,
    /// The worst of the drops that the yield was found by.
    worst: Extremes,
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

    fn met(&self, point: &[f64], run: &Run) -> bool {
        self.space.met(point, run)
    }

    fn varied(&self, point: &[f64], widened: f64) -> Option<Varying<'_>> {
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
    blind(&scene)?;
    let designed = designed(&scene, &space, options)?;
    report::deliver(&designed, output, output.format == Format::Json, out)
}

/// A feeder with plates as long as needed has no height and no width to keep or to aim at.
fn blind(scene: &Scene) -> Result<(), Failure> {
    let (limits, aim) = limits(scene);
    let asked = limits.height.is_some() || limits.width.is_some() || aim == Aim::Height;
    let endless = scene.feeder().plates.iter().position(|plate| plate.unbounded);
    match endless {
        Some(plate) if asked => Err(Failure::Usage(format!(
            "{}: plate \"{}\" is as long as needed: without its length (gap or length) the feeder's height and width are not known",
            scene.name(),
            part::obstacle(scene.feeder(), plate)
        ))),
        _ => Ok(()),
    }
}

/// The limits that a scene writes.
fn limits(scene: &Scene) -> (Limits, Aim) {
    scene.design().map(|design| (design.limits(), design.aim)).unwrap_or_default()
}

fn designed<'s>(
    scene: &'s Scene,
    space: &'s DesignSpace<'s>,
    options: &DesignOptions,
) -> Result<Designed<'s>, Failure> {
    let (limits, aim) = limits(scene);
    let confirming = options.samples.div_ceil(REPETITIONS as u64).min(MOST_CONFIRMING);
    let goal = Goal { limits, aim, seed: options.seed, scanned: options.scan, confirming };
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
    let to = |value: f64, step: f64| (value / step).round() * step;
    match (dimension, dimension.unit(dimension.usual())) {
        (Dimension::Length, Some(unit)) => unit.to_si(to(unit.of_si(value) * 10.0, 1.0) / 10.0),
        (Dimension::Angle, Some(unit)) => unit.to_si(to(unit.of_si(value) * 20.0, 1.0) / 20.0),
        (Dimension::Count, _) => value.round(),
        _ => format!("{value:.2e}").parse().unwrap_or(value),
    }
}

/// The winner in round values, confirmed with drops of its own; as it was found where the round one is worse.
fn winner(
    counted: &Counted<'_>,
    goal: &Goal,
    design: &Design,
    samples: u64,
) -> Result<Option<Winner>, Failure> {
    let space = counted.space;
    let exact = space.values(&design.point);
    let round: Vec<f64> = exact
        .iter()
        .zip(space.quantities())
        .enumerate()
        .map(|(i, (value, quantity))| {
            let round = rounded(*value, quantity.kind.dimension);
            if space.within(i, round) { round } else { *value }
        })
        .collect();
    let round = confirmed(counted, goal, round, samples)?;
    // Round values may cost what sampling cannot tell, and no more.
    let good_enough =
        |winner: &Winner| winner.yields.high >= design.yields.low && goal.suffices(&winner.yields);
    match round.filter(good_enough) {
        Some(winner) => Ok(Some(winner)),
        None => {
            let exact = confirmed(counted, goal, exact, samples)?;
            Ok(exact.filter(|winner| goal.suffices(&winner.yields)))
        }
    }
}

/// A layout with these values, judged as a scene of its own; `None` where it fails a demand.
fn confirmed(
    counted: &Counted<'_>,
    goal: &Goal,
    values: Vec<f64>,
    samples: u64,
) -> Result<Option<Winner>, Failure> {
    let scene = counted.space.scene_with(&values)?;
    let text = counted.space.text(&values)?;
    let run = scene.feeder().run().map_err(|error| Failure::Undone(error.to_string()))?;
    let met = |run: &Run| scene.ends_as_wanted(run).unwrap_or(true);
    let judged = goal.judged(scene.feeder(), carom_scene::extent(scene.feeder()), &run, met(&run));
    if !judged.failed.is_empty() {
        return Ok(None);
    }
    let Some(to_the_end) = to_the_end(scene.feeder()) else { return Ok(None) };
    let yields = |widened: f64, worst: &Worst| -> Result<Estimate, Failure> {
        let varied = scene.widened(widened)?;
        let plan = Plan {
            dimensions: varied.dimensions(),
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
        let keeps = |run: &Run| {
            worst.see(run);
            met(run) && goal.limits.keeps(run)
        };
        let found = sample(&plan, feeder, keeps, |_| 0.0);
        found.map(|found| found.wanted).map_err(|error| Failure::Undone(error.to_string()))
    };
    let worst = Worst::default();
    let (yields, doubled) = (yields(1.0, &worst)?, yields(2.0, &Worst::default())?);
    let worst = worst.found();
    Ok(Some(Winner { values, text, scene, run, to_the_end, judged, yields, doubled, worst }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broken_calls::{every_call_of_part_fails, printed};
    use std::path::Path;

    #[test]
    fn every_call_of_a_result_may_fail() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/design_turn_once.toml");
        let options = DesignOptions { scene: file.clone(), scan: 16, samples: 16, seed: 1 };
        let scene = Scene::read(&file).unwrap_or_else(|problems| panic!("{problems}"));
        let space = scene.design_space().unwrap_or_else(|problems| panic!("{problems}"));
        let found = designed(&scene, &space, &options).unwrap_or_else(|failure| panic!("{failure}"));
        assert!(found.winner.is_some(), "there is a layout to write");
        let (limits, aim) = limits(&scene);
        let (drops, seconds) = (found.drops, found.seconds);
        let nothing = Designed {
            scene: &scene,
            space: &space,
            limits,
            aim,
            found: found.found.clone(),
            winner: None,
            seed: 1,
            drops,
            seconds,
        };
        let deliver = |designed: &Designed<'_>, out: &Path| {
            let output = Output { format: Format::Text, out: Some(out.to_owned()) };
            printed(|out| report::deliver(designed, &output, false, out))
        };
        let (some, none) = (|out: &Path| deliver(&found, out), |out: &Path| deliver(&nothing, out));
        let first = every_call_of_part_fails("design", &none, &some);
        // Without a layout the files of an earlier one are obsolete.
        let second = every_call_of_part_fails("design-of-none", &some, &none);
        assert!(first >= 30 && second >= 10, "{first} and {second} calls");
    }
}
