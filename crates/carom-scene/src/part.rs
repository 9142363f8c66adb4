//! From a drawn part to a body: rounding, mass centre, mass, inertia.

use crate::approximation::Approximation;
use crate::chain::{ChainDrawing, corners_of, crosses_itself, rounded, turned_round};
use crate::drawing::{MassCentre, MassSpec, Outline, PartDrawing};
use crate::outline::Solid;
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::unit::Dimension;
use carom_feeder::{Part, PartKind};
use carom_motion::planar::{Body, ChainPoint, MassProperties, Rest, Shape, ShapeProblem};
use carom_num::Vec2;
use std::ops::Range;

/// A part, and what was done to its drawing.
pub(crate) struct Built {
    pub(crate) part: Part,
    /// The point of the drawing that is the body's own origin, its mass centre [m].
    pub(crate) origin: Vec2,
    pub(crate) notes: Vec<String>,
    pub(crate) approximations: Vec<Approximation>,
}

/// The corners as drawn, counter-clockwise, and whether their order was turned round.
struct Corners {
    points: Vec<Vec2>,
    spans: Vec<Option<Range<usize>>>,
    reversed: bool,
}

/// Builds the part.
///
/// `corner_radius` keeps the drawn outline's straight sides where they are, and rounds the corners between them.
pub(crate) fn build_part(drawing: &PartDrawing) -> Result<Built, Vec<Problem>> {
    let radius = drawing.corner_radius.as_ref().map_or(0.0, |radius| radius.value);
    let (mut own, mut volume, mut origin, mut approximations) = (None, None, Vec2::ZERO, vec![]);
    let mut take = |solid: Solid| {
        (own, volume, origin) = (Some(solid.properties), solid.volume, solid.origin);
        approximations = solid.approximations;
        (solid.kind, solid.shape, solid.notes)
    };
    let (kind, shape, notes) = match &drawing.outline {
        Outline::Rod { length } => {
            let half = 0.5 * length.value - radius;
            (PartKind::Rod, rod(half, radius, drawing)?, vec![])
        }
        Outline::Box { length, height } => {
            (PartKind::Box, rectangle(length, height, radius, drawing)?, vec![])
        }
        Outline::Polygon { vertices } => {
            let corners = corners(vertices);
            let notes = if corners.reversed {
                vec![
                    "part.vertices run clockwise: they are taken in the reverse order, vertex 0 first".into(),
                ]
            } else {
                vec![]
            };
            let (shape, centroid) = polygon(&corners, radius, drawing)?;
            origin = centroid;
            (PartKind::Polygon, shape, notes)
        }
        Outline::Chain { chain } => {
            let (shape, centroid, notes) = chained(chain)?;
            origin = centroid;
            (PartKind::Polygon, shape, notes)
        }
        Outline::Disc { radius } => {
            let shape = Shape::new(vec![Vec2::ZERO], radius.value);
            (PartKind::Disc, shape.map_err(|found| shape_problems(&found, drawing, None))?, vec![])
        }
        Outline::File { drawn, scale } => {
            let solid = drawn.solid(scale.value).map_err(|found| scale_problem(&found, scale))?;
            take(solid)
        }
        Outline::Library(part) => take(part.solid(&drawing.span)?),
        // It is followed in space.
        Outline::Solid(_) => return Err(vec![]),
    };
    let mut properties = own.unwrap_or_else(|| MassProperties::of(&shape));
    let mut shape = shape;
    if let Some(given) = &drawing.mass_centre {
        let at = [given.at[0].value, given.at[1].value];
        let at = match &drawing.outline {
            Outline::File { drawn, .. } => drawn.upright(at),
            _ => Vec2::new(at[0], at[1]),
        };
        let shift = at - origin;
        shape = balanced(&shape, kind, shift, given)?;
        // What the uniform outline would have about the given point: what is proposed where no inertia is given.
        properties.gyration_squared += shift.dot(shift);
        origin += shift;
    }
    let (mass, inertia) = mass(&shape, &properties, volume, drawing)?;
    Ok(Built { part: Part { kind, body: Body { shape, mass, inertia } }, origin, notes, approximations })
}

/// The shape about a mass centre that lies `shift` from where it would be if the part were uniform.
fn balanced(shape: &Shape, kind: PartKind, shift: Vec2, given: &MassCentre) -> Result<Shape, Vec<Problem>> {
    let fail = |message: &str| {
        let span = Some(given.span.clone());
        Err(vec![Problem::new(ProblemKind::Geometry, "part.mass_centre", message, span)])
    };
    if kind == PartKind::Disc {
        return fail("a disc rolls about its own middle: no other mass centre can be given");
    }
    let rests = shape.rests();
    let within = |rest: &Rest| {
        let depth = rest.depth - shift.dot(rest.normal);
        let along = (shift - rest.from).dot(rest.to - rest.from);
        // A thin rod has no inside: its mass centre lies on it, between its ends.
        if rests.len() > 2 { depth > 0.0 } else { depth >= 0.0 && along > 0.0 }
    };
    if !rests.iter().all(within) {
        return fail("lies outside the part: a mass centre is within its convex hull");
    }
    Ok(shape.shifted(-shift))
}

fn rod(half: f64, radius: f64, drawing: &PartDrawing) -> Result<Shape, Vec<Problem>> {
    if half <= 0.0 {
        return Err(vec![too_round(drawing, "half the rod's length")]);
    }
    let shape = Shape::new(vec![Vec2::new(-half, 0.0), Vec2::new(half, 0.0)], radius);
    shape.map_err(|found| shape_problems(&found, drawing, None))
}

fn rectangle(
    length: &Quantity,
    height: &Quantity,
    radius: f64,
    drawing: &PartDrawing,
) -> Result<Shape, Vec<Problem>> {
    let (a, b) = (0.5 * length.value - radius, 0.5 * height.value - radius);
    if a <= 0.0 || b <= 0.0 {
        return Err(vec![too_round(drawing, "half the box's shorter side")]);
    }
    let corners = vec![Vec2::new(-a, -b), Vec2::new(a, -b), Vec2::new(a, b), Vec2::new(-a, b)];
    Shape::new(corners, radius).map_err(|found| shape_problems(&found, drawing, None))
}

fn corners(vertices: &[[Quantity; 2]]) -> Corners {
    let mut points: Vec<Vec2> = vertices.iter().map(|[x, y]| Vec2::new(x.value, y.value)).collect();
    let mut spans: Vec<_> = vertices.iter().map(|[x, y]| pair_span(x, y)).collect();
    let k = points.len();
    let doubled: f64 = (0..k).map(|i| (points[i] - points[0]).cross(points[(i + 1) % k] - points[0])).sum();
    let reversed = doubled < 0.0;
    if reversed {
        points[1..].reverse();
        spans[1..].reverse();
    }
    Corners { points, spans, reversed }
}

fn pair_span(x: &Quantity, y: &Quantity) -> Option<Range<usize>> {
    match (&x.span, &y.span) {
        (Some(x), Some(y)) => Some(x.start..y.end),
        _ => None,
    }
}

/// The polygon about its centroid, and where that lies as drawn.
fn polygon(corners: &Corners, radius: f64, drawing: &PartDrawing) -> Result<(Shape, Vec2), Vec<Problem>> {
    let problems = |found: Vec<ShapeProblem>| shape_problems(&found, drawing, Some(corners));
    if crosses_itself(&corners.points) {
        return Err(problems(vec![ShapeProblem::Crosses]));
    }
    let sharp: Vec<ChainPoint> = corners.points.iter().map(|p| ChainPoint::straight(*p)).collect();
    Shape::of_chain(&sharp).map_err(problems)?;
    let chain = if radius > 0.0 {
        rounded(&sharp, radius, true)
            .ok_or_else(|| vec![too_round(drawing, "what its shortest side allows")])?
    } else {
        sharp
    };
    // A rounded corner is two points of the chain.
    let of_corner = |i: usize| if radius > 0.0 { i / 2 } else { i };
    let problems = |found: Vec<ShapeProblem>| {
        problems(found.into_iter().map(|problem| problem.renumbered(of_corner)).collect())
    };
    about_centroid(&chain).map_err(problems)
}

/// The shape of a chain about its centroid, and where that lies as drawn.
fn about_centroid(chain: &[ChainPoint]) -> Result<(Shape, Vec2), Vec<ShapeProblem>> {
    let centroid = MassProperties::of(&Shape::of_chain(chain)?).centroid;
    let about: Vec<ChainPoint> = chain.iter().map(|p| ChainPoint { at: p.at - centroid, ..*p }).collect();
    Ok((Shape::of_chain(&about)?, centroid))
}

/// The outline of a chain about its centroid, where that lies as drawn, and what is to be said of it.
fn chained(chain: &ChainDrawing) -> Result<(Shape, Vec2, Vec<String>), Vec<Problem>> {
    let mut points = chain.points(true)?;
    let mut notes = vec![];
    let problems = |found: Vec<ShapeProblem>| {
        let message = |found: &ShapeProblem| {
            Problem::new(ProblemKind::Geometry, &chain.path, found.to_string(), Some(chain.span.clone()))
        };
        found.iter().map(message).collect::<Vec<_>>()
    };
    if crosses_itself(&corners_of(&points)) {
        return Err(problems(vec![ShapeProblem::Crosses]));
    }
    if Shape::of_chain(&points).is_err_and(|found| found.contains(&ShapeProblem::Clockwise)) {
        points = turned_round(&points);
        notes.push("part.points run clockwise: they are taken in the reverse order, point 0 first".into());
    }
    let (shape, centroid) = about_centroid(&points).map_err(problems)?;
    Ok((shape, centroid, notes))
}

fn too_round(drawing: &PartDrawing, limit: &str) -> Problem {
    let radius = drawing.corner_radius.as_ref();
    let shown = radius.map_or(String::new(), |radius| Dimension::Length.show(radius.value));
    let span = radius.and_then(|radius| radius.span.clone());
    let message = format!("{shown} must be less than {limit}");
    Problem::new(ProblemKind::Geometry, "part.corner_radius", message, span)
}

fn shape_problems(found: &[ShapeProblem], drawing: &PartDrawing, corners: Option<&Corners>) -> Vec<Problem> {
    let k = corners.map_or(0, |corners| corners.points.len());
    // Corners drawn clockwise were turned round: a problem names the corner as it is numbered in the file.
    let drawn = |i: usize| match corners {
        Some(corners) if corners.reversed => (k - i) % k,
        _ => i,
    };
    let place = |i: usize| corners.and_then(|corners| corners.spans[i].clone());
    let whole = || {
        let spans = corners.map(|corners| &corners.spans);
        let first = spans.and_then(|spans| spans.iter().flatten().map(|span| span.start).min());
        let last = spans.and_then(|spans| spans.iter().flatten().map(|span| span.end).max());
        first.zip(last).map_or_else(|| drawing.span.clone(), |(first, last)| first..last)
    };
    let problem =
        |path: String, message: &str, span| Problem::new(ProblemKind::Geometry, path, message, span);
    found
        .iter()
        .map(|found| match found {
            ShapeProblem::NotConvex(i) => problem(
                format!("part.vertices.{}", drawn(*i)),
                "the outline is not convex at this corner",
                place(*i),
            )
            .with_help("parts are convex: leave this corner out, or round it with corner_radius"),
            ShapeProblem::Coincide(_, j) => problem(
                format!("part.vertices.{}", drawn(*j)),
                "two neighbouring corners are at the same place",
                place(*j),
            ),
            ShapeProblem::Crosses | ShapeProblem::Clockwise => {
                problem("part.vertices".into(), &found.to_string(), Some(whole()))
            }
            ShapeProblem::Empty | ShapeProblem::PointWithoutRadius | ShapeProblem::NotANumber => {
                problem("part".into(), &found.to_string(), Some(whole()))
            }
        })
        .collect()
}

/// An outline of a good file has a good hull; what is wrong is the size that it is given.
fn scale_problem(found: &[ShapeProblem], scale: &Quantity) -> Vec<Problem> {
    let found = found.first().map_or(String::new(), |found| format!(": {found}"));
    let message = format!("{} makes no part of the outline{found}", Dimension::Number.show(scale.value));
    vec![Problem::new(ProblemKind::Geometry, "part.scale", message, scale.span.clone())]
}

/// Mass and inertia; the properties are those of the shape, or of what the outline stands for, the volume that of a body of revolution.
fn mass(
    shape: &Shape,
    properties: &MassProperties,
    volume: Option<f64>,
    drawing: &PartDrawing,
) -> Result<(f64, f64), Vec<Problem>> {
    let mass = match &drawing.mass {
        MassSpec::Mass(mass) => mass.value,
        MassSpec::Density { density, depth: None } => density.value * volume.unwrap_or(0.0),
        MassSpec::Density { density, .. } if properties.area == 0.0 => {
            let message = "a thin rod has no area that a density could fill";
            let problem = Problem::new(ProblemKind::Geometry, "part.density", message, density.span.clone());
            return Err(vec![problem.with_help("give its mass, or draw it as a box with a height")]);
        }
        MassSpec::Density { density, depth: Some(depth) } => density.value * depth.value * properties.area,
    };
    let Some(inertia) = &drawing.inertia else {
        return match &drawing.mass_centre {
            None => Ok((mass, mass * properties.gyration_squared)),
            Some(given) => Err(vec![inertia_missing(mass * properties.gyration_squared, given)]),
        };
    };
    // No part of the mass is farther from the centre than the farthest point of the shape.
    let most = mass * shape.size() * shape.size();
    if inertia.value > most {
        let shown = Dimension::Inertia.show(inertia.value);
        let message = format!(
            "{shown} is impossible for this shape: with all its mass at the farthest point it would be {}",
            Dimension::Inertia.show(most)
        );
        let problem = Problem::new(ProblemKind::Geometry, "part.inertia", message, inertia.span.clone());
        let uniform = Dimension::Inertia.show(mass * properties.gyration_squared);
        return Err(vec![problem.with_help(format!("left out, it is {uniform}, from the shape"))]);
    }
    Ok((mass, inertia.value))
}

/// Whoever knows the mass centre knows that the part is not uniform: its inertia cannot be that of a uniform one.
fn inertia_missing(uniform: f64, given: &MassCentre) -> Problem {
    let message =
        "missing: a part whose mass centre is given is not uniform, so its inertia has to be given too";
    let problem = Problem::new(ProblemKind::MissingKey, "part.inertia", message, Some(given.span.clone()));
    let shown = Dimension::Inertia.show_digits(uniform, 5);
    problem.with_help(format!("spread evenly over its outline the mass would have {shown} about that point"))
}
