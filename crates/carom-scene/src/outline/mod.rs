//! Outlines from DXF and SVG files.
//!
//! A file becomes edges ([`dxf`], [`svg`]), edges become loops ([`loops`]), loops one outline with its holes ([`nesting`]).
//! The engine is given the outline as a chain of arcs and segments ([`chain`]); the mass is the outline's own, its holes left out ([`moments`],
//! [`body`]).

mod body;
mod chain;
mod drawn;
mod dxf;
mod dxf_entity;
mod edge;
mod loops;
mod moments;
mod nesting;
mod spline;
mod svg;
mod svg_shape;
mod xml_entities;

pub(crate) use body::{Solid, first_face, starting_point};
pub(crate) use drawn::Fault;

use crate::input::{Beside, Files};
use crate::tolerance::{CHORD, FINEST_CHORD, OUTLINE_ROUNDING, SMALLEST_OUTLINE};
use crate::unit::Unit;
use carom_num::Vec2;
use drawn::{Drawn, length, shortened};
use nesting::Nest;
use std::path::Path;
use std::sync::Arc;

/// The coarsest.
const COARSEST: f64 = 0.1;
const LARGEST: f64 = 1e4;
/// Loops are told apart on chords this much nearer to the curves than those of the part may be.
const FINER: f64 = 16.0;
/// Most edges of an outline.
const MOST_EDGES: usize = 20_000;

/// Most points on its curves.
const MOST_POINTS: usize = 1_000_000;

/// An outline as a file has it, in its own size.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FileOutline {
    /// The file's name, as the scene has it.
    file: String,
    /// Shared: a study lays out a scene thousands of times.
    nest: Arc<Nest>,
    /// The longer side of the upright rectangle around it [m].
    size: f64,
    /// How far chords may be from curves [m].
    chord: f64,
    /// What a reader should know about the way it was read.
    said: String,
    /// True where the file counts y downwards.
    y_down: bool,
}

impl FileOutline {
    /// The file's name, as the scene has it.
    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// A point in the file's own axes, y up.
    pub(crate) fn upright(&self, [x, y]: [f64; 2]) -> Vec2 {
        Vec2::new(x, if self.y_down { -y } else { y })
    }
}

/// What a scene says beside the file's name.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Reading<'s> {
    /// Unit of a file that does not give its own.
    pub(crate) unit: Option<Unit>,
    /// The only layer that is read.
    pub(crate) layer: Option<&'s str>,
    /// How far chords may be from curves, and ends from each other, in the file's own size [m].
    pub(crate) chord: Option<f64>,
}

/// Reads an outline; `name` is what the scene calls the file.
///
/// # Errors
/// Everything that is wrong with the file.
pub(crate) fn read(beside: Beside<'_>, name: &str, reading: &Reading<'_>) -> Result<FileOutline, Vec<Fault>> {
    let path = beside.folder.join(name);
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let format = match ending.as_deref() {
        Some("dxf") => Format::Dxf,
        Some("svg") => Format::Svg,
        _ => {
            let text = "is neither .dxf nor .svg: only these are read";
            return Err(vec![Fault::unsupported(None, text)]);
        }
    };
    outline_of(&text_of(&path, beside.files)?, format, name, reading).map_err(shortened)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Dxf,
    Svg,
}

fn text_of(path: &Path, files: &dyn Files) -> Result<String, Vec<Fault>> {
    let fault = |error: &std::io::Error| {
        let text = match error.kind() {
            std::io::ErrorKind::NotFound => "there is no such file beside the scene".to_owned(),
            _ => error.to_string(),
        };
        vec![Fault::file(None, text)]
    };
    let bytes = files.bytes(path).map_err(|error| match error.kind() {
        std::io::ErrorKind::FileTooLarge => vec![Fault::unsupported(None, error.to_string())],
        _ => fault(&error),
    })?;
    // Old drawings have texts in other encodings; numbers and names of entities are the same in all of them.
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn outline_of(
    text: &str,
    format: Format,
    name: &str,
    reading: &Reading<'_>,
) -> Result<FileOutline, Vec<Fault>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let drawn = match (format, reading.layer) {
        (Format::Dxf, layer) => dxf::read_dxf(text, reading.unit, layer)?,
        (Format::Svg, None) => svg::read_svg(text, reading.unit)?,
        (Format::Svg, Some(_)) => {
            let fault = Fault::unsupported(None, "`layer` is for DXF files: an SVG file is read as a whole");
            return Err(vec![fault]);
        }
    };
    joined(drawn, name, reading).map(|outline| FileOutline { y_down: format == Format::Svg, ..outline })
}

fn joined(drawn: Drawn, name: &str, reading: &Reading<'_>) -> Result<FileOutline, Vec<Fault>> {
    let (size, edges) = (drawn.size(), drawn.pieces.iter().map(|piece| piece.edges.len()).sum::<usize>());
    let passed: Vec<String> =
        drawn.passed_over.iter().map(|(name, count)| format!("{count} {name}")).collect();
    if edges == 0 || size == 0.0 {
        let and = if passed.is_empty() { String::new() } else { format!(", only {}", passed.join(", ")) };
        return Err(vec![Fault::new(None, format!("draws no outline{and}"))]);
    }
    if !(SMALLEST_OUTLINE..=LARGEST).contains(&size) {
        let text = format!(
            "is {} large: outlines are read from {} to {}",
            length(size),
            length(SMALLEST_OUTLINE),
            length(LARGEST)
        );
        return Err(vec![Fault::new(None, text).with_help("is its unit right?")]);
    }
    if edges > MOST_EDGES {
        let text = format!("draws {edges} edges: an outline has at most {MOST_EDGES}");
        return Err(vec![Fault::unsupported(None, text)]);
    }
    let chord = reading.chord.unwrap_or(CHORD * size);
    if !(FINEST_CHORD * size..=COARSEST * size).contains(&chord) {
        let text = format!(
            "is {} large, so `chord` may be from {} to {}",
            length(size),
            length(FINEST_CHORD * size),
            length(COARSEST * size)
        );
        return Err(vec![Fault::new(None, text)]);
    }
    // Whatever chord is asked for, loops are told apart on chords that are finer than those of the part.
    let within = chord.min(CHORD * size) / FINER;
    let points: usize =
        drawn.pieces.iter().flat_map(|piece| &piece.edges).map(|edge| edge.chords(1.0, within)).sum();
    if points > MOST_POINTS {
        let text = format!("needs {points} points for chords of {}: at most {MOST_POINTS}", length(chord));
        return Err(vec![Fault::unsupported(None, text)]);
    }
    let joined = loops::join(drawn.pieces, size, chord)?;
    let nest = nesting::nest(joined.loops, size, within)?;
    let mut said = drawn.unit;
    if joined.widest_gap > OUTLINE_ROUNDING * size {
        said += &format!("; gaps up to {} are closed", length(joined.widest_gap));
    }
    if !passed.is_empty() {
        said += &format!("; passed over: {}", passed.join(", "));
    }
    let size = drawn::size_of(nest.outer.edges.iter());
    Ok(FileOutline { file: name.to_owned(), nest: Arc::new(nest), size, chord, said, y_down: false })
}

#[cfg(test)]
mod tests;
