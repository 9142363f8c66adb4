//! The start of a run, and its impacts.

use super::closing::Closed;
use super::motion::{Motion, Standing};
use super::walker::{Walker, without_way};
use crate::MotionError;
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::state::measured;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::{Support, World};
use crate::spatial::modes::contacts::{Answer, Way};
use crate::spatial::modes::mode::Mode;
use crate::spatial::modes::settle::settled;
use crate::spatial::modes::stretch::Stretch;
use crate::spatial::record::run::{Clock, End, Impact};
use crate::tolerance::{
    AT_REST_AT_START, BESIDE, COMES_DOWN_AT_ONCE, FAINT_STRIKE, FLAT, GRAZING_SPEED, ROUNDING_OF_TIME,
    SUPPORT_TOUCHES, TOUCHES_AT_START,
};
use carom_impact::spatial::Conclusion;
use carom_num::Vec3;
use std::ops::ControlFlow;

/// What touches again without having risen is faint up to so many times the speed of a faint strike.
const LOST_HOP: f64 = 10.0;

impl Walker<'_> {
    /// Velocity of a support, world axes.
    pub(in crate::spatial) fn velocity_of(&self, support: usize) -> Vec3 {
        self.state.velocity_of(self.world.arm(support, self.state.pose()))
    }

    /// How fast a support rises over its plane [m/s].
    pub(in crate::spatial) fn rise_of(&self, support: usize) -> f64 {
        self.world.normal(support, self.state.pose()).dot(self.velocity_of(support))
    }

    /// No place of the body is faster [m/s].
    pub(super) fn top_speed(&self) -> f64 {
        self.state.velocity.norm() + self.state.spin.norm() * self.scales.length
    }

    /// Those of these supports that come down, and do not graze.
    fn coming_down(&self, of: Supports) -> Supports {
        let least = -GRAZING_SPEED * self.top_speed();
        of.those(|i| self.rise_of(i) < least)
    }

    /// Measures all heights, over each plane from the lowest support.
    pub(super) fn measure_heights(&mut self) {
        let (world, state) = (self.world, self.state);
        let placed = |i: &usize| measured(world, &state, None, *i);
        for (support, far) in (world.of_faces()..).zip(world.far(&state)) {
            self.heights[support] = if far { f64::INFINITY } else { placed(&support) };
        }
        for plane in 0..world.planes().len() {
            let own = world.of_plane(plane);
            let lowest = own.clone().min_by(|a, b| placed(a).total_cmp(&placed(b))).unwrap_or_default();
            let ground = placed(&lowest);
            for support in own {
                self.heights[support] = ground + measured(world, &state, Some(lowest), support);
            }
        }
    }

    /// Looks at what touches at the start.
    pub(super) fn begin(&mut self) -> Result<Option<End>, MotionError> {
        let (length, count) = (self.scales.length, self.world.count());
        let speed = self.scales.speed.max(self.top_speed());
        let mut resting = Supports::NONE;
        let (mut strikes, mut slides) = (false, None);
        if let Some((obstacle, depth)) = self.world.overlap(self.state.pose(), TOUCHES_AT_START * length) {
            return Err(MotionError::Overlaps { obstacle, depth });
        }
        self.measure_heights();
        for support in (0..count).filter(|i| self.heights[*i] < f64::INFINITY).collect::<Vec<_>>() {
            let (height, velocity) = (self.heights[support], self.velocity_of(support));
            let rise = self.rise_of(support);
            let ends = self.world.limits(support) > 0;
            if ends && (height < -TOUCHES_AT_START * length || !self.world.is_within(support, &self.state)) {
                continue;
            }
            if height < -TOUCHES_AT_START * length {
                return Err(MotionError::Below { support, depth: -height });
            }
            if height > TOUCHES_AT_START * length {
                continue;
            }
            self.heights[support] = 0.0;
            if velocity.norm() <= AT_REST_AT_START * speed {
                resting = resting.with(support);
            } else if rise < -AT_REST_AT_START * speed {
                strikes = true;
            } else if rise <= AT_REST_AT_START * speed {
                resting = if self.world.friction().is_some() { resting.with(support) } else { resting };
                slides = Some((support, velocity.norm()));
            }
        }
        // An impact stops slips as well: only without one, in a world where nothing may slide, is a slip at the start an error.
        let slides = slides.filter(|_| self.world.friction().is_none());
        match slides {
            _ if strikes => self.meet(Supports::NONE),
            Some((support, speed)) => Err(MotionError::Slides { support, speed }),
            None if self.lies_flat(resting) => Ok(Some(End::Flat { touching: resting })),
            None if resting.is_overfull() => Err(self.too_many(resting)),
            None => {
                let few = self.spoken_for(self.world.distinct(resting, self.state.pose()), Supports::NONE);
                self.hold(few, None)
            }
        }
    }

    /// The supports that touch now: those that are held, and those that come down at once.
    fn near(&self) -> Supports {
        let at_once = (COMES_DOWN_AT_ONCE * self.lasted).max(ROUNDING_OF_TIME * self.scales.time);
        let low = |i: usize| match self.world.pair(i) {
            None => SUPPORT_TOUCHES * self.scales.length,
            // What is measured in the world is less exact than what is counted on.
            Some(_) => TOUCHES_AT_START * self.scales.length,
        };
        let touches = |i: &usize| self.heights[*i] <= (-self.rise_of(*i) * at_once).max(low(*i));
        let ends = |i: &usize| self.world.limits(*i) > 0;
        // Below a face that has ends the body may be beside it.
        let near = |i: &usize| !ends(i) || self.heights[*i] >= -BESIDE * self.scales.length;
        let within = |i: &usize| !ends(i) || self.world.is_within(*i, &self.state);
        let all = (0..self.world.count()).filter(|i| self.heights[*i] < f64::INFINITY);
        let touching: Supports = all.filter(|i| touches(i) && near(i) && within(i)).collect();
        touching.union(self.mode.held(self.world).those(|i| within(&i)))
    }

    /// The same, once at each place.
    pub(in crate::spatial) fn touching(&self) -> Result<Supports, MotionError> {
        let near = self.near();
        if near.is_overfull() {
            Err(self.too_many(near))
        } else {
            Ok(self.world.distinct(near, self.state.pose()))
        }
    }

    fn too_many(&self, touching: Supports) -> MotionError {
        MotionError::TooManyTouching { time: self.time, count: touching.len() + 1, most: Supports::TOGETHER }
    }

    /// Supports leave where they touch, with all that touch at the same places: where two obstacles meet one edge crosses both.
    pub(super) fn departs(&mut self, leaving: Supports) {
        self.departing = leaving;
        if leaving.is_empty() || !self.world.has_pairs(leaving) {
            return;
        }
        let low = TOUCHES_AT_START * self.scales.length;
        let held = self.mode.held(self.world);
        let beside = (0..self.world.count()).filter(|i| self.heights[*i].abs() <= low && !held.contains(*i));
        self.departing = leaving.union(self.world.twins(leaving, beside, self.state.pose()));
    }

    /// What comes of supports that touch: an impact, if one of them comes down. `found` are those that were found to touch. They may be at the end of their face, and
    /// beyond it by rounding: then they leave.
    pub(in crate::spatial) fn meet(&mut self, found: Supports) -> Result<Option<End>, MotionError> {
        let all = self.touching()?;
        let mut touching = self.spoken_for(all, Supports::NONE);
        let held = self.mode.held(self.world);
        // Where none of those that speak for a face comes down, the one that was found to touch speaks for itself.
        if !self.beside.is_empty() && self.coming_down(touching.difference(held)).is_empty() {
            touching = self.spoken_for(all, found);
        }
        if self.lies_flat(touching) {
            return Ok(Some(End::Flat { touching }));
        }
        let free = touching.difference(held);
        if free.is_empty() {
            // What has come down is where something else is held.
            self.departing = self.near().union(found).difference(held);
            return Ok(None);
        }
        let striking = self.coming_down(free);
        // Of a hop that is down again at once rounding has taken the height.
        let hops = if self.lasted == 0.0 { LOST_HOP } else { 1.0 };
        let faint = FAINT_STRIKE * self.scales.speed * hops;
        if !striking.is_empty() {
            let together = self.rest_together(touching, faint);
            return if together { self.hold(touching, None) } else { self.strike(touching, striking) };
        }
        // What rises touches in passing: another edge at the corner over which the body leaves, say. Where nothing slides all supports are of one plane.
        let slides = self.world.friction().is_some();
        let grazing = free.those(|i| !slides || self.rise_of(i) <= faint);
        if grazing.is_empty() {
            self.departs(free);
            return Ok(None);
        }
        self.graze(grazing, found)
    }

    /// Among obstacles with ends, whose gaps are measured, several that all but rest come to rest together: one after the other they would strike without end.
    fn rest_together(&self, touching: Supports, faint: f64) -> bool {
        let measured = self.world.count() > self.world.of_faces();
        measured && touching.len() > 1 && touching.iter().all(|i| self.rise_of(i).abs() <= faint)
    }

    /// A circle among these supports lies flat on its plane.
    fn lies_flat(&self, touching: Supports) -> bool {
        let sine = |i: usize| {
            if self.world.pair(i).is_some() {
                return None;
            }
            let Support { feature, plane } = self.world.support(i);
            feature.tilt(self.state.attitude.undo(plane.normal()))
        };
        self.world.body().is_round() && touching.iter().filter_map(sine).any(|sine| sine <= FLAT)
    }

    /// Supports touch the plane and do not come down on it. Those that it does not draw down part from it again. If the others rest it is asked whether they are
    /// held; if one moves along the plane it comes down the next instant, which is an impact.
    fn graze(&mut self, grazing: Supports, found: Supports) -> Result<Option<End>, MotionError> {
        let sinking = self.sinking(grazing)?;
        let held = self.mode.held(self.world);
        if sinking.is_empty() {
            // It was found to sink, a moment from now: it is only then that the law tells who is held.
            if self.world.has_pairs(grazing.those(|i| found.contains(i))) {
                return self.hold_ahead(held.union(grazing));
            }
            self.departs(grazing);
            Ok(None)
        } else if self.world.friction().is_some() {
            self.hold(held.union(grazing), None)
        } else if sinking.iter().any(|i| self.velocity_of(i).norm() > AT_REST_AT_START * self.top_speed()) {
            self.strike(held.union(grazing), sinking)
        } else {
            self.hold(held.union(grazing), None)
        }
    }

    /// The place where a support touches has come to the end of a face or an edge. What touches there now goes on: an edge where a point has left a face, say. What approaches
    /// strikes.
    pub(super) fn leave(&mut self, support: usize) -> Result<Option<End>, MotionError> {
        let touching = self.touching()?.difference(Supports::one(support));
        let touching = self.spoken_for(touching, Supports::NONE);
        let held = self.mode.held(self.world);
        let striking = self.coming_down(touching.difference(held));
        let faint = FAINT_STRIKE * self.scales.speed;
        if !striking.is_empty() && !self.rest_together(touching, faint) {
            return self.strike(touching, striking);
        }
        let stays = |i: &usize| held.contains(*i) || self.rise_of(*i) <= faint;
        let end = self.hold(touching.iter().filter(stays).collect(), None)?;
        if !self.mode.held(self.world).contains(support) {
            self.departing = self.departing.with(support);
        }
        Ok(end)
    }

    /// Those that the motion draws down.
    pub(super) fn sinking(&self, grazing: Supports) -> Result<Supports, MotionError> {
        let rising = self.rising_faster(grazing)?;
        Ok(rising.into_iter().filter(|(_, second)| *second <= 0.0).map(|(i, _)| i).collect())
    }

    /// How fast supports begin to rise faster [m/s²].
    pub(super) fn rising_faster(&self, supports: Supports) -> Result<Vec<(usize, f64)>, MotionError> {
        if matches!(self.mode, Mode::Slides { .. }) {
            let (sliding, first) = self.sliding()?;
            return Ok(self.seconds(&sliding, &first, supports));
        }
        let not_finite = MotionError::NotFinite { time: self.time };
        let stretch = Stretch::from(self.world, self.mode, &self.state, &self.heights).ok_or(not_finite)?;
        let first = stretch.first();
        Ok(self.seconds(&Standing::of(self.world, stretch), &first, supports))
    }

    fn seconds<M: Motion>(&self, motion: &M, first: &M::Y, supports: Supports) -> Vec<(usize, f64)> {
        let now = motion.posture(first, 0.0);
        let moving = motion.moving(&now);
        supports.iter().map(|i| (i, motion.gap(self.world, i, &now, &moving).second)).collect()
    }

    /// Resolves an impact, closes the series that it belongs to, and holds what rests.
    fn strike(&mut self, touching: Supports, striking: Supports) -> Result<Option<End>, MotionError> {
        if self.world.friction().is_some() {
            return self.strike_rough(touching, striking);
        }
        let before = self.state;
        touching.iter().for_each(|i| self.heights[i] = 0.0);
        self.effort.impacts += 1;
        let Answer { conclusion, way } = self.question(touching).of_impact()?;
        let Some(way) = way else { return Ok(Some(without_way(conclusion, Clock::Impact))) };
        let kept = way.kept;
        self.state = pushed(&before, self.world, &way.pushes);
        // What is kept rests: that is known better than the impulses say it.
        let mode = Mode::holding(self.world, kept, self.state.pose());
        self.state = settled(self.world, mode, &self.state);
        let seen = self.tell(&before, [touching, striking], way, conclusion);
        self.mode = mode;
        if seen.is_break() {
            return Ok(Some(End::Stopped));
        }
        match self.note(touching, kept, kept)? {
            Closed::Yes(end) => Ok(end),
            Closed::Not => self.hold(kept, None),
        }
    }

    /// Records an impact that has led from the state before to the present one, and shows it to the observer.
    pub(super) fn tell(
        &mut self,
        before: &State,
        [touching, striking]: [Supports; 2],
        way: Way,
        conclusion: Conclusion,
    ) -> ControlFlow<()> {
        let body = self.world.body();
        let impact = Impact {
            time: self.time,
            touching,
            striking,
            held: self.mode.held(self.world),
            kept: way.kept,
            sliding: way.sliding,
            attitude: before.attitude,
            spin_before: before.spin,
            spin_after: self.state.spin,
            kinetic_before: before.kinetic(body),
            kinetic_after: self.state.kinetic(body),
            potential: before.potential(self.world),
            impulses: way.pushes,
            friction_demand: way.friction_demand,
            open: way.open,
            conclusion,
        };
        let seen = self.observer.impact(&impact);
        self.impacts.push(impact);
        seen
    }
}

/// The state after impulses on supports, world axes.
pub(in crate::spatial) fn pushed(state: &State, world: &World, pushes: &[(usize, Vec3)]) -> State {
    let body = world.body();
    let (mut push, mut moment) = (Vec3::ZERO, Vec3::ZERO);
    for (support, impulse) in pushes {
        let own = state.attitude.undo(*impulse);
        push += *impulse;
        moment += world.arm(*support, state.pose()).cross(own);
    }
    State {
        velocity: state.velocity + push / body.mass(),
        spin: state.spin + body.mobility() * moment,
        ..*state
    }
}
