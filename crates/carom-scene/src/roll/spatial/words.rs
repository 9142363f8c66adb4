//! Points, states and motions in words.

use super::{SpatialRollProblem, SpatialRollRun};
use carom_motion::spatial::{Budget, Clock, End, Mode, Supports};

/// The name of a point.
pub(super) fn point_name(problem: &SpatialRollProblem, point: usize) -> &str {
    problem.points.get(point).map_or("?", String::as_str)
}

pub(super) fn names(problem: &SpatialRollProblem, points: Supports) -> Vec<String> {
    points.iter().map(|i| point_name(problem, i).to_owned()).collect()
}

/// "O, A and K"; "none" where there is none.
pub(super) fn points_in_words(problem: &SpatialRollProblem, points: Supports) -> String {
    match &names(problem, points)[..] {
        [] => "none".to_owned(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// "O and K keep, A opens"; of those that stay, some may slide.
pub(super) fn kept_words(
    problem: &SpatialRollProblem,
    [kept, sliding]: [Supports; 2],
    touching: Supports,
) -> String {
    let opened = touching.difference(kept);
    let of = |points: Supports, one: &str, more: &str| {
        let verb = if points.len() == 1 { one } else { more };
        (!points.is_empty()).then(|| format!("{} {verb}", points_in_words(problem, points)))
    };
    let parts = [
        of(kept.difference(sliding), "keeps", "keep"),
        of(sliding, "slides", "slide"),
        of(opened, "opens", "open"),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// What the body does, in a word, and on which points.
pub(super) fn mode_words(mode: &Mode) -> &'static str {
    match mode {
        Mode::Flight => "flight",
        Mode::Pivot { .. } => "pivot",
        Mode::Edge { .. } => "edge",
        Mode::Rest { .. } => "rest",
        Mode::Slides { .. } => "slide",
    }
}

/// The name of the end of a run, and a sentence that says what it means.
pub(super) fn end_words(problem: &SpatialRollProblem, run: &SpatialRollRun) -> (&'static str, String) {
    let slid = run.pieces.last().is_some_and(|piece| matches!(piece.mode, Mode::Slides { .. }));
    let rough = problem.world.friction().is_some();
    match run.end {
        None => ("strikes reached", "it still moves after as many strikes as were followed".to_owned()),
        Some(End::AtRest { held }) => {
            let how = if slid { "slid to rest" } else { "rests" };
            ("at rest", format!("it {how} on {}", points_in_words(problem, held)))
        }
        Some(End::NoConsistentOutcome(clock)) if rough => (
            "no consistent outcome",
            match clock {
                Clock::Impact => "no way through the strike was found: its contacts jam, or hand the load to each other without end".to_owned(),
                Clock::Motion => "friction lets it neither rest nor slide on, and no impact without approach does".to_owned(),
            },
        ),
        Some(End::Balanced { held }) => (
            "balanced",
            format!(
                "it stands still on {}, in an equilibrium that does not last",
                points_in_words(problem, held)
            ),
        ),
        Some(End::Overturned) => {
            ("overturned", "its mass centre has passed over what it stands on: it falls over".to_owned())
        }
        Some(End::NoConsistentOutcome(clock)) => (
            "no consistent outcome",
            match clock {
                Clock::Impact => {
                    "every state of the strike is refused: without sliding there is no way on".to_owned()
                }
                Clock::Motion => {
                    "no set of held points is consistent with the forces: without sliding there is no way on"
                        .to_owned()
                }
            },
        ),
        Some(End::Several(clock)) => (
            "several ways on",
            match clock {
                Clock::Impact => {
                    "the law allows several motions after the strike, and none was to be chosen".to_owned()
                }
                Clock::Motion => {
                    "the law allows several ways to move on, and none was to be chosen".to_owned()
                }
            },
        ),
        Some(End::BudgetSpent(budget)) => (
            "budget spent",
            match budget {
                Budget::Time => "it still moves at the end of the time it was followed".to_owned(),
                Budget::Steps => "it still moves after as many steps as are made".to_owned(),
                Budget::Impacts => "it still moves after as many strikes as are followed".to_owned(),
            },
        ),
        Some(End::Stopped) => ("strikes reached", "it still moves".to_owned()),
    }
}
