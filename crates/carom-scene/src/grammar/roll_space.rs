//! The grammar of roll files of bodies in space.

use super::kind::{
    COORDINATE, DENSITY, FRICTION, INERTIA, LENGTH, LENGTH_OR_NONE, NUMBER, POINTS, PRODUCT, RESTITUTION,
    SCALE, SLOPE, SPEED, SPIN, SPIN_RATE, STRIKES, TURN, VELOCITY,
};
use super::part::length_units;
use super::roll::{DEFAULT_RADIUS, GRAVITY_KEY, MASS_KEY, TIME_KEY, file, one_of};
use super::scene::way;
use super::{File, Foreign, Holds, Key, Rule, Table, Way, When, key};
use crate::problem::ProblemKind;
use carom_impact::Law;
use carom_motion::spatial::Choice;
use carom_words::Words;

pub(crate) static PYRAMID_FILE: File = file("carom roll pyramid: input", &[(When::Always, &PYRAMID)]);
pub(crate) static STOOL_FILE: File = file("carom roll stool: input", &[(When::Always, &STOOL)]);
pub(crate) static BODY_FILE: File = file("carom roll body: input", &[(When::Always, &BODY)]);

/// How a body in space is followed.
const IN_SPACE: &[Key] = &[
    GRAVITY_KEY,
    key(
        "strikes",
        Holds::Quantity(STRIKES),
        "How many strikes are followed; one of a pyramid, else all until it rests, where it is left out.",
    ),
    TIME_KEY,
    key(
        "choice",
        Holds::Words(Choice::words),
        "What is followed where several states, or ways on, are consistent.",
    )
    .or_word("keep most"),
    MASS_KEY,
];
const MOMENTS: &[Key] = &[
    key(
        "inertia_transverse",
        Holds::Quantity(INERTIA),
        "Moment of inertia across the body's axis, about the mass centre; of a homogeneous body where it is left out.",
    ),
    key(
        "inertia_axial",
        Holds::Quantity(INERTIA),
        "Moment of inertia about the body's axis; of a homogeneous body where it is left out.",
    ),
];
/// Friction of the plane under a body in space.
const ROUGH: &[Key] = &[
    key(
        "friction",
        Holds::Quantity(FRICTION),
        "Coulomb's coefficient of friction. Nothing slides where it is left out, and strikes are plastic.",
    ),
    key("restitution", Holds::Quantity(RESTITUTION), "Coefficient of restitution. It needs a friction.")
        .or(0.0),
    LAW_IN_SPACE,
];
/// Newton's law says what one closing contact does, and here several strike.
pub(super) const LAW_IN_SPACE: Key =
    key("law", Holds::Words(laws_in_space), "The law by which restitution ends. It needs a friction. Newton's is not among them: in space it is for one contact.")
        .or_word("poisson");

fn laws_in_space() -> Vec<&'static str> {
    Law::words().into_iter().filter(|word| *word != "newton").collect()
}

const RULES_OF_FRICTION: [Rule; 2] = [
    Rule { when: When::Has("restitution"), ways: WITH_FRICTION, missing: NEEDS_FRICTION, help: PLASTIC },
    Rule { when: When::Has("law"), ways: WITH_FRICTION, missing: NEEDS_FRICTION, help: PLASTIC },
];
const WITH_FRICTION: &[Way] = &[way(When::Has("friction"), &[], &[])];
const NEEDS_FRICTION: &str = "a friction, beside a restitution or a law";
const PLASTIC: &str = "without a friction nothing slides, and strikes are plastic";

static PYRAMID: Table = Table {
    name: "Pyramid",
    about: "A pyramid on a regular base that turns about its lateral edge OA until the next corner K of the base strikes.",
    keys: &[
        IN_SPACE,
        MOMENTS,
        &[
            key("sides", Holds::Quantity(POINTS), "Number of sides of the base.").or(4.0),
            key(
                "circumradius",
                Holds::Quantity(LENGTH),
                "Circumradius of the base; 100 mm where neither it nor base_edge is written.",
            ),
            key("base_edge", Holds::Quantity(LENGTH), "Length of an edge of the base."),
            key("height", Holds::Quantity(LENGTH), "Height of the apex above the base."),
            key("height_ratio", Holds::Quantity(SCALE), "Ratio of the height to the circumradius.").or(1.0),
            key(
                "apex_to_centre",
                Holds::Quantity(LENGTH),
                "The mass centre's distance from the apex, on the axis; three quarters of the height where it is left out.",
            ),
            key(
                "roll_rate",
                Holds::Quantity(SPIN),
                "Roll rate about OA, just before the strike; 5 rad/s, or 0 with a tilt, where it is left out.",
            ),
            key("tilt", Holds::Quantity(SLOPE), "How far the face is from flat at the start.").or(0.0),
        ],
    ],
    rules: &[one_of!("circumradius", "base_edge"), one_of!("height", "height_ratio")],
    foreign: &[
        Foreign {
            keys: &["friction"],
            kind: ProblemKind::Unsupported,
            message: "is not asked: contacts of a pyramid that keep do not slide, whatever friction that takes; the result says how much",
            help: "",
        },
        Foreign {
            keys: &["restitution", "law"],
            kind: ProblemKind::Unsupported,
            message: "is not asked: strikes of a pyramid are plastic",
            help: "",
        },
    ],
    inherited: &[],
};

static STOOL: Table = Table {
    name: "Stool",
    about: "A body on n supports, evenly on a circle, that is let go standing on one of them.",
    keys: &[
        IN_SPACE,
        MOMENTS,
        ROUGH,
        &[
            key("supports", Holds::Quantity(POINTS), "How many supports there are.").or(4.0),
            key("circle_radius", Holds::Quantity(LENGTH), "Radius of the circle on which the supports are.")
                .or(DEFAULT_RADIUS),
            key("centre_height", Holds::Quantity(LENGTH), "Height of the mass centre above the supports."),
            key(
                "height",
                Holds::Quantity(LENGTH),
                "Height of a homogeneous prism on the supports; √2 circle radii where neither it nor centre_height is written.",
            ),
            key("tilt", Holds::Quantity(SLOPE), "Angle by which the body is lifted about support 0.").or(0.1),
            key(
                "axis",
                Holds::Vector(NUMBER, 3),
                "Axis about which the body is lifted; [0.25, 1, 0] where it is left out.",
            ),
            key(
                "spin",
                Holds::Vector(SPIN, 3),
                "Spin at the start, in the body's axes; 0 where it is left out.",
            ),
        ],
    ],
    rules: &[one_of!("height", "centre_height"), RULES_OF_FRICTION[0], RULES_OF_FRICTION[1]],
    foreign: &[],
    inherited: &[],
};

static BODY: Table = Table {
    name: "Body",
    about: "A convex polyhedron that is thrown on a plane.",
    keys: &[
        IN_SPACE,
        ROUGH,
        &[
            key(
                "box",
                Holds::Vector(LENGTH, 3),
                "The three edges of a box; 60 × 40 × 25 mm where no shape is written.",
            ),
            key(
                "vertices",
                Holds::List {
                    of: &Holds::Vector(COORDINATE, 3),
                    least: 0,
                    most: usize::MAX,
                    called: "a list of places [[x, y, z], ...]",
                },
                "Points whose convex hull is the body.",
            ),
            key(
                "file",
                Holds::Text,
                "An STL file, looked for from this file's folder; its hull is what touches.",
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
                "Radius of the body's edges and corners: its faces stay where they are, and it rolls over what is between them. Sharp where it is left out.",
            ),
            key("density", Holds::Quantity(DENSITY), "Density of the body, in place of a mass."),
            key(
                "centre",
                Holds::Vector(COORDINATE, 3),
                "The mass centre, of a body that is not homogeneous.",
            ),
            key(
                "inertia",
                Holds::Vector(INERTIA, 3),
                "Moments of inertia about x, y and z through the mass centre, of a body that is not homogeneous.",
            ),
            key(
                "inertia_products",
                Holds::Vector(PRODUCT, 3),
                "Entries xy, xz and yz of the matrix of inertia.",
            ),
            key(
                "axis",
                Holds::Vector(NUMBER, 3),
                "Axis about which the body is turned at the start; [2, 1, 0.5] where it is left out.",
            ),
            key(
                "turn",
                Holds::Quantity(TURN),
                "Angle by which the body is turned about the axis at the start.",
            )
            .or(0.7),
            key(
                "height",
                Holds::Quantity(LENGTH_OR_NONE),
                "Height of the lowest vertex at the start; the reach of the body where it is left out.",
            ),
            key(
                "velocity",
                Holds::Vector(VELOCITY, 3),
                "Velocity of the mass centre at the start; 0 where it is left out.",
            ),
            key(
                "spin",
                Holds::Vector(SPIN, 3),
                "Spin at the start, in the body's axes; 0 where it is left out.",
            ),
            key(
                "speed",
                Holds::Quantity(SPEED),
                "Horizontal speed of throws; from velocity where it is left out.",
            ),
            key("spin_rate", Holds::Quantity(SPIN_RATE), "Spin of throws; from spin where it is left out."),
        ],
    ],
    rules: &[
        one_of!("box", "vertices", "file"),
        one_of!("mass", "density"),
        Rule {
            when: When::Has("unit"),
            ways: &[way(When::Has("file"), &[], &[])],
            missing: "unit is that of an STL file, and none is named",
            help: "",
        },
        Rule {
            when: When::Any(&["centre", "inertia_products"]),
            ways: &[way(When::Has("inertia"), &[], &[])],
            missing: "three moments about the mass centre: the body is not homogeneous",
            help: "",
        },
        Rule {
            when: When::Has("corner_radius"),
            ways: WITH_FRICTION,
            missing: "a friction, beside a corner_radius",
            help: "a body with round edges rolls, and friction says how; it may be 0",
        },
        RULES_OF_FRICTION[0],
        RULES_OF_FRICTION[1],
    ],
    foreign: &[],
    inherited: &[],
};
