//! A rigid body that stands on points of its own, sharp or rounded.

use super::feature::Feature;
use super::form::Form;
use super::polyhedron::Polyhedron;
use crate::tolerance::{LEAST_ROUNDING, ONE_SUPPORT, PRINCIPAL_SPARE, UNIT_LENGTH};
use carom_impact::ImpactError;
use carom_impact::spatial::RigidBody;
use carom_num::elementary::{acos, cos};
use carom_num::{Mat3, Rotation, Vec3};
use thiserror::Error;

/// A rigid body with the points that it may stand on.
///
/// # Example
/// A rod of 2 m and 1 kg that stands on its foot: `J = m ℓ²/12 = 1/3` across, and `m ℓ²/3 = 4/3` about the
/// foot.
/// ```
/// use carom_motion::spatial::Body;
/// use carom_num::{Mat3, Vec3};
/// let rod = Body::new(1.0, Mat3::diagonal(1.0 / 3.0, 1.0 / 3.0, 1e-3), vec![-Vec3::Z]).unwrap();
/// assert_eq!(rod.inertia_about(rod.supports()[0]).rows[0].x, 4.0 / 3.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    mass: f64,
    inertia: Mat3,
    mobility: Mat3,
    supports: Vec<Vec3>,
    features: Vec<Feature>,
    round: bool,
    reach: f64,
    /// Where it is more than the hull of its supports.
    form: Option<Box<Form>>,
}

/// What is wrong with the numbers of a body.
///
/// # Example
/// Two supports in one place are told.
/// ```
/// use carom_motion::spatial::{Body, BodyProblem};
/// use carom_num::{Mat3, Vec3};
/// let problems = Body::new(1.0, Mat3::IDENTITY, vec![Vec3::Z, Vec3::Z]).unwrap_err();
/// assert_eq!(problems, [BodyProblem::Together { first: 0, second: 1, distance: 0.0 }]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BodyProblem {
    /// No rigid body has such a mass or inertia.
    #[error("{0}")]
    Mass(ImpactError),
    /// There are none, or more than a set of them holds.
    #[error("{count} supports: allowed are 1 to {}", Body::MOST)]
    Count {
        /// How many there are.
        count: usize,
    },
    /// A place that is not finite.
    #[error("support {support} is not at a finite place")]
    NotFinite {
        /// Which one.
        support: usize,
    },
    /// The only support is the mass centre: no length scales the motion.
    #[error("the only support is the mass centre")]
    Central,
    /// A radius that no circle or ball has.
    #[error("support {support} has a radius of {radius} m: allowed is finite and >= 0")]
    Radius {
        /// Which one.
        support: usize,
        /// What it is \[m\].
        radius: f64,
    },
    /// The axis of a circle is no unit vector.
    #[error("the axis of support {support} has the length {length}: it must be 1")]
    Axis {
        /// Which one.
        support: usize,
        /// Its length.
        length: f64,
    },
    /// A corner of the hull of pieces at which none of them has a corner.
    #[error("none of the pieces has corner {corner} of the hull: faces of it are almost on one plane")]
    Hidden {
        /// Which one.
        corner: usize,
    },
    /// Two supports in one place.
    #[error("supports {first} and {second} are {distance} m apart: they must be two points")]
    Together {
        /// One of them.
        first: usize,
        /// The other.
        second: usize,
        /// Their distance [m].
        distance: f64,
    },
}

impl Body {
    /// How many supports it may have.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Body;
    /// assert_eq!(Body::MOST, 1024);
    /// ```
    pub const MOST: usize = 1024;

    /// The least radius of balls about its points, in units of its reach, where obstacles have ends: smaller ones are not told from sharp points.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Body;
    /// assert_eq!(Body::LEAST_ROUNDING, 1e-5);
    /// ```
    pub const LEAST_ROUNDING: f64 = LEAST_ROUNDING;

    /// A body of a mass \[kg\], with its inertia about the mass centre in body axes [kg m²] and its supports from the mass centre in body axes \[m\].
    ///
    /// # Errors
    /// All problems.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Body;
    /// use carom_num::{Mat3, Vec3};
    /// let third = 1.0 / 6.0;
    /// let corner = |x: f64, y: f64| Vec3::new(x, y, -0.5);
    /// let corners = vec![corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
    /// let cube = Body::new(1.0, Mat3::diagonal(third, third, third), corners).unwrap();
    /// assert_eq!(cube.reach(), 0.75f64.sqrt());
    /// assert_eq!(Body::new(0.0, Mat3::IDENTITY, vec![]).unwrap_err().len(), 2);
    /// ```
    pub fn new(mass: f64, inertia: Mat3, supports: Vec<Vec3>) -> Result<Self, Vec<BodyProblem>> {
        Self::of(mass, inertia, supports.into_iter().map(Feature::point).collect())
    }

    /// A body that touches planes with these features of it: balls, circles, or points. The inertia is that of the whole body, as given.
    ///
    /// # Errors
    /// All problems.
    ///
    /// # Example
    /// A ball of 0.1 m and 2 kg: `J = 2/5 m ρ²`.
    /// ```
    /// use carom_motion::spatial::{Body, BodyProblem, Feature};
    /// use carom_num::{Mat3, Vec3};
    /// let moment = 0.4 * 2.0 * 0.01;
    /// let inertia = Mat3::diagonal(moment, moment, moment);
    /// let ball = |radius| Body::of(2.0, inertia, vec![Feature::point(Vec3::ZERO).rounded(radius)]);
    /// assert_eq!(ball(0.1).unwrap().reach(), 0.1);
    /// assert_eq!(ball(0.0).unwrap_err(), [BodyProblem::Central]);
    /// assert_eq!(ball(-1.0).unwrap_err(), [BodyProblem::Radius { support: 0, radius: -1.0 }]);
    /// ```
    pub fn of(mass: f64, inertia: Mat3, features: Vec<Feature>) -> Result<Self, Vec<BodyProblem>> {
        let mut problems = vec![];
        let still = RigidBody { mass, inertia, velocity: Vec3::ZERO, spin: Vec3::ZERO };
        problems.extend(still.check().err().map(BodyProblem::Mass));
        if features.is_empty() || features.len() > Self::MOST {
            problems.push(BodyProblem::Count { count: features.len() });
        }
        problems.extend(
            features.iter().enumerate().flat_map(|(support, feature)| own_problems(support, feature)),
        );
        let reach = features.iter().map(Feature::reach).fold(0.0, f64::max);
        for (second, b) in features.iter().enumerate() {
            for (first, a) in features.iter().enumerate().take(second) {
                let distance = (a.point - b.point).norm();
                if distance <= ONE_SUPPORT * reach && a.is_like(b) {
                    problems.push(BodyProblem::Together { first, second, distance });
                }
            }
        }
        if features.len() == 1 && features[0].is_sharp() && reach == 0.0 {
            problems.push(BodyProblem::Central);
        }
        let mobility = inertia.inverse();
        match mobility {
            Some(mobility) if problems.is_empty() => {
                let supports = features.iter().map(Feature::centre).collect();
                let round = !features.iter().all(Feature::is_sharp);
                Ok(Self { mass, inertia, mobility, supports, features, round, reach, form: None })
            }
            _ => Err(problems),
        }
    }

    /// A body of convex pieces that are fixed to each other, from the mass centre in body axes \[m\]: it need not be convex. They may lie along each other and reach into each other; mass and inertia
    /// are those of all of them, as given. Its supports are those of their corners that are corners of the whole: first those near the places of `first`, in that order, then the others.
    ///
    /// # Errors
    /// All problems.
    ///
    /// # Limits
    /// Its edges and corners are sharp.
    ///
    /// # Example
    /// A bar that is cut in two has eight corners, as the whole one.
    /// ```
    /// use carom_motion::spatial::{Body, Polyhedron};
    /// use carom_num::{Mat3, Vec3};
    /// let half = |side: f64| {
    ///     let corner = |i: usize| Vec3::new((i & 1) as f64 * side, (i >> 1 & 1) as f64 - 0.5, (i >> 2) as f64 - 0.5);
    ///     Polyhedron::of_points(&(0..8).map(corner).collect::<Vec<_>>(), 1e-9).unwrap()
    /// };
    /// let last = Vec3::new(2.0, 0.5, 0.5);
    /// let bar = Body::of_pieces(1.0, Mat3::IDENTITY, &[half(-2.0), half(2.0)], &[last]).unwrap();
    /// assert_eq!((bar.supports().len(), bar.supports()[0]), (8, last));
    /// // Four sides of each half, and an end.
    /// assert_eq!(bar.polygons().len(), 10);
    /// ```
    pub fn of_pieces(
        mass: f64,
        inertia: Mat3,
        pieces: &[Polyhedron],
        first: &[Vec3],
    ) -> Result<Self, Vec<BodyProblem>> {
        let form = Form::of_pieces(pieces, first);
        let body = Self::new(mass, inertia, form.outside().corners.clone())?;
        Ok(Self { form: Some(Box::new(form)), ..body })
    }

    /// The faces of its pieces that are outside, by their corners, counter-clockwise as seen from outside, body axes \[m\]: a piece may hide a share of another one's. None of a body that
    /// is the hull of its supports. [`super::world::World::touch`] numbers them so.
    pub fn polygons(&self) -> &[Vec<Vec3>] {
        self.form.as_ref().map_or(&[], |form| form.polygons())
    }

    /// Its form where it is more than the hull of its supports.
    pub(super) fn form(&self) -> Option<&Form> {
        self.form.as_deref()
    }

    /// A body whose axes are its principal ones, of numbers that [`Body::new`] would accept.
    pub(in crate::spatial) fn of_principal(mass: f64, [a, b, c]: [f64; 3], supports: Vec<Vec3>) -> Self {
        let reach = supports.iter().map(|r| r.norm()).fold(0.0, f64::max);
        let mobility = Mat3::diagonal(1.0 / a, 1.0 / b, 1.0 / c);
        let features = supports.iter().copied().map(Feature::point).collect();
        let (inertia, form) = (Mat3::diagonal(a, b, c), None);
        Self { mass, inertia, mobility, supports, features, round: false, reach, form }
    }

    /// Mass \[kg\].
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Inertia about the mass centre, body axes [kg m²].
    pub fn inertia(&self) -> Mat3 {
        self.inertia
    }

    /// The inverse of [`Body::inertia`] [1/(kg m²)].
    pub fn mobility(&self) -> Mat3 {
        self.mobility
    }

    /// Supports from the mass centre, body axes \[m\]; of circles and balls their centres.
    pub fn supports(&self) -> &[Vec3] {
        &self.supports
    }

    /// What it touches planes with, in the order of its supports.
    pub fn features(&self) -> &[Feature] {
        &self.features
    }

    /// True where a place at which it touches may move along it: then it can roll.
    pub fn is_round(&self) -> bool {
        self.round
    }

    /// The radius of the balls about its points: 0 where all are sharp. `None` where there is a circle, or balls are unlike: then no one ball rounds all of the body.
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::{Body, Feature};
    /// use carom_num::{Mat3, Vec3};
    /// let end = |x: f64, radius| Feature::point(Vec3::X * x).rounded(radius);
    /// let bar = |radii: [f64; 2]| Body::of(1.0, Mat3::IDENTITY, vec![end(-0.2, radii[0]), end(0.2, radii[1])]);
    /// assert_eq!(bar([0.05, 0.05]).unwrap().rounding(), Some(0.05));
    /// assert_eq!(bar([0.05, 0.04]).unwrap().rounding(), None);
    /// ```
    pub fn rounding(&self) -> Option<f64> {
        let radius = self.features.first().map_or(0.0, |first| first.radius);
        self.features.iter().all(|own| own.circle == 0.0 && own.radius == radius).then_some(radius)
    }

    /// Distance of the farthest point of a support from the mass centre \[m\].
    ///
    /// # Example
    /// The farther of two supports counts.
    /// ```
    /// use carom_motion::spatial::Body;
    /// use carom_num::{Mat3, Vec3};
    /// let body = Body::new(1.0, Mat3::IDENTITY, vec![Vec3::X, Vec3::new(3.0, 0.0, -4.0)]).unwrap();
    /// assert_eq!(body.reach(), 5.0);
    /// ```
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// The height of its lowest place over the mass centre, which is below it: negative \[m\].
    ///
    /// # Example
    /// A cube of 1 m stands on its lower face.
    /// ```
    /// use carom_motion::spatial::examples;
    /// assert_eq!(examples::cube().lowest(carom_num::Rotation::NONE), -0.5);
    /// ```
    pub fn lowest(&self, attitude: Rotation) -> f64 {
        let up = attitude.undo(Vec3::Z);
        let height = |feature: &Feature| attitude.apply(feature.point).z - feature.depth(up);
        self.features.iter().map(height).fold(f64::INFINITY, f64::min)
    }

    /// The middle of the supports, body axes \[m\].
    pub(in crate::spatial) fn middle(&self) -> Vec3 {
        #[expect(clippy::cast_precision_loss, reason = "a handful")]
        let count = self.supports.len() as f64;
        self.supports.iter().fold(Vec3::ZERO, |sum, r| sum + *r) / count
    }

    /// Inertia about a point at `arm` from the mass centre, body axes [kg m²]: `J + m (s² 1 − s sᵀ)`.
    ///
    /// # Example
    /// Steiner: about an edge a cube of 1 m and 1 kg has 1/6 + 1/2.
    /// ```
    /// use carom_motion::spatial::examples;
    /// use carom_num::Vec3;
    /// let cube = examples::cube();
    /// let about_edge = cube.inertia_about(Vec3::new(0.0, 0.5, -0.5));
    /// assert!((about_edge.rows[0].x - 2.0 / 3.0).abs() < 1e-15);
    /// ```
    pub fn inertia_about(&self, arm: Vec3) -> Mat3 {
        let square = arm.dot(arm);
        self.inertia + (Mat3::diagonal(square, square, square) - Mat3::dyad(arm, arm)) * self.mass
    }
}

/// What is wrong with a feature by itself.
fn own_problems(support: usize, feature: &Feature) -> Vec<BodyProblem> {
    let mut problems = vec![];
    if !feature.point.is_finite() {
        problems.push(BodyProblem::NotFinite { support });
    }
    let lengths = [feature.circle, feature.radius].into_iter().filter(|r| !(*r >= 0.0 && r.is_finite()));
    problems.extend(lengths.map(|radius| BodyProblem::Radius { support, radius }));
    let length = feature.axis.norm();
    if feature.circle != 0.0 && ((length - 1.0).abs() > UNIT_LENGTH || length.is_nan()) {
        problems.push(BodyProblem::Axis { support, length });
    }
    problems
}

/// A lower bound of the least principal moment of a symmetric matrix, and an upper one of the largest.
///
/// # Source
/// O. K. Smith, Communications of the ACM 4 (1961) 168.
pub(in crate::spatial) fn principal_range(m: Mat3) -> (f64, f64) {
    let [a, b, c] = m.rows;
    let mean = (a.x + b.y + c.z) / 3.0;
    let rest = m - Mat3::diagonal(mean, mean, mean);
    let p = (rest.rows.iter().map(|row| row.dot(*row)).sum::<f64>() / 6.0).sqrt();
    if p <= PRINCIPAL_SPARE * mean {
        return (mean * (1.0 - 3.0 * PRINCIPAL_SPARE), mean * (1.0 + 3.0 * PRINCIPAL_SPARE));
    }
    let third = acos((0.5 * (rest * (1.0 / p)).determinant()).clamp(-1.0, 1.0)) / 3.0;
    let of = |angle: f64| mean + 2.0 * p * cos(angle);
    let (least, largest) = (of(third + 2.0 * std::f64::consts::FRAC_PI_3), of(third));
    // A body so thin that the closed form loses its least moment still has one above its determinant's share.
    let floor = m.determinant() / (largest * largest);
    (
        (least * (1.0 - PRINCIPAL_SPARE)).max(floor * (1.0 - PRINCIPAL_SPARE)),
        largest * (1.0 + PRINCIPAL_SPARE),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_principal_range_holds_the_moments() {
        let turned = Rotation::by(Vec3::new(0.3, -1.1, 0.4)).matrix();
        for moments in [[1.0, 2.0, 2.5], [1.0, 1.0, 1.5], [0.001, 1.0, 1.0], [2.0, 2.0, 2.0]] {
            let [a, b, c] = moments;
            let m = turned.product(Mat3::diagonal(a, b, c)).product(turned.transposed());
            let (least, largest) = principal_range(m);
            let (true_least, true_largest) = (moments[0], moments[2]);
            assert!(least <= true_least && least >= 0.999 * true_least, "{moments:?}: {least}");
            assert!(largest >= true_largest && largest <= 1.001 * true_largest, "{moments:?}: {largest}");
        }
    }
}
