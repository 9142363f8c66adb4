//! The measures of a layout: first what the scene writes, then what follows from it.

use crate::draft::{Axis, Draft, Measure};
use crate::layout::{millimetres, wall_beside};
use crate::mechanism::plumb;
use crate::senses::slopes_text;
use carom_feeder::{Feeder, Plate, Wall};
use carom_num::Vec2;

/// Places within this share of the layout's size are the same.
const SAME: f64 = 1e-9;

/// A measure as drawn.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Drawn {
    pub(crate) axis: Axis,
    pub(crate) from: Vec2,
    pub(crate) to: Vec2,
    pub(crate) text: String,
    /// False for one that follows from others.
    pub(crate) written: bool,
}

/// All lengths of a layout; with `full` also those that a workshop asks for and nobody wrote: lengths of plates, drops from hinge to hinge.
pub(crate) fn lengths(feeder: &Feeder, draft: &Draft, full: bool) -> Vec<Drawn> {
    let mut all: Vec<Drawn> =
        draft.measures.iter().filter(|m| m.axis != Axis::Slope).map(as_written).collect();
    let said = !draft.measures.is_empty();
    let mut add = |name: &str, axis: Axis, from: Vec2, to: Vec2| {
        let length = millimetres(axis.length(from, to));
        // In parentheses, as drawings have it, where others are written that it follows from.
        let text = if said { format!("({length})") } else { length };
        let text = if name.is_empty() { text } else { format!("{name} {text}") };
        let known = all.iter().any(|other| other.axis == axis && same(other, from, to));
        if !known && axis.length(from, to) > 0.0 {
            all.push(Drawn { axis, from, to, text, written: false });
        }
    };
    for (i, plate) in feeder.plates.iter().enumerate() {
        if full && !plate.unbounded && plate.form.course.is_empty() && draft.of_plate(i, "length").is_none() {
            add("length", Axis::Along, plate.uphill, plate.edge);
        }
        if let Some(next) = feeder.plates.get(i + 1) {
            let hinges = full && !plate.unbounded && !next.unbounded && next.uphill.y < plate.uphill.y;
            if hinges && draft.of_plate(i + 1, "drop").is_none() {
                add("drop", Axis::Plumb, plate.uphill, next.uphill);
            }
            if let Some(foot) = plumb(feeder, i + 1, plate.edge) {
                add("plumb", Axis::Plumb, plate.edge, foot);
            }
        }
        if let Some(side) = wall_beside(feeder, i).filter(|_| draft.of_plate(i, "gap").is_none()) {
            add("", Axis::Level, plate.edge, side);
        }
    }
    let arcs = feeder.plates.iter().map(Plate::arcs).chain(feeder.walls.iter().map(Wall::arcs)).flatten();
    for arc in arcs.filter(|arc| full || !arc.uphill) {
        let name = if arc.bend { "bend R" } else { "edge R" };
        add(name, Axis::Radius, arc.centre, arc.middle);
    }
    all
}

fn as_written(measure: &Measure) -> Drawn {
    let Measure { name, text, axis, from, to, .. } = measure;
    Drawn { axis: *axis, from: *from, to: *to, text: format!("{name} {text}"), written: true }
}

fn same(other: &Drawn, from: Vec2, to: Vec2) -> bool {
    let near = SAME * (to - from).norm();
    let is = |a: Vec2, b: Vec2| (a - b).norm() <= near;
    (is(other.from, from) && is(other.to, to)) || (is(other.from, to) && is(other.to, from))
}

/// The slope of a plate: as it is written, else to a hundredth of a degree.
pub(crate) fn slope_text(feeder: &Feeder, draft: &Draft, plate: usize) -> String {
    match (draft.of_plate(plate, "slope"), feeder.plates.get(plate)) {
        (Some(written), _) => written.text.clone(),
        (None, Some(plate)) => slopes_text(plate, 1),
        (None, None) => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_feeder::{Part, Plate, Start, Stop};
    use carom_impact::Law;

    fn feeder() -> Feeder {
        let plate = |name: &str, uphill, edge| Plate {
            name: name.to_owned(),
            uphill,
            edge,
            friction: 0.2,
            restitution: 0.0,
            unbounded: false,
            form: Default::default(),
        };
        let (upper, lower) = ([(0.0, 0.0), (0.12, -0.05)], [(0.2, -0.15), (0.08, -0.2)]);
        let [upper, lower] = [upper, lower].map(|ends| ends.map(|(x, y)| Vec2::new(x, y)));
        Feeder {
            gravity: 9.81,
            stop: Stop::Landed,
            law: Law::Poisson,
            part: Part::rectangle(0.03, 0.01, 0.05, 4e-6).unwrap(),
            start: Start { to_edge: 0.05, speed: 0.0, face: 0 },
            plates: vec![plate("upper", upper[0], upper[1]), plate("lower", lower[0], lower[1])],
            walls: vec![],
        }
    }

    #[test]
    fn what_is_written_stands_as_it_is_written_and_what_follows_in_parentheses() {
        let feeder = feeder();
        let (from, to) = (feeder.plates[0].uphill, feeder.plates[1].uphill);
        let drop = Measure {
            plate: Some(1),
            name: "drop".to_owned(),
            text: "150 ± 1 mm".to_owned(),
            axis: Axis::Plumb,
            from,
            to,
        };
        let draft = Draft { measures: vec![drop], ..Draft::default() };
        let texts = |full: bool| -> Vec<String> {
            lengths(&feeder, &draft, full).into_iter().map(|drawn| drawn.text).collect()
        };
        // Below (0.12, −0.05) the lower plate is at −0.15 − 0.08·5/12 = −0.18333.
        assert_eq!(texts(false), ["drop 150 ± 1 mm", "plumb (133.33 mm)"]);
        // Both plates are 12 by 5: 13 long.
        let all = ["drop 150 ± 1 mm", "length (130 mm)", "plumb (133.33 mm)", "length (130 mm)"];
        assert_eq!(texts(true), all);
    }
}
