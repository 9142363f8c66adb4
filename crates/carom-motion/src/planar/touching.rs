//! Which features touch in a state.

use super::kinematics::{Kinematics, Pairing, Turn};
use super::{Feature, Shape, State, World};
use carom_num::Vec2;

/// Most pairs of features that can touch at once.
pub(super) const MOST_TOUCHING: usize = carom_impact::planar::MOST_CONTACTS;

/// A short list without heap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Few<T: Copy> {
    items: [Option<T>; MOST_TOUCHING],
    len: usize,
    /// More was added than fits.
    overflows: bool,
}

impl<T: Copy> Default for Few<T> {
    fn default() -> Self {
        Self { items: [None; MOST_TOUCHING], len: 0, overflows: false }
    }
}

impl<T: Copy> Few<T> {
    /// Adds an item; false where the list is full.
    pub(super) fn push(&mut self, item: T) -> bool {
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

    /// True where something did not fit.
    pub(super) fn overflows(&self) -> bool {
        self.overflows
    }

    pub(super) fn len(&self) -> usize {
        self.len
    }

    pub(super) fn is_empty(&self) -> bool {
        self.len == 0
    }

    pub(super) fn get(&self, i: usize) -> Option<&T> {
        self.items.get(i)?.as_ref()
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &T> + Clone {
        self.items[..self.len].iter().flatten()
    }

    pub(super) fn iter_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.items[..self.len].iter_mut().flatten()
    }

    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    pub(super) fn retain(&mut self, mut keep: impl FnMut(&T) -> bool) {
        let old = *self;
        self.clear();
        for item in old.iter().filter(|i| keep(i)) {
            self.push(*item);
        }
    }
}

/// Where to look for touching features, and how near counts.
pub(super) struct Search<'a> {
    /// Gaps up to this count [m].
    pub(super) reach: f64,
    /// Side of each obstacle the body is on (true: left of its direction), for a rod in line with it.
    pub(super) sides: &'a [bool],
    /// Speeds up to this are rounding [m/s].
    pub(super) still: f64,
    /// A pair that does not count.
    pub(super) except: Option<Pairing>,
}

impl World {
    /// All pairs of features that touch, one per contact point.
    pub(super) fn touching(&self, state: &State, search: &Search<'_>) -> Few<Pairing> {
        let turn = Turn::of(state);
        let mut found = Few::default();
        for (number, obstacle) in self.obstacles.iter().enumerate() {
            let size = self.body.shape.size() + search.reach;
            let (along, d) = (obstacle.direction(), state.pose.centre - obstacle.from());
            let s = along.dot(d);
            if along.cross(d).abs() > size || s < -size || s > obstacle.length() + size {
                continue;
            }
            self.touching_one(state, turn, number, search, &mut found);
        }
        found
    }

    pub(super) fn touching_one(
        &self,
        state: &State,
        turn: Turn,
        obstacle: usize,
        search: &Search<'_>,
        found: &mut Few<Pairing>,
    ) {
        let shape = &self.body.shape;
        let mut candidates: Few<(Pairing, Kinematics)> = Few::default();
        let offer = |feature: Feature| {
            let pair = Pairing { obstacle, feature };
            if search.except == Some(pair) {
                return;
            }
            let k = self.kinematics_turned(state, turn, pair);
            let inside = self.extents(state, turn, pair).iter().flatten().all(|(s, rate)| {
                // At the end of its extent a contact that is about to leave it does not count: its neighbour does.
                *s >= -search.reach && (*s > search.reach || *rate >= -search.still)
            });
            if k.gap.abs() <= search.reach && inside && self.outside(state, turn, pair, &k, search) {
                keep_one_per_point(&mut candidates, pair, k, search.reach.max(1e-9 * shape.size()));
            }
        };
        shape.each_feature(offer);
        for (pair, _) in candidates.iter() {
            found.push(*pair);
        }
    }

    /// True where the body and the obstacle lie on opposite sides of the contact's tangent.
    fn outside(&self, state: &State, turn: Turn, pair: Pairing, k: &Kinematics, search: &Search<'_>) -> bool {
        let (shape, o) = (&self.body.shape, &self.obstacles[pair.obstacle]);
        let lowest = |shape: &Shape| {
            shape.vertices().iter().map(|v| k.normal.dot(turn.apply(*v))).fold(f64::INFINITY, f64::min)
        };
        let contact = k.normal.dot(k.arm) + shape.radius();
        if lowest(shape) < contact - 2.0 * search.reach {
            return false;
        }
        let point = state.pose.centre + k.arm;
        // A long obstacle turns a small angle into a large distance.
        let lever = 1.0 + o.length() / shape.size();
        if k.normal.dot(o.from() - point).max(k.normal.dot(o.to() - point)) > 2.0 * search.reach * lever {
            return false;
        }
        // A rod in line with the obstacle is on both sides at once: memory decides.
        let along = o.direction();
        let spread =
            |a: Vec2| shape.vertices().iter().map(|v| a.dot(turn.apply(*v)).abs()).fold(0.0, f64::max);
        let in_line = shape.radius() == 0.0 && spread(along.turned_left()) <= 4.0 * search.reach;
        let left = search.sides.get(pair.obstacle).copied().unwrap_or(true);
        !in_line || (along.turned_left().dot(k.normal) > 0.0) == left
    }
}

/// Where two pairs of one obstacle touch at one point, the body is kept out by either: the one that approaches least counts.
fn keep_one_per_point(candidates: &mut Few<(Pairing, Kinematics)>, pair: Pairing, k: Kinematics, reach: f64) {
    for (known, kk) in candidates.iter_mut() {
        if (kk.arm - k.arm).norm() <= reach {
            if k.approach > kk.approach {
                (*known, *kk) = (pair, k);
            }
            return;
        }
    }
    candidates.push((pair, k));
}
