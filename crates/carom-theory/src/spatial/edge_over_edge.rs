//! A straight edge that slides over another one without friction.

use crate::OutsideDomain;
use crate::domain::{require_finite, require_positive};

/// A body whose straight edge slides over a fixed edge, across it and without friction, where gravity acts along the fixed one.
///
/// Across the fixed edge nothing but the edge acts on the body. With the distance s from it to the mass centre, along the body's edge on which the mass centre lies, and the
/// rate θ̇ of the angle, the moment of momentum about the fixed edge and the energy stay:
///
/// ```text
/// (J + m s²) θ̇ = H,   ½ m ṡ² + ½ H²/(J + m s²) = E
/// N = 2 m J ṡ θ̇/(J + m s²)
/// ```
///
/// The edge pushes across the body's edge, so that the body stays on it as long as N is positive towards its side: while it slides out and turns away from the fixed edge.
///
/// Source: Lagrange's equations in s and θ, `L = ½ m (ṡ² + s² θ̇²) + ½ J θ̇²`.
///
/// # Example
/// A rod that turns with 2 rad/s about its middle, which then is on the fixed edge and moves along the rod with 3 m/s, is pushed by `2 m ṡ θ̇`.
/// ```
/// use carom_theory::spatial::EdgeOverEdge;
/// let rod = EdgeOverEdge { mass: 1.5, inertia: 0.1 };
/// let kept = rod.kept(0.0, 3.0, 2.0)?;
/// assert_eq!(kept.force(0.0)?, 2.0 * 1.5 * 3.0 * 2.0);
/// assert_eq!((kept.speed(0.0)?, kept.turns(0.0)?), (3.0, 2.0));
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeOverEdge {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// J > 0, about the mass centre and an axis along the fixed edge [kg m²].
    pub inertia: f64,
}

/// What it keeps on its way out.
///
/// # Example
/// The farther out, the slower it turns and the faster it goes.
/// ```
/// use carom_theory::spatial::EdgeOverEdge;
/// let kept = EdgeOverEdge { mass: 1.0, inertia: 1.0 }.kept(0.0, 1.0, 2.0)?;
/// assert_eq!((kept.turns(1.0)?, kept.speed(1.0)?), (1.0, 3f64.sqrt()));
/// # Ok::<(), carom_theory::OutsideDomain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlidingOver {
    body: EdgeOverEdge,
    /// H [kg m²/s].
    moment: f64,
    /// E \[J\].
    energy: f64,
}

impl EdgeOverEdge {
    fn about(&self, distance: f64) -> f64 {
        self.inertia + self.mass * distance * distance
    }

    /// What stays of a motion at the distance s \[m\] with ṡ > 0 [m/s] and θ̇ \[rad/s\].
    ///
    /// # Errors
    /// The first quantity outside its domain.
    pub fn kept(&self, distance: f64, speed: f64, turns: f64) -> Result<SlidingOver, OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("inertia", self.inertia)?;
        require_finite("distance", distance)?;
        require_positive("speed", speed)?;
        require_finite("turns", turns)?;
        let moment = self.about(distance) * turns;
        let energy = 0.5 * self.mass * speed * speed + 0.5 * moment * turns;
        Ok(SlidingOver { body: *self, moment, energy })
    }
}

impl SlidingOver {
    /// θ̇ at the distance s \[rad/s\].
    ///
    /// # Errors
    /// A distance that is not finite.
    pub fn turns(&self, distance: f64) -> Result<f64, OutsideDomain> {
        require_finite("distance", distance)?;
        Ok(self.moment / self.body.about(distance))
    }

    /// ṡ at the distance s [m/s].
    ///
    /// # Errors
    /// A distance that is not finite.
    pub fn speed(&self, distance: f64) -> Result<f64, OutsideDomain> {
        let turning = 0.5 * self.moment * self.turns(distance)?;
        Ok((2.0 * (self.energy - turning).max(0.0) / self.body.mass).sqrt())
    }

    /// N at the distance s \[N\].
    ///
    /// # Errors
    /// A distance that is not finite.
    pub fn force(&self, distance: f64) -> Result<f64, OutsideDomain> {
        let EdgeOverEdge { mass, inertia } = self.body;
        let across = 2.0 * mass * inertia * self.speed(distance)? * self.turns(distance)?;
        Ok(across / self.body.about(distance))
    }
}
