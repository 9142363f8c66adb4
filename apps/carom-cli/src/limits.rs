//! How far each quantity may move alone before the verdict flips.

use crate::pipeline;
use crate::side_by_side::aligned;
use carom_feeder::{Feeder, Outcome, Verdict};
use carom_scene::{Limit, NamedQuantity, Scene, unit::Dimension};

/// The first step away from a value, as a share of its scale; each next one is twice as long.
const FIRST_STEP: f64 = 1.0 / 1024.0;
/// Steps before the search ends: 2^17 first steps are 128 scales.
const STEPS: u32 = 18;
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

/// The limits of every continuous quantity that the scene writes down.
///
/// Found by steps that double, then by bisection: an island of another verdict that is narrower than a step can be missed. Where a
/// drawing becomes impossible before the verdict flips there is no limit.
pub(crate) fn limits(scene: &Scene) -> Vec<Limit> {
    let Some(now) = kept(scene.feeder()) else { return vec![] };
    let effect = |path: &str, value: f64| match scene.with(path, value) {
        Err(_) => Effect::Impossible,
        Ok(changed) => match kept(changed.feeder()) {
            None => Effect::Impossible,
            Some(kept) if kept == now => Effect::Same,
            Some(_) => Effect::Flips,
        },
    };
    let moves = |quantity: &NamedQuantity| quantity.written && quantity.kind.dimension != Dimension::Count;
    scene
        .quantities()
        .into_iter()
        .filter(moves)
        .map(|quantity| {
            let effect = |value: f64| effect(&quantity.path, value);
            let scale = scale(&quantity);
            Limit {
                low: limit(quantity.value, -scale, &effect),
                high: limit(quantity.value, scale, &effect),
                quantity: quantity.path.clone(),
            }
        })
        .collect()
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

/// The last value with the same verdict, going from `value` in steps of `scale`; `None` where it never flips.
pub(crate) fn limit(value: f64, scale: f64, effect: &impl Fn(f64) -> Effect) -> Option<f64> {
    let mut inside = value;
    for step in 0..STEPS {
        let outside = value + scale * FIRST_STEP * f64::from(1u32 << step);
        match effect(outside) {
            Effect::Same => inside = outside,
            other => return bisect(inside, (outside, other), effect),
        }
    }
    None
}

fn bisect(mut inside: f64, mut outside: (f64, Effect), effect: &impl Fn(f64) -> Effect) -> Option<f64> {
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (inside + outside.0);
        match effect(middle) {
            Effect::Same => inside = middle,
            other => outside = (middle, other),
        }
    }
    (outside.1 == Effect::Flips).then_some(inside)
}

/// The limits as a table.
pub(crate) fn text(scene: &Scene, limits: &[Limit]) -> String {
    let quantities = scene.quantities();
    let mut rows = vec![["quantity", "now", "from", "to"].map(str::to_owned).to_vec()];
    for limit in limits {
        let Some(quantity) = quantities.iter().find(|quantity| quantity.path == limit.quantity) else {
            continue;
        };
        let show = |value: Option<f64>| {
            value.map_or("-".to_owned(), |value| quantity.kind.dimension.show_digits(value, 5))
        };
        rows.push(vec![
            limit.quantity.clone(),
            show(Some(quantity.value)),
            show(limit.low),
            show(limit.high),
        ]);
    }
    format!("the verdict stays while one quantity moves alone\n\n{}", aligned(&rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_edge_of_a_verdict_is_found() {
        let effect = |x: f64| if (0.055..0.176).contains(&x) { Effect::Same } else { Effect::Flips };
        let low = limit(0.15, -0.15, &effect).unwrap();
        let high = limit(0.15, 0.15, &effect).unwrap();
        assert!((low - 0.055).abs() < 1e-9 && effect(low) == Effect::Same, "{low}");
        assert!((high - 0.176).abs() < 1e-9 && effect(high) == Effect::Same, "{high}");
    }

    #[test]
    fn a_verdict_that_never_changes_has_no_limit() {
        assert_eq!(limit(1.0, 1.0, &|_| Effect::Same), None);
        let until_zero = |x: f64| if x > 0.0 { Effect::Same } else { Effect::Impossible };
        assert_eq!(limit(1.0, -1.0, &until_zero), None);
    }
}
