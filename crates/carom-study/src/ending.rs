//! How a drop ends, as far as studies tell drops apart.

use carom_feeder::{Feeder, Outcome, Run, Verdict};
use carom_motion::planar::Options;
use std::fmt;

/// How a part's drop ends on the plate that a study looks at.
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
    pub fn of(run: &Run, plate: usize) -> Self {
        match run.landings.iter().find(|landing| landing.plate == plate) {
            Some(landing) => landing.verdict.map_or(Self::Stays, Self::Lies),
            None => Self::Otherwise(run.outcome),
        }
    }

    /// The ending whose words these are, as it is displayed; `None` where there is none.
    pub fn of_words(words: &str) -> Option<Self> {
        let face = words.strip_prefix("face ").and_then(|number| number.parse().ok()).map(Verdict::Face);
        let lies = [Verdict::Same, Verdict::Turned].into_iter().chain(face).map(Self::Lies);
        let otherwise = Outcome::ALL.into_iter().map(Self::Otherwise);
        let mut all = lies.chain(otherwise).chain([Self::Stays, Self::Impossible, Self::Failed]);
        all.find(|ending| ending.to_string() == words)
    }

    /// True where the part came to lie on the plate, or stayed on it.
    pub fn arrives(self) -> bool {
        matches!(self, Self::Lies(_) | Self::Stays)
    }

    /// A letter or two, for inside a region: no two endings differ by case alone.
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
#[derive(Clone, Debug, PartialEq)]
pub struct Dropped {
    /// How it ends on the plate that the study looks at.
    pub ending: Ending,
    /// The run, without a trace; `None` where there was none.
    pub run: Option<Run>,
}

impl Dropped {
    /// Drops the part once; `None` stands for a drawing that makes no feeder. `plate` is the number of the plate that is looked at.
    pub fn of(feeder: Option<&Feeder>, plate: usize, options: &Options) -> Self {
        let Some(feeder) = feeder else { return Self { ending: Ending::Impossible, run: None } };
        match feeder.prepare(*options).map(|prepared| prepared.verdict()) {
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
