//! What a yield study says to a program.

use super::{YieldStudy, file_of};
use carom_feeder::Verdict;
use carom_scene::{
    Drawn, EndingReport, EndingWord, FaceShareReport, LawReport, RecirculationReport, SensitivityReport,
    StudyRunReport, TransitionReport, Word, WorstReport, YieldPlateReport, YieldReport,
};
use carom_study::Ending;
use carom_study::yields::{Estimate, Recirculation, Sensitivity, Transition, Worst};
use carom_words::part::Names;

fn transition(studied: &YieldStudy<'_, impl Drawn>, found: &Transition) -> TransitionReport {
    let face = |ending| match ending {
        Ending::Lies(Verdict::Face(face)) => Some(face),
        _ => None,
    };
    let Estimate { share, low, high, count } = found.share;
    TransitionReport {
        plate: studied.scene.feeder().given(found.plate).to_owned(),
        from: face(found.from),
        to: face(found.to),
        ending: EndingWord(found.to),
        share,
        low,
        high,
        drops: count,
    }
}

fn looped(found: &Recirculation) -> RecirculationReport {
    let start = |(face, share): &(usize, Estimate)| FaceShareReport { face: *face, share: (*share).into() };
    RecirculationReport {
        starts: found.starts.iter().map(start).collect(),
        probability: found.wanted.into(),
        passes: found.passes,
    }
}

impl<S: Drawn> YieldStudy<'_, S> {
    /// Everything that was found, for a program; `run` says what it took.
    pub fn summary(&self, run: StudyRunReport) -> YieldReport {
        let studied = self;
        let found = &studied.found;
        let feeder = studied.scene.feeder();
        let plates = found.plates.iter().enumerate().map(|(plate, spread)| YieldPlateReport {
            plate: feeder.given(plate).to_owned(),
            impact_speed_m_s: spread.impact_speed.as_ref().map(Into::into),
            sliding_speed_m_s: spread.sliding_speed.as_ref().map(Into::into),
            flat_s: spread.flat.as_ref().map(Into::into),
        });
        let ending = |(ending, estimate): &(Ending, Estimate)| EndingReport {
            ending: EndingWord(*ending),
            probability: (*estimate).into(),
        };
        let worst = |worst: &Worst| WorstReport {
            file: file_of(worst),
            ending: EndingWord(worst.ending),
            why: if worst.hardest { "hardest" } else { "nearest" },
            impact_speed_m_s: worst.impact_speed,
        };
        let decider = |(quantity, s): (String, Sensitivity)| SensitivityReport {
            quantity,
            first: s.first,
            first_error: s.first_error,
            total: s.total,
            total_error: s.total_error,
        };
        let saved = |worst: &&Worst| studied.varied.text(&worst.point).is_ok();
        YieldReport {
            scene: studied.scene.name().to_owned(),
            approximations: studied.scene.approximations().to_vec(),
            notes: studied.scene.notes().to_vec(),
            plate: studied.scene.feeder().given(studied.plan.plate).to_owned(),
            wanted: studied.wanted(),
            probability: found.wanted.into(),
            yield_within_limits: studied.limits.map(|_| found.kept.into()),
            endings: found.endings.iter().map(ending).collect(),
            transitions: found.transitions.iter().map(|found| transition(studied, found)).collect(),
            recirculation: found.recirculation.as_ref().map(looped),
            plates: plates.collect(),
            time_s: found.time.as_ref().map(Into::into),
            parts_per_minute: found.time.as_ref().map(|time| 60.0 / time.mean),
            sensitivity: studied.ranked().ok().map(|ranked| ranked.into_iter().map(decider).collect()),
            laws: studied
                .laws
                .iter()
                .map(|(law, restitution, ending)| LawReport {
                    law: Word(*law),
                    restitution: *restitution,
                    ending: EndingWord(*ending),
                })
                .collect(),
            worst: found.worst.iter().filter(saved).map(worst).collect(),
            samples: found.drops,
            seed: studied.plan.seed,
            run,
        }
    }
}
