//! One or two contacts: the rate problem by hand.
//!
//! The general elimination says the same. Of two contacts the second contact's reaction is found once for each of its possibilities and taken into the
//! first contact's response, so that a hypothesis costs a few products. What rounding could blur is left to the general elimination.

use super::answer::{Answer, Guess};
use super::equations::Equations;
use super::rate::RateProblem;
use crate::planar::contacts::names::Slip;
use crate::planar::contacts::set::Block;
use crate::tolerance::CLEAR;

/// Rows and columns are (t, n).
type Matrix = [[f64; 2]; 2];

/// A contact's response to its own rates, and the sums of the magnitudes of its terms.
struct Response {
    matrix: Matrix,
    terms: Matrix,
}

/// What a contact does by a hypothesis: its rates are `base − stiffness · w`, w being its response to all else.
struct Reaction {
    base: [f64; 2],
    stiffness: Matrix,
}

/// Both contacts, the second one reacting by one of its possibilities.
struct Coupled {
    second: Reaction,
    /// Response of the second contact to its base and the drive, and to the first one's rates.
    drive_of_second: [f64; 2],
    to_second: Matrix,
    /// The first contact as it responds together with the second one.
    first: Response,
    drive_of_first: [f64; 2],
}

impl<const N: usize, const M: usize> RateProblem<'_, N, M> {
    /// The answer for one contact.
    pub(super) fn solve_one(&self) -> Answer<N> {
        let scale = self.scale();
        let mut answer = Answer::NONE;
        let mut guess = [Guess { holds: false, slip: Slip::Open }; N];
        let response = Response::of(matrix(&self.operator[0][0]));
        for first in self.options(0) {
            guess[0] = first;
            let solution = match response.reaction(self, 0, first) {
                Some(reaction) => {
                    let mut rates = [[0.0; 2]; N];
                    rates[0] = reaction.rates(moved(self.drive[0], &response.matrix, reaction.base));
                    self.tested(&guess, rates, false)
                }
                None => Equations::of(self).solution(&guess),
            };
            if let Some(solution) = solution {
                answer.keep(solution, 1, scale);
            }
        }
        answer
    }

    /// The answer for two contacts.
    pub(super) fn solve_two(&self) -> Answer<N> {
        let scale = self.scale();
        let mut answer = Answer::NONE;
        let mut guess = [Guess { holds: false, slip: Slip::Open }; N];
        let firsts = self.options(0);
        for second in self.options(1) {
            guess[1] = second;
            let coupled = Coupled::new(self, second);
            for first in firsts.clone() {
                guess[0] = first;
                let solution = match coupled.as_ref().and_then(|c| c.rates(self, first)) {
                    Some(pair) => {
                        let mut rates = [[0.0; 2]; N];
                        rates[..2].copy_from_slice(&pair);
                        self.tested(&guess, rates, false)
                    }
                    None => Equations::of(self).solution(&guess),
                };
                if let Some(solution) = solution {
                    answer.keep(solution, 2, scale);
                }
            }
        }
        answer
    }
}

impl Coupled {
    /// `None` where rounding could blur the second contact's reaction.
    fn new<const N: usize, const M: usize>(problem: &RateProblem<'_, N, M>, second: Guess) -> Option<Self> {
        let block = |i: usize, j: usize| matrix(&problem.operator[i][j]);
        let second = Response::of(block(1, 1)).reaction(problem, 1, second)?;
        let (to_first, to_second) = (block(0, 1), block(1, 0));
        let drive_of_second = moved(problem.drive[1], &block(1, 1), second.base);
        let drive_of_first = moved(problem.drive[0], &to_first, second.rates(drive_of_second));
        let back = product(&to_first, &product(&second.stiffness, &to_second));
        let first = Response::of(block(0, 0)).less(&back);
        Some(Self { second, drive_of_second, to_second, first, drive_of_first })
    }

    /// The rates of both contacts; `None` where rounding could blur them.
    fn rates<const N: usize, const M: usize>(
        &self,
        problem: &RateProblem<'_, N, M>,
        first: Guess,
    ) -> Option<[[f64; 2]; 2]> {
        let reaction = self.first.reaction(problem, 0, first)?;
        let first = reaction.rates(moved(self.drive_of_first, &self.first.matrix, reaction.base));
        Some([first, self.second.rates(moved(self.drive_of_second, &self.to_second, first))])
    }
}

impl Response {
    fn of(matrix: Matrix) -> Self {
        Self { matrix, terms: matrix.map(|row| row.map(f64::abs)) }
    }

    fn less(mut self, other: &Matrix) -> Self {
        for (i, row) in other.iter().enumerate() {
            for (j, v) in row.iter().enumerate() {
                self.matrix[i][j] -= v;
                self.terms[i][j] += v.abs();
            }
        }
        self
    }

    /// The reaction of contact i that responds like this; `None` where rounding could blur it.
    fn reaction<const N: usize, const M: usize>(
        &self,
        problem: &RateProblem<'_, N, M>,
        i: usize,
        guess: Guess,
    ) -> Option<Reaction> {
        let [[tt, tn], [nt, nn]] = self.matrix;
        let [[tt_terms, tn_terms], [nt_terms, nn_terms]] = self.terms;
        let sticks = guess.slip == Slip::Sticks;
        let pull = guess.slip.pull(problem.friction[i]);
        let (stiffness, clear) = match (sticks, guess.holds) {
            (true, true) => {
                let determinant = tt * nn - tn * nt;
                let terms = tt_terms * nn_terms + tn_terms * nt_terms;
                let inverse = [[nn / determinant, -tn / determinant], [-nt / determinant, tt / determinant]];
                (inverse, determinant.abs() > CLEAR * terms)
            }
            (true, false) => ([[1.0 / tt, 0.0], [0.0, 0.0]], tt.abs() > CLEAR * tt_terms),
            (false, true) => {
                let along = nn + nt * pull;
                let terms = nn_terms + (nt_terms * pull).abs();
                ([[0.0, pull / along], [0.0, 1.0 / along]], along.abs() > CLEAR * terms)
            }
            (false, false) => ([[0.0; 2]; 2], true),
        };
        let base = if guess.is_loaded() { problem.base(i) } else { 0.0 };
        clear.then_some(Reaction { base: [pull * base, base], stiffness })
    }
}

impl Reaction {
    fn rates(&self, response: [f64; 2]) -> [f64; 2] {
        let [[a, b], [c, d]] = self.stiffness;
        let [t, n] = response;
        [self.base[0] - (a * t + b * n), self.base[1] - (c * t + d * n)]
    }
}

fn matrix(b: &Block) -> Matrix {
    [[b.tt, b.tn], [b.nt, b.nn]]
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| [0, 1].map(|j| row[0] * b[0][j] + row[1] * b[1][j]))
}

/// What a response becomes with these rates.
fn moved(from: [f64; 2], by: &Matrix, rates: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|i| from[i] + (by[i][0] * rates[0] + by[i][1] * rates[1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Load;
    use crate::planar::contacts::set::ContactSet2;
    use crate::planar::contacts::set::Touch;
    use carom_num::Vec2;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    /// Responses against the largest: by hand three digits may be lost, and nearly singular contacts lose others.
    const SAME: f64 = 1e-9;

    #[test]
    fn it_finds_what_elimination_finds() {
        let mut several = [0; 2];
        for case in 0..20_000_u32 {
            let mut rng = Pcg64::seed_from_u64(u64::from(case));
            let numbers: [f64; 16] = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
            let random = |k: usize| numbers[k];
            let touch = |k: usize| Touch {
                arm: Vec2::new(random(k), random(k + 1)),
                normal: Vec2::at_angle(3.2 * random(k + 2)),
                friction: if case % 7 == 0 { 0.0 } else { 1.0 + random(k + 3) },
                restitution: 0.0,
            };
            let velocity = Vec2::new(random(8), random(9));
            let touches = [touch(0), touch(4)];
            let set = ContactSet2::of_free_body(1.0, 0.6 + 0.5 * random(10), velocity, random(11), &touches)
                .unwrap();
            // Slips that are given or not, contacts that are loaded or not.
            let slip = [12, 13].map(|k| random(k).max(0.0));
            let load = [14, 15].map(|k| match 1.0 + random(k) {
                x if x < 1.0 => Load::Touching(0.0),
                x if x < 1.7 => Load::Touching(x),
                x => Load::Prescribed(x),
            });
            let drive = std::array::from_fn(|i| [set.slip[i], set.normal[i]]);
            let (operator, friction) = (&set.operator, &set.friction);
            for count in [1, 2] {
                let problem = RateProblem::<2, 4> { count, operator, friction, drive, slip, load };
                let by_hand = if count == 1 { problem.solve_one() } else { problem.solve_two() };
                let by_elimination = problem.solve_by_elimination();
                assert_eq!(by_hand.count, by_elimination.count, "{case}: {by_hand:?} {by_elimination:?}");
                several[count - 1] += usize::from(by_hand.count > 1);
                for (a, b) in by_hand.iter().zip(by_elimination.iter()) {
                    let largest = |m: f64, w: &f64| m.max(w.abs());
                    let largest = a.response[..count].iter().flatten().fold(problem.scale(), largest);
                    let mut pairs = a.response[..count].iter().flatten().zip(b.response.iter().flatten());
                    assert!(pairs.all(|(a, b)| (a - b).abs() <= SAME * largest), "{case}: {a:?} {b:?}");
                }
            }
        }
        assert!(several.iter().all(|n| *n > 20), "{several:?} have several answers");
    }
}
