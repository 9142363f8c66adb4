//! Changes of a scene that the page makes.

use crate::reply::{Failure, Headline};
use crate::request::{Change, Table, point};
use carom_scene::{Scene, Snap, editing};
use carom_words::run;
use std::collections::BTreeMap;

/// How it would end with these values.
pub(crate) fn ending_at(scene: &Scene, values: &BTreeMap<String, f64>) -> Result<Headline, Failure> {
    let paths: Vec<&str> = values.keys().map(String::as_str).collect();
    let feeder = scene.variants(&paths)?.feeder(&values.values().copied().collect::<Vec<_>>())?;
    let headline = run::headline(&feeder, &feeder.run_untraced()?);
    Ok(Headline { word: headline.word, plate: headline.plate, wanted: None })
}

/// The text of a scene after a change. `read` reads a scene that has got a line more.
pub(crate) fn changed(
    scene: &Scene,
    change: &Change,
    read: &dyn Fn(&str) -> Result<Scene, Failure>,
) -> Result<String, Failure> {
    match change {
        Change::Drag { grip, to, snap } => {
            Ok(scene.dragged(&grip.grip(), point(*to), Snap { length: snap[0], angle: snap[1] })?)
        }
        Change::Write { path, value } => Ok(scene.text_writing(path, value)?),
        Change::Move { values } => moved(scene, values, read),
        Change::Add { table, from, to, snap } => Ok(added(scene, *table, [*from, *to], *snap)),
        Change::Remove { obstacle } => removed(scene, *obstacle),
        Change::Want { plate, want } => {
            editing::setting(scene.source(), &format!("plate.{plate}"), "want", want).ok_or_else(tableless)
        }
        Change::Pull { .. } | Change::AddContact { .. } | Change::RemoveContact { .. } => {
            Err(Failure::of_page("this is a scene: only an impact has contacts to pull"))
        }
        Change::Replace { table, lines } => Ok(editing::replacing(scene.source(), table, lines)),
    }
}

fn tableless() -> Failure {
    Failure::of_page("it has no table of its own in the scene: change the channel or the zig-zag")
}

/// The scene with these values. Tolerances stay.
fn moved(
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

/// The scene with one more plate or wall. A plate runs down from its higher end.
fn added(scene: &Scene, table: Table, ends: [[f64; 2]; 2], snap: f64) -> String {
    let feeder = scene.feeder();
    let (word, count) = match table {
        Table::Plate => ("plate", feeder.plates.len()),
        Table::Wall => ("wall", feeder.walls.len()),
    };
    let taken = |name: &str| {
        feeder.plates.iter().any(|plate| plate.name == name)
            || feeder.walls.iter().any(|wall| wall.name == name)
    };
    let names = (count + 1..).map(|number| format!("{word}_{number}"));
    let name = names.into_iter().find(|name| !taken(name)).unwrap_or_default();
    let [mut from, mut to] = ends;
    if table == Table::Plate && to[1] > from[1] {
        (from, to) = (to, from);
    }
    let millimetres = |value: f64| {
        let snapped = if snap > 0.0 { (value / snap).round() * snap } else { value };
        format!("\"{} mm\"", (1e9 * snapped).round() / 1e6)
    };
    let pair = |[x, y]: [f64; 2]| format!("[{}, {}]", millimetres(x), millimetres(y));
    editing::adding(
        scene.source(),
        word,
        &format!("name = \"{name}\"\nfrom = {}\nto = {}", pair(from), pair(to)),
    )
}

/// The scene without a plate or wall.
fn removed(scene: &Scene, obstacle: usize) -> Result<String, Failure> {
    let feeder = scene.feeder();
    let plates = feeder.plates.len();
    let text = match obstacle.checked_sub(plates) {
        None => editing::without(scene.source(), "plate", obstacle),
        Some(wall) => {
            // The walls of a channel have no tables of their own.
            let quantities = scene.quantities();
            let drawn = |name: &str| {
                quantities.iter().any(|quantity| quantity.path.starts_with(&format!("wall.{name}.")))
            };
            let own: Vec<usize> =
                (0..feeder.walls.len()).filter(|wall| drawn(&feeder.walls[*wall].name)).collect();
            own.iter()
                .position(|own| *own == wall)
                .and_then(|number| editing::without(scene.source(), "wall", number))
        }
    };
    text.ok_or_else(tableless)
}
