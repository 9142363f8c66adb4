//! What is watched along a curve: every inequality of the hypothesis, as a function that falls through zero where it breaks.

use super::curve::{CLOCK, Curve, State, WORK};
use super::leg::{Goal, Pace};
use crate::Load;
use crate::spatial::rates::answer::Mode;
use crate::tolerance::{AT_EDGE_OF_CURVE, CLOCK_HELD_UP, TOUCHING_EDGE};
use carom_num::ode8::Vector;
use carom_num::{Mat3, Vec3};

/// Event functions of a contact: it closes, it pushes, it sticks, others turn it back or carry for it, it owes work.
pub(super) const OF_CONTACT: usize = 5;

/// Event functions, all scaled: those of each contact, and the goal and the clock.
#[derive(Clone, Copy)]
pub(super) struct Watch<const N: usize> {
    pub(super) contact: [[f64; OF_CONTACT]; N],
    pub(super) common: [f64; 2],
}

/// Its numbers in a row: the goal and the clock, then those of each contact.
impl<const N: usize> Vector for Watch<N> {
    const COUNT: usize = 2 + OF_CONTACT * N;

    fn from_fn(mut number: impl FnMut(usize) -> f64) -> Self {
        let common = [0, 1].map(&mut number);
        let contact = std::array::from_fn(|i| std::array::from_fn(|kind| number(2 + OF_CONTACT * i + kind)));
        Self { contact, common }
    }

    fn at(&self, i: usize) -> f64 {
        if i < 2 { self.common[i] } else { self.contact[(i - 2) / OF_CONTACT][(i - 2) % OF_CONTACT] }
    }
}

impl<const N: usize> Watch<N> {
    pub(super) const NONE: Self = Self { contact: [[0.0; OF_CONTACT]; N], common: [0.0; 2] };

    /// Where rates are not known, nothing is.
    const UNKNOWN: Self = Self { contact: [[f64::NAN; OF_CONTACT]; N], common: [f64::NAN; 2] };

    /// What keeps functions that start at their edge from falling at once. A contact that is lifted by too much, because equal springs find no rest, is not
    /// watched.
    pub(super) fn lift(&self) -> Self {
        let lift = |f: f64, edge: f64| if f < edge { edge - f.min(0.0) } else { 0.0 };
        // A debt is paid to the last: what is left of it, however little, is the square of a velocity.
        let edge = |kind: usize| match kind {
            0 => TOUCHING_EDGE,
            4 => 0.0,
            _ => AT_EDGE_OF_CURVE,
        };
        let lift_of = |kind: usize, f: f64| match kind {
            3 if f < -AT_EDGE_OF_CURVE => 1.0 - f,
            _ => lift(f, edge(kind)),
        };
        let contact = self.contact.map(|of| std::array::from_fn(|kind| lift_of(kind, of[kind])));
        Self { contact, common: [0.0, lift(self.common[1], AT_EDGE_OF_CURVE)] }
    }
}

impl<const N: usize> Curve<'_, N> {
    /// All event functions, those lifted that start at their edge.
    pub(super) fn lifted(&self, y: &State<N>) -> Watch<N> {
        let watch = self.watch(y).unwrap_or(Watch::UNKNOWN);
        Watch::from_fn(|i| watch.at(i) + self.lift.at(i))
    }

    /// All event functions; `None` where the rates are not known.
    pub(super) fn watch(&self, y: &State<N>) -> Option<Watch<N>> {
        let direction = self.directions(y);
        let now = self.leg.pace(&direction)?;
        let (normal, clock) = (self.normal(y), y[0][CLOCK]);
        let mut out = Watch { contact: [[1.0; OF_CONTACT]; N], common: [1.0; 2] };
        for i in self.leg.contacts() {
            out.contact[i] = self.watch_contact(i, &now, normal[i], clock);
            if let Some(lifted) = self.leg.lifted(i) {
                out.contact[i][3] = -self.leg.sinks(i, lifted, &direction, now.clock)?;
            }
            if let Goal::Work(end) = self.leg.goal
                && end[i].is_finite()
            {
                let unit = self.leg.fastest * self.leg.fastest / self.leg.largest_response;
                out.contact[i][4] = (end[i] - y[i][WORK + 1]) / unit;
            }
        }
        out.common[0] = match self.leg.goal {
            Goal::Clock(end) => end - clock,
            Goal::Approach(i) if self.start.at.velocity[i].z < 0.0 => -normal[i] / self.leg.fastest,
            Goal::Velocity(i, end) => (end - normal[i]) / self.leg.fastest,
            Goal::Approach(_) | Goal::Work(_) => 1.0,
        };
        // In units of a clock that is an impulse. At zero the equations are singular.
        out.common[1] = now.clock * self.leg.fastest / self.leg.largest_response - CLOCK_HELD_UP;
        Some(out)
    }

    fn watch_contact(&self, i: usize, now: &Pace<N>, normal: f64, clock: f64) -> [f64; OF_CONTACT] {
        let (leg, guess, p) = (self.leg, self.leg.guess[i], now.rates[i]);
        let mut out = [1.0; OF_CONTACT];
        let start = self.start.at.velocity[i].z;
        if !guess.holds && start >= 0.0 {
            // What is loaded in the paradox may be driven in.
            out[0] = if leg.may_sink(i) { 1.0 } else { normal / leg.fastest };
        }
        if guess.holds {
            let base = match leg.load[i] {
                Load::Touching(base) | Load::Prescribed(base) => base,
                Load::Absent => 0.0,
            };
            out[1] = p.z - base * now.clock;
        } else if start < 0.0 && matches!(leg.load[i], Load::Touching(_)) {
            // Measured against its terms, as the hypothesis was judged.
            let row = |(block, p): (&Mat3, &Vec3)| {
                let [_, _, n] = block.rows;
                (n.x * p.x).abs() + (n.y * p.y).abs() + (n.z * p.z).abs()
            };
            let terms: f64 = leg.set.operator[i].iter().zip(&now.rates).take(leg.set.count).map(row).sum();
            let left = (1.0 - clock) / now.clock;
            out[3] = (normal + left * now.response[i].z) / (leg.fastest + left * terms);
        }
        if guess.mode == Mode::Sticks {
            out[2] = leg.set.friction[i] * p.z - (p.x * p.x + p.y * p.y).sqrt();
        }
        out
    }
}
