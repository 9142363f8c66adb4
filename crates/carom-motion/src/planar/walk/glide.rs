//! Motion with contacts held: integration, its events, and what follows them.

use super::events::{Event, Vector, pack, rate, unpack};
use super::gliding::{Gliding, Over};
use super::path::{Course, Stretch};
use super::terms::Happening;
use super::walker::Walker;
use crate::MotionError;
use crate::planar::geometry::{Feature, State};
use crate::planar::modes::{
    mode::{Forces, Held},
    watch::{FEW_WATCHED, MOST_OF_CONTACT, MOST_WATCHED, Watch, WatchList, Watched},
};
use crate::planar::record::{
    observer::{Observers, is_dense, wants_slips},
    trace::{ContactSample, PieceEnd},
};
use crate::tolerance::{CLEARLY_OPEN, FIRST_STEP_TOLERANCE};
use carom_impact::planar::Slip;
use carom_num::course::{Lost, Reached, Stop, follow};
use carom_num::elementary::pow;
use carom_num::ode8::Step;
use std::sync::Arc;

/// Most steps of one piece. Common pieces take some tens. A piece that takes more than these, a second of work, follows a motion whose own times are
/// minute beside the budget of time.
pub(super) const MOST_STEPS: u32 = 20_000;
/// Events in a row that time does not part, after which rounding is what decides them.
const MOST_STALLS: u32 = 12;

impl<const B: usize> Walker<'_, B> {
    /// Moves with the present contacts held until an event, and resolves it.
    pub(super) fn glide(&mut self, observers: &mut Observers<'_, B>) -> Result<Happening, MotionError> {
        self.forget_past();
        if let Some(happening) = self.glide_along_series(observers) {
            return happening;
        }
        if self.watches_few() {
            self.glide_watching(&mut WatchList::on(&mut [None; FEW_WATCHED]), observers)
        } else {
            self.glide_watching(&mut WatchList::on(&mut [None; MOST_WATCHED]), observers)
        }
    }

    /// True where the event functions of the present mode are few: the modes' own, and a gap for each pair that has just opened.
    pub(super) fn watches_few(&self) -> bool {
        MOST_OF_CONTACT * self.held.len() + 2 + self.departing.len() <= FEW_WATCHED
    }

    fn glide_watching(
        &mut self,
        list: &mut WatchList<'_>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        let (start_time, start) = (self.time, self.states);
        self.report_start(observers);
        self.report_slips(observers);
        self.sample_here(observers);
        let mut gliding = Gliding::from(self, list, observers);
        let y = pack(&start);
        gliding.walker.effort.evaluations += 1;
        let (f, length) = (rate(&y, &gliding.forces.acceleration), gliding.walker.first_length(gliding.list));
        let stop = follow(&mut gliding, (y, f), length, MOST_STEPS as usize);
        let stop = stop.map(|stop| match stop {
            Stop::Event { event: Reached { event, length, y }, step } => {
                self.note_step(step, length, observers);
                if is_dense(observers) {
                    self.sample_stretch(&step, (length / step.length, true), observers);
                }
                self.time += length;
                self.states = self.projected(&unpack(&y));
                self.report_slips(observers);
                Stop::Event { event, step: () }
            }
            Stop::End(over) => Stop::End(over),
        });
        self.conclude((start_time, &start), stop, observers)
    }

    /// Resolves what has ended a piece of motion, where the walker has come to.
    pub(super) fn conclude(
        &mut self,
        (start_time, start): (f64, &[State; B]),
        stop: Result<Stop<(), Event, Over>, Lost>,
        observers: &mut Observers<'_, B>,
    ) -> Result<Happening, MotionError> {
        match stop {
            Ok(Stop::Event { event, .. }) => {
                self.sample_here(observers);
                if self.comes_back_at(&event) {
                    return Ok(self.swings((start_time, start), observers));
                }
                self.report_piece(start_time, start, |b| self.piece_end(&event, b), observers);
                self.resolve(&event, observers)
            }
            Ok(Stop::End(Over::TimeUp)) => {
                self.report_piece(start_time, start, |_| PieceEnd::TimeUp, observers);
                Ok(Happening::BudgetSpent)
            }
            Ok(Stop::End(Over::Swings)) => Ok(self.swings((start_time, start), observers)),
            // The normal force grows without bound (Painlevé's paradox): an impact stops the slip.
            Err(Lost::Short(_)) if self.slips() => {
                let edge = Event::Watched(Watched::plain(Watch::Regular));
                self.turning_points = 0;
                self.report_piece(start_time, start, |b| self.piece_end(&edge, b), observers);
                self.resolve(&edge, observers)
            }
            Err(Lost::Short(step)) => Err(MotionError::StepTooSmall { time: self.time, step }),
            Err(Lost::Number) => Err(MotionError::NotFinite { time: self.time }),
            Err(Lost::Steps) => Err(MotionError::TooManySteps { time: self.time, steps: MOST_STEPS }),
        }
    }

    /// Ends the walk in a swing.
    fn swings(
        &mut self,
        (start_time, start): (f64, &[State; B]),
        observers: &mut Observers<'_, B>,
    ) -> Happening {
        self.report_piece(start_time, start, |_| PieceEnd::Swings, observers);
        self.ended = Some(Happening::Swings);
        Happening::Swings
    }

    /// A first step to try: long where two contacts of one face leave only a steady slide, shorter where one of them nears the face's middle,
    /// short where the body may turn.
    fn first_length(&self, list: &WatchList<'_>) -> f64 {
        let on_face = |h: &Held| matches!(h.pair.feature, Feature::VertexOnFace { .. });
        // The error of a step is of order 8 in its length.
        let loose = || pow(self.options.tolerance / FIRST_STEP_TOLERANCE, 0.125).clamp(1.0, 5.0);
        let times = match (self.held.get(0), self.held.get(1)) {
            (Some(a), Some(b)) if a.pair.obstacle != b.pair.obstacle => 0.12,
            (Some(a), Some(b)) if on_face(a) && on_face(b) => 8.0,
            (Some(_), Some(_)) => 2.0,
            _ => 0.1 * loose(),
        };
        // A hop that is over soon must not be a speck at the start of a long step.
        self.scales.time * (2.0 * list.returns).min(times)
    }

    fn slips(&self) -> bool {
        self.held.iter().any(|h| h.slip != Slip::Sticks)
    }

    /// Shows the present states to those who ask for samples.
    pub(super) fn sample_here(&self, observers: &mut Observers<'_, B>) {
        if is_dense(observers) {
            self.sample(&self.states, observers);
        }
    }

    pub(super) fn report_slips(&self, observers: &mut Observers<'_, B>) {
        if wants_slips(observers) {
            let turns = self.turns();
            for h in self.held.iter().filter(|h| h.slip != Slip::Sticks) {
                let speed = self.world.kinematics_turned(&self.states, &turns, h.pair).slip.abs();
                for (body, observer) in observers.iter_mut().enumerate() {
                    if let (Some(observer), Some((obstacle, _))) = (observer, self.seen_by(body, h.pair)) {
                        observer.slips(obstacle, speed);
                    }
                }
            }
        }
    }

    /// Notes the event functions from here on; leaves the forces here in `forces`.
    pub(super) fn note_watched_with(&self, list: &mut WatchList<'_>, forces: &mut Forces<B>) {
        let turns = self.turns();
        self.world.forces_into(&self.held, &self.states, &turns, forces);
        list.begin(self.time, (self.stalls > MOST_STALLS, self.options.significant()));
        list.note(&self.world, (&self.states, &turns), forces, &self.departing);
    }

    /// Drops pairs that have clearly opened; true where that changes what is watched.
    pub(super) fn forget_left(&mut self, states: &[State; B]) -> bool {
        let before = self.departing.len();
        let (world, clear) = (&*self.world, CLEARLY_OPEN * self.scales.length);
        self.departing.retain(|pair| world.kinematics(states, *pair).gap.abs() < clear);
        self.departing.len() != before
    }

    /// Drops pairs that have opened and are clearly open, or now leave their features' extents: past them the gap of two lines says nothing of the
    /// features.
    fn forget_past(&mut self) {
        if self.departing.is_empty() {
            return;
        }
        let states = self.states;
        self.forget_left(&states);
        let mut departing = self.departing;
        departing.retain(|pair| !self.runs_off(*pair));
        self.departing = departing;
    }

    /// Samples along a part of a stretch; its end as well, unless something ends there.
    pub(super) fn sample_stretch(
        &self,
        stretch: &impl Stretch<B>,
        (part, ends): (f64, bool),
        observers: &mut Observers<'_, B>,
    ) {
        let span = part * stretch.length();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to a small count"
        )]
        let count = (span / (0.02 * self.scales.time)).ceil().clamp(1.0, 200.0) as u32;
        let last = if ends { count - 1 } else { count };
        for i in 1..=last {
            let x = part * f64::from(i) / f64::from(count);
            let states = self.projected(&stretch.states(x));
            self.sample_at(self.time + x * stretch.length(), &states, observers);
        }
    }

    /// Notes the first part of a step, of this length [s], for those who want to know.
    pub(super) fn note_step(&mut self, step: Step<Vector<B>>, length: f64, observers: &mut Observers<'_, B>) {
        self.show_along(&step, length, observers);
        self.note_leg(length, || Course::Along(Arc::new(step)));
    }

    /// Hands over the states that are asked for along the first part of a stretch, of this length [s].
    pub(super) fn show_along(
        &self,
        stretch: &impl Stretch<B>,
        length: f64,
        observers: &mut Observers<'_, B>,
    ) {
        let whole = stretch.length();
        self.show_instants(length, |t| self.projected(&stretch.states(t / whole)), observers);
    }

    pub(super) fn sample(&self, states: &[State; B], observers: &mut Observers<'_, B>) {
        self.sample_at(self.time, states, observers);
    }

    fn sample_at(&self, time: f64, states: &[State; B], observers: &mut Observers<'_, B>) {
        let forces = self.world.forces(&self.held, states);
        for (body, observer) in observers.iter_mut().enumerate().take(self.world.bodies.len()) {
            let Some(observer) = observer else { continue };
            let mut contacts = forces.contacts.iter().filter_map(|c| {
                let (obstacle, feature) = self.seen_by(body, c.held.pair)?;
                let (k, own) = (&c.kinematics, c.held.pair.body == body);
                Some(ContactSample {
                    obstacle,
                    feature,
                    point: states[body].pose.centre + if own { k.arm } else { k.other_arm },
                    normal: if own { k.normal } else { -k.normal },
                    normal_force: c.normal_force,
                    tangential_force: c.tangential_force,
                    slip: k.slip,
                })
            });
            observer.sample(time, &states[body], &mut contacts);
        }
    }

    /// The contacts held, for the outside.
    pub(super) fn held_pairs(&self) -> impl Iterator<Item = &Held> {
        self.held.iter()
    }
}
