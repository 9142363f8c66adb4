//! Surfaces that are cut, against what they were.

use super::super::form::Form;
use super::*;
use carom_num::Rotation;
use carom_num::elementary::{cos, sin};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

fn drawn(rng: &mut Pcg64) -> Vec3 {
    Vec3::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0))
}

fn length(of: &Form) -> f64 {
    of.outside().edges.iter().map(|edge| edge.length).sum()
}

fn area(of: &Form) -> f64 {
    of.polygons().iter().map(|polygon| 0.5 * newell(polygon).norm()).sum()
}

/// Cuts through corners and along edges too: what the pieces have outside is what the whole has.
#[test]
fn pieces_of_a_hull_have_the_surface_of_the_whole() {
    let mut rng = Pcg64::seed_from_u64(1);
    for case in 0..60 {
        let points: Vec<Vec3> = (0..8).map(|_| drawn(&mut rng)).collect();
        let hull = Polyhedron::of_points(&points, 1e-9).unwrap();
        let mut pieces = vec![hull.clone()];
        for _ in 0..1 + case % 3 {
            // Two corners of the hull and a third place, which may be one as well.
            let third = if case % 2 == 0 { drawn(&mut rng) } else { hull.vertices()[2] };
            let Some(cut) = plane_of(&[hull.vertices()[0], hull.vertices()[1], third]) else { continue };
            let halves = |piece: &Polyhedron| [cut, cut.flipped()].map(|cut| piece.behind(&cut, 1e-9));
            pieces = pieces.iter().flat_map(halves).flatten().collect();
        }
        let (whole, cut) = (Form::of_pieces(&[hull], &[]), Form::of_pieces(&pieces, &[]));
        let corners = |form: &Form| form.outside().corners.len();
        assert_eq!(corners(&whole), corners(&cut), "case {case}: {} pieces", pieces.len());
        let off = length(&whole) - length(&cut);
        assert!(off.abs() < 1e-8, "case {case}: edges are {off:e} shorter, {} pieces", pieces.len());
        let off = area(&whole) - area(&cut);
        assert!(off.abs() < 1e-8, "case {case}: faces are {off:e} smaller, {} pieces", pieces.len());
    }
}

/// A prism over a profile that is cut into triangles, turned, with the digits of a file.
fn prism(profile: &[[f64; 2]], triangles: &[[usize; 3]], turned: Rotation) -> Mesh {
    let n = profile.len();
    let at = |z: f64| profile.iter().map(move |[x, y]| turned.apply(Vec3::new(*x, *y, z)));
    let short = |r: Vec3| Vec3::new(f64::from(r.x as f32), f64::from(r.y as f32), f64::from(r.z as f32));
    let mut facets: Vec<[usize; 3]> =
        triangles.iter().flat_map(|&[a, b, c]| [[a, c, b], [a + n, b + n, c + n]]).collect();
    facets.extend((0..n).flat_map(|k| {
        let next = (k + 1) % n;
        [[k, next, k + n], [next, next + n, k + n]]
    }));
    Mesh { vertices: at(0.0).chain(at(1.5)).map(short).collect(), facets }
}

/// A comb of so many teeth.
fn comb(teeth: usize, turned: Rotation) -> Mesh {
    let mut profile = vec![[0.0, -1.0], [2.0 * teeth as f64 - 1.0, -1.0]];
    let mut triangles = vec![];
    for tooth in (0..teeth).rev() {
        let (left, k) = (2.0 * tooth as f64, profile.len());
        profile.extend([[left + 1.0, 0.0], [left + 1.0, 1.0], [left, 1.0], [left, 0.0]]);
        triangles.extend([[k, k + 1, k + 2], [k, k + 2, k + 3]]);
        triangles.push([0, k, k + 3]);
        if tooth > 0 {
            triangles.push([0, k + 3, k + 4]);
        }
    }
    triangles.push([0, 1, 2]);
    prism(&profile, &triangles, turned)
}

/// A corner of a hook is on four planes: with the digits of a file not on all of them.
#[test]
fn a_hook_lies_flat_across_its_hollow() {
    let profile =
        [[0.0, 0.0], [1.0, 0.0], [1.0, 4.0], [5.0, 4.0], [5.0, 1.6], [6.0, 1.6], [6.0, 5.0], [0.0, 5.0]];
    let triangles = [[0, 1, 2], [0, 2, 7], [2, 3, 7], [3, 6, 7], [3, 4, 6], [4, 5, 6]];
    for turned in [Vec3::ZERO, Vec3::new(0.3, 0.7, -0.2), Vec3::new(1.0, 2.0, 0.5)] {
        let hook = prism(&profile, &triangles, Rotation::by(turned));
        let hull = Polyhedron::of_points(&hook.vertices, 1e-5).unwrap();
        let pieces = hook.pieces(1e-5, 8).unwrap();
        let corners = || pieces.iter().flat_map(Polyhedron::vertices);
        for face in hull.faces() {
            let heights = corners().map(|r| face.normal.dot(*r - hull.vertices()[face.corners[0]]));
            let on: Vec<f64> = heights.filter(|height| height.abs() < 1e-4).collect();
            assert!(on.len() >= 4 && on.iter().all(|height| height.abs() < 1e-14), "{turned:?}: {on:?}");
        }
    }
}

/// A ring of six sides with a section of four: its cuts end within edges, with the digits of a file. Those on the edge inside are none where a plane could touch.
#[test]
fn a_ring_has_the_corners_of_its_hull() {
    for turned in [Vec3::ZERO, Vec3::new(0.3, 0.7, -0.2), Vec3::new(1.0, 2.0, 0.5), Vec3::new(-0.4, 0.1, 2.0)]
    {
        let turned = Rotation::by(turned);
        let at = |k: usize| {
            let [around, radius] = [TAU * (k / 4) as f64 / 6.0, [13.0, 10.0, 7.0, 10.0][k % 4]];
            let r = turned.apply(Vec3::new(
                radius * cos(around),
                radius * sin(around),
                [0.0, 3.0, 0.0, -3.0][k % 4],
            ));
            Vec3::new(f64::from(r.x as f32), f64::from(r.y as f32), f64::from(r.z as f32))
        };
        let facets = (0..24).flat_map(|k| {
            let [along, both] = [(k + 4) % 24, (k / 4 * 4 + 4) % 24 + (k + 1) % 4];
            [[k, along, both], [k, both, k / 4 * 4 + (k + 1) % 4]]
        });
        let ring = Mesh { vertices: (0..24).map(at).collect(), facets: facets.collect() };
        let pieces = ring.pieces(1e-5, 32).unwrap();
        let form = Form::of_pieces(&pieces, &[]);
        assert_eq!(form.outside().corners.len(), 18, "{turned:?}: {:?}", form.outside().corners);
    }
}

#[test]
fn a_comb_is_its_back_and_its_teeth() {
    for (teeth, turned) in [(1, Vec3::ZERO), (2, Vec3::ZERO), (4, Vec3::new(0.3, -1.1, 0.4)), (7, Vec3::X)] {
        let comb = comb(teeth, Rotation::by(turned));
        let pieces = comb.pieces(1e-5, 16).unwrap();
        assert_eq!(pieces.len(), if teeth == 1 { 1 } else { teeth + 1 }, "{teeth} teeth");
        // Around both ends, and 1.5 m along each corner that is no inner one.
        let expected = 12.0 * teeth as f64 + 1.5 * (2.0 * teeth as f64 + 2.0);
        let form = Form::of_pieces(&pieces, &[]);
        assert!((length(&form) - expected).abs() < 1e-4, "{teeth}: {} {expected}", length(&form));
        assert_eq!(form.outside().corners.len(), 4 + 4 * teeth, "two of its back, two of each tooth");
        // Both ends, and the sides along the profile.
        let expected = 2.0 * (3.0 * teeth as f64 - 1.0) + 1.5 * (6.0 * teeth as f64);
        assert!((area(&form) - expected).abs() < 1e-4, "{teeth}: {} {expected}", area(&form));
    }
    assert_eq!(comb(7, Rotation::NONE).pieces(1e-5, 5), Err(PiecesProblem::TooMany { most: 5 }));
}
