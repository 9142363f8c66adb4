//! Balls in a row: Newton's cradle, and a light ball on a heavy one.

use crate::failure::ValidationError;
use crate::value::Values;
use carom_impact::Law;
use carom_impact::planar::sharing::{self, Sharing};
use carom_impact::planar::{ContactSet6, Meeting, RigidBody, struck};
use carom_num::Vec2;

/// Velocities after of balls of radius 1 m in a row, by mass [kg] and velocity before [m/s]; where `wall`, the first strikes a wall behind it.
fn row(
    balls: &[[f64; 2]],
    restitution: f64,
    wall: bool,
    sharing: &Sharing<6>,
) -> Result<Vec<f64>, ValidationError> {
    let mut bodies: Vec<RigidBody> = vec![];
    let mut place = 1.0;
    for [mass, velocity] in balls {
        let (centre, velocity) = (Vec2::new(place, 0.0), Vec2::new(*velocity, 0.0));
        bodies.push(RigidBody { mass: *mass, inertia: 0.4 * mass, centre, velocity, spin: 0.0 });
        place += 2.0;
    }
    let meeting = |into: usize, out_of: usize, x: f64| Meeting {
        into,
        out_of,
        point: Vec2::new(x, 0.0),
        normal: Vec2::new(1.0, 0.0),
        friction: 0.0,
        restitution,
    };
    let mut meetings: Vec<Meeting> =
        (1..balls.len()).map(|i| meeting(i, i - 1, bodies[i].centre.x - 1.0)).collect();
    if wall {
        bodies.push(RigidBody::FIXED);
        meetings.push(meeting(0, balls.len(), 0.0));
    }
    let what = "balls in a row";
    let set = ContactSet6::of_bodies(&bodies, &meetings).map_err(|e| ValidationError::input(what, e))?;
    let out = sharing::resolve(&set, Law::Poisson, sharing).map_err(|e| ValidationError::engine(what, e))?;
    let after = struck(&bodies, &meetings, &out.impulse).map_err(|e| ValidationError::engine(what, e))?;
    Ok(after.iter().take(balls.len()).map(|ball| ball.velocity.x).collect())
}

/// Cradles of five: how many balls swing in.
const SWUNG: [usize; 3] = [1, 2, 3];
/// Rows that are struck together: balls and e.
const TOGETHER: [(usize, f64); 4] = [(2, 1.0), (3, 1.0), (5, 1.0), (4, 0.6)];

/// Newton's cradle, in sequence and together.
pub(crate) fn cradle() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for swung in SWUNG {
        let balls: Vec<[f64; 2]> = (0..5).map(|i| [1.0, if i < swung { 1.0 } else { 0.0 }]).collect();
        let after = row(&balls, 1.0, false, &Sharing::InSequence)?;
        for (i, velocity) in after.iter().enumerate() {
            values.put(format!("sequence.{swung}.{}", i + 1), *velocity);
        }
    }
    for (count, e) in TOGETHER {
        let balls: Vec<[f64; 2]> = (0..count).map(|i| [1.0, if i == 0 { 1.0 } else { 0.0 }]).collect();
        let after = row(&balls, e, false, &Sharing::Together)?;
        for (which, velocity) in [("first", after.first()), ("last", after.last())] {
            values.put(format!("together.{count}.{e}.{which}"), velocity.copied().unwrap_or(f64::NAN));
        }
    }
    Ok(values)
}

/// Masses of the lower ball by the upper one's.
const STACKS: [f64; 4] = [3.0, 5.0, 10.0, 1000.0];

/// A ball on another, dropped on the floor with 1 m/s.
pub(crate) fn stacked() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for ratio in STACKS {
        let after = row(&[[ratio, -1.0], [1.0, -1.0]], 1.0, true, &Sharing::InSequence)?;
        for (which, velocity) in [("lower", after.first()), ("upper", after.last())] {
            values.put(format!("{which}.{ratio}"), velocity.copied().unwrap_or(f64::NAN));
        }
    }
    Ok(values)
}
