//! A slip that starts smoothly: a contact that comes to the edge of its friction cone while others turn.
//!
//! Its slip then grows from nothing as the square of the impulse, and meanwhile its direction follows the one that friction does not turn. On the
//! clock of a slip that is nearly nothing this takes for ever, so the onset is walked in short steps of normal impulse by the trapezoidal rule, the
//! direction implicit: `g(θ) = s dθ/dN` at the end of each step.
//!
//! So is a slip whose start is steep: friction turns it back to its direction, or away from it, much faster than it grows. Away from it rounding would grow
//! faster than the slip, and the walk would leave the one direction in which the slip starts; back to it steps would be short.
//!
//! It is of second order: an impact with such an onset is known to about 1e-8.

use super::curve::{CLOCK, Curve, IMPULSE, State, WORK};
use super::leg::Pace;
use crate::tolerance::{
    ONSET_ARRIVED, ONSET_DIFFERENCE, ONSET_STEP, SMOOTH_START, STARTED, TURNED_AWAY, TURNED_BACK,
};
use carom_num::elementary::{atan2, ln, sin_cos};

/// Steps of an onset, at most.
const MOST_ONSET: u32 = 20_000;
/// Shorter steps that are tried where something happens within it.
const MOST_HALVINGS: u32 = 8;
/// Newton's steps to the direction.
const MOST_STEPS: u32 = 20;

impl<const N: usize> Curve<'_, N> {
    /// The one contact whose slip starts, where it starts smoothly.
    pub(super) fn starts_at_edge(&self, now: &Pace<N>) -> Option<usize> {
        let mut starting = self.tracked().filter(|&i| self.starts(i));
        let (Some(i), None) = (starting.next(), starting.next()) else { return None };
        let [e_x, e_y] = self.leg.direction[i];
        let growth = e_x * now.response[i].x + e_y * now.response[i].y;
        (growth <= SMOOTH_START * self.leg.largest_response).then_some(i)
    }

    /// The one contact whose slip starts where friction turns it much faster than it grows.
    fn starts_steeply(&self, y: &State<N>, now: &Pace<N>) -> Option<usize> {
        let mut starting = self.tracked().filter(|&i| self.starts(i));
        let (Some(i), None) = (starting.next(), starting.next()) else { return None };
        let aside = |theta: f64| {
            let mut at = *y;
            at[i][1] = theta;
            let w = self.leg.pace(&self.directions(&at))?.response[i];
            let (sin, cos) = sin_cos(theta);
            Some(cos * w.y - sin * w.x)
        };
        let theta = y[i][1];
        let turns =
            (aside(theta + ONSET_DIFFERENCE)? - aside(theta - ONSET_DIFFERENCE)?) / (2.0 * ONSET_DIFFERENCE);
        let [e_x, e_y] = self.leg.direction[i];
        let growth = e_x * now.response[i].x + e_y * now.response[i].y;
        (turns > TURNED_AWAY * growth || turns < -TURNED_BACK * growth).then_some(i)
    }

    /// The state after the onset of the one slip that starts smoothly or steeply; `None` where none does.
    pub(super) fn onset(&self, y: &State<N>, now: &Pace<N>) -> Option<State<N>> {
        let i = self.starts_at_edge(now).or_else(|| self.starts_steeply(y, now))?;
        let (mut y, mut now, mut any) = (*y, *now, false);
        y[i][0] = f64::NEG_INFINITY;
        // The others turn meanwhile, a slow slip faster than a fast one.
        let others = self.tracked().filter(|&j| j != i).map(|j| self.speed(&y, j));
        let scale = others.fold(self.leg.fastest, f64::min);
        let whole = ONSET_STEP * scale / self.leg.largest_response;
        for _ in 0..MOST_ONSET {
            let mut lengths = (0..MOST_HALVINGS).scan(whole, |length, _| {
                *length *= 0.25;
                Some(4.0 * *length)
            });
            let Some(end) = lengths.find_map(|length| self.stepped(&y, &now, i, length)) else { break };
            (y, any) = (end, true);
            if self.speed(&y, i) > STARTED * scale {
                break;
            }
            now = self.leg.pace(&self.directions(&y))?;
        }
        any.then_some(y)
    }

    /// The state after a normal impulse of this length, unless something happens before.
    fn stepped(&self, y: &State<N>, now: &Pace<N>, i: usize, length: f64) -> Option<State<N>> {
        let mut end = *y;
        for j in self.tracked().filter(|&j| j != i) {
            let (sin, cos) = sin_cos(y[j][1]);
            let (w, speed) = (now.response[j], self.speed(y, j));
            end[j][1] += length * (cos * w.y - sin * w.x) / speed;
        }
        let after = self.turned(&mut end, now, i, length)?;
        let direction = self.directions(&end);
        let mean = |a: f64, b: f64| 0.5 * length * (a + b);
        let normal = self.normal(y);
        for j in self.leg.contacts() {
            let (p, q) = (now.rates[j], after.rates[j]);
            end[j][IMPULSE] += mean(p.x, q.x);
            end[j][IMPULSE + 1] += mean(p.y, q.y);
            end[j][IMPULSE + 2] += mean(p.z, q.z);
            end[j][WORK + 1] +=
                mean(p.z, q.z) * (normal[j] + 0.25 * length * (now.response[j].z + after.response[j].z));
        }
        end[0][CLOCK] += mean(now.clock, after.clock);
        // Slips from the impulse, so that they belong to it.
        let tangential = self.tangential(&end);
        for j in self.tracked() {
            let ([ux, uy], [x, y_e]) = (tangential[j], direction[j]);
            // Of a slip that is nearly nothing the impulse tells the speed, but not the direction.
            let along = ux * x + uy * y_e;
            if along <= 0.0 || along.is_nan() {
                return None;
            }
            let (speed, theta) =
                if j == i { (along, end[j][1]) } else { ((ux * ux + uy * uy).sqrt(), atan2(uy, ux)) };
            let mean_slip = 0.5 * (speed + self.speed(y, j));
            let (p, q) = (now.rates[j], after.rates[j]);
            end[j][WORK] += mean_slip * (x * mean(p.x, q.x) + y_e * mean(p.y, q.y));
            (end[j][0], end[j][1]) = (ln(speed), theta);
        }
        self.nothing_happens(&end).then_some(end)
    }

    /// Turns contact i as far as its slip at the end of the step allows: where that is nearly nothing, into the direction that friction does not turn.
    fn turned(&self, y: &mut State<N>, before: &Pace<N>, i: usize, length: f64) -> Option<Pace<N>> {
        let (start, speed) = (y[i][1], self.speed(y, i));
        let (sin, cos) = sin_cos(start);
        let growth = cos * before.response[i].x + sin * before.response[i].y;
        let aside = |theta: f64| {
            let mut at = *y;
            at[i][1] = theta;
            let w = self.leg.pace(&self.directions(&at))?.response[i];
            let (sin, cos) = sin_cos(theta);
            let slip = speed + 0.5 * length * (growth + cos * w.x + sin * w.y);
            Some(cos * w.y - sin * w.x - slip * (theta - start) / length)
        };
        let mut theta = start;
        for _ in 0..MOST_STEPS {
            let slope = (aside(theta + ONSET_DIFFERENCE)? - aside(theta - ONSET_DIFFERENCE)?)
                / (2.0 * ONSET_DIFFERENCE);
            let step = aside(theta)? / slope;
            if !step.is_finite() {
                return None;
            }
            theta -= step.clamp(-0.1, 0.1);
            if step.abs() <= ONSET_ARRIVED {
                break;
            }
        }
        y[i][1] = theta;
        self.leg.pace(&self.directions(y))
    }
}
