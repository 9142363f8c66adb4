//! One question at a time: the answer as the command writes it.

use crate::failure::{of_fault, of_input, of_inputs, of_words};
use crate::scene::{Scene, each};
use crate::watch::long;
use carom::tasks;
use carom::tasks::StudyError;
use carom::tasks::design::{DesignPlan, DesignStudy, Designed, design_space};
use carom::tasks::impact::ImpactStudy;
use carom::tasks::impact::space::SpatialImpactStudy;
use carom::tasks::roll::RollStudy;
use carom::tasks::solid::SolidStudy;
use carom_scene::{
    AnyImpact, AnyScene, ForceAnswerReport, FoundLimits, ImpactProblem, RollKind, RollProblem,
    SpatialRollKind, SpatialRollProblem, StudyRunReport,
};
use carom_words::Words;
use pyo3::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::time::Instant;

/// An answer as JSON, and the files that come with it, by their names.
pub(crate) type Answer = (String, BTreeMap<String, String>);
/// The same with files that are no texts.
pub(crate) type Tabled = (String, BTreeMap<String, String>, BTreeMap<String, Vec<u8>>);

pub(crate) fn pretty(value: &impl Serialize) -> PyResult<String> {
    serde_json::to_string_pretty(value).map(|text| text + "\n").map_err(of_fault)
}

pub(crate) fn named<N: Into<String>>(
    files: impl IntoIterator<Item = (N, String)>,
) -> BTreeMap<String, String> {
    files.into_iter().map(|(name, text)| (name.into(), text)).collect()
}

pub(crate) fn spent(drops: usize, begun: Instant, threads: usize) -> StudyRunReport {
    StudyRunReport { drops, seconds: begun.elapsed().as_secs_f64(), threads }
}

/// Why a study has no answer, as the package's exception.
pub(crate) fn refused(py: Python<'_>, error: &StudyError) -> PyErr {
    match error {
        StudyError::Input(problems) => of_inputs(py, problems),
        StudyError::Asked(message) | StudyError::Undone(message) => of_words(py, message),
    }
}

/// TOML of what was given: TOML, or one JSON object.
pub(crate) fn toml(py: Python<'_>, name: &str, text: &str, json: bool) -> PyResult<String> {
    if !json {
        return Ok(text.to_owned());
    }
    carom_scene::toml_of_json(name, text).map_err(|problems| of_input(py, &problems))
}

/// The TOML of one JSON object.
#[pyfunction]
pub(crate) fn toml_of_json(py: Python<'_>, name: &str, json: &str) -> PyResult<String> {
    toml(py, name, json, true)
}

/// What `carom run` says and writes.
#[pyfunction]
#[pyo3(signature = (scene, limits=false, progress=None))]
pub(crate) fn run(
    py: Python<'_>,
    scene: &Scene,
    limits: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Tabled> {
    let undone = |error: carom::feeder::RunError| of_words(py, &format!("{}: {error}", scene.inner.name()));
    let (files, motion) = match &scene.inner {
        AnyScene::Plane(scene) => {
            let done = long(py, None, progress, |watch| {
                let run = scene.feeder().run()?;
                let fed = tasks::feed(scene)?;
                let found = limits.then(|| FoundLimits::of(&**scene, &mut |_, _| watch.step()));
                Ok::<_, carom::feeder::RunError>((run, fed, found))
            })?;
            let (run, fed, found) = done.map_err(undone)?;
            (named(tasks::run_files(scene, &run, fed.as_ref(), found.as_ref()).map_err(of_fault)?), None)
        }
        AnyScene::Space(scene) => {
            let done = long(py, None, progress, |watch| {
                let run = scene.feeder().run()?;
                Ok::<_, carom::feeder::RunError>((
                    run,
                    limits.then(|| FoundLimits::of(&**scene, &mut |_, _| watch.step())),
                ))
            })?;
            let (run, found) = done.map_err(undone)?;
            let motion = carom::figure::space_glb(scene.feeder(), &run);
            (named(tasks::space::run_files(scene, &run, found.as_ref()).map_err(of_fault)?), Some(motion))
        }
    };
    let (mut files, motion) = (files, motion.map(|motion| ("motion.glb".to_owned(), motion)));
    let json = files.remove("run.json").unwrap_or_default();
    Ok((json, files, motion.into_iter().collect()))
}

/// What `carom impact` says and writes.
#[pyfunction]
pub(crate) fn impact(py: Python<'_>, name: &str, text: &str, json: bool) -> PyResult<Answer> {
    let text = toml(py, name, text, json)?;
    let problem = AnyImpact::parse(name, &text).map_err(|problems| of_input(py, &problems))?;
    let title = name.rsplit('/').next().unwrap_or(name);
    let title = title.strip_suffix(".toml").unwrap_or(title);
    py.detach(|| match problem {
        AnyImpact::Planar(problem) => {
            let study = ImpactStudy::of(*problem);
            let files = study.files(title, &text).map_err(of_fault)?;
            Ok((pretty(&study.report)?, named(files)))
        }
        AnyImpact::Spatial(problem) => {
            let study = SpatialImpactStudy::of(*problem);
            let page = study.page(title, &text);
            Ok((pretty(&study.report)?, named([("report.html", page)])))
        }
    })
}

/// What `carom contact` says.
#[pyfunction]
pub(crate) fn contact(py: Python<'_>, name: &str, text: &str, json: bool) -> PyResult<Answer> {
    let text = toml(py, name, text, json)?;
    let problem = ImpactProblem::parse(name, &text).map_err(|problems| of_input(py, &problems))?;
    let answer = py.detach(|| problem.under_forces(name)).map_err(|problems| of_input(py, &problems))?;
    Ok((pretty(&ForceAnswerReport::new(&problem, &answer))?, BTreeMap::new()))
}

/// What `carom roll` says and writes.
#[pyfunction]
pub(crate) fn roll(
    py: Python<'_>,
    kind: &str,
    name: &str,
    text: &str,
    json: bool,
    set: Vec<String>,
) -> PyResult<Answer> {
    let text = toml(py, name, text, json)?;
    let planar = [RollKind::Cylinder, RollKind::Prism, RollKind::Rod].into_iter();
    let spatial = [SpatialRollKind::Pyramid, SpatialRollKind::Stool, SpatialRollKind::Body].into_iter();
    if let Some(kind) = planar.clone().find(|known| known.word() == kind) {
        let problem = RollProblem::parse(kind, name, &text, &set).map_err(|found| of_inputs(py, &found.0))?;
        let study = py.detach(|| RollStudy::of(problem));
        let study = study.map_err(|error| of_words(py, &format!("{name}: {error}")))?;
        let page = study.page(name);
        return Ok((pretty(&study.report)?, named([("report.html", page)])));
    }
    let Some(kind) = spatial.clone().find(|known| known.word() == kind) else {
        let words: Vec<&str> =
            planar.map(|kind| kind.word()).chain(spatial.map(|kind| kind.word())).collect();
        return Err(of_words(py, &format!("what rolls is one of {}, not \"{kind}\"", words.join(", "))));
    };
    let problem =
        SpatialRollProblem::parse(kind, name, &text, &set).map_err(|found| of_inputs(py, &found.0))?;
    let study = py.detach(|| SolidStudy::of(problem));
    let study = study.map_err(|error| of_words(py, &format!("{name}: {error}")))?;
    let page = study.page(name);
    Ok((pretty(&study.report)?, named([("report.html", page)])))
}

/// What `carom design` says and writes.
#[pyfunction]
#[pyo3(signature = (scene, scan, samples, seed, progress=None))]
pub(crate) fn design(
    py: Python<'_>,
    scene: &Scene,
    scan: Option<u64>,
    samples: Option<u64>,
    seed: u64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Answer> {
    each!(scene, scene => designed(py, scene, (scan, samples, seed), progress))
}

fn designed<S: Designed>(
    py: Python<'_>,
    scene: &S,
    (scan, samples, seed): (Option<u64>, Option<u64>, u64),
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Answer> {
    let space = design_space(scene).map_err(|error| refused(py, &error))?;
    let usual = DesignPlan::usual(scene);
    let (scan, samples) = (scan.unwrap_or(usual.scan), samples.unwrap_or(usual.samples));
    let plan = DesignPlan { scan, samples, seed };
    let begun = Instant::now();
    let (study, threads) = long(py, None, progress, |watch| {
        let study = DesignStudy::searched(scene, &space, plan, || watch.step(), |_| {});
        (study, carom_study::threads())
    })?;
    let study = study.map_err(|error| refused(py, &error))?;
    Ok((pretty(&study.summary(spent(study.drops, begun, threads)))?, named(study.files())))
}
