//! Motion with contacts held: integration, its events, and what follows them.

use super::events::{Event, Vector, pack, rate, unpack};
use super::kinematics::Turn;
use super::mode::Held;
use super::observer::Observer;
use super::terms::{Happening, MotionError};
use super::trace::{ContactSample, PieceEnd};
use super::walker::Walker;
use super::watch::{Watch, WatchList, Watched};
use super::{Feature, State};
use carom_impact::planar::Slip;
use carom_num::ode8::{EVALUATIONS_DENSE, EVALUATIONS_PLAIN, Step, length_factor, step_plain};

/// Events in a row that time does not part, after which rounding is what decides them.
const MOST_STALLS: u32 = 12;

impl Walker<'_> {
    /// Moves with the present contacts held until an event, and resolves it.
    pub(super) fn glide<O: Observer>(&mut self, observer: &mut O) -> Result<Happening, MotionError> {
        let (start_time, start) = (self.time, self.state);
        observer.starts(self.time, &self.state, &mut self.held());
        self.report_slips(observer);
        let mut list = self.watch_list();
        let mut y = pack(&self.state);
        let mut f = self.rate_of(&y);
        if O::DENSE {
            self.sample(&unpack(&y), observer);
        }
        let mut length = self.first_length(&list);
        loop {
            if self.time >= self.options.most_time {
                self.state = unpack(&y);
                self.report_piece(start_time, start, PieceEnd::TimeUp, observer);
                return Ok(Happening::BudgetSpent);
            }
            length = length.min(self.options.most_time - self.time);
            let (tried, next) = match self.accepted_step(y, f, length) {
                // The normal force grows without bound (Painlevé's paradox): an impact stops the slip.
                Err(MotionError::StepTooSmall { .. }) if self.slips() => {
                    return self.jam_dynamically(start_time, start, observer);
                }
                other => other?,
            };
            if let Some(found) = self.event_in(&tried, &list) {
                let end = self.polish(&tried, &found);
                let begin = self.time;
                if O::DENSE {
                    self.sample_step(&tried, end.length / tried.length, observer);
                }
                self.time = begin + end.length;
                self.state = self.projected(&unpack(&end.state));
                if O::DENSE {
                    self.sample(&self.state, observer);
                }
                self.report_slips(observer);
                self.report_piece(start_time, start, self.piece_end(&found.event), observer);
                return self.resolve(&found.event, observer);
            }
            if O::DENSE {
                self.sample_step(&tried, 1.0, observer);
            }
            self.time += tried.length;
            let state = self.projected(&unpack(&tried.end));
            y = pack(&state);
            f = tried.end_rate;
            length = next;
            self.state = state;
            self.report_slips(observer);
            if self.forget_left(&state) {
                list = self.watch_list();
            }
        }
    }

    /// A first step to try: long where two contacts of one face leave only a steady slide, shorter where one of them nears the face's middle,
    /// short where the body may turn.
    fn first_length(&self, list: &WatchList) -> f64 {
        let on_face = |h: &Held| matches!(h.pair.feature, Feature::VertexOnFace { .. });
        let times = match (self.held.get(0), self.held.get(1)) {
            (Some(a), Some(b)) if a.pair.obstacle != b.pair.obstacle => 0.12,
            (Some(a), Some(b)) if on_face(a) && on_face(b) => 8.0,
            (Some(_), Some(_)) => 2.0,
            _ => 0.12,
        };
        // A hop that is over soon must not be a speck at the start of a long step.
        self.scales.time * (2.0 * list.returns).min(times)
    }

    fn slips(&self) -> bool {
        self.held.iter().any(|h| h.slip != Slip::Sticks)
    }

    fn jam_dynamically<O: Observer>(
        &mut self,
        start_time: f64,
        start: State,
        observer: &mut O,
    ) -> Result<Happening, MotionError> {
        let edge = Event::Watched(Watched::plain(Watch::Regular));
        self.report_piece(start_time, start, self.piece_end(&edge), observer);
        self.resolve(&edge, observer)
    }

    fn report_slips<O: Observer>(&self, observer: &mut O) {
        if O::SLIPS {
            let turn = Turn::of(&self.state);
            for h in self.held.iter().filter(|h| h.slip != Slip::Sticks) {
                observer.slips(
                    h.pair.obstacle,
                    self.world.kinematics_turned(&self.state, turn, h.pair).slip.abs(),
                );
            }
        }
    }

    fn watch_list(&mut self) -> WatchList {
        self.last_look = None;
        let forces = self.world.forces(&self.held, &self.state);
        let stalled = self.stalls > MOST_STALLS;
        WatchList::of(self.world, self.time, &self.state, &forces, &self.departing, stalled)
    }

    fn rate_of(&mut self, y: &Vector) -> Vector {
        self.effort.evaluations += 1;
        rate(y, &self.world.accelerate(&self.held, &unpack(y)))
    }

    /// A step whose error is within tolerance, and the length to try next.
    fn accepted_step(
        &mut self,
        y: Vector,
        f: Vector,
        mut length: f64,
    ) -> Result<(Step<Vector>, f64), MotionError> {
        let (l, v, rtol) = (self.scales.length, self.scales.speed, self.options.tolerance);
        let speed = v.max(self.state.twist.velocity.norm());
        let spin = (speed / l).max(self.state.twist.spin.abs());
        let tolerance = [rtol * l, rtol * l, rtol, rtol * speed, rtol * speed, rtol * spin];
        loop {
            let (world, held) = (self.world, &self.held);
            let rhs = |y: &Vector| rate(y, &world.accelerate(held, &unpack(y)));
            let tried = step_plain(y, f, length, rhs);
            self.effort.evaluations += EVALUATIONS_PLAIN;
            let error = tried.scaled_error(&tolerance);
            if error <= 1.0 {
                self.effort.steps += 1;
                self.effort.evaluations += EVALUATIONS_DENSE;
                let end = world.forces(held, &unpack(&tried.end));
                let end_rate = rate(&tried.end, &end.acceleration);
                let step = tried.with_dense(end_rate, rhs);
                self.end_forces = Some(end);
                return Ok((step, length * length_factor(error)));
            }
            if !error.is_finite()
                && !tried.end.iter().all(|v| v.is_finite())
                && length < 1e-12 * self.scales.time
            {
                return Err(MotionError::NotFinite { time: self.time });
            }
            length *= if error.is_finite() { length_factor(error).min(0.9) } else { 0.2 };
            if length < 1e-14 * self.scales.time {
                return Err(MotionError::StepTooSmall { time: self.time, step: length });
            }
        }
    }

    /// Drops pairs that have clearly opened; true where that changes what is watched.
    fn forget_left(&mut self, state: &State) -> bool {
        let before = self.departing.len();
        let (world, clear) = (self.world, 1e-5 * self.scales.length);
        self.departing.retain(|pair| world.kinematics(state, *pair).gap < clear);
        self.departing.len() != before
    }

    fn sample_step<O: Observer>(&self, tried: &Step<Vector>, part: f64, observer: &mut O) {
        let span = part * tried.length;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to a small count"
        )]
        let count = (span / (0.02 * self.scales.time)).ceil().clamp(1.0, 200.0) as u32;
        let last = if part < 1.0 { count - 1 } else { count };
        for i in 1..=last {
            let x = part * f64::from(i) / f64::from(count);
            let state = self.projected(&unpack(&tried.at(x)));
            self.sample_at(self.time + x * tried.length, &state, observer);
        }
    }

    fn sample<O: Observer>(&self, state: &State, observer: &mut O) {
        self.sample_at(self.time, state, observer);
    }

    fn sample_at<O: Observer>(&self, time: f64, state: &State, observer: &mut O) {
        let forces = self.world.forces(&self.held, state);
        let mut contacts = forces.contacts.iter().map(|c| ContactSample {
            obstacle: c.held.pair.obstacle,
            feature: c.held.pair.feature,
            point: state.pose.centre + c.kinematics.arm,
            normal: c.kinematics.normal,
            normal_force: c.normal_force,
            tangential_force: c.tangential_force,
            slip: c.kinematics.slip,
        });
        observer.sample(time, state, &mut contacts);
    }

    /// The contacts held, for the outside.
    pub(super) fn held_pairs(&self) -> impl Iterator<Item = &Held> {
        self.held.iter()
    }
}
