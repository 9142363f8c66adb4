//! `carom map`: how a drop ends, over two quantities of a scene.

mod report;

use crate::args::{Format, MapOptions, Output};
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;
use crate::quantities::{keys, named, plate};
use crate::regions::keys::{Axis, Complaints, Plane, read};
use carom::tasks::map::{MapError, OutcomeMap, name};
use carom_figure::regions_csv;
use carom_scene::Scene;
use carom_scene::columns::{Column, ColumnsError, Table};
use carom_study::map::Node;
use carom_study::regions;
use carom_words::study;
use std::io::Write;

/// A map and what it is of.
struct Drawn<'s> {
    map: OutcomeMap<'s>,
    plane: Plane,
    accuracy: f64,
    seconds: f64,
}

pub(crate) fn map(options: &MapOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let mut complaints = Complaints::default();
    let plate = plate(&scene, options.plate.as_deref(), &mut complaints);
    let (scene, plane) = plane(&scene, options, complaints)?;
    let drawn = computed(&scene, plate, plane, options)?;
    deliver(&drawn, output, out)
}

/// The scene as it is set, and the plane over it.
fn plane(scene: &Scene, options: &MapOptions, mut complaints: Complaints) -> Result<(Scene, Plane), Failure> {
    let (x, y) = (named(scene, &options.x), named(scene, &options.y));
    let set: Vec<String> = options.set.iter().map(|set| named(scene, set)).collect();
    if !(regions::LEAST_ACCURACY..=0.1).contains(&options.accuracy) {
        let least = regions::LEAST_ACCURACY;
        complaints.push("--accuracy", format!("{} is outside {least} to 0.1", options.accuracy));
    }
    let plane = read(keys(scene), &set, [&x, &y], &mut complaints);
    complaints.finish()?;
    let plane = plane.ok_or_else(|| Failure::Usage("the axes could not be read".to_owned()))?;
    let mut scene = scene.clone();
    for setting in &set {
        if let Some((path, _)) = setting.split_once('=')
            && let Some(key) = plane.keys.iter().find(|key| key.name == path.trim())
        {
            scene = scene.with(&key.name, key.value)?;
        }
    }
    Ok((scene, plane))
}

fn computed<'s>(
    scene: &'s Scene,
    plate: usize,
    plane: Plane,
    options: &MapOptions,
) -> Result<Drawn<'s>, Failure> {
    let axes = plane.axes.each_ref().map(|axis| axis.of_map(&plane.keys));
    let looked = regions::Options { accuracy: options.accuracy, depth: options.depth };
    let progress = Progress::new("drops", None);
    let map =
        OutcomeMap::drawn(scene, plate, axes, looked, &[], || progress.step()).map_err(
            |error| match error {
                MapError::Scene(problems) => Failure::from(problems),
                MapError::Regions(error) => Failure::Usage(error.to_string()),
            },
        )?;
    let seconds = progress.seconds();
    drop(progress);
    Ok(Drawn { map, accuracy: options.accuracy, seconds, plane })
}

fn deliver(drawn: &Drawn<'_>, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let summary = format!("{}\n", serde_json::to_string_pretty(&report::summary(drawn))?);
    let folder = output.folder(drawn.map.scene.name());
    let mut written = files::write_drawing(&folder, "map", &drawn.map.svg())?;
    written.push(files::write(&folder, "map.csv", &csv(drawn))?);
    written.extend(files::write_table(&folder, "map.parquet", nodes(drawn))?);
    written.push(files::write(&folder, "map.json", &summary)?);
    match output.format {
        Format::Text => out.write_all(report::text(drawn, &written).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(())
}

/// The boundaries as CSV, with axes as the picture has them.
fn csv(drawn: &Drawn<'_>) -> String {
    let [x, y] = [0, 1].map(|k| {
        let axis = &drawn.plane.axes[k];
        let path = &drawn.plane.keys[axis.key].name;
        if axis.unit().is_empty() { path.clone() } else { format!("{path} [{}]", axis.unit()) }
    });
    regions_csv(&drawn.map.map.regions, [&x, &y], &name)
}

/// What every node of the grid measures, as Parquet.
fn nodes(drawn: &Drawn<'_>) -> Result<Vec<u8>, ColumnsError> {
    let nodes = &drawn.map.map.nodes;
    let number = |of: &dyn Fn(&Node) -> Option<f64>| Column::Number(nodes.iter().map(of).collect());
    let [x, y] = &drawn.plane.axes;
    let path = |axis: &Axis| drawn.plane.keys[axis.key].name.as_str();
    let columns = [
        (path(x), number(&|node| Some(x.si(node.x)))),
        (path(y), number(&|node| Some(y.si(node.y)))),
        ("ending", Column::Word(nodes.iter().map(|node| Some(study::ending(node.ending))).collect())),
        ("impact_speed_m_s", number(&|node| node.impact_speed)),
        ("flat_s", number(&|node| node.flat)),
        ("margin", number(&|node| node.margin)),
    ];
    let si = |axis: &Axis| drawn.plane.keys[axis.key].dimension.si();
    let units = [si(x), si(y), "", "m/s", "s", ""];
    let about = [
        ("scene", drawn.map.scene.source()),
        ("plate", &drawn.map.scene.feeder().plates[drawn.map.plate].name),
        ("version", env!("CARGO_PKG_VERSION")),
    ];
    let mut table = Table::new(&columns, &units, &about)?;
    table.push(&columns)?;
    table.finish()
}
