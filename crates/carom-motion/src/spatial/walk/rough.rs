//! Supports with friction: which of those that touch stick, slide or open, and what an event of theirs brings.

use super::motion::Motion;
use super::question::Carries;
use super::sliding::carriers::Carried;
use super::sliding::{Sliding, Vector};
use super::walker::{Walker, without_way};
use crate::MotionError;
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::grip::MOST_BEARING;
use crate::spatial::modes::mode::{Mode as BodyMode, Vector as Standing, spanned};
use crate::spatial::modes::settle::settled;
use crate::spatial::modes::stretch::Stretch;
use crate::spatial::record::run::{Clock, End};
use crate::spatial::terms::Choice;
use crate::tolerance::{CONES_LEFT_AT_ONCE, RESTING_SLIP, SLIPS_AHEAD, WEIGHTLESS};
use carom_impact::spatial::Conclusion;
use carom_num::Vec3;
use carom_num::ode8::step_plain;

impl<'w> Walker<'w> {
    /// Speeds below this are rest.
    pub(in crate::spatial) fn still(&self) -> f64 {
        RESTING_SLIP * self.top_speed().max(self.scales.speed)
    }

    /// The slip of a support, exactly zero where it rests.
    pub(super) fn slip_of(&self, support: usize) -> Vec3 {
        let flat = self.world.along(support, self.state.pose(), self.velocity_of(support));
        if flat.norm() <= self.still() { Vec3::ZERO } else { flat }
    }

    /// The stretch in which supports slide as the mode says.
    pub(in crate::spatial) fn sliding(&self) -> Result<(Sliding<'w>, Vector), MotionError> {
        let (sticking, slipping) = match self.mode {
            BodyMode::Slides { sticking, slipping } => (sticking, slipping),
            _ => (Supports::NONE, Supports::NONE),
        };
        self.sliding_on(&Carried { sticking, slipping, leads: &self.leads })
    }

    pub(super) fn sliding_on(&self, carried: &Carried<'_>) -> Result<(Sliding<'w>, Vector), MotionError> {
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
        let asked = self.askable(asked);
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
            BodyMode::sticking(self.world, sticking, self.state.pose())
        } else {
            BodyMode::Slides { sticking, slipping }
        };
        if slipping.is_empty() {
            self.state = settled(self.world, self.mode, &self.state);
        }
        if let Some(one) = self.drawn_in()? {
            self.beside = self.beside.difference(Supports::one(one));
            return self.hold_rough(touching.with(one), None);
        }
        self.departs(touching.union(self.beside).difference(self.mode.held(self.world)));
        let rests = matches!(self.mode, BodyMode::Rest { .. });
        Ok(rests.then(|| End::AtRest { held: spanned(self.world, touching) }))
    }

    /// A support that stuck has come to the edge of its cone: it slips on from rest, against the friction that it has taken.
    pub(super) fn slip_starts(&mut self, which: usize) -> Result<Option<End>, MotionError> {
        let held = self.mode.held(self.world);
        if !self.world.is_of_one_plane(held) {
            return self.slips_apart(Some(which), held);
        }
        let carries = match self.mode {
            BodyMode::Slides { .. } => self.slips_against(Supports::one(which))?,
            _ => self.slips_from_rest(which)?,
        };
        // Where a slip against its friction cannot grow from nothing, the support lets go or slips elsewhere at once.
        let Carries { sticking, slipping, leads } = &carries;
        let (sliding, first) =
            self.sliding_on(&Carried { sticking: *sticking, slipping: *slipping, leads })?;
        if sliding.starts_smoothly(&first) { self.enter(carries, held) } else { self.slips_apart(None, held) }
    }

    /// Of a body that slides some that stuck slip too, against their friction.
    fn slips_against(&self, which: Supports) -> Result<Carries, MotionError> {
        let BodyMode::Slides { sticking, slipping } = self.mode else { return Ok(Carries::default()) };
        let (sliding, first) = self.sliding()?;
        let forces = sliding.forces(&first).unwrap_or_default();
        let across = |i: usize, force: Vec3| self.world.along(i, self.state.pose(), force);
        let friction = |i: usize| self.world.friction().map_or(0.0, |f| f.coefficient(i));
        // Others may come to the edges of their cones at once.
        let used_up = |(i, force): &(usize, Vec3)| {
            let most = friction(*i) * self.world.normal(*i, self.state.pose()).dot(*force);
            sticking.contains(*i) && across(*i, *force).norm() >= (1.0 - CONES_LEFT_AT_ONCE) * most
        };
        let which = which.union(forces.iter().filter(|f| used_up(f)).map(|(i, _)| *i).collect());
        let mut leads = self.leads.clone();
        let starting = forces.into_iter().filter(|(i, _)| which.contains(*i));
        leads.extend(starting.map(|(i, force)| (i, -across(i, force).unit().unwrap_or(Vec3::ZERO))));
        Ok(Carries { sticking: sticking.difference(which), slipping: slipping.union(which), leads })
    }

    /// Supports of several planes can no longer all do what they do: the rate problem says what follows, a moment later, when their cones are clearly left.
    ///
    /// `which` is the one that has left its cone, where their forces are determined. Where the rate problem finds nothing, or that this one could stick, it slips
    /// against its friction.
    pub(super) fn slips_apart(
        &mut self,
        which: Option<usize>,
        held: Supports,
    ) -> Result<Option<End>, MotionError> {
        let (conclusion, way) = self.asked_ahead(held)?;
        if conclusion == Conclusion::Several && self.options.choice == Choice::End {
            return Ok(Some(End::Several(Clock::Motion)));
        }
        let present = match self.mode {
            BodyMode::Slides { sticking, slipping } => (sticking, slipping),
            _ => (held, Supports::NONE),
        };
        let goes_on = |carries: &Carries| {
            let same = (carries.sticking, carries.slipping) == present;
            same || which.is_some_and(|one| carries.sticking.contains(one))
        };
        match (way.filter(|carries| !goes_on(carries)), which) {
            (Some(carries), _) => self.enter(carries, held),
            (None, Some(which)) => {
                let world = self.world;
                let place = |i: usize| world.support(i);
                let alike = |i: &usize| {
                    let on_faces = world.pair(*i).is_none() && world.pair(which).is_none();
                    let same = || {
                        place(*i).feature == place(which).feature
                            && place(*i).plane.normal() == place(which).plane.normal()
                    };
                    *i == which || on_faces && same()
                };
                let carries = self.slips_against(held.iter().filter(alike).collect())?;
                self.enter(carries, held)
            }
            // The law lets them go on, with other shares than equal springs have: the one that these would have pull is let go.
            (None, None) => match self.pulls()? {
                Some(one) => self.hold_rough(held, Some(one)),
                // What holds now is about to end, and another way on is consistent beside it.
                None => match self.ask_for_another(held)? {
                    Some(carries) => self.enter(carries, held),
                    None => self.strike_unapproached(held),
                },
            },
        }
    }

    /// What the rate problem says a moment later, if the mode goes on until then.
    fn asked_ahead(&mut self, asked: Supports) -> Result<(Conclusion, Option<Carries>), MotionError> {
        self.effort.questions += 1;
        self.a_moment_later(|walker| walker.ask_rough(asked))
    }

    /// Asks something a moment later, if the mode goes on until then.
    pub(super) fn a_moment_later<T>(
        &mut self,
        ask: impl FnOnce(&Self) -> Result<T, MotionError>,
    ) -> Result<T, MotionError> {
        let now = self.state;
        self.state = self.ahead(SLIPS_AHEAD * self.scales.time)?;
        let answer = ask(self);
        self.state = now;
        answer
    }

    /// Enters the mode that supports have a moment later: at the instant itself one has just lost its force, and another has none yet.
    pub(super) fn hold_ahead(&mut self, touching: Supports) -> Result<Option<End>, MotionError> {
        match self.asked_ahead(touching)? {
            (Conclusion::Several, _) if self.options.choice == Choice::End => {
                Ok(Some(End::Several(Clock::Motion)))
            }
            (_, Some(carries)) => self.enter(carries, touching),
            (_, None) => self.hold_rough(touching, None),
        }
    }

    /// The support of a sliding body that would pull most, or carries nothing.
    fn pulls(&self) -> Result<Option<usize>, MotionError> {
        if !matches!(self.mode, BodyMode::Slides { .. }) {
            return Ok(None);
        }
        let (sliding, first) = self.sliding()?;
        let forces = sliding.forces(&first).unwrap_or_default();
        let normal = |(i, force): &(usize, Vec3)| self.world.normal(*i, self.state.pose()).dot(*force);
        let least = forces.iter().map(|f| (f.0, normal(f))).min_by(|a, b| a.1.total_cmp(&b.1));
        let nothing = WEIGHTLESS * self.world.body().mass() * self.world.gravity().norm();
        Ok(least.filter(|(_, normal)| *normal <= nothing).map(|(i, _)| i))
    }

    /// The state a short time later, if the mode goes on.
    pub(super) fn ahead(&self, time: f64) -> Result<State, MotionError> {
        if matches!(self.mode, BodyMode::Slides { .. }) {
            let (sliding, first) = self.sliding()?;
            let step = step_plain(first, sliding.rate(&first), time, |y| sliding.rate(y));
            return Ok(sliding.state(&sliding.tidied(&step.end), time));
        }
        let not_finite = MotionError::NotFinite { time: self.time };
        let stretch = Stretch::from(self.world, self.mode, &self.state, &self.heights).ok_or(not_finite)?;
        let first: Standing = stretch.first();
        let rate = |y: &Standing| stretch.equations.rate(y);
        Ok(stretch.state(&step_plain(first, rate(&first), time, rate).end, time))
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
            let slipping = self.mode.held(self.world);
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
        self.hold_rough(self.mode.held(self.world), None)
    }
}

/// The end where an impact without approach does nothing.
pub(super) fn no_motion() -> End {
    without_way(Conclusion::None, Clock::Motion)
}
