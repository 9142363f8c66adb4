//! How far each quantity may move alone before the verdict flips.

use crate::pipeline;
use crate::printed::tell;
use crate::side_by_side::aligned;
use carom_feeder::{Feeder, Outcome, Verdict};
use carom_scene::{Limit, LimitEnd, NamedQuantity, Scene, labelled, unit::Dimension};
use std::cell::Cell;
use std::time::{Duration, Instant};

/// The first step away from a value, as a share of its scale; each next one is twice as long.
const FIRST_STEP: f64 = 1.0 / 1024.0;
/// Steps before the search ends: 2^17 first steps are 128 scales.
const STEPS: u32 = 18;
/// The share of a value that it is made smaller to at most.
const LEAST: f64 = 1e-3;
/// Bisections of the last step.
const BISECTIONS: u32 = 30;

/// What must stay: how the run ends, and what lies on each plate.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Kept {
    outcome: Outcome,
    plates: Vec<(usize, Option<Verdict>)>,
}

pub(crate) fn kept(feeder: &Feeder) -> Option<Kept> {
    let run = pipeline::verdict(feeder)?;
    let plates = run.landings.iter().map(|landing| (landing.plate, landing.verdict)).collect();
    Some(Kept { outcome: run.outcome, plates })
}

/// What a changed value does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Effect {
    /// The verdict stays.
    Same,
    /// The verdict flips.
    Flips,
    /// There is no such feeder.
    Impossible,
}

/// What was found, and with how many runs.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) limits: Vec<Limit>,
    pub(crate) runs: u64,
}

/// The limits of every continuous quantity that the scene writes down; `progress` is told of each quantity and of the runs so far.
///
/// Each run is for the verdict alone. Found by steps that double, then by bisection: an island of another verdict that is narrower than a
/// step can be missed. Where a drawing becomes impossible before the verdict flips the search ends there, and
/// says so.
pub(crate) fn limits(scene: &Scene, progress: &mut impl FnMut(&str, u64)) -> Found {
    let runs = Cell::new(0);
    let counted = |feeder: &Feeder| {
        runs.set(runs.get() + 1);
        kept(feeder)
    };
    let Some(now) = counted(scene.feeder()) else { return Found { limits: vec![], runs: runs.get() } };
    let effect = |path: &str, value: f64| match scene.with(path, value) {
        Err(_) => Effect::Impossible,
        Ok(changed) => match counted(changed.feeder()) {
            None => Effect::Impossible,
            Some(kept) if kept == now => Effect::Same,
            Some(_) => Effect::Flips,
        },
    };
    // The verdict is that of one part alone: how it is fed changes nothing.
    let fed = |quantity: &NamedQuantity| quantity.path.starts_with("feed.");
    let moves = |quantity: &NamedQuantity| {
        quantity.written && quantity.kind.dimension != Dimension::Count && !fed(quantity)
    };
    let mut limits = vec![];
    for quantity in scene.quantities().into_iter().filter(moves) {
        progress(&quantity.path, runs.get());
        let effect = |value: f64| effect(&quantity.path, value);
        let scale = scale(&quantity);
        let ends = [-scale, scale].map(|scale| limit(quantity.value, scale, &effect));
        limits.push(Limit::new(&quantity.path, ends));
    }
    Found { limits, runs: runs.get() }
}

/// Says on stderr how far a search is, at most once a second and never in its first one.
pub(crate) fn progress(scene: &str) -> impl FnMut(&str, u64) {
    let mut last = Instant::now();
    move |path: &str, runs: u64| {
        if last.elapsed() >= Duration::from_secs(1) {
            last = Instant::now();
            // There is nowhere to report that stderr is closed.
            tell(&format!("limits of {scene}: {path}, {runs} runs so far"));
        }
    }
}

/// The length that steps are measured in: the value itself, or where it is 0 what is usual for its dimension.
fn scale(quantity: &NamedQuantity) -> f64 {
    if quantity.value != 0.0 {
        return quantity.value.abs();
    }
    match quantity.kind.dimension {
        Dimension::Length => 0.1,
        Dimension::Angle => 0.1,
        _ => 1.0,
    }
}

/// The last value with the same verdict, going from `value` in steps of `scale`, and what ended the search there.
pub(crate) fn limit(value: f64, scale: f64, effect: &impl Fn(f64) -> Effect) -> (f64, LimitEnd) {
    let mut inside = value;
    // Towards zero a value shrinks to a thousandth: a part of no mass is no part.
    let least = value * LEAST;
    for step in 0..STEPS {
        let next = value + scale * FIRST_STEP * f64::from(1u32 << step);
        let at_end = value * scale < 0.0 && (next - least) * value < 0.0;
        let outside = if at_end { least } else { next };
        match effect(outside) {
            Effect::Same => inside = outside,
            other => return bisect(inside, (outside, other), effect),
        }
        if at_end {
            break;
        }
    }
    (inside, LimitEnd::EndOfSearch)
}

fn bisect(mut inside: f64, mut outside: (f64, Effect), effect: &impl Fn(f64) -> Effect) -> (f64, LimitEnd) {
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (inside + outside.0);
        match effect(middle) {
            Effect::Same => inside = middle,
            other => outside = (middle, other),
        }
    }
    (inside, if outside.1 == Effect::Flips { LimitEnd::Flips } else { LimitEnd::NoSuchFeeder })
}

/// The limits as a table.
pub(crate) fn text(scene: &Scene, found: &Found) -> String {
    let quantities = scene.quantities();
    let mut rows = vec![["quantity", "now", "from", "to"].map(str::to_owned).to_vec()];
    for limit in &found.limits {
        let Some(quantity) = quantities.iter().find(|quantity| quantity.path == limit.quantity) else {
            continue;
        };
        let show = |value: f64| quantity.kind.dimension.show_digits(value, 5);
        let edge = |kept: f64, end: LimitEnd| match end {
            LimitEnd::Flips => show(kept),
            LimitEnd::NoSuchFeeder => format!("({})", show(kept)),
            LimitEnd::EndOfSearch => "-".to_owned(),
        };
        rows.push(vec![
            labelled(&limit.quantity).into_owned(),
            show(quantity.value),
            edge(limit.low_kept, limit.low_end),
            edge(limit.high_kept, limit.high_end),
        ]);
    }
    let runs = found.runs;
    format!(
        "the verdict stays while one quantity moves alone ({runs} runs)\n(in parentheses: no flip, but beyond it there is no such feeder; -: no flip down to a thousandth of it, or up to 128 times it)\n\n{}",
        aligned(&rows)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_edge_of_a_verdict_is_found() {
        let effect = |x: f64| if (0.055..0.176).contains(&x) { Effect::Same } else { Effect::Flips };
        let [(low, _), (high, end)] = [-0.15, 0.15].map(|scale| limit(0.15, scale, &effect));
        assert_eq!(end, LimitEnd::Flips);
        assert!((low - 0.055).abs() < 1e-9 && effect(low) == Effect::Same, "{low}");
        assert!((high - 0.176).abs() < 1e-9 && effect(high) == Effect::Same, "{high}");
    }

    #[test]
    fn a_verdict_that_never_changes_has_no_limit() {
        assert_eq!(limit(1.0, 1.0, &|_| Effect::Same).1, LimitEnd::EndOfSearch);
        let until_zero = |x: f64| if x > 0.0 { Effect::Same } else { Effect::Impossible };
        assert_eq!(limit(1.0, -1.0, &until_zero), (LEAST, LimitEnd::EndOfSearch));
        let until_two = |x: f64| if x < 2.0 { Effect::Same } else { Effect::Impossible };
        let (kept, end) = limit(1.0, 1.0, &until_two);
        assert!(
            (2.0 - kept).abs() < 1e-8 && end == LimitEnd::NoSuchFeeder,
            "{kept}: it cannot be drawn beyond"
        );
        let near_zero = |x: f64| if x > 1e-5 { Effect::Same } else { Effect::Flips };
        assert_eq!(limit(1.0, -1.0, &near_zero).1, LimitEnd::EndOfSearch, "not searched below a thousandth");
    }
}
