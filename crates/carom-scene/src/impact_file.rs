//! One impact to resolve: a free body and its contacts, several bodies that meet, or the operator alone. TOML, or JSON with the same keys.

use crate::drawing::{FRICTION, INERTIA, MASS, RESTITUTION};
use crate::impact_bodies::{Between, Group, read_group};
use crate::impact_contacts::{ImpactContacts, MOST_PIVOTED};
use crate::impact_operator::read_operator;
use crate::node::{Node, Value, from_json, from_toml};
use crate::problem::{Problem, ProblemKind, Problems};
use crate::quantity::{Allowed, Kind};
use crate::read_part::read_law;
use crate::section::{Section, Sink, expected, read_pair};
use crate::unit::Dimension;
use carom_impact::planar::forces::Applied;
use carom_impact::planar::sharing::Sharing;
use carom_impact::planar::{Law, MOST_CONTACTS, Touch};
use carom_num::Vec2;
use std::ops::Range;

pub(crate) const ANY_SPEED: Kind = Kind::new(Dimension::Speed, Allowed::Any);
pub(crate) const ANY_SPIN: Kind = Kind::new(Dimension::Spin, Allowed::Any);
pub(crate) const ANY_LENGTH: Kind = Kind::new(Dimension::Length, Allowed::Any);
pub(crate) const ANY_NUMBER: Kind = Kind::new(Dimension::Number, Allowed::Any);
pub(crate) const ANY_FORCE: Kind = Kind::new(Dimension::Force, Allowed::Any);
pub(crate) const ANY_TORQUE: Kind = Kind::new(Dimension::Torque, Allowed::Any);
const ANY_ACCELERATION: Kind = Kind::new(Dimension::Acceleration, Allowed::Any);
const STIFFNESS: Kind = Kind::new(Dimension::Number, Allowed::Positive);
const EXPONENT: Kind = Kind::new(Dimension::Number, Allowed::Positive);

/// A free planar body that is touched.
///
/// # Example
/// ```
/// # use carom_scene::*;
/// let ball = ImpactProblem::parse("ball.toml", r#"
///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)?;
/// let ImpactBody { mass, velocity, touches, .. } = ball.body.unwrap();
/// assert_eq!((mass, velocity.y, touches[0].arm.y), (2.0, -3.0, -1.0));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactBody {
    /// Mass [kg].
    pub mass: f64,
    /// Moment of inertia about the mass centre [kg m²].
    pub inertia: f64,
    /// Velocity of the mass centre before [m/s].
    pub velocity: Vec2,
    /// Spin before [rad/s].
    pub spin: f64,
    /// Where it is touched; normals are unit vectors.
    pub touches: Vec<Touch>,
}

/// An impact to resolve.
///
/// # Example
/// A contact without a name is called A.
/// ```
/// # use carom_scene::*;
/// let ball = ImpactProblem::parse("ball.toml", r#"
///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)?;
/// assert_eq!((ball.names, ball.contacts.count()), (vec!["A".to_owned()], 1));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactProblem {
    /// Restitution law.
    pub law: Law,
    /// Names of the contacts: A, B, … unless they are given.
    pub names: Vec<String>,
    /// The contacts with their operator.
    pub contacts: ImpactContacts,
    /// The body, where one is described.
    pub body: Option<ImpactBody>,
    /// The bodies, where several are described.
    pub group: Option<Group>,
    /// What is applied to each body, its weight included; an impact does not ask for it.
    pub applied: Vec<Applied>,
    /// How contacts that close together share the impact.
    pub sharing: Sharing<MOST_CONTACTS>,
    /// The springs that sharing by stiffness is asked with, whether or not it is how they share.
    pub by_stiffness: Sharing<MOST_CONTACTS>,
}

impl ImpactProblem {
    /// Reads the TOML text of an impact; `file` is the name its problems are reported under.
    ///
    /// # Errors
    /// Every problem found.
    ///
    /// # Example
    /// A mass of a ball in grams.
    /// ```
    /// # use carom_scene::*;
    /// let ball = ImpactProblem::parse("ball.toml", r#"
    ///     body = { mass = "250 g", inertia = 0.4, velocity = [0, -3] }
    ///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3 }]
    /// "#)?;
    /// assert_eq!(ball.body.unwrap().mass, 0.25);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn parse(file: &str, source: &str) -> Result<Self, Problems> {
        let fail = |list| Problems::new(file, source, list);
        let (tree, syntax) = from_toml(source);
        if syntax.is_empty() { read(&tree).map_err(fail) } else { Err(fail(syntax)) }
    }

    /// Reads one JSON text with the same keys.
    ///
    /// # Errors
    /// Every problem found.
    ///
    /// # Example
    /// The same keys.
    /// ```
    /// # use carom_scene::*;
    /// let ball = ImpactProblem::parse("ball.toml", r#"
    ///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
    ///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
    /// "#)?;
    /// let json = r#"{ "body": { "mass": 2, "inertia": 0.4, "velocity": [0, -3] },
    ///     "contact": [{ "point": [0, -1], "normal": [0, 1], "friction": 0.3, "restitution": 0.5 }] }"#;
    /// assert_eq!(ImpactProblem::parse_json("ball.json", json)?, ball);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn parse_json(file: &str, source: &str) -> Result<Self, Problems> {
        let fail = |mut list: Vec<Problem>| {
            // One line of numbers is no picture: the path says where.
            list.iter_mut().for_each(|problem| problem.span = None);
            Problems::new(file, source, list)
        };
        let tree = from_json(source).map_err(|problem| fail(vec![problem]))?;
        read(&tree).map_err(fail)
    }
}

pub(crate) fn read(tree: &Node) -> Result<ImpactProblem, Vec<Problem>> {
    let sink = Sink::default();
    let Some(root) = Section::new("", tree, &sink) else { return Err(sink.into_list()) };
    if let Some(key) = ["part", "plate", "zigzag"].into_iter().find(|key| root.has(key)) {
        let message = "this is a scene, not an impact";
        let problem = Problem::new(ProblemKind::File, key, message, Some(root.key_span(key)));
        return Err(vec![problem.with_help("`carom run` runs it")]);
    }
    let found = read_problem(&root);
    root.get("operator");
    root.finish();
    let problems = sink.into_list();
    match found {
        Some(found) if problems.is_empty() => Ok(found),
        _ => Err(problems),
    }
}

fn read_problem(root: &Section<'_>) -> Option<ImpactProblem> {
    let law = read_law(root);
    let asked = read_sharing(root);
    let gravity = read_gravity(root);
    let mut springs = [1.0; MOST_CONTACTS];
    let found = if root.has("operator") {
        for key in ["body", "contact"] {
            if root.has(key) {
                root.get(key);
                let message = "does not go together with [operator], which says it all";
                let span = Some(root.key_span(key));
                root.sink().push(Problem::new(ProblemKind::Conflict, key, message, span));
            }
        }
        read_operator(root).map(|(names, contacts)| Struck {
            names,
            contacts,
            body: None,
            group: None,
            applied: vec![],
        })
    } else {
        let list = read_contacts(root);
        for (k, contact) in springs.iter_mut().zip(&list) {
            *k = contact.stiffness;
        }
        if matches!(root.get("body").map(|node| &node.value), Some(Value::List(_))) {
            read_group(root, &list, gravity).map(|(names, group, contacts, applied)| Struck {
                names,
                contacts,
                body: None,
                group: Some(group),
                applied,
            })
        } else {
            read_body(root, &list, gravity)
        }
    };
    let Struck { names, contacts, body, group, applied } = found?;
    let by_stiffness = Sharing::ByStiffness { stiffness: springs, exponent: asked.exponent };
    let sharing = match asked.word {
        Some(Shared::InSequence) => Sharing::InSequence,
        Some(Shared::ByStiffness) => by_stiffness,
        Some(Shared::Together) | None => Sharing::Together,
    };
    if contacts.count() > MOST_CONTACTS && sharing != Sharing::Together {
        let message = format!("is for up to {MOST_CONTACTS} contacts, found {}", contacts.count());
        let span = Some(root.key_span("sharing"));
        let problem = Problem::new(ProblemKind::Conflict, "sharing", message, span);
        root.sink().push(problem.with_help("more share as \"together\" says"));
    }
    Some(ImpactProblem { law, names, contacts, body, group, applied, sharing, by_stiffness })
}

/// What is struck, and where.
struct Struck {
    names: Vec<String>,
    contacts: ImpactContacts,
    body: Option<ImpactBody>,
    group: Option<Group>,
    applied: Vec<Applied>,
}

/// Gravity, downwards or as a list [gx, gy]; none where it is not written.
fn read_gravity(section: &Section<'_>) -> Option<Vec2> {
    let node = section.get("gravity")?;
    if let Value::List(_) = &node.value {
        let [x, y] = read_pair(&section.path_of("gravity"), node, ANY_ACCELERATION, section.sink())?;
        return Some(Vec2::new(x.value, y.value));
    }
    let down = section.quantity("gravity", ANY_ACCELERATION)?;
    Some(Vec2::new(0.0, -down.value))
}

/// What is applied to a body of this mass: `force`, `torque` and its weight.
pub(crate) fn read_applied(section: &Section<'_>, gravity: Option<Vec2>, mass: Option<f64>) -> Applied {
    let force = section.pair("force", ANY_FORCE).map_or(Vec2::ZERO, |[x, y]| Vec2::new(x.value, y.value));
    let torque = section.quantity("torque", ANY_TORQUE).map_or(0.0, |torque| torque.value);
    let weight = gravity.zip(mass.filter(|mass| mass.is_finite())).map_or(Vec2::ZERO, |(g, mass)| g * mass);
    Applied { force: force + weight, torque }
}

/// How an impact is to be shared, as it is written.
struct AskedSharing {
    word: Option<Shared>,
    exponent: f64,
}

fn read_sharing(root: &Section<'_>) -> AskedSharing {
    let word = root.word("sharing", &SHARING_WORDS);
    let exponent = root.quantity("exponent", EXPONENT).map_or(1.0, |e| e.value);
    AskedSharing { word, exponent }
}

#[derive(Clone, Copy)]
enum Shared {
    Together,
    InSequence,
    ByStiffness,
}

const SHARING_WORDS: [(&str, Shared); 3] = [
    ("together", Shared::Together),
    ("in sequence", Shared::InSequence),
    ("by stiffness", Shared::ByStiffness),
];

/// A contact as it is written: also one with problems keeps its name and what it is between.
pub(crate) struct ReadContact {
    pub(crate) name: String,
    /// Its arm is the point as it is written; `None` where a part of it cannot be read.
    pub(crate) touch: Option<Touch>,
    stiffness: f64,
    /// `between = [into, out_of]`, where it is said, and its place.
    pub(crate) between: Option<Between>,
    /// Path and place of the contact.
    pub(crate) path: String,
    pub(crate) span: Range<usize>,
}

/// The contacts; none where they are too many.
fn read_contacts(root: &Section<'_>) -> Vec<ReadContact> {
    if !root.has("contact") {
        root.missing("contact", "[[contact]] with point, normal and friction, one for each contact");
    }
    let contacts = root.sections("contact");
    if contacts.len() > MOST_PIVOTED {
        let message =
            format!("at most {MOST_PIVOTED} contacts are resolved at once, found {}", contacts.len());
        let span = Some(root.key_span("contact"));
        root.sink().push(Problem::new(ProblemKind::OutOfRange, "contact", message, span));
    }
    let too_many = contacts.len() > MOST_PIVOTED;
    let list: Vec<ReadContact> = contacts.into_iter().enumerate().map(read_contact).collect();
    for (i, contact) in list.iter().enumerate() {
        if list[..i].iter().any(|other| other.name == contact.name) {
            let message = format!("two contacts are called {:?}", contact.name);
            let (path, span) = (format!("{}.name", contact.path), Some(contact.span.clone()));
            root.sink().push(Problem::new(ProblemKind::Conflict, path, message, span));
        }
    }
    if too_many { vec![] } else { list }
}

fn read_body(root: &Section<'_>, list: &[ReadContact], gravity: Option<Vec2>) -> Option<Struck> {
    if !root.has("body") {
        root.missing("body", "a table [body] with mass, inertia, velocity and spin; or [operator]");
    }
    let section = root.section("body")?;
    let (mass, inertia) = (section.required("mass", MASS), section.required("inertia", INERTIA));
    if !section.has("velocity") {
        section.missing("velocity", "a list [vx, vy]");
    }
    let velocity = section.pair("velocity", ANY_SPEED);
    let spin = section.quantity("spin", ANY_SPIN);
    let gravity = read_gravity(&section).or(gravity);
    let applied = vec![read_applied(&section, gravity, mass.as_ref().map(|mass| mass.value))];
    section.finish();
    for contact in list {
        if let Some((_, span)) = &contact.between {
            let message = "needs several bodies: [[body]] with a name each";
            let path = format!("{}.between", contact.path);
            root.sink().push(Problem::new(ProblemKind::Conflict, path, message, Some(span.clone())));
        }
    }
    let touches: Vec<Touch> = list.iter().map(|contact| contact.touch).collect::<Option<_>>()?;
    if touches.is_empty() {
        return None;
    }
    let names = list.iter().map(|contact| contact.name.clone()).collect();
    let ([vx, vy], spin) = (velocity?, spin.map_or(0.0, |spin| spin.value));
    let (mass, inertia) = (mass?.value, inertia?.value);
    let velocity = Vec2::new(vx.value, vy.value);
    let contacts = ImpactContacts::of_free_body(mass, inertia, (velocity, spin), &touches).ok()?;
    let body = ImpactBody { mass, inertia, velocity, spin, touches };
    Some(Struck { names, contacts, body: Some(body), group: None, applied })
}

fn read_contact((number, section): (usize, Section<'_>)) -> ReadContact {
    let name = section.text("name").map_or_else(|| letter(number), |(name, _)| name.to_owned());
    for key in ["point", "normal"] {
        if !section.has(key) {
            section.missing(key, "a list [x, y]");
        }
    }
    let point = section.pair("point", ANY_LENGTH);
    let normal = section.get("normal").and_then(|node| {
        let path = section.path_of("normal");
        let [x, y] = read_pair(&path, node, ANY_NUMBER, section.sink())?;
        let unit = Vec2::new(x.value, y.value).unit();
        if unit.is_none() {
            let message = "has no direction: it must not be zero";
            let span = Some(node.span.clone());
            section.sink().push(Problem::new(ProblemKind::Geometry, path, message, span));
        }
        unit
    });
    let friction = section.required("friction", FRICTION);
    let restitution = section.quantity("restitution", RESTITUTION);
    let stiffness = section.quantity("stiffness", STIFFNESS);
    let between = section.get("between").and_then(|node| read_between(&section, node));
    let (path, span) = (section.path().to_owned(), section.span());
    section.finish();
    let touch = point.zip(normal).zip(friction).map(|(([x, y], normal), friction)| Touch {
        arm: Vec2::new(x.value, y.value),
        normal,
        friction: friction.value,
        restitution: restitution.map_or(0.0, |restitution| restitution.value),
    });
    ReadContact { name, touch, stiffness: stiffness.map_or(1.0, |k| k.value), between, path, span }
}

pub(crate) fn read_between(section: &Section<'_>, node: &Node) -> Option<Between> {
    let items: &[Node] = if let Value::List(items) = &node.value { items } else { &[] };
    let words = items.iter().map(|item| match &item.value {
        Value::Text(text) => Some(text.clone()),
        _ => None,
    });
    let words: Option<Vec<String>> = words.collect();
    match words.and_then(|words| <[String; 2]>::try_from(words).ok()) {
        Some(pair) => Some((pair, node.span.clone())),
        None => {
            let what = "two names [into, out_of]: the normal points out of the second body into the first";
            section.sink().push(expected(what, &section.path_of("between"), node));
            None
        }
    }
}

/// A, B, C …
pub(crate) fn letter(number: usize) -> String {
    char::from(b'A' + (number % 26) as u8).to_string()
}
