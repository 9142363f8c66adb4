//! `carom map`: how a drop ends, over two quantities of a scene.

use crate::args::{Format, MapOptions, Output};
use crate::failure::Failure;
use crate::files;
use crate::printed::with_files;
use crate::progress::{Progress, spent};
use carom::tasks::axes::Asker;
use carom::tasks::map::{MapAsked, MapStudy};
use carom_scene::{AnyScene, Drawn};
use std::io::Write;

pub(crate) fn map(options: &MapOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let asked = MapAsked {
        axes: [&options.x, &options.y],
        set: &options.set,
        plate: options.plate.as_deref(),
        accuracy: options.accuracy,
        depth: options.depth,
        cells: options.cells,
        asker: Asker::Command,
    };
    match AnyScene::read(&options.scene)? {
        AnyScene::Plane(scene) => of_scene(&*scene, &asked, output, out),
        AnyScene::Space(scene) => of_scene(&*scene, &asked, output, out),
    }
}

fn of_scene(
    scene: &impl Drawn,
    asked: &MapAsked<'_>,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let (scene, plate, plane) = asked.read(scene)?;
    let progress = Progress::new("drops", None);
    let study = MapStudy::drawn(&scene, plate, plane, asked, || progress.step())?;
    let seconds = progress.seconds();
    drop(progress);
    deliver(&study, seconds, output, out)
}

fn deliver(
    study: &MapStudy<'_, impl Drawn>,
    seconds: f64,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let summary = study.summary(spent(study.map.map.drops, seconds));
    let summary = format!("{}\n", serde_json::to_string_pretty(&summary)?);
    let folder = output.folder(study.map.scene.name());
    let mut written = files::write_drawing(&folder, "map", &study.map.svg())?;
    written.push(files::write(&folder, "map.csv", &study.csv())?);
    written.extend(files::write_table(&folder, "map.parquet", study.nodes())?);
    if let Some((text, table)) = study.cells_csv().zip(study.cells_table()) {
        written.push(files::write(&folder, "map-cells.csv", &text)?);
        written.extend(files::write_table(&folder, "map-cells.parquet", table)?);
    } else {
        files::remove(&folder, &["map-cells.csv", "map-cells.parquet"])?;
    }
    written.push(files::write(&folder, "map.json", &summary)?);
    match output.format {
        Format::Text => out.write_all(with_files(study.text(seconds), &written).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(())
}
