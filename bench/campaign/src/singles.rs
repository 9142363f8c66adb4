//! Impacts at one contact.

use crate::draw;
use crate::tally::{Tally, kind_of};
use carom_impact::Law;
use carom_impact::planar::{ContactSet2, ImpactType, single};
use carom_num::Vec2;
use rand::RngExt;

/// Residuals against the sum of their terms.
const CLOSE: f64 = 1e-11;

/// One case: a random body at one contact.
pub(crate) fn case(seed: u64, number: u64, tally: &mut Tally) {
    let rng = &mut draw::numbers(seed, number);
    let body = draw::slender(rng);
    let touch = draw::touch(rng, &body);
    let velocity = Vec2::new(draw::speed(rng), draw::speed(rng));
    let spin = draw::speed(rng) / body.half.x;
    let Ok(set) = ContactSet2::of_free_body(body.mass, body.inertia, velocity, spin, &[touch]) else {
        return tally.breaks("a body that is none", number);
    };
    let mut contact = set.alone(0);
    if rng.random_bool(0.1) {
        contact.slip = 0.0;
    }
    if rng.random_bool(0.05) {
        contact.normal = 0.0;
    }
    let law = if rng.random_bool(0.2) { Law::Newton } else { draw::law(rng) };
    match single::resolve(&contact, law) {
        Err(error) => tally.count(format!("refused: {}", kind_of(&error.to_string()))),
        Ok(out) => {
            tally.count(format!("{law:?}, {}", named(out.kind)));
            judge(&contact, law, &out, (number, tally));
        }
    }
}

fn named(kind: Option<ImpactType>) -> String {
    kind.map_or("nothing happens".to_owned(), |kind| format!("type {}", kind.number()))
}

fn judge(c: &single::Contact, law: Law, out: &single::Outcome, (number, tally): (u64, &mut Tally)) {
    let (q, p) = (out.tangential_impulse, out.normal_impulse);
    let push = q.abs() + p.abs();
    let velocity = c.slip.abs() + c.normal.abs() + out.slip.abs() + out.normal.abs();
    let scale = velocity + (c.w_tt + c.w_nn) * push;
    if scale == 0.0 {
        return;
    }
    let slip = (c.slip + c.w_tt * q + c.w_tn * p - out.slip).abs() / scale;
    let normal = (c.normal + c.w_tn * q + c.w_nn * p - out.normal).abs() / scale;
    tally.residual("momentum", slip.max(normal), CLOSE, number);
    if push > 0.0 {
        tally.residual("a pull", -p / push, CLOSE, number);
        tally.residual(
            "beyond the cone",
            (q.abs() - c.friction * p) / (push * (1.0 + c.friction)),
            CLOSE,
            number,
        );
    }
    if c.normal <= 0.0 {
        tally.residual("still approaching", -out.normal / scale, CLOSE, number);
    }
    if law != Law::Newton {
        let work = out.normal_work + out.tangential_work;
        // The work is the change of kinetic energy: against the largest that the impulses do.
        let terms = push * velocity;
        tally.residual("energy gained", if terms > 0.0 { work / terms } else { 0.0 }, CLOSE, number);
    }
}
