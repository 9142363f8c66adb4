//! What a region diagram is made of.

use super::Range;

/// A piece of the border between two labels.
///
/// # Example
/// The border x = 0.3 runs from one side of the square to the other.
/// ```
/// use carom_study::regions::{Boundary, Options, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let found = find(side, side, &Options::default(), |x, _| x < 0.3)?;
/// let Boundary { pair, points, closed, ends } = &found.boundaries[0];
/// assert_eq!((pair, *closed, ends), (&[false, true], false, &[None, None]));
/// assert!(points.iter().all(|[x, _]| (x - 0.3).abs() <= 1e-9));
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Boundary<L> {
    /// The two labels, the smaller one first.
    pub pair: [L; 2],
    /// Its points, in units of the axes.
    pub points: Vec<[f64; 2]>,
    /// True: the last point is joined to the first.
    pub closed: bool,
    /// The junctions it starts and ends in, by number.
    pub ends: [Option<usize>; 2],
}

/// A point where three or more labels meet.
///
/// # Example
/// Below y = 0.6 there is 0, above it 1 up to x = 0.3 and 2 beyond: all three meet at (0.3, 0.6).
/// ```
/// use carom_study::regions::{Junction, Options, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let label = |x: f64, y: f64| if y < 0.6 { 0_u8 } else if x < 0.3 { 1 } else { 2 };
/// let found = find(side, side, &Options::default(), label)?;
/// let Junction { labels, at, .. } = &found.junctions[0];
/// assert_eq!(labels, &[0, 2, 1]);
/// assert!((at[0] - 0.3).abs() < 2e-9 && (at[1] - 0.6).abs() < 2e-9);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Junction<L> {
    /// The labels in the order in which they stand around it, counter-clockwise in (x, y), from the smallest.
    pub labels: Vec<L>,
    /// The point, in units of the axes.
    pub at: [f64; 2],
    /// Half the size of the window it was found in, as a share of the ranges.
    pub accuracy: f64,
}

/// A convex or concave piece of a region: with all others it covers the plane.
///
/// # Example
/// The patches cover the square: by the shoelace formula their areas add up to 1.
/// ```
/// use carom_study::regions::{Options, Patch, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let found = find(side, side, &Options::default(), |x, _| x < 0.3)?;
/// let area = |Patch { outline, .. }: &Patch<bool>| {
///     let next = outline.iter().cycle().skip(1);
///     0.5 * outline.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>().abs()
/// };
/// assert!((found.patches.iter().map(area).sum::<f64>() - 1.0).abs() < 1e-12);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Patch<L> {
    /// Its label.
    pub label: L,
    /// Its corners, in units of the axes.
    pub outline: Vec<[f64; 2]>,
}

/// A connected set of grid nodes with one label, and where its name is best written.
///
/// # Example
/// Of 25 nodes ten, at x = 0 and x = 1/4, lie below 0.3.
/// ```
/// use carom_study::regions::{Options, Place, Range, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let found = find(side, side, &Options::default(), |x, _| x < 0.3)?;
/// let places: Vec<_> = found.places.iter().map(|Place { label, nodes, .. }| (*label, *nodes)).collect();
/// assert_eq!(places, [(false, 15), (true, 10)]);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<L> {
    /// The label.
    pub label: L,
    /// The node that is farthest from other labels and from the border, in units of the axes.
    pub at: [f64; 2],
    /// How far that is, in cells.
    pub clearance: usize,
    /// How many nodes are connected.
    pub nodes: usize,
}

/// How much of the plane a label takes.
///
/// # Example
/// ```
/// use carom_study::regions::{Options, Range, Share, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let found = find(side, side, &Options::default(), |x, _| x < 0.3)?;
/// let Share { label, area, nodes } = found.shares[1];
/// assert_eq!((label, nodes), (true, 10));
/// assert!((area - 0.3).abs() < 1e-8);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share<L> {
    /// The label.
    pub label: L,
    /// Its share of the plane's area, to second order in the size of a cell.
    pub area: f64,
    /// Nodes of the grid that have it.
    pub nodes: usize,
}

/// The regions of a plane.
///
/// # Example
/// Three regions meet in one point, and three borders start there.
/// ```
/// use carom_study::regions::{Options, Range, Regions, find};
/// let side = Range { from: 0.0, to: 1.0, count: 4 };
/// let label = |x: f64, y: f64| if y < 0.6 { 0_u8 } else if x < 0.3 { 1 } else { 2 };
/// let found = find(side, side, &Options::default(), label)?;
/// let Regions { shares, boundaries, junctions, .. } = &found;
/// assert_eq!((shares.len(), boundaries.len(), junctions.len()), (3, 3, 1));
/// assert!(boundaries.iter().all(|border| border.ends.contains(&Some(0))));
/// assert!((shares.iter().map(|share| share.area).sum::<f64>() - 1.0).abs() < 1e-12);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Regions<L> {
    /// The abscissa.
    pub x: Range,
    /// The ordinate.
    pub y: Range,
    /// Every label that was found, ascending.
    pub shares: Vec<Share<L>>,
    /// The borders between them, by pair of labels.
    pub boundaries: Vec<Boundary<L>>,
    /// Where three or more meet.
    pub junctions: Vec<Junction<L>>,
    /// What covers the plane.
    pub patches: Vec<Patch<L>>,
    /// Where names are best written, from the largest connected set down.
    pub places: Vec<Place<L>>,
    /// Share of the plane in cells of the smallest size that hold more than one line: what else is in them was not looked into.
    pub crowded: f64,
    /// How often the classifier was asked.
    pub evaluations: usize,
}
