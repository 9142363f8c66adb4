//! How a drop ends, as far as studies tell drops apart.

use crate::device::{Device, Landed};
use carom_feeder::{Feeder, Outcome, Run, RunError, Verdict};
use carom_motion::planar::Options;

/// How a part's drop ends on the plate that a study looks at.
///
/// # Example
/// A rod on a slope of 3 in 4: friction of 1 holds it, friction of 1/2 does not.
/// ```
/// use carom_feeder::{Outcome, examples};
/// use carom_motion::planar::Options;
/// use carom_study::{Dropped, Ending};
/// let slope = examples::rod_on_a_slope;
/// let ending = |friction| Dropped::of(Some(&slope(friction)), 0, &Options::default()).ending;
/// assert_eq!(ending(1.0), Ending::Otherwise(Outcome::Stuck));
/// assert_eq!(ending(0.5), Ending::Otherwise(Outcome::Delivered));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ending {
    /// It lies flat on the plate: on which side.
    Lies(Verdict),
    /// A disc stays on the plate: it has no flat side.
    Stays,
    /// It never lies flat on the plate; how the run ends.
    Otherwise(Outcome),
    /// There is no such feeder: what is drawn cannot be.
    Impossible,
    /// A fault of the numbers.
    Failed,
}

impl Ending {
    /// How a run ends on one of its plates.
    ///
    /// # Example
    /// A disc that falls on a tray stays there; it never lies on the slope above.
    /// ```
    /// use carom_feeder::{Outcome, examples};
    /// use carom_study::Ending;
    /// let feeder = examples::disc_above_a_tray();
    /// let run = feeder.run_untraced().unwrap();
    /// assert_eq!(Ending::of(&run, 1), Ending::Stays);
    /// assert_eq!(Ending::of(&run, 0), Ending::Otherwise(Outcome::Landed));
    /// ```
    pub fn of(run: &impl Landed, plate: usize) -> Self {
        match run.landings().iter().find(|landing| landing.plate == plate) {
            Some(landing) => landing.verdict.map_or(Self::Stays, Self::Lies),
            None => Self::Otherwise(run.outcome()),
        }
    }

    /// True where the part came to lie on the plate, or stayed on it.
    ///
    /// # Example
    /// ```
    /// use carom_feeder::{Outcome, Verdict};
    /// use carom_study::Ending;
    /// assert!(Ending::Lies(Verdict::Turned).arrives() && Ending::Stays.arrives());
    /// assert!(!Ending::Otherwise(Outcome::Missed).arrives());
    /// ```
    pub fn arrives(self) -> bool {
        matches!(self, Self::Lies(_) | Self::Stays)
    }
}

/// What a study keeps of one drop.
///
/// # Example
/// A disc slides 2 m down at 6 m/s², then falls 1.25 m: it strikes with `√(2·6·2 + 2·10·1.25)`, 7 m/s.
/// ```
/// use carom_feeder::examples;
/// use carom_motion::planar::Options;
/// let feeder = examples::disc_above_a_tray();
/// let dropped = carom_study::Dropped::of(Some(&feeder), 1, &Options::default());
/// assert_eq!(dropped.ending, carom_study::Ending::Stays);
/// assert!((dropped.impact_speed(1).unwrap() - 7.0).abs() < 1e-12);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Dropped<R = Run> {
    /// How it ends on the plate that the study looks at.
    pub ending: Ending,
    /// The run, without a trace; `None` where there was none.
    pub run: Option<R>,
}

impl Dropped {
    /// Drops the part once. A feeder of `None` stands for a drawing that makes no feeder. `plate` is the number of the plate that is looked at.
    ///
    /// # Example
    /// Of no drawing comes no run.
    /// ```
    /// use carom_motion::planar::Options;
    /// use carom_study::{Dropped, Ending};
    /// let dropped = Dropped::of(None, 0, &Options::default());
    /// assert_eq!((dropped.ending, dropped.run), (Ending::Impossible, None));
    /// ```
    pub fn of(feeder: Option<&Feeder>, plate: usize, options: &Options) -> Self {
        let Some(feeder) = feeder else { return Self { ending: Ending::Impossible, run: None } };
        match feeder.prepare(*options).map(|prepared| prepared.run_untraced()) {
            Err(_) => Self { ending: Ending::Impossible, run: None },
            Ok(Err(_)) => Self { ending: Ending::Failed, run: None },
            Ok(Ok(run)) => Self { ending: Ending::of(&run, plate), run: Some(run) },
        }
    }
}

impl<R: Landed> Dropped<R> {
    /// Drops a part through a feeder, in the plane or in space; `None` where what is drawn cannot be.
    ///
    /// # Example
    /// ```
    /// use carom_feeder::spatial::examples;
    /// use carom_study::{Dropped, Ending};
    /// let drop = Dropped::through(Some(&examples::two_plates()), 1);
    /// assert_eq!(drop.ending, Ending::Lies(carom_feeder::Verdict::Same));
    /// ```
    pub fn through<D: Device<Run = R>>(device: Option<&D>, plate: usize) -> Self {
        let Some(device) = device else { return Self { ending: Ending::Impossible, run: None } };
        match device.drop_part() {
            Ok(run) => Self { ending: Ending::of(&run, plate), run: Some(run) },
            Err(RunError::Problems(_)) => Self { ending: Ending::Impossible, run: None },
            Err(_) => Self { ending: Ending::Failed, run: None },
        }
    }

    /// Speed of the striking point when it first strikes a plate [m/s]; `None` where it never touches it.
    pub fn impact_speed(&self, plate: usize) -> Option<f64> {
        let landings = self.run.iter().flat_map(Landed::landings);
        landings.filter(|landing| landing.plate == plate).map(|landing| landing.impact_speed).next()
    }

    /// When the part first lies flat on a plate [s].
    pub fn flat(&self, plate: usize) -> Option<f64> {
        let landings = self.run.iter().flat_map(Landed::landings);
        landings.filter(|landing| landing.plate == plate).find_map(|landing| landing.flat)
    }

    /// The smallest decided inequality of the run, scaled.
    pub fn margin(&self) -> Option<f64> {
        self.run.as_ref().map(Landed::margin).filter(|margin| margin.is_finite())
    }
}
