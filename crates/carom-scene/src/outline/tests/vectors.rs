//! SVG: sizes, transforms, shapes and paths.

use super::*;
use std::f64::consts::PI;

fn properties(text: &str) -> carom_motion::planar::MassProperties {
    solid(&svg(text)).properties
}

fn sized(head: &str, unit: Option<&str>) -> Result<FileOutline, Vec<Fault>> {
    let unit = unit.and_then(|symbol| crate::unit::Dimension::Length.unit(symbol));
    let text = format!("<svg {head}><rect x=\"1\" y=\"2\" width=\"4\" height=\"2\"/></svg>");
    outline_of(&text, Format::Svg, "drawn", &Reading { unit, ..Reading::default() })
}

/// Length and height of the rectangle of 4 by 2.
fn sides(head: &str, unit: Option<&str>) -> [f64; 2] {
    let found = solid(&sized(head, unit).unwrap());
    let corner = found.shape.vertices()[2];
    [2.0 * corner.x, 2.0 * corner.y]
}

#[test]
fn a_user_unit_is_what_width_and_view_box_make_it() {
    for (head, unit, expected) in [
        ("width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\"", None, [4e-3, 2e-3]),
        ("width=\"10cm\" viewBox=\"0 0 50 20\"", None, [8e-3, 4e-3]),
        ("height=\"1in\" viewBox=\"0 0 500 254\"", None, [4e-4, 2e-4]),
        ("width=\"72pt\" height=\"72pt\" viewBox=\"0 0 25.4 25.4\"", None, [4e-3, 2e-3]),
        ("width=\"96\" height=\"96\" viewBox=\"0 0 25.4 25.4\"", None, [4e-3, 2e-3]),
        ("width=\"96px\" height=\"192px\"", None, [4.0 * 0.0254 / 96.0, 2.0 * 0.0254 / 96.0]),
        ("viewBox=\"0 0 8 8\"", Some("mm"), [4e-3, 2e-3]),
        ("width=\"300\" height=\"300\" viewBox=\"0 0 8 8\"", Some("in"), [0.1016, 0.0508]),
        // The smaller scale, unless the drawing may be stretched.
        ("width=\"8mm\" height=\"16mm\" viewBox=\"0 0 8 8\"", None, [4e-3, 2e-3]),
        (
            "width=\"8mm\" height=\"16mm\" viewBox=\"0 0 8 8\" preserveAspectRatio=\"none\"",
            None,
            [4e-3, 4e-3],
        ),
    ] {
        let found = sides(head, unit);
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-12 * expected, "{head}: {found} is not {expected}");
        }
    }
}

#[test]
fn a_size_that_is_unknown_or_contradicted_is_a_problem() {
    let fault = |head: &str, unit| sized(head, unit).unwrap_err().remove(0).text;
    assert_eq!(fault("viewBox=\"0 0 8 8\"", None), "does not say its size: <svg> has no width and no height");
    assert_eq!(
        fault("width=\"8mm\" viewBox=\"0 0 8 8\"", Some("in")),
        "<svg> gives its own size, 8 mm, but the scene gives a unit, in"
    );
    assert_eq!(
        fault("width=\"8em\" viewBox=\"0 0 8 8\"", None),
        "<svg> has a size of 8 em, which is no physical size"
    );
}

#[test]
fn y_is_up() {
    // A triangle whose tip is at the top of the page.
    let found = properties("<polygon points=\"0,3 3,3 0,0\"/>");
    close_to(found.centroid, Vec2::new(1.0, -2.0), "centroid");
    close(found.area, 4.5, "area");
}

#[test]
fn shapes_are_what_they_are_called() {
    let rounded = properties("<rect x=\"-3\" y=\"-1\" width=\"6\" height=\"2\" rx=\"0.5\"/>");
    close(rounded.area, 12.0 - (4.0 - PI) * 0.25, "rounded rectangle");
    let oval = properties("<rect x=\"-3\" y=\"-1\" width=\"6\" height=\"2\" rx=\"3\" ry=\"1\"/>");
    close(oval.area, 3.0 * PI, "an ellipse of four quarters");
    close(oval.gyration_squared, (9.0 + 1.0) / 4.0, "its gyration squared");
    close(properties("<circle cx=\"1\" cy=\"1\" r=\"2\"/>").area, 4.0 * PI, "circle");
    close(properties("<ellipse rx=\"2\" ry=\"1\"/>").area, 2.0 * PI, "ellipse");
    let lines = "<line x1=\"0\" y1=\"0\" x2=\"3\" y2=\"0\"/><polyline points=\"3 0 0 4 0 0\"/>";
    close(properties(lines).area, 6.0, "a line and a polyline, joined");
}

#[test]
fn every_command_of_a_path_is_followed() {
    // A unit square, each side by another command, absolute and relative.
    for path in [
        "M 0 0 L 1 0 H 1 V 1 L 0 1 Z",
        "m 0 0 l 1 0 h 0 v 1 l -1 0 z",
        "m 0 0 c .25 0 .75 0 1 0 l 0 1 q -.5 0 -1 0 z",
    ] {
        close(properties(&format!("<path d=\"{path}\"/>")).area, 1.0, path);
    }
    // S mirrors (0.75, 0) to (1.25, 0): x − 1 = ¾ s(1 − s)² over y = (3s² − s³)/2 encloses 9/160.
    // T mirrors (0.5, 1) to (−0.5, 1): a parabola, two thirds of the triangle of its control points, 1/6.
    let smooth =
        ["M0 0C.25 0 .75 0 1 0S1 .5 1 1Q.5 1 0 1T0 0", "m0 0c.25 0 .75 0 1 0s0 .5 0 1q-.5 0-1 0t0-1"];
    for path in smooth {
        close(properties(&format!("<path d=\"{path}\"/>")).area, 1.0 + 9.0 / 160.0 + 1.0 / 6.0, path);
    }
}

#[test]
fn arcs_of_a_path_are_exact() {
    let disc = properties("<path d=\"M 2 0 A 2 2 0 0 1 -2 0 A 2 2 0 1 1 2 0\"/>");
    close(disc.area, 4.0 * PI, "two halves");
    let three_quarters = properties("<path d=\"M 0 0 L 2 0 A 2 2 0 1 1 0 -2 Z\"/>");
    close(three_quarters.area, 3.0 * PI, "the large arc of a quarter's ends");
    let quarter = properties("<path d=\"M 0 0 L 2 0 A 2 2 0 0 0 0 -2 Z\"/>");
    close(quarter.area, PI, "the small one, turning the other way");
    let small = properties("<path d=\"M 2 0 A 1 1 0 0 1 -2 0 Z\"/>");
    close(small.area, 2.0 * PI, "radii that are too small grow until they reach");
    let turned = properties("<path d=\"M 0 2 A 2 1 90 0 1 0 -2 A 2 1 90 0 1 0 2 Z\"/>");
    close(turned.area, 2.0 * PI, "an ellipse that stands");
    close(turned.gyration_squared, 5.0 / 4.0, "its gyration squared");
}

#[test]
fn transforms_are_applied_from_the_inside() {
    let plain = "<rect width=\"4\" height=\"2\"/>";
    let centroid =
        |transform: &str| properties(&format!("<g transform=\"{transform}\">{plain}</g>")).centroid;
    close_to(centroid("translate(10 0) rotate(90)"), Vec2::new(9.0, -2.0), "turned, then shifted");
    close_to(centroid("rotate(90 10 0)"), Vec2::new(9.0, 8.0), "turned about a point");
    close_to(centroid("matrix(0 1 -1 0 10 0)"), Vec2::new(9.0, -2.0), "by a matrix");
    close_to(centroid("skewX(45)"), Vec2::new(3.0, -1.0), "skewed");
    close_to(centroid("scale(2 3)"), Vec2::new(4.0, -3.0), "stretched");
}

#[test]
fn holes_and_what_is_not_drawn() {
    let found = svg(concat!(
        "<defs><circle r=\"50\"/></defs><metadata/>",
        "<path d=\"M 0 0 H 10 V 10 H 0 Z M 2 2 H 4 V 4 H 2 Z\"/>",
        "<circle cx=\"7\" cy=\"7\" r=\"1\"/><g style=\"display: none\"><circle r=\"99\"/></g><text>10 mm</text>",
    ));
    close(solid(&found).properties.area, 100.0 - 4.0 - PI, "area");
    assert!(
        solid(&found).notes[0].ends_with("2 holes; user unit m, from the scene; passed over: 1 <text>"),
        "notes"
    );
}

#[test]
fn problems_have_the_line_they_are_on() {
    let text = "<svg>\n<path d=\"M 0 0 L 1\"/>\n<use href=\"#a\"/>\n<circle r=\"-1\"/>\n<rect width=\"5%\" height=\"1\"/>\n</svg>";
    let unit = crate::unit::Dimension::Length.unit("mm");
    let faults = outline_of(text, Format::Svg, "drawn", &Reading { unit, ..Reading::default() }).unwrap_err();
    let lines: Vec<Option<usize>> = faults.iter().map(|fault| fault.line).collect();
    assert_eq!(lines, [Some(2), Some(3), Some(4), Some(5)], "{faults:?}");
}

#[test]
fn no_cut_of_a_drawing_panics() {
    let text = "<svg width=\"1mm\" viewBox=\"0 0 1 1\"><path transform=\"rotate(3)\" d=\"M 0 0 L 1 0 A 1 1 0 0 1 6 0 C 11 1 7 3 8 5 Z\"/></svg>";
    for end in 0..text.len() {
        for wrong in ["x", "-", "9e999", "\"", "<", ""] {
            let text = format!("{}{wrong}{}", &text[..end], &text[end + 1..]);
            if let Err(faults) = outline_of(&text, Format::Svg, "drawn", &Reading::default()) {
                assert!(!faults.is_empty(), "{wrong} at {end}");
            }
        }
    }
}

#[test]
fn entities_that_are_longer_than_any_file_are_refused_before_they_are_written_out() {
    let entity = |letters: usize| format!("<!DOCTYPE svg [<!ENTITY a \"{}\">]>", "A".repeat(letters));
    let drawn = |references: usize| {
        let text = format!("<text>{}</text>", "&a;".repeat(references));
        format!("<svg width=\"8mm\" viewBox=\"0 0 8 8\"><rect width=\"4\" height=\"2\"/>{text}</svg>")
    };
    let read = |text: &str| outline_of(text, Format::Svg, "drawn", &Reading::default());
    assert!(read(&(entity(1000) + &drawn(1000))).is_ok(), "a megabyte of text is passed over");
    // 70 kB of file and 100 MB of text.
    let faults = read(&(entity(10_000) + &drawn(10_000))).unwrap_err();
    assert_eq!(faults[0].text, "its entities, written out, are longer than 64 MiB");
}

#[test]
fn of_a_scribble_no_more_crossings_are_looked_for_than_say_that_it_is_one() {
    // A star of 201 points that are joined across the middle: each of its edges crosses nearly all others, some 20 000 pairs.
    let points: Vec<String> = (0..201)
        .map(|k| {
            let (sin, cos) = carom_num::elementary::sin_cos(2.0 * PI * 100.0 * f64::from(k) / 201.0);
            format!("{cos},{sin}")
        })
        .collect();
    let text =
        format!("<svg width=\"4mm\" viewBox=\"-2 -2 4 4\"><polygon points=\"{}\"/></svg>", points.join(" "));
    let faults = outline_of(&text, Format::Svg, "drawn", &Reading::default()).unwrap_err();
    assert_eq!(faults.len(), 1000, "no more are looked for");
    let last = shortened(faults).pop().unwrap().text;
    assert_eq!(last, "and at least 980 more problems like these");
}
