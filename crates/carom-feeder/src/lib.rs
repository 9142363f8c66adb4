//! The gravity-impact feeder: a part, plates, a start, and the verdict.

mod feeder;
mod run;

pub use feeder::{Feeder, FeederProblem, Part, PartKind, Plate, Start, Stop, Wall};
pub use run::{Exit, Landing, Outcome, Run, Stage, StageName, Verdict, Work};
