//! A sliding body at one instant: what each support does, and how the body answers.

use super::carriers::Carrier;
use super::{SLIP, Sliding, Vector, WAY, YAW};
use crate::spatial::geometry::pair::Pair;
use crate::spatial::geometry::posture::Posture;
use crate::spatial::geometry::state::{Pose, State};
use crate::spatial::modes::grip::{Bearing, Grip, Reactions};
use carom_num::{Rotation, Vec3};

/// The body at one instant.
pub(in crate::spatial) struct Moment {
    pub(in crate::spatial) turned: Rotation,
    pub(in crate::spatial) spin: Vec3,
    /// The tangents and the normal of the foot's plane, body axes.
    pub(in crate::spatial) axes: [Vec3; 3],
    /// Where the foot touches, from the mass centre, how fast that place moves along the body, and the foot's slip, body axes.
    pub(in crate::spatial) foot: Vec3,
    foot_drift: Vec3,
    pub(in crate::spatial) slip: Vec3,
    pub(in crate::spatial) bearings: Vec<Bearing>,
    /// How fast the places where they touch move along the body, less the foot's, body axes [m/s].
    pub(in crate::spatial) drifts: Vec<Vec3>,
    /// Slip speeds \[m/s\].
    pub(in crate::spatial) speeds: Vec<f64>,
    /// Angular acceleration of the free body.
    free: Vec3,
}

impl Sliding<'_> {
    pub(in crate::spatial) fn moment(&self, y: &Vector) -> Moment {
        let turned = Rotation { w: y[0], v: Vec3::new(y[1], y[2], y[3]) };
        let turned = Rotation::of(turned.to_array()).unwrap_or(turned);
        let (spin, yaw) = (Vec3::new(y[4], y[5], y[6]), y[YAW]);
        let axes = self.axes.map(|axis| turned.undo(axis));
        let [east, north, up] = axes;
        let spin = spin + up * (yaw - up.dot(spin));
        let gravity = self.gravity_in(axes);
        let free = self.body.mobility() * -spin.cross(self.body.inertia() * spin);
        let slip = east * y[SLIP] + north * y[SLIP + 1] + up * y[SLIP + 2];
        let (foot, foot_drift, state) = self.on_foot(y, (turned, axes), (spin, slip));
        let count = self.carriers.len();
        let (mut bearings, mut speeds) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let mut drifts = Vec::with_capacity(count);
        for c in &self.carriers {
            if let (Some(pair), Some(state)) = (self.world.pair(c.support), &state) {
                let (bearing, drift) = self.paired((c, pair), state, [slip, foot, free]);
                speeds.push(bearing.1);
                drifts.push(drift - foot_drift);
                bearings.push(bearing.0);
                continue;
            }
            let axes = if c.level { axes } else { c.then.map(|axis| turned.undo(axis)) };
            let bearing = Bearing { axes, ..Bearing::default() };
            // What touches the foot's plane lies in it: no other part of the spin moves it along.
            let arm = c.feature.arm(axes[2]);
            let turn = if c.level { up * yaw } else { spin };
            let own = bearing.along(slip + turn.cross(arm - foot));
            let drift = c.feature.drift(axes[2], spin);
            drifts.push(drift - foot_drift);
            let lead = axes[0] * c.frame[0].dot(c.lead) + axes[1] * c.frame[1].dot(c.lead);
            // On several planes a slip that is to start is never zero to the last digit.
            let own =
                if self.apart && lead != Vec3::ZERO && own.norm() <= self.speck { Vec3::ZERO } else { own };
            speeds.push(own.norm());
            bearings.push(Bearing {
                arm,
                axes,
                friction: c.friction,
                sticks: c.sticks,
                toward: if c.sticks { Vec3::ZERO } else { own.unit().unwrap_or(lead) },
                drive: gravity + free.cross(arm) + spin.cross(spin.cross(arm) + drift),
            });
        }
        Moment { turned, spin, axes, foot, foot_drift, slip, bearings, drifts, speeds, free }
    }

    /// Where the foot touches, how fast that place moves along the body, body axes; and the body, where something but its points touches.
    fn on_foot(
        &self,
        y: &Vector,
        (turned, axes): (Rotation, [Vec3; 3]),
        (spin, slip): (Vec3, Vec3),
    ) -> (Vec3, Vec3, Option<State>) {
        let up = axes[2];
        if !self.paired {
            return (self.foot.arm(up), self.foot.drift(up, spin), None);
        }
        let pose = self.pose(y, turned, spin);
        let pair = self.pair.and_then(|support| self.world.pair(support));
        let arm = match pair {
            Some(pair) => pose.attitude.undo(pair.meeting(pose).place - pose.centre),
            None => self.foot.arm(up),
        };
        let velocity = pose.attitude.apply(slip + arm.cross(spin));
        let state = State { centre: pose.centre, attitude: pose.attitude, velocity, spin };
        let drift = pair.map_or_else(
            || self.foot.drift(up, spin),
            |pair| {
                let passing = pair.passing(&state);
                pose.attitude.undo(passing.place - passing.slip)
            },
        );
        (arm, drift, Some(state))
    }

    /// A pair that carries the body: with its slip speed, and how fast its place moves along the body.
    fn paired(
        &self,
        (c, pair): (&Carrier, &Pair),
        state: &State,
        [slip, foot, free]: [Vec3; 3],
    ) -> ((Bearing, f64), Vec3) {
        let (pose, attitude, spin) = (state.pose(), state.attitude, state.spin);
        let passing = pair.passing(state);
        let meeting = passing.at;
        let axes = meeting.axes().map(|axis| attitude.undo(axis));
        let arm = attitude.undo(meeting.place - pose.centre);
        let bearing = Bearing { axes, ..Bearing::default() };
        let own = bearing.along(slip + spin.cross(arm - foot));
        let lead = bearing.along(attitude.undo(c.lead)).unit().unwrap_or(Vec3::ZERO);
        let own = if lead != Vec3::ZERO && own.norm() <= self.speck { Vec3::ZERO } else { own };
        let drift = attitude.undo(passing.place - passing.slip);
        let gravity = attitude.undo(self.world.gravity());
        let bearing = Bearing {
            arm,
            friction: c.friction,
            sticks: c.sticks,
            toward: if c.sticks { Vec3::ZERO } else { own.unit().unwrap_or(lead) },
            drive: gravity + free.cross(arm) + passing.bent(state),
            ..bearing
        };
        ((bearing, own.norm()), drift)
    }

    /// Three of the numbers that are integrated as a vector of the world.
    pub(super) fn in_world(&self, y: &Vector, first: usize) -> Vec3 {
        self.frame[0] * y[first] + self.frame[1] * y[first + 1] + self.frame[2] * y[first + 2]
    }

    /// Where the body is.
    pub(super) fn pose(&self, y: &Vector, turned: Rotation, spin: Vec3) -> Pose {
        let whole = self.attitude.after(turned);
        let attitude = Rotation::of(whole.to_array()).unwrap_or(whole);
        let [raised, ..] = self.raised(turned, spin, Vec3::ZERO);
        let centre = self.place + self.in_world(y, WAY) + raised - attitude.apply(self.foot.point);
        Pose { centre, attitude }
    }

    pub(in crate::spatial) fn reactions(&self, now: &Moment) -> Option<Reactions> {
        let grip = Grip { body: self.body, bearings: &now.bearings };
        if self.loose { grip.corrections() } else { grip.reactions() }
    }

    pub(super) fn turning(&self, now: &Moment, reactions: Option<&Reactions>) -> Vec3 {
        now.free + reactions.map_or(Vec3::ZERO, |r| self.body.mobility() * r.moment)
    }

    /// The instant as the search of events sees it.
    pub(super) fn posture_of(&self, y: &Vector, now: &Moment, reactions: Option<&Reactions>) -> Posture {
        let flat =
            |v: Vec3| (0..self.ways).fold(Vec3::ZERO, |sum, k| sum + self.frame[k] * v.dot(now.axes[k]));
        let turning = self.turning(now, reactions);
        // No height over the foot's own plane changes with it.
        let bent = reactions
            .filter(|_| self.planes.len() > 1 || self.ways == 3)
            .map_or(Vec3::ZERO, |reactions| flat(self.centre_acceleration(now, reactions)));
        let base = [self.in_world(y, WAY), self.in_world(y, SLIP) + flat(self.rolled(now)), bent];
        // That of its centre does, where it is a circle.
        let raised = self.raised(now.turned, now.spin, turning);
        let base = [0, 1, 2].map(|k| base[k] + raised[k]);
        Posture { turned: now.turned, up: now.axes[2], spin: now.spin, turning, from: self.foot.point, base }
    }

    /// How far the foot's centre has risen over the foot's plane, its velocity and its acceleration, world axes: none but of a circle.
    pub(super) fn raised(&self, turned: Rotation, spin: Vec3, turning: Vec3) -> [Vec3; 3] {
        let then = self.axes[2];
        let lift = self.foot.sunk(turned, [then, turned.undo(then)], [spin, turning]);
        [lift.value, lift.rate, lift.second].map(|v| self.frame[2] * v)
    }

    /// Gravity, body axes, where the tangents and the normal of the foot's plane are these.
    fn gravity_in(&self, [east, north, up]: [Vec3; 3]) -> Vec3 {
        east * self.gravity.x + north * self.gravity.y + up * self.gravity.z
    }

    /// How fast the foot's centre moves before the place where it touches, body axes.
    pub(super) fn rolled(&self, now: &Moment) -> Vec3 {
        now.spin.cross(self.foot.point - now.foot)
    }

    /// Acceleration of the foot's centre, body axes.
    fn centre_acceleration(&self, now: &Moment, reactions: &Reactions) -> Vec3 {
        if self.foot.is_sharp() && self.ways == 2 {
            return self.foot_acceleration(now, reactions);
        }
        let (point, turning) = (self.foot.point, self.turning(now, Some(reactions)));
        self.gravity_in(now.axes)
            + reactions.force / self.body.mass()
            + turning.cross(point)
            + now.spin.cross(now.spin.cross(point))
    }

    /// How fast the slip of the foot changes, body axes: not at all where it sticks.
    pub(super) fn foot_acceleration(&self, now: &Moment, reactions: &Reactions) -> Vec3 {
        let sticks = self.carriers.iter().any(|c| c.sticks);
        if sticks {
            return Vec3::ZERO;
        }
        let turning = self.turning(now, Some(reactions));
        let swing = now.spin.cross(now.foot) + now.foot_drift;
        let bent = turning.cross(now.foot) + now.spin.cross(swing);
        self.gravity_in(now.axes) + reactions.force / self.body.mass() + bent
    }
}
