//! A body among fixed obstacles, and the world's own units.

use super::body::Body;
use super::feature::Feature;
use super::form::Form;
use super::friction::{Friction, FrictionProblem};
use super::hull::HullProblem;
use super::obstacle::{Obstacle, Rough};
use super::pair::{Pair, pairs_of};
use super::plane::Plane;
use super::supports::Supports;
use super::surface::{Limit, Surface};
use crate::tolerance::{LEAST_ROUNDING, ON_EDGE};
use carom_num::Vec3;
use std::ops::Range;
use thiserror::Error;

/// A body over the plane z = 0 of the world, which lies below it: z is the plane's normal; or among planes, plates and solids ([`World::among`]).
///
/// Each feature of the body is a support of each face of an obstacle. The supports of the first face have the numbers of the features, those of the next face follow; after all of them
/// come the body's faces with the corners of obstacles, and its edges with their edges. A body with balls or circles rolls: its world needs friction ([`World::with_friction`]).
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
    /// Within what each of the planes is a face.
    pub(super) limits: Vec<Vec<Limit>>,
    pub(super) pairs: Vec<Pair>,
    /// The body's faces and edges, where obstacles have some; and the obstacles.
    pub(super) form: Form,
    pub(super) obstacles: Vec<Surface>,
    /// Which planes and pairs are theirs.
    pub(super) shares: Vec<Share>,
}

/// What of all planes and pairs is of one obstacle.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Share {
    pub(super) planes: Range<usize>,
    pub(super) pairs: Range<usize>,
}

/// What a body cannot be among.
///
/// # Example
/// ```
/// use carom_motion::spatial::{Friction, Plane, ObstaclesProblem, World, examples};
/// use carom_num::Vec3;
/// let world = World::new(examples::cube(), Vec3::Z * -10.0).unwrap();
/// let rough = world.clone().with_friction(Friction::new(0.3)).unwrap();
/// assert_eq!(rough.among::<Plane>(vec![]), Err(ObstaclesProblem::None));
/// assert_eq!(world.among(vec![Plane::FLOOR; 2]), Err(ObstaclesProblem::NothingSlides));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ObstaclesProblem {
    /// There are none.
    #[error("there is no obstacle")]
    None,
    /// The world has no friction, so that nothing slides.
    #[error("supports must be able to slide where there are obstacles: the world has no friction")]
    NothingSlides,
    /// More supports than a set of them holds.
    #[error(
        "{pairs} pairs of a point, edge or face of the body and one of an obstacle: allowed are {}",
        Supports::MOST
    )]
    Count {
        /// How many there are.
        pairs: usize,
    },
    /// A body with circles or unlike balls, and obstacles that have ends.
    #[error(
        "a body with circles, or with balls of different radii, touches planes without ends alone: an obstacle has edges"
    )]
    Round,
    /// A ball, of the body or of an obstacle, so small beside the body that what it rounds touches as what is sharp does.
    #[error(
        "the radius of {radius} m is too small beside the body: at least {least} m, or 0 for sharp edges"
    )]
    Sharp {
        /// What it is \[m\].
        radius: f64,
        /// The least one that is told from a sharp edge \[m\].
        least: f64,
    },
    /// A body whose points have no hull with edges and faces, and obstacles that have ends.
    #[error("the body needs edges and faces where an obstacle has ends: {0}")]
    Shape(HullProblem),
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
        Self {
            body,
            gravity,
            friction: None,
            planes: vec![Plane::FLOOR],
            limits: vec![vec![]],
            pairs: vec![],
            form: Form::default(),
            obstacles: vec![],
            shares: vec![Share { planes: 0..1, pairs: 0..0 }],
        }
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

    /// The same world, with friction, where these planes, plates and solids stand in place of z = 0.
    ///
    /// # Errors
    /// The first problem. Friction that was given for each support is wanted for each of all supports.
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
    pub fn among<O: Into<Obstacle>>(self, obstacles: Vec<O>) -> Result<Self, ObstaclesProblem> {
        let Some(friction) = &self.friction else { return Err(ObstaclesProblem::NothingSlides) };
        if obstacles.is_empty() {
            return Err(ObstaclesProblem::None);
        }
        let obstacles: Vec<Obstacle> = obstacles.into_iter().map(Into::into).collect();
        let rough: Vec<Rough> = obstacles.iter().map(|obstacle| obstacle.rough).collect();
        let obstacles: Vec<Surface> = obstacles.into_iter().map(|obstacle| obstacle.surface).collect();
        let form = form_among(&self.body, &obstacles)?;
        let (mut pairs, mut shares, mut planes) = (vec![], vec![], 0);
        for obstacle in &obstacles {
            let (first, from) = (planes, pairs.len());
            planes += obstacle.faces.len();
            pairs.extend(pairs_of(form.outside(), obstacle));
            shares.push(Share { planes: first..planes, pairs: from..pairs.len() });
        }
        let raised = |obstacle: &Surface| {
            obstacle.faces.iter().map(|face| face.raised(obstacle.radius)).collect::<Vec<_>>()
        };
        let faces = obstacles.iter().flat_map(raised);
        let (planes, limits): (Vec<_>, Vec<_>) = faces.map(|face| (face.plane, face.limits)).unzip();
        let count = self.body.supports().len() * planes.len() + pairs.len();
        if count > Supports::MOST {
            return Err(ObstaclesProblem::Count { pairs: count });
        }
        friction.check(count).map_err(ObstaclesProblem::Friction)?;
        let world = Self { planes, limits, pairs, form, obstacles, shares, ..self };
        world.roughened(&rough).map_err(ObstaclesProblem::Friction)
    }

    /// The same, where some obstacles have friction or restitution of their own.
    fn roughened(self, rough: &[Rough]) -> Result<Self, FrictionProblem> {
        let Some(friction) =
            self.friction.as_ref().filter(|_| rough.iter().any(|own| *own != Rough::default()))
        else {
            return Ok(self);
        };
        let (mut coefficients, mut restitutions) = (vec![], vec![]);
        for support in 0..self.count() {
            let own = rough[self.obstacle_of(support)];
            coefficients.push(own.friction.unwrap_or_else(|| friction.coefficient(support)));
            restitutions.push(own.restitution.unwrap_or_else(|| friction.restitution(support)));
        }
        let friction = Friction::of_all(coefficients, restitutions, friction.law());
        friction.check(self.count())?;
        Ok(Self { friction: Some(friction), ..self })
    }

    /// The planes that the body may touch: those of faces too.
    pub fn planes(&self) -> &[Plane] {
        &self.planes
    }

    /// A support by its number: one of a face.
    pub(in crate::spatial) fn support(&self, number: usize) -> Support<'_> {
        let features = self.body.features();
        Support { feature: &features[number % features.len()], plane: &self.planes[number / features.len()] }
    }

    /// Its point, or the centre of its circle, from the mass centre, body axes \[m\]; of a face.
    pub(in crate::spatial) fn point(&self, number: usize) -> Vec3 {
        self.support(number).feature.point
    }

    /// Their features are alike: places of them on one plane keep their distances.
    pub(in crate::spatial) fn are_alike(&self, supports: Supports) -> bool {
        let feature = |i: usize| self.support(i).feature;
        let Some(first) = supports.iter().next() else { return true };
        self.body.rounding().is_some() || supports.iter().all(|i| feature(i).is_like(feature(first)))
    }

    /// A support between two others on its plane stays on the line of their places as they move: true where its radii lie as its centre does between theirs.
    pub(in crate::spatial) fn is_between(&self, [a, b]: [usize; 2], support: usize) -> bool {
        // With one ball about all of its points the radii are alike, and the ends may be edges.
        if self.body.rounding().is_some() {
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

/// The body's form; none where no obstacle has ends.
fn form_among(body: &Body, obstacles: &[Surface]) -> Result<Form, ObstaclesProblem> {
    if obstacles.iter().all(|obstacle| obstacle.corners.is_empty()) {
        return Ok(Form::default());
    }
    let form = Form::of(body)?;
    let least = LEAST_ROUNDING * body.reach();
    let radii = obstacles.iter().map(|obstacle| obstacle.radius).chain([form.outside().radius]);
    match radii.into_iter().find(|radius| *radius > 0.0 && *radius < least) {
        Some(radius) => Err(ObstaclesProblem::Sharp { radius, least }),
        None => Ok(form),
    }
}
