//! What of a body can touch a plane: points and circles, sharp or rounded.

use super::posture::{Bend, Height, moved};
use carom_num::{Rotation, Vec3};

/// A point or a circle of a body, or the ball or ring that rounds it.
///
/// A circle touches a plane with its lowest place. That place, and the one where a ball touches, moves along the body as the body turns.
///
/// # Example
/// A coin of 2 cm has two circles; a capsule two balls.
/// ```
/// use carom_motion::spatial::Feature;
/// use carom_num::Vec3;
/// let rim = |z: f64| Feature::circle(Vec3::Z * z, Vec3::Z, 0.01);
/// let coin = [rim(-0.001), rim(0.001)];
/// let capsule = [-0.02, 0.02].map(|x| Feature::point(Vec3::X * x).rounded(0.005));
/// assert_eq!((coin[0].reach(), capsule[1].reach()), (1.01e-4f64.sqrt(), 0.025));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feature {
    /// From the mass centre, body axes \[m\].
    pub(in crate::spatial) point: Vec3,
    /// The circle's axis and radius; zero of a point.
    pub(in crate::spatial) axis: Vec3,
    pub(in crate::spatial) circle: f64,
    /// Of the ball that rounds it.
    pub(in crate::spatial) radius: f64,
}

impl Feature {
    /// A point, from the mass centre, body axes \[m\].
    pub fn point(place: Vec3) -> Self {
        Self { point: place, axis: Vec3::ZERO, circle: 0.0, radius: 0.0 }
    }

    /// A circle about a centre, from the mass centre, with a unit axis, body axes, and a radius \[m\].
    pub fn circle(centre: Vec3, axis: Vec3, radius: f64) -> Self {
        let axis = if radius == 0.0 { Vec3::ZERO } else { axis };
        Self { point: centre, axis, circle: radius, radius: 0.0 }
    }

    /// The same, with a ball of this radius \[m\] about every place of it.
    pub fn rounded(self, radius: f64) -> Self {
        Self { radius, ..self }
    }

    /// The point, or the centre of the circle, from the mass centre, body axes \[m\].
    pub fn centre(&self) -> Vec3 {
        self.point
    }

    /// Distance of its farthest place from the mass centre \[m\].
    pub fn reach(&self) -> f64 {
        if self.circle == 0.0 {
            return self.point.norm() + self.radius;
        }
        let along = self.axis * self.axis.dot(self.point);
        let aside = (self.point - along).norm() + self.circle;
        (along.dot(along) + aside * aside).sqrt() + self.radius
    }

    /// Its place does not move along the body.
    pub(in crate::spatial) fn is_sharp(&self) -> bool {
        self.circle == 0.0 && self.radius == 0.0
    }

    /// Places of this one and of the other are always as far from each other as their centres.
    pub(in crate::spatial) fn is_like(&self, other: &Self) -> bool {
        (self.circle, self.radius) == (other.circle, other.radius) && self.has_axis_of(other)
    }

    /// Their circles are parallel.
    pub(in crate::spatial) fn has_axis_of(&self, other: &Self) -> bool {
        self.axis == other.axis || self.axis == -other.axis
    }

    /// The direction from the centre of a circle to its lowest place, and the sine of the angle between its axis and the normal; body axes. Both are zero for a point.
    fn lowest(&self, up: Vec3) -> (Vec3, f64) {
        if self.circle == 0.0 {
            return (Vec3::ZERO, 0.0);
        }
        let flat = self.axis * self.axis.dot(up) - up;
        let sine = flat.norm();
        (flat.unit().unwrap_or(Vec3::ZERO), sine)
    }

    /// The sine of the angle of a circle from flat; `None` for a point.
    pub(in crate::spatial) fn tilt(&self, up: Vec3) -> Option<f64> {
        (self.circle > 0.0).then(|| self.lowest(up).1)
    }

    /// In what time a circle lies flat, were it to turn on as it does \[s\]; `None` for one that does not come nearer to flat, and for a point.
    pub(in crate::spatial) fn flat_in(&self, up: Vec3, spin: Vec3) -> Option<f64> {
        let (lowest, sine) = self.lowest(up);
        let falls = lowest.dot(up.cross(spin));
        (falls > 0.0).then_some(sine / falls)
    }

    /// Where it touches a plane whose normal is `up`, from the mass centre, body axes \[m\].
    pub(in crate::spatial) fn arm(&self, up: Vec3) -> Vec3 {
        self.point + self.lowest(up).0 * self.circle - up * self.radius
    }

    /// How far that place is below the centre \[m\].
    pub(in crate::spatial) fn depth(&self, up: Vec3) -> f64 {
        self.circle * self.lowest(up).1 + self.radius
    }

    /// How fast that place moves along the body, body axes [m/s].
    pub(in crate::spatial) fn drift(&self, up: Vec3, spin: Vec3) -> Vec3 {
        if self.is_sharp() {
            return Vec3::ZERO;
        }
        let turns = up.cross(spin);
        let (lowest, sine) = self.lowest(up);
        let around = self.axis.cross(lowest);
        let runs = if sine > 0.0 { around * (-self.circle * around.dot(turns) / sine) } else { Vec3::ZERO };
        runs - turns * self.radius
    }

    /// How fast that depth can change in a time that follows, where the spin is so and stays below a size, and so does its rate.
    ///
    /// With the part ω' of the spin across a circle's axis its sine s changes by |ω'| at most, and `|s̈| ≤ |ω̇| + |ω| |ω'| + ω'²/s`: as long as s is at least half
    /// of what it is.
    pub(in crate::spatial) fn bend(
        &self,
        [up, now]: [Vec3; 2],
        [spin, turning]: [f64; 2],
        time: f64,
    ) -> Bend {
        let Some(sine) = self.tilt(up) else { return Bend { lasts: f64::INFINITY, ..Bend::default() } };
        let across = (self.axis.cross(now).norm() + turning * time).min(spin);
        let lasts = if across > 0.0 { 0.5 * sine / across } else { f64::INFINITY };
        let around = if across > 0.0 { 2.0 * across * across / sine } else { 0.0 };
        Bend {
            own: 0.0,
            most: self.circle * (turning + spin * across + around),
            lasts,
            sinks: self.circle * across,
        }
    }

    /// How much deeper that place has come under the centre since the body has turned, and how fast it does.
    pub(in crate::spatial) fn sunk(
        &self,
        turned: Rotation,
        [then, up]: [Vec3; 2],
        [spin, turning]: [Vec3; 2],
    ) -> Height {
        if self.circle == 0.0 {
            return Height::default();
        }
        let ((lowest, sine), (_, first)) = (self.lowest(up), self.lowest(then));
        let (before, more) = (self.axis.dot(then), then.dot(moved(turned, self.axis)));
        // A sine by the difference of its cosines: however little it changes, it keeps its digits.
        let whole = sine + first;
        let change = if whole > 0.0 { -(2.0 * before + more) * more / whole } else { 0.0 };
        let rate = up.cross(spin);
        let second = rate.cross(spin) + up.cross(turning);
        let around = self.axis.cross(lowest).dot(rate);
        let bent = if sine > 0.0 { around * around / sine } else { 0.0 };
        Height {
            value: self.circle * change,
            rate: -self.circle * lowest.dot(rate),
            second: self.circle * (bent - lowest.dot(second)),
        }
    }
}
