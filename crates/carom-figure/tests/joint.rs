//! The picture of an impact at several contacts.

use carom_figure::{JointContact, JointWalk, joint_svg};
use carom_impact::Law;
use carom_impact::planar::staged::{self, resolve_observed};
use carom_impact::planar::{ContactSet2, Touch};
use carom_num::Vec2;

/// A body on two inclined supports, whose slips stop by turns.
fn struck() -> Vec<staged::Stage<2>> {
    let touch = |x: f64, y: f64, n: f64, friction: f64| Touch {
        arm: Vec2::new(x, y),
        normal: Vec2::new(n, 1.0).unit().unwrap(),
        friction,
        restitution: 0.4,
    };
    let touches = [touch(-0.04, -0.03, 0.5, 0.6), touch(0.05, -0.02, -0.6, 0.5)];
    let set = ContactSet2::of_free_body(1.0, 2e-3, Vec2::new(0.7, -1.0), 9.0, &touches).unwrap();
    let mut stages = vec![];
    resolve_observed(&set, Law::Poisson, &mut |stage| stages.push(*stage)).unwrap();
    stages
}

fn contacts() -> Vec<JointContact> {
    let contact = |name: &str, friction| JointContact { name: name.to_owned(), friction };
    vec![contact("<left>", 0.6), contact("right", 0.5)]
}

/// The numbers of an attribute of every element of a class, in order.
fn numbers(svg: &str, class: &str, attribute: &str) -> Vec<f64> {
    let elements = svg.split_inclusive('>').filter(|line| line.contains(&format!("class=\"{class}\"")));
    let number = |line: &str| {
        let rest = line.split(&format!(" {attribute}=\"")).nth(1)?;
        rest.split('"').next()?.parse().ok()
    };
    elements.filter_map(number).collect()
}

#[test]
fn every_panel_has_the_stages_on_one_scale() {
    let stages = struck();
    assert!(stages.len() >= 3, "{} stages", stages.len());
    let svg = joint_svg(&JointWalk::of_stages(contacts(), &stages));
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "one element");
    assert!(svg.contains("&lt;left&gt;") && !svg.contains("NaN"), "names are escaped");
    for (i, class) in ["k0", "k1"].into_iter().enumerate() {
        let start = numbers(&svg, &format!("start {class}"), "cx")[0];
        let dots = numbers(&svg, class, "cx");
        // As many pixels for a newton second in both panels.
        let walked: Vec<f64> = stages.iter().map(|stage| stage.end.impulse[i][1]).collect();
        let shown = dots.iter().map(|x| x - start).fold(0.0, f64::max);
        let largest = (0..2).map(|k| stages.last().unwrap().end.impulse[k][1]).fold(0.0, f64::max);
        let panel = (760.0 - 66.0 - 16.0 - 18.0) / 2.0;
        let expected = walked.last().unwrap() / (1.12 * largest) * panel;
        let last = dots.iter().any(|x| (x - start - expected).abs() < 0.02);
        assert!(last, "contact {i}: {expected} px, shown {dots:?} from {start}, {shown}");
    }
}

#[test]
fn stage_boundaries_stand_over_the_clock() {
    let stages = struck();
    let svg = joint_svg(&JointWalk::of_stages(contacts(), &stages));
    let clock: Vec<f64> =
        stages.iter().map(|stage| stage.end.impulse.iter().map(|p| p[1]).sum::<f64>()).collect();
    let (left, right) = (66.0, 760.0 - 84.0);
    let lines = numbers(&svg, "event", "x1");
    for line in &lines {
        let at = (line - left) / (right - left) * clock.last().unwrap();
        let nearest = clock.iter().map(|c| (c - at).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-4 * clock.last().unwrap(), "{line} px is no end of a stage");
    }
    assert!(lines.len() >= 2 * 2 && lines.len() <= 2 * stages.len(), "{} lines", lines.len());
    for (word, stage) in [("compression ends", 1), ("restitution ends", 1)] {
        assert_eq!(svg.matches(&format!(">{word}</text>")).count(), stage, "{word}");
    }
}

#[test]
fn the_same_walk_is_the_same_picture() {
    let draw = || joint_svg(&JointWalk::of_stages(contacts(), &struck()));
    assert_eq!(draw(), draw());
}

#[test]
fn without_an_impulse_there_is_no_picture() {
    let walk = JointWalk::of_stages::<2>(contacts(), &[]);
    assert_eq!(joint_svg(&walk), "", "no stage");
    let mut walk = JointWalk::of_stages(contacts(), &struck());
    walk.stages[0].pieces[0].velocity[1][0] = f64::NAN;
    assert_eq!(joint_svg(&walk), "", "not a number");
}

#[test]
fn of_many_stages_the_first_and_the_last_are_told() {
    let stages = struck();
    let many: Vec<staged::Stage<2>> = (0..40).map(|k| stages[k % stages.len()]).collect();
    let svg = joint_svg(&JointWalk::of_stages(contacts(), &many));
    assert!(svg.contains(">… 24 stages</text>"), "16 lines are shown");
    let words = ["slips +t", "slips −t", "sticks", "open"];
    let cells: usize = words.iter().map(|word| svg.matches(&format!(">{word}</text>")).count()).sum();
    assert_eq!(cells, 16 * 2, "a word for each contact on every line");
}
