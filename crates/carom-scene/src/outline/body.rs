//! From an outline to a part: what the engine touches with, what it weighs, and what its author should know.

use super::drawn::length;
use super::edge::{Edge, Placement};
use super::hull::{Hull, MANY};
use super::loops::{Loop, ROUNDING};
use super::moments::Moments;
use super::rounded::{Rounded, rounded};
use super::{CHORD, FileOutline};
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
    /// The part, all lengths of the file times `scale`; `chord` is how far chords may be from curves [m].
    ///
    /// # Errors
    /// What the engine finds wrong with the hull.
    pub(crate) fn solid(&self, scale: f64, chord: Option<f64>) -> Result<Solid, Vec<ShapeProblem>> {
        let by = Placement::scaled(scale, scale);
        let placed = |drawn: &Loop| drawn.edges.iter().map(|edge| edge.placed(by)).collect::<Vec<Edge>>();
        let outer = placed(&self.nest.outer);
        let holes: Vec<Vec<Edge>> = self.nest.holes.iter().map(placed).collect();
        let size = self.size * scale;
        let chord = chord.unwrap_or(CHORD * size);
        let about = outer.first().map_or(Vec2::ZERO, Edge::from);
        let filled = Moments::of(&outer, about);
        let moments = holes.iter().fold(filled, |sum, hole| sum.plus(Moments::of(hole, about)));
        let properties = moments.properties(about);
        let hull = Hull::of(&outer, size, chord);
        let kept = rounded(&outer, &hull.curved, size, hull.within)
            .filter(|kept| kept.centres.len() > 1 || is_at(kept.centres[0], properties.centroid, size));
        let (kind, shape) = shape(&hull, kept.as_ref(), properties.centroid)?;
        // Gaps of rounding are closed by lines that nobody drew.
        let long = |edge: &&Edge| (edge.to() - edge.from()).norm() > ROUNDING * size || !edge.is_straight();
        let (edges, holes) =
            (counted(outer.iter().filter(long).count(), "edge"), counted(holes.len(), "hole"));
        let mut notes = vec![format!("part.file: {}, {edges}, {holes}; {}", self.file, self.said)];
        notes.push(filling(&hull, kept.as_ref().map(|_| &shape), filled.area));
        notes.extend(kept_or_cut(&hull, kept.as_ref(), chord));
        notes.extend(faces(&hull, &shape, kept.is_none()));
        Ok(Solid { kind, shape, properties, notes })
    }
}

fn is_at(centre: Vec2, mass_centre: Vec2, size: f64) -> bool {
    (centre - mass_centre).norm() <= ROUNDING * size
}

/// The hull about the mass centre, face 0 first.
fn shape(hull: &Hull, kept: Option<&Rounded>, about: Vec2) -> Result<(PartKind, Shape), Vec<ShapeProblem>> {
    let (corners, radius) = kept.map_or((&hull.vertices, 0.0), |kept| (&kept.centres, kept.radius));
    if corners.len() == 1 {
        return Ok((PartKind::Disc, Shape::new(vec![Vec2::ZERO], radius)?));
    }
    let first = first_face(corners, radius);
    let k = corners.len();
    let vertices = (first..first + k).map(|i| corners[i % k] - about).collect();
    Ok((PartKind::Polygon, Shape::new(vertices, radius)?))
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

/// What the hull adds to the outline.
fn filling(hull: &Hull, kept: Option<&Shape>, area: f64) -> String {
    let hull_area = kept.map_or_else(|| hull.area(), |shape| MassProperties::of(shape).area);
    let share = Dimension::Number.show_digits(100.0 * (hull_area - area).abs() / area, 3);
    if hull.hollow <= hull.within {
        return if kept.is_some() || hull.deviation == 0.0 {
            "the part is convex: its hull adds nothing to its outline".to_owned()
        } else {
            let faces = hull.vertices.len();
            format!(
                "the part is convex; its hull of {faces} straight faces leaves out {share} % of the area within its outline"
            )
        };
    }
    format!(
        "the part touches with its convex hull, which adds {share} % to the area within the outline and fills hollows up to {} deep; mass, mass centre and inertia are the outline's own, its holes left out",
        Dimension::Length.show_digits(hull.hollow, 3)
    )
}

/// What became of the hull's curves, or of corners too many.
fn kept_or_cut(hull: &Hull, kept: Option<&Rounded>, chord: f64) -> Option<String> {
    if let Some(kept) = kept {
        let what = match kept.centres.len() {
            1 => "the part is a disc".to_owned(),
            k => format!("{k} corners are round"),
        };
        return Some(format!("arcs kept: {what}, radius {}", length(kept.radius)));
    }
    let count = hull.vertices.len();
    let what = if hull.curved.is_empty() {
        "corners of the hull are left out"
    } else {
        "curves of the hull are chords"
    };
    let slow = if count > MANY {
        "; each chord that the part rolls over is a strike: a larger chord runs faster"
    } else {
        ""
    };
    (hull.deviation > 0.0).then(|| {
        format!(
            "{what}, at most {} off, as chord = {} allows: {count} vertices{slow}",
            length(hull.deviation),
            length(chord)
        )
    })
}

/// Which faces are straight sides, where others are chords.
fn faces(hull: &Hull, shape: &Shape, cut: bool) -> Option<String> {
    let k = hull.vertices.len();
    if !cut || hull.curved.is_empty() {
        return None;
    }
    let first = first_face(&hull.vertices, 0.0);
    let straight: Vec<String> =
        (0..k).filter(|i| hull.curves[(first + i) % k].is_none()).map(|i| i.to_string()).collect();
    let (a, b) = shape.face(0);
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
