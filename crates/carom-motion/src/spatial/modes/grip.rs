//! What supports that carry a body do to it, each sticking or sliding in a direction that is known.

use crate::spatial::geometry::body::Body;
use crate::tolerance::{MODE_RANK, NOTHING_NEW, STEEPEST};
use carom_impact::spatial::MOST_EXAMINED;
use carom_num::solve::{dot, solve_regular};
use carom_num::{Basis, Vec3};

/// Supports that carry a body at once, at most.
pub(in crate::spatial) const MOST_BEARING: usize = MOST_EXAMINED;
/// Unknown forces: one for each support that slides, three for each that sticks.
const MOST: usize = 3 * MOST_BEARING;

/// A support that carries the body, in body axes.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::spatial) struct Bearing {
    /// From the mass centre \[m\].
    pub(in crate::spatial) arm: Vec3,
    /// The tangents and the normal of its plane.
    pub(in crate::spatial) axes: [Vec3; 3],
    pub(in crate::spatial) friction: f64,
    pub(in crate::spatial) sticks: bool,
    /// Unit vector of its slip; zero where it sticks.
    pub(in crate::spatial) toward: Vec3,
    /// What the forces have to take away: its acceleration without them, or its velocity.
    pub(in crate::spatial) drive: Vec3,
}

impl Bearing {
    /// The normal of its plane.
    pub(in crate::spatial) fn up(&self) -> Vec3 {
        self.axes[2]
    }

    /// The forces in which it pushes, by one unknown each, and along what it must not move.
    pub(in crate::spatial) fn pushes(&self) -> impl Iterator<Item = (Vec3, Vec3)> + '_ {
        let count = if self.sticks { 3 } else { 1 };
        self.axes.iter().rev().take(count).rev().map(|axis| {
            let force = if self.sticks { *axis } else { *axis - self.toward * self.friction };
            (force, *axis)
        })
    }

    /// The part of a vector along its plane.
    pub(in crate::spatial) fn along(&self, v: Vec3) -> Vec3 {
        v - self.up() * self.up().dot(v)
    }
}

/// What these supports do.
#[derive(Clone, Debug)]
pub(in crate::spatial) struct Reactions {
    /// On each of them, body axes.
    pub(in crate::spatial) forces: Vec<Vec3>,
    /// The normal part of each.
    pub(in crate::spatial) normals: Vec<f64>,
    /// All of them, and their moment about the mass centre.
    pub(in crate::spatial) force: Vec3,
    pub(in crate::spatial) moment: Vec3,
    /// Of one support that slides: `m W_nn` with friction along. It presses the body out where this is positive.
    pub(in crate::spatial) regularity: f64,
}

/// Where forces act and what they do.
pub(in crate::spatial) struct Grip<'a> {
    pub(in crate::spatial) body: &'a Body,
    pub(in crate::spatial) bearings: &'a [Bearing],
}

/// A direction in which a support can push with one unknown, and how the body responds.
#[derive(Clone, Copy, Default)]
struct Push {
    of: usize,
    force: Vec3,
    /// About the mass centre.
    moment: Vec3,
    linear: Vec3,
    angular: Vec3,
    /// Along what its support must not move.
    axis: Vec3,
}

impl Push {
    /// So many times as much of it.
    fn scaled(&self, by: f64) -> Self {
        let Self { of, axis, .. } = *self;
        let [force, moment] = [self.force, self.moment].map(|v| v * by);
        let [linear, angular] = [self.linear, self.angular].map(|v| v * by);
        Self { of, force, moment, linear, angular, axis }
    }

    /// What is left of it without these, which are of size one and square to each other; twice, for the rounding of the first time.
    fn left(&self, axes: &[Self]) -> Self {
        let mut left = *self;
        for axis in axes.iter().chain(axes) {
            let share = left.force.dot(axis.linear) + left.moment.dot(axis.angular);
            left = left.with(axis, -share);
        }
        left
    }

    /// The square of its size, by the body's own mass.
    fn square(&self) -> f64 {
        self.force.dot(self.linear) + self.moment.dot(self.angular)
    }

    /// What it moves supports by, along what each of these must not move.
    fn does(&self, pushes: &[Self]) -> Vec<f64> {
        let along = |of: &Self| of.force.dot(self.linear) + of.moment.dot(self.angular);
        pushes.iter().map(along).collect()
    }

    /// The same with so much of another one.
    fn with(&self, other: &Self, share: f64) -> Self {
        Self {
            force: self.force + other.force * share,
            moment: self.moment + other.moment * share,
            linear: self.linear + other.linear * share,
            angular: self.angular + other.angular * share,
            ..*self
        }
    }
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The axes along which pushes are to bring what they are short of: of size one and square to each other, without those along which rounding would be multiplied.
fn reconciled(pushes: &[Push], short: &[f64]) -> Vec<Push> {
    let worst = pushes.iter().zip(short).map(|(push, short)| short.abs() / push.square().sqrt());
    let most = STEEPEST * worst.fold(0.0, f64::max);
    let (mut axes, mut gone): (Vec<Push>, Vec<f64>) = (vec![], vec![0.0; pushes.len()]);
    let mut open: Vec<usize> = (0..pushes.len()).collect();
    loop {
        // The one with the most that is new comes first.
        let left = open.iter().enumerate().map(|(place, k)| (place, *k, pushes[*k].left(&axes)));
        let next = left.max_by(|a, b| a.2.square().total_cmp(&b.2.square()));
        let Some((place, k, left)) = next.filter(|n| n.2.square() > NOTHING_NEW * pushes[n.1].square())
        else {
            return axes;
        };
        open.remove(place);
        let size = left.square().sqrt();
        let share = (short[k] - gone[k]) / size;
        if share.abs() <= most {
            let axis = left.scaled(1.0 / size);
            gone.iter_mut().zip(axis.does(pushes)).for_each(|(gone, does)| *gone += share * does);
            axes.push(axis);
        }
    }
}

impl Grip<'_> {
    /// The forces under which no support moves along the normal, and none that sticks moves at all. Of a family of such forces, those of equal springs. `None`
    /// where there are none.
    pub(in crate::spatial) fn reactions(&self) -> Option<Reactions> {
        self.answer(true)
    }

    /// The same, where the drives are what rounding has left of supports that move: what no forces could take away of them is left.
    pub(in crate::spatial) fn corrections(&self) -> Option<Reactions> {
        self.answer(false)
    }

    /// The least change of velocity and spin, by the body's own mass, after which no support moves along the normal and none that sticks moves at all: what takes
    /// back the rounding of its drives. It has no friction.
    ///
    /// Supports that almost say the same contradict each other by rounding, and what would reconcile them is no rounding any more: the one that asks for it is left as it is.
    pub(in crate::spatial) fn taken_back(&self) -> (Vec3, Vec3) {
        let pushes = self.pushes();
        let short: Vec<f64> = pushes.iter().map(|of| -self.bearings[of.of].drive.dot(of.axis)).collect();
        let (mut velocity, mut spin) = (Vec3::ZERO, Vec3::ZERO);
        let mut square: Vec<(Vec<f64>, Push)> = vec![];
        for axis in reconciled(&pushes, &short) {
            let (mut own, mut does) = (axis, axis.does(&pushes));
            for (other, by) in &square {
                let share = product(&does, other);
                does.iter_mut().zip(other).for_each(|(a, b)| *a -= share * b);
                own = own.with(by, -share);
            }
            let scale = 1.0 / product(&does, &does).sqrt();
            does.iter_mut().for_each(|a| *a *= scale);
            let (own, share) = (own.scaled(scale), product(&does, &short));
            velocity += own.linear * share;
            spin += own.angular * share;
            square.push((does, own));
        }
        (velocity, spin)
    }

    fn answer(&self, exact: bool) -> Option<Reactions> {
        let pushes = &self.pushes()[..];
        match pushes.len() {
            0 => Some(self.of(&[], pushes, 1.0)),
            1 => {
                let one = &pushes[0];
                let own = self.moved_along(one, one);
                let normal = -self.bearings[0].drive.dot(one.axis) / own;
                Some(self.of(&[normal], pushes, own * self.body.mass()))
            }
            2..=4 => self.solved::<4>(pushes, exact),
            5..=10 => self.solved::<10>(pushes, exact),
            11..=24 => self.solved::<24>(pushes, exact),
            _ => self.solved::<MOST>(pushes, exact),
        }
    }

    fn pushes(&self) -> Vec<Push> {
        let mut pushes = Vec::with_capacity(3 * self.bearings.len());
        for (of, b) in self.bearings.iter().enumerate() {
            pushes.extend(b.pushes().map(|(force, axis)| {
                let moment = b.arm.cross(force);
                let (linear, angular) = (force / self.body.mass(), self.body.mobility() * moment);
                Push { of, force, moment, linear, angular, axis }
            }));
        }
        pushes
    }

    /// Response of the constraint `of` to a unit force of the push `by`: acceleration of its support along its axis [1/kg].
    fn moved_along(&self, by: &Push, of: &Push) -> f64 {
        of.axis.dot(by.linear + by.angular.cross(self.bearings[of.of].arm))
    }

    fn solved<const M: usize>(&self, pushes: &[Push], exact: bool) -> Option<Reactions> {
        let (mut matrix, mut right) = ([[0.0; M]; M], [0.0; M]);
        for (k, of) in pushes.iter().enumerate() {
            for (l, by) in pushes.iter().enumerate() {
                matrix[k][l] = self.moved_along(by, of);
            }
            right[k] = -self.bearings[of.of].drive.dot(of.axis);
        }
        if let Some(x) = solve_regular(matrix, right, pushes.len(), MODE_RANK) {
            return Some(self.of(&x, pushes, 1.0));
        }
        let x = self.sprung(&matrix, &right, pushes, exact)?;
        Some(self.of(&x, pushes, 1.0))
    }

    /// The forces of equal springs, where supports that hold more than they must share what they carry: each in proportion to how far the body sinks in there.
    fn sprung<const M: usize>(
        &self,
        matrix: &[[f64; M]; M],
        right: &[f64; M],
        pushes: &[Push],
        exact: bool,
    ) -> Option<[f64; M]> {
        let moved = |by: &Push| {
            let (force, moment) = (by.axis, self.bearings[by.of].arm.cross(by.axis));
            (force / self.body.mass(), self.body.mobility() * moment)
        };
        let (mut basis, mut columns) = (Basis::NONE, [[0.0; M]; M]);
        for (column, by) in columns.iter_mut().zip(pushes) {
            let (linear, angular) = moved(by);
            for (entry, of) in column.iter_mut().zip(pushes) {
                *entry = of.axis.dot(linear + angular.cross(self.bearings[of.of].arm));
            }
        }
        let largest = columns.iter().fold(0.0, |m: f64, c| m.max(dot(c, c))).sqrt();
        // The one with the most that is new comes first: what is left of those that depend on others is then rounding.
        let square = |column: &[f64; M]| dot(column, column);
        while let Some(next) = columns[..pushes.len()]
            .iter()
            .map(|column| basis.left(*column))
            .max_by(|a, b| square(a).total_cmp(&square(b)))
            && basis.take(next, MODE_RANK * largest)
        {}
        let axes = basis.axes();
        let (mut along, mut must) = ([[0.0; M]; M], [0.0; M]);
        for (a, axis) in axes.iter().enumerate() {
            must[a] = dot(axis, right);
            let does: [f64; M] =
                std::array::from_fn(|c| (0..pushes.len()).map(|k| axis[k] * matrix[k][c]).sum());
            along[a].iter_mut().zip(axes).for_each(|(entry, other)| *entry = dot(&does, other));
        }
        let size = |v: &[f64; M]| v.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        if exact && size(&basis.left(*right)) > MODE_RANK * size(right) {
            return None;
        }
        let z = solve_regular(along, must, axes.len(), MODE_RANK)?;
        Some(std::array::from_fn(|k| axes.iter().zip(z).map(|(axis, z)| axis[k] * z).sum()))
    }

    fn of(&self, x: &[f64], pushes: &[Push], regularity: f64) -> Reactions {
        let mut out = Reactions {
            forces: vec![Vec3::ZERO; self.bearings.len()],
            normals: Vec::with_capacity(self.bearings.len()),
            force: Vec3::ZERO,
            moment: Vec3::ZERO,
            regularity,
        };
        for (x, push) in x.iter().zip(pushes) {
            out.forces[push.of] += push.force * *x;
        }
        for (i, b) in self.bearings.iter().enumerate() {
            out.normals.push(out.forces[i].dot(b.up()));
            out.force += out.forces[i];
            out.moment += b.arm.cross(out.forces[i]);
        }
        out
    }
}
