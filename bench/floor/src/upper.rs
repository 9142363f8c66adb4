//! The upper plate, once the rod has left it: proofs that it is not met again.
//!
//! In the lower plate's frame, from the foot of the edge, it lies on the left, and no lower than the edge.

use crate::answer::{Prepared, Uncovered};
use crate::flight::Flight;
use crate::plate::OnEnd;
use crate::series::first_root;
use crate::strike::Strike;
use crate::tip::Tip;
use carom_num::elementary::atan2;
use carom_num::taylor::{INVERSE, spread};
use std::f64::consts::{FRAC_PI_2, PI};

fn clear(proved: bool) -> Result<(), Uncovered> {
    if proved { Ok(()) } else { Err(Uncovered::UpperPlate) }
}

/// A rod that leaves the edge keeps clear of it up to its first strike.
pub(crate) fn clear_at_first(
    drop: &Prepared,
    (at, runs_off): (&Tip, bool),
    strike: &Strike,
) -> Result<(), Uncovered> {
    // Tilt against the upper plate when the rod leaves it.
    let cos = at.cos * drop.upper.1 + at.sin * drop.upper.0;
    let sin = at.sin * drop.upper.1 - at.cos * drop.upper.0;
    let lasted = strike.lasted;
    clear(if runs_off {
        after_end(drop, at, (cos, sin), lasted)
    } else {
        over_edge((cos, sin), at.turning * lasted)
    })
}

/// The rod's line keeps over the edge, and the plate behind it, until the rod has turned by half a turn against the plate.
///
/// With x = w t the line's gap over the edge is (r + ṙ t)(sin x − x cos x) + g sin θ t² sin x/2, without a negative term for x ≤ π.
fn over_edge((cos, sin): (f64, f64), turns: f64) -> bool {
    cos > 0.0 && sin > 0.0 && turns < FRAC_PI_2 || turns + atan2(sin, cos) < PI
}

/// A rod whose trailing end has run off keeps beyond the edge until it stands square to the plate: that end only gains speed down the plate.
/// Later it keeps below the plate, where its centre is lower than half its length by then and falls.
fn after_end(drop: &Prepared, at: &Tip, (cos, sin): (f64, f64), lasted: f64) -> bool {
    let square = (FRAC_PI_2 - atan2(sin, cos)) / at.turning;
    if cos <= 0.0 || square > lasted {
        return cos > 0.0;
    }
    let rate = -at.slip * sin - at.turning * cos;
    let height = -sin + rate * square - 0.5 * drop.upper.1 * square * square;
    height < -1.0 && rate < drop.upper.1 * square
}

/// The same for a later flight: the rod stays below the edge's height, or beyond the edge.
pub(crate) fn clear_in_flight(drop: &Prepared, flight: &Flight) -> Result<(), Uncovered> {
    let up = flight.vy.max(0.0);
    let highest = flight.y + up * up / (2.0 * drop.lower.1) + 1.0;
    if highest < drop.edge_height {
        return Ok(());
    }
    let (sin, cos) = between(drop);
    let back = (flight.vx * cos - flight.vy * sin).min(0.0);
    let beyond = flight.x * cos - (flight.y - drop.edge_height) * sin - back * back / (2.0 * drop.upper.0);
    clear(beyond > 1.0)
}

/// Sine and cosine of the angle between both plates.
fn between(drop: &Prepared) -> (f64, f64) {
    let ((s, c), (sin, cos)) = (drop.upper, drop.lower);
    (s * cos + c * sin, c * cos - s * sin)
}

/// The same for a step of `t` with an end on the plate.
pub(crate) fn clear_on_plate<const P: usize>(
    drop: &Prepared,
    at: &OnEnd,
    (c, s, u): (&[f64; P], &[f64; P], &[f64; P]),
    t: f64,
) -> Result<(), Uncovered> {
    if drop.edge_height > 2.0 || 2.0 * (at.s + spread(s, t)) < drop.edge_height {
        return Ok(());
    }
    // How far both ends are beyond the edge, along the upper plate.
    let (sin, cos) = between(drop);
    let (mut near, mut far) = ([0.0; P], [0.0; P]);
    near[0] = at.x * cos + drop.edge_height * sin;
    for i in 0..P - 1 {
        near[i + 1] = u[i] * INVERSE[i] * cos;
    }
    for i in 0..P {
        far[i] = near[i] + 2.0 * (c[i] * cos - s[i] * sin);
    }
    clear(first_root(&near, t)?.is_none() && first_root(&far, t)?.is_none())
}
