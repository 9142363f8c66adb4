//! Bodies that touch, under forces: the rate problem of motion at one instant.
//!
//! The clock is time. The drive of a contact is what it would do without contact forces: its slip acceleration and its normal
//! acceleration. With the contact forces `f`, `w = drive + W f`.
//!
//! ```text
//! a = F/m    α = M/J    a_P = a + α × r − ω² r
//! drive_t = t·(a_P − a_Q)    drive_n = n·(a_P − a_Q) − 2 ω_Q u_t
//! ```
//!
//! P is a point of the body that the normal points into, Q the point under it of a straight face of the other. The last term is the face's:
//! it turns with ω_Q while P slips along it with u_t.

use super::answer::{Answer, Broken, Guess};
use super::rate::{MOST_EXAMINED, RateProblem};
use crate::ImpactError;
use crate::Load;
use crate::error::{outside, require};
use crate::planar::contacts::bodies::Meeting;
use crate::planar::contacts::bodies::RigidBody;
use crate::planar::contacts::bodies::check;
use crate::planar::contacts::set::ContactSet;
use crate::tolerance::TOUCHING_VELOCITY;
use carom_num::Vec2;

/// The force at the mass centre of a body, and the torque about it, its weight included.
///
/// # Example
/// The weight of 2 kg.
/// ```
/// use carom_impact::planar::forces::Applied;
/// use carom_num::Vec2;
/// let weight = Applied { force: Vec2::new(0.0, -9.81) * 2.0, torque: 0.0 };
/// assert_eq!(weight.force.y, -19.62);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Applied {
    /// Force [N].
    pub force: Vec2,
    /// Torque [N m], counter-clockwise.
    pub torque: f64,
}

/// How the velocity of a body changes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Acceleration {
    /// Of the mass centre [m/s²].
    pub centre: Vec2,
    /// Of the spin [rad/s²], counter-clockwise.
    pub spin: f64,
}

/// Bodies that touch, under forces.
///
/// # Limits
/// Each contact is a point of one body on a straight face of the other, as [`ContactSet::of_bodies`] has them. Velocities along the
/// normal, and slips, below 1e-9 of the velocities at the contact are zero.
///
/// # Example
/// A block of 2 kg on a floor, pulled with 8 N against friction 1/2: of its weight, 20 N, friction takes 10 N, and it sticks.
/// ```
/// use carom_impact::planar::forces::{Applied, Loaded};
/// use carom_impact::planar::{Meeting, RigidBody, Slip};
/// use carom_num::Vec2;
/// let block = RigidBody { mass: 2.0, inertia: 1.0, ..RigidBody::FIXED };
/// let floor = Meeting {
///     into: 0, out_of: 1, point: Vec2::ZERO, normal: Vec2::new(0.0, 1.0), friction: 0.5, restitution: 0.0,
/// };
/// let pulled = Applied { force: Vec2::new(8.0, -20.0), torque: 0.0 };
/// let bodies = [block, RigidBody::FIXED];
/// let loaded = Loaded::<1, 2>::new(&bodies, &[floor], &[pulled, Applied::default()])?;
/// let answer = loaded.solve(&mut |_, _| {});
/// let solution = answer.solutions[0].unwrap();
/// assert_eq!((answer.count, solution.guess[0].slip, solution.rates[0]), (1, Slip::Sticks, [-8.0, 20.0]));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Loaded<const N: usize, const M: usize> {
    /// Velocities, friction and operator of the contacts.
    pub set: ContactSet<N, M>,
    /// Slip and normal acceleration of each contact without contact forces [m/s²].
    pub drive: [[f64; 2]; N],
    /// Contacts that touch: the others separate.
    pub touching: [bool; N],
}

impl<const N: usize, const M: usize> Loaded<N, M> {
    /// Bodies that meet, each with what is applied to it.
    ///
    /// # Errors
    /// As [`ContactSet::of_bodies`] and [`ContactSet::check`]; [`ImpactError::OutsideDomain`] for a force or torque that is no number,
    /// or for a contact that approaches: that is an impact.
    ///
    /// # Example
    /// What approaches is no matter of forces.
    /// ```
    /// use carom_impact::planar::forces::{Applied, Loaded};
    /// use carom_impact::planar::{Meeting, RigidBody};
    /// use carom_num::Vec2;
    /// let ball = RigidBody { mass: 1.0, inertia: 0.4, velocity: Vec2::new(0.0, -2.0), ..RigidBody::FIXED };
    /// let floor = Meeting {
    ///     into: 0, out_of: 1, point: Vec2::ZERO, normal: Vec2::new(0.0, 1.0), friction: 0.5, restitution: 0.0,
    /// };
    /// let none = [Applied::default(); 2];
    /// let refused = Loaded::<1, 2>::new(&[ball, RigidBody::FIXED], &[floor], &none).unwrap_err();
    /// assert_eq!(refused.to_string(), "normal velocity of contact 0 is -2, allowed is 0 or more: an approach is an impact");
    /// ```
    pub fn new(bodies: &[RigidBody], meetings: &[Meeting], applied: &[Applied]) -> Result<Self, ImpactError> {
        let mut set = ContactSet::of_bodies(bodies, meetings)?;
        set.check()?;
        for (force, quantity) in applied
            .iter()
            .flat_map(|a| [(a.force.x, "force x"), (a.force.y, "force y"), (a.torque, "torque")])
        {
            require(force.is_finite(), || outside(None, quantity, force, "a finite number"))?;
        }
        let (mut drive, mut touching) = ([[0.0; 2]; N], [false; N]);
        let free = free(bodies, applied);
        for (i, m) in meetings.iter().enumerate() {
            let [into, out_of] = [&bodies[m.into], &bodies[m.out_of]];
            let speeds =
                [into, out_of].map(|b| b.velocity.norm() + b.spin.abs() * (m.point - b.centre).norm());
            let still = TOUCHING_VELOCITY * (speeds[0] + speeds[1]);
            require(set.normal[i] >= -still, || {
                outside(Some(i), "normal velocity", set.normal[i], "0 or more: an approach is an impact")
            })?;
            touching[i] = set.normal[i] <= still;
            if touching[i] {
                set.normal[i] = 0.0;
            }
            // Before the drive is made: its turning term must not take rounding for a slip.
            if set.slip[i].abs() <= still {
                set.slip[i] = 0.0;
            }
            let n = m.normal / m.normal.norm();
            let apart = at(into, &free[m.into], m.point) - at(out_of, &free[m.out_of], m.point);
            drive[i] = [n.turned_right().dot(apart), n.dot(apart) - 2.0 * out_of.spin * set.slip[i]];
        }
        Ok(Self { set, drive, touching })
    }

    /// Every consistent motion; each other hypothesis goes to `reject` with the inequality that it breaks most.
    ///
    /// The solutions' rates are forces [N], their responses accelerations (slip, normal) [m/s²].
    pub fn solve(&self, reject: &mut impl FnMut(&[Guess; N], Broken)) -> Answer<N> {
        let problem = self.problem();
        if self.set.count > MOST_EXAMINED { problem.solve() } else { problem.solve_observed(reject) }
    }

    /// The rate problem itself, for asking hypotheses one by one.
    pub fn problem(&self) -> RateProblem<'_, N, M> {
        RateProblem {
            count: self.set.count,
            operator: &self.set.operator,
            friction: &self.set.friction,
            drive: self.drive,
            slip: self.set.slip,
            load: self.touching.map(|touches| if touches { Load::Touching(0.0) } else { Load::Absent }),
        }
    }
}

/// What the bodies do under what is applied to them and under contact forces (tangential, normal) [N].
///
/// # Errors
/// As [`ContactSet::of_bodies`]; [`ImpactError::OutsideDomain`] for a force that is no number.
pub fn accelerations(
    bodies: &[RigidBody],
    meetings: &[Meeting],
    applied: &[Applied],
    forces: &[[f64; 2]],
) -> Result<Vec<Acceleration>, ImpactError> {
    check(bodies, meetings)?;
    let mut out = free(bodies, applied);
    for (i, (m, force)) in meetings.iter().zip(forces).enumerate() {
        for value in force {
            require(value.is_finite(), || outside(Some(i), "force", *value, "a finite number"))?;
        }
        let n = m.normal / m.normal.norm();
        let on_into = n.turned_right() * force[0] + n * force[1];
        for (body, f) in [(m.into, on_into), (m.out_of, -on_into)] {
            let b = &bodies[body];
            out[body].centre += f / b.mass;
            out[body].spin += (m.point - b.centre).cross(f) / b.inertia;
        }
    }
    Ok(out)
}

/// Of every body without contact forces; nothing accelerates a body of infinite mass.
fn free(bodies: &[RigidBody], applied: &[Applied]) -> Vec<Acceleration> {
    let of = |(i, b): (usize, &RigidBody)| {
        let Applied { force, torque } = applied.get(i).copied().unwrap_or_default();
        Acceleration { centre: force / b.mass, spin: torque / b.inertia }
    };
    bodies.iter().enumerate().map(of).collect()
}

/// The acceleration of a body's point.
fn at(body: &RigidBody, acceleration: &Acceleration, point: Vec2) -> Vec2 {
    let r = point - body.centre;
    acceleration.centre + r.turned_left() * acceleration.spin - r * (body.spin * body.spin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_num::elementary::sin_cos;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    /// A body under constant accelerations: centre, angle, velocity and spin after so long.
    fn later(body: &RigidBody, by: &Acceleration, time: f64) -> (Vec2, f64, Vec2, f64) {
        let centre = body.centre + body.velocity * time + by.centre * (0.5 * time * time);
        let angle = body.spin * time + 0.5 * by.spin * time * time;
        (centre, angle, body.velocity + by.centre * time, body.spin + by.spin * time)
    }

    fn turned(v: Vec2, angle: f64) -> Vec2 {
        let (sin, cos) = sin_cos(angle);
        Vec2::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
    }

    #[test]
    fn the_drive_is_the_second_derivative_of_the_gap_and_the_first_of_the_slip() {
        for seed in 0..200 {
            let mut rng = Pcg64::seed_from_u64(seed);
            let mut number = || rng.random_range(-1.0..1.0);
            let mut body = |mass: f64| RigidBody {
                mass,
                inertia: 0.3 * mass,
                centre: Vec2::new(number(), number()),
                velocity: Vec2::new(number(), number()),
                spin: number(),
            };
            let mut bodies = [body(1.3), body(0.7)];
            let (point, normal) = (Vec2::new(number(), number()), Vec2::new(number(), number()));
            let m = Meeting { into: 0, out_of: 1, point, normal, friction: 0.0, restitution: 0.0 };
            let n = normal / normal.norm();
            // The first body is moved along the normal so that the contact neither opens nor closes.
            let apart = n.dot(bodies[0].velocity_at(point) - bodies[1].velocity_at(point));
            bodies[0].velocity -= n * apart;
            let mut apply = || Applied { force: Vec2::new(number(), number()), torque: number() };
            let applied = [apply(), apply()];
            let loaded = Loaded::<1, 2>::new(&bodies, &[m], &applied).unwrap();
            let by = free(&bodies, &applied);
            let arms = [0, 1].map(|k| point - bodies[k].centre);
            // Gap and slip at a time: P goes with the first body, the face with the second.
            let seen = |time: f64| {
                let (c, angle, v, spin) = later(&bodies[0], &by[0], time);
                let (face_c, face_angle, face_v, face_spin) = later(&bodies[1], &by[1], time);
                let (p, on_face) = (c + turned(arms[0], angle), face_c + turned(arms[1], face_angle));
                let n = turned(n, face_angle);
                let v_p = v + (p - c).turned_left() * spin;
                let v_q = face_v + (p - face_c).turned_left() * face_spin;
                (n.dot(p - on_face), n.turned_right().dot(v_p - v_q))
            };
            let h = 1e-4;
            let ((before, slip_before), (now, _), (after, slip_after)) = (seen(-h), seen(0.0), seen(h));
            let normal = (before - 2.0 * now + after) / (h * h);
            let slip = (slip_after - slip_before) / (2.0 * h);
            let [drive_t, drive_n] = loaded.drive[0];
            // Differences lose half the digits.
            assert!((normal - drive_n).abs() < 1e-6, "{seed}: normal {normal} {drive_n}");
            assert!((slip - drive_t).abs() < 1e-6, "{seed}: slip {slip} {drive_t}");
        }
    }
}
