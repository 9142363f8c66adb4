//! A prism that tips over its edge A on a plane and lands on its edge K.

use super::{Strike, Tangential, solid_polygon_inertia_ratio};
use crate::OutsideDomain;
use crate::domain::{require_not_negative, require_positive};

/// A body with a flat face A–K, seen when that face meets the plane.
///
/// # Example
/// A cube of edge 2, J = 2m/3, that does not slip keeps (2/3)/(2/3 + 2) of its roll rate.
/// ```
/// use carom_theory::rocking::Prism;
/// let cube = Prism { mass: 1.0, inertia: 2.0 / 3.0, to_centre: 1.0, to_k: 1.0, height: 1.0, friction: 1.0 };
/// let (_, strike) = cube.strike(4.0)?;
/// assert!((strike.roll_rate - 1.0).abs() < 1e-15);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prism {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0 about the mass centre [kg m²].
    pub inertia: f64,
    /// d_A > 0, from A forward to the foot of the mass centre \[m\].
    pub to_centre: f64,
    /// d_K > 0, from there forward to K \[m\].
    pub to_k: f64,
    /// h > 0, of the mass centre above the face \[m\].
    pub height: f64,
    /// f ≥ 0.
    pub friction: f64,
}

/// What the plastic strike of a prism leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PrismState {
    /// 1: both edges stay, it stops.
    Stops = 1,
    /// 2: both edges stay, it slides on without turning.
    SlidesFlat = 2,
    /// 3: A separates, K sticks: it rolls on.
    RollsOn = 3,
    /// 4: A separates, K slides forward.
    TurnsAndSlides = 4,
}

impl PrismState {
    /// The number 1…4.
    pub fn number(self) -> u8 {
        self as u8
    }
}

impl Prism {
    /// A homogeneous solid regular n-gon with circumradius a: `d_A = d_K = a sin(π/n)`, `h = a cos(π/n)`.
    ///
    /// # Example
    /// ```
    /// let square = carom_theory::rocking::Prism::regular(4, 2f64.sqrt(), 3.0, 0.5); // side 2
    /// assert!((square.height - 1.0).abs() < 1e-15 && (square.inertia - 2.0).abs() < 1e-14);
    /// ```
    pub fn regular(sides: u32, circumradius: f64, mass: f64, friction: f64) -> Self {
        let (sin, cos) = libm::sincos(core::f64::consts::PI / f64::from(sides));
        let inertia = solid_polygon_inertia_ratio(sides) * mass * circumradius * circumradius;
        let half_side = circumradius * sin;
        Self { mass, inertia, to_centre: half_side, to_k: half_side, height: circumradius * cos, friction }
    }

    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::Prism;
    /// let rough = Prism::regular(4, 1.0, 1.0, -0.5);
    /// assert!(rough.check().is_err() && Prism { friction: 0.5, ..rough }.check().is_ok());
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_positive("to_centre", self.to_centre)?;
        require_positive("to_k", self.to_k)?;
        require_positive("height", self.height)?;
        require_not_negative("friction", self.friction)
    }

    /// f_s = m h d_K/(J + m h²): with at least this friction K sticks, if A separates.
    ///
    /// # Example
    /// ```
    /// let square = carom_theory::rocking::Prism::regular(4, 1.0, 1.0, 0.5);
    /// assert!((square.sticking_friction() - 0.6).abs() < 1e-15);
    /// ```
    pub fn sticking_friction(&self) -> f64 {
        let Self { mass: m, inertia: j, to_k, height: h, .. } = *self;
        m * h * to_k / (j + m * h * h)
    }

    /// f_A = (d_A d_K − J/m)/(d_A h): with at most this friction A stays, if both slide. Negative: never.
    ///
    /// # Example
    /// ```
    /// let square = carom_theory::rocking::Prism::regular(4, 1.0, 1.0, 0.5);
    /// assert!((square.staying_friction() - 1.0 / 3.0).abs() < 1e-15);
    /// ```
    pub fn staying_friction(&self) -> f64 {
        let Self { mass: m, inertia: j, to_centre, to_k, height: h, .. } = *self;
        (to_centre * to_k - j / m) / (to_centre * h)
    }

    /// The state of the plastic strike.
    ///
    /// ```text
    /// J ≤ m(d_A d_K − h²):  1 if f ≥ h/d_A, else 2
    /// J > m(d_A d_K − h²):  3 if f ≥ f_s;  2 if f ≤ f_A;  else 4
    /// ```
    ///
    /// The four regions tile the plane (J, f) without overlap.
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::{Prism, PrismState};
    /// let square = |friction| Prism::regular(4, 1.0, 1.0, friction).state();
    /// assert_eq!([square(0.3), square(0.4), square(0.7)],
    ///            [PrismState::SlidesFlat, PrismState::TurnsAndSlides, PrismState::RollsOn]);
    /// assert_eq!(Prism::regular(3, 1.0, 1.0, 0.6).state(), PrismState::Stops);
    /// ```
    pub fn state(&self) -> PrismState {
        let Self { mass: m, inertia: j, to_centre, to_k, height: h, friction } = *self;
        if j <= m * (to_centre * to_k - h * h) {
            if friction >= h / to_centre { PrismState::Stops } else { PrismState::SlidesFlat }
        } else if friction >= self.sticking_friction() {
            PrismState::RollsOn
        } else if friction <= self.staying_friction() {
            PrismState::SlidesFlat
        } else {
            PrismState::TurnsAndSlides
        }
    }

    /// The plastic strike of a prism that turns about A with ω₀ > 0; L = d_A + d_K.
    ///
    /// ```text
    /// 1  N_A = ω₀(m(d_A d_K − h²) − J)/L,  N_K = ω₀(J + m(d_A² + h²))/L,  T_A + T_K = −mω₀h,   it stops
    /// 2  N_A = ω₀(m d_A(d_K − fh) − J)/L,  N_K = ω₀(J + m d_A(d_A + fh))/L,  T = −fN,           v_x = ω₀(h − f d_A), ω = 0
    /// 3  N_K = mω₀L(J + mh²)/(J + m(h² + d_K²)),  T_K = mh(ω − ω₀),  ω = ω₀(J + m(h² − d_A d_K))/(J + m(h² + d_K²))
    /// 4  N_K = mω₀LJ/(J + q),  T_K = −fN_K,  q = m d_K(d_K − fh),      ω = ω₀(J − m d_A(d_K − fh))/(J + q)
    /// ```
    ///
    /// # Errors
    /// A quantity outside its domain.
    ///
    /// # Source
    /// Polukoshko, Viba and others; conditions corrected.
    ///
    /// # Example
    ///
    /// A square that does not slip: ω⁺/ω₀ = (1/3 + cos 90°)/(1 + 1/3) = 1/4.
    ///
    /// ```
    /// let (_, strike) = carom_theory::rocking::Prism::regular(4, 1.0, 1.0, 0.7).strike(1.0)?;
    /// assert!((strike.roll_rate - 0.25).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn strike(&self, roll_rate: f64) -> Result<(PrismState, Strike), OutsideDomain> {
        self.check()?;
        require_positive("roll rate", roll_rate)?;
        let state = self.state();
        let unit = match state {
            PrismState::Stops => self.stops(),
            PrismState::SlidesFlat => self.slides_flat(),
            PrismState::RollsOn => self.rolls_on(),
            PrismState::TurnsAndSlides => self.turns_and_slides(),
        };
        Ok((state, unit.scaled(roll_rate)))
    }

    /// A strike with ω₀ = 1, from its motion after.
    fn unit(&self, velocity: [f64; 2], roll_rate: f64, normal: [f64; 2], tangential: Tangential) -> Strike {
        let velocity_before = [self.height, -self.to_centre];
        Strike { velocity_before, roll_rate_before: 1.0, velocity, roll_rate, normal, tangential }
    }

    fn stops(&self) -> Strike {
        let Self { mass: m, inertia: j, to_centre: d, to_k, height: h, .. } = *self;
        let face = d + to_k;
        let normal = [(m * (d * to_k - h * h) - j) / face, (j + m * (d * d + h * h)) / face];
        self.unit([0.0, 0.0], 0.0, normal, Tangential::Sum(-m * h))
    }

    fn slides_flat(&self) -> Strike {
        let Self { mass: m, inertia: j, to_centre: d, to_k, height: h, friction: f } = *self;
        let face = d + to_k;
        let normal = [(m * d * (to_k - f * h) - j) / face, (j + m * d * (d + f * h)) / face];
        self.unit([h - f * d, 0.0], 0.0, normal, Tangential::Each(normal.map(|n| -f * n)))
    }

    fn rolls_on(&self) -> Strike {
        let Self { mass: m, inertia: j, to_centre: d, to_k, height: h, .. } = *self;
        let about_k = j + m * (h * h + to_k * to_k);
        let rate = (j + m * (h * h - d * to_k)) / about_k;
        let struck = m * (d + to_k) * (j + m * h * h) / about_k;
        // h(ω − 1) with the difference written out: it cancels when the face is short.
        let held = -m * m * h * to_k * (d + to_k) / about_k;
        self.unit([rate * h, rate * to_k], rate, [0.0, struck], Tangential::Each([0.0, held]))
    }

    fn turns_and_slides(&self) -> Strike {
        let Self { mass: m, inertia: j, to_centre: d, to_k, height: h, friction: f } = *self;
        let pressed = j + m * to_k * (to_k - f * h);
        let rate = (j - m * d * (to_k - f * h)) / pressed;
        let struck = m * (d + to_k) * j / pressed;
        let velocity = [h - f * struck / m, rate * to_k];
        self.unit(velocity, rate, [0.0, struck], Tangential::Each([0.0, -f * struck]))
    }
}

impl Strike {
    /// The same strike of a body that turns `factor` times as fast.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        let scale = |pair: [f64; 2]| pair.map(|x| factor * x);
        Self {
            velocity_before: scale(self.velocity_before),
            roll_rate_before: factor * self.roll_rate_before,
            velocity: scale(self.velocity),
            roll_rate: factor * self.roll_rate,
            normal: scale(self.normal),
            tangential: match self.tangential {
                Tangential::Each(each) => Tangential::Each(scale(each)),
                Tangential::Sum(sum) => Tangential::Sum(factor * sum),
            },
        }
    }
}
