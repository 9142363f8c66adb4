//! The inequality that rejects a hypothesis, as JSON.

use crate::word::Word;
use carom_impact::Phase;
use carom_impact::planar::{Broken, Condition};
use carom_words::impact::Clock;
use schemars::JsonSchema;
use serde::Serialize;

/// What an inequality is about.
///
/// # Example
/// ```
/// assert_eq!(serde_json::to_string(&carom_scene::InequalityKind::FrictionCone).unwrap(), r#""friction_cone""#);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InequalityKind {
    /// A contact must not pull: its normal impulse is 0 or more.
    NormalImpulse,
    /// A contact must not pull: its normal force is 0 or more.
    NormalForce,
    /// A contact that separates must not approach.
    NormalVelocity,
    /// A contact that separates must not accelerate into the obstacle.
    NormalAcceleration,
    /// A contact that sticks needs no more friction than μ times its push.
    FrictionCone,
    /// Friction acts against the slip that it lets start.
    SlipDirection,
    /// The equations of the hypothesis have no solution: no inequality is left to ask.
    Equations,
}

/// The inequality that a hypothesis breaks most, and by how much.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct InequalityReport {
    /// What it is about.
    pub kind: InequalityKind,
    /// The contact; null for equations.
    pub contact: Option<String>,
    /// By how much it is broken, > 0; null for equations, where numbers overflow, and for a stage in space, which knows its share.
    pub amount: Option<f64>,
    /// The unit of the amount: N s, N, m/s or m/s^2; empty for equations.
    #[schemars(extend("enum" = ["N s", "N", "m/s", "m/s^2", ""]))]
    pub unit: &'static str,
    /// The amount divided by the magnitudes of all that it is a difference of: near 0 a close call, 1 where nothing speaks for the
    /// hypothesis; null where numbers overflow, and for the law under which nothing slides.
    #[schemars(range(min = 0, max = 1))]
    pub share: Option<f64>,
    /// compression (or the one step of Newton's law) or restitution; null for forces, and for the law under which nothing slides.
    pub phase: Option<Word<Phase>>,
}

impl InequalityReport {
    pub(crate) fn new(broken: &Broken, names: &[String], clock: Clock) -> Self {
        let motion = clock == Clock::Time;
        let (rate, response) = if motion { ("N", "m/s^2") } else { ("N s", "m/s") };
        let (kind, contact, unit) = match broken.condition {
            Condition::Pushes(i) if motion => (InequalityKind::NormalForce, Some(i), rate),
            Condition::Pushes(i) => (InequalityKind::NormalImpulse, Some(i), rate),
            Condition::Opens(i) if motion => (InequalityKind::NormalAcceleration, Some(i), response),
            Condition::Opens(i) => (InequalityKind::NormalVelocity, Some(i), response),
            Condition::WithinCone(i) => (InequalityKind::FrictionCone, Some(i), rate),
            Condition::StartsForward(i) | Condition::StartsBackward(i) => {
                (InequalityKind::SlipDirection, Some(i), response)
            }
            Condition::Solvable => (InequalityKind::Equations, None, ""),
        };
        Self {
            kind,
            contact: contact.and_then(|i| names.get(i).cloned()),
            amount: contact.map(|_| broken.amount).filter(|amount| amount.is_finite()),
            unit,
            share: Some(broken.share).filter(|share| share.is_finite()),
            phase: match clock {
                Clock::Impulse(phase) => Some(Word(phase)),
                Clock::Time => None,
            },
        }
    }
}
