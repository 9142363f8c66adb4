//! A part that hangs over a sharp edge with the edge in an inner corner of it: an L on a post, or over the end of a plate.
//!
//! ```text
//!      n_l  u  n_r         K   the inner corner, on the edge: the part turns about it
//!        ↖  ↑  ↗           C   the mass centre, h from K, somewhere below
//!       ____|____          u   from C to K, up while the part hangs at rest
//!      /    K    \         n   normals of the two faces, out of the edge into the part, ν_l to the left of u and ν_r to the right:
//!     /   / | \   \            the hollow is open by γ = π − ν_l − ν_r
//!    /___/  |  \___\       φ   the tilt from there, counter-clockwise: C = K + h (sin φ, −cos φ)
//!           |
//!
//! (J + mh²) φ̈ = −mgh sin φ
//! force of the edge   along u     m(g cos φ + hφ̇²)
//!                     along e     mg sin φ J/(J + mh²),      e = (cos φ, sin φ), C's way
//! ```
//!
//! The part stays as long as this force lies within the friction cones of both faces and between them, which is at most λ = atan μ
//! outside of n_l and of n_r. It leaves over one side: there the one face opens, and the other slides on the edge as in
//! [`crate::rod_on_edge`].
//!
//! Source: the physical pendulum, Landau and Lifshitz, Mechanics, §11; a point of a body that is stopped, Routh, Elementary Part, on
//! impulsive forces: the moment of momentum about the point is kept. When it slips out is derived here from Coulomb's law.

mod corner;
mod swing;

pub use corner::Caught;

use crate::OutsideDomain;
use crate::domain::{require, require_positive};
use core::f64::consts::{FRAC_PI_2, PI};

/// A part with an inner corner on a sharp edge.
///
/// # Example
/// Let go at tan φ = 3/4 the edge carries 16 towards the corner and 6 across.
/// ```
/// use carom_theory::hooked_part::HookedPart;
/// let eighth = std::f64::consts::FRAC_PI_4;
/// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [eighth; 2], gravity: 10.0 };
/// let [along, across] = part.edge_force([0.75f64.atan(), 0.0]);
/// assert!((along - 16.0).abs() < 1e-14 && (across - 6.0).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HookedPart {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the mass centre [kg m²].
    pub inertia: f64,
    /// h > 0, from the inner corner to the mass centre \[m\].
    pub arm: f64,
    /// ν_l to the left and ν_r to the right of u, of the normals of the two faces \[rad\].
    pub normals: [f64; 2],
    /// g > 0 [m/s²].
    pub gravity: f64,
}

impl HookedPart {
    /// A uniform L: one leg to the left, one down, with inner faces of the lengths p and q, both w thick.
    ///
    /// ```text
    ///       p                       C − K = (w² − p² + qw, w² − q² + pw)/(2(p + q + w))
    ///    _________ w                (J + mh²)/m = (p³ + q³ + w²(p + q) + 2w³)/(3(p + q + w))
    ///   |_______K |                 tan ν_l = (p² − w² − qw)/(q² − w² − pw),   ν_r = π/2 − ν_l
    ///           | | q
    ///           |_|
    /// ```
    ///
    /// Both are those of two rectangles.
    ///
    /// # Limits
    /// p, q > 0, w ≥ 0; the mass centre is not at the corner.
    ///
    /// # Example
    /// A bent wire: C is 2/3 to the left of the corner and 1/6 below, and m(8 + 1)/(3 · 3) is left of the inertia.
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let wire = HookedPart::of_l(6.0, [2.0, 1.0], 0.0, 10.0);
    /// assert!((wire.arm * wire.arm - 17.0 / 36.0).abs() < 1e-15 && (wire.normals[0].tan() - 4.0).abs() < 1e-14);
    /// assert!((wire.inertia_about_edge() - 6.0).abs() < 1e-14);
    /// ```
    pub fn of_l(mass: f64, [p, q]: [f64; 2], w: f64, gravity: f64) -> Self {
        let all = p + q + w;
        let left = (p * p - w * w - q * w) / (2.0 * all);
        let below = (q * q - w * w - p * w) / (2.0 * all);
        let square = left * left + below * below;
        let about_corner = (p * p * p + q * q * q + w * w * (p + q + 2.0 * w)) / (3.0 * all);
        let to_the_left = libm::atan2(left, below);
        Self {
            mass,
            inertia: mass * (about_corner - square),
            arm: square.sqrt(),
            normals: [to_the_left, FRAC_PI_2 - to_the_left],
            gravity,
        }
    }

    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let flat = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.5, -0.5], gravity: 10.0 };
    /// assert_eq!(flat.check().map_err(|error| error.quantity), Err("angle between the normals"));
    /// assert_eq!(HookedPart { normals: [0.5, 0.5], ..flat }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_positive("arm", self.arm)?;
        let between = self.normals[0] + self.normals[1];
        require(between > 0.0 && between < PI, "angle between the normals", between, "0 < angle < pi")?;
        require_positive("gravity", self.gravity)
    }

    /// Inertia about the edge, J + mh² [kg m²].
    ///
    /// # Example
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [0.8; 2], gravity: 10.0 };
    /// assert_eq!(part.inertia_about_edge(), 4.0);
    /// ```
    pub fn inertia_about_edge(&self) -> f64 {
        self.inertia + self.mass * self.arm * self.arm
    }

    /// Tilts between which a thin plate stays inside of the hollow, that runs from the edge at an angle δ, counter-clockwise from
    /// straight down \[rad\]: `[δ − (π/2 − ν_r), δ + π/2 − ν_l]`. At the first the right face lies on the plate, at the second the left one.
    ///
    /// # Example
    /// A post, in a hollow of 90° that hangs evenly, leaves 45° to either side.
    /// ```
    /// use carom_theory::hooked_part::HookedPart;
    /// let eighth = std::f64::consts::FRAC_PI_4;
    /// let part = HookedPart { mass: 2.0, inertia: 2.0, arm: 1.0, normals: [eighth; 2], gravity: 10.0 };
    /// assert_eq!(part.lying_tilts(0.0), [-eighth, eighth]);
    /// ```
    pub fn lying_tilts(&self, plate: f64) -> [f64; 2] {
        [plate - FRAC_PI_2 + self.normals[1], plate + FRAC_PI_2 - self.normals[0]]
    }
}

#[cfg(test)]
mod tests;
