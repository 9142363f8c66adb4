//! One contact with friction: Painlevé's rod, and what Newton's law does to energy.

use super::rolling::border;
use crate::failure::ValidationError;
use crate::value::Values;
use carom_impact::Law;
use carom_impact::Load;
use carom_impact::planar::rate::RateProblem;
use carom_impact::planar::single::{Contact, Outcome, resolve};
use carom_impact::planar::{ContactSet2, Touch};
use carom_num::Vec2;

/// A uniform slender rod of 2 m and 1 kg: J = 1/3 kg m².
const INERTIA: f64 = 1.0 / 3.0;
/// Gravity [m/s²]: which one does not matter to what is asked.
const GRAVITY: f64 = 10.0;
/// tan of the rod's angle to the plate.
const LEANS: [f64; 4] = [1.0, 2.0, 3.0, 4.0];
/// Angles between which the worst is looked for, and how many.
const ANGLES: u32 = 200;

/// The rod's end, its mass centre above it at this lean.
fn end(lean: f64, friction: f64) -> Touch {
    let along = Vec2::new(1.0, lean) / (1.0 + lean * lean).sqrt();
    Touch { arm: -along, normal: Vec2::new(0.0, 1.0), friction, restitution: 0.0 }
}

fn set(lean: f64, friction: f64, velocity: Vec2) -> Result<ContactSet2, ValidationError> {
    ContactSet2::of_free_body(1.0, INERTIA, velocity, 0.0, &[end(lean, friction)])
        .map_err(|e| ValidationError::input("the rod on its end", e))
}

/// Motions that rigid-body mechanics allows the rod whose end slips under its mass centre, so that friction digs it in.
fn motions(lean: f64, friction: f64) -> Result<usize, ValidationError> {
    let set = set(lean, friction, Vec2::ZERO)?;
    let problem = RateProblem::<2, 4> {
        count: 1,
        operator: &set.operator,
        friction: &set.friction,
        drive: [[0.0, -GRAVITY], [0.0; 2]],
        slip: [-1.0, 0.0],
        load: [Load::Touching(0.0), Load::Absent],
    };
    Ok(problem.solve().count)
}

/// Friction from which the rod has no motion at this lean.
fn critical(lean: f64) -> Result<f64, ValidationError> {
    border([0.5, 50.0], |friction| Ok(motions(lean, friction)? > 0))
}

/// Painlevé's paradox of a rod that slides on its end.
pub(crate) fn painleve() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for lean in LEANS {
        values.put(format!("friction.{lean}"), critical(lean)?);
    }
    let mut least = f64::INFINITY;
    for i in 0..ANGLES {
        // From tan 1 to tan 3, both ends and 2 included.
        least = least.min(critical(1.0 + 2.0 * f64::from(i) / f64::from(ANGLES))?);
    }
    values.put("friction.least", least);
    let beyond = set(1.0, 1.7, Vec2::new(-1.0, 0.0))?;
    let outcome = strike(&beyond.alone(0), Law::Poisson)?;
    let what = if outcome.without_approach { "an impact without approach" } else { "no impact" };
    values.put("beyond", what);
    values.put("beyond.slip", outcome.slip);
    values.put("beyond.impulse", outcome.normal_impulse);
    let below = set(1.0, 1.6, Vec2::new(-1.0, 0.0))?;
    let outcome = strike(&below.alone(0), Law::Poisson)?;
    values.put("below", if outcome.without_approach { "an impact without approach" } else { "no impact" });
    Ok(values)
}

fn strike(contact: &Contact, law: Law) -> Result<Outcome, ValidationError> {
    resolve(contact, law).map_err(|e| ValidationError::engine("the rod's strike", e))
}

/// Slips before, where the rod comes down with 1 m/s at 45°; friction enough to stick.
const SLIPS: [f64; 3] = [0.4, 0.8, 1.4];
const STICKING: f64 = 2.0;

/// Kinetic energy that a rod gains or loses by its strike, under each law with e = 1.
pub(crate) fn energy() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for slip in SLIPS {
        let set = set(1.0, STICKING, Vec2::new(slip, -1.0))?;
        let contact = Contact { restitution: 1.0, ..set.alone(0) };
        for (law, name) in [(Law::Newton, "newton"), (Law::Poisson, "poisson"), (Law::Stronge, "stronge")] {
            let outcome = strike(&contact, law)?;
            let change = outcome.normal_work + outcome.tangential_work;
            if law == Law::Newton {
                values.put(format!("change.{slip}"), change);
            }
            values.put(format!("gains.{name}.{slip}"), if change > 0.0 { "gains" } else { "does not gain" });
        }
    }
    Ok(values)
}
