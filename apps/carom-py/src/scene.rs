//! Scenes.

use crate::failure::{of_fault, of_input};
use carom_scene::input::{Disk, Files, InMemory};
use carom_scene::{Drawn, Scene as Inner, labelled, toml_of_json};
use pyo3::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A scene that was read and checked.
#[pyclass(frozen, module = "carom._carom")]
pub(crate) struct Scene {
    pub(crate) inner: Inner,
    file: String,
    /// The files that it names; of the disk where there are none.
    beside: Option<InMemory>,
}

/// A quantity of a scene.
#[derive(Serialize)]
struct Quantity<'a> {
    path: &'a str,
    label: String,
    value: f64,
    unit: &'static str,
    usual_unit: &'static str,
    low: Option<f64>,
    high: Option<f64>,
    written: bool,
}

impl Scene {
    fn of(py: Python<'_>, file: &str, text: &str, beside: Option<InMemory>) -> PyResult<Self> {
        let files: &dyn Files = match &beside {
            Some(files) => files,
            None => &Disk,
        };
        let inner = Inner::parse_with(file, text, files).map_err(|problems| of_input(py, &problems))?;
        Ok(Self { inner, file: file.to_owned(), beside })
    }
}

#[pymethods]
impl Scene {
    /// Reads the text of a scene, TOML or one JSON object; `files` are those that it names.
    #[new]
    fn new(
        py: Python<'_>,
        text: &str,
        name: &str,
        json: bool,
        files: Option<BTreeMap<PathBuf, Vec<u8>>>,
    ) -> PyResult<Self> {
        if json {
            let text = toml_of_json(name, text).map_err(|problems| of_input(py, &problems))?;
            return Self::of(py, name, &text, files);
        }
        Self::of(py, name, text, files)
    }

    /// Reads a scene's file.
    #[staticmethod]
    fn read(py: Python<'_>, path: &str) -> PyResult<Self> {
        let inner = Inner::read(Path::new(path)).map_err(|problems| of_input(py, &problems))?;
        Ok(Self { inner, file: path.to_owned(), beside: None })
    }

    /// The same scene with other values, as a person writes them.
    fn writing(&self, py: Python<'_>, values: Vec<(String, String)>) -> PyResult<Self> {
        let paths: Vec<String> = values.iter().map(|(path, _)| self.inner.canonical(path)).collect();
        let values: Vec<(&str, &str)> =
            paths.iter().zip(&values).map(|(path, (_, value))| (path.as_str(), value.as_str())).collect();
        let text = self.inner.text_writing_all(&values).map_err(|problems| of_input(py, &problems))?;
        Self::of(py, &self.file, &text, self.beside.clone())
    }

    /// A path with a plate's number replaced by its name.
    fn canonical(&self, path: &str) -> String {
        self.inner.canonical(path)
    }

    /// The files that it names; None where they are on the disk.
    #[getter]
    fn files(&self) -> Option<InMemory> {
        self.beside.clone()
    }

    /// The file that it was read from, or its name.
    #[getter]
    fn file(&self) -> &str {
        &self.file
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        self.inner.name()
    }

    /// Its text.
    #[getter]
    fn text(&self) -> &str {
        self.inner.source()
    }

    /// The names of its plates.
    #[getter]
    fn plates(&self) -> Vec<&str> {
        self.inner.feeder().plates.iter().map(|plate| &*plate.name).collect()
    }

    /// Its quantities, as JSON.
    fn quantities(&self) -> PyResult<String> {
        let all = self.inner.quantities();
        let finite = |end: f64| Some(end).filter(|end| end.is_finite());
        let shown = all.iter().map(|quantity| {
            let [low, high] = quantity.kind.interval();
            Quantity {
                path: &quantity.path,
                label: labelled(&quantity.path).into_owned(),
                value: quantity.value,
                unit: quantity.kind.dimension.si(),
                usual_unit: quantity.kind.dimension.usual(),
                low: finite(low),
                high: finite(high),
                written: quantity.written,
            }
        });
        serde_json::to_string(&shown.collect::<Vec<_>>()).map_err(of_fault)
    }

    /// The scene for simulators: texts by the names of their files.
    fn simulators(&self) -> BTreeMap<String, String> {
        carom::tasks::simulator_files(&self.inner).into_iter().collect()
    }

    /// The layout as SVG.
    fn layout(&self) -> String {
        carom::tasks::layout(&self.inner)
    }
}
