//! On which faces bodies rest, and how often: against solid angles in closed form, and against what symmetry and numbering must not change.

use carom_motion::spatial::{Polyhedron, Rest, examples};
use carom_num::elementary::atan2;
use carom_num::{Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::PI;

/// What counts as flat, of bodies of about 1 m.
const FLAT: f64 = 1e-9;
/// Some operations on numbers of about 1.
const ROUNDING: f64 = 4e-15;
const SEED: u64 = 20_261_129;

fn drawn(random: &mut Pcg64Mcg) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| random.random_range(-1.0..1.0)))
}

fn cuboid(half: Vec3) -> Vec<Vec3> {
    let sign = |i: u32, k: u32| f64::from(2 * (i >> k & 1)) - 1.0;
    (0..8).map(|i| Vec3::new(half.x * sign(i, 0), half.y * sign(i, 1), half.z * sign(i, 2))).collect()
}

fn hull(points: &[Vec3]) -> (Polyhedron, Vec3) {
    let hull = Polyhedron::of_points(points, FLAT).unwrap();
    let centre = hull.solid().unwrap().centre;
    (hull, centre)
}

fn facing(hull: &Polyhedron, normal: Vec3) -> usize {
    hull.faces().iter().position(|face| (face.normal - normal).norm() < FLAT).unwrap()
}

fn sum(rests: &[Rest]) -> f64 {
    rests.iter().map(|rest| rest.share).sum()
}

#[test]
fn a_box_rests_on_each_face_by_its_solid_angle() {
    let mut random = Pcg64Mcg::seed_from_u64(SEED);
    for case in 0..50 {
        let half = Vec3::from_array(std::array::from_fn(|_| random.random_range(0.1..1.0)));
        let turn = Rotation::by(drawn(&mut random) * 3.0);
        let shift = drawn(&mut random);
        let points: Vec<Vec3> = cuboid(half).into_iter().map(|r| turn.apply(r) + shift).collect();
        let cuboid = Polyhedron::of_points(&points, FLAT).unwrap();
        let rests = cuboid.rests(shift).unwrap();
        for (axis, h, a, b) in [
            (Vec3::X, half.x, half.y, half.z),
            (Vec3::Y, half.y, half.z, half.x),
            (Vec3::Z, half.z, half.x, half.y),
        ] {
            // A rectangle of 2a × 2b over its middle at the height h: 4 atan(a b / (h √(h² + a² + b²))).
            let closed = atan2(a * b, h * half.norm()) / PI;
            for normal in [axis, -axis] {
                let rest = rests[facing(&cuboid, turn.apply(normal))];
                assert!((rest.share - closed).abs() < ROUNDING, "case {case}: {rest:?}, {closed}");
                assert!((rest.seen - closed).abs() < ROUNDING && rest.stays, "case {case}: {rest:?}");
                let least = atan2(a.min(b), h);
                assert!((rest.tips_after - least).abs() < ROUNDING, "case {case}: {rest:?}, {least}");
            }
        }
        assert!((sum(&rests) - 1.0).abs() < ROUNDING, "case {case}: {rests:?}");
    }
}

#[test]
fn a_regular_tetrahedron_rests_on_each_face_alike() {
    let corner = |x: f64, y: f64, z: f64| Vec3::new(x, y, z);
    let corners =
        [corner(1.0, 1.0, 1.0), corner(1.0, -1.0, -1.0), corner(-1.0, 1.0, -1.0), corner(-1.0, -1.0, 1.0)];
    let (hull, centre) = hull(&corners);
    for rest in hull.rests(centre).unwrap() {
        assert!((rest.share - 0.25).abs() < ROUNDING, "{rest:?}");
        // With the edge a the mass centre is a/√24 above a face, and a/√12 inside its sides: tan φ = √2.
        assert!((rest.tips_after - atan2(2f64.sqrt(), 1.0)).abs() < ROUNDING, "{rest:?}");
    }
}

/// A prism that leans so far that it does not stay on its ends: of height 1 on the unit square, its upper end 2 m to the right.
fn leaning() -> Vec<Vec3> {
    (0..8)
        .map(|i| {
            let [x, y, z] = [i & 1, i >> 1 & 1, i >> 2].map(f64::from);
            Vec3::new(x + 2.0 * z, y, z)
        })
        .collect()
}

#[test]
fn a_face_on_which_a_body_does_not_stay_gives_its_share_to_the_next() {
    let (prism, centre) = hull(&leaning());
    let rests = prism.rests(centre).unwrap();
    let slant = Vec3::new(1.0, 0.0, -2.0).unit().unwrap();
    for (end, side) in [(-Vec3::Z, slant), (Vec3::Z, -slant)] {
        let (end, side) = (facing(&prism, end), facing(&prism, side));
        let rest = rests[end];
        assert!(!rest.stays && rest.tips_onto == side, "{rest:?}");
        assert_eq!((rest.share, rest.tips_after), (0.0, 0.0), "{rest:?}");
        assert!((rest.stance.margin + 0.5).abs() < ROUNDING, "the centre is half a metre beyond: {rest:?}");
        assert!(rest.seen > 0.0, "{rest:?}");
        let beside = rests[side];
        assert!((beside.share - beside.seen - rest.seen).abs() < ROUNDING, "{beside:?}");
        // The side over which it leaves is the one that both faces have.
        for vertex in rest.tips_over {
            assert!(prism.faces()[end].corners.contains(&vertex), "{rest:?}");
            assert!(prism.faces()[side].corners.contains(&vertex), "{rest:?}");
        }
    }
    assert!((sum(&rests) - 1.0).abs() < ROUNDING, "{rests:?}");
}

#[test]
fn a_body_rolls_off_over_several_faces() {
    // Half a cylinder of radius 1 m with twelve facets. The foot of the mass centre is `0.3 sin φ` beside the middle of a facet that faces at the angle φ, and a facet reaches
    // tan 7.5° = 0.13 to either side: it stays on those within 25° of either end of the half circle, the two outer ones.
    let ring = |z: f64| {
        (0..=12).map(move |k| {
            let (sin, cos) = carom_num::elementary::sin_cos(PI * f64::from(k) / 12.0);
            Vec3::new(cos, sin, z)
        })
    };
    let points: Vec<Vec3> = ring(-1.0).chain(ring(1.0)).collect();
    let shell = Polyhedron::of_points(&points, FLAT).unwrap();
    let rests = shell.rests(Vec3::new(0.3, 0.01, 0.0)).unwrap();
    let facet = |k: i32| {
        let (sin, cos) = carom_num::elementary::sin_cos(PI * (f64::from(k) + 0.5) / 12.0);
        rests[facing(&shell, Vec3::new(cos, sin, 0.0))]
    };
    for k in 0..12 {
        assert_eq!(facet(k).stays, [0, 1, 10, 11].contains(&k), "facet {k}: {:?}", facet(k));
    }
    // From those in between it rolls down, facet by facet, to the second.
    let rolled: f64 = (1..10).map(|k| facet(k).seen).sum();
    assert!((facet(1).share - rolled).abs() < ROUNDING, "{:?}, {rolled}", facet(1));
    assert!((facet(11).share - facet(11).seen).abs() < ROUNDING, "{:?}", facet(11));
    assert!((sum(&rests) - 1.0).abs() < ROUNDING, "{rests:?}");
    for rest in &rests {
        assert!(rest.stays == (rest.share > 0.0), "what does not stay keeps nothing: {rest:?}");
    }
}

#[test]
fn shares_add_up_to_one_and_go_with_the_faces_whatever_the_numbers() {
    let mut random = Pcg64Mcg::seed_from_u64(SEED);
    let mut rolls = 0;
    for case in 0..200 {
        let count = random.random_range(5..30);
        let points: Vec<Vec3> = (0..count).map(|_| drawn(&mut random)).collect();
        let (first, centre) = hull(&points);
        let rests = first.rests(centre).unwrap();
        assert!((sum(&rests) - 1.0).abs() < ROUNDING, "case {case} of {SEED}: {rests:?}");
        let seen: f64 = rests.iter().map(|rest| rest.seen).sum();
        assert!((seen - 1.0).abs() < ROUNDING, "case {case} of {SEED}: {seen}");
        assert!(
            rests.iter().all(|rest| rest.stays == (rest.share > 0.0)),
            "case {case} of {SEED}: {rests:?}"
        );
        rolls += rests.iter().filter(|rest| !rest.stays).count();
        let mut others = points.clone();
        for k in (1..others.len()).rev() {
            others.swap(k, random.random_range(0..=k));
        }
        let (second, _) = hull(&others);
        let again = second.rests(centre).unwrap();
        for (face, rest) in first.faces().iter().zip(&rests) {
            let same = again[facing(&second, face.normal)];
            let apart = (same.share - rest.share).abs().max((same.tips_after - rest.tips_after).abs());
            assert!(
                apart < ROUNDING && same.stays == rest.stays,
                "case {case} of {SEED}: {rest:?}, {same:?}"
            );
        }
    }
    assert!(rolls > 200, "the bodies have faces on which they do not stay: {rolls}");
}

#[test]
fn a_mass_centre_over_a_side_is_balanced_and_one_outside_rests_on_nothing() {
    let cube = Polyhedron::of_points(&examples::cube_corners(), FLAT).unwrap();
    let below = facing(&cube, -Vec3::Z);
    let inside = 1.0 - 1e-12;
    let rests = cube.rests(Vec3::new(inside, 0.5, 0.25)).unwrap();
    assert!(!rests[below].stays, "over the side but for rounding: {:?}", rests[below]);
    assert!((sum(&rests) - 1.0).abs() < 1e-9, "{rests:?}");
    assert_eq!(cube.rests(Vec3::new(1.25, 0.5, 0.5)), None);
}
