//! A flat part that slides and tips over the edge of a plate: normal force and equations of motion.
//!
//! The edge is the origin, x along the plate downhill, y into the plate, angles turn x towards y, so that φ > 0 when the leading
//! end has sunk. `e_r` points along the part's lower face, `e_φ` is perpendicular to it, away from the part; the mass centre is at
//! `r e_r − c e_φ`, where c is half the thickness (0 for a thin rod).
//!
//! ```text
//! slip at the edge   ṙ,  s = sign ṙ
//! N = (g cos(α+φ) − 2ṙφ̇ − cφ̇²)/(1/m + r(r + sμc)/J)
//! φ̈ = N (r + sμc)/J
//! r̈ = rφ̇² − cφ̈ + g sin(α+φ) − sμN/m
//! ```
//!
//! At `r = −sμc` the part is balanced: this is where it begins to tip (`incline::tipping_offset_sliding`).
//!
//! Source: for c = 0, Polukoshko, Kononova and Sokolova, gravity-impact part feeder (ETR), second stage of motion; the thickness is ours.

/// The part, its plate and its friction.
///
/// # Example
/// On a level plate, balanced over the edge, the edge carries the weight.
/// ```
/// use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};
/// let rod = PartOnEdge {
///     mass: 3.0, inertia: 1.0, half_thickness: 0.1, friction: 0.2, slope: 0.0, gravity: 4.0,
/// };
/// let motion = rod.motion(&EdgeState { reach: 0.0, tilt: 0.0, slip: 0.0, tilt_rate: 0.0 });
/// assert_eq!((motion.normal_force, motion.tilt_acceleration), (12.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartOnEdge {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the mass centre [kg m²].
    pub inertia: f64,
    /// c, half the thickness \[m\]: how far the mass centre is above the lower face; negative of a part that hangs over the edge.
    pub half_thickness: f64,
    /// μ ≥ 0.
    pub friction: f64,
    /// Slope α of the plate below the horizontal \[rad\].
    pub slope: f64,
    /// g ≥ 0 [m/s²].
    pub gravity: f64,
}

/// State of a part on an edge.
///
/// # Example
/// A rod that only turns about the edge has the energy (J + mr²) φ̇²/2 = (1 + 3) 2²/2 while it is level.
/// ```
/// use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};
/// let rod = PartOnEdge {
///     mass: 3.0, inertia: 1.0, half_thickness: 0.0, friction: 0.2, slope: 0.0, gravity: 4.0,
/// };
/// assert_eq!(rod.energy(&EdgeState { reach: 1.0, tilt: 0.0, slip: 0.0, tilt_rate: 2.0 }), 8.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeState {
    /// r, the way of the mass centre beyond the edge along the part \[m\].
    pub reach: f64,
    /// φ, from the plate to the part, positive with the leading end down \[rad\].
    pub tilt: f64,
    /// ṙ, which is the slip at the edge [m/s].
    pub slip: f64,
    /// φ̇, clockwise when x points right [rad/s].
    pub tilt_rate: f64,
}

/// Force and accelerations of a part on an edge.
///
/// # Example
/// Let go at the reach 1 it turns about the edge: φ̈ = mgr/(J + mr²) = 12/4, and mg − N = mrφ̈.
/// ```
/// use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};
/// let rod = PartOnEdge {
///     mass: 3.0, inertia: 1.0, half_thickness: 0.0, friction: 0.2, slope: 0.0, gravity: 4.0,
/// };
/// let motion = rod.motion(&EdgeState { reach: 1.0, tilt: 0.0, slip: 0.0, tilt_rate: 0.0 });
/// assert!((motion.tilt_acceleration - 3.0).abs() < 1e-15);
/// assert!((12.0 - motion.normal_force - 3.0 * motion.tilt_acceleration).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeMotion {
    /// N \[N\]; the part leaves the edge where it would become negative.
    pub normal_force: f64,
    /// r̈ [m/s²].
    pub slip_rate: f64,
    /// φ̈ [rad/s²].
    pub tilt_acceleration: f64,
}

impl PartOnEdge {
    /// Normal force and accelerations while the part touches the edge and slips; without slip (ṙ = 0) it is taken as frictionless.
    ///
    /// # Limits
    /// Holds while N ≥ 0 and the edge lies on the lower face. `1/m + r(r + sμc)/J ≤ 0` is Painlevé's case, where no such force exists.
    ///
    /// # Example
    ///
    /// A thin rod (m = 0.3, J = 2.5e-4) on a 15° plate, its mass centre on the edge: N = mg cos α and no angular acceleration.
    ///
    /// ```
    /// use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};
    /// let rod = PartOnEdge {
    ///     mass: 0.3, inertia: 2.5e-4, half_thickness: 0.0, friction: 0.15, slope: 15f64.to_radians(), gravity: 9.81,
    /// };
    /// let motion = rod.motion(&EdgeState { reach: 0.0, tilt: 0.0, slip: 0.4728, tilt_rate: 0.0 });
    /// assert!((motion.normal_force - 2.8427).abs() < 1e-4 && motion.tilt_acceleration == 0.0);
    /// ```
    pub fn motion(&self, state: &EdgeState) -> EdgeMotion {
        let EdgeState { reach: r, tilt, slip, tilt_rate } = *state;
        let (m, j, c, g) = (self.mass, self.inertia, self.half_thickness, self.gravity);
        let drag = if slip == 0.0 { 0.0 } else { slip.signum() * self.friction };
        let (sin, cos) = libm::sincos(self.slope + tilt);
        let arm = r + drag * c;
        let normal = (g * cos - 2.0 * slip * tilt_rate - c * tilt_rate * tilt_rate) / (1.0 / m + r * arm / j);
        let turning = normal * arm / j;
        EdgeMotion {
            normal_force: normal,
            slip_rate: r * tilt_rate * tilt_rate - c * turning + g * sin - drag * normal / m,
            tilt_acceleration: turning,
        }
    }

    /// Kinetic and potential energy, the latter zero at the edge \[J\]; friction takes μN|ṙ| of it per second.
    ///
    /// ```text
    /// E = m((ṙ + cφ̇)² + r²φ̇²)/2 + Jφ̇²/2 − mg(r sin(α+φ) − c cos(α+φ))
    /// ```
    ///
    /// # Example
    /// ```
    /// use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};
    /// let rod = PartOnEdge {
    ///     mass: 2.0, inertia: 0.5, half_thickness: 0.0, friction: 0.0, slope: 0.0, gravity: 10.0,
    /// };
    /// assert_eq!(rod.energy(&EdgeState { reach: 1.0, tilt: 0.0, slip: 3.0, tilt_rate: 2.0 }), 14.0);
    /// ```
    pub fn energy(&self, state: &EdgeState) -> f64 {
        let EdgeState { reach: r, tilt, slip, tilt_rate } = *state;
        let (m, c) = (self.mass, self.half_thickness);
        let (sin, cos) = libm::sincos(self.slope + tilt);
        let (along, across) = (slip + c * tilt_rate, r * tilt_rate);
        0.5 * m * (along * along + across * across) + 0.5 * self.inertia * tilt_rate * tilt_rate
            - m * self.gravity * (r * sin - c * cos)
    }
}
