//! The convex hull of points in space, by its plane faces.
//!
//! Gift wrapping: a supporting plane turns about each edge of a face until it meets the next points, and all that lie on it within the flatness are
//! the next face. So coplanar points need no exact predicates, and a face has as many corners as it has.
//!
//! # Source
//! D. R. Chand and S. S. Kapur, Journal of the ACM 17 (1970) 78.

use carom_num::Vec3;
use std::collections::BTreeSet;
use thiserror::Error;

/// Points that are wrapped at most: the work grows with their number times that of the faces.
const MOST_POINTS: usize = 10_000;
/// Faces after which wrapping is given up, for so many points.
const FACES_A_POINT: usize = 2;
/// Times a plane is fitted again to the points that lie on it.
const MOST_FITS: u32 = 4;
/// Passes over the points in search of the plane that is met first.
const MOST_PASSES: u32 = 4;
/// A point may stand out of a face by this many times the flatness: a fitted plane lies between its points.
const STANDS_OUT: f64 = 2.0;

/// Why points have no hull with a volume.
///
/// # Example
/// A triangle and a square have no volume.
/// ```
/// use carom_motion::spatial::{HullProblem, Polyhedron};
/// use carom_num::Vec3;
/// let mut points = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
/// assert_eq!(Polyhedron::of_points(&points, 1e-9), Err(vec![HullProblem::TooFew { count: 3 }]));
/// points.push(Vec3::X + Vec3::Y);
/// assert_eq!(Polyhedron::of_points(&points, 1e-9), Err(vec![HullProblem::Flat { thickness: 0.0 }]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HullProblem {
    /// A place that is not finite.
    #[error("point {point} is not at a finite place")]
    NotFinite {
        /// Which one.
        point: usize,
    },
    /// Fewer than four places.
    #[error("{count} different points: a body needs at least 4, not on one plane")]
    TooFew {
        /// How many there are.
        count: usize,
    },
    /// More than are wrapped.
    #[error("{count} points: at most {MOST_POINTS} are taken")]
    TooMany {
        /// How many there are.
        count: usize,
    },
    /// All lie on one line or plane.
    #[error("all points lie on one plane, within {thickness:.3e} m: a body needs a volume")]
    Flat {
        /// How far they reach from that plane \[m\].
        thickness: f64,
    },
    /// Faces cannot be told apart.
    #[error(
        "faces cannot be told apart with a flatness of {flatness} m: neighbouring ones are almost on one plane"
    )]
    Unclear {
        /// What counts as flat \[m\].
        flatness: f64,
    },
}

/// The corners of each face, by the numbers of points, counter-clockwise as seen from outside.
pub(super) type Faces = Vec<Vec<usize>>;

/// For each point the number of the one that stands for it: points no farther than this from an earlier point are the same point.
pub(super) fn welded(points: &[Vec3], distance: f64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|a, b| points[*a].x.total_cmp(&points[*b].x).then(a.cmp(b)));
    let mut stands: Vec<usize> = (0..points.len()).collect();
    for (k, &i) in order.iter().enumerate() {
        let near = order[k + 1..].iter().take_while(|j| points[**j].x - points[i].x <= distance);
        for &j in near.filter(|j| (points[**j] - points[i]).norm() <= distance) {
            let (a, b) = (root(&stands, i), root(&stands, j));
            stands[a.max(b)] = a.min(b);
        }
    }
    (0..points.len()).map(|i| root(&stands, i)).collect()
}

fn root(stands: &[usize], mut i: usize) -> usize {
    while stands[i] != i {
        i = stands[i];
    }
    i
}

/// A plane `normal · r = offset`, with everything below it.
#[derive(Clone, Copy, Debug)]
struct Plane {
    normal: Vec3,
    offset: f64,
}

/// What is wrapped: points, and what counts as flat.
struct Wrapping<'p> {
    points: &'p [Vec3],
    /// The points that count: one for each place.
    places: Vec<usize>,
    flatness: f64,
}

/// The faces of the hull of these points.
///
/// # Errors
/// The first problem of the points as a whole.
pub(super) fn faces(points: &[Vec3], flatness: f64) -> Result<Faces, HullProblem> {
    let stands = welded(points, flatness);
    let places: Vec<usize> = (0..points.len()).filter(|i| stands[*i] == *i).collect();
    let count = places.len();
    if count < 4 {
        return Err(HullProblem::TooFew { count });
    }
    if count > MOST_POINTS {
        return Err(HullProblem::TooMany { count });
    }
    let wrapping = Wrapping { points, places, flatness };
    let (first, plane) = wrapping.first()?;
    let depth = |i: &usize| plane.offset - plane.normal.dot(points[*i]);
    let thickness = wrapping.places.iter().map(depth).fold(0.0, f64::max);
    if thickness <= STANDS_OUT * flatness {
        return Err(HullProblem::Flat { thickness });
    }
    wrapping.all(first).ok_or(HullProblem::Unclear { flatness })
}

impl Wrapping<'_> {
    /// A first face: a plane that touches the sphere about the points at the farthest one, turned about two lines.
    fn first(&self) -> Result<(Vec<usize>, Plane), HullProblem> {
        let at = |i: usize| self.points[i];
        #[expect(clippy::cast_precision_loss, reason = "thousands")]
        let count = self.places.len() as f64;
        let mean = self.places.iter().fold(Vec3::ZERO, |sum, i| sum + at(*i)) / count;
        let far = |i: &&usize| (at(**i) - mean).norm();
        let flat = HullProblem::Flat { thickness: 0.0 };
        let corner = self.places.iter().max_by(|a, b| far(a).total_cmp(&far(b))).map_or(mean, |i| at(*i));
        let normal = (corner - mean).unit().ok_or(flat)?;
        let [along, _] = normal.tangents();
        let (second, normal) = self.turned(corner, along, normal).ok_or(flat)?;
        let along = (at(second) - corner).unit().ok_or(flat)?;
        // Turned about that line the plane loses it only by rounding.
        let normal = (normal - along * normal.dot(along)).unit().ok_or(flat)?;
        let (_, normal) = self.turned(corner, along, normal).ok_or(flat)?;
        self.face(Plane { normal, offset: normal.dot(corner) }).ok_or(flat)
    }

    /// Wraps all faces from a first one; `None` where they do not close.
    fn all(&self, first: Vec<usize>) -> Option<Faces> {
        let most = FACES_A_POINT * self.places.len();
        let mut taken: BTreeSet<(usize, usize)> = sides(&first).collect();
        let mut faces: Faces = vec![first];
        let mut done = 0;
        while done < faces.len() {
            let face = faces[done].clone();
            done += 1;
            let normal = newell(&self.corners(&face)).unit()?;
            for (a, b) in sides(&face) {
                if taken.contains(&(b, a)) {
                    continue;
                }
                let next = self.beside((a, b), normal)?;
                if faces.len() >= most || sides(&next).any(|side| taken.contains(&side)) {
                    return None;
                }
                taken.extend(sides(&next));
                faces.push(next);
            }
        }
        taken.iter().all(|(a, b)| taken.contains(&(*b, *a))).then_some(faces)
    }

    /// The face on the other side of an edge of one with this normal.
    fn beside(&self, (a, b): (usize, usize), normal: Vec3) -> Option<Vec<usize>> {
        let along = (self.points[b] - self.points[a]).unit()?;
        let across = (normal - along * normal.dot(along)).unit()?;
        let (_, next) = self.turned(self.points[a], along, across)?;
        let (next, plane) = self.face(Plane { normal: next, offset: next.dot(self.points[a]) })?;
        let out = |i: &usize| plane.normal.dot(self.points[*i]) - plane.offset;
        let highest = self.places.iter().map(out).fold(0.0, f64::max);
        let fits = highest <= STANDS_OUT * self.flatness && sides(&next).any(|side| side == (b, a));
        fits.then_some(next)
    }

    fn corners(&self, face: &[usize]) -> Vec<Vec3> {
        face.iter().map(|i| self.points[*i]).collect()
    }

    /// A supporting plane with this normal turns about a line on it, away from the body's side, until it meets the next points: one of them, the farthest from the line, and the
    /// normal then. `None` where all points are on the line.
    fn turned(&self, on: Vec3, along: Vec3, normal: Vec3) -> Option<(usize, Vec3)> {
        let out = along.cross(normal);
        // From the line, across it: outwards on the plane, and along its normal.
        let across = |i: usize| {
            let r = self.points[i] - on;
            [r.dot(out), r.dot(normal)]
        };
        let size = |[u, h]: [f64; 2]| (u * u + h * h).sqrt();
        let mut best: Option<(usize, [f64; 2])> = None;
        for _ in 0..MOST_PASSES {
            let before = best.map(|(i, _)| i);
            for &i in &self.places {
                let w = across(i);
                let length = size(w);
                if length <= self.flatness {
                    continue;
                }
                let better = best.is_none_or(|(_, b)| {
                    let above = (b[0] * w[1] - b[1] * w[0]) / size(b);
                    let same_side = b[0] * w[0] + b[1] * w[1] > 0.0;
                    above > self.flatness || (above >= -self.flatness && same_side && length > size(b))
                });
                if better {
                    best = Some((i, w));
                }
            }
            if best.map(|(i, _)| i) == before {
                break;
            }
        }
        let (point, [u, h]) = best?;
        Some((point, (normal * u - out * h).unit()?))
    }

    /// The face on a plane, fitted to the points that lie on it.
    fn face(&self, mut plane: Plane) -> Option<(Vec<usize>, Plane)> {
        let mut face = vec![];
        for _ in 0..MOST_FITS {
            let off = |i: &usize| (plane.normal.dot(self.points[*i]) - plane.offset).abs();
            let on: Vec<usize> = self.places.iter().copied().filter(|i| off(i) <= self.flatness).collect();
            let found = self.outline(&on, plane.normal);
            if found.len() < 3 || found == face {
                break;
            }
            face = found;
            let corners = self.corners(&face);
            plane = fitted(&corners)?;
        }
        (face.len() >= 3).then_some((face, plane))
    }

    /// The corners of the convex hull of points on a plane, counter-clockwise about its normal; points on its sides are none.
    ///
    /// # Source
    /// A. M. Andrew, Information Processing Letters 9 (1979) 216.
    fn outline(&self, on: &[usize], normal: Vec3) -> Vec<usize> {
        let [x, y] = normal.tangents();
        let at = |i: usize| [self.points[i].dot(x), self.points[i].dot(y)];
        let mut order = on.to_vec();
        let first = |a: &usize, b: &usize| {
            let (p, q) = (at(*a), at(*b));
            p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])).then(a.cmp(b))
        };
        order.sort_by(first);
        let half = |order: &mut dyn Iterator<Item = usize>| {
            let mut chain: Vec<usize> = vec![];
            for i in order {
                while let [.., a, b] = chain[..] {
                    if left(at(a), at(b), at(i)) > 0.0 {
                        break;
                    }
                    chain.pop();
                }
                chain.push(i);
            }
            chain.pop();
            chain
        };
        let lower = half(&mut order.iter().copied());
        let upper = half(&mut order.iter().rev().copied());
        self.without_middles([lower, upper].concat(), &at)
    }

    /// The corners that are not on the line of their neighbours.
    fn without_middles(&self, mut corners: Vec<usize>, at: &dyn Fn(usize) -> [f64; 2]) -> Vec<usize> {
        let mut k = 0;
        while corners.len() > 2 && k < corners.len() {
            let n = corners.len();
            let (a, b, c) = (at(corners[(k + n - 1) % n]), at(corners[k]), at(corners[(k + 1) % n]));
            let base = ((c[0] - a[0]).powi(2) + (c[1] - a[1]).powi(2)).sqrt();
            if left(a, b, c) <= self.flatness * base {
                corners.remove(k);
                // The one before has another neighbour now.
                k = k.saturating_sub(1);
            } else {
                k += 1;
            }
        }
        corners
    }
}

/// Twice the area of a triangle, positive where it turns to the left.
fn left(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The directed sides of a face.
pub(super) fn sides(face: &[usize]) -> impl Iterator<Item = (usize, usize)> {
    (0..face.len()).map(|k| (face[k], face[(k + 1) % face.len()]))
}

/// The normal of a polygon in space, as long as twice its area.
///
/// # Source
/// M. E. Newell, as in I. E. Sutherland, R. F. Sproull and R. A. Schumacker, ACM Computing Surveys 6 (1974) 1.
pub(super) fn newell(corners: &[Vec3]) -> Vec3 {
    let Some(first) = corners.first().copied() else { return Vec3::ZERO };
    let pairs = corners.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first));
    pairs.fold(Vec3::ZERO, |sum, area| sum + area)
}

/// The plane of a polygon that is almost flat.
fn fitted(corners: &[Vec3]) -> Option<Plane> {
    let normal = newell(corners).unit()?;
    #[expect(clippy::cast_precision_loss, reason = "a handful")]
    let count = corners.len() as f64;
    let offset = corners.iter().map(|r| normal.dot(*r)).sum::<f64>() / count;
    Some(Plane { normal, offset })
}
