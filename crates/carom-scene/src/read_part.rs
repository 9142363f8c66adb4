//! `[part]`, `[contact]` and `[start]`.

use crate::drawing::{COORDINATE, LENGTH_OR_NONE};
use crate::drawing::{
    ContactDrawing, DENSITY, FACE, FRICTION, Heft, INERTIA, LENGTH, MASS, MassCentre, Outline, PartDrawing,
    RESTITUTION, SPEED, StartDrawing, Surface,
};
use crate::node::Value;
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::read_outline::read_outline_file;
use crate::section::{Section, expected, read_pair};
use carom_impact::planar::Law;
use std::path::Path;

#[derive(Clone, Copy)]
enum Word {
    Rod,
    Box,
    Polygon,
    Disc,
    Outline,
}

const SHAPES: [(&str, Word); 5] = [
    ("rod", Word::Rod),
    ("box", Word::Box),
    ("polygon", Word::Polygon),
    ("disc", Word::Disc),
    ("outline", Word::Outline),
];

/// Reads `[part]`; the file of an outline is looked for from `folder`.
pub(crate) fn read_part(root: &Section<'_>, folder: &Path) -> Option<PartDrawing> {
    if !root.has("part") {
        root.missing("part", "a table [part] with the part's shape and mass");
        return None;
    }
    let section = root.section("part")?;
    if !section.has("shape") {
        section.missing("shape", "rod, box, polygon, disc or outline");
    }
    let span = section.key_span("shape");
    let word = section.word("shape", &SHAPES);
    // A shape that is not known says nothing about which keys belong to it.
    let Some(word) = word else {
        for key in ["length", "height", "radius", "vertices", "file", "unit", "layer", "scale", "chord"] {
            section.get(key);
        }
        read_heft(&section);
        section.quantity("inertia", INERTIA);
        section.pair("mass_centre", COORDINATE);
        section.quantity("corner_radius", LENGTH_OR_NONE);
        section.finish();
        return None;
    };
    let outline = read_outline(&section, word, folder);
    let heft = read_heft(&section);
    let inertia = section.quantity("inertia", INERTIA).filter(|_| heft.is_some());
    // A part without a good mass has its problem; its outline can still be judged, with any mass.
    let heft = heft.unwrap_or_else(|| Heft::Mass(Quantity::default_of(1.0, MASS)));
    let corner_radius = match word {
        // A file draws its round corners itself.
        Word::Disc | Word::Outline => None,
        Word::Rod | Word::Box | Word::Polygon => section.quantity("corner_radius", LENGTH_OR_NONE),
    };
    let at = section.pair("mass_centre", COORDINATE);
    let mass_centre = at.map(|at| MassCentre { at, span: section.key_span("mass_centre") });
    section.finish();
    Some(PartDrawing { outline: outline?, mass_centre, corner_radius, heft, inertia, span })
}

fn read_outline(section: &Section<'_>, word: Word, folder: &Path) -> Option<Outline> {
    match word {
        Word::Rod => Some(Outline::Rod { length: section.required("length", LENGTH)? }),
        Word::Box => {
            let (length, height) = (section.required("length", LENGTH), section.required("height", LENGTH));
            Some(Outline::Box { length: length?, height: height? })
        }
        Word::Disc => Some(Outline::Disc { radius: section.required("radius", LENGTH)? }),
        Word::Polygon => read_vertices(section),
        Word::Outline => read_outline_file(section, folder),
    }
}

fn read_vertices(section: &Section<'_>) -> Option<Outline> {
    if !section.has("vertices") {
        section.missing("vertices", "a list of corners, [[\"0 mm\", \"0 mm\"], ...]");
        return None;
    }
    let node = section.get("vertices")?;
    let path = section.path_of("vertices");
    let Value::List(items) = &node.value else {
        section.sink().push(expected("a list of corners [[x, y], ...]", &path, node));
        return None;
    };
    let pairs = items.iter().enumerate();
    let vertices: Vec<Option<[Quantity; 2]>> =
        pairs.map(|(i, item)| read_pair(&format!("{path}.{i}"), item, COORDINATE, section.sink())).collect();
    if vertices.len() < 3 {
        let message = format!("a polygon has at least 3 corners, found {}", vertices.len());
        let problem = Problem::new(ProblemKind::Geometry, path, message, Some(node.span.clone()));
        section.sink().push(problem.with_help("two points are a rod: shape = \"rod\", length = ..."));
        return None;
    }
    Some(Outline::Polygon { vertices: vertices.into_iter().collect::<Option<_>>()? })
}

fn read_heft(section: &Section<'_>) -> Option<Heft> {
    if section.has("mass") {
        if section.has("density") {
            let message = "both mass and density are given: keep one";
            let span = Some(section.key_span("density"));
            section.sink().push(Problem::new(
                ProblemKind::Conflict,
                section.path_of("density"),
                message,
                span,
            ));
            section.get("density");
        }
        // The depth is then only for pictures.
        section.quantity("depth", LENGTH);
        return Some(Heft::Mass(section.quantity("mass", MASS)?));
    }
    section.get("mass");
    if section.has("density") {
        let (density, depth) = (section.required("density", DENSITY), section.required("depth", LENGTH));
        return Some(Heft::Density { density: density?, depth: depth? });
    }
    section.quantity("depth", LENGTH);
    section.get("density");
    section.missing("mass", "a mass in kg, or density with depth");
    None
}

const LAWS: [(&str, Law); 3] =
    [("poisson", Law::Poisson), ("stronge", Law::Stronge), ("newton", Law::Newton)];

/// Reads `law`, Poisson's where there is none.
pub(crate) fn read_law(section: &Section<'_>) -> Law {
    section.word("law", &LAWS).unwrap_or_default()
}

/// Reads `[contact]`. Its friction is needed only where a surface has none of its own.
pub(crate) fn read_contact(root: &Section<'_>) -> ContactDrawing {
    let none = || Quantity::default_of(0.0, RESTITUTION);
    let Some(section) = root.section("contact") else {
        return ContactDrawing {
            friction: None,
            friction_written: false,
            restitution: none(),
            law: Law::default(),
        };
    };
    let friction_written = section.has("friction");
    let friction = section.quantity("friction", FRICTION);
    let restitution = section.quantity("restitution", RESTITUTION).unwrap_or_else(none);
    let law = read_law(&section);
    section.finish();
    ContactDrawing { friction, friction_written, restitution, law }
}

/// Reads a surface's own friction and restitution.
pub(crate) fn read_surface(section: &Section<'_>) -> Surface {
    Surface {
        friction: section.quantity("friction", FRICTION),
        restitution: section.quantity("restitution", RESTITUTION),
    }
}

/// Reads `[start]`.
pub(crate) fn read_start(root: &Section<'_>) -> Option<StartDrawing> {
    if !root.has("start") {
        root.missing("start", "a table [start] with to_edge, from the mass centre to the free edge");
        return None;
    }
    let section = root.section("start")?;
    let to_edge = section.required("to_edge", LENGTH_OR_NONE);
    let speed = section.quantity("speed", SPEED).unwrap_or_else(|| Quantity::default_of(0.0, SPEED));
    let face = section.quantity("face", FACE);
    let face_span = face.as_ref().and_then(|face| face.span.clone());
    section.finish();
    Some(StartDrawing {
        to_edge: to_edge?,
        speed,
        face: face.map_or(0, |face| face.value as usize),
        face_span,
    })
}
