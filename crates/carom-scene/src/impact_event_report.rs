//! Why stages of an impact end, and why an impact has no walk, as JSON.

use carom_impact::ImpactError;
use carom_impact::planar::StageEnd;
use carom_impact::spatial::{Ground, StageEvent};
use schemars::JsonSchema;
use serde::Serialize;

/// What ended a stage of an impact.
///
/// # Example
/// ```
/// use carom_scene::ImpactEventKind;
/// assert_eq!(serde_json::to_string(&ImpactEventKind::SlipStops)?, r#""slip_stops""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ImpactEventKind {
    /// The slip of a contact came to zero.
    SlipStops,
    /// The slip of a contact that stuck begins.
    SlipStarts,
    /// An open contact closed again.
    Closes,
    /// A contact opened.
    Opens,
    /// A contact that rested takes an impulse.
    Loads,
    /// Friction drives a contact in (Painlevé's paradox).
    DrivenIn,
    /// A contact has returned its work of compression.
    Repaid,
    /// No contact approaches any more.
    CompressionEnds,
    /// What the law asks of restitution is done.
    RestitutionEnds,
}

/// Why a stage of an impact ended.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ImpactEventReport {
    /// What happened.
    pub kind: ImpactEventKind,
    /// At which contact; null where it is none in particular.
    pub contact: Option<String>,
}

impl ImpactEventReport {
    fn new(kind: ImpactEventKind, contact: Option<usize>, names: &[String]) -> Self {
        Self { kind, contact: contact.and_then(|i| names.get(i).cloned()) }
    }

    pub(crate) fn in_plane(end: StageEnd, names: &[String]) -> Self {
        let (kind, contact) = match end {
            StageEnd::SlipStops(i) => (ImpactEventKind::SlipStops, Some(i)),
            StageEnd::Closes(i) => (ImpactEventKind::Closes, Some(i)),
            StageEnd::CompressionEnds => (ImpactEventKind::CompressionEnds, None),
            StageEnd::RestitutionEnds => (ImpactEventKind::RestitutionEnds, None),
        };
        Self::new(kind, contact, names)
    }

    pub(crate) fn in_space(end: StageEvent, names: &[String]) -> Self {
        let (kind, contact) = match end {
            StageEvent::SlipStops(i) => (ImpactEventKind::SlipStops, Some(i)),
            StageEvent::Closes(i) => (ImpactEventKind::Closes, Some(i)),
            StageEvent::Opens(i) => (ImpactEventKind::Opens, Some(i)),
            StageEvent::SlipStarts(i) => (ImpactEventKind::SlipStarts, Some(i)),
            StageEvent::Loads(i) => (ImpactEventKind::Loads, Some(i)),
            StageEvent::DrivenIn => (ImpactEventKind::DrivenIn, None),
            StageEvent::Repaid(i) => (ImpactEventKind::Repaid, Some(i)),
            StageEvent::CompressionEnds => (ImpactEventKind::CompressionEnds, None),
            StageEvent::RestitutionEnds => (ImpactEventKind::RestitutionEnds, None),
        };
        Self::new(kind, contact, names)
    }
}

/// Why a stage is walked that no consistent hypothesis says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ForcedKind {
    /// Friction drives the contact in (Painlevé's paradox).
    DrivenIn,
    /// The contact approaches fastest.
    FastestFirst,
}

/// The contact that is loaded in a stage that no consistent hypothesis says.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ForcedReport {
    /// Why it is that one.
    pub kind: ForcedKind,
    /// Its name; of several that are alike, and loaded together, the first.
    pub contact: Option<String>,
}

impl ForcedReport {
    pub(crate) fn new(ground: Ground, names: &[String]) -> Option<Self> {
        let (kind, i) = match ground {
            Ground::Consistent => return None,
            Ground::DrivenIn(i) => (ForcedKind::DrivenIn, i),
            Ground::FastestFirst(i) => (ForcedKind::FastestFirst, i),
        };
        Some(Self { kind, contact: names.get(i).cloned() })
    }
}

/// Why an impact has no walk.
///
/// # Example
/// ```
/// use carom_impact::ImpactError;
/// use carom_scene::ImpactFailure;
/// assert_eq!(ImpactFailure::of(&ImpactError::Jammed), ImpactFailure::Jammed);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ImpactFailure {
    /// More contacts act than are walked in stages.
    TooMany,
    /// A number is none that an impact can be computed from, or two contacts are one.
    Refused,
    /// Products of the numbers overflow.
    Overflow,
    /// The walk did not end within its budget of stages.
    Unending,
    /// The contacts pass the load around in a circle.
    Circling,
    /// No motion through the impact is consistent.
    Jammed,
}

impl ImpactFailure {
    /// The kind of an error.
    pub fn of(error: &ImpactError) -> Self {
        match error {
            ImpactError::TooMany { .. } => Self::TooMany,
            ImpactError::Overflow => Self::Overflow,
            ImpactError::Unending { .. } => Self::Unending,
            ImpactError::Circling { .. } => Self::Circling,
            ImpactError::Jammed => Self::Jammed,
            _ => Self::Refused,
        }
    }
}
