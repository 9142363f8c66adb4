//! Which features touch in a state.

use super::World;
use super::kinematics::{Kinematics, Pairing, Turn};
use crate::planar::geometry::{Feature, Obstacle, Shape, State};
use crate::tolerance::SAME_POINT;
use carom_num::Vec2;

/// Most pairs of features that can touch at once: three boxes face to face on a plate have ten.
pub(in crate::planar) const MOST_TOUCHING: usize = 12;

/// A short list without heap.
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Few<T: Copy> {
    items: [Option<T>; MOST_TOUCHING],
    len: usize,
    /// More was added than fits.
    overflows: bool,
}

impl<T: Copy> Default for Few<T> {
    fn default() -> Self {
        // Not a copy of `EMPTY`: that would copy every place.
        Self { items: [None; MOST_TOUCHING], len: 0, overflows: false }
    }
}

impl<T: Copy> Few<T> {
    /// Nothing.
    pub(super) const EMPTY: Self = Self { items: [None; MOST_TOUCHING], len: 0, overflows: false };

    /// Adds an item; false where the list is full.
    pub(in crate::planar) fn push(&mut self, item: T) -> bool {
        match self.items.get_mut(self.len) {
            Some(place) => {
                *place = Some(item);
                self.len += 1;
                true
            }
            None => {
                self.overflows = true;
                false
            }
        }
    }

    /// Notes that something did not fit that should be here.
    pub(in crate::planar) fn note_overflow(&mut self, overflows: bool) {
        self.overflows |= overflows;
    }

    /// True where something did not fit.
    pub(in crate::planar) fn overflows(&self) -> bool {
        self.overflows
    }

    pub(in crate::planar) fn len(&self) -> usize {
        self.len
    }

    pub(in crate::planar) fn is_empty(&self) -> bool {
        self.len == 0
    }

    pub(in crate::planar) fn get(&self, i: usize) -> Option<&T> {
        self.items[..self.len].get(i)?.as_ref()
    }

    pub(in crate::planar) fn iter(&self) -> impl Iterator<Item = &T> + Clone {
        self.items[..self.len].iter().flatten()
    }

    pub(in crate::planar) fn iter_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.items[..self.len].iter_mut().flatten()
    }

    pub(in crate::planar) fn clear(&mut self) {
        (self.len, self.overflows) = (0, false);
    }

    pub(in crate::planar) fn retain(&mut self, mut keep: impl FnMut(&T) -> bool) {
        let mut kept = 0;
        for i in 0..self.len {
            if self.items[i].as_ref().is_some_and(&mut keep) {
                self.items[kept] = self.items[i];
                kept += 1;
            }
        }
        self.len = kept;
    }
}

/// Where to look for touching features, and how near counts.
pub(in crate::planar) struct Search<'a> {
    /// Gaps up to this count [m].
    pub(in crate::planar) reach: f64,
    /// So deep behind a pair may lie [m]: what lies deeper touches from its other side, if it is thin.
    pub(in crate::planar) deepest: f64,
    /// Side of each obstacle each body is on (true: left of its direction), for a rod in line with it; by [`World::place`].
    pub(in crate::planar) sides: &'a [bool],
    /// Speeds up to this are rounding [m/s].
    pub(in crate::planar) still: f64,
    /// A pair that does not count.
    pub(in crate::planar) except: Option<Pairing>,
}

impl World {
    /// Place of what is known of a body and what it meets in a list of all such pairs.
    pub(in crate::planar) fn place(&self, body: usize, obstacle: usize) -> usize {
        body * self.things() + obstacle
    }

    /// Every body with every obstacle, then with every body after it.
    pub(in crate::planar) fn each_meeting(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (obstacles, bodies) = (self.obstacles.len(), self.bodies.len());
        (0..bodies).flat_map(move |b| {
            (0..obstacles).chain(obstacles + b + 1..obstacles + bodies).map(move |o| (b, o))
        })
    }

    /// All pairs of features that touch, one per contact point.
    pub(in crate::planar) fn touching<const B: usize>(
        &self,
        (states, turns): (&[State; B], &[Turn; B]),
        search: &Search<'_>,
    ) -> Few<Pairing> {
        let mut found = Few::default();
        for meeting in self.each_meeting() {
            if self.are_near(states, meeting, search.reach) {
                self.touching_one(states, turns, meeting, search, &mut found);
            }
        }
        found
    }

    /// False where a body and what it meets are farther apart than their sizes.
    fn are_near(&self, states: &[State], (body, obstacle): (usize, usize), reach: f64) -> bool {
        let (centre, size) = (states[body].pose.centre, self.bodies[body].shape.size() + reach);
        match self.obstacles.get(obstacle) {
            Some(o) => o.is_within(centre, size),
            None => {
                let other = obstacle - self.obstacles.len();
                (centre - states[other].pose.centre).norm() <= size + self.bodies[other].shape.size()
            }
        }
    }

    /// Every pair of features with which a body and what it meets can touch.
    #[inline]
    pub(in crate::planar) fn each_pair(
        &self,
        (body, obstacle): (usize, usize),
        mut offer: impl FnMut(Pairing),
    ) {
        let (own, met) = (&self.bodies[body].shape, self.shape_of(obstacle));
        let offer = |feature| offer(Pairing { body, obstacle, feature });
        if obstacle < self.obstacles.len() {
            own.each_feature(met, Shape::radius_of, offer);
        } else {
            own.each_feature(met, Shape::skin, offer);
        }
    }

    /// True where a body, or what it meets, is round: a contact between them can roll.
    pub(in crate::planar) fn is_round(&self, (body, obstacle): (usize, usize)) -> bool {
        let own = &self.bodies[body].shape;
        match obstacle.checked_sub(self.obstacles.len()) {
            None => own.is_round() || self.obstacles[obstacle].shape().is_round(),
            Some(other) => own.skin(0) + self.bodies[other].shape.skin(0) > 0.0 || own.is_round(),
        }
    }

    /// True where a body and what it meets are both hulls of points, rounded evenly: two of them are apart where an axis parts them.
    pub(in crate::planar) fn are_hulls(&self, (body, obstacle): (usize, usize)) -> bool {
        self.bodies[body].shape.is_hull() && self.shape_of(obstacle).is_hull()
    }

    /// Of the pairs of [`World::each_pair`] those whose gap is within what is searched, and whose normal may point to where the body is.
    fn each_near(
        &self,
        states: &[State],
        turns: &[Turn],
        meeting: (usize, usize),
        search: &Search<'_>,
        mut offer: impl FnMut(Pairing),
    ) {
        let ((body, obstacle), reach) = (meeting, search.reach);
        let is_near = |gap: f64| gap <= reach && gap >= -search.deepest;
        let segment = self.obstacles.get(obstacle).filter(|o| o.is_segment());
        let Some(met) = segment.filter(|_| self.bodies[body].shape.is_hull()) else {
            return self.each_pair(meeting, |pair| {
                if is_near(self.gap(states, turns, pair)) {
                    offer(pair);
                }
            });
        };
        // In the body's frame nothing of the body needs turning, and one distance tells of both sides.
        let (shape, turn, centre) = (&self.bodies[body].shape, turns[body], states[body].pose.centre);
        let (left, radius) = (met.direction().turned_left(), shape.radius());
        let (offset, left) = (left.dot(centre - met.from()), turn.undo(left));
        let mut near = |gap: f64, feature: Feature| {
            if is_near(gap) {
                offer(Pairing { body, obstacle, feature });
            }
        };
        // A rod in line with the obstacle is on both sides at once: memory decides.
        let in_line = radius == 0.0 && shape.vertices().iter().all(|v| left.dot(*v).abs() <= 4.0 * reach);
        let side = in_line.then(|| self.side(search.sides, meeting).unwrap_or(true));
        // Else a side counts that all of the body lies on, up to what is allowed beyond the tangent.
        let all_across = shape.vertices().iter().map(|v| offset + left.dot(*v));
        let lowest = || all_across.clone().fold(f64::INFINITY, f64::min);
        let highest = || all_across.clone().fold(f64::NEG_INFINITY, f64::max);
        let (on_left, on_right) = match side {
            Some(left) => (left, !left),
            None => (lowest() - radius >= -4.0 * reach, highest() + radius <= 4.0 * reach),
        };
        for (vertex, across) in all_across.clone().enumerate() {
            if on_left {
                near(across - radius, Feature::VertexOnFace { vertex, face: Obstacle::LEFT });
            }
            if on_right {
                near(-across - radius, Feature::VertexOnFace { vertex, face: Obstacle::RIGHT });
            }
        }
        for end in [Obstacle::FROM, Obstacle::TO] {
            let seen = turn.undo(met.end(end) - centre);
            for face in 0..shape.faces() {
                let outward = shape.face_normal(face);
                if side.is_none_or(|side| (left.dot(outward) < 0.0) == side) {
                    near(
                        outward.dot(seen - shape.vertices()[face]) - radius,
                        Feature::FaceOnEnd { face, end },
                    );
                }
            }
            if radius > 0.0 {
                for (vertex, at) in shape.vertices().iter().enumerate() {
                    near((seen - *at).norm() - radius, Feature::VertexOnEnd { vertex, end });
                }
            }
        }
    }

    pub(in crate::planar) fn touching_one(
        &self,
        states: &[State],
        turns: &[Turn],
        meeting: (usize, usize),
        search: &Search<'_>,
        found: &mut Few<Pairing>,
    ) {
        let size = self.bodies[meeting.0].shape.size();
        let mut candidates: Few<(Pairing, Kinematics)> = Few::default();
        self.each_near(states, turns, meeting, search, |pair| {
            if search.except == Some(pair) || !self.inside(states, turns, pair, search) {
                return;
            }
            let k = self.kinematics_turned(states, turns, pair);
            if self.outside(states, turns, pair, &k, search) {
                self.keep_one_per_point(&mut candidates, pair, k, search.reach.max(SAME_POINT * size));
            }
        });
        for (pair, _) in candidates.iter() {
            found.push(*pair);
        }
        found.note_overflow(candidates.overflows());
    }

    /// True where a pair lies within its features' extents, and stays there.
    fn inside(&self, states: &[State], turns: &[Turn], pair: Pairing, search: &Search<'_>) -> bool {
        let hair = search.reach.max(self.hair(pair));
        self.extents(states, turns, pair).iter().enumerate().all(|(slot, extent)| {
            // At the end of its extent a contact that is about to leave it does not count: its neighbour does.
            extent.is_none_or(|(room, rate)| {
                room > search.reach
                    || room >= -search.reach && rate >= -search.still
                    || room >= -hair && self.goes_on(pair, slot)
            })
        })
    }

    /// How far the body of a pair reaches beyond the contact's tangent, and how far what it meets does [m]: both at most 0 where they lie
    /// on opposite sides of it.
    pub(in crate::planar) fn beyond_tangent(
        &self,
        states: &[State],
        turns: &[Turn],
        pair: Pairing,
        k: &Kinematics,
    ) -> [f64; 2] {
        if !self.are_hulls(pair.meeting()) {
            // What is not convex lies beyond the tangent near the contact at most: its directions there say by how much.
            let of = self.rooms(states, turns, pair);
            return [of.own, of.met]
                .map(|rooms| rooms.iter().flatten().map(|room| -room.0).fold(f64::NEG_INFINITY, f64::max));
        }
        let shape = &self.body_of(pair).shape;
        let along = |shape: &Shape, turn: Turn, sign: f64| {
            let of = |v: &Vec2| sign * k.normal.dot(turn.apply(*v));
            shape.vertices().iter().map(of).fold(f64::NEG_INFINITY, f64::max)
        };
        let fixed = pair.obstacle < self.obstacles.len();
        let radius = if fixed { shape.radius() } else { shape.skin(0) };
        let own = along(shape, turns[pair.body], -1.0) + k.normal.dot(k.arm) + radius;
        let point = states[pair.body].pose.centre + k.arm;
        let other = match self.obstacles.get(pair.obstacle) {
            Some(o) if o.is_segment() => k.normal.dot(o.from() - point).max(k.normal.dot(o.to() - point)),
            Some(o) => along(o.shape(), Turn::NONE, 1.0) + o.shape().radius() - k.normal.dot(point),
            None => {
                let b = pair.obstacle - self.obstacles.len();
                let shape = &self.bodies[b].shape;
                along(shape, turns[b], 1.0) + shape.skin(0) - k.normal.dot(point - states[b].pose.centre)
            }
        };
        [own, other]
    }

    /// Length of what a pair's body meets [m].
    fn length_met(&self, pair: Pairing) -> f64 {
        match self.obstacles.get(pair.obstacle) {
            Some(o) => o.length(),
            None => 2.0 * self.bodies[pair.obstacle - self.obstacles.len()].shape.size(),
        }
    }

    /// True where the body and what it meets lie on opposite sides of the contact's tangent.
    fn outside(
        &self,
        states: &[State],
        turns: &[Turn],
        pair: Pairing,
        k: &Kinematics,
        search: &Search<'_>,
    ) -> bool {
        let shape = &self.body_of(pair).shape;
        let [own, other] = self.beyond_tangent(states, turns, pair, k);
        // A long obstacle turns a small angle into a large distance.
        let lever = 1.0 + self.length_met(pair) / shape.size();
        own <= 2.0 * search.reach
            && other <= 2.0 * search.reach * lever
            && !self.is_in_corner(pair, k, 2.0 * search.reach / shape.size())
    }

    /// Keeps one pair where two pairs of one body and one thing that it meets touch at one point. Either pair keeps the body out: the one that
    /// approaches least counts. In an inner corner both do.
    fn keep_one_per_point(
        &self,
        candidates: &mut Few<(Pairing, Kinematics)>,
        pair: Pairing,
        k: Kinematics,
        reach: f64,
    ) {
        for (known, kk) in candidates.iter_mut() {
            if (kk.arm - k.arm).norm() <= reach && !self.are_inner_corner(*known, pair) {
                if k.approach > kk.approach {
                    (*known, *kk) = (pair, k);
                }
                return;
            }
        }
        candidates.push((pair, k));
    }
}
