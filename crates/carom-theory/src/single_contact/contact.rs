//! What a contact is given, and what its impact is.

use super::classify::Numbers;
use crate::OutsideDomain;
use crate::domain::{require, require_finite, require_not_negative, require_positive};
use crate::products::difference_of_products;

/// How restitution is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// p_n(restitution) = e · p_n(compression) (Poisson).
    Poisson,
    /// Work of the normal impulse in restitution = −e² × its work in compression (Stronge 1990).
    Stronge,
    /// u_n⁺ = −e u_n⁻ (Newton). Creates energy in some impacts of types 4 to 7.
    Newton,
}

/// The seven types of Plavnieks (1969), each one class of Wang and Mason (1992).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ImpactType {
    /// Type 1, *sliding*: slips throughout in the initial direction.
    SlidesThroughout = 1,
    /// Type 2: no slip before, slips all the same.
    SlipsFromRest = 2,
    /// Type 3: no slip before, sticks.
    SticksFromRest = 3,
    /// Type 4, *R-reversed*: the slip reverses in restitution.
    ReversesInRestitution = 4,
    /// Type 5, *C-reversed*: the slip reverses in compression.
    ReversesInCompression = 5,
    /// Type 6, *R-sticking*: the slip stops for good in restitution.
    StopsInRestitution = 6,
    /// Type 7, *C-sticking*: the slip stops for good in compression.
    StopsInCompression = 7,
}

impl ImpactType {
    /// The number 1…7.
    pub fn number(self) -> u8 {
        self as u8
    }

    /// True for types 3, 6 and 7, which end without slip.
    pub fn sticks(self) -> bool {
        matches!(self, Self::SticksFromRest | Self::StopsInRestitution | Self::StopsInCompression)
    }
}

/// The symmetric inverse inertia `W = J M⁻¹ Jᵀ` of a contact [1/kg], in its frame (t, n).
///
/// # Example
/// A unit impulse along the normal changes the velocity by W's last column.
/// ```
/// let w = carom_theory::single_contact::Operator { tt: 2.0, tn: 1.0, nn: 3.0 };
/// assert_eq!(w.velocity_change(0.0, 1.0), (1.0, 3.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Operator {
    /// W_tt > 0.
    pub tt: f64,
    /// W_tn.
    pub tn: f64,
    /// W_nn > 0.
    pub nn: f64,
}

impl Operator {
    /// `W_tt W_nn − W_tn²`, within 1.5 units in the last place of the entries given.
    ///
    /// # Example
    /// ```
    /// use carom_theory::single_contact::Operator;
    /// assert_eq!(Operator { tt: 2.0, tn: 1.0, nn: 3.0 }.determinant(), 5.0);
    /// ```
    pub fn determinant(&self) -> f64 {
        difference_of_products(self.tt, self.nn, self.tn, self.tn)
    }

    /// The velocity change `W p` of an impulse `(p_t, p_n)`.
    ///
    /// # Example
    /// ```
    /// use carom_theory::single_contact::Operator;
    /// assert_eq!(Operator { tt: 2.0, tn: 1.0, nn: 3.0 }.velocity_change(1.0, 2.0), (4.0, 7.0));
    /// ```
    pub fn velocity_change(&self, tangential: f64, normal: f64) -> (f64, f64) {
        (self.tt * tangential + self.tn * normal, self.tn * tangential + self.nn * normal)
    }
}

/// One contact at the instant of its impact.
///
/// # Example
/// A contact that opens takes no impulse.
/// ```
/// use carom_theory::single_contact::{Contact, Law, Operator, resolve};
/// let w = Operator { tt: 2.0, tn: 1.0, nn: 3.0 };
/// let opening = Contact { w, slip: 1.0, approach: 0.5, friction: 0.25, restitution: 0.5 };
/// let impact = resolve(&opening, Law::Poisson)?;
/// assert_eq!((impact.kind, impact.normal_impulse, impact.normal_velocity_after), (None, 0.0, 0.5));
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Inverse inertia [1/kg].
    pub w: Operator,
    /// S₀ = u_t⁻ [m/s].
    pub slip: f64,
    /// C₀ = u_n⁻ [m/s]: negative when the contact closes.
    pub approach: f64,
    /// μ ≥ 0.
    pub friction: f64,
    /// e in 0…1, of the law that is asked.
    pub restitution: f64,
}

impl Contact {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity that lies outside the domain of the closed forms.
    ///
    /// # Example
    /// ```
    /// use carom_theory::single_contact::{Contact, Operator};
    /// let w = Operator { tt: 1.0, tn: 0.0, nn: 1.0 };
    /// let contact = Contact { w, slip: 1.0, approach: -1.0, friction: -0.5, restitution: 0.5 };
    /// assert_eq!(contact.check().map_err(|error| error.quantity), Err("friction"));
    /// assert_eq!(Contact { friction: 0.5, ..contact }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("W_tt", self.w.tt)?;
        require_positive("W_nn", self.w.nn)?;
        require_finite("W_tn", self.w.tn)?;
        let determinant = self.w.determinant();
        require_positive("W_tt W_nn - W_tn^2", determinant)?;
        require_finite("slip", self.slip)?;
        require_finite("approach", self.approach)?;
        require_not_negative("friction", self.friction)?;
        let e = self.restitution;
        require((0.0..=1.0).contains(&e), "restitution", e, "0 <= e <= 1")
    }
}

/// Works of the impulses on the body \[J\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Of the normal impulse in compression, ≤ 0.
    pub compression: f64,
    /// Of the normal impulse in restitution, ≥ 0.
    pub restitution: f64,
    /// Of the tangential impulse, ≤ 0.
    pub tangential: f64,
}

impl Work {
    /// The change of kinetic energy, which is the sum of the three works \[J\]. Positive only under Newton's law.
    ///
    /// # Example
    /// ```
    /// let work = carom_theory::single_contact::Work { compression: -2.0, restitution: 0.5, tangential: -0.25 };
    /// assert_eq!(work.energy_change(), -1.75);
    /// ```
    pub fn energy_change(&self) -> f64 {
        self.compression + self.restitution + self.tangential
    }
}

/// One impact, resolved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// The law it was resolved under.
    pub law: Law,
    /// Its type, or `None` when no impulse is transmitted.
    pub kind: Option<ImpactType>,
    /// p_t [N s].
    pub tangential_impulse: f64,
    /// p_n ≥ 0 [N s].
    pub normal_impulse: f64,
    /// p_n at the end of compression [N s].
    pub compression_impulse: f64,
    /// p_n at which the initial slip stops [N s]; `None` for types 1, 2, 3 and for no impact.
    pub slip_stop_impulse: Option<f64>,
    /// u_t⁺ [m/s]; exactly 0 for the sticking types.
    pub slip_after: f64,
    /// u_n⁺ [m/s].
    pub normal_velocity_after: f64,
    /// Works of the impulses.
    pub work: Work,
    /// What classified it.
    pub numbers: Numbers,
}

impl Impact {
    /// `(|S₀| + |W_tt p_t| + |W_tn p_n|, |C₀| + |W_tn p_t| + |W_nn p_n|)`: what rounding in the velocities after is measured against.
    ///
    /// # Example
    /// ```
    /// use carom_theory::single_contact::{Contact, Law, Operator, resolve};
    /// let w = Operator { tt: 1.0, tn: 0.0, nn: 1.0 };
    /// let thrown = Contact { w, slip: 1.0, approach: -1.0, friction: 0.25, restitution: 1.0 };
    /// assert_eq!(resolve(&thrown, Law::Newton)?.velocity_scale(&thrown), (1.5, 3.0));
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn velocity_scale(&self, contact: &Contact) -> (f64, f64) {
        let w = Operator { tn: contact.w.tn.abs(), ..contact.w };
        let change = w.velocity_change(self.tangential_impulse.abs(), self.normal_impulse);
        (contact.slip.abs() + change.0, contact.approach.abs() + change.1)
    }
}
