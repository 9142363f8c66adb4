//! What supports that carry a body do to it, each sticking or sliding in a direction that is known.

use crate::spatial::geometry::body::Body;
use crate::spatial::geometry::state::Pose;
use crate::spatial::geometry::world::World;
use crate::tolerance::{MODE_RANK, NOTHING_NEW, SPANNED_RANK, STEEPEST};
use carom_impact::spatial::MOST_EXAMINED;
use carom_num::solve::{dot, solve_regular};
use carom_num::{Basis, Vec3};

/// Supports that carry a body at once, at most.
pub(in crate::spatial) const MOST_BEARING: usize = MOST_EXAMINED;
/// Unknown forces: one for each support that slides, three for each that sticks.
const MOST: usize = 3 * MOST_BEARING;
/// What a body can do: no more unknowns than this are determined by it.
const MOTIONS: usize = 6;

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
    /// A support without friction that has nothing to take away.
    pub(in crate::spatial) fn smooth(world: &World, support: usize, pose: Pose) -> Self {
        let axes = world.axes(support, pose).map(|axis| pose.attitude.undo(axis));
        Self { arm: world.arm(support, pose), axes, ..Self::default() }
    }

    /// The normal of its plane.
    pub(in crate::spatial) fn up(&self) -> Vec3 {
        self.axes[2]
    }

    /// The forces in which it pushes, by one unknown each, and along what it must not move.
    pub(in crate::spatial) fn pushes(&self) -> impl Iterator<Item = (Vec3, Vec3)> + '_ {
        self.axes[3 - self.unknowns()..].iter().map(|axis| {
            let force = if self.sticks { *axis } else { *axis - self.toward * self.friction };
            (force, *axis)
        })
    }

    /// How many unknowns it pushes with.
    fn unknowns(&self) -> usize {
        if self.sticks { 3 } else { 1 }
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
    /// Along what its support must not move, and what a unit force along that has as its moment.
    axis: Vec3,
    lever: Vec3,
}

impl Push {
    /// So many times as much of it.
    fn scaled(&self, by: f64) -> Self {
        let [force, moment] = [self.force, self.moment].map(|v| v * by);
        let [linear, angular] = [self.linear, self.angular].map(|v| v * by);
        Self { force, moment, linear, angular, ..*self }
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

    /// What moves along its axis where the body accelerates so.
    fn moved(&self, linear: Vec3, angular: Vec3) -> f64 {
        self.axis.dot(linear) + self.lever.dot(angular)
    }

    /// Response along the axis of another one to a unit of this: acceleration of its support [1/kg].
    fn moves_along(&self, of: &Self) -> f64 {
        of.moved(self.linear, self.angular)
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

/// What these motions span.
fn spanned<const M: usize>(mut motions: [[f64; M]; MOTIONS]) -> Basis<M> {
    let mut basis = Basis::NONE;
    let square = |motion: &[f64; M]| dot(motion, motion);
    let largest = |motions: &[[f64; M]; MOTIONS]| {
        motions.iter().copied().max_by(|a, b| square(a).total_cmp(&square(b))).unwrap_or([0.0; M])
    };
    let floor = MODE_RANK.sqrt() * square(&largest(&motions)).sqrt();
    // The one with the most that is new comes first: what is left of those that depend on others is then rounding.
    while basis.take(largest(&motions), floor) {
        let axis = basis.axes()[basis.axes().len() - 1];
        for motion in &mut motions {
            let along = dot(motion, &axis);
            motion.iter_mut().zip(&axis).for_each(|(v, a)| *v -= along * a);
        }
    }
    basis
}

/// The forces that do what is asked of them where they alone can: `None` where they share it with others.
fn alone<const M: usize>(pushes: &[Push], right: &[f64; M]) -> Option<[f64; M]> {
    if pushes.len() > MOTIONS {
        return None;
    }
    let (mut matrix, mut asked) = ([[0.0; MOTIONS]; MOTIONS], [0.0; MOTIONS]);
    asked.iter_mut().zip(right).for_each(|(asked, right)| *asked = *right);
    for (row, of) in matrix.iter_mut().zip(pushes) {
        row.iter_mut().zip(pushes).for_each(|(entry, by)| *entry = by.moves_along(of));
    }
    let found = solve_regular(matrix, asked, pushes.len(), MODE_RANK)?;
    let mut x = [0.0; M];
    x.iter_mut().zip(found).for_each(|(x, found)| *x = found);
    Some(x)
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
        let mut pushes = vec![Push::default(); self.unknowns()];
        self.fill(&mut pushes);
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
        match self.unknowns() {
            0 => Some(self.of(&[], &[], 1.0)),
            1 => {
                let mut one = [Push::default()];
                self.fill(&mut one);
                let [one] = one;
                let own = one.moves_along(&one);
                let normal = -self.bearings[one.of].drive.dot(one.axis) / own;
                Some(self.of(&[normal], &[one], own * self.body.mass()))
            }
            count @ 2..=MOTIONS => self.solved::<MOTIONS>(count, exact),
            count @ 7..=12 => self.solved::<12>(count, exact),
            count @ 13..=24 => self.solved::<24>(count, exact),
            count => self.solved::<MOST>(count, exact),
        }
    }

    /// How many unknowns there are.
    fn unknowns(&self) -> usize {
        self.bearings.iter().map(Bearing::unknowns).sum()
    }

    /// What the supports push with, one place for each unknown.
    fn fill(&self, pushes: &mut [Push]) {
        let mut places = pushes.iter_mut();
        for (of, b) in self.bearings.iter().enumerate() {
            // Those of the support come first: the places end where the unknowns do.
            for ((force, axis), place) in b.pushes().zip(&mut places) {
                let moment = b.arm.cross(force);
                let (linear, angular) = (force / self.body.mass(), self.body.mobility() * moment);
                *place = Push { of, force, moment, linear, angular, axis, lever: b.arm.cross(axis) };
            }
        }
    }

    fn solved<const M: usize>(&self, count: usize, exact: bool) -> Option<Reactions> {
        let (mut pushes, mut right) = ([Push::default(); M], [0.0; M]);
        let pushes = &mut pushes[..count];
        self.fill(pushes);
        for (right, push) in right.iter_mut().zip(&*pushes) {
            *right = -self.bearings[push.of].drive.dot(push.axis);
        }
        let x = alone(pushes, &right).or_else(|| self.sprung(pushes, &right, exact))?;
        Some(self.of(&x, pushes, 1.0))
    }

    /// The forces of equal springs, where supports that hold more than they must share what they carry: each in proportion to how far the body sinks in there.
    ///
    /// A body has six motions, however many supports it has: what they make of all supports is what can be asked for.
    fn sprung<const M: usize>(&self, pushes: &[Push], right: &[f64; M], exact: bool) -> Option<[f64; M]> {
        let mobility = self.body.mobility();
        // Turns in a unit in which they take as much to start as ways do.
        let [a, b, c] = mobility.rows;
        let turn = (self.body.mass() * (a.x + b.y + c.z) / 3.0).sqrt();
        let mut motions = [[0.0; M]; MOTIONS];
        for (k, push) in pushes.iter().enumerate() {
            let (way, by) = (push.axis.to_array(), (push.lever * turn).to_array());
            (0..3).for_each(|i| (motions[i][k], motions[i + 3][k]) = (way[i], by[i]));
        }
        let basis = spanned(motions);
        let axes = basis.axes();
        let (mut along, mut must) = ([[0.0; MOTIONS]; MOTIONS], [0.0; MOTIONS]);
        for (a, axis) in axes.iter().enumerate() {
            must[a] = dot(axis, right);
            // What the forces along this axis do to the body, and that to the supports.
            let all = axis.iter().zip(pushes);
            let [force, moment] = all.fold([Vec3::ZERO; 2], |[force, moment], (share, push)| {
                [force + push.force * *share, moment + push.moment * *share]
            });
            let (linear, angular) = (force / self.body.mass(), mobility * moment);
            for (other, row) in axes.iter().zip(&mut along) {
                let moved = other.iter().zip(pushes);
                row[a] = moved.map(|(share, of)| share * of.moved(linear, angular)).sum();
            }
        }
        let size = |v: &[f64; M]| v.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        if exact && size(&basis.left(*right)) > MODE_RANK * size(right) {
            return None;
        }
        // How many axes there are tells the rank: nothing but friction makes them singular.
        let z = solve_regular(along, must, axes.len(), SPANNED_RANK)?;
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
