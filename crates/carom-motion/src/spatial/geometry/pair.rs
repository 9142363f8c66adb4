//! What a body touches an obstacle with but for its own points: a face with a corner of the obstacle, an edge with an edge.
//!
//! The place where they touch moves along the body or along the obstacle, and its normal turns with the body. With the velocity ẋ of the place, the rate ṅ of
//! its normal and the velocity s of the body's material there, s is accelerated by `a + α × r + ω × (ẋ − v)`, and the gap, whose rate is `n · s`, by `n` times
//! that and by `ṅ · s`.

use super::posture::{Height, Most, Moving};
use super::state::{Pose, State};
use super::surface::{Edge, Facet};
use crate::tolerance::{BETWEEN_FACES, PARALLEL_EDGES};
use carom_num::Vec3;

/// Two of them that may touch: the body's in its axes from the mass centre, the obstacle's in the world's.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::spatial) enum Pair {
    /// A face of the body, and a corner of an obstacle.
    Corner {
        /// The face.
        face: Facet,
        /// The corner.
        corner: Vec3,
        /// Unit vectors from it along the obstacle's edges.
        spokes: Vec<Vec3>,
    },
    /// An edge of the body across an edge of an obstacle.
    Cross {
        /// The body's.
        own: Edge,
        /// The obstacle's.
        other: Edge,
    },
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

/// Two edges at an instant, world axes.
struct Crossed {
    /// The body's direction, the common perpendicular as long as the sine between them, on which side of it the body is, and that sine.
    along: Vec3,
    straight: Vec3,
    side: f64,
    sine: f64,
    /// From the middle of the obstacle's edge, which may be long, to the start of the body's.
    between: Vec3,
}

impl Crossed {
    fn of(own: &Edge, other: &Edge, pose: Pose) -> Self {
        let along = pose.attitude.apply(own.along);
        let straight = along.cross(other.along);
        let side = if straight.dot(pose.attitude.apply(own.outward)) > 0.0 { -1.0 } else { 1.0 };
        let between = pose.centre + pose.attitude.apply(own.from) - other.middle();
        Self { along, straight, side, sine: straight.norm(), between }
    }

    /// The perpendicular that points into the body.
    fn across(&self) -> Vec3 {
        self.straight * self.side
    }

    fn is_parallel(&self) -> bool {
        self.sine <= PARALLEL_EDGES
    }

    /// How far along the two edges they are nearest to each other.
    fn places(&self, other: &Edge) -> [f64; 2] {
        let square = self.sine * self.sine;
        let place = |edge: Vec3| -self.between.cross(edge).dot(self.straight) / square;
        [place(other.along), place(self.along) + 0.5 * other.length]
    }
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
            Self::Corner { face, corner, .. } => {
                let gap = face.plane.height(pose.attitude.undo(*corner - pose.centre));
                Meeting { place: *corner, normal: -pose.attitude.apply(face.plane.normal()), gap }
            }
            Self::Cross { own, other } => {
                let crossed = Crossed::of(own, other, pose);
                if crossed.is_parallel() {
                    let place = pose.centre + pose.attitude.apply(own.from);
                    return Meeting { place, normal: Vec3::Z, gap: f64::INFINITY };
                }
                let normal = crossed.across() / crossed.sine;
                let [along, _] = crossed.places(other);
                let place = other.middle() + crossed.between + crossed.along * along;
                Meeting { place, normal, gap: normal.dot(crossed.between) }
            }
        }
    }

    pub(in crate::spatial) fn passing(&self, state: &State) -> Passing {
        let pose = state.pose();
        let at = self.meeting(pose);
        let Meeting { place, normal, gap } = at;
        let spin = pose.attitude.apply(state.spin);
        let slip = state.velocity + spin.cross(place - pose.centre);
        match self {
            Self::Corner { .. } => Passing { at, place: Vec3::ZERO, normal: spin.cross(normal), slip },
            Self::Cross { own, other } => {
                let crossed = Crossed::of(own, other, pose);
                if crossed.is_parallel() {
                    return Passing { at, place: slip, normal: Vec3::ZERO, slip };
                }
                let turns = spin.cross(crossed.along).cross(other.along) * crossed.side;
                let turns = (turns - normal * normal.dot(turns)) / crossed.sine;
                let square = crossed.sine * crossed.sine;
                let runs = (turns * gap - slip).cross(other.along).dot(crossed.straight) / square;
                Passing { at, place: slip + crossed.along * runs, normal: turns, slip }
            }
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
        let pose = state.pose();
        let spin = pose.attitude.apply(state.spin);
        match self {
            Self::Corner { .. } => {
                let Meeting { place, normal, gap } = self.meeting(pose);
                [gap + added, normal.dot(state.velocity + spin.cross(place - pose.centre))]
            }
            Self::Cross { own, other } => {
                let crossed = Crossed::of(own, other, pose);
                let Crossed { along, side, between, sine, .. } = crossed;
                let (across, added) = (crossed.across(), added * sine);
                let velocity = state.velocity + spin.cross(pose.attitude.apply(own.from));
                let turns = spin.cross(along).cross(other.along) * side;
                [across.dot(between) + added, turns.dot(between) + across.dot(velocity)]
            }
        }
    }

    /// What the second derivatives of that and of [`Pair::beyond`] do not exceed for so long.
    pub(in crate::spatial) fn bend(&self, state: &State, most: &Most, time: f64) -> [f64; 2] {
        let Most { spin, turning, acceleration } = *most;
        let bent = turning + spin * spin;
        let (middle, there, lengths) = match self {
            Self::Corner { face, corner, .. } => (face.plane.onto(Vec3::ZERO), *corner, 0.0),
            Self::Cross { own, other } => (own.middle(), other.middle(), own.length + other.length),
        };
        let arm = middle.norm() + lengths;
        let speed = state.velocity.norm() + acceleration * time + spin * arm;
        let far = (state.place(middle) - there).norm() + lengths + speed * time;
        let own = bent * far + 2.0 * spin * speed + acceleration + bent * arm;
        let ends =
            2.0 * (bent + spin * spin) * (far + lengths) + 4.0 * spin * speed + acceleration + bent * arm;
        [own, ends]
    }

    /// How many limits the place has.
    pub(in crate::spatial) fn limits(&self) -> usize {
        match self {
            Self::Corner { face, .. } => face.limits.len(),
            Self::Cross { .. } => 4,
        }
    }

    /// How far the place is inside one of its limits \[m\].
    pub(in crate::spatial) fn margin(&self, limit: usize, pose: Pose) -> f64 {
        match self {
            Self::Corner { face, corner, .. } => {
                face.limits[limit].margin(pose.attitude.undo(*corner - pose.centre))
            }
            Self::Cross { own, other } => {
                let crossed = Crossed::of(own, other, pose);
                if crossed.is_parallel() {
                    return f64::NEG_INFINITY;
                }
                let [along, beside] = crossed.places(other);
                [along, own.length - along, beside, other.length - beside][limit]
            }
        }
    }

    /// How fast that changes [m/s].
    pub(in crate::spatial) fn margin_rate(&self, limit: usize, state: &State) -> f64 {
        let passing = self.passing(state);
        match self {
            Self::Corner { face, .. } => {
                face.limits[limit].inward.dot(state.attitude.undo(passing.place - passing.slip))
            }
            Self::Cross { own, other } => {
                let along = state.attitude.apply(own.along).dot(passing.place - passing.slip);
                let beside = other.along.dot(passing.place);
                [along, -along, beside, -beside][limit]
            }
        }
    }

    /// True where edges are parallel: they cross nowhere.
    pub(in crate::spatial) fn is_parallel(&self, pose: Pose) -> bool {
        match self {
            Self::Corner { .. } => false,
            Self::Cross { own, other } => Crossed::of(own, other, pose).is_parallel(),
        }
    }

    /// What [`Pair::beyond`] is in units of.
    pub(in crate::spatial) fn scale(&self, pose: Pose) -> f64 {
        match self {
            Self::Corner { .. } => 1.0,
            Self::Cross { own, other } => {
                let sine = Crossed::of(own, other, pose).sine;
                sine * sine
            }
        }
    }

    /// How far the place is beyond one of its limits, and its rate: of edges times the square of the sine between them, which bends less; `spare` beyond it is not.
    pub(in crate::spatial) fn beyond(&self, limit: usize, state: &State, spare: f64) -> [f64; 2] {
        let pose = state.pose();
        let spin = pose.attitude.apply(state.spin);
        match self {
            Self::Corner { .. } => [-self.margin(limit, pose) - spare, -self.margin_rate(limit, state)],
            Self::Cross { own, other } => {
                let Crossed { along, straight, sine, between, .. } = Crossed::of(own, other, pose);
                let moves = state.velocity + spin.cross(pose.attitude.apply(own.from));
                let (turns, edge) = (spin.cross(along), other.along);
                let bent = turns.cross(edge);
                let (square, widens) = (sine * sine, 2.0 * straight.dot(bent));
                let (run, rate, length) = if limit < 2 {
                    let run = between.cross(edge);
                    (run.dot(straight), moves.cross(edge).dot(straight) + run.dot(bent), own.length)
                } else {
                    let run = between.cross(along);
                    let rate = moves.cross(along) + between.cross(turns);
                    let half = 0.5 * other.length;
                    let (run, rate) = (run.dot(straight), rate.dot(straight) + run.dot(bent));
                    (run - half * square, rate - half * widens, other.length)
                };
                let (run, rate) = if limit.is_multiple_of(2) {
                    (run, rate)
                } else {
                    (-run - length * square, -rate - length * widens)
                };
                [run - spare * square, rate - spare * widens]
            }
        }
    }

    /// Edges touch in a direction that is outside of both: between the faces of each. A face touches a corner where the obstacle is behind it.
    pub(in crate::spatial) fn faces(&self, pose: Pose) -> bool {
        !self.is_parallel(pose) && self.turned_away(pose)[0] <= 0.0
    }

    /// How far it is turned from directions in which it touches, of edges times the sine between them; and how far at least it has to turn, of which no more than 2 |ω| is taken back.
    ///
    /// The perpendicular of two edges changes its side where it is across the middle of the body's faces: what the obstacle's faces say of it holds until then.
    pub(in crate::spatial) fn turned_away(&self, pose: Pose) -> [f64; 2] {
        let most = |sides: &[Vec3], normal: Vec3| {
            sides.iter().map(|side| side.dot(normal)).fold(f64::NEG_INFINITY, f64::max)
        };
        match self {
            Self::Cross { own, other } => {
                let crossed = Crossed::of(own, other, pose);
                let (across, sine) = (crossed.across(), crossed.sine);
                let inner = pose.attitude.undo(-across);
                let [body, obstacle] = [most(&own.sides, inner), most(&other.sides, across)];
                let flips = own.outward.unit().map_or(0.0, |outward| outward.dot(inner).abs());
                let spare = BETWEEN_FACES * sine;
                [body.max(obstacle) - spare, body.max(obstacle.min(flips)) - spare]
            }
            Self::Corner { face, spokes, .. } => {
                let away = most(spokes, -pose.attitude.apply(face.plane.normal())) - BETWEEN_FACES;
                [away, away]
            }
        }
    }
}

#[cfg(test)]
mod tests;
