//! Stages whose slip has come to a direction that friction does not turn.

use super::curve::{CLOCK, Curve, State, WORK};
use super::leg::{Goal, Leg, StageEvent, Walked};
use crate::spatial::contacts::hodograph::turned_back_to;
use crate::tolerance::{NEAR_STOP, SETTLED_TURN};
use carom_num::elementary::{exp, sin_cos};

impl<const N: usize> Curve<'_, N> {
    /// The rest of a stage with one slip, which friction does not turn any more, and turns back where it goes beside: where friction is just about what would hold
    /// the contact, the slip changes so slowly there that no walk in steps comes to an end. `None` where it may turn.
    pub(super) fn straight_on(&self, y: &State<N>, rate: &State<N>) -> Option<Walked<N>> {
        let limit = SETTLED_TURN * self.leg.largest_response * self.leg.fastest;
        let mut tracked = self.tracked();
        let (Some(i), None) = (tracked.next(), tracked.next()) else { return None };
        let slip = exp(y[i][0]);
        if rate[i][1].abs() * slip > limit || slip < NEAR_STOP * self.leg.fastest || self.starts(i) {
            return None;
        }
        // No event: nothing is made zero yet.
        let here = self.walked(y, StageEvent::SlipStarts(0));
        let goal = match self.leg.goal {
            Goal::Clock(end) => Goal::Clock(end - y[0][CLOCK]),
            Goal::Work(left) => Goal::Work(std::array::from_fn(|i| left[i] - y[i][WORK + 1])),
            absolute => absolute,
        };
        let mut leg = Leg { direction: self.directions(y), goal, ..*self.leg };
        let theta = turned_back_to(y[i][1], |by| {
            let mut beside = leg;
            let (sin, cos) = sin_cos(y[i][1] + by);
            beside.direction[i] = [cos, sin];
            let response = beside.pace(&beside.direction)?.response[i];
            Some(cos * response.y - sin * response.x)
        })?;
        let (sin, cos) = sin_cos(theta);
        leg.direction[i] = [cos, sin];
        let now = leg.pace(&leg.direction)?;
        let rest = leg.go_straight(&here.place, &now)?;
        let work = std::array::from_fn(|i| std::array::from_fn(|k| here.work[i][k] + rest.work[i][k]));
        Some(Walked { work, clock: here.clock + rest.clock, ..rest })
    }
}
