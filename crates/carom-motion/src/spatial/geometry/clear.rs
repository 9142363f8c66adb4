//! What is certain not to touch for some time, told by a look at one instant: most of what a body and an obstacle have.

use super::crossing::Crossing;
use super::nearest::Nearest;
use super::pair::Pair;
use super::posture::{Height, Most, Moving};
use super::state::State;
use super::world::{Support, World};
use crate::tolerance::{CLEAR_OF_ROUNDING, FAR};
use carom_num::segment::distance;
use carom_num::{Mat3, Vec3};

/// Edges and corners that are farther apart than this, in units of the reach, are far.
const NEAR_PAIR: f64 = 0.05;

/// How a body stands and moves at an instant, and what its motion does not exceed for some time.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Outlook {
    centre: Vec3,
    turn: Mat3,
    velocity: Vec3,
    /// World axes.
    spin: Vec3,
    most: Most,
    /// For how long \[s\].
    time: f64,
}

impl Outlook {
    pub(in crate::spatial) fn of(moving: &Moving, most: Most, time: f64) -> Self {
        let state = moving.state;
        let turn = state.attitude.matrix();
        Self { centre: state.centre, turn, velocity: state.velocity, spin: turn * state.spin, most, time }
    }

    /// Where a point of the body is, world axes, and how far it can go \[m\].
    fn moves(&self, r: Vec3) -> (Vec3, f64) {
        let arm = self.turn * r;
        let Most { spin, turning, acceleration } = self.most;
        let speed = (self.velocity + self.spin.cross(arm)).norm();
        let bend = acceleration + r.norm() * (turning + spin * spin);
        (self.centre + arm, (speed + 0.5 * bend * self.time) * self.time)
    }

    /// True where an edge of the body cannot come to one of an obstacle in the time, each given by its ends.
    fn keeps_apart(&self, own: [Vec3; 2], other: [Vec3; 2], spare: f64) -> bool {
        let ends = own.map(|end| self.moves(end));
        // No point between the ends goes farther than both.
        let far = ends[0].1.max(ends[1].1);
        distance(ends.map(|(place, _)| place), other) > far + spare
    }

    /// A place of the world, body axes.
    fn seen(&self, place: Vec3) -> Vec3 {
        self.turn.transposed() * (place - self.centre)
    }
}

impl World {
    /// For each pair whether it is so far from touching that nothing is noted of its gap.
    pub(in crate::spatial) fn far(&self, state: &State) -> Vec<bool> {
        let still = Most { spin: 0.0, turning: 0.0, acceleration: 0.0 };
        let moving = Moving { state: *state, acceleration: Vec3::ZERO, turning: Vec3::ZERO };
        let (now, reach) = (Outlook::of(&moving, still, 0.0), self.body().reach());
        let mut far = vec![true; self.count() - self.of_faces()];
        for obstacle in 0..self.obstacle_count() {
            if self.distance(obstacle, state.centre) > FAR * reach {
                continue;
            }
            let [_, pairs] = self.of_obstacle(obstacle);
            for pair in pairs {
                far[pair - self.of_faces()] = self.is_clear(pair, &now, NEAR_PAIR * reach);
            }
        }
        far
    }

    /// True where a support is certain not to touch in the time that is looked ahead; false says nothing. `spare` is how far behind a face what is beside its obstacle may be \[m\].
    pub(in crate::spatial) fn is_clear(&self, support: usize, ahead: &Outlook, spare: f64) -> bool {
        // Small heights are counted on from a touch, and differ from what is measured here.
        let spare = spare + CLEAR_OF_ROUNDING * self.body().reach();
        match self.pair(support) {
            None => self.point_is_clear(support, ahead, spare),
            Some(Pair::Corner { face, corner, radius, .. }) => {
                // The corner as the body sees it: the face's own point there moves with the body.
                let seen = ahead.seen(*corner);
                let (_, far) = ahead.moves(seen);
                let reach = self.body().reach() + radius;
                face.plane.height(seen).abs() > far + spare || seen.norm() > reach + far + spare
            }
            Some(Pair::Cross(Crossing { own, other, radius, .. })) => {
                let spare = spare + radius;
                let (middle, far) = ahead.moves(own.middle());
                let along = other.along.dot(middle - other.from).clamp(0.0, other.length);
                let distance = (other.from + other.along * along - middle).norm();
                distance > 0.5 * own.length + far + spare
                    || ahead.keeps_apart(own.ends(), other.ends(), spare)
            }
            Some(Pair::Round(Nearest { own, other, radius, .. })) => {
                ahead.keeps_apart(own.ends(), other.ends(), spare + radius)
            }
        }
    }

    /// For so long at least edges that may cross stay farther apart than `spare` \[s\], however parallel they become; 0 of other supports.
    pub(in crate::spatial) fn apart(&self, support: usize, state: &State, most: &Most, spare: f64) -> f64 {
        let Some(Pair::Cross(Crossing { own, other, radius, .. })) = self.pair(support) else { return 0.0 };
        let ends = own.ends();
        let clear = distance(ends.map(|end| state.place(end)), other.ends()) - radius - spare;
        let largest = |of: &dyn Fn(Vec3) -> f64| ends.into_iter().map(of).fold(0.0, f64::max);
        let speed = largest(&|end| state.velocity_of(end).norm());
        let bent = most.turning + most.spin * most.spin;
        let bend = most.acceleration + largest(&|end| end.norm()) * bent;
        if clear > 0.0 { Height { value: clear, rate: -speed, second: 0.0 }.safe(bend) } else { 0.0 }
    }

    fn point_is_clear(&self, support: usize, ahead: &Outlook, spare: f64) -> bool {
        let Support { feature, plane } = self.support(support);
        if feature.circle > 0.0 {
            return false;
        }
        let (place, far) = ahead.moves(feature.point);
        let height = plane.height(place) - feature.radius;
        let limits = &self.limits[self.plane_of(support)];
        let behind = !limits.is_empty() && height < -(far + spare);
        height > far + spare || behind || limits.iter().any(|limit| limit.margin(place) < -(far + spare))
    }
}
