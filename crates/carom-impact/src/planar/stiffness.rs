//! Sharing by stiffness ratio: every contact a spring `F = k δ^η`, in the limit of stiff ones, where only the ratios of k count.
//!
//! Loading stores the energy `k δ^(η+1)/(η+1)`; unloading returns e² of it, so that δ falls at `u_n/e²` while the contact opens
//! at `u_n`. Friction is Coulomb's at every instant, sticking contacts hold by the rate problem. Time stands for the path only: stiffness and time
//! scale out together.
//!
//! Source: Liu, Zhao and Brogliato, Proc. R. Soc. A 464 (2008) 3193: their distributing law `dP_j/dP_i` is the ratio of these forces.

use super::error::{outside, require};
use super::rate::{Load, RANK_TOLERANCE, RateProblem};
use super::sharing::{settle_states, untouched};
use super::staged::StagedOutcome;
use super::{ContactSet, Guess, ImpactError, Law, MOST_CONTACTS, Slip};
use carom_num::elementary::pow;
use carom_num::ode8::{Trial, length_factor, step_plain};

/// Impulses (t, n), spring, and work (t, n) of up to six contacts.
const STATE: usize = 5 * MOST_CONTACTS;
type State = [f64; STATE];
/// Where the parts of a state begin.
const NORMAL: usize = MOST_CONTACTS;
const SPRING: usize = 2 * MOST_CONTACTS;
const WORK_T: usize = 3 * MOST_CONTACTS;
const WORK_N: usize = 4 * MOST_CONTACTS;

/// Velocities below this fraction of the largest before are zero.
const STILL: f64 = 1e-12;
/// Error of a step in units of the impact.
const TOLERANCE: f64 = 1e-12;
/// Events after which the springs are given up.
const MOST_EVENTS: usize = 20_000;
/// Restitution below which a spring would have to let go faster than can be followed.
const LEAST_RESTITUTION: f64 = 0.01;

/// What every contact does until the next event.
#[derive(Clone, Copy)]
struct Mode<const N: usize> {
    /// It is loaded, or about to be.
    active: [bool; N],
    loading: [bool; N],
    guess: [Guess; N],
}

struct Springs<'a, const N: usize, const M: usize> {
    set: &'a ContactSet<N, M>,
    stiffness: [f64; N],
    exponent: f64,
    fastest: f64,
    /// Duration of the stiffest contact's own impact: the unit of time.
    time: f64,
}

/// Resolves an impact whose contacts share it as springs of these stiffnesses (only their ratios count) and this exponent (1: linear, 1.5: Hertz).
///
/// # Errors
/// As [`staged::resolve`](super::staged::resolve), and [`ImpactError::OutsideDomain`] unless stiffnesses are above 0, the exponent is 1 to
/// 3, and restitutions are at least 0.01: a spring that returns nothing would let go at once.
///
/// # Limits
/// Velocities to about 1e-9 of the largest. Energy e² is returned, so that one contact without friction restitutes e.
///
/// # Example
/// One ball, whatever its spring: half of 2 m/s comes back.
/// ```
/// # use carom_impact::planar::{Block, ContactSet, stiffness::by_stiffness};
/// let ball = ContactSet::<1, 2> {
///     count: 1, operator: [[Block { tt: 3.5, tn: 0.0, nt: 0.0, nn: 1.0 }]],
///     slip: [0.0], normal: [-2.0], friction: [0.3], restitution: [0.5],
/// };
/// let [[_, up]] = by_stiffness(&ball, &[1e6], 1.5)?.velocity;
/// assert!((up - 1.0).abs() < 1e-8);
/// # Ok::<(), carom_impact::planar::ImpactError>(())
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
    if (0..set.count).all(|i| set.normal[i] >= -STILL * fastest) {
        settle_states(&mut out, set.count);
        return Ok(out);
    }
    let springs = Springs::new(set, stiffness, exponent, fastest);
    let end = springs.run()?;
    let scale = fastest * fastest / set.operator[0][0].nn;
    for i in 0..set.count {
        let [u_t, u_n] = springs.velocity(&end, i);
        let rest = |u: f64| if u.abs() <= 1e3 * STILL * fastest { 0.0 } else { u };
        out.velocity[i] = [rest(u_t), rest(u_n).max(0.0)];
        out.impulse[i] = [end[i], end[NORMAL + i]];
        out.work[i] = [end[WORK_T + i], end[WORK_N + i]];
    }
    out.gained_energy = out.work[..set.count].iter().flatten().sum::<f64>() > 1e-9 * scale;
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
        let rates = self.problem([0.0; N], load).rates_of(&mode.guess, RANK_TOLERANCE);
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
        let still = STILL * self.fastest;
        let (mut active, mut loading) = ([false; N], [false; N]);
        let (mut slip, mut load) = ([0.0; N], [Load::Absent; N]);
        for i in 0..self.set.count {
            let [u_t, u_n] = self.velocity(y, i);
            (active[i], loading[i]) = (y[SPRING + i] > 0.0 || u_n < -still, u_n <= 0.0);
            slip[i] = if u_t.abs() <= 10.0 * still { 0.0 } else { u_t };
            if active[i] {
                // What is about to be loaded pulls already.
                let soon = y[SPRING + i] + 1e-6 * self.time * (-u_n).max(still);
                load[i] = Load::Prescribed(self.force(soon, i));
            }
        }
        let answer = self.problem(slip, load).solve();
        let open = Guess { holds: false, slip: Slip::Open };
        let guess = answer.preferred(None).map_or([open; N], |s| s.guess);
        Mode { active, loading, guess }
    }

    /// True where a state has left its mode.
    fn left(&self, y: &State, mode: &Mode<N>) -> bool {
        let still = STILL * self.fastest;
        let forces = self.forces(y, mode);
        (0..self.set.count).any(|i| {
            let [u_t, u_n] = self.velocity(y, i);
            if !mode.active[i] {
                return u_n < -2.0 * still;
            }
            let [q, f] = forces[i];
            let turned = if mode.loading[i] { u_n > still } else { u_n < -still || y[SPRING + i] < 0.0 };
            turned
                || match mode.guess[i].slip {
                    Slip::Forward => u_t < -still,
                    Slip::Backward => u_t > still,
                    Slip::Sticks => q.abs() > self.set.friction[i] * f * (1.0 + 1e-12),
                    Slip::Open => f > 0.0,
                }
        })
    }

    fn run(&self) -> Result<State, ImpactError> {
        let mut y = [0.0; STATE];
        let (deepest, fastest) = (self.time * self.fastest, self.fastest);
        let impulse = fastest / self.set.operator[0][0].nn;
        let tolerance: State = std::array::from_fn(|k| {
            TOLERANCE
                * if k < SPRING {
                    impulse
                } else if k < WORK_T {
                    deepest
                } else {
                    impulse * fastest
                }
        });
        for _ in 0..MOST_EVENTS {
            for z in &mut y[SPRING..WORK_T] {
                *z = if *z <= STILL * deepest { 0.0 } else { *z };
            }
            let mode = self.mode(&y);
            if !mode.active.contains(&true) {
                return Ok(y);
            }
            y = self.until_left(y, &mode, &tolerance)?;
        }
        Err(ImpactError::Unending { stages: MOST_EVENTS })
    }

    /// Goes on in a mode until it is left.
    fn until_left(&self, mut y: State, mode: &Mode<N>, tolerance: &State) -> Result<State, ImpactError> {
        let f = |y: &State| self.rate(y, mode);
        let mut length = 0.01 * self.time;
        for _ in 0..MOST_EVENTS {
            let start = self.rate(&y, mode);
            let trial = step_plain(y, start, length, f);
            let error = trial.scaled_error(tolerance);
            if error > 1.0 || !error.is_finite() {
                length *= if error.is_finite() { length_factor(error).min(0.9) } else { 0.2 };
                require(length > 1e-13 * self.time, || ImpactError::Overflow)?;
                continue;
            }
            if self.left(&trial.end, mode) {
                return Ok(self.to_the_edge(&trial, start, mode));
            }
            y = trial.end;
            length *= length_factor(error);
        }
        Err(ImpactError::Unending { stages: MOST_EVENTS })
    }

    /// The first state within a step that has left its mode.
    fn to_the_edge(&self, trial: &Trial<State>, start: State, mode: &Mode<N>) -> State {
        let (mut low, mut high, mut end) = (0.0, trial.length, trial.end);
        for _ in 0..48 {
            let middle = 0.5 * (low + high);
            let at = step_plain(trial.start, start, middle, |y| self.rate(y, mode)).end;
            if self.left(&at, mode) {
                (high, end) = (middle, at);
            } else {
                low = middle;
            }
        }
        end
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Block, Pair, single, staged};
    use super::*;
    use carom_num::elementary::sin_cos;

    fn chain(second: f64) -> Pair {
        let cell = |nn, tt| Block { tt, tn: 0.0, nt: 0.0, nn };
        ContactSet {
            count: 2,
            operator: [[cell(2.0, 2.0), cell(-1.0, 0.0)], [cell(-1.0, 0.0), cell(2.0, 2.0)]],
            slip: [0.0; 2],
            normal: [-1.0, second],
            friction: [0.0; 2],
            restitution: [1.0; 2],
        }
    }

    /// Balls 0, 1, 2 of 1 kg with equal linear springs between them, ball 0 at 1 m/s: the closed form by normal modes while both springs
    /// are loaded, then the last two alone.
    fn three_balls() -> [f64; 3] {
        let root3 = 3.0_f64.sqrt();
        // δ₁,₂ = (sin t ± sin(√3 t)/√3)/2.
        let delta = |t: f64| {
            let (slow, fast) = (sin_cos(t).0, sin_cos(root3 * t).0 / root3);
            [(slow + fast) / 2.0, (slow - fast) / 2.0]
        };
        let rate = |t: f64| {
            let (slow, fast) = (sin_cos(t).1, sin_cos(root3 * t).1);
            [(slow + fast) / 2.0, (slow - fast) / 2.0]
        };
        let (mut low, mut high) = (1.5, 3.0);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if delta(middle)[0] > 0.0 { low = middle } else { high = middle }
        }
        let ([_, d2], [r1, r2]) = (delta(low), rate(low));
        // v₀ − v₁ = r₁, v₁ − v₂ = r₂, and the sum is 1.
        let v2 = (1.0 - r1 - 2.0 * r2) / 3.0;
        let (v1, v0) = (v2 + r2, v2 + r2 + r1);
        let (middle, apart) = (0.5 * (v1 + v2), (r2 * r2 + 2.0 * d2 * d2).sqrt());
        [v0, middle - 0.5 * apart, middle + 0.5 * apart]
    }

    #[test]
    fn three_equal_balls_and_springs_move_as_their_normal_modes_do() {
        let out = by_stiffness(&chain(0.0), &[1.0, 1.0], 1.0).unwrap();
        let (p1, p2) = (out.impulse[0][1], out.impulse[1][1]);
        for (ours, closed) in [1.0 - p1, p1 - p2, p2].into_iter().zip(three_balls()) {
            assert!((ours - closed).abs() < 1e-9, "{ours} is not {closed}");
        }
        assert!(out.work.iter().flatten().sum::<f64>().abs() < 1e-10, "{out:?}");
    }

    #[test]
    fn a_stiff_first_contact_is_over_before_the_second_begins() {
        let out = by_stiffness(&chain(0.0), &[1e8, 1.0], 1.5).unwrap();
        assert!((out.impulse[1][1] - 1.0).abs() < 1e-2 && (out.impulse[0][1] - 1.0).abs() < 1e-2, "{out:?}");
    }

    #[test]
    fn one_contact_ends_as_stronges_law_says() {
        let set = ContactSet::<1, 2> {
            count: 1,
            operator: [[Block { tt: 3.0, tn: -0.8, nt: -0.8, nn: 1.5 }]],
            slip: [0.7],
            normal: [-1.0],
            friction: [0.6],
            restitution: [0.5],
        };
        let b = &set.operator[0][0];
        let contact = single::Contact {
            w_tt: b.tt,
            w_tn: b.tn,
            w_nn: b.nn,
            slip: 0.7,
            normal: -1.0,
            friction: 0.6,
            restitution: 0.5,
        };
        let stronge = single::resolve(&contact, Law::Stronge).unwrap();
        for exponent in [1.0, 1.5] {
            let out = by_stiffness(&set, &[1.0], exponent).unwrap();
            let off = (out.impulse[0][1] - stronge.normal_impulse).abs();
            assert!(off < 1e-8 && (out.velocity[0][0] - stronge.slip).abs() < 1e-8, "{out:?} {stronge:?}");
        }
    }

    #[test]
    fn stiffness_of_symmetric_contacts_changes_nothing() {
        // Both ends of a symmetric rod close alike: any symmetric sharing ends as together.
        let mut set = chain(-1.0);
        set.restitution = [0.7; 2];
        let springs = by_stiffness(&set, &[2.0, 2.0], 1.0).unwrap();
        let together = staged::resolve(&set, Law::Poisson).unwrap();
        for i in 0..2 {
            assert!(
                (springs.velocity[i][1] - together.velocity[i][1]).abs() < 1e-9,
                "{springs:?} {together:?}"
            );
        }
    }

    #[test]
    fn what_no_spring_can_do_is_refused() {
        let mut dead = chain(0.0);
        dead.restitution[1] = 0.0;
        let text = by_stiffness(&dead, &[1.0; 2], 1.0).unwrap_err().to_string();
        assert_eq!(text, "restitution of contact 1 is 0, allowed is 0.01 to 1 for sharing by stiffness");
        assert!(by_stiffness(&chain(0.0), &[1.0, 0.0], 1.0).is_err(), "no stiffness");
        assert!(by_stiffness(&chain(0.0), &[1.0; 2], 0.5).is_err(), "no such spring");
    }
}
