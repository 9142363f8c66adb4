//! The loop of every walk: step after step, each looked through for the first event.

/// What goes on in steps until something happens.
///
/// # Example
/// See [`walk`].
pub trait Stepper {
    /// A step.
    type Step;
    /// What may happen.
    type Event;
    /// How it may end without an event.
    type End;

    /// The end where no step has to be made any more. Asked before each step.
    fn end(&mut self) -> Option<Self::End>;

    /// The next step.
    ///
    /// # Errors
    /// [`Lost`].
    fn step(&mut self) -> Result<Self::Step, Lost>;

    /// The first event within a step, which then is what ends there.
    ///
    /// # Errors
    /// [`Lost::Number`] where an event function is no number that should be one.
    fn event(&mut self, step: &mut Self::Step) -> Result<Option<Self::Event>, Lost>;

    /// Goes to the end of a step in which nothing happens.
    fn passed(&mut self, step: Self::Step);
}

/// Walks to the first event, or to where the end is known, in at most `most_steps` steps.
///
/// # Errors
/// [`Lost`]: a budget by its name.
///
/// # Example
/// Whole numbers, until the first whose square is above 50.
/// ```
/// use carom_num::course::{Lost, Stepper, Stop, walk};
/// struct Count(u32);
/// impl Stepper for Count {
///     type Step = ();
///     type Event = u32;
///     type End = ();
///     fn end(&mut self) -> Option<()> {
///         None
///     }
///     fn step(&mut self) -> Result<(), Lost> {
///         Ok(())
///     }
///     fn event(&mut self, (): &mut ()) -> Result<Option<u32>, Lost> {
///         Ok((self.0 * self.0 > 50).then_some(self.0))
///     }
///     fn passed(&mut self, (): ()) {
///         self.0 += 1;
///     }
/// }
/// assert!(matches!(walk(&mut Count(1), 100), Ok(Stop::Event { event: 8, .. })));
/// assert!(matches!(walk(&mut Count(1), 5), Err(Lost::Steps)));
/// ```
pub fn walk<S: Stepper>(stepper: &mut S, most_steps: usize) -> Result<Walked<S>, Lost> {
    for _ in 0..most_steps {
        if let Some(end) = stepper.end() {
            return Ok(Stop::End(end));
        }
        let mut step = stepper.step()?;
        if let Some(event) = stepper.event(&mut step)? {
            return Ok(Stop::Event { event, step });
        }
        stepper.passed(step);
    }
    stepper.end().map(Stop::End).ok_or(Lost::Steps)
}

/// Where a walk was left.
///
/// # Example
/// See [`walk`].
#[derive(Clone, Copy, Debug)]
pub enum Stop<Step, Event, End> {
    /// Something happened.
    Event {
        /// What.
        event: Event,
        /// The step in which it happened.
        step: Step,
    },
    /// [`Stepper::end`] knew the rest.
    End(End),
}

/// Where a stepper was left.
pub type Walked<S> = Stop<<S as Stepper>::Step, <S as Stepper>::Event, <S as Stepper>::End>;

/// Why a walk has no end.
///
/// # Example
/// See [`walk`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lost {
    /// No event within the steps that were allowed.
    Steps,
    /// Steps would have to be shorter than [`Pace::shortest`](super::Pace::shortest): the length that would come next.
    Short(f64),
    /// A number was lost, as the course has told, and a shorter step does not bring it back. A rate that is no number by itself ends as [`Lost::Short`].
    Number,
}
