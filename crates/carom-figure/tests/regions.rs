//! The drawing and the table of a region diagram.

use carom_figure::{RegionAxis, RegionCurve, RegionDiagram, RegionName, regions_csv, regions_svg};
use carom_study::regions::{Options, Range, Regions, find};

fn name(label: u8) -> RegionName {
    RegionName { short: label.to_string(), long: format!("outcome <{label}>") }
}

/// A disc of label 1 in a plane of label 0.
fn disc() -> Regions<u8> {
    let side = Range { from: -2.0, to: 2.0, count: 40 };
    find(side, side, &Options::default(), |x, y| u8::from(x * x + y * y < 1.0)).unwrap()
}

fn drawn(curves: Vec<RegionCurve>) -> String {
    marked(curves, None)
}

fn marked(curves: Vec<RegionCurve>, here: Option<([f64; 2], String)>) -> String {
    let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
    regions_svg(&RegionDiagram {
        title: "A disc & its plane".to_owned(),
        subtitle: "radius 1".to_owned(),
        axes: [axis("angle", "deg"), axis("inertia", "kg m^2")],
        regions: &disc(),
        name: &name,
        curves_are: "closed forms".to_owned(),
        curves,
        here,
    })
}

#[test]
fn regions_have_names_areas_and_units() {
    let svg = drawn(vec![]);
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "one element");
    for what in [
        "A disc &amp; its plane",
        "outcome &lt;1&gt;",
        "angle  [deg]",
        "inertia  [kg m²]",
        "19.6 %",
        "80.4 %",
    ] {
        assert!(svg.contains(what), "{what}");
    }
    // π/16 = 19.6 %; chords of a tenth of the radius take at most 0.2 % of it off.
    assert!(!svg.contains("NaN") && !svg.contains("class=\"closed-form\" d"), "no curve, no NaN");
}

#[test]
fn a_diagram_says_at_which_resolution_regions_were_looked_for() {
    let svg = drawn(vec![]);
    let told = svg.replace("</text>", "\n");
    let words: String = told.lines().filter_map(|line| line.rsplit('>').next()).collect::<Vec<_>>().join(" ");
    assert!(words.contains("Looked for on 40 × 40 cells"), "{words}");
    assert!(words.contains("narrower than a cell may be missed"), "{words}");
}

#[test]
fn names_of_slivers_do_not_lie_on_each_other() {
    // A sliver along the diagonal, half a cell wide: the nodes that meet it are many places.
    let side = Range { from: 0.0, to: 1.0, count: 40 };
    let diagonal =
        |x: f64, y: f64| if (y - 0.93 * x - 0.013).abs() < 0.006 { 1 } else { u8::from(y < x) * 2 };
    let regions = find(side, side, &Options::default(), diagonal).unwrap();
    let axis = || RegionAxis { name: "x".to_owned(), unit: String::new() };
    let svg = regions_svg(&RegionDiagram {
        title: String::new(),
        subtitle: String::new(),
        axes: [axis(), axis()],
        regions: &regions,
        name: &|label| RegionName {
            short: ["none", "OK", "OK,K"][usize::from(label)].to_owned(),
            long: String::new(),
        },
        curves_are: String::new(),
        curves: vec![],
        here: None,
    });
    let number = |part: &str, key: &str| -> f64 {
        part.split(&format!(" {key}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
    };
    let names = svg.split("<text class=\"state\"").skip(1);
    let at: Vec<[f64; 2]> = names.map(|part| [number(part, "x"), number(part, "y")]).collect();
    for (i, [x, y]) in at.iter().enumerate() {
        for [other_x, other_y] in &at[..i] {
            let apart = (x - other_x).abs() >= 20.0 || (y - other_y).abs() >= 15.0;
            assert!(apart, "a name at {x}, {y} lies on one at {other_x}, {other_y}");
        }
    }
    assert!(at.len() >= 2, "regions with room have their names: {at:?}");
}

#[test]
fn a_curve_is_drawn_over_the_boundary_and_named() {
    let line = |pieces: Vec<Vec<[f64; 2]>>| RegionCurve { name: "x = 0".to_owned(), pieces };
    let svg = drawn(vec![line(vec![vec![[0.0, -2.0], [0.0, 2.0]]])]);
    assert!(
        svg.contains("class=\"closed-form\" d=\"M297 ") && svg.contains(">x = 0</text>"),
        "half-way across"
    );
    assert!(!drawn(vec![line(vec![])]).contains(">x = 0</text>"), "a curve outside the plane is not named");
}

#[test]
fn the_table_gives_every_point_its_labels_and_its_line() {
    let (regions, table) = (disc(), regions_csv(&disc(), ["x", "y"], &name));
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0], ["x", "y", "label_a", "label_b", "polyline"], "columns");
    assert_eq!(rows.len(), 2 + regions.boundaries[0].points.len(), "a closed line ends where it began");
    assert_eq!(rows[1], *rows.last().unwrap(), "first and last");
    assert!(rows[1..].iter().all(|row| row[2..] == ["0", "1", "0"]), "labels and line");
    let [x, y]: [f64; 2] = [rows[1][0].parse().unwrap(), rows[1][1].parse().unwrap()];
    assert!(((x * x + y * y).sqrt() - 1.0).abs() < 4e-9, "all digits: {x}, {y}");
}

#[test]
fn a_point_is_marked_where_it_lies_in_the_plane() {
    // The plane is 470 by 410 px from (62, 82) on: its middle is at (297, 287), and the arms are 6 px long.
    let svg = marked(vec![], Some(([0.0, 0.0], "the scene".to_owned())));
    assert!(svg.contains("<path class=\"boundary here\" d=\"M291 287h12M297 281v12\""), "in the middle");
    assert!(svg.contains(">the scene</text>"), "and in the legend");
    let beyond = marked(vec![], Some(([0.0, 2.1], "the scene".to_owned())));
    assert!(!beyond.contains("boundary here") && !beyond.contains("the scene"), "beyond the plane");
}
