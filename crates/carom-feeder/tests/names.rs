//! What a run is called: outcomes, stages, the line of the verdict, the names of a part's features, and what parts were doing where they met.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod paper;

use carom_feeder::{
    Doing, Feed, FeedRun, Feeder, Headline, Outcome, Part, PartKind, StageName, Stop, Verdict,
};
use carom_motion::planar::{Body, Feature, Options, Shape, Surface};
use carom_num::Vec2;
use std::collections::BTreeSet;

fn feed(feeder: &Feeder, interval: f64) -> FeedRun {
    let between = Surface { friction: 0.2, restitution: 0.0 };
    feeder.prepare(Options::default()).unwrap().feed(&Feed { parts: 2, interval, between }).unwrap()
}

#[test]
fn every_outcome_and_stage_has_a_word_of_its_own() {
    let stages = [
        StageName::Slide,
        StageName::Tip,
        StageName::Flight,
        StageName::Swing,
        StageName::Stick,
        StageName::Roll,
        StageName::Wedge,
        StageName::Push,
        StageName::Rest,
        StageName::Clatter,
    ];
    let plain = |word: &str| word.chars().all(|c| c.is_ascii_lowercase() || c == '_');
    let words: BTreeSet<&str> = Outcome::ALL.iter().map(|outcome| outcome.word()).collect();
    assert!(words.len() == Outcome::ALL.len() && words.iter().all(|word| plain(word)), "{words:?}");
    let words: BTreeSet<&str> = stages.iter().map(|stage| stage.word()).collect();
    assert!(words.len() == stages.len() && words.iter().all(|word| plain(word)), "{words:?}");
    assert_eq!(Verdict::Face(2).words(), "face 2");
}

#[test]
fn the_headline_names_the_plate_or_says_what_went_wrong() {
    let feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    let mut run = feeder.run().unwrap();
    let side = run.landings.last().unwrap().verdict.unwrap().words();
    let plate = Some("lower".to_owned());
    let landed = Headline { word: side.clone(), plate: plate.clone(), because: "" };
    assert_eq!(feeder.headline(&run), landed, "it came to the lower plate");
    let mut seen = BTreeSet::new();
    for outcome in Outcome::ALL {
        run.outcome = outcome;
        let headline = feeder.headline(&run);
        let arrives = matches!(outcome, Outcome::Landed | Outcome::Delivered);
        assert_eq!(headline.because.is_empty(), arrives, "{headline:?} says why where it failed");
        let lies = arrives || matches!(outcome, Outcome::Stuck | Outcome::OnEnd);
        assert_eq!(headline.plate.is_some(), lies, "{headline:?} names the plate it lies on");
        assert!(seen.insert(headline.word.clone()), "{headline:?}: two outcomes of one name");
    }
    run.outcome = Outcome::Delivered;
    assert_eq!(feeder.headline(&run).word, format!("delivered, {side}"), "with the side");
    run.landings.clear();
    assert_eq!(feeder.headline(&run).word, "delivered", "without one");
    assert_eq!(run.deciding_strike(), None, "nothing decides where nothing landed");
}

#[test]
fn the_deciding_strike_is_the_first_on_the_last_plate() {
    let feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    let run = feeder.run().unwrap();
    let strike = run.deciding_strike().unwrap();
    assert_eq!(strike.contacts[0].obstacle, 1, "on the lower plate");
    // Without friction it would come down by less than the feeder's height, 0.3 m here, and turn no faster.
    let speed = run.struck_at().unwrap();
    assert!(speed > 0.0 && speed < 2.0 * (2.0 * feeder.gravity * 0.3f64).sqrt(), "{speed} m/s");
}

#[test]
fn features_are_named_as_the_part_lay_at_the_start() {
    let corner = |vertex| Feature::VertexOnFace { vertex, face: 0 };
    let names = |feeder: &Feeder, corners: usize| -> BTreeSet<String> {
        (0..corners).map(|vertex| feeder.feature_name(corner(vertex))).collect()
    };
    let set = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<BTreeSet<String>>();
    let mut feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    assert_eq!(names(&feeder, 4), set(&["front", "front top", "rear", "rear top"]), "a box");
    let end = Feature::VertexOnEnd { vertex: 0, end: 1 };
    assert_eq!(feeder.feature_name(end), feeder.feature_name(corner(0)), "a corner, whatever it touches");
    assert_eq!(feeder.feature_name(Feature::FaceOnEnd { face: 2, end: 1 }), "face 2");
    assert_eq!(names(&paper::feeder(15.0, (0.347, 0.2), 0.0), 2), set(&["front", "rear"]), "a rod");
    feeder.part.kind = PartKind::Polygon;
    assert_eq!(names(&feeder, 2), set(&["corner 0", "corner 1"]), "a polygon");
    feeder.part.kind = PartKind::Box;
    assert_eq!(feeder.feature_name(corner(7)), "corner 7", "one that is not there");
    let shape = Shape::new(vec![Vec2::ZERO], 0.05).unwrap();
    feeder.part = Part { kind: PartKind::Disc, body: Body { shape, mass: 1.0, inertia: 1e-3 } };
    assert_eq!(feeder.feature_name(corner(0)), "rim", "a disc");
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
