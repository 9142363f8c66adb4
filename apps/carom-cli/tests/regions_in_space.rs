//! Region diagrams of bodies in space, as a user meets them.

use crate::command;

use carom_num::elementary::{atan2, sin};
use command::result_on;
use serde_json::Value;
use std::f64::consts::PI;

/// What a boundary is located to, as a share of the axes.
const ACCURACY: f64 = 1e-9;
/// The same where every point is a whole run.
const RUN_ACCURACY: f64 = 1e-7;
/// A critical height is bisected to this share of the axis, 2 circumradii, and rounding adds as much.
const HEIGHT: f64 = 4e-13;

/// What a diagram prints as JSON, computed on as many threads as there are.
fn summary(test: &str, words: &[&str]) -> Value {
    result_on("0", test, &[&["regions"], words].concat())
}

/// Every closed form is met by its boundary, from both sides; returns how many have one.
fn assert_closed_forms(summary: &Value) -> usize {
    let mut met = 0;
    assert_eq!(summary["points_without_closed_form"], 0, "{summary:#}");
    for curve in summary["closed_forms"].as_array().unwrap() {
        assert_eq!(curve["curve_points"], curve["curve_points_confirmed"], "{curve}");
        if curve["boundary_points"].as_u64().unwrap() > 0 {
            assert!(curve["largest_distance_share"].as_f64().unwrap() <= ACCURACY, "{curve}");
            met += 1;
        }
    }
    met
}

fn area(summary: &Value, label: &str) -> f64 {
    let labels = summary["labels"].as_array().unwrap();
    labels.iter().find(|l| l["label"] == label).map_or(0.0, |l| l["area_share"].as_f64().unwrap())
}

#[test]
fn a_pyramid_is_long_from_the_printed_height_on_and_stops_on_a_triangle() {
    let pyramid = summary("regions_pyramid", &["pyramid"]);
    assert_eq!(assert_closed_forms(&pyramid), 5, "every curve has a boundary");
    let thresholds = pyramid["thresholds"].as_array().unwrap();
    assert_eq!(thresholds.len(), 10, "one for each n from 3 to 12");
    for (n, row) in (3_u32..).zip(thresholds) {
        assert_eq!(row["x"].as_f64().unwrap(), f64::from(n), "{row}");
        let sin = sin(PI / f64::from(n));
        let printed = (1.0 - 2.0 / 3.0 * sin * sin).sqrt();
        for height in [&row["y"], &row["closed_form_y"]] {
            assert!((height.as_f64().unwrap() - printed).abs() < HEIGHT, "{row}, in print {printed}");
        }
        let sides = if n == 3 { ["AK", "OAK"] } else { ["K", "OK"] };
        assert_eq!([&row["below"], &row["above"]], sides, "{row}");
    }
    // Where T = E = 0: S² = 21/34, h² = 1 − (2/3) S² = 10/17.
    let meeting = &pyramid["junctions"][0];
    let sides = PI / atan2(21.0_f64.sqrt(), 13.0_f64.sqrt());
    assert!((meeting["x"].as_f64().unwrap() - sides).abs() < 9.0 * 2.0 * ACCURACY, "{meeting}");
    assert!((meeting["y"].as_f64().unwrap() - (10.0_f64 / 17.0).sqrt()).abs() < 4.0 * ACCURACY, "{meeting}");
}

#[test]
fn where_the_mass_centre_is_moves_the_critical_height() {
    let words =
        ["pyramid", "--x", "centre_ratio=0.2..0.9:35", "--y", "height_ratio=0.3..3:36", "--set", "sides=5"];
    let pyramid = summary("regions_pyramid_centre", &words);
    assert!(assert_closed_forms(&pyramid) >= 1, "J_t = m d (h − d)");
    assert_eq!(pyramid["thresholds"], serde_json::json!([]), "sides are no axis");
}

#[test]
fn a_tripod_keeps_both_or_one_or_either_or_none() {
    let strike = summary("regions_stool_strike", &["stool-strike"]);
    assert_eq!(assert_closed_forms(&strike), 4, "each outcome against two others");
    for label in ["OK", "K", "OK,K", "none"] {
        assert!(area(&strike, label) > 0.05, "{label} has room: {}", strike["labels"]);
    }
    let labels = strike["labels"].as_array().unwrap();
    assert_eq!(labels.len(), 4, "O alone is kept nowhere: {labels:?}");
    let remark = strike["remarks"][0].as_str().unwrap();
    assert!(remark.contains("separation only of K"), "{remark}");
    // Of four supports, swinging inward no faster than it comes down, O always separates: κ² > −a² cos 2π/4 = 0.
    let four = ["stool-strike", "--set", "supports=4", "--set", "tilt=0", "--x", "swinging=-0.4..0.4:16"];
    let four = summary("regions_stool_strike_4", &four);
    assert!((area(&four, "K") - 1.0).abs() < 1e-12, "{}", four["labels"]);
}

#[test]
fn a_stool_tilted_to_the_left_does_what_one_tilted_to_the_right_does() {
    let words = ["stool", "--x", "tilt=5..75 deg:14", "--y", "direction=40..140 deg:20", "--depth", "1"];
    let stool = summary("regions_stool", &words);
    for end in ["rest", "over"] {
        let [left, right] = ["01→1", "03→3"].map(|strike| area(&stool, &format!("{strike} {end}")));
        // Cells on the border of the two are cut by its bisection.
        assert!(left > 0.02 && (left - right).abs() < 1e-6, "{end}: {left} {right}");
    }
    // 45° of tilt's axis and less would press a neighbour of support 0 into the plane.
    assert!((area(&stool, "-") - 0.1).abs() < 1e-6, "{}", stool["labels"]);
    // Straight over support 0 it overturns from tan τ = a/c = √2 on: there everything meets.
    let lean = atan2(2.0_f64.sqrt(), 1.0).to_degrees();
    let at = |junction: &&Value| {
        let off = |key: &str, value: f64| (junction[key].as_f64().unwrap() - value).abs();
        off("x", lean) < 70.0 * 2.0 * RUN_ACCURACY && off("y", 90.0) < 100.0 * 2.0 * RUN_ACCURACY
    };
    assert!(stool["junctions"].as_array().unwrap().iter().any(|j| at(&j)), "{}", stool["junctions"]);
}
