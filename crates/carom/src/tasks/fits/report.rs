//! What a fit says in words, as JSON and as a scene.

use super::FitStudy;
use super::over::Over;
use crate::tasks::StudyError;
use carom_num::normal::quantile;
use carom_scene::{FitParameterReport, FitReport, FitScatterReport, NotToldReport, StudyRunReport, labelled};
use carom_study::fits::{Pair, Parameter};
use carom_words::{aligned, part};
use std::fmt::Write as _;

/// Digits with which values are shown.
const DIGITS: usize = 4;
/// Times that are off by more than this, in standard deviations, do not agree with the fit: of one time in 20 by chance, of several hardly ever.
const POOR: f64 = 2.0;
/// A value is written to this share of its standard deviation.
const WRITTEN: f64 = 0.01;

/// `friction` of `contact.friction (…)`, as it is told.
fn label(found: &FitStudy<'_>, k: usize) -> String {
    labelled(&found.over[k].path).into_owned()
}

/// What the runs do not tell.
fn not_told(found: &FitStudy<'_>) -> Vec<NotToldReport> {
    let path = |k: usize| found.over[k].path.clone();
    let untold = found.fit.parameters.iter().enumerate().filter(|(_, parameter)| !parameter.told);
    let alone = untold.map(|(k, _)| NotToldReport {
        parameters: vec![path(k)],
        kind: "range",
        correlation: None,
        why: format!(
            "{}: its interval is about as wide as the range, the runs say next to nothing of it",
            label(found, k)
        ),
    });
    let ridges = found.fit.pairs.iter().filter(|pair| !pair.told);
    let ridge = |pair: &Pair| {
        let [a, b] = pair.of.map(|k| label(found, k));
        let way = if pair.correlation < 0.0 {
            "more of one and less of the other"
        } else {
            "more of both, or less of both,"
        };
        NotToldReport {
            parameters: pair.of.map(path).to_vec(),
            kind: "ridge",
            correlation: Some(pair.correlation),
            why: format!(
                "{a} and {b}: {way} agree with the runs as well; another kind of test must tell one of them"
            ),
        }
    };
    alone.chain(ridges.map(ridge)).collect()
}

impl FitStudy<'_> {
    /// What it says to a person; `seconds` is how long it took.
    pub fn text(&self, seconds: f64) -> String {
        let found = self;
        let fit = &found.fit;
        let plate = part::obstacle(found.scene.feeder(), found.plate);
        let drops: u64 = found.runs.observations.iter().map(|seen| seen.count).sum();
        let plural = |count: u64| if count == 1 { "" } else { "s" };
        let rows = found.runs.observations.len() as u64;
        let mut text = format!(
            "{}: fitted to {drops} drop{} in {rows} row{} of {}, as they ended on \"{plate}\"\n\n",
            found.scene.name(),
            plural(drops),
            plural(rows),
            found.runs.file
        );
        let level = format!("{} % interval", 100.0 * found.plan.level);
        let mut table = vec![vec!["quantity".to_owned(), "best".to_owned(), level, "range".to_owned()]];
        for (k, (over, parameter)) in found.over.iter().zip(&fit.parameters).enumerate() {
            let show = |value: f64| over.dimension.show_digits(value, DIGITS);
            let between = |low: f64, high: f64| format!("{} to {}", show(low), show(high));
            let [from, to] = over.range;
            table.push(vec![
                label(found, k),
                show(parameter.best),
                between(parameter.low, parameter.high),
                between(from, to),
            ]);
        }
        if let Some(scatter) = &fit.scatter {
            let show = |value: f64| format!("{:.2} ms", 1000.0 * value);
            let between = format!("{} to {}", show(scatter.low), show(scatter.high));
            table.push(vec!["scatter of times".to_owned(), show(scatter.best), between, String::new()]);
        }
        text += &aligned(&table);
        let untold = not_told(found);
        if !untold.is_empty() {
            text += "\nnot told apart\n";
        }
        for untold in &untold {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "  {}", untold.why);
        }
        text += &caveats(found);
        let _ = writeln!(
            text,
            "\nln of the likelihood {:.2}; {} drops of the engine at {} nodes, seed {}, {:.2} s\n",
            fit.log_likelihood, found.drops, fit.nodes, found.plan.seed, seconds
        );
        text
    }

    /// What it says to a program; `run` says what it took.
    pub fn summary(&self, run: StudyRunReport) -> FitReport {
        let found = self;
        let fit = &found.fit;
        let parameter = |(over, p): (&Over, &Parameter)| FitParameterReport {
            name: over.path.clone(),
            unit: over.dimension.si().to_owned(),
            best: p.best,
            low: p.low,
            high: p.high,
            level: found.plan.level,
            median: p.median,
            mean: p.mean,
            standard_deviation: p.deviation,
            range: over.range,
        };
        let scatter = |p: &Parameter| FitScatterReport { best: p.best, low: p.low, high: p.high };
        FitReport {
            scene: found.scene.name().to_owned(),
            approximations: found.scene.approximations().to_vec(),
            plate: found.scene.feeder().plates[found.plate].name.clone(),
            runs: found.runs.file.clone(),
            observed_drops: found.runs.observations.iter().map(|seen| seen.count).sum(),
            parameters: found.over.iter().zip(&fit.parameters).map(parameter).collect(),
            time_scatter_s: fit.scatter.as_ref().map(scatter),
            likelihood: fit.log_likelihood,
            not_told_apart: not_told(found),
            resolved: fit.resolved,
            few_samples: fit.few_samples,
            misfit: fit.misfit,
            samples: found.plan.rounded(),
            nodes: fit.nodes,
            seed: found.plan.seed,
            run,
        }
    }

    /// The scene with what was fitted: each value is the best, its tolerance a normal distribution whose interval is as wide as the one that was found.
    ///
    /// # Errors
    /// A scene that cannot be written.
    pub fn fitted_scene(&self) -> Result<String, StudyError> {
        let found = self;
        let halves = 2.0 * quantile(0.5 * (1.0 + found.plan.level));
        let deviations: Vec<f64> = found.fit.parameters.iter().map(|p| (p.high - p.low) / halves).collect();
        let best: Vec<f64> =
            found.fit.parameters.iter().zip(&deviations).map(|(p, d)| rounded(p.best, *d)).collect();
        let deviations: Vec<f64> = deviations.iter().map(|d| rounded(*d, *d)).collect();
        let text = found.fitted.text(&best, &deviations)?;
        let mut head = format!("# {}: fitted to {}.\n", found.scene.name(), found.runs.file);
        for (over, p) in found.over.iter().zip(&found.fit.parameters) {
            let [low, high] = [p.low, p.high].map(|end| over.dimension.show_digits(end, DIGITS));
            // Writing to a String cannot fail.
            let _ = writeln!(
                head,
                "# {}; {} % interval {low} to {high}.",
                over.at(p.best),
                100.0 * found.plan.level
            );
        }
        for untold in not_told(found) {
            let _ = writeln!(head, "# Not told apart: {}.", untold.why);
        }
        Ok(head + &text)
    }
}

/// Why intervals may not be what they seem.
fn caveats(found: &FitStudy<'_>) -> String {
    let (fit, mut text) = (&found.fit, String::new());
    if !fit.resolved {
        let _ = writeln!(
            text,
            "\nthe budget of {} nodes ended first: intervals are coarse, take more {}",
            found.plan.nodes,
            found.asker.option("nodes")
        );
    }
    if let Some(misfit) = fit.misfit.filter(|misfit| *misfit > POOR) {
        let _ = writeln!(
            text,
            "\nthe fit is poor: at the best value times are off by {misfit:.1} times their scatter, so the intervals are too narrow; is the scatter right, and does what varies from drop to drop have a tolerance in the scene?"
        );
    }
    if fit.few_samples {
        let _ = writeln!(
            text,
            "\n{} samples are fewer than ten times the drops of one setting: intervals are wider than the drops allow, and may miss where an outcome is rare; take more {}",
            found.plan.rounded(),
            found.asker.option("samples")
        );
    }
    text
}

/// A value to a hundredth of its standard deviation or finer, in decimals.
fn rounded(value: f64, deviation: f64) -> f64 {
    let mut step = 1.0;
    while step > WRITTEN * deviation && deviation > 0.0 {
        step /= 10.0;
    }
    let decimals = format!("{:.0}", value / step).parse::<f64>().unwrap_or(value / step);
    // Once more through text: the nearest double of a short decimal.
    let shown = decimals * step;
    format!("{shown:.11e}").parse().unwrap_or(shown)
}
