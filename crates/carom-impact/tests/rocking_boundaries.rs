//! The staged impact against the closed forms of rocking bodies at and beside the boundaries of their states.

use crate::rocking_bodies;

use carom_num::elementary::{cos, tan};
use carom_theory::rocking::{Cylinder, CylinderRegions, Prism};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rocking_bodies::Rocking;
use rocking_bodies::compare::{AGREEMENT, Tally, differences};
use rocking_bodies::draw::{beside, cylinder, prism, restitution, rod};

/// Heights or speeds that differ by less, relative to them, are one border.
const APART: f64 = 1e-9;

const CASES: usize = 100_000;
/// Beside a boundary the last stage of a stop is as short as the distance to it: one digit less than elsewhere.
const BESIDE: f64 = 10.0 * AGREEMENT;

/// A cylinder at or beside a boundary of its states, and a restitution at or beside one of its ends.
fn cylinder_on_a_boundary(rng: &mut Pcg64) -> (Cylinder, f64) {
    let mut c = cylinder(rng);
    c.friction += 0.01;
    let regions = CylinderRegions::new(c.inertia_ratio).unwrap();
    let star = regions.quadruple_friction();
    if star < 2.0 && rng.random_range(0..6) == 0 {
        c.friction = star * beside(rng);
    }
    let f = c.friction;
    c.half_angle = beside(rng)
        * match rng.random_range(0..6) {
            0 => regions.gripping(f),
            1 => regions.pressing(f),
            2 => regions.stopping(f),
            3 => regions.rolling_over(),
            4 => regions.wedging(f),
            _ => c.half_angle,
        };
    c.half_angle = c.half_angle.min(1.56);
    let (cosine, rate) = (cos(2.0 * c.half_angle), c.strike(1.0).unwrap().1.roll_rate);
    let e = beside(rng)
        * match rng.random_range(0..4) {
            0 => -(c.inertia_ratio + cosine) / ((1.0 + c.inertia_ratio) * cosine),
            1 => rate / (1.0 - cosine - rate),
            2 => 1e-9,
            _ => 1.0,
        };
    (c, if e > 0.0 && e <= 1.0 { e } else { rng.random_range(0.01..1.0) })
}

/// Where the law itself decides within rounding, or jumps, and what is said there is not compared.
fn undecided(c: &Cylinder) -> Option<&'static str> {
    let regions = CylinderRegions::new(c.inertia_ratio).unwrap();
    if (c.friction * tan(c.half_angle) - 1.0).abs() < 1e-6 {
        Some("f tan γ = 1: wedged, or all but at rest")
    } else if (c.half_angle - regions.rolling_over()).abs() < APART
        && c.friction > regions.quadruple_friction() * (1.0 - APART)
    {
        Some("cos 2γ = −b, f > f*: rolling over slides back with restitution, rest stays wedged")
    } else {
        None
    }
}

#[test]
#[allow(clippy::print_stdout, reason = "the counts show that boundaries are met from both sides")]
fn cylinders_at_the_boundaries_of_their_states_strike_as_their_closed_forms_say() {
    let mut rng = Pcg64::seed_from_u64(7);
    let (mut plastic, mut elastic, mut open) = (Tally::default(), Tally::default(), Tally::default());
    for _ in 0..CASES {
        let (c, e) = cylinder_on_a_boundary(&mut rng);
        let (state, strike) = c.strike(1.0).unwrap();
        let body = Rocking::cylinder(&c, 1.0, 0.0);
        plastic.compare_within(BESIDE, state.label(), &body, &strike, false);
        let (end, strike) = c.elastic_strike(1.0, e).unwrap();
        let body = Rocking::cylinder(&c, 1.0, e);
        // At rest for one side, all but at rest for the other.
        let ([x, y], w) = (strike.velocity, strike.roll_rate * c.radius);
        let wedged = x.abs() + y.abs() + w.abs() <= BESIDE * body.speed();
        let Some(why) = undecided(&c) else {
            elastic.compare_within(BESIDE, end.label(), &body, &strike, wedged);
            continue;
        };
        open.count(why);
        if differences(&body, &strike, true)[0] > BESIDE {
            open.count(&format!("of which {} moves otherwise", end.label()));
        }
    }
    println!("plastic {plastic:?}\nelastic {elastic:?}\nnot compared {:#?}", open.counts);
    assert!(plastic.counts.len() == 6 && elastic.counts.len() == 8, "all are met");
}

/// A prism at or beside one of the boundaries of its states, or where they all meet.
fn prism_on_a_boundary(rng: &mut Pcg64) -> Prism {
    let mut p = prism(rng);
    let least = p.mass * (p.to_centre * p.to_k - p.height * p.height);
    let kind = rng.random_range(0..5);
    if kind < 2 && least > 0.0 {
        p.inertia = least * beside(rng);
    }
    p.friction = match kind {
        0 | 2 => p.height / p.to_centre * beside(rng),
        3 => p.sticking_friction() * beside(rng),
        4 if p.staying_friction() > 0.0 => p.staying_friction() * beside(rng),
        _ => p.friction,
    };
    p
}

#[test]
#[allow(clippy::print_stdout, reason = "the counts show that boundaries are met from both sides")]
fn prisms_at_the_boundaries_of_their_states_strike_as_their_closed_forms_say() {
    let mut rng = Pcg64::seed_from_u64(8);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let (p, e) = (prism_on_a_boundary(&mut rng), restitution(&mut rng));
        let (state, strike) = p.strike(1.0).unwrap();
        let (body, strike) = (Rocking::prism(&p, 1.0, e), strike.with_restitution(e));
        tally.compare_within(BESIDE, &state.number().to_string(), &body, &strike, false);
    }
    println!("{tally:?}");
    assert_eq!(tally.counts.len(), 4, "every state is met");
}

#[test]
#[allow(clippy::print_stdout, reason = "the counts show that the boundary is met from both sides")]
fn rods_that_all_but_stop_strike_as_their_closed_forms_say() {
    let mut rng = Pcg64::seed_from_u64(9);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let (mut rod, e) = (rod(&mut rng), restitution(&mut rng));
        rod.to_a += 0.01;
        rod.inertia = rod.mass * rod.to_a * rod.to_b * beside(&mut rng);
        let (state, strike) = rod.strike(1.0).unwrap();
        let body = Rocking::rod(&rod, 1.0, e);
        tally.compare(&format!("{state:?}"), &body, &strike.with_restitution(e), false);
    }
    println!("{tally:?}");
    assert_eq!(tally.counts.len(), 2, "both states are met");
}
