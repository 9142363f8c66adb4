//! Rates that a hypothesis leaves open, where those of equal springs break an inequality: the member whose smallest slack is largest.
//!
//! Slacks are the normal rates above their base loads and, of sticking contacts, what is left of the friction cone, `μ r − |q|`. That is concave, so its
//! largest smallest value is found by cutting planes: the cone is replaced by planes that touch it, one more wherever the last point was outside.

use super::answer::Mode;
use super::equations::{Hypothesis, MOST, Unknowns};
use crate::tolerance::KNOWN_SLACK;
use carom_num::Vec3;
use carom_num::slack::Slacks;
use carom_num::solve::Solutions;

/// Cutting planes of all cones together: four of each to begin with, and so many in all, or so many more.
const MOST_CUTS: usize = 36;
const MORE_CUTS: usize = 4;
/// Cutting planes that are made, at most, where those within reach do not tell whether a member lies within the cones.
const MOST_ROUNDS: usize = 200;
/// A rate that is ample, in units of what one contact alone would need.
const AMPLE: f64 = 10.0;

/// A plane that touches the cone of contact `of` where friction points in this direction.
#[derive(Clone, Copy)]
struct Plane {
    of: usize,
    toward: [f64; 2],
}

impl<const N: usize> Hypothesis<'_, N> {
    /// The member of a family whose smallest slack is largest.
    pub(in crate::spatial) fn middle(&self) -> Option<[Vec3; N]> {
        let unknowns = self.unknowns();
        match unknowns.count {
            0..=24 => self.middle_sized::<24>(&unknowns),
            _ => self.middle_sized::<MOST>(&unknowns),
        }
    }

    fn middle_sized<const M: usize>(&self, unknowns: &Unknowns) -> Option<[Vec3; N]> {
        let family = self.family::<M>(unknowns)?;
        let unit = self.ample_rate();
        if family.freedom == 0 || unit == 0.0 {
            return Some(self.spread(&family.point, unknowns));
        }
        // In units of the ample rate, so that no unit of impulse or force decides.
        let rates = self.spread(&family.point, unknowns).map(|p| p / unit);
        let free: Vec<[Vec3; N]> =
            family.free[..family.freedom].iter().map(|d| self.direct(d, unknowns)).collect();
        let mut planes = vec![];
        for of in self.sticking() {
            for toward in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
                planes.push(Plane { of, toward });
            }
        }
        // The planes promise more than the cones give, and a later point may give less than an earlier one: the best is kept.
        let mut best = (f64::NEG_INFINITY, [0.0; M]);
        let most = MOST_CUTS.max(planes.len() + MORE_CUTS);
        for _ in 0..MOST_ROUNDS {
            let (z, promised) = self.most::<M>(&planes, &rates, &free)?;
            let at: [Vec3; N] = std::array::from_fn(|i| {
                free.iter().zip(&z).fold(rates[i], |p, (direction, z)| p + direction[i] * *z)
            });
            let (slack, of) = self.least_slack(&at, unit);
            if slack > best.0 {
                best = (slack, z);
            }
            let Some(of) = of.filter(|_| slack < promised - KNOWN_SLACK) else { break };
            if planes.len() > most {
                // It is not yet known whether any member lies within the cones: what the last point is farthest inside of makes room.
                if best.0 >= 0.0 || promised < 0.0 {
                    break;
                }
                let left = |plane: &Plane| self.left(plane, &at[plane.of]);
                let loosest =
                    (0..planes.len()).max_by(|a, b| left(&planes[*a]).total_cmp(&left(&planes[*b])));
                loosest.map(|k| planes.swap_remove(k));
            }
            let tangential = (at[of].x * at[of].x + at[of].y * at[of].y).sqrt();
            planes.push(Plane { of, toward: [at[of].x / tangential, at[of].y / tangential] });
        }
        Some(self.moved(&family, unknowns, &best.1.map(|z| z * unit)))
    }

    fn moved<const M: usize>(&self, family: &Solutions<M>, unknowns: &Unknowns, by: &[f64; M]) -> [Vec3; N] {
        let mut x = family.point;
        for (by, direction) in by.iter().zip(&family.free[..family.freedom]) {
            x.iter_mut().zip(direction).for_each(|(x, d)| *x += by * d);
        }
        self.spread(&x, unknowns)
    }

    fn sticking(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.problem.count).filter(|&i| self.guess[i].mode == Mode::Sticks)
    }

    fn holding(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.problem.count).filter(|&i| self.guess[i].holds)
    }

    /// The largest smallest slack over these planes, at most 1, and where.
    fn most<const M: usize>(
        &self,
        planes: &[Plane],
        rates: &[Vec3; N],
        free: &[[Vec3; N]],
    ) -> Option<([f64; M], f64)> {
        let unit = self.ample_rate();
        let mut slacks = Slacks::<M>::of(free.len());
        for i in self.holding() {
            slacks.push(rates[i].z - self.problem.base(i) / unit, |d| free[d][i].z);
        }
        for plane in planes {
            slacks.push(self.left(plane, &rates[plane.of]), |d| self.left(plane, &free[d][plane.of]));
        }
        slacks.largest_smallest(1.0)
    }

    /// How far inside of a plane a rate is.
    fn left(&self, &Plane { of, toward: [x, y] }: &Plane, rate: &Vec3) -> f64 {
        self.problem.friction[of] * rate.z - x * rate.x - y * rate.y
    }

    /// The smallest slack, and the contact whose cone it is of, if it is one of a cone.
    fn least_slack(&self, rates: &[Vec3; N], unit: f64) -> (f64, Option<usize>) {
        let pushes = self.holding().map(|i| (rates[i].z - self.problem.base(i) / unit, None));
        let cones = self.sticking().map(|i| {
            let p = rates[i];
            (self.problem.friction[i] * p.z - (p.x * p.x + p.y * p.y).sqrt(), Some(i))
        });
        let smaller = |a: (f64, Option<usize>), b: (f64, Option<usize>)| if b.0 < a.0 { b } else { a };
        pushes.chain(cones).fold((1.0, None), smaller)
    }

    /// A rate that is ample for every contact.
    fn ample_rate(&self) -> f64 {
        let own = |i: usize| {
            let (w, d) = (&self.problem.operator[i][i], self.problem.drive[i]);
            let alone =
                |drive: f64, response: f64| if response > 0.0 { (drive / response).abs() } else { 0.0 };
            let [a, b, c] = w.rows;
            alone(d.x, a.x).max(alone(d.y, b.y)).max(alone(d.z, c.z)).max(self.problem.base(i))
        };
        AMPLE * (0..self.problem.count).map(own).fold(0.0, f64::max)
    }
}
