//! A corner or edge of the body, and an edge or a corner of an obstacle, one of which is rounded at least.
//!
//! The balls that round them touch where their centres, on the corner or the edge of each, are nearest to each other: as far away as both radii. That is so as long as
//! the nearest places are these: between the ends of an edge, and in a direction in which nothing else of either is nearer.

use super::pair::{Meeting, Passing};
use super::posture::Most;
use super::state::{Pose, State};
use super::surface::Edge;
use carom_num::Vec3;

/// A point, or the points of an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::spatial) struct Span {
    pub(in crate::spatial) from: Vec3,
    /// Unit vector; zero of a point.
    pub(in crate::spatial) along: Vec3,
    pub(in crate::spatial) length: f64,
}

impl Span {
    pub(super) fn point(from: Vec3) -> Self {
        Self { from, along: Vec3::ZERO, length: 0.0 }
    }

    pub(super) fn edge(edge: &Edge) -> Self {
        Self { from: edge.from, along: edge.along, length: edge.length }
    }

    pub(super) fn ends(&self) -> [Vec3; 2] {
        [self.from, self.from + self.along * self.length]
    }

    pub(super) fn is_edge(&self) -> bool {
        self.length > 0.0
    }
}

/// The two; one of them at least is a point.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::spatial) struct Nearest {
    /// From the mass centre, body axes.
    pub(in crate::spatial) own: Span,
    /// World axes.
    pub(in crate::spatial) other: Span,
    /// Of the balls about every place of the body's and of the obstacle's, together; and of the body's alone.
    pub(in crate::spatial) radius: f64,
    pub(in crate::spatial) own_radius: f64,
    /// Unit vectors from the body's corner along its edges, or from its edge into its faces, body axes.
    pub(in crate::spatial) inner: Vec<Vec3>,
    /// The same of the obstacle, world axes.
    pub(in crate::spatial) outer: Vec<Vec3>,
}

/// How they are at an instant, world axes.
struct Nearness {
    /// Where the ball's centre is, and from the place of the obstacle that is nearest to it.
    centre: Vec3,
    between: Vec3,
    /// How far along the edge the nearest place is.
    run: f64,
}

/// How that changes.
struct Nearing {
    centre: Vec3,
    between: Vec3,
    run: f64,
    spin: Vec3,
}

impl Nearest {
    fn at(&self, pose: Pose) -> Nearness {
        let along = pose.attitude.apply(self.own.along);
        let from = pose.centre + pose.attitude.apply(self.own.from);
        let apart = from - self.other.from;
        let run = if self.own.is_edge() { -apart.dot(along) } else { apart.dot(self.other.along) };
        let own = if self.own.is_edge() { along * run } else { Vec3::ZERO };
        let other = if self.own.is_edge() { Vec3::ZERO } else { self.other.along * run };
        Nearness { centre: from + own, between: apart + own - other, run }
    }

    fn changes(&self, state: &State, at: &Nearness) -> Nearing {
        let spin = state.attitude.apply(state.spin);
        let along = state.attitude.apply(self.own.along);
        let moves = state.velocity + spin.cross(at.centre - state.centre);
        if !self.own.is_edge() {
            let run = moves.dot(self.other.along);
            return Nearing { centre: moves, between: moves - self.other.along * run, run, spin };
        }
        let run = -(moves.dot(along) + at.between.dot(spin.cross(along)));
        let centre = moves + along * run;
        Nearing { centre, between: centre, run, spin }
    }

    pub(super) fn meeting(&self, pose: Pose) -> Meeting {
        self.meeting_of(&self.at(pose))
    }

    fn meeting_of(&self, &Nearness { centre, between, .. }: &Nearness) -> Meeting {
        let normal = between.unit().unwrap_or(Vec3::Z);
        Meeting { place: centre - normal * self.own_radius, normal, gap: between.norm() - self.radius }
    }

    pub(super) fn passing(&self, state: &State) -> Passing {
        let at = self.at(state.pose());
        let change = self.changes(state, &at);
        let meeting = self.meeting_of(&at);
        let normal = meeting.normal;
        let turns = (change.between - normal * normal.dot(change.between)) / at.between.norm();
        let slip = state.velocity + change.spin.cross(meeting.place - state.centre);
        Passing { at: meeting, place: change.centre - turns * self.own_radius, normal: turns, slip }
    }

    /// Half the difference of the squares of the distance and of the radius less what is added to the gap, in the radius, and its rate: the gap where they touch, and how it bends is
    /// bounded.
    pub(super) fn approach(&self, state: &State, added: f64) -> [f64; 2] {
        let (at, radius) = (self.at(state.pose()), self.radius - added);
        let (change, apart) = (self.changes(state, &at), at.between.norm());
        [(apart - radius) * (apart + radius) / (2.0 * radius), at.between.dot(change.between) / radius]
    }

    /// What the second derivatives of that and of [`Nearest::margin`] do not exceed for so long.
    pub(super) fn bend(&self, state: &State, most: &Most, time: f64) -> [f64; 2] {
        let Most { spin, turning, acceleration } = *most;
        let bent = turning + spin * spin;
        let arm = self.own.from.norm() + self.own.length;
        let lengths = self.own.length + self.other.length;
        let speed = state.velocity.norm() + acceleration * time + spin * arm;
        let bends = acceleration + bent * arm;
        let apart = self.at(state.pose()).between.norm() + speed * time;
        let runs = speed + apart * spin;
        let own = ((speed + runs) * speed + apart * (bends + spin * runs)) / self.radius;
        let far = (state.place(self.own.from) - self.other.from).norm() + lengths + speed * time;
        // A run is a product of two of them, and what is beside an edge a vector less such a product of two.
        let ends = 2.0 * (bent * far + 2.0 * spin * speed + bends);
        [own, ends]
    }

    pub(super) fn limits(&self) -> usize {
        let ends = if self.own.is_edge() || self.other.is_edge() { 2 } else { 0 };
        ends + self.inner.len() + self.outer.len()
    }

    /// Which limit that is: an end of the edge, where it begins, or a direction, of the body.
    fn limit(&self, limit: usize) -> Bound {
        let ends = self.limits() - self.inner.len() - self.outer.len();
        match limit.checked_sub(ends) {
            None => Bound::End { begins: limit == 0 },
            Some(place) if place < self.inner.len() => Bound::Inner(self.inner[place]),
            Some(place) => Bound::Outer(self.outer[place - self.inner.len()]),
        }
    }

    /// How far they are inside one of the limits within which they are what is nearest \[m\].
    pub(super) fn margin(&self, limit: usize, pose: Pose) -> f64 {
        let at = self.at(pose);
        match self.limit(limit) {
            Bound::End { begins: true } => at.run,
            Bound::End { begins: false } => self.own.length + self.other.length - at.run,
            Bound::Inner(side) => pose.attitude.apply(side).dot(at.between),
            Bound::Outer(side) => -side.dot(at.between),
        }
    }

    /// How fast that changes [m/s].
    pub(super) fn margin_rate(&self, limit: usize, state: &State) -> f64 {
        let at = self.at(state.pose());
        let change = self.changes(state, &at);
        match self.limit(limit) {
            Bound::End { begins: true } => change.run,
            Bound::End { begins: false } => -change.run,
            Bound::Inner(side) => {
                let side = state.attitude.apply(side);
                side.dot(change.between) + change.spin.cross(side).dot(at.between)
            }
            Bound::Outer(side) => -side.dot(change.between),
        }
    }
}

/// What ends the places where two things are nearest.
enum Bound {
    /// An end of the edge: where it begins, or the other one.
    End { begins: bool },
    /// Beyond it another place of the body is nearer, in this direction of its axes.
    Inner(Vec3),
    /// The same of the obstacle, world axes.
    Outer(Vec3),
}
