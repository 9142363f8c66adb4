//! What ends a piece of a mode: an event function, or an obstacle that is met.
use super::glide::MOST_STEPS;
use super::path::Stretch;
use super::walker::Walker;
use crate::evaluated::{Quantity, evaluated};
use crate::planar::contact::{
    bounds::Bounds,
    kinematics::{Pairing, turns},
    separation::{Leniency, Open},
};
use crate::planar::geometry::{Pose, State, Twist};
use crate::planar::modes::{
    mode::Acceleration,
    watch::{Watch, WatchList, Watched},
};
use crate::tolerance::{APPROACH_PART, GRAZING_PART, GRAZING_STEP, MET_GAP, STEP_PAST_TOUCH, TOUCHING_GAP};
use carom_num::Vec2;

/// The states of several bodies as the integration takes them.
pub(super) type Vector<const B: usize> = [[f64; 6]; B];

pub(super) fn pack<const B: usize>(states: &[State; B]) -> Vector<B> {
    states.map(|s| {
        let (c, v) = (s.pose.centre, s.twist.velocity);
        [c.x, c.y, s.pose.angle, v.x, v.y, s.twist.spin]
    })
}

pub(super) fn unpack<const B: usize>(y: &Vector<B>) -> [State; B] {
    y.map(|y| State {
        pose: Pose { centre: Vec2::new(y[0], y[1]), angle: y[2] },
        twist: Twist { velocity: Vec2::new(y[3], y[4]), spin: y[5] },
    })
}

pub(super) fn rate<const B: usize>(y: &Vector<B>, a: &[Acceleration; B]) -> Vector<B> {
    let of = |value: f64| evaluated(Quantity::Acceleration, value);
    std::array::from_fn(|b| [y[b][3], y[b][4], y[b][5], a[b].linear.x, a[b].linear.y, of(a[b].angular)])
}

/// What ends a piece of a mode.
#[derive(Clone, Copy, Debug)]
pub(super) enum Event {
    /// An event function of the mode came to zero.
    Watched(Watched),
    /// A pair of another obstacle closed.
    Meets(Pairing),
}

/// Steps towards an obstacle after which what grazes it counts as met: one that is not grazed takes tens.
const MOST_GRAZING_STEPS: u32 = 1000;
/// Doublings of the steps along what grazes for long.
const MOST_DOUBLINGS: u32 = 30;

impl<const B: usize> Walker<'_, B> {
    /// Forgets a pair that has opened and has left its features since: what falls to zero is the distance of a point and a line elsewhere.
    pub(super) fn watch_no_more(&mut self, pair: Pairing, list: &mut WatchList<'_>) {
        self.departing.retain(|opened| *opened != pair);
        list.strike(Watch::Gap(pair));
    }

    /// True where a pair lies past the extents of its features.
    pub(super) fn has_run_off(&self, pair: Pairing, states: &[State; B]) -> bool {
        let extents = self.world.extents(states, &turns(states), pair);
        let (reach, hair) = (TOUCHING_GAP * self.scales.length, self.world.hair(pair));
        extents.iter().enumerate().any(|(slot, extent)| {
            let past = |room: f64| room < -hair || room < -reach && !self.world.goes_on(pair, slot);
            extent.is_some_and(|(room, _)| past(room))
        })
    }

    /// The first place before `until` where an obstacle that is not touched is met.
    pub(super) fn first_meeting(
        &self,
        tried: &impl Stretch<B>,
        until: f64,
        bounds: &[Bounds; B],
    ) -> Option<(f64, Pairing)> {
        let mut first: Option<(f64, Pairing)> = None;
        for (body, bounds) in bounds.iter().enumerate().take(self.world.bodies.len()) {
            for obstacle in 0..self.world.obstacles.len() {
                // Two hulls that hold each other touch elsewhere only by turning, and that is watched.
                let holds = self.held.iter().any(|h| h.pair.meeting() == (body, obstacle));
                if !(holds && self.world.are_hulls((body, obstacle))) {
                    let end = first.map_or(until, |(x, _)| x);
                    first = self.march_on(tried, end, (body, obstacle), bounds).or(first);
                }
            }
        }
        first
    }

    /// The pairs of a body and an obstacle that touch where they hold each other.
    fn each_held_point(&self, meeting: (usize, usize), mut offer: impl FnMut(Pairing)) {
        let reach = TOUCHING_GAP * self.scales.length;
        self.world.each_pair(meeting, |pair| {
            let own = self.held.iter().filter(|h| h.pair.meeting() == meeting);
            if own.clone().any(|h| h.pair == pair)
                || self.kinematics(pair).gap.abs() <= reach
                    && own.clone().any(|h| self.coincide(h.pair, pair))
            {
                offer(pair);
            }
        });
    }

    /// The place before `end` where a body meets an obstacle.
    fn march_on(
        &self,
        tried: &impl Stretch<B>,
        end: f64,
        meeting: (usize, usize),
        bounds: &Bounds,
    ) -> Option<(f64, Pairing)> {
        let whole = Bounds { horizon: end * tried.length(), ..*bounds };
        if self.world.out_of_reach(&tried.start()[meeting.0], meeting, &whole) {
            return None;
        }
        let known = self.known();
        let holds = self.held.iter().any(|h| h.pair.meeting() == meeting);
        // What is held stays in touch.
        let mut lenient = Leniency::default();
        if holds {
            self.each_held_point(meeting, |pair| {
                lenient.open.push(Open { pair, time: f64::INFINITY });
            });
        }
        // Pairs that have just opened have event functions of their own.
        for pair in self.departing.iter().filter(|p| p.meeting() == meeting) {
            lenient.open.push(Open { pair: *pair, time: f64::INFINITY });
        }
        // Shortest steps, as fractions of the stretch: that exact places need, and along what grazes for long.
        let [exact, grazing] =
            [STEP_PAST_TOUCH, GRAZING_STEP].map(|least| least * self.scales.time / tried.length());
        let left = self.world.side(&self.sides, meeting);
        let (mut x, mut steps) = (0.0, 0);
        while x < end {
            let states = tried.states(x);
            let state = &states[meeting.0];
            let bounds = Bounds { horizon: (end - x) * tried.length(), left, ..*bounds };
            lenient.allowance = 0.0;
            // A march past what is held leaves it out of account from the first.
            let strict = if holds { &lenient } else { &Leniency::NONE };
            let apart = self.world.apart(state, meeting, &bounds, strict);
            steps += 1;
            if apart.distance > MET_GAP * self.scales.length {
                let least = if steps > MOST_STEPS { grazing } else { APPROACH_PART };
                x += (apart.safe / tried.length()).max(least);
                continue;
            }
            // What grazes for long counts as met: the rate problem says whether it is held.
            let watched = |pair: &Pairing| lenient.open.iter().any(|o| o.pair == *pair);
            let nearest = || self.world.nearest(&states, meeting, left);
            let lingers = || nearest().filter(|_| steps > MOST_GRAZING_STEPS);
            let closes = self.world.closing(&states, meeting, &known).iter().copied().find(|p| !watched(p));
            if let Some(pair) = closes.or_else(|| lingers().filter(|p| !watched(p))) {
                return Some((x, pair));
            }
            lenient.allowance = 2.0 * MET_GAP * self.scales.length + (-apart.distance).max(0.0);
            let free = self.world.apart(state, meeting, &bounds, &lenient);
            // What has just opened and still grazes has its own event function: what else touches meanwhile is found a moment late, and where.
            let least = match steps / MOST_GRAZING_STEPS {
                0 => exact.max(GRAZING_PART),
                thousands => grazing * f64::from(1 << (thousands - 1).min(MOST_DOUBLINGS)),
            };
            x += (free.safe / tried.length()).max(least);
        }
        None
    }
}
