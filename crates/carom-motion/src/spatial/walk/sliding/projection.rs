//! What keeps a body on several planes: the least motion, by the body's own mass, that takes back what the integration has let drift.

use super::{Sliding, Vector};
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::grip::{Bearing, Grip};
use carom_num::{Rotation, Vec3};

impl Sliding {
    /// The same motion with all its supports on their planes and none of them moving along a normal; those that stick rest, and so do those that are `stopped`.
    pub(in crate::spatial) fn projected(&self, y: &Vector, stopped: Supports) -> Vector {
        let placed = self.placed(y);
        let now = self.moment(&placed);
        let drive = |b: &Bearing, _: usize| self.velocity(&placed, b.arm);
        self.moved(&placed, &self.bearings(&placed, stopped, drive), now.axes)
    }

    /// The same, with the heights taken back.
    fn placed(&self, y: &Vector) -> Vector {
        let at = super::Motion::posture(self, y, 0.0);
        let height = |b: &Bearing, k: usize| {
            let upright =
                super::Upright { normal: self.carriers[k].frame[2], then: self.carriers[k].then[2] };
            b.up() * at.height(&upright, b.arm, 0.0).value
        };
        let mut bearings = self.bearings(y, Supports::NONE, height);
        bearings.iter_mut().for_each(|b| b.sticks = false);
        let grip = Grip { body: &self.body, bearings: &bearings };
        let Some(shift) = grip.corrections() else { return *y };
        let turn = self.body.mobility() * shift.moment;
        let gone = shift.force / self.body.mass() + turn.cross(self.foot);
        let now = self.moment(y);
        let turned = now.turned.after(Rotation::by(turn));
        let turned = Rotation::of(turned.to_array()).unwrap_or(turned);
        let mut out = *y;
        out[..4].copy_from_slice(&turned.to_array());
        out[7] += gone.dot(now.axes[0]);
        out[8] += gone.dot(now.axes[1]);
        out
    }

    /// The carriers without friction, and what they have to take away.
    pub(in crate::spatial) fn bearings(
        &self,
        y: &Vector,
        stopped: Supports,
        drive: impl Fn(&Bearing, usize) -> Vec3,
    ) -> Vec<Bearing> {
        let mut bearings = self.moment(y).bearings;
        for (k, c) in self.carriers.iter().enumerate() {
            let sticks = c.sticks || stopped.contains(c.support);
            let drive = drive(&bearings[k], k);
            bearings[k] = Bearing { sticks, friction: 0.0, drive, ..bearings[k] };
        }
        bearings
    }

    /// Velocity of a point, body axes.
    fn velocity(&self, y: &Vector, arm: Vec3) -> Vec3 {
        let now = self.moment(y);
        now.axes[0] * y[9] + now.axes[1] * y[10] + now.spin.cross(arm - self.foot)
    }

    /// The motion after impulses that take the drives away.
    pub(in crate::spatial) fn moved(&self, y: &Vector, bearings: &[Bearing], axes: [Vec3; 3]) -> Vector {
        let grip = Grip { body: &self.body, bearings };
        let Some(push) = grip.corrections() else { return *y };
        let spin = self.body.mobility() * push.moment;
        self.changed(y, push.force / self.body.mass(), spin, axes)
    }

    /// The motion with another velocity of the mass centre and another spin, body axes: by so much.
    pub(in crate::spatial) fn changed(
        &self,
        y: &Vector,
        velocity: Vec3,
        spin: Vec3,
        axes: [Vec3; 3],
    ) -> Vector {
        let slip = velocity + spin.cross(self.foot);
        let mut out = *y;
        for (k, change) in [(4, spin.x), (5, spin.y), (6, spin.z)] {
            out[k] += change;
        }
        for (k, axis) in [(9, axes[0]), (10, axes[1])] {
            out[k] += slip.dot(axis);
        }
        out[12] += spin.dot(axes[2]);
        out
    }

    /// Rates at which these supports do not accelerate along their planes either.
    pub(in crate::spatial) fn held_back(&self, y: &Vector, rate: &Vector, resting: Supports) -> Vector {
        let now = self.moment(y);
        let own = now.axes[0] * rate[9] + now.axes[1] * rate[10];
        let turning = Vec3::new(rate[4], rate[5], rate[6]);
        let drive = |b: &Bearing, _: usize| {
            let d = b.arm - self.foot;
            own + turning.cross(d) + now.spin.cross(now.spin.cross(d))
        };
        self.moved(rate, &self.bearings(y, resting, drive), now.axes)
    }

    /// What a change of the motion leaves of itself where no support may leave its plane, and none that sticks may move.
    pub(in crate::spatial) fn admissible(&self, y: &Vector, velocity: Vec3, spin: Vec3) -> (Vec3, Vec3) {
        let drive = |b: &Bearing, _: usize| velocity + spin.cross(b.arm);
        let bearings = self.bearings(y, Supports::NONE, drive);
        let grip = Grip { body: &self.body, bearings: &bearings };
        grip.corrections().map_or((Vec3::ZERO, Vec3::ZERO), |push| {
            (velocity + push.force / self.body.mass(), spin + self.body.mobility() * push.moment)
        })
    }
}
