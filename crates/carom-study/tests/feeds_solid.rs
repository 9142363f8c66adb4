//! How closely solid parts may follow each other: against closed forms, and against parts in the plane.

#![allow(clippy::print_stdout, reason = "how far two ways agree is a measurement")]

use crate::extruded::in_space;
use crate::feeds::{BETWEEN, back_and_forth};

use carom_feeder::spatial::{self, examples};
use carom_feeder::{Feed, Feeder};
use carom_num::elementary::{cos, sin};
use carom_num::{Vec2, Vec3};
use carom_study::feeds::{Feeds, FeedsError, Kind, Meets, Plan, search, search_solid};

fn searched(feeder: &spatial::Feeder, nodes: usize, accuracy: f64) -> Feeds<spatial::Run> {
    let plan = Plan { nodes, accuracy, most: 2 };
    search_solid(feeder, &plan, |_| None, || ()).unwrap()
}

/// A bar of 40 mm × 20 mm that slides askew down a plate, from rest, and over its end.
fn askew(turn: f64) -> spatial::Feeder {
    let mut feeder = examples::two_plates();
    feeder.plates.truncate(1);
    feeder.start.turn = turn;
    feeder
}

/// Two equal rectangles side by side are clear of each other once they are their length apart along it, or their width across.
#[test]
fn bars_that_start_askew_may_follow_once_the_first_is_clear() {
    for turn in [0.0, 0.2, 0.45, 0.8, 1.2, 1.5] {
        let feeder = askew(turn);
        let down = (feeder.plates[0].edge - feeder.plates[0].uphill).unit().unwrap();
        let acceleration = 9.81 * (-down.y - 0.15 * down.x);
        let clear = if turn == 0.0 { 0.04 } else { (0.04 / cos(turn)).min(0.02 / sin(turn)) };
        let expected = (2.0 * clear / acceleration).sqrt();
        let found = searched(&feeder, 64, 1e-9);
        let smallest = found.smallest.unwrap();
        let off = (smallest.free - expected).abs();
        println!("turn {turn}: {expected} s, within {off:.1e} s");
        assert!(
            off < 2e-9 && smallest.free - smallest.touching < 1e-9,
            "{turn}: {smallest:?}, not {expected}"
        );
        let longest = found.longest.unwrap();
        assert!((longest.high - expected).abs() < 2e-9, "{turn}: {longest:?}");
        assert_eq!((smallest.below, found.rests_on), (Kind::Blocked, None));
        assert!(smallest.meets.unwrap().blocked && found.stretches.len() == 2, "{:?}", found.stretches);
    }
}

/// The same feeder, where the box has a third extent.
fn with_depth(feeder: &Feeder) -> spatial::Feeder {
    in_space(feeder, examples::block(Vec3::new(0.06, 0.02, 0.05), 0.1))
}

#[test]
fn a_box_may_follow_in_space_as_it_may_in_the_plane() {
    let mut widest = 0.0_f64;
    for (lower, friction) in [(14.0, 0.2), (20.0, 0.2), (24.0, 0.3), (28.0, 0.35), (30.0, 0.4)] {
        let feeder = back_and_forth(lower, friction);
        let plan = Plan { nodes: 64, accuracy: 1e-7, most: 1 };
        let feed = Feed { parts: 2, interval: 1.0, between: BETWEEN };
        let plane = search(&feeder, &feed, &plan, |_| None, || ()).unwrap();
        let space = searched(&with_depth(&feeder), 64, 1e-7);
        let (own, other) = (space.smallest.unwrap(), plane.smallest.unwrap());
        let off = (own.free - other.free).abs();
        println!("lower plate {lower}°: {} s, within {off:.1e} s", own.free);
        widest = widest.max(off);
        // Who is ahead, and on which plate each was. A bounce that is over in the plane may clatter on in space.
        let of = |meets: Meets| (meets.parts, meets.doing.map(|doing| doing.obstacle), meets.blocked);
        assert_eq!(own.meets.map(of), other.meets.map(of), "{lower}");
        assert_eq!(space.ending, plane.ending, "{lower}");
    }
    assert!(widest < 1e-7, "{widest}");
}

/// One that comes to rest is in the way of all that follow.
#[test]
fn parts_pile_up_behind_one_that_rests() {
    let mut feeder = with_depth(&back_and_forth(20.0, 0.2));
    feeder.plates[1].friction = 1.0;
    let found = searched(&feeder, 16, 1e-6);
    assert_eq!((found.rests_on, found.smallest.clone()), (Some(1), None));
    assert!(found.piles_up() && found.stretches.iter().all(|piece| !piece.label.is_free()));
}

#[test]
fn what_cannot_be_searched_is_said() {
    let plan = |nodes| Plan { nodes, ..Plan::default() };
    let refused =
        |feeder: &spatial::Feeder, nodes| search_solid(feeder, &plan(nodes), |_| None, || ()).unwrap_err();
    assert_eq!(refused(&askew(0.0), 3), FeedsError::Nodes { nodes: 3 });
    let mut through = askew(0.0);
    through.plates.push(spatial::Plate {
        uphill: Vec2::new(-0.2, -0.2),
        edge: Vec2::new(0.0, 0.2),
        ..through.plates[0].clone()
    });
    assert!(matches!(refused(&through, 16), FeedsError::Problems(_)));
}
