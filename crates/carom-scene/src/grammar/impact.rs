//! The grammar of impact files: one body and its contacts, several bodies that meet, or the operator alone, in the plane or in space.

use super::check::variant;
use super::impact_space::{SPACE_FILE, SPACE_GROUP_FILE, SPACE_OPERATOR_FILE};
use super::kind::{
    ACCELERATION, APPROACH, COORDINATE, FORCE, FRICTION, INERTIA, MASS, NUMBER, RESTITUTION, SCALE, SPIN,
    TORQUE, VELOCITY,
};
use super::scene::{LAW, way};
use super::{File, FileKind, Foreign, Holds, Key, Rule, Table, Tables, When, key};
use crate::impact_bodies::BodyKind;
use crate::impact_contacts::MOST_PIVOTED;
use crate::impact_file::Convention;
use crate::node::{Node, Value};
use crate::problem::ProblemKind;
use carom_words::Words;

pub(crate) static IMPACT: File = File {
    kind: FileKind::Impact,
    title: "carom impact: input",
    variants: &[
        (When::ListsOfThree("operator", "velocity"), &SPACE_OPERATOR_FILE),
        (When::Has("operator"), &OPERATOR_FILE),
        (When::All(&[IN_SPACE, When::IsList("body")]), &SPACE_GROUP_FILE),
        (IN_SPACE, &SPACE_FILE),
        (When::IsList("body"), &GROUP_FILE),
        (When::Always, &BODY_FILE),
    ],
};

/// Most vectors have three numbers. Moments and spins are lists in space alone.
const IN_SPACE: When =
    When::InSpace(&[("body", &["inertia", "velocity", "spin", "centre"]), ("contact", &["point", "normal"])]);

/// True for an impact in space.
pub(crate) fn is_in_space(tree: &Node) -> bool {
    match &tree.value {
        Value::Table(entries) => {
            let table = variant(IMPACT.variants, entries);
            [&SPACE_FILE, &SPACE_GROUP_FILE, &SPACE_OPERATOR_FILE].iter().any(|one| std::ptr::eq(*one, table))
        }
        _ => false,
    }
}

/// How an impact is resolved.
const HOW: &[Key] = &[
    LAW,
    key("sharing", Holds::Words(Convention::words), "How contacts that close together share the impact.")
        .or_word("together"),
    key("exponent", Holds::Quantity(SCALE), "Exponent of the springs, where contacts share by stiffness.")
        .or(1.0),
    GRAVITY,
];
/// Downwards, or a vector.
const GRAVITY: Key = key(
    "gravity",
    Holds::Either(&[Holds::Quantity(ACCELERATION), Holds::Vector(ACCELERATION, 2)]),
    "Gravity, downwards, or [gx, gy]. An impact does not ask for it, contacts under forces do.",
);

/// A quantity, or a list of quantities.
macro_rules! numbers {
    ($kind:expr) => {
        Holds::Either(&[
            Holds::Quantity($kind),
            Holds::List { of: &Holds::Quantity($kind), least: 0, most: usize::MAX, called: "a list" },
        ])
    };
}
pub(super) use numbers;

static BODY_FILE: Table = Table {
    name: "ImpactOfABody",
    about: "One free body in the plane and its contacts.",
    keys: &[
        HOW,
        &[
            key("body", Holds::Table(&BODY), "The body; its mass centre is the origin.")
                .needed_as("a table [body] with mass, inertia, velocity and spin; or [operator]"),
            key("contact", Holds::Tables(&CONTACTS), "The contacts: where the body is touched.")
                .needed_as("[[contact]] with point, normal and friction, one for each contact"),
        ],
    ],
    rules: &[],
    foreign: &[],
    inherited: &[],
};

static GROUP_FILE: Table = Table {
    name: "ImpactOfBodies",
    about: "Several bodies in the plane that meet.",
    keys: &[
        HOW,
        &[
            key("body", Holds::Tables(&BODIES), "The bodies, free, fixed or moved.").needed(),
            key("contact", Holds::Tables(&MEETINGS), "The contacts: where two bodies touch.")
                .needed_as("[[contact]] with point, normal, friction and between, one for each contact"),
        ],
    ],
    rules: &[],
    foreign: &[],
    inherited: &[],
};

static OPERATOR_FILE: Table = Table {
    name: "ImpactByOperator",
    about: "The operator alone: how velocities at the contacts follow from impulses there, whatever the bodies are.",
    keys: &[
        HOW,
        &[key(
            "operator",
            Holds::Variant(&[(When::Has("matrix"), &MATRIX), (When::Always, &NUMBERS)]),
            "The operator, with the velocities before.",
        )
        .needed()],
    ],
    rules: &[],
    foreign: &[SAID_BY_OPERATOR],
    inherited: &[],
};

pub(super) const SAID_BY_OPERATOR: Foreign = Foreign {
    keys: &["body", "contact"],
    kind: ProblemKind::Conflict,
    message: "does not go together with [operator], which says it all",
    help: "",
};

static BODY: Table = Table::plain(
    "ImpactBody",
    "A free body in the plane; its mass centre is the origin.",
    &[
        &[
            key("mass", Holds::Quantity(MASS), "Mass of the body.").needed(),
            key("inertia", Holds::Quantity(INERTIA), "Moment of inertia about the body's mass centre.")
                .needed(),
            key("velocity", Holds::Vector(VELOCITY, 2), "Velocity of the mass centre before.").needed(),
            key("spin", Holds::Quantity(SPIN), "Spin before, counter-clockwise.").or(0.0),
            GRAVITY,
        ],
        APPLIED,
    ],
);

/// What is applied to a body; an impact does not ask for it.
const APPLIED: &[Key] = &[
    key("force", Holds::Vector(FORCE, 2), "Force at the mass centre, beside the weight."),
    key("torque", Holds::Quantity(TORQUE), "Torque on the body, counter-clockwise.").or(0.0),
];

static BODIES: Tables = Tables::of(&GROUP_BODY, usize::MAX);

/// A fixed body has no mass, a free one needs it.
pub(super) const FREE_OR_FIXED: Rule = Rule {
    when: When::Always,
    ways: &[
        way(When::Is("kind", "fixed"), &[], &["centre"]),
        way(When::NoOther, &["mass", "inertia", "centre"], &["kind"]),
    ],
    missing: "",
    help: "",
};

/// Keys that each of several bodies has, in the plane and in space.
pub(super) const BODY_NAME: Key = key("name", Holds::Text, "Name, by which contacts call the body.");
pub(super) const BODY_KIND: Key = key(
    "kind",
    Holds::Words(BodyKind::words),
    "Whether impulses move the body. A fixed one moves on as it is.",
)
.or_word("free");

static GROUP_BODY: Table = Table {
    name: "MeetingBody",
    about: "One of several bodies in the plane.",
    keys: &[
        &[
            BODY_NAME,
            BODY_KIND,
            key("mass", Holds::Quantity(MASS), "Mass of a free body."),
            key(
                "inertia",
                Holds::Quantity(INERTIA),
                "Moment of inertia of a free body, about its mass centre.",
            ),
            key("centre", Holds::Vector(COORDINATE, 2), "Mass centre of the body."),
            key(
                "velocity",
                Holds::Vector(VELOCITY, 2),
                "Velocity of the mass centre before; 0 where it is left out.",
            ),
            key("spin", Holds::Quantity(SPIN), "Spin before, counter-clockwise.").or(0.0),
        ],
        APPLIED,
    ],
    rules: &[FREE_OR_FIXED],
    foreign: &[],
    inherited: &[],
};

static CONTACTS: Tables = Tables::of(&CONTACT, MOST_PIVOTED);
static MEETINGS: Tables = Tables::of(&MEETING, MOST_PIVOTED);

const TOUCH: &[Key] = &[
    CONTACT_NAME,
    key(
        "point",
        Holds::Vector(COORDINATE, 2),
        "Where the contact is, from the body's mass centre; of several bodies, in the world.",
    )
    .needed(),
    key(
        "normal",
        Holds::Vector(NUMBER, 2),
        "Normal of the contact, out of the obstacle into the body, or out of the second body into the first.",
    )
    .needed(),
    key(
        "stiffness",
        Holds::Quantity(SCALE),
        "Stiffness beside those of the other contacts, where they share by stiffness.",
    )
    .or(1.0),
];
pub(super) const CONTACT_NAME: Key =
    key("name", Holds::Text, "Name of the contact; A, B, C … where it is left out.");
pub(super) const FRICTIONAL: &[Key] = &[
    key("friction", Holds::Quantity(FRICTION), "Coulomb's coefficient of friction.").needed(),
    key("restitution", Holds::Quantity(RESTITUTION), "Coefficient of restitution.").or(0.0),
];

/// A contact of one body is with something fixed.
pub(super) const NO_SECOND_BODY: Foreign = Foreign {
    keys: &["between"],
    kind: ProblemKind::Conflict,
    message: "needs several bodies: [[body]] with a name each",
    help: "",
};

static CONTACT: Table = Table {
    name: "ImpactContact",
    about: "A contact of the body with something fixed.",
    keys: &[TOUCH, FRICTIONAL],
    rules: &[],
    foreign: &[NO_SECOND_BODY],
    inherited: &[],
};

/// Which two bodies a contact is between.
pub(super) const BETWEEN: Key = key(
    "between",
    Holds::List {
        of: &Holds::Text,
        least: 2,
        most: 2,
        called: "two names [into, out_of]: the normal points out of the second body into the first",
    },
    "The two bodies: the normal points out of the second into the first.",
)
.needed();

static MEETING: Table =
    Table::plain("MeetingContact", "A contact of two bodies.", &[TOUCH, FRICTIONAL, &[BETWEEN]]);

static NUMBERS: Table = Table::plain(
    "OneContactOperator",
    "The operator of one contact.",
    &[
        &[
            key("w_tt", Holds::Quantity(SCALE), "Tangential velocity of a tangential unit impulse [1/kg].")
                .needed(),
            key("w_tn", Holds::Quantity(NUMBER), "Tangential velocity of a normal unit impulse [1/kg].")
                .needed(),
            key("w_nn", Holds::Quantity(SCALE), "Normal velocity of a normal unit impulse [1/kg].").needed(),
            key("slip", Holds::Quantity(VELOCITY), "Tangential velocity before.").needed(),
            key("approach", Holds::Quantity(APPROACH), "Normal velocity before.").needed(),
        ],
        FRICTIONAL,
    ],
);

static MATRIX: Table = Table::plain(
    "ManyContactOperator",
    "The operator of n contacts: two rows for each, tangential and normal.",
    &[&[
        key("matrix", ROWS, "The operator of n contacts, 2 n rows of 2 n numbers [1/kg].").needed(),
        key("velocity", numbers!(VELOCITY), "Slip and normal velocity of each contact, before: 2 n numbers.")
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

pub(super) const ROWS: Holds = Holds::List {
    of: &Holds::List { of: &Holds::Quantity(NUMBER), least: 0, most: usize::MAX, called: "a list" },
    least: 0,
    most: usize::MAX,
    called: "a list of rows [[..], ..]",
};
