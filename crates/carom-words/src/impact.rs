//! What contacts do in an impact in the plane, why its stages end, and why hypotheses fail.

use crate::{Words, named};
use carom_impact::planar::{Broken, Condition, Guess, Slip, StageEnd};
use carom_impact::{ImpactError, Phase};

/// What a contact does, for a person: `slips along +t`.
pub fn slip(slip: Slip) -> &'static str {
    match slip {
        Slip::Open => "open",
        Slip::Sticks => "sticks",
        Slip::Forward => "slips along +t",
        Slip::Backward => "slips along −t",
    }
}

/// The same as briefly as a table has room for: `slips +t`.
pub fn brief_slip(slip: Slip) -> &'static str {
    match slip {
        Slip::Open | Slip::Sticks => self::slip(slip),
        Slip::Forward => "slips +t",
        Slip::Backward => "slips −t",
    }
}

/// Why a stage ended; `names` are those of the contacts.
///
/// # Example
/// ```
/// use carom_impact::planar::StageEnd;
/// assert_eq!(carom_words::impact::stage_end(&["left", "right"], StageEnd::SlipStops(1)), "slip stops at right");
/// ```
pub fn stage_end<T: AsRef<str>>(names: &[T], end: StageEnd) -> String {
    match end {
        StageEnd::SlipStops(i) => format!("slip stops at {}", named(names, i)),
        StageEnd::Closes(i) => format!("{} closes", named(names, i)),
        StageEnd::CompressionEnds | StageEnd::RestitutionEnds => phase_ends(end).to_owned(),
    }
}

/// Why a stage ended, as one contact sees it.
pub fn stage_end_at(end: StageEnd, contact: usize) -> &'static str {
    match end {
        StageEnd::SlipStops(i) if i == contact => "its slip stops",
        StageEnd::SlipStops(_) => "another contact's slip stops",
        StageEnd::Closes(i) if i == contact => "it closes again",
        StageEnd::Closes(_) => "another contact closes again",
        StageEnd::CompressionEnds | StageEnd::RestitutionEnds => phase_ends(end),
    }
}

fn phase_ends(end: StageEnd) -> &'static str {
    if end == StageEnd::RestitutionEnds { "restitution ends" } else { "compression ends" }
}

/// What a hypothesis says of each contact: "A slips+, B sticks".
pub fn hypothesis<T: AsRef<str>>(names: &[T], guess: &[Guess]) -> String {
    let words = names.iter().zip(guess).map(|(name, guess)| {
        let name = name.as_ref();
        match (guess.holds, guess.slip) {
            (true, slip) => format!("{name} {}", slip.word()),
            (false, Slip::Open) => format!("{name} separates"),
            // In restitution it separates under the impulse that compression left it.
            (false, slip) => format!("{name} separates ({})", slip.word()),
        }
    });
    words.collect::<Vec<_>>().join(", ")
}

/// Which clock a rate problem has: it gives its quantities their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// The normal impulse: rates are impulses, responses are velocities.
    Impulse(Phase),
    /// Time: rates are forces, responses are accelerations.
    Time,
}

/// The inequality that a hypothesis breaks, and by which share of its terms.
pub fn because<T: AsRef<str>>(names: &[T], broken: &Broken, clock: Clock) -> String {
    let (rate, rates, responses) = match clock {
        Clock::Impulse(_) => ("impulse", "all impulses", "its velocities"),
        Clock::Time => ("force", "all forces", "its accelerations"),
    };
    let (name, by) = (|i| named(names, i), |of| share(broken.share, of));
    let words = match broken.condition {
        Condition::Pushes(i) => format!("normal {rate} at {} < 0{}", name(i), by(rates)),
        Condition::Opens(i) => format!("{} would still approach{}", name(i), by(responses)),
        Condition::WithinCone(i) => {
            format!("tangential {rate} at {} beyond friction{}", name(i), by("both"))
        }
        Condition::StartsForward(i) => format!("slip at {} would not be forward{}", name(i), by(responses)),
        Condition::StartsBackward(i) => {
            format!("slip at {} would not be backward{}", name(i), by(responses))
        }
        Condition::Solvable => "its equations have no solution".to_owned(),
    };
    if clock == Clock::Impulse(Phase::Restitution) { format!("in restitution: {words}") } else { words }
}

/// Why an impact could not be resolved, with the names of its contacts where the engine has their numbers.
///
/// # Example
/// ```
/// use carom_impact::ImpactError;
/// let error = ImpactError::OutsideDomain { contact: Some(1), quantity: "restitution", value: 0.0, allowed: "> 0" };
/// assert_eq!(carom_words::impact::failure(&["A", "K"], &error), "restitution of K is 0, allowed is > 0");
/// ```
pub fn failure<T: AsRef<str>>(names: &[T], error: &ImpactError) -> String {
    match *error {
        ImpactError::OutsideDomain { contact: Some(i), quantity, value, allowed } => {
            format!("{quantity} of {} is {value}, allowed is {allowed}", named(names, i))
        }
        ImpactError::Coincide { first, second } => {
            let (first, second) = (named(names, first), named(names, second));
            format!("{first} and {second} coincide: same bodies, same point, same normal")
        }
        _ => error.to_string(),
    }
}

/// ", by 0.250 of all impulses"; nothing where numbers overflow: there is no share to tell.
pub(crate) fn share(share: f64, of: &str) -> String {
    if share.is_finite() { format!(", by {share:.3} of {of}") } else { String::new() }
}
