//! One impact in space: a free body, several bodies or the operator alone; every vector of three numbers.

use crate::grammar::impact::is_in_space;
use crate::impact_file::{ImpactProblem, read};
use crate::impact_space_bodies::SpatialGroup;
use crate::impact_space_read::read_space;
use crate::node::{Node, from_json, from_toml};
use crate::problem::{Problem, Problems};
use carom_impact::spatial::{ContactSet, MOST_EXAMINED, Preference, RigidBody, StagedOutcome, Touch, staged};
use carom_impact::{ImpactError, Law};

/// An impact in the plane or in space.
///
/// # Example
/// An inertia of three numbers is one in space.
/// ```
/// # use carom_scene::*;
/// let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
///     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
///     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)? else { panic!("it is in space") };
/// assert_eq!(ball.body.unwrap().inertia.rows[2].z, 0.4);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum AnyImpact {
    /// In the plane.
    Planar(Box<ImpactProblem>),
    /// In space.
    Spatial(Box<SpatialImpactProblem>),
}

/// An impact in space: of one free body, of several bodies that meet, or between any bodies. Axes are the file's; of one body the mass
/// centre is their origin. Where only the operator is known, each contact has axes of its own.
///
/// # Example
/// ```
/// # use carom_scene::*;
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
    /// The one body before, where there is one.
    pub body: Option<RigidBody>,
    /// Where it is touched; normals are unit vectors.
    pub touches: Vec<Touch>,
    /// Several bodies, where several meet.
    pub group: Option<SpatialGroup>,
    /// The contacts with their operator.
    pub contacts: ContactSet<MOST_EXAMINED>,
}

/// What comes of an impact in space.
///
/// # Example
/// A ball of 2 kg that strikes with 3 m/s and e = 1/2 takes 9 N s.
/// ```
/// # use carom_scene::*;
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
    /// Reads the TOML text of an impact; in space it is where a vector of a body or of a contact has three numbers.
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
        if syntax.is_empty() { any(&tree, source).map_err(fail) } else { Err(fail(syntax)) }
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
    /// let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
    ///     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
    ///     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
    /// "#)? else { panic!("it is in space") };
    /// let json = r#"{ "body": { "mass": 2, "inertia": [0.4, 0.4, 0.4], "velocity": [0, 0, -3],
    ///     "spin": [0, 0, 5] }, "contact": [{ "point": [0, 0, -1], "normal": [0, 0, 1], "friction": 0.3,
    ///     "restitution": 0.5 }] }"#;
    /// assert_eq!(AnyImpact::parse_json("ball.json", json)?, AnyImpact::Spatial(ball));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn parse_json(file: &str, source: &str) -> Result<Self, Problems> {
        let fail = |mut list: Vec<Problem>| {
            list.iter_mut().for_each(|problem| problem.span = None);
            Problems::new(file, source, list)
        };
        let tree = from_json(source).map_err(fail)?;
        any(&tree, "").map_err(fail)
    }
}

impl SpatialImpactProblem {
    /// Resolves it, with every stage of the walk.
    ///
    /// # Example
    /// The ball leaves with half its speed.
    /// ```
    /// # use carom_scene::*;
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

    /// The one body after an outcome; `None` where there is none.
    ///
    /// # Example
    /// Friction at the lowest point has no lever on a spin about the vertical.
    /// ```
    /// # use carom_scene::*;
    /// let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
    ///     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
    ///     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
    /// "#)? else { panic!("it is in space") };
    /// let after = ball.after(&ball.solve().outcome?).unwrap();
    /// assert!((after.velocity.z - 1.5).abs() < 1e-12 && after.spin.z == 5.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn after(&self, outcome: &StagedOutcome<MOST_EXAMINED>) -> Option<RigidBody> {
        let pushed = |body: RigidBody, (i, touch): (usize, &Touch)| {
            body.pushed(touch.arm, self.contacts.frame[i].transposed() * outcome.impulse[i])
        };
        self.touches.iter().enumerate().try_fold(self.body?, pushed)
    }
}

fn any(tree: &Node, source: &str) -> Result<AnyImpact, Vec<Problem>> {
    if is_in_space(tree) {
        read_space(tree).map(|found| AnyImpact::Spatial(Box::new(found)))
    } else {
        read(tree, source).map(|found| AnyImpact::Planar(Box::new(found)))
    }
}
