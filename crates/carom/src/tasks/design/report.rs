//! What a search says to a program, and the files of its winner.

use super::said::{at_range_ends, wall_strikes_by_name, worst};
use super::{DesignStudy, Designed, Winner};
use carom_scene::{
    DeliveredReport, DesignLayoutReport, DesignReport, EndingWord, ForbiddenReport, StudyRunReport, Word,
};
use carom_study::design::Judged;
use carom_study::yields::Estimate;
use carom_study::{Ending, Landed};
use carom_words::part::Names;

/// How the part comes to lie on every plate but the one it starts on.
fn endings<S: Designed>(winner: &Winner<S>) -> Vec<DeliveredReport> {
    let feeder = winner.scene.feeder();
    let ending = |i| EndingWord(Ending::of(&winner.run, i));
    let on = |i| DeliveredReport { plate: feeder.given(i).to_owned(), ending: ending(i) };
    (1..feeder.plate_count()).map(on).collect()
}

fn layout(
    designed: &DesignStudy<'_, impl Designed>,
    values: &[f64],
    judged: &Judged,
    [yields, doubled]: [Estimate; 2],
) -> DesignLayoutReport {
    let paths = designed.space.quantities().map(|quantity| quantity.path.clone());
    DesignLayoutReport {
        chosen: paths.zip(values.iter().copied()).collect(),
        probability: yields.into(),
        yield_doubled: doubled.into(),
        impact_speed_m_s: judged.impact_speed,
        sliding_speed_m_s: judged.sliding_speed,
        height_m: judged.height,
        width_m: judged.width,
        time_s: judged.time,
    }
}

impl<S: Designed> DesignStudy<'_, S> {
    /// Everything that was found, for a program; `run` says what it took.
    pub fn summary(&self, run: StudyRunReport) -> DesignReport {
        let designed = self;
        let found = &designed.found;
        let winner = designed.winner.as_ref();
        DesignReport {
            scene: designed.scene.name().to_owned(),
            approximations: designed.scene.approximations().to_vec(),
            outcome: if winner.is_some() { "found" } else { "not possible" },
            aim: Word(designed.aim),
            winner: winner.map(|w| layout(designed, &w.values, &w.judged, [w.yields, w.doubled])),
            worst: winner.map(|winner| worst(designed, winner)),
            at_range_ends: winner.map(|winner| at_range_ends(designed, winner)).unwrap_or_default(),
            wall_strikes: winner.map(wall_strikes_by_name).unwrap_or_default(),
            delivered: winner.map(Winner::delivered).unwrap_or_default(),
            endings: winner.map(endings).unwrap_or_default(),
            exit: winner.and_then(|winner| S::leaving(&winner.to_the_end)).map(|leaving| leaving.report),
            ends: winner.map(|winner| Word(winner.to_the_end.outcome())),
            front: found
                .front
                .iter()
                .map(|d| layout(designed, &designed.space.values(&d.point), &d.judged, [d.yields, d.doubled]))
                .collect(),
            forbidden: found
                .forbidden
                .iter()
                .map(|f| ForbiddenReport {
                    demand: Word(f.demand),
                    failed: f.failed,
                    alone: f.alone,
                    nearest: f.nearest,
                    limit: designed.limits.of(f.demand),
                })
                .collect(),
            scanned: found.scanned,
            met: found.met,
            seed: designed.seed,
            run,
        }
    }

    /// The files of the winner with their names: the scene, its drawings and the report of its run; none where there is no winner.
    pub fn files(&self) -> Vec<(&'static str, String)> {
        let Some(winner) = &self.winner else { return vec![] };
        let mut files = vec![("design.toml", winner.text.clone())];
        files.extend(winner.scene.shown(&winner.run, self.said()));
        files
    }
}
