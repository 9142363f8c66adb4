//! Volume, mass centre and moment of inertia of simple solids of revolution.

use std::f64::consts::PI;

/// A solid of revolution about the z axis: its volume, where its mass centre is on the axis, and its moment of inertia across the axis.
///
/// # Source
/// Beer & Johnston, Vector Mechanics for Engineers: Statics, figure 5.21 (centroids of volumes) and figure 9.28 (moments of inertia).
///
/// # Example
/// A ball of radius 1 m: 4π/3 m³, and 2/5 of its mass times m².
/// ```
/// let ball = carom_theory::solids::ball(1.0);
/// assert_eq!((ball.volume, ball.gyration_squared), (4.0 / 3.0 * std::f64::consts::PI, 0.4));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// Volume \[m³\].
    pub volume: f64,
    /// The mass centre on the axis [m]: from the flat side on which the solid is described, of a ball from its middle.
    pub centre: f64,
    /// Moment of inertia across the axis, about the mass centre, divided by the mass \[m²\].
    pub gyration_squared: f64,
}

/// A cylinder of radius r on its flat side, h high: `V = π r² h`, `k² = r²/4 + h²/12`.
///
/// # Source
/// As [`Solid`].
///
/// # Example
/// ```
/// let found = carom_theory::solids::cylinder(2.0, 6.0);
/// assert_eq!((found.centre, found.gyration_squared), (3.0, 4.0));
/// ```
pub fn cylinder(radius: f64, height: f64) -> Solid {
    ring(0.0, radius, height)
}

/// A ring or tube from the radius r to R on its flat side, h high: `V = π (R² − r²) h`, `k² = (R² + r²)/4 + h²/12`.
///
/// # Source
/// As [`Solid`]: a cylinder less a cylinder.
///
/// # Example
/// ```
/// let found = carom_theory::solids::ring(1.0, 1.0, 12.0);
/// assert_eq!((found.volume, found.gyration_squared), (0.0, 12.5));
/// ```
pub fn ring(inner: f64, outer: f64, height: f64) -> Solid {
    Solid {
        volume: PI * (outer - inner) * (outer + inner) * height,
        centre: 0.5 * height,
        gyration_squared: 0.25 * (outer * outer + inner * inner) + height * height / 12.0,
    }
}

/// A cone of radius r on its flat side, h high: `V = π r² h/3`, `z̄ = h/4`, `k² = 3 r²/20 + 3 h²/80`.
///
/// # Source
/// As [`Solid`]: 3/20 (r² + 4 h²) about its tip, less (3h/4)².
///
/// # Example
/// ```
/// let found = carom_theory::solids::cone(2.0, 4.0);
/// assert!((found.centre, found.volume) == (1.0, 16.0 / 3.0 * std::f64::consts::PI));
/// assert!((found.gyration_squared - 1.2).abs() < 1e-15);
/// ```
pub fn cone(radius: f64, height: f64) -> Solid {
    Solid {
        volume: PI * radius * radius * height / 3.0,
        centre: 0.25 * height,
        gyration_squared: 3.0 / 20.0 * radius * radius + 3.0 / 80.0 * height * height,
    }
}

/// A ball of radius r: `V = 4π r³/3`, `k² = 2 r²/5`.
///
/// # Source
/// As [`Solid`].
///
/// # Example
/// ```
/// assert_eq!(carom_theory::solids::ball(5.0).gyration_squared, 10.0);
/// ```
pub fn ball(radius: f64) -> Solid {
    Solid {
        volume: 4.0 / 3.0 * PI * radius * radius * radius,
        centre: 0.0,
        gyration_squared: 0.4 * radius * radius,
    }
}

/// Half a ball of radius r on its flat side: `V = 2π r³/3`, `z̄ = 3r/8`, `k² = 83 r²/320`.
///
/// # Source
/// As [`Solid`]: 2 r²/5 about the middle of the ball, less (3r/8)².
///
/// # Example
/// ```
/// let found = carom_theory::solids::half_ball(8.0);
/// assert_eq!((found.centre, found.gyration_squared), (3.0, 16.6));
/// ```
pub fn half_ball(radius: f64) -> Solid {
    Solid {
        volume: 2.0 / 3.0 * PI * radius * radius * radius,
        centre: 3.0 / 8.0 * radius,
        gyration_squared: 83.0 / 320.0 * radius * radius,
    }
}
