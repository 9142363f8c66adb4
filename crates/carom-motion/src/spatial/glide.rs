//! Integration of a mode, from one event to the next.

use super::bounds::Bounds;
use super::events::{Event, Watch};
use super::mode::{Vector, normalised};
use super::posture::Posture;
use super::run::Budget;
use super::state::measured;
use super::stretch::Stretch;
use super::terms::RollError;
use super::walker::Walker;
use super::{Observer, Piece, State, Supports};
use carom_num::ode8::{EVALUATIONS_DENSE, EVALUATIONS_PLAIN, Step, length_factor, step_plain};

/// What a stretch ended with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    Event(Event),
    Spent(Budget),
    /// Nothing moves, and nothing makes it move.
    Still,
}

/// The first step, in the world's time, where nothing says more.
const FIRST_STEP: f64 = 0.1;
/// No step is shorter than this, in the world's time.
const SHORTEST: f64 = 1e-15;
/// A first step reaches a little beyond the first touch that is foreseen: heights of a hop are then told from zero at every place of it.
const BEYOND: f64 = 1.2;
/// Samples that an observer is handed of a step.
const SAMPLES: u32 = 8;
/// Heights below this, in units of the reach, are counted on from stretch to stretch.
const SMALL: f64 = 1e-3;
/// Accelerations below this, in the world's own units, are rounding.
const STILL: f64 = 1e-13;

impl<O: Observer> Walker<'_, O> {
    /// Moves on to the next event.
    pub(super) fn glide(&mut self) -> Result<Stop, RollError> {
        let (start_time, start) = (self.time, self.state);
        let not_finite = RollError::NotFinite { time: start_time };
        let stretch = Stretch::from(self.world, self.mode, &start, &self.heights).ok_or(not_finite)?;
        let first = stretch.first();
        let at = stretch.posture(&first, 0.0);
        let time = self.scales.time;
        if self.mode.foot().is_some() && start.spin.norm() == 0.0 && at.turning.norm() * time * time <= STILL
        {
            return Ok(Stop::Still);
        }
        let watch = Watch {
            world: self.world,
            stretch,
            bounds: Bounds::of(self.world, &stretch.equations, &at),
            held: self.mode.held(self.world.body()),
            departing: std::mem::take(&mut self.departing),
            overturning: self.options.overturning,
            middle: self.world.body().middle(),
        };
        self.length = self.first_length(&watch, &first);
        let stop = self.glide_on(watch, first)?;
        self.note_drift(&start);
        let (mode, end, end_time) = (self.mode, self.state, self.time);
        self.observer.piece(&Piece { mode, start_time, end_time, start, end });
        Ok(stop)
    }

    fn first_length(&self, watch: &Watch<'_>, first: &Vector) -> f64 {
        let at = watch.stretch.posture(first, 0.0);
        let free = (0..self.world.body().supports().len()).filter(|i| !watch.held.contains(*i));
        let foreseen = free.filter_map(|i| watch.height(i, &at).forecast()).fold(f64::INFINITY, f64::min);
        let own = if self.length > 0.0 { self.length } else { FIRST_STEP * self.scales.time };
        own.max(FIRST_STEP * self.scales.time).min(BEYOND * foreseen).max(SHORTEST * self.scales.time)
    }

    fn glide_on(&mut self, mut watch: Watch<'_>, first: Vector) -> Result<Stop, RollError> {
        let (mut y, mut rate, mut elapsed) = (first, watch.stretch.equations.rate(&first), 0.0);
        let start_time = self.time;
        self.effort.evaluations += 1;
        loop {
            let left = self.options.most_time - self.time;
            if left <= 0.0 {
                return Ok(Stop::Spent(Budget::Time));
            }
            if self.effort.steps >= self.options.most_steps {
                return Ok(Stop::Spent(Budget::Steps));
            }
            let step = self.step((&y, &rate), left, &watch)?;
            if let Some(found) = watch.first_event(&step, elapsed, &mut self.effort) {
                let (length, end) = watch.polish(&step, &found, elapsed, &mut self.effort);
                self.show(&watch.stretch, &step, (start_time, elapsed), length);
                self.state = watch.stretch.state(&end, elapsed + length);
                self.lasted = elapsed + length;
                self.note_heights(&watch, &watch.stretch.posture(&end, elapsed + length));
                self.time = start_time + (elapsed + length);
                return Ok(Stop::Event(found.event));
            }
            self.show(&watch.stretch, &step, (start_time, elapsed), step.length);
            elapsed += step.length;
            (y, rate) = (normalised(&step.end), step.end_rate);
            watch.departing = Supports::NONE;
            self.state = watch.stretch.state(&y, elapsed);
            self.time = if step.length >= left { self.options.most_time } else { start_time + elapsed };
            if !self.state.is_finite() {
                return Err(RollError::NotFinite { time: self.time });
            }
        }
    }

    /// A step whose error is within the tolerance, and the length of the next.
    fn step(
        &mut self,
        (y, rate): (&Vector, &Vector),
        most: f64,
        watch: &Watch<'_>,
    ) -> Result<Step<Vector>, RollError> {
        let rates = |y: &Vector| watch.stretch.equations.rate(y);
        let spin = (y[4] * y[4] + y[5] * y[5] + y[6] * y[6]).sqrt().max(1.0 / self.scales.time);
        let tolerance: Vector =
            std::array::from_fn(|i| self.options.tolerance * if i < 4 { 1.0 } else { spin });
        let mut length = self.length.min(most);
        loop {
            if length < SHORTEST * self.scales.time && length < most {
                return Err(RollError::StepTooSmall { time: self.time, step: length });
            }
            let trial = step_plain(*y, *rate, length, rates);
            self.effort.evaluations += EVALUATIONS_PLAIN;
            let error = trial.scaled_error(&tolerance);
            if error <= 1.0 {
                self.effort.evaluations += EVALUATIONS_DENSE;
                self.effort.steps += 1;
                self.length = length * length_factor(error);
                return Ok(trial.with_dense(rates(&trial.end), rates));
            }
            self.effort.refused_steps += 1;
            length *= if error.is_finite() { length_factor(error) } else { 0.1 };
        }
    }

    /// Samples of a step up to a length, for observers that want them.
    fn show(&mut self, stretch: &Stretch, step: &Step<Vector>, (start, elapsed): (f64, f64), length: f64) {
        if !O::DENSE {
            return;
        }
        for k in 0..=SAMPLES {
            let along = length * f64::from(k) / f64::from(SAMPLES);
            let state = stretch.state(&step.at(along / step.length), elapsed + along);
            self.observer.sample(start + elapsed + along, self.mode, &state);
        }
    }

    /// Counts on the heights. Those that are not small are measured again, so that no rounding adds up.
    fn note_heights(&mut self, watch: &Watch<'_>, at: &Posture) {
        let foot = self.mode.foot();
        for support in 0..self.world.body().supports().len() {
            let counted = watch.height(support, at).value;
            self.heights[support] = if watch.held.contains(support) {
                0.0
            } else if counted > SMALL * self.scales.length {
                measured(self.world.body(), &self.state, foot, support)
            } else {
                counted
            };
        }
    }

    /// Compares the energy with that at the start of a stretch.
    fn note_drift(&mut self, start: &State) {
        let body = self.world.body();
        let (before, after) = (start.kinetic(body), self.state.kinetic(body));
        // Differences of the potential energy without that of the place on the plane.
        let fallen = self.world.gravity().dot(self.state.centre - start.centre);
        let change = after - before - body.mass() * fallen;
        self.drift = self.drift.max(change.abs() / (self.scales.energy + before.max(after)));
    }
}
