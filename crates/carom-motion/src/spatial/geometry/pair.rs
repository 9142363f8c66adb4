//! What a body touches an obstacle with but for its own points on its faces: a face with a corner of the obstacle, an edge with an edge, and what is round with either.
//!
//! The place where they touch moves along the body or along the obstacle, and its normal turns with the body. With the velocity ẋ of the place, the rate ṅ of
//! its normal and the velocity s of the body's material there, s is accelerated by `a + α × r + ω × (ẋ − v)`, and the gap, whose rate is `n · s`, by `n` times
//! that and by `ṅ · s`.

use super::crossing::{Crossing, most};
use super::nearest::{Nearest, Span};
use super::posture::{Height, Most, Moving};
use super::state::{Pose, State};
use super::surface::{Edge, Facet, Surface};
use crate::tolerance::BETWEEN_FACES;
use carom_num::Vec3;

/// Two of them that may touch: the body's in its axes from the mass centre, the obstacle's in the world's.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::spatial) enum Pair {
    /// A face of the body, and a corner of an obstacle.
    Corner {
        /// The face, as far outside of its corners as the radii are of the balls that round the body and the obstacle.
        face: Facet,
        /// That of the obstacle's.
        radius: f64,
        /// The corner.
        corner: Vec3,
        /// Unit vectors from it along the obstacle's edges.
        spokes: Vec<Vec3>,
    },
    /// An edge of the body across an edge of an obstacle.
    Cross(Crossing),
    /// A corner or edge of the body, and an edge or a corner of an obstacle, one of which is rounded at least.
    Round(Nearest),
}

/// How a pair stands to each other; world axes.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Meeting {
    /// Where the body would touch.
    pub(in crate::spatial) place: Vec3,
    /// From the obstacle to the body.
    pub(in crate::spatial) normal: Vec3,
    /// Negative where they overlap; infinite where edges are parallel.
    pub(in crate::spatial) gap: f64,
}

/// How that changes.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Passing {
    pub(in crate::spatial) at: Meeting,
    /// Velocity of the place.
    pub(in crate::spatial) place: Vec3,
    /// Rate of the normal.
    pub(in crate::spatial) normal: Vec3,
    /// Velocity of the body's material there.
    pub(in crate::spatial) slip: Vec3,
}

impl Meeting {
    /// Two tangents and the normal, world axes.
    pub(in crate::spatial) fn axes(&self) -> [Vec3; 3] {
        let [first, second] = self.normal.tangents();
        [first, second, self.normal]
    }
}

impl Passing {
    /// What the material where a pair touches accelerates by, body axes, besides what the accelerations of the mass centre and of the spin do, and the turn of the normal.
    pub(in crate::spatial) fn bent(&self, state: &State) -> Vec3 {
        let moves = state.attitude.undo(self.place - state.velocity);
        state.spin.cross(moves) + state.attitude.undo(self.at.normal) * self.normal.dot(self.slip)
    }
}

impl Pair {
    pub(in crate::spatial) fn meeting(&self, pose: Pose) -> Meeting {
        match self {
            Self::Corner { face, corner, radius, .. } => {
                let gap = face.plane.height(pose.attitude.undo(*corner - pose.centre));
                let normal = -pose.attitude.apply(face.plane.normal());
                Meeting { place: *corner + normal * *radius, normal, gap }
            }
            Self::Cross(crossing) => crossing.meeting(pose),
            Self::Round(nearest) => nearest.meeting(pose),
        }
    }

    pub(in crate::spatial) fn passing(&self, state: &State) -> Passing {
        match self {
            Self::Corner { radius, .. } => {
                let at = self.meeting(state.pose());
                let spin = state.attitude.apply(state.spin);
                let slip = state.velocity + spin.cross(at.place - state.centre);
                let turns = spin.cross(at.normal);
                Passing { at, place: turns * *radius, normal: turns, slip }
            }
            Self::Cross(crossing) => crossing.passing(state),
            Self::Round(nearest) => nearest.passing(state),
        }
    }

    /// The gap, and how it changes.
    pub(in crate::spatial) fn height(&self, moving: &Moving) -> Height {
        let State { attitude, centre, .. } = moving.state;
        let passing = self.passing(&moving.state);
        let Meeting { place, normal, gap } = passing.at;
        let bent = moving.turning.cross(attitude.undo(place - centre)) + passing.bent(&moving.state);
        let second = normal.dot(moving.acceleration + attitude.apply(bent));
        Height { value: gap, rate: normal.dot(passing.slip), second }
    }

    /// What is zero where they touch and has a bounded second derivative, and its rate: the gap and what is added to it, of edges times the sine between them.
    pub(in crate::spatial) fn approach(&self, state: &State, added: f64) -> [f64; 2] {
        match self {
            Self::Corner { .. } => {
                let Passing { at, slip, .. } = self.passing(state);
                [at.gap + added, at.normal.dot(slip)]
            }
            Self::Cross(crossing) => crossing.approach(state, added),
            Self::Round(nearest) => nearest.approach(state, added),
        }
    }

    /// What the second derivatives of that and of [`Pair::beyond`] do not exceed for so long.
    pub(in crate::spatial) fn bend(&self, state: &State, most: &Most, time: f64) -> [f64; 2] {
        match self {
            Self::Corner { face, corner, .. } => {
                let Most { spin, turning, acceleration } = *most;
                let bent = turning + spin * spin;
                let middle = face.plane.onto(Vec3::ZERO);
                let arm = middle.norm();
                let speed = state.velocity.norm() + acceleration * time + spin * arm;
                let far = (state.place(middle) - *corner).norm() + speed * time;
                let own = bent * far + 2.0 * spin * speed + acceleration + bent * arm;
                let ends = 2.0 * (bent + spin * spin) * far + 4.0 * spin * speed + acceleration + bent * arm;
                [own, ends]
            }
            Self::Cross(crossing) => crossing.bend(state, most, time),
            Self::Round(nearest) => nearest.bend(state, most, time),
        }
    }

    /// How many limits the place has.
    pub(in crate::spatial) fn limits(&self) -> usize {
        match self {
            Self::Corner { face, .. } => face.limits.len(),
            Self::Cross(_) => 4,
            Self::Round(nearest) => nearest.limits(),
        }
    }

    /// How far the place is inside one of its limits \[m\].
    pub(in crate::spatial) fn margin(&self, limit: usize, pose: Pose) -> f64 {
        match self {
            Self::Corner { face, corner, .. } => {
                face.limits[limit].margin(pose.attitude.undo(*corner - pose.centre))
            }
            Self::Cross(crossing) => crossing.margin(limit, pose),
            Self::Round(nearest) => nearest.margin(limit, pose),
        }
    }

    /// At that limit an edge ends in a corner, which touches there by itself.
    pub(in crate::spatial) fn ends_in_corner(&self, limit: usize) -> bool {
        match self {
            Self::Cross(Crossing { own, other, .. }) => [own.corners, other.corners].as_flattened()[limit],
            Self::Corner { .. } | Self::Round(_) => false,
        }
    }

    /// How fast that changes [m/s].
    pub(in crate::spatial) fn margin_rate(&self, limit: usize, state: &State) -> f64 {
        match self {
            Self::Corner { face, .. } => {
                let passing = self.passing(state);
                face.limits[limit].inward.dot(state.attitude.undo(passing.place - passing.slip))
            }
            Self::Cross(crossing) => crossing.margin_rate(limit, state),
            Self::Round(nearest) => nearest.margin_rate(limit, state),
        }
    }

    /// True where edges are parallel: they cross nowhere.
    pub(in crate::spatial) fn is_parallel(&self, pose: Pose) -> bool {
        matches!(self, Self::Cross(crossing) if crossing.is_parallel(pose))
    }

    /// What [`Pair::beyond`] is in units of.
    pub(in crate::spatial) fn scale(&self, pose: Pose) -> f64 {
        match self {
            Self::Cross(crossing) => crossing.scale(pose),
            Self::Corner { .. } | Self::Round(_) => 1.0,
        }
    }

    /// How far the place is beyond one of its limits, and its rate: of edges times the square of the sine between them, which bends less; `spare` beyond it is not.
    pub(in crate::spatial) fn beyond(&self, limit: usize, state: &State, spare: f64) -> [f64; 2] {
        match self {
            Self::Cross(crossing) => crossing.beyond(limit, state, spare),
            Self::Corner { .. } | Self::Round(_) => {
                [-self.margin(limit, state.pose()) - spare, -self.margin_rate(limit, state)]
            }
        }
    }

    /// Edges touch in a direction that is outside of both: between the faces of each. A face touches a corner where the obstacle is behind it.
    pub(in crate::spatial) fn faces(&self, pose: Pose) -> bool {
        !self.is_parallel(pose) && self.turned_away(pose)[0] <= 0.0
    }

    /// How far it is turned from directions in which it touches, of edges times the sine between them; and how far at least it has to turn, of which no more than 2 |ω| is taken back. What is
    /// round has limits instead.
    pub(in crate::spatial) fn turned_away(&self, pose: Pose) -> [f64; 2] {
        match self {
            Self::Cross(crossing) => crossing.turned_away(pose),
            Self::Corner { face, spokes, .. } => {
                let away = most(spokes, -pose.attitude.apply(face.plane.normal())) - BETWEEN_FACES;
                [away, away]
            }
            Self::Round(_) => [f64::NEG_INFINITY; 2],
        }
    }
}

/// What a body may touch of an obstacle besides its faces: each of its faces each of the corners, then each of its edges each of the edges. Where one of them is round, each of its points each of
/// the edges, each of its edges each of the corners, and each of its points each of the corners too.
pub(super) fn pairs_of(own: &Surface, obstacle: &Surface) -> Vec<Pair> {
    let (own_radius, radius) = (own.radius, own.radius + obstacle.radius);
    let corners = || obstacle.corners.iter().zip(&obstacle.spokes);
    let mut pairs = vec![];
    for face in &own.faces {
        let of = |(corner, spokes): (&Vec3, &Vec<Vec3>)| Pair::Corner {
            face: face.raised(radius),
            radius: obstacle.radius,
            corner: *corner,
            spokes: spokes.clone(),
        };
        pairs.extend(corners().map(of));
    }
    for edge in &own.edges {
        let of = |other: &Edge| Pair::Cross(Crossing { own: *edge, other: *other, radius, own_radius });
        pairs.extend(obstacle.edges.iter().map(of));
    }
    if radius == 0.0 {
        return pairs;
    }
    let points = || own.corners.iter().zip(&own.spokes);
    let round = |(own, inner): (Span, &[Vec3]), (other, outer): (Span, &[Vec3])| {
        Pair::Round(Nearest { own, other, radius, own_radius, inner: inner.to_vec(), outer: outer.to_vec() })
    };
    for (point, spokes) in points() {
        let of = |edge: &Edge| round((Span::point(*point), spokes), (Span::edge(edge), &edge.sides));
        pairs.extend(obstacle.edges.iter().map(of));
    }
    for edge in &own.edges {
        let of = |(corner, spokes): (&Vec3, &Vec<Vec3>)| {
            round((Span::edge(edge), &edge.sides), (Span::point(*corner), spokes))
        };
        pairs.extend(corners().map(of));
    }
    for (point, own) in points() {
        let of = |(corner, spokes): (&Vec3, &Vec<Vec3>)| {
            round((Span::point(*point), own), (Span::point(*corner), spokes))
        };
        pairs.extend(corners().map(of));
    }
    pairs
}

#[cfg(test)]
mod tests;
