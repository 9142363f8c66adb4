//! A flat part on an inclined plate: sliding to the edge, and where it begins to tip.

use crate::OutsideDomain;
use crate::domain::{require, require_finite, require_not_negative, require_positive};

/// A plate and the friction on it.
///
/// # Example
/// Without friction a slope of 30° accelerates by half of g.
/// ```
/// use carom_theory::incline::Incline;
/// let plate = Incline { slope: 30f64.to_radians(), friction: 0.0, gravity: 10.0 };
/// assert!((plate.sliding_acceleration() - 5.0).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incline {
    /// α below the horizontal, in (−π/2, π/2) \[rad\].
    pub slope: f64,
    /// μ ≥ 0.
    pub friction: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
}

/// Arrival of a sliding part at a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// Time needed \[s\].
    pub time: f64,
    /// Speed on arrival [m/s].
    pub speed: f64,
}

/// The angle of friction atan μ \[rad\]: a part at rest starts to slide on slopes above it.
///
/// # Source
/// Coulomb (1785).
///
/// # Example
/// ```
/// let angle = carom_theory::incline::friction_angle(1.0);
/// assert!((angle.to_degrees() - 45.0).abs() < 1e-13);
/// ```
pub fn friction_angle(friction: f64) -> f64 {
    libm::atan(friction)
}

impl Incline {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::incline::Incline;
    /// let wall = Incline { slope: 2.0, friction: 0.1, gravity: 9.81 };
    /// assert_eq!(wall.check().map_err(|error| error.quantity), Err("slope"));
    /// assert_eq!(Incline { slope: 0.2, ..wall }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        let quarter = core::f64::consts::FRAC_PI_2;
        require(self.slope.abs() < quarter, "slope", self.slope, "-pi/2 < slope < pi/2")?;
        require_not_negative("friction", self.friction)?;
        require_positive("gravity", self.gravity)
    }

    /// Acceleration of a part that slides downhill [m/s²]; negative when friction brakes it.
    ///
    /// ```text
    /// ẍ = g (sin α − μ cos α)
    /// ```
    ///
    /// Near the angle of friction the two terms cancel; the form used is `g (tan α − μ) cos α`, whose only loss is that of α itself.
    ///
    /// # Source
    /// Polukoshko, Kononova and Sokolova, gravity-impact part feeder (ETR), equation (1).
    ///
    /// # Example
    /// ```
    /// use carom_theory::incline::Incline;
    /// let plate = Incline { slope: 0.75f64.atan(), friction: 0.25, gravity: 10.0 }; // a 3-4-5 triangle
    /// assert!((plate.sliding_acceleration() - 10.0 * (0.6 - 0.25 * 0.8)).abs() < 1e-14);
    /// ```
    pub fn sliding_acceleration(&self) -> f64 {
        let (sin, cos) = libm::sincos(self.slope);
        self.gravity * (sin / cos - self.friction) * cos
    }

    /// True if a part at rest on the plate starts to slide downhill: tan α > μ.
    ///
    /// # Example
    /// ```
    /// use carom_theory::incline::Incline;
    /// assert!(!Incline { slope: 0.1, friction: 0.15, gravity: 9.81 }.starts_from_rest());
    /// assert!(Incline { slope: 0.2, friction: 0.15, gravity: 9.81 }.starts_from_rest());
    /// ```
    pub fn starts_from_rest(&self) -> bool {
        self.sliding_acceleration() > 0.0
    }

    /// Time and speed with which a part that slides downhill at `speed ≥ 0` has gone `distance ≥ 0`; `None` if friction stops it first.
    ///
    /// ```text
    /// v² = v₀² + 2 ẍ L,   T = 2L/(v₀ + v)         (from rest: v = √(2 g L (sin α − μ cos α)),  T = √(2L/(g (sin α − μ cos α))))
    /// ```
    ///
    /// # Errors
    /// A quantity outside its domain.
    ///
    /// # Source
    /// As [`Incline::sliding_acceleration`]; there from rest.
    ///
    /// # Example
    /// ```
    /// use carom_theory::incline::Incline;
    /// let plate = Incline { slope: 0.75f64.atan(), friction: 0.25, gravity: 10.0 }; // 4 m/s²
    /// let edge = plate.slide(0.0, 0.5)?.expect("it slides");
    /// assert!((edge.speed - 2.0).abs() < 1e-14 && (edge.time - 0.5).abs() < 1e-14);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn slide(&self, speed: f64, distance: f64) -> Result<Option<Arrival>, OutsideDomain> {
        self.check()?;
        require_not_negative("speed", speed)?;
        require_not_negative("distance", distance)?;
        if distance == 0.0 {
            return Ok(Some(Arrival { time: 0.0, speed }));
        }
        let square = speed * speed + 2.0 * self.sliding_acceleration() * distance;
        let arrives = square > 0.0 || (square == 0.0 && speed > 0.0);
        let speed_there = square.max(0.0).sqrt();
        Ok(arrives.then(|| Arrival { time: 2.0 * distance / (speed + speed_there), speed: speed_there }))
    }
}

/// How far before the edge the mass centre of a sliding flat part is when it begins to tip \[m\].
///
/// ```text
/// μ h/2
/// ```
///
/// A part of thickness h that slides without turning obeys `N = mg cos α`, `T = μN` uphill along its lower face, and the moments
/// about its mass centre, h/2 above that face, must vanish: `N x_N = T h/2`. The resultant normal force therefore acts
/// `x_N = μh/2` downhill of the mass centre, whatever the slope and the acceleration. It can move no farther than the edge of the
/// plate, which it reaches when the mass centre is still μh/2 uphill of it; from then on the part turns. Negative for a part
/// that slides uphill over an edge (friction then acts downhill), which is `friction → −friction` here.
///
/// # Limits
/// The lower face is flat and longer than μh on the uphill side; the part slides (see [`tipping_offset_at_rest`] for one that sticks).
///
/// # Source
/// Ours; it is the equilibrium of moments.
///
/// # Example
/// ```
/// assert_eq!(carom_theory::incline::tipping_offset_sliding(0.001, 0.15), 0.075e-3);
/// ```
pub fn tipping_offset_sliding(thickness: f64, friction: f64) -> f64 {
    0.5 * friction * thickness
}

/// How far before the edge the mass centre of a flat part at rest may be before it tips \[m\]: (h/2) tan α.
///
/// At rest the resultant force is vertical through the mass centre, and leaves the lower face (h/2) tan α downhill of it.
///
/// # Errors
/// A quantity outside its domain.
///
/// # Source
/// Ours; statics.
///
/// # Example
/// ```
/// let offset = carom_theory::incline::tipping_offset_at_rest(0.02, 0.75f64.atan())?;
/// assert!((offset - 0.0075).abs() < 1e-17);
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
pub fn tipping_offset_at_rest(thickness: f64, slope: f64) -> Result<f64, OutsideDomain> {
    require_not_negative("thickness", thickness)?;
    require_finite("slope", slope)?;
    require(slope.abs() < core::f64::consts::FRAC_PI_2, "slope", slope, "-pi/2 < slope < pi/2")?;
    Ok(0.5 * thickness * libm::tan(slope))
}
