//! How closely parts may follow each other: found in two ways that must agree, and against rasters of single feeds.

#![allow(clippy::print_stdout, reason = "how far the two ways agree is a measurement")]

use crate::random;

use carom_feeder::{Feed, Feeder, Outcome, Part, PartKind, Plate, Prepared, StageName, Start, Stop};
use carom_impact::Law;
use carom_motion::planar::{Body, Options, Shape, Surface};
use carom_num::Vec2;
use carom_study::feeds::{Feeds, FeedsError, Kind, Plan, followed, longest_meeting, search};
use rayon::prelude::*;

pub(crate) const BETWEEN: Surface = Surface { friction: 0.2, restitution: 0.2 };

/// Uphill end and free edge of a plate.
fn ends(left: bool, degrees: f64, edge: Vec2, length: f64) -> (Vec2, Vec2) {
    let angle = degrees.to_radians();
    let downhill = Vec2::at_angle(if left { std::f64::consts::PI + angle } else { -angle });
    (edge - downhill * length, edge)
}

/// A box that slides down one plate and drops on another that leads back; parts follow each other closest on the lower one.
pub(crate) fn back_and_forth(lower: f64, friction: f64) -> Feeder {
    let plate = |name: &str, (uphill, edge): (Vec2, Vec2), friction: f64| Plate {
        name: name.into(),
        uphill,
        edge,
        friction,
        restitution: 0.1,
        unbounded: false,
        form: Default::default(),
    };
    Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Law::Poisson,
        part: Part::rectangle(0.06, 0.02, 0.1, 0.1 * (0.0036 + 0.0004) / 12.0).unwrap(),
        start: Start { to_edge: 0.12, speed: 0.5, face: 0 },
        plates: vec![
            plate("upper", ends(false, 30.0, Vec2::ZERO, 0.2), 0.3),
            plate("lower", ends(true, lower, Vec2::new(-0.18, -0.19), 0.44), friction),
        ],
        walls: vec![],
    }
}

fn searched(feeder: &Feeder, parts: usize, nodes: usize) -> Feeds {
    let plan = Plan { nodes, most: 2, ..Plan::default() };
    let feed = Feed { parts, interval: 1.0, between: BETWEEN };
    search(feeder, &feed, &plan, |_| None, || ()).unwrap()
}

/// Do so many parts at this interval [s] do without a touch, and does each start?
fn is_free(prepared: &Prepared<'_>, parts: usize, interval: f64) -> bool {
    let run = prepared.feed(&Feed { parts, interval, between: BETWEEN }).unwrap();
    run.contacts.is_empty() && run.parts.iter().all(|part| part.run.outcome != Outcome::Blocked)
}

#[test]
fn the_way_of_one_part_tells_where_feeds_begin_to_touch() {
    let (mut asked, mut given_up, mut widest) = (0, 0, 0.0_f64);
    for seed in 0..80 {
        let feeder = followed(&random::feeder(seed));
        let Ok(prepared) = feeder.prepare(Options::default()) else { continue };
        let one = prepared.feed(&Feed { parts: 1, interval: 1.0, between: BETWEEN }).unwrap();
        let alone = &one.parts[0].run;
        if !matches!(alone.outcome, Outcome::Delivered | Outcome::Escaped | Outcome::Missed) {
            continue;
        }
        let longest = longest_meeting(&feeder.part.body.shape, alone, 1e-7);
        given_up += u32::from(longest.high - longest.low > 1e-7);
        let at = |interval: f64| is_free(&prepared, 2, interval);
        // How near to the answer of the first way the second one changes.
        let off = [1e-7, 1e-6, 1e-5, 1e-4].into_iter().find(|d| !at(longest.low - d) && at(longest.high + d));
        let Some(off) = off else { panic!("{seed}: {longest:?}") };
        widest = widest.max(off);
        let above =
            (1..=12).map(|k| longest.high + off + (alone.end_time - longest.high) * f64::from(k) / 12.0);
        for interval in above {
            assert!(at(interval), "{seed}: parts touch at {interval}, above {longest:?}");
        }
        asked += 1;
    }
    println!("{asked} feeders, {given_up} searches given up, changes within {widest:e} s");
    assert!(asked > 30 && given_up <= asked / 20, "{asked} {given_up}");
}

#[test]
fn the_answer_is_that_of_single_feeds() {
    let feeder = back_and_forth(20.0, 0.3);
    let found = searched(&feeder, 3, 24);
    let smallest = found.smallest.as_ref().unwrap();
    println!("{} runs, {} stretches, {smallest:?}", found.runs, found.stretches.len());
    let longest = found.longest.unwrap();
    assert!(smallest.free - smallest.touching <= 1e-6, "{smallest:?}");
    assert!((smallest.free - longest.high).abs() < 2e-6, "{smallest:?} {longest:?}");
    let followed = followed(&feeder);
    let prepared = followed.prepare(Options::default()).unwrap();
    assert!(is_free(&prepared, 3, smallest.free) && !is_free(&prepared, 3, smallest.touching));
    // As the feeder is drawn, with its own stop, as well.
    assert!(is_free(&feeder.prepare(Options::default()).unwrap(), 3, smallest.free));
    let step = (found.alone.end_time - smallest.free) / 1999.0;
    let above = |k: u32| smallest.free + step * f64::from(k);
    let touches = (0..2000u32).into_par_iter().filter(|k| !is_free(&prepared, 3, above(*k))).count();
    assert_eq!(touches, 0, "above the answer");
    for piece in &found.stretches {
        for interval in [piece.first, piece.last] {
            assert_eq!(is_free(&prepared, 3, interval), piece.label.kind() == Kind::Free, "{interval}");
        }
    }
}

#[test]
fn more_parts_need_no_longer_interval() {
    let feeder = followed(&back_and_forth(25.0, 0.3));
    let found = searched(&feeder, 2, 16);
    let smallest = found.smallest.unwrap();
    let prepared = feeder.prepare(Options::default()).unwrap();
    for parts in [2, 3, 6, 12] {
        let both = [smallest.touching, smallest.free].map(|interval| is_free(&prepared, parts, interval));
        assert_eq!(both, [false, true], "{parts} parts, {smallest:?}");
    }
}

/// A disc that is thrown on a plate and bounces back through the way it came.
fn thrown_back() -> Feeder {
    let mut feeder = back_and_forth(28.0, 0.0);
    let shape = Shape::new(vec![Vec2::ZERO], 0.01).unwrap();
    feeder.part = Part { kind: PartKind::Disc, body: Body { shape, mass: 0.1, inertia: 5e-6 } };
    feeder.start.speed = 2.0;
    (feeder.plates[0].uphill, feeder.plates[0].edge) = ends(false, 1.0, Vec2::ZERO, 0.2);
    (feeder.plates[1].uphill, feeder.plates[1].edge) = ends(true, 28.0, Vec2::new(0.2, -0.735), 1.0);
    feeder.plates[0].friction = 0.0;
    feeder.plates[1].restitution = 0.8;
    feeder
}

#[test]
fn windows_without_touch_are_found_below_the_answer() {
    let feeder = followed(&thrown_back());
    let found = searched(&feeder, 2, 64);
    let smallest = found.smallest.as_ref().unwrap();
    let free = found.stretches.iter().filter(|piece| piece.label.kind() == Kind::Free);
    let window = free.filter(|piece| piece.last < smallest.touching).map(|piece| piece.last - piece.first);
    let widest = window.fold(0.0, f64::max);
    println!("{smallest:?}, a window of {widest} s, {} feeds", found.runs);
    // One falls, the other has struck the lower plate.
    let doing = smallest.meets.unwrap().doing.map(|doing| (doing.stage, doing.obstacle));
    assert_eq!(doing, [(Some(StageName::Flight), 1), (Some(StageName::Flight), 0)]);
    assert!(widest > 0.1, "{widest}");
    // The third does to the second what that does to the first, and to the first the same two intervals later.
    let prepared = feeder.prepare(Options::default()).unwrap();
    let mut free = 0;
    for k in 1..=200 {
        let interval = 1.1 * smallest.free * f64::from(k) / 200.0;
        let of_three = is_free(&prepared, 3, interval);
        assert_eq!(
            of_three,
            is_free(&prepared, 2, interval) && is_free(&prepared, 2, 2.0 * interval),
            "{interval}"
        );
        free += u32::from(of_three && interval < smallest.touching);
    }
    assert!(free > 0, "none of the raster lies in a window");
}

#[test]
fn parts_that_stay_pile_up() {
    // On the lower plate friction is above the slope: a part lies down and slides to a stop.
    let feeder = back_and_forth(14.0, 0.4);
    let found = searched(&feeder, 2, 16);
    assert!(found.piles_up() && found.smallest.is_none() && found.longest.is_none());
    assert_eq!(found.alone.outcome, Outcome::Stuck);
    let last = found.stretches.last().unwrap();
    assert!(last.last > 1.2 * found.alone.end_time && last.label.meets.is_some(), "{last:?}");
    // Whatever the feeder stops at.
    let prepared = feeder.prepare(Options::default()).unwrap();
    assert_eq!(feeder.stop, Stop::Landed);
    assert!(!is_free(&prepared, 3, 2.0 * found.alone.end_time));
}

#[test]
fn what_cannot_be_searched_is_said() {
    let feeder = back_and_forth(20.0, 0.3);
    let feed = Feed { parts: 3, interval: 1.0, between: BETWEEN };
    let refused =
        |feeder: &Feeder, feed: Feed, plan: Plan| search(feeder, &feed, &plan, |_| None, || ()).unwrap_err();
    let fine = Plan::default();
    assert_eq!(refused(&feeder, Feed { parts: 1, ..feed }, fine), FeedsError::Parts { parts: 1 });
    assert_eq!(refused(&feeder, feed, Plan { nodes: 15, ..fine }), FeedsError::Nodes { nodes: 15 });
    let accuracy = refused(&feeder, feed, Plan { accuracy: 0.0, ..fine });
    assert_eq!(accuracy.to_string(), "the accuracy 0 s is outside 1e-9 s to 0.1 s");
    let between = Surface { friction: -1.0, restitution: 2.0 };
    let found = refused(&feeder, Feed { between, ..feed }, fine).to_string();
    assert!(found.contains("feed.friction = -1") && found.contains("feed.restitution = 2"), "{found}");
    // A part that lies where it starts blocks the next one for ever.
    let mut held = feeder.clone();
    held.plates[0].friction = 0.9;
    held.start.speed = 0.0;
    let found = searched(&held, 2, 16);
    assert!(found.piles_up());
    assert!(found.stretches.iter().all(|piece| piece.label.kind() == Kind::Blocked));
}
