//! What the rate problem says of supports that touch and do not approach.

use super::walker::Walker;
use crate::MotionError;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::contacts::Conclusive;
use crate::spatial::modes::frictional::contacts_of;
use crate::spatial::modes::grip::MOST_BEARING;
use crate::spatial::modes::mode::Mode as BodyMode;
use crate::spatial::terms::Choice;
use crate::tolerance::{INSIDE_CONE, WEIGHTLESS};
use carom_impact::Load;
use carom_impact::spatial::{Conclusion, Mode as ContactMode, RateProblem, Solution};
use carom_num::Vec3;

/// What becomes of supports that touch.
#[derive(Clone, Debug, Default)]
pub(super) struct Carries {
    pub(super) sticking: Supports,
    pub(super) slipping: Supports,
    /// Where slips that are zero start, world axes.
    pub(super) leads: Vec<(usize, Vec3)>,
}

/// Which of the ways on that are consistent.
#[derive(Clone, Copy)]
enum Wanted {
    /// What goes on as it does where that is one, else as the choice says.
    Preferred,
    /// One that does not go on as it does.
    Another,
}

impl Walker<'_> {
    /// Accelerations of supports of the free body, body axes.
    fn free_accelerations(&self, asked: Supports) -> Vec<Vec3> {
        let (body, spin) = (self.world.body(), self.state.spin);
        let turning = body.mobility() * -spin.cross(body.inertia() * spin);
        let gravity = self.state.attitude.undo(self.world.gravity());
        let of = |i: usize| {
            let (arm, bent) = (self.world.arm(i, self.state.pose()), self.world.bent(i, &self.state));
            gravity + turning.cross(arm) + bent
        };
        asked.iter().map(of).collect()
    }

    pub(super) fn ask_rough(&self, asked: Supports) -> Result<(Conclusion, Option<Carries>), MotionError> {
        self.ask_for(asked, Wanted::Preferred)
    }

    /// A consistent way on in which supports do not all do what they do; `None` where there is none.
    pub(super) fn ask_for_another(&self, asked: Supports) -> Result<Option<Carries>, MotionError> {
        Ok(self.ask_for(asked, Wanted::Another)?.1)
    }

    fn ask_for(&self, asked: Supports, wanted: Wanted) -> Result<(Conclusion, Option<Carries>), MotionError> {
        let asked = self.askable(asked);
        let at_rest = asked.iter().all(|i| self.slip_of(i) == Vec3::ZERO);
        // What lies between the ends of an edge at rest adds nothing to what they can hold.
        let asked = match BodyMode::holding(self.world, asked, self.state.pose()) {
            BodyMode::Edge { ends, .. } if at_rest && self.world.is_of_one_plane(asked) => {
                ends.into_iter().collect()
            }
            _ => asked,
        };
        match asked.len() {
            0..=2 => self.ask_rough_sized::<2>(asked, wanted),
            3..=4 => self.ask_rough_sized::<4>(asked, wanted),
            5..=8 => self.ask_rough_sized::<8>(asked, wanted),
            9..=MOST_BEARING => self.ask_rough_sized::<MOST_BEARING>(asked, wanted),
            count => Err(MotionError::TooManyTouching { time: self.time, count, most: MOST_BEARING }),
        }
    }

    /// Accelerations along a plane this small, in units of gravity, are rounding; in the frame of a support.
    fn stays_put(&self, acceleration: Vec3) -> bool {
        self.stays(Vec3::new(acceleration.x, acceleration.y, 0.0).norm())
    }

    fn stays(&self, acceleration: f64) -> bool {
        acceleration.abs() <= INSIDE_CONE * self.world.gravity().norm()
    }

    fn ask_rough_sized<const N: usize>(
        &self,
        asked: Supports,
        wanted: Wanted,
    ) -> Result<(Conclusion, Option<Carries>), MotionError> {
        let refused = |error| MotionError::Impact { time: self.time, error };
        let set = contacts_of::<N>(self.world, &self.state, asked).map_err(refused)?;
        let (mut drive, mut load) = ([Vec3::ZERO; N], [Load::Absent; N]);
        let (mut slip, mut present) = ([[0.0; 2]; N], [ContactMode::Open; N]);
        for (k, (i, a)) in asked.iter().zip(self.free_accelerations(asked)).enumerate() {
            drive[k] = set.frame[k] * self.state.attitude.apply(a);
            load[k] = Load::Touching(0.0);
            let own = set.frame[k] * self.slip_of(i);
            slip[k] = [own.x, own.y];
            present[k] = if slip[k] == [0.0; 2] { ContactMode::Sticks } else { ContactMode::Slips };
        }
        let problem = RateProblem {
            count: set.count,
            operator: &set.operator,
            friction: &set.friction,
            drive,
            slip,
            load,
        };
        let answer = problem.solve_first();
        let conclusion = answer.count.conclusion();
        let preference = self.options.choice.preference();
        let chosen = match wanted {
            Wanted::Preferred => {
                let present = (self.options.choice != Choice::KeepFewest).then_some(&present);
                answer.preferred(present, preference)
            }
            Wanted::Another => answer.another(&present, preference),
        };
        let Some(chosen) = chosen else {
            return Ok((conclusion, None));
        };
        let mut carries = Carries::default();
        for (k, i) in asked.iter().enumerate() {
            match self.does(asked, chosen, k, slip[k] == [0.0; 2]) {
                ContactMode::Open => {}
                ContactMode::Sticks => carries.sticking = carries.sticking.with(i),
                ContactMode::Slips => carries.slipping = carries.slipping.with(i),
                ContactMode::Starts => {
                    carries.slipping = carries.slipping.with(i);
                    carries.leads.push((i, set.frame[k].transposed() * self.lead_of(chosen, k)));
                }
            }
        }
        Ok((conclusion, Some(carries)))
    }

    /// What one of the supports that were asked about does then.
    fn does<const N: usize>(
        &self,
        asked: Supports,
        chosen: &Solution<N>,
        k: usize,
        rests: bool,
    ) -> ContactMode {
        let weight = self.world.body().mass() * self.world.gravity().norm();
        let carries = chosen.rates[k].z > WEIGHTLESS * weight;
        // On a plane of its own one that carries nothing touches on, where nothing takes it away: beside a wall, say.
        let idles = !carries && !self.world.is_of_one_plane(asked) && self.stays(chosen.response[k].z);
        // Nothing draws it anywhere: without friction too it stays where it is.
        let put = rests && self.stays_put(chosen.response[k]);
        match chosen.guess[k].mode {
            mode if carries && (mode == ContactMode::Sticks || !put) => mode,
            _ if !carries && !idles => ContactMode::Open,
            _ if put => ContactMode::Sticks,
            _ if rests => ContactMode::Starts,
            _ => ContactMode::Slips,
        }
    }

    /// Where a support that starts to slip slips to, in its frame: one that carries nothing goes with the body.
    fn lead_of<const N: usize>(&self, chosen: &Solution<N>, k: usize) -> Vec3 {
        let flat = |x: f64, y: f64| Vec3::new(x, y, 0.0);
        if chosen.guess[k].mode == ContactMode::Starts {
            let [x, y] = chosen.direction[k];
            return flat(x, y);
        }
        flat(chosen.response[k].x, chosen.response[k].y).unit().unwrap_or(Vec3::ZERO)
    }
}
