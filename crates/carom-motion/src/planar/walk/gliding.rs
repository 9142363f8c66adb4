//! A mode's motion on its way to the event that ends it, as a [`Course`].

use super::events::{Event, Vector, rate, unpack};
use super::steady::steadily;
use super::swing::Swing;
use super::walker::Walker;
use crate::evaluated::watched;
use crate::planar::contact::{bounds::Bounds, kinematics::turns};
use crate::planar::modes::{
    mode::Forces,
    watch::{Watch, WatchList, Watched},
};
use crate::planar::record::observer::{Observers, is_dense};
use crate::tolerance::{INSTANT, SHORTEST_STEP};
use carom_num::course::{self, Course, Found, Lost, Pace, placed};
use carom_num::ode8::{Step, Trial, step_plain};
use carom_num::poly::Quartic;

/// A mode's motion, what has been seen of it, and those who look on.
pub(super) struct Gliding<'g, 'w, 'l, 'o, const B: usize> {
    pub(super) walker: &'g mut Walker<'w, B>,
    pub(super) observers: &'g mut Observers<'o, B>,
    /// The event functions.
    pub(super) list: &'g mut WatchList<'l>,
    /// The forces where the motion was looked at last; at first those with which the event functions were noted.
    pub(super) forces: Forces<B>,
    /// The forces at the end of the step that is being examined.
    pub(super) end: Option<Forces<B>>,
    /// The acceleration stays what it is.
    pub(super) steady: bool,
    /// Bounds on the motion up to now: the event functions at the end of the last step are those at the start of the next.
    pub(super) so_far: Option<[Bounds; B]>,
    swing: Option<Swing>,
    swings: bool,
}

/// How a mode's motion ends without an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Over {
    /// The time is used up.
    TimeUp,
    /// It swings for ever.
    Swings,
}

impl<const B: usize> Walker<'_, B> {
    /// How a motion ends here that swings for ever, or does not.
    pub(super) fn over(&self, swings: bool) -> Option<Over> {
        let spent = self.time >= self.options.most_time;
        if swings { Some(Over::Swings) } else { spent.then_some(Over::TimeUp) }
    }
}

impl<'g, 'w, 'l, 'o, const B: usize> Gliding<'g, 'w, 'l, 'o, B> {
    /// The motion from where the walker is, the event functions noted.
    pub(super) fn from(
        walker: &'g mut Walker<'w, B>,
        list: &'g mut WatchList<'l>,
        observers: &'g mut Observers<'o, B>,
    ) -> Self {
        let (steady, swing) = (walker.is_steady(), walker.swing());
        let mut gliding = Self {
            walker,
            observers,
            list,
            forces: Forces::default(),
            end: None,
            steady,
            so_far: None,
            swing,
            swings: false,
        };
        gliding.note_watched();
        gliding
    }

    /// Notes the event functions from here on; leaves the forces here in `forces`.
    fn note_watched(&mut self) {
        (self.end, self.so_far) = (None, None);
        self.walker.note_watched_with(self.list, &mut self.forces);
    }

    /// The first event function that falls within a step.
    fn watched_event_in(&mut self, tried: &Step<Vector<B>>) -> Option<Found<Event>> {
        loop {
            let (x, w) = self.first_fall(tried)?;
            let found = placed(self, tried, Event::Watched(w), x);
            let found = self.not_after_another(tried, found);
            let Event::Watched(Watched { what: Watch::Gap(pair), .. }) = found.event else {
                return Some(found);
            };
            if !self.walker.has_run_off(pair, &unpack(&tried.at(found.at))) {
                return Some(found);
            }
            self.walker.watch_no_more(pair, self.list);
        }
    }

    /// This event, or another one whose place turns out to be before it. An interpolant tells that a function falls; of two functions that fall soon
    /// after each other it does not always tell which is first.
    fn not_after_another(&mut self, tried: &Step<Vector<B>>, mut first: Found<Event>) -> Found<Event> {
        for i in 0.. {
            let Some(row) = self.list.iter().nth(i).copied() else { break };
            let falls = row.values[0] > 0.0 && row.values.iter().any(|v| *v < 0.0);
            if !falls {
                continue;
            }
            if matches!(first.event, Event::Watched(known) if known.what == row.watched.what) {
                continue;
            }
            let (other, after) = (Event::Watched(row.watched), first.at * tried.length);
            if self.value(&other, after, &tried.at(first.at)) >= 0.0 {
                continue;
            }
            if let Some(x) = Quartic::through(&row.values).first_fall() {
                let found = placed(self, tried, other, x);
                first = if found.at < first.at { found } else { first };
            }
        }
        first
    }
}

impl<const B: usize> Course for Gliding<'_, '_, '_, '_, B> {
    type Y = Vector<B>;
    type Event = Event;
    type End = Over;

    fn rate(&mut self, y: &Vector<B>) -> Vector<B> {
        self.walker.effort.evaluations += 1;
        rate(y, &self.walker.world.accelerate(&self.walker.held, &unpack(y)))
    }

    fn end_rate(&mut self, y: &Vector<B>) -> Vector<B> {
        self.walker.effort.evaluations += 1;
        self.walker.effort.steps += 1;
        let states = unpack(y);
        let end = self.end.get_or_insert_default();
        self.walker.world.forces_into(&self.walker.held, &states, &turns(&states), end);
        rate(y, &end.acceleration)
    }

    fn first_event(&mut self, step: &Step<Vector<B>>) -> Result<Option<Found<Event>>, Lost> {
        let bounds = self.look_over(step);
        let watched = self.watched_event_in(step);
        let until = watched.as_ref().map_or(1.0, |found| found.at);
        let found = match self.walker.first_meeting(step, until, &bounds) {
            Some((x, pair)) => Some(placed(self, step, Event::Meets(pair), x)),
            None => watched,
        };
        // Time passes before an event.
        let least = INSTANT * self.walker.scales.time / step.length;
        Ok(found.map(|found| Found { at: found.at.max(least), ..found }))
    }

    fn value(&mut self, event: &Event, after: f64, y: &Vector<B>) -> f64 {
        let (walker, states) = (&mut *self.walker, unpack(y));
        walker.effort.event_evaluations += 1;
        match event {
            Event::Watched(w) => {
                let (turns, asked) = (turns(&states), w.what.asks_forces());
                if asked {
                    walker.effort.evaluations += 1;
                    walker.world.forces_into(&walker.held, &states, &turns, &mut self.forces);
                }
                let forces = asked.then_some(&self.forces);
                walker.snapshot(walker.time + after, (&states, &turns), forces).value(w)
            }
            Event::Meets(pair) => walker.world.kinematics(&states, *pair).gap / walker.scales.length,
        }
    }

    fn end(&mut self, _: &Vector<B>, _: &Vector<B>) -> Option<Over> {
        self.walker.over(self.swings)
    }

    fn pace(&self, _: &Vector<B>, _: &Vector<B>) -> Pace<Vector<B>> {
        let walker = &*self.walker;
        let (l, v, rtol) = (walker.scales.length, walker.scales.speed, walker.options.tolerance);
        let tolerance = walker.states.map(|state| {
            let speed = v.max(state.twist.velocity.norm());
            let spin = (speed / l).max(state.twist.spin.abs());
            [rtol * l, rtol * l, rtol, rtol * speed, rtol * speed, rtol * spin]
        });
        Pace {
            longest: walker.options.most_time - walker.time,
            shortest: SHORTEST_STEP * walker.scales.time,
            clock: walker.time,
            ..Pace::within(tolerance)
        }
    }

    fn step(
        &mut self,
        (y, f): (&Vector<B>, &Vector<B>),
        length: f64,
        pace: &Pace<Vector<B>>,
    ) -> Result<(Step<Vector<B>>, f64), Lost> {
        if self.steady {
            let length = length.min(pace.longest);
            return Ok((self.walker.steady_step(y, f, length), 2.0 * length));
        }
        course::step(self, (y, f), length, pace)
    }

    fn tried(&mut self, (y, f): (&Vector<B>, &Vector<B>), length: f64) -> (Trial<Vector<B>>, bool) {
        let (trial, lost) = watched(|| step_plain(*y, *f, length, |y| self.rate(y)));
        (trial, lost || !trial.end.iter().flatten().all(|v| v.is_finite()))
    }

    fn step_to(&mut self, step: &Step<Vector<B>>, length: f64) -> Vector<B> {
        if self.steady {
            return steadily(&step.start, &step.start_rate, length).0;
        }
        course::explicit_end(self, step, length)
    }

    fn passed(&mut self, step: Step<Vector<B>>) -> Vector<B> {
        let (walker, observers) = (&mut *self.walker, &mut *self.observers);
        if is_dense(observers) {
            walker.sample_stretch(&step, (1.0, false), observers);
        }
        let (length, states) = (step.length, walker.projected(&unpack(&step.end)));
        walker.note_step(step, length, observers);
        walker.time += length;
        walker.states = states;
        walker.report_slips(observers);
        self.swings = self.walker.comes_back(self.swing.as_mut());
        if !self.swings && self.walker.forget_left(&states) {
            self.note_watched();
        }
        super::events::pack(&states)
    }
}
