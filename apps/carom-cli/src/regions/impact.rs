//! Any impact file: what its contacts do after, over two of its numbers.

use super::keys::{Key, Plane};
use super::study::{Label, Study};
use carom_figure::RegionName;
use carom_impact::planar::{Slip, single, staged};
use carom_scene::{ImpactProblem, ImpactTemplate};

/// A velocity after that is smaller than this share of the largest before is the rounding of zero.
const STILL: f64 = 1e-12;
/// Digits of a label: no contact has more states.
const BASE: Label = 5;

const STATES: [(&str, &str); 5] =
    [("", ""), ("o", "separates"), ("s", "sticks"), ("+", "slips along t"), ("−", "slips against t")];

/// The numbers of a file as keys.
pub(super) fn keys(template: &ImpactTemplate) -> Vec<Key> {
    let any = [f64::NEG_INFINITY, f64::INFINITY];
    let key = |number: &carom_scene::ImpactNumber| {
        Key::new(&number.path, &number.path, number.dimension, number.value, any)
    };
    template.numbers().iter().map(key).collect()
}

/// The problems that the ends of the axes bring, once each.
pub(super) fn problems(template: &ImpactTemplate, plane: &Plane) -> Vec<(&'static str, String)> {
    let mut found: Vec<(&'static str, String)> = vec![];
    for (axis, option) in plane.axes.iter().zip(["--x", "--y"]) {
        for shown in [axis.range.from, axis.range.to] {
            let path = plane.keys[axis.key].name.as_str();
            let Err(problems) = template.at(&[(path, axis.si(shown))]) else { continue };
            let text =
                |problem: &carom_scene::Problem| (option, format!("{}: {}", problem.path, problem.message));
            for complaint in problems.list.iter().map(text) {
                if !found.contains(&complaint) {
                    found.push(complaint);
                }
            }
        }
    }
    found
}

/// The diagram of a file.
pub(super) fn study<'a>(
    template: &'a ImpactTemplate,
    names: &'a [String],
    title: &str,
    plane: &'a Plane,
) -> Study<'a> {
    let paths: Vec<&str> = plane.keys.iter().map(|key| key.name.as_str()).collect();
    let is_axis = |k: usize| plane.axes.iter().any(|axis| axis.key == k);
    let is_set =
        |k: usize| template.numbers().get(k).is_some_and(|number| number.value != plane.keys[k].value);
    let changed: Vec<usize> = (0..paths.len()).filter(|&k| is_axis(k) || is_set(k)).collect();
    Study {
        slug: format!("regions-{title}"),
        title: format!("What the contacts of {title} do after the impact"),
        subtitle: "staged impact; o separates, s sticks, + and − slips along or against the tangent"
            .to_owned(),
        plane,
        classify: Box::new(move |x, y| {
            let values = plane.at(x, y);
            let moved: Vec<(&str, f64)> = changed.iter().map(|&k| (paths[k], values[k])).collect();
            template.at(&moved).map_or(0, |problem| label(&problem))
        }),
        name: Box::new(move |label| name(label, names)),
        state: Box::new(|_| 0),
        curves: vec![],
        curves_are: String::new(),
        remarks: Box::new(|_| vec![]),
    }
}

/// The type where one contact acts, and the state of every contact; 0 where there is no walk.
fn label(problem: &ImpactProblem) -> Label {
    let set = &problem.contacts;
    let Ok(outcome) = staged::resolve(set, problem.law) else { return 0 };
    let fastest = (0..set.count).fold(0.0f64, |most, i| most.max(set.slip[i].abs()).max(set.normal[i].abs()));
    let still = STILL * fastest;
    let digit = |i: usize| {
        let [slip, normal] = outcome.velocity[i];
        let slips = if slip.abs() <= still {
            Slip::Sticks
        } else if slip > 0.0 {
            Slip::Forward
        } else {
            Slip::Backward
        };
        match slips {
            _ if normal > still => 1,
            Slip::Sticks | Slip::Open => 2,
            Slip::Forward => 3,
            Slip::Backward => 4,
        }
    };
    let states = (0..set.count).rev().fold(0, |label, i| label * BASE + digit(i));
    states * 8 + Label::from(kind(problem))
}

/// The type 1…7 of an impact at one contact; 0 for others.
fn kind(problem: &ImpactProblem) -> u8 {
    let set = &problem.contacts;
    if set.count != 1 {
        return 0;
    }
    let outcome = single::resolve(&set.alone(0), problem.law).ok();
    outcome.and_then(|outcome| outcome.kind).map_or(0, |kind| kind.number())
}

fn name(label: Label, names: &[String]) -> RegionName {
    if label == 0 {
        return RegionName { short: "?".to_owned(), long: "no walk".to_owned() };
    }
    let (kind, mut rest) = (label % 8, label / 8);
    let (mut short, mut words) = (String::new(), vec![]);
    if kind > 0 {
        short = kind.to_string();
        words.push(format!("type {kind}"));
    }
    for name in names {
        let (sign, word) = STATES[(rest % BASE) as usize];
        rest /= BASE;
        short += sign;
        words.push(format!("{name} {word}"));
    }
    RegionName { short, long: words.join(", ") }
}
