//! One end strikes the lower plate, without restitution: Routh's construction in closed form.
//!
//! Source: Routh, Dynamics of a System of Rigid Bodies (1860); Wang and Mason, J. Appl. Mech. 59 (1992) 635.

use crate::answer::{KAPPA, Uncovered};
use crate::plate::OnEnd;
use crate::tolerance::{NO_APPROACH, ZERO};

/// The rod at the moment one of its ends touches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strike {
    pub(crate) time: f64,
    /// How long it flew.
    pub(crate) lasted: f64,
    pub(crate) end: f64,
    pub(crate) c: f64,
    pub(crate) s: f64,
    pub(crate) w: f64,
    /// Where the end is along the plate.
    pub(crate) x: f64,
    pub(crate) vx: f64,
    pub(crate) vy: f64,
}

impl Strike {
    /// Velocity of the end that touches: along the plate and out of it.
    pub(crate) fn velocity(&self) -> (f64, f64) {
        (self.vx + self.s * self.w, self.vy - self.c * self.w)
    }

    /// The rod after the strike: its end stays on the plate, or is about to leave it.
    pub(crate) fn after(&self, friction: f64) -> Result<OnEnd, Uncovered> {
        let (c, s) = (self.c, self.s);
        let (tt, nn, tn) = (1.0 + KAPPA * s * s, 1.0 + KAPPA * c * c, -KAPPA * c * s);
        let (ut, un) = self.velocity();
        if un >= -NO_APPROACH || ut.abs() < ZERO {
            return Err(Uncovered::Tie);
        }
        let q = ut.signum();
        let drag = q * friction;
        let (lift, brake) = (nn - drag * tn, q * (tn - drag * tt));
        if lift <= 0.0 {
            return Err(Uncovered::Jams);
        }
        let whole = -un / lift;
        let stops = -ut.abs() / brake;
        let (pn, pt, u) = if brake >= 0.0 || stops > whole {
            (whole, -drag * whole, ut + q * brake * whole)
        } else {
            // The slip stops before the approach is over. Friction holds the end from then on where it can; else the slip turns round.
            let left = un + lift * stops;
            if tn.abs() <= friction * tt {
                let more = -left / (nn - tn * tn / tt);
                (stops + more, -drag * stops - tn / tt * more, 0.0)
            } else {
                let drag_after = tn.signum() * friction;
                let more = -left / (nn - drag_after * tn);
                (stops + more, -drag * stops - drag_after * more, (tn - drag_after * tt) * more)
            }
        };
        let w = self.w + KAPPA * (s * pt - c * pn);
        Ok(OnEnd { time: self.time, end: self.end, c, s, w, u, x: self.x })
    }
}
