//! Carom in C: the library behind `include/carom.h`.
//!
//! An impact in the plane is asked by plain structs, and so is how a drop ends. Everything else crosses as text: an impact file or a scene in,
//! the JSON that the command prints out.
//!
//! Everything is in SI units, in a world with x to the right and y up; angles and spins are counter-clockwise. A contact's normal points out
//! of the obstacle into the body, and its tangent is the normal turned a quarter clockwise.
//!
//! No function keeps a state between calls, and none lets a panic out: any number of threads may call at once.

mod abi;
mod drop;
mod impact;
mod plain;
mod refusal;
mod text;

pub use abi::*;
pub use impact::EndStates;
pub use plain::*;
