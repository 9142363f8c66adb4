//! Motion of a lone body with one contact along its Taylor series: the event functions are series as well, so that their first fall is found
//! without looking at the motion again.

use crate::tolerance::{COARSE_SERIES_TOLERANCE, INSTANT, NEWTON_ASTRAY, NEWTON_DONE, SHORTEST_STEP};
mod along;
mod expansion;
mod modes;
mod quantities;
mod straight;

use super::events::Event;
use super::glide::MOST_STEPS;
use super::gliding::Over;
use super::path::{Course, Stretch};
use super::swing::Swing;
use super::terms::Happening;
use super::walker::Walker;
use crate::MotionError;
use crate::planar::contact::{World, bounds::Bounds, kinematics::Pairing, touching::Few, world::Scales};
use crate::planar::geometry::Feature;
use crate::planar::modes::{
    mode::Forces,
    watch::{FEW_WATCHED, Watch, WatchList, Watched},
};
use crate::planar::record::observer::{Observers, is_dense, wants_slips};
use along::Along;
use carom_impact::planar::Slip;
use carom_num::course::{Lost, Stepper, walk};
use expansion::Given;
use std::sync::Arc;
use straight::Straight;

/// Coefficients of a series where much is asked, and where little is (from [`COARSE_SERIES_TOLERANCE`] on).
const FINE: usize = 18;
const COARSE: usize = 12;
/// Part of the tolerance that the last coefficient may add. The coefficients left out, and a reach that is known to a few per cent, take the rest.
const LAST: f64 = 0.1;
/// A step is at most this long, in the world's own time: where nothing turns a series reaches for ever.
const LONGEST: f64 = 8.0;

/// Stretch after stretch of a mode, each in the place of the last one: series are long.
struct Stretches<'g, 'w, 'o, 'l, E, F, const B: usize> {
    walker: &'g mut Walker<'w, B>,
    observers: &'g mut Observers<'o, B>,
    list: WatchList<'l>,
    place: Option<E>,
    number: u32,
    /// Makes the stretch of this number.
    next: F,
    swing: Option<Swing>,
    swings: bool,
}

impl<'w, E, F, const B: usize> Stepper for Stretches<'_, 'w, '_, '_, E, F, B>
where
    E: Expanded<B>,
    F: Fn(&mut Walker<'w, B>, u32, &mut Option<E>) -> Result<(), Lost>,
{
    type Step = ();
    type Event = Event;
    type End = Over;

    fn end(&mut self) -> Option<Over> {
        self.walker.over(self.swings)
    }

    fn step(&mut self) -> Result<(), Lost> {
        self.number += 1;
        (self.next)(self.walker, self.number, &mut self.place)
    }

    fn event(&mut self, (): &mut ()) -> Result<Option<Event>, Lost> {
        let Some(stretch) = &mut self.place else { return Err(Lost::Number) };
        let event = self.walker.shortened(stretch, &mut self.list);
        self.walker.take(stretch, event.is_some(), self.observers);
        if event.is_some() {
            self.walker.states = self.walker.projected(&self.walker.states);
        }
        Ok(event)
    }

    fn passed(&mut self, (): ()) {
        let states = self.walker.states;
        self.swings = self.walker.comes_back(self.swing.as_mut());
        // What has clearly opened needs no event function of its own any more: the list is made anew without it.
        if !self.swings && self.walker.forget_left(&states) {
            self.walker.note_watched_with(&mut self.list, &mut Forces::default());
        }
    }
}

/// A stretch of motion whose event functions are known as functions of time.
trait Expanded<const B: usize>: Stretch<B> + Clone + 'static {
    /// Ends it earlier [s].
    fn shorten(&mut self, length: f64);
    /// Where an event function falls through zero first within it [s]; it starts at the time `now`.
    fn fall(&self, known: (&World, &Scales), watched: &Watched, now: f64) -> Option<f64>;
    /// Bounds on the motion.
    fn bounds(&self, world: &World) -> Bounds;
    /// The slip speed at its end [m/s].
    fn slips(&self) -> f64;
    /// The largest slip speed where it is neither at the start nor at the end [m/s].
    fn fastest_within(&self) -> Option<f64>;
}

impl<const B: usize> Walker<'_, B> {
    /// Moves with the present contacts held until an event, and resolves it, where the mode is one whose event functions are known as functions
    /// of time: a lone body with one contact between a vertex and a face, or with two that slide on one line.
    pub(super) fn glide_along_series(
        &mut self,
        observers: &mut Observers<'_, B>,
    ) -> Option<Result<Happening, MotionError>> {
        let of_vertex_and_face = |pair: &Pairing| !matches!(pair.feature, Feature::VertexOnEnd { .. });
        if B > 1 || !self.watches_few() || !self.departing.iter().all(of_vertex_and_face) {
            return None;
        }
        match (self.held.get(0), self.held.len()) {
            (Some(h), 1) if of_vertex_and_face(&h.pair) && self.world.is_plain(h.pair) => {
                Some(if self.options.tolerance < COARSE_SERIES_TOLERANCE {
                    self.glide_expanded(Self::step_along::<FINE>, observers)
                } else {
                    self.glide_expanded(Self::step_along::<COARSE>, observers)
                })
            }
            (Some(_), 2) if self.straight(0.0).is_some() => {
                let longest = LONGEST * self.scales.time;
                let next = |walker: &mut Self, steps, place: &mut Option<Straight>| {
                    *place = walker.straight(f64::from(steps) * longest);
                    // No step is made from where they do not slide on one line any more.
                    if place.is_some() { Ok(()) } else { Err(Lost::Short(0.0)) }
                };
                Some(self.glide_expanded(next, observers))
            }
            _ => None,
        }
    }

    /// Goes along stretch after stretch of a mode to its end. `next` is given the number of the stretch and makes it in the place of the last one.
    fn glide_expanded<E: Expanded<B>>(
        &mut self,
        next: impl Fn(&mut Self, u32, &mut Option<E>) -> Result<(), Lost>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let mut rows = [None; FEW_WATCHED];
        let mut list = WatchList::on(&mut rows);
        let (start_time, start) = (self.time, self.states);
        self.report_start(observers);
        self.report_slips(observers);
        self.note_watched_with(&mut list, &mut Forces::default());
        self.sample_here(observers);
        let swing = self.swing();
        let mut stretches =
            Stretches { walker: self, observers, list, place: None, number: 0, next, swing, swings: false };
        let stop = walk(&mut stretches, MOST_STEPS as usize);
        self.conclude((start_time, &start), stop, observers)
    }

    /// What is left of the time there is [s].
    fn time_left(&self) -> f64 {
        self.options.most_time - self.time
    }

    /// Two contacts that slide on one line, for this long at most [s].
    fn straight(&self, length: f64) -> Option<Straight> {
        if !self.states.iter().all(|s| self.turns_not(s)) {
            return None;
        }
        Straight::of(&self.world, &self.held, &self.states[0], length.min(self.time_left()))
    }

    /// The series from here on as far as they reach.
    fn step_along<const P: usize>(&mut self, _number: u32, place: &mut Option<Along<P>>) -> Result<(), Lost> {
        let (Some(held), [state, ..]) = (self.held.get(0), &self.states[..]) else {
            return Err(Lost::Number);
        };
        let Some(given) = Given::of(&self.world, held, state) else { return Err(Lost::Number) };
        let slips = held.slip != Slip::Sticks;
        let along = Along::from(given, place);
        self.effort.steps += 1;
        self.effort.evaluations += P as u64;
        let (l, v, tolerance) = (self.scales.length, self.scales.speed, LAST * self.options.tolerance);
        let speed = v.max(state.twist.velocity.norm());
        let spin = (speed / l).max(state.twist.spin.abs());
        let length =
            along.expansion.reach((tolerance * spin, tolerance * speed, tolerance), self.scales.time);
        if length >= SHORTEST_STEP * self.scales.time {
            let length = length.min(LONGEST * self.scales.time).min(self.time_left());
            along.set_length(length);
            return Ok(());
        }
        Err(if length.is_nan() && !slips { Lost::Number } else { Lost::Short(length) })
    }

    /// The first event within a stretch, which then ends there.
    fn shortened<E: Expanded<B>>(&mut self, stretch: &mut E, list: &mut WatchList<'_>) -> Option<Event> {
        let mut first: Option<Event> = None;
        let mut run_off = Few::default();
        for row in list.iter() {
            self.effort.event_evaluations += 1;
            let known = (&*self.world, &self.scales);
            let fall = stretch.fall(known, &row.watched, self.time);
            let Some(time) = fall.filter(|time| first.is_none() || *time < stretch.length()) else {
                continue;
            };
            if let Watch::Gap(pair) = row.watched.what
                && self.has_run_off(pair, &stretch.states(time / stretch.length()))
            {
                run_off.push(pair);
                continue;
            }
            stretch.shorten(time);
            first = Some(Event::Watched(row.watched));
        }
        run_off.iter().for_each(|pair| self.watch_no_more(*pair, list));
        if stretch.length() <= INSTANT * self.scales.time {
            return first;
        }
        let bounds = stretch.bounds(&self.world);
        let Some((x, pair)) = self.first_meeting(stretch, 1.0, &[bounds; B]) else { return first };
        let time = self.touched(stretch, x, pair);
        stretch.shorten(time);
        Some(Event::Meets(pair))
    }

    /// The very moment at which a pair touches [s after the start of the stretch]. `near` is a fraction of the stretch at which it is about to touch.
    fn touched(&mut self, stretch: &impl Stretch<B>, near: f64, pair: Pairing) -> f64 {
        let mut x = near;
        for _ in 0..8 {
            self.effort.event_evaluations += 1;
            let k = self.world.kinematics(&stretch.states(x), pair);
            let change = -k.gap / (k.approach * stretch.length());
            if !change.is_finite() || change.abs() * stretch.length() > NEWTON_ASTRAY * self.scales.time {
                break;
            }
            x = (x + change).clamp(0.0, 1.0);
            if change.abs() <= NEWTON_DONE {
                break;
            }
        }
        x * stretch.length()
    }

    /// Goes to the end of a stretch.
    fn take<E: Expanded<B>>(&mut self, stretch: &E, ends: bool, observers: &mut Observers<'_, B>) {
        self.show_along(stretch, stretch.length(), observers);
        self.note_leg(stretch.length(), || Course::Along(Arc::new(stretch.clone())));
        if is_dense(observers) {
            self.sample_stretch(stretch, (1.0, ends), observers);
        }
        self.time += stretch.length();
        self.states = stretch.states(1.0);
        if wants_slips(observers) {
            let speed = stretch.fastest_within().unwrap_or(0.0).max(stretch.slips());
            for (body, observer) in observers.iter_mut().enumerate() {
                let Some(observer) = observer else { continue };
                let slipping = self.held_of(body).filter(|held| held.slip != Slip::Sticks);
                slipping.for_each(|held| observer.slips(held.obstacle, speed));
            }
        }
    }
}
