//! Supports with friction: which of those that touch stick, slide or open, and what an event of theirs brings.

use super::sliding::{Carried, Sliding, Vector};
use super::walker::{Walker, without_way};
use crate::MotionError;
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::contacts::Conclusive;
use crate::spatial::modes::frictional::contacts_of;
use crate::spatial::modes::grip::{Bearing, Grip, MOST_BEARING};
use crate::spatial::modes::mode::{Mode as BodyMode, Vector as Standing, spanned};
use crate::spatial::modes::stretch::Stretch;
use crate::spatial::record::run::{Clock, End};
use crate::spatial::terms::Choice;
use crate::tolerance::{CONES_LEFT_AT_ONCE, INSIDE_CONE, RESTING_SLIP, WEIGHTLESS};
use carom_impact::Load;
use carom_impact::spatial::{Conclusion, Mode as ContactMode, RateProblem};
use carom_num::Vec3;

/// At the limit of a series the impulses that end it stop every slip that is below this many times the largest speed along the normal.
const SWEPT: f64 = 4.0;

/// What becomes of supports that touch.
#[derive(Clone, Debug, Default)]
struct Carries {
    sticking: Supports,
    slipping: Supports,
    /// Where slips that are zero start, world axes.
    leads: Vec<(usize, Vec3)>,
}

impl Walker<'_> {
    /// Speeds below this are rest.
    pub(in crate::spatial) fn still(&self) -> f64 {
        let size = self.state.velocity.norm() + self.state.spin.norm() * self.scales.length;
        RESTING_SLIP * size.max(self.scales.speed)
    }

    /// The slip of a support, exactly zero where it rests.
    pub(super) fn slip_of(&self, support: usize) -> Vec3 {
        let v = self.velocity_of(support);
        let flat = Vec3::new(v.x, v.y, 0.0);
        if flat.norm() <= self.still() { Vec3::ZERO } else { flat }
    }

    /// The stretch in which supports slide as the mode says.
    pub(in crate::spatial) fn sliding(&self) -> Result<(Sliding, Vector), MotionError> {
        let (sticking, slipping) = match self.mode {
            BodyMode::Slides { sticking, slipping } => (sticking, slipping),
            _ => (Supports::NONE, Supports::NONE),
        };
        self.sliding_on(&Carried { sticking, slipping, leads: &self.leads })
    }

    fn sliding_on(&self, carried: &Carried<'_>) -> Result<(Sliding, Vector), MotionError> {
        let sliding = Sliding::from(self.world, carried, &self.state, &self.heights);
        sliding.ok_or(MotionError::TooManyTouching {
            time: self.time,
            count: carried.sticking.union(carried.slipping).len(),
            most: MOST_BEARING,
        })
    }

    /// Enters the mode of supports that touch and do not approach, with friction. `without` is a support that has just lost its force.
    pub(super) fn hold_rough(
        &mut self,
        touching: Supports,
        without: Option<usize>,
    ) -> Result<Option<End>, MotionError> {
        let asked = without.map_or(touching, |one| touching.difference(Supports::one(one)));
        let mut carries = Carries::default();
        if !asked.is_empty() {
            self.settle_rough(asked)?;
            self.effort.questions += 1;
            let (conclusion, way) = self.ask_rough(asked)?;
            match (way, conclusion, self.options.choice) {
                (_, Conclusion::Several, Choice::End) => return Ok(Some(End::Several(Clock::Motion))),
                (Some(way), ..) => carries = way,
                // Painlevé's paradox: friction makes an impact without approach.
                (None, ..) => return self.strike_unapproached(asked),
            }
        }
        self.enter(carries, touching)
    }

    /// Enters a mode.
    fn enter(&mut self, carries: Carries, touching: Supports) -> Result<Option<End>, MotionError> {
        let Carries { sticking, slipping, leads } = carries;
        self.leads = leads;
        self.mode = if slipping.is_empty() {
            BodyMode::holding(self.world.body(), sticking)
        } else {
            BodyMode::Slides { sticking, slipping }
        };
        if slipping.is_empty() {
            self.state = crate::spatial::modes::settle::settled(self.world.body(), self.mode, &self.state);
        }
        self.departing = touching.difference(self.mode.held(self.world.body()));
        let rests = matches!(self.mode, BodyMode::Rest { .. });
        Ok(rests.then(|| End::AtRest { held: spanned(self.world.body(), touching) }))
    }

    /// Takes back what rounding has left of heights and of velocities along the normal.
    fn settle_rough(&mut self, asked: Supports) -> Result<(), MotionError> {
        let (sticking, slipping): (Vec<usize>, Vec<usize>) =
            asked.iter().partition(|i| self.slip_of(*i) == Vec3::ZERO);
        let body = self.world.body();
        if slipping.is_empty() {
            self.state =
                crate::spatial::modes::settle::settled(body, BodyMode::holding(body, asked), &self.state);
            return Ok(());
        }
        let carried = Carried {
            sticking: sticking.into_iter().take(1).collect(),
            slipping: slipping.into_iter().collect(),
            leads: &[],
        };
        let (sliding, first) = self.sliding_on(&carried)?;
        self.state = super::motion::Motion::state(&sliding, &first, 0.0);
        Ok(())
    }

    /// The state in which none of these supports moves along the normal, where a series of impacts with friction comes to its limit.
    ///
    /// The impulses of the series are those of the weight meanwhile less what stops the support that has just risen. Since the stretch that follows starts at the
    /// last impact and not at the limit, it brings those of the weight; here the others are taken back, with their share of friction.
    pub(super) fn landed(&self, kept: Supports) -> Option<State> {
        let (body, state, friction) = (self.world.body(), &self.state, self.world.friction()?);
        if kept.len() > MOST_BEARING {
            return None;
        }
        let rises = kept.iter().map(|i| self.velocity_of(i).z.abs()).fold(0.0, f64::max);
        let bearing = |i: usize| {
            let (slip, velocity) = (self.slip_of(i), self.velocity_of(i));
            // A slip that is no faster than the bounces has been stopped by the impulses of the bounces still to come.
            let sticks = slip.norm() <= SWEPT * rises;
            Bearing {
                arm: body.supports()[i],
                friction: friction.coefficient(i),
                sticks,
                toward: if sticks {
                    Vec3::ZERO
                } else {
                    state.attitude.undo(slip.unit().unwrap_or(Vec3::ZERO))
                },
                drive: state.attitude.undo(velocity),
            }
        };
        let bearings: Vec<Bearing> = kept.iter().map(bearing).collect();
        let axes = [state.attitude.undo(Vec3::X), state.attitude.undo(Vec3::Y)];
        let reactions = Grip { body, up: state.up(), axes, bearings: &bearings }.reactions()?;
        Some(State {
            velocity: state.velocity + state.attitude.apply(reactions.force) / body.mass(),
            spin: state.spin + body.mobility() * reactions.moment,
            ..*state
        })
    }

    /// Accelerations of supports of the free body, body axes.
    fn free_accelerations(&self, asked: Supports) -> Vec<Vec3> {
        let (body, spin) = (self.world.body(), self.state.spin);
        let turning = body.mobility() * -spin.cross(body.inertia() * spin);
        let gravity = self.state.attitude.undo(self.world.gravity());
        let of = |i: usize| {
            let arm = body.supports()[i];
            gravity + turning.cross(arm) + spin.cross(spin.cross(arm))
        };
        asked.iter().map(of).collect()
    }

    fn ask_rough(&self, asked: Supports) -> Result<(Conclusion, Option<Carries>), MotionError> {
        let body = self.world.body();
        let at_rest = asked.iter().all(|i| self.slip_of(i) == Vec3::ZERO);
        // What lies between the ends of an edge at rest adds nothing to what they can hold.
        let asked = match BodyMode::holding(body, asked) {
            BodyMode::Edge { ends, .. } if at_rest => ends.into_iter().collect(),
            _ => asked,
        };
        match asked.len() {
            0..=2 => self.ask_rough_sized::<2>(asked),
            3..=4 => self.ask_rough_sized::<4>(asked),
            5..=8 => self.ask_rough_sized::<8>(asked),
            9..=MOST_BEARING => self.ask_rough_sized::<MOST_BEARING>(asked),
            count => Err(MotionError::TooManyTouching { time: self.time, count, most: MOST_BEARING }),
        }
    }

    /// Accelerations along the plane this small, in units of gravity, are rounding.
    fn stays_put(&self, acceleration: Vec3) -> bool {
        let along = Vec3::new(acceleration.x, acceleration.y, 0.0);
        along.norm() <= INSIDE_CONE * self.world.gravity().norm()
    }

    fn ask_rough_sized<const N: usize>(
        &self,
        asked: Supports,
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
        let present = (self.options.choice != Choice::KeepFewest).then_some(&present);
        let Some(chosen) = answer.preferred(present, self.options.choice.preference()) else {
            return Ok((conclusion, None));
        };
        let weight = self.world.body().mass() * self.world.gravity().norm();
        let mut carries = Carries::default();
        for (k, i) in asked.iter().enumerate() {
            if chosen.rates[k].z <= WEIGHTLESS * weight {
                continue;
            }
            match chosen.guess[k].mode {
                ContactMode::Open => {}
                ContactMode::Sticks => carries.sticking = carries.sticking.with(i),
                // Nothing draws it anywhere: without friction too it stays where it is.
                ContactMode::Slips | ContactMode::Starts
                    if slip[k] == [0.0; 2] && self.stays_put(chosen.response[k]) =>
                {
                    carries.sticking = carries.sticking.with(i);
                }
                ContactMode::Slips => carries.slipping = carries.slipping.with(i),
                ContactMode::Starts => {
                    let [x, y] = chosen.direction[k];
                    carries.slipping = carries.slipping.with(i);
                    carries.leads.push((i, set.frame[k].transposed() * Vec3::new(x, y, 0.0)));
                }
            }
        }
        Ok((conclusion, Some(carries)))
    }

    /// A support that stuck has come to the edge of its cone: it slips on from rest, against the friction that it has taken.
    pub(super) fn slip_starts(&mut self, which: usize) -> Result<Option<End>, MotionError> {
        let held = self.mode.held(self.world.body());
        let against = |force: Vec3| -force.unit().unwrap_or(Vec3::ZERO);
        let carries = match self.mode {
            BodyMode::Slides { sticking, slipping } => {
                let (sliding, first) = self.sliding()?;
                let forces = sliding.forces(&first).unwrap_or_default();
                let own = forces.iter().find(|(i, _)| *i == which).map_or(Vec3::ZERO, |(_, f)| *f);
                let mut leads = self.leads.clone();
                leads.push((which, against(Vec3::new(own.x, own.y, 0.0))));
                let one = Supports::one(which);
                Carries { sticking: sticking.difference(one), slipping: slipping.union(one), leads }
            }
            _ => self.slips_from_rest(which)?,
        };
        self.enter(carries, held)
    }

    /// Which supports of a pivot or an edge slip, and where to.
    fn slips_from_rest(&self, which: usize) -> Result<Carries, MotionError> {
        let not_finite = MotionError::NotFinite { time: self.time };
        let stretch = Stretch::from(self.world, self.mode, &self.state, &self.heights).ok_or(not_finite)?;
        let first: Standing = stretch.first();
        let forces = stretch.equations.end_forces(&stretch.posture(&first, 0.0));
        let [along, across] = forces.axes.map(|axis| self.state.attitude.apply(axis));
        let against = |force: Vec3| -force.unit().unwrap_or(Vec3::ZERO);
        let BodyMode::Edge { ends, .. } = self.mode else {
            let slipping = self.mode.held(self.world.body());
            let leads = slipping.iter().map(|i| (i, against(along))).collect();
            return Ok(Carries { sticking: Supports::NONE, slipping, leads });
        };
        let friction = |k: usize| self.world.friction().map_or(0.0, |f| f.coefficient(ends[k]));
        // Both ends may come to their cones' edges at once.
        let used_up =
            |k: usize| forces.across[k].abs() >= (1.0 - CONES_LEFT_AT_ONCE) * friction(k) * forces.normal[k];
        if let Some(&end) = ends.get(which).filter(|_| !used_up(1 - which)) {
            let (sticking, slipping) = (Supports::one(ends[1 - which]), Supports::one(end));
            let leads = vec![(end, against(across * forces.across[which]))];
            return Ok(Carries { sticking, slipping, leads });
        }
        let lead = |k: usize| {
            let (most, taken) = (friction(k) * forces.normal[k], forces.across[k]);
            let rest = (most * most - taken * taken).max(0.0).sqrt();
            (ends[k], against(across * taken + along * rest.copysign(forces.along)))
        };
        let slipping = ends.into_iter().collect();
        Ok(Carries { sticking: Supports::NONE, slipping, leads: vec![lead(0), lead(1)] })
    }

    /// A slip has come to zero.
    pub(super) fn slip_stops(&mut self) -> Result<Option<End>, MotionError> {
        self.hold_rough(self.mode.held(self.world.body()), None)
    }
}

/// The end where an impact without approach does nothing.
pub(super) fn no_motion() -> End {
    without_way(Conclusion::None, Clock::Motion)
}
