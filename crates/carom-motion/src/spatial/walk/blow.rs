//! Impacts with friction.

use super::closing::Closed;
use super::rough::no_motion;
use super::strike::pushed;
use super::walker::{Walker, without_way};
use crate::MotionError;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::contacts::{Answer, Way};
use crate::spatial::modes::frictional::frictional_contacts;
use crate::spatial::modes::grip::MOST_BEARING;
use crate::spatial::modes::mode::Mode;
use crate::spatial::record::run::{Clock, End};
use crate::spatial::terms::Choice;
use crate::tolerance::{FAINT_STRIKE, PRESSING_APPROACHES, SUPPORT_STAYS, SUPPORT_STICKS};
use carom_impact::ImpactError;
use carom_impact::spatial::{Conclusion, staged};
use carom_num::Vec3;

/// Impacts without approach at one instant after which nothing is left that friction lets go on.
const MOST_FORCED: u32 = 16;

impl Walker<'_> {
    /// Resolves an impact with friction.
    pub(super) fn strike_rough(
        &mut self,
        touching: Supports,
        striking: Supports,
    ) -> Result<Option<End>, MotionError> {
        let (touching, answer) = self.blow_on_all(touching, None)?;
        self.struck(touching, striking, answer)
    }

    fn struck(
        &mut self,
        touching: Supports,
        striking: Supports,
        Answer { conclusion, way }: Answer,
    ) -> Result<Option<End>, MotionError> {
        touching.union(self.beside).iter().for_each(|i| self.heights[i] = 0.0);
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
        // What rebounds rests at the limit of its series.
        match self.note(touching, striking, touching)? {
            Closed::Yes(end) => Ok(end),
            Closed::Not => self.hold(kept, None),
        }
    }

    /// An impact although nothing approaches: friction lets no motion go on that is free of impacts.
    ///
    /// Where the normal force of one support grows without bound, its slip stops at once, a moment before nothing would press it out any more. The
    /// support is pressed as much as that takes.
    pub(super) fn strike_unapproached(&mut self, touching: Supports) -> Result<Option<End>, MotionError> {
        self.forget_series();
        let (instant, count) = self.forced;
        self.forced = if instant == self.time { (instant, count + 1) } else { (self.time, 0) };
        if self.forced.1 > MOST_FORCED {
            return Ok(Some(no_motion()));
        }
        let touching = self.askable(touching);
        let slips = |i: usize| self.slip_of(i) != Vec3::ZERO;
        // Where some stick the press alone would be taken back. What has just come down slowly had an approach, which holding it has taken away.
        let presses = !self.come_down(touching).is_empty() || touching.iter().all(slips);
        let pressed =
            if presses && touching.iter().any(slips) { PRESSING_APPROACHES.as_slice() } else { &[] };
        let pushes = |answer: &Answer| {
            answer.way.as_ref().is_some_and(|way| way.pushes.iter().any(|(_, p)| p.norm() > 0.0))
        };
        let sliding = touching.those(slips);
        let mut least = None;
        for press in std::iter::once(&0.0).chain(pressed) {
            let (touching, answer) = self.blow_on_all(touching, Some(*press))?;
            if !pushes(&answer) {
                continue;
            }
            // Where all slide on as they did the press alone is taken back, and the same is asked again.
            let goes_on =
                answer.way.as_ref().is_some_and(|way| way.kept == touching && way.sliding == sliding);
            if *press == 0.0 || !goes_on {
                return self.struck(touching, Supports::NONE, answer);
            }
            least = least.or(Some((touching, answer)));
        }
        match least {
            Some((touching, answer)) => self.struck(touching, Supports::NONE, answer),
            None => Ok(Some(no_motion())),
        }
    }

    /// Those of these supports that have just come down: the mode does not hold them yet.
    fn come_down(&self, touching: Supports) -> Supports {
        touching.difference(self.mode.held(self.world))
    }

    /// The impact of these supports. There is no way on where they jam; else there is one, also where the law leaves several. `press` is given
    /// where friction forces the impact: supports that have just come down approach at it, or else those that are held, in units of the motion's speeds.
    pub(super) fn blow(&self, touching: Supports, press: Option<f64>) -> Result<Answer, MotionError> {
        match touching.len() {
            0..=2 => self.blow_sized::<2>(touching, press),
            3..=4 => self.blow_sized::<4>(touching, press),
            5..=8 => self.blow_sized::<8>(touching, press),
            9..=MOST_BEARING => self.blow_sized::<MOST_BEARING>(touching, press),
            count => Err(MotionError::TooManyTouching { time: self.time, count, most: MOST_BEARING }),
        }
    }

    fn blow_sized<const N: usize>(
        &self,
        touching: Supports,
        press: Option<f64>,
    ) -> Result<Answer, MotionError> {
        let law = self
            .world
            .friction()
            .map_or_else(Default::default, crate::spatial::geometry::friction::Friction::law);
        let refused = |error| MotionError::Impact { time: self.time, error };
        let size = self.top_speed();
        let held = self.mode.held(self.world);
        let mut set = frictional_contacts::<N>(self.world, &self.state, touching, held).map_err(refused)?;
        let came = self.come_down(touching);
        let approaching = if came.is_empty() { held } else { came };
        for (k, i) in touching.iter().enumerate() {
            match press {
                Some(press) if approaching.contains(i) => set.velocity[k].z = -press * size,
                _ if held.contains(i) => set.velocity[k].z = 0.0,
                _ => {}
            }
        }
        // A bounce from here may be lower than what heights are told from zero by: it would be struck down again before it has risen. Where friction forces the impact it need not be.
        let faint = FAINT_STRIKE * self.scales.speed;
        let fastest = |speeds: &[Vec3; N], way: f64| {
            speeds.iter().take(touching.len()).map(|u| way * u.z).fold(0.0, f64::max)
        };
        let resolved = |set: &_| staged::resolve_preferring(set, law, self.options.choice.preference());
        let returns = || resolved(&set).is_ok_and(|out| fastest(&out.velocity, 1.0) > faint);
        if fastest(&set.velocity, -1.0) <= faint && !(press.is_some() && returns()) {
            set.restitution = [0.0; N];
        }
        let out = match resolved(&set) {
            Ok(out) => out,
            // An impact that comes to no end is physics, not a fault: the law has no way on, and the run ends by saying so.
            Err(ImpactError::Jammed | ImpactError::Circling { .. } | ImpactError::Unending { .. }) => {
                return Ok(Answer { conclusion: Conclusion::None, way: None });
            }
            Err(error) => return Err(refused(error)),
        };
        let of = |(k, i): (usize, usize)| (i, set.frame[k].transposed() * out.impulse[k]);
        let stays = |(k, _): &(usize, usize)| out.velocity[*k].z <= SUPPORT_STAYS * size;
        let slip = |k: usize| Vec3::new(out.velocity[k].x, out.velocity[k].y, 0.0).norm();
        let slides = |(k, _): &(usize, usize)| slip(*k) > SUPPORT_STICKS * size;
        let way = Way {
            kept: touching.iter().enumerate().filter(stays).map(|(_, i)| i).collect(),
            sliding: touching.iter().enumerate().filter(stays).filter(slides).map(|(_, i)| i).collect(),
            pushes: touching.iter().enumerate().map(of).collect(),
            friction_demand: out.friction_demand(),
            open: out.freedom,
        };
        Ok(Answer { conclusion: out.conclusion(), way: Some(way) })
    }
}
