//! `carom fit`: which friction, which restitution agrees with drops that were observed.

use crate::args::{Format, Output};
use crate::failure::Failure;
use crate::files;
use crate::printed::with_files;
use crate::progress::{Progress, spent};
use carom::tasks::axes::Asker;
use carom::tasks::fits::{FitAsked, FitStudy};
use carom_scene::Scene;
use clap::Args;
use std::io::Write;
use std::path::{Path, PathBuf};

#[derive(Args, Debug)]
pub(crate) struct FitOptions {
    /// Scene file, with tolerances of what varies from drop to drop.
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// CSV file of drops that were observed.
    #[arg(value_name = "RUNS")]
    pub(crate) runs: PathBuf,
    /// A quantity to fit and its range, once for each [default: every friction and restitution that the scene writes, 0..1].
    #[arg(long, value_name = "PATH=LOW..HIGH", allow_hyphen_values = true)]
    pub(crate) over: Vec<String>,
    /// Probability that an interval holds.
    #[arg(long, default_value_t = 0.95)]
    pub(crate) level: f64,
    /// Standard deviation of times that have no scatter of their own: "5 ms" [default: it is fitted].
    #[arg(long, value_name = "TIME")]
    pub(crate) scatter: Option<String>,
    /// Drops of the engine at each node, where something varies from drop to drop; rounded up to 16 times a power of two.
    #[arg(long, default_value_t = 256, value_parser = clap::value_parser!(u64).range(16..=1 << 20))]
    pub(crate) samples: u64,
    /// Most nodes that the engine is asked at.
    #[arg(long, default_value_t = 10_000, value_parser = clap::value_parser!(u32).range(100..=1 << 20))]
    pub(crate) nodes: u32,
    /// What every random number comes from: the same seed gives the same result.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// The plate to look at, by name or number from 0 [default: the last].
    #[arg(long, value_name = "PLATE")]
    pub(crate) plate: Option<String>,
    /// Where the fitted scene is written [default: fitted.toml in the scene's folder of results].
    #[arg(long, value_name = "FILE")]
    pub(crate) write: Option<PathBuf>,
}

pub(crate) fn fit(options: &FitOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let rows = files::read_input(&options.runs)?;
    let asked = FitAsked {
        over: &options.over,
        level: options.level,
        scatter: options.scatter.as_deref(),
        samples: options.samples,
        nodes: options.nodes,
        seed: options.seed,
        plate: options.plate.as_deref(),
        asker: Asker::Command,
    };
    let progress = Progress::new("drops", None);
    let runs = options.runs.display().to_string();
    let study = FitStudy::fitted(&scene, (&runs, &rows), &asked, || progress.step())?;
    let seconds = progress.seconds();
    drop(progress);
    deliver((&study, seconds), options.write.as_deref(), output, out)
}

/// Writes everything and says what came out.
fn deliver(
    (study, seconds): (&FitStudy<'_>, f64),
    write: Option<&Path>,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let folder = output.folder(study.scene.name());
    let file = write.map_or_else(|| folder.join("fitted.toml"), Path::to_path_buf);
    let parent = file.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let text = study.fitted_scene()?;
    files::bring_outline(study.scene, parent)?;
    let mut written = vec![files::write(parent, &name, &text)?];
    let summary = study.summary(spent(study.drops, seconds));
    let summary = format!("{}\n", serde_json::to_string_pretty(&summary)?);
    written.push(files::write(&folder, "fit.json", &summary)?);
    match output.format {
        Format::Text => out.write_all(with_files(study.text(seconds), &written).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(())
}
