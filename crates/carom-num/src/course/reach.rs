//! From an event's place on the dense output of a step to the event itself.

use super::Course;
use crate::ode8::{Step, Vector};
use crate::tolerance::{FIRST_SECANT, LAST_DIGIT, SECANT_DONE, SHORT_SHIFT, STRAIGHT};

/// Steps to an event after which it is taken where it is.
const MOST_STEPS: u32 = 7;
/// Secants on the dense output after which a step is made to where they have come.
const MOST_SECANTS: u32 = 8;
/// A fraction of a step by which an interpolant does not mistake the place of an event.
const MOST_ASTRAY: f64 = 0.02;
/// A secant this many times as long as the one before follows rounding.
const LEAP: f64 = 100.0;
/// The fraction of a step within which a fall is looked for first, and then twice as far each time.
const NEAREST: f64 = 1e-9;
/// Halvings of the part of a step in which an event is, before a secant.
const MOST_HALVINGS: u32 = 12;

/// An event within a step.
///
/// # Example
/// See [`follow`](super::follow).
#[derive(Clone, Copy, Debug)]
pub struct Found<Event> {
    /// A fraction of the step.
    pub at: f64,
    /// How fast the event function changes there with the length of the step, where that is known.
    pub slope: Option<f64>,
    /// What happens.
    pub event: Event,
}

impl<Event> Found<Event> {
    /// An event of which no slope is known.
    ///
    /// # Example
    /// ```
    /// let found = carom_num::course::Found::at(0.5, "it touches");
    /// assert_eq!((found.at, found.slope), (0.5, None));
    /// ```
    pub fn at(at: f64, event: Event) -> Self {
        Self { at, slope: None, event }
    }
}

/// Where an event function is zero on the dense output, near the fraction `at` of the step where its interpolant is.
///
/// # Example
/// A height of 1 − t² on a step of 2, of which an interpolant says 0.501.
/// ```
/// use carom_num::course::{Course, Found, Lost, Pace, placed};
/// use carom_num::ode8::{Step, step_plain};
/// struct Time;
/// impl Course for Time {
///     type Y = [f64; 1];
///     type Event = ();
///     type End = ();
///     fn rate(&mut self, _: &[f64; 1]) -> [f64; 1] {
///         [1.0]
///     }
///     fn first_event(&mut self, _: &Step<[f64; 1]>) -> Result<Option<Found<()>>, Lost> {
///         Ok(None)
///     }
///     fn value(&mut self, _: &(), _: f64, y: &[f64; 1]) -> f64 {
///         1.0 - y[0] * y[0]
///     }
///     fn pace(&self, _: &[f64; 1], _: &[f64; 1]) -> Pace<[f64; 1]> {
///         Pace::within([1e-9])
///     }
/// }
/// let step = step_plain([0.0], [1.0], 2.0, |_| [1.0]).with_dense([1.0], |_| [1.0]);
/// let found = placed(&mut Time, &step, (), 0.501);
/// assert!((found.at - 0.5).abs() < 1e-12);
/// ```
pub fn placed<C: Course>(course: &mut C, step: &Step<C::Y>, event: C::Event, at: f64) -> Found<C::Event> {
    let mut x = at;
    let mut value = value_on(course, step, &event, x);
    let mut other = if x > FIRST_SECANT { x - FIRST_SECANT } else { x + FIRST_SECANT };
    let mut other_value = value_on(course, step, &event, other);
    let mut slope = (other_value - value) / (other - x);
    let mut lost = false;
    for secants in 0..MOST_SECANTS {
        let next = (x - value / slope).clamp(0.0, 1.0);
        if !next.is_finite() || (next - x).abs() <= SECANT_DONE {
            break;
        }
        // A secant through last digits may lead anywhere, also to another place where the function is as small: to the start, if it began at zero.
        let leaps = secants > 0 && (next - x).abs() > LEAP * (x - other).abs();
        lost = leaps || (next - at).abs() > MOST_ASTRAY;
        if lost {
            break;
        }
        (other, other_value, x) = (x, value, next);
        value = value_on(course, step, &event, x);
        slope = (other_value - value) / (other - x);
    }
    // Where it rises it came from: it does not fall there.
    if lost || slope > 0.0 {
        (x, slope) = bracketed(course, step, &event, at).unwrap_or((x, slope));
    }
    Found { at: x, slope: Some(slope / step.length), event }
}

/// Where an event function falls on the dense output next to a fraction `at` of the step that is not quite the place, and the slope there;
/// `None` where it does not change its sign between there and the step's end, or its start.
fn bracketed<C: Course>(course: &mut C, step: &Step<C::Y>, event: &C::Event, at: f64) -> Option<(f64, f64)> {
    let mut near = (at, value_on(course, step, event, at));
    // On the side where the fall is still to come, or has been.
    let (side, mut reach) = (1.0_f64.copysign(near.1), NEAREST);
    let mut far = loop {
        let x = (at + side * reach).clamp(0.0, 1.0);
        let value = value_on(course, step, event, x);
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
        let value = value_on(course, step, event, x);
        if side * value > 0.0 { near = (x, value) } else { far = (x, value) }
    }
    // The last digits may be the same on both sides.
    let slope = (far.1 - near.1) / (far.0 - near.0);
    let root = near.0 - near.1 / slope;
    Some((if root.is_finite() { root } else { near.0 }, slope))
}

fn value_on<C: Course>(course: &mut C, step: &Step<C::Y>, event: &C::Event, x: f64) -> f64 {
    course.value(event, x * step.length, &step.at(x))
}

/// Steps to an event: the length of the step that ends there, and its end. What is left of the event function is taken away by a shift along the
/// course, which is too short for the curvature of the course to count. `clock` is where the step starts.
pub(super) fn reach<C: Course>(
    course: &mut C,
    step: &Step<C::Y>,
    found: &Found<C::Event>,
    clock: f64,
) -> (f64, C::Y) {
    let smooth = course.is_smooth(step);
    let place = found.at * step.length;
    let (mut length, mut slope) = (place, found.slope);
    let mut before: Option<(f64, f64)> = None;
    let mut end = course.step_to(step, length);
    for _ in 0..MOST_STEPS {
        let value = course.value(&found.event, length, &end);
        if let Some(known) = course.slope(&found.event, length, &end) {
            slope = Some(known);
        } else if let Some((at, was)) = before.filter(|(at, _)| *at != length) {
            slope = Some((value - was) / (length - at));
        }
        let slope = *slope.get_or_insert_with(|| {
            // The first secant needs a second place near by.
            let near = (found.at - FIRST_SECANT).max(0.5 * found.at);
            (value - value_on(course, step, &found.event, near)) / (length - near * step.length)
        });
        let correction = -value / slope;
        if !correction.is_finite() || correction.abs() <= LAST_DIGIT * (clock + length) {
            break;
        }
        // It was found after the start, where the function is zero too, but for rounding: the digits that are left lead back there.
        if place > 0.0 && correction <= -length {
            return (place, course.step_to(step, place));
        }
        if smooth && correction.abs() <= STRAIGHT * step.length {
            return (length + correction, shifted(course, &end, correction));
        }
        before = Some((length, value));
        let next = (length + correction).max(0.0);
        // The dense output is not that far from the course. What is left of the function is rounding, and other events lie between.
        if (next - place).abs() > MOST_ASTRAY * step.length {
            return (place, course.step_to(step, place));
        }
        end = if smooth && correction.abs() <= SHORT_SHIFT * length {
            moved_on(course, &end, next - length)
        } else {
            course.step_to(step, next)
        };
        length = next;
    }
    (length, end)
}

/// A state a short way further on, or back: the classical method of order 4.
fn moved_on<C: Course>(course: &mut C, y: &C::Y, by: f64) -> C::Y {
    let after = |rate: &C::Y, t: f64| C::Y::from_fn(|i| y.at(i) + t * rate.at(i));
    let first = course.rate(y);
    let second = course.rate(&after(&first, 0.5 * by));
    let third = course.rate(&after(&second, 0.5 * by));
    let fourth = course.rate(&after(&third, by));
    let mean = |i: usize| (first.at(i) + 2.0 * (second.at(i) + third.at(i)) + fourth.at(i)) / 6.0;
    C::Y::from_fn(|i| y.at(i) + by * mean(i))
}

/// A state a very short way further on, or back.
fn shifted<C: Course>(course: &mut C, y: &C::Y, by: f64) -> C::Y {
    let along = course.rate(y);
    C::Y::from_fn(|i| y.at(i) + by * along.at(i))
}
