//! The shapes and paths of an SVG file as edges, in its user units.

use super::edge::{Arc, Edge};
use super::spline::quadratic;
use carom_num::Vec2;
use carom_num::elementary::{atan2, sin_cos};
use roxmltree::Node;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::str::FromStr;
use svgtypes::{Length, LengthUnit, PathParser, PathSegment, PointsParser};

/// Edges that follow each other, and whether the last meets the first.
type Chain = (Vec<Edge>, bool);

/// What an element draws; `None` where it is no outline.
///
/// # Errors
/// In words, what is wrong with it.
pub(crate) fn shape_of(node: Node<'_, '_>) -> Result<Option<Vec<Chain>>, String> {
    let number = |key: &str| number(node, key);
    match node.tag_name().name() {
        "path" => path(node.attribute("d").unwrap_or_default()).map(Some),
        "rect" => Ok(Some(vec![(rectangle(node)?, true)])),
        "circle" => {
            let (centre, radius) = (Vec2::new(number("cx")?, number("cy")?), number("r")?);
            Ok(Some(vec![(round(centre, radius, radius)?, true)]))
        }
        "ellipse" => {
            let centre = Vec2::new(number("cx")?, number("cy")?);
            Ok(Some(vec![(round(centre, number("rx")?, number("ry")?)?, true)]))
        }
        "line" => {
            let (from, to) =
                (Vec2::new(number("x1")?, number("y1")?), Vec2::new(number("x2")?, number("y2")?));
            Ok(Some(vec![(vec![Edge::Line { from, to }], false)]))
        }
        "polygon" => Ok(Some(vec![(polyline(node, true), true)])),
        "polyline" => Ok(Some(vec![(polyline(node, false), false)])),
        _ => Ok(None),
    }
}

/// An attribute in user units, 0 where it is missing.
fn number(node: Node<'_, '_>, key: &str) -> Result<f64, String> {
    let Some(text) = node.attribute(key) else { return Ok(0.0) };
    match Length::from_str(text) {
        Ok(Length { number, unit: LengthUnit::None | LengthUnit::Px }) => Ok(number),
        Ok(_) => Err(format!("has {key} = \"{text}\": only plain user units are read")),
        Err(_) => Err(format!("has {key} = \"{text}\", which is no number")),
    }
}

fn round(centre: Vec2, rx: f64, ry: f64) -> Result<Vec<Edge>, String> {
    if rx <= 0.0 || ry <= 0.0 {
        return Err("has a radius that is not above 0".to_owned());
    }
    Ok(vec![Edge::Arc(Arc::about(centre, Vec2::new(rx, 0.0), Vec2::new(0.0, ry), [0.0, TAU]))])
}

fn polyline(node: Node<'_, '_>, closed: bool) -> Vec<Edge> {
    let points = PointsParser::from(node.attribute("points").unwrap_or_default());
    let points: Vec<Vec2> = points.map(|(x, y)| Vec2::new(x, y)).collect();
    let k = points.len();
    let sides = if closed { k } else { k.saturating_sub(1) };
    (0..sides).map(|i| Edge::Line { from: points[i], to: points[(i + 1) % k] }).collect()
}

fn rectangle(node: Node<'_, '_>) -> Result<Vec<Edge>, String> {
    let number = |key: &str| number(node, key);
    let (low, width, height) = (Vec2::new(number("x")?, number("y")?), number("width")?, number("height")?);
    if width <= 0.0 || height <= 0.0 {
        return Err("has a side that is not above 0".to_owned());
    }
    let given = |key: &str| number(key).map(|radius| node.attribute(key).map(|_| radius.max(0.0)));
    let (along, down) = (given("rx")?, given("ry")?);
    let rx = along.or(down).unwrap_or(0.0).min(0.5 * width);
    let ry = down.or(along).unwrap_or(0.0).min(0.5 * height);
    let high = low + Vec2::new(width, height);
    let (u, v) = (Vec2::new(rx, 0.0), Vec2::new(0.0, ry));
    // From the left end of the side of low y; turns go from x to y.
    let corners = [
        (Vec2::new(high.x - rx, low.y + ry), -FRAC_PI_2),
        (Vec2::new(high.x - rx, high.y - ry), 0.0),
        (Vec2::new(low.x + rx, high.y - ry), FRAC_PI_2),
        (Vec2::new(low.x + rx, low.y + ry), PI),
    ];
    let ends = |centre: Vec2, start: f64| match start {
        s if s < 0.0 => (centre - v, centre + u),
        0.0 => (centre + u, centre + v),
        s if s < PI => (centre + v, centre - u),
        _ => (centre - u, centre - v),
    };
    let mut edges: Vec<Edge> = vec![];
    let mut at = ends(corners[3].0, PI).1;
    for (centre, start) in corners {
        let (from, to) = ends(centre, start);
        edges.push(Edge::Line { from: at, to: from });
        if rx > 0.0 && ry > 0.0 {
            let arc = Arc::about(centre, u, v, [start, FRAC_PI_2]);
            edges.push(Edge::Arc(Arc { from, to, ..arc }));
        }
        at = to;
    }
    Ok(edges)
}

/// A path while it is drawn.
#[derive(Default)]
struct Pen {
    chains: Vec<Chain>,
    edges: Vec<Edge>,
    start: Vec2,
    at: Vec2,
    /// The last control point of a cubic and of a quadratic, for those that go on smoothly.
    cubic: Option<Vec2>,
    quadratic: Option<Vec2>,
}

impl Pen {
    fn lift(&mut self, closed: bool) {
        if closed && self.at != self.start && !self.edges.is_empty() {
            self.edges.push(Edge::Line { from: self.at, to: self.start });
        }
        if !self.edges.is_empty() {
            self.chains.push((std::mem::take(&mut self.edges), closed));
        }
    }

    fn draw(&mut self, edge: Edge) {
        self.at = edge.to();
        self.edges.push(edge);
    }
}

fn path(text: &str) -> Result<Vec<Chain>, String> {
    let mut pen = Pen::default();
    for segment in PathParser::from(text) {
        let segment = segment.map_err(|error| format!("has a path that cannot be read: {error}"))?;
        follow(&mut pen, segment);
    }
    pen.lift(false);
    Ok(pen.chains)
}

fn follow(pen: &mut Pen, segment: PathSegment) {
    let base = if segment.is_abs() { Vec2::ZERO } else { pen.at };
    let point = |x: f64, y: f64| base + Vec2::new(x, y);
    // SVG lets a smooth curve leave out its first control point: it is the mirror image of the last one before, or the pen itself after any other segment.
    let mirrored = |control: Option<Vec2>| control.map_or(pen.at, |control| pen.at * 2.0 - control);
    let (mut cubic, mut middle) = (None, None);
    let line = |to: Vec2| Edge::Line { from: pen.at, to };
    let edge = match segment {
        PathSegment::MoveTo { x, y, .. } => {
            let to = point(x, y);
            pen.lift(false);
            (pen.start, pen.at, pen.cubic, pen.quadratic) = (to, to, None, None);
            return;
        }
        PathSegment::ClosePath { .. } => {
            pen.lift(true);
            (pen.at, pen.cubic, pen.quadratic) = (pen.start, None, None);
            return;
        }
        PathSegment::LineTo { x, y, .. } => line(point(x, y)),
        PathSegment::HorizontalLineTo { x, .. } => line(Vec2::new(base.x + x, pen.at.y)),
        PathSegment::VerticalLineTo { y, .. } => line(Vec2::new(pen.at.x, base.y + y)),
        PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
            cubic = Some(point(x2, y2));
            Edge::Cubic([pen.at, point(x1, y1), point(x2, y2), point(x, y)])
        }
        PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
            cubic = Some(point(x2, y2));
            Edge::Cubic([pen.at, mirrored(pen.cubic), point(x2, y2), point(x, y)])
        }
        PathSegment::Quadratic { x1, y1, x, y, .. } => {
            middle = Some(point(x1, y1));
            quadratic(pen.at, point(x1, y1), point(x, y))
        }
        PathSegment::SmoothQuadratic { x, y, .. } => {
            let control = mirrored(pen.quadratic);
            middle = Some(control);
            quadratic(pen.at, control, point(x, y))
        }
        PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. } => {
            let radii = Vec2::new(rx.abs(), ry.abs());
            elliptic(pen.at, point(x, y), radii, x_axis_rotation * PI / 180.0, [large_arc, sweep])
        }
    };
    pen.draw(edge);
    (pen.cubic, pen.quadratic) = (cubic, middle);
}

/// An arc from its ends, as a path has it.
///
/// # Source
/// W3C, *SVG 1.1*, appendix F.6: from endpoint to centre parametrization, radii that are too small made larger.
fn elliptic(from: Vec2, to: Vec2, radii: Vec2, turn: f64, [large, positive]: [bool; 2]) -> Edge {
    if radii.x == 0.0 || radii.y == 0.0 || from == to {
        return Edge::Line { from, to };
    }
    let (sin, cos) = sin_cos(turn);
    // Half the chord in the axes of the ellipse, shrunk to the unit circle.
    let half = (from - to).rotated(cos, -sin) * 0.5;
    let unit = Vec2::new(half.x / radii.x, half.y / radii.y);
    let grow = unit.norm().max(1.0);
    let (radii, unit) = (radii * grow, unit / grow);
    // The centre, from the chord's middle, is at right angles to the chord.
    let chord = unit.dot(unit);
    let away = ((1.0 - chord).max(0.0) / chord).sqrt() * if large == positive { -1.0 } else { 1.0 };
    let centre = Vec2::new(unit.y, -unit.x) * away;
    let first = unit - centre;
    // Half the chord and its distance from the centre: no digits are lost on a flat arc.
    let turn = 2.0 * atan2(unit.norm(), centre.norm());
    let turn = if large { TAU - turn } else { turn };
    let sweep = if positive { turn } else { -turn };
    let stretch = |p: Vec2| Vec2::new(p.x * radii.x, p.y * radii.y).rotated(cos, sin);
    Edge::Arc(Arc { from, to, u: stretch(first), v: stretch(first.turned_left()), sweep })
}
