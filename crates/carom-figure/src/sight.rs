//! What lies straight ahead of a point: the nearest place of a plate or wall in one direction.

use crate::outline::{Bend, sides};
use crate::tolerance::ROUNDING;
use carom_feeder::Feeder;
use carom_motion::planar::Shape;
use carom_num::Vec2;

/// The nearest point of an obstacle's outline from a point on, in a direction of length 1.
pub(crate) fn seen(feeder: &Feeder, obstacle: usize, from: Vec2, way: Vec2) -> Option<Vec2> {
    let obstacle = feeder.obstacle(obstacle).ok()??;
    nearest(obstacle.shape(), from, way).map(|distance| from + way * distance)
}

fn nearest(shape: &Shape, from: Vec2, way: Vec2) -> Option<f64> {
    let mut found: Vec<f64> = vec![];
    for side in sides(shape) {
        if side.has_length {
            found.extend(on_segment(side.from, side.to, from, way));
        }
        if let Some(Bend { centre, radius, normals: ends }) = side.arc {
            found.extend(on_circle(centre, radius, from, way).into_iter().filter(|distance| {
                let normal = (from + way * *distance - centre) / radius;
                let turns = radius.signum();
                turns * ends[0].cross(normal) >= -ROUNDING && turns * normal.cross(ends[1]) >= -ROUNDING
            }));
        }
    }
    found.into_iter().filter(|distance| *distance > 0.0).min_by(f64::total_cmp)
}

/// How far a segment is along a ray.
fn on_segment(a: Vec2, b: Vec2, from: Vec2, way: Vec2) -> Option<f64> {
    let (along, to) = (b - a, a - from);
    let across = way.cross(along);
    let share = to.cross(way) / across;
    let distance = to.cross(along) / across;
    ((0.0..=1.0).contains(&share) && distance.is_finite()).then_some(distance)
}

/// How far the two points of a circle are along a ray; none where it passes by.
fn on_circle(centre: Vec2, radius: f64, from: Vec2, way: Vec2) -> Vec<f64> {
    let to = centre - from;
    let (along, across) = (way.dot(to), way.cross(to));
    let half = radius * radius - across * across;
    if half < 0.0 { vec![] } else { [-1.0, 1.0].map(|sign| along + sign * half.sqrt()).to_vec() }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use carom_motion::planar::ChainPoint;
    use std::f64::consts::{FRAC_PI_2, PI};

    /// Rounding of sums of a few terms of size 1.
    const NEAR: f64 = 1e-14;

    fn at(x: f64, y: f64, sweep: f64) -> ChainPoint {
        ChainPoint { at: Vec2::new(x, y), sweep }
    }

    #[test]
    fn segments_and_arcs_are_seen_where_they_are() {
        let down = Vec2::new(0.0, -1.0);
        // A slope from (0, −1) to (2, −2), a bowl of 1 m below the origin, and a sheet with round ends about the x axis.
        let slope = Shape::of_open_chain(&[at(0.0, -1.0, 0.0), at(2.0, -2.0, 0.0)]).unwrap();
        let bowl = Shape::of_open_chain(&[at(-1.0, 0.0, PI), at(1.0, 0.0, 0.0)]).unwrap();
        let quarter = Shape::of_open_chain(&[at(-1.0, 0.0, FRAC_PI_2), at(0.0, -1.0, 0.0)]).unwrap();
        for (shape, x, expected, name) in [
            (&slope, 1.0, Some(1.5), "the middle of the slope"),
            (&slope, -0.1, None, "beside it"),
            (&bowl, 0.6, Some(0.8), "an arc that is hollow from there"),
            (&bowl, 1.1, None, "outside of the bowl"),
            (&quarter, -0.6, Some(0.8), "the quarter that is there"),
            (&quarter, 0.6, None, "the quarter that is not"),
        ] {
            let found = nearest(shape, Vec2::new(x, 0.0), down);
            let same = match (found, expected) {
                (Some(found), Some(expected)) => (found - expected).abs() < NEAR,
                (found, expected) => found == expected,
            };
            assert!(same, "{name}: {found:?}");
        }
        let above = nearest(&slope, Vec2::new(1.0, -3.0), down);
        assert_eq!(above, None, "what lies above is not ahead");
    }
}
