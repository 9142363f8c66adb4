//! An observer that keeps everything.

use super::observer::{ContactSample, HeldContact, ImpactFacts, Observer, PieceFacts};
use super::trace::{Impact, Piece, Sample, Trace};
use crate::planar::geometry::State;

/// Keeps every piece, sample and impact.
///
/// # Example
/// A ball falls from 0.2 m, bounces with e = 1/2 and comes to rest at 0.6 s, but for the last few millionths
/// of the world's time, 0.1 s.
/// ```
/// use carom_motion::planar::{Happening, Options, Recorder, Walker, examples};
/// let (world, start) = examples::falling_ball();
/// let mut recorder = Recorder::default();
/// let mut walker = Walker::new(&world, start, vec![], Options::default())?;
/// while walker.advance(&mut recorder)? == Happening::Moves {}
/// let trace = recorder.into_trace();
/// assert!((trace.impacts[0].time - 0.2).abs() < 1e-12);
/// assert!((trace.pieces.last().unwrap().end_time - 0.6).abs() < 1e-6);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Recorder {
    trace: Trace,
    held: Vec<HeldContact>,
    samples: Vec<Sample>,
}

impl Recorder {
    /// What was recorded.
    pub fn into_trace(self) -> Trace {
        self.trace
    }

    /// What has been recorded so far.
    pub fn trace(&self) -> &Trace {
        &self.trace
    }
}

impl Observer for Recorder {
    fn is_dense(&self) -> bool {
        true
    }

    fn starts(&mut self, _time: f64, _state: &State, held: &mut dyn Iterator<Item = HeldContact>) {
        self.held = held.collect();
        self.samples.clear();
    }

    fn sample(&mut self, time: f64, state: &State, contacts: &mut dyn Iterator<Item = ContactSample>) {
        self.samples.push(Sample { time, state: *state, contacts: contacts.collect() });
    }

    fn piece(&mut self, piece: &PieceFacts) {
        self.trace.pieces.push(Piece {
            held: std::mem::take(&mut self.held),
            start_time: piece.start_time,
            end_time: piece.end_time,
            start: piece.start,
            end: piece.end,
            ended_by: piece.ended_by,
            samples: std::mem::take(&mut self.samples),
        });
    }

    fn impact(&mut self, _facts: &ImpactFacts, whole: Option<Impact>) {
        self.trace.impacts.extend(whole);
    }

    fn lifts_off(&mut self, needed_force: f64) {
        if let Some(impact) = self.trace.impacts.last_mut() {
            impact.holding_would_need = Some(needed_force);
        }
    }

    fn accumulation(&mut self, from: f64, to: f64) {
        self.trace.accumulations.push((from, to));
    }
}
