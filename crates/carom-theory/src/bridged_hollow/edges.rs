//! A rod across the gap between two sharp edges of the same height.

use crate::OutsideDomain;
use crate::domain::{require_finite, require_not_negative, require_positive};
use crate::rod_on_edge::{EdgeState, PartOnEdge};

/// A uniform thin rod, level, on two edges.
///
/// # Example
/// Half way to the right-hand edge that edge carries three quarters.
/// ```
/// use carom_theory::bridged_hollow::RodOnEdges;
/// let rod = RodOnEdges { mass: 2.0, half_length: 3.0, half_gap: 1.0, offset: 0.5, gravity: 10.0 };
/// assert_eq!((rod.forces(), rod.rests()), ([5.0, 15.0], true));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RodOnEdges {
    /// m > 0 \[kg\].
    pub mass: f64,
    /// l > 0 \[m\].
    pub half_length: f64,
    /// d > 0, half the distance of the edges \[m\].
    pub half_gap: f64,
    /// e, of the rod's centre to the right of the middle of the gap \[m\].
    pub offset: f64,
    /// g ≥ 0 [m/s²].
    pub gravity: f64,
}

impl RodOnEdges {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodOnEdges;
    /// let no_gap = RodOnEdges { mass: 2.0, half_length: 3.0, half_gap: 0.0, offset: 0.5, gravity: 10.0 };
    /// assert_eq!(no_gap.check().map_err(|error| error.quantity), Err("half gap"));
    /// assert_eq!(RodOnEdges { half_gap: 1.0, ..no_gap }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_positive("mass", self.mass)?;
        require_positive("half length", self.half_length)?;
        require_positive("half gap", self.half_gap)?;
        require_finite("offset", self.offset)?;
        require_not_negative("gravity", self.gravity)
    }

    /// Forces of the left and the right edge on the rod at rest, upward, `mg(d ∓ e)/(2d)` \[N\]; one is negative where the rod does not rest.
    ///
    /// They are the same while the rod, which is thin, slides along: friction has no lever about its centre.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodOnEdges;
    /// let rod = RodOnEdges { mass: 2.0, half_length: 3.0, half_gap: 1.0, offset: 2.0, gravity: 10.0 };
    /// assert_eq!(rod.forces(), [-10.0, 30.0]);
    /// ```
    pub fn forces(&self) -> [f64; 2] {
        let half = 0.5 * self.mass * self.gravity;
        [-1.0, 1.0].map(|side| half * (1.0 + side * self.offset / self.half_gap))
    }

    /// True if the rod rests: it lies on both edges, d + |e| ≤ l, and its centre is not beyond either, |e| ≤ d.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodOnEdges;
    /// let rests = |half_length: f64, offset: f64| {
    ///     RodOnEdges { mass: 2.0, half_length, half_gap: 1.0, offset, gravity: 10.0 }.rests()
    /// };
    /// assert!(rests(3.0, 1.0) && !rests(3.0, -1.25));
    /// assert!(!rests(1.25, 0.5)); // the left end does not reach its edge
    /// ```
    pub fn rests(&self) -> bool {
        let offset = self.offset.abs();
        offset <= self.half_gap && self.half_gap + offset <= self.half_length
    }

    /// True if a rod that is pushed over the gap arrives at the other edge before it tips over this one: l ≥ 2d, as long as two gaps.
    ///
    /// # Limits
    /// The rod is pushed along without lifting or pressing it. Its speed does not matter, since it is level until its centre is over the edge.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bridged_hollow::RodOnEdges;
    /// let rod = RodOnEdges { mass: 2.0, half_length: 3.0, half_gap: 1.0, offset: -5.0, gravity: 10.0 };
    /// assert!(rod.bridges() && !RodOnEdges { half_length: 1.9, ..rod }.bridges());
    /// ```
    pub fn bridges(&self) -> bool {
        self.half_length >= 2.0 * self.half_gap
    }

    /// How the rod begins to tip, let go where it does not rest: about which edge, at which reach beyond it; `None` where it rests, or where it
    /// lies on no edge.
    ///
    /// It tips outwards about an edge that its centre is beyond (reach |e| − d > 0), and into the gap about the edge that it lies on alone
    /// (reach |e| − d < 0). The equations are those of [`crate::rod_on_edge`], on a level plate and with J = ml²/3, with x away from the
    /// middle of the gap: to the right for e ≥ 0, else to the left.
    ///
    /// # Example
    ///
    /// Its centre 1 beyond the edge: φ̈ = mgr/(J + mr²) = 20/(6 + 2).
    ///
    /// ```
    /// use carom_theory::bridged_hollow::RodOnEdges;
    /// let rod = RodOnEdges { mass: 2.0, half_length: 3.0, half_gap: 1.0, offset: 2.0, gravity: 10.0 };
    /// let (part, state) = rod.tipping(0.3).expect("it does not rest");
    /// assert!(state.reach == 1.0 && (part.motion(&state).tilt_acceleration - 2.5).abs() < 1e-14);
    /// ```
    pub fn tipping(&self, friction: f64) -> Option<(PartOnEdge, EdgeState)> {
        let reach = self.offset.abs() - self.half_gap;
        if self.rests() || reach.abs() > self.half_length {
            return None;
        }
        let part = PartOnEdge {
            mass: self.mass,
            inertia: self.mass * self.half_length * self.half_length / 3.0,
            half_thickness: 0.0,
            friction,
            slope: 0.0,
            gravity: self.gravity,
        };
        Some((part, EdgeState { reach, tilt: 0.0, slip: 0.0, tilt_rate: 0.0 }))
    }
}
