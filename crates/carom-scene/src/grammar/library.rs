//! The keys of parts that are known by their name and their dimensions, and which go together.

use super::kind::{CHAMFER, LENGTH, LENGTH_OR_NONE};
use super::part::CHAIN;
use super::scene::way;
use super::{Holds, Key, Rule, Way, When, key};
use crate::library::HeadWord;
use carom_words::Words;

pub(super) const LIBRARY: &[Key] = &[
    key(
        "size",
        Holds::Text,
        "Size of a bolt, \"M8 x 30\", of a washer, \"M8\", or of a pin, \"8 x 30\": its dimensions are those of the standard where they are not written.",
    ),
    key(
        "head",
        Holds::Words(HeadWord::words),
        "The head of a bolt: hexagon, by ISO 4017; or socket, a cylinder with a hexagon socket, by ISO 4762.",
    )
    .or_word("hexagon"),
    key("diameter", Holds::Quantity(LENGTH), "Outer diameter of a bolt's thread, a pin or a cap.")
        .if_missing("the outer diameter, for example in mm"),
    key(
        "head_width",
        Holds::Quantity(LENGTH),
        "Width of a bolt's head: of a hexagon across flats, else its diameter.",
    )
    .if_missing("the width of the head, for example in mm; or size = \"M8 x 30\""),
    key("head_height", Holds::Quantity(LENGTH), "Height of a bolt's head.")
        .if_missing("the height of the head, for example in mm; or size = \"M8 x 30\""),
    key(
        "pitch",
        Holds::Quantity(LENGTH),
        "Pitch of a bolt's thread, by which the thread is lighter than a full shank.",
    ),
    key(
        "thread_length",
        Holds::Quantity(LENGTH_OR_NONE),
        "Length of a bolt's thread, from its end; up to the head where it is left out.",
    ),
    key("socket_width", Holds::Quantity(LENGTH), "Width of the hexagon socket, across flats."),
    key("socket_depth", Holds::Quantity(LENGTH), "Depth of the hexagon socket."),
    key("inner_diameter", Holds::Quantity(LENGTH_OR_NONE), "Diameter of a washer's hole.")
        .if_missing("the diameter of the hole, for example in mm; or size = \"M8\""),
    key("outer_diameter", Holds::Quantity(LENGTH), "Outer diameter of a washer.")
        .if_missing("the outer diameter, for example in mm; or size = \"M8\""),
    key("thickness", Holds::Quantity(LENGTH), "Thickness of a washer, or of a bracket's legs."),
    key("chamfer", Holds::Quantity(LENGTH_OR_NONE), "Length of the chamfers of a pin, along its axis."),
    key(
        "chamfer_angle",
        Holds::Quantity(CHAMFER),
        "Angle between a pin's chamfers and its axis; 45 deg where only the chamfer is written.",
    ),
    key("wall", Holds::Quantity(LENGTH), "Thickness of a cap's wall."),
    key(
        "base",
        Holds::Quantity(LENGTH),
        "Thickness of a cap's closed end; that of its wall where it is left out.",
    ),
    key(
        "legs",
        Holds::Vector(LENGTH, 2),
        "Lengths of a bracket's two legs, from the outside of its corner: along x, along y.",
    )
    .if_missing("the lengths of the two legs, legs = [\"40 mm\", \"30 mm\"]"),
    key("inner_radius", Holds::Quantity(LENGTH_OR_NONE), "Radius of a bracket's bend, inside.").or(0.0),
    key("outer_radius", Holds::Quantity(LENGTH_OR_NONE), "Radius of a bracket's bend, outside.").or(0.0),
    key(
        "profile",
        CHAIN,
        "Half of the outline of a body of revolution: points [axial, radius], with arcs between them, from the axis to the axis.",
    )
    .if_missing("the points [axial, radius] of half of the outline, from the axis to the axis"),
    key(
        "bore",
        CHAIN,
        "The hollow of a body of revolution, as the profile is written: what lies between it and the axis weighs nothing.",
    ),
];

const BOLT: Way = way(
    When::Is("shape", "bolt"),
    &[],
    &[
        "size",
        "head",
        "diameter",
        "length",
        "head_width",
        "head_height",
        "pitch",
        "thread_length",
        "socket_width",
        "socket_depth",
    ],
);
const WASHER: Way =
    way(When::Is("shape", "washer"), &[], &["size", "inner_diameter", "outer_diameter", "thickness"]);
const PIN: Way = way(
    When::Is("shape", "pin"),
    &[],
    &["size", "diameter", "length", "chamfer", "chamfer_angle", "corner_radius"],
);
const CAP: Way = way(When::Is("shape", "cap"), &["diameter", "height", "wall"], &["base", "corner_radius"]);
const BRACKET: Way =
    way(When::Is("shape", "bracket"), &["legs", "thickness"], &["inner_radius", "outer_radius", "depth"]);
const REVOLVED: Way = way(When::Is("shape", "revolved"), &["profile"], &["bore"]);

/// Every shape of a part with the keys that belong to it.
pub(super) const SHAPES: Rule = Rule {
    when: When::Has("shape"),
    ways: &[
        way(When::Is("shape", "rod"), &["length"], &["corner_radius", "depth"]),
        way(When::Is("shape", "box"), &["length", "height"], &["corner_radius", "depth"]),
        way(When::Is("shape", "polygon"), &["vertices"], &["corner_radius", "depth"]),
        way(When::Is("shape", "chain"), &["points"], &["depth"]),
        way(When::Is("shape", "disc"), &["radius"], &["depth"]),
        way(When::Is("shape", "outline"), &["file"], &["unit", "layer", "scale", "chord", "depth"]),
        BOLT,
        WASHER,
        PIN,
        CAP,
        BRACKET,
        REVOLVED,
    ],
    missing: "",
    help: "",
};

/// Dimensions follow from a size, or are written one by one.
pub(super) const BOLT_SIZE: Rule = Rule {
    when: When::Is("shape", "bolt"),
    ways: &[
        way(When::Has("size"), &[], &["length", "head_width", "head_height"]),
        way(When::NoOther, &["diameter", "length", "head_width", "head_height"], &[]),
    ],
    missing: "",
    help: "",
};

pub(super) const SOCKET: Rule = Rule {
    when: When::Is("shape", "bolt"),
    ways: &[
        way(When::Is("head", "socket"), &[], &["socket_width", "socket_depth"]),
        way(When::NoOther, &[], &["head"]),
    ],
    missing: "",
    help: "",
};

pub(super) const WASHER_SIZE: Rule = Rule {
    when: When::Is("shape", "washer"),
    ways: &[
        way(When::Has("size"), &[], &["inner_diameter", "outer_diameter", "thickness"]),
        way(When::NoOther, &["inner_diameter", "outer_diameter", "thickness"], &[]),
    ],
    missing: "",
    help: "",
};

pub(super) const PIN_SIZE: Rule = Rule {
    when: When::Is("shape", "pin"),
    ways: &[way(When::Has("size"), &[], &["length"]), way(When::NoOther, &["diameter", "length"], &[])],
    missing: "",
    help: "",
};

pub(super) const PIN_ENDS: Rule = Rule {
    when: When::Is("shape", "pin"),
    ways: &[
        way(When::Has("corner_radius"), &[], &[]),
        way(When::Any(&["chamfer", "chamfer_angle"]), &[], &[]),
        way(When::NoOther, &[], &[]),
    ],
    missing: "",
    help: "",
};

/// What has no depth of its own: everything but bodies of revolution.
pub(super) const FLAT: &[&str] = &["rod", "box", "polygon", "chain", "disc", "outline", "bracket"];
