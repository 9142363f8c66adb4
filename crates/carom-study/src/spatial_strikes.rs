//! Strikes of bodies in space that do not slide, as the engine resolves them: a pyramid that rolls over its edges, a stool on two of its supports.
//!
//! Every state of the non-sliding law is tried ([`ContactSet::states_of_keeping_strictly`]); what is consistent, and nothing else, is the answer. Impulses follow
//! from velocities in proportion: neither the mass nor the speed changes it.

use carom_impact::ImpactError;
use carom_impact::spatial::{ContactSet, RigidBody, StatesOfKeeping, Touch};
use carom_num::elementary::sin_cos;
use carom_num::{Mat3, Rotation, Vec3};
use std::f64::consts::PI;

/// Which sets of contacts may be kept, as a set of sets: bit s stands for the set with the bits s.
///
/// # Example
/// The set that holds O and K, and the one that holds K alone.
/// ```
/// use carom_study::spatial_strikes::{EdgeRoll, Ways};
/// let set = |contacts: &[u32]| -> Ways { 1 << contacts.iter().map(|bit| 1 << bit).sum::<u32>() };
/// assert_eq!(set(&[0, 2]) | set(&[2]), EdgeRoll::LONG | EdgeRoll::SHORT);
/// ```
pub type Ways = u64;

/// A body that turns about its edge OA, O its apex, until K strikes: three points of a pyramid and the moments of the solid.
///
/// # Example
/// A pyramid on a square rolls on over its apex, whatever its mass and speed, and leaves A; one on a triangle
/// keeps all three.
/// ```
/// use carom_study::spatial_strikes::EdgeRoll;
/// let kept = |sides: f64| {
///     let pyramid = EdgeRoll { sides, height: 1.0, centre: 0.75, inertia: 1.0 };
///     pyramid.states().map(|states| states.consistent[0].kept)
/// };
/// assert_eq!((kept(4.0)?, kept(3.0)?), ([true, false, true], [true; 3]));
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeRoll {
    /// n ≥ 3: π/n is half the angle between A and K as seen along the axis. Between whole numbers the homogeneous solid's moments are continued.
    pub sides: f64,
    /// Height by the base's circumradius, > 0.
    pub height: f64,
    /// Distance of the mass centre from the apex by the height, in (0, 1); 3/4 of a homogeneous body.
    pub centre: f64,
    /// Moments of inertia by those of the homogeneous body, > 0.
    pub inertia: f64,
}

/// A stool that turns about its support O and comes down on the neighbour K.
///
/// # Example
/// On many supports the neighbour is near, and hardly anything is lost: such a stool rolls on over K.
/// ```
/// use carom_study::spatial_strikes::StoolStrike;
/// let (centre, gyration) = (0.5, 0.6);
/// let stool = StoolStrike { supports: 12, centre, gyration, axial: 1.0, swinging: 0.0, tilt: 0.0 };
/// assert_eq!(stool.ways()?, StoolStrike::NEXT);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoolStrike {
    /// n ≥ 3, evenly on a circle of radius 1 m.
    pub supports: u32,
    /// The mass centre above the supports, by the circle's radius.
    pub centre: f64,
    /// Radius of gyration across the axis, by the circle's radius.
    pub gyration: f64,
    /// Moment about the axis by that across it, in (0, 2].
    pub axial: f64,
    /// γ/β: inward speed of K by its speed of approach.
    pub swinging: f64,
    /// Tilt about OK [rad].
    pub tilt: f64,
}

fn touch(arm: Vec3, normal: Vec3) -> Touch {
    Touch { arm, normal, friction: 0.0, restitution: 0.0 }
}

/// The set of sets of contacts that are kept in consistent states.
fn ways<const N: usize>(states: &StatesOfKeeping<N>) -> Ways {
    let bits = |kept: &[bool; N]| {
        kept.iter().enumerate().filter(|(_, kept)| **kept).fold(0_u32, |set, (i, _)| set | 1 << i)
    };
    states.consistent.iter().fold(0, |all, state| all | 1 << bits(&state.kept))
}

impl EdgeRoll {
    /// Kept: O has bit 0, A bit 1, K bit 2.
    ///
    /// # Example
    /// O and K stay, bits 0 and 2.
    /// ```
    /// use carom_study::spatial_strikes::EdgeRoll;
    /// assert_eq!(EdgeRoll::LONG.trailing_zeros(), 1 + 4);
    /// ```
    pub const LONG: Ways = 1 << 0b101;
    /// K alone.
    ///
    /// # Example
    /// ```
    /// use carom_study::spatial_strikes::EdgeRoll;
    /// assert_eq!(EdgeRoll::SHORT.trailing_zeros(), 4);
    /// ```
    pub const SHORT: Ways = 1 << 0b100;
    /// All three.
    ///
    /// # Example
    /// A pyramid on a triangle stops on all three.
    /// ```
    /// use carom_study::spatial_strikes::EdgeRoll;
    /// let pyramid = EdgeRoll { sides: 3.0, height: 1.0, centre: 0.75, inertia: 1.0 };
    /// assert_eq!(pyramid.ways()?, EdgeRoll::STOPS);
    /// assert_eq!(EdgeRoll::STOPS.trailing_zeros(), 1 + 2 + 4);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub const STOPS: Ways = 1 << 0b111;
    /// A and K.
    ///
    /// # Example
    /// ```
    /// use carom_study::spatial_strikes::EdgeRoll;
    /// assert_eq!(EdgeRoll::BASE_EDGE.trailing_zeros(), 2 + 4);
    /// ```
    pub const BASE_EDGE: Ways = 1 << 0b110;

    /// Every state of the strike: contacts O, A, K.
    ///
    /// # Errors
    /// A fault of the numbers: no such body.
    ///
    /// # Example
    /// A pyramid on a square keeps its apex, one on a triangle of the same height stops.
    /// ```
    /// use carom_study::spatial_strikes::EdgeRoll;
    /// let on = |sides: f64| EdgeRoll { sides, height: 1.0, centre: 0.75, inertia: 1.0 };
    /// assert_eq!(on(4.0).ways()?, EdgeRoll::LONG);
    /// assert_eq!(on(3.0).ways()?, EdgeRoll::STOPS);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn states(&self) -> Result<StatesOfKeeping<3>, ImpactError> {
        let (h, (sin, cos)) = (self.height, sin_cos(PI / self.sides));
        let polygon = 1.0 - 2.0 / 3.0 * sin * sin;
        let across = self.inertia * (0.15 * polygon + 0.0375 * h * h);
        let along = self.inertia * 0.3 * polygon;
        let centre = Vec3::Z * (self.centre * h);
        let points = [Vec3::ZERO, Vec3::new(cos, -sin, h), Vec3::new(cos, sin, h)];
        let spin = points[1] * -1.0;
        let body = RigidBody {
            mass: 1.0,
            inertia: Mat3::diagonal(across, across, along),
            velocity: spin.cross(centre),
            spin,
        };
        let normal = Vec3::new(-h, 0.0, cos) / (h * h + cos * cos).sqrt();
        let set = ContactSet::<3>::of_free_body(&body, &points.map(|x| touch(x - centre, normal)))?;
        Ok(set.states_of_keeping_strictly())
    }

    /// Which contacts may be kept.
    ///
    /// # Errors
    /// As [`EdgeRoll::states`].
    ///
    /// # Example
    /// One bit for each consistent state.
    /// ```
    /// use carom_study::spatial_strikes::EdgeRoll;
    /// let pyramid = EdgeRoll { sides: 4.0, height: 1.0, centre: 0.75, inertia: 1.0 };
    /// let states = pyramid.states()?;
    /// assert_eq!(pyramid.ways()?.count_ones() as usize, states.consistent.len());
    /// assert_eq!(states.consistent[0].kept, [true, false, true]);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn ways(&self) -> Result<Ways, ImpactError> {
        Ok(ways(&self.states()?))
    }
}

impl StoolStrike {
    /// Kept: O has bit 0, K bit 1.
    ///
    /// # Example
    /// O and K stay, bits 0 and 1.
    /// ```
    /// use carom_study::spatial_strikes::StoolStrike;
    /// assert_eq!(StoolStrike::BOTH.trailing_zeros(), 1 + 2);
    /// ```
    pub const BOTH: Ways = 1 << 0b11;
    /// K alone.
    ///
    /// # Example
    /// K alone, bit 1.
    /// ```
    /// use carom_study::spatial_strikes::StoolStrike;
    /// assert_eq!(StoolStrike::NEXT.trailing_zeros(), 2);
    /// ```
    pub const NEXT: Ways = 1 << 0b10;

    /// Every state of the strike: contacts O, K.
    ///
    /// # Errors
    /// A fault of the numbers: no such body.
    ///
    /// # Example
    /// A cube that comes down almost flat leaves O.
    /// ```
    /// use carom_study::spatial_strikes::StoolStrike;
    /// let third = (1.0f64 / 3.0).sqrt();
    /// let cube = StoolStrike {
    ///     supports: 4, centre: 0.5f64.sqrt(), gyration: third, axial: 1.0, swinging: 0.0, tilt: 0.0,
    /// };
    /// assert_eq!(cube.ways()?, StoolStrike::NEXT);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn states(&self) -> Result<StatesOfKeeping<2>, ImpactError> {
        // x from O to K, z the plane's normal.
        let (half, inner) = sin_cos(PI / f64::from(self.supports));
        let tilted = Rotation::by(Vec3::X * self.tilt);
        let centre = Vec3::X * half + tilted.apply(Vec3::new(0.0, inner, self.centre));
        let spin = Vec3::new(0.0, 1.0, self.swinging);
        let across = self.gyration * self.gyration;
        let inertia = tilted.turn(Mat3::diagonal(across, across, self.axial * across));
        let body = RigidBody { mass: 1.0, inertia, velocity: spin.cross(centre), spin };
        let points = [Vec3::ZERO, Vec3::X * (2.0 * half)];
        let set = ContactSet::<2>::of_free_body(&body, &points.map(|x| touch(x - centre, Vec3::Z)))?;
        Ok(set.states_of_keeping_strictly())
    }

    /// Which contacts may be kept.
    ///
    /// # Errors
    /// As [`StoolStrike::states`].
    ///
    /// # Example
    /// A cube that comes down almost flat keeps K and leaves O.
    /// ```
    /// use carom_study::spatial_strikes::StoolStrike;
    /// let (centre, gyration) = (0.5f64.sqrt(), (1.0f64 / 3.0).sqrt());
    /// let cube = StoolStrike { supports: 4, centre, gyration, axial: 1.0, swinging: 0.0, tilt: 0.0 };
    /// assert_eq!(cube.ways()?, StoolStrike::NEXT);
    /// assert_eq!(cube.states()?.consistent[0].kept, [false, true]);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn ways(&self) -> Result<Ways, ImpactError> {
        Ok(ways(&self.states()?))
    }
}
