//! What the three laws of restitution have in common, and where they part.

use crate::oracle;

use carom_theory::single_contact::{Contact, ImpactType, Inequality, Law, Operator, resolve};
use oracle::Stream;

/// A few roundings of numbers of order one.
const EXACT: f64 = 1e-15;
/// Some ten roundings, as a fraction of the terms.
const ROUNDING: f64 = 1e-14;

const LAWS: [Law; 3] = [Law::Poisson, Law::Stronge, Law::Newton];

fn random_contact(stream: &mut Stream) -> Contact {
    let (tt, nn) = (stream.decades(-1.0, 1.0), stream.decades(-1.0, 1.0));
    let w = Operator { tt, tn: stream.within(-0.999, 0.999) * (tt * nn).sqrt(), nn };
    Contact {
        w,
        slip: stream.sign() * stream.decades(-2.0, 1.0),
        approach: -stream.decades(-1.0, 1.0),
        friction: stream.within(0.0, 2.0),
        restitution: stream.within(0.0, 1.0),
    }
}

#[test]
fn works_sum_to_the_change_of_energy() {
    let mut stream = Stream(7);
    for _ in 0..50_000 {
        let contact = random_contact(&mut stream);
        for law in LAWS {
            let impact = resolve(&contact, law).expect("in the domain");
            let (p_t, p_n) = (impact.tangential_impulse, impact.normal_impulse);
            let mean_slip = 0.5 * (contact.slip + impact.slip_after);
            let mean_rise = 0.5 * (contact.approach + impact.normal_velocity_after);
            let change = p_t * mean_slip + p_n * mean_rise;
            let (slip_scale, rise_scale) = impact.velocity_scale(&contact);
            let scale = p_t.abs() * slip_scale + p_n * rise_scale;
            let off = (impact.work.energy_change() - change).abs();
            assert!(off <= ROUNDING * scale, "{law:?} {off:e} of {scale:e}: {contact:?}");
        }
    }
}

#[test]
fn velocities_after_are_those_of_the_impulses() {
    let mut stream = Stream(8);
    for _ in 0..50_000 {
        let contact = random_contact(&mut stream);
        for law in LAWS {
            let impact = resolve(&contact, law).expect("in the domain");
            let change = contact.w.velocity_change(impact.tangential_impulse, impact.normal_impulse);
            let (slip_scale, rise_scale) = impact.velocity_scale(&contact);
            let slip_off = (contact.slip + change.0 - impact.slip_after).abs();
            let rise_off = (contact.approach + change.1 - impact.normal_velocity_after).abs();
            assert!(slip_off <= ROUNDING * slip_scale, "{law:?} {slip_off:e}: {contact:?}");
            assert!(rise_off <= ROUNDING * rise_scale, "{law:?} {rise_off:e}: {contact:?}");
        }
    }
}

#[test]
fn only_newtons_law_gains_energy_and_only_when_the_slip_stops() {
    let mut stream = Stream(9);
    let mut gains = 0;
    for _ in 0..50_000 {
        let contact = random_contact(&mut stream);
        for law in LAWS {
            let impact = resolve(&contact, law).expect("in the domain");
            let scale = -impact.work.compression - impact.work.tangential;
            if impact.work.energy_change() > 1e-12 * scale {
                assert_eq!(law, Law::Newton, "{contact:?}");
                assert!(impact.slip_stop_impulse.is_some(), "{contact:?}");
                gains += 1;
            }
        }
    }
    assert!(gains > 100, "the gain is not a curiosity: {gains}");
}

#[test]
fn the_laws_agree_where_the_slip_does_not_stop() {
    let mut stream = Stream(10);
    for _ in 0..50_000 {
        let contact = random_contact(&mut stream);
        let [poisson, stronge, newton] = LAWS.map(|law| resolve(&contact, law).expect("in the domain"));
        assert_eq!([stronge.kind, newton.kind], [poisson.kind; 2], "the type is that of the first leg");
        if poisson.kind == Some(ImpactType::SlidesThroughout) {
            let near = |p: f64| (p - poisson.normal_impulse).abs() <= EXACT * poisson.normal_impulse;
            assert!(near(stronge.normal_impulse) && near(newton.normal_impulse), "{contact:?}");
        }
    }
}

#[test]
fn the_mirror_image_is_resolved_to_the_mirror_image() {
    let mut stream = Stream(11);
    for _ in 0..20_000 {
        let contact = random_contact(&mut stream);
        let w = Operator { tn: -contact.w.tn, ..contact.w };
        let mirrored = Contact { w, slip: -contact.slip, ..contact };
        for law in LAWS {
            let (a, b) = (
                resolve(&contact, law).expect("in the domain"),
                resolve(&mirrored, law).expect("in the domain"),
            );
            assert_eq!(a.kind, b.kind, "{contact:?}");
            assert_eq!(a.normal_impulse, b.normal_impulse, "to the last bit");
            assert_eq!(a.tangential_impulse, -b.tangential_impulse, "to the last bit");
            assert_eq!(a.slip_after, -b.slip_after, "to the last bit");
        }
    }
}

#[test]
fn without_restitution_the_types_4_and_6_do_not_occur() {
    let mut stream = Stream(12);
    for _ in 0..50_000 {
        let contact = Contact { restitution: 0.0, ..random_contact(&mut stream) };
        for law in LAWS {
            let impact = resolve(&contact, law).expect("in the domain");
            let restoring = [Some(ImpactType::ReversesInRestitution), Some(ImpactType::StopsInRestitution)];
            assert!(!restoring.contains(&impact.kind), "{law:?} {contact:?}");
            let (_, rise_scale) = impact.velocity_scale(&contact);
            assert!(impact.normal_velocity_after.abs() <= EXACT * rise_scale, "{law:?} stays");
        }
    }
}

#[test]
fn degenerate_contacts_have_their_named_answer() {
    let w = Operator { tt: 2.0, tn: 1.0, nn: 3.0 };
    let straight = Contact { w, slip: 0.0, approach: -1.0, friction: 0.6, restitution: 0.5 };
    let held = resolve(&straight, Law::Poisson).expect("in the domain");
    assert_eq!(held.kind, Some(ImpactType::SticksFromRest), "μ_s = 1/2 < 0.6");
    assert!((held.normal_impulse - 0.6).abs() < EXACT, "1.5 · 2/5");
    assert!((held.tangential_impulse + 0.3).abs() < EXACT, "−p_n/2");

    let smooth = Contact { friction: 0.0, ..straight };
    let slips = resolve(&smooth, Law::Newton).expect("in the domain");
    assert_eq!(slips.kind, Some(ImpactType::SlipsFromRest), "nothing holds it");
    assert_eq!(slips.tangential_impulse, 0.0, "no friction");
    assert!((slips.normal_impulse - 0.5).abs() < EXACT, "1.5/3");
    assert!((slips.slip_after - 0.5).abs() < EXACT, "the coupling drives it forward");

    let grazing = Contact { approach: 0.0, slip: 1.0, ..straight };
    let nothing = resolve(&grazing, Law::Stronge).expect("in the domain");
    assert_eq!((nothing.kind, nothing.normal_impulse), (None, 0.0), "B₂ − μ > 0");
    assert_eq!(nothing.numbers.decided_by, Inequality::PressingCloses, "3 − 0.6 > 0");

    let jammed = Contact { friction: 4.0, ..grazing };
    let stops = resolve(&jammed, Law::Newton).expect("in the domain");
    assert_eq!(stops.kind, Some(ImpactType::StopsInCompression), "3 − 4 < 0");
    assert!((stops.normal_impulse - 0.2).abs() < EXACT, "W_tn S₀/det = 1/5");
    assert_eq!((stops.slip_after, stops.normal_velocity_after), (0.0, 0.0), "it comes to rest");

    let leaving = Contact { approach: 1.0, ..straight };
    assert_eq!(resolve(&leaving, Law::Poisson).expect("in the domain").kind, None, "it opens");
}

#[test]
fn contacts_outside_the_domain_are_refused_by_name() {
    let w = Operator { tt: 1.0, tn: 0.0, nn: 1.0 };
    let sound = Contact { w, slip: 1.0, approach: -1.0, friction: 0.5, restitution: 0.5 };
    let refused = |contact: Contact| resolve(&contact, Law::Poisson).expect_err("outside").quantity;
    assert_eq!(refused(Contact { restitution: 1.5, ..sound }), "restitution");
    assert_eq!(refused(Contact { friction: -0.1, ..sound }), "friction");
    assert_eq!(refused(Contact { slip: f64::NAN, ..sound }), "slip");
    assert_eq!(refused(Contact { w: Operator { tn: 1.0, ..w }, ..sound }), "W_tt W_nn - W_tn^2");
    assert_eq!(refused(Contact { w: Operator { tt: 0.0, ..w }, ..sound }), "W_tt");
    let enormous = resolve(&Contact { slip: 1e300, approach: -1e300, ..sound }, Law::Poisson);
    assert_eq!(enormous.expect_err("overflows").quantity, "energy change");
}
