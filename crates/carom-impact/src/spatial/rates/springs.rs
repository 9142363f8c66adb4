//! How contacts that hold more than they must share what they carry: as equal springs.
//!
//! Under equal and very small compliances a rigid body sinks in a little: the normal rate of a contact is in proportion to how far the body sinks in
//! there, the tangential rate of one that sticks to how far it is displaced across, and a contact that is lifted carries nothing beyond its base load:
//! `x = base + G λ` with the rows of the hypothesis's constraints as G. What slides brakes by its friction, which no spring feels. There are as many
//! unknowns as the body has motions, however many contacts it has.

use super::equations::{Equations, Hypothesis, Unknowns};
use crate::tolerance::RANK;
use carom_num::Vec3;
use carom_num::solve::{dot, solve_regular};

/// After so many guesses of which contacts are lifted every set of them is tried.
const MOST_GUESSES: usize = 8;

/// The springs of a hypothesis.
pub(super) struct Springs<'u, const M: usize> {
    unknowns: &'u Unknowns,
    base: [f64; M],
    /// What small displacements of the bodies make of the unknowns, orthonormal, and how many they are.
    axes: [[f64; M]; M],
    rank: usize,
    /// What each unknown does to the constraints, along the axes.
    does: [[f64; M]; M],
    /// What all of them must do beyond their base loads, along the axes.
    must: [f64; M],
}

/// Rates by equal springs.
#[derive(Clone, Copy)]
pub(super) struct Sprung<const M: usize> {
    /// The unknowns.
    pub(super) x: [f64; M],
    /// By how much each would grow beyond its base load if every contact were pressed in or pulled out.
    pub(super) sinks: [f64; M],
}

impl<const N: usize> Hypothesis<'_, N> {
    /// The springs that meet these equations; `None` where nothing can.
    pub(super) fn springs<'u, const M: usize>(
        &self,
        unknowns: &'u Unknowns,
        equations: &Equations<M>,
    ) -> Option<Springs<'u, M>> {
        let n = unknowns.count;
        let base = unknowns.each(|(i, axis)| if axis == 2 { self.problem.base(i) } else { 0.0 });
        let mut right = equations.right;
        for (right, row) in right.iter_mut().zip(&equations.matrix).take(n) {
            *right -= dot(row, &base);
        }
        let (axes, rank) = self.displacements::<M>(unknowns);
        let (mut does, mut must) = ([[0.0; M]; M], [0.0; M]);
        for (a, axis) in axes[..rank].iter().enumerate() {
            must[a] = dot(axis, &right);
            for (part, row) in axis.iter().zip(&equations.matrix).take(n) {
                does[a].iter_mut().zip(row).for_each(|(does, entry)| *does += part * entry);
            }
        }
        // Both sides are what displacements make: what is left of the right one, nothing does.
        let left = (0..n).map(|k| right[k] - (0..rank).map(|a| axes[a][k] * must[a]).sum::<f64>());
        let largest = right[..n].iter().fold(0.0, |m: f64, v| m.max(v.abs())).max(equations.terms);
        let met = left.fold(0.0, |m: f64, v| m.max(v.abs())) <= RANK * largest;
        met.then_some(Springs { unknowns, base, axes, rank, does, must })
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

impl<const M: usize> Springs<'_, M> {
    /// The rates where these contacts, one bit each, are lifted; `None` where the others cannot do what the hypothesis says.
    pub(super) fn sprung(&self, lifted: u32) -> Option<Sprung<M>> {
        let carries = self.unknowns.each::<M>(|(i, _)| if lifted & (1 << i) == 0 { 1.0 } else { 0.0 });
        let mut matrix = [[0.0; M]; M];
        for (row, does) in matrix[..self.rank].iter_mut().zip(&self.does) {
            let by: [f64; M] = std::array::from_fn(|c| carries[c] * does[c]);
            row.iter_mut().zip(&self.axes[..self.rank]).for_each(|(entry, axis)| *entry = dot(&by, axis));
        }
        let z = solve_regular(matrix, self.must, self.rank, RANK)?;
        let sinks = std::array::from_fn(|k| (0..self.rank).map(|a| self.axes[a][k] * z[a]).sum());
        Some(Sprung { x: std::array::from_fn(|k| self.base[k] + carries[k] * sinks[k]), sinks })
    }

    /// The rates where these contacts are lifted, if they are those that would pull.
    fn resting(&self, lifted: u32) -> Result<Sprung<M>, Option<u32>> {
        let sprung = self.sprung(lifted).ok_or(None)?;
        let pulled = self.unknowns.pulled(&sprung.sinks);
        if pulled == lifted { Ok(sprung) } else { Err(Some(pulled)) }
    }

    /// A set of lifted contacts, one bit each, of which exactly those that are lifted would pull, and the rates. It is guessed.
    pub(super) fn guessed(&self) -> Option<(u32, Sprung<M>)> {
        let mut lifted = 0;
        for _ in 0..MOST_GUESSES {
            match self.resting(lifted) {
                Ok(sprung) => return Some((lifted, sprung)),
                Err(pulled) => lifted = pulled?,
            }
        }
        None
    }

    /// All such sets. Where what slides brakes unequally there may be more than one of them.
    pub(super) fn all(&self) -> impl Iterator<Item = (u32, Sprung<M>)> {
        let holding = self.unknowns.pulled(&self.unknowns.each::<M>(|_| -1.0));
        let mut next = Some(0);
        let sets = std::iter::from_fn(move || {
            let set = next?;
            // The next larger number whose bits are all of contacts that hold.
            next = Some((set | !holding).wrapping_add(1) & holding).filter(|&next| next != 0);
            Some(set)
        });
        sets.filter_map(|set| Some((set, self.resting(set).ok()?)))
    }
}
