//! The impulse plane for a terminal: Braille dots, eight to a character.

use crate::impulse::ImpulsePlane;
use crate::text::significant;

/// Bit of the dot in column x (0, 1) and row y (0…3) of a Braille character.
const BITS: [[u8; 4]; 2] = [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]];

struct Canvas {
    columns: usize,
    rows: usize,
    dots: Vec<u8>,
    letters: Vec<Option<char>>,
}

impl Canvas {
    fn new(columns: usize, rows: usize) -> Self {
        Self { columns, rows, dots: vec![0; columns * rows], letters: vec![None; columns * rows] }
    }

    /// The cell and the bit of a place in [0, 1]², from the upper left.
    fn cell(&self, u: f64, v: f64) -> Option<(usize, u8)> {
        if !((0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v)) {
            return None;
        }
        let x = ((u * (2 * self.columns - 1) as f64).round()) as usize;
        let y = ((v * (4 * self.rows - 1) as f64).round()) as usize;
        let bit = BITS.get(x % 2)?.get(y % 4)?;
        Some(((y / 4) * self.columns + x / 2, *bit))
    }

    fn line(&mut self, from: (f64, f64), to: (f64, f64), keep: impl Fn(usize) -> bool) {
        let steps = 6 * self.columns.max(2 * self.rows);
        for k in (0..=steps).filter(|k| keep(*k)) {
            let s = k as f64 / steps as f64;
            let at = (from.0 + s * (to.0 - from.0), from.1 + s * (to.1 - from.1));
            if let Some((cell, bit)) = self.cell(at.0, at.1)
                && let Some(dots) = self.dots.get_mut(cell)
            {
                *dots |= bit;
            }
        }
    }

    fn letter(&mut self, at: (f64, f64), letter: char) {
        if let Some((cell, _)) = self.cell(at.0.clamp(0.0, 1.0), at.1.clamp(0.0, 1.0))
            && let Some(place) = self.letters.get_mut(cell)
        {
            *place = Some(letter);
        }
    }

    fn text(&self) -> Vec<String> {
        let cells = self.dots.iter().zip(&self.letters).map(|(dots, letter)| {
            letter.unwrap_or_else(|| char::from_u32(0x2800 + u32::from(*dots)).unwrap_or(' '))
        });
        let cells: Vec<char> = cells.map(|c| if c == '\u{2800}' { ' ' } else { c }).collect();
        cells.chunks(self.columns).map(|row| row.iter().collect::<String>().trim_end().to_owned()).collect()
    }
}

/// The impulse plane drawn with `columns` × `rows` characters: the friction cone (dotted), the line of sticking `S`, the line of maximum
/// compression `C`, and the walk with its corners numbered, explained below. Empty where there is no impulse to draw.
///
/// Sizes below 20 × 6 are raised to that.
pub fn impulse_text(plane: &ImpulsePlane, columns: usize, rows: usize) -> String {
    if !plane.can_be_drawn() {
        return String::new();
    }
    let (half, normal) = plane.extent();
    let mut canvas = Canvas::new(columns.max(20), rows.max(6));
    let at = |n: f64, t: f64| (n / normal, 0.5 * (1.0 - t / half));
    let dotted = |k: usize| k % 18 < 3;
    let o = at(0.0, 0.0);
    canvas.line(o, at(normal, plane.friction * normal), dotted);
    canvas.line(o, at(normal, -plane.friction * normal), dotted);
    for (line, letter) in [(plane.line_of_sticking(), 'S'), (plane.line_of_compression(), 'C')] {
        if let Some(line) = line {
            deciding_line(&mut canvas, line, (half, normal), letter);
        }
    }
    let mut from = o;
    for (i, p) in plane.points.iter().enumerate() {
        let to = at(p.normal, p.tangential);
        canvas.line(from, to, |_| true);
        canvas.letter(
            (to.0 + 1.5 / columns.max(20) as f64, to.1),
            char::from_digit(i as u32 + 1, 36).unwrap_or('*'),
        );
        from = to;
    }
    framed(plane, &canvas, half, normal)
}

fn deciding_line(canvas: &mut Canvas, line: [f64; 3], (half, normal): (f64, f64), letter: char) {
    let [a, b, c] = line;
    let steps = 8 * canvas.columns.max(canvas.rows);
    let mut last = None;
    for k in 0..=steps {
        let s = k as f64 / steps as f64;
        // Walked along both axes: whichever the line crosses slowly leaves no holes.
        let (n, t) = (s * normal, (2.0 * s - 1.0) * half);
        for (n, t) in [(n, -(b * n + c) / a), (-(a * t + c) / b, t)] {
            let at = (n / normal, 0.5 * (1.0 - t / half));
            if k % 2 == 0 {
                canvas.line(at, at, |_| true);
            }
            if canvas.cell(at.0, at.1).is_some() {
                last = Some(at);
            }
        }
    }
    if let Some(at) = last {
        canvas.letter(at, letter);
    }
}

fn framed(plane: &ImpulsePlane, canvas: &Canvas, half: f64, normal: f64) -> String {
    let rows = canvas.text();
    let middle = rows.len() / 2;
    let mut out = String::from("p_t [N s]\n");
    for (i, row) in rows.iter().enumerate() {
        let tick = match i {
            0 => significant(half, 2),
            i if i == middle => "0".to_owned(),
            i if i + 1 == rows.len() => significant(-half, 2),
            _ => String::new(),
        };
        out += format!("{tick:>9} │{row}").trim_end();
        out.push('\n');
    }
    out += &format!("{:>9} └{}\n", "", "─".repeat(canvas.columns));
    let end = format!("p_n [N s] {}", significant(normal, 2));
    out += &format!("{:>11}{end:>width$}\n", "0", width = canvas.columns);
    out += "  cone dotted";
    if plane.operator.is_some() {
        out += ", S sticking u_t = 0, C maximum compression u_n = 0";
    }
    out.push('\n');
    for (i, p) in plane.points.iter().enumerate() {
        out += &format!("  {} {}\n", i + 1, p.label);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ImpulsePoint;
    use carom_impact::Phase;

    #[test]
    fn the_terminal_plane_keeps_its_size_and_names_its_lines() {
        let end =
            ImpulsePoint { normal: 0.3, tangential: 0.045, phase: Phase::Compression, label: "slips".into() };
        let plane = ImpulsePlane {
            operator: Some([10.0, 4.5, 6.2]),
            slip: -0.88,
            approach: -1.65,
            friction: 0.15,
            points: vec![end],
        };
        let text = impulse_text(&plane, 48, 12);
        assert_eq!(text.lines().count(), 1 + 12 + 2 + 1 + 1, "{text}");
        assert!(text.lines().all(|l| l.chars().count() <= 72), "{text}");
        assert!(text.contains('C') && text.contains('1'), "{text}");
        let nothing = ImpulsePlane { points: vec![], ..plane };
        assert_eq!(impulse_text(&nothing, 48, 12), "", "no impulse");
    }
}
