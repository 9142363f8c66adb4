//! Studies: what many impacts or runs have in common.
//!
//! - [`map`]: how a drop ends over two quantities of a feeder; [`Ending`] and [`Dropped`]: what a study keeps of a drop;
//! - [`yields`]: with what probability drops end as wanted when quantities vary;
//! - [`fits`]: which quantities agree with drops that were observed;
//! - [`poses`]: with what probability a body that is thrown comes to rest on which face;
//! - [`design`]: which layout makes drops end as wanted, and how surely;
//! - [`feeds`]: the smallest interval at which parts fed one after another do not touch, and what happens below it;
//! - [`stretches`]: a line cut up by what happens at each of its points;
//! - [`sweep`]: one drop each in many designs;
//! - [`regions`]: the regions of a plane of two quantities in which the same thing happens, and the curves between them.
//! - [`rocking`]: the strike of a rolling cylinder, a prism or a rod, as the engine resolves it;
//! - [`spatial_strikes`]: strikes of bodies in space that do not slide; [`releases`]: a stool that is let go, followed to its end;
//! - [`Ends`]: how sure an outcome is: the end states that the laws allow;
//! - [`corner`]: the strike of a part's corner, by the two angles that describe it.

pub mod corner;
pub mod design;
mod device;
mod ending;
mod ends;
pub mod feeds;
pub mod fits;
pub mod limits;
pub mod map;
mod packed;
pub mod poses;
pub mod regions;
pub mod releases;
pub mod rocking;
pub mod spatial_strikes;
pub mod stretches;
pub mod sweep;
mod tolerance;
pub mod yields;

pub use device::{Device, Landed};
pub use ending::{Dropped, Ending};
pub use ends::Ends;

/// How many threads a study works with.
///
/// # Example
/// As many as the pool that the study runs in has.
/// ```
/// let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build()?;
/// assert_eq!(pool.install(carom_study::threads), 3);
/// # Ok::<(), rayon::ThreadPoolBuildError>(())
/// ```
pub fn threads() -> usize {
    rayon::current_num_threads()
}
