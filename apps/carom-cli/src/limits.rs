//! How far each quantity may move alone before the verdict flips: what is told of it.

use crate::args::RunOptions;
use crate::printed::tell;
use carom_scene::{Drawn, FoundLimits, LimitEnd, labelled};
use carom_words::aligned;
use std::time::{Duration, Instant};

/// Says on stderr how far a search is, at most once a second and never in its first one.
fn progress(scene: &str) -> impl FnMut(&str, u64) {
    let mut last = Instant::now();
    move |path: &str, runs: u64| {
        if last.elapsed() >= Duration::from_secs(1) {
            last = Instant::now();
            // There is nowhere to report that stderr is closed.
            tell(&format!("limits of {scene}: {path}, {runs} runs so far"));
        }
    }
}

/// The limits, where they are asked for.
pub(crate) fn sought(scene: &impl Drawn, options: &RunOptions) -> Option<FoundLimits> {
    options.limits.then(|| FoundLimits::of(scene, &mut progress(scene.name())))
}

/// The limits as a table.
pub(crate) fn text(scene: &impl Drawn, found: &FoundLimits) -> String {
    let quantities = scene.quantities();
    let mut rows = vec![["quantity", "now", "from", "to"].map(str::to_owned).to_vec()];
    for limit in &found.limits {
        let Some(quantity) = quantities.iter().find(|quantity| quantity.path == limit.quantity) else {
            continue;
        };
        let show = |value: f64| quantity.kind.dimension.show_digits(value, 5);
        let edge = |kept: f64, end: LimitEnd| match end {
            LimitEnd::Flips => show(kept),
            LimitEnd::NoSuchFeeder => format!("({})", show(kept)),
            LimitEnd::EndOfSearch => "-".to_owned(),
        };
        rows.push(vec![
            labelled(&limit.quantity).into_owned(),
            show(quantity.value),
            edge(limit.low_kept, limit.low_end),
            edge(limit.high_kept, limit.high_end),
        ]);
    }
    let runs = found.runs;
    format!(
        "the verdict stays while one quantity moves alone ({runs} runs)\n(in parentheses: no flip, but beyond it there is no such feeder; -: no flip down to a thousandth of it, or up to 128 times it)\n\n{}",
        aligned(&rows)
    )
}
