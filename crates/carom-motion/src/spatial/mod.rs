//! A rigid body over a fixed plane in space: with friction ([`World::with_friction`]) its supports may slide, without it none that touches does.
//!
//! World axes: z is the plane's normal, the plane is z = 0. Body axes have their origin in the mass centre. Spins are in body axes, impulses and
//! velocities in world axes. SI units.

mod blow;
mod body;
mod bounds;
#[cfg(test)]
mod broken_numbers;
mod closing;
mod contacts;
mod events;
pub mod examples;
mod forces;
mod friction;
mod frictional;
mod glide;
mod gliding;
mod grip;
mod hull;
mod mode;
mod motion;
pub mod observer;
mod onset;
mod polyhedron;
mod posture;
mod rough;
mod run;
mod series;
mod settle;
mod sliding;
mod slips;
mod solid;
mod state;
mod stretch;
mod strike;
mod supports;
mod terms;
mod walker;
mod world;

pub use body::{Body, BodyProblem};
pub use forces::{Forces, forces};
pub use friction::{Friction, FrictionProblem};
pub use frictional::frictional_contacts;
pub use hull::HullProblem;
pub use mode::Mode;
pub use observer::{Observer, Samples};
pub use polyhedron::{Face, Polyhedron, Stance};
pub use run::{Budget, Clock, Closing, End, Impact, Piece, Run};
pub use solid::{Mesh, MeshProblem, Solid};
pub use state::State;
pub use supports::Supports;
pub use terms::{Choice, Effort, Options, Overturning};
pub use walker::run;
pub use world::{GravityProblem, Scales, World};
