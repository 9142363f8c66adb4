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
use crate::ImpactError;
use crate::tolerance::{BESIDE, CURVE_STEP_ERROR, SETTLED_TURN, STOPPED};
use carom_num::course::{self, Course, Found, Lost, Pace, Stop, placed};
use carom_num::elementary::{atan2, exp, ln, sin_cos};
use carom_num::falls::first_fall;
use carom_num::ode8::Step;
use carom_num::{Mat3, Vec3};

/// A contact's operator and its friction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rough {
    pub(in crate::spatial) operator: Mat3,
    pub(in crate::spatial) friction: f64,
}

/// What a contact at rest in its tangent plane does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rest {
    pub(in crate::spatial) sticks: bool,
    /// Impulse per normal impulse.
    pub(in crate::spatial) along: Vec3,
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

/// A slip on its way through a phase.
struct Slide {
    contact: Rough,
    start: Place,
    goal: Goal,
    /// The largest velocity at the start [m/s], and the largest response of the operator [1/kg].
    largest: f64,
    response: f64,
}

/// Steps after which a slide is given up.
const MOST_STEPS: usize = 10_000;
/// Directions tried for one that friction does not turn.
const DIRECTIONS: u32 = 96;

impl Rough {
    /// Impulse per normal impulse of a slip in this direction, and the velocity per normal impulse along it, across it and along the normal.
    fn slipping(&self, theta: f64) -> (Vec3, [f64; 3]) {
        let (sin, cos) = sin_cos(theta);
        let impulse = Vec3::new(-self.friction * cos, -self.friction * sin, 1.0);
        let u = self.operator * impulse;
        (impulse, [cos * u.x + sin * u.y, cos * u.y - sin * u.x, u.z])
    }

    /// What a contact does that does not slip; `None` where it does slip.
    pub(in crate::spatial) fn rest(&self, velocity: &Vec3) -> Option<Rest> {
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
}

/// Follows a slip to the end of the phase or to its own; moves the place there.
///
/// # Errors
/// [`ImpactError::Unending`] where neither is reached.
pub(super) fn slide(contact: &Rough, at: &mut Place, goal: Goal) -> Result<Reached, ImpactError> {
    let (start, v) = (*at, at.velocity);
    let response = contact.operator.rows.map(Vec3::norm).into_iter().fold(0.0, f64::max);
    let mut slide = Slide { contact: *contact, start, goal, largest: v.norm(), response };
    let first = [
        ln((v.x * v.x + v.y * v.y).sqrt()),
        atan2(v.y, v.x),
        at.impulse.z,
        v.z,
        at.impulse.x,
        at.impulse.y,
        at.work,
    ];
    let rate = slide.rate(&first);
    let length = 0.1 / (response * (1.0 + contact.friction));
    let end = course::follow(&mut slide, (first, rate), length, MOST_STEPS)
        .map_err(|_| ImpactError::Unending { stages: MOST_STEPS })?;
    let reached;
    (*at, reached) = match end {
        Stop::Event { event, .. } => (slide.place(&event.y), Reached::Goal),
        Stop::End(end) => end,
    };
    Ok(reached)
}

impl Course for Slide {
    type Y = Curve;
    /// The phase ends.
    type Event = ();
    type End = (Place, Reached);

    fn rate(&mut self, y: &Curve) -> Curve {
        let speed = exp(y[0]);
        let (impulse, [along, across, normal]) = self.contact.slipping(y[1]);
        [along, across, speed, speed * normal, speed * impulse.x, speed * impulse.y, speed * y[3]]
    }

    fn first_event(&mut self, step: &Step<Curve>) -> Result<Option<Found<()>>, Lost> {
        let fall = first_fall(&mut |x| [self.left(&step.at(x)).0]);
        Ok(fall.map(|fall| placed(self, step, (), fall.at)))
    }

    fn value(&mut self, (): &(), _: f64, y: &Curve) -> f64 {
        self.left(y).0
    }

    fn slope(&mut self, (): &(), _: f64, y: &Curve) -> Option<f64> {
        Some(self.left(y).1)
    }

    fn end(&mut self, y: &Curve, rate: &Curve) -> Option<(Place, Reached)> {
        // ln s falls without end where the slip stops.
        if y[0] <= ln(STOPPED * self.largest) {
            return Some((self.stopped(y), Reached::Rest));
        }
        // Along a direction that friction does not turn ln s may fall so slowly that steps never end: the rest goes in closed form.
        let settled = rate[1].abs() * exp(y[0]) <= SETTLED_TURN * self.response * self.largest;
        if settled { self.straight_on(y) } else { None }
    }

    fn pace(&self, _: &Curve, _: &Curve) -> Pace<Curve> {
        let impulse = self.largest / self.response;
        let scales = [1.0, 1.0, impulse, self.largest, impulse, impulse, impulse * self.largest];
        Pace::within(scales.map(|scale| CURVE_STEP_ERROR * scale))
    }
}

impl Slide {
    /// What is left of the phase, and its rate with σ.
    fn left(&self, y: &Curve) -> (f64, f64) {
        let growth = self.contact.slipping(y[1]).1[2];
        let (left, rate) = self.goal.left(y[2], y[3], y[6], growth);
        (left, rate * exp(y[0]))
    }

    /// The walk's place at a point of the curve; the velocity is computed from the impulse.
    fn place(&self, y: &Curve) -> Place {
        let impulse = Vec3::new(y[4], y[5], y[2]);
        let velocity = self.start.velocity + self.contact.operator * (impulse - self.start.impulse);
        Place { impulse, velocity, work: y[6] }
    }

    /// The walk's place after so much more normal impulse in one direction.
    fn placed(&self, y: &Curve, (theta, more): (f64, f64)) -> Place {
        let (impulse, [_, _, normal]) = self.contact.slipping(theta);
        let mut end = *y;
        (end[2], end[4], end[5]) = (y[2] + more, y[4] + impulse.x * more, y[5] + impulse.y * more);
        end[6] += more * (y[3] + 0.5 * normal * more);
        self.place(&end)
    }

    /// Goes straight to the goal or to the end of the slip, where friction turns the slip back to the direction that it has.
    fn straight_on(&self, y: &Curve) -> Option<(Place, Reached)> {
        let turn = |theta: f64| self.contact.slipping(theta).1[1];
        let theta = turned_back_to(y[1], |by| Some(turn(y[1] + by)))?;
        let [along, _, normal] = self.contact.slipping(theta).1;
        let ahead = |length: f64| if length >= 0.0 { length } else { f64::INFINITY };
        let to_goal = ahead(self.goal.straight(&self.place(y), normal));
        let to_rest = ahead(-exp(y[0]) / along);
        let more = to_goal.min(to_rest);
        if more.is_infinite() {
            return None;
        }
        let place = self.placed(y, (theta, more));
        Some(if to_rest > to_goal { (place, Reached::Goal) } else { (at_rest(place), Reached::Rest) })
    }

    /// The end of a slip that has come to nearly nothing: the rest of it goes straight.
    fn stopped(&self, y: &Curve) -> Place {
        let more = exp(y[0]) / -self.contact.slipping(y[1]).1[0];
        let goes = more.is_finite() && more > 0.0;
        at_rest(if goes { self.placed(y, (y[1], more)) } else { self.place(y) })
    }
}

/// The same place without a slip.
fn at_rest(mut place: Place) -> Place {
    (place.velocity.x, place.velocity.y) = (0.0, 0.0);
    place
}

/// The direction near `theta` that friction does not turn, and to which it turns neighbouring slips back; `None` where there is none. `turn` says
/// how fast friction turns a slip at an angle beside `theta`.
pub(in crate::spatial) fn turned_back_to(theta: f64, turn: impl Fn(f64) -> Option<f64>) -> Option<f64> {
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
