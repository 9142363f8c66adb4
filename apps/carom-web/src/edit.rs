//! Changes of a scene that the page makes.

use crate::reply::{Failure, Headline};
use crate::request::{Held, point};
use carom_scene::{Grip, Scene, Snap};
use carom_words::run;
use std::collections::BTreeMap;

/// How it would end with these values.
pub(crate) fn ending_at(scene: &Scene, values: &BTreeMap<String, f64>) -> Result<Headline, Failure> {
    let paths: Vec<&str> = values.keys().map(String::as_str).collect();
    let feeder = scene.variants(&paths)?.feeder(&values.values().copied().collect::<Vec<_>>())?;
    let headline = run::headline(&feeder, &feeder.run_untraced()?);
    Ok(Headline { word: headline.word, plate: headline.plate, wanted: None })
}

/// The scene with these values. Tolerances stay. `read` reads a scene that has got a line more.
pub(crate) fn moved(
    scene: &Scene,
    values: &BTreeMap<String, f64>,
    read: &dyn Fn(&str) -> Result<Scene, Failure>,
) -> Result<String, Failure> {
    let paths: Vec<&str> = values.keys().map(String::as_str).collect();
    let variants = scene.variants(&paths)?;
    let open: Vec<_> = variants.open().cloned().collect();
    let of_its_own: Vec<f64> = values.values().copied().collect();
    if open.iter().all(|quantity| quantity.span.is_some()) {
        return Ok(variants.text_with_tolerances(&of_its_own)?);
    }
    // A default gets its line first.
    let missing = open.iter().zip(&of_its_own).find(|(quantity, _)| quantity.span.is_none());
    let Some((quantity, value)) = missing else { return Ok(scene.source().to_owned()) };
    let text = scene.text_writing(&quantity.path, &format!("{value:?} {}", quantity.kind.dimension.si()))?;
    moved(&read(&text)?, values, read)
}

/// The scene with a quantity as a person typed it.
pub(crate) fn written(scene: &Scene, path: &str, value: &str) -> Result<String, Failure> {
    Ok(scene.text_writing(path, value)?)
}

/// The scene after a grip was dragged.
pub(crate) fn dragged(scene: &Scene, held: &Held, to: [f64; 2], snap: [f64; 2]) -> Result<String, Failure> {
    let grip = match held.obstacle {
        None => Grip::Part,
        Some(index) => Grip::Obstacle {
            index,
            ends: held.ends.map(point),
            cut: held.cut,
            hold: held.hold.into(),
            at: point(held.at),
        },
    };
    Ok(scene.dragged(&grip, point(to), Snap { length: snap[0], angle: snap[1] })?)
}
