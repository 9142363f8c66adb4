//! The grammar of impact files in space: keys are those of the plane; what is a pair there, or a moment or a spin, is three numbers.

use super::impact::{
    BETWEEN, CONTACT_NAME, FREE_OR_FIXED, FRICTIONAL, NO_SECOND_BODY, OTHER_FILE, ROWS, SAID_BY_OPERATOR,
    numbers,
};
use super::kind::{COORDINATE, FRICTION, INERTIA, MASS, NUMBER, RESTITUTION, SPIN, VELOCITY};
use super::scene::LAW;
use super::{Holds, Key, Table, Tables, key, words};
use crate::impact_bodies::BodyKind;

pub(super) static SPACE_FILE: Table = Table {
    name: "ImpactInSpace",
    about: "One free body in space and its contacts.",
    keys: &[&[
        LAW,
        key("body", Holds::Table(&BODY), "The body; its mass centre is the origin.").needed(),
        key("contact", Holds::Tables(&CONTACTS), "Where it is touched.").needed_as(CONTACT_MISSING),
    ]],
    rules: &[],
    foreign: &[OTHER_FILE],
    inherited: &[],
};

pub(super) static SPACE_GROUP_FILE: Table = Table {
    name: "ImpactOfBodiesInSpace",
    about: "Several bodies in space that meet.",
    keys: &[&[
        LAW,
        key("body", Holds::Tables(&BODIES), "The bodies, free, fixed or moved.").needed(),
        key("contact", Holds::Tables(&MEETINGS), "Where two of them touch.").needed_as(CONTACT_MISSING),
    ]],
    rules: &[],
    foreign: &[OTHER_FILE],
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
    foreign: &[OTHER_FILE, SAID_BY_OPERATOR],
    inherited: &[],
};

const CONTACT_MISSING: &str = "[[contact]] with point, normal and friction, one for each contact";

/// The motion of a body before.
const SPIN_KEY: Key = key("spin", Holds::Vector(SPIN, 3), "Before; 0 where it is left out.");

static BODY: Table = Table::plain(
    "ImpactBodyInSpace",
    "A free body in space, in its principal axes; its mass centre is the origin.",
    &[&[
        key("mass", Holds::Quantity(MASS), "Of the body.").needed(),
        key("inertia", Holds::Vector(INERTIA, 3), "About its principal axes x, y, z.").needed(),
        key("velocity", Holds::Vector(VELOCITY, 3), "Of its mass centre, before.").needed(),
        SPIN_KEY,
    ]],
);

static BODIES: Tables = Tables::of(&GROUP_BODY, usize::MAX);

static GROUP_BODY: Table = Table {
    name: "MeetingBodyInSpace",
    about: "One of several bodies in space.",
    keys: &[&[
        key("name", Holds::Text, "By which contacts call it."),
        key("kind", Holds::Words(words::<BodyKind>), "Fixed bodies move as they are said to.")
            .or_word("free"),
        key("mass", Holds::Quantity(MASS), "Of a free body."),
        key("inertia", Holds::Vector(INERTIA, 3), "Of a free body, about its principal axes x, y, z."),
        key("centre", Holds::Vector(COORDINATE, 3), "Its mass centre."),
        key("velocity", Holds::Vector(VELOCITY, 3), "Of its mass centre, before; 0 where it is left out."),
        SPIN_KEY,
    ]],
    rules: &[FREE_OR_FIXED],
    foreign: &[],
    inherited: &[],
};

static CONTACTS: Tables = Tables::of(&CONTACT, usize::MAX);
static MEETINGS: Tables = Tables::of(&MEETING, usize::MAX);

const TOUCH: &[Key] = &[
    CONTACT_NAME,
    key(
        "point",
        Holds::Vector(COORDINATE, 3),
        "Where it is, from the body's mass centre; of several bodies, in the world.",
    )
    .needed(),
    key("normal", Holds::Vector(NUMBER, 3), "Out of the obstacle, or out of the second body into the first.")
        .needed(),
];

static CONTACT: Table = Table {
    name: "ImpactContactInSpace",
    about: "A contact of the body with something fixed.",
    keys: &[TOUCH, FRICTIONAL],
    rules: &[],
    foreign: &[NO_SECOND_BODY],
    inherited: &[],
};

static MEETING: Table =
    Table::plain("MeetingContactInSpace", "A contact of two bodies.", &[TOUCH, FRICTIONAL, &[BETWEEN]]);

static OPERATOR: Table = Table::plain(
    "ManyContactOperatorInSpace",
    "The operator of n contacts in space: three rows for each, tangent 1, tangent 2 and normal.",
    &[&[
        key("matrix", ROWS, "3 n rows of 3 n numbers [1/kg].").needed(),
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
        key("friction", numbers!(FRICTION), "Coulomb's coefficient of each, or one of all.").needed(),
        key(
            "restitution",
            numbers!(RESTITUTION),
            "Coefficient of restitution of each, or one of all; 0 where it is left out.",
        ),
    ]],
);
