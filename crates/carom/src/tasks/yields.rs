//! How surely a drop of a scene ends as wanted: the study of `carom yield`.

mod located;
mod page;
mod report;

pub use located::{LINES, LocatedYield};

use super::wants;
use carom_feeder::Outcome;
use carom_impact::Law;
use carom_scene::{Drawn, Scene, Varied};
use carom_study::design::Limits;
use carom_study::yields::{
    Contrasts, NoIndices, Plan, Points, Portion, REPETITIONS, Sensitivity, Worst, Yield, YieldError,
};
use carom_study::{Device, Dropped, Ending};
use carom_words::part::Names;
use carom_words::{part, study};

/// Samples of a Sobol index, for so many samples of the yield.
const OF_SAMPLES: u64 = 8;
/// Samples of the yield that must end the rarer way for Sobol's indices to be more than noise: 30 of those of an index.
const LEAST_RARE: u64 = 30 * OF_SAMPLES;
/// Most samples that may be asked for.
const MOST_SAMPLES: u64 = 1 << 34;
/// No answer was found: nobody wants that.
const UNRESOLVED: Ending = Ending::Otherwise(Outcome::Unresolved);
/// Restitutions under which the laws are compared.
pub const RESTITUTIONS: [f64; 7] = [0.0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9];

/// Stands for the ending in the name of the file with the hardest strike.
const HARDEST: &str = "hardest";

/// A yield study and what it is of.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks::yields::YieldStudy};
/// use carom::study::yields::Points;
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let varied = scene.varied()?;
/// let plan = YieldStudy::plan(&varied, 512, 1, Points::Sobol, 1);
/// let mut studied = YieldStudy::sampled(&varied, plan, || {}).unwrap();
/// studied.decide(|| {});
/// assert!(studied.found.drops >= 512 && studied.page("out").contains("how surely"));
/// # Ok::<(), carom::Error>(())
/// ```
pub struct YieldStudy<'s, S: Drawn = Scene> {
    /// The scene.
    pub scene: &'s S,
    /// With its tolerances.
    pub varied: &'s Varied<'s, S>,
    /// How it was sampled.
    pub plan: Plan,
    /// What is wanted of the plate where the scene says nothing: as the drop of the middle of all tolerances ends.
    pub middle: Ending,
    /// What a layout must keep besides, where the scene says so of a drop.
    pub limits: Option<Limits>,
    /// What came out.
    pub found: Yield,
    /// The quantities by how much they decide, in the order of the scene, or why that is not known.
    pub deciders: Result<Vec<Sensitivity>, String>,
    /// How the drop of the middle ends under every law, with every one of [`RESTITUTIONS`].
    pub laws: Vec<(Law, f64, Ending)>,
    /// Drops in all.
    pub drops: usize,
}

impl<'s, S: Drawn> YieldStudy<'s, S> {
    /// So many samples at least, from this seed; endings are told apart on this plate.
    pub fn plan(varied: &Varied<'_, S>, samples: u64, seed: u64, points: Points, plate: usize) -> Plan {
        Plan {
            dimensions: varied.dimensions(),
            samples: samples.div_ceil(REPETITIONS as u64),
            seed,
            points,
            plates: varied.scene().feeder().plate_count(),
            plate,
        }
    }

    /// Drops as planned; `step` is called after each.
    ///
    /// # Errors
    /// A plan that cannot be followed.
    pub fn sampled(
        varied: &'s Varied<'s, S>,
        plan: Plan,
        step: impl Fn() + Sync,
    ) -> Result<Self, YieldError> {
        Self::of(varied, vec![Self::portion(varied, &plan, (0, 1), step)?])
    }

    /// One portion of the drops that are planned, `number` of `of` from 0, for a machine of its own; `step` is called after each drop.
    ///
    /// # Errors
    /// A plan that cannot be followed, a portion that there is not.
    pub fn portion(
        varied: &Varied<'_, S>,
        plan: &Plan,
        number_of: (u32, u32),
        step: impl Fn() + Sync,
    ) -> Result<Portion, YieldError> {
        let scene = varied.scene();
        let middle = middle(scene, plan);
        let met = |run: &RunOf<S>| met(scene, plan.plate, middle, run);
        let limits = scene.limits();
        let keeps = |run: &RunOf<S>| limits.is_none_or(|limits| limits.keeps(run));
        let feeder = |point: &[f64]| {
            step();
            varied.feeder(point)
        };
        Portion::sampled(plan, number_of, feeder, (met, keeps), |point| varied.distance(point))
    }

    /// What all portions of the drops say together.
    ///
    /// # Errors
    /// Portions of different studies, one twice, or not all of them.
    pub fn of(varied: &'s Varied<'s, S>, portions: Vec<Portion>) -> Result<Self, YieldError> {
        let scene = varied.scene();
        let plan = *portions.first().ok_or(YieldError::Portions)?.plan();
        if plan.dimensions != varied.dimensions() || plan.plates != scene.feeder().plate_count() {
            return Err(YieldError::Portions);
        }
        let found = Yield::of(portions)?;
        let deciders = Err(undecided(&plan, &found).unwrap_or_else(|| "it was not asked".to_owned()));
        let (laws, drops) = (laws(scene.feeder(), plan.plate), found.drops as usize);
        let (middle, limits) = (middle(scene, &plan), scene.limits());
        Ok(Self { scene, varied, plan, middle, limits, found, deciders, laws, drops })
    }

    /// How many more drops it takes to say what decides; none where that cannot be said.
    pub fn to_decide(&self) -> Option<usize> {
        let drops = Contrasts::drops(&self.plan, of_an_index(&self.plan));
        undecided(&self.plan, &self.found).is_none().then_some(drops as usize)
    }

    /// Finds which quantity decides; `step` is called after each drop.
    pub fn decide(&mut self, step: impl Fn() + Sync) {
        if self.to_decide().is_some() {
            self.decided(Self::contrasts(self.varied, &self.plan, (0, 1), step).map(|all| vec![all]));
        }
    }

    /// One portion of the drops that say which quantity decides, `number` of `of` from 0; `step` is called after each drop.
    ///
    /// # Errors
    /// More quantities than can be told apart, a portion that there is not.
    pub fn contrasts(
        varied: &Varied<'_, S>,
        plan: &Plan,
        number_of: (u32, u32),
        step: impl Fn() + Sync,
    ) -> Result<Contrasts, NoIndices> {
        let scene = varied.scene();
        let middle = middle(scene, plan);
        let good = |point: &[f64]| {
            step();
            let dropped = Dropped::through(varied.feeder(point).as_ref(), plan.plate);
            dropped.run.as_ref().is_some_and(|run| met(scene, plan.plate, middle, run))
        };
        Contrasts::counted(plan, of_an_index(plan), number_of, good)
    }

    /// Takes what all portions say of which quantity decides.
    pub fn decided(&mut self, portions: Result<Vec<Contrasts>, NoIndices>) {
        if portions.is_ok() {
            self.drops += Contrasts::drops(&self.plan, of_an_index(&self.plan)) as usize;
        }
        self.deciders = portions.and_then(Sensitivity::of).map_err(|why| why.to_string());
    }

    /// What is wanted, in words.
    pub fn wanted(&self) -> String {
        wanted(self.scene, self.plan.plate, self.middle)
    }

    /// The plate on which endings are told apart.
    pub fn plate_label(&self) -> String {
        part::obstacle(self.scene.feeder(), self.plan.plate)
    }

    /// The quantities by their paths, the one that decides most first.
    ///
    /// # Errors
    /// Why that is not known.
    pub fn ranked(&self) -> Result<Vec<(String, Sensitivity)>, &str> {
        let paths = self.varied.paths();
        let mut ranked: Vec<(String, Sensitivity)> =
            paths.into_iter().zip(self.deciders.as_ref().map_err(String::as_str)?.iter().copied()).collect();
        ranked.sort_by(|a, b| b.1.total.total_cmp(&a.1.total));
        Ok(ranked)
    }

    /// Drops to look at, each as a scene with the name of its file; what cannot be drawn cannot be saved as a scene that can be run.
    pub fn worst_scenes(&self) -> Vec<(String, String)> {
        let saved = self.found.worst.iter().filter_map(|worst| {
            let text = self.varied.text(&worst.point).ok()?;
            Some((file_of(worst), format!("{}{text}", self.head_of(worst))))
        });
        saved.collect()
    }

    /// Why a drop is one to look at.
    fn why(&self, worst: &Worst) -> String {
        let drops = self.found.drops;
        match worst.among {
            _ if worst.hardest => {
                format!("the hardest first strike of {drops} drops on plates that the part comes to lie on")
            }
            1 => format!("the only one of {drops} drops that ends so"),
            like => format!("of the {like} of {drops} drops that end so, the most probable"),
        }
    }

    /// What stands above a scene that is saved.
    fn head_of(&self, worst: &Worst) -> String {
        let (name, ending) = (self.scene.name(), study::ending(worst.ending));
        format!("# {name}: {ending}, {}; seed {}.\n", self.why(worst), self.plan.seed)
    }
}

/// What a drop of a scene's feeder says.
type RunOf<S> = <<S as Drawn>::Feeder as Device>::Run;

/// How the drop of the middle of all tolerances ends.
fn middle<S: Drawn>(scene: &S, plan: &Plan) -> Ending {
    Dropped::through(Some(scene.feeder()), plan.plate).ending
}

/// What is wanted, in words.
fn wanted<S: Drawn>(scene: &S, plate: usize, middle: Ending) -> String {
    wants(scene.feeder(), scene.wants()).unwrap_or_else(|| {
        let (ending, plate) = (study::ending(middle), part::obstacle(scene.feeder(), plate));
        if middle == UNRESOLVED {
            return format!("nothing is wanted, as the drop where nothing varies ends {ending}; `want` of a plate says what is");
        }
        format!("{ending} on \"{plate}\", as it ends where nothing varies")
    })
}

/// Whether a drop ends as the scene wants, or else as the middle of all tolerances does, if that has an answer.
fn met<S: Drawn>(scene: &S, plate: usize, middle: Ending, run: &RunOf<S>) -> bool {
    let as_in_the_middle = || middle != UNRESOLVED && Ending::of(run, plate) == middle;
    scene.ends_as_wanted(run).unwrap_or_else(as_in_the_middle)
}

/// Samples of a Sobol index.
fn of_an_index(plan: &Plan) -> u64 {
    plan.rounded() * REPETITIONS as u64 / OF_SAMPLES
}

/// Why nothing can be said on what decides, where that is so.
fn undecided(plan: &Plan, found: &Yield) -> Option<String> {
    too_few(found).or_else(|| Contrasts::check(plan).err().map(|why| why.to_string()))
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
fn laws<D: Device>(feeder: &D, plate: usize) -> Vec<(Law, f64, Ending)> {
    let mut found = vec![];
    for law in D::LAWS {
        for restitution in RESTITUTIONS {
            let feeder = feeder.with_law(*law, restitution);
            found.push((*law, restitution, Dropped::through(Some(&feeder), plate).ending));
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
///
/// # Example
/// ```
/// use carom::tasks::yields::is_of_a_drop;
/// assert!(is_of_a_drop("worst-same_side.toml") && !is_of_a_drop("worst-of-all.toml"));
/// ```
pub fn is_of_a_drop(name: &str) -> bool {
    let which = name.strip_prefix("worst-").and_then(|name| name.strip_suffix(".toml"));
    which.is_some_and(|which| which == HARDEST || study::ending_of(&which.replace('_', " ")).is_some())
}
