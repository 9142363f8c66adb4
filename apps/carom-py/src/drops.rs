//! Many drops in one call.

use crate::failure::{of_input, of_words};
use crate::given::{Given, Values, at, plate, rows};
use crate::scene::{Scene, each};
use crate::table::{Data, Named, Table};
use crate::watch::long;
use carom::tasks::sweep::{FOUND, found};
use carom_scene::{Drawn, Variants};
use carom_study::sweep;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;

/// Designs that are followed before their answers are put into the table: runs take more memory than what is kept of them.
const STEP: usize = 10_000;

/// One drop in each design: a row of the columns, which are quantities by their paths, SI.
#[pyfunction]
#[pyo3(signature = (scene, columns, plate=None, progress=None))]
pub(crate) fn drops(
    py: Python<'_>,
    scene: &Scene,
    columns: Vec<(String, PyReadonlyArray1<'_, f64>)>,
    plate: Option<&str>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Table> {
    each!(scene, scene => followed(py, scene, columns, plate, progress))
}

fn followed<S: Drawn>(
    py: Python<'_>,
    scene: &S,
    columns: Vec<(String, PyReadonlyArray1<'_, f64>)>,
    plate: Option<&str>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Table> {
    let plate = self::plate(py, scene, plate)?;
    if columns.is_empty() {
        return Err(of_words(py, "no column: give at least one quantity by its path"));
    }
    let (paths, arrays): (Vec<String>, Vec<_>) = columns.into_iter().unzip();
    let paths: Vec<&str> = paths.iter().map(String::as_str).collect();
    let variants = Variants::over(scene, &paths).map_err(|problems| of_input(py, &problems))?;
    let values: Vec<Values<'_>> = arrays.iter().map(PyReadonlyArray1::as_array).collect();
    let given: Vec<Given<'_>> = variants
        .open()
        .zip(&values)
        .map(|(quantity, values)| Given {
            name: &quantity.path,
            values: values.view(),
            allowed: quantity.kind.interval(),
        })
        .collect();
    let rows = rows(py, scene.name(), &given)?;
    let units: Vec<&str> = variants.open().map(|quantity| quantity.kind.dimension.si()).collect();
    let results = long(py, Some(rows), progress, |watch| {
        let mut results: Vec<Data> = FOUND.iter().map(|(name, _)| empty(name)).collect();
        for begin in (0..rows).step_by(STEP) {
            let design = |row: usize| values.iter().map(|column| at(column, row)).collect();
            let designs: Vec<Vec<f64>> = (begin..(begin + STEP).min(rows)).map(design).collect();
            let drops = sweep::drops(&designs, plate, |values| {
                watch.step();
                variants.feeder(values).ok()
            });
            results.iter_mut().zip(found(&drops, plate)).for_each(|(whole, more)| whole.append(&more));
        }
        results
    })?;
    let inputs = paths.iter().zip(&values).zip(units).map(|((path, values), unit)| Named {
        name: scene.canonical(path),
        unit: unit.to_owned(),
        data: Data::Number((0..rows).map(|row| at(values, row)).collect()),
    });
    let outputs = FOUND.iter().zip(results).map(|((name, unit), data)| Named {
        name: (*name).to_owned(),
        unit: (*unit).to_owned(),
        data,
    });
    Ok(Table::new(rows, inputs.chain(outputs).collect()))
}

fn empty(name: &str) -> Data {
    if ["ending", "outcome"].contains(&name) { Data::words() } else { Data::numbers() }
}
