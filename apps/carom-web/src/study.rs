//! Many drops of a scene.

use crate::reply::{Failure, NamedText, Reply};
use crate::request::Side;
use crate::watch::Watch;
use carom::study::regions::{Options, Range};
use carom::study::yields::Points;
use carom::tasks::map::{MapAxis, MapError, OutcomeMap};
use carom::tasks::yields::YieldStudy;
use carom_scene::Scene;

/// How surely it ends as wanted on its last plate, and drops to look at.
pub(crate) fn yielded(scene: &Scene, samples: u64, seed: u64, watch: &dyn Watch) -> Result<Reply, Failure> {
    let varied = scene.varied()?;
    let plan = YieldStudy::plan(&varied, samples, seed, Points::Sobol, last_plate(scene));
    let mut studied = YieldStudy::sampled(&varied, plan, || watch.step())
        .map_err(|error| Failure::of_page(&error.to_string()))?;
    studied.decide(|| watch.step());
    let scenes = studied.worst_scenes().into_iter().map(|(name, text)| NamedText { name, text });
    Ok(Reply { html: Some(studied.live()), scenes: Some(scenes.collect()), ..Reply::default() })
}

/// How it ends on its last plate over two quantities, as SVG.
pub(crate) fn map(
    scene: &Scene,
    sides: &[Side; 2],
    cells: usize,
    options: Options,
    watch: &dyn Watch,
) -> Result<String, Failure> {
    let quantities = scene.quantities();
    let axis = |side: &Side| {
        let own = quantities.iter().find(|quantity| quantity.path == side.path);
        let unit = own.map(|quantity| quantity.kind.dimension).and_then(|of| of.unit(of.usual()));
        let shown = |value: f64| unit.map_or(value, |unit| unit.of_si(value));
        let range = Range { from: shown(side.from), to: shown(side.to), count: cells };
        MapAxis { path: side.path.clone(), range, unit }
    };
    let axes = sides.each_ref().map(axis);
    let drawn = OutcomeMap::drawn(scene, last_plate(scene), axes, options, || watch.step());
    drawn.map(|map| map.live()).map_err(|error| match error {
        MapError::Scene(problems) => problems.into(),
        MapError::Regions(error) => Failure::of_page(&error.to_string()),
    })
}

fn last_plate(scene: &Scene) -> usize {
    scene.feeder().plates.len() - 1
}
