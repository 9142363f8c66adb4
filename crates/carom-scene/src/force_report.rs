//! What contacts under forces do, as JSON: SI, the unit in the key.

use crate::force_answer::{ForceAnswer, ForceMotion};
use crate::impact_file::ImpactProblem;
use crate::impact_report::RejectedReport;
use crate::impact_verdict::{ImpactOutcome, Uniqueness};
use crate::inequality_report::InequalityReport;
use crate::word::Word;
use carom_impact::planar::{ContactState, Slip};
use carom_words::impact::{self, Clock};
use schemars::JsonSchema;
use serde::Serialize;

/// One contact under forces.
///
/// # Example
/// See [`ForceAnswerReport`].
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ForceContactReport {
    /// Its name.
    pub name: String,
    /// What it does.
    pub state: Word<ContactState>,
    /// Normal force on the body [N].
    #[serde(rename = "normal_force_N")]
    pub normal_force: f64,
    /// Tangential force on the body [N].
    #[serde(rename = "tangential_force_N")]
    pub tangential_force: f64,
    /// How the normal velocity changes [m/s²].
    pub normal_acceleration_m_s2: f64,
    /// How the slip changes [m/s²].
    pub slip_acceleration_m_s2: f64,
}

/// One of several bodies under forces.
///
/// # Example
/// See [`ForceAnswerReport`].
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BodyAccelerationReport {
    /// Its name.
    pub name: String,
    /// Acceleration of its mass centre [m/s²].
    pub acceleration_m_s2: [f64; 2],
    /// How its spin changes, counter-clockwise [rad/s²].
    pub spin_acceleration_rad_s2: f64,
}

/// A motion that all laws allow.
///
/// # Example
/// See [`ForceAnswerReport`].
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ForceMotionReport {
    /// What each contact does: "A slips+, B sticks".
    pub hypothesis: String,
    /// The contacts.
    pub contacts: Vec<ForceContactReport>,
    /// Acceleration of the body's mass centre [m/s²]; null where there are several bodies.
    pub acceleration_m_s2: Option<[f64; 2]>,
    /// How the body's spin changes, counter-clockwise [rad/s²]; null where there are several bodies.
    pub spin_acceleration_rad_s2: Option<f64>,
    /// Several bodies; else empty.
    pub bodies: Vec<BodyAccelerationReport>,
    /// Smallest slack divided by the sum of its terms' magnitudes; null where nothing touches.
    pub margin: Option<f64>,
    /// The forces are not determined, the motion is: these forces are one choice of many.
    pub indeterminate: bool,
}

/// What contacts under forces do.
///
/// # Example
/// A block of 2 kg on a floor slides, pulled with 15 N against friction 1/2: of these friction takes 10 N, and 5 N accelerate it.
/// ```
/// use carom_scene::*;
/// let block = ImpactProblem::parse("block.toml", r#"
///     gravity = 10
///     body = { mass = 2, inertia = 1, velocity = [1, 0], force = [15, 0] }
///     contact = [{ point = [0, 0], normal = [0, 1], friction = 0.5 }]
/// "#)?;
/// let report = ForceAnswerReport::new(&block, &block.under_forces("block.toml")?);
/// assert_eq!((report.outcome, report.solutions[0].acceleration_m_s2), (ImpactOutcome::Unique, Some([2.5, 0.0])));
/// let contact = &report.solutions[0].contacts[0];
/// assert_eq!((contact.state.as_str(), contact.normal_force, contact.tangential_force), ("slips", 20.0, -10.0));
/// # Ok::<(), Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom contact")]
pub struct ForceAnswerReport {
    /// unique, several or none; of more than six contacts found or not_found.
    pub outcome: ImpactOutcome,
    /// Whether every hypothesis was examined.
    pub uniqueness: Uniqueness,
    /// How many motions are consistent; the first four are listed.
    pub count: usize,
    /// The motions that are consistent.
    pub solutions: Vec<ForceMotionReport>,
    /// The other hypotheses; empty where uniqueness is not examined.
    pub rejected: Vec<RejectedReport>,
}

impl ForceAnswerReport {
    /// The report of an answer.
    pub fn new(problem: &ImpactProblem, answer: &ForceAnswer) -> Self {
        let certainty = answer.certainty();
        let rejected = answer.rejected.iter().map(|(guess, broken)| RejectedReport {
            hypothesis: impact::hypothesis(&problem.names, guess),
            because: impact::because(&problem.names, broken, Clock::Time),
            slips: guess[..problem.names.len()].iter().map(|guess| Word(guess.slip)).collect(),
            inequality: InequalityReport::new(broken, &problem.names, Clock::Time),
        });
        Self {
            outcome: certainty.outcome(),
            uniqueness: if answer.examined { Uniqueness::Examined } else { Uniqueness::NotExamined },
            count: answer.count,
            solutions: answer.motions.iter().map(|motion| motion_report(problem, motion)).collect(),
            rejected: rejected.collect(),
        }
    }
}

fn motion_report(problem: &ImpactProblem, motion: &ForceMotion) -> ForceMotionReport {
    let contacts = problem.names.iter().enumerate().map(|(i, name)| ForceContactReport {
        name: name.clone(),
        state: Word(match motion.guess[i].slip {
            Slip::Open => ContactState::Separates,
            Slip::Sticks => ContactState::Sticks,
            Slip::Forward | Slip::Backward => ContactState::Slips,
        }),
        normal_force: motion.force[i][1],
        tangential_force: motion.force[i][0],
        normal_acceleration_m_s2: motion.response[i][1],
        slip_acceleration_m_s2: motion.response[i][0],
    });
    let alone = motion.bodies.first().filter(|_| problem.group.is_none());
    let names = problem.group.as_ref().map_or(&[][..], |group| &group.names);
    let bodies = names.iter().zip(&motion.bodies).map(|(name, body)| BodyAccelerationReport {
        name: name.clone(),
        acceleration_m_s2: [body.centre.x, body.centre.y],
        spin_acceleration_rad_s2: body.spin,
    });
    ForceMotionReport {
        hypothesis: impact::hypothesis(&problem.names, &motion.guess),
        contacts: contacts.collect(),
        acceleration_m_s2: alone.map(|body| [body.centre.x, body.centre.y]),
        spin_acceleration_rad_s2: alone.map(|body| body.spin),
        bodies: bodies.collect(),
        margin: motion.margin.is_finite().then_some(motion.margin),
        indeterminate: motion.indeterminate,
    }
}
