//! A layout that is looked for.

use crate::answer::named;
use crate::reply::{Candidate, DesignFound, Failure, Reply};
use crate::watch::Watch;
use carom::study::design::{Design, Looked};
use carom::tasks::StudyError;
use carom::tasks::design::{DesignPlan, DesignStudy, design_space};
use carom_figure::{Draft, live_small, live_view};
use carom_scene::{DesignSpace, Scene, labelled};
use carom_words::number::fixed;
use carom_words::run as run_words;
use carom_words::study::percent_with_interval;
use serde::Serialize;

/// Of a small picture [px].
const SMALL: [f64; 2] = [280.0, 200.0];

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        match error {
            // The page gives one file at a time.
            StudyError::Input(problems) => match problems.into_iter().next() {
                Some(problems) => problems.into(),
                None => Self::of_page("the scene has problems"),
            },
            StudyError::Asked(message) | StudyError::Undone(message) => Self::of_page(&message),
        }
    }
}

/// How far a search is, with the best layout so far.
#[derive(Serialize)]
struct News {
    look: u32,
    looks: u32,
    best: Option<Candidate>,
}

/// Which layout makes drops end as wanted.
pub(crate) fn found(scene: &Scene, plan: DesignPlan, watch: &dyn Watch) -> Result<Reply, Failure> {
    let space = design_space(scene)?;
    let looked = |looked: &Looked<'_>| {
        let best = looked.best.and_then(|design| candidate_of(scene, &space, design));
        let news = News { look: looked.look, looks: looked.looks, best };
        watch.told(&serde_json::to_string(&news).unwrap_or_default());
    };
    let study = DesignStudy::searched(scene, &space, plan, || watch.step(), looked)?;
    let winner = study.winner.as_ref();
    let mut candidates = vec![];
    if let Some(winner) = winner {
        let measured = [winner.yields, winner.doubled].map(|estimate| percent_with_interval(&estimate));
        candidates.extend(candidate(
            scene,
            (winner.text.clone(), &winner.scene),
            measures(measured, winner.judged.height, winner.judged.impact_speed),
            chosen(&space, &winner.values),
        ));
    }
    candidates.extend(study.found.front.iter().filter_map(|design| candidate_of(scene, &space, design)));
    let verdict = match winner {
        None => {
            // The page says above it that it is not possible.
            let why = study.impossible();
            why.split_once("NOT POSSIBLE: ").map_or(why.trim_end(), |(_, why)| why.trim_end()).to_owned()
        }
        Some(winner) => format!(
            "{} end as wanted, within the limits; {} with every tolerance doubled",
            percent_with_interval(&winner.yields),
            percent_with_interval(&winner.doubled)
        ),
    };
    let mut said =
        winner.map(|winner| vec![winner.delivered().join(", "), winner.afterwards()]).unwrap_or_default();
    said.extend(study.said());
    said.push(format!(
        "{} of {} layouts of the first look meet every demand where nothing varies",
        study.found.met, study.found.scanned
    ));
    let found = DesignFound {
        verdict,
        possible: winner.is_some(),
        said,
        candidates,
        forbidden: study.forbidden_rows(),
        files: named(study.files()),
    };
    Ok(Reply { found: Some(Box::new(found)), ..Reply::default() })
}

/// A layout of the search; `None` where it cannot be drawn.
fn candidate_of(scene: &Scene, space: &DesignSpace<'_>, design: &Design) -> Option<Candidate> {
    let values = space.values(&design.point);
    let own = space.scene_with(&values).ok()?;
    let text = space.text(&values).ok()?;
    let measured = [design.yields, design.doubled].map(|estimate| percent_with_interval(&estimate));
    let measures = measures(measured, design.judged.height, design.judged.impact_speed);
    candidate(scene, (text, &own), measures, chosen(space, &values))
}

fn measures([yields, doubled]: [String; 2], height: f64, speed: f64) -> Vec<[String; 2]> {
    let row = |name: &str, value: String| [name.to_owned(), value];
    vec![
        row("as wanted", yields),
        row("tolerances doubled", doubled),
        row("height", format!("{} m", fixed(height, 4))),
        row("strikes at most", format!("{} m/s", fixed(speed, 3))),
    ]
}

fn chosen(space: &DesignSpace<'_>, values: &[f64]) -> Vec<[String; 2]> {
    let shown = space.quantities().zip(values);
    shown
        .map(|(quantity, value)| {
            [labelled(&quantity.path).into_owned(), quantity.kind.dimension.show_digits(*value, 4)]
        })
        .collect()
}

fn candidate(
    scene: &Scene,
    (text, own): (String, &Scene),
    mut rows: Vec<[String; 2]>,
    chosen: Vec<[String; 2]>,
) -> Option<Candidate> {
    let feeder = own.feeder();
    let run = feeder.run().ok()?;
    let view = live_view(feeder, Some(&run), SMALL);
    let draft = Draft { outline: scene.outline(), ..Draft::default() };
    let picture = live_small(feeder, &run, &draft, &view);
    let headline = run_words::headline(feeder, &run);
    let on = headline.plate.map(|plate| format!(" on {plate}")).unwrap_or_default();
    rows.extend(chosen);
    Some(Candidate { text, words: format!("{}{on}", headline.word), picture, size: SMALL, rows })
}
