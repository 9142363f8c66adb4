//! Scenes.

use crate::failure::{of_fault, of_input, of_words};
use carom_scene::input::{Disk, Files, InMemory};
use carom_scene::{AnyScene, Drawn, NamedQuantity, Scene as Planar, labelled, toml_of_json};
use pyo3::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The same of a scene in the plane and of one in space, whichever it is.
macro_rules! each {
    ($scene:expr, $inner:ident => $body:expr) => {
        match &$scene.inner {
            carom_scene::AnyScene::Plane($inner) => {
                let $inner = &**$inner;
                $body
            }
            carom_scene::AnyScene::Space($inner) => {
                let $inner = &**$inner;
                $body
            }
        }
    };
}
pub(crate) use each;

/// A scene that was read and checked: of a part in the plane, or of a solid.
#[pyclass(frozen, module = "carom._carom")]
pub(crate) struct Scene {
    pub(crate) inner: AnyScene,
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
    /// One in the plane, for what follows no others.
    pub(crate) fn planar(&self, py: Python<'_>, asked: &str) -> PyResult<&Planar> {
        match &self.inner {
            AnyScene::Plane(scene) => Ok(scene),
            AnyScene::Space(scene) => {
                let message =
                    format!("{}: its part is a solid, and {asked} is for parts in the plane", scene.name());
                Err(of_words(py, &message))
            }
        }
    }

    fn known(&self) -> Vec<NamedQuantity> {
        each!(self, scene => scene.quantities())
    }

    fn of(py: Python<'_>, file: &str, text: &str, beside: Option<InMemory>) -> PyResult<Self> {
        let files: &dyn Files = match &beside {
            Some(files) => files,
            None => &Disk,
        };
        let inner = AnyScene::parse_with(file, text, files).map_err(|problems| of_input(py, &problems))?;
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
        let inner = AnyScene::read(Path::new(path)).map_err(|problems| of_input(py, &problems))?;
        Ok(Self { inner, file: path.to_owned(), beside: None })
    }

    /// The same scene with other values, as a person writes them.
    fn writing(&self, py: Python<'_>, values: Vec<(String, String)>) -> PyResult<Self> {
        let paths: Vec<String> = values.iter().map(|(path, _)| self.canonical(path)).collect();
        let values: Vec<(&str, &str)> =
            paths.iter().zip(&values).map(|(path, (_, value))| (path.as_str(), value.as_str())).collect();
        let text = each!(self, scene => scene.text_writing_all(&values));
        let text = text.map_err(|problems| of_input(py, &problems))?;
        Self::of(py, &self.file, &text, self.beside.clone())
    }

    /// A path with a plate's number replaced by its name.
    fn canonical(&self, path: &str) -> String {
        each!(self, scene => Drawn::canonical(scene, path))
    }

    /// True where its part is a solid.
    #[getter]
    pub(crate) fn is_solid(&self) -> bool {
        matches!(self.inner, AnyScene::Space(_))
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
        each!(self, scene => scene.source())
    }

    /// The names of its plates.
    #[getter]
    fn plates(&self) -> Vec<&str> {
        each!(self, scene => scene.feeder().plates.iter().map(|plate| &*plate.name).collect())
    }

    /// Its quantities, as JSON.
    fn quantities(&self) -> PyResult<String> {
        let all = self.known();
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
    fn simulators(&self, py: Python<'_>) -> PyResult<BTreeMap<String, String>> {
        Ok(carom::tasks::simulator_files(self.planar(py, "simulators()")?).into_iter().collect())
    }

    /// The layout as SVG.
    fn layout(&self, py: Python<'_>) -> PyResult<String> {
        Ok(carom::tasks::layout(self.planar(py, "layout()")?))
    }
}
