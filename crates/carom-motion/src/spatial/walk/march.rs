//! The way to a touch: steps along the motion, each so long that the support cannot come down in it.

use super::events::Place;
use super::gliding::Gliding;
use super::motion::{Event, Motion};
use crate::spatial::geometry::posture::{Bend, Height};
use crate::tolerance::{BESIDE, CORRECTION_ROUNDING, FALLS_WITHIN, GRAZES, LEAST_MARCH, SKIMS_BESIDE};
use carom_num::course::Found;
use carom_num::falls::first_fall;
use carom_num::ode8::Step;
use std::ops::ControlFlow::{self, Break, Continue};

/// Looks of a march that is not long.
const FEW: u32 = 4;
/// Looks of a march after which the rest of the step is looked at as a whole, for the first time: ever more seldom where that does not end it.
const MANY: u32 = 16;
/// Looks of a march after which its steps are no shorter than what grazes a plane needs.
const PATIENCE: u32 = 256;
/// Steps of Newton's method on the dense output after which a step is made to where they have come.
const MOST_NEWTON: u32 = 20;

/// A look of a march at a support.
struct Look<Y> {
    x: f64,
    until: f64,
    seen: Place<Y>,
    height: Height,
    bend: Bend,
    /// For so long at least it stays beside its face \[s\].
    aside: f64,
    /// How many looks there were.
    count: u32,
}

/// What has to end before a support can touch.
#[derive(Clone, Copy)]
enum Waits {
    /// It is above its face.
    Above,
    /// It is behind it.
    Behind,
    /// It is there, and rises.
    Rising,
    /// It is there, beyond a limit of the face.
    ShutOut((usize, bool)),
}

/// Goes on with a march at a place, or ends it with what was found.
type Goes = ControlFlow<Option<Found<Event>>, f64>;

impl<M: Motion> Gliding<'_, '_, M> {
    /// The place in a part of a step where a support is certain to come down next: before it nothing does.
    ///
    /// From a height h, its rate and a bound B on the size of its acceleration the plane is not reached for a while; and it is certain to be reached
    /// where `ḣ < 0` and `2 B h < ḣ²`.
    pub(super) fn march(
        &mut self,
        step: &Step<M::Y>,
        (support, from, until): (usize, f64, f64),
    ) -> Option<Found<Event>> {
        let length = step.length;
        let behind = self.behind(support);
        let (mut x, mut looks, mut many) = (from, 0_u32, MANY);
        while x < until {
            let seen = self.place(step, x);
            looks += 1;
            let height = self.approach(support, &seen);
            // It is noted, and nothing can be said of what comes after.
            if height.value.is_nan() {
                return None;
            }
            // What comes to its plane later may go along it from there on: it is asked again, ever more seldom.
            if looks.is_power_of_two() && self.skims(step, support, &height, [x, until]) {
                return None;
            }
            if looks >= many {
                many *= 2;
                match self.rest_of(step, (support, height), [x, until]) {
                    Continue(next) => x = next,
                    Break(found) => return found,
                }
                continue;
            }
            let time = (until - x) * length;
            let bend = self.bend(support, &seen, time);
            let aside = self.stays_aside(support, &seen, time);
            let look = Look { x, until, seen, height, bend, aside, count: looks };
            // Beside a face, or beyond an edge: what comes through from behind touches nothing.
            let goes = if aside > 0.0 || height.value < -behind {
                self.beside(step, support, &look)
            } else {
                self.above(step, support, &look)
            };
            match goes {
                Continue(next) => x = next,
                Break(found) => return found,
            }
        }
        None
    }

    /// The next place of a march of what is beside its face or behind it.
    fn beside(&mut self, step: &Step<M::Y>, support: usize, look: &Look<M::Y>) -> Goes {
        let &Look { x, until, height, ref bend, aside, .. } = look;
        let rate = height.rate.copysign(height.rate * height.value);
        let other = Height { value: height.value.abs(), rate, second: 0.0 };
        let clear = other.clear(bend).max(self.apart(step, support, look));
        let next = (x + (clear.max(aside) / step.length).max(self.least(step, look))).min(until);
        let waits = height.value > 0.0 && next > x + clear / step.length;
        // While it was waited for what is beside it may come through just where it is there.
        if waits && let Some(found) = self.comes_through(step, support, [x, next]) {
            return Break(Some(found));
        }
        Continue(next)
    }

    /// The same of what is above its face, or certain to come down to it.
    fn above(&mut self, step: &Step<M::Y>, support: usize, look: &Look<M::Y>) -> Goes {
        let &Look { x, until, height, ref bend, .. } = look;
        let (length, least) = (step.length, self.least(step, look));
        // Until here the bound on the acceleration holds.
        let reach = until.min(x + bend.lasts / length);
        if height.rate < 0.0 && 2.0 * bend.most * height.value < height.rate * height.rate {
            let roots = [height.safe(bend.most), height.sure(bend.most)].map(|time| x + time / length);
            // What hardly moves may come down long after this step.
            let later = roots[0] >= reach || roots[1] > reach && self.look(step, support, reach).value > 0.0;
            if later && reach >= until {
                return Break(None);
            }
            if !later {
                let roots = roots.map(|end| end.min(reach));
                // What is below its plane by rounding may have come there before.
                let at = root_between(roots, length, &mut |x| self.look(step, support, x)).max(x);
                if at >= until || self.is_within(step, support, at) {
                    return Break((at < until).then_some(Found::at(at, Event::Touches(support))));
                }
                return Continue(at + least);
            }
        }
        let clear = height.clear(bend).max(self.apart(step, support, look)) / length;
        let next = (x + clear.max(least)).min(until);
        let ends = self.walker.world.limits(support) > 0;
        let passes = ends && height.value > 0.0 && clear < least;
        if passes && let Some(found) = self.comes_through(step, support, [x, next]) {
            return Break(Some(found));
        }
        Continue(next)
    }

    /// What a support does between two places of a step, told as other events are: beside a wall that a bound on the acceleration brings nearer than the motion does a march would
    /// take least steps.
    fn rest_of(
        &mut self,
        step: &Step<M::Y>,
        (support, height): (usize, Height),
        [from, until]: [f64; 2],
    ) -> Goes {
        let (world, behind) = (self.walker.world, self.behind(support));
        let waits = match height.value {
            h if h > 0.0 => Waits::Above,
            h if h < -behind => Waits::Behind,
            _ if height.rate > 0.0 => Waits::Rising,
            _ => {
                let state = self.place(step, from).moving.state;
                let Some(case) = world.shut_out(support, &state) else { return Continue(from) };
                Waits::ShutOut(case)
            }
        };
        let rest = until - from;
        let mut course = |share: f64| {
            let seen = self.place(step, from + share * rest);
            let now = self.approach(support, &seen);
            match waits {
                Waits::Above => [now.value, 1.0],
                Waits::Behind => [-behind - now.value, 1.0],
                Waits::Rising => [-now.value, now.rate],
                Waits::ShutOut(case) => world.kept_out(support, case, &seen.moving.state),
            }
        };
        let Some(fall) = first_fall(&mut course) else { return Break(None) };
        let mut around = [-FALLS_WITHIN, FALLS_WITHIN].map(|by| (fall.at + by).clamp(0.0, 1.0));
        // A hop that is short beside the step is seen, but not so exactly.
        if course(around[0])[0] <= 0.0 {
            around = [0.0, around[0]];
        }
        let over = course(around[1])[0] > 0.0;
        let around = around.map(|share| from + share * rest);
        match waits {
            Waits::Above if over => Continue(around[1] + LEAST_MARCH),
            Waits::Above => {
                let at = root_between(around, step.length, &mut |x| self.look(step, support, x));
                if self.is_within(step, support, at) {
                    return Break(Some(Found::at(at, Event::Touches(support))));
                }
                Continue(around[1] + LEAST_MARCH)
            }
            Waits::Behind => Continue(around[1] + LEAST_MARCH),
            // From there on it may touch.
            Waits::Rising | Waits::ShutOut(_) => Continue(around[0] + LEAST_MARCH),
        }
    }

    /// What is deeper than this behind its face touches nothing \[m\]: without bound where the face has no ends.
    fn behind(&self, support: usize) -> f64 {
        let ends = self.walker.world.limits(support) > 0;
        if ends { BESIDE * self.walker.scales.length } else { f64::INFINITY }
    }

    /// For so long at least edges stay apart: asked in a march of several looks, where what is zero as they touch is small because they are nearly parallel.
    fn apart(&self, step: &Step<M::Y>, support: usize, look: &Look<M::Y>) -> f64 {
        if look.count < FEW {
            return 0.0;
        }
        let most = self.motion.most(&look.seen.at, (look.until - look.x) * step.length);
        let spare = SKIMS_BESIDE * self.walker.scales.length;
        self.walker.world.apart(support, &look.seen.moving.state, &most, spare)
    }

    /// The shortest step of a march, as a part of the step that it looks at. Where it takes long, what grazes a plane comes below it in one by no more than is told apart there.
    fn least(&self, step: &Step<M::Y>, look: &Look<M::Y>) -> f64 {
        if look.count <= PATIENCE {
            return LEAST_MARCH;
        }
        let time = (GRAZES * self.walker.scales.length / look.bend.most).sqrt();
        if time.is_finite() { LEAST_MARCH.max(time / step.length) } else { LEAST_MARCH }
    }

    /// The touch of what is above its face at the first of two places of a step, behind it at the second, and within its ends where it comes through.
    fn comes_through(&mut self, step: &Step<M::Y>, support: usize, places: [f64; 2]) -> Option<Found<Event>> {
        let behind = BESIDE * self.walker.scales.length;
        if self.look(step, support, places[1]).value >= -behind {
            return None;
        }
        let at = root_between(places, step.length, &mut |x| self.look(step, support, x));
        self.is_within(step, support, at).then_some(Found::at(at, Event::Touches(support)))
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
