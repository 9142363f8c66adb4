//! How a drop ends, as far as studies tell drops apart.

use carom_feeder::{Feeder, Outcome, Run, Verdict};
use carom_motion::planar::Options;
use std::fmt;

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
    pub fn of(run: &Run, plate: usize) -> Self {
        match run.landings.iter().find(|landing| landing.plate == plate) {
            Some(landing) => landing.verdict.map_or(Self::Stays, Self::Lies),
            None => Self::Otherwise(run.outcome),
        }
    }

    /// The ending whose words these are, as it is displayed; `None` where there is none.
    ///
    /// # Example
    /// ```
    /// use carom_feeder::Verdict;
    /// use carom_study::Ending;
    /// let third = Ending::Lies(Verdict::Face(3));
    /// assert_eq!(Ending::of_words(&third.to_string()), Some(third));
    /// assert_eq!(Ending::of_words("face of a coin"), None);
    /// ```
    pub fn of_words(words: &str) -> Option<Self> {
        let face = words.strip_prefix("face ").and_then(|number| number.parse().ok()).map(Verdict::Face);
        let lies = [Verdict::Same, Verdict::Turned].into_iter().chain(face).map(Self::Lies);
        let otherwise = Outcome::ALL.into_iter().map(Self::Otherwise);
        let mut all = lies.chain(otherwise).chain([Self::Stays, Self::Impossible, Self::Failed]);
        all.find(|ending| ending.to_string() == words)
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

    /// A letter or two, for inside a region: no two endings differ by case alone.
    ///
    /// # Example
    /// ```
    /// use carom_feeder::{Outcome, Verdict};
    /// use carom_study::Ending;
    /// let lies = [Verdict::Turned, Verdict::Face(3)].map(Ending::Lies);
    /// assert_eq!(lies.map(Ending::short), ["T", "3"]);
    /// assert_eq!(Ending::Otherwise(Outcome::OnEnd).short(), "oe");
    /// ```
    pub fn short(self) -> String {
        match self {
            Self::Lies(Verdict::Same) => "S".to_owned(),
            Self::Lies(Verdict::Turned) => "T".to_owned(),
            Self::Lies(Verdict::Face(face)) => face.to_string(),
            Self::Stays => "ok".to_owned(),
            Self::Otherwise(outcome) => match outcome.word().split_once('_') {
                Some((first, second)) => [first, second].iter().filter_map(|word| word.get(..1)).collect(),
                None => outcome.word().chars().take(2).collect(),
            },
            Self::Impossible => "-".to_owned(),
            Self::Failed => "!".to_owned(),
        }
    }
}

impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lies(verdict) => f.write_str(&verdict.words()),
            Self::Stays => f.write_str("stays on it"),
            Self::Otherwise(outcome) => f.write_str(&outcome.word().replace('_', " ")),
            Self::Impossible => f.write_str("no such feeder"),
            Self::Failed => f.write_str("failed"),
        }
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
pub struct Dropped {
    /// How it ends on the plate that the study looks at.
    pub ending: Ending,
    /// The run, without a trace; `None` where there was none.
    pub run: Option<Run>,
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

    /// Speed of the striking point when it first strikes a plate [m/s]; `None` where it never touches it.
    pub fn impact_speed(&self, plate: usize) -> Option<f64> {
        let landings = self.run.iter().flat_map(|run| &run.landings);
        landings.filter(|landing| landing.plate == plate).map(|landing| landing.impact_speed).next()
    }

    /// When the part first lies flat on a plate [s].
    pub fn flat(&self, plate: usize) -> Option<f64> {
        let landings = self.run.iter().flat_map(|run| &run.landings);
        landings.filter(|landing| landing.plate == plate).find_map(|landing| landing.flat)
    }

    /// The smallest decided inequality of the run, scaled.
    pub fn margin(&self) -> Option<f64> {
        self.run.as_ref().map(|run| run.margin).filter(|margin| margin.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_names_differ_by_more_than_case() {
        let mut endings = Outcome::ALL.map(Ending::Otherwise).to_vec();
        endings.extend([Verdict::Same, Verdict::Turned, Verdict::Face(1)].map(Ending::Lies));
        endings.extend([Ending::Stays, Ending::Impossible, Ending::Failed]);
        let mut short: Vec<String> = endings.iter().map(|ending| ending.short().to_lowercase()).collect();
        assert!(short.iter().all(|short| (1..=2).contains(&short.len())), "{short:?}");
        short.sort();
        short.dedup();
        assert_eq!(short.len(), endings.len(), "{short:?}");
    }

    #[test]
    fn every_ending_is_known_by_its_words() {
        for (number, outcome) in Outcome::ALL.into_iter().enumerate() {
            assert_eq!(outcome as usize, number, "each once, in its order");
        }
        assert_eq!(Outcome::ALL.last(), Some(&Outcome::Blocked), "the last one there is");
        let lies = [Verdict::Same, Verdict::Turned, Verdict::Face(0), Verdict::Face(12)].map(Ending::Lies);
        let others = [Ending::Stays, Ending::Impossible, Ending::Failed];
        for ending in lies.into_iter().chain(others).chain(Outcome::ALL.map(Ending::Otherwise)) {
            assert_eq!(Ending::of_words(&ending.to_string()), Some(ending));
        }
        for words in ["mine", "", "face", "face 07", "face x", "stuck "] {
            assert_eq!(Ending::of_words(words), None, "{words}");
        }
    }
}
