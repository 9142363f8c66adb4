//! Where one state of a rocking strike gives way to another.

use super::{Cylinder, Prism, SupportedRod};

/// The curve on which two states meet, as a function that vanishes there.
///
/// # Example
/// A uniform rod of 1 kg and 2 m on supports at its quarter points: `J − mab = 1/3 − 1/4`, so that it is
/// beyond the border.
/// ```
/// use carom_theory::rocking::{Border, SupportedRod};
/// let Border { states, residual, applies } = SupportedRod::uniform(1.0, 2.0, [0.5, 0.5]).border();
/// assert!(states == [1, 2] && applies && (residual - 1.0 / 12.0).abs() < 1e-16);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Border {
    /// The states that meet, the smaller number first.
    pub states: [u8; 2],
    /// Changes sign across the curve; smooth in every quantity of the body.
    pub residual: f64,
    /// False where other states lie on both sides of the curve.
    pub applies: bool,
}

impl Cylinder {
    /// The four curves between the states of the plastic strike, in the plane of friction f and half angle γ.
    ///
    /// ```text
    /// 1|2  tan γ = f(1+b)/b            below f* = b/√(1−b²)
    /// 2|3  γ = 45° + atan(f)/2         below f*
    /// 3|4  tan γ = (b + (1+b)f²)/f     below f*
    /// 1|4  cos 2γ = −b                 above f*: the one that is left of the three
    /// ```
    ///
    /// All meet at f*, `tan γ* = √((1+b)/(1−b))`; for b = 1 they never do.
    ///
    /// # Source
    /// As [`Cylinder::state`].
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::Cylinder;
    /// // b = 1/2: f* = 1/√3 and γ* = 60°.
    /// let disc = Cylinder {
    ///     mass: 1.0, radius: 1.0, inertia_ratio: 0.5, friction: 3f64.sqrt().recip(), half_angle: 60f64.to_radians(),
    /// };
    /// assert!(disc.borders().iter().all(|border| border.residual.abs() < 1e-15));
    /// ```
    pub fn borders(&self) -> [Border; 4] {
        let Self { inertia_ratio: b, friction: f, half_angle, .. } = *self;
        let (sin, cos) = libm::sincos(half_angle);
        let (s, c) = (2.0 * sin * cos, (cos - sin) * (cos + sin));
        let separate = f * f * (1.0 - b) * (1.0 + b) <= b * b;
        let border = |states, residual, applies| Border { states, residual, applies };
        [
            border([1, 2], b * sin - f * (1.0 + b) * cos, separate),
            border([2, 3], c + f * s, separate),
            border([3, 4], f * sin - (b + (1.0 + b) * f * f) * cos, separate),
            border([1, 4], c + b, !separate),
        ]
    }
}

impl Prism {
    /// The four curves between the states of the plastic strike, in the plane of friction and inertia.
    ///
    /// ```text
    /// 1|2  f = h/d_A                    where J ≤ m(d_A d_K − h²)
    /// 1|3  J = m(d_A d_K − h²)          where f ≥ h/d_A
    /// 2|4  f = f_A                      where J ≥ m(d_A d_K − h²)
    /// 3|4  f = f_s                      where J ≥ m(d_A d_K − h²)
    /// ```
    ///
    /// # Source
    /// As [`Prism::state`].
    ///
    /// # Example
    /// ```
    /// use carom_theory::rocking::Prism;
    /// // Where they meet: J = m(d_A d_K − h²), f = h/d_A.
    /// let prism = Prism { mass: 1.0, inertia: 0.75, to_centre: 1.0, to_k: 1.0, height: 0.5, friction: 0.5 };
    /// assert!(prism.borders().iter().all(|border| border.residual.abs() < 1e-15));
    /// ```
    pub fn borders(&self) -> [Border; 4] {
        let Self { mass: m, inertia: j, to_centre: d, to_k, height: h, friction: f } = *self;
        let heavy = j - m * (d * to_k - h * h);
        let border = |states, residual, applies| Border { states, residual, applies };
        [
            border([1, 2], f * d - h, heavy <= 0.0),
            border([1, 3], heavy, f * d >= h),
            border([2, 4], f * m * d * h - (m * d * to_k - j), heavy > 0.0),
            border([3, 4], f * (j + m * h * h) - m * h * to_k, heavy > 0.0),
        ]
    }
}

impl SupportedRod {
    /// The curve between the variants 1 and 2: `J = mab`, for a uniform rod `12ab = l²`.
    ///
    /// # Source
    /// As [`SupportedRod::strike`].
    ///
    /// # Example
    /// ```
    /// let rod = carom_theory::rocking::SupportedRod::uniform(1.0, 12f64.sqrt(), [1.0, 1.0]);
    /// assert!(rod.border().residual.abs() < 1e-15);
    /// ```
    pub fn border(&self) -> Border {
        let Self { mass, inertia, to_a, to_b } = *self;
        Border { states: [1, 2], residual: inertia - mass * to_a * to_b, applies: true }
    }
}
