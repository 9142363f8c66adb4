//! The walk itself: straight pieces of impulse, each to the next event.

use super::super::names::ContactState;
use super::super::names::ImpactType;
use super::super::names::Slip;
use super::super::names::StageEnd;
use super::{Contact, Outcome, Stage, Station};
use crate::tolerance::WORK_GAINED;
use crate::{Law, Phase};

/// What compression leaves for restitution.
pub(super) struct Compression {
    pub(super) impulse: f64,
    pub(super) work: f64,
}

/// Change of both velocities and of the tangential impulse with the normal impulse.
#[derive(Clone, Copy)]
pub(super) struct Rates {
    slip: f64,
    pub(super) normal: f64,
    tangential_impulse: f64,
}

/// The walk through one impact.
pub(super) struct Walk<'a> {
    contact: &'a Contact,
    pub(super) slip: Slip,
    pub(super) now: Station,
    pub(super) normal_work: f64,
    tangential_work: f64,
    /// Magnitudes of the works of all stages: what rounding in their sum is measured against.
    pub(super) work_terms: f64,
    pub(super) from_rest: bool,
    /// The initial slip has come to zero.
    pub(super) stopped: bool,
    margin: f64,
}

impl<'a> Walk<'a> {
    pub(super) fn new(contact: &'a Contact) -> Self {
        let now = Station { slip: contact.slip, normal: contact.normal, ..Station::default() };
        let mut walk = Self {
            contact,
            slip: Slip::Open,
            now,
            normal_work: 0.0,
            tangential_work: 0.0,
            work_terms: 0.0,
            from_rest: contact.slip == 0.0,
            stopped: false,
            margin: f64::INFINITY,
        };
        walk.slip = if contact.slip > 0.0 {
            Slip::Forward
        } else if contact.slip < 0.0 {
            Slip::Backward
        } else {
            walk.slip_from_rest()
        };
        walk
    }

    /// Notes how clearly two magnitudes are told apart.
    fn decide(&mut self, a: f64, b: f64) {
        let sum = a + b;
        if sum > 0.0 && sum.is_finite() {
            self.margin = self.margin.min((a - b).abs() / sum);
        }
    }

    /// Stick where friction can hold, else slip the way a growing normal impulse alone pushes.
    fn slip_from_rest(&mut self) -> Slip {
        let c = self.contact;
        self.decide(c.w_tn.abs(), c.friction * c.w_tt);
        if c.w_tn.abs() <= c.friction * c.w_tt {
            Slip::Sticks
        } else if c.w_tn > 0.0 {
            Slip::Forward
        } else {
            Slip::Backward
        }
    }

    pub(super) fn rates(&self) -> Rates {
        let c = self.contact;
        match self.slip {
            Slip::Sticks => {
                let q = -c.w_tn / c.w_tt;
                Rates { slip: 0.0, normal: c.w_nn + c.w_tn * q, tangential_impulse: q }
            }
            Slip::Forward | Slip::Backward | Slip::Open => {
                let q = if self.slip == Slip::Backward { c.friction } else { -c.friction };
                Rates { slip: c.w_tn + c.w_tt * q, normal: c.w_nn + c.w_tn * q, tangential_impulse: q }
            }
        }
    }

    /// Normal impulse until the slip stops, where it does.
    fn until_slip_stops(&self, rates: &Rates) -> f64 {
        let (speed, toward_zero) = match self.slip {
            Slip::Forward => (self.now.slip, -rates.slip),
            Slip::Backward => (-self.now.slip, rates.slip),
            Slip::Sticks | Slip::Open => return f64::INFINITY,
        };
        // A slip that stops together with compression may stand at zero, or a rounding beyond it, and must not run on.
        if toward_zero > 0.0 { speed.max(0.0) / toward_zero } else { f64::INFINITY }
    }

    pub(super) fn compress(&mut self, observe: &mut impl FnMut(&Stage)) {
        loop {
            let rates = self.rates();
            let stop = self.until_slip_stops(&rates);
            let end = if rates.normal > 0.0 { -self.now.normal / rates.normal } else { f64::INFINITY };
            self.decide(stop, end);
            if stop < end {
                self.advance(Phase::Compression, stop, &rates, StageEnd::SlipStops(0), observe);
            } else {
                self.advance(Phase::Compression, end, &rates, StageEnd::CompressionEnds, observe);
                return;
            }
        }
    }

    pub(super) fn restitute(
        &mut self,
        law: Law,
        compression: &Compression,
        observe: &mut impl FnMut(&Stage),
    ) {
        let e = self.contact.restitution;
        if e <= 0.0 {
            return;
        }
        // What is left of the law's measure: counted down, since e² of a work is lost in its sum with that work where e is small.
        let mut impulse_left = e * compression.impulse;
        let mut work_left = -e * e * compression.work;
        let normal_at_end = -e * self.contact.normal;
        loop {
            let rates = self.rates();
            let stop = self.until_slip_stops(&rates);
            let u = self.now.normal;
            let end = match law {
                Law::Poisson => impulse_left,
                Law::Newton => (normal_at_end - u) / rates.normal,
                Law::Stronge => {
                    let root = (u * u + 2.0 * rates.normal * work_left).sqrt();
                    if root > 0.0 { 2.0 * work_left / (u + root) } else { 0.0 }
                }
            };
            self.decide(stop, end);
            if stop < end {
                self.advance(Phase::Restitution, stop, &rates, StageEnd::SlipStops(0), observe);
                impulse_left = (impulse_left - stop).max(0.0);
                work_left = (work_left - 0.5 * (u + self.now.normal) * stop).max(0.0);
            } else {
                self.advance(Phase::Restitution, end.max(0.0), &rates, StageEnd::RestitutionEnds, observe);
                return;
            }
        }
    }

    fn advance(
        &mut self,
        phase: Phase,
        by: f64,
        rates: &Rates,
        why: StageEnd,
        observe: &mut impl FnMut(&Stage),
    ) {
        let start = self.now;
        // What an event says is zero is exactly zero: the next stage asks whether it slips or approaches.
        let end = Station {
            normal_impulse: start.normal_impulse + by,
            tangential_impulse: start.tangential_impulse + rates.tangential_impulse * by,
            slip: if matches!(why, StageEnd::SlipStops(_)) { 0.0 } else { start.slip + rates.slip * by },
            normal: if matches!(why, StageEnd::CompressionEnds) {
                0.0
            } else {
                start.normal + rates.normal * by
            },
        };
        let normal_work = 0.5 * (start.normal + end.normal) * by;
        let tangential_work = 0.5 * (start.slip + end.slip) * rates.tangential_impulse * by;
        self.normal_work += normal_work;
        self.tangential_work += tangential_work;
        self.work_terms += normal_work.abs() + tangential_work.abs();
        observe(&Stage { phase, slip: self.slip, start, end, ended_by: why });
        self.now = end;
        if matches!(why, StageEnd::SlipStops(_)) {
            self.stopped = true;
            self.slip = self.slip_from_rest();
        }
    }

    pub(super) fn outcome(&self, kind: Option<ImpactType>, without_approach: bool) -> Outcome {
        let state = if self.now.normal > 0.0 {
            ContactState::Separates
        } else if self.now.slip == 0.0 && (self.slip == Slip::Sticks || kind.is_none()) {
            ContactState::Sticks
        } else {
            ContactState::Slips
        };
        let work = self.normal_work + self.tangential_work;
        let gained_energy = work > WORK_GAINED * self.work_terms;
        Outcome {
            normal_impulse: self.now.normal_impulse,
            tangential_impulse: self.now.tangential_impulse,
            slip: self.now.slip,
            normal: self.now.normal,
            normal_work: self.normal_work,
            tangential_work: self.tangential_work,
            kind,
            state,
            gained_energy,
            without_approach: without_approach && kind.is_some(),
            margin: self.margin,
        }
    }
}
