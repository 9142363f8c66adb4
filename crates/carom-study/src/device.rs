//! What studies drop parts through, and what they look at of a drop: in the plane and in space alike.

use carom_feeder::{Feeder, Landing, Outcome, Run, RunError, spatial};
use carom_impact::Law;

/// What studies look at of a run.
///
/// # Example
/// ```
/// use carom_feeder::{Outcome, examples};
/// use carom_study::Landed;
/// let run = examples::rod_on_a_slope(0.2).run_untraced()?;
/// assert_eq!((run.outcome(), run.landings().len()), (Landed::outcome(&run), run.landings.len()));
/// # Ok::<(), carom_feeder::RunError>(())
/// ```
pub trait Landed: Send + Sync {
    /// The plates on which the part came to lie, in their order.
    fn landings(&self) -> &[Landing];
    /// How it ended.
    fn outcome(&self) -> Outcome;
    /// The walls that the part touched.
    fn walls_touched(&self) -> &[usize];
    /// When it ended [s].
    fn end_time(&self) -> f64;
    /// The smallest decided inequality, relative; infinite where none is known.
    fn margin(&self) -> f64;
}

/// A feeder, in the plane or in space.
///
/// # Example
/// The same bar through the same plates, drawn wide.
/// ```
/// use carom_feeder::spatial::examples;
/// use carom_study::{Device, Landed};
/// let feeder = examples::two_plates();
/// assert_eq!(feeder.start_face(), 0);
/// let bouncing = feeder.with_law(carom_impact::Law::Poisson, 0.3);
/// assert!(bouncing.drop_part()?.end_time() > feeder.drop_part()?.end_time());
/// # Ok::<(), carom_feeder::RunError>(())
/// ```
pub trait Device: Clone + Send + Sync {
    /// What a drop says.
    type Run: Landed;
    /// The laws of restitution that it may have: in space Newton's is for one contact, and several strike.
    const LAWS: &'static [Law];
    /// Drops a part, without a trace.
    ///
    /// # Errors
    /// A feeder that cannot be run, a fault of the numbers.
    fn drop_part(&self) -> Result<Self::Run, RunError>;
    /// The face on which the part starts.
    fn start_face(&self) -> usize;
    /// The same under a law of restitution, every plate and wall with this coefficient.
    #[must_use]
    fn with_law(&self, law: Law, restitution: f64) -> Self;
}

impl Landed for Run {
    fn landings(&self) -> &[Landing] {
        &self.landings
    }

    fn outcome(&self) -> Outcome {
        self.outcome
    }

    fn walls_touched(&self) -> &[usize] {
        &self.walls_touched
    }

    fn end_time(&self) -> f64 {
        self.end_time
    }

    fn margin(&self) -> f64 {
        self.margin
    }
}

impl Landed for spatial::Run {
    fn landings(&self) -> &[Landing] {
        &self.landings
    }

    fn outcome(&self) -> Outcome {
        self.outcome
    }

    fn walls_touched(&self) -> &[usize] {
        &self.walls_touched
    }

    fn end_time(&self) -> f64 {
        self.end_time
    }

    fn margin(&self) -> f64 {
        f64::INFINITY
    }
}

impl Device for Feeder {
    type Run = Run;
    const LAWS: &'static [Law] = &[Law::Poisson, Law::Stronge, Law::Newton];

    fn drop_part(&self) -> Result<Run, RunError> {
        self.run_untraced()
    }

    fn start_face(&self) -> usize {
        self.start.face
    }

    fn with_law(&self, law: Law, restitution: f64) -> Self {
        let mut feeder = Self { law, ..self.clone() };
        feeder.plates.iter_mut().for_each(|plate| plate.restitution = restitution);
        feeder.walls.iter_mut().for_each(|wall| wall.restitution = restitution);
        feeder
    }
}

impl Device for spatial::Feeder {
    type Run = spatial::Run;
    const LAWS: &'static [Law] = &[Law::Poisson, Law::Stronge];

    fn drop_part(&self) -> Result<spatial::Run, RunError> {
        self.run_untraced()
    }

    fn start_face(&self) -> usize {
        self.start.face
    }

    fn with_law(&self, law: Law, restitution: f64) -> Self {
        let mut feeder = Self { law, ..self.clone() };
        feeder.plates.iter_mut().for_each(|plate| plate.restitution = restitution);
        feeder.walls.iter_mut().for_each(|wall| wall.restitution = restitution);
        feeder
    }
}
