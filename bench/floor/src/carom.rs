//! The same drop for Carom.

use crate::answer::{Design, GRAVITY};
use carom_feeder::{Feeder, Outcome, Part, Plate, Prepared, RunError, Start, Stop, Verdict};
use carom_impact::Law;
use carom_motion::planar::Options;
use carom_num::Vec2;

use crate::answer::{Answer, Landing};

impl Design {
    /// The feeder of this drop: both plates are there to the end. `None` where the numbers are no part.
    pub fn feeder(&self) -> Option<Feeder> {
        let x = Vec2::at_angle(-self.upper_slope);
        let down = -Vec2::at_angle(self.lower_slope);
        let low = x.turned_right() * self.line_b;
        let plate = |name: &str, uphill: Vec2, edge: Vec2| Plate {
            name: name.into(),
            uphill,
            edge,
            friction: self.friction,
            restitution: 0.0,
            unbounded: true,
            form: Default::default(),
        };
        Some(Feeder {
            gravity: GRAVITY,
            stop: Stop::Landed,
            law: Law::Poisson,
            part: Part::rod(0.1, 0.3, 2.5e-4)?,
            start: Start { to_edge: self.to_edge, speed: 0.0, face: 0 },
            plates: vec![
                plate("upper", -x * (self.to_edge + 0.4), Vec2::ZERO),
                plate("lower", low - down * 5.0, low + down * 5.0),
            ],
            walls: vec![],
        })
    }
}

/// What Carom says of a drop, in the floor's words; `None` where it neither lands on the lower plate nor is stuck.
///
/// # Errors
/// As [`Prepared::run_untraced`].
pub fn answer(feeder: &Prepared<'_>) -> Result<Option<Answer>, RunError> {
    let run = feeder.run_untraced()?;
    let landing = run.landings.last().filter(|landing| landing.plate == 1);
    Ok(match (run.outcome, landing.map(|l| (l, l.verdict, l.flat))) {
        (Outcome::Landed, Some((landing, Some(verdict), Some(flat)))) => Some(Answer::Lands(Landing {
            turned: verdict == Verdict::Turned,
            first_touch: landing.first_touch,
            impact_speed: landing.impact_speed,
            flat,
        })),
        (Outcome::Stuck, _) if run.landings.is_empty() => Some(Answer::Stuck),
        _ => None,
    })
}

/// Carom's options at this tolerance.
pub fn options(tolerance: f64) -> Options {
    Options { tolerance, ..Options::default() }
}
