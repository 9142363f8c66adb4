//! What studies drop parts through, and what they look at of a drop: in the plane and in space alike.

use crate::design::Pace;
use carom_feeder::{Feeder, Landing, Outcome, Run, RunError, Stop, spatial};
use carom_impact::Law;
use carom_num::Vec2;

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
    type Run: Landed + Clone;
    /// The laws of restitution that it may have: in space Newton's is for one contact, and several strike.
    const LAWS: &'static [Law];
    /// How many drops a search for a layout takes.
    const PACE: Pace;
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
    /// The drop until the part leaves the last plate or rests, whatever [`Stop`] the feeder has; without a trace. `None` for a fault of the numbers.
    ///
    /// # Example
    /// A disc that has landed slides on without friction, and leaves the tray: 9 m and the part of it that it
    /// fell along, at `0.8 √24` m/s.
    /// ```
    /// use carom_feeder::{Outcome, examples};
    /// use carom_study::Device;
    /// let feeder = examples::disc_above_a_tray();
    /// let (landed, gone) = (feeder.drop_part()?, feeder.to_the_end().unwrap());
    /// assert_eq!((landed.outcome, gone.outcome), (Outcome::Landed, Outcome::Delivered));
    /// // From where its centre left the slope, 0.036 m beyond the edge.
    /// let speed = 0.8 * 24f64.sqrt();
    /// assert!((gone.end_time - (24f64.sqrt() / 6.0 + (9.0 - 0.036) / speed)).abs() < 1e-9);
    /// # Ok::<(), carom_feeder::RunError>(())
    /// ```
    fn to_the_end(&self) -> Option<Self::Run>;
    /// Pairs of plates that cross, by their numbers: such a feeder cannot be built. In space those whose middle lines cross in the drawing.
    fn crossing_plates(&self) -> Vec<(usize, usize)>;
    /// The plates, each with its ends in the drawing \[m\]; `None` of one that is as long as needed.
    fn plate_ends(&self) -> Vec<Option<[Vec2; 2]>>;

    /// How wide and how high the plates are together in the drawing \[m\]; plates as long as needed do not count.
    ///
    /// # Example
    /// ```
    /// use carom_feeder::examples;
    /// use carom_study::Device;
    /// let [width, height] = examples::disc_above_a_tray().extent();
    /// assert!(width > height && height > 0.0);
    /// ```
    fn extent(&self) -> [f64; 2] {
        let points: Vec<Vec2> = self.plate_ends().into_iter().flatten().flatten().collect();
        let span = |of: fn(&Vec2) -> f64| {
            let (low, high) = points
                .iter()
                .map(of)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
            (high - low).max(0.0)
        };
        [span(|p| p.x), span(|p| p.y)]
    }
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
    const PACE: Pace = Pace::IN_THE_PLANE;

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
    fn to_the_end(&self) -> Option<Run> {
        Self { stop: Stop::Delivered, ..self.clone() }.run_untraced().ok()
    }

    fn crossing_plates(&self) -> Vec<(usize, usize)> {
        self.crossing_plates()
    }

    fn plate_ends(&self) -> Vec<Option<[Vec2; 2]>> {
        let ends = self.plates.iter().map(|plate| (!plate.unbounded).then_some([plate.uphill, plate.edge]));
        ends.collect()
    }
}

impl Device for spatial::Feeder {
    type Run = spatial::Run;
    const LAWS: &'static [Law] = &[Law::Poisson, Law::Stronge];
    const PACE: Pace = Pace::IN_SPACE;

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
    fn to_the_end(&self) -> Option<spatial::Run> {
        Self { stop: Stop::Delivered, ..self.clone() }.run_untraced().ok()
    }

    fn crossing_plates(&self) -> Vec<(usize, usize)> {
        self.crossing_plates()
    }

    fn plate_ends(&self) -> Vec<Option<[Vec2; 2]>> {
        let ends = self.plates.iter().map(|plate| (!plate.unbounded).then_some([plate.uphill, plate.edge]));
        ends.collect()
    }
}
