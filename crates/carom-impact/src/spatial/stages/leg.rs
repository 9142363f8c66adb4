//! One stage of the walk of several contacts: what each contact does stays the same, but slips may turn.
//!
//! Rates depend on the directions of the slips alone. Where friction turns none of them the stage is straight, and ends in closed form. Else it is a curve, in
//! polar coordinates of every slip, with the clock of [`curve`](super::curve).

use super::staged::Station;
use crate::Load;
use crate::spatial::contacts::set::ContactSet;
use crate::spatial::rates::answer::{Guess, Member, Mode, Solution};
use crate::spatial::rates::equations::Hypothesis;
use crate::spatial::rates::rate::RateProblem;
use crate::tolerance::{NO_SLIP, ON_LINE, SMALL_SLIP, STAGE_ZERO, STRAIGHT_TURN};
use carom_num::Vec3;

/// What ends a stage of several contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StageEvent {
    /// The slip of this contact comes to zero.
    SlipStops(usize),
    /// This open contact closes again.
    Closes(usize),
    /// This contact has nothing left to push with, and opens.
    Opens(usize),
    /// This contact cannot stick any longer.
    SlipStarts(usize),
    /// This contact takes an impulse as well: it approached and others had turned it back, or it touched and others carried for it.
    Loads(usize),
    /// Friction drives the contacts in: no impulse along the slips as they are now ends the approach.
    DrivenIn,
    /// This contact has returned its work (Stronge's law).
    Repaid(usize),
    /// No contact approaches any more.
    CompressionEnds,
    /// The law's measure of restitution is used up.
    RestitutionEnds,
}

/// How far a stage goes where nothing else ends it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Goal<const N: usize> {
    /// The clock comes to this.
    Clock(f64),
    /// The approach of this contact comes to its end.
    Approach(usize),
    /// The normal velocity of this contact comes to this.
    Velocity(usize, f64),
    /// The work of the normal impulse of a contact in this stage comes to its number; infinite where nothing is owed.
    Work([f64; N]),
}

/// Where a walk stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<const N: usize> {
    pub(super) at: Station<N>,
    /// Work of the tangential and of the normal impulse of each contact.
    pub(super) work: [[f64; 2]; N],
}

/// A stage to be walked.
#[derive(Clone, Copy)]
pub(super) struct Leg<'a, const N: usize> {
    pub(super) set: &'a ContactSet<N>,
    pub(super) drive: [Vec3; N],
    pub(super) load: [Load; N],
    pub(super) guess: [Guess; N],
    /// Directions of slips at its start.
    pub(super) direction: [[f64; 2]; N],
    /// Which rates are meant where they are a family.
    pub(super) member: Member,
    pub(super) goal: Goal<N>,
    /// Largest velocity of the impact, and entry of its operator: what rounding is measured against.
    pub(super) fastest: f64,
    pub(super) largest_response: f64,
}

/// Rates at one instant.
#[derive(Clone, Copy)]
pub(super) struct Pace<const N: usize> {
    /// For one unit of all normal impulses together.
    pub(super) rates: [Vec3; N],
    /// The change of velocities that they cause.
    pub(super) response: [Vec3; N],
    /// By how much the clock advances meanwhile.
    pub(super) clock: f64,
}

/// How a stage ended.
#[derive(Clone, Copy)]
pub(super) struct Walked<const N: usize> {
    pub(super) place: Place<N>,
    /// By how much the clock advanced.
    pub(super) clock: f64,
    /// Work of the tangential and of the normal impulse of each contact in this stage.
    pub(super) work: [[f64; 2]; N],
    pub(super) event: StageEvent,
}

impl<'a, const N: usize> Leg<'a, N> {
    pub(super) fn contacts(&self) -> std::ops::Range<usize> {
        0..self.set.count
    }

    /// True where the slip of contact i decides the direction of its friction.
    pub(super) fn is_tracked(&self, i: usize) -> bool {
        self.guess[i].slides() && self.direction[i] != [0.0; 2] && self.set.friction[i] > 0.0
    }

    /// The rates with these directions; `None` where nothing can be said.
    pub(super) fn pace(&self, direction: &[[f64; 2]; N]) -> Option<Pace<N>> {
        let problem = self.problem(direction);
        let hypothesis = Hypothesis { problem: &problem, guess: &self.guess, direction: *direction };
        let rates = match self.member {
            Member::Springs(lifted) => hypothesis.sprung_by(lifted)?.0,
            Member::Middle => hypothesis.middle()?,
        };
        self.pace_of(&rates)
    }

    /// By how much contact i, which is lifted, sinks in, at the pace of this clock: below zero as long as it is.
    pub(super) fn sinks(&self, i: usize, lifted: u32, direction: &[[f64; 2]; N], clock: f64) -> Option<f64> {
        let problem = self.problem(direction);
        let hypothesis = Hypothesis { problem: &problem, guess: &self.guess, direction: *direction };
        Some(hypothesis.sprung_by(lifted)?.1[i] * clock)
    }

    /// The contacts that hold and are lifted off their springs, one bit each, where contact i is one of them.
    pub(super) fn lifted(&self, i: usize) -> Option<u32> {
        let Member::Springs(lifted) = self.member else { return None };
        (lifted & (1 << i) != 0).then_some(lifted)
    }

    fn problem(&self, direction: &[[f64; 2]; N]) -> RateProblem<'a, N> {
        RateProblem {
            count: self.set.count,
            operator: &self.set.operator,
            friction: &self.set.friction,
            drive: self.drive,
            slip: *direction,
            load: self.load,
        }
    }

    pub(super) fn pace_of(&self, rates: &[Vec3; N]) -> Option<Pace<N>> {
        let total: f64 = rates[..self.set.count].iter().map(|p| p.z).sum();
        let clock = 1.0 / total;
        let rates = rates.map(|p| p * clock);
        let response = self.set.responses(&rates);
        (clock.is_finite() && response.iter().all(|w| w.is_finite())).then_some(Pace {
            rates,
            response,
            clock,
        })
    }

    /// True where friction turns no slip at these rates.
    pub(super) fn is_straight(&self, now: &Pace<N>) -> bool {
        let all: f64 = now.rates[..self.set.count].iter().map(|p| p.norm()).sum();
        self.contacts().filter(|&i| self.is_tracked(i)).all(|i| {
            let [x, y] = self.direction[i];
            let w = now.response[i];
            (x * w.y - y * w.x).abs() <= STRAIGHT_TURN * self.largest_response * all
        })
    }

    /// The rates if every slip were turned by the angle of this cosine and sine.
    pub(super) fn turned(&self, by: [f64; 2]) -> Option<Pace<N>> {
        let mut direction = self.direction;
        for i in self.contacts().filter(|&i| self.is_tracked(i)) {
            let [x, y] = self.direction[i];
            direction[i] = [x * by[0] - y * by[1], x * by[1] + y * by[0]];
        }
        self.pace(&direction)
    }

    /// The same stage with every slip exactly on a line, where the others leave each slipping contact one line only: a contact that slips while
    /// another sticks turns about that one. `None` where a slip may turn. Else rounding across the line would grow without bound relative to a
    /// slip that stops on it.
    pub(super) fn on_lines(&self, from: &Place<N>, now: &Pace<N>) -> Option<Self> {
        let responses =
            [now.response, self.turned([0.6, 0.8])?.response, self.turned([-0.28, 0.96])?.response];
        let mut leg = *self;
        for i in self.contacts().filter(|&i| self.is_tracked(i)) {
            let size = |w: &Vec3| w.x * w.x + w.y * w.y;
            let along = responses.iter().map(|w| w[i]).max_by(|a, b| size(a).total_cmp(&size(b)))?;
            let length = size(&along).sqrt();
            let (u, [x, y]) = (from.at.velocity[i], [along.x / length, along.y / length]);
            let aside = |v: Vec3| (x * v.y - y * v.x).abs();
            let fixed = responses.iter().all(|w| aside(w[i]) <= ON_LINE * length);
            if !fixed || aside(u) > ON_LINE * self.fastest {
                return None;
            }
            let [dx, dy] = self.direction[i];
            let sign = 1.0_f64.copysign(x * dx + y * dy);
            leg.direction[i] = [sign * x, sign * y];
        }
        Some(leg)
    }

    /// Goes straight to the first event.
    pub(super) fn go_straight(&self, from: &Place<N>, now: &Pace<N>) -> Option<Walked<N>> {
        let (length, event) = self.first_event(from, now)?;
        let mut place = *from;
        for i in self.contacts() {
            place.at.impulse[i] += now.rates[i] * length;
        }
        let clock = now.clock * length;
        self.settle(from, &mut place, clock, |i| {
            let [x, y] = self.direction[i];
            let (u, w) = (from.at.velocity[i], now.response[i]);
            (x * (u.x + w.x * length) + y * (u.y + w.y * length), self.direction[i], true)
        });
        self.mark(&mut place, event);
        let mut work = [[0.0; 2]; N];
        for i in self.contacts() {
            let mean = (from.at.velocity[i] + place.at.velocity[i]) * 0.5;
            let p = now.rates[i] * length;
            work[i] = [mean.x * p.x + mean.y * p.y, mean.z * p.z];
            place.work[i][0] += work[i][0];
            place.work[i][1] += work[i][1];
        }
        Some(Walked { place, clock, work, event })
    }

    /// Velocities at the end of a stage, from its impulses; `slip` says the slip of a contact that slides, its direction, and whether it has not turned.
    pub(super) fn settle(
        &self,
        from: &Place<N>,
        place: &mut Place<N>,
        clock: f64,
        slip: impl Fn(usize) -> (f64, [f64; 2], bool),
    ) {
        let impulse: [Vec3; N] = std::array::from_fn(|i| place.at.impulse[i] - from.at.impulse[i]);
        let by = self.set.responses(&impulse);
        for i in self.contacts() {
            let u = from.at.velocity[i];
            let sum = |u: f64, by: f64| {
                let zero = (u + by).abs() <= STAGE_ZERO * (u.abs() + by.abs()).max(self.fastest);
                if zero { 0.0 } else { u + by }
            };
            let mut v = Vec3::new(sum(u.x, by[i].x), sum(u.y, by[i].y), sum(u.z, by[i].z));
            if self.guess[i].holds {
                v.z = sum(u.z, -self.drive[i].z * clock);
            } else if u.z == 0.0 && !self.may_sink(i) {
                // But for the slack that a hypothesis is allowed, what opens does not sink in.
                v.z = v.z.max(0.0);
            }
            if self.guess[i].mode == Mode::Sticks {
                (v.x, v.y) = (0.0, 0.0);
            } else if self.is_tracked(i) {
                let (s, [x, y], on_line) = slip(i);
                if s <= NO_SLIP * self.fastest {
                    (v.x, v.y) = (0.0, 0.0);
                } else if on_line || s <= SMALL_SLIP * self.fastest {
                    // Of a small slip the impulses do not tell the direction.
                    (v.x, v.y) = (s * x, s * y);
                }
            }
            place.at.velocity[i] = v;
        }
    }

    /// Sets to exactly zero what an event says is zero.
    pub(super) fn mark(&self, place: &mut Place<N>, event: StageEvent) {
        match event {
            StageEvent::SlipStops(i) => {
                let v = &mut place.at.velocity[i];
                (v.x, v.y) = (0.0, 0.0);
            }
            StageEvent::Closes(i) => place.at.velocity[i].z = 0.0,
            StageEvent::CompressionEnds => {
                // Only those that are loaded come to rest: others may approach still.
                for i in self.contacts().filter(|&i| self.guess[i].mode != Mode::Open) {
                    place.at.velocity[i].z = 0.0;
                }
            }
            _ => {}
        }
    }

    /// The first of: a slip stops, an open contact closes, the goal; as an impulse of all contacts together.
    fn first_event(&self, from: &Place<N>, now: &Pace<N>) -> Option<(f64, StageEvent)> {
        let mut next = self.goal_from(from, now);
        for i in self.contacts() {
            let (u, w) = (from.at.velocity[i], now.response[i]);
            if self.is_tracked(i) {
                let [x, y] = self.direction[i];
                let (s, growth) = (x * u.x + y * u.y, x * w.x + y * w.y);
                if s > 0.0 && growth < 0.0 && s / -growth < next.0 {
                    next = (s / -growth, StageEvent::SlipStops(i));
                }
            }
            // What is held, or kept out, does not move along its normal.
            if u.z > 0.0 && w.z < 0.0 && !self.guess[i].holds && u.z / -w.z < next.0 {
                next = (u.z / -w.z, StageEvent::Closes(i));
            }
        }
        next.0.is_finite().then_some(next)
    }

    fn goal_from(&self, from: &Place<N>, now: &Pace<N>) -> (f64, StageEvent) {
        let rising = |i: usize, to: f64| {
            let (u, w) = (from.at.velocity[i].z, now.response[i].z);
            if w > 0.0 { ((to - u) / w).max(0.0) } else { f64::INFINITY }
        };
        match self.goal {
            Goal::Clock(end) => (end.max(0.0) / now.clock, self.end()),
            Goal::Approach(i) => {
                (if from.at.velocity[i].z < 0.0 { rising(i, 0.0) } else { f64::INFINITY }, self.end())
            }
            Goal::Velocity(i, end) => (rising(i, end), self.end()),
            Goal::Work(end) => {
                let mut first = (f64::INFINITY, self.end());
                for i in self.contacts().filter(|&i| end[i].is_finite()) {
                    let length = returns(end[i], from.at.velocity[i].z, now, i);
                    if length < first.0 {
                        first = (length, StageEvent::Repaid(i));
                    }
                }
                first
            }
        }
    }

    /// This contact is loaded because friction drives it in.
    pub(super) fn may_sink(&self, i: usize) -> bool {
        matches!((self.goal, self.load[i]), (Goal::Approach(_), Load::Prescribed(_)))
    }

    /// What the clock of the whole phase is.
    pub(super) fn span(&self) -> f64 {
        match self.goal {
            Goal::Clock(_) | Goal::Work(_) => 1.0,
            Goal::Approach(_) | Goal::Velocity(..) => self.fastest / self.largest_response,
        }
    }

    /// A contact whose debt is paid before the stage begins.
    pub(super) fn owes_nothing(&self) -> Option<usize> {
        let Goal::Work(left) = self.goal else { return None };
        self.contacts().find(|&i| left[i] <= 0.0)
    }

    /// The event of its goal.
    pub(super) fn end(&self) -> StageEvent {
        match self.goal {
            Goal::Approach(_) => StageEvent::CompressionEnds,
            Goal::Clock(_) if self.drive.iter().any(|d| d.z != 0.0) => StageEvent::CompressionEnds,
            _ => StageEvent::RestitutionEnds,
        }
    }
}

/// Impulse after which the normal impulse of contact i has done this work.
fn returns<const N: usize>(work: f64, u: f64, now: &Pace<N>, i: usize) -> f64 {
    let (rate, growth) = (now.rates[i].z, now.response[i].z);
    if work <= 0.0 {
        return 0.0;
    }
    // rate (u N + growth N²/2) = work, without cancellation.
    let left = work / rate;
    let root = u * u + 2.0 * growth * left;
    if root > 0.0 && u + root.sqrt() > 0.0 { 2.0 * left / (u + root.sqrt()) } else { f64::INFINITY }
}

impl<const N: usize> ContactSet<N> {
    /// The change of velocities that impulses cause.
    pub(super) fn responses(&self, impulse: &[Vec3; N]) -> [Vec3; N] {
        let mut out = [Vec3::ZERO; N];
        for i in 0..self.count {
            for (block, p) in self.operator[i].iter().zip(impulse).take(self.count) {
                out[i] += *block * *p;
            }
        }
        out
    }
}

/// What each contact does by the hypothesis that was chosen.
pub(super) fn modes<const N: usize>(solution: &Solution<N>) -> [Mode; N] {
    solution.guess.map(|g| g.mode)
}
