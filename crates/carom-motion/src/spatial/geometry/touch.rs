//! Where supports touch: the place, the normal, and how they move.

use super::pair::Pair;
use super::plane::Plane;
use super::posture::{Height, Most};
use super::state::{Pose, State};
use super::supports::Supports;
use super::surface::{Edge, Limit, Surface};
use super::world::{Share, Support, World};
use crate::tolerance::{BETWEEN_FACES, BEYOND_END, CARRIES, ONE_PLACE, RESTING_SLIP};
use carom_num::Vec3;
use std::ops::Range;

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

    /// The normal where a support touches, out of the obstacle and into the body, world axes; `ẑ` of a support that there is not.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::{State, World, examples};
    /// use carom_num::Vec3;
    /// let (world, start) = examples::falling_cube();
    /// assert_eq!(world.normal_at(0, &start), Vec3::Z);
    /// ```
    pub fn normal_at(&self, support: usize, state: &State) -> Vec3 {
        if support < self.count() { self.normal(support, state.pose()) } else { Vec3::Z }
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

    /// The supports of a plane; beyond the planes each pair is by itself.
    pub(in crate::spatial) fn of_plane(&self, plane: usize) -> Range<usize> {
        let (points, planes) = (self.body().supports().len(), self.planes().len());
        match plane.checked_sub(planes) {
            None => plane * points..(plane + 1) * points,
            Some(pair) => planes * points + pair..planes * points + pair + 1,
        }
    }

    /// The obstacle of a support, by its place in the list that [`World::among`] was given; 0 where there is the one plane z = 0.
    ///
    /// # Example
    /// A cube of eight corners on a floor and between two walls, which are planes.
    /// ```
    /// use carom_motion::spatial::{Friction, Plane, World, examples};
    /// use carom_num::Vec3;
    /// let wall = |x: f64| Plane::new(Vec3::X * x, -2.0).unwrap();
    /// let world = World::new(examples::block(), Vec3::Z * -10.0).unwrap().with_friction(Friction::new(0.1)).unwrap();
    /// let world = world.among(vec![Plane::FLOOR, wall(1.0), wall(-1.0)]).unwrap();
    /// assert_eq!([7, 8, 23].map(|support| world.obstacle_of(support)), [0, 1, 2]);
    /// ```
    pub fn obstacle_of(&self, support: usize) -> usize {
        let of_face = |share: &Share| share.planes.contains(&self.plane_of(support));
        let pair = support.checked_sub(self.of_faces());
        let of_pair = |share: &Share| pair.is_some_and(|pair| share.pairs.contains(&pair));
        let own = |share: &Share| if pair.is_some() { of_pair(share) } else { of_face(share) };
        self.shares.iter().position(own).unwrap_or_default()
    }

    /// How many obstacles there are.
    pub(in crate::spatial) fn obstacle_count(&self) -> usize {
        self.shares.len()
    }

    /// The supports of an obstacle: on its faces, and the pairs.
    pub(in crate::spatial) fn of_obstacle(&self, obstacle: usize) -> [Range<usize>; 2] {
        let (share, points, faces) = (&self.shares[obstacle], self.body().supports().len(), self.of_faces());
        let (planes, pairs) = (&share.planes, &share.pairs);
        [planes.start * points..planes.end * points, faces + pairs.start..faces + pairs.end]
    }

    /// How far a place is from an obstacle at least; negative where that may be 0 \[m\].
    pub(in crate::spatial) fn distance(&self, obstacle: usize, place: Vec3) -> f64 {
        let planes = self.planes()[self.shares[obstacle].planes.clone()].iter();
        let beyond =
            |edge: &Edge| edge.outward.unit().map_or(f64::NEG_INFINITY, |n| n.dot(place - edge.from));
        let none = Surface::default();
        let surface = self.obstacles.get(obstacle).unwrap_or(&none);
        if surface.faces.is_empty() && !surface.corners.is_empty() {
            return surface.beyond_balls(place);
        }
        let beyond = surface.edges.iter().map(|edge| beyond(edge) - surface.radius);
        planes.map(|plane| plane.height(place)).chain(beyond).fold(f64::NEG_INFINITY, f64::max)
    }

    /// A body that flies so is below all obstacles that have ends, and no plane without ends faces upwards: nothing can carry it any more.
    pub(in crate::spatial) fn is_past(&self, state: &State) -> bool {
        let Some(down) = self.gravity().unit() else { return false };
        let carries = |plane: &Plane| plane.normal().dot(down) < -CARRIES;
        let lowest = |surface: &Surface| {
            let corners = surface.corners.iter().map(|corner| down.dot(*corner));
            corners.fold(f64::NEG_INFINITY, f64::max) + surface.radius
        };
        let below = |surface: &Surface| {
            if surface.corners.is_empty() {
                return !surface.faces.iter().any(|face| carries(&face.plane));
            }
            down.dot(state.centre) - self.body().reach() > lowest(surface)
        };
        !self.obstacles.is_empty() && down.dot(state.velocity) >= 0.0 && self.obstacles.iter().all(below)
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
        let spokes = self.form.spokes(number % features).iter().map(|spoke| -spoke.dot(up));
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
        let mut seen: Vec<(Vec3, Vec3)> = vec![];
        let mut out = Supports::NONE;
        for support in supports.iter() {
            let own = self.place_of(support, pose);
            if !seen.iter().any(|other| self.is_one_place(own, *other)) {
                seen.push(own);
                out = out.with(support);
            }
        }
        out
    }

    /// Those of some supports that touch where these do, with the same normal.
    pub(in crate::spatial) fn twins(
        &self,
        of: Supports,
        among: impl Iterator<Item = usize>,
        pose: Pose,
    ) -> Supports {
        let seen: Vec<(Vec3, Vec3)> = of.iter().map(|support| self.place_of(support, pose)).collect();
        let is_twin = |i: &usize| {
            let own = self.place_of(*i, pose);
            seen.iter().any(|other| self.is_one_place(own, *other))
        };
        among.filter(is_twin).collect()
    }

    /// Where a support touches, body axes, and its normal, world axes.
    fn place_of(&self, support: usize, pose: Pose) -> (Vec3, Vec3) {
        (self.arm(support, pose), self.normal(support, pose))
    }

    fn is_one_place(&self, (place, normal): (Vec3, Vec3), (other, up): (Vec3, Vec3)) -> bool {
        let near = ONE_PLACE * self.body().reach();
        (place - other).norm() <= near && (normal - up).norm() <= ONE_PLACE
    }

    /// True where a support may touch, were its height zero: its place is on the face or the edges, and does not leave them at their very end.
    pub(in crate::spatial) fn is_within(&self, number: usize, state: &State) -> bool {
        let faces = match self.pair(number) {
            Some(pair) => pair.faces(state.pose()),
            None => self.limits(number) == 0 || self.turned_away(number, state) <= 0.0,
        };
        faces && self.shut_out(number, state).is_none()
    }

    /// The limit of a face or an edge that a place is beyond, and whether it is by so much that it has to come back first; else it is there and does not come in.
    pub(in crate::spatial) fn shut_out(&self, number: usize, state: &State) -> Option<(usize, bool)> {
        let cases = (0..self.limits(number)).flat_map(|limit| [(limit, true), (limit, false)]);
        let is = |case: &(usize, bool)| {
            let [margin, rate] = self.kept_out(number, *case, state);
            margin >= 0.0 && rate > 0.0
        };
        cases.into_iter().find(is)
    }

    /// What stays positive as long as that does: by how far the place is beyond, and how slowly it comes in [m, m/s].
    pub(in crate::spatial) fn kept_out(
        &self,
        number: usize,
        (limit, far): (usize, bool),
        state: &State,
    ) -> [f64; 2] {
        let beyond = BEYOND_END * self.body().reach();
        let margin = self.margin(number, limit, state.pose());
        if far {
            return [-beyond - margin, 1.0];
        }
        let rate = match self.pair(number) {
            Some(pair) => pair.margin_rate(limit, state),
            None => {
                // Its place moves as fast as its centre does: only points and balls touch faces that have ends.
                let velocity = state.velocity_of(self.support(number).feature.point);
                self.limits[self.plane_of(number)][limit].inward.dot(velocity)
            }
        };
        let still = self.still(state);
        // An edge that ends just on another one touches with its corner: a box slides over the seam of two plates.
        let by_corner = self.pair(number).is_some_and(|pair| pair.ends_in_corner(limit));
        let least = if by_corner { still } else { -still };
        [0.5 * beyond - margin, least - rate]
    }
}
