//! `chain` and `points`: chains of points with arcs between them.

use crate::drawing::Side;
use crate::grammar::{Mixed, Section};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::tolerance::{ARC_RADII, STRAIGHT_ARC};
use crate::unit::Dimension;
use carom_motion::planar::ChainPoint;
use carom_num::Vec2;
use carom_num::elementary::{atan2, tan};
use carom_num::segment::properly_cross;
use std::f64::consts::PI;
use std::ops::Range;

/// Fewest points of a chain.
const LEAST_POINTS: usize = 2;
/// Chords of an arc that are asked whether they cross others.
const CHORDS: u32 = 16;

/// How an arc between two points is drawn.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ArcDrawing {
    Through([Quantity; 2]),
    About { centre: [Quantity; 2], turn: Side },
    OfRadius { radius: Quantity, turn: Side },
}

/// A point of a chain, and the arc that leads on from it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stop {
    pub(crate) at: [Quantity; 2],
    pub(crate) arc: Option<(ArcDrawing, Range<usize>)>,
    /// Its number in the list.
    pub(crate) number: usize,
}

/// A chain as it is written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ChainDrawing {
    pub(crate) stops: Vec<Stop>,
    /// Rounds the corners between straight stretches.
    pub(crate) bend_radius: Option<Quantity>,
    /// `plate.lower.chain`
    pub(crate) path: String,
    pub(crate) span: Range<usize>,
}

/// Reads the chain of a key. A closed one may end with an arc, which leads back to its first point.
pub(crate) fn read_chain(section: &Section<'_>, key: &str, closed: bool) -> Option<ChainDrawing> {
    let (path, span) = (section.path_of(key), section.key_span(key));
    let mut stops: Vec<Stop> = vec![];
    let wrong = |path: &str, span: &Range<usize>, message: &str| {
        section.push(Problem::new(ProblemKind::Geometry, path, message, Some(span.clone())));
    };
    let mut good = true;
    let items = section.mixed::<2>(key)?;
    let count = items.len();
    for (number, item) in items.into_iter().enumerate() {
        let bend = match item {
            Mixed::Vector(at) => {
                stops.push(Stop { at, arc: None, number });
                continue;
            }
            Mixed::Table(bend) => bend,
        };
        let arc = read_arc(&bend.section("arc")?)?;
        match stops.last_mut() {
            Some(last) if last.arc.is_none() && (closed || number + 1 < count) => {
                last.arc = Some((arc, bend.span()));
            }
            _ => {
                good = false;
                wrong(&format!("{path}.{number}"), &bend.span(), "an arc stands between two points");
            }
        }
    }
    if stops.len() < LEAST_POINTS {
        // A list that is shorter is told by the grammar.
        if count >= LEAST_POINTS {
            wrong(&path, &span, "a chain has at least two points");
        }
        return None;
    }
    good.then(|| ChainDrawing { stops, bend_radius: None, path: path.clone(), span: span.clone() })
}

fn read_arc(section: &Section<'_>) -> Option<ArcDrawing> {
    if section.has("through") {
        return Some(ArcDrawing::Through(section.vector("through")?));
    }
    let turn = section.word("turn")?;
    if section.has("centre") {
        return Some(ArcDrawing::About { centre: section.vector("centre")?, turn });
    }
    Some(ArcDrawing::OfRadius { radius: section.quantity("radius")?, turn })
}

fn point([x, y]: &[Quantity; 2]) -> Vec2 {
    Vec2::new(x.value, y.value)
}

/// The angle from one direction to another, to the left [rad].
fn turn_from(a: Vec2, b: Vec2) -> f64 {
    atan2(a.cross(b), a.dot(b))
}

impl ArcDrawing {
    /// The angle by which it turns from one point to another, to the left positive; or what is wrong with it.
    fn sweep(&self, from: Vec2, to: Vec2) -> Result<f64, String> {
        match self {
            Self::Through(middle) => {
                let middle = point(middle);
                // An angle at the rim is half of that at the centre.
                let sweep = 2.0 * turn_from(middle - from, to - middle);
                let straight = sweep.abs() < STRAIGHT_ARC || sweep.abs() > 2.0 * PI - STRAIGHT_ARC;
                if straight {
                    Err("its point lies on the line through its ends: this is no arc".into())
                } else {
                    Ok(sweep)
                }
            }
            Self::About { centre, turn } => {
                let (a, b) = (from - point(centre), to - point(centre));
                let [near, far] = [a.norm(), b.norm()];
                if (near - far).abs() > ARC_RADII * near.max(far) {
                    let [near, far] = [near, far].map(|radius| Dimension::Length.show(radius));
                    return Err(format!(
                        "its centre is {near} from its first end and {far} from its other one"
                    ));
                }
                let left = turn_from(a, b);
                let left = if left <= 0.0 { left + 2.0 * PI } else { left };
                Ok(if *turn == Side::Left { left } else { left - 2.0 * PI })
            }
            Self::OfRadius { radius, turn } => {
                let half = 0.5 * (to - from).norm() / radius.value;
                if half > 1.0 {
                    let least = Dimension::Length.show(0.5 * (to - from).norm());
                    return Err(format!(
                        "its radius must be at least half of the distance of its ends, {least}"
                    ));
                }
                Ok(-turn.sign() * 2.0 * atan2(half, (1.0 - half * half).sqrt()))
            }
        }
    }
}

impl ChainDrawing {
    fn problem(&self, number: usize, message: &str, span: Option<Range<usize>>) -> Problem {
        let span = span.or_else(|| Some(self.span.clone()));
        Problem::new(ProblemKind::Geometry, format!("{}.{number}", self.path), message, span)
    }

    /// The points of the chain, its corners rounded; closed from the last to the first where it is the outline of a part.
    pub(crate) fn points(&self, closed: bool) -> Result<Vec<ChainPoint>, Vec<Problem>> {
        let k = self.stops.len();
        let mut problems = vec![];
        let mut chain = vec![];
        for (i, stop) in self.stops.iter().enumerate() {
            let (at, next) = (point(&stop.at), point(&self.stops[(i + 1) % k].at));
            let last = i + 1 == k && !closed;
            if !last && at == next {
                let next = &self.stops[(i + 1) % k];
                problems.push(self.problem(next.number, "is at the same place as the point before it", None));
                continue;
            }
            let sweep = stop.arc.as_ref().filter(|_| !last).map(|(arc, span)| {
                arc.sweep(at, next).map_err(|why| self.problem(stop.number + 1, &why, Some(span.clone())))
            });
            match sweep.transpose() {
                Ok(sweep) => chain.push(ChainPoint { at, sweep: sweep.unwrap_or(0.0) }),
                Err(problem) => problems.push(problem),
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        match self.rounding() {
            Some(radius) => rounded(&chain, radius.value, closed).ok_or_else(|| vec![self.too_round(radius)]),
            None => Ok(chain),
        }
    }

    /// The radius with which its corners are rounded; none where they stay sharp.
    pub(crate) fn rounding(&self) -> Option<&Quantity> {
        self.bend_radius.as_ref().filter(|radius| radius.value > 0.0)
    }

    fn too_round(&self, radius: &Quantity) -> Problem {
        let shown = Dimension::Length.show(radius.value);
        let path = self.path.trim_end_matches("chain").to_owned() + "bend_radius";
        let message = format!("{shown} leaves nothing of a stretch between two corners");
        Problem::new(ProblemKind::Geometry, path, message, radius.span.clone())
    }
}

/// A chain with the corners between straight stretches rounded by a radius, those that turn right as well; `None` where that leaves nothing of a
/// stretch.
pub(crate) fn rounded(chain: &[ChainPoint], radius: f64, closed: bool) -> Option<Vec<ChainPoint>> {
    let k = chain.len();
    let run = |i: usize| chain[(i + 1) % k].at - chain[i % k].at;
    let is_straight = |i: usize| chain[i % k].sweep == 0.0 && (closed || i % k + 1 < k);
    // From a corner to where its arc begins, and by how much the chain turns there; nothing beside an arc and at an open end.
    let turn = |i: usize| {
        let i = i % k;
        if !(is_straight(i) && is_straight(i + k - 1)) || !closed && (i == 0 || i + 1 == k) {
            return (0.0, 0.0);
        }
        let angle = turn_from(run(i + k - 1), run(i));
        (radius * tan(0.5 * angle.abs()), angle)
    };
    let mut out = vec![];
    for (i, corner) in chain.iter().enumerate() {
        let ((cut, angle), (next, _), side) = (turn(i), turn(i + 1), run(i));
        if is_straight(i) && cut + next >= side.norm() {
            return None;
        }
        if angle == 0.0 {
            out.push(*corner);
            continue;
        }
        let before = run(i + k - 1);
        out.push(ChainPoint { at: corner.at - before * (cut / before.norm()), sweep: angle });
        out.push(ChainPoint::straight(corner.at + side * (cut / side.norm())));
    }
    Some(out)
}

/// Corners of a closed chain with a few chords in place of each arc: enough to find edges that cross.
pub(crate) fn corners_of(chain: &[ChainPoint]) -> Vec<Vec2> {
    let ends = chain.iter().zip(chain.iter().cycle().skip(1));
    let piece = |(from, to): (&ChainPoint, &ChainPoint)| {
        let count = if from.sweep == 0.0 { 1 } else { CHORDS };
        (0..count).map(|i| from.along(to.at, f64::from(i) / f64::from(count))).collect::<Vec<_>>()
    };
    ends.flat_map(piece).collect()
}

/// A closed chain the other way round, from the same point on.
pub(crate) fn turned_round(chain: &[ChainPoint]) -> Vec<ChainPoint> {
    let k = chain.len();
    (0..k)
        .map(|i| ChainPoint { at: chain[(k - i) % k].at, sweep: -chain[(2 * k - i - 1) % k].sweep })
        .collect()
}

/// True where two sides of a closed chain that are no neighbours cross.
pub(crate) fn crosses_itself(corners: &[Vec2]) -> bool {
    any_cross(corners, corners.len())
}

/// As [`crosses_itself`], of an open chain, its arcs as a few chords.
pub(crate) fn course_crosses_itself(course: &[ChainPoint]) -> bool {
    let corners = corners_of(course);
    // What leads back from the last point to the first is no side.
    let straight_back = course.last().is_some_and(|last| last.sweep == 0.0);
    any_cross(&corners, corners.len() - usize::from(straight_back))
}

/// True where two of the first sides that are no neighbours cross.
fn any_cross(corners: &[Vec2], sides: usize) -> bool {
    let side = |i: usize| (corners[i], corners[(i + 1) % corners.len()]);
    let cross = |i: usize, j: usize| {
        let ((a, b), (c, d)) = (side(i), side(j));
        a != b && c != d && properly_cross((a, b), (c, d), 0.0)
    };
    (0..sides).any(|i| (i + 2..sides).any(|j| cross(i, j)))
}
