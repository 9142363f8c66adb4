//! The event functions at the nodes of a step, and the first place where one of them falls through zero.

use super::events::{Vector, unpack};
use super::gliding::Gliding;
use super::walker::Walker;
use crate::planar::contact::{
    bounds::Bounds,
    kinematics::{Turn, turns},
};
use crate::planar::geometry::State;
use crate::planar::modes::{
    mode::Forces,
    snapshot::Snapshot,
    watch::{Row, Watched},
};
use crate::tolerance::{JUST_LEFT, LEAVES_DOWNWARD};
use carom_num::Vec2;
use carom_num::falls::{MOST_HALVINGS, Shown, shown};
use carom_num::ode8::Step;
use carom_num::poly::NODES;

/// What three nodes cannot show is taken to be at most this many times the highest term of their quadratic.
const UNSEEN: f64 = 4.0;
/// Event functions that are halved together.
const MOST_DOUBTS: usize = 16;

/// True where the quadratic through nodes 0, 2 and 4 stays above zero by more than what it cannot show.
fn far_from_zero(row: &[f64; 5]) -> bool {
    let (start, middle, end) = (row[0], row[2], row[4]);
    let highest = 0.25 * (start - 2.0 * middle + end);
    let control = 2.0 * middle - 0.5 * (start + end);
    start.min(control).min(end) > UNSEEN * highest.abs()
}

/// What the values of an event function at the nodes of an interval say.
fn said(values: &[f64; 5], w: &Watched, depth: u32) -> Shown {
    let largest = || values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    if w.leaving.is_some() && values[0] < -LEAVES_DOWNWARD * largest() && values.iter().all(|v| v.is_finite())
    {
        // It leaves zero downwards: the event is here.
        return Shown::Falls(0.0);
    }
    shown(values, depth < MOST_HALVINGS)
}

/// The earlier of two places.
fn earlier(a: Option<(f64, Watched)>, b: Option<(f64, Watched)>) -> Option<(f64, Watched)> {
    match (a, b) {
        (Some(x), Some(y)) => Some(if y.0 < x.0 { y } else { x }),
        (one, other) => one.or(other),
    }
}

/// A part of a step, as fractions of it, and how often the step was halved to come to it.
#[derive(Clone, Copy)]
struct Part {
    from: f64,
    to: f64,
    depth: u32,
}

impl Part {
    const WHOLE: Self = Self { from: 0.0, to: 1.0, depth: 0 };

    /// The place of a fraction of the part.
    fn place(self, fraction: f64) -> f64 {
        self.from + (self.to - self.from) * fraction
    }

    fn halves(self) -> [Self; 2] {
        let (middle, depth) = (0.5 * (self.from + self.to), self.depth + 1);
        [Self { to: middle, depth, ..self }, Self { from: middle, depth, ..self }]
    }
}

/// Event functions of an interval whose nodes do not show enough of one of them.
#[derive(Clone, Copy)]
struct Doubts {
    rows: [Option<Row>; MOST_DOUBTS],
    len: usize,
}

impl Doubts {
    fn none() -> Self {
        Self { rows: [None; MOST_DOUBTS], len: 0 }
    }

    fn push(&mut self, row: Row) {
        if let Some(place) = self.rows.get_mut(self.len) {
            *place = Some(row);
            self.len += 1;
        }
    }

    fn rows_mut(&mut self) -> &mut [Option<Row>] {
        &mut self.rows[..self.len]
    }

    fn iter(&self) -> impl Iterator<Item = &Row> {
        self.rows[..self.len].iter().flatten()
    }
}

impl<const B: usize> Gliding<'_, '_, '_, '_, B> {
    /// Looks at the event functions at the nodes of a step; returns bounds on the motion. The two nodes between the middle and the ends are
    /// left out where the other three show that nothing comes near zero.
    pub(super) fn look_over(&mut self, tried: &Step<Vector<B>>) -> [Bounds; B] {
        let mut bounds = [Bounds { horizon: tried.length, ..Bounds::default() }; B];
        let known = self.so_far.is_some();
        if let Some(so_far) = self.so_far {
            bounds = so_far.map(|known| Bounds { horizon: tried.length, ..known });
            self.list.iter_mut().for_each(|row| row.values[0] = row.values[4]);
        }
        self.list.clear = true;
        for node in if known { &[2, 4][..] } else { &[0, 2, 4] } {
            self.look_at_all(tried, *node, &mut bounds);
        }
        self.so_far = Some(bounds);
        let leaves = |row: &Row| self.walker.leaves_at(&row.watched, tried, 0.0);
        if !self.list.iter().all(|row| !leaves(row) && far_from_zero(&row.values)) {
            for node in [1, 3] {
                self.look_at_all(tried, node, &mut bounds);
            }
            self.list.clear = false;
            self.walker.continue_to_start(tried, 0.0, self.list.rows_mut());
        }
        if self.steady {
            return self.steady_bounds(tried);
        }
        // The nodes are samples: leave room between them.
        let gravity = self.walker.world.gravity.norm();
        for bounds in &mut bounds {
            bounds.acceleration = 1.5 * bounds.acceleration + 0.1 * gravity;
            bounds.angular = 1.5 * bounds.angular + 0.1 * gravity / self.walker.scales.length;
            bounds.spin += bounds.angular * tried.length;
            bounds.speed += bounds.acceleration * tried.length;
        }
        bounds
    }

    /// Where the acceleration stays what it is the motion is as bounded as a flight's.
    fn steady_bounds(&self, tried: &Step<Vector<B>>) -> [Bounds; B] {
        let speed = |y: &[f64; 6]| Vec2::new(y[3], y[4]).norm();
        std::array::from_fn(|body| {
            let rate = &tried.start_rate[body];
            let acceleration = Vec2::new(rate[3], rate[4]);
            Bounds {
                horizon: tried.length,
                acceleration: acceleration.norm(),
                angular: 0.0,
                spin: tried.start[body][5].abs(),
                speed: speed(&tried.start[body]).max(speed(&tried.end[body])),
                steady: Some(acceleration),
                left: None,
            }
        })
    }

    /// All event functions at one node of a step, and what they say of the bounds.
    fn look_at_all(&mut self, tried: &Step<Vector<B>>, node: usize, bounds: &mut [Bounds; B]) {
        let states = unpack(&tried.at(NODES[node]));
        let turns = turns(&states);
        let known = self.end.as_ref().filter(|_| node == 4);
        // The start is looked at only where the list has just been made: the forces there are those it was made with.
        if known.is_none() && node != 0 {
            self.walker.effort.evaluations += 1;
            self.walker.world.forces_into(&self.walker.held, &states, &turns, &mut self.forces);
        }
        let forces = known.unwrap_or(&self.forces);
        let time = self.walker.time + NODES[node] * tried.length;
        let snapshot = self.walker.snapshot(time, (&states, &turns), Some(forces));
        let mut looked = 0;
        for row in self.list.iter_mut() {
            row.values[node] = snapshot.value(&row.watched);
            looked += 1;
        }
        self.walker.effort.event_evaluations += looked;
        for ((bounds, acceleration), state) in bounds.iter_mut().zip(forces.acceleration).zip(&states) {
            bounds.acceleration = bounds.acceleration.max(acceleration.linear.norm());
            bounds.angular = bounds.angular.max(acceleration.angular.abs());
            bounds.spin = bounds.spin.max(state.twist.spin.abs());
            bounds.speed = bounds.speed.max(state.twist.velocity.norm());
        }
    }

    /// Some event functions at one node of a part of a step.
    fn look_at(&mut self, tried: &Step<Vector<B>>, part: Part, node: usize, rows: &mut [Option<Row>]) {
        let at = part.place(NODES[node]);
        let states = unpack(&tried.at(at));
        let turns = turns(&states);
        let asked = rows.iter().flatten().any(|row| row.watched.what.asks_forces());
        if asked {
            self.walker.effort.evaluations += 1;
            self.walker.world.forces_into(&self.walker.held, &states, &turns, &mut self.forces);
        }
        let forces = asked.then_some(&self.forces);
        let snapshot = self.walker.snapshot(self.walker.time + at * tried.length, (&states, &turns), forces);
        let mut looked = 0;
        for row in rows.iter_mut().flatten() {
            row.values[node] = snapshot.value(&row.watched);
            looked += 1;
        }
        self.walker.effort.event_evaluations += looked;
    }

    /// The first place in a step where an event function falls through zero.
    pub(super) fn first_fall(&mut self, tried: &Step<Vector<B>>) -> Option<(f64, Watched)> {
        if self.list.clear {
            return None;
        }
        let (first, doubtful) = verdict(self.list.iter(), Part::WHOLE);
        if !doubtful {
            return first;
        }
        // Where one is doubtful, what the nodes say of the others is not believed either.
        let mut first = None;
        for known in (0..).step_by(MOST_DOUBTS) {
            let mut doubts = Doubts::none();
            self.list.iter().skip(known).take(MOST_DOUBTS).for_each(|row| doubts.push(*row));
            if doubts.len == 0 {
                break;
            }
            first = earlier(first, self.halved(tried, &doubts, Part::WHOLE, first));
        }
        first
    }

    /// The first fall of one of these within a part of a step, by halves, up to where one is known already.
    fn halved(
        &mut self,
        tried: &Step<Vector<B>>,
        doubts: &Doubts,
        part: Part,
        known: Option<(f64, Watched)>,
    ) -> Option<(f64, Watched)> {
        for (part, ends) in part.halves().into_iter().zip([[0, 2], [2, 4]]) {
            if known.is_some_and(|(x, _)| x <= part.from) {
                return None;
            }
            let mut rows = *doubts;
            for row in rows.rows_mut().iter_mut().flatten() {
                (row.values[0], row.values[4]) = (row.values[ends[0]], row.values[ends[1]]);
            }
            if let Some(found) = self.fall_in(tried, &mut rows, part, known) {
                return Some(found);
            }
        }
        None
    }

    /// The first fall of one of these, whose values at the ends of a part of a step are known, within that part.
    fn fall_in(
        &mut self,
        tried: &Step<Vector<B>>,
        rows: &mut Doubts,
        part: Part,
        known: Option<(f64, Watched)>,
    ) -> Option<(f64, Watched)> {
        self.look_at(tried, part, 2, rows.rows_mut());
        let leaves = |row: &Row| self.walker.leaves_at(&row.watched, tried, part.from);
        if rows.iter().all(|row| !leaves(row) && far_from_zero(&row.values)) {
            return None;
        }
        for node in [1, 3] {
            self.look_at(tried, part, node, rows.rows_mut());
        }
        self.walker.continue_to_start(tried, part.from, rows.rows_mut());
        let (first, doubtful) = verdict(rows.iter(), part);
        if !doubtful {
            return first;
        }
        self.halved(tried, rows, part, known)
    }
}

impl<const B: usize> Walker<'_, B> {
    /// True where a quantity has just left zero at a place of a step.
    fn leaves_at(&self, w: &Watched, tried: &Step<Vector<B>>, at: f64) -> bool {
        let time = self.time + at * tried.length;
        w.leaving.is_some_and(|l| time - l.since <= JUST_LEFT * tried.length)
    }

    /// What has just left zero is 0/0 at the very start: the cubic through the other nodes continues it.
    fn continue_to_start(&self, tried: &Step<Vector<B>>, from: f64, rows: &mut [Option<Row>]) {
        for row in rows.iter_mut().flatten() {
            if self.leaves_at(&row.watched, tried, from) {
                let known = row.watched.leaving.and_then(|leaving| leaving.first);
                row.values[0] = known.unwrap_or_else(|| extrapolated(&row.values));
            }
        }
    }

    /// A state of the present mode with what event functions need.
    pub(super) fn snapshot<'a>(
        &'a self,
        time: f64,
        (states, turns): (&'a [State; B], &'a [Turn; B]),
        forces: Option<&'a Forces<B>>,
    ) -> Snapshot<'a, B> {
        let (world, scales, held) = (&*self.world, &self.scales, &self.held);
        let heaviest = world.bodies.iter().map(|b| b.mass).fold(0.0, f64::max);
        let weight = heaviest * scales.speed * scales.speed / scales.length;
        Snapshot { world, scales, held, time, states, turns, forces, weight }
    }
}

/// The first fall that the nodes of a part of a step show, and whether they leave a doubt.
fn verdict<'r>(rows: impl Iterator<Item = &'r Row>, part: Part) -> (Option<(f64, Watched)>, bool) {
    let (mut first, mut doubtful) = (None, false);
    for row in rows {
        match said(&row.values, &row.watched, part.depth) {
            Shown::Stays => {}
            Shown::Falls(x) => first = earlier(first, Some((part.place(x), row.watched))),
            Shown::Doubtful => doubtful = true,
        }
    }
    (first, doubtful)
}

/// The cubic through nodes 1…4 continued to node 0.
fn extrapolated(f: &[f64; 5]) -> f64 {
    let mut sum = 0.0;
    for i in 1..5 {
        let mut weight = 1.0;
        for j in 1..5 {
            if j != i {
                weight *= (NODES[0] - NODES[j]) / (NODES[i] - NODES[j]);
            }
        }
        sum += weight * f[i];
    }
    sum
}
