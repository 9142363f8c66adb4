//! Solid parts of an STL file that touch with their hollows.

use carom_feeder::Verdict;
use carom_num::Vec3;
use carom_num::elementary::{cos, sin};
use carom_scene::{AnyScene, Problems, SolidFaceReport, SpaceScene};
use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::{Path, PathBuf};

fn example(change: impl Fn(String) -> String) -> Result<SpaceScene, Problems> {
    let path = "../../examples/solid_bracket.toml";
    SpaceScene::parse(path, &change(std::fs::read_to_string(path).unwrap()))
}

fn without(text: &str) -> String {
    text.replace("hollows = true", "hollows = false")
}

/// The edge of the plate stops it in its inner corner, and only there does it turn.
#[test]
fn a_bracket_catches_with_its_hollow() {
    let [hollow, filled] = [example(|text| text).unwrap(), example(|text| without(&text)).unwrap()];
    assert!(hollow.approximations().is_empty(), "it touches as it is drawn");
    assert!(filled.approximations()[0].text.contains("hollows = true"), "{:?}", filled.approximations());
    let verdict =
        |scene: &SpaceScene| scene.feeder().run().unwrap().landings.last().unwrap().verdict.unwrap();
    assert_eq!([verdict(&hollow), verdict(&filled)], [Verdict::Face(1), Verdict::Same]);
}

/// The key does not change what a face is called, what the part weighs or how it rests.
#[test]
fn faces_are_those_of_the_hull() {
    let [hollow, filled] = [example(|text| text).unwrap(), example(|text| without(&text)).unwrap()];
    let [with, without] = [&hollow, &filled].map(|scene| &scene.feeder().part);
    assert_eq!((with.body.mass(), with.body.inertia()), (without.body.mass(), without.body.inertia()));
    assert_eq!(
        (with.body.supports().len(), without.body.supports().len()),
        (10, 10),
        "two corners are inner ones"
    );
    for (a, b) in SolidFaceReport::of(&hollow).iter().zip(SolidFaceReport::of(&filled)) {
        assert_eq!((a.face, &a.corners, a.stable), (b.face, &b.corners, b.stable));
        let off = (a.centre_height_m - b.centre_height_m).abs().max((a.margin_m - b.margin_m).abs());
        assert!(off < 1e-8, "the file has seven digits: {a:?} {b:?}");
    }
}

/// A tube, of so many facets around.
fn tube(name: &str, around: usize) -> PathBuf {
    let at = |ring: usize, k: usize| {
        let (radius, z) = [(9.0, 0.0), (9.0, 30.0), (6.0, 30.0), (6.0, 0.0)][ring % 4];
        let angle = TAU * (k % around) as f64 / around as f64;
        format!("vertex {} {} {z}\n", radius * cos(angle), radius * sin(angle))
    };
    let mut text = "solid tube\n".to_owned();
    for (ring, k) in (0..4).flat_map(|ring| (0..around).map(move |k| (ring, k))) {
        let [a, b, c, d] = [at(ring, k), at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k)];
        for [a, b, c] in [[&a, &b, &c], [&a, &c, &d]] {
            write!(text, "facet normal 0 0 0\nouter loop\n{a}{b}{c}endloop\nendfacet\n").unwrap();
        }
    }
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text + "endsolid tube\n").unwrap();
    path
}

/// A scene with a tube.
fn with_tube(around: usize, more: &str) -> Result<AnyScene, Problems> {
    let path = tube(&format!("tube-{around}.stl"), around);
    let text = format!(
        "[part]\nfile = \"{}\"\n{more}\ndensity = 1000\n[contact]\nfriction = 0.3\n[start]\nto_edge = 0.05\n[[plate]]\nslope = \"20 deg\"\nlength = 0.2\n",
        path.file_name().unwrap().to_str().unwrap()
    );
    AnyScene::parse(path.with_file_name("scene.toml").to_str().unwrap(), &text)
}

/// What is outside of its pieces is its surface: none is hidden that is not, and none is told twice.
#[test]
fn a_tube_is_cut_into_pieces() {
    let AnyScene::Space(scene) = with_tube(12, "hollows = true").unwrap() else { panic!("a solid") };
    let body = &scene.feeder().part.body;
    assert_eq!(body.supports().len(), 24, "those outside at both ends: at the inner ones no plane touches");
    let twice = |polygon: &Vec<Vec3>| {
        let pairs = polygon[1..].windows(2);
        pairs
            .map(|pair| (pair[0] - polygon[0]).cross(pair[1] - polygon[0]))
            .fold(Vec3::ZERO, |sum, r| sum + r)
    };
    let area: f64 = body.polygons().iter().map(|polygon| 0.5 * twice(polygon).norm()).sum();
    let [sides, ends] = [24.0 * 30.0 * 15.0 * sin(TAU / 24.0), 12.0 * 45.0 * sin(TAU / 12.0)];
    assert!((area - 1e-6 * (sides + ends)).abs() < 1e-10, "the file has seven digits: {area}");
}

#[test]
fn too_many_pieces_are_said_with_what_to_do() {
    let told = with_tube(80, "hollows = true").unwrap_err().to_string();
    assert!(told.contains("part.hollows") && told.contains("64 convex pieces"), "{told}");
    assert!(told.contains("fewer facets"), "{told}");
}

#[test]
fn what_is_not_a_sharp_solid_from_a_file_has_no_hollows() {
    let rounded = with_tube(12, "hollows = true\ncorner_radius = 0.001").unwrap_err().to_string();
    assert!(rounded.contains("part.corner_radius"), "{rounded}");
    let drawn = |part: &str| {
        let told = example(|text| text.replace("file    = \"bracket.stl\"", part)).unwrap_err();
        assert!(told.to_string().contains("hollows"), "{part}: {told}");
    };
    drawn("box = [0.04, 0.03, 0.02]");
    drawn("vertices = [[0, 0, 0], [0.02, 0, 0], [0, 0.02, 0], [0, 0, 0.02]]");
}
