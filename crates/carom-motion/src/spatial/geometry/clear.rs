//! What is certain not to touch for some time, told by a look at one instant: most of what a body and an obstacle have.

use super::pair::Pair;
use super::posture::{Most, Moving};
use super::state::State;
use super::world::{Support, World};
use crate::tolerance::{CLEAR_OF_ROUNDING, FAR};
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
            Some(Pair::Corner { face, corner, .. }) => {
                // The corner as the body sees it: the face's own point there moves with the body.
                let seen = ahead.seen(*corner);
                let (_, far) = ahead.moves(seen);
                face.plane.height(seen).abs() > far + spare || seen.norm() > self.body().reach() + far + spare
            }
            Some(Pair::Cross { own, other }) => {
                let (middle, far) = ahead.moves(own.middle());
                let along = other.along.dot(middle - other.from).clamp(0.0, other.length);
                let distance = (other.from + other.along * along - middle).norm();
                distance > 0.5 * own.length + far + spare
            }
        }
    }

    fn point_is_clear(&self, support: usize, ahead: &Outlook, spare: f64) -> bool {
        let Support { feature, plane } = self.support(support);
        if !feature.is_sharp() {
            return false;
        }
        let (place, far) = ahead.moves(feature.point);
        let height = plane.height(place);
        let limits = &self.limits[self.plane_of(support)];
        let behind = !limits.is_empty() && height < -(far + spare);
        height > far + spare || behind || limits.iter().any(|limit| limit.margin(place) < -(far + spare))
    }
}
