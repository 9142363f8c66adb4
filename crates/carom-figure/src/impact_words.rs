//! Phases, slips and ends of the stages of an impact in words: every picture and table takes them from here.

use carom_impact::planar::{Phase, Slip, StageEnd};

pub(crate) fn phase(phase: Phase) -> &'static str {
    match phase {
        Phase::Compression => "compression",
        Phase::Restitution => "restitution",
    }
}

/// What a contact does.
pub(crate) fn slip(slip: Slip) -> &'static str {
    match slip {
        Slip::Open => "open",
        Slip::Sticks => "sticks",
        Slip::Forward => "slips along +t",
        Slip::Backward => "slips along −t",
    }
}

/// The same as briefly as a table has room for.
pub(crate) fn brief_slip(slip: Slip) -> String {
    self::slip(slip).replace(" along", "")
}

/// What ended a stage; `names` are those of the contacts.
pub(crate) fn stage_end<'n>(end: StageEnd, names: impl Fn(usize) -> &'n str) -> String {
    match end {
        StageEnd::SlipStops(i) => format!("slip stops at {}", names(i)),
        StageEnd::Closes(i) => format!("{} closes", names(i)),
        StageEnd::CompressionEnds | StageEnd::RestitutionEnds => ends(end).to_owned(),
    }
}

/// What ended a stage, as one contact sees it.
pub(crate) fn stage_end_at(end: StageEnd, contact: usize) -> &'static str {
    match end {
        StageEnd::SlipStops(i) if i == contact => "its slip stops",
        StageEnd::SlipStops(_) => "another contact's slip stops",
        StageEnd::Closes(i) if i == contact => "it closes again",
        StageEnd::Closes(_) => "another contact closes again",
        StageEnd::CompressionEnds | StageEnd::RestitutionEnds => ends(end),
    }
}

fn ends(end: StageEnd) -> &'static str {
    if end == StageEnd::RestitutionEnds { "restitution ends" } else { "compression ends" }
}
