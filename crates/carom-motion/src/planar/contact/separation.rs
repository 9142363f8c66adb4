//! How far a body is from an obstacle, and for how long it certainly stays apart.
//!
//! Two convex sets are apart where some axis separates them. Axes fixed in the world (the obstacle's normals, the line from an end to a
//! vertex) and in the body (its face normals) are tried; along each, the gap of every vertex (or end) is bounded below by a parabola, so
//! the first root of the lowest parabola is a time before which nothing can touch.

use super::World;
use super::bounds::Bounds;
use super::clearance::{Exactness, Moves};
use super::kinematics::{Pairing, Turn};
use super::touching::Few;
use crate::evaluated::{Quantity, evaluated};
use crate::planar::geometry::{Feature, Obstacle, State};
use crate::tolerance::{CLEAR_GAP, MET_GAP, ONE_DIRECTION_SINE, THIN_TOUCHES};
use carom_num::Vec2;
use carom_num::poly::first_root;

/// A pair in touch that is known to stay open for a while [s].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::planar) struct Open {
    pub(in crate::planar) pair: Pairing,
    pub(in crate::planar) time: f64,
}

/// What overlap is passed over, and which pairs in touch are known to stay open.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::planar) struct Leniency {
    /// Overlap up to this depth [m] counts as apart.
    pub(in crate::planar) allowance: f64,
    pub(in crate::planar) open: Few<Open>,
}

impl Leniency {
    /// None at all.
    pub(in crate::planar) const NONE: Self = Self { allowance: 0.0, open: Few::EMPTY };
}

/// Distance to an obstacle and a time for which it certainly stays positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::planar) struct Apart {
    /// Largest separation found along an axis [m]; ≤ 0 where none separates.
    pub(in crate::planar) distance: f64,
    /// No overlap is deeper than the allowance before this long [s].
    pub(in crate::planar) safe: f64,
}

/// One look at one body and one obstacle.
struct Probe<'a> {
    state: &'a State,
    turn: Turn,
    body: usize,
    obstacle: usize,
    bounds: &'a Bounds,
    leniency: &'a Leniency,
    /// Both are hulls: what their hulls do, they do.
    hulls: bool,
    /// The side of a segment on which a rod in line with it is, as a normal of the segment. The rod may have sunk a hair: the other side does not part them.
    side: Option<Vec2>,
}

/// True where one look shows that `gap + rate τ − bend τ² / 2` has no root up to `time`. A function that does not bend downwards is taken as
/// straight.
fn stays_apart((gap, rate, bend): (f64, f64, f64), time: f64) -> bool {
    gap > 0.0 && gap + time * (rate - 0.5 * bend.max(0.0) * time) > 0.0
}

impl World {
    /// Separation of a body in this state and an obstacle along the best axis [m]: the distance where they are apart, negative where they
    /// overlap.
    ///
    /// # Example
    /// A ball of radius 0.1 m, its centre 0.3 m above a floor.
    /// ```
    /// use carom_motion::planar::examples;
    /// let (world, start) = examples::falling_ball();
    /// assert!((world.clearance(0, &start, 0) - 0.2).abs() < 1e-15);
    /// ```
    pub fn clearance(&self, body: usize, state: &State, obstacle: usize) -> f64 {
        self.apart(state, (body, obstacle), &Bounds::default(), &Leniency::NONE).distance
    }

    /// False where a body in this state is farther from an obstacle than its size. It looks at one distance only: ask it before [`World::clearance`],
    /// which looks at all of them.
    ///
    /// # Example
    /// A ball whose centre is three times its radius away cannot touch; one that lies on the floor may.
    /// ```
    /// use carom_motion::planar::{Pose, State, examples};
    /// use carom_num::Vec2;
    /// let (world, start) = examples::falling_ball();
    /// let lying = State { pose: Pose { centre: Vec2::new(0.0, 0.1), angle: 0.0 }, ..start };
    /// assert!(!world.may_touch(0, &start, 0) && world.may_touch(0, &lying, 0));
    /// ```
    pub fn may_touch(&self, body: usize, state: &State, obstacle: usize) -> bool {
        !self.out_of_reach(state, (body, obstacle), &Bounds::default())
    }

    /// True where a body is farther from an obstacle than its mass centre can come within the bounds.
    pub(in crate::planar) fn out_of_reach(
        &self,
        state: &State,
        (body, obstacle): (usize, usize),
        bounds: &Bounds,
    ) -> bool {
        let (o, shape) = (&self.obstacles[obstacle], &self.bodies[body].shape);
        if !o.is_segment() {
            let reach = (1.0 + CLEAR_GAP) * shape.size() + bounds.speed * bounds.horizon;
            return !o.is_within(state.pose.centre, reach);
        }
        let d = state.pose.centre - o.from();
        let along = o.direction().dot(d);
        let beyond = (-along).max(along - o.length()).max(0.0);
        let across = o.direction().cross(d);
        let reach = (1.0 + CLEAR_GAP) * shape.size() + bounds.speed * bounds.horizon;
        beyond * beyond + across * across > reach * reach
    }

    /// Separation, and a time for which no overlap becomes deeper than is allowed.
    pub(in crate::planar) fn apart(
        &self,
        state: &State,
        (body, obstacle): (usize, usize),
        bounds: &Bounds,
        leniency: &Leniency,
    ) -> Apart {
        let turn = Turn::of(state);
        let mut best = Apart { distance: f64::NEG_INFINITY, safe: 0.0 };
        let (o, hulls) = (&self.obstacles[obstacle], self.are_hulls((body, obstacle)));
        let in_line = CLEAR_GAP * self.bodies[body].shape.size();
        let known = bounds.left.map(|left| (left, in_line));
        let side = known.and_then(|known| self.side_in_line((state, turn), (body, obstacle), known));
        let probe = Probe { state, turn, body, obstacle, bounds, leniency, hulls, side };
        let (shape, met) = (self.bodies[body].shape.hull(), o.shape().hull());
        for normal in o.normals(state.pose.centre).filter(|normal| side.is_none_or(|s| s.dot(*normal) > 0.0))
        {
            self.try_world_axis(&probe, normal, &mut best);
            // What lies on one side of an obstacle is not on the other.
            if best.distance > leniency.allowance {
                break;
            }
        }
        // Apart by one axis for as long as was asked.
        if bounds.horizon > 0.0 && best.safe >= bounds.horizon && best.distance > CLEAR_GAP * shape.size() {
            return Apart { safe: bounds.horizon, ..best };
        }
        self.try_body_axes(&probe, &mut best);
        // Two segments in line are apart along their line, which is no normal of theirs; what has an inside needs its normals only.
        let thin = shape.vertices().len() < 3;
        if thin && best.distance <= THIN_TOUCHES * shape.size() || shape.radius() + met.radius() > 0.0 {
            for end in met.vertices() {
                for v in shape.vertices() {
                    let d = state.pose.centre + turn.apply(*v) - *end;
                    if let Some(axis) = d.unit() {
                        self.try_world_axis(&probe, axis, &mut best);
                    }
                }
            }
        }
        // No axis parts what lies in a hollow: there each pair of features tells for how long it does not touch.
        if !hulls && best.safe < bounds.horizon.max(f64::MIN_POSITIVE) {
            self.try_features(&probe, &mut best);
        }
        best.safe = best.safe.min(bounds.horizon);
        best.distance = evaluated(Quantity::Distance, best.distance);
        best
    }

    /// By the features themselves, one pair after the other.
    fn try_features(&self, probe: &Probe<'_>, best: &mut Apart) {
        let (bounds, body) = (probe.bounds, probe.body);
        let moves = Moves {
            horizon: bounds.horizon,
            acceleration: bounds.acceleration,
            steady: bounds.steady,
            speed: bounds.speed,
            angular: [bounds.angular, 0.0],
            spin: [bounds.spin, 0.0],
        };
        // Of the bodies only this one is asked about.
        let (states, turns) = (vec![*probe.state; body + 1], vec![probe.turn; body + 1]);
        let exact = MET_GAP * self.bodies[body].shape.size();
        let (mut distance, mut safe) = (f64::INFINITY, bounds.horizon);
        self.each_pair((body, probe.obstacle), |pair| {
            let known = probe.known_open(pair.feature).unwrap_or(0.0);
            if known >= bounds.horizon && bounds.horizon > 0.0 {
                return;
            }
            let exactness = Exactness { allowance: probe.leniency.allowance, exact };
            let clear = self.clearance_of((&states, &turns), pair, &moves, exactness);
            (distance, safe) = (distance.min(clear.distance), safe.min(clear.safe.max(known)));
        });
        // The allowance counts as apart, as it does along an axis.
        best.take(distance - probe.leniency.allowance, safe, probe.leniency);
    }

    fn try_world_axis(&self, probe: &Probe<'_>, axis: Vec2, best: &mut Apart) {
        let (o, shape) = (&self.obstacles[probe.obstacle], self.bodies[probe.body].shape.hull());
        let (c, v, w) = (probe.state.pose.centre, probe.state.twist.velocity, probe.state.twist.spin);
        let support = o.support(axis) + shape.radius();
        let bounds = probe.bounds;
        let bend = bounds.against(axis) + (bounds.angular + bounds.spin * bounds.spin) * shape.reach();
        // In the body's frame no vertex needs turning.
        let (seen, base, drift) = (probe.turn.undo(axis), axis.dot(c) - support, axis.dot(v));
        let (mut distance, mut safe) = (f64::INFINITY, bounds.horizon);
        for (number, vertex) in shape.vertices().iter().enumerate() {
            let along = seen.dot(*vertex);
            let gap = base + along;
            distance = distance.min(gap);
            let room = (gap + probe.leniency.allowance).max(0.0);
            let rate = drift + w * seen.dot(vertex.turned_left());
            if stays_apart((room, rate, bend), safe) {
                continue;
            }
            let mut free = first_root(room, rate, bend);
            if bounds.steady.is_some() {
                free = free.max(bounds.in_flight(axis, (along, shape.reach()), w, (room, rate), free));
            }
            if probe.hulls
                && let Some(face) = o.face_along(axis)
                && let Some(time) = probe.known_open(Feature::VertexOnFace { vertex: number, face })
            {
                free = free.max(time);
            }
            safe = safe.min(free);
        }
        best.take(distance, safe, probe.leniency);
    }

    fn try_body_axes(&self, probe: &Probe<'_>, best: &mut Apart) {
        let c = probe.state.pose.centre;
        let met = self.obstacles[probe.obstacle].shape().hull();
        let seen = |end: usize| {
            let d = met.vertices()[end] - c;
            (end, probe.turn.undo(d), probe.bounds.bend_seen_from_body(d))
        };
        if met.is_thin_rod() {
            self.try_faces_against(probe, &[seen(Obstacle::FROM), seen(Obstacle::TO)], 0.0, best);
        } else {
            let ends: Vec<_> = (0..met.vertices().len()).map(seen).collect();
            self.try_faces_against(probe, &ends, met.radius(), best);
        }
    }

    /// Along the normals of the body's faces, against the vertices of an obstacle (by their numbers, as the body sees them, and how their distance
    /// may bend) of this radius.
    #[inline(always)]
    fn try_faces_against(
        &self,
        probe: &Probe<'_>,
        ends: &[(usize, Vec2, f64)],
        radius: f64,
        best: &mut Apart,
    ) {
        let (v, w) = (probe.state.twist.velocity, probe.state.twist.spin);
        let shape = self.bodies[probe.body].shape.hull();
        let drift = probe.turn.undo(v);
        // While something separates them already, an axis counts only if it does so for longer.
        let longer =
            best.distance > CLEAR_GAP * shape.size() && best.safe > 0.0 && probe.leniency.open.is_empty();
        let side = probe.side.map(|side| probe.turn.undo(side));
        'faces: for face in 0..shape.faces() {
            let axis = shape.face_normal(face);
            if side.is_some_and(|side| side.dot(axis) > 0.0) {
                continue;
            }
            let support = axis.dot(shape.vertices()[face]) + shape.radius() + radius;
            let spared = probe.bounds.spared_along(probe.turn.apply(axis));
            let allowed = |gap: f64| gap + probe.leniency.allowance;
            let (mut distance, mut safe) = (f64::INFINITY, probe.bounds.horizon);
            for (end, d, bend) in ends {
                let gap = axis.dot(*d) - support;
                // What is met already does not stay apart because nothing drives it on.
                let bend = if gap > MET_GAP * shape.size() { bend - spared } else { *bend };
                let rate = w * axis.turned_left().dot(*d) - axis.dot(drift);
                if longer && !stays_apart((allowed(gap), rate, bend), best.safe) {
                    continue 'faces;
                }
                distance = distance.min(gap);
                let room = allowed(gap).max(0.0);
                if stays_apart((room, rate, bend), safe) {
                    continue;
                }
                let mut free = first_root(room, rate, bend);
                if probe.hulls
                    && let Some(time) = probe.known_open(Feature::FaceOnEnd { face, end: *end })
                {
                    free = free.max(time);
                }
                safe = safe.min(free);
            }
            best.take(distance, safe, probe.leniency);
        }
    }
}

impl Obstacle {
    /// Normals out of its hull, first those towards a point.
    fn normals(&self, towards: Vec2) -> impl Iterator<Item = Vec2> {
        let hull = self.shape().hull();
        let (segment, faces) = (self.is_segment(), hull.faces());
        // Of a segment, the side on which the point is; of others, whichever comes.
        let first = usize::from(segment && hull.face_normal(Self::LEFT).dot(towards - self.from()) >= 0.0);
        (0..faces).map(move |face| hull.face_normal(if segment { face ^ first } else { face }))
    }

    /// How far its hull reaches along an axis [m].
    fn support(&self, axis: Vec2) -> f64 {
        if self.is_segment() {
            return axis.dot(self.from()).max(axis.dot(self.to()));
        }
        let hull = self.shape().hull();
        hull.vertices().iter().map(|v| axis.dot(*v)).fold(f64::NEG_INFINITY, f64::max) + hull.radius()
    }

    /// The face whose normal is along an axis.
    fn face_along(&self, axis: Vec2) -> Option<usize> {
        if self.is_segment() {
            let face = if self.direction().cross(axis) > 0.0 { Self::LEFT } else { Self::RIGHT };
            return (self.direction().dot(axis).abs() < ONE_DIRECTION_SINE).then_some(face);
        }
        let shape = self.shape();
        (0..shape.faces()).find(|face| {
            let normal = shape.face_normal(*face);
            normal.dot(axis) > 0.0 && normal.cross(axis).abs() < ONE_DIRECTION_SINE
        })
    }
}

impl Probe<'_> {
    /// For how long a pair of this obstacle is known to stay open.
    fn known_open(&self, feature: Feature) -> Option<f64> {
        let pair = Pairing { body: self.body, obstacle: self.obstacle, feature };
        self.leniency.open.iter().find(|o| o.pair == pair).map(|o| o.time)
    }
}

impl Apart {
    fn take(&mut self, distance: f64, safe: f64, leniency: &Leniency) {
        self.distance = self.distance.max(distance);
        if distance > -leniency.allowance {
            self.safe = self.safe.max(safe);
        }
    }
}
