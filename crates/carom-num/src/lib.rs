//! Numbers without physics.
//!
//! - [`Vec2`]: a plane vector; [`Vec3`], [`Mat3`] and [`Rotation`]: vectors, matrices and rotations in space;
//! - [`circle`]: trigonometric equations and their roots on the circle;
//! - [`elementary`]: the one place that sine, cosine and their kin come from;
//! - [`solve`]: small dense linear systems;
//! - [`segment`]: straight segments in the plane;
//! - [`slack`]: linear programmes of a few variables;
//! - [`lemke`]: the linear complementarity problem;
//! - [`principal`]: principal values and axes of a symmetric matrix;
//! - [`poly`]: polynomials on an interval and the certain isolation of their roots;
//! - [`course`]: smooth equations followed to their first event; [`falls`]: where smooth functions fall through zero first;
//! - [`ode`]: an explicit Runge–Kutta step of order 5 with dense output;
//! - [`ode8`]: an explicit step of order 8 with dense output;
//! - [`radau`]: an implicit step of order 9, for stiff equations;
//! - [`taylor`]: Taylor series: products by order, values, first roots;
//! - [`quadrature`]: integrals by weighted values;
//! - [`cones`]: the narrowest cones that hold a member of a family of vectors;
//! - [`sobol`], [`normal`]: Sobol's points with Owen's scrambling; the normal distribution.

mod basis;
pub mod circle;
pub mod cones;
pub mod course;
pub mod elementary;
pub mod falls;
pub mod lemke;
mod mat3;
pub mod normal;
pub mod ode;
pub mod ode8;
pub mod poly;
pub mod principal;
pub mod quadrature;
pub mod radau;
mod rotation;
pub mod segment;
pub mod slack;
pub mod sobol;
pub mod solve;
pub mod taylor;
mod tolerance;
mod vec2;
mod vec3;

pub use basis::Basis;
pub use mat3::Mat3;
pub use rotation::Rotation;
pub use vec2::Vec2;
pub use vec3::Vec3;
