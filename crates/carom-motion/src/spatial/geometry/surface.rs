//! Faces, edges and corners of what is convex: of a body, in its axes from the mass centre, or of an obstacle, in the world's.

use super::hull::sides;
use super::plane::Plane;
use super::polyhedron::Polyhedron;
use super::state::Pose;
use crate::tolerance::PARALLEL_EDGES;
use carom_num::Vec3;
use carom_num::segment::distance;

/// A half-space: `inward · r + offset` is positive in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::spatial) struct Limit {
    pub(in crate::spatial) inward: Vec3,
    pub(in crate::spatial) offset: f64,
}

impl Limit {
    /// How far inside a place is \[m\].
    pub(in crate::spatial) fn margin(&self, place: Vec3) -> f64 {
        self.inward.dot(place) + self.offset
    }
}

/// A flat face: the places of a plane that are within all limits.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::spatial) struct Facet {
    /// Its normal is outwards.
    pub(in crate::spatial) plane: Plane,
    pub(in crate::spatial) limits: Vec<Limit>,
}

/// An edge between two faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::spatial) struct Edge {
    pub(in crate::spatial) from: Vec3,
    /// Unit vector.
    pub(in crate::spatial) along: Vec3,
    pub(in crate::spatial) length: f64,
    /// Unit vectors across the edge into each of the faces.
    pub(in crate::spatial) sides: [Vec3; 2],
    /// The middle of the directions in which its outside lies.
    pub(in crate::spatial) outward: Vec3,
    /// Whether it ends in a corner, where it begins and where it ends: in an inner corner it does not.
    pub(in crate::spatial) corners: [bool; 2],
}

/// Faces, edges and corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::spatial) struct Surface {
    pub(in crate::spatial) faces: Vec<Facet>,
    pub(in crate::spatial) edges: Vec<Edge>,
    pub(in crate::spatial) corners: Vec<Vec3>,
    /// Unit vectors from each corner along its edges.
    pub(in crate::spatial) spokes: Vec<Vec<Vec3>>,
    /// Of the ball about every place of it: 0 of what is sharp.
    pub(in crate::spatial) radius: f64,
}

impl Edge {
    /// Where it begins and where it ends.
    pub(in crate::spatial) fn ends(&self) -> [Vec3; 2] {
        [self.from, self.from + self.along * self.length]
    }
}

impl Facet {
    /// A segment goes through it.
    fn is_crossed(&self, [a, b]: [Vec3; 2]) -> bool {
        let [low, high] = [a, b].map(|r| self.plane.height(r));
        if low * high >= 0.0 {
            return false;
        }
        let at = a + (b - a) * (low / (low - high));
        self.limits.iter().all(|limit| limit.margin(at) >= 0.0)
    }

    /// The same face, so far outside.
    pub(in crate::spatial) fn raised(&self, by: f64) -> Self {
        Self { plane: self.plane.raised(by), limits: self.limits.clone() }
    }

    /// The face with these corners, counter-clockwise as seen from outside.
    pub(in crate::spatial) fn of(normal: Vec3, corners: &[Vec3]) -> Self {
        // Of corners that are not quite on one plane the outermost.
        let offset = corners.iter().map(|corner| normal.dot(*corner)).fold(f64::NEG_INFINITY, f64::max);
        let ends = (0..corners.len()).map(|k| (corners[k], corners[(k + 1) % corners.len()]));
        let limit = |(from, to): (Vec3, Vec3)| {
            let inward = normal.cross((to - from).unit()?);
            Some(Limit { inward, offset: -inward.dot(from) })
        };
        Self { plane: Plane::of_unit(normal, offset), limits: ends.filter_map(limit).collect() }
    }
}

impl Edge {
    /// The edge between two places and two faces with these normals. The first face has the edge in this direction around it, the other one against it.
    fn between(from: Vec3, to: Vec3, [first, second]: [Vec3; 2]) -> Option<Self> {
        let along = (to - from).unit()?;
        let sides = [first.cross(along), along.cross(second)];
        let (length, outward) = ((to - from).norm(), first + second);
        Some(Self { from, along, length, sides, outward, corners: [true; 2] })
    }

    /// The edge of a thin plate with this normal, counter-clockwise around it.
    pub(in crate::spatial) fn of_plate(from: Vec3, to: Vec3, normal: Vec3) -> Option<Self> {
        let along = (to - from).unit()?;
        let inward = normal.cross(along);
        let (length, outward) = ((to - from).norm(), -inward);
        Some(Self { from, along, length, sides: [inward; 2], outward, corners: [true; 2] })
    }

    /// The middle of the edge.
    pub(in crate::spatial) fn middle(&self) -> Vec3 {
        self.from + self.along * (0.5 * self.length)
    }
}

impl Surface {
    /// That of a ball, or of the balls at both ends of an edge and all between them.
    pub(in crate::spatial) fn of_round(points: &[Vec3], radius: f64) -> Self {
        let none =
            Self { corners: points.to_vec(), spokes: vec![vec![]; points.len()], radius, ..Self::default() };
        let [first, last] = points[..] else { return none };
        let Some(along) = (last - first).unit() else { return none };
        let length = (last - first).norm();
        // No face ends it: it touches all around.
        let (sides, outward) = ([Vec3::ZERO; 2], Vec3::ZERO);
        let edge = Edge { from: first, along, length, sides, outward, corners: [true; 2] };
        Self { edges: vec![edge], spokes: vec![vec![along], vec![-along]], ..none }
    }

    /// The ends of its edges; of what has none its corners, as edges without length.
    fn spans(&self) -> Vec<[Vec3; 2]> {
        match self.edges[..] {
            [] => self.corners.iter().map(|corner| [*corner; 2]).collect(),
            ref edges => edges.iter().map(Edge::ends).collect(),
        }
    }

    /// How far a place is from the balls about its edges or corners; negative inside them.
    pub(in crate::spatial) fn beyond_balls(&self, place: Vec3) -> f64 {
        let far = |ends: &[Vec3; 2]| distance([place; 2], *ends);
        self.spans().iter().map(far).fold(f64::INFINITY, f64::min) - self.radius
    }

    /// How far this one, which moves with a body, is from another one; negative where they overlap. Of two sharp ones that is [`Surface::separation`].
    pub(in crate::spatial) fn apart(&self, other: &Self, pose: Pose) -> f64 {
        let radius = self.radius + other.radius;
        if radius == 0.0 {
            return self.separation(other, pose);
        }
        let placed = |r: Vec3| pose.centre + pose.attitude.apply(r);
        let own: Vec<Vec3> = self.corners.iter().map(|r| placed(*r)).collect();
        let seen: Vec<Vec3> = other.corners.iter().map(|r| pose.attitude.undo(*r - pose.centre)).collect();
        let spans: Vec<[Vec3; 2]> = self.spans().into_iter().map(|ends| ends.map(placed)).collect();
        let others = other.spans();
        let of_edges = spans.iter().flat_map(|own| others.iter().map(|ends| distance(*own, *ends)));
        let above = |faces: &[Facet], corners: &[Vec3]| {
            let over = |face: &Facet| {
                let inside = |r: &Vec3| face.limits.iter().all(|limit| limit.margin(*r) >= 0.0);
                let heights = corners.iter().filter(|r| inside(r)).map(|r| face.plane.height(*r));
                heights.filter(|height| *height >= 0.0).fold(f64::INFINITY, f64::min)
            };
            faces.iter().map(over).fold(f64::INFINITY, f64::min)
        };
        let distance = of_edges.fold(f64::INFINITY, f64::min);
        let distance = distance.min(above(&other.faces, &own)).min(above(&self.faces, &seen));
        // Where one is in the other some edge goes through a face, or all of it is inside.
        let crosses = |faces: &[Facet], ends: &[[Vec3; 2]]| {
            faces.iter().any(|face| ends.iter().any(|ends| face.is_crossed(*ends)))
        };
        let seen_edges: Vec<[Vec3; 2]> =
            others.iter().map(|ends| ends.map(|r| pose.attitude.undo(r - pose.centre))).collect();
        let within = |faces: &[Facet], corners: &[Vec3]| {
            !faces.is_empty()
                && corners.first().is_some_and(|r| faces.iter().all(|face| face.plane.height(*r) < 0.0))
        };
        let inside = crosses(&other.faces, &spans)
            || crosses(&self.faces, &seen_edges)
            || within(&other.faces, &own)
            || within(&self.faces, &seen);
        let deep = self.separation(other, pose).min(0.0);
        (if inside { deep } else { distance }) - radius
    }

    /// How far this one, which moves with a body, is from another one at least; negative where they overlap, by how far the body has to move to be beside it.
    ///
    /// # Source
    /// The separating axes of convex polyhedra: normals of faces, and perpendiculars of two edges. S. Gottschalk, M. C. Lin and D. Manocha, SIGGRAPH (1996) 171.
    pub(in crate::spatial) fn separation(&self, other: &Self, pose: Pose) -> f64 {
        let turned = |v: Vec3| pose.attitude.apply(v);
        let own: Vec<Vec3> = self.corners.iter().map(|r| pose.centre + turned(*r)).collect();
        let faces = self.faces.iter().map(|face| turned(face.plane.normal()));
        let across = |edge: &Edge| {
            let along = turned(edge.along);
            other.edges.iter().map(move |other| along.cross(other.along))
        };
        let across = self.edges.iter().flat_map(across).filter(|axis| axis.norm() > PARALLEL_EDGES);
        let axes = faces.chain(other.faces.iter().map(|face| face.plane.normal())).chain(across);
        let gap = |axis: Vec3| {
            let range = |corners: &[Vec3]| {
                let along = corners.iter().map(|r| axis.dot(*r));
                along.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
            };
            let ([a, b], [c, d]) = (range(&own), range(&other.corners));
            ((c - b).max(a - d)) / axis.norm()
        };
        axes.map(gap).fold(f64::NEG_INFINITY, f64::max)
    }

    /// That of a polyhedron whose vertices are at these places.
    pub(in crate::spatial) fn of(shape: &Polyhedron, places: &[Vec3]) -> Self {
        let place = |vertex: usize| places[vertex];
        let faces = shape.faces().iter().map(|face| {
            let corners: Vec<Vec3> = face.corners.iter().map(|i| place(*i)).collect();
            Facet::of(face.normal, &corners)
        });
        let (mut edges, mut spokes) = (vec![], vec![vec![]; shape.vertices().len()]);
        for (k, face) in shape.faces().iter().enumerate() {
            for (a, b) in sides(&face.corners) {
                let other = shape.faces()[k + 1..]
                    .iter()
                    .find(|other| sides(&other.corners).any(|(from, to)| (from, to) == (b, a)));
                let normals = other.map(|other| [face.normal, other.normal]);
                let edge = normals.and_then(|normals| Edge::between(place(a), place(b), normals));
                if let Some(edge) = edge {
                    spokes[a].push(edge.along);
                    spokes[b].push(-edge.along);
                    edges.push(edge);
                }
            }
        }
        Self { faces: faces.collect(), edges, corners: places.to_vec(), spokes, radius: 0.0 }
    }
}
