//! The events of a mode: found on the dense output of a step, polished by stepping to them.

use super::course::Course;
use super::posture::{Height, Posture};
use super::terms::{Effort, Overturning};
use super::{Supports, World};
use crate::evaluated::{Quantity, evaluated};
use crate::tolerance::{CORRECTION_ROUNDING, FIRST_SECANT, LEAST_MARCH};
use carom_num::Vec3;
use carom_num::elementary::cos;
use carom_num::falls::first_fall;
use carom_num::ode8::{EVALUATIONS_PLAIN, Step};

/// What ends a stretch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Event {
    /// A support comes down on the plane.
    Touches(usize),
    /// The normal force on a held support falls to zero: the foot's, or that on the other end of an edge.
    Lets {
        /// The support.
        support: usize,
        /// Its place among the normal forces.
        place: usize,
    },
    /// The friction that a support takes, one end of an edge or both of them, has come to the edge of its cone: the first end's, the second's, or that along
    /// the edge. Of a body that slides, that of the support of this number.
    Slips(usize),
    /// The slip of a support comes to zero.
    Stops,
    /// Friction presses a sliding body on the plane without bound.
    Jams,
    /// It leans over too far.
    Overturns,
}

/// An event within a step, as a fraction of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) at: f64,
    pub(super) event: Event,
}

/// Steps to an event after which it is taken where it is.
const MOST_STEPS_TO_EVENT: u32 = 8;
/// Steps of Newton's method on the dense output after which a step is made to where they have come.
const MOST_NEWTON: u32 = 20;

/// What is watched during a stretch.
pub(super) struct Watch<'w, C> {
    pub(super) world: &'w World,
    pub(super) course: C,
    /// Supports that are held.
    pub(super) held: Supports,
    /// Supports that have just left the plane without speed: their height leaves zero by its second or third derivative.
    pub(super) departing: Supports,
    pub(super) overturning: Option<Overturning>,
    /// The middle of the supports, body axes.
    pub(super) middle: Vec3,
}

impl<C: Course> Watch<'_, C> {
    fn value(&self, event: &Event, y: &C::Y, at: &Posture) -> f64 {
        let value = match *event {
            Event::Touches(support) => return self.height(support, at).value,
            Event::Overturns => self.uprightness(at),
            _ => self.course.value(event, y, at),
        };
        evaluated(Quantity::Event, value)
    }

    /// Positive as long as the body has not overturned.
    fn uprightness(&self, at: &Posture) -> f64 {
        match self.overturning {
            None => 1.0,
            Some(Overturning::Tilt { axis, angle }) => at.up.dot(axis) - cos(angle),
            Some(Overturning::Beyond) => {
                let Some(edge) = self.course.leans_over() else { return 1.0 };
                // Horizontal parts, across the edge: from the foot to the mass centre, and to the middle of the supports.
                let flat = |r: Vec3| r - at.up * r.dot(at.up) - edge * r.dot(edge);
                flat(-at.from).dot(flat(self.middle - at.from))
            }
        }
    }

    pub(super) fn height(&self, support: usize, at: &Posture) -> Height {
        let height = self.course.height(self.world, support, at);
        Height { value: evaluated(Quantity::Gap, height.value), ..height }
    }

    /// Event functions that are looked at at nodes.
    fn smooth_events(&self) -> Vec<Event> {
        let mut events = self.course.smooth_events();
        events.extend(self.overturning.map(|_| Event::Overturns));
        events
    }

    /// The first event within a step that starts `elapsed` after the stretch does.
    pub(super) fn first_event(&self, step: &Step<C::Y>, elapsed: f64, effort: &mut Effort) -> Option<Found> {
        let mut first: Option<Found> = None;
        let place = |x: f64| {
            let y = step.at(x);
            let at = self.course.posture(&y, elapsed + x * step.length);
            (y, at)
        };
        let posture = |x: f64| place(x).1;
        for event in self.smooth_events() {
            let mut of = |x: f64| {
                effort.event_evaluations += 1;
                let (y, at) = place(x);
                [self.value(&event, &y, &at)]
            };
            let fall = first_fall(&mut of).map(|fall| Found { at: fall.at, event });
            first = earlier(first, fall);
        }
        let free = (0..self.world.body().supports().len()).filter(|i| !self.held.contains(*i));
        for support in free {
            let until = first.map_or(1.0, |found| found.at);
            let from = if self.departing.contains(support) {
                let mut bend = |x: f64| {
                    effort.event_evaluations += 1;
                    let second = self.height(support, &posture(x)).second;
                    // At the very start it may be zero, but for rounding.
                    [if x == 0.0 { second.max(0.0) } else { second }]
                };
                first_fall(&mut bend).map_or(1.0, |fall| fall.at)
            } else {
                0.0
            };
            let touch = self.march((support, from, until), step.length, &posture, effort);
            first = touch.or(first);
        }
        first
    }

    /// The place in a part of a step where a support is certain to come down next: before it nothing does.
    ///
    /// From a height h, its rate and a bound B on the size of its acceleration the plane is not reached for a while; and it is certain to be reached
    /// where `ḣ < 0` and `2 B h < ḣ²`.
    fn march(
        &self,
        (support, from, until): (usize, f64, f64),
        length: f64,
        posture: &impl Fn(f64) -> Posture,
        effort: &mut Effort,
    ) -> Option<Found> {
        let arm = self.world.body().supports()[support];
        let mut x = from;
        while x < until {
            let at = posture(x);
            let height = self.height(support, &at);
            // It is noted, and nothing can be said of what comes after.
            if height.value.is_nan() {
                return None;
            }
            let bend = self.course.bend(&at, arm, (until - x) * length);
            effort.event_evaluations += 1;
            if height.rate < 0.0 && 2.0 * bend * height.value < height.rate * height.rate {
                let ends = [height.safe(bend), height.sure(bend)].map(|time| x + time / length);
                let mut look = |x: f64| {
                    effort.event_evaluations += 1;
                    self.height(support, &posture(x))
                };
                let at = root_between(ends, length, &mut look);
                return (at < until).then_some(Found { at, event: Event::Touches(support) });
            }
            x += (height.safe(bend) / length).max(LEAST_MARCH);
        }
        None
    }

    /// Steps TO the event: returns the length of the step that ends there, and its end.
    pub(super) fn polish(
        &self,
        step: &Step<C::Y>,
        found: &Found,
        elapsed: f64,
        effort: &mut Effort,
    ) -> (f64, C::Y) {
        let mut look = |length: f64| {
            effort.evaluations += EVALUATIONS_PLAIN;
            effort.event_evaluations += 1;
            let end = self.course.advanced(step, length);
            let at = self.course.posture(&end, elapsed + length);
            let slope = match found.event {
                Event::Touches(support) => Some(self.height(support, &at).rate),
                _ => None,
            };
            (end, self.value(&found.event, &end, &at), slope)
        };
        let mut length = found.at * step.length;
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..MOST_STEPS_TO_EVENT {
            let (end, value, slope) = look(length);
            // The rate of a height is known; other event functions need a secant, and the first one a second point near by.
            let slope = slope.unwrap_or_else(|| {
                let (at, was) = before.filter(|(at, _)| *at != length).unwrap_or_else(|| {
                    let at = length * (1.0 - FIRST_SECANT);
                    (at, look(at).1)
                });
                (value - was) / (length - at)
            });
            let correction = -value / slope;
            if !correction.is_finite() || correction.abs() <= CORRECTION_ROUNDING * length {
                return (length, end);
            }
            before = Some((length, value));
            length = (length + correction).clamp(0.0, 1.5 * step.length);
        }
        (length, look(length).0)
    }
}

/// The root of a height between two places of a step: Newton's method, kept between them.
fn root_between([mut low, mut high]: [f64; 2], length: f64, look: &mut impl FnMut(f64) -> Height) -> f64 {
    let mut x = low;
    for _ in 0..MOST_NEWTON {
        let height = look(x);
        if height.value > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = x - height.value / (height.rate * length);
        let next = if newton >= low && newton <= high { newton } else { 0.5 * (low + high) };
        if (next - x).abs() <= CORRECTION_ROUNDING {
            return next;
        }
        x = next;
    }
    x
}

fn earlier(a: Option<Found>, b: Option<Found>) -> Option<Found> {
    match (a, b) {
        (Some(x), Some(y)) => Some(if y.at < x.at { y } else { x }),
        (one, other) => one.or(other),
    }
}
