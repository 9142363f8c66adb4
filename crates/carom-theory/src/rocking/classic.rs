//! Ratios of the roll rates after and before a strike that neither slips nor holds the first contact.

/// Housner's ratio of a uniform block, α = atan(width/height): `ω⁺/ω⁻ = 1 − (3/2) sin²α`.
///
/// # Limits
/// `sin²α ≤ 2/3`: a squatter block does not rock but stops. The friction must be at least [`housner_sticking_friction`].
///
/// # Source
/// Housner, Bull. Seismol. Soc. Am. 53 (1963) 403.
///
/// # Example
/// ```
/// assert!((carom_theory::rocking::housner_ratio(30f64.to_radians()) - 0.625).abs() < 1e-15);
/// ```
pub fn housner_ratio(alpha: f64) -> f64 {
    let sin = libm::sin(alpha);
    1.0 - 1.5 * sin * sin
}

/// Friction that Housner's strike needs, `3 sin α cos α/(1 + 3 cos²α)`.
///
/// # Source
/// Ours: T/N at the struck corner (the prism's f_s with d_A = d_K and J = m(B² + H²)/3).
///
/// # Example
/// ```
/// assert!((carom_theory::rocking::housner_sticking_friction(45f64.to_radians()) - 0.6).abs() < 1e-15);
/// ```
pub fn housner_sticking_friction(alpha: f64) -> f64 {
    let (sin, cos) = libm::sincos(alpha);
    3.0 * sin * cos / (1.0 + 3.0 * cos * cos)
}

/// Friction up to which Housner's block lands flat and slides on without rocking, `(sin²α − 1/3)/(sin α cos α)`; negative: never.
///
/// # Source
/// Derived here (the prism's f_A with d_A = d_K and J = m(B² + H²)/3).
///
/// # Example
/// ```
/// assert!((carom_theory::rocking::housner_sliding_friction(45f64.to_radians()) - 1.0 / 3.0).abs() < 1e-15);
/// ```
pub fn housner_sliding_friction(alpha: f64) -> f64 {
    let (sin, cos) = libm::sincos(alpha);
    (sin * sin - 1.0 / 3.0) / (sin * cos)
}

/// Rimless wheel of n spokes, `j = J/(m a²)`: `ω⁺/ω⁻ = (cos(2π/n) + j)/(1 + j)`.
///
/// With `j = 0` (massless spokes) this is cos(2π/n).
///
/// # Source
/// McGeer, Int. J. Robotics Res. 9 (1990) 62.
///
/// # Example
/// ```
/// assert!((carom_theory::rocking::rimless_wheel_ratio(6, 0.0) - 0.5).abs() < 1e-15);
/// ```
pub fn rimless_wheel_ratio(spokes: u32, inertia_ratio: f64) -> f64 {
    let turn = 2.0 * core::f64::consts::PI / f64::from(spokes);
    (libm::cos(turn) + inertia_ratio) / (1.0 + inertia_ratio)
}

/// Friction that the rimless wheel's strike needs, `sin θ cos θ/(j + cos²θ)`, θ = π/n.
///
/// # Source
/// Ours: T/N at the struck spoke.
///
/// # Example
/// ```
/// let f = carom_theory::rocking::rimless_wheel_sticking_friction(4, 1.0 / 3.0);
/// assert!((f - 0.6).abs() < 1e-15); // a solid square
/// ```
pub fn rimless_wheel_sticking_friction(spokes: u32, inertia_ratio: f64) -> f64 {
    let (sin, cos) = libm::sincos(core::f64::consts::PI / f64::from(spokes));
    sin * cos / (inertia_ratio + cos * cos)
}

/// `J/(m a²)` of a homogeneous solid regular n-gon with circumradius a about its centre: `(2 + cos(2π/n))/6`.
///
/// # Source
/// Any table of moments of inertia.
///
/// # Example
/// ```
/// let square = carom_theory::rocking::solid_polygon_inertia_ratio(4); // side a√2: J = m s²/6 = m a²/3
/// assert!((square - 1.0 / 3.0).abs() < 1e-15);
/// ```
pub fn solid_polygon_inertia_ratio(sides: u32) -> f64 {
    let turn = 2.0 * core::f64::consts::PI / f64::from(sides);
    (2.0 + libm::cos(turn)) / 6.0
}

/// `J/(m a²)` of a regular n-gon with thin walls and circumradius a about its centre: `cos²θ + sin²θ/3`, θ = π/n.
///
/// # Source
/// Any table of moments of inertia: each wall is a thin rod.
///
/// # Example
/// ```
/// let square = carom_theory::rocking::thin_walled_polygon_inertia_ratio(4); // 1/2 + 1/6
/// assert!((square - 2.0 / 3.0).abs() < 1e-15);
/// ```
pub fn thin_walled_polygon_inertia_ratio(sides: u32) -> f64 {
    let (sin, cos) = libm::sincos(core::f64::consts::PI / f64::from(sides));
    cos * cos + sin * sin / 3.0
}

/// Cylinder, state 1 (leaves A, sticks at K): `ω⁺/ω⁻ = (b + cos 2γ)/(1 + b)`, `b = J/(m a²)`, 2γ the central angle A–C–K.
///
/// # Source
/// Polukoshko, Viba and others; the same as the rimless wheel with 2π/n → 2γ.
///
/// # Example
/// ```
/// // A disc (b = 1/2) that strikes a step under 2γ = 60°: (1/2 + 1/2)/(3/2)
/// assert!((carom_theory::rocking::cylinder_ratio(0.5, 30f64.to_radians()) - 2.0 / 3.0).abs() < 1e-15);
/// ```
pub fn cylinder_ratio(inertia_ratio: f64, half_angle: f64) -> f64 {
    (inertia_ratio + libm::cos(2.0 * half_angle)) / (1.0 + inertia_ratio)
}

/// Friction that the cylinder's state 1 needs, `b tan γ/(1 + b)`.
///
/// # Source
/// Ours: T/N at K.
///
/// # Example
/// ```
/// let f = carom_theory::rocking::cylinder_sticking_friction(0.5, 45f64.to_radians());
/// assert!((f - 1.0 / 3.0).abs() < 1e-15);
/// ```
pub fn cylinder_sticking_friction(inertia_ratio: f64, half_angle: f64) -> f64 {
    inertia_ratio * libm::tan(half_angle) / (1.0 + inertia_ratio)
}
