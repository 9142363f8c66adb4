//! What a run of a feeder says.

use crate::Feeder;
use carom_motion::planar::trace::{Impact, Trace};
use carom_motion::planar::{Feature, RestKind, State};

/// How a run ends: in exactly one of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// Flat on the last plate.
    Landed,
    /// Left over the last plate's edge.
    Delivered,
    /// Friction holds it.
    Stuck,
    /// It rests on an end.
    OnEnd,
    /// It rests wedged between obstacles, or no impact resolves its contacts: [`Run::jam`] says which.
    Jammed,
    /// It fell past the last plate without touching it.
    Missed,
    /// It touched the last plate and left it before lying flat.
    Escaped,
    /// The budget of events or time ran out, or it swings to and fro for ever without loss.
    NeverFlat,
    /// More contacts met at once than could be resolved.
    Unresolved,
    /// It did not start: another part stood in its place. Only in a feed.
    Blocked,
}

/// Which face is down when the part first lies flat on a plate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// The face that was down at the start.
    Same,
    /// The opposite face.
    Turned,
    /// Any other face, by number.
    Face(usize),
}

/// One landing: the part's first lying flat on a plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landing {
    /// Number of the plate.
    pub plate: usize,
    /// Against the start; `None` for a disc.
    pub verdict: Option<Verdict>,
    /// Against the plate before; `None` for a disc.
    pub turned_here: Option<bool>,
    /// The face that is down; `None` for a disc.
    pub face: Option<usize>,
    /// First touch of this plate [s].
    pub first_touch: f64,
    /// Flat [s]; `None` for a disc.
    pub flat: Option<f64>,
    /// Speed of the striking point when it first strikes this plate; 0 where it never does [m/s].
    pub impact_speed: f64,
    /// Highest speed of the striking point in any strike on this plate, after it has come to lie there as well; 0 where there is none [m/s].
    pub max_impact_speed: f64,
    /// Largest slip velocity of a contact on this plate [m/s].
    pub max_sliding_speed: f64,
}

/// How the part left over the last plate's edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exit {
    /// Time [s].
    pub time: f64,
    /// Pose and velocity.
    pub state: State,
}

/// Deterministic counts of the work done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Evaluations of a mode's forces and accelerations.
    pub rhs_evaluations: u64,
    /// Steps of the integration.
    pub steps: u64,
    /// Evaluations of event functions.
    pub event_evaluations: u64,
    /// Rate problems that were asked between impacts.
    pub rate_problems: u64,
    /// Events.
    pub events: u64,
    /// Impacts.
    pub impacts: u64,
}

/// The names of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum StageName {
    /// Lies flat on a plate and slides.
    Slide,
    /// Turns over a plate's end.
    Tip,
    /// Touches nothing.
    Flight,
    /// One corner on a plate, turning.
    Swing,
    /// One corner on a plate, sticking there.
    Stick,
    /// A rounded part rolls.
    Roll,
    /// Touches two obstacles and moves.
    Wedge,
    /// Touches another part of a feed, and moves.
    Push,
    /// Nothing moves.
    Rest,
    /// Many strikes on one obstacle, one soon after the other: often infinitely many in finite time.
    Clatter,
}

/// A feature of the part on an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch<F = Feature> {
    /// Number of the obstacle: plates first, then walls, then the parts of a feed.
    pub obstacle: usize,
    /// The features that touch.
    pub feature: F,
}

/// Why a stage ended: what came to zero, and where.
#[derive(Clone, Debug, PartialEq)]
pub enum StageEnd<F = Feature> {
    /// A gap closed.
    Touches(Touch<F>),
    /// The part lay down on an obstacle that it touched already.
    LiesDown(Touch<F>),
    /// The normal force came to zero on a part that slid: its centre is at an edge.
    CentreAtEdge(Touch<F>),
    /// The normal force came to zero.
    LiftsOff(Touch<F>),
    /// A slip came to zero.
    SlipStops(Touch<F>),
    /// Friction held as much as it can.
    FrictionGivesWay(Touch<F>),
    /// A contact came to the end of its features.
    RunsOff(Touch<F>),
    /// A normal force grew without bound: Painlevé's paradox.
    Painleve(Touch<F>),
    /// Nothing changes any more.
    Rests,
    /// It flies and can meet nothing any more.
    FliesAway,
    /// It swings to and fro without loss, and nothing is left that could end it.
    Swings,
    /// Another part that it touches brought it.
    OtherPart,
    /// The time asked for is over.
    TimeUp,
    /// A clatter is over.
    Strikes {
        /// How many.
        count: usize,
        /// The obstacles that were struck, in the order of their first strike.
        obstacles: Vec<usize>,
        /// True where a series of ever smaller ones came to its limit.
        limit: bool,
    },
}

/// What the tightest decision of a run was about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Decided {
    /// Nothing was decided.
    Nothing,
    /// Which contacts hold, stick or slip.
    Contacts {
        /// When [s].
        time: f64,
    },
    /// The course of an impact.
    Impact {
        /// When [s].
        time: f64,
    },
}

/// Which of the two it is that keeps a jammed part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JamKind {
    /// It rests, and contacts on several obstacles hold it.
    Wedged,
    /// Its contacts have no consistent motion, and no impact resolves them: here rigid bodies with friction have no answer.
    Unresolved,
}

/// Between what a part jammed.
#[derive(Clone, Debug, PartialEq)]
pub struct Jam<F = Feature> {
    /// Which of the two it is.
    pub kind: JamKind,
    /// The contacts that hold it, or that no impact resolves.
    pub contacts: Vec<Touch<F>>,
}

/// One stage of the table: neighbouring pieces of the trace with one name on one plate.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage<S = State, F = Feature> {
    /// Its name.
    pub name: StageName,
    /// The obstacle it happens on: plates first, then walls; `None` in flight.
    pub obstacle: Option<usize>,
    /// Start [s].
    pub start_time: f64,
    /// End [s].
    pub end_time: f64,
    /// Pose and velocity at the start.
    pub start: S,
    /// Pose and velocity at the end.
    pub end: S,
    /// Why it ended.
    pub ended_by: StageEnd<F>,
    /// Its pieces: a range of `trace.pieces`.
    pub pieces: std::ops::Range<usize>,
}

/// One run.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// How it ended.
    pub outcome: Outcome,
    /// When it ended [s].
    pub end_time: f64,
    /// The landings, in order.
    pub landings: Vec<Landing>,
    /// The walls that it touched on its way, struck or held, by their numbers from 0.
    pub walls_touched: Vec<usize>,
    /// How it left, when delivered.
    pub exit: Option<Exit>,
    /// The smallest decided inequality divided by the sum of its terms' magnitudes.
    pub margin: f64,
    /// What that decided.
    pub margin_of: Decided,
    /// Between what it jammed; `None` for every other outcome.
    pub jam: Option<Jam>,
    /// How near the part came to the last plate in the flight in which it missed it [m]; `None` for every other outcome.
    pub missed_by: Option<f64>,
    /// Counts of the work done.
    pub effort: Effort,
    /// Stages by name; empty without a trace.
    pub stages: Vec<Stage>,
    /// Everything, in order of time; empty without a trace.
    pub trace: Trace,
}

impl Run {
    /// The landing with which the run ended: the last one, where the part stayed on that plate or was delivered from it.
    pub fn final_landing(&self) -> Option<&Landing> {
        let stays = matches!(self.outcome, Outcome::Landed | Outcome::Delivered | Outcome::Stuck);
        self.landings.last().filter(|_| stays)
    }

    /// The first strike on the plate of the final landing: the one that decides. `None` without a trace.
    pub fn deciding_strike(&self) -> Option<&Impact> {
        let landing = self.final_landing()?;
        let on_plate =
            |impact: &&Impact| impact.contacts.first().is_some_and(|c| c.obstacle == landing.plate);
        self.trace.impacts.iter().find(on_plate)
    }

    /// Speed of the striking point just before the deciding strike [m/s].
    pub fn struck_at(&self) -> Option<f64> {
        let before = self.deciding_strike()?.contacts.first()?.before;
        Some((before.slip * before.slip + before.normal * before.normal).sqrt())
    }

    /// The face on whose arc the part swings to and fro at the end, by its number; `None` of every other end, and without a trace.
    pub fn swings_on(&self, feeder: &Feeder) -> Option<usize> {
        let last = self.stages.last().filter(|stage| stage.ended_by == StageEnd::Swings)?;
        let shape = &feeder.part.body.shape;
        let face = shape.rest_below(last.end.pose.down())?;
        shape.rests().get(face).filter(|rest| rest.kind == RestKind::Arc).map(|_| face)
    }

    /// A part that has not moved yet.
    pub(crate) fn without_motion(outcome: Outcome, time: f64) -> Self {
        Self {
            outcome,
            end_time: time,
            landings: vec![],
            walls_touched: vec![],
            exit: None,
            margin: f64::INFINITY,
            margin_of: Decided::Nothing,
            jam: None,
            missed_by: None,
            effort: Effort::default(),
            stages: vec![],
            trace: Trace::default(),
        }
    }
}
