//! The layout as a drawing that a workshop's programs read: DXF, millimetres, one to one.

use crate::mechanism::view_of;
use crate::motion::corners;
use crate::words::slope;
use carom_feeder::{Feeder, Plate};
use carom_num::Vec2;
use std::fmt::Write as _;

/// Millimetres of a metre.
const MILLI: f64 = 1e3;
/// Height of letters [mm].
const LETTERS: f64 = 6.0;

/// The layout as DXF (release 12, which every reader knows): plates on the layer PLATES, walls on WALLS, the part where it starts on PART,
/// lengths, slopes and the places of ends on DIMENSIONS. In millimetres; the origin and the axes are the scene's.
///
/// Plates whose drawing gives no length are cut to the neighbourhood of the others, and marked so.
///
/// # Example
/// A plate of 1 m that falls 3 in 4: atan(3/4) = 36.870°. Plate and rod are a line each, the rod there and
/// back.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// let dxf = carom_figure::layout_dxf(&feeder);
/// assert!(dxf.contains("upper: 1000.00 mm, 36.870 deg") && dxf.contains("edge (0.00, 0.00)"));
/// let lines = |layer: &str| dxf.matches(&format!("LINE\r\n8\r\n{layer}\r\n")).count();
/// assert_eq!((lines("PLATES"), lines("PART")), (1, 2));
/// ```
pub fn layout_dxf(feeder: &Feeder) -> String {
    let view = view_of(feeder, &[], 1000.0, 1000.0);
    let mut out = Dxf::default();
    for plate in &feeder.plates {
        let Some((from, to, _)) = view.clip(plate.uphill, plate.edge).filter(|_| plate.unbounded) else {
            out.line("PLATES", plate.uphill, plate.edge);
            out.plate(plate, plate.uphill, plate.edge);
            continue;
        };
        out.line("PLATES", from, to);
        out.plate(plate, from, to);
    }
    for wall in &feeder.walls {
        if let Some((from, to, _)) = view.clip(wall.from, wall.to) {
            out.line("WALLS", from, to);
        }
    }
    let part: Vec<Vec2> = corners(&feeder.part.body.shape, feeder.start_state().pose).collect();
    for (i, corner) in part.iter().enumerate() {
        out.line("PART", *corner, part[(i + 1) % part.len()]);
    }
    let (shape, centre) = (&feeder.part.body.shape, feeder.start_state().pose.centre);
    if part.len() == 1 {
        out.circle("PART", centre, shape.radius());
    }
    out.whole()
}

/// Groups of a drawing: a code and a value each, on two lines.
#[derive(Default)]
struct Dxf {
    entities: String,
}

impl Dxf {
    fn group(&mut self, code: u32, value: impl std::fmt::Display) {
        // Writing to a String cannot fail.
        let _ = write!(self.entities, "{code}\r\n{value}\r\n");
    }

    fn begin(&mut self, kind: &str, layer: &str) {
        self.group(0, kind);
        self.group(8, layer);
    }

    /// A point under the codes of its coordinates.
    fn point(&mut self, code: u32, p: Vec2) {
        self.group(code, mm(p.x));
        self.group(code + 10, mm(p.y));
        self.group(code + 20, "0.0");
    }

    fn line(&mut self, layer: &str, from: Vec2, to: Vec2) {
        self.begin("LINE", layer);
        self.point(10, from);
        self.point(11, to);
    }

    fn circle(&mut self, layer: &str, centre: Vec2, radius: f64) {
        self.begin("CIRCLE", layer);
        self.point(10, centre);
        self.group(40, mm(radius));
    }

    fn text(&mut self, at: Vec2, text: &str) {
        self.begin("TEXT", "DIMENSIONS");
        self.point(10, at);
        self.group(40, LETTERS);
        // Text of this release is ASCII.
        let plain: String = text.chars().map(|c| if c.is_ascii() { c } else { '?' }).collect();
        self.group(1, plain);
    }

    /// Name, length, slope and places of the ends of a plate.
    fn plate(&mut self, plate: &Plate, from: Vec2, to: Vec2) {
        let step = Vec2::new(0.0, -1.6 * LETTERS / MILLI);
        let middle = (from + to) * 0.5;
        let length = if plate.unbounded {
            "as long as needed".to_owned()
        } else {
            format!("{} mm", plain((plate.edge - plate.uphill).norm() * MILLI, 2))
        };
        self.text(
            middle + step,
            &format!(
                "{}: {length}, {} deg",
                plate.name,
                plain(slope(plate.uphill, plate.edge).to_degrees(), 3)
            ),
        );
        let place = |p: Vec2| format!("({}, {})", plain(p.x * MILLI, 2), plain(p.y * MILLI, 2));
        if !plate.unbounded {
            self.text(plate.uphill - step * 0.6, &place(plate.uphill));
        }
        self.text(to + step, &format!("edge {}", place(plate.edge)));
    }

    fn whole(self) -> String {
        let header = "0\r\nSECTION\r\n2\r\nHEADER\r\n9\r\n$ACADVER\r\n1\r\nAC1009\r\n9\r\n$INSUNITS\r\n70\r\n4\r\n0\r\nENDSEC\r\n";
        let entities = self.entities;
        format!("{header}0\r\nSECTION\r\n2\r\nENTITIES\r\n{entities}0\r\nENDSEC\r\n0\r\nEOF\r\n")
    }
}

/// To a nanometre, far below what is made.
fn mm(metres: f64) -> String {
    plain(metres * MILLI, 6)
}

/// A number as programs read it: with a hyphen for a minus, and no minus before zero.
fn plain(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let zero = text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.');
    if zero { text.trim_start_matches('-').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_programs() {
        assert_eq!([plain(-35.2, 2), plain(-1e-9, 2)], ["-35.20", "0.00"]);
        assert!(!mm(-0.4).contains('\u{2212}'));
    }
}
