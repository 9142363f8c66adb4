//! Loose lines and arcs, joined end to end into closed loops.

use super::drawn::{Fault, Origin, Piece, length, place};
use super::edge::Edge;
use crate::tolerance::OUTLINE_ROUNDING;
use carom_num::Vec2;

/// A closed loop of edges, and which piece of the file each came from.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Loop {
    pub(crate) edges: Vec<Edge>,
    /// For each edge.
    pub(crate) origins: Vec<Origin>,
}

impl Loop {
    fn of(piece: Piece, rounding: f64) -> Self {
        let mut made = Self { edges: vec![], origins: vec![] };
        made.append(piece, rounding);
        made
    }

    fn append(&mut self, mut piece: Piece, rounding: f64) {
        if let (Some(last), Some(first)) = (self.edges.last_mut(), piece.edges.first_mut())
            && let Some(bridge) = meet(last, first, rounding)
        {
            self.edges.push(bridge);
            self.origins.push(piece.origin.clone());
        }
        self.origins.extend(piece.edges.iter().map(|_| piece.origin.clone()));
        self.edges.extend(piece.edges);
    }

    fn close(mut self, rounding: f64) -> Self {
        let bridge = match &mut self.edges[..] {
            [first, .., last] => meet(last, first, rounding),
            // An arc of nearly a whole turn.
            [only] if only.from() != only.to() => Some(Edge::Line { from: only.to(), to: only.from() }),
            _ => None,
        };
        if let Some(bridge) = bridge {
            self.edges.push(bridge);
            self.origins.extend(self.origins.last().cloned());
        }
        self
    }

    pub(crate) fn reverse(&mut self) {
        self.edges.reverse();
        self.origins.reverse();
        self.edges.iter_mut().for_each(|edge| *edge = edge.reversed());
    }
}

/// Lets one edge end where the next begins: by moving the end of a line, else by a line between two curves.
///
/// A line that is too long is so cut short, rather than crossing its neighbour.
fn meet(last: &mut Edge, next: &mut Edge, rounding: f64) -> Option<Edge> {
    let (end, start) = (last.to(), next.from());
    if next.is_straight() || (end - start).norm() <= rounding {
        next.start_at(end);
    } else if last.is_straight() {
        last.end_at(start);
    } else {
        return Some(Edge::Line { from: end, to: start });
    }
    None
}

/// Closed loops, and the widest gap that was closed [m].
pub(crate) struct Joined {
    pub(crate) loops: Vec<Loop>,
    pub(crate) widest_gap: f64,
}

/// Joins pieces whose ends are at most `gap` apart; each end goes to its nearest, if that has none nearer.
///
/// # Errors
/// Every end that meets none, and every place where more than two meet.
pub(crate) fn join(pieces: Vec<Piece>, size: f64, gap: f64) -> Result<Joined, Vec<Fault>> {
    let rounding = OUTLINE_ROUNDING * size;
    let (closed, open): (Vec<Piece>, Vec<Piece>) = pieces.into_iter().partition(|piece| piece.closed);
    let mut loops: Vec<Loop> =
        closed.into_iter().map(|piece| Loop::of(piece, rounding).close(rounding)).collect();
    let ends = Ends::of(&open);
    let mut faults = ends.forks(rounding);
    let mut partners = vec![None; ends.points.len()];
    ends.pair(&mut partners, rounding);
    ends.pair(&mut partners, gap.max(rounding));
    if faults.is_empty() {
        faults = ends.loose(&partners, gap);
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut widest_gap = 0.0f64;
    for (end, partner) in partners.iter().enumerate() {
        let Some(partner) = partner else { continue };
        widest_gap = widest_gap.max((ends.points[end] - ends.points[*partner]).norm());
    }
    loops.extend(follow(open, &partners, rounding));
    Ok(Joined { loops, widest_gap })
}

/// The ends of open pieces: 2i is where piece i starts, 2i + 1 where it ends.
struct Ends<'p> {
    pieces: &'p [Piece],
    points: Vec<Vec2>,
    /// By x, for neighbours to be near in the list.
    order: Vec<usize>,
}

impl<'p> Ends<'p> {
    fn of(pieces: &'p [Piece]) -> Self {
        let points: Vec<Vec2> = pieces.iter().flat_map(|piece| [piece.from(), piece.to()]).collect();
        let mut order: Vec<usize> = (0..points.len()).collect();
        order.sort_by(|i, j| points[*i].x.total_cmp(&points[*j].x).then(i.cmp(j)));
        Self { pieces, points, order }
    }

    /// Pairs of ends that are near each other, with their distance.
    fn near(&self, within: f64) -> Vec<(f64, usize, usize)> {
        let mut found = vec![];
        for (k, i) in self.order.iter().enumerate() {
            let reach = self.points[*i].x + within;
            let after = self.order[k + 1..].iter().take_while(|j| self.points[**j].x <= reach);
            found.extend(after.filter_map(|j| {
                let apart = (self.points[*i] - self.points[*j]).norm();
                (apart <= within).then_some((apart, *i.min(j), *i.max(j)))
            }));
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        found
    }

    /// Pairs the nearest ends first.
    fn pair(&self, partners: &mut [Option<usize>], within: f64) {
        for (_, i, j) in self.near(within) {
            if partners[i].is_none() && partners[j].is_none() {
                (partners[i], partners[j]) = (Some(j), Some(i));
            }
        }
    }

    /// Places where more than two ends meet.
    fn forks(&self, within: f64) -> Vec<Fault> {
        let mut meeting: Vec<Vec<usize>> = (0..self.points.len()).map(|end| vec![end]).collect();
        for (_, i, j) in self.near(within) {
            meeting[i].push(j);
            meeting[j].push(i);
        }
        let mut faults = vec![];
        for (end, others) in meeting.iter_mut().enumerate() {
            others.sort_unstable();
            if others.len() < 3 || others[0] != end {
                continue;
            }
            let (count, at) = (others.len(), place(self.points[end]));
            let names: Vec<String> = others.iter().map(|end| self.origin(*end).to_string()).collect();
            let text = format!("{count} ends meet at {at}: {}", names.join(", "));
            faults.push(Fault::new(self.origin(end).line, text).with_help(
                "is something drawn twice, or does a construction line touch the outline? Leave it out, or draw the outline on a layer of its own",
            ));
        }
        faults
    }

    /// Ends that nothing continues.
    fn loose(&self, partners: &[Option<usize>], gap: f64) -> Vec<Fault> {
        let free: Vec<usize> = (0..partners.len()).filter(|end| partners[*end].is_none()).collect();
        free.iter()
            .map(|end| {
                let point = self.points[*end];
                let apart = |other: &usize| (self.points[*other] - point).norm();
                let nearest = free.iter().filter(|other| *other != end).map(apart).fold(f64::NAN, f64::min);
                let origin = self.origin(*end);
                let verb = if end % 2 == 0 { "begins" } else { "ends" };
                let text = format!(
                    "the outline is open: {origin} {verb} at {} and nothing goes on there; the nearest loose end is {} away, and gaps up to {} are closed",
                    place(point),
                    length(nearest),
                    length(gap)
                );
                Fault::new(origin.line, text)
            })
            .collect()
    }

    fn origin(&self, end: usize) -> &Origin {
        &self.pieces[end / 2].origin
    }
}

/// Goes from piece to piece until each loop is closed.
fn follow(open: Vec<Piece>, partners: &[Option<usize>], rounding: f64) -> Vec<Loop> {
    let mut left: Vec<Option<Piece>> = open.into_iter().map(Some).collect();
    let mut loops = vec![];
    for first in 0..left.len() {
        let mut entered = 2 * first;
        let mut made = Loop { edges: vec![], origins: vec![] };
        while let Some(mut piece) = left[entered / 2].take() {
            if entered % 2 == 1 {
                piece.reverse();
            }
            made.append(piece, rounding);
            match partners[entered ^ 1] {
                Some(next) => entered = next,
                None => break,
            }
        }
        if !made.edges.is_empty() {
            loops.push(made.close(rounding));
        }
    }
    loops
}
