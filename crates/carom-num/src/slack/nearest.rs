//! The point nearest to the origin where no slack is negative.

use super::Slacks;
use crate::solve::dot;
use crate::tolerance::{BLOCKS, NO_SLACK, PIVOT};

/// Steps for each slack, after which the search is given up: a guard against rounding that cycles.
const MOST_STEPS: usize = 10;

/// A point nearest to the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest<const M: usize> {
    /// The point.
    pub point: [f64; M],
    /// The slacks that keep it from the origin, one bit each: they are zero, and their slopes are independent.
    pub kept_by: u64,
}

/// Slacks that are held at zero: their slopes, made orthonormal one after the other.
struct Held<const M: usize> {
    of: [usize; M],
    count: usize,
    axes: [[f64; M]; M],
    /// Parts of each slope along the axes.
    parts: [[f64; M]; M],
}

impl<const M: usize> Slacks<M> {
    /// Finds the point nearest to z = 0 where no slack is negative, from the point where the smallest is largest, by the method of active sets.
    ///
    /// `None` where some slack is negative everywhere, or where it does not fit; M is at most 32.
    ///
    /// Source: Nocedal and Wright, Numerical Optimization (2006), algorithm 16.3, for the identity as the quadratic form.
    ///
    /// # Example
    /// Beyond the line x + y = 2, and where x is 1.5 at least.
    /// ```
    /// use carom_num::slack::Slacks;
    /// let mut slacks = Slacks::<4>::of(2);
    /// slacks.push(-2.0, |_| 1.0);
    /// let near = |found: [f64; 4], x: f64, y: f64| (found[0] - x).abs() + (found[1] - y).abs() < 1e-14;
    /// assert!(slacks.nearest().is_some_and(|n| near(n.point, 1.0, 1.0) && n.kept_by == 0b1));
    /// slacks.push(-1.5, |j| [1.0, 0.0][j]);
    /// assert!(slacks.nearest().is_some_and(|n| near(n.point, 1.5, 0.5) && n.kept_by == 0b11));
    /// slacks.push(1.0, |j| [-1.0, 0.0][j]);
    /// assert_eq!(slacks.nearest(), None, "x ≤ 1 as well");
    /// ```
    pub fn nearest(&self) -> Option<Nearest<M>> {
        if self.rows >= 2 * M || self.columns >= M {
            return None;
        }
        let constant = &self.constant.as_flattened()[..self.rows];
        if constant.iter().all(|c| *c >= 0.0) {
            return Some(Nearest { point: [0.0; M], kept_by: 0 });
        }
        // In units of the largest constant, whose square may be no number.
        let size = constant.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
        let mut scaled = self.clone();
        scaled.constant.as_flattened_mut()[..self.rows].iter_mut().for_each(|c| *c /= size);
        let found = scaled.nearest_of_ones()?;
        Some(Nearest { point: found.point.map(|z| z * size), ..found })
    }

    /// The same, where the largest constant is one.
    fn nearest_of_ones(&self) -> Option<Nearest<M>> {
        let (rows, columns) = (self.rows, self.columns);
        let constant = &self.constant.as_flattened()[..rows];
        let mut slopes = [[[0.0; M]; 2]; M];
        for k in 0..rows {
            let slope = &mut slopes.as_flattened_mut()[k];
            (0..columns).for_each(|j| slope[j] = self.coefficient[j].as_flattened()[k]);
        }
        let slopes = slopes.as_flattened();
        let (mut at, deepest) = self.clone().largest_smallest(1.0)?;
        if deepest < -NO_SLACK {
            return None;
        }
        let mut held = Held::NONE;
        for _ in 0..MOST_STEPS * (rows + 1) {
            let target = held.nearest(constant);
            // As far towards it as the slacks allow.
            let way: [f64; M] = std::array::from_fn(|j| target[j] - at[j]);
            let far = dot(&at, &at).sqrt() + dot(&target, &target).sqrt();
            let mut first: Option<(usize, f64)> = None;
            for k in (0..rows).filter(|k| !held.of[..held.count].contains(k)) {
                let falls = -dot(&slopes[k], &way);
                let slack = (constant[k] + dot(&slopes[k], &at)).max(0.0);
                let blocks = falls > BLOCKS * far * dot(&slopes[k], &slopes[k]).sqrt();
                if blocks && slack < falls * first.map_or(1.0, |(_, share)| share) {
                    first = Some((k, slack / falls));
                }
            }
            if let Some((k, share)) = first {
                at.iter_mut().zip(way).for_each(|(at, way)| *at += share * way);
                if held.count == columns || !held.add(k, &slopes[k]) {
                    return None;
                }
                continue;
            }
            at = target;
            // A slack that pulls at the point, instead of keeping it away, is let go.
            let Some(pulls) = held.pulling(&at) else {
                let kept_by = held.of[..held.count].iter().fold(0, |bits, k| bits | 1 << k);
                return Some(Nearest { point: at, kept_by });
            };
            held = held.without(pulls, slopes);
        }
        None
    }
}

impl<const M: usize> Held<M> {
    const NONE: Self = Self { of: [0; M], count: 0, axes: [[0.0; M]; M], parts: [[0.0; M]; M] };

    /// Holds one more slack; false where its slope is a sum of the others'.
    fn add(&mut self, k: usize, slope: &[f64; M]) -> bool {
        let (mut left, mut parts) = (*slope, [0.0; M]);
        // Twice is enough for rounding.
        for _ in 0..2 {
            for (axis, part) in self.axes[..self.count].iter().zip(&mut parts) {
                let along = dot(&left, axis);
                *part += along;
                left.iter_mut().zip(axis).for_each(|(l, a)| *l -= along * a);
            }
        }
        let length = dot(&left, &left).sqrt();
        if length <= PIVOT * dot(slope, slope).sqrt() {
            return false;
        }
        parts[self.count] = length;
        self.axes[self.count] = left.map(|l| l / length);
        self.parts[self.count] = parts;
        self.of[self.count] = k;
        self.count += 1;
        true
    }

    /// All but one of them.
    fn without(&self, k: usize, slopes: &[[f64; M]]) -> Self {
        let mut left = Self::NONE;
        for &other in self.of[..self.count].iter().filter(|other| **other != k) {
            left.add(other, &slopes[other]);
        }
        left
    }

    /// The point nearest to the origin where all of them are zero.
    fn nearest(&self, constant: &[f64]) -> [f64; M] {
        let mut along = [0.0; M];
        let mut point = [0.0; M];
        for i in 0..self.count {
            let before: f64 = (0..i).map(|j| self.parts[i][j] * along[j]).sum();
            along[i] = (-constant[self.of[i]] - before) / self.parts[i][i];
            point.iter_mut().zip(&self.axes[i]).for_each(|(p, a)| *p += along[i] * a);
        }
        point
    }

    /// Of the slacks without which the nearest point would be nearer, the one that pulls most.
    fn pulling(&self, at: &[f64; M]) -> Option<usize> {
        let mut pressure = [0.0; M];
        for i in (0..self.count).rev() {
            let after: f64 = (i + 1..self.count).map(|j| self.parts[j][i] * pressure[j]).sum();
            pressure[i] = (dot(at, &self.axes[i]) - after) / self.parts[i][i];
        }
        let least = (0..self.count).min_by(|&i, &j| pressure[i].total_cmp(&pressure[j]))?;
        let slope = dot(&self.parts[least], &self.parts[least]).sqrt();
        (pressure[least] * slope < -PIVOT * dot(at, at).sqrt()).then_some(self.of[least])
    }
}

#[cfg(test)]
mod tests {
    use crate::slack::Slacks;
    use crate::solve::{Tolerance, dot, solve_rows};

    /// What solving and pivoting leaves of numbers near 1.
    const ROUNDING: f64 = 1e-12;

    /// Beside all ways of leaving unknowns out: the shortest of those that are not negative.
    #[test]
    fn the_shortest_of_positive_solutions_is_that_of_all_subsets() {
        let (n, mut seed, mut found) = (6, 1u32, 0);
        let mut random = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1u32 << 23) - 1.0
        };
        for _ in 0..300 {
            let rows: [[f64; 6]; 3] =
                std::array::from_fn(|k| std::array::from_fn(|_| if k == 0 { 1.0 } else { random() }));
            let right = [1.0, 0.4 * random(), 0.4 * random()];
            let family = |left_out: u32| {
                let (mut rows, mut right) = (rows, right);
                rows.iter_mut()
                    .for_each(|row| (0..n).filter(|j| left_out & (1 << j) != 0).for_each(|j| row[j] = 0.0));
                let mut family = solve_rows(&mut rows, &mut right, n, Tolerance::of(ROUNDING))?;
                family.shorten();
                Some(family)
            };
            let subsets = (0..1 << n).filter_map(family).map(|family| family.point);
            let positive = subsets.filter(|x| x.iter().all(|x| *x >= -ROUNDING));
            let expected = positive.map(|x| dot(&x, &x)).fold(f64::INFINITY, f64::min);
            let x = family(0).unwrap().shortest_above(&[0.0; 6]).map(|found| found.point);
            assert_eq!(x.is_some(), expected.is_finite(), "{rows:?} {right:?}");
            let Some(x) = x else { continue };
            found += 1;
            let off =
                rows.iter().zip(right).map(|(row, right)| (dot(row, &x) - right).abs()).fold(0.0, f64::max);
            assert!(x.iter().all(|x| *x >= -ROUNDING) && off < 1e-12, "{x:?}: {off:e}");
            assert!((dot(&x, &x) - expected).abs() < 1e-12 * expected, "{x:?}");
        }
        assert!(found > 200, "{found} of 300 have such a solution");
    }

    /// The corner of a square seen along its diagonal, with a slack more than it takes: one of three that vanish there keeps the point by itself.
    #[test]
    fn slacks_may_vanish_together_at_any_size() {
        for size in [1e-200, 1e-9, 1.0, 1e9, 1e200] {
            let mut slacks = Slacks::<4>::of(2);
            slacks.push(-size, |j| [1.0, 0.0][j]);
            slacks.push(-size, |j| [0.0, 1.0][j]);
            slacks.push(-2.0 * size, |_| 1.0);
            // One that falls towards the origin from the other side, and touches at the corner too.
            slacks.push(size, |j| [-1.0, 0.0][j]);
            let found = slacks.nearest().unwrap();
            let off = found.point.iter().zip([1.0, 1.0, 0.0, 0.0]).map(|(z, x)| (z / size - x).abs());
            assert!(off.fold(0.0, f64::max) < ROUNDING, "{size:e}: {found:?}");
            slacks.push(0.5 * size, |j| [-1.0, 0.0][j]);
            assert_eq!(slacks.nearest(), None, "{size:e}: nowhere");
        }
    }

    #[test]
    fn entries_may_have_a_least_of_their_own() {
        // x + y = 3 with x at least 2, and with x at least 1: the shortest has both 1.5.
        let mut line =
            solve_rows(&mut [[1.0, 1.0, 0.0, 0.0]; 1], &mut [3.0], 2, Tolerance::of(ROUNDING)).unwrap();
        line.shorten();
        let of = |least: f64| line.shortest_above(&[least, 0.0]).unwrap();
        let near = |x: [f64; 4], y: [f64; 2]| (x[0] - y[0]).abs() + (x[1] - y[1]).abs() < ROUNDING;
        assert!(near(of(2.0).point, [2.0, 1.0]) && of(2.0).at_least == 0b1, "{:?}", of(2.0));
        assert!(near(of(1.0).point, [1.5, 1.5]) && of(1.0).at_least == 0, "{:?}", of(1.0));
    }
}
