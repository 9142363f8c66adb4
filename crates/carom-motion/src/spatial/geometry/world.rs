//! A body among fixed planes, and the world's own units.

use super::body::Body;
use super::feature::Feature;
use super::friction::{Friction, FrictionProblem};
use super::plane::Plane;
use super::supports::Supports;
use crate::tolerance::ON_EDGE;
use carom_num::{Rotation, Vec3};
use thiserror::Error;

/// A body over the plane z = 0 of the world, which lies below it: z is the plane's normal; or among several planes ([`World::among`]).
///
/// Each feature of the body is a support of each plane. The supports of the first plane have the numbers of the features, those of the next plane follow. A body with balls or circles
/// rolls: its world needs friction ([`World::with_friction`]).
///
/// # Example
/// On a plane that rises by 3 in 4, gravity of 10 m/s² has 6 m/s² along the plane.
/// ```
/// use carom_motion::spatial::{World, examples};
/// use carom_num::Vec3;
/// let rod = examples::rod();
/// let world = World::new(rod, Vec3::new(6.0, 0.0, -8.0)).unwrap();
/// assert_eq!(world.gravity().norm(), 10.0);
/// assert!(world.friction().is_none());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    body: Body,
    gravity: Vec3,
    friction: Option<Friction>,
    planes: Vec<Plane>,
}

/// What a body cannot be among.
///
/// # Example
/// ```
/// use carom_motion::spatial::{Friction, Plane, PlanesProblem, World, examples};
/// use carom_num::Vec3;
/// let world = World::new(examples::cube(), Vec3::Z * -10.0).unwrap();
/// let rough = world.clone().with_friction(Friction::new(0.3)).unwrap();
/// assert_eq!(rough.among(vec![]), Err(PlanesProblem::None));
/// assert_eq!(world.among(vec![Plane::FLOOR; 2]), Err(PlanesProblem::NothingSlides));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlanesProblem {
    /// There are none.
    #[error("there is no plane")]
    None,
    /// The world has no friction, so that nothing slides.
    #[error("supports must be able to slide where there are several planes: the world has no friction")]
    NothingSlides,
    /// More supports than a set of them holds.
    #[error("{points} points and {planes} planes: allowed are {} pairs of them", Supports::MOST)]
    Count {
        /// Points of the body.
        points: usize,
        /// Planes.
        planes: usize,
    },
    /// Friction coefficients for another number of supports.
    #[error("{0}")]
    Friction(FrictionProblem),
}

/// A support: a feature of the body, and the plane that it may touch.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Support<'w> {
    pub(in crate::spatial) feature: &'w Feature,
    pub(in crate::spatial) plane: &'w Plane,
}

/// Gravity that no motion can be scaled by.
///
/// # Example
/// ```
/// use carom_motion::spatial::{GravityProblem, World, examples};
/// use carom_num::Vec3;
/// let rod = examples::rod();
/// let problem = World::new(rod, Vec3::ZERO).unwrap_err();
/// assert_eq!(problem, GravityProblem { size: 0.0 });
/// assert_eq!(problem.to_string(), "gravity has the size 0 m/s²: it must be finite and > 0");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("gravity has the size {size} m/s²: it must be finite and > 0")]
pub struct GravityProblem {
    /// Its size [m/s²].
    pub size: f64,
}

/// The world's own units.
///
/// # Example
/// Reach 0.4 m and g = 10 m/s²: `√(g ℓ)` is 2 m/s.
/// ```
/// use carom_motion::spatial::{Body, Scales, World};
/// use carom_num::{Mat3, Vec3};
/// let body = Body::new(3.0, Mat3::IDENTITY, vec![Vec3::Z * -0.4]).unwrap();
/// let scales = World::new(body, Vec3::Z * -10.0).unwrap().scales();
/// assert_eq!(scales, Scales { length: 0.4, time: 0.2, speed: 2.0, energy: 12.0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// The body's reach \[m\].
    pub length: f64,
    /// √(length/g) \[s\].
    pub time: f64,
    /// √(g length) [m/s].
    pub speed: f64,
    /// m g length \[J\].
    pub energy: f64,
}

impl World {
    /// A body under gravity [m/s²], in world axes; on an inclined plane it is not along −z.
    ///
    /// # Errors
    /// Where there is none, or it is not finite.
    pub fn new(body: Body, gravity: Vec3) -> Result<Self, GravityProblem> {
        let size = gravity.norm();
        if size > 0.0 && size.is_finite() {
            Ok(Self::of_checked(body, gravity))
        } else {
            Err(GravityProblem { size })
        }
    }

    /// A body under gravity [m/s²] that [`World::new`] would accept.
    pub(in crate::spatial) fn of_checked(body: Body, gravity: Vec3) -> Self {
        Self { body, gravity, friction: None, planes: vec![Plane::FLOOR] }
    }

    /// The same world, whose plane has friction: supports may slide. Without it no support that touches slides, whatever that takes.
    ///
    /// # Errors
    /// The first number that no friction of this body has.
    ///
    /// # Example
    /// A rod that stands on one foot has one coefficient, not two.
    /// ```
    /// use carom_motion::spatial::{Friction, FrictionProblem, World, examples};
    /// use carom_num::Vec3;
    /// let rod = examples::rod();
    /// let world = World::new(rod, Vec3::Z * -10.0).unwrap();
    /// assert!(world.clone().with_friction(Friction::of_supports(vec![0.3])).is_ok());
    /// let problem = world.with_friction(Friction::of_supports(vec![0.3, 0.2])).unwrap_err();
    /// assert_eq!(problem, FrictionProblem::Count { given: 2, supports: 1 });
    /// ```
    pub fn with_friction(self, friction: Friction) -> Result<Self, FrictionProblem> {
        friction.check(self.count())?;
        Ok(Self { friction: Some(friction), ..self })
    }

    /// The same world, with friction, where these planes stand in place of z = 0.
    ///
    /// # Errors
    /// The first problem. Friction that was given for each support is wanted for each support of each plane.
    ///
    /// # Example
    /// A groove of two planes that rise at 45° from the x axis.
    /// ```
    /// use carom_motion::spatial::{Friction, Plane, World, examples};
    /// use carom_num::Vec3;
    /// let flank = |y: f64| Plane::new(Vec3::new(0.0, y, 1.0).unit().unwrap(), 0.0).unwrap();
    /// let world = World::new(examples::cube(), Vec3::Z * -10.0).unwrap();
    /// let groove = world.with_friction(Friction::new(0.3)).unwrap().among(vec![flank(1.0), flank(-1.0)]);
    /// assert_eq!(groove.unwrap().planes().len(), 2);
    /// ```
    pub fn among(self, planes: Vec<Plane>) -> Result<Self, PlanesProblem> {
        let points = self.body.supports().len();
        let Some(friction) = &self.friction else { return Err(PlanesProblem::NothingSlides) };
        if planes.is_empty() {
            return Err(PlanesProblem::None);
        }
        if points * planes.len() > Supports::MOST {
            return Err(PlanesProblem::Count { points, planes: planes.len() });
        }
        friction.check(points * planes.len()).map_err(PlanesProblem::Friction)?;
        Ok(Self { planes, ..self })
    }

    /// The planes that the body may touch.
    pub fn planes(&self) -> &[Plane] {
        &self.planes
    }

    /// How many supports there are.
    pub(in crate::spatial) fn count(&self) -> usize {
        self.body.supports().len() * self.planes.len()
    }

    /// A support by its number.
    pub(in crate::spatial) fn support(&self, number: usize) -> Support<'_> {
        let features = self.body.features();
        Support { feature: &features[number % features.len()], plane: &self.planes[number / features.len()] }
    }

    /// Its point, or the centre of its circle, from the mass centre, body axes \[m\].
    pub(in crate::spatial) fn point(&self, number: usize) -> Vec3 {
        self.support(number).feature.point
    }

    /// Where a support touches its plane, from the mass centre, body axes \[m\]: of a ball or a circle a matter of the attitude. Supports of the first plane have the numbers
    /// of the body's features. `None` where there is no such support.
    ///
    /// # Example
    /// A ball touches the floor with its lowest place, whichever of its own that is.
    /// ```
    /// use carom_motion::spatial::{Body, Feature, World};
    /// use carom_num::{Mat3, Rotation, Vec3};
    /// let ball = Body::of(1.0, Mat3::IDENTITY, vec![Feature::point(Vec3::ZERO).rounded(0.5)]).unwrap();
    /// let world = World::new(ball, -Vec3::Z).unwrap();
    /// let lying = Rotation::by(Vec3::X * std::f64::consts::FRAC_PI_2);
    /// assert!((world.touches_at(0, lying).unwrap() + Vec3::Y * 0.5).norm() < 1e-15);
    /// assert_eq!(world.touches_at(1, lying), None);
    /// ```
    pub fn touches_at(&self, support: usize, attitude: Rotation) -> Option<Vec3> {
        (support < self.count()).then(|| self.arm(support, attitude))
    }

    /// The same of a support that there is.
    pub(in crate::spatial) fn arm(&self, number: usize, attitude: Rotation) -> Vec3 {
        let Support { feature, plane } = self.support(number);
        if feature.is_sharp() { feature.point } else { feature.arm(attitude.undo(plane.normal())) }
    }

    /// How fast the place where it touches moves, as seen from the mass centre, body axes [m/s].
    pub(in crate::spatial) fn swing(&self, number: usize, attitude: Rotation, spin: Vec3) -> Vec3 {
        let Support { feature, plane } = self.support(number);
        if feature.is_sharp() {
            return spin.cross(feature.point);
        }
        let up = attitude.undo(plane.normal());
        spin.cross(feature.arm(up)) + feature.drift(up, spin)
    }

    /// The normal of its plane, world axes.
    pub(in crate::spatial) fn normal(&self, number: usize) -> Vec3 {
        self.support(number).plane.normal()
    }

    /// The supports of a plane.
    pub(in crate::spatial) fn of_plane(&self, plane: usize) -> Supports {
        let points = self.body.supports().len();
        (plane * points..(plane + 1) * points).collect()
    }

    /// The plane of a support, by its number.
    pub(in crate::spatial) fn plane_of(&self, support: usize) -> usize {
        support / self.body.supports().len()
    }

    /// Their features are alike: places of them on one plane keep their distances.
    pub(in crate::spatial) fn are_alike(&self, supports: Supports) -> bool {
        let feature = |i: usize| self.support(i).feature;
        let Some(first) = supports.iter().next() else { return true };
        !self.body.is_round() || supports.iter().all(|i| feature(i).is_like(feature(first)))
    }

    /// A support between two others on its plane stays on the line of their places as they move: true where its radii lie as its centre does between theirs.
    pub(in crate::spatial) fn is_between(&self, [a, b]: [usize; 2], support: usize) -> bool {
        if !self.body.is_round() {
            return true;
        }
        let [from, to, own] = [a, b, support].map(|i| self.support(i).feature);
        let whole = to.point - from.point;
        let square = whole.dot(whole);
        let share = if square > 0.0 { (own.point - from.point).dot(whole) / square } else { 0.0 };
        let near = ON_EDGE * self.body.reach();
        let wide = |of: fn(&Feature) -> f64| (of(from) + share * (of(to) - of(from)) - of(own)).abs() <= near;
        let on = (own.point - from.point - whole * share).norm() <= near;
        let along = |end: &Feature| end.circle == 0.0 || own.circle == 0.0 || end.has_axis_of(own);
        on && along(from) && along(to) && wide(|f| f.circle) && wide(|f| f.radius)
    }

    /// True where these supports are of one plane, or none.
    pub(in crate::spatial) fn is_of_one_plane(&self, supports: Supports) -> bool {
        let mut planes = supports.iter().map(|i| self.plane_of(i));
        planes.next().is_none_or(|first| planes.all(|plane| plane == first))
    }

    /// Friction of the planes; `None` where no support may slide.
    pub fn friction(&self) -> Option<&Friction> {
        self.friction.as_ref()
    }

    /// The body.
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// Gravity, world axes [m/s²].
    pub fn gravity(&self) -> Vec3 {
        self.gravity
    }

    /// The world's own units.
    pub fn scales(&self) -> Scales {
        let (length, g) = (self.body.reach(), self.gravity.norm());
        let speed = (g * length).sqrt();
        Scales { length, time: length / speed, speed, energy: self.body.mass() * g * length }
    }
}
