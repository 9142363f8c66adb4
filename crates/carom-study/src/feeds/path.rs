//! The longest interval at which identical parts can touch, from the way of one of them alone.
//!
//! Until parts touch, each does what the one before did, an interval later. So they touch at the interval T where the part, somewhere on
//! its way, overlaps itself a time T later. The largest such T is found by branch and bound over the time s and the interval T: a box is given
//! up where the distance of the poses at s and at s + T, at its middle, is more than either can change within it.

use crate::tolerance::POSES_TOUCH;
use carom_feeder::Run;
use carom_motion::planar::trace::Trace;
use carom_motion::planar::{Pose, Shape, State};
use carom_num::Vec2;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Boxes that are looked at before the search is given up.
const MOST_BOXES: usize = 1_000_000;

/// The largest interval at which a part's way meets itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Longest {
    /// The way meets itself at this interval [s]; 0 where no such interval was seen.
    pub low: f64,
    /// It does not at any longer one than this [s], but for the error of the motion between samples.
    pub high: f64,
    /// Boxes that were looked at.
    pub boxes: usize,
}

/// The longest interval at which parts can touch that all do what this run's part does. It is bracketed to `accuracy` [s], unless a million boxes are
/// too few: that is where parts follow each other for long and almost touch. The run needs its trace.
///
/// # Example
/// A disc of 0.06 m that starts from rest at 6 m/s² is out of its own way after `√(4·0.06/6)` s.
/// ```
/// use carom_feeder::{Feed, examples};
/// use carom_motion::planar::Surface;
/// use carom_study::feeds::{Plan, longest_meeting, search};
/// let feeder = examples::disc_on_a_slope();
/// let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.0, restitution: 0.0 } };
/// let plan = Plan { nodes: 16, accuracy: 1e-4, most: 1 };
/// let alone = search(&feeder, &feed, &plan, |_| None, || ()).unwrap().alone;
/// let longest = longest_meeting(&feeder.part.body.shape, &alone, 1e-7);
/// assert!(longest.low < 0.2 + 1e-6 && 0.2 - 1e-6 < longest.high);
/// ```
pub fn longest_meeting(shape: &Shape, run: &Run, accuracy: f64) -> Longest {
    let way = Way::of(shape, &run.trace);
    way.search(accuracy)
}

/// A cubic between two samples.
#[derive(Clone, Copy, Debug)]
struct Leg {
    from: f64,
    to: f64,
    ends: [State; 2],
    /// No point of the part is faster [m/s].
    speed: f64,
}

/// What a part does from its start to its end.
struct Way<'s> {
    shape: &'s Shape,
    legs: Vec<Leg>,
}

/// Times s from the part's start, by intervals T.
#[derive(Clone, Copy, Debug)]
struct Box2 {
    time: [f64; 2],
    interval: [f64; 2],
}

impl Box2 {
    fn key(&self) -> [f64; 4] {
        [self.interval[1], self.time[0], self.time[1], self.interval[0]]
    }
}

impl PartialEq for Box2 {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Box2 {}

impl PartialOrd for Box2 {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Box2 {
    fn cmp(&self, other: &Self) -> Ordering {
        let both = self.key().into_iter().zip(other.key());
        both.fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(&b)))
    }
}

impl<'s> Way<'s> {
    fn of(shape: &'s Shape, trace: &Trace) -> Self {
        let reach = shape.size();
        let mut legs: Vec<Leg> = vec![];
        for piece in &trace.pieces {
            let inner = piece.samples.iter().map(|sample| (sample.time, sample.state));
            let mut known = (piece.start_time, piece.start);
            for next in inner.chain([(piece.end_time, piece.end)]) {
                if next.0 > known.0 {
                    legs.push(Leg::between(known, next, reach));
                }
                known = next;
            }
        }
        Self { shape, legs }
    }

    fn end(&self) -> f64 {
        self.legs.last().map_or(0.0, |leg| leg.to)
    }

    fn leg_at(&self, time: f64) -> usize {
        self.legs.partition_point(|leg| leg.to < time).min(self.legs.len().saturating_sub(1))
    }

    fn pose(&self, time: f64) -> Pose {
        self.legs.get(self.leg_at(time)).map_or_else(Pose::default, |leg| leg.pose(time))
    }

    /// No point of the part is faster between these times [m/s].
    fn speed(&self, from: f64, to: f64) -> f64 {
        let legs = self.legs[self.leg_at(from)..].iter().take_while(|leg| leg.from <= to);
        legs.map(|leg| leg.speed).fold(0.0, f64::max)
    }

    fn search(&self, accuracy: f64) -> Longest {
        let end = self.end();
        let mut found = Longest { low: 0.0, high: end, boxes: 0 };
        let mut open = BinaryHeap::from([Box2 { time: [0.0, end], interval: [0.0, end] }]);
        let touch = POSES_TOUCH * self.shape.size();
        while let Some(here) = open.pop() {
            found.high = here.interval[1];
            if found.high - found.low <= accuracy || found.boxes >= MOST_BOXES {
                return found;
            }
            found.boxes += 1;
            let [time, interval] = [here.time, here.interval].map(|[low, high]| 0.5 * (low + high));
            let half = [here.time, here.interval].map(|[low, high]| 0.5 * (high - low));
            // Where a box reaches beyond the end, the part is gone.
            let (first, second) = (self.pose(time.min(end)), self.pose((time + interval).min(end)));
            let distance = distance(self.shape, first, second);
            let early = self.speed(here.time[0], here.time[1]);
            let late = self.speed(here.time[0] + here.interval[0], here.time[1] + here.interval[1]);
            let by = [half[0] * (early + late), half[1] * late];
            if distance <= touch && time + interval <= end {
                found.low = found.low.max(interval);
            }
            if distance > by[0] + by[1] + touch {
                continue;
            }
            let (axis, at) = if by[0] > by[1] { (0, time) } else { (1, interval) };
            for part in halves(here, axis, at) {
                if part.time[0] + part.interval[0] < end && part.interval[1] > found.low {
                    open.push(part);
                }
            }
        }
        found.high = found.low;
        found
    }
}

fn halves(whole: Box2, axis: usize, at: f64) -> [Box2; 2] {
    let (mut low, mut high) = (whole, whole);
    if axis == 0 {
        (low.time[1], high.time[0]) = (at, at);
    } else {
        (low.interval[1], high.interval[0]) = (at, at);
    }
    [low, high]
}

impl Leg {
    fn between((from, a): (f64, State), (to, b): (f64, State), reach: f64) -> Self {
        let dt = to - from;
        // A cubic's rate is a quadratic, and lies among these three.
        let mean = (b.pose.centre - a.pose.centre) * (3.0 / dt) - a.twist.velocity - b.twist.velocity;
        let turn = (b.pose.angle - a.pose.angle) * (3.0 / dt) - a.twist.spin - b.twist.spin;
        let speed = [a.twist.velocity, mean, b.twist.velocity].iter().map(|v| v.norm()).fold(0.0, f64::max);
        let spin = [a.twist.spin, turn, b.twist.spin].iter().map(|w| w.abs()).fold(0.0, f64::max);
        Self { from, to, ends: [a, b], speed: speed + spin * reach }
    }

    fn pose(&self, time: f64) -> Pose {
        let dt = self.to - self.from;
        let u = ((time - self.from) / dt).clamp(0.0, 1.0);
        let [a, b] = &self.ends;
        let cubic = |p: f64, q: f64, m: f64, n: f64| {
            let (m, n) = (m * dt, n * dt);
            (((2.0 * p + m - 2.0 * q + n) * u + 3.0 * (q - p) - 2.0 * m - n) * u + m) * u + p
        };
        let along = |of: fn(Vec2) -> f64| {
            cubic(of(a.pose.centre), of(b.pose.centre), of(a.twist.velocity), of(b.twist.velocity))
        };
        Pose {
            centre: Vec2::new(along(|v| v.x), along(|v| v.y)),
            angle: cubic(a.pose.angle, b.pose.angle, a.twist.spin, b.twist.spin),
        }
    }
}

/// How far apart two poses of a shape are [m]; negative, or zero, where they overlap.
fn distance(shape: &Shape, a: Pose, b: Pose) -> f64 {
    let size = shape.size();
    let between = (b.centre - a.centre).norm();
    // Far apart their circles tell enough: it is no more than the distance.
    if between > 4.0 * size {
        return between - 2.0 * size;
    }
    let corners = |pose: Pose| {
        let turn = Vec2::at_angle(pose.angle);
        move |v: &Vec2| pose.centre + v.rotated(turn.x, turn.y)
    };
    let of_a: Vec<Vec2> = shape.vertices().iter().map(corners(a)).collect();
    let of_b: Vec<Vec2> = shape.vertices().iter().map(corners(b)).collect();
    let mut apart = f64::NEG_INFINITY;
    let mut take = |axis: Vec2| {
        let high = of_a.iter().map(|v| axis.dot(*v)).fold(f64::NEG_INFINITY, f64::max);
        let low = of_b.iter().map(|v| axis.dot(*v)).fold(f64::INFINITY, f64::min);
        apart = apart.max(low - high - 2.0 * shape.skin(0));
    };
    for (pose, sign) in [(a, 1.0), (b, -1.0)] {
        let turn = Vec2::at_angle(pose.angle);
        for face in 0..shape.faces() {
            take(shape.face_normal(face).rotated(turn.x, turn.y) * sign);
        }
    }
    for p in &of_a {
        for q in &of_b {
            take((*q - *p).unit().unwrap_or_default());
        }
    }
    apart
}
