//! How contacts that hold more than they must share what they carry: as equal springs.
//!
//! Under equal and very small compliances a rigid body sinks in a little: the normal rate of a contact is in proportion to how far the body sinks in
//! there, the tangential rate of one that sticks to how far it is displaced across, and a contact that is lifted carries nothing beyond its base load:
//! `x = base + G λ` with the rows of the hypothesis's constraints as G. What slides brakes by its friction, which no spring feels. There are as many
//! unknowns as the body has motions, however many contacts it has.

use super::equations::{Hypothesis, Unknowns};
use crate::tolerance::RANK;
use carom_num::Vec3;
use carom_num::solve::{dot, solve_regular};

/// After so many guesses of which contacts are lifted every set of them is tried.
const MOST_GUESSES: usize = 8;

/// Rates by equal springs.
#[derive(Clone, Copy)]
pub(super) struct Sprung<const M: usize> {
    /// The unknowns.
    pub(super) x: [f64; M],
    /// By how much each would grow beyond its base load if every contact were pressed in or pulled out.
    pub(super) sinks: [f64; M],
}

impl<const N: usize> Hypothesis<'_, N> {
    /// The rates where these contacts, one bit each, are lifted; `None` where the others cannot do what the hypothesis says.
    pub(super) fn sprung<const M: usize>(&self, unknowns: &Unknowns, lifted: u32) -> Option<Sprung<M>> {
        let n = unknowns.count;
        let equations = self.equations::<M>(unknowns);
        let mut right = equations.right;
        let base = unknowns.each(|(i, axis)| if axis == 2 { self.problem.base(i) } else { 0.0 });
        let carries = unknowns.each::<M>(|(i, _)| if lifted & (1 << i) == 0 { 1.0 } else { 0.0 });
        for (right, row) in right.iter_mut().zip(&equations.matrix).take(n) {
            *right -= dot(row, &base);
        }
        let (axes, rank) = self.displacements::<M>(unknowns);
        // Both sides are what displacements make: along these they say all.
        let mut matrix = [[0.0; M]; M];
        let mut along = [0.0; M];
        for a in 0..rank {
            along[a] = dot(&axes[a], &right);
            let row: [f64; M] = std::array::from_fn(|c| {
                carries[c] * (0..n).map(|k| axes[a][k] * equations.matrix[k][c]).sum::<f64>()
            });
            for b in 0..rank {
                matrix[a][b] = dot(&row, &axes[b]);
            }
        }
        let left = (0..n).map(|k| right[k] - (0..rank).map(|a| axes[a][k] * along[a]).sum::<f64>());
        let largest = right[..n].iter().fold(0.0, |m: f64, v| m.max(v.abs())).max(equations.terms);
        if left.fold(0.0, |m: f64, v| m.max(v.abs())) > RANK * largest {
            return None;
        }
        let z = solve_regular(matrix, along, rank, RANK)?;
        let sinks = std::array::from_fn(|k| (0..rank).map(|a| axes[a][k] * z[a]).sum());
        let x = std::array::from_fn(|k| base[k] + carries[k] * sinks[k]);
        Some(Sprung { x, sinks })
    }

    /// The contacts that are lifted, one bit each, and the rates; `None` where no set of them is. `all` says whether every set may be tried.
    pub(super) fn resting<const M: usize>(&self, unknowns: &Unknowns, all: bool) -> Option<(u32, Sprung<M>)> {
        let ask = |lifted: u32| {
            let sprung = self.sprung::<M>(unknowns, lifted)?;
            Some((unknowns.pulled(&sprung.sinks), sprung))
        };
        let mut lifted = 0;
        for _ in 0..MOST_GUESSES {
            let Some((pulled, sprung)) = ask(lifted) else { break };
            if pulled == lifted {
                return Some((lifted, sprung));
            }
            lifted = pulled;
        }
        let holding =
            (0..self.problem.count).filter(|&i| self.guess[i].holds).fold(0, |bits, i| bits | 1 << i);
        let sets = (0..if all { 1u32 << self.problem.count } else { 0 }).filter(|set| set & !holding == 0);
        sets.filter_map(|set| ask(set).filter(|(pulled, _)| *pulled == set)).next()
    }

    /// What small displacements of the bodies make of the unknowns, as orthonormal axes, and how many they are.
    fn displacements<const M: usize>(&self, unknowns: &Unknowns) -> ([[f64; M]; M], usize) {
        let of = unknowns.of();
        let column = |&(j, by): &(usize, usize)| {
            let unit = [Vec3::X, Vec3::Y, Vec3::Z][by];
            unknowns.each::<M>(|(i, axis)| self.problem.operator[i][j].rows[axis].dot(unit))
        };
        let (mut axes, mut rank) = ([[0.0; M]; M], 0);
        let columns: Vec<[f64; M]> = of.iter().map(column).collect();
        let largest = columns.iter().fold(0.0, |m: f64, c| m.max(dot(c, c))).sqrt();
        for mut left in columns {
            // Twice is enough for rounding.
            for _ in 0..2 {
                for axis in &axes[..rank] {
                    let along = dot(&left, axis);
                    left.iter_mut().zip(axis).for_each(|(l, a)| *l -= along * a);
                }
            }
            let length = dot(&left, &left).sqrt();
            if length > RANK * largest && rank < M {
                axes[rank] = left.map(|l| l / length);
                rank += 1;
            }
        }
        (axes, rank)
    }
}
