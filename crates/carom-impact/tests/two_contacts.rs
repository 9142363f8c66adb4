//! Two contacts: the staged walk against the closed forms of rocking bodies, and landings that admit of no doubt.

use carom_impact::Law;
use carom_impact::planar::{ContactSet2, ContactState, Touch, staged};
use carom_num::Vec2;
use carom_theory::rocking::{Cylinder, Prism, Strike, SupportedRod, Tangential};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Some ten roundings of velocities of order one.
const ROUNDING: f64 = 1e-14;
/// A few roundings of numbers of order one.
const EXACT: f64 = 1e-15;

/// Velocities and impulses of order one; two contacts that nearly share one line of action cancel three digits.
const AGREEMENT: f64 = 1e-11;

fn touch(arm: [f64; 2], normal: [f64; 2], friction: f64) -> Touch {
    Touch {
        arm: Vec2::new(arm[0], arm[1]),
        normal: Vec2::new(normal[0], normal[1]),
        friction,
        restitution: 0.0,
    }
}

/// The set of a body that rolls about its first contact; what touches or sticks does so exactly.
fn rolling(mass: f64, inertia: f64, strike: &Strike, touches: &[Touch; 2]) -> ContactSet2 {
    let [x, y] = strike.velocity_before;
    let mut set =
        ContactSet2::of_free_body(mass, inertia, Vec2::new(x, y), -strike.roll_rate_before, touches).unwrap();
    set.snap(ROUNDING);
    set
}

/// Compares motion and impulses after a plastic strike.
fn assert_strikes(
    mass: f64,
    inertia: f64,
    strike: &Strike,
    touches: &[Touch; 2],
    case: &dyn std::fmt::Debug,
) {
    let set = rolling(mass, inertia, strike, touches);
    let out = staged::resolve(&set, Law::Poisson).unwrap();
    let [x, y] = strike.velocity;
    let after =
        ContactSet2::of_free_body(mass, inertia, Vec2::new(x, y), -strike.roll_rate, touches).unwrap();
    for i in 0..2 {
        let pairs = [
            (out.velocity[i][0], after.slip[i]),
            (out.velocity[i][1], after.normal[i]),
            (out.impulse[i][1], strike.normal[i]),
        ];
        for (ours, exact) in pairs {
            assert!((ours - exact).abs() <= AGREEMENT * (1.0 + exact.abs()), "{case:?}\n{strike:?}\n{out:?}");
        }
    }
    let [a, k] = [out.impulse[0][0], out.impulse[1][0]];
    let tangential = match strike.tangential {
        Tangential::Each([ours_a, ours_k]) => (a - ours_a).abs().max((k - ours_k).abs()),
        Tangential::Sum(sum) => (a + k - sum).abs(),
    };
    assert!(tangential <= AGREEMENT * (1.0 + a.abs() + k.abs()), "{case:?}\n{strike:?}\n{out:?}");
}

#[test]
fn a_rolling_cylinder_strikes_as_its_closed_forms_say() {
    let mut rng = Pcg64::seed_from_u64(1);
    let (mut states, mut wedged) = ([0usize; 6], 0);
    for _ in 0..40_000 {
        let cylinder = Cylinder {
            mass: 1.0,
            radius: 1.0,
            inertia_ratio: [1.0, 0.5, 0.4, rng.random_range(0.05..1.0)][rng.random_range(0..4)],
            friction: rng.random_range(0.0..2.0) * [0.3, 1.0][rng.random_range(0..2)],
            half_angle: rng.random_range(1f64..89.0).to_radians(),
        };
        let (state, strike) = cylinder.strike(1.0).unwrap();
        states[state as usize] += 1;
        wedged += usize::from(cylinder.may_wedge());
        let normal = Vec2::at_angle(2.0 * cylinder.half_angle).turned_left();
        let f = cylinder.friction;
        let touches =
            [touch([0.0, -1.0], [0.0, 1.0], f), touch([-normal.x, -normal.y], [normal.x, normal.y], f)];
        assert_strikes(1.0, cylinder.inertia_ratio, &strike, &touches, &(state, cylinder));
    }
    assert!(states.iter().all(|&n| n > 100) && wedged > 1000, "every state is met: {states:?} {wedged}");
}

#[test]
fn a_rolling_prism_strikes_as_its_closed_forms_say() {
    let mut rng = Pcg64::seed_from_u64(2);
    let mut states = [0usize; 5];
    for _ in 0..40_000 {
        let prism = Prism {
            mass: rng.random_range(0.1..10.0),
            inertia: rng.random_range(0.01..3.0),
            to_centre: rng.random_range(0.05..2.0),
            to_k: rng.random_range(0.05..2.0),
            height: rng.random_range(0.05..2.0),
            friction: rng.random_range(0.0..2.0),
        };
        let (state, strike) = prism.strike(1.0).unwrap();
        states[usize::from(state.number())] += 1;
        let (h, f) = (-prism.height, prism.friction);
        let touches = [touch([-prism.to_centre, h], [0.0, 1.0], f), touch([prism.to_k, h], [0.0, 1.0], f)];
        assert_strikes(prism.mass, prism.inertia, &strike, &touches, &(state, prism));
    }
    assert!(states[1..].iter().all(|&n| n > 100), "every state is met: {states:?}");
}

#[test]
fn a_rod_on_two_supports_strikes_as_its_closed_forms_say() {
    let mut rng = Pcg64::seed_from_u64(3);
    for _ in 0..20_000 {
        let supports = [rng.random_range(0.01..0.5), rng.random_range(0.01..0.5)];
        let rod = SupportedRod::uniform(rng.random_range(0.1..10.0), 1.0, supports);
        let (state, strike) = rod.strike(rng.random_range(0.1..3.0)).unwrap();
        let touches = [touch([-rod.to_a, 0.0], [0.0, 1.0], 0.0), touch([rod.to_b, 0.0], [0.0, 1.0], 0.0)];
        assert_strikes(rod.mass, rod.inertia, &strike, &touches, &(state, rod));
    }
}

/// A box of 1 kg, 2 m × 1 m, on its two lower corners.
fn flat_box(friction: f64, restitution: f64, velocity: Vec2, spin: f64) -> ContactSet2 {
    let corners = [-1.0, 1.0].map(|x| Touch { restitution, ..touch([x, -0.5], [0.0, 1.0], friction) });
    ContactSet2::of_free_body(1.0, 5.0 / 12.0, velocity, spin, &corners).unwrap()
}

#[test]
fn a_box_that_lands_flat_and_sticks_stops_though_its_forces_are_undetermined() {
    let out = staged::resolve(&flat_box(0.8, 0.0, Vec2::new(0.1, -1.0), 0.0), Law::Poisson).unwrap();
    assert_eq!(out.velocity, [[0.0; 2]; 2], "{out:?}");
    assert_eq!(out.state, [ContactState::Sticks; 2], "{out:?}");
    let [a, b] = out.impulse;
    assert!((a[1] + b[1] - 1.0).abs() < ROUNDING && (a[0] + b[0] + 0.1).abs() < ROUNDING, "{out:?}");
    assert!((b[1] - a[1] - 0.05).abs() < ROUNDING, "friction below the centre turns it: {out:?}");
}

#[test]
fn a_box_that_lands_flat_on_a_smooth_floor_leaves_with_e_times_its_speed() {
    let out = staged::resolve(&flat_box(0.0, 0.4, Vec2::new(0.3, -1.0), 0.0), Law::Poisson).unwrap();
    for i in 0..2 {
        assert!((out.velocity[i][1] - 0.4).abs() < EXACT && out.velocity[i][0] == 0.3, "{out:?}");
        assert!((out.impulse[i][1] - 0.7).abs() < EXACT && out.impulse[i][0] == 0.0, "{out:?}");
    }
}

#[test]
fn identical_contacts_act_as_one() {
    let corner = Touch { restitution: 0.5, ..touch([0.3, -0.5], [0.0, 1.0], 0.4) };
    let resolve = |touches: &[Touch]| {
        let set = ContactSet2::of_free_body(1.0, 0.4, Vec2::new(0.5, -1.0), 0.2, touches).unwrap();
        staged::resolve(&set, Law::Poisson).unwrap()
    };
    let (one, two) = (resolve(&[corner]), resolve(&[corner, corner]));
    for axis in 0..2 {
        let sum = two.impulse[0][axis] + two.impulse[1][axis];
        assert!((sum - one.impulse[0][axis]).abs() < 1e-13, "{one:?} {two:?}");
        assert!((two.velocity[1][axis] - one.velocity[0][axis]).abs() < 1e-13, "{one:?} {two:?}");
    }
}

#[test]
fn contacts_that_separate_or_rest_exchange_nothing() {
    for velocity in [Vec2::new(0.3, 0.5), Vec2::ZERO] {
        let set = flat_box(0.5, 0.5, velocity, 0.0);
        let out = staged::resolve(&set, Law::Stronge).unwrap();
        assert_eq!(out.impulse, [[0.0; 2]; 2], "{out:?}");
        assert_eq!([out.velocity[0], out.velocity[1]], [0, 1].map(|i| [set.slip[i], set.normal[i]]));
    }
}

#[test]
fn two_closing_contacts_come_to_rest_together() {
    // A box that falls flat into a smooth corner: floor and wall act each for itself.
    let touches = [touch([0.0, -1.0], [0.0, 1.0], 0.0), touch([-1.0, 0.0], [1.0, 0.0], 0.0)];
    let set = ContactSet2::of_free_body(2.0, 1.0, Vec2::new(-3.0, -1.0), 0.0, &touches).unwrap();
    let mut stages = 0;
    let out = staged::resolve_observed(&set, Law::Poisson, &mut |_| stages += 1).unwrap();
    assert_eq!([out.impulse[0][1], out.impulse[1][1]], [2.0, 6.0], "m u each: {out:?}");
    assert_eq!((stages, out.velocity), (1, [[0.0; 2]; 2]), "one straight stage");
}
