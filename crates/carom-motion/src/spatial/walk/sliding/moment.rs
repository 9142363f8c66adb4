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
    /// Where the foot touches, from the mass centre, body axes.
    pub(in crate::spatial) foot: Vec3,
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
        let foot = self.foot - up * self.body.radius();
        let count = self.carriers.len();
        let (mut bearings, mut speeds) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for c in &self.carriers {
            let axes = if c.level { axes } else { c.then.map(|axis| turned.undo(axis)) };
            let bearing = Bearing { axes, ..Bearing::default() };
            // What touches the foot's plane lies in it: no other part of the spin moves it along.
            let arm = c.point - axes[2] * self.body.radius();
            let (turn, d) = if c.level { (up * yaw, c.point - self.foot) } else { (spin, arm - foot) };
            let own = bearing.along(slip + turn.cross(d));
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
                // As a ball rolls, its place moves along the body by ρ ω × e: of ω × (ω × arm) that leaves the point's.
                drive: gravity + free.cross(arm) + spin.cross(spin.cross(c.point)),
            });
        }
        Moment { turned, spin, axes, foot, bearings, speeds, free }
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
        let flat = |v: Vec3| along(v.dot(now.axes[0]), v.dot(now.axes[1]));
        let turning = self.turning(now, reactions);
        // No height over the foot's own plane changes with it.
        let bent = reactions.filter(|_| self.planes.len() > 1).map_or(Vec3::ZERO, |reactions| {
            flat(self.foot_acceleration(now, reactions) + self.rolled(now, turning))
        });
        let base = [along(y[7], y[8]), along(y[9], y[10]) + flat(self.rolled(now, now.spin)), bent];
        Posture { turned: now.turned, up: now.axes[2], spin: now.spin, turning, from: self.foot, base }
    }

    /// How fast the centre of the foot's ball moves before where it touches, body axes; with an angular acceleration, by how much faster.
    pub(super) fn rolled(&self, now: &Moment, spin: Vec3) -> Vec3 {
        spin.cross(now.axes[2] * self.body.radius())
    }

    /// How fast the slip of the foot changes, body axes: not at all where it sticks.
    pub(super) fn foot_acceleration(&self, now: &Moment, reactions: &Reactions) -> Vec3 {
        let sticks = self.carriers.iter().any(|c| c.sticks);
        if sticks {
            return Vec3::ZERO;
        }
        let [east, north, up] = now.axes;
        let gravity = east * self.gravity.x + north * self.gravity.y + up * self.gravity.z;
        let turning = self.turning(now, Some(reactions));
        let bent = turning.cross(now.foot) + now.spin.cross(now.spin.cross(self.foot));
        gravity + reactions.force / self.body.mass() + bent
    }
}
