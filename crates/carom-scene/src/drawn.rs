//! What scenes in the plane and in space have in common: quantities that may be moved, and a feeder for every choice of them.

use crate::approximation::Approximation;
use crate::assemble::assemble;
use crate::drawing::{Design, Drawing, StartFaces, Want};
use crate::grammar::out_of_range;
use crate::problem::{Problem, Problems};
use crate::scene::{NamedQuantity, Scene, quantities};
use crate::space::{SpaceScene, assemble as assemble_in_space};
use crate::start::resting;
use crate::visit::{canonical, unknown};
use crate::wanted::Wanted;
use carom_feeder::{Feeder, spatial};
use carom_impact::Law;
use carom_study::Device;
use carom_study::design::Limits;
use carom_words::part::Names;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A scene, in the plane or in space.
///
/// # Example
/// ```
/// use carom_scene::{AnyScene, Drawn};
/// let scene = AnyScene::read("../../examples/case_2.toml".as_ref())?.plane().unwrap();
/// assert_eq!((Drawn::name(&scene), scene.start_faces()), ("case_2", vec![(0, 1.0)]));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
pub trait Drawn: Clone + Send + Sync {
    /// What it stands for.
    type Feeder: Device + Names;
    /// How its parts move, in words.
    const MOTION: &'static str;
    /// Its name: the file's, without folder and ending.
    fn name(&self) -> &str;
    /// The name that its problems are reported under.
    fn file(&self) -> &str;
    /// Its text, as it was read.
    fn source(&self) -> &str;
    /// Every quantity, in the order of a scene, defaults included.
    fn quantities(&self) -> Vec<NamedQuantity>;
    /// The feeder it stands for.
    fn feeder(&self) -> &Self::Feeder;
    /// The feeder with some of its quantities moved, each given by its place in their order, and of a part that starts on a face.
    ///
    /// # Errors
    /// A drawing that the values make impossible.
    fn moved(&self, values: &[(usize, f64)], face: Option<usize>) -> Result<Self::Feeder, Vec<Problem>>;
    /// The whole scene with some of its quantities moved.
    ///
    /// # Errors
    /// As [`Drawn::moved`].
    fn remade(&self, values: &[(usize, f64)]) -> Result<Self, Vec<Problem>>;
    /// The same scene with one quantity changed. A plate may be named by its number: `plate.1.below.y`.
    ///
    /// # Errors
    /// No such quantity; a value that is not allowed; a drawing that this value makes impossible.
    fn with(&self, path: &str, value: f64) -> Result<Self, Problems>;

    /// A path with a plate's number replaced by its name: `plate.1.slope` becomes `plate.lower.slope`.
    fn canonical(&self, path: &str) -> String {
        let known = self.quantities();
        let paths: Vec<&str> = known.iter().map(|quantity| quantity.path.as_str()).collect();
        canonical(path, &paths)
    }

    /// Each face on which the part may start, and its share; the shares sum to 1.
    fn start_faces(&self) -> Vec<(usize, f64)>;
    /// Where the file says on which.
    fn face_span(&self) -> Option<Range<usize>>;
    /// The file that draws its part, as the scene names it, and where it is; `None` where the scene itself draws the part.
    fn part_file(&self) -> Option<(&str, PathBuf)>;
    /// What is wanted on each plate.
    fn wants(&self) -> &[Option<Want>];
    /// What was done to the drawing that its author should know.
    fn notes(&self) -> &[String];
    /// How the computed part differs from the drawn one.
    fn approximations(&self) -> &[Approximation];
    /// The law of restitution.
    fn law(&self) -> Law;
    /// What a design may choose, must keep and aims at.
    fn design(&self) -> Option<&Design>;
    /// What a layout must keep besides, where the scene says so of a drop.
    fn limits(&self) -> Option<Limits> {
        self.design().map(Design::limits).filter(Limits::are_of_drops)
    }
    /// Each plate on which something is wanted, and whether a run has it.
    fn wanted_of(&self, run: &<Self::Feeder as Device>::Run) -> Vec<Wanted>;

    /// Whether the part lies on every plate as wanted; `None` where nothing is.
    fn ends_as_wanted(&self, run: &<Self::Feeder as Device>::Run) -> Option<bool> {
        let wanted = self.wanted_of(run);
        (!wanted.is_empty()).then(|| wanted.iter().all(|wanted| wanted.met))
    }
}

/// A drawing with quantities moved, each given by its place in their order, and of a part that starts on a face.
pub(crate) fn moved(drawing: &Drawing, values: &[(usize, f64)], face: Option<usize>) -> Drawing {
    let mut drawing = drawing.clone();
    let mut place = 0;
    drawing.visit(&mut |_, quantity| {
        if let Some((_, value)) = values.iter().find(|(open, _)| *open == place) {
            quantity.move_to(*value);
        }
        place += 1;
    });
    if let Some(face) = face {
        drawing.start.faces = StartFaces::One(face);
    }
    drawing
}

/// A drawing with one quantity changed.
pub(crate) fn changed(drawing: &Drawing, path: &str, value: f64) -> Result<Drawing, Problem> {
    let mut changed = drawing.clone();
    let paths = quantities(drawing);
    let paths: Vec<&str> = paths.iter().map(|quantity| quantity.path.as_str()).collect();
    let plain = canonical(path, &paths);
    let mut problem = Some(unknown(path, &paths));
    changed.visit(&mut |found, quantity| {
        let found = found.to_string();
        if found == plain {
            quantity.value = value;
            let mut alone = quantity.clone();
            (alone.tolerance, alone.span) = (None, None);
            problem = out_of_range(&found, &alone);
        }
    });
    problem.map_or(Ok(changed), Err)
}

impl Drawn for Scene {
    type Feeder = Feeder;
    const MOTION: &'static str = "plane motion";

    fn name(&self) -> &str {
        self.name()
    }

    fn file(&self) -> &str {
        self.file()
    }

    fn source(&self) -> &str {
        self.source()
    }

    fn quantities(&self) -> Vec<NamedQuantity> {
        self.quantities()
    }

    fn feeder(&self) -> &Feeder {
        self.feeder()
    }

    fn moved(&self, values: &[(usize, f64)], face: Option<usize>) -> Result<Feeder, Vec<Problem>> {
        Ok(assemble(&moved(self.drawing(), values, face))?.feeder)
    }

    fn remade(&self, values: &[(usize, f64)]) -> Result<Self, Vec<Problem>> {
        let drawing = moved(self.drawing(), values, None);
        let assembled = assemble(&drawing)?;
        Ok(self.redrawn(drawing, assembled))
    }

    fn with(&self, path: &str, value: f64) -> Result<Self, Problems> {
        self.with(path, value)
    }

    fn start_faces(&self) -> Vec<(usize, f64)> {
        self.drawing().start.faces.shares(|| resting(&self.feeder().part.body.shape))
    }

    fn face_span(&self) -> Option<Range<usize>> {
        self.drawing().start.face_span.clone()
    }

    fn wants(&self) -> &[Option<Want>] {
        self.wants()
    }

    fn notes(&self) -> &[String] {
        self.notes()
    }

    fn approximations(&self) -> &[Approximation] {
        self.approximations()
    }

    fn law(&self) -> Law {
        self.feeder().law
    }

    fn part_file(&self) -> Option<(&str, PathBuf)> {
        self.outline_file()
    }

    fn design(&self) -> Option<&Design> {
        self.design()
    }

    fn wanted_of(&self, run: &carom_feeder::Run) -> Vec<Wanted> {
        self.wanted(run)
    }
}

impl Drawn for SpaceScene {
    type Feeder = spatial::Feeder;
    const MOTION: &'static str = "motion in space";

    fn name(&self) -> &str {
        self.name()
    }

    fn file(&self) -> &str {
        self.file()
    }

    fn source(&self) -> &str {
        self.source()
    }

    fn quantities(&self) -> Vec<NamedQuantity> {
        self.quantities()
    }

    fn feeder(&self) -> &spatial::Feeder {
        self.feeder()
    }

    fn moved(&self, values: &[(usize, f64)], face: Option<usize>) -> Result<spatial::Feeder, Vec<Problem>> {
        Ok(assemble_in_space(&moved(self.drawing(), values, face))?.feeder)
    }

    fn remade(&self, values: &[(usize, f64)]) -> Result<Self, Vec<Problem>> {
        let drawing = moved(self.drawing(), values, None);
        let assembled = assemble_in_space(&drawing)?;
        Ok(self.redrawn(drawing, assembled))
    }

    fn with(&self, path: &str, value: f64) -> Result<Self, Problems> {
        self.with(path, value)
    }

    fn start_faces(&self) -> Vec<(usize, f64)> {
        self.drawing().start.faces.shares(|| self.resting())
    }

    fn face_span(&self) -> Option<Range<usize>> {
        self.drawing().start.face_span.clone()
    }

    fn wants(&self) -> &[Option<Want>] {
        self.wants()
    }

    fn notes(&self) -> &[String] {
        self.notes()
    }

    fn approximations(&self) -> &[Approximation] {
        self.approximations()
    }

    fn law(&self) -> Law {
        self.feeder().law
    }

    fn part_file(&self) -> Option<(&str, PathBuf)> {
        let name = self.shape().file.as_deref()?;
        let folder = Path::new(self.file()).parent().unwrap_or(Path::new(""));
        Some((name, folder.join(name)))
    }

    fn design(&self) -> Option<&Design> {
        self.drawing().design.as_ref()
    }

    fn wanted_of(&self, run: &spatial::Run) -> Vec<Wanted> {
        self.wanted(run)
    }
}
