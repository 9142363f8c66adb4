//! The strike map: a corner's angle to the normal and its incidence, and what comes of the strike.

use super::study::{Curve, Label, Study};
use crate::tasks::axes::{Key, Plane};
use crate::tasks::tolerance::{LEAST_INCIDENCE, REGION_ACCURACY};
use carom_figure::RegionName;
use carom_scene::unit::Dimension;
use carom_study::corner::Striker;
use carom_study::regions::Regions;
use carom_words::number::ascii as fixed;
use std::f64::consts::FRAC_PI_2;

/// Of the feeder paper's part [kg m²].
const PAPERS_INERTIA: f64 = 2.5e-4;
/// Smallest moment of inertia of a diagram [kg m²].
const LEAST_INERTIA: f64 = 1e-12;
const LEAST: f64 = 1e-9;
const ANY: f64 = f64::INFINITY;

/// Places of the quantities in [`keys`].
const ANGLE: usize = 0;
const SLOPE: usize = 8;

/// What may be set; defaults are the part of the published feeder and its second case.
pub(super) fn keys() -> Vec<Key> {
    let side = FRAC_PI_2 - LEAST;
    vec![
        Key::new("angle_to_normal", "axis to normal φ_K", Dimension::Angle, 0.0, [-side, side]),
        Key::new("incidence", "incidence of the corner", Dimension::Angle, 0.0, [-side, side]),
        Key::new("length", "length", Dimension::Length, 0.1, [LEAST, ANY]),
        Key::new("height", "height", Dimension::Length, 0.0, [0.0, ANY]),
        Key::new("mass", "mass", Dimension::Mass, 0.3, [LEAST, ANY]),
        Key::new("inertia", "J", Dimension::Inertia, PAPERS_INERTIA, [LEAST_INERTIA, ANY]),
        Key::new("friction", "f", Dimension::Number, 0.15, [0.0, ANY]),
        Key::new("restitution", "R", Dimension::Number, 0.0, [0.0, 1.0]),
        Key::new("slope", "plate's slope", Dimension::Angle, 25f64.to_radians(), [0.0, side]),
        Key::new("speed", "corner's speed", Dimension::Speed, 1.87, [LEAST, ANY]),
        Key::new("spin", "spin before", Dimension::Spin, 7.6, [f64::NEG_INFINITY, ANY]),
    ]
}

pub(super) const AXES: [&str; 2] = ["angle_to_normal=-85..85 deg:85", "incidence=-85..85 deg:85"];

/// The diagram, with the rule printed for the published feeder over it.
pub(super) fn study(plane: &Plane) -> Study<'_> {
    let line = |name: &str, at: fn(&[f64]) -> f64| Curve {
        name: name.to_owned(),
        states: None,
        border: Box::new(move |x, y| {
            let values = plane.at(x, y);
            (values[ANGLE] - at(&values), true)
        }),
    };
    Study {
        slug: "regions-strike".to_owned(),
        title: "A corner strikes a plate: type and spin after".to_owned(),
        subtitle: plane.fixed(),
        plane,
        classify: Box::new(move |x, y| label(&plane.at(x, y))),
        name: Box::new(name),
        state: Box::new(|_| 0),
        curves: vec![
            line("left of 0: spin reverses, type 5", |_| 0.0),
            line("right of the slope: stays positive, type 1", |values| values[SLOPE]),
        ],
        curves_are: "the rule in print; type 7 between:".to_owned(),
        ends: None,
        remarks: Box::new(move |regions| vec![agreement(plane, regions)]),
        thresholds: None,
        accuracy: REGION_ACCURACY,
    }
}

/// Type and sign of the spin after: `3 · type + (0: negative, 1: none, 2: positive)`; 0 where nothing strikes.
fn label(values: &[f64]) -> Label {
    let &[angle, incidence, length, height, mass, inertia, friction, restitution, _, speed, spin] = values
    else {
        return 0;
    };
    let part = Striker { length, height, mass, inertia, friction, restitution };
    let incidence = if incidence == 0.0 { LEAST_INCIDENCE } else { incidence };
    let Ok(strike) = part.strike([angle, incidence], speed, spin) else { return 0 };
    let sign = if strike.spin > 0.0 { 2 } else { Label::from(strike.spin == 0.0) };
    strike.kind.map_or(0, |kind| 3 * Label::from(kind.number()) + sign)
}

fn name(label: Label) -> RegionName {
    if label == 0 {
        return RegionName { short: "?".to_owned(), long: "no impact".to_owned() };
    }
    let (sign, sense) = [("−", "negative"), ("0", "zero"), ("+", "positive")][(label % 3) as usize];
    let kind = match label / 3 {
        1 => "slides throughout",
        2 => "slips from rest",
        3 => "sticks from rest",
        4 => "reverses in restitution",
        5 => "reverses in compression",
        6 => "stops in restitution",
        _ => "stops in compression",
    };
    RegionName { short: format!("{}{sign}", label / 3), long: format!("{kind}, spin {sense}") }
}

/// On how much of the grid the printed rule names the type, and the sign of the spin.
fn agreement(plane: &Plane, regions: &Regions<Label>) -> String {
    let (mut nodes, mut types, mut decided, mut signs, mut simple) = (0u32, 0u32, 0u32, 0u32, 0u32);
    for j in 0..=regions.y.count {
        for i in 0..=regions.x.count {
            let share = |k: usize, count: usize| k as f64 / count as f64;
            let (x, y) = (share(i, regions.x.count), share(j, regions.y.count));
            let values = plane.at(regions.x.at(x), regions.y.at(y));
            let label = label(&values);
            let (kind, positive) = (label / 3, label % 3 == 2);
            let (angle, slope) = (values[ANGLE], values[SLOPE]);
            nodes += 1;
            simple += u32::from(positive == (angle > 0.0));
            let printed = if angle > slope {
                1
            } else if angle < 0.0 {
                5
            } else {
                7
            };
            types += u32::from(kind == printed);
            if printed != 7 {
                decided += 1;
                signs += u32::from(positive == (printed == 1));
            }
        }
    }
    let percent = |part: u32, of: u32| fixed(100.0 * f64::from(part) / f64::from(of.max(1)), 1);
    format!(
        "the rule in print (φ_K above the plate's slope: spin stays positive, type 1; below 0: it reverses, type 5; between: type 7)\n\
         names the type on {} % of the grid, and the sign of the spin on {} % of what it decides; \"φ_K > 0\" gives the sign on {} %",
        percent(types, nodes),
        percent(signs, decided),
        percent(simple, nodes)
    )
}
