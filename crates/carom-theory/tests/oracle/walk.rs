//! Routh's walk from event to event, in double-double, without any knowledge of classes or closed forms.

use super::double::Double;
use carom_theory::single_contact::{Contact, Law};

#[derive(Clone, Copy, Debug)]
pub struct Walked {
    pub tangential: Double,
    pub normal: Double,
    pub slip: Double,
    pub rise: Double,
    /// Works of the normal impulse in compression and restitution, and of the tangential one.
    pub work: [Double; 3],
    /// Slip stopped in this phase (0 compression, 1 restitution).
    pub stopped: Option<usize>,
}

struct Walker {
    w: [Double; 3],
    friction: Double,
    at: Walked,
    rest: bool,
}

impl Walker {
    /// d(p_t)/d(p_n) of the leg that starts here.
    fn tangential_rate(&self) -> Double {
        let [tt, tn, _] = self.w;
        if !self.rest {
            if self.at.slip.is_positive() { -self.friction } else { self.friction }
        } else if tn.abs() <= self.friction * tt {
            -tn / tt
        } else if tn.is_positive() {
            -self.friction
        } else {
            self.friction
        }
    }

    /// Rates of slip and rise.
    fn rates(&self) -> (Double, Double, Double) {
        let [tt, tn, nn] = self.w;
        let q = self.tangential_rate();
        let sticks = self.rest && tn.abs() <= self.friction * tt;
        let slip = if sticks { Double::ZERO } else { tt * q + tn };
        (q, slip, tn * q + nn)
    }

    fn to_slip_stop(&self) -> Option<Double> {
        let (_, slip, _) = self.rates();
        let closing = (self.at.slip.is_positive() && slip.is_negative())
            || (self.at.slip.is_negative() && slip.is_positive());
        (!self.rest && closing).then(|| -self.at.slip / slip)
    }

    /// Goes `by` of normal impulse on, and books the work of this phase.
    fn go(&mut self, by: Double, phase: usize) {
        let (q, slip, rise) = self.rates();
        let (old_slip, old_rise) = (self.at.slip, self.at.rise);
        self.at.slip = old_slip + slip * by;
        self.at.rise = old_rise + rise * by;
        self.at.normal = self.at.normal + by;
        self.at.tangential = self.at.tangential + q * by;
        let half = Double::from(0.5) * by;
        self.at.work[phase] = self.at.work[phase] + half * (old_rise + self.at.rise);
        self.at.work[2] = self.at.work[2] + half * q * (old_slip + self.at.slip);
    }

    /// Walks until `remaining` of the phase is 0, stopping where the slip stops.
    fn phase(&mut self, phase: usize, remaining: impl Fn(&Self) -> Option<Double>) {
        loop {
            let end = remaining(self);
            match self.to_slip_stop() {
                Some(stop) if end.is_none_or(|end| stop < end) => {
                    self.go(stop, phase);
                    self.at.slip = Double::ZERO;
                    self.at.stopped = Some(phase);
                    self.rest = true;
                }
                _ => {
                    if let Some(end) = end {
                        self.go(end, phase);
                    }
                    return;
                }
            }
        }
    }
}

pub fn walk(contact: &Contact, law: Law) -> Walked {
    let d = Double::from;
    let at = Walked {
        tangential: Double::ZERO,
        normal: Double::ZERO,
        slip: d(contact.slip),
        rise: d(contact.approach),
        work: [Double::ZERO; 3],
        stopped: None,
    };
    let w = [d(contact.w.tt), d(contact.w.tn), d(contact.w.nn)];
    let mut walker = Walker { w, friction: d(contact.friction), at, rest: contact.slip == 0.0 };
    let (_, _, rise) = walker.rates();
    if contact.approach > 0.0 || (contact.approach == 0.0 && (walker.rest || !rise.is_negative())) {
        return walker.at;
    }
    walker.phase(0, |here| {
        let (_, _, rise) = here.rates();
        rise.is_positive().then(|| -here.at.rise / rise)
    });
    walker.at.rise = Double::ZERO;
    let (compressed, taken, e) = (walker.at.normal, -walker.at.work[0], d(contact.restitution));
    let approach = d(-contact.approach);
    walker.phase(1, |here| {
        let (_, _, rise) = here.rates();
        Some(match law {
            Law::Poisson => (d(1.0) + e) * compressed - here.at.normal,
            Law::Newton => (e * approach - here.at.rise) / rise,
            Law::Stronge => {
                let left = e * e * taken - here.at.work[1];
                let final_rise = (here.at.rise * here.at.rise + (rise + rise) * left).sqrt();
                (final_rise - here.at.rise) / rise
            }
        })
    });
    walker.at
}
