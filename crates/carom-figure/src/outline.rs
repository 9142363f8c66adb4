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
    /// What touches, where a file draws something else: the hull.
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
    let touches = hull(&feeder.part.body.shape, scale, &place);
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

pub(crate) fn hull(shape: &Shape, scale: f64, place: &impl Fn(Vec2) -> Vec2) -> String {
    let r = shape.radius();
    let at = |p: Vec2| {
        let q = place(p);
        format!("{} {}", px(q.x), px(q.y))
    };
    let arc = |to: Vec2| format!("A{0} {0} 0 0 0 {1}", px(r * scale), at(to));
    let vertices = shape.vertices();
    if let [centre] = vertices {
        let (a, b) = (*centre + Vec2::new(r, 0.0), *centre - Vec2::new(r, 0.0));
        return format!("M{}{}{}Z", at(a), arc(b), arc(a));
    }
    let mut d = String::new();
    for i in 0..shape.faces() {
        let (from, to) = shape.face(i);
        let n = shape.face_normal(i) * r;
        if i == 0 {
            d += &format!("M{}", at(from + n));
        } else if r > 0.0 {
            d += &arc(from + n);
        }
        d += &format!("L{}", at(to + n));
    }
    if r > 0.0 {
        let (from, _) = shape.face(0);
        d += &arc(from + shape.face_normal(0) * r);
    }
    d + "Z"
}

fn mark(feeder: &Feeder, scale: f64, place: &impl Fn(Vec2) -> Vec2) -> String {
    let shape = &feeder.part.body.shape;
    let (from, to) = if shape.faces() == 0 {
        (Vec2::ZERO, Vec2::new(shape.radius(), 0.0))
    } else {
        let (a, b) = shape.face(feeder.start.face);
        let off = if feeder.part.kind == PartKind::Rod { MARK_OFFSET / scale } else { 0.0 };
        let n = shape.face_normal(feeder.start.face) * (shape.radius() + off);
        (a + n, b + n)
    };
    let (a, b) = (place(from), place(to));
    format!("M{} {}L{} {}", px(a.x), px(a.y), px(b.x), px(b.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_motion::planar::Shape;

    #[test]
    fn a_rounded_square_has_four_arcs_and_a_disc_two() {
        let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let square = Shape::new(square.map(|(x, y)| Vec2::new(x, y)).to_vec(), 0.5).unwrap();
        assert_eq!(hull(&square, 1.0, &|p| p).matches('A').count(), 4, "corners");
        let disc = Shape::new(vec![Vec2::ZERO], 2.0).unwrap();
        assert_eq!(hull(&disc, 1.0, &|p| p), "M2 0A2 2 0 0 0 -2 0A2 2 0 0 0 2 0Z", "two halves");
    }
}
