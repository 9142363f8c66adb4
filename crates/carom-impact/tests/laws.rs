//! Laws that every impact obeys, over random contacts.

use carom_impact::Law;
use carom_impact::planar::{ContactSet, ContactSet2, ContactSet6, ContactState, Touch, single, staged};
use carom_num::Vec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

const LAWS: [Law; 3] = [Law::Poisson, Law::Stronge, Law::Newton];

fn touch(rng: &mut Pcg64) -> Touch {
    let normal = Vec2::at_angle(rng.random_range(-3.2..3.2));
    // The arm points roughly against the normal, as for a convex body.
    let arm = Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0))
        - normal * rng.random_range(0.0..1.0);
    Touch { arm, normal, friction: rng.random_range(0.0..1.5), restitution: rng.random_range(0.0..1.0) }
}

fn velocity(rng: &mut Pcg64) -> (Vec2, f64) {
    (Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0)), rng.random_range(-2.0..2.0))
}

fn kinetic<const N: usize, const M: usize>(set: &ContactSet<N, M>) -> f64 {
    (0..set.count).map(|i| set.slip[i].powi(2) + set.normal[i].powi(2)).fold(0.0, f64::max)
}

#[test]
fn one_contact_walks_alike_in_both_ways() {
    let mut rng = Pcg64::seed_from_u64(1);
    for _ in 0..200_000 {
        let (touch, (v, w)) = (touch(&mut rng), velocity(&mut rng));
        let set = ContactSet2::of_free_body(1.0, rng.random_range(0.05..1.0), v, w, &[touch]).unwrap();
        let b = set.operator[0][0];
        let contact = single::Contact {
            w_tt: b.tt,
            w_tn: b.tn,
            w_nn: b.nn,
            slip: set.slip[0],
            normal: set.normal[0],
            friction: touch.friction,
            restitution: touch.restitution,
        };
        for law in LAWS {
            let one = single::resolve(&contact, law).unwrap();
            let many = staged::resolve(&set, law).unwrap();
            let scale = kinetic(&set).sqrt();
            for (a, b) in [(one.slip, many.velocity[0][0]), (one.normal, many.velocity[0][1])] {
                assert!((a - b).abs() <= 1e-11 * scale, "{law:?} {contact:?}: {one:?} {many:?}");
            }
            assert!(law == Law::Newton || !one.gained_energy, "{law:?} {contact:?}");
        }
    }
}

#[test]
fn two_contacts_never_penetrate_gain_or_leave_the_cone() {
    let mut rng = Pcg64::seed_from_u64(2);
    let mut scaled = 0;
    for _ in 0..100_000 {
        let touches = [touch(&mut rng), touch(&mut rng)];
        let (v, w) = velocity(&mut rng);
        let inertia = rng.random_range(0.05..1.0);
        let set = ContactSet6::of_free_body(1.0, inertia, v, w, &touches).unwrap();
        let out = staged::resolve(&set, Law::Poisson).unwrap();
        let scale = kinetic(&set).sqrt();
        for i in 0..2 {
            let [q, r] = out.impulse[i];
            assert!(out.velocity[i][1] >= -1e-12 * scale, "penetrates {touches:?} {out:?}");
            assert!(r >= 0.0 && q.abs() <= touches[i].friction * r * (1.0 + 1e-12) + 1e-15, "cone {out:?}");
        }
        assert!(!out.gained_energy, "{out:?}");
        scaled += usize::from(out.restitution_scaled < 1.0);
        let pair = ContactSet2::of_free_body(1.0, inertia, v, w, &touches).unwrap();
        assert_eq!(
            staged::resolve(&pair, Law::Poisson).unwrap().velocity[..],
            out.velocity[..2],
            "capacity must not matter"
        );
    }
    assert!(scaled < 1000, "restitution scaled {scaled} times");
}

#[test]
fn contacts_in_another_order_give_the_same_impact() {
    let mut rng = Pcg64::seed_from_u64(3);
    let mut different = 0;
    for _ in 0..20_000 {
        let touches = [touch(&mut rng), touch(&mut rng), touch(&mut rng)];
        let (v, w) = velocity(&mut rng);
        let resolve = |order: [usize; 3]| {
            let set = ContactSet6::of_free_body(1.0, 0.3, v, w, &order.map(|i| touches[i])).unwrap();
            staged::resolve(&set, Law::Poisson)
        };
        let (Ok(a), Ok(b)) = (resolve([0, 1, 2]), resolve([2, 0, 1])) else { continue };
        if a.branches > 1 || b.branches > 1 {
            continue;
        }
        let worst =
            (0..3).map(|i| (a.velocity[[2, 0, 1][i]][1] - b.velocity[i][1]).abs()).fold(0.0, f64::max);
        different += usize::from(worst > 1e-9);
    }
    assert_eq!(different, 0, "impacts that depend on the order of contacts");
}

#[test]
fn a_rod_that_lands_flat_on_its_two_ends_stops() {
    // Two ends on one plate, one closing and one touching and both at rest along the plate: sticking leaves the forces indeterminate.
    let touches = [-0.5, 0.5].map(|x| Touch {
        arm: Vec2::new(x, 0.0),
        normal: Vec2::new(0.0, 1.0),
        friction: 0.5,
        restitution: 0.0,
    });
    let set = ContactSet2::of_free_body(1.0, 1.0 / 12.0, Vec2::new(0.01, -0.5), -1.0, &touches).unwrap();
    assert!(set.normal[0].abs() < 1e-15 && set.normal[1] == -1.0, "{set:?}");
    let out = staged::resolve(&set, Law::Poisson).unwrap();
    assert_eq!(out.state[1], ContactState::Sticks, "{out:?}");
    assert!(out.velocity[0][1] >= 0.0 && out.velocity[1] == [0.0, 0.0], "{out:?}");
}
