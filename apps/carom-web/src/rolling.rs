//! A body that rolls in the plane: its motion, its picture and its words.

use crate::fields::{fields, moved, written};
use crate::reply::{Failure, Headline, Reply, Sections, Seen};
use crate::request::{Change, Frame, Window};
use carom::tasks::roll::RollStudy;
use carom_scene::{Form, RollKind, RollProblem, RollProblems};
use carom_words::Words;
use serde_json::value::RawValue;

impl From<RollProblems> for Failure {
    fn from(found: RollProblems) -> Self {
        // Without overrides all of them are the file's.
        match found.0.into_iter().next() {
            Some(problems) => problems.into(),
            None => Self::of_page("the file has problems"),
        }
    }
}

/// Everything about a roll after a change.
pub(crate) fn shown(
    kind: RollKind,
    name: &str,
    text: &str,
    change: Option<&Change>,
    frame: Frame,
) -> Result<Reply, Failure> {
    let text = match change {
        Some(Change::Write { path, value }) => written(text, path, value)?,
        Some(Change::Move { values }) => moved(Form::Roll(kind), text, values)?,
        Some(_) => {
            return Err(Failure::of_page("a body that rolls has values to write, and nothing to draw"));
        }
        None => text.to_owned(),
    };
    let study = RollStudy::of(RollProblem::parse(kind, name, &text, &[])?)
        .map_err(|fault| Failure::of_page(&fault.to_string()))?;
    let view = match frame {
        Frame::Size(size) => study.view(size.map(|side| side.max(1.0))),
        Frame::Window(window) => window.view()?,
    };
    let live = study.live(&view);
    let words = format!("A {} rolls: {}.", kind.word(), study.verdict());
    let motion = RawValue::from_string(live.motion).map_err(Failure::from)?;
    Ok(Reply {
        kind: Some("roll"),
        window: Some(Window::of(&view)),
        seen: Some(Seen { scene: live.scene, motion, grips: vec![], words }),
        headline: Some(Headline { word: study.verdict(), plate: None, wanted: None }),
        sections: Some(Sections {
            verdict: live.said,
            timeline: live.strikes,
            part: String::new(),
            stages: String::new(),
            model: live.hypotheses,
        }),
        quantities: Some(fields(Form::Roll(kind), &text)),
        controls: Some(live.controls),
        text: Some(text),
        ..Reply::default()
    })
}

/// The files that `carom roll` writes.
pub(crate) fn files(kind: RollKind, name: &str, text: &str) -> Result<Reply, Failure> {
    let study = RollStudy::of(RollProblem::parse(kind, name, text, &[])?)
        .map_err(|fault| Failure::of_page(&fault.to_string()))?;
    let json = format!("{}\n", serde_json::to_string_pretty(&study.report)?);
    let files = [("roll.json", json), ("report.html", study.page(name))];
    Ok(Reply { files: Some(crate::answer::named(files)), ..Reply::default() })
}
