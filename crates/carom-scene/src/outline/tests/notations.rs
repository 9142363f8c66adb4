//! DXF: units, layers, entities, joining.

use super::*;

/// The corners of the part about its mass centre, each with its neighbours' order kept.
fn corners(outline: &FileOutline) -> Vec<Vec2> {
    solid(outline).shape.vertices().to_vec()
}

const SQUARE: &str = "LWPOLYLINE 8 Part 70 1 10 0 20 0 10 2 20 0 10 2 20 2 10 0 20 2";

fn side(text: &str, unit: Option<&str>) -> f64 {
    let unit = unit.and_then(|symbol| crate::unit::Dimension::Length.unit(symbol));
    let found = read_text(text, Format::Dxf, &Reading { unit, ..Reading::default() });
    2.0 * corners(&found)[1].x
}

#[test]
fn the_header_says_the_unit_and_the_scene_where_it_does_not() {
    for (code, side_of_two) in [(1, 0.0508), (2, 0.6096), (4, 0.002), (5, 0.02), (6, 2.0), (13, 2e-6)] {
        close(side(&dxf(code, &[SQUARE]), None), side_of_two, "side");
    }
    close(side(&dxf(0, &[SQUARE]), Some("mm")), 0.002, "unit of the scene");
    close(side(&dxf(4, &[SQUARE]), Some("mm")), 0.002, "the same unit twice");
    let text = "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n10\n0\n20\n0\n40\n1\n0\nENDSEC\n0\nEOF\n";
    let unit = crate::unit::Dimension::Length.unit("in");
    let found = read_text(text, Format::Dxf, &Reading { unit, ..Reading::default() });
    assert_eq!(solid(&found).shape.radius(), 0.0254, "a file of entities alone");
}

#[test]
fn scale_multiplies_every_length() {
    let outline = drawn(&[SQUARE, "CIRCLE 8 Part 10 1 20 1 40 0.5"]);
    let (plain, scaled) = (solid(&outline), outline.solid(3.0).unwrap());
    close(scaled.properties.area, 9.0 * plain.properties.area, "area");
    close(scaled.properties.gyration_squared, 9.0 * plain.properties.gyration_squared, "gyration squared");
    close(scaled.shape.size(), 3.0 * plain.shape.size(), "size");
}

#[test]
fn only_the_layer_that_is_asked_for_is_read() {
    let text = dxf(6, &[SQUARE, "LINE 8 axes 10 -9 20 1 11 9 21 1", "INSERT 8 frame 2 A4"]);
    let reading = Reading { layer: Some("PART"), ..Reading::default() };
    close(solid(&read_text(&text, Format::Dxf, &reading)).properties.area, 4.0, "area");
    let wrong = Reading { layer: Some("parts"), ..Reading::default() };
    let faults = outline_of(&text, Format::Dxf, "drawn", &wrong).unwrap_err();
    assert_eq!(
        faults[0].text,
        "nothing is drawn on layer \"parts\"; its layers: \"Part\", \"axes\", \"frame\""
    );
}

#[test]
fn what_is_invisible_or_on_paper_is_not_read() {
    let outline = drawn(&[SQUARE, "LINE 67 1 10 -9 20 1 11 9 21 1", "CIRCLE 60 1 10 9 20 9 40 1"]);
    close(solid(&outline).properties.area, 4.0, "area");
}

#[test]
fn layers_that_are_off_or_frozen_are_not_read_unless_asked_for() {
    let entities = [SQUARE, "CIRCLE 8 Off 10 1 20 1 40 0.5", "CIRCLE 8 Cold 10 9 20 9 40 1"];
    let tables = "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n3\n0\nLAYER\n2\nOff\n70\n0\n62\n-7\n0\nLAYER\n2\ncold\n70\n5\n62\n7\n0\nLAYER\n2\nPart\n70\n4\n62\n7\n0\nENDTAB\n0\nENDSEC\n";
    let text = format!("{tables}{}", dxf(6, &entities));
    close(
        solid(&read_text(&text, Format::Dxf, &Reading::default())).properties.area,
        4.0,
        "area of the square",
    );
    let cold = Reading { layer: Some("Cold"), ..Reading::default() };
    assert_eq!(
        solid(&read_text(&text, Format::Dxf, &cold)).shape.radius(),
        1.0,
        "the disc, as it is asked for"
    );
}

#[test]
fn loose_lines_are_joined_whichever_way_they_run() {
    let outline =
        drawn(&["LINE 10 0 20 0 11 3 21 0", "LINE 10 0 20 4 11 0 21 0", "LINE 10 3 20 0 11 0 21 4"]);
    let found = solid(&outline).properties;
    close(found.area, 6.0, "area");
    close_to(found.centroid, Vec2::new(1.0, 4.0 / 3.0), "centroid");
}

#[test]
fn gaps_up_to_the_tolerance_are_closed_and_said() {
    // A thousandth of 4 is 4 mm.
    let gap = |x: f64| {
        let line = format!("LINE 10 {x} 20 0 11 0 21 4");
        outline_of(
            &dxf(6, &["LINE 10 0 20 0 11 3 21 0", "LINE 10 0 20 4 11 0 21 0", &line]),
            Format::Dxf,
            "drawn",
            &Reading::default(),
        )
    };
    let closed = solid(&gap(3.0039).unwrap());
    assert!(closed.notes[0].ends_with("gaps up to 3.9 mm are closed"), "{:?}", closed.notes);
    let faults = gap(3.0041).unwrap_err();
    assert_eq!(
        faults[0].text,
        "the outline is open: the LINE in line 16 ends at (3 m, 0 mm) and nothing goes on there; the nearest loose end is 4.1 mm away, and gaps up to 4 mm are closed"
    );
    assert_eq!((faults.len(), faults[0].line), (2, Some(16)), "both ends");
}

#[test]
fn ends_that_are_off_by_rounding_make_no_turn() {
    // The least numbers beside 3 and 4, and beside 0: each joint is off another way.
    let outline = drawn(&[
        "LINE 10 0 20 -4e-16 11 3.0000000000000004 21 4e-16",
        "LINE 10 2.9999999999999996 20 -4e-16 11 4e-16 21 4.000000000000001",
        "LINE 10 -4e-16 20 3.9999999999999996 11 4e-16 21 4e-16",
    ]);
    close(solid(&outline).properties.area, 6.0, "area");
    assert_eq!(outline.nest.outer.edges.len(), 3, "no lines between");
}

#[test]
fn lines_that_are_too_long_are_cut_short() {
    let outline = drawn(&[
        "LINE 10 0 20 0 11 3.003 21 0",
        "LINE 10 3.0015 20 -0.002 11 0 21 4",
        "LINE 10 0 20 4.003 11 0 21 -0.003",
    ]);
    let found = solid(&outline);
    // Corners move by 4 mm at most, along sides of 12 m in all.
    assert!((found.properties.area - 6.0).abs() < 0.004 * 12.0, "{}", found.properties.area);
    assert_eq!(found.shape.faces(), 3, "three sides");
}

#[test]
fn an_arc_of_nearly_a_turn_is_closed_by_a_line() {
    // 0.1° are 1.7 mm of a radius of 1 m.
    let found = solid(&drawn(&["ARC 10 0 20 0 40 1 50 0.1 51 360"]));
    let turn = 359.9 * std::f64::consts::PI / 180.0;
    close(found.properties.area, 0.5 * (turn - carom_num::elementary::sin(turn)), "sector and triangle");
}

#[test]
fn an_old_polyline_is_read_corner_by_corner() {
    let outline = drawn(&[
        "POLYLINE 66 1 10 0 20 0 70 1",
        "VERTEX 10 0 20 0",
        "VERTEX 10 4 20 0 42 1",
        "VERTEX 10 4 20 2",
        "VERTEX 70 16 10 9 20 9",
        "VERTEX 10 0 20 2",
        "SEQEND",
    ]);
    close(solid(&outline).properties.area, 8.0 + 0.5 * std::f64::consts::PI, "a rectangle and half a disc");
}

#[test]
fn entities_on_the_back_of_the_plane_are_mirrored() {
    // An arc from 0° to 90° about (−2, 0), seen from behind: its middle is up and to the left of (2, 0).
    let outline = drawn(&[
        "ARC 10 -2 20 0 40 1 50 0 51 90 230 -1",
        "LINE 10 2 20 1 11 2 21 0",
        "LINE 10 1 20 0 11 2 21 0",
    ]);
    let found = solid(&outline).properties;
    close(found.area, 0.25 * std::f64::consts::PI, "a quarter of a disc");
    assert!(found.centroid.x < 2.0 && found.centroid.y > 0.0, "{found:?}");
}

/// B-splines by their basis functions (de Boor, Cox): another way to a curve's points.
fn basis(knots: &[f64], i: usize, degree: usize, t: f64) -> f64 {
    if degree == 0 {
        return if knots[i] <= t && t < knots[i + 1] { 1.0 } else { 0.0 };
    }
    let part = |top: f64, width: f64, below: f64| if width == 0.0 { 0.0 } else { top / width * below };
    part(t - knots[i], knots[i + degree] - knots[i], basis(knots, i, degree - 1, t))
        + part(
            knots[i + degree + 1] - t,
            knots[i + degree + 1] - knots[i + 1],
            basis(knots, i + 1, degree - 1, t),
        )
}

#[test]
fn splines_are_their_bezier_pieces() {
    let points = [(0.0, 0.0), (2.0, -1.0), (4.0, 1.0), (4.0, 4.0), (1.0, 5.0), (0.0, 3.0)];
    let points: Vec<Vec2> = points.iter().map(|(x, y)| Vec2::new(*x, *y)).collect();
    for (degree, knots) in [
        (1, vec![0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.0]),
        (2, vec![0.0, 0.0, 0.0, 1.0, 2.5, 3.0, 4.0, 4.0, 4.0]),
        (3, vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 4.0, 4.0, 4.0, 4.0]),
        (3, (0..10).map(f64::from).collect()),
    ] {
        let (domain, mut starts) = (knots[degree]..knots[points.len()], vec![]);
        for pair in knots.windows(2).filter(|pair| pair[0] < pair[1] && domain.contains(&pair[0])) {
            starts.push((pair[0], pair[1]));
        }
        let spline =
            spline::Spline { degree, knots: knots.clone(), points: points.clone(), weights: vec![1.0; 6] };
        let edges = spline.edges().unwrap();
        assert_eq!(edges.len(), starts.len(), "one piece between knots");
        for (edge, (from, to)) in edges.iter().zip(starts) {
            for s in [0.0, 0.3, 0.9] {
                let t = from + (to - from) * s;
                let sum = points.iter().enumerate();
                let sum = sum.fold(Vec2::ZERO, |sum, (i, p)| sum + *p * basis(&knots, i, degree, t));
                close_to(edge.point(s), sum, "point of the curve");
            }
        }
    }
}

#[test]
fn what_crosses_repeats_or_stands_apart_is_said() {
    let bow = "LWPOLYLINE 70 1 10 0 20 0 10 2 20 2 10 2 20 0 10 0 20 3";
    assert_eq!(faults(&[bow])[0], "the LWPOLYLINE in line 16 crosses itself at (1.2 m, 1.2 m)");
    let at_a_corner = "LWPOLYLINE 70 1 10 0 20 0 10 1 20 1 10 2 20 2.5 10 2 20 0 10 1 20 1 10 0 20 3";
    assert_eq!(
        faults(&[at_a_corner])[0],
        "the loop of the LWPOLYLINE in line 16 runs through itself or back along itself"
    );
    let hole = "CIRCLE 10 2 20 1 40 0.5";
    assert_eq!(
        faults(&[SQUARE, hole]).len(),
        2,
        "the circle crosses the square twice, in two of its sides or one"
    );
    let inside = "CIRCLE 10 1 20 1 40 0.5";
    assert_eq!(
        faults(&[SQUARE, inside, inside]),
        ["the CIRCLE in line 46 repeats the loop of the CIRCLE in line 38"]
    );
    let beside = faults(&[SQUARE, "CIRCLE 10 9 20 1 40 0.5"]);
    assert_eq!(
        beside,
        [
            "one of 2 separate outlines: the LWPOLYLINE in line 16 (2 m by 2 m)",
            "one of 2 separate outlines: the CIRCLE in line 38 (1 m by 1 m)"
        ]
    );
    let island = faults(&[SQUARE, inside, "CIRCLE 10 1 20 1 40 0.2"]);
    assert_eq!(island, ["an outline within a hole: the CIRCLE in line 46 (400 mm by 400 mm)"]);
    let twice = faults(&[SQUARE, "LINE 10 0 20 0 11 1 21 0", "LINE 10 1 20 0 11 0 21 0"]);
    assert!(twice[0].contains("encloses no area"), "{twice:?}");
}

#[test]
fn a_fork_names_all_that_meet() {
    let found = faults(&[
        "LINE 10 0 20 0 11 3 21 0",
        "LINE 10 3 20 0 11 0 21 4",
        "LINE 10 0 20 4 11 0 21 0",
        "LINE 10 0 20 0 11 9 21 9",
    ]);
    assert_eq!(
        found,
        ["3 ends meet at (0 mm, 0 mm): the LINE in line 16, the LINE in line 36, the LINE in line 46"]
    );
}

#[test]
fn no_cut_and_no_wrong_letter_of_a_drawing_panics() {
    let text = dxf(
        4,
        &[
            SQUARE,
            "ARC 10 0 20 0 40 1 50 0 51 90",
            "SPLINE 71 2 40 0 10 0 20 0",
            "ELLIPSE 10 0 20 0 11 1 21 0 40 1",
        ],
    );
    for end in 0..text.len() {
        if let Err(faults) = outline_of(&text[..end], Format::Dxf, "drawn", &Reading::default()) {
            assert!(!faults.is_empty(), "cut at {end}");
        }
        for wrong in ["x", "-", "9e999", "\n", ""] {
            let text = format!("{}{wrong}{}", &text[..end], &text[end + 1..]);
            if let Err(faults) = outline_of(&text, Format::Dxf, "drawn", &Reading::default()) {
                assert!(!faults.is_empty(), "{wrong} at {end}");
            }
        }
    }
}
