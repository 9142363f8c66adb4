//! A smooth course, followed to its first event.
//!
//! A [`Course`] is a system of equations and the functions that are positive as long as they hold. [`follow`] makes steps of
//! [order 8](crate::ode8), looks for the [first fall](crate::falls) of an event function on the dense output of each, and steps TO the event: the end is that
//! of a step, not of an interpolant.

use crate::falls::first_fall;
use crate::ode8::{Step, Trial, Vector, length_factor, step_plain};
use crate::tolerance::{EVENT_ARRIVED, EVENT_ASTRAY, EVENT_SECANT};

/// Secants, or steps of Newton's method, to an event.
const MOST_CORRECTIONS: u32 = 8;
/// What a step is multiplied by whose error is no number.
const LOST_STEP: f64 = 0.2;

/// Equations and what ends them.
///
/// # Example
/// See [`follow`].
pub trait Course {
    /// The state.
    type Y: Vector;
    /// Values of all event functions.
    type Events: Vector;
    /// How the course may end without an event.
    type End;

    /// The derivative of a state.
    fn rate(&self, y: &Self::Y) -> Self::Y;

    /// The event functions: positive, or leaving zero upwards, as long as the equations hold. One that is no number is not looked at.
    fn events(&self, y: &Self::Y) -> Self::Events;

    /// How fast an event function changes along the course, where that is known; else secants find it.
    fn slope(&self, _event: usize, _y: &Self::Y) -> Option<f64> {
        None
    }

    /// The end of the course where no step has to be made any more, because it is known in another way. Asked before each step.
    fn end(&self, _y: &Self::Y, _rate: &Self::Y) -> Option<Self::End> {
        None
    }

    /// The longest step to try from a state.
    fn longest(&self, _y: &Self::Y, _rate: &Self::Y) -> f64 {
        f64::INFINITY
    }
}

/// How steps are made.
///
/// # Example
/// See [`follow`].
#[derive(Clone, Copy, Debug)]
pub struct Pace<Y> {
    /// The first step.
    pub first: f64,
    /// What a step may err by.
    pub tolerance: Y,
    /// A step that has to be shorter than this is not made: [`Lost::Short`].
    pub shortest: f64,
    /// Errors of steps of this length or less, and up to this number of tolerances, are rounding: shorter steps would not help.
    pub noise: Option<[f64; 2]>,
    /// Steps, the refused ones too, after which the course is given up: [`Lost::Steps`].
    pub most_steps: usize,
}

impl<Y: Vector> Pace<Y> {
    /// The length to go on with after a step whose error is rounding; `None` where it is not.
    fn short(&self, length: f64, error: f64) -> Option<f64> {
        self.noise.filter(|[short, most]| length <= *short && error <= *most).map(|[short, _]| short)
    }
}

/// Where a course was left.
///
/// # Example
/// See [`follow`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop<Y, End> {
    /// An event function fell through zero.
    Event {
        /// Which one.
        event: usize,
        /// The state there: the end of a step.
        y: Y,
    },
    /// [`Course::end`] knew the rest.
    End(End),
}

/// Why a course has no end.
///
/// # Example
/// A course without events is given up by its budget.
/// ```
/// use carom_num::course::{Course, Lost, Pace, follow};
/// struct Rest;
/// impl Course for Rest {
///     type Y = [f64; 1];
///     type Events = [f64; 0];
///     type End = ();
///     fn rate(&self, _: &[f64; 1]) -> [f64; 1] {
///         [0.0]
///     }
///     fn events(&self, _: &[f64; 1]) -> [f64; 0] {
///         []
///     }
/// }
/// let pace = Pace { first: 1.0, tolerance: [1e-9], shortest: 0.0, noise: None, most_steps: 10 };
/// assert_eq!(follow(&Rest, [0.0], &pace), Err(Lost::Steps));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lost {
    /// No event within [`Pace::most_steps`].
    Steps,
    /// Steps would have to be shorter than [`Pace::shortest`].
    Short,
}

/// Follows a course to its first event, or to where its end is known.
///
/// # Errors
/// [`Lost`]: a budget by its name.
///
/// # Guarantees
/// Those of [`first_fall`], for each event function on each step. The place of an event is as exact as a step of its length.
///
/// # Example
/// A ball that falls from 20 m at 10 m/s² is down after 2 s.
/// ```
/// use carom_num::course::{Course, Pace, Stop, follow};
/// struct Falling;
/// impl Course for Falling {
///     /// Height, speed, time.
///     type Y = [f64; 3];
///     type Events = [f64; 1];
///     type End = ();
///     fn rate(&self, y: &[f64; 3]) -> [f64; 3] {
///         [y[1], -10.0, 1.0]
///     }
///     fn events(&self, y: &[f64; 3]) -> [f64; 1] {
///         [y[0]]
///     }
/// }
/// let pace = Pace { first: 0.1, tolerance: [1e-9; 3], shortest: 0.0, noise: None, most_steps: 100 };
/// let Ok(Stop::Event { event: 0, y }) = follow(&Falling, [20.0, 0.0, 0.0], &pace) else { panic!("it falls") };
/// assert!((y[2] - 2.0).abs() < 1e-12 && (y[1] + 20.0).abs() < 1e-11);
/// ```
pub fn follow<C: Course>(course: &C, mut y: C::Y, pace: &Pace<C::Y>) -> Result<Stop<C::Y, C::End>, Lost> {
    let rates = |y: &C::Y| course.rate(y);
    let (mut rate, mut length) = (rates(&y), pace.first);
    if let Some(end) = course.end(&y, &rate) {
        return Ok(Stop::End(end));
    }
    for _ in 0..pace.most_steps {
        length = length.min(course.longest(&y, &rate));
        let trial = step_plain(y, rate, length, rates);
        let error = trial.scaled_error(&pace.tolerance);
        let short = pace.short(length, error);
        if (error > 1.0 || error.is_nan()) && short.is_none() {
            length *= if error.is_nan() { LOST_STEP } else { length_factor(error) };
            if length <= pace.shortest {
                return Err(Lost::Short);
            }
            continue;
        }
        let step = trial.with_dense(rates(&trial.end), rates);
        if let Some(fall) = first_fall(&mut |x| course.events(&step.at(x))) {
            return Ok(Stop::Event { event: fall.of, y: reach(course, &step, (fall.of, fall.at)) });
        }
        (y, rate) = (step.end, step.end_rate);
        length = short.unwrap_or(step.length * length_factor(error));
        if let Some(end) = course.end(&y, &rate) {
            return Ok(Stop::End(end));
        }
    }
    Err(Lost::Steps)
}

/// Steps to an event near a fraction of a step: the end of the step that ends there.
fn reach<C: Course>(course: &C, step: &Step<C::Y>, (event, x): (usize, f64)) -> C::Y {
    let to = |length: f64| -> Trial<C::Y> {
        step_plain(step.start, step.start_rate, length, |y: &C::Y| course.rate(y))
    };
    let value = |y: &C::Y| course.events(y).at(event);
    let mut end = to(x * step.length).end;
    let mut now = (x * step.length, value(&end));
    let mut before = None;
    for _ in 0..MOST_CORRECTIONS {
        let slope = course.slope(event, &end).unwrap_or_else(|| {
            // The first secant needs a second place near by.
            let near = || (x - EVENT_SECANT).max(0.5 * x);
            let (at, was) = before.unwrap_or_else(|| (near() * step.length, value(&step.at(near()))));
            (now.1 - was) / (now.0 - at)
        });
        let correction = -now.1 / slope;
        // The dense output is not that far from the course: what is left of the function is rounding.
        let astray = correction.abs() > EVENT_ASTRAY * step.length;
        if !correction.is_finite() || astray || correction.abs() <= EVENT_ARRIVED * step.length {
            break;
        }
        before = Some(now);
        let length = now.0 + correction;
        end = to(length).end;
        now = (length, value(&end));
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elementary::sin_cos;

    /// An oscillator (position, velocity, time) whose events are these functions of it.
    struct Oscillator<E>(E);

    impl<const K: usize, E: Fn(&[f64; 3]) -> [f64; K]> Course for Oscillator<E> {
        type Y = [f64; 3];
        type Events = [f64; K];
        type End = ();

        fn rate(&self, y: &[f64; 3]) -> [f64; 3] {
            [y[1], -y[0], 1.0]
        }

        fn events(&self, y: &[f64; 3]) -> [f64; K] {
            (self.0)(y)
        }
    }

    fn pace(first: f64) -> Pace<[f64; 3]> {
        Pace { first, tolerance: [1e-9; 3], shortest: 1e-6, noise: None, most_steps: 100 }
    }

    /// Both ends of the step see the function positive: only what happens between tells.
    #[test]
    fn a_function_that_falls_and_rises_within_one_step_is_found() {
        for depth in [1e-2, 1e-4, 1e-6] {
            let dips = Oscillator(|y: &[f64; 3]| [1.0 - depth - y[0]]);
            let Ok(Stop::Event { event: 0, y }) = follow(&dips, [0.0, 1.0, 0.0], &pace(2.5)) else {
                panic!("it dips by {depth}")
            };
            // sin t = 1 − depth, on the way up.
            let (sin, _) = sin_cos(y[2]);
            assert!((sin - 1.0 + depth).abs() < 1e-8 && y[2] < std::f64::consts::FRAC_PI_2, "{depth}: {y:?}");
        }
    }

    #[test]
    fn of_two_events_in_one_step_the_first_ends_the_course() {
        let both = Oscillator(|y: &[f64; 3]| [0.9 - y[2], 0.8 - y[2]]);
        let Ok(Stop::Event { event, y }) = follow(&both, [0.0, 1.0, 0.0], &pace(1.0)) else {
            panic!("both fall")
        };
        assert!(event == 1 && (y[2] - 0.8).abs() < 1e-12, "{event} at {y:?}");
    }

    #[test]
    fn budgets_end_by_name() {
        let none = Oscillator(|_: &[f64; 3]| [1.0]);
        assert_eq!(follow(&none, [0.0, 1.0, 0.0], &pace(0.1)), Err(Lost::Steps));
        let tight = Pace { tolerance: [1e-60; 3], ..pace(0.1) };
        assert_eq!(follow(&none, [0.0, 1.0, 0.0], &tight), Err(Lost::Short));
    }
}
