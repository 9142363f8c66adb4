//! What happens in a feed at which interval, as strips along one axis.

use crate::FIGURE_CSS;
use crate::markup::{Markup, document, html, joined};
use crate::regions::{REGIONS_CSS, tick};
use crate::regions_legend::wrapped;
use crate::svg::{self, line, text};
use crate::text::px;
use crate::ticks::ticks;

/// Size of a strip [px], and where the first one lies.
const WIDTH: f64 = 700.0;
const LEFT: f64 = 96.0;
const RIGHT: f64 = 24.0;
const TOP: f64 = 92.0;
const HIGH: f64 = 64.0;
/// Height of a part's strip, and the room between two.
const LOW: f64 = 16.0;
const BETWEEN: f64 = 6.0;
/// Parts that get a strip of their own at most.
const MOST_PARTS: usize = 12;
/// Letters of a line under the title.
const SUBTITLE: usize = 130;
/// Height of a line of the legend.
const LINE: f64 = 18.0;

/// Slanted lines over what is not known.
fn hatch() -> Markup {
    html! {
        defs {
            pattern id="hatch" width="5" height="5" patternUnits="userSpaceOnUse" patternTransform="rotate(45)" {
                line.axis x1="0" y1="0" x2="0" y2="5" {}
            }
        }
    }
}

/// How a stretch is filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IntervalFill {
    /// As it should be.
    Good,
    /// Not as it should be, and no harm is done.
    Fair,
    /// Harm is done.
    Bad,
    /// A part does not even start.
    Blocked,
    /// It is not known.
    Unknown,
}

impl IntervalFill {
    fn class(self) -> &'static str {
        match self {
            Self::Good => "r2",
            Self::Fair => "r5",
            Self::Bad => "r15",
            Self::Blocked => "r9",
            Self::Unknown => "r3",
        }
    }

    /// A filled rectangle; what is not known is hatched.
    fn rect(self, more: &str, at: [f64; 2], size: [f64; 2]) -> Markup {
        let [x, y, width, height] = [at[0], at[1], size[0], size[1]].map(px);
        html! {
            (svg::rect(&format!("region {}{more}", self.class()), at, size))
            @if self == Self::Unknown { rect fill="url(#hatch)" x=(x) y=(y) width=(width) height=(height) {} }
        }
    }
}

/// Intervals at which the same happens.
#[derive(Clone, Debug, PartialEq)]
pub struct IntervalPiece {
    /// The shortest of them [s].
    pub from: f64,
    /// The longest of them [s].
    pub to: f64,
    /// What happens to all parts.
    pub fill: IntervalFill,
    /// What becomes of each part.
    pub parts: Vec<IntervalFill>,
}

/// Strips to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct IntervalStrips {
    /// What it shows.
    pub title: String,
    /// More of it.
    pub subtitle: String,
    /// The end of the axis [s]; it begins at 0.
    pub to: f64,
    /// What happens, in order of the interval.
    pub pieces: Vec<IntervalPiece>,
    /// Intervals that are marked [s], with what they are.
    pub marks: Vec<(f64, String)>,
    /// What the fills mean, in the order of the legend.
    pub legend: Vec<(IntervalFill, String)>,
}

impl IntervalStrips {
    fn x(&self, interval: f64) -> f64 {
        LEFT + WIDTH * (interval / self.to).clamp(0.0, 1.0)
    }

    /// One strip, with neighbours of one fill drawn as one.
    fn strip(&self, top: f64, height: f64, fill: impl Fn(&IntervalPiece) -> Option<IntervalFill>) -> Markup {
        let mut runs: Vec<(f64, f64, IntervalFill)> = vec![];
        for (k, piece) in self.pieces.iter().enumerate() {
            let Some(fill) = fill(piece) else { continue };
            // A change is somewhere between two intervals that were followed.
            let before = k.checked_sub(1).and_then(|k| self.pieces.get(k)).map(|before| before.to);
            let after = self.pieces.get(k + 1).map(|after| after.from);
            let from = before.map_or(piece.from, |before| 0.5 * (before + piece.from));
            let to = after.map_or(piece.to, |after| 0.5 * (after + piece.to));
            match runs.last_mut() {
                Some(last) if last.2 == fill && last.1 == from => last.1 = to,
                _ => runs.push((from, to, fill)),
            }
        }
        let shown = runs.into_iter().filter(|(from, _, _)| *from < self.to);
        joined(shown.map(|(from, to, fill)| {
            let (left, right) = (self.x(from), self.x(to));
            fill.rect("", [left, top], [right - left, height])
        }))
    }

    /// The axis at the foot of the strips.
    fn axis(&self, floor: f64) -> Markup {
        let across = ticks(0.0, self.to, 8);
        let mut out = vec![line("axis", [LEFT, floor], [LEFT + WIDTH, floor])];
        for at in &across.at {
            let x = self.x(*at);
            out.push(line("axis", [x, floor], [x, floor + 4.0]));
            out.push(text("", [x, floor + 17.0], "middle", &tick(*at, across.decimals)));
        }
        out.push(text("name", [LEFT + WIDTH, floor + 36.0], "end", "interval  [s]"));
        joined(out)
    }

    fn marked(&self, floor: f64) -> Markup {
        let mut out: Vec<Markup> = vec![];
        for (k, (at, words)) in self.marks.iter().enumerate().filter(|(_, (at, _))| *at <= self.to) {
            let (x, y) = (self.x(*at), TOP - 8.0 - 14.0 * k as f64);
            out.push(line("boundary", [x, y + 2.0], [x, floor]));
            let anchor = if x > LEFT + 0.6 * WIDTH { "end" } else { "start" };
            out.push(text("key", [x, y - 2.0], anchor, words));
        }
        joined(out)
    }
}

/// Strips of a feed's intervals as a stand-alone SVG: what happens to all, what becomes of each part, marks, and a legend.
pub fn intervals_svg(strips: &IntervalStrips) -> String {
    let parts = strips.pieces.iter().map(|piece| piece.parts.len()).max().unwrap_or(0).min(MOST_PARTS);
    let floor = TOP + HIGH + BETWEEN + parts as f64 * (LOW + BETWEEN);
    let legend = floor + 58.0;
    let (width, height) = (LEFT + WIDTH + RIGHT, legend + LINE * strips.legend.len() as f64);
    let size = [width, height];
    let mut out = vec![svg::styled(size, &[FIGURE_CSS, REGIONS_CSS]), hatch()];
    out.push(text("title", [8.0, 20.0], "start", &strips.title));
    for (k, part) in wrapped(&strips.subtitle, SUBTITLE).iter().take(2).enumerate() {
        out.push(text("small", [8.0, 36.0 + 14.0 * k as f64], "start", part));
    }
    out.push(text("name", [LEFT - 8.0, TOP + 0.5 * HIGH + 4.0], "end", "all"));
    out.push(strips.strip(TOP, HIGH, |piece| Some(piece.fill)));
    for part in 0..parts {
        let top = TOP + HIGH + BETWEEN + part as f64 * (LOW + BETWEEN);
        out.push(text("", [LEFT - 8.0, top + 12.0], "end", &format!("part {}", part + 1)));
        out.push(strips.strip(top, LOW, |piece| piece.parts.get(part).copied()));
    }
    out.push(strips.axis(floor));
    out.push(strips.marked(floor));
    for (k, (fill, words)) in strips.legend.iter().enumerate() {
        let y = legend + LINE * k as f64;
        out.push(fill.rect(" swatch", [LEFT, y - 10.0], [14.0, 12.0]));
        out.push(text("key", [LEFT + 22.0, y], "start", words));
    }
    document(svg::drawing("fig", size, &strips.title, joined(out)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_of_one_fill_are_one_and_nothing_is_left_out() {
        let piece = |from, to, fill| IntervalPiece { from, to, fill, parts: vec![IntervalFill::Good, fill] };
        let strips = IntervalStrips {
            title: "a < b".to_owned(),
            subtitle: String::new(),
            to: 1.0,
            pieces: vec![
                piece(0.1, 0.2, IntervalFill::Bad),
                piece(0.2, 0.4, IntervalFill::Bad),
                piece(0.4, 3.0, IntervalFill::Good),
                piece(4.0, 5.0, IntervalFill::Unknown),
            ],
            marks: vec![(0.4, "here".to_owned()), (2.0, "beyond".to_owned())],
            legend: vec![
                (IntervalFill::Good, "good".to_owned()),
                (IntervalFill::Unknown, "unknown".to_owned()),
            ],
        };
        let svg = intervals_svg(&strips);
        let drawn = |class: &str| svg.matches(&format!("<rect class=\"region {class}\"")).count();
        assert_eq!((drawn("r15"), drawn("r2")), (2, 3), "{svg}");
        // From 0.1 to 0.4 of 700 px, from 96 px on; the next goes to the end of the axis.
        assert!(svg.contains("x=\"166\" y=\"92\" width=\"210\""), "{svg}");
        assert!(svg.contains("x=\"376\" y=\"92\" width=\"420\""), "{svg}");
        assert_eq!(svg.matches("url(#hatch)").count(), 1, "the swatch is hatched: {svg}");
        assert!(svg.contains("a &lt; b") && svg.contains("here") && !svg.contains("beyond"), "{svg}");
    }
}
