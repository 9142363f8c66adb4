//! Sections 1, 3 and 4 of the paper on simultaneous collisions: cylinder, prism and rod at two contacts.

use super::rolling::{border, first_strike, keys};
use crate::failure::ValidationError;
use crate::value::Values;
use carom_scene::{RollKind, RollStrikeReport};

/// Velocities and impulses below this, where rates are 1 rad/s, lengths 1 m and masses 1 kg, are rounding.
const ROUNDING: f64 = 1e-9;

/// A cylinder of 1 kg and 1 m that rolls at 1 rad/s: b, f, γ [deg] and R.
fn cylinder([b, f, gamma, r]: [f64; 4]) -> Result<RollStrikeReport, ValidationError> {
    first_strike(
        RollKind::Cylinder,
        &keys(&[
            ("mass", "1 kg".to_owned()),
            ("radius", "1 m".to_owned()),
            ("roll_rate", "1 rad/s".to_owned()),
            ("inertia_ratio", b.to_string()),
            ("friction", f.to_string()),
            ("gamma", format!("{gamma} deg")),
            ("restitution", r.to_string()),
        ]),
    )
}

/// Contact A, then K or B.
fn normal_impulse(strike: &RollStrikeReport, contact: usize) -> f64 {
    strike.contacts.get(contact).map_or(f64::NAN, |c| c.normal_impulse)
}

fn slip(strike: &RollStrikeReport, contact: usize) -> f64 {
    strike.contacts.get(contact).map_or(f64::NAN, |c| c.slip_m_s)
}

fn leaves(strike: &RollStrikeReport, contact: usize) -> bool {
    strike.contacts.get(contact).is_some_and(|c| c.normal_velocity_m_s > ROUNDING)
}

/// In the paper's frames of state 3: b, f, γ.
const BOTH_SLIDE: [[f64; 3]; 5] =
    [[1.0, 0.3, 60.0], [1.0, 0.1, 50.0], [1.0, 0.7, 70.0], [0.5, 0.3, 60.0], [0.4, 0.2, 60.0]];
/// One of each of the four states.
const STATES: [[f64; 3]; 8] = [
    [1.0, 0.3, 20.0],
    [1.0, 0.3, 40.0],
    [1.0, 0.3, 60.0],
    [1.0, 0.3, 80.0],
    [0.5, 0.3, 30.0],
    [0.5, 0.3, 50.0],
    [0.5, 0.3, 60.0],
    [0.5, 0.3, 70.0],
];

/// Section 1: a cylinder that rolls against a second surface.
pub(crate) fn compute_cylinder() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for [b, f, gamma] in BOTH_SLIDE {
        let strike = cylinder([b, f, gamma, 0.0])?;
        let of = |what: &str| format!("{what}.{b}.{f}.{gamma}");
        values.put(of("SNA"), normal_impulse(&strike, 0));
        values.put(of("SNK"), normal_impulse(&strike, 1));
        values.put(of("rate"), strike.roll_rate_rad_s);
    }
    for [b, f, gamma] in STATES {
        let strike = cylinder([b, f, gamma, 0.0])?;
        let number = strike.number.map_or(f64::NAN, f64::from);
        values.put(format!("state.{b}.{f}.{gamma}"), number);
    }
    let steep = cylinder([0.5, 0.8, 62.0, 0.0])?;
    values.put("a_leaves", if leaves(&steep, 0) { "A separates" } else { "A does not separate" });
    let reversed = cylinder([1.0, 0.3, 60.0, 0.9])?;
    values.put("reversal.slip", slip(&reversed, 1));
    let stopped = cylinder([1.0, 0.3, 40.0, 0.5])?;
    values.put("stop.slip", slip(&stopped, 1));
    let free = cylinder([1.0, 1.0, 60.0, 0.8])?;
    let struck = normal_impulse(&free, 0) > ROUNDING;
    values.put("state_5.a", if struck { "A is struck again" } else { "free plane motion" });
    values.put("state_6.slip", slip(&cylinder([1.0, 0.3, 60.0, 0.5])?, 0));
    let jammed = cylinder([1.0, 0.3, 80.0, 0.5])?;
    values.put("state_7.rate", jammed.roll_rate_rad_s);
    values.put("state_7.slip", slip(&cylinder([0.5, 0.45, 64.0, 0.5])?, 0));
    Ok(values)
}

/// A regular prism of 1 kg and 1 m that turns at 1 rad/s.
fn regular(sides: u32, friction: f64, restitution: f64) -> Result<RollStrikeReport, ValidationError> {
    first_strike(
        RollKind::Prism,
        &keys(&[
            ("mass", "1 kg".to_owned()),
            ("circumradius", "1 m".to_owned()),
            ("roll_rate", "1 rad/s".to_owned()),
            ("sides", sides.to_string()),
            ("friction", friction.to_string()),
            ("restitution", restitution.to_string()),
        ]),
    )
}

/// The same of one that is not regular: d_A, d_K and h [m], J [kg m²]; it does not slide.
fn irregular([d_a, d_k, h]: [f64; 3], inertia: f64) -> Result<RollStrikeReport, ValidationError> {
    first_strike(
        RollKind::Prism,
        &keys(&[
            ("mass", "1 kg".to_owned()),
            ("a_to_centre", format!("{d_a} m")),
            ("centre_to_k", format!("{d_k} m")),
            ("height", format!("{h} m")),
            ("inertia", format!("{inertia} kg m^2")),
            ("roll_rate", "1 rad/s".to_owned()),
        ]),
    )
}

/// Section 3: a prism that rolls over its edges.
pub(crate) fn compute_prism() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    let stays = |strike: &RollStrikeReport| if leaves(strike, 0) { "A separates" } else { "A stays" };
    let triangle = regular(3, 0.6, 0.0)?;
    values.put("SNA.3", normal_impulse(&triangle, 0));
    values.put("SNK.3", normal_impulse(&triangle, 1));
    values.put("stays.3", stays(&triangle));
    values.put("stays.3.sliding", stays(&regular(3, 0.3, 0.0)?));
    for sides in [3, 4, 6, 8, 12] {
        let slides = |f: f64| Ok(slip(&regular(sides, f, 0.0)?, 1).abs() > ROUNDING);
        values.put(format!("sticking.{sides}"), border([0.01, 2.0], slides)?);
    }
    for sides in [4, 5, 6, 12] {
        values.put(format!("stays.{sides}"), stays(&regular(sides, 0.7, 0.0)?));
    }
    let square = regular(4, 0.2, 0.0)?;
    values.put("stays.4.sliding", stays(&square));
    values.put("SNA.4.sliding", normal_impulse(&square, 0));
    for (name, shape) in [("even", [0.5, 0.5, 0.3]), ("uneven", [0.3, 0.7, 0.2])] {
        let stays = |inertia: f64| Ok(!leaves(&irregular(shape, inertia)?, 0));
        values.put(format!("irregular.{name}"), border([0.01, 1.0], stays)?);
    }
    let elastic = slip(&regular(6, 0.5, 0.4)?, 1).abs();
    values.put("item_5", if elastic > ROUNDING { "K slips" } else { "K sticks" });
    let mut lifted = 0;
    for (sides, f) in (3..=12).flat_map(|n| [0.1, 0.3, 0.5, 0.9].map(|f| (n, f))) {
        lifted += u32::from(normal_impulse(&regular(sides, f, 0.0)?, 1) <= 0.0);
    }
    values.put("k_separates", f64::from(lifted));
    Ok(values)
}

/// A rod on two supports: l, a, b [m], R; `more` says how it starts.
fn rod(
    [length, a, b, r]: [f64; 4],
    mass: f64,
    more: (&str, &str),
) -> Result<RollStrikeReport, ValidationError> {
    first_strike(
        RollKind::Rod,
        &keys(&[
            ("mass", format!("{mass} kg")),
            ("length", format!("{length} m")),
            ("to_a", format!("{a} m")),
            ("to_b", format!("{b} m")),
            ("restitution", r.to_string()),
            (more.0, more.1.to_owned()),
        ]),
    )
}

/// Rods that leave A: l, a, b.
const LEAVING: [[f64; 3]; 5] =
    [[2.0, 0.5, 0.5], [1.0, 0.2, 0.3], [1.0, 0.1, 0.4], [1.0, 0.4, 0.1], [1.5, 0.3, 0.5]];

/// Section 4: a rod that turns about one support and falls on the other.
pub(crate) fn compute_rod() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    let level = ("roll_rate", "1 rad/s");
    for [length, a, b] in LEAVING {
        let strike = rod([length, a, b, 0.0], 1.0, level)?;
        values.put(format!("k.{length}.{a}.{b}"), strike.roll_rate_rad_s);
    }
    let heavy = rod([1.0, 0.2, 0.3, 0.0], 3.0, ("roll_rate", "7 rad/s"))?;
    values.put("k.heavy", heavy.roll_rate_rad_s / heavy.roll_rate_before_rad_s);
    let released = rod([1.0, 0.3, 0.3, 0.0], 1.0, ("release", "30 deg"))?;
    values.put("release", released.roll_rate_before_rad_s);
    let held = rod([1.0, 0.4, 0.4, 0.0], 1.0, level)?;
    values.put("SYA", normal_impulse(&held, 0));
    values.put("SYB", normal_impulse(&held, 1));
    values.put("border", border([0.1, 0.49], |a| Ok(leaves(&rod([1.0, a, a, 0.0], 1.0, level)?, 0)))?);
    for (variant, of) in [
        (1, [1.0, 0.4, 0.4, 0.0]),
        (2, [1.0, 0.2, 0.3, 0.0]),
        (3, [1.0, 0.4, 0.4, 0.6]),
        (4, [1.0, 0.2, 0.3, 0.6]),
    ] {
        let number = rod(of, 1.0, level)?.number.map_or(f64::NAN, f64::from);
        values.put(format!("variant.{variant}"), number);
    }
    let mut lifted = 0;
    for (a, b) in (1..=4).flat_map(|i| (1..=4).map(move |j| (0.1 * f64::from(i), 0.1 * f64::from(j)))) {
        lifted += u32::from(normal_impulse(&rod([1.0, a, b, 0.0], 1.0, level)?, 1) <= 0.0);
    }
    values.put("b_separates", f64::from(lifted));
    Ok(values)
}
