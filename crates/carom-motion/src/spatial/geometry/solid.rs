//! Volume, mass centre and inertia of a solid within a closed surface of triangles; what is wrong with such a surface.

use crate::tolerance::EMPTY_VOLUME;
use carom_num::{Mat3, Vec3};
use std::collections::{BTreeMap, VecDeque};
use thiserror::Error;

/// A surface of triangles.
///
/// # Example
/// The corner of a cube of 1 m, cut off along three diagonals of its faces, has a sixth of its volume.
/// ```
/// use carom_motion::spatial::Mesh;
/// use carom_num::Vec3;
/// let vertices = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
/// let corner = Mesh { vertices, facets: vec![[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]] };
/// assert!((corner.solid().unwrap().volume - 1.0 / 6.0).abs() < 1e-15);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners \[m\].
    pub vertices: Vec<Vec3>,
    /// The corners of each facet, counter-clockwise as seen from outside.
    pub facets: Vec<[usize; 3]>,
}

/// What keeps a surface from enclosing a solid.
///
/// # Example
/// Without its last facet the surface is open along three sides.
/// ```
/// use carom_motion::spatial::{Mesh, MeshProblem};
/// use carom_num::Vec3;
/// let vertices = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
/// let open = Mesh { vertices, facets: vec![[0, 2, 1], [0, 3, 2], [0, 1, 3]] };
/// let problems = open.solid().unwrap_err();
/// assert_eq!(problems.iter().filter(|p| matches!(p, MeshProblem::Open { .. })).count(), 3);
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MeshProblem {
    /// A place that is not finite.
    #[error("vertex {vertex} is not at a finite place")]
    NotFinite {
        /// Which one.
        vertex: usize,
    },
    /// A side of a facet at which there is no other one.
    #[error(
        "the surface is open at facet {facet}: no other facet is beside its side from {from:.6?} to {to:.6?} m"
    )]
    Open {
        /// Which facet.
        facet: usize,
        /// One end of the side \[m\].
        from: [f64; 3],
        /// The other \[m\].
        to: [f64; 3],
    },
    /// A facet whose neighbours run the other way round.
    #[error("facet {facet} is turned round: its corners run clockwise as seen from outside")]
    Flipped {
        /// Which facet.
        facet: usize,
    },
    /// The facets at a side do not pair.
    #[error(
        "{count} facets meet at one side of facet {facet}, from {from:.6?} to {to:.6?} m: they do not pair"
    )]
    Tangled {
        /// The first of them.
        facet: usize,
        /// How many.
        count: usize,
        /// One end of the side \[m\].
        from: [f64; 3],
        /// The other \[m\].
        to: [f64; 3],
    },
    /// A surface with one side only.
    #[error("the surface has one side only, as Möbius' strip: it has no inside")]
    OneSided,
    /// No volume.
    #[error("it encloses {volume} m³: a body needs a volume")]
    Empty {
        /// The volume \[m³\].
        volume: f64,
    },
}

/// A homogeneous solid of density 1.
///
/// # Example
/// The centre of a tetrahedron is the mean of its corners.
/// ```
/// use carom_motion::spatial::{Mesh, Solid};
/// use carom_num::Vec3;
/// let vertices = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
/// let facets = vec![[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];
/// let Solid { centre, .. } = Mesh { vertices, facets }.solid().unwrap();
/// assert!((centre - Vec3::new(0.25, 0.25, 0.25)).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// Volume \[m³\].
    pub volume: f64,
    /// Its centre \[m\].
    pub centre: Vec3,
    /// Moments of inertia about it, over the density [m⁵].
    pub inertia: Mat3,
}

/// A facet that has a side, and whether the side runs from its lower to its higher corner there.
type Use = (usize, bool);

/// The inertia that belongs to the integral of the dyads of place, about the mass centre.
pub(super) fn inertia_of(about: Mat3) -> Mat3 {
    let [x, y, z] = about.rows;
    let trace = x.x + y.y + z.z;
    let inertia = Mat3::diagonal(trace, trace, trace) - about;
    // Symmetric to the last digit.
    (inertia + inertia.transposed()) * 0.5
}

impl Mesh {
    /// Volume, centre and inertia, exact but for rounding: sums over the tetrahedra between the mean of the vertices and each facet (by the
    /// divergence theorem).
    ///
    /// ```text
    /// 6 V = Σ a·(b×c)     24 V r̄ = Σ a·(b×c) (a + b + c)     120 ∫ r rᵀ dV = Σ a·(b×c) (a aᵀ + b bᵀ + c cᵀ + s sᵀ),  s = a + b + c
    /// ```
    ///
    /// A surface whose facets all run clockwise as seen from outside encloses the same solid. A facet with two corners in one place has no area, and counts for nothing.
    ///
    /// # Errors
    /// All problems: sides without a neighbour, some facets turned round, no volume.
    ///
    /// # Limits
    /// A surface that cuts itself counts what it encloses twice.
    ///
    /// # Example
    /// Of the corner of a cube: `∫ x² dV = 1/60` about the corner, so that `J = 2 (1/60 − 1/96)` about the
    /// centre.
    /// ```
    /// use carom_motion::spatial::Mesh;
    /// use carom_num::Vec3;
    /// let vertices = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
    /// let facets = vec![[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];
    /// let solid = Mesh { vertices, facets }.solid().unwrap();
    /// assert!((solid.inertia.rows[0].x - 2.0 * (1.0 / 60.0 - 1.0 / 96.0)).abs() < 1e-15);
    /// ```
    pub fn solid(&self) -> Result<Solid, Vec<MeshProblem>> {
        let problems = self.problems();
        if !problems.is_empty() {
            return Err(problems);
        }
        let solid = self.summed();
        let [low, high] = self.extent();
        let [x, y, z] = (high - low).to_array();
        let volume = solid.volume;
        if !(volume.abs() > EMPTY_VOLUME * x * y * z && volume.is_finite()) {
            return Err(vec![MeshProblem::Empty { volume }]);
        }
        if volume < 0.0 {
            return Ok(Solid { volume: -volume, inertia: solid.inertia * -1.0, ..solid });
        }
        Ok(solid)
    }

    /// Corners of the box around it.
    fn extent(&self) -> [Vec3; 2] {
        let all = |start: f64, of: fn(f64, f64) -> f64| {
            let start = Vec3::new(start, start, start);
            let both = |a: Vec3, b: &Vec3| Vec3::new(of(a.x, b.x), of(a.y, b.y), of(a.z, b.z));
            self.vertices.iter().fold(start, both)
        };
        [all(f64::INFINITY, f64::min), all(f64::NEG_INFINITY, f64::max)]
    }

    fn summed(&self) -> Solid {
        let [low, high] = self.extent();
        let from = (low + high) * 0.5;
        let (mut six, mut first, mut second) = (0.0, Vec3::ZERO, Mat3::ZERO);
        for facet in &self.facets {
            let [a, b, c] = facet.map(|i| self.vertices[i] - from);
            let (d, s) = (a.dot(b.cross(c)), a + b + c);
            six += d;
            first += s * d;
            let dyads = Mat3::dyad(a, a) + Mat3::dyad(b, b) + Mat3::dyad(c, c) + Mat3::dyad(s, s);
            second = second + dyads * d;
        }
        let volume = six / 6.0;
        let offset = first / (4.0 * six);
        let about = second * (1.0 / 120.0) - Mat3::dyad(offset, offset) * volume;
        Solid { volume, centre: from + offset, inertia: inertia_of(about) }
    }

    fn problems(&self) -> Vec<MeshProblem> {
        let lost = self.vertices.iter().enumerate().filter(|(_, r)| !r.is_finite());
        let lost: Vec<MeshProblem> = lost.map(|(vertex, _)| MeshProblem::NotFinite { vertex }).collect();
        if !lost.is_empty() {
            return lost;
        }
        let uses = self.uses();
        let ends = |(a, b): &(usize, usize)| [a, b].map(|i| self.vertices[*i].to_array());
        let mut problems = vec![];
        for (side, facets) in &uses {
            let ([from, to], facet) = (ends(side), facets[0].0);
            let up = facets.iter().filter(|(_, up)| *up).count();
            match facets.len() {
                1 => problems.push(MeshProblem::Open { facet, from, to }),
                2 => {}
                count if 2 * up == count => {}
                count => problems.push(MeshProblem::Tangled { facet, count, from, to }),
            }
        }
        problems.extend(self.flipped(&uses));
        problems
    }

    /// Which facets have each side.
    fn uses(&self) -> BTreeMap<(usize, usize), Vec<Use>> {
        let mut uses: BTreeMap<(usize, usize), Vec<Use>> = BTreeMap::new();
        // One with two corners in one place runs along its only side and back.
        let whole = |(_, [a, b, c]): &(usize, &[usize; 3])| a != b && b != c && c != a;
        for (facet, [a, b, c]) in self.facets.iter().enumerate().filter(whole) {
            for (i, j) in [(*a, *b), (*b, *c), (*c, *a)] {
                uses.entry((i.min(j), i.max(j))).or_default().push((facet, i < j));
            }
        }
        uses
    }

    /// The facets that run the other way round than most of the piece of surface they belong to.
    fn flipped(&self, uses: &BTreeMap<(usize, usize), Vec<Use>>) -> Vec<MeshProblem> {
        let mut neighbours: Vec<Vec<(usize, bool)>> = vec![vec![]; self.facets.len()];
        for pair in uses.values() {
            if let [(f, up), (g, other)] = pair[..] {
                neighbours[f].push((g, up == other));
                neighbours[g].push((f, up == other));
            }
        }
        let mut turned: Vec<Option<bool>> = vec![None; self.facets.len()];
        let mut problems = vec![];
        for start in 0..self.facets.len() {
            if turned[start].is_some() {
                continue;
            }
            turned[start] = Some(false);
            let (mut piece, mut waiting) = (vec![start], VecDeque::from([start]));
            while let Some(facet) = waiting.pop_front() {
                let own = turned[facet] == Some(true);
                for &(other, disagrees) in &neighbours[facet] {
                    match turned[other] {
                        None => {
                            turned[other] = Some(own != disagrees);
                            piece.push(other);
                            waiting.push_back(other);
                        }
                        // A piece that comes back to itself the other way round has one side only, as Möbius's strip.
                        Some(known) if known != (own != disagrees) => return vec![MeshProblem::OneSided],
                        Some(_) => {}
                    }
                }
            }
            // Nothing says which of the two ways round is right: the fewer facets are taken to be wrong.
            let few = 2 * piece.iter().filter(|f| turned[**f] == Some(true)).count() <= piece.len();
            let mut odd: Vec<usize> = piece.into_iter().filter(|f| turned[*f] == Some(few)).collect();
            odd.sort_unstable();
            problems.extend(odd.into_iter().map(|facet| MeshProblem::Flipped { facet }));
        }
        problems
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sums of four terms of order 1: the last digit of what is below 1/2.
    const LAST_DIGIT: f64 = 1e-16;

    /// The tetrahedron between the origin and the unit vectors.
    fn corner() -> Mesh {
        let vertices = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
        Mesh { vertices, facets: vec![[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]] }
    }

    #[test]
    fn a_corner_has_a_sixth_of_a_cube() {
        let solid = corner().solid().unwrap();
        assert!((solid.volume - 1.0 / 6.0).abs() < LAST_DIGIT, "{solid:?}");
        assert!((solid.centre - Vec3::new(0.25, 0.25, 0.25)).norm() < LAST_DIGIT, "{solid:?}");
        // ∫ x² = 1/60 and ∫ x y = 1/120 about the corner, less V r̄² of 1/96.
        let (square, product) = (1.0 / 60.0 - 1.0 / 96.0, 1.0 / 120.0 - 1.0 / 96.0);
        let [x, ..] = solid.inertia.rows;
        assert!((x - Vec3::new(2.0 * square, -product, -product)).norm() < LAST_DIGIT, "{solid:?}");
    }

    #[test]
    fn a_surface_turned_inside_out_encloses_the_same() {
        let mut turned = corner();
        turned.facets.iter_mut().for_each(|f| f.swap(0, 1));
        assert_eq!(turned.solid().unwrap(), corner().solid().unwrap());
    }

    /// Where a triangle's side has shrunk to a point, its other two sides are one, and the facets beyond them neighbours.
    #[test]
    fn a_facet_without_length_opens_no_surface() {
        for facet in [[0, 1, 1], [1, 1, 0], [3, 2, 3], [2, 2, 2]] {
            let mut more = corner();
            more.facets.insert(1, facet);
            assert_eq!(more.solid().unwrap(), corner().solid().unwrap(), "with {facet:?}");
        }
        let mut open = corner();
        (open.facets[3], open.facets[2]) = ([1, 2, 2], [0, 0, 1]);
        let problems = open.solid().unwrap_err();
        let sides = problems.iter().filter(|p| matches!(p, MeshProblem::Open { .. })).count();
        assert_eq!(sides, 4, "two facets with a side in common are open at four: {problems:?}");
    }

    #[test]
    fn every_problem_of_a_surface_is_named() {
        let mut open = corner();
        open.facets.remove(3);
        let problems = open.solid().unwrap_err();
        assert_eq!(problems.len(), 3, "three sides: {problems:?}");
        assert!(problems.iter().all(|p| matches!(p, MeshProblem::Open { .. })), "{problems:?}");
        let mut flipped = corner();
        flipped.facets[2].swap(0, 1);
        assert_eq!(flipped.solid().unwrap_err(), [MeshProblem::Flipped { facet: 2 }]);
        let mut lost = corner();
        lost.vertices[1].x = f64::NAN;
        assert_eq!(lost.solid().unwrap_err(), [MeshProblem::NotFinite { vertex: 1 }]);
        let mut flat = corner();
        flat.vertices[3] = Vec3::new(0.3, 0.3, 0.0);
        assert!(matches!(flat.solid().unwrap_err()[..], [MeshProblem::Empty { .. }]));
        let mut three = corner();
        three.vertices.push(-Vec3::Z);
        three.facets.push([0, 1, 4]);
        assert!(
            three.solid().unwrap_err().iter().any(|p| matches!(p, MeshProblem::Tangled { count: 3, .. }))
        );
    }
}
