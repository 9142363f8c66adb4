//! One impact to resolve: a free body and its contacts, several bodies that meet, or the operator alone. TOML, or JSON with the same keys.

use crate::grammar::{Section, impact::PLANAR_IMPACT, read_checked};
use crate::impact_bodies::{Between, Group, read_group};
use crate::impact_contacts::{ImpactContacts, MOST_PIVOTED};
use crate::impact_operator::read_operator;
use crate::node::{Node, Value, from_json, from_toml};
use crate::problem::{Problem, ProblemKind, Problems};
use crate::quantity::Quantity;
use carom_impact::planar::forces::Applied;
use carom_impact::planar::sharing::Sharing;
use carom_impact::planar::{Law, MOST_CONTACTS, Touch};
use carom_num::Vec2;
use std::collections::BTreeSet;
use std::ops::Range;

/// A free planar body that is touched.
///
/// # Example
/// ```
/// use carom_scene::*;
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
/// use carom_scene::*;
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
    /// use carom_scene::*;
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
    read_checked(&PLANAR_IMPACT, tree, read_problem)
}

fn read_problem(root: &Section<'_>) -> Option<ImpactProblem> {
    let law = root.word_or_default("law");
    let gravity = read_gravity(root);
    let mut springs = [1.0; MOST_CONTACTS];
    let found = if root.has("operator") {
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
    // The springs are kept whatever sharing is asked for: the answer says what sharing by stiffness would give.
    let Struck { names, contacts, body, group, applied } = found?;
    let by_stiffness = Sharing::ByStiffness { stiffness: springs, exponent: root.number("exponent") };
    let sharing = match root.word_or_default("sharing") {
        Convention::InSequence => Sharing::InSequence,
        Convention::ByStiffness => by_stiffness,
        Convention::Together => Sharing::Together,
    };
    if contacts.count() > MOST_CONTACTS && sharing != Sharing::Together {
        let message = format!("is for up to {MOST_CONTACTS} contacts, found {}", contacts.count());
        let span = Some(root.key_span("sharing"));
        let problem = Problem::new(ProblemKind::Conflict, "sharing", message, span);
        root.push(problem.with_help("more share as \"together\" says"));
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
    match section.get("gravity")?.value {
        Value::List(_) => section.vector("gravity").map(vector),
        _ => section.value("gravity").map(|down| Vec2::new(0.0, -down)),
    }
}

/// A vector, SI.
pub(crate) fn vector([x, y]: [Quantity; 2]) -> Vec2 {
    Vec2::new(x.value, y.value)
}

/// What is applied to a body of this mass: `force`, `torque` and its weight.
pub(crate) fn read_applied(section: &Section<'_>, gravity: Option<Vec2>, mass: Option<f64>) -> Applied {
    let force = section.vector("force").map_or(Vec2::ZERO, vector);
    let weight = gravity.zip(mass.filter(|mass| mass.is_finite())).map_or(Vec2::ZERO, |(g, mass)| g * mass);
    Applied { force: force + weight, torque: section.number("torque") }
}

/// A convention on how contacts that close together share an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Convention {
    /// All at once, as the stages of the walk say.
    Together,
    /// One after the other, the fastest first.
    InSequence,
    /// As springs, by the ratios of their stiffnesses.
    ByStiffness,
}

carom_words::words! {
    Convention {
        Together = "together",
        InSequence = "in sequence",
        ByStiffness = "by stiffness",
    }
}

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
    let contacts = root.sections("contact");
    let too_many = contacts.len() > MOST_PIVOTED;
    let list: Vec<ReadContact> = contacts.into_iter().flatten().enumerate().map(read_contact).collect();
    tell_twins(root, list.iter().map(|contact| (&*contact.name, &*contact.path, &contact.span)));
    if too_many { vec![] } else { list }
}

fn read_body(root: &Section<'_>, list: &[ReadContact], gravity: Option<Vec2>) -> Option<Struck> {
    let section = root.section("body")?;
    let (mass, inertia) = (section.value("mass"), section.value("inertia"));
    let gravity = read_gravity(&section).or(gravity);
    let applied = vec![read_applied(&section, gravity, mass)];
    let touches: Vec<Touch> = list.iter().map(|contact| contact.touch).collect::<Option<_>>()?;
    if touches.is_empty() {
        return None;
    }
    let names = list.iter().map(|contact| contact.name.clone()).collect();
    let (velocity, spin) = (vector(section.vector("velocity")?), section.number("spin"));
    let (mass, inertia) = (mass?, inertia?);
    let contacts = ImpactContacts::of_free_body(mass, inertia, (velocity, spin), &touches).ok()?;
    let body = ImpactBody { mass, inertia, velocity, spin, touches };
    Some(Struck { names, contacts, body: Some(body), group: None, applied })
}

fn read_contact((number, section): (usize, Section<'_>)) -> ReadContact {
    let name = section.text("name").map_or_else(|| letter(number), |(name, _)| name.to_owned());
    let normal = section.vector("normal").and_then(|normal| {
        let unit = vector(normal).unit();
        if unit.is_none() {
            section.blame_value(ProblemKind::Geometry, "normal", "has no direction: it must not be zero");
        }
        unit
    });
    let touch = section.vector("point").zip(normal).zip(section.value("friction"));
    let touch = touch.map(|((point, normal), friction)| Touch {
        arm: vector(point),
        normal,
        friction,
        restitution: section.number("restitution"),
    });
    let between = read_between(&section);
    let stiffness = section.number("stiffness");
    ReadContact { name, touch, stiffness, between, path: section.path().to_owned(), span: section.span() }
}

/// Says which contacts have one name; of each its name, its path and its place.
pub(crate) fn tell_twins<'c>(
    root: &Section<'_>,
    contacts: impl Iterator<Item = (&'c str, &'c str, &'c Range<usize>)>,
) {
    let mut names = BTreeSet::new();
    for (name, path, span) in contacts {
        if !names.insert(name) {
            let message = format!("two contacts are called {name:?}");
            root.push(Problem::new(ProblemKind::Name, format!("{path}.name"), message, Some(span.clone())));
        }
    }
}

/// The two bodies that a contact is between.
pub(crate) fn read_between(section: &Section<'_>) -> Option<Between> {
    let node = section.get("between")?;
    let Value::List(items) = &node.value else { return None };
    let name = |item: &Node| match &item.value {
        Value::Text(text) => Some(text.clone()),
        _ => None,
    };
    let names: [String; 2] = items.iter().map(name).collect::<Option<Vec<String>>>()?.try_into().ok()?;
    Some((names, node.span.clone()))
}

/// A, B, C …
pub(crate) fn letter(number: usize) -> String {
    char::from(b'A' + (number % 26) as u8).to_string()
}
