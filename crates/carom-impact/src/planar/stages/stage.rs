//! One straight stage: how fast velocities change, which event ends it, and the step to there.

use super::staged::Stage;
use super::walk::Walk;
use crate::Phase;
use crate::planar::contacts::names::Slip;
use crate::planar::contacts::names::StageEnd;
use crate::planar::rates::answer::Solution;
use crate::tolerance::STAGE_ZERO;

/// The next event of a straight stage.
pub(super) struct Step {
    pub(in crate::planar) length: f64,
    pub(in crate::planar) why: StageEnd,
}

/// Change of each velocity per unit of the stage, exactly zero where the hypothesis says so.
pub(in crate::planar) fn change<const N: usize>(
    chosen: &Solution<N>,
    drive: &[[f64; 2]; N],
) -> [[f64; 2]; N] {
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

impl<const N: usize, const M: usize> Walk<'_, N, M> {
    /// A touching contact that opens, but for the slack that a hypothesis is allowed, does not sink in by it. Not so the
    /// `clocks`, which friction may drive in.
    pub(super) fn kept_out(
        &self,
        mut change: [[f64; 2]; N],
        chosen: &Solution<N>,
        clocks: Option<&[bool; N]>,
    ) -> [[f64; 2]; N] {
        for i in self.contacts() {
            if self.normal(i) == 0.0 && !chosen.guess[i].holds && !clocks.is_some_and(|clocks| clocks[i]) {
                change[i][1] = change[i][1].max(0.0);
            }
        }
        change
    }

    /// The first of: a slip stops, an open contact closes, `end`.
    pub(super) fn next_event(&self, chosen: &Solution<N>, change: &[[f64; 2]; N], end: Step) -> Step {
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

    /// Goes to the event.
    pub(super) fn advance(
        &mut self,
        phase: Phase,
        chosen: &Solution<N>,
        change: &[[f64; 2]; N],
        step: &Step,
    ) -> Stage<N> {
        let start = self.now;
        for i in self.contacts() {
            let by = change[i].map(|d| d * step.length);
            self.go(i, by, chosen.rates[i].map(|r| r * step.length));
        }
        match step.why {
            StageEnd::SlipStops(i) => self.now.velocity[i][0] = 0.0,
            StageEnd::Closes(i) => self.now.velocity[i][1] = 0.0,
            StageEnd::CompressionEnds | StageEnd::RestitutionEnds => {}
        }
        let slip = std::array::from_fn(|i| chosen.guess[i].slip);
        self.present = Some(slip);
        Stage { phase, slip, start, end: self.now, ended_by: step.why }
    }

    /// Moves contact i by a change of its velocities and impulses, and books their work.
    fn go(&mut self, i: usize, by: [f64; 2], impulse: [f64; 2]) {
        for axis in 0..2 {
            let u = self.now.velocity[i][axis];
            let sum = u + by[axis];
            // Contacts of one face stop and close together: rounding must not tell them apart.
            let zero = sum.abs() <= STAGE_ZERO * (u.abs() + by[axis].abs()).max(self.fastest);
            let v = if zero { 0.0 } else { sum };
            self.book(i, axis, v, impulse[axis]);
        }
    }

    /// Gives a velocity of contact i its value at the end of a straight piece, and books the impulse of that piece and its work.
    pub(super) fn book(&mut self, i: usize, axis: usize, velocity: f64, impulse: f64) {
        let work = 0.5 * (self.now.velocity[i][axis] + velocity) * impulse;
        self.now.velocity[i][axis] = velocity;
        self.now.impulse[i][axis] += impulse;
        self.step[i][axis] += impulse;
        self.work[i][axis] += work;
        self.work_terms += work.abs();
        self.added += self.largest_response * impulse.abs();
        if axis == 1 && i == self.clock.striking {
            self.clock.return_work(work);
        }
    }
}
