//! The part's outline as SVG paths: what its file draws, and what touches.

use crate::draft::Draft;
use crate::markup::{Markup, html};
use crate::svg;
use crate::text::px;
use crate::view::View;
use carom_feeder::{Feeder, PartKind};
use carom_motion::planar::{Pose, Shape};
use carom_num::Vec2;

/// The body's outline and the mark on the face that was down at the start, as path data on paper.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Outline {
    /// Closed outline (a line for a thin rod), with the holes of what a file draws.
    body: String,
    /// What touches, where a file draws its own outline.
    hull: String,
    /// The marked face; the spoke of a disc.
    mark: String,
}

impl Outline {
    /// Its paths as SVG.
    pub(crate) fn svg(&self) -> Markup {
        let Self { body, hull, mark } = self;
        html! {
            (svg::path("body", body))
            @if !hull.is_empty() { (svg::path("hull", hull)) }
            (svg::path("mark", mark))
        }
    }
}

/// Pixels that the mark stands off a thin rod's line, so that its side can be told.
const MARK_OFFSET: f64 = 2.6;

/// The outline at a pose, in the view's pixels.
pub(crate) fn outline(feeder: &Feeder, draft: &Draft, pose: Pose, view: &View) -> Outline {
    let turn = Vec2::at_angle(pose.angle);
    let place = |p: Vec2| view.at(pose.centre + p.rotated(turn.x, turn.y));
    draw(feeder, draft, view.scale, place)
}

/// The outline at angle zero about the paper's origin: what the player moves.
pub(crate) fn outline_at_rest(feeder: &Feeder, draft: &Draft, view: &View) -> Outline {
    draw(feeder, draft, view.scale, |p| view.along(p))
}

fn draw(feeder: &Feeder, draft: &Draft, scale: f64, place: impl Fn(Vec2) -> Vec2) -> Outline {
    let touches = path(&feeder.part.body.shape, scale, &place);
    let mark = mark(feeder, scale, &place);
    if draft.outline.is_empty() {
        return Outline { body: touches, hull: String::new(), mark };
    }
    let body: String = draft.outline.iter().map(|chain| closed(chain, &place)).collect();
    Outline { body, hull: touches, mark }
}

/// A closed chain of points.
fn closed(chain: &[Vec2], place: &impl Fn(Vec2) -> Vec2) -> String {
    let mut data = String::new();
    chain.iter().for_each(|point| svg::to(&mut data, svg::xy(place(*point))));
    data + "Z"
}

/// What touches, as path data: the arcs and segments of a shape.
pub(crate) fn path(shape: &Shape, scale: f64, place: &impl Fn(Vec2) -> Vec2) -> String {
    let at = |p: Vec2| {
        let q = place(p);
        format!("{} {}", px(q.x), px(q.y))
    };
    // Counter-clockwise in the world is against the clock on paper.
    let arc = |radius: f64, to: Vec2| {
        format!("A{0} {0} 0 0 {1} {2}", px(radius.abs() * scale), u8::from(radius < 0.0), at(to))
    };
    if shape.faces() == 0 {
        let (centre, r) = (shape.vertices()[0], shape.radius_of(0));
        let (a, b) = (centre + Vec2::new(r, 0.0), centre - Vec2::new(r, 0.0));
        return format!("M{}{}{}Z", at(a), arc(r, b), arc(r, a));
    }
    let mut d = String::new();
    for side in sides(shape) {
        if d.is_empty() {
            d += &format!("M{}", at(side.from));
        }
        if side.has_length {
            d += &format!("L{}", at(side.to));
        }
        if let Some(bend) = side.arc {
            d += &arc(bend.radius, bend.centre + bend.normals[1] * bend.radius);
        }
    }
    d + "Z"
}

/// A face of a shape as it is drawn, and the arc that follows it.
pub(crate) struct Side {
    /// Where the face meets the arcs at its two ends.
    pub(crate) from: Vec2,
    pub(crate) to: Vec2,
    /// False where one arc goes on in another.
    pub(crate) has_length: bool,
    /// None at a corner.
    pub(crate) arc: Option<Bend>,
}

/// An arc of a shape's outline.
pub(crate) struct Bend {
    pub(crate) centre: Vec2,
    /// Negative about a hollow.
    pub(crate) radius: f64,
    /// Normals out of the shape at its two ends.
    pub(crate) normals: [Vec2; 2],
}

/// The outline of a shape, counter-clockwise; nothing of a circle, which has no face.
pub(crate) fn sides(shape: &Shape) -> impl Iterator<Item = Side> {
    let (count, vertices) = (shape.faces(), shape.vertices());
    // Where the arc about a vertex meets a face.
    let joint =
        |vertex: usize, face: usize| vertices[vertex] + shape.face_normal(face) * shape.radius_of(vertex);
    (0..count).map(move |face| {
        let next = (face + 1) % count;
        let (centre, radius) = (vertices[next], shape.radius_of(next));
        let normals = [shape.face_normal(face), shape.face_normal(next)];
        Side {
            from: joint(face, face),
            to: joint(next, face),
            has_length: shape.face_length(face) > 0.0,
            arc: (radius != 0.0).then_some(Bend { centre, radius, normals }),
        }
    })
}

fn mark(feeder: &Feeder, scale: f64, place: &impl Fn(Vec2) -> Vec2) -> String {
    let shape = &feeder.part.body.shape;
    let (from, to) = if shape.faces() == 0 {
        // A spoke: from the middle, which of a cam is not the mass centre.
        let middle = shape.vertices()[0];
        (middle, middle + Vec2::new(shape.radius_of(0), 0.0))
    } else {
        let rest = shape.rests()[feeder.start.face];
        let off = if feeder.part.kind == PartKind::Rod { MARK_OFFSET / scale } else { 0.0 };
        (rest.from + rest.normal * off, rest.to + rest.normal * off)
    };
    let (a, b) = (place(from), place(to));
    format!("M{} {}L{} {}", px(a.x), px(a.y), px(b.x), px(b.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_motion::planar::Shape;

    #[test]
    fn a_hollow_turns_the_other_way() {
        use carom_motion::planar::ChainPoint;
        let at = |x: f64, y: f64| ChainPoint::straight(Vec2::new(x, y));
        let bite = ChainPoint { sweep: -std::f64::consts::PI, ..at(1.0, 2.0) };
        let bitten =
            Shape::of_chain(&[at(-2.0, 0.0), at(2.0, 0.0), at(2.0, 2.0), bite, at(-1.0, 2.0), at(-2.0, 2.0)]);
        let data = path(&bitten.unwrap(), 1.0, &|p| Vec2::new(p.x, -p.y));
        assert!(data.contains("L1 -2A1 1 0 0 1 -1 -2"), "{data}");
    }

    #[test]
    fn a_rounded_square_has_four_arcs_and_a_disc_two() {
        let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let square = Shape::new(square.map(|(x, y)| Vec2::new(x, y)).to_vec(), 0.5).unwrap();
        assert_eq!(path(&square, 1.0, &|p| p).matches('A').count(), 4, "corners");
        let disc = Shape::new(vec![Vec2::ZERO], 2.0).unwrap();
        assert_eq!(path(&disc, 1.0, &|p| p), "M2 0A2 2 0 0 0 -2 0A2 2 0 0 0 2 0Z", "two halves");
    }
}
