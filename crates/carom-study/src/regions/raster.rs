//! The label of every cell of a fine grid. Most cells are not asked: their region is known.

use super::{Boundary, Label, Options, Range, Regions, RegionsError, check, find};
use rayon::prelude::*;

/// Cells of the fine grid along a side of a cell of the grid on which regions are sought.
const COARSENESS: usize = 8;
/// That many, as halvings.
const DEPTH: u32 = 3;
/// How finely boundaries are located, in cells.
const WITHIN: f64 = 0.1;
/// Cells whose middle is nearer to a boundary than this, in cells, are classified on their own.
const NEAR: f64 = 0.75;

/// The cells of a grid.
///
/// # Example
/// See [`cells`].
#[derive(Clone, Debug, PartialEq)]
pub struct Cells<L> {
    /// The label at the middle of each cell, row by row from the lowest ordinate up.
    pub labels: Vec<L>,
    /// How often the classifier was asked.
    pub evaluations: usize,
}

/// Finds the label at the middle of every cell of a grid by its regions: their boundaries are followed, and only cells beside a boundary are classified on their own. Where one of
/// these is not what its region says, its neighbours are classified too, and so on.
///
/// # Limits
/// A region that holds none of the places that [`find`] asks, on a grid eight times as coarse, is missed unless a cell beside a boundary, or a chain of neighbours from there, lies in it.
///
/// # Errors
/// As [`find`].
///
/// # Example
/// A disc, drawn with a tenth of the questions.
/// ```
/// use carom_study::regions::{Range, cells};
/// let side = Range { from: -1.0, to: 1.0, count: 200 };
/// let inside = |x: f64, y: f64| x * x + y * y < 0.5;
/// let drawn = cells(side, side, inside)?;
/// let middle = |k: usize| side.at((k as f64 + 0.5) / 200.0);
/// assert!((0..40_000).all(|k| drawn.labels[k] == inside(middle(k % 200), middle(k / 200))));
/// assert!(drawn.evaluations < 4000);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
pub fn cells<L: Label>(
    x: Range,
    y: Range,
    classify: impl Fn(f64, f64) -> L + Sync,
) -> Result<Cells<L>, RegionsError> {
    check(x, y, &Options::default())?;
    let (coarse, options) = followed([x, y]);
    let regions = find(coarse[0], coarse[1], &options, &classify)?;
    let mut cells = filled([x, y], &regions, classify);
    cells.evaluations += regions.evaluations;
    Ok(cells)
}

/// The coarse grid on which regions are sought to fill a fine one, and how.
pub(crate) fn followed(fine: [Range; 2]) -> ([Range; 2], Options) {
    let accuracy = WITHIN / fine[0].count.max(fine[1].count) as f64;
    let coarse = fine.map(|range| Range { count: range.count.div_ceil(COARSENESS), ..range });
    (coarse, Options { accuracy, depth: DEPTH })
}

/// Fills a fine grid by regions that were [followed].
pub(crate) fn filled<L: Label>(
    fine: [Range; 2],
    regions: &Regions<L>,
    classify: impl Fn(f64, f64) -> L + Sync,
) -> Cells<L> {
    let mut raster = Raster::of(fine, regions);
    let mut evaluations = 0;
    let mut open: Vec<usize> = (0..raster.asked.len()).filter(|cell| raster.asked[*cell]).collect();
    while !open.is_empty() {
        evaluations += open.len();
        let ask = |cell: &usize| {
            let [x, y] = raster.middle(*cell);
            classify(x, y)
        };
        let labels: Vec<L> = open.par_iter().panic_fuse().map(ask).collect();
        let surprising = open.iter().zip(labels).filter_map(|(cell, label)| {
            let known = raster.labels[*cell].replace(label);
            (known != Some(label)).then_some(*cell)
        });
        let surprising: Vec<usize> = surprising.collect();
        open = surprising.into_iter().flat_map(|cell| raster.neighbours(cell)).collect();
        open.retain(|cell| !std::mem::replace(&mut raster.asked[*cell], true));
    }
    Cells { labels: raster.labels.into_iter().flatten().collect(), evaluations }
}

/// The fine grid: what its regions say of each cell, and which cells have been asked, or will be.
struct Raster<L> {
    ranges: [Range; 2],
    labels: Vec<Option<L>>,
    asked: Vec<bool>,
}

impl<L: Label> Raster<L> {
    fn of(ranges: [Range; 2], regions: &Regions<L>) -> Self {
        let count = ranges[0].count * ranges[1].count;
        let mut raster = Self { ranges, labels: vec![None; count], asked: vec![false; count] };
        for patch in &regions.patches {
            raster.fill(&patch.outline, patch.label);
        }
        regions.boundaries.iter().for_each(|boundary| raster.mark(boundary));
        for (asked, label) in raster.asked.iter_mut().zip(&raster.labels) {
            *asked |= label.is_none();
        }
        raster
    }

    /// The middle of a cell.
    fn middle(&self, cell: usize) -> [f64; 2] {
        let columns = self.ranges[0].count;
        let place = [cell % columns, cell / columns];
        [0, 1].map(|axis| self.ranges[axis].at((place[axis] as f64 + 0.5) / self.ranges[axis].count as f64))
    }

    /// A point in cells from the lowest corner, where middles are whole numbers.
    fn in_cells(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.ranges[axis].share(point[axis]) * self.ranges[axis].count as f64 - 0.5)
    }

    /// Gives a label to the cells whose middle is within an outline.
    fn fill(&mut self, outline: &[[f64; 2]], label: L) {
        let points: Vec<[f64; 2]> = outline.iter().map(|point| self.in_cells(*point)).collect();
        let sides = || points.iter().zip(points.iter().cycle().skip(1));
        let (low, high) =
            sides().fold((f64::INFINITY, 0.0_f64), |(a, b), ([_, y], _)| (a.min(*y), b.max(*y)));
        for row in whole(low, high, self.ranges[1].count) {
            let y = row as f64;
            let crosses = |(a, b): (&[f64; 2], &[f64; 2])| {
                let along = (y - a[1]) / (b[1] - a[1]);
                ((a[1] <= y) != (b[1] <= y)).then(|| a[0] + along * (b[0] - a[0]))
            };
            let mut crossings: Vec<f64> = sides().filter_map(crosses).collect();
            crossings.sort_by(f64::total_cmp);
            for pair in crossings.chunks_exact(2) {
                let columns = self.ranges[0].count;
                whole(pair[0], pair[1], columns).for_each(|i| self.labels[row * columns + i] = Some(label));
            }
        }
    }

    /// Notes the cells beside a boundary.
    fn mark(&mut self, boundary: &Boundary<L>) {
        let [columns, rows] = self.ranges.map(|range| range.count);
        let points: Vec<[f64; 2]> = boundary.points.iter().map(|point| self.in_cells(*point)).collect();
        let closing = if boundary.closed { points.first().copied() } else { None };
        let ends = points.iter().skip(1).copied().chain(closing);
        for (a, b) in points.iter().zip(ends) {
            let [low, high] = [f64::min, f64::max].map(|of| [of(a[0], b[0]), of(a[1], b[1])]);
            for row in whole(low[1] - NEAR, high[1] + NEAR, rows) {
                for column in whole(low[0] - NEAR, high[0] + NEAR, columns) {
                    let near = distance([column as f64, row as f64], *a, b) <= NEAR;
                    self.asked[row * columns + column] |= near;
                }
            }
        }
    }

    /// The cells around one.
    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> + use<L> {
        let [columns, rows] = self.ranges.map(|range| range.count);
        let (column, row) = (cell % columns, cell / columns);
        let around = move |at: usize, count: usize| at.saturating_sub(1)..(at + 2).min(count);
        around(row, rows).flat_map(move |j| around(column, columns).map(move |i| j * columns + i))
    }
}

/// Whole numbers from one number to another, of 0, 1, … below `count`.
fn whole(from: f64, to: f64, count: usize) -> std::ops::Range<usize> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to the numbers of cells"
    )]
    let clamped = |v: f64| v.clamp(0.0, count as f64) as usize;
    clamped(from.ceil())..clamped(to.floor() + 1.0)
}

/// How far a point is from a straight piece.
fn distance(point: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (d, to) = ([b[0] - a[0], b[1] - a[1]], [point[0] - a[0], point[1] - a[1]]);
    let length = d[0] * d[0] + d[1] * d[1];
    let along = if length > 0.0 { ((to[0] * d[0] + to[1] * d[1]) / length).clamp(0.0, 1.0) } else { 0.0 };
    let off = [to[0] - along * d[0], to[1] - along * d[1]];
    (off[0] * off[0] + off[1] * off[1]).sqrt()
}
