//! The layouts that may be chosen.

use super::Design;
use crate::device::Device;
use carom_feeder::Feeder;

/// A layout.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout<F = Feeder> {
    /// The feeder where nothing varies.
    pub feeder: F,
    /// How high it is [m].
    pub height: f64,
    /// How wide it is [m].
    pub width: f64,
}

/// The feeders that a layout may become: one for every point of the unit cube of what varies, or none where it cannot be drawn.
pub type Varying<'a, F = Feeder> = Box<dyn Fn(&[f64]) -> Option<F> + Sync + 'a>;

/// How far a search is.
///
/// # Example
/// Whoever waits for a search hears how far it is after each of its looks.
/// ```
/// use carom_study::design::Looked;
/// let halfway = Looked { look: 4, looks: 8, best: None };
/// assert_eq!(2 * halfway.look, halfway.looks);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Looked<'d> {
    /// Looks that are over.
    pub look: u32,
    /// Looks in all.
    pub looks: u32,
    /// The best layout so far; `None` before any is sampled, or where none meets the demands.
    pub best: Option<&'d Design>,
}

/// The layouts that may be chosen.
///
/// # Example
/// The friction of a plate of 3 in 4 may be chosen from 0 to 1. A rod is to be held: that takes 3/4, and a
/// quarter of the layouts do it.
/// ```
/// use carom_feeder::{Feeder, Outcome, Run, examples};
/// use carom_study::design::{Aim, Goal, Layout, Limits, Space, Varying, search};
/// struct Friction;
/// impl Space for Friction {
///     type Feeder = Feeder;
///     fn dimensions(&self) -> usize {
///         1
///     }
///     fn varying(&self) -> usize {
///         1
///     }
///     fn layout(&self, point: &[f64]) -> Option<Layout> {
///         Some(Layout { feeder: examples::rod_on_a_slope(point[0]), height: 3.0, width: 4.0 })
///     }
///     fn met(&self, _: &[f64], run: &Run) -> bool {
///         run.outcome == Outcome::Stuck
///     }
///     fn varied(&self, point: &[f64], _widened: f64) -> Option<Varying<'_>> {
///         let feeder = examples::rod_on_a_slope(point[0]);
///         Some(Box::new(move |_| Some(feeder.clone())))
///     }
/// }
/// let goal = Goal { limits: Limits::default(), aim: Aim::Yield, seed: 1, scanned: 16, confirming: 1 };
/// assert_eq!(search(&Friction, &goal).unwrap().met, 4);
/// ```
pub trait Space: Sync {
    /// What parts are dropped through, in the plane or in space.
    type Feeder: Device;

    /// Quantities that may be chosen.
    fn dimensions(&self) -> usize;

    /// Quantities that vary.
    fn varying(&self) -> usize;

    /// The layout at a point of the unit cube; `None` where what is drawn cannot be.
    fn layout(&self, point: &[f64]) -> Option<Layout<Self::Feeder>>;

    /// Does a run of the layout at a point end as wanted?
    fn met(&self, point: &[f64], run: &<Self::Feeder as Device>::Run) -> bool;

    /// The feeders that a layout may become, for points of the unit cube of what varies. Tolerances are multiplied by `widened`.
    fn varied(&self, point: &[f64], widened: f64) -> Option<Varying<'_, Self::Feeder>>;

    /// Hears after each look how far the search is.
    fn looked(&self, _looked: &Looked<'_>) {}
}
