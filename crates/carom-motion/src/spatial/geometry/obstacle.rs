//! What a body may touch.

use super::plane::Plane;
use super::polyhedron::Polyhedron;
use super::surface::{Edge, Facet, Surface};
use crate::tolerance::FLAT_PLATE;
use carom_num::Vec3;
use thiserror::Error;

/// Something convex that does not move: a plane without ends, a plate, a solid, or a round pin.
///
/// # Example
/// A cube of 1 m lies on a level plate and hangs over its end, by 40 % of its length and by 60 %: it rests there, or tips over and falls on the floor, 3 m down.
/// ```
/// use carom_motion::spatial::{Body, End, Friction, Obstacle, Options, Plane, State, World, run};
/// use carom_num::{Mat3, Rotation, Vec3};
/// let ends = |over: f64| {
///     let half = |i: u32, bit: u32| if i >> bit & 1 == 1 { 0.5 } else { -0.5 };
///     let corners = (0..8).map(|i| Vec3::new(half(i, 0), half(i, 1), half(i, 2))).collect();
///     let cube = Body::new(6.0, Mat3::IDENTITY, corners).unwrap();
///     let outline = [(-9.0, -1.0), (0.0, -1.0), (0.0, 1.0), (-9.0, 1.0)];
///     let plate = Obstacle::plate(&outline.map(|(x, y)| Vec3::new(x, y, 0.0))).unwrap();
///     let floor = Plane::new(Vec3::Z, -3.0).unwrap();
///     let world = World::new(cube, Vec3::Z * -10.0).unwrap().with_friction(Friction::new(0.5)).unwrap();
///     let world = world.among(vec![plate, floor.into()]).unwrap();
///     let centre = Vec3::new(over - 0.5, 0.0, 0.5);
///     let start = State { centre, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO };
///     run(&world, &start, &Options::default(), &mut ()).unwrap()
/// };
/// let (rests, tips) = (ends(0.4), ends(0.6));
/// assert!(matches!(rests.end, End::AtRest { .. }) && rests.state.centre.z == 0.5);
/// assert!(matches!(tips.end, End::AtRest { .. }) && (tips.state.centre.z + 2.5).abs() < 1e-9);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Obstacle {
    pub(in crate::spatial) surface: Surface,
    pub(in crate::spatial) rough: Rough,
}

/// Friction and restitution that an obstacle has of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::spatial) struct Rough {
    pub(in crate::spatial) friction: Option<f64>,
    pub(in crate::spatial) restitution: Option<f64>,
}

/// Corners that no plate has.
///
/// # Example
/// ```
/// use carom_motion::spatial::{Obstacle, PlateProblem};
/// use carom_num::Vec3;
/// assert_eq!(Obstacle::plate(&[Vec3::X, Vec3::Y]), Err(PlateProblem::TooFew { count: 2 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlateProblem {
    /// Fewer than three.
    #[error("a plate has 3 corners or more, not {count}")]
    TooFew {
        /// How many there are.
        count: usize,
    },
    /// A corner that is not finite.
    #[error("corner {corner} of a plate is not finite")]
    NotFinite {
        /// Its number.
        corner: usize,
    },
    /// Corners on one line, or in one place.
    #[error("the corners of a plate lie on one line")]
    Line,
    /// A corner that is not on the plane of the others.
    #[error("corner {corner} of a plate is {distance} m from the plane of the others")]
    NotFlat {
        /// Its number.
        corner: usize,
        /// How far it is from the plane \[m\].
        distance: f64,
    },
    /// A corner at which the outline turns inwards, or does not turn.
    #[error("a plate turns the same way at all its corners: not at corner {corner}")]
    NotConvex {
        /// Its number.
        corner: usize,
    },
}

/// Numbers that no ball has.
///
/// # Example
/// ```
/// use carom_motion::spatial::{Obstacle, RadiusProblem};
/// use carom_num::Vec3;
/// assert_eq!(Obstacle::pin([Vec3::X, -Vec3::X], 0.0), Err(RadiusProblem { radius: 0.0 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("a radius of {radius} m: it must be finite and > 0, and the places that it is about finite")]
pub struct RadiusProblem {
    /// What it is \[m\].
    pub radius: f64,
}

impl From<Plane> for Obstacle {
    fn from(plane: Plane) -> Self {
        let face = Facet { plane, limits: vec![] };
        Self::of(Surface { faces: vec![face], ..Surface::default() })
    }
}

impl Obstacle {
    /// A thin flat plate with these corners, in their order around it \[m\]. It is touched on both sides, along its edges and at its corners.
    ///
    /// # Errors
    /// The first problem.
    ///
    /// # Example
    /// A corner is a millimetre out of the plane.
    /// ```
    /// use carom_motion::spatial::{Obstacle, PlateProblem};
    /// use carom_num::Vec3;
    /// let corners = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 1e-3), Vec3::Y];
    /// assert!(matches!(Obstacle::plate(&corners), Err(PlateProblem::NotFlat { .. })));
    /// ```
    pub fn plate(corners: &[Vec3]) -> Result<Self, PlateProblem> {
        let count = corners.len();
        if count < 3 {
            return Err(PlateProblem::TooFew { count });
        }
        if let Some(corner) = corners.iter().position(|r| !r.is_finite()) {
            return Err(PlateProblem::NotFinite { corner });
        }
        let (normal, size) = outline(corners)?;
        let around = |k: usize| (corners[k], corners[(k + 1) % count]);
        let face = Facet::of(normal, corners);
        for (corner, r) in corners.iter().enumerate() {
            let distance = normal.dot(*r - corners[0]).abs();
            if distance > FLAT_PLATE * size {
                return Err(PlateProblem::NotFlat { corner, distance });
            }
            let (next, after) = (corners[(corner + 1) % count] - *r, corners[(corner + 2) % count] - *r);
            let turns =
                normal.dot(next.cross(after - next)) > FLAT_PLATE * next.norm() * (after - next).norm();
            if !turns || face.limits.iter().any(|limit| limit.margin(*r) < -FLAT_PLATE * size) {
                return Err(PlateProblem::NotConvex { corner: (corner + 1) % count });
            }
        }
        // What winds around itself twice is within its own sides too.
        let again = |k: &usize| corners[..*k].iter().any(|r| (*r - corners[*k]).norm() <= FLAT_PLATE * size);
        if let Some(corner) = (1..count).find(again) {
            return Err(PlateProblem::NotConvex { corner });
        }
        let back: Vec<Vec3> = corners.iter().rev().copied().collect();
        let edge = |k: usize| Edge::of_plate(around(k).0, around(k).1, normal);
        let edges: Vec<Edge> = (0..count).filter_map(edge).collect();
        let spokes = (0..count).map(|k| vec![edges[k].along, -edges[(k + count - 1) % count].along]);
        Ok(Self::of(Surface {
            radius: 0.0,
            spokes: spokes.collect(),
            faces: vec![face, Facet::of(-normal, &back)],
            edges,
            corners: corners.to_vec(),
        }))
    }

    /// A convex solid, which stands where its vertices are \[m\].
    ///
    /// # Example
    /// A cube of 1 m as a block on which other things fall.
    /// ```
    /// use carom_motion::spatial::{Obstacle, Polyhedron, examples};
    /// let block = Polyhedron::of_points(&examples::cube_corners(), 1e-9)?;
    /// assert_ne!(Obstacle::solid(&block), Obstacle::from(carom_motion::spatial::Plane::FLOOR));
    /// # Ok::<(), Vec<carom_motion::spatial::HullProblem>>(())
    /// ```
    pub fn solid(shape: &Polyhedron) -> Self {
        Self::of(Surface::of(shape, shape.vertices()))
    }

    /// A round pin: all places that are within a radius \[m\] of the line between two ends \[m\], so that its ends are half balls; of two ends in one place a ball.
    ///
    /// # Errors
    /// Numbers that no pin has.
    ///
    /// # Example
    /// A cube of 1 m falls on a pin under one side of it, tips over that, and rolls off.
    /// ```
    /// use carom_motion::spatial::{Body, Friction, Obstacle, Options, Plane, State, World, examples, run};
    /// use carom_num::{Rotation, Vec3};
    /// let pin = Obstacle::pin([Vec3::Y * -2.0, Vec3::Y * 2.0], 0.2)?;
    /// let world = World::new(examples::block(), Vec3::Z * -10.0).unwrap().with_friction(Friction::new(0.5)).unwrap();
    /// let world = world.among(vec![pin, Plane::new(Vec3::Z, -3.0).unwrap().into()]).unwrap();
    /// let centre = Vec3::new(0.4, 0.0, 0.75);
    /// let start = State { centre, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    /// let run = run(&world, &start, &Options::default(), &mut ()).unwrap();
    /// // It meets the pin 0.05 m further down.
    /// assert!((run.impacts[0].time - 0.1).abs() < 1e-12 && run.state.centre.z < -2.0);
    /// # Ok::<(), carom_motion::spatial::RadiusProblem>(())
    /// ```
    pub fn pin(ends: [Vec3; 2], radius: f64) -> Result<Self, RadiusProblem> {
        let is_one = radius > 0.0 && radius.is_finite() && ends.iter().all(|r| r.is_finite());
        let points = if ends[0] == ends[1] { &ends[..1] } else { &ends[..] };
        if is_one { Ok(Self::of(Surface::of_round(points, radius))) } else { Err(RadiusProblem { radius }) }
    }

    /// The same, with a ball of this radius \[m\] about every place of it: a solid with round edges that is larger all around, a plate as thick as two radii, a pin with more.
    ///
    /// # Errors
    /// A radius that no ball has.
    ///
    /// # Example
    /// A cube of 1 m rests on a rounded plate by the radius higher than on a thin one.
    /// ```
    /// use carom_motion::spatial::{Friction, Obstacle, State, World, examples};
    /// use carom_num::{Rotation, Vec3};
    /// let outline = [(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)];
    /// let plate = Obstacle::plate(&outline.map(|(x, y)| Vec3::new(x, y, 0.0))).unwrap();
    /// let world = World::new(examples::block(), Vec3::Z * -10.0).unwrap().with_friction(Friction::new(0.5)).unwrap();
    /// let among = world.among(vec![plate.rounded(0.1)?]).unwrap();
    /// let state = State { centre: Vec3::Z * 0.59, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    /// assert!((among.reaches_into(&state, 0.0)[0].1 - 0.01).abs() < 1e-15);
    /// # Ok::<(), carom_motion::spatial::RadiusProblem>(())
    /// ```
    pub fn rounded(mut self, radius: f64) -> Result<Self, RadiusProblem> {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(RadiusProblem { radius });
        }
        self.surface.radius += radius;
        Ok(self)
    }

    /// The same with a friction coefficient of its own, in place of the world's. [`World::among`](super::world::World::among) refuses one below 0.
    ///
    /// # Example
    /// A body on two level planes side by side would slide from the one to the other: here on a plane as smooth as ice, between walls of rubber.
    /// ```
    /// use carom_motion::spatial::{Friction, Obstacle, Plane, World, examples};
    /// use carom_num::Vec3;
    /// let wall = |x: f64| Obstacle::from(Plane::new(Vec3::X * x, -2.0).unwrap()).with_friction(0.9);
    /// let world = World::new(examples::block(), Vec3::Z * -10.0).unwrap().with_friction(Friction::new(0.01)).unwrap();
    /// let among = world.among(vec![Plane::FLOOR.into(), wall(1.0), wall(-1.0)]).unwrap();
    /// // The cube's eight corners on the floor, then on each of the walls.
    /// assert_eq!([0, 8, 16].map(|i| among.friction().unwrap().coefficient(i)), [0.01, 0.9, 0.9]);
    /// ```
    #[must_use]
    pub fn with_friction(mut self, friction: f64) -> Self {
        self.rough.friction = Some(friction);
        self
    }

    /// The same with a coefficient of restitution of its own, in place of the world's. [`World::among`](super::world::World::among) refuses one outside [0, 1].
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::{Friction, Obstacle, Plane, World, examples};
    /// use carom_num::Vec3;
    /// let floor = Obstacle::from(Plane::FLOOR).with_restitution(0.5);
    /// let world = World::new(examples::block(), Vec3::Z * -10.0).unwrap().with_friction(Friction::new(0.3)).unwrap();
    /// assert_eq!(world.among(vec![floor]).unwrap().friction().unwrap().restitution(0), 0.5);
    /// ```
    #[must_use]
    pub fn with_restitution(mut self, restitution: f64) -> Self {
        self.rough.restitution = Some(restitution);
        self
    }

    /// One with the world's friction.
    fn of(surface: Surface) -> Self {
        Self { surface, rough: Rough::default() }
    }
}

/// The unit normal of a polygon, and its size \[m\].
fn outline(corners: &[Vec3]) -> Result<(Vec3, f64), PlateProblem> {
    let from = |r: &Vec3| *r - corners[0];
    let size = corners.iter().flat_map(|r| from(r).to_array()).fold(0.0, |most: f64, x| most.max(x.abs()));
    let shape: Vec<Vec3> = corners.iter().map(|r| from(r) / size).collect();
    let farthest = shape.iter().max_by(|a, b| a.norm().total_cmp(&b.norm())).and_then(|r| r.unit());
    let along = farthest.filter(|along| along.is_finite()).ok_or(PlateProblem::Line)?;
    let (distance, corner) = shape.iter().enumerate().fold((0.0, 0), |(most, corner), (k, r)| {
        let distance = r.cross(along).norm();
        if distance > most { (distance, k) } else { (most, corner) }
    });
    if distance <= FLAT_PLATE {
        return Err(PlateProblem::Line);
    }
    let area = super::hull::newell(&shape);
    let normal =
        area.unit().filter(|_| area.norm() > FLAT_PLATE).ok_or(PlateProblem::NotConvex { corner })?;
    Ok((normal, size))
}
