//! The grammar of a scene: what stands on a feeder's drawing.

use super::kind::{
    COORDINATE, COUNT, FACE, FRICTION, GRAVITY, LENGTH, LENGTH_OR_NONE, RESTITUTION, SCALE, SLOPE, SPEED,
};
use super::part::{CHAIN, PART};
use super::scene_space::SPACE_ROOT;
use super::scene_studies::{DESIGN, FEED};
use super::{File, FileKind, Foreign, Holds, Inherited, Key, Rule, Table, Tables, Way, When, key};
use crate::contact_table::contact_names;
use crate::drawing::{Side, Want};
use crate::problem::ProblemKind;
use crate::start::StartWord;
use carom_feeder::Stop;
use carom_impact::Law;
use carom_words::Words;

/// Standard of the papers [m/s²].
pub(crate) const STANDARD_GRAVITY: f64 = 9.81;

pub(crate) static SCENE: File = File {
    kind: FileKind::Scene,
    title: "carom scene",
    variants: &[(IN_SPACE, &SPACE_ROOT), (When::Always, &ROOT)],
};

/// A scene whose part is a solid is followed in space.
pub(crate) const IN_SPACE: When = When::Solid("part");

pub(super) const GRAVITY_KEY: Key =
    key("gravity", Holds::Quantity(GRAVITY), "Gravity, downwards.").or(STANDARD_GRAVITY);
pub(super) const STOP: Key = key(
    "stop",
    Holds::Words(Stop::words),
    "When a run ends: landed, flat on the last plate; or delivered, when the part has left it.",
)
.or_word("landed");
static CONTACT_CHOICES: [Holds; 2] = [MATERIALS, Holds::Table(&CONTACT)];
pub(super) const CONTACT_KEY: Key = key(
    "contact",
    Holds::Either(&CONTACT_CHOICES),
    "How the part touches every plate and wall that does not say its own: friction and restitution, or the name of two materials.",
);

static ROOT: Table = Table {
    name: "Scene",
    about: "What stands on a feeder's drawing.",
    keys: &[&[
        GRAVITY_KEY,
        STOP,
        key("part", Holds::Table(&PART), "The part.")
            .needed_as("a table [part] with the part's shape and mass"),
        CONTACT_KEY,
        key("start", Holds::Table(&START), "How the part starts.")
            .needed_as("a table [start] with to_edge, from the mass centre to the free edge"),
        key("channel", Holds::Table(&CHANNEL), "Two vertical walls, between which the plates are."),
        key("plate", Holds::Tables(&PLATES), "The plates, in the order in which the part meets them."),
        key("zigzag", Holds::Table(&ZIGZAG), "Plates that are all alike."),
        key("wall", Holds::Tables(&WALLS), "Other obstacles."),
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
        or: "contact",
        from: "contact",
        heirs: &["plate", "zigzag", "wall", "channel", "feed"],
        missing: "a plain number, for every plate, wall and feed that has no friction of its own",
    }],
};

pub(super) const fn way(shown: When, needs: &'static [&'static str], takes: &'static [&'static str]) -> Way {
    Way { shown, needs, takes }
}

pub(super) const MATERIALS: Holds = Holds::Named(contact_names, "contact of two materials");

/// Friction and restitution of a surface, where they are its own.
pub(super) const SURFACE: &[Key] = &[
    key("contact", MATERIALS, "Two materials by name, whose friction and restitution count."),
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

/// They are written, or are those of two materials.
pub(super) const OWN_SURFACE: Rule = Rule {
    when: When::Has("contact"),
    ways: &[way(When::Has("contact"), &[], &[]), way(When::NoOther, &[], &["friction", "restitution"])],
    missing: "",
    help: "",
};

static CONTACT: Table = Table {
    name: "Contact",
    about: "Contact of the part with every plate and wall that does not say its own.",
    keys: &[&[
        key("friction", Holds::Quantity(FRICTION), "Coulomb's coefficient of friction."),
        key("restitution", Holds::Quantity(RESTITUTION), "Coefficient of restitution.").or(0.0),
        LAW,
    ]],
    rules: &[],
    foreign: &[Foreign {
        keys: &["contact"],
        kind: ProblemKind::Conflict,
        message: "two materials are named in place of [contact], not in it",
        help: "write the line contact = \"steel on steel, dry\" at the top of the file, before the first [table]",
    }],
    inherited: &[],
};

/// The law of restitution, of a scene, an impact or a roll.
pub(super) const LAW: Key =
    key("law", Holds::Words(Law::words), "The law by which restitution ends.").or_word("poisson");

pub(super) const TO_EDGE: Key = key(
    "to_edge",
    Holds::Quantity(LENGTH_OR_NONE),
    "Distance from the mass centre to the plate's free edge, along the plate.",
)
.needed();
pub(super) const START_SPEED: Key =
    key("speed", Holds::Quantity(SPEED), "Speed down the plate at the start.").or(0.0);

static START: Table = Table::plain(
    "Start",
    "How the part starts, lying flat on the first plate.",
    &[&[
        TO_EDGE,
        START_SPEED,
        key(
            "face",
            Holds::Either(&[
                Holds::Number(FACE),
                Holds::Words(StartWord::words),
                FACE_SHARES,
            ]),
            "Number of the face on which the part lies at the start; or a list of faces, each with its share of all parts; or `resting`: each face with the \
             share of those parts that come to rest on it when they are let go without speed, turned at random. A single drop starts on the most probable \
             one, `carom yield` on all of them.",
        )
        .or(0.0),
    ]],
);

pub(super) const FACE_SHARES: Holds = Holds::List {
    of: &Holds::Table(&FACE_SHARE),
    least: 1,
    most: usize::MAX,
    called: "a list of { face, share }",
};

static FACE_SHARE: Table = Table::plain(
    "FaceShare",
    "A face on which parts start, and how many of them.",
    &[&[
        key("face", Holds::Number(FACE), "Number of the face.").needed(),
        key(
            "share",
            Holds::Number(SCALE),
            "Its share of all parts; the shares of all faces are taken to sum to 1.",
        )
        .needed(),
    ]],
);

pub(super) static CHANNEL: Table = Table {
    rules: &[OWN_SURFACE],
    ..Table::plain(
        "Channel",
        "Two vertical walls, the left one at x = 0.",
        &[&[key("width", Holds::Quantity(LENGTH), "Distance between the walls.").needed()], SURFACE],
    )
};

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

pub(super) const NAME: Key = key(
    "name",
    Holds::Text,
    "Name, by which paths call it. Its number, counted from 0, counts where it is left out.",
);
const BEND_RADIUS: Key = key(
    "bend_radius",
    Holds::Quantity(LENGTH_OR_NONE),
    "Rounds the corners between the straight stretches of the chain; these stay where they are drawn.",
);
pub(super) const WANT: Key = key(
    "want",
    Holds::Either(&[Holds::Words(Want::words), Holds::Number(FACE)]),
    "How the part is to lie on the plate: on the same side or turned (a rod or a box), on any face, or on the face of this number.",
);

static PLATES: Tables = Tables {
    of: &PLATE,
    least: 1,
    most: usize::MAX,
    named: true,
    first: &[
        placed(&[HINGED, BY_LINE, THROUGH, BY_EDGE, BY_ENDS, BY_CHAIN, ORIGIN], "", WAYS_TO_PLACE),
        FIRST_LEVEL,
    ],
    later: &[
        placed(&[HINGED, BY_LINE, THROUGH, BY_EDGE, BY_ENDS, BY_CHAIN], "a place", WAYS_TO_PLACE),
        LATER_LEVEL,
    ],
};

/// How high the hinge of the first plate is.
pub(super) const FIRST_LEVEL: Rule = Rule {
    when: When::Has("wall"),
    ways: &[
        way(When::Has("height"), &[], &[]),
        way(When::Has("drop"), &[], &[]),
        way(When::NoOther, &[], &[]),
    ],
    missing: "",
    help: "",
};
/// How high that of a later one is.
pub(super) const LATER_LEVEL: Rule = Rule {
    when: When::Has("wall"),
    ways: &[way(When::Has("drop"), &[], &[]), way(When::Has("height"), &[], &[])],
    missing: "a length below the previous hinge, or height",
    help: "",
};
/// How far a hinged plate reaches.
pub(super) const REACH: Rule = Rule {
    when: When::Has("wall"),
    ways: &[way(When::Has("gap"), &[], &[]), way(When::Has("length"), &[], &[])],
    missing: "a length from the free edge to the other wall, or length",
    help: "",
};

pub(super) const HINGED: Way = way(When::Has("wall"), &["slope"], &["height", "drop", "gap", "length"]);
pub(super) const BY_LINE: Way = way(When::Has("line"), &[], &["downhill"]);
pub(super) const THROUGH: Way = way(When::Has("below"), &["slope"], &["downhill"]);
pub(super) const BY_EDGE: Way = way(When::Has("edge"), &["slope", "length"], &["downhill"]);
pub(super) const BY_ENDS: Way = way(When::Any(&["from", "to"]), &["from", "to"], &[]);
const BY_CHAIN: Way = way(When::Has("chain"), &[], &["bend_radius"]);
/// The first plate: its free edge is the origin.
pub(super) const ORIGIN: Way = way(When::NoOther, &["slope"], &["length", "downhill"]);

const WAYS_TO_PLACE: &str = "a plate is placed by wall + drop + slope + gap (or length), by line, by below + slope, by edge + slope + length, by from + to, or by chain";

pub(super) const fn placed(ways: &'static [Way], missing: &'static str, help: &'static str) -> Rule {
    Rule { when: When::Always, ways, missing, help }
}

/// Where a straight plate is.
pub(super) const STRAIGHT: &[Key] = &[
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
];

pub(super) const PLATE_EDGE_RADIUS: Key = key(
    "edge_radius",
    Holds::Quantity(LENGTH_OR_NONE),
    "Radius of the plate's edges: it is then a sheet twice as thick below its upper side, its ends half round. Thin and sharp where it is left out.",
);

pub(super) const WALL_EDGE_RADIUS: Key = key(
    "edge_radius",
    Holds::Quantity(LENGTH_OR_NONE),
    "Radius of the wall's edges: it is then a sheet twice as thick about the drawn line, its ends half round. Thin and sharp where it is left out.",
);

static PLATE: Table = Table {
    name: "Plate",
    about: "A plate. The first needs no place: its free edge is the origin. Others are placed by wall (hinged there) with slope, drop or height, and gap or length; by line; by below with slope; by edge with slope and length; by from and to; or by chain, which may be bent.",
    keys: &[
        STRAIGHT,
        &[
            key(
                "chain",
                CHAIN,
                "The upper side of the plate from its uphill end to its free edge: points, with an arc between two of them where it is bent.",
            ),
            BEND_RADIUS,
            PLATE_EDGE_RADIUS,
            WANT,
        ],
        SURFACE,
    ],
    rules: &[REACH, OWN_SURFACE],
    foreign: &[],
    inherited: &[],
};

static ZIGZAG: Table = Table {
    rules: &[OWN_SURFACE],
    ..Table::plain(
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
    )
};

static WALLS: Tables = Tables { of: &WALL, least: 0, most: usize::MAX, named: true, first: &[], later: &[] };

static WALL: Table = Table {
    name: "Wall",
    about: "Another obstacle.",
    keys: &[
        &[
            NAME,
            key("from", Holds::Point(COORDINATE), "One end of the wall."),
            key("to", Holds::Point(COORDINATE), "The other end of the wall."),
            key(
                "chain",
                CHAIN,
                "The wall from one end to the other: points, with an arc between two of them where it is bent.",
            ),
            BEND_RADIUS,
            WALL_EDGE_RADIUS,
        ],
        SURFACE,
    ],
    rules: &[
        Rule { when: When::Always, ways: &[BY_ENDS, BY_CHAIN], missing: "from and to, or a chain", help: "" },
        OWN_SURFACE,
    ],
    foreign: &[],
    inherited: &[],
};
