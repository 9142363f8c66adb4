//! Impacts at two to four contacts at once.

use crate::draw;
use crate::tally::{Tally, kind_of};
use carom_impact::ImpactError;
use carom_impact::planar::{ContactSet6, Touch, staged};
use carom_num::Vec2;
use carom_theory::wedging::{PushedPoint, least_wrench};
use rand::RngExt;

/// Residuals against the sum of their terms.
const CLOSE: f64 = 1e-9;

/// Wrench per push below which a load holds itself but for rounding.
const HOLDS_ITSELF: f64 = 1e-12;

/// One case: a random body at several contacts.
pub(crate) fn case(seed: u64, number: u64, tally: &mut Tally) {
    let rng = &mut draw::numbers(seed, number);
    let body = draw::slender(rng);
    let count = rng.random_range(2..5);
    let touches: Vec<Touch> = (0..count).map(|_| draw::touch(rng, &body)).collect();
    let velocity = Vec2::new(draw::speed(rng), draw::speed(rng));
    let spin = draw::speed(rng) / body.half.x;
    let Ok(mut set) = ContactSet6::of_free_body(body.mass, body.inertia, velocity, spin, &touches) else {
        return tally.breaks("a body that is none", number);
    };
    // A contact that moves away takes no part, but it may: every other one only touches.
    for normal in &mut set.normal[..count] {
        if rng.random_bool(0.25) {
            *normal = 0.0;
        }
    }
    let law = draw::law(rng);
    match staged::resolve(&set, law) {
        Err(ImpactError::Jammed) => {
            let least = least_wrench(&touches.iter().map(pushed).collect::<Vec<_>>(), gyration(&body));
            let held = if least < HOLDS_ITSELF { "a load holds itself" } else { "none does" };
            tally.count(format!("{count} contacts, refused: jammed, {held}"));
        }
        Err(error) => tally.count(format!("{count} contacts, refused: {}", kind_of(&error.to_string()))),
        Ok(out) => {
            let how = if out.branches > 1 { "several ways on" } else { "one way on" };
            tally.count(format!("{count} contacts, {law:?}, {how}"));
            judge(&set, &out, (number, tally));
        }
    }
}

fn pushed(touch: &Touch) -> PushedPoint {
    let [arm, normal] = [touch.arm, touch.normal].map(|v| [v.x, v.y]);
    PushedPoint { arm, normal, friction: touch.friction }
}

/// The body's radius of gyration.
fn gyration(body: &draw::Box2) -> f64 {
    (body.inertia / body.mass).sqrt()
}

fn judge(set: &ContactSet6, out: &staged::StagedOutcome<6>, (number, tally): (u64, &mut Tally)) {
    let n = set.count;
    let push: f64 = out.impulse[..n].iter().flatten().map(|p| p.abs()).sum();
    let entry =
        set.operator[..n].iter().flat_map(|row| &row[..n]).fold(0.0, |m: f64, b| m.max(b.tt).max(b.nn));
    let before = set.slip[..n].iter().chain(&set.normal[..n]);
    let velocity: f64 = before.chain(out.velocity[..n].iter().flatten()).map(|u| u.abs()).sum();
    // What impulses do may cancel: residuals are compared with all that was in play, not with what is left of it.
    let scale = velocity + entry * push;
    let mut work = 0.0;
    for i in 0..n {
        let ([q, p], [slip, normal]) = (out.impulse[i], out.velocity[i]);
        let (mut along, mut across) = (set.slip[i], set.normal[i]);
        for (b, [q, p]) in set.operator[i].iter().zip(&out.impulse).take(n) {
            along += b.tt * q + b.tn * p;
            across += b.nt * q + b.nn * p;
        }
        tally.residual("momentum", (along - slip).abs().max((across - normal).abs()) / scale, CLOSE, number);
        if push > 0.0 {
            tally.residual("a pull", -p / push, CLOSE, number);
            let beyond = (q.abs() - set.friction[i] * p) / (push * (1.0 + set.friction[i]));
            tally.residual("beyond the cone", beyond, CLOSE, number);
        }
        if set.normal[i] <= 0.0 {
            tally.residual("still approaching", -normal / scale, CLOSE, number);
        }
        work += out.work[i][0] + out.work[i][1];
    }
    if push > 0.0 {
        tally.residual("energy gained", work / (push * velocity), CLOSE, number);
    }
}
