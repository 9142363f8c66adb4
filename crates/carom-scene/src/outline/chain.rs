//! From an outline's edges to the chain that the engine touches with: arcs of circles as they are, other curves as chords.

use super::edge::{Arc, Edge};
use crate::tolerance::OUTLINE_ROUNDING;
use carom_motion::planar::ChainPoint;
use carom_num::Vec2;
use std::f64::consts::PI;

/// More points than this are thinned out as far as the tolerance allows.
pub(super) const MANY: usize = 64;
/// Half a turn, and some rounding: longer arcs are cut.
const HALF_TURN: f64 = PI * (1.0 + OUTLINE_ROUNDING);
/// Places on a chord's curve at which it is asked how far that is.
const PLACES: u32 = 8;

/// A chain, and how well it keeps to the outline.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    pub(super) points: Vec<ChainPoint>,
    /// Arcs of circles among its edges.
    pub(super) arcs: usize,
    /// Curves that are chords in it.
    pub(super) curves: usize,
    /// Farthest that it is from the outline [m].
    pub(super) deviation: f64,
}

/// The chain of a closed loop of edges in a file of this size [m]; chords are at most `chord` off [m].
pub(super) fn chain_of(edges: &[Edge], size: f64, chord: f64) -> Chain {
    let mut out = Chain { points: vec![], arcs: 0, curves: 0, deviation: 0.0 };
    for edge in edges {
        let closed = (edge.to() - edge.from()).norm() <= OUTLINE_ROUNDING * size;
        match edge {
            Edge::Line { .. } if closed => {}
            Edge::Line { .. } => out.points.push(ChainPoint::straight(edge.from())),
            Edge::Arc(arc) if arc.radius().is_some() => out.add_arc(edge, arc),
            Edge::Arc(_) | Edge::Cubic(_) => out.add_chords(edge, chord),
        }
    }
    if out.points.len() > MANY {
        out.thin_out(chord);
    }
    out
}

impl Chain {
    fn add_arc(&mut self, edge: &Edge, arc: &Arc) {
        let pieces = (arc.sweep.abs() / HALF_TURN).ceil().max(1.0);
        let sweep = if arc.turns_left() { arc.sweep.abs() } else { -arc.sweep.abs() } / pieces;
        let at = |i: usize| edge.point(i as f64 / pieces);
        self.points.extend((0..pieces as usize).map(|i| ChainPoint { at: at(i), sweep }));
        self.arcs += 1;
    }

    fn add_chords(&mut self, edge: &Edge, chord: f64) {
        let count = edge.chords(1.0, chord);
        let at = |i: f64| edge.point(i / count as f64);
        for i in 0..count {
            let (from, to) = (at(i as f64), at((i + 1) as f64));
            let along = (to - from) / (to - from).norm();
            let off = |j: u32| along.cross(at(i as f64 + f64::from(j) / f64::from(PLACES)) - from).abs();
            self.deviation = (1..PLACES).map(off).fold(self.deviation, f64::max);
            self.points.push(ChainPoint::straight(from));
        }
        self.curves += 1;
    }

    /// Leaves out points of straight stretches that lie within `within` of the lines that then remain.
    fn thin_out(&mut self, within: f64) {
        let k = self.points.len();
        // An arc's ends stay; where there is none, two far points do.
        let is_end = |i: usize| self.points[i].sweep != 0.0 || self.points[(i + k - 1) % k].sweep != 0.0;
        let mut ends: Vec<usize> = (0..k).filter(|i| is_end(*i)).collect();
        if ends.len() < 2 {
            let away = |i: usize| (self.points[i].at - self.points[0].at).norm();
            let far = (0..k).max_by(|i, j| away(*i).total_cmp(&away(*j))).unwrap_or(0);
            ends = vec![0, far];
        }
        let mut kept = vec![false; k];
        for (i, from) in ends.iter().enumerate() {
            let to = ends[(i + 1) % ends.len()];
            self.keep(&mut kept, *from, if to > *from { to } else { to + k }, within);
        }
        let mut at = 0;
        self.points.retain(|_| {
            at += 1;
            kept[at - 1]
        });
    }

    /// Keeps the two ends of a stretch, and of the points between those that a line would miss by more than `within` (Ramer, Douglas and Peucker).
    fn keep(&mut self, kept: &mut [bool], from: usize, to: usize, within: f64) {
        let k = self.points.len();
        let mut stretches = vec![(from, to)];
        while let Some((from, to)) = stretches.pop() {
            (kept[from % k], kept[to % k]) = (true, true);
            let (a, b) = (self.points[from % k].at, self.points[to % k].at);
            let off = |i: usize| {
                let p = self.points[i % k].at;
                let along = (b - a).unit();
                along.map_or((p - a).norm(), |along| along.cross(p - a).abs())
            };
            let Some(worst) = (from + 1..to).max_by(|i, j| off(*i).total_cmp(&off(*j))) else { continue };
            if off(worst) > within {
                stretches.extend([(from, worst), (worst, to)]);
            } else {
                self.deviation = self.deviation.max(off(worst));
            }
        }
    }

    /// The chain about a point, all lengths times `scale`, beginning at its point number `first`.
    pub(super) fn placed(&self, about: Vec2, scale: f64, first: usize) -> Vec<ChainPoint> {
        let mut points: Vec<ChainPoint> =
            self.points.iter().map(|p| ChainPoint { at: (p.at - about) * scale, ..*p }).collect();
        points.rotate_left(first);
        points
    }
}
