//! From an event's place on the dense output of a step to the event itself.

use super::events::{Event, Found, Reached, Vector, unpack};
use super::nodes::Seen;
use super::steady::steadily;
use super::walker::Walker;
use crate::planar::contact::kinematics::turns;
use crate::planar::geometry::State;
use crate::planar::modes::watch::WatchList;
use crate::tolerance::{CURVELESS, FIRST_SECANT, INSTANT, LAST_DIGIT_OF_TIME, SECANT_DONE, SHORT_SHIFT};
use carom_num::ode8::{EVALUATIONS_PLAIN, Step, step_plain};
use carom_num::poly::Quartic;

/// Steps to an event after which it is taken where it is.
const MOST_STEPS_TO_EVENT: u32 = 7;
/// Secants on the dense output after which a step is made to where they have come.
const MOST_SECANTS: u32 = 8;
/// A fraction of a step by which an interpolant does not mistake the place of an event.
const MOST_ASTRAY: f64 = 0.02;
/// Halvings of the part of a step in which an event is, before a secant.
const MOST_HALVINGS: u32 = 12;

impl<const B: usize> Walker<'_, B> {
    /// Steps to the event: makes a step that ends where the dense output has the event. What is left of the event function is taken away by a shift
    /// along the motion, which is too short for the curvature of the motion to count.
    pub(super) fn polish(
        &mut self,
        (tried, steady): (&Step<Vector<B>>, bool),
        found: &Found,
        seen: &mut Seen<B>,
    ) -> Reached<B> {
        let place = found.length.max(INSTANT * self.scales.time);
        let (mut length, mut slope) = (place, found.slope);
        let mut before: Option<(f64, f64)> = None;
        let mut end = self.step_to((tried, steady), length);
        for _ in 0..MOST_STEPS_TO_EVENT {
            let value = self.event_value(&found.event, self.time + length, &unpack(&end), seen);
            if let Some((at, was)) = before.filter(|(at, _)| *at != length) {
                slope = (value - was) / (length - at);
            }
            let correction = -value / slope;
            if !correction.is_finite() || correction.abs() <= LAST_DIGIT_OF_TIME * (self.time + length) {
                break;
            }
            if correction.abs() <= CURVELESS * self.scales.time {
                return self.shifted((length, &end), correction.max(-length));
            }
            before = Some((length, value));
            let next = (length + correction).max(0.0);
            // The dense output is not that far from the motion. What is left of the function is rounding, and other events lie between.
            if (next - place).abs() > MOST_ASTRAY * tried.length {
                return Reached { length: place, state: self.step_to((tried, steady), place) };
            }
            end = if correction.abs() <= SHORT_SHIFT * length {
                self.moved_on(&end, next - length)
            } else {
                self.step_to((tried, steady), next)
            };
            length = next;
        }
        Reached { length, state: end }
    }

    /// Where the event function is zero on the dense output, near the fraction `at` of the step where its interpolant is.
    pub(super) fn placed(
        &mut self,
        tried: &Step<Vector<B>>,
        event: Event,
        at: f64,
        seen: &mut Seen<B>,
    ) -> Found {
        let mut x = at;
        let mut value = self.value_on(tried, &event, x, seen);
        let mut other = if x > FIRST_SECANT { x - FIRST_SECANT } else { x + FIRST_SECANT };
        let mut other_value = self.value_on(tried, &event, other, seen);
        let mut slope = (other_value - value) / (other - x);
        for _ in 0..MOST_SECANTS {
            let next = (x - value / slope).clamp(0.0, 1.0);
            if !next.is_finite() || (next - x).abs() <= SECANT_DONE {
                break;
            }
            if (next - at).abs() > MOST_ASTRAY {
                (x, slope) = self.bracketed(tried, &event, at, seen).unwrap_or((x, slope));
                break;
            }
            (other, other_value, x) = (x, value, next);
            value = self.value_on(tried, &event, x, seen);
            slope = (other_value - value) / (other - x);
        }
        Found { length: x * tried.length, slope: slope / tried.length, event }
    }

    /// Where an event function falls on the dense output next to a fraction `at` of the step that is not quite the place, and the slope there;
    /// `None` where it does not change its sign between there and the step's end, or its start.
    fn bracketed(
        &mut self,
        tried: &Step<Vector<B>>,
        event: &Event,
        at: f64,
        seen: &mut Seen<B>,
    ) -> Option<(f64, f64)> {
        let mut near = (at, self.value_on(tried, event, at, seen));
        // On the side where the fall is still to come, or has been.
        let (side, mut reach) = (1.0_f64.copysign(near.1), MOST_ASTRAY);
        let mut far = loop {
            let x = (at + side * reach).clamp(0.0, 1.0);
            let value = self.value_on(tried, event, x, seen);
            if side * value <= 0.0 {
                break (x, value);
            }
            if x == 0.0 || x == 1.0 {
                return None;
            }
            (near, reach) = ((x, value), 2.0 * reach);
        };
        for _ in 0..MOST_HALVINGS {
            let x = 0.5 * (near.0 + far.0);
            let value = self.value_on(tried, event, x, seen);
            if side * value > 0.0 { near = (x, value) } else { far = (x, value) }
        }
        let slope = (far.1 - near.1) / (far.0 - near.0);
        Some((near.0 - near.1 / slope, slope))
    }

    /// This event, or another one whose place turns out to be before it. An interpolant tells that a function falls; of two functions that fall soon
    /// after each other it does not always tell which is first.
    pub(super) fn not_after_another(
        &mut self,
        tried: &Step<Vector<B>>,
        list: &WatchList<'_>,
        mut first: Found,
        seen: &mut Seen<B>,
    ) -> Found {
        for row in list.iter().filter(|row| row.values[0] > 0.0 && row.values.iter().any(|v| *v < 0.0)) {
            if matches!(first.event, Event::Watched(known) if known.what == row.watched.what) {
                continue;
            }
            let other = Event::Watched(row.watched);
            if self.value_on(tried, &other, first.length / tried.length, seen) >= 0.0 {
                continue;
            }
            if let Some(x) = Quartic::through(&row.values).first_fall() {
                let found = self.placed(tried, other, x, seen);
                first = if found.length < first.length { found } else { first };
            }
        }
        first
    }

    fn value_on(&mut self, tried: &Step<Vector<B>>, event: &Event, x: f64, seen: &mut Seen<B>) -> f64 {
        self.event_value(event, self.time + x * tried.length, &unpack(&tried.at(x)), seen)
    }

    /// The end of a step of `length` from where `tried` starts.
    fn step_to(&mut self, (tried, steady): (&Step<Vector<B>>, bool), length: f64) -> Vector<B> {
        if steady {
            return steadily(&tried.start, &tried.start_rate, length).0;
        }
        self.effort.evaluations += EVALUATIONS_PLAIN;
        step_plain(tried.start, tried.start_rate, length, self.rates()).end
    }

    /// The end of a step, moved on or back by a short time: the classical method of order 4.
    fn moved_on(&mut self, end: &Vector<B>, by: f64) -> Vector<B> {
        self.effort.evaluations += 4;
        let of = self.rates();
        let after = |f: &Vector<B>, t: f64| -> Vector<B> {
            std::array::from_fn(|b| std::array::from_fn(|i| end[b][i] + t * f[b][i]))
        };
        let first = of(end);
        let second = of(&after(&first, 0.5 * by));
        let third = of(&after(&second, 0.5 * by));
        let fourth = of(&after(&third, by));
        let mean =
            |b: usize, i: usize| (first[b][i] + 2.0 * (second[b][i] + third[b][i]) + fourth[b][i]) / 6.0;
        std::array::from_fn(|b| std::array::from_fn(|i| end[b][i] + by * mean(b, i)))
    }

    /// The end of a step, moved by a very short time along the motion there.
    fn shifted(&mut self, (length, end): (f64, &Vector<B>), by: f64) -> Reached<B> {
        self.effort.evaluations += 1;
        let along = self.rates()(end);
        let state = std::array::from_fn(|b| std::array::from_fn(|i| end[b][i] + by * along[b][i]));
        Reached { length: length + by, state }
    }

    fn event_value(&mut self, event: &Event, time: f64, states: &[State; B], seen: &mut Seen<B>) -> f64 {
        self.effort.event_evaluations += 1;
        match event {
            Event::Watched(w) => {
                let (turns, asked) = (turns(states), w.what.asks_forces());
                if asked {
                    self.effort.evaluations += 1;
                    self.world.forces_into(&self.held, states, &turns, &mut seen.forces);
                }
                self.snapshot(time, (states, &turns), asked.then_some(&seen.forces)).value(w)
            }
            Event::Meets(pair) => self.world.kinematics(states, *pair).gap / self.scales.length,
        }
    }
}
