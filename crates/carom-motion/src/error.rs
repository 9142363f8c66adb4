//! Why a motion cannot be followed.

use carom_impact::ImpactError;
use thiserror::Error;

/// Why there is no motion, or it cannot go on: a fault of the start or of the numbers, not of the physics.
///
/// # Example
/// A body at a place that is not a number cannot move.
/// ```
/// use carom_motion::MotionError;
/// use carom_motion::planar::{Options, Pose, State, Walker, examples};
/// use carom_num::Vec2;
/// let (world, start) = examples::falling_ball();
/// let nowhere = State { pose: Pose { centre: Vec2::new(f64::NAN, 0.0), angle: 0.0 }, ..start };
/// let error = Walker::new(&world, nowhere, vec![], Options::default()).unwrap_err();
/// assert_eq!(error, MotionError::NotFinite { time: 0.0 });
/// assert_eq!(error.to_string(), "the motion is not finite at t = 0 s");
/// ```
/// A cube of 1 m whose centre starts 0.375 m above the plane reaches 0.125 m below it.
/// ```
/// use carom_motion::MotionError;
/// use carom_motion::spatial::{Options, State, examples, run};
/// use carom_num::Vec3;
/// let (world, start) = examples::falling_cube();
/// let sunk = State { centre: Vec3::Z * 0.375, ..start };
/// let error = run(&world, &sunk, &Options::default(), &mut ()).unwrap_err();
/// assert_eq!(error, MotionError::Below { support: 0, depth: 0.125 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// An option that is outside its domain.
    #[error("{option} is {value}: allowed is {allowed}")]
    Option {
        /// Which one.
        option: &'static str,
        /// What it is.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The start has a support below the plane.
    #[error("support {support} starts {depth} m below the plane")]
    Below {
        /// Which one.
        support: usize,
        /// How far [m].
        depth: f64,
    },
    /// The body overlaps a plate or a solid at the start.
    #[error("the body starts {depth} m deep in obstacle {obstacle}")]
    Overlaps {
        /// Which one: obstacles are numbered from 0 in the order in which they were given.
        obstacle: usize,
        /// How far it has to move to be out of it [m].
        depth: f64,
    },
    /// The start has a support that slides along a plane without friction, on which nothing slides.
    #[error("support {support} starts on the plane and slides at {speed} m/s")]
    Slides {
        /// Which one.
        support: usize,
        /// How fast [m/s].
        speed: f64,
    },
    /// A rounded body rolls, and the world has no friction that says which way.
    #[error("a body with rounded supports rolls: the world needs friction (0 is allowed)")]
    Rolls,
    /// A rod without thickness among bent obstacles without one: two such lines do not tell on which side of each other they are. Give one of them a
    /// thickness, as small as it may be.
    #[error("body {body} and the bent obstacle {obstacle} are both without thickness")]
    BothThin {
        /// The rod, by its number among the bodies.
        body: usize,
        /// What it could meet, by its number among the obstacles.
        obstacle: usize,
    },
    /// A number that is not finite appeared.
    #[error("the motion is not finite at t = {time} s")]
    NotFinite {
        /// When [s].
        time: f64,
    },
    /// The integration needs steps below rounding.
    #[error("the integration needs a step of {step} s at t = {time} s")]
    StepTooSmall {
        /// When [s].
        time: f64,
        /// The step [s].
        step: f64,
    },
    /// One piece of the motion needs more steps than it is given: nothing happens that would end it, and the steps it needs are minute.
    #[error("at t = {time} s one piece of the motion has taken {steps} steps")]
    TooManySteps {
        /// When [s].
        time: f64,
        /// How many it was given.
        steps: u32,
    },
    /// More bodies touch each other at once than are walked together.
    #[error("at t = {time} s more than {most} bodies touch each other")]
    TooManyTogether {
        /// When [s].
        time: f64,
        /// How many may.
        most: usize,
    },
    /// More supports touch at once than are enumerated.
    #[error("at t = {time} s {count} supports touch: at most {most} are enumerated")]
    TooManyTouching {
        /// When [s].
        time: f64,
        /// How many touch.
        count: usize,
        /// How many may.
        most: usize,
    },
    /// The impact kernel refused: more contacts at once than fit, or no end of its stages.
    #[error("at t = {time} s: {error}")]
    Impact {
        /// When [s].
        time: f64,
        /// What the impact said.
        error: ImpactError,
    },
}
