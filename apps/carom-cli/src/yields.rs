//! `carom yield`: how surely a drop ends as wanted.

mod page;
mod report;

pub(crate) use page::quoted;
pub(crate) use report::percent;

use crate::args::{Format, Output, YieldOptions};
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;
use crate::quantities;
use crate::regions::keys::Complaints;
use carom_feeder::{Feeder, Run};
use carom_impact::planar::Law;
use carom_motion::planar::Options;
use carom_scene::{Scene, Varied};
use carom_study::design::Limits;
use carom_study::yields::{Plan, Points, REPETITIONS, Sensitivity, Worst, Yield, sample_within, sensitivity};
use carom_study::{Dropped, Ending};
use carom_words::study;
use std::io::Write;
use std::path::PathBuf;

/// Samples of a Sobol index, for so many samples of the yield.
const OF_SAMPLES: u64 = 8;
/// Samples of the yield that must end the rarer way for Sobol's indices to be more than noise: 30 of those of an index.
const LEAST_RARE: u64 = 30 * OF_SAMPLES;
/// Most samples that may be asked for.
const MOST_SAMPLES: u64 = 1 << 34;
/// Restitutions under which the laws are compared.
const RESTITUTIONS: [f64; 7] = [0.0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9];

/// Stands for the ending in the name of the file with the hardest strike.
const HARDEST: &str = "hardest";

/// The quantities by how much they decide, or why that is not known.
type Deciders = Result<Vec<Sensitivity>, String>;

/// A yield study and what it is of.
struct Studied<'s> {
    scene: &'s Scene,
    varied: &'s Varied<'s>,
    plan: Plan,
    wanted: Wanted<'s>,
    /// What a layout must keep besides, where the scene says so of a drop.
    limits: Option<Limits>,
    found: Yield,
    deciders: Deciders,
    laws: Vec<(Law, f64, Ending)>,
    drops: usize,
    seconds: f64,
}

/// What is wanted: what the scene says, or else what the drop of the middle of all tolerances does.
struct Wanted<'s> {
    scene: &'s Scene,
    plate: usize,
    middle: Ending,
}

impl Wanted<'_> {
    fn met(&self, run: &Run) -> bool {
        self.scene.ends_as_wanted(run).unwrap_or_else(|| Ending::of(run, self.plate) == self.middle)
    }
}

pub(crate) fn yields(options: &YieldOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let mut complaints = Complaints::default();
    let plate = quantities::plate(&scene, options.plate.as_deref(), &mut complaints);
    complaints.finish()?;
    let varied = scene.varied()?;
    let plan = Plan {
        dimensions: varied.dimensions(),
        samples: options.samples.div_ceil(REPETITIONS as u64),
        seed: options.seed,
        points: if options.plain { Points::Random } else { Points::Sobol },
        plates: scene.feeder().plates.len(),
        plate,
    };
    let studied = studied(&scene, &varied, plan)?;
    let page = deliver(&studied, output, out)?;
    if options.open { files::open(&page) } else { Ok(()) }
}

fn studied<'s>(scene: &'s Scene, varied: &'s Varied<'s>, plan: Plan) -> Result<Studied<'s>, Failure> {
    let options = Options::default();
    let middle = Dropped::of(Some(scene.feeder()), plan.plate, &options).ending;
    let wanted = Wanted { scene, plate: plan.plate, middle };
    let all = plan.rounded() as usize * REPETITIONS;
    let limits = scene.design().map(|design| design.limits()).filter(Limits::are_of_drops);
    let keeps = |run: &Run| limits.is_none_or(|limits| limits.keeps(run));
    let progress = Progress::new("drops", Some(all));
    let feeder = |point: &[f64]| {
        progress.step();
        varied.feeder(point)
    };
    let asked = (|run: &Run| wanted.met(run), keeps);
    let found = sample_within(&plan, feeder, asked, |point| varied.distance(point))
        .map_err(|error| Failure::Usage(format!("{}: {error}", scene.name())))?;
    // What decides needs drops of its own: their progress is another line, so this one ends here.
    let mut seconds = progress.seconds();
    drop(progress);
    let mut drops = found.drops as usize;
    let deciders = match too_few(&found) {
        Some(why) => Err(why),
        None => {
            let few = plan.rounded() * REPETITIONS as u64 / OF_SAMPLES;
            let more = few as usize * (plan.dimensions + 2);
            let progress = Progress::new("drops for what decides", Some(more));
            let good = |point: &[f64]| {
                progress.step();
                let dropped = Dropped::of(varied.feeder(point).as_ref(), plan.plate, &options);
                dropped.run.as_ref().is_some_and(|run| wanted.met(run))
            };
            let deciders = sensitivity(&plan, few, good).map_err(|why| why.to_string());
            drops += progress.count();
            seconds += progress.seconds();
            deciders
        }
    };
    let laws = laws(scene.feeder(), plan.plate);
    Ok(Studied { scene, varied, plan, wanted, limits, found, deciders, laws, drops, seconds })
}

/// Why nothing can be said on what decides, where too few samples end the rarer way.
fn too_few(found: &Yield) -> Option<String> {
    let rarer = found.wanted.count.min(found.drops - found.wanted.count);
    if rarer == 0 {
        let which = if found.wanted.count == 0 { "none of the samples ends" } else { "all samples end" };
        return Some(format!("{which} as wanted"));
    }
    if rarer >= LEAST_RARE {
        return None;
    }
    let (way, verb) = match rarer {
        _ if rarer != found.wanted.count => ("otherwise", if rarer == 1 { "ends" } else { "end" }),
        1 => ("as wanted", "ends"),
        _ => ("as wanted", "end"),
    };
    let enough = found.drops.saturating_mul(LEAST_RARE).div_ceil(rarer);
    let enough = enough.checked_next_power_of_two().filter(|enough| *enough <= MOST_SAMPLES);
    let hint = enough.map_or(String::new(), |enough| format!("; take about --samples {enough}"));
    Some(format!("only {rarer} of {} samples {verb} {way}, {LEAST_RARE} must{hint}", found.drops))
}

/// How a feeder's drop ends under every law, with every restitution.
fn laws(feeder: &Feeder, plate: usize) -> Vec<(Law, f64, Ending)> {
    let mut found = vec![];
    for law in [Law::Poisson, Law::Stronge, Law::Newton] {
        for restitution in RESTITUTIONS {
            let mut feeder = Feeder { law, ..feeder.clone() };
            feeder.plates.iter_mut().for_each(|plate| plate.restitution = restitution);
            feeder.walls.iter_mut().for_each(|wall| wall.restitution = restitution);
            found.push((law, restitution, Dropped::of(Some(&feeder), plate, &Options::default()).ending));
        }
    }
    found
}

/// The file that a drop is saved in.
fn file_of(worst: &Worst) -> String {
    let ending = study::ending(worst.ending).replace(' ', "_");
    format!("worst-{}.toml", if worst.hardest { HARDEST } else { &ending })
}

/// True of a name that a drop of any study is saved under: what else is in the folder is the user's.
fn is_of_a_drop(name: &str) -> bool {
    let which = name.strip_prefix("worst-").and_then(|name| name.strip_suffix(".toml"));
    which.is_some_and(|which| which == HARDEST || study::ending_of(&which.replace('_', " ")).is_some())
}

/// Writes everything and says what came out; returns where the page is.
fn deliver(studied: &Studied<'_>, output: &Output, out: &mut impl Write) -> Result<PathBuf, Failure> {
    let folder = output.folder(studied.scene.name());
    let mut written = vec![];
    files::bring_outline(studied.scene, &folder)?;
    for worst in &studied.found.worst {
        // What cannot be drawn cannot be saved as a scene that can be run.
        let Ok(text) = studied.varied.text(&worst.point) else { continue };
        let head = report::head_of(studied, worst);
        written.push(files::write(&folder, &file_of(worst), &format!("{head}{text}"))?);
    }
    let summary = format!("{}\n", serde_json::to_string_pretty(&report::summary(studied))?);
    written.push(files::write(&folder, "yield.json", &summary)?);
    let page = files::write(&folder, "yield.html", &page::page(studied, &folder))?;
    written.push(page.clone());
    files::remove_known(&folder, |name| is_of_a_drop(name) && !written.contains(&folder.join(name)))?;
    match output.format {
        Format::Text => out.write_all(report::text(studied, &written).as_bytes())?,
        Format::Json => out.write_all(summary.as_bytes())?,
    }
    Ok(page)
}
