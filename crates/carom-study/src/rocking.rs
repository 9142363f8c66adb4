//! A rolling body that strikes with a second point while the first still touches, resolved by the engine.
//!
//! Contact A is the one the body turns about, K the one that strikes. The body rolls forward, towards +x and clockwise, with a roll rate
//! of 1 rad/s. Impulses follow from velocities in proportion, so that neither the mass nor the roll rate changes what happens.

use crate::ends::Ends;
use crate::tolerance::{JAMMED_AT_REST, STILL_AFTER_STRIKE, TOUCHING_VELOCITY};
use carom_impact::planar::{ContactSet2, ContactState, Slip, Touch, staged};
use carom_impact::{ImpactError, Law};
use carom_num::{Vec2, elementary::sin_cos};

/// A body that rolls on contact A and strikes with K.
///
/// # Example
/// A ring (b = 1) that rolls over a step under 2γ keeps `(b + cos 2γ)/(1 + b)` of its roll rate: at 60° three
/// quarters.
/// ```
/// use carom_study::rocking::Rolling;
/// let ring = Rolling::cylinder(1.0, std::f64::consts::FRAC_PI_6, 0.7, 0.0);
/// assert!((ring.strike()?.roll_rate - 0.75).abs() < 1e-14);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolling {
    /// Mass [kg].
    pub mass: f64,
    /// Moment of inertia about the mass centre [kg m²].
    pub inertia: f64,
    /// Velocity of the mass centre [m/s] at a roll rate of 1 rad/s.
    pub velocity: Vec2,
    /// Contacts A and K.
    pub touches: [Touch; 2],
}

/// What a strike leaves.
///
/// # Example
/// A square goes on about the edge that strikes, and leaves the other.
/// ```
/// use carom_impact::planar::{ContactState::{Separates, Sticks}, Slip};
/// let square = carom_study::rocking::Rolling::prism(2.0 / 3.0, [1.0, 1.0, 1.0], 0.7, 0.0);
/// let struck = square.strike()?;
/// assert_eq!((struck.state, struck.slip[1], struck.rests), ([Separates, Sticks], Slip::Sticks, false));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Struck {
    /// What A and K do at the end; velocities within rounding are zero.
    pub state: [ContactState; 2],
    /// Whether they slip at the end, and which way: also one that separates has a slip velocity.
    pub slip: [Slip; 2],
    /// True where the body stands still, on both contacts.
    pub rests: bool,
    /// Roll rate after [rad/s], clockwise; exactly zero where it is within rounding.
    pub roll_rate: f64,
}

fn touch(arm: Vec2, normal: Vec2, friction: f64, restitution: f64) -> Touch {
    Touch { arm, normal, friction, restitution }
}

impl Rolling {
    /// A cylinder of radius 1 m and mass 1 kg on a level plane, which strikes under the central angle 2γ between A and K [rad];
    /// `inertia_ratio` is b = J/(m a²).
    ///
    /// # Example
    /// A thin ring at 2γ = 90° and f = 0.7 rolls over the step: A separates, K sticks, half the roll rate is left.
    /// ```
    /// use carom_impact::planar::ContactState::{Separates, Sticks};
    /// let ring = carom_study::rocking::Rolling::cylinder(1.0, std::f64::consts::FRAC_PI_4, 0.7, 0.0);
    /// let struck = ring.strike()?;
    /// assert_eq!(struck.state, [Separates, Sticks]);
    /// assert!((struck.roll_rate - 0.5).abs() < 1e-14);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn cylinder(inertia_ratio: f64, half_angle: f64, friction: f64, restitution: f64) -> Self {
        let (sin, cos) = sin_cos(half_angle);
        let normal = Vec2::new(-2.0 * sin * cos, (cos - sin) * (cos + sin));
        let up = Vec2::new(0.0, 1.0);
        let touches = [up, normal].map(|n| touch(n * -1.0, n, friction, restitution));
        Self { mass: 1.0, inertia: inertia_ratio, velocity: Vec2::new(1.0, 0.0), touches }
    }

    /// A prism of 1 kg that turns about the edge A, `to_centre` behind its mass centre, and falls on the edge K, `to_k` before it, both
    /// `height` below it [m]; `inertia` [kg m²].
    ///
    /// # Example
    /// A square of side 2 m that does not slip goes on with a quarter of its roll rate.
    /// ```
    /// let square = carom_study::rocking::Rolling::prism(2.0 / 3.0, [1.0, 1.0, 1.0], 0.7, 0.0);
    /// assert!((square.strike()?.roll_rate - 0.25).abs() < 1e-14);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn prism(inertia: f64, [to_centre, to_k, height]: [f64; 3], friction: f64, restitution: f64) -> Self {
        let edge = |x: f64| touch(Vec2::new(x, -height), Vec2::new(0.0, 1.0), friction, restitution);
        let velocity = Vec2::new(height, -to_centre);
        Self { mass: 1.0, inertia, velocity, touches: [edge(-to_centre), edge(to_k)] }
    }

    /// A uniform thin rod of 1 kg on smooth level supports, A `to_a` behind its middle and K `to_b` before it [m].
    ///
    /// # Example
    /// Supported at its quarter points it goes on about K with a seventh of its roll rate.
    /// ```
    /// let rod = carom_study::rocking::Rolling::rod(2.0, [0.5, 0.5], 0.0);
    /// assert!((rod.strike()?.roll_rate - 1.0 / 7.0).abs() < 1e-14);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn rod(length: f64, [to_a, to_b]: [f64; 2], restitution: f64) -> Self {
        Self::prism(length * length / 12.0, [to_a, to_b, 0.0], 0.0, restitution)
    }

    fn contacts(&self) -> Result<ContactSet2, ImpactError> {
        let mut set = ContactSet2::of_free_body(self.mass, self.inertia, self.velocity, -1.0, &self.touches)?;
        set.snap(TOUCHING_VELOCITY);
        Ok(set)
    }

    /// Every end state by Poisson's law beside the staged impact.
    ///
    /// # Errors
    /// As [`staged::resolve`].
    ///
    /// # Example
    /// A thin ring that rolls over a step without restitution can do nothing else.
    /// ```
    /// let ring = carom_study::rocking::Rolling::cylinder(1.0, std::f64::consts::FRAC_PI_4, 0.7, 0.0);
    /// let ends = ring.ends()?;
    /// assert_eq!((ends.count, ends.reached, ends.branches), (1, true, 1));
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn ends(&self) -> Result<Ends, ImpactError> {
        Ends::of(&self.contacts()?, Law::Poisson)
    }

    /// The staged impact by Poisson's law: with restitution 0 the state at the end of compression.
    ///
    /// # Errors
    /// As [`staged::resolve`].
    ///
    /// # Example
    /// A rod on supports at its ends, ½ from the middle, keeps `(1/12 − 1/4)/(1/12 + 1/4)` by the formula: it
    /// would have to turn back, and so it stops.
    /// ```
    /// use carom_study::rocking::Rolling;
    /// let struck = Rolling::rod(1.0, [0.5, 0.5], 0.0).strike()?;
    /// assert_eq!((struck.roll_rate, struck.rests), (0.0, true));
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn strike(&self) -> Result<Struck, ImpactError> {
        let (touches, set) = (&self.touches, self.contacts()?);
        let outcome = staged::resolve(&set, Law::Poisson)?;
        // From the velocities of the two points: their impulses may be large and all but undetermined where the body jams.
        let point = |k: usize| {
            let ([slip, normal], n) = (outcome.velocity[k], touches[k].normal);
            n.turned_right() * slip + n * normal
        };
        let apart = touches[1].arm - touches[0].arm;
        let roll_rate = -apart.cross(point(1) - point(0)) / apart.dot(apart);
        let roll_rate = if roll_rate.abs() <= STILL_AFTER_STRIKE { 0.0 } else { roll_rate };
        let speed = (0..2).fold(0.0f64, |most, k| most.max(set.slip[k].abs()).max(set.normal[k].abs()));
        let slip = [0, 1].map(|k| match outcome.velocity[k][0] {
            slip if slip.abs() <= STILL_AFTER_STRIKE * speed => Slip::Sticks,
            slip if slip > 0.0 => Slip::Forward,
            _ => Slip::Backward,
        });
        let state = [0, 1].map(|k| match (outcome.velocity[k][1] > STILL_AFTER_STRIKE * speed, slip[k]) {
            (true, _) => ContactState::Separates,
            (false, Slip::Sticks) => ContactState::Sticks,
            (false, _) => ContactState::Slips,
        });
        let fast = outcome.velocity.iter().flatten().any(|u| u.abs() > JAMMED_AT_REST * speed);
        Ok(Struck { state, slip, rests: !fast && roll_rate.abs() <= JAMMED_AT_REST, roll_rate })
    }
}

impl Struck {
    /// The state 1…4 of a cylinder: over K; off A and slipping at K; spinning in the corner; stopped. `None` for any other.
    ///
    /// # Source
    /// Polukoshko, Viba and others, on simultaneous collisions of rolling bodies.
    ///
    /// # Example
    /// A ring that rolls over the step.
    /// ```
    /// let ring = carom_study::rocking::Rolling::cylinder(1.0, std::f64::consts::FRAC_PI_6, 0.7, 0.0);
    /// assert_eq!(ring.strike()?.cylinder_state(), Some(1));
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn cylinder_state(&self) -> Option<u8> {
        use ContactState::{Separates, Slips, Sticks};
        match self.state {
            [Separates, Sticks] => Some(1),
            [Separates, Slips] => Some(2),
            [Slips, Slips] => Some(3),
            // Where one of two touching contacts sticks, a rigid body stands still: the other's slip is rounding.
            [Sticks | Slips, Sticks] | [Sticks, Slips] => Some(4),
            [_, Separates] => None,
        }
    }

    /// The state 1…4 of a prism: stopped; flat and sliding; rolling on about K; off A and sliding at K. `None` for any other.
    ///
    /// # Source
    /// As [`Struck::cylinder_state`].
    ///
    /// # Example
    /// A square rolls on about K; a prism of twice that width, with as high a centre, does not bounce off A.
    /// ```
    /// use carom_study::rocking::Rolling;
    /// let inertia = |half: f64| (half * half + 1.0) / 3.0;
    /// let state = |half: f64| Rolling::prism(inertia(half), [half, half, 1.0], 2.5, 0.0).strike();
    /// assert_eq!(state(1.0)?.prism_state(), Some(3));
    /// assert_eq!(state(2.0)?.prism_state(), Some(1));
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn prism_state(&self) -> Option<u8> {
        use ContactState::{Separates, Slips, Sticks};
        match self.state {
            // As for the cylinder: where one sticks, both do.
            [Sticks | Slips, Sticks] | [Sticks, Slips] => Some(1),
            [Slips, Slips] => Some(2),
            [Separates, Sticks] => Some(3),
            [Separates, Slips] => Some(4),
            [_, Separates] => None,
        }
    }

    /// The variant 1 or 2 of a rod on supports: stopped; on about K. `None` for any other.
    ///
    /// # Source
    /// As [`Struck::cylinder_state`].
    ///
    /// # Example
    /// A rod goes on about K where its supports are nearer to the middle than `ℓ/√12`, and stops where they
    /// are not.
    /// ```
    /// use carom_study::rocking::Rolling;
    /// let state = |arm: f64| Rolling::rod(12f64.sqrt(), [arm, arm], 0.0).strike();
    /// assert_eq!((state(0.9)?.rod_state(), state(1.1)?.rod_state()), (Some(2), Some(1)));
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn rod_state(&self) -> Option<u8> {
        use ContactState::{Separates, Sticks};
        match self.state {
            [Sticks, Sticks] => Some(1),
            [Separates, Sticks] => Some(2),
            _ => None,
        }
    }
}
