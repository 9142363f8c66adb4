//! A body in space that rolls or is thrown: its motion, its picture and its words.

use crate::answer::named;
use crate::fields::{fields, moved, written};
use crate::reply::{Failure, Headline, Reply, Sections, SolidShown};
use crate::request::{Change, Frame, Window};
use carom::tasks::solid::{SolidStudy, words};
use carom_scene::input::InMemory;
use carom_scene::{Form, SpatialRollKind, SpatialRollProblem};
use carom_words::Words;
use serde_json::value::RawValue;

/// Everything about a body in space after a change.
pub(crate) fn shown(
    kind: SpatialRollKind,
    (name, text): (&str, &str),
    change: Option<&Change>,
    frame: Frame,
    files: &InMemory,
) -> Result<Reply, Failure> {
    let form = Form::SpatialRoll(kind);
    let text = match change {
        Some(Change::Write { path, value }) => written(text, path, value)?,
        Some(Change::Move { values }) => moved(form, text, values)?,
        Some(_) => return Err(Failure::of_page("a body in space has values to write, and nothing to draw")),
        None => text.to_owned(),
    };
    let study = study(kind, (name, &text), files)?;
    let live = study.live();
    let verdict = words::headline(&study.report);
    Ok(Reply {
        kind: Some("solid"),
        // The view is turned, not moved: the page keeps the window that it has.
        window: Some(match frame {
            Frame::Window(window) => window,
            Frame::Size(size) => Window { low: [0.0; 2], scale: 1.0, size, speed: 0.0 },
        }),
        solid: Some(SolidShown {
            player: live.player,
            motion: RawValue::from_string(live.motion)?,
            chart: live.chart,
            words: format!("A {} in space: {verdict}.", kind.word()),
        }),
        headline: Some(Headline { word: verdict, plate: None, wanted: None }),
        sections: Some(Sections {
            verdict: live.said,
            timeline: live.strikes,
            part: String::new(),
            stages: String::new(),
            model: live.states,
        }),
        quantities: Some(fields(form, &text)),
        text: Some(text),
        ..Reply::default()
    })
}

fn study(kind: SpatialRollKind, (name, text): (&str, &str), files: &InMemory) -> Result<SolidStudy, Failure> {
    let problem = SpatialRollProblem::parse_with(kind, name, text, &[], files)?;
    SolidStudy::of(problem).map_err(|fault| Failure::of_page(&fault.to_string()))
}

/// The files that `carom roll` writes. The command sets what the literature says beside the strikes of pyramids and stools.
pub(crate) fn files(
    kind: SpatialRollKind,
    (name, text): (&str, &str),
    files: &InMemory,
) -> Result<Reply, Failure> {
    let study = study(kind, (name, text), files)?;
    let json = format!("{}\n", serde_json::to_string_pretty(&study.report)?);
    let files = [("roll.json", json), ("report.html", study.page(name))];
    Ok(Reply { files: Some(named(files)), ..Reply::default() })
}
