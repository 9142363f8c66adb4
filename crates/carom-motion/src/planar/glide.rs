//! Motion with contacts held: integration, its events, and what follows them.

use super::collide::Closed;
use super::flight::{Known, MET};
use super::kinematics::{Pairing, Turn};
use super::mode::{Forces, Held};
use super::observer::Observer;
use super::question::Asked;
use super::separation::{Bounds, Leniency};
use super::touching::Few;
use super::trace::{ContactSample, HeldContact, PieceEnd};
use super::walker::{Happening, MotionError, STILL, Walker};
use super::watch::{MOST_WATCHED, Watch, WatchList, Watched};
use super::{Pose, State, Twist};
use carom_impact::planar::Slip;
use carom_num::Vec2;
use carom_num::ode::{EVALUATIONS, Step, length_factor, step};
use carom_num::poly::{NODES, Quartic};

type Vector = [f64; 6];

fn pack(s: &State) -> Vector {
    let (c, v) = (s.pose.centre, s.twist.velocity);
    [c.x, c.y, s.pose.angle, v.x, v.y, s.twist.spin]
}

fn unpack(y: &Vector) -> State {
    State {
        pose: Pose { centre: Vec2::new(y[0], y[1]), angle: y[2] },
        twist: Twist { velocity: Vec2::new(y[3], y[4]), spin: y[5] },
    }
}

fn rate(y: &Vector, forces: &Forces) -> Vector {
    let a = forces.acceleration;
    [y[3], y[4], y[5], a.linear.x, a.linear.y, a.angular]
}

/// What ends a piece of a mode.
#[derive(Clone, Copy, Debug)]
enum Event {
    /// An event function of the mode came to zero.
    Watched(Watched),
    /// A pair of another obstacle closed.
    Meets(Pairing),
}

/// An event within a step: where, as a length from the step's start.
#[derive(Clone, Copy, Debug)]
struct Found {
    length: f64,
    event: Event,
}

/// Values of all event functions at the five nodes of an interval.
type Table = [[f64; 5]; MOST_WATCHED];

/// Steps along a grazing obstacle after which it counts as met.
const MOST_GRAZING_STEPS: u32 = 1000;
/// Halvings of a step after which an event function that stays positive at its nodes is taken as positive.
const MOST_HALVINGS: u32 = 12;

impl Walker<'_> {
    /// Moves with the present contacts held until an event, and resolves it.
    pub(super) fn glide<O: Observer>(&mut self, observer: &mut O) -> Result<Happening, MotionError> {
        let (start_time, start) = (self.time, self.state);
        observer.starts(self.time, &self.state, &mut self.held());
        self.report_slips(observer);
        let mut list = self.watch_list();
        let mut y = pack(&self.state);
        let mut f = self.rate_of(&y);
        if O::DENSE {
            self.sample(&unpack(&y), observer);
        }
        let mut length = if self.last_step > 0.0 { self.last_step } else { 0.05 * self.scales.time };
        loop {
            if self.time >= self.options.most_time {
                self.state = unpack(&y);
                self.report_piece(start_time, start, PieceEnd::TimeUp, observer);
                return Ok(Happening::BudgetSpent);
            }
            let (tried, next) = match self.accepted_step(y, f, length) {
                // The normal force grows without bound (Painlevé's paradox): an impact stops the slip.
                Err(MotionError::StepTooSmall { .. }) if self.slips() => {
                    return self.jam_dynamically(start_time, start, observer);
                }
                other => other?,
            };
            if let Some(found) = self.event_in(&tried, &list) {
                let (end, event) = self.polish(&tried, found);
                let begin = self.time;
                if O::DENSE {
                    self.sample_step(&tried, end.length / tried.length, observer);
                }
                self.time = begin + end.length;
                self.state = self.projected(&unpack(&end.end));
                if O::DENSE {
                    self.sample(&self.state, observer);
                }
                self.report_slips(observer);
                self.report_piece(start_time, start, self.piece_end(&event), observer);
                return self.resolve(&event, observer);
            }
            if O::DENSE {
                self.sample_step(&tried, 1.0, observer);
            }
            self.time += tried.length;
            let state = self.projected(&unpack(&tried.end));
            y = pack(&state);
            f = tried.end_rate;
            length = next;
            self.state = state;
            self.report_slips(observer);
            if self.forget_left(&state) {
                list = self.watch_list();
            }
        }
    }

    fn slips(&self) -> bool {
        self.held.iter().any(|h| h.slip != Slip::Sticks)
    }

    fn jam_dynamically<O: Observer>(
        &mut self,
        start_time: f64,
        start: State,
        observer: &mut O,
    ) -> Result<Happening, MotionError> {
        let edge = Event::Watched(Watched { what: Watch::Regular, leaving: None });
        self.report_piece(start_time, start, self.piece_end(&edge), observer);
        self.resolve(&edge, observer)
    }

    fn report_slips<O: Observer>(&self, observer: &mut O) {
        if O::SLIPS {
            let turn = Turn::of(&self.state);
            for h in self.held.iter().filter(|h| h.slip != Slip::Sticks) {
                observer.slips(
                    h.pair.obstacle,
                    self.world.kinematics_turned(&self.state, turn, h.pair).slip.abs(),
                );
            }
        }
    }

    fn watch_list(&self) -> WatchList {
        let forces = self.world.forces(&self.held, &self.state);
        WatchList::of(self.world, self.time, &self.state, &forces, &self.departing)
    }

    fn rate_of(&mut self, y: &Vector) -> Vector {
        self.effort.evaluations += 1;
        rate(y, &self.world.forces(&self.held, &unpack(y)))
    }

    /// A step whose error is within tolerance, and the length to try next.
    fn accepted_step(
        &mut self,
        y: Vector,
        f: Vector,
        mut length: f64,
    ) -> Result<(Step<6>, f64), MotionError> {
        let (l, v, rtol) = (self.scales.length, self.scales.speed, self.options.tolerance);
        let speed = v.max(self.state.twist.velocity.norm());
        let spin = (speed / l).max(self.state.twist.spin.abs());
        let tolerance = [rtol * l, rtol * l, rtol, rtol * speed, rtol * speed, rtol * spin];
        loop {
            let (world, held) = (self.world, &self.held);
            let tried = step(y, f, length, |y| rate(y, &world.forces(held, &unpack(y))));
            self.effort.evaluations += EVALUATIONS;
            let error = tried.scaled_error(&tolerance);
            if error <= 1.0 {
                self.effort.steps += 1;
                return Ok((tried, length * length_factor(error)));
            }
            if !error.is_finite()
                && !tried.end.iter().all(|v| v.is_finite())
                && length < 1e-12 * self.scales.time
            {
                return Err(MotionError::NotFinite { time: self.time });
            }
            length *= if error.is_finite() { length_factor(error).min(0.9) } else { 0.2 };
            if length < 1e-14 * self.scales.time {
                return Err(MotionError::StepTooSmall { time: self.time, step: length });
            }
        }
    }

    /// The first event within a step.
    fn event_in(&mut self, tried: &Step<6>, list: &WatchList) -> Option<Found> {
        let (table, bounds) = self.table(tried, 0.0, 1.0, list);
        let watched = self.first_fall(tried, list, &table, (0.0, 1.0), 0);
        let until = watched.map_or(1.0, |(x, _)| x);
        let meets = self.first_meeting(tried, until, &bounds);
        match (meets, watched) {
            (Some((x, pair)), _) => Some(Found { length: x * tried.length, event: Event::Meets(pair) }),
            (None, Some((x, w))) => Some(Found { length: x * tried.length, event: Event::Watched(w) }),
            (None, None) => None,
        }
    }

    /// Event functions at the nodes of the part [a, b] of a step, and bounds on the motion there.
    fn table(&mut self, tried: &Step<6>, a: f64, b: f64, list: &WatchList) -> (Table, Bounds) {
        let mut table = [[1.0; 5]; MOST_WATCHED];
        let mut bounds = Bounds {
            horizon: tried.length,
            acceleration: 0.0,
            angular: 0.0,
            spin: 0.0,
            speed: 0.0,
            steady: None,
        };
        for (node, x) in NODES.iter().enumerate() {
            let at = a + (b - a) * x;
            let state = unpack(&tried.at(at));
            let forces = self.world.forces(&self.held, &state);
            self.effort.evaluations += u64::from(at > 0.0 && at < 1.0);
            let time = self.time + at * tried.length;
            for (row, w) in table.iter_mut().zip(list.iter()) {
                row[node] = self.world.watch(w, time, &state, &forces, &self.scales);
            }
            bounds.acceleration = bounds.acceleration.max(forces.acceleration.linear.norm());
            bounds.angular = bounds.angular.max(forces.acceleration.angular.abs());
            bounds.spin = bounds.spin.max(state.twist.spin.abs());
            bounds.speed = bounds.speed.max(state.twist.velocity.norm());
        }
        for (row, w) in table.iter_mut().zip(list.iter()) {
            let leaves_here =
                w.leaving.is_some_and(|l| self.time + a * tried.length - l.since <= 1e-3 * tried.length);
            if leaves_here {
                // 0/0 at the very start: the cubic through the other nodes continues it.
                row[0] = extrapolated(row);
            }
        }
        // The nodes are samples: leave room between them.
        bounds.acceleration = 1.5 * bounds.acceleration + 0.1 * self.world.gravity.norm();
        bounds.angular = 1.5 * bounds.angular + 0.1 * self.world.gravity.norm() / self.scales.length;
        bounds.spin += bounds.angular * tried.length;
        bounds.speed += bounds.acceleration * tried.length;
        (table, bounds)
    }

    /// The first place in [a, b] where an event function falls through zero.
    fn first_fall(
        &mut self,
        tried: &Step<6>,
        list: &WatchList,
        table: &Table,
        (a, b): (f64, f64),
        depth: u32,
    ) -> Option<(f64, Watched)> {
        let mut doubtful = false;
        let mut found: Option<(f64, Watched)> = None;
        for (values, w) in table.iter().zip(list.iter()) {
            let quartic = Quartic::through(values);
            // What five nodes cannot show is taken to be at most the interpolant's own highest term.
            if quartic.lower_bound() > quartic.highest {
                continue;
            }
            let resolved = quartic.highest <= 1e-3 * values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
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
        let (left, _) = self.table(tried, a, middle, list);
        self.first_fall(tried, list, &left, (a, middle), depth + 1).or_else(|| {
            let (right, _) = self.table(tried, middle, b, list);
            self.first_fall(tried, list, &right, (middle, b), depth + 1)
        })
    }

    /// The first place before `until` where an obstacle that is not touched is met.
    fn first_meeting(&self, tried: &Step<6>, until: f64, bounds: &Bounds) -> Option<(f64, Pairing)> {
        let known = Known { departing: &self.departing, sides: &self.sides, scales: self.scales };
        let mut first: Option<(f64, Pairing)> = None;
        for obstacle in 0..self.world.obstacles.len() {
            let touched = self.held.iter().any(|h| h.pair.obstacle == obstacle)
                || self.departing.iter().any(|d| d.obstacle == obstacle);
            if touched {
                continue;
            }
            let end = first.map_or(until, |(x, _)| x);
            let mut x = 0.0;
            for steps in 0.. {
                if x >= end {
                    break;
                }
                let state = unpack(&tried.at(x));
                let horizon = (end - x) * tried.length;
                let bounds = Bounds { horizon, ..*bounds };
                let apart = self.world.apart(&state, obstacle, &bounds, &Leniency::default());
                if apart.distance > MET * self.scales.length {
                    x += (apart.safe / tried.length).max(1e-13);
                    continue;
                }
                // What grazes for long counts as met: the rate problem says whether it is held.
                let lingers = || self.world.nearest(&state, obstacle).filter(|_| steps > MOST_GRAZING_STEPS);
                if let Some(pair) = self.world.closing(&state, obstacle, &known).or_else(lingers) {
                    first = Some((x, pair));
                    break;
                }
                let allowance = 2.0 * MET * self.scales.length + (-apart.distance).max(0.0);
                let lenient = Leniency { allowance, open: Few::default() };
                let free = self.world.apart(&state, obstacle, &bounds, &lenient);
                x += (free.safe.max(1e-12 * self.scales.time) / tried.length).max(1e-15);
            }
        }
        first
    }

    /// Steps TO the event from the step's start, correcting the length until the event function is zero.
    fn polish(&mut self, tried: &Step<6>, found: Found) -> (Step<6>, Event) {
        let mut length = found.length.max(1e-15 * self.scales.time);
        let (mut before, mut best) = (None::<(f64, f64)>, None::<(f64, Step<6>)>);
        for _ in 0..8 {
            let (world, held) = (self.world, &self.held);
            let again = step(tried.start, self.first_rate(tried), length, |y| {
                rate(y, &world.forces(held, &unpack(y)))
            });
            self.effort.evaluations += EVALUATIONS;
            let value = self.event_value(&found.event, self.time + length, &unpack(&again.end));
            if best.as_ref().is_none_or(|(v, _)| value.abs() < v.abs()) {
                best = Some((value, again));
            }
            let slope = match before {
                Some((l, v)) if l != length => (value - v) / (length - l),
                _ => self.slope(tried, &found),
            };
            let correction = -value / slope;
            if value.abs() <= 1e-15
                || !correction.is_finite()
                || correction.abs() <= 1e-15 * (self.time + length)
            {
                break;
            }
            before = Some((length, value));
            length = (length + correction).clamp(0.0, 1.5 * tried.length);
        }
        (best.map_or(*tried, |(_, s)| s), found.event)
    }

    fn first_rate(&self, tried: &Step<6>) -> Vector {
        rate(&tried.start, &self.world.forces(&self.held, &unpack(&tried.start)))
    }

    fn event_value(&self, event: &Event, time: f64, state: &State) -> f64 {
        match event {
            Event::Watched(w) => {
                self.world.watch(w, time, state, &self.world.forces(&self.held, state), &self.scales)
            }
            Event::Meets(pair) => self.world.kinematics(state, *pair).gap / self.scales.length,
        }
    }

    /// Slope of an event function at its place, from the dense output.
    fn slope(&self, tried: &Step<6>, found: &Found) -> f64 {
        let x = found.length / tried.length;
        let d = 1e-4;
        let (low, high) = ((x - d).max(0.0), (x + d).min(1.0));
        let at = |x: f64| self.event_value(&found.event, self.time + x * tried.length, &unpack(&tried.at(x)));
        (at(high) - at(low)) / ((high - low) * tried.length)
    }

    /// Drops pairs that have clearly opened; true where that changes what is watched.
    fn forget_left(&mut self, state: &State) -> bool {
        let before = self.departing.len();
        let (world, clear) = (self.world, 1e-5 * self.scales.length);
        self.departing.retain(|pair| world.kinematics(state, *pair).gap < clear);
        self.departing.len() != before
    }

    fn piece_end(&self, event: &Event) -> PieceEnd {
        let held = |i: usize| {
            self.held.iter().nth(i).map(|h| HeldContact {
                obstacle: h.pair.obstacle,
                feature: h.pair.feature,
                slip: h.slip,
            })
        };
        let closes = |pair: Pairing| PieceEnd::Closes { obstacle: pair.obstacle, feature: pair.feature };
        match event {
            Event::Meets(pair) => closes(*pair),
            Event::Watched(w) => match w.what {
                Watch::Force(i) => held(i).map_or(PieceEnd::TimeUp, PieceEnd::ForceZero),
                Watch::Slip(i) => held(i).map_or(PieceEnd::TimeUp, PieceEnd::SlipZero),
                Watch::Cone(i, _) => held(i).map_or(PieceEnd::TimeUp, PieceEnd::StickLimit),
                Watch::Extent(i, _) => held(i).map_or(PieceEnd::TimeUp, PieceEnd::RunsOff),
                Watch::Parallel(i, _) => held(i).map_or(PieceEnd::TimeUp, |h| PieceEnd::Closes {
                    obstacle: h.obstacle,
                    feature: h.feature,
                }),
                Watch::Gap(pair) => closes(pair),
                Watch::Regular => held(0).map_or(PieceEnd::TimeUp, PieceEnd::PainleveEdge),
            },
        }
    }

    /// What an event brings.
    fn resolve<O: Observer>(&mut self, event: &Event, observer: &mut O) -> Result<Happening, MotionError> {
        let mut asked = self.asked();
        let watched = match event {
            Event::Meets(pair) => {
                return self.collide_here(&Closed { named: Some(*pair), ..Closed::default() }, observer);
            }
            Event::Watched(w) => w,
        };
        let nth = |asked: &Few<Asked>, i: usize| asked.iter().nth(i).map(|a| a.pair);
        match watched.what {
            Watch::Force(i) => {
                if let Some(pair) = nth(&asked, i) {
                    asked.retain(|a| a.pair != pair);
                    self.depart(pair);
                }
                self.settle(&asked, observer)
            }
            Watch::Slip(i) => {
                for (j, a) in asked.iter_mut().enumerate() {
                    if i == j || a.slip.abs() <= 10.0 * STILL * self.scales.speed {
                        a.slip = 0.0;
                    }
                }
                self.settle(&asked, observer)
            }
            Watch::Cone(i, forward) => {
                if let Some(a) = asked.iter_mut().nth(i) {
                    // Friction along +t is used up: the contact slips along −t.
                    a.known = Some(if forward { Slip::Backward } else { Slip::Forward });
                }
                self.settle(&asked, observer)
            }
            Watch::Extent(i, _) => self.hand_over(nth(&asked, i), observer),
            Watch::Parallel(i, slot) => {
                let turn = Turn::of(&self.state);
                let sine = nth(&asked, i).map_or(0.0, |pair| self.world.parallel(turn, pair, slot));
                self.collide_here(&Closed { sine: sine.abs(), ..Closed::default() }, observer)
            }
            Watch::Gap(pair) => {
                self.collide_here(&Closed { named: Some(pair), ..Closed::default() }, observer)
            }
            Watch::Regular => self.force(&asked, observer),
        }
    }

    fn sample_step<O: Observer>(&self, tried: &Step<6>, part: f64, observer: &mut O) {
        let span = part * tried.length;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to a small count"
        )]
        let count = (span / (0.02 * self.scales.time)).ceil().clamp(1.0, 200.0) as u32;
        let last = if part < 1.0 { count - 1 } else { count };
        for i in 1..=last {
            let x = part * f64::from(i) / f64::from(count);
            let state = self.projected(&unpack(&tried.at(x)));
            self.sample_at(self.time + x * tried.length, &state, observer);
        }
    }

    fn sample<O: Observer>(&self, state: &State, observer: &mut O) {
        self.sample_at(self.time, state, observer);
    }

    fn sample_at<O: Observer>(&self, time: f64, state: &State, observer: &mut O) {
        let forces = self.world.forces(&self.held, state);
        let mut contacts = forces.contacts.iter().map(|c| ContactSample {
            obstacle: c.held.pair.obstacle,
            feature: c.held.pair.feature,
            point: state.pose.centre + c.kinematics.arm,
            normal: c.kinematics.normal,
            normal_force: c.normal_force,
            tangential_force: c.tangential_force,
            slip: c.kinematics.slip,
        });
        observer.sample(time, state, &mut contacts);
    }

    /// The contacts held, for the outside.
    pub(super) fn held_pairs(&self) -> impl Iterator<Item = &Held> {
        self.held.iter()
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
