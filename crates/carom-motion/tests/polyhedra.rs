//! Hulls of points and what fills them, against closed forms and against other sums.

use carom_motion::spatial::{HullProblem, Polyhedron, Solid};
use carom_num::elementary::sin_cos;
use carom_num::{Mat3, Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::{PI, TAU};

/// What counts as flat, of bodies of about 1 m.
const FLAT: f64 = 1e-9;

fn random() -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(20_261_121)
}

fn drawn(random: &mut Pcg64Mcg) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| random.random_range(-1.0..1.0)))
}

fn cuboid([a, b, c]: [f64; 3]) -> Vec<Vec3> {
    let sign = |i: u32, k: u32| f64::from(2 * (i >> k & 1)) - 1.0;
    (0..8).map(|i| Vec3::new(0.5 * a * sign(i, 0), 0.5 * b * sign(i, 1), 0.5 * c * sign(i, 2))).collect()
}

fn prism(sides: u32, radius: f64, height: f64) -> Vec<Vec3> {
    let ring = |z: f64| {
        (0..sides).map(move |j| {
            let (sin, cos) = sin_cos(TAU * f64::from(j) / f64::from(sides));
            Vec3::new(radius * cos, radius * sin, z)
        })
    };
    ring(-0.5 * height).chain(ring(0.5 * height)).collect()
}

fn placed(points: &[Vec3], turn: Vec3, shift: Vec3) -> Vec<Vec3> {
    points.iter().map(|r| Rotation::by(turn).apply(*r) + shift).collect()
}

fn difference(a: Mat3, b: Mat3) -> f64 {
    (a - b).rows.iter().map(|row| row.norm()).fold(0.0, f64::max)
}

/// A solid that is turned and moved, against the closed form of it where it lies at the origin.
fn check(name: &str, points: &[Vec3], volume: f64, centre: Vec3, moments: [f64; 3]) {
    let mut random = random();
    for case in 0..20 {
        let (turn, shift) =
            if case == 0 { (Vec3::ZERO, Vec3::ZERO) } else { (drawn(&mut random) * 3.0, drawn(&mut random)) };
        let found = Polyhedron::of_points(&placed(points, turn, shift), FLAT).unwrap().solid().unwrap();
        let attitude = Rotation::by(turn);
        let inertia = attitude.turn(Mat3::diagonal(moments[0], moments[1], moments[2]));
        let largest = moments.into_iter().fold(0.0, f64::max);
        assert!((found.volume - volume).abs() < 1e-14 * volume, "{name}, case {case}: {found:?}");
        assert!(
            (found.centre - attitude.apply(centre) - shift).norm() < 2e-15,
            "{name}, case {case}: {found:?}"
        );
        assert!(difference(found.inertia, inertia) < 1e-14 * largest, "{name}, case {case}: {found:?}");
    }
}

#[test]
fn solids_have_the_moments_of_their_closed_forms() {
    let [a, b, c] = [1.0, 0.6, 0.3];
    let v = a * b * c;
    let box_moments = [b * b + c * c, a * a + c * c, a * a + b * b].map(|s| v * s / 12.0);
    check("box", &cuboid([a, b, c]), v, Vec3::ZERO, box_moments);

    // A regular tetrahedron of edge 1: volume √2/12, every moment V/20.
    let s = 0.5 / 2.0_f64.sqrt();
    let tetrahedron = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]]
        .map(|r: [f64; 3]| Vec3::from_array(r) * s);
    let v = 2.0_f64.sqrt() / 12.0;
    check("tetrahedron", &tetrahedron, v, Vec3::ZERO, [v / 20.0; 3]);

    // A hexagon of circumradius a has the area 3√3/2 a² and q = 1 − (2/3) sin² 30°.
    let (radius, height) = (0.5, 0.8);
    let q = 1.0 - 2.0 / 3.0 * 0.25;
    let v = 1.5 * 3.0_f64.sqrt() * radius * radius * height;
    let base = v * radius * radius * q;
    let across = 0.25 * base + v * height * height / 12.0;
    check("hexagonal prism", &prism(6, radius, height), v, Vec3::ZERO, [across, across, 0.5 * base]);

    // A pyramid on a square of side 1 and height 1: its centre is at a quarter of it, J = V (1/20 + 3/80) and V/10.
    let pyramid: Vec<Vec3> =
        cuboid([1.0, 1.0, 0.0]).into_iter().take(4).chain([Vec3::new(0.0, 0.0, 1.0)]).collect();
    let v = 1.0 / 3.0;
    let across = v * (0.05 + 0.0375);
    check("pyramid", &pyramid, v, Vec3::Z * 0.25, [across, across, 0.1 * v]);
}

/// The same integrals by tetrahedra from another point, inside, by the formula of a tetrahedron about its own centre.
fn from_within(hull: &Polyhedron, from: Vec3) -> Solid {
    let mut parts: Vec<(f64, Vec3, Mat3)> = vec![];
    for face in hull.faces() {
        for k in 1..face.corners.len() - 1 {
            let corners = [from]
                .into_iter()
                .chain([face.corners[0], face.corners[k], face.corners[k + 1]].map(|i| hull.vertices()[i]));
            let corners: Vec<Vec3> = corners.collect();
            let [a, b, c] = [1, 2, 3].map(|i| corners[i] - corners[0]);
            let volume = a.dot(b.cross(c)) / 6.0;
            let mean = corners.iter().fold(Vec3::ZERO, |s, r| s + *r) * 0.25;
            // Σ (rᵢ − r̄)(rᵢ − r̄)ᵀ V/20 about the centre of a tetrahedron.
            let about = corners.iter().fold(Mat3::ZERO, |s, r| s + Mat3::dyad(*r - mean, *r - mean))
                * (volume / 20.0);
            parts.push((volume, mean, about));
        }
    }
    let volume: f64 = parts.iter().map(|p| p.0).sum();
    let centre = parts.iter().fold(Vec3::ZERO, |s, p| s + p.1 * p.0) / volume;
    let about = parts
        .iter()
        .fold(Mat3::ZERO, |s, (v, mean, own)| s + *own + Mat3::dyad(*mean - centre, *mean - centre) * *v);
    let trace: f64 = about.rows[0].x + about.rows[1].y + about.rows[2].z;
    Solid { volume, centre, inertia: Mat3::diagonal(trace, trace, trace) - about }
}

#[test]
fn random_polyhedra_agree_with_tetrahedra_from_another_point() {
    let mut random = random();
    for case in 0..60 {
        let points: Vec<Vec3> = (0..4 + case).map(|_| drawn(&mut random)).collect();
        let hull = Polyhedron::of_points(&points, FLAT).unwrap();
        let solid = hull.solid().unwrap();
        let share = random.random_range(0.2..0.8);
        let from = solid.centre * share + points[hull.sources()[0]] * (1.0 - share);
        let other = from_within(&hull, from);
        assert!((solid.volume - other.volume).abs() < 1e-13, "case {case}: {solid:?} {other:?}");
        assert!((solid.centre - other.centre).norm() < 1e-11, "case {case}: {solid:?} {other:?}");
        assert!(difference(solid.inertia, other.inertia) < 1e-12, "case {case}: {solid:?} {other:?}");
    }
}

#[test]
fn a_random_polyhedron_has_the_moments_of_points_within() {
    // A million points in the box: the standard error of a mean over it is below 2e-3 of its size here.
    let mut random = random();
    let points: Vec<Vec3> = (0..30).map(|_| drawn(&mut random)).collect();
    let hull = Polyhedron::of_points(&points, FLAT).unwrap();
    let solid = hull.solid().unwrap();
    let offsets: Vec<(Vec3, f64)> =
        hull.faces().iter().map(|f| (f.normal, f.normal.dot(hull.vertices()[f.corners[0]]))).collect();
    let (mut inside, mut first, mut second) = (0.0, Vec3::ZERO, 0.0);
    let all = 200_000;
    for _ in 0..all {
        let r = drawn(&mut random);
        if offsets.iter().all(|(n, c)| n.dot(r) <= *c) {
            inside += 1.0;
            first += r;
            second += (r - solid.centre).dot(r - solid.centre);
        }
    }
    let volume = 8.0 * inside / f64::from(all);
    assert!((volume - solid.volume).abs() < 0.03, "{volume} {solid:?}");
    assert!((first / inside - solid.centre).norm() < 0.006, "{first:?} {solid:?}");
    let trace = solid.inertia.rows[0].x + solid.inertia.rows[1].y + solid.inertia.rows[2].z;
    let polar = 2.0 * second / inside * solid.volume;
    assert!((polar - trace).abs() < 0.01 * trace, "{polar} {trace}");
}

/// Every point is below every face, every side belongs to two faces, and corners, sides and faces satisfy Euler's formula.
fn is_hull(hull: &Polyhedron, points: &[Vec3], flat: f64, name: &str) {
    for (number, face) in hull.faces().iter().enumerate() {
        let offset = face.normal.dot(hull.vertices()[face.corners[0]]);
        let out = points.iter().map(|r| face.normal.dot(*r) - offset).fold(f64::NEG_INFINITY, f64::max);
        assert!(out <= 4.0 * flat, "{name}: {out} m over face {number}");
    }
    let sides: Vec<(usize, usize)> = hull
        .faces()
        .iter()
        .flat_map(|f| (0..f.corners.len()).map(|k| (f.corners[k], f.corners[(k + 1) % f.corners.len()])))
        .collect();
    for (a, b) in &sides {
        let back = sides.iter().filter(|side| **side == (*b, *a)).count();
        assert_eq!(back, 1, "{name}: the side {a} {b}");
    }
    let (v, e, f) = (hull.vertices().len(), sides.len() / 2, hull.faces().len());
    assert_eq!(v + f, e + 2, "{name}: {v} vertices, {e} sides, {f} faces");
}

#[test]
fn hulls_of_random_points_contain_them_all() {
    let mut random = random();
    for case in 0..60 {
        let count = 4 + case * case / 4;
        let points: Vec<Vec3> = (0..count).map(|_| drawn(&mut random)).collect();
        is_hull(&Polyhedron::of_points(&points, FLAT).unwrap(), &points, FLAT, &format!("case {case}"));
    }
}

#[test]
fn points_on_a_sphere_are_all_vertices() {
    let mut random = random();
    let points: Vec<Vec3> = (0..1500).filter_map(|_| drawn(&mut random).unit()).collect();
    let hull = Polyhedron::of_points(&points, 1e-12).unwrap();
    assert_eq!((hull.vertices().len(), hull.faces().len()), (1500, 2996));
    is_hull(&hull, &points, 1e-12, "sphere");
}

#[test]
fn points_within_on_sides_and_on_faces_are_no_vertices() {
    // Boxes and prisms, with points on their sides and faces and within, turned and rounded to 24 binary digits as in an STL file.
    let mut random = random();
    for case in 0..120_u32 {
        let sides = 3 + case % 9;
        let corners = prism(sides, 1.0, 0.3 + 0.02 * f64::from(case));
        let mut points = corners.clone();
        let n = sides as usize;
        for j in 0..n {
            let [a, b, c] = [corners[j], corners[(j + 1) % n], corners[n + j]];
            points.push(a * 0.3 + b * 0.7);
            points.push(a * 0.5 + c * 0.5);
            points.push(a * 0.4 + b * 0.3 + c * 0.3);
            points.push(a * 0.1);
            points.push(Vec3::new(0.0, 0.0, a.z));
        }
        let round = |x: f64| f64::from(x as f32);
        let turned = placed(&points, drawn(&mut random) * 3.0, drawn(&mut random) * 2.0);
        let points: Vec<Vec3> =
            turned.iter().map(|r| Vec3::new(round(r.x), round(r.y), round(r.z))).collect();
        let flat = 3.0 * 16.0 * f64::from(f32::EPSILON);
        let hull = Polyhedron::of_points(&points, flat).unwrap();
        is_hull(&hull, &points, flat, &format!("case {case}"));
        assert_eq!((hull.vertices().len(), hull.faces().len()), (2 * n, n + 2), "case {case}");
        assert!(hull.sources().iter().all(|i| *i < 2 * n), "case {case}: {:?}", hull.sources());
        assert!(hull.unevenness() < 4e-15, "case {case}: {}", hull.unevenness());
        assert!(hull.moved() < flat, "case {case}: {}", hull.moved());
    }
}

#[test]
fn faces_come_in_the_order_of_their_corners_whatever_the_turn() {
    let points = prism(6, 0.5, 0.3);
    let faces = |points: &[Vec3]| {
        let hull = Polyhedron::of_points(points, FLAT).unwrap();
        hull.faces().iter().map(|f| f.corners.clone()).collect::<Vec<_>>()
    };
    let mut random = random();
    let first = faces(&points);
    assert_eq!(first[0], [0, 1, 7, 6], "a side");
    assert_eq!(first[1], [0, 5, 4, 3, 2, 1], "the base, seen from below");
    for case in 0..30 {
        let turned = placed(&points, drawn(&mut random) * 3.0, drawn(&mut random));
        assert_eq!(faces(&turned), first, "case {case}");
    }
}

#[test]
fn points_without_a_volume_are_refused() {
    let problem = |points: &[Vec3]| Polyhedron::of_points(points, FLAT).unwrap_err();
    assert_eq!(problem(&[]), [HullProblem::TooFew { count: 0 }]);
    assert_eq!(problem(&[Vec3::X; 9]), [HullProblem::TooFew { count: 1 }]);
    let line: Vec<Vec3> = (0..9).map(|i| Vec3::new(f64::from(i), 2.0 * f64::from(i), 0.5)).collect();
    assert!(matches!(problem(&line)[..], [HullProblem::Flat { .. }]), "{:?}", problem(&line));
    let mut random = random();
    let plane: Vec<Vec3> = (0..40).map(|_| drawn(&mut random)).map(|r| r - Vec3::Z * r.z).collect();
    let plane = placed(&plane, drawn(&mut random), Vec3::ZERO);
    assert!(matches!(problem(&plane)[..], [HullProblem::Flat { .. }]), "{:?}", problem(&plane));
    let mut lost = cuboid([1.0; 3]);
    lost[2].x = f64::NAN;
    lost[5].z = f64::INFINITY;
    assert_eq!(problem(&lost), [2, 5].map(|point| HullProblem::NotFinite { point }));
}

#[test]
fn a_stance_is_the_projection_of_the_mass_centre() {
    let hull = Polyhedron::of_points(&cuboid([1.0, 0.6, 0.2]), FLAT).unwrap();
    for face in 0..6 {
        let stance = hull.stance(face, Vec3::ZERO).unwrap();
        let normal = hull.faces()[face].normal;
        let half = [normal.x, normal.y, normal.z].map(f64::abs);
        let height = 0.5 * half[0] + 0.3 * half[1] + 0.1 * half[2];
        let others = [(0.5, half[0]), (0.3, half[1]), (0.1, half[2])];
        let margin = others.iter().filter(|(_, n)| *n < 0.5).map(|(l, _)| *l).fold(1.0, f64::min);
        assert!((stance.height - height).abs() < 1e-15, "{face}: {stance:?}");
        assert!((stance.margin - margin).abs() < 1e-15, "{face}: {stance:?}");
    }
    assert!(hull.stance(0, Vec3::new(0.6, 0.0, 0.0)).unwrap().margin < 0.0, "beyond the face");
    assert_eq!(hull.stance(6, Vec3::ZERO), None);
    // An oblique prism of a slope of 60° falls over its long side.
    let leaning: Vec<Vec3> =
        cuboid([0.2, 0.2, 1.0]).into_iter().map(|r| r + Vec3::X * (r.z + 0.5) * (PI / 3.0)).collect();
    let hull = Polyhedron::of_points(&leaning, FLAT).unwrap();
    let centre = hull.solid().unwrap().centre;
    let base = hull.faces().iter().position(|f| f.normal.z < -0.99).unwrap();
    assert!(hull.stance(base, centre).unwrap().margin < 0.0, "its centre is beside the base");
}
