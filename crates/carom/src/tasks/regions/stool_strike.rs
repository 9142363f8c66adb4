//! A stool that comes down from its support O on the neighbour K: which of the two stay.

use super::study::{Curve, Label, Study};
use crate::tasks::axes::{Key, Plane};
use crate::tasks::tolerance::REGION_ACCURACY;
use carom_figure::RegionName;
use carom_scene::unit::Dimension;
use carom_study::regions::Regions;
use carom_study::spatial_strikes::StoolStrike;
use carom_theory::spatial::{Approach, Stool};
use carom_words::number::ascii as fixed;
use std::f64::consts::FRAC_PI_2;

pub(super) const LEAST: f64 = 1e-3;
pub(super) const MOST: f64 = 1e3;
const MOST_SUPPORTS: f64 = 12.0;
/// What the engine refuses to compute.
const FAILED: Label = Label::MAX;

pub(super) const AXES: [&str; 2] = ["swinging=-4..4:80", "gyration_ratio=0.05..1.2:69"];

pub(super) fn keys() -> Vec<Key> {
    let swinging = "K's inward speed by its approach γ/β";
    let mut keys = shape([3.0, 0.4, 0.5, 1.5]);
    keys.extend([
        Key::new("swinging", swinging, Dimension::Number, 0.0, [-MOST, MOST]),
        Key::new("tilt", "tilt about OK δ", Dimension::Angle, 5f64.to_radians(), [0.0, FRAC_PI_2 - LEAST]),
    ]);
    keys
}

/// The quantities of a stool itself, with what each is where nobody says it: the first four of every diagram of stools.
pub(super) fn shape([supports, centre, gyration, axial]: [f64; 4]) -> Vec<Key> {
    let number = |name, words, value, allowed| Key::new(name, words, Dimension::Number, value, allowed);
    vec![
        number("supports", "supports n", supports, [3.0, MOST_SUPPORTS]),
        number("centre_ratio", "mass centre by circle radius c/a", centre, [LEAST, MOST]),
        number("gyration_ratio", "radius of gyration by circle radius", gyration, [LEAST, MOST]),
        number("axial_ratio", "J_z/J_t", axial, [LEAST, 2.0]),
    ]
}

/// A whole number of supports: an axis goes through the numbers between as well.
pub(super) fn whole(supports: f64) -> u32 {
    supports.round().clamp(3.0, MOST_SUPPORTS) as u32
}

fn strike(values: &[f64]) -> StoolStrike {
    let at = |k: usize| values.get(k).copied().unwrap_or(f64::NAN);
    StoolStrike {
        supports: whole(at(0)),
        centre: at(1),
        gyration: at(2),
        axial: at(3),
        swinging: at(4),
        tilt: at(5),
    }
}

fn theory(values: &[f64]) -> (Stool, Approach) {
    let StoolStrike { supports, centre, gyration, axial, swinging, tilt } = strike(values);
    let inertia = gyration * gyration;
    let stool = Stool {
        supports,
        circle_radius: 1.0,
        centre_height: centre,
        mass: 1.0,
        inertia_transverse: inertia,
        inertia_axial: axial * inertia,
    };
    (stool, Approach { tilting: 0.0, closing: 1.0, swinging, tilt })
}

const CURVES: [&str; 6] = [
    "OK|none  a normal impulse is 0, both kept",
    "K|OK,K   the same",
    "K|none   K's impulse or O's velocity is 0",
    "OK|OK,K  the same",
    "OK|K     κ² = −a² cos 2π/n, if J_z = J_t",
    "OK,K|none  γ p c = β κ², if δ = 0",
];

pub(super) fn study(plane: &Plane) -> Study<'_> {
    let (stool, approach) = theory(&plane.at(plane.axes[0].range.from, plane.axes[1].range.from));
    let states = stool.borders(&approach);
    let curve = |(k, name): (usize, &&str)| Curve {
        name: (*name).to_owned(),
        states: Some(states[k].states),
        border: Box::new(move |x, y| {
            let (stool, approach) = theory(&plane.at(x, y));
            let border = stool.borders(&approach)[k];
            (border.residual, border.applies)
        }),
    };
    Study {
        slug: "regions-stool-strike".to_owned(),
        title: "A stool comes down on its next support: which of the two stay".to_owned(),
        subtitle: format!("{}; plastic, nothing slides", plane.fixed()),
        plane,
        classify: Box::new(move |x, y| strike(&plane.at(x, y)).ways().unwrap_or(FAILED)),
        name: Box::new(name),
        state: Box::new(state),
        curves: CURVES.iter().enumerate().map(curve).collect(),
        curves_are: "closed forms".to_owned(),
        ends: None,
        remarks: Box::new(move |regions| vec![only_the_next(plane, regions)]),
        thresholds: None,
        accuracy: REGION_ACCURACY,
    }
}

/// The number that the closed forms give an outcome.
fn state(label: Label) -> u8 {
    const EITHER: Label = StoolStrike::BOTH | StoolStrike::NEXT;
    match label {
        StoolStrike::BOTH => 1,
        StoolStrike::NEXT => 2,
        EITHER => 3,
        0 => 4,
        _ => 0,
    }
}

fn name(label: Label) -> RegionName {
    let (short, long) = match state(label) {
        1 => ("OK", "both stay: it turns about OK"),
        2 => ("K", "O separates: it turns about K"),
        3 => ("OK,K", "either both stay or O separates: the law leaves it open"),
        4 => ("none", "no state is consistent: without sliding there is no way on"),
        _ => return other(label, &["O", "K"], FAILED),
    };
    RegionName { short: short.to_owned(), long: long.to_owned() }
}

/// The name of any set of ways on.
pub(super) fn other(label: Label, points: &[&str], failed: Label) -> RegionName {
    if label == failed {
        return RegionName { short: "?".to_owned(), long: "there is no such body".to_owned() };
    }
    let letters = |set: usize| -> String {
        points.iter().enumerate().filter(|(i, _)| set >> i & 1 == 1).map(|(_, point)| *point).collect()
    };
    let sets = (0..1_usize << points.len()).filter(|set| label >> set & 1 == 1);
    let ways: Vec<String> = sets.map(letters).collect();
    if ways.is_empty() {
        let long = "no state is consistent: without sliding there is no way on".to_owned();
        return RegionName { short: "none".to_owned(), long };
    }
    RegionName { short: ways.join(","), long: format!("stays: {}", ways.join(" or ")) }
}

/// On how much of the grid the state that keeps both asks K alone to pull.
fn only_the_next(plane: &Plane, regions: &Regions<Label>) -> String {
    let (mut nodes, mut pulls) = (0_u32, 0_u32);
    for j in 0..=regions.y.count {
        for i in 0..=regions.x.count {
            let share = |k: usize, count: usize| k as f64 / count as f64;
            let (x, y) = (share(i, regions.x.count), share(j, regions.y.count));
            let (stool, approach) = theory(&plane.at(regions.x.at(x), regions.y.at(y)));
            let [at_o, at_k] = stool.on_both(&approach).normal;
            nodes += 1;
            pulls += u32::from(at_k < 0.0 && at_o >= 0.0);
        }
    }
    let percent = fixed(100.0 * f64::from(pulls) / f64::from(nodes.max(1)), 1);
    format!(
        "on {percent} % of the grid the state that keeps both has N_K < 0 <= N_O, in print \"separation only of K\":\n\
         no impulse at O can stop K, and no state keeps O alone anywhere"
    )
}
