//! A whole scene: holds it to its grammar, reads every table, then lays it out.

use crate::assemble::{Readable, problems_of};
use crate::drawing::{Drawing, PartDrawing, Place, PlateDrawing, StartDrawing, WallDrawing};
use crate::grammar::{Section, Sink, check, scene::SCENE};
use crate::input::Beside;
use crate::node::Node;
use crate::problem::Problem;
use crate::quantity::Kind;
use crate::read_design::read_design;
use crate::read_part::{read_contact, read_part};
use crate::read_plate::{read_channel, read_feed, read_pins, read_plates, read_walls, read_zigzag};
use crate::space::{is_in_space, read_solid};
use crate::start::read_start;

/// The longest length that a plain number may be [m]: a feeder has no part, plate or drop so long, and whoever forgets the unit of
/// millimetres soon writes a larger number. With its unit any length may be written.
pub(crate) const LONGEST_PLAIN: f64 = 5.0;

/// Reads a scene from its tree; the files that it names are looked for beside it.
///
/// `assemble` lays out what is drawn: in the plane or in space.
pub(crate) fn read_scene<A>(
    tree: &Node,
    beside: Beside<'_>,
    assemble: impl Fn(&Drawing) -> Result<A, Vec<Problem>>,
) -> Result<(Drawing, A), Vec<Problem>> {
    let sink = Sink::with_longest_plain(LONGEST_PLAIN);
    let root = check(&SCENE, tree, &sink).and_then(|table| Section::new(table, String::new(), tree, &sink));
    let Some(root) = root else { return Err(sink.into_list()) };
    let drawing = read_drawing(&root, beside);
    let assembled = drawing.as_ref().and_then(|drawing| match assemble(drawing) {
        Ok(assembled) => Some(assembled),
        Err(problems) => {
            problems.into_iter().for_each(|problem| sink.push(problem));
            None
        }
    });
    let known = drawing.as_ref().map(known_kinds);
    let design = read_design(&root, known.as_deref());
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
fn read_drawing(root: &Section<'_>, beside: Beside<'_>) -> Option<Drawing> {
    let part = if is_in_space(root) { read_solid(root, beside) } else { read_part(root, beside) };
    let start = read_start(root);
    let [channel, groove] = ["channel", "groove"].map(|key| read_channel(root, key));
    let plates = read_plates(root);
    let zigzag = read_zigzag(root);
    let walls = read_walls(root);
    let pins = read_pins(root).into_iter().collect::<Option<Vec<_>>>();
    let feed = read_feed(root);
    let broken = (root.has("channel") && channel.is_none())
        || (root.has("groove") && groove.is_none())
        || (root.has("zigzag") && zigzag.is_none())
        || pins.is_none();
    let complete = complete(part.as_ref(), start.as_ref(), &plates, &walls);
    // Without a plate there is nothing to lay out, which is told already.
    let empty = plates.is_empty() && zigzag.is_none();
    if let (Some((part, start, plates, walls)), false) = (complete, broken || empty) {
        return Some(Drawing {
            gravity: root.quantity_or_default("gravity")?,
            stop: root.word_or_default("stop"),
            part,
            contact: read_contact(root),
            start,
            channel,
            groove,
            plates,
            zigzag,
            walls,
            pins: pins?,
            feed,
            design: None,
        });
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
    problems_of(&readable).into_iter().for_each(|problem| root.push(problem));
    None
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
