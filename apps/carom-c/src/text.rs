//! Files in, the command's JSON out.

use crate::refusal::Refusal;
use carom::tasks;
use carom::tasks::impact::ImpactStudy;
use carom::tasks::impact::space::SpatialImpactStudy;
use carom_scene::{AnyImpact, AnyScene, Problems, Scene, SpaceRunReport, toml_of_json};
use std::borrow::Cow;

/// An answer as JSON, and why it is not the whole answer, where that is so.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) json: String,
    pub(crate) undone: Option<Refusal>,
}

/// TOML of what was given: TOML, or one JSON object. No TOML begins with a brace.
fn toml<'t>(name: &str, text: &'t str) -> Result<Cow<'t, str>, Problems> {
    let begins = text.trim_start_matches('\u{feff}').trim_start();
    if begins.starts_with('{') { toml_of_json(name, begins).map(Cow::Owned) } else { Ok(Cow::Borrowed(text)) }
}

/// A scene from its text.
pub(crate) fn scene(name: &str, text: &str) -> Result<Scene, Refusal> {
    Ok(Scene::parse(name, &toml(name, text)?)?)
}

/// Why a scene has no run, as the command says it.
pub(crate) fn no_run(scene: &str, why: impl std::fmt::Display) -> Refusal {
    Refusal::of_failure(format!("{scene}: {why}"))
}

/// What `carom impact` prints.
pub(crate) fn impact(name: &str, text: &str) -> Result<Answer, Refusal> {
    match AnyImpact::parse(name, &toml(name, text)?)? {
        AnyImpact::Planar(problem) => {
            let ImpactStudy { problem, answer, report } = ImpactStudy::of(*problem);
            let undone = answer.undone().map(|why| {
                let why = carom_words::impact::failure(&problem.names, &why);
                Refusal::of_failure(format!("no answer: {why}"))
            });
            Ok(Answer { json: serde_json::to_string_pretty(&report)? + "\n", undone })
        }
        AnyImpact::Spatial(problem) => {
            let report = SpatialImpactStudy::of(*problem).report;
            Ok(Answer { json: serde_json::to_string_pretty(&report)? + "\n", undone: None })
        }
    }
}

/// What `carom run` prints.
pub(crate) fn run(name: &str, text: &str) -> Result<Answer, Refusal> {
    let json = match AnyScene::parse(name, &toml(name, text)?)? {
        AnyScene::Plane(scene) => {
            let run = scene.feeder().run().map_err(|error| no_run(scene.name(), error))?;
            let fed = tasks::feed(&scene);
            let fed = fed.map_err(|error| no_run(scene.name(), format!("the feed: {error}")))?;
            serde_json::to_string_pretty(&tasks::run_report(&scene, &run, fed.as_ref(), None))?
        }
        AnyScene::Space(scene) => {
            let run = scene.feeder().run().map_err(|error| no_run(scene.name(), error))?;
            serde_json::to_string_pretty(&SpaceRunReport::new(&scene, &run))?
        }
    };
    Ok(Answer { json: json + "\n", undone: None })
}
