//! From a part of the library to a body: its outline about its mass centre, its kind, its first face.

use super::{LibraryPart, Made};
use crate::chain::{corners_of, crosses_itself};
use crate::outline::{Solid, first_face, starting_point};
use crate::problem::{Problem, ProblemKind};
use crate::tolerance::OUTLINE_ROUNDING;
use carom_feeder::PartKind;
use carom_motion::planar::{ChainPoint, MassProperties, Rest, Shape, ShapeProblem};
use carom_num::Vec2;
use std::ops::Range;

impl LibraryPart {
    /// The part; its shape stands at `span` in the file.
    pub(crate) fn solid(&self, span: &Range<usize>) -> Result<Solid, Vec<Problem>> {
        let Made { outline, axial, zero, notes, .. } = self.make()?;
        let problems = |found: Vec<ShapeProblem>| {
            let told = |found: &ShapeProblem| {
                Problem::new(ProblemKind::Geometry, "part", found.to_string(), Some(span.clone()))
            };
            found.iter().map(told).collect::<Vec<_>>()
        };
        let wrong = |message: &str| {
            Err(vec![Problem::new(ProblemKind::Geometry, "part", message, Some(span.clone()))])
        };
        if axial.is_some_and(|axial| axial.volume <= 0.0) {
            return wrong("has no volume");
        }
        if crosses_itself(&corners_of(&outline)) {
            return Err(problems(vec![ShapeProblem::Crosses]));
        }
        let drawn = Shape::of_chain(&outline).map_err(problems)?;
        let properties = match &axial {
            None => MassProperties::of(&drawn),
            Some(axial) => MassProperties {
                area: 0.0,
                centroid: Vec2::new(zero + axial.centre(), 0.0),
                gyration_squared: axial.gyration_squared(),
            },
        };
        let origin = properties.centroid;
        let mut points: Vec<ChainPoint> =
            outline.iter().map(|p| ChainPoint { at: p.at - origin, ..*p }).collect();
        let mut shape = Shape::of_chain(&points).map_err(problems)?;
        let kind = kind_of(&shape);
        if shape.faces() == 0 && kind != PartKind::Disc {
            return wrong("a ball whose mass centre is not its middle has no side to start on");
        }
        if kind == PartKind::Disc {
            shape = Shape::new(vec![Vec2::ZERO], shape.radius()).map_err(problems)?;
        } else {
            // A flat part starts on a side, as one from a file does; a body of revolution on whatever it lies longest on.
            let chosen = if axial.is_some() { longest } else { first_face };
            let first = starting_point(&points, &shape, chosen);
            points.rotate_left(first);
            shape = Shape::of_chain(&points).map_err(problems)?;
        }
        let volume = axial.map(|axial| axial.volume);
        Ok(Solid { kind, shape, properties, origin, notes, volume, approximations: vec![] })
    }
}

impl LibraryPart {
    /// For pictures of a part that is hollow: its outline and its hollow, as closed chains of points about `origin`.
    pub(crate) fn loops(&self, origin: Vec2) -> Vec<Vec<Vec2>> {
        let Ok(Made { outline, hollow, .. }) = self.make() else { return vec![] };
        if hollow.is_empty() {
            return vec![];
        }
        [outline, hollow].map(|chain| corners_of(&chain).into_iter().map(|p| p - origin).collect()).into()
    }
}

/// A ball is a disc in the plane, and what has four sides like a box is called a box.
fn kind_of(shape: &Shape) -> PartKind {
    if shape.faces() == 0 {
        let off = shape.vertices()[0].norm();
        return if off <= OUTLINE_ROUNDING * shape.size() { PartKind::Disc } else { PartKind::Polygon };
    }
    let rests = shape.rests();
    let is_box = shape.faces() == 4 && rests.len() == 4 && rests.iter().all(Rest::is_face);
    if is_box { PartKind::Box } else { PartKind::Polygon }
}

/// The longest side or line across a hollow on which it stays; of several the lowest as drawn.
fn longest(rests: &[Rest]) -> usize {
    let stays = |rest: &Rest| rest.inside().iter().all(|inside| *inside > 0.0);
    let long = |rest: &Rest| if stays(rest) { (rest.to - rest.from).norm() } else { 0.0 };
    let most = rests.iter().map(long).fold(0.0, f64::max);
    let longs = (0..rests.len()).filter(|i| long(&rests[*i]) >= most * (1.0 - OUTLINE_ROUNDING));
    let low = |i: &usize| rests[*i].from.y + rests[*i].to.y;
    longs.min_by(|i, j| low(i).total_cmp(&low(j))).unwrap_or(0)
}
