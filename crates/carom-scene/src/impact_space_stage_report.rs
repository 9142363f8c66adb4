//! What contacts do in a stage of an impact in space, as JSON.

use schemars::JsonSchema;
use serde::Serialize;

/// A hypothesis, and the inequality that rejects it.
///
/// # Example
/// A ball cannot open where it approaches.
/// ```
/// # use carom_scene::*;
/// # let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
/// #     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
/// #     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
/// # "#)? else { panic!("it is in space") };
/// let report = SpatialImpactReport::new(&ball, &ball.solve());
/// let rejected: &[SpatialHypothesisReport] = &report.non_sliding_rejected;
/// assert!(!rejected.is_empty() && rejected.iter().all(|other| !other.because.is_empty()));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialHypothesisReport {
    /// What it says of each contact.
    pub hypothesis: String,
    /// What rejects it.
    pub because: String,
}

/// One contact of an impact in space, at the end of the impact or of a stage.
///
/// # Example
/// A ball of 2 kg that strikes with 3 m/s and e = 1/2 takes 9 N s.
/// ```
/// # use carom_scene::*;
/// # let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
/// #     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
/// #     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
/// # "#)? else { panic!("it is in space") };
/// let report = SpatialImpactReport::new(&ball, &ball.solve());
/// let contact: &SpatialImpactContactReport = &report.end.as_ref().unwrap().contacts[0];
/// assert_eq!(contact.state, "separates");
/// assert!((contact.normal_impulse - 9.0).abs() < 1e-12 && (contact.velocity_m_s[2] - 1.5).abs() < 1e-12);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialImpactContactReport {
    /// Its name.
    pub name: String,
    /// At the end separates, sticks or slips; in a stage open, slips, sticks or starts to slip.
    pub state: String,
    /// Impulse so far on the body into which the normal points [N s], in the axes that `axes` names.
    #[serde(rename = "impulse_N_s")]
    pub impulse: [f64; 3],
    /// Normal part of it [N s].
    #[serde(rename = "normal_impulse_N_s")]
    pub normal_impulse: f64,
    /// Velocity of the contact point, relative to the other body [m/s].
    pub velocity_m_s: [f64; 3],
    /// Normal part of it [m/s].
    pub normal_velocity_m_s: f64,
}

/// A stage of the walk.
///
/// # Example
/// Nothing slips, and so no slip turns.
/// ```
/// # use carom_scene::*;
/// # let AnyImpact::Spatial(ball) = AnyImpact::parse("ball.toml", r#"
/// #     body = { mass = 2, inertia = [0.4, 0.4, 0.4], velocity = [0, 0, -3], spin = [0, 0, 5] }
/// #     contact = [{ point = [0, 0, -1], normal = [0, 0, 1], friction = 0.3, restitution = 0.5 }]
/// # "#)? else { panic!("it is in space") };
/// let report = SpatialImpactReport::new(&ball, &ball.solve());
/// let stages: &[SpatialWalkStageReport] = &report.stages;
/// assert_eq!((stages[0].phase.as_str(), stages[0].straight), ("compression", true));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpatialWalkStageReport {
    /// compression or restitution.
    pub phase: String,
    /// Why it ended.
    pub ended_by: String,
    /// No slip turns in it.
    pub straight: bool,
    /// What each contact does in it, and where it ends.
    pub contacts: Vec<SpatialImpactContactReport>,
    /// Why it is walked though no way on is consistent at its start: the contact that friction drives in (Painlevé's paradox), or the fastest one, is loaded
    /// alone; null where one is.
    pub forced: Option<String>,
    /// Every consistent way on at its start.
    pub ways_on: Vec<String>,
    /// False where there may be other ways on: directions of several slips that start were looked for.
    pub examined: bool,
    /// The other hypotheses, each with what rejects it.
    pub rejected: Vec<SpatialHypothesisReport>,
    /// Rejected hypotheses beyond those that are told.
    pub rejected_left_out: usize,
}
