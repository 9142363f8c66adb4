//! A scene's quantities and plates, as options name them.

use crate::regions::keys::{Complaints, Key};
use carom::tasks;
use carom_scene::unit::Dimension;
use carom_scene::{Scene, labelled};

/// The number of the plate that is looked at.
pub(crate) fn plate(scene: &Scene, named: Option<&str>, complaints: &mut Complaints) -> usize {
    tasks::plate(scene, named).unwrap_or_else(|message| {
        complaints.push("--plate", message);
        0
    })
}

/// The quantities of a scene that may be moved.
pub(crate) fn keys(scene: &Scene) -> Vec<Key> {
    let quantities = scene.quantities().into_iter();
    let continuous = quantities.filter(|quantity| quantity.kind.dimension != Dimension::Count);
    continuous
        .map(|quantity| {
            let (dimension, allowed) = (quantity.kind.dimension, quantity.kind.interval());
            let key = Key::new(&quantity.path, &labelled(&quantity.path), dimension, quantity.value, allowed);
            Key { needs_unit: true, ..key }
        })
        .collect()
}

/// The same text with a plate's number replaced by its name.
pub(crate) fn named(scene: &Scene, text: &str) -> String {
    let Some((path, rest)) = text.split_once('=') else { return text.to_owned() };
    format!("{}={rest}", scene.canonical(path.trim()))
}
