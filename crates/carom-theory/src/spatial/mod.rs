//! Bodies in space that strike with a point while others still touch.
//!
//! But for [`Twist`], [`FlatSlide`], [`ThreeFeet`], [`Groove`], [`Ladder`], [`Ball`], [`TippeTop`], [`RollingDisc`], [`RoundOverEdge`], [`BlockOnCylinder`] and [`EdgeOverEdge`], which slide or roll, the law is the non-sliding one: a contact that is kept comes to rest, whatever friction that takes; one that is not kept takes no impulse. A
//! *state* is the set of contacts that are kept. It is consistent where no kept contact pulls and none of the others approaches.
//!
//! Source of the states: Polukoshko, Viba and others, on simultaneous collisions of rolling bodies, section 5. The conditions and the impulses were
//! derived again; what differs from the print is said where it stands.

mod ball;
mod block_on_cylinder;
mod borders;
mod edge_over_edge;
mod feet;
mod groove;
mod ladder;
mod pyramid;
mod rolling_disc;
mod round_over_edge;
mod slide;
mod stool;
mod tippe_top;
mod twist;

pub use ball::Ball;
pub use block_on_cylinder::BlockOnCylinder;
pub use borders::LateralRoll;
pub use edge_over_edge::{EdgeOverEdge, SlidingOver};
pub use feet::ThreeFeet;
pub use groove::Groove;
pub use ladder::{Ladder, LeavesWall};
pub use pyramid::{Kept, Pyramid, PyramidStrike};
pub use rolling_disc::RollingDisc;
pub use round_over_edge::RoundOverEdge;
pub use slide::{FlatSlide, ToRest};
pub use stool::{Approach, OnBoth, OnNext, Stool};
pub use tippe_top::TippeTop;
pub use twist::{AfterTwist, SpinStops, Twist};
