//! The grammar of impact files: one body and its contacts, several bodies that meet, or the operator alone, in the plane or in space.

use super::check::variant;
use super::impact_space::{SPACE_FILE, SPACE_GROUP_FILE, SPACE_OPERATOR_FILE};
use super::kind::{
    ACCELERATION, APPROACH, COORDINATE, FORCE, FRICTION, INERTIA, MASS, NUMBER, RESTITUTION, SCALE, SPIN,
    TORQUE, VELOCITY,
};
use super::scene::{LAW, way};
use super::{By, File, Foreign, Holds, Key, Rule, Table, Tables, key, words};
use crate::impact_bodies::BodyKind;
use crate::impact_contacts::MOST_PIVOTED;
use crate::impact_file::Convention;
use crate::node::{Node, Value};
use crate::problem::ProblemKind;

pub(crate) static IMPACT: File = File {
    title: IMPACT_TITLE,
    variants: &[
        (By::ListsOfThree("operator", "velocity"), &SPACE_OPERATOR_FILE),
        (By::Has("operator"), &OPERATOR_FILE),
        (By::All(&[IN_SPACE, By::IsList("body")]), &SPACE_GROUP_FILE),
        (IN_SPACE, &SPACE_FILE),
        (By::IsList("body"), &GROUP_FILE),
        (By::Always, &BODY_FILE),
    ],
};

/// A vector has three numbers. Moments and spins are lists in space alone.
const IN_SPACE: By =
    By::InSpace(&[("body", &["inertia", "velocity", "spin", "centre"]), ("contact", &["point", "normal"])]);

/// The same where only the plane is known.
pub(crate) static PLANAR_IMPACT: File = File {
    title: IMPACT_TITLE,
    variants: &[
        (By::Has("operator"), &OPERATOR_FILE),
        (By::IsList("body"), &GROUP_FILE),
        (By::Always, &BODY_FILE),
    ],
};

const IMPACT_TITLE: &str = "carom impact: input";

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

pub(super) const OTHER_FILE: Foreign = Foreign {
    keys: &["part", "plate", "zigzag"],
    kind: ProblemKind::File,
    message: "this is a scene, not an impact",
    help: "`carom run` runs it",
    alone: true,
};

/// How an impact is resolved.
const HOW: &[Key] = &[
    LAW,
    key("sharing", Holds::Words(words::<Convention>), "How contacts that close together share the impact.")
        .or_word("together"),
    key("exponent", Holds::Quantity(SCALE), "Of the springs by which they share by stiffness.").or(1.0),
    GRAVITY,
];
/// Downwards, or a vector.
const GRAVITY: Key = key(
    "gravity",
    Holds::Either(&[Holds::Quantity(ACCELERATION), Holds::Vector(ACCELERATION, 2)]),
    "Downwards, or [gx, gy]; an impact does not ask for it, contacts under forces do.",
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
            key("contact", Holds::Tables(&CONTACTS), "Where it is touched.")
                .needed_as("[[contact]] with point, normal and friction, one for each contact"),
        ],
    ],
    rules: &[],
    foreign: &[OTHER_FILE],
    inherited: &[],
};

static GROUP_FILE: Table = Table {
    name: "ImpactOfBodies",
    about: "Several bodies in the plane that meet.",
    keys: &[
        HOW,
        &[
            key("body", Holds::Tables(&BODIES), "The bodies, free, fixed or moved.").needed(),
            key("contact", Holds::Tables(&MEETINGS), "Where two of them touch.")
                .needed_as("[[contact]] with point, normal, friction and between, one for each contact"),
        ],
    ],
    rules: &[],
    foreign: &[OTHER_FILE],
    inherited: &[],
};

static OPERATOR_FILE: Table = Table {
    name: "ImpactByOperator",
    about: "The operator alone: how velocities at the contacts follow from impulses there, whatever the bodies are.",
    keys: &[
        HOW,
        &[key(
            "operator",
            Holds::Variant(&[(By::Has("matrix"), &MATRIX), (By::Always, &NUMBERS)]),
            "The operator, with the velocities before.",
        )
        .needed()],
    ],
    rules: &[],
    foreign: &[OTHER_FILE, SAID_BY_OPERATOR],
    inherited: &[],
};

pub(super) const SAID_BY_OPERATOR: Foreign = Foreign {
    keys: &["body", "contact"],
    kind: ProblemKind::Conflict,
    message: "does not go together with [operator], which says it all",
    help: "",
    alone: false,
};

static BODY: Table = Table::plain(
    "ImpactBody",
    "A free body in the plane; its mass centre is the origin.",
    &[
        &[
            key("mass", Holds::Quantity(MASS), "Of the body.").needed(),
            key("inertia", Holds::Quantity(INERTIA), "About its mass centre.").needed(),
            key("velocity", Holds::Vector(VELOCITY, 2), "Of its mass centre, before.").needed(),
            key("spin", Holds::Quantity(SPIN), "Before, counter-clockwise.").or(0.0),
            GRAVITY,
        ],
        APPLIED,
    ],
);

/// What is applied to a body; an impact does not ask for it.
const APPLIED: &[Key] = &[
    key("force", Holds::Vector(FORCE, 2), "At its mass centre, besides its weight."),
    key("torque", Holds::Quantity(TORQUE), "On it, counter-clockwise.").or(0.0),
];

static BODIES: Tables = Tables::of(&GROUP_BODY, usize::MAX);

/// A fixed body has no mass, a free one needs it.
pub(super) const FREE_OR_FIXED: Rule = Rule {
    when: By::Always,
    ways: &[
        way(By::Is("kind", "fixed"), &[], &["centre"]),
        way(By::Otherwise, &["mass", "inertia", "centre"], &["kind"]),
    ],
    missing: "",
    help: "",
};

static GROUP_BODY: Table = Table {
    name: "MeetingBody",
    about: "One of several bodies in the plane.",
    keys: &[
        &[
            key("name", Holds::Text, "By which contacts call it."),
            key("kind", Holds::Words(words::<BodyKind>), "Fixed bodies move as they are said to.")
                .or_word("free"),
            key("mass", Holds::Quantity(MASS), "Of a free body."),
            key("inertia", Holds::Quantity(INERTIA), "Of a free body, about its mass centre."),
            key("centre", Holds::Vector(COORDINATE, 2), "Its mass centre."),
            key(
                "velocity",
                Holds::Vector(VELOCITY, 2),
                "Of its mass centre, before; 0 where it is left out.",
            ),
            key("spin", Holds::Quantity(SPIN), "Before, counter-clockwise.").or(0.0),
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
        "Where it is, from the body's mass centre; of several bodies, in the world.",
    )
    .needed(),
    key("normal", Holds::Vector(NUMBER, 2), "Out of the obstacle, or out of the second body into the first.")
        .needed(),
    key(
        "stiffness",
        Holds::Quantity(SCALE),
        "Beside those of the other contacts, where they share by stiffness.",
    )
    .or(1.0),
];
pub(super) const CONTACT_NAME: Key =
    key("name", Holds::Text, "Of the contact; A, B, C … where it is left out.");
pub(super) const FRICTIONAL: &[Key] = &[
    key("friction", Holds::Quantity(FRICTION), "Coulomb's coefficient.").needed(),
    key("restitution", Holds::Quantity(RESTITUTION), "Coefficient of restitution.").or(0.0),
];

/// A contact of one body is with something fixed.
pub(super) const NO_SECOND_BODY: Foreign = Foreign {
    keys: &["between"],
    kind: ProblemKind::Conflict,
    message: "needs several bodies: [[body]] with a name each",
    help: "",
    alone: false,
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
        key("matrix", ROWS, "2 n rows of 2 n numbers [1/kg].").needed(),
        key("velocity", numbers!(VELOCITY), "Slip and normal velocity of each contact, before: 2 n numbers.")
            .needed(),
        key("friction", numbers!(FRICTION), "Coulomb's coefficient of each, or one of all.").needed(),
        key(
            "restitution",
            numbers!(RESTITUTION),
            "Coefficient of restitution of each, or one of all; 0 where it is left out.",
        ),
    ]],
);

pub(super) const ROWS: Holds = Holds::List {
    of: &Holds::List { of: &Holds::Quantity(NUMBER), least: 0, most: usize::MAX, called: "a list" },
    least: 0,
    most: usize::MAX,
    called: "a list of rows [[..], ..]",
};
