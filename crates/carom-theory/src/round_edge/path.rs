//! Rolling over a round edge: everything as a function of the tilt.

use super::{RoundEdge, RoundEdgeMotion, RoundEdgeState};
use crate::roots::border;

/// Tilts between the start and the end at which a part is asked whether it still rolls.
const STATIONS: u32 = 4096;

impl RoundEdge {
    /// Offset at a tilt of a part that rolls from `start`, s = s₀ + ρ(θ − θ₀) \[m\].
    ///
    /// # Example
    /// ```
    /// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// let start = RoundEdgeState { offset: 1.0, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    /// assert_eq!(part.rolling_offset(&start, -0.25), 0.75);
    /// ```
    pub fn rolling_offset(&self, start: &RoundEdgeState, tilt: f64) -> f64 {
        start.offset + self.edge_radius * (tilt - start.tilt)
    }

    /// Square of the spin at a tilt of a part that rolls from `start` [rad²/s²]; negative at tilts that it does not reach.
    ///
    /// ```text
    /// ω² = (I(s₀)ω₀² + 2mg(h₀ − h))/I(s),   I(s) = J + m(c² + s²),   h = (ρ+c) cos θ + s sin θ
    /// ```
    ///
    /// The difference of the heights is formed from products of half angles, and keeps its digits just after the release.
    ///
    /// # Example
    ///
    /// Let go level at s = ρπ/2 it is upright when s = 0: C has come down from ρ + c to the height of O, ω² = 2mg(ρ+c)/(J + mc²) = 60/2.
    ///
    /// ```
    /// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// let quarter = std::f64::consts::FRAC_PI_2;
    /// let start = RoundEdgeState { offset: quarter, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    /// assert!((part.rolling_rate_squared(&start, -quarter) - 30.0).abs() < 1e-13);
    /// ```
    pub fn rolling_rate_squared(&self, start: &RoundEdgeState, tilt: f64) -> f64 {
        let RoundEdgeState { offset: s, tilt: from, tilt_rate, .. } = *start;
        let (c, rho) = (self.half_thickness, self.edge_radius);
        let turned = tilt - from;
        let (sin, cos) = libm::sincos(0.5 * (tilt + from));
        let chord = 2.0 * libm::sin(0.5 * turned);
        let fall = chord * ((rho + c) * sin - s * cos) - rho * turned * libm::sin(tilt);
        let kept = self.inertia_about_contact(s) * tilt_rate * tilt_rate;
        let there = self.inertia_about_contact(self.rolling_offset(start, tilt));
        (kept + 2.0 * self.mass * self.gravity * fall) / there
    }

    /// Forces and accelerations at a tilt of a part that rolls from `start`.
    ///
    /// # Example
    ///
    /// Upright in the example of [`RoundEdge::rolling_rate_squared`], where s = 0 and ω² = 30: N = m(ρ−c)ω².
    ///
    /// ```
    /// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// let quarter = std::f64::consts::FRAC_PI_2;
    /// let start = RoundEdgeState { offset: quarter, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    /// assert!((part.rolling_at(&start, -quarter).normal_force - 30.0).abs() < 1e-13);
    /// ```
    pub fn rolling_at(&self, start: &RoundEdgeState, tilt: f64) -> RoundEdgeMotion {
        let s = self.rolling_offset(start, tilt);
        self.rolling_with(s, tilt, self.rolling_rate_squared(start, tilt))
    }

    /// Friction |F|/N that a part needs at a tilt to roll there from `start`; infinite where N ≤ 0.
    ///
    /// # Example
    /// ```
    /// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
    /// let part = RoundEdge { mass: 2.0, inertia: 1.5, half_thickness: 0.5, edge_radius: 1.0, gravity: 10.0 };
    /// let start = RoundEdgeState { offset: 1.0, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    /// assert_eq!(part.friction_needed(&start, 0.0), 0.5); // F = 5, N = 10
    /// ```
    pub fn friction_needed(&self, start: &RoundEdgeState, tilt: f64) -> f64 {
        let RoundEdgeMotion { normal_force, friction_force, .. } = self.rolling_at(start, tilt);
        if normal_force > 0.0 { friction_force.abs() / normal_force } else { f64::INFINITY }
    }

    /// First tilt from `start` towards `end` at which the friction no longer lets the part roll \[rad\]; `None` if it gets to `end`, or
    /// turns back before.
    ///
    /// # Limits
    /// The way is looked at in 4096 places: a slip that would end again between two of them is not seen.
    ///
    /// # Example
    ///
    /// A thin rod that tips over a sharp edge slips at tan|θ| = μJ/(J + 3ms²), here μ/2 below the level.
    ///
    /// ```
    /// use carom_theory::round_edge::{RoundEdge, RoundEdgeState};
    /// let rod = RoundEdge { mass: 1.0, inertia: 3.0, half_thickness: 0.0, edge_radius: 0.0, gravity: 10.0 };
    /// let start = RoundEdgeState { offset: 1.0, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    /// let tilt = rod.slip_tilt(&start, -1.0, 0.5).expect("it slips");
    /// assert!((tilt.tan() + 0.25).abs() < 1e-15);
    /// ```
    pub fn slip_tilt(&self, start: &RoundEdgeState, end: f64, friction: f64) -> Option<f64> {
        let rolls = |tilt: f64| self.friction_needed(start, tilt) <= friction;
        if !rolls(start.tilt) {
            return Some(start.tilt);
        }
        let stride = (end - start.tilt) / f64::from(STATIONS);
        let mut before = start.tilt;
        for i in 1..=STATIONS {
            let tilt = if i == STATIONS { end } else { start.tilt + stride * f64::from(i) };
            let slips = (!rolls(tilt)).then(|| border(rolls, before, tilt));
            if self.rolling_rate_squared(start, slips.unwrap_or(tilt)) < 0.0 {
                return None;
            }
            if slips.is_some() {
                return slips;
            }
            before = tilt;
        }
        None
    }
}
