//! What stands as printed for a formula is the formula's value.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use carom_theory::bouncing::Drop;
use carom_theory::falling_stick::floor_force_foot_fixed;
use carom_theory::incline::friction_angle;
use carom_theory::painleve::critical_friction;
use carom_theory::rocking::{
    SupportedRod, housner_ratio, rimless_wheel_ratio, rimless_wheel_speed, solid_polygon_inertia_ratio,
};
use carom_theory::spatial::Pyramid;
use carom_validation::{Table, table};

/// What is printed under a key.
fn printed(table: &Table, key: &str) -> String {
    let row = table.rows.iter().find(|row| row.key == key);
    row.map(|row| row.printed.clone()).unwrap_or_else(|| format!("no row {key}"))
}

/// Holds a printed entry to a value, rounded as the entry is.
fn is(table: &Table, key: &str, value: f64) {
    let entry = printed(table, key);
    let decimals = entry.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    assert_eq!(entry, format!("{value:.decimals$}"), "{key}");
}

#[test]
fn blocks_and_wheels() {
    let block = table("housner_block").unwrap();
    for alpha in [5, 10, 15, 20, 30, 45, 50, 60] {
        let ratio = housner_ratio(f64::from(alpha).to_radians());
        is(&block, &format!("rate.{alpha}"), ratio);
        is(&block, &format!("energy.{alpha}"), ratio * ratio);
    }
    let wheel = table("rimless_wheel").unwrap();
    for (spokes, j) in [(8, 0.05), (6, 0.5), (8, 0.25), (10, 0.5), (12, 0.5)] {
        is(&wheel, &format!("ratio.{spokes}.{j}"), rimless_wheel_ratio(spokes, j));
        let steady = rimless_wheel_speed(spokes, j, [1.0, 9.81], 8_f64.to_radians()).unwrap();
        is(&wheel, &format!("steady.{spokes}.{j}"), steady);
    }
}

#[test]
fn rods_and_pyramids() {
    let rod = table("rod").unwrap();
    for [length, a, b] in
        [[2.0, 0.5, 0.5], [1.0, 0.2, 0.3], [1.0, 0.1, 0.4], [1.0, 0.4, 0.1], [1.5, 0.3, 0.5]]
    {
        is(&rod, &format!("k.{length}.{a}.{b}"), SupportedRod::uniform(1.0, length, [a, b]).k());
    }
    let pyramid = table("pyramid").unwrap();
    for sides in [4, 5, 6, 8, 12] {
        let critical = Pyramid { sides, circumradius: 1.0, height: 1.0, mass: 1.0 }.critical_height();
        is(&pyramid, &format!("border.{sides}"), critical);
    }
    assert!((solid_polygon_inertia_ratio(3) - 0.25).abs() < 1e-15, "the triangle of the prism's impulses");
}

#[test]
fn friction_and_bounces() {
    let painleve = table("painleve_rod").unwrap();
    is(&painleve, "friction.least", critical_friction(1.0 / 3.0));
    let ball = table("bouncing_ball").unwrap();
    for restitution in [0.5, 0.7, 0.9] {
        let drop = Drop { height: 0.5, gravity: 9.81, restitution };
        is(&ball, &format!("time.{restitution}"), drop.end_of_bouncing().unwrap());
        for n in [1, 2] {
            is(&ball, &format!("height.{restitution}.{n}"), drop.rebound_height(n));
        }
    }
    is(&table("incline").unwrap(), "angle", friction_angle(0.3).to_degrees());
    let stick = table("falling_stick").unwrap();
    for friction in [0.1, 0.3, 0.36, 0.5, 1.0] {
        let tilt: f64 = printed(&stick, &format!("angle.{friction}")).parse().unwrap();
        let (forward, upward) = floor_force_foot_fixed(tilt.to_radians());
        // Seven decimals of a degree.
        assert!((forward.abs() / upward - friction).abs() < 1e-7, "friction {friction} at {tilt} deg");
    }
}
