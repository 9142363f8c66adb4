//! From what happens to a verdict.

use super::drop::Prepared;
use super::part::Face;
use super::run::{Exit, Run};
use super::stages::stages;
use crate::drop::RunError;
use crate::feeder::Stop;
use crate::run::{Effort, Jam, JamKind, Landing, Outcome, Touch, Verdict};
use crate::seen::{Seen, with_speeds};
use crate::tolerance::{FLAT_FACE, ON_FACE};
use carom_impact::spatial::Conclusion;
use carom_motion::MotionError;
use carom_motion::spatial::{
    Closing, End, Impact, Mode, Observer, Piece, Run as Motion, Samples, State, Supports, Touch as Feature,
    run as run_motion,
};
use carom_num::Vec3;
use std::ops::ControlFlow;

/// Looks on, notes what a verdict needs, and ends the run where it is known.
pub(super) struct Watcher<'p, 'f> {
    prepared: &'p Prepared<'f>,
    traced: bool,
    plates: Vec<Seen>,
    walls: Vec<bool>,
    landings: Vec<Landing>,
    /// The last flight that started where the last plate had been touched.
    left: Option<Exit>,
    /// It has touched nothing for a while.
    has_flown: bool,
    /// The state before the next impact.
    now: State,
    struck_at: Vec<f64>,
    struck: Vec<usize>,
    held: Supports,
    /// The last series of impacts that was closed: when, and its limit [s].
    closed: Option<[f64; 2]>,
    samples: Samples,
}

impl<'p, 'f> Watcher<'p, 'f> {
    pub(super) fn new(prepared: &'p Prepared<'f>, traced: bool) -> Self {
        let mut plates = vec![Seen::default(); prepared.feeder.plates.len()];
        plates[0].touched(0.0);
        Self {
            prepared,
            traced,
            plates,
            walls: vec![false; prepared.feeder.walls.len()],
            landings: vec![],
            left: None,
            has_flown: false,
            now: prepared.start,
            struck_at: vec![],
            struck: vec![],
            held: Supports::NONE,
            closed: None,
            samples: Samples::default(),
        }
    }

    /// Follows the part to its end.
    pub(super) fn follow(mut self) -> Result<Run, RunError> {
        let Prepared { world, start, options, .. } = self.prepared;
        let run = match run_motion(world, start, options, &mut self) {
            Ok(run) => run,
            Err(MotionError::TooManyTouching { time, .. }) => return Ok(self.given_up(time)),
            Err(error) => return Err(error.into()),
        };
        let outcome = self.outcome(&run.end, run.time, &run.state);
        Ok(self.finish(outcome, run))
    }

    /// More contacts than can be resolved: all that is known is the way until then.
    fn given_up(self, time: f64) -> Run {
        let until = Motion {
            end: End::Stopped,
            time,
            state: self.now,
            impacts: vec![],
            closings: vec![],
            drift: 0.0,
            friction_work: 0.0,
            effort: Default::default(),
        };
        self.finish(Outcome::Unresolved, until)
    }

    fn finish(self, outcome: Outcome, motion: Motion) -> Run {
        let jam = (outcome == Outcome::Jammed).then(|| self.jam());
        let mut run = Run {
            outcome,
            end_time: motion.time,
            end: motion.state,
            landings: with_speeds(self.landings, &self.plates),
            walls_touched: (0..self.walls.len()).filter(|wall| self.walls[*wall]).collect(),
            exit: self.left.filter(|_| outcome == Outcome::Delivered),
            jam,
            forks: motion.impacts.iter().filter(|i| i.conclusion == Conclusion::Several).count() as u64,
            effort: Effort {
                rhs_evaluations: motion.effort.evaluations,
                steps: motion.effort.steps,
                event_evaluations: motion.effort.event_evaluations,
                rate_problems: motion.effort.questions,
                events: self.samples.pieces.len() as u64,
                impacts: motion.effort.impacts,
            },
            stages: vec![],
            impacts: motion.impacts,
            struck_at: self.struck_at,
            struck: self.struck,
            closings: motion.closings,
            samples: self.samples,
        };
        if self.traced {
            run.stages = stages(self.prepared, &run);
        } else {
            run.samples = Samples::default();
        }
        run
    }

    fn jam(&self) -> Jam<Feature> {
        let touch = |support| Touch { obstacle: self.owner(support), feature: self.prepared.touch(support) };
        let mut owners: Vec<usize> = self.held.iter().map(|support| self.owner(support)).collect();
        owners.dedup();
        let kind = if owners.len() > 1 { JamKind::Wedged } else { JamKind::Unresolved };
        Jam { kind, contacts: self.held.iter().map(touch).collect() }
    }

    fn last(&self) -> usize {
        self.prepared.feeder.plates.len() - 1
    }

    /// How a run ended.
    fn outcome(&mut self, end: &End, time: f64, state: &State) -> Outcome {
        match *end {
            End::Stopped => Outcome::Landed,
            End::AtRest { held } | End::Balanced { held } => {
                self.note(time, held, state);
                self.resting(held)
            }
            End::FliesAway if self.left.is_some() && self.prepared.feeder.stop == Stop::Delivered => {
                Outcome::Delivered
            }
            End::FliesAway if self.plates[self.last()].first_touch.is_some() => Outcome::Escaped,
            End::FliesAway => Outcome::Missed,
            End::Flat { .. } => Outcome::Unresolved,
            End::NoConsistentOutcome(_) | End::Several(_) => Outcome::Jammed,
            End::Overturned | End::BudgetSpent(_) => Outcome::NeverFlat,
        }
    }

    fn resting(&self, held: Supports) -> Outcome {
        let plates = 0..self.prepared.feeder.plates.len();
        let flat = plates.rev().find(|plate| self.face_on(*plate, held, &self.now).is_some());
        let mut owners: Vec<usize> = held.iter().map(|i| self.owner(i)).collect();
        owners.dedup();
        match flat {
            Some(plate) if plate == self.last() && self.prepared.feeder.stop == Stop::Landed && plate > 0 => {
                Outcome::Landed
            }
            Some(_) => Outcome::Stuck,
            None if owners.len() > 1 => Outcome::Jammed,
            None => Outcome::Stuck,
        }
    }

    fn owner(&self, support: usize) -> usize {
        self.prepared.owner(support)
    }

    /// Notes what is touched, and where the part lies flat for the first time.
    fn note(&mut self, time: f64, held: Supports, state: &State) {
        (self.now, self.held) = (*state, held);
        for support in held.iter() {
            let owner = self.owner(support);
            let slip = self.slip(support, state);
            let plates = self.plates.len();
            match self.plates.get_mut(owner) {
                Some(seen) => {
                    seen.touched(time);
                    seen.slid(slip);
                }
                None => self.walls[owner - plates] = true,
            }
        }
        for plate in 0..self.plates.len() {
            let known = self.landings.iter().any(|landing| landing.plate == plate);
            // The first plate carries the part from the start: it has to be left before the part can land there.
            let is_start = plate == 0 && !self.has_flown;
            if known || is_start {
                continue;
            }
            let Some(face) = self.face_on(plate, held, state) else { continue };
            let landing = self.landing(plate, face, time);
            self.landings.push(landing);
        }
    }

    /// What comes to rest at the end of a series of impacts does so at its limit [s].
    fn limit_at(&self, time: f64) -> f64 {
        self.closed.filter(|[last, _]| *last == time).map_or(time, |[_, limit]| limit)
    }

    /// The speed along the surface with which a support slips [m/s].
    fn slip(&self, support: usize, state: &State) -> f64 {
        let world = &self.prepared.world;
        let Some(arm) = world.touches_at(support, state) else { return 0.0 };
        let (velocity, normal) = (state.velocity_of(arm), world.normal_at(support, state));
        (velocity - normal * normal.dot(velocity)).norm()
    }

    fn landing(&self, plate: usize, face: usize, time: f64) -> Landing {
        let before = self.landings.iter().rev().find(|landing| landing.plate != plate);
        let start = self.prepared.feeder.start.face;
        let face_before = before.map_or(Some(start), |landing| landing.face);
        let opposite = self.prepared.feeder.part.opposite(start);
        let verdict = match face {
            _ if face == start => Verdict::Same,
            _ if Some(face) == opposite => Verdict::Turned,
            _ => Verdict::Face(face),
        };
        Landing {
            plate,
            verdict: Some(verdict),
            turned_here: Some(Some(face) != face_before),
            face: Some(face),
            first_touch: self.plates[plate].first_touch.unwrap_or(time),
            flat: Some(self.limit_at(time)),
            impact_speed: 0.0,
            max_impact_speed: 0.0,
            max_sliding_speed: 0.0,
        }
    }

    /// The face of the part that lies on a plate, in a groove on the flank behind before the other one: three contacts that are not on one line hold it there, and it is parallel to the plate.
    fn face_on(&self, plate: usize, held: Supports, state: &State) -> Option<usize> {
        let Prepared { world, feeder, owners, .. } = self.prepared;
        // What carries is the first of a plate's obstacles, one sheet or two flanks: its side walls follow.
        let first = owners.iter().position(|owner| *owner == plate)?;
        let carriers = if feeder.plates[plate].cross_section.is_groove() { 2 } else { 1 };
        let face_on = |sheet: usize| {
            let own = held.those(|support| world.obstacle_of(support) == sheet);
            if !self.prepared.are_wide(own, state) {
                return None;
            }
            let first = own.iter().next()?;
            let (up, place) = (world.normal_at(first, state), world.touches_at(first, state)?);
            let down = -state.attitude.undo(up);
            let turned = |face: &Face| (face.normal - down).norm() <= FLAT_FACE;
            // In a hollow it may hang on what is parallel to a face.
            let near = ON_FACE * world.body().reach();
            let is_on = |face: &Face| (down.dot(place) - face.depth).abs() <= near;
            feeder.part.faces.iter().position(|face| turned(face) && is_on(face))
        };
        (first..first + carriers).find_map(face_on)
    }

    /// The mass centre of a part that has touched the last plate moves downhill beyond its free edge, between its sides.
    fn is_over_edge(&self, state: &State) -> bool {
        let (last, reach) = (self.last(), self.prepared.world.body().reach());
        let plate = &self.prepared.feeder.plates[last];
        let Some(axes) = plate.axes().filter(|_| self.plates[last].first_touch.is_some()) else {
            return false;
        };
        let from_edge = state.centre - Vec3::new(plate.edge.x, plate.edge.y, 0.0);
        let beside = axes.across.dot(from_edge).abs();
        let between = plate.width.is_none_or(|width| beside <= 0.5 * width + reach);
        between && axes.downhill.dot(from_edge) > -reach && axes.downhill.dot(state.velocity) > 0.0
    }

    fn has_landed(&self) -> bool {
        let last = self.last();
        self.prepared.feeder.stop == Stop::Landed && self.landings.iter().any(|landing| landing.plate == last)
    }
}

impl Observer for Watcher<'_, '_> {
    fn is_dense(&self) -> bool {
        self.traced
    }

    fn sample(&mut self, time: f64, mode: Mode, state: &State) {
        self.samples.sample(time, mode, state);
    }

    fn starts(&mut self, time: f64, mode: Mode, state: &State) -> ControlFlow<()> {
        self.note(time, mode.held(&self.prepared.world), state);
        self.has_flown |= mode == Mode::Flight && time > 0.0;
        if mode != Mode::Flight {
            self.left = None;
        } else if self.left.is_none() && self.is_over_edge(state) {
            self.left = Some(Exit { time, state: *state });
        }
        if self.has_landed() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn piece(&mut self, piece: &Piece) {
        self.note(piece.end_time, piece.mode.held(&self.prepared.world), &piece.end);
        self.samples.piece(piece);
    }

    fn closing(&mut self, closing: &Closing) {
        self.closed = Some([closing.time, closing.limit]);
    }

    fn impact(&mut self, impact: &Impact) -> ControlFlow<()> {
        let world = &self.prepared.world;
        let speed = |support: usize| {
            world.touches_at(support, &self.now).map_or(0.0, |arm| self.now.velocity_of(arm).norm())
        };
        let Some(first) = impact.striking.iter().next().or_else(|| impact.touching.iter().next()) else {
            return ControlFlow::Continue(());
        };
        let (speed, owner) = (speed(first), self.owner(first));
        self.struck_at.push(speed);
        self.struck.push(owner);
        for support in impact.touching.iter() {
            let (owner, plates) = (self.owner(support), self.plates.len());
            match self.plates.get_mut(owner) {
                Some(seen) => {
                    seen.touched(impact.time);
                    if impact.striking.contains(support) {
                        seen.struck(speed);
                    }
                }
                None => self.walls[owner - plates] = true,
            }
        }
        ControlFlow::Continue(())
    }
}
