//! The walk of several contacts through compression and restitution.

use super::accumulation::History;
use super::clock::Clock;
use super::share::Share;
use super::stage::{Step, change};
use super::staged::{Stage, StagedOutcome, Station};
use crate::Load;
use crate::planar::contacts::names::ContactState;
use crate::planar::contacts::names::Slip;
use crate::planar::contacts::names::StageEnd;
use crate::planar::contacts::set::ContactSet;
use crate::planar::rates::answer::Solution;
use crate::planar::rates::equations::Equations;
use crate::planar::rates::rate::RateProblem;
use crate::tolerance::{ACCOUNTED, AT_REST, BALANCE, DROWNED, LOST, WORK_GAINED};
use crate::{ImpactError, Law, Phase};

/// Stages after which a walk is given up, per contact. Nearly all need fewer than ten; a series that is passed over starts as soon as its
/// rounds are alike, and two slopes that are close to each other take thousands of stages to get there.
const STAGES_PER_CONTACT: usize = 1 << 14;
/// Stages after which a long walk is asked whether its numbers still tell anything.
const LOOK_AFTER: usize = 64;

/// Where a walk stands.
#[derive(Clone)]
pub(in crate::planar) struct Walk<'a, const N: usize, const M: usize> {
    pub(in crate::planar) set: &'a ContactSet<N, M>,
    pub(in crate::planar) now: Station<N>,
    /// Impulses since the last mark of the history: their digits are not lost in the sum of all.
    pub(in crate::planar) step: [[f64; 2]; N],
    /// Work of the tangential and of the normal impulse of each contact.
    pub(in crate::planar) work: [[f64; 2]; N],
    /// Magnitudes of the works of all stages: what rounding in their sum is measured against.
    pub(in crate::planar) work_terms: f64,
    /// Slip states of the stage before.
    pub(in crate::planar) present: Option<[Slip; N]>,
    /// How much restitution is left.
    pub(super) clock: Clock,
    pub(super) history: History<N>,
    pub(in crate::planar) stages: usize,
    pub(super) branches: usize,
    /// Which member stands for impulses that are open, and at which contacts restitution depends on that.
    pub(in crate::planar) share: Share,
    pub(in crate::planar) open: [bool; N],
    without_approach: bool,
    margin: f64,
    /// Largest velocity before.
    pub(super) fastest: f64,
    /// Magnitudes of all that was added to velocities since: what their rounding is measured against.
    pub(in crate::planar) added: f64,
    /// Largest entry of the operator.
    pub(super) largest_response: f64,
}

impl<'a, const N: usize, const M: usize> Walk<'a, N, M> {
    pub(in crate::planar) fn new(set: &'a ContactSet<N, M>) -> Self {
        let velocity = std::array::from_fn(|i| [set.slip[i], set.normal[i]]);
        let all = set.slip[..set.count].iter().chain(&set.normal[..set.count]);
        Self {
            fastest: all.fold(0.0, |m: f64, u| m.max(u.abs())),
            added: 0.0,
            largest_response: set.largest_entry(),
            set,
            now: Station { velocity, impulse: [[0.0; 2]; N] },
            step: [[0.0; 2]; N],
            work: [[0.0; 2]; N],
            work_terms: 0.0,
            present: None,
            clock: Clock::default(),
            history: History::default(),
            stages: 0,
            branches: 1,
            share: Share::Middle,
            open: [false; N],
            without_approach: false,
            margin: f64::INFINITY,
        }
    }

    pub(in crate::planar) fn normal(&self, i: usize) -> f64 {
        self.now.velocity[i][1]
    }

    pub(in crate::planar) fn contacts(&self) -> std::ops::Range<usize> {
        0..self.set.count
    }

    pub(in crate::planar) fn ask(&self, drive: [[f64; 2]; N], load: [Load; N]) -> RateProblem<'a, N, M> {
        RateProblem {
            count: self.set.count,
            operator: &self.set.operator,
            friction: &self.set.friction,
            drive,
            slip: std::array::from_fn(|i| self.now.velocity[i][0]),
            load,
        }
    }

    fn solution(&mut self, phase: Phase, drive: [[f64; 2]; N], load: [Load; N]) -> Option<Solution<N>> {
        let problem = self.ask(drive, load);
        let answer = problem.solve();
        let mut chosen = answer.preferred(self.present.as_ref()).copied()?;
        self.branches = self.branches.max(answer.count);
        self.margin = self.margin.min(chosen.margin);
        if chosen.indeterminate {
            self.note_share(phase, &problem, &mut chosen);
        }
        Some(chosen)
    }

    /// Restitution multiplies the impulses of compression, and Stronge's measures the work at the striking contact: where these are one
    /// choice of many, says so and takes the one that is asked for.
    fn note_share(&mut self, phase: Phase, problem: &RateProblem<'_, N, M>, chosen: &mut Solution<N>) {
        let counts = |i: usize| match phase {
            Phase::Compression => self.set.restitution[i] > 0.0,
            Phase::Restitution => self.clock.measures_work_at(i),
        };
        let counted: [bool; N] = std::array::from_fn(|i| i < self.set.count && counts(i));
        if !counted.contains(&true) {
            return;
        }
        let equations = Equations::of(problem);
        for i in (0..N).filter(|&i| counted[i]) {
            let Some([least, most]) = equations.ends_of(&chosen.guess, i) else { continue };
            self.open[i] = true;
            match self.share {
                Share::Least(j) if i == j => chosen.rates = least,
                Share::Most(j) if i == j => chosen.rates = most,
                _ => {}
            }
        }
    }

    /// Walks until no contact approaches.
    pub(in crate::planar) fn compress(
        &mut self,
        observe: &mut impl FnMut(&Stage<N>),
    ) -> Result<(), ImpactError> {
        // Contacts that only touch may be driven in by friction: then the paradox's contact starts the walk.
        if self.contacts().all(|i| self.normal(i) >= 0.0) {
            if self.driven_in().is_none() {
                return Ok(());
            }
            self.without_approach = true;
            self.force(Phase::Compression, observe)?;
        }
        while self.contacts().any(|i| self.approaches(i)) {
            self.spend()?;
            let drive = std::array::from_fn(|i| [0.0, self.normal(i).min(0.0)]);
            let load = std::array::from_fn(|i| {
                if i < self.set.count && self.normal(i) <= 0.0 { Load::Touching(0.0) } else { Load::Absent }
            });
            let Some(chosen) = self.solution(Phase::Compression, drive, load) else {
                self.force(Phase::Compression, observe)?;
                continue;
            };
            // The response includes the drive: what the impulse alone changes is the rest.
            let change = change(&chosen, &drive);
            let end = Step { length: 1.0, why: StageEnd::CompressionEnds };
            let step = self.next_event(&chosen, &change, end);
            let stage = self.advance(Phase::Compression, &chosen, &change, &step);
            self.finish(&stage, observe)?;
        }
        for i in 0..self.set.count {
            self.now.velocity[i][1] = self.now.velocity[i][1].max(0.0);
        }
        Ok(())
    }

    /// An approach that is not only the rounding of what was added to it.
    pub(in crate::planar) fn approaches(&self, i: usize) -> bool {
        self.normal(i) < -AT_REST * self.added
    }

    /// Walks until the law's measure of restitution, times `factor`, is used up.
    pub(in crate::planar) fn restitute(
        &mut self,
        law: Law,
        factor: f64,
        observe: &mut impl FnMut(&Stage<N>),
    ) -> Result<(), ImpactError> {
        let debt: [f64; N] = std::array::from_fn(|i| {
            let owes = i < self.set.count && self.normal(i) <= 0.0;
            if owes { factor * self.set.restitution[i] * self.now.impulse[i][1] } else { 0.0 }
        });
        let striking = self.contacts().find(|&i| self.set.normal[i] < 0.0).unwrap_or(0);
        if debt.iter().all(|d| *d <= 0.0) || (law != Law::Poisson && debt[striking] <= 0.0) {
            return Ok(());
        }
        let e = factor * self.set.restitution[striking];
        self.clock = Clock::new(law, striking, e, self.work[striking][1], self.set.normal[striking]);
        loop {
            self.spend()?;
            let load = std::array::from_fn(|i| match (i < self.set.count, self.normal(i) <= 0.0) {
                (true, true) => Load::Touching(debt[i]),
                (true, false) if debt[i] > 0.0 => Load::Prescribed(debt[i]),
                _ => Load::Absent,
            });
            let drive = [[0.0; 2]; N];
            let Some(chosen) = self.solution(Phase::Restitution, drive, load) else {
                // A slip that reversed into the paradox: stop it first, then let nothing approach.
                if !self.force(Phase::Restitution, observe)? {
                    return Ok(());
                }
                self.compress(observe)?;
                continue;
            };
            let change = self.kept_out(change(&chosen, &drive), &chosen, None);
            let rise = self.beyond_rounding(change[striking][1], &chosen);
            let left = self.clock.left(self.normal(striking), rise, chosen.rates[striking][1]);
            let end = Step { length: left, why: StageEnd::RestitutionEnds };
            let step = self.next_event(&chosen, &change, end);
            if !step.length.is_finite() {
                // Wedged: whatever it is pressed with, the striking contact does not rise, and nothing is returned.
                return Ok(());
            }
            let stage = self.advance(Phase::Restitution, &chosen, &change, &step);
            self.clock.spend(step.length);
            self.finish(&stage, observe)?;
            if step.why == StageEnd::RestitutionEnds {
                return Ok(());
            }
        }
    }

    /// How fast a velocity changes, or 0 where that is rounding of what the impulses of a wedge do to it.
    fn beyond_rounding(&self, change: f64, chosen: &Solution<N>) -> f64 {
        let rates: f64 = chosen.rates.iter().flatten().map(|rate| rate.abs()).sum();
        if change.abs() <= AT_REST * self.largest_response * rates { 0.0 } else { change }
    }

    /// Shows a stage; where it ends a round of a series, goes to its limit.
    pub(super) fn finish(
        &mut self,
        stage: &Stage<N>,
        observe: &mut impl FnMut(&Stage<N>),
    ) -> Result<(), ImpactError> {
        observe(stage);
        if let Some(rest) = self.accumulate(stage)? {
            observe(&rest);
        }
        Ok(())
    }

    pub(super) fn spend(&mut self) -> Result<(), ImpactError> {
        self.stages += 1;
        let most = STAGES_PER_CONTACT * self.set.count;
        if self.stages.is_multiple_of(LOOK_AFTER) && self.is_drowned() {
            return Err(ImpactError::Jammed);
        }
        if self.stages > most { Err(ImpactError::Unending { stages: most }) } else { Ok(()) }
    }

    fn total_work(&self) -> f64 {
        self.work[..self.set.count].iter().flatten().sum()
    }

    pub(in crate::planar) fn gained_energy(&self) -> bool {
        self.total_work() > WORK_GAINED * self.work_terms
    }

    pub(in crate::planar) fn outcome(
        &self,
        law: Law,
        restitution_scaled: f64,
    ) -> Result<StagedOutcome<N>, ImpactError> {
        let all = self.now.velocity.iter().chain(&self.now.impulse).flatten();
        if !(all.sum::<f64>() + self.work_terms).is_finite() {
            return Err(ImpactError::Overflow);
        }
        // However little is returned: contacts wedge the body so hard that rounding of their impulses is as large as its motion.
        let wedged = self.is_drowned() || self.is_open() || !self.is_accounted();
        if wedged || law != Law::Newton && self.gained_energy() {
            return Err(ImpactError::Jammed);
        }
        Ok(StagedOutcome {
            impulse: self.now.impulse,
            velocity: self.now.velocity,
            work: self.work,
            state: self.now.velocity.map(ContactState::of),
            law,
            branches: self.branches,
            open_share: self.open,
            gained_energy: self.gained_energy(),
            restitution_scaled,
            without_approach: self.without_approach,
            margin: self.margin,
        })
    }

    /// What the impulses make of a velocity, and the size of its terms.
    fn balance(&self, i: usize, axis: usize) -> (f64, f64) {
        let before = [self.set.slip[i], self.set.normal[i]][axis];
        let terms = self.set.operator[i]
            .iter()
            .zip(&self.now.impulse)
            .take(self.set.count)
            .flat_map(|(b, [q, p])| [[b.tt * q, b.tn * p], [b.nt * q, b.nn * p]][axis]);
        terms.fold((before, self.fastest), |(sum, size), term| (sum + term, size + term.abs()))
    }

    /// Whether the impulses do not make the velocities that are noted.
    fn is_open(&self) -> bool {
        let open = |i: usize, axis: usize| {
            let (sum, size) = self.balance(i, axis);
            (sum - self.now.velocity[i][axis]).abs() > (BALANCE * size).min(LOST * self.fastest)
        };
        self.contacts().any(|i| open(i, 0) || open(i, 1))
    }

    /// Whether the works are those of the impulses between the velocities before and now.
    fn is_accounted(&self) -> bool {
        let of = |i: usize, axis: usize| {
            let before = [self.set.slip[i], self.set.normal[i]][axis];
            0.5 * (before + self.now.velocity[i][axis]) * self.now.impulse[i][axis]
        };
        let work: f64 = self.contacts().flat_map(|i| [of(i, 0), of(i, 1)]).sum();
        let terms: f64 = self.contacts().flat_map(|i| [of(i, 0).abs(), of(i, 1).abs()]).sum();
        (work - self.total_work()).abs() <= ACCOUNTED * terms.max(self.work_terms)
    }

    /// Whether the impulses have become so large that their rounding hides the motion.
    fn is_drowned(&self) -> bool {
        self.contacts().any(|i| (0..2).any(|axis| DROWNED * self.balance(i, axis).1 > self.fastest))
    }
}
