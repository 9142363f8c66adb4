//! A smooth course, followed to its first event.
//!
//! [`walk`] is the loop. It makes step after step of a [`Stepper`] and searches each for its first event, until one happens, the end is known, or a budget is
//! spent. A stepper that knows its steps as series in time needs nothing more.
//!
//! A [`Course`] is a system of equations and the functions that are positive as long as they hold. [`follow`] makes a stepper of it: it makes [steps](step) of
//! [order 8](crate::ode8) within a tolerance, asks the course for the first event in the dense output of each, and steps TO the event: the end is that of a step, not of
//! an interpolant.

mod reach;
mod stepper;

pub use reach::{Found, placed};
pub use stepper::{Lost, Stepper, Stop, Walked, walk};

use crate::ode8::{Step, Trial, Vector, length_factor, step_plain};
use reach::reach;

/// What a step is multiplied by whose error is no number.
const LOST_STEP: f64 = 0.2;

/// Equations and what ends them.
///
/// The methods take the course itself, so that it may count what it does, keep what it has seen, and show its steps.
///
/// # Example
/// See [`follow`].
pub trait Course {
    /// The state.
    type Y: Vector;
    /// What may happen.
    type Event: Copy;
    /// How the course may end without an event.
    type End;

    /// The derivative of a state.
    fn rate(&mut self, y: &Self::Y) -> Self::Y;

    /// The derivative at the end of a step that is good enough: the same, unless more is wanted there.
    fn end_rate(&mut self, y: &Self::Y) -> Self::Y {
        self.rate(y)
    }

    /// The first event within a step.
    ///
    /// # Errors
    /// [`Lost::Number`] where an event function is no number that should be one.
    fn first_event(&mut self, step: &Step<Self::Y>) -> Result<Option<Found<Self::Event>>, Lost>;

    /// The function of an event, this long after the start of the present step: positive, or leaving zero upwards, until the event.
    fn value(&mut self, event: &Self::Event, after: f64, y: &Self::Y) -> f64;

    /// How fast that function changes along the course, where that is known; else secants find it.
    fn slope(&mut self, _event: &Self::Event, _after: f64, _y: &Self::Y) -> Option<f64> {
        None
    }

    /// The end of the course where no step has to be made any more. Asked before each step.
    fn end(&mut self, _y: &Self::Y, _rate: &Self::Y) -> Option<Self::End> {
        None
    }

    /// How steps are made from a state.
    fn pace(&self, y: &Self::Y, rate: &Self::Y) -> Pace<Self::Y>;

    /// A step and the length of the next one. `length` is what the last step has left, and `pace` that of the state.
    ///
    /// # Errors
    /// [`Lost`].
    fn step(
        &mut self,
        from: (&Self::Y, &Self::Y),
        length: f64,
        pace: &Pace<Self::Y>,
    ) -> Result<(Step<Self::Y>, f64), Lost> {
        step(self, from, length, pace)
    }

    /// An explicit step that is tried, and whether a number was lost in it.
    fn tried(&mut self, (y, rate): (&Self::Y, &Self::Y), length: f64) -> (Trial<Self::Y>, bool) {
        (step_plain(*y, *rate, length, |y| self.rate(y)), false)
    }

    /// True where a state near an event may be moved on by explicit steps; false where the equations are stiff.
    fn is_smooth(&self, _step: &Step<Self::Y>) -> bool {
        true
    }

    /// The end of a step of another length from the same start.
    fn step_to(&mut self, step: &Step<Self::Y>, length: f64) -> Self::Y {
        explicit_end(self, step, length)
    }

    /// Goes to the end of a step in which nothing happens; the state to go on from, with what has drifted taken back.
    fn passed(&mut self, step: Step<Self::Y>) -> Self::Y {
        step.end
    }
}

/// How steps are made.
///
/// # Example
/// See [`follow`].
#[derive(Clone, Copy, Debug)]
pub struct Pace<Y> {
    /// What a step may err by.
    pub tolerance: Y,
    /// The longest step to try.
    pub longest: f64,
    /// A step that is refused is not tried again shorter than this: [`Lost::Short`].
    pub shortest: f64,
    /// Errors of steps of this length or less, and up to this number of tolerances, are rounding: shorter steps would not help.
    pub noise: Option<[f64; 2]>,
    /// Where the course stands on its own clock: lengths below the last digit of that are rounding.
    pub clock: f64,
}

impl<Y: Vector> Pace<Y> {
    /// Steps of any length within a tolerance, on a clock that starts anew with each.
    ///
    /// # Example
    /// ```
    /// let pace = carom_num::course::Pace::within([1e-9; 2]);
    /// assert_eq!((pace.longest, pace.shortest), (f64::INFINITY, 0.0));
    /// ```
    pub fn within(tolerance: Y) -> Self {
        Self { tolerance, longest: f64::INFINITY, shortest: 0.0, noise: None, clock: 0.0 }
    }

    /// The length to go on with after a step whose error is rounding; `None` where it is not.
    fn short(&self, length: f64, error: f64) -> Option<f64> {
        self.noise.filter(|[short, most]| length <= *short && error <= *most).map(|[short, _]| short)
    }
}

/// An event, and where a course meets it.
///
/// # Example
/// See [`follow`].
#[derive(Clone, Copy, Debug)]
pub struct Reached<Y, Event> {
    /// What happens.
    pub event: Event,
    /// How long after the start of the step in which it happens.
    pub length: f64,
    /// The state there: the end of a step.
    pub y: Y,
}

/// Where a course was left, and the step in which something happened, as it was made.
pub type Followed<C> =
    Stop<Step<<C as Course>::Y>, Reached<<C as Course>::Y, <C as Course>::Event>, <C as Course>::End>;

/// Follows a course from a state, and the derivative there, to its first event or to where its end is known. `first` is the length of the first step. At
/// most `most_steps` are made; those that are refused do not count.
///
/// # Errors
/// [`Lost`]: a budget by its name.
///
/// # Guarantees
/// Those of [`Course::first_event`], for which [`first_fall`](crate::falls::first_fall) is made. The place of an event is as exact as a step of its length.
///
/// # Example
/// A ball that falls from 20 m at 10 m/s² is down after 2 s.
/// ```
/// use carom_num::course::{Course, Found, Lost, Pace, Stop, follow};
/// use carom_num::falls::first_fall;
/// use carom_num::ode8::Step;
/// struct Falling;
/// impl Course for Falling {
///     /// Height, speed.
///     type Y = [f64; 2];
///     type Event = usize;
///     type End = ();
///     fn rate(&mut self, y: &[f64; 2]) -> [f64; 2] {
///         [y[1], -10.0]
///     }
///     fn first_event(&mut self, step: &Step<[f64; 2]>) -> Result<Option<Found<usize>>, Lost> {
///         let fall = first_fall(&mut |x| [step.at(x)[0]]);
///         Ok(fall.map(|fall| Found::at(fall.at, fall.of)))
///     }
///     fn value(&mut self, _: &usize, _: f64, y: &[f64; 2]) -> f64 {
///         y[0]
///     }
///     fn pace(&self, _: &[f64; 2], _: &[f64; 2]) -> Pace<[f64; 2]> {
///         Pace::within([1e-9; 2])
///     }
/// }
/// let end = follow(&mut Falling, ([20.0, 0.0], [0.0, -10.0]), 4.0, 100);
/// let Ok(Stop::Event { event, .. }) = end else { panic!("it falls") };
/// assert!((event.length - 2.0).abs() < 1e-12 && (event.y[1] + 20.0).abs() < 1e-11);
/// ```
pub fn follow<C: Course>(
    course: &mut C,
    (y, rate): (C::Y, C::Y),
    first: f64,
    most_steps: usize,
) -> Result<Followed<C>, Lost> {
    walk(&mut Integration { course, y, rate, length: first, pace: None }, most_steps)
}

/// A course from step to step.
struct Integration<'c, C: Course> {
    course: &'c mut C,
    y: C::Y,
    rate: C::Y,
    /// Of the next step.
    length: f64,
    /// Of the last step; `None` before the first.
    pace: Option<Pace<C::Y>>,
}

impl<C: Course> Stepper for Integration<'_, C> {
    type Step = Step<C::Y>;
    type Event = Reached<C::Y, C::Event>;
    type End = C::End;

    fn end(&mut self) -> Option<C::End> {
        self.course.end(&self.y, &self.rate)
    }

    fn step(&mut self) -> Result<Step<C::Y>, Lost> {
        let pace = self.course.pace(&self.y, &self.rate);
        let (step, next) = self.course.step((&self.y, &self.rate), self.length, &pace)?;
        (self.length, self.pace) = (next, Some(pace));
        Ok(step)
    }

    fn event(&mut self, step: &mut Step<C::Y>) -> Result<Option<Reached<C::Y, C::Event>>, Lost> {
        let found = self.course.first_event(step)?;
        Ok(found.map(|found| {
            let clock = self.pace.as_ref().map_or(0.0, |pace| pace.clock);
            let (length, y) = reach(self.course, step, &found, clock);
            Reached { event: found.event, length, y }
        }))
    }

    fn passed(&mut self, step: Step<C::Y>) {
        let (end, rate) = (step.end, step.end_rate);
        self.y = self.course.passed(step);
        // Drift that was taken back and is more than a step may err by takes its derivative along: the next step would think that it bends where it begins.
        let off = |pace: &Pace<C::Y>, i: usize| (self.y.at(i) - end.at(i)).abs() > pace.tolerance.at(i);
        let moved = self.pace.as_ref().is_some_and(|pace| (0..C::Y::COUNT).any(|i| off(pace, i)));
        self.rate = if moved { self.course.rate(&self.y) } else { rate };
    }
}

/// The end of an explicit step of another length from the same start.
///
/// # Example
/// See [`Course::step_to`], which is this unless a course knows better.
pub fn explicit_end<C: Course + ?Sized>(course: &mut C, step: &Step<C::Y>, length: f64) -> C::Y {
    step_plain(step.start, step.start_rate, length, |y| course.rate(y)).end
}

/// An explicit step whose error is within the tolerance, and the length to try next.
///
/// # Errors
/// [`Lost`].
///
/// # Example
/// See [`Course::step`], which is this unless a course knows better.
pub fn step<C: Course + ?Sized>(
    course: &mut C,
    from: (&C::Y, &C::Y),
    length: f64,
    pace: &Pace<C::Y>,
) -> Result<(Step<C::Y>, f64), Lost> {
    // Longer steps than any number have no error that could be told.
    let mut length = length.min(pace.longest).min(f64::MAX);
    // A last step may be as short as what is left.
    let shortest = pace.shortest.min(pace.longest);
    loop {
        let (trial, lost) = course.tried(from, length);
        let error = trial.scaled_error(&pace.tolerance);
        let short = pace.short(length, error);
        // A number that is lost on the way to a place too far off is lost with the step.
        if error <= 1.0 && !lost || short.is_some() {
            let end_rate = course.end_rate(&trial.end);
            let step = trial.with_dense(end_rate, |y| course.rate(y));
            return Ok((step, short.unwrap_or(length * length_factor(error))));
        }
        length *= if lost || !error.is_finite() { LOST_STEP } else { length_factor(error) };
        if length < shortest || length == 0.0 {
            return Err(if lost { Lost::Number } else { Lost::Short(length) });
        }
    }
}

#[cfg(test)]
mod tests;
