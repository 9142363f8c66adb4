//! A convex polyhedron whose edges and corners are rounded: its faces stay where they are, and a ball of one radius rolls along inside of the rest.

use super::hull::sides;
use super::polyhedron::{Face, Polyhedron};
use super::solid::{Solid, inertia_of};
use carom_num::elementary::atan2;
use carom_num::{Mat3, Vec3};
use std::collections::BTreeMap;
use thiserror::Error;

/// A rounded polyhedron: all that is within a radius of an inner one.
///
/// # Example
/// A cube of 1 m, rounded by 0.1 m, has the edge 0.8 m inside; `V = a³ + 6 a² ρ + 3 π a ρ² + ⁴⁄₃ π ρ³`.
/// ```
/// use carom_motion::spatial::{Polyhedron, examples};
/// use std::f64::consts::PI;
/// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
/// let rounded = cube.rounded(0.1).unwrap();
/// let volume = 0.512 + 6.0 * 0.064 + 3.0 * PI * 0.8 * 0.01 + 4.0 / 3.0 * PI * 0.001;
/// assert!((rounded.solid.volume - volume).abs() < 1e-15);
/// assert!((rounded.inner.vertices()[0] - carom_num::Vec3::new(0.1, 0.1, 0.1)).norm() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Rounding {
    /// The centres of the balls at its corners, with the faces and the numbers of the polyhedron.
    pub inner: Polyhedron,
    /// What fills the rounded body.
    pub solid: Solid,
    /// Places on its surface, whose hull shows it: of each face its corners, and one in the middle of every round edge and corner.
    pub shown: Vec<Vec3>,
}

/// Why a polyhedron is not rounded.
///
/// # Example
/// No ball of 0.6 m is inside of a cube of 1 m.
/// ```
/// use carom_motion::spatial::{Polyhedron, RoundingProblem, examples};
/// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
/// assert_eq!(cube.rounded(0.6), Err(RoundingProblem::Vanishes { face: 0 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RoundingProblem {
    /// A radius that rounds nothing.
    #[error("the radius is {radius} m: allowed is finite and > 0")]
    Radius {
        /// What it is \[m\].
        radius: f64,
    },
    /// A face of which nothing plane would be left.
    #[error("nothing of face {face} would stay plane")]
    Vanishes {
        /// Which one.
        face: usize,
    },
    /// A corner at which more than three faces meet: what a ball inside of it touches is not one corner.
    #[error("{faces} faces meet at vertex {vertex}: corners of three are rounded")]
    Faces {
        /// Which one.
        vertex: usize,
        /// How many.
        faces: usize,
    },
}

impl Polyhedron {
    /// The same polyhedron, rounded with a radius \[m\].
    ///
    /// # Errors
    /// The first problem.
    pub fn rounded(&self, radius: f64) -> Result<Rounding, RoundingProblem> {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(RoundingProblem::Radius { radius });
        }
        let normals: Vec<Vec<Vec3>> =
            (0..self.vertices().len()).map(|vertex| self.normals_at(vertex)).collect();
        let mut vertices = vec![];
        for (vertex, (place, normals)) in self.vertices().iter().zip(&normals).enumerate() {
            let [a, b, c] = normals[..] else {
                return Err(RoundingProblem::Faces { vertex, faces: normals.len() });
            };
            // The place that is a radius behind all three faces.
            let back = (b.cross(c) + c.cross(a) + a.cross(b)) / a.dot(b.cross(c));
            vertices.push(*place - back * radius);
        }
        let inner = self.with_vertices(vertices);
        let keeps = |(i, j): (usize, usize)| {
            let along = |of: &Self| of.vertices()[j] - of.vertices()[i];
            along(self).dot(along(&inner)) > 0.0
        };
        let whole = |face: &Face| sides(&face.corners).all(keeps);
        if let Some(face) = self.faces().iter().position(|face| !whole(face)) {
            return Err(RoundingProblem::Vanishes { face });
        }
        let sums = Sums::of(&inner, &normals, radius);
        let shown = shown(&inner, &normals, radius);
        Ok(Rounding { inner, solid: sums.solid(), shown })
    }

    /// The normals of the faces at a vertex, of three counter-clockwise as seen from outside.
    fn normals_at(&self, vertex: usize) -> Vec<Vec3> {
        let own = self.faces().iter().filter(|face| face.corners.contains(&vertex));
        let mut normals: Vec<Vec3> = own.map(|face| face.normal).collect();
        if let [a, b, c] = normals[..]
            && a.dot(b.cross(c)) < 0.0
        {
            normals.swap(1, 2);
        }
        normals
    }

    /// Its edges: the two vertices and the normals of the two faces.
    fn edges(&self) -> Vec<([usize; 2], [Vec3; 2])> {
        let mut found: BTreeMap<[usize; 2], Vec<Vec3>> = BTreeMap::new();
        for face in self.faces() {
            for (i, j) in sides(&face.corners) {
                found.entry([i.min(j), i.max(j)]).or_default().push(face.normal);
            }
        }
        found.into_iter().filter_map(|(ends, normals)| Some((ends, normals.try_into().ok()?))).collect()
    }
}

/// Places on the surface.
fn shown(inner: &Polyhedron, normals: &[Vec<Vec3>], radius: f64) -> Vec<Vec3> {
    let mut places = vec![];
    for (place, normals) in inner.vertices().iter().zip(normals) {
        let sum = normals.iter().fold(Vec3::ZERO, |sum, n| sum + *n);
        let directions = normals.iter().copied().chain(sum.unit());
        places.extend(directions.map(|direction| *place + direction * radius));
    }
    for (ends, [a, b]) in inner.edges() {
        let Some(between) = (a + b).unit() else { continue };
        places.extend(ends.map(|end| inner.vertices()[end] + between * radius));
    }
    places
}

/// Volume, and the integrals of place and of its dyad over it.
#[derive(Clone, Copy, Debug)]
struct Sums {
    volume: f64,
    first: Vec3,
    second: Mat3,
}

/// `a bᵀ + b aᵀ`.
fn mixed(a: Vec3, b: Vec3) -> Mat3 {
    Mat3::dyad(a, b) + Mat3::dyad(b, a)
}

fn square(a: Vec3) -> Mat3 {
    Mat3::dyad(a, a)
}

impl Sums {
    /// Of the inner polyhedron, a slab on each face, a sector of a cylinder along each edge and a sector of a ball at each vertex.
    fn of(inner: &Polyhedron, normals: &[Vec<Vec3>], radius: f64) -> Self {
        let mut sums = Self { volume: 0.0, first: Vec3::ZERO, second: Mat3::ZERO };
        if let Ok(Solid { volume, centre, inertia }) = inner.solid() {
            let [a, b, c] = inertia.rows;
            let half = 0.5 * (a.x + b.y + c.z);
            let own = Mat3::diagonal(half, half, half) - inertia;
            sums.add(volume, centre * volume, own + square(centre) * volume);
        }
        for face in inner.faces() {
            let place = |i: usize| inner.vertices()[face.corners[i]];
            for k in 1..face.corners.len() - 1 {
                sums.slab([place(0), place(k), place(k + 1)], face.normal, radius);
            }
        }
        for (ends, normals) in inner.edges() {
            sums.edge(ends.map(|end| inner.vertices()[end]), normals, radius);
        }
        for (place, normals) in inner.vertices().iter().zip(normals) {
            if let [a, b, c] = normals[..] {
                sums.corner(*place, [a, b, c], radius);
            }
        }
        // All corners together have the directions of one ball.
        let ball = 4.0 / 15.0 * std::f64::consts::PI * radius.powi(5);
        sums.add(0.0, Vec3::ZERO, Mat3::diagonal(ball, ball, ball));
        sums
    }

    fn add(&mut self, volume: f64, first: Vec3, second: Mat3) {
        self.volume += volume;
        self.first += first;
        self.second = self.second + second;
    }

    /// A prism of the height ρ on a triangle.
    fn slab(&mut self, [a, b, c]: [Vec3; 3], normal: Vec3, radius: f64) {
        let area = 0.5 * (b - a).cross(c - a).norm();
        let sum = a + b + c;
        let first = sum * (area / 3.0);
        let second = (square(a) + square(b) + square(c) + square(sum)) * (area / 12.0);
        let thick = radius * radius;
        self.add(
            area * radius,
            first * radius + normal * (0.5 * area * thick),
            second * radius
                + mixed(first, normal) * (0.5 * thick)
                + square(normal) * (area * radius * thick / 3.0),
        );
    }

    /// A sector of a cylinder between two faces.
    fn edge(&mut self, [from, to]: [Vec3; 2], [a, b]: [Vec3; 2], radius: f64) {
        let (Some(middle), Some(aside)) = ((a + b).unit(), (b - a).unit()) else { return };
        let angle = atan2(a.cross(b).norm(), a.dot(b));
        let (sine, half) = (a.cross(b).norm(), 0.5 * (b - a).norm());
        let length = (to - from).norm();
        let first = (from + to) * (0.5 * length);
        let second = (square(from) + square(to) + mixed(from, to) * 0.5) * (length / 3.0);
        let directions = middle * (2.0 * half);
        let dyads = square(middle) * (0.5 * (angle + sine)) + square(aside) * (0.5 * (angle - sine));
        let (two, three, four) = (radius.powi(2) / 2.0, radius.powi(3) / 3.0, radius.powi(4) / 4.0);
        self.add(
            length * angle * two,
            first * (angle * two) + directions * (length * three),
            second * (angle * two) + mixed(first, directions) * three + dyads * (length * four),
        );
    }

    /// A sector of a ball between three faces, but for the dyads of its directions, which count for all corners together.
    fn corner(&mut self, place: Vec3, [a, b, c]: [Vec3; 3], radius: f64) {
        let triple = a.dot(b.cross(c)).abs();
        let angle = 2.0 * atan2(triple, 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
        let side = |a: Vec3, b: Vec3| {
            let across = a.cross(b);
            across.unit().unwrap_or(Vec3::ZERO) * (0.5 * atan2(across.norm(), a.dot(b)))
        };
        let directions = side(a, b) + side(b, c) + side(c, a);
        let (three, four) = (radius.powi(3) / 3.0, radius.powi(4) / 4.0);
        self.add(
            angle * three,
            place * (angle * three) + directions * four,
            square(place) * (angle * three) + mixed(place, directions) * four,
        );
    }

    fn solid(&self) -> Solid {
        let centre = self.first / self.volume;
        let about = self.second - square(centre) * self.volume;
        Solid { volume: self.volume, centre, inertia: inertia_of(about) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn cuboid([a, b, c]: [f64; 3]) -> Polyhedron {
        let sign = |i: u32, k: u32| f64::from(i >> k & 1);
        let points: Vec<Vec3> =
            (0..8).map(|i| Vec3::new(a * sign(i, 0), b * sign(i, 1), c * sign(i, 2))).collect();
        Polyhedron::of_points(&points, 1e-9).unwrap()
    }

    /// A box whose inner one is a line, but for a millionth, is a capsule: a cylinder and two half balls.
    #[test]
    fn a_long_box_that_is_rounded_as_much_as_it_can_be_is_a_capsule() {
        let (radius, length, thin) = (0.5_f64, 2.0, 1e-7);
        let rounded = cuboid([length + 2.0 * radius, 2.0 * radius + thin, 2.0 * radius + thin])
            .rounded(radius)
            .unwrap();
        let (rod, ball) = (PI * radius * radius * length, 4.0 / 3.0 * PI * radius.powi(3));
        let axial = 0.5 * rod * radius * radius + 0.4 * ball * radius * radius;
        let half = 0.5 * length;
        let across = rod * (radius * radius / 4.0 + length * length / 12.0)
            + ball * (0.4 * radius * radius + half * half + 0.75 * radius * half);
        let Solid { volume, centre, inertia } = rounded.solid;
        assert!((volume - rod - ball).abs() < 1e-6, "{volume} and {}", rod + ball);
        let found = [inertia.rows[0].x, inertia.rows[1].y, inertia.rows[2].z];
        let off = |k: usize, wanted: f64| (found[k] / wanted - 1.0).abs();
        assert!(off(0, axial) < 1e-6 && off(1, across) < 1e-6 && off(2, across) < 1e-6, "{found:?}");
        assert!((centre - Vec3::new(1.5, 0.5, 0.5)).norm() < 1e-6, "{centre:?}");
    }

    /// The sums of a skew prism do not depend on where it lies or how it is turned.
    #[test]
    fn a_rounded_prism_is_the_same_elsewhere() {
        let corners = [[0.0, 0.0], [1.3, 0.2], [0.4, 0.9]];
        let place = |z: f64| corners.map(|[x, y]| Vec3::new(x + 0.2 * z, y - 0.1 * z, z));
        let points: Vec<Vec3> = [place(0.0), place(0.7)].concat();
        let turn = carom_num::Rotation::by(Vec3::new(0.4, -1.0, 0.3));
        let moved: Vec<Vec3> = points.iter().map(|r| turn.apply(*r) + Vec3::new(3.0, 1.0, -2.0)).collect();
        let of = |points: &[Vec3]| Polyhedron::of_points(points, 1e-9).unwrap().rounded(0.1).unwrap().solid;
        let (one, other) = (of(&points), of(&moved));
        assert_eq!(other.inertia, other.inertia.transposed(), "a body wants it symmetric to the last digit");
        assert!((one.volume - other.volume).abs() < 1e-14, "{one:?} {other:?}");
        let centre = turn.apply(one.centre) + Vec3::new(3.0, 1.0, -2.0) - other.centre;
        assert!(centre.norm() < 1e-13, "{centre:?}");
        let inertia = turn.turn(one.inertia) - other.inertia;
        assert!(inertia.rows.iter().all(|row| row.norm() < 1e-13), "{inertia:?}");
    }

    #[test]
    fn a_corner_of_four_faces_is_not_rounded() {
        let mut points = vec![Vec3::Z];
        points
            .extend([(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| Vec3::new(x, y, 0.0)));
        let pyramid = Polyhedron::of_points(&points, 1e-9).unwrap();
        assert_eq!(pyramid.rounded(0.1), Err(RoundingProblem::Faces { vertex: 0, faces: 4 }));
        assert!(matches!(pyramid.rounded(f64::NAN), Err(RoundingProblem::Radius { .. })));
    }
}
