//! The staged impact and the end states against tables of rocking bodies, to the printed digits.

use crate::rocking_bodies;
use crate::tables;

use carom_impact::planar::{end_states, staged};
use carom_impact::{Law, Phase};
use carom_theory::rocking::{Cylinder, Prism, SupportedRod};
use rocking_bodies::{Rocking, number_of, ordered};
use tables::{IMPULSES, MOTION, Row, cylinder, rows};

/// Half of the last digit printed.
const PRINTED: f64 = 5e-7;

/// Rounding of motions of order one, from impulses that the chord between the contacts makes large.
const ROUNDING: f64 = 1e-11;

/// Different motions of the end states, as (v_x, v_y, ω clockwise).
fn end_motions(body: &Rocking) -> Vec<[f64; 3]> {
    body.different_end_states(ROUNDING).iter().map(|e| body.after(&e.impulse)).collect()
}

fn prints(row: &Row, names: [&str; 3], motion: &[f64; 3]) -> bool {
    names.iter().zip(motion).all(|(n, v)| (v - row.number(n)).abs() <= row.resolution(n) + 1e-12)
}

#[test]
fn cylinder_strikes_print_as_the_table() {
    for row in &rows(tables::CYLINDER_PLASTIC) {
        let body = Rocking::cylinder(&cylinder(row), 1.0, 0.0);
        let out = body.strike();
        let q = body.after(&out.impulse);
        row.assert_all_print(MOTION, q);
        row.assert_all_print(IMPULSES, ordered(&out.impulse));
        row.assert_prints("energy_ratio", body.energy_ratio(q));
    }
}

#[test]
fn the_cylinders_plastic_end_states_are_all_algebraic_solutions_of_the_table() {
    for row in &rows(tables::CYLINDER_PLASTIC) {
        let body = Rocking::cylinder(&cylinder(row), 1.0, 0.0);
        let ends = end_states::enumerate(&body.set(), Law::Poisson);
        let mut numbers: Vec<u8> = ends.found.iter().map(|e| number_of(&e.velocity, ROUNDING)).collect();
        numbers.sort_unstable();
        let printed: Vec<u8> = row.text("end_states").split('-').map(|s| s.parse().unwrap()).collect();
        assert_eq!(numbers, printed, "{row:?}\n{ends:?}");
    }
}

#[test]
fn elastic_cylinder_strikes_print_as_the_table() {
    for row in &rows(tables::CYLINDER_ELASTIC) {
        let body = Rocking::cylinder(&cylinder(row), 1.0, row.number("R"));
        let out = body.strike();
        let q = body.after(&out.impulse);
        row.assert_all_print(MOTION, q);
        let [[t_a, n_a], [t_k, n_k]] = out.velocity;
        row.assert_all_print(["vnA", "vtA", "vnK", "vtK"], [n_a, t_a, n_k, t_k]);
        row.assert_prints("energy_ratio", body.energy_ratio(q));
        assert_eq!(out.restitution_scaled, 1.0, "no energy to take back: {row:?}");
    }
}

#[test]
fn ambiguous_compressions_have_the_two_end_states_of_the_table() {
    let table = rows(tables::AMBIGUOUS_COMPRESSION);
    for pair in table.chunks(2) {
        let body = Rocking::cylinder(&cylinder(&pair[0]), 1.0, 0.0);
        let motions = end_motions(&body);
        assert_eq!(motions.len(), 2, "{pair:?} {motions:?}");
        for row in pair {
            assert!(motions.iter().any(|q| prints(row, MOTION, q)), "{row:?} {motions:?}");
        }
        let staged = body.after(&body.strike().impulse);
        let moving = pair.iter().find(|row| row.text("A") != "stick").unwrap();
        moving.assert_all_print(MOTION, staged);
    }
}

/// The rows of one problem of restitution.
fn problems(table: &[Row]) -> Vec<&[Row]> {
    table.chunk_by(|_, next| next.text("row") != "compression").collect()
}

#[test]
fn ambiguous_restitutions_have_the_staged_answer_and_the_end_states_of_the_table() {
    let table = rows(tables::AMBIGUOUS_RESTITUTION);
    assert_eq!(problems(&table).len(), 8);
    for problem in problems(&table) {
        let row = &problem[0];
        let cylinder = cylinder(row);
        let body = Rocking::cylinder(&cylinder, 1.0, row.number("R"));
        let mut motions = end_motions(&body);
        assert_compresses(row, &body);
        for row in problem.iter().filter(|row| row.text("row") == "staged") {
            row.assert_all_print(MOTION, body.after(&body.strike().impulse));
        }
        let mut printed: Vec<_> = problem.iter().filter(|row| row.text("row") == "end state").collect();
        if row.text("name") == "4" {
            // The impulses that stop it are not determined, and what follows is in proportion to them: a row is one member.
            let row = printed.pop().unwrap();
            assert_in_proportion(row, &cylinder, &body, &motions);
            motions.clear();
        }
        for row in &printed {
            assert!(motions.iter().any(|q| prints(row, MOTION, q)), "{row:?} {motions:?}");
        }
        // The other compression, wedged rest, adds rest at most.
        let at_rest = |q: &[f64; 3]| q.iter().all(|v| v.abs() <= ROUNDING);
        for q in &motions {
            let known = printed.iter().any(|row| prints(row, MOTION, q));
            assert!(known || (at_rest(q) && cylinder.may_wedge()), "{q:?} is not in {printed:?}");
        }
    }
}

/// End states that start from a stop with undetermined impulses: rest, or the printed motion times N_K/(the printed N_K), for an N_K within
/// the bounds of both cones.
fn assert_in_proportion(row: &Row, cylinder: &Cylinder, body: &Rocking, motions: &[[f64; 3]]) {
    let staged = body.strike();
    let [x, _, w] = body.after(&staged.impulse);
    row.assert_all_print(MOTION, [x, 0.0, w]);
    let (_, plastic) = cylinder.strike(1.0).unwrap();
    let rest = cylinder.rest_impulses(1.0).unwrap();
    let bounds = [rest.start[2], rest.start[2] + rest.length].map(|n| n / plastic.normal[1]);
    for q in motions {
        let factor = if w == 0.0 { 1.0 } else { q[2] / w };
        assert!((q[0] - factor * x).abs() <= ROUNDING && q[1].abs() <= ROUNDING, "{q:?} {row:?}");
        assert!(bounds[0] - ROUNDING <= factor && factor <= bounds[1] + ROUNDING, "{q:?} {bounds:?} {row:?}");
    }
    assert_eq!(motions.len(), 1, "{motions:?}");
}

#[test]
fn the_spin_after_an_undetermined_stop_ranges_from_0_013_to_0_035() {
    let disc = Cylinder {
        mass: 1.0,
        radius: 1.0,
        inertia_ratio: 0.5,
        friction: 0.45,
        half_angle: 64f64.to_radians(),
    };
    let body = Rocking::cylinder(&disc, 1.0, 0.5);
    let spin = body.after(&body.strike().impulse)[2];
    let (_, plastic) = disc.strike(1.0).unwrap();
    let rest = disc.rest_impulses(1.0).unwrap();
    let [low, high] = [0.0, rest.length].map(|more| spin * (rest.start[2] + more) / plastic.normal[1]);
    assert!((low - 0.013_247).abs() < PRINTED, "the stages take the least impulses: {low}");
    assert!((high - 0.035_174).abs() < PRINTED, "the most that both cones allow: {high}");
}

/// The first phase alone, from the stages of the walk.
fn assert_compresses(row: &Row, body: &Rocking) {
    let mut first = None;
    staged::resolve_observed(&body.set(), Law::Poisson, &mut |stage| {
        if stage.phase == Phase::Compression {
            first = Some(stage.end);
        }
    })
    .unwrap();
    let end = first.unwrap();
    row.assert_all_print(MOTION, body.after(&end.impulse));
    row.assert_all_print(IMPULSES, ordered(&end.impulse));
}

/// The prism's strike without restitution, and with it.
fn assert_prism_strikes(row: &Row, prism: &Prism, restitution: f64) {
    let body = Rocking::prism(prism, 1.0, 0.0);
    let out = body.strike();
    row.assert_all_print(MOTION, body.after(&out.impulse));
    row.assert_all_print(["SNA", "SNK"], [out.impulse[0][1], out.impulse[1][1]]);
    let ends = end_states::enumerate(&body.set(), Law::Poisson);
    assert_eq!(ends.found.len(), 1, "one end state: {row:?} {ends:?}");
    assert!(body.moves_as(&ends.found[0], &out.velocity, 1e-12), "{row:?} {ends:?}");
    let elastic = Rocking::prism(prism, 1.0, restitution);
    row.assert_all_print(["end_vx", "end_vy", "end_w"], elastic.after(&elastic.strike().impulse));
}

#[test]
fn regular_prism_strikes_print_as_the_table() {
    for row in &rows(tables::PRISM_REGULAR) {
        let prism = Prism::regular(row.text("n").parse().unwrap(), 1.0, 1.0, row.number("f"));
        assert_prism_strikes(row, &prism, 0.5);
        row.assert_prints("vtK", Rocking::prism(&prism, 1.0, 0.0).strike().velocity[1][0]);
    }
}

#[test]
fn irregular_prism_strikes_print_as_the_table() {
    for row in &rows(tables::PRISM_IRREGULAR) {
        let [to_centre, to_k, height, inertia, friction] = row.numbers(["dA", "dK", "h", "J", "f"]);
        assert_prism_strikes(row, &Prism { mass: 1.0, inertia, to_centre, to_k, height, friction }, 0.4);
    }
}

#[test]
fn rod_strikes_print_as_the_table() {
    for row in &rows(tables::ROD) {
        let [a, b, l, restitution] = row.numbers(["a", "b", "l", "R"]);
        let rod = SupportedRod::uniform(1.0, l, [a, b]);
        let plastic = Rocking::rod(&rod, 1.0, 0.0).strike();
        row.assert_all_print(["SYA", "SYB"], [plastic.impulse[0][1], plastic.impulse[1][1]]);
        let body = Rocking::rod(&rod, 1.0, restitution);
        let out = body.strike();
        let q = body.after(&out.impulse);
        row.assert_all_print(["vy", "w", "vA", "vB"], [q[1], q[2], out.velocity[0][1], out.velocity[1][1]]);
        row.assert_prints("energy_ratio", body.energy_ratio(q));
    }
}
