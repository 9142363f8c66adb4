//! How a slip turns under its own friction.
//!
//! In polar form, slip speed s and direction θ, with e_r = (cos θ, sin θ):
//!
//! ```text
//! ds/dN = f(θ) = e_r · (w_tn − μ W_tt e_r),   s dθ/dN = g(θ) = e_θ · (w_tn − μ W_tt e_r)
//! ```
//!
//! At s = 0 this is singular, and the slip may turn through any angle on its last bit of impulse. With the clock σ, dN = s dσ, it is not: θ runs by itself,
//! `dθ/dσ = g(θ)`, towards a direction that friction does not turn, while ln s falls steadily. Once it is there the rest is straight. Where friction is just about what
//! would hold the contact, ln s falls so slowly there that no walk in steps comes to an end.
//!
//! # Source
//! The invariant directions are those of Bhatt and Koechling, J. Appl. Mech. 62 (1995) 893; the clock σ is a change of variable.

use super::single::{Goal, Place};
use crate::planar::ImpactError;
use crate::tolerance::{BESIDE, CURVE_STEP_ERROR, SETTLED_TURN, STOPPED};
use carom_num::elementary::{atan2, exp, ln, sin_cos};
use carom_num::ode8::{Step, length_factor, step_plain};
use carom_num::poly::{NODES, Quartic};
use carom_num::{Mat3, Vec3};

/// A contact's operator and its friction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    pub(super) operator: Mat3,
    pub(super) friction: f64,
}

/// What a contact at rest in its tangent plane does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rest {
    pub(super) sticks: bool,
    /// Impulse per normal impulse.
    pub(super) along: Vec3,
}

/// How a slide ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reached {
    /// The phase's goal.
    Goal,
    /// The slip came to zero.
    Rest,
}

/// (ln s, θ, N, u_n, p₁, p₂, work of the normal impulse).
type Curve = [f64; 7];

/// Steps after which a slide is given up.
const MOST_STEPS: usize = 10_000;
/// Newton's steps to a goal.
const MOST_CORRECTIONS: u32 = 6;
/// Directions tried for one that friction does not turn.
const DIRECTIONS: u32 = 96;

impl Course {
    /// Impulse per normal impulse of a slip in this direction, and the velocity per normal impulse along it, across it and along the normal.
    fn slipping(&self, theta: f64) -> (Vec3, [f64; 3]) {
        let (sin, cos) = sin_cos(theta);
        let impulse = Vec3::new(-self.friction * cos, -self.friction * sin, 1.0);
        let u = self.operator * impulse;
        (impulse, [cos * u.x + sin * u.y, cos * u.y - sin * u.x, u.z])
    }

    /// What a contact does that does not slip; `None` where it does slip.
    pub(super) fn rest(&self, velocity: &Vec3) -> Option<Rest> {
        if velocity.x != 0.0 || velocity.y != 0.0 {
            return None;
        }
        // What would hold it: W_tt q = −w_tn.
        let [a, b, _] = self.operator.rows;
        let determinant = a.x * b.y - a.y * b.x;
        let held = Vec3::new(a.y * b.z - b.y * a.z, b.x * a.z - a.x * b.z, determinant) / determinant;
        if held.x * held.x + held.y * held.y <= self.friction * self.friction {
            return Some(Rest { sticks: true, along: held });
        }
        Some(Rest { sticks: false, along: self.slipping(self.way_out()).0 })
    }

    /// The direction in which a contact that does not hold starts to slip: friction does not turn that direction, and the slip grows along it.
    /// There is one.
    fn way_out(&self) -> f64 {
        let turn = |theta: f64| self.slipping(theta).1[1];
        let step = 2.0 * std::f64::consts::PI / f64::from(DIRECTIONS);
        let mut best = (f64::NEG_INFINITY, 0.0);
        for i in 0..DIRECTIONS {
            let (mut low, mut high) = (step * f64::from(i), step * f64::from(i + 1));
            let rises = turn(high) > turn(low);
            if (turn(low) > 0.0) == (turn(high) > 0.0) {
                continue;
            }
            while high - low > 4.0 * f64::EPSILON * high {
                let middle = 0.5 * (low + high);
                if (turn(middle) > 0.0) == rises { high = middle } else { low = middle }
            }
            let growth = self.slipping(high).1[0];
            if growth > best.0 {
                best = (growth, high);
            }
        }
        best.1
    }

    fn rate(&self, y: &Curve) -> Curve {
        let speed = exp(y[0]);
        let (impulse, [along, across, normal]) = self.slipping(y[1]);
        [along, across, speed, speed * normal, speed * impulse.x, speed * impulse.y, speed * y[3]]
    }
}

/// Follows a slip to the end of the phase or to its own; moves the place there.
///
/// # Errors
/// [`ImpactError::Unending`] where neither is reached.
pub(super) fn slide(course: &Course, at: &mut Place, goal: Goal) -> Result<Reached, ImpactError> {
    let (start, v) = (*at, at.velocity);
    let largest = v.norm();
    let mut y: Curve = [
        ln((v.x * v.x + v.y * v.y).sqrt()),
        atan2(v.y, v.x),
        at.impulse.z,
        v.z,
        at.impulse.x,
        at.impulse.y,
        at.work,
    ];
    let stopped = ln(STOPPED * largest);
    let size = course.operator.rows.map(Vec3::norm).into_iter().fold(0.0, f64::max);
    let impulse = largest / size;
    let scales = [1.0, 1.0, impulse, largest, impulse, impulse, impulse * largest];
    let rate = |y: &Curve| course.rate(y);
    let mut length = 0.1 / (size * (1.0 + course.friction));
    for _ in 0..MOST_STEPS {
        // ln s falls without end where the slip stops.
        if y[0] <= stopped {
            return Ok(stop(course, &start, &y, at));
        }
        let first = rate(&y);
        // Along a direction that friction does not turn ln s may fall so slowly that steps never end: the rest goes in closed form.
        if first[1].abs() * exp(y[0]) <= SETTLED_TURN * size * largest
            && let Some(reached) = straight_on(course, (&start, goal), &y, at)
        {
            return Ok(reached);
        }
        let trial = step_plain(y, first, length, rate);
        let error = trial.scaled_error(&scales.map(|scale| CURVE_STEP_ERROR * scale));
        if error > 1.0 || error.is_nan() {
            length *= if error.is_finite() { length_factor(error).min(0.9) } else { 0.2 };
            continue;
        }
        let step = trial.with_dense(rate(&trial.end), rate);
        if let Some(x) = goal_in(course, &step, goal) {
            let end = to_goal(course, &step, goal, x);
            *at = place(course, &start, &end);
            return Ok(Reached::Goal);
        }
        y = step.end;
        length = step.length * length_factor(error);
    }
    Err(ImpactError::Unending { stages: MOST_STEPS })
}

/// What is left of the phase, and its rate with σ.
fn left(course: &Course, goal: Goal, y: &Curve) -> (f64, f64) {
    let growth = course.slipping(y[1]).1[2];
    let (left, rate) = goal.left(y[2], y[3], y[6], growth);
    (left, rate * exp(y[0]))
}

/// The fraction of a step at which the goal is reached.
fn goal_in(course: &Course, step: &Step<Curve>, goal: Goal) -> Option<f64> {
    Quartic::through(&NODES.map(|x| left(course, goal, &step.at(x)).0)).first_fall()
}

/// Steps to the goal, near a fraction of a step.
fn to_goal(course: &Course, step: &Step<Curve>, goal: Goal, x: f64) -> Curve {
    let mut length = x * step.length;
    let mut end = step.at(x);
    for _ in 0..MOST_CORRECTIONS {
        end = step_plain(step.start, step.start_rate, length, |y: &Curve| course.rate(y)).end;
        let (value, slope) = left(course, goal, &end);
        let correction = -value / slope;
        if !correction.is_finite() || correction.abs() <= 4.0 * f64::EPSILON * step.length {
            break;
        }
        length += correction;
    }
    end
}

/// The walk's place at a point of a curve; the velocity is computed from the impulse.
fn place(course: &Course, start: &Place, y: &Curve) -> Place {
    let impulse = Vec3::new(y[4], y[5], y[2]);
    let velocity = start.velocity + course.operator * (impulse - start.impulse);
    Place { impulse, velocity, work: y[6] }
}

/// The walk's place after so much more normal impulse in one direction.
fn placed(course: &Course, start: &Place, y: &Curve, (theta, more): (f64, f64)) -> Place {
    let (impulse, [_, _, normal]) = course.slipping(theta);
    let mut end = *y;
    (end[2], end[4], end[5]) = (y[2] + more, y[4] + impulse.x * more, y[5] + impulse.y * more);
    end[6] += more * (y[3] + 0.5 * normal * more);
    place(course, start, &end)
}

/// The direction near `theta` that friction does not turn, and to which it turns neighbouring slips back; `None` where there is none. `turn` says
/// how fast friction turns a slip at an angle beside `theta`.
pub(super) fn turned_back_to(theta: f64, turn: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let (mut low, mut high) = (-BESIDE, BESIDE);
    if turn(low)? <= 0.0 || turn(high)? >= 0.0 {
        return None;
    }
    while high - low > f64::EPSILON {
        let middle = 0.5 * (low + high);
        if turn(middle)? > 0.0 { low = middle } else { high = middle }
    }
    Some(theta + 0.5 * (low + high))
}

/// Goes straight to the goal or to the end of the slip, where friction turns the slip back to the direction that it has.
fn straight_on(course: &Course, (start, goal): (&Place, Goal), y: &Curve, at: &mut Place) -> Option<Reached> {
    let turn = |theta: f64| course.slipping(theta).1[1];
    let theta = turned_back_to(y[1], |by| Some(turn(y[1] + by)))?;
    let [along, _, normal] = course.slipping(theta).1;
    let here = place(course, start, y);
    let ahead = |length: f64| if length >= 0.0 { length } else { f64::INFINITY };
    let to_goal = ahead(goal.straight(&here, normal));
    let to_rest = ahead(-exp(y[0]) / along);
    let more = to_goal.min(to_rest);
    if more.is_infinite() {
        return None;
    }
    *at = placed(course, start, y, (theta, more));
    if to_rest > to_goal {
        return Some(Reached::Goal);
    }
    (at.velocity.x, at.velocity.y) = (0.0, 0.0);
    Some(Reached::Rest)
}

/// Ends a slip that has come to nearly nothing: the rest of it goes straight.
fn stop(course: &Course, start: &Place, y: &Curve, at: &mut Place) -> Reached {
    let more = exp(y[0]) / -course.slipping(y[1]).1[0];
    *at = if more.is_finite() && more > 0.0 {
        placed(course, start, y, (y[1], more))
    } else {
        place(course, start, y)
    };
    (at.velocity.x, at.velocity.y) = (0.0, 0.0);
    Reached::Rest
}
