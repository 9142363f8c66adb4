//! From an outline to a part: what the engine touches with, what it weighs, and what its author should know.

use super::FileOutline;
use super::drawn::length;
use super::edge::Edge;
use super::hull::{Hull, MANY};
use super::loops::Loop;
use super::moments::Moments;
use super::rounded::{Rounded, rounded};
use crate::approximation::{AS_DRAWN, Approximation, ApproximationKind};
use crate::tolerance::OUTLINE_ROUNDING;
use crate::unit::Dimension;
use carom_feeder::PartKind;
use carom_motion::planar::{MassProperties, Shape, ShapeProblem};
use carom_num::Vec2;

/// How far the chords of a picture may be from its curves, as a share of its size: below what a screen shows.
const SHOWN: f64 = 5e-4;

/// A part made of an outline.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Solid {
    pub(crate) kind: PartKind,
    /// The outline's convex hull about the mass centre.
    pub(crate) shape: Shape,
    /// Those of the outline itself, its holes left out.
    pub(crate) properties: MassProperties,
    /// The point of the file's plane, in the scene's size, about which the shape is given.
    pub(crate) origin: Vec2,
    pub(crate) notes: Vec<String>,
    /// How the shape differs from the outline.
    pub(crate) approximations: Vec<Approximation>,
}

impl FileOutline {
    /// The part, all lengths of the file times `scale`.
    ///
    /// # Errors
    /// What the engine finds wrong with the hull: a scale beyond measure.
    pub(crate) fn solid(&self, scale: f64) -> Result<Solid, Vec<ShapeProblem>> {
        let (outer, size) = (&self.nest.outer.edges, self.size);
        let about = outer.first().map_or(Vec2::ZERO, Edge::from);
        let filled = Moments::of(outer, about);
        let holes = self.nest.holes.iter().map(|hole| Moments::of(&hole.edges, about));
        let properties = holes.fold(filled, Moments::plus).properties(about);
        let hull = Hull::of(outer, size, self.chord);
        let kept = rounded(outer, &hull.curved, size, hull.within)
            .filter(|kept| kept.centres.len() > 1 || is_at(kept.centres[0], properties.centroid, size));
        let rounding = kept.as_ref().map_or(0.0, |kept| kept.radius);
        let centres = kept.as_ref().map_or(&hull.vertices, |kept| &kept.centres);
        // A part lies on its own sides: a line of the hull across a hollow is never face 0.
        let is_side = |i: usize| {
            hull.hollow <= hull.within || kept.is_none() && hull.curves[i].is_some() || {
                let (a, b) = (centres[i], centres[(i + 1) % centres.len()]);
                let out = (b - a).turned_right() * (rounding / (b - a).norm());
                is_drawn(outer, a + out, b + out, hull.within)
            }
        };
        let (kind, first) = match centres.len() {
            1 => (PartKind::Disc, 0),
            _ => (PartKind::Polygon, first_face(centres, rounding, is_side)),
        };
        let order: Vec<usize> = (first..first + centres.len()).map(|i| i % centres.len()).collect();
        let about = if kind == PartKind::Disc { centres[0] } else { properties.centroid };
        let vertices = order.iter().map(|i| (centres[*i] - about) * scale).collect();
        let shape = Shape::new(vertices, rounding * scale)?;
        let properties = MassProperties {
            area: properties.area * scale * scale,
            centroid: properties.centroid * scale,
            gyration_squared: properties.gyration_squared * scale * scale,
        };
        let filled = filled.area * scale * scale;
        let bridges: Vec<usize> =
            if kind == PartKind::Disc { vec![] } else { positions(&order, |i| !is_side(i)) };
        let chords = if kept.is_some() { vec![] } else { positions(&order, |i| hull.curves[i].is_some()) };
        let report = Report { hull: &hull, kept: kept.as_ref(), shape: &shape, scale, bridges, chords };
        let mut notes = vec![self.reading()];
        notes.extend(report.convex(filled));
        notes.extend(report.arcs_kept());
        let chords = report.cut(self.chord);
        notes.extend(chords.iter().map(|chords| chords.text.clone()));
        notes.extend(report.faces());
        let approximations = report.filling(filled).into_iter().chain(chords).collect();
        Ok(Solid { kind, shape, properties, origin: about * scale, notes, approximations })
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

fn is_at(centre: Vec2, mass_centre: Vec2, size: f64) -> bool {
    (centre - mass_centre).norm() <= OUTLINE_ROUNDING * size
}

/// Where in `order` those stand that `holds` is true of.
fn positions(order: &[usize], holds: impl Fn(usize) -> bool) -> Vec<usize> {
    (0..order.len()).filter(|position| holds(order[*position])).collect()
}

/// True where an edge of the outline lies on the line from `a` to `b`, within `within`: the line is a side, perhaps with hollows in it.
fn is_drawn(edges: &[Edge], a: Vec2, b: Vec2, within: f64) -> bool {
    let along = (b - a) * (1.0 / (b - a).norm());
    let on_line = |point: Vec2| along.cross(point - a).abs() <= within;
    edges.iter().any(|edge| {
        (edge.to() - edge.from()).norm() > within && (0..=4).all(|i| on_line(edge.point(f64::from(i) / 4.0)))
    })
}

/// The longest face of corners rounded by a radius; of several the lowest one, as drawn, and of several such the rightmost.
///
/// Faces that differ by rounding are equally long. Where some faces are sides of the part, only these count.
pub(crate) fn first_face(corners: &[Vec2], radius: f64, is_side: impl Fn(usize) -> bool) -> usize {
    let k = corners.len();
    let mut offered: Vec<usize> = (0..k).filter(|i| is_side(*i)).collect();
    if offered.is_empty() {
        offered = (0..k).collect();
    }
    let run = |i: usize| corners[(i + 1) % k] - corners[i];
    let longest = offered.iter().map(|i| run(*i).norm()).fold(0.0, f64::max);
    let slack = OUTLINE_ROUNDING * longest;
    let middle = |i: usize| corners[i] + run(i) * 0.5 + run(i).turned_right() * (radius / longest);
    let better = |i: usize, j: usize| {
        let (a, b) = (middle(i), middle(j));
        a.y < b.y - slack || (a.y < b.y + slack && a.x > b.x + slack)
    };
    let long = offered.into_iter().filter(|i| run(*i).norm() >= longest - slack);
    long.reduce(|best, i| if better(i, best) { i } else { best }).unwrap_or(0)
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// What is said about a hull, in the size that the scene gives it.
struct Report<'h> {
    /// In the file's size.
    hull: &'h Hull,
    kept: Option<&'h Rounded>,
    /// In the scene's.
    shape: &'h Shape,
    scale: f64,
    /// Faces that are lines across hollows, and faces that are chords of curves, as the part numbers them.
    bridges: Vec<usize>,
    chords: Vec<usize>,
}

impl Report<'_> {
    fn is_hollow(&self) -> bool {
        self.hull.hollow > self.hull.within
    }

    /// By how much the hull's area differs from the area within the outline, as a share of that.
    fn difference(&self, area: f64) -> f64 {
        (MassProperties::of(self.shape).area - area).abs() / area
    }

    /// What the hull adds to an outline with hollows.
    fn filling(&self, area: f64) -> Option<Approximation> {
        if !self.is_hollow() {
            return None;
        }
        let amount = self.difference(area);
        let depth = Dimension::Length.show_digits(self.hull.hollow * self.scale, 3);
        let share = Dimension::Number.show_digits(100.0 * amount, 3);
        let lines = match &self.bridges[..] {
            [] => String::new(),
            [one] => format!("; face {one} is a line across a hollow and no side of the part"),
            several => {
                format!("; faces {} are lines across hollows and no sides of the part", joined(several))
            }
        };
        let text = format!(
            "the part touches with its convex hull, which adds {share} % to the area within the outline and fills hollows up to {depth} deep{lines}; {AS_DRAWN}"
        );
        let kind = ApproximationKind::ConvexHull;
        Some(Approximation { kind, of: "part", amount, unit: "1", faces: self.bridges.clone(), text })
    }

    /// How near the hull of an outline without hollows is to it.
    fn convex(&self, area: f64) -> Option<String> {
        if self.is_hollow() {
            return None;
        }
        if self.kept.is_some() || self.hull.deviation == 0.0 {
            return Some("the part is convex: its hull adds nothing to its outline".to_owned());
        }
        let share = Dimension::Number.show_digits(100.0 * self.difference(area), 3);
        let faces = self.shape.faces();
        Some(format!(
            "the part is convex; its hull of {faces} straight faces leaves out {share} % of the area within its outline"
        ))
    }

    fn arcs_kept(&self) -> Option<String> {
        let kept = self.kept?;
        let what = match kept.centres.len() {
            1 => "the part is a disc".to_owned(),
            k => format!("{k} corners are round"),
        };
        Some(format!("arcs kept: {what}, radius {}", length(self.shape.radius())))
    }

    /// What became of the hull's curves, or of corners too many.
    fn cut(&self, chord: f64) -> Option<Approximation> {
        if self.kept.is_some() || self.hull.deviation <= 0.0 {
            return None;
        }
        let count = self.hull.vertices.len();
        let what = match self.hull.curved[..] {
            [] => "corners of the hull are left out",
            _ => "curves of the hull are chords",
        };
        let slow = match count {
            0..=MANY => "",
            _ => "; each chord that the part rolls over is a strike: a larger chord runs faster",
        };
        let amount = self.hull.deviation * self.scale;
        let [off, allowed] = [amount, chord * self.scale].map(length);
        let text = format!("{what}, at most {off} off, as chord = {allowed} allows: {count} vertices{slow}");
        let kind = ApproximationKind::Chords;
        Some(Approximation { kind, of: "part", amount, unit: "m", faces: self.chords.clone(), text })
    }

    /// Which faces are straight sides, where others are not.
    fn faces(&self) -> Option<String> {
        let k = self.shape.faces();
        if k == 0 || self.chords.is_empty() && self.bridges.is_empty() {
            return None;
        }
        let straight: Vec<usize> =
            (0..k).filter(|i| !self.chords.contains(i) && !self.bridges.contains(i)).collect();
        let (a, b) = self.shape.face(0);
        let long = length((b - a).norm());
        Some(if straight.is_empty() {
            format!("no face is a straight side; face 0, the longest, is {long} long")
        } else {
            let (last, straight) = (k - 1, joined(&straight));
            format!(
                "of faces 0 to {last}, straight sides are {straight}; face 0, the longest of them, is {long} long"
            )
        })
    }
}

fn joined(faces: &[usize]) -> String {
    faces.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}
