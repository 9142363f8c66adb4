//! Area, centroid and moment: textbook shapes, and polygons of very many corners.

use super::*;
use std::f64::consts::PI;

/// Pieces of a composite section: area, centroid, polar moment about that centroid.
struct Part(f64, Vec2, f64);

fn rectangle(low: (f64, f64), high: (f64, f64)) -> Part {
    let (b, h) = (high.0 - low.0, high.1 - low.1);
    Part(b * h, Vec2::new(low.0 + 0.5 * b, low.1 + 0.5 * h), b * h * (b * b + h * h) / 12.0)
}

fn disc(centre: (f64, f64), r: f64) -> Part {
    Part(PI * r * r, Vec2::new(centre.0, centre.1), 0.5 * PI * r * r * r * r)
}

/// A quarter of a disc about `centre`, towards (±1, ±1).
fn quarter(centre: (f64, f64), r: f64, towards: (f64, f64)) -> Part {
    let c = 4.0 * r / (3.0 * PI);
    let area = 0.25 * PI * r * r;
    let own = area * (0.5 * r * r - 2.0 * c * c);
    Part(area, Vec2::new(centre.0 + towards.0 * c, centre.1 + towards.1 * c), own)
}

/// Area, centroid and gyration² of pieces, each taken so many times.
fn composed(parts: &[(f64, Part)]) -> (f64, Vec2, f64) {
    let area: f64 = parts.iter().map(|(sign, part)| sign * part.0).sum();
    let first = parts.iter().fold(Vec2::ZERO, |sum, (sign, part)| sum + part.1 * (sign * part.0));
    let centroid = first / area;
    let polar = |part: &Part| part.2 + part.0 * (part.1 - centroid).dot(part.1 - centroid);
    let polar: f64 = parts.iter().map(|(sign, part)| sign * polar(part)).sum();
    (area, centroid, polar / area)
}

fn check(outline: &FileOutline, (area, centroid, gyration_squared): (f64, Vec2, f64)) {
    let found = solid(outline).properties;
    close(found.area, area, "area");
    close_to(found.centroid, centroid, "centroid");
    close(found.gyration_squared, gyration_squared, "gyration squared");
}

#[test]
fn a_disc_of_two_bulges_has_pi_r_squared() {
    let found = drawn(&["LWPOLYLINE 70 1 10 -1 20 3 42 1 10 2 20 3 42 1"]);
    let moments = solid(&found).properties;
    // The last digits: nothing but rounding.
    assert!((moments.area - 2.25 * PI).abs() <= 8.0 * f64::EPSILON * moments.area, "{}", moments.area);
    check(&found, composed(&[(1.0, disc((0.5, 3.0), 1.5))]));
}

#[test]
fn a_ring_is_a_disc_without_a_disc() {
    let found = drawn(&["CIRCLE 10 5 20 -2 40 3", "CIRCLE 10 5 20 -2 40 1"]);
    check(&found, (8.0 * PI, Vec2::new(5.0, -2.0), 5.0));
}

#[test]
fn a_bracket_with_a_fillet_and_a_hole_is_composed_of_textbook_parts() {
    // 40 × 30, legs 8, inner corner rounded by 4 about (12, 12), hole of 5 at (30, 4).
    let found = drawn(&[
        "LWPOLYLINE 70 1 10 0 20 0 10 40 20 0 10 40 20 8 10 12 20 8 42 -0.41421356237309503 10 8 20 12 10 8 20 30 10 0 20 30",
        "CIRCLE 10 30 20 4 40 2.5",
    ]);
    check(
        &found,
        composed(&[
            (1.0, rectangle((0.0, 0.0), (40.0, 8.0))),
            (1.0, rectangle((0.0, 8.0), (8.0, 30.0))),
            (1.0, rectangle((8.0, 8.0), (12.0, 12.0))),
            (-1.0, quarter((12.0, 12.0), 4.0, (-1.0, -1.0))),
            (-1.0, disc((30.0, 4.0), 2.5)),
        ]),
    );
}

#[test]
fn an_ellipse_has_pi_a_b() {
    let found = drawn(&["ELLIPSE 10 1 20 2 11 3 21 0 40 0.5 41 0 42 6.283185307179586"]);
    check(&found, (4.5 * PI, Vec2::new(1.0, 2.0), (9.0 + 2.25) / 4.0));
}

#[test]
fn a_very_flat_arc_keeps_its_digits() {
    // Sagitta bulge/2 of a chord of 1, radius 1/(4 bulge): an area of bulge/3 × chord² in the limit.
    let bulge = 1e-7;
    let entity = format!("LWPOLYLINE 70 1 10 0 20 0 42 {bulge} 10 1 20 0 10 1 20 1 10 0 20 1");
    let area = solid(&drawn(&[&entity])).properties.area;
    assert!((area - 1.0 - bulge / 3.0).abs() <= 4.0 * f64::EPSILON, "{area}");
}

/// Shoelace sums over the corners of a polygon: another way to the same numbers.
fn shoelace(corners: &[Vec2]) -> (f64, Vec2, f64) {
    let (mut area, mut first, mut polar) = (0.0, Vec2::ZERO, 0.0);
    for (i, p) in corners.iter().enumerate() {
        let q = corners[(i + 1) % corners.len()];
        let doubled = p.x * q.y - q.x * p.y;
        area += 0.5 * doubled;
        first += Vec2::new((p.x + q.x) * doubled / 6.0, (p.y + q.y) * doubled / 6.0);
        let squares = |p: f64, q: f64| p * p + p * q + q * q;
        polar += doubled * (squares(p.x, q.x) + squares(p.y, q.y)) / 12.0;
    }
    (area, first / area, polar / area - (first / area).dot(first / area))
}

#[test]
fn masses_are_the_limit_of_many_corners() {
    // Arcs of both turns, an ellipse's arc and a cubic, in user units with y down.
    let path = "M 0 0 L 4 0 A 1 1 0 0 1 6 0 L 8 0 C 11 1 7 3 8 5 A 3 1.5 20 0 1 3 6 A 2 2 0 1 0 0 4 Z";
    let found = svg(&format!("<path d=\"{path}\"/>"));
    let error_of = |steps: usize| {
        let edges = &found.nest.outer.edges;
        let corners: Vec<Vec2> = edges
            .iter()
            .flat_map(|edge| (0..steps).map(move |i| edge.point(i as f64 / steps as f64)))
            .collect();
        let (area, centroid, gyration) = shoelace(&corners);
        let exact = solid(&found).properties;
        [
            (area - exact.area) / exact.area,
            (centroid - exact.centroid).norm(),
            (gyration - exact.gyration_squared) / exact.gyration_squared,
        ]
    };
    let (coarse, fine) = (error_of(500), error_of(1000));
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(fine.abs() < 1e-5, "{fine}");
        // Chords are off by the square of their length, with no limit but zero.
        assert!((coarse / fine - 4.0).abs() < 1e-3, "{coarse} and {fine}");
    }
}

#[test]
fn a_turned_and_shifted_outline_has_the_same_moments() {
    let path = "M 0 0 L 4 0 A 1 1 0 0 1 6 0 L 8 0 C 11 1 7 3 8 5 A 3 1.5 20 0 1 3 6 A 2 2 0 1 0 0 4 Z";
    let plain = solid(&svg(&format!("<path d=\"{path}\"/>")));
    let turned = solid(&svg(&format!(
        "<g transform=\"translate(3 -7)\"><path transform=\"rotate(33)\" d=\"{path}\"/></g>"
    )));
    let mirrored = solid(&svg(&format!("<path transform=\"scale(-1 1)\" d=\"{path}\"/>")));
    for other in [turned, mirrored] {
        close(other.properties.area, plain.properties.area, "area");
        close(other.properties.gyration_squared, plain.properties.gyration_squared, "gyration squared");
    }
}

#[test]
fn the_body_is_drawn_about_the_mass_centre_of_the_true_outline() {
    // A dart: three corners and an inner one.
    let found = solid(&drawn(&["LWPOLYLINE 70 1 10 0 20 0 10 4 20 0 10 1 20 1 10 0 20 4"]));
    // The triangle (0,0) (4,0) (0,4) without the triangle (4,0) (0,4) (1,1): 8 − 4.
    let centroid = Vec2::new(8.0 * 4.0 / 3.0 - 4.0 * 5.0 / 3.0, 8.0 * 4.0 / 3.0 - 4.0 * 5.0 / 3.0) / 4.0;
    close(found.properties.area, 4.0, "area");
    close_to(found.properties.centroid, centroid, "centroid");
    let corners = found.shape.vertices();
    assert_eq!(
        (corners.len(), found.shape.hull().vertices().len()),
        (4, 3),
        "three corners and an inner one"
    );
    // The line from (4, 0) to (0, 4) is longer, but no side: face 0 is the lower one of the two sides.
    close_to(corners[0], Vec2::ZERO - centroid, "vertex 0");
    close_to(corners[1], Vec2::new(4.0, 0.0) - centroid, "vertex 1");
    close(found.shape.face_normal(0).y, -1.0, "normal of face 0");
}
