//! What the engine touches with.

use super::*;
use crate::outline::body::first_face;
use carom_feeder::PartKind;

/// A rectangle of 6 by 2 with corners rounded by these radii, from loose lines and arcs.
fn rounded(radii: [f64; 4]) -> Vec<String> {
    let [a, b, c, d] = radii;
    let line = |x: f64, y: f64, to_x: f64, to_y: f64| format!("LINE 10 {x} 20 {y} 11 {to_x} 21 {to_y}");
    let arc = |x: f64, y: f64, r: f64, start: f64| {
        format!("ARC 10 {x} 20 {y} 40 {r} 50 {start} 51 {}", start + 90.0)
    };
    vec![
        line(a, 0.0, 6.0 - b, 0.0),
        line(6.0, b, 6.0, 2.0 - c),
        arc(6.0 - b, b, b, 270.0),
        arc(a, a, a, 180.0),
        // Drawn the other way.
        line(d, 2.0, 6.0 - c, 2.0),
        line(0.0, a, 0.0, 2.0 - d),
        arc(6.0 - c, 2.0 - c, c, 0.0),
        arc(d, 2.0 - d, d, 90.0),
    ]
}

fn solid_of(entities: &[String]) -> body::Solid {
    solid(&drawn(&entities.iter().map(String::as_str).collect::<Vec<_>>()))
}

#[test]
fn a_rounded_rectangle_keeps_its_arcs() {
    let found = solid_of(&rounded([0.5; 4]));
    assert_eq!((found.kind, found.shape.faces(), found.shape.radius()), (PartKind::Polygon, 4, 0.5));
    // Face 0 is the lower long side; the vertices are the arcs' centres about the mass centre.
    close_to(found.shape.vertices()[0], Vec2::new(-2.5, -0.5), "vertex 0");
    close_to(found.shape.vertices()[2], Vec2::new(2.5, 0.5), "vertex 2");
    let own = carom_motion::planar::MassProperties::of(&found.shape);
    close(found.properties.area, own.area, "area of the rounded polygon");
    close(found.properties.gyration_squared, own.gyration_squared, "its gyration squared");
    assert!(found.notes.iter().any(|note| note.starts_with("arcs kept: 4 corners")), "{:?}", found.notes);
}

#[test]
fn arcs_are_kept_from_any_notation_and_whichever_way_they_run() {
    let expected = solid_of(&rounded([0.5; 4])).shape;
    let rect = "<rect x=\"7\" y=\"3\" width=\"6\" height=\"2\" rx=\"0.5\"/>";
    let mirrored = format!("<g transform=\"scale(-1 1)\">{rect}</g>");
    let halves = "<path d=\"M 0.5 0 H 5.5 A .5 .5 0 0 1 5.853553390593274 .14644660940672624 A .5 .5 0 0 1 6 .5 V 1.5 A .5 .5 0 0 1 5.5 2 H .5 A .5 .5 0 0 1 0 1.5 V .5 A .5 .5 0 0 1 .5 0 Z\"/>";
    for text in [rect, &mirrored, halves] {
        let found = solid(&svg(text)).shape;
        close(found.radius(), 0.5, text);
        for (found, expected) in found.vertices().iter().zip(expected.vertices()) {
            close_to(*found, *expected, text);
        }
    }
}

#[test]
fn arcs_of_two_radii_are_not_kept() {
    let found = solid_of(&rounded([0.5, 0.5, 0.5, 0.4]));
    assert_eq!(found.shape.radius(), 0.0, "chords instead");
    assert!(found.shape.faces() > 20, "{} faces", found.shape.faces());
}

#[test]
fn a_corner_that_is_sharp_is_not_rounded() {
    let found = solid(&drawn(&["LWPOLYLINE 70 1 10 0 20 0 10 5 20 0 42 1 10 5 20 2 10 0 20 2"]));
    assert_eq!(found.shape.radius(), 0.0, "chords instead");
}

#[test]
fn an_obround_is_a_rod_with_round_ends() {
    let found = solid(&drawn(&["LWPOLYLINE 70 1 10 0 20 0 10 4 20 0 42 1 10 4 20 2 10 0 20 2 42 1"]));
    assert_eq!((found.shape.faces(), found.shape.radius()), (2, 1.0));
    close_to(found.shape.vertices()[0], Vec2::new(-2.0, 0.0), "vertex 0");
    assert_eq!(found.kind, PartKind::Polygon, "its verdicts are numbers of faces");
}

#[test]
fn an_arc_that_hides_within_the_hull_does_not_matter() {
    // A bump of another radius in a notch of the long side.
    let bump = "LWPOLYLINE 70 1 10 0 20 0 10 1 20 0 10 1 20 0.5 10 1.5 20 0.5 42 -0.5 10 2.5 20 0.5 10 3 20 0.5 10 3 20 0 10 4 20 0 42 1 10 4 20 2 10 0 20 2 42 1";
    let found = solid(&drawn(&[bump]));
    assert_eq!((found.shape.faces(), found.shape.radius()), (2, 1.0));
}

#[test]
fn a_disc_is_kept_while_its_mass_centre_is_its_centre() {
    let ring = solid(&drawn(&["CIRCLE 10 5 20 -2 40 3", "CIRCLE 10 5 20 -2 40 1"]));
    assert_eq!((ring.kind, ring.shape.vertices().len(), ring.shape.radius()), (PartKind::Disc, 1, 3.0));
    let cam = solid(&drawn(&["CIRCLE 10 5 20 -2 40 3", "CIRCLE 10 6 20 -2 40 1"]));
    assert_eq!((cam.kind, cam.shape.radius()), (PartKind::Polygon, 0.0));
}

/// Outlines with curves on their hulls.
const CURVED: [&str; 4] = [
    "<circle cx=\"0\" cy=\"0\" r=\"3\"/><circle cx=\"1\" cy=\"0\" r=\"1\"/>",
    "<path d=\"M 0 0 L 4 0 A 1 1 0 0 1 6 0 L 8 0 C 11 1 7 3 8 5 A 3 1.5 20 0 1 3 6 A 2 2 0 1 0 0 4 Z\"/>",
    "<path d=\"M 0 0 L 5 0 A 2 2 0 0 1 5 4 L 0 4 Z\"/>",
    "<ellipse cx=\"2\" cy=\"1\" rx=\"4\" ry=\"1\"/>",
];

#[test]
fn chords_stay_within_their_tolerance() {
    for text in CURVED {
        for chord in [None, Some(0.1), Some(0.001)] {
            let outline = FileOutline { chord: chord.unwrap_or(svg(text).chord), ..svg(text) };
            let found = solid(&outline);
            let allowed = chord.unwrap_or(CHORD * outline.size);
            let corners = found.shape.vertices();
            let beyond = |point: Vec2| {
                let faces = 0..found.shape.faces();
                let out = faces.map(|i| found.shape.face_normal(i).dot(point - found.shape.face(i).0));
                out.fold(f64::NEG_INFINITY, f64::max)
            };
            let edges = &outline.nest.outer.edges;
            let places =
                |edge: &edge::Edge| (0..5000).map(|i| edge.point(f64::from(i) / 5000.0)).collect::<Vec<_>>();
            let points: Vec<Vec2> =
                edges.iter().flat_map(places).map(|point| point - found.properties.centroid).collect();
            let farthest = points.iter().map(|point| beyond(*point)).fold(f64::NEG_INFINITY, f64::max);
            assert!(farthest <= allowed, "{text}: {farthest} beyond chords of {allowed}");
            // As good as the tolerance asks for, and no better.
            assert!(farthest >= 0.2 * allowed, "{text}: {farthest} of {allowed}");
            // Every vertex is a point of the outline: within half a step of 5000 on an edge of length 40 at most.
            for corner in corners {
                let nearest =
                    points.iter().map(|point| (*point - *corner).norm()).fold(f64::INFINITY, f64::min);
                assert!(nearest < 0.5 * 40.0 / 5000.0, "{text}: a vertex {nearest} off the outline");
            }
        }
    }
}

#[test]
fn a_mirrored_outline_has_a_mirrored_hull() {
    for text in CURVED {
        let plain = solid(&svg(text));
        let mirrored = solid(&svg(&format!("<g transform=\"scale(-1 1)\">{text}</g>")));
        assert_eq!(plain.shape.faces(), mirrored.shape.faces(), "{text}");
        let slack = 1e-12 * plain.shape.size();
        for corner in plain.shape.vertices() {
            let image = Vec2::new(-corner.x, corner.y);
            let nearest =
                mirrored.shape.vertices().iter().map(|v| (*v - image).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < slack, "{text}: {nearest}");
        }
    }
}

#[test]
fn hollows_and_what_fills_them_are_said() {
    let found = solid(&drawn(&["LWPOLYLINE 70 1 10 0 20 0 10 4 20 0 10 1 20 1 10 0 20 4"]));
    // From (1, 1) to the line x + y = 4: 2/√2. The hull's area is 8, the outline's 4.
    let hull = &found.approximations[0];
    assert_eq!(
        (hull.amount, hull.faces.as_slice()),
        (1.0, [1].as_slice()),
        "twice the area; the line from tip to tip"
    );
    let said =
        hull.text.contains("adds 100 % to the area") && hull.text.contains("hollows up to 1.41 m deep");
    assert!(said, "{}", hull.text);
}

#[test]
fn an_outline_of_very_many_corners_is_thinned_out() {
    // 3000 corners on a circle of radius 1, in straight lines.
    let corner = |i: u32| {
        let (sin, cos) = carom_num::elementary::sin_cos(f64::from(i) * std::f64::consts::TAU / 3000.0);
        format!("10 {cos} 20 {sin}")
    };
    let entity = format!("LWPOLYLINE 70 1 {}", (0..3000).map(corner).collect::<Vec<_>>().join(" "));
    let found = solid(&drawn(&[&entity]));
    // Chords of one length would be 50: 1 − cos(π/50) = 0.002, the tolerance. One at a time they do not come out so even.
    assert!((50..=75).contains(&found.shape.faces()), "{} faces", found.shape.faces());
    let least = (0..found.shape.faces()).map(|i| found.shape.face_normal(i).dot(found.shape.face(i).0));
    let least = least.fold(f64::INFINITY, f64::min);
    assert!(least >= 1.0 - 0.002 - 1e-5, "{least}");
}

#[test]
fn face_0_is_the_longest_then_the_lowest_then_the_rightmost() {
    let corners = |list: &[(f64, f64)]| list.iter().map(|(x, y)| Vec2::new(*x, *y)).collect::<Vec<_>>();
    assert_eq!(
        first_face(&corners(&[(1.0, 0.0), (1.0, 5.0), (0.0, 5.0), (0.0, 0.0)]), 0.0, |_| true),
        0,
        "the right one of two"
    );
    assert_eq!(
        first_face(&corners(&[(0.0, 2.0), (0.0, 0.0), (3.0, 0.0), (3.0, 2.0)]), 0.0, |_| true),
        1,
        "the lower one of two"
    );
    assert_eq!(first_face(&corners(&[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)]), 0.0, |_| true), 1, "the longest");
    // The two faces of an obround have one line of centres.
    assert_eq!(first_face(&corners(&[(0.0, 0.0), (4.0, 0.0)]), 1.0, |_| true), 0, "the lower one");
    assert_eq!(
        first_face(&corners(&[(4.0, 0.0), (0.0, 0.0)]), 1.0, |_| true),
        1,
        "the lower one of the other order"
    );
    assert_eq!(first_face(&corners(&[(0.0, 4.0), (0.0, 0.0)]), 1.0, |_| true), 1, "the right one");
}
