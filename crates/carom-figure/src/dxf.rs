//! The layout as a drawing that a workshop's programs read: DXF, millimetres, one to one.

use crate::draft::Draft;
use crate::dxf_dimension::Dimensions;
use crate::dxf_file::{Group, plain};
use crate::mechanism::drawn;
use crate::outline::{Bend, sides};
use crate::sheet::view_of_sheet;
use carom_feeder::{Feeder, Form, Plate};
use carom_motion::planar::Shape;
use carom_num::{Vec2, elementary::atan2};
use carom_words::part;

/// Millimetres of a metre.
const MILLI: f64 = 1e3;

/// The layout as DXF (release 12, which every reader knows): plates on the layer PLATES, walls on WALLS, the part where it starts on PART,
/// what touches of it on TOUCHES where a file draws something else, measures on DIMENSIONS, each a dimension with its picture in a block. In
/// millimetres; the origin and the axes are the scene's.
///
/// Plates whose drawing gives no length are cut to the neighbourhood of the others, and marked so.
pub fn layout_dxf(feeder: &Feeder, draft: &Draft) -> String {
    let view = view_of_sheet(feeder);
    let mut dimensions = Dimensions::of(&view);
    let mut out = Group::default();
    for (i, plate) in feeder.plates.iter().enumerate() {
        let (mut from, mut to) = (plate.uphill, plate.edge);
        if let Some((a, b, _)) = view.clip(from, to).filter(|_| plate.unbounded) {
            (from, to) = (a, b);
        }
        if plate.form.is_plain() {
            out.line("PLATES", from, to);
        } else {
            bent(&mut out, "PLATES", feeder, i, &plate.form);
        }
        ends(&mut out, dimensions.letters(), plate, from, to);
        if let Some(d) = drawn(feeder, i, &view).filter(|_| plate.form.course.is_empty()) {
            dimensions.slope(feeder, draft, i, &d);
        }
    }
    for (i, wall) in feeder.walls.iter().enumerate() {
        if !wall.form.is_plain() {
            bent(&mut out, "WALLS", feeder, feeder.plates.len() + i, &wall.form);
        } else if let Some((from, to, _)) = view.clip(wall.from, wall.to) {
            out.line("WALLS", from, to);
        }
    }
    part(&mut out, feeder, draft);
    dimensions.lengths(feeder, draft);
    for (i, plate) in feeder.plates.iter().enumerate() {
        if let Some(d) = drawn(feeder, i, &view) {
            dimensions.name(&mut out, &d, &name_of(&part::obstacle(feeder, i), plate));
        }
    }
    let (blocks, entities) = dimensions.done();
    out.text += &entities;
    out.whole(&blocks, &["PLATES", "WALLS", "PART", "TOUCHES", "DIMENSIONS", "DEFPOINTS"])
}

/// Name, length and slope of a plate.
fn name_of(label: &str, plate: &Plate) -> String {
    let length = if plate.unbounded {
        "as long as needed".to_owned()
    } else {
        format!("{} mm", plain(plate.length() * MILLI, 2))
    };
    let [begins, ends] = plate.slopes().map(|slope| plain(slope.to_degrees(), 3));
    let slope = if plate.form.course.is_empty() { ends } else { format!("{begins} to {ends}") };
    let edge = match plate.form.edge_radius {
        0.0 => String::new(),
        radius => format!(", edge radius {} mm", plain(radius * MILLI, 3)),
    };
    format!("{label}: {length}, {slope} deg{edge}")
}

/// A plate or wall that is bent or has rounded edges: its course where it is thin, else its outline.
fn bent(out: &mut Group, layer: &str, feeder: &Feeder, obstacle: usize, form: &Form) {
    if form.edge_radius == 0.0 {
        for pair in form.course.windows(2) {
            let (from, to) = (pair[0], pair[1].at);
            match from.arc_to(to) {
                None => out.line(layer, from.at, to),
                Some((centre, radius)) => {
                    // Arcs of a drawing run counter-clockwise.
                    let ends = if radius > 0.0 { [from.at, to] } else { [to, from.at] };
                    let angle = |p: Vec2| atan2(p.y - centre.y, p.x - centre.x).to_degrees();
                    out.arc(layer, centre, radius.abs(), ends.map(angle));
                }
            }
        }
    } else if let Ok(Some(obstacle)) = feeder.obstacle(obstacle) {
        shape(out, layer, obstacle.shape(), 0.0, |p| p);
    }
}

/// The places of the ends of a plate.
fn ends(out: &mut Group, letters: f64, plate: &Plate, from: Vec2, to: Vec2) {
    let place = |p: Vec2| format!("({}, {})", plain(p.x * MILLI, 2), plain(p.y * MILLI, 2));
    let up = Vec2::new(0.0, 1.1 * letters / MILLI);
    if !plate.unbounded {
        out.label("DIMENSIONS", from + up, letters, &place(plate.uphill));
    }
    out.label("DIMENSIONS", to + up, letters, &format!("edge {}", place(plate.edge)));
}

/// The part where it starts: what its file draws, and what touches.
fn part(out: &mut Group, feeder: &Feeder, draft: &Draft) {
    let pose = feeder.start_state().pose;
    let turn = Vec2::at_angle(pose.angle);
    let place = |p: Vec2| pose.centre + p.rotated(turn.x, turn.y);
    for chain in &draft.outline {
        for (i, point) in chain.iter().enumerate() {
            out.line("PART", place(*point), place(chain[(i + 1) % chain.len()]));
        }
    }
    let layer = if draft.outline.is_empty() { "PART" } else { "TOUCHES" };
    shape(out, layer, &feeder.part.body.shape, pose.angle.to_degrees(), place);
}

/// A shape, turned by an angle [°]: its segments and arcs.
fn shape(out: &mut Group, layer: &str, shape: &Shape, turned: f64, place: impl Fn(Vec2) -> Vec2) {
    if shape.faces() == 0 {
        out.circle(layer, place(shape.vertices()[0]), shape.radius_of(0));
        return;
    }
    let angle = |n: Vec2| atan2(n.y, n.x).to_degrees() + turned;
    for side in sides(shape) {
        if side.has_length {
            out.line(layer, place(side.from), place(side.to));
        }
        // Arcs of a drawing run counter-clockwise: one about a hollow is drawn the other way, seen from its centre.
        if let Some(Bend { centre, radius, normals }) = side.arc {
            let [from, to] = if radius > 0.0 { normals } else { [-normals[1], -normals[0]] };
            out.arc(layer, place(centre), radius.abs(), [angle(from), angle(to)]);
        }
    }
}
