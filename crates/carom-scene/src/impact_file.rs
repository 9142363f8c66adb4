//! One impact to resolve: a free body and its contacts, several bodies that meet, or the operator alone. TOML, or JSON with the same keys.

use crate::grammar::impact::{IMPACT, is_in_space};
use crate::grammar::{Section, read_checked};
use crate::impact_bodies::{Group, read_group};
use crate::impact_contacts::{ImpactContacts, MOST_PIVOTED};
use crate::impact_operator::read_operator;
use crate::impact_touch::{ReadContact, ReadTouch, letter, read_contacts};
use crate::node::{Node, Value, from_json, from_toml};
use crate::problem::{Problem, ProblemKind, Problems};
use crate::quantity::Quantity;
use carom_impact::planar::forces::Applied;
use carom_impact::planar::sharing::Sharing;
use carom_impact::planar::{MOST_CONTACTS, Touch};
use carom_impact::{ImpactError, Law};
use carom_num::Vec2;
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
    /// Where the contacts are written.
    pub places: ContactPlaces,
}

/// Where the contacts of an impact are written, for problems that show only when it is asked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactPlaces {
    /// The text of the file; empty where there is none.
    pub source: String,
    /// The place of each contact in it; empty where the operator is given, or there is no text.
    pub contacts: Vec<Range<usize>>,
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
        if syntax.is_empty() { read(&tree, source).map_err(fail) } else { Err(fail(syntax)) }
    }

    /// The impact of one body that a program has in numbers: contacts that close together share it at once.
    ///
    /// # Errors
    /// Too many contacts, or numbers that overflow. Whether numbers are what a file may have is not asked.
    ///
    /// # Example
    /// ```
    /// use carom_scene::*;
    /// let ball = ImpactProblem::parse("ball.toml", r#"
    ///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
    ///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
    /// "#)?;
    /// let again = ImpactProblem::of_body(ball.law, ball.body.clone().unwrap()).unwrap();
    /// assert_eq!((again.solve(), again.names), (ball.solve(), ball.names));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn of_body(law: Law, body: ImpactBody) -> Result<Self, ImpactError> {
        let ImpactBody { mass, inertia, velocity, spin, touches } = &body;
        let contacts = ImpactContacts::of_free_body(*mass, *inertia, (*velocity, *spin), touches)?;
        let names = (0..touches.len()).map(letter).collect();
        Ok(Self {
            law,
            names,
            contacts,
            body: Some(body),
            group: None,
            applied: vec![Applied::default()],
            sharing: Sharing::Together,
            by_stiffness: Sharing::ByStiffness { stiffness: [1.0; MOST_CONTACTS], exponent: 1.0 },
            places: ContactPlaces::default(),
        })
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
        let tree = from_json(source).map_err(fail)?;
        read(&tree, "").map_err(fail)
    }
}

/// Reads an impact in the plane from the tree of a text; the text is empty where places in it say nothing.
pub(crate) fn read(tree: &Node, source: &str) -> Result<ImpactProblem, Vec<Problem>> {
    if let Some(problem) = in_space(tree) {
        return Err(vec![problem]);
    }
    let problem = read_checked(&IMPACT, tree, read_problem)?;
    let contacts = if source.is_empty() { vec![] } else { problem.places.contacts };
    Ok(ImpactProblem { places: ContactPlaces { source: source.to_owned(), contacts }, ..problem })
}

/// That an impact is in space, where it is asked for in the plane.
fn in_space(tree: &Node) -> Option<Problem> {
    let Value::Table(entries) = &tree.value else { return None };
    let shows = entries.iter().find(|entry| ["body", "operator"].contains(&entry.key.as_str()))?;
    let message =
        "the impact is in space, with vectors of three numbers: this is asked for in the plane only";
    let (path, place) = (shows.key.as_str(), Some(shows.key_span.clone()));
    let problem =
        Problem::new(ProblemKind::File, path, message, place).with_help("`carom impact` resolves it");
    is_in_space(tree).then_some(problem)
}

fn read_problem(root: &Section<'_>) -> Option<ImpactProblem> {
    let law = root.word_or_default("law");
    let gravity = read_gravity(root);
    let (list, springs) = read_all_contacts(root);
    let found = if root.has("operator") {
        read_operator(root).map(|(names, contacts)| Struck {
            names,
            contacts,
            body: None,
            group: None,
            applied: vec![],
        })
    } else if matches!(root.get("body").map(|node| &node.value), Some(Value::List(_))) {
        read_group(root, &list, gravity).map(|(names, group, contacts, applied)| Struck {
            names,
            contacts,
            body: None,
            group: Some(group),
            applied,
        })
    } else {
        read_body(root, &list, gravity)
    };
    // The springs are kept whatever sharing is asked for: the answer says what sharing by stiffness would give.
    let Struck { names, contacts, body, group, applied } = found?;
    let places = list.iter().map(|contact| contact.span.clone()).collect();
    let places = ContactPlaces { source: String::new(), contacts: places };
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
    Some(ImpactProblem { law, names, contacts, body, group, applied, sharing, by_stiffness, places })
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

/// The contacts, with the springs by which they share; no contacts where they are too many.
fn read_all_contacts(root: &Section<'_>) -> (Vec<ReadContact<Vec2>>, [f64; MOST_CONTACTS]) {
    let mut springs = [1.0; MOST_CONTACTS];
    if root.has("operator") {
        return (vec![], springs);
    }
    for (spring, contact) in springs.iter_mut().zip(root.sections("contact").into_iter().flatten()) {
        *spring = contact.number("stiffness");
    }
    let list = read_contacts(root);
    let too_many = list.len() > MOST_PIVOTED;
    (if too_many { vec![] } else { list }, springs)
}

impl From<ReadTouch<Vec2>> for Touch {
    fn from(read: ReadTouch<Vec2>) -> Self {
        let ReadTouch { point, normal, friction, restitution } = read;
        Self { arm: point, normal, friction, restitution }
    }
}

fn read_body(root: &Section<'_>, list: &[ReadContact<Vec2>], gravity: Option<Vec2>) -> Option<Struck> {
    let section = root.section("body")?;
    let (mass, inertia) = (section.value("mass"), section.value("inertia"));
    let gravity = read_gravity(&section).or(gravity);
    let applied = vec![read_applied(&section, gravity, mass)];
    let touches: Vec<Touch> =
        list.iter().map(|contact| contact.touch.map(Touch::from)).collect::<Option<_>>()?;
    if touches.is_empty() {
        return None;
    }
    let names = list.iter().map(|contact| contact.name.name.clone()).collect();
    let (velocity, spin) = (vector(section.vector("velocity")?), section.number("spin"));
    let (mass, inertia) = (mass?, inertia?);
    let contacts = ImpactContacts::of_free_body(mass, inertia, (velocity, spin), &touches).ok()?;
    let body = ImpactBody { mass, inertia, velocity, spin, touches };
    Some(Struck { names, contacts, body: Some(body), group: None, applied })
}
