//! The names of what happened: neighbouring pieces of the trace with one name on one obstacle are one stage.

use crate::clatter::{Happened, Strike, fold, moment};
use crate::feeder::Feeder;
use crate::run::{Stage, StageEnd, StageName, Touch};
use carom_impact::planar::Slip;
use carom_motion::planar::trace::{HeldContact, Impact, Piece, PieceEnd, Trace};
use carom_motion::planar::{Feature, Obstacle, State};

/// The stages of a trace: what takes no time is none, and many strikes in a row are one.
pub(crate) fn stages(feeder: &Feeder, obstacles: &[Obstacle], trace: &Trace) -> Vec<Stage> {
    let mut stages = by_name(feeder, obstacles, trace);
    stages.retain(|stage| stage.end_time > stage.start_time || stage.name == StageName::Rest);
    fold(stages, &happened(trace), moment(feeder.part.body.shape.size(), feeder.gravity))
}

/// What folding looks at.
fn happened(trace: &Trace) -> Happened<State> {
    let strike = |impact: &Impact| Strike {
        time: impact.time,
        obstacle: impact.contacts.first().map(|contact| contact.obstacle),
        before: State { pose: impact.pose, twist: impact.before },
        after: State { pose: impact.pose, twist: impact.after },
    };
    Happened {
        strikes: trace.impacts.iter().map(strike).collect(),
        pieces: trace.pieces.iter().map(|piece| [piece.start_time, piece.end_time]).collect(),
        series: trace.accumulations.clone(),
    }
}

fn by_name(feeder: &Feeder, obstacles: &[Obstacle], trace: &Trace) -> Vec<Stage> {
    let stage = |(i, piece): (usize, &Piece)| {
        let (name, obstacle) = name_of(feeder, obstacles, piece);
        Stage {
            name,
            obstacle,
            start_time: piece.start_time,
            end_time: piece.end_time,
            start: piece.start,
            end: piece.end,
            ended_by: end_of(name, piece),
            pieces: i..i + 1,
        }
    };
    let struck = |time: f64| trace.impacts.iter().any(|impact| impact.time == time);
    join(trace.pieces.iter().enumerate().map(stage), struck)
}

/// Neighbours with one name on one obstacle are one stage, unless a strike at the time between them parts them.
pub(crate) fn join<S, F>(
    stages: impl Iterator<Item = Stage<S, F>>,
    struck: impl Fn(f64) -> bool,
) -> Vec<Stage<S, F>> {
    let mut out: Vec<Stage<S, F>> = vec![];
    for stage in stages {
        match out.last_mut() {
            Some(last)
                if last.name == stage.name
                    && last.obstacle == stage.obstacle
                    && !struck(stage.start_time) =>
            {
                (last.end_time, last.end, last.ended_by) = (stage.end_time, stage.end, stage.ended_by);
                last.pieces.end = stage.pieces.end;
            }
            _ => out.push(stage),
        }
    }
    out
}

fn name_of(feeder: &Feeder, obstacles: &[Obstacle], piece: &Piece) -> (StageName, Option<usize>) {
    let Some(first) = piece.held.first() else { return (StageName::Flight, None) };
    let obstacle = Some(first.obstacle);
    if matches!(piece.ended_by, PieceEnd::Rests) {
        return (StageName::Rest, obstacle);
    }
    let fixed = feeder.plates.len() + feeder.walls.len();
    if piece.held.iter().any(|h| h.obstacle >= fixed) {
        let carrier = piece.held.iter().map(|h| h.obstacle).find(|o| *o < fixed);
        return (StageName::Push, carrier);
    }
    if piece.held.iter().any(|h| h.obstacle != first.obstacle) {
        return (StageName::Wedge, obstacle);
    }
    let sticks = piece.held.iter().all(|h| h.slip == Slip::Sticks);
    let shape = &feeder.part.body.shape;
    let rolls = |vertex: usize| shape.radius_of(vertex) > 0.0;
    // Within a bend, and on one that only a disc rolls over, the part moves as on a plate; over an edge it tips.
    let bends = |end: usize| {
        let met = obstacles.get(first.obstacle).map(Obstacle::shape);
        met.is_some_and(|met| met.is_hollow(end) || shape.faces() == 0 && met.radius_of(end) > 0.0)
    };
    let on_vertex = match first.feature {
        Feature::VertexOnFace { vertex, .. } => Some(vertex),
        Feature::VertexOnEnd { vertex, end } => Some(vertex).filter(|_| bends(end)),
        Feature::FaceOnEnd { .. } => None,
    };
    let name = match (piece.held.len(), on_vertex) {
        (2.., _) if sticks => StageName::Rest,
        (2.., _) => StageName::Slide,
        (_, None) => StageName::Tip,
        (_, Some(vertex)) if sticks && rolls(vertex) => StageName::Roll,
        (_, Some(_)) if sticks => StageName::Stick,
        (_, Some(_)) if shape.faces() == 0 => StageName::Slide,
        (_, Some(_)) => StageName::Swing,
    };
    (name, obstacle)
}

/// True where a face lies over an edge of what it touches, and another contact holds it as well.
fn over_edge(piece: &Piece) -> bool {
    piece.held.len() > 1 && piece.held.iter().any(|h| matches!(h.feature, Feature::FaceOnEnd { .. }))
}

fn end_of(name: StageName, piece: &Piece) -> StageEnd {
    let on = |held: HeldContact| Touch { obstacle: held.obstacle, feature: held.feature };
    match piece.ended_by {
        PieceEnd::Closes { feature, obstacle } => {
            let touch = Touch { obstacle, feature };
            let own = piece.held.iter().any(|h| h.obstacle == obstacle);
            if own { StageEnd::LiesDown(touch) } else { StageEnd::Touches(touch) }
        }
        PieceEnd::ForceZero(h) if name == StageName::Slide && over_edge(piece) => {
            StageEnd::CentreAtEdge(on(h))
        }
        PieceEnd::ForceZero(h) => StageEnd::LiftsOff(on(h)),
        PieceEnd::SlipZero(h) => StageEnd::SlipStops(on(h)),
        PieceEnd::StickLimit(h) => StageEnd::FrictionGivesWay(on(h)),
        PieceEnd::RunsOff(h) => StageEnd::RunsOff(on(h)),
        PieceEnd::PainleveEdge(h) => StageEnd::Painleve(on(h)),
        PieceEnd::Rests => StageEnd::Rests,
        PieceEnd::FliesAway => StageEnd::FliesAway,
        PieceEnd::Swings => StageEnd::Swings,
        PieceEnd::Elsewhere => StageEnd::OtherPart,
        PieceEnd::TimeUp => StageEnd::TimeUp,
    }
}
