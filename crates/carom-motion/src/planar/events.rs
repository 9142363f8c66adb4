//! The events of a mode: found on the dense output of a step, polished by stepping to them.

use super::flight::MET;
use super::kinematics::Pairing;
use super::mode::Acceleration;
use super::separation::{Bounds, Leniency, Open};
use super::touching::Few;
use super::walker::Walker;
use super::watch::{MOST_WATCHED, Snapshot, WatchList, Watched};
use super::{Pose, State, Twist};
use carom_num::Vec2;
use carom_num::ode8::{EVALUATIONS_PLAIN, Step, Trial, step_plain};
use carom_num::poly::{NODES, Quartic};

/// The states of several bodies as the integration takes them.
pub(super) type Vector<const B: usize> = [[f64; 6]; B];

pub(super) fn pack<const B: usize>(states: &[State; B]) -> Vector<B> {
    states.map(|s| {
        let (c, v) = (s.pose.centre, s.twist.velocity);
        [c.x, c.y, s.pose.angle, v.x, v.y, s.twist.spin]
    })
}

pub(super) fn unpack<const B: usize>(y: &Vector<B>) -> [State; B] {
    y.map(|y| State {
        pose: Pose { centre: Vec2::new(y[0], y[1]), angle: y[2] },
        twist: Twist { velocity: Vec2::new(y[3], y[4]), spin: y[5] },
    })
}

pub(super) fn rate<const B: usize>(y: &Vector<B>, a: &[Acceleration; B]) -> Vector<B> {
    std::array::from_fn(|b| [y[b][3], y[b][4], y[b][5], a[b].linear.x, a[b].linear.y, a[b].angular])
}

/// What ends a piece of a mode.
#[derive(Clone, Copy, Debug)]
pub(super) enum Event {
    /// An event function of the mode came to zero.
    Watched(Watched),
    /// A pair of another obstacle closed.
    Meets(Pairing),
}

/// An event within a step: where, as a length from the step's start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) length: f64,
    /// Slope of the event function there, per second.
    slope: f64,
    pub(super) event: Event,
}

/// Where a step to an event ends.
pub(super) struct Reached<const B: usize> {
    /// Length from the step's start [s].
    pub(super) length: f64,
    pub(super) state: Vector<B>,
}

/// Values of all event functions at the five nodes of an interval.
pub(super) type Table = [[f64; 5]; MOST_WATCHED];

/// The event functions over an interval, and bounds on the motion.
struct Notes<const B: usize> {
    node: usize,
    table: Table,
    bounds: [Bounds; B],
    /// Three nodes show that nothing comes near zero: the other two were not looked at.
    clear: bool,
}

/// The event functions at the end of a step: those at the start of the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look<const B: usize> {
    time: f64,
    column: [f64; MOST_WATCHED],
    bounds: [Bounds; B],
}

impl<const B: usize> Look<B> {
    fn at_end(note: &Notes<B>, time: f64) -> Self {
        Self { time, column: note.table.map(|row| row[4]), bounds: note.bounds }
    }

    fn into_notes(self, note: &mut Notes<B>) {
        for (row, value) in note.table.iter_mut().zip(self.column) {
            row[0] = value;
        }
        for (bounds, known) in note.bounds.iter_mut().zip(self.bounds) {
            *bounds = Bounds { horizon: bounds.horizon, ..known };
        }
    }
}

impl<const B: usize> Notes<B> {
    fn new(horizon: f64) -> Self {
        let bounds = [Bounds { horizon, ..Bounds::default() }; B];
        Self { node: 0, table: [[1.0; 5]; MOST_WATCHED], bounds, clear: false }
    }
}

/// What three nodes cannot show is taken to be at most this often the highest term of their quadratic.
const UNSEEN: f64 = 4.0;

/// True where the quadratic through nodes 0, 2 and 4 stays above zero by more than what it cannot show.
fn far_from_zero(row: &[f64; 5]) -> bool {
    let (start, middle, end) = (row[0], row[2], row[4]);
    let highest = 0.25 * (start - 2.0 * middle + end);
    let control = 2.0 * middle - 0.5 * (start + end);
    start.min(control).min(end) > UNSEEN * highest.abs()
}

/// Steps along a grazing obstacle after which it counts as met.
const MOST_GRAZING_STEPS: u32 = 1000;
/// Steps to an event after which it is taken where it is.
const MOST_STEPS_TO_EVENT: u32 = 7;
/// Secants on the dense output after which a step is made to where they have come.
const MOST_SECANTS: u32 = 8;
/// A fraction of a step by which an interpolant does not mistake the place of an event.
const MOST_ASTRAY: f64 = 0.02;
/// Times below this, in the world's own units, are too short for the curvature of a motion to count.
const CURVELESS: f64 = 1e-8;
/// A quantity leaves zero downwards where its first rate is below this fraction of its largest, negative: the rest is rounding.
const DOWNWARD: f64 = 1e-6;
/// Halvings of a step after which an event function that stays positive at its nodes is taken as positive.
const MOST_HALVINGS: u32 = 12;

impl<const B: usize> Walker<'_, B> {
    /// The first event within a step.
    pub(super) fn event_in(&mut self, tried: &Step<Vector<B>>, list: &WatchList) -> Option<Found> {
        let Notes { table, bounds, clear, .. } = self.table(tried, 0.0, 1.0, list);
        let falls = if clear { None } else { self.first_fall(tried, list, &table, (0.0, 1.0), 0) };
        let watched = falls.map(|(x, w)| self.placed(tried, Event::Watched(w), x));
        let until = watched.as_ref().map_or(1.0, |found| found.length / tried.length);
        match self.first_meeting(tried, until, &bounds) {
            Some((x, pair)) => Some(self.placed(tried, Event::Meets(pair), x)),
            None => watched,
        }
    }

    /// Event functions at one place of a step, noted in a column of the table, and what they say of the bounds.
    fn look(&mut self, tried: &Step<Vector<B>>, at: f64, list: &WatchList, note: &mut Notes<B>) {
        let (time, states) = (self.time + at * tried.length, unpack(&tried.at(at)));
        let known = self.end_forces.filter(|_| at == 1.0);
        let forces = known.unwrap_or_else(|| {
            self.effort.evaluations += 1;
            self.world.forces(&self.held, &states)
        });
        let snapshot = Snapshot::of_forces(&self.world, &self.scales, forces, time, &states);
        for (row, w) in note.table.iter_mut().zip(list.iter()) {
            row[note.node] = snapshot.value(w);
        }
        for ((bounds, acceleration), state) in
            note.bounds.iter_mut().zip(snapshot.forces.acceleration).zip(&states)
        {
            bounds.acceleration = bounds.acceleration.max(acceleration.linear.norm());
            bounds.angular = bounds.angular.max(acceleration.angular.abs());
            bounds.spin = bounds.spin.max(state.twist.spin.abs());
            bounds.speed = bounds.speed.max(state.twist.velocity.norm());
        }
    }

    /// Event functions at the nodes of the part [a, b] of a step, and bounds on the motion there. The two nodes between the middle and the
    /// ends are left out where the other three show that nothing comes near zero.
    fn table(&mut self, tried: &Step<Vector<B>>, a: f64, b: f64, list: &WatchList) -> Notes<B> {
        let mut note = Notes::new(tried.length);
        let known = self.last_look.filter(|l| a == 0.0 && l.time == self.time);
        if let Some(last) = known {
            last.into_notes(&mut note);
        }
        for node in if known.is_some() { &[2, 4][..] } else { &[0, 2, 4] } {
            note.node = *node;
            self.look(tried, a + (b - a) * NODES[*node], list, &mut note);
        }
        if b == 1.0 {
            self.last_look = Some(Look::at_end(&note, self.time + tried.length));
        }
        let begin = self.time + a * tried.length;
        let leaves_here = |w: &Watched| w.leaving.is_some_and(|l| begin - l.since <= 1e-3 * tried.length);
        let leaves = list.iter().any(leaves_here);
        note.clear = !leaves && note.table.iter().zip(list.iter()).all(|(row, _)| far_from_zero(row));
        if !note.clear {
            for node in [1, 3] {
                note.node = node;
                self.look(tried, a + (b - a) * NODES[node], list, &mut note);
            }
        }
        for (row, w) in note.table.iter_mut().zip(list.iter()) {
            if leaves_here(w) {
                // 0/0 at the very start: the cubic through the other nodes continues it.
                row[0] = extrapolated(row);
            }
        }
        // The nodes are samples: leave room between them.
        let gravity = self.world.gravity.norm();
        for bounds in &mut note.bounds {
            bounds.acceleration = 1.5 * bounds.acceleration + 0.1 * gravity;
            bounds.angular = 1.5 * bounds.angular + 0.1 * gravity / self.scales.length;
            bounds.spin += bounds.angular * tried.length;
            bounds.speed += bounds.acceleration * tried.length;
        }
        note
    }

    /// The first place in [a, b] where an event function falls through zero.
    fn first_fall(
        &mut self,
        tried: &Step<Vector<B>>,
        list: &WatchList,
        table: &Table,
        (a, b): (f64, f64),
        depth: u32,
    ) -> Option<(f64, Watched)> {
        let mut doubtful = false;
        let mut found: Option<(f64, Watched)> = None;
        for (values, w) in table.iter().zip(list.iter()) {
            if !values.iter().all(|v| v.is_finite()) {
                // An interval so short that its nodes are one instant.
                continue;
            }
            let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            if w.leaving.is_some() && values[0] < -DOWNWARD * largest {
                // It leaves zero downwards: the event is here.
                found = Some((a, *w));
                continue;
            }
            let quartic = Quartic::through(values);
            // What five nodes cannot show is taken to be at most the interpolant's own highest term.
            if quartic.lower_bound() > quartic.highest {
                continue;
            }
            let resolved = quartic.highest <= 1e-3 * largest;
            doubtful |= !resolved && depth < MOST_HALVINGS;
            if let Some(x) = quartic.first_fall() {
                let at = a + (b - a) * x;
                if found.is_none_or(|(f, _)| at < f) {
                    found = Some((at, *w));
                }
            }
        }
        if !doubtful {
            return found;
        }
        let middle = 0.5 * (a + b);
        let mut half = |from: f64, to: f64| {
            let note = self.table(tried, from, to, list);
            if note.clear { None } else { self.first_fall(tried, list, &note.table, (from, to), depth + 1) }
        };
        half(a, middle).or_else(|| half(middle, b))
    }

    /// The first place before `until` where an obstacle that is not touched is met.
    fn first_meeting(
        &self,
        tried: &Step<Vector<B>>,
        until: f64,
        bounds: &[Bounds; B],
    ) -> Option<(f64, Pairing)> {
        let mut first: Option<(f64, Pairing)> = None;
        for (body, bounds) in bounds.iter().enumerate().take(self.world.bodies.len()) {
            for obstacle in 0..self.world.obstacles.len() {
                if !self.held.iter().any(|h| h.pair.meeting() == (body, obstacle)) {
                    let end = first.map_or(until, |(x, _)| x);
                    first = self.march_on(tried, end, (body, obstacle), bounds).or(first);
                }
            }
        }
        first
    }

    /// The place before `end` where a body meets an obstacle.
    fn march_on(
        &self,
        tried: &Step<Vector<B>>,
        end: f64,
        meeting: (usize, usize),
        bounds: &Bounds,
    ) -> Option<(f64, Pairing)> {
        let known = self.known();
        // Pairs that have just opened have event functions of their own.
        let mut open = Few::default();
        for pair in self.departing.iter().filter(|p| p.meeting() == meeting) {
            open.push(Open { pair: *pair, time: f64::INFINITY });
        }
        let (mut x, mut steps) = (0.0, 0);
        while x < end {
            let states = unpack(&tried.at(x));
            let state = &states[meeting.0];
            let bounds = Bounds { horizon: (end - x) * tried.length, ..*bounds };
            let apart = self.world.apart(state, meeting, &bounds, &Leniency::default());
            steps += 1;
            if apart.distance > MET * self.scales.length {
                x += (apart.safe / tried.length).max(1e-13);
                continue;
            }
            // What grazes for long counts as met: the rate problem says whether it is held.
            let watched = |pair: &Pairing| self.departing.iter().any(|d| d == pair);
            let lingers = || self.world.nearest(&states, meeting).filter(|_| steps > MOST_GRAZING_STEPS);
            let closes = self.world.closing(&states, meeting, &known).iter().copied().find(|p| !watched(p));
            if let Some(pair) = closes.or_else(|| lingers().filter(|p| !watched(p))) {
                return Some((x, pair));
            }
            let allowance = 2.0 * MET * self.scales.length + (-apart.distance).max(0.0);
            let lenient = Leniency { allowance, open };
            let free = self.world.apart(state, meeting, &bounds, &lenient);
            x += (free.safe.max(1e-12 * self.scales.time) / tried.length).max(1e-15);
        }
        None
    }

    /// Steps TO the event: a step is made that ends where the dense output has it, and what is left of the event function is
    /// taken away by a shift along the motion, too short for its curvature to count.
    pub(super) fn polish(&mut self, tried: &Step<Vector<B>>, found: &Found) -> Reached<B> {
        let (mut length, mut slope) = (found.length.max(1e-15 * self.scales.time), found.slope);
        let mut before: Option<(f64, f64)> = None;
        let mut trial = self.step_to(tried, length);
        for _ in 0..MOST_STEPS_TO_EVENT {
            let value = self.event_value(&found.event, self.time + length, &unpack(&trial.end));
            if let Some((at, was)) = before.filter(|(at, _)| *at != length) {
                slope = (value - was) / (length - at);
            }
            let correction = -value / slope;
            if !correction.is_finite() || correction.abs() <= 1e-16 * (self.time + length) {
                break;
            }
            if correction.abs() <= CURVELESS * self.scales.time {
                return self.shifted(&trial, correction);
            }
            before = Some((length, value));
            length = (length + correction).clamp(0.0, 1.5 * tried.length);
            trial = self.step_to(tried, length);
        }
        Reached { length, state: trial.end }
    }

    /// Where the event function is zero on the dense output, near the fraction `seen` of the step where its interpolant is.
    fn placed(&mut self, tried: &Step<Vector<B>>, event: Event, seen: f64) -> Found {
        let mut x = seen;
        let mut value = self.value_on(tried, &event, x);
        let mut other = if x > 1e-4 { x - 1e-4 } else { x + 1e-4 };
        let mut other_value = self.value_on(tried, &event, other);
        let mut slope = (other_value - value) / (other - x);
        for _ in 0..MOST_SECANTS {
            let next = (x - value / slope).clamp(0.0, 1.0);
            let done = !next.is_finite() || (next - x).abs() <= 1e-12 || (next - seen).abs() > MOST_ASTRAY;
            if done {
                break;
            }
            (other, other_value, x) = (x, value, next);
            value = self.value_on(tried, &event, x);
            slope = (other_value - value) / (other - x);
        }
        Found { length: x * tried.length, slope: slope / tried.length, event }
    }

    fn value_on(&mut self, tried: &Step<Vector<B>>, event: &Event, x: f64) -> f64 {
        self.effort.evaluations += 1;
        self.event_value(event, self.time + x * tried.length, &unpack(&tried.at(x)))
    }

    /// A step of `length` from where `tried` starts.
    fn step_to(&mut self, tried: &Step<Vector<B>>, length: f64) -> Trial<Vector<B>> {
        let (world, held) = (&*self.world, &self.held);
        self.effort.evaluations += EVALUATIONS_PLAIN;
        step_plain(tried.start, tried.start_rate, length, |y| rate(y, &world.accelerate(held, &unpack(y))))
    }

    /// The end of a step, moved by a very short time along the motion there.
    fn shifted(&mut self, trial: &Trial<Vector<B>>, by: f64) -> Reached<B> {
        self.effort.evaluations += 1;
        let along = rate(&trial.end, &self.world.accelerate(&self.held, &unpack(&trial.end)));
        let state = std::array::from_fn(|b| std::array::from_fn(|i| trial.end[b][i] + by * along[b][i]));
        Reached { length: trial.length + by, state }
    }

    fn event_value(&self, event: &Event, time: f64, states: &[State; B]) -> f64 {
        match event {
            Event::Watched(w) => Snapshot::new(&self.world, &self.scales, &self.held, time, states).value(w),
            Event::Meets(pair) => self.world.kinematics(states, *pair).gap / self.scales.length,
        }
    }
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
