//! A rod with both ends on a round hollow.

use crate::OutsideDomain;
use crate::domain::{require, require_positive};
use crate::pendulum;
use core::f64::consts::FRAC_PI_2;

/// A straight body whose ends A (left) and B (right) lie on a circular hollow.
///
/// Seen from the centre O of the hollow, B is β counter-clockwise of the rod's centre and A as much clockwise: sin β = l/R, cos β = h/R. The
/// tilt α is counter-clockwise, so that B rises with it; the rod's centre is at `O + h (sin α, −cos α)`.
///
/// # Example
/// A triangle of 3, 4 and 5; lying level, each end is pressed with mgR/(2h).
/// ```
/// use carom_theory::bridged_hollow::RodInHollow;
/// let rod = RodInHollow::uniform(1.0, 3.0, 5.0, 19.0);
/// assert_eq!((rod.depth(), rod.inertia), (4.0, 3.0));
/// assert_eq!(rod.forces(0.0, 0.0), [11.875, 11.875]); // 19 · 5/8
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RodInHollow {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the rod's centre, which is its mass centre [kg m²].
    pub inertia: f64,
    /// l > 0 \[m\].
    pub half_length: f64,
    /// R > l of the hollow \[m\].
    pub hollow_radius: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

impl RodInHollow {
    /// A uniform thin rod: J = ml²/3.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// assert_eq!(RodInHollow::uniform(2.0, 3.0, 5.0, 10.0).inertia, 6.0);
    /// ```
    pub fn uniform(mass: f64, half_length: f64, hollow_radius: f64, gravity: f64) -> Self {
        Self { mass, inertia: mass * half_length * half_length / 3.0, half_length, hollow_radius, gravity }
    }

    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// let long = RodInHollow::uniform(2.0, 5.0, 5.0, 10.0);
    /// assert_eq!(long.check().map_err(|error| error.quantity), Err("hollow radius"));
    /// assert_eq!(RodInHollow::uniform(2.0, 3.0, 5.0, 10.0).check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_positive("half length", self.half_length)?;
        let wide = self.hollow_radius > self.half_length && self.hollow_radius.is_finite();
        require(wide, "hollow radius", self.hollow_radius, "finite and > half length")?;
        require_positive("gravity", self.gravity)
    }

    /// h = √(R² − l²), of the rod's centre below O \[m\].
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// assert_eq!(RodInHollow::uniform(2.0, 3.0, 5.0, 10.0).depth(), 4.0);
    /// ```
    pub fn depth(&self) -> f64 {
        let (l, r) = (self.half_length, self.hollow_radius);
        ((r - l) * (r + l)).sqrt()
    }

    /// Inertia about O, J + mh²; of a uniform rod m(R² − 2l²/3) [kg m²].
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// assert_eq!(RodInHollow::uniform(1.0, 3.0, 5.0, 10.0).inertia_about_centre(), 19.0);
    /// ```
    pub fn inertia_about_centre(&self) -> f64 {
        let depth = self.depth();
        self.inertia + self.mass * depth * depth
    }

    /// ω₀² = mgh/(J + mh²) [1/s²]: without friction the rod is a pendulum about O, α̈ = −ω₀² sin α.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// assert_eq!(RodInHollow::uniform(1.0, 3.0, 5.0, 19.0).stiffness(), 4.0);
    /// ```
    pub fn stiffness(&self) -> f64 {
        self.mass * self.gravity * self.depth() / self.inertia_about_centre()
    }

    /// Square of the rate α̇ at a tilt of a rod that slides without friction from `[α₀, α̇₀]`, `α̇₀² + 2ω₀²(cos α − cos α₀)` [rad²/s²];
    /// negative at tilts that it does not reach.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// let square = RodInHollow::uniform(1.0, 3.0, 5.0, 19.0).rate_squared([60f64.to_radians(), 0.0], 0.0);
    /// assert!((square - 4.0).abs() < 1e-14); // 8 (1 − 1/2)
    /// ```
    pub fn rate_squared(&self, [from, rate]: [f64; 2], tilt: f64) -> f64 {
        let fall = 2.0 * libm::sin(0.5 * (from - tilt)) * libm::sin(0.5 * (from + tilt));
        rate * rate + 2.0 * self.stiffness() * fall
    }

    /// Period without friction with an amplitude A, `2π/(ω₀ agm(1, cos(A/2)))` \[s\].
    ///
    /// # Errors
    /// `amplitude` where it is not below π in size.
    ///
    /// # Limits
    /// |A| ≤ [`RodInHollow::lifting_amplitude`]; the hollow reaches up to A + β.
    ///
    /// # Source
    /// Landau and Lifshitz, Mechanics, §11, problem 1; the arithmetic-geometric mean (agm) is Gauss's.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// let small = RodInHollow::uniform(1.0, 3.0, 5.0, 19.0).period(0.0).expect("below 180°");
    /// assert_eq!(small, std::f64::consts::PI); // ω₀ = 2
    /// ```
    pub fn period(&self, amplitude: f64) -> Result<f64, OutsideDomain> {
        pendulum::period(self.stiffness(), amplitude)
    }

    /// Forces at A and at B, towards O, at a tilt α and a rate α̇ without friction \[N\]; an end lifts where its force would become negative.
    ///
    /// ```text
    /// N = (R/2)(m(g cos α + hα̇²)/h ± mg sin α J/(l(J + mh²)))      + at A, − at B
    /// ```
    ///
    /// # Example
    ///
    /// The lower end carries more: 2.5 (19 · 0.8/4 ± 19 · 0.6 · 3/57).
    ///
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// let [a, b] = RodInHollow::uniform(1.0, 3.0, 5.0, 19.0).forces(0.75f64.atan(), 0.0);
    /// assert!((a - 11.0).abs() < 1e-14 && (b - 8.0).abs() < 1e-14);
    /// ```
    pub fn forces(&self, tilt: f64, rate: f64) -> [f64; 2] {
        let (m, g, h) = (self.mass, self.gravity, self.depth());
        let (sin, cos) = libm::sincos(tilt);
        let inward = m * (g * cos + h * rate * rate) / h;
        let along = m * g * sin * self.inertia / (self.half_length * self.inertia_about_centre());
        [0.5 * self.hollow_radius * (inward + along), 0.5 * self.hollow_radius * (inward - along)]
    }

    /// Amplitude up to which both ends stay on the hollow without friction, `atan(l(J + mh²)/(hJ))` \[rad\]; of a uniform rod
    /// `atan((3h² + l²)/(hl))`. The upper end of the rod at the end of its swing is the first to lift.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// let rod = RodInHollow::uniform(1.0, 3.0, 5.0, 19.0);
    /// assert!((rod.lifting_amplitude().tan() - 4.75).abs() < 1e-14); // 57/12
    /// ```
    pub fn lifting_amplitude(&self) -> f64 {
        libm::atan2(self.half_length * self.inertia_about_centre(), self.depth() * self.inertia)
    }

    /// Largest tilt at which the rod can rest with a friction μ at both ends \[rad\]; `None` from μ = cot β = h/l on, where it holds itself at
    /// every tilt.
    ///
    /// ```text
    /// tan α = (tan(β+λ) − tan(β−λ))/2 = μR²/(h² − μ²l²),   λ = atan μ
    /// ```
    ///
    /// It rests if the vertical through its centre meets the quadrangle that the two friction cones share. Seen from the rod's centre,
    /// the corner of the quadrangle farthest aside lies between the flatter side of A's cone, π/2 − β − λ from the rod, and the steeper
    /// one of B's, π/2 − β + λ. From μ = h/l on each end lies in the cone of the other.
    ///
    /// # Limits
    /// Below it the forces are not determined by the tilt alone; the hollow reaches up to α + β.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// let rod = RodInHollow::uniform(1.0, 3.0, 5.0, 19.0);
    /// let tilt = rod.resting_tilt(0.5).expect("below 4/3");
    /// assert!((tilt.tan() - 10.0 / 11.0).abs() < 1e-15); // 12.5/(16 − 2.25)
    /// assert_eq!(rod.resting_tilt(1.5), None);
    /// ```
    pub fn resting_tilt(&self, friction: f64) -> Option<f64> {
        let (l, r, h) = (self.half_length, self.hollow_radius, self.depth());
        let open = (h - friction * l) * (h + friction * l);
        (friction * l < h).then(|| libm::atan2(friction * r * r, open))
    }

    /// Least friction with which the rod rests at a tilt of less than π/2.
    ///
    /// ```text
    /// μ = 2h² τ/(R² + √(R⁴ + 4h²l²τ²)),   τ = |tan α|
    /// ```
    ///
    /// # Errors
    /// `tilt` outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodInHollow;
    /// let rod = RodInHollow::uniform(1.0, 3.0, 5.0, 19.0);
    /// let friction = rod.friction_to_rest((10.0f64 / 11.0).atan()).expect("below 90°");
    /// assert!((friction - 0.5).abs() < 1e-15);
    /// ```
    pub fn friction_to_rest(&self, tilt: f64) -> Result<f64, OutsideDomain> {
        require(tilt.abs() < FRAC_PI_2, "tilt", tilt, "-pi/2 < tilt < pi/2")?;
        let (l, r, h) = (self.half_length, self.hollow_radius, self.depth());
        let slope = libm::tan(tilt).abs();
        let (square, lever) = (r * r, 2.0 * h * l * slope);
        Ok(2.0 * h * h * slope / (square + (square * square + lever * lever).sqrt()))
    }
}
