//! Rigid bodies among fixed obstacles in the plane.

mod contact;
pub mod examples;
mod geometry;
mod modes;
pub mod record;
mod several;
mod walk;

#[cfg(test)]
mod broken_numbers;

pub use contact::{Kinematics, Pairing, Scales, World};
pub use geometry::{
    AxialMoments, Body, ChainPoint, Feature, MassProperties, Obstacle, Pose, Rest, RestKind, Shape,
    ShapeProblem, State, Surface, Twist,
};
pub use record::{Observer, Recorder, observer, trace};
pub use several::{Advance, Crowd, Member, Outlook};
pub use walk::{Effort, Happening, Margin, MarginOf, Options, Walker};
