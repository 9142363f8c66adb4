//! Stages and strikes in order of time, each in one sentence.

use crate::after_strike;
use crate::markup::{Markup, html};
use crate::stage_table::{Row, milliseconds, rows};
use crate::text::{fixed, significant};
use carom_feeder::{Feeder, Run, Stage};
use carom_words::{Words, part, run};

/// Rows that are shown: who has more reads the table of stages.
const MOST: usize = 60;

/// The list: a button for each stage and strike, with its time.
pub(crate) fn list(feeder: &Feeder, run: &Run) -> Markup {
    let all = rows(run);
    html! {
        ol.timeline {
            @for row in all.iter().take(MOST) {
                @match row {
                    Row::Stage(i, stage) => li { (stage_button(feeder, *i, stage)) },
                    Row::Strike(k, impact) => li { (strike_button(feeder, run, *k, impact.time)) },
                }
            }
        }
        @if all.len() > MOST { p.note { "and " (all.len() - MOST) " more" } }
    }
}

fn stage_button(feeder: &Feeder, i: usize, stage: &Stage) -> Markup {
    let name = stage.name.word();
    let on = stage.obstacle.map(|o| format!(" on “{}”", part::obstacle(feeder, o))).unwrap_or_default();
    let speeds = [&stage.start, &stage.end].map(|state| significant(state.twist.velocity.norm(), 3));
    html! {
        button type="button" data-t=(stage.start_time) data-stage=(i) {
            i class={ "key " (name) } {}
            b { (name) } (on)
            small {
                (milliseconds(stage.end_time - stage.start_time)) " ms, " (speeds[0]) " → " (speeds[1])
                " m/s; ended by: " (run::stage_end(feeder, &stage.ended_by))
            }
        }
    }
}

fn strike_button(feeder: &Feeder, run: &Run, k: usize, time: f64) -> Markup {
    html! {
        button type="button" data-t=(time) data-strike=(k) {
            i.key.strike {}
            b { "strike " (k + 1) } " at " (fixed(time, 4)) " s"
            small { (after_strike::sentence(feeder, run, k)) }
        }
    }
}
