//! A rigid body over a fixed plane in space, or among several ([`World::among`]): with friction ([`World::with_friction`]) its supports may slide, without it none
//! that touches does.
//!
//! World axes: where nothing else is said the one plane is z = 0 with the normal z. Body axes have their origin in the mass centre. Spins are in body axes, impulses and
//! velocities in world axes. SI units.

#[cfg(test)]
mod broken_numbers;
pub mod examples;
mod geometry;
mod modes;
mod record;
mod terms;
mod walk;
pub use record::observer;

pub use geometry::body::{Body, BodyProblem};
pub use geometry::cut::PiecesProblem;
pub use geometry::feature::Feature;
pub use geometry::form::Form;
pub use geometry::friction::{Friction, FrictionProblem};
pub use geometry::hull::HullProblem;
pub use geometry::named::Touch;
pub use geometry::obstacle::{Obstacle, PlateProblem, RadiusProblem};
pub use geometry::plane::{Plane, PlaneProblem};
pub use geometry::polyhedron::{Face, Polyhedron, Stance};
pub use geometry::rest::Rest;
pub use geometry::rounding::{Rounding, RoundingProblem};
pub use geometry::solid::{Mesh, MeshProblem, Solid};
pub use geometry::state::State;
pub use geometry::supports::Supports;
pub use geometry::world::{GravityProblem, ObstaclesProblem, Scales, World};
pub use modes::frictional::frictional_contacts;
pub use modes::mode::Mode;
pub use record::observer::{Observer, Samples};
pub use record::run::{Budget, Clock, Closing, End, Impact, Piece, PieceEnd, Run};
pub use terms::{Choice, Effort, Options, Overturning};
pub use walk::forces::{Forces, forces};
pub use walk::walker::run;
