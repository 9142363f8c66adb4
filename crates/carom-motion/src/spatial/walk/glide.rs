//! Integration of a mode, from one event to the next.

use super::gliding::Gliding;
use super::motion::{Event, Motion, Standing, Stop};
use super::walker::Walker;
use crate::MotionError;
use crate::spatial::geometry::state::State;
use crate::spatial::modes::mode::Mode;
use crate::spatial::modes::stretch::Stretch;
use crate::spatial::record::run::{Piece, PieceEnd};
use crate::tolerance::STILL_ACCELERATION;
use carom_num::Vec3;
use carom_num::course::{self, Course, Lost, follow};

impl<'w> Walker<'w> {
    /// Moves on to the next event.
    pub(super) fn glide(&mut self) -> Result<Stop, MotionError> {
        let (start_time, start) = (self.time, self.state);
        let stop = match self.mode {
            Mode::Slides { .. } => self.glide_sliding()?,
            _ => self.glide_standing()?,
        };
        let (mode, end, end_time) = (self.mode, self.state, self.time);
        if let Some(ended_by) = ended_by(stop) {
            self.observer.piece(&Piece { mode, start_time, end_time, start, end, ended_by });
        }
        Ok(stop)
    }

    fn glide_standing(&mut self) -> Result<Stop, MotionError> {
        let start = self.state;
        let not_finite = MotionError::NotFinite { time: self.time };
        let stretch = Stretch::from(self.world, self.mode, &start, &self.heights).ok_or(not_finite)?;
        let first = stretch.first();
        let at = stretch.posture(&first, 0.0);
        if self.mode.foot().is_some() && start.spin.norm() == 0.0 && self.stays_still(at.turning) {
            return Ok(Stop::Still);
        }
        self.glide_along(Standing::of(self.world, stretch), first)
    }

    fn glide_sliding(&mut self) -> Result<Stop, MotionError> {
        let (sliding, first) = self.sliding()?;
        let slips = matches!(self.mode, Mode::Slides { slipping, .. } if !slipping.is_empty());
        if !slips
            && self.state.spin.norm() * self.scales.length <= self.still()
            && self.stays_still(sliding.posture(&first, 0.0).turning)
        {
            return Ok(Stop::Still);
        }
        self.glide_along(sliding, first)
    }

    /// Such an angular acceleration of a body at rest is rounding.
    fn stays_still(&self, turning: Vec3) -> bool {
        turning.norm() * self.scales.time * self.scales.time <= STILL_ACCELERATION
    }

    fn glide_along<M: Motion>(&mut self, motion: M, first: M::Y) -> Result<Stop, MotionError> {
        let (start, mode) = (self.state, self.mode);
        let mut gliding = Gliding::from(self, motion, &first);
        let (rate, length) = (gliding.rate(&first), gliding.first_length(&first));
        let stop = match follow(&mut gliding, (first, rate), length, usize::MAX) {
            Ok(course::Stop::Event { event: reached, step }) => {
                gliding.show(&step, reached.length);
                gliding.arrive(&reached.y, gliding.elapsed + reached.length);
                Stop::Event(reached.event)
            }
            Ok(course::Stop::End(stop)) => stop,
            // The forces on what slides grow without bound here: it jams, and this is no fault of the numbers.
            Err(Lost::Short(_)) if matches!(mode, Mode::Slides { .. }) => Stop::Event(Event::Jams),
            Err(Lost::Short(step)) => return Err(MotionError::StepTooSmall { time: self.time, step }),
            Err(Lost::Number) => return Err(MotionError::NotFinite { time: self.time }),
            Err(Lost::Steps) => return Err(MotionError::TooManySteps { time: self.time, steps: u32::MAX }),
        };
        let work = gliding.work;
        self.friction_work += work;
        self.note_drift(&start, work);
        Ok(stop)
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

/// What ended a stretch; `None` where nothing moved.
fn ended_by(stop: Stop) -> Option<PieceEnd> {
    Some(match stop {
        Stop::Still => return None,
        Stop::Spent(_) => PieceEnd::BudgetSpent,
        Stop::Away => PieceEnd::FliesAway,
        Stop::Event(event) => match event {
            Event::Touches(support) => PieceEnd::Touches { support },
            Event::Lets { support, .. } => PieceEnd::LiftsOff { support },
            Event::Slips(_) | Event::Gives => PieceEnd::FrictionGivesWay,
            Event::Stops => PieceEnd::SlipStops,
            Event::Leaves { support, .. } => PieceEnd::RunsOff { support },
            Event::Flattens(_) => PieceEnd::Flattens,
            Event::Jams => PieceEnd::Jams,
            Event::Overturns => PieceEnd::Overturns,
        },
    })
}
