//! Why stages end, what the tightest decision was about and between what a part jams, as JSON.

use carom_feeder::{Decided, Jam, JamKind, StageEnd, Touch};
use carom_words::part::Names;
use schemars::JsonSchema;
use serde::Serialize;

/// A feature of the part on a plate or wall.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TouchReport {
    /// Name of the plate or wall; its number, counted from 0, where it has none.
    pub plate: String,
    /// The part's feature: front, rear, front top, corner 2, face 0 or rim.
    pub feature: String,
}

/// What ended a stage.
///
/// # Example
/// ```
/// use carom_scene::StageEndKind;
/// assert_eq!(serde_json::to_string(&StageEndKind::LiesDown)?, r#""lies_down""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StageEndKind {
    /// A gap closed.
    Touches,
    /// The part lay down on what it touched already.
    LiesDown,
    /// The centre of a part that slid came to an edge.
    CentreAtEdge,
    /// A normal force came to zero.
    LiftsOff,
    /// A slip came to zero.
    SlipStops,
    /// Friction held as much as it can.
    FrictionGivesWay,
    /// A contact came to the end of its features.
    RunsOff,
    /// A normal force grew without bound: Painlevé's paradox.
    Painleve,
    /// Nothing changes any more.
    Rests,
    /// It flies and can meet nothing any more.
    FliesAway,
    /// It swings to and fro without loss, and nothing is left that could end it.
    Swings,
    /// Another part of a feed.
    OtherPart,
    /// The time asked for is over.
    TimeUp,
    /// Strikes that are told together.
    Strikes,
    /// Ever smaller strikes, at their limit.
    StrikesToLimit,
}

/// What was watched when a stage ended.
///
/// # Example
/// ```
/// use carom_scene::WatchedQuantity;
/// assert_eq!(serde_json::to_string(&WatchedQuantity::NormalForce)?, r#""normal_force""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WatchedQuantity {
    /// Distance of two features.
    Gap,
    /// Sine of the angle between a face and what it comes to lie on.
    Angle,
    /// Normal force of a contact.
    NormalForce,
    /// Slip velocity of a contact.
    Slip,
    /// How much more friction a contact could carry.
    FrictionLeft,
    /// Distance to the end of a contact's features.
    Extent,
    /// Normal acceleration per normal force of a contact that slides.
    Response,
    /// Number of strikes.
    Strikes,
}

/// The unit of an amount, SI.
///
/// # Example
/// ```
/// use carom_scene::AmountUnit;
/// assert_eq!(serde_json::to_string(&AmountUnit::MetrePerSecond)?, r#""m/s""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub enum AmountUnit {
    /// Metre.
    #[serde(rename = "m")]
    Metre,
    /// Metre per second.
    #[serde(rename = "m/s")]
    MetrePerSecond,
    /// Newton.
    #[serde(rename = "N")]
    Newton,
    /// One per kilogram.
    #[serde(rename = "1/kg")]
    PerKilogram,
    /// Joule.
    #[serde(rename = "J")]
    Joule,
    /// A pure number.
    #[serde(rename = "1")]
    One,
}

/// Why a stage ended.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StageEndReport {
    /// What happened.
    pub kind: StageEndKind,
    /// Where; null where it is no single contact.
    pub contact: Option<TouchReport>,
    /// What was watched; null where nothing was.
    pub quantity: Option<WatchedQuantity>,
    /// What it came to; null where nothing was watched.
    pub amount: Option<f64>,
    /// The unit of the amount; null where nothing was watched.
    pub unit: Option<AmountUnit>,
    /// The plates and walls struck by the strikes that are told together; empty for every other kind.
    pub plates: Vec<String>,
}

/// What a decision was about.
///
/// # Example
/// ```
/// use carom_scene::DecidedKind;
/// assert_eq!(serde_json::to_string(&DecidedKind::Impact)?, r#""impact""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DecidedKind {
    /// Nothing was decided.
    Nothing,
    /// Which contacts hold, stick or slip.
    Contacts,
    /// The course of an impact.
    Impact,
}

/// What the tightest decision of a run was about.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DecidedReport {
    /// What it was.
    pub kind: DecidedKind,
    /// When [s]; null where nothing was decided.
    pub t_s: Option<f64>,
}

/// Which of the two keeps a jammed part.
///
/// # Example
/// ```
/// use carom_scene::JamReportKind;
/// assert_eq!(serde_json::to_string(&JamReportKind::Wedged)?, r#""wedged""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum JamReportKind {
    /// It rests, held by contacts on several plates or walls.
    Wedged,
    /// No motion of its contacts is consistent, and no impact resolves them.
    Unresolved,
}

/// Between what a part jammed.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JamReport {
    /// Which of the two it is.
    pub kind: JamReportKind,
    /// The contacts that hold it, or that no impact resolves.
    pub contacts: Vec<TouchReport>,
}

pub(crate) fn jam_report<N: Names>(feeder: &N, jam: &Jam<N::Feature>) -> JamReport {
    let kind = match jam.kind {
        JamKind::Wedged => JamReportKind::Wedged,
        JamKind::Unresolved => JamReportKind::Unresolved,
    };
    JamReport { kind, contacts: jam.contacts.iter().map(|touch| touch_report(feeder, touch)).collect() }
}

pub(crate) fn decided_report(decided: Decided) -> DecidedReport {
    let (kind, t_s) = match decided {
        Decided::Nothing => (DecidedKind::Nothing, None),
        Decided::Contacts { time } => (DecidedKind::Contacts, Some(time)),
        Decided::Impact { time } => (DecidedKind::Impact, Some(time)),
    };
    DecidedReport { kind, t_s }
}

fn touch_report<N: Names>(feeder: &N, touch: &Touch<N::Feature>) -> TouchReport {
    TouchReport { plate: feeder.given(touch.obstacle).to_owned(), feature: feeder.part_of(&touch.feature) }
}

#[expect(clippy::cast_precision_loss, reason = "a count of strikes is small")]
pub(crate) fn stage_end_report<N: Names>(feeder: &N, end: &StageEnd<N::Feature>) -> StageEndReport {
    use WatchedQuantity as Quantity;
    let at = |kind, touch: &Touch<N::Feature>, (quantity, unit)| StageEndReport {
        kind,
        contact: Some(touch_report(feeder, touch)),
        quantity: Some(quantity),
        amount: Some(0.0),
        unit: Some(unit),
        plates: vec![],
    };
    let alone = |kind| StageEndReport {
        kind,
        contact: None,
        quantity: None,
        amount: None,
        unit: None,
        plates: vec![],
    };
    let force = (Quantity::NormalForce, AmountUnit::Newton);
    match end {
        StageEnd::Touches(t) => at(StageEndKind::Touches, t, (Quantity::Gap, AmountUnit::Metre)),
        StageEnd::LiesDown(t) => at(StageEndKind::LiesDown, t, (Quantity::Angle, AmountUnit::One)),
        StageEnd::CentreAtEdge(t) => at(StageEndKind::CentreAtEdge, t, force),
        StageEnd::LiftsOff(t) => at(StageEndKind::LiftsOff, t, force),
        StageEnd::SlipStops(t) => {
            at(StageEndKind::SlipStops, t, (Quantity::Slip, AmountUnit::MetrePerSecond))
        }
        StageEnd::FrictionGivesWay(t) => {
            at(StageEndKind::FrictionGivesWay, t, (Quantity::FrictionLeft, AmountUnit::Newton))
        }
        StageEnd::RunsOff(t) => at(StageEndKind::RunsOff, t, (Quantity::Extent, AmountUnit::Metre)),
        StageEnd::Painleve(t) => at(StageEndKind::Painleve, t, (Quantity::Response, AmountUnit::PerKilogram)),
        StageEnd::Rests => alone(StageEndKind::Rests),
        StageEnd::FliesAway => alone(StageEndKind::FliesAway),
        StageEnd::Swings => alone(StageEndKind::Swings),
        StageEnd::OtherPart => alone(StageEndKind::OtherPart),
        StageEnd::TimeUp => alone(StageEndKind::TimeUp),
        StageEnd::Strikes { count, obstacles, limit } => StageEndReport {
            quantity: Some(Quantity::Strikes),
            amount: Some(*count as f64),
            unit: Some(AmountUnit::One),
            plates: obstacles.iter().map(|o| feeder.given(*o).to_owned()).collect(),
            ..alone(if *limit { StageEndKind::StrikesToLimit } else { StageEndKind::Strikes })
        },
    }
}
