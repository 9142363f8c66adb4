//! Readers, masses and chains against computations by other means.

mod chains;
mod masses;
mod notations;
mod vectors;

use super::*;
use carom_num::Vec2;
use std::fmt::Write;

/// A DXF text: one entity a line, as its name and pairs of code and value.
fn dxf(unit: i32, entities: &[&str]) -> String {
    let mut text =
        format!("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{unit}\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
    for entity in entities {
        let mut words = entity.split_whitespace();
        write!(text, "0\n{}\n", words.next().unwrap()).unwrap();
        for word in words {
            writeln!(text, "{word}").unwrap();
        }
    }
    text + "0\nENDSEC\n0\nEOF\n"
}

fn read_text(text: &str, format: Format, reading: &Reading<'_>) -> FileOutline {
    outline_of(text, format, "drawn", reading).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"))
}

/// An outline of metres.
fn drawn(entities: &[&str]) -> FileOutline {
    read_text(&dxf(6, entities), Format::Dxf, &Reading::default())
}

/// What is wrong with a drawing in metres.
fn faults(entities: &[&str]) -> Vec<String> {
    let faults = outline_of(&dxf(6, entities), Format::Dxf, "drawn", &Reading::default()).unwrap_err();
    faults.into_iter().map(|fault| fault.text).collect()
}

/// What an SVG text draws, one user unit to the metre.
fn svg(text: &str) -> FileOutline {
    let unit = crate::unit::Dimension::Length.unit("m");
    let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{text}</svg>");
    read_text(&text, Format::Svg, &Reading { unit, ..Reading::default() })
}

fn solid(outline: &FileOutline) -> body::Solid {
    outline.solid(1.0).unwrap()
}

/// Within so many parts in 10¹² of 1 or of the expected number: some thousand operations, each rounded.
fn close(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-12 * (1.0 + expected.abs()), "{what}: {found} is not {expected}");
}

fn close_to(found: Vec2, expected: Vec2, what: &str) {
    close(found.x, expected.x, what);
    close(found.y, expected.y, what);
}
