//! A rod that slides with one end on a plate, under gravity: which motions are consistent.

use super::study::{Curve, Label, Study};
use crate::tasks::axes::{Key, Plane};
use crate::tasks::tolerance::REGION_ACCURACY;
use carom_figure::RegionName;
use carom_impact::planar::forces::{Applied, Loaded};
use carom_impact::planar::{Guess, Meeting, RigidBody, Slip};
use carom_num::Vec2;
use carom_num::elementary::sin_cos;
use carom_scene::unit::Dimension;
use carom_theory::painleve;
use std::f64::consts::FRAC_PI_2;

/// A share of the length or an angle that is as good as none.
const LEAST: f64 = 1e-9;
const MOST: f64 = 1e6;

pub(super) const AXES: [&str; 2] = ["angle=1..89 deg:88", "friction=0..3:75"];

const ANGLE: usize = 0;
const FRICTION: usize = 1;
const GYRATION: usize = 2;
const SPIN: usize = 3;
const SLIP: usize = 4;

/// Lengths in units of the way from the mass centre to the end, ℓ, times in units of √(ℓ/g). Defaults are a uniform slender rod that
/// slides into its lean.
pub(super) fn keys() -> Vec<Key> {
    let number = |name, words, value, allowed| Key::new(name, words, Dimension::Number, value, allowed);
    vec![
        Key::new("angle", "angle θ from the plate", Dimension::Angle, 1.0, [LEAST, FRAC_PI_2]),
        number("friction", "friction μ", 1.6, [0.0, MOST]),
        number("gyration_squared", "κ² = J/(mℓ²)", 1.0 / 3.0, [LEAST, MOST]),
        number("spin_ratio", "spin by √(g/ℓ)", 0.0, [-MOST, MOST]),
        number("slip_ratio", "slip by √(gℓ), into the lean", 1.0, [-MOST, MOST]),
    ]
}

pub(super) fn study(plane: &Plane) -> Study<'_> {
    // Where the spin does not throw the end off, pressing it in decides between one motion and none; where it does, between one and two.
    let border = |name: &str, states: [u8; 2], thrown: bool| Curve {
        name: name.to_owned(),
        states: Some(states),
        border: Box::new(move |x, y| {
            let values = plane.at(x, y);
            let free = painleve::free_acceleration(values[ANGLE], values[SPIN]);
            (pressed(&values), (free > 0.0) == thrown)
        }),
    };
    let thrown = |name: &str, states: [u8; 2], held: bool| Curve {
        name: name.to_owned(),
        states: Some(states),
        border: Box::new(move |x, y| {
            let values = plane.at(x, y);
            (painleve::free_acceleration(values[ANGLE], values[SPIN]), (pressed(&values) > 0.0) == held)
        }),
    };
    Study {
        slug: "regions-contact".to_owned(),
        title: "A rod slides with its end on a plate: consistent motions".to_owned(),
        subtitle: plane.fixed(),
        plane,
        classify: Box::new(move |x, y| label(&plane.at(x, y))),
        name: Box::new(name),
        state: Box::new(state),
        curves: vec![
            border("Painlevé: 1 + cos θ (cos θ − μ sin θ)/κ² = 0, the end falls", [1, 0], false),
            border("the same, the spin throws the end off", [2, 3], true),
            thrown("ω² sin θ = g/ℓ, the end can be pressed", [1, 2], true),
            thrown("the same, in Painlevé's case", [0, 3], false),
        ],
        curves_are: "closed forms:".to_owned(),
        ends: None,
        remarks: Box::new(|_| vec![]),
        thresholds: None,
        accuracy: REGION_ACCURACY,
    }
}

/// Normal acceleration per normal force of the end that slips, friction against the slip.
fn pressed(values: &[f64]) -> f64 {
    let into_the_lean = if values[SLIP] < 0.0 { -1.0 } else { 1.0 };
    painleve::response(values[GYRATION], values[ANGLE], into_the_lean * values[FRICTION])
}

/// Which of [`SLIPS`] are consistent, a bit for each.
fn label(values: &[f64]) -> Label {
    let &[angle, friction, gyration_squared, spin, slip] = values else { return 0 };
    let (sin, cos) = sin_cos(angle);
    // The end is ahead of the mass centre and below it, and touches: it does not approach.
    let arm = Vec2::new(cos, -sin);
    let end = Vec2::new(slip, 0.0);
    let velocity = end - arm.turned_left() * spin;
    let rod = RigidBody { mass: 1.0, inertia: gyration_squared, centre: Vec2::ZERO, velocity, spin };
    let normal = Vec2::new(0.0, 1.0);
    let plate = Meeting { into: 0, out_of: 1, point: arm, normal, friction, restitution: 0.0 };
    let weight = Applied { force: -normal, torque: 0.0 };
    let applied = [weight, Applied::default()];
    let Ok(loaded) = Loaded::<1, 2>::new(&[rod, RigidBody::FIXED], &[plate], &applied) else {
        return UNKNOWN;
    };
    // Hypothesis by hypothesis: two motions that meet at a border count as two up to it.
    let problem = loaded.problem();
    let known = SLIPS.iter().enumerate().filter(|(_, (slip, _, _))| may_be_asked(*slip, loaded.set.slip[0]));
    let consistent = known.filter(|(_, (slip, _, _))| {
        problem.try_guess(&[Guess { holds: *slip != Slip::Open, slip: *slip }]).is_ok()
    });
    consistent.fold(0, |bits, (k, _)| bits | 1 << k)
}

/// An end that slips goes on the way it slips; one that does not may do anything.
fn may_be_asked(slip: Slip, present: f64) -> bool {
    match slip {
        Slip::Open => true,
        Slip::Sticks => present == 0.0,
        Slip::Forward => present >= 0.0,
        Slip::Backward => present <= 0.0,
    }
}

/// What the end may do: a sign and words for each.
const SLIPS: [(Slip, &str, &str); 4] = [
    (Slip::Open, "o", "lifts off"),
    (Slip::Sticks, "s", "sticks"),
    (Slip::Forward, "+", "slides into its lean"),
    (Slip::Backward, "−", "slides out of its lean"),
];
/// What no rod is computed from.
const UNKNOWN: Label = 1 << SLIPS.len();
const LIFTS: Label = 1;

fn state(label: Label) -> u8 {
    match (label, label & LIFTS) {
        (0, _) => 0,
        (LIFTS, _) => 2,
        (_, LIFTS) => 3,
        _ => 1,
    }
}

fn name(label: Label) -> RegionName {
    if label == 0 {
        return RegionName { short: "∅".to_owned(), long: "no motion is consistent".to_owned() };
    }
    if label == UNKNOWN {
        return RegionName { short: "?".to_owned(), long: "no rod".to_owned() };
    }
    let said = |word: fn(&(Slip, &'static str, &'static str)) -> &'static str, between: &str| {
        let known = SLIPS.iter().enumerate().filter(|(k, _)| label >> k & 1 == 1);
        known.map(|(_, slip)| word(slip)).collect::<Vec<_>>().join(between)
    };
    RegionName { short: said(|s| s.1, "|"), long: said(|s| s.2, ", or ") }
}
