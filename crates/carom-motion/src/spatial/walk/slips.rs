//! The slips of a sliding body: how friction changes them, which is the slowest, how those that are zero start; and the forces.

use super::sliding::{Carrier, Sliding, Slowing, Vector};
use crate::spatial::modes::grip::MOST_BEARING;
use crate::tolerance::SLIPS_ACROSS;
use carom_num::Vec3;

impl Sliding {
    /// The slips that friction acts against.
    pub(super) fn slowing(&self, y: &Vector, rate: &Vector) -> impl Iterator<Item = Slowing> {
        let now = self.moment(y);
        let normals = self.reactions(&now).map_or([0.0; MOST_BEARING], |r| r.normals);
        let [east, north, up] = now.axes;
        let (yaw, yaw_rate) = (y[12], rate[12]);
        let own = east * rate[9] + north * rate[10];
        let foot = self.foot;
        let slipping = |(_, c): &(usize, Carrier)| !c.sticks && c.friction > 0.0;
        self.carriers.clone().into_iter().enumerate().filter(slipping).map(move |(k, c)| {
            let d = c.arm - foot;
            let change = own + up.cross(d) * yaw_rate - d * (yaw * yaw);
            let into_world = |v: Vec3| Vec3::new(v.dot(east), v.dot(north), 0.0);
            Slowing {
                support: c.support,
                speed: now.speeds[k],
                change: now.bearings[k].toward.dot(change),
                friction: c.friction,
                normal: normals[k],
                aside: into_world(up.cross(now.bearings[k].toward)),
                from_foot: into_world(d),
            }
        })
    }

    /// The slip of the foot, and the slowest of the others.
    pub(in crate::spatial) fn slowest(&self, y: &Vector) -> [f64; 2] {
        let now = self.moment(y);
        let slips = self.carriers.iter().zip(now.speeds).filter(|(c, speed)| !c.sticks && *speed > 0.0);
        slips.fold([self.scales().speed; 2], |[own, others], (c, speed)| {
            if c.arm == self.foot { [own.min(speed), others] } else { [own, others.min(speed)] }
        })
    }

    /// How slips that are zero start, together: the foot's, world axes, and the turn about the normal that goes with it; in units of no meaning.
    pub(super) fn starting(&self, y: &Vector) -> Option<(Vec3, f64)> {
        let now = self.moment(y);
        let rests = |(k, c): &(usize, &Carrier)| !c.sticks && now.speeds[*k] == 0.0 && c.lead != Vec3::ZERO;
        let (mut own, mut other) = (None, None);
        for (_, c) in self.carriers.iter().enumerate().filter(rests) {
            if c.arm == self.foot { own = Some(*c) } else { other = Some(*c) }
        }
        let up = now.axes[2];
        let into = |v: Vec3| now.axes[0] * v.x + now.axes[1] * v.y;
        match (own, other) {
            (None, None) => None,
            (Some(foot), None) => Some((foot.lead, 0.0)),
            (own, Some(end)) => {
                let edge = end.arm - self.foot;
                let along = edge.unit()?;
                let (far, near) = (into(end.lead), own.map_or(Vec3::ZERO, |c| into(c.lead)));
                let (there, here) = (along.dot(far), along.dot(near));
                // A rigid edge keeps its length; where both ends slip across it, nothing says more.
                let share = match own {
                    None => 0.0,
                    Some(_) if here.abs() <= SLIPS_ACROSS => 1.0,
                    Some(_) => there / here,
                };
                let yaw = up.dot(along.cross(far - near * share)) / edge.norm();
                Some((own.map_or(Vec3::ZERO, |c| c.lead * share), yaw))
            }
        }
    }

    /// The forces on the carriers, world axes.
    pub(in crate::spatial) fn forces(&self, y: &Vector) -> Option<Vec<(usize, Vec3)>> {
        let now = self.moment(y);
        let reactions = self.reactions(&now)?;
        let whole = self.attitude.after(now.turned);
        let of = |(k, c): (usize, &Carrier)| (c.support, whole.apply(reactions.forces[k]));
        Some(self.carriers.iter().enumerate().map(of).collect())
    }
}
