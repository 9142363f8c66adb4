//! 98 designs of the paper's feeder against an independent event-driven solution (scipy), for the rod and for a box 1 mm thick.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::extruded::in_space;
use crate::paper;

use carom_feeder::{Feeder, Outcome, Run, Verdict, spatial};
use carom_motion::planar::Options;
use carom_motion::spatial::Body;
use carom_num::{Mat3, Vec3};

struct Row {
    slope: f64,
    line_b: f64,
    verdict: [&'static str; 2],
    kind: [u8; 2],
    spin_before: f64,
    spin_after: [f64; 2],
    touch: f64,
    flat: f64,
}

fn design(row: &Row, thickness: f64) -> Feeder {
    let d = row.line_b / carom_num::elementary::tan((row.slope + 15.0).to_radians());
    paper::feeder(15.0, (d, row.line_b), thickness)
}

fn verdict(run: &Run) -> &'static str {
    match run.landings.last().unwrap().verdict {
        Some(Verdict::Same) => "same",
        Some(Verdict::Turned) => "turned",
        _ => "other",
    }
}

fn rows() -> Vec<Row> {
    let text = include_str!("reference/feeder_grid.csv");
    let row = |line: &'static str| {
        let f: Vec<&'static str> = line.split(',').map(str::trim).collect();
        let number = |i: usize| f[i].parse::<f64>().unwrap();
        Row {
            slope: number(0),
            line_b: number(1),
            verdict: [f[2], f[3]],
            kind: [f[4].parse().unwrap(), f[9].parse().unwrap()],
            spin_before: number(5),
            spin_after: [number(6), number(10)],
            touch: number(7),
            flat: number(8),
        }
    };
    text.lines().skip(1).map(row).collect()
}

#[test]
fn every_design_of_the_grid_agrees() {
    let rows = rows();
    assert_eq!(rows.len(), 98);
    for (part, thickness) in [0.0, 0.001].into_iter().enumerate() {
        let (mut verdicts, mut kinds, mut worst_spin, mut worst_time) = (0, 0, 0.0_f64, 0.0_f64);
        for row in &rows {
            let run = design(row, thickness).run().unwrap();
            assert_eq!(run.outcome, Outcome::Landed, "slope {} b {}", row.slope, row.line_b);
            let verdict = verdict(&run);
            let strike = &run.trace.impacts[0];
            let kind = strike.kind.unwrap().number();
            if verdict != row.verdict[part] || kind != row.kind[part] {
                println!(
                    "slope {} b {}: {verdict} type {kind}, expected {} type {}",
                    row.slope, row.line_b, row.verdict[part], row.kind[part]
                );
            }
            verdicts += u32::from(verdict == row.verdict[part]);
            kinds += u32::from(kind == row.kind[part]);
            worst_spin = worst_spin
                .max((-strike.after.spin - row.spin_after[part]).abs() / row.spin_after[part].abs());
            if part == 0 {
                worst_spin = worst_spin.max((-strike.before.spin - row.spin_before).abs() / row.spin_before);
                let landing = run.landings.last().unwrap();
                worst_time = worst_time
                    .max((strike.time - row.touch).abs())
                    .max((landing.flat.unwrap() - row.flat).abs());
            }
        }
        println!(
            "thickness {thickness} m: verdicts {verdicts} of 98, types {kinds} of 98, spin within {worst_spin:.1e}, times within {worst_time:.1e} s"
        );
        assert_eq!((verdicts, kinds), (98, 98), "thickness {thickness}");
        assert!(worst_spin < 1e-6 && worst_time < 1e-7, "{worst_spin} {worst_time}");
    }
}

/// The bar of 1 mm as a solid, with the inertia that the reference has.
fn bar() -> spatial::Part {
    let edges = Vec3::new(0.1, 0.001, 0.02);
    let block = spatial::examples::block(edges, 0.3);
    let square = |a: f64, b: f64| 0.3 * (a * a + b * b) / 12.0;
    let inertia = Mat3::diagonal(square(edges.y, edges.z), square(edges.x, edges.z), 2.5e-4);
    let body = Body::new(0.3, inertia, block.body.supports().to_vec()).unwrap();
    spatial::Part { body, faces: block.faces }
}

#[test]
fn every_design_of_the_grid_agrees_in_space() {
    let (mut verdicts, mut spins, mut times, mut ends) = (0, 0.0_f64, 0.0_f64, 0.0_f64);
    for row in &rows() {
        let feeder = design(row, 0.001);
        let (plane, run) = (feeder.run().unwrap(), in_space(&feeder, bar()).run().unwrap());
        let strike = &run.impacts[0];
        spins =
            spins.max((strike.spin_after.norm() - row.spin_after[1].abs()).abs() / row.spin_after[1].abs());
        times = times.max((strike.time - plane.trace.impacts[0].time).abs());
        let landing = run.final_landing().unwrap();
        let found = match landing.verdict {
            Some(Verdict::Same) => "same",
            Some(Verdict::Turned) => "turned",
            _ => "other",
        };
        ends = ends.max((landing.flat.unwrap() - plane.landings.last().unwrap().flat.unwrap()).abs());
        verdicts += u32::from(run.outcome == Outcome::Landed && found == row.verdict[1]);
    }
    println!(
        "in space: verdicts {verdicts} of 98, spin within {spins:.1e}, first strike within {times:.1e} s, flat within {ends:.1e} s"
    );
    assert_eq!(verdicts, 98);
    assert!(spins < 1e-6 && times < 1e-8 && ends < 1e-8, "{spins} {times} {ends}");
}

#[test]
fn a_loose_tolerance_gives_the_same_verdicts() {
    for tolerance in [1e-10, 1e-8, 1e-6, 1e-5, 1e-4] {
        for (part, thickness) in [0.0, 0.001].into_iter().enumerate() {
            for row in &rows() {
                let (feeder, options) = (design(row, thickness), Options { tolerance, ..Options::default() });
                let run = feeder.prepare(options).unwrap().run_untraced().unwrap();
                let (slope, line_b) = (row.slope, row.line_b);
                assert_eq!(run.outcome, Outcome::Landed, "{tolerance} slope {slope} b {line_b}");
                assert_eq!(verdict(&run), row.verdict[part], "{tolerance} slope {slope} b {line_b}");
            }
        }
    }
}
