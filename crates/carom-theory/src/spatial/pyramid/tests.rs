//! The strikes of the pyramid, held to an independent enumeration.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;

fn strike(sides: u32, height: f64) -> PyramidStrike {
    Pyramid { sides, height, circumradius: 1.0, mass: 1.0 }.strike(1.0).unwrap()
}

/// Rows of a table computed independently, by enumerating all states of a general body: n, h/a, spin, energy ratio, normal impulses.
#[test]
fn the_strikes_are_those_of_an_independent_enumeration() {
    let rows = [
        (3, 0.25, [0.0, 0.166_448_387_3, 0.0], 0.080_007_256_9, [0.0, 0.037_196_84, 0.112_343_75]),
        (3, 2.0, [0.0; 3], 0.0, [0.098_630_33, 0.079_843_60, 0.385_127_94]),
        (
            4,
            0.5,
            [-0.093_969_491_2, -0.023_696_654_3, -0.083_202_529_4],
            0.042_581_826_0,
            [0.0, 0.0, 0.209_759_81],
        ),
        (
            5,
            1.0,
            [-0.273_222_687_7, -0.198_507_902_2, -0.337_721_814_9],
            0.228_112_048_6,
            [0.016_495_54, 0.0, 0.341_593_06],
        ),
        (
            8,
            0.9,
            [-0.537_028_512_3, -0.215_964_313_3, -0.524_192_520_5],
            0.613_983_183_1,
            [0.0, 0.0, 0.244_334_23],
        ),
    ];
    for (sides, height, spin, ratio, normal) in rows {
        let s = strike(sides, height);
        for (ours, table) in s.spin.iter().zip(spin) {
            assert!((ours - table).abs() < 6e-11, "n {sides} h {height}: {s:?}");
        }
        assert!((s.energy_ratio - ratio).abs() < 6e-11, "n {sides} h {height}: {s:?}");
        for (ours, table) in s.normal.iter().zip(normal) {
            assert!((ours - table).abs() < 6e-9, "n {sides} h {height}: {s:?}");
        }
    }
}

#[test]
fn long_and_short_meet_at_the_critical_height() {
    for sides in 3..12 {
        let of = |height: f64| Pyramid { sides, height, circumradius: 1.0, mass: 1.0 };
        let critical = of(1.0).critical_height();
        let (long, short) = (strike(sides, critical * (1.0 + 1e-9)), strike(sides, critical * (1.0 - 1e-9)));
        assert_ne!(long.kept, short.kept, "n {sides}");
        let change = minus(long.spin, short.spin);
        assert!(dot(change, change).sqrt() < 1e-8, "n {sides}: {long:?} {short:?}");
        assert!(long.normal[0] >= 0.0 && long.normal[0] < 1e-8, "n {sides}: {long:?}");
    }
}

#[test]
fn a_separates_from_every_base_but_a_triangle() {
    for sides in 3..40 {
        for height in [0.1, 0.5, 0.9, 1.0, 2.0, 7.0] {
            let pyramid = Pyramid { sides, height, circumradius: 1.0, mass: 1.0 };
            assert_eq!(pyramid.roll_ratio() > 0.0, sides > 3, "n {sides} h {height}");
        }
    }
}
