//! What a search for the interval of a feed says in words, as CSV and as JSON.

use super::{FeedStudy, Saved};
use crate::tasks::wants;
use carom_feeder::{Doing, Feed, Outcome};
use carom_figure::csv_cell;
use carom_motion::planar::Surface;
use carom_scene::{
    AloneReport, Drawn, EndingWord, FeedMeetingReport, FeedStretchReport, FeedStudyReport, OwnMeetingReport,
    SavedFeedReport, SmallestIntervalReport, StudyRunReport, Word,
};
use carom_study::feeds::{End, Happens, Kind, Meets, Smallest};
use carom_study::stretches::Stretch;
use carom_study::{Ending, Landed};
use carom_words::number::ascii as fixed;
use carom_words::part::Names;
use carom_words::{Words, aligned, part, study};
use std::fmt::Write as _;

/// Rows of the table for a person; the CSV has all.
const MOST_ROWS: usize = 24;

/// A time with one digit more than the accuracy has: it tells an interval with a touch from the next without.
pub(super) fn seconds(time: f64, searched: &FeedStudy<'_, impl Drawn>) -> String {
    let mut digits = 1;
    while digits < 12 && format!("1e-{digits}").parse::<f64>().is_ok_and(|one| one >= searched.plan.accuracy)
    {
        digits += 1;
    }
    format!("{time:.digits$} s")
}

/// What is wanted, in words.
fn wanted(searched: &FeedStudy<'_, impl Drawn>) -> String {
    wants(searched.scene.feeder(), searched.scene.wants()).unwrap_or_else(|| {
        let words = match searched.found.ending {
            Ending::Lies(verdict) => format!("{} on \"{}\"", carom_words::run::side(verdict), last(searched)),
            ending => on_last(ending, searched),
        };
        format!("{words}, as one part alone")
    })
}

/// The name of the last plate.
fn last(searched: &FeedStudy<'_, impl Drawn>) -> String {
    let feeder = searched.scene.feeder();
    part::obstacle(feeder, feeder.plate_count() - 1)
}

/// How a part ends on the last plate; where it stays on it, with its name.
fn on_last(ending: Ending, searched: &FeedStudy<'_, impl Drawn>) -> String {
    match ending {
        Ending::Stays => format!("stays on \"{}\"", last(searched)),
        other => study::ending(other),
    }
}

/// How a part ends on the last plate, and how its run ends.
fn end_in_words(ending: Ending, outcome: Outcome, searched: &FeedStudy<'_, impl Drawn>) -> String {
    let ended = outcome.word().replace('_', " ");
    match ending {
        Ending::Otherwise(Outcome::Delivered) => "delivered before it lay flat".to_owned(),
        Ending::Otherwise(other) if other == outcome => ended,
        Ending::Stays => format!("{}, then {ended}", on_last(ending, searched)),
        _ => format!("{}, {ended}", study::ending(ending)),
    }
}

/// Part 2, in flight from "upper".
fn doing(feeder: &impl Names, part: usize, doing: Doing) -> String {
    let plate = part::obstacle(feeder, doing.obstacle);
    match doing.stage.map(|stage| stage.word()) {
        None => format!("part {} at its start", part + 1),
        Some("flight") => format!("part {} in flight from \"{plate}\"", part + 1),
        Some(stage) => format!("part {} ({stage} on \"{plate}\")", part + 1),
    }
}

fn meeting(feeder: &impl Names, meets: &Meets) -> String {
    let [ahead, behind] = [0, 1].map(|k| doing(feeder, meets.parts[k], meets.doing[k]));
    let does = if meets.blocked { "finds in its place" } else { "touches" };
    format!("{behind} {does} {ahead}")
}

/// The answer in a sentence.
pub(super) fn answer(searched: &FeedStudy<'_, impl Drawn>) -> String {
    match &searched.found.smallest {
        Some(Smallest { free, .. }) => format!(
            "smallest interval without touch {}: {} parts a minute",
            seconds(*free, searched),
            fixed(60.0 / free, 1)
        ),
        None if searched.found.longest.is_some() => "no interval without touch was found".to_owned(),
        None => format!("no interval is free of touch: {}", staying(searched)),
    }
}

/// Where one part alone comes to rest, and that later ones come to it.
fn staying(searched: &FeedStudy<'_, impl Drawn>) -> String {
    let place = searched.found.rests_on;
    let place =
        place.map_or(String::new(), |o| format!(" on \"{}\"", part::obstacle(searched.scene.feeder(), o)));
    let outcome = searched.found.alone.outcome().word().replace('_', " ");
    format!("one part alone comes to rest{place} ({outcome}), and later ones pile up")
}

/// Which parts are followed, and how far.
fn followed(searched: &FeedStudy<'_, impl Drawn>) -> String {
    let until = "followed until it has left the last plate or rests";
    let Some(Feed { parts, between: Surface { friction, restitution }, .. }) = searched.feed else {
        return format!(
            "one part alone is {until}: whether others touch it does not depend on how many there are; what those do that touch is not followed"
        );
    };
    let said = if searched.given.is_some() { "" } else { ", as contacts of [contact]" };
    format!(
        "{parts} parts, friction {friction} and restitution {restitution} between them{said}; each is {until}"
    )
}

impl<S: Drawn> FeedStudy<'_, S> {
    /// What it says to a person; `seconds_spent` is how long it took.
    pub fn text(&self, seconds_spent: f64) -> String {
        let searched = self;
        let (found, feeder) = (&searched.found, searched.scene.feeder());
        let scene = searched.scene;
        let mut text = format!("{}: {}\n", scene.name(), answer(searched));
        // Writing to a String cannot fail.
        if let Some(smallest) = &found.smallest {
            let at = seconds(smallest.touching, searched);
            let _ = match &smallest.meets {
                Some(meets) => {
                    let plate = part::obstacle(feeder, meets.doing[0].obstacle);
                    writeln!(text, "limited by \"{plate}\": at {at} {}", meeting(feeder, meets))
                }
                None => writeln!(text, "below it: at {at} {}", study::feed(smallest.below)),
            };
            if let Some(longest) = &found.longest {
                let _ = writeln!(
                    text,
                    "the way of one part alone meets itself at no interval above {}",
                    seconds(longest.high, searched)
                );
            }
        }
        let _ = writeln!(text, "{}", followed(searched));
        let _ = writeln!(text, "one part alone: {} after {:.3} s", alone(searched), found.alone.end_time());
        let _ = writeln!(text, "wanted: {}\n", wanted(searched));
        text += &table(searched);
        if found.unresolved > 0.0 {
            let _ = writeln!(
                text,
                "not looked into: {:.6} s of the intervals, where what happens changes from one to the next",
                found.unresolved
            );
        }
        let _ = match searched.feed {
            Some(_) => writeln!(text, "{} feeds, {:.2} s\n", found.runs, seconds_spent),
            None => writeln!(text, "{:.2} s\n", seconds_spent),
        };
        text
    }

    /// One line a stretch.
    pub fn csv(&self) -> String {
        let searched = self;
        let feeder = searched.scene.feeder();
        let mut out = String::from(
            "from_s,to_s,what,part_ahead,part_behind,stage_ahead,plate_ahead,stage_behind,plate_behind",
        );
        for part in 1..=searched.parts() {
            let _ = write!(out, ",part_{part}");
        }
        out.push('\n');
        for piece in &searched.found.stretches {
            let _ = write!(out, "{},{},{}", piece.first, piece.last, piece.label.kind().word());
            match &piece.label.meets {
                None => out += ",,,,,,",
                Some(meets) => {
                    let [a, b] = meets.parts;
                    let _ = write!(out, ",{},{}", a + 1, b + 1);
                    for doing in meets.doing {
                        let stage = doing.stage.map_or("start", |stage| stage.word());
                        let _ = write!(out, ",{stage},{}", csv_cell(feeder.given(doing.obstacle)));
                    }
                }
            }
            for end in &piece.label.ends {
                let _ = write!(out, ",{}", csv_cell(&end_in_words(end.ending, end.outcome, searched)));
            }
            out.push('\n');
        }
        out
    }

    /// What it says to a program; `run` says what it took.
    pub fn summary(&self, run: StudyRunReport) -> FeedStudyReport {
        let searched = self;
        let (found, feeder) = (&searched.found, searched.scene.feeder());
        let meeting = |meets: &Meets| FeedMeetingReport::new(feeder, meets);
        let smallest = found.smallest.as_ref().map(|smallest| SmallestIntervalReport {
            interval_s: smallest.free,
            touching_s: smallest.touching,
            below: Word(smallest.below),
            parts_per_minute: 60.0 / smallest.free,
            limited_by: smallest.meets.map(|meets| feeder.given(meets.doing[0].obstacle).to_owned()),
            first: smallest.meets.as_ref().map(meeting),
        });
        let saved = self.saved().map(|saved: Saved| SavedFeedReport {
            file: saved.file.to_owned(),
            why: saved.why,
            interval_s: saved.interval,
        });
        FeedStudyReport {
            scene: searched.scene.name().to_owned(),
            approximations: searched.scene.approximations().to_vec(),
            parts: searched.feed.map(|feed| feed.parts),
            friction: searched.feed.map(|feed| feed.between.friction),
            restitution: searched.feed.map(|feed| feed.between.restitution),
            wanted: wanted(searched),
            accuracy_s: searched.plan.accuracy,
            alone: AloneReport {
                ending: EndingWord(found.ending),
                outcome: Word(found.alone.outcome()),
                end_s: found.alone.end_time(),
            },
            smallest,
            piles_up: found.piles_up(),
            own_meeting: found.longest.map(|own| OwnMeetingReport { low_s: own.low, high_s: own.high }),
            stretches: found.stretches.iter().map(|piece| FeedStretchReport::new(feeder, piece)).collect(),
            unresolved_s: found.unresolved,
            saved: saved.collect(),
            feeds: found.runs,
            run,
        }
    }
}

fn alone(searched: &FeedStudy<'_, impl Drawn>) -> String {
    end_in_words(searched.found.ending, searched.found.alone.outcome(), searched)
}

/// How parts first touch in a feed, or that it is not resolved whether they do.
type FirstTouch = (Option<Meets>, bool);
/// Neighbouring stretches that begin with one touch, the longest intervals first.
type Group<'f> = (FirstTouch, Vec<&'f Stretch<Happens>>);

fn first_touch(happens: &Happens) -> FirstTouch {
    (happens.meets, happens.meets.is_none() && !happens.is_free())
}

fn grouped<'f>(searched: &'f FeedStudy<'_, impl Drawn>) -> Vec<Group<'f>> {
    let mut groups: Vec<Group<'f>> = vec![];
    for piece in searched.found.stretches.iter().rev() {
        match groups.last_mut() {
            Some((first, pieces)) if *first == first_touch(&piece.label) => pieces.push(piece),
            _ => groups.push((first_touch(&piece.label), vec![piece])),
        }
    }
    groups
}

/// In which column of shares a feed counts.
fn column(happens: &Happens) -> usize {
    match happens.kind() {
        Kind::Free if happens.ends.iter().all(|end| end.as_wanted) => 0,
        Kind::Harmless => 0,
        Kind::Free | Kind::Harmful => 1,
        Kind::Blocked => 2,
        Kind::Touching | Kind::Unresolved => 3,
    }
}

/// The share that ends as is wanted, otherwise, with a part that does not start, and unresolved, in percent of the intervals that were followed.
fn shares(pieces: &[&Stretch<Happens>]) -> [String; 4] {
    let length = |own: Option<usize>| {
        let own = pieces.iter().filter(|piece| own.is_none_or(|own| column(&piece.label) == own));
        own.map(|piece| piece.last - piece.first).sum::<f64>()
    };
    let (whole, any) = (length(None), |own: usize| pieces.iter().any(|piece| column(&piece.label) == own));
    [0, 1, 2, 3].map(|own| match any(own) {
        true if whole > 0.0 => fixed(100.0 * length(Some(own)) / whole, 1),
        true => fixed(100.0, 1),
        false => "-".to_owned(),
    })
}

/// What happens at which interval, the longest first.
fn table(searched: &FeedStudy<'_, impl Drawn>) -> String {
    let feeder = searched.scene.feeder();
    let groups = grouped(searched);
    let outcomes = ["as wanted %", "otherwise %", "no start %", "unresolved %"].map(str::to_owned);
    // What becomes of solid parts that touch is not followed.
    let with = |outcomes: [String; 4]| outcomes.into_iter().filter(|_| searched.feed.is_some());
    let mut rows = vec![["from s", "to s"].map(str::to_owned).to_vec()];
    rows[0].extend(with(outcomes));
    rows[0].push("first touch".to_owned());
    for ((meets, unresolved), pieces) in groups.iter().take(MOST_ROWS) {
        let (Some(longest), Some(shortest)) = (pieces.first(), pieces.last()) else { continue };
        let mut row =
            [shortest.first, longest.last].map(|at| seconds(at, searched).replace(" s", "")).to_vec();
        row.extend(with(shares(pieces)));
        let none = if *unresolved { Kind::Unresolved } else { Kind::Free };
        row.push(meets.as_ref().map_or(study::feed(none).to_owned(), |meets| meeting(feeder, meets)));
        rows.push(row);
    }
    let mut text = aligned(&rows);
    if groups.len() > MOST_ROWS {
        let _ = writeln!(text, "... {} more", groups.len() - MOST_ROWS);
    }
    let harmful = searched.found.stretches.iter().rev().find(|piece| piece.label.kind() == Kind::Harmful);
    if let Some(piece) = harmful {
        let at = seconds(piece.last, searched);
        let _ = writeln!(
            text,
            "\nthe longest interval at which a part ends otherwise is {at}: {}",
            ends(&piece.label.ends, searched)
        );
    }
    text + "\n"
}

/// What becomes of those that end otherwise.
fn ends(ends: &[End], searched: &FeedStudy<'_, impl Drawn>) -> String {
    let others = ends.iter().enumerate().filter(|(_, end)| !end.as_wanted);
    let words = others
        .map(|(part, end)| format!("part {}: {}", part + 1, end_in_words(end.ending, end.outcome, searched)));
    words.collect::<Vec<_>>().join(", ")
}
