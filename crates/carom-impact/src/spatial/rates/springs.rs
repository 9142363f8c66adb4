//! How contacts that hold more than they must share what they carry: as equal springs.
//!
//! Under equal and very small compliances a rigid body sinks in a little: the normal rate of a contact is in proportion to how far the body sinks in
//! there, the tangential rate of one that sticks to how far it is displaced across, and a contact that is lifted carries nothing beyond its base load:
//! `x = base + G λ` with the rows of the hypothesis's constraints as G. What slides brakes by its friction, which no spring feels. There are as many
//! unknowns as the body has motions, however many contacts it has.

use super::equations::{Equations, Hypothesis, Unknowns};
use crate::tolerance::{RANK, SLACK_TOLERANCE};
use carom_num::solve::{dot, solve_regular};
use carom_num::{Basis, Vec3};

/// After so many guesses of which contacts are lifted every set of them is tried.
const MOST_GUESSES: usize = 8;
/// Of so many contacts every set is tried, and of more where they are on several planes; of more on one plane those that it can leave.
const MOST_IN_ALL_SETS: usize = 8;
/// Contacts of one plane sink in as one: by a depth and two turns.
const PLANE: usize = 3;

/// The springs of a hypothesis.
pub(super) struct Springs<'u, const M: usize> {
    unknowns: &'u Unknowns,
    base: [f64; M],
    /// What small displacements of the bodies make of the unknowns.
    basis: Basis<M>,
    /// What each unknown does to the constraints, along the axes of the basis.
    does: [[f64; M]; M],
    /// What all of them must do beyond their base loads, along them.
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

/// Rates by equal springs where some contacts are lifted.
#[derive(Clone, Copy)]
pub(super) struct Rest<const M: usize> {
    /// The contacts that are lifted, one bit each.
    pub(super) lifted: u32,
    pub(super) sprung: Sprung<M>,
    /// True where none of them would carry.
    pub(super) rests: bool,
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
        let basis = self.displacements::<M>(unknowns);
        let (mut does, mut must) = ([[0.0; M]; M], [0.0; M]);
        for (a, axis) in basis.axes().iter().enumerate() {
            must[a] = dot(axis, &right);
            for (part, row) in axis.iter().zip(&equations.matrix).take(n) {
                does[a].iter_mut().zip(row).for_each(|(does, entry)| *does += part * entry);
            }
        }
        // Both sides are what displacements make: what is left of the right one, nothing does.
        let size = |v: &[f64; M]| v[..n].iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let met = size(&basis.left(right)) <= RANK * size(&right).max(equations.terms);
        met.then_some(Springs { unknowns, base, basis, does, must })
    }

    /// What small displacements of the bodies make of the unknowns.
    fn displacements<const M: usize>(&self, unknowns: &Unknowns) -> Basis<M> {
        let column = |(j, by): (usize, usize)| {
            let unit = [Vec3::X, Vec3::Y, Vec3::Z][by];
            unknowns.each::<M>(|(i, axis)| self.problem.operator[i][j].rows[axis].dot(unit))
        };
        let columns = || unknowns.of().map(column);
        let largest = columns().fold(0.0, |m: f64, c| m.max(dot(&c, &c))).sqrt();
        let mut basis = Basis::NONE;
        columns().for_each(|column| {
            basis.take(column, RANK * largest);
        });
        basis
    }
}

impl<const M: usize> Springs<'_, M> {
    /// The rates where these contacts, one bit each, are lifted; `None` where the others cannot do what the hypothesis says.
    pub(super) fn sprung(&self, lifted: u32) -> Option<Sprung<M>> {
        let carries = self.unknowns.each::<M>(|(i, _)| if lifted & (1 << i) == 0 { 1.0 } else { 0.0 });
        let axes = self.basis.axes();
        let mut matrix = [[0.0; M]; M];
        for (row, does) in matrix[..axes.len()].iter_mut().zip(&self.does) {
            let by: [f64; M] = std::array::from_fn(|c| carries[c] * does[c]);
            row.iter_mut().zip(axes).for_each(|(entry, axis)| *entry = dot(&by, axis));
        }
        let z = solve_regular(matrix, self.must, axes.len(), RANK)?;
        let sinks = std::array::from_fn(|k| axes.iter().zip(z).map(|(axis, z)| axis[k] * z).sum());
        Some(Sprung { x: std::array::from_fn(|k| self.base[k] + carries[k] * sinks[k]), sinks })
    }

    /// The rates where these contacts are lifted, and whether they rest so; `None` where another one would pull.
    fn rest(&self, lifted: u32) -> (u32, Option<Rest<M>>) {
        let Some(sprung) = self.sprung(lifted) else { return (lifted, None) };
        // What neither sinks in nor rises but for rounding stays as it is.
        let edge = SLACK_TOLERANCE * sprung.sinks.iter().fold(0.0, |m: f64, sink| m.max(sink.abs()));
        let below = |edge: f64| self.unknowns.pulled(&sprung.sinks.map(|sink| sink - edge));
        let pulled = below(-edge) | (below(edge) & lifted);
        let pushes = pulled & !lifted == 0;
        (pulled, pushes.then_some(Rest { lifted, sprung, rests: pulled == lifted }))
    }

    /// A way in which contacts may be lifted. It is guessed, from those that would pull if the guess before were true.
    pub(super) fn guessed(&self) -> Option<Rest<M>> {
        let (mut lifted, mut nearly) = (0, None);
        for _ in 0..MOST_GUESSES {
            let (pulled, rest) = self.rest(lifted);
            nearly = rest.or(nearly);
            if pulled == lifted {
                break;
            }
            lifted = pulled;
        }
        nearly
    }

    /// All ways in which contacts may be lifted and rest so. Where what slides brakes unequally they may be more than one, or none: then the one that is
    /// nearest to it, in which those that are lifted by too much would carry least.
    pub(super) fn all(&self) -> Vec<Rest<M>> {
        let (mut all, mut nearest) = (vec![], None::<(f64, Rest<M>)>);
        for rest in self.sets().into_iter().filter_map(|set| self.rest(set).1) {
            if rest.rests {
                all.push(rest);
                continue;
            }
            let too_far = self
                .unknowns
                .each::<M>(|(i, axis)| f64::from(u8::from(axis == 2 && rest.lifted >> i & 1 == 1)));
            let by = dot(&too_far, &rest.sprung.sinks.map(|sink| sink.max(0.0)));
            if nearest.is_none_or(|(least, _)| by < least) {
                nearest = Some((by, rest));
            }
        }
        if all.is_empty() {
            all.extend(nearest.map(|(_, rest)| rest));
        }
        all
    }

    /// Sets of contacts that may be lifted, one bit each.
    fn sets(&self) -> Vec<u32> {
        let of = self.unknowns.of().enumerate().filter(|(_, (_, axis))| *axis == 2);
        let holding: Vec<(usize, u32)> = of.map(|(k, (i, _))| (k, 1 << i)).collect();
        if holding.len() > MOST_IN_ALL_SETS {
            let planes = self.planes();
            if planes.axes().len() <= PLANE {
                return self.beyond_lines(&planes, &holding);
            }
        }
        let with =
            |sets: Vec<u32>, (_, bit): &(usize, u32)| sets.iter().flat_map(|set| [*set, set | bit]).collect();
        let mut sets: Vec<u32> = holding.iter().fold(vec![0], with);
        sets.sort_unstable();
        sets
    }

    /// How far the contacts that hold may sink in together.
    fn planes(&self) -> Basis<M> {
        let normal: [f64; M] = self.unknowns.each(|(_, of)| if of == 2 { 1.0 } else { 0.0 });
        let mut planes = Basis::NONE;
        for axis in self.basis.axes() {
            planes.take(std::array::from_fn(|k| axis[k] * normal[k]), RANK);
        }
        planes
    }

    /// The sets of lifted contacts that a plane which sinks in can leave: those on one side of a line. A line that parts them can be moved until it goes
    /// through two contacts. Each contact that holds is given by its unknown and its bit.
    fn beyond_lines(&self, planes: &Basis<M>, holding: &[(usize, u32)]) -> Vec<u32> {
        let part = |axis: usize, k: usize| planes.axes().get(axis).map_or(0.0, |axis| axis[k]);
        let places: Vec<(Vec3, u32)> =
            holding.iter().map(|&(k, bit)| (Vec3::new(part(0, k), part(1, k), part(2, k)), bit)).collect();
        let lines: Vec<Vec3> = match planes.axes().len() {
            // Of contacts in a row those before one of them and those behind it.
            2 => places.iter().map(|(at, _)| Vec3::Z.cross(*at)).collect(),
            PLANE => {
                let before = |n: usize| places[..n].iter();
                let pairs =
                    places.iter().enumerate().flat_map(|(n, one)| before(n).map(move |other| (one, other)));
                pairs.map(|((one, _), (other, _))| one.cross(*other)).collect()
            }
            _ => vec![],
        };
        let mut sets = vec![0];
        for line in lines {
            let on = |at: &Vec3| line.dot(*at).abs() <= RANK * line.norm() * at.norm();
            let touched: Vec<u32> = places.iter().filter(|(at, _)| on(at)).map(|(_, bit)| *bit).collect();
            let (first, others) =
                touched.split_first().map_or((0, 0), |(first, all)| (*first, all.iter().sum()));
            for side in [1.0, -1.0] {
                let beyond = places.iter().filter(|(at, _)| !on(at) && line.dot(*at) * side > 0.0);
                let beyond: u32 = beyond.map(|(_, bit)| *bit).sum();
                // The first that the line goes through is lifted or not, and so are the others on it.
                sets.extend([0, first, others, first | others].map(|with| beyond | with));
            }
        }
        sets.sort_unstable();
        sets.dedup();
        sets
    }
}
