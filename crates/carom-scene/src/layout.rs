//! From drawn plates to segments.
//!
//! A plate whose drawing gives no length is as long as needed. It reaches 10 L uphill and 40 L downhill of the point of its line nearest
//! to the previous plate's free edge, where L is the distance to that edge plus the part's run on the first plate plus the part's size.
//! Its uphill end stops below the previous free edge where it slopes the same way, and one L above it where it slopes back.

use crate::chain::corners_of;
use crate::drawing::{ChannelDrawing, Level, Place, PlateDrawing, Reach, Side, ZigzagDrawing};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::unit::Dimension;
use carom_motion::planar::ChainPoint;
use carom_num::{
    Vec2,
    elementary::{atan2, sin_cos},
};
use std::ops::Range;

/// Uphill and downhill reach of a plate as long as needed, in lengths L.
const REACH: [f64; 2] = [10.0, 40.0];

/// A plate in its place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Placed {
    pub(crate) uphill: Vec2,
    pub(crate) edge: Vec2,
    /// Its course, where it is bent.
    pub(crate) course: Vec<ChainPoint>,
    pub(crate) downhill: Side,
    /// No length is drawn.
    pub(crate) unbounded: bool,
    /// Free edge is where the drawing says.
    pub(crate) edge_known: bool,
}

/// What the places of plates are measured with.
pub(crate) struct Yard<'a> {
    pub(crate) channel: Option<&'a ChannelDrawing>,
    /// The part's run on the first plate plus its size [m].
    pub(crate) part: f64,
}

/// The plates that a zig-zag stands for.
pub(crate) fn zigzag_plates(zigzag: &ZigzagDrawing) -> Vec<PlateDrawing> {
    let count = zigzag.plates.value as usize;
    let mut wall = zigzag.wall;
    let mut plates = vec![];
    for i in 0..count {
        let level = match i {
            0 => Level::Height(zigzag.height.clone()),
            _ => Level::Drop(zigzag.drop.clone()),
        };
        let (slope, reach) = (zigzag.slope.clone(), Reach::Gap(zigzag.gap.clone()));
        plates.push(PlateDrawing {
            name: i.to_string(),
            place: Place::Hinged { wall, level, slope, reach },
            edge_radius: None,
            width: None,
            roll: None,
            side_walls: None,
            v_angle: None,
            surface: zigzag.surface.clone(),
            want: if i + 1 == count { zigzag.want } else { None },
            span: zigzag.span.clone(),
        });
        wall = wall.other();
    }
    plates
}

/// Unit direction downhill.
pub(crate) fn downhill_direction(slope: f64, side: Side) -> Vec2 {
    let (sin, cos) = sin_cos(slope);
    Vec2::new(side.sign() * cos, -sin)
}

impl Yard<'_> {
    /// Places every plate and says what is wrong with each; `None` in place of one whose place is not known.
    pub(crate) fn place_all(&self, plates: &[Option<&PlateDrawing>]) -> (Vec<Option<Placed>>, Vec<Problem>) {
        let mut placed: Vec<Option<Placed>> = vec![];
        let mut problems = vec![];
        for plate in plates {
            let before = placed.last().map(Option::as_ref);
            let found = match (*plate, before) {
                (None, _) => None,
                // Measured from a plate whose own place is not known.
                (Some(plate), Some(None)) if plate.place.is_relative() => None,
                (Some(plate), before) => match self.place(plate, before.flatten()) {
                    Ok(found) => {
                        let none = no_length(&found, &format!("plate.{}", plate.name), &plate.span);
                        let good = none.is_none().then_some(found);
                        problems.extend(none);
                        good
                    }
                    Err(problem) => {
                        problems.push(problem);
                        None
                    }
                },
            };
            placed.push(found);
        }
        (placed, problems)
    }

    fn place(&self, plate: &PlateDrawing, before: Option<&Placed>) -> Result<Placed, Problem> {
        let name = &plate.name;
        match &plate.place {
            Place::Origin { slope, length, downhill } => {
                // Without a length the plate goes on uphill without end: this point only gives its direction.
                let reach = length.as_ref().map_or(4.0 * self.part, |length| length.value);
                let uphill = -downhill_direction(slope.value, *downhill) * reach;
                let (edge, unbounded) = (Vec2::ZERO, length.is_none());
                Ok(Placed { uphill, edge, course: vec![], downhill: *downhill, unbounded, edge_known: true })
            }
            Place::Hinged { wall, level, slope, reach } => {
                self.hinged(plate, *wall, level, before).and_then(|hinge| {
                    let length = self.length(name, slope, reach)?;
                    let downhill = wall.other();
                    let edge = hinge + downhill_direction(slope.value, downhill) * length;
                    Ok(Placed {
                        uphill: hinge,
                        edge,
                        course: vec![],
                        downhill,
                        unbounded: false,
                        edge_known: true,
                    })
                })
            }
            Place::Line { along, normal, downhill } => {
                self.on_line(plate, [along, normal], *downhill, known_edge(plate, before)?)
            }
            Place::Through { slope, below, downhill } => {
                let before = known_edge(plate, before)?;
                let downhill = downhill.unwrap_or(before.downhill.other());
                let point = before.edge + Vec2::new(below[0].value, below[1].value);
                self.endless(plate, point, downhill_direction(slope.value, downhill), before)
            }
            Place::Edge { edge, slope, length, downhill } => {
                let downhill =
                    downhill.unwrap_or(before.map_or(Side::Right, |before| before.downhill.other()));
                let edge = Vec2::new(edge[0].value, edge[1].value);
                let uphill = edge - downhill_direction(slope.value, downhill) * length.value;
                Ok(Placed { uphill, edge, course: vec![], downhill, unbounded: false, edge_known: true })
            }
            Place::Ends { from, to } => ends(plate, from, to),
            // A chain that is written with problems is not read; one of them is enough where a quantity was varied.
            Place::Chain { chain } => match chain.points(false) {
                Ok(course) => bent(plate, &course),
                Err(mut problems) => Err(problems.swap_remove(0)),
            },
        }
    }

    fn hinged(
        &self,
        plate: &PlateDrawing,
        wall: Side,
        level: &Level,
        before: Option<&Placed>,
    ) -> Result<Vec2, Problem> {
        let path = |key: &str| format!("plate.{}.{key}", plate.name);
        let x = match (wall, self.channel) {
            (Side::Left, _) => 0.0,
            (Side::Right, Some(channel)) => channel.width.value,
            (Side::Right, None) => {
                let message = "the right wall is at the channel's width, but there is no [channel]";
                let span = Some(plate.span.clone());
                let problem = Problem::new(ProblemKind::Geometry, path("wall"), message, span);
                return Err(problem.with_help("add [channel] with width = \"180 mm\""));
            }
        };
        match (level, before) {
            (Level::Height(height), _) => Ok(Vec2::new(x, height.value)),
            // An endless plate ends uphill where it is drawn, and that is no hinge of anybody's.
            (Level::Drop(drop), Some(before)) if before.unbounded => {
                let message = "the plate before it is as long as needed and has no hinge: give the height";
                Err(Problem::new(ProblemKind::Geometry, path("drop"), message, drop.span.clone()))
            }
            (Level::Drop(drop), Some(before)) => Ok(Vec2::new(x, before.uphill.y - drop.value)),
            (Level::Drop(drop), None) => {
                let message = "the first plate has no hinge before it: give its height";
                Err(Problem::new(ProblemKind::Geometry, path("drop"), message, drop.span.clone()))
            }
        }
    }

    fn length(&self, name: &str, slope: &Quantity, reach: &Reach) -> Result<f64, Problem> {
        let gap = match reach {
            Reach::Length(length) => return Ok(length.value),
            Reach::Gap(gap) => gap,
        };
        let problem = |kind, message: String| {
            Err(Problem::new(kind, format!("plate.{name}.gap"), message, gap.span.clone()))
        };
        let Some(channel) = self.channel else {
            let message = "a gap is measured to the other wall, but there is no [channel]";
            return problem(ProblemKind::Geometry, message.into());
        };
        let width = channel.width.value;
        if gap.value >= width {
            let [gap, width] = [gap.value, width].map(|length| Dimension::Length.show(length));
            return problem(
                ProblemKind::Geometry,
                format!("{gap} leaves no plate: the channel is {width} wide"),
            );
        }
        Ok((width - gap.value) / sin_cos(slope.value).1)
    }

    /// The paper's x/d + y/b = 1: x along the previous plate from its free edge, y down through it.
    fn on_line(
        &self,
        plate: &PlateDrawing,
        [along, normal]: [&Quantity; 2],
        downhill: Option<Side>,
        before: &Placed,
    ) -> Result<Placed, Problem> {
        // The axes of the plate before need its direction; one of no length has a problem of its own as well.
        let Some(x) = (before.edge - before.uphill).unit() else {
            let message = "the plate before it has no length to measure along";
            let path = format!("plate.{}.line", plate.name);
            return Err(Problem::new(ProblemKind::Geometry, path, message, along.span.clone()));
        };
        let y = match before.downhill {
            Side::Right => x.turned_right(),
            Side::Left => x.turned_left(),
        };
        let (on_x, on_y) = (before.edge + x * along.value, before.edge + y * normal.value);
        let direction = (on_y - on_x) / (on_y - on_x).norm();
        let direction = if direction.y > 0.0 { -direction } else { direction };
        let found = if direction.x < 0.0 { Side::Left } else { Side::Right };
        if let Some(said) = downhill.filter(|said| *said != found) {
            let slope = Dimension::Angle.show(atan2(-direction.y, direction.x.abs()));
            let message = format!(
                "the line goes downhill to the {}, {slope} below the horizontal, not to the {}",
                found.word(),
                said.word()
            );
            let path = format!("plate.{}.downhill", plate.name);
            return Err(Problem::new(ProblemKind::Conflict, path, message, along.span.clone()));
        }
        self.endless(plate, on_y, direction, before)
    }

    /// A plate as long as needed on the line through `point`.
    fn endless(
        &self,
        plate: &PlateDrawing,
        point: Vec2,
        direction: Vec2,
        before: &Placed,
    ) -> Result<Placed, Problem> {
        let problem = |message: String| {
            let path = format!("plate.{}", plate.name);
            Err(Problem::new(ProblemKind::Geometry, path, message, Some(plate.span.clone())))
        };
        let downhill = if direction.x < 0.0 { Side::Left } else { Side::Right };
        // Height of the line where it passes below the edge.
        let level = point.y + (before.edge.x - point.x) * direction.y / direction.x;
        let below = before.edge.y - level;
        if below <= 0.0 {
            let above = Dimension::Length.show(-below);
            return problem(format!(
                "passes {above} above the previous plate's free edge: a part cannot fall on it"
            ));
        }
        let foot = point + direction * (before.edge - point).dot(direction);
        let unit = (before.edge - foot).norm() + self.part;
        let ceiling = if downhill == before.downhill { 0.0 } else { unit };
        // direction.y is 0 for a level plate: its uphill end is then at no height's mercy.
        let to_ceiling = (foot.y - before.edge.y - ceiling) / direction.y;
        let up = if to_ceiling > 0.0 { to_ceiling.min(REACH[0] * unit) } else { REACH[0] * unit };
        let (uphill, edge) = (foot - direction * up, foot + direction * (REACH[1] * unit));
        Ok(Placed { uphill, edge, course: vec![], downhill, unbounded: true, edge_known: false })
    }
}

/// The plate before, where its free edge is known.
fn known_edge<'p>(plate: &PlateDrawing, before: Option<&'p Placed>) -> Result<&'p Placed, Problem> {
    before.filter(|before| before.edge_known).ok_or_else(|| {
        let message = "is measured from the free edge of the plate before it, which is as long as needed";
        let path = format!("plate.{}", plate.name);
        let problem = Problem::new(ProblemKind::Geometry, path, message, Some(plate.span.clone()));
        problem.with_help("place the plate before it with a length: wall, edge or from + to")
    })
}

fn ends(plate: &PlateDrawing, from: &[Quantity; 2], to: &[Quantity; 2]) -> Result<Placed, Problem> {
    let (uphill, edge) = (Vec2::new(from[0].value, from[1].value), Vec2::new(to[0].value, to[1].value));
    let run = edge - uphill;
    let path = format!("plate.{}", plate.name);
    let span = Some(plate.span.clone());
    if run.y > 0.0 {
        let message = "goes uphill: from is the uphill end and to the free edge, which is lower";
        return Err(Problem::new(ProblemKind::Geometry, path, message, span));
    }
    if run.x == 0.0 && run.y < 0.0 {
        let message = "is vertical: a plate slopes less than 90 deg";
        let problem = Problem::new(ProblemKind::Geometry, path, message, span);
        return Err(problem.with_help("a vertical obstacle is a [[wall]]"));
    }
    let downhill = if run.x < 0.0 { Side::Left } else { Side::Right };
    Ok(Placed { uphill, edge, course: vec![], downhill, unbounded: false, edge_known: true })
}

fn bent(plate: &PlateDrawing, course: &[ChainPoint]) -> Result<Placed, Problem> {
    let [first, .., last] = course else {
        let path = format!("plate.{}.chain", plate.name);
        return Err(Problem::new(ProblemKind::Geometry, path, "has no length", Some(plate.span.clone())));
    };
    if last.at.y > first.at.y && corners_of(course).iter().all(|point| point.y >= first.at.y) {
        let path = format!("plate.{}.chain", plate.name);
        let message =
            "goes uphill: its first point is the uphill end and its last one the free edge, which is lower";
        return Err(Problem::new(ProblemKind::Geometry, path, message, Some(plate.span.clone())));
    }
    let downhill = if last.at.x < first.at.x { Side::Left } else { Side::Right };
    let (uphill, edge, course) = (first.at, last.at, course.to_vec());
    Ok(Placed { uphill, edge, course, downhill, unbounded: false, edge_known: true })
}

fn no_length(placed: &Placed, path: &str, span: &Range<usize>) -> Option<Problem> {
    let length = (placed.edge - placed.uphill).norm();
    let problem = || Problem::new(ProblemKind::Geometry, path, "has no length", Some(span.clone()));
    (length == 0.0 || !length.is_finite()).then(problem)
}
