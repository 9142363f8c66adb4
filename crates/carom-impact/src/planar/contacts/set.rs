//! Several contacts of one body: velocities and the operator `W = G M⁻¹ Gᵀ`.

use super::single;
use crate::ImpactError;
use crate::faults::{Faults, Quantity};
use carom_num::Vec2;

/// Largest number of contacts of one impact.
///
/// # Example
/// ```
/// use carom_impact::{ImpactError, planar::{ContactSet6, MOST_CONTACTS, Touch}};
/// use carom_num::Vec2;
/// let leg = Touch { arm: Vec2::ZERO, normal: Vec2::new(0.0, 1.0), friction: 0.3, restitution: 0.0 };
/// let refused = ContactSet6::of_free_body(1.0, 1.0, Vec2::ZERO, 0.0, &[leg; MOST_CONTACTS + 1]).unwrap_err();
/// assert_eq!(refused, ImpactError::TooMany { count: 7, most: 6 });
/// ```
pub const MOST_CONTACTS: usize = 6;

/// Response of one contact's velocity to another's impulse: `Δu = W p`, in (t, n).
///
/// # Example
/// An impulse up at the left foot of a box, 1 m from the middle, turns the right one down: 1/m − 1/J.
/// ```
/// use carom_impact::planar::{ContactSet2, Touch};
/// use carom_num::Vec2;
/// let normal = Vec2::new(0.0, 1.0);
/// let foot = |x| Touch { arm: Vec2::new(x, -1.0), normal, friction: 0.3, restitution: 0.0 };
/// let set = ContactSet2::of_free_body(1.0, 0.5, Vec2::ZERO, 0.0, &[foot(-1.0), foot(1.0)])?;
/// let [left, right] = set.operator[0];
/// assert_eq!((left.nn, right.nn), (1.0 + 2.0, 1.0 - 2.0));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
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
///
/// # Example
/// On a floor the tangent points right: the slip is the velocity along x.
/// ```
/// use carom_impact::planar::Touch;
/// use carom_num::Vec2;
/// let floor = Touch { arm: Vec2::ZERO, normal: Vec2::new(0.0, 1.0), friction: 0.3, restitution: 0.5 };
/// assert_eq!(floor.velocity(Vec2::new(3.0, -4.0), 2.0), (3.0, -4.0));
/// ```
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
    ///
    /// # Example
    /// The lowest point of a wheel of radius 0.5 m that rolls without slip.
    /// ```
    /// use carom_impact::planar::Touch;
    /// use carom_num::Vec2;
    /// let normal = Vec2::new(0.0, 1.0);
    /// let low = Touch { arm: Vec2::new(0.0, -0.5), normal, friction: 0.3, restitution: 0.5 };
    /// assert_eq!(low.velocity(Vec2::new(1.0, 0.0), -2.0), (0.0, 0.0));
    /// ```
    #[inline]
    pub fn velocity(&self, velocity: Vec2, spin: f64) -> (f64, f64) {
        let u = velocity + self.arm.turned_left() * spin;
        (self.normal.turned_right().dot(u), self.normal.dot(u))
    }
}

/// Up to N contacts at one instant; M = 2 N.
///
/// # Example
/// Two particles of 1 and 1/2 kg that fall side by side do not know of each other: each takes its own
/// momentum.
/// ```
/// use carom_impact::{Law, planar::{Block, ContactSet, staged}};
/// let particle = |w| Block { tt: w, tn: 0.0, nt: 0.0, nn: w };
/// let none = Block::default();
/// let set = ContactSet::<2, 4> {
///     count: 2, operator: [[particle(1.0), none], [none, particle(2.0)]],
///     slip: [0.0; 2], normal: [-3.0; 2], friction: [0.0; 2], restitution: [0.0; 2],
/// };
/// let out = staged::resolve(&set, Law::Poisson)?;
/// assert!((out.impulse[0][1] - 3.0).abs() < 1e-15 && (out.impulse[1][1] - 1.5).abs() < 1e-15);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
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

/// Up to two contacts: a landing.
pub type ContactSet2 = ContactSet<2, 4>;
/// Up to six contacts: as many as an impact may have.
pub type ContactSet6 = ContactSet<MOST_CONTACTS, { 2 * MOST_CONTACTS }>;

impl<const N: usize, const M: usize> ContactSet<N, M> {
    /// The contacts of a free planar body of `mass` [kg] and `inertia` [kg m²] that moves with `velocity` [m/s] and `spin` [rad/s].
    ///
    /// # Errors
    /// [`ImpactError::TooMany`] where they do not fit; [`ImpactError::OutsideDomain`] unless mass and inertia are positive (infinite ones
    /// are: a body that cannot turn, or cannot shift), velocities and arms finite, and normals have a length; [`ImpactError::Faults`] names all
    /// that is wrong where that is more than one number. The touches are checked where the set is resolved.
    ///
    /// # Example
    /// A square of side 2 m, 1 kg, J = 2/3 kg m², about to strike with a lower corner: W_nn = 1 + 1/J.
    /// ```
    /// use carom_impact::planar::{ContactSet2, Touch};
    /// use carom_num::Vec2;
    /// let normal = Vec2::new(0.0, 1.0);
    /// let corner = Touch { arm: Vec2::new(1.0, -1.0), normal, friction: 0.3, restitution: 0.5 };
    /// let set = ContactSet2::of_free_body(1.0, 2.0 / 3.0, Vec2::new(0.0, -1.0), 0.5, &[corner])?;
    /// assert_eq!((set.operator[0][0].nn, set.slip[0], set.normal[0]), (2.5, 0.5, -0.5));
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
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
        check(mass, inertia, velocity, spin, touches)?;
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

    /// Contact i as if the others were not there.
    pub fn alone(&self, i: usize) -> single::Contact {
        let b = &self.operator[i][i];
        single::Contact {
            w_tt: b.tt,
            w_tn: b.tn,
            w_nn: b.nn,
            slip: self.slip[i],
            normal: self.normal[i],
            friction: self.friction[i],
            restitution: self.restitution[i],
        }
    }

    /// The same contacts with room for A of them, which must be enough: small sets are faster.
    pub(in crate::planar) fn resized<const A: usize, const B: usize>(&self) -> ContactSet<A, B> {
        let within = |i: usize| i < self.count.min(A);
        let list = |from: &[f64; N]| std::array::from_fn(|i| if within(i) { from[i] } else { 0.0 });
        let block =
            |i: usize, j: usize| if within(i) && within(j) { self.operator[i][j] } else { Block::default() };
        ContactSet {
            count: self.count,
            operator: std::array::from_fn(|i| std::array::from_fn(|j| block(i, j))),
            slip: list(&self.slip),
            normal: list(&self.normal),
            friction: list(&self.friction),
            restitution: list(&self.restitution),
        }
    }

    /// Whether the set can be resolved at all.
    ///
    /// # Errors
    /// [`ImpactError::TooMany`] where `count` exceeds N; [`ImpactError::OutsideDomain`] where a number is not finite, a friction
    /// coefficient < 0, a restitution outside 0…1, or `W_tt ≤ 0` or `W_nn ≤ 0` at a contact, [`ImpactError::Faults`] where several are.
    pub fn check(&self) -> Result<(), ImpactError> {
        let n = self.count;
        if n > N {
            return Err(ImpactError::TooMany { count: n, most: N });
        }
        let mut total = 0.0;
        let mut sound = true;
        for i in 0..n {
            let own = &self.operator[i][i];
            sound &= own.tt > 0.0 && own.nn > 0.0;
            sound &= self.friction[i] >= 0.0 && (0.0..=1.0).contains(&self.restitution[i]);
            total += (self.slip[i].abs() + self.normal[i].abs() + self.friction[i]) * 0.0;
            for b in &self.operator[i][..n] {
                total += (b.tt.abs() + b.tn.abs() + b.nt.abs() + b.nn.abs()) * 0.0;
            }
        }
        // Zero times a number is zero only where the number is finite.
        if sound && total == 0.0 { Ok(()) } else { self.complain() }
    }

    /// Magnitude of the largest entry of the operator.
    pub(in crate::planar) fn largest_entry(&self) -> f64 {
        let blocks = self.operator[..self.count].iter().flat_map(|row| &row[..self.count]);
        let largest = |b: &Block| b.tt.abs().max(b.tn.abs()).max(b.nt.abs()).max(b.nn.abs());
        blocks.map(largest).fold(0.0, f64::max)
    }

    #[cold]
    fn complain(&self) -> Result<(), ImpactError> {
        let mut faults = Faults::NONE;
        for i in 0..self.count {
            let at = Some(i);
            let own = &self.operator[i][i];
            let (slip, normal, mu, e) = (self.slip[i], self.normal[i], self.friction[i], self.restitution[i]);
            for b in &self.operator[i][..self.count] {
                for entry in [b.tt, b.tn, b.nt, b.nn] {
                    faults.finite(at, Quantity::Operator, entry);
                }
            }
            faults.finite(at, Quantity::Slip, slip);
            faults.finite(at, Quantity::NormalVelocity, normal);
            faults.finite(at, Quantity::Bound, mu);
            // What is not finite is named already.
            faults.check(mu >= 0.0 || !mu.is_finite(), at, Quantity::Friction, mu);
            faults.check(own.tt > 0.0 || !own.tt.is_finite(), at, Quantity::OwnTangential, own.tt);
            faults.check(own.nn > 0.0 || !own.nn.is_finite(), at, Quantity::OwnNormal, own.nn);
            faults.check((0.0..=1.0).contains(&e), at, Quantity::Restitution, e);
        }
        faults.refuse()?;
        // Each number is finite, but a sum of them is not.
        Err(ImpactError::Overflow)
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

/// Whether a free body can be struck at all.
fn check(mass: f64, inertia: f64, velocity: Vec2, spin: f64, touches: &[Touch]) -> Result<(), ImpactError> {
    let mut faults = Faults::NONE;
    faults.check(mass > 0.0, None, Quantity::Mass, mass);
    faults.check(inertia > 0.0, None, Quantity::Inertia, inertia);
    faults.finite(None, Quantity::VelocityX, velocity.x);
    faults.finite(None, Quantity::VelocityY, velocity.y);
    faults.finite(None, Quantity::Spin, spin);
    for (i, touch) in touches.iter().enumerate() {
        let length = touch.normal.norm();
        faults.check(length > 0.0 && length.is_finite(), Some(i), Quantity::Normal, length);
        faults.check(touch.arm.is_finite(), Some(i), Quantity::Arm, f64::NAN);
    }
    faults.refuse()
}

/// One block of the operator of a free body.
#[inline]
fn coupling(mass: f64, inertia: f64, a: &Touch, b: &Touch) -> Block {
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
