//! How far a body is in what it must not be in.

use super::state::{Pose, State, measured};
use super::world::World;

impl World {
    /// The first obstacle with ends that the body is in, and how deep; where it touches one it is not deeper than `spare`.
    pub(in crate::spatial) fn overlap(&self, pose: Pose, spare: f64) -> Option<(usize, f64)> {
        let with_ends = self.obstacles.iter().enumerate().filter(|(_, other)| !other.corners.is_empty());
        let mut deep = with_ends.map(|(i, other)| (i, -self.form.apart(other, pose)));
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
            Some(other) if !other.corners.is_empty() => -self.form.apart(other, state.pose()),
            _ => {
                let [points, _] = self.of_obstacle(obstacle);
                points.map(|i| -measured(self, state, None, i)).fold(f64::NEG_INFINITY, f64::max)
            }
        };
        let all = (0..self.obstacle_count()).map(|obstacle| (obstacle, depth(obstacle)));
        all.filter(|(_, depth)| *depth > spare).collect()
    }
}
