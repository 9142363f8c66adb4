//! A run in space as the player of bodies in space shows it: the world turned so that z is up, the plates near the way of the part.

use crate::solid::{SolidDrawing, SolidFigure, SolidInstant, SolidPlate, SolidStage, SolidStrike};
use crate::space_plates::near;
use crate::space_rows::space_tilt;
use carom_feeder::StageEnd;
use carom_feeder::spatial::{Feeder, Plate, Prepared, Run, Shown};
use carom_motion::spatial::{Impact, Mode, Options, State, Supports, Touch};
use carom_num::{Rotation, Vec2, Vec3};
use carom_words::{Words, part};
use std::f64::consts::FRAC_PI_2;

/// Reaches of the part that it is shown falling below the last place where it comes near a plate.
const FALLS: f64 = 6.0;
/// Instants of which the way is made that plates are cut to.
const WAY: usize = 400;

/// What the player shows of a run.
pub(crate) struct SpaceScene {
    corners: Vec<Vec3>,
    faces: Vec<Vec<usize>>,
    numbers: Vec<usize>,
    seams: Vec<[usize; 2]>,
    names: Vec<String>,
    around: Vec<SolidPlate>,
    pub(crate) instants: Vec<SolidInstant>,
    stages: Vec<SolidStage>,
    strikes: Vec<SolidStrike>,
    /// Plates and walls that are too far from the way to be shown.
    pub(crate) far: Vec<String>,
    /// From when on the part falls past everything, and is not shown any more [s].
    pub(crate) ends: Option<f64>,
}

impl SpaceScene {
    pub(crate) fn new(feeder: &Feeder, run: &Run) -> Self {
        let prepared = feeder.prepare(Options::default()).ok();
        let corners = feeder.part.body.supports();
        let mut own = instants(feeder, run, prepared.as_ref());
        let ends = falls_from(feeder, run);
        own.retain(|at| ends.is_none_or(|end| at.time <= end));
        let last = own.last().map_or(run.end_time, |at| at.time);
        let every = own.len().div_ceil(WAY).max(1);
        let few = own.iter().enumerate().filter(|(i, _)| i % every == 0 || i + 1 == own.len());
        let way = few.flat_map(|(_, at)| corners.iter().map(|corner| at.centre + at.attitude.apply(*corner)));
        let (around, far) = near(feeder, way);
        let stages = run.stages.iter().map(|stage| SolidStage {
            name: stage.name.word(),
            on: stage.obstacle.map(|on| part::obstacle(feeder, on)).unwrap_or_default(),
            start: stage.start_time,
            end: stage.end_time.min(last),
        });
        let Shown { corners: shown, faces, numbers, seams } = feeder.part.shown();
        Self {
            corners: shown,
            faces,
            numbers,
            seams,
            names: (0..corners.len()).map(|corner| corner.to_string()).collect(),
            around: around.into_iter().map(upright_plate).collect(),
            instants: own.into_iter().map(upright_instant).collect(),
            stages: stages.collect(),
            strikes: run.impacts.iter().map(|impact| strike(run, prepared.as_ref(), impact)).collect(),
            far,
            ends,
        }
    }

    /// The same as a figure of a body in space.
    pub(crate) fn figure<'a>(&'a self, feeder: &'a Feeder) -> SolidFigure<'a> {
        let (corners, faces, points) = (&self.corners, &self.faces, feeder.part.body.supports());
        let numbers = Some(&self.numbers[..]);
        let (seams, names) = (&self.seams[..], &self.names[..]);
        let drawing = SolidDrawing { corners, faces, numbers, seams, lines: &[], points, names };
        SolidFigure {
            title: "",
            verdict: "",
            lead: "",
            notes: &[],
            drawing,
            around: &self.around,
            instants: &self.instants,
            stages: &self.stages,
            strikes: &self.strikes,
            series: &[],
            source: "",
            made_by: "",
        }
    }
}

/// The part at every sample, axes of the drawing; as it ends where nothing moved.
fn instants(feeder: &Feeder, run: &Run, prepared: Option<&Prepared<'_>>) -> Vec<SolidInstant> {
    let of = |time: f64, held: Supports, state: &State| {
        let (held, places) = touching(prepared, held, state);
        let tilt = space_tilt(feeder, state);
        SolidInstant { time, centre: state.centre, attitude: state.attitude, tilt, held, places }
    };
    let held = |mode: &Mode| prepared.map_or(Supports::NONE, |prepared| mode.held(prepared.world()));
    let samples = &run.samples.instants;
    if samples.is_empty() {
        return vec![of(run.end_time, Supports::NONE, &run.end)];
    }
    samples.iter().map(|(time, mode, state)| of(*time, held(mode), state)).collect()
}

/// When a part that falls past everything is so far below the plates that there is nothing more to see; `None` where that is not so.
fn falls_from(feeder: &Feeder, run: &Run) -> Option<f64> {
    let last = run.stages.last().filter(|stage| stage.ended_by == StageEnd::FliesAway)?;
    let fall: Vec<(f64, Vec3)> = run
        .samples
        .instants
        .iter()
        .filter(|(time, _, _)| *time >= last.start_time)
        .map(|(time, _, state)| (*time, state.centre))
        .collect();
    // It is past a plate where it has come nearest to it.
    let nearest = |plate: &Plate| {
        let from = |(_, centre): &&(f64, Vec3)| distance(*centre, [plate.uphill, plate.edge]);
        fall.iter().min_by(|a, b| from(a).total_cmp(&from(b))).map(|(time, _)| *time)
    };
    let past = feeder.plates.iter().filter_map(nearest).fold(last.start_time, f64::max);
    let height = fall.iter().find(|(time, _)| *time >= past)?.1.y;
    let deep = height - FALLS * feeder.part.body.reach();
    fall.iter().find(|(_, centre)| centre.y < deep).map(|(time, _)| *time).filter(|end| *end < run.end_time)
}

/// How far a place of the drawing is from a line of it.
fn distance(place: Vec3, [from, to]: [Vec2; 2]) -> f64 {
    let (place, along) = (Vec2::new(place.x, place.y), to - from);
    let share = ((place - from).dot(along) / along.dot(along)).clamp(0.0, 1.0);
    (from + along * share - place).norm()
}

/// The corners of the part among supports that touch, and where the others touch, in its own axes.
fn touching(prepared: Option<&Prepared<'_>>, supports: Supports, state: &State) -> (Vec<usize>, Vec<Vec3>) {
    let Some(world) = prepared.map(Prepared::world) else { return (vec![], vec![]) };
    let (mut corners, mut places) = (vec![], vec![]);
    for support in supports.iter() {
        match world.touch(support) {
            // A rounded one touches beside the middle of its ball.
            Some(Touch::Point { point, .. }) if !world.body().is_round() => corners.push(point),
            _ => places.extend(world.touches_at(support, state)),
        }
    }
    corners.sort_unstable();
    corners.dedup();
    (corners, places)
}

fn strike(run: &Run, prepared: Option<&Prepared<'_>>, impact: &Impact) -> SolidStrike {
    let before = run.samples.pieces.iter().rev().find(|piece| piece.end_time <= impact.time);
    let after =
        || run.samples.pieces.iter().find(|piece| piece.start_time >= impact.time).map(|piece| piece.start);
    let state = before.map(|piece| piece.end).or_else(after);
    let (corners, places) =
        state.map_or((vec![], vec![]), |state| touching(prepared, impact.striking, &state));
    let place = |arm: &Vec3| state.map_or(*arm, |state| upright(state.centre + state.attitude.apply(*arm)));
    SolidStrike {
        time: impact.time,
        struck: corners.iter().map(usize::to_string).collect::<Vec<_>>().join(", "),
        places: places.iter().map(place).collect(),
        ..SolidStrike::default()
    }
}

/// From the drawing's axes, y up, to the player's, z up.
fn upright(place: Vec3) -> Vec3 {
    Vec3::new(place.x, -place.z, place.y)
}

fn upright_plate(plate: SolidPlate) -> SolidPlate {
    SolidPlate { corners: plate.corners.into_iter().map(upright).collect(), ..plate }
}

fn upright_instant(instant: SolidInstant) -> SolidInstant {
    let attitude = Rotation::by(Vec3::X * FRAC_PI_2).after(instant.attitude);
    SolidInstant { centre: upright(instant.centre), attitude, ..instant }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_up_in_the_drawing_is_up_in_the_player() {
        let feeder = carom_feeder::spatial::examples::two_plates();
        let run = feeder.run().unwrap();
        let scene = SpaceScene::new(&feeder, &run);
        let (first, last) = (&scene.instants[0], &scene.instants[scene.instants.len() - 1]);
        assert!(first.centre.z > 0.0 && last.centre.z < -0.1, "it falls along z");
        let corner = feeder.part.body.supports()[0];
        let state = run.samples.instants[0].2;
        let there = upright(state.place(corner));
        let shown = first.centre + first.attitude.apply(corner);
        assert!((there - shown).norm() < 1e-15, "attitude and place are turned alike: {there:?} {shown:?}");
    }
}
