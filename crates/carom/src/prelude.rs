//! The names that a program about feeders nearly always needs: `use carom::prelude::*`.
//!
//! Impacts are asked for by their modules, [`single`](crate::impact::planar::single) and [`staged`](crate::impact::planar::staged): both
//! have a `resolve`.

pub use crate::Error;
pub use carom_feeder::{
    Feeder, Landing, Outcome, Part, PartKind, Plate, Prepared, Run, Stage, StageName, Start, Stop, Verdict,
    Wall,
};
pub use carom_impact::Law;
pub use carom_impact::planar::ImpactType;
pub use carom_motion::planar::{Observer, Options, Pose, Recorder, State, Twist};
pub use carom_num::Vec2;
pub use carom_scene::Scene;
