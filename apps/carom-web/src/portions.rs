//! Long work in portions: each worker of the page does one, and one of them puts all together. What comes out does not depend on how many
//! there are.

use crate::regions::{File, Plane};
use crate::reply::{Failure, NamedText, Reply};
use crate::request::{Request, Shared, Side};
use crate::watch::Watch;
use carom::study::map;
use carom::study::regions::{Options, Range};
use carom::study::yields::{Contrasts, Points, Portion};
use carom::tasks::map::{MapAxis, MapError, OutcomeMap};
use carom::tasks::yields::YieldStudy;
use carom_scene::{Drawn, Scene, Varied};
use carom_words::part::Names;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// One portion, `number` of `of`, of a round of the work.
pub(crate) fn of(
    request: &Request,
    study: &Shared,
    (round, portion): (usize, (u32, u32)),
    watch: &dyn Watch,
) -> Result<String, Failure> {
    match study {
        Shared::Yield { samples, seed } => {
            let asked = (*samples, *seed, round, portion);
            match request.is_in_space() {
                true => sampled(&request.space_scene()?.varied()?, asked, watch),
                false => sampled(&request.scene()?.varied()?, asked, watch),
            }
        }
        Shared::Map { axes, cells, depth, accuracy } => {
            let options = Options { accuracy: *accuracy, depth: *depth };
            if request.is_in_the_plane() {
                let scene = request.scene()?;
                let axes = scene_axes(&scene, axes, *cells);
                let plate = last_plate(&scene);
                let known = OutcomeMap::explored(&scene, plate, &axes, options, portion, || watch.step());
                return packed(&map::to_words(&known.map_err(of_map)?));
            }
            let beside = request.files();
            let file = File::of(request, &beside);
            packed(&Plane::of(&file, axes, (*cells, options))?.explored(portion, watch)?)
        }
    }
}

/// Drops of one portion, or of the round that says what decides: how many in all, of which seed, which round, which portion.
fn sampled(
    varied: &Varied<'_, impl Drawn>,
    (samples, seed, round, portion): (u64, u64, usize, (u32, u32)),
    watch: &dyn Watch,
) -> Result<String, Failure> {
    let plan = YieldStudy::plan(varied, samples, seed, Points::Sobol, last_plate(varied.scene()));
    let step = || watch.step();
    packed(&match round {
        0 => YieldStudy::portion(varied, &plan, portion, step).map_err(told)?.to_words(),
        _ => YieldStudy::contrasts(varied, &plan, portion, step).map_err(told)?.to_words(),
    })
}

/// What all portions say together.
pub(crate) fn joined(
    request: &Request,
    study: &Shared,
    known: &[Vec<String>],
    watch: &dyn Watch,
) -> Result<Reply, Failure> {
    let first = known.first().map_or(&[][..], Vec::as_slice);
    match study {
        Shared::Yield { .. } => match request.is_in_space() {
            true => yielded(&request.space_scene()?.varied()?, first, known.get(1)),
            false => yielded(&request.scene()?.varied()?, first, known.get(1)),
        },
        Shared::Map { axes, cells, depth, accuracy } => {
            let options = Options { accuracy: *accuracy, depth: *depth };
            let html = if request.is_in_the_plane() {
                let scene = request.scene()?;
                let axes = scene_axes(&scene, axes, *cells);
                let mut nodes = vec![];
                for portion in first {
                    nodes.extend(map::of_words(&unpacked::<Vec<u64>>(portion)?).ok_or_else(unread)?);
                }
                let plate = last_plate(&scene);
                let drawn = OutcomeMap::drawn(&scene, plate, axes, options, &nodes, || watch.step());
                drawn.map_err(of_map)?.live()
            } else {
                let beside = request.files();
                let file = File::of(request, &beside);
                let mut told = vec![];
                for portion in first {
                    told.extend(unpacked::<Vec<_>>(portion)?);
                }
                Plane::of(&file, axes, (*cells, options))?.drawn(told, watch)?
            };
            Ok(Reply { html: Some(html), ..Reply::default() })
        }
    }
}

/// How surely it ends as wanted on its last plate, and drops to look at; or that what decides has to be asked.
fn yielded(
    varied: &Varied<'_, impl Drawn>,
    counted: &[String],
    deciding: Option<&Vec<String>>,
) -> Result<Reply, Failure> {
    let mut portions = vec![];
    for portion in counted {
        portions.push(Portion::of_words(&unpacked::<Vec<u64>>(portion)?).map_err(told)?);
    }
    let mut studied = YieldStudy::of(varied, portions).map_err(told)?;
    match deciding {
        None if studied.to_decide().is_some() => return Ok(Reply { again: true, ..Reply::default() }),
        None => {}
        Some(portions) => {
            let mut contrasts = vec![];
            for portion in portions {
                contrasts.push(Contrasts::of_words(&unpacked::<Vec<u64>>(portion)?).map_err(told)?);
            }
            studied.decided(Ok(contrasts));
        }
    }
    let scenes = studied.worst_scenes().into_iter().map(|(name, text)| NamedText { name, text });
    Ok(Reply { html: Some(studied.live()), scenes: Some(scenes.collect()), ..Reply::default() })
}

fn scene_axes(scene: &Scene, sides: &[Side; 2], cells: usize) -> [MapAxis; 2] {
    let quantities = scene.quantities();
    sides.each_ref().map(|side| {
        let own = quantities.iter().find(|quantity| quantity.path == side.path);
        let unit = own.map(|quantity| quantity.kind.dimension).and_then(|of| of.unit(of.usual()));
        let shown = |value: f64| unit.map_or(value, |unit| unit.of_si(value));
        let range = Range { from: shown(side.from), to: shown(side.to), count: cells };
        MapAxis { path: side.path.clone(), range, unit }
    })
}

fn last_plate(scene: &impl Drawn) -> usize {
    Drawn::feeder(scene).plate_count() - 1
}

fn packed(value: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string(value).map_err(told)
}

fn unpacked<T: DeserializeOwned>(portion: &str) -> Result<T, Failure> {
    serde_json::from_str(portion).map_err(|_| unread())
}

fn unread() -> Failure {
    Failure::of_page("a worker's portion cannot be read")
}

fn told(error: impl std::fmt::Display) -> Failure {
    Failure::of_page(&error.to_string())
}

fn of_map(error: MapError) -> Failure {
    match error {
        MapError::Scene(problems) => problems.into(),
        MapError::Regions(error) => told(error),
    }
}
