//! The names of what happened: neighbouring pieces with one name on one plate are one stage.

use super::drop::Prepared;
use super::run::Run;
use crate::clatter::{Happened, Strike, fold, moment};
use crate::run::{Stage, StageEnd, StageName, Touch as On};
use crate::stages::join;
use carom_motion::spatial::{Mode, Piece, PieceEnd, State, Supports, Touch};

/// The stages of a run: what takes no time is none, and many strikes in a row are one.
pub(super) fn stages(prepared: &Prepared<'_>, run: &Run) -> Vec<Stage<State, Touch>> {
    let stages = by_name(prepared, run);
    let size = prepared.world.body().reach();
    fold(stages, &happened(run), moment(size, prepared.feeder.gravity))
}

/// What folding looks at.
fn happened(run: &Run) -> Happened<State> {
    let pieces = &run.samples.pieces;
    let strike = |(time, owner): (f64, &usize)| {
        let before =
            pieces.iter().rev().find(|piece| piece.end_time <= time).map_or(run.end, |piece| piece.end);
        let after = pieces.iter().find(|piece| piece.start_time >= time).map_or(run.end, |piece| piece.start);
        Strike { time, obstacle: Some(*owner), before, after }
    };
    Happened {
        strikes: run.impacts.iter().map(|impact| impact.time).zip(&run.struck).map(strike).collect(),
        pieces: pieces.iter().map(|piece| [piece.start_time, piece.end_time]).collect(),
        series: series(run),
    }
}

/// Series that were closed at their limits: a limit may be the last beat of a series of limits, which goes on to its own, from the same last strike.
fn series(run: &Run) -> Vec<(f64, f64)> {
    let mut found: Vec<(f64, f64)> = vec![];
    for closing in &run.closings {
        match found.last_mut() {
            Some((last, limit)) if [*last, *limit].contains(&closing.time) => *limit = closing.limit,
            _ => found.push((closing.time, closing.limit)),
        }
    }
    found
}

fn by_name(prepared: &Prepared<'_>, run: &Run) -> Vec<Stage<State, Touch>> {
    // What takes no time is none: what is before it goes on after it.
    let lasting = |(_, piece): &(usize, &Piece)| piece.end_time > piece.start_time;
    let stage = |(i, piece): (usize, &Piece)| {
        let (name, obstacle) = name_of(prepared, piece);
        Stage {
            name,
            obstacle,
            start_time: piece.start_time,
            end_time: piece.end_time,
            start: piece.start,
            end: piece.end,
            ended_by: end_of(prepared, piece),
            pieces: i..i + 1,
        }
    };
    let struck = |time: f64| run.impacts.iter().any(|impact| impact.time == time);
    join(run.samples.pieces.iter().enumerate().filter(lasting).map(stage), struck)
}

fn name_of(prepared: &Prepared<'_>, piece: &Piece) -> (StageName, Option<usize>) {
    let held = piece.mode.held(&prepared.world);
    let Some(first) = held.iter().next() else { return (StageName::Flight, None) };
    let obstacle = Some(prepared.owner(first));
    if held.iter().any(|i| Some(prepared.owner(i)) != obstacle) {
        return (StageName::Wedge, obstacle);
    }
    let over_end = held.iter().any(|i| !matches!(prepared.world.touch(i), Some(Touch::Point { .. })));
    let name = match piece.mode {
        Mode::Flight => StageName::Flight,
        Mode::Rest { .. } => StageName::Rest,
        _ if prepared.are_wide(held, &piece.start) => StageName::Slide,
        _ if over_end => StageName::Tip,
        Mode::Slides { slipping, .. } if !slipping.is_empty() => StageName::Swing,
        _ => StageName::Stick,
    };
    (name, obstacle)
}

fn end_of(prepared: &Prepared<'_>, piece: &Piece) -> StageEnd<Touch> {
    let held = piece.mode.held(&prepared.world);
    let on = |support: usize| On { obstacle: prepared.owner(support), feature: prepared.touch(support) };
    let first = |supports: Supports| supports.iter().next().map(on);
    let of_held = |end: fn(On<Touch>) -> StageEnd<Touch>| first(held).map_or(StageEnd::Rests, end);
    match piece.ended_by {
        PieceEnd::Touches { support } => {
            let own = held.iter().any(|i| prepared.owner(i) == prepared.owner(support));
            if own { StageEnd::LiesDown(on(support)) } else { StageEnd::Touches(on(support)) }
        }
        PieceEnd::LiftsOff { support } => StageEnd::LiftsOff(on(support)),
        PieceEnd::RunsOff { support } => StageEnd::RunsOff(on(support)),
        PieceEnd::FrictionGivesWay => of_held(StageEnd::FrictionGivesWay),
        PieceEnd::SlipStops => of_held(StageEnd::SlipStops),
        PieceEnd::Jams => of_held(StageEnd::Painleve),
        PieceEnd::Flattens => of_held(StageEnd::LiesDown),
        PieceEnd::Overturns => of_held(StageEnd::RunsOff),
        PieceEnd::FliesAway => StageEnd::FliesAway,
        PieceEnd::BudgetSpent => StageEnd::TimeUp,
    }
}
