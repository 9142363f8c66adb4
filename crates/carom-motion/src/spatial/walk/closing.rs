//! Series of impacts closed at their limits, and series of such limits.

use super::series::{Beat, Recent, Series};
use super::walker::Walker;
use crate::MotionError;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::mode::Mode;
use crate::spatial::modes::settle::{all_held, settled, spin_on};
use crate::spatial::record::run::{Closing, End};
use crate::tolerance::{CLOSING_ERROR, FAINT_ENERGY, LIES_ON_PLANE, MOST_TURNS_LEFT, TURNS_EARLIER};

/// What became of an impact that may be one of a series.
pub(super) enum Closed {
    /// It is none yet, or the series cannot be closed.
    Not,
    /// The series is closed and the body goes on, or the run has ended.
    Yes(Option<End>),
}

impl Walker<'_> {
    /// Notes an impact, and closes the series that it belongs to once its limit is near. `pattern` tells one impact of a period from the others; `rests` is what
    /// rests where a series of such impacts is over. A limit may be one of a series too: a body that rocks on two edges may chatter on each before it rolls on it. So may the turns of supports
    /// that strike one after the other be: the first strikes of each.
    pub(super) fn note(
        &mut self,
        touching: Supports,
        pattern: Supports,
        rests: Supports,
    ) -> Result<Closed, MotionError> {
        let faint = self.state.kinetic(self.world.body()) < FAINT_ENERGY * self.scales.energy;
        let mut beat = Beat { time: self.time, touching, pattern, rests, faint };
        let mut closed = Closed::Not;
        // What stands without sliding hardly chatters: its impacts are its turns.
        if self.world.friction().is_some() && self.turns.latest() != Some(pattern) {
            self.turns.push(beat);
            let closing = (TURNS_EARLIER * self.options.closing).min(MOST_TURNS_LEFT);
            // What lies down on one face does so from farther off than rounding: elsewhere it would be moved among its other supports.
            if let Some(series) = self.series_of(&self.turns, closing)
                && self.lies_down(series.kept)
                && let Closed::Yes(end) = self.close(&series, beat.time + series.left)?
            {
                self.forget_series();
                return Ok(Closed::Yes(end));
            }
        }
        for level in 0..self.recent.len() {
            self.recent[level].push(beat);
            let Some(series) = self.series_of(&self.recent[level], self.options.closing) else { break };
            let limit = beat.time + series.left;
            let Closed::Yes(end) = self.close(&series, limit)? else { break };
            self.recent[level].clear();
            if end.is_some() {
                return Ok(Closed::Yes(end));
            }
            closed = Closed::Yes(None);
            let kept = series.kept;
            beat = Beat { time: limit, touching: kept, pattern: kept, rests: kept, faint };
        }
        Ok(closed)
    }

    /// The series that these impacts belong to, once so much of the world's time is left of it.
    fn series_of(&self, recent: &Recent, closing: f64) -> Option<Series> {
        let [short, error] =
            [closing, CLOSING_ERROR * self.options.closing].map(|time| time * self.scales.time);
        let fewest = if self.world.friction().is_some() { 1 } else { 2 };
        recent.series(short, error).filter(|s| s.kept.len() >= fewest)
    }

    /// These supports are points on one face, and keep the body from turning.
    fn lies_down(&self, kept: Supports) -> bool {
        let mode = Mode::holding(self.world, kept, self.state.pose());
        matches!(mode, Mode::Rest { .. }) && self.world.is_of_one_plane(kept) && !self.world.has_pairs(kept)
    }

    /// Closes a series: the supports that any of its impacts keeps rest. If they would not stay, there is no series.
    fn close(&mut self, series: &Series, limit: f64) -> Result<Closed, MotionError> {
        let world = self.world;
        let before = (self.state, self.mode, self.departing, self.heights.clone());
        let impacts = self.impacts.len();
        let mode = Mode::holding(world, series.kept, self.state.pose());
        if self.world.friction().is_some() {
            // A face has to come down to where it lies: what is beside it may keep it as it is otherwise.
            if matches!(mode, Mode::Rest { .. }) {
                let Some(state) = self.laid(series.kept) else { return Ok(Closed::Not) };
                self.state = state;
                self.measure_heights();
            }
            let Some(state) = self.landed(series.kept, series.left) else {
                (self.state, self.heights) = (before.0, before.3);
                return Ok(Closed::Not);
            };
            self.state = state;
        } else {
            self.state.spin = spin_on(world, mode, &self.state);
            self.state = settled(world, mode, &self.state);
        }
        self.level_heights(mode);
        // A body at rest may lie on more supports than the series' impacts have kept.
        let resting = if matches!(mode, Mode::Rest { .. }) { self.touching()? } else { Supports::NONE };
        let resting = self.spoken_for(resting, series.kept);
        let kept = series.kept.union(resting);
        let end = self.hold(kept, None)?;
        if !all_held(world, self.mode, kept) && self.impacts.len() == impacts {
            (self.state, self.mode, self.departing, self.heights) = before;
            return Ok(Closed::Not);
        }
        let closing = Closing { time: self.time, limit, period: series.period, ratio: series.ratio, kept };
        self.observer.closing(&closing);
        self.closings.push(closing);
        if end.is_some() {
            self.time = limit;
        }
        Ok(Closed::Yes(end))
    }

    /// The stretch after a closed series starts at its last impact, and brings what is left of it. A run that is ended there ends at the limit.
    pub(super) fn goes_to_the_limit(&mut self) -> Result<(), MotionError> {
        let closed = self.closings.last().filter(|closing| closing.time == self.time);
        if let Some(limit) = closed.map(|closing| closing.limit).filter(|limit| *limit > self.time) {
            self.state = self.ahead(limit - self.time)?;
            self.time = limit;
        }
        Ok(())
    }

    /// The heights after the held supports have come down to the plane: all go down with a body at rest, and turn across an edge. On several planes they are
    /// the ones that they were.
    fn level_heights(&mut self, mode: Mode) {
        let (world, held, pose) = (self.world, mode.held(self.world), self.state.pose());
        let rests = matches!(mode, Mode::Rest { .. });
        if world.is_of_one_plane(held) {
            match mode {
                Mode::Edge { ends: [a, b], along, .. } => {
                    let (low, high) = (self.heights[a], self.heights[b]);
                    let place = |i: usize| world.arm(i, pose);
                    let length = (place(b) - place(a)).norm();
                    let sunk = |i: usize| low + (high - low) * (place(i) - place(a)).dot(along) / length;
                    self.sink(a, sunk);
                }
                Mode::Pivot { support, .. } => {
                    let low = self.heights[support];
                    self.sink(support, |_| low);
                }
                _ => {}
            }
        }
        // Supports of several planes leave a body that slides on them free to turn: of what is low only what lies flush with them touches.
        let flush = (rests && !world.is_of_one_plane(held)).then(|| self.flush_with(held));
        let lies = |i: usize| flush.as_ref().is_none_or(|marks| marks.contains(i));
        for (i, height) in self.heights.iter_mut().enumerate().take(world.count()) {
            let low = height.abs() < LIES_ON_PLANE * self.scales.length;
            if held.contains(i) || rests && low && lies(i) {
                *height = 0.0;
            }
        }
    }

    /// The supports of the same plane come down by this.
    fn sink(&mut self, support: usize, by: impl Fn(usize) -> f64) {
        let own = self.world.of_plane(self.world.plane_of(support));
        own.into_iter().for_each(|i| self.heights[i] -= by(i));
    }

    /// Whatever was seen of series is over.
    pub(super) fn forget_series(&mut self) {
        self.recent.iter_mut().for_each(Recent::clear);
        self.turns.clear();
    }
}
