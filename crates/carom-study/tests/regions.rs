//! Region diagrams of classifiers whose boundaries are known in closed form.

use carom_study::regions::{Boundary, Label, Options, Range, Regions, RegionsError, find};

/// What is asked of crossings and junctions, as a share of the range.
const ACCURACY: f64 = 1e-9;

fn range(from: f64, to: f64, count: usize) -> Range {
    Range { from, to, count }
}

fn sought<L: Label>(x: Range, y: Range, classify: impl Fn(f64, f64) -> L + Sync) -> Regions<L> {
    let found = find(x, y, &Options::default(), classify).unwrap();
    let whole: f64 = found.shares.iter().map(|share| share.area).sum();
    // A sum of some thousand patches, each rounded to 1e-16 of the plane.
    assert!((whole - 1.0).abs() < 1e-11, "the patches cover the plane once: {whole}");
    found
}

/// Every boundary ends at the border or in a junction, and each of its points is `distance` from where it should be.
fn assert_sound<L: Label>(found: &Regions<L>, distance: impl Fn(&Boundary<L>, [f64; 2]) -> f64) -> f64 {
    let mut worst = 0.0f64;
    for boundary in &found.boundaries {
        assert!(boundary.points.len() > 1, "a line: {boundary:?}");
        for (point, junction) in
            [(boundary.points[0], boundary.ends[0]), (*boundary.points.last().unwrap(), boundary.ends[1])]
        {
            let [x, y] = point;
            let border = x == found.x.from || x == found.x.to || y == found.y.from || y == found.y.to;
            assert!(boundary.closed || border || junction.is_some(), "a loose end at {point:?}");
        }
        for point in &boundary.points {
            worst = worst.max(distance(boundary, *point));
        }
    }
    worst
}

#[test]
fn a_circle_is_one_closed_line_to_a_billionth() {
    let side = range(-1.3, 1.3, 40);
    let found = sought(side, side, |x, y| x * x + y * y < 1.0);
    let worst = assert_sound(&found, |_, [x, y]| ((x * x + y * y).sqrt() - 1.0).abs() / 2.6);
    assert!(worst <= ACCURACY, "{worst:e}");
    assert!(found.boundaries.len() == 1 && found.boundaries[0].closed, "one loop");
    let area = found.shares[1].area * 2.6 * 2.6;
    // Chords cut off about (2/3)(s²/8R) of an arc s: 2e-4 with s of one cell.
    assert!((area - std::f64::consts::PI).abs() < 2e-3, "{area}");
}

#[test]
fn many_circles_of_any_size_and_place_are_found() {
    let side = range(0.0, 1.0, 30);
    let mut seed = 1u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    for case in 0..200 {
        // A circle that contains a disc of the probes' spacing, half a cell, is seen.
        let radius = 0.0125 + 0.2 * random();
        let (cx, cy) = (0.25 + 0.5 * random(), 0.25 + 0.5 * random());
        let inside = |x: f64, y: f64| (x - cx) * (x - cx) + (y - cy) * (y - cy) < radius * radius;
        let found = sought(side, side, inside);
        let worst = assert_sound(&found, |_, [x, y]| {
            (((x - cx) * (x - cx) + (y - cy) * (y - cy)).sqrt() - radius).abs()
        });
        assert!(worst <= ACCURACY, "case {case}: {worst:e}");
        assert_eq!(found.boundaries.len(), 1, "case {case}: radius {radius} at {cx}, {cy}");
    }
}

/// Four sectors that meet in a point, bounded by two lines.
fn sectors(x: f64, y: f64, [px, py]: [f64; 2], slopes: [f64; 2]) -> u8 {
    let above = |slope: f64| (y - py) > slope * (x - px);
    u8::from(above(slopes[0])) * 2 + u8::from(above(slopes[1]))
}

#[test]
fn four_lines_meet_in_one_quadruple_point() {
    for (k, at) in [[0.312_345, 0.598_765], [0.5, 0.5], [0.25, 0.711], [0.7, 0.1]].into_iter().enumerate() {
        let side = range(0.0, 1.0, 20);
        let slopes = [0.7, -1.3];
        let found = sought(side, side, |x, y| sectors(x, y, at, slopes));
        let worst = assert_sound(&found, |_, [x, y]| {
            let off = |slope: f64| ((y - at[1]) - slope * (x - at[0])).abs() / (1.0 + slope * slope).sqrt();
            off(slopes[0]).min(off(slopes[1]))
        });
        let [junction] = &found.junctions[..] else { panic!("case {k}: {:?}", found.junctions) };
        let distance = [0, 1].map(|axis| (junction.at[axis] - at[axis]).abs());
        assert!(
            worst <= ACCURACY && distance[0].max(distance[1]) <= ACCURACY,
            "case {k}: {worst:e} {distance:?}"
        );
        assert_eq!(junction.labels, [0, 1, 3, 2], "case {k}: around the point");
        assert_eq!(found.boundaries.len(), 4, "case {k}");
    }
}

#[test]
fn a_junction_of_close_lines_is_located_in_long_narrow_cells() {
    // One line into a point from the left, two from there to the right.
    let at = [0.785_321, 0.765_432];
    let classify = |x: f64, y: f64| {
        let (u, v) = (x - at[0], y - at[1]);
        let upper = if u < 0.0 { -0.32 * u } else { 0.17 * u };
        if v > upper { 1u8 } else { 2 + u8::from(v > -0.32 * u) }
    };
    for (columns, rows) in [(400, 2), (2, 400), (40, 40)] {
        let found = sought(range(0.0, 1.0, columns), range(0.0, 1.0, rows), classify);
        let [junction] = &found.junctions[..] else { panic!("{columns} x {rows}: {:?}", found.junctions) };
        let distance = [0, 1].map(|axis| (junction.at[axis] - at[axis]).abs());
        assert!(distance[0].max(distance[1]) <= ACCURACY, "{columns} x {rows}: {junction:?}");
    }
}

#[test]
fn two_triple_points_in_one_cell_are_told_apart() {
    // Left of both, right of both, above, below; the middle edge is 2 · 1e-4 long, a fraction of the finest cell.
    let half = 1e-4;
    let classify = |x: f64, y: f64| {
        let (u, v) = (x - 0.512_3, y - 0.487_1);
        let sideways = (u.abs() - half) > v.abs();
        if sideways { u8::from(u > 0.0) } else { 2 + u8::from(v > 0.0) }
    };
    let side = range(0.0, 1.0, 16);
    let found = sought(side, side, classify);
    assert_eq!(found.junctions.len(), 2, "{:?}", found.junctions);
    for junction in &found.junctions {
        let left = junction.labels.contains(&0);
        let exact = [0.512_3 + if left { -half } else { half }, 0.487_1];
        let off = (junction.at[0] - exact[0]).abs().max((junction.at[1] - exact[1]).abs());
        assert!(off <= ACCURACY, "{junction:?} {exact:?}");
        assert_eq!(junction.labels.len(), 3, "{junction:?}");
    }
    let between = found.boundaries.iter().find(|boundary| boundary.pair == [2, 3]).unwrap();
    assert!(between.ends.iter().all(Option::is_some), "the middle edge joins the two: {between:?}");
}

#[test]
fn a_thin_wedge_is_followed_to_the_finest_cell() {
    // Between y = x/3 and y = x/3 + (x − 0.2)/50: from a point it opens to 1.6 % of the plane, under a coarse cell of 4 %.
    let classify = |x: f64, y: f64| {
        let height = y - x / 3.0 - 0.2;
        let top = ((x - 0.2) / 50.0).max(0.0);
        if height < 0.0 {
            1u8
        } else if height < top {
            2
        } else {
            3
        }
    };
    let side = range(0.0, 1.0, 25);
    let found = sought(side, side, classify);
    let worst = assert_sound(&found, |boundary, [x, y]| {
        let height = y - x / 3.0 - 0.2;
        if boundary.pair == [2, 3] { (height - (x - 0.2) / 50.0).abs() } else { height.abs() }
    });
    assert!(worst <= ACCURACY, "{worst:e}");
    let reached = found.boundaries.iter().filter(|boundary| boundary.pair == [2, 3]);
    let tip = reached.flat_map(|boundary| &boundary.points).map(|point| point[0]).fold(1.0, f64::min);
    assert!((tip - 0.2).abs() <= ACCURACY, "bisection sees the wedge between 1 and 3 down to its tip: {tip}");
    assert_eq!(found.junctions.len(), 1, "{:?}", found.junctions);
}

#[test]
fn the_order_of_labels_and_a_mirror_change_nothing_but_names() {
    let side = range(-1.0, 1.0, 24);
    let classify = |x: f64, y: f64| if y > 0.3 * x { u8::from(x > 0.1) } else { 2 };
    let found = sought(side, side, classify);
    let mirrored = sought(side, side, |x, y| 9 - classify(-x, y));
    assert_eq!(found.boundaries.len(), mirrored.boundaries.len(), "as many lines");
    let ([a], [b]) = (&found.junctions[..], &mirrored.junctions[..]) else { panic!("one triple point each") };
    assert!(
        (a.at[0] + b.at[0]).abs() <= 4.0 * ACCURACY && (a.at[1] - b.at[1]).abs() <= 4.0 * ACCURACY,
        "{a:?} {b:?}"
    );
}

#[test]
fn what_cannot_be_sought_is_refused() {
    let (good, options) = (range(0.0, 1.0, 4), Options::default());
    let error = |x: Range, options: &Options| find(x, good, options, |_, _| 0u8).unwrap_err();
    assert_eq!(error(range(1.0, 1.0, 4), &options), RegionsError::Range { from: 1.0, to: 1.0 });
    assert!(matches!(error(range(0.0, f64::NAN, 4), &options), RegionsError::Range { .. }), "not a number");
    assert_eq!(error(range(0.0, 1.0, 0), &options), RegionsError::Cells { count: 0 });
    assert_eq!(error(good, &Options { depth: 9, ..options }), RegionsError::Depth { depth: 9 });
    assert_eq!(error(good, &Options { accuracy: 0.0, ..options }), RegionsError::Accuracy { accuracy: 0.0 });
}

#[test]
fn one_label_has_no_boundary() {
    let found = sought(range(0.0, 1.0, 3), range(0.0, 2.0, 5), |_, _| 7u8);
    assert!(found.boundaries.is_empty() && found.junctions.is_empty(), "nothing to tell apart");
    assert_eq!((found.shares.len(), found.shares[0].nodes, found.places.len()), (1, 24, 1), "one region");
}

/// Label 9 holds on a line only, 4·10⁻¹¹ wide: bisection would meet it now and then.
#[test]
fn an_outcome_at_equality_has_no_boundary_of_its_own() {
    let side = range(0.0, 1.0, 23);
    // Its slope is small, so that the line stays long within the last bracket of many bisections.
    let height = |x: f64, y: f64| y - 0.37 - 0.03 * x * x;
    let label = |x: f64, y: f64| match height(x, y) {
        h if h.abs() < 2e-11 => 9,
        h => u8::from(h > 0.0),
    };
    let found = sought(side, side, label);
    assert!(found.shares.iter().all(|share| share.label != 9), "{:?}", found.shares);
    assert_eq!((found.boundaries.len(), found.junctions.len()), (1, 0), "one line from side to side");
    let worst = assert_sound(&found, |_, [x, y]| height(x, y));
    assert!(worst <= 2.0 * ACCURACY, "{worst}");
}
