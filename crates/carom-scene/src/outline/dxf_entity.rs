//! The entities of a DXF file as edges.

use super::drawn::{Drawn, Fault, Origin};
use super::dxf::Pair;
use super::edge::{Arc, Edge, Placement};
use super::spline::Spline;
use crate::tolerance::{DXF_NORMAL, DXF_WHOLE_TURN, STRAIGHT_BULGE};
use crate::unit::Unit;
use carom_num::Vec2;
use std::f64::consts::{PI, TAU};

/// What may well draw the outline, in a way that is not read.
const UNSUPPORTED: [(&str, &str); 7] = [
    ("INSERT", "explode blocks before saving"),
    ("REGION", "explode regions into lines and arcs before saving"),
    ("MLINE", "explode multilines before saving"),
    ("HELIX", "draw the outline in the plane"),
    ("3DSOLID", "draw the outline in the plane"),
    ("BODY", "draw the outline in the plane"),
    ("SURFACE", "draw the outline in the plane"),
];

/// One entity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Entity<'p, 't> {
    pub(crate) name: &'t str,
    /// Line of its name, from 1.
    pub(crate) line: usize,
    pub(crate) pairs: &'p [Pair<'t>],
}

impl<'t> Entity<'_, 't> {
    /// The first pair of a group code.
    pub(crate) fn text(&self, code: i32) -> Option<Pair<'t>> {
        self.pairs.iter().find(|pair| pair.code == code).copied()
    }

    pub(crate) fn layer(&self) -> &'t str {
        self.text(8).map_or("0", |pair| pair.value)
    }

    /// True for what is on a paper layout or invisible.
    pub(crate) fn is_hidden(&self) -> bool {
        [67, 60].iter().any(|code| self.text(*code).is_some_and(|pair| pair.value == "1"))
    }

    fn origin(&self) -> Origin {
        Origin { name: self.name.to_owned(), line: self.line }
    }

    fn optional(&self, code: i32) -> Result<Option<f64>, Fault> {
        self.text(code).map(|pair| number(&pair)).transpose()
    }

    fn number(&self, code: i32) -> Result<f64, Fault> {
        let missing = || Fault::new(self.line, format!("{} has no group {code}", self.name));
        self.optional(code)?.ok_or_else(missing)
    }

    fn flags(&self, code: i32) -> Result<u32, Fault> {
        // The cast saturates.
        Ok(self.optional(code)?.unwrap_or(0.0) as u32)
    }

    fn point(&self, code: i32, unit: Unit) -> Result<Vec2, Fault> {
        Ok(Vec2::new(unit.to_si(self.number(code)?), unit.to_si(self.number(code + 10)?)))
    }

    fn length(&self, code: i32, unit: Unit) -> Result<f64, Fault> {
        Ok(unit.to_si(self.number(code)?))
    }

    /// Every value of a group code, in order.
    fn numbers(&self, code: i32) -> Result<Vec<f64>, Fault> {
        self.pairs.iter().filter(|pair| pair.code == code).map(number).collect()
    }

    fn points(&self, code: i32, unit: Unit) -> Result<Vec<Vec2>, Fault> {
        let (x, y) = (self.numbers(code)?, self.numbers(code + 10)?);
        if x.len() != y.len() {
            let text = format!("{} has {} x and {} y coordinates", self.name, x.len(), y.len());
            return Err(Fault::new(self.line, text));
        }
        Ok(x.iter().zip(y).map(|(x, y)| Vec2::new(unit.to_si(*x), unit.to_si(y))).collect())
    }

    /// Entities drawn on the back of the plane have x the other way.
    fn frame(&self) -> Result<Placement, Fault> {
        let [x, y] = [self.optional(210)?.unwrap_or(0.0), self.optional(220)?.unwrap_or(0.0)];
        let z = self.optional(230)?.unwrap_or(1.0);
        if x.abs().max(y.abs()) > DXF_NORMAL || z == 0.0 {
            let text = format!("{} is not drawn in the xy plane (its normal is {x}, {y}, {z})", self.name);
            return Err(Fault::unsupported(self.line, text));
        }
        Ok(Placement::scaled(z.signum(), 1.0))
    }
}

fn number(pair: &Pair<'_>) -> Result<f64, Fault> {
    let bad = || {
        let text = format!("group {}: expected a finite number, found \"{}\"", pair.code, pair.value);
        Fault::new(pair.line + 1, text)
    };
    pair.value.parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(bad)
}

/// Adds an entity; `corners` are the VERTEX entities of an old polyline.
pub(crate) fn draw(
    entity: &Entity<'_, '_>,
    corners: &[Entity<'_, '_>],
    unit: Unit,
    drawn: &mut Drawn,
) -> Result<(), Fault> {
    let (mut edges, mut closed) = (vec![], false);
    match entity.name {
        "LINE" => {
            edges.push(Edge::Line { from: entity.point(10, unit)?, to: entity.point(11, unit)? });
            return drawn.push(edges, false, entity.origin());
        }
        "ELLIPSE" => {
            (edges, closed) = ellipse(entity, unit)?;
            return drawn.push(edges, closed, entity.origin());
        }
        "SPLINE" => return drawn.push(spline(entity, unit)?, false, entity.origin()),
        "CIRCLE" => {
            edges.push(Edge::Arc(Arc::circle(entity.point(10, unit)?, radius(entity, unit)?)));
            closed = true;
        }
        "ARC" => edges.push(arc(entity, unit)?),
        "LWPOLYLINE" => {
            closed = entity.flags(70)? & 1 == 1;
            edges = polyline(&light_corners(entity, unit)?, closed);
        }
        "POLYLINE" => {
            closed = entity.flags(70)? & 1 == 1;
            edges = polyline(&old_corners(entity, corners, unit)?, closed);
        }
        name => {
            if let Some((_, help)) = UNSUPPORTED.iter().find(|(known, _)| *known == name) {
                let text = format!("{name} is not read");
                return Err(Fault::unsupported(entity.line, text).with_help(help));
            }
            drawn.pass_over(name);
            return Ok(());
        }
    }
    // These are drawn in the entity's own axes; the ones above in the world's.
    let frame = entity.frame()?;
    drawn.push(edges.iter().map(|edge| edge.placed(frame)).collect(), closed, entity.origin())
}

fn radius(entity: &Entity<'_, '_>, unit: Unit) -> Result<f64, Fault> {
    let radius = entity.length(40, unit)?;
    let bad = || Fault::new(entity.line, format!("the radius of {} must be above 0", entity.name));
    if radius > 0.0 { Ok(radius) } else { Err(bad()) }
}

/// From one angle to another [rad], counter-clockwise: above 0, at most a turn.
fn sweep(start: f64, end: f64) -> f64 {
    let sweep = (end - start).rem_euclid(TAU);
    if sweep == 0.0 { TAU } else { sweep }
}

fn arc(entity: &Entity<'_, '_>, unit: Unit) -> Result<Edge, Fault> {
    let (centre, radius) = (entity.point(10, unit)?, radius(entity, unit)?);
    let (start, end) = (entity.number(50)?, entity.number(51)?);
    // The difference in degrees is exact where the angles are whole numbers.
    let turn = (end - start).rem_euclid(360.0);
    let sweep = if turn == 0.0 { TAU } else { turn * PI / 180.0 };
    let (u, v) = (Vec2::new(radius, 0.0), Vec2::new(0.0, radius));
    Ok(Edge::Arc(Arc::about(centre, u, v, [start * PI / 180.0, sweep])))
}

fn ellipse(entity: &Entity<'_, '_>, unit: Unit) -> Result<(Vec<Edge>, bool), Fault> {
    let (centre, major) = (entity.point(10, unit)?, entity.point(11, unit)?);
    let ratio = entity.number(40)?;
    if major == Vec2::ZERO || ratio == 0.0 {
        return Err(Fault::new(entity.line, "ELLIPSE has an axis of no length"));
    }
    // The minor axis is the normal × the major one.
    let minor = major.turned_left() * (ratio * entity.frame()?.x.x);
    let start = entity.optional(41)?.unwrap_or(0.0);
    let sweep = sweep(start, entity.optional(42)?.unwrap_or(TAU));
    // A whole ellipse runs from 0 to 2π as the file's digits have it.
    let closed = (sweep - TAU).abs() <= DXF_WHOLE_TURN;
    let sweep = if closed { TAU } else { sweep };
    Ok((vec![Edge::Arc(Arc::about(centre, major, minor, [start, sweep]))], closed))
}

fn spline(entity: &Entity<'_, '_>, unit: Unit) -> Result<Vec<Edge>, Fault> {
    let spline = Spline {
        degree: entity.flags(71)? as usize,
        knots: entity.numbers(40)?,
        points: entity.points(10, unit)?,
        weights: entity.numbers(41)?,
    };
    spline.edges().map_err(|why| Fault::unsupported(entity.line, format!("SPLINE {why}")))
}

/// A corner of a polyline and the bulge of the side after it.
type Corner = (Vec2, f64);

fn light_corners(entity: &Entity<'_, '_>, unit: Unit) -> Result<Vec<Corner>, Fault> {
    let mut corners: Vec<Corner> = vec![];
    let points = entity.points(10, unit)?;
    for pair in entity.pairs {
        match pair.code {
            10 if corners.len() < points.len() => corners.push((points[corners.len()], 0.0)),
            42 => {
                if let Some(last) = corners.last_mut() {
                    last.1 = number(pair)?;
                }
            }
            _ => {}
        }
    }
    Ok(corners)
}

fn old_corners(
    entity: &Entity<'_, '_>,
    corners: &[Entity<'_, '_>],
    unit: Unit,
) -> Result<Vec<Corner>, Fault> {
    const MESH: u32 = 16 | 64;
    const CONTROL: u32 = 16;
    if entity.flags(70)? & MESH != 0 {
        return Err(Fault::unsupported(entity.line, "POLYLINE is a mesh, not an outline"));
    }
    let mut found = vec![];
    for corner in corners {
        // A fitted polyline has its control points among its corners.
        if corner.flags(70)? & CONTROL == 0 {
            found.push((corner.point(10, unit)?, corner.optional(42)?.unwrap_or(0.0)));
        }
    }
    Ok(found)
}

fn polyline(corners: &[Corner], closed: bool) -> Vec<Edge> {
    let k = corners.len();
    let sides = if closed { k } else { k.saturating_sub(1) };
    let side = |i: usize| {
        let ((from, bulge), (to, _)) = (corners[i], corners[(i + 1) % k]);
        if bulge.abs() < STRAIGHT_BULGE || from == to {
            Edge::Line { from, to }
        } else {
            Edge::Arc(Arc::bulged(from, to, bulge))
        }
    };
    (0..sides).map(side).collect()
}
