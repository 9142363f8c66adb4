//! Contacts under forces: which motions are consistent at one instant.

use crate::impact_contacts::MOST_PIVOTED;
use crate::impact_file::ImpactProblem;
use crate::impact_verdict::Certainty;
use crate::problem::{Problem, ProblemKind, Problems};
use crate::unit::Dimension;
use carom_impact::planar::forces::{Acceleration, Applied, Loaded, accelerations};

use carom_impact::ImpactError;
use carom_impact::planar::{Broken, Guess, MOST_CONTACTS, Meeting, RigidBody};
use carom_num::Vec2;

/// A motion that all laws allow.
///
/// # Example
/// A block of 2 kg on a floor that is pulled with 8 N: friction gives as much, and it stays.
/// ```
/// use carom_scene::*;
/// let block = ImpactProblem::parse("block.toml", r#"
///     gravity = 10
///     body = { mass = 2, inertia = 1, velocity = [0, 0], force = [8, 0] }
///     contact = [{ point = [0, 0], normal = [0, 1], friction = 0.5 }]
/// "#)?;
/// let motion: &ForceMotion = &block.under_forces("block.toml")?.motions[0];
/// assert_eq!((motion.force[0], motion.response[0]), ([-8.0, 20.0], [0.0, 0.0]));
/// # Ok::<(), Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ForceMotion {
    /// What each contact does.
    pub guess: Vec<Guess>,
    /// Contact forces (tangential, normal) [N].
    pub force: Vec<[f64; 2]>,
    /// Accelerations (slip, normal) of each contact [m/s²].
    pub response: Vec<[f64; 2]>,
    /// What each body does.
    pub bodies: Vec<Acceleration>,
    /// Smallest slack divided by the sum of its terms' magnitudes.
    pub margin: f64,
    /// The forces are not determined, the motion is.
    pub indeterminate: bool,
}

/// A hypothesis that is not consistent: what each contact does, and the inequality that this breaks most.
pub type ForceRejected = (Vec<Guess>, Broken);

/// Every motion that is consistent.
///
/// # Example
/// A rod that slides into its lean with enough friction has none: Painlevé's paradox.
/// ```
/// use carom_scene::*;
/// let rod = ImpactProblem::parse("rod.toml", r#"
///     gravity = 9.81
///     body = { mass = 1, inertia = 0.3333333333333333, velocity = [1, 0] }
///     contact = [{ point = [0.5, -0.8660254037844386], normal = [0, 1], friction = 1.6 }]
/// "#)?;
/// assert_eq!(rod.under_forces("rod.toml")?.motions.len(), 0);
/// # Ok::<(), Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ForceAnswer {
    /// The motions that differ, the first four of them.
    pub motions: Vec<ForceMotion>,
    /// How many there are.
    pub count: usize,
    /// Every other hypothesis.
    pub rejected: Vec<ForceRejected>,
    /// False where one motion was sought, and no other.
    pub examined: bool,
}

impl ForceAnswer {
    /// Whether there is one motion.
    ///
    /// # Example
    /// ```
    /// use carom_scene::*;
    /// let none = ForceAnswer { motions: vec![], count: 0, rejected: vec![], examined: true };
    /// assert_eq!(none.certainty().outcome(), ImpactOutcome::None);
    /// ```
    pub fn certainty(&self) -> Certainty {
        Certainty { examined: self.examined, ..Certainty::of_ends(self.count) }
    }
}

/// Bodies and where they touch.
struct Scene {
    bodies: Vec<RigidBody>,
    meetings: Vec<Meeting>,
    applied: Vec<Applied>,
}

impl ImpactProblem {
    /// The motions that are consistent under the forces that the file writes; `file` is the name that problems are reported under.
    ///
    /// # Errors
    /// A contact that approaches (that is an impact), and a file that gives the operator alone (it knows no forces): every problem.
    ///
    /// # Limits
    /// As [`Loaded`].
    ///
    /// # Example
    /// The block's floor is approached.
    /// ```
    /// use carom_scene::*;
    /// let block = ImpactProblem::parse("block.toml", r#"
    ///     body = { mass = 2, inertia = 1, velocity = [0, -1], force = [8, -20] }
    ///     contact = [{ point = [0, 0], normal = [0, 1], friction = 0.5 }]
    /// "#)?;
    /// assert!(block.under_forces("block.toml").unwrap_err().to_string().contains("an approach is an impact"));
    /// # Ok::<(), Problems>(())
    /// ```
    pub fn under_forces(&self, file: &str) -> Result<ForceAnswer, Problems> {
        let fail = |list| Err(Problems::new(file, &self.places.source, list));
        let Some(scene) = self.scene() else {
            let message = "has no forces: write [body] or [[body]] with force, torque or gravity";
            return fail(vec![Problem::new(ProblemKind::Conflict, "operator", message, None)]);
        };
        // One by one first, so that every contact that is at fault is named.
        let alone = |m: &Meeting| Loaded::<1, 2>::new(&scene.bodies, &[*m], &scene.applied).err();
        let refused = scene.meetings.iter().enumerate().filter_map(|(i, m)| Some((i, alone(m)?)));
        let list: Vec<Problem> = refused.map(|(i, error)| self.refusal(i, error)).collect();
        if !list.is_empty() {
            return fail(list);
        }
        let found = if scene.meetings.len() > MOST_CONTACTS {
            solve::<MOST_PIVOTED, { 2 * MOST_PIVOTED }>(&scene)
        } else {
            solve::<MOST_CONTACTS, { 2 * MOST_CONTACTS }>(&scene)
        };
        found.or_else(|error| {
            fail(vec![Problem::new(ProblemKind::Geometry, "contact", error.to_string(), None)])
        })
    }

    fn scene(&self) -> Option<Scene> {
        let applied = self.applied.clone();
        if let Some(group) = &self.group {
            return Some(Scene { bodies: group.bodies.clone(), meetings: group.meetings.clone(), applied });
        }
        let body = self.body.as_ref()?;
        let (mass, inertia, velocity, spin) = (body.mass, body.inertia, body.velocity, body.spin);
        let free = RigidBody { mass, inertia, centre: Vec2::ZERO, velocity, spin };
        let meetings = body.touches.iter().map(|t| Meeting {
            into: 0,
            out_of: 1,
            point: t.arm,
            normal: t.normal,
            friction: t.friction,
            restitution: t.restitution,
        });
        Some(Scene { bodies: vec![free, RigidBody::FIXED], meetings: meetings.collect(), applied })
    }

    fn refusal(&self, i: usize, error: ImpactError) -> Problem {
        let name = self.names.get(i).map_or("?", String::as_str);
        let place = self.places.contacts.get(i).cloned();
        let message = match error {
            ImpactError::OutsideDomain { quantity, value, allowed, contact: Some(_) } => {
                // Only velocities have a unit here: the other numbers of a contact are ratios.
                let value = match quantity {
                    "normal velocity" => Dimension::Speed.show_digits(value, 6),
                    _ => value.to_string(),
                };
                format!("{quantity} of {name} is {value}, allowed is {allowed}")
            }
            error => error.to_string(),
        };
        Problem::new(ProblemKind::OutOfRange, format!("contact.{i}"), message, place)
            .with_help("`carom impact` resolves impacts")
    }
}

fn solve<const N: usize, const M: usize>(scene: &Scene) -> Result<ForceAnswer, ImpactError> {
    let Scene { bodies, meetings, applied } = scene;
    let loaded = Loaded::<N, M>::new(bodies, meetings, applied)?;
    let (count, mut rejected) = (loaded.set.count, vec![]);
    let answer = loaded.solve(&mut |guess, broken| {
        rejected.push((guess[..count].to_vec(), broken));
    });
    let motion = |solution: &carom_impact::planar::Solution<N>| {
        let force = solution.rates[..count].to_vec();
        let bodies = accelerations(bodies, meetings, applied, &force)?;
        Ok(ForceMotion {
            guess: solution.guess[..count].to_vec(),
            response: solution.response[..count].to_vec(),
            force,
            bodies,
            margin: solution.margin,
            indeterminate: solution.indeterminate,
        })
    };
    let motions = answer.iter().map(motion).collect::<Result<_, ImpactError>>()?;
    Ok(ForceAnswer { motions, count: answer.count, rejected, examined: answer.examined })
}
