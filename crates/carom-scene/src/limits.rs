//! How far each quantity of a scene may move alone before its verdict flips.

use crate::drawn::Drawn;
use crate::run_report::{Limit, LimitEnd};
use crate::scene::NamedQuantity;
use crate::unit::Dimension;
use carom_feeder::{Outcome, Verdict};
use carom_study::limits::{Effect, End, limit};
use carom_study::{Device, Landed};
use std::cell::Cell;

/// What must stay: how the run ends, and what lies on each plate.
#[derive(Clone, Debug, PartialEq)]
struct Kept {
    outcome: Outcome,
    plates: Vec<(usize, Option<Verdict>)>,
}

fn kept(feeder: &impl Device) -> Option<Kept> {
    let run = feeder.drop_part().ok()?;
    let plates = run.landings().iter().map(|landing| (landing.plate, landing.verdict)).collect();
    Some(Kept { outcome: run.outcome(), plates })
}

/// What was found, and with how many runs.
///
/// # Example
/// ```
/// assert_eq!(carom_scene::FoundLimits::default().runs, 0);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FoundLimits {
    /// Of each quantity that was moved, in the order of the scene.
    pub limits: Vec<Limit>,
    /// Runs that it took.
    pub runs: u64,
}

impl FoundLimits {
    /// The quantities whose limits are sought: continuous, written in the scene, and no matter of how parts are fed.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{FoundLimits, Scene};
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// assert!(FoundLimits::quantities(&scene).iter().any(|quantity| quantity.path == "contact.friction"));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn quantities(scene: &impl Drawn) -> Vec<NamedQuantity> {
        // The verdict is that of one part alone: how it is fed changes nothing.
        let fed = |quantity: &NamedQuantity| quantity.path.starts_with("feed.");
        let moves = |quantity: &NamedQuantity| {
            quantity.written && quantity.kind.dimension != Dimension::Count && !fed(quantity)
        };
        scene.quantities().into_iter().filter(moves).collect()
    }

    /// The limits of one quantity and the runs that they took; `None` where there is no such quantity or the feeder cannot be run.
    ///
    /// Each run is for the verdict alone. An island of another verdict that is narrower than a step of the search can be missed. Where a
    /// drawing becomes impossible before the verdict flips the search ends there, and says so.
    ///
    /// # Example
    /// The rod of the second published feeder turns over with friction from 0.055 to 0.176.
    /// ```
    /// use carom_scene::{FoundLimits, Scene};
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let (limit, runs) = FoundLimits::one(&scene, "contact.friction").unwrap();
    /// let shown = [limit.low, limit.high].map(|end| end.map(|end| (1e3 * end).round()));
    /// assert!(shown == [Some(55.0), Some(176.0)] && runs > 60, "{shown:?} after {runs}");
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn one(scene: &impl Drawn, path: &str) -> Option<(Limit, u64)> {
        let quantity = scene.quantities().into_iter().find(|quantity| quantity.path == path)?;
        let now = kept(scene.feeder())?;
        let (limit, runs) = limits_of(scene, &quantity, &now);
        Some((limit, 1 + runs))
    }

    /// The limits of every one of [`FoundLimits::quantities`]; `progress` is told of each before its turn, and of the runs so far.
    pub fn of(scene: &impl Drawn, progress: &mut impl FnMut(&str, u64)) -> Self {
        let Some(now) = kept(scene.feeder()) else { return Self { limits: vec![], runs: 1 } };
        let mut found = Self { limits: vec![], runs: 1 };
        for quantity in Self::quantities(scene) {
            progress(&quantity.path, found.runs);
            let (limit, runs) = limits_of(scene, &quantity, &now);
            found.limits.push(limit);
            found.runs += runs;
        }
        found
    }
}

fn limits_of(scene: &impl Drawn, quantity: &NamedQuantity, now: &Kept) -> (Limit, u64) {
    let runs = Cell::new(0);
    let effect = |value: f64| match scene.with(&quantity.path, value) {
        Err(_) => Effect::Impossible,
        Ok(changed) => {
            runs.set(runs.get() + 1);
            match kept(changed.feeder()) {
                None => Effect::Impossible,
                Some(kept) if kept == *now => Effect::Same,
                Some(_) => Effect::Flips,
            }
        }
    };
    let scale = scale(quantity);
    let ends = [-scale, scale].map(|scale| limit(quantity.value, scale, &effect));
    (Limit::new(&quantity.path, ends.map(|(kept, end)| (kept, end.into()))), runs.get())
}

impl From<End> for LimitEnd {
    fn from(end: End) -> Self {
        match end {
            End::Flips => Self::Flips,
            End::Impossible => Self::NoSuchFeeder,
            End::OfSearch => Self::EndOfSearch,
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
