//! `carom map`: how a drop ends, over two quantities of a scene.

mod report;

use crate::args::{Format, MapOptions, Output};
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;
use crate::quantities::{keys, named, plate};
use crate::regions::keys::{Axis, Complaints, Plane, read};
use carom_figure::{RegionAxis, RegionDiagram, RegionName, regions_csv, regions_svg};
use carom_scene::columns::{Column, ColumnsError, Table};
use carom_scene::{Scene, Variants};
use carom_study::map::{Map, Node, draw};
use carom_study::{Ending, regions};
use carom_words::{part, study};
use std::io::Write;

/// A map and what it is of.
struct Drawn<'s> {
    scene: &'s Scene,
    plate: usize,
    plane: Plane,
    accuracy: f64,
    map: Map,
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
    let paths = [0, 1].map(|k| plane.keys[plane.axes[k].key].name.as_str());
    let variants: Variants<'_> = scene.variants(&paths)?;
    let [x, y] = [0, 1].map(|k| plane.axes[k].range);
    let options = regions::Options { accuracy: options.accuracy, depth: options.depth };
    let progress = Progress::new("drops", None);
    let feeder = |x: f64, y: f64| {
        progress.step();
        variants.feeder(&[plane.axes[0].si(x), plane.axes[1].si(y)]).ok()
    };
    let map = draw(x, y, &options, plate, feeder).map_err(|error| Failure::Usage(error.to_string()))?;
    let seconds = progress.seconds();
    drop(progress);
    Ok(Drawn { scene, plate, accuracy: options.accuracy, map, seconds, plane })
}

/// How an ending is written.
fn name(ending: Ending) -> RegionName {
    RegionName { short: study::letters(ending), long: study::ending(ending) }
}

fn deliver(drawn: &Drawn<'_>, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let summary = format!("{}\n", serde_json::to_string_pretty(&report::summary(drawn))?);
    let folder = output.folder(drawn.scene.name());
    let mut written = files::write_drawing(&folder, "map", &svg(drawn))?;
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
    regions_csv(&drawn.map.regions, [&x, &y], &name)
}

/// What every node of the grid measures, as Parquet.
fn nodes(drawn: &Drawn<'_>) -> Result<Vec<u8>, ColumnsError> {
    let nodes = &drawn.map.nodes;
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
        ("scene", drawn.scene.source()),
        ("plate", &drawn.scene.feeder().plates[drawn.plate].name),
        ("version", env!("CARGO_PKG_VERSION")),
    ];
    let mut table = Table::new(&columns, &units, &about)?;
    table.push(&columns)?;
    table.finish()
}

fn svg(drawn: &Drawn<'_>) -> String {
    let axis = |k: usize| {
        let axis = &drawn.plane.axes[k];
        RegionAxis { name: drawn.plane.keys[axis.key].words.clone(), unit: axis.unit().to_owned() }
    };
    let plate = part::obstacle(drawn.scene.feeder(), drawn.plate);
    regions_svg(&RegionDiagram {
        title: format!("{}: how a drop ends on \"{plate}\"", drawn.scene.name()),
        subtitle: report::subtitle(drawn),
        axes: [axis(0), axis(1)],
        regions: &drawn.map.regions,
        name: &|ending| RegionName { long: report::words(drawn, ending), ..name(ending) },
        curves_are: String::new(),
        curves: vec![],
        here: Some((
            drawn.plane.axes.each_ref().map(|axis| axis.here(&drawn.plane.keys)),
            "the scene".to_owned(),
        )),
    })
}
