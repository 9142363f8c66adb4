//! What stands in the way of the part where it starts.

use crate::tolerance::OBSTACLES_TOUCH;
use carom_motion::planar::{Pose, Shape};
use carom_num::Vec2;
use carom_num::segment::properly_cross;

/// True where the segment cuts into a shape in this pose; touching is not crossing.
pub(crate) fn crosses(shape: &Shape, pose: Pose, from: Vec2, to: Vec2) -> bool {
    let slack = OBSTACLES_TOUCH * shape.size();
    let direction = Vec2::at_angle(pose.angle);
    let placed: Vec<Vec2> =
        shape.vertices().iter().map(|v| pose.centre + v.rotated(direction.x, direction.y)).collect();
    match placed[..] {
        [centre] => distance_to_segment(centre, from, to) < shape.radius() - slack,
        [a, b] if shape.radius() == 0.0 => properly_cross((a, b), (from, to), slack),
        _ => {
            let near = |i: usize| {
                let (a, b) = (placed[i], placed[(i + 1) % placed.len()]);
                segment_distance(a, b, from, to) < shape.radius() - slack
            };
            (0..placed.len()).any(near) || (placed.len() > 2 && cuts_hull(&placed, from, to, slack))
        }
    }
}

/// Clips the segment to the hull drawn `slack` smaller.
fn cuts_hull(hull: &[Vec2], from: Vec2, to: Vec2, slack: f64) -> bool {
    let (mut start, mut end) = (0.0f64, 1.0f64);
    for (i, a) in hull.iter().enumerate() {
        let edge = hull[(i + 1) % hull.len()] - *a;
        let outward = edge.turned_right() / edge.norm();
        let (out_from, out_to) = (outward.dot(from - *a) + slack, outward.dot(to - *a) + slack);
        if out_from >= 0.0 && out_to >= 0.0 {
            return false;
        }
        let at = out_from / (out_from - out_to);
        if out_from >= 0.0 {
            start = start.max(at);
        } else if out_to > 0.0 {
            end = end.min(at);
        }
    }
    start < end
}

fn distance_to_segment(point: Vec2, from: Vec2, to: Vec2) -> f64 {
    let run = to - from;
    let at = ((point - from).dot(run) / run.dot(run)).clamp(0.0, 1.0);
    (point - (from + run * at)).norm()
}

fn segment_distance(a: Vec2, b: Vec2, from: Vec2, to: Vec2) -> f64 {
    if properly_cross((a, b), (from, to), 0.0) {
        return 0.0;
    }
    let ends = [
        distance_to_segment(a, from, to),
        distance_to_segment(b, from, to),
        distance_to_segment(from, a, b),
        distance_to_segment(to, a, b),
    ];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}
