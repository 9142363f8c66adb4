//! DXF files: pairs of a group code and a value, each on a line of its own.

use super::drawn::{Drawn, Fault};
use super::dxf_entity::{Entity, draw};
use crate::unit::{Dimension, Unit};
use std::collections::BTreeSet;

/// A group code and its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pair<'t> {
    pub(crate) code: i32,
    pub(crate) value: &'t str,
    /// Line of the code, from 1.
    pub(crate) line: usize,
}

/// `$INSUNITS` for the units that a scene may be written in.
const UNITS: [(i32, &str); 6] = [(1, "in"), (2, "ft"), (4, "mm"), (5, "cm"), (6, "m"), (13, "um")];

/// Reads what a DXF text draws on a layer, or on all of them; `unit` decides where the file's header does not.
///
/// # Errors
/// Everything that could not be read, with its line.
///
/// # Source
/// Autodesk, *DXF Reference*: group codes, `$INSUNITS`, the object coordinate system.
pub(crate) fn read_dxf(text: &str, unit: Option<Unit>, layer: Option<&str>) -> Result<Drawn, Vec<Fault>> {
    if text.starts_with("AutoCAD Binary DXF") {
        let fault = Fault::unsupported(None, "is a binary DXF file: save it as text (ASCII DXF)");
        return Err(vec![fault]);
    }
    let pairs = pairs(text).map_err(|fault| vec![fault])?;
    let (unit, said) = unit_of(&pairs, unit).map_err(|fault| vec![fault])?;
    let Some(entities) = section(&pairs, "ENTITIES") else {
        return Err(vec![Fault::new(None, "has no ENTITIES section: it draws nothing")]);
    };
    let mut drawn = Drawn { unit: said, ..Drawn::default() };
    let wanted = Wanted { layer: layer.map(str::to_lowercase), hidden: hidden_layers(&pairs) };
    let faults = read_entities(&entities_of(entities), unit, &wanted, &mut drawn);
    if faults.is_empty() { Ok(drawn) } else { Err(faults) }
}

fn pairs(text: &str) -> Result<Vec<Pair<'_>>, Fault> {
    let mut found = vec![];
    let mut lines = text.lines().enumerate();
    while let Some((at, code)) = lines.next() {
        let line = at + 1;
        let broken = || Fault::file(line, "the file breaks off: there is no EOF");
        if code.trim().is_empty() && lines.clone().all(|(_, rest)| rest.trim().is_empty()) {
            return Err(broken());
        }
        let Ok(code) = code.trim().parse() else {
            let text = format!("expected a group code, a whole number, found \"{}\"", code.trim());
            return Err(Fault::file(line, text));
        };
        let Some((_, value)) = lines.next() else { return Err(broken()) };
        found.push(Pair { code, value: value.trim(), line });
        if (code, value.trim()) == (0, "EOF") {
            return Ok(found);
        }
    }
    Err(Fault::file(None, "the file breaks off: there is no EOF"))
}

/// The pairs of a section, without those that open and close it.
fn section<'p, 't>(pairs: &'p [Pair<'t>], name: &str) -> Option<&'p [Pair<'t>]> {
    let opens = |two: &[Pair<'_>]| {
        (two[0].code, two[0].value) == (0, "SECTION") && (two[1].code, two[1].value) == (2, name)
    };
    let start = pairs.windows(2).position(opens)? + 2;
    let end = pairs[start..].iter().position(|pair| (pair.code, pair.value) == (0, "ENDSEC"));
    Some(&pairs[start..end.map_or(pairs.len(), |end| start + end)])
}

/// The unit and how it is known.
fn unit_of(pairs: &[Pair<'_>], wanted: Option<Unit>) -> Result<(Unit, String), Fault> {
    let header = section(pairs, "HEADER").unwrap_or_default();
    let at = header.iter().position(|pair| (pair.code, pair.value) == (9, "$INSUNITS"));
    let written = at.and_then(|at| header.get(at + 1));
    let number: i32 = written.and_then(|pair| pair.value.parse().ok()).unwrap_or(0);
    let symbol = UNITS.iter().find(|(known, _)| *known == number).map(|(_, symbol)| *symbol);
    let line = written.map(|pair| pair.line + 1);
    let known = symbol.and_then(|symbol| Dimension::Length.unit(symbol));
    match (known, wanted) {
        (Some(unit), Some(wanted)) if wanted != unit => {
            let text = format!("$INSUNITS says {}, but the scene's unit is {}", unit.symbol, wanted.symbol);
            Err(Fault::new(line, text)
                .with_help("leave `unit` out; if the file is wrong about itself, `scale` puts it right"))
        }
        (Some(unit), _) => Ok((unit, format!("unit {}, from the file", unit.symbol))),
        (None, _) if number != 0 => {
            let text = format!(
                "$INSUNITS is {number}, which is none of 1 (in), 2 (ft), 4 (mm), 5 (cm), 6 (m) and 13 (um)"
            );
            Err(Fault::unsupported(line, text))
        }
        (None, Some(wanted)) => Ok((wanted, format!("unit {}, from the scene", wanted.symbol))),
        (None, None) => {
            let text = "does not say its unit: $INSUNITS is 0 or missing";
            Err(Fault::new(line, text).with_help("write the unit beside the file: unit = \"mm\""))
        }
    }
}

/// Entities, each from its name to the next.
fn entities_of<'p, 't>(pairs: &'p [Pair<'t>]) -> Vec<Entity<'p, 't>> {
    let starts: Vec<usize> = (0..pairs.len()).filter(|i| pairs[*i].code == 0).collect();
    let ends = starts.iter().skip(1).copied().chain([pairs.len()]);
    let entity = |(start, end): (&usize, usize)| Entity {
        name: pairs[*start].value,
        line: pairs[*start].line + 1,
        pairs: &pairs[*start + 1..end],
    };
    starts.iter().zip(ends).map(entity).collect()
}

/// Layers, in small letters: their names do not tell capital letters from small ones.
struct Wanted {
    /// The only one that is read, be it visible or not.
    layer: Option<String>,
    /// Those that are switched off or frozen.
    hidden: BTreeSet<String>,
}

impl Wanted {
    fn holds(&self, layer: &str) -> bool {
        let layer = layer.to_lowercase();
        self.layer.as_ref().map_or_else(|| !self.hidden.contains(&layer), |wanted| *wanted == layer)
    }
}

/// The layers that the file's tables switch off (a colour below 0) or freeze (flag 1).
fn hidden_layers(pairs: &[Pair<'_>]) -> BTreeSet<String> {
    let tables = entities_of(section(pairs, "TABLES").unwrap_or_default());
    let number = |table: &Entity<'_, '_>, code| -> i32 {
        table.text(code).and_then(|pair| pair.value.parse().ok()).unwrap_or(0)
    };
    let hidden = |table: &&Entity<'_, '_>| {
        table.name == "LAYER" && (number(table, 62) < 0 || number(table, 70) & 1 == 1)
    };
    tables.iter().filter(hidden).filter_map(|table| Some(table.text(2)?.value.to_lowercase())).collect()
}

fn read_entities(entities: &[Entity<'_, '_>], unit: Unit, wanted: &Wanted, drawn: &mut Drawn) -> Vec<Fault> {
    let mut faults = vec![];
    let mut layers = BTreeSet::new();
    let mut asked = false;
    let mut rest = entities;
    while let Some((entity, after)) = rest.split_first() {
        // The corners of an old polyline follow it as entities of their own.
        let follows = after.iter().take_while(|next| next.name == "VERTEX").count();
        let (corners, after) = after.split_at(follows);
        rest = after;
        if entity.name == "SEQEND" || entity.is_hidden() {
            continue;
        }
        layers.insert(entity.layer());
        if !wanted.holds(entity.layer()) {
            continue;
        }
        asked = true;
        faults.extend(draw(entity, corners, unit, drawn).err());
    }
    if let (Some(layer), false) = (&wanted.layer, asked) {
        let names: Vec<String> = layers.iter().map(|name| format!("\"{name}\"")).collect();
        let known = if names.is_empty() { "the file draws nothing".to_owned() } else { names.join(", ") };
        faults.push(Fault::new(None, format!("nothing is drawn on layer \"{layer}\"; its layers: {known}")));
    }
    faults
}
