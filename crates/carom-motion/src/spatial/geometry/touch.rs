//! Where supports touch: the place, the normal, and how they move.

use super::pair::Pair;
use super::posture::{Height, Most};
use super::state::{Pose, State};
use super::supports::Supports;
use super::surface::Limit;
use super::world::{Support, World};
use crate::tolerance::{BETWEEN_FACES, BEYOND_END, ONE_PLACE, RESTING_SLIP};
use carom_num::Vec3;

impl World {
    /// How many supports there are.
    pub(in crate::spatial) fn count(&self) -> usize {
        self.of_faces() + self.pairs.len()
    }

    /// How many of them are points of the body on faces: they come first.
    pub(in crate::spatial) fn of_faces(&self) -> usize {
        self.body().supports().len() * self.planes().len()
    }

    /// The edges, or the face and the corner, that a support is; `None` where it is a point of the body on a face.
    pub(in crate::spatial) fn pair(&self, number: usize) -> Option<&Pair> {
        self.pairs.get(number.checked_sub(self.of_faces())?)
    }

    /// One of these is no point of the body on a face.
    pub(in crate::spatial) fn has_pairs(&self, supports: Supports) -> bool {
        !self.pairs.is_empty() && supports.iter().any(|i| i >= self.of_faces())
    }

    /// Where a support touches, from the mass centre, body axes \[m\]: a matter of how the body stands. Supports of the first face have the numbers
    /// of the body's features. `None` where there is no such support.
    ///
    /// # Example
    /// A ball touches the floor with its lowest place, whichever of its own that is.
    /// ```
    /// use carom_motion::spatial::{Body, Feature, State, World};
    /// use carom_num::{Mat3, Rotation, Vec3};
    /// let ball = Body::of(1.0, Mat3::IDENTITY, vec![Feature::point(Vec3::ZERO).rounded(0.5)]).unwrap();
    /// let lying = Rotation::by(Vec3::X * std::f64::consts::FRAC_PI_2);
    /// let state = State::standing(&ball, 0, lying, Vec3::ZERO);
    /// let world = World::new(ball, -Vec3::Z).unwrap();
    /// assert!((world.touches_at(0, &state).unwrap() + Vec3::Y * 0.5).norm() < 1e-15);
    /// assert_eq!(world.touches_at(1, &state), None);
    /// ```
    pub fn touches_at(&self, support: usize, state: &State) -> Option<Vec3> {
        (support < self.count()).then(|| self.arm(support, state.pose()))
    }

    /// The same of a support that there is.
    pub(in crate::spatial) fn arm(&self, number: usize, pose: Pose) -> Vec3 {
        if let Some(pair) = self.pair(number) {
            return pose.attitude.undo(pair.meeting(pose).place - pose.centre);
        }
        let Support { feature, plane } = self.support(number);
        if feature.is_sharp() { feature.point } else { feature.arm(pose.attitude.undo(plane.normal())) }
    }

    /// What a support that touches accelerates by, body axes, besides what the accelerations of the mass centre and of the spin do: its place moves, and its normal may turn.
    pub(in crate::spatial) fn bent(&self, number: usize, state: &State) -> Vec3 {
        let (attitude, spin) = (state.attitude, state.spin);
        if let Some(pair) = self.pair(number) {
            return pair.passing(state).bent(state);
        }
        let Support { feature, plane } = self.support(number);
        if feature.is_sharp() {
            return spin.cross(spin.cross(feature.point));
        }
        let up = attitude.undo(plane.normal());
        spin.cross(spin.cross(feature.arm(up)) + feature.drift(up, spin))
    }

    /// Two tangents and the normal where it touches, world axes.
    pub(in crate::spatial) fn axes(&self, number: usize, pose: Pose) -> [Vec3; 3] {
        match self.pair(number) {
            Some(pair) => pair.meeting(pose).axes(),
            None => self.support(number).plane.axes(),
        }
    }

    /// The normal where it touches, world axes.
    pub(in crate::spatial) fn normal(&self, number: usize, pose: Pose) -> Vec3 {
        match self.pair(number) {
            Some(pair) => pair.meeting(pose).normal,
            None => self.support(number).plane.normal(),
        }
    }

    /// The part of a vector across that normal, world axes.
    pub(in crate::spatial) fn along(&self, number: usize, pose: Pose, v: Vec3) -> Vec3 {
        let normal = self.normal(number, pose);
        v - normal * normal.dot(v)
    }

    /// The first obstacle with ends that the body is in, and how deep; where it touches one it is not deeper than `spare`.
    pub(in crate::spatial) fn overlap(&self, pose: Pose, spare: f64) -> Option<(usize, f64)> {
        let with_ends = self.obstacles.iter().enumerate().filter(|(_, other)| !other.corners.is_empty());
        let mut deep = with_ends.map(|(i, other)| (i, -self.surface.separation(other, pose)));
        deep.find(|(_, depth)| *depth > spare)
    }

    /// The supports of a plane; beyond the planes each pair is by itself.
    pub(in crate::spatial) fn of_plane(&self, plane: usize) -> Supports {
        let (points, planes) = (self.body().supports().len(), self.planes().len());
        match plane.checked_sub(planes) {
            None => (plane * points..(plane + 1) * points).collect(),
            Some(pair) => Supports::one(planes * points + pair),
        }
    }

    /// The plane of a support, by its number.
    pub(in crate::spatial) fn plane_of(&self, support: usize) -> usize {
        match support.checked_sub(self.of_faces()) {
            None => support / self.body().supports().len(),
            Some(pair) => self.planes().len() + pair,
        }
    }

    /// True where these supports are of one plane, or none.
    pub(in crate::spatial) fn is_of_one_plane(&self, supports: Supports) -> bool {
        let mut planes = supports.iter().map(|i| self.plane_of(i));
        let one = planes.next().is_none_or(|first| planes.all(|plane| plane == first));
        one && !self.has_pairs(supports)
    }

    /// How many limits the place has where a support touches.
    pub(in crate::spatial) fn limits(&self, number: usize) -> usize {
        match self.pair(number) {
            Some(pair) => pair.limits(),
            None => self.limits[self.plane_of(number)].len(),
        }
    }

    /// How far that place is inside one of its limits \[m\].
    pub(in crate::spatial) fn margin(&self, number: usize, limit: usize, pose: Pose) -> f64 {
        match self.pair(number) {
            Some(pair) => pair.margin(limit, pose),
            None => {
                let place = pose.centre + pose.attitude.apply(self.arm(number, pose));
                self.limits[self.plane_of(number)][limit].margin(place)
            }
        }
    }

    /// For so long at least a support stays beside the face that has ends, or its edges stay beside each other, if they are so now \[s\].
    pub(in crate::spatial) fn stays_aside(
        &self,
        number: usize,
        state: &State,
        most: &Most,
        time: f64,
    ) -> f64 {
        let spare = BEYOND_END * self.body().reach();
        let still = self.still(state);
        // At the very end it stays no contact as long as it leaves.
        let for_long = |[beyond, rate]: [f64; 2], bend: f64, scale: f64| {
            let height = Height { value: beyond, rate, second: 0.0 };
            if beyond > 0.0 {
                height.safe(bend)
            } else if beyond >= -1.5 * spare * scale && rate > still * scale {
                rate / bend
            } else {
                0.0
            }
        };
        let turns = |away: f64| if away > 0.0 { away / (2.0 * most.spin) } else { 0.0 };
        if let Some(pair) = self.pair(number) {
            let ([_, bend], scale) = (pair.bend(state, most, time), pair.scale(state.pose()));
            let of = |limit: usize| for_long(pair.beyond(limit, state, spare), bend, scale);
            return (0..pair.limits()).map(of).fold(turns(pair.turned_away(state.pose())[1]), f64::max);
        }
        let limits = &self.limits[self.plane_of(number)];
        if limits.is_empty() {
            return 0.0;
        }
        let feature = self.support(number).feature;
        let (place, velocity) = (state.place(feature.point), state.velocity_of(feature.point));
        let bend = most.acceleration + feature.point.norm() * (most.turning + most.spin * most.spin);
        let of =
            |limit: &Limit| for_long([-limit.margin(place) - spare, -limit.inward.dot(velocity)], bend, 1.0);
        limits.iter().map(of).fold(turns(self.turned_away(number, state)), f64::max)
    }

    /// How far a point of the body is turned from where it touches a face: its edges are in front of the face then. A thin plate has another face behind. At most |ω| takes it back.
    fn turned_away(&self, number: usize, state: &State) -> f64 {
        let features = self.body().features().len();
        let up = state.attitude.undo(self.support(number).plane.normal());
        let spokes = self.spokes[number % features].iter().map(|spoke| -spoke.dot(up));
        spokes.fold(f64::NEG_INFINITY, f64::max) - BETWEEN_FACES
    }

    /// Places that move slower than this along a face or an edge stay where they are [m/s].
    fn still(&self, state: &State) -> f64 {
        RESTING_SLIP * self.scales().speed.max(state.velocity.norm())
    }

    /// Of supports that touch at one place with one normal the first.
    pub(in crate::spatial) fn distinct(&self, supports: Supports, pose: Pose) -> Supports {
        if self.pairs.is_empty() {
            return supports;
        }
        let near = ONE_PLACE * self.body().reach();
        let mut seen: Vec<(Vec3, Vec3)> = vec![];
        let mut out = Supports::NONE;
        for support in supports.iter() {
            let (place, normal) = (self.arm(support, pose), self.normal(support, pose));
            let same = |(other, up): &(Vec3, Vec3)| {
                (place - *other).norm() <= near && (normal - *up).norm() <= ONE_PLACE
            };
            if !seen.iter().any(same) {
                seen.push((place, normal));
                out = out.with(support);
            }
        }
        out
    }

    /// True where a support may touch, were its height zero: its place is on the face or the edges, and does not leave them at their very end.
    pub(in crate::spatial) fn is_within(&self, number: usize, state: &State) -> bool {
        let beyond = BEYOND_END * self.body().reach();
        let rate = |limit: usize| match self.pair(number) {
            Some(pair) => pair.margin_rate(limit, state),
            None => {
                let velocity = state.velocity_of(self.arm(number, state.pose()));
                self.limits[self.plane_of(number)][limit].inward.dot(velocity)
            }
        };
        let still = self.still(state);
        // An edge that ends just on another one touches with its corner: a box slides over the seam of two plates.
        let least = if matches!(self.pair(number), Some(Pair::Cross { .. })) { still } else { -still };
        let stays = |limit: usize| {
            let margin = self.margin(number, limit, state.pose());
            margin > 0.5 * beyond || margin >= -beyond && rate(limit) >= least
        };
        let faces = match self.pair(number) {
            Some(pair) => pair.faces(state.pose()),
            None => self.limits(number) == 0 || self.turned_away(number, state) <= 0.0,
        };
        faces && (0..self.limits(number)).all(stays)
    }
}
