//! One impact in space: a free body and its contacts, every vector of three numbers.

use crate::grammar::{
    Section, Sink, check,
    impact::{IMPACT, is_in_space},
};
use crate::impact_file::{ImpactProblem, letter, read};
use crate::node::{Node, from_json, from_toml};
use crate::problem::{Problem, ProblemKind, Problems};
use crate::quantity::Quantity;
use carom_impact::planar::{ImpactError, Law};
use carom_impact::spatial::{ContactSet, MOST_EXAMINED, Preference, RigidBody, StagedOutcome, Touch, staged};
use carom_num::{Mat3, Vec3};

/// An impact in the plane or in space.
///
/// # Example
/// An inertia of three numbers is one in space.
/// ```
/// use carom_scene::*;
/// let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
///     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
///     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)? else { panic!("it is in space") };
/// assert_eq!(ball.body.inertia.rows[2].z, 0.4);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum AnyImpact {
    /// In the plane.
    Planar(Box<ImpactProblem>),
    /// In space.
    Spatial(Box<SpatialImpactProblem>),
}

/// An impact of one free body in space. Axes are the file's; the mass centre is their origin.
///
/// # Example
/// ```
/// use carom_scene::*;
/// let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
///     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
///     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)? else { panic!("it is in space") };
/// assert_eq!((ball.names.as_slice(), ball.contacts.velocity[0].z), (["A".to_owned()].as_slice(), -3.0));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpatialImpactProblem {
    /// Restitution law.
    pub law: Law,
    /// Names of the contacts: A, B, … unless they are given.
    pub names: Vec<String>,
    /// The body before.
    pub body: RigidBody,
    /// Where it is touched; normals are unit vectors.
    pub touches: Vec<Touch>,
    /// The contacts with their operator.
    pub contacts: ContactSet<MOST_EXAMINED>,
}

/// What comes of an impact in space.
///
/// # Example
/// A ball of 2 kg that strikes with 3 m/s and e = 1/2 takes 9 N s.
/// ```
/// use carom_scene::*;
/// let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
///     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
///     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)? else { panic!("it is in space") };
/// let SpatialImpactAnswer { outcome, .. } = ball.solve();
/// assert!((outcome?.impulse[0].z - 9.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpatialImpactAnswer {
    /// The walk's stages.
    pub stages: Vec<staged::Stage<MOST_EXAMINED>>,
    /// Where it ends, or why it does not.
    pub outcome: Result<StagedOutcome<MOST_EXAMINED>, ImpactError>,
}

impl AnyImpact {
    /// Reads the TOML text of an impact; in space it is where the body's inertia, velocity or spin has three numbers.
    ///
    /// # Errors
    /// Every problem found.
    ///
    /// # Example
    /// A ball of 1 kg and radius 1 m that spins about the vertical: friction at its lowest point has no lever on that.
    /// ```
    /// use carom_scene::AnyImpact;
    /// let text = "
    /// [body]
    /// mass = 1
    /// inertia = [0.4, 0.4, 0.4]
    /// velocity = [0, 0, -1]
    /// spin = [0, 0, 5]
    /// [[contact]]
    /// point = [0, 0, -1]
    /// normal = [0, 0, 1]
    /// friction = 0.3
    /// restitution = 0.5
    /// ";
    /// let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", text)? else { panic!("it is in space") };
    /// let after = ball.after(&ball.solve().outcome?).unwrap();
    /// assert_eq!((after.velocity.z, after.spin.z), (0.5, 5.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parse(file: &str, source: &str) -> Result<Self, Problems> {
        let fail = |list| Problems::new(file, source, list);
        let (tree, syntax) = from_toml(source);
        if syntax.is_empty() { any(&tree).map_err(fail) } else { Err(fail(syntax)) }
    }

    /// Reads one JSON text with the same keys.
    ///
    /// # Errors
    /// Every problem found.
    pub fn parse_json(file: &str, source: &str) -> Result<Self, Problems> {
        let fail = |mut list: Vec<Problem>| {
            list.iter_mut().for_each(|problem| problem.span = None);
            Problems::new(file, source, list)
        };
        let tree = from_json(source).map_err(|problem| fail(vec![problem]))?;
        any(&tree).map_err(fail)
    }
}

impl SpatialImpactProblem {
    /// Resolves it, with every stage of the walk.
    ///
    /// # Example
    /// The ball leaves with half its speed.
    /// ```
    /// use carom_scene::*;
    /// let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
    ///     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
    ///     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
    /// "#)? else { panic!("it is in space") };
    /// assert!((ball.solve().outcome?.velocity[0].z - 1.5).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn solve(&self) -> SpatialImpactAnswer {
        let mut stages = vec![];
        let outcome =
            staged::resolve_observed(&self.contacts, self.law, Preference::default(), &mut |stage| {
                stages.push(*stage)
            });
        SpatialImpactAnswer { stages, outcome }
    }

    /// The body after an outcome; `None` where its inertia is singular.
    pub fn after(&self, outcome: &StagedOutcome<MOST_EXAMINED>) -> Option<RigidBody> {
        let pushed = |body: RigidBody, (i, touch): (usize, &Touch)| {
            body.pushed(touch.arm, self.contacts.frame[i].transposed() * outcome.impulse[i])
        };
        self.touches.iter().enumerate().try_fold(self.body, pushed)
    }
}

fn any(tree: &Node) -> Result<AnyImpact, Vec<Problem>> {
    if is_in_space(tree) {
        read_space(tree).map(|found| AnyImpact::Spatial(Box::new(found)))
    } else {
        read(tree).map(|found| AnyImpact::Planar(Box::new(found)))
    }
}

fn read_space(tree: &Node) -> Result<SpatialImpactProblem, Vec<Problem>> {
    let sink = Sink::default();
    let table = check(&IMPACT, tree, &sink);
    let root = table.and_then(|table| Section::new(table, String::new(), tree, &sink));
    let found = root.and_then(|root| read_problem(&root));
    let problems = sink.into_list();
    match found {
        Some(found) if problems.is_empty() => Ok(found),
        _ => Err(problems),
    }
}

fn vector([x, y, z]: [Quantity; 3]) -> Vec3 {
    Vec3::new(x.value, y.value, z.value)
}

fn read_problem(root: &Section<'_>) -> Option<SpatialImpactProblem> {
    let section = root.section("body")?;
    let moments = section.vector("inertia").map(vector);
    let velocity = section.vector("velocity").map(vector);
    let spin = if section.has("spin") { section.vector("spin").map(vector) } else { Some(Vec3::ZERO) };
    let (path, span) = (section.path().to_owned(), section.span());
    let list: Vec<(String, Option<Touch>)> =
        root.sections("contact").into_iter().flatten().enumerate().map(read_touch).collect();
    for (i, (name, _)) in list.iter().enumerate() {
        if list[..i].iter().any(|(other, _)| other == name) {
            let message = format!("two contacts are called {name:?}");
            let span = Some(root.key_span("contact"));
            root.push(Problem::new(ProblemKind::Name, "contact", message, span));
        }
    }
    let names = list.iter().map(|(name, _)| name.clone()).collect();
    let touches: Vec<Touch> = list.into_iter().map(|(_, touch)| touch).collect::<Option<_>>()?;
    let Vec3 { x, y, z } = moments?;
    let body = RigidBody {
        mass: section.value("mass")?,
        inertia: Mat3::diagonal(x, y, z),
        velocity: velocity?,
        spin: spin?,
    };
    if touches.is_empty() {
        return None;
    }
    match ContactSet::of_free_body(&body, &touches) {
        Ok(contacts) => {
            Some(SpatialImpactProblem { law: root.word_or_default("law"), names, body, touches, contacts })
        }
        Err(error) => {
            let (path, span) = match error {
                ImpactError::TooMany { .. } => ("contact".to_owned(), root.key_span("contact")),
                _ => (path, span),
            };
            root.push(Problem::new(ProblemKind::Conflict, path, error.to_string(), Some(span)));
            None
        }
    }
}

fn read_touch((number, section): (usize, Section<'_>)) -> (String, Option<Touch>) {
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
    (name, touch)
}
