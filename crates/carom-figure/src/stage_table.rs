//! The stage table: every stage and every strike, in order of time; the strikes of a clatter are one row with it.

use crate::markup::{Markup, html, table};
use crate::senses::tilt_in;
use crate::text::{fixed, significant};
use crate::tolerance::NO_SPIN;
use carom_feeder::{Feeder, PartKind, Run, Stage, StageName};
use carom_motion::planar::trace::Impact;
use carom_motion::planar::{Pose, State, Twist};
use carom_words::{Words, part, run};

/// One row of the stage table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Row<'a> {
    /// A stage with its number from 0. A clatter stands for its strikes too.
    Stage(usize, &'a Stage),
    /// An impact with its number from 0.
    Strike(usize, &'a Impact),
}

/// Stages and strikes in order of time: a strike before the stage that begins with it.
pub fn rows(run: &Run) -> Vec<Row<'_>> {
    let mut out = vec![];
    let mut strikes = run.trace.impacts.iter().enumerate().peekable();
    for (i, stage) in run.stages.iter().enumerate() {
        let clatters = stage.name == StageName::Clatter;
        let before = |impact: &Impact| {
            impact.time < stage.start_time || (!clatters && impact.time <= stage.start_time)
        };
        while let Some((k, impact)) = strikes.next_if(|(_, impact)| before(impact)) {
            out.push(Row::Strike(k, impact));
        }
        out.push(Row::Stage(i, stage));
        while clatters && strikes.next_if(|(_, impact)| impact.time <= stage.end_time).is_some() {}
    }
    out.extend(strikes.map(|(k, impact)| Row::Strike(k, impact)));
    out
}

/// A duration [ms]: to a tenth, or to two digits where it is shorter.
///
/// # Example
/// ```
/// use carom_figure::milliseconds;
/// assert_eq!([0.25, 1.0 / 3.0, 2.5e-6].map(milliseconds), ["250.0", "333.3", "0.0025"]);
/// ```
pub fn milliseconds(seconds: f64) -> String {
    let ms = 1e3 * seconds;
    if ms > 0.0 && ms < 0.095 { significant(ms, 2) } else { fixed(ms, 1) }
}

/// Tilt in a run \[rad\]; `None` for a disc, which has no side to be down.
pub fn shown_tilt(feeder: &Feeder, run: &Run, pose: Pose) -> Option<f64> {
    (feeder.part.kind != PartKind::Disc).then(|| tilt_in(feeder, run, pose))
}

fn change(a: f64, b: f64, digits: usize) -> String {
    let (a, b) = (significant(a, digits), significant(b, digits));
    if a == b { a } else { format!("{a} → {b}") }
}

fn degrees(a: Option<f64>, b: Option<f64>) -> String {
    let (Some(a), Some(b)) = (a, b) else { return "–".to_owned() };
    let (a, b) = (fixed(a.to_degrees(), 1), fixed(b.to_degrees(), 1));
    if a == b { a } else { format!("{a} → {b}") }
}

/// A spin counted forward; rounding noise is zero.
fn forward(sense: f64, twist: Twist) -> f64 {
    let spin = sense * twist.spin;
    if spin.abs() < NO_SPIN { 0.0 } else { spin }
}

/// What a strike is, in a few words.
pub(crate) fn kind_of(impact: &Impact) -> String {
    if impact.without_approach {
        return "forced by friction, without approach".into();
    }
    match impact.kind {
        Some(kind) => format!("type {}, {}", kind.number(), kind.word()),
        None => format!("{} contacts together", impact.contacts.len()),
    }
}

/// The table's section; empty where the run kept no stages.
pub(crate) fn section(feeder: &Feeder, run: &Run) -> Markup {
    if run.stages.is_empty() && run.trace.impacts.is_empty() {
        return html! {};
    }
    let row = |row| match row {
        Row::Stage(i, stage) => stage_row(feeder, run, i, stage),
        Row::Strike(k, impact) => strike_row(feeder, run, k, impact),
    };
    let heads =
        ["#", "stage", "on", "from [s]", "lasts [ms]", "speed [m/s]", "tilt [°]", "spin [1/s]", "ended by"];
    let sense = crate::senses::forward_sense(feeder);
    html! {
        section id="stages" {
            h2 { "Stages" }
            (table("stages", &heads, rows(run).into_iter().map(row)))
            p.note {
                "Tilt and spin are positive the way the part tips over the first plate’s free edge, here "
                @if sense < 0.0 { "clockwise" } @else { "counter-clockwise" }
                ". Tilt is that of the side that was down at the start, from the horizontal. Speed is that of the mass centre."
            }
        }
    }
}

fn stage_row(feeder: &Feeder, run: &Run, i: usize, stage: &Stage) -> Markup {
    let sense = crate::senses::forward_sense(feeder);
    let speed = |s: &State| s.twist.velocity.norm();
    let name = stage.name.word();
    html! {
        tr.stage data-stage=(i) data-t=(if stage.start_time.is_finite() { stage.start_time } else { 0.0 }) {
            td { (i + 1) }
            th scope="row" { i class={ "key " (name) } {} (name) }
            td { (stage.obstacle.map_or("–".into(), |o| part::obstacle(feeder, o))) }
            td { (fixed(stage.start_time, 4)) }
            td { (milliseconds(stage.end_time - stage.start_time)) }
            td { (change(speed(&stage.start), speed(&stage.end), 3)) }
            td { (degrees(shown_tilt(feeder, run, stage.start.pose), shown_tilt(feeder, run, stage.end.pose))) }
            td { (change(forward(sense, stage.start.twist), forward(sense, stage.end.twist), 3)) }
            td.words { (run::stage_end(feeder, &stage.ended_by)) }
        }
    }
}

fn strike_row(feeder: &Feeder, run: &Run, k: usize, impact: &Impact) -> Markup {
    let sense = crate::senses::forward_sense(feeder);
    let on = impact.contacts.first().map(|c| part::obstacle(feeder, c.obstacle)).unwrap_or_default();
    html! {
        tr.strike {
            td {}
            th scope="row" { i.key.strike {} a href="#strikes" { "strike " (k + 1) } }
            td { (on) }
            td { (fixed(impact.time, 4)) }
            td {}
            td { (change(impact.before.velocity.norm(), impact.after.velocity.norm(), 3)) }
            td {
                (shown_tilt(feeder, run, impact.pose).map_or("–".to_owned(), |tilt| fixed(tilt.to_degrees(), 1)))
            }
            td { (change(forward(sense, impact.before), forward(sense, impact.after), 3)) }
            td.words { (kind_of(impact)) }
        }
    }
}
