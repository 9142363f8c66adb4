//! The words of results, as JSON has them.

use carom_feeder::{Outcome, StageName};
/// The word of an outcome, as JSON has it.
pub fn outcome_word(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Landed => "landed",
        Outcome::Delivered => "delivered",
        Outcome::Stuck => "stuck",
        Outcome::OnEnd => "on_end",
        Outcome::Jammed => "jammed",
        Outcome::Missed => "missed",
        Outcome::Escaped => "escaped",
        Outcome::NeverFlat => "never_flat",
    }
}

/// The word of a stage, as JSON has it.
pub fn stage_word(name: StageName) -> &'static str {
    match name {
        StageName::Slide => "slide",
        StageName::Tip => "tip",
        StageName::Flight => "flight",
        StageName::Swing => "swing",
        StageName::Stick => "stick",
        StageName::Roll => "roll",
        StageName::Wedge => "wedge",
        StageName::Rest => "rest",
        StageName::Clatter => "clatter",
    }
}
