//! Several parts on one feeder.

#![allow(clippy::print_stdout, reason = "what random feeds come to is a measurement")]

use crate::paper;
use crate::random;

use carom_feeder::{FedPart, Feed, FeedRun, Feeder, Outcome, RunError, Stop};
use carom_motion::planar::trace::Piece;
use carom_motion::planar::{Options, Shape, State, Surface};
use carom_num::Vec2;
use rayon::prelude::*;
use std::collections::BTreeMap;

fn feed(feeder: &Feeder, parts: usize, interval: f64, restitution: f64) -> FeedRun {
    let between = Surface { friction: 0.2, restitution };
    feeder.prepare(Options::default()).unwrap().feed(&Feed { parts, interval, between }).unwrap()
}

#[test]
fn parts_that_do_not_meet_do_what_one_does() {
    for thickness in [0.0, 0.01] {
        let feeder = paper::feeder(15.0, (0.347, 0.2), thickness);
        let alone = feeder.run().unwrap();
        let run = feed(&feeder, 3, 0.6, 0.0);
        assert!(run.contacts.is_empty());
        for part in &run.parts {
            assert_eq!(part.run.outcome, alone.outcome);
            for (own, of_alone) in part.run.landings.iter().zip(&alone.landings) {
                assert_eq!((own.plate, own.verdict), (of_alone.plate, of_alone.verdict));
                let late = own.flat.unwrap() - part.entered - of_alone.flat.unwrap();
                assert!(late.abs() < 1e-11, "{late:e}");
            }
        }
        // The first one's clock is that of a part alone: not a bit differs.
        let shown: Vec<&Piece> =
            run.parts[0].run.trace.pieces.iter().take(alone.trace.pieces.len()).collect();
        assert_eq!(shown, alone.trace.pieces.iter().collect::<Vec<_>>());
    }
}

#[test]
fn a_part_that_finds_its_place_taken_does_not_start() {
    let feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    let run = feed(&feeder, 3, 0.3, 0.0);
    let outcomes: Vec<Outcome> = run.parts.iter().map(|p| p.run.outcome).collect();
    assert_eq!(outcomes, [Outcome::Landed, Outcome::Blocked, Outcome::Landed]);
    assert!(run.parts[1].run.trace.pieces.is_empty());
}

#[test]
fn a_part_that_is_stuck_is_pushed_on_by_the_next() {
    // On the second plate friction is just above the slope: a part alone stays where it lies down.
    let mut feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    feeder.stop = Stop::Delivered;
    feeder.plates[1].friction = 0.6;
    let alone = feeder.run().unwrap();
    assert_eq!(alone.outcome, Outcome::Stuck);
    let run = feed(&feeder, 2, 1.2, 0.0);
    let [contact] = run.contacts.as_slice() else { panic!("{:?}", run.contacts) };
    assert_eq!(contact.parts, [0, 1]);
    let [first, second] = [0, 1].map(|i: usize| &run.parts[i].run);
    assert!(first.trace.pieces.last().unwrap().end.pose != alone.trace.pieces.last().unwrap().end.pose);
    assert_eq!((first.outcome, second.outcome), (Outcome::Stuck, Outcome::Stuck));
    // What one does to the other, the other does to it.
    let struck = |run: &carom_feeder::Run, time: f64| {
        let impact = run.trace.impacts.iter().find(|i| i.time == time).unwrap();
        let contact = impact.contacts.iter().find(|c| c.obstacle >= feeder.plates.len()).unwrap();
        contact.normal * contact.normal_impulse + contact.normal.turned_right() * contact.tangential_impulse
    };
    let [a, b] = [struck(first, contact.time), struck(second, contact.time)];
    assert!(a.norm() > 0.0 && (a + b).norm() < 1e-15, "{a:?} {b:?}");
}

/// The corners of a part [m].
fn corners(shape: &Shape, state: &State) -> Vec<Vec2> {
    let turn = Vec2::at_angle(state.pose.angle);
    shape.vertices().iter().map(|v| state.pose.centre + v.rotated(turn.x, turn.y)).collect()
}

/// How deep two parts overlap, in part sizes; negative where they are apart.
fn depth(shape: &Shape, a: &State, b: &State) -> f64 {
    let (of_a, of_b) = (corners(shape, a), corners(shape, b));
    let mut apart = f64::NEG_INFINITY;
    let mut take = |axis: Vec2| {
        let high = of_a.iter().map(|v| axis.dot(*v)).fold(f64::NEG_INFINITY, f64::max);
        let low = of_b.iter().map(|v| axis.dot(*v)).fold(f64::INFINITY, f64::min);
        apart = f64::max(apart, low - high - 2.0 * shape.radius());
    };
    for (state, sign) in [(a, 1.0), (b, -1.0)] {
        let turn = Vec2::at_angle(state.pose.angle);
        for face in 0..shape.faces() {
            take(shape.face_normal(face).rotated(turn.x, turn.y) * sign);
        }
    }
    for p in &of_a {
        for q in &of_b {
            take((*q - *p).unit().unwrap_or_default());
        }
    }
    -apart / shape.size()
}

/// The deepest overlap of two parts where pieces of both begin, and at every instant of their pieces at which both were noted.
fn overlap(shape: &Shape, a: &FedPart, b: &FedPart) -> f64 {
    let mut deepest = f64::NEG_INFINITY;
    for p in &a.run.trace.pieces {
        for q in b.run.trace.pieces.iter().filter(|q| q.start_time == p.start_time) {
            deepest = deepest.max(depth(shape, &p.start, &q.start));
            for (s, r) in p.samples.iter().zip(&q.samples).filter(|(s, r)| s.time == r.time) {
                deepest = deepest.max(depth(shape, &s.state, &r.state));
            }
        }
    }
    deepest
}

/// What random feeds come to.
#[derive(Debug, Default)]
struct Sum {
    outcomes: BTreeMap<Outcome, u32>,
    /// Feeds in which parts touch.
    touched: u32,
    /// Feeds that hold more together than is walked.
    broken_off: u32,
    /// Deepest overlap of two parts, in part sizes.
    deepest: f64,
}

impl Sum {
    fn and(mut self, other: Self) -> Self {
        for (outcome, count) in other.outcomes {
            *self.outcomes.entry(outcome).or_insert(0) += count;
        }
        Self {
            touched: self.touched + other.touched,
            broken_off: self.broken_off + other.broken_off,
            deepest: self.deepest.max(other.deepest),
            ..self
        }
    }
}

fn random_feeds(seeds: u32, parts: usize) -> Sum {
    let fed = |seed: u32| {
        let mut sum = Sum::default();
        let feeder = random::feeder(u64::from(seed));
        let Ok(prepared) = feeder.prepare(Options::default()) else { return sum };
        let share = (f64::from(seed) * 0.618_034).fract();
        let between = Surface { friction: 0.2, restitution: (7.0 * share).fract() };
        let run = prepared.feed(&Feed { parts, interval: 0.3 + 0.9 * share, between }).unwrap();
        sum.touched += u32::from(!run.contacts.is_empty());
        sum.broken_off += u32::from(run.broken_off.is_some());
        for (i, part) in run.parts.iter().enumerate() {
            *sum.outcomes.entry(part.run.outcome).or_insert(0) += 1;
            let others = run.parts[..i].iter();
            let shape = &feeder.part.body.shape;
            sum.deepest = others.map(|o| overlap(shape, o, part)).fold(sum.deepest, f64::max);
        }
        sum
    };
    (0..seeds).into_par_iter().map(fed).reduce(Sum::default, Sum::and)
}

#[test]
fn two_parts_of_random_feeds_stay_apart() {
    let sum = random_feeds(400, 2);
    assert!(sum.touched > 100 && sum.broken_off == 0 && sum.deepest < 1e-9, "{sum:?}");
    assert_eq!(sum.outcomes.get(&Outcome::NeverFlat), None, "{sum:?}");
}

#[test]
fn three_parts_of_random_feeds_stay_apart() {
    let sum = random_feeds(150, 3);
    assert!(sum.touched > 30 && sum.broken_off == 0 && sum.deepest < 1e-7, "{sum:?}");
    assert_eq!(sum.outcomes.get(&Outcome::NeverFlat), None, "{sum:?}");
}

#[test]
fn a_queue_that_does_not_clear_itself_is_told_to_its_end() {
    // The last plate holds what lies on it: each part strikes the queue before it.
    let mut feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    feeder.stop = Stop::Delivered;
    feeder.plates[1].friction = 0.9;
    for parts in 2..=6 {
        let run = feed(&feeder, parts, 1.2, 0.2);
        assert_eq!(run.parts.len(), parts);
        assert_eq!(run.broken_off, None);
        assert!(run.parts.iter().all(|p| p.run.outcome == Outcome::Stuck), "{parts} parts");
        let shape = &feeder.part.body.shape;
        for (i, part) in run.parts.iter().enumerate() {
            assert!(run.parts[..i].iter().all(|o| overlap(shape, o, part) < 1e-6), "part {i} of {parts}");
        }
    }
}

#[test]
fn what_is_wrong_with_a_feed_is_said_at_once() {
    let feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    let between = Surface { friction: -1.0, restitution: 2.0 };
    let feed = Feed { parts: 101, interval: 3601.0, between };
    let Err(RunError::Problems(found)) = feeder.prepare(Options::default()).unwrap().feed(&feed) else {
        panic!("such a feed runs")
    };
    let said: Vec<String> = found.iter().map(ToString::to_string).collect();
    let expected = [
        "feed.parts = 101: 1 to 100",
        "feed.interval = 3601: above 0 s, at most 3600 s",
        "feed.friction = -1: 0 or more",
        "feed.restitution = 2: 0 to 1",
    ];
    assert_eq!(said, expected);
}
