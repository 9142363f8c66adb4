//! The layouts that a scene's `[design]` leaves open.

use crate::drawing::{Free, Want};
use crate::drawn::Drawn;
use crate::problem::{Problem, ProblemKind, Problems};
use crate::scene::{NamedQuantity, Scene};
use crate::unit::Dimension;
use crate::variants::Variants;
use crate::varied::Varied;
use carom_study::Device;
use carom_study::design::{Layout, Space, Varying};
use std::borrow::Cow;

/// The layouts of a design.
///
/// # Example
/// The lower plate's slope may be 10° to 40°, its drop 120 mm to 260 mm.
/// ```
/// use carom_scene::*;
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// use carom_study::design::Space;
/// let space = scene.design_space()?;
/// assert_eq!((space.dimensions(), space.varying()), (2, 3));
/// let [slope, drop] = space.values(&[0.5, 0.5])[..] else { panic!("two values") };
/// assert!((slope - 25_f64.to_radians()).abs() < 1e-15 && (drop - 0.19).abs() < 1e-15);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug)]
pub struct DesignSpace<'s, S: Drawn = Scene> {
    variants: Variants<'s, S>,
    free: &'s [Free],
    /// Of each free quantity: true for a count.
    counts: Vec<bool>,
    varying: usize,
}

impl Scene {
    /// What `[design]` leaves open.
    ///
    /// # Errors
    /// There is no `[design]`, it leaves nothing open, nothing varies, or nothing is wanted on any plate.
    pub fn design_space(&self) -> Result<DesignSpace<'_>, Problems> {
        DesignSpace::of(self)
    }
}

impl<'s, S: Drawn> DesignSpace<'s, S> {
    /// What `[design]` of a scene leaves open, in the plane or in space.
    ///
    /// # Errors
    /// As [`Scene::design_space`].
    pub fn of(scene: &'s S) -> Result<Self, Problems> {
        let fail = |message: &str, help: &str| {
            let problem = Problem::new(ProblemKind::MissingKey, "design", message, None).with_help(help);
            Err(Problems::new(scene.file(), scene.source(), vec![problem]))
        };
        let help = "for example [design] with free = { \"plate.lower.slope\" = \"10..40 deg\" }";
        let Some(design) = scene.design() else { return fail("missing: what may be chosen", help) };
        if design.free.is_empty() {
            return fail("nothing may be chosen: free is missing or empty", help);
        }
        if !scene.wants().iter().flatten().any(|want| *want != Want::Any) {
            let problem =
                Problem::new(ProblemKind::MissingKey, "plate", "nothing is wanted on any plate", None)
                    .with_help("write want = \"turned\" (or same, or a face) on a plate");
            return Err(Problems::new(scene.file(), scene.source(), vec![problem]));
        }
        let all = scene.quantities();
        let unwritten = design
            .free
            .iter()
            .filter(|free| all.iter().any(|quantity| quantity.path == free.path && !quantity.written));
        let problems: Vec<Problem> = unwritten
            .map(|free| {
                let message = "is not written in the scene: write the value to begin with";
                Problem::new(ProblemKind::MissingKey, &free.path, message, None)
            })
            .collect();
        if !problems.is_empty() {
            return Err(Problems::new(scene.file(), scene.source(), problems));
        }
        let paths: Vec<&str> = design.free.iter().map(|free| free.path.as_str()).collect();
        let variants = Variants::over(scene, &paths)?;
        let counts = variants.open().map(|quantity| quantity.kind.dimension == Dimension::Count).collect();
        let varying = Varied::over(scene, 1.0)?.dimensions();
        Ok(DesignSpace { variants, free: &design.free, counts, varying })
    }
}

impl<S: Drawn> DesignSpace<'_, S> {
    /// The values of the free quantities at a point of the unit cube, SI.
    pub fn values(&self, point: &[f64]) -> Vec<f64> {
        let at = |((free, share), count): ((&Free, &f64), &bool)| {
            if *count {
                // Every whole number has the same room.
                (free.low + (share * (free.high - free.low + 1.0)).floor()).min(free.high)
            } else {
                free.low * (1.0 - share) + free.high * share
            }
        };
        self.free.iter().zip(point).zip(&self.counts).map(at).collect()
    }

    /// The quantities that may be chosen, in the order of the dimensions.
    pub fn quantities(&self) -> impl ExactSizeIterator<Item = &NamedQuantity> {
        self.variants.open()
    }

    /// The whole scene at a point of the unit cube.
    ///
    /// # Errors
    /// What is drawn cannot be.
    pub fn scene(&self, point: &[f64]) -> Result<S, Problems> {
        self.scene_with(&self.values(point))
    }

    /// The whole scene with these values of the free quantities, SI.
    ///
    /// # Errors
    /// What is drawn cannot be.
    pub fn scene_with(&self, values: &[f64]) -> Result<S, Problems> {
        self.variants.scene(values)
    }

    /// A value within the range that is free.
    pub fn within(&self, quantity: usize, value: f64) -> bool {
        self.free.get(quantity).is_some_and(|free| (free.low..=free.high).contains(&value))
    }

    /// The text of the scene with these values of the free quantities, tolerances kept.
    ///
    /// # Errors
    /// As [`Variants::text_with_tolerances`].
    ///
    /// # Example
    /// ```
    /// use carom_scene::*;
    /// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
    /// let text = scene.design_space()?.text(&[0.5, 0.2])?;
    /// assert!(text.contains("drop  = \"200.0 mm\"") && text.contains("friction    = \"0.15 ± 0.03\""));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text(&self, values: &[f64]) -> Result<String, Problems> {
        self.variants.text_with_tolerances(values)
    }
}

impl<S: Drawn> Space for DesignSpace<'_, S> {
    type Feeder = S::Feeder;

    fn dimensions(&self) -> usize {
        self.free.len()
    }

    fn varying(&self) -> usize {
        self.varying
    }

    fn layout(&self, point: &[f64]) -> Option<Layout<S::Feeder>> {
        let feeder = self.variants.feeder(&self.values(point)).ok()?;
        let [width, height] = feeder.extent();
        Some(Layout { feeder, height, width })
    }

    fn met(&self, point: &[f64], run: &<S::Feeder as Device>::Run) -> bool {
        // Where plates are counted, which of them is the last is the layout's own matter.
        if self.counts.contains(&true) {
            return self.scene(point).is_ok_and(|scene| scene.ends_as_wanted(run).unwrap_or(true));
        }
        self.variants.drawn().ends_as_wanted(run).unwrap_or(true)
    }

    fn varied(&self, point: &[f64], widened: f64) -> Option<Varying<'_, S::Feeder>> {
        let varied = Varied::<S>::of(Cow::Owned(self.scene(point).ok()?), widened).ok()?;
        Some(Box::new(move |point: &[f64]| varied.feeder(point)))
    }
}
