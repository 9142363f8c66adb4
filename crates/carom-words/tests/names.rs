//! What a run is called: the line of the verdict, the names of a part's features, plates and walls; words that no two values of an enum share.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../../carom-feeder/tests/paper/mod.rs"]
mod paper;

use carom_feeder::{Feeder, Outcome, Part, PartKind, StageName, Verdict, Wall};
use carom_impact::{planar, spatial};
use carom_motion::planar::{Body, Feature, Shape};
use carom_num::Vec2;
use carom_study::feeds::Kind;
use carom_words::{
    Words,
    part::{feature, obstacle},
    roll_space,
    run::{Headline, headline, side},
};
use std::collections::BTreeSet;

fn differ<T: Words>() {
    let words: BTreeSet<&str> = T::words().into_iter().collect();
    assert_eq!(words.len(), T::ALL.len(), "two values have one word: {words:?}");
}

#[test]
fn no_two_values_of_an_enum_have_one_word() {
    differ::<carom_impact::Law>();
    differ::<carom_impact::Phase>();
    differ::<planar::Slip>();
    differ::<planar::ContactState>();
    differ::<planar::ImpactType>();
    differ::<planar::Class>();
    differ::<spatial::Mode>();
    differ::<spatial::Freedom>();
    differ::<spatial::Conclusion>();
    differ::<roll_space::StageName>();
    differ::<roll_space::PointState>();
    differ::<roll_space::EndName>();
}

#[test]
fn every_outcome_and_stage_has_a_plain_word_of_its_own() {
    differ::<Outcome>();
    differ::<StageName>();
    differ::<Kind>();
    assert!(Kind::ALL.is_sorted(), "from what is best to what is not known");
    let ends = (Kind::ALL.first(), Kind::ALL.last());
    assert_eq!(ends, (Some(&Kind::Free), Some(&Kind::Unresolved)), "the first and the last");
    let plain = |word: &&str| word.chars().all(|c| c.is_ascii_lowercase() || c == '_');
    assert!(Outcome::words().iter().all(plain), "{:?}", Outcome::words());
    assert!(StageName::words().iter().all(plain), "{:?}", StageName::words());
    assert_eq!(side(Verdict::Face(2)), "face 2");
}

#[test]
fn the_headline_names_the_plate_or_says_what_went_wrong() {
    let feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    let mut run = feeder.run().unwrap();
    let side = run.landings.last().unwrap().verdict.map(side).unwrap();
    let plate = Some("lower".to_owned());
    let landed = Headline { word: side.clone(), plate: plate.clone(), because: String::new() };
    assert_eq!(headline(&feeder, &run), landed, "it came to the lower plate");
    let mut seen = BTreeSet::new();
    for outcome in Outcome::ALL.iter().copied() {
        run.outcome = outcome;
        let said = headline(&feeder, &run);
        let arrives = matches!(outcome, Outcome::Landed | Outcome::Delivered);
        assert_eq!(said.because.is_empty(), arrives, "{said:?} says why where it failed");
        let lies = arrives || matches!(outcome, Outcome::Stuck | Outcome::OnEnd);
        assert_eq!(said.plate.is_some(), lies, "{said:?} names the plate it lies on");
        assert!(seen.insert(said.word.clone()), "{said:?}: two outcomes of one name");
    }
    run.outcome = Outcome::Delivered;
    assert_eq!(headline(&feeder, &run).word, format!("delivered, {side}"), "with the side");
    run.landings.clear();
    assert_eq!(headline(&feeder, &run).word, "delivered", "without one");
}

#[test]
fn features_are_named_as_the_part_lay_at_the_start() {
    let corner = |vertex| Feature::VertexOnFace { vertex, face: 0 };
    let names = |feeder: &Feeder, corners: usize| -> BTreeSet<String> {
        (0..corners).map(|vertex| feature(feeder, corner(vertex))).collect()
    };
    let set = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<BTreeSet<String>>();
    let mut feeder = paper::feeder(15.0, (0.347, 0.2), 0.01);
    assert_eq!(names(&feeder, 4), set(&["front", "front top", "rear", "rear top"]), "a box");
    let end = Feature::VertexOnEnd { vertex: 0, end: 1 };
    assert_eq!(feature(&feeder, end), feature(&feeder, corner(0)), "a corner, whatever it touches");
    assert_eq!(feature(&feeder, Feature::FaceOnEnd { face: 2, end: 1 }), "face 2");
    assert_eq!(names(&paper::feeder(15.0, (0.347, 0.2), 0.0), 2), set(&["front", "rear"]), "a rod");
    feeder.part.kind = PartKind::Polygon;
    assert_eq!(names(&feeder, 2), set(&["corner 0", "corner 1"]), "a polygon");
    feeder.part.kind = PartKind::Box;
    assert_eq!(feature(&feeder, corner(7)), "corner 7", "one that is not there");
    let shape = Shape::new(vec![Vec2::ZERO], 0.05).unwrap();
    feeder.part = Part { kind: PartKind::Disc, body: Body { shape, mass: 1.0, inertia: 1e-3 } };
    assert_eq!(feature(&feeder, corner(0)), "rim", "a disc");
}

#[test]
fn what_has_no_name_is_counted_from_one() {
    let mut feeder = paper::feeder(15.0, (0.347, 0.2), 0.0);
    feeder.plates[0].name = "0".to_owned();
    feeder.plates.push(feeder.plates[0].clone());
    feeder.plates[2].name = "2".to_owned();
    let (from, to) = (Vec2::ZERO, Vec2::new(1.0, 0.0));
    let wall = |name: &str| Wall {
        name: name.to_owned(),
        from,
        to,
        friction: 0.2,
        restitution: 0.0,
        form: Default::default(),
    };
    feeder.walls = vec![wall("left"), wall("1")];
    let labels: Vec<String> = (0..6).map(|o| obstacle(&feeder, o)).collect();
    assert_eq!(labels, ["plate 1", "lower", "plate 3", "left", "wall 2", "another part"]);
    assert_eq!(feeder.obstacle_name(2), "2", "in paths and files the number is the index");
}
