//! Impacts at several contacts of a body: finite, balanced, within the cone, and without a gain of energy.

use crate::draw::{coefficient, direction, magnitude, signed};
use arbitrary::{Result, Unstructured};
use carom_impact::planar::{ContactSet6, MOST_CONTACTS, Touch, single, staged};
use carom_impact::{ImpactError, Law};
use carom_num::Vec2;

/// Residuals against the sum of their terms: rounding of a walk of some hundred stages over operators whose entries differ by powers of ten.
const CLOSE: f64 = 1e-9;
/// Most contacts of an impact here: six can be resolved, but a walk that asks a hundred times which of 46 656 hypotheses hold takes seconds.
const MOST_WALKED: usize = 4;

/// One to `most` contacts of a free body, drawn from bytes.
pub(crate) fn contact_set(u: &mut Unstructured<'_>, most: usize) -> Result<ContactSet6> {
    let mass = magnitude(u, 1e-6, 1e6)?;
    let size = magnitude(u, 1e-4, 1e3)?;
    let inertia = mass * size * size * magnitude(u, 1e-3, 1.0)?;
    let speed = magnitude(u, 1e-6, 1e3)?;
    let velocity = Vec2::new(signed(u, speed, 9)?, signed(u, speed, 9)?);
    let spin = signed(u, speed / size, 9)?;
    let count = u.int_in_range(1..=most)?;
    let (common, alike) = (coefficient(u, 1.0)?, u.arbitrary::<bool>()?);
    let mut touches = vec![];
    for _ in 0..count {
        let normal = direction(u)?;
        let aside = Vec2::new(signed(u, size, 9)?, signed(u, size, 9)?);
        touches.push(Touch {
            arm: aside,
            normal,
            friction: coefficient(u, 2.0)?,
            restitution: if alike { common } else { coefficient(u, 1.0)? },
        });
    }
    let mut set = ContactSet6::of_free_body(mass, inertia, velocity, spin, &touches)
        .map_err(|_| arbitrary::Error::IncorrectFormat)?;
    // A contact that only touches.
    for i in 0..count {
        if u.ratio(1, 4)? {
            set.normal[i] = 0.0;
        }
        if u.ratio(1, 8)? {
            set.slip[i] = 0.0;
        }
    }
    Ok(set)
}

pub(crate) fn law(u: &mut Unstructured<'_>) -> Result<Law> {
    u.choose(&[Law::Poisson, Law::Stronge, Law::Newton]).copied()
}

/// One impact: its contacts together, and the first of them alone.
pub fn impact(bytes: &[u8]) {
    let mut u = Unstructured::new(bytes);
    let Ok((law, set)) = law(&mut u).and_then(|law| Ok((law, contact_set(&mut u, MOST_WALKED)?))) else {
        return;
    };
    check_single(&set.alone(0), law);
    match staged::resolve(&set, law) {
        Ok(out) => check_staged(&set, law, &out),
        Err(error) => check_refusal(&set, &error),
    }
}

/// Numbers from a body that can be touched are inside the domain, and far from overflow. Where a contact only touches, as drawn here, its obstacle moves with the
/// body, and such obstacles can feed a load that goes in circles.
fn check_refusal(set: &ContactSet6, error: &ImpactError) {
    let named =
        matches!(error, ImpactError::Jammed | ImpactError::Unending { .. } | ImpactError::Circling { .. });
    assert!(named, "{error}: {set:?}");
}

fn check_single(contact: &single::Contact, law: Law) {
    // Where the arm is so long that the body turns about the contact alone, W_tt W_nn − W_tn² is lost in rounding.
    let Ok(out) = single::resolve(contact, law) else { return };
    let (p_t, p_n) = (out.tangential_impulse, out.normal_impulse);
    let all = [p_t, p_n, out.slip, out.normal, out.normal_work, out.tangential_work];
    assert!(all.iter().all(|x| x.is_finite()), "finite: {contact:?} {law:?} {out:?}");
    let total = p_t.abs() + p_n.abs();
    assert!(p_n >= 0.0, "pushes: {contact:?} {law:?} {out:?}");
    assert!(p_t.abs() <= contact.friction * p_n + CLOSE * total, "cone: {contact:?} {law:?} {out:?}");
    let entry = contact.w_tt.max(contact.w_nn);
    let scale = contact.slip.abs().max(contact.normal.abs()) + entry * total;
    let off_t = contact.slip + contact.w_tt * p_t + contact.w_tn * p_n - out.slip;
    let off_n = contact.normal + contact.w_tn * p_t + contact.w_nn * p_n - out.normal;
    assert!(off_t.abs().max(off_n.abs()) <= CLOSE * scale, "balance: {contact:?} {law:?} {out:?}");
    assert!(out.normal >= -CLOSE * scale, "approaches: {contact:?} {law:?} {out:?}");
    let gain = out.normal_work + out.tangential_work;
    assert!(law == Law::Newton || gain <= CLOSE * total * scale, "energy: {contact:?} {law:?} {out:?}");
}

fn check_staged(set: &ContactSet6, law: Law, out: &staged::StagedOutcome<MOST_CONTACTS>) {
    let n = set.count;
    let numbers =
        [&out.impulse, &out.velocity, &out.work].into_iter().flat_map(|of| of[..n].iter().flatten());
    assert!(numbers.clone().all(|x| x.is_finite()), "finite: {set:?} {law:?} {out:?}");
    let total: f64 = out.impulse[..n].iter().flatten().map(|p| p.abs()).sum();
    let entry = set.operator[..n].iter().flatten().fold(0.0, |m: f64, b| m.max(b.tt).max(b.nn));
    let before = set.slip[..n].iter().chain(&set.normal[..n]).fold(0.0, |m: f64, u| m.max(u.abs()));
    let scale = before + entry * total;
    for i in 0..n {
        let ([p_t, p_n], u) = (out.impulse[i], out.velocity[i]);
        assert!(p_n >= -CLOSE * total, "contact {i} pulls: {set:?} {law:?} {out:?}");
        let cone = set.friction[i] * p_n;
        assert!(p_t.abs() <= cone + CLOSE * total, "contact {i} leaves the cone: {set:?} {law:?} {out:?}");
        assert!(u[1] >= -CLOSE * scale, "contact {i} approaches: {set:?} {law:?} {out:?}");
        let mut off = [set.slip[i] - u[0], set.normal[i] - u[1]];
        for (b, [q, p]) in set.operator[i].iter().zip(out.impulse).take(n) {
            off[0] += b.tt * q + b.tn * p;
            off[1] += b.nt * q + b.nn * p;
        }
        let off = off[0].abs().max(off[1].abs());
        assert!(off <= CLOSE * scale, "balance of contact {i}: {off:e} {set:?} {law:?} {out:?}");
    }
    let gain: f64 = out.work[..n].iter().flatten().sum();
    let may_gain = out.law == Law::Newton;
    assert!(may_gain || gain <= CLOSE * total * scale, "energy {gain:e}: {set:?} {law:?} {out:?}");
    assert!(may_gain || !out.gained_energy, "says it gained energy: {set:?} {law:?} {out:?}");
}
