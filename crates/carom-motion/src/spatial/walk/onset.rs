//! The smooth start of a slip, and other slips so slow that friction turns them at once.
//!
//! Where a support that stuck comes to the edge of its cone its slip starts with no acceleration: it grows as the square of the time, and its direction is at every
//! instant the one in which friction lets it grow. The equations are then stiff, and at the start the direction of friction is that of the slip which only
//! comes: an implicit step asks for it where the slip is.

use super::motion::Motion;
use super::sliding::{DIMENSIONS, SLIP, Sliding, Slowing, Vector, WAY, WORK, YAW};
use crate::tolerance::{
    EASY_STEP, FORCE_DIFFERENCE, IMPLICIT_EVENT_TOLERANCE, LEAST_SLIP_GROWTH, SHORTEST_IMPLICIT_STEP,
    SLIP_STARTED, SLIP_TURN,
};
use carom_num::Vec3;
use carom_num::ode8::Step;
use carom_num::radau::{self, NODES, STAGES, Setup, Stages};

/// A slip whose speed changes slower than this fraction of what friction turns it by is followed implicitly, as long as it is slow.
const SLOW_CHANGE: f64 = 0.2;
/// A slip is slow that friction could turn or stop within this fraction of the world's time.
const SLOW: f64 = 0.02;
/// Where a body touches it is lighter than all of it, as it turns away: by no more than so many times, unless it is about to jam.
const LIGHTEST: f64 = 20.0;
/// Slips that supports of other planes leave less of a turn than this cannot turn.
const LEAST_FREEDOM: f64 = 1e-3;
/// The places of the spin, the slip and the spin about the normal in what is integrated.
const MOVES: [usize; 7] = [4, 5, 6, SLIP, SLIP + 1, SLIP + 2, YAW];
/// The longest implicit step, in the world's time.
const LONGEST: f64 = 2.0;

impl Sliding<'_> {
    /// True where explicit steps would be far shorter than what the motion needs: where a slip starts, and where friction turns a slow one, or one on its way
    /// to zero, much faster than it changes its speed.
    ///
    /// A slip u whose direction is off by δ from the one that friction lets it keep has `δ̇ = −(k/u) δ`, and `u̇` is its change.
    pub(super) fn turns_at_once(&self, y: &Vector, rate: &Vector) -> bool {
        self.slowing(y, rate).any(|slip| {
            let most = slip.friction * slip.normal.max(0.0) / self.mass();
            if most <= 0.0 || slip.speed == 0.0 {
                return most > 0.0;
            }
            if slip.speed >= SLOW * LIGHTEST * most * self.scales().time {
                return false;
            }
            let back = self.turned_back(y, rate, &slip);
            let size = most.max(back);
            back > 0.0
                && slip.change.abs() < SLOW_CHANGE * size
                && slip.speed < SLOW * size * self.scales().time
        })
    }

    /// By what a slip that is turned is turned back, per radian \[m/s²\].
    fn turned_back(&self, y: &Vector, rate: &Vector, slip: &Slowing) -> f64 {
        if self.apart {
            return self.turned_back_apart(y, rate, slip);
        }
        let [east, north, up] = self.moment(y).axes;
        let aside = slip.aside * (SLIP_TURN * slip.speed);
        let mut turned = *y;
        turned[SLIP] += aside.dot(east);
        turned[SLIP + 1] += aside.dot(north);
        let then = self.rate(&turned);
        let by = |k: usize| then[k] - rate[k];
        let foot = east * by(SLIP) + north * by(SLIP + 1);
        let change = foot + up.cross(slip.from_foot) * by(YAW);
        slip.change - change.dot(slip.aside) / SLIP_TURN
    }

    /// The same where supports of several planes leave a slip less freedom to turn, or none: then nothing turns it back.
    fn turned_back_apart(&self, y: &Vector, rate: &Vector, slip: &Slowing) -> f64 {
        let size = SLIP_TURN * slip.speed;
        let now = self.moment(y);
        let (velocity, spin) = self.admissible(&now, (slip.aside * size, Vec3::ZERO), &[]);
        let arm = slip.from_foot + now.foot;
        let share = (velocity + spin.cross(arm)).dot(slip.aside) / size;
        if share < LEAST_FREEDOM {
            return 0.0;
        }
        let then = self.rate(&self.changed(y, velocity, spin, &now));
        let by = |k: usize| then[k] - rate[k];
        let foot = now.axes[0] * by(SLIP) + now.axes[1] * by(SLIP + 1) + now.axes[2] * by(SLIP + 2);
        let change = foot + Vec3::new(by(4), by(5), by(6)).cross(slip.from_foot);
        slip.change - change.dot(slip.aside) / (SLIP_TURN * share)
    }

    /// An implicit step within the tolerance, and the length of the next; `None` where none is found.
    pub(super) fn implicit_step(
        &self,
        (y, rate): (&Vector, &Vector),
        (hint, most): (f64, f64),
        tolerance: &Vector,
    ) -> Option<(Step<Vector>, f64)> {
        let time = self.scales().time;
        let mut length = hint.clamp(SHORTEST_IMPLICIT_STEP * time, LONGEST * time).min(most);
        while length >= (SHORTEST_IMPLICIT_STEP * time).min(most) {
            if let Some(whole) = self.implicit(y, &self.guess(y, rate, length), length, tolerance)
                && let Some(step) = self.collocated((y, rate), &whole, length)
                && let Some([middle, end]) = self.in_halves(y, &step, tolerance)
            {
                let apart = |a: &Vector, b: &Vector| {
                    (0..a.len()).map(|d| (a[d] - b[d]).abs() / tolerance[d]).fold(0.0, f64::max)
                };
                let last = whole[STAGES - 1];
                // Events are searched on what is between the ends.
                let error = apart(&last, &end).max(apart(&step.at(0.5), &middle));
                let sound = last.iter().chain(&end).chain(&self.rate(&end)).all(|v| v.is_finite());
                if error <= WITHIN && sound {
                    let next = if error < EASY_STEP * WITHIN { 2.0 * length } else { length };
                    return Some((step, next));
                }
            }
            length *= 0.5;
        }
        None
    }

    /// The middle and the end of a step in two halves.
    fn in_halves(&self, y: &Vector, step: &Step<Vector>, tolerance: &Vector) -> Option<[Vector; 2]> {
        let length = 0.5 * step.length;
        let half = |from: &Vector, start: f64| {
            let near = NODES.map(|c| step.at(start + 0.5 * c));
            let guess = radau::rates_through(from, &near, length)?;
            Some(self.implicit(from, &guess, length, tolerance)?[STAGES - 1])
        };
        let middle = half(y, 0.0)?;
        Some([middle, half(&middle, 0.5)?])
    }

    /// The end of an implicit step of a length.
    pub(super) fn implicit_end(&self, y: &Vector, rate: &Vector, length: f64) -> Option<Vector> {
        let tolerance = self.tolerance(y, IMPLICIT_EVENT_TOLERANCE, 1.0 / self.scales().time);
        Some(self.implicit(y, &self.guess(y, rate, length), length, &tolerance)?[STAGES - 1])
    }

    fn implicit(
        &self,
        y: &Vector,
        guess: &Stages<DIMENSIONS>,
        length: f64,
        tolerance: &Vector,
    ) -> Option<Stages<DIMENSIONS>> {
        let difference = |y: &Vector| {
            let [own, others] = self.slowest(y).map(|speed| FORCE_DIFFERENCE * speed);
            let reach = self.scales().length;
            std::array::from_fn(|d| match d {
                // On several planes every part of the spin moves supports along one of them.
                4..=6 if self.apart => (FORCE_DIFFERENCE / self.scales().time).min(others / reach),
                4..=6 => FORCE_DIFFERENCE / self.scales().time,
                YAW => others / reach,
                d if (SLIP..WORK).contains(&d) => own.min(others),
                WAY..SLIP => FORCE_DIFFERENCE * reach,
                _ => FORCE_DIFFERENCE,
            })
        };
        let setup = Setup { rate: |y: &Vector| self.rate(y), difference, stiff: MOVES };
        radau::step::<DIMENSIONS, { MOVES.len() }, { STAGES * MOVES.len() }>(
            y, guess, length, tolerance, &setup,
        )
    }

    /// Guessed rates at the stages of a step: linear from those at the start to those a step later, with the slips that start on their way.
    fn guess(&self, y: &Vector, rate: &Vector, length: f64) -> Stages<DIMENSIONS> {
        let mut ahead: Vector = std::array::from_fn(|d| y[d] + length * rate[d]);
        let starting = self.starting(y);
        let Some(start) = starting else {
            let there = self.rate(&ahead);
            return NODES.map(|c| std::array::from_fn(|d| rate[d] + c * (there[d] - rate[d])));
        };
        let resting = self.resting(&self.moment(y));
        // Friction is asked for where the slips have started: how fast does not matter.
        if self.apart {
            ahead = self.projected(&ahead, resting);
            MOVES.into_iter().for_each(|d| ahead[d] += start[d] * SLIP_STARTED);
        } else {
            [SLIP, SLIP + 1, YAW].into_iter().for_each(|d| ahead[d] = y[d] + start[d] * SLIP_STARTED);
        }
        let there = self.rate(&ahead);
        // Both without what makes the slips grow, and how much that is.
        let [own, last] = [(y, rate), (&ahead, &there)].map(|(y, rate)| self.held_back(y, rate, resting));
        let reach = self.scales().length;
        let weight = |d: usize| if (SLIP..WORK).contains(&d) { 1.0 } else { reach * reach };
        let size: f64 = MOVES.iter().map(|d| start[*d] * start[*d] * weight(*d)).sum();
        let grown = |k: &Vector, held: &Vector| -> f64 {
            MOVES.iter().map(|d| start[*d] * (k[*d] - held[*d]) * weight(*d)).sum::<f64>() / size
        };
        let first = grown(rate, &own).max(0.0);
        let least = LEAST_SLIP_GROWTH * self.gravity_size() * length / self.scales().time;
        let more = (grown(&there, &last) - first).max(least);
        NODES.map(|c| {
            let mut guess: Vector = std::array::from_fn(|d| own[d] + c * (last[d] - own[d]));
            MOVES.into_iter().for_each(|d| guess[d] += start[d] * (first + c * more));
            guess
        })
    }

    /// The step through the stages. Where slips start, their direction at the very start is known from those alone.
    fn collocated(
        &self,
        start: (&Vector, &Vector),
        stages: &Stages<DIMENSIONS>,
        length: f64,
    ) -> Option<Step<Vector>> {
        let end = stages[STAGES - 1];
        let between = std::array::from_fn(|i| (NODES[i], stages[i]));
        let starts = !self.resting(&self.moment(start.0)).is_empty();
        let before = || radau::rate_before(&stages.map(|stage| self.rate(&stage)));
        let first = if starts { before() } else { *start.1 };
        Step::through((*start.0, first), &between, (end, self.rate(&end)), length)
    }
}

/// Two halves of an implicit step may differ from the whole by this many times the tolerance.
const WITHIN: f64 = 100.0;
