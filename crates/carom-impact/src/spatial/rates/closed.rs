//! Which hypotheses are part of another one, and are not asked beside it.
//!
//! Three contacts of a face that hold keep the whole face on its plane, and two that stick keep all of it from sliding. A hypothesis in which such a
//! contact is open, or starts to slip, can only be consistent with a rate of zero where it is open, or a slip of zero where it starts: its rates are then
//! in the family of the hypothesis in which that contact holds, or sticks. Of a family one member stands for all, by the rule of
//! [`equations`](super::equations): with friction the others may move the body in another way, and that is said by [`Freedom::Motion`].
//! Of n corners of a face whole faces, edges and corners are left in place of 2ⁿ sets.
//!
//! [`Freedom::Motion`]: super::answer::Freedom::Motion

use super::answer::{Guess, Mode};
use super::equations::component;
use super::rate::RateProblem;
use crate::Load;
use crate::spatial::contacts::set::MOST_EXAMINED;
use crate::tolerance::RANK;
use carom_num::Vec3;

/// Most constraints.
const MOST_ROWS: usize = 3 * MOST_EXAMINED;

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

    /// What of it no other row has, if it is more than rounding.
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

impl<const N: usize> RateProblem<'_, N> {
    /// False where what holds and sticks keeps a contact on its plane that the hypothesis calls open, or keeps one from slipping that it lets start.
    pub(super) fn is_closed(&self, guess: &[Guess; N]) -> bool {
        let sticks = |i: usize| guess[i].mode == Mode::Sticks;
        let may_hold = |i: usize| !guess[i].holds && matches!(self.load[i], Load::Touching(_));
        let mut rows = [Row { of: [Vec3::ZERO; N], drive: 0.0 }; MOST_ROWS];
        let mut count = 0;
        // The drive counts as much as the operator, whatever its unit.
        let driven = self.drive[..self.count].iter().fold(0.0, |m: f64, d| m.max(d.norm()));
        let responds = (0..self.count).fold(0.0, |m: f64, i| m.max(self.operator[i][i].rows[2].norm()));
        let unit = if driven > 0.0 { responds / driven } else { 0.0 };
        let row = |i: usize, axis: usize| Row {
            of: std::array::from_fn(
                |j| if j < self.count { self.operator[i][j].rows[axis] } else { Vec3::ZERO },
            ),
            drive: unit * component(self.drive[i], axis),
        };
        for i in 0..self.count {
            for (axis, fixed) in [sticks(i), sticks(i), guess[i].holds].into_iter().enumerate() {
                let new = if fixed { row(i, axis).beside(&rows[..count]) } else { None };
                if let (Some(place), Some(new)) = (rows.get_mut(count), new) {
                    *place = new;
                    count += 1;
                }
            }
        }
        let rows = &rows[..count];
        let kept = |i: usize, axis: usize| row(i, axis).beside(rows).is_none();
        !(0..self.count).any(|i| {
            let starts = guess[i].mode == Mode::Starts;
            (may_hold(i) && kept(i, 2)) || (starts && kept(i, 0) && kept(i, 1))
        })
    }
}
