//! Where a disc on a fixed disc begins to slip, and where it lifts off.

use super::DiscOnDisc;
use crate::roots::border;
use core::f64::consts::FRAC_PI_2;

/// The end of a way down with friction.
///
/// # Example
/// With much friction a solid disc slips just before it lifts off, at cos φ = 4/7.
/// ```
/// use carom_theory::disc_on_disc::DiscOnDisc;
/// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
/// let end = discs.lift_off([0.0, 0.0], 1e6).expect("it slides on");
/// let limit = (4.0f64 / 7.0).acos();
/// assert!(end.slip_angle < end.angle && (end.angle - limit).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiftOff {
    /// φ at which the disc begins to slip \[rad\].
    pub slip_angle: f64,
    /// φ at which it lifts off \[rad\].
    pub angle: f64,
    /// φ̇ there [rad/s].
    pub rate: f64,
}

impl DiscOnDisc {
    /// Friction |F|/N that a disc needs at an angle to roll there from `[φ₀, φ̇₀]`; infinite where N ≤ 0.
    ///
    /// ```text
    /// κ sin φ/((3+κ) cos φ − D),   D = 2 cos φ₀ + (1+κ)Lφ̇₀²/g
    /// ```
    ///
    /// It grows all the way down, beyond any bound.
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// let needed = discs.friction_needed([0.0, 0.0], 0.8f64.acos()); // 0.3/(2.8 − 2)
    /// assert!((needed - 0.375).abs() < 1e-15);
    /// ```
    pub fn friction_needed(&self, start: [f64; 2], angle: f64) -> f64 {
        let kappa = self.inertia_ratio();
        let (sin, cos) = libm::sincos(angle);
        let pressed = cos - self.way_radius() * self.rolling_rate_squared(start, angle) / self.gravity;
        if pressed > 0.0 { sin.abs() * kappa / (1.0 + kappa) / pressed } else { f64::INFINITY }
    }

    /// Angle at which a disc that rolls from `[φ₀, φ̇₀]` begins to slip \[rad\]; φ₀ where it does at once.
    ///
    /// ```text
    /// μ(3+κ) cos φ − κ sin φ = μD:   φ = arccos(μD/√(μ²(3+κ)² + κ²)) − atan(κ/(μ(3+κ)))
    /// ```
    ///
    /// D as in [`DiscOnDisc::friction_needed`].
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// assert!((discs.slip_angle([0.0, 0.0], 0.375) - 0.8f64.acos()).abs() < 1e-15);
    /// assert_eq!(discs.slip_angle([0.5, 0.0], 0.1), 0.5); // tan φ₀ > 3 · 0.1
    /// ```
    pub fn slip_angle(&self, start: [f64; 2], friction: f64) -> f64 {
        let kappa = self.inertia_ratio();
        let (held, turned) = (friction * (3.0 + kappa), kappa);
        let share = friction * self.thrown(kappa, start) / (held * held + turned * turned).sqrt();
        (libm::acos(share.min(1.0)) - libm::atan2(turned, held)).max(start[0])
    }

    /// Angle at which a disc that rolls from `[φ₀, φ̇₀]` lifts off, if it had friction enough \[rad\]; φ₀ where it does at once.
    ///
    /// ```text
    /// cos φ = (2 cos φ₀ + (1+κ)Lφ̇₀²/g)/(3+κ);   from rest on top: 2/(3+κ)
    /// ```
    ///
    /// # Example
    /// A solid disc: cos φ = 4/7.
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// assert!((discs.rolling_lift_off([0.0, 0.0]).cos() - 4.0 / 7.0).abs() < 1e-15);
    /// ```
    pub fn rolling_lift_off(&self, start: [f64; 2]) -> f64 {
        let kappa = self.inertia_ratio();
        libm::acos((self.thrown(kappa, start) / (3.0 + kappa)).min(1.0)).max(start[0])
    }

    /// Angle at which a disc that slides without friction from `[φ₀, φ̇₀]` lifts off \[rad\]: as [`DiscOnDisc::rolling_lift_off`] with κ = 0.
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// assert!((discs.smooth_lift_off([0.0, 0.0]).cos() - 2.0 / 3.0).abs() < 1e-15);
    /// ```
    pub fn smooth_lift_off(&self, start: [f64; 2]) -> f64 {
        libm::acos((self.thrown(0.0, start) / 3.0).min(1.0)).max(start[0])
    }

    /// D = 2 cos φ₀ + (1+κ)Lφ̇₀²/g.
    fn thrown(&self, kappa: f64, [from, rate]: [f64; 2]) -> f64 {
        2.0 * libm::cos(from) + (1.0 + kappa) * self.way_radius() * rate * rate / self.gravity
    }

    /// Angle at which a disc that slips all the way from `[φ₀, φ̇₀]` lifts off, its drag q as in [`DiscOnDisc::sliding`] \[rad\]; φ₀
    /// where it does at once, `None` where friction stops it before or keeps it at rest.
    ///
    /// `N e^(−2qφ)` falls all the way down, so that it lifts off but once; `φ̇² e^(−2qφ)` is least at tan φ = q, so that a disc that
    /// gets there goes on.
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// let angle = discs.sliding_lift_off([60f64.to_radians(), 0.0], 0.0).expect("nothing stops it");
    /// assert!((angle.cos() - 1.0 / 3.0).abs() < 1e-15);
    /// assert_eq!(discs.sliding_lift_off([40f64.to_radians(), 0.0], 1.0), None); // tan 40° < 1
    /// ```
    pub fn sliding_lift_off(&self, start: [f64; 2], drag: f64) -> Option<f64> {
        let square = |angle: f64| self.sliding_rate_squared(start, angle, drag);
        let slowest = libm::atan(drag);
        let pressed = |angle: f64| self.gravity * libm::cos(angle) > self.way_radius() * square(angle);
        let goes_on = start[0] > slowest || square(slowest) > 0.0;
        if !pressed(start[0]) {
            return Some(start[0]);
        }
        goes_on.then(|| border(pressed, start[0], FRAC_PI_2))
    }

    /// How a disc that rolls from `[φ₀, φ̇₀]` leaves: it begins to slip, and lifts off while it slips; `None` where friction would stop it.
    ///
    /// # Example
    ///
    /// Without friction it slips from the start.
    ///
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// let end = discs.lift_off([60f64.to_radians(), 0.0], 0.0).expect("nothing stops it");
    /// assert_eq!(end.slip_angle, 60f64.to_radians());
    /// assert!((end.angle.cos() - 1.0 / 3.0).abs() < 1e-15 && (end.rate * end.rate - 0.5).abs() < 1e-14); // g cos φ/L
    /// ```
    pub fn lift_off(&self, start: [f64; 2], friction: f64) -> Option<LiftOff> {
        let slip_angle = self.slip_angle(start, friction);
        let slips = [slip_angle, self.rolling_rate_squared(start, slip_angle).max(0.0).sqrt()];
        // The rim is carried ahead of the rolling: the slip is along growing φ, and grows, since N falls.
        let angle = self.sliding_lift_off(slips, friction)?;
        let rate = self.sliding_rate_squared(slips, angle, friction).max(0.0).sqrt();
        Some(LiftOff { slip_angle, angle, rate })
    }

    /// Speed of the centre with which a disc lifts off at an angle, `√(gL cos φ)` [m/s]: a faster one has no contact there.
    ///
    /// So a disc from a plate does not follow a rounded end at all from this speed on, φ being the plate's slope.
    ///
    /// # Example
    /// A solid disc that has rolled from rest on top: v² = (4/7) g(a+b).
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 7.0 };
    /// let speed = discs.lift_off_speed(discs.rolling_lift_off([0.0, 0.0]));
    /// assert!((speed - 4.0).abs() < 1e-14);
    /// ```
    pub fn lift_off_speed(&self, angle: f64) -> f64 {
        (self.gravity * self.way_radius() * libm::cos(angle)).sqrt()
    }

    /// By how much the normal force falls where a disc comes from a plate onto its rounded end, a tangent arc, `mv²/L` \[N\].
    ///
    /// # Example
    /// ```
    /// use carom_theory::disc_on_disc::DiscOnDisc;
    /// let discs = DiscOnDisc { mass: 2.0, inertia: 1.0, radius: 1.0, fixed_radius: 3.0, gravity: 6.0 };
    /// assert_eq!(discs.joint_drop(3.0), 4.5);
    /// ```
    pub fn joint_drop(&self, speed: f64) -> f64 {
        self.mass * speed * speed / self.way_radius()
    }
}
