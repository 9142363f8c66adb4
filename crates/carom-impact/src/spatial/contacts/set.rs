//! Several contacts of one body in space: velocities and the operator `W = G M⁻¹ Gᵀ`.

use super::bodies::Meeting;
use crate::ImpactError;
use crate::error::outside;
use crate::tolerance::{INERTIA_EQUALITY, UNIT_LENGTH};
use carom_num::principal::principal;
use carom_num::{Mat3, Vec3};

/// Most contacts of which every hypothesis is tried.
pub const MOST_EXAMINED: usize = 16;

/// A free rigid body at one instant.
///
/// # Example
/// A coin on its edge that rolls: the point on the floor rests.
/// ```
/// use carom_impact::spatial::RigidBody;
/// use carom_num::{Mat3, Vec3};
/// let inertia = Mat3::diagonal(0.25, 0.5, 0.25);
/// let coin = RigidBody { mass: 1.0, inertia, velocity: Vec3::X * 2.0, spin: Vec3::Y * 2.0 };
/// assert_eq!((coin.check(), coin.velocity_at(-Vec3::Z)), (Ok(()), Vec3::ZERO));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody {
    /// Mass [kg], > 0.
    pub mass: f64,
    /// Inertia about the mass centre, world axes [kg m²]: symmetric, positive definite, no principal moment above the sum of the other two.
    pub inertia: Mat3,
    /// Velocity of the mass centre [m/s].
    pub velocity: Vec3,
    /// Angular velocity, world axes [rad/s].
    pub spin: Vec3,
}

/// Where a free body is touched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Contact point from the mass centre, world axes [m].
    pub arm: Vec3,
    /// Unit normal out of what is touched into the body, world axes.
    pub normal: Vec3,
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}

/// Up to N contacts of a body at one instant.
///
/// Velocities and impulses of a contact are in its own frame (t₁, t₂, n).
///
/// # Example
/// What an impulse at one contact does to another is what one there does to the first: `W₁₂ = W₂₁ᵀ`.
/// ```
/// use carom_impact::spatial::{ContactSet, RigidBody, Touch};
/// use carom_num::{Mat3, Vec3};
/// let inertia = Mat3::diagonal(1.0, 2.0, 2.5);
/// let body = RigidBody { mass: 1.0, inertia, velocity: -Vec3::Z, spin: Vec3::Y };
/// let foot = |x, y| Touch { arm: Vec3::new(x, y, -1.0), normal: Vec3::Z, friction: 0.3, restitution: 0.5 };
/// let set = ContactSet::<2>::of_free_body(&body, &[foot(1.0, 0.5), foot(-0.5, 2.0)])?;
/// let difference = set.operator[0][1] - set.operator[1][0].transposed();
/// assert!(difference.rows.iter().all(|row| row.norm() < 1e-15));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSet<const N: usize> {
    /// How many contacts.
    pub count: usize,
    /// Each contact's frame: its rows are t₁, t₂, n in world axes.
    pub frame: [Mat3; N],
    /// Velocity of each contact point [m/s]; an approach has a negative third component.
    pub velocity: [Vec3; N],
    /// `operator[i][j]`: velocity of contact i to impulse at contact j [1/kg].
    pub operator: [[Mat3; N]; N],
    /// Coulomb friction coefficients.
    pub friction: [f64; N],
    /// Coefficients of restitution.
    pub restitution: [f64; N],
}

impl RigidBody {
    /// Checks that the numbers are those of a rigid body.
    ///
    /// # Errors
    /// [`ImpactError::OutsideDomain`] with the first quantity that no rigid body has.
    ///
    /// # Example
    /// A moment of inertia is never above the sum of the two others.
    /// ```
    /// use carom_impact::spatial::RigidBody;
    /// use carom_num::{Mat3, Vec3};
    /// let body = |z| RigidBody {
    ///     mass: 1.0, inertia: Mat3::diagonal(1.0, 1.0, z), velocity: Vec3::ZERO, spin: Vec3::ZERO,
    /// };
    /// assert!(body(2.0).check().is_ok() && body(2.1).check().is_err());
    /// ```
    pub fn check(&self) -> Result<(), ImpactError> {
        let mass = self.mass;
        if !(mass > 0.0 && mass.is_finite()) {
            return Err(outside(None, "mass", mass, "finite and > 0"));
        }
        let [a, b, c] = self.inertia.rows;
        let skew = (a.y - b.x).abs().max((a.z - c.x).abs()).max((b.z - c.y).abs());
        let trace = a.x + b.y + c.z;
        if !self.inertia.is_finite() || skew > INERTIA_EQUALITY * trace.abs() {
            return Err(outside(None, "inertia: its asymmetry", skew, "0"));
        }
        // Sylvester's criterion for J, and the same for tr J / 2 − J: no principal moment exceeds the sum of the other two.
        let second = Mat3::diagonal(0.5 * trace, 0.5 * trace, 0.5 * trace) - self.inertia;
        let [least, least_second] = [least_minor(self.inertia, trace), least_minor(second, trace)];
        let ([small, middle, large], _) = principal(self.inertia);
        if least <= 0.0 {
            let quantity = "inertia: its least principal moment [kg m²]";
            return Err(outside(None, quantity, small.min(0.0), "> 0"));
        }
        if least_second < -INERTIA_EQUALITY {
            let quantity = "inertia: the sum of its two lesser principal moments less the largest [kg m²]";
            return Err(outside(None, quantity, small + middle - large, ">= 0"));
        }
        let motion = [("velocity", self.velocity), ("spin", self.spin)];
        match motion.into_iter().find(|(_, v)| !v.is_finite()) {
            Some((quantity, v)) => Err(outside(None, quantity, v.norm(), "finite")),
            None => Ok(()),
        }
    }

    /// Velocity of a point at `arm` from the mass centre [m/s], world axes.
    ///
    /// # Example
    /// ```
    /// use carom_impact::spatial::RigidBody;
    /// use carom_num::{Mat3, Vec3};
    /// let top = RigidBody { mass: 1.0, inertia: Mat3::IDENTITY, velocity: Vec3::X, spin: Vec3::Z * 3.0 };
    /// assert_eq!(top.velocity_at(Vec3::X * 2.0), Vec3::new(1.0, 6.0, 0.0));
    /// ```
    pub fn velocity_at(&self, arm: Vec3) -> Vec3 {
        self.velocity + self.spin.cross(arm)
    }

    /// Kinetic energy [J].
    ///
    /// # Example
    /// 2 · 5²/2 + 0.5 · 2²/2.
    /// ```
    /// use carom_impact::spatial::RigidBody;
    /// use carom_num::{Mat3, Vec3};
    /// let inertia = Mat3::diagonal(0.4, 0.4, 0.5);
    /// let (velocity, spin) = (Vec3::new(3.0, 4.0, 0.0), Vec3::Z * 2.0);
    /// assert_eq!(RigidBody { mass: 2.0, inertia, velocity, spin }.energy(), 26.0);
    /// ```
    pub fn energy(&self) -> f64 {
        0.5 * self.mass * self.velocity.dot(self.velocity) + 0.5 * self.spin.dot(self.inertia * self.spin)
    }

    /// The body after an impulse [N s] at a point `arm` from its mass centre, both in world axes; `None` where its inertia is singular.
    ///
    /// # Example
    /// Off its centre: 4 N s at 0.5 m make 2 N m s, and with 2 kg m² a spin of 1 rad/s.
    /// ```
    /// use carom_impact::spatial::RigidBody;
    /// use carom_num::{Mat3, Vec3};
    /// let inertia = Mat3::diagonal(2.0, 2.0, 2.0);
    /// let body = RigidBody { mass: 2.0, inertia, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    /// let after = body.pushed(Vec3::X * 0.5, Vec3::Y * 4.0).unwrap();
    /// assert_eq!((after.velocity, after.spin), (Vec3::Y * 2.0, Vec3::Z));
    /// ```
    pub fn pushed(&self, arm: Vec3, impulse: Vec3) -> Option<Self> {
        let turned = self.inertia.inverse()? * arm.cross(impulse);
        Some(Self { velocity: self.velocity + impulse / self.mass, spin: self.spin + turned, ..*self })
    }
}

/// The least of the leading principal minors, each in units of the trace.
fn least_minor(m: Mat3, trace: f64) -> f64 {
    let [a, b, _] = m.rows;
    let minors = [a.x / trace, (a.x * b.y - a.y * b.x) / (trace * trace), m.determinant() / trace.powi(3)];
    minors.into_iter().fold(f64::INFINITY, f64::min)
}

impl Touch {
    pub(in crate::spatial) fn check(&self, contact: usize) -> Result<(), ImpactError> {
        let of = |quantity, value, allowed| Err(outside(Some(contact), quantity, value, allowed));
        if !self.arm.is_finite() {
            return of("arm", self.arm.norm(), "finite");
        }
        let length = self.normal.norm();
        if (length - 1.0).abs() > UNIT_LENGTH || length.is_nan() {
            return of("length of the normal", length, "1");
        }
        if self.friction < 0.0 || self.friction.is_nan() {
            return of("friction", self.friction, ">= 0");
        }
        if !(0.0..=1.0).contains(&self.restitution) {
            return of("restitution", self.restitution, "0 to 1");
        }
        Ok(())
    }

    /// The contact's frame: rows t₁, t₂, n in world axes.
    pub(in crate::spatial) fn frame(&self) -> Mat3 {
        let [first, second] = self.normal.tangents();
        Mat3 { rows: [first, second, self.normal] }
    }
}

impl<const N: usize> ContactSet<N> {
    /// The contacts of a free body.
    ///
    /// # Errors
    /// [`ImpactError::TooMany`] where they do not fit; [`ImpactError::OutsideDomain`] with the first quantity that is not allowed;
    /// [`ImpactError::Overflow`] where finite data have no finite response.
    ///
    /// # Example
    /// A ball of 1 kg and radius 1 m, 2/5 kg m², on its lowest point: along the normal the whole mass resists, across it 2/7 of it.
    /// ```
    /// use carom_impact::spatial::{ContactSet, RigidBody, Touch};
    /// use carom_num::{Mat3, Vec3};
    /// let ball = RigidBody { mass: 1.0, inertia: Mat3::diagonal(0.4, 0.4, 0.4), velocity: -Vec3::Z, spin: Vec3::ZERO };
    /// let touch = Touch { arm: -Vec3::Z, normal: Vec3::Z, friction: 0.3, restitution: 1.0 };
    /// let set = ContactSet::<1>::of_free_body(&ball, &[touch])?;
    /// assert_eq!(set.operator[0][0], Mat3::diagonal(3.5, 3.5, 1.0));
    /// assert_eq!(set.velocity[0], -Vec3::Z);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn of_free_body(body: &RigidBody, touches: &[Touch]) -> Result<Self, ImpactError> {
        Self::joined(std::slice::from_ref(body), touches.len(), |i| Meeting {
            body: 0,
            touch: touches[i],
            other: None,
        })
    }

    /// Velocities after these impulses, each in its contact's frame.
    pub fn after(&self, impulses: &[Vec3; N]) -> [Vec3; N] {
        std::array::from_fn(|i| {
            let pushed = |v: Vec3, (block, p): (&Mat3, &Vec3)| v + *block * *p;
            self.operator[i].iter().zip(impulses).take(self.count).fold(self.velocity[i], pushed)
        })
    }

    /// Whether the set can be resolved at all.
    ///
    /// # Errors
    /// [`ImpactError::TooMany`] above [`MOST_EXAMINED`] contacts; [`ImpactError::OutsideDomain`] names the first number that is not finite, friction < 0,
    /// restitution outside 0…1, or the first contact whose own response is not positive.
    pub fn check(&self) -> Result<(), ImpactError> {
        let most = MOST_EXAMINED.min(N);
        if self.count > most {
            return Err(ImpactError::TooMany { count: self.count, most });
        }
        for i in 0..self.count {
            let refuse = |quantity, value, allowed| Err(outside(Some(i), quantity, value, allowed));
            let (friction, restitution) = (self.friction[i], self.restitution[i]);
            if !self.velocity[i].is_finite() {
                return refuse("velocity", self.velocity[i].norm(), "finite");
            }
            if let Some(block) = self.operator[i][..self.count].iter().find(|block| !block.is_finite()) {
                return refuse("operator", block.rows[2].norm(), "finite");
            }
            if !(friction >= 0.0 && friction.is_finite()) {
                return refuse("friction", friction, "finite and >= 0");
            }
            if !(0.0..=1.0).contains(&restitution) {
                return refuse("restitution", restitution, "0 to 1");
            }
            let [a, b, c] = self.operator[i][i].rows;
            for own in [a.x, b.y, c.z] {
                if own <= 0.0 {
                    return refuse("W of its own impulse", own, "> 0");
                }
            }
        }
        Ok(())
    }

    /// Sets to zero each normal velocity and each slip that is smaller than `relative` times the largest velocity of the set: the rounding of contacts
    /// that are known to touch or to stick.
    pub fn snap(&mut self, relative: f64) {
        let largest = self.velocity[..self.count].iter().fold(0.0, |m: f64, u| m.max(u.norm()));
        for u in &mut self.velocity[..self.count] {
            if u.z.abs() <= relative * largest {
                u.z = 0.0;
            }
            if (u.x * u.x + u.y * u.y).sqrt() <= relative * largest {
                (u.x, u.y) = (0.0, 0.0);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_refused_by_what_no_body_has() {
        let check =
            |inertia: Mat3| RigidBody { mass: 1.0, inertia, velocity: Vec3::ZERO, spin: Vec3::ZERO }.check();
        assert_eq!(
            check(Mat3::diagonal(1.0, 1.0, 2.0)),
            Ok(()),
            "a flat one: the largest is the sum of the others"
        );
        assert_eq!(check(Mat3::diagonal(1e-9, 1.0, 1.0)), Ok(()), "a thin one");
        let refusal = |inertia: Mat3| check(inertia).unwrap_err().to_string();
        let lesser = "inertia: the sum of its two lesser principal moments less the largest [kg m²] is ";
        assert!(
            refusal(Mat3::diagonal(1.0, 1.0, 2.01)).starts_with(&format!("{lesser}-0.0")),
            "more than flat"
        );
        let least = "inertia: its least principal moment [kg m²] is ";
        assert_eq!(refusal(Mat3::diagonal(0.0, 1.0, 1.0)), format!("{least}0, allowed is > 0"));
        let mut skew = Mat3::IDENTITY;
        skew.rows[0].y = 0.5;
        assert_eq!(refusal(skew), "inertia: its asymmetry is 0.5, allowed is 0");
    }
}
