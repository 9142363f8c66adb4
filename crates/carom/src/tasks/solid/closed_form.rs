//! What a closed form says of a strike, beside the engine's numbers.

mod pyramid;
mod stool;

use crate::tasks::tolerance::CLOSED_FORM_AGREES;
use carom_num::Vec3;
use carom_scene::{ClosedFormReport, SpatialRollKind, SpatialRollProblem, SpatialStrike};

/// `None` where no closed form covers the strike.
pub(super) fn of(problem: &SpatialRollProblem, strike: &SpatialStrike) -> Option<ClosedFormReport> {
    if problem.world.friction().is_some() {
        // Forms are those of the non-sliding law.
        return None;
    }
    match problem.kind {
        SpatialRollKind::Pyramid => pyramid::of(problem, strike),
        SpatialRollKind::Stool => stool::of(problem, strike),
        SpatialRollKind::Body => None,
    }
}

/// What a form predicts.
struct Predicted {
    case: String,
    words: String,
    /// Points that stay.
    kept: Vec<usize>,
    /// Spin after, body axes.
    spin: Vec3,
    /// Normal impulses at points, where the form gives them.
    normal: Vec<(usize, f64)>,
}

impl Predicted {
    /// Beside what the engine says.
    fn beside(self, problem: &SpatialRollProblem, strike: &SpatialStrike) -> ClosedFormReport {
        let impact = &strike.impact;
        let apart = (impact.spin_after - self.spin).norm() / impact.spin_before.norm();
        let ours = |point: usize| impact.impulses.iter().find(|(i, _)| *i == point).map_or(0.0, |(_, p)| p.z);
        let largest = self.normal.iter().map(|(_, p)| p.abs()).fold(0.0, f64::max);
        let differences = self.normal.iter().map(|(i, p)| (ours(*i) - p).abs() / largest);
        let impulse_difference = differences.reduce(f64::max).filter(|x| x.is_finite());
        let same = self.kept.iter().copied().collect::<carom_motion::spatial::Supports>() == impact.kept;
        let names = self.kept.iter().filter_map(|i| problem.points.get(*i).cloned());
        ClosedFormReport {
            case: self.case,
            words: self.words,
            kept: names.collect(),
            spin_difference: apart,
            impulse_difference,
            agrees: same
                && apart < CLOSED_FORM_AGREES
                && impulse_difference.is_none_or(|x| x < CLOSED_FORM_AGREES),
        }
    }
}
