//! The inequalities of a hypothesis whose rates are known.

use super::answer::{Broken, Condition, Guess, Solution};
use super::rate::RateProblem;
use crate::Load;
use crate::planar::contacts::names::Slip;
use crate::tolerance::{CLEARLY_BROKEN, SLACK_TOLERANCE};

/// A number (t, n) for every contact.
type PerContact<const N: usize> = [[f64; 2]; N];

impl<const N: usize, const M: usize> RateProblem<'_, N, M> {
    /// As [`RateProblem::verify`], but asks first the inequalities of the rates alone: most hypotheses fail there.
    pub(in crate::planar) fn tested(
        &self,
        guess: &[Guess; N],
        rates: PerContact<N>,
        indeterminate: bool,
    ) -> Option<Solution<N>> {
        if self.is_driven_together(guess) || self.pulls_or_slips(guess, &rates) {
            return None;
        }
        self.verify(guess, rates, indeterminate).ok()
    }

    /// The inequality of the motion that is broken most, where one is broken clearly: what opens must not approach, and
    /// friction acts against the slip it starts.
    pub(super) fn moves_wrongly(&self, guess: &[Guess; N], rates: &PerContact<N>) -> Option<Broken> {
        let (response, terms) = self.response(rates);
        let mut worst = Broken { share: CLEARLY_BROKEN, ..Broken::UNSOLVABLE };
        for i in 0..self.count {
            let ([t, n], [terms_t, terms_n]) = (response[i], terms[i]);
            let opens = !guess[i].holds && matches!(self.load[i], Load::Touching(_));
            let (condition, slack, scale) = match guess[i].slip {
                _ if opens && n < 0.0 => (Condition::Opens(i), n, terms_n),
                Slip::Forward if self.starts(i) => (Condition::StartsForward(i), t, terms_t),
                Slip::Backward if self.starts(i) => (Condition::StartsBackward(i), -t, terms_t),
                _ => continue,
            };
            if -slack > worst.share * scale {
                worst = Broken { condition, amount: -slack, share: -slack / scale };
            }
        }
        (worst.condition != Condition::Solvable).then_some(worst)
    }

    /// True where no contact transmits anything, but the drive closes one.
    fn is_driven_together(&self, guess: &[Guess; N]) -> bool {
        let closes = |i: usize| matches!(self.load[i], Load::Touching(_)) && self.drive[i][1] < 0.0;
        let all_open = guess[..self.count].iter().all(|g| g.slip == Slip::Open);
        all_open && (0..self.count).any(closes)
    }

    /// The inequalities that rates alone can break.
    fn pulls_or_slips(&self, guess: &[Guess; N], rates: &PerContact<N>) -> bool {
        let total = self.total(rates);
        (0..self.count).any(|i| {
            let ([q, r], base) = (rates[i], self.base(i));
            let pulls = guess[i].holds && r - base < -SLACK_TOLERANCE * total;
            let beyond = guess[i].slip == Slip::Sticks && !self.never_slides(i) && {
                let (slack, scale) = self.within_cone(i, [q, r], total);
                slack < -SLACK_TOLERANCE * scale
            };
            pulls || beyond
        })
    }

    /// What friction could give more than it does, and both added up. Only a push has a cone: a contact that pulls breaks another inequality.
    /// Rates that are rounding of all the others are none.
    fn within_cone(&self, i: usize, [q, r]: [f64; 2], total: f64) -> (f64, f64) {
        let rounding = SLACK_TOLERANCE * total;
        if r < -rounding || (r < 0.0 && q.abs() <= rounding) {
            return (0.0, 0.0);
        }
        let bound = self.friction[i] * r.max(0.0);
        (bound - q.abs(), bound.abs() + q.abs())
    }

    /// All rates and base loads, added up without their signs: what a push is measured against.
    fn total(&self, rates: &PerContact<N>) -> f64 {
        rates.iter().enumerate().fold(0.0, |m: f64, (i, [q, r])| m + q.abs() + r.abs() + self.base(i))
    }

    /// Asks every inequality of a hypothesis.
    ///
    /// A slack is told as a share of the magnitudes of all that it is the difference of, so that it lies in −1…1 whatever the inequality: a
    /// push against all rates and loads, a friction against itself and its bound, a velocity against its terms.
    pub(super) fn verify(
        &self,
        guess: &[Guess; N],
        rates: PerContact<N>,
        indeterminate: bool,
    ) -> Result<Solution<N>, Broken> {
        let (response, terms) = self.response(&rates);
        let total = self.total(&rates);
        // The inequality with the least scaled slack: condition, slack, scaled slack.
        let mut worst = (Condition::Solvable, f64::INFINITY, f64::INFINITY);
        let mut check = |condition: Condition, slack: f64, scale: f64| {
            let scaled = if scale == 0.0 { 0.0 } else { slack / scale };
            if scaled < worst.2 || scaled.is_nan() {
                worst = (condition, slack, scaled);
            }
        };
        for i in 0..self.count {
            let ([q, r], g) = (rates[i], guess[i]);
            if g.holds {
                check(Condition::Pushes(i), r - self.base(i), total);
            } else if matches!(self.load[i], Load::Touching(_)) {
                check(Condition::Opens(i), response[i][1], terms[i][1]);
            }
            match g.slip {
                Slip::Sticks if self.never_slides(i) => {}
                Slip::Sticks => {
                    let (slack, scale) = self.within_cone(i, [q, r], total);
                    check(Condition::WithinCone(i), slack, scale);
                }
                Slip::Forward if self.starts(i) => {
                    check(Condition::StartsForward(i), response[i][0], terms[i][0])
                }
                Slip::Backward if self.starts(i) => {
                    check(Condition::StartsBackward(i), -response[i][0], terms[i][0])
                }
                _ => {}
            }
        }
        let (margin_of, slack, margin) = worst;
        let sound = response.iter().flatten().sum::<f64>().is_finite();
        if sound && margin >= -SLACK_TOLERANCE {
            let rates = clip(rates);
            let guess = self.turned(guess, &response);
            Ok(Solution { guess, rates, response, margin, margin_of, indeterminate })
        } else {
            Err(Broken { condition: margin_of, amount: -slack, share: -margin })
        }
    }

    /// The hypothesis with the slips that really start: without friction a contact slips the way it is moved, whatever was assumed.
    fn turned(&self, guess: &[Guess; N], response: &PerContact<N>) -> [Guess; N] {
        let mut guess = *guess;
        for (i, g) in guess.iter_mut().enumerate().take(self.count) {
            if g.slip == Slip::Forward && self.is_smooth_at_rest(i) && response[i][0] < 0.0 {
                g.slip = Slip::Backward;
            }
        }
        guess
    }

    fn is_smooth_at_rest(&self, i: usize) -> bool {
        self.slip[i] == 0.0 && self.friction[i] == 0.0
    }

    /// True where a slip would start from rest and its direction is a matter of the solution.
    fn starts(&self, i: usize) -> bool {
        self.slip[i] == 0.0 && self.friction[i] > 0.0
    }

    /// `drive + W (q, r)` of every contact, and the sums of the magnitudes of its terms.
    pub(in crate::planar) fn response(&self, rates: &PerContact<N>) -> (PerContact<N>, PerContact<N>) {
        let mut response = self.drive;
        let mut terms = response.map(|drive| drive.map(f64::abs));
        for i in 0..self.count {
            let ([w_t, w_n], [terms_t, terms_n]) = (&mut response[i], &mut terms[i]);
            for (b, [q, r]) in self.operator[i].iter().zip(rates).take(self.count) {
                *w_t += b.tt * q + b.tn * r;
                *w_n += b.nt * q + b.nn * r;
                *terms_t += (b.tt * q).abs() + (b.tn * r).abs();
                *terms_n += (b.nt * q).abs() + (b.nn * r).abs();
            }
        }
        (response, terms)
    }
}

/// Rounding must not leave a normal rate that pulls.
fn clip<const N: usize>(mut rates: PerContact<N>) -> PerContact<N> {
    for rate in &mut rates {
        if rate[1] < 0.0 {
            *rate = [0.0; 2];
        }
    }
    rates
}
