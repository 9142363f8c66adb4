//! What decides a run, and what parts were doing where they met.

use crate::paper;

use carom_feeder::{Doing, Feed, FeedRun, Feeder, Run, Stop};
use carom_motion::planar::{Options, Surface};

fn feed(feeder: &Feeder, interval: f64) -> FeedRun {
    let between = Surface { friction: 0.2, restitution: 0.0 };
    feeder.prepare(Options::default()).unwrap().feed(&Feed { parts: 2, interval, between }).unwrap()
}

#[test]
fn the_deciding_strike_is_the_first_on_the_last_plate() {
    let feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    let run = feeder.run().unwrap();
    let strike = run.deciding_strike().unwrap();
    assert_eq!(strike.contacts[0].obstacle, 1, "on the lower plate");
    let nowhere = Run { landings: vec![], ..run.clone() };
    assert_eq!(nowhere.deciding_strike(), None, "nothing decides where nothing landed");
    // Without friction it would come down by less than the feeder's height, 0.3 m here, and turn no faster.
    let speed = run.struck_at().unwrap();
    assert!(speed > 0.0 && speed < 2.0 * (2.0 * feeder.gravity * 0.3f64).sqrt(), "{speed} m/s");
}

#[test]
fn parts_that_are_far_from_each_other_do_not_meet() {
    let feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    assert_eq!(feed(&feeder, 0.6).first_meeting(2), None);
}

#[test]
fn a_start_that_is_blocked_is_a_meeting() {
    let feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    let meeting = feed(&feeder, 0.3).first_meeting(2).unwrap();
    assert!(meeting.blocked && meeting.parts == [0, 1] && meeting.time == 0.3, "{meeting:?}");
    let [ahead, late] = meeting.doing;
    assert_eq!(late, Doing { stage: None, obstacle: 0 }, "it has not started");
    assert!(ahead.stage.is_some() && ahead.obstacle == 0, "{ahead:?} is still on the upper plate");
}

#[test]
fn a_part_that_lies_in_the_way_is_met_where_it_lies() {
    let mut feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    feeder.stop = Stop::Delivered;
    feeder.plates[1].friction = 0.6;
    let run = feed(&feeder, 1.2);
    let meeting = run.first_meeting(2).unwrap();
    assert!(!meeting.blocked && meeting.time == run.contacts[0].time, "{meeting:?}");
    assert_eq!((meeting.parts, meeting.doing[0].obstacle), ([0, 1], 1), "the first lies on the lower plate");
    // Whoever asks about one fixed obstacle only is not told of the other.
    assert_eq!(run.first_meeting(1).unwrap().doing[0].obstacle, 0);
}
