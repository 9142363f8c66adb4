//! Conventions on sharing, on sets whose outcome is known.

use super::*;
use crate::planar::contacts::set::Block;
use crate::planar::contacts::set::ContactSet6;
use crate::planar::contacts::set::Touch;
use carom_num::Vec2;

/// A few roundings of numbers of order one.
const EXACT: f64 = 1e-15;
/// Some ten roundings of velocities of order one.
const ROUNDING: f64 = 1e-14;

/// Equal balls of 1 kg in a row, no friction; ball 0 strikes with 1 m/s.
fn cradle(balls: usize, restitution: f64) -> ContactSet6 {
    let contacts = balls - 1;
    let mut set = ContactSet6 {
        count: contacts,
        operator: [[Block::default(); 6]; 6],
        slip: [0.0; 6],
        normal: [0.0; 6],
        friction: [0.0; 6],
        restitution: [restitution; 6],
    };
    for i in 0..contacts {
        for j in 0..contacts {
            let nn = if i == j {
                2.0
            } else if i.abs_diff(j) == 1 {
                -1.0
            } else {
                0.0
            };
            set.operator[i][j] = Block { tt: if i == j { 2.0 } else { 0.0 }, tn: 0.0, nt: 0.0, nn };
        }
    }
    set.normal[0] = -1.0;
    set
}

/// Velocities of the balls after.
fn balls(out: &StagedOutcome<6>, contacts: usize) -> Vec<f64> {
    let p = |i: usize| if i < contacts { out.impulse[i][1] } else { 0.0 };
    (0..=contacts).map(|b| if b == 0 { 1.0 - p(0) } else { p(b - 1) - p(b) }).collect()
}

#[test]
fn in_sequence_the_last_ball_of_a_cradle_leaves_with_all() {
    for n in 2..=5 {
        let out = in_sequence(&cradle(n, 1.0), Law::Poisson).unwrap();
        let v = balls(&out, n - 1);
        assert!((v[n - 1] - 1.0).abs() < EXACT, "{v:?}");
        assert!(v[..n - 1].iter().all(|v| v.abs() < EXACT), "{v:?}");
    }
}

#[test]
fn together_every_ball_but_the_first_leaves_alike() {
    // Compression makes all equal, v = 1/n; restitution repeats its impulses: v₁ = 2/n − 1, the others 2/n.
    for n in 2..=5_u32 {
        let out = staged::resolve(&cradle(n as usize, 1.0), Law::Poisson).unwrap();
        let v = balls(&out, n as usize - 1);
        let share = 2.0 / f64::from(n);
        assert!((v[0] - (share - 1.0)).abs() < ROUNDING, "{v:?}");
        assert!(v[1..].iter().all(|v| (v - share).abs() < ROUNDING), "{v:?}");
    }
}

#[test]
fn every_reaches_both_conventions() {
    let set = cradle(3, 0.0);
    let all = every(&set, 64).unwrap();
    let together = staged::resolve(&set, Law::Poisson).unwrap();
    assert!(all.iter().any(|out| alike(&set, out, &together)), "{all:?}");
    for out in &all {
        assert!(out.velocity[..2].iter().all(|u| u[1] >= 0.0), "{out:?}");
        assert!(out.work[..2].iter().flatten().sum::<f64>() <= EXACT, "{out:?}");
    }
}

#[test]
fn where_one_load_lifts_the_other_contact_the_order_decides() {
    // Loading one contact alone, u = −1 at both: p = 1/2, the other is left with −3/4 and takes 3/8, which lifts the first by 3/16.
    let mut set = cradle(3, 0.0);
    (set.operator[0][1].nn, set.operator[1][0].nn) = (0.5, 0.5);
    set.normal[1] = -1.0;
    let reached = every(&set, 64).unwrap();
    let ends = |a: f64, b: f64| {
        reached
            .iter()
            .any(|out| (out.velocity[0][1] - a).abs() < ROUNDING && (out.velocity[1][1] - b).abs() < ROUNDING)
    };
    assert!(ends(0.1875, 0.0) && ends(0.0, 0.1875) && ends(0.0, 0.0), "{reached:?}");
    assert!(reached.len() > 10, "{} between them", reached.len());
}

#[test]
fn a_sequence_that_dies_out_comes_to_rest() {
    // A rod that turns about one support and falls on the other, without restitution: struck in turn, it comes to rest as struck together.
    let mut set = cradle(3, 0.0);
    let (nn, across) = (4.0, -2.0);
    set.operator[0][0].nn = nn;
    set.operator[1][1].nn = nn;
    set.operator[0][1].nn = across;
    set.operator[1][0].nn = across;
    let (turn, together) =
        (in_sequence(&set, Law::Poisson).unwrap(), staged::resolve(&set, Law::Poisson).unwrap());
    for i in 0..2 {
        assert!((turn.impulse[i][1] - together.impulse[i][1]).abs() < 1e-11, "{turn:?} {together:?}");
    }
}

#[test]
fn in_sequence_each_impact_starts_where_the_last_one_ended() {
    // A box comes down on both corners, one of them a little sooner, and slides: what the first strike leaves of the slip the second one finds.
    let touch = |x: f64, friction| Touch {
        arm: Vec2::new(x, -0.1),
        normal: Vec2::new(0.0, 1.0),
        friction,
        restitution: 0.3,
    };
    let touches = [touch(-0.2, 0.4), touch(0.2, 0.1)];
    let set = ContactSet6::of_free_body(1.0, 0.02, Vec2::new(1.5, -1.0), 0.4, &touches).unwrap();
    let out = in_sequence(&set, Law::Poisson).unwrap();
    assert!(out.impulse[..2].iter().all(|p| p[1] > 0.0), "both are struck: {out:?}");
    let mut energy = 0.0;
    for i in 0..2 {
        let before = [set.slip[i], set.normal[i]];
        for axis in 0..2 {
            let row = (0..2).map(|j| {
                let (b, [q, p]) = (&set.operator[i][j], out.impulse[j]);
                [b.tt * q + b.tn * p, b.nt * q + b.nn * p][axis]
            });
            let after = before[axis] + row.sum::<f64>();
            assert!((after - out.velocity[i][axis]).abs() < 1e-13, "{after} {out:?}");
            energy += 0.5 * (before[axis] + after) * out.impulse[i][axis];
        }
        let [q, p] = out.impulse[i];
        assert!(q.abs() <= set.friction[i] * p + EXACT, "{out:?}");
    }
    let work: f64 = out.work.iter().flatten().sum();
    assert!((work - energy).abs() < 1e-13 && work < 0.0, "{work} {energy}");
}
