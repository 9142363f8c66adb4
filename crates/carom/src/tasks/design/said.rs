//! What is said of a search: of its winner beside its numbers, or why there is none.

use super::{DesignStudy, Designed, Winner};
use carom_scene::unit::Dimension;
use carom_scene::{DesignWorstReport, RangeEnd, Word, labelled};
use carom_study::design::{Demand, ENOUGH, Forbidden};
use carom_study::{Ending, Landed};
use carom_words::number::fixed;
use carom_words::part::Names;
use carom_words::{Words, part, study};
use std::collections::BTreeMap;

/// The unit of what a demand measures; empty where it measures nothing.
///
/// # Example
/// ```
/// use carom::study::design::Demand;
/// assert_eq!(carom::tasks::design::unit(Demand::Height), "m");
/// ```
pub fn unit(demand: Demand) -> &'static str {
    match demand {
        Demand::Drawable | Demand::Clear | Demand::Wanted | Demand::Walls | Demand::ComesOut => "",
        Demand::ImpactSpeed | Demand::SlidingSpeed => "m/s",
        Demand::Height | Demand::Width => "m",
        Demand::Time => "s",
    }
}

impl<S: Designed> DesignStudy<'_, S> {
    /// What must be said of the winner beside its numbers: its worst drops, ranges that end where it is, walls that it works by.
    pub fn said(&self) -> Vec<String> {
        self.winner.as_ref().map(|winner| sentences(self, winner)).unwrap_or_default()
    }

    /// What stands in the way, demand by demand, as a table with its head; empty where nothing does.
    pub fn forbidden_rows(&self) -> Vec<Vec<String>> {
        let head = ["demand", "limit", "fail it", "fail it alone", "nearest of these"];
        let row = |f: &Forbidden| {
            let show =
                |value: Option<f64>| value.map_or("-".to_owned(), |v| format!("{v:.4} {}", unit(f.demand)));
            vec![
                f.demand.word().to_owned(),
                show(self.limits.of(f.demand)),
                f.failed.to_string(),
                f.alone.to_string(),
                show(f.nearest),
            ]
        };
        let failed = self.found.forbidden.iter().filter(|f| f.failed > 0).map(row);
        let mut rows = vec![head.map(str::to_owned).to_vec()];
        rows.extend(failed);
        if rows.len() > 1 { rows } else { vec![] }
    }

    /// Why no layout meets what is asked; empty where one does.
    pub fn impossible(&self) -> String {
        if self.winner.is_some() { String::new() } else { not_possible(self) }
    }
}

impl<S: Designed> Winner<S> {
    /// How the part comes to lie on every plate but the one it starts on, in words.
    pub fn delivered(&self) -> Vec<String> {
        let feeder = self.scene.feeder();
        let end =
            |i| format!("{} on \"{}\"", study::ending(Ending::of(&self.run, i)), part::obstacle(feeder, i));
        (1..feeder.plate_count()).map(end).collect()
    }

    /// Pose and speed in which the part leaves the last plate.
    pub fn afterwards(&self) -> String {
        let feeder = self.scene.feeder();
        let last = part::obstacle(feeder, feeder.plate_count() - 1);
        let Some(exit) = S::leaving(&self.to_the_end) else {
            let word = self.to_the_end.outcome().word().replace('_', " ");
            return format!("it does not leave \"{last}\": {word} after {:.3} s", self.to_the_end.end_time());
        };
        let (below, turned) = (exit.below.to_degrees(), &exit.turned);
        format!(
            "leaves \"{last}\" after {:.3} s at {:.3} m/s, {below:.1}° below the horizontal, {turned}",
            exit.time, exit.speed
        )
    }
}

fn not_possible(designed: &DesignStudy<'_, impl Designed>) -> String {
    let mut text = format!("{}: NOT POSSIBLE", designed.scene.name());
    let failed = |demand: Demand| {
        designed.found.forbidden.iter().filter(|f| f.demand == demand).map(|f| f.failed).sum::<u64>()
    };
    let (undrawable, unwanted) = (failed(Demand::Drawable), failed(Demand::Wanted));
    // What cannot be drawn says nothing about what can, unless nothing can; nor what ends otherwise, where some end as wanted.
    let decides = |f: &&Forbidden| match f.demand {
        Demand::Drawable => undrawable == designed.found.scanned,
        Demand::Wanted => undrawable + unwanted == designed.found.scanned,
        _ => true,
    };
    let alone = designed.found.forbidden.iter().filter(|f| f.alone > 0).filter(decides);
    let decisive = alone.max_by_key(|f| f.alone);
    // Where some meet every demand it is their yield that does not suffice.
    let decisive = decisive.filter(|_| designed.found.met == 0);
    text += &match decisive {
        Some(f) => match (f.nearest, designed.limits.of(f.demand)) {
            (Some(nearest), Some(limit)) => format!(
                ": {} forbids it. Of the layouts looked at that meet all else the best has {nearest:.4} {u}; at most {limit} {u} is allowed\n",
                f.demand.word(),
                u = unit(f.demand)
            ),
            _ => format!(": no layout meets the demand that {}\n", f.demand.word()),
        },
        None if designed.found.met > 0 => {
            format!(": no layout has a yield of {} %\n", fixed(100.0 * ENOUGH, 0))
        }
        None => ": every layout fails several demands at once\n".to_owned(),
    };
    text
}

/// A value nearer to the end of its range than this share of the range is at the end: the last look around a design reaches no nearer.
const AT_END: f64 = 0.01;

fn sentences<S: Designed>(designed: &DesignStudy<'_, S>, winner: &Winner<S>) -> Vec<String> {
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
        .map(|(wall, count)| (part::obstacle(feeder, feeder.plate_count() + wall), count))
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

fn worst_sentence<S: Designed>(designed: &DesignStudy<'_, S>, winner: &Winner<S>) -> String {
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
pub(super) fn worst<S: Designed>(designed: &DesignStudy<'_, S>, winner: &Winner<S>) -> DesignWorstReport {
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
pub(super) fn at_range_ends<S: Designed>(
    designed: &DesignStudy<'_, S>,
    winner: &Winner<S>,
) -> BTreeMap<String, Word<RangeEnd>> {
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
fn wall_strikes<S: Designed>(winner: &Winner<S>) -> impl Iterator<Item = (usize, usize)> {
    let (plates, run) = (winner.scene.feeder().plate_count(), &winner.run);
    run.walls_touched().iter().map(move |wall| (*wall, S::strikes(run, plates + wall)))
}

/// The same by the names that paths have.
pub(super) fn wall_strikes_by_name<S: Designed>(winner: &Winner<S>) -> BTreeMap<String, usize> {
    let feeder = winner.scene.feeder();
    let name = |wall: usize| feeder.given(feeder.plate_count() + wall).to_owned();
    wall_strikes(winner).map(|(wall, count)| (name(wall), count)).collect()
}
