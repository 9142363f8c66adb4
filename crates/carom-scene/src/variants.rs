//! One scene drawn many times, with some of its quantities moved.

use crate::drawn::Drawn;
use crate::problem::{Problem, ProblemKind, Problems};
use crate::quantity::Tolerance;
use crate::scene::{NamedQuantity, Scene};
use crate::unit::{Dimension, Unit};
use crate::visit::{canonical, unknown};
use std::borrow::Cow;

/// A scene with some of its quantities left open: a feeder for every choice of their values.
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
///     slope = "15 deg"
/// "#)?;
/// let variants = scene.variants(&["contact.friction", "start.to_edge"])?;
/// let feeder = variants.feeder(&[0.2, 0.12])?;
/// assert_eq!((feeder.plates[0].friction, feeder.start.to_edge), (0.2, 0.12));
/// assert!(variants.feeder(&[-0.2, 0.12]).is_err());
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug)]
pub struct Variants<'s, S: Drawn = Scene> {
    scene: Cow<'s, S>,
    /// The open quantities, and each one's place in the order of the drawing.
    open: Vec<(NamedQuantity, usize)>,
}

impl Scene {
    /// Leaves these quantities open. A plate may be named by its number: `plate.1.below.y`.
    ///
    /// # Errors
    /// Every path that the scene does not have, and every one that is named twice.
    ///
    /// # Example
    /// ```
    /// use carom_scene::*;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// assert_eq!(scene.variants(&["part.mass", "plate.0.slope"])?.open().len(), 2);
    /// assert!(scene.variants(&["part.mass", "part.mass"]).is_err());
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn variants(&self, paths: &[&str]) -> Result<Variants<'_>, Problems> {
        Variants::over(self, paths)
    }
}

impl<'s, S: Drawn> Variants<'s, S> {
    /// Leaves these quantities of a scene open, in the plane or in space: as [`Scene::variants`].
    ///
    /// # Errors
    /// As [`Scene::variants`].
    pub fn over(scene: &'s S, paths: &[&str]) -> Result<Self, Problems> {
        Self::of(Cow::Borrowed(scene), paths)
    }

    /// Leaves these quantities of a scene open.
    pub(crate) fn of(scene: Cow<'s, S>, paths: &[&str]) -> Result<Self, Problems> {
        let known = scene.quantities();
        let names: Vec<&str> = known.iter().map(|quantity| quantity.path.as_str()).collect();
        let (mut open, mut problems): (Vec<(NamedQuantity, usize)>, Vec<Problem>) = (vec![], vec![]);
        for path in paths {
            let plain = canonical(path, &names);
            match known.iter().position(|quantity| quantity.path == plain) {
                None => problems.push(unknown(path, &names)),
                Some(place) if open.iter().any(|(_, other)| *other == place) => {
                    problems.push(Problem::new(ProblemKind::Conflict, *path, "is named twice", None));
                }
                Some(place) => open.push((known[place].clone(), place)),
            }
        }
        if problems.is_empty() {
            Ok(Variants { scene, open })
        } else {
            Err(Problems::new(scene.file(), scene.source(), problems))
        }
    }
}

/// The number of twelve digits that stands for the same value, where there is one.
fn neat(shown: f64, to_si: impl Fn(f64) -> f64) -> f64 {
    let short: f64 = format!("{shown:.11e}").parse().unwrap_or(shown);
    if to_si(short) == to_si(shown) { short } else { shown }
}

/// A value as a file has it, to the last digit; with a tolerance around it.
fn written(quantity: &NamedQuantity, value: f64, tolerance: Option<Tolerance>) -> String {
    let dimension = quantity.kind.dimension;
    // A person reads the unit of a drawing; only where it keeps every digit does it stand for the SI value.
    let kept = |unit: &Unit| unit.to_si(neat(unit.of_si(value), |shown| unit.to_si(shown))) == value;
    let unit = dimension.unit(dimension.usual()).filter(kept);
    let shown = |value: f64| match (unit, dimension.si()) {
        _ if dimension == Dimension::Count => format!("{value:.0}"),
        (Some(unit), _) => {
            format!("{:?} {}", neat(unit.of_si(value), |shown| unit.to_si(shown)), unit.symbol)
        }
        (None, "") => format!("{value:?}"),
        (None, si) => format!("{value:?} {si}"),
    };
    let moved = |end: f64| shown(end + value - quantity.value);
    match tolerance {
        None if dimension.si().is_empty() => shown(value),
        None => format!("\"{}\"", shown(value)),
        Some(Tolerance::Limits { half_width }) => format!("\"{} ± {}\"", shown(value), shown(half_width)),
        Some(Tolerance::Sigma { sigma }) => {
            format!("{{ value = \"{}\", sigma = \"{}\" }}", shown(value), shown(sigma))
        }
        Some(Tolerance::Uniform { low, high }) => {
            format!("{{ low = \"{}\", high = \"{}\" }}", moved(low), moved(high))
        }
    }
}

impl<S: Drawn> Variants<'_, S> {
    /// The scene as it is drawn.
    pub(crate) fn drawn(&self) -> &S {
        &self.scene
    }

    /// The open quantities, as the scene has them, in the order in which their values are given.
    pub fn open(&self) -> impl ExactSizeIterator<Item = &NamedQuantity> {
        self.open.iter().map(|(quantity, _)| quantity)
    }

    /// The feeder with these values, SI.
    ///
    /// # Errors
    /// A value that is not allowed, or a missing one; a drawing that the values make impossible.
    pub fn feeder(&self, values: &[f64]) -> Result<S::Feeder, Problems> {
        self.scene.moved(&self.placed(values)?, None).map_err(|found| self.problems(found))
    }

    /// As [`Variants::feeder`], of a part that starts on this face.
    pub(crate) fn feeder_on(&self, values: &[f64], face: usize) -> Result<S::Feeder, Problems> {
        self.scene.moved(&self.placed(values)?, Some(face)).map_err(|found| self.problems(found))
    }

    /// As [`Variants::text`], with the tolerances that the file has.
    ///
    /// # Errors
    /// As [`Variants::text`].
    pub fn text_with_tolerances(&self, values: &[f64]) -> Result<String, Problems> {
        let tolerances: Vec<_> = self.open().map(|quantity| quantity.tolerance).collect();
        self.rewritten(values, &tolerances, None)
    }

    /// As [`Variants::text`], with these tolerances, one for each open quantity.
    ///
    /// # Errors
    /// As [`Variants::text`].
    ///
    /// # Example
    /// ```
    /// use carom_scene::{Scene, quantity::Tolerance};
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let around = Some(Tolerance::Sigma { sigma: 0.01 });
    /// let text = scene.variants(&["contact.friction"])?.text_with(&[0.25], &[around])?;
    /// assert!(text.contains(r#"{ value = "0.25", sigma = "0.01" }"#));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text_with(&self, values: &[f64], tolerances: &[Option<Tolerance>]) -> Result<String, Problems> {
        self.rewritten(values, tolerances, None)
    }

    /// The text of the scene with these values in place of what the file has; comments and all else stay.
    ///
    /// # Errors
    /// A quantity that the file does not write down; what [`Variants::feeder`] says.
    ///
    /// # Example
    /// All else stays, comments too.
    /// ```
    /// use carom_scene::*;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let text = scene.variants(&["contact.friction"])?.text(&[0.25])?;
    /// assert_eq!(text, scene.source().replace("0.15", "0.25"));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text(&self, values: &[f64]) -> Result<String, Problems> {
        self.rewritten(values, &[], None)
    }

    /// As [`Variants::text`], of a part that starts on this face.
    pub(crate) fn text_on(&self, values: &[f64], face: usize) -> Result<String, Problems> {
        self.rewritten(values, &[], Some(face))
    }

    fn rewritten(
        &self,
        values: &[f64],
        tolerances: &[Option<Tolerance>],
        face: Option<usize>,
    ) -> Result<String, Problems> {
        self.feeder(values)?;
        let mut places = vec![];
        // A face that is not written is the first, and only one of several is chosen.
        if let (Some(face), Some(span)) = (face, self.scene.face_span()) {
            places.push((span, face.to_string()));
        }
        let mut problems = vec![];
        for (k, ((quantity, _), value)) in self.open.iter().zip(values).enumerate() {
            match &quantity.span {
                Some(span) => {
                    let tolerance = tolerances.get(k).copied().flatten();
                    places.push((span.clone(), written(quantity, *value, tolerance)));
                }
                None => {
                    let message = "is not written in the file: it cannot be changed there";
                    problems.push(Problem::new(ProblemKind::MissingKey, &quantity.path, message, None));
                }
            }
        }
        if !problems.is_empty() {
            return Err(self.problems(problems));
        }
        // From the end, so that places before keep theirs.
        places.sort_by_key(|(span, _)| usize::MAX - span.start);
        let mut text = self.scene.source().to_owned();
        for (span, value) in places {
            text.replace_range(span, &value);
        }
        Ok(text)
    }

    /// The values of the open quantities, each with its place.
    fn placed(&self, values: &[f64]) -> Result<Vec<(usize, f64)>, Problems> {
        let mut problems = vec![];
        for (i, (quantity, _)) in self.open.iter().enumerate() {
            let value = values.get(i).copied().unwrap_or(f64::NAN);
            if !quantity.kind.holds(value) {
                let message =
                    format!("{}: it {}", quantity.kind.dimension.show(value), quantity.kind.rule_for(value));
                problems.push(Problem::new(ProblemKind::OutOfRange, &quantity.path, message, None));
            }
        }
        if !problems.is_empty() {
            return Err(self.problems(problems));
        }
        Ok(self.open.iter().zip(values).map(|((_, place), value)| (*place, *value)).collect())
    }

    fn problems(&self, found: Vec<Problem>) -> Problems {
        Problems::new(self.scene.file(), self.scene.source(), found)
    }
}

impl<S: Drawn> Variants<'_, S> {
    /// The whole scene with these values, SI.
    ///
    /// # Errors
    /// As [`Variants::feeder`].
    pub fn scene(&self, values: &[f64]) -> Result<S, Problems> {
        self.scene.remade(&self.placed(values)?).map_err(|found| self.problems(found))
    }
}
