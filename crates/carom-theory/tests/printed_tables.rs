//! The closed forms of rocking bodies against every row of the tables, to the printed digits.

use crate::tables;

use carom_theory::rocking::{
    Cylinder, CylinderRegions, Prism, RodState, Strike, SupportedRod, Tangential, housner_ratio,
    housner_sliding_friction, housner_sticking_friction, rimless_wheel_ratio,
    rimless_wheel_sticking_friction, solid_polygon_inertia_ratio, thin_walled_polygon_inertia_ratio,
};
use tables::{IMPULSES, MOTION, Row, cylinder, rows};

fn motion(strike: &Strike) -> [f64; 3] {
    [strike.velocity[0], strike.velocity[1], strike.roll_rate]
}

fn impulses(strike: &Strike) -> [f64; 4] {
    let Tangential::Each([a, k]) = strike.tangential else { panic!("determined impulses: {strike:?}") };
    [strike.normal[0], a, strike.normal[1], k]
}

#[test]
fn cylinder_boundaries_are_the_tables() {
    let table = rows(tables::CYLINDER_BOUNDARIES);
    assert_eq!(table.len(), 57);
    for row in &table {
        let (b, f) = (row.number("b"), row.number("f"));
        let regions = CylinderRegions::new(b).expect("in the domain");
        row.assert_prints("g12_deg", regions.gripping(f).to_degrees());
        row.assert_prints("g23_deg", regions.pressing(f).to_degrees());
        row.assert_prints("g34_deg", regions.stopping(f).to_degrees());
        row.assert_prints("wedge_deg", regions.wedging(f).to_degrees());
        let active = regions.active(f).expect("in the domain");
        let states: Vec<u8> = row.text("states").split('-').map(|s| s.parse().expect("a number")).collect();
        assert_eq!(active.len() + 1, states.len(), "{row:?}");
        if !row.text("g14_deg").is_empty() {
            row.assert_prints("g14_deg", regions.rolling_over().to_degrees());
        }
        // On either side of each boundary stands the state that the table says.
        for (i, gamma) in active.iter().enumerate().filter(|(_, g)| **g > 1e-3 && **g < 1.57) {
            for (side, expected) in [(-1e-6, states[i]), (1e-6, states[i + 1])] {
                let cylinder = Cylinder {
                    mass: 1.0,
                    radius: 1.0,
                    inertia_ratio: b,
                    friction: f,
                    half_angle: gamma + side,
                };
                assert_eq!(cylinder.state().number(), expected, "{side:+} of boundary {i}: {row:?}");
            }
        }
    }
}

#[test]
fn cylinder_strikes_are_the_tables() {
    let table = rows(tables::CYLINDER_PLASTIC);
    assert_eq!(table.len(), 33);
    for row in &table {
        let cylinder = cylinder(row);
        let (state, strike) = cylinder.strike(1.0).expect("in the domain");
        assert_eq!(state.label(), row.text("state"), "{row:?}");
        row.assert_all_print(MOTION, motion(&strike));
        row.assert_all_print(IMPULSES, impulses(&strike));
        row.assert_prints("energy_ratio", strike.energy_ratio(cylinder.inertia_ratio));
        let ends: Vec<String> = cylinder.end_states().iter().map(u8::to_string).collect();
        assert_eq!(ends.join("-"), row.text("end_states"), "{row:?}");
    }
}

/// Velocities (v_nA, v_tA, v_nK, v_tK) of the cylinder's contact points.
fn contact_velocities(cylinder: &Cylinder, q: [f64; 3]) -> [f64; 4] {
    let (s, c) = libm::sincos(2.0 * cylinder.half_angle);
    let [x, y, w] = q;
    [y, x - w, c * y - s * x, c * x + s * y - w]
}

#[test]
fn elastic_cylinder_strikes_are_the_tables() {
    let table = rows(tables::CYLINDER_ELASTIC);
    assert_eq!(table.len(), 23);
    for row in &table {
        let cylinder = cylinder(row);
        let (end, strike) = cylinder.elastic_strike(1.0, row.number("R")).expect("in the domain");
        let q = motion(&strike);
        row.assert_all_print(MOTION, q);
        row.assert_all_print(["vnA", "vtA", "vnK", "vtK"], contact_velocities(&cylinder, q));
        row.assert_prints("energy_ratio", strike.energy_ratio(cylinder.inertia_ratio));
        // On the boundary R = R_c rounding chooses between 5a and a re-closing that lasts no time.
        let tie = row.text("end") == "5a" && row.number("vnA") == 0.0;
        assert!(end.label() == row.text("end") || (tie && end.label() == "5r"), "{end:?} {row:?}");
        let balanced = after(&cylinder, [1.0, 0.0, 1.0], impulses(&strike));
        for (ours, sum) in q.into_iter().zip(balanced) {
            assert!((ours - sum).abs() < 1e-13, "momentum and spin balance: {strike:?} {row:?}");
        }
    }
}

/// The motion that impulses (N_A, T_A, N_K, T_K) make of another.
fn after(cylinder: &Cylinder, q: [f64; 3], p: [f64; 4]) -> [f64; 3] {
    let (s, c) = libm::sincos(2.0 * cylinder.half_angle);
    let [n_a, t_a, n_k, t_k] = p;
    [
        q[0] + t_a - s * n_k + c * t_k,
        q[1] + n_a + c * n_k + s * t_k,
        q[2] - (t_a + t_k) / cylinder.inertia_ratio,
    ]
}

#[test]
fn both_end_states_of_ambiguous_compressions_are_the_tables() {
    let table = rows(tables::AMBIGUOUS_COMPRESSION);
    assert_eq!(table.len(), 10);
    for row in &table {
        let cylinder = cylinder(row);
        let (state, strike) = cylinder.strike(1.0).expect("in the domain");
        assert_eq!(state.label(), row.text("staged_state"), "{row:?}");
        assert_eq!(cylinder.end_states(), [state.number(), 4], "{row:?}");
        if row.text("A") != "stick" {
            row.assert_all_print(MOTION, motion(&strike));
            row.assert_all_print(IMPULSES, impulses(&strike));
            continue;
        }
        let rest = cylinder.rest_impulses(1.0).expect("it can be wedged");
        row.assert_all_print(MOTION, [0.0; 3]);
        row.assert_all_print(IMPULSES, rest.start);
        assert!(rest.length.is_infinite(), "{rest:?} {row:?}");
        // The second member that is printed is one unit of length further.
        let norm = rest.direction.iter().map(|d| d * d).sum::<f64>().sqrt();
        let further = [0, 1, 2, 3].map(|i| rest.start[i] + rest.direction[i] / norm);
        row.assert_all_print(["further_SNA", "further_STA", "further_SNK", "further_STK"], further);
    }
}

#[test]
fn ambiguous_restitutions_are_the_tables() {
    let table = rows(tables::AMBIGUOUS_RESTITUTION);
    assert_eq!(table.len(), 37);
    for row in &table {
        let cylinder = cylinder(row);
        let restitution = row.number("R");
        let (state, plastic) = cylinder.strike(1.0).expect("in the domain");
        let (end, elastic) = cylinder.elastic_strike(1.0, restitution).expect("in the domain");
        match row.text("row") {
            "compression" => {
                assert_eq!(state.label(), row.text("name"), "{row:?}");
                row.assert_all_print(MOTION, motion(&plastic));
                row.assert_all_print(IMPULSES, impulses(&plastic));
            }
            "staged" => {
                assert_eq!(end.label(), row.text("name"), "{row:?}");
                row.assert_all_print(MOTION, motion(&elastic));
            }
            "end state" => {
                // The impulses of the second phase: from one end state of the first, obeying every law.
                let second = row.numbers(IMPULSES);
                let first = impulses(&plastic);
                let q = after(&cylinder, motion(&plastic), second);
                let rest = after(&cylinder, [0.0; 3], second);
                let from_rest = rest.iter().zip(MOTION).all(|(ours, n)| (ours - row.number(n)).abs() < 4e-6);
                let moving = q.iter().zip(MOTION).all(|(ours, n)| (ours - row.number(n)).abs() < 4e-6);
                assert!(moving || from_rest, "balances: {q:?} {row:?}");
                for i in [0, 2] {
                    assert!(second[i] >= restitution * first[i] - 1e-6 || from_rest, "Poisson: {row:?}");
                    let cone = cylinder.friction * second[i];
                    assert!(second[i + 1].abs() <= cone + 2e-6, "Coulomb: {row:?}");
                }
            }
            "exactly R times" => {
                // Repeating every normal impulse R times is possible where A never has to take more.
                let count = usize::from(matches!(end.label(), "5a" | "5b" | "5c" | "6a"));
                assert_eq!(count.to_string(), row.text("name"), "{row:?}");
            }
            other => panic!("unknown row {other}"),
        }
    }
}

fn wheel(row: &Row) -> (u32, f64) {
    let n = row.text("n").parse().expect("a number of sides");
    let ratio = match row.text("kind") {
        "solid" => solid_polygon_inertia_ratio(n),
        "shell" => thin_walled_polygon_inertia_ratio(n),
        _ => 1.0,
    };
    (n, ratio)
}

#[test]
fn regular_prisms_have_the_ratios_and_thresholds_of_the_tables() {
    let table = rows(tables::PRISM_RATIOS);
    assert_eq!(table.len(), 30);
    for row in &table {
        let (n, j) = wheel(row);
        row.assert_prints("j", j);
        row.assert_prints("ratio", rimless_wheel_ratio(n, j));
        row.assert_prints("f_stick", rimless_wheel_sticking_friction(n, j));
        let prism = |friction| Prism { inertia: j, ..Prism::regular(n, 1.0, 1.0, friction) };
        row.assert_prints("f_stick", prism(0.0).sticking_friction());
        row.assert_prints("f_A", prism(0.0).staying_friction());
        let flat = prism(0.0).height / prism(0.0).to_centre;
        row.assert_prints("cot", flat);
        // A state between each pair of neighbouring thresholds.
        let (last, slides) = (prism(0.0).sticking_friction(), prism(0.0).staying_friction());
        let samples = match row.text("states") {
            "2-1" => vec![0.5 * flat, 2.0 * flat],
            "2-4-3" => vec![0.5 * slides, 0.5 * (slides + last), 2.0 * last],
            _ => vec![0.5 * last, 2.0 * last],
        };
        for (friction, expected) in samples.into_iter().zip(row.text("states").split('-')) {
            let (state, strike) = prism(friction).strike(1.0).expect("in the domain");
            // J = m(d_A d_K − h²) for the thin-walled triangle: states 1 and 3 are one, at rest.
            let tie = strike.roll_rate.abs() < 1e-15 && expected == "1";
            assert!(state.number().to_string() == expected || tie, "f = {friction}: {state:?} {row:?}");
        }
    }
}

/// Compares the prism's strike and its continuation with restitution R; the states after it are numbered 9 − state.
fn assert_prism_strikes(row: &Row, prism: &Prism, restitution: f64) {
    let (state, strike) = prism.strike(1.0).expect("in the domain");
    assert_eq!(state.number().to_string(), row.text("state"), "{row:?}");
    row.assert_all_print(MOTION, motion(&strike));
    row.assert_all_print(["SNA", "SNK"], strike.normal);
    let elastic = strike.with_restitution(restitution);
    row.assert_all_print(["end_vx", "end_vy", "end_w"], motion(&elastic));
    let end = [8, 7, 5, 6][usize::from(state.number()) - 1];
    assert_eq!(end.to_string(), row.text("end"), "{row:?}");
}

#[test]
fn regular_prism_strikes_are_the_tables() {
    let table = rows(tables::PRISM_REGULAR);
    assert_eq!(table.len(), 60);
    for row in &table {
        let prism =
            Prism::regular(row.text("n").parse().expect("a number of sides"), 1.0, 1.0, row.number("f"));
        assert_prism_strikes(row, &prism, 0.5);
        let (_, strike) = prism.strike(1.0).expect("in the domain");
        row.assert_prints("vtK", strike.velocity[0] - prism.height * strike.roll_rate);
    }
}

#[test]
fn irregular_prism_strikes_are_the_tables() {
    let table = rows(tables::PRISM_IRREGULAR);
    assert_eq!(table.len(), 11);
    for row in &table {
        let [to_centre, to_k, height, inertia, friction] = row.numbers(["dA", "dK", "h", "J", "f"]);
        let prism = Prism { mass: 1.0, inertia, to_centre, to_k, height, friction };
        row.assert_prints("cosine_term", height * height - to_centre * to_k);
        assert_prism_strikes(row, &prism, 0.4);
    }
}

#[test]
fn rod_strikes_are_the_tables() {
    let table = rows(tables::ROD);
    assert_eq!(table.len(), 52);
    for row in &table {
        let [a, b, l, restitution] = row.numbers(["a", "b", "l", "R"]);
        let rod = SupportedRod::uniform(1.0, l, [a, b]);
        let (state, plastic) = rod.strike(1.0).expect("in the domain");
        row.assert_prints("ratio", 12.0 * a * b / (l * l));
        row.assert_prints("k", rod.k());
        row.assert_all_print(["SYA", "SYB"], plastic.normal);
        row.assert_prints("w1", plastic.roll_rate);
        let strike = plastic.with_restitution(restitution);
        let (rise, rate) = (strike.velocity[1], strike.roll_rate);
        row.assert_all_print(["vy", "w", "vA", "vB"], [rise, rate, rise + rate * a, rise - rate * b]);
        row.assert_prints("energy_ratio", strike.energy_ratio(rod.inertia));
        let variant = if state == RodState::Stops { 1 } else { 2 } + if restitution > 0.0 { 2 } else { 0 };
        // At 12ab = l² both forms agree.
        let tie = (12.0 * a * b - l * l).abs() < 1e-15;
        assert!(variant.to_string() == row.text("variant") || tie, "{state:?} {row:?}");
    }
}

#[test]
fn housners_block_is_the_table() {
    let table = rows(tables::HOUSNER);
    assert_eq!(table.len(), 12);
    for row in &table {
        let alpha = row.number("alpha_deg").to_radians();
        let ratio = housner_ratio(alpha);
        row.assert_prints("ratio", ratio);
        row.assert_prints("energy_ratio", ratio * ratio);
        row.assert_prints("f_stick", housner_sticking_friction(alpha));
        row.assert_prints("f_A", housner_sliding_friction(alpha));
    }
}
