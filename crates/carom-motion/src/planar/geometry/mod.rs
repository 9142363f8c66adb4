//! Shapes, their masses and faces, and where bodies are.

mod axial;
mod body;
mod chain;
mod feature;
mod mass;
mod obstacle;
mod rest;
mod shape;
mod shape_problem;
mod state;
mod wrap;

pub use axial::AxialMoments;
pub use body::Body;
pub use chain::ChainPoint;
pub use feature::Feature;
pub use mass::MassProperties;
pub use obstacle::{Obstacle, Surface};
pub use rest::{Rest, RestKind};
pub use shape::Shape;
pub use shape_problem::ShapeProblem;
pub use state::{Pose, State, Twist};
