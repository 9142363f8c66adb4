//! The grammar of a scene in space: a solid part, plates with a width, walls beside them.

use super::kind::{
    COORDINATE, DENSITY, FACE, FRICTION, INERTIA, LENGTH, LENGTH_OR_NONE, MASS, PRODUCT, RESTITUTION, TURN,
};
use super::part::length_units;
use super::roll_space::LAW_IN_SPACE;
use super::scene::{
    BY_EDGE, BY_ENDS, BY_LINE, CHANNEL, FACE_SHARES, FIRST_LEVEL, GRAVITY_KEY, HINGED, LATER_LEVEL,
    MATERIALS, NAME, ORIGIN, OWN_SURFACE, PLATE_EDGE_RADIUS, REACH, START_SPEED, STOP, STRAIGHT, SURFACE,
    THROUGH, TO_EDGE, WALL_EDGE_RADIUS, WANT, placed, way,
};
use super::scene_studies::DESIGN;
use super::{Foreign, Holds, Inherited, Rule, Table, Tables, When, key};
use crate::part_drawing::SolidWord;
use crate::problem::ProblemKind;
use crate::start::StartWord;
use carom_words::Words;

pub(super) static SPACE_ROOT: Table = Table {
    name: "SpaceScene",
    about: "What stands on a feeder's drawing, and how wide it is: its part is a solid, and it is followed in space. World axes are those of the drawing, x to the right and y up, and z out of it.",
    keys: &[&[
        GRAVITY_KEY,
        STOP,
        key("part", Holds::Table(&SOLID), "The part.")
            .needed_as("a table [part] with the part's shape and mass"),
        key(
            "contact",
            Holds::Either(&CONTACT_CHOICES),
            "How the part touches every plate and wall that does not say its own: friction and restitution, or the name of two materials.",
        ),
        key("start", Holds::Table(&SPACE_START), "How the part starts.")
            .needed_as("a table [start] with to_edge, from the mass centre to the free edge"),
        key("channel", Holds::Table(&CHANNEL), "Two vertical walls, between which the plates are."),
        key("groove", Holds::Table(&GROOVE), "Two walls beside the drawing, between which the part moves."),
        key("plate", Holds::Tables(&SPACE_PLATES), "The plates, in the order in which the part meets them.")
            .needed_as("at least one [[plate]]"),
        key("wall", Holds::Tables(&SPACE_WALLS), "Other obstacles across the drawing."),
        key("pin", Holds::Tables(&PINS), "Round pins, wherever they are and whichever way they point."),
        key("design", Holds::Table(&DESIGN), "What `carom design` may choose, must keep and aims at."),
    ]],
    rules: &[],
    foreign: &[
        Foreign {
            keys: &["zigzag"],
            kind: ProblemKind::Unsupported,
            message: "is not read in a scene in space: write each [[plate]]",
            help: "",
        },
        Foreign {
            keys: &["feed"],
            kind: ProblemKind::Unsupported,
            message: "is for parts that move in the plane: a solid part is followed alone; `carom feed` says how closely others may follow it",
            help: "",
        },
    ],
    inherited: &[Inherited {
        key: "friction",
        or: "contact",
        from: "contact",
        heirs: &["plate", "wall", "channel", "pin"],
        missing: "a plain number, for every plate and wall that has no friction of its own",
    }],
};

static CONTACT_CHOICES: [Holds; 2] = [MATERIALS, Holds::Table(&CONTACT)];

static CONTACT: Table = Table::plain(
    "SpaceContact",
    "Contact of the part with every plate and wall that does not say its own.",
    &[&[
        key("friction", Holds::Quantity(FRICTION), "Coulomb's coefficient of friction."),
        key("restitution", Holds::Quantity(RESTITUTION), "Coefficient of restitution.").or(0.0),
        LAW_IN_SPACE,
    ]],
);

static SOLID: Table = Table {
    name: "SolidPart",
    about: "A solid part: a box, the convex hull of vertices, or that of the surface in an STL file.",
    keys: &[&[
        key("shape", Holds::Words(SolidWord::words), "It is a solid.").or_word("solid"),
        key(
            "box",
            Holds::Vector(LENGTH, 3),
            "The three edges of a box, along x, y and z. Its faces are numbered as in the plane: 0 the lower one, 1 the right end, 2 the upper one, 3 the left end; then 4 the front and 5 the back.",
        ),
        key(
            "vertices",
            Holds::List {
                of: &Holds::Vector(COORDINATE, 3),
                least: 4,
                most: usize::MAX,
                called: "a list of places [[x, y, z], ...]",
            },
            "Points whose convex hull is the part.",
        ),
        key(
            "file",
            Holds::Text,
            "An STL file, looked for from the scene's folder; its hull is what touches, unless hollows says otherwise.",
        ),
        key(
            "hollows",
            Holds::Flag,
            "True where the part touches with the hollows of its file too, of any depth: it is cut into convex pieces. Where it is left out its hull touches.",
        ),
        key("unit", Holds::Words(length_units), "Unit of the lengths in the STL file.").or_word("mm"),
        key(
            "flatness",
            Holds::Quantity(LENGTH),
            "How far corners of one face may be from its plane; from rounding where it is left out.",
        ),
        key(
            "corner_radius",
            Holds::Quantity(LENGTH),
            "Radius of the part's edges and corners: its faces stay where they are, and it rolls over what is between them. Sharp where it is left out.",
        ),
        key("mass", Holds::Quantity(MASS), "Mass of the part. Or write density."),
        key("density", Holds::Quantity(DENSITY), "Density of the material. Or write mass."),
        key(
            "centre",
            Holds::Vector(COORDINATE, 3),
            "The mass centre, of a part that is not uniform; it needs inertia too.",
        ),
        key(
            "inertia",
            Holds::Vector(INERTIA, 3),
            "Moments of inertia about x, y and z through the mass centre, of a part that is not uniform.",
        ),
        key("inertia_products", Holds::Vector(PRODUCT, 3), "Entries xy, xz and yz of the matrix of inertia."),
    ]],
    rules: &[
        Rule {
            when: When::Always,
            ways: &[
                way(When::Has("file"), &[], &["unit", "hollows"]),
                way(When::Has("vertices"), &[], &[]),
                way(When::Has("box"), &[], &[]),
            ],
            missing: "a box, vertices, or an STL file: file = \"bolt.stl\"",
            help: "",
        },
        Rule {
            when: When::Always,
            ways: &[way(When::Has("mass"), &[], &[]), way(When::Has("density"), &[], &[])],
            missing: "a mass in kg, or a density",
            help: "",
        },
        Rule {
            when: When::Any(&["centre", "inertia_products"]),
            ways: &[way(When::Has("inertia"), &[], &[])],
            missing: "three moments about the mass centre: the part is not uniform",
            help: "",
        },
    ],
    foreign: &[],
    inherited: &[],
};

static SPACE_START: Table = Table::plain(
    "SpaceStart",
    "How the part starts, lying flat on the first plate; in a V groove on the flank behind, and against the other one.",
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
            "Number of the face on which the part lies at the start, as `carom faces` numbers them; or a list of faces, each with its share of all parts; or `resting`: each face with the share of those parts that come to rest on it when they are let go without speed, turned at random. A single drop starts on the most probable one, `carom yield` on all of them.",
        )
        .or(0.0),
        key(
            "turn",
            Holds::Quantity(TURN),
            "How far the part is turned on the plate, or on its flank, counter-clockwise as seen from above. At 0 its axes are those of the drawing, but for the least turn that lays the face down.",
        )
        .or(0.0),
        key(
            "aside",
            Holds::Quantity(COORDINATE),
            "From the middle of the plate to the mass centre, across it: towards whoever looks at the drawing.",
        )
        .or(0.0),
    ]],
);

static GROOVE: Table = Table {
    rules: &[OWN_SURFACE],
    ..Table::plain(
        "Groove",
        "Two walls without ends, parallel to the drawing, to either side of it; smooth where they have no friction of their own.",
        &[&[key("width", Holds::Quantity(LENGTH), "Distance between the walls.").needed()], SURFACE],
    )
};

static SPACE_PLATES: Tables = Tables {
    of: &SPACE_PLATE,
    least: 1,
    most: usize::MAX,
    named: true,
    first: &[placed(&[HINGED, BY_LINE, THROUGH, BY_EDGE, BY_ENDS, ORIGIN], "", WAYS), FIRST_LEVEL],
    later: &[placed(&[HINGED, BY_LINE, THROUGH, BY_EDGE, BY_ENDS], "a place", WAYS), LATER_LEVEL],
};

const WAYS: &str = "a plate is placed by wall + drop + slope + gap (or length), by line, by below + slope, by edge + slope + length, or by from + to";

/// Bent sheets.
const BENT: Foreign = Foreign {
    keys: &["chain", "bend_radius"],
    kind: ProblemKind::Unsupported,
    message: "is for parts that move in the plane: in space plates are straight",
    help: "",
};

static SPACE_PLATE: Table = Table {
    name: "SpacePlate",
    about: "A plate, placed as in the plane, with a width across the drawing: flat, or with v_angle a V groove. With edge_radius its sides are round as its ends are, but where side_walls stand along them.",
    keys: &[
        STRAIGHT,
        &[
            key(
                "width",
                Holds::Quantity(LENGTH),
                "Width across the drawing, half of it to either side. As wide as needed where it is left out.",
            ),
            key(
                "roll",
                Holds::Quantity(TURN),
                "Turn about the line from the uphill end to the free edge: a positive one lowers the side that is towards whoever looks at the drawing.",
            )
            .or(0.0),
            key(
                "side_walls",
                Holds::Quantity(LENGTH_OR_NONE),
                "Height of walls along both sides, square to the plate; they touch the part as the plate does. They need a width.",
            )
            .or(0.0),
            key(
                "v_angle",
                Holds::Quantity(TURN),
                "Angle between the two flanks of a V groove, 10° to 170°: its bottom is the line from the uphill end to the free edge, and width is how wide it opens. The plate is flat where it is left out.",
            ),
            PLATE_EDGE_RADIUS,
            WANT,
        ],
        SURFACE,
    ],
    rules: &[
        REACH,
        Rule {
            when: When::Any(&["side_walls", "v_angle"]),
            ways: &[way(When::Has("side_walls"), &[], &[]), way(When::Has("v_angle"), &[], &[])],
            missing: "",
            help: "a plate is flat, with walls along its sides or without, or a V groove",
        },
        Rule {
            when: When::Has("side_walls"),
            ways: &[way(When::Has("width"), &[], &[])],
            missing: "a width, beside side_walls: they stand along the sides of the plate",
            help: "",
        },
        OWN_SURFACE,
    ],
    foreign: &[BENT],
    inherited: &[],
};

static SPACE_WALLS: Tables =
    Tables { of: &SPACE_WALL, least: 0, most: usize::MAX, named: true, first: &[], later: &[] };

static SPACE_WALL: Table = Table {
    name: "SpaceWall",
    about: "Another obstacle: a flat wall across the drawing, as wide as needed.",
    keys: &[
        &[
            NAME,
            key("from", Holds::Point(COORDINATE), "One end of the wall.").needed(),
            key("to", Holds::Point(COORDINATE), "The other end of the wall.").needed(),
            WALL_EDGE_RADIUS,
        ],
        SURFACE,
    ],
    rules: &[OWN_SURFACE],
    foreign: &[BENT],
    inherited: &[],
};

static PINS: Tables = Tables { of: &PIN, least: 0, most: usize::MAX, named: true, first: &[], later: &[] };

static PIN: Table = Table {
    name: "Pin",
    about: "A round bar between two places, [x, y, z], with half balls about them; a ball where they are one place.",
    keys: &[
        &[
            NAME,
            key("from", Holds::Vector(COORDINATE, 3), "The middle of the ball at one end.").needed(),
            key("to", Holds::Vector(COORDINATE, 3), "The middle of the ball at the other end.").needed(),
            key("radius", Holds::Quantity(LENGTH), "Its radius.").needed(),
        ],
        SURFACE,
    ],
    rules: &[OWN_SURFACE],
    foreign: &[],
    inherited: &[],
};
