//! Numbers without physics.
//!
//! - [`Vec2`]: a plane vector;
//! - [`elementary`]: the one place that sine, cosine and their kin come from;
//! - [`solve`]: small dense linear systems;
//! - [`slack`]: linear programmes of a few variables;
//! - [`lemke`]: the linear complementarity problem;
//! - [`poly`]: polynomials on an interval and the certain isolation of their roots;
//! - [`ode`]: an explicit Runge–Kutta step of order 5 with dense output;
//! - [`ode8`]: one of order 8.

pub mod elementary;
pub mod lemke;
pub mod normal;
pub mod ode;
pub mod ode8;
pub mod poly;
pub mod slack;
pub mod sobol;
pub mod solve;
mod vec2;

pub use vec2::Vec2;
