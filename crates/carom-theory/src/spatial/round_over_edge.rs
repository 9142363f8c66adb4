//! A ball or a lying cylinder that goes over a straight, level edge.

use crate::OutsideDomain;
use crate::domain::{require, require_finite, require_positive};

/// A ball, or a cylinder or capsule that lies along the edge: the moment about the axis along the edge is `J = k m ρ²`, and the mass centre is ρ from the edge.
///
/// φ is the angle from upright of the line from the edge to the axis. The edge pushes with N along that line; friction holds the material that touches it with F, or not at all:
///
/// ```text
/// φ̇² = φ̇₀² + 2 g (cos φ₀ − cos φ)/(ρ (1 + k))      N = m (g cos φ − ρ φ̇²)      F = m g sin φ · k/(1 + k)
/// ```
///
/// and without friction the same with k = 0. A *ball* that rolls goes along the edge too. With its spin ω_n about that line and ω_t about the third axis, so that its middle goes
/// along the edge with −ρ ω_t,
///
/// ```text
/// dω_t/dφ = −λ² ω_n,    dω_n/dφ = ω_t,    λ² = k/(1 + k)
/// ```
///
/// λ² is 2/7 for a solid ball: it turns back along the edge as a golf ball does in its hole.
///
/// Source: derived here from Newton's and Euler's laws, with the axes e along the edge, n from the edge to the middle and t = e × n. On a cylinder the ball's √(2/7) is classical:
/// M. Gualtieri, T. Tokieda, L. Advis-Gaete, B. Carry, E. Reffet and C. Guthmann, American Journal of Physics 74 (2006) 497.
///
/// # Example
/// From rest on top a ball that rolls would leave where cos φ = 10/17, and one without friction where it is 2/3.
/// ```
/// use carom_theory::spatial::RoundOverEdge;
/// let ball = RoundOverEdge { radius: 0.1, share: 0.4, gravity: 9.81 };
/// assert!((ball.leaves([0.0, 0.0])? - 10.0 / 17.0).abs() < 1e-15);
/// let smooth = RoundOverEdge { share: 0.0, ..ball };
/// assert!((smooth.leaves([0.0, 0.0])? - 2.0 / 3.0).abs() < 1e-15);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundOverEdge {
    /// ρ > 0 \[m\].
    pub radius: f64,
    /// k in \[0, 1\]: 0 where nothing turns it, without friction.
    pub share: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

impl RoundOverEdge {
    fn check(&self, [angle, rate]: [f64; 2]) -> Result<(), OutsideDomain> {
        require_positive("radius", self.radius)?;
        require((0.0..=1.0).contains(&self.share), "share", self.share, "in [0, 1]")?;
        require_positive("gravity", self.gravity)?;
        require_finite("angle", angle)?;
        require_finite("rate", rate)
    }

    /// φ̇² at an angle φ \[rad\], after a start \[φ₀, φ̇₀\]; negative where it does not come so far [rad²/s²].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn square(&self, start: [f64; 2], angle: f64) -> Result<f64, OutsideDomain> {
        self.check(start)?;
        require_finite("angle", angle)?;
        let [from, rate] = start;
        let fallen = libm::cos(from) - libm::cos(angle);
        Ok(rate * rate + 2.0 * self.gravity * fallen / (self.radius * (1.0 + self.share)))
    }

    /// The cosine of the angle at which nothing pushes it any more, were friction without bound, after a start \[φ₀, φ̇₀\]: above 1 where it never touches.
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn leaves(&self, start: [f64; 2]) -> Result<f64, OutsideDomain> {
        self.check(start)?;
        let [from, rate] = start;
        let given = libm::cos(from) + 0.5 * rate * rate * self.radius * (1.0 + self.share) / self.gravity;
        Ok(2.0 * given / (3.0 + self.share))
    }

    /// F and N at an angle, in units of the weight.
    ///
    /// # Errors
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// On top nothing has to hold it.
    /// ```
    /// use carom_theory::spatial::RoundOverEdge;
    /// let ball = RoundOverEdge { radius: 0.1, share: 0.4, gravity: 9.81 };
    /// assert_eq!(ball.forces([0.0, 0.0], 0.0)?, [0.0, 1.0]);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn forces(&self, start: [f64; 2], angle: f64) -> Result<[f64; 2], OutsideDomain> {
        let square = self.square(start, angle)?;
        let across = libm::sin(angle) * self.share / (1.0 + self.share);
        Ok([across, libm::cos(angle) - self.radius * square / self.gravity])
    }

    /// ω_t and ω_n of a ball that has rolled on by an angle \[rad\] from where they were these \[rad/s\].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// One that spins about the line from the edge to its middle starts to go along the edge.
    /// ```
    /// use carom_theory::spatial::RoundOverEdge;
    /// let ball = RoundOverEdge { radius: 0.1, share: 0.4, gravity: 9.81 };
    /// let [t, n] = ball.spins([0.0, 7.0], 1e-3)?;
    /// assert!((t + 2e-3).abs() < 1e-8 && (n - 7.0).abs() < 1e-5);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn spins(&self, [across, about]: [f64; 2], angle: f64) -> Result<[f64; 2], OutsideDomain> {
        self.check([angle, across])?;
        require_finite("spin", about)?;
        let lambda = (self.share / (1.0 + self.share)).sqrt();
        let (sine, cosine) = (libm::sin(lambda * angle), libm::cos(lambda * angle));
        let turned = if lambda > 0.0 { sine / lambda } else { angle };
        Ok([across * cosine - lambda * about * sine, about * cosine + across * turned])
    }
}
