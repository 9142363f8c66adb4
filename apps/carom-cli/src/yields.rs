//! `carom yield`: how surely a drop ends as wanted.

mod report;

use crate::args::{Format, Output};
use crate::failure::Failure;
use crate::files;
use crate::printed::with_files;
use crate::progress::{Progress, spent};
use carom::tasks::axes::{Asker, Complaints, plate};
use carom::tasks::yields::{LINES, LocatedYield, YieldStudy, is_of_a_drop};
use carom_scene::{AnyScene, Drawn, Varied};
use carom_study::yields::{Plan, Points, REPETITIONS};
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub(crate) struct YieldOptions {
    /// Scene file, with tolerances: slope = "15 ± 0.5 deg".
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// Drops; rounded up to 16 times a power of two.
    #[arg(long, default_value_t = 16_384, value_parser = clap::value_parser!(u64).range(16..=1 << 34))]
    pub(crate) samples: u64,
    /// Independent random points in place of Sobol's: a check of them.
    #[arg(long)]
    pub(crate) plain: bool,
    /// Locate where drops stop to end as wanted, and say nothing but how surely they do: to about a thousandth, for a tenth to a hundredth of the drops.
    #[arg(long, conflicts_with_all = ["samples", "open"])]
    pub(crate) locate: bool,
    /// With --locate: how many lines are searched for the places where the ending changes; rounded up to 16 times a power of two.
    #[arg(long, default_value_t = LINES, requires = "locate", value_parser = clap::value_parser!(u64).range(16..=1 << 18))]
    pub(crate) lines: u64,
    /// What every random number comes from: the same seed gives the same result.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// The plate to look at, by name or number from 0 [default: the last].
    #[arg(long, value_name = "PLATE")]
    pub(crate) plate: Option<String>,
    /// Open the page when it is written.
    #[arg(long)]
    pub(crate) open: bool,
}

pub(crate) fn yields(options: &YieldOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    match AnyScene::read(&options.scene)? {
        AnyScene::Plane(scene) => of_scene(&*scene, &scene.varied()?, options, output, out),
        AnyScene::Space(scene) => of_scene(&*scene, &scene.varied()?, options, output, out),
    }
}

/// The study of a scene, in the plane or in space.
fn of_scene<S: Drawn>(
    scene: &S,
    varied: &Varied<'_, S>,
    options: &YieldOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let mut complaints = Complaints::of(Asker::Command);
    let plate = plate(scene, options.plate.as_deref(), &mut complaints);
    complaints.finish()?;
    let points = if options.plain { Points::Random } else { Points::Sobol };
    let count = if options.locate { options.lines } else { options.samples };
    let plan = YieldStudy::plan(varied, count, options.seed, points, plate);
    if options.locate {
        return located(varied, plan, output, out);
    }
    let (studied, seconds) = studied(varied, plan)?;
    let page = deliver(&studied, seconds, output, out)?;
    if options.open { files::open(&page) } else { Ok(()) }
}

/// Locates, and writes and says what came out.
fn located<S: Drawn>(
    varied: &Varied<'_, S>,
    plan: Plan,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let progress = Progress::new("drops", None);
    let name = varied.scene().name();
    let found = LocatedYield::of(varied, plan, || progress.step())
        .map_err(|error| Failure::Usage(format!("{name}: {error}")))?;
    let seconds = progress.seconds();
    drop(progress);
    let summary = found.summary(spent(found.drops, seconds));
    let summary = format!("{}\n", serde_json::to_string_pretty(&summary)?);
    let written = files::write(&output.folder(name), "yield-located.json", &summary)?;
    match output.format {
        Format::Text => out.write_all(with_files(found.text(seconds), &[written]).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(())
}

/// The study, and how long it took [s].
fn studied<'s, S: Drawn>(varied: &'s Varied<'s, S>, plan: Plan) -> Result<(YieldStudy<'s, S>, f64), Failure> {
    let progress = Progress::new("drops", Some(plan.rounded() as usize * REPETITIONS));
    let name = varied.scene().name();
    let mut studied = YieldStudy::sampled(varied, plan, || progress.step())
        .map_err(|error| Failure::Usage(format!("{name}: {error}")))?;
    // What decides needs drops of its own: their progress is another line, so this one ends here.
    let mut seconds = progress.seconds();
    drop(progress);
    if let Some(more) = studied.to_decide() {
        let progress = Progress::new("drops for what decides", Some(more));
        studied.decide(|| progress.step());
        seconds += progress.seconds();
    }
    Ok((studied, seconds))
}

/// Writes everything and says what came out; returns where the page is.
fn deliver(
    studied: &YieldStudy<'_, impl Drawn>,
    seconds: f64,
    output: &Output,
    out: &mut impl Write,
) -> Result<PathBuf, Failure> {
    let folder = output.folder(studied.scene.name());
    let mut written = vec![];
    files::bring_outline(studied.scene, &folder)?;
    for (name, text) in studied.worst_scenes() {
        written.push(files::write(&folder, &name, &text)?);
    }
    let summary = studied.summary(spent(studied.drops, seconds));
    let summary = format!("{}\n", serde_json::to_string_pretty(&summary)?);
    written.push(files::write(&folder, "yield.json", &summary)?);
    let page = files::write(&folder, "yield.html", &studied.page(&folder))?;
    written.push(page.clone());
    files::remove_known(&folder, |name| is_of_a_drop(name) && !written.contains(&folder.join(name)))?;
    match output.format {
        Format::Text => out.write_all(report::text(studied, &written, seconds).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(page)
}
