//! A yield study as a page.

use super::{YieldStudy, file_of};
use crate::tasks::{MADE_BY, quoted};
use carom_figure::{YieldFigure, YieldQuantity, YieldWorst, live_yield, yield_report};
use carom_scene::quantity::Tolerance;
use carom_scene::{Drawn, NamedQuantity, labelled};
use carom_study::Device;
use carom_study::yields::{Points, REPETITIONS, Sensitivity, Worst};
use carom_words::part::Names;
use carom_words::{part, study};
use std::path::Path;

/// Digits of a value, as a drawing shows it.
const DIGITS: usize = 5;

impl<S: Drawn> YieldStudy<'_, S> {
    /// The page; `folder` is where the drops to look at are saved, for the commands that run them.
    pub fn page(&self, folder: impl AsRef<Path>) -> String {
        with_figure(self, folder.as_ref(), false, yield_report)
    }

    /// Its sections without their frame, for a page that can open the drops of [`YieldStudy::worst_scenes`] itself.
    pub fn live(&self) -> String {
        with_figure(self, Path::new(""), true, live_yield)
    }
}

fn with_figure<S: Drawn>(
    studied: &YieldStudy<'_, S>,
    folder: &Path,
    live: bool,
    show: impl Fn(&YieldFigure<'_>) -> String,
) -> String {
    let feeder = studied.scene.feeder();
    let plates: Vec<String> = (0..feeder.plate_count()).map(|plate| part::obstacle(feeder, plate)).collect();
    let labels = |found: Vec<(String, Sensitivity)>| {
        found.into_iter().map(|(path, share)| (labelled(&path).into_owned(), share)).collect::<Vec<_>>()
    };
    let ranked = studied.ranked().map(labels);
    let mut quantities: Vec<YieldQuantity> = studied.varied.quantities().map(quantity).collect();
    quantities.extend(faces(studied));
    // What cannot be drawn is not saved either.
    let saved = studied.found.worst.iter().filter(|worst| studied.varied.text(&worst.point).is_ok());
    let worst: Vec<YieldWorst> = saved.map(|worst| case(studied, worst, folder)).collect();
    show(&YieldFigure {
        title: studied.scene.name(),
        motion: S::MOTION,
        wanted: &studied.wanted(),
        limited: studied.limits.is_some(),
        plate: &studied.plate_label(),
        plates: &plates,
        found: &studied.found,
        deciders: ranked.as_deref().map_err(|why| *why),
        laws: &studied.laws,
        drawn: studied.middle,
        law: studied.scene.law(),
        quantities: &quantities,
        worst: &worst,
        notes: &notes(studied),
        live,
        source: studied.scene.source(),
        made_by: MADE_BY,
    })
}

fn quantity(quantity: &NamedQuantity) -> YieldQuantity {
    let show = |value: f64| quantity.kind.dimension.show_digits(value, DIGITS);
    let tolerance = match quantity.tolerance {
        Some(Tolerance::Limits { half_width }) => format!("± {}", show(half_width)),
        Some(Tolerance::Sigma { sigma }) => format!("σ = {}", show(sigma)),
        Some(Tolerance::Uniform { low, high }) => format!("{} to {}, all alike", show(low), show(high)),
        None => String::new(),
    };
    YieldQuantity { path: labelled(&quantity.path).into_owned(), middle: show(quantity.value), tolerance }
}

/// The faces on which parts start, where they are several.
fn faces(studied: &YieldStudy<'_, impl Drawn>) -> Option<YieldQuantity> {
    let faces = studied.varied.faces();
    let share = |(face, share): &(usize, f64)| format!("{face} in {:.1} %", 100.0 * share);
    (faces.len() > 1).then(|| YieldQuantity {
        path: labelled("start.face").into_owned(),
        middle: format!("face {}", studied.scene.feeder().start_face()),
        tolerance: format!("mixed: {}", faces.iter().map(share).collect::<Vec<_>>().join(", ")),
    })
}

fn case(studied: &YieldStudy<'_, impl Drawn>, worst: &Worst, folder: &Path) -> YieldWorst {
    let values = studied.varied.values(&worst.point);
    let shown = studied.varied.quantities().zip(&values);
    YieldWorst {
        ending: study::ending(worst.ending),
        why: studied.why(worst),
        impact_speed: worst.impact_speed,
        command: format!("carom run {}", quoted(&folder.join(file_of(worst)).display().to_string())),
        values: shown
            .map(|(q, value)| q.kind.dimension.show_digits(*value, DIGITS))
            .chain((studied.varied.faces().len() > 1).then(|| studied.varied.face(&worst.point).to_string()))
            .collect(),
    }
}

/// How it was sampled, and what that means.
fn notes<S: Drawn>(studied: &YieldStudy<'_, S>) -> Vec<String> {
    let plan = &studied.plan;
    let points = match plan.points {
        Points::Sobol => {
            format!("Sobol’s points with Owen’s scrambling, in {REPETITIONS} scrambles of their own")
        }
        Points::Random => format!("independent random points, in {REPETITIONS} lots"),
    };
    let mut notes = vec![
        format!("{} drops: {points}; seed {}.", studied.found.drops, plan.seed),
        "Limits ± are three standard deviations of a normal distribution that is cut there.".to_owned(),
        "The 95 % interval is Student’s, from the spread of the scrambles; where few drops end so, no narrower than Wilson’s.".to_owned(),
    ];
    let indices = studied.drops as u64 - studied.found.drops;
    if indices > 0 {
        notes.push(format!("Which tolerance decides comes from {indices} more drops."));
    }
    notes.push(
        format!("The model: {}, rigid part and plates, dry friction after Coulomb, one part at a time; no air, dust or oil.", S::MOTION),
    );
    notes
}
