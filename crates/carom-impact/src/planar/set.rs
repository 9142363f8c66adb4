//! Several contacts of one body: velocities and the operator `W = G M⁻¹ Gᵀ`.

use carom_num::Vec2;
use thiserror::Error;

/// Largest number of contacts of one impact.
pub const MOST_CONTACTS: usize = 6;

/// Response of one contact's velocity to another's impulse: `Δu = W p`, in (t, n).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Block {
    /// Slip to tangential impulse [1/kg].
    pub tt: f64,
    /// Slip to normal impulse [1/kg].
    pub tn: f64,
    /// Normal velocity to tangential impulse [1/kg].
    pub nt: f64,
    /// Normal velocity to normal impulse [1/kg].
    pub nn: f64,
}

/// Where a free body is touched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Contact point from the mass centre [m].
    pub arm: Vec2,
    /// Unit normal out of the obstacle into the body.
    pub normal: Vec2,
    /// Coulomb friction coefficient, ≥ 0.
    pub friction: f64,
    /// Coefficient of restitution, in [0, 1].
    pub restitution: f64,
}

impl Touch {
    /// Velocity (slip, normal) of the contact point of a body that moves with `velocity` [m/s] and `spin` [rad/s].
    #[inline]
    pub fn velocity(&self, velocity: Vec2, spin: f64) -> (f64, f64) {
        let u = velocity + self.arm.turned_left() * spin;
        (self.normal.turned_right().dot(u), self.normal.dot(u))
    }
}

/// Up to N contacts at one instant; M = 2 N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSet<const N: usize, const M: usize> {
    /// How many contacts.
    pub count: usize,
    /// `operator[i][j]`: velocity of contact i to impulse at contact j.
    pub operator: [[Block; N]; N],
    /// Slip velocities [m/s].
    pub slip: [f64; N],
    /// Normal velocities [m/s]; an approach is negative, a touching contact has 0.
    pub normal: [f64; N],
    /// Coulomb friction coefficients.
    pub friction: [f64; N],
    /// Coefficients of restitution.
    pub restitution: [f64; N],
}

/// Two contacts: a landing.
pub type Pair = ContactSet<2, 4>;
/// As many contacts as an impact may have.
pub type Several = ContactSet<MOST_CONTACTS, { 2 * MOST_CONTACTS }>;

/// Why an impact could not be resolved.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ImpactError {
    /// More contacts than fit.
    #[error("{count} contacts at once: at most {most} are resolved")]
    TooMany {
        /// Contacts given.
        count: usize,
        /// Contacts that fit.
        most: usize,
    },
    /// The walk did not end within its budget of stages.
    #[error("the impact did not end within {stages} stages")]
    Unending {
        /// Stages walked.
        stages: usize,
    },
    /// No consistent way on, and no contact whose slip could be stopped first.
    #[error("no consistent motion through the impact: the contacts are jammed")]
    Jammed,
}

impl<const N: usize, const M: usize> ContactSet<N, M> {
    /// The contacts of a free planar body of `mass` [kg] and `inertia` [kg m²] that moves with `velocity` [m/s] and `spin` [rad/s].
    ///
    /// # Errors
    /// [`ImpactError::TooMany`] where they do not fit.
    pub fn of_free_body(
        mass: f64,
        inertia: f64,
        velocity: Vec2,
        spin: f64,
        touches: &[Touch],
    ) -> Result<Self, ImpactError> {
        if touches.len() > N {
            return Err(ImpactError::TooMany { count: touches.len(), most: N });
        }
        let mut set = Self {
            count: touches.len(),
            operator: [[Block::default(); N]; N],
            slip: [0.0; N],
            normal: [0.0; N],
            friction: [0.0; N],
            restitution: [0.0; N],
        };
        for (i, a) in touches.iter().enumerate() {
            (set.slip[i], set.normal[i]) = a.velocity(velocity, spin);
            set.friction[i] = a.friction;
            set.restitution[i] = a.restitution;
            for (j, b) in touches.iter().enumerate() {
                set.operator[i][j] = coupling(mass, inertia, a, b);
            }
        }
        Ok(set)
    }

    /// Sets to zero each normal velocity and slip that is smaller than `relative` times the largest velocity of the set: the rounding of
    /// contacts that are known to touch or to stick.
    pub fn snap(&mut self, relative: f64) {
        let largest =
            (0..self.count).fold(0.0, |m: f64, i| m.max(self.slip[i].abs()).max(self.normal[i].abs()));
        for u in self.slip[..self.count].iter_mut().chain(self.normal[..self.count].iter_mut()) {
            if u.abs() <= relative * largest {
                *u = 0.0;
            }
        }
    }
}

/// One block of the operator of a free body.
#[inline]
pub fn coupling(mass: f64, inertia: f64, a: &Touch, b: &Touch) -> Block {
    let (ta, tb) = (a.normal.turned_right(), b.normal.turned_right());
    let (lat, lan) = (a.arm.cross(ta), a.arm.cross(a.normal));
    let (lbt, lbn) = (b.arm.cross(tb), b.arm.cross(b.normal));
    Block {
        tt: ta.dot(tb) / mass + lat * lbt / inertia,
        tn: ta.dot(b.normal) / mass + lat * lbn / inertia,
        nt: a.normal.dot(tb) / mass + lan * lbt / inertia,
        nn: a.normal.dot(b.normal) / mass + lan * lbn / inertia,
    }
}
