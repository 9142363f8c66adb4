//! A region diagram before it is computed, and what comes of it.

use crate::tasks::axes::Plane;
use crate::tasks::tolerance::REGION_ACCURACY;
use carom_figure::{RegionCurve, RegionName};
use carom_scene::RegionsThresholdReport;
use carom_study::Ends;
use carom_study::regions::{Boundary, Options, Range, Regions, across, distance, find};

/// What happens at a point, as a number; [`Study::name`] says what it is.
pub(super) type Label = u64;

/// What a diagram says of its regions in words.
pub(super) type Remarks<'a> = Box<dyn Fn(&Regions<Label>) -> Vec<String> + Sync + 'a>;

/// Changes of the outcome on single lines of the plane.
pub(super) type Thresholds<'a> = Box<dyn Fn() -> Vec<RegionsThresholdReport> + Sync + 'a>;

/// End states at a point.
pub(super) type EndsAt<'a> = Box<dyn Fn(f64, f64) -> Option<Ends> + Sync + 'a>;

/// Cells along each axis on which a curve is drawn.
const CURVE_CELLS: usize = 160;

/// A curve between two outcomes: a function that vanishes on it, and whether it separates them there.
pub(super) struct Curve<'a> {
    pub(super) name: String,
    /// The states on its two sides, where the engine's are to be compared with it.
    pub(super) states: Option<[u8; 2]>,
    pub(super) border: Box<dyn Fn(f64, f64) -> (f64, bool) + Sync + 'a>,
}

/// What is to be drawn.
pub(super) struct Study<'a> {
    /// Of its files.
    pub(super) slug: String,
    pub(super) title: String,
    pub(super) subtitle: String,
    pub(super) plane: &'a Plane,
    pub(super) classify: Box<dyn Fn(f64, f64) -> Label + Sync + 'a>,
    pub(super) name: Box<dyn Fn(Label) -> RegionName + Sync + 'a>,
    /// The state that the closed forms know of a label.
    pub(super) state: Box<dyn Fn(Label) -> u8 + Sync + 'a>,
    pub(super) curves: Vec<Curve<'a>>,
    pub(super) curves_are: String,
    /// End states at a point, where they are sought.
    pub(super) ends: Option<EndsAt<'a>>,
    /// What else a person should know, from the regions.
    pub(super) remarks: Remarks<'a>,
    /// Where the outcome changes on single lines of the plane, beside a closed form.
    pub(super) thresholds: Option<Thresholds<'a>>,
    /// What a boundary is located to, as a share of the ranges.
    pub(super) accuracy: f64,
}

/// On what share of the grid the laws leave a choice.
pub(super) struct EndsShares {
    /// Several end states obey the laws.
    pub(super) several: f64,
    /// The staged impact ends in none of them.
    pub(super) not_reached: f64,
    /// The staged impact met several ways on.
    pub(super) branching: f64,
}

/// How a curve and the engine's boundary compare.
pub(super) struct Comparison {
    pub(super) name: String,
    pub(super) states: [u8; 2],
    /// Points of the engine's boundary between these states.
    pub(super) points: usize,
    /// The largest distance of one of them from the curve, as a share of the ranges.
    pub(super) largest: f64,
    /// Points of the curve, where it applies.
    pub(super) curve_points: usize,
    /// Those on whose two sides, [`REGION_ACCURACY`] away, the engine finds its two states.
    pub(super) confirmed: usize,
}

/// A diagram that is computed.
pub(super) struct Findings {
    pub(super) regions: Regions<Label>,
    pub(super) curves: Vec<RegionCurve>,
    pub(super) comparisons: Vec<Comparison>,
    /// Points of boundaries for which there is no closed form.
    pub(super) unexplained: usize,
    pub(super) ends: Option<EndsShares>,
    pub(super) remarks: Vec<String>,
    pub(super) thresholds: Vec<RegionsThresholdReport>,
}

impl Study<'_> {
    fn ranges(&self) -> [Range; 2] {
        [0, 1].map(|axis| self.plane.axes[axis].range)
    }

    /// Finds the regions and compares their boundaries with the curves; `step` is called at each point.
    pub(super) fn compute(&self, depth: u32, step: &(dyn Fn() + Sync)) -> Result<Findings, String> {
        let [x, y] = self.ranges();
        let options = Options { accuracy: self.accuracy, depth };
        let asked = |x: f64, y: f64| {
            step();
            (self.classify)(x, y)
        };
        let regions = find(x, y, &options, asked).map_err(|error| error.to_string())?;
        let curves: Vec<RegionCurve> = self.curves.iter().map(|curve| self.drawn(curve)).collect();
        let pairs = curves.iter().zip(&self.curves);
        let comparisons = pairs.filter_map(|(drawn, curve)| self.compared(curve, drawn, &regions)).collect();
        let known = |pair: [Label; 2]| self.curves.iter().any(|curve| self.is_between(curve, pair));
        let unknown = regions.boundaries.iter().filter(|line| !known(line.pair));
        let unexplained = unknown.map(|line| line.points.len()).sum();
        let remarks = (self.remarks)(&regions);
        let ends = self.ends.as_ref().map(|ends| self.ends_shares(ends));
        let thresholds = self.thresholds.as_ref().map(|thresholds| thresholds()).unwrap_or_default();
        Ok(Findings { regions, curves, comparisons, unexplained, ends, remarks, thresholds })
    }

    /// At the nodes of the grid.
    fn ends_shares(&self, ends: &EndsAt<'_>) -> EndsShares {
        let [x, y] = self.ranges();
        let node = |range: &Range, k: usize| range.at(k as f64 / range.count as f64);
        let (mut nodes, mut several, mut not_reached, mut branching) = (0u32, 0u32, 0u32, 0u32);
        for j in 0..=y.count {
            for i in 0..=x.count {
                nodes += 1;
                let Some(ends) = ends(node(&x, i), node(&y, j)) else { continue };
                several += u32::from(ends.count > 1);
                not_reached += u32::from(!ends.reached);
                branching += u32::from(ends.branches > 1);
            }
        }
        let share = |part: u32| f64::from(part) / f64::from(nodes);
        EndsShares { several: share(several), not_reached: share(not_reached), branching: share(branching) }
    }

    /// A curve where it applies, from the change of its sign.
    fn drawn(&self, curve: &Curve<'_>) -> RegionCurve {
        let [x, y] = self.ranges().map(|range| Range { count: CURVE_CELLS, ..range });
        let side = |x: f64, y: f64| match (curve.border)(x, y) {
            (_, false) => 2,
            (residual, true) => Label::from(residual > 0.0),
        };
        let options = Options { accuracy: REGION_ACCURACY, depth: 2 };
        let lines = find(x, y, &options, side).map(|found| found.boundaries).unwrap_or_default();
        let pieces = lines.into_iter().filter(|line| line.pair == [0, 1]);
        RegionCurve { name: curve.name.clone(), pieces: pieces.map(|line| line.points).collect() }
    }

    fn is_between(&self, curve: &Curve<'_>, pair: [Label; 2]) -> bool {
        let [a, b] = pair.map(|label| (self.state)(label));
        curve.states.is_some_and(|[p, q]| [a, b] == [p, q] || [b, a] == [p, q])
    }

    fn compared(
        &self,
        curve: &Curve<'_>,
        drawn: &RegionCurve,
        regions: &Regions<Label>,
    ) -> Option<Comparison> {
        let states = curve.states?;
        let ranges = self.ranges();
        let lines = regions.boundaries.iter().filter(|line| self.is_between(curve, line.pair));
        let (mut points, mut largest) = (0, 0.0f64);
        for point in lines.flat_map(|line| located(line, regions)) {
            points += 1;
            largest = largest.max(distance(ranges, *point, |x, y| (curve.border)(x, y).0));
        }
        let (mut curve_points, mut confirmed) = (0, 0);
        // The ends of a piece are the border of the plane, or points where other curves begin.
        for point in drawn.pieces.iter().flat_map(|piece| piece.iter().skip(1).rev().skip(1)) {
            let Some(normal) = across(ranges, *point, |x, y| (curve.border)(x, y).0) else { continue };
            let side = |sign: f64| {
                let [x, y] = [0, 1].map(|axis| {
                    point[axis]
                        + sign * REGION_ACCURACY * normal[axis] * (ranges[axis].to - ranges[axis].from)
                });
                (self.classify)(x, y)
            };
            curve_points += 1;
            confirmed += usize::from(self.is_between(curve, [side(-1.0), side(1.0)]));
        }
        Some(Comparison { name: curve.name.clone(), states, points, largest, curve_points, confirmed })
    }
}

/// The points of a line that are located to [`REGION_ACCURACY`]: not a junction of regions too small to be followed.
fn located<'l>(line: &'l Boundary<Label>, regions: &Regions<Label>) -> &'l [[f64; 2]] {
    let coarse = |end: Option<usize>| {
        usize::from(end.is_some_and(|number| regions.junctions[number].accuracy > REGION_ACCURACY))
    };
    let (first, last) = (coarse(line.ends[0]), line.points.len() - coarse(line.ends[1]));
    line.points.get(first..last).unwrap_or_default()
}
