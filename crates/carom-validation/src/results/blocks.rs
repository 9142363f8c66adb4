//! Housner's rocking block and McGeer's rimless wheel.

use super::rolling::{first_strike, follow, keys};
use crate::failure::ValidationError;
use crate::value::Values;
use carom_num::elementary::sin_cos;
use carom_scene::{RollKind, RollStrikeReport};

/// The block's slenderness, α = atan(width/height) [deg].
const SLENDERNESS: [u32; 8] = [5, 10, 15, 20, 30, 45, 50, 60];
/// From a corner to the mass centre [m].
const REACH: f64 = 1.0;

/// A uniform block that rocks over from one corner to the other without sliding.
pub(crate) fn housner() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for alpha in SLENDERNESS {
        let (width, height) = sin_cos(f64::from(alpha).to_radians());
        let strike = rocks_over(REACH * width, REACH * height)?;
        let ratio = strike.roll_rate_rad_s / strike.roll_rate_before_rad_s;
        values.put(format!("rate.{alpha}"), ratio);
        values.put(format!("energy.{alpha}"), strike.energy_after / strike.energy_before);
    }
    Ok(values)
}

/// The first change of corner of a uniform block of that half width and half height \[m\], which turns at 1 rad/s.
pub(crate) fn rocks_over(width: f64, height: f64) -> Result<RollStrikeReport, ValidationError> {
    first_strike(
        RollKind::Prism,
        &keys(&[
            ("a_to_centre", format!("{width} m")),
            ("centre_to_k", format!("{width} m")),
            ("height", format!("{height} m")),
            ("roll_rate", "1 rad/s".to_owned()),
        ]),
    )
}

/// Spokes of the wheels, and their j = J/(m a²).
const WHEELS: [(u32, &str); 5] = [(8, "0.05"), (6, "0.5"), (8, "0.25"), (10, "0.5"), (12, "0.5")];
/// Steps after which a wheel's rate is steady: each brings it nearer by the square of the ratio.
const STEPS: u32 = 400;
/// Slope down which they roll on [deg].
const SLOPE: &str = "8 deg";

/// A wheel of spokes without a rim, on the level and down a slope.
pub(crate) fn rimless_wheel() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for (spokes, j) in WHEELS {
        let shape = [
            ("sides", spokes.to_string()),
            ("inertia_ratio", j.to_owned()),
            ("circumradius", "1 m".to_owned()),
        ];
        let level = first_strike(RollKind::Prism, &keys(&shape))?;
        let ratio = level.roll_rate_rad_s / level.roll_rate_before_rad_s;
        values.put(format!("ratio.{spokes}.{j}"), ratio);
        let more = [
            ("slope", SLOPE.to_owned()),
            ("strikes", STEPS.to_string()),
            ("roll_rate", "4 rad/s".to_owned()),
        ];
        let down = follow(RollKind::Prism, &keys(&[&shape[..], &more[..]].concat()))?;
        let last = down.strikes.last().ok_or_else(|| ValidationError::missing("a step of the wheel"))?;
        values.put(format!("steady.{spokes}.{j}"), last.roll_rate_before_rad_s);
    }
    Ok(values)
}
