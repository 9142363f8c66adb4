//! How surely drops end as wanted: in one process, or in portions that other machines count.

use crate::answers::{Answer, named, pretty, spent};
use crate::failure::{of_fault, of_input, of_words};
use crate::scene::{Scene, each};
use crate::watch::long;
use carom::study::yields::{Contrasts, Plan, Points, Portion};
use carom::tasks::yields::{LocatedYield, YieldStudy};
use carom_scene::{Drawn, StudyRunReport, Varied};
use pyo3::prelude::*;
use std::path::Path;
use std::time::Instant;

/// What is asked of a yield, as Python gives it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Asks {
    samples: u64,
    seed: u64,
    plain: bool,
    plate: Option<String>,
}

/// What varies, and how it is sampled.
fn planned<'s, S: Drawn>(py: Python<'_>, scene: &'s S, asks: &Asks) -> PyResult<(Varied<'s, S>, Plan)> {
    let plate = crate::given::plate(py, scene, asks.plate.as_deref())?;
    let varied = varied(py, scene)?;
    let points = if asks.plain { Points::Random } else { Points::Sobol };
    let plan = YieldStudy::plan(&varied, asks.samples, asks.seed, points, plate);
    Ok((varied, plan))
}

fn varied<'s, S: Drawn>(py: Python<'_>, scene: &'s S) -> PyResult<Varied<'s, S>> {
    Varied::over(scene, 1.0).map_err(|problems| of_input(py, &problems))
}

/// A study that has no answer.
fn refused(py: Python<'_>, scene: &impl Drawn, why: &dyn std::fmt::Display) -> PyErr {
    of_words(py, &format!("{}: {why}", scene.name()))
}

fn told(study: &YieldStudy<'_, impl Drawn>, spent: StudyRunReport) -> PyResult<Answer> {
    let mut files = named(study.worst_scenes());
    files.insert("yield.html".to_owned(), study.page(Path::new("")));
    Ok((pretty(&study.summary(spent))?, files))
}

/// What `carom yield` says and writes.
#[pyfunction]
#[pyo3(signature = (scene, asks, progress=None))]
pub(crate) fn yields(
    py: Python<'_>,
    scene: &Scene,
    asks: Asks,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Answer> {
    each!(scene, scene => sampled(py, scene, &asks, progress))
}

fn sampled<S: Drawn>(
    py: Python<'_>,
    scene: &S,
    asks: &Asks,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Answer> {
    let (varied, plan) = planned(py, scene, asks)?;
    let begun = Instant::now();
    let drops = usize::try_from(plan.drops()).ok();
    let (study, threads) = long(py, drops, progress, |watch| {
        let study = YieldStudy::sampled(&varied, plan, || watch.step()).map(|mut study| {
            study.decide(|| watch.step());
            study
        });
        (study, carom_study::threads())
    })?;
    let study = study.map_err(|error| refused(py, scene, &error))?;
    told(&study, spent(study.drops, begun, threads))
}

/// What `carom yield --locate` says and writes; `samples` are lines.
#[pyfunction]
#[pyo3(signature = (scene, asks, progress=None))]
pub(crate) fn located(
    py: Python<'_>,
    scene: &Scene,
    asks: Asks,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Answer> {
    each!(scene, scene => along_lines(py, scene, &asks, progress))
}

fn along_lines<S: Drawn>(
    py: Python<'_>,
    scene: &S,
    asks: &Asks,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Answer> {
    let (varied, plan) = planned(py, scene, asks)?;
    let begun = Instant::now();
    let (found, threads) = long(py, None, progress, |watch| {
        (LocatedYield::of(&varied, plan, || watch.step()), carom_study::threads())
    })?;
    let found = found.map_err(|error| refused(py, scene, &error))?;
    let json = pretty(&found.summary(spent(found.drops, begun, threads)))?;
    Ok((json, std::collections::BTreeMap::new()))
}

/// One portion of a yield, a number of how many, as bytes: its drops, or in the second round those that say what decides.
#[pyfunction]
pub(crate) fn yield_portion(
    py: Python<'_>,
    scene: &Scene,
    asks: Asks,
    deciding: bool,
    portion: (u32, u32),
) -> PyResult<Vec<u8>> {
    each!(scene, scene => counted(py, scene, &asks, deciding, portion))
}

fn counted<S: Drawn>(
    py: Python<'_>,
    scene: &S,
    asks: &Asks,
    deciding: bool,
    portion: (u32, u32),
) -> PyResult<Vec<u8>> {
    let (varied, plan) = planned(py, scene, asks)?;
    let words = long(py, None, None, |watch| {
        let step = || watch.step();
        if deciding {
            let portion = YieldStudy::contrasts(&varied, &plan, portion, step);
            portion.map(|portion| portion.to_words()).map_err(|why| why.to_string())
        } else {
            let portion = YieldStudy::portion(&varied, &plan, portion, step);
            portion.map(|portion| portion.to_words()).map_err(|why| why.to_string())
        }
    })?;
    let words = words.map_err(|why| refused(py, scene, &why))?;
    Ok(words.into_iter().flat_map(u64::to_le_bytes).collect())
}

/// The numbers of a portion; bytes that are no whole number of them have none.
fn words(bytes: &[u8]) -> Vec<u64> {
    let (words, rest) = bytes.as_chunks::<8>();
    if rest.is_empty() { words.iter().map(|word| u64::from_le_bytes(*word)).collect() } else { vec![] }
}

/// What all portions say together; `None` where it must be asked first what decides. `took` is for how long [s], on how many threads.
#[pyfunction]
pub(crate) fn yield_joined(
    py: Python<'_>,
    scene: &Scene,
    counted: Vec<Vec<u8>>,
    deciding: Option<Vec<Vec<u8>>>,
    took: (f64, usize),
) -> PyResult<Option<Answer>> {
    each!(scene, scene => joined(py, scene, &counted, deciding.as_deref(), took))
}

fn joined<S: Drawn>(
    py: Python<'_>,
    scene: &S,
    counted: &[Vec<u8>],
    deciding: Option<&[Vec<u8>]>,
    (seconds, threads): (f64, usize),
) -> PyResult<Option<Answer>> {
    let varied = varied(py, scene)?;
    let portions = counted.iter().map(|bytes| Portion::of_words(&words(bytes)));
    let portions = portions.collect::<Result<Vec<_>, _>>().map_err(of_fault)?;
    let mut study = py.detach(|| YieldStudy::of(&varied, portions)).map_err(of_fault)?;
    match deciding {
        None if study.to_decide().is_some() => return Ok(None),
        None => {}
        Some(portions) => {
            let portions = portions.iter().map(|bytes| Contrasts::of_words(&words(bytes)));
            study.decided(Ok(portions.collect::<Result<Vec<_>, _>>().map_err(of_fault)?));
        }
    }
    told(&study, StudyRunReport { drops: study.drops, seconds, threads }).map(Some)
}
