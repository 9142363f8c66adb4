//! A scene whose quantities are not exactly what is drawn.

use crate::drawn::Drawn;
use crate::problem::{Problem, ProblemKind, Problems};
use crate::quantity::Tolerance;
use crate::scene::{NamedQuantity, Scene};
use crate::space::SpaceScene;
use crate::start::FaceMix;
use crate::variants::Variants;
use carom_num::normal::{probability, quantile};
use std::borrow::Cow;

/// How many standard deviations the limits of a tolerance are from its middle.
const SIGMAS: f64 = 3.0;

impl Tolerance {
    /// The value below which this share of all parts lies: of a quantity with this middle, all of whose values are in `allowed`.
    ///
    /// # Example
    /// ```
    /// use carom_scene::quantity::Tolerance;
    /// let tolerance = Tolerance::Limits { half_width: 0.3 };
    /// let at = |share| tolerance.at(share, 1.0, [0.0, f64::INFINITY]);
    /// assert!((at(0.5) - 1.0).abs() < 1e-15 && (at(1.0) - 1.3).abs() < 1e-12);
    /// ```
    pub fn at(&self, share: f64, middle: f64, allowed: [f64; 2]) -> f64 {
        let normal = |sigma: f64, [low, high]: [f64; 2]| {
            let [below, under] = [low, high].map(|end| probability((end - middle) / sigma));
            (middle + sigma * quantile(below + share * (under - below))).clamp(low, high)
        };
        let within = |low: f64, high: f64| [low.max(allowed[0]), high.min(allowed[1])];
        match *self {
            Self::Limits { half_width } => {
                normal(half_width / SIGMAS, within(middle - half_width, middle + half_width))
            }
            Self::Sigma { sigma } => normal(sigma, allowed),
            Self::Uniform { low, high } => {
                let [low, high] = within(low, high);
                low * (1.0 - share) + high * share
            }
        }
    }

    /// The tolerance of a quantity whose middle moves by this: ends that are written move with it.
    pub(crate) fn moved(self, by: f64) -> Self {
        match self {
            Self::Uniform { low, high } => Self::Uniform { low: low + by, high: high + by },
            other => other,
        }
    }

    /// The same tolerance of a quantity with this middle, so many times as wide.
    fn widened(self, by: f64, middle: f64) -> Self {
        match self {
            Self::Limits { half_width } => Self::Limits { half_width: half_width * by },
            Self::Sigma { sigma } => Self::Sigma { sigma: sigma * by },
            Self::Uniform { low, high } => {
                Self::Uniform { low: middle + by * (low - middle), high: middle + by * (high - middle) }
            }
        }
    }
}

/// A scene with tolerances: a feeder for every point of the unit cube, one dimension a quantity that varies, and a last one where the part may
/// start on several faces.
///
/// # Example
/// Friction and two slopes have a tolerance: the middle of the cube stands for their middles.
/// ```
/// use carom_scene::*;
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let varied = scene.varied()?;
/// assert_eq!(varied.quantities().len(), 3);
/// let middles = varied.values(&[0.5; 3]);
/// assert!(varied.quantities().zip(middles).all(|(quantity, value)| (value - quantity.value).abs() < 1e-15));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug)]
pub struct Varied<'s, S: Drawn = Scene> {
    variants: Variants<'s, S>,
    /// How many times as wide tolerances are.
    widened: f64,
    faces: FaceMix,
}

impl Scene {
    /// Lets every quantity vary that has a tolerance.
    ///
    /// # Errors
    /// None has.
    pub fn varied(&self) -> Result<Varied<'_>, Problems> {
        Varied::of(Cow::Borrowed(self), 1.0)
    }
}

impl SpaceScene {
    /// What differs from part to part of this scene.
    ///
    /// # Errors
    /// As [`Scene::varied`].
    pub fn varied(&self) -> Result<Varied<'_, Self>, Problems> {
        Varied::of(Cow::Borrowed(self), 1.0)
    }
}

impl<'s, S: Drawn> Varied<'s, S> {
    /// What differs from part to part of a scene, in the plane or in space, every tolerance so many times as wide.
    ///
    /// # Errors
    /// As [`Scene::varied`].
    pub fn over(scene: &'s S, widened: f64) -> Result<Self, Problems> {
        Self::of(Cow::Borrowed(scene), widened)
    }

    /// A scene's tolerances, so many times as wide.
    pub(crate) fn of(scene: Cow<'s, S>, widened: f64) -> Result<Self, Problems> {
        let all = scene.quantities();
        let paths: Vec<&str> =
            all.iter().filter(|quantity| quantity.varies()).map(|quantity| quantity.path.as_str()).collect();
        let faces = FaceMix::of(&*scene);
        if paths.is_empty() && !faces.varies() {
            let problem = Problem::new(
                ProblemKind::MissingKey,
                "",
                "nothing varies: no quantity has a tolerance, and the part starts on one face",
                None,
            );
            let help = "write one, for example slope = \"15 ± 0.5 deg\" or friction = \"0.15 ± 0.03\"";
            return Err(Problems::new(scene.file(), scene.source(), vec![problem.with_help(help)]));
        }
        Ok(Varied { variants: Variants::of(scene, &paths)?, widened, faces })
    }
}

impl<S: Drawn> Varied<'_, S> {
    /// The scene as it is drawn.
    pub fn scene(&self) -> &S {
        self.variants.drawn()
    }

    /// How many dimensions the unit cube has.
    ///
    /// # Example
    /// Three quantities have a tolerance, and the part starts on one face.
    /// ```
    /// use carom_scene::*;
    /// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
    /// assert_eq!((scene.varied()?.dimensions(), scene.varied()?.paths().len()), (3, 3));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn dimensions(&self) -> usize {
        self.quantities().len() + usize::from(self.faces.varies())
    }

    /// What varies, by its path, in the order of the dimensions: quantities, then `start.face` where that is one of several.
    pub fn paths(&self) -> Vec<String> {
        let face = self.faces.varies().then(|| "start.face".to_owned());
        self.quantities().map(|quantity| quantity.path.clone()).chain(face).collect()
    }

    /// The faces on which the part may start, and the share of each; the shares sum to 1.
    pub fn faces(&self) -> &[(usize, f64)] {
        self.faces.shares()
    }

    /// The face on which the part starts at a point of the unit cube: the last dimension is cut into pieces as long as the shares.
    pub fn face(&self, point: &[f64]) -> usize {
        self.faces.at(point.get(self.quantities().len()).copied().unwrap_or(0.0))
    }

    /// The quantities that vary, in the order of the dimensions.
    pub fn quantities(&self) -> impl ExactSizeIterator<Item = &NamedQuantity> {
        self.variants.open()
    }

    /// The values at a point of the unit cube, SI.
    pub fn values(&self, point: &[f64]) -> Vec<f64> {
        let at = |(quantity, share): (&NamedQuantity, &f64)| match quantity.tolerance {
            Some(tolerance) => {
                let tolerance = tolerance.widened(self.widened, quantity.value);
                tolerance.at(*share, quantity.value, quantity.kind.interval())
            }
            None => quantity.value,
        };
        self.quantities().zip(point).map(at).collect()
    }

    /// How far the values at a point are from their middles: the sum of their squared distances in standard deviations, of those that are
    /// normal; every value of a uniform one is as probable as its middle.
    pub fn distance(&self, point: &[f64]) -> f64 {
        let values = self.values(point);
        let score = |(quantity, value): (&NamedQuantity, f64)| match quantity.tolerance {
            Some(Tolerance::Limits { half_width }) => (value - quantity.value) / (half_width / SIGMAS),
            Some(Tolerance::Sigma { sigma }) => (value - quantity.value) / sigma,
            Some(Tolerance::Uniform { .. }) | None => 0.0,
        };
        self.quantities().zip(values).map(score).map(|score| score * score).sum()
    }

    /// The feeder at a point; `None` where what is drawn cannot be.
    pub fn feeder(&self, point: &[f64]) -> Option<S::Feeder> {
        self.variants.feeder_on(&self.values(point), self.face(point)).ok()
    }

    /// The text of a scene in which everything that varies has the value that it has at a point.
    ///
    /// # Errors
    /// As [`Variants::text`].
    ///
    /// # Example
    /// What is written varies no more.
    /// ```
    /// use carom_scene::*;
    /// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
    /// let fixed = Scene::parse("fixed.toml", &scene.varied()?.text(&[0.2, 0.5, 0.5])?)?;
    /// assert!(fixed.varied().is_err());
    /// assert_eq!(fixed.feeder().plates[0].friction, scene.varied()?.values(&[0.2, 0.5, 0.5])[0]);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text(&self, point: &[f64]) -> Result<String, Problems> {
        self.variants.text_on(&self.values(point), self.face(point))
    }
}
