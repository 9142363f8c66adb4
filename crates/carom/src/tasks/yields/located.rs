//! How surely a drop ends as wanted, by where drops stop to end so: the study of `carom yield --locate`.

use super::{RunOf, met, middle, wanted};
use carom_scene::{Drawn, LocatedReport, LocatedShareReport, Scene, StudyRunReport, Varied, labelled};
use carom_study::yields::{Located, Plan, YieldError, locate};
use carom_study::{Dropped, Ending};
use carom_words::part::Names;
use carom_words::study::percent;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::{Mutex, PoisonError};

/// Lines along which the boundary is located where nothing else is said.
pub const LINES: u64 = 128;

/// A yield that was located and what it is of.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks::yields::{LINES, LocatedYield, YieldStudy}};
/// use carom::study::yields::Points;
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let varied = scene.varied()?;
/// let plan = YieldStudy::plan(&varied, LINES, 1, Points::Sobol, 1);
/// let found = LocatedYield::of(&varied, plan, || {}).unwrap();
/// assert!(found.wanted.wanted.share > 0.99 && found.drops < 2000);
/// assert!(found.text(0.1).contains("end as wanted"));
/// # Ok::<(), carom::Error>(())
/// ```
pub struct LocatedYield<'s, S: Drawn = Scene> {
    /// With its tolerances.
    pub varied: &'s Varied<'s, S>,
    /// How it was sought: `samples` are the lines of a repetition.
    pub plan: Plan,
    /// What is wanted of the plate where the scene says nothing: as the drop of the middle of all tolerances ends.
    pub middle: Ending,
    /// How surely a drop ends as wanted.
    pub wanted: Located,
    /// How surely it keeps the limits of `[design]` as well; `None` where there are none.
    pub kept: Option<Located>,
    /// Drops in all.
    pub drops: usize,
}

impl<'s, S: Drawn> LocatedYield<'s, S> {
    /// Locates as planned; `step` is called after each drop.
    ///
    /// # Errors
    /// A plan that cannot be followed.
    pub fn of(varied: &'s Varied<'s, S>, plan: Plan, step: impl Fn() + Sync) -> Result<Self, YieldError> {
        let scene = varied.scene();
        let middle = middle(scene, &plan);
        let limits = scene.limits();
        // Both shares ask at the same places, as long as the same quantity decides.
        let known: Mutex<BTreeMap<Vec<u64>, [bool; 2]>> = Mutex::default();
        // Only a thread that panics poisons a lock, and its panic goes on.
        let open = || known.lock().unwrap_or_else(PoisonError::into_inner);
        let ends = |point: &[f64]| {
            let place: Vec<u64> = point.iter().map(|u| u.to_bits()).collect();
            if let Some(ends) = open().get(&place) {
                return *ends;
            }
            let dropped = Dropped::through(varied.feeder(point).as_ref(), plan.plate);
            step();
            let run = dropped.run.filter(|run| met(scene, plan.plate, middle, run));
            let keeps = |run: &RunOf<S>| limits.is_none_or(|limits| limits.keeps(run));
            let ends = [run.is_some(), run.as_ref().is_some_and(keeps)];
            if limits.is_some() {
                open().insert(place, ends);
            }
            ends
        };
        let wanted = locate(&plan, |point| ends(point)[0])?;
        let kept = limits.map(|_| locate(&plan, |point| ends(point)[1])).transpose()?;
        let drops = if limits.is_some() { open().len() } else { wanted.drops as usize };
        Ok(Self { varied, plan, middle, wanted, kept, drops })
    }

    /// What it says to a person.
    pub fn text(&self, seconds: f64) -> String {
        let scene = self.varied.scene();
        let [share, interval] = percent(&self.wanted.wanted);
        let wanted = wanted(scene, self.plan.plate, self.middle);
        let mut text = format!("{}: {share} % end as wanted ({interval}): {wanted}\n", scene.name());
        if let Some(kept) = &self.kept {
            let [share, interval] = percent(&kept.wanted);
            text += &format!("{share} % end as wanted within the limits of [design] ({interval})\n");
        }
        text.push('\n');
        let how = self.how(&self.wanted);
        // Both are often located alike: that is said once.
        let other = self.kept.as_ref().map(|kept| self.how(kept)).filter(|other| *other != how);
        text += &how;
        text += &other.unwrap_or_default();
        let _ = writeln!(text, "{} drops, seed {}, {seconds:.2} s\n", self.drops, self.plan.seed);
        text
    }

    /// What it says to a program; `run` says what it took.
    pub fn summary(&self, run: StudyRunReport) -> LocatedReport {
        let scene = self.varied.scene();
        let share = |found: &Located| LocatedShareReport {
            share: found.wanted.share,
            low: found.wanted.low,
            high: found.wanted.high,
            lines: found.wanted.count,
            unseen_share: found.unseen,
            along: self.path(found),
        };
        LocatedReport {
            scene: scene.name().to_owned(),
            approximations: scene.approximations().to_vec(),
            notes: scene.notes().to_vec(),
            plate: scene.feeder().given(self.plan.plate).to_owned(),
            wanted: wanted(scene, self.plan.plate, self.middle),
            located: share(&self.wanted),
            yield_within_limits: self.kept.as_ref().map(share),
            seed: self.plan.seed,
            run,
        }
    }

    /// How a share was located, and what is not in its interval.
    fn how(&self, found: &Located) -> String {
        let (lines, changed) = (found.wanted.count, found.changed);
        let along = self.path(found);
        format!(
            "{changed} of {lines} lines of {} change their ending, and the places were located. Each line was checked with one more drop: at most {:.1} % of all drops may end otherwise than their line says. The interval does not contain this.\n",
            labelled(&along),
            100.0 * found.unseen
        )
    }

    /// The quantity along which a boundary was located.
    fn path(&self, found: &Located) -> String {
        self.varied.paths().swap_remove(found.along)
    }
}
