//! Carom computes exactly what rigid parts do when they touch: slide, tip, fall, strike, stick, rebound. Its main job is the gravity-impact
//! part feeder.
//!
//! *Exactly* means: every contact law is solved, not relaxed over small steps; every event is located; smooth motion in between is
//! integrated under error control, in `f64`.
//!
//! ```
//! use carom::prelude::*;
//!
//! let scene = Scene::parse("case_2.toml", r#"
//!     [part]
//!     shape   = "rod"
//!     length  = "100 mm"
//!     mass    = "0.3 kg"
//!     inertia = "2.5e-4 kg m^2"
//!     [contact]
//!     friction    = 0.15
//!     restitution = 0.0
//!     [start]
//!     to_edge = "100 mm"
//!     [[plate]]
//!     name  = "upper"
//!     slope = "10 deg"
//!     [[plate]]
//!     name     = "lower"
//!     downhill = "left"
//!     line     = { along = "428 mm", normal = "300 mm" }
//! "#)?;
//! let run = scene.feeder().run()?;
//! assert_eq!(run.outcome, Outcome::Landed);
//! assert_eq!(run.landings[0].verdict, Some(Verdict::Turned));
//! # Ok::<(), carom::Error>(())
//! ```
//!
//! # Where to start
//!
//! | you | read |
//! |---|---|
//! | design part feeders | [`tutorials::_01_a_first_feeder`] |
//! | research or teach impacts, or check an engine's | [`tutorials::_02_one_impact`] |
//! | want bodies and obstacles of your own | [`tutorials::_03_how_motion_is_walked`] |
//!
//! # The rooms
//!
//! This crate is the face of several: it holds no physics of its own, only their names, one [`Error`], the [`tasks`] that join them, and the
//! [`tutorials`].
//!
//! | module | holds |
//! |---|---|
//! | [`scene`] | files to checked models: TOML with units, and results as JSON |
//! | [`figure`] | pictures: layout, animation, impulse diagram, the HTML report |
//! | [`words`] | what answers are called, and said of them in a sentence |
//! | [`feeder`] | the device: part, plates, start; verdicts and the names of stages |
//! | [`study`] | many impacts and runs: maps, yields, designs, feeds, sweeps, poses, region diagrams |
//! | [`motion`] | bodies in time: shapes, gaps, flight, contact modes, events, the trace |
//! | [`impact`] | contacts at one instant: the rate problem, staged impacts, restitution laws, end states |
//! | [`num`] | numbers without physics: vectors, small solves, Runge–Kutta, elementary functions |
//!
//! Everything is in SI units, in a world with x to the right and y up; angles and spins are counter-clockwise. Other units exist in
//! [`scene`] alone. A contact's normal points out of the obstacle into the body, and its tangent is the normal turned a quarter
//! clockwise, so an approach has a negative normal velocity.
//!
//! # What is promised
//!
//! - One input gives one result, byte for byte, in debug and release builds.
//! - Bad input is an [`Error`] that lists all its problems; nothing panics and no result holds a NaN.
//! - Where rigid-body mechanics allows several answers or none, the result says so. That is physics, not an error.

pub use carom_feeder as feeder;
pub use carom_figure as figure;
pub use carom_impact as impact;
pub use carom_motion as motion;
pub use carom_num as num;
pub use carom_scene as scene;
pub use carom_study as study;
pub use carom_words as words;

mod error;
pub mod prelude;
pub mod tasks;
pub mod tutorials;

pub use error::Error;
