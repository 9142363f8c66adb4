//! A flat part on an edge, followed by its equations of motion.

use carom_motion::planar::Pose;
use carom_num::Vec2;
use carom_num::elementary::{cos, sin};
use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};

/// Steps of order 4: over times of 0.1 s they leave 1e-13 of what is compared.
const STEPS: u32 = 2000;

/// The state after a time [s], by the classical method of order 4; with friction the slip keeps its direction.
pub(crate) fn follow(part: &PartOnEdge, start: EdgeState, time: f64) -> EdgeState {
    let forward = start.slip >= 0.0;
    let rates = |s: &EdgeState| {
        // Where the slip has only begun a stage may mistake its direction by rounding, and friction with it.
        let slip = match forward {
            _ if part.friction == 0.0 => s.slip,
            true => s.slip.max(f64::MIN_POSITIVE),
            false => s.slip.min(-f64::MIN_POSITIVE),
        };
        let motion = part.motion(&EdgeState { slip, ..*s });
        [s.slip, s.tilt_rate, motion.slip_rate, motion.tilt_acceleration]
    };
    let after = |s: &EdgeState, of: [f64; 4], t: f64| EdgeState {
        reach: s.reach + t * of[0],
        tilt: s.tilt + t * of[1],
        slip: s.slip + t * of[2],
        tilt_rate: s.tilt_rate + t * of[3],
    };
    let step = time / f64::from(STEPS);
    (0..STEPS).fold(start, |s, _| {
        let first = rates(&s);
        let second = rates(&after(&s, first, 0.5 * step));
        let third = rates(&after(&s, second, 0.5 * step));
        let fourth = rates(&after(&s, third, step));
        let mean = |i: usize| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0;
        after(&s, std::array::from_fn(mean), step)
    })
}

/// Where a part is whose edge is at the origin of a level plate, its lower face being level in its drawing: x to the right, or to the left where
/// it is `mirrored`.
pub(crate) fn pose(part: &PartOnEdge, state: &EdgeState, mirrored: bool) -> Pose {
    let side = if mirrored { -1.0 } else { 1.0 };
    let (sin, cos) = (sin(state.tilt), cos(state.tilt));
    let centre = Vec2::new(side * cos, -sin) * state.reach + Vec2::new(side * sin, cos) * part.half_thickness;
    Pose { centre, angle: -side * state.tilt }
}
