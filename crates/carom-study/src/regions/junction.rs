//! Points where three or more labels meet: found by shrinking a window.

use super::cell::{Stop, divide, runs};
use super::lattice::{Crossing, End, Lattice};
use super::{Junction, Label};
use crate::tolerance::{BLURRED, CROSSING_FINENESS};
use rayon::prelude::*;

/// Pieces in which a side of a window is searched: a tongue may enter between two nodes of one label.
const PIECES: usize = 4;

/// Sets of labels that are followed in one cell.
const MOST_PARTS: usize = 16;

/// What becomes of a window.
enum Shrunk<L> {
    /// A point.
    To(Junction<L>),
    /// Windows with fewer labels each: several points shared it.
    Parted(Vec<(Window, Vec<L>)>),
}

/// A rectangle in shares of the ranges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    pub(super) low: [f64; 2],
    pub(super) size: [f64; 2],
}

impl Window {
    /// A corner or a point of a side, `(0, 0)` to `(1, 1)`.
    fn at(&self, u: f64, v: f64) -> [f64; 2] {
        [self.low[0] + u * self.size[0], self.low[1] + v * self.size[1]]
    }

    /// Nine windows of half the size: the middle one first, so that a point on a cell's side is met in one of them.
    fn halves(&self) -> Vec<Window> {
        let size = self.size.map(|size| 0.5 * size);
        let shifts = [(0.25, 0.25), (0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5)];
        let shifts = shifts.into_iter().chain([(0.25, 0.0), (0.25, 0.5), (0.0, 0.25), (0.5, 0.25)]);
        shifts.map(|(u, v)| Window { low: self.at(u, v), size }).collect()
    }

    /// A quarter more on every side, within the plane: a point on a side is inside then.
    fn widened(&self) -> Window {
        let low = [0, 1].map(|axis| (self.low[axis] - 0.25 * self.size[axis]).max(0.0));
        let high = [0, 1].map(|axis| (self.low[axis] + 1.25 * self.size[axis]).min(1.0));
        Window { low, size: [0, 1].map(|axis| high[axis] - low[axis]) }
    }

    fn largest(&self) -> f64 {
        self.size[0].max(self.size[1])
    }

    fn smallest(&self) -> f64 {
        self.size[0].min(self.size[1])
    }
}

impl<L: Label> Lattice<'_, L> {
    /// The labels that must meet in a window, counter-clockwise from the smallest; empty where none need to.
    fn meeting(&self, window: &Window) -> Vec<L> {
        let (mut stops, mut crossings) = (vec![], vec![]);
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        for k in 0..4 {
            let (from, to) = (corners[k], corners[(k + 1) % 4]);
            let axis = k % 2;
            let start = self.ask(window.at(from.0, from.1));
            let mut last = End { share: window.at(from.0, from.1)[axis], label: start };
            for piece in 1..=PIECES {
                let share = piece as f64 / PIECES as f64;
                let at = window.at(from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
                let next = End { share: at[axis], label: self.ask(at) };
                self.pass(window, axis, at[1 - axis], [last, next], (&mut stops, &mut crossings));
                last = next;
            }
        }
        let centre = self.ask(window.at(0.5, 0.5));
        let mut labels: Vec<L> =
            divide(runs(&stops, &crossings), centre).meeting.iter().map(|run| run.label).collect();
        let first = (0..labels.len()).min_by_key(|&k| (labels[k], k)).unwrap_or(0);
        labels.rotate_left(first);
        labels
    }

    /// Walks one piece of a side, forward or backward along its axis.
    fn pass(
        &self,
        window: &Window,
        axis: usize,
        fixed: f64,
        [from, to]: [End<L>; 2],
        (stops, crossings): (&mut Vec<Stop>, &mut Vec<Crossing<L>>),
    ) {
        let forward = from.share <= to.share;
        let mut found = vec![];
        let bracket = if forward { [from, to] } else { [to, from] };
        let fineness = (CROSSING_FINENESS * window.smallest()).max(BLURRED * self.accuracy);
        self.isolate(axis, fixed, fineness, bracket, &mut found);
        if !forward {
            found.reverse();
        }
        for crossing in found {
            stops.push(Stop::Crossing { number: crossings.len(), forward });
            crossings.push(crossing);
        }
    }

    /// Every junction in a window or on its sides, to the accuracy of the lattice.
    pub(super) fn junctions(&self, window: Window) -> Vec<Junction<L>> {
        // A junction on a side belongs to the windows on both sides of it: the widened window is sure to hold it, and what lies outside is left out at the end.
        let wide = window.widened();
        let mut begun = vec![self.meeting(&wide)];
        let mut windows = vec![(wide, begun[0].clone())];
        let mut found: Vec<Junction<L>> = vec![];
        while let Some((window, labels)) = windows.pop() {
            match self.shrink(window, labels) {
                Shrunk::To(junction) if found.iter().all(|known| known.labels != junction.labels) => {
                    found.push(junction);
                }
                Shrunk::To(_) => {}
                Shrunk::Parted(parts) => {
                    for (part, labels) in parts {
                        if begun.len() < MOST_PARTS && !begun.contains(&labels) {
                            begun.push(labels.clone());
                            windows.push((part, labels));
                        }
                    }
                }
            }
        }
        found.retain(|junction| junction.labels.len() > 2);
        let sharp = |junction: &Junction<L>| 2.0 * junction.accuracy <= self.accuracy;
        if found.iter().any(sharp) {
            found.retain(sharp);
        }
        let ranges = self.ranges;
        let inside = |junction: &Junction<L>| {
            let within = 2.0 * self.accuracy;
            [0, 1].into_iter().all(|axis| {
                let share = ranges[axis].share(junction.at[axis]) - window.low[axis];
                (-within..=window.size[axis] + within).contains(&share)
            })
        };
        if found.iter().any(inside) {
            found.retain(inside);
        }
        found
    }

    fn shrink(&self, mut window: Window, mut labels: Vec<L>) -> Shrunk<L> {
        while window.largest() > self.accuracy {
            let halves: Vec<(Window, Vec<L>)> = window
                .halves()
                .into_par_iter()
                .panic_fuse()
                .map(|half| (half, self.meeting(&half)))
                .collect();
            let most = halves.iter().map(|(_, labels)| labels.len()).max().unwrap_or(0);
            if most == 0 {
                break;
            }
            if most < labels.len() || labels.is_empty() {
                return Shrunk::Parted(halves.into_iter().filter(|(_, labels)| !labels.is_empty()).collect());
            }
            // The labels that are followed: one that shows up now only is smaller than what was seen before.
            let holds = |half: &[L]| labels.iter().all(|label| half.contains(label));
            let same = halves.iter().position(|(_, half)| holds(half));
            let next = same.or_else(|| halves.iter().position(|(_, half)| half.len() == most));
            let Some((half, seen)) = next.and_then(|k| halves.into_iter().nth(k)) else { break };
            window = half;
            if same.is_none() {
                labels = seen;
            }
        }
        let at = self.point(window.at(0.5, 0.5));
        Shrunk::To(Junction { at, accuracy: 0.5 * window.largest(), labels })
    }
}
