//! A whole scene: reads every table, then lays it out.

use crate::assemble::{Assembled, Readable, assemble, friction_missing, problems_of};
use crate::drawing::{Drawing, GRAVITY, PartDrawing, Place, PlateDrawing, StartDrawing, WallDrawing};
use crate::node::Node;
use crate::problem::{Problem, ProblemKind};
use crate::quantity::{Kind, Quantity};
use crate::read_design::read_design;
use crate::read_part::{read_contact, read_part, read_start};
use crate::read_plate::{read_channel, read_feed, read_plates, read_walls, read_zigzag};
use crate::section::{Section, Sink};
use carom_feeder::Stop;
use std::path::Path;

/// Standard of the papers [m/s²].
const DEFAULT_GRAVITY: f64 = 9.81;

/// The longest length that a plain number may be [m]: a feeder has no part, plate or drop so long, and whoever forgets the unit of
/// millimetres soon writes a larger number. With its unit any length may be written.
const LONGEST_PLAIN: f64 = 5.0;

const STOPS: [(&str, Stop); 2] = [("landed", Stop::Landed), ("delivered", Stop::Delivered)];

/// Reads a scene from its tree; the files that it names are looked for from `folder`.
pub(crate) fn read_scene(tree: &Node, folder: &Path) -> Result<(Drawing, Assembled), Vec<Problem>> {
    let sink = Sink::with_longest_plain(LONGEST_PLAIN);
    let Some(root) = Section::new("", tree, &sink) else { return Err(sink.into_list()) };
    if let Some(key) = ["body", "operator"].into_iter().find(|key| root.has(key)) {
        let message = "this is an impact, not a scene";
        let problem = Problem::new(ProblemKind::File, key, message, Some(root.key_span(key)));
        return Err(vec![problem.with_help("`carom impact` resolves it")]);
    }
    let drawing = read_drawing(&root, folder);
    let assembled = drawing.as_ref().and_then(|drawing| match assemble(drawing) {
        Ok(assembled) => Some(assembled),
        Err(problems) => {
            problems.into_iter().for_each(|problem| sink.push(problem));
            None
        }
    });
    let known = drawing.as_ref().map(known_kinds);
    let design = read_design(&root, known.as_deref());
    root.finish();
    let problems = sink.into_list();
    match (drawing, assembled) {
        (Some(drawing), Some(assembled)) if problems.is_empty() => {
            Ok((Drawing { design, ..drawing }, assembled))
        }
        _ => Err(problems),
    }
}

fn known_kinds(drawing: &Drawing) -> Vec<(String, Kind)> {
    let mut known = vec![];
    drawing.clone().visit(&mut |path, quantity| known.push((path.to_string(), quantity.kind)));
    known
}

/// Everything but `[design]`; `None` where a table has problems that leave it unknown.
fn read_drawing(root: &Section<'_>, folder: &Path) -> Option<Drawing> {
    let gravity =
        root.quantity("gravity", GRAVITY).unwrap_or_else(|| Quantity::default_of(DEFAULT_GRAVITY, GRAVITY));
    let stop = root.word("stop", &STOPS).unwrap_or_default();
    let part = read_part(root, folder);
    let contact = read_contact(root);
    let start = read_start(root);
    let channel = read_channel(root);
    let plates = read_plates(root);
    let zigzag = read_zigzag(root);
    let walls = read_walls(root);
    let feed = read_feed(root);
    no_plates(root, &plates);
    let unknown =
        !contact.friction_written && plates.iter().flatten().all(|plate| plate.surface.friction.is_none());
    let broken = (root.has("channel") && channel.is_none()) || (root.has("zigzag") && zigzag.is_none());
    let complete = complete(part.as_ref(), start.as_ref(), &plates, &walls);
    match complete {
        Some((part, start, plates, walls)) if !broken => Some(Drawing {
            gravity,
            stop,
            part,
            contact,
            start,
            channel,
            plates,
            zigzag,
            walls,
            feed,
            design: None,
        }),
        _ => {
            if unknown {
                root.sink().push(friction_missing());
            }
            // What could be read can still be judged. Where the channel could not, hinges have no place.
            let known = |plate: &&PlateDrawing| !broken || !matches!(plate.place, Place::Hinged { .. });
            let readable = Readable {
                part: part.as_ref(),
                start: start.as_ref(),
                channel: channel.as_ref(),
                plates: plates.iter().map(|plate| plate.as_ref().filter(known)).collect(),
                walls: walls.iter().flatten().collect(),
            };
            problems_of(&readable).into_iter().for_each(|problem| root.sink().push(problem));
            None
        }
    }
}

type Complete = (PartDrawing, StartDrawing, Vec<PlateDrawing>, Vec<WallDrawing>);

fn complete(
    part: Option<&PartDrawing>,
    start: Option<&StartDrawing>,
    plates: &[Option<PlateDrawing>],
    walls: &[Option<WallDrawing>],
) -> Option<Complete> {
    let plates = plates.iter().cloned().collect::<Option<Vec<_>>>()?;
    let walls = walls.iter().cloned().collect::<Option<Vec<_>>>()?;
    Some((part?.clone(), start?.clone(), plates, walls))
}

fn no_plates(root: &Section<'_>, plates: &[Option<PlateDrawing>]) {
    if root.has("zigzag") && !plates.is_empty() {
        let message = "[zigzag] makes all plates: it does not go together with [[plate]]";
        let span = Some(root.key_span("zigzag"));
        root.sink().push(Problem::new(ProblemKind::Conflict, "zigzag", message, span));
    }
    if !root.has("zigzag") && !root.has("plate") {
        let message = "missing: a feeder needs at least one plate, [[plate]] or [zigzag]";
        root.sink().push(Problem::new(ProblemKind::MissingKey, "plate", message, None));
    }
}
