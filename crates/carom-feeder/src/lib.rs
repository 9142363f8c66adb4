//! The gravity-impact feeder: a part, plates, a start, and the verdict.
//!
//! ```
//! use carom_feeder::{Feeder, Form, Outcome, Part, Plate, Start, Stop, Verdict};
//! use carom_num::Vec2;
//!
//! // A thin rod of 100 mm slides down a plate, tips over its edge and falls on a plate that descends the other way.
//! let plate = |name: &str, uphill: (f64, f64), edge: (f64, f64)| Plate {
//!     name: name.into(),
//!     uphill: Vec2::new(uphill.0, uphill.1),
//!     edge: Vec2::new(edge.0, edge.1),
//!     friction: 0.15,
//!     restitution: 0.0,
//!     unbounded: false,
//!     form: Form::default(),
//! };
//! let feeder = Feeder {
//!     gravity: 9.81,
//!     stop: Stop::Landed,
//!     law: Default::default(),
//!     part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
//!     start: Start { to_edge: 0.1, speed: 0.0, face: 0 },
//!     plates: vec![plate("upper", (-0.29, 0.08), (0.0, 0.0)), plate("lower", (0.3, -0.08), (-0.2, -0.24))],
//!     walls: vec![],
//! };
//! let run = feeder.run().unwrap();
//! assert_eq!(run.outcome, Outcome::Landed);
//! assert_eq!(run.landings[0].verdict, Some(Verdict::Same));
//! ```

mod check;
mod clatter;
mod course;
mod drop;
mod ending;
pub mod examples;
mod feed;
mod feeder;
mod first_contact;
mod form;
mod part_view;
mod run;
mod seen;
pub mod spatial;
mod stages;
mod tolerance;

pub use drop::{Prepared, RunError};
pub use feed::{Contact, FedPart, Feed, FeedRun};
pub use feeder::{Feeder, FeederProblem, Part, PartKind, Plate, Start, Stop, Wall};
pub use first_contact::{Doing, FirstContact};
pub use form::{Form, FormArc};
pub use run::{
    Decided, Effort, Exit, Jam, JamKind, Landing, Outcome, Run, Stage, StageEnd, StageName, Touch, Verdict,
};
