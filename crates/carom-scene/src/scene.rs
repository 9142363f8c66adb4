//! A scene: what is drawn, checked, and the feeder it stands for.

use crate::approximation::Approximation;
use crate::assemble::{Assembled, assemble};
use crate::drawing::{Design, Drawing, Outline, Want};
use crate::drawn::changed;
use crate::input::{Beside, Disk, Files};
use crate::node::from_toml;
use crate::problem::{Problem, ProblemKind, Problems};
use crate::quantity::{Kind, Tolerance};
use crate::read_scene::read_scene;
use carom_feeder::{Feed, Feeder};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A checked scene.
///
/// # Example
/// ```
/// use carom_scene::Scene;
/// let scene = Scene::parse("slide.toml", r#"
///     [part]
///     shape = "rod"
///     length = "100 mm"
///     mass = "0.3 kg"
///     [contact]
///     friction = 0.15
///     [start]
///     to_edge = "100 mm"
///     [[plate]]
///     slope = "15 ± 0.5 deg"
/// "#)?;
/// assert_eq!(scene.to_feeder().part.body.inertia, 0.3 * (0.1 * 0.1 / 12.0));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    file: Arc<str>,
    source: Arc<str>,
    drawing: Drawing,
    assembled: Assembled,
}

/// A quantity of a scene, by path.
///
/// # Example
/// The upper plate of the second published feeder descends by 10°.
/// ```
/// use carom_scene::*;
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let slope = scene.quantities().into_iter().find(|quantity| quantity.path == "plate.upper.slope").unwrap();
/// assert!(slope.written && slope.tolerance.is_none());
/// assert_eq!(slope.value, 10_f64.to_radians());
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NamedQuantity {
    /// Its path: `plate.lower.slope`.
    pub path: String,
    /// Its value, or the middle of its tolerance, SI.
    pub value: f64,
    /// What it measures and what is allowed.
    pub kind: Kind,
    /// Its tolerance, where one is written.
    pub tolerance: Option<Tolerance>,
    /// True where the file writes it, be it by the name of a contact; false for a default.
    pub written: bool,
    /// Where it stands in the file.
    pub span: Option<std::ops::Range<usize>>,
}

impl NamedQuantity {
    /// True where it differs from part to part: how parts are fed is no matter of one part.
    pub(crate) fn varies(&self) -> bool {
        self.tolerance.is_some() && !self.path.starts_with("feed.")
    }
}

impl Scene {
    /// Reads a scene's file.
    ///
    /// # Errors
    /// Every problem found: of the file, of its notation, of each value, of what they draw together.
    ///
    /// # Example
    /// The part of the second published feeder weighs 0.3 kg.
    /// ```
    /// use carom_scene::*;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// assert_eq!((scene.name(), scene.feeder().part.body.mass), ("case_2", 0.3));
    /// assert!(Scene::read("nowhere.toml".as_ref()).is_err());
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn read(path: &Path) -> Result<Self, Problems> {
        Self::parse(&path.display().to_string(), &source_of(path)?)
    }

    /// Reads a scene's text; `file` is the name its problems are reported under, and its folder is where an outline's file is looked for.
    ///
    /// # Errors
    /// Every problem found. Where the notation itself is broken, only that: what else is wrong cannot be known.
    ///
    /// # Example
    /// Every problem of a scene is told at once.
    /// ```
    /// use carom_scene::Scene;
    /// let part = "part = { shape = 'rod', length = '0.1 kg', mass = '-1 kg' }";
    /// let problems = Scene::parse("mine.toml", part).unwrap_err();
    /// let paths: Vec<&str> = problems.list.iter().map(|problem| problem.path.as_str()).collect();
    /// assert!(paths.contains(&"part.length") && paths.contains(&"part.mass"));
    /// ```
    pub fn parse(file: &str, source: &str) -> Result<Self, Problems> {
        Self::parse_with(file, source, &Disk)
    }

    /// As [`Scene::parse`], with the files that the scene names from elsewhere than the disk: see [`Files`].
    ///
    /// # Errors
    /// As [`Scene::parse`].
    pub fn parse_with(file: &str, source: &str, files: &dyn Files) -> Result<Self, Problems> {
        let source = source.strip_prefix('\u{feff}').unwrap_or(source);
        let fail = |problems| Problems::new(file, source, problems);
        let (tree, syntax) = from_toml(source);
        if !syntax.is_empty() {
            return Err(fail(syntax));
        }
        if matches!(&tree.value, crate::node::Value::Table(entries) if entries.is_empty()) {
            let problem = Problem::new(ProblemKind::File, "", "the file is empty", None);
            return Err(fail(vec![problem.with_help("`carom new` writes a scene to start from")]));
        }
        if let Some(problem) = crate::space::refused_in_the_plane(&tree) {
            return Err(fail(vec![problem]));
        }
        let folder = Path::new(file).parent().unwrap_or(Path::new(""));
        let (drawing, assembled) = read_scene(&tree, Beside { folder, files }, assemble).map_err(fail)?;
        Ok(Self { file: file.into(), source: source.into(), drawing, assembled })
    }

    /// Its name: the file's, without folder and ending.
    pub fn name(&self) -> &str {
        name_of(&self.file)
    }

    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// The point of the part's drawing that is its mass centre [m].
    pub(crate) fn origin(&self) -> carom_num::Vec2 {
        self.assembled.origin
    }

    pub(crate) fn drawing(&self) -> &Drawing {
        &self.drawing
    }

    /// The same file, drawn otherwise.
    pub(crate) fn redrawn(&self, drawing: Drawing, assembled: Assembled) -> Self {
        Self { file: self.file.clone(), source: self.source.clone(), drawing, assembled }
    }

    /// The file that draws its part, as the scene names it, and where it is; `None` where the scene itself draws the part.
    pub fn outline_file(&self) -> Option<(&str, PathBuf)> {
        let Outline::File { drawn, .. } = &self.drawing.part.outline else { return None };
        let folder = Path::new(&*self.file).parent().unwrap_or(Path::new(""));
        Some((drawn.file(), folder.join(drawn.file())))
    }

    /// Its text, as it was read.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The feeder it stands for.
    pub fn feeder(&self) -> &Feeder {
        &self.assembled.feeder
    }

    /// The feeder it stands for, to keep.
    pub fn to_feeder(&self) -> Feeder {
        self.assembled.feeder.clone()
    }

    /// What was done to the drawing that its author should know.
    pub fn notes(&self) -> &[String] {
        &self.assembled.notes
    }

    /// How the computed part differs from the drawn one; empty where it does not. Every answer about the scene carries this.
    pub fn approximations(&self) -> &[Approximation] {
        &self.assembled.approximations
    }

    /// What is wanted on each plate.
    pub fn wants(&self) -> &[Option<Want>] {
        &self.assembled.wants
    }

    /// Several parts, one after another.
    pub fn feed(&self) -> Option<&Feed> {
        self.assembled.feed.as_ref()
    }

    /// What a design may choose, must keep and aims at.
    pub fn design(&self) -> Option<&Design> {
        self.drawing.design.as_ref()
    }

    /// What the second plate's line is in the first plate's axes, where it is drawn so: along, normal [m].
    pub fn paper_line(&self) -> Option<[f64; 2]> {
        match self.drawing.plates.as_slice() {
            [_, plate] => match &plate.place {
                crate::drawing::Place::Line { along, normal, .. } => Some([along.value, normal.value]),
                _ => None,
            },
            _ => None,
        }
    }

    /// Every quantity, in the order of a scene, defaults included.
    pub fn quantities(&self) -> Vec<NamedQuantity> {
        quantities(&self.drawing)
    }

    /// The same scene with one quantity changed. A plate may be named by its number: `plate.1.below.y`.
    ///
    /// # Errors
    /// No such quantity; a value that is not allowed; a drawing that this value makes impossible.
    ///
    /// # Example
    /// ```
    /// use carom_scene::*;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let heavier = scene.with("part.mass", 0.6)?;
    /// assert_eq!(heavier.feeder().part.body.mass, 0.6);
    /// assert!(scene.with("part.mass", -0.6).is_err());
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn with(&self, path: &str, value: f64) -> Result<Self, Problems> {
        let fail = |problems| Problems::new(&self.file, &self.source, problems);
        let drawing = changed(&self.drawing, path, value).map_err(|problem| fail(vec![problem]))?;
        let assembled = assemble(&drawing).map_err(fail)?;
        Ok(self.redrawn(drawing, assembled))
    }
}

/// The text of a scene's file.
pub(crate) fn source_of(path: &Path) -> Result<String, Problems> {
    crate::input::text(path).map_err(|error| {
        let message = match error.kind() {
            std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => error.to_string(),
        };
        let file = path.display().to_string();
        Problems::new(&file, "", vec![Problem::new(ProblemKind::File, "", message, None)])
    })
}

/// A file's name without folder and ending.
pub(crate) fn name_of(file: &str) -> &str {
    Path::new(file).file_stem().and_then(|stem| stem.to_str()).unwrap_or(file)
}

/// Every quantity of a drawing, in the order of a scene, defaults included.
pub(crate) fn quantities(drawing: &Drawing) -> Vec<NamedQuantity> {
    let mut found = vec![];
    drawing.clone().visit(&mut |path, quantity| {
        found.push(NamedQuantity {
            path: path.to_string(),
            value: quantity.value,
            kind: quantity.kind,
            tolerance: quantity.tolerance,
            written: quantity.span.is_some() || quantity.tolerance.is_some(),
            span: quantity.span.clone(),
        });
    });
    found
}
