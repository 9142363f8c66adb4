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

/// A test of each result, and their names.
macro_rules! published {
    ($($test:ident: $name:literal;)*) => {
        const HELD: &[&str] = &[$($name),*];
        $(
            #[test]
            fn $test() {
                holds($name);
            }
        )*
    };
}

published! {
    the_feeder_papers_table_1_is_as_declared: "feeder_table_1";
    housners_block_is_as_declared: "housner_block";
    the_rimless_wheel_is_as_declared: "rimless_wheel";
    the_feeder_papers_turning_rule_is_as_declared: "turning_rule";
    the_cylinder_is_as_declared: "cylinder";
    the_prism_is_as_declared: "prism";
    the_rod_is_as_declared: "rod";
    the_pyramid_is_as_declared: "pyramid";
    the_body_on_supports_is_as_declared: "supports";
    energy_out_of_nothing_is_as_declared: "energy_gain";
    painleves_rod_is_as_declared: "painleve_rod";
    the_falling_stick_is_as_declared: "falling_stick";
    newtons_cradle_is_as_declared: "newtons_cradle";
    stacked_balls_are_as_declared: "stacked_balls";
    the_bouncing_ball_is_as_declared: "bouncing_ball";
    rolling_off_an_edge_is_as_declared: "rolling_off_an_edge";
    the_incline_is_as_declared: "incline";
    the_hexagonal_prism_is_as_declared: "hexagonal_prism";
    measured_rocking_is_as_declared: "rocking_measured";
    measured_dice_are_as_declared: "cuboid_dice";
}

#[test]
fn every_published_result_is_held() {
    let mut held = HELD.to_vec();
    let mut published: Vec<&str> = carom_validation::names().collect();
    held.sort_unstable();
    published.sort_unstable();
    assert_eq!(held, published);
}
