//! A mode's motion on its way to the event that ends it, as a [`Course`].

use super::events::Place;
use super::flush::Marks;
use super::motion::{Event, Motion, Stop};
use super::walker::Walker;
use crate::evaluated::{Quantity, evaluated, lost, watched};
use crate::spatial::geometry::posture::Posture;
use crate::spatial::geometry::state::measured;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::mode::{Fixed, Mode};
use crate::spatial::record::run::Budget;
use crate::spatial::terms::Overturning;
use crate::tolerance::{SHORTEST_SPATIAL_STEP, SKIMS_MEASURED, SMALL_HEIGHT, TOUCHES_AT_START};
use carom_num::Vec3;
use carom_num::course::{self, Course, Found, Lost, Pace};
use carom_num::ode8::{Step, Trial, Vector, step_plain};

/// The first step, in the world's time, where nothing says more.
const FIRST_STEP: f64 = 0.1;
/// A first step reaches a little beyond the first touch that is foreseen: heights of a hop are then told from zero at every place of it.
const BEYOND: f64 = 1.2;
/// Samples that an observer is handed of a step.
const SAMPLES: u32 = 8;

/// A mode's motion, and what is watched during it.
pub(super) struct Gliding<'g, 'w, M: Motion> {
    pub(super) walker: &'g mut Walker<'w>,
    pub(in crate::spatial) motion: M,
    /// Supports that are held.
    pub(in crate::spatial) held: Supports,
    /// What of the body stays where it is: heights of its points do not change.
    pub(super) fixed: Fixed,
    /// Supports that cannot leave what they touch meanwhile.
    pub(super) flush: Marks,
    /// Supports that have just left the plane without speed: their height leaves zero by its second or third derivative.
    pub(super) departing: Supports,
    pub(in crate::spatial) overturning: Option<Overturning>,
    /// The middle of the supports, body axes.
    pub(in crate::spatial) middle: Vec3,
    /// What is added to the gaps of pairs, those after the points on faces: small ones are counted on from stretch to stretch too.
    counted: Vec<f64>,
    /// The motion at places of the step that is being looked at.
    pub(super) places: Vec<Place<M::Y>>,
    /// What was worked out there.
    pub(super) known_at: Vec<(f64, M::Known)>,
    start_time: f64,
    /// Time since the start of the stretch [s].
    pub(in crate::spatial) elapsed: f64,
    /// Work of friction since then \[J\].
    pub(in crate::spatial) work: f64,
}

impl<'g, 'w, M: Motion> Gliding<'g, 'w, M> {
    pub(in crate::spatial) fn from(walker: &'g mut Walker<'w>, motion: M, first: &M::Y) -> Self {
        let (world, near) = (walker.world, SKIMS_MEASURED * walker.scales.length);
        let at = motion.posture(first, 0.0);
        let moving = motion.moving(&at);
        let count = |i: usize| {
            let noted = walker.heights[i];
            // Of what is far no gap is counted on.
            if noted == f64::INFINITY {
                return 0.0;
            }
            let gap = motion.gap(world, i, &at, &moving).value;
            // What has just touched is at no height, however little the projection of others has moved it.
            if gap.is_finite() && noted == 0.0 || (noted - gap).abs() <= near { noted - gap } else { 0.0 }
        };
        let counted = (world.of_faces()..world.count()).map(count).collect();
        let (body, held) = (walker.world.body(), walker.mode.held(walker.world));
        Self {
            held,
            fixed: walker.mode.fixed(walker.world),
            flush: walker.flush(),
            departing: std::mem::take(&mut walker.departing),
            overturning: walker.options.overturning,
            middle: body.middle(),
            counted,
            places: vec![],
            known_at: vec![],
            start_time: walker.time,
            elapsed: 0.0,
            work: 0.0,
            walker,
            motion,
        }
    }

    pub(super) fn first_length(&self, first: &M::Y) -> f64 {
        let (at, unit) = (self.motion.posture(first, 0.0), self.walker.scales.time);
        let moving = self.motion.moving(&at);
        let height = |i: usize| self.height_of(i, &at, &moving);
        let free = (0..self.walker.world.count()).filter(|i| !self.held.contains(*i));
        // What is beside a face, or behind it, may be at no height as well.
        let world = self.walker.world;
        let low = TOUCHES_AT_START * self.walker.scales.length;
        let near = |i: &usize| self.walker.heights[*i] < f64::INFINITY;
        let ahead = |i: &usize| world.limits(*i) == 0 || height(*i).value > low;
        let foreseen = free.filter(near).filter(ahead).filter_map(|i| height(i).forecast());
        let foreseen = foreseen.fold(f64::INFINITY, f64::min);
        let own = if self.walker.length > 0.0 { self.walker.length } else { FIRST_STEP * unit };
        own.max(FIRST_STEP * unit).min(BEYOND * foreseen).max(SHORTEST_SPATIAL_STEP * unit)
    }

    /// What is added to the gap of a support.
    pub(super) fn counted(&self, support: usize) -> f64 {
        let pair = support.checked_sub(self.walker.world.of_faces());
        pair.map_or(0.0, |pair| self.counted[pair])
    }

    /// Something may come down before a slip has stopped, which is so long: steps tell.
    fn touches_within(&self, rest: f64, y: &M::Y) -> bool {
        let (world, at) = (self.walker.world, self.motion.posture(y, self.elapsed));
        let (moving, low) = (self.motion.moving(&at), TOUCHES_AT_START * self.walker.scales.length);
        let comes = |i: &usize| {
            let gap = self.motion.gap(world, *i, &at, &moving);
            let height = gap.value + self.counted(*i);
            height > 0.0 && height + gap.rate * rest < -low
        };
        let near = |i: &usize| self.walker.heights[*i] < f64::INFINITY;
        let free = (0..world.count()).filter(|i| !self.held.contains(*i) && !self.flush.contains(*i));
        free.filter(near).any(|i| comes(&i))
    }

    /// The stretch ends here, so long after its start.
    pub(super) fn arrive(&mut self, end: &M::Y, elapsed: f64) {
        self.walker.state = self.motion.state(end, elapsed);
        self.walker.lasted = elapsed;
        self.walker.time = self.start_time + elapsed;
        self.work = self.motion.work(end);
        self.note_heights(&self.motion.posture(end, elapsed));
    }

    /// Carries the heights on to the end of a stretch. Heights that are not small are measured again, so that rounding does not add up.
    fn note_heights(&mut self, at: &Posture) {
        let (world, foot) = (self.walker.world, self.walker.mode.foot());
        let (far, moving) = (world.far(&self.walker.state), self.motion.moving(at));
        for support in 0..world.count() {
            if support >= world.of_faces() && far[support - world.of_faces()] {
                self.walker.heights[support] = f64::INFINITY;
                continue;
            }
            let counted = self.height_of(support, at, &moving).value;
            self.walker.heights[support] = if self.held.contains(support) {
                0.0
            } else if counted.abs() > SMALL_HEIGHT * self.walker.scales.length {
                measured(world, &self.walker.state, foot, support)
            } else {
                counted
            };
        }
        self.walker.note_flush();
    }

    /// Samples of a step up to a length, and the states that are asked for within it, for observers that want them.
    pub(super) fn show(&mut self, step: &Step<M::Y>, length: f64) {
        let (elapsed, mode, motion) = (self.elapsed, self.walker.mode, &self.motion);
        let state = |along: f64| motion.state(&step.at(along / step.length), elapsed + along);
        let (begin, observer) = (self.start_time + elapsed, &mut *self.walker.observer);
        let mut next = observer.next_instant();
        while next < begin + length {
            observer.instant(next, &state((next - begin).max(0.0)));
            let asked = std::mem::replace(&mut next, observer.next_instant());
            if next <= asked {
                break;
            }
        }
        if !observer.is_dense() {
            return;
        }
        for k in 0..=SAMPLES {
            let along = length * f64::from(k) / f64::from(SAMPLES);
            observer.sample(begin + along, mode, &state(along));
        }
    }
}

/// Rates of a motion. If one of them is no number, none is. Rates that do not exist, because friction jams the body, are not lost numbers.
fn sound<Y: Vector>(rate: Y) -> Y {
    let sum = (0..Y::COUNT).fold(0.0, |sum, i| sum + rate.at(i));
    if !sum.is_nan() && evaluated(Quantity::Acceleration, sum).is_nan() {
        return Y::from_fn(|_| f64::NAN);
    }
    rate
}

impl<M: Motion> Course for Gliding<'_, '_, M> {
    type Y = M::Y;
    type Event = Event;
    type End = Stop;

    fn rate(&mut self, y: &M::Y) -> M::Y {
        self.walker.effort.evaluations += 1;
        sound(self.motion.rate(y))
    }

    fn end_rate(&mut self, y: &M::Y) -> M::Y {
        // The step that was tried is made.
        self.walker.effort.refused_steps -= 1;
        self.walker.effort.steps += 1;
        self.rate(y)
    }

    fn first_event(&mut self, step: &Step<M::Y>) -> Result<Option<Found<Event>>, Lost> {
        self.places.clear();
        self.known_at.clear();
        let at: Vec<Posture> = M::LOOKED_AT.iter().map(|x| self.place(step, *x).at).collect();
        self.motion.look(step, &at);
        let found = self.event_in(step);
        // An event may have been passed over, and the motion go on without end.
        if lost() { Err(Lost::Number) } else { Ok(found) }
    }

    fn value(&mut self, event: &Event, after: f64, y: &M::Y) -> f64 {
        self.walker.effort.event_evaluations += 1;
        let known = self.motion.known(y);
        let at = self.motion.posture_at(y, self.elapsed + after, &known);
        self.value_at(event, y, &at, &known)
    }

    fn slope(&mut self, event: &Event, after: f64, y: &M::Y) -> Option<f64> {
        let Event::Touches(support) = event else { return None };
        Some(self.height(*support, &self.motion.posture(y, self.elapsed + after)).rate)
    }

    fn end(&mut self, y: &M::Y, rate: &M::Y) -> Option<Stop> {
        // The next step tells it.
        if !self.walker.state.is_finite() {
            return None;
        }
        if self.elapsed > 0.0
            && let Some((rest, end)) = self.motion.stops(y, rate)
            && !self.touches_within(rest, y)
        {
            self.arrive(&end, self.elapsed + rest);
            return Some(Stop::Event(Event::Stops));
        }
        // Walls beside it may still touch it, and carry nothing.
        let (world, held) = (self.walker.world, self.walker.mode.held(self.walker.world));
        let falls =
            !matches!(self.walker.mode, Mode::Rest { .. }) && held.iter().all(|i| world.limits(i) == 0);
        if falls && world.is_past(&self.walker.state) {
            self.work = self.motion.work(y);
            return Some(Stop::Away);
        }
        let options = self.walker.options;
        let spent = if self.walker.time >= options.most_time {
            Budget::Time
        } else if self.walker.effort.steps >= options.most_steps {
            Budget::Steps
        } else {
            return None;
        };
        self.work = self.motion.work(y);
        Some(Stop::Spent(spent))
    }

    fn pace(&self, y: &M::Y, rate: &M::Y) -> Pace<M::Y> {
        let (walker, unit) = (&*self.walker, self.walker.scales.time);
        Pace {
            longest: (walker.options.most_time - walker.time).min(self.motion.longest(y, rate)),
            shortest: SHORTEST_SPATIAL_STEP * unit,
            clock: walker.time,
            ..Pace::within(self.motion.tolerance(y, walker.options.tolerance, 1.0 / unit))
        }
    }

    fn step(
        &mut self,
        from: (&M::Y, &M::Y),
        length: f64,
        pace: &Pace<M::Y>,
    ) -> Result<(Step<M::Y>, f64), Lost> {
        if !self.walker.state.is_finite() {
            return Err(Lost::Number);
        }
        let Pace { longest, shortest, .. } = *pace;
        // Steps towards a stop that never comes, on a clock that stands: only what is left of the time may be as short.
        if longest < shortest && longest < self.walker.options.most_time - self.walker.time {
            self.arrive(from.0, self.elapsed);
            return Err(Lost::Short(longest));
        }
        let made = if let Some(stiff) = self.motion.stiff_step(from, (length, longest), &pace.tolerance) {
            self.walker.effort.steps += 1;
            Ok(stiff)
        } else {
            course::step(self, from, length, pace)
        };
        match made {
            Ok((_, next)) => self.walker.length = next,
            Err(_) => self.arrive(from.0, self.elapsed),
        }
        made
    }

    fn tried(&mut self, (y, rate): (&M::Y, &M::Y), length: f64) -> (Trial<M::Y>, bool) {
        self.walker.effort.refused_steps += 1;
        watched(|| step_plain(*y, *rate, length, |y| self.rate(y)))
    }

    fn is_smooth(&self, step: &Step<M::Y>) -> bool {
        !self.motion.is_stiff(&step.start, &step.start_rate)
    }

    fn step_to(&mut self, step: &Step<M::Y>, length: f64) -> M::Y {
        let stiff = self.motion.stiff_end(step, length);
        stiff.unwrap_or_else(|| course::explicit_end(self, step, length))
    }

    fn passed(&mut self, step: Step<M::Y>) -> M::Y {
        let left = self.walker.options.most_time - self.walker.time;
        self.show(&step, step.length);
        self.elapsed += step.length;
        self.departing = Supports::NONE;
        let y = self.motion.tidied(&step.end);
        self.walker.state = self.motion.state(&y, self.elapsed);
        let spent = step.length >= left;
        self.walker.time = if spent { self.walker.options.most_time } else { self.start_time + self.elapsed };
        y
    }
}
