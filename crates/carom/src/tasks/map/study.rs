//! A map as it is asked for: axes and settings in words.

use super::{MapCells, MapError, OutcomeMap};
use crate::tasks::StudyError;
use crate::tasks::axes::{Asker, Complaints, Plane, keys, named, plate, read};
use carom_scene::{Drawn, Scene};
use carom_study::map::cells_options;
use carom_study::regions::{LEAST_ACCURACY, Options, Range};

/// What is asked of a map.
///
/// # Example
/// ```
/// use carom::tasks::{axes::Asker, map::MapAsked};
/// let axes = ["contact.friction=0.05..0.17:16", "contact.restitution=0..0.4:16"];
/// let asked = MapAsked::over(axes, Asker::Command);
/// assert_eq!((asked.depth, asked.plate), (3, None));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct MapAsked<'a> {
    /// Abscissa and ordinate: `plate.lower.slope=2..38 deg:100`.
    pub axes: [&'a str; 2],
    /// Quantities that are not as in the scene: `contact.friction=0.2`.
    pub set: &'a [String],
    /// The plate to look at, by name or number from 0; the last where none is named.
    pub plate: Option<&'a str>,
    /// How finely boundaries are located, as a share of the axes; where nothing is said 10⁻⁷, or with `cells` a tenth of a cell, which then is the coarsest.
    pub accuracy: Option<f64>,
    /// How often a cell is halved where something in it does not fit.
    pub depth: u32,
    /// Whether to say how the drop at the middle of every cell ends.
    pub cells: bool,
    /// Who asks.
    pub asker: Asker,
}

impl<'a> MapAsked<'a> {
    /// What is asked where nothing but the axes is said.
    pub fn over(axes: [&'a str; 2], asker: Asker) -> Self {
        Self { axes, set: &[], plate: None, accuracy: None, depth: 3, cells: false, asker }
    }

    /// How carefully to look over these ranges: cells need boundaries to a tenth of one.
    fn options(&self, ranges: [Range; 2]) -> Options {
        let cells = self.cells.then(|| cells_options(ranges).accuracy);
        let accuracy = match (self.accuracy, cells) {
            (Some(asked), Some(needed)) => asked.min(needed),
            (asked, needed) => asked.or(needed).unwrap_or(crate::tasks::tolerance::MAP_ACCURACY),
        };
        Options { accuracy, depth: self.depth }
    }

    /// The scene as it is set, the number of the plate, and the plane over it.
    ///
    /// # Errors
    /// Everything that is wrong with what is asked.
    pub fn read<S: Drawn>(&self, scene: &S) -> Result<(S, usize, Plane), StudyError> {
        let mut complaints = Complaints::of(self.asker);
        let plate = plate(scene, self.plate, &mut complaints);
        let [x, y] = self.axes.map(|axis| named(scene, axis));
        let set: Vec<String> = self.set.iter().map(|set| named(scene, set)).collect();
        if let Some(accuracy) = self.accuracy.filter(|accuracy| !(LEAST_ACCURACY..=0.1).contains(accuracy)) {
            complaints.push("accuracy", format!("{accuracy} is outside {LEAST_ACCURACY} to 0.1"));
        }
        let plane = read(keys(scene, self.asker), &set, [&x, &y], &mut complaints);
        complaints.finish()?;
        let plane = plane.ok_or_else(|| StudyError::Asked("the axes could not be read".to_owned()))?;
        let mut scene = scene.clone();
        for setting in &set {
            if let Some((path, _)) = setting.split_once('=')
                && let Some(key) = plane.keys.iter().find(|key| key.name == path.trim())
            {
                scene = scene.with(&key.name, key.value)?;
            }
        }
        Ok((scene, plate, plane))
    }
}

/// A map that was asked for in words.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks::{axes::Asker, map::{MapAsked, MapStudy}}};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let asked = MapAsked::over(["contact.friction=0.05..0.17:6", "contact.restitution=0..0.4:6"], Asker::Command);
/// let (scene, plate, plane) = asked.read(&scene).unwrap();
/// let study = MapStudy::drawn(&scene, plate, plane, &asked, || {}).unwrap();
/// assert!(study.text(0.1).contains("how a drop ends on \"lower\""));
/// # Ok::<(), carom::Error>(())
/// ```
pub struct MapStudy<'s, S: Drawn = Scene> {
    /// The map.
    pub map: OutcomeMap<'s, S>,
    /// Over what it is.
    pub plane: Plane,
    /// How finely boundaries are located, as a share of the axes.
    pub accuracy: f64,
    /// How the drop at the middle of every cell ends, where that was asked.
    pub cells: Option<MapCells>,
}

impl<'s, S: Drawn> MapStudy<'s, S> {
    /// Draws over what [`MapAsked::read`] found; `step` is called after each drop.
    ///
    /// # Errors
    /// A quantity that is named twice; a range, an accuracy or a depth that cannot be.
    pub fn drawn(
        scene: &'s S,
        plate: usize,
        plane: Plane,
        asked: &MapAsked<'_>,
        step: impl Fn() + Sync,
    ) -> Result<Self, StudyError> {
        let axes = plane.axes.each_ref().map(|axis| axis.of_map(&plane.keys));
        let ranges = axes.each_ref().map(|axis| axis.range);
        let options = asked.options(ranges);
        let drawn = if asked.cells {
            let found = OutcomeMap::with_cells(scene, plate, axes, options, step);
            found.map(|(map, cells)| (map, Some(MapCells { ranges, labels: cells.labels })))
        } else {
            OutcomeMap::drawn(scene, plate, axes, options, &[], step).map(|map| (map, None))
        };
        let (map, cells) = drawn.map_err(|error| match error {
            MapError::Scene(problems) => StudyError::from(problems),
            MapError::Regions(error) => StudyError::Asked(error.to_string()),
        })?;
        Ok(Self { map, plane, accuracy: options.accuracy, cells })
    }
}
