//! A sliding body at one instant: what each support does, and how the body answers.

use super::{Sliding, Vector};
use crate::spatial::geometry::posture::Posture;
use crate::spatial::modes::grip::{Bearing, Grip, Reactions};
use carom_num::{Rotation, Vec3};

/// The body at one instant.
pub(in crate::spatial) struct Moment {
    pub(in crate::spatial) turned: Rotation,
    pub(in crate::spatial) spin: Vec3,
    /// The tangents and the normal of the foot's plane, body axes.
    pub(in crate::spatial) axes: [Vec3; 3],
    pub(in crate::spatial) bearings: Vec<Bearing>,
    /// Slip speeds \[m/s\].
    pub(in crate::spatial) speeds: Vec<f64>,
    /// Angular acceleration of the free body.
    free: Vec3,
}

impl Sliding {
    pub(in crate::spatial) fn moment(&self, y: &Vector) -> Moment {
        let turned = Rotation { w: y[0], v: Vec3::new(y[1], y[2], y[3]) };
        let turned = Rotation::of(turned.to_array()).unwrap_or(turned);
        let (spin, yaw) = (Vec3::new(y[4], y[5], y[6]), y[12]);
        let axes = self.axes.map(|axis| turned.undo(axis));
        let [east, north, up] = axes;
        let spin = spin + up * (yaw - up.dot(spin));
        let gravity = east * self.gravity.x + north * self.gravity.y + up * self.gravity.z;
        let free = self.body.mobility() * -spin.cross(self.body.inertia() * spin);
        let slip = east * y[9] + north * y[10];
        let count = self.carriers.len();
        let (mut bearings, mut speeds) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for c in &self.carriers {
            let axes = if c.level { axes } else { c.then.map(|axis| turned.undo(axis)) };
            let bearing = Bearing { axes, ..Bearing::default() };
            // What touches the foot's plane lies in it: no other part of the spin moves it along.
            let turn = if c.level { up * yaw } else { spin };
            let own = bearing.along(slip + turn.cross(c.arm - self.foot));
            let lead = axes[0] * c.frame[0].dot(c.lead) + axes[1] * c.frame[1].dot(c.lead);
            // On several planes a slip that is to start is never zero to the last digit.
            let own =
                if self.apart && lead != Vec3::ZERO && own.norm() <= self.speck { Vec3::ZERO } else { own };
            speeds.push(own.norm());
            bearings.push(Bearing {
                arm: c.arm,
                axes,
                friction: c.friction,
                sticks: c.sticks,
                toward: if c.sticks { Vec3::ZERO } else { own.unit().unwrap_or(lead) },
                drive: gravity + free.cross(c.arm) + spin.cross(spin.cross(c.arm)),
            });
        }
        Moment { turned, spin, axes, bearings, speeds, free }
    }

    pub(in crate::spatial) fn reactions(&self, now: &Moment) -> Option<Reactions> {
        Grip { body: &self.body, bearings: &now.bearings }.reactions()
    }

    pub(super) fn turning(&self, now: &Moment, reactions: Option<&Reactions>) -> Vec3 {
        now.free + reactions.map_or(Vec3::ZERO, |r| self.body.mobility() * r.moment)
    }

    /// The instant as the search of events sees it.
    pub(super) fn posture_of(&self, y: &Vector, now: &Moment, reactions: Option<&Reactions>) -> Posture {
        let along = |a: f64, b: f64| self.frame[0] * a + self.frame[1] * b;
        // No height over the foot's own plane changes with it.
        let bent = reactions.filter(|_| self.planes.len() > 1).map_or(Vec3::ZERO, |reactions| {
            let own = self.foot_acceleration(now, reactions);
            along(own.dot(now.axes[0]), own.dot(now.axes[1]))
        });
        let (turning, base) = (self.turning(now, reactions), [along(y[7], y[8]), along(y[9], y[10]), bent]);
        Posture { turned: now.turned, up: now.axes[2], spin: now.spin, turning, from: self.foot, base }
    }

    /// Acceleration of the foot, body axes: none where it sticks.
    pub(super) fn foot_acceleration(&self, now: &Moment, reactions: &Reactions) -> Vec3 {
        let sticks = self.carriers.iter().any(|c| c.sticks);
        if sticks { Vec3::ZERO } else { self.acceleration(now, reactions, self.foot) }
    }

    /// Acceleration of a point of the body, body axes.
    pub(super) fn acceleration(&self, now: &Moment, reactions: &Reactions, arm: Vec3) -> Vec3 {
        let [east, north, up] = now.axes;
        let gravity = east * self.gravity.x + north * self.gravity.y + up * self.gravity.z;
        let turning = self.turning(now, Some(reactions));
        let bent = turning.cross(arm) + now.spin.cross(now.spin.cross(arm));
        gravity + reactions.force / self.body.mass() + bent
    }
}
