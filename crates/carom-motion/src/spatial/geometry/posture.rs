//! A body at one instant of its motion: heights of its supports, and how they change.
//!
//! All in body axes, where the supports stay and the normal e of a plane turns: `ė = e × ω`. A stretch of motion starts with known heights, and an instant
//! says how much they have risen since: so the height of a hop keeps its digits, however small it is beside the body.

use super::feature::Feature;
use super::state::State;
use carom_num::poly::first_root;
use carom_num::{Rotation, Vec3};

/// A height and its first two derivatives [m, m/s, m/s²].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::spatial) struct Height {
    pub(in crate::spatial) value: f64,
    pub(in crate::spatial) rate: f64,
    pub(in crate::spatial) second: f64,
}

/// What a height does not exceed in a time that follows.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::spatial) struct Bend {
    /// The acceleration of the height of what does not move along the body \[m/s²\].
    pub(in crate::spatial) own: f64,
    /// That of the height itself, for as long as `lasts` \[s\].
    pub(in crate::spatial) most: f64,
    pub(in crate::spatial) lasts: f64,
    /// How fast circles sink or rise under what does not move along the body, all the time \[m/s\].
    pub(in crate::spatial) sinks: f64,
}

impl Bend {
    /// Of a height that another bounded one is added to.
    pub(in crate::spatial) fn and(self, other: Self) -> Self {
        Self {
            own: self.own + other.own,
            most: self.most + other.most,
            lasts: self.lasts.min(other.lasts),
            sinks: self.sinks + other.sinks,
        }
    }

    /// Of what does not move along the body.
    pub(in crate::spatial) fn own(own: f64) -> Self {
        Self { own, most: own, lasts: f64::INFINITY, sinks: 0.0 }
    }
}

/// A body at one instant.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Posture {
    /// The turn since the start of the stretch: the body's axes now in those of then.
    pub(in crate::spatial) turned: Rotation,
    /// The normal of the plane that the foot is on, or of the first one, body axes.
    pub(in crate::spatial) up: Vec3,
    /// Angular velocity and acceleration, body axes.
    pub(in crate::spatial) spin: Vec3,
    pub(in crate::spatial) turning: Vec3,
    /// The point that the motion is reckoned from, from the mass centre, body axes.
    pub(in crate::spatial) from: Vec3,
    /// How far that point has gone since, its velocity and its acceleration, world axes.
    pub(in crate::spatial) base: [Vec3; 3],
}

/// A body at an instant, and how its motion changes.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Moving {
    pub(in crate::spatial) state: State,
    /// Of the mass centre, world axes.
    pub(in crate::spatial) acceleration: Vec3,
    /// Angular acceleration, body axes.
    pub(in crate::spatial) turning: Vec3,
}

/// What a motion does not exceed for some time: the spin, its rate, the acceleration of the mass centre.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Most {
    pub(in crate::spatial) spin: f64,
    pub(in crate::spatial) turning: f64,
    pub(in crate::spatial) acceleration: f64,
}

/// A plane's normal as a stretch of motion sees it.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Upright {
    /// World axes.
    pub(in crate::spatial) normal: Vec3,
    /// Body axes as they were at the start.
    pub(in crate::spatial) then: Vec3,
}

impl Posture {
    /// The body, which started with an attitude and with the point that the motion is reckoned from at a place.
    pub(in crate::spatial) fn moving(&self, start: Rotation, place: Vec3) -> Moving {
        let whole = start.after(self.turned);
        let attitude = Rotation::of(whole.to_array()).unwrap_or(whole);
        let [gone, rate, second] = self.base;
        let across = self.spin.cross(self.from);
        let bent = self.turning.cross(self.from) + self.spin.cross(across);
        let state = State {
            centre: place + gone - attitude.apply(self.from),
            attitude,
            velocity: rate - attitude.apply(across),
            spin: self.spin,
        };
        Moving { state, acceleration: second - attitude.apply(bent), turning: self.turning }
    }

    /// The height over a plane of a feature of the body that started at a height.
    pub(in crate::spatial) fn height(&self, plane: &Upright, feature: &Feature, start: f64) -> Height {
        let up = self.turned.undo(plane.then);
        let d = feature.point - self.from;
        let across = self.spin.cross(d);
        let bent = self.turning.cross(d) + self.spin.cross(across);
        let moved = moved(self.turned, d);
        let [gone, rate, second] = self.base.map(|v| plane.normal.dot(v));
        let sunk = feature.sunk(self.turned, [plane.then, up], [self.spin, self.turning]);
        Height {
            value: start + (gone + plane.then.dot(moved) - sunk.value),
            rate: rate + up.dot(across) - sunk.rate,
            second: second + up.dot(bent) - sunk.second,
        }
    }
}

/// What a rotation adds to a vector, without the vector itself.
pub(in crate::spatial) fn moved(turned: Rotation, d: Vec3) -> Vec3 {
    let twice = turned.v.cross(d) * 2.0;
    twice * turned.w + turned.v.cross(twice)
}

impl Height {
    /// For how long a point stays above the plane at least, if its acceleration never exceeds `bound` in size: the first root of
    /// `h + ḣ t − bound t²/2`.
    pub(in crate::spatial) fn safe(&self, bound: f64) -> f64 {
        first_root(self.value.max(0.0), self.rate, bound)
    }

    /// For how long a height stays above zero at least: by its acceleration while that is bounded, or by how fast circles can sink.
    pub(in crate::spatial) fn clear(&self, bend: &Bend) -> f64 {
        if bend.lasts == f64::INFINITY {
            return self.safe(bend.most);
        }
        // What sinks now may do so already: that counts twice.
        let sinking = Self { rate: self.rate - 2.0 * bend.sinks, ..*self }.safe(bend.own);
        self.safe(bend.most).min(bend.lasts).max(sinking)
    }

    /// When a point that comes down has reached the plane at the latest, if its acceleration never exceeds `bound` and `ḣ² ≥ 2 bound h`: the first
    /// root of `h + ḣ t + bound t²/2`.
    pub(in crate::spatial) fn sure(&self, bound: f64) -> f64 {
        let (h, rate) = (self.value.max(0.0), self.rate);
        2.0 * h / ((rate * rate - 2.0 * bound * h).max(0.0).sqrt() - rate)
    }

    /// When it would come down, were its acceleration to stay.
    pub(in crate::spatial) fn forecast(&self) -> Option<f64> {
        let (h, rate, bend) = (self.value.max(0.0), self.rate, self.second);
        let root = (rate * rate - 2.0 * bend * h).sqrt();
        let time = if rate > 0.0 { -(rate + root) / bend } else { 2.0 * h / (root - rate) };
        (time > 0.0 && time.is_finite()).then_some(time)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stone_falls_when_it_is_foreseen_to() {
        let thrown = Height { value: 1.0, rate: 2.0, second: -4.0 };
        let time = thrown.forecast().unwrap();
        assert!((1.0 + 2.0 * time - 2.0 * time * time).abs() < 1e-14, "{time}");
        assert!((thrown.safe(4.0) - time).abs() < 1e-15, "the bound is met: {}", thrown.safe(4.0));
        assert_eq!(Height { value: 1.0, rate: 1.0, second: 1.0 }.forecast(), None);
    }
}
