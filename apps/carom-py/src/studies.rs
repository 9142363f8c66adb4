//! Studies over ranges: maps, regions, feeds and fits, as the command writes them.

use crate::answers::{Answer, Tabled, named, pretty, refused, spent, toml};
use crate::failure::of_words;
use crate::scene::{Scene, each};
use crate::watch::long;
use carom::tasks::StudyError;
use carom::tasks::axes::Asker;
use carom::tasks::feeds::{FeedAsked, FeedStudy};
use carom::tasks::fits::{FitAsked, FitStudy};
use carom::tasks::map::{MapAsked, MapStudy};
use carom::tasks::regions::{RegionsAsked, RegionsOf, RegionsStudy, RegionsSubject};
use carom_scene::columns::ColumnsError;
use carom_scene::{AnyScene, Drawn, StudyRunReport};
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::time::Instant;

/// A table by its name. It cannot fail in this build: it has Parquet.
fn tables(name: &str, table: Result<Vec<u8>, ColumnsError>) -> BTreeMap<String, Vec<u8>> {
    table.map(|bytes| (name.to_owned(), bytes)).into_iter().collect()
}

/// Long work whose answer may be refused.
fn asked<T: Send>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&(dyn Fn() + Sync)) -> Result<T, StudyError> + Send,
) -> PyResult<(T, usize, Instant)> {
    let begun = Instant::now();
    let (found, threads) =
        long(py, None, progress, |watch| (work(&|| watch.step()), carom_study::threads()))?;
    Ok((found.map_err(|error| refused(py, &error))?, threads, begun))
}

/// What is asked of a map, as Python gives it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Map {
    x: String,
    y: String,
    plate: Option<String>,
    accuracy: Option<f64>,
    depth: u32,
    cells: bool,
}

/// What `carom map` says and writes.
#[pyfunction]
#[pyo3(signature = (scene, asks, progress=None))]
pub(crate) fn map(
    py: Python<'_>,
    scene: &Scene,
    asks: Map,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Tabled> {
    each!(scene, scene => mapped(py, scene, &asks, progress))
}

fn mapped<S: Drawn>(
    py: Python<'_>,
    scene: &S,
    asks: &Map,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Tabled> {
    let Map { x, y, plate, accuracy, depth, cells } = asks;
    let over = MapAsked::over([x, y], Asker::Call);
    let map = MapAsked { plate: plate.as_deref(), accuracy: *accuracy, depth: *depth, cells: *cells, ..over };
    let (scene, plate, plane) = map.read(scene).map_err(|error| refused(py, &error))?;
    let (study, threads, begun) =
        asked(py, progress, |step| MapStudy::drawn(&scene, plate, plane, &map, step))?;
    let json = pretty(&study.summary(spent(study.map.map.drops, begun, threads)))?;
    let cells = study.cells_csv().map(|text| ("map-cells.csv", text));
    let files = named([("map.svg", study.map.svg()), ("map.csv", study.csv())].into_iter().chain(cells));
    let mut written = tables("map.parquet", study.nodes());
    if let Some(table) = study.cells_table() {
        written.extend(tables("map-cells.parquet", table));
    }
    Ok((json, files, written))
}

/// What is asked of a region diagram, as Python gives it: of a kind, or of an impact file, its name, its text and whether that is JSON.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Regions {
    kind: Option<String>,
    file: Option<(String, String, bool)>,
    set: Vec<String>,
    x: Option<String>,
    y: Option<String>,
    elastic: Option<f64>,
    depth: u32,
}

/// What `carom regions` says and writes.
#[pyfunction]
#[pyo3(signature = (asks, progress=None))]
pub(crate) fn regions(
    py: Python<'_>,
    asks: Regions,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Tabled> {
    let Regions { kind, file, set, x, y, elastic, depth } = asks;
    let file = file.map(|(name, text, json)| toml(py, &name, &text, json).map(|text| (name, text)));
    let file = file.transpose()?;
    let of = match (&kind, &file) {
        (Some(word), _) => RegionsSubject::Kind(RegionsOf::of_word(word).ok_or_else(|| {
            let words = RegionsOf::ALL.map(RegionsOf::word).join(", ");
            of_words(py, &format!("kind: \"{word}\" is none of {words}"))
        })?),
        (None, Some((name, text))) => RegionsSubject::File(name, text),
        (None, None) => return Err(of_words(py, "name a kind, or an impact file")),
    };
    let axes = [x.as_deref(), y.as_deref()];
    let diagram = RegionsAsked { of, set: &set, axes, elastic, depth, asker: Asker::Call };
    let (study, ..) = asked(py, progress, |step| RegionsStudy::drawn(&diagram, step))?;
    let files = named([("regions.svg", study.svg), ("regions.csv", study.csv)]);
    Ok((pretty(&study.report)?, files, tables("regions.parquet", study.table)))
}

/// What `carom feed` says and writes.
#[pyfunction]
#[pyo3(signature = (scene, parts, intervals, accuracy, progress=None))]
pub(crate) fn feed(
    py: Python<'_>,
    scene: &Scene,
    parts: Option<usize>,
    intervals: usize,
    accuracy: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Answer> {
    let feed = FeedAsked { parts, intervals, accuracy, asker: Asker::Call };
    match &scene.inner {
        AnyScene::Plane(scene) => {
            let (study, threads, begun) =
                asked(py, progress, |step| FeedStudy::searched(scene, &feed, step))?;
            let scenes = study.scenes().map_err(|error| refused(py, &error))?;
            fed(&study, scenes, spent(study.drops(), begun, threads))
        }
        AnyScene::Space(scene) => {
            let (study, threads, begun) =
                asked(py, progress, |step| FeedStudy::searched_solid(scene, &feed, step))?;
            fed(&study, vec![], spent(study.drops(), begun, threads))
        }
    }
}

fn fed(
    study: &FeedStudy<'_, impl Drawn>,
    scenes: Vec<(&'static str, String)>,
    run: StudyRunReport,
) -> PyResult<Answer> {
    let mut files = named(scenes);
    files.extend(named([("feed.svg", study.svg()), ("feed.csv", study.csv())]));
    Ok((pretty(&study.summary(run))?, files))
}

/// What is asked of a fit, as Python gives it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Fit {
    over: Vec<String>,
    level: f64,
    scatter: Option<String>,
    samples: u64,
    nodes: u32,
    seed: u64,
    plate: Option<String>,
}

/// What `carom fit` says and writes; `runs` are the name of a table of drops and its text as CSV.
#[pyfunction]
#[pyo3(signature = (scene, runs, asks, progress=None))]
pub(crate) fn fit(
    py: Python<'_>,
    scene: &Scene,
    runs: (String, String),
    asks: Fit,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Answer> {
    let scene = scene.planar(py, "fit()")?;
    let given = FitAsked {
        over: &asks.over,
        level: asks.level,
        scatter: asks.scatter.as_deref(),
        samples: asks.samples,
        nodes: asks.nodes,
        seed: asks.seed,
        plate: asks.plate.as_deref(),
        asker: Asker::Call,
    };
    let rows = (runs.0.as_str(), runs.1.as_str());
    let (study, threads, begun) = asked(py, progress, |step| FitStudy::fitted(scene, rows, &given, step))?;
    let text = study.fitted_scene().map_err(|error| refused(py, &error))?;
    let json = pretty(&study.summary(spent(study.drops, begun, threads)))?;
    Ok((json, named([("fitted.toml", text)])))
}
