//! What is told of a motion: samples, pieces, strikes.

pub mod observer;
mod recorder;
pub mod trace;

pub use observer::Observer;
pub use recorder::Recorder;
