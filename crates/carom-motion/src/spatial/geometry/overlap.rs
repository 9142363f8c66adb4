//! How far a body is from what it must not be in: obstacles, and another body like it.

use super::body::Body;
use super::state::{Pose, State, measured};
use super::surface::Surface;
use super::world::{ObstaclesProblem, World, form_of};

impl World {
    /// The first obstacle with ends that the body is in, and how deep; where it touches one it is not deeper than `spare`.
    pub(in crate::spatial) fn overlap(&self, pose: Pose, spare: f64) -> Option<(usize, f64)> {
        let with_ends = self.obstacles.iter().enumerate().filter(|(_, other)| !other.corners.is_empty());
        let mut deep = with_ends.map(|(i, other)| (i, -self.surface.apart(other, pose)));
        deep.find(|(_, depth)| *depth > spare)
    }

    /// The obstacles that the body reaches into by more than `spare`, and how far \[m\]. No run starts so.
    ///
    /// # Example
    /// A cube of 1 m whose centre is 0.4 m above the floor.
    /// ```
    /// use carom_motion::spatial::{Friction, Plane, State, World, examples};
    /// use carom_num::{Rotation, Vec3};
    /// let (attitude, still) = (Rotation::NONE, Vec3::ZERO);
    /// let state = State { centre: Vec3::Z * 0.4, attitude, velocity: still, spin: still };
    /// let world = World::new(examples::block(), Vec3::Z * -10.0).unwrap().with_friction(Friction::new(0.1)).unwrap();
    /// let deep = world.among(vec![Plane::FLOOR]).unwrap().reaches_into(&state, 1e-9);
    /// assert!(deep.len() == 1 && (deep[0].1 - 0.1).abs() < 1e-15);
    /// ```
    pub fn reaches_into(&self, state: &State, spare: f64) -> Vec<(usize, f64)> {
        let depth = |obstacle: usize| match self.obstacles.get(obstacle) {
            Some(other) if !other.corners.is_empty() => -self.surface.apart(other, state.pose()),
            _ => {
                let [points, _] = self.of_obstacle(obstacle);
                points.map(|i| -measured(self, state, None, i)).fold(f64::NEG_INFINITY, f64::max)
            }
        };
        let all = (0..self.obstacle_count()).map(|obstacle| (obstacle, depth(obstacle)));
        all.filter(|(_, depth)| *depth > spare).collect()
    }
}

/// The form of a body: what is between its supports.
#[derive(Clone, Debug, PartialEq)]
pub struct Form {
    surface: Surface,
    reach: f64,
}

impl Form {
    /// The hull of a body's supports; of one with round edges all places within the radius of it.
    ///
    /// # Errors
    /// [`ObstaclesProblem`]: supports that have no hull, or are rounded in different ways.
    pub fn of(body: &Body) -> Result<Self, ObstaclesProblem> {
        let (surface, _) = form_of(body)?;
        Ok(Self { surface, reach: body.reach() })
    }

    /// No place of it is farther from the mass centre \[m\].
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// How far a body of this form in one state is from one in another, at least \[m\]; 0 or negative exactly where they overlap. What they do does not matter, only where they stand.
    ///
    /// # Example
    /// Two cubes of 1 m beside each other, their centres 1.25 m apart.
    /// ```
    /// use carom_motion::spatial::{Form, State, examples};
    /// use carom_num::{Rotation, Vec3};
    /// let cube = Form::of(&examples::block()).unwrap();
    /// let (attitude, still) = (Rotation::NONE, Vec3::ZERO);
    /// let at = |x: f64| State { centre: Vec3::X * x, attitude, velocity: still, spin: still };
    /// assert_eq!(cube.clearance([&at(0.0), &at(1.25)]), 0.25);
    /// ```
    pub fn clearance(&self, [a, b]: [&State; 2]) -> f64 {
        let attitude = b.attitude.inverse().after(a.attitude);
        let centre = b.attitude.undo(a.centre - b.centre);
        self.surface.apart(&self.surface, Pose { centre, attitude })
    }
}
