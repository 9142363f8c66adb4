//! Numbers without physics.
//!
//! - [`Vec2`]: a plane vector;
//! - [`elementary`]: the one place that sine, cosine and their kin come from;
//! - [`solve`]: small dense linear systems and small linear programmes;
//! - [`poly`]: polynomials on an interval and the certain isolation of their roots;
//! - [`ode`]: an explicit Runge–Kutta step with dense output.

pub mod elementary;
pub mod ode;
pub mod poly;
pub mod solve;
mod vec2;

pub use vec2::Vec2;
