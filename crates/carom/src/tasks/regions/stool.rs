//! A stool that is let go: what it strikes with first, what stays, and how it ends.

use super::stool_strike::{LEAST, MOST, shape, whole};
use super::study::{Label, Study};
use crate::tasks::axes::{Key, Plane};
use crate::tasks::tolerance::RUN_ACCURACY;
use carom_figure::RegionName;
use carom_motion::spatial::Supports;
use carom_num::elementary::atan2;
use carom_scene::unit::Dimension;
use carom_study::releases::{Release, Released, Settled};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

const MOST_STRIKES: f64 = 1000.0;

pub(super) const AXES: [&str; 2] = ["tilt=1..80 deg:32", "direction=40..140 deg:32"];

/// Defaults are the cube of `carom roll stool`.
pub(super) fn keys() -> Vec<Key> {
    let number = |name, words, value, allowed| Key::new(name, words, Dimension::Number, value, allowed);
    let mut keys = shape([4.0, FRAC_1_SQRT_2, (1.0f64 / 3.0).sqrt(), 1.0]);
    keys.extend([
        Key::new("tilt", "tilt", Dimension::Angle, 0.1, [LEAST, FRAC_PI_2]),
        Key::new("direction", "tilt's axis from support 0", Dimension::Angle, atan2(4.0, 1.0), [0.0, PI]),
        number("spin_ratio", "spin about the axis by √(g/a)", 0.0, [-MOST, MOST]),
        number("strikes", "strikes followed (0: all)", 0.0, [0.0, MOST_STRIKES]),
    ]);
    keys
}

fn release(values: &[f64]) -> Release {
    let at = |k: usize| values.get(k).copied().unwrap_or(f64::NAN);
    Release {
        supports: whole(at(0)),
        centre: at(1),
        gyration: at(2),
        axial: at(3),
        tilt: at(4),
        direction: at(5),
        spin: at(6),
        strikes: at(7).round() as u32,
    }
}

pub(super) fn study(plane: &Plane) -> Study<'_> {
    Study {
        slug: "regions-stool".to_owned(),
        title: "A stool is let go: first strike and end".to_owned(),
        subtitle: format!("{}; plastic, nothing slides", plane.fixed()),
        plane,
        classify: Box::new(move |x, y| label(&release(&plane.at(x, y)).followed())),
        name: Box::new(name),
        state: Box::new(|_| 0),
        curves: vec![],
        curves_are: String::new(),
        ends: None,
        remarks: Box::new(|_| vec![]),
        thresholds: None,
        accuracy: RUN_ACCURACY,
    }
}

const SETTLED: [Settled; 6] = [
    Settled::AtRest,
    Settled::Overturned,
    Settled::NoConsistentOutcome,
    Settled::GoesOn,
    Settled::Balanced,
    Settled::NoStart,
];
const SHORT: [&str; 6] = ["rest", "over", "none", "on", "balance", "-"];
const LONG: [&str; 6] = [
    "comes to rest",
    "overturns",
    "without sliding there is no way on",
    "goes on",
    "stands still, balanced",
    "a support would start below the plane",
];
/// Bits of a set of supports.
const PLACES: u32 = 12;

/// The end, and the two sets of the first strike.
fn label(released: &Released) -> Label {
    let settled = SETTLED.iter().position(|settled| *settled == released.settled).unwrap_or(0) as Label;
    let bits = |set: Supports| set.iter().fold(0, |bits: Label, i| bits | 1 << i);
    let [touching, kept] = released.first.map(bits);
    settled + 8 * (touching | kept << PLACES)
}

fn name(label: Label) -> RegionName {
    let (settled, sets) = ((label % 8) as usize, label / 8);
    let set = |bits: Label, between: &str| {
        let numbers: Vec<String> =
            (0..PLACES).filter(|i| bits >> i & 1 == 1).map(|i| i.to_string()).collect();
        numbers.join(between)
    };
    let (touching, kept) = (sets % (1 << PLACES), sets >> PLACES);
    let (short, long) = (SHORT[settled.min(5)], LONG[settled.min(5)]);
    if touching == 0 {
        return RegionName { short: short.to_owned(), long: format!("{long}, without a strike") };
    }
    let plural = |bits: Label| if bits.count_ones() == 1 { "stays" } else { "stay" };
    let keeps = if kept == 0 { "none".to_owned() } else { set(kept, ", ") };
    RegionName {
        short: format!(
            "{}→{} {short}",
            set(touching, ""),
            if kept == 0 { "∅".to_owned() } else { set(kept, "") }
        ),
        long: format!("strike of {}: {keeps} {}; {long}", set(touching, ", "), plural(kept)),
    }
}
