//! What stands in the way of the part where it starts.

use crate::tolerance::OBSTACLES_TOUCH;
use carom_motion::planar::{Pose, Shape};
use carom_num::Vec2;
use carom_num::segment::properly_cross;

/// True where the segment cuts into a shape in this pose; touching is not crossing.
pub(crate) fn crosses(shape: &Shape, pose: Pose, from: Vec2, to: Vec2) -> bool {
    let slack = OBSTACLES_TOUCH * shape.size();
    let turn = Vec2::at_angle(pose.angle);
    let [from, to] = [from, to].map(|end| (end - pose.centre).rotated(turn.x, -turn.y));
    if let [a, b] = *shape.vertices()
        && shape.radius() == 0.0
    {
        return properly_cross((a, b), (from, to), slack);
    }
    // Between two cuts the segment is all inside or all outside.
    let mut places = vec![0.0];
    places.extend(shape.cuts(from, to));
    places.push(1.0);
    let at = |share: f64| from + (to - from) * share;
    places.windows(2).any(|ends| shape.depth_of(at(0.5 * (ends[0] + ends[1]))) > slack)
}
