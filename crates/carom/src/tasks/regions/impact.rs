//! Any impact file: what its contacts do after, over two of its numbers.

use super::study::{EndsAt, Label, Study};
use crate::tasks::axes::{Key, Plane};
use crate::tasks::tolerance::{REGION_ACCURACY, STILL_AFTER_IMPACT};
use carom_figure::RegionName;
use carom_impact::Law;
use carom_impact::planar::sharing::{self, Sharing};
use carom_impact::planar::{ContactSet6, MOST_CONTACTS, pivoting, single};
use carom_scene::{ImpactContacts, ImpactProblem, ImpactTemplate};
use carom_study::Ends;

/// Contacts whose end states are sought at every node: hypotheses grow as four to their power.
const MOST_EXAMINED: usize = 2;
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
    for (axis, option) in plane.axes.iter().zip(["x", "y"]) {
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
    // As the file, but for the axes and what is set.
    let at = move |x: f64, y: f64| {
        let values = plane.at(x, y);
        let moved: Vec<(&str, f64)> = changed.iter().map(|&k| (paths[k], values[k])).collect();
        template.at(&moved).ok()
    };
    let also_at = at.clone();
    let walked = match template.at(&[]).map(|problem| problem.sharing) {
        _ if names.len() > MOST_CONTACTS => "one end state, others not searched for",
        Ok(Sharing::InSequence) => "contacts are struck in sequence",
        Ok(Sharing::ByStiffness { .. }) => "contacts share by stiffness",
        _ => "staged impact",
    };
    Study {
        slug: format!("regions-{title}"),
        title: format!("What the contacts of {title} do after the impact"),
        subtitle: format!("{walked}; o separates, s sticks, + and − slips along or against the tangent"),
        plane,
        classify: Box::new(move |x, y| at(x, y).map_or(0, |problem| label(&problem))),
        name: Box::new(move |label| name(label, names)),
        state: Box::new(|_| 0),
        curves: vec![],
        curves_are: String::new(),
        ends: (names.len() <= MOST_EXAMINED).then(|| {
            let ends: EndsAt<'a> = Box::new(move |x, y| {
                let problem = also_at(x, y)?;
                let ImpactContacts::Several(set) = &problem.contacts else { return None };
                Ends::shared(&**set, problem.law, &problem.sharing).ok()
            });
            ends
        }),
        remarks: Box::new(|_| vec![]),
        thresholds: None,
        accuracy: REGION_ACCURACY,
    }
}

/// The type where one contact acts, and the state of every contact; 0 where there is no answer.
fn label(problem: &ImpactProblem) -> Label {
    let (velocity, kind): (Vec<[f64; 2]>, u8) = match &problem.contacts {
        ImpactContacts::Several(set) => match sharing::resolve(&**set, problem.law, &problem.sharing) {
            Ok(outcome) => (outcome.velocity[..set.count].to_vec(), kind(set, problem.law)),
            Err(_) => return 0,
        },
        ImpactContacts::Many(set) => match pivoting::one_end_state(&**set, problem.law) {
            Ok(end) => (end.velocity[..set.count].to_vec(), 0),
            Err(_) => return 0,
        },
    };
    let before = problem.contacts.before();
    let still = STILL_AFTER_IMPACT * before.iter().flatten().fold(0.0f64, |most, u| most.max(u.abs()));
    let digit = |[slip, normal]: [f64; 2]| match slip {
        _ if normal > still => 1,
        slip if slip.abs() <= still => 2,
        slip if slip > 0.0 => 3,
        _ => 4,
    };
    let states = velocity.into_iter().rev().fold(0, |label, u| label * BASE + digit(u));
    states * 8 + Label::from(kind)
}

/// The type 1…7 of an impact at one contact; 0 for others.
fn kind(set: &ContactSet6, law: Law) -> u8 {
    if set.count != 1 {
        return 0;
    }
    let outcome = single::resolve(&set.alone(0), law).ok();
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
