//! What happens at which interval, as a picture.

use super::{FeedStudy, report};
use carom_feeder::Outcome;
use carom_figure::{IntervalFill, IntervalPiece, IntervalStrips, intervals_svg};
use carom_scene::Drawn;
use carom_study::feeds::{End, Kind};
use carom_words::{Words, study};

/// How far the axis goes above the smallest interval without touch.
const ABOVE: f64 = 1.25;

fn fill(kind: Kind) -> IntervalFill {
    match kind {
        Kind::Free => IntervalFill::Good,
        Kind::Harmless => IntervalFill::Fair,
        Kind::Harmful | Kind::Touching => IntervalFill::Bad,
        Kind::Blocked => IntervalFill::Blocked,
        Kind::Unresolved => IntervalFill::Unknown,
    }
}

/// What becomes of one part. Where nothing touches it goes its own way, wanted or not: that is no harm of the interval.
fn fill_of_part(kind: Kind, end: &End) -> IntervalFill {
    match end.outcome {
        _ if kind == Kind::Free => IntervalFill::Good,
        Outcome::Blocked => IntervalFill::Blocked,
        Outcome::Unresolved | Outcome::NeverFlat => IntervalFill::Unknown,
        _ if end.as_wanted => IntervalFill::Good,
        _ => IntervalFill::Bad,
    }
}

/// The strips as SVG.
pub(super) fn svg(searched: &FeedStudy<'_, impl Drawn>) -> String {
    let (found, name) = (&searched.found, searched.scene.name());
    let pieces = found.stretches.iter().map(|piece| IntervalPiece {
        from: piece.first,
        to: piece.last,
        fill: fill(piece.label.kind()),
        // What is said of solid parts is said of all.
        parts: match searched.feed {
            Some(_) => piece.label.ends.iter().map(|end| fill_of_part(piece.label.kind(), end)).collect(),
            None => vec![],
        },
    });
    let last = found.stretches.last().map_or(1.0, |piece| piece.last);
    let free = found.smallest.as_ref().map(|smallest| smallest.free);
    let mut marks: Vec<(f64, String)> = free
        .map(|free| (free, format!("no touch above {}", report::seconds(free, searched))))
        .into_iter()
        .collect();
    marks.extend(searched.given.map(|interval| (interval, format!("the scene: {interval} s"))));
    let parts = " (of one part: as wanted, or as it ends alone)";
    // What becomes of solid parts that touch is not followed, of others it is.
    let shown = |kind: &&Kind| match kind {
        Kind::Free | Kind::Blocked => true,
        Kind::Touching => searched.feed.is_none(),
        Kind::Harmless | Kind::Harmful | Kind::Unresolved => searched.feed.is_some(),
    };
    let legend = Kind::ALL.iter().filter(shown).map(|&kind| {
        let more = match kind {
            _ if searched.feed.is_none() => "",
            Kind::Free => parts,
            Kind::Harmful => " (of one part: it does)",
            Kind::Blocked => " (of one part: it does not start)",
            Kind::Harmless | Kind::Touching | Kind::Unresolved => "",
        };
        (fill(kind), format!("{}{more}", study::feed(kind)))
    });
    let legend: Vec<_> = legend.collect();
    intervals_svg(&IntervalStrips {
        title: match searched.feed {
            Some(feed) => {
                format!("{name}: what happens to {} parts, by the interval between them", feed.parts)
            }
            None => format!("{name}: whether parts touch, by the interval between them"),
        },
        subtitle: report::answer(searched),
        to: free.map_or(last, |free| ABOVE * free),
        pieces: pieces.collect(),
        marks,
        legend: legend.to_vec(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_study::Ending;

    #[test]
    fn a_part_does_no_harm_where_nothing_touches() {
        let outcome = Outcome::Delivered;
        let end = |as_wanted| End { ending: Ending::Stays, outcome, as_wanted };
        assert_eq!(fill_of_part(Kind::Free, &end(false)), IntervalFill::Good, "it goes its own way");
        assert_eq!(fill_of_part(Kind::Harmful, &end(false)), IntervalFill::Bad, "it was touched");
        assert_eq!(fill_of_part(Kind::Harmful, &end(true)), IntervalFill::Good, "another one was");
    }
}
