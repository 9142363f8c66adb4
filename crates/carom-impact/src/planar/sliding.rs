//! Two contacts whose slips are known: the rate problem by hand.
//!
//! The general enumeration says the same; here each hypothesis costs a few products, and only those that push are verified.

use super::answer::{Answer, Guess};
use super::equations::Equations;
use super::rate::{Load, RANK_TOLERANCE, SLACK_TOLERANCE};
use super::{Slip, Solution};

/// A contact that slips in a known direction.
#[derive(Clone, Copy)]
struct Slider {
    slip: Slip,
    base: f64,
    may_hold: bool,
}

impl<const N: usize, const M: usize> Equations<'_, N, M> {
    /// The answer for two contacts that both slip, or have no friction; `None` where there are others, one is at rest along its tangent, or
    /// the equations are singular.
    pub(super) fn solve_two_sliding(&self) -> Option<Answer<N>> {
        let problem = self.problem;
        if problem.count != 2 {
            return None;
        }
        let sliders = [self.slider(0)?, self.slider(1)?];
        // Normal response to normal rates, friction included, and what the base loads leave to be cancelled.
        let response = [0, 1].map(|i| [0, 1].map(|j| self.normal(j, sliders[j].slip)[i][1]));
        let drive = [0, 1].map(|i: usize| {
            problem.drive[i][1] + response[i][0] * sliders[0].base + response[i][1] * sliders[1].base
        });
        let [[a, b], [c, d]] = response;
        let determinant = a * d - b * c;
        let largest = a.abs().max(b.abs()).max(c.abs()).max(d.abs());
        if determinant.abs() <= RANK_TOLERANCE * largest * largest || a == 0.0 || d == 0.0 {
            return None;
        }
        let mut answer = Answer { solutions: [None; 4], count: 0 };
        let scale = problem.scale();
        for holds in [[false, false], [true, false], [false, true], [true, true]] {
            if (0..2).any(|i| holds[i] && !sliders[i].may_hold) {
                continue;
            }
            let excess = match holds {
                [false, false] => [0.0, 0.0],
                [true, false] => [-drive[0] / a, 0.0],
                [false, true] => [0.0, -drive[1] / d],
                [true, true] => {
                    [(drive[1] * b - drive[0] * d) / determinant, (drive[0] * c - drive[1] * a) / determinant]
                }
            };
            if let Some(solution) = self.verified(&sliders, holds, excess) {
                answer.keep(solution, 2, scale);
            }
        }
        Some(answer)
    }

    fn slider(&self, i: usize) -> Option<Slider> {
        let known = self.problem.slip[i] != 0.0 || self.problem.friction[i] == 0.0;
        if !known || self.problem.never_slides(i) {
            return None;
        }
        let slip = if self.problem.slip[i] < 0.0 { Slip::Backward } else { Slip::Forward };
        let base = self.problem.base(i);
        Some(Slider { slip, base, may_hold: matches!(self.problem.load[i], Load::Touching(_)) })
    }

    fn verified(&self, sliders: &[Slider; 2], holds: [bool; 2], excess: [f64; 2]) -> Option<Solution<N>> {
        let total = sliders[0].base + sliders[1].base + excess[0].abs() + excess[1].abs();
        // Friction only adds to what the slack is measured against: verification is the judge of what is near zero.
        let most = 1.0 + self.problem.friction[0].max(self.problem.friction[1]);
        if excess.iter().any(|x| *x < -SLACK_TOLERANCE * 2.0 * most * total) {
            return None;
        }
        let mut guess = [Guess { holds: false, slip: Slip::Open }; N];
        let mut rates = [[0.0; 2]; N];
        for i in 0..2 {
            let rate = sliders[i].base + excess[i];
            if holds[i] || sliders[i].base > 0.0 {
                guess[i] = Guess { holds: holds[i], slip: sliders[i].slip };
                rates[i] = [sliders[i].slip.pull(self.problem.friction[i]) * rate, rate];
            }
        }
        self.verify(&guess, rates, false).ok()
    }
}
