//! What `carom run` says of a feed of several parts.

use crate::table::headline;
use carom_feeder::{Feed, FeedRun, Outcome};
use carom_scene::Scene;
use std::fmt::Write as _;

/// The table of the parts, and which of them touch.
pub(crate) fn text(scene: &Scene, feed: &Feed, run: &FeedRun) -> String {
    let feeder = scene.feeder();
    let mut out = format!("{}: {} parts, one every {} s\n", scene.name(), feed.parts, feed.interval);
    let _ = writeln!(out, "part  starts s  decided s  verdict");
    for (i, part) in run.parts.iter().enumerate() {
        let never = matches!(part.run.outcome, Outcome::Blocked | Outcome::NeverFlat);
        let decided = if never { "-".to_owned() } else { format!("{:.4}", part.run.end_time) };
        let _ = writeln!(
            out,
            "{:<5} {:<9.4} {:<10} {}",
            i + 1,
            part.entered,
            decided,
            headline(feeder, &part.run)
        );
    }
    if let Some(why) = &run.broken_off {
        let _ = writeln!(out, "broken off: {why}");
    }
    if run.contacts.is_empty() {
        out.push_str("no two parts touch\n");
    }
    for contact in &run.contacts {
        let [a, b] = contact.parts;
        let how = contact.speed.map_or("without a strike".to_owned(), |v| format!("at {v:.3} m/s"));
        let _ = writeln!(out, "parts {} and {} touch first at {:.4} s, {how}", a + 1, b + 1, contact.time);
    }
    out
}
