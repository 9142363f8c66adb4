//! Rounds of stages that repeat each other as they are.
//!
//! Where every stage of a round needs the impulses that it needed a round before, k rounds more add `k d` to the impulses and `k W d` to
//! the velocities, d being the impulses of the last round: small slips stop and start again in turn while a large approach shrinks by a
//! little each time. They are passed over up to the event that ends them: a velocity that comes to 0, or restitution that is used up.
//!
//! Where `W d = 0` the load goes in a circle: the round leads back to the velocities that it came from. In restitution that ends when what
//! is to be returned is used up; in compression it never does. (Bodies that were free before cannot do the latter: a round of compression
//! takes energy, and the same velocities have the same. Obstacles that close in on a body can.)

use super::accumulation::{History, LONGEST_ROUND, Mark, difference};
use super::walk::Walk;
use crate::ImpactError;
use crate::tolerance::{ADDED_ROUNDING, PASSED_OVER, SAME_IMPULSE, SAME_PLACE};

/// Rounds that are left to be walked before the event.
const LEFT: f64 = 2.0;

/// A round that does what the one before did.
struct Round<const N: usize> {
    /// How many stages it has.
    stages: usize,
    /// What it adds to every impulse, and the work of that.
    impulse: [[f64; 2]; N],
    work: [[f64; 2]; N],
    /// Which velocities it changes by more than rounding.
    moves: [[bool; 2]; N],
    /// By which fraction of the largest impulse the two rounds differ.
    unlike: f64,
}

impl<const N: usize> History<N> {
    /// The shortest round that ends here and repeats the one before.
    fn repeated(&self) -> Option<Round<N>> {
        (1..=LONGEST_ROUND).find_map(|stages| self.repeated_after(stages))
    }

    fn repeated_after(&self, stages: usize) -> Option<Round<N>> {
        let [a, b, c] = self.rounds(stages)?;
        let (before, now) = (difference(&b.at, &a.at), difference(&c.at, &b.at));
        let last = self.marks.len();
        let [impulse_before, impulse] =
            [last - 2 * stages, last - stages].map(|first| self.impulse(first, stages));
        let off = apart(&now.velocity, &before.velocity);
        let unlike = apart(&impulse, &impulse_before) / largest(&impulse_before);
        let moved = SAME_PLACE * largest(&c.at.velocity) + ADDED_ROUNDING * c.added;
        let same = off <= moved && unlike <= SAME_IMPULSE;
        let work = std::array::from_fn(|i| std::array::from_fn(|axis| c.work[i][axis] - b.work[i][axis]));
        let moves = now.velocity.map(|u| u.map(|u| u.abs() > moved));
        same.then_some(Round { stages, impulse, work, moves, unlike })
    }

    /// Impulses of so many stages.
    fn impulse(&self, first: usize, stages: usize) -> [[f64; 2]; N] {
        let mut sum = [[0.0; 2]; N];
        for mark in &self.marks[first..first + stages] {
            for (sum, step) in sum.iter_mut().flatten().zip(mark.step.iter().flatten()) {
                *sum += step;
            }
        }
        sum
    }
}

fn largest<const N: usize>(of: &[[f64; 2]; N]) -> f64 {
    of.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// The largest difference.
fn apart<const N: usize>(a: &[[f64; 2]; N], b: &[[f64; 2]; N]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()))
}

impl<const N: usize, const M: usize> Walk<'_, N, M> {
    /// Passes over rounds that do what the last one did; false where there are none.
    ///
    /// # Errors
    /// [`ImpactError::Circling`] where they lead back to the same velocities and nothing ends them.
    pub(super) fn go_round(&mut self) -> Result<bool, ImpactError> {
        let Some(round) = self.history.repeated() else {
            return Ok(false);
        };
        let drift = self.drift(&round);
        let until_event = self.rounds_until_event(round.stages, &drift);
        let striking = self.clock.striking;
        let growth = drift[striking][1] * round.impulse[striking][1];
        let before = self.history.marks[self.history.marks.len() - 1 - round.stages].clock;
        let rise = [self.normal(striking), drift[striking][1]];
        let until_end = self.clock.rounds_left(&before, growth, rise);
        let circles = drift.iter().flatten().all(|u| *u == 0.0);
        if circles && !until_end.is_finite() {
            return Err(ImpactError::Circling { stages: round.stages });
        }
        // What changes from round to round adds up; in a circle it is rounding.
        let alike = if circles { f64::INFINITY } else { PASSED_OVER / (round.unlike + 4.0 * f64::EPSILON) };
        let passed = (until_event.min(until_end) - LEFT).min(alike).floor();
        if passed < 1.0 {
            return Ok(false);
        }
        self.pass(passed, &round, &drift);
        self.clock.pass(passed, &before, growth);
        Ok(true)
    }

    /// What a round does to the velocities, from its impulses: their digits are not lost beside large velocities. 0 where it is rounding.
    fn drift(&self, round: &Round<N>) -> [[f64; 2]; N] {
        std::array::from_fn(|i| {
            std::array::from_fn(|axis| {
                if !round.moves[i][axis] {
                    return 0.0;
                }
                let row = self.set.operator[i].iter().zip(&round.impulse);
                row.map(|(b, [q, p])| [b.tt * q + b.tn * p, b.nt * q + b.nn * p][axis]).sum()
            })
        })
    }

    /// How often this may be added to the velocities of the last round before one of them comes to 0.
    fn rounds_until_event(&self, stages: usize, drift: &[[f64; 2]; N]) -> f64 {
        let last: &[Mark<N>] = &self.history.marks[self.history.marks.len() - stages..];
        let velocities = last.iter().flat_map(|mark| mark.at.velocity.iter().flatten());
        let pairs = velocities.zip(std::iter::repeat_n(drift, stages).flatten().flatten());
        let shrinks = pairs.filter(|(u, by)| **u * **by < 0.0);
        shrinks.map(|(u, by)| -u / by).fold(f64::INFINITY, f64::min)
    }

    fn pass(&mut self, rounds: f64, round: &Round<N>, drift: &[[f64; 2]; N]) {
        for i in self.contacts() {
            for axis in 0..2 {
                let (p, u) = (round.impulse[i][axis], drift[i][axis]);
                // The work of each round differs from that of the one before by u p.
                let work = rounds * (round.work[i][axis] + 0.5 * (rounds + 1.0) * u * p);
                self.now.velocity[i][axis] += rounds * u;
                self.now.impulse[i][axis] += rounds * p;
                // What is passed over may be part of a longer round.
                self.step[i][axis] += rounds * p;
                self.work[i][axis] += work;
                self.work_terms += work.abs();
                self.added += self.largest_response * (rounds * p).abs();
            }
        }
    }
}
