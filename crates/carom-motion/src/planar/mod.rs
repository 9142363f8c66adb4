//! A rigid body among fixed obstacles in the plane.

mod body;
mod feature;
mod mass;
mod obstacle;
mod shape;
mod state;
pub mod trace;

pub use body::Body;
pub use feature::Feature;
pub use mass::MassProperties;
pub use obstacle::Obstacle;
pub use shape::{Shape, ShapeProblem};
pub use state::{Pose, State, Twist};
