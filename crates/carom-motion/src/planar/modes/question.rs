//! The rate problem of motion: which touching contacts hold, and how.

use super::mode::Held;
use crate::planar::contact::{
    World,
    kinematics::{Kinematics, Pairing, Turn},
    touching::{Few, MOST_TOUCHING},
};
use crate::planar::geometry::State;
use crate::tolerance::{MODE_CONTRADICTION, SIGNIFICANT_RATE, WEIGHTLESS};
use carom_impact::ImpactError;
use carom_impact::Load;
use carom_impact::planar::rate::RateProblem;
use carom_impact::planar::{
    Answer, ContactSet, Guess, MOST_CONTACTS, Meeting, RigidBody, Slip, Solution, Touch,
};
use carom_num::Vec2;

/// A touching contact as the rate problem sees it.
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Asked {
    pub(in crate::planar) pair: Pairing,
    /// Slip velocity, exactly zero where it is at rest along t [m/s].
    pub(in crate::planar) slip: f64,
    /// What this contact is known to do, where an event has just decided it.
    pub(in crate::planar) known: Option<Slip>,
    /// What it did before.
    pub(in crate::planar) present: Slip,
}

/// The answer in motion's words.
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Settled {
    /// The contacts that hold.
    pub(in crate::planar) held: Few<Held>,
    /// The others.
    pub(in crate::planar) opening: Few<Pairing>,
    /// Smallest scaled slack of the answer.
    pub(in crate::planar) margin: f64,
}

/// The states of the bodies, and how they are turned there.
pub(super) type Posed<'a, const B: usize> = (&'a [State; B], &'a [Turn; B]);

impl World {
    fn touch(&self, pair: Pairing, k: &Kinematics) -> Touch {
        let o = self.surface(pair);
        Touch { arm: k.arm, normal: k.normal, friction: o.friction, restitution: o.restitution }
    }

    /// Kinematics of each of these pairs.
    fn kinematics_of_each<const B: usize, const N: usize>(
        &self,
        (states, turns): Posed<'_, B>,
        pairs: impl Iterator<Item = Pairing>,
    ) -> Result<[Kinematics; N], ImpactError> {
        let mut out = [Kinematics::default(); N];
        for (i, pair) in pairs.enumerate() {
            let Some(place) = out.get_mut(i) else {
                return Err(ImpactError::TooMany { count: i + 1, most: N });
            };
            *place = self.kinematics_turned(states, turns, pair);
        }
        Ok(out)
    }

    /// The contacts of `pairs` as an impact sees them, and their kinematics.
    pub(super) fn contact_set<const B: usize, const N: usize, const M: usize>(
        &self,
        posed: Posed<'_, B>,
        pairs: impl Iterator<Item = Pairing> + Clone,
    ) -> Result<(ContactSet<N, M>, [Kinematics; N]), ImpactError> {
        let seen: [Kinematics; N] = self.kinematics_of_each(posed, pairs.clone())?;
        if B > 1 {
            return self.set_of_bodies(posed.0, pairs.zip(&seen)).map(|set| (set, seen));
        }
        let mut touches = [Touch { arm: Vec2::ZERO, normal: Vec2::ZERO, friction: 0.0, restitution: 0.0 }; N];
        let mut count = 0;
        for ((place, pair), k) in touches.iter_mut().zip(pairs).zip(&seen) {
            *place = self.touch(pair, k);
            count += 1;
        }
        let (body, twist) = (&self.bodies[0], &posed.0[0].twist);
        let touches = &touches[..count];
        let set = ContactSet::of_free_body(body.mass, body.inertia, twist.velocity, twist.spin, touches)?;
        Ok((set, seen))
    }

    /// The contacts of several bodies; each obstacle is a body that nothing moves.
    fn set_of_bodies<'k, const B: usize, const N: usize, const M: usize>(
        &self,
        states: &[State; B],
        contacts: impl Iterator<Item = (Pairing, &'k Kinematics)>,
    ) -> Result<ContactSet<N, M>, ImpactError> {
        let free = self.bodies.iter().zip(states).map(|(body, state)| RigidBody {
            mass: body.mass,
            inertia: body.inertia,
            centre: state.pose.centre,
            velocity: state.twist.velocity,
            spin: state.twist.spin,
        });
        let fixed = self.obstacles.iter().map(|_| RigidBody::FIXED);
        let bodies: Vec<RigidBody> = free.chain(fixed).collect();
        let meeting = |(pair, k): (Pairing, &Kinematics)| {
            let surface = self.surface(pair);
            Meeting {
                into: pair.body,
                out_of: self.other_body(pair).unwrap_or(self.bodies.len() + pair.obstacle),
                point: states[pair.body].pose.centre + k.arm,
                normal: k.normal,
                friction: surface.friction,
                restitution: surface.restitution,
            }
        };
        let meetings: Vec<Meeting> = contacts.map(meeting).collect();
        ContactSet::of_bodies(&bodies, &meetings)
    }

    /// Asks which of the touching contacts hold. `None`: no hypothesis is consistent.
    pub(in crate::planar) fn ask<const B: usize>(
        &self,
        posed: Posed<'_, B>,
        asked: &Few<Asked>,
    ) -> Option<Settled> {
        if asked.is_empty() {
            return Some(Settled { held: Few::default(), opening: Few::default(), margin: f64::INFINITY });
        }
        if asked.len() <= 2 {
            self.ask_sized::<B, 2, 4>(posed, asked)
        } else if asked.len() <= MOST_CONTACTS {
            self.ask_sized::<B, MOST_CONTACTS, { 2 * MOST_CONTACTS }>(posed, asked)
        } else {
            self.ask_sized::<B, MOST_TOUCHING, { 2 * MOST_TOUCHING }>(posed, asked)
        }
    }

    fn ask_sized<const B: usize, const N: usize, const M: usize>(
        &self,
        posed: Posed<'_, B>,
        asked: &Few<Asked>,
    ) -> Option<Settled> {
        let pairs = asked.iter().map(|a| a.pair);
        let (set, seen): (ContactSet<N, M>, _) = self.contact_set(posed, pairs.clone()).ok()?;
        let mut slip = [0.0; N];
        for (s, a) in slip.iter_mut().zip(asked.iter()) {
            *s = a.slip;
        }
        let problem = self.rate_problem(&set, pairs.zip(&seen), slip);
        let answer = problem.solve();
        let chosen = self.known_first(&problem, &answer, asked)?;
        let mut out = Settled { held: Few::default(), opening: Few::default(), margin: chosen.margin };
        let heaviest = self.bodies.iter().map(|b| b.mass).fold(0.0, f64::max);
        for (i, a) in asked.iter().enumerate() {
            let guess = chosen.guess[i];
            // A contact without force is not held.
            let weightless = chosen.rates[i][1] <= WEIGHTLESS * heaviest * self.gravity.norm();
            if guess.slip == Slip::Open || weightless {
                out.opening.push(a.pair);
            } else {
                let slip = if self.surface(a.pair).friction == 0.0 && a.slip == 0.0 {
                    self.begins_to_slip(chosen.response[i][0], a.present)
                } else {
                    guess.slip
                };
                out.held.push(Held { pair: a.pair, slip });
            }
        }
        Some(out)
    }

    /// Which way a contact without friction begins to slip with this rate [m/s²]; where the rate is rounding, as the contact did before.
    fn begins_to_slip(&self, rate: f64, present: Slip) -> Slip {
        let scales = self.scales();
        match present {
            Slip::Forward | Slip::Backward if rate.abs() <= SIGNIFICANT_RATE * scales.speed / scales.time => {
                present
            }
            _ if rate < 0.0 => Slip::Backward,
            _ => Slip::Forward,
        }
    }

    /// The rate problem of touching contacts in a state.
    fn rate_problem<'s, 'k, const N: usize, const M: usize>(
        &self,
        set: &'s ContactSet<N, M>,
        contacts: impl Iterator<Item = (Pairing, &'k Kinematics)>,
        slip: [f64; N],
    ) -> RateProblem<'s, N, M> {
        let (mut drive, mut load) = ([[0.0; 2]; N], [Load::Absent; N]);
        for (i, (pair, k)) in contacts.enumerate() {
            let pulled = |bias: f64, along: Vec2| bias + self.gravity_along(pair, along);
            drive[i] = [pulled(k.slip_bias, k.tangent()), pulled(k.normal_bias, k.normal)];
            load[i] = Load::Touching(0.0);
        }
        RateProblem { count: set.count, operator: &set.operator, friction: &set.friction, drive, slip, load }
    }

    /// Forces (t, n) of held contacts that do not determine them: of all that are possible, those that the rate problem takes, so that the mode holds
    /// as long as any of them does.
    pub(super) fn shared_forces<const B: usize>(
        &self,
        posed: Posed<'_, B>,
        held: &Few<Held>,
    ) -> Option<Vec<[f64; 2]>> {
        if held.len() <= MOST_CONTACTS {
            self.shared_sized::<B, MOST_CONTACTS, { 2 * MOST_CONTACTS }>(posed, held)
        } else {
            self.shared_sized::<B, MOST_TOUCHING, { 2 * MOST_TOUCHING }>(posed, held)
        }
    }

    fn shared_sized<const B: usize, const N: usize, const M: usize>(
        &self,
        posed: Posed<'_, B>,
        held: &Few<Held>,
    ) -> Option<Vec<[f64; 2]>> {
        let pairs = || held.iter().map(|h| h.pair);
        let (set, seen): (ContactSet<N, M>, _) = self.contact_set(posed, pairs()).ok()?;
        let mut guess = [Guess { holds: false, slip: Slip::Open }; N];
        for (g, h) in guess.iter_mut().zip(held.iter()) {
            *g = Guess { holds: true, slip: h.slip };
        }
        let problem = self.rate_problem(&set, pairs().zip(&seen), [0.0; N]);
        problem.rates_of(&guess, MODE_CONTRADICTION).map(|(rates, _)| rates[..set.count].to_vec())
    }

    /// The consistent hypothesis that says what an event has just decided, if there is one; else the preferred hypothesis.
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
        // Of more contacts than are examined what they do at present is tried before pivoting is believed to have found nothing.
        if asked.iter().any(|a| a.known.is_some()) || (answer.count == 0 && !answer.examined) {
            let guess = std::array::from_fn(|i| Guess { holds: present[i] != Slip::Open, slip: present[i] });
            if let Ok(solution) = problem.try_guess(&guess) {
                return Some(solution);
            }
        }
        answer.preferred(Some(&present)).copied()
    }
}
