//! Counting drops.

use super::estimate::{Estimate, REPETITIONS, Spread};
use super::recirculation::{Pass, Passes, Recirculation};
use super::{Plan, Yield};
use crate::device::Landed;
use crate::ending::{Dropped, Ending};
use crate::packed::packed;
use carom_feeder::{Landing, Verdict};
use std::collections::BTreeMap;

/// With what probability a part that lies on one face comes to lie on another on the next plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transition {
    /// Number of the plate.
    pub plate: usize,
    /// The face on the plate before, by its number: of the first plate that on which it starts. [`Ending::Stays`] of a disc.
    pub from: Ending,
    /// The face on this plate, by its number; else how the run ends.
    pub to: Ending,
    /// The share of the drops that come from that face.
    pub share: Estimate,
}

/// How a part lies, by the number of its face.
fn on_face(face: Option<usize>) -> Ending {
    face.map_or(Ending::Stays, |face| Ending::Lies(Verdict::Face(face)))
}

/// Speeds and times on one plate, over the drops that come to lie on it.
///
/// # Example
/// A disc strikes the tray with 7 m/s; it has no flat side.
/// ```
/// use carom_feeder::examples;
/// use carom_study::yields::{Plan, PlateSpread, Points, sample};
/// let feeder = examples::disc_above_a_tray();
/// let plan = Plan { dimensions: 1, samples: 2, seed: 1, points: Points::Sobol, plates: 2, plate: 1 };
/// let found = sample(&plan, |_| Some(feeder.clone()), |_| true, |_| 0.0)?;
/// let PlateSpread { impact_speed, flat, .. } = &found.plates[1];
/// assert!((impact_speed.as_ref().unwrap().mean - 7.0).abs() < 1e-12);
/// assert!(flat.is_none());
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PlateSpread {
    /// Speed of the striking point at its first strike [m/s].
    pub impact_speed: Option<Spread>,
    /// Largest slip velocity on the plate [m/s].
    pub sliding_speed: Option<Spread>,
    /// When it first lies flat [s].
    pub flat: Option<Spread>,
}

/// A drop that somebody should look at.
///
/// # Example
/// Of 32 drops that are not held the one nearest to the middle has a friction of a little less than 3/4.
/// ```
/// use carom_feeder::{Outcome, Run, examples};
/// use carom_study::Ending;
/// use carom_study::yields::{Plan, Points, Worst, sample};
/// let slope = examples::rod_on_a_slope;
/// let plan = Plan { dimensions: 1, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let varied = |u: &[f64]| Some(slope(0.5 + 0.5 * u[0]));
/// let held = |run: &Run| run.outcome == Outcome::Stuck;
/// let found = sample(&plan, varied, held, |u| (u[0] - 0.5).abs())?;
/// let Worst { ending, point, among, .. } = found.worst.iter().find(|worst| !worst.hardest).unwrap();
/// assert_eq!((*ending, *among), (Ending::Otherwise(Outcome::Delivered), 32));
/// assert!(0.375 < point[0] && point[0] < 0.5);
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// How it ends.
    pub ending: Ending,
    /// Where in the unit cube it is.
    pub point: Vec<f64>,
    /// The largest speed of a first strike on the plates that it comes to lie on [m/s]; `None` where it comes to lie on none but that which it
    /// starts on.
    pub impact_speed: Option<f64>,
    /// How many drops it is chosen from: those of its ending that do not end as wanted; for the hardest strike all.
    pub among: u64,
    /// True for the hardest strike of all drops; false for the drop of its ending that is nearest to the middle.
    pub hardest: bool,
}

/// What is noted of one plate.
#[derive(Clone, Debug, Default)]
struct Noted {
    impact_speed: Vec<f64>,
    sliding_speed: Vec<f64>,
    flat: Vec<f64>,
}

packed!(Noted { impact_speed, sliding_speed, flat });
packed!(Near { distance, point, impact_speed, among });
packed!(Tally { wanted, kept, endings, transitions, passes, plates, time, near, hardest, drops });

impl Noted {
    fn take(&mut self, mut other: Self) {
        self.impact_speed.append(&mut other.impact_speed);
        self.sliding_speed.append(&mut other.sliding_speed);
        self.flat.append(&mut other.flat);
    }
}

/// The drop of an ending that is nearest to the middle.
#[derive(Clone, Debug)]
struct Near {
    /// From the middle of all that varies: the smaller, the more probable.
    distance: f64,
    point: Vec<f64>,
    impact_speed: Option<f64>,
    /// How many drops it is chosen from.
    among: u64,
}

impl Near {
    /// Takes the nearer of both; of two that are as near, this.
    fn meet(&mut self, other: Self) {
        let among = self.among + other.among;
        if other.distance < self.distance {
            *self = other;
        }
        self.among = among;
    }
}

fn add(own: &mut [u64; REPETITIONS], more: &[u64; REPETITIONS]) {
    own.iter_mut().zip(more).for_each(|(own, more)| *own += more);
}

fn merge<K: Ord>(own: &mut BTreeMap<K, [u64; REPETITIONS]>, other: BTreeMap<K, [u64; REPETITIONS]>) {
    other.into_iter().for_each(|(key, counts)| add(own.entry(key).or_insert([0; REPETITIONS]), &counts));
}

/// Counts of some drops.
#[derive(Clone, Debug)]
pub(super) struct Tally {
    wanted: [u64; REPETITIONS],
    kept: [u64; REPETITIONS],
    endings: BTreeMap<Ending, [u64; REPETITIONS]>,
    /// From plate to plate, by the numbers of faces.
    transitions: BTreeMap<(usize, Ending, Ending), [u64; REPETITIONS]>,
    passes: Passes,
    plates: Vec<Noted>,
    time: Vec<f64>,
    near: BTreeMap<Ending, Near>,
    hardest: Option<(Ending, Near)>,
    drops: u64,
}

impl Tally {
    pub(super) fn new(plan: &Plan) -> Self {
        Self {
            wanted: [0; REPETITIONS],
            kept: [0; REPETITIONS],
            endings: BTreeMap::new(),
            transitions: BTreeMap::new(),
            passes: Passes::new(),
            plates: vec![Noted::default(); plan.plates],
            time: vec![],
            near: BTreeMap::new(),
            hardest: None,
            drops: 0,
        }
    }

    /// Counts one drop.
    pub(super) fn add(
        &mut self,
        repetition: usize,
        (point, distance): (&[f64], f64),
        dropped: &Dropped<impl Landed>,
        good: bool,
    ) {
        self.drops += 1;
        self.wanted[repetition] += u64::from(good);
        self.endings.entry(dropped.ending).or_insert([0; REPETITIONS])[repetition] += 1;
        let mut hardest: Option<f64> = None;
        if let Some(run) = &dropped.run {
            for landing in run.landings() {
                let noted = &mut self.plates[landing.plate];
                noted.impact_speed.push(landing.impact_speed);
                noted.sliding_speed.push(landing.max_sliding_speed);
                noted.flat.extend(landing.flat);
                hardest = Some(hardest.map_or(landing.impact_speed, |known| known.max(landing.impact_speed)));
            }
            if good {
                self.time.push(run.end_time());
            }
        }
        self.look_closer((point, distance), dropped.ending, hardest, good);
    }

    /// Counts on which faces a drop that started on `start` lies, and whether it ends as wanted on the plate that is looked at.
    pub(super) fn add_faces(
        &mut self,
        repetition: usize,
        start: Option<usize>,
        dropped: &Dropped<impl Landed>,
        (looked_at, good): (usize, bool),
    ) {
        let (Some(run), Some(start)) = (&dropped.run, start) else { return };
        let landing = |plate: usize| run.landings().iter().find(|landing| landing.plate == plate);
        let has_faces = run.landings().iter().all(|landing| landing.face.is_some());
        let mut from = on_face(has_faces.then_some(start));
        for plate in 1..self.plates.len() {
            let lies = |landing: &Landing| on_face(landing.face);
            let to = landing(plate).map_or(Ending::Otherwise(run.outcome()), lies);
            self.transitions.entry((plate, from, to)).or_insert([0; REPETITIONS])[repetition] += 1;
            if !to.arrives() {
                break;
            }
            from = to;
        }
        if has_faces {
            let back = landing(looked_at).and_then(|landing| landing.face).map_or(Pass::Lost, Pass::Back);
            let pass = if good { Pass::Leaves } else { back };
            self.passes.entry((start, pass)).or_insert([0; REPETITIONS])[repetition] += 1;
        }
    }

    /// The shares of each face's drops.
    fn summed_transitions(&self) -> Vec<Transition> {
        let mut whole: BTreeMap<(usize, Ending), [u64; REPETITIONS]> = BTreeMap::new();
        for ((plate, from, _), counts) in &self.transitions {
            add(whole.entry((*plate, *from)).or_insert([0; REPETITIONS]), counts);
        }
        let share = |((plate, from, to), counts): (&(usize, Ending, Ending), &[u64; REPETITIONS])| {
            let share = Estimate::among(counts, &whole[&(*plate, *from)]);
            Transition { plate: *plate, from: *from, to: *to, share }
        };
        self.transitions.iter().map(share).collect()
    }

    /// Counts whether it keeps what must be kept as well.
    pub(super) fn keep(&mut self, repetition: usize, kept: bool) {
        self.kept[repetition] += u64::from(kept);
    }

    fn look_closer(
        &mut self,
        (point, distance): (&[f64], f64),
        ending: Ending,
        impact_speed: Option<f64>,
        good: bool,
    ) {
        let near = || Near { distance, point: point.to_vec(), impact_speed, among: 1 };
        if !good {
            match self.near.get_mut(&ending) {
                Some(known) if known.distance <= distance => known.among += 1,
                Some(known) => known.meet(near()),
                None => drop(self.near.insert(ending, near())),
            }
        }
        let harder = self.hardest.as_ref().is_none_or(|(_, known)| impact_speed > known.impact_speed);
        if harder && impact_speed.is_some_and(|speed| speed > 0.0) {
            self.hardest = Some((ending, near()));
        }
    }

    /// Adds the drops of another, which come after these.
    pub(super) fn take(&mut self, other: Self) {
        self.drops += other.drops;
        for (own, more) in [(&mut self.wanted, other.wanted), (&mut self.kept, other.kept)] {
            add(own, &more);
        }
        merge(&mut self.endings, other.endings);
        merge(&mut self.transitions, other.transitions);
        merge(&mut self.passes, other.passes);
        self.plates.iter_mut().zip(other.plates).for_each(|(own, more)| own.take(more));
        self.time.extend(other.time);
        for (ending, near) in other.near {
            match self.near.get_mut(&ending) {
                Some(known) => known.meet(near),
                None => drop(self.near.insert(ending, near)),
            }
        }
        if let Some((ending, near)) = other.hardest
            && self.hardest.as_ref().is_none_or(|(_, known)| near.impact_speed > known.impact_speed)
        {
            self.hardest = Some((ending, near));
        }
    }

    /// True of the counts of a feeder with so many plates.
    pub(super) fn fits(&self, plates: usize) -> bool {
        self.plates.len() == plates
    }

    /// What the counts say.
    pub(super) fn summed_up(self, samples: u64) -> Yield {
        let estimate = |counts: &[u64; REPETITIONS]| Estimate::of(counts, samples);
        let mut endings: Vec<(Ending, Estimate)> =
            self.endings.iter().map(|(ending, counts)| (*ending, estimate(counts))).collect();
        endings.sort_by_key(|(ending, estimate)| (u64::MAX - estimate.count, *ending));
        let (transitions, recirculation) = (self.summed_transitions(), Recirculation::of(&self.passes));
        let spread = |noted: Noted| PlateSpread {
            impact_speed: Spread::of(noted.impact_speed),
            sliding_speed: Spread::of(noted.sliding_speed),
            flat: Spread::of(noted.flat),
        };
        let worst = |(ending, near, hardest): (Ending, Near, bool)| Worst {
            ending,
            point: near.point,
            impact_speed: near.impact_speed,
            // The hardest drop is one of all; the nearest is one of those with its ending.
            among: if hardest { self.drops } else { near.among },
            hardest,
        };
        let nearest = self.near.into_iter().map(|(ending, near)| (ending, near, false));
        let hardest = self.hardest.map(|(ending, near)| (ending, near, true));
        Yield {
            wanted: estimate(&self.wanted),
            kept: estimate(&self.kept),
            endings,
            transitions,
            recirculation,
            plates: self.plates.into_iter().map(spread).collect(),
            time: Spread::of(self.time),
            worst: nearest.chain(hardest).map(worst).collect(),
            drops: self.drops,
        }
    }
}
