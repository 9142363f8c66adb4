//! From the points of a chain to arcs and faces: how an outline or a plate is drawn.

use super::shape::{Parts, Shape};
use super::shape_problem::ShapeProblem;
use crate::tolerance::{COINCIDENT_VERTICES, SMOOTH_JOINT, STRAIGHT_JOINT, TANGENT_JOINT};
use carom_num::Vec2;
use carom_num::elementary::{atan2, sin, sin_cos};
use std::f64::consts::PI;

/// A point of a chain, and how the edge that leaves it runs to the next one.
///
/// # Example
/// From (1, 0) to (0, 1), a quarter turn to the left about the origin.
/// ```
/// use carom_motion::planar::ChainPoint;
/// use carom_num::Vec2;
/// let quarter = ChainPoint { at: Vec2::new(1.0, 0.0), sweep: std::f64::consts::FRAC_PI_2 };
/// let (centre, radius) = quarter.arc_to(Vec2::new(0.0, 1.0)).unwrap();
/// assert!(centre.norm() < 1e-15 && (radius - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainPoint {
    /// Where [m].
    pub at: Vec2,
    /// By how much the edge turns on its way \[rad\], positive to the left: 0 for a straight one, within ±2π.
    pub sweep: f64,
}

impl ChainPoint {
    /// A point that a straight edge leaves.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::ChainPoint;
    /// use carom_num::Vec2;
    /// assert_eq!(ChainPoint::straight(Vec2::new(1.0, 2.0)).sweep, 0.0);
    /// ```
    pub fn straight(at: Vec2) -> Self {
        Self { at, sweep: 0.0 }
    }

    /// Centre and signed radius of the edge to `next`: the radius is negative where the edge turns right. `None` where it is straight.
    ///
    /// # Source
    /// A chord of length c under the angle s at the centre: `r = c / (2 sin(s/2))`, and the centre is `c / (2 tan(s/2))` to the left of the middle.
    ///
    /// # Example
    /// Half a turn to the right over a chord of 2 m.
    /// ```
    /// use carom_motion::planar::ChainPoint;
    /// use carom_num::Vec2;
    /// let half = ChainPoint { at: Vec2::ZERO, sweep: -std::f64::consts::PI };
    /// let (centre, radius) = half.arc_to(Vec2::new(2.0, 0.0)).unwrap();
    /// assert!((centre - Vec2::new(1.0, 0.0)).norm() < 1e-15 && (radius + 1.0).abs() < 1e-15);
    /// ```
    pub fn arc_to(&self, next: Vec2) -> Option<(Vec2, f64)> {
        if self.sweep == 0.0 {
            return None;
        }
        let chord = next - self.at;
        let (sin, cos) = sin_cos(0.5 * self.sweep);
        let centre = (self.at + next) * 0.5 + chord.turned_left() * (0.5 * cos / sin);
        Some((centre, 0.5 * chord.norm() / sin))
    }

    /// The point of the edge to `next` at this share of its length.
    ///
    /// From the start the chord to a point of an arc has the length c sin(σs/2)/sin(σ/2) and is turned by half of what is left of the sweep σ: no
    /// centre is needed, which for an edge that is hardly bent would lie far away.
    ///
    /// # Example
    /// The middle of half a turn to the right over a chord of 2 m.
    /// ```
    /// use carom_motion::planar::ChainPoint;
    /// use carom_num::Vec2;
    /// let half = ChainPoint { at: Vec2::ZERO, sweep: -std::f64::consts::PI };
    /// assert!((half.along(Vec2::new(2.0, 0.0), 0.5) - Vec2::new(1.0, 1.0)).norm() < 1e-15);
    /// ```
    pub fn along(&self, next: Vec2, share: f64) -> Vec2 {
        let chord = next - self.at;
        if self.sweep == 0.0 {
            return self.at + chord * share;
        }
        let half = 0.5 * self.sweep;
        let (whole, part) = (sin(half), sin(half * share));
        let (sine, cos) = sin_cos(half * (share - 1.0));
        self.at + chord.rotated(cos, sine) * (part / whole)
    }
}

/// An edge of a chain that has been read: what it is, and its directions at both ends.
struct Run {
    /// Where it starts [m].
    from: Vec2,
    /// Centre and signed radius, of an arc.
    arc: Option<(Vec2, f64)>,
    sweep: f64,
    leaves: Vec2,
    arrives: Vec2,
}

fn runs(points: &[ChainPoint]) -> Vec<Run> {
    let next = |i: usize| points[(i + 1) % points.len()].at;
    let run = |(i, p): (usize, &ChainPoint)| {
        let (to, arc) = (next(i), p.arc_to(next(i)));
        let chord = (to - p.at) / (to - p.at).norm();
        let (sin, cos) = sin_cos(0.5 * p.sweep);
        let (leaves, arrives) = (chord.rotated(cos, -sin), chord.rotated(cos, sin));
        Run { from: p.at, arc, sweep: p.sweep, leaves, arrives }
    };
    points.iter().enumerate().map(run).collect()
}

impl Shape {
    /// A shape whose outline is a closed chain of arcs and segments about the mass centre [m], counter-clockwise.
    ///
    /// Where two edges meet at an angle there is a corner: an arc of radius 0. Where they meet smoothly there is none, and a contact passes from one to
    /// the other: two arcs up to 10⁻⁹ rad; two segments up to 10⁻⁸ rad, where they are laid along one line; a segment and an arc up to 10⁻⁵ rad, where the segment is
    /// laid along the arc. An edge that comes back along itself has no thickness: a rod, or a plate.
    ///
    /// # Errors
    /// Every [`ShapeProblem`] found.
    ///
    /// # Example
    /// An L of two legs, 3 m and 2 m long and 1 m wide: five corners that turn left, and one that turns right.
    /// ```
    /// use carom_motion::planar::{ChainPoint, Shape};
    /// use carom_num::Vec2;
    /// let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    /// let chain = corners.map(|(x, y)| ChainPoint::straight(Vec2::new(x, y)));
    /// let l = Shape::of_chain(&chain).unwrap();
    /// assert_eq!((0..6).filter(|&v| l.is_hollow(v)).collect::<Vec<_>>(), [3]);
    /// assert_eq!(l.hull().vertices().len(), 5);
    /// ```
    pub fn of_chain(points: &[ChainPoint]) -> Result<Self, Vec<ShapeProblem>> {
        let problems = problems_of(points);
        if !problems.is_empty() {
            return Err(problems);
        }
        Ok(Self::of_parts(&parts_of(points)))
    }

    /// A shape without thickness: an open chain of arcs and segments, and the way back.
    ///
    /// Its faces and arcs run there first, with their right sides out, then back.
    ///
    /// # Errors
    /// Every [`ShapeProblem`] found.
    ///
    /// # Example
    /// A chute: a segment, a quarter of a circle that turns left, and another segment. It has two faces and an arc on each side, and two ends.
    /// ```
    /// use carom_motion::planar::{ChainPoint, Shape};
    /// use carom_num::Vec2;
    /// let at = |x, y| ChainPoint::straight(Vec2::new(x, y));
    /// let bend = ChainPoint { sweep: std::f64::consts::FRAC_PI_2, ..at(1.0, 0.0) };
    /// let chute = Shape::of_open_chain(&[at(0.0, 0.0), bend, at(2.0, 1.0), at(2.0, 2.0)]).unwrap();
    /// assert_eq!((chute.vertices().len(), chute.faces()), (4, 4));
    /// let bends = [(1, 1.0), (3, -1.0)].map(|(v, radius)| (chute.radius_of(v) - radius).abs() < 1e-15);
    /// assert_eq!((bends, chute.radius_of(0), chute.radius_of(2)), ([true, true], 0.0, 0.0));
    /// ```
    pub fn of_open_chain(points: &[ChainPoint]) -> Result<Self, Vec<ShapeProblem>> {
        let Some((last, before)) = points.split_last() else { return Err(vec![ShapeProblem::Empty]) };
        let mut there_and_back = before.to_vec();
        // The edge that leaves a point on the way back is the one that has come to it, turned round.
        there_and_back.push(ChainPoint { at: last.at, sweep: -before.last().map_or(0.0, |p| p.sweep) });
        for i in (1..before.len()).rev() {
            there_and_back.push(ChainPoint { at: points[i].at, sweep: -points[i - 1].sweep });
        }
        Self::of_chain(&there_and_back)
    }
}

/// An arc turns by at most this \[rad\], half a turn and some rounding: a longer one is cut, so that a contact on it lies between the directions of its
/// two ends.
const LONGEST_ARC: f64 = PI + SMOOTH_JOINT;

/// Arcs and faces, in turn, of a chain without problems.
fn parts_of(points: &[ChainPoint]) -> Parts {
    let runs = runs(points);
    let mut parts = Parts::default();
    if let Some(whole) = whole_circle(&runs) {
        parts.arc(whole.0, whole.1, false);
        return parts;
    }
    // Between two arcs there is always a face: where they follow each other directly it has no length.
    for (i, run) in runs.iter().enumerate() {
        let before = &runs[(i + runs.len() - 1) % runs.len()];
        if let Some(turn) = corner(before, run) {
            parts.runs(before.arrives);
            parts.arc(run.from, 0.0, turn < 0.0);
        }
        match run.arc {
            None => parts.edge(run.leaves),
            Some((centre, radius)) => {
                let pieces = (run.sweep.abs() / LONGEST_ARC).ceil();
                let mut along = run.leaves;
                let (sin, cos) = sin_cos(run.sweep / pieces);
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "one to three")]
                for _ in 0..pieces as usize {
                    parts.runs(along);
                    parts.arc(centre, radius, radius < 0.0);
                    along = along.rotated(cos, sin);
                }
            }
        }
    }
    parts
}

/// The one circle of which all edges are arcs.
fn whole_circle(runs: &[Run]) -> Option<(Vec2, f64)> {
    let (centre, radius) = runs.first()?.arc?;
    let slack = SMOOTH_JOINT * radius.abs();
    let same =
        |run: &Run| run.arc.is_some_and(|(c, r)| (c - centre).norm() <= slack && (r - radius).abs() <= slack);
    (radius > 0.0 && runs.iter().all(same)).then_some((centre, radius))
}

/// By how much the chain turns where one edge meets the next \[rad\]; `None` where it goes on smoothly.
fn corner(before: &Run, after: &Run) -> Option<f64> {
    let (a, b) = (before.arrives, after.leaves);
    let turn = atan2(a.cross(b), a.dot(b));
    // What comes back along itself turns about its end, to the left: a rod has an end there and no hollow.
    let turn = if turn.abs() > PI - SMOOTH_JOINT { PI } else { turn };
    // A segment gives way to the arc that it touches, and two segments are laid along one line; two arcs do not give way to each other.
    let smooth = match (before.arc, after.arc) {
        (Some(_), Some(_)) => SMOOTH_JOINT,
        (None, None) => STRAIGHT_JOINT,
        _ => TANGENT_JOINT,
    };
    (turn.abs() > smooth).then_some(turn)
}

fn problems_of(points: &[ChainPoint]) -> Vec<ShapeProblem> {
    if points.is_empty() {
        return vec![ShapeProblem::Empty];
    }
    let finite = |p: &ChainPoint| p.at.is_finite() && p.sweep.abs() < 2.0 * PI;
    if points.len() < 2 || !points.iter().all(finite) {
        return vec![ShapeProblem::NotANumber];
    }
    let size = points.iter().map(|p| (p.at - points[0].at).norm()).fold(0.0, f64::max);
    let mut found = vec![];
    for (i, p) in points.iter().enumerate() {
        let j = (i + 1) % points.len();
        if (points[j].at - p.at).norm() <= COINCIDENT_VERTICES * size {
            found.push(ShapeProblem::Coincide(i, j));
        }
    }
    if !found.is_empty() {
        return found;
    }
    // An outline that does not cross itself turns once round; one that runs clockwise turns once the other way.
    let runs = runs(points);
    let turned: f64 = (0..runs.len())
        .map(|i| runs[i].sweep + corner(&runs[(i + runs.len() - 1) % runs.len()], &runs[i]).unwrap_or(0.0))
        .sum();
    if turned < -PI {
        vec![ShapeProblem::Clockwise]
    } else if !(PI..3.0 * PI).contains(&turned) {
        vec![ShapeProblem::Crosses]
    } else {
        vec![]
    }
}
