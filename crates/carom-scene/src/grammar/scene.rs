//! The grammar of a scene: what stands on a feeder's drawing.

use super::kind::{
    COORDINATE, COUNT, DENSITY, FACE, FRICTION, GRAVITY, INERTIA, LENGTH, LENGTH_OR_NONE, MASS, MAX_SPEED,
    PARTS, RESTITUTION, SCALE, SLOPE, SPEED, TIME,
};
use super::{By, File, Foreign, Holds, Inherited, Key, Rule, Table, Tables, Way, key, words};
use crate::drawing::{ShapeWord, Side, Want};
use crate::problem::ProblemKind;
use crate::unit::Dimension;
use carom_feeder::Stop;
use carom_impact::planar::Law;
use carom_study::design::Aim;

/// Standard of the papers [m/s²].
pub(crate) const STANDARD_GRAVITY: f64 = 9.81;

pub(crate) static SCENE: File = File { title: "carom scene", variants: &[(By::Always, &ROOT)] };

static ROOT: Table = Table {
    name: "Scene",
    about: "What stands on a feeder's drawing.",
    keys: &[&[
        key("gravity", Holds::Quantity(GRAVITY), "Downwards.").or(STANDARD_GRAVITY),
        key(
            "stop",
            Holds::Words(words::<Stop>),
            "When a run ends: landed, flat on the last plate; or delivered, when the part has left it.",
        )
        .or_word("landed"),
        key("part", Holds::Table(&PART), "The part.")
            .needed_as("a table [part] with the part's shape and mass"),
        key("contact", Holds::Table(&CONTACT), "Contact of the part with every plate and wall."),
        key("start", Holds::Table(&START), "How the part starts.")
            .needed_as("a table [start] with to_edge, from the mass centre to the free edge"),
        key("channel", Holds::Table(&CHANNEL), "Two vertical walls."),
        key("plate", Holds::Tables(&PLATES), "The plates, in the order in which the part meets them."),
        key("zigzag", Holds::Table(&ZIGZAG), "Plates that are all alike."),
        key("wall", Holds::Tables(&WALLS), "Other straight obstacles."),
        key("feed", Holds::Table(&FEED), "Several parts, one after another."),
        key("design", Holds::Table(&DESIGN), "What `carom design` may choose, must keep and aims at."),
    ]],
    rules: &[Rule {
        when: By::Always,
        ways: &[way(By::Has("plate"), &[], &[]), way(By::Has("zigzag"), &[], &[])],
        missing: "a feeder needs at least one plate, [[plate]] or [zigzag]",
        help: "",
    }],
    foreign: &[Foreign {
        keys: &["body", "operator"],
        kind: ProblemKind::File,
        message: "this is an impact, not a scene",
        help: "`carom impact` resolves it",
        alone: true,
    }],
    inherited: &[Inherited {
        key: "friction",
        from: "contact",
        by: &["plate", "zigzag", "wall", "channel", "feed"],
        missing: "a plain number, for every plate, wall and feed that has no friction of its own",
    }],
};

pub(super) const fn way(by: By, needs: &'static [&'static str], takes: &'static [&'static str]) -> Way {
    Way { by, needs, takes }
}

static PART: Table = Table {
    name: "Part",
    about: "The part: its shape and its mass.",
    keys: &[&[
        key("shape", Holds::Words(words::<ShapeWord>), "What it looks like from the side.").needed(),
        key("length", Holds::Quantity(LENGTH), "Of a rod or a box."),
        key("height", Holds::Quantity(LENGTH), "Of a box."),
        key("radius", Holds::Quantity(LENGTH), "Of a disc."),
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
            "file",
            Holds::Text,
            "A DXF or SVG file that draws the outline, looked for from the scene's folder.",
        )
        .if_missing("a DXF or SVG file that draws the outline, file = \"bracket.dxf\""),
        key("unit", Holds::Words(length_units), "Of an outline's file that does not say its own."),
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
        key("mass", Holds::Quantity(MASS), "Of the part; or density with depth."),
        key("density", Holds::Quantity(DENSITY), "Of its material, with depth; or mass."),
        key("depth", Holds::Quantity(LENGTH), "Across the drawing."),
        key(
            "mass_centre",
            Holds::Vector(COORDINATE, 2),
            "Of a part that is not uniform, with its inertia: in the coordinates of the vertices or of the outline's file; of a rod or box from its middle.",
        ),
        key(
            "inertia",
            Holds::Quantity(INERTIA),
            "About the mass centre; from the shape where it is left out.",
        ),
    ]],
    rules: &[
        Rule {
            when: By::Has("shape"),
            ways: &[
                way(By::Is("shape", "rod"), &["length"], &["corner_radius"]),
                way(By::Is("shape", "box"), &["length", "height"], &["corner_radius"]),
                way(By::Is("shape", "polygon"), &["vertices"], &["corner_radius"]),
                way(By::Is("shape", "disc"), &["radius"], &[]),
                way(By::Is("shape", "outline"), &["file"], &["unit", "layer", "scale", "chord"]),
            ],
            missing: "",
            help: "",
        },
        Rule {
            when: By::Always,
            ways: &[way(By::Has("mass"), &[], &["depth"]), way(By::Has("density"), &["depth"], &[])],
            missing: "a mass in kg, or density with depth",
            help: "",
        },
        Rule {
            when: By::Has("mass_centre"),
            ways: &[way(By::Has("inertia"), &[], &[])],
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

/// Friction and restitution of a surface, where they are its own.
const SURFACE: &[Key] = &[
    key(
        "friction",
        Holds::Quantity(FRICTION),
        "Coefficient of friction; that of [contact] where it is left out.",
    ),
    key(
        "restitution",
        Holds::Quantity(RESTITUTION),
        "Coefficient of restitution; that of [contact] where it is left out.",
    ),
];

static CONTACT: Table = Table::plain(
    "Contact",
    "Contact of the part with every plate and wall that does not say its own.",
    &[&[
        key("friction", Holds::Quantity(FRICTION), "Coulomb's coefficient."),
        key("restitution", Holds::Quantity(RESTITUTION), "Coefficient of restitution.").or(0.0),
        LAW,
    ]],
);

/// The law of restitution, of a scene, an impact or a roll.
pub(super) const LAW: Key =
    key("law", Holds::Words(words::<Law>), "The law by which restitution ends.").or_word("poisson");

static START: Table = Table::plain(
    "Start",
    "How the part starts, lying flat on the first plate.",
    &[&[
        key(
            "to_edge",
            Holds::Quantity(LENGTH_OR_NONE),
            "From the mass centre to the plate's free edge, along the plate.",
        )
        .needed(),
        key("speed", Holds::Quantity(SPEED), "Down the plate.").or(0.0),
        key("face", Holds::Quantity(FACE), "The face that is down.").or(0.0),
    ]],
);

static CHANNEL: Table = Table::plain(
    "Channel",
    "Two vertical walls, the left one at x = 0.",
    &[&[key("width", Holds::Quantity(LENGTH), "Between the walls.").needed()], SURFACE],
);

static LINE: Table = Table::plain(
    "Line",
    "A line x/along + y/normal = 1 in the axes of the plate before: x from its free edge downhill, y down through it.",
    &[&[
        key("along", Holds::Quantity(LENGTH), "Where it meets the plate's line.").needed(),
        key("normal", Holds::Quantity(LENGTH), "How far below the free edge, at right angles to the plate.")
            .needed(),
    ]],
);

const NAME: Key =
    key("name", Holds::Text, "By which paths call it; its number, from 0, where it is left out.");
const WANT: Key = key(
    "want",
    Holds::Either(&[Holds::Words(words::<Want>), Holds::Number(FACE)]),
    "How the part is to come off: on the same side, turned, on any, or on the face of this number.",
);

static PLATES: Tables = Tables {
    of: &PLATE,
    least: 1,
    most: usize::MAX,
    named: true,
    first: &[
        placed(&[HINGED, BY_LINE, THROUGH, BY_EDGE, BY_ENDS, ORIGIN], ""),
        Rule {
            when: By::Has("wall"),
            ways: &[
                way(By::Has("height"), &[], &[]),
                way(By::Has("drop"), &[], &[]),
                way(By::Otherwise, &[], &[]),
            ],
            missing: "",
            help: "",
        },
    ],
    later: &[
        placed(&[HINGED, BY_LINE, THROUGH, BY_EDGE, BY_ENDS], "a place"),
        Rule {
            when: By::Has("wall"),
            ways: &[way(By::Has("drop"), &[], &[]), way(By::Has("height"), &[], &[])],
            missing: "a length below the previous hinge, or height",
            help: "",
        },
    ],
};

const HINGED: Way = way(By::Has("wall"), &["slope"], &["height", "drop", "gap", "length"]);
const BY_LINE: Way = way(By::Has("line"), &[], &["downhill"]);
const THROUGH: Way = way(By::Has("below"), &["slope"], &["downhill"]);
const BY_EDGE: Way = way(By::Has("edge"), &["slope", "length"], &["downhill"]);
const BY_ENDS: Way = way(By::Any(&["from", "to"]), &["from", "to"], &[]);
/// The first plate: its free edge is the origin.
const ORIGIN: Way = way(By::Otherwise, &["slope"], &["length", "downhill"]);

const fn placed(ways: &'static [Way], missing: &'static str) -> Rule {
    let help = "a plate is placed by wall + drop + slope + gap (or length), by line, by below + slope, by edge + slope + length, or by from + to";
    Rule { when: By::Always, ways, missing, help }
}

static PLATE: Table = Table {
    name: "Plate",
    about: "A plate. The first needs no place: its free edge is the origin. Others are placed by wall (hinged there) with slope, drop or height, and gap or length; by line; by below with slope; by edge with slope and length; or by from and to.",
    keys: &[
        &[
            NAME,
            key("wall", Holds::Words(words::<Side>), "The wall at which it is hinged."),
            key("height", Holds::Quantity(COORDINATE), "Of the hinge."),
            key("drop", Holds::Quantity(LENGTH), "Of the hinge, below the previous plate's."),
            key("slope", Holds::Quantity(SLOPE), "Below the horizontal, away from its uphill end."),
            key("gap", Holds::Quantity(LENGTH), "From its free edge to the other wall."),
            key("length", Holds::Quantity(LENGTH), "From its uphill end to its free edge."),
            key("downhill", Holds::Words(words::<Side>), "The side to which it slopes."),
            key("line", Holds::Table(&LINE), "Its line, in the axes of the plate before."),
            key(
                "below",
                Holds::Point(COORDINATE),
                "A point that its line passes through, from the previous plate's free edge.",
            ),
            key("edge", Holds::Point(COORDINATE), "Its free edge."),
            key("from", Holds::Point(COORDINATE), "Its uphill end."),
            key("to", Holds::Point(COORDINATE), "Its free edge."),
            WANT,
        ],
        SURFACE,
    ],
    rules: &[Rule {
        when: By::Has("wall"),
        ways: &[way(By::Has("gap"), &[], &[]), way(By::Has("length"), &[], &[])],
        missing: "a length from the free edge to the other wall, or length",
        help: "",
    }],
    foreign: &[],
    inherited: &[],
};

static ZIGZAG: Table = Table::plain(
    "Zigzag",
    "Plates hinged by turns at the two walls of the channel, all alike.",
    &[
        &[
            key("plates", Holds::Quantity(COUNT), "How many.").needed(),
            key("drop", Holds::Quantity(LENGTH), "From hinge to hinge.").needed(),
            key("slope", Holds::Quantity(SLOPE), "Of each, below the horizontal.").needed(),
            key("gap", Holds::Quantity(LENGTH), "From each free edge to the other wall.").needed(),
            key("height", Holds::Quantity(COORDINATE), "Of the first hinge.").or(0.0),
            key("wall", Holds::Words(words::<Side>), "Of the first hinge.").or_word("left"),
            WANT,
        ],
        SURFACE,
    ],
);

static WALLS: Tables = Tables { of: &WALL, least: 0, most: usize::MAX, named: true, first: &[], later: &[] };

static WALL: Table = Table::plain(
    "Wall",
    "Another straight obstacle.",
    &[
        &[
            NAME,
            key("from", Holds::Point(COORDINATE), "One end.").needed(),
            key("to", Holds::Point(COORDINATE), "The other end.").needed(),
        ],
        SURFACE,
    ],
);

static FEED: Table = Table::plain(
    "Feed",
    "Several parts, one after another; friction and restitution are those between two parts.",
    &[
        &[
            key("parts", Holds::Quantity(PARTS), "How many.").needed(),
            key("interval", Holds::Quantity(TIME), "From one part's start to the next.").needed(),
        ],
        SURFACE,
    ],
);

static DESIGN: Table = Table::plain(
    "Design",
    "What a design may choose, must keep and aims at.",
    &[&[
        key("free", Holds::Ranges, "Paths with their ranges: \"plate.lower.slope\" = \"10..40 deg\"."),
        key("max_impact_speed", Holds::Quantity(MAX_SPEED), "Highest approach speed of an impact."),
        key("max_sliding_speed", Holds::Quantity(MAX_SPEED), "Highest slip."),
        key("max_height", Holds::Quantity(LENGTH), "Highest feeder."),
        key("max_width", Holds::Quantity(LENGTH), "Widest feeder."),
        key("max_time", Holds::Quantity(TIME), "Longest time of a drop."),
        key("forbid_walls", Holds::Flag, "True where the part may touch no wall on its way."),
        key("aim", Holds::Words(words::<Aim>), "What to be best at.").or_word("yield"),
    ]],
);
