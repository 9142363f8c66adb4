//! Several bodies that meet: their contacts as one set, and their velocities after it.

use super::set::Block;
use super::set::ContactSet;
use crate::ImpactError;
use crate::faults::{Faults, Quantity};
use crate::tolerance::COINCIDE;
use carom_num::Vec2;

/// A rigid body in the plane at one instant. With infinite mass and inertia it is fixed, or moves on unchanged whatever strikes it.
///
/// # Example
/// Two bodies of 2 kg that meet head on: `W_nn = 1/2 + 1/2`.
/// ```
/// use carom_impact::planar::{Meeting, ContactSet2, RigidBody};
/// use carom_num::Vec2;
/// let velocity = Vec2::new(3.0, 0.0);
/// let left = RigidBody { mass: 2.0, inertia: 0.5, centre: Vec2::ZERO, velocity, spin: 0.0 };
/// let right = RigidBody { centre: Vec2::new(2.0, 0.0), velocity: Vec2::ZERO, ..left };
/// let (point, normal) = (Vec2::new(1.0, 0.0), Vec2::new(1.0, 0.0));
/// let meeting = Meeting { into: 1, out_of: 0, point, normal, friction: 0.0, restitution: 1.0 };
/// assert_eq!(ContactSet2::of_bodies(&[left, right], &[meeting])?.operator[0][0].nn, 1.0);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody {
    /// Mass [kg], > 0; infinite for a body that does not yield.
    pub mass: f64,
    /// Moment of inertia about the mass centre [kg m²], > 0; infinite for a body that does not turn.
    pub inertia: f64,
    /// Mass centre [m], world frame.
    pub centre: Vec2,
    /// Velocity of the mass centre [m/s].
    pub velocity: Vec2,
    /// Spin [rad/s], counter-clockwise.
    pub spin: f64,
}

impl RigidBody {
    /// A body that nothing moves.
    pub const FIXED: Self = Self {
        mass: f64::INFINITY,
        inertia: f64::INFINITY,
        centre: Vec2::ZERO,
        velocity: Vec2::ZERO,
        spin: 0.0,
    };

    /// Velocity of the body's point at `point` [m/s].
    ///
    /// # Example
    /// A wheel of radius 0.5 m that rolls: its lowest point rests, its highest has twice the speed.
    /// ```
    /// use carom_impact::planar::RigidBody;
    /// use carom_num::Vec2;
    /// let wheel = RigidBody { velocity: Vec2::new(1.0, 0.0), spin: -2.0, ..RigidBody::FIXED };
    /// assert_eq!(wheel.velocity_at(Vec2::new(0.0, -0.5)), Vec2::ZERO);
    /// assert_eq!(wheel.velocity_at(Vec2::new(0.0, 0.5)), Vec2::new(2.0, 0.0));
    /// ```
    pub fn velocity_at(&self, point: Vec2) -> Vec2 {
        self.velocity + (point - self.centre).turned_left() * self.spin
    }

    /// Kinetic energy [J]; 0 for a body that nothing moves.
    ///
    /// # Example
    /// 2 · 5²/2 + 0.5 · 2²/2.
    /// ```
    /// use carom_impact::planar::RigidBody;
    /// use carom_num::Vec2;
    /// let (centre, velocity) = (Vec2::ZERO, Vec2::new(3.0, 4.0));
    /// assert_eq!(RigidBody { mass: 2.0, inertia: 0.5, centre, velocity, spin: 2.0 }.energy(), 26.0);
    /// ```
    pub fn energy(&self) -> f64 {
        let half = |m: f64, u2: f64| if m.is_finite() { 0.5 * m * u2 } else { 0.0 };
        half(self.mass, self.velocity.dot(self.velocity)) + half(self.inertia, self.spin * self.spin)
    }
}

/// A point where two bodies meet.
///
/// # Example
/// The first body comes with 3 m/s along the normal: the contact approaches with that.
/// ```
/// use carom_impact::planar::{Meeting, ContactSet2, RigidBody};
/// use carom_num::Vec2;
/// let wall = RigidBody { centre: Vec2::new(2.0, 0.0), ..RigidBody::FIXED };
/// let ball = RigidBody { mass: 1.0, inertia: 0.4, velocity: Vec2::new(3.0, 0.5), ..RigidBody::FIXED };
/// let (point, normal) = (Vec2::new(1.0, 0.0), Vec2::new(-1.0, 0.0));
/// let meeting = Meeting { into: 1, out_of: 0, point, normal, friction: 0.0, restitution: 1.0 };
/// assert_eq!(ContactSet2::of_bodies(&[wall, ball], &[meeting])?.normal[0], -3.0);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// Number of the body the normal points into.
    pub into: usize,
    /// Number of the body the normal points out of.
    pub out_of: usize,
    /// The point [m], world frame.
    pub point: Vec2,
    /// Normal, of any length above 0.
    pub normal: Vec2,
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}

/// A unit impulse along one axis of a meeting: on the first body `+`, on the second `−`.
#[derive(Clone, Copy)]
struct Pull {
    direction: Vec2,
    moments: [f64; 2],
}

fn pull(bodies: &[RigidBody], m: &Meeting, direction: Vec2) -> Pull {
    let moment = |body: usize| (m.point - bodies[body].centre).cross(direction);
    Pull { direction, moments: [moment(m.into), moment(m.out_of)] }
}

/// What a unit impulse of `b` at its meeting does to the velocity along `a` at its own.
fn response(bodies: &[RigidBody], (ma, a): (&Meeting, Pull), (mb, b): (&Meeting, Pull)) -> f64 {
    let mut sum = 0.0;
    for (i, sign_a) in [(ma.into, 1.0), (ma.out_of, -1.0)] {
        for (j, sign_b) in [(mb.into, 1.0), (mb.out_of, -1.0)] {
            if i == j {
                let own = a.moments[usize::from(sign_a < 0.0)] * b.moments[usize::from(sign_b < 0.0)];
                sum += sign_a
                    * sign_b
                    * (a.direction.dot(b.direction) / bodies[i].mass + own / bodies[i].inertia);
            }
        }
    }
    sum
}

impl<const N: usize, const M: usize> ContactSet<N, M> {
    /// The contacts of several bodies, free, fixed or moved.
    ///
    /// # Errors
    /// [`ImpactError::TooMany`] where they do not fit. [`ImpactError::OutsideDomain`] unless masses and inertias are above 0, the bodies of
    /// each meeting exist and differ, and normals have a length; [`ImpactError::Faults`] lists several such numbers.
    /// [`ImpactError::Coincide`] for two meetings of the same bodies at one point with one normal. Friction and restitution are checked
    /// where the set is resolved.
    ///
    /// # Example
    /// A ball of 1 kg meets one of 2 kg that rests: `W_nn = 1 + 1/2`.
    /// ```
    /// use carom_impact::{Law, planar::{ContactSet2, Meeting, RigidBody, staged, struck}};
    /// use carom_num::Vec2;
    /// let ball = |mass, x, v| RigidBody {
    ///     mass, inertia: 1.0, centre: Vec2::new(x, 0.0), velocity: Vec2::new(v, 0.0), spin: 0.0,
    /// };
    /// let bodies = [ball(1.0, 0.0, 3.0), ball(2.0, 2.0, 0.0)];
    /// let meeting = Meeting {
    ///     into: 1, out_of: 0, point: Vec2::new(1.0, 0.0), normal: Vec2::new(1.0, 0.0), friction: 0.0, restitution: 1.0,
    /// };
    /// let set = ContactSet2::of_bodies(&bodies, &[meeting])?;
    /// assert_eq!((set.operator[0][0].nn, set.normal[0]), (1.5, -3.0));
    /// let out = staged::resolve(&set, Law::Poisson)?;
    /// let after = struck(&bodies, &[meeting], &out.impulse)?;
    /// assert!((after[0].velocity.x + 1.0).abs() < 1e-15 && (after[1].velocity.x - 2.0).abs() < 1e-15);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn of_bodies(bodies: &[RigidBody], meetings: &[Meeting]) -> Result<Self, ImpactError> {
        if meetings.len() > N {
            return Err(ImpactError::TooMany { count: meetings.len(), most: N });
        }
        check(bodies, meetings)?;
        let mut set = Self {
            count: meetings.len(),
            operator: [[Block::default(); N]; N],
            slip: [0.0; N],
            normal: [0.0; N],
            friction: [0.0; N],
            restitution: [0.0; N],
        };
        let axes = |m: &Meeting| {
            let n = m.normal / m.normal.norm();
            [pull(bodies, m, n.turned_right()), pull(bodies, m, n)]
        };
        for (i, a) in meetings.iter().enumerate() {
            let [at, an] = axes(a);
            // The normal points into the first of the two: what approaches has a negative normal velocity.
            let u = bodies[a.into].velocity_at(a.point) - bodies[a.out_of].velocity_at(a.point);
            (set.slip[i], set.normal[i]) = (at.direction.dot(u), an.direction.dot(u));
            (set.friction[i], set.restitution[i]) = (a.friction, a.restitution);
            for (j, b) in meetings.iter().enumerate() {
                let [bt, bn] = axes(b);
                set.operator[i][j] = Block {
                    tt: response(bodies, (a, at), (b, bt)),
                    tn: response(bodies, (a, at), (b, bn)),
                    nt: response(bodies, (a, an), (b, bt)),
                    nn: response(bodies, (a, an), (b, bn)),
                };
            }
        }
        Ok(set)
    }
}

/// The bodies after impulses (tangential, normal) at their meetings [N s].
///
/// # Errors
/// As [`ContactSet::of_bodies`](super::set::ContactSet::of_bodies) for a mass, inertia, body number or normal that no impact can be computed
/// from; [`ImpactError::OutsideDomain`] for an impulse that is not finite.
///
/// # Example
/// An impulse that two bodies give each other keeps their momentum.
/// ```
/// use carom_impact::planar::{Meeting, RigidBody, struck};
/// use carom_num::Vec2;
/// let one = RigidBody { mass: 1.0, inertia: 1.0, velocity: Vec2::new(3.0, 0.0), ..RigidBody::FIXED };
/// let two = RigidBody { mass: 2.0, centre: Vec2::new(2.0, 0.0), velocity: Vec2::ZERO, ..one };
/// let (point, normal) = (Vec2::new(1.0, 0.0), Vec2::new(1.0, 0.0));
/// let meeting = Meeting { into: 1, out_of: 0, point, normal, friction: 0.0, restitution: 1.0 };
/// let after = struck(&[one, two], &[meeting], &[[0.0, 4.0]])?;
/// assert_eq!((after[0].velocity.x, after[1].velocity.x), (-1.0, 2.0));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn struck(
    bodies: &[RigidBody],
    meetings: &[Meeting],
    impulses: &[[f64; 2]],
) -> Result<Vec<RigidBody>, ImpactError> {
    check(bodies, meetings)?;
    let mut faults = Faults::NONE;
    for (i, value) in impulses.iter().enumerate().flat_map(|(i, impulse)| impulse.map(|value| (i, value))) {
        faults.finite(Some(i), Quantity::Impulse, value);
    }
    faults.refuse()?;
    let mut out = bodies.to_vec();
    for (m, [p_t, p_n]) in meetings.iter().zip(impulses) {
        let n = m.normal / m.normal.norm();
        let p = n.turned_right() * *p_t + n * *p_n;
        for (body, p) in [(m.into, p), (m.out_of, -p)] {
            let b = &mut out[body];
            b.velocity += p / b.mass;
            b.spin += (m.point - b.centre).cross(p) / b.inertia;
        }
    }
    Ok(out)
}

pub(in crate::planar) fn check(bodies: &[RigidBody], meetings: &[Meeting]) -> Result<(), ImpactError> {
    let mut faults = Faults::NONE;
    for b in bodies {
        faults.check(b.mass > 0.0, None, Quantity::Mass, b.mass);
        faults.check(b.inertia > 0.0, None, Quantity::Inertia, b.inertia);
        faults.finite(None, Quantity::CentreX, b.centre.x);
        faults.finite(None, Quantity::CentreY, b.centre.y);
        faults.finite(None, Quantity::VelocityX, b.velocity.x);
        faults.finite(None, Quantity::VelocityY, b.velocity.y);
        faults.finite(None, Quantity::Spin, b.spin);
    }
    for (i, m) in meetings.iter().enumerate() {
        let at = Some(i);
        for body in [m.into, m.out_of] {
            #[expect(clippy::cast_precision_loss, reason = "only shown")]
            let number = body as f64;
            faults.check(body < bodies.len(), at, Quantity::Body, number);
        }
        #[expect(clippy::cast_precision_loss, reason = "only shown")]
        let number = m.into as f64;
        faults.check(m.into != m.out_of, at, Quantity::OtherBody, number);
        faults.finite(at, Quantity::Point, m.point.x);
        faults.finite(at, Quantity::Point, m.point.y);
        let length = m.normal.norm();
        faults.check(length > 0.0 && length.is_finite(), at, Quantity::Normal, length);
    }
    // Only now does every number name a body: levers may be asked for.
    faults.refuse()?;
    for (j, b) in meetings.iter().enumerate() {
        for (i, a) in meetings[..j].iter().enumerate() {
            // Against both levers: where one body is fixed at the contact, its own is nothing.
            let lever = (a.point - bodies[a.into].centre).norm() + (a.point - bodies[a.out_of].centre).norm();
            let same_bodies = (a.into, a.out_of) == (b.into, b.out_of);
            let same_normal = a.normal.cross(b.normal).abs() <= COINCIDE * a.normal.norm() * b.normal.norm();
            if same_bodies && same_normal && (a.point - b.point).norm() <= COINCIDE * lever {
                return Err(ImpactError::Coincide { first: i, second: j });
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Law;
    use crate::planar::contacts::set::ContactSet2;
    use crate::planar::contacts::set::ContactSet6;
    use crate::planar::contacts::set::Touch;
    use crate::planar::stages::staged;

    fn body(mass: f64, x: f64, velocity: (f64, f64), spin: f64) -> RigidBody {
        RigidBody {
            mass,
            inertia: 0.4 * mass,
            centre: Vec2::new(x, 0.3),
            velocity: Vec2::new(velocity.0, velocity.1),
            spin,
        }
    }

    fn floor_meeting(x: f64) -> Meeting {
        let (point, normal) = (Vec2::new(x, 0.0), Vec2::new(0.0, 2.0));
        Meeting { into: 0, out_of: 1, point, normal, friction: 0.3, restitution: 0.4 }
    }

    #[test]
    fn one_free_body_on_a_fixed_one_is_the_set_of_a_free_body() {
        let bodies = [body(2.0, 0.1, (0.5, -1.0), 0.7), RigidBody::FIXED];
        let meetings = [floor_meeting(-0.2), floor_meeting(0.5)];
        let set = ContactSet2::of_bodies(&bodies, &meetings).unwrap();
        let touches = meetings.map(|m| Touch {
            arm: m.point - bodies[0].centre,
            normal: Vec2::new(0.0, 1.0),
            friction: m.friction,
            restitution: m.restitution,
        });
        let alone = ContactSet2::of_free_body(2.0, 0.8, bodies[0].velocity, 0.7, &touches).unwrap();
        assert_eq!(set, alone);
    }

    #[test]
    fn momentum_and_moment_of_momentum_are_kept_between_free_bodies() {
        let bodies = [body(2.0, 0.0, (0.5, -1.0), 0.7), body(1.0, 1.0, (-2.0, 0.4), -3.0)];
        let meeting = Meeting {
            into: 1,
            point: Vec2::new(0.5, 0.4),
            normal: Vec2::new(1.0, 0.2),
            ..floor_meeting(0.0)
        };
        let meeting = Meeting { out_of: 0, ..meeting };
        let set = ContactSet6::of_bodies(&bodies, &[meeting]).unwrap();
        let out = staged::resolve(&set, Law::Poisson).unwrap();
        let after = struck(&bodies, &[meeting], &out.impulse).unwrap();
        let total = |all: &[RigidBody]| {
            let p = all.iter().fold(Vec2::ZERO, |p, b| p + b.velocity * b.mass);
            let l: f64 = all.iter().map(|b| b.centre.cross(b.velocity) * b.mass + b.inertia * b.spin).sum();
            [p.x, p.y, l]
        };
        for (a, b) in total(&bodies).into_iter().zip(total(&after)) {
            assert!((a - b).abs() < 1e-14, "{a} {b}");
        }
        let energy = |all: &[RigidBody]| all.iter().map(RigidBody::energy).sum::<f64>();
        let work: f64 = out.work[0].iter().sum();
        assert!((energy(&after) - energy(&bodies) - work).abs() < 1e-14 && work < 0.0, "{work}");
    }

    #[test]
    fn meetings_coincide_by_what_parts_them_against_both_levers() {
        for scale in [1e-3, 1.0, 1e3] {
            let at =
                |y: f64| RigidBody { centre: Vec2::new(0.0, y * scale), ..body(1.0, 0.0, (0.0, -1.0), 0.0) };
            let of = |apart: f64| {
                let second = Meeting { point: Vec2::new(apart * 0.7 * scale, 0.0), ..floor_meeting(0.0) };
                ContactSet2::of_bodies(&[at(0.3), at(-0.4)], &[floor_meeting(0.0), second]).err()
            };
            let one = Some(ImpactError::Coincide { first: 0, second: 1 });
            assert_eq!((of(0.5 * COINCIDE), of(2.0 * COINCIDE)), (one, None), "{scale}");
        }
    }

    #[test]
    fn bodies_without_mass_or_inertia_are_refused() {
        let good = body(1.0, 0.0, (0.0, -1.0), 0.0);
        let refusal =
            |bad| ContactSet2::of_bodies(&[bad, RigidBody::FIXED], &[floor_meeting(0.0)]).unwrap_err();
        let weightless = refusal(RigidBody { mass: 0.0, ..good }).to_string();
        assert!(
            weightless.starts_with("mass") && weightless.ends_with("is 0, allowed is > 0"),
            "{weightless}"
        );
        let easy = refusal(RigidBody { inertia: 0.0, ..good }).to_string();
        assert!(easy.starts_with("inertia") && easy.ends_with("is 0, allowed is > 0"), "{easy}");
    }

    #[test]
    fn what_is_no_meeting_is_refused_by_name() {
        let bodies = [body(1.0, 0.0, (0.0, -1.0), 0.0), RigidBody::FIXED];
        let m = floor_meeting(0.0);
        let refusal =
            |meetings: &[Meeting]| ContactSet2::of_bodies(&bodies, meetings).unwrap_err().to_string();
        assert_eq!(refusal(&[m, m]), "contacts 0 and 1 coincide: same bodies, same point, same normal");
        let flat = Meeting { normal: Vec2::ZERO, ..m };
        assert_eq!(refusal(&[flat]), "length of the normal of contact 0 is 0, allowed is > 0");
        let alone = Meeting { out_of: 0, ..m };
        assert_eq!(refusal(&[alone]), "body of contact 0 is 0, allowed is two different bodies");
        let nobody = Meeting { out_of: 7, ..m };
        assert_eq!(refusal(&[nobody]), "body of contact 0 is 7, allowed is a body, counted from 0");
    }
}
