//! What contacts do in an impact in space, why its stages end, and why hypotheses fail.

use crate::impact::share;
use crate::number::six_digits;
use crate::{Words, named};
use carom_impact::spatial::{Condition, Ground, Guess, Mode, Refusal, StageEvent};

/// What a hypothesis says of each contact: "A slips; B open".
pub fn hypothesis<T: AsRef<str>>(names: &[T], guess: &[Guess]) -> String {
    let words = names.iter().zip(guess).map(|(name, guess)| {
        let name = name.as_ref();
        match guess {
            Guess { holds: false, mode: Mode::Open } => format!("{name} open"),
            Guess { holds: true, mode } => format!("{name} {}", mode.word()),
            // In restitution it separates under the impulse that compression left it.
            Guess { mode, .. } => format!("{name} separates, {}", mode.word()),
        }
    });
    words.collect::<Vec<_>>().join("; ")
}

/// What a state of the law under which nothing slides says of each contact: "A keeps; B open".
pub fn keeping<T: AsRef<str>>(names: &[T], kept: &[bool]) -> String {
    let each = names.iter().zip(kept);
    let words =
        each.map(|(name, kept)| format!("{} {}", name.as_ref(), if *kept { "keeps" } else { "open" }));
    words.collect::<Vec<_>>().join("; ")
}

/// The inequality that a hypothesis breaks, and by which share of its terms.
pub fn because<T: AsRef<str>>(names: &[T], condition: Condition, broken: f64) -> String {
    let (name, by) = (|i| named(names, i), |of| share(broken, of));
    match condition {
        Condition::Pushes(i) => format!("normal impulse at {} < 0{}", name(i), by("all impulses")),
        Condition::Opens(i) => format!("{} would still approach{}", name(i), by("its velocities")),
        Condition::WithinCone(i) => {
            format!("tangential impulse at {} beyond friction{}", name(i), by("both"))
        }
        Condition::Starts(i) => format!("no direction in which {} would slip against its friction", name(i)),
        Condition::Solvable => "its equations have no solution".to_owned(),
    }
}

/// What refuses a state of the law under which nothing slides.
///
/// # Example
/// ```
/// use carom_impact::spatial::Refusal;
/// let refused = carom_words::impact_space::refused(&["O", "A"], Refusal::Pulls(1), -0.25);
/// assert_eq!(refused, "normal impulse at A = -0.250000 N s < 0: it would pull");
/// ```
pub fn refused<T: AsRef<str>>(names: &[T], refusal: Refusal, amount: f64) -> String {
    let amount = six_digits(amount);
    match refusal {
        Refusal::Pulls(i) => {
            format!("normal impulse at {} = {amount} N s < 0: it would pull", named(names, i))
        }
        Refusal::Approaches(i) => {
            format!("normal velocity of {} = {amount} m/s < 0: it would go on down", named(names, i))
        }
        Refusal::Unsolvable => "no impulses bring these contacts to rest".to_owned(),
    }
}

/// Why a stage is walked that no consistent hypothesis says; `None` where one does. `clocks` are the contacts that are loaded in it.
pub fn ground<T: AsRef<str>>(names: &[T], ground: Ground, clocks: &[bool]) -> Option<String> {
    let loaded = names.iter().zip(clocks).filter(|(_, clock)| **clock);
    let loaded: Vec<&str> = loaded.map(|(name, _)| name.as_ref()).collect();
    let (all, several) = (loaded.join(" and "), loaded.len() > 1);
    match ground {
        Ground::Consistent => None,
        Ground::DrivenIn(_) => {
            let are = if several { "they are" } else { "it is" };
            Some(format!("friction drives {all} in (Painlevé's paradox): {are} loaded until a slip stops"))
        }
        Ground::FastestFirst(_) => {
            let are = if several { "approach fastest and are" } else { "approaches fastest and is" };
            Some(format!("{all} {are} loaded first"))
        }
    }
}

/// Why a stage ended; `names` are those of the contacts.
pub fn stage_end<T: AsRef<str>>(names: &[T], event: StageEvent) -> String {
    let name = |i: usize| named(names, i);
    match event {
        StageEvent::SlipStops(i) => format!("slip stops at {}", name(i)),
        StageEvent::Closes(i) => format!("{} closes", name(i)),
        StageEvent::Opens(i) => format!("{} opens", name(i)),
        StageEvent::SlipStarts(i) => format!("slip starts at {}", name(i)),
        StageEvent::Loads(i) => format!("{} takes an impulse", name(i)),
        StageEvent::DrivenIn => "friction drives it in".to_owned(),
        StageEvent::Repaid(i) => format!("{} has returned its work", name(i)),
        StageEvent::CompressionEnds => "compression ends".to_owned(),
        StageEvent::RestitutionEnds => "restitution ends".to_owned(),
    }
}
