//! A stage on which slips turn.
//!
//! With N the sum of all normal impulses, a slip of speed sᵢ and direction θᵢ obeys `dsᵢ/dN = fᵢ(θ)`, `sᵢ dθᵢ/dN = gᵢ(θ)`, singular where a slip
//! stops. With the clock σ,
//! `dN = ρ dσ` and `1/ρ = Σ 1/sᵢ`, it is not:
//!
//! ```text
//! d ln sᵢ/dσ = (ρ/sᵢ) fᵢ(θ),   dθᵢ/dσ = (ρ/sᵢ) gᵢ(θ),   0 < ρ/sᵢ ≤ 1
//! ```
//!
//! The slip that is about to stop turns by itself, and meanwhile the others stand still. One contact has ρ = s, the clock of [`hodograph`](crate::spatial::contacts::hodograph).
//!
//! Every inequality of the hypothesis is an event function of a [`Course`].

use super::leg::{Goal, Leg, Pace, Place, StageEvent, Walked};
use super::watch::{OF_CONTACT, Watch};
use crate::ImpactError;
use crate::spatial::rates::answer::Mode;
use crate::tolerance::{
    BIRTH, CURVE_NOISE, CURVE_SHORT, CURVE_STEP_ERROR, FALLEN, NEAR_STOP, NEUTRAL, SETTLED_FALL, STANDING,
    STOPPED,
};
use carom_num::Vec3;
use carom_num::course::{self, Course, Found, Lost, Stop, placed};
use carom_num::elementary::{atan2, exp, ln, sin_cos};
use carom_num::falls::first_fall;
use carom_num::ode8::{Step, Vector};

/// Of each contact: ln s, θ, the three impulses, work of tangential and normal impulse; the clock is the first contact's last number.
pub(super) type State<const N: usize> = [[f64; 8]; N];
/// Where the parts of a state are.
pub(super) const IMPULSE: usize = 2;
pub(super) const WORK: usize = 5;
pub(super) const CLOCK: usize = 7;

/// The first step, by what slips turn and change at most.
const LENGTH: f64 = 0.05;
/// Steps after which a stage is given up.
const MOST_STEPS: usize = 20_000;

/// A curve in polar coordinates of the slips.
pub(super) struct Curve<'a, const N: usize> {
    pub(super) leg: &'a Leg<'a, N>,
    pub(super) start: &'a Place<N>,
    /// Added to event functions that start at their edge.
    pub(super) lift: Watch<N>,
    /// A slip that starts at the edge of its cone, and below which ln s it has not started.
    edge: Option<(usize, f64)>,
}

impl<const N: usize> Leg<'_, N> {
    /// Follows the slips to the first event.
    ///
    /// # Errors
    /// [`ImpactError::Unending`] where there is none.
    pub(super) fn go_curved(&self, from: &Place<N>, now: &Pace<N>) -> Result<Walked<N>, ImpactError> {
        let mut curve = Curve { leg: self, start: from, lift: Watch::NONE, edge: None };
        let first = curve.state(now);
        if let Some(i) = self.owes_nothing() {
            return Ok(curve.walked(&first, StageEvent::Repaid(i)));
        }
        let unending = ImpactError::Unending { stages: MOST_STEPS };
        curve.lift = curve.watch(&first).ok_or(unending)?.lift();
        let onset = curve.onset(&first, now);
        let edge = if onset.is_none() { curve.starts_at_edge(now) } else { None };
        let first = onset.unwrap_or(first);
        curve.edge = edge.map(|i| (i, first[i][0] - FALLEN));
        let rate = curve.rate(&first);
        match course::follow(&mut curve, (first, rate), self.first_length(), MOST_STEPS)
            .map_err(|_| unending)?
        {
            Stop::Event { event, .. } => Ok(curve.walked(&event.y, curve.event(event.event))),
            Stop::End(walked) => Ok(walked),
        }
    }

    /// How far it is to a goal of the clock, at this rate.
    fn until_clock_ends(&self, y: &State<N>, rate: &State<N>) -> f64 {
        match self.goal {
            Goal::Clock(end) if rate[0][CLOCK] > 0.0 => (end - y[0][CLOCK]) / rate[0][CLOCK],
            _ => f64::INFINITY,
        }
    }

    fn first_length(&self) -> f64 {
        LENGTH / (self.largest_response * (1.0 + self.roughest()))
    }

    fn roughest(&self) -> f64 {
        self.set.friction[..self.set.count].iter().fold(0.0, |m: f64, mu| m.max(*mu))
    }
}

impl<const N: usize> Course for Curve<'_, N> {
    type Y = State<N>;
    /// The function that falls, as [`Watch`] counts them.
    type Event = usize;
    type End = Walked<N>;

    fn rate(&mut self, y: &State<N>) -> State<N> {
        let mut out = [[0.0; 8]; N];
        let direction = self.directions(y);
        let Some(now) = self.leg.pace(&direction) else { return [[f64::NAN; 8]; N] };
        let mut speed = [f64::INFINITY; N];
        self.tracked().for_each(|i| speed[i] = exp(y[i][0]));
        let least = speed.iter().copied().fold(f64::INFINITY, f64::min);
        let sum: f64 = speed.iter().map(|own| least / own).sum();
        let rho = least / sum;
        let normal = self.normal(y);
        for i in self.leg.contacts() {
            let (p, w) = (now.rates[i], now.response[i]);
            out[i][IMPULSE] = rho * p.x;
            out[i][IMPULSE + 1] = rho * p.y;
            out[i][IMPULSE + 2] = rho * p.z;
            out[i][WORK + 1] = rho * p.z * normal[i];
            if self.leg.is_tracked(i) {
                let ([x, y_e], share) = (direction[i], least / speed[i] / sum);
                out[i][0] = share * (x * w.x + y_e * w.y);
                out[i][1] = share * (x * w.y - y_e * w.x);
                out[i][WORK] = rho * speed[i] * (x * p.x + y_e * p.y);
            }
        }
        out[0][CLOCK] = rho * now.clock;
        out
    }

    fn first_event(&mut self, step: &Step<State<N>>) -> Result<Option<Found<usize>>, Lost> {
        let fall = first_fall(&mut |x| self.lifted(&step.at(x)));
        Ok(fall.map(|fall| placed(self, step, fall.of, fall.at)))
    }

    fn value(&mut self, event: &usize, _: f64, y: &State<N>) -> f64 {
        self.lifted(y).at(*event)
    }

    fn end(&mut self, y: &State<N>, rate: &State<N>) -> Option<Walked<N>> {
        let fallen = || self.edge.filter(|&(i, least)| y[i][0] < least).map(|(i, _)| i);
        if let Some(i) = self.stopped(y).or_else(fallen) {
            return Some(self.walked(y, StageEvent::SlipStops(i)));
        }
        if let Some((i, end)) = self.stops_straight(y, rate) {
            return Some(self.walked(&end, StageEvent::SlipStops(i)));
        }
        let stands = || self.stands(y, rate).map(|i| self.walked(y, StageEvent::SlipStops(i)));
        self.straight_on(y, rate).or_else(stands)
    }

    fn pace(&self, y: &State<N>, rate: &State<N>) -> course::Pace<State<N>> {
        let first = self.leg.first_length();
        let impulse = self.leg.fastest / self.leg.largest_response;
        let work = impulse * self.leg.fastest;
        let scales = [1.0, 1.0, impulse, impulse, impulse, work, work, 1.0];
        let tolerance = [scales.map(|scale| CURVE_STEP_ERROR * scale); N];
        course::Pace {
            // What comes beyond the goal is noise of what comes before it.
            longest: 2.0 * self.leg.until_clock_ends(y, rate),
            noise: Some([CURVE_SHORT * first, CURVE_NOISE]),
            ..course::Pace::within(tolerance)
        }
    }
}

impl<const N: usize> Curve<'_, N> {
    pub(super) fn tracked(&self) -> impl Iterator<Item = usize> + '_ {
        self.leg.contacts().filter(|&i| self.leg.is_tracked(i))
    }

    fn state(&self, now: &Pace<N>) -> State<N> {
        let mut y = [[0.0; 8]; N];
        for i in self.leg.contacts() {
            let p = self.start.at.impulse[i];
            // Work is that of the stage: what is left of a debt is no difference of totals.
            y[i] = [0.0, 0.0, p.x, p.y, p.z, 0.0, 0.0, 0.0];
        }
        // Slips that start together start in proportion to how fast they grow.
        let growth = |i: usize| {
            let ([x, y], w) = (self.leg.direction[i], now.response[i]);
            (x * w.x + y * w.y).max(0.0)
        };
        let starting = || self.tracked().filter(|&i| self.starts(i));
        let fastest = starting().map(growth).fold(0.0, f64::max);
        for i in self.tracked() {
            let (u, [x, e_y]) = (self.start.at.velocity[i], self.leg.direction[i]);
            let speed = if self.starts(i) {
                // At the edge of its cone a slip may grow by less than nothing, but for rounding: that is no proportion.
                let share = if fastest > 0.0 { growth(i) / fastest } else { 1.0 };
                BIRTH * self.leg.fastest * share
            } else {
                (u.x * u.x + u.y * u.y).sqrt()
            };
            (y[i][0], y[i][1]) = (ln(speed), atan2(e_y, x));
        }
        y
    }

    /// A slip that has come to nothing.
    fn stopped(&self, y: &State<N>) -> Option<usize> {
        let least = ln(STOPPED * self.leg.fastest);
        self.tracked().find(|&i| y[i][0] <= least)
    }

    /// A small slip that falls and hardly turns any more goes straight to its stop, if nothing else happens before: where slips turn fast and stop
    /// slowly, steps would be many.
    fn stops_straight(&self, y: &State<N>, rate: &State<N>) -> Option<(usize, State<N>)> {
        let small = ln(NEAR_STOP * self.leg.fastest);
        let settled =
            |i: usize| y[i][0] <= small && rate[i][0] < 0.0 && rate[i][1].abs() <= -SETTLED_FALL * rate[i][0];
        let i = self.tracked().find(|&i| settled(i))?;
        let more = -1.0 / rate[i][0];
        let moves = |j: usize| more * rate[j][0].abs().max(rate[j][1].abs()) > SETTLED_FALL;
        if self.tracked().any(|j| j != i && moves(j)) {
            return None;
        }
        let mut end: State<N> = std::array::from_fn(|j| {
            std::array::from_fn(|k| if j == i && k < IMPULSE { y[j][k] } else { y[j][k] + more * rate[j][k] })
        });
        // The slip falls steadily to nothing.
        end[i][WORK] -= 0.5 * more * rate[i][WORK];
        self.nothing_happens(&end).then_some((i, end))
    }

    /// The slowest of small slips that neither turn nor change any more: friction holds them, and nothing would ever end the stage.
    fn stands(&self, y: &State<N>, rate: &State<N>) -> Option<usize> {
        let still = |i: usize| rate[i][0].abs() <= NEUTRAL && rate[i][1].abs() <= NEUTRAL;
        let slowest = self.tracked().min_by(|&i, &j| y[i][0].total_cmp(&y[j][0]))?;
        let stands = y[slowest][0] <= ln(STANDING * self.leg.fastest) && self.tracked().all(still);
        stands.then_some(slowest)
    }

    /// True where no event function has fallen yet.
    pub(super) fn nothing_happens(&self, y: &State<N>) -> bool {
        let watch = self.lifted(y);
        (0..Watch::<N>::COUNT).all(|i| watch.at(i) > 0.0)
    }

    pub(super) fn directions(&self, y: &State<N>) -> [[f64; 2]; N] {
        let mut direction = self.leg.direction;
        for i in self.tracked() {
            let (sin, cos) = sin_cos(y[i][1]);
            direction[i] = [cos, sin];
        }
        direction
    }

    /// True where the slip of contact i starts with the stage.
    pub(super) fn starts(&self, i: usize) -> bool {
        self.leg.guess[i].mode == Mode::Starts
    }

    pub(super) fn speed(&self, y: &State<N>, i: usize) -> f64 {
        exp(y[i][0])
    }

    /// Slips, from the impulse.
    pub(super) fn tangential(&self, y: &State<N>) -> [[f64; 2]; N] {
        let impulse = self.impulse(y);
        let by: [Vec3; N] = std::array::from_fn(|i| impulse[i] - self.start.at.impulse[i]);
        let moved = self.leg.set.responses(&by);
        std::array::from_fn(|i| {
            let u = self.start.at.velocity[i];
            [u.x + moved[i].x, u.y + moved[i].y]
        })
    }

    fn impulse(&self, y: &State<N>) -> [Vec3; N] {
        std::array::from_fn(|i| Vec3::new(y[i][IMPULSE], y[i][IMPULSE + 1], y[i][IMPULSE + 2]))
    }

    /// Normal velocities.
    pub(super) fn normal(&self, y: &State<N>) -> [f64; N] {
        let impulse = self.impulse(y);
        let by: [Vec3; N] = std::array::from_fn(|i| impulse[i] - self.start.at.impulse[i]);
        let moved = self.leg.set.responses(&by);
        std::array::from_fn(|i| {
            let start = self.start.at.velocity[i].z;
            // What is held at rest stays there: rounding of its impulses would do work.
            if start == 0.0 && self.leg.guess[i].holds { 0.0 } else { start + moved[i].z }
        })
    }

    /// The event of a function, as [`Watch`] counts them.
    fn event(&self, function: usize) -> StageEvent {
        let Some(of) = function.checked_sub(2) else {
            return if function == 0 { self.leg.end() } else { StageEvent::DrivenIn };
        };
        let contact = of / OF_CONTACT;
        match of % OF_CONTACT {
            0 => StageEvent::Closes(contact),
            1 => StageEvent::Opens(contact),
            2 => StageEvent::SlipStarts(contact),
            3 => StageEvent::Loads(contact),
            _ => StageEvent::Repaid(contact),
        }
    }

    /// Where the curve has come to.
    pub(super) fn walked(&self, y: &State<N>, event: StageEvent) -> Walked<N> {
        let mut place = *self.start;
        place.at.impulse = self.impulse(y);
        let work: [[f64; 2]; N] = std::array::from_fn(|i| [y[i][WORK], y[i][WORK + 1]]);
        for (total, stage) in place.work.iter_mut().flatten().zip(work.iter().flatten()) {
            *total += stage;
        }
        let (clock, direction) = (y[0][CLOCK], self.directions(y));
        self.leg.settle(self.start, &mut place, clock, |i| (exp(y[i][0]), direction[i], false));
        // A slip that stops as it turns into the paradox has stopped: what it does then is asked anew.
        let still = |i: &usize| (place.at.velocity[*i].x, place.at.velocity[*i].y) == (0.0, 0.0);
        let event = match self.tracked().find(still) {
            Some(i) if event == StageEvent::DrivenIn => StageEvent::SlipStops(i),
            _ => event,
        };
        self.leg.mark(&mut place, event);
        Walked { place, clock, work, event }
    }
}
