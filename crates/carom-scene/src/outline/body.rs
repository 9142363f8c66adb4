//! From an outline to a part: what the engine touches with, what it weighs, and what its author should know.

use super::FileOutline;
use super::chain::{Chain, MANY, chain_of};
use super::drawn::length;
use super::edge::Edge;
use super::loops::Loop;
use super::moments::Moments;
use crate::approximation::{Approximation, ApproximationKind};
use crate::tolerance::OUTLINE_ROUNDING;
use carom_feeder::PartKind;
use carom_motion::planar::{ChainPoint, MassProperties, Rest, RestKind, Shape, ShapeProblem};
use carom_num::Vec2;

/// How far the chords of a picture may be from its curves, as a share of its size: below what a screen shows.
const SHOWN: f64 = 5e-4;

/// A part made of an outline.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Solid {
    pub(crate) kind: PartKind,
    /// The outline about the mass centre.
    pub(crate) shape: Shape,
    /// Those of the outline itself, its holes left out.
    pub(crate) properties: MassProperties,
    /// The point of the file's plane, in the scene's size, about which the shape is given.
    pub(crate) origin: Vec2,
    pub(crate) notes: Vec<String>,
    /// Of a body of revolution [m³]; what is flat has the area of its properties times its depth.
    pub(crate) volume: Option<f64>,
    /// How the shape differs from the outline.
    pub(crate) approximations: Vec<Approximation>,
}

impl FileOutline {
    /// The part, all lengths of the file times `scale`.
    ///
    /// # Errors
    /// What the engine finds wrong with the outline: a scale beyond measure.
    pub(crate) fn solid(&self, scale: f64) -> Result<Solid, Vec<ShapeProblem>> {
        let (outer, size) = (&self.nest.outer.edges, self.size);
        let from = outer.first().map_or(Vec2::ZERO, Edge::from);
        let filled = Moments::of(outer, from);
        let holes = self.nest.holes.iter().map(|hole| Moments::of(&hole.edges, from));
        let drawn = holes.fold(filled, Moments::plus).properties(from);
        let about = drawn.centroid;
        let chain = chain_of(outer, size, self.chord);
        let mut shape = Shape::of_chain(&chain.placed(about, scale, 0))?;
        let is_circle = shape.faces() == 0;
        let is_disc = is_circle && shape.vertices()[0].norm() <= OUTLINE_ROUNDING * size * scale;
        let kind = if is_disc { PartKind::Disc } else { PartKind::Polygon };
        if is_disc {
            shape = Shape::new(vec![Vec2::ZERO], shape.radius())?;
        } else {
            let first = starting_point(&chain.placed(about, scale, 0), &shape, first_face);
            shape = Shape::of_chain(&chain.placed(about, scale, first))?;
        }
        let properties = MassProperties {
            area: drawn.area * scale * scale,
            centroid: drawn.centroid * scale,
            gyration_squared: drawn.gyration_squared * scale * scale,
        };
        let report = Report { chain: &chain, rests: shape.rests(), scale };
        let chords = report.chords(self.chord);
        let mut notes = vec![self.reading()];
        notes.extend(report.arcs());
        notes.extend(chords.iter().map(|chords| chords.text.clone()));
        notes.extend(report.faces());
        Ok(Solid {
            kind,
            shape,
            properties,
            origin: about * scale,
            notes,
            volume: None,
            approximations: chords.into_iter().collect(),
        })
    }

    /// The outline and then its holes as closed chains of points about `origin`, all lengths of the file times `scale`.
    pub(crate) fn loops(&self, scale: f64, origin: Vec2) -> Vec<Vec<Vec2>> {
        let within = SHOWN * self.size;
        let chain = |drawn: &Loop| {
            let points = drawn.edges.iter().flat_map(|edge| {
                let chords = edge.chords(1.0, within);
                (0..chords).map(move |i| edge.point(i as f64 / chords as f64) * scale - origin)
            });
            points.collect()
        };
        std::iter::once(&self.nest.outer).chain(&self.nest.holes).map(chain).collect()
    }

    fn reading(&self) -> String {
        // Gaps of rounding are closed by lines that nobody drew.
        let rounding = OUTLINE_ROUNDING * self.size;
        let long = |edge: &&Edge| (edge.to() - edge.from()).norm() > rounding || !edge.is_straight();
        let edges = counted(self.nest.outer.edges.iter().filter(long).count(), "edge");
        let holes = counted(self.nest.holes.len(), "hole");
        format!("part.file: {}, {edges}, {holes}; {}", self.file, self.said)
    }
}

/// The point of a chain from which the part's faces are numbered, so that face 0 is the one that is `chosen` of them.
pub(crate) fn starting_point(points: &[ChainPoint], shape: &Shape, chosen: fn(&[Rest]) -> usize) -> usize {
    let rests = shape.rests();
    let Some(rest) = rests.get(chosen(rests)) else { return 0 };
    let (vertex, radius) = (shape.vertices()[rest.vertex], shape.radius_of(rest.vertex));
    // Its vertex is a corner of the chain, or the centre of an arc.
    let off = |i: usize| match points[i].arc_to(points[(i + 1) % points.len()].at) {
        Some((centre, _)) if radius > 0.0 => (centre - vertex).norm(),
        _ if radius > 0.0 => f64::INFINITY,
        _ => (points[i].at - vertex).norm(),
    };
    (0..points.len()).min_by(|i, j| off(*i).total_cmp(&off(*j))).unwrap_or(0)
}

/// The longest side; of several the lowest one, as drawn, and of several such the rightmost.
///
/// Sides that differ by rounding are equally long. A line across a hollow is the first only where a part has no other side.
pub(crate) fn first_face(rests: &[Rest]) -> usize {
    let mut offered: Vec<usize> = (0..rests.len()).filter(|i| rests[*i].is_face()).collect();
    if offered.is_empty() {
        offered = (0..rests.len()).collect();
    }
    let long = |i: usize| (rests[i].to - rests[i].from).norm();
    let longest = offered.iter().map(|i| long(*i)).fold(0.0, f64::max);
    let slack = OUTLINE_ROUNDING * longest;
    let better = |i: usize, j: usize| {
        let [a, b] = [i, j].map(|i| (rests[i].from + rests[i].to) * 0.5);
        a.y < b.y - slack || (a.y < b.y + slack && a.x > b.x + slack)
    };
    let longs = offered.into_iter().filter(|i| long(*i) >= longest - slack);
    longs.reduce(|best, i| if better(i, best) { i } else { best }).unwrap_or(0)
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// What is said about a chain, in the size that the scene gives it.
struct Report<'c> {
    /// In the file's size.
    chain: &'c Chain,
    /// In the scene's.
    rests: &'c [Rest],
    scale: f64,
}

impl Report<'_> {
    fn arcs(&self) -> Option<String> {
        let arcs = self.chain.arcs;
        (arcs > 0).then(|| format!("{} kept as drawn", counted(arcs, "arc")))
    }

    /// What became of curves that are no arcs of circles, or of corners too many.
    fn chords(&self, chord: f64) -> Option<Approximation> {
        if self.chain.deviation <= 0.0 {
            return None;
        }
        let count = self.chain.points.len();
        let what = if self.chain.curves > 0 { "curves are chords" } else { "corners are left out" };
        let slow = if count > MANY {
            "; each chord that the part rolls over is a strike: a larger chord runs faster"
        } else {
            ""
        };
        let amount = self.chain.deviation * self.scale;
        let [off, allowed] = [amount, chord * self.scale].map(length);
        let text = format!("{what}, at most {off} off, as chord = {allowed} allows: {count} points{slow}");
        Some(Approximation { kind: ApproximationKind::Chords, of: "part", amount, unit: "m", text })
    }

    /// What each face of the part lies on, where some are no sides.
    fn faces(&self) -> Option<String> {
        let of = |kind: RestKind| -> Vec<usize> {
            (0..self.rests.len()).filter(|i| self.rests[*i].kind == kind).collect()
        };
        let kinds = [
            ("straight sides", of(RestKind::Face)),
            ("two points across hollows", of(RestKind::Across)),
            ("the lowest point of an arc", of(RestKind::Arc)),
        ];
        let (last, first) = (self.rests.len().checked_sub(1)?, self.rests.first()?);
        let [(_, sides), ..] = &kinds;
        if sides.len() == self.rests.len() {
            return None;
        }
        let some: Vec<_> = kinds.iter().filter(|(_, faces)| !faces.is_empty()).collect();
        if let ([(what, _)], 0) = (&some[..], last) {
            return Some(format!("it lies on {what} alone: its only face, 0"));
        }
        let lies: Vec<_> =
            some.iter().map(|(what, faces)| format!("on {what} on {}", joined(faces))).collect();
        let long = match first.kind {
            RestKind::Arc => String::new(),
            _ => format!("; face 0 is {} long", length((first.to - first.from).norm())),
        };
        Some(format!("of its faces 0 to {last} it lies {}{long}", lies.join(", ")))
    }
}

fn joined(faces: &[usize]) -> String {
    faces.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}
