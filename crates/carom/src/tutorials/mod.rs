//! Long-form tutorials. Every block of code in them is compiled and run as a test, and every number in them is asserted.
//!
//! 1. [`_01_a_first_feeder`]: from a drawing to a verdict, and what may be changed before the verdict flips;
//! 2. [`_02_one_impact`]: one contact, its impulse plane, the seven types, and three laws of restitution on one strike;
//! 3. [`_03_how_motion_is_walked`]: two clocks and one question, observers, and the trace that a run leaves behind.

pub mod _01_a_first_feeder;
pub mod _02_one_impact;
pub mod _03_how_motion_is_walked;

/// The second example of the feeder's paper, which the lessons follow: a rod of 0.1 m lands on its other side.
pub const CASE_2: &str = r#"
part = { shape = "rod", length = "100 mm", mass = "0.3 kg", inertia = "2.5e-4 kg m^2" }
contact = { friction = 0.15, restitution = 0.0 }
start = { to_edge = "100 mm" }
[[plate]]
name = "upper"
slope = "10 deg"
[[plate]]
name = "lower"
downhill = "left"
line = { along = "428 mm", normal = "300 mm" }
"#;
