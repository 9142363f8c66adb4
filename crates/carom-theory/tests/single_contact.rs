//! The closed forms of one contact against a walk from event to event with twice the digits.

use crate::oracle;

use carom_theory::single_contact::{Contact, Impact, ImpactType, Law, Operator, resolve};
use oracle::Stream;
use oracle::walk::{Walked, walk};

const LAWS: [Law; 3] = [Law::Poisson, Law::Stronge, Law::Newton];
const SEED: u64 = 1969;

/// Largest residual allowed anywhere, relative to impulses and velocities as the documentation scales them.
const RESIDUAL: f64 = 1e-12;

/// Residual allowed per unit of `condition`, away from the boundaries: some ten roundings.
const ROUNDING: f64 = 2e-15;

/// Closer to a boundary than this the walk may find the other type, whose condition is another.
const BOUNDARY: f64 = 1e-12;

/// A free body of any slenderness struck anywhere.
fn random_contact(stream: &mut Stream) -> Contact {
    let (mass, inertia) = (stream.decades(-2.0, 2.0), stream.decades(-3.0, 1.0));
    let (r_t, r_n) = (stream.within(-1.0, 1.0), stream.within(-1.0, 1.0));
    let turning = mass * inertia;
    let w = Operator {
        tt: 1.0 / mass + r_n * r_n / turning,
        tn: -r_t * r_n / turning,
        nn: 1.0 / mass + r_t * r_t / turning,
    };
    Contact {
        w,
        slip: stream.sign() * stream.decades(-3.0, 2.0) * stream.one_of([0.0, 1.0, 1.0, 1.0]),
        approach: -stream.decades(-2.0, 1.0),
        friction: stream.within(0.0, 2.0) * stream.one_of([0.0, 0.2, 1.0, 1.0]),
        restitution: stream.one_of([0.0, 1.0, stream.0 as f64 / u64::MAX as f64]),
    }
}

/// The same contact, moved next to a boundary between two classes.
fn next_to_a_boundary(stream: &mut Stream, contact: Contact) -> Contact {
    let off = 1.0 + stream.sign() * stream.decades(-16.5, -1.0);
    let mut moved = contact;
    if moved.slip == 0.0 {
        moved.slip = stream.sign();
    }
    let numbers = resolve(&moved, Law::Poisson).expect("in the domain").numbers;
    match stream.bits() % 4 {
        0 => moved.friction = off * numbers.mu_s.abs(),
        1 if contact.w.tn != 0.0 => {
            moved.friction = off * contact.w.nn / contact.w.tn.abs();
            moved.slip = moved.slip.abs() * contact.w.tn.signum();
        }
        choice => {
            let whole = if choice == 2 { 1.0 } else { 1.0 + contact.restitution };
            let p_s = whole * moved.approach.abs() / numbers.normal_response;
            let slip = off * p_s * numbers.slip_response;
            if slip > 0.0 && slip.is_finite() {
                moved.slip = slip * moved.slip.signum();
            }
        }
    }
    moved
}

/// The largest residual of an impact against the walk, scaled as the documentation says.
fn residual(contact: &Contact, impact: &Impact, walked: &Walked) -> f64 {
    let p_n = walked.normal.value();
    if impact.kind.is_none() {
        return if p_n == 0.0 && impact.normal_impulse == 0.0 { 0.0 } else { f64::INFINITY };
    }
    let (slip_scale, rise_scale) = impact.velocity_scale(contact);
    let mu = contact.friction.max(1.0);
    let work_scale = p_n * (rise_scale + contact.friction * slip_scale);
    let work = &impact.work;
    [
        (impact.normal_impulse - p_n) / p_n,
        (impact.tangential_impulse - walked.tangential.value()) / (mu * p_n),
        (impact.slip_after - walked.slip.value()) / slip_scale,
        (impact.normal_velocity_after - walked.rise.value()) / rise_scale,
        (work.compression - walked.work[0].value()) / work_scale,
        (work.restitution - walked.work[1].value()) / work_scale,
        (work.tangential - walked.work[2].value()) / work_scale,
    ]
    .into_iter()
    .fold(0.0, |worst, r: f64| if r.is_nan() { f64::INFINITY } else { worst.max(r.abs()) })
}

/// Runs `count` cases under every law, and returns the largest residual and how often each type came.
fn compare(count: usize, mut case: impl FnMut() -> Contact) -> (f64, [usize; 8]) {
    let (mut worst, mut types) = (0.0f64, [0; 8]);
    for _ in 0..count {
        let contact = case();
        for law in LAWS {
            let impact = resolve(&contact, law).expect("in the domain");
            let here = residual(&contact, &impact, &walk(&contact, law));
            let numbers = &impact.numbers;
            let on_boundary = numbers.margin < BOUNDARY;
            assert!(here <= RESIDUAL, "{here:e} under {law:?}: {contact:?}\n{impact:?}");
            assert!(
                on_boundary || here <= ROUNDING * numbers.condition,
                "{here:e} under {law:?}: {contact:?}\n{impact:?}"
            );
            worst = worst.max(here);
            types[impact.kind.map_or(0, |k| usize::from(k.number()))] += 1;
        }
    }
    (worst, types)
}

#[test]
fn every_type_agrees_with_the_walk_on_random_bodies() {
    let mut stream = Stream(SEED);
    let (worst, types) = compare(150_000, || random_contact(&mut stream));
    assert!(types[1..].iter().all(|&n| n > 1000), "every type is met: {types:?}, worst {worst:e}");
}

#[test]
fn impulses_keep_their_digits_next_to_every_boundary() {
    let mut stream = Stream(SEED + 1);
    let (worst, types) = compare(150_000, || {
        let contact = random_contact(&mut stream);
        next_to_a_boundary(&mut stream, contact)
    });
    let slipping = [1, 4, 5, 6, 7];
    assert!(slipping.iter().all(|&k| types[k] > 1000), "{types:?}, worst {worst:e}");
}

#[test]
fn condition_bounds_what_very_slender_bodies_lose() {
    let mut stream = Stream(SEED + 5);
    let mut ill = 0;
    for _ in 0..100_000 {
        let (inertia, r_t, r_n) =
            (stream.decades(-9.0, -2.0), stream.within(-1.0, 1.0), stream.within(-1.0, 1.0));
        let w = Operator {
            tt: 1.0 + r_n * r_n / inertia,
            tn: -r_t * r_n / inertia,
            nn: 1.0 + r_t * r_t / inertia,
        };
        let contact = Contact { w, ..random_contact(&mut stream) };
        for law in LAWS {
            let impact = resolve(&contact, law).expect("in the domain");
            let here = residual(&contact, &impact, &walk(&contact, law));
            let numbers = &impact.numbers;
            let allowed =
                if numbers.margin < BOUNDARY { f64::INFINITY } else { ROUNDING * numbers.condition };
            assert!(here <= allowed, "{here:e} under {law:?}: {contact:?}\n{impact:?}");
            ill += usize::from(numbers.condition > 1e6);
        }
    }
    assert!(ill > 1000, "ill-conditioned cases are among them: {ill}");
}

#[test]
fn a_grazing_contact_jams_only_in_painleves_case() {
    let mut stream = Stream(SEED + 2);
    let (_, types) = compare(100_000, || {
        let grazing = Contact { approach: 0.0, ..random_contact(&mut stream) };
        Contact { friction: 3.0 * grazing.friction, ..grazing }
    });
    assert!(types[7] > 1000 && types[0] > 1000, "both are met: {types:?}");
    assert_eq!(types[1..7], [0; 6], "an impact without approach is C-sticking");
}

#[test]
fn types_are_the_ones_the_walk_lives_through() {
    let mut stream = Stream(SEED + 3);
    for _ in 0..100_000 {
        let contact = random_contact(&mut stream);
        let impact = resolve(&contact, Law::Poisson).expect("in the domain");
        if impact.numbers.margin < 1e-12 {
            continue;
        }
        for law in LAWS {
            let walked = walk(&contact, law);
            let after = walked.slip.value();
            let expected = match (contact.slip == 0.0, walked.stopped, after == 0.0) {
                (true, _, false) => ImpactType::SlipsFromRest,
                (true, _, true) => ImpactType::SticksFromRest,
                (false, None, _) => ImpactType::SlidesThroughout,
                (false, Some(1), false) => ImpactType::ReversesInRestitution,
                (false, Some(1), true) => ImpactType::StopsInRestitution,
                (false, Some(_), false) => ImpactType::ReversesInCompression,
                (false, Some(_), true) => ImpactType::StopsInCompression,
            };
            assert_eq!(impact.kind, Some(expected), "{law:?} {contact:?}");
            assert_eq!(resolve(&contact, law).expect("in the domain").kind, Some(expected), "{law:?}");
        }
    }
}

/// Coulomb's law with Poisson's restitution in many small steps: the only thing it shares with the closed forms is the law.
fn stepped(contact: &Contact, steps: usize, step: f64) -> (f64, f64) {
    let (mut slip, mut rise, mut tangential) = (contact.slip, contact.approach, 0.0);
    let (mut normal, mut compressed) = (0.0, None);
    for _ in 0..steps {
        if compressed.is_none() && rise >= 0.0 {
            compressed = Some(normal);
        }
        if compressed.is_some_and(|c: f64| normal >= (1.0 + contact.restitution) * c) {
            break;
        }
        // The tangential impulse that would end the slip in this step, cut at the cone.
        let wanted = -(slip + contact.w.tn * step) / contact.w.tt;
        let given = wanted.clamp(-contact.friction * step, contact.friction * step);
        let change = contact.w.velocity_change(given, step);
        (slip, rise) = (slip + change.0, rise + change.1);
        (tangential, normal) = (tangential + given, normal + step);
    }
    (tangential, normal)
}

#[test]
fn poissons_forms_are_the_limit_of_small_steps() {
    let mut stream = Stream(SEED + 4);
    let steps = 20_000;
    for _ in 0..1000 {
        let contact = random_contact(&mut stream);
        let impact = resolve(&contact, Law::Poisson).expect("in the domain");
        let step = impact.normal_impulse / steps as f64;
        let (tangential, normal) = stepped(&contact, 2 * steps, step);
        // Each phase and the slip stop end up to one step late, and the change of leg magnifies that by the condition.
        let allowed = 4.0 * impact.numbers.condition * step * contact.friction.max(1.0);
        assert!((normal - impact.normal_impulse).abs() <= allowed, "{normal} {contact:?} {impact:?}");
        assert!((tangential - impact.tangential_impulse).abs() <= allowed, "{contact:?} {impact:?}");
    }
}
