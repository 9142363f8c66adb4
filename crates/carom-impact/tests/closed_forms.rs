//! One contact: the walk against the closed forms, over a million random contacts, more than a third of them on or beside a boundary, each under
//! every law.
//!
//! *Scales.* A rounding of the data moves an impulse by `condition` times as much (denominators cancel near Painlevé's case, near a
//! slip that is not braked and near a singular operator). So impulses are compared relative to `condition · p_n` (`· max(1, μ)` along
//! t), velocities relative to `condition` × the sum of the magnitudes of their terms, and works relative to the product of the two.
//! Where a contact lies within rounding of a boundary, the two sides may take it for the two types that meet there; impulses are
//! continuous across it, and the condition that counts is that of both types together.

use carom_impact::Law;
use carom_impact::planar::{Class, ContactState, ImpactType, single};
use carom_num::elementary::pow;
use carom_theory::single_contact as theory;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

const CONTACTS: usize = 1_000_000;
/// Largest difference that rounding may make, on the scales above.
const AGREEMENT: f64 = 1e-12;
/// Types are compared where the deciding inequality is farther than this from its boundary.
const DECIDED: f64 = 1e-12;
const LAWS: [(Law, theory::Law); 3] = [
    (Law::Poisson, theory::Law::Poisson),
    (Law::Stronge, theory::Law::Stronge),
    (Law::Newton, theory::Law::Newton),
];
/// The class of Wang and Mason that each type of Plavnieks is.
const CLASSES: [Class; 7] = [
    Class::Sliding,
    Class::SlidingFromRest,
    Class::Sticking,
    Class::RReversed,
    Class::CReversed,
    Class::RSticking,
    Class::CSticking,
];

fn sign(rng: &mut Pcg64) -> f64 {
    if rng.random_bool(0.5) { 1.0 } else { -1.0 }
}

fn decades(rng: &mut Pcg64, low: f64, high: f64) -> f64 {
    pow(10.0, rng.random_range(low..high))
}

/// 1 + a relative distance to a boundary: none one time in six, else 1e-16 to 0.1 on either side.
fn beside(rng: &mut Pcg64) -> f64 {
    if rng.random_range(0..6) == 0 { 1.0 } else { 1.0 + sign(rng) * decades(rng, -16.0, -1.0) }
}

/// The operator of a free body, of a slender one (m r²/J up to 2000), or any that is positive definite, nearly singular ones included.
fn operator(rng: &mut Pcg64) -> theory::Operator {
    let (t, n) = (rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
    let free = |inertia: f64| theory::Operator {
        tt: 1.0 + n * n / inertia,
        tn: -t * n / inertia,
        nn: 1.0 + t * t / inertia,
    };
    match rng.random_range(0..5) {
        0 | 1 => free(rng.random_range(0.05..1.0)),
        2 => free(decades(rng, -3.3, -1.0)),
        kind => {
            let (tt, nn) = (decades(rng, -3.0, 3.0), decades(rng, -3.0, 3.0));
            let coupled = if kind == 3 { rng.random_range(0.0..1.0) } else { 1.0 - decades(rng, -9.0, -1.0) };
            theory::Operator { tt, nn, tn: sign(rng) * coupled * (tt * nn).sqrt() }
        }
    }
}

/// A contact with nothing special.
fn ordinary(rng: &mut Pcg64) -> theory::Contact {
    theory::Contact {
        w: operator(rng),
        slip: sign(rng) * decades(rng, -2.0, 1.0),
        approach: -decades(rng, -2.0, 1.0),
        friction: rng.random_range(0.0..3.0),
        restitution: rng.random_range(0.0..1.0),
    }
}

/// Moves an ordinary contact to a boundary, or beside it; two contacts in nine stay as they are.
fn contact(rng: &mut Pcg64) -> theory::Contact {
    let mut c = ordinary(rng);
    let mu_s = (c.w.tn / c.w.tt).abs();
    let beyond = beside(rng);
    match rng.random_range(0..9) {
        // The cone boundary, and on it any of the others.
        0 | 7 if mu_s < 3.0 => c.friction = mu_s * beyond,
        // Painlevé: W_nn = sμW_tn.
        1 if c.w.nn < 3.0 * c.w.tn.abs() => {
            c.friction = c.w.nn / c.w.tn.abs() * beyond;
            c.slip = c.slip.abs() * c.w.tn.signum();
            c.approach *= [0.0, 1.0][rng.random_range(0..2)];
        }
        2 => c.slip = 0.0,
        3 => c.approach = 0.0,
        4 => c.approach *= decades(rng, -15.0, 0.0),
        5 => c.slip *= decades(rng, -15.0, 0.0),
        6 => c.restitution = if rng.random_bool(0.5) { 0.0 } else { 1.0 },
        _ => {}
    }
    // Class boundaries: P_d = P_q, or P_d = (1 + e) P_q.
    let s = if c.slip == 0.0 { 0.0 } else { c.slip.signum() };
    let (a1, k) = (c.w.nn - s * c.friction * c.w.tn, c.friction * c.w.tt - s * c.w.tn);
    let ratio = k * -c.approach / a1;
    if rng.random_bool(0.6) && s != 0.0 && ratio > 0.0 && ratio.is_finite() {
        let factor = if rng.random_bool(0.5) { 1.0 } else { 1.0 + c.restitution };
        c.slip = s * ratio * factor * beside(rng);
    }
    if rng.random_range(0..50) == 0 {
        c.friction = 0.0;
    }
    c
}

fn engine(c: &theory::Contact) -> single::Contact {
    single::Contact {
        w_tt: c.w.tt,
        w_tn: c.w.tn,
        w_nn: c.w.nn,
        slip: c.slip,
        normal: c.approach,
        friction: c.friction,
        restitution: c.restitution,
    }
}

/// The conditions of all denominators that the two types at a boundary may use.
fn widest_condition(c: &theory::Contact, numbers: &theory::Numbers) -> f64 {
    let (mu, coupling) = (c.friction, c.w.tn.abs());
    let (normal_terms, slip_terms) = (c.w.nn + mu * coupling, mu * c.w.tt + coupling);
    let first = normal_terms / numbers.normal_response.abs();
    let stop = slip_terms / numbers.slip_response.abs();
    let sticks = (c.w.tt * c.w.nn + coupling * coupling) / c.w.determinant();
    let slips = normal_terms / (c.w.nn - mu * coupling).abs();
    // A slip that is not braked has no stop, and a cone that holds no second leg that slips.
    let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
    finite(first) + finite(stop) + finite(sticks) + finite(slips)
}

/// What Stronge's law adds where the slip stops in compression: the root of a work that, for a contact that grazes in Painlevé's case,
/// is as small as W_nn − sμW_tn is against its terms.
fn root_condition(c: &theory::Contact, exact: &theory::Impact) -> f64 {
    let numbers = &exact.numbers;
    let Some(stop) = exact.slip_stop_impulse.filter(|&p| p <= exact.compression_impulse) else {
        return 0.0;
    };
    let sticks = exact.kind.is_some_and(|k| k.sticks());
    let coupling = c.friction * c.w.tn.abs();
    let last = if sticks { c.w.determinant() / c.w.tt } else { c.w.nn - coupling };
    let at_stop = (numbers.p_d - numbers.p_q) / numbers.slip_response;
    let work = last * stop * (c.approach.abs() + at_stop.abs());
    (c.w.nn + coupling) * stop / work.sqrt()
}

/// What is compared, for the report of the worst.
const COMPARED: [&str; 6] =
    ["normal impulse", "tangential impulse", "slip", "normal velocity", "normal work", "tangential work"];

/// The differences, each on its scale.
fn residuals(c: &theory::Contact, ours: &single::Outcome, exact: &theory::Impact) -> [f64; 6] {
    let mut condition = if exact.numbers.margin > DECIDED {
        exact.numbers.condition
    } else {
        widest_condition(c, &exact.numbers)
    };
    if exact.law == theory::Law::Stronge {
        condition += root_condition(c, exact);
    }
    let (slip_scale, normal_scale) = exact.velocity_scale(c);
    let normal = exact.normal_impulse;
    let along = c.friction.max(1.0) * normal;
    let normal_work = exact.work.compression + exact.work.restitution;
    let pairs = [
        (ours.normal_impulse, exact.normal_impulse, normal),
        (ours.tangential_impulse, exact.tangential_impulse, along),
        (ours.slip, exact.slip_after, slip_scale),
        (ours.normal, exact.normal_velocity_after, normal_scale),
        (ours.normal_work, normal_work, normal_scale * normal),
        (ours.tangential_work, exact.work.tangential, slip_scale * along),
    ];
    pairs.map(|(a, b, scale)| if a == b { 0.0 } else { (a - b).abs() / (scale * condition) })
}

fn assert_same_kind(c: &theory::Contact, law: Law, ours: &single::Outcome, exact: &theory::Impact) {
    let (kind, class) = (ours.kind.map(ImpactType::number), ours.kind.map(ImpactType::class));
    let expected = exact.kind.map(|k| k.number());
    assert_eq!(kind, expected, "type: {law:?} {c:?}\n{ours:?}\n{exact:?}");
    assert_eq!(class, expected.map(|n| CLASSES[usize::from(n) - 1]), "class: {law:?} {c:?}");
    assert_eq!(ours.without_approach, expected.is_some() && c.approach == 0.0, "{law:?} {c:?}");
}

fn assert_same_energy_flag(c: &theory::Contact, law: Law, ours: &single::Outcome, exact: &theory::Impact) {
    let work = &exact.work;
    let terms = work.compression.abs() + work.restitution + work.tangential.abs();
    let gain = work.energy_change();
    if gain.abs() > AGREEMENT * exact.numbers.condition * terms {
        assert_eq!(ours.gained_energy, gain > 0.0, "energy: {law:?} {c:?}\n{ours:?}\n{exact:?}");
    } else {
        assert!(law == Law::Newton || !ours.gained_energy, "energy is kept: {law:?} {c:?}\n{ours:?}");
    }
}

/// What the contact does at the end is what its velocity says, and its type: one that comes to rest or stays there sticks, unless it separates.
fn assert_state_of_velocity(c: &theory::Contact, law: Law, ours: &single::Outcome) {
    let agrees = match ours.state {
        ContactState::Separates => ours.normal > 0.0,
        ContactState::Sticks => ours.normal <= 0.0 && ours.slip == 0.0,
        ContactState::Slips => ours.normal <= 0.0,
    };
    let rests = [ImpactType::SticksFromRest, ImpactType::StopsInRestitution, ImpactType::StopsInCompression];
    let sticks = ours.normal <= 0.0 && ours.kind.is_some_and(|kind| rests.contains(&kind));
    assert!(agrees && (!sticks || ours.state == ContactState::Sticks), "state: {law:?} {c:?}\n{ours:?}");
}

#[test]
#[allow(clippy::print_stdout, reason = "the counts show that every type and every boundary is met")]
fn a_million_contacts_meet_their_closed_forms() {
    let mut rng = Pcg64::seed_from_u64(1992);
    let (mut kinds, mut special, mut jumps) = ([0usize; 8], 0usize, 0usize);
    let mut worst = [0.0f64; 6];
    for _ in 0..CONTACTS {
        let c = contact(&mut rng);
        for (law, theory_law) in LAWS {
            let exact = theory::resolve(&c, theory_law).unwrap();
            let ours = single::resolve(&engine(&c), law).unwrap();
            if law == Law::Poisson {
                kinds[exact.kind.map_or(0, |k| usize::from(k.number()))] += 1;
                special += usize::from(exact.numbers.margin < 1e-3 || c.slip == 0.0 || c.approach == 0.0);
            }
            if exact.numbers.margin > DECIDED {
                assert_same_kind(&c, law, &ours, &exact);
            } else if ours.kind.is_some() != exact.kind.is_some() {
                // A grazing contact within rounding of Painlevé's boundary: the impulse jumps there.
                assert_eq!(c.approach, 0.0, "only grazing contacts jump: {law:?} {c:?}");
                jumps += 1;
                continue;
            }
            let residuals = residuals(&c, &ours, &exact);
            for (k, residual) in residuals.into_iter().enumerate() {
                assert!(
                    residual <= AGREEMENT,
                    "{} {residual}: {law:?} {c:?}\n{ours:?}\n{exact:?}",
                    COMPARED[k]
                );
                worst[k] = worst[k].max(residual);
            }
            assert_same_energy_flag(&c, law, &ours, &exact);
            assert_state_of_velocity(&c, law, &ours);
        }
    }
    println!("types (0: nothing happens) {kinds:?}, on or beside a boundary {special}, on a jump {jumps}");
    println!("worst scaled differences: {COMPARED:?} {worst:?}");
    assert!(kinds.iter().all(|&n| n > CONTACTS / 200), "every type is met: {kinds:?}");
    assert!(special > CONTACTS / 3, "boundaries are met: {special}");
}
