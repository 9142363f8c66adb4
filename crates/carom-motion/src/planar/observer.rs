//! Who looks on while a body moves.

use super::trace::{Impact, PieceEnd};
use super::{Feature, State};
use carom_impact::planar::ImpactType;

/// A contact that transmits force, as handed to an observer.
pub use super::trace::{ContactSample, HeldContact};

/// The bare facts of an impact, for runs that keep no trace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactFacts {
    /// Time [s].
    pub time: f64,
    /// Obstacle of the striking contact.
    pub obstacle: usize,
    /// Features of the striking contact.
    pub feature: Feature,
    /// Speed of the striking contact point relative to the obstacle [m/s].
    pub speed: f64,
    /// Type, where one contact acts.
    pub kind: Option<ImpactType>,
    /// State before.
    pub before: State,
    /// State after.
    pub after: State,
}

/// The bare facts of a smooth piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceFacts {
    /// Start [s].
    pub start_time: f64,
    /// End [s].
    pub end_time: f64,
    /// Pose and velocity at the start.
    pub start: State,
    /// Pose and velocity at the end.
    pub end: State,
    /// Why it ended.
    pub ended_by: PieceEnd,
}

/// Who looks on. `()` looks at nothing.
pub trait Observer {
    /// True: samples and whole impacts are made and handed over.
    fn is_dense(&self) -> bool {
        false
    }

    /// True: slip speeds are handed over.
    fn wants_slips(&self) -> bool {
        false
    }

    /// A smooth piece starts with these contacts held.
    fn starts(&mut self, time: f64, state: &State, held: &mut dyn Iterator<Item = HeldContact>) {
        let _ = (time, state, held);
    }

    /// An instant of the present piece; only where [`Observer::is_dense`].
    fn sample(&mut self, time: f64, state: &State, contacts: &mut dyn Iterator<Item = ContactSample>) {
        let _ = (time, state, contacts);
    }

    /// The present piece has ended.
    fn piece(&mut self, piece: &PieceFacts) {
        let _ = piece;
    }

    /// An impact; `whole` only where [`Observer::is_dense`].
    fn impact(&mut self, facts: &ImpactFacts, whole: Option<Impact>) {
        let _ = (facts, whole);
    }

    /// The contact struck last would have to pull to be held: it lifts off at once.
    fn lifts_off(&mut self, needed_force: f64) {
        let _ = needed_force;
    }

    /// Infinitely many impacts between these two times were closed at their limit.
    fn accumulation(&mut self, from: f64, to: f64) {
        let _ = (from, to);
    }

    /// Slip speed of a held contact on an obstacle [m/s], at every step of the integration; only where [`Observer::wants_slips`].
    fn slips(&mut self, obstacle: usize, speed: f64) {
        let _ = (obstacle, speed);
    }
}

impl Observer for () {}

/// Those who look on bodies, one each. A walk is compiled once, whoever looks on: it tells them of events, not of every number.
pub(super) type Observers<'o, const B: usize> = [Option<&'o mut dyn Observer>; B];

/// True where somebody wants samples and whole impacts.
pub(super) fn is_dense<const B: usize>(observers: &Observers<'_, B>) -> bool {
    observers.iter().flatten().any(|observer| observer.is_dense())
}

/// True where somebody wants slip speeds.
pub(super) fn wants_slips<const B: usize>(observers: &Observers<'_, B>) -> bool {
    observers.iter().flatten().any(|observer| observer.wants_slips())
}
