//! The words of an impact's report: what contacts do, why stages end, why hypotheses fail.

use crate::impact_file::ImpactProblem;
use carom_impact::planar::end_states::Rejected;
use carom_impact::planar::{Broken, Condition, Guess, MOST_CONTACTS, Phase, Slip, StageEnd};

/// Why a stage ended: "slip stops at A".
///
/// # Example
/// ```
/// use carom_impact::planar::StageEnd;
/// let names = ["left".to_owned(), "right".to_owned()];
/// assert_eq!(carom_scene::stage_end_words(&names, StageEnd::SlipStops(1)), "slip stops at right");
/// ```
pub fn stage_end_words(names: &[String], end: StageEnd) -> String {
    let name = |i: usize| names.get(i).map_or("?", String::as_str);
    match end {
        StageEnd::SlipStops(i) => format!("slip stops at {}", name(i)),
        StageEnd::Closes(i) => format!("{} closes", name(i)),
        StageEnd::CompressionEnds => "compression ends".to_owned(),
        StageEnd::RestitutionEnds => "restitution ends".to_owned(),
    }
}

pub(crate) fn slip_word(slip: Slip) -> &'static str {
    match slip {
        Slip::Open => "open",
        Slip::Sticks => "sticks",
        Slip::Forward => "slips+",
        Slip::Backward => "slips-",
    }
}

pub(crate) fn phase_word(phase: Phase) -> &'static str {
    match phase {
        Phase::Compression => "compression",
        Phase::Restitution => "restitution",
    }
}

/// "A slips+, B sticks".
pub(crate) fn hypothesis(problem: &ImpactProblem, guess: &[Guess]) -> String {
    let words = problem.names.iter().zip(guess).map(|(name, guess)| {
        match (guess.holds, guess.slip) {
            (true, slip) => format!("{name} {}", slip_word(slip)),
            (false, Slip::Open) => format!("{name} separates"),
            // In restitution it separates under the impulse that compression left it.
            (false, slip) => format!("{name} separates ({})", slip_word(slip)),
        }
    });
    words.collect::<Vec<_>>().join(", ")
}

/// The inequality that rejects a hypothesis of an impact.
pub(crate) fn because(problem: &ImpactProblem, rejected: &Rejected<MOST_CONTACTS>) -> String {
    let words = inequality(problem, &rejected.broken, &OF_IMPACT);
    match rejected.phase {
        Phase::Compression => words,
        Phase::Restitution => format!("in restitution: {words}"),
    }
}

/// What the quantities of a rate problem are called under one of its two clocks.
pub(crate) struct Words {
    rate: &'static str,
    rates: &'static str,
    responses: &'static str,
}

/// The clock is the normal impulse.
pub(crate) const OF_IMPACT: Words = Words { rate: "impulse", rates: "impulses", responses: "velocities" };
/// The clock is time.
pub(crate) const OF_MOTION: Words = Words { rate: "force", rates: "forces", responses: "accelerations" };

/// An inequality that a hypothesis breaks.
pub(crate) fn inequality(problem: &ImpactProblem, broken: &Broken, called: &Words) -> String {
    let Words { rate, rates, responses } = called;
    let name = |i: usize| problem.names.get(i).map_or("?", String::as_str);
    // Where numbers overflow there is no share to tell.
    let by = |of: &str| match broken.share {
        share if share.is_finite() => format!(", by {share:.3} of {of}"),
        _ => String::new(),
    };
    let (of_rates, of_responses) = (format!("all {rates}"), format!("its {responses}"));
    match broken.condition {
        Condition::Pushes(i) => format!("normal {rate} at {} < 0{}", name(i), by(&of_rates)),
        Condition::Opens(i) => format!("{} would still approach{}", name(i), by(&of_responses)),
        Condition::WithinCone(i) => {
            format!("tangential {rate} at {} beyond friction{}", name(i), by("both"))
        }
        Condition::StartsForward(i) => {
            format!("slip at {} would not be forward{}", name(i), by(&of_responses))
        }
        Condition::StartsBackward(i) => {
            format!("slip at {} would not be backward{}", name(i), by(&of_responses))
        }
        Condition::Solvable => "its equations have no solution".to_owned(),
    }
}
