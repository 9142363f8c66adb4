//! The directions in which contacts start to slip.
//!
//! *One* contact that starts: the others' reactions are taken into its response, and friction against the slip that starts makes a trigonometric equation of second
//! degree, `e⊥ · [a_t D(e) − a_n c_t(e)] = 0` with c(e) its response to a normal rate with friction against e and D = c_n. All of its roots are found: up to four.
//!
//! *Two*: the first one's equation is of first degree in the direction of the second, which gives closed curves of pairs of directions, whose ends are
//! roots of a trigonometric equation; on these the second one's equation changes sign. Each is scanned in steps, more where the directions turn fast.
//! *More*, or rates that stay open whatever the direction: as one motion of all of them, see [`motions`](super::motions). Where what holds and sticks leaves them
//! none or one, its directions are known for certain, of two contacts too; else a direction may be missed.

use super::answer::{Guess, Mode};
use super::equations::Hypothesis;
use super::motions::Motions;
use super::rate::{RateProblem, Search, Tried};
use super::reduced::Reduced;
use crate::Load;
use crate::spatial::contacts::set::MOST_EXAMINED;
use crate::tolerance::{HELD, SAME_DIRECTION, START_ARRIVED, START_DIFFERENCE, START_RANK, START_ROUNDING};
use carom_num::elementary::{atan2, sin_cos};
use carom_num::solve::solve_regular;
use carom_num::{Mat3, Vec3};
use std::f64::consts::TAU;

/// Contacts that start at once, at most.
pub(super) const MOST: usize = MOST_EXAMINED;
/// Directions spread evenly, for each contact of the first four.
const SEEDS: usize = 12;
/// Newton's steps, and what they may be at most [rad].
const MOST_STEPS: u32 = 24;
const LONGEST: f64 = 0.5;

/// Directions of all contacts.
pub(in crate::spatial) type Directions<const N: usize> = [[f64; 2]; N];

/// Where Newton's method starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Seeds {
    /// At the motion that the drive causes.
    Driven,
    /// Wherever a motion that follows itself may be near.
    All,
}

impl<const N: usize> RateProblem<'_, N> {
    /// Hands all directions of a hypothesis to `visit`, if it belongs to this search.
    pub(super) fn each_start(
        &self,
        guess: &[Guess; N],
        search: Search,
        visit: &mut impl FnMut(&Directions<N>),
    ) -> Tried {
        let mut direction = [[0.0; 2]; N];
        let (mut starting, mut k) = ([0; MOST], 0);
        for i in 0..self.count {
            match guess[i].mode {
                Mode::Slips => direction[i] = self.slip_direction(i),
                Mode::Starts => {
                    starting[k] = i;
                    k += 1;
                }
                Mode::Open | Mode::Sticks => {}
            }
        }
        match search {
            Search::Certain => self.start_for_certain(guess, direction, &starting[..k], visit),
            Search::Pairs => self.start_in_pairs(guess, direction, &starting[..k], visit),
            Search::Driven => self.start_widely(guess, direction, &starting[..k], (Seeds::Driven, visit)),
            Search::Wide => self.start_widely(guess, direction, &starting[..k], (Seeds::All, visit)),
        }
    }

    fn start_for_certain(
        &self,
        guess: &[Guess; N],
        mut direction: Directions<N>,
        starting: &[usize],
        visit: &mut impl FnMut(&Directions<N>),
    ) -> Tried {
        if starting.is_empty() {
            visit(&direction);
            return Tried::ForCertain;
        }
        if let &[i] = starting
            && let Some(one) = self.reduced([i], guess, direction)
        {
            one.each_root(|e| {
                direction[i] = e;
                visit(&direction);
            });
            return Tried::ForCertain;
        }
        match self.motions(guess, direction, starting) {
            Some(motions) if motions.freedom() <= 1 => {
                motions.each_near(visit);
                Tried::ForCertain
            }
            _ => Tried::Elsewhere,
        }
    }

    fn start_in_pairs(
        &self,
        guess: &[Guess; N],
        mut direction: Directions<N>,
        starting: &[usize],
        visit: &mut impl FnMut(&Directions<N>),
    ) -> Tried {
        let &[i, j] = starting else { return Tried::Elsewhere };
        match self.motions(guess, direction, starting) {
            Some(motions) if motions.freedom() <= 1 => return Tried::Elsewhere,
            Some(motions) if motions.freedom() == 2 => {
                self.seek(guess, (direction, starting), Some(&motions), (Seeds::All, visit));
                return Tried::Looked;
            }
            _ => {}
        }
        let Some(pair) = self.reduced([i, j], guess, direction) else { return Tried::Elsewhere };
        pair.each_pair(|[a, b]| {
            (direction[i], direction[j]) = (a, b);
            visit(&direction);
        });
        Tried::Looked
    }

    /// Tries what the two narrower searches leave.
    fn start_widely(
        &self,
        guess: &[Guess; N],
        direction: Directions<N>,
        starting: &[usize],
        (seeds, visit): (Seeds, &mut impl FnMut(&Directions<N>)),
    ) -> Tried {
        let elsewhere = match *starting {
            [] => true,
            [i] => self.reduced([i], guess, direction).is_some(),
            _ => false,
        };
        if elsewhere {
            return Tried::Elsewhere;
        }
        let motions = self.motions(guess, direction, starting);
        match (motions.as_ref().map(Motions::freedom), starting) {
            (Some(0 | 1), _) | (Some(2), [_, _]) => return Tried::Elsewhere,
            (_, &[i, j]) if self.reduced([i, j], guess, direction).is_some() => return Tried::Elsewhere,
            _ => self.seek(guess, (direction, starting), motions.as_ref(), (seeds, visit)),
        }
        Tried::Looked
    }

    /// The response of contacts that start, all others reacting as the hypothesis says; `None` where that leaves rates open.
    fn reduced<const K: usize>(
        &self,
        starting: [usize; K],
        guess: &[Guess; N],
        direction: Directions<N>,
    ) -> Option<Reduced<K>> {
        let mut others = *guess;
        starting.iter().for_each(|&i| others[i] = Guess::OPEN);
        let responding = |problem: &RateProblem<'_, N>| {
            let rates = Hypothesis { problem, guess: &others, direction }.determined()?;
            let (response, _) = problem.response(&rates);
            Some(starting.map(|i| response[i]))
        };
        let drive = responding(self)?;
        let mut operator = [[Mat3::ZERO; K]; K];
        for (b, &j) in starting.iter().enumerate() {
            let mut columns = [[Vec3::ZERO; 3]; K];
            for (axis, unit) in [Vec3::X, Vec3::Y, Vec3::Z].into_iter().enumerate() {
                let pushed: [Vec3; N] =
                    std::array::from_fn(
                        |i| if i < self.count { self.operator[i][j] * unit } else { Vec3::ZERO },
                    );
                // The others' base loads are in the response to the drive already, and must not count again.
                let response =
                    responding(&RateProblem { drive: pushed, load: [Load::Touching(0.0); N], ..*self })?;
                (0..K).for_each(|a| columns[a][axis] = response[a]);
            }
            for a in 0..K {
                let [x, y, z] = columns[a];
                operator[a][b] = Mat3::of_columns(x, y, z);
            }
            // Others hold it along its normal: they could take over any load of it, and the rates stay open.
            let own = self.operator[j][j].rows[2].z;
            if guess[j].holds && operator[b][b].rows[2].z.abs() <= HELD * own {
                return None;
            }
        }
        let base = starting.map(|i| (!guess[i].holds).then(|| self.base(i)));
        let held = (0..K).any(|a| self.is_held(starting[a], drive[a], &operator[a]));
        Some(Reduced { drive, operator, friction: starting.map(|i| self.friction[i]), base, held })
    }

    /// True where contact i responds to nothing across its normal, up to rounding.
    fn is_held(&self, i: usize, drive: Vec3, response: &[Mat3]) -> bool {
        let across = |block: &Mat3| block.rows[0].norm().max(block.rows[1].norm());
        let all = self.drive[..self.count].iter().map(|d| d.norm()).fold(0.0, f64::max);
        let driven = drive.x.abs().max(drive.y.abs()) > HELD * all;
        !driven && response.iter().all(|block| across(block) <= HELD * across(&self.operator[i][i]))
    }

    /// Newton's method from near the motions that follow themselves; where there is more than a sphere of motions, from directions spread evenly.
    fn seek(
        &self,
        guess: &[Guess; N],
        (mut direction, starting): (Directions<N>, &[usize]),
        motions: Option<&Motions<'_, N>>,
        (seeds, visit): (Seeds, &mut impl FnMut(&Directions<N>)),
    ) {
        let k = starting.len();
        let mut aside = |theta: &[f64; MOST]| {
            for (theta, &i) in theta.iter().zip(starting) {
                let (sin, cos) = sin_cos(*theta);
                direction[i] = [cos, sin];
            }
            let rates = Hypothesis { problem: self, guess, direction }.shared()?;
            let (response, _) = self.response(&rates);
            let mut out = [0.0; MOST];
            for (out, &i) in out.iter_mut().zip(starting) {
                let [x, y] = direction[i];
                *out = x * response[i].y - y * response[i].x;
            }
            Some((out, direction))
        };
        let mut found: Vec<[f64; MOST]> = vec![];
        let mut arrive = |from: [f64; MOST]| {
            let Some(theta) = newton(from, k, &mut |t| aside(t).map(|(f, _)| f)) else { return };
            // Many seeds lead to one root, and angles may differ by whole turns.
            let same = |other: &[f64; MOST]| {
                other.iter().zip(&theta).all(|(a, b)| sin_cos(0.5 * (a - b)).0.abs() < 0.5 * SAME_DIRECTION)
            };
            if !found.iter().any(same)
                && let Some((_, direction)) = aside(&theta)
            {
                found.push(theta);
                visit(&direction);
            }
        };
        let mut from = |direction: &Directions<N>| {
            let mut theta = [0.0; MOST];
            for (theta, &i) in theta.iter_mut().zip(starting) {
                *theta = atan2(direction[i][1], direction[i][0]);
            }
            arrive(theta);
        };
        match (motions, seeds) {
            (Some(motions), Seeds::Driven) => motions.driven(&mut from),
            (None, Seeds::Driven) => {}
            (Some(motions), Seeds::All) => motions.each_near(&mut from),
            (None, Seeds::All) => (0..SEEDS * k.min(4)).for_each(|seed| arrive(spread(seed, k))),
        }
    }
}

/// Angles of a seed, one for each contact.
fn spread(seed: usize, k: usize) -> [f64; MOST] {
    std::array::from_fn(|axis| if axis < k { TAU * additive(seed, axis) } else { 0.0 })
}

/// The numbers of an additive recurrence, spread evenly over [0, 1) in each axis and in all together.
pub(super) fn additive(number: usize, axis: usize) -> f64 {
    const ROOTS: [f64; MOST] =
        [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0, 31.0, 37.0, 41.0, 43.0, 47.0, 53.0];
    #[expect(clippy::cast_precision_loss, reason = "small counts")]
    let n = number as f64;
    (0.3 + n * ROOTS[axis].sqrt()).fract()
}

/// A root of k equations in k angles.
pub(super) fn newton(
    mut theta: [f64; MOST],
    k: usize,
    f: &mut impl FnMut(&[f64; MOST]) -> Option<[f64; MOST]>,
) -> Option<[f64; MOST]> {
    let mut before = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let value = f(&theta)?;
        let mut slopes = [[0.0; MOST]; MOST];
        for j in 0..k {
            let [mut low, mut high] = [theta; 2];
            low[j] -= START_DIFFERENCE;
            high[j] += START_DIFFERENCE;
            let (low, high) = (f(&low)?, f(&high)?);
            for i in 0..k {
                slopes[i][j] = (high[i] - low[i]) / (2.0 * START_DIFFERENCE);
            }
        }
        let step = solve_regular(slopes, value, k, START_RANK)?;
        let largest = step[..k].iter().fold(0.0, |m: f64, s| m.max(s.abs()));
        let shorter = if largest > LONGEST { LONGEST / largest } else { 1.0 };
        theta.iter_mut().zip(step).for_each(|(theta, s)| *theta -= s * shorter);
        // So near a root steps shrink by their square, unless they are rounding.
        if largest <= START_ARRIVED || (largest <= START_ROUNDING && largest >= 0.5 * before) {
            return Some(theta);
        }
        before = largest;
    }
    None
}
