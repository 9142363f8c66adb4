//! The grammar of a part, and of the chains of which parts and plates are drawn.

use super::kind::{COORDINATE, DENSITY, INERTIA, LENGTH, LENGTH_OR_NONE, MASS, SCALE};
use super::library::{BOLT_SIZE, FLAT, LIBRARY, PIN_ENDS, PIN_SIZE, SHAPES, SOCKET, WASHER_SIZE};
use super::scene::way;
use super::{Holds, Rule, Table, When, key};
use crate::drawing::{ShapeWord, Side};
use crate::unit::Dimension;
use carom_words::Words;

/// An arc of a chain.
static ARC: Table = Table {
    name: "Arc",
    about: "An arc between two points of a chain.",
    keys: &[&[
        key("through", Holds::Vector(COORDINATE, 2), "A point on the arc, between its ends."),
        key("centre", Holds::Vector(COORDINATE, 2), "The centre of the arc."),
        key("radius", Holds::Quantity(LENGTH), "Radius of the arc, which turns less than half round."),
        key("turn", Holds::Words(Side::words), "The side to which the arc turns, seen along the chain."),
    ]],
    rules: &[Rule {
        when: When::Always,
        ways: &[
            way(When::Has("through"), &[], &[]),
            way(When::Has("centre"), &["turn"], &[]),
            way(When::Has("radius"), &["turn"], &[]),
        ],
        missing: "through = [x, y], or centre or radius with turn = \"left\" or \"right\"",
        help: "",
    }],
    foreign: &[],
    inherited: &[],
};

/// Between two points of a chain: what leads from one to the other where that is no straight line.
static BEND: Table = Table::plain(
    "Bend",
    "What leads from one point of a chain to the next where that is no straight line.",
    &[&[key("arc", Holds::Table(&ARC), "An arc.").needed()]],
);

/// Points with arcs between them.
pub(super) const CHAIN: Holds = Holds::List {
    of: &Holds::Either(&[Holds::Vector(COORDINATE, 2), Holds::Table(&BEND)]),
    least: 2,
    most: usize::MAX,
    called: "a list of points [x, y], with arcs { arc = { ... } } between them",
};

pub(super) static PART: Table = Table {
    name: "Part",
    about: "The part: its shape and its mass.",
    keys: &[
        &[
            key("shape", Holds::Words(ShapeWord::words), "The shape of the part, seen from the side.")
                .needed(),
            key(
                "length",
                Holds::Quantity(LENGTH),
                "Length of a rod, a box, a pin, or of a bolt below its head.",
            ),
            key("height", Holds::Quantity(LENGTH), "Height of a box or a cap."),
            key("radius", Holds::Quantity(LENGTH), "Radius of a disc."),
            key(
                "vertices",
                Holds::List {
                    of: &Holds::Vector(COORDINATE, 2),
                    least: 3,
                    most: usize::MAX,
                    called: "a list of corners [[x, y], ...]",
                },
                "Corners of a polygon, one after the other.",
            ),
            key(
                "points",
                CHAIN,
                "Points of a chain, one after the other, with an arc between two of them where the outline is bent there. It is closed from the last to the first.",
            ),
            key(
                "file",
                Holds::Text,
                "A DXF or SVG file that draws the outline, looked for from the scene's folder.",
            )
            .if_missing("a DXF or SVG file that draws the outline, file = \"bracket.dxf\""),
            key(
                "unit",
                Holds::Words(length_units),
                "Unit of lengths in an outline's file, where the file does not say it.",
            ),
            key(
                "layer",
                Holds::Text,
                "The only layer of a DXF file that is read; every visible one where it is left out.",
            ),
            key("scale", Holds::Quantity(SCALE), "All lengths of the outline's file are multiplied by it.")
                .or(1.0),
            key(
                "chord",
                Holds::Quantity(LENGTH),
                "How far chords may be from curves of the outline, and ends that are joined from each other; a thousandth of the size where it is left out.",
            ),
            key(
                "corner_radius",
                Holds::Quantity(LENGTH_OR_NONE),
                "Rounds the corners; the straight sides stay where they are drawn.",
            ),
            key("mass", Holds::Quantity(MASS), "Mass of the part. Or write density and depth."),
            key(
                "density",
                Holds::Quantity(DENSITY),
                "Density of the material, with depth; a body of revolution needs no depth. Or write mass.",
            ),
            key("depth", Holds::Quantity(LENGTH), "Depth of the part, across the drawing."),
            key(
                "mass_centre",
                Holds::Vector(COORDINATE, 2),
                "Mass centre of a part that is not uniform; it needs inertia too. It is measured as the vertices are, or as the outline's file is; of a rod or box from the middle.",
            ),
            key(
                "inertia",
                Holds::Quantity(INERTIA),
                "Moment of inertia about the mass centre. It follows from the shape where it is left out.",
            ),
        ],
        LIBRARY,
    ],
    rules: &[
        SHAPES,
        BOLT_SIZE,
        SOCKET,
        WASHER_SIZE,
        PIN_SIZE,
        PIN_ENDS,
        Rule {
            when: When::Always,
            ways: &[way(When::Has("mass"), &[], &[]), way(When::Has("density"), &[], &[])],
            missing: "a mass in kg, or density with depth",
            help: "",
        },
        Rule {
            when: When::All(&[When::Has("density"), When::IsOneOf("shape", FLAT)]),
            ways: &[way(When::Has("density"), &["depth"], &[])],
            missing: "",
            help: "",
        },
        Rule {
            when: When::Has("mass_centre"),
            ways: &[way(When::Has("inertia"), &[], &[])],
            missing: "a part whose mass centre is given is not uniform, so its inertia has to be given too",
            help: "",
        },
    ],
    foreign: &[],
    inherited: &[],
};

/// Units in which the lengths of a file may be.
pub(crate) fn length_units() -> Vec<&'static str> {
    Dimension::Length.units().iter().map(|unit| unit.symbol).collect()
}
