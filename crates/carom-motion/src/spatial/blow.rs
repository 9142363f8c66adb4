//! Impacts with friction.

use super::closing::Closed;
use super::contacts::Conclusive;
use super::grip::MOST_BEARING;
use super::rough::no_motion;
use super::run::{Clock, End, Impact};
use super::strike::pushed;
use super::terms::{Choice, RollError};
use super::walker::Walker;
use super::{Mode, Observer, State, Supports};
use carom_impact::planar::ImpactError;
use carom_impact::spatial::{Conclusion, staged};
use carom_num::Vec3;

/// After an impact a support that rises slower than this, in units of the speeds before, stays on the plane.
const STAYS: f64 = 1e-11;

/// Slips below this, in units of the motion's speeds, are rounding.
const RESTS: f64 = 1e-13;

/// What an impact comes to.
struct Blow {
    pushes: Vec<(usize, Vec3)>,
    /// Velocities along the normal after it.
    rises: Vec<(usize, f64)>,
    friction_demand: f64,
    conclusion: Conclusion,
}

impl<O: Observer> Walker<'_, O> {
    /// Resolves an impact with friction.
    pub(super) fn strike_rough(
        &mut self,
        touching: Supports,
        striking: Supports,
    ) -> Result<Option<End>, RollError> {
        touching.iter().for_each(|i| self.heights[i] = 0.0);
        self.effort.impacts += 1;
        let Some(blow) = self.blow(touching, striking)? else {
            return Ok(Some(End::NoConsistentOutcome(Clock::Impact)));
        };
        if blow.conclusion == Conclusion::Several && self.options.choice == Choice::End {
            return Ok(Some(End::Several(Clock::Impact)));
        }
        let before = self.state;
        let size = before.velocity.norm() + before.spin.norm() * self.scales.length;
        self.state = pushed(&before, self.world, &blow.pushes);
        let stays = |(_, rise): &&(usize, f64)| *rise <= STAYS * size;
        let kept: Supports = blow.rises.iter().filter(stays).map(|(i, _)| *i).collect();
        let seen = self.tell(&before, touching, striking, kept, blow);
        if seen.is_break() {
            return Ok(Some(End::Stopped));
        }
        self.mode = Mode::Flight;
        match self.note(touching, touching)? {
            Closed::Yes(end) => Ok(end),
            Closed::Not => self.hold(kept, None),
        }
    }

    fn tell(
        &mut self,
        before: &State,
        touching: Supports,
        striking: Supports,
        kept: Supports,
        blow: Blow,
    ) -> std::ops::ControlFlow<()> {
        let body = self.world.body();
        let impact = Impact {
            time: self.time,
            touching,
            striking,
            kept,
            attitude: before.attitude,
            spin_before: before.spin,
            spin_after: self.state.spin,
            kinetic_before: before.kinetic(body),
            kinetic_after: self.state.kinetic(body),
            potential: before.potential(self.world),
            impulses: blow.pushes,
            friction_demand: blow.friction_demand,
            conclusion: blow.conclusion,
        };
        let seen = self.observer.impact(&impact);
        self.impacts.push(impact);
        seen
    }

    /// Friction lets no motion go on that is free of impacts, though nothing approaches.
    pub(super) fn strike_unapproached(&mut self, touching: Supports) -> Result<Option<End>, RollError> {
        self.forget_series();
        let blow = self.blow(touching, Supports::NONE)?;
        let moves = blow.is_some_and(|blow| blow.pushes.iter().any(|(_, p)| p.norm() > 0.0));
        if moves { self.strike_rough(touching, Supports::NONE) } else { Ok(Some(no_motion())) }
    }

    /// The impact of these supports; `None` where they jam.
    fn blow(&self, touching: Supports, striking: Supports) -> Result<Option<Blow>, RollError> {
        match touching.len() {
            0..=2 => self.blow_sized::<2>(touching, striking),
            3..=4 => self.blow_sized::<4>(touching, striking),
            5..=MOST_BEARING => self.blow_sized::<MOST_BEARING>(touching, striking),
            count => Err(RollError::TooManyTouching { time: self.time, count, most: MOST_BEARING }),
        }
    }

    fn blow_sized<const N: usize>(
        &self,
        touching: Supports,
        striking: Supports,
    ) -> Result<Option<Blow>, RollError> {
        let law = self.world.friction().map_or_else(Default::default, super::Friction::law);
        let mut set = self.set_of::<N>(touching)?;
        let size = self.state.velocity.norm() + self.state.spin.norm() * self.scales.length;
        let held = self.mode.held(self.world.body());
        for (k, i) in touching.iter().enumerate() {
            let velocity = self.velocity_of(i);
            let rests = Vec3::new(velocity.x, velocity.y, 0.0).norm() <= RESTS * size;
            let slip = if rests { Vec3::ZERO } else { set.velocity[k] };
            let fall = if striking.contains(i) || !held.contains(i) { velocity.z } else { 0.0 };
            set.velocity[k] = Vec3::new(slip.x, slip.y, fall);
        }
        let out = match staged::resolve(&set, law) {
            Ok(out) => out,
            Err(ImpactError::Jammed | ImpactError::Unending { .. }) => return Ok(None),
            Err(error) => return Err(RollError::Impact { time: self.time, error }),
        };
        let of = |(k, i): (usize, usize)| (i, set.frame[k].transposed() * out.impulse[k]);
        Ok(Some(Blow {
            pushes: touching.iter().enumerate().map(of).collect(),
            rises: touching.iter().enumerate().map(|(k, i)| (i, out.velocity[k].z)).collect(),
            friction_demand: out.friction_demand(),
            conclusion: out.branches.conclusion(),
        }))
    }
}
