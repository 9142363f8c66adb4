//! The equations of a mode, order by order: from the coefficients up to one order those of the next.
//!
//! In the contact's frame (t along it, n out of the obstacle) with a = (a_t, a_n) from the mass centre to the contact, u the slip, w the
//! spin, N and T the forces, and r the vertex from the mass centre:
//!
//! ```text
//! it slides:   T = p N,   N (1/m + a_t (a_t − p a_n)/J) = −bias_n − g_n,   ẇ = N (a_t − p a_n)/J,   u̇ = g_t + p N/m − ẇ a_n + bias_t
//! it sticks:   u = 0,   (J + m a²) ẇ = m (a_n (g_t + bias_t) − a_t (g_n + bias_n)),   N = −m (ẇ a_t + bias_n + g_n),
//!              T = m (ẇ a_n − bias_t − g_t)
//! vertex on a face:  the frame rests,   a = r − ρ n,   bias = −w² r
//! face on an end:    the frame turns with the body, a_n stays,   ȧ_t = −u,   bias_n = −2wu − w² a_n,   bias_t = −w² a_t
//! ```
//!
//! Source: the equations of motion with the contact's accelerations eliminated, as the general solution of a mode has them; their coefficients order by order as in
//! Jorba, Zou, Exp. Math. 14 (2005).

use super::expansion::{Expansion, Given};
use carom_impact::planar::Slip;
use carom_num::taylor::{INVERSE, product, product_but_newest, quotient, square};
use carom_num::{Vec2, every_order};

/// The coefficient of a constant.
#[inline(always)]
fn constant<const I: usize>(value: f64) -> f64 {
    if I == 0 { value } else { 0.0 }
}

impl<const P: usize> Expansion<P> {
    /// The coefficients of all orders from those at the start.
    pub(super) fn expand(&mut self) {
        match (self.given.by_vertex(), self.given.held.slip == Slip::Sticks) {
            (true, false) => every_order!(self, vertex_slides, P - 1),
            (true, true) => every_order!(self, vertex_sticks, P - 1),
            (false, false) => every_order!(self, face_slides, P - 1),
            (false, true) => every_order!(self, face_sticks, P - 1),
        }
        if self.given.by_vertex() {
            self.end_vertex();
        }
    }

    /// The spin times such a vector.
    #[inline(always)]
    fn swept(&self, v: Vec2, i: usize) -> (f64, f64) {
        let (cos, sin) = &self.turning;
        (v.x * cos[i] - v.y * sin[i], v.y * cos[i] + v.x * sin[i])
    }

    /// The spin and the turn of the next order.
    #[inline(always)]
    fn turn<const I: usize>(&mut self, angular: f64) {
        self.spin[I + 1] = angular * INVERSE[I];
        self.cos[I + 1] = -self.turning.1[I] * INVERSE[I];
        self.sin[I + 1] = self.turning.0[I] * INVERSE[I];
    }

    #[inline(always)]
    fn sweep<const I: usize>(&mut self) {
        self.turning.0[I] = product::<I, P>(&self.cos, &self.spin);
        self.turning.1[I] = product::<I, P>(&self.sin, &self.spin);
    }

    /// The normal force N of a contact that slides, of order `I`, from what bends its way; returns the angular acceleration ẇ. The newest terms of
    /// the products in N/m + a_t ẇ = −bias_n − g_n and ẇ = N (a_t − p a_n)/J are solved for.
    #[inline(always)]
    fn push<const I: usize>(&mut self, bend: f64, gravity: f64) -> f64 {
        let Given { pull, per_mass, per_inertia, .. } = self.given;
        self.lever[I] = per_inertia * (self.along[I] - pull * self.across[I]);
        if I == 0 {
            self.over = 1.0 / (per_mass + self.along[0] * self.lever[0]);
        }
        let known = product_but_newest::<I, P>(&self.lever, &self.force);
        let carried = product_but_newest::<I, P>(&self.along, &self.angular) + self.along[0] * known;
        self.force[I] = (bend - gravity - carried) * self.over;
        self.friction[I] = pull * self.force[I];
        self.angular[I] = known + self.lever[0] * self.force[I];
        self.angular[I]
    }

    /// The arm of a vertex in touch, of order `I`, and the spin times the vertex along n.
    #[inline(always)]
    fn arm<const I: usize>(&mut self) {
        let Given { radius, arm, .. } = self.given;
        self.sweep::<I>();
        let (along, across) = self.turned(arm, I);
        (self.along[I], self.across[I]) = (along, across - constant::<I>(radius));
    }

    /// A vertex that slides on a face. Of the mass centre's velocity v along t the slip is v − w a_n.
    #[inline(always)]
    fn vertex_slides<const I: usize>(&mut self) {
        let Given { radius, arm, gravity, per_mass, .. } = self.given;
        self.arm::<I>();
        self.bending[I] = self.swept(arm, I).1;
        if I > 0 {
            self.slip[I] = self.way[I] - self.bending[I] + radius * self.spin[I];
        }
        let bend = product::<I, P>(&self.spin, &self.bending);
        let angular = self.push::<I>(bend, constant::<I>(gravity.y));
        self.way[I + 1] = (constant::<I>(gravity.x) + per_mass * self.friction[I]) * INVERSE[I];
        self.turn::<I>(angular);
    }

    /// A vertex that sticks to a face, or rolls on it: v = w a_n along t and −w a_t along n.
    #[inline(always)]
    fn vertex_sticks<const I: usize>(&mut self) {
        let Given { radius, mass, inertia, gravity, .. } = self.given;
        self.arm::<I>();
        self.note_hold(I);
        let moment = mass * (gravity.x * self.across[I] - gravity.y * self.along[I]);
        let angular = if radius == 0.0 {
            if I == 0 {
                self.over = 1.0
                    / (inertia + mass * (self.along[0] * self.along[0] + self.across[0] * self.across[0]));
            }
            moment * self.over
        } else {
            // It rolls: the inertia about the contact changes.
            let arms = square::<I, P>(&self.along) + square::<I, P>(&self.across);
            self.lever[I] = constant::<I>(inertia) + mass * arms;
            if I == 0 {
                self.over = 1.0 / self.lever[0];
            }
            self.bending[I] = self.swept(self.given.arm, I).0;
            let rolls = mass * radius * product::<I, P>(&self.spin, &self.bending);
            self.angular[I] = quotient::<I, P>(moment + rolls, (&self.lever, self.over), &self.angular);
            self.angular[I]
        };
        self.turn::<I>(angular);
    }

    /// The forces that hold a vertex, of the order before: mass times the rates of the velocity, less gravity.
    #[inline(always)]
    fn note_hold(&mut self, i: usize) {
        let Given { radius, arm, mass, gravity, .. } = self.given;
        if i == 0 {
            return;
        }
        let (along, across) = self.swept(arm, i);
        let across = across - radius * self.spin[i];
        let gravity = if i == 1 { gravity } else { Vec2::ZERO };
        self.force[i - 1] = -mass * (i as f64 * along + gravity.y);
        self.friction[i - 1] = mass * (i as f64 * across - gravity.x);
    }

    /// What the last order of a vertex in touch lacks.
    fn end_vertex(&mut self) {
        let last = P - 1;
        let Given { radius, arm, .. } = self.given;
        (self.turning.0[last], self.turning.1[last]) = (0.0, 0.0);
        for i in 0..P {
            self.turning.0[last] += self.cos[i] * self.spin[last - i];
            self.turning.1[last] += self.sin[i] * self.spin[last - i];
        }
        (self.along[last], self.across[last]) = self.turned(arm, last);
        if self.given.held.slip == Slip::Sticks {
            self.note_hold(last);
        } else {
            self.slip[last] = self.way[last] - self.swept(arm, last).1 + radius * self.spin[last];
        }
    }

    /// Gravity in a frame that turns with the body, of order `I`.
    #[inline(always)]
    fn gravity<const I: usize>(&self) -> (f64, f64) {
        let g = self.given.gravity;
        (g.x * self.cos[I] + g.y * self.sin[I], g.y * self.cos[I] - g.x * self.sin[I])
    }

    /// A face that slides over an end.
    #[inline(always)]
    fn face_slides<const I: usize>(&mut self) {
        let (gravity, per_mass, across) = (self.gravity::<I>(), self.given.per_mass, self.across[0]);
        self.sweep::<I>();
        self.way[I] = square::<I, P>(&self.spin);
        self.bending[I] = 2.0 * self.slip[I] + across * self.spin[I];
        let bend = product::<I, P>(&self.spin, &self.bending);
        let angular = self.push::<I>(bend, gravity.1);
        let slip = gravity.0 + per_mass * self.friction[I]
            - angular * across
            - product::<I, P>(&self.way, &self.along);
        self.along[I + 1] = -self.slip[I] * INVERSE[I];
        self.slip[I + 1] = slip * INVERSE[I];
        self.turn::<I>(angular);
    }

    /// A face that turns about an end.
    #[inline(always)]
    fn face_sticks<const I: usize>(&mut self) {
        let (gravity, mass) = (self.gravity::<I>(), self.given.mass);
        let (along, across) = (self.along[0], self.across[0]);
        self.sweep::<I>();
        let squared = square::<I, P>(&self.spin);
        if I == 0 {
            self.over = 1.0 / (self.given.inertia + mass * (along * along + across * across));
        }
        let angular = mass * (gravity.0 * across - gravity.1 * along) * self.over;
        self.force[I] = mass * (squared * across - gravity.1 - angular * along);
        self.friction[I] = mass * (squared * along - gravity.0 + angular * across);
        self.turn::<I>(angular);
    }
}
