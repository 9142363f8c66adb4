//! The narrowest cones that hold a member of a family of vectors: a small convex problem, solved through analytic centres.

use crate::Vec3;
use crate::slack::Slacks;
use crate::tolerance::{CONES_CENTRED, CONES_CLOSE, CONES_FLAT, CONES_SHORTEST};

/// Room of the linear programme that finds a member with positive third components.
const MOST: usize = 40;
/// How much of the gap between a bound and its member's own cones is kept from one centre to the next.
const KEPT: f64 = 0.1;
/// Centres, and Newton steps to each, at most: a guard against rounding that goes in circles.
const MOST_CENTRES: u32 = 600;
const MOST_NEWTON: u32 = 40;

/// The least μ for which a member `p + Σⱼ xⱼ dⱼ` of a family has `√(pₓ² + p_y²) ≤ μ p_z` in each of its parts, to 10⁻⁹ of it.
///
/// For a fixed μ the members that do are a convex set; its analytic centre minimises `−Σ log(μ² p_z² − pₓ² − p_y²)`. The centre's own quotients are below μ, and
/// the next μ lies little above them, until both agree. Where members of any size are in the family, the least may be that of their limit.
///
/// Infinite where in every member a part has no third component and others, or a negative one. Parts that are zero throughout do not count.
///
/// # Source
/// Boyd and El Ghaoui, Method of centers for minimizing generalized eigenvalues, *Linear Algebra and its Applications* 188 (1993).
///
/// # Example
/// Two feet 2 m apart carry 1 N each and push along their line by 3 N and −2 N: only the difference to 1 N is needed, half of it by each.
/// ```
/// use carom_num::Vec3;
/// use carom_num::cones::narrowest;
/// let pushed = [Vec3::new(3.0, 0.0, 1.0), Vec3::new(-2.0, 0.0, 1.0)];
/// let apart = vec![Vec3::X, -Vec3::X];
/// assert!((narrowest(&pushed, &[apart]) - 0.5).abs() < 1e-9);
/// ```
pub fn narrowest<D: AsRef<[Vec3]>>(point: &[Vec3], free: &[D]) -> f64 {
    let free: Vec<&[Vec3]> = free.iter().map(AsRef::as_ref).collect();
    let counts = |i: &usize| point[*i] != Vec3::ZERO || free.iter().any(|d| d[*i] != Vec3::ZERO);
    let parts: Vec<usize> = (0..point.len()).filter(counts).collect();
    let of = |all: &[Vec3]| parts.iter().map(|i| all[*i]).collect::<Vec<_>>();
    let free: Vec<Vec<Vec3>> = free.iter().map(|d| of(d)).filter(|d| size(d) > 0.0).collect();
    let Some(start) = upright(&of(point), &free) else { return opening(&of(point)) };
    let mut family = Family::of(start, &free);
    if free.is_empty() || family.opening() == 0.0 {
        return family.opening();
    }
    let mut bound = 2.0 * family.opening();
    for _ in 0..MOST_CENTRES {
        family.centre(bound);
        let own = family.opening();
        if bound - own <= CONES_CLOSE * own {
            break;
        }
        bound = own + KEPT * (bound - own);
    }
    family.opening()
}

fn size(all: &[Vec3]) -> f64 {
    all.iter().map(|p| p.norm()).fold(0.0, f64::max)
}

/// The largest quotient of a member.
fn opening(member: &[Vec3]) -> f64 {
    let of = |p: &Vec3| {
        let across = (p.x * p.x + p.y * p.y).sqrt();
        if across == 0.0 && p.z >= 0.0 {
            0.0
        } else if p.z > 0.0 {
            across / p.z
        } else {
            f64::INFINITY
        }
    };
    member.iter().map(of).fold(0.0, f64::max)
}

/// A member whose third components are all positive; `None` where there is none.
fn upright(point: &[Vec3], free: &[Vec<Vec3>]) -> Option<Vec<Vec3>> {
    let least = |member: &[Vec3]| member.iter().map(|p| p.z).fold(f64::INFINITY, f64::min);
    let mut member = point.to_vec();
    let enough = CONES_FLAT * size(point);
    if least(&member) <= enough && !free.is_empty() && free.len() < MOST && point.len() < MOST {
        member = match point.len().max(free.len()) {
            0..=7 => deepest::<8>(point, free)?,
            8..=15 => deepest::<16>(point, free)?,
            _ => deepest::<MOST>(point, free)?,
        };
    }
    (least(&member) > enough).then_some(member)
}

/// The member whose least third component is largest.
fn deepest<const M: usize>(point: &[Vec3], free: &[Vec<Vec3>]) -> Option<Vec<Vec3>> {
    let mut slacks = Slacks::<M>::of(free.len());
    for (i, p) in point.iter().enumerate() {
        slacks.push(p.z, |j| free[j][i].z);
    }
    let (x, _) = slacks.largest_smallest(size(point))?;
    let mut member = point.to_vec();
    for (x, direction) in x.iter().zip(free) {
        member.iter_mut().zip(direction).for_each(|(p, d)| *p += *d * *x);
    }
    Some(member)
}

/// Members whose third components add up to the same, which are those of the whole family but for their size.
struct Family {
    member: Vec<Vec3>,
    free: Vec<Vec<Vec3>>,
    /// How much of the first member is in the present one, and in each direction: it must stay positive.
    share: f64,
    shares: Vec<f64>,
}

impl Family {
    fn of(start: Vec<Vec3>, free: &[Vec<Vec3>]) -> Self {
        let sum = |all: &[Vec3]| all.iter().map(|p| p.z).sum::<f64>();
        let (whole, scale) = (sum(&start), size(&start));
        let mut shares = vec![];
        let mut directions = vec![];
        for direction in free {
            let unit = scale / size(direction);
            let share = -sum(direction) * unit / whole;
            let one = |(d, p): (&Vec3, &Vec3)| *d * unit + *p * share;
            directions.push(direction.iter().zip(&start).map(one).collect());
            shares.push(share);
        }
        Self { member: start, free: directions, share: 1.0, shares }
    }

    fn opening(&self) -> f64 {
        opening(&self.member)
    }

    /// The barrier of a member; infinite outside.
    fn barrier(member: &[Vec3], share: f64, bound: f64) -> f64 {
        let inside = |p: &Vec3| p.z > 0.0 && room(p, bound) > 0.0;
        if share <= 0.0 || !member.iter().all(inside) {
            return f64::INFINITY;
        }
        member.iter().map(|p| -crate::elementary::ln(room(p, bound))).sum::<f64>()
            - crate::elementary::ln(share)
    }

    /// Moves to the analytic centre of the members within cones of this opening.
    fn centre(&mut self, bound: f64) {
        for _ in 0..MOST_NEWTON {
            let (slope, curvature) = self.slope(bound);
            let Some(step) = solved(curvature, slope.iter().map(|g| -g).collect()) else { return };
            let falls: f64 = step.iter().zip(&slope).map(|(s, g)| -s * g).sum();
            let before = Self::barrier(&self.member, self.share, bound);
            let mut part = 1.0;
            let moved = loop {
                let to = self.moved(&step, part);
                if Self::barrier(&to.0, to.1, bound) <= before - 0.1 * part * falls {
                    break Some(to);
                }
                part *= 0.5;
                if part < CONES_SHORTEST {
                    break None;
                }
            };
            let Some((member, share)) = moved else { return };
            (self.member, self.share) = (member, share);
            if falls < CONES_CENTRED {
                return;
            }
        }
    }

    fn moved(&self, step: &[f64], part: f64) -> (Vec<Vec3>, f64) {
        let (mut member, mut share) = (self.member.clone(), self.share);
        for ((x, direction), own) in step.iter().zip(&self.free).zip(&self.shares) {
            member.iter_mut().zip(direction).for_each(|(p, d)| *p += *d * (x * part));
            share += x * part * own;
        }
        (member, share)
    }

    /// First and second derivatives of the barrier.
    fn slope(&self, bound: f64) -> (Vec<f64>, Vec<Vec<f64>>) {
        let count = self.free.len();
        let (mut slope, mut curvature) = (vec![0.0; count], vec![vec![0.0; count]; count]);
        let paired = |a: &Vec3, b: &Vec3| 2.0 * (bound * bound * a.z * b.z - a.x * b.x - a.y * b.y);
        for (i, p) in self.member.iter().enumerate() {
            let room = room(p, bound);
            let first: Vec<f64> = self.free.iter().map(|d| paired(p, &d[i]) / room).collect();
            for j in 0..count {
                slope[j] -= first[j];
                for k in 0..count {
                    curvature[j][k] +=
                        first[j] * first[k] - paired(&self.free[j][i], &self.free[k][i]) / room;
                }
            }
        }
        for j in 0..count {
            slope[j] -= self.shares[j] / self.share;
            for k in 0..count {
                curvature[j][k] += self.shares[j] * self.shares[k] / (self.share * self.share);
            }
        }
        (slope, curvature)
    }
}

/// What is left of a cone: `μ² z² − x² − y²`, as a product that keeps its digits.
fn room(p: &Vec3, bound: f64) -> f64 {
    let across = (p.x * p.x + p.y * p.y).sqrt();
    (bound * p.z - across) * (bound * p.z + across)
}

/// Solves a symmetric positive definite system by Cholesky's method; directions in which nothing changes are left alone.
fn solved(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let count = right.len();
    let largest = (0..count).map(|j| matrix[j][j]).fold(0.0, f64::max);
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    for j in 0..count {
        for k in 0..=j {
            let known: f64 = (0..k).map(|l| matrix[j][l] * matrix[k][l]).sum();
            let left = matrix[j][k] - known;
            matrix[j][k] = if j > k {
                left / matrix[k][k]
            } else if left > f64::EPSILON * largest {
                left.sqrt()
            } else {
                f64::INFINITY
            };
        }
    }
    for j in 0..count {
        let known: f64 = (0..j).map(|l| matrix[j][l] * right[l]).sum();
        right[j] = (right[j] - known) / matrix[j][j];
    }
    for j in (0..count).rev() {
        let known: f64 = (j + 1..count).map(|l| matrix[l][j] * right[l]).sum();
        right[j] = (right[j] - known) / matrix[j][j];
    }
    right.iter().all(|x| x.is_finite()).then_some(right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elementary::sin_cos;

    /// What the answer is good for, relative to it.
    const EXACT: f64 = 1e-9;
    /// The worst of a grid of motions is this near to the worst of all: its steps of 0.01 rad, squared, with room.
    const GRID: f64 = 1e-3;

    /// What feet on a plane can do to each other along their lines: nothing to the body.
    fn squeezes(feet: &[Vec3]) -> Vec<Vec<Vec3>> {
        let mut all = vec![];
        for i in 0..feet.len() {
            for j in 0..i {
                let along = (feet[i] - feet[j]).unit().unwrap();
                let mut one = vec![Vec3::ZERO; feet.len()];
                (one[i], one[j]) = (along, -along);
                all.push(one);
            }
        }
        all
    }

    fn with(mut member: Vec<Vec3>, free: &[Vec<Vec3>], shares: &[f64]) -> Vec<Vec3> {
        for (share, direction) in shares.iter().zip(free) {
            member.iter_mut().zip(direction).for_each(|(p, d)| *p += *d * *share);
        }
        member
    }

    fn feet(count: u32) -> Vec<Vec3> {
        let at = |k: u32| {
            sin_cos(0.3 + f64::from(k * k) * 0.1 + std::f64::consts::TAU * f64::from(k) / f64::from(count))
        };
        (0..count)
            .map(|k| {
                let (y, x) = at(k);
                Vec3::new(x, y, 0.0)
            })
            .collect()
    }

    /// A force along the plane of T beside N across takes T/N at least, and no more where each foot takes its share of it.
    #[test]
    fn a_push_that_each_foot_shares_by_its_load_needs_its_own_quotient() {
        for count in 3..8 {
            let (feet, free) = {
                let feet = feet(count);
                let free = squeezes(&feet);
                (feet, free)
            };
            let member =
                (0..feet.len()).map(|i| Vec3::new(0.3, -0.4, 1.0) * (0.2 + 0.3 * i as f64)).collect();
            let shares: Vec<f64> = (0..free.len()).map(|j| 0.7 - 0.3 * j as f64).collect();
            let found = narrowest(&with(member, &free, &shares), &free);
            assert!((found - 0.5).abs() < EXACT, "{count} feet: {found}");
        }
    }

    /// A turn about the middle of feet on a circle of 1 m takes M/N.
    #[test]
    fn a_turn_needs_its_moment_over_the_radius() {
        let (feet, load) = (feet(4), [0.1, 0.4, 0.3, 0.2]);
        let free = squeezes(&feet);
        let turned = feet.iter().zip(load).map(|(r, z)| (Vec3::Z.cross(*r) * 0.6 + Vec3::Z) * z).collect();
        let found = narrowest(&with(turned, &free, &[0.5, -0.2, 0.3, 0.1, -0.7, 0.2]), &free);
        assert!((found - 0.6).abs() < EXACT, "{found}");
    }

    /// By duality the least friction of fixed loads is the largest quotient of the work of the forces and of `Σ z |v|`, over all motions along the plane.
    #[test]
    fn any_three_feet_need_what_the_worst_motion_asks() {
        let feet = feet(3);
        let free = squeezes(&feet);
        for case in 0..6 {
            let c = f64::from(case);
            let member: Vec<Vec3> = (0..3)
                .map(|i| {
                    let (s, k) = sin_cos(1.7 * c + 2.0 * i as f64);
                    Vec3::new(s, k, 0.5 + 0.2 * i as f64)
                })
                .collect();
            let found = narrowest(&member, &free);
            let asked = |vx: f64, vy: f64, w: f64| {
                let (mut work, mut most) = (0.0, 0.0);
                for (p, r) in member.iter().zip(&feet) {
                    let v = Vec3::new(vx, vy, 0.0) + Vec3::Z.cross(*r) * w;
                    work += p.dot(v);
                    most += p.z * v.norm();
                }
                work / most
            };
            let mut worst = 0.0_f64;
            for a in 0..600 {
                for b in 0..300 {
                    let ((sin, cos), (rise, flat)) = (
                        sin_cos(std::f64::consts::TAU * f64::from(a) / 600.0),
                        sin_cos(std::f64::consts::PI * (f64::from(b) / 300.0 - 0.5)),
                    );
                    worst = worst.max(asked(cos * flat, sin * flat, rise));
                }
            }
            assert!(
                found >= worst * (1.0 - EXACT) && found < worst * (1.0 + GRID),
                "case {case}: {found}, at least {worst}"
            );
        }
    }

    #[test]
    fn what_cannot_be_held_is_infinite_and_what_pushes_straight_needs_nothing() {
        let free = vec![vec![Vec3::X, -Vec3::X]];
        assert_eq!(
            narrowest(&[Vec3::Y, Vec3::Z], &free),
            f64::INFINITY,
            "a foot without load is pulled along"
        );
        assert_eq!(narrowest(&[Vec3::Z, Vec3::Z], &free), 0.0);
        let none: [[Vec3; 2]; 0] = [];
        assert_eq!(narrowest(&[Vec3::ZERO, Vec3::Z], &none), 0.0);
        assert_eq!(narrowest(&[], &none), 0.0);
    }

    /// Two parts that are pushed along by 1 and across by ½ and may be squeezed by any x: `√(x²/4 + 1)/(½ + x cos 30°)` is least at `x = 4 √3`, √13/6.5.
    #[test]
    fn members_of_any_size_are_looked_at() {
        let (sin, cos) = sin_cos(std::f64::consts::FRAC_PI_6);
        let free = [[Vec3::new(sin, 0.0, cos), Vec3::new(-sin, 0.0, cos)]];
        let found = narrowest(&[Vec3::new(0.0, 1.0, 0.5); 2], &free);
        assert!((found - 13.0_f64.sqrt() / 6.5).abs() < EXACT, "{found}");
    }
}
