//! An edge of the body across an edge of an obstacle.
//!
//! They are nearest to each other on the common perpendicular of their lines. Both may be rounded by balls: the two touch where the lines are the radii apart.

use super::pair::{Meeting, Passing};
use super::posture::Most;
use super::state::{Pose, State};
use super::surface::Edge;
use crate::tolerance::{BETWEEN_FACES, PARALLEL_EDGES};
use carom_num::Vec3;

/// Two edges that may touch: the body's in its axes from the mass centre, the obstacle's in the world's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::spatial) struct Crossing {
    pub(in crate::spatial) own: Edge,
    pub(in crate::spatial) other: Edge,
    /// Of the balls that round the two, together; 0 of sharp ones. And of the body's alone.
    pub(in crate::spatial) radius: f64,
    pub(in crate::spatial) own_radius: f64,
}

/// How two edges are at an instant, world axes.
struct Crossed {
    /// The body's direction, the common perpendicular as long as the sine between them, on which side of it the body is, and that sine.
    along: Vec3,
    straight: Vec3,
    side: f64,
    sine: f64,
    /// From the middle of the obstacle's edge, which may be long, to the start of the body's.
    between: Vec3,
}

impl Crossed {
    /// The perpendicular that points into the body.
    fn across(&self) -> Vec3 {
        self.straight * self.side
    }

    fn is_parallel(&self) -> bool {
        self.sine <= PARALLEL_EDGES
    }

    /// How far along the two edges they are nearest to each other.
    fn places(&self, other: &Edge) -> [f64; 2] {
        let square = self.sine * self.sine;
        let place = |edge: Vec3| -self.between.cross(edge).dot(self.straight) / square;
        [place(other.along), place(self.along) + 0.5 * other.length]
    }
}

impl Crossing {
    fn at(&self, pose: Pose) -> Crossed {
        let Self { own, other, radius, .. } = self;
        let along = pose.attitude.apply(own.along);
        let straight = along.cross(other.along);
        let between = pose.centre + pose.attitude.apply(own.from) - other.middle();
        // A sharp edge may be behind the other, and faces tell on which side of it its body is; the middle of a rounded one is on its own side.
        let other_side = if *radius > 0.0 {
            straight.dot(between) < 0.0
        } else {
            straight.dot(pose.attitude.apply(own.outward)) > 0.0
        };
        let side = if other_side { -1.0 } else { 1.0 };
        Crossed { along, straight, side, sine: straight.norm(), between }
    }

    pub(super) fn meeting(&self, pose: Pose) -> Meeting {
        self.meeting_of(&self.at(pose), pose)
    }

    fn meeting_of(&self, crossed: &Crossed, pose: Pose) -> Meeting {
        if crossed.is_parallel() {
            let place = pose.centre + pose.attitude.apply(self.own.from);
            return Meeting { place, normal: Vec3::Z, gap: f64::INFINITY };
        }
        let normal = crossed.across() / crossed.sine;
        let [along, _] = crossed.places(&self.other);
        let place = self.other.middle() + crossed.between + crossed.along * along - normal * self.own_radius;
        Meeting { place, normal, gap: normal.dot(crossed.between) - self.radius }
    }

    pub(super) fn passing(&self, state: &State) -> Passing {
        let (pose, other) = (state.pose(), &self.other);
        let crossed = self.at(pose);
        let at = self.meeting_of(&crossed, pose);
        let Meeting { place, normal, gap } = at;
        let spin = pose.attitude.apply(state.spin);
        let moves = |place: Vec3| state.velocity + spin.cross(place - pose.centre);
        let slip = moves(place);
        if crossed.is_parallel() {
            return Passing { at, place: slip, normal: Vec3::ZERO, slip };
        }
        let turns = spin.cross(crossed.along).cross(other.along) * crossed.side;
        let turns = (turns - normal * normal.dot(turns)) / crossed.sine;
        let square = crossed.sine * crossed.sine;
        let line = moves(place + normal * self.own_radius);
        let runs = (turns * (gap + self.radius) - line).cross(other.along).dot(crossed.straight) / square;
        let place = line + crossed.along * runs - turns * self.own_radius;
        Passing { at, place, normal: turns, slip }
    }

    /// Places of the two edges that are near to each other, world axes.
    fn nearest(&self, pose: Pose) -> [Vec3; 2] {
        let crossed = self.at(pose);
        let [along, beside] = if crossed.is_parallel() {
            [self.own.length, self.other.length].map(|length| 0.5 * length)
        } else {
            crossed.places(&self.other)
        };
        let own = crossed.along * (along.clamp(0.0, self.own.length));
        let other = self.other.along * beside.clamp(0.0, self.other.length);
        [self.other.middle() + crossed.between + own, self.other.from + other]
    }

    /// The distance of the lines times the sine between them, and its rate.
    fn apart(&self, state: &State) -> [f64; 2] {
        let pose = state.pose();
        let spin = pose.attitude.apply(state.spin);
        let crossed = self.at(pose);
        let velocity = state.velocity + spin.cross(pose.attitude.apply(self.own.from));
        let (across, turns) = (crossed.across(), spin.cross(crossed.along).cross(self.other.along));
        let rate = (turns * crossed.side).dot(crossed.between) + across.dot(velocity);
        [across.dot(crossed.between), rate]
    }

    /// The gap and what is added to it, times the sine between the edges, and its rate: bounded is how that bends. Of a rounded edge half the difference of the squares of the lines'
    /// distance and of the radius, in the radius, times the square of the sine: the gap times that square where they touch.
    pub(super) fn approach(&self, state: &State, added: f64) -> [f64; 2] {
        let [apart, rate] = self.apart(state);
        let Crossed { along, straight, sine, .. } = self.at(state.pose());
        if self.radius == 0.0 {
            return [apart + added * sine, rate];
        }
        let bent = state.attitude.apply(state.spin).cross(along).cross(self.other.along);
        let radius = self.radius - added;
        let value = (apart - radius * sine) * (apart + radius * sine) / (2.0 * radius);
        [value, (apart * rate - radius * radius * straight.dot(bent)) / radius]
    }

    /// What the second derivatives of that and of [`Crossing::beyond`] do not exceed for so long.
    pub(super) fn bend(&self, state: &State, most: &Most, time: f64) -> [f64; 2] {
        let Most { spin, turning, acceleration } = *most;
        let bent = turning + spin * spin;
        let lengths = self.own.length + self.other.length;
        let arm = self.own.middle().norm() + lengths;
        let speed = state.velocity.norm() + acceleration * time + spin * arm;
        let far = (state.place(self.own.middle()) - self.other.middle()).norm() + lengths + speed * time;
        let ends =
            2.0 * (bent + spin * spin) * (far + lengths) + 4.0 * spin * speed + acceleration + bent * arm;
        // The distance of the lines is told by any two places on them: by the nearest ones of the edges it bends least.
        let [place, there] = self.nearest(state.pose());
        let seen = state.attitude.undo(place - state.centre);
        let bends = acceleration + bent * seen.norm();
        let speed = state.velocity_of(seen).norm() + bends * time;
        let own = bent * ((place - there).norm() + speed * time) + 2.0 * spin * speed + bends;
        if self.radius == 0.0 {
            return [own, ends];
        }
        // What they are now, and for so long at most.
        let [apart, rate] = self.apart(state).map(f64::abs);
        let (apart, rate) = (apart + (rate + 0.5 * own * time) * time, rate + own * time);
        let round = (rate * rate + apart * own) / self.radius + self.radius * (spin * spin + bent);
        [round, ends]
    }

    /// How far the place is inside one of its limits: the ends of both edges \[m\].
    pub(super) fn margin(&self, limit: usize, pose: Pose) -> f64 {
        let crossed = self.at(pose);
        if crossed.is_parallel() {
            return f64::NEG_INFINITY;
        }
        let [along, beside] = crossed.places(&self.other);
        [along, self.own.length - along, beside, self.other.length - beside][limit]
    }

    /// How fast that changes [m/s].
    pub(super) fn margin_rate(&self, limit: usize, state: &State) -> f64 {
        let passing = self.passing(state);
        let along = state.attitude.apply(self.own.along).dot(passing.place - passing.slip);
        let beside = self.other.along.dot(passing.place);
        [along, -along, beside, -beside][limit]
    }

    pub(super) fn is_parallel(&self, pose: Pose) -> bool {
        self.at(pose).is_parallel()
    }

    /// What [`Crossing::beyond`] is in units of.
    pub(super) fn scale(&self, pose: Pose) -> f64 {
        let sine = self.at(pose).sine;
        sine * sine
    }

    /// How far the place is beyond one of its limits, and its rate, times the square of the sine between the edges, which bends less; `spare` beyond it is not.
    pub(super) fn beyond(&self, limit: usize, state: &State, spare: f64) -> [f64; 2] {
        let Self { own, other, .. } = self;
        let pose = state.pose();
        let spin = pose.attitude.apply(state.spin);
        let Crossed { along, straight, sine, between, .. } = self.at(pose);
        let moves = state.velocity + spin.cross(pose.attitude.apply(own.from));
        let (turns, edge) = (spin.cross(along), other.along);
        let bent = turns.cross(edge);
        let (square, widens) = (sine * sine, 2.0 * straight.dot(bent));
        let (run, rate, length) = if limit < 2 {
            let run = between.cross(edge);
            (run.dot(straight), moves.cross(edge).dot(straight) + run.dot(bent), own.length)
        } else {
            let run = between.cross(along);
            let rate = moves.cross(along) + between.cross(turns);
            let half = 0.5 * other.length;
            let (run, rate) = (run.dot(straight), rate.dot(straight) + run.dot(bent));
            (run - half * square, rate - half * widens, other.length)
        };
        let (run, rate) = if limit.is_multiple_of(2) {
            (run, rate)
        } else {
            (-run - length * square, -rate - length * widens)
        };
        [run - spare * square, rate - spare * widens]
    }

    /// How far the perpendicular is turned from directions outside of both, between the faces of each, times the sine; and how far at least it has to turn, of which no more than 2 |ω| is
    /// taken back.
    ///
    /// The perpendicular of two sharp edges changes its side where it is across the middle of the body's faces: what the obstacle's faces say of it holds until then. That of a rounded one does
    /// where the lines meet: both sides are asked.
    pub(super) fn turned_away(&self, pose: Pose) -> [f64; 2] {
        let crossed = self.at(pose);
        let spare = BETWEEN_FACES * crossed.sine;
        let away = |across: Vec3| {
            let inner = pose.attitude.undo(-across);
            (inner, [most(&self.own.sides, inner), most(&self.other.sides, across)])
        };
        let (inner, [body, obstacle]) = away(crossed.across());
        let now = body.max(obstacle);
        let lasting = if self.radius == 0.0 {
            let flips = self.own.outward.unit().map_or(0.0, |outward| outward.dot(inner).abs());
            body.max(obstacle.min(flips))
        } else {
            let (_, [body, obstacle]) = away(-crossed.across());
            now.min(body.max(obstacle))
        };
        [now - spare, lasting - spare]
    }
}

/// How far a direction leads into the farthest of some others.
pub(super) fn most(sides: &[Vec3], normal: Vec3) -> f64 {
    sides.iter().map(|side| side.dot(normal)).fold(f64::NEG_INFINITY, f64::max)
}
