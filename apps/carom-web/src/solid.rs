//! What moves in space: a body that rolls or is thrown, and a solid part that goes through a feeder. Its motion, its picture and its words.

use crate::answer::named;
use crate::fields::{fields, moved, written};
use crate::reply::{Failure, Headline, Reply, SolidShown};
use crate::request::{Change, Frame, Request, Window};
use carom::tasks::solid::{SolidStudy, words};
use carom::tasks::space;
use carom_figure::LiveSolid;
use carom_scene::input::InMemory;
use carom_scene::{Drawn, Form, SpaceScene, SpatialRollKind, SpatialRollProblem};
use carom_words::{Words, run as run_words};
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
    let text = changed(form, text, change)?;
    let study = study(kind, (name, &text), files)?;
    let word = words::headline(&study.report);
    let words = format!("A {} in space: {word}.", kind.word());
    let headline = Headline { word, plate: None, wanted: None };
    Ok(Reply { kind: Some("solid"), ..reply(study.live(), (headline, words), frame, (form, text))? })
}

/// Everything about a feeder and the solid part that goes through it, after a change.
pub(crate) fn through_feeder(
    request: &Request,
    change: Option<&Change>,
    frame: Frame,
) -> Result<Reply, Failure> {
    let text = changed(Form::Scene, &request.text, change)?;
    let scene = SpaceScene::parse_with(&request.name, &text, &request.files())?;
    let run = scene.feeder().run()?;
    let live = space::live(&scene, &run);
    let headline = headline(&scene, &run, scene.ends_as_wanted(&run));
    let words = format!("A solid part goes through the feeder: {}.", headline.words());
    Ok(Reply { kind: Some("space"), ..reply(live, (headline, words), frame, (Form::Scene, text))? })
}

/// How a solid part came out of its feeder.
pub(crate) fn headline(
    scene: &SpaceScene,
    run: &carom_feeder::spatial::Run,
    wanted: Option<bool>,
) -> Headline {
    let found = run_words::headline_in_space(scene.feeder(), run);
    Headline { word: found.word, plate: found.plate, wanted }
}

/// The text after a change. What moves in space is turned with the pointer, not dragged: its values are written.
fn changed(form: Form, text: &str, change: Option<&Change>) -> Result<String, Failure> {
    match change {
        Some(Change::Write { path, value }) => written(text, path, value),
        Some(Change::Move { values }) => moved(form, text, values),
        Some(_) => Err(Failure::of_page("in space values are written, and nothing is drawn by the pointer")),
        None => Ok(text.to_owned()),
    }
}

fn reply(
    live: LiveSolid,
    (headline, words): (Headline, String),
    frame: Frame,
    (form, text): (Form, String),
) -> Result<Reply, Failure> {
    let motion = RawValue::from_string(live.motion)?;
    Ok(Reply {
        // The view is turned, not moved: the page keeps the window that it has.
        window: Some(match frame {
            Frame::Window(window) => window,
            Frame::Size(size) => Window { low: [0.0; 2], scale: 1.0, size, speed: 0.0 },
        }),
        solid: Some(SolidShown { player: live.player, motion, chart: live.chart, words }),
        headline: Some(headline),
        sections: Some(live.sections.into()),
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

/// The files that `carom run` writes of a scene in space.
pub(crate) fn files_of_run(scene: &SpaceScene) -> Result<Reply, Failure> {
    let files = space::run_files(scene, &scene.feeder().run()?, None)?;
    Ok(Reply { files: Some(named(files)), ..Reply::default() })
}
