//! The slips of a sliding body: how friction changes them, which is the slowest, how those that are zero start; and the forces.

use super::sliding::carriers::Carrier;
use super::sliding::moment::Moment;
use super::sliding::{DIMENSIONS, SLIP, Sliding, Slowing, Vector, YAW};
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::grip::Bearing;
use crate::tolerance::SLIPS_ACROSS;
use carom_num::{Mat3, Vec3};

impl Sliding<'_> {
    /// The slips that friction acts against.
    pub(super) fn slowing(&self, y: &Vector, rate: &Vector) -> impl Iterator<Item = Slowing> {
        let now = self.moment(y);
        let normals = self.reactions(&now).map_or_else(|| vec![0.0; self.carriers.len()], |r| r.normals);
        let [east, north, up] = now.axes;
        let (yaw, yaw_rate) = (y[YAW], rate[YAW]);
        let turning = Vec3::new(rate[4], rate[5], rate[6]);
        let own = east * rate[SLIP] + north * rate[SLIP + 1] + up * rate[SLIP + 2];
        let slipping = |(_, c): &(usize, Carrier)| !c.sticks && c.friction > 0.0;
        self.carriers.clone().into_iter().enumerate().filter(slipping).map(move |(k, c)| {
            let (d, drift) = (now.bearings[k].arm - now.foot, now.drifts[k]);
            let change = if c.level {
                own + up.cross(d) * yaw_rate - d * (yaw * yaw) + up.cross(drift) * yaw
            } else {
                own + turning.cross(d) + now.spin.cross(now.spin.cross(d) + drift)
            };
            let bearing = &now.bearings[k];
            Slowing {
                support: c.support,
                speed: now.speeds[k],
                change: bearing.toward.dot(change),
                friction: c.friction,
                normal: normals[k],
                aside: bearing.up().cross(bearing.toward),
                from_foot: d,
            }
        })
    }

    /// The slip of the foot, and the slowest of the others.
    pub(in crate::spatial) fn slowest(&self, y: &Vector) -> [f64; 2] {
        let now = self.moment(y);
        let slips = self.carriers.iter().zip(now.speeds).filter(|(c, speed)| !c.sticks && *speed > 0.0);
        slips.fold([self.scales().speed; 2], |[own, others], (c, speed)| {
            if c.is_foot { [own.min(speed), others] } else { [own, others.min(speed)] }
        })
    }

    /// How slips that are zero start, together, in units of no meaning: what is added to the motion.
    pub(super) fn starting(&self, y: &Vector) -> Option<Vector> {
        let now = self.moment(y);
        let resting = self.resting(&now);
        if self.apart {
            return self.starting_apart(&now, resting);
        }
        let (slip, yaw) = self.starting_on_one(&now, resting)?;
        let mut out = [0.0; DIMENSIONS];
        (out[SLIP], out[SLIP + 1], out[YAW]) = (slip.dot(self.frame[0]), slip.dot(self.frame[1]), yaw);
        Some(out)
    }

    /// The supports whose slips are zero and start.
    pub(super) fn resting(&self, now: &Moment) -> Supports {
        let starts = |(c, speed): &(&Carrier, &f64)| !c.sticks && **speed == 0.0 && c.lead != Vec3::ZERO;
        self.carriers.iter().zip(&now.speeds).filter(starts).map(|(c, _)| c.support).collect()
    }

    /// On several planes: the least motion in which the slips have their directions, and the speed 1 in the mean.
    ///
    /// Of all motions in which no support leaves its plane or moves across its direction it is, by the body's own mass, the one nearest to what a push on every support along its
    /// direction does.
    fn starting_apart(&self, now: &Moment, resting: Supports) -> Option<Vector> {
        if resting.is_empty() {
            return None;
        }
        let all = self.carriers.iter().zip(&now.bearings);
        let starting: Vec<&Bearing> =
            all.filter(|(c, _)| resting.contains(c.support)).map(|(_, b)| b).collect();
        let body = self.body;
        let pushed = starting.iter().fold((Vec3::ZERO, Vec3::ZERO), |(velocity, spin), b| {
            (velocity + b.toward / body.mass(), spin + body.mobility() * b.arm.cross(b.toward))
        });
        let across = |b: &&Bearing| {
            let axes = [b.up(), b.toward, b.up().cross(b.toward)];
            Bearing { axes, friction: 0.0, sticks: false, ..**b }
        };
        let across: Vec<Bearing> = starting.iter().map(across).collect();
        let (velocity, spin) = self.admissible(now, pushed, &across);
        let slips: f64 = starting.iter().map(|b| (velocity + spin.cross(b.arm)).dot(b.toward)).sum();
        let scale = starting.len() as f64 / slips;
        (slips > 0.0).then(|| self.changed(&[0.0; DIMENSIONS], velocity * scale, spin * scale, now))
    }

    /// On one plane: the foot's slip, world axes, and the turn about the normal that goes with it.
    fn starting_on_one(&self, now: &Moment, resting: Supports) -> Option<(Vec3, f64)> {
        let (mut own, mut other) = (None, None);
        for c in self.carriers.iter().filter(|c| resting.contains(c.support)) {
            if c.is_foot { own = Some(*c) } else { other = Some(*c) }
        }
        let up = now.axes[2];
        let into = |v: Vec3| now.axes[0] * v.dot(self.frame[0]) + now.axes[1] * v.dot(self.frame[1]);
        match (own, other) {
            (None, None) => None,
            (Some(foot), None) => Some((foot.lead, 0.0)),
            (own, Some(end)) => {
                let edge = end.feature.point - self.foot.point;
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

    /// True where slips can start with no acceleration and grow from there; of several supports it is taken to be so.
    ///
    /// The place of one support accelerates by `d + N W (n − μ e) = s e` in the direction e of its slip, W being the inverse mass that a force meets there and N
    /// the normal force. Where the friction that sticks comes to the edge of its cone, N and e solve this with s = 0. Just beyond, with the small changes of d, N and e, the part of
    /// it along `q = e + μ n`, which is square to `n − μ e` and to what e changes by, leaves `s (q · W⁻¹ e) = q · W⁻¹ δd`, and that is what sticking would take more than the cone holds.
    /// So s is positive where `q · W⁻¹ e` is. In the plane that has the sign of `W_nn − μ W_nt`; in space it does not, and both are needed: N has that sign.
    pub(in crate::spatial) fn starts_smoothly(&self, y: &Vector) -> bool {
        let [bearing] = &self.moment(y).bearings[..] else { return true };
        let Bearing { arm, toward, friction, .. } = *bearing;
        let answers =
            |force: Vec3| force / self.mass() + (self.body.mobility() * arm.cross(force)).cross(arm);
        let felt = Mat3::of_columns(answers(Vec3::X), answers(Vec3::Y), answers(Vec3::Z));
        let presses_out = bearing.up().dot(felt * (bearing.up() - toward * friction)) > 0.0;
        let grows = |inverse: Mat3| (toward + bearing.up() * friction).dot(inverse * toward) > 0.0;
        presses_out && felt.inverse().is_some_and(grows)
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
