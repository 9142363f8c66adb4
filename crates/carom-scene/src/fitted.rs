//! A scene some quantities of which are fitted to observed drops.

use crate::drawn::Drawn;
use crate::problem::Problems;
use crate::quantity::Tolerance;
use crate::scene::{NamedQuantity, Scene};
use crate::start::FaceMix;
use crate::variants::Variants;
use carom_feeder::Feeder;

/// A scene with quantities that are fitted, others that are set anew for each lot of drops, and those with a tolerance, which vary from drop to drop.
///
/// # Example
/// Friction is fitted, the upper slope was set for each lot and has a tolerance about that; the lower one varies as the scene says.
/// ```
/// use carom_scene::Scene;
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let fitted = scene.fitted(&["contact.friction"], &["plate.upper.slope"])?;
/// assert_eq!(fitted.dimensions(), 2);
/// let feeder = fitted.feeder(&[0.2], &[0.3], &[0.5, 0.5]).unwrap();
/// assert_eq!(feeder.plates[0].friction, 0.2);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug)]
pub struct Fitted<'s> {
    variants: Variants<'s>,
    parameters: usize,
    columns: usize,
    faces: FaceMix,
}

impl Scene {
    /// Leaves these parameters open, and these columns, which observed drops set; what has a tolerance besides varies from drop to drop.
    /// A tolerance of a parameter does not count; one of a column is about the value that is set.
    ///
    /// # Errors
    /// Every path that the scene does not have, and every one that is named twice.
    pub fn fitted(&self, parameters: &[&str], columns: &[&str]) -> Result<Fitted<'_>, Problems> {
        let known = self.quantities();
        let named: Vec<String> = parameters.iter().chain(columns).map(|path| self.canonical(path)).collect();
        let mut paths: Vec<&str> = named.iter().map(String::as_str).collect();
        let varies = |quantity: &&NamedQuantity| quantity.varies() && !named.contains(&quantity.path);
        paths.extend(known.iter().filter(varies).map(|quantity| quantity.path.as_str()));
        let variants = self.variants(&paths)?;
        Ok(Fitted {
            variants,
            parameters: parameters.len(),
            columns: columns.len(),
            faces: FaceMix::of(self),
        })
    }
}

impl Fitted<'_> {
    /// The parameters, as the scene has them.
    pub fn parameters(&self) -> impl Iterator<Item = &NamedQuantity> {
        self.variants.open().take(self.parameters)
    }

    /// How many quantities vary from drop to drop; the face on which the part starts is the last of them, where that is one of several.
    pub fn dimensions(&self) -> usize {
        self.varying().count() + usize::from(self.faces.varies())
    }

    /// What varies from drop to drop: its place among what is open, and its tolerance.
    fn varying(&self) -> impl Iterator<Item = (usize, &NamedQuantity, Tolerance)> {
        let open = self.variants.open().enumerate().skip(self.parameters);
        open.filter_map(|(place, quantity)| Some((place, quantity, quantity.tolerance?)))
    }

    /// The feeder of one drop, SI: with these parameters and columns, at this point of the unit cube of what varies. None where what is drawn
    /// cannot be.
    pub fn feeder(&self, parameters: &[f64], columns: &[f64], point: &[f64]) -> Option<Feeder> {
        let mut values: Vec<f64> = parameters.iter().chain(columns).copied().collect();
        values
            .extend(self.variants.open().skip(self.parameters + self.columns).map(|quantity| quantity.value));
        for ((place, quantity, tolerance), share) in self.varying().zip(point) {
            let middle = *values.get(place)?;
            let tolerance = tolerance.moved(middle - quantity.value);
            values[place] = tolerance.at(*share, middle, quantity.kind.interval());
        }
        let face = self.faces.at(point.get(self.varying().count()).copied().unwrap_or(0.0));
        self.variants.feeder_on(&values, face).ok()
    }

    /// The text of the scene with these parameters, SI, each normal with this standard deviation; all else stays.
    ///
    /// # Errors
    /// A quantity that the file does not write down; values that are not allowed, or make the drawing impossible.
    pub fn text(&self, best: &[f64], deviations: &[f64]) -> Result<String, Problems> {
        let paths: Vec<&str> = self.parameters().map(|quantity| quantity.path.as_str()).collect();
        let normal = |sigma: &f64| (*sigma > 0.0).then_some(Tolerance::Sigma { sigma: *sigma });
        let tolerances: Vec<_> = deviations.iter().map(normal).collect();
        self.variants.drawn().variants(&paths)?.text_with(best, &tolerances)
    }
}
