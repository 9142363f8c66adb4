//! Region diagrams: a plane of two quantities, cut up by what happens at each of its points.
//!
//! A *classifier* gives every point (x, y) a label. [`find`] locates the boundaries between labels:
//!
//! 1. It labels the nodes of a grid.
//! 2. It halves a cell, both ways, while something in it does not fit: its centre, the middle of a side, or more crossings on its sides
//!    than one line through the cell would make. At most [`Options::depth`] times.
//! 3. On every side of a cell whose ends differ it isolates the crossing by bisection, down to [`Options::accuracy`] of the range. Where a
//!    third label turns up between, both halves are searched; one that is met on less than twice the accuracy is passed over, since it may
//!    be an outcome at equality, which fills a line and no region.
//! 4. Within a cell, crossings between the same two labels are joined. Where that is impossible three or more regions meet in it: the
//!    point is located by shrinking the cell to the same accuracy.
//! 5. The pieces are chained to one polyline after another.
//!
//! # Guarantees
//! Every inner point of a [`Boundary`] lies on a grid line, and labels on this line change within `accuracy` × range of it; each
//! [`Junction`] lies in a window of that size around which at least three labels alternate so that their regions must meet inside.
//! Boundaries end only at the border of the plane or in junctions. The result depends on nothing but the arguments: not on the number of
//! threads that ask the classifier, not on random numbers, not on the order of a hash map.
//!
//! # Limits
//! The classifier is seen at points only. A region, or a part of one, is found where it contains a node of the grid, the middle of a cell
//! or of its side, or a point of a bisection; what is smaller than the finest cell, `range/(count · 2^depth)`, may be missed, and a
//! tongue that becomes thinner than it is cut off there. Between its points a polyline is straight: it leaves a curve of radius of
//! curvature R by up to s²/8R over a piece of length s.
//!
//! A classifier that is noise is not followed to the last digit: of more than 64 changes along one side the rest are taken as they come, and
//! of the sets of labels that meet in one cell 16 are followed. Two junctions of the same labels in one finest cell count as one.
//!
//! # Source
//! Ours: marching squares with bisected crossings, after Lorensen and Cline's marching cubes (1987), for labels in place of a level.

mod cell;
mod chain;
mod curve;
mod diagram;
mod junction;
mod lattice;
mod nodes;
mod patch;
pub(crate) mod raster;
mod refine;

pub use curve::{across, distance};
pub use diagram::{Boundary, Junction, Patch, Place, Regions, Share};
pub use raster::{Cells, cells};

use crate::tolerance::REGIONS_ACCURACY;
use std::fmt::Debug;
use thiserror::Error;

/// An axis: its ends, and the number of cells along it.
///
/// # Example
/// Six cells from 0.1 to 0.7.
/// ```
/// use carom_study::regions::Range;
/// let range = Range { from: 0.1, to: 0.7, count: 6 };
/// assert!((range.at(1.0 / 6.0) - 0.2).abs() < 1e-15);
/// assert!((range.share(0.4) - 0.5).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Where it begins.
    pub from: f64,
    /// Where it ends, > `from`.
    pub to: f64,
    /// Cells of the grid, 1 to [`MOST_CELLS`].
    pub count: usize,
}

/// Largest number of cells along an axis.
///
/// # Example
/// ```
/// use carom_study::regions::*;
/// let side = Range { from: 0.0, to: 1.0, count: MOST_CELLS + 1 };
/// let refused = find(side, side, &Options::default(), |x, y| x < y);
/// assert_eq!(refused, Err(RegionsError::Cells { count: 2001 }));
/// ```
pub const MOST_CELLS: usize = 2000;
/// Largest number of times a cell is halved.
///
/// # Example
/// ```
/// use carom_study::regions::*;
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let options = Options { depth: MOST_DEPTH + 1, ..Options::default() };
/// assert_eq!(find(side, side, &options, |x, y| x < y), Err(RegionsError::Depth { depth: 9 }));
/// ```
pub const MOST_DEPTH: u32 = 8;
/// Smallest accuracy: bisection of a range of doubles can do no better.
///
/// # Example
/// ```
/// use carom_study::regions::*;
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let accuracy = 0.5 * LEAST_ACCURACY;
/// let options = Options { accuracy, ..Options::default() };
/// assert_eq!(find(side, side, &options, |x, y| x < y), Err(RegionsError::Accuracy { accuracy }));
/// ```
pub const LEAST_ACCURACY: f64 = 1e-14;

impl Range {
    /// The point at a share of the range; its ends are met exactly.
    ///
    /// # Example
    /// ```
    /// let range = carom_study::regions::Range { from: 0.1, to: 0.7, count: 6 };
    /// assert_eq!((range.at(0.0), range.at(1.0)), (0.1, 0.7));
    /// ```
    pub fn at(&self, share: f64) -> f64 {
        self.from * (1.0 - share) + self.to * share
    }

    /// The share of the range at which a point lies.
    ///
    /// # Example
    /// A share and the point at it belong together.
    /// ```
    /// let range = carom_study::regions::Range { from: 2.0, to: 6.0, count: 4 };
    /// assert_eq!((range.share(3.0), range.at(0.25)), (0.25, 3.0));
    /// ```
    pub fn share(&self, point: f64) -> f64 {
        (point - self.from) / (self.to - self.from)
    }
}

/// What a label must be.
///
/// # Example
/// Whatever has an order may be a label: here the sign of x + y, in words.
/// ```
/// use carom_study::regions::*;
/// fn labels<L: Label>(found: &Regions<L>) -> Vec<L> {
///     found.shares.iter().map(|share| share.label).collect()
/// }
/// let side = Range { from: -1.0, to: 1.0, count: 4 };
/// let words = |x: f64, y: f64| if x + y < -0.3 { "below" } else { "above" };
/// assert_eq!(labels(&find(side, side, &Options::default(), words)?), ["above", "below"]);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
pub trait Label: Copy + Ord + Debug + Send + Sync {}
impl<L: Copy + Ord + Debug + Send + Sync> Label for L {}

/// Gives every point a label. No parameter, so that the search is compiled once for a kind of label, not for every question asked.
type Classifier<'a, L> = &'a (dyn Fn(f64, f64) -> L + Sync);

/// How carefully to look.
///
/// # Example
/// A border is found as finely as is asked for.
/// ```
/// use carom_study::regions::*;
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// for accuracy in [1e-3, 1e-12] {
///     let found = find(side, side, &Options { accuracy, depth: 0 }, |x, _| x < 0.3)?;
///     assert!(found.boundaries[0].points.iter().all(|[x, _]| (x - 0.3).abs() <= accuracy));
/// }
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Accuracy of crossings and junctions, as a share of the range; at least [`LEAST_ACCURACY`].
    pub accuracy: f64,
    /// How often a cell is halved at most; up to [`MOST_DEPTH`].
    pub depth: u32,
}

impl Default for Options {
    /// A billionth of the range, three halvings.
    fn default() -> Self {
        Self { accuracy: REGIONS_ACCURACY, depth: 3 }
    }
}

/// Why no regions were sought: the first fault of the axes or options.
///
/// # Example
/// ```
/// use carom_study::regions::*;
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let turned = Range { from: 1.0, to: 0.0, count: 4 };
/// let error = find(turned, side, &Options::default(), |x, y| x < y).unwrap_err();
/// assert_eq!(error, RegionsError::Range { from: 1.0, to: 0.0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RegionsError {
    /// A range that is not one.
    #[error("the range {from} to {to} is not one: both ends must be finite, and the first below the second")]
    Range {
        /// Its first end.
        from: f64,
        /// Its second end.
        to: f64,
    },
    /// A number of cells.
    #[error("{count} cells: 1 to {MOST_CELLS} are allowed")]
    Cells {
        /// The number.
        count: usize,
    },
    /// An accuracy.
    #[error("the accuracy {accuracy} is outside {LEAST_ACCURACY} to 0.1")]
    Accuracy {
        /// The accuracy.
        accuracy: f64,
    },
    /// A depth.
    #[error("the depth {depth} is more than {MOST_DEPTH}")]
    Depth {
        /// The depth.
        depth: u32,
    },
}

/// Finds the regions of equal labels and the boundaries between them.
///
/// # Guarantees, limits
/// As the [module](self).
///
/// # Errors
/// [`RegionsError`]: a range, a number of cells, an accuracy or a depth outside what is allowed.
///
/// # Example
/// Inside and outside of a circle of radius 1 in a square of side 4: the circle takes π/16 of it.
/// ```
/// use carom_study::regions::{Options, Range, find};
/// let side = Range { from: -2.0, to: 2.0, count: 64 };
/// let found = find(side, side, &Options::default(), |x, y| x * x + y * y < 1.0)?;
/// assert_eq!(found.boundaries.len(), 1);
/// for [x, y] in &found.boundaries[0].points {
///     assert!(((x * x + y * y).sqrt() - 1.0).abs() < 2e-9);
/// }
/// assert!((found.shares[1].area - std::f64::consts::PI / 16.0).abs() < 1e-3);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
pub fn find<L: Label>(
    x: Range,
    y: Range,
    options: &Options,
    classify: impl Fn(f64, f64) -> L + Sync,
) -> Result<Regions<L>, RegionsError> {
    find_between([x, y], options, vec![], &classify)
}

/// Asks the classifier what [`find`] asks it about a band of the plane: `number` of `of` bands of rows, from 0, from the lowest ordinate up.
/// Who keeps the answers of all bands, one machine each, need not ask again: [`find`] then asks for little more, at the seams.
///
/// # Errors
/// As [`find`]. A band that there is not asks for nothing.
///
/// # Example
/// ```
/// use carom_study::regions::{Options, Range, explore, find};
/// use std::{collections::BTreeSet, sync::Mutex};
/// let (side, options) = (Range { from: -2.0, to: 2.0, count: 16 }, Options::default());
/// let asked = Mutex::new(BTreeSet::new());
/// for number in 0..2 {
///     explore([side, side], &options, (number, 2), |x, y| {
///         asked.lock().unwrap().insert((x.to_bits(), y.to_bits()));
///         x * x + y * y < 1.0
///     })?;
/// }
/// let known = asked.into_inner().unwrap();
/// let anew = Mutex::new(0);
/// let found = find(side, side, &options, |x, y| {
///     *anew.lock().unwrap() += usize::from(!known.contains(&(x.to_bits(), y.to_bits())));
///     x * x + y * y < 1.0
/// })?;
/// assert!(found.evaluations > 1000 && *anew.lock().unwrap() < 10);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
pub fn explore<L: Label>(
    [x, y]: [Range; 2],
    options: &Options,
    (number, of): (u32, u32),
    classify: impl Fn(f64, f64) -> L + Sync,
) -> Result<(), RegionsError> {
    check(x, y, options)?;
    let mut lattice = lattice::Lattice::new([x, y], options, &classify);
    let row = |number: u32| y.count * number.min(of) as usize / of.max(1) as usize;
    let leaves = refine::leaves(&mut lattice, row(number)..row(number.saturating_add(1)));
    refine::draw(&mut lattice, &leaves);
    Ok(())
}

/// The nodes of the grid, row by row from the lowest ordinate up, in units of the axes.
pub(crate) fn nodes(ranges: [Range; 2]) -> impl Iterator<Item = [f64; 2]> {
    let [x, y] = ranges;
    let at = |range: Range, k: usize| range.at(k as f64 / range.count as f64);
    (0..=y.count).flat_map(move |j| (0..=x.count).map(move |i| [at(x, i), at(y, j)]))
}

/// As [`find`], where the labels of the grid's [`nodes`] are known already. An empty list means that none is known.
pub(crate) fn find_between<L: Label>(
    [x, y]: [Range; 2],
    options: &Options,
    known: Vec<L>,
    classify: Classifier<'_, L>,
) -> Result<Regions<L>, RegionsError> {
    check(x, y, options)?;
    let mut lattice = lattice::Lattice::new([x, y], options, classify);
    lattice.know(known);
    let places = patch::places(&mut lattice);
    let leaves = refine::leaves(&mut lattice, 0..y.count);
    let drawn = refine::draw(&mut lattice, &leaves);
    let counts = patch::counts(&mut lattice);
    let crowded = drawn.crowded as f64 / (lattice.steps[0] * lattice.steps[1]) as f64;
    let mut boundaries = chain::boundaries(&lattice.crossings, &drawn);
    // Where a junction lies on a node, labels that only touch there leave pieces no longer than the accuracy.
    boundaries.retain(|boundary| {
        boundary.points.iter().any(|point| apart(boundary.points[0], *point, [x, y], options))
    });
    Ok(Regions {
        x,
        y,
        shares: patch::shares(&drawn.patches, &counts, [x, y]),
        boundaries,
        patches: patch::merged(drawn.patches),
        junctions: drawn.junctions,
        places,
        crowded,
        evaluations: lattice.evaluations(),
    })
}

/// True where two points are told apart by more than the accuracy of both.
fn apart(a: [f64; 2], b: [f64; 2], ranges: [Range; 2], options: &Options) -> bool {
    (0..2).any(|axis| {
        (a[axis] - b[axis]).abs() > 4.0 * options.accuracy * (ranges[axis].to - ranges[axis].from)
    })
}

pub(crate) fn check(x: Range, y: Range, options: &Options) -> Result<(), RegionsError> {
    for Range { from, to, count } in [x, y] {
        if !(from.is_finite() && to.is_finite() && (to - from).is_finite() && from < to) {
            return Err(RegionsError::Range { from, to });
        }
        if !(1..=MOST_CELLS).contains(&count) {
            return Err(RegionsError::Cells { count });
        }
    }
    let Options { accuracy, depth } = *options;
    if !(LEAST_ACCURACY..=0.1).contains(&accuracy) {
        return Err(RegionsError::Accuracy { accuracy });
    }
    if depth > MOST_DEPTH { Err(RegionsError::Depth { depth }) } else { Ok(()) }
}
