//! The events of a mode, found on the dense output of a step.

use super::gliding::Gliding;
use super::motion::{Event, Motion};
use crate::evaluated::{Quantity, evaluated, watched};
use crate::spatial::geometry::clear::Outlook;
use crate::spatial::geometry::posture::{Bend, Height, Moving, Posture};
use crate::spatial::terms::Overturning;
use crate::tolerance::{BESIDE, SKIMS, SKIMS_BESIDE, SKIMS_MEASURED, STILL_ACCELERATION};
use carom_num::Vec3;
use carom_num::course::{Found, placed};
use carom_num::elementary::cos;
use carom_num::falls::first_fall;
use carom_num::ode8::Step;

/// Places of a step at which a support that never leaves its plane is looked at.
const SKIMMED: [f64; 4] = [0.25, 0.5, 0.75, 1.0];
/// Places of a step that are kept for those who look there again.
const MOST_PLACES: usize = 24;
/// This part of the way to an event is almost there.
const ALMOST: f64 = 0.99;
/// A body that is certain to be beside an obstacle for a smaller part of a step is near it.
const NEAR: f64 = 0.05;
/// The motion at a place of a step.
#[derive(Clone, Copy)]
pub(super) struct Place<Y> {
    /// The fraction of the step.
    x: f64,
    y: Y,
    pub(super) at: Posture,
    pub(super) moving: Moving,
}

impl<M: Motion> Gliding<'_, '_, M> {
    /// Where forces do not exist, as where all places that carry come together, it is no number: an event next to such a place is taken where the search has found it.
    pub(super) fn value_at(&self, event: &Event, y: &M::Y, at: &Posture, known: &M::Known) -> f64 {
        match *event {
            Event::Touches(support) => self.height(support, at).value,
            Event::Overturns => self.uprightness(at),
            _ => self.motion.value(event, y, at, known),
        }
    }

    /// Positive as long as the body has not overturned.
    fn uprightness(&self, at: &Posture) -> f64 {
        match self.overturning {
            None => 1.0,
            Some(Overturning::Tilt { axis, angle }) => at.up.dot(axis) - cos(angle),
            Some(Overturning::Beyond) => {
                let Some(edge) = self.motion.leans_over() else { return 1.0 };
                // Horizontal parts, across the edge: from the foot to the mass centre, and to the middle of the supports.
                let flat = |r: Vec3| r - at.up * r.dot(at.up) - edge * r.dot(edge);
                flat(-at.from).dot(flat(self.middle - at.from))
            }
        }
    }

    pub(in crate::spatial) fn height(&self, support: usize, at: &Posture) -> Height {
        self.height_of(support, at, &self.motion.moving(at))
    }

    /// The same of a body of which it is known how it moves.
    pub(super) fn height_of(&self, support: usize, at: &Posture, moving: &Moving) -> Height {
        let height = self.motion.gap(self.walker.world, support, at, moving);
        Height { value: evaluated(Quantity::Gap, height.value + self.counted(support)), ..height }
    }

    /// What is searched for the touch of a support: its height, or of edges what is zero with it and bends less.
    pub(super) fn approach(&self, support: usize, seen: &Place<M::Y>) -> Height {
        let Some(pair) = self.walker.world.pair(support) else {
            return self.height_of(support, &seen.at, &seen.moving);
        };
        let [value, rate] = pair.approach(&seen.moving.state, self.counted(support));
        Height { value: evaluated(Quantity::Gap, value), rate, second: 0.0 }
    }

    /// What that bends by.
    pub(super) fn bend(&self, support: usize, seen: &Place<M::Y>, time: f64) -> Bend {
        match self.walker.world.pair(support) {
            None => self.motion.bend(self.walker.world, support, &seen.at, time),
            Some(pair) => {
                let most = self.motion.most(&seen.at, time);
                Bend::own(pair.bend(&seen.moving.state, &most, time)[0])
            }
        }
    }

    /// For so long at least the place of a support stays beside the face that has ends, if it is beside it.
    pub(super) fn stays_aside(&self, support: usize, seen: &Place<M::Y>, time: f64) -> f64 {
        if self.walker.world.limits(support) == 0 {
            return 0.0;
        }
        let most = self.motion.most(&seen.at, time);
        self.walker.world.stays_aside(support, &seen.moving.state, &most, time)
    }

    /// A face or an edge has ends: a support of it touches where its place is between them.
    pub(super) fn is_within(&mut self, step: &Step<M::Y>, support: usize, x: f64) -> bool {
        if self.walker.world.limits(support) == 0 {
            return true;
        }
        let state = self.place(step, x).moving.state;
        self.walker.world.is_within(support, &state)
    }

    /// Event functions that are looked at at nodes.
    fn smooth_events(&self) -> Vec<Event> {
        let mut events = self.motion.smooth_events();
        events.extend(self.overturning.map(|_| Event::Overturns));
        events
    }

    /// The first event within a step.
    pub(super) fn event_in(&mut self, step: &Step<M::Y>) -> Option<Found<Event>> {
        let mut first = self.first_of_smooth(step);
        first = first.map(|found| placed(self, step, found.event, found.at));
        let behind = BESIDE * self.walker.scales.length;
        for obstacle in 0..self.walker.world.obstacle_count() {
            let Some(near) = self.comes_near(step, obstacle) else { continue };
            let until = first.map_or(1.0, |found| found.at);
            let ahead = self.outlook(step, [near, until]);
            for support in self.walker.world.of_obstacle(obstacle).into_iter().flatten() {
                let clear = || self.walker.world.is_clear(support, &ahead, behind);
                if self.held.contains(support)
                    || self.flush.contains(support)
                    || self.fixed.holds(self.walker.world, support)
                    || !self.departing.contains(support) && clear()
                {
                    continue;
                }
                first = self.touch_of(step, (support, near), first).or(first);
            }
        }
        first
    }

    /// The first fall of a smooth event.
    ///
    /// Where two places that carry come together their forces grow without bound and change their signs, and no nodes on both sides of that tell what they do: before what was found it is
    /// looked again, for something else that has fallen and stays below zero until there.
    fn first_of_smooth(&mut self, step: &Step<M::Y>) -> Option<Found<Event>> {
        let mut first = self.first_until(step, 1.0)?;
        while first.at > 0.0
            && let Some(before) = self.first_until(step, first.at)
            && before.event != first.event
            && before.at < ALMOST * first.at
            && self.value_in(step, &before.event, ALMOST * first.at) < 0.0
        {
            first = before;
        }
        Some(first)
    }

    /// The value of an event's function at a place of a step, searched for the first fall: one that is no number hides it.
    fn value_in(&mut self, step: &Step<M::Y>, event: &Event, x: f64) -> f64 {
        let Place { y, at, .. } = self.place(step, x);
        let known = self.known_at.iter().find(|(known, _)| known.to_bits() == x.to_bits());
        let value = match known {
            Some((_, known)) => self.value_at(event, &y, &at, known),
            None => self.value_at(event, &y, &at, &self.motion.known(&y)),
        };
        evaluated(Quantity::Event, value)
    }

    /// The same up to a place of a step. Forces do not exist where all places that carry come together: where something ends the mode before, none is lost.
    fn first_until(&mut self, step: &Step<M::Y>, until: f64) -> Option<Found<Event>> {
        let (mut first, mut without) = (None, f64::INFINITY);
        let (_, lost) = watched(|| {
            for event in self.smooth_events() {
                let mut of = |share: f64| {
                    let x = share * until;
                    let value = self.value_in(step, &event, x);
                    without = if value.is_nan() { x.min(without) } else { without };
                    [value]
                };
                let fall = first_fall(&mut of).map(|fall| Found::at(fall.at * until, event));
                first = earlier(first, fall);
            }
        });
        if lost && !first.is_some_and(|found: Found<Event>| found.at < without) {
            evaluated(Quantity::Event, f64::NAN);
        }
        first
    }

    /// How the body moves between two places of a step.
    fn outlook(&mut self, step: &Step<M::Y>, [from, until]: [f64; 2]) -> Outlook {
        let Place { at, moving, .. } = self.place(step, from);
        let time = (until - from).max(0.0) * step.length;
        Outlook::of(&moving, self.motion.most(&at, time), time)
    }

    /// The touch of a support between a place of a step and an event that is found already.
    fn touch_of(
        &mut self,
        step: &Step<M::Y>,
        (support, near): (usize, f64),
        first: Option<Found<Event>>,
    ) -> Option<Found<Event>> {
        let until = first.map_or(1.0, |found| found.at);
        let from = if self.departing.contains(support) {
            let rounding = STILL_ACCELERATION * self.walker.world.gravity().norm();
            let mut bend = |x: f64| {
                let Place { at, moving, .. } = self.place(step, x);
                let second = self.height_of(support, &at, &moving).second + rounding;
                // At the very start it may be zero, but for rounding.
                [if x == 0.0 { second.max(0.0) } else { second }]
            };
            first_fall(&mut bend).map_or(1.0, |fall| fall.at)
        } else {
            near
        };
        self.march(step, (support, from, until))
    }

    /// The place of a step until which the body is certain to be beside an obstacle; `None` where it is so for the whole step.
    fn comes_near(&mut self, step: &Step<M::Y>, obstacle: usize) -> Option<f64> {
        let (mut x, length) = (0.0, step.length);
        if self.walker.world.obstacle_count() == 1 {
            return Some(x);
        }
        while x < 1.0 {
            let Place { at, moving, .. } = self.place(step, x);
            let most = self.motion.most(&at, (1.0 - x) * length);
            let clear = self.walker.world.distance(obstacle, moving.state.centre) - self.walker.scales.length;
            let rate = -moving.state.velocity.norm();
            let next = Height { value: clear, rate, second: 0.0 }.safe(most.acceleration) / length;
            // So near, or told from what is no number.
            if !(clear > 0.0 && next > NEAR) {
                return Some(x);
            }
            x += next;
        }
        None
    }

    /// A support with this height goes along its plane between two places of a step and never leaves it: beside a wall, where nothing presses it.
    pub(super) fn skims(
        &mut self,
        step: &Step<M::Y>,
        support: usize,
        height: &Height,
        [from, until]: [f64; 2],
    ) -> bool {
        let skimmed = SKIMMED.map(|share| from + share * (until - from));
        // What is measured in the world is less exact than what is counted on.
        let ends = self.walker.world.limits(support) > 0;
        let (low, slow) = if ends { (SKIMS_BESIDE, SKIMS_MEASURED) } else { (SKIMS, SKIMS) };
        let (low, slow) = (low * self.walker.scales.length, slow * self.walker.scales.speed);
        // In a short step it is as slow as the rounding of places is small.
        let slow = if ends { slow.max(SKIMS * self.walker.scales.length / step.length) } else { slow };
        let stays = |height: &Height| height.value.abs() <= low && height.rate.abs() <= slow;
        let beside = self.walker.world.planes().len() > 1;
        if beside && stays(height) && skimmed.into_iter().all(|x| stays(&self.look(step, support, x))) {
            return true;
        }
        let world = self.walker.world;
        world.pair(support).is_some_and(|pair| {
            let mut pose = |x: f64| self.place(step, x).moving.state.pose();
            pair.is_parallel(pose(from)) && skimmed.into_iter().all(|x| pair.is_parallel(pose(x)))
        })
    }

    /// The motion at a fraction of a step.
    pub(super) fn place(&mut self, step: &Step<M::Y>, x: f64) -> Place<M::Y> {
        self.walker.effort.event_evaluations += 1;
        // All supports are looked at from the same places first.
        if let Some(known) = self.places.iter().find(|known| known.x.to_bits() == x.to_bits()) {
            return *known;
        }
        let y = step.at(x);
        let known = self.motion.known(&y);
        let at = self.motion.posture_at(&y, self.elapsed + x * step.length, &known);
        let place = Place { x, y, at, moving: self.motion.moving(&at) };
        if self.places.len() < MOST_PLACES {
            self.places.push(place);
            self.known_at.push((x, known));
        }
        place
    }

    /// The height of a support at a fraction of a step.
    pub(super) fn look(&mut self, step: &Step<M::Y>, support: usize, x: f64) -> Height {
        let seen = self.place(step, x);
        self.approach(support, &seen)
    }
}

fn earlier(a: Option<Found<Event>>, b: Option<Found<Event>>) -> Option<Found<Event>> {
    match (a, b) {
        (Some(x), Some(y)) => Some(if y.at < x.at { y } else { x }),
        (one, other) => one.or(other),
    }
}
