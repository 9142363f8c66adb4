//! The hypotheses of a rate problem, and which of them are part of another one and are not asked beside it.
//!
//! Three contacts of a face that hold keep the whole face on its plane, and two that stick keep all of it from sliding. A hypothesis in which such a
//! contact is open, or starts to slip, can only be consistent with a rate of zero where it is open, or a slip of zero where it starts: its rates are then
//! in the family of the hypothesis in which that contact holds, or sticks. So it is where two contacts hold between which others lie on both sides:
//! they could only open if others closed. Of a family one member stands for all, by the rule of [`equations`](super::equations): with friction the
//! others may move the body in another way, and that is said by [`Freedom::Motion`]. Of n corners of a face the face, its edges and its corners are
//! left in place of 2ⁿ sets.
//!
//! [`Freedom::Motion`]: super::answer::Freedom::Motion

use super::answer::{Guess, Mode};
use super::equations::component;
use super::rate::RateProblem;
use crate::Load;
use crate::tolerance::RANK;
use carom_num::Vec3;

/// Whether a hypothesis is asked beside others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Closed {
    /// It says of all that holds and sticks together that it does.
    Yes,
    /// It is part of another one. It is asked only where no other kind is consistent: the one member that stands for all rates of a hypothesis need not be
    /// where a part of them is.
    No,
}

/// A constraint as the rates and the drive see it: its row of the operator, and its drive.
#[derive(Clone, Copy)]
struct Row<const N: usize> {
    of: [Vec3; N],
    drive: f64,
}

impl<const N: usize> Row<N> {
    fn dot(&self, other: &Self) -> f64 {
        self.drive * other.drive + self.of.iter().zip(&other.of).map(|(a, b)| a.dot(*b)).sum::<f64>()
    }

    fn less(&self, other: &Self, times: f64) -> Self {
        let of = std::array::from_fn(|i| self.of[i] - other.of[i] * times);
        Self { of, drive: self.drive - other.drive * times }
    }

    fn over(&self, length: f64) -> Self {
        Self { of: self.of.map(|of| of / length), drive: self.drive / length }
    }

    /// What of it no other row has, of length 1, if it is more than rounding.
    fn beside(&self, others: &[Self]) -> Option<Self> {
        let size = self.dot(self).sqrt();
        let mut left = *self;
        // Twice is enough for rounding.
        for _ in 0..2 {
            left = others.iter().fold(left, |left, other| left.less(other, left.dot(other)));
        }
        let length = left.dot(&left).sqrt();
        (length > RANK * size).then(|| left.over(length))
    }
}

/// The hypotheses of a problem, one contact said after the other, the last one first.
pub(super) struct Guesses<'p, 'q, const N: usize> {
    problem: &'p RateProblem<'q, N>,
    rows: [[Row<N>; 3]; N],
    /// What is said so far.
    guess: [Guess; N],
    /// What holds and sticks, orthonormal.
    fixed: Vec<Row<N>>,
}

impl<'p, 'q, const N: usize> Guesses<'p, 'q, N> {
    pub(super) fn of(problem: &'p RateProblem<'q, N>) -> Self {
        let count = problem.count;
        // The drive counts as much as the operator, whatever its unit.
        let driven = problem.drive[..count].iter().fold(0.0, |m: f64, d| m.max(d.norm()));
        let responds = (0..count).fold(0.0, |m: f64, i| m.max(problem.operator[i][i].rows[2].norm()));
        let unit = if driven > 0.0 { responds / driven } else { 0.0 };
        let none = Row { of: [Vec3::ZERO; N], drive: 0.0 };
        let mut rows = [[none; 3]; N];
        for (i, of) in rows.iter_mut().enumerate().take(count) {
            for (axis, row) in of.iter_mut().enumerate() {
                row.drive = unit * component(problem.drive[i], axis);
                let entries = problem.operator[i].iter().take(count).map(|block| block.rows[axis]);
                row.of.iter_mut().zip(entries).for_each(|(place, entry)| *place = entry);
            }
        }
        Self { problem, rows, guess: [Guess::OPEN; N], fixed: vec![] }
    }

    /// Hands over every hypothesis of a kind, the options of the first contact in turn, then those of the next.
    pub(super) fn each(&mut self, kind: Closed, visit: &mut impl FnMut(&[Guess; N])) {
        self.say(self.problem.count, true, kind, visit);
    }

    /// True where nothing that is said to be open, or to start to slip, is kept from it by what holds and sticks.
    pub(super) fn is_closed(&mut self, guess: &[Guess; N]) -> bool {
        self.fixed.clear();
        self.guess = *guess;
        (0..self.problem.count).for_each(|i| self.fix(i));
        self.lets(0) && self.opens()
    }

    /// Says what the contacts below `from` do; `closed` is whether the others are closed among themselves.
    fn say(&mut self, from: usize, closed: bool, kind: Closed, visit: &mut impl FnMut(&[Guess; N])) {
        if from == 0 {
            let is_closed = closed && self.opens();
            if is_closed == (kind == Closed::Yes) {
                visit(&self.guess);
            }
            return;
        }
        let i = from - 1;
        for option in self.problem.options(i) {
            let count = self.fixed.len();
            self.guess[i] = option;
            self.fix(i);
            // What is kept stays kept, whatever is said of the others.
            let closed = closed && self.lets(i);
            if closed || kind == Closed::No {
                self.say(i, closed, kind, visit);
            }
            self.fixed.truncate(count);
        }
    }

    /// Takes in what contact i keeps.
    fn fix(&mut self, i: usize) {
        let sticks = self.guess[i].mode == Mode::Sticks;
        for (axis, fixed) in [sticks, sticks, self.guess[i].holds].into_iter().enumerate() {
            if fixed && let Some(new) = self.rows[i][axis].beside(&self.fixed) {
                self.fixed.push(new);
            }
        }
    }

    fn kept(&self, i: usize, axis: usize) -> bool {
        self.rows[i][axis].beside(&self.fixed).is_none()
    }

    /// Contacts from this one on that may open.
    fn opening(&self, from: usize) -> impl Iterator<Item = usize> {
        (from..self.problem.count)
            .filter(|&i| !self.guess[i].holds && matches!(self.problem.load[i], Load::Touching(_)))
    }

    /// False where what holds and sticks keeps a contact, from this one on, on its plane that is said to be open, or keeps one from slipping that
    /// is said to start.
    fn lets(&self, from: usize) -> bool {
        let starts = |&i: &usize| self.guess[i].mode == Mode::Starts;
        let slips_not = (from..self.problem.count).filter(starts).any(|i| self.kept(i, 0) && self.kept(i, 1));
        !slips_not && !self.opening(from).any(|i| self.kept(i, 2))
    }

    /// False where the contacts that may open are left with one motion, and some of them would close by it whichever way it goes.
    fn opens(&self) -> bool {
        let mut left = self.opening(0).map(|i| self.rows[i][2].beside(&self.fixed));
        let Some(Some(only)) = left.next() else { return true };
        let sides = left.map(|left| {
            let unit = left?;
            let along = unit.dot(&only);
            unit.beside(&[only]).is_none().then_some(along > 0.0)
        });
        // With more motions than one nothing is said.
        let Some(sides) = sides.collect::<Option<Vec<bool>>>() else { return true };
        sides.iter().all(|same| *same)
    }
}
