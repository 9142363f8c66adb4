//! What section 5 of Polukoshko, Viba and others prints of bodies in space, sentence by sentence, against every state of general bodies.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_impact::spatial::{ContactSet, KeptState, Refusal, RigidBody, StatesOfKeeping, Touch};
use carom_num::elementary::{sin, sin_cos};
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::spatial::Stool;
use random::numbers;
use std::f64::consts::{PI, TAU};

/// What rounding leaves of spins and velocities of order one.
const ROUNDING: f64 = 1e-11;
/// Heights this near to the critical one, as a fraction of it, are left out: rounding decides there.
const EDGE: f64 = 1e-9;

fn touch(arm: Vec3, normal: Vec3) -> Touch {
    Touch { arm, normal, friction: 0.0, restitution: 0.0 }
}

/// Contacts O, A, K of a homogeneous pyramid of circumradius 1 as K strikes, rolling about OA with 1 rad/s.
fn pyramid(sides: u32, height: f64) -> ContactSet<3> {
    let (s, c) = sin_cos(PI / f64::from(sides));
    let polygon = 1.0 - 2.0 / 3.0 * s * s;
    let centre = Vec3::Z * (0.75 * height);
    let points = [Vec3::ZERO, Vec3::new(c, -s, height), Vec3::new(c, s, height)];
    let spin = -points[1].unit().unwrap();
    let across = 0.15 * polygon + 0.0375 * height * height;
    let inertia = Mat3::diagonal(across, across, 0.3 * polygon);
    let body = RigidBody { mass: 1.0, inertia, velocity: spin.cross(centre), spin };
    let normal = Vec3::new(-height, 0.0, c).unit().unwrap();
    ContactSet::of_free_body(&body, &points.map(|x| touch(x - centre, normal))).unwrap()
}

/// In print: a √(1 − (2/3) sin² π/n).
fn printed_height(sides: u32) -> f64 {
    let s = sin(PI / f64::from(sides));
    (1.0 - 2.0 / 3.0 * s * s).sqrt()
}

fn only<const N: usize>(states: &StatesOfKeeping<N>) -> &KeptState<N> {
    assert_eq!(states.consistent.len(), 1, "one state: {states:?}");
    &states.consistent[0]
}

/// Random pyramids that are not at the critical height.
fn each_pyramid(mut visit: impl FnMut(u32, f64, &ContactSet<3>)) {
    for case in 0..2000 {
        let random = numbers(case);
        let (sides, height) = (3 + case % 10, 0.05 + 3.0 * random(0) * random(1));
        if (height / printed_height(sides) - 1.0).abs() > EDGE {
            visit(sides, height, &pyramid(sides, height));
        }
    }
}

const O: usize = 0;
const A: usize = 1;
const K: usize = 2;

#[test]
fn k_strikes_straight_and_o_and_a_are_at_rest_as_printed() {
    each_pyramid(|sides, height, set| {
        let [o, a, k] = set.velocity;
        assert!(o.norm() < ROUNDING && a.norm() < ROUNDING, "{sides} {height}: {o:?} {a:?}");
        assert!(k.z < 0.0 && (k.x * k.x + k.y * k.y).sqrt() < ROUNDING, "{sides} {height}: {k:?}");
    });
}

#[test]
fn the_printed_height_decides_whether_the_apex_stays() {
    let mut long = 0;
    each_pyramid(|sides, height, set| {
        let stays = only(&set.states_of_keeping()).kept[O];
        assert_eq!(stays, height > printed_height(sides), "{sides} {height}");
        long += u32::from(stays);
    });
    assert!((200..1800).contains(&long), "both are met: {long}");
}

#[test]
fn of_the_eight_printed_variants_two_are_possible_from_four_sides_on() {
    each_pyramid(|sides, height, set| {
        let states = set.states_of_keeping();
        let kept = only(&states).kept;
        assert_eq!(states.refused.len(), 7, "{sides} {height}: {states:?}");
        if sides > 3 {
            assert!(
                [[true, false, true], [false, false, true]].contains(&kept),
                "{sides} {height}: {kept:?}"
            );
        }
    });
}

/// In print of a short pyramid "the vertex A of the base is also separated": A separates from a long one too, and what separates besides is the apex.
#[test]
fn misprint_in_a_short_pyramid_the_apex_is_also_separated() {
    each_pyramid(|sides, height, set| {
        if sides == 3 {
            return;
        }
        let states = set.states_of_keeping();
        let after = only(&states).velocity;
        let short = height < printed_height(sides);
        assert!(after[A].z > 0.0, "A separates from long and short: {sides} {height}");
        assert_eq!(after[O].norm() > ROUNDING, short, "{sides} {height}: {:?}", after[O]);
        assert!(!short || after[O].z > 0.0, "{sides} {height}: {:?}", after[O]);
        assert!(after[K].norm() < ROUNDING, "{sides} {height}");
    });
}

/// In print "only two variants are possible": of a pyramid on a triangle neither is.
#[test]
fn wrong_in_print_a_triangular_pyramid_stops_or_turns_about_its_base() {
    let mut counts = [0; 2];
    each_pyramid(|sides, height, set| {
        if sides != 3 {
            return;
        }
        let states = set.states_of_keeping();
        let state = only(&states);
        let long = height > printed_height(3);
        assert_eq!(state.kept, [long, true, true], "{height}: {states:?}");
        assert!(!long || state.velocity.iter().all(|v| v.norm() < ROUNDING), "it stops: {height}");
        assert!(long || state.velocity[O].z > 0.0, "the apex lifts: {height}");
        counts[usize::from(long)] += 1;
    });
    assert!(counts.iter().all(|n| *n > 20), "{counts:?}");
}

/// In print "separation only of points K" is one of three outcomes: no impulse at O stops K, whatever the body.
#[test]
fn wrong_in_print_separation_only_of_k_is_impossible() {
    let mut pulled = 0;
    for case in 0..5000 {
        let random = numbers(case);
        let vector =
            |k: usize| Vec3::new(random(k), random(k + 1), random(k + 2)) * 2.0 - Vec3::new(1.0, 1.0, 1.0);
        let third = 0.2 + 0.7 * random(9);
        let inertia = Rotation::by(vector(3) * 3.0).turn(Mat3::diagonal(0.6, 0.5, third)) * 0.2;
        // It turns about O, and K comes down.
        let (o, k) = (vector(6) - Vec3::Z, vector(10) - Vec3::Z);
        let k = Vec3::new(k.x, k.y, o.z);
        let turning = vector(0) * 3.0;
        let spin = if turning.cross(k - o).z < 0.0 { turning } else { -turning };
        let body = RigidBody { mass: 1.0, inertia, velocity: -spin.cross(o), spin };
        let set = ContactSet::<2>::of_free_body(&body, &[o, k].map(|arm| touch(arm, Vec3::Z))).unwrap();
        if set.velocity[1].z > -EDGE {
            continue;
        }
        let states = set.states_of_keeping();
        assert!(states.consistent.iter().all(|state| state.kept[1]), "case {case}: {states:?}");
        let alone = states.refused.iter().find(|refused| refused.kept == [true, false]).unwrap();
        assert_eq!(alone.refusal, Refusal::Approaches(1), "case {case}");
        assert!((alone.amount - set.velocity[1].z).abs() < ROUNDING, "it comes down as before: case {case}");
        let both = states.refused.iter().find(|refused| refused.kept == [true, true]);
        pulled += u32::from(both.is_some_and(|both| both.refusal == Refusal::Pulls(1)));
    }
    // What the print means: the state that keeps both asks K alone to pull.
    println!("in {pulled} of 5000 cases keeping both would pull at K");
    assert!(pulled > 100, "{pulled}");
}

/// The printed ω₁ = (−C J_ξ ω_ξ + S (J_η ω_η − J_ηζ ω_ζ))/(J_η S² + J_ξ C²) against the engine's state that keeps both.
#[test]
fn the_printed_spin_about_ok_holds_with_moments_about_the_support() {
    let (mut worst, mut centre, mut compared) = (0.0_f64, 0.0_f64, 0);
    for case in 0..2000 {
        let random = numbers(case);
        let (s, a) = (stool(case), 0.3 + random(1));
        let s = Stool { circle_radius: a, ..s };
        let (sn, cs) = sin_cos(PI / f64::from(s.supports));
        // At O: η to the middle, ζ up, ξ = η × ζ; K at −ξ.
        let k = Vec3::new(-cs, sn, 0.0) * (2.0 * a * sn);
        let spin = Vec3::new(random(2) - 0.5, random(3) - 0.5, random(4) - 0.5);
        let spin = if spin.cross(k).z < 0.0 { spin } else { -spin };
        let g = Vec3::new(0.0, a, s.centre_height);
        let inertia = Mat3::diagonal(s.inertia_transverse, s.inertia_transverse, s.inertia_axial);
        let body = RigidBody { mass: s.mass, inertia, velocity: spin.cross(g), spin };
        let set = ContactSet::<2>::of_free_body(&body, &[-g, k - g].map(|r| touch(r, Vec3::Z))).unwrap();
        let states = set.states_of_keeping();
        let Some(both) = states.consistent.iter().find(|state| state.kept == [true; 2]) else { continue };
        let after = [-g, k - g]
            .iter()
            .zip(&set.frame)
            .zip(&both.impulse)
            .fold(body, |body, ((arm, frame), p)| body.pushed(*arm, frame.transposed() * *p).unwrap());
        let along = after.spin.dot(k.unit().unwrap());
        let printed = |j: [f64; 3]| {
            let [xi, eta, deviation] = j;
            (-cs * xi * spin.x + sn * (eta * spin.y - deviation * spin.z)) / (eta * sn * sn + xi * cs * cs)
        };
        let (m, c) = (s.mass, s.centre_height);
        let about = [s.inertia_transverse + m * (a * a + c * c), s.inertia_transverse + m * c * c, m * a * c];
        worst = worst.max((along - printed(about)).abs());
        centre = centre.max((along - printed([s.inertia_transverse, s.inertia_transverse, 0.0])).abs());
        compared += 1;
    }
    println!("{compared} cases: to {worst:.1e}; with moments about the mass centre off by {centre:.1e}");
    assert!(compared > 30 && worst < ROUNDING && centre > 1e-2, "{compared} {worst:e} {centre:e}");
}

fn stool(case: u32) -> Stool {
    let random = numbers(case);
    let axial = 0.02 + 0.6 * random(5) * random(6);
    Stool {
        supports: 3 + case % 6,
        circle_radius: 1.0,
        centre_height: 0.05 + random(7),
        mass: 0.5 + random(8),
        inertia_transverse: axial * (0.5 + random(9)),
        inertia_axial: axial,
    }
}

/// A stool that comes down flat with 1 rad/s about a line that touches the ring at `turned` from support 0: the rest of its spin, and what stays.
fn flat(s: &Stool, turned: f64, lever: f64) -> (f64, Vec<bool>) {
    let (sin, cos) = sin_cos(turned);
    let (outward, along) = (Vec3::new(cos, sin, 0.0), Vec3::new(-sin, cos, 0.0));
    let arms: Vec<Vec3> = (0..s.supports)
        .map(|i| {
            let (y, x) = sin_cos(TAU * f64::from(i) / f64::from(s.supports));
            Vec3::new(s.circle_radius * x, s.circle_radius * y, -s.centre_height)
        })
        .collect();
    let spin = -along;
    let pivot = outward * lever - Vec3::Z * s.centre_height;
    let inertia = Mat3::diagonal(s.inertia_transverse, s.inertia_transverse, s.inertia_axial);
    let body = RigidBody { mass: s.mass, inertia, velocity: -spin.cross(pivot), spin };
    let touches: Vec<Touch> = arms.iter().map(|arm| touch(*arm, Vec3::Z)).collect();
    let mut set = ContactSet::<8>::of_free_body(&body, &touches).unwrap();
    set.snap(EDGE);
    let states = set.states_of_keeping();
    let state = only(&states);
    let after = arms.iter().enumerate().fold(body, |body, (i, arm)| {
        body.pushed(*arm, set.frame[i].transposed() * state.impulse[i]).unwrap()
    });
    assert!(after.spin.cross(along).norm() < ROUNDING, "it turns about the same direction: {after:?}");
    (after.spin.dot(spin), state.kept[..arms.len()].to_vec())
}

#[test]
fn flat_from_a_support_or_an_edge_it_stops_where_its_inertia_is_small() {
    let (mut worst, mut stops) = (0.0_f64, [0; 2]);
    for case in 0..600 {
        let s = stool(case);
        let n = s.supports;
        let half = PI / f64::from(n);
        let (_, cos) = sin_cos(half);
        let ways = [
            (0.0, s.circle_radius, s.flat_from_support()),
            (half, s.circle_radius * cos, s.flat_from_edge()),
        ];
        for (k, (turned, lever, wanted)) in ways.into_iter().enumerate() {
            let (rest, kept) = flat(&s, turned, lever);
            worst = worst.max((rest - wanted).abs());
            assert!(worst < ROUNDING, "case {case}: {rest} {wanted} {s:?}");
            let stay = kept.iter().filter(|kept| **kept).count();
            // Opposite to a support lies a support where their number is even, else an edge.
            let opposite = if n.is_multiple_of(2) == (k == 0) { 1 } else { 2 };
            assert_eq!(stay, if wanted == 0.0 { n as usize } else { opposite }, "case {case}: {kept:?}");
            stops[k] += u32::from(wanted == 0.0);
        }
    }
    println!("600 stools fall flat, from a support and from an edge: {stops:?} stop; spins to {worst:.1e}");
    assert!(stops.iter().all(|n| (30..570).contains(n)), "{stops:?}");
}
