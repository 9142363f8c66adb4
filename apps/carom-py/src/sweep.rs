//! Any number of designs into a folder, as `carom sweep` writes them.

use crate::answers::{pretty, refused};
use crate::scene::{Scene, each};
use crate::watch::long;
use carom::tasks::axes::Asker;
use carom_scene::{Drawn, StudyRunReport};
use carom_sweep::{DesignsAsked, Sizes, Sweep, SweepAsked};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

/// What is asked of a sweep, as Python gives it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Asks {
    grid: Vec<String>,
    list: Option<PathBuf>,
    plate: Option<String>,
    shard: String,
    force: bool,
    /// What other processes did of it: drops, for how long [s], on how many threads.
    before: Option<(usize, f64, usize)>,
}

/// What `carom sweep` says, and what it found damaged in the folder, a line each.
#[pyfunction]
#[pyo3(signature = (scene, folder, asks, progress=None))]
pub(crate) fn sweep(
    py: Python<'_>,
    scene: &Scene,
    folder: PathBuf,
    asks: Asks,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(String, Vec<String>)> {
    let asked = SweepAsked {
        designs: match &asks.list {
            Some(file) => DesignsAsked::List(file),
            None => DesignsAsked::Grid(&asks.grid),
        },
        plate: asks.plate.as_deref(),
        shard: &asks.shard,
        force: asks.force,
        sizes: if scene.is_solid() { Sizes::IN_SPACE } else { Sizes::default() },
        asker: Asker::Call,
    };
    each!(scene, scene => swept(py, scene, folder, &asked, asks.before, progress))
}

fn swept<S: Drawn>(
    py: Python<'_>,
    scene: &S,
    folder: PathBuf,
    asked: &SweepAsked<'_>,
    before: Option<(usize, f64, usize)>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(String, Vec<String>)> {
    let damaged = Mutex::new(vec![]);
    let tell = |line: &str| damaged.lock().unwrap_or_else(PoisonError::into_inner).push(line.to_owned());
    let open = || Sweep::open(scene, asked, folder, tell);
    let sweep = py.detach(open).map_err(|error| refused(py, &error))?;
    let designs = sweep.designs();
    let swept = long(py, Some(designs), progress, |watch| sweep.follow(|designs| watch.steps(designs)))?;
    let mut report = swept.map_err(|error| refused(py, &error))?.report;
    if let Some((drops, seconds, threads)) = before {
        report.run = StudyRunReport { drops: drops + report.run.drops, seconds, threads };
    }
    let json = pretty(&report)?;
    Ok((json, damaged.into_inner().unwrap_or_else(PoisonError::into_inner)))
}
