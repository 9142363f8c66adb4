//! Changes of a scene that the page makes.

use crate::reply::Failure;
use crate::request::{Held, point};
use carom_scene::{Grip, Scene, Snap};

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
