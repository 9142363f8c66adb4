//! `[[plate]]`, `[zigzag]`, `[[wall]]`, `[feed]` and `[channel]`.

use crate::chain::{ChainDrawing, course_crosses_itself, read_chain};
use crate::drawing::{
    ChannelDrawing, FeedDrawing, Level, PinDrawing, Place, PlateDrawing, Reach, Side, WallCourse,
    WallDrawing, Want, ZigzagDrawing,
};
use crate::grammar::kind::COORDINATE;
use crate::grammar::{Section, can_stand_in_paths};
use crate::node::Value;
use crate::problem::{Problem, ProblemKind};
use crate::quantity::{Allowed, Quantity};
use crate::read_part::read_surface;
use std::collections::BTreeSet;
use std::ops::Range;

/// Reads every `[[plate]]`; `None` in place of one that has problems.
pub(crate) fn read_plates(root: &Section<'_>) -> Vec<Option<PlateDrawing>> {
    let mut names = Names::default();
    let plates = root.sections("plate").into_iter().enumerate();
    let plate = |(i, section): (usize, Option<Section<'_>>)| {
        let section = section?;
        let name = names.read(&section, i);
        Some(PlateDrawing {
            name,
            place: read_place(&section, i == 0)?,
            edge_radius: section.quantity_if_known("edge_radius"),
            width: section.quantity_if_known("width"),
            roll: section.quantity_if_known("roll"),
            side_walls: section.quantity_if_known("side_walls"),
            v_angle: section.quantity_if_known("v_angle"),
            surface: read_surface(&section),
            want: read_want(&section),
            span: section.span(),
        })
    };
    plates.map(plate).collect()
}

/// Names of plates or walls: each is its own.
#[derive(Default)]
struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// The name of a plate or wall: its number where it has none that can stand in a path.
    fn read(&mut self, section: &Section<'_>, number: usize) -> String {
        let name = self.good(section, number).unwrap_or_else(|| number.to_string());
        self.taken.insert(name.clone());
        name
    }

    fn good(&self, section: &Section<'_>, number: usize) -> Option<String> {
        let (name, span) = section.text("name")?;
        let wrong = if name.is_empty() {
            "a name needs at least one letter"
        } else if !can_stand_in_paths(name) {
            "a name has no dot, quote or equals sign: it stands in paths like plate.lower.slope"
        } else if name.parse::<usize>().is_ok_and(|n| n != number) {
            "a name that is a number must be its own number, counted from 0"
        } else if self.taken.contains(name) {
            "this name is taken: every plate needs its own"
        } else {
            return Some(name.to_owned());
        };
        section.push(Problem::new(ProblemKind::Name, section.path_of("name"), wrong, Some(span)));
        None
    }
}

fn read_want(section: &Section<'_>) -> Option<Want> {
    match section.get("want")?.value {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number from 0")]
        Value::Number(face) => Allowed::Face.holds(face).then_some(Want::Face(face as usize)),
        _ => section.word("want"),
    }
}

fn read_place(section: &Section<'_>, first: bool) -> Option<Place> {
    if let Some(way) = ["line", "below"].into_iter().find(|way| first && section.has(way)) {
        let message = format!("the first plate has no plate before it that {way} could be measured from");
        let span = Some(section.key_span(way));
        let problem = Problem::new(ProblemKind::Geometry, section.path_of(way), message, span);
        section.push(problem.with_help("leave its place out: its free edge is then the origin"));
        return None;
    }
    // Which keys go together is checked already: the first key of a way decides.
    let downhill = section.word("downhill");
    if section.has("wall") {
        return read_hinged(section, first);
    }
    if section.has("line") {
        let line = section.section("line")?;
        return Some(Place::Line {
            along: line.quantity("along")?,
            normal: line.quantity("normal")?,
            downhill,
        });
    }
    if section.has("from") || section.has("to") {
        return Some(Place::Ends { from: section.vector("from")?, to: section.vector("to")? });
    }
    if section.has("chain") && section.knows("chain") {
        return Some(Place::Chain { chain: read_bent(section)? });
    }
    let slope = section.quantity("slope")?;
    let length = section.quantity("length");
    if section.has("below") {
        return Some(Place::Through { slope, below: section.vector("below")?, downhill });
    }
    if section.has("edge") {
        return Some(Place::Edge { edge: section.vector("edge")?, slope, length: length?, downhill });
    }
    first.then(|| Place::Origin { slope, length, downhill: downhill.unwrap_or(Side::Right) })
}

/// Reads `chain` and `bend_radius`.
fn read_bent(section: &Section<'_>) -> Option<ChainDrawing> {
    let bend_radius = section.quantity("bend_radius");
    let chain = ChainDrawing { bend_radius, ..read_chain(section, "chain", false)? };
    let wrong = |key: &str, message: &str, span: Range<usize>| {
        vec![Problem::new(ProblemKind::Geometry, section.path_of(key), message, Some(span))]
    };
    let problems = match chain.points(false) {
        Err(problems) => problems,
        Ok(points) if course_crosses_itself(&points) => wrong("chain", "crosses itself", chain.span.clone()),
        // A corner that is rounded becomes two points.
        Ok(points) if chain.rounding().is_some() && points.len() == chain.stops.len() => wrong(
            "bend_radius",
            "rounds nothing: the chain has no corner between two straight stretches",
            section.key_span("bend_radius"),
        ),
        Ok(_) => vec![],
    };
    let good = problems.is_empty();
    problems.into_iter().for_each(|problem| section.push(problem));
    good.then_some(chain)
}

fn read_hinged(section: &Section<'_>, first: bool) -> Option<Place> {
    let level = if section.has("drop") {
        Level::Drop(section.quantity("drop")?)
    } else if section.has("height") || !first {
        Level::Height(section.quantity("height")?)
    } else {
        Level::Height(Quantity::default_of(0.0, COORDINATE))
    };
    let reach = match section.quantity("gap") {
        Some(gap) => Reach::Gap(gap),
        None => Reach::Length(section.quantity("length")?),
    };
    Some(Place::Hinged { wall: section.word("wall")?, level, slope: section.quantity("slope")?, reach })
}

/// Reads `[zigzag]`.
pub(crate) fn read_zigzag(root: &Section<'_>) -> Option<ZigzagDrawing> {
    let section = root.section_if_known("zigzag")?;
    Some(ZigzagDrawing {
        plates: section.quantity("plates")?,
        drop: section.quantity("drop")?,
        slope: section.quantity("slope")?,
        gap: section.quantity("gap")?,
        height: section.quantity_or_default("height")?,
        wall: section.word_or_default("wall"),
        surface: read_surface(&section),
        want: read_want(&section),
        span: section.span(),
    })
}

/// Reads every `[[wall]]`.
pub(crate) fn read_walls(root: &Section<'_>) -> Vec<Option<WallDrawing>> {
    let mut names = Names::default();
    let walls = root.sections("wall").into_iter().enumerate();
    let wall = |(i, section): (usize, Option<Section<'_>>)| {
        let section = section?;
        let name = names.read(&section, i);
        Some(WallDrawing {
            name,
            course: if section.has("chain") && section.knows("chain") {
                WallCourse::Chain { chain: read_bent(&section)? }
            } else {
                WallCourse::Ends { from: section.vector("from")?, to: section.vector("to")? }
            },
            edge_radius: section.quantity_if_known("edge_radius"),
            surface: read_surface(&section),
            span: section.span(),
        })
    };
    walls.map(wall).collect()
}

/// Reads every `[[pin]]` of a scene in space; `None` in place of one that has problems.
pub(crate) fn read_pins(root: &Section<'_>) -> Vec<Option<PinDrawing>> {
    if !root.knows("pin") {
        return vec![];
    }
    let mut names = Names::default();
    let pin = |(i, section): (usize, Option<Section<'_>>)| {
        let section = section?;
        let name = names.read(&section, i);
        let ends = ["from", "to"].map(|key| section.vector::<3>(key));
        let [Some(from), Some(to)] = ends else { return None };
        let radius = section.quantity("radius")?;
        Some(PinDrawing { name, ends: [from, to], radius, surface: read_surface(&section) })
    };
    root.sections("pin").into_iter().enumerate().map(pin).collect()
}

/// The longest time between two parts of a feed [s].
const LONGEST_INTERVAL: f64 = 3600.0;

/// Reads `[feed]`.
pub(crate) fn read_feed(root: &Section<'_>) -> Option<FeedDrawing> {
    let section = root.section_if_known("feed")?;
    let interval = section.quantity("interval");
    if let Some(interval) = interval.as_ref().filter(|interval| interval.value > LONGEST_INTERVAL) {
        let message = format!("{} s must be at most {LONGEST_INTERVAL} s", interval.value);
        let span = interval.span.clone();
        section.push(Problem::new(ProblemKind::OutOfRange, "feed.interval", message, span));
    }
    Some(FeedDrawing {
        parts: section.quantity("parts")?,
        interval: interval?,
        surface: read_surface(&section),
        span: section.span(),
    })
}

/// Reads `[channel]` or `[groove]`.
pub(crate) fn read_channel(root: &Section<'_>, key: &str) -> Option<ChannelDrawing> {
    let section = root.section_if_known(key)?;
    Some(ChannelDrawing { width: section.quantity("width")?, surface: read_surface(&section) })
}
