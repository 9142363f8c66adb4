//! The walk of several contacts in space through compression and restitution.

use super::debt::Debts;
use super::leg::{Goal, Leg, Place, StageEvent, Walked, modes};
use super::staged::{Ground, Stage, StagedOutcome, Station};
use crate::Load;
use crate::spatial::contacts::set::ContactSet;
use crate::spatial::rates::answer::{Answer, Freedom, Guess, Mode, Preference, Solution};
use crate::spatial::rates::rate::RateProblem;
use crate::tolerance::{
    AT_FOLD, AT_REST, BARELY_CARRIES, NOT_STARTED, STAGE_ZERO, WEDGED_STAGE, WORK_GAINED_IN_SPACE,
};
use crate::{ImpactError, Law, Phase};
use carom_num::Vec3;

/// Stages after which a walk is given up, per contact.
const STAGES_PER_CONTACT: usize = 1 << 10;

/// What a stage is walked for: what was asked, and why it is walked as it is.
#[derive(Clone, Copy)]
pub(super) struct Purpose<const N: usize> {
    pub(super) phase: Phase,
    pub(super) drive: [Vec3; N],
    pub(super) load: [Load; N],
    pub(super) ground: Ground,
}

/// Where a walk stands.
#[derive(Clone, Copy)]
pub(super) struct Walk<'a, const N: usize> {
    pub(super) set: &'a ContactSet<N>,
    pub(super) place: Place<N>,
    preference: Preference,
    /// What contacts did in the stage before.
    present: Option<[Mode; N]>,
    /// The hypothesis that the last event leads to.
    led_to: Option<[Guess; N]>,
    /// A contact of a face that has just ceased to carry, or begun to.
    carries: Option<(usize, bool)>,
    /// A contact that neither sticks nor starts to slip any longer, though at the edge of its cone both are consistent.
    folded: Option<usize>,
    stages: usize,
    pub(super) branches: usize,
    examined: bool,
    freedom: Freedom,
    without_approach: bool,
    forced: usize,
    margin: f64,
    /// Largest velocity before, and entry of the operator.
    pub(super) fastest: f64,
    largest_response: f64,
    /// Magnitudes of all that was added to velocities, and of all works: what their rounding is measured against.
    pub(super) added: f64,
    pub(super) work_terms: f64,
}

impl<'a, const N: usize> Walk<'a, N> {
    pub(super) fn new(set: &'a ContactSet<N>, preference: Preference) -> Self {
        let count = set.count;
        let blocks = set.operator[..count].iter().flat_map(|row| &row[..count]);
        let entries = blocks.flat_map(|b| b.rows).flat_map(Vec3::to_array);
        let fastest = set.velocity[..count].iter().fold(0.0, |m: f64, u| m.max(u.norm()));
        // A foot that rests but for rounding neither approaches nor slips: else it would be a contact that others may drive in.
        let rests = |u: f64| if u.abs() <= STAGE_ZERO * fastest { 0.0 } else { u };
        let velocity = set.velocity.map(|u| Vec3::new(rests(u.x), rests(u.y), rests(u.z)));
        Self {
            set,
            place: Place { at: Station { velocity, impulse: [Vec3::ZERO; N] }, work: [[0.0; 2]; N] },
            preference,
            present: None,
            led_to: None,
            carries: None,
            folded: None,
            stages: 0,
            branches: 1,
            examined: true,
            freedom: Freedom::None,
            without_approach: false,
            forced: 0,
            margin: f64::INFINITY,
            fastest,
            largest_response: entries.fold(0.0, |m: f64, w| m.max(w.abs())),
            added: 0.0,
            work_terms: 0.0,
        }
    }

    pub(super) fn normal(&self, i: usize) -> f64 {
        self.place.at.velocity[i].z
    }

    pub(super) fn contacts(&self) -> std::ops::Range<usize> {
        0..self.set.count
    }

    pub(super) fn ask(&self, drive: [Vec3; N], load: [Load; N]) -> RateProblem<'a, N> {
        RateProblem {
            count: self.set.count,
            operator: &self.set.operator,
            friction: &self.set.friction,
            drive,
            slip: self.place.at.velocity.map(|u| [u.x, u.y]),
            load,
        }
    }

    /// Of several continuations the one that is walked.
    pub(super) fn preferred(&self, answer: &Answer<N>) -> Option<Solution<N>> {
        answer.preferred(self.present.as_ref(), self.preference).copied()
    }

    /// The leg of the preferred continuation; `None` where there is none.
    fn leg(&mut self, drive: [Vec3; N], load: [Load; N], goal: Goal<N>) -> Option<(Leg<'a, N>, Solution<N>)> {
        let problem = self.ask(drive, load);
        if let Some(i) = self.folded.take() {
            return self.beyond(&problem, i, goal);
        }
        let answer = problem.solve_first();
        // At an edge two hypotheses are one motion, and the one that the event leads to goes on.
        let led = self.led_to.take().and_then(|guess| problem.first_of(&guess));
        let carries = self.carries.take().filter(|_| led.is_none());
        let solution = led.or_else(|| self.preferred(&answer))?;
        self.branches = self.branches.max(answer.count);
        self.examined &= answer.examined;
        self.margin = self.margin.min(solution.margin);
        let leg = self.leg_of(&solution, drive, load, goal);
        // What has just changed in how a face shares its load stays so, though at this instant both ways are one.
        let shared = carries.filter(|&(i, _)| {
            let all: f64 = solution.rates.iter().map(|p| p.z).sum();
            let barely = solution.rates[i].z - problem.base(i) <= BARELY_CARRIES * all;
            let sticks = solution.guess.iter().any(|g| g.mode == Mode::Sticks);
            barely && !sticks && solution.freedom != Freedom::None && solution.guess[i].holds
        });
        let changed = shared.map(|(i, carries)| Leg { member: leg.member.carrying(i, carries), ..leg });
        // Where too few are left to hold the face, they do so at this instant alone.
        let changed = changed.filter(|leg| leg.turned([0.6, 0.8]).is_some());
        Some((changed.unwrap_or(leg), solution))
    }

    /// The leg beyond a fold, where sticking and starting to slip have become one and end: the solution that is farthest from being rejected, if it is not
    /// one of these.
    fn beyond(
        &mut self,
        problem: &RateProblem<'a, N>,
        i: usize,
        goal: Goal<N>,
    ) -> Option<(Leg<'a, N>, Solution<N>)> {
        let answer = problem.solve();
        let away = answer.iter().filter(|s| s.margin > AT_FOLD || s.guess[i].mode == Mode::Open);
        let solution = *away.max_by(|a, b| a.margin.total_cmp(&b.margin))?;
        self.examined &= answer.examined;
        Some((self.leg_of(&solution, problem.drive, problem.load, goal), solution))
    }

    pub(super) fn leg_of(
        &self,
        solution: &Solution<N>,
        drive: [Vec3; N],
        load: [Load; N],
        goal: Goal<N>,
    ) -> Leg<'a, N> {
        Leg {
            set: self.set,
            drive,
            load,
            guess: solution.guess,
            direction: solution.direction,
            member: solution.member,
            goal,
            fastest: self.fastest,
            largest_response: self.largest_response,
        }
    }

    /// Walks a leg and shows it; `None` where nothing ends it.
    pub(super) fn go(
        &mut self,
        leg: &Leg<'a, N>,
        solution: &Solution<N>,
        purpose: &Purpose<N>,
        observe: &mut impl FnMut(&Stage<N>),
    ) -> Result<Option<Walked<N>>, ImpactError> {
        let Some(now) = leg.pace_of(&solution.rates) else { return Ok(None) };
        let from = self.place;
        let on_lines = if leg.is_straight(&now) { None } else { leg.on_lines(&from, &now) };
        let (leg, now) = match on_lines.and_then(|leg| Some((leg, leg.pace(&leg.direction)?))) {
            Some(on_lines) => on_lines,
            None => (*leg, now),
        };
        let straight = leg.is_straight(&now);
        let walked = if straight { leg.go_straight(&from, &now) } else { Some(leg.go_curved(&from, &now)?) };
        let Some(walked) = walked else { return Ok(None) };
        // Wedged contacts press each other without end, and velocities drown in rounding.
        let pressed = |i: usize| (walked.place.at.impulse[i] - from.at.impulse[i]).norm();
        let added: f64 = self.contacts().map(|i| self.largest_response * pressed(i)).sum();
        if added.is_nan() || added > WEDGED_STAGE * self.fastest {
            return Ok(None);
        }
        self.added += added;
        self.place = walked.place;
        self.freedom = self.freedom.max(solution.freedom);
        let mode = modes(solution);
        self.present = Some(mode);
        self.folded = match walked.event {
            StageEvent::SlipStops(i)
                if mode[i] == Mode::Starts && walked.clock <= NOT_STARTED * leg.span() =>
            {
                Some(i)
            }
            _ => None,
        };
        let mut guess = solution.guess;
        if matches!(walked.event, StageEvent::Opens(_)) {
            // With it those open that carry nothing, if it is not the whole face that goes on.
            self.contacts().filter(|&i| leg.lifted(i).is_some()).for_each(|i| guess[i] = Guess::OPEN);
        }
        self.led_to = led_to(&guess, walked.event, &self.place.at);
        self.carries = match walked.event {
            StageEvent::Opens(i) => Some((i, false)),
            StageEvent::Loads(i) if leg.lifted(i).is_some() => Some((i, true)),
            _ => None,
        };
        for i in self.contacts() {
            let works = self.place.work[i].iter().zip(&from.work[i]);
            self.work_terms += works.map(|(now, before)| (now - before).abs()).sum::<f64>();
        }
        let Purpose { phase, drive, load, ground } = *purpose;
        self.forced += usize::from(ground != Ground::Consistent);
        observe(&Stage {
            phase,
            mode,
            start: from.at,
            end: self.place.at,
            ended_by: walked.event,
            straight,
            drive,
            load,
            clocks: std::array::from_fn(|i| leg.may_sink(i)),
            ground,
        });
        Ok(Some(walked))
    }

    /// What compression asks: contacts that approach or touch, driven by their approach.
    fn approaching(&self) -> Purpose<N> {
        let count = self.set.count;
        let drive =
            std::array::from_fn(|i| if i < count { Vec3::Z * self.normal(i).min(0.0) } else { Vec3::ZERO });
        let touches = |i: usize| i < count && self.normal(i) <= 0.0;
        let load = std::array::from_fn(|i| if touches(i) { Load::Touching(0.0) } else { Load::Absent });
        Purpose { phase: Phase::Compression, drive, load, ground: Ground::Consistent }
    }

    /// Walks until no contact approaches.
    pub(super) fn compress(&mut self, observe: &mut impl FnMut(&Stage<N>)) -> Result<(), ImpactError> {
        // Contacts that only touch may be driven in by friction: then the paradox's contact starts the walk.
        if self.contacts().all(|i| self.normal(i) >= 0.0) {
            if !self.is_driven_in() {
                return Ok(());
            }
            self.without_approach = true;
            self.force(&self.approaching(), false, observe)?;
        }
        while self.contacts().any(|i| self.normal(i) < -AT_REST * self.added) {
            self.spend()?;
            let purpose = self.approaching();
            let went = match self.leg(purpose.drive, purpose.load, Goal::Clock(1.0)) {
                Some((leg, solution)) => self.go(&leg, &solution, &purpose, observe)?,
                None => None,
            };
            let paradox = went.is_some_and(|walked| walked.event == StageEvent::DrivenIn);
            if (paradox || went.is_none()) && !self.force(&self.approaching(), paradox, observe)? {
                break;
            }
        }
        for i in self.contacts() {
            let u = &mut self.place.at.velocity[i];
            u.z = u.z.max(0.0);
        }
        Ok(())
    }

    /// Walks until the law's measure of restitution, times `factor`, is used up.
    pub(super) fn restitute(
        &mut self,
        law: Law,
        factor: f64,
        observe: &mut impl FnMut(&Stage<N>),
    ) -> Result<(), ImpactError> {
        let mut debts = Debts::new(self.set, &self.place, law, factor);
        while debts.any() {
            self.spend()?;
            let load = std::array::from_fn(|i| match (i < self.set.count, self.normal(i) <= 0.0) {
                (true, true) => Load::Touching(debts.rate[i]),
                (true, false) if debts.rate[i] > 0.0 => Load::Prescribed(debts.rate[i]),
                _ => Load::Absent,
            });
            let (phase, drive, ground) = (Phase::Restitution, [Vec3::ZERO; N], Ground::Consistent);
            let purpose = Purpose { phase, drive, load, ground };
            let leg = self.leg(drive, load, debts.goal());
            let (mut paradox, mut turned) = (leg.is_none(), false);
            if let Some((leg, solution)) = leg {
                let Some(walked) = self.go(&leg, &solution, &purpose, observe)? else {
                    // Wedged: whatever it is pressed with, nothing rises, and nothing is returned.
                    break;
                };
                debts.pay(walked.event, walked.clock, &walked.work);
                turned = walked.event == StageEvent::DrivenIn;
                paradox = turned;
            }
            if paradox {
                // A slip that turned into the paradox: stop it first, then let nothing approach.
                let before = self.place.work;
                if !self.force(&purpose, turned, observe)? {
                    break;
                }
                self.compress(observe)?;
                debts.count(|i| self.place.work[i][1] - before[i][1]);
            }
        }
        // An end may come within rounding before a contact closes.
        if self.contacts().any(|i| self.normal(i) < 0.0) { self.compress(observe) } else { Ok(()) }
    }

    pub(super) fn spend(&mut self) -> Result<(), ImpactError> {
        self.stages += 1;
        let most = STAGES_PER_CONTACT * self.set.count;
        if self.stages > most { Err(ImpactError::Unending { stages: most }) } else { Ok(()) }
    }

    pub(super) fn total_work(&self) -> f64 {
        self.place.work[..self.set.count].iter().flatten().sum()
    }

    pub(super) fn gained_energy(&self) -> bool {
        self.total_work() > WORK_GAINED_IN_SPACE * self.work_terms
    }

    pub(super) fn outcome(&self, law: Law, restitution_scaled: f64) -> Result<StagedOutcome<N>, ImpactError> {
        let Place { at: Station { velocity, impulse }, work } = self.place;
        let sound = velocity.iter().chain(&impulse).all(|v| v.is_finite()) && self.work_terms.is_finite();
        if !sound {
            return Err(ImpactError::Overflow);
        }
        // However little is returned: contacts wedge the body so hard that rounding of their impulses is as large as its motion.
        if !self.is_accounted_for() || law != Law::Newton && self.gained_energy() {
            return Err(ImpactError::Jammed);
        }
        Ok(StagedOutcome {
            impulse,
            velocity,
            work,
            law,
            branches: self.branches,
            examined: self.examined,
            freedom: self.freedom,
            gained_energy: self.gained_energy(),
            restitution_scaled,
            without_approach: self.without_approach,
            forced: self.forced,
            margin: self.margin,
            stages: self.stages,
        })
    }
}

/// The hypothesis that an event leads to, where it is an inequality that has come to its edge.
fn led_to<const N: usize>(guess: &[Guess; N], event: StageEvent, at: &Station<N>) -> Option<[Guess; N]> {
    let mut next = *guess;
    for (g, u) in next.iter_mut().zip(&at.velocity).filter(|(g, _)| g.mode == Mode::Starts) {
        if (u.x, u.y) != (0.0, 0.0) {
            g.mode = Mode::Slips;
        }
    }
    match event {
        StageEvent::Opens(i) => next[i] = Guess::OPEN,
        StageEvent::SlipStarts(i) => next[i].mode = Mode::Starts,
        StageEvent::Loads(i) => {
            let slips = (at.velocity[i].x, at.velocity[i].y) != (0.0, 0.0);
            next[i] = Guess { holds: true, mode: if slips { Mode::Slips } else { Mode::Sticks } };
        }
        _ => return None,
    }
    Some(next)
}
