//! Free flight of one body in closed form, and its first touch.

use super::collide::Closed;
use super::path::Course;
use super::terms::Happening;
use super::walker::Walker;
use crate::MotionError;
use crate::planar::contact::{
    World,
    bounds::Bounds,
    kinematics::{Pairing, turns},
    separation::{Leniency, Open},
    touching::{Few, Search},
    world::Scales,
};
use crate::planar::geometry::State;
use crate::planar::record::{
    observer::{Observers, is_dense},
    trace::PieceEnd,
};
use crate::tolerance::{
    INSTANT, MET_GAP, NEWTON_ASTRAY, NEWTON_DONE, STEP_PAST_TOUCH, STILL_SPEED, TOUCHING_GAP,
};

/// A pair of features that meets, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::planar) struct Touchdown {
    pub(in crate::planar) time: f64,
    pub(in crate::planar) pair: Pairing,
}

/// What is known of the contacts at the start of a flight.
pub(in crate::planar) struct Known<'a> {
    pub(in crate::planar) departing: &'a Few<Pairing>,
    pub(in crate::planar) sides: &'a [bool],
    pub(in crate::planar) scales: Scales,
    /// Derivatives below this, in the world's own units, count as zero.
    pub(in crate::planar) significant: f64,
}

/// A flight that is likely to end where it began within this many of the world's own times is a hop.
const HOP: f64 = 1.0;
/// Steps of a march towards what may be met after which what has touched all along counts as met, and what has been hardly apart takes longer steps:
/// one that is not grazed takes tens.
pub(in crate::planar) const MOST_STEPS: u32 = 4000;
/// The least step doubles after each so many more.
const STEPS_A_DOUBLING: u32 = 500;

/// Steps after which a march takes long.
const MANY_STEPS: u32 = 64;

/// A march that takes long.
struct TakesLong;

/// By how much the least step of a march has grown after so many steps: it stays a small part of the time that the march has taken.
pub(in crate::planar) fn growth(steps: u32) -> f64 {
    let doublings = steps.saturating_sub(MOST_STEPS) / STEPS_A_DOUBLING;
    (0..doublings).fold(1.0, |grown, _| 2.0 * grown)
}

impl World {
    /// After this long in flight nothing can be met any more [s]; infinite without gravity.
    pub(in crate::planar) fn leaves_after(&self, state: &State) -> f64 {
        let g = self.gravity.norm();
        if g == 0.0 {
            return f64::INFINITY;
        }
        let down = self.gravity / g;
        let lowest = self
            .obstacles
            .iter()
            .flat_map(|o| o.shape().hull().vertices().iter().map(move |v| *v + down * o.shape().radius()))
            .map(|p| down.dot(p))
            .fold(f64::NEG_INFINITY, f64::max);
        let drop = lowest + 1.001 * self.bodies[0].shape.size() - down.dot(state.pose.centre);
        let fall = down.dot(state.twist.velocity);
        if drop <= 0.0 && fall >= 0.0 {
            return 0.0;
        }
        let root = (fall * fall + 2.0 * g * drop.max(0.0)).sqrt();
        (root - fall) / g
    }

    /// The first touch of a flight within `horizon` [s]. Pairs that have just opened are looked at again once a Taylor bound shows that
    /// they have left zero.
    pub(in crate::planar) fn first_touch(
        &self,
        start: &State,
        known: &Known<'_>,
        horizon: f64,
    ) -> Option<Touchdown> {
        let path = Ballistic { world: self, start, known };
        let mut first: Option<Touchdown> = None;
        let until = |first: &Option<Touchdown>| first.map_or(horizon, |f| f.time);
        // What it has just left is hardly what it meets first, unless it hops: what is likely met first is asked first, the others up to there.
        let left = |obstacle: usize| known.departing.iter().any(|d| d.obstacle == obstacle);
        let hops = known.departing.iter().any(|pair| self.hop(start, *pair, known) < HOP * known.scales.time);
        let obstacles = || 0..self.obstacles.len();
        // One that takes long is left until the others have been asked: behind a wall, where nothing comes, it would be marched through for nothing.
        let mut long: Few<usize> = Few::default();
        let order = obstacles().filter(|o| left(*o) == hops).chain(obstacles().filter(|o| left(*o) != hops));
        for obstacle in order {
            match path.march(obstacle, until(&first), MANY_STEPS) {
                Ok(touch) => first = touch.or(first),
                Err(TakesLong) if long.push(obstacle) => {}
                Err(TakesLong) => first = path.march_however_long(obstacle, until(&first)).or(first),
            }
        }
        for obstacle in long.iter() {
            first = path.march_however_long(*obstacle, until(&first)).or(first);
        }
        first
    }

    /// How long a pair that has just opened would stay open if its gap were a parabola [s]. A pair that opens at no speed has been let go.
    fn hop(&self, start: &State, pair: Pairing, known: &Known<'_>) -> f64 {
        let k = self.kinematics(std::array::from_ref(start), pair);
        let bend = k.normal_bias + k.normal.dot(self.gravity);
        let hops = k.approach > STILL_SPEED * known.scales.speed && bend < 0.0;
        if hops { -2.0 * k.approach / bend } else { f64::INFINITY }
    }
}

/// A flight as a path to march along.
struct Ballistic<'a> {
    world: &'a World,
    start: &'a State,
    known: &'a Known<'a>,
}

impl Ballistic<'_> {
    fn at(&self, t: f64) -> State {
        self.start.flown(self.world.gravity, t)
    }

    /// As [`Ballistic::march`], however long it takes.
    fn march_however_long(&self, obstacle: usize, until: f64) -> Option<Touchdown> {
        self.march(obstacle, until, u32::MAX).ok().flatten()
    }

    /// Steps safely towards an obstacle until it is met or time is up.
    ///
    /// # Errors
    /// [`TakesLong`] where that takes more than `most` steps.
    fn march(&self, obstacle: usize, until: f64, most: u32) -> Result<Option<Touchdown>, TakesLong> {
        let met = MET_GAP * self.known.scales.length;
        let left = self.world.side(self.known.sides, (0, obstacle));
        let mut t = 0.0;
        if until.is_finite()
            && self.world.out_of_reach(self.start, (0, obstacle), &self.bounds(self.start, until))
        {
            return Ok(None);
        }
        for steps in 0..most {
            if t >= until {
                return Ok(None);
            }
            let lengthened = self.known.scales.time * growth(steps);
            let state = self.at(t);
            let bounds =
                Bounds { left, ..self.bounds(&state, (until - t).min(4.0 * self.known.scales.time)) };
            let apart = |leniency: &Leniency| self.world.apart(&state, (0, obstacle), &bounds, leniency);
            let just_opened = steps == 0 && self.known.departing.iter().any(|d| d.obstacle == obstacle);
            let mut allowance = 2.0 * met;
            if !just_opened {
                let apart = apart(&Leniency::NONE);
                if apart.distance > met {
                    t += apart.safe.max(INSTANT * lengthened);
                    continue;
                }
                if steps > MOST_STEPS
                    && let Some(pair) = self.world.nearest(&[state], (0, obstacle), left)
                {
                    return Ok(Some(Touchdown { time: t, pair }));
                }
                let closing = self.world.closing(&[state], (0, obstacle), self.known);
                if !closing.is_empty() {
                    let touches = closing.iter().filter_map(|pair| self.polish(*pair, t, until));
                    return Ok(touches.min_by(|a, b| a.time.total_cmp(&b.time)));
                }
                allowance += (-apart.distance).max(0.0);
            }
            // What opens, or grazes, is left alone for as long as nothing overlaps by more than counts as met.
            let open = self.open(&state, obstacle, steps == 0);
            let mut leniency = Leniency { allowance, open };
            let mut free = apart(&leniency);
            if free.distance < -leniency.allowance {
                leniency.allowance -= free.distance;
                free = apart(&leniency);
            }
            t += free.safe.max(STEP_PAST_TOUCH * lengthened);
        }
        Err(TakesLong)
    }

    fn bounds(&self, state: &State, horizon: f64) -> Bounds {
        let gravity = self.world.gravity.norm();
        Bounds {
            horizon,
            acceleration: gravity,
            angular: 0.0,
            spin: state.twist.spin.abs(),
            speed: state.twist.velocity.norm() + gravity * horizon,
            steady: Some(self.world.gravity),
            left: None,
        }
    }

    /// For how long pairs in touch stay open, by the Taylor series of their gaps: those that have just opened, or those found.
    fn open(&self, state: &State, obstacle: usize, at_start: bool) -> Few<Open> {
        let mut out = Few::default();
        let mut add = |pair: Pairing| {
            let time = self.world.left_zero_after(state, pair, self.known);
            out.push(Open { pair, time });
        };
        if at_start {
            self.known.departing.iter().filter(|d| d.obstacle == obstacle).for_each(|d| add(*d));
        } else {
            self.world.in_reach(&[*state], (0, obstacle), self.known).iter().for_each(|pair| add(*pair));
        }
        out
    }

    /// Newton on the pair's own gap, with its second rate: near the top of a short hop the first alone overshoots.
    fn polish(&self, pair: Pairing, near: f64, until: f64) -> Option<Touchdown> {
        let mut t = near;
        for _ in 0..8 {
            let k = self.world.kinematics(&[self.at(t)], pair);
            let bend = k.normal_bias + k.normal.dot(self.world.gravity);
            let step = falling_root(k.gap, k.approach, bend);
            if !step.is_finite() || step.abs() > NEWTON_ASTRAY * self.known.scales.time {
                break;
            }
            t += step;
            if step.abs() <= NEWTON_DONE * self.known.scales.time {
                break;
            }
        }
        (t < until).then_some(Touchdown { time: t.max(0.0), pair })
    }
}

/// The root of `gap + rate τ + bend τ² / 2` at which it falls; where it does not reach zero, its top or its straight part's root.
pub(in crate::planar) fn falling_root(gap: f64, rate: f64, bend: f64) -> f64 {
    let inside = rate * rate - 2.0 * bend * gap;
    if inside < 0.0 {
        return if bend < 0.0 { -rate / bend } else { -gap / rate };
    }
    if rate <= 0.0 {
        2.0 * gap / (inside.sqrt() - rate)
    } else if bend < 0.0 {
        (rate + inside.sqrt()) / -bend
    } else {
        0.0
    }
}

impl World {
    /// The pairs of features of a body and what it meets that are in touch.
    fn in_reach<const B: usize>(
        &self,
        states: &[State; B],
        meeting: (usize, usize),
        known: &Known<'_>,
    ) -> Few<Pairing> {
        let (reach, still) = (TOUCHING_GAP * known.scales.length, STILL_SPEED * known.scales.speed);
        let search = Search { reach, deepest: reach, sides: known.sides, still, except: None };
        let mut pairs = Few::default();
        self.touching_one(states, &turns(states), meeting, &search, &mut pairs);
        if pairs.is_empty()
            && let Some(pair) = self.nearest(states, meeting, self.side(known.sides, meeting))
        {
            pairs.push(pair);
        }
        pairs
    }

    /// Of the pairs of a body and what it meets that are in touch those that close.
    pub(in crate::planar) fn closing<const B: usize>(
        &self,
        states: &[State; B],
        meeting: (usize, usize),
        known: &Known<'_>,
    ) -> Few<Pairing> {
        let mut pairs = self.in_reach(states, meeting, known);
        pairs.retain(|pair| self.kinematics(states, *pair).approach < -STILL_SPEED * known.scales.speed);
        pairs
    }
}

impl<const B: usize> Walker<'_, B> {
    pub(in crate::planar) fn known(&self) -> Known<'_> {
        let significant = self.options.significant();
        Known { departing: &self.departing, sides: &self.sides, scales: self.scales, significant }
    }

    /// Flies until something is met. Bodies that touch nothing, not even each other, fly each for itself: `B` is 1.
    pub(super) fn fly(&mut self, observers: &mut Observers<'_, B>) -> Result<Happening, MotionError> {
        let (start_time, start) = (self.time, self.states);
        self.report_start(observers);
        let budget = self.options.most_time - self.time;
        let leaves = self.world.leaves_after(&start[0]);
        let known = self.known();
        let touch = self.world.first_touch(&start[0], &known, leaves.min(budget));
        let (length, ended_by) = match touch {
            Some(t) => (t.time, PieceEnd::Closes { obstacle: t.pair.obstacle, feature: t.pair.feature }),
            None if leaves <= budget => (leaves, PieceEnd::FliesAway),
            None => (budget, PieceEnd::TimeUp),
        };
        if is_dense(observers) {
            self.sample_flight(length, observers);
        }
        let gravity = self.world.gravity;
        self.show_instants(length, |t| start.map(|state| state.flown(gravity, t)), observers);
        self.note_leg(length, || Course::Flight(start, gravity));
        self.time += length;
        self.states = start.map(|state| state.flown(self.world.gravity, length));
        self.report_piece(start_time, &start, |_| ended_by, observers);
        match touch {
            Some(t) => {
                // Whatever had opened before has been away for the whole flight: if it touches now, it closes.
                self.departing.clear();
                self.collide_here(&Closed { named: Some(t.pair), ..Closed::default() }, observers)
            }
            None if leaves <= budget => Ok(Happening::FliesAway),
            None => {
                let states = self.states;
                self.forget_left(&states);
                Ok(Happening::BudgetSpent)
            }
        }
    }

    fn sample_flight(&self, length: f64, observers: &mut Observers<'_, B>) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to a small count"
        )]
        let count = (length / (0.05 * self.scales.time)).ceil().clamp(4.0, 200.0) as u32;
        for i in 0..=count {
            let t = length * f64::from(i) / f64::from(count);
            for (observer, state) in observers.iter_mut().zip(&self.states) {
                let Some(observer) = observer else { continue };
                let flown = state.flown(self.world.gravity, t);
                observer.sample(self.time + t, &flown, &mut std::iter::empty());
            }
        }
    }
}
