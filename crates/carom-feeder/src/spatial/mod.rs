//! The feeder in space: a solid part that slides down plates with a width, over their ends and sides, between walls.
//!
//! World axes are those of the drawing: x to the right, y up, and z out of it, towards whoever looks at it. Body axes have their origin in the mass centre. Words are those of the
//! plane: outcomes, verdicts, landings and stages are the same.

mod course;
mod drop;
pub mod examples;
mod feeder;
mod part;
mod run;
mod sheets;
mod stages;

pub use drop::Prepared;
pub use feeder::{CrossSection, Feeder, Plate, Start, Wall, WallForm};
pub use part::{Face, Part, PartProblem, Shown};
pub use run::{Exit, Run};
