//! `shape = "outline"`: a part drawn in a file of its own.

use crate::drawing::Outline;
use crate::grammar::Section;
use crate::input::Beside;
use crate::outline::{self, Fault, Reading};
use crate::problem::Problem;
use crate::unit::{Dimension, Unit};
use std::ops::Range;

/// Reads `file` with `unit`, `layer`, `scale` and `chord`.
pub(crate) fn read_outline_file(section: &Section<'_>, beside: Beside<'_>) -> Option<Outline> {
    let file = section.text("file");
    let (unit, layer) = (read_unit(section), section.text("layer"));
    let scale = section.quantity("scale");
    let chord = section.quantity("chord");
    // A key with a problem leaves open how the file is to be read.
    let unread = |key, good: bool| section.has(key) && !good;
    if unread("unit", unit.is_some()) || unread("layer", layer.is_some()) || unread("scale", scale.is_some())
    {
        return None;
    }
    let scale = section.quantity_or_default("scale")?;
    let chord = chord.map(|chord| chord.value / scale.value);
    let (name, span) = file?;
    let layer = layer.map(|(layer, _)| layer);
    let reading = Reading { unit, layer, chord };
    match outline::read(beside, name, &reading) {
        Ok(drawn) => Some(Outline::File { drawn, scale }),
        Err(faults) => {
            for fault in faults {
                section.push(problem(section, name, &span, &fault));
            }
            None
        }
    }
}

fn problem(section: &Section<'_>, name: &str, span: &Range<usize>, fault: &Fault) -> Problem {
    let message = match fault.line {
        Some(line) => format!("{name}:{line}: {}", fault.text),
        None => format!("{name}: {}", fault.text),
    };
    let problem = Problem::new(fault.kind, section.path_of("file"), message, Some(span.clone()));
    match fault.help {
        Some(help) => problem.with_help(help),
        None => problem,
    }
}

fn read_unit(section: &Section<'_>) -> Option<Unit> {
    section.text("unit").and_then(|(symbol, _)| Dimension::Length.unit(symbol))
}
