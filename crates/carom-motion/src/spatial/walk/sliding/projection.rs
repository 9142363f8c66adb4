//! What keeps a body on several planes: the least motion, by the body's own mass, that takes back what the integration has let drift.

use super::super::motion::Motion;
use super::carriers::Carrier;
use super::moment::Moment;
use super::{SLIP, Sliding, Vector, WAY, YAW};
use crate::spatial::geometry::posture::Upright;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::grip::{Bearing, Grip};
use carom_num::{Rotation, Vec3};

impl Sliding<'_> {
    /// The same motion with all its supports on their planes and none of them moving along a normal; those that stick rest, and so do those that are `stopped`.
    pub(in crate::spatial) fn projected(&self, y: &Vector, stopped: Supports) -> Vector {
        let placed = self.placed(y);
        let now = self.moment(&placed);
        let slip = now.slip;
        let drive = |b: &Bearing, _: usize| slip + now.spin.cross(b.arm - now.foot);
        self.moved(&placed, &self.bearings(&now, stopped, drive), &now)
    }

    /// The same, with the heights taken back.
    fn placed(&self, y: &Vector) -> Vector {
        let now = self.moment(y);
        let at = self.posture_of(y, &now, None);
        let height = |b: &Bearing, k: usize| {
            let Carrier { support, feature, frame, then, .. } = self.carriers[k];
            let gap = match self.world.pair(support) {
                Some(pair) => pair.meeting(self.moving(&at).state.pose()).gap,
                None => at.height(&Upright { normal: frame[2], then: then[2] }, &feature, 0.0).value,
            };
            b.up() * gap
        };
        let mut bearings = self.bearings(&now, Supports::NONE, height);
        bearings.iter_mut().for_each(|b| b.sticks = false);
        let (moved, turn) = self.answered(&bearings);
        let gone = moved + turn.cross(self.foot.point);
        let turned = now.turned.after(Rotation::by(turn));
        let turned = Rotation::of(turned.to_array()).unwrap_or(turned);
        let mut out = *y;
        out[..4].copy_from_slice(&turned.to_array());
        (0..self.ways).for_each(|k| out[WAY + k] += gone.dot(now.axes[k]));
        out
    }

    /// The carriers without friction, and what they have to take away.
    pub(in crate::spatial) fn bearings(
        &self,
        now: &Moment,
        stopped: Supports,
        drive: impl Fn(&Bearing, usize) -> Vec3,
    ) -> Vec<Bearing> {
        let of = |(k, (b, c)): (usize, (&Bearing, &Carrier))| {
            let sticks = c.sticks || stopped.contains(c.support);
            Bearing { sticks, friction: 0.0, drive: drive(b, k), ..*b }
        };
        now.bearings.iter().zip(&self.carriers).enumerate().map(of).collect()
    }

    /// How the mass centre and the body answer impulses that take the drives away: velocity and spin, body axes.
    fn answered(&self, bearings: &[Bearing]) -> (Vec3, Vec3) {
        Grip { body: self.body, bearings }.taken_back()
    }

    /// The motion after impulses that take the drives away.
    pub(in crate::spatial) fn moved(&self, y: &Vector, bearings: &[Bearing], now: &Moment) -> Vector {
        let (velocity, spin) = self.answered(bearings);
        self.changed(y, velocity, spin, now)
    }

    /// The motion with another velocity of the mass centre and another spin, body axes: by so much.
    pub(in crate::spatial) fn changed(&self, y: &Vector, velocity: Vec3, spin: Vec3, now: &Moment) -> Vector {
        let slip = velocity + spin.cross(now.foot);
        let mut out = *y;
        for (k, change) in [(4, spin.x), (5, spin.y), (6, spin.z)] {
            out[k] += change;
        }
        (0..self.ways).for_each(|k| out[SLIP + k] += slip.dot(now.axes[k]));
        out[YAW] += spin.dot(now.axes[2]);
        out
    }

    /// Rates at which these supports do not accelerate along their planes either.
    pub(in crate::spatial) fn held_back(&self, y: &Vector, rate: &Vector, resting: Supports) -> Vector {
        let now = self.moment(y);
        let own = (0..self.ways).fold(Vec3::ZERO, |sum, k| sum + now.axes[k] * rate[SLIP + k]);
        let turning = Vec3::new(rate[4], rate[5], rate[6]);
        let drive = |b: &Bearing, k: usize| {
            let d = b.arm - now.foot;
            own + turning.cross(d) + now.spin.cross(now.spin.cross(d) + now.drifts[k])
        };
        self.moved(rate, &self.bearings(&now, resting, drive), &now)
    }

    /// What a motion of the whole body leaves of itself, velocity and spin, where no support may leave its plane, none that sticks may move, and none of `others` along its normal.
    pub(in crate::spatial) fn admissible(
        &self,
        now: &Moment,
        (velocity, spin): (Vec3, Vec3),
        others: &[Bearing],
    ) -> (Vec3, Vec3) {
        let moved = |b: &Bearing| velocity + spin.cross(b.arm);
        let mut bearings = self.bearings(now, Supports::NONE, |b, _| moved(b));
        bearings.extend(others.iter().map(|b| Bearing { drive: moved(b), ..*b }));
        let (taken, turn) = self.answered(&bearings);
        (velocity + taken, spin + turn)
    }
}
