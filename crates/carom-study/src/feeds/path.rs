//! The longest interval at which identical parts can touch, from the way of one of them alone.
//!
//! Until parts touch, each does what the one before did, an interval later. So they touch at the interval T where the part, somewhere on
//! its way, overlaps itself a time T later. The largest such T is found by branch and bound over the time s and the interval T: a box is given
//! up where the distance of the poses at s and at s + T, at its middle, is more than either can change within it.

use crate::tolerance::POSES_TOUCH;
use carom_feeder::Run;
use carom_motion::planar::Shape;
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
    let pieces = run.trace.pieces.iter().map(|piece| {
        let inner = piece.samples.iter().map(|sample| (sample.time, sample.state));
        std::iter::once((piece.start_time, piece.start)).chain(inner).chain([(piece.end_time, piece.end)])
    });
    let nowhere = Longest { low: 0.0, high: 0.0, boxes: 0 };
    Way::of(shape, pieces, true).map_or(nowhere, |way| way.search(accuracy))
}

/// A part of which it is known how it stands between two samples of its motion, and how far it is from where it is at another time.
pub(super) trait Passes {
    /// A sample.
    type State: Copy;
    /// How it stands.
    type Pose;

    /// No place of it is farther from its centre [m].
    fn size(&self) -> f64;

    /// How it stands at a fraction of the time between two samples.
    fn pose(&self, leg: &Leg<Self::State>, fraction: f64) -> Self::Pose;

    /// No place of it is faster between two samples that are so long apart [m/s].
    fn speed(&self, ends: &[Self::State; 2], lasts: f64) -> f64;

    /// How far apart two of it are at least [m]; negative, or zero, where they overlap, and only there.
    fn distance(&self, a: &Self::Pose, b: &Self::Pose) -> f64;
}

/// A cubic between two samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg<S> {
    from: f64,
    to: f64,
    pub(super) ends: [S; 2],
    /// No point of the part is faster [m/s].
    speed: f64,
}

impl<S> Leg<S> {
    /// How long it lasts [s].
    pub(super) fn lasts(&self) -> f64 {
        self.to - self.from
    }
}

/// What a part does from its start to its end.
pub(super) struct Way<'s, P: Passes> {
    part: &'s P,
    /// One at least.
    legs: Vec<Leg<P::State>>,
    /// At its end the part is gone; else it rests there.
    gone: bool,
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

impl<'s, P: Passes> Way<'s, P> {
    /// The way through these samples, of which some may be at one time; `None` where all are.
    pub(super) fn of<I: Iterator<Item = (f64, P::State)>>(
        part: &'s P,
        pieces: impl Iterator<Item = I>,
        gone: bool,
    ) -> Option<Self> {
        let mut legs: Vec<Leg<P::State>> = vec![];
        for piece in pieces {
            let mut known = None;
            for next in piece {
                if let Some((from, a)) = known
                    && next.0 > from
                {
                    let (to, ends) = (next.0, [a, next.1]);
                    legs.push(Leg { from, to, ends, speed: part.speed(&ends, to - from) });
                }
                known = Some(next);
            }
        }
        (!legs.is_empty()).then_some(Self { part, legs, gone })
    }

    fn end(&self) -> f64 {
        self.legs.last().map_or(0.0, |leg| leg.to)
    }

    fn leg_at(&self, time: f64) -> usize {
        self.legs.partition_point(|leg| leg.to < time).min(self.legs.len() - 1)
    }

    /// How the part stands; from its end on as it did then.
    pub(super) fn pose(&self, time: f64) -> P::Pose {
        let leg = &self.legs[self.leg_at(time)];
        self.part.pose(leg, ((time - leg.from) / leg.lasts()).clamp(0.0, 1.0))
    }

    /// No point of the part is faster between these times [m/s].
    fn speed(&self, from: f64, to: f64) -> f64 {
        if from >= self.end() {
            return 0.0;
        }
        let legs = self.legs[self.leg_at(from)..].iter().take_while(|leg| leg.from <= to);
        legs.map(|leg| leg.speed).fold(0.0, f64::max)
    }

    pub(super) fn search(&self, accuracy: f64) -> Longest {
        let end = self.end();
        let mut found = Longest { low: 0.0, high: end, boxes: 0 };
        let mut open = BinaryHeap::from([Box2 { time: [0.0, end], interval: [0.0, end] }]);
        let touch = POSES_TOUCH * self.part.size();
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
            let distance = self.part.distance(&first, &second);
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

    /// When after its start a part first touches the one that is this interval ahead of it [s]; `None` where it passes without.
    pub(super) fn first_touch(&self, interval: f64) -> Option<f64> {
        let (end, touch) = (self.end(), POSES_TOUCH * self.part.size());
        let until = if self.gone { end - interval } else { end };
        let mut open = vec![[0.0, until]];
        while let Some([low, high]) = open.pop().filter(|[low, high]| high >= low) {
            let (time, half) = (0.5 * (low + high), 0.5 * (high - low));
            let distance = self.part.distance(&self.pose(time), &self.pose(time + interval));
            let by = half * (self.speed(low, high) + self.speed(low + interval, high + interval));
            if distance > by + touch {
                continue;
            }
            if by <= touch || half <= f64::EPSILON * time {
                return Some(low);
            }
            open.extend([[time, high], [low, time]]);
        }
        None
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
