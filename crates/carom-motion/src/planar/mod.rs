//! Rigid bodies among fixed obstacles in the plane.

mod accumulation;
mod between;
mod body;
mod collide;
mod consequence;
mod crowd;
mod encounter;
mod events;
mod feature;
mod flight;
mod glide;
mod island;
mod kinematics;
mod line;
mod mass;
mod meeting;
mod mode;
mod nodes;
pub mod observer;
mod obstacle;
mod path;
mod polish;
mod project;
mod question;
mod recorder;
mod reports;
mod separation;
mod series;
mod shape;
mod sides;
mod snapshot;
mod state;
mod steady;
mod strike;
mod terms;
mod touching;
pub mod trace;
mod walker;
mod watch;
mod world;

#[cfg(test)]
mod broken_numbers;

pub use body::Body;
pub use crowd::{Advance, Crowd, Member};
pub use feature::Feature;
pub use kinematics::{Kinematics, Pairing};
pub use mass::MassProperties;
pub use observer::Observer;
pub use obstacle::{Obstacle, Surface};
pub use recorder::Recorder;
pub use shape::{Shape, ShapeProblem};
pub use state::{Pose, State, Twist};
pub use terms::{Effort, Happening, Margin, MarginOf, MotionError, Options};
pub use walker::Walker;
pub use world::{Scales, World};
