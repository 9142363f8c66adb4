//! DXF of release 12 as text: groups, entities, and the frame around them.

use carom_num::Vec2;
use std::fmt::Write as _;

/// Millimetres of a metre.
const MILLI: f64 = 1e3;

/// Groups of a drawing: a code and a value each, on two lines. Lengths come in metres and stand in millimetres.
#[derive(Default)]
pub(crate) struct Group {
    pub(crate) text: String,
}

impl Group {
    pub(crate) fn group(&mut self, code: u32, value: impl std::fmt::Display) {
        // Writing to a String cannot fail.
        let _ = write!(self.text, "{code}\r\n{value}\r\n");
    }

    pub(crate) fn begin(&mut self, kind: &str, layer: &str) {
        self.group(0, kind);
        self.group(8, layer);
    }

    /// A point under the codes of its coordinates.
    pub(crate) fn point(&mut self, code: u32, p: Vec2) {
        self.group(code, mm(p.x));
        self.group(code + 10, mm(p.y));
        self.group(code + 20, "0.0");
    }

    pub(crate) fn line(&mut self, layer: &str, from: Vec2, to: Vec2) {
        self.begin("LINE", layer);
        self.point(10, from);
        self.point(11, to);
    }

    pub(crate) fn circle(&mut self, layer: &str, centre: Vec2, radius: f64) {
        self.begin("CIRCLE", layer);
        self.point(10, centre);
        self.group(40, mm(radius));
    }

    /// Counter-clockwise from one angle to another [°].
    pub(crate) fn arc(&mut self, layer: &str, centre: Vec2, radius: f64, angles: [f64; 2]) {
        self.begin("ARC", layer);
        self.point(10, centre);
        self.group(40, mm(radius));
        self.group(50, plain(angles[0].rem_euclid(360.0), 9));
        self.group(51, plain(angles[1].rem_euclid(360.0), 9));
    }

    /// A filled triangle.
    pub(crate) fn triangle(&mut self, layer: &str, [a, b, c]: [Vec2; 3]) {
        self.begin("SOLID", layer);
        for (code, p) in [(10, a), (11, b), (12, c), (13, c)] {
            self.point(code, p);
        }
    }

    /// A text that begins at a point, of letters so high [mm].
    pub(crate) fn label(&mut self, layer: &str, at: Vec2, letters: f64, text: &str) {
        self.begin("TEXT", layer);
        self.point(10, at);
        self.group(40, plain(letters, 3));
        self.group(1, ascii(text));
    }

    /// A text with its middle at a point, turned by an angle [°].
    pub(crate) fn centred(&mut self, layer: &str, at: Vec2, letters: f64, angle: f64, text: &str) {
        self.label(layer, at, letters, text);
        self.group(50, plain(angle, 6));
        self.group(72, 1);
        self.point(11, at);
        self.group(73, 2);
    }

    /// A whole file with these entities.
    pub(crate) fn whole(self, blocks: &str, layers: &[&str]) -> String {
        let mut out = Group::default();
        section(&mut out, "HEADER", |out| {
            for (name, code, value) in [("$ACADVER", 1, "AC1009"), ("$INSUNITS", 70, "4")] {
                out.group(9, name);
                out.group(code, value);
            }
        });
        section(&mut out, "TABLES", |out| tables(out, layers));
        section(&mut out, "BLOCKS", |out| out.text += blocks);
        section(&mut out, "ENTITIES", |out| out.text += &self.text);
        out.group(0, "EOF");
        out.text
    }
}

fn section(out: &mut Group, name: &str, fill: impl FnOnce(&mut Group)) {
    out.group(0, "SECTION");
    out.group(2, name);
    fill(out);
    out.group(0, "ENDSEC");
}

fn tables(out: &mut Group, layers: &[&str]) {
    let table = |out: &mut Group, name: &str, rows: Vec<Vec<(u32, String)>>| {
        out.group(0, "TABLE");
        out.group(2, name);
        out.group(70, rows.len());
        for row in rows {
            out.group(0, name);
            for (code, value) in row {
                out.group(code, value);
            }
        }
        out.group(0, "ENDTAB");
    };
    let row = |groups: &[(u32, &str)]| -> Vec<(u32, String)> {
        groups.iter().map(|(code, value)| (*code, (*value).to_owned())).collect()
    };
    let solid = [(2, "CONTINUOUS"), (70, "0"), (3, "Solid line"), (72, "65"), (73, "0"), (40, "0.0")];
    table(out, "LTYPE", vec![row(&solid)]);
    let layer = |name: &str| row(&[(2, name), (70, "0"), (62, "7"), (6, "CONTINUOUS")]);
    table(out, "LAYER", ["0"].iter().chain(layers).map(|name| layer(name)).collect());
    let style = [
        (2, "STANDARD"),
        (70, "0"),
        (40, "0.0"),
        (41, "1.0"),
        (50, "0.0"),
        (71, "0"),
        (42, "2.5"),
        (3, "txt"),
        (4, ""),
    ];
    table(out, "STYLE", vec![row(&style)]);
    table(out, "DIMSTYLE", vec![row(&[(2, "STANDARD"), (70, "0")])]);
}

/// Text of this release is ASCII, with names of its own for degrees and tolerances.
pub(crate) fn ascii(text: &str) -> String {
    let plain = text.replace('°', "%%d").replace('±', "%%p").replace('−', "-");
    plain.chars().map(|c| if c.is_ascii() && !c.is_control() { c } else { '?' }).collect()
}

/// To a nanometre, far below what is made.
pub(crate) fn mm(metres: f64) -> String {
    plain(metres * MILLI, 6)
}

/// A number as programs read it: with a hyphen for a minus, and no minus before zero.
pub(crate) fn plain(value: f64, decimals: usize) -> String {
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

    #[test]
    fn texts_are_ascii() {
        assert_eq!(ascii("25 ± 0.5° für\n−1"), "25 %%p 0.5%%d f?r?-1");
    }
}
