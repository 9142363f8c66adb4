//! Several bodies that meet, each other or what does not yield: their contacts as one set, and the bodies after it.

use super::set::ContactSet;
use super::set::RigidBody;
use super::set::Touch;
use crate::ImpactError;
use crate::error::outside;
use carom_num::{Mat3, Vec3};

/// A contact of a body with another one, or with what does not yield.
///
/// # Example
/// A ball of 1 kg that meets one that rests, or what does not yield: `W_nn` is 1 + 1, or 1.
/// ```
/// use carom_impact::spatial::{ContactSet, Meeting, RigidBody, Touch};
/// use carom_num::{Mat3, Vec3};
/// let inertia = Mat3::diagonal(0.4, 0.4, 0.4);
/// let ball = RigidBody { mass: 1.0, inertia, velocity: Vec3::ZERO, spin: Vec3::ZERO };
/// let touch = Touch { arm: -Vec3::X, normal: Vec3::X, friction: 0.3, restitution: 1.0 };
/// let response = |other| {
///     let set = ContactSet::<1>::of_bodies(&[ball, ball], &[Meeting { body: 1, touch, other }]);
///     set.map(|set| set.operator[0][0].rows[2].z)
/// };
/// assert_eq!((response(Some((0, Vec3::X))), response(None)), (Ok(2.0), Ok(1.0)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// Number of the body that the normal points into.
    pub body: usize,
    /// Where that body is touched.
    pub touch: Touch,
    /// Number of the body that the normal points out of, and the contact point from its mass centre, world axes [m]; `None` for what does not yield.
    pub other: Option<(usize, Vec3)>,
}

/// One of the bodies of a meeting: its number, the contact point from its mass centre, and the sign of the impulse on it.
type Side = (usize, Vec3, f64);

impl Meeting {
    fn sides(&self) -> impl Iterator<Item = Side> + Clone {
        let other = self.other.map(|(body, arm)| (body, arm, -1.0));
        std::iter::once((self.body, self.touch.arm, 1.0)).chain(other)
    }

    fn check(&self, contact: usize, bodies: usize) -> Result<(), ImpactError> {
        self.touch.check(contact)?;
        let refuse = |body: usize, allowed| {
            #[expect(clippy::cast_precision_loss, reason = "only shown")]
            let number = body as f64;
            Err(outside(Some(contact), "body", number, allowed))
        };
        if let Some((body, ..)) = self.sides().find(|(body, ..)| *body >= bodies) {
            return refuse(body, "a body, counted from 0");
        }
        match self.other {
            Some((other, _)) if other == self.body => refuse(other, "two different bodies"),
            Some((_, arm)) if !arm.is_finite() => {
                Err(outside(Some(contact), "arm on the other body", arm.norm(), "finite"))
            }
            _ => Ok(()),
        }
    }

    /// Velocity of the contact point on the body relative to that on the other [m/s], world axes.
    fn velocity(&self, bodies: &[RigidBody]) -> Vec3 {
        self.sides().fold(Vec3::ZERO, |u, (body, arm, sign)| u + bodies[body].velocity_at(arm) * sign)
    }
}

/// What a unit impulse at one meeting does to the velocity at another, world axes [1/kg].
fn response(bodies: &[RigidBody], mobility: impl Fn(usize) -> Mat3, a: &Meeting, b: &Meeting) -> Mat3 {
    let mut sum = Mat3::ZERO;
    for (i, arm_a, sign_a) in a.sides() {
        for (j, arm_b, sign_b) in b.sides().filter(|(j, ..)| *j == i) {
            let turning = Mat3::crossing(arm_a).product(mobility(j)).product(Mat3::crossing(arm_b));
            let linear = 1.0 / bodies[i].mass;
            sum = sum + (Mat3::diagonal(linear, linear, linear) - turning) * (sign_a * sign_b);
        }
    }
    sum
}

impl<const N: usize> ContactSet<N> {
    /// The contacts of several free bodies with each other and with what does not yield.
    ///
    /// # Errors
    /// [`ImpactError::TooMany`] where they do not fit; [`ImpactError::OutsideDomain`] with the first quantity that is not allowed;
    /// [`ImpactError::Overflow`] where finite data have no finite response.
    ///
    /// # Example
    /// A ball of 1 kg meets one of 2 kg that rests, head on: `W_nn = 1 + 1/2`, and without loss it goes back with a third of its velocity.
    /// ```
    /// use carom_impact::spatial::{ContactSet, Meeting, RigidBody, Touch, struck};
    /// use carom_num::{Mat3, Vec3};
    /// let ball = |mass, velocity| RigidBody {
    ///     mass, inertia: Mat3::diagonal(0.4, 0.4, 0.4), velocity, spin: Vec3::ZERO,
    /// };
    /// let bodies = [ball(1.0, Vec3::X * 3.0), ball(2.0, Vec3::ZERO)];
    /// let touch = Touch { arm: -Vec3::X, normal: Vec3::X, friction: 0.3, restitution: 1.0 };
    /// let meetings = [Meeting { body: 1, touch, other: Some((0, Vec3::X)) }];
    /// let set = ContactSet::<1>::of_bodies(&bodies, &meetings)?;
    /// assert_eq!((set.operator[0][0].rows[2].z, set.velocity[0].z), (1.5, -3.0));
    /// let after = struck(&bodies, &meetings, &[Vec3::Z * (2.0 * 3.0 / 1.5)])?;
    /// assert_eq!((after[0].velocity, after[1].velocity), (-Vec3::X, Vec3::X * 2.0));
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn of_bodies(bodies: &[RigidBody], meetings: &[Meeting]) -> Result<Self, ImpactError> {
        Self::joined(bodies, meetings.len(), |i| meetings[i])
    }

    /// The contacts of these meetings.
    pub(super) fn joined(
        bodies: &[RigidBody],
        count: usize,
        meeting: impl Fn(usize) -> Meeting,
    ) -> Result<Self, ImpactError> {
        if count > N {
            return Err(ImpactError::TooMany { count, most: N });
        }
        bodies.iter().try_for_each(RigidBody::check)?;
        (0..count).try_for_each(|i| meeting(i).check(i, bodies.len()))?;
        // A body that was checked may still be too small to invert. Refused here, so that the zero below never makes one that cannot turn.
        if bodies.iter().any(|b| b.inertia.inverse().is_none()) {
            return Err(ImpactError::Overflow);
        }
        let mobility = |body: usize| bodies[body].inertia.inverse().unwrap_or(Mat3::ZERO);
        let mut set = Self {
            count,
            frame: [Mat3::ZERO; N],
            velocity: [Vec3::ZERO; N],
            operator: [[Mat3::ZERO; N]; N],
            friction: [0.0; N],
            restitution: [0.0; N],
        };
        for i in 0..count {
            let a = meeting(i);
            set.frame[i] = a.touch.frame();
            set.velocity[i] = set.frame[i] * a.velocity(bodies);
            (set.friction[i], set.restitution[i]) = (a.touch.friction, a.touch.restitution);
        }
        for i in 0..count {
            for j in 0..count {
                let response = response(bodies, mobility, &meeting(i), &meeting(j));
                set.operator[i][j] = set.frame[i].product(response).product(set.frame[j].transposed());
            }
        }
        let finite = set.velocity.iter().all(|v| v.is_finite())
            && set.operator.iter().flatten().all(|block| block.is_finite());
        if finite { Ok(set) } else { Err(ImpactError::Overflow) }
    }
}

/// The bodies after these impulses [N s], each in the frame of its meeting.
///
/// # Errors
/// [`ImpactError::OutsideDomain`] for a meeting of bodies that do not exist; [`ImpactError::Overflow`] for a body whose inertia is singular.
///
/// # Example
/// What two bodies give each other keeps their momentum: 1 · 3 = 1 · (−1) + 2 · 2.
/// ```
/// use carom_impact::spatial::{Meeting, RigidBody, Touch, struck};
/// use carom_num::{Mat3, Vec3};
/// let inertia = Mat3::diagonal(0.4, 0.4, 0.4);
/// let one = RigidBody { mass: 1.0, inertia, velocity: Vec3::X * 3.0, spin: Vec3::ZERO };
/// let two = RigidBody { mass: 2.0, velocity: Vec3::ZERO, ..one };
/// let touch = Touch { arm: -Vec3::X, normal: Vec3::X, friction: 0.3, restitution: 1.0 };
/// let meeting = Meeting { body: 1, touch, other: Some((0, Vec3::X)) };
/// let after = struck(&[one, two], &[meeting], &[Vec3::Z * 4.0])?;
/// assert_eq!((after[0].velocity, after[1].velocity), (-Vec3::X, Vec3::X * 2.0));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn struck(
    bodies: &[RigidBody],
    meetings: &[Meeting],
    impulses: &[Vec3],
) -> Result<Vec<RigidBody>, ImpactError> {
    let mut out = bodies.to_vec();
    for (i, (meeting, impulse)) in meetings.iter().zip(impulses).enumerate() {
        meeting.check(i, bodies.len())?;
        let world = meeting.touch.frame().transposed() * *impulse;
        for (body, arm, sign) in meeting.sides() {
            out[body] = out[body].pushed(arm, world * sign).ok_or(ImpactError::Overflow)?;
        }
    }
    Ok(out)
}
