//! What the page is answered.

use crate::request::{Held, Pulled, Window};
use carom_feeder::RunError;
use carom_figure::LiveSections;
use carom_scene::{Limit, LineError, LineProblem, Problems};
use serde::Serialize;
use serde_json::value::RawValue;
use std::collections::BTreeMap;

/// An answer: what was asked for, the rest left out.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Reply {
    /// What kind of file it is: `scene`, `impact`, `roll`; in space `space`, a scene, or `solid`, a body on a plane.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kind: Option<&'static str>,
    /// True where the whole engine answers this: the module has the bench alone.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub elsewhere: bool,
    /// The file as it is now.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
    /// The window of the picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub window: Option<Window>,
    /// What moves and what it moves among.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seen: Option<Seen>,
    /// The picture of a body in space.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub solid: Option<SolidShown>,
    /// How it came out, in a few words.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub headline: Option<Headline>,
    /// The sections of the report, as HTML.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sections: Option<Sections>,
    /// Every quantity of the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quantities: Option<Vec<QuantityShown>>,
    /// Clock, ribbon and buttons of the player, as HTML.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub controls: Option<String>,
    /// One piece of HTML.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub html: Option<String>,
    /// Scenes to open.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scenes: Option<Vec<NamedText>>,
    /// What one worker found of long work, for [`Ask::Joined`](crate::Ask::Joined).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub portion: Option<String>,
    /// True where the work needs one more round.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub again: bool,
    /// How far a quantity may move.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<Box<Limit>>,
    /// Files by their names.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub files: Option<BTreeMap<String, String>>,
    /// The impact as it is now.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lab: Option<Box<LabShown>>,
    /// What a design may choose and must keep, as the scene has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub design: Option<DesignAsked>,
    /// What a design found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub found: Option<Box<DesignFound>>,
    /// Why there is no answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<Failure>,
}

/// A scene that can be opened.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NamedText {
    /// The name of its file.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// The picture.
#[derive(Clone, Debug, Serialize)]
pub struct Seen {
    /// Children of the SVG.
    pub scene: String,
    /// The motion, as the player reads it.
    pub motion: Box<RawValue>,
    /// What can be dragged.
    pub grips: Vec<Grip>,
    /// The picture in words, for who does not see it.
    pub words: String,
}

/// A body in space.
#[derive(Clone, Debug, Serialize)]
pub struct SolidShown {
    /// The canvas and what plays it, as HTML.
    pub player: String,
    /// Body and motion, as the player reads them.
    pub motion: Box<RawValue>,
    /// The tilt against time, as HTML.
    pub chart: String,
    /// The picture in words, for who does not see it.
    pub words: String,
}

/// A place where something can be dragged.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Grip {
    /// What it drags, in words.
    pub label: String,
    /// Where it is seen, in pixels.
    pub at: [f64; 2],
    /// What the page gives back.
    pub held: Held,
    /// Paths of what it moves.
    pub moves: Vec<String>,
}

/// How a run came out.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Headline {
    /// One word: `turned`.
    pub word: String,
    /// On which plate.
    pub plate: Option<String>,
    /// Whether it is as wanted; null where nothing is wanted.
    pub wanted: Option<bool>,
}

impl Headline {
    /// As a part of a sentence: `turned on lower, as wanted`.
    pub(crate) fn words(&self) -> String {
        let on = self.plate.as_ref().map(|plate| format!(" on {plate}")).unwrap_or_default();
        let wanted = match self.wanted {
            Some(true) => ", as wanted",
            Some(false) => ", not as wanted",
            None => "",
        };
        format!("{}{on}{wanted}", self.word)
    }
}

/// The sections of a report, as HTML.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Sections {
    /// How it came out.
    pub verdict: String,
    /// In order of time.
    pub timeline: String,
    /// The part.
    pub part: String,
    /// The table of stages.
    pub stages: String,
    /// What else there is to say.
    pub model: String,
}

impl From<LiveSections> for Sections {
    fn from(sections: LiveSections) -> Self {
        let LiveSections { verdict, timeline, part, stages, model } = sections;
        Self { verdict, timeline, part, stages, model }
    }
}

/// A quantity as the page shows it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct QuantityShown {
    /// Its path.
    pub path: String,
    /// What it is called.
    pub label: String,
    /// As the file has it, or its default.
    pub text: String,
    /// True where the file writes it.
    pub written: bool,
    /// Its value or middle, SI.
    pub value: f64,
    /// The interval that it must lie in, SI; null where it has no end.
    pub allowed: [Option<f64>; 2],
    /// The unit of drawings.
    pub unit: String,
    /// How many SI units one of drawings is.
    pub si: f64,
    /// Of an impact: what it means.
    pub about: &'static str,
    /// The words that it may be; empty where it is none of a few.
    pub choices: Vec<&'static str>,
    /// True for a single number.
    pub number: bool,
}

/// An impact on the bench.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct LabShown {
    /// Below the headline: end states and law.
    pub lead: String,
    /// What is struck, as the children of an SVG; empty where it is not drawn.
    pub sketch: String,
    /// Why it is not drawn, where it is not.
    pub unseen: &'static str,
    /// The mass centres in pixels.
    pub centres: Vec<[f64; 2]>,
    /// Velocity [m/s] and spin [rad/s] of each body: before, and after each stage.
    pub motion: Vec<Vec<[f64; 3]>>,
    /// What can be pulled.
    pub grips: Vec<LabGrip>,
    /// The walk, as SVG.
    pub walk: String,
    /// Places in it at the start and at the end of each stage: the number of their contact, and x and y.
    pub tracks: Vec<(usize, Vec<[f64; 2]>)>,
    /// What happens in each stage.
    pub stages: Vec<String>,
    /// Sentences, contacts and bodies after it, as HTML.
    pub after: String,
    /// End states and what rejects the others, as HTML.
    pub hypotheses: String,
    /// What every law makes of it.
    pub laws: Vec<BesideShown>,
    /// What every way to share makes of it.
    pub sharings: Vec<BesideShown>,
    /// What follows under forces.
    pub forces: Option<ForcesShown>,
    /// The picture in words, for who does not see it.
    pub words: String,
}

/// A place where something of an impact can be pulled.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LabGrip {
    /// What it pulls, in words.
    pub label: String,
    /// Where it is seen, in pixels.
    pub at: [f64; 2],
    /// What the page gives back.
    pub pulled: Pulled,
    /// The contact that it is of.
    pub contact: Option<usize>,
}

/// What another law or way to share makes of an impact.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BesideShown {
    /// Its name.
    pub name: String,
    /// Where it ends, or why not.
    pub said: String,
    /// Kinetic energy before and after [J].
    pub energy: Option<[f64; 2]>,
    /// True for the one that the impact asks for.
    pub asked: bool,
}

/// What follows under forces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ForcesShown {
    /// In a few words.
    pub headline: String,
    /// Motions that all laws allow, each with its forces.
    pub motions: Vec<[String; 2]>,
    /// What rejects the others.
    pub rejected: Vec<[String; 2]>,
}

/// What a design may choose, must keep and aims at.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DesignAsked {
    /// What is wanted on each plate: its label, and the word in the file or nothing.
    pub wants: Vec<[String; 2]>,
    /// Quantities that may be chosen.
    pub free: Vec<FreeRange>,
    /// What may be limited.
    pub limits: Vec<DesignLimit>,
    /// True where the part may touch no wall.
    pub forbid_walls: bool,
    /// What it is to be best at, and what else there is.
    pub aim: &'static str,
    /// Every word of an aim.
    pub aims: Vec<&'static str>,
}

/// A quantity that may be chosen, with its ends in SI.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FreeRange {
    /// Its path.
    pub path: String,
    /// Lowest value.
    pub from: f64,
    /// Highest value.
    pub to: f64,
}

/// What may be limited: its key in the file, its words, and the limit as it would be written, or nothing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DesignLimit {
    /// `max_height`.
    pub key: &'static str,
    /// `highest feeder`.
    pub label: &'static str,
    /// `0.6 m`, or empty.
    pub text: String,
    /// `m`.
    pub unit: &'static str,
}

/// What a design found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DesignFound {
    /// In one sentence.
    pub verdict: String,
    /// Whether there is a layout that meets every demand.
    pub possible: bool,
    /// What must be said beside it.
    pub said: Vec<String>,
    /// The winner first, then layouts none of which is worse than another in all that matters.
    pub candidates: Vec<Candidate>,
    /// What each demand forbids: a table with its head.
    pub forbidden: Vec<Vec<String>>,
    /// The files of the winner by their names.
    pub files: BTreeMap<String, String>,
}

/// A layout to look at and to take.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Candidate {
    /// The scene.
    pub text: String,
    /// How it ends.
    pub words: String,
    /// Children of a small SVG, and its width and height.
    pub picture: String,
    /// Width and height of the picture.
    pub size: [f64; 2],
    /// What it measures, and the quantities that were chosen: names and values.
    pub rows: Vec<[String; 2]>,
}

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Failure {
    /// One sentence.
    pub message: String,
    /// Every problem of the scene.
    pub problems: Vec<LineProblem>,
    /// The lines of the problems in the scene's text, from 1; null for what has no place.
    pub lines: Vec<Option<usize>>,
}

impl Failure {
    /// Of the page itself: a request that makes no sense.
    pub fn of_page(message: &str) -> Self {
        Self { message: message.to_owned(), problems: vec![], lines: vec![] }
    }
}

impl From<Problems> for Failure {
    fn from(found: Problems) -> Self {
        let line = |problem: &carom_scene::Problem| {
            problem.span.as_ref().map(|span| found.line_and_column(span.start).0)
        };
        let lines = found.list.iter().map(line).collect();
        let message = match found.list.len() {
            1 => "one problem".to_owned(),
            several => format!("{several} problems"),
        };
        Self { message, lines, problems: LineError::of_input(0, &[found]).error.problems }
    }
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        Self::of_page(&error.to_string())
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        Self::of_page(&error.to_string())
    }
}

impl Reply {
    pub(crate) fn of_failure(failure: Failure) -> Self {
        Self { failure: Some(failure), ..Self::default() }
    }
}
