//! Every published result is as its table declares.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use carom_validation::{OursReport, validate};

/// Computes a result, prints it beside the print, and holds every row to its declared verdict.
fn holds(name: &str) {
    let report = validate(&[name]).unwrap();
    let result = &report.results[0];
    println!("{}: {:?}", result.title, result.verdicts);
    let mut others = vec![];
    for row in &result.rows {
        let ours = match &row.ours {
            Some(OursReport::Number(number)) => format!("{number:.12}"),
            Some(OursReport::Word(word)) => word.clone(),
            None => "-".to_owned(),
        };
        let line = format!(
            "{:<24} {:>16} {ours:>20} {:>10.2e} {:<15} {}",
            row.key,
            row.printed,
            row.share.unwrap_or(0.0),
            row.verdict.word(),
            row.reason
        );
        println!("{line}");
        if !row.as_declared {
            others.push(format!("declared {}: {line}", row.declared));
        }
    }
    assert_eq!(result.failure, None, "{name}");
    assert!(others.is_empty(), "{name}: {} rows are not as declared\n{}", others.len(), others.join("\n"));
}

#[test]
fn the_feeder_papers_table_1_is_as_declared() {
    holds("feeder_table_1");
}

#[test]
fn housners_block_is_as_declared() {
    holds("housner_block");
}

#[test]
fn the_rimless_wheel_is_as_declared() {
    holds("rimless_wheel");
}

#[test]
fn the_feeder_papers_turning_rule_is_as_declared() {
    holds("turning_rule");
}

#[test]
fn the_cylinder_is_as_declared() {
    holds("cylinder");
}

#[test]
fn the_prism_is_as_declared() {
    holds("prism");
}

#[test]
fn the_rod_is_as_declared() {
    holds("rod");
}

#[test]
fn the_pyramid_is_as_declared() {
    holds("pyramid");
}

#[test]
fn the_body_on_supports_is_as_declared() {
    holds("supports");
}

#[test]
fn energy_out_of_nothing_is_as_declared() {
    holds("energy_gain");
}

#[test]
fn painleves_rod_is_as_declared() {
    holds("painleve_rod");
}

#[test]
fn the_falling_stick_is_as_declared() {
    holds("falling_stick");
}

#[test]
fn newtons_cradle_is_as_declared() {
    holds("newtons_cradle");
}

#[test]
fn stacked_balls_are_as_declared() {
    holds("stacked_balls");
}

#[test]
fn the_bouncing_ball_is_as_declared() {
    holds("bouncing_ball");
}

#[test]
fn rolling_off_an_edge_is_as_declared() {
    holds("rolling_off_an_edge");
}

#[test]
fn the_incline_is_as_declared() {
    holds("incline");
}

#[test]
fn the_hexagonal_prism_is_as_declared() {
    holds("hexagonal_prism");
}

#[test]
fn measured_rocking_is_as_declared() {
    holds("rocking_measured");
}

#[test]
fn measured_dice_are_as_declared() {
    holds("cuboid_dice");
}
