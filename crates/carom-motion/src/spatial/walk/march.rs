//! The way to a touch: steps along the motion, each so long that the support cannot come down in it.

use super::events::Place;
use super::gliding::Gliding;
use super::motion::{Event, Motion};
use crate::spatial::geometry::posture::{Bend, Height};
use crate::tolerance::{BESIDE, CORRECTION_ROUNDING, FALLS_WITHIN, GRAZES, LEAST_MARCH, SKIMS_BESIDE};
use carom_num::course::Found;
use carom_num::falls::first_fall;
use carom_num::ode8::Step;

/// Looks of a march that is not long.
const FEW: u32 = 4;
/// Looks of a march after which the rest of the step is looked at as a whole.
const MANY: u32 = 16;
/// Looks of a march after which its steps are no shorter than what grazes a plane needs.
const PATIENCE: u32 = 256;
/// Steps of Newton's method on the dense output after which a step is made to where they have come.
const MOST_NEWTON: u32 = 20;

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
        let ends = self.walker.world.limits(support) > 0;
        let behind = BESIDE * self.walker.scales.length;
        let (mut x, mut looks) = (from, 0_u32);
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
            if looks == MANY && height.value > 0.0 {
                return self.falls_next(step, (support, x, until));
            }
            let bend = self.bend(support, &seen, (until - x) * length);
            let least = self.least(&bend, length, looks);
            let aside = self.stays_aside(support, &seen, (until - x) * length);
            // Beside a face, or beyond an edge: what comes through from behind touches nothing.
            if aside > 0.0 || ends && height.value < -behind {
                let rate = height.rate.copysign(height.rate * height.value);
                let other = Height { value: height.value.abs(), rate, second: 0.0 };
                let clear = other.clear(&bend).max(self.apart(support, &seen, (until - x) * length, looks));
                let next = (x + (clear.max(aside) / length).max(least)).min(until);
                let waits = height.value > 0.0 && next > x + clear / length;
                // While it was waited for what is beside it may come through just where it is there.
                if waits && let Some(found) = self.comes_through(step, support, [x, next]) {
                    return Some(found);
                }
                x = next;
                continue;
            }
            // Until here the bound on the acceleration holds.
            let reach = until.min(x + bend.lasts / length);
            if height.rate < 0.0 && 2.0 * bend.most * height.value < height.rate * height.rate {
                let roots = [height.safe(bend.most), height.sure(bend.most)].map(|time| x + time / length);
                // What hardly moves may come down long after this step.
                let later =
                    roots[0] >= reach || roots[1] > reach && self.look(step, support, reach).value > 0.0;
                if later && reach >= until {
                    return None;
                }
                if !later {
                    let roots = roots.map(|end| end.min(reach));
                    // What is below its plane by rounding may have come there before.
                    let at = root_between(roots, length, &mut |x| self.look(step, support, x)).max(x);
                    if at >= until || self.is_within(step, support, at) {
                        return (at < until).then_some(Found::at(at, Event::Touches(support)));
                    }
                    x = at + least;
                    continue;
                }
            }
            let apart = self.apart(support, &seen, (until - x) * length, looks);
            let clear = height.clear(&bend).max(apart) / length;
            let next = (x + clear.max(least)).min(until);
            let passes = ends && height.value > 0.0 && clear < least;
            if passes && let Some(found) = self.comes_through(step, support, [x, next]) {
                return Some(found);
            }
            x = next;
        }
        None
    }

    /// Where a support that is above its face comes down next, told as other events are: beside a wall that a bound on the acceleration brings nearer than the motion does a march would
    /// take least steps.
    fn falls_next(
        &mut self,
        step: &Step<M::Y>,
        (support, from, until): (usize, f64, f64),
    ) -> Option<Found<Event>> {
        let mut rest = |share: f64| [self.look(step, support, from + share * (until - from)).value];
        let at = from + first_fall(&mut rest)?.at * (until - from);
        let around = [at - FALLS_WITHIN * (until - from), at + FALLS_WITHIN * (until - from)];
        let around = around.map(|x| x.clamp(from, until));
        let at = root_between(around, step.length, &mut |x| self.look(step, support, x));
        if self.is_within(step, support, at) {
            return Some(Found::at(at, Event::Touches(support)));
        }
        self.march(step, (support, around[1] + LEAST_MARCH, until))
    }

    /// For so long at least edges stay apart: asked in a march of several looks, where what is zero as they touch is small because they are nearly parallel.
    fn apart(&self, support: usize, seen: &Place<M::Y>, time: f64, looks: u32) -> f64 {
        if looks < FEW {
            return 0.0;
        }
        let most = self.motion.most(&seen.at, time);
        let spare = SKIMS_BESIDE * self.walker.scales.length;
        self.walker.world.apart(support, &seen.moving.state, &most, spare)
    }

    /// The shortest step of a march, as a part of the step that it looks at. Where it takes long, what grazes a plane comes below it in one by no more than is told apart there.
    fn least(&self, bend: &Bend, length: f64, looks: u32) -> f64 {
        if looks <= PATIENCE {
            return LEAST_MARCH;
        }
        let time = (GRAZES * self.walker.scales.length / bend.most).sqrt();
        if time.is_finite() { LEAST_MARCH.max(time / length) } else { LEAST_MARCH }
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
