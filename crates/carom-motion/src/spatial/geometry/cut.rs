//! A solid within a surface that is not convex, cut into convex pieces along the planes of its facets.
//!
//! The convex hull is cut by the plane of a facet that goes through it, and so is what becomes of it, until no facet goes through any part. A part is then all inside or all outside. Of planes that
//! may cut a part the one is taken that goes through the fewest other facets.
//!
//! # Source
//! Binary space partitioning: H. Fuchs, Z. M. Kedem and B. F. Naylor, SIGGRAPH (1980) 124.

use super::hull::{HullProblem, newell};
use super::plane::Plane;
use super::polyhedron::{Face, Polyhedron};
use super::solid::{Mesh, MeshProblem};
use carom_num::Vec3;
use carom_num::elementary::atan2;
use std::f64::consts::TAU;
use thiserror::Error;

/// Planes that are tried for a part, those of the largest facets first.
const MOST_PLANES: usize = 64;
/// Parts that are looked at, for each piece that is allowed.
const PARTS_A_PIECE: usize = 16;
/// A facet goes through a part where it is this many times the flatness inside.
const INSIDE: f64 = 2.0;

/// Why a surface is not cut into pieces.
///
/// # Example
/// A tetrahedron is one piece, and none is too few.
/// ```
/// use carom_motion::spatial::{Mesh, PiecesProblem};
/// use carom_num::Vec3;
/// let vertices = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
/// let corner = Mesh { vertices, facets: vec![[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]] };
/// assert_eq!(corner.pieces(1e-9, 0), Err(PiecesProblem::TooMany { most: 0 }));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PiecesProblem {
    /// It encloses no solid.
    #[error("{0}")]
    Surface(MeshProblem),
    /// It has no hull.
    #[error("{0}")]
    Hull(HullProblem),
    /// More than are wanted.
    #[error("it makes more than {most} convex pieces")]
    TooMany {
        /// How many are wanted.
        most: usize,
    },
    /// What is cut out is not what the surface encloses.
    #[error(
        "its convex pieces have {pieces:.6e} m³ and it encloses {solid:.6e} m³: shells of it reach into each other, or faces of it are almost on one plane"
    )]
    Volume {
        /// Of the pieces \[m³\].
        pieces: f64,
        /// Of the solid \[m³\].
        solid: f64,
    },
}

/// A part of the hull, and what of the facets is in it.
struct Part {
    cell: Polyhedron,
    facets: Vec<Vec<Vec3>>,
}

fn plane_of(facet: &[Vec3]) -> Option<Plane> {
    let normal = newell(facet).unit()?;
    Some(Plane::of_unit(normal, normal.dot(facet[0])))
}

/// A facet lies on the plane.
fn holds(plane: &Plane, facet: &[Vec3], flatness: f64) -> bool {
    facet.iter().all(|r| plane.height(*r).abs() <= flatness)
}

/// The plane goes through a facet.
fn crosses(plane: &Plane, facet: &[Vec3], flatness: f64) -> bool {
    let heights = || facet.iter().map(|r| plane.height(*r));
    heights().any(|height| height > flatness) && heights().any(|height| height < -flatness)
}

/// What of facets goes through a cell.
fn through(cell: &Polyhedron, facets: &[Vec<Vec3>], flatness: f64) -> Vec<Vec<Vec3>> {
    let within = |face: &Face| {
        let heights = face.corners.iter().map(|i| face.normal.dot(cell.vertices()[*i]));
        Plane::of_unit(face.normal, heights.fold(f64::NEG_INFINITY, f64::max) - INSIDE * flatness)
    };
    let faces: Vec<Plane> = cell.faces().iter().map(within).collect();
    let clipped = |facet: &Vec<Vec3>| faces.iter().fold(facet.clone(), |facet, face| face.behind(&facet));
    facets.iter().map(clipped).filter(|facet| facet.len() > 2 && newell(facet).norm() > 0.0).collect()
}

impl Part {
    /// The plane to cut it by; `None` where no facet goes through it.
    fn plane(&self, flatness: f64) -> Option<Plane> {
        let mut order: Vec<(f64, &Vec<Vec3>)> =
            self.facets.iter().map(|facet| (newell(facet).norm(), facet)).collect();
        order.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut cuts: Vec<Plane> = vec![];
        for (_, facet) in order {
            if cuts.len() < MOST_PLANES && !cuts.iter().any(|cut| holds(cut, facet, flatness)) {
                cuts.extend(plane_of(facet));
            }
        }
        let crossed = |cut: &Plane| self.facets.iter().filter(|facet| crosses(cut, facet, flatness)).count();
        cuts.into_iter().min_by_key(crossed)
    }
}

impl Mesh {
    /// The solid that it encloses as convex pieces, at most so many. Pieces that are convex together are one.
    ///
    /// # Errors
    /// [`PiecesProblem`]: the first problem.
    ///
    /// # Limits
    /// Hollows that are less deep than twice the flatness \[m\] may be filled.
    ///
    /// # Example
    /// A bracket, of two legs of 2 m × 1 m × 1 m one of which stands on the end of the other.
    /// ```
    /// use carom_motion::spatial::Mesh;
    /// use carom_num::Vec3;
    /// let profile = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    /// let at = |z: f64| profile.map(|(x, y)| Vec3::new(x, y, z));
    /// let mut facets: Vec<[usize; 3]> = (0..6).flat_map(|k| [[k, (k + 1) % 6, k + 6], [(k + 1) % 6, (k + 1) % 6 + 6, k + 6]]).collect();
    /// for [a, b, c] in [[0, 1, 3], [1, 2, 3], [0, 3, 5], [3, 4, 5]] {
    ///     facets.extend([[a, c, b], [a + 6, b + 6, c + 6]]);
    /// }
    /// let bracket = Mesh { vertices: [at(0.0), at(1.0)].concat(), facets };
    /// let pieces = bracket.pieces(1e-9, 8)?;
    /// assert_eq!(pieces.len(), 2);
    /// let volume: f64 = pieces.iter().map(|piece| piece.solid().unwrap().volume).sum();
    /// assert!((volume - 3.0).abs() < 1e-12);
    /// # Ok::<(), carom_motion::spatial::PiecesProblem>(())
    /// ```
    pub fn pieces(&self, flatness: f64, most: usize) -> Result<Vec<Polyhedron>, PiecesProblem> {
        let first = |problems: Vec<MeshProblem>| {
            PiecesProblem::Surface(problems.into_iter().next().unwrap_or(MeshProblem::OneSided))
        };
        let solid = self.solid().map_err(first)?;
        let hull = Polyhedron::of_points(&self.vertices, flatness).map_err(|problems| {
            let first = problems.into_iter().next();
            PiecesProblem::Hull(first.unwrap_or(HullProblem::Unclear { flatness }))
        })?;
        let pieces = self.inside(hull.clone(), flatness, most)?;
        let volume: f64 = pieces.iter().map(volume).sum();
        if (volume - solid.volume).abs() > flatness * size(&pieces).powi(2) {
            return Err(PiecesProblem::Volume { pieces: volume, solid: solid.volume });
        }
        let pieces = super::aligned::aligned(&hull, &joined(pieces, flatness), flatness);
        if pieces.len() > most { Err(PiecesProblem::TooMany { most }) } else { Ok(pieces) }
    }

    /// Convex parts of the hull that are inside.
    fn inside(&self, hull: Polyhedron, flatness: f64, most: usize) -> Result<Vec<Polyhedron>, PiecesProblem> {
        let facets: Vec<Vec<Vec3>> =
            self.facets.iter().map(|facet| facet.map(|i| self.vertices[i]).to_vec()).collect();
        let mut waiting = vec![Part { facets: through(&hull, &facets, flatness), cell: hull }];
        let (mut pieces, mut looks) = (vec![], 0);
        while let Some(part) = waiting.pop() {
            looks += 1;
            if looks > PARTS_A_PIECE * (most + 1) {
                return Err(PiecesProblem::TooMany { most });
            }
            let Some(cut) = part.plane(flatness) else {
                if self.encloses(middle(&part.cell)) {
                    pieces.push(part.cell);
                }
                continue;
            };
            // What lies in the plane goes through neither half.
            let rest: Vec<Vec<Vec3>> =
                part.facets.iter().filter(|facet| !holds(&cut, facet, flatness)).cloned().collect();
            let halves = [cut, cut.flipped()].map(|cut| part.cell.behind(&cut, flatness));
            let of = |cell: Polyhedron| Part { facets: through(&cell, &rest, flatness), cell };
            match halves {
                [Some(below), Some(above)] => waiting.extend([below, above].map(of)),
                // All of it but for the flatness is on one side.
                _ => waiting.push(of(part.cell)),
            }
        }
        Ok(pieces)
    }

    /// A place is inside, seen from which the facets are all around.
    ///
    /// # Source
    /// A. Van Oosterom and J. Strackee, IEEE Transactions on Biomedical Engineering 30 (1983) 125: the solid angle of a triangle.
    fn encloses(&self, place: Vec3) -> bool {
        let half = |facet: &[usize; 3]| {
            let [a, b, c] = facet.map(|i| self.vertices[i] - place);
            let [x, y, z] = [a, b, c].map(Vec3::norm);
            atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y)
        };
        // All around is 4 π, twice the sum of the halves.
        self.facets.iter().map(half).sum::<f64>().abs() > 0.5 * TAU
    }
}

/// Pieces of which no two are convex together.
fn joined(mut pieces: Vec<Polyhedron>, flatness: f64) -> Vec<Polyhedron> {
    let spare = flatness * size(&pieces).powi(2);
    let both = |a: &Polyhedron, b: &Polyhedron| {
        if !share_a_face(a, b, flatness) {
            return None;
        }
        let points = [a.vertices(), b.vertices()].concat();
        let hull = Polyhedron::of_points(&points, flatness).ok()?;
        (volume(&hull) <= volume(a) + volume(b) + spare).then_some(hull)
    };
    let mut first = 0;
    while first < pieces.len() {
        let found = (first + 1..pieces.len()).find_map(|k| Some((k, both(&pieces[first], &pieces[k])?)));
        match found {
            Some((k, hull)) => {
                pieces.remove(k);
                pieces[first] = hull;
                first = 0;
            }
            None => first += 1,
        }
    }
    pieces
}

/// Two pieces have one face, each on its side of it: what is convex together does, if neither reaches into the other.
fn share_a_face(a: &Polyhedron, b: &Polyhedron, flatness: f64) -> bool {
    let near = INSIDE * flatness;
    let all_on = |piece: &Polyhedron, face: &Face, other: &Polyhedron, of: &Face| {
        of.corners.iter().all(|corner| piece.height(face, other.vertices()[*corner]).abs() <= near)
    };
    let is_one = |own: &Face, other: &Face| {
        own.normal.dot(other.normal) < 0.0 && (all_on(a, own, b, other) || all_on(b, other, a, own))
    };
    a.faces().iter().any(|own| b.faces().iter().any(|other| is_one(own, other)))
}

fn volume(piece: &Polyhedron) -> f64 {
    piece.solid().map_or(0.0, |solid| solid.volume)
}

/// How far places of the pieces are from each other at most, within a factor of two \[m\].
fn size(pieces: &[Polyhedron]) -> f64 {
    let places = || pieces.iter().flat_map(Polyhedron::vertices);
    places().next().map_or(0.0, |first| places().map(|r| (*r - *first).norm()).fold(0.0, f64::max))
}

fn middle(piece: &Polyhedron) -> Vec3 {
    #[expect(clippy::cast_precision_loss, reason = "a handful")]
    let count = piece.vertices().len() as f64;
    piece.vertices().iter().fold(Vec3::ZERO, |sum, r| sum + *r) / count
}

#[cfg(test)]
mod tests;
