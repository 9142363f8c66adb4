//! The grammar of roll files, one for each kind of body. Their keys stand in no table.

use super::kind::{
    COUNT, FRICTION, GRAVITY, INERTIA, LENGTH, LENGTH_OR_NONE, MASS, RESTITUTION, SCALE, SLOPE, SPIN, TIME,
    VELOCITY,
};
use super::scene::{LAW, STANDARD_GRAVITY, way};
use super::{File, FileKind, Holds, Key, Rule, Table, When, key};
use std::f64::consts::PI;

/// Mass of a body whose file says none [kg].
pub(crate) const DEFAULT_MASS: f64 = 1.0;
/// Size of a body whose file says none [m]: a hand's width.
pub(crate) const DEFAULT_RADIUS: f64 = 0.1;

/// A file of one table.
pub(super) const fn file(title: &'static str, variants: &'static [(When, &'static Table)]) -> File {
    File { kind: FileKind::Roll, title, variants }
}

pub(crate) static CYLINDER_FILE: File = file("carom roll cylinder: input", &[(When::Always, &CYLINDER)]);
pub(crate) static PRISM_FILE: File = file("carom roll prism: input", &[(When::Always, &PRISM)]);
pub(crate) static ROD_FILE: File = file("carom roll rod: input", &[(When::Always, &ROD)]);

/// The contacts of a body in the plane, and how long it is followed.
const IN_PLANE: &[Key] = &[
    key(
        "friction",
        Holds::Quantity(FRICTION),
        "Coulomb's coefficient of friction at every contact. Where it is left out, contacts that keep do not slide.",
    ),
    key("restitution", Holds::Quantity(RESTITUTION), "Coefficient of restitution at every contact.").or(0.0),
    LAW,
    GRAVITY_KEY,
    key(
        "strikes",
        Holds::Quantity(COUNT),
        "How many strikes are followed; one, or of a rod all until it rests, where it is left out.",
    ),
    TIME_KEY,
    MASS_KEY,
    key(
        "inertia",
        Holds::Quantity(INERTIA),
        "Moment of inertia about the mass centre. It follows from the shape where it is left out.",
    ),
    key(
        "inertia_ratio",
        Holds::Quantity(SCALE),
        "Ratio of the inertia to m a², where a is the distance from the contact to the mass centre.",
    ),
];
pub(super) const GRAVITY_KEY: Key =
    key("gravity", Holds::Quantity(GRAVITY), "Gravity, downwards.").or(STANDARD_GRAVITY);
pub(super) const TIME_KEY: Key = key(
    "time",
    Holds::Quantity(TIME),
    "How long the body is followed at most; as long as a body of its size needs where it is left out.",
);
pub(super) const MASS_KEY: Key = key("mass", Holds::Quantity(MASS), "Mass of the body.").or(DEFAULT_MASS);
const ROLL_RATE: &str = "Roll rate just before the strike, forward where it is above 0.";

/// At most one of two keys.
macro_rules! one_of {
    ($($key:literal),+) => {
        Rule {
            when: When::Always,
            ways: &[$(way(When::Has($key), &[], &[]),)+ way(When::NoOther, &[], &[])],
            missing: "",
            help: "",
        }
    };
}
pub(super) use one_of;

static CYLINDER: Table = Table {
    name: "Cylinder",
    about: "A disc on level ground, at A, that strikes at K: a second surface that is tangent to it, or the corner of a step.",
    keys: &[
        IN_PLANE,
        &[
            key("radius", Holds::Quantity(LENGTH), "Radius of the disc.").or(DEFAULT_RADIUS),
            key("roll_rate", Holds::Quantity(SPIN), ROLL_RATE).or(10.0),
            key(
                "speed",
                Holds::Quantity(VELOCITY),
                "Speed of the centre, where the disc slides before the strike. It rolls where this is left out.",
            ),
            key("gamma", Holds::Quantity(SLOPE), "Half the central angle from A to K.").or(PI / 6.0),
            key("step_height", Holds::Quantity(LENGTH), "Height of a step, whose corner is K."),
            key(
                "distance",
                Holds::Quantity(LENGTH_OR_NONE),
                "Distance at the start from A to the place of the strike.",
            )
            .or(0.0),
        ],
    ],
    rules: &[one_of!("inertia", "inertia_ratio"), one_of!("gamma", "step_height")],
    foreign: &[],
    inherited: &[],
};

static PRISM: Table = Table {
    name: "Prism",
    about: "A prism that turns about its edge A until the next one, K, strikes the plane.",
    keys: &[
        IN_PLANE,
        &[
            key("sides", Holds::Quantity(COUNT), "Number of sides of a regular prism, 3 or more.").or(6.0),
            key("circumradius", Holds::Quantity(LENGTH), "Circumradius of a regular prism.")
                .or(DEFAULT_RADIUS),
            key(
                "a_to_centre",
                Holds::Quantity(LENGTH),
                "Distance of an irregular prism from A to the foot of the mass centre.",
            ),
            key(
                "centre_to_k",
                Holds::Quantity(LENGTH),
                "Distance of an irregular prism from that foot to K.",
            ),
            key(
                "height",
                Holds::Quantity(LENGTH),
                "Height of the mass centre of an irregular prism above its face.",
            ),
            key("roll_rate", Holds::Quantity(SPIN), ROLL_RATE).or(5.0),
            key("slope", Holds::Quantity(SLOPE), "Slope of the plane, down to +x.").or(0.0),
            key("tilt", Holds::Quantity(SLOPE), "How far the face is from flat at the start.").or(0.0),
        ],
    ],
    rules: &[
        one_of!("inertia", "inertia_ratio"),
        Rule {
            when: When::Always,
            ways: &[
                way(When::Any(IRREGULAR), IRREGULAR, &[]),
                way(When::Any(&["sides", "circumradius"]), &[], &["sides", "circumradius"]),
                way(When::NoOther, &[], &[]),
            ],
            missing: "",
            help: "a regular prism has sides and circumradius, an irregular one a_to_centre, centre_to_k and height",
        },
    ],
    foreign: &[],
    inherited: &[],
};

/// The keys of an irregular prism.
const IRREGULAR: &[&str] = &["a_to_centre", "centre_to_k", "height"];

static ROD: Table = Table {
    name: "Rod",
    about: "A thin rod on two point supports, A behind its middle and B before it.",
    keys: &[
        IN_PLANE,
        &[
            key("length", Holds::Quantity(LENGTH), "Length of the rod.").or(1.0),
            key(
                "to_a",
                Holds::Quantity(LENGTH),
                "Distance from the middle of the rod to A; a quarter of the length where it is left out.",
            ),
            key(
                "to_b",
                Holds::Quantity(LENGTH),
                "Distance from the middle of the rod to B; a quarter of the length where it is left out.",
            ),
            key(
                "release",
                Holds::Quantity(SLOPE),
                "Angle by which the rod is lifted about A and let go; 10 deg, or 0 with a roll_rate, where it is left out.",
            ),
            key("roll_rate", Holds::Quantity(SPIN), "Roll rate at the start; 0 where it is left out."),
        ],
    ],
    rules: &[one_of!("inertia", "inertia_ratio")],
    foreign: &[],
    inherited: &[],
};

/// How far a rod is lifted whose file does not say it [rad].
pub(crate) const DEFAULT_RELEASE: f64 = PI / 18.0;
