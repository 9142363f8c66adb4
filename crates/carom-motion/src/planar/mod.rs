//! A rigid body among fixed obstacles in the plane.

mod accumulation;
mod body;
mod collide;
mod consequence;
mod events;
mod feature;
mod flight;
mod glide;
mod kinematics;
mod mass;
mod mode;
pub mod observer;
mod obstacle;
mod project;
mod question;
mod recorder;
mod separation;
mod shape;
mod state;
mod strike;
mod touching;
pub mod trace;
mod walker;
mod watch;
mod world;

pub use body::Body;
pub use feature::Feature;
pub use kinematics::{Kinematics, Pairing};
pub use mass::MassProperties;
pub use observer::Observer;
pub use obstacle::Obstacle;
pub use recorder::Recorder;
pub use shape::{Shape, ShapeProblem};
pub use state::{Pose, State, Twist};
pub use walker::{Effort, Happening, Margin, MarginOf, MotionError, Options, Walker};
pub use world::{Scales, World};
