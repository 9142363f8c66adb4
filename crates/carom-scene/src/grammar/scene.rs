//! The grammar of a scene: what stands on a feeder's drawing.

use super::kind::{
    COORDINATE, COUNT, DENSITY, FACE, FRICTION, GRAVITY, INERTIA, LENGTH, LENGTH_OR_NONE, MASS, MAX_SPEED,
    PARTS, RESTITUTION, SCALE, SLOPE, SPEED, TIME,
};
use super::{File, FileKind, Holds, Inherited, Key, Rule, Table, Tables, Way, When, key};
use crate::drawing::{ShapeWord, Side, Want};
use crate::unit::Dimension;
use carom_feeder::Stop;
use carom_impact::planar::Law;
use carom_study::design::Aim;
use carom_words::Words;

/// Standard of the papers [m/s²].
pub(crate) const STANDARD_GRAVITY: f64 = 9.81;

pub(crate) static SCENE: File =
    File { kind: FileKind::Scene, title: "carom scene", variants: &[(When::Always, &ROOT)] };

static ROOT: Table = Table {
    name: "Scene",
    about: "What stands on a feeder's drawing.",
    keys: &[&[
        key("gravity", Holds::Quantity(GRAVITY), "Gravity, downwards.").or(STANDARD_GRAVITY),
        key(
            "stop",
            Holds::Words(Stop::words),
            "When a run ends: landed, flat on the last plate; or delivered, when the part has left it.",
        )
        .or_word("landed"),
        key("part", Holds::Table(&PART), "The part.")
            .needed_as("a table [part] with the part's shape and mass"),
        key(
            "contact",
            Holds::Table(&CONTACT),
            "How the part touches every plate and wall that does not say its own.",
        ),
        key("start", Holds::Table(&START), "How the part starts.")
            .needed_as("a table [start] with to_edge, from the mass centre to the free edge"),
        key("channel", Holds::Table(&CHANNEL), "Two vertical walls, between which the plates are."),
        key("plate", Holds::Tables(&PLATES), "The plates, in the order in which the part meets them."),
        key("zigzag", Holds::Table(&ZIGZAG), "Plates that are all alike."),
        key("wall", Holds::Tables(&WALLS), "Other straight obstacles."),
        key("feed", Holds::Table(&FEED), "Several parts are fed, one after another."),
        key("design", Holds::Table(&DESIGN), "What `carom design` may choose, must keep and aims at."),
    ]],
    rules: &[Rule {
        when: When::Always,
        ways: &[way(When::Has("plate"), &[], &[]), way(When::Has("zigzag"), &[], &[])],
        missing: "a feeder needs at least one plate, [[plate]] or [zigzag]",
        help: "",
    }],
    foreign: &[],
    inherited: &[Inherited {
        key: "friction",
        from: "contact",
        heirs: &["plate", "zigzag", "wall", "channel", "feed"],
        missing: "a plain number, for every plate, wall and feed that has no friction of its own",
    }],
};

pub(super) const fn way(shown: When, needs: &'static [&'static str], takes: &'static [&'static str]) -> Way {
    Way { shown, needs, takes }
}

static PART: Table = Table {
    name: "Part",
    about: "The part: its shape and its mass.",
    keys: &[&[
        key("shape", Holds::Words(ShapeWord::words), "The shape of the part, seen from the side.").needed(),
        key("length", Holds::Quantity(LENGTH), "Length of a rod or a box."),
        key("height", Holds::Quantity(LENGTH), "Height of a box."),
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
        key("density", Holds::Quantity(DENSITY), "Density of the material, with depth. Or write mass."),
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
    ]],
    rules: &[
        Rule {
            when: When::Has("shape"),
            ways: &[
                way(When::Is("shape", "rod"), &["length"], &["corner_radius"]),
                way(When::Is("shape", "box"), &["length", "height"], &["corner_radius"]),
                way(When::Is("shape", "polygon"), &["vertices"], &["corner_radius"]),
                way(When::Is("shape", "disc"), &["radius"], &[]),
                way(When::Is("shape", "outline"), &["file"], &["unit", "layer", "scale", "chord"]),
            ],
            missing: "",
            help: "",
        },
        Rule {
            when: When::Always,
            ways: &[way(When::Has("mass"), &[], &["depth"]), way(When::Has("density"), &["depth"], &[])],
            missing: "a mass in kg, or density with depth",
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

/// Friction and restitution of a surface, where they are its own.
const SURFACE: &[Key] = &[
    key(
        "friction",
        Holds::Quantity(FRICTION),
        "Coefficient of friction. That of [contact] counts where it is left out.",
    ),
    key(
        "restitution",
        Holds::Quantity(RESTITUTION),
        "Coefficient of restitution. That of [contact] counts where it is left out.",
    ),
];

static CONTACT: Table = Table::plain(
    "Contact",
    "Contact of the part with every plate and wall that does not say its own.",
    &[&[
        key("friction", Holds::Quantity(FRICTION), "Coulomb's coefficient of friction."),
        key("restitution", Holds::Quantity(RESTITUTION), "Coefficient of restitution.").or(0.0),
        LAW,
    ]],
);

/// The law of restitution, of a scene, an impact or a roll.
pub(super) const LAW: Key =
    key("law", Holds::Words(Law::words), "The law by which restitution ends.").or_word("poisson");

static START: Table = Table::plain(
    "Start",
    "How the part starts, lying flat on the first plate.",
    &[&[
        key(
            "to_edge",
            Holds::Quantity(LENGTH_OR_NONE),
            "Distance from the mass centre to the plate's free edge, along the plate.",
        )
        .needed(),
        key("speed", Holds::Quantity(SPEED), "Speed down the plate at the start.").or(0.0),
        key("face", Holds::Quantity(FACE), "Number of the face on which the part lies at the start.").or(0.0),
    ]],
);

static CHANNEL: Table = Table::plain(
    "Channel",
    "Two vertical walls, the left one at x = 0.",
    &[&[key("width", Holds::Quantity(LENGTH), "Distance between the walls.").needed()], SURFACE],
);

static LINE: Table = Table::plain(
    "Line",
    "A line x/along + y/normal = 1 in the axes of the plate before: x from its free edge downhill, y down through it.",
    &[&[
        key(
            "along",
            Holds::Quantity(LENGTH),
            "Distance from the free edge at which it meets the plate's line.",
        )
        .needed(),
        key(
            "normal",
            Holds::Quantity(LENGTH),
            "How far it is below the free edge, at right angles to the plate.",
        )
        .needed(),
    ]],
);

const NAME: Key = key(
    "name",
    Holds::Text,
    "Name, by which paths call it. Its number, counted from 0, counts where it is left out.",
);
const WANT: Key = key(
    "want",
    Holds::Either(&[Holds::Words(Want::words), Holds::Number(FACE)]),
    "How the part is to lie on the plate: on the same side, turned, on any face, or on the face of this number.",
);

static PLATES: Tables = Tables {
    of: &PLATE,
    least: 1,
    most: usize::MAX,
    named: true,
    first: &[
        placed(&[HINGED, BY_LINE, THROUGH, BY_EDGE, BY_ENDS, ORIGIN], ""),
        Rule {
            when: When::Has("wall"),
            ways: &[
                way(When::Has("height"), &[], &[]),
                way(When::Has("drop"), &[], &[]),
                way(When::NoOther, &[], &[]),
            ],
            missing: "",
            help: "",
        },
    ],
    later: &[
        placed(&[HINGED, BY_LINE, THROUGH, BY_EDGE, BY_ENDS], "a place"),
        Rule {
            when: When::Has("wall"),
            ways: &[way(When::Has("drop"), &[], &[]), way(When::Has("height"), &[], &[])],
            missing: "a length below the previous hinge, or height",
            help: "",
        },
    ],
};

const HINGED: Way = way(When::Has("wall"), &["slope"], &["height", "drop", "gap", "length"]);
const BY_LINE: Way = way(When::Has("line"), &[], &["downhill"]);
const THROUGH: Way = way(When::Has("below"), &["slope"], &["downhill"]);
const BY_EDGE: Way = way(When::Has("edge"), &["slope", "length"], &["downhill"]);
const BY_ENDS: Way = way(When::Any(&["from", "to"]), &["from", "to"], &[]);
/// The first plate: its free edge is the origin.
const ORIGIN: Way = way(When::NoOther, &["slope"], &["length", "downhill"]);

const fn placed(ways: &'static [Way], missing: &'static str) -> Rule {
    let help = "a plate is placed by wall + drop + slope + gap (or length), by line, by below + slope, by edge + slope + length, or by from + to";
    Rule { when: When::Always, ways, missing, help }
}

static PLATE: Table = Table {
    name: "Plate",
    about: "A plate. The first needs no place: its free edge is the origin. Others are placed by wall (hinged there) with slope, drop or height, and gap or length; by line; by below with slope; by edge with slope and length; or by from and to.",
    keys: &[
        &[
            NAME,
            key("wall", Holds::Words(Side::words), "The wall at which the plate is hinged."),
            key("height", Holds::Quantity(COORDINATE), "Height of the hinge."),
            key("drop", Holds::Quantity(LENGTH), "Drop of the hinge, below the previous plate's hinge."),
            key(
                "slope",
                Holds::Quantity(SLOPE),
                "Slope of the plate below the horizontal, away from its uphill end.",
            ),
            key("gap", Holds::Quantity(LENGTH), "Gap from the free edge to the other wall."),
            key("length", Holds::Quantity(LENGTH), "Length from the uphill end to the free edge."),
            key("downhill", Holds::Words(Side::words), "The side to which the plate slopes."),
            key("line", Holds::Table(&LINE), "The line of the plate, in the axes of the plate before."),
            key(
                "below",
                Holds::Point(COORDINATE),
                "A point on the line of the plate, measured from the previous plate's free edge.",
            ),
            key("edge", Holds::Point(COORDINATE), "The free edge of the plate."),
            key("from", Holds::Point(COORDINATE), "The uphill end of the plate."),
            key("to", Holds::Point(COORDINATE), "The free edge of the plate."),
            WANT,
        ],
        SURFACE,
    ],
    rules: &[Rule {
        when: When::Has("wall"),
        ways: &[way(When::Has("gap"), &[], &[]), way(When::Has("length"), &[], &[])],
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
            key("plates", Holds::Quantity(COUNT), "How many plates there are.").needed(),
            key("drop", Holds::Quantity(LENGTH), "Drop from hinge to hinge.").needed(),
            key("slope", Holds::Quantity(SLOPE), "Slope of each plate below the horizontal.").needed(),
            key("gap", Holds::Quantity(LENGTH), "Gap from each free edge to the other wall.").needed(),
            key("height", Holds::Quantity(COORDINATE), "Height of the first hinge.").or(0.0),
            key("wall", Holds::Words(Side::words), "The wall of the first hinge.").or_word("left"),
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
            key("from", Holds::Point(COORDINATE), "One end of the wall.").needed(),
            key("to", Holds::Point(COORDINATE), "The other end of the wall.").needed(),
        ],
        SURFACE,
    ],
);

static FEED: Table = Table::plain(
    "Feed",
    "Several parts, one after another; friction and restitution are those between two parts.",
    &[
        &[
            key("parts", Holds::Quantity(PARTS), "How many parts there are.").needed(),
            key("interval", Holds::Quantity(TIME), "Time from one part's start to the next.").needed(),
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
        key("max_sliding_speed", Holds::Quantity(MAX_SPEED), "Highest speed of sliding."),
        key("max_height", Holds::Quantity(LENGTH), "Greatest height of the feeder."),
        key("max_width", Holds::Quantity(LENGTH), "Greatest width of the feeder."),
        key("max_time", Holds::Quantity(TIME), "Longest time of a drop."),
        key("forbid_walls", Holds::Flag, "True where the part may touch no wall on its way."),
        key("aim", Holds::Words(Aim::words), "What the design is to be best at.").or_word("yield"),
    ]],
);
