//! `shape = "bolt"` and its kin: parts that are known by their name and their dimensions.

use crate::chain::read_chain;
use crate::drawing::ShapeWord;
use crate::grammar::Section;
use crate::grammar::kind::{CHAMFER, LENGTH, LENGTH_OR_NONE};
use crate::library::{
    Bolt, Bracket, Cap, HeadWord, LibraryPart, PIN_CHAMFER, Pin, PinEnds, Revolved, Size, Washer, bolt_row,
    pin_row, read_size, washer_row,
};
use crate::problem::ProblemKind;
use crate::quantity::{Kind, Quantity};
use crate::unit::Dimension;
use std::f64::consts::FRAC_PI_4;

/// Reads the dimensions of a part of the library.
pub(crate) fn read_library(section: &Section<'_>, shape: ShapeWord) -> Option<LibraryPart> {
    match shape {
        ShapeWord::Bolt => read_bolt(section).map(LibraryPart::Bolt),
        ShapeWord::Washer => read_washer(section).map(LibraryPart::Washer),
        ShapeWord::Pin => read_pin(section).map(LibraryPart::Pin),
        ShapeWord::Cap => read_cap(section).map(LibraryPart::Cap),
        ShapeWord::Bracket => read_bracket(section).map(LibraryPart::Bracket),
        ShapeWord::Revolved => {
            let profile = read_chain(section, "profile", false);
            let bore = section.has("bore").then(|| read_chain(section, "bore", false));
            let bore = bore.map_or(Some(None), |bore| bore.map(Some));
            Some(LibraryPart::Revolved(Revolved { profile: profile?, bore: bore? }))
        }
        _ => None,
    }
}

/// A number of a standard, in mm.
fn millimetres(value: f64, kind: Kind) -> Quantity {
    let unit = Dimension::Length.unit("mm");
    Quantity::default_of(unit.map_or(value, |unit| unit.to_si(value)), kind)
}

/// A dimension that is written, or else that of the standard [mm].
fn or_standard(section: &Section<'_>, key: &str, standard: Option<f64>, kind: Kind) -> Option<Quantity> {
    if section.has(key) {
        return section.quantity(key);
    }
    standard.map(|value| millimetres(value, kind))
}

/// A size that is written: what it says, and what the standard says of it. `None` where there is no good one.
fn sized<T>(
    section: &Section<'_>,
    thread: bool,
    of: impl Fn(f64) -> Result<T, String>,
    standard: &str,
) -> Option<(Size, T)> {
    let (text, _) = section.text("size")?;
    let example = match (thread, standard) {
        (true, "ISO 7089") => "\"M8\"",
        (true, _) => "\"M8 x 30\"",
        _ => "\"8 x 30\"",
    };
    let wrong = |message: String| {
        section.blame_value(ProblemKind::Quantity, "size", message);
        None
    };
    let Some(size) = read_size(text, thread) else {
        return wrong(format!("\"{text}\" is no size: write {example}"));
    };
    match of(size.diameter) {
        Ok(row) => Some((size, row)),
        Err(sizes) => wrong(format!("\"{text}\" is no size of {standard}, which has {sizes}")),
    }
}

/// The length that a size or the key `length` gives, and not both.
fn length_of(section: &Section<'_>, size: Option<Size>) -> Option<Quantity> {
    let in_size = size.and_then(|size| size.length);
    if section.has("length") && in_size.is_some() {
        section.blame(ProblemKind::Conflict, "length", "the size has a length already: keep one of the two");
        return None;
    }
    if size.is_some() && !section.has("length") && in_size.is_none() {
        let message = "has no length: add it, as in \"M8 x 30\", or write length beside it";
        section.blame_value(ProblemKind::Quantity, "size", message);
    }
    let length = or_standard(section, "length", in_size, LENGTH)?;
    if LENGTH.holds(length.value) {
        return Some(length);
    }
    let message = format!("{}: it {}", LENGTH.dimension.show(length.value), LENGTH.rule_for(length.value));
    section.blame_value(ProblemKind::OutOfRange, "size", message);
    None
}

fn read_bolt(section: &Section<'_>) -> Option<Bolt> {
    let head: HeadWord = section.word_or_default("head");
    let standard = match head {
        HeadWord::Hexagon => "ISO 4017",
        HeadWord::Socket => "ISO 4762",
    };
    let found = sized(section, true, bolt_row, standard);
    if section.has("size") && found.is_none() {
        return None;
    }
    let (size, row) = found.unzip();
    let [width, height] = match head {
        HeadWord::Hexagon => [row.map(|row| row.hexagon_width), row.map(|row| row.hexagon_height)],
        // k = d
        HeadWord::Socket => [row.map(|row| row.cylinder_width), row.map(|row| row.diameter)],
    };
    let length = length_of(section, size);
    let socket = (head == HeadWord::Socket).then(|| {
        let width = or_standard(section, "socket_width", row.map(|row| row.socket_width), LENGTH);
        let depth = or_standard(section, "socket_depth", row.map(|row| row.socket_depth), LENGTH);
        width.zip(depth)
    });
    let called = section.text("size").map(|(text, _)| format!("{text} ({standard})"));
    Some(Bolt {
        head,
        called,
        diameter: or_standard(section, "diameter", row.map(|row| row.diameter), LENGTH)?,
        length: length?,
        head_width: or_standard(section, "head_width", width, LENGTH)?,
        head_height: or_standard(section, "head_height", height, LENGTH)?,
        pitch: or_standard(section, "pitch", row.map(|row| row.pitch), LENGTH),
        thread_length: section.quantity("thread_length"),
        socket: socket.flatten(),
    })
}

fn read_washer(section: &Section<'_>) -> Option<Washer> {
    let found = sized(section, true, washer_row, "ISO 7089");
    if let Some((Size { length: Some(_), .. }, _)) = found {
        section.blame_value(ProblemKind::Quantity, "size", "a washer has no length: write \"M8\"");
        return None;
    }
    if section.has("size") && found.is_none() {
        return None;
    }
    let of = |i: usize| found.map(|(_, row)| row[i]);
    let called = section.text("size").map(|(text, _)| format!("{text} (ISO 7089)"));
    Some(Washer {
        called,
        inner_diameter: or_standard(section, "inner_diameter", of(0), LENGTH_OR_NONE)?,
        outer_diameter: or_standard(section, "outer_diameter", of(1), LENGTH)?,
        thickness: or_standard(section, "thickness", of(2), LENGTH)?,
    })
}

fn read_pin(section: &Section<'_>) -> Option<Pin> {
    let found = sized(section, false, pin_row, "ISO 2338");
    if section.has("size") && found.is_none() {
        return None;
    }
    let (size, standard) = found.unzip();
    let ends = if section.has("corner_radius") {
        section.quantity("corner_radius").map(|radius| PinEnds::Rounded { radius })
    } else if let Some(chamfer) = or_standard(section, "chamfer", standard, LENGTH_OR_NONE) {
        // Whoever writes a chamfer alone means one of 45°; the standard's lean less.
        let angle = if section.has("chamfer") { FRAC_PI_4 } else { PIN_CHAMFER.to_radians() };
        let angle = if section.has("chamfer_angle") {
            section.quantity("chamfer_angle")
        } else {
            Some(Quantity::default_of(angle, CHAMFER))
        };
        angle.map(|angle| PinEnds::Chamfered { chamfer, angle })
    } else if section.has("chamfer_angle") {
        section.blame(ProblemKind::Conflict, "chamfer_angle", "goes with chamfer, which is missing");
        None
    } else {
        Some(PinEnds::Sharp)
    };
    let length = length_of(section, size);
    let called = section.text("size").map(|(text, _)| format!("{text} (ISO 2338)"));
    let diameter = or_standard(section, "diameter", size.map(|size| size.diameter), LENGTH);
    Some(Pin { called, diameter: diameter?, length: length?, ends: ends? })
}

fn read_cap(section: &Section<'_>) -> Option<Cap> {
    Some(Cap {
        diameter: section.quantity("diameter")?,
        height: section.quantity("height")?,
        wall: section.quantity("wall")?,
        base: section.quantity("base"),
        corner_radius: section.quantity("corner_radius"),
    })
}

fn read_bracket(section: &Section<'_>) -> Option<Bracket> {
    Some(Bracket {
        legs: section.vector("legs")?,
        thickness: section.quantity("thickness")?,
        inner_radius: section.quantity_or_default("inner_radius")?,
        outer_radius: section.quantity_or_default("outer_radius")?,
    })
}
