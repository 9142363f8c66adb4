//! Several runs side by side: one column each.

use crate::table::{as_wanted, energy_change, fixed, headline, signed};
use carom_feeder::Run;
use carom_figure::milliseconds;
use carom_scene::{Scene, angle_to_normal};
use carom_words::{Words, aligned, run::stage_end};

/// A run with its scene.
pub(crate) type Done = (Scene, Run);

/// The table of several runs.
pub(crate) fn text(done: &[Done]) -> String {
    let mut rows: Vec<Vec<String>> = vec![];
    let mut row = |name: &str, value: &dyn Fn(&Done) -> String| {
        let mut cells = vec![name.to_owned()];
        cells.extend(done.iter().map(value));
        rows.push(cells);
    };
    row("", &|(scene, _)| scene.name().to_owned());
    row("verdict", &|(scene, run)| headline(scene.feeder(), run));
    if done.iter().any(|(scene, run)| as_wanted(scene, run).is_some()) {
        row("wanted", &|(scene, run)| dash(as_wanted(scene, run)));
    }
    row("flat at", &|(_, run)| {
        dash(run.final_landing().and_then(|landing| landing.flat).map(|flat| format!("{flat:.4} s")))
    });
    row("ended at", &|(_, run)| format!("{:.4} s", run.end_time));
    row("struck at", &|(_, run)| dash(run.struck_at().map(|speed| format!("{speed:.3} m/s"))));
    row("angle to normal", &|(scene, run)| {
        let angle = run.deciding_strike().and_then(|impact| angle_to_normal(scene.feeder(), impact));
        dash(angle.map(|angle| format!("{}°", fixed(angle * 180.0 / std::f64::consts::PI, 2))))
    });
    row("impact type", &|(_, run)| {
        let kind = run.deciding_strike().and_then(|impact| impact.kind);
        dash(kind.map(|kind| format!("{}, {}", kind.number(), kind.class().word())))
    });
    row("energy", &|(_, run)| {
        dash(run.deciding_strike().and_then(energy_change).map(|change| format!("{} %", signed(change, 1))))
    });
    row("strikes", &|(_, run)| run.trace.impacts.len().to_string());
    row("margin", &|(_, run)| {
        if run.margin.is_finite() { format!("{:.2e}", run.margin) } else { "-".to_owned() }
    });
    // Stages stand beside each other by their number: runs that differ in a stage differ from that row on.
    let most = done.iter().map(|(_, run)| run.stages.len()).max().unwrap_or(0);
    for i in 0..most {
        row(if i == 0 { "stages" } else { "" }, &|(scene, run)| {
            run.stages.get(i).map_or(String::new(), |stage| {
                let duration = milliseconds(stage.end_time - stage.start_time);
                format!("{} {duration} ms, {}", stage.name.word(), stage_end(scene.feeder(), &stage.ended_by))
            })
        });
    }
    aligned(&rows)
}

fn dash(text: Option<String>) -> String {
    text.unwrap_or_else(|| "-".to_owned())
}
