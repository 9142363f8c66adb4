//! The convex hull of an outline: straight faces where it has them, chords of its curves elsewhere.

use super::CHORD;
use super::edge::Edge;
use crate::tolerance::OUTLINE_ROUNDING;
use carom_num::Vec2;

/// More vertices than this are thinned out as far as the tolerance allows.
pub(crate) const MANY: usize = 64;
/// The hull is searched among points this much nearer to the curves than its chords may be.
pub(crate) const FINER: f64 = 16.0;
/// Faces longer than this share of the size keep their direction.
const SIDE: f64 = 0.05;

/// A convex hull.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Hull {
    /// Counter-clockwise, face i from vertex i to the next.
    pub(crate) vertices: Vec<Vec2>,
    /// For each face: the curved edge it is a chord of.
    pub(crate) curves: Vec<Option<usize>>,
    /// The curved edges that bound it with more than their ends.
    pub(crate) curved: Vec<usize>,
    /// Farthest that the outline reaches beyond a face [m]; 0 where that is rounding.
    pub(crate) deviation: f64,
    /// Farthest that the outline stays behind the face that bridges it [m].
    pub(crate) hollow: f64,
    /// Where curves touch it is known to this [m].
    pub(crate) within: f64,
}

/// A point of the outline: the edge it lies on and the share of its parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Spot {
    at: Vec2,
    edge: usize,
    /// Of `of` equal steps along the edge.
    step: usize,
    of: usize,
}

/// A piece of the hull's boundary.
enum Stretch {
    Straight(Vec2),
    /// Part of a curved edge, from one share of its parameter to another.
    Curved {
        edge: usize,
        from: f64,
        to: f64,
    },
}

impl Hull {
    /// The hull of a counter-clockwise loop, its curves replaced by chords at most `chord` off.
    pub(crate) fn of(edges: &[Edge], size: f64, chord: f64) -> Self {
        let within = chord.min(CHORD * size) / FINER;
        let spots = spots(edges, within);
        let corners = without_straight_corners(wrap(&spots), size);
        let hollow = hollow_of(&spots, &corners);
        let mut hull =
            Self { vertices: vec![], curves: vec![], curved: vec![], deviation: 0.0, hollow, within };
        for stretch in stretches(&corners, edges) {
            match stretch {
                Stretch::Straight(from) => hull.push(from, None),
                Stretch::Curved { edge, from, to } => {
                    hull.curved.push(edge);
                    let chords = edges[edge].chords(to - from, chord);
                    for i in 0..chords {
                        let share = from + (to - from) * (i as f64 / chords as f64);
                        hull.push(edges[edge].point(share), Some(edge));
                    }
                }
            }
        }
        hull.curved.sort_unstable();
        hull.curved.dedup();
        hull.thin_out(chord, SIDE * size);
        let deviation = hull.deviation_of(edges, &corners, chord);
        hull.deviation = if deviation > OUTLINE_ROUNDING * size { deviation } else { 0.0 };
        hull
    }

    fn push(&mut self, vertex: Vec2, curve: Option<usize>) {
        self.vertices.push(vertex);
        self.curves.push(curve);
    }

    /// How far a point is beyond the farthest face [m]; below 0 inside.
    fn beyond(&self, point: Vec2) -> f64 {
        let k = self.vertices.len();
        let out = |i: usize| {
            let run = self.vertices[(i + 1) % k] - self.vertices[i];
            run.turned_right().dot(point - self.vertices[i]) / run.norm()
        };
        (0..k).map(out).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Leaves out the vertices that matter least, while there are many and none left out is farther than `within` from the hull.
    ///
    /// The ends of faces longer than `side` stay.
    fn thin_out(&mut self, within: f64, side: f64) {
        // For each vertex: those left out between it and the next.
        let mut lost: Vec<Vec<Vec2>> = vec![vec![]; self.vertices.len()];
        let mut costs: Vec<f64> = (0..lost.len()).map(|i| self.cost(i, &lost, side)).collect();
        while self.vertices.len() > MANY {
            let least = costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
            let Some((i, _)) = least.filter(|(_, cost)| **cost <= within) else { return };
            let (vertex, curve) = (self.vertices.remove(i), self.curves.remove(i));
            let moved = lost.remove(i);
            costs.remove(i);
            let k = self.vertices.len();
            let before = (i + k - 1) % k;
            lost[before].push(vertex);
            lost[before].extend(moved);
            self.curves[before] = self.curves[before].or(curve);
            for near in [before, i % k] {
                costs[near] = self.cost(near, &lost, side);
            }
        }
    }

    /// How far the hull would fall short without a vertex [m].
    fn cost(&self, i: usize, lost: &[Vec<Vec2>], side: f64) -> f64 {
        let k = self.vertices.len();
        let before = (i + k - 1) % k;
        let (from, here, to) = (self.vertices[before], self.vertices[i], self.vertices[(i + 1) % k]);
        if (here - from).norm() > side || (to - here).norm() > side {
            return f64::INFINITY;
        }
        let run = to - from;
        let away = |point: &Vec2| run.turned_right().dot(*point - from) / run.norm();
        lost[before].iter().chain(&lost[i]).map(away).fold(away(&here), f64::max)
    }

    fn deviation_of(&self, edges: &[Edge], corners: &[Spot], chord: f64) -> f64 {
        let mut farthest = 0.0f64;
        for stretch in stretches(corners, edges) {
            match stretch {
                Stretch::Straight(from) => farthest = farthest.max(self.beyond(from)),
                Stretch::Curved { edge, from, to } => {
                    // The middles of the chords are among these places.
                    let places = 8 * edges[edge].chords(to - from, chord);
                    for i in 0..=places {
                        let share = from + (to - from) * (i as f64 / places as f64);
                        farthest = farthest.max(self.beyond(edges[edge].point(share)));
                    }
                }
            }
        }
        farthest
    }
}

/// Points along the edges, the curves' so dense that chords between them are at most `within` off.
fn spots(edges: &[Edge], within: f64) -> Vec<Spot> {
    let mut found = vec![];
    for (number, edge) in edges.iter().enumerate() {
        let of = edge.chords(1.0, within);
        found.extend((0..of).map(|step| Spot {
            at: edge.point(step as f64 / of as f64),
            edge: number,
            step,
            of,
        }));
    }
    found
}

/// The corners of the convex hull, counter-clockwise (Andrew's monotone chain).
fn wrap(spots: &[Spot]) -> Vec<Spot> {
    let mut sorted = spots.to_vec();
    sorted.sort_by(|a, b| a.at.x.total_cmp(&b.at.x).then(a.at.y.total_cmp(&b.at.y)));
    sorted.dedup_by(|a, b| a.at == b.at);
    let chain = |points: &mut dyn Iterator<Item = Spot>| {
        let mut chain: Vec<Spot> = vec![];
        for spot in points {
            while let [.., a, b] = chain[..]
                && (b.at - a.at).cross(spot.at - a.at) <= 0.0
            {
                chain.pop();
            }
            chain.push(spot);
        }
        chain.pop();
        chain
    };
    let mut hull = chain(&mut sorted.iter().copied());
    hull.extend(chain(&mut sorted.iter().rev().copied()));
    hull
}

/// Leaves out corners that rounding has made of straight sides, and those at one place.
fn without_straight_corners(mut corners: Vec<Spot>, size: f64) -> Vec<Spot> {
    let mut i = 0;
    let mut kept = 0;
    while corners.len() > 3 && kept < corners.len() {
        let k = corners.len();
        let (a, b, c) = (corners[(i + k - 1) % k].at, corners[i % k].at, corners[(i + 1) % k].at);
        let run = c - a;
        if (b - a).norm() <= OUTLINE_ROUNDING * size
            || run.cross(b - a).abs() <= OUTLINE_ROUNDING * size * run.norm()
        {
            corners.remove(i % k);
            (i, kept) = ((i % k + k - 2) % (k - 1), 0);
        } else {
            (i, kept) = ((i + 1) % k, kept + 1);
        }
    }
    corners
}

/// How far the outline is behind the line between one corner of its hull and the next.
fn hollow_of(spots: &[Spot], corners: &[Spot]) -> f64 {
    let (n, k) = (spots.len(), corners.len());
    // A simple outline meets the corners in the hull's order.
    let key = |spot: &Spot| (spot.edge, spot.step);
    let place = |corner: &Spot| spots.binary_search_by_key(&key(corner), key).unwrap_or(0);
    let places: Vec<usize> = corners.iter().map(place).collect();
    let behind = |i: usize| {
        let (from, to) = (places[i], places[(i + 1) % k]);
        let (start, run) = (spots[from].at, spots[to].at - spots[from].at);
        let between = (from..from + (to + n - from) % n).map(|at| spots[at % n].at);
        between.map(|point| run.cross(point - start) / run.norm()).fold(0.0, f64::max)
    };
    (0..k).map(behind).fold(0.0, f64::max)
}

/// The hull's boundary as straight faces and parts of curves, beginning where a part begins.
fn stretches(corners: &[Spot], edges: &[Edge]) -> Vec<Stretch> {
    let k = corners.len();
    // From a corner to the next along a curved edge, by one step of it.
    let follows = |i: usize| {
        let (a, b) = (corners[i % k], corners[(i + 1) % k]);
        let next = if a.step + 1 == a.of { ((a.edge + 1) % edges.len(), 0) } else { (a.edge, a.step + 1) };
        !edges[a.edge].is_straight() && (b.edge, b.step) == next
    };
    let begins = |i: &usize| corners[*i].step == 0 || !follows(i + k - 1);
    let first = (0..k).find(begins).unwrap_or(0);
    let mut found: Vec<Stretch> = vec![];
    for i in (first..first + k).map(|i| i % k) {
        let spot = corners[i];
        if !follows(i) {
            found.push(Stretch::Straight(spot.at));
            continue;
        }
        let share = |step: usize| step as f64 / spot.of as f64;
        match found.last_mut() {
            Some(Stretch::Curved { edge, to, .. }) if *edge == spot.edge && *to == share(spot.step) => {
                *to = share(spot.step + 1);
            }
            _ => {
                let (from, to) = (share(spot.step), share(spot.step + 1));
                found.push(Stretch::Curved { edge: spot.edge, from, to });
            }
        }
    }
    found
}
