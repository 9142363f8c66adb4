//! A block that rolls on top of a fixed, level cylinder.

use crate::OutsideDomain;
use crate::domain::{require, require_finite, require_positive};

/// A block whose flat face lies on a fixed, level cylinder, and which rolls on it without slipping: the plank on a log.
///
/// φ is the angle of the face from level, and of the line of contact from the top. At φ = 0 the mass centre is above the axis, h over the face; the line of contact goes R φ along
/// the face. With n out of the cylinder, t along the face, and k the radius of gyration about the mass centre,
///
/// ```text
/// v = φ̇ (h t + R φ n)          y = (R + h) cos φ + R φ sin φ          φ̇² (k² + h² + R² φ²) + 2 g y = const
/// N = m (R φ φ̈ + (R − h) φ̇² + g cos φ)          F = m (h φ̈ + R φ φ̇² − g sin φ)
/// ```
///
/// Upright it is stable where R > h, and swings by little with `ω² = g (R − h)/(k² + h²)`.
///
/// Source: derived here from Newton's and Euler's laws; stability and the small swing are classical, as of rocking stones.
///
/// # Example
/// A thin plank of 2 b on a log swings by little with ω² = 3 g R/b².
/// ```
/// use carom_theory::spatial::BlockOnCylinder;
/// let (half, little) = (0.5, 1e-4);
/// let plank = BlockOnCylinder { radius: 0.1, height: 0.0, gyration: half / 3_f64.sqrt(), gravity: 9.81 };
/// let [turning, _, _] = plank.forces([little, 0.0], little)?;
/// let square = -turning / little;
/// assert!((square / (3.0 * 9.81 * 0.1 / (half * half)) - 1.0).abs() < 1e-7);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlockOnCylinder {
    /// R > 0 of the cylinder \[m\].
    pub radius: f64,
    /// h of the mass centre over the face, 0 or more \[m\].
    pub height: f64,
    /// k > 0 about the axis through the mass centre along the cylinder \[m\].
    pub gyration: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

impl BlockOnCylinder {
    fn check(&self, numbers: [f64; 3]) -> Result<(), OutsideDomain> {
        require_positive("radius", self.radius)?;
        require_finite("height", self.height)?;
        require(self.height >= 0.0, "height", self.height, "0 or more")?;
        require_positive("gyration", self.gyration)?;
        require_positive("gravity", self.gravity)?;
        let names = ["start angle", "start rate", "angle"];
        names.into_iter().zip(numbers).try_for_each(|(name, number)| require_finite(name, number))
    }

    /// The moment of inertia about the line of contact, of a unit of mass.
    fn inertia(&self, angle: f64) -> f64 {
        let Self { radius, height, gyration, .. } = *self;
        let run = radius * angle;
        gyration * gyration + height * height + run * run
    }

    /// The mass centre from the axis: aside, to where the block tips, and above \[m\].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::BlockOnCylinder;
    /// let block = BlockOnCylinder { radius: 0.2, height: 0.1, gyration: 0.1, gravity: 9.81 };
    /// let [aside, above] = block.centre(0.0)?;
    /// assert!(aside == 0.0 && (above - 0.3).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn centre(&self, angle: f64) -> Result<[f64; 2], OutsideDomain> {
        self.check([0.0, 0.0, angle])?;
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        let (out, run) = (self.radius + self.height, self.radius * angle);
        Ok([out * sine - run * cosine, out * cosine + run * sine])
    }

    /// φ̇² at an angle φ \[rad\], after a start \[φ₀, φ̇₀\]; negative where it does not come so far [rad²/s²].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn square(&self, [from, rate]: [f64; 2], angle: f64) -> Result<f64, OutsideDomain> {
        self.check([from, rate, angle])?;
        // By products instead of differences of heights: of small angles these keep their digits.
        let (half, mean) = (0.5 * (from - angle), 0.5 * (from + angle));
        let (sine, change) = (libm::sin(half), 2.0 * half);
        let fallen = -2.0 * (self.radius + self.height) * libm::sin(mean) * sine
            + self.radius * (change * libm::sin(from) + 2.0 * angle * libm::cos(mean) * sine);
        Ok((rate * rate * self.inertia(from) + 2.0 * self.gravity * fallen) / self.inertia(angle))
    }

    /// φ̈ at an angle [rad/s²], and F and N there in units of the weight, after a start \[φ₀, φ̇₀\].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// At rest on top nothing has to hold it.
    /// ```
    /// use carom_theory::spatial::BlockOnCylinder;
    /// let block = BlockOnCylinder { radius: 0.2, height: 0.1, gyration: 0.1, gravity: 9.81 };
    /// assert_eq!(block.forces([0.0, 0.0], 0.0)?, [0.0, 0.0, 1.0]);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn forces(&self, start: [f64; 2], angle: f64) -> Result<[f64; 3], OutsideDomain> {
        let square = self.square(start, angle)?;
        let Self { radius, height, gravity, .. } = *self;
        let (sine, cosine, run) = (libm::sin(angle), libm::cos(angle), radius * angle);
        let turning =
            (gravity * (height * sine - run * cosine) - radius * run * square) / self.inertia(angle);
        let along = height * turning + run * square - gravity * sine;
        let out = run * turning + (radius - height) * square + gravity * cosine;
        Ok([turning, along / gravity, out / gravity])
    }

    /// How long it takes from rest at an angle \[rad\] back to the top \[s\], a quarter of its period; infinite where it tips over instead.
    ///
    /// # Errors
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// Of small swings the quarter of 2 π/ω.
    /// ```
    /// use carom_theory::spatial::BlockOnCylinder;
    /// let block = BlockOnCylinder { radius: 0.2, height: 0.1, gyration: 0.1, gravity: 9.81 };
    /// let small = (0.02_f64 / (9.81 * 0.1)).sqrt() * std::f64::consts::FRAC_PI_2;
    /// assert!((block.quarter(1e-4)? / small - 1.0).abs() < 1e-7);
    /// assert_eq!(BlockOnCylinder { height: 0.3, ..block }.quarter(0.1)?, f64::INFINITY);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn quarter(&self, from: f64) -> Result<f64, OutsideDomain> {
        self.check([from, 0.0, 0.0])?;
        // With φ = φ₀ sin ψ nothing is singular at the start: the speed is zero there as the cosine is. The trapezoidal rule of a function of period π is exact to all digits.
        const PARTS: u32 = 400;
        let mut sum = 0.0;
        for k in 0..PARTS {
            let psi = std::f64::consts::FRAC_PI_2 * (f64::from(k) + 0.5) / f64::from(PARTS);
            let square = self.square([from, 0.0], from * libm::sin(psi))?;
            if square <= 0.0 {
                return Ok(f64::INFINITY);
            }
            sum += from.abs() * libm::cos(psi) / square.sqrt();
        }
        Ok(sum * std::f64::consts::FRAC_PI_2 / f64::from(PARTS))
    }
}
