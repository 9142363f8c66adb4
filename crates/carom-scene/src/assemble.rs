//! From a drawing to a feeder, with the checks that need the whole.

use crate::approximation::Approximation;
use crate::crossing::crosses;
use crate::drawing::{
    ChannelDrawing, Drawing, Level, PartDrawing, Place, PlateDrawing, StartDrawing, WallCourse, WallDrawing,
    Want,
};
use crate::feed::feed_of;
use crate::layout::{Placed, Yard, zigzag_plates};
use crate::part::{Built, build_part};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::start::resting;
use crate::surfaces::{contact_notes, surface_of};
use crate::unit::Dimension;
use carom_feeder::{Feed, Feeder, FeederProblem, Form, Part, PartKind, Plate, RunError, Start, Stop, Wall};
use carom_impact::Law;
use carom_motion::planar::{ChainPoint, Options, Pose};
use carom_num::Vec2;
use carom_study::Device;
use carom_words::part::{self, Names};
use std::ops::Range;

/// How far a channel's walls reach above and below its plates, in lengths of the part's run and size.
const WALL_REACH: f64 = 10.0;

/// A feeder and what is known about its drawing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Assembled {
    pub(crate) feeder: Feeder,
    /// The point of the part's drawing that is its mass centre [m].
    pub(crate) origin: Vec2,
    pub(crate) notes: Vec<String>,
    pub(crate) approximations: Vec<Approximation>,
    pub(crate) wants: Vec<Option<Want>>,
    pub(crate) feed: Option<Feed>,
}

/// What the engine finds that the file does not say in these words.
pub(crate) fn engine_problems(error: RunError, drawn: &[PlateDrawing]) -> Vec<Problem> {
    let problem = |path: &str, message: String| Problem::new(ProblemKind::Geometry, path, message, None);
    match error {
        RunError::Problems(found) => found
            .into_iter()
            .map(|found| match found {
                FeederProblem::OutOfRange { path, value, allowed } => drawn
                    .iter()
                    .find_map(|plate| end_out_of_range(plate, &path, value, allowed))
                    .unwrap_or_else(|| problem(&path, format!("{value} is out of range: {allowed}"))),
                FeederProblem::Form { path, why } => match of_path(drawn, &path) {
                    // A thin plate has its course alone; of a sheet it is the radius that does not fit it.
                    Some(plate) => match &plate.edge_radius {
                        Some(radius) => {
                            let path = format!("{path}.edge_radius");
                            let span = radius.span.clone().or_else(|| Some(plate.span.clone()));
                            let message = format!("{}: {why}", Dimension::Length.show(radius.value));
                            Problem::new(ProblemKind::Geometry, path, message, span)
                        }
                        None => Problem::new(ProblemKind::Geometry, path, why, Some(plate.span.clone())),
                    },
                    None => problem(&path, why.to_owned()),
                },
                FeederProblem::NoLength { path } => problem(&path, "has no length".into()),
                FeederProblem::CrossesStart { path } => {
                    let span = of_path(drawn, &path).map(|plate| plate.span.clone());
                    Problem::new(ProblemKind::Geometry, path, "crosses the part where it starts", span)
                }
                FeederProblem::World { why } => problem("", why),
                FeederProblem::NoPlates => problem("plate", found.to_string()),
            })
            .collect(),
        other => vec![problem("", other.to_string())],
    }
}

/// The plate of a path such as `plate.lower`.
fn of_path<'d>(drawn: &'d [PlateDrawing], path: &str) -> Option<&'d PlateDrawing> {
    drawn.iter().find(|plate| path.strip_prefix("plate.") == Some(plate.name.as_str()))
}

/// An end of a plate that is out of range, by the key that puts it there; none where the file writes the end itself.
fn end_out_of_range(plate: &PlateDrawing, path: &str, value: f64, allowed: &str) -> Option<Problem> {
    let (end, axis) = match path.strip_prefix("plate.")?.strip_prefix(plate.name.as_str())? {
        ".from.x" => ("uphill end", "x"),
        ".from.y" => ("uphill end", "y"),
        ".to.x" => ("free edge", "x"),
        ".to.y" => ("free edge", "y"),
        _ => return None,
    };
    let (key, span) = match &plate.place {
        Place::Hinged { level: Level::Drop(drop), .. } => ("drop", &drop.span),
        Place::Hinged { level: Level::Height(height), .. } => ("height", &height.span),
        Place::Origin { length: Some(length), .. } => ("length", &length.span),
        Place::Through { below: [_, y], .. } => ("below", &y.span),
        Place::Edge { edge: [_, y], .. } => ("edge", &y.span),
        Place::Line { along, .. } => ("line", &along.span),
        Place::Origin { length: None, .. } | Place::Ends { .. } | Place::Chain { .. } => return None,
    };
    let place = Dimension::Length.show(value);
    let message = format!("its {end} would be at {axis} = {place}: {allowed}");
    let span = span.clone().or_else(|| Some(plate.span.clone()));
    Some(Problem::new(ProblemKind::Geometry, format!("plate.{}.{key}", plate.name), message, span))
}

/// The tables of a drawing that could be read, of one that has problems elsewhere.
pub(crate) struct Readable<'a> {
    pub(crate) part: Option<&'a PartDrawing>,
    pub(crate) start: Option<&'a StartDrawing>,
    pub(crate) channel: Option<&'a ChannelDrawing>,
    pub(crate) plates: Vec<Option<&'a PlateDrawing>>,
    pub(crate) walls: Vec<&'a WallDrawing>,
}

/// What is wrong with what could be read: the part by itself, places, and what crosses the part where it starts.
pub(crate) fn problems_of(readable: &Readable<'_>) -> Vec<Problem> {
    let mut problems = vec![];
    let built = readable.part.and_then(|part| build_part(part).map_err(|found| problems.extend(found)).ok());
    let size = built.as_ref().map(|built| 2.0 * built.part.body.shape.size());
    // Only how far plates without a length reach depends on it.
    let run = readable.start.zip(size).map_or(1.0, |(start, size)| start.to_edge.value + size);
    let (placed, found) = Yard { channel: readable.channel, part: run }.place_all(&readable.plates);
    problems.extend(found);
    if let (Some(built), Some(start), Some(Some(first))) = (built, readable.start, placed.first()) {
        let plates = readable.plates.iter().zip(&placed).skip(1);
        let mut others: Vec<Obstacle> =
            plates.filter_map(|(drawn, placed)| Some(plate_obstacle((*drawn)?, placed.as_ref()?))).collect();
        others.extend(readable.walls.iter().map(|wall| wall_obstacle(wall)));
        problems.extend(start_problems(start, &built.part, first, &others));
    }
    problems
}

/// Lays out a drawing.
pub(crate) fn assemble(drawing: &Drawing) -> Result<Assembled, Vec<Problem>> {
    let zigzag = drawing.zigzag.as_ref().map(zigzag_plates);
    let drawn: &[PlateDrawing] = zigzag.as_deref().unwrap_or(&drawing.plates);
    let mut problems = vec![];
    let built = build_part(&drawing.part).map_err(|found| problems.extend(found)).ok();
    let part = drawing.start.to_edge.value + built.as_ref().map_or(0.0, |b| 2.0 * b.part.body.shape.size());
    let yard = Yard { channel: drawing.channel.as_ref(), part };
    let (placed, found) = yard.place_all(&drawn.iter().map(Some).collect::<Vec<_>>());
    problems.extend(found);
    let Some(built) = built else { return Err(problems) };
    problems.extend(face_problems(drawing, drawn, &built.part));
    if let Some(Some(first)) = placed.first() {
        let others = obstacles(drawing, drawn, &placed, part);
        problems.extend(start_problems(&drawing.start, &built.part, first, &others));
    }
    let feed = feed_of(drawing).unwrap_or_else(|found| {
        problems.extend(found);
        None
    });
    let Some(placed) = placed.into_iter().collect::<Option<Vec<Placed>>>() else { return Err(problems) };
    let face = drawing.start.faces.usual(|| resting(&built.part.body.shape));
    let feeder = Feeder {
        gravity: drawing.gravity.value,
        stop: drawing.stop,
        law: drawing.contact.law,
        part: built.part,
        start: Start { to_edge: drawing.start.to_edge.value, speed: drawing.start.speed.value, face },
        plates: drawn.iter().zip(&placed).map(|(drawn, placed)| plate(drawing, drawn, placed)).collect(),
        walls: walls(drawing, &placed, part),
    };
    if problems.is_empty() {
        // What the engine asks for has been checked above, with places in the file; what it finds beyond that has none.
        let found = feeder.prepare(Options::default()).err();
        problems.extend(found.into_iter().flat_map(|found| engine_problems(found, drawn)));
    }
    if problems.is_empty() {
        let wants = drawn.iter().map(|plate| plate.want).collect();
        let mut notes = built.notes;
        notes.extend(contact_notes(drawing));
        notes.extend(crossing_notes(&feeder));
        let Built { origin, approximations, .. } = built;
        Ok(Assembled { feeder, origin, notes, approximations, wants, feed })
    } else {
        Err(problems)
    }
}

/// What is said of plates that cross.
pub(crate) fn crossing_notes<F: Device + Names>(feeder: &F) -> Vec<String> {
    let note = |(i, j): (usize, usize)| {
        let [a, b] = [i, j].map(|plate| part::obstacle(feeder, plate));
        format!("plates \"{a}\" and \"{b}\" cross: such a feeder can be run, but not built")
    };
    feeder.crossing_plates().into_iter().map(note).collect()
}

/// The plates in their places, of a drawing without a zig-zag; a part's run on the first plate and its size are so long together \[m\].
pub(crate) fn laid_out(drawing: &Drawing, part: f64) -> (Option<Vec<Placed>>, Vec<Problem>) {
    let yard = Yard { channel: drawing.channel.as_ref(), part };
    let (placed, problems) = yard.place_all(&drawing.plates.iter().map(Some).collect::<Vec<_>>());
    (placed.into_iter().collect(), problems)
}

pub(crate) fn plate(drawing: &Drawing, drawn: &PlateDrawing, placed: &Placed) -> Plate {
    let (friction, restitution) = surface_of(drawing, &drawn.surface);
    Plate {
        name: drawn.name.clone(),
        uphill: placed.uphill,
        edge: placed.edge,
        friction,
        restitution,
        unbounded: placed.unbounded,
        form: form(placed.course.clone(), drawn.edge_radius.as_ref()),
    }
}

fn form(course: Vec<ChainPoint>, edge_radius: Option<&Quantity>) -> Form {
    Form { course, edge_radius: edge_radius.map_or(0.0, |radius| radius.value) }
}

/// Ends and form of a wall; none where its chain is none.
fn wall_course(wall: &WallDrawing) -> Option<(Vec2, Vec2, Form)> {
    let point = |pair: &[Quantity; 2]| Vec2::new(pair[0].value, pair[1].value);
    let (from, to, course) = match &wall.course {
        WallCourse::Ends { from, to } => (point(from), point(to), vec![]),
        WallCourse::Chain { chain } => {
            let course = chain.points(false).ok()?;
            (course.first()?.at, course.last()?.at, course)
        }
    };
    Some((from, to, form(course, wall.edge_radius.as_ref())))
}

pub(crate) fn walls(drawing: &Drawing, placed: &[Placed], part: f64) -> Vec<Wall> {
    let mut walls: Vec<Wall> = drawing
        .walls
        .iter()
        .filter_map(|wall| {
            let (friction, restitution) = surface_of(drawing, &wall.surface);
            let (from, to, form) = wall_course(wall)?;
            Some(Wall { name: wall.name.clone(), from, to, friction, restitution, form })
        })
        .collect();
    let Some(channel) = &drawing.channel else { return walls };
    let (friction, restitution) = surface_of(drawing, &channel.surface);
    let width = channel.width.value;
    let heights = || placed.iter().flat_map(|plate| heights_between_walls(plate, width));
    let top = heights().fold(f64::NEG_INFINITY, f64::max) + WALL_REACH * part;
    let bottom = heights().fold(f64::INFINITY, f64::min) - WALL_REACH * part;
    for (name, x) in [("left wall", 0.0), ("right wall", width)] {
        let (from, to) = (Vec2::new(x, top), Vec2::new(x, bottom));
        walls.push(Wall { name: name.into(), from, to, friction, restitution, form: Form::default() });
    }
    walls
}

/// Heights of a plate's ends; those of an endless one where it meets the walls.
fn heights_between_walls(plate: &Placed, width: f64) -> [f64; 2] {
    let run = plate.edge - plate.uphill;
    if !plate.unbounded || run.x == 0.0 {
        return [plate.uphill.y, plate.edge.y];
    }
    [0.0, width].map(|x| plate.uphill.y + (x - plate.uphill.x) * run.y / run.x)
}

fn face_problems(drawing: &Drawing, drawn: &[PlateDrawing], part: &Part) -> Vec<Problem> {
    let faces = part.body.shape.rests().len();
    let mut problems = vec![];
    problems.extend(drawing.start.faces.problems(faces, &drawing.start));
    for plate in drawn {
        let wrong = match plate.want {
            Some(Want::Same | Want::Turned | Want::Face(_)) if part.kind == PartKind::Disc => {
                "a disc has no face that could be wanted".to_owned()
            }
            Some(Want::Same | Want::Turned) if part.kind == PartKind::Polygon => {
                format!(
                    "only a rod or a box lands same or turned: of this part write a face, 0 to {}",
                    faces - 1
                )
            }
            Some(Want::Face(face)) if face >= faces => {
                format!("{face} is no face of this part: its faces are 0 to {}", faces - 1)
            }
            _ => continue,
        };
        let path = format!("plate.{}.want", plate.name);
        problems.push(Problem::new(ProblemKind::OutOfRange, path, wrong, Some(plate.span.clone())));
    }
    problems
}

/// What may stand where the part starts: its straight pieces, its path, its place in the file.
struct Obstacle {
    pieces: Vec<(Vec2, Vec2)>,
    path: String,
    span: Option<Range<usize>>,
}

fn plate_obstacle(drawn: &PlateDrawing, placed: &Placed) -> Obstacle {
    let path = format!("plate.{}", drawn.name);
    Obstacle { pieces: placed.plate().pieces(), path, span: Some(drawn.span.clone()) }
}

fn wall_obstacle(wall: &WallDrawing) -> Obstacle {
    let path = format!("wall.{}", wall.name);
    let course = wall_course(wall);
    let pieces = course.map(|(from, to, form)| form.pieces(from, to)).unwrap_or_default();
    Obstacle { pieces, path, span: Some(wall.span.clone()) }
}

/// Everything but the first plate.
fn obstacles(
    drawing: &Drawing,
    drawn: &[PlateDrawing],
    placed: &[Option<Placed>],
    part: f64,
) -> Vec<Obstacle> {
    let plates = drawn.iter().zip(placed).skip(1);
    let mut all: Vec<Obstacle> =
        plates.filter_map(|(drawn, placed)| Some(plate_obstacle(drawn, placed.as_ref()?))).collect();
    all.extend(drawing.walls.iter().map(wall_obstacle));
    let known: Vec<Placed> = placed.iter().flatten().cloned().collect();
    let channel = drawing.channel.as_ref().and_then(|channel| channel.width.span.clone());
    all.extend(walls(drawing, &known, part).into_iter().skip(drawing.walls.len()).map(|wall| Obstacle {
        pieces: vec![(wall.from, wall.to)],
        path: format!("wall.{}", wall.name),
        span: channel.clone(),
    }));
    all
}

fn start_problems(start: &StartDrawing, part: &Part, first: &Placed, others: &[Obstacle]) -> Vec<Problem> {
    let mut problems = vec![];
    let plate = first.plate();
    let length = plate.length();
    if start.to_edge.value > length {
        let [at, long] = [start.to_edge.value, length].map(|length| Dimension::Length.show(length));
        let message = format!("{at} is beyond the uphill end of the first plate, which is {long} long");
        let span = start.to_edge.span.clone();
        problems.push(Problem::new(ProblemKind::Geometry, "start.to_edge", message, span));
    }
    if part.kind != PartKind::Disc && plate.is_bent_at(start.to_edge.value) {
        let message = "the first plate is bent there: only a disc starts on an arc";
        let span = start.to_edge.span.clone();
        problems.push(Problem::new(ProblemKind::Geometry, "start.to_edge", message, span));
    }
    let faces = part.body.shape.rests().len().max(1);
    // Whichever face it starts on.
    let shares =
        start.faces.shares(|| resting(&part.body.shape)).into_iter().filter(|(face, _)| *face < faces);
    let poses: Vec<Pose> = shares.map(|(face, _)| pose_at_start(start, face, part, first)).collect();
    for other in others {
        let crossed =
            |(from, to): &(Vec2, Vec2)| poses.iter().any(|pose| crosses(&part.body.shape, *pose, *from, *to));
        let message = if other.pieces.iter().any(|(from, to)| from == to) {
            "has no length"
        } else if other.pieces.iter().any(crossed) {
            "crosses the part where it starts"
        } else {
            continue;
        };
        problems.push(Problem::new(ProblemKind::Geometry, &other.path, message, other.span.clone()));
    }
    problems
}

impl Placed {
    /// A plate in this place, without friction and restitution.
    fn plate(&self) -> Plate {
        Plate {
            name: String::new(),
            uphill: self.uphill,
            edge: self.edge,
            friction: 0.0,
            restitution: 0.0,
            unbounded: self.unbounded,
            form: form(self.course.clone(), None),
        }
    }
}

/// Where the part starts, whatever else stands there.
fn pose_at_start(start: &StartDrawing, face: usize, part: &Part, first: &Placed) -> Pose {
    let start = Start { to_edge: start.to_edge.value, speed: start.speed.value, face };
    let alone = Feeder {
        gravity: 1.0,
        stop: Stop::default(),
        law: Law::default(),
        part: part.clone(),
        start,
        plates: vec![first.plate()],
        walls: vec![],
    };
    alone.start_state().pose
}
