//! Impacts with friction.

use super::closing::Closed;
use super::contacts::{Answer, Conclusive, Way};
use super::grip::MOST_BEARING;
use super::rough::no_motion;
use super::run::{Clock, End};
use super::strike::pushed;
use super::terms::{Choice, RollError};
use super::walker::{Walker, without_way};
use super::{Mode, Observer, Supports};
use carom_impact::planar::ImpactError;
use carom_impact::spatial::{Conclusion, staged};
use carom_num::Vec3;

/// After an impact a support that rises slower than this, in units of the speeds before, stays on the plane.
const STAYS: f64 = 1e-11;

/// Approaches, in units of the motion's speeds, that press on a support whose slip is about to be stopped at once.
const PRESSED: [f64; 3] = [1e-12, 1e-11, 1e-10];
/// Slips below this, in units of the motion's speeds, are rounding.
const RESTS: f64 = 1e-13;

impl<O: Observer> Walker<'_, O> {
    /// Resolves an impact with friction.
    pub(super) fn strike_rough(
        &mut self,
        touching: Supports,
        striking: Supports,
    ) -> Result<Option<End>, RollError> {
        let answer = self.blow(touching, striking, 0.0)?;
        self.struck(touching, striking, answer)
    }

    fn struck(
        &mut self,
        touching: Supports,
        striking: Supports,
        Answer { conclusion, way }: Answer,
    ) -> Result<Option<End>, RollError> {
        touching.iter().for_each(|i| self.heights[i] = 0.0);
        self.effort.impacts += 1;
        let Some(way) = way else { return Ok(Some(without_way(conclusion, Clock::Impact))) };
        if conclusion == Conclusion::Several && self.options.choice == Choice::End {
            return Ok(Some(End::Several(Clock::Impact)));
        }
        let (before, kept) = (self.state, way.kept);
        self.state = pushed(&before, self.world, &way.pushes);
        if self.tell(&before, [touching, striking], way, conclusion).is_break() {
            return Ok(Some(End::Stopped));
        }
        self.mode = Mode::Flight;
        match self.note(touching, touching)? {
            Closed::Yes(end) => Ok(end),
            Closed::Not => self.hold(kept, None),
        }
    }

    /// Friction lets no motion go on that is free of impacts, though nothing approaches.
    ///
    /// Where the normal force of one support grows without bound its slip stops at once, a moment before nothing would press it out any more: it is pressed as much as
    /// that takes.
    pub(super) fn strike_unapproached(&mut self, touching: Supports) -> Result<Option<End>, RollError> {
        self.forget_series();
        let pressed = if touching.len() == 1 { PRESSED.as_slice() } else { &[] };
        for press in std::iter::once(&0.0).chain(pressed) {
            let answer = self.blow(touching, Supports::NONE, *press)?;
            if answer.way.as_ref().is_some_and(|way| way.pushes.iter().any(|(_, p)| p.norm() > 0.0)) {
                return self.struck(touching, Supports::NONE, answer);
            }
        }
        Ok(Some(no_motion()))
    }

    /// The impact of these supports: no way on where they jam, else one, also where there are several. Those that are held approach at `press`, in units of the
    /// motion's speeds.
    fn blow(&self, touching: Supports, striking: Supports, press: f64) -> Result<Answer, RollError> {
        match touching.len() {
            0..=2 => self.blow_sized::<2>(touching, striking, press),
            3..=4 => self.blow_sized::<4>(touching, striking, press),
            5..=MOST_BEARING => self.blow_sized::<MOST_BEARING>(touching, striking, press),
            count => Err(RollError::TooManyTouching { time: self.time, count, most: MOST_BEARING }),
        }
    }

    fn blow_sized<const N: usize>(
        &self,
        touching: Supports,
        striking: Supports,
        press: f64,
    ) -> Result<Answer, RollError> {
        let law = self.world.friction().map_or_else(Default::default, super::Friction::law);
        let mut set = self.set_of::<N>(touching)?;
        let size = self.state.velocity.norm() + self.state.spin.norm() * self.scales.length;
        let held = self.mode.held(self.world.body());
        let slips = self.slips_on_plane(touching, size);
        for ((k, i), slip) in touching.iter().enumerate().zip(slips) {
            let free = striking.contains(i) || !held.contains(i);
            let fall = if free { self.velocity_of(i).z } else { -press * size };
            set.velocity[k] = set.frame[k] * Vec3::new(slip.x, slip.y, fall);
        }
        let out = match staged::resolve(&set, law) {
            Ok(out) => out,
            Err(ImpactError::Jammed | ImpactError::Unending { .. }) => {
                return Ok(Answer { conclusion: Conclusion::None, way: None });
            }
            Err(error) => return Err(RollError::Impact { time: self.time, error }),
        };
        let of = |(k, i): (usize, usize)| (i, set.frame[k].transposed() * out.impulse[k]);
        let stays = |(k, _): &(usize, usize)| out.velocity[*k].z <= STAYS * size;
        let way = Way {
            kept: touching.iter().enumerate().filter(stays).map(|(_, i)| i).collect(),
            pushes: touching.iter().enumerate().map(of).collect(),
            friction_demand: out.friction_demand(),
        };
        Ok(Answer { conclusion: out.branches.conclusion(), way: Some(way) })
    }

    /// Slips of supports that all touch the plane, world axes: those of one motion along it, exactly. Slips that are zero but for rounding are zero, and the
    /// others are of the turn about such a support.
    ///
    /// Their distances do not change, so that differences of slips along them are nothing but the rounding of the body's speeds. A hop may be slower than that is
    /// relative to it, and in its impact no impulse could ever bring such a slip to rest.
    fn slips_on_plane(&self, touching: Supports, size: f64) -> Vec<Vec3> {
        let state = &self.state;
        let along = |v: Vec3| Vec3::new(v.x, v.y, 0.0);
        let slips: Vec<Vec3> = touching.iter().map(|i| along(self.velocity_of(i))).collect();
        let arm = |i: usize| along(state.attitude.apply(self.world.body().supports()[i]));
        let arms: Vec<Vec3> = touching.iter().map(arm).collect();
        let slowest = (0..slips.len()).min_by(|&i, &j| slips[i].norm().total_cmp(&slips[j].norm()));
        let Some(base) = slowest else { return slips };
        let own = if slips[base].norm() <= RESTS * size { Vec3::ZERO } else { slips[base] };
        let turn = Vec3::Z * state.attitude.apply(state.spin).z;
        let of = |arm: &Vec3| own + turn.cross(*arm - arms[base]);
        let rounded = |slip: Vec3| if slip.norm() <= RESTS * size { Vec3::ZERO } else { slip };
        arms.iter().map(of).map(rounded).collect()
    }
}
