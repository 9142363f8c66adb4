//! What happens at which interval, as a picture.

use super::{Searched, report};
use carom_feeder::Outcome;
use carom_figure::{IntervalFill, IntervalPiece, IntervalStrips, intervals_svg};
use carom_study::feeds::{End, Kind};

/// How far the axis goes above the smallest interval without touch.
const ABOVE: f64 = 1.25;

fn fill(kind: Kind) -> IntervalFill {
    match kind {
        Kind::Free => IntervalFill::Good,
        Kind::Harmless => IntervalFill::Fair,
        Kind::Harmful => IntervalFill::Bad,
        Kind::Blocked => IntervalFill::Blocked,
        Kind::Unresolved => IntervalFill::Unknown,
    }
}

fn fill_of_part(end: &End) -> IntervalFill {
    match end.outcome {
        Outcome::Blocked => IntervalFill::Blocked,
        Outcome::Unresolved | Outcome::NeverFlat => IntervalFill::Unknown,
        _ if end.as_wanted => IntervalFill::Good,
        _ => IntervalFill::Bad,
    }
}

/// The strips as SVG.
pub(super) fn svg(searched: &Searched<'_>) -> String {
    let found = &searched.found;
    let pieces = found.stretches.iter().map(|piece| IntervalPiece {
        from: piece.first,
        to: piece.last,
        fill: fill(piece.label.kind()),
        parts: piece.label.ends.iter().map(fill_of_part).collect(),
    });
    let last = found.stretches.last().map_or(1.0, |piece| piece.last);
    let free = found.smallest.as_ref().map(|smallest| smallest.free);
    let mut marks: Vec<(f64, String)> = free
        .map(|free| (free, format!("no touch above {}", report::seconds(free, searched))))
        .into_iter()
        .collect();
    marks
        .extend(searched.scene.feed().map(|feed| (feed.interval, format!("the scene: {} s", feed.interval))));
    let parts = " (of one part: as wanted)";
    let legend = Kind::ALL.map(|kind| {
        let more = match kind {
            Kind::Free => parts,
            Kind::Harmful => " (of one part: it does)",
            Kind::Blocked => " (of one part: it does not start)",
            Kind::Harmless | Kind::Unresolved => "",
        };
        (fill(kind), format!("{}{more}", kind.words()))
    });
    intervals_svg(&IntervalStrips {
        title: format!(
            "{}: what happens to {} parts, by the interval between them",
            searched.scene.name(),
            searched.feed.parts
        ),
        subtitle: report::answer(searched),
        to: free.map_or(last, |free| ABOVE * free),
        pieces: pieces.collect(),
        marks,
        legend: legend.to_vec(),
    })
}
