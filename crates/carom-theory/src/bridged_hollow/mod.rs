//! A straight rod across a hollow: on the two edges of a gap, or with both ends on a round hollow.
//!
//! ```text
//!    ====|====e====·====|====           rod of half length l on edges 2d apart, its centre e from their middle
//!   _____|              |_____
//!
//!    \        O        /                rod of half length l in a hollow of radius R about O, tilted by α;
//!     A----___        /                 its centre is h = √(R² − l²) from O, always
//!      \      ---___ B
//!        ` - . _ . - '
//! ```
//!
//! Source: the laws of statics, Newton and Euler; derived here.

mod edges;
mod round;

pub use edges::RodOnEdges;
pub use round::RodInHollow;
