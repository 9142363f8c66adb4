//! How drops end, as maps, yields and feeds name it.

use crate::Words;
use crate::run::side;
use carom_feeder::{Outcome, Verdict};
use carom_study::poses::{Pose, Spent};
use carom_study::yields::Estimate;
use carom_study::{Ending, feeds};

/// How a run ended, in words: `on end`.
pub fn outcome(outcome: Outcome) -> String {
    outcome.word().replace('_', " ")
}

/// How a drop ended on the plate that a study looks at: `turned`, `face 2`, `stuck`.
///
/// # Example
/// ```
/// use carom_study::Ending;
/// assert_eq!(carom_words::study::ending(Ending::Stays), "stays on it");
/// ```
pub fn ending(ending: Ending) -> String {
    match ending {
        Ending::Lies(verdict) => side(verdict),
        Ending::Stays => "stays on it".to_owned(),
        Ending::Otherwise(outcome) => self::outcome(outcome),
        Ending::Impossible => "no such feeder".to_owned(),
        Ending::Failed => "failed".to_owned(),
    }
}

/// A share and its interval, in percent: `98.53`, `98.31 to 98.75`.
///
/// # Example
/// ```
/// use carom_study::yields::Estimate;
/// let half = Estimate { share: 0.5, low: 0.4, high: 0.6, count: 128 };
/// assert_eq!(carom_words::study::percent(&half), ["50.00", "40.00 to 60.00"]);
/// ```
pub fn percent(estimate: &Estimate) -> [String; 2] {
    let show = |share: f64| format!("{:.2}", 100.0 * share);
    [show(estimate.share), format!("{} to {}", show(estimate.low), show(estimate.high))]
}

/// The same in one: `98.53 % (98.31 to 98.75)`.
pub fn percent_with_interval(estimate: &Estimate) -> String {
    let [share, interval] = percent(estimate);
    format!("{share} % ({interval})")
}

/// Every ending but those on a face by its number.
pub fn endings() -> impl Iterator<Item = Ending> {
    let lies = [Verdict::Same, Verdict::Turned].map(Ending::Lies);
    let otherwise = Outcome::ALL.iter().copied().map(Ending::Otherwise);
    lies.into_iter().chain(otherwise).chain([Ending::Stays, Ending::Impossible, Ending::Failed])
}

/// The ending whose words these are; `None` where there is none.
///
/// # Example
/// ```
/// use carom_feeder::Verdict;
/// use carom_study::Ending;
/// use carom_words::study::{ending, ending_of};
/// let third = Ending::Lies(Verdict::Face(3));
/// assert_eq!(ending_of(&ending(third)), Some(third));
/// assert_eq!(ending_of("face of a coin"), None);
/// ```
pub fn ending_of(words: &str) -> Option<Ending> {
    let face = words.strip_prefix("face ").and_then(|number| number.parse().ok());
    let face = face.map(|face| Ending::Lies(Verdict::Face(face)));
    face.into_iter().chain(endings()).find(|found| ending(*found) == words)
}

/// A letter or two, for inside a region: no two endings differ by case alone.
///
/// # Example
/// ```
/// use carom_feeder::{Outcome, Verdict};
/// use carom_study::Ending;
/// use carom_words::study::letters;
/// assert_eq!(letters(Ending::Lies(Verdict::Turned)), "T");
/// assert_eq!(letters(Ending::Otherwise(Outcome::OnEnd)), "oe");
/// ```
pub fn letters(ending: Ending) -> String {
    match ending {
        Ending::Lies(Verdict::Same) => "S".to_owned(),
        Ending::Lies(Verdict::Turned) => "T".to_owned(),
        Ending::Lies(Verdict::Face(face)) => face.to_string(),
        Ending::Stays => "ok".to_owned(),
        Ending::Otherwise(outcome) => match outcome.word().split_once('_') {
            Some((first, second)) => [first, second].iter().filter_map(|word| word.get(..1)).collect(),
            None => outcome.word().chars().take(2).collect(),
        },
        Ending::Impossible => "-".to_owned(),
        Ending::Failed => "!".to_owned(),
    }
}

/// What happens in a feed, in words.
///
/// # Example
/// ```
/// assert_eq!(carom_words::study::feed(carom_study::feeds::Kind::Free), "no touch");
/// ```
pub fn feed(kind: feeds::Kind) -> &'static str {
    match kind {
        feeds::Kind::Free => "no touch",
        feeds::Kind::Harmless => "touch, all end as wanted",
        feeds::Kind::Harmful => "touch, a part ends otherwise",
        feeds::Kind::Touching => "touch, not followed on",
        feeds::Kind::Blocked => "a part cannot start",
        feeds::Kind::Unresolved => "not resolved",
    }
}

/// How a thrown body ended: `face 2`, `balanced`.
///
/// # Example
/// ```
/// assert_eq!(carom_words::study::pose(carom_study::poses::Pose::Balanced), "balanced");
/// ```
pub fn pose(pose: Pose) -> String {
    match pose {
        Pose::Face(face) => format!("face {face}"),
        Pose::NoFace => "at rest on no face".to_owned(),
        Pose::Balanced => "balanced".to_owned(),
        Pose::NoConsistentOutcome => "no consistent outcome".to_owned(),
        Pose::Several => "several ways on".to_owned(),
        Pose::StillMoves(Spent::Time) => "still moves after its time".to_owned(),
        Pose::StillMoves(Spent::Steps) => "still moves after its steps".to_owned(),
        Pose::StillMoves(Spent::Impacts) => "still moves after its strikes".to_owned(),
        Pose::Failed => "could not be followed".to_owned(),
    }
}

/// Every way to end but those on a face by its number.
pub fn poses() -> impl Iterator<Item = Pose> {
    let named = [Pose::NoFace, Pose::Balanced, Pose::NoConsistentOutcome, Pose::Several, Pose::Failed];
    named.into_iter().chain([Spent::Time, Spent::Steps, Spent::Impacts].map(Pose::StillMoves))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_differ_by_more_than_case() {
        let one_face = [Ending::Lies(Verdict::Face(1))];
        let mut short: Vec<String> =
            endings().chain(one_face).map(|ending| letters(ending).to_lowercase()).collect();
        assert!(short.iter().all(|short| (1..=2).contains(&short.len())), "{short:?}");
        let count = short.len();
        short.sort();
        short.dedup();
        assert_eq!(short.len(), count, "{short:?}");
    }

    #[test]
    fn every_ending_is_known_by_its_words() {
        for (number, outcome) in Outcome::ALL.iter().enumerate() {
            assert_eq!(*outcome as usize, number, "each once, in its order");
        }
        let faces = [0, 12].map(|face| Ending::Lies(Verdict::Face(face)));
        for found in endings().chain(faces) {
            assert_eq!(ending_of(&ending(found)), Some(found), "{found:?}");
        }
        for words in ["mine", "", "face", "face 07", "face x", "stuck "] {
            assert_eq!(ending_of(words), None, "{words}");
        }
    }
}
