//! Outlines whose hull is a polygon rounded by one radius: kept as they are, without chords.

use super::edge::{Arc, Edge};
use crate::tolerance::OUTLINE_ROUNDING;
use carom_num::Vec2;
use carom_num::elementary::atan2;
use std::f64::consts::TAU;

/// The convex hull of centres, counter-clockwise, rounded by a radius.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rounded {
    pub(crate) centres: Vec<Vec2>,
    pub(crate) radius: f64,
}

/// Finds the rounded polygon that is the outline's hull, if there is one.
///
/// With `curves` the edges that bound the hull with more than their ends, all must be arcs of one radius r. Let C be the convex hull of their
/// centres. C rounded by r is the outline's hull exactly if
///
/// - no point of the outline is farther than r from C, and
/// - at each corner of C the arcs drawn reach from the normal of one side to that of the next.
///
/// Both are asked for within a billionth of the size.
pub(crate) fn rounded(edges: &[Edge], curves: &[usize], size: f64, within: f64) -> Option<Rounded> {
    let arcs: Vec<&Arc> = curves
        .iter()
        .map(|i| match &edges[*i] {
            Edge::Arc(arc) if arc.turns_left() => Some(arc),
            _ => None,
        })
        .collect::<Option<_>>()?;
    let radius = arcs.first()?.radius()?;
    let slack = OUTLINE_ROUNDING * size;
    if !arcs.iter().all(|arc| arc.radius().is_some_and(|other| (other - radius).abs() <= slack)) {
        return None;
    }
    let candidate =
        Rounded { centres: hull_of(arcs.iter().map(|arc| arc.centre()).collect(), slack), radius };
    let kept = |edge: &Edge| matches!(edge, Edge::Arc(arc) if arcs.contains(&arc));
    let inside =
        edges.iter().all(|edge| candidate.covers(edge, slack, if kept(edge) { 0.0 } else { within }));
    (inside && candidate.is_drawn(&arcs, slack)).then_some(candidate)
}

impl Rounded {
    /// True where an edge is nowhere farther than the radius from the centres' hull; its points are `within` of the chords between them.
    fn covers(&self, edge: &Edge, slack: f64, within: f64) -> bool {
        let ends = [edge.from(), edge.to()];
        let leftward = match edge {
            Edge::Line { .. } => false,
            Edge::Arc(arc) => arc.turns_left() && within > 0.0,
            Edge::Cubic(_) => true,
        };
        let chords = if leftward { edge.chords(1.0, within) } else { 1 };
        let between = (1..chords).map(|i| edge.point(i as f64 / chords as f64));
        ends.iter().all(|end| self.distance(*end) <= self.radius + slack)
            // Only a curve that turns left can reach beyond its points.
            && between.into_iter().all(|point| self.distance(point) <= self.radius - within)
    }

    /// Distance of a point from the centres' hull, 0 inside.
    fn distance(&self, point: Vec2) -> f64 {
        let k = self.centres.len();
        let mut least = f64::INFINITY;
        let mut inside = k > 2;
        for (i, a) in self.centres.iter().enumerate() {
            let run = self.centres[(i + 1) % k] - *a;
            inside &= run.cross(point - *a) >= 0.0;
            let along = if run == Vec2::ZERO { 0.0 } else { (point - *a).dot(run) / run.dot(run) };
            least = least.min((point - (*a + run * along.clamp(0.0, 1.0))).norm());
        }
        if inside { 0.0 } else { least }
    }

    /// True where the arcs about each centre reach all round its corner.
    fn is_drawn(&self, arcs: &[&Arc], slack: f64) -> bool {
        let k = self.centres.len();
        let slack_angle = slack / self.radius;
        (0..k).all(|i| {
            let centre = self.centres[i];
            let (start, turn) = if k == 1 {
                (arcs[0].u, TAU)
            } else {
                let (before, after) =
                    (centre - self.centres[(i + k - 1) % k], self.centres[(i + 1) % k] - centre);
                (before.turned_right(), angle(before, after, slack_angle))
            };
            let about = arcs.iter().filter(|arc| (arc.centre() - centre).norm() <= slack);
            // Where each arc begins, from the corner's start, and how far it goes.
            let mut reaches: Vec<(f64, f64)> =
                about.map(|arc| (angle(start, arc.u, slack_angle), arc.sweep.abs())).collect();
            reaches.extend(reaches.clone().iter().map(|(begin, sweep)| (begin - TAU, *sweep)));
            reaches.sort_by(|a, b| a.0.total_cmp(&b.0));
            let reached = reaches.iter().fold(0.0, |reached: f64, (begin, sweep)| {
                if *begin <= reached + slack_angle { reached.max(begin + sweep) } else { reached }
            });
            reached >= turn - slack_angle
        })
    }
}

/// Angle from one direction counter-clockwise to another, 0 to 2π; a turn less than the slack is none.
fn angle(from: Vec2, to: Vec2, slack: f64) -> f64 {
    let angle = atan2(from.cross(to), from.dot(to));
    let angle = if angle < 0.0 { angle + TAU } else { angle };
    if angle > TAU - slack { 0.0 } else { angle }
}

/// The corners of the convex hull of a few points, counter-clockwise; points nearer than the slack to another or to a side are left out.
fn hull_of(mut points: Vec<Vec2>, slack: f64) -> Vec<Vec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let mut apart: Vec<Vec2> = vec![];
    for point in points {
        if apart.iter().all(|other| (*other - point).norm() > slack) {
            apart.push(point);
        }
    }
    if apart.len() < 3 {
        return apart;
    }
    let half = |points: &mut dyn Iterator<Item = Vec2>| {
        let mut chain: Vec<Vec2> = vec![];
        for point in points {
            while let [.., a, b] = chain[..]
                && (point - a).cross(b - a) >= -slack * (point - a).norm()
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut apart.iter().copied());
    hull.extend(half(&mut apart.iter().rev().copied()));
    hull
}
