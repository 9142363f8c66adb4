//! How a drop of a scene ends over two of its quantities: the study of `carom map`.

mod cells;
mod report;
mod study;

pub use cells::MapCells;
pub use study::{MapAsked, MapStudy};

use carom_feeder::Verdict;
use carom_figure::{RegionAxis, RegionDiagram, RegionName, live_regions, regions_svg};
use carom_scene::unit::Unit;
use carom_scene::{Drawn, Problems, Scene, Variants, Want, labelled};
use carom_study::Ending;
use carom_study::map::{Map, Node, draw_cells, draw_knowing, explore};
use carom_study::regions::{Cells, Options, Range, RegionsError};
use carom_words::{part, study as words};

/// An axis of a map.
///
/// # Example
/// ```
/// use carom::tasks::map::MapAxis;
/// use carom::study::regions::Range;
/// let range = Range { from: 5.0, to: 20.0, count: 16 };
/// let slope = MapAxis { path: "plate.upper.slope".to_owned(), range, unit: None };
/// assert_eq!(slope.si(0.1), 0.1);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MapAxis {
    /// Path of its quantity.
    pub path: String,
    /// Its ends in the unit it is shown in, and its cells.
    pub range: Range,
    /// The unit it is shown in; `None` for plain numbers.
    pub unit: Option<Unit>,
}

impl MapAxis {
    /// A value of the axis in SI.
    pub fn si(&self, shown: f64) -> f64 {
        self.unit.map_or(shown, |unit| unit.to_si(shown))
    }

    /// An SI value in the unit of the axis.
    pub fn shown(&self, si: f64) -> f64 {
        self.unit.map_or(si, |unit| unit.of_si(si))
    }

    /// The symbol of its unit; empty for plain numbers.
    pub fn symbol(&self) -> &'static str {
        self.unit.map_or("", |unit| unit.symbol)
    }
}

/// A map and what it is of.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks::map::{MapAxis, OutcomeMap}};
/// use carom::study::regions::{Options, Range};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let axis = |path: &str, from, to| MapAxis { path: path.to_owned(), range: Range { from, to, count: 6 }, unit: None };
/// let axes = [axis("contact.friction", 0.05, 0.17), axis("contact.restitution", 0.0, 0.4)];
/// let map = OutcomeMap::drawn(&scene, 1, axes, Options::default(), &[], || {}).unwrap();
/// assert!(map.map.drops > 36 && map.svg().contains("how a drop ends"));
/// # Ok::<(), carom::Error>(())
/// ```
pub struct OutcomeMap<'s, S: Drawn = Scene> {
    /// The scene.
    pub scene: &'s S,
    /// The plate on which endings are told apart.
    pub plate: usize,
    /// Abscissa and ordinate.
    pub axes: [MapAxis; 2],
    /// What came out.
    pub map: Map,
}

/// Why there is no map.
///
/// # Example
/// ```
/// use carom::tasks::map::MapError;
/// let error = MapError::Regions(carom::study::regions::RegionsError::Cells { count: 0 });
/// assert!(error.to_string().starts_with("0 cells"));
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MapError {
    /// A quantity that the scene does not have, or has twice here.
    #[error(transparent)]
    Scene(#[from] Problems),
    /// A range, a number of cells, an accuracy or a depth.
    #[error(transparent)]
    Regions(#[from] RegionsError),
}

impl<'s, S: Drawn> OutcomeMap<'s, S> {
    /// Drops over the plane, but for those that are known from [`OutcomeMap::explored`]; `step` is called after each.
    ///
    /// # Errors
    /// See [`MapError`].
    pub fn drawn(
        scene: &'s S,
        plate: usize,
        axes: [MapAxis; 2],
        options: Options,
        known: &[Node],
        step: impl Fn() + Sync,
    ) -> Result<Self, MapError> {
        let feeder = feeder(scene, &axes, step)?;
        let map = draw_knowing(axes.each_ref().map(|axis| axis.range), &options, plate, feeder, known)?;
        Ok(Self { scene, plate, axes, map })
    }

    /// As [`OutcomeMap::drawn`], and how the drop at the middle of every cell of these axes ends; the map has an eighth of the cells, across and up.
    ///
    /// # Errors
    /// See [`MapError`].
    pub fn with_cells(
        scene: &'s S,
        plate: usize,
        axes: [MapAxis; 2],
        options: Options,
        step: impl Fn() + Sync,
    ) -> Result<(Self, Cells<Ending>), MapError> {
        let feeder = feeder(scene, &axes, step)?;
        let ranges = axes.each_ref().map(|axis| axis.range);
        let (map, cells) = draw_cells(ranges, &options, plate, feeder)?;
        Ok((Self { scene, plate, axes, map }, cells))
    }

    /// The drops of one band of the plane, `number` of `of` from 0, for a machine of its own; `step` is called after each.
    ///
    /// # Errors
    /// See [`MapError`].
    pub fn explored(
        scene: &S,
        plate: usize,
        axes: &[MapAxis; 2],
        options: Options,
        band: (u32, u32),
        step: impl Fn() + Sync,
    ) -> Result<Vec<Node>, MapError> {
        let feeder = feeder(scene, axes, step)?;
        Ok(explore(axes.each_ref().map(|axis| axis.range), &options, plate, band, feeder)?)
    }

    /// The picture, by itself.
    pub fn svg(&self) -> String {
        self.diagram(regions_svg)
    }

    /// The picture as a page that stays open shows it: without a style of its own.
    pub fn live(&self) -> String {
        self.diagram(live_regions)
    }

    fn diagram(&self, show: impl Fn(&RegionDiagram<'_, Ending>) -> String) -> String {
        let axis = |axis: &MapAxis| RegionAxis {
            name: labelled(&axis.path).into_owned(),
            unit: axis.symbol().to_owned(),
        };
        let plate = part::obstacle(self.scene.feeder(), self.plate);
        show(&RegionDiagram {
            title: format!("{}: how a drop ends on \"{plate}\"", self.scene.name()),
            subtitle: self.subtitle(),
            axes: self.axes.each_ref().map(axis),
            regions: &self.map.regions,
            name: &|ending| RegionName { long: self.words(ending), ..name(ending) },
            curves_are: String::new(),
            curves: vec![],
            here: Some((self.axes.each_ref().map(|axis| self.here(axis)), "the scene".to_owned())),
        })
    }

    /// Where the scene is on an axis.
    fn here(&self, axis: &MapAxis) -> f64 {
        let path = self.scene.canonical(&axis.path);
        let own = self.scene.quantities().into_iter().find(|quantity| quantity.path == path);
        own.map_or(f64::NAN, |quantity| axis.shown(quantity.value))
    }

    /// Below the title: how much of the plane was not looked into, and what is no axis.
    fn subtitle(&self) -> String {
        let axes = self.axes.each_ref().map(|axis| self.scene.canonical(&axis.path));
        let quantities = self.scene.quantities().into_iter();
        let fixed = quantities.filter(|q| q.written && !axes.contains(&q.path));
        let fixed: Vec<String> =
            fixed.map(|q| format!("{} {}", labelled(&q.path), q.kind.dimension.show(q.value))).collect();
        let (fixed, crowded) = (fixed.join(", "), 100.0 * self.map.regions.crowded);
        if crowded > 0.0 { format!("not looked into: {crowded:.3} % of the plane; {fixed}") } else { fixed }
    }

    /// How an ending is written in full: with a word where it is the one that the scene wants on the plate.
    pub fn words(&self, ending: Ending) -> String {
        let wanted = match self.scene.wants().get(self.plate).copied().flatten() {
            Some(Want::Same) => Some(Ending::Lies(Verdict::Same)),
            Some(Want::Turned) => Some(Ending::Lies(Verdict::Turned)),
            Some(Want::Face(face)) => Some(Ending::Lies(Verdict::Face(face))),
            Some(Want::Any) | None => None,
        };
        let words = words::ending(ending);
        if wanted == Some(ending) { format!("{words}, as wanted") } else { words }
    }
}

/// The feeder at a point of the plane; `step` is called for each.
fn feeder<S: Drawn>(
    scene: &S,
    axes: &[MapAxis; 2],
    step: impl Fn() + Sync,
) -> Result<impl Fn(f64, f64) -> Option<S::Feeder> + Sync, Problems> {
    let variants = Variants::over(scene, &[axes[0].path.as_str(), axes[1].path.as_str()])?;
    let [across, up] = axes.clone();
    Ok(move |x: f64, y: f64| {
        step();
        variants.feeder(&[across.si(x), up.si(y)]).ok()
    })
}

/// How an ending is written on a map.
pub fn name(ending: Ending) -> RegionName {
    RegionName { short: words::letters(ending), long: words::ending(ending) }
}
