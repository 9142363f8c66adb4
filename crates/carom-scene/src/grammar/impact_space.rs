//! The grammar of impact files in space: keys are those of the plane; what is a pair there, or a moment or a spin, is three numbers.

use super::impact::{
    BETWEEN, BODY_KIND, BODY_NAME, CONTACT_NAME, FREE_OR_FIXED, FRICTIONAL, NO_SECOND_BODY, ROWS,
    SAID_BY_OPERATOR, numbers,
};
use super::kind::{COORDINATE, FRICTION, INERTIA, MASS, NUMBER, RESTITUTION, SPIN, VELOCITY};
use super::scene::LAW;
use super::{Foreign, Holds, Key, Table, Tables, key};
use crate::problem::ProblemKind;

pub(super) static SPACE_FILE: Table = Table {
    name: "ImpactInSpace",
    about: "One free body in space and its contacts.",
    keys: &[&[
        LAW,
        key("body", Holds::Table(&BODY), "The body; its mass centre is the origin.").needed(),
        key("contact", Holds::Tables(&CONTACTS), "The contacts: where the body is touched.")
            .needed_as(CONTACT_MISSING),
    ]],
    rules: &[],
    foreign: &[PLANE_ONLY],
    inherited: &[],
};

pub(super) static SPACE_GROUP_FILE: Table = Table {
    name: "ImpactOfBodiesInSpace",
    about: "Several bodies in space that meet.",
    keys: &[&[
        LAW,
        key("body", Holds::Tables(&BODIES), "The bodies, free, fixed or moved.").needed(),
        key("contact", Holds::Tables(&MEETINGS), "The contacts: where two bodies touch.")
            .needed_as(CONTACT_MISSING),
    ]],
    rules: &[],
    foreign: &[PLANE_ONLY],
    inherited: &[],
};

pub(super) static SPACE_OPERATOR_FILE: Table = Table {
    name: "ImpactByOperatorInSpace",
    about: "The operator alone, in space: each contact has axes of its own.",
    keys: &[&[
        LAW,
        key("operator", Holds::Table(&OPERATOR), "The operator, with the velocities before.").needed(),
    ]],
    rules: &[],
    foreign: &[PLANE_ONLY, SAID_BY_OPERATOR],
    inherited: &[],
};

/// Keys of impacts in the plane, and of contacts under forces.
const PLANE_ONLY: Foreign = Foreign {
    keys: &["sharing", "exponent", "stiffness", "gravity", "force", "torque"],
    kind: ProblemKind::Unsupported,
    message: "is for the plane only, and this impact is in space",
    help: "",
};

const CONTACT_MISSING: &str = "[[contact]] with point, normal and friction, one for each contact";

/// The motion of a body before.
const SPIN_KEY: Key = key("spin", Holds::Vector(SPIN, 3), "Spin before; 0 where it is left out.");

static BODY: Table = Table {
    name: "ImpactBodyInSpace",
    about: "A free body in space, in its principal axes; its mass centre is the origin.",
    keys: &[&[
        key("mass", Holds::Quantity(MASS), "Mass of the body.").needed(),
        key(
            "inertia",
            Holds::Vector(INERTIA, 3),
            "Moments of inertia about the body's principal axes x, y, z.",
        )
        .needed(),
        key("velocity", Holds::Vector(VELOCITY, 3), "Velocity of the mass centre before.").needed(),
        SPIN_KEY,
    ]],
    rules: &[],
    foreign: &[PLANE_ONLY],
    inherited: &[],
};

static BODIES: Tables = Tables::of(&GROUP_BODY, usize::MAX);

static GROUP_BODY: Table = Table {
    name: "MeetingBodyInSpace",
    about: "One of several bodies in space.",
    keys: &[&[
        BODY_NAME,
        BODY_KIND,
        key("mass", Holds::Quantity(MASS), "Mass of a free body."),
        key(
            "inertia",
            Holds::Vector(INERTIA, 3),
            "Moments of inertia of a free body, about its principal axes x, y, z.",
        ),
        key("centre", Holds::Vector(COORDINATE, 3), "Mass centre of the body."),
        key(
            "velocity",
            Holds::Vector(VELOCITY, 3),
            "Velocity of the mass centre before; 0 where it is left out.",
        ),
        SPIN_KEY,
    ]],
    rules: &[FREE_OR_FIXED],
    foreign: &[PLANE_ONLY],
    inherited: &[],
};

static CONTACTS: Tables = Tables::of(&CONTACT, usize::MAX);
static MEETINGS: Tables = Tables::of(&MEETING, usize::MAX);

const TOUCH: &[Key] = &[
    CONTACT_NAME,
    key(
        "point",
        Holds::Vector(COORDINATE, 3),
        "Where the contact is, from the body's mass centre; of several bodies, in the world.",
    )
    .needed(),
    key(
        "normal",
        Holds::Vector(NUMBER, 3),
        "Normal of the contact, out of the obstacle into the body, or out of the second body into the first.",
    )
    .needed(),
];

static CONTACT: Table = Table {
    name: "ImpactContactInSpace",
    about: "A contact of the body with something fixed.",
    keys: &[TOUCH, FRICTIONAL],
    rules: &[],
    foreign: &[NO_SECOND_BODY, PLANE_ONLY],
    inherited: &[],
};

static MEETING: Table = Table {
    name: "MeetingContactInSpace",
    about: "A contact of two bodies.",
    keys: &[TOUCH, FRICTIONAL, &[BETWEEN]],
    rules: &[],
    foreign: &[PLANE_ONLY],
    inherited: &[],
};

static OPERATOR: Table = Table::plain(
    "ManyContactOperatorInSpace",
    "The operator of n contacts in space: three rows for each, tangent 1, tangent 2 and normal.",
    &[&[
        key("matrix", ROWS, "The operator of n contacts, 3 n rows of 3 n numbers [1/kg].").needed(),
        key(
            "velocity",
            Holds::List {
                of: &Holds::Vector(VELOCITY, 3),
                least: 1,
                most: usize::MAX,
                called: "a list [tangent 1, tangent 2, normal] for each contact",
            },
            "Velocity of each contact before: tangent 1, tangent 2, normal.",
        )
        .needed(),
        key(
            "friction",
            numbers!(FRICTION),
            "Coulomb's coefficient of friction of each contact, or one for all.",
        )
        .needed(),
        key(
            "restitution",
            numbers!(RESTITUTION),
            "Coefficient of restitution of each contact, or one for all; 0 where it is left out.",
        ),
    ]],
);
