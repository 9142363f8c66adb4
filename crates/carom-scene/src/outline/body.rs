//! From an outline to a part: what the engine touches with, what it weighs, and what its author should know.

use super::FileOutline;
use super::drawn::length;
use super::edge::Edge;
use super::hull::{Hull, MANY};
use super::loops::ROUNDING;
use super::moments::Moments;
use super::rounded::{Rounded, rounded};
use crate::unit::Dimension;
use carom_feeder::PartKind;
use carom_motion::planar::{MassProperties, Shape, ShapeProblem};
use carom_num::Vec2;

/// A part made of an outline.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Solid {
    pub(crate) kind: PartKind,
    /// The outline's convex hull about the mass centre.
    pub(crate) shape: Shape,
    /// Those of the outline itself, its holes left out.
    pub(crate) properties: MassProperties,
    pub(crate) notes: Vec<String>,
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
        let (kind, vertices, radius) = corners(&hull, kept.as_ref(), properties.centroid);
        let shape = Shape::new(vertices.iter().map(|vertex| *vertex * scale).collect(), radius * scale)?;
        let properties = MassProperties {
            area: properties.area * scale * scale,
            centroid: properties.centroid * scale,
            gyration_squared: properties.gyration_squared * scale * scale,
        };
        let filled = filled.area * scale * scale;
        let report = Report { hull: &hull, kept: kept.as_ref(), shape: &shape, scale };
        let mut notes = vec![self.reading(), report.filling(filled)];
        notes.extend(report.kept_or_cut(self.chord));
        notes.extend(report.faces());
        Ok(Solid { kind, shape, properties, notes })
    }

    fn reading(&self) -> String {
        // Gaps of rounding are closed by lines that nobody drew.
        let rounding = ROUNDING * self.size;
        let long = |edge: &&Edge| (edge.to() - edge.from()).norm() > rounding || !edge.is_straight();
        let edges = counted(self.nest.outer.edges.iter().filter(long).count(), "edge");
        let holes = counted(self.nest.holes.len(), "hole");
        format!("part.file: {}, {edges}, {holes}; {}", self.file, self.said)
    }
}

fn is_at(centre: Vec2, mass_centre: Vec2, size: f64) -> bool {
    (centre - mass_centre).norm() <= ROUNDING * size
}

/// The hull about the mass centre, face 0 first, and the radius that rounds it.
fn corners(hull: &Hull, kept: Option<&Rounded>, about: Vec2) -> (PartKind, Vec<Vec2>, f64) {
    let (corners, radius) = kept.map_or((&hull.vertices, 0.0), |kept| (&kept.centres, kept.radius));
    if corners.len() == 1 {
        return (PartKind::Disc, vec![Vec2::ZERO], radius);
    }
    let first = first_face(corners, radius);
    let k = corners.len();
    (PartKind::Polygon, (first..first + k).map(|i| corners[i % k] - about).collect(), radius)
}

/// The longest face of corners rounded by a radius; of several the lowest one, as drawn, and of several such the rightmost.
///
/// Faces that differ by rounding are equally long.
pub(crate) fn first_face(corners: &[Vec2], radius: f64) -> usize {
    let k = corners.len();
    let run = |i: usize| corners[(i + 1) % k] - corners[i];
    let longest = (0..k).map(|i| run(i).norm()).fold(0.0, f64::max);
    let slack = ROUNDING * longest;
    let middle = |i: usize| corners[i] + run(i) * 0.5 + run(i).turned_right() * (radius / longest);
    let better = |i: usize, j: usize| {
        let (a, b) = (middle(i), middle(j));
        a.y < b.y - slack || (a.y < b.y + slack && a.x > b.x + slack)
    };
    let long = (0..k).filter(|i| run(*i).norm() >= longest - slack);
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
}

impl Report<'_> {
    /// What the hull adds to the area within the outline.
    fn filling(&self, area: f64) -> String {
        let hull_area = MassProperties::of(self.shape).area;
        let share = Dimension::Number.show_digits(100.0 * (hull_area - area).abs() / area, 3);
        if self.hull.hollow > self.hull.within {
            return format!(
                "the part touches with its convex hull, which adds {share} % to the area within the outline and fills hollows up to {} deep; mass, mass centre and inertia are the outline's own, its holes left out",
                Dimension::Length.show_digits(self.hull.hollow * self.scale, 3)
            );
        }
        if self.kept.is_some() || self.hull.deviation == 0.0 {
            return "the part is convex: its hull adds nothing to its outline".to_owned();
        }
        let faces = self.shape.faces();
        format!(
            "the part is convex; its hull of {faces} straight faces leaves out {share} % of the area within its outline"
        )
    }

    /// What became of the hull's curves, or of corners too many.
    fn kept_or_cut(&self, chord: f64) -> Option<String> {
        if let Some(kept) = self.kept {
            let what = match kept.centres.len() {
                1 => "the part is a disc".to_owned(),
                k => format!("{k} corners are round"),
            };
            return Some(format!("arcs kept: {what}, radius {}", length(self.shape.radius())));
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
        let [off, allowed] = [self.hull.deviation, chord].map(|value| length(value * self.scale));
        (self.hull.deviation > 0.0).then(|| {
            format!("{what}, at most {off} off, as chord = {allowed} allows: {count} vertices{slow}")
        })
    }

    /// Which faces are straight sides, where others are chords.
    fn faces(&self) -> Option<String> {
        let (hull, k) = (self.hull, self.hull.vertices.len());
        if self.kept.is_some() || hull.curved.is_empty() {
            return None;
        }
        let first = first_face(&hull.vertices, 0.0);
        let straight = (0..k).filter(|i| hull.curves[(first + i) % k].is_none());
        let straight: Vec<String> = straight.map(|i| i.to_string()).collect();
        let (a, b) = self.shape.face(0);
        let longest = length((b - a).norm());
        Some(if straight.is_empty() {
            format!("no face is a straight side; face 0, the longest, is {longest} long")
        } else {
            format!(
                "of faces 0 to {}, straight sides are {}; face 0, the longest, is {longest} long",
                k - 1,
                straight.join(", ")
            )
        })
    }
}
