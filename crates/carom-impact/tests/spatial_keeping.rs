//! The non-sliding law in space against its closed forms: the rolling pyramid and the stool.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_impact::spatial::{Conclusion, ContactSet, KeptState, RigidBody, StatesOfKeeping, Touch};
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::spatial::{Approach, Kept, Pyramid, Stool};
use random::numbers;

/// Impulses at the rank of their equations, of order one.
const ROUNDING: f64 = 1e-12;
/// Half of the last digit printed, and rounding.
const PRINTED: f64 = 5.1e-11;

fn touch(arm: Vec3, normal: Vec3) -> Touch {
    Touch { arm, normal, friction: 0.0, restitution: 0.0 }
}

/// The pyramid in its own axes as K strikes, turning with `rate` about OA; its points are O, A, K.
fn pyramid(p: &Pyramid, rate: f64) -> (RigidBody, [Vec3; 3], Vec3) {
    let (h, a) = (p.height, p.circumradius);
    let half = std::f64::consts::PI / f64::from(p.sides);
    let (sin, cos) = carom_num::elementary::sin_cos(half);
    let corner = |sign: f64| Vec3::new(a * cos, sign * a * sin, h);
    let centre = Vec3::Z * (0.75 * h);
    let points = [Vec3::ZERO, corner(-1.0), corner(1.0)];
    let spin = points[1].unit().unwrap() * -rate;
    let [across, along] = p.inertia();
    let body = RigidBody {
        mass: p.mass,
        inertia: Mat3::diagonal(across, across, along),
        velocity: spin.cross(centre),
        spin,
    };
    let normal = Vec3::new(-h, 0.0, a * cos).unit().unwrap();
    (body, points.map(|x| x - centre), normal)
}

/// The body after the impulses of a state.
fn after<const N: usize>(
    body: &RigidBody,
    set: &ContactSet<N>,
    arms: &[Vec3],
    state: &KeptState<N>,
) -> RigidBody {
    let mut out = *body;
    for (i, arm) in arms.iter().enumerate() {
        out = out.pushed(*arm, set.frame[i].transposed() * state.impulse[i]).unwrap();
    }
    out
}

fn struck(p: &Pyramid) -> (RigidBody, ContactSet<3>, StatesOfKeeping<3>, RigidBody) {
    let (body, arms, normal) = pyramid(p, 1.0);
    let set = ContactSet::<3>::of_free_body(&body, &arms.map(|arm| touch(arm, normal))).unwrap();
    let states = set.states_of_keeping();
    let end = after(&body, &set, &arms, &states.consistent[0]);
    (body, set, states, end)
}

fn kept(kept: Kept) -> [bool; 3] {
    match kept {
        Kept::ApexAndNext => [true, false, true],
        Kept::Next => [false, false, true],
        Kept::All => [true; 3],
        Kept::BaseEdge => [false, true, true],
    }
}

#[test]
fn random_pyramids_leave_as_their_closed_forms_say() {
    let (mut worst_spin, mut worst_impulse) = (0.0_f64, 0.0_f64);
    for case in 0..3000_u32 {
        let random = numbers(case);
        let p = Pyramid {
            sides: 3 + (10.0 * random(0)) as u32,
            height: 0.05 + 7.4 * random(1) * random(2),
            circumradius: 1.0,
            mass: 0.5 + random(3),
        };
        let (body, _, states, end) = struck(&p);
        let form = p.strike(1.0).unwrap();
        assert_eq!(states.conclusion(), Conclusion::Unique, "{p:?}");
        let state = &states.consistent[0];
        assert_eq!(state.kept, kept(form.kept), "{p:?}");
        assert_eq!(states.refused.len() + 1, 8, "one state is consistent, seven are not: {p:?}");
        worst_spin = worst_spin.max((end.spin - Vec3::from_array(form.spin)).norm());
        for (ours, theirs) in state.impulse.iter().zip(form.normal) {
            worst_impulse = worst_impulse.max((ours.z - theirs).abs() / p.mass);
        }
        assert!((end.energy() / body.energy() - form.energy_ratio).abs() < ROUNDING, "{p:?}");
    }
    println!(
        "3000 pyramids: spins within {worst_spin:.1e} rad/s, normal impulses within {worst_impulse:.1e} N s/kg"
    );
    assert!(worst_spin < ROUNDING && worst_impulse < ROUNDING, "{worst_spin:e} {worst_impulse:e}");
}

#[test]
fn every_row_of_the_table_holds_to_its_printed_digits() {
    let rows = include_str!("pyramid_table.csv").lines().skip(2);
    let mut count = 0;
    for row in rows {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |i: usize| -> f64 { cells[i].parse().unwrap() };
        let p = Pyramid { sides: cells[0].parse().unwrap(), height: number(1), circumradius: 1.0, mass: 1.0 };
        let (body, _, states, end) = struck(&p);
        let state = &states.consistent[0];
        let name: String = "OAK".chars().zip(state.kept).filter(|(_, k)| *k).map(|(c, _)| c).collect();
        assert_eq!(name, cells[2], "{row}");
        for (i, ours) in end.spin.to_array().into_iter().enumerate() {
            assert!((ours - number(3 + i)).abs() <= PRINTED, "{row}: {:?}", end.spin);
        }
        assert!((end.energy() / body.energy() - number(6)).abs() <= PRINTED, "{row}");
        for (i, ours) in state.impulse.iter().enumerate() {
            assert!((ours.z - number(7 + i)).abs() <= 5.1e-9, "{row}: {:?}", state.impulse);
        }
        // Of three kept contacts the table has one member of a family; another may do with less.
        let (friction, printed) = (state.friction_demand(), number(10));
        let of_a_family = name == "OAK";
        let least =
            if of_a_family { friction <= printed + 5.1e-7 } else { (friction - printed).abs() <= 5.1e-7 };
        assert!(least, "{row}: {friction}");
        count += 1;
    }
    println!("{count} rows");
    assert_eq!(count, 45);
}

/// A stool that turns about its support 0 and strikes with its neighbour 1, in the axes (u, e, N) of the closed forms.
fn stool(s: &Stool, a: &Approach) -> (RigidBody, [Vec3; 2]) {
    let half = std::f64::consts::PI / f64::from(s.supports);
    let (sin, cos) = carom_num::elementary::sin_cos(half);
    let (l, p) = (s.circle_radius * sin, s.circle_radius * cos);
    let tilted = Rotation::by(Vec3::X * a.tilt);
    let centre = Vec3::X * l + tilted.apply(Vec3::new(0.0, p, s.centre_height));
    let spin = Vec3::new(a.tilting, a.closing, a.swinging);
    let inertia = Mat3::diagonal(s.inertia_transverse, s.inertia_transverse, s.inertia_axial);
    let body = RigidBody { mass: s.mass, inertia: tilted.turn(inertia), velocity: spin.cross(centre), spin };
    (body, [-centre, Vec3::X * (2.0 * l) - centre])
}

#[test]
fn random_stools_leave_as_their_closed_forms_say() {
    let (mut worst, mut counts) = (0.0_f64, [0; 4]);
    for case in 0..20_000_u32 {
        let random = numbers(case);
        let axial = 0.01 + 0.2 * random(0) * random(12);
        let s = Stool {
            supports: 3 + (6.0 * random(1) * random(10)) as u32,
            circle_radius: 0.3 + 0.7 * random(2),
            centre_height: 0.02 + 0.6 * random(3),
            mass: 0.5 + random(4),
            inertia_transverse: axial * (0.5 + 2.0 * random(5)),
            inertia_axial: axial,
        };
        let a = Approach {
            tilting: 4.0 * random(6) - 2.0,
            closing: 0.1 + random(7),
            swinging: 16.0 * random(8) - 8.0,
            tilt: 0.4 * random(9),
        };
        let (body, arms) = stool(&s, &a);
        let set = ContactSet::<2>::of_free_body(&body, &arms.map(|arm| touch(arm, Vec3::Z))).unwrap();
        let states = set.states_of_keeping();
        let (both, next) = (s.on_both(&a), s.on_next(&a));
        let on_both = both.normal.iter().all(|n| *n >= 0.0);
        let on_next = next.normal >= 0.0 && next.separation >= 0.0;
        let found = |k: [bool; 2]| states.consistent.iter().find(|state| state.kept == k);
        assert_eq!(found([true, true]).is_some(), on_both, "{s:?} {a:?} {states:?}");
        assert_eq!(found([false, true]).is_some(), on_next, "{s:?} {a:?} {states:?}");
        assert!(found([true, false]).is_none(), "keeping O alone does not stop K: {s:?} {a:?}");
        counts[usize::from(on_both) + 2 * usize::from(on_next)] += 1;
        if let Some(state) = found([true, true]) {
            let spin = after(&body, &set, &arms, state).spin;
            worst = worst.max((spin - Vec3::X * both.tilting).norm());
            for (ours, theirs) in state.impulse.iter().zip(both.normal) {
                worst = worst.max((ours.z - theirs).abs());
            }
        }
        if let Some(state) = found([false, true]) {
            let spin = after(&body, &set, &arms, state).spin;
            worst = worst.max((spin - Vec3::from_array(next.spin)).norm());
            worst = worst.max((state.impulse[1].z - next.normal).abs());
        }
    }
    let [none, both, next, either] = counts;
    println!("20000 stools within {worst:.1e}: none {none}, both stay {both}, one {next}, either {either}");
    assert!(worst < 1e-11, "{worst:e}");
    assert!(counts.iter().all(|n| *n > 0), "{counts:?}");
}

/// The printed formula for the turn about OK, its axes being ξ, η, ζ at O.
#[test]
fn the_printed_formula_for_the_turn_about_the_line_holds_with_moments_about_the_support() {
    let s = Stool {
        supports: 5,
        circle_radius: 0.4,
        centre_height: 0.13,
        mass: 2.0,
        inertia_transverse: 0.05,
        inertia_axial: 0.07,
    };
    let half = std::f64::consts::PI / 5.0;
    let (sin, cos) = carom_num::elementary::sin_cos(half);
    let a = Approach { tilting: 0.3, closing: 1.2, swinging: -0.4, tilt: 0.0 };
    // K lies on −ξ: u = −C ξ + S η, e = S ξ + C η, and u × e = −ζ. Seen in a mirror, where the axes of the approach are right-handed, an angular
    // velocity changes its sign.
    let (u, e) = ([-cos, sin], [sin, cos]);
    let along = |i: usize| -(a.tilting * u[i] + a.closing * e[i]);
    let after = s.spin_about_line([along(0), along(1), -a.swinging]);
    assert!((after + s.on_both(&a).tilting).abs() < 1e-14, "{after} {:?}", s.on_both(&a));
}
