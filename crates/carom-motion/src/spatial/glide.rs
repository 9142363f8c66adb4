//! Integration of a mode, from one event to the next.

use super::course::{Course, Standing};
use super::events::{Event, Watch};
use super::posture::Posture;
use super::run::Budget;
use super::state::measured;
use super::stretch::Stretch;
use super::terms::MotionError;
use super::walker::Walker;
use super::{Mode, Piece, State, Supports};
use crate::evaluated::{Quantity, evaluated, lost, watched};
use crate::tolerance::{SHORTEST_SPATIAL_STEP, SMALL_HEIGHT, STILL_ACCELERATION};
use carom_num::ode8::{EVALUATIONS_DENSE, EVALUATIONS_PLAIN, Step, Vector, length_factor, step_plain};

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
/// A first step reaches a little beyond the first touch that is foreseen: heights of a hop are then told from zero at every place of it.
const BEYOND: f64 = 1.2;
/// Samples that an observer is handed of a step.
const SAMPLES: u32 = 8;

/// Rates of a motion. If one of them is no number, none is. Rates that do not exist, because friction jams the body, are not lost numbers.
fn sound<Y: Vector>(rate: Y) -> Y {
    let sum = (0..Y::COUNT).fold(0.0, |sum, i| sum + rate.at(i));
    if !sum.is_nan() && evaluated(Quantity::Acceleration, sum).is_nan() {
        return Y::from_fn(|_| f64::NAN);
    }
    rate
}

impl Walker<'_> {
    /// Moves on to the next event.
    pub(super) fn glide(&mut self) -> Result<Stop, MotionError> {
        let (start_time, start) = (self.time, self.state);
        let stop = match self.mode {
            Mode::Slides { .. } => self.glide_sliding()?,
            _ => self.glide_standing()?,
        };
        let (mode, end, end_time) = (self.mode, self.state, self.time);
        if stop != Stop::Still {
            self.observer.piece(&Piece { mode, start_time, end_time, start, end });
        }
        Ok(stop)
    }

    fn glide_standing(&mut self) -> Result<Stop, MotionError> {
        let start = self.state;
        let not_finite = MotionError::NotFinite { time: self.time };
        let stretch = Stretch::from(self.world, self.mode, &start, &self.heights).ok_or(not_finite)?;
        let first = stretch.first();
        let at = stretch.posture(&first, 0.0);
        let time = self.scales.time;
        if self.mode.foot().is_some()
            && start.spin.norm() == 0.0
            && at.turning.norm() * time * time <= STILL_ACCELERATION
        {
            return Ok(Stop::Still);
        }
        self.glide_along(Standing::of(self.world, stretch), first)
    }

    fn glide_sliding(&mut self) -> Result<Stop, MotionError> {
        let (sliding, first) = self.sliding()?;
        self.glide_along(sliding, first)
    }

    fn glide_along<C: Course>(&mut self, course: C, first: C::Y) -> Result<Stop, MotionError> {
        let start = self.state;
        let watch = Watch {
            world: self.world,
            course,
            held: self.mode.held(self.world.body()),
            departing: std::mem::take(&mut self.departing),
            overturning: self.options.overturning,
            middle: self.world.body().middle(),
        };
        self.length = self.first_length(&watch, &first);
        let (stop, work) = self.glide_on(watch, first)?;
        self.friction_work += work;
        self.note_drift(&start, work);
        Ok(stop)
    }

    fn first_length<C: Course>(&self, watch: &Watch<'_, C>, first: &C::Y) -> f64 {
        let at = watch.course.posture(first, 0.0);
        let free = (0..self.world.body().supports().len()).filter(|i| !watch.held.contains(*i));
        let foreseen = free.filter_map(|i| watch.height(i, &at).forecast()).fold(f64::INFINITY, f64::min);
        let own = if self.length > 0.0 { self.length } else { FIRST_STEP * self.scales.time };
        own.max(FIRST_STEP * self.scales.time)
            .min(BEYOND * foreseen)
            .max(SHORTEST_SPATIAL_STEP * self.scales.time)
    }

    /// Integrates to the next event; returns the work of friction too.
    fn glide_on<C: Course>(
        &mut self,
        mut watch: Watch<'_, C>,
        first: C::Y,
    ) -> Result<(Stop, f64), MotionError> {
        let (mut y, mut rate, mut elapsed) = (first, sound(watch.course.rate(&first)), 0.0);
        let start_time = self.time;
        self.effort.evaluations += 1;
        loop {
            let left = self.options.most_time - self.time;
            if left <= 0.0 {
                return Ok((Stop::Spent(Budget::Time), watch.course.work(&y)));
            }
            if self.effort.steps >= self.options.most_steps {
                return Ok((Stop::Spent(Budget::Steps), watch.course.work(&y)));
            }
            let Some(step) = self.step((&y, &rate), left, &watch)? else {
                self.arrive(&watch, &y, (start_time, elapsed));
                return Ok((Stop::Event(Event::Jams), watch.course.work(&y)));
            };
            watch.course.look(&step);
            let found = watch.first_event(&step, elapsed, &mut self.effort);
            // An event may have been passed over, and the motion go on without end.
            if lost() {
                return Err(MotionError::NotFinite { time: self.time });
            }
            if let Some(found) = found {
                let (length, end) = watch.polish(&step, &found, elapsed, &mut self.effort);
                self.show(&watch.course, &step, (start_time, elapsed), length);
                self.arrive(&watch, &end, (start_time, elapsed + length));
                return Ok((Stop::Event(found.event), watch.course.work(&end)));
            }
            self.show(&watch.course, &step, (start_time, elapsed), step.length);
            elapsed += step.length;
            (y, rate) = (watch.course.tidied(&step.end), step.end_rate);
            watch.departing = Supports::NONE;
            if let Some((rest, end)) = watch.course.stops(&y, &rate) {
                self.arrive(&watch, &end, (start_time, elapsed + rest));
                return Ok((Stop::Event(Event::Stops), watch.course.work(&end)));
            }
            self.state = watch.course.state(&y, elapsed);
            self.time = if step.length >= left { self.options.most_time } else { start_time + elapsed };
            if !self.state.is_finite() {
                return Err(MotionError::NotFinite { time: self.time });
            }
        }
    }

    /// The stretch ends here.
    fn arrive<C: Course>(&mut self, watch: &Watch<'_, C>, end: &C::Y, (start, elapsed): (f64, f64)) {
        self.state = watch.course.state(end, elapsed);
        self.lasted = elapsed;
        self.note_heights(watch, &watch.course.posture(end, elapsed));
        self.time = start + elapsed;
    }

    /// A step whose error is within the tolerance, and the length of the next; `None` where a body that slides needs steps below rounding.
    fn step<C: Course>(
        &mut self,
        (y, rate): (&C::Y, &C::Y),
        most: f64,
        watch: &Watch<'_, C>,
    ) -> Result<Option<Step<C::Y>>, MotionError> {
        let rates = |y: &C::Y| sound(watch.course.rate(y));
        let tolerance = watch.course.tolerance(y, self.options.tolerance, 1.0 / self.scales.time);
        let longest = watch.course.longest(y, rate);
        if let Some((step, next)) =
            watch.course.stiff_step((y, rate), (self.length, most.min(longest)), &tolerance)
        {
            self.effort.steps += 1;
            self.length = next;
            return Ok(Some(step));
        }
        let mut length = self.length.min(most).min(longest);
        let mut astray = false;
        loop {
            if length < SHORTEST_SPATIAL_STEP * self.scales.time && length < most {
                // In a step this short the number was lost at its start, not on the way to a place too far off.
                if astray {
                    return Err(MotionError::NotFinite { time: self.time });
                }
                // The forces on what slides grow without bound here: it jams, and this is no fault of the numbers.
                if matches!(self.mode, Mode::Slides { .. }) {
                    return Ok(None);
                }
                return Err(MotionError::StepTooSmall { time: self.time, step: length });
            }
            let trial;
            (trial, astray) = watched(|| step_plain(*y, *rate, length, rates));
            self.effort.evaluations += EVALUATIONS_PLAIN;
            let error = trial.scaled_error(&tolerance);
            if error <= 1.0 && !astray {
                self.effort.evaluations += EVALUATIONS_DENSE;
                self.effort.steps += 1;
                self.length = length * length_factor(error);
                return Ok(Some(trial.with_dense(rates(&trial.end), rates)));
            }
            self.effort.refused_steps += 1;
            length *= if error.is_finite() { length_factor(error) } else { 0.1 };
        }
    }

    /// Samples of a step up to a length, and the states that are asked for within it, for observers that want them.
    fn show<C: Course>(&mut self, course: &C, step: &Step<C::Y>, (start, elapsed): (f64, f64), length: f64) {
        let begin = start + elapsed;
        let mut next = self.observer.next_instant();
        while next < begin + length {
            let along = (next - begin).max(0.0);
            self.observer.instant(next, &course.state(&step.at(along / step.length), elapsed + along));
            let asked = std::mem::replace(&mut next, self.observer.next_instant());
            if next <= asked {
                break;
            }
        }
        if !self.observer.is_dense() {
            return;
        }
        for k in 0..=SAMPLES {
            let along = length * f64::from(k) / f64::from(SAMPLES);
            let state = course.state(&step.at(along / step.length), elapsed + along);
            self.observer.sample(start + elapsed + along, self.mode, &state);
        }
    }

    /// Carries the heights on to the end of a stretch. Heights that are not small are measured again, so that rounding does not add up.
    fn note_heights<C: Course>(&mut self, watch: &Watch<'_, C>, at: &Posture) {
        let foot = self.mode.foot();
        for support in 0..self.world.body().supports().len() {
            let counted = watch.height(support, at).value;
            self.heights[support] = if watch.held.contains(support) {
                0.0
            } else if counted > SMALL_HEIGHT * self.scales.length {
                measured(self.world.body(), &self.state, foot, support)
            } else {
                counted
            };
        }
    }

    /// Compares the energy with that at the start of a stretch, and with what friction has done.
    fn note_drift(&mut self, start: &State, work: f64) {
        let body = self.world.body();
        let (before, after) = (start.kinetic(body), self.state.kinetic(body));
        // Differences of the potential energy without that of the place on the plane.
        let fallen = self.world.gravity().dot(self.state.centre - start.centre);
        let change = after - before - body.mass() * fallen - work;
        self.drift = self.drift.max(change.abs() / (self.scales.energy + before.max(after)));
    }
}
