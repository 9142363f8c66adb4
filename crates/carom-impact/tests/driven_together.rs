//! Touching contacts that friction drives in and that drive each other in: none can be loaded alone, for the other could not follow.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use carom_impact::Law;
use carom_impact::planar::staged::{self, StagedOutcome};
use carom_impact::planar::{Block, ContactSet, ContactSet6, Touch, end_states};
use carom_num::Vec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Differences of velocities and impulses that rounding may make, against the largest of their terms: operators of these scenes are nearly
/// singular.
const ROUNDING: f64 = 1e-8;
/// By how much one contact may take more of the load than another: 0.02 of it, or 50 times as much.
const SHARES: [f64; 7] = [0.02, 0.1, 0.5, 1.0, 2.0, 10.0, 50.0];

/// Operators that came up among random ones.
fn scenes() -> Vec<ContactSet6> {
    let text = include_str!("driven_together.txt");
    let numbers = |line: &str| line.split_whitespace().map(|v| v.parse().unwrap()).collect::<Vec<f64>>();
    let scene = |paragraph: &str| {
        let lines: Vec<Vec<f64>> = paragraph.lines().map(numbers).collect();
        let (friction, velocity, rows) = (&lines[0], &lines[1], &lines[2..]);
        let mut set = empty(friction.len());
        for i in 0..set.count {
            (set.friction[i], set.slip[i], set.normal[i]) =
                (friction[i], velocity[2 * i], velocity[2 * i + 1]);
            for j in 0..set.count {
                let entry = |a: usize, b: usize| rows[2 * i + a][2 * j + b];
                set.operator[i][j] =
                    Block { tt: entry(0, 0), tn: entry(0, 1), nt: entry(1, 0), nn: entry(1, 1) };
            }
        }
        set
    };
    text.split("\n\n").skip(1).map(scene).collect()
}

fn empty(count: usize) -> ContactSet6 {
    let none = [0.0; 6];
    ContactSet {
        count,
        operator: [[Block::default(); 6]; 6],
        slip: none,
        normal: none,
        friction: none,
        restitution: none,
    }
}

/// The contacts in another order: contact k is contact `order[k]` of `set`.
fn permuted(set: &ContactSet6, order: &[usize]) -> ContactSet6 {
    let mut out = empty(set.count);
    for (i, &from) in order.iter().enumerate() {
        (out.slip[i], out.normal[i]) = (set.slip[from], set.normal[from]);
        (out.friction[i], out.restitution[i]) = (set.friction[from], set.restitution[from]);
        for (j, &other) in order.iter().enumerate() {
            out.operator[i][j] = set.operator[from][other];
        }
    }
    out
}

/// Seen in a mirror: tangents turn round.
fn mirrored(set: &ContactSet6) -> ContactSet6 {
    let mut out = *set;
    out.slip = set.slip.map(|u| -u);
    out.operator = set.operator.map(|row| row.map(|b| Block { tn: -b.tn, nt: -b.nt, ..b }));
    out
}

/// Contact i with its impulse measured in another unit and its velocity in that unit's inverse: power stays, the law does not see it, but a
/// load of one unit at every contact is shared otherwise.
fn measured(set: &ContactSet6, unit: [f64; 6]) -> ContactSet6 {
    let mut out = *set;
    for i in 0..set.count {
        out.slip[i] *= unit[i];
        out.normal[i] *= unit[i];
        for j in 0..set.count {
            let (b, by) = (&set.operator[i][j], unit[i] * unit[j]);
            out.operator[i][j] = Block { tt: b.tt * by, tn: b.tn * by, nt: b.nt * by, nn: b.nn * by };
        }
    }
    out
}

fn work(out: &StagedOutcome<6>) -> f64 {
    out.work.iter().flatten().sum()
}

/// Largest difference of a velocity, against the terms that it is the sum of.
fn drift(set: &ContactSet6, a: &[[f64; 2]; 6], b: &[[f64; 2]; 6], impulse: &[[f64; 2]; 6]) -> f64 {
    let mut worst = 0.0f64;
    for i in 0..set.count {
        let mut terms = [set.slip[i].abs(), set.normal[i].abs()];
        for (w, p) in set.operator[i].iter().zip(impulse) {
            terms[0] += (w.tt * p[0]).abs() + (w.tn * p[1]).abs();
            terms[1] += (w.nt * p[0]).abs() + (w.nn * p[1]).abs();
        }
        let scale = terms[0].max(terms[1]);
        worst = (0..2).fold(worst, |m, axis| m.max((a[i][axis] - b[i][axis]).abs() / scale));
    }
    worst
}

#[test]
fn contacts_that_drive_each_other_in_end_in_the_one_state_there_is() {
    let scenes = scenes();
    assert_eq!(scenes.len(), 5, "all scenes are read");
    for (k, set) in scenes.iter().enumerate() {
        let ends = end_states::enumerate(set, Law::Poisson);
        assert_eq!(ends.found.len(), 1, "scene {k}: one state among 4^n");
        let end = &ends.found[0];
        let mut order: Vec<usize> = (0..set.count).collect();
        for turn in 0..set.count {
            order.rotate_left(1);
            for (what, seen, sign) in [
                ("as it is", permuted(set, &order), 1.0),
                ("mirrored", mirrored(&permuted(set, &order)), -1.0),
            ] {
                let out =
                    staged::resolve(&seen, Law::Poisson).unwrap_or_else(|e| panic!("{k} {turn} {what}: {e}"));
                assert!(work(&out) < 0.0, "scene {k}, {what}: work {}", work(&out));
                let (mut velocity, mut impulse) = ([[0.0; 2]; 6], [[0.0; 2]; 6]);
                for (i, &from) in order.iter().enumerate() {
                    velocity[from] = [sign * out.velocity[i][0], out.velocity[i][1]];
                    impulse[from] = [sign * out.impulse[i][0], out.impulse[i][1]];
                }
                let off = drift(set, &velocity, &end.velocity, &end.impulse);
                assert!(off < ROUNDING, "scene {k}, {what}, turned by {turn}: {off:e} off the end state");
            }
        }
    }
}

#[test]
fn how_they_share_the_load_does_not_matter() {
    for (k, set) in scenes().iter().enumerate() {
        let equal = staged::resolve(set, Law::Poisson).unwrap();
        for i in 0..set.count {
            for share in SHARES {
                let mut unit = [1.0; 6];
                unit[i] = share;
                let out = staged::resolve(&measured(set, unit), Law::Poisson);
                let out = out.unwrap_or_else(|e| panic!("scene {k}, contact {i}, {share}: {e}"));
                let (mut velocity, mut impulse) = (out.velocity, out.impulse);
                (0..2).for_each(|axis| {
                    (velocity[i][axis], impulse[i][axis]) =
                        (velocity[i][axis] / share, impulse[i][axis] * share)
                });
                let off = drift(set, &velocity, &equal.velocity, &equal.impulse);
                assert!(off < ROUNDING, "scene {k}, {share} of contact {i}: {off:e} off");
            }
        }
    }
}

/// A free body that slips at two points, which friction drives in alone and by each other: all four entries of `W_nn − s μ W_nt` are below 0. The
/// first approaches, or both only touch, or a third contact strikes.
fn drawn(rng: &mut Pcg64) -> Option<ContactSet6> {
    let touch = |rng: &mut Pcg64| Touch {
        arm: Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0)),
        normal: Vec2::at_angle(rng.random_range(-3.2..3.2)),
        friction: rng.random_range(0.5..8.0),
        restitution: 0.0,
    };
    let count = rng.random_range(2..4);
    let touches: Vec<Touch> = (0..count).map(|_| touch(rng)).collect();
    // Where the normals of the first two meet is the pole of a motion that keeps both; what is added slips along the second.
    let [a, b] = [touches[0], touches[1]];
    let across = a.normal.cross(b.normal);
    let pole = a.arm + a.normal * ((b.arm - a.arm).cross(b.normal) / across);
    let spin = [-1.0, 1.0][rng.random_range(0..2)];
    let strikes = [0.0, rng.random_range(0.0..0.5)][rng.random_range(0..2)];
    let along = b.normal.turned_right() * strikes;
    let into = if along.dot(a.normal) > 0.0 { along * -1.0 } else { along };
    let velocity = into - pole.turned_left() * spin;
    let mut set =
        ContactSet6::of_free_body(1.0, rng.random_range(0.02..0.5), velocity, spin, &touches).ok()?;
    set.snap(1e-13);
    let sinks = |i: usize, j: usize| {
        let b = &set.operator[i][j];
        b.nn - set.slip[j].signum() * set.friction[j] * b.nt < -0.01
    };
    let driven = (0..2).all(|i| (0..2).all(|j| sinks(i, j))) && set.normal[0] <= 0.0 && set.normal[1] == 0.0;
    (driven && (set.count == 2 || set.normal[2] < 0.0)).then_some(set)
}

#[test]
fn a_body_on_two_such_contacts_is_never_jammed() {
    let mut rng = Pcg64::seed_from_u64(66);
    let (mut bodies, mut together, mut shared) = (0, 0, 0);
    while bodies < 2000 {
        let Some(set) = drawn(&mut rng) else { continue };
        bodies += 1;
        let out =
            staged::resolve(&set, Law::Poisson).unwrap_or_else(|e| panic!("body {bodies}: {e}: {set:?}"));
        assert!(work(&out) < 0.0, "body {bodies} loses energy: {out:?}");
        for i in 0..set.count {
            let ([q, p], [_, u]) = (out.impulse[i], out.velocity[i]);
            assert!(p >= 0.0 && u >= 0.0, "body {bodies}: contact {i} pushes and keeps out: {out:?}");
            assert!(
                q.abs() <= set.friction[i] * p * (1.0 + ROUNDING),
                "body {bodies}: contact {i} in its cone: {out:?}"
            );
        }
        let ends = end_states::enumerate(&set, Law::Poisson);
        together += usize::from(
            ends.found.iter().any(|end| drift(&set, &out.velocity, &end.velocity, &end.impulse) < ROUNDING),
        );
        let other = staged::resolve(&measured(&set, [2.0, 1.0, 1.0, 1.0, 1.0, 1.0]), Law::Poisson).unwrap();
        let mut velocity = other.velocity;
        velocity[0] = velocity[0].map(|u| u / 2.0);
        shared += usize::from(drift(&set, &velocity, &out.velocity, &out.impulse) < ROUNDING);
    }
    println!(
        "of {bodies} bodies {together} end in a state that is consistent at the end, {shared} whatever the share"
    );
    assert!(together > bodies / 2 && shared > bodies / 2, "{together} {shared}");
}
