//! Which friction, which restitution agrees with drops that were observed: the study of `carom fit`.

mod over;
mod report;
mod runs;

use super::StudyError;
use super::axes::{self, Asker, Complaints, quantity};
use carom_motion::planar::Options;
use carom_scene::unit::Dimension;
use carom_scene::{Fitted, Problem, ProblemKind, Problems, Scene};
use carom_study::Dropped;
use carom_study::fits::{self, Fit, FitError, Plan, Simulated};
use over::Over;
use runs::Runs;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What is asked of a fit.
///
/// # Example
/// ```
/// use carom::tasks::fits::FitAsked;
/// assert_eq!(FitAsked::default().level, 0.95);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FitAsked<'a> {
    /// Quantities and their ranges, `contact.friction=0..1`; every friction and restitution that the scene writes where there are none.
    pub over: &'a [String],
    /// Probability that an interval holds.
    pub level: f64,
    /// Standard deviation of times that have no scatter of their own, `5 ms`; it is fitted where none is given.
    pub scatter: Option<&'a str>,
    /// Drops at each node, where something varies from drop to drop.
    pub samples: u64,
    /// Most nodes that the engine is asked at.
    pub nodes: u32,
    /// What every random number comes from.
    pub seed: u64,
    /// The plate to look at, by name or number from 0; the last where none is named.
    pub plate: Option<&'a str>,
    /// Who asks.
    pub asker: Asker,
}

impl Default for FitAsked<'_> {
    fn default() -> Self {
        Self {
            over: &[],
            level: 0.95,
            scatter: None,
            samples: 256,
            nodes: 10_000,
            seed: 1,
            plate: None,
            asker: Asker::Call,
        }
    }
}

/// A fit and what it is of.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks::fits::{FitAsked, FitStudy}};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let over = ["contact.friction=0..0.17".to_owned()];
/// let asked = FitAsked { over: &over, ..FitAsked::default() };
/// let rows = "outcome\nturned\nturned\n";
/// let study = FitStudy::fitted(&scene, ("seen.csv", rows), &asked, || {}).unwrap();
/// assert!(study.fit.parameters[0].low > 0.02, "with less friction it does not turn");
/// # Ok::<(), carom::Error>(())
/// ```
pub struct FitStudy<'s> {
    /// The scene.
    pub scene: &'s Scene,
    /// How it was fitted.
    pub plan: Plan,
    /// The plate on which drops were observed.
    pub plate: usize,
    /// What came out.
    pub fit: Fit,
    /// Drops of the engine in all.
    pub drops: usize,
    fitted: Fitted<'s>,
    over: Vec<Over>,
    runs: Runs,
    asker: Asker,
}

impl<'s> FitStudy<'s> {
    /// Fits a scene to the rows of a CSV file, its name and its text; `step` is called after each drop.
    ///
    /// # Errors
    /// Everything that is wrong with what is asked and with the rows; rows that no value gives.
    pub fn fitted(
        scene: &'s Scene,
        (file, text): (&str, &str),
        asked: &FitAsked<'_>,
        step: impl Fn() + Sync,
    ) -> Result<Self, StudyError> {
        let mut complaints = Complaints::of(asked.asker);
        let plate = axes::plate(scene, asked.plate, &mut complaints);
        let scatter = scatter(asked.scatter, &mut complaints);
        if !(asked.level > 0.0 && asked.level < 1.0) {
            complaints.push("level", format!("{} is not between 0 and 1", asked.level));
        }
        let over = over::read(scene, asked.over, &mut complaints);
        let runs = runs::read(scene, (file, text), (scatter, asked.asker), &over);
        // What is wrong with what is asked and with the rows is told together.
        let runs = match (complaints.finish(), runs) {
            (Ok(()), Ok(runs)) => runs,
            (Ok(()), Err(problems)) | (Err(problems), Ok(_)) => return Err(problems.into()),
            (Err(asked), Err(rows)) => return Err(StudyError::Input(vec![asked, rows])),
        };
        let parameters: Vec<&str> = over.iter().map(|over| over.path.as_str()).collect();
        let columns: Vec<&str> = runs.columns.iter().map(String::as_str).collect();
        let fitted = scene.fitted(&parameters, &columns)?;
        let plan = Plan {
            ranges: over.iter().map(|over| over.range).collect(),
            conditions: runs.conditions.len(),
            dimensions: fitted.dimensions(),
            samples: asked.samples,
            seed: asked.seed,
            nodes: asked.nodes as usize,
            level: asked.level,
        };
        let drops = AtomicUsize::new(0);
        let simulate = |parameters: &[f64], condition: usize, point: &[f64]| {
            drops.fetch_add(1, Ordering::Relaxed);
            step();
            let columns = runs.conditions.get(condition).map_or(&[][..], Vec::as_slice);
            let feeder = fitted.feeder(parameters, columns, point);
            Simulated::of(&Dropped::of(feeder.as_ref(), plate, &Options::default()), plate)
        };
        let fit = fits::fit(&plan, &runs.observations, simulate)
            .map_err(|error| failed(&over, &runs, &error, asked.asker))?;
        let drops = drops.into_inner();
        Ok(Self { scene, plan, plate, fit, drops, fitted, over, runs, asker: asked.asker })
    }
}

/// The scatter of times that have none of their own [s].
fn scatter(text: Option<&str>, complaints: &mut Complaints) -> Option<f64> {
    let text = text?;
    match quantity(text, Dimension::Time) {
        Ok(value) if value > 0.0 => return Some(value),
        Ok(_) => complaints.push("scatter", format!("\"{text}\" must be above 0")),
        Err(message) => complaints.push("scatter", format!("\"{text}\": {message}")),
    }
    None
}

/// What is wrong with the runs where no value agrees with them, row by row.
fn failed(over: &[Over], runs: &Runs, error: &FitError, asker: Asker) -> StudyError {
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
        FitError::Untimely { observations, spans } => return untimely(runs, observations, spans, asker),
        FitError::Lost { nodes } => {
            return StudyError::Undone(format!(
                "the budget of {nodes} nodes ended before it was found where the runs agree best, so there are no intervals: take more {}, or a narrower range ({}) of {}",
                asker.option("nodes"),
                asker.option("over"),
                ranges.join(", ")
            ));
        }
        other => return StudyError::Asked(other.to_string()),
    };
    let [plate, over] = ["plate", "over"].map(|option| asker.option(option));
    let help = format!(
        "is it the right plate ({plate}), is the range wide enough ({over}), and does what varies from drop to drop have a tolerance in the scene?"
    );
    let problem = |observation: &usize| {
        let place = runs.places.get(*observation).cloned();
        Problem::new(ProblemKind::Conflict, "", message.clone(), place).with_help(help.clone())
    };
    let problems = observations.iter().map(problem).collect();
    StudyError::from(Problems::new(&runs.file, &runs.source, problems))
}

/// The rows whose times no drop of the engine takes.
fn untimely(runs: &Runs, observations: &[usize], spans: &[[f64; 2]], asker: Asker) -> StudyError {
    let scatter = asker.option("scatter");
    let problem = |(observation, span): (&usize, &[f64; 2])| {
        let [low, high] = span.map(|time| Dimension::Time.show_digits(time, 4));
        let message = format!("no drop of the engine that ends so takes so long: they take {low} to {high}");
        let help = format!(
            "is the time counted from the start of the slide to the first lying flat on the plate, and is the scatter ({scatter}) right?"
        );
        Problem::new(ProblemKind::Conflict, "", message, runs.places.get(*observation).cloned())
            .with_help(help)
    };
    let problems = observations.iter().zip(spans).map(problem).collect();
    StudyError::from(Problems::new(&runs.file, &runs.source, problems))
}
