//! A scene's quantities and plates, as options name them, and what is wanted on these.

use crate::regions::keys::{Complaints, Key};
use carom_scene::unit::Dimension;
use carom_scene::{Scene, Want, labelled};
use carom_words::part;

/// The number of the plate that is looked at.
pub(crate) fn plate(scene: &Scene, named: Option<&str>, complaints: &mut Complaints) -> usize {
    let plates = &scene.feeder().plates;
    let Some(named) = named else { return plates.len() - 1 };
    let by_name = plates.iter().position(|plate| plate.name == named);
    let found = by_name.or_else(|| named.parse().ok().filter(|number| *number < plates.len()));
    found.unwrap_or_else(|| {
        let names: Vec<String> =
            (0..plates.len()).map(|plate| part::obstacle(scene.feeder(), plate)).collect();
        complaints.push("--plate", format!("\"{named}\" is none of {}", names.join(", ")));
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

/// What a scene wants of a part, in words; `None` where it wants nothing.
pub(crate) fn wants(scene: &Scene) -> Option<String> {
    let wants = scene.wants().iter().enumerate().filter_map(|(plate, want)| {
        let want = match want.as_ref()? {
            Want::Any => return None,
            Want::Same => "same side".to_owned(),
            Want::Turned => "turned".to_owned(),
            Want::Face(face) => format!("face {face}"),
        };
        Some(format!("{want} on \"{}\"", part::obstacle(scene.feeder(), plate)))
    });
    let wants: Vec<String> = wants.collect();
    (!wants.is_empty()).then(|| wants.join(", "))
}
