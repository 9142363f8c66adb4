//! A pyramid that rolls over its lateral edge onto the next face: which of the three points stay, over its shape.

use super::study::{Curve, Label, Study};
use crate::tasks::axes::{Axis, Key, Plane};
use crate::tasks::tolerance::{BRACKET, REGION_ACCURACY};
use carom_figure::RegionName;
use carom_scene::RegionsThresholdReport;
use carom_scene::unit::Dimension;
use carom_study::regions::Regions;
use carom_study::spatial_strikes::EdgeRoll;
use carom_study::stretches::{self, Options};
use carom_theory::spatial::LateralRoll;

const LEAST: f64 = 1e-3;
const MOST_SIDES: f64 = 1000.0;
/// What the engine refuses to compute.
const FAILED: Label = Label::MAX;

/// Places of the quantities in [`keys`].
const SIDES: usize = 0;
const HEIGHT: usize = 1;
/// Changes of the outcome that are followed between two nodes of a line.
const MOST_CHANGES: usize = 8;

pub(super) const AXES: [&str; 2] = ["sides=3..12:90", "height_ratio=0.05..2:78"];

pub(super) fn keys() -> Vec<Key> {
    let number = |name, words, value, allowed| Key::new(name, words, Dimension::Number, value, allowed);
    vec![
        number("sides", "sides n", 4.0, [3.0, MOST_SIDES]),
        number("height_ratio", "height by circumradius h/a", 1.0, [LEAST, 1.0 / LEAST]),
        number("centre_ratio", "mass centre from the apex d/h", 0.75, [LEAST, 1.0 - LEAST]),
        number("inertia_ratio", "moments by the homogeneous ones", 1.0, [LEAST, 1.0 / LEAST]),
    ]
}

fn body(values: &[f64]) -> EdgeRoll {
    let [sides, height, centre, inertia] = [0, 1, 2, 3].map(|k| values.get(k).copied().unwrap_or(f64::NAN));
    EdgeRoll { sides, height, centre, inertia }
}

fn label(values: &[f64]) -> Label {
    body(values).ways().unwrap_or(FAILED)
}

fn theory(values: &[f64]) -> LateralRoll {
    let EdgeRoll { sides, height, centre, inertia } = body(values);
    let whole = LateralRoll::homogeneous(sides, height);
    LateralRoll {
        apex_to_centre: centre * height,
        inertia_transverse: inertia * whole.inertia_transverse,
        inertia_axial: inertia * whole.inertia_axial,
        ..whole
    }
}

const CURVES: [&str; 5] = [
    "OK|K     J_t = m d (h − d)",
    "OAK|AK   the same",
    "OK|OAK   J_a h² = −(J_t + m d²) a² cos 2π/n",
    "AK|none  A's impulse beside K's is 0",
    "K|none   A's velocity about K is 0",
];

pub(super) fn study(plane: &Plane) -> Study<'_> {
    let states = theory(&plane.at(plane.axes[0].range.from, plane.axes[1].range.from)).borders();
    let curve = |(k, name): (usize, &&str)| Curve {
        name: (*name).to_owned(),
        states: Some(states[k].states),
        border: Box::new(move |x, y| {
            let border = theory(&plane.at(x, y)).borders()[k];
            (border.residual, border.applies)
        }),
    };
    Study {
        slug: "regions-pyramid".to_owned(),
        title: "A pyramid rolls onto its next face: which points stay".to_owned(),
        subtitle: format!("{}; plastic, nothing slides", plane.fixed()),
        plane,
        classify: Box::new(move |x, y| label(&plane.at(x, y))),
        name: Box::new(name),
        state: Box::new(state),
        curves: CURVES.iter().enumerate().map(curve).collect(),
        curves_are: "closed forms".to_owned(),
        ends: None,
        remarks: Box::new(move |regions| remarks(plane, regions)),
        thresholds: Some(Box::new(move || thresholds(plane))),
        accuracy: REGION_ACCURACY,
    }
}

/// The number that the closed forms give an outcome.
fn state(label: Label) -> u8 {
    match label {
        EdgeRoll::LONG => 1,
        EdgeRoll::SHORT => 2,
        EdgeRoll::STOPS => 3,
        EdgeRoll::BASE_EDGE => 4,
        0 => 5,
        _ => 0,
    }
}

fn name(label: Label) -> RegionName {
    let long = match state(label) {
        1 => "A separates: it rolls on about the lateral edge OK",
        2 => "the apex O and A separate: it turns about K",
        3 => "nothing separates: it stops on the face OAK",
        4 => "the apex O separates: it turns about the edge AK of the base",
        5 => "no state is consistent: without sliding there is no way on",
        _ => return super::stool_strike::other(label, &["O", "A", "K"], FAILED),
    };
    let short = ["", "OK", "K", "OAK", "AK", "none"][usize::from(state(label))];
    RegionName { short: short.to_owned(), long: long.to_owned() }
}

/// True where the plane is the height over the number of sides.
fn is_height_over_sides(plane: &Plane) -> bool {
    plane.axes[0].key == SIDES && plane.axes[1].key == HEIGHT
}

/// On every whole number of sides: where the outcome changes with the height.
fn thresholds(plane: &Plane) -> Vec<RegionsThresholdReport> {
    if !is_height_over_sides(plane) {
        return vec![];
    }
    let [across, up] = [0, 1].map(|k| plane.axes[k].range);
    let nodes: Vec<f64> = (0..=up.count).map(|k| up.at(k as f64 / up.count as f64)).collect();
    let options = Options { accuracy: BRACKET * (up.to - up.from), most: MOST_CHANGES };
    let mut found = vec![];
    let mut sides = across.from.ceil();
    while sides <= across.to {
        let at = |height: f64| label(&plane.at(sides, height));
        let pieces = stretches::find(&nodes, options, at, |label| *label).pieces;
        for pair in pieces.windows(2) {
            let [below, above] = pair else { continue };
            found.push(RegionsThresholdReport {
                x: sides,
                y: 0.5 * (below.last + above.first),
                y_bracket: above.first - below.last,
                below: name(below.label).short,
                above: name(above.label).short,
                closed_form_y: critical(plane, sides, [below.label, above.label]),
            });
        }
        sides += 1.0;
    }
    found
}

/// The height at which the apex begins to stay, where that is what changes.
fn critical(plane: &Plane, sides: f64, labels: [Label; 2]) -> Option<f64> {
    let EdgeRoll { centre, inertia, .. } = body(&plane.at(sides, 1.0));
    let states = labels.map(state);
    let changes = [[2, 1], [1, 2], [4, 3], [3, 4]].contains(&states);
    changes.then(|| LateralRoll::critical_ratio(sides, centre, inertia)).flatten()
}

fn remarks(plane: &Plane, _: &Regions<Label>) -> Vec<String> {
    let whole = |axis: &Axis| axis.key == SIDES;
    if !plane.axes.iter().any(whole) {
        return vec![];
    }
    vec![
        "n is a pyramid's number of sides where it is whole; between, the same three points and moments go on continuously\n\
         the printed criterion, h = a √(1 − ⅔ sin² π/n) if homogeneous, is the curve OK|K; a pyramid on a triangle has neither of the two outcomes in print"
            .to_owned(),
    ]
}
