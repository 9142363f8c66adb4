//! The legend of a region diagram.

use crate::markup::{Markup, joined};
use crate::regions::{LEGEND, LEGEND_WIDTH, RegionName};
use crate::svg::{self, text};
use crate::text::{fixed, px};
use crate::tolerance::LEAST_SHARE;

/// Letters of a line beside a number, and of one that has the whole width.
const LETTERS: usize = 32;
const WIDE: usize = 42;
const LINE: f64 = 15.0;

/// One label.
pub(crate) struct Entry {
    pub(crate) fill: usize,
    pub(crate) name: RegionName,
    pub(crate) area: f64,
}

/// A point of the plane that is marked.
pub(crate) fn cross([x, y]: [f64; 2]) -> Markup {
    let [left, up] = [x - 6.0, y - 6.0].map(px);
    svg::path("boundary here", &format!("M{left} {}h12M{} {up}v12", px(y), px(x)))
}

/// The legend from `top` down, and where it ends.
pub(crate) fn legend(
    entries: &[Entry],
    (curves_are, curves): (&str, &[&str]),
    (junctions, here): (bool, Option<&str>),
    (looked_for, top): (&str, f64),
) -> (Markup, f64) {
    let mut out: Vec<Markup> = vec![];
    let mut y = top + 10.0;
    for Entry { fill, name, area } in entries {
        let swatch = format!("region r{fill} swatch");
        out.push(svg::rect(&swatch, [LEGEND, y - 10.0], [14.0, 12.0]));
        let share =
            if *area < LEAST_SHARE { "<0.1 %".to_owned() } else { format!("{} %", fixed(100.0 * area, 1)) };
        out.push(text("small", [LEGEND + LEGEND_WIDTH - 8.0, y], "end", &share));
        let long = if name.long == name.short {
            name.long.clone()
        } else {
            format!("{}  {}", name.short, name.long)
        };
        // Beside the share there is less room than for what stands alone in its line.
        for part in wrapped(&long, LETTERS) {
            out.push(text("key", [LEGEND + 22.0, y], "start", &part));
            y += LINE;
        }
        y += 4.0;
    }
    y += 10.0;
    let mut stroke = |class: &str, words: &str, y: &mut f64| {
        out.push(svg::line(class, [LEGEND - 2.0, *y - 4.0], [LEGEND + 16.0, *y - 4.0]));
        for part in wrapped(words, WIDE) {
            out.push(text("key", [LEGEND + 22.0, *y], "start", &part));
            *y += LINE;
        }
    };
    stroke("boundary", "where the engine's outcome changes", &mut y);
    if !curves.is_empty() {
        stroke("closed-form", curves_are, &mut y);
        for curve in curves {
            for part in wrapped(curve, WIDE) {
                out.push(text("small", [LEGEND + 30.0, y], "start", &part));
                y += LINE;
            }
        }
    }
    if junctions {
        out.push(svg::circle("junction", [LEGEND + 7.0, y - 4.0], 3.6));
        out.push(text("key", [LEGEND + 22.0, y], "start", "where three or more meet"));
        y += LINE;
    }
    if let Some(here) = here {
        out.push(cross([LEGEND + 7.0, y - 4.0]));
        out.push(text("key", [LEGEND + 22.0, y], "start", here));
        y += LINE;
    }
    y += 6.0;
    for part in wrapped(looked_for, WIDE) {
        out.push(text("small", [LEGEND, y], "start", &part));
        y += LINE;
    }
    (joined(out), y)
}

/// A text in lines that fit.
pub(crate) fn wrapped(text: &str, letters: usize) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(last) if last.chars().count() + 1 + word.chars().count() <= letters => {
                last.push(' ');
                last.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_names_are_wrapped_between_words() {
        let lines = wrapped("front slips along the tangent, rear separates and stays off", LETTERS);
        assert!(lines.len() == 2 && lines.iter().all(|line| line.chars().count() <= LETTERS), "{lines:?}");
        assert_eq!(wrapped("short", LETTERS), ["short"], "one line");
    }
}
