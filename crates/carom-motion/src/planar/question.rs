//! The rate problem of motion: which touching contacts hold, and how.

use super::kinematics::{Kinematics, Pairing, Turn};
use super::mode::Held;
use super::touching::Few;
use super::{State, World};
use carom_impact::planar::rate::{Load, RateProblem};
use carom_impact::planar::{Answer, ContactSet, Guess, ImpactError, MOST_CONTACTS, Slip, Solution, Touch};

/// A touching contact as the rate problem sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    pub(super) pair: Pairing,
    /// Slip velocity, exactly zero where it is at rest along t [m/s].
    pub(super) slip: f64,
    /// What this contact is known to do, where an event has just decided it.
    pub(super) known: Option<Slip>,
    /// What it did before.
    pub(super) present: Slip,
}

/// The answer in motion's words.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settled {
    /// The contacts that hold.
    pub(super) held: Few<Held>,
    /// The others.
    pub(super) opening: Few<Pairing>,
    /// Smallest scaled slack of the answer.
    pub(super) margin: f64,
}

impl World {
    pub(super) fn touch(&self, pair: Pairing, k: &Kinematics) -> Touch {
        let o = &self.obstacles[pair.obstacle];
        Touch { arm: k.arm, normal: k.normal, friction: o.friction, restitution: o.restitution }
    }

    /// The contacts of `pairs` as an impact sees them.
    pub(super) fn contact_set<const N: usize, const M: usize>(
        &self,
        state: &State,
        pairs: impl Iterator<Item = Pairing>,
    ) -> Result<ContactSet<N, M>, ImpactError> {
        let turn = Turn::of(state);
        let mut touches = [Touch {
            arm: carom_num::Vec2::ZERO,
            normal: carom_num::Vec2::ZERO,
            friction: 0.0,
            restitution: 0.0,
        }; N];
        let mut count = 0;
        for pair in pairs {
            let Some(place) = touches.get_mut(count) else {
                return Err(ImpactError::TooMany { count: count + 1, most: N });
            };
            *place = self.touch(pair, &self.kinematics_turned(state, turn, pair));
            count += 1;
        }
        ContactSet::of_free_body(
            self.body.mass,
            self.body.inertia,
            state.twist.velocity,
            state.twist.spin,
            &touches[..count],
        )
    }

    /// Asks which of the touching contacts hold. `None`: no hypothesis is consistent.
    pub(super) fn ask(&self, state: &State, asked: &Few<Asked>) -> Option<Settled> {
        if asked.is_empty() {
            return Some(Settled { held: Few::default(), opening: Few::default(), margin: f64::INFINITY });
        }
        if asked.len() <= 2 {
            self.ask_sized::<2, 4>(state, asked)
        } else {
            self.ask_sized::<MOST_CONTACTS, { 2 * MOST_CONTACTS }>(state, asked)
        }
    }

    fn ask_sized<const N: usize, const M: usize>(
        &self,
        state: &State,
        asked: &Few<Asked>,
    ) -> Option<Settled> {
        let set: ContactSet<N, M> = self.contact_set(state, asked.iter().map(|a| a.pair)).ok()?;
        let mut slip = [0.0; N];
        for (s, a) in slip.iter_mut().zip(asked.iter()) {
            *s = a.slip;
        }
        let problem = self.rate_problem(&set, state, asked.iter().map(|a| a.pair), slip);
        let answer = problem.solve();
        let chosen = self.known_first(&problem, &answer, asked)?;
        let mut out = Settled { held: Few::default(), opening: Few::default(), margin: chosen.margin };
        for (i, a) in asked.iter().enumerate() {
            let guess = chosen.guess[i];
            // A contact without force is not held.
            let weightless = chosen.rates[i][1] <= 1e-9 * self.body.mass * self.gravity.norm();
            if guess.slip == Slip::Open || weightless {
                out.opening.push(a.pair);
            } else {
                let slip = if self.obstacles[a.pair.obstacle].friction == 0.0 && a.slip == 0.0 {
                    if chosen.response[i][0] < 0.0 { Slip::Backward } else { Slip::Forward }
                } else {
                    guess.slip
                };
                out.held.push(Held { pair: a.pair, slip });
            }
        }
        Some(out)
    }

    /// The rate problem of touching contacts in a state.
    fn rate_problem<'s, const N: usize, const M: usize>(
        &self,
        set: &'s ContactSet<N, M>,
        state: &State,
        pairs: impl Iterator<Item = Pairing>,
        slip: [f64; N],
    ) -> RateProblem<'s, N, M> {
        let turn = Turn::of(state);
        let (mut drive, mut load) = ([[0.0; 2]; N], [Load::Absent; N]);
        for (i, pair) in pairs.enumerate() {
            let k = self.kinematics_turned(state, turn, pair);
            drive[i] =
                [k.slip_bias + k.tangent().dot(self.gravity), k.normal_bias + k.normal.dot(self.gravity)];
            load[i] = Load::Touching(0.0);
        }
        RateProblem { count: set.count, operator: &set.operator, friction: &set.friction, drive, slip, load }
    }

    /// Forces (t, n) of held contacts that leave them indeterminate: the member of the family that the rate problem takes, so that the
    /// mode holds as long as any member does.
    pub(super) fn shared_forces(&self, state: &State, held: &Few<Held>) -> Option<[[f64; 2]; MOST_CONTACTS]> {
        const M: usize = 2 * MOST_CONTACTS;
        let pairs = || held.iter().map(|h| h.pair);
        let set: ContactSet<MOST_CONTACTS, M> = self.contact_set(state, pairs()).ok()?;
        let mut guess = [Guess { holds: false, slip: Slip::Open }; MOST_CONTACTS];
        for (g, h) in guess.iter_mut().zip(held.iter()) {
            *g = Guess { holds: true, slip: h.slip };
        }
        let problem = self.rate_problem(&set, state, pairs(), [0.0; MOST_CONTACTS]);
        problem.rates_of(&guess).map(|(rates, _)| rates)
    }

    /// Where an event has decided what a contact does, the hypothesis that says so, if it is consistent; else the preferred one.
    fn known_first<const N: usize, const M: usize>(
        &self,
        problem: &RateProblem<'_, N, M>,
        answer: &Answer<N>,
        asked: &Few<Asked>,
    ) -> Option<Solution<N>> {
        let mut present = [Slip::Open; N];
        for (p, a) in present.iter_mut().zip(asked.iter()) {
            *p = a.known.unwrap_or(a.present);
        }
        if asked.iter().any(|a| a.known.is_some()) {
            let guess = std::array::from_fn(|i| Guess { holds: present[i] != Slip::Open, slip: present[i] });
            if let Ok(solution) = problem.try_guess(&guess) {
                return Some(solution);
            }
        }
        answer.preferred(Some(&present)).copied()
    }
}
