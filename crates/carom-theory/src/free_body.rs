//! A free rigid body in the plane at one contact: inverse inertia, contact velocity and the motion after an impulse.
//!
//! ```text
//! r = contact point − mass centre = (r_t, r_n)
//! W_tt = 1/m + r_n²/J,   W_tn = −r_t r_n/J,   W_nn = 1/m + r_t²/J
//! u_t = v_t − ω r_n,     u_n = v_n + ω r_t
//! ```
//!
//! Source: Routh (1860); any text on impact, for instance Stronge, *Impact Mechanics* (2000), chapter 3.

use crate::single_contact::Operator;

/// Mass and central moment of inertia.
///
/// # Example
/// An impulse along a line through the mass centre does not turn the body.
/// ```
/// use carom_theory::free_body::{FreeBody, PlanarVelocity};
/// let falling = PlanarVelocity { first: 0.0, second: -1.0, spin: 0.0 };
/// let after = FreeBody { mass: 2.0, inertia: 0.5 }.after_impulse(falling, [0.0, -1.0], [0.0, 3.0]);
/// assert_eq!((after.second, after.spin), (0.5, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeBody {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the mass centre [kg m²].
    pub inertia: f64,
}

/// A velocity of the mass centre and a counter-clockwise spin.
///
/// # Example
/// A wheel of radius 0.5 that rolls forward: its lowest point is at rest.
/// ```
/// use carom_theory::free_body::{PlanarVelocity, contact_velocity};
/// let rolling = PlanarVelocity { first: 1.0, second: 0.0, spin: -2.0 };
/// assert_eq!(contact_velocity(rolling, [0.0, -0.5]), [0.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarVelocity {
    /// Component along the first axis (t, or x) [m/s].
    pub first: f64,
    /// Component along the second axis (n, or y) [m/s].
    pub second: f64,
    /// Counter-clockwise spin [rad/s].
    pub spin: f64,
}

impl FreeBody {
    /// The operator W at a contact whose point lies at `arm = (r_t, r_n)` from the mass centre.
    ///
    /// The determinant is `1/m² + (r_t² + r_n²)/(mJ)`; formed from the entries instead it loses about
    /// `log₁₀(m r²/J)` digits when the arm is much longer than the radius of gyration.
    ///
    /// # Example
    ///
    /// A uniform rod of mass 1 and length 2 (J = 1/3) that strikes with its end, lying at 45°: r² = 1, r_t² = r_n² = 1/2.
    ///
    /// ```
    /// use carom_theory::free_body::FreeBody;
    /// let rod = FreeBody { mass: 1.0, inertia: 1.0 / 3.0 };
    /// let w = rod.operator([-0.5f64.sqrt(), -0.5f64.sqrt()]);
    /// assert!((w.tt - 2.5).abs() < 1e-15 && (w.tn + 1.5).abs() < 1e-15 && (w.nn - 2.5).abs() < 1e-15);
    /// ```
    pub fn operator(&self, arm: [f64; 2]) -> Operator {
        let [r_t, r_n] = arm;
        let (free, turning) = (1.0 / self.mass, 1.0 / self.inertia);
        Operator { tt: free + r_n * r_n * turning, tn: -r_t * r_n * turning, nn: free + r_t * r_t * turning }
    }

    /// The motion after an impulse `(p_t, p_n)` at `arm`: `v⁺ = v⁻ + p/m`, `ω⁺ = ω⁻ + (r_t p_n − r_n p_t)/J`.
    ///
    /// # Example
    /// ```
    /// use carom_theory::free_body::{FreeBody, PlanarVelocity};
    /// let body = FreeBody { mass: 2.0, inertia: 0.5 };
    /// let falling = PlanarVelocity { first: 0.0, second: -1.0, spin: 0.0 };
    /// let after = body.after_impulse(falling, [1.0, 0.0], [0.0, 1.0]);
    /// assert_eq!(after, PlanarVelocity { first: 0.0, second: -0.5, spin: 2.0 });
    /// ```
    pub fn after_impulse(&self, before: PlanarVelocity, arm: [f64; 2], impulse: [f64; 2]) -> PlanarVelocity {
        let ([r_t, r_n], [p_t, p_n]) = (arm, impulse);
        PlanarVelocity {
            first: before.first + p_t / self.mass,
            second: before.second + p_n / self.mass,
            spin: before.spin + (r_t * p_n - r_n * p_t) / self.inertia,
        }
    }

    /// Kinetic energy \[J\].
    ///
    /// # Example
    /// ```
    /// use carom_theory::free_body::{FreeBody, PlanarVelocity};
    /// let body = FreeBody { mass: 2.0, inertia: 0.5 };
    /// assert_eq!(body.kinetic_energy(PlanarVelocity { first: 3.0, second: 4.0, spin: 2.0 }), 26.0);
    /// ```
    pub fn kinetic_energy(&self, v: PlanarVelocity) -> f64 {
        0.5 * (self.mass * (v.first * v.first + v.second * v.second) + self.inertia * v.spin * v.spin)
    }
}

/// The velocity `(u_t, u_n)` of the body's point at `arm` from its mass centre.
///
/// # Example
/// ```
/// use carom_theory::free_body::{PlanarVelocity, contact_velocity};
/// let v = PlanarVelocity { first: 1.0, second: -2.0, spin: 3.0 };
/// assert_eq!(contact_velocity(v, [0.5, -1.0]), [4.0, -0.5]);
/// ```
pub fn contact_velocity(v: PlanarVelocity, arm: [f64; 2]) -> [f64; 2] {
    [v.first - v.spin * arm[1], v.second + v.spin * arm[0]]
}

/// The components (t, n) of a vector (x, y), for a unit normal `n = (n_x, n_y)`; `t = (n_y, −n_x)`.
///
/// # Example
/// ```
/// use carom_theory::free_body::into_contact_frame;
/// assert_eq!(into_contact_frame([0.0, 1.0], [3.0, 4.0]), [3.0, 4.0]); // a floor: t = x
/// assert_eq!(into_contact_frame([-1.0, 0.0], [3.0, 4.0]), [4.0, -3.0]); // a wall on the right: t = y
/// ```
pub fn into_contact_frame(normal: [f64; 2], vector: [f64; 2]) -> [f64; 2] {
    let ([n_x, n_y], [x, y]) = (normal, vector);
    [n_y * x - n_x * y, n_x * x + n_y * y]
}
