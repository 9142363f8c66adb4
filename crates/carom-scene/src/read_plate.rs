//! `[[plate]]`, `[zigzag]` and `[[wall]]`.

use crate::drawing::{
    COORDINATE, COUNT, ChannelDrawing, FeedDrawing, LENGTH, Level, PARTS, Place, PlateDrawing, Reach, SLOPE,
    Side, TIME, WallDrawing, Want, ZigzagDrawing,
};
use crate::node::Value;
use crate::problem::{Problem, ProblemKind};
use crate::quantity::{Allowed, Quantity};
use crate::read_part::read_surface;
use crate::section::{Section, expected};
use std::collections::BTreeSet;

const SIDES: [(&str, Side); 2] = [("left", Side::Left), ("right", Side::Right)];

/// The keys that begin a way to place a plate, and what else belongs to it.
const WAYS: [(&str, &[&str]); 5] = [
    ("wall", &["wall", "height", "drop", "slope", "gap", "length"]),
    ("line", &["line", "downhill"]),
    ("below", &["below", "slope", "downhill"]),
    ("edge", &["edge", "slope", "length", "downhill"]),
    ("from", &["from", "to"]),
];

/// Every key that places a plate.
const PLACING: [&str; 12] =
    ["wall", "height", "drop", "slope", "gap", "length", "line", "below", "edge", "from", "to", "downhill"];

/// What to write where a plate has no place.
const HOW: &str =
    "give wall + drop + slope + gap (or length), line, slope + below, edge + slope + length, or from + to";

/// Reads every `[[plate]]`; `None` in place of one that has problems.
pub(crate) fn read_plates(root: &Section<'_>) -> Vec<Option<PlateDrawing>> {
    let mut names: BTreeSet<String> = BTreeSet::new();
    let sections = root.sections("plate");
    sections
        .into_iter()
        .enumerate()
        .map(|(i, mut section)| {
            let name = read_name(&section, i, &names);
            section.rename(format!("plate.{name}"));
            names.insert(name.clone());
            let place = read_place(&section, i == 0);
            let surface = read_surface(&section);
            let want = read_want(&section);
            let span = section.span();
            section.finish();
            Some(PlateDrawing { name, place: place?, surface, want, span })
        })
        .collect()
}

/// The name of a plate or wall: its number where it has none.
fn read_name(section: &Section<'_>, number: usize, taken: &BTreeSet<String>) -> String {
    let Some((name, span)) = section.text("name") else { return number.to_string() };
    let wrong = if name.is_empty() {
        "a name needs at least one letter"
    } else if name.contains(['.', '"', '=', '\n']) {
        "a name has no dot, quote or equals sign: it stands in paths like plate.lower.slope"
    } else if name.parse::<usize>().is_ok_and(|n| n != number) {
        "a name that is a number must be its own number, counted from 0"
    } else if taken.contains(name) {
        "this name is taken: every plate needs its own"
    } else {
        return name.to_owned();
    };
    let problem = Problem::new(ProblemKind::WrongValue, section.path_of("name"), wrong, Some(span));
    section.sink().push(problem);
    number.to_string()
}

fn read_want(section: &Section<'_>) -> Option<Want> {
    let node = section.get("want")?;
    match &node.value {
        Value::Number(face) if Allowed::Face.holds(*face) => Some(Want::Face(*face as usize)),
        Value::Text(_) => {
            section.word("want", &[("same", Want::Same), ("turned", Want::Turned), ("any", Want::Any)])
        }
        _ => {
            let problem = expected("same, turned, any or a face number", &section.path_of("want"), node);
            section.sink().push(problem);
            None
        }
    }
}

fn read_place(section: &Section<'_>, first: bool) -> Option<Place> {
    // `to` alone is a slip of someone who means from + to.
    let begun = |way: &str| section.has(way) || (way == "from" && section.has("to"));
    let begun: Vec<&(&str, &[&str])> = WAYS.iter().filter(|(way, _)| begun(way)).collect();
    match begun[..] {
        [] if first => read_origin(section),
        [] => {
            ask(section);
            let stray: Vec<&str> = PLACING.into_iter().filter(|key| section.has(key)).collect();
            let message = if stray.is_empty() {
                "has no place".to_owned()
            } else {
                format!("has no place: {} alone does not say where it is", stray.join(" + "))
            };
            let problem =
                Problem::new(ProblemKind::MissingKey, section.path(), message, Some(section.span()));
            section.sink().push(problem.with_help(HOW));
            None
        }
        [(way, keys)] => {
            let stray: Vec<&str> =
                PLACING.into_iter().filter(|key| section.has(key) && !keys.contains(key)).collect();
            let place = read_way(section, way, first);
            if stray.is_empty() { place } else { two_ways(section, way, &stray) }
        }
        [(way, _), ref others @ ..] => {
            let others: Vec<&str> = others.iter().map(|(other, _)| *other).collect();
            two_ways(section, way, &others)
        }
    }
}

/// Marks every placing key as known.
fn ask(section: &Section<'_>) {
    for key in PLACING {
        section.get(key);
    }
}

fn two_ways(section: &Section<'_>, way: &str, others: &[&str]) -> Option<Place> {
    ask(section);
    let message = format!("is placed in two ways: by {way}, and by {}: keep one", others.join(", "));
    let span = Some(section.key_span(others[0]));
    let problem = Problem::new(ProblemKind::Conflict, section.path(), message, span);
    let keys = WAYS.iter().find(|(key, _)| *key == way).map_or(String::new(), |(_, keys)| keys.join(", "));
    section.sink().push(problem.with_help(format!("with {way} go only {keys}")));
    None
}

fn read_way(section: &Section<'_>, way: &str, first: bool) -> Option<Place> {
    let relative = matches!(way, "line" | "below");
    if first && relative {
        ask(section);
        let message = format!("the first plate has no plate before it that {way} could be measured from");
        let span = Some(section.key_span(way));
        let problem = Problem::new(ProblemKind::Geometry, section.path_of(way), message, span);
        section.sink().push(problem.with_help("leave its place out: its free edge is then the origin"));
        return None;
    }
    match way {
        "wall" => read_hinged(section, first),
        "line" => {
            let line = section.section("line");
            let downhill = section.word("downhill", &SIDES);
            let line = line?;
            let (along, normal) = (line.required("along", LENGTH), line.required("normal", LENGTH));
            line.finish();
            Some(Place::Line { along: along?, normal: normal?, downhill })
        }
        "below" => {
            let slope = section.required("slope", SLOPE);
            let downhill = section.word("downhill", &SIDES);
            let below = read_point(section, "below");
            Some(Place::Through { slope: slope?, below: below?, downhill })
        }
        "edge" => {
            let slope = section.required("slope", SLOPE);
            let length = section.required("length", LENGTH);
            let downhill = section.word("downhill", &SIDES);
            let edge = read_point(section, "edge");
            Some(Place::Edge { edge: edge?, slope: slope?, length: length?, downhill })
        }
        _ => {
            let (from, to) = read_ends(section);
            Some(Place::Ends { from: from?, to: to? })
        }
    }
}

/// A point: `[x, y]` or `{ x, y }`.
fn read_point(section: &Section<'_>, key: &'static str) -> Option<[Quantity; 2]> {
    match section.get(key)?.value {
        Value::Table(_) => {
            let point = section.section(key)?;
            let (x, y) = (point.required("x", COORDINATE), point.required("y", COORDINATE));
            point.finish();
            Some([x?, y?])
        }
        _ => section.pair(key, COORDINATE),
    }
}

fn read_ends(section: &Section<'_>) -> (Option<[Quantity; 2]>, Option<[Quantity; 2]>) {
    for key in ["from", "to"] {
        if !section.has(key) {
            section.missing(key, "a point [x, y]");
        }
    }
    (read_point(section, "from"), read_point(section, "to"))
}

fn read_origin(section: &Section<'_>) -> Option<Place> {
    let slope = section.required("slope", SLOPE);
    let length = section.quantity("length", LENGTH);
    let downhill = section.word("downhill", &SIDES).unwrap_or(Side::Right);
    for key in ["height", "drop", "gap"] {
        if section.has(key) {
            section.get(key);
            let message = "is for a plate that is hinged at a wall: wall = \"left\" or \"right\" is missing";
            let span = Some(section.key_span(key));
            let problem = Problem::new(ProblemKind::MissingKey, section.path_of(key), message, span);
            section.sink().push(problem);
        }
    }
    Some(Place::Origin { slope: slope?, length, downhill })
}

fn read_hinged(section: &Section<'_>, first: bool) -> Option<Place> {
    let wall = section.word("wall", &SIDES);
    let height = section.quantity("height", COORDINATE);
    let drop = section.quantity("drop", LENGTH);
    let slope = section.required("slope", SLOPE);
    let gap = section.quantity("gap", LENGTH);
    let length = section.quantity("length", LENGTH);
    if section.has("height") && section.has("drop") {
        both(section, "height", "drop");
    }
    if section.has("gap") && section.has("length") {
        both(section, "gap", "length");
    }
    let level = match (height, drop) {
        (Some(height), _) => Some(Level::Height(height)),
        (None, Some(drop)) => Some(Level::Drop(drop)),
        (None, None) if first && !section.has("height") && !section.has("drop") => {
            Some(Level::Height(Quantity::default_of(0.0, COORDINATE)))
        }
        (None, None) => {
            if !section.has("height") && !section.has("drop") {
                section.missing("drop", "a length below the previous hinge, or height");
            }
            None
        }
    };
    let reach = match (gap, length) {
        (Some(gap), _) => Some(Reach::Gap(gap)),
        (None, Some(length)) => Some(Reach::Length(length)),
        (None, None) => {
            if !section.has("gap") && !section.has("length") {
                section.missing("gap", "a length from the free edge to the other wall, or length");
            }
            None
        }
    };
    Some(Place::Hinged { wall: wall?, level: level?, slope: slope?, reach: reach? })
}

fn both(section: &Section<'_>, one: &str, other: &str) {
    let message = format!("is placed by both {one} and {other}: keep one");
    let span = Some(section.key_span(other));
    section.sink().push(Problem::new(ProblemKind::Conflict, section.path(), message, span));
}

/// Reads `[zigzag]`.
pub(crate) fn read_zigzag(root: &Section<'_>) -> Option<ZigzagDrawing> {
    let section = root.section("zigzag")?;
    let plates = section.required("plates", COUNT);
    let drop = section.required("drop", LENGTH);
    let slope = section.required("slope", SLOPE);
    let gap = section.required("gap", LENGTH);
    let height = section.quantity("height", COORDINATE);
    let wall = section.word("wall", &SIDES).unwrap_or(Side::Left);
    let surface = read_surface(&section);
    let want = read_want(&section);
    let span = section.span();
    section.finish();
    Some(ZigzagDrawing {
        plates: plates?,
        drop: drop?,
        slope: slope?,
        gap: gap?,
        height: height.unwrap_or_else(|| Quantity::default_of(0.0, COORDINATE)),
        wall,
        surface,
        want,
        span,
    })
}

/// Reads every `[[wall]]`.
pub(crate) fn read_walls(root: &Section<'_>) -> Vec<Option<WallDrawing>> {
    let mut names: BTreeSet<String> = BTreeSet::new();
    let sections = root.sections("wall");
    sections
        .into_iter()
        .enumerate()
        .map(|(i, mut section)| {
            let name = read_name(&section, i, &names);
            section.rename(format!("wall.{name}"));
            names.insert(name.clone());
            let (from, to) = read_ends(&section);
            let surface = read_surface(&section);
            let span = section.span();
            section.finish();
            Some(WallDrawing { name, from: from?, to: to?, surface, span })
        })
        .collect()
}

/// The longest time between two parts of a feed [s].
const LONGEST_INTERVAL: f64 = 3600.0;
/// Most parts of one feed.
const MOST_PARTS: f64 = 100.0;

/// Reads `[feed]`.
pub(crate) fn read_feed(root: &Section<'_>) -> Option<FeedDrawing> {
    let section = root.section("feed")?;
    let parts = section.required("parts", PARTS);
    let interval = section.required("interval", TIME);
    if let Some(parts) = parts.as_ref().filter(|parts| parts.value > MOST_PARTS) {
        let message = format!("{} must be at most {MOST_PARTS}", parts.value);
        root.sink().push(Problem::new(ProblemKind::OutOfRange, "feed.parts", message, parts.span.clone()));
    }
    if let Some(interval) = interval.as_ref().filter(|interval| interval.value > LONGEST_INTERVAL) {
        let message = format!("{} s must be at most {LONGEST_INTERVAL} s", interval.value);
        let span = interval.span.clone();
        root.sink().push(Problem::new(ProblemKind::OutOfRange, "feed.interval", message, span));
    }
    let surface = read_surface(&section);
    let span = section.span();
    section.finish();
    Some(FeedDrawing { parts: parts?, interval: interval?, surface, span })
}

/// Reads `[channel]`.
pub(crate) fn read_channel(root: &Section<'_>) -> Option<ChannelDrawing> {
    let section = root.section("channel")?;
    let width = section.required("width", LENGTH);
    let surface = read_surface(&section);
    section.finish();
    Some(ChannelDrawing { width: width?, surface })
}
