//! What must be said of a winner beside its numbers: its worst drops, ranges that end where it is, walls that it works by.

use super::{Designed, Winner};
use carom_scene::unit::Dimension;
use carom_scene::{DesignWorstReport, RangeEnd, Word, labelled};
use carom_words::part;
use std::collections::BTreeMap;

/// A value nearer to the end of its range than this share of the range is at the end: the last look around a design reaches no nearer.
const AT_END: f64 = 0.01;

/// The sentences, for the text and for the page.
pub(super) fn sentences(designed: &Designed<'_>, winner: &Winner) -> Vec<String> {
    let mut all = vec![worst_sentence(designed, winner)];
    for (path, end) in at_range_ends(designed, winner) {
        let value =
            designed.space.quantities().zip(&winner.values).find(|(quantity, _)| quantity.path == path);
        let shown = value.map_or(String::new(), |(quantity, value)| {
            format!(", {}", quantity.kind.dimension.show_digits(*value, 4))
        });
        let path = labelled(&path);
        all.push(format!("{path} is at the {end} end of its range{shown}: a wider range may do better"));
    }
    let feeder = winner.scene.feeder();
    let walls: Vec<String> = wall_strikes(winner)
        .map(|(wall, count)| (part::obstacle(feeder, feeder.plates.len() + wall), count))
        .map(|(wall, count)| match count {
            0 => format!("it touches the {wall}"),
            1 => format!("it strikes the {wall} once"),
            _ => format!("it strikes the {wall} {count} times"),
        })
        .collect();
    if !walls.is_empty() {
        all.push(format!(
            "where nothing varies {}: it works by its walls (forbid_walls = true looks for a layout that does not)",
            walls.join(", ")
        ));
    }
    all
}

fn worst_sentence(designed: &Designed<'_>, winner: &Winner) -> String {
    let (limits, worst) = (&designed.limits, &winner.worst);
    let against = |value: f64, limit: Option<f64>, unit: &str| match limit {
        None => String::new(),
        Some(limit) if value <= limit => format!(" (at most {limit} {unit}: kept)"),
        Some(limit) => format!(" (at most {limit} {unit}: NOT KEPT by all)"),
    };
    format!(
        "the worst of {} drops within the tolerances: struck at {:.3} m/s{}, sliding at {:.3} m/s{}, over after {:.3} s{}",
        worst.drops,
        worst.impact_speed,
        against(worst.impact_speed, limits.impact_speed, "m/s"),
        worst.sliding_speed,
        against(worst.sliding_speed, limits.sliding_speed, "m/s"),
        worst.time,
        against(worst.time, limits.time, "s"),
    )
}

/// The same for a program.
pub(super) fn worst(designed: &Designed<'_>, winner: &Winner) -> DesignWorstReport {
    let (limits, worst) = (&designed.limits, &winner.worst);
    let holds = |value: f64, limit: Option<f64>| limit.is_none_or(|limit| value <= limit);
    DesignWorstReport {
        impact_speed_m_s: worst.impact_speed,
        sliding_speed_m_s: worst.sliding_speed,
        time_s: worst.time,
        drops: worst.drops,
        limits_hold: holds(worst.impact_speed, limits.impact_speed)
            && holds(worst.sliding_speed, limits.sliding_speed)
            && holds(worst.time, limits.time),
    }
}

/// The quantities that are at an end of their range, and at which.
pub(super) fn at_range_ends(designed: &Designed<'_>, winner: &Winner) -> BTreeMap<String, Word<RangeEnd>> {
    let free = designed.scene.design().map(|design| design.free.as_slice()).unwrap_or_default();
    let mut found = BTreeMap::new();
    for (quantity, value) in designed.space.quantities().zip(&winner.values) {
        // A count has ends that mean something.
        let counted = quantity.kind.dimension == Dimension::Count;
        let Some(range) = free.iter().find(|free| free.path == quantity.path && !counted) else { continue };
        let near = AT_END * (range.high - range.low);
        if value - range.low <= near {
            found.insert(quantity.path.clone(), Word(RangeEnd::Low));
        } else if range.high - value <= near {
            found.insert(quantity.path.clone(), Word(RangeEnd::High));
        }
    }
    found
}

/// How often the winner strikes each wall that it touches, where nothing varies.
fn wall_strikes(winner: &Winner) -> impl Iterator<Item = (usize, usize)> {
    let (feeder, run) = (winner.scene.feeder(), &winner.run);
    let strikes = move |wall: usize| {
        let number = feeder.plates.len() + wall;
        let on = |i: &&carom_motion::planar::trace::Impact| i.contacts.iter().any(|c| c.obstacle == number);
        run.trace.impacts.iter().filter(on).count()
    };
    run.walls_touched.iter().map(move |wall| (*wall, strikes(*wall)))
}

/// The same by the names that paths have.
pub(super) fn wall_strikes_by_name(winner: &Winner) -> BTreeMap<String, usize> {
    let walls = &winner.scene.feeder().walls;
    wall_strikes(winner).map(|(wall, count)| (walls[wall].name.clone(), count)).collect()
}
