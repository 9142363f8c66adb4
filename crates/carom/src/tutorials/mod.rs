//! Long-form tutorials. Every block of code in them is compiled and run as a test, and every number in them is asserted.
//!
//! 1. [`_01_a_first_feeder`]: from a drawing to a verdict, and what may be changed before the verdict flips;
//! 2. [`_02_one_impact`]: one contact, its impulse plane, the seven types, and three laws of restitution on one strike;
//! 3. [`_03_how_motion_is_walked`]: two clocks and one question, observers, and the trace that a run leaves behind.

pub mod _01_a_first_feeder;
pub mod _02_one_impact;
pub mod _03_how_motion_is_walked;
