//! The feeder paper's rule on which parts turn over, on 98 designs of its feeder.

use crate::failure::ValidationError;
use crate::value::Values;
use carom_feeder::{Feeder, Part, Plate, Start, Stop, Verdict};
use carom_impact::Law;
use carom_num::Vec2;
use carom_num::elementary::tan;
use carom_scene::angle_to_normal;

/// Of the paper's part [kg m²].
const PAPERS_INERTIA: f64 = 2.5e-4;

/// Slope of the upper plate [deg].
const UPPER: f64 = 15.0;
/// Slopes of the lower plate [deg]: from 2 in steps of 4.
const SLOPES: u32 = 10;
/// b of the lower plate's line x/d + y/b = 1 [cm]: from 13 in steps of 3.
const LINES: u32 = 10;
/// Two designs that the independent solution leaves out: slope and b as above.
const LEFT_OUT: [(u32, u32); 2] = [(34, 13), (38, 13)];

/// A drop, as far as rules judge it.
struct Drop {
    turned: bool,
    /// φ_K [deg].
    angle: f64,
    /// Slope of the lower plate [deg].
    slope: f64,
    /// After the impact, positive the way the part tips.
    spin: f64,
    kind: u8,
}

/// The paper's feeder with another lower plate; only the lower plate is there after release.
fn feeder(slope: f64, line_b: f64) -> Option<Feeder> {
    let x = Vec2::at_angle(-UPPER.to_radians());
    let y = x.turned_right();
    let (high, low) = (x * (line_b / tan((slope + UPPER).to_radians())), y * line_b);
    let down = (low - high).unit()?;
    let plate = |name: &str, uphill: Vec2, edge: Vec2| Plate {
        name: name.to_owned(),
        uphill,
        edge,
        friction: 0.15,
        restitution: 0.0,
        unbounded: true,
        form: Default::default(),
    };
    Some(Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Law::Poisson,
        part: Part::rod(0.1, 0.3, PAPERS_INERTIA)?,
        start: Start { to_edge: 0.1, speed: 0.0, face: 0 },
        plates: vec![
            plate("upper", x * -0.5, Vec2::ZERO),
            plate("lower", high - down * 3.0, low + down * 3.0),
        ],
        walls: vec![],
    })
}

fn drop(slope: u32, line_cm: u32) -> Result<Drop, ValidationError> {
    let what = format!("the design of {slope} deg and b = 0.{line_cm} m");
    let missing = || ValidationError::missing(format!("{what}: a strike and a landing"));
    let feeder = feeder(f64::from(slope), f64::from(line_cm) / 100.0).ok_or_else(missing)?;
    let run = feeder.run().map_err(|e| ValidationError::engine(&what, e))?;
    let strike = run.trace.impacts.first().ok_or_else(missing)?;
    let landing = run.landings.last().ok_or_else(missing)?;
    Ok(Drop {
        turned: landing.verdict == Some(Verdict::Turned),
        angle: angle_to_normal(&feeder, strike).ok_or_else(missing)?.to_degrees(),
        slope: f64::from(slope),
        // The upper plate descends to the right: the part tips clockwise.
        spin: -strike.after.spin,
        kind: strike.kind.ok_or_else(missing)?.number(),
    })
}

/// Drops the rod in every design and scores the rules.
pub(crate) fn compute() -> Result<Values, ValidationError> {
    let mut drops = vec![];
    for (i, j) in (0..SLOPES).flat_map(|i| (0..LINES).map(move |j| (i, j))) {
        let (slope, line) = (2 + 4 * i, 13 + 3 * j);
        if !LEFT_OUT.contains(&(slope, line)) {
            drops.push(drop(slope, line)?);
        }
    }
    let count = |holds: &dyn Fn(&Drop) -> bool| drops.iter().filter(|drop| holds(drop)).count() as f64;
    let right = |rule: &dyn Fn(&Drop) -> bool| count(&|drop| rule(drop) == drop.turned);
    let sevens = || drops.iter().filter(|drop| drop.kind == 7).map(|drop| drop.angle);
    let mut values = Values::default();
    values.put("designs", drops.len() as f64);
    values.put("turned", count(&|drop| drop.turned));
    values.put("rule.printed", right(&|drop| drop.angle > drop.slope));
    values.put("rule.never", right(&|_| false));
    values.put("rule.angle", right(&|drop| drop.angle > 0.0));
    values.put("rule.spin", right(&|drop| drop.spin > 0.0));
    values.put("above.type_1", count(&|d| d.angle > d.slope && d.kind != 1));
    values.put("above.spin", count(&|d| d.angle > d.slope && d.spin <= 0.0));
    values.put("below.spin", count(&|d| d.angle < 0.0 && d.spin >= 0.0));
    values.put("below.type_5", count(&|d| d.angle < 0.0 && d.kind != 5));
    values.put("band.outside", count(&|d| d.kind == 7 && !(d.angle >= 0.0 && d.angle <= d.slope)));
    values.put("band.low", sevens().fold(f64::INFINITY, f64::min));
    values.put("band.high", sevens().fold(f64::NEG_INFINITY, f64::max));
    Ok(values)
}
