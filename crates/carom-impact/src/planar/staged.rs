//! Several contacts: the staged impact.
//!
//! *Compression.* The drive is the present normal velocity: over the contacts with `u_n ≤ 0` the rate problem is solved with the drive
//! `(0, u_n)` and walked along to the next event: a slip stops, an open contact closes again, or no contact approaches any more.
//! With one closing contact this is Routh's walk, its touching contacts held by complementarity.
//!
//! *Restitution.* Contact i owes `eᵢ Pᵢ`, Pᵢ its normal impulse of compression; contacts that are open when compression ends owe
//! nothing. A clock loads every debtor at the rate `eᵢ Pᵢ`; contacts with `u_n = 0` may take more. Poisson's clock stops at 1,
//! Stronge's where the striking contact's work is used up, Newton's where its normal velocity is `−e` times that before (the latter two
//! only where one contact closes: for more they are not unique, and Poisson's is used).
//!
//! Where no hypothesis is consistent, the contact with `W_nn − sμW_nt < 0` becomes the clock until its slip stops: an impact without
//! approach (Painlevé's paradox).
//!
//! Source: Routh 1860; Glocker and Pfeiffer 1995 for the complementarity of several contacts; the walk by stages for several contacts is
//! this project's own (`docs/notation.md` names its conventions).

use super::answer::Solution;
use super::clock::Clock;
use super::rate::{Load, RateProblem};
use super::{ContactSet, ContactState, ImpactError, Law, Phase, Slip, StageEnd};

/// The outcome of an impact at several contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StagedOutcome<const N: usize> {
    /// Impulses (tangential, normal) on the body [N s].
    pub impulse: [[f64; 2]; N],
    /// Velocities (slip, normal) after [m/s].
    pub velocity: [[f64; 2]; N],
    /// Work of the tangential and of the normal impulse of each contact [J].
    pub work: [[f64; 2]; N],
    /// What each contact does at the end.
    pub state: [ContactState; N],
    /// The law that was used.
    pub law: Law,
    /// Largest number of consistent continuations met at a stage: above 1 the walk chose.
    pub branches: usize,
    /// True where the total work is positive beyond rounding (possible under Newton's law).
    pub gained_energy: bool,
    /// Common factor on the coefficients of restitution that keeps energy from growing; 1 where none is needed.
    pub restitution_scaled: f64,
    /// True where friction, not approach, forced the impact.
    pub without_approach: bool,
    /// Smallest scaled slack of the hypotheses walked.
    pub margin: f64,
}

/// One contact at one instant of the walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station<const N: usize> {
    /// Velocities (slip, normal) [m/s].
    pub velocity: [[f64; 2]; N],
    /// Impulses (tangential, normal) so far [N s].
    pub impulse: [[f64; 2]; N],
}

/// One straight stage of the walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StagedStage<const N: usize> {
    /// Compression or restitution.
    pub phase: Phase,
    /// What each contact does.
    pub slip: [Slip; N],
    /// Where the stage starts.
    pub start: Station<N>,
    /// Where it ends.
    pub end: Station<N>,
    /// Why it ends.
    pub ended_by: StageEnd,
}

/// Stages after which a walk is given up, per contact.
const STAGES_PER_CONTACT: usize = 64;
/// A velocity that changes sign within rounding is zero: this fraction of the terms it comes from.
const ROUNDING: f64 = 1e-13;
/// Work below this fraction of its terms is rounding.
const WORK_ROUNDING: f64 = 1e-12;

/// Resolves an impact at several contacts.
///
/// # Errors
/// [`ImpactError::Jammed`] where no continuation is consistent and no slip is left to stop; [`ImpactError::Unending`] after a budget of
/// stages.
pub fn resolve<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
) -> Result<StagedOutcome<N>, ImpactError> {
    resolve_observed(set, law, &mut |_: &StagedStage<N>| {})
}

/// As [`resolve`], handing every stage of the final walk to `observe` in order.
///
/// # Errors
/// As [`resolve`].
pub fn resolve_observed<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
    observe: &mut impl FnMut(&StagedStage<N>),
) -> Result<StagedOutcome<N>, ImpactError> {
    let closing = (0..set.count).filter(|&i| set.normal[i] < 0.0).count();
    let law = if closing == 1 { law } else { Law::Poisson };
    let mut walk = Walk::new(set);
    walk.compress(observe)?;
    let compressed = walk.clone();
    let mut factor = 1.0;
    walk.restitute(law, factor, &mut |_| {})?;
    if walk.gained_energy() && law != Law::Newton {
        factor = largest_harmless_factor(&compressed, law)?;
    }
    walk = compressed;
    walk.restitute(law, factor, observe)?;
    Ok(walk.outcome(law, factor))
}

/// The largest common factor on the restitution under which no energy is gained.
fn largest_harmless_factor<const N: usize, const M: usize>(
    from: &Walk<'_, N, M>,
    law: Law,
) -> Result<f64, ImpactError> {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let mut walk = from.clone();
        walk.restitute(law, middle, &mut |_| {})?;
        if walk.gained_energy() {
            high = middle;
        } else {
            low = middle;
        }
    }
    Ok(low)
}

/// A stage in which one contact is the clock.
struct Loaded<const N: usize> {
    clock: usize,
    chosen: Solution<N>,
    change: [[f64; 2]; N],
    step: Step,
}

#[derive(Clone)]
struct Walk<'a, const N: usize, const M: usize> {
    set: &'a ContactSet<N, M>,
    now: Station<N>,
    work: [[f64; 2]; N],
    present: Option<[Slip; N]>,
    stages: usize,
    branches: usize,
    without_approach: bool,
    margin: f64,
    /// Largest velocity before.
    fastest: f64,
}

/// The next event of a straight stage.
struct Step {
    length: f64,
    why: StageEnd,
}

impl<'a, const N: usize, const M: usize> Walk<'a, N, M> {
    fn new(set: &'a ContactSet<N, M>) -> Self {
        let velocity = std::array::from_fn(|i| [set.slip[i], set.normal[i]]);
        let all = set.slip[..set.count].iter().chain(&set.normal[..set.count]);
        Self {
            fastest: all.fold(0.0, |m: f64, u| m.max(u.abs())),
            set,
            now: Station { velocity, impulse: [[0.0; 2]; N] },
            work: [[0.0; 2]; N],
            present: None,
            stages: 0,
            branches: 1,
            without_approach: false,
            margin: f64::INFINITY,
        }
    }

    fn normal(&self, i: usize) -> f64 {
        self.now.velocity[i][1]
    }

    fn contacts(&self) -> std::ops::Range<usize> {
        0..self.set.count
    }

    fn ask(&self, drive: [[f64; 2]; N], load: [Load; N]) -> RateProblem<'a, N, M> {
        RateProblem {
            count: self.set.count,
            operator: &self.set.operator,
            friction: &self.set.friction,
            drive,
            slip: std::array::from_fn(|i| self.now.velocity[i][0]),
            load,
        }
    }

    fn solution(&mut self, drive: [[f64; 2]; N], load: [Load; N]) -> Option<Solution<N>> {
        let answer = self.ask(drive, load).solve();
        let chosen = answer.preferred(self.present.as_ref()).copied()?;
        self.branches = self.branches.max(answer.count);
        self.margin = self.margin.min(chosen.margin);
        Some(chosen)
    }

    fn compress(&mut self, observe: &mut impl FnMut(&StagedStage<N>)) -> Result<(), ImpactError> {
        // Contacts that only touch may be driven in by friction: then the paradox's contact starts the walk.
        if self.contacts().all(|i| self.normal(i) >= 0.0) {
            if self.driven_in().is_none() {
                return Ok(());
            }
            self.without_approach = true;
            self.force(Phase::Compression, observe)?;
        }
        while self.contacts().any(|i| self.normal(i) < 0.0) {
            self.spend()?;
            let drive = std::array::from_fn(|i| [0.0, self.normal(i).min(0.0)]);
            let load = std::array::from_fn(|i| {
                if i < self.set.count && self.normal(i) <= 0.0 { Load::Touching(0.0) } else { Load::Absent }
            });
            let Some(chosen) = self.solution(drive, load) else {
                self.force(Phase::Compression, observe)?;
                continue;
            };
            // The response includes the drive: what the impulse alone changes is the rest.
            let change = self.change(&chosen, &drive);
            let step =
                self.next_event(&chosen, &change, Step { length: 1.0, why: StageEnd::CompressionEnds });
            self.advance(Phase::Compression, &chosen, &change, &step, observe);
        }
        Ok(())
    }

    /// No hypothesis is consistent: one contact becomes the clock, loaded whatever its normal velocity does, up to the next event.
    ///
    /// It is the contact that friction drives in, alone or together with the contacts that touch; where there is none, contacts that
    /// close together drive each other in, and the one that approaches fastest is loaded first until it approaches no more.
    fn force(&mut self, phase: Phase, observe: &mut impl FnMut(&StagedStage<N>)) -> Result<(), ImpactError> {
        self.spend()?;
        let fastest = || {
            let approaching = self.contacts().filter(|&i| self.normal(i) < 0.0);
            approaching.min_by(|&i, &j| self.normal(i).total_cmp(&self.normal(j)))
        };
        let load = self
            .driven_in()
            .or_else(|| fastest().and_then(|i| self.loaded(i)).filter(|l| l.step.length.is_finite()));
        let Loaded { chosen, change, step, .. } = load.ok_or(ImpactError::Jammed)?;
        self.advance(phase, &chosen, &change, &step, observe);
        Ok(())
    }

    /// A contact that its own load drives into its obstacle, by friction alone or with the help of the contacts that follow: of several,
    /// the one that is driven in fastest per impulse.
    fn driven_in(&self) -> Option<Loaded<N>> {
        let touching = self.contacts().filter(|&i| self.normal(i) <= 0.0);
        let stages = touching
            .filter_map(|i| self.loaded(i))
            .filter(|l| l.change[l.clock][1] < 0.0 && l.step.length.is_finite());
        stages.min_by(|a, b| a.change[a.clock][1].total_cmp(&b.change[b.clock][1]))
    }

    /// The straight stage in which contact `clock` is loaded at rate 1, touching contacts following.
    fn loaded(&self, clock: usize) -> Option<Loaded<N>> {
        let load = std::array::from_fn(|i| {
            if i == clock {
                Load::Prescribed(1.0)
            } else if i < self.set.count && self.normal(i) == 0.0 {
                Load::Touching(0.0)
            } else {
                Load::Absent
            }
        });
        let drive = [[0.0; 2]; N];
        let chosen = *self.ask(drive, load).solve().preferred(self.present.as_ref())?;
        let change = self.change(&chosen, &drive);
        let (u, by) = (self.normal(clock), change[clock][1]);
        let length = if u < 0.0 && by > 0.0 { -u / by } else { f64::INFINITY };
        let step = self.next_event(&chosen, &change, Step { length, why: StageEnd::CompressionEnds });
        Some(Loaded { clock, chosen, change, step })
    }

    fn restitute(
        &mut self,
        law: Law,
        factor: f64,
        observe: &mut impl FnMut(&StagedStage<N>),
    ) -> Result<(), ImpactError> {
        let debt: [f64; N] = std::array::from_fn(|i| {
            let owes = i < self.set.count && self.normal(i) <= 0.0;
            if owes { factor * self.set.restitution[i] * self.now.impulse[i][1] } else { 0.0 }
        });
        let striking = self.contacts().find(|&i| self.set.normal[i] < 0.0).unwrap_or(0);
        let e = factor * self.set.restitution[striking];
        let mut clock = Clock::new(law, striking, e, self.work[striking][1], self.set.normal[striking]);
        if debt[..self.set.count].iter().all(|d| *d <= 0.0) || (law != Law::Poisson && debt[striking] <= 0.0)
        {
            return Ok(());
        }
        loop {
            self.spend()?;
            let load = std::array::from_fn(|i| match (i < self.set.count, self.normal(i) <= 0.0) {
                (true, true) => Load::Touching(debt[i]),
                (true, false) if debt[i] > 0.0 => Load::Prescribed(debt[i]),
                _ => Load::Absent,
            });
            let drive = [[0.0; 2]; N];
            let Some(chosen) = self.solution(drive, load) else {
                // A slip that reversed into the paradox: stop it first, then let nothing approach.
                self.force(Phase::Restitution, observe)?;
                self.compress(observe)?;
                continue;
            };
            let change = self.change(&chosen, &drive);
            let end = Step {
                length: clock.left(
                    self.normal(clock.striking),
                    change[clock.striking][1],
                    chosen.rates[clock.striking][1],
                ),
                why: StageEnd::RestitutionEnds,
            };
            let step = self.next_event(&chosen, &change, end);
            if !step.length.is_finite() {
                return Err(ImpactError::Jammed);
            }
            let work = self.work[clock.striking][1];
            self.advance(Phase::Restitution, &chosen, &change, &step, observe);
            clock.spend(step.length, self.work[clock.striking][1] - work);
            if step.why == StageEnd::RestitutionEnds {
                return Ok(());
            }
        }
    }

    fn spend(&mut self) -> Result<(), ImpactError> {
        self.stages += 1;
        let most = STAGES_PER_CONTACT * self.set.count;
        if self.stages > most { Err(ImpactError::Unending { stages: most }) } else { Ok(()) }
    }

    /// Change of each velocity per unit of the stage, exactly zero where the hypothesis says so.
    fn change(&self, chosen: &Solution<N>, drive: &[[f64; 2]; N]) -> [[f64; 2]; N] {
        std::array::from_fn(|i| {
            let mut change = [chosen.response[i][0] - drive[i][0], chosen.response[i][1] - drive[i][1]];
            if chosen.guess[i].slip == Slip::Sticks {
                change[0] = -drive[i][0];
            }
            if chosen.guess[i].holds {
                change[1] = -drive[i][1];
            }
            change
        })
    }

    fn next_event(&self, chosen: &Solution<N>, change: &[[f64; 2]; N], end: Step) -> Step {
        let mut next = end;
        for i in self.contacts() {
            let ([u_t, u_n], [d_t, d_n]) = (self.now.velocity[i], change[i]);
            if matches!(chosen.guess[i].slip, Slip::Forward | Slip::Backward) && u_t * d_t < 0.0 {
                let length = -u_t / d_t;
                if length < next.length {
                    next = Step { length, why: StageEnd::SlipStops(i) };
                }
            }
            if u_n > 0.0 && d_n < 0.0 {
                let length = -u_n / d_n;
                if length < next.length {
                    next = Step { length, why: StageEnd::Closes(i) };
                }
            }
        }
        next
    }

    fn advance(
        &mut self,
        phase: Phase,
        chosen: &Solution<N>,
        change: &[[f64; 2]; N],
        step: &Step,
        observe: &mut impl FnMut(&StagedStage<N>),
    ) {
        let start = self.now;
        for i in self.contacts() {
            for axis in 0..2 {
                let (u, by) = (start.velocity[i][axis], change[i][axis] * step.length);
                let sum = u + by;
                // Contacts of one face stop and close together: rounding must not tell them apart.
                let zero = sum.abs() <= ROUNDING * (u.abs() + by.abs()).max(self.fastest);
                let rate = chosen.rates[i][axis];
                let v = if zero { 0.0 } else { sum };
                self.now.velocity[i][axis] = v;
                self.now.impulse[i][axis] += rate * step.length;
                self.work[i][axis] += 0.5 * (u + v) * rate * step.length;
            }
        }
        match step.why {
            StageEnd::SlipStops(i) => self.now.velocity[i][0] = 0.0,
            StageEnd::Closes(i) => self.now.velocity[i][1] = 0.0,
            StageEnd::CompressionEnds | StageEnd::RestitutionEnds => {}
        }
        if step.why == StageEnd::CompressionEnds {
            for i in self.contacts().filter(|&i| start.velocity[i][1] <= 0.0) {
                if chosen.guess[i].holds || self.now.velocity[i][1] < 0.0 {
                    self.now.velocity[i][1] = 0.0;
                }
            }
        }
        let slip = std::array::from_fn(|i| chosen.guess[i].slip);
        self.present = Some(slip);
        observe(&StagedStage { phase, slip, start, end: self.now, ended_by: step.why });
    }

    fn total_work(&self) -> (f64, f64) {
        let all = self.work[..self.set.count].iter().flatten();
        (all.clone().sum(), all.map(|w| w.abs()).sum())
    }

    fn gained_energy(&self) -> bool {
        let (work, terms) = self.total_work();
        work > WORK_ROUNDING * terms
    }

    fn outcome(&self, law: Law, restitution_scaled: f64) -> StagedOutcome<N> {
        let state = std::array::from_fn(|i| {
            let [u_t, u_n] = self.now.velocity[i];
            if u_n > 0.0 {
                ContactState::Separates
            } else if u_t == 0.0 {
                ContactState::Sticks
            } else {
                ContactState::Slips
            }
        });
        StagedOutcome {
            impulse: self.now.impulse,
            velocity: self.now.velocity,
            work: self.work,
            state,
            law,
            branches: self.branches,
            gained_energy: self.gained_energy(),
            restitution_scaled,
            without_approach: self.without_approach,
            margin: self.margin,
        }
    }
}
