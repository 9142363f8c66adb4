//! Scenes in space: a solid part, and plates with a width.

mod assemble;
mod read;
mod report;
mod rests;
mod throws;

pub(crate) use read::{is_in_space, read_solid, refused_in_the_plane};
pub use report::{
    SpaceContactReport, SpaceExitReport, SpaceImpactReport, SpaceRunReport, SpaceStageReport,
    SpaceStateReport,
};

pub use throws::SolidThrows;

use crate::approximation::Approximation;
use crate::drawing::{Drawing, Want};
use crate::drawn::changed;
use crate::input::{Beside, Disk, Files};
use crate::node::from_toml;
use crate::problem::{Problem, ProblemKind, Problems};
use crate::read_scene::read_scene;
use crate::roll::spatial::ThrownShape;
use crate::scene::quantities;
use crate::{NamedQuantity, Scene};
use assemble::SpaceAssembled;
pub(crate) use assemble::assemble;
use carom_feeder::spatial::Feeder;
use std::path::Path;
use std::sync::Arc;

/// A checked scene whose part is a solid: it is followed in space.
///
/// # Example
/// ```
/// use carom_scene::SpaceScene;
/// let scene = SpaceScene::parse("slide.toml", r#"
///     [part]
///     shape   = "solid"
///     box     = ["40 mm", "10 mm", "20 mm"]
///     density = "7850 kg/m^3"
///     [contact]
///     friction = 0.15
///     [start]
///     to_edge = "100 mm"
///     [[plate]]
///     slope = "15 deg"
///     width = "60 mm"
/// "#)?;
/// assert!((scene.feeder().part.body.mass() - 0.0628).abs() < 1e-15);
/// assert_eq!(scene.feeder().plates[0].width, Some(0.06));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceScene {
    file: Arc<str>,
    source: Arc<str>,
    drawing: Drawing,
    assembled: SpaceAssembled,
}

/// A scene of any kind.
///
/// # Example
/// ```
/// use carom_scene::AnyScene;
/// let rod = AnyScene::read("../../examples/case_2.toml".as_ref())?;
/// assert!(matches!(rod, AnyScene::Plane(_)) && rod.name() == "case_2");
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum AnyScene {
    /// Its part moves in the plane.
    Plane(Box<Scene>),
    /// Its part is a solid.
    Space(Box<SpaceScene>),
}

impl AnyScene {
    /// Reads a scene's file.
    ///
    /// # Errors
    /// As [`Scene::read`].
    pub fn read(path: &Path) -> Result<Self, Problems> {
        let file = path.display().to_string();
        Self::parse(&file, &crate::scene::source_of(path)?)
    }

    /// Reads a scene's text, as [`Scene::parse`] does.
    ///
    /// # Errors
    /// As [`Scene::parse`].
    pub fn parse(file: &str, source: &str) -> Result<Self, Problems> {
        Self::parse_with(file, source, &Disk)
    }

    /// As [`AnyScene::parse`], with the files that the scene names from elsewhere than the disk.
    ///
    /// # Errors
    /// As [`Scene::parse`].
    pub fn parse_with(file: &str, source: &str, files: &dyn Files) -> Result<Self, Problems> {
        if SpaceScene::is_one(source) {
            SpaceScene::parse_with(file, source, files).map(|scene| Self::Space(Box::new(scene)))
        } else {
            Scene::parse_with(file, source, files).map(|scene| Self::Plane(Box::new(scene)))
        }
    }

    /// A scene in the plane; `None` of one in space.
    pub fn plane(self) -> Option<Scene> {
        match self {
            Self::Plane(scene) => Some(*scene),
            Self::Space(_) => None,
        }
    }

    /// Its name: the file's, without folder and ending.
    pub fn name(&self) -> &str {
        match self {
            Self::Plane(scene) => scene.name(),
            Self::Space(scene) => scene.name(),
        }
    }
}

impl SpaceScene {
    /// Whether a text describes a solid part; a text that is no TOML does not.
    pub fn is_one(source: &str) -> bool {
        read::is_solid(&from_toml(source.strip_prefix('\u{feff}').unwrap_or(source)).0)
    }

    /// Reads a scene's text; `file` is the name its problems are reported under, and an STL file is looked for in its folder.
    ///
    /// # Errors
    /// Every problem found.
    pub fn parse(file: &str, source: &str) -> Result<Self, Problems> {
        Self::parse_with(file, source, &Disk)
    }

    /// As [`SpaceScene::parse`], with the files that the scene names from elsewhere than the disk.
    ///
    /// # Errors
    /// As [`SpaceScene::parse`].
    pub fn parse_with(file: &str, source: &str, files: &dyn Files) -> Result<Self, Problems> {
        let source = source.strip_prefix('\u{feff}').unwrap_or(source);
        let fail = |problems| Problems::new(file, source, problems);
        let (tree, syntax) = from_toml(source);
        if !syntax.is_empty() {
            return Err(fail(syntax));
        }
        if !read::is_solid(&tree) {
            let message = "the part is no solid: this scene is followed in the plane";
            return Err(fail(vec![Problem::new(ProblemKind::Unsupported, "part", message, None)]));
        }
        let folder = Path::new(file).parent().unwrap_or(Path::new(""));
        let (drawing, assembled) = read_scene(&tree, Beside { folder, files }, assemble).map_err(fail)?;
        Ok(Self { file: file.into(), source: source.into(), drawing, assembled })
    }

    /// Its name: the file's, without folder and ending.
    pub fn name(&self) -> &str {
        crate::scene::name_of(&self.file)
    }

    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    pub(crate) fn drawing(&self) -> &Drawing {
        &self.drawing
    }

    /// Its text, as it was read.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The feeder it stands for.
    pub fn feeder(&self) -> &Feeder {
        &self.assembled.feeder
    }

    /// The shape of the part, in the axes of its drawing.
    pub fn shape(&self) -> &ThrownShape {
        &self.assembled.shape
    }

    /// The mass centre, in the axes of its drawing [m].
    pub fn mass_centre(&self) -> carom_num::Vec3 {
        self.assembled.centre
    }

    /// What was done to the drawing that its author should know.
    pub fn notes(&self) -> &[String] {
        &self.assembled.notes
    }

    /// How the computed part differs from the drawn one; empty where it does not.
    pub fn approximations(&self) -> &[Approximation] {
        &self.assembled.approximations
    }

    /// What is wanted on each plate.
    pub fn wants(&self) -> &[Option<Want>] {
        &self.assembled.wants
    }

    /// Every quantity, in the order of a scene, defaults included.
    pub fn quantities(&self) -> Vec<NamedQuantity> {
        quantities(&self.drawing)
    }

    /// The same scene with one quantity changed. A plate may be named by its number: `plate.1.width`.
    ///
    /// # Errors
    /// No such quantity; a value that is not allowed; a drawing that this value makes impossible.
    pub fn with(&self, path: &str, value: f64) -> Result<Self, Problems> {
        let fail = |problems| Problems::new(&self.file, &self.source, problems);
        let drawing = changed(&self.drawing, path, value).map_err(|problem| fail(vec![problem]))?;
        let assembled = assemble(&drawing).map_err(fail)?;
        Ok(self.redrawn(drawing, assembled))
    }

    /// The same file, drawn otherwise.
    pub(crate) fn redrawn(&self, drawing: Drawing, assembled: SpaceAssembled) -> Self {
        Self { file: self.file.clone(), source: self.source.clone(), drawing, assembled }
    }
}
