//! A solid part, by the faces that it may lie on.

use crate::tolerance::{DRAWN_FLAT, ON_FACE, SAME_CORNER};
use carom_motion::spatial::{Body, BodyProblem, Feature, Polyhedron, Solid};
use carom_num::{Mat3, Vec3};

/// A plane face of a part: on it the part may lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Unit normal, outwards, body axes.
    pub normal: Vec3,
    /// The points of the body at its corners, counter-clockwise as seen from outside; of a rounded part the middles of the balls there.
    pub corners: Vec<usize>,
    /// How far it is from the mass centre [m].
    pub depth: f64,
}

/// A solid part: a rigid body, and the faces of its convex hull.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Mass, inertia, and the corners of its hull, sharp or with a ball of one radius about each. Of a part with hollows its other corners follow.
    pub body: Body,
    /// The faces of the hull.
    pub faces: Vec<Face>,
}

/// A part as a picture has it, body axes [m].
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// Its corners.
    pub corners: Vec<Vec3>,
    /// Its faces by their corners, counter-clockwise as seen from outside.
    pub faces: Vec<Vec<usize>>,
    /// Of the first of them the numbers among [`Part::faces`]; the others are in a hollow, or facets of a round edge.
    pub numbers: Vec<usize>,
    /// Sides of faces that are no edges, each by the corners that it goes from and to: another one goes on there, on the same plane.
    pub seams: Vec<[usize; 2]>,
}

/// Why a hull and a mass make no part.
pub type PartProblem = Vec<BodyProblem>;

impl Part {
    /// A part whose surface is touched as its convex hull is, filled as `solid` says, of a density [kg/m³].
    ///
    /// # Errors
    /// All that is wrong with the body.
    ///
    /// # Example
    /// A cube of 1 m that is filled with 1000 kg/m³.
    /// ```
    /// use carom_feeder::spatial::Part;
    /// use carom_motion::spatial::{Polyhedron, examples::cube_corners};
    /// let hull = Polyhedron::of_points(&cube_corners(), 1e-9).unwrap();
    /// let cube = Part::of(&hull, &hull.solid().unwrap(), 1000.0)?;
    /// assert!((cube.body.mass() - 1000.0).abs() < 1e-9 && cube.faces.len() == 6);
    /// assert!(cube.faces.iter().all(|face| (face.depth - 0.5).abs() < 1e-15));
    /// # Ok::<(), Vec<carom_motion::spatial::BodyProblem>>(())
    /// ```
    pub fn of(hull: &Polyhedron, solid: &Solid, density: f64) -> Result<Self, PartProblem> {
        let (mass, inertia) = (density * solid.volume, solid.inertia * density);
        Self::about((hull, 0.0), solid.centre, (mass, inertia))
    }

    /// The same of a known mass [kg] and inertia about a known mass centre [kg m², m]. The hull is rounded by balls of a radius [m] about all of its places; 0 leaves it sharp.
    ///
    /// # Errors
    /// As [`Part::of`].
    ///
    /// # Example
    /// A cube of 1 m whose edges are rounded by 0.1 m: its faces stay where they are.
    /// ```
    /// use carom_feeder::spatial::Part;
    /// use carom_motion::spatial::{Polyhedron, examples::cube_corners};
    /// let rounding = Polyhedron::of_points(&cube_corners(), 1e-9).unwrap().rounded(0.1).unwrap();
    /// let solid = rounding.solid;
    /// let cube = Part::about((&rounding.inner, 0.1), solid.centre, (solid.volume, solid.inertia))?;
    /// assert_eq!(cube.body.rounding(), Some(0.1));
    /// assert!(cube.faces.iter().all(|face| (face.depth - 0.5).abs() < 1e-15));
    /// # Ok::<(), Vec<carom_motion::spatial::BodyProblem>>(())
    /// ```
    pub fn about(
        (hull, radius): (&Polyhedron, f64),
        centre: Vec3,
        (mass, inertia): (f64, Mat3),
    ) -> Result<Self, PartProblem> {
        let corners: Vec<Vec3> = hull.vertices().iter().map(|vertex| *vertex - centre).collect();
        let face = |face: &carom_motion::spatial::Face| Face {
            normal: face.normal,
            depth: face
                .corners
                .iter()
                .map(|i| face.normal.dot(corners[*i]))
                .fold(f64::NEG_INFINITY, f64::max)
                + radius,
            corners: face.corners.clone(),
        };
        let faces = hull.faces().iter().map(face).collect();
        let features = corners.iter().map(|r| Feature::point(*r).rounded(radius)).collect();
        Ok(Self { body: Body::of(mass, inertia, features)?, faces })
    }

    /// A part that touches with its hollows too: its hull, and the convex pieces that it consists of. Mass [kg], mass centre [m] and inertia about it [kg m²] are those of all of them.
    ///
    /// # Errors
    /// As [`Part::of`]; and a corner of the hull that is none of the pieces.
    pub fn of_pieces(
        (hull, pieces): (&Polyhedron, &[Polyhedron]),
        centre: Vec3,
        (mass, inertia): (f64, Mat3),
    ) -> Result<Self, PartProblem> {
        let of_hull: Vec<Vec3> = hull.vertices().iter().map(|vertex| *vertex - centre).collect();
        let pieces: Vec<Polyhedron> = pieces.iter().map(|piece| piece.moved_by(-centre)).collect();
        let body = Body::of_pieces(mass, inertia, &pieces, &of_hull)?;
        let near = SAME_CORNER * body.reach();
        let has = |corner: &usize| {
            let at = body.supports().get(*corner);
            at.is_some_and(|r| (*r - of_hull[*corner]).norm() <= near)
        };
        let hidden: Vec<BodyProblem> = (0..of_hull.len())
            .filter(|corner| !has(corner))
            .map(|corner| BodyProblem::Hidden { corner })
            .collect();
        if !hidden.is_empty() {
            return Err(hidden);
        }
        let at = |corner: &usize| body.supports()[*corner];
        let face = |face: &carom_motion::spatial::Face| {
            let corners: Vec<Vec3> = face.corners.iter().map(at).collect();
            // Where the pieces have it: they lie on one plane with all that is on this face.
            let normal = area(&corners).unit().unwrap_or(face.normal);
            // Of all corners, those that others hide too: what starts on it is in nothing.
            let all = pieces.iter().flat_map(Polyhedron::vertices);
            let depth = all.map(|r| normal.dot(*r)).fold(f64::NEG_INFINITY, f64::max);
            Face { normal, depth, corners: face.corners.clone() }
        };
        Ok(Self { faces: hull.faces().iter().map(face).collect(), body })
    }

    /// Its surface as a picture has it. Faces of the hull come first, by their numbers; of a rounded part facets between them follow, two along a round edge. Of a part with hollows there are the
    /// faces of its pieces: several may be parts of one face of the hull, and none be where a face of the hull goes over a hollow.
    ///
    /// # Example
    /// A rounded cube: its 6 faces come first.
    /// ```
    /// use carom_feeder::spatial::{Part, Shown};
    /// use carom_motion::spatial::{Polyhedron, examples::cube_corners};
    /// let rounding = Polyhedron::of_points(&cube_corners(), 1e-9).unwrap().rounded(0.1).unwrap();
    /// let solid = rounding.solid;
    /// let cube = Part::about((&rounding.inner, 0.1), solid.centre, (solid.volume, solid.inertia))?;
    /// let Shown { corners, faces, numbers, .. } = cube.shown();
    /// assert!(faces.len() > 6 && faces[0].len() == 4 && numbers.len() == 6);
    /// assert!(faces[2].iter().all(|corner| (cube.faces[2].normal.dot(corners[*corner]) - 0.5).abs() < 1e-12));
    /// # Ok::<(), Vec<carom_motion::spatial::BodyProblem>>(())
    /// ```
    pub fn shown(&self) -> Shown {
        if !self.body.polygons().is_empty() {
            return self.shown_in_pieces();
        }
        let corners = self.body.supports();
        let numbers: Vec<usize> = (0..self.faces.len()).collect();
        let sharp = || Shown {
            corners: corners.to_vec(),
            faces: self.faces.iter().map(|face| face.corners.clone()).collect(),
            numbers: numbers.clone(),
            seams: vec![],
        };
        let Some(radius) = self.body.rounding().filter(|radius| *radius > 0.0) else { return sharp() };
        let around = |corner: usize| self.faces.iter().filter(move |face| face.corners.contains(&corner));
        let mut places = vec![];
        for (corner, at) in corners.iter().enumerate() {
            let normals: Vec<Vec3> = around(corner).map(|face| face.normal).collect();
            let pairs =
                normals.iter().enumerate().flat_map(|(k, a)| normals[k..].iter().map(move |b| *a + *b));
            let all = normals.iter().fold(Vec3::ZERO, |sum, normal| sum + *normal);
            places.extend(pairs.chain([all]).filter_map(Vec3::unit).map(|out| *at + out * radius));
        }
        let flatness = DRAWN_FLAT * self.body.reach();
        let Ok(hull) = Polyhedron::of_points(&places, flatness) else { return sharp() };
        let own = |face: &carom_motion::spatial::Face| self.facing(face.normal).unwrap_or(usize::MAX);
        let mut faces: Vec<&carom_motion::spatial::Face> = hull.faces().iter().collect();
        faces.sort_by_key(|face| own(face));
        let faces = faces.into_iter().map(|face| face.corners.clone()).collect();
        Shown { corners: hull.vertices().to_vec(), faces, numbers, seams: vec![] }
    }

    fn shown_in_pieces(&self) -> Shown {
        let number = |polygon: &&Vec<Vec3>| {
            let normal = area(polygon).unit()?;
            self.on_plane(normal, normal.dot(polygon[0]))
        };
        let mut polygons: Vec<(Option<usize>, &Vec<Vec3>)> =
            self.body.polygons().iter().map(|polygon| (number(&polygon), polygon)).collect();
        polygons.sort_by_key(|(number, _)| number.unwrap_or(usize::MAX));
        let near = ON_FACE * self.body.reach();
        let (mut corners, mut faces, mut seams) = (vec![], vec![], vec![]);
        for (k, (_, polygon)) in polygons.iter().enumerate() {
            let others = polygons.iter().enumerate().filter(|(other, _)| *other != k);
            let sides = split(polygon, others.map(|(_, (_, other))| &other[..]), near);
            let number = |side: usize| corners.len() + side % sides.len();
            let inner = sides.iter().enumerate().filter(|(_, (_, goes_on))| *goes_on);
            seams.extend(inner.map(|(side, _)| [number(side), number(side + 1)]));
            faces.push((0..sides.len()).map(number).collect());
            corners.extend(sides.iter().map(|(from, _)| *from));
        }
        Shown {
            corners,
            faces,
            numbers: polygons.into_iter().filter_map(|(number, _)| number).collect(),
            seams,
        }
    }

    /// The number of a face of the body that has this unit normal: of one in a hollow it comes after those of [`Part::faces`].
    pub(super) fn numbered(&self, face: usize, normal: Vec3) -> usize {
        let Some(polygon) = self.body.polygons().get(face) else {
            return self.facing(normal).unwrap_or(face);
        };
        self.on_plane(normal, normal.dot(polygon[0])).unwrap_or(self.faces.len() + face)
    }

    /// The face on the plane with this unit normal, so far from the mass centre [m]; `None` where there is none.
    fn on_plane(&self, normal: Vec3, depth: f64) -> Option<usize> {
        let near = ON_FACE * self.body.reach();
        self.facing(normal).filter(|face| (self.faces[*face].depth - depth).abs() <= near)
    }

    /// The face that a part on a plane rests on with these points of its body; `None` where they belong to no face together.
    pub fn face_of(&self, points: impl Iterator<Item = usize>) -> Option<usize> {
        let points: Vec<usize> = points.collect();
        let near = ON_FACE * self.body.reach();
        let is_on = |face: &Face, point: usize| {
            (face.normal.dot(self.body.supports()[point]) + self.body.rounding().unwrap_or_default()
                - face.depth)
                .abs()
                <= near
        };
        self.faces.iter().position(|face| points.iter().all(|point| is_on(face, *point)))
    }

    /// The face with this unit normal, body axes; `None` where there is none.
    pub fn facing(&self, normal: Vec3) -> Option<usize> {
        self.faces.iter().position(|face| (face.normal - normal).norm() <= crate::tolerance::OPPOSITE)
    }

    /// The face that looks the other way, by its number; `None` where there is none.
    pub fn opposite(&self, face: usize) -> Option<usize> {
        self.facing(-self.faces.get(face)?.normal)
    }
}

/// The normal of a polygon, as long as twice its area.
fn area(corners: &[Vec3]) -> Vec3 {
    let Some((first, others)) = corners.split_first() else { return Vec3::ZERO };
    others
        .windows(2)
        .map(|pair| (pair[0] - *first).cross(pair[1] - *first))
        .fold(Vec3::ZERO, |sum, area| sum + area)
}

/// Where each side of a polygon begins, and whether another polygon goes on beyond it on the same plane: sides are split where that begins and ends.
fn split<'p>(polygon: &[Vec3], others: impl Iterator<Item = &'p [Vec3]>, near: f64) -> Vec<(Vec3, bool)> {
    let sides = |polygon: &[Vec3]| {
        let next = polygon.iter().copied().cycle().skip(1);
        polygon.iter().copied().zip(next).collect::<Vec<(Vec3, Vec3)>>()
    };
    let normal = area(polygon);
    let level = |other: &&[Vec3]| {
        other.iter().all(|r| normal.dot(*r - polygon[0]).abs() <= near * normal.norm())
            && area(other).dot(normal) > 0.0
    };
    let beyond: Vec<(Vec3, Vec3)> = others.filter(level).flat_map(sides).collect();
    let mut found = vec![];
    for (from, to) in sides(polygon) {
        let Some(along) = (to - from).unit() else { continue };
        let length = (to - from).norm();
        // Its neighbours have the side the other way round.
        let spans: Vec<[f64; 2]> = beyond
            .iter()
            .filter(|(a, b)| [a, b].iter().all(|r| along.cross(**r - from).norm() <= near))
            .map(|(a, b)| [b, a].map(|r| along.dot(*r - from).clamp(0.0, length)))
            .filter(|[first, last]| last - first > near)
            .collect();
        let mut cuts: Vec<f64> = spans.as_flattened().iter().copied().chain([0.0, length]).collect();
        cuts.sort_by(f64::total_cmp);
        for span in cuts.windows(2).filter(|span| span[1] - span[0] > near) {
            let middle = 0.5 * (span[0] + span[1]);
            let goes_on = spans.iter().any(|[first, last]| *first < middle && middle < *last);
            found.push((from + along * span[0], goes_on));
        }
    }
    found
}
