//! The best layout, in round values, confirmed with drops of its own.

use super::{Designed, RunOf, StudyError, Watched};
use carom_scene::unit::Dimension;
use carom_scene::{Scene, Varied};
use carom_study::Device;
use carom_study::design::{Design, Extremes, Goal, Judged, Worst};
use carom_study::yields::{Estimate, Plan, Points, REPETITIONS, sample};
use carom_words::part::Names;

/// The best layout, in values that a workshop can keep.
#[derive(Clone)]
pub struct Winner<S: Designed = Scene> {
    /// The free quantities in their order, SI.
    pub values: Vec<f64>,
    /// The scene as text, tolerances kept.
    pub text: String,
    /// The scene.
    pub scene: S,
    /// Its run where nothing varies.
    pub run: RunOf<S>,
    /// The run followed as far as the part goes.
    pub to_the_end: RunOf<S>,
    /// What it measures where nothing varies.
    pub judged: Judged,
    /// Share of drops that end as wanted within the limits.
    pub yields: Estimate,
    /// The same with every tolerance doubled.
    pub doubled: Estimate,
    /// The worst of the drops that the yield was found by.
    pub worst: Extremes,
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

/// The winner in round values; as it was found where the round one is worse.
pub(super) fn of<S: Designed>(
    watched: &Watched<'_, '_, S>,
    goal: &Goal,
    design: &Design,
    samples: u64,
) -> Result<Option<Winner<S>>, StudyError> {
    let space = watched.space;
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
    let round = confirmed(watched, goal, round, samples)?;
    // Round values may cost what sampling cannot tell, and no more.
    let good_enough =
        |winner: &Winner<S>| winner.yields.high >= design.yields.low && goal.suffices(&winner.yields);
    match round.filter(good_enough) {
        Some(winner) => Ok(Some(winner)),
        None => {
            let exact = confirmed(watched, goal, exact, samples)?;
            Ok(exact.filter(|winner| goal.suffices(&winner.yields)))
        }
    }
}

/// A layout with these values, judged as a scene of its own; `None` where it fails a demand.
fn confirmed<S: Designed>(
    watched: &Watched<'_, '_, S>,
    goal: &Goal,
    values: Vec<f64>,
    samples: u64,
) -> Result<Option<Winner<S>>, StudyError> {
    let undone = |why: String| StudyError::Undone(why);
    let scene = watched.space.scene_with(&values)?;
    let text = watched.space.text(&values)?;
    let run = scene.traced().map_err(|error| undone(error.to_string()))?;
    let met = |run: &RunOf<S>| scene.ends_as_wanted(run).unwrap_or(true);
    let judged = goal.judged(scene.feeder(), scene.feeder().extent(), &run, met(&run));
    if !judged.failed.is_empty() {
        return Ok(None);
    }
    let Some(to_the_end) = scene.feeder().to_the_end() else { return Ok(None) };
    let yields = |widened: f64, worst: &Worst| -> Result<Estimate, StudyError> {
        let varied = Varied::over(&scene, widened)?;
        let plan = Plan {
            dimensions: varied.dimensions(),
            samples: samples.div_ceil(REPETITIONS as u64),
            // Other drops than those it was chosen by.
            seed: !goal.seed,
            points: Points::Sobol,
            plates: scene.feeder().plate_count(),
            plate: 0,
        };
        let feeder = |point: &[f64]| {
            watched.step();
            varied.feeder(point)
        };
        let keeps = |run: &RunOf<S>| {
            worst.see(run);
            met(run) && goal.limits.keeps(run)
        };
        let found = sample(&plan, feeder, keeps, |_| 0.0);
        found.map(|found| found.wanted).map_err(|error| undone(error.to_string()))
    };
    let worst = Worst::default();
    let (yields, doubled) = (yields(1.0, &worst)?, yields(2.0, &Worst::default())?);
    let worst = worst.found();
    Ok(Some(Winner { values, text, scene, run, to_the_end, judged, yields, doubled, worst }))
}
