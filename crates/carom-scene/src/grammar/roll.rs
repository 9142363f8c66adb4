//! The grammar of roll files, one for each kind of body. Their keys stand in no table.

use super::kind::{
    COUNT, FRICTION, GRAVITY, INERTIA, LENGTH, LENGTH_OR_NONE, MASS, RESTITUTION, SCALE, SLOPE, SPIN, TIME,
    VELOCITY,
};
use super::scene::{LAW, STANDARD_GRAVITY, way};
use super::{By, File, Foreign, Holds, Key, Rule, Table, key};
use crate::problem::ProblemKind;
use std::f64::consts::PI;

/// Mass of a body whose file says none [kg].
pub(crate) const DEFAULT_MASS: f64 = 1.0;
/// Size of a body whose file says none [m]: a hand's width.
pub(crate) const DEFAULT_RADIUS: f64 = 0.1;

/// A file of one table.
pub(super) const fn file(title: &'static str, variants: &'static [(By, &'static Table)]) -> File {
    File { title, variants }
}

pub(crate) static CYLINDER_FILE: File = file("carom roll cylinder: input", &[(By::Always, &CYLINDER)]);
pub(crate) static PRISM_FILE: File = file("carom roll prism: input", &[(By::Always, &PRISM)]);
pub(crate) static ROD_FILE: File = file("carom roll rod: input", &[(By::Always, &ROD)]);

/// What is a scene or an impact.
pub(super) const OTHER_FILE: Foreign = Foreign {
    keys: &["part", "plate", "zigzag", "body", "operator"],
    kind: ProblemKind::File,
    message: "this is no roll file: its keys stand in no table",
    help: "`carom run` runs a scene, `carom impact` resolves an impact",
    alone: true,
};

/// The contacts of a body in the plane, and how long it is followed.
const IN_PLANE: &[Key] = &[
    key(
        "friction",
        Holds::Quantity(FRICTION),
        "Coulomb's coefficient at every contact; where it is left out contacts that keep do not slide.",
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
    key("inertia", Holds::Quantity(INERTIA), "About the mass centre; from the shape where it is left out."),
    key("inertia_ratio", Holds::Quantity(SCALE), "Its ratio to m a², a from the contact to the mass centre."),
];
pub(super) const GRAVITY_KEY: Key =
    key("gravity", Holds::Quantity(GRAVITY), "Downwards.").or(STANDARD_GRAVITY);
pub(super) const TIME_KEY: Key = key(
    "time",
    Holds::Quantity(TIME),
    "How long it is followed at most; as long as a body of its size needs where it is left out.",
);
pub(super) const MASS_KEY: Key = key("mass", Holds::Quantity(MASS), "Of the body.").or(DEFAULT_MASS);
const ROLL_RATE: &str = "Just before the strike, forward where it is above 0.";

/// At most one of two keys.
macro_rules! one_of {
    ($($key:literal),+) => {
        Rule {
            when: By::Always,
            ways: &[$(way(By::Has($key), &[], &[]),)+ way(By::Otherwise, &[], &[])],
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
            key("radius", Holds::Quantity(LENGTH), "Of the disc.").or(DEFAULT_RADIUS),
            key("roll_rate", Holds::Quantity(SPIN), ROLL_RATE).or(10.0),
            key(
                "speed",
                Holds::Quantity(VELOCITY),
                "Of its centre, where it slides before the strike; it rolls where it is left out.",
            ),
            key("gamma", Holds::Quantity(SLOPE), "Half the central angle from A to K.").or(PI / 6.0),
            key("step_height", Holds::Quantity(LENGTH), "Of a step, whose corner is K."),
            key(
                "distance",
                Holds::Quantity(LENGTH_OR_NONE),
                "How far A is before the place of the strike at the start.",
            )
            .or(0.0),
        ],
    ],
    rules: &[one_of!("inertia", "inertia_ratio"), one_of!("gamma", "step_height")],
    foreign: &[OTHER_FILE],
    inherited: &[],
};

static PRISM: Table = Table {
    name: "Prism",
    about: "A prism that turns about its edge A until the next one, K, strikes the plane.",
    keys: &[
        IN_PLANE,
        &[
            key("sides", Holds::Quantity(COUNT), "Of a regular prism, 3 or more.").or(6.0),
            key("circumradius", Holds::Quantity(LENGTH), "Of a regular prism.").or(DEFAULT_RADIUS),
            key(
                "a_to_centre",
                Holds::Quantity(LENGTH),
                "Of an irregular prism: from A to the foot of the mass centre.",
            ),
            key("centre_to_k", Holds::Quantity(LENGTH), "Of an irregular prism: from that foot to K."),
            key(
                "height",
                Holds::Quantity(LENGTH),
                "Of an irregular prism: of the mass centre above its face.",
            ),
            key("roll_rate", Holds::Quantity(SPIN), ROLL_RATE).or(5.0),
            key("slope", Holds::Quantity(SLOPE), "Of the plane, down to +x.").or(0.0),
            key("tilt", Holds::Quantity(SLOPE), "How far the face is from flat at the start.").or(0.0),
        ],
    ],
    rules: &[
        one_of!("inertia", "inertia_ratio"),
        Rule {
            when: By::Always,
            ways: &[
                way(By::Any(IRREGULAR), IRREGULAR, &[]),
                way(By::Any(&["sides", "circumradius"]), &[], &["sides", "circumradius"]),
                way(By::Otherwise, &[], &[]),
            ],
            missing: "",
            help: "a regular prism has sides and circumradius, an irregular one a_to_centre, centre_to_k and height",
        },
    ],
    foreign: &[OTHER_FILE],
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
            key("length", Holds::Quantity(LENGTH), "Of the rod.").or(1.0),
            key(
                "to_a",
                Holds::Quantity(LENGTH),
                "From its middle to A; a quarter of the length where it is left out.",
            ),
            key(
                "to_b",
                Holds::Quantity(LENGTH),
                "From its middle to B; a quarter of the length where it is left out.",
            ),
            key(
                "release",
                Holds::Quantity(SLOPE),
                "It is lifted so far about A and let go; 10 deg, or 0 with a roll_rate, where it is left out.",
            ),
            key("roll_rate", Holds::Quantity(SPIN), "At the start; 0 where it is left out."),
        ],
    ],
    rules: &[one_of!("inertia", "inertia_ratio")],
    foreign: &[OTHER_FILE],
    inherited: &[],
};

/// How far a rod is lifted whose file does not say it [rad].
pub(crate) const DEFAULT_RELEASE: f64 = PI / 18.0;
