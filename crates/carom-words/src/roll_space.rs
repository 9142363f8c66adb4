//! What bodies in space do that roll, rock and rest: their points, their modes, their ends.

use crate::{list, named};
use carom_motion::spatial::{Budget, Clock, End, Mode, Supports};

/// The names of some points.
pub fn points<T: AsRef<str>>(names: &[T], points: Supports) -> Vec<String> {
    points.iter().map(|i| named(names, i).to_owned()).collect()
}

/// "O and K keep, A opens"; of those that stay, some may slide.
pub fn kept<T: AsRef<str>>(names: &[T], [kept, sliding]: [Supports; 2], touching: Supports) -> String {
    let of = |these: Supports, one: &str, more: &str| {
        let verb = if these.len() == 1 { one } else { more };
        (!these.is_empty()).then(|| format!("{} {verb}", list(&points(names, these), "none")))
    };
    let parts = [
        of(kept.difference(sliding), "keeps", "keep"),
        of(sliding, "slides", "slide"),
        of(touching.difference(kept), "opens", "open"),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// What is said of a strike whose motion hangs on how its contacts share what they carry.
pub const SHARED: &str = "with friction the motion depends on how the contacts share the load, which rigid bodies leave open: one way is followed, others are as consistent";

/// What a body does between two events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StageName {
    /// It touches nothing.
    Flight,
    /// It turns about one point.
    Pivot,
    /// It turns about two.
    Edge,
    /// It rests.
    Rest,
    /// Points of it slide.
    Slide,
    /// It rolls on balls or circles, and nothing slides.
    Roll,
}

/// What a point does after a strike.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointState {
    /// It stays where it is.
    Keeps,
    /// It stays on the plane and slips.
    Slides,
    /// It leaves the plane.
    Opens,
}

/// How a run ends, without the points that it ends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndName {
    /// It rests.
    AtRest,
    /// It stands still in an equilibrium that does not last.
    Balanced,
    /// A circle of it lies flat, and what follows is not known.
    Flat,
    /// It falls over.
    Overturned,
    /// It was followed through as many strikes as were asked for.
    StrikesReached,
    /// The law has no way on.
    NoConsistentOutcome,
    /// The law has several ways on, and none was to be chosen.
    SeveralWaysOn,
    /// It flies, and nothing can carry it any more.
    FliesAway,
    /// A budget of time, steps or strikes ran out.
    BudgetSpent,
}

crate::words! {
    StageName {
        Flight = "flight",
        Pivot = "pivot",
        Edge = "edge",
        Rest = "rest",
        Slide = "slide",
        Roll = "roll",
    }
    PointState {
        Keeps = "keeps",
        Slides = "slides",
        Opens = "opens",
    }
    EndName {
        AtRest = "at rest",
        Balanced = "balanced",
        Flat = "flat",
        Overturned = "overturned",
        StrikesReached = "strikes reached",
        NoConsistentOutcome = "no consistent outcome",
        SeveralWaysOn = "several ways on",
        FliesAway = "flies away",
        BudgetSpent = "budget spent",
    }
}

/// What a body does in a mode.
pub fn mode(mode: &Mode) -> StageName {
    match mode {
        Mode::Flight => StageName::Flight,
        Mode::Pivot { .. } => StageName::Pivot,
        Mode::Edge { .. } => StageName::Edge,
        Mode::Rest { .. } => StageName::Rest,
        Mode::Slides { slipping, .. } if slipping.is_empty() => StageName::Roll,
        Mode::Slides { .. } => StageName::Slide,
    }
}

/// The name of an end; `None` is a run that was followed through as many strikes as were asked for.
pub fn end_name(end: Option<End>) -> EndName {
    match end {
        None | Some(End::Stopped) => EndName::StrikesReached,
        Some(End::AtRest { .. }) => EndName::AtRest,
        Some(End::Balanced { .. }) => EndName::Balanced,
        Some(End::Flat { .. }) => EndName::Flat,
        Some(End::Overturned) => EndName::Overturned,
        Some(End::FliesAway) => EndName::FliesAway,
        Some(End::NoConsistentOutcome(_)) => EndName::NoConsistentOutcome,
        Some(End::Several(_)) => EndName::SeveralWaysOn,
        Some(End::BudgetSpent(_)) => EndName::BudgetSpent,
    }
}

/// What the end of a run means, in a sentence. `rough` where there is friction, `slid` where the body slid last.
pub fn end<T: AsRef<str>>(names: &[T], end: Option<End>, [rough, slid]: [bool; 2]) -> String {
    let on = |held: Supports| list(&points(names, held), "none");
    let sentence = match end {
        None => "it still moves after as many strikes as were followed",
        Some(End::AtRest { held }) => {
            return format!("it {} on {}", if slid { "slid to rest" } else { "rests" }, on(held));
        }
        Some(End::Balanced { held }) => {
            return format!("it stands still on {}, in an equilibrium that a touch ends", on(held));
        }
        Some(End::Flat { .. }) => "a circle of it lies flat: what its whole rim does is not followed",
        Some(End::Overturned) => "its mass centre has passed over what it stands on: it falls over",
        Some(End::FliesAway) => "it falls, and nothing can carry it any more",
        Some(End::NoConsistentOutcome(clock)) => match (clock, rough) {
            (Clock::Impact, true) => {
                "no way through the strike was found: its contacts jam, or hand the load to each other without end"
            }
            (Clock::Motion, true) => {
                "friction lets it neither rest nor slide on, and no impact without approach does"
            }
            (Clock::Impact, false) => {
                "every state of the strike is refused: without sliding there is no way on"
            }
            (Clock::Motion, false) => {
                "no set of held points is consistent with the forces: without sliding there is no way on"
            }
        },
        Some(End::Several(Clock::Impact)) => {
            "the law allows several motions after the strike, and none was to be chosen"
        }
        Some(End::Several(Clock::Motion)) => {
            "the law allows several ways to move on, and none was to be chosen"
        }
        Some(End::BudgetSpent(Budget::Time)) => "it still moves at the end of the time it was followed",
        Some(End::BudgetSpent(Budget::Steps)) => "it still moves after as many steps as are made",
        Some(End::BudgetSpent(Budget::Impacts)) => "it still moves after as many strikes as are followed",
        Some(End::Stopped) => "it still moves",
    };
    sentence.to_owned()
}
