//! A convex polyhedron: the hull of points, its faces, what fills it, and on which faces it may rest.

use super::hull::{self, Faces, HullProblem, newell, sides};
use super::plane::Plane;
use super::solid::{Mesh, MeshProblem, Solid};
use crate::tolerance::{INDEPENDENT_NORMALS, THINNEST_BODY, VERTEX_ON_FACE};
use carom_num::{Mat3, Vec3};

/// A convex polyhedron.
///
/// # Example
/// Euler: a cube has `V − E + F = 2`.
/// ```
/// use carom_motion::spatial::{Polyhedron, examples};
/// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
/// let edges = cube.faces().iter().map(|face| face.corners.len()).sum::<usize>() / 2;
/// assert_eq!((cube.vertices().len(), edges, cube.faces().len()), (8, 12, 6));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Polyhedron {
    vertices: Vec<Vec3>,
    sources: Vec<usize>,
    faces: Vec<Face>,
    moved: f64,
}

/// A plane face of it.
///
/// # Example
/// The normals of a cube's faces, all of one size, add up to nothing.
/// ```
/// use carom_motion::spatial::{Face, Polyhedron, examples};
/// use carom_num::Vec3;
/// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
/// let sum = cube.faces().iter().fold(Vec3::ZERO, |sum, Face { normal, .. }| sum + *normal);
/// assert_eq!(sum, Vec3::ZERO);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// The vertices at its corners, counter-clockwise as seen from outside, the lowest number first.
    pub corners: Vec<usize>,
    /// Unit normal, outwards.
    pub normal: Vec3,
}

/// How a body stands on a face.
///
/// # Example
/// A cube of 1 m rests on each face alike, its centre half a metre up and half a metre from the nearest side.
/// ```
/// use carom_motion::spatial::{Polyhedron, Stance, examples};
/// use carom_num::Vec3;
/// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
/// let centre = Vec3::new(0.5, 0.5, 0.5);
/// let stances: Vec<_> = (0..6).map(|face| cube.stance(face, centre)).collect();
/// assert_eq!(stances, vec![Some(Stance { height: 0.5, margin: 0.5 }); 6]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stance {
    /// Height of the mass centre over the face \[m\].
    pub height: f64,
    /// How far inside the face the mass centre's projection is from the nearest side; negative where it is outside \[m\].
    pub margin: f64,
}

/// Rounds in which vertices are moved onto their faces.
const MOST_ROUNDS: u32 = 60;

impl Polyhedron {
    /// The convex hull of points \[m\]. Those within `flatness` \[m\] of one plane make one face, and its vertices are moved onto it: then the polyhedron lies on the plane with
    /// all of them.
    ///
    /// # Errors
    /// Points that are not finite, each; or why the others have no hull with a volume.
    ///
    /// # Limits
    /// Corners of a face with four and more faces about them may not find a common place; what is left is [`Polyhedron::unevenness`].
    ///
    /// # Example
    /// A point within a cube is none of its vertices.
    /// ```
    /// use carom_motion::spatial::Polyhedron;
    /// use carom_num::Vec3;
    /// let mut points: Vec<Vec3> =
    ///     (0..8).map(|i| Vec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64)).collect();
    /// points.push(Vec3::new(0.5, 0.2, 0.7));
    /// let cube = Polyhedron::of_points(&points, 1e-9)?;
    /// assert_eq!((cube.vertices().len(), cube.faces().len()), (8, 6));
    /// assert_eq!(cube.faces()[0].corners, [0, 1, 5, 4]);
    /// # Ok::<(), Vec<carom_motion::spatial::HullProblem>>(())
    /// ```
    pub fn of_points(points: &[Vec3], flatness: f64) -> Result<Self, Vec<HullProblem>> {
        let lost = points.iter().enumerate().filter(|(_, r)| !r.is_finite());
        let lost: Vec<HullProblem> = lost.map(|(point, _)| HullProblem::NotFinite { point }).collect();
        if !lost.is_empty() {
            return Err(lost);
        }
        let found = hull::faces(points, flatness).map_err(|problem| vec![problem])?;
        let mut sources: Vec<usize> = found.iter().flatten().copied().collect();
        sources.sort_unstable();
        sources.dedup();
        let number = |point: usize| sources.binary_search(&point).unwrap_or_default();
        let mut faces: Faces =
            found.iter().map(|face| from_lowest(face.iter().map(|i| number(*i)).collect())).collect();
        // The hull finds faces in an order that rounding may change; the numbers of faces must not.
        faces.sort_unstable();
        let mut vertices: Vec<Vec3> = sources.iter().map(|i| points[*i]).collect();
        level(&mut vertices, &faces);
        let moves = sources.iter().zip(&vertices).map(|(i, r)| (points[*i] - *r).norm());
        let moved = moves.fold(0.0, f64::max);
        let unclear = || vec![HullProblem::Unclear { flatness }];
        let faces = faces.into_iter().map(|corners| {
            let normal = newell(&places(&vertices, &corners)).unit()?;
            Some(Face { corners, normal })
        });
        let faces = faces.collect::<Option<Vec<Face>>>().ok_or_else(unclear)?;
        let made = Self { vertices, sources, faces, moved };
        let (thickness, length) = made.thickness();
        if thickness <= THINNEST_BODY * length {
            return Err(vec![HullProblem::Flat { thickness }]);
        }
        Ok(made)
    }

    /// The same faces of other vertices, as many as these.
    pub(super) fn with_vertices(&self, vertices: Vec<Vec3>) -> Self {
        Self { vertices, ..self.clone() }
    }

    /// The same one elsewhere \[m\].
    #[must_use]
    pub fn moved_by(&self, by: Vec3) -> Self {
        self.with_vertices(self.vertices.iter().map(|r| *r + by).collect())
    }

    /// What of it is behind a plane; places within `flatness` \[m\] of that are on it. `None` where that has no volume.
    ///
    /// # Example
    /// Half a cube.
    /// ```
    /// use carom_motion::spatial::{Plane, Polyhedron, examples};
    /// use carom_num::Vec3;
    /// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
    /// let half = cube.behind(&Plane::new(Vec3::Z, 0.5).unwrap(), 1e-9).unwrap();
    /// assert_eq!((half.vertices().len(), half.solid().unwrap().volume), (8, 0.5));
    /// assert_eq!(cube.behind(&Plane::FLOOR, 1e-9), None);
    /// ```
    pub fn behind(&self, plane: &Plane, flatness: f64) -> Option<Self> {
        let height = |vertex: usize| plane.height(self.vertices[vertex]);
        let mut points: Vec<Vec3> =
            self.vertices.iter().copied().filter(|r| plane.height(*r) <= flatness).collect();
        for (i, j) in self.faces.iter().flat_map(|face| sides(&face.corners)).filter(|(i, j)| i < j) {
            let (a, b) = (height(i), height(j));
            if a.abs() > flatness && b.abs() > flatness && a * b < 0.0 {
                points.push(self.vertices[i] + (self.vertices[j] - self.vertices[i]) * (a / (a - b)));
            }
        }
        Self::of_points(&points, flatness).ok()
    }

    /// The same faces with these normals, and vertices at these places on them.
    pub(super) fn placed(&self, vertices: Vec<Vec3>, normals: impl Iterator<Item = Vec3>) -> Self {
        let turned = |(face, normal): (&Face, Vec3)| Face { normal, ..face.clone() };
        let faces = self.faces.iter().zip(normals).map(turned).collect();
        Self { vertices, faces, ..self.clone() }
    }

    /// How far a place is outside of one of its faces \[m\].
    pub(super) fn height(&self, face: &Face, place: Vec3) -> f64 {
        face.normal.dot(place - self.vertices[face.corners[0]])
    }

    /// The area of a face [m²].
    pub(super) fn area(&self, face: usize) -> f64 {
        0.5 * newell(&places(&self.vertices, &self.faces[face].corners)).norm()
    }

    /// Its vertices, in the order of the points that they were \[m\].
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }

    /// Which of the points each vertex was.
    ///
    /// # Example
    /// The first point lies inside.
    /// ```
    /// use carom_motion::spatial::{Polyhedron, examples};
    /// use carom_num::Vec3;
    /// let points = examples::cube_corners();
    /// let cube = Polyhedron::of_points(&points, 1e-9).unwrap();
    /// let with_inner: Vec<Vec3> = [Vec3::new(0.5, 0.2, 0.7)].into_iter().chain(points).collect();
    /// let cube = Polyhedron::of_points(&with_inner, 1e-9).unwrap();
    /// assert_eq!(cube.sources(), [1, 2, 3, 4, 5, 6, 7, 8]);
    /// ```
    pub fn sources(&self) -> &[usize] {
        &self.sources
    }

    /// Its faces, in the order of their corners.
    ///
    /// # Example
    /// The lower face of a cube, in the order in which it is seen from below.
    /// ```
    /// use carom_motion::spatial::{Polyhedron, examples};
    /// use carom_num::Vec3;
    /// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
    /// let below = cube.faces().iter().find(|face| face.normal == -Vec3::Z).unwrap();
    /// assert_eq!(below.corners, [0, 2, 3, 1]);
    /// ```
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// How far a vertex was moved at most, to bring it onto its faces \[m\].
    ///
    /// # Example
    /// One corner is a millionth of a metre off: it is brought back onto three faces, and none moves farther
    /// than that.
    /// ```
    /// use carom_motion::spatial::{Polyhedron, examples};
    /// let points = examples::cube_corners();
    /// let cube = Polyhedron::of_points(&points, 1e-9).unwrap();
    /// assert_eq!(cube.moved(), 0.0);
    /// let mut rough = points.clone();
    /// rough[7].z += 1e-6;
    /// let moved = Polyhedron::of_points(&rough, 1e-5).unwrap().moved();
    /// assert!(0.0 < moved && moved <= 1e-6);
    /// ```
    pub fn moved(&self) -> f64 {
        self.moved
    }

    /// How far a vertex is from a face of its at most \[m\].
    pub fn unevenness(&self) -> f64 {
        let of = |face: &Face| {
            let (_, offset) = plane(&self.vertices, &face.corners);
            let off = |i: &usize| (face.normal.dot(self.vertices[*i]) - offset).abs();
            face.corners.iter().map(off).fold(0.0, f64::max)
        };
        self.faces.iter().map(of).fold(0.0, f64::max)
    }

    /// Thickness and length \[m\]: how far the vertices reach from the face from which they reach least, and how far from the first vertex at most.
    fn thickness(&self) -> (f64, f64) {
        let reach = |normal: Vec3, offset: f64| {
            self.vertices.iter().map(|r| offset - normal.dot(*r)).fold(0.0, f64::max)
        };
        let of = |face: &Face| reach(face.normal, plane(&self.vertices, &face.corners).1);
        let least = self.faces.iter().map(of).fold(f64::INFINITY, f64::min);
        let length = |a: &Vec3| self.vertices.iter().map(|b| (*a - *b).norm()).fold(0.0, f64::max);
        (least, self.vertices.first().map_or(0.0, length))
    }

    /// Its surface as triangles.
    pub fn mesh(&self) -> Mesh {
        let fan = |face: &Face| {
            let corners = face.corners.clone();
            (1..corners.len().saturating_sub(1)).map(move |k| [corners[0], corners[k], corners[k + 1]])
        };
        Mesh { vertices: self.vertices.clone(), facets: self.faces.iter().flat_map(fan).collect() }
    }

    /// What fills it.
    ///
    /// # Errors
    /// It has no volume, but for rounding.
    ///
    /// # Example
    /// A cube of 1 m has `J = V a²/6`.
    /// ```
    /// use carom_motion::spatial::{Polyhedron, examples};
    /// use carom_num::Vec3;
    /// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
    /// let solid = cube.solid().unwrap();
    /// assert!((solid.volume - 1.0).abs() < 1e-15);
    /// assert!((solid.centre - Vec3::new(0.5, 0.5, 0.5)).norm() < 1e-15);
    /// assert!((solid.inertia.rows[0] - Vec3::X / 6.0).norm() < 1e-15);
    /// ```
    pub fn solid(&self) -> Result<Solid, Vec<MeshProblem>> {
        self.mesh().solid()
    }

    /// How a body with this mass centre \[m\] stands on a face; `None` where there is no such face.
    ///
    /// It rests there where the margin is positive, and where not it rolls off: over the side that is nearest to the projection.
    ///
    /// # Example
    /// A mass centre beyond the side of a face: the cube rolls off it.
    /// ```
    /// use carom_motion::spatial::{Polyhedron, examples};
    /// use carom_num::Vec3;
    /// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
    /// let below = cube.faces().iter().position(|face| face.normal == -Vec3::Z).unwrap();
    /// let stance = cube.stance(below, Vec3::new(1.25, 0.5, 0.5)).unwrap();
    /// assert_eq!((stance.height, stance.margin), (0.5, -0.25));
    /// assert!(cube.stance(6, Vec3::ZERO).is_none());
    /// ```
    pub fn stance(&self, face: usize, centre: Vec3) -> Option<Stance> {
        let Face { corners, normal } = self.faces.get(face)?;
        let (_, offset) = plane(&self.vertices, corners);
        let margin = sides(corners).map(|side| self.inside(face, side, centre)).fold(f64::INFINITY, f64::min);
        Some(Stance { height: offset - normal.dot(centre), margin })
    }

    /// How far inside a side of a face the projection of a place on it is; negative beyond the side \[m\].
    pub(super) fn inside(&self, face: usize, (a, b): (usize, usize), place: Vec3) -> f64 {
        let along = (self.vertices[b] - self.vertices[a]).unit().unwrap_or(Vec3::ZERO);
        self.faces[face].normal.cross(along).dot(place - self.vertices[a])
    }
}

/// The same face from its lowest corner on.
fn from_lowest(mut face: Vec<usize>) -> Vec<usize> {
    let lowest = (0..face.len()).min_by_key(|k| face[*k]).unwrap_or_default();
    face.rotate_left(lowest);
    face
}

fn places(vertices: &[Vec3], corners: &[usize]) -> Vec<Vec3> {
    corners.iter().map(|i| vertices[*i]).collect()
}

/// Unit normal and offset of the plane through the corners' mean.
fn plane(vertices: &[Vec3], corners: &[usize]) -> (Vec3, f64) {
    let normal = newell(&places(vertices, corners)).unit().unwrap_or(Vec3::ZERO);
    #[expect(clippy::cast_precision_loss, reason = "a handful")]
    let count = corners.len() as f64;
    (normal, corners.iter().map(|i| normal.dot(vertices[*i])).sum::<f64>() / count)
}

/// Moves vertices onto the faces that they belong to, as little as it takes. A triangle asks nothing.
fn level(vertices: &mut [Vec3], faces: &Faces) {
    let size = vertices.iter().map(|r| (*r - vertices[0]).norm()).fold(0.0, f64::max);
    let wide: Vec<&Vec<usize>> = faces.iter().filter(|face| face.len() > 3).collect();
    let mut least = f64::INFINITY;
    for _ in 0..MOST_ROUNDS {
        let mut asked: Vec<Vec<(Vec3, f64)>> = vec![vec![]; vertices.len()];
        let mut worst = 0.0_f64;
        for face in &wide {
            let (normal, offset) = plane(vertices, face);
            for &i in *face {
                let off = offset - normal.dot(vertices[i]);
                worst = worst.max(off.abs());
                asked[i].push((normal, off));
            }
        }
        // Rounding is all that is left, or it does not get better.
        if worst <= VERTEX_ON_FACE * size || worst >= least {
            return;
        }
        least = worst;
        for (vertex, asked) in vertices.iter_mut().zip(&asked) {
            *vertex += step(asked);
        }
    }
}

/// The shortest step that goes so far along each normal; of more than three, as nearly as can be.
fn step(asked: &[(Vec3, f64)]) -> Vec3 {
    match *asked {
        [] => Vec3::ZERO,
        [(n, off)] => n * off,
        [(a, x), (b, y)] => solved([a, b, a.cross(b)], Vec3::new(x, y, 0.0)),
        [(a, x), (b, y), (c, z)] => solved([a, b, c], Vec3::new(x, y, z)),
        _ => {
            let matrix = asked.iter().fold(Mat3::ZERO, |sum, (n, _)| sum + Mat3::dyad(*n, *n));
            let right = asked.iter().fold(Vec3::ZERO, |sum, (n, off)| sum + *n * *off);
            solved(matrix.rows, right)
        }
    }
}

fn solved(rows: [Vec3; 3], right: Vec3) -> Vec3 {
    let matrix = Mat3 { rows };
    let clear = matrix.determinant().abs() > INDEPENDENT_NORMALS;
    matrix.inverse().filter(|_| clear).map_or(Vec3::ZERO, |inverse| inverse * right)
}
