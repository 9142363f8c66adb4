//! Modes whose acceleration stays what it is: their motion is known without integration.
//!
//! Where two contacts of a lone body have one normal and lie apart, neither can stay closed while the body turns: its angle keeps, and with it
//! every contact's normal. Where all contacts slip, the direction of each contact's force keeps as well. The sum of the forces is then the
//! same at all times if these directions are one (their sum balances gravity along the normal), or if no contact moves in the body
//! (nothing in the mode's equations changes).

use super::events::{Vector, pack, rate, unpack};
use super::walker::Walker;
use crate::planar::geometry::{Feature, State};
use crate::planar::modes::mode::Acceleration;
use crate::tolerance::{KEEPS_ANGLE_ARM, ONE_DIRECTION_SINE, STILL_SPEED};
use carom_impact::planar::Slip;
use carom_num::Vec2;
use carom_num::ode8::Step;

impl<const B: usize> Walker<'_, B> {
    /// True where the acceleration of the present mode stays what it is.
    pub(super) fn is_steady(&self) -> bool {
        let lone = B == 1 && self.states.iter().all(|s| self.turns_not(s));
        let (Some(first), true) = (self.held.get(0), lone && self.held.len() > 1) else { return false };
        let turns = self.turns();
        let of = |pair| self.world.kinematics_turned(&self.states, &turns, pair);
        let one = of(first.pair);
        let pull_of_one = first.slip.pull(self.world.surface(first.pair).friction);
        let (mut apart, mut still, mut same_pull) = (0.0_f64, true, true);
        for h in self.held.iter() {
            let k = of(h.pair);
            if h.slip == Slip::Sticks
                || matches!(h.pair.feature, Feature::VertexOnEnd { .. })
                || k.normal.cross(one.normal).abs() > ONE_DIRECTION_SINE
                || k.normal.dot(one.normal) < 0.0
            {
                return false;
            }
            apart = apart.max((k.arm - one.arm).dot(one.tangent()).abs());
            still &= matches!(h.pair.feature, Feature::VertexOnFace { .. });
            same_pull &= h.slip.pull(self.world.surface(h.pair).friction) == pull_of_one;
        }
        apart > KEEPS_ANGLE_ARM * self.scales.length && (still || same_pull)
    }

    /// What two contacts have left of a spin is rounding.
    pub(super) fn turns_not(&self, state: &State) -> bool {
        state.twist.spin.abs() * self.scales.length <= STILL_SPEED * self.scales.speed
    }

    /// A step of a steady mode, exact at any length.
    pub(super) fn steady_step(
        &self,
        start: &Vector<B>,
        start_rate: &Vector<B>,
        length: f64,
    ) -> Step<Vector<B>> {
        let at = |time| steadily(start, start_rate, time);
        Step::between(at(0.0), at(length), length)
    }
}

/// The states after a time at which the accelerations stay what they are and nothing turns, and their rates there.
pub(super) fn steadily<const B: usize>(
    start: &Vector<B>,
    start_rate: &Vector<B>,
    time: f64,
) -> (Vector<B>, Vector<B>) {
    let mut states = unpack(start);
    let mut accelerations = [Acceleration::default(); B];
    for ((state, acceleration), rate) in states.iter_mut().zip(&mut accelerations).zip(start_rate) {
        state.twist.spin = 0.0;
        acceleration.linear = Vec2::new(rate[3], rate[4]);
        *state = state.flown(acceleration.linear, time);
    }
    let end = pack(&states);
    (end, rate(&end, &accelerations))
}
