//! The verdict of a run, why its stages end, what decided it and why it failed.

use crate::number::{plain, significant};
use crate::part::{Names, obstacle};
use crate::{Words, list};
use carom_feeder::{Decided, Feeder, Jam, JamKind, Landing, Outcome, Run, StageEnd, Touch, Verdict, spatial};
use carom_motion::planar::trace::{Impact, PieceEnd};

/// Which face is down: `same side`, `turned`, `face 2`.
///
/// # Example
/// ```
/// assert_eq!(carom_words::run::side(carom_feeder::Verdict::Face(2)), "face 2");
/// ```
pub fn side(verdict: Verdict) -> String {
    match verdict {
        Verdict::Same => "same side".to_owned(),
        Verdict::Turned => "turned".to_owned(),
        Verdict::Face(face) => format!("face {face}"),
    }
}

/// The verdict in a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Headline {
    /// How it came out: `turned`, `same side`, `face 2`, `delivered, turned`, `stuck`, ...
    pub word: String,
    /// Name of the plate it came to, where it came to one.
    pub plate: Option<String>,
    /// Why it failed: between what a part jammed, by how much it missed, or what the word means. Empty for what did not fail.
    pub because: String,
}

/// The verdict of a run in a line.
pub fn headline(feeder: &Feeder, run: &Run) -> Headline {
    let plate = match run.outcome {
        Outcome::NeverFlat if swings(run) => run.stages.last().and_then(|stage| stage.obstacle),
        outcome => on_plate(outcome, &run.landings, run.stages.last().map(|stage| stage.obstacle)),
    };
    let plate = plate.map(|plate| obstacle(feeder, plate));
    Headline { word: came_out(run.outcome, &run.landings), plate, because: because(feeder, run) }
}

/// The same of a run in space.
pub fn headline_in_space(feeder: &spatial::Feeder, run: &spatial::Run) -> Headline {
    let plate = on_plate(run.outcome, &run.landings, run.stages.last().map(|stage| stage.obstacle));
    let because = match &run.jam {
        Some(jam) => jammed(feeder, jam),
        // What holds it, friction or another plate, is not asked.
        None if run.outcome == Outcome::Stuck => "it has come to rest there".to_owned(),
        None if run.outcome == Outcome::Escaped
            && run.landings.last().is_some_and(|landing| landing.plate + 1 == feeder.plates.len()) =>
        {
            "it lay flat on the last plate and left it, but not over its free edge".to_owned()
        }
        None => why(run.outcome).to_owned(),
    };
    let plate = plate.map(|plate| obstacle(feeder, plate));
    Headline { word: came_out(run.outcome, &run.landings), plate, because }
}

/// How it came out.
fn came_out(outcome: Outcome, landings: &[Landing]) -> String {
    let verdict = landings.last().and_then(|landing| landing.verdict).map(side);
    match (outcome, verdict) {
        (Outcome::Landed, verdict) => verdict.unwrap_or("landed".to_owned()),
        (Outcome::Delivered, Some(verdict)) => format!("delivered, {verdict}"),
        (outcome, _) => crate::study::outcome(outcome),
    }
}

/// The plate that a run came to, where it came to one; with what its last stage was on.
fn on_plate(outcome: Outcome, landings: &[Landing], last: Option<Option<usize>>) -> Option<usize> {
    let landed = landings.last().map(|landing| landing.plate);
    match outcome {
        Outcome::Landed | Outcome::Delivered => landed,
        // Where it lies now, not where it landed last.
        Outcome::Stuck | Outcome::OnEnd => last.unwrap_or_else(|| landed.or(Some(0))),
        Outcome::Jammed
        | Outcome::Missed
        | Outcome::Escaped
        | Outcome::NeverFlat
        | Outcome::Unresolved
        | Outcome::Blocked => None,
    }
}

/// What the word of an outcome means; empty for what did not fail.
fn why(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Landed | Outcome::Delivered => "",
        Outcome::Stuck => "friction holds it",
        Outcome::OnEnd => "it rests on an end",
        Outcome::Jammed => "it rests wedged",
        Outcome::Missed => "it fell past the last plate",
        Outcome::Escaped => "it left the last plate before it lay flat",
        Outcome::NeverFlat => "the budget of events or time ran out",
        Outcome::Unresolved => "more contacts met at once than could be resolved",
        Outcome::Blocked => "another part stood where it starts",
    }
}

fn because(feeder: &Feeder, run: &Run) -> String {
    if let Some(jam) = &run.jam {
        return jammed(feeder, jam);
    }
    if let Some(by) = run.missed_by {
        return format!(
            "it fell past the last plate, {} mm from it at the nearest",
            significant(1e3 * by, 3)
        );
    }
    if let Some(face) = run.swings_on(feeder) {
        return format!("it swings to and fro on face {face}, and nothing takes energy from it");
    }
    if run.outcome == Outcome::NeverFlat && swings(run) {
        return "it swings to and fro, and nothing takes energy from it".to_owned();
    }
    why(run.outcome).to_owned()
}

/// True where a run ended in a swing without end.
///
/// # Example
/// A part that slides down a slope and off it does not swing.
/// ```
/// let feeder = carom_feeder::examples::rod_on_a_slope(0.2);
/// assert!(!carom_words::run::swings(&feeder.run()?));
/// # Ok::<(), carom_feeder::RunError>(())
/// ```
pub fn swings(run: &Run) -> bool {
    run.stages.last().is_some_and(|stage| stage.ended_by == StageEnd::Swings)
}

fn jammed<N: Names>(feeder: &N, jam: &Jam<N::Feature>) -> String {
    let on = |touch: &Touch<N::Feature>| {
        format!("{} on “{}”", feeder.part_of(&touch.feature), obstacle(feeder, touch.obstacle))
    };
    let contacts: Vec<String> = jam.contacts.iter().map(on).collect();
    let listed = list(&contacts, "its contacts");
    match jam.kind {
        JamKind::Wedged => format!("it rests wedged, held by {listed}"),
        JamKind::Unresolved => format!("no impact resolves {listed}"),
    }
}

/// Why a stage ended: `front touches`, `6 strikes`.
pub fn stage_end<N: Names>(feeder: &N, end: &StageEnd<N::Feature>) -> String {
    let feature = |touch: &Touch<N::Feature>| feeder.part_of(&touch.feature);
    match end {
        StageEnd::Touches(touch) => format!("{} touches", feature(touch)),
        StageEnd::LiesDown(_) => "lies down".to_owned(),
        StageEnd::CentreAtEdge(_) => "centre at edge".to_owned(),
        StageEnd::LiftsOff(_) => "lift-off, N = 0".to_owned(),
        StageEnd::SlipStops(_) => "slip comes to zero".to_owned(),
        StageEnd::FrictionGivesWay(_) => "friction gives way".to_owned(),
        StageEnd::RunsOff(touch) if feeder.is_over_end(&touch.feature) => {
            "trailing end at the edge".to_owned()
        }
        StageEnd::RunsOff(touch) => format!("{} runs off", feature(touch)),
        StageEnd::Painleve(_) => "Painlevé's paradox".to_owned(),
        StageEnd::Rests => "rests".to_owned(),
        StageEnd::FliesAway => "meets nothing more".to_owned(),
        StageEnd::Swings => "swings for ever".to_owned(),
        StageEnd::OtherPart => "the other part".to_owned(),
        StageEnd::TimeUp => "time is up".to_owned(),
        StageEnd::Strikes { count, obstacles, limit } => strikes(feeder, *count, obstacles, *limit),
    }
}

/// `6 strikes, ever smaller, then their limit`; on what, where that is several obstacles.
fn strikes(feeder: &impl Names, count: usize, obstacles: &[usize], limit: bool) -> String {
    let names: Vec<String> = obstacles.iter().map(|o| obstacle(feeder, *o)).collect();
    let on = if names.len() > 1 { format!(" on {}", list(&names, "")) } else { String::new() };
    match (limit, count) {
        (true, 1) => "one strike, then the limit of ever smaller ones".to_owned(),
        (true, _) => format!("{count} strikes{on}, ever smaller, then their limit"),
        (false, _) => format!("{count} strikes{on}"),
    }
}

/// Why a piece of motion ended, short enough for a mark in a plot.
pub fn piece_end(end: PieceEnd) -> &'static str {
    match end {
        PieceEnd::Closes { .. } => "touches",
        PieceEnd::ForceZero(_) => "N = 0",
        PieceEnd::SlipZero(_) => "slip stops",
        PieceEnd::StickLimit(_) => "begins to slip",
        PieceEnd::RunsOff(_) => "runs off",
        PieceEnd::PainleveEdge(_) => "Painlevé's edge",
        PieceEnd::Rests => "rests",
        PieceEnd::FliesAway => "flies away",
        PieceEnd::Swings => "swings for ever",
        PieceEnd::Elsewhere => "the other part",
        PieceEnd::TimeUp => "time is up",
    }
}

/// What the tightest decision of a run was about.
///
/// # Example
/// ```
/// use carom_feeder::Decided;
/// use carom_words::run::decided;
/// assert_eq!(decided(Decided::Impact { time: 0.5 }), "the course of the impact at t = 0.500000 s");
/// ```
pub fn decided(what: Decided) -> String {
    match what {
        Decided::Nothing => "nothing was decided".to_owned(),
        Decided::Contacts { time } => format!("which contacts hold, stick or slip at t = {time:.6} s"),
        Decided::Impact { time } => format!("the course of the impact at t = {time:.6} s"),
    }
}

/// What is remarkable about an impact of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Note {
    /// No contact approached: friction forces it (Painlevé's paradox).
    WithoutApproach,
    /// So many ways on were consistent at most, and one was chosen.
    WaysOn(usize),
    /// Other shares of compression leave other motions.
    OpenShare,
    /// The part lifts off at once: to stay it would need this normal force, < 0 [N].
    LiftsOff(f64),
    /// The law created so much energy [J].
    GainedEnergy(f64),
    /// Restitution was multiplied by this factor, so that energy does not grow.
    RestitutionScaled(f64),
}

/// What is remarkable about an impact.
pub fn notes(impact: &Impact) -> Vec<Note> {
    let gained = impact.energy_after - impact.energy_before;
    let notes = [
        impact.without_approach.then_some(Note::WithoutApproach),
        (impact.branches > 1).then_some(Note::WaysOn(impact.branches)),
        impact.open_share.then_some(Note::OpenShare),
        impact.holding_would_need.map(Note::LiftsOff),
        impact.gained_energy.then_some(Note::GainedEnergy(gained)),
        (impact.restitution_scaled < 1.0).then_some(Note::RestitutionScaled(impact.restitution_scaled)),
    ];
    notes.into_iter().flatten().collect()
}

/// What is remarkable about an impact, in a line; `None` where nothing is.
pub fn note(impact: &Impact) -> Option<String> {
    let words = |note: &Note| match note {
        Note::WithoutApproach => {
            "no contact approached: friction forces the impact (Painlevé's paradox)".to_owned()
        }
        Note::WaysOn(ways) => format!("up to {ways} ways on were consistent, and one was chosen"),
        Note::OpenShare => "the share of compression is open: others leave other motions".to_owned(),
        Note::LiftsOff(force) => {
            format!("lifts off at once: holding would need N = {} N", plain(*force, 3))
        }
        Note::GainedEnergy(gain) => format!("{} law created {gain:.3e} J", impact.law.word()),
        Note::RestitutionScaled(scale) => {
            format!("restitution scaled by {scale:.4} so that energy does not grow")
        }
    };
    let notes: Vec<String> = notes(impact).iter().map(words).collect();
    (!notes.is_empty()).then(|| notes.join("; "))
}
