//! `carom fit`: which friction, which restitution agrees with drops that were observed.

mod over;
mod report;
mod runs;

use crate::args::{Format, Output};
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;
use crate::quantities;
use crate::regions::keys::{Complaints, quantity};
use carom_motion::planar::Options;
use carom_scene::unit::Dimension;
use carom_scene::{Fitted, Problem, ProblemKind, Problems, Scene};
use carom_study::Dropped;
use carom_study::fits::{self, Fit, FitError, Plan, Simulated};
use clap::Args;
use over::Over;
use runs::Runs;
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

/// A fit and what it is of.
struct Found<'s> {
    scene: &'s Scene,
    fitted: &'s Fitted<'s>,
    over: &'s [Over],
    runs: &'s Runs,
    plan: Plan,
    plate: usize,
    fit: Fit,
    drops: usize,
    seconds: f64,
}

pub(crate) fn fit(options: &FitOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let mut complaints = Complaints::default();
    let plate = quantities::plate(&scene, options.plate.as_deref(), &mut complaints);
    let scatter = scatter(options.scatter.as_deref(), &mut complaints);
    if !(options.level > 0.0 && options.level < 1.0) {
        complaints.push("--level", format!("{} is not between 0 and 1", options.level));
    }
    let over = over::read(&scene, &options.over, &mut complaints);
    let runs = runs::read(&scene, &options.runs, scatter, &over);
    // What is wrong with the command line and with the runs is told together.
    let (over, runs) = match (complaints.finish(), runs) {
        (Ok(()), Ok(runs)) => (over, runs),
        (Ok(()), Err(failure)) => return Err(failure),
        (Err(problems), Err(Failure::Input(mut more))) => {
            more.insert(0, problems);
            return Err(Failure::Input(more));
        }
        (Err(problems), _) => return Err(problems.into()),
    };
    let parameters: Vec<&str> = over.iter().map(|over| over.path.as_str()).collect();
    let columns: Vec<&str> = runs.columns.iter().map(String::as_str).collect();
    let fitted = scene.fitted(&parameters, &columns)?;
    let plan = Plan {
        ranges: over.iter().map(|over| over.range).collect(),
        conditions: runs.conditions.len(),
        dimensions: fitted.dimensions(),
        samples: options.samples,
        seed: options.seed,
        nodes: options.nodes as usize,
        level: options.level,
    };
    let found = found((&scene, &fitted), (&over, &runs), plan, plate)?;
    deliver(&found, options.write.as_deref(), output, out)
}

/// The scatter of times that have none of their own [s].
fn scatter(text: Option<&str>, complaints: &mut Complaints) -> Option<f64> {
    let text = text?;
    match quantity(text, Dimension::Time) {
        Ok(value) if value > 0.0 => return Some(value),
        Ok(_) => complaints.push("--scatter", format!("\"{text}\" must be above 0")),
        Err(message) => complaints.push("--scatter", format!("\"{text}\": {message}")),
    }
    None
}

fn found<'s>(
    (scene, fitted): (&'s Scene, &'s Fitted<'s>),
    (over, runs): (&'s [Over], &'s Runs),
    plan: Plan,
    plate: usize,
) -> Result<Found<'s>, Failure> {
    let progress = Progress::new("drops", None);
    let simulate = |parameters: &[f64], condition: usize, point: &[f64]| {
        progress.step();
        let columns = runs.conditions.get(condition).map_or(&[][..], Vec::as_slice);
        let feeder = fitted.feeder(parameters, columns, point);
        Simulated::of(&Dropped::of(feeder.as_ref(), plate, &Options::default()), plate)
    };
    let fit = fits::fit(&plan, &runs.observations, simulate).map_err(|error| failed(over, runs, &error))?;
    let (drops, seconds) = (progress.count(), progress.seconds());
    Ok(Found { scene, fitted, over, runs, plan, plate, fit, drops, seconds })
}

/// What is wrong with the runs where no value agrees with them, row by row.
fn failed(over: &[Over], runs: &Runs, error: &FitError) -> Failure {
    let ranges: Vec<String> = over.iter().map(Over::shown).collect();
    let (observations, message) = match error {
        FitError::Never { observations } => {
            (observations, format!("never happens, whatever {}", ranges.join(", ")))
        }
        FitError::Contradiction { observations, at } => {
            let at: Vec<String> = over.iter().zip(at).map(|(over, value)| over.at(*value)).collect();
            let message = format!(
                "contradicts the other rows: no value in {} gives all of them; most are as observed at {}, and this is not",
                ranges.join(", "),
                at.join(", ")
            );
            (observations, message)
        }
        FitError::Untimely { observations, spans } => return untimely(runs, observations, spans),
        FitError::Lost { nodes } => {
            return Failure::Undone(format!(
                "the budget of {nodes} nodes ended before it was found where the runs agree best, so there are no intervals: take more --nodes, or a narrower range (--over) of {}",
                ranges.join(", ")
            ));
        }
        other => return Failure::Usage(other.to_string()),
    };
    let help = "is it the right plate (--plate), is the range wide enough (--over), and does what varies from drop to drop have a tolerance in the scene?";
    let problem = |observation: &usize| {
        let place = runs.places.get(*observation).cloned();
        Problem::new(ProblemKind::Conflict, "", message.clone(), place).with_help(help)
    };
    let problems = observations.iter().map(problem).collect();
    Failure::from(Problems::new(&runs.file, &runs.source, problems))
}

/// The rows whose times no drop of the engine takes.
fn untimely(runs: &Runs, observations: &[usize], spans: &[[f64; 2]]) -> Failure {
    let problem = |(observation, span): (&usize, &[f64; 2])| {
        let [low, high] = span.map(|time| Dimension::Time.show_digits(time, 4));
        let message = format!("no drop of the engine that ends so takes so long: they take {low} to {high}");
        let help = "is the time counted from the start of the slide to the first lying flat on the plate, and is the scatter (--scatter) right?";
        Problem::new(ProblemKind::Conflict, "", message, runs.places.get(*observation).cloned())
            .with_help(help)
    };
    let problems = observations.iter().zip(spans).map(problem).collect();
    Failure::from(Problems::new(&runs.file, &runs.source, problems))
}

/// Writes everything and says what came out.
fn deliver(
    found: &Found<'_>,
    write: Option<&Path>,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let folder = output.folder(found.scene.name());
    let file = write.map_or_else(|| folder.join("fitted.toml"), Path::to_path_buf);
    let parent = file.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let text = report::scene(found)?;
    files::bring_outline(found.scene, parent)?;
    let mut written = vec![files::write(parent, &name, &text)?];
    let summary = format!("{}\n", serde_json::to_string_pretty(&report::summary(found))?);
    written.push(files::write(&folder, "fit.json", &summary)?);
    match output.format {
        Format::Text => out.write_all(report::text(found, &written).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(())
}
