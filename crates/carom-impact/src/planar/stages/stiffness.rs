//! Sharing by stiffness ratio: every contact a spring `F = k δ^η`, in the limit of stiff ones, where only the ratios of k count.
//!
//! Loading stores the energy `k δ^(η+1)/(η+1)`; unloading returns e² of it, so that δ falls at `u_n/e²` while the contact opens
//! at `u_n`. Friction is Coulomb's at every instant, sticking contacts hold by the rate problem. Time stands for the path only: stiffness and time
//! scale out together.
//!
//! Source: Liu, Zhao and Brogliato, Proc. R. Soc. A 464 (2008) 3193: their distributing law `dP_j/dP_i` is the ratio of these forces.

use super::sharing::{settle_states, untouched};
use super::staged::StagedOutcome;
use crate::Load;
use crate::error::{outside, require};
use crate::planar::contacts::names::Slip;
use crate::planar::contacts::set::ContactSet;
use crate::planar::contacts::set::MOST_CONTACTS;
use crate::planar::rates::answer::Guess;
use crate::planar::rates::rate::RateProblem;
use crate::tolerance::{
    RANK, SPRING_CONE, SPRING_GAIN, SPRING_REST, SPRING_SHORTEST, SPRING_SOON, SPRING_STEP_ERROR,
    SPRING_STILL,
};
use crate::{ImpactError, Law};
use carom_num::course::{self, Course, Found, Lost, Pace, Stop, placed};
use carom_num::elementary::pow;
use carom_num::falls::first_fall;
use carom_num::ode8::{Step, Vector};

/// Impulses (t, n), spring, and work (t, n) of up to six contacts.
const STATE: usize = 5 * MOST_CONTACTS;
type State = [f64; STATE];
/// Where the parts of a state begin.
const NORMAL: usize = MOST_CONTACTS;
const SPRING: usize = 2 * MOST_CONTACTS;
const WORK_T: usize = 3 * MOST_CONTACTS;
const WORK_N: usize = 4 * MOST_CONTACTS;

/// Events after which the springs are given up.
const MOST_EVENTS: usize = 20_000;
/// The first step, in the duration of an impact.
const FIRST_STEP: f64 = 0.01;
/// Event functions of a contact.
const OF_CONTACT: usize = 4;
/// Restitution below which a spring would have to let go faster than can be followed.
const LEAST_RESTITUTION: f64 = 0.01;

/// What every contact does until the next event.
#[derive(Clone, Copy)]
struct Mode<const N: usize> {
    /// It is loaded, or about to be.
    active: [bool; N],
    loading: [bool; N],
    guess: [Guess; N],
    /// Slips at its start.
    slip: [f64; N],
}

struct Springs<'a, const N: usize, const M: usize> {
    set: &'a ContactSet<N, M>,
    stiffness: [f64; N],
    exponent: f64,
    fastest: f64,
    /// Duration of the stiffest contact's own impact: the unit of time.
    time: f64,
}

/// The springs from one event to the next.
struct Leg<'s, const N: usize, const M: usize> {
    springs: &'s Springs<'s, N, M>,
    mode: Mode<N>,
}

/// Resolves an impact whose contacts share it as springs of these stiffnesses (only their ratios count) and this exponent (1: linear, 1.5: Hertz).
///
/// # Errors
/// As [`staged::resolve`](super::staged::resolve), and [`ImpactError::OutsideDomain`] unless stiffnesses are above 0, the exponent is 1 to
/// 3, and restitutions are at least 0.01: a spring that returns nothing would let go at once.
///
/// # Limits
/// Velocities to about 1e-9 of the largest. Energy e² is returned, so that one contact without friction restitutes e.
/// Springs of contacts that wedge a body may stay loaded, as friction holds them: the impact ends where nothing moves any more, and impulses are
/// those until then.
///
/// # Example
/// One ball, whatever its spring: half of 2 m/s comes back.
/// ```
/// use carom_impact::planar::{Block, ContactSet, stiffness::by_stiffness};
/// let ball = ContactSet::<1, 2> {
///     count: 1, operator: [[Block { tt: 3.5, tn: 0.0, nt: 0.0, nn: 1.0 }]],
///     slip: [0.0], normal: [-2.0], friction: [0.3], restitution: [0.5],
/// };
/// let [[_, up]] = by_stiffness(&ball, &[1e6], 1.5)?.velocity;
/// assert!((up - 1.0).abs() < 1e-8);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn by_stiffness<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    stiffness: &[f64; N],
    exponent: f64,
) -> Result<StagedOutcome<N>, ImpactError> {
    set.check()?;
    require(set.count <= MOST_CONTACTS, || ImpactError::TooMany { count: set.count, most: MOST_CONTACTS })?;
    require((1.0..=3.0).contains(&exponent), || outside(None, "exponent", exponent, "1 to 3"))?;
    for i in 0..set.count {
        let (k, e) = (stiffness[i], set.restitution[i]);
        require(k > 0.0 && k.is_finite(), || outside(Some(i), "stiffness", k, "> 0"))?;
        require(e >= LEAST_RESTITUTION, || {
            outside(Some(i), "restitution", e, "0.01 to 1 for sharing by stiffness")
        })?;
    }
    let mut out = untouched(set, Law::Stronge);
    let fastest = out.velocity[..set.count].iter().flatten().fold(0.0, |m: f64, u| m.max(u.abs()));
    if (0..set.count).all(|i| set.normal[i] >= -SPRING_STILL * fastest) {
        settle_states(&mut out, set.count);
        return Ok(out);
    }
    let springs = Springs::new(set, stiffness, exponent, fastest);
    let end = springs.run()?;
    let scale = fastest * fastest / set.operator[0][0].nn;
    for i in 0..set.count {
        let [u_t, u_n] = springs.velocity(&end, i);
        // Steps do not end in exact zeros, but states are read from them.
        let rest = |u: f64| if u.abs() <= SPRING_REST * fastest { 0.0 } else { u };
        out.velocity[i] = [rest(u_t), rest(u_n).max(0.0)];
        out.impulse[i] = [end[i], end[NORMAL + i]];
        out.work[i] = [end[WORK_T + i], end[WORK_N + i]];
    }
    out.gained_energy = out.work[..set.count].iter().flatten().sum::<f64>() > SPRING_GAIN * scale;
    settle_states(&mut out, set.count);
    Ok(out)
}

impl<'a, const N: usize, const M: usize> Springs<'a, N, M> {
    fn new(set: &'a ContactSet<N, M>, stiffness: &[f64; N], exponent: f64, fastest: f64) -> Self {
        let largest = stiffness[..set.count].iter().fold(0.0, |m: f64, k| m.max(*k));
        let stiffness = stiffness.map(|k| k / largest);
        // Deepest spring of a contact alone: W k z^(η+1)/(η+1) = u²/2.
        let nn = (0..set.count).map(|i| set.operator[i][i].nn).fold(f64::INFINITY, f64::min);
        let deepest = pow(0.5 * (exponent + 1.0) * fastest * fastest / nn, 1.0 / (exponent + 1.0));
        Self { set, stiffness, exponent, fastest, time: deepest / fastest }
    }

    fn velocity(&self, y: &State, i: usize) -> [f64; 2] {
        let mut u = [self.set.slip[i], self.set.normal[i]];
        for j in 0..self.set.count {
            let b = &self.set.operator[i][j];
            u[0] += b.tt * y[j] + b.tn * y[NORMAL + j];
            u[1] += b.nt * y[j] + b.nn * y[NORMAL + j];
        }
        u
    }

    fn force(&self, z: f64, i: usize) -> f64 {
        if z <= 0.0 {
            0.0
        } else if self.exponent == 1.0 {
            self.stiffness[i] * z
        } else {
            self.stiffness[i] * pow(z, self.exponent)
        }
    }

    fn problem(&self, slip: [f64; N], load: [Load; N]) -> RateProblem<'a, N, M> {
        let set = self.set;
        RateProblem {
            count: set.count,
            operator: &set.operator,
            friction: &set.friction,
            drive: [[0.0; 2]; N],
            slip,
            load,
        }
    }

    /// Forces (t, n) in a state of a mode.
    fn forces(&self, y: &State, mode: &Mode<N>) -> [[f64; 2]; N] {
        let load = std::array::from_fn(|i| match mode.active.get(i) {
            Some(true) => Load::Prescribed(self.force(y[SPRING + i], i)),
            _ => Load::Absent,
        });
        let rates = self.problem([0.0; N], load).rates_of(&mode.guess, RANK);
        rates.map_or([[0.0; 2]; N], |(rates, _)| rates)
    }

    fn rate(&self, y: &State, mode: &Mode<N>) -> State {
        let mut out = [0.0; STATE];
        let forces = self.forces(y, mode);
        for i in (0..self.set.count).filter(|&i| mode.active[i]) {
            let ([u_t, u_n], [q, f]) = (self.velocity(y, i), forces[i]);
            let e = self.set.restitution[i];
            (out[i], out[NORMAL + i]) = (q, f);
            out[SPRING + i] = if mode.loading[i] { -u_n } else { -u_n / (e * e) };
            (out[WORK_T + i], out[WORK_N + i]) = (u_t * q, u_n * f);
        }
        out
    }

    /// The mode that a state is in.
    fn mode(&self, y: &State) -> Mode<N> {
        let still = SPRING_STILL * self.fastest;
        let (mut active, mut loading) = ([false; N], [false; N]);
        let (mut slip, mut load) = ([0.0; N], [Load::Absent; N]);
        let mut at_start = [0.0; N];
        for i in 0..self.set.count {
            let [u_t, u_n] = self.velocity(y, i);
            at_start[i] = u_t;
            (active[i], loading[i]) = (y[SPRING + i] > 0.0 || u_n < -still, u_n <= 0.0);
            slip[i] = if u_t.abs() <= 10.0 * still { 0.0 } else { u_t };
            if active[i] {
                // What is about to be loaded pulls already.
                let z = y[SPRING + i];
                let soon = if z > 0.0 { z } else { SPRING_SOON * self.time * (-u_n).max(still) };
                load[i] = Load::Prescribed(self.force(soon, i));
            }
        }
        let answer = self.problem(slip, load).solve();
        let open = Guess { holds: false, slip: Slip::Open };
        let guess = answer.preferred(None).map_or([open; N], |s| s.guess);
        Mode { active, loading, guess, slip: at_start }
    }

    /// True where nothing moves, and the loads of the springs hold each other: so it stays.
    fn holds_itself(&self, y: &State, mode: &Mode<N>) -> bool {
        let (rest, forces) = (SPRING_REST * self.fastest, self.forces(y, mode));
        let operator = &self.set.operator;
        (0..self.set.count).all(|i| {
            let mut gain = [0.0; 2];
            for (b, [q, f]) in operator[i].iter().zip(&forces).take(self.set.count) {
                gain[0] += b.tt * q + b.tn * f;
                gain[1] += b.nt * q + b.nn * f;
            }
            let moves = |(u, a): (f64, f64)| u.abs() > rest || a.abs() * self.time > rest;
            !self.velocity(y, i).into_iter().zip(gain).any(moves)
        })
    }

    fn run(&self) -> Result<State, ImpactError> {
        let mut y = [0.0; STATE];
        let deepest = self.time * self.fastest;
        for _ in 0..MOST_EVENTS {
            for z in &mut y[SPRING..WORK_T] {
                *z = if *z <= SPRING_STILL * deepest { 0.0 } else { *z };
            }
            let mode = self.mode(&y);
            if !mode.active.contains(&true) || self.holds_itself(&y, &mode) {
                return Ok(y);
            }
            let mut leg = Leg { springs: self, mode };
            let rate = leg.rate(&y);
            y = match course::follow(&mut leg, (y, rate), FIRST_STEP * self.time, MOST_EVENTS) {
                Ok(Stop::Event { event, .. }) => event.y,
                Ok(Stop::End(y)) => y,
                Err(Lost::Short(_) | Lost::Number) => return Err(ImpactError::Overflow),
                Err(Lost::Steps) => return Err(ImpactError::Unending { stages: MOST_EVENTS }),
            };
        }
        Err(ImpactError::Unending { stages: MOST_EVENTS })
    }
}

impl<const N: usize, const M: usize> Leg<'_, N, M> {
    /// What ends the mode at a contact: it closes or opens, its spring is slack, and its slip turns round, or friction does not hold it, one way or
    /// the other.
    fn of_contact(&self, i: usize, y: &State, [q, f]: [f64; 2]) -> [f64; OF_CONTACT] {
        let (springs, mode) = (self.springs, &self.mode);
        let still = SPRING_STILL * springs.fastest;
        let [u_t, u_n] = springs.velocity(y, i);
        if !mode.active[i] {
            return [u_n + 2.0 * still, 1.0, 1.0, 1.0];
        }
        let [turns, slack] = if mode.loading[i] { [still - u_n, 1.0] } else { [u_n + still, y[SPRING + i]] };
        let friction = springs.set.friction[i];
        let [one, other] = match mode.guess[i].slip {
            // Nothing changes where a slip without friction turns round.
            _ if friction == 0.0 => [1.0; 2],
            // A slip that starts may stand beyond zero by rounding: it has left its mode where it goes on that way.
            Slip::Forward => [u_t - (mode.slip[i] - still).min(-still), 1.0],
            Slip::Backward => [(mode.slip[i] + still).max(still) - u_t, 1.0],
            Slip::Sticks => {
                let most = friction * f * (1.0 + SPRING_CONE);
                [most - q, most + q]
            }
            Slip::Open => [1.0; 2],
        };
        [turns, slack, one, other]
    }

    fn events(&self, y: &State) -> [[f64; OF_CONTACT]; N] {
        let forces = self.springs.forces(y, &self.mode);
        std::array::from_fn(|i| {
            if i < self.springs.set.count { self.of_contact(i, y, forces[i]) } else { [1.0; OF_CONTACT] }
        })
    }
}

impl<const N: usize, const M: usize> Course for Leg<'_, N, M> {
    type Y = State;
    /// The function that falls, by its number.
    type Event = usize;
    type End = State;

    fn rate(&mut self, y: &State) -> State {
        self.springs.rate(y, &self.mode)
    }

    fn first_event(&mut self, step: &Step<State>) -> Result<Option<Found<usize>>, Lost> {
        let fall = first_fall(&mut |x| self.events(&step.at(x)));
        Ok(fall.map(|fall| placed(self, step, fall.of, fall.at)))
    }

    fn value(&mut self, event: &usize, _: f64, y: &State) -> f64 {
        self.events(y).at(*event)
    }

    fn end(&mut self, y: &State, _: &State) -> Option<State> {
        self.springs.holds_itself(y, &self.mode).then_some(*y)
    }

    fn pace(&self, _: &State, _: &State) -> Pace<State> {
        let springs = self.springs;
        let (deepest, fastest) = (springs.time * springs.fastest, springs.fastest);
        let impulse = fastest / springs.set.operator[0][0].nn;
        let scale = |k: usize| match k {
            _ if k < SPRING => impulse,
            _ if k < WORK_T => deepest,
            _ => impulse * fastest,
        };
        let tolerance = std::array::from_fn(|k| SPRING_STEP_ERROR * scale(k));
        Pace { shortest: SPRING_SHORTEST * springs.time, ..Pace::within(tolerance) }
    }
}

#[cfg(test)]
mod tests;
