//! One or two contacts that start to slip while all others react: the equations of their directions.

use super::starts::{MOST, newton};
use carom_num::circle::Trigonometric;
use carom_num::elementary::{atan2, sin_cos};
use carom_num::{Mat3, Vec3};
use std::f64::consts::TAU;

/// Steps around a curve of pairs of directions.
const SCAN: u32 = 128;
/// Over a step the second direction turns by about this at most [rad], if so many halvings are enough.
const MOST_TURN: f64 = 0.1;
const MOST_HALVINGS: usize = 16;
/// Golden-section steps into a dip between places of one sign: each leaves 0.62 of it.
const DIP: u32 = 24;
/// Bisections before Newton's method: from farther it may run to another root.
const BISECTIONS: u32 = 12;
/// Directions of the second contact that are tried where that of the first is known.
const SEEDS: u32 = 16;

/// K contacts that start to slip, with their response while all others react.
pub(super) struct Reduced<const K: usize> {
    pub(in crate::spatial) drive: [Vec3; K],
    pub(in crate::spatial) operator: [[Mat3; K]; K],
    pub(in crate::spatial) friction: [f64; K],
    /// The base load of a contact that does not hold; `None` where it holds.
    pub(in crate::spatial) base: [Option<f64>; K],
    /// True where the others keep one of them from slipping at all.
    pub(in crate::spatial) held: bool,
}

/// A place on a curve of pairs of directions.
#[derive(Clone, Copy)]
struct Look {
    phi: f64,
    /// Direction of the first contact [rad].
    theta: f64,
    /// Direction of the second.
    e: [f64; 2],
    /// Component of the second one's response across its slip.
    aside: f64,
}

/// Response to a normal rate with friction against a direction.
fn sliding(w: &Mat3, friction: f64, [x, y]: [f64; 2]) -> Vec3 {
    *w * Vec3::new(-friction * x, -friction * y, 1.0)
}

fn aside([x, y]: [f64; 2], v: Vec3) -> f64 {
    x * v.y - y * v.x
}

impl Reduced<1> {
    /// All directions in which the response is along the slip.
    pub(super) fn each_root(&self, mut visit: impl FnMut([f64; 2])) {
        if self.held {
            return;
        }
        let (a, [[w]], [mu]) = (self.drive[0], &self.operator, self.friction);
        let [tx, ty, n] = w.rows;
        // Rate r = −a_n / D(e) where it holds, D = w_nn − μ w_nt · e; times D, the response is v + V e.
        let (rate, [hx, hy, hn]) = match self.base[0] {
            None => (-a.z, [-mu * n.x, -mu * n.y, n.z]),
            Some(base) => (base, [0.0, 0.0, 1.0]),
        };
        let v = [a.x * hn + rate * tx.z, a.y * hn + rate * ty.z];
        let of = |a: f64, row: Vec3| [a * hx - mu * rate * row.x, a * hy - mu * rate * row.y];
        let [[xx, xy], [yx, yy]] = [of(a.x, tx), of(a.y, ty)];
        let size = |u: Vec3| u.x.abs() + u.y.abs() + u.z.abs();
        let terms = (1.0 + mu) * (size(a) * size(n) + rate.abs() * (size(tx) + size(ty)));
        let equation = Trigonometric {
            constant: 0.5 * (yx - xy),
            cos: [v[1], 0.5 * (yx + xy)],
            sin: [-v[0], 0.5 * (yy - xx)],
        };
        equation.each_root(terms, |theta| {
            let (sin, cos) = sin_cos(theta);
            visit([cos, sin]);
        });
    }
}

impl Reduced<2> {
    /// Components of both responses across the directions of their slips, zero at a solution, times the determinant of the normal rates. Of second
    /// degree in a contact's own direction, of first degree in the other's.
    fn aside(&self, e: [[f64; 2]; 2]) -> [f64; 2] {
        let c: [[Vec3; 2]; 2] =
            [0, 1].map(|i| [0, 1].map(|j| sliding(&self.operator[i][j], self.friction[j], e[j])));
        let a = [self.drive[0].z, self.drive[1].z];
        let (by, rates) = match self.base {
            [None, None] => (
                c[0][0].z * c[1][1].z - c[0][1].z * c[1][0].z,
                [a[1] * c[0][1].z - a[0] * c[1][1].z, a[0] * c[1][0].z - a[1] * c[0][0].z],
            ),
            [None, Some(base)] => (c[0][0].z, [-a[0] - base * c[0][1].z, base * c[0][0].z]),
            [Some(base), None] => (c[1][1].z, [base * c[1][1].z, -a[1] - base * c[1][0].z]),
            [Some(first), Some(second)] => (1.0, [first, second]),
        };
        [0, 1].map(|i| aside(e[i], self.drive[i] * by + c[i][0] * rates[0] + c[i][1] * rates[1]))
    }

    /// Magnitude of what makes up [`Reduced::aside`].
    fn terms(&self) -> f64 {
        let size = |v: Vec3| v.x.abs() + v.y.abs() + v.z.abs();
        let operator: f64 = self.operator.iter().flatten().flat_map(|block| block.rows).map(size).sum();
        let response = operator * (1.0 + self.friction[0] + self.friction[1]);
        let drive = size(self.drive[0]) + size(self.drive[1]);
        let held = |base: &Option<f64>| if base.is_none() { response } else { 1.0 };
        let bases: f64 = self.base.iter().flatten().sum();
        (drive + response * bases) * self.base.iter().map(held).product::<f64>()
    }

    /// The component of the first one's response across its slip, as a + (b, c) · e in the direction e of the second.
    fn first(&self, theta: f64) -> [f64; 3] {
        let (sin, cos) = sin_cos(theta);
        let at = |e: [f64; 2]| self.aside([[cos, sin], e])[0];
        let [east, west, north] = [at([1.0, 0.0]), at([-1.0, 0.0]), at([0.0, 1.0])];
        let a = 0.5 * (east + west);
        [a, 0.5 * (east - west), north - a]
    }

    /// Where this is positive, there are two directions of the second contact for which the first one's response is along its slip.
    fn discriminant(&self, theta: f64) -> f64 {
        let [a, b, c] = self.first(theta);
        b * b + c * c - a * a
    }

    /// One of these directions, and the component of the second contact's response across it.
    fn branch(&self, theta: f64, sign: f64) -> ([f64; 2], f64) {
        let ([a, b, c], (sin, cos)) = (self.first(theta), sin_cos(theta));
        let square = b * b + c * c;
        let root = sign * (square - a * a).max(0.0).sqrt();
        let e = [(-a * b - root * c) / square, (-a * c + root * b) / square];
        (e, self.aside([[cos, sin], e])[1])
    }

    /// Hands all directions that are found to `visit`.
    pub(super) fn each_pair(&self, mut visit: impl FnMut([[f64; 2]; 2])) {
        if self.held {
            return;
        }
        let mut polish = |theta: f64, e: [f64; 2]| {
            let mut seed = [0.0; MOST];
            (seed[0], seed[1]) = (theta, atan2(e[1], e[0]));
            let turned = |t: &[f64; MOST]| [t[0], t[1]].map(sin_cos).map(|(sin, cos)| [cos, sin]);
            let root = newton(seed, 2, &mut |t| {
                let mut out = [0.0; MOST];
                out[..2].copy_from_slice(&self.aside(turned(t)));
                Some(out)
            });
            if let Some(root) = root {
                visit(turned(&root));
            }
        };
        // A discriminant errs by what its parts err by, times these: they may be far smaller than their terms.
        let mut largest = 0.0_f64;
        let discriminant = Trigonometric::<4>::through(|theta| {
            let parts = self.first(theta);
            largest = parts.iter().fold(largest, |m, part| m.max(part.abs()));
            self.discriminant(theta)
        });
        let (mut ends, mut count) = ([0.0; 9], 0);
        discriminant.each_root(self.terms() * largest, |theta| {
            if let Some(place) = ends[..8].get_mut(count) {
                *place = theta;
                count += 1;
            }
        });
        if count == 0 {
            if discriminant.at(0.0)[0] > 0.0 {
                // Two branches around the whole circle.
                for sign in [1.0, -1.0] {
                    self.scan(|phi| (phi, sign), &mut polish);
                }
            }
            return;
        }
        ends[count] = ends[0] + TAU;
        let inside = |k: usize| discriminant.at(0.5 * (ends[k] + ends[k + 1]))[0] > 0.0;
        for k in 0..count {
            if inside(k) {
                // The two branches join at the ends: around the loop once.
                let (middle, half) = (0.5 * (ends[k] + ends[k + 1]), 0.5 * (ends[k + 1] - ends[k]));
                self.scan(
                    |phi| {
                        let (sin, cos) = sin_cos(phi);
                        (middle + half * cos, sin)
                    },
                    &mut polish,
                );
            } else if !inside((k + count - 1) % count) {
                // So short a loop that the first direction is known, and the second one may be any.
                for seed in 0..SEEDS {
                    let (sin, cos) = sin_cos(TAU * f64::from(seed) / f64::from(SEEDS));
                    polish(ends[k], [cos, sin]);
                }
            }
        }
    }

    /// Goes once around, in steps over which neither direction turns much, and hands the places near which the second contact's response changes sides to `polish`.
    fn scan(&self, at: impl Fn(f64) -> (f64, f64), polish: &mut impl FnMut(f64, [f64; 2])) {
        let step = TAU / f64::from(SCAN);
        let look = |phi: f64| {
            let (theta, sign) = at(phi);
            let (e, aside) = self.branch(theta, 1.0_f64.copysign(sign));
            Look { phi, theta, e, aside }
        };
        let mut before = look(0.5 * step);
        let mut older = before;
        let mut halvings = 8 * SCAN;
        // Halves of the present step that are still to be walked, the next one last.
        let mut ahead = [before; MOST_HALVINGS + 1];
        for i in 1..=SCAN {
            ahead[0] = look(step * (f64::from(i) + 0.5));
            let mut left = 1;
            while left > 0 {
                let now = ahead[left - 1];
                let turned = (before.e[0] - now.e[0]).abs() + (before.e[1] - now.e[1]).abs();
                if turned > MOST_TURN && left < ahead.len() && halvings > 0 {
                    halvings -= 1;
                    ahead[left] = look(0.5 * (before.phi + now.phi));
                    left += 1;
                    continue;
                }
                let mut cross = |one: Look, other: Look| {
                    let near = crossing(one, other, look);
                    polish(near.theta, near.e);
                };
                if (before.aside > 0.0) != (now.aside > 0.0) {
                    cross(before, now);
                } else if let Some(lowest) = dip([&older, &before, &now], look) {
                    cross(older, lowest);
                    cross(lowest, now);
                }
                (older, before) = (before, now);
                left -= 1;
            }
        }
    }
}

/// A place near which the sides change, between two places on different sides; Newton's method goes on from there.
fn crossing(mut one: Look, mut other: Look, look: impl Fn(f64) -> Look) -> Look {
    for _ in 0..BISECTIONS {
        let middle = look(0.5 * (one.phi + other.phi));
        if (middle.aside > 0.0) == (one.aside > 0.0) { one = middle } else { other = middle }
    }
    if one.aside.abs() < other.aside.abs() { one } else { other }
}

/// A place at which the second contact's response is on the other side of its slip, between three places on one side: the sides change twice
/// there. It is sought only where the middle place is the nearest to the other side.
fn dip([older, before, now]: [&Look; 3], look: impl Fn(f64) -> Look) -> Option<Look> {
    let side = 1.0_f64.copysign(before.aside);
    let height = |look: &Look| side * look.aside;
    if height(before) > height(older).min(height(now)) || height(before) <= 0.0 {
        return None;
    }
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (older.phi, now.phi);
    let at = |share: f64, low: f64, high: f64| look(low + share * (high - low));
    let (mut left, mut right) = (at(1.0 - golden, low, high), at(golden, low, high));
    for _ in 0..DIP {
        let lowest = if height(&left) < height(&right) { left } else { right };
        if height(&lowest) <= 0.0 {
            return Some(lowest);
        }
        if height(&left) < height(&right) {
            (high, right) = (right.phi, left);
            left = at(1.0 - golden, low, high);
        } else {
            (low, left) = (left.phi, right);
            right = at(golden, low, high);
        }
    }
    None
}
