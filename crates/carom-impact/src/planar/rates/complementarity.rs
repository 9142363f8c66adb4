//! One solution of a rate problem of more contacts than can be examined, by complementary pivoting.
//!
//! The problem's laws as one linear complementarity problem: the excess of each contact against its normal rate of separation; where it
//! does not slip yet, forward and backward friction against the slip that starts, and the rate λ of that slip against what is left of the
//! friction cone; where it slips, friction is known. What pivoting finds is one vertex of the solutions; the hypothesis it belongs to then
//! goes through the same equations and inequalities as any other.
//!
//! Source: as of [`pivoting`](crate::planar::ends::pivoting).

use super::answer::{Answer, Guess, Solution};
use super::equations::Equations;
use super::rate::RateProblem;
use crate::Load;
use crate::planar::contacts::names::Slip;
use crate::tolerance::{PIVOTED_ZERO, SPECK};
use carom_num::lemke::lemke;

/// What an unknown stands for, with its contact.
#[derive(Clone, Copy, PartialEq)]
enum Unknown {
    /// Excess of the normal rate.
    Excess(usize),
    /// Friction forward (1) or backward (−1).
    Friction(usize, f64),
    /// Rate of the slip that starts.
    Slip(usize),
}

impl<const N: usize, const M: usize> RateProblem<'_, N, M> {
    /// A solution, if pivoting finds one; whether there are others is not examined.
    pub(super) fn solve_by_pivoting(&self) -> Answer<N> {
        let none = Answer { solutions: [None; 4], count: 0, examined: false };
        let Some(rates) = (self.count <= N).then(|| self.pivoted()).flatten() else { return none };
        let equations = Equations::of(self);
        // Contacts that touch without need of force keep what they touch: a vertex leaves many of them without any.
        let found = [true, false]
            .into_iter()
            .find_map(|keeps| equations.try_guess(&self.guess_of(&rates, keeps)).ok());
        let solutions: [Option<Solution<N>>; 4] = [found, None, None, None];
        Answer { solutions, count: usize::from(found.is_some()), examined: false }
    }

    fn unknowns(&self) -> Vec<Unknown> {
        let mut out = vec![];
        for i in 0..self.count {
            let touching = matches!(self.load[i], Load::Touching(_));
            if touching {
                out.push(Unknown::Excess(i));
            }
            if self.slip[i] == 0.0 && self.friction[i] > 0.0 && self.load[i] != Load::Absent {
                out.extend([Unknown::Friction(i, 1.0), Unknown::Friction(i, -1.0), Unknown::Slip(i)]);
            }
        }
        out
    }

    /// Known friction of a contact that slips, per unit of its normal rate.
    fn pull(&self, i: usize) -> f64 {
        if self.slip[i] == 0.0 { 0.0 } else { -self.slip[i].signum() * self.friction[i] }
    }

    /// Response (t, n) of contact i to a unit of an unknown.
    fn response_to(&self, i: usize, unknown: Unknown) -> [f64; 2] {
        match unknown {
            Unknown::Excess(j) => {
                let (b, pull) = (&self.operator[i][j], self.pull(j));
                [b.tn + b.tt * pull, b.nn + b.nt * pull]
            }
            Unknown::Friction(j, sign) => {
                let b = &self.operator[i][j];
                [sign * b.tt, sign * b.nt]
            }
            Unknown::Slip(_) => [0.0; 2],
        }
    }

    /// The rates (q, r) of a vertex of the solutions.
    fn pivoted(&self) -> Option<[[f64; 2]; N]> {
        let unknowns = self.unknowns();
        let (free, _) = self.response(&self.base_rates());
        // λ stands in both rows of friction and complementary to the cone's row (Stewart and Trinkle): where a slip starts,
        // friction acts against it and is all that the cone gives.
        let row = |of: Unknown| -> Vec<f64> {
            let entry = |by: &Unknown| match of {
                Unknown::Excess(i) => self.response_to(i, *by)[1],
                Unknown::Friction(i, sign) => {
                    let starts = f64::from(u8::from(*by == Unknown::Slip(i)));
                    sign * self.response_to(i, *by)[0] + starts
                }
                Unknown::Slip(i) => match *by {
                    Unknown::Excess(j) if j == i => self.friction[i],
                    Unknown::Friction(j, _) if j == i => -1.0,
                    _ => 0.0,
                },
            };
            unknowns.iter().map(entry).collect()
        };
        let constant = |of: &Unknown| match *of {
            Unknown::Excess(i) => free[i][1],
            Unknown::Friction(i, sign) => sign * free[i][0],
            Unknown::Slip(i) => self.friction[i] * self.base(i),
        };
        let matrix: Vec<Vec<f64>> = unknowns.iter().map(|u| row(*u)).collect();
        let q: Vec<f64> = unknowns.iter().map(constant).collect();
        let speck = SPECK * self.scale();
        let opened = || {
            let lift =
                |(u, q): (&Unknown, &f64)| if matches!(u, Unknown::Excess(_)) { q + speck } else { *q };
            lemke(&matrix, &unknowns.iter().zip(&q).map(lift).collect::<Vec<_>>())
        };
        // The lift is for problems at the edge of having a solution: one that has a solution keeps its numbers.
        let z = lemke(&matrix, &q).or_else(opened)?;
        let mut rates = self.base_rates();
        for (unknown, z) in unknowns.iter().zip(z) {
            match *unknown {
                Unknown::Excess(i) => {
                    rates[i][1] += z;
                    rates[i][0] += self.pull(i) * z;
                }
                Unknown::Friction(i, sign) => rates[i][0] += sign * z,
                Unknown::Slip(_) => {}
            }
        }
        Some(rates)
    }

    /// The rates without any excess.
    fn base_rates(&self) -> [[f64; 2]; N] {
        std::array::from_fn(|i| {
            if i < self.count { [self.pull(i) * self.base(i), self.base(i)] } else { [0.0; 2] }
        })
    }

    /// The hypothesis that rates belong to. `keeps`: a contact that neither pushes nor separates holds.
    fn guess_of(&self, rates: &[[f64; 2]; N], keeps: bool) -> [Guess; N] {
        let (rounding, (response, _)) = (PIVOTED_ZERO * self.scale(), self.response(rates));
        std::array::from_fn(|i| {
            if i >= self.count || self.load[i] == Load::Absent {
                return Guess { holds: false, slip: Slip::Open };
            }
            let [t, n] = response[i];
            let touching = matches!(self.load[i], Load::Touching(_));
            let pushes = rates[i][1] > self.base(i);
            let holds = touching && (pushes || (keeps && n.abs() <= rounding));
            let way = if self.slip[i] == 0.0 { t } else { self.slip[i] };
            let sticks = self.slip[i] == 0.0 && t.abs() <= rounding && self.friction[i] > 0.0;
            let slip = match (holds || self.base(i) > 0.0, sticks || self.never_slides(i)) {
                (false, _) => Slip::Open,
                (true, true) => Slip::Sticks,
                (true, false) if way < 0.0 => Slip::Backward,
                (true, false) => Slip::Forward,
            };
            Guess { holds, slip }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::contacts::set::ContactSet6;
    use crate::planar::contacts::set::Touch;
    use carom_num::Vec2;

    /// Feet of a body under a load: some at rest along the floor, some slipping.
    fn feet(count: u32, seed: f64) -> Vec<Touch> {
        let share = |k: u32, of: f64| (f64::from(k + 1) * of + seed).fract();
        let foot = |k: u32| Touch {
            arm: Vec2::new(share(k, 0.618_034) - 0.5, -0.4 - 0.3 * share(k, 0.324_718)),
            normal: Vec2::at_angle(0.5 * std::f64::consts::PI + 0.6 * (share(k, 0.754_877) - 0.5)),
            friction: share(k, 0.569_840),
            restitution: 0.0,
        };
        (0..count).map(foot).collect()
    }

    #[test]
    fn it_finds_one_of_the_solutions_that_trying_every_hypothesis_finds() {
        let mut found = 0;
        for case in 0..2000_u32 {
            let seed = (f64::from(case) * 0.445_042).fract();
            let count = 1 + case % 4;
            let set = ContactSet6::of_free_body(1.0, 0.2, Vec2::ZERO, 0.0, &feet(count, seed)).unwrap();
            let pull = Vec2::at_angle(6.3 * seed) * 9.81;
            let touches = feet(count, seed);
            let drive = std::array::from_fn(|i| {
                touches.get(i).map_or([0.0; 2], |t| [t.normal.turned_right().dot(pull), t.normal.dot(pull)])
            });
            let slip = std::array::from_fn(|i| [0.0, 1.0, 0.0, -1.0][(i + case as usize / 4) % 4]);
            let load = std::array::from_fn(|i| {
                if i < count as usize { Load::Touching(if i == 1 { 0.5 } else { 0.0 }) } else { Load::Absent }
            });
            let problem = RateProblem::<6, 12> {
                count: set.count,
                operator: &set.operator,
                friction: &set.friction,
                drive,
                slip,
                load,
            };
            let all = problem.solve_by_elimination();
            let one = problem.solve_by_pivoting();
            assert!(all.count == 0 || one.count == 1, "case {case}: {all:?}");
            let Some(one) = one.solutions[0] else { continue };
            found += 1;
            let same = |s: &Solution<6>| {
                let pairs = s.response.iter().flatten().zip(one.response.iter().flatten());
                pairs.map(|(a, b)| (a - b).abs()).all(|off| off < 1e-8)
            };
            assert!(all.count > Answer::<6>::KEPT || all.iter().any(same), "case {case}: {one:?} {all:?}");
        }
        assert!(found > 1900, "{found}");
    }
}
