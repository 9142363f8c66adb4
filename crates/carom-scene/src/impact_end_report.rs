//! How an impact goes and where it ends, as JSON.

use crate::impact_verdict::SharingVerdict;
use schemars::JsonSchema;
use serde::Serialize;

/// One contact at the end.
///
/// # Example
/// A ball of 2 kg that strikes with 3 m/s and e = 1/2 takes 9 N s and leaves with 1.5 m/s.
/// ```
/// # use carom_scene::*;
/// # let ball = ImpactProblem::parse("ball.toml", r#"
/// #     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
/// #     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// # "#)?;
/// let report = ImpactAnswerReport::new(&ball, &ball.solve());
/// let contact: &EndContactReport = &report.end_states[0].end.contacts[0];
/// assert_eq!((contact.name.as_str(), contact.state.as_str()), ("A", "separates"));
/// assert!((contact.normal_impulse - 9.0).abs() < 1e-14);
/// assert!((contact.normal_velocity_m_s - 1.5).abs() < 1e-14);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EndContactReport {
    /// Its name.
    pub name: String,
    /// separates, sticks or slips.
    pub state: String,
    /// Normal impulse on the body [N s].
    #[serde(rename = "normal_impulse_N_s")]
    pub normal_impulse: f64,
    /// Tangential impulse on the body [N s].
    #[serde(rename = "tangential_impulse_N_s")]
    pub tangential_impulse: f64,
    /// Normal velocity after [m/s].
    pub normal_velocity_m_s: f64,
    /// Slip after [m/s].
    pub slip_m_s: f64,
}

/// One contact during a stage; pairs are the stage's start and end.
///
/// # Example
/// In compression a ball of 2 kg and 3 m/s takes 6 N s.
/// ```
/// # use carom_scene::*;
/// # let ball = ImpactProblem::parse("ball.toml", r#"
/// #     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
/// #     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// # "#)?;
/// let report = ImpactAnswerReport::new(&ball, &ball.solve());
/// let contact: &StageContactReport = &report.staged.as_ref().unwrap().stages[0].contacts[0];
/// assert_eq!((contact.normal_impulse, contact.normal_velocity_m_s), ([0.0, 6.0], [-3.0, 0.0]));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StageContactReport {
    /// open, sticks, slips+ or slips-.
    pub slip: &'static str,
    /// Normal impulse so far [N s].
    #[serde(rename = "normal_impulse_N_s")]
    pub normal_impulse: [f64; 2],
    /// Tangential impulse so far [N s].
    #[serde(rename = "tangential_impulse_N_s")]
    pub tangential_impulse: [f64; 2],
    /// Normal velocity [m/s].
    pub normal_velocity_m_s: [f64; 2],
    /// Slip [m/s].
    pub slip_m_s: [f64; 2],
}

/// One straight stage of the walk.
///
/// # Example
/// ```
/// # use carom_scene::*;
/// # let ball = ImpactProblem::parse("ball.toml", r#"
/// #     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
/// #     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// # "#)?;
/// let report = ImpactAnswerReport::new(&ball, &ball.solve());
/// let stages: Vec<WalkStageReport> = report.staged.unwrap().stages;
/// assert_eq!((stages[0].phase, stages[0].ended_by.as_str()), ("compression", "compression ends"));
/// assert_eq!(stages[1].phase, "restitution");
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WalkStageReport {
    /// compression or restitution.
    pub phase: &'static str,
    /// Why it ended.
    pub ended_by: String,
    /// The contacts.
    pub contacts: Vec<StageContactReport>,
}

/// Which share of the impulses of compression a contact takes, of those that give the same motion.
///
/// # Example
/// ```
/// assert_eq!(serde_json::to_string(&carom_scene::ShareTaken::Least).unwrap(), r#""least""#);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ShareTaken {
    /// As little as the laws allow.
    Least,
    /// The share that is farthest from every inequality: the answer's own.
    Middle,
    /// As much as the laws allow; where they allow any, some more than it must.
    Most,
}

/// What another share of compression leaves: restitution multiplies the share that is taken.
///
/// # Example
/// A ball that strikes one plate shares with nobody.
/// ```
/// # use carom_scene::*;
/// # let ball = ImpactProblem::parse("ball.toml", r#"
/// #     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
/// #     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// # "#)?;
/// let shares: Vec<OpenShareReport> = ImpactAnswerReport::new(&ball, &ball.solve()).staged.unwrap().open_shares;
/// assert!(shares.is_empty());
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OpenShareReport {
    /// The contact whose share is asked for.
    pub contact: String,
    /// Which share it takes.
    pub takes: ShareTaken,
    /// Where that ends.
    pub end: EndReport,
}

/// One of several bodies after an impact.
///
/// # Example
/// Newton's cradle, three balls of 1 kg: 1 kg m/s goes in and comes out.
/// ```
/// # use carom_scene::*;
/// # let text = std::fs::read_to_string("../../examples/impact_cradle.toml")?;
/// # let cradle = ImpactProblem::parse("cradle.toml", &text)?;
/// let report = ImpactAnswerReport::new(&cradle, &cradle.solve());
/// let bodies: &[BodyReport] = &report.staged.as_ref().unwrap().end.bodies;
/// assert_eq!(bodies.len(), 3);
/// assert!((bodies.iter().map(|body| body.velocity_m_s[0]).sum::<f64>() - 1.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BodyReport {
    /// Its name.
    pub name: String,
    /// Velocity of its mass centre after [m/s].
    pub velocity_m_s: [f64; 2],
    /// Spin after [rad/s].
    pub spin_rad_s: f64,
}

/// What a convention on how closing contacts share an impact says.
///
/// # Example
/// The answer is that of one of the conventions at least.
/// ```
/// # use carom_scene::*;
/// # let text = std::fs::read_to_string("../../examples/impact_cradle.toml")?;
/// # let cradle = ImpactProblem::parse("cradle.toml", &text)?;
/// let report = ImpactAnswerReport::new(&cradle, &cradle.solve());
/// let names: Vec<_> = report.sharing.iter().map(|shared: &SharingReport| shared.sharing).collect();
/// assert_eq!(names, ["together", "in sequence", "by stiffness"]);
/// assert!(report.sharing.iter().any(|shared| shared.verdict == SharingVerdict::Agrees));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SharingReport {
    /// together, in sequence or by stiffness.
    pub sharing: &'static str,
    /// It moves as the answer does.
    pub verdict: SharingVerdict,
    /// Where it ends; null where it has no answer.
    pub end: Option<EndReport>,
    /// Why it has no answer; else null.
    pub because: Option<String>,
}

/// Where an impact ends.
///
/// # Example
/// With e = 1/2 and without slip a quarter of 9 J is left.
/// ```
/// # use carom_scene::*;
/// # let ball = ImpactProblem::parse("ball.toml", r#"
/// #     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
/// #     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// # "#)?;
/// let report = ImpactAnswerReport::new(&ball, &ball.solve());
/// let EndReport { energy_before, energy_after, .. } = report.staged.unwrap().end;
/// assert_eq!(energy_before, Some(9.0));
/// assert!((energy_after.unwrap() - 2.25).abs() < 1e-14);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EndReport {
    /// The contacts, in the order given.
    pub contacts: Vec<EndContactReport>,
    /// Velocity of the body after [m/s]; null without a body.
    pub velocity_m_s: Option<[f64; 2]>,
    /// Spin of the body after [rad/s]; null without a body.
    pub spin_rad_s: Option<f64>,
    /// Kinetic energy before [J]; null without a body.
    #[serde(rename = "energy_before_J")]
    pub energy_before: Option<f64>,
    /// Kinetic energy after [J]; null without a body.
    #[serde(rename = "energy_after_J")]
    pub energy_after: Option<f64>,
    /// Where several bodies meet: each of them; else empty.
    pub bodies: Vec<BodyReport>,
}
