//! Polygons that roll or rock on a plane: a published problem, and what was measured.

use super::blocks::rocks_over;
use super::rolling::{border, first_strike, follow, keys};
use crate::failure::ValidationError;
use crate::value::Values;
use carom_scene::{RollKind, RollReport};

/// J/(m a²) of the solid hexagon about its axis, a from there to an edge.
const SOLID: &str = "0.4166666666666667";
/// The same of a hexagonal tube with a thin wall.
const TUBE: &str = "0.8333333333333334";
/// Slope on which it rolls steadily [deg].
const SLOPE: f64 = 10.0;
/// Gravity of a roll file [m/s²].
const GRAVITY: f64 = 9.81;
/// Strikes after which its rate is steady: each brings its energy nearer by 121/289.
const STEADY: u32 = 60;

/// A hexagonal prism, 1 m from its axis to an edge, that rolls down a slope.
pub(crate) fn hexagonal_prism() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    let level = first_strike(RollKind::Prism, &hexagon(SOLID, 0.0, 1.0, 1))?;
    values.put("rate", level.roll_rate_rad_s / level.roll_rate_before_rad_s);
    values.put("energy", level.energy_after / level.energy_before);

    let steady = follow(RollKind::Prism, &hexagon(SOLID, SLOPE, 2.5, STEADY))?;
    let last = steady.strikes.last().ok_or_else(|| ValidationError::missing("a strike of the hexagon"))?;
    values.put("kappa", in_weights(last.roll_rate_before_rad_s));

    let stays = |rate: f64| Ok(!rolls_on(&follow(RollKind::Prism, &hexagon(SOLID, SLOPE, rate, 2))?, 2));
    values.put("delta", in_weights(border([0.1, 3.0], stays)?));

    let stops = |slope: f64| {
        Ok(!rolls_on(&follow(RollKind::Prism, &hexagon(SOLID, slope, 2.5, STEADY))?, STEADY as usize))
    };
    values.put("least_slope", border([1.0, 12.0], stops)?);

    // Of the pencil nothing but its faces and the slope is told: a mere length does not decide whether it stops.
    let pencil = follow(RollKind::Prism, &hexagon(TUBE, 2.0, 2.5, STEADY))?;
    values.put("pencil", if rolls_on(&pencil, STEADY as usize) { "rolls on" } else { "stops" });
    Ok(values)
}

fn hexagon(inertia_ratio: &str, slope: f64, rate: f64, strikes: u32) -> Vec<String> {
    keys(&[
        ("sides", "6".to_owned()),
        ("circumradius", "1 m".to_owned()),
        ("inertia_ratio", inertia_ratio.to_owned()),
        ("slope", format!("{slope} deg")),
        ("roll_rate", format!("{rate} rad/s")),
        ("strikes", strikes.to_string()),
    ])
}

/// Kinetic energy about an edge in units of m g a.
fn in_weights(rate: f64) -> f64 {
    0.5 * (17.0 / 12.0) * rate * rate / GRAVITY
}

/// True where it is still on its way down when the last of so many strikes comes.
fn rolls_on(run: &RollReport, strikes: usize) -> bool {
    run.strikes.len() == strikes && run.strikes.iter().all(|strike| strike.roll_rate_before_rad_s > 0.0)
}

/// Height by width of the measured blocks.
const ASPECTS: [u32; 2] = [3, 5];

/// What a change of corner leaves of the roll rate, by what Housner's formula leaves.
pub(crate) fn rocking_measured() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for aspect in ASPECTS {
        let strike = rocks_over(1.0, f64::from(aspect))?;
        let ours = strike.roll_rate_rad_s / strike.roll_rate_before_rad_s;
        // 1 − 3/2 sin² α with tan α = 1/aspect: what the measured rates were divided by.
        let housner = 1.0 - 1.5 / f64::from(1 + aspect * aspect);
        values.put(format!("concrete.{aspect}"), ours / housner);
        if aspect == 5 {
            values.put("rubber.5", ours / housner);
        }
    }
    Ok(values)
}
