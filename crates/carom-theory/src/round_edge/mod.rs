//! A flat part that slides or rolls over a rounded edge: forces, equations of motion, and where it is balanced.
//!
//! The edge is a cylinder of radius ρ about O, the part's lower face touches it. θ is the tilt of the part, counter-clockwise,
//! `t = (cos θ, sin θ)` points along the lower face and `n = (−sin θ, cos θ)` out of the edge into the part, so that `ṅ = −ωt` and
//! `ṫ = ωn`. The mass centre C is c above the lower face, and s along t from the contact:
//!
//! ```text
//!    ______________n__________      C − O = (ρ+c) n + s t, with the contact at O + ρn
//!   |              ↑    C     |     gravity (0, −g)
//!   |______________|→t__|_____|     force on the part N n + F t
//!               .  o  . |           slip of its lower face on the edge  u = ṡ − ρω
//!              (   O   )  s > 0
//!
//! m(s̈ − (ρ+c)ω̇ − sω²) = F − mg sin θ
//! m(sω̇ + 2ṡω − (ρ+c)ω²) = N − mg cos θ
//! Jω̇ = cF − sN
//! ```
//!
//! The first two are C's acceleration along t and n, the third is the moment about C. A part that tips over the right-hand end of
//! a plate turns clockwise, θ < 0, and rolls back towards it: s decreases.
//!
//! Source: derived here from Newton's and Euler's laws; with ρ = 0 they are the equations of [`crate::rod_on_edge`], with r = s and
//! φ = −θ. That a board on a cylinder is stable while c < ρ is classical.

mod balance;
mod path;

use crate::OutsideDomain;
use crate::domain::{require_not_negative, require_positive};

/// The part and its edge.
///
/// # Example
/// Balanced on top, the edge carries the weight.
/// ```
/// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
/// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
/// let motion = part.rolling(&RoundEdgeState { offset: 0.0, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 });
/// assert_eq!((motion.normal_force, motion.friction_force, motion.tilt_acceleration), (20.0, 0.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundEdge {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the mass centre [kg m²].
    pub inertia: f64,
    /// c ≥ 0, half the thickness \[m\]: how far the mass centre is above the lower face.
    pub half_thickness: f64,
    /// ρ ≥ 0 of the edge \[m\].
    pub edge_radius: f64,
    /// g ≥ 0 [m/s²].
    pub gravity: f64,
}

/// State of a part on a round edge.
///
/// # Example
/// It rolls where ṡ = ρω.
/// ```
/// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
/// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
/// let rolls = RoundEdgeState { offset: 1.0, tilt: 0.0, offset_rate: 2.0, tilt_rate: 2.0 };
/// assert_eq!(part.slip(&rolls), 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundEdgeState {
    /// s, of the mass centre from the contact along t \[m\].
    pub offset: f64,
    /// θ, counter-clockwise from level \[rad\].
    pub tilt: f64,
    /// ṡ [m/s].
    pub offset_rate: f64,
    /// ω = θ̇ [rad/s].
    pub tilt_rate: f64,
}

/// Forces and accelerations of a part on a round edge.
///
/// # Example
/// Let go at the offset 1 it begins to roll clockwise: the moments about C give Jω̇ = cF − sN.
/// ```
/// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
/// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
/// let motion = part.rolling(&RoundEdgeState { offset: 1.0, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 });
/// let moment = 0.5 * motion.friction_force - motion.normal_force;
/// assert_eq!((1.5 * motion.tilt_acceleration, moment), (-7.5, -7.5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundEdgeMotion {
    /// N along n \[N\]; the part leaves the edge where it would become negative.
    pub normal_force: f64,
    /// F on the part, along t \[N\].
    pub friction_force: f64,
    /// s̈ [m/s²].
    pub offset_acceleration: f64,
    /// ω̇ [rad/s²].
    pub tilt_acceleration: f64,
}

impl RoundEdge {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::round_edge::RoundEdge;
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: -1.0, gravity: 10.0 };
    /// assert_eq!(part.check().map_err(|error| error.quantity), Err("edge radius"));
    /// assert_eq!(RoundEdge { edge_radius: 1.0, ..part }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_not_negative("half thickness", self.half_thickness)?;
        require_not_negative("edge radius", self.edge_radius)?;
        require_not_negative("gravity", self.gravity)
    }

    /// Slip u = ṡ − ρω of the part's lower face on the edge, along t [m/s].
    ///
    /// # Example
    /// ```
    /// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 0.5, gravity: 10.0 };
    /// assert_eq!(part.slip(&RoundEdgeState { offset: 0.0, tilt: 0.0, offset_rate: 3.0, tilt_rate: 2.0 }), 2.0);
    /// ```
    pub fn slip(&self, state: &RoundEdgeState) -> f64 {
        state.offset_rate - self.edge_radius * state.tilt_rate
    }

    /// Kinetic and potential energy, the latter zero at the height of O \[J\]; friction takes μN|u| of it per second.
    ///
    /// ```text
    /// E = m((ṡ − (ρ+c)ω)² + s²ω²)/2 + Jω²/2 + mg((ρ+c) cos θ + s sin θ)
    /// ```
    ///
    /// # Example
    ///
    /// A part that rolls has the kinetic energy (J + m(c² + s²)) ω²/2 = (1.5 + 2.5) 2²/2, here 1.5 above O.
    ///
    /// ```
    /// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// let rolls = RoundEdgeState { offset: 1.0, tilt: 0.0, offset_rate: 2.0, tilt_rate: 2.0 };
    /// assert_eq!(part.energy(&rolls), 8.0 + 30.0);
    /// ```
    pub fn energy(&self, state: &RoundEdgeState) -> f64 {
        let RoundEdgeState { offset: s, tilt, offset_rate, tilt_rate } = *state;
        let up = self.edge_radius + self.half_thickness;
        let (sin, cos) = libm::sincos(tilt);
        let (along, across) = (offset_rate - up * tilt_rate, s * tilt_rate);
        0.5 * self.mass * (along * along + across * across)
            + 0.5 * self.inertia * tilt_rate * tilt_rate
            + self.mass * self.gravity * (up * cos + s * sin)
    }

    /// Forces and accelerations while the part slips, with `F = −drag N`: drag is μ for a slip along t and −μ for one against it.
    ///
    /// ```text
    /// N = (g cos θ + 2ṡω − (ρ+c)ω²)/(1/m + s(s + drag c)/J)
    /// ω̇ = −N(s + drag c)/J
    /// s̈ = (ρ+c)ω̇ + sω² − g sin θ − drag N/m
    /// ```
    ///
    /// # Limits
    /// Holds while N ≥ 0 and the part touches the edge with its lower face. `1/m + s(s + drag c)/J ≤ 0` is Painlevé's case, where
    /// no such force exists.
    ///
    /// # Example
    ///
    /// Let go at the offset 1 with μ = 1/2 it needs all of the friction, forward, to roll: s̈ = ρω̇.
    ///
    /// ```
    /// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// let rest = RoundEdgeState { offset: 1.0, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    /// let motion = part.sliding(&rest, -0.5);
    /// assert_eq!((motion.normal_force, motion.friction_force), (10.0, 5.0)); // 10/(1/2 + 3/4 / 1.5)
    /// assert_eq!((motion.tilt_acceleration, motion.offset_acceleration), (-5.0, -5.0));
    /// ```
    pub fn sliding(&self, state: &RoundEdgeState, drag: f64) -> RoundEdgeMotion {
        let RoundEdgeState { offset: s, tilt, offset_rate, tilt_rate } = *state;
        let (m, j, c, g) = (self.mass, self.inertia, self.half_thickness, self.gravity);
        let up = self.edge_radius + c;
        let (sin, cos) = libm::sincos(tilt);
        let arm = s + drag * c;
        let inward = g * cos + 2.0 * offset_rate * tilt_rate - up * tilt_rate * tilt_rate;
        let normal = inward / (1.0 / m + s * arm / j);
        let turning = -normal * arm / j;
        RoundEdgeMotion {
            normal_force: normal,
            friction_force: -drag * normal,
            offset_acceleration: up * turning + s * tilt_rate * tilt_rate - g * sin - drag * normal / m,
            tilt_acceleration: turning,
        }
    }

    /// Forces and accelerations while the part rolls; ṡ is taken as ρω, whatever the state says.
    ///
    /// ```text
    /// ω̇ = −m(ρsω² + g(s cos θ − c sin θ))/(J + m(c² + s²)),   s̈ = ρω̇
    /// N = m(sω̇ + (ρ−c)ω² + g cos θ)
    /// F = m(g sin θ − sω² − cω̇)
    /// ```
    ///
    /// # Limits
    /// Holds while |F| ≤ μN and the part touches the edge with its lower face.
    ///
    /// # Example
    ///
    /// ω̇ = −mgs/(J + m(c² + s²)) = −20/4 from rest, mg − N = −msω̇ and F = −mcω̇.
    ///
    /// ```
    /// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// let rest = RoundEdgeState { offset: 1.0, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    /// let motion = part.rolling(&rest);
    /// assert_eq!((motion.tilt_acceleration, motion.offset_acceleration), (-5.0, -5.0));
    /// assert_eq!((motion.normal_force, motion.friction_force), (10.0, 5.0));
    /// ```
    pub fn rolling(&self, state: &RoundEdgeState) -> RoundEdgeMotion {
        self.rolling_with(state.offset, state.tilt, state.tilt_rate * state.tilt_rate)
    }

    /// As [`Self::rolling`], which only depends on the square of the spin.
    fn rolling_with(&self, s: f64, tilt: f64, spin_squared: f64) -> RoundEdgeMotion {
        let (m, c, rho, g) = (self.mass, self.half_thickness, self.edge_radius, self.gravity);
        let (sin, cos) = libm::sincos(tilt);
        let driving = rho * s * spin_squared + g * (s * cos - c * sin);
        let turning = -m * driving / self.inertia_about_contact(s);
        RoundEdgeMotion {
            normal_force: m * (s * turning + (rho - c) * spin_squared + g * cos),
            friction_force: m * (g * sin - s * spin_squared - c * turning),
            offset_acceleration: rho * turning,
            tilt_acceleration: turning,
        }
    }

    /// J + m(c² + s²).
    fn inertia_about_contact(&self, s: f64) -> f64 {
        self.inertia + self.mass * (self.half_thickness * self.half_thickness + s * s)
    }
}
