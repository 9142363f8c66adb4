use super::super::staged;
use super::super::walk::Walk;
use super::*;
use crate::Law;
use crate::planar::contacts::names::StageEnd;
use crate::planar::contacts::set::ContactSet6;
use crate::planar::contacts::set::Touch;
use carom_num::Vec2;
use carom_num::solve::solve_regular;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Impulses against the largest of a stage.
const SAME: f64 = 1e-7;
/// Equations that contradict each other by less than this fraction agree.
const CONTRADICTION: f64 = 1e-9;

struct Body {
    mass: f64,
    inertia: f64,
    velocity: Vec2,
    spin: f64,
    touches: [Touch; 3],
}

impl Body {
    fn set(&self) -> ContactSet6 {
        ContactSet6::of_free_body(self.mass, self.inertia, self.velocity, self.spin, &self.touches).unwrap()
    }

    /// What a unit of the tangential and of the normal impulse of contact i does to the three momenta of the body.
    fn columns(&self, i: usize) -> [[f64; 3]; 2] {
        let Touch { arm, normal, .. } = self.touches[i];
        [normal.turned_right(), normal].map(|d| [d.x, d.y, arm.cross(d)])
    }

    /// Velocity and spin after these impulses.
    fn after(&self, impulse: &[[f64; 2]]) -> [f64; 3] {
        let mut momentum = [0.0; 3];
        for (i, [q, p]) in impulse.iter().enumerate().take(3) {
            let [t, n] = self.columns(i);
            (0..3).for_each(|k| momentum[k] += t[k] * q + n[k] * p);
        }
        let velocity = self.velocity + Vec2::new(momentum[0], momentum[1]) / self.mass;
        [velocity.x, velocity.y, self.spin + momentum[2] / self.inertia]
    }
}

/// Three contacts that close, with restitution; the body of seed 1 is the one of the first test.
fn random(seed: u64) -> Body {
    let mut rng = Pcg64::seed_from_u64(seed);
    let touches = std::array::from_fn(|_| {
        let (around, lean) = (rng.random_range(0.0..6.2), rng.random_range(-0.9..0.9));
        let arm = Vec2::at_angle(around) * rng.random_range(0.5..1.0);
        let (friction, restitution) = (rng.random_range(0.0..1.0), rng.random_range(0.0..0.9));
        Touch { arm, normal: -Vec2::at_angle(around + lean), friction, restitution }
    });
    let mut number = |m: f64| rng.random_range(-m..m);
    let velocity = Vec2::new(number(1.5), number(1.5));
    Body { mass: 1.0, inertia: 0.3 + number(0.1), velocity, spin: number(0.5), touches }
}

/// A stage of compression as its motion shows it: nothing is asked of the walk's impulses.
struct Seen {
    /// Coefficients of the impulses in the momenta, and which contact's normal impulse each of them is.
    columns: Vec<[f64; 3]>,
    normal: Vec<Option<usize>>,
    /// Inequalities `row · x ≥ 0`.
    rows: Vec<Vec<f64>>,
    momentum: [f64; 3],
}

impl Seen {
    fn new(body: &Body, stage: &staged::Stage<6>) -> Self {
        let zero = |u: f64| u.abs() < 1e-12;
        let (mut columns, mut normal, mut sides) = (vec![], vec![], vec![]);
        for i in 0..3 {
            let ([slip, u_n], [slip_end, end]) = (stage.start.velocity[i], stage.end.velocity[i]);
            // The drive takes every touching contact's approach away at the same rate; one that leaves transmits nothing.
            let closing = (0..3).filter(|&j| stage.start.velocity[j][1] < -1e-12);
            let left =
                closing.map(|j| stage.end.velocity[j][1] / stage.start.velocity[j][1]).fold(0.0, f64::max);
            if u_n > 0.0 || (end - left * u_n).abs() > 1e-9 {
                continue;
            }
            let [t, n] = body.columns(i);
            let friction = body.touches[i].friction;
            if zero(slip) && zero(slip_end) {
                sides.push((columns.len(), Some(columns.len() + 1), friction));
                columns.extend([n, t]);
                normal.extend([Some(i), None]);
            } else {
                let along = -friction * if zero(slip) { slip_end } else { slip }.signum();
                sides.push((columns.len(), None, 0.0));
                columns.push(std::array::from_fn(|k| n[k] + along * t[k]));
                normal.push(Some(i));
            }
        }
        let mut rows = vec![];
        for (n, t, friction) in sides {
            let row = |normal: f64, tangential: f64| {
                let mut row = vec![0.0; columns.len()];
                row[n] = normal;
                t.into_iter().for_each(|t| row[t] = tangential);
                row
            };
            match t {
                Some(_) => rows.extend([row(friction, 1.0), row(friction, -1.0)]),
                None => rows.push(row(1.0, 0.0)),
            }
        }
        let [before, after] = [&stage.start, &stage.end].map(|station| body.after(&station.impulse));
        let masses = [body.mass, body.mass, body.inertia];
        let momentum = std::array::from_fn(|k| masses[k] * (after[k] - before[k]));
        Self { columns, normal, rows, momentum }
    }

    /// Every vertex of the impulses that bring this momentum: some of the inequalities hold with equality, and nothing is left open. Of
    /// impulses that bring none the sum of the normal ones is 1.
    fn vertices(&self, momentum: [f64; 3]) -> Vec<[f64; 6]> {
        let n = self.columns.len();
        let brings_none = momentum == [0.0; 3];
        let mut found = vec![];
        for mask in 0..1_u32 << self.rows.len() {
            let mut equations: Vec<(Vec<f64>, f64)> = (0..3)
                .map(|k| (self.columns.iter().map(|column| column[k]).collect(), momentum[k]))
                .collect();
            if brings_none {
                equations
                    .push((self.normal.iter().map(|of| f64::from(u8::from(of.is_some()))).collect(), 1.0));
            }
            let at_equality = (0..self.rows.len()).filter(|k| mask >> k & 1 == 1);
            equations.extend(at_equality.map(|k| (self.rows[k].clone(), 0.0)));
            // As least squares: more equations than unknowns may agree.
            let (mut a, mut b) = ([[0.0; 6]; 6], [0.0; 6]);
            for (row, right) in &equations {
                for i in 0..n {
                    (0..n).for_each(|j| a[i][j] += row[i] * row[j]);
                    b[i] += row[i] * right;
                }
            }
            let Some(x) = solve_regular(a, b, n, 1e-9) else { continue };
            let size = x[..n].iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            let value = |row: &Vec<f64>| row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>();
            let holds =
                equations.iter().all(|(row, right)| (value(row) - right).abs() <= CONTRADICTION * size);
            if holds && self.rows.iter().all(|row| value(row) >= -CONTRADICTION * size) {
                found.push(x);
            }
        }
        found
    }

    /// The least and the largest normal impulse of contact i; the largest is without bound where contacts wedge the body.
    fn range(&self, i: usize) -> [f64; 2] {
        let Some(place) = self.normal.iter().position(|of| *of == Some(i)) else { return [0.0; 2] };
        let vertices = self.vertices(self.momentum);
        let least = vertices.iter().map(|x| x[place]).fold(f64::INFINITY, f64::min);
        let most = vertices.iter().map(|x| x[place]).fold(f64::NEG_INFINITY, f64::max);
        let wedged = self.vertices([0.0; 3]).iter().any(|x| x[place] > 1e-9);
        [least, if wedged { f64::INFINITY } else { most }]
    }
}

/// Impulses at the end of compression.
fn compressed(set: &ContactSet6, share: Share) -> Option<(Walk<'_, 6, 12>, Vec<staged::Stage<6>>)> {
    let mut stages = vec![];
    let mut walk = Walk::new(set);
    walk.share = share;
    walk.compress(&mut |stage| stages.push(*stage)).ok()?;
    Some((walk, stages))
}

#[test]
fn the_ends_are_those_of_every_set_of_impulses_that_gives_the_motion() {
    let (mut open, mut ends, mut wedged, mut several) = (0, 0, 0, 0);
    for seed in 0..1500 {
        let body = random(seed);
        let set = body.set();
        let Some((walk, stages)) = compressed(&set, Share::Middle) else { continue };
        if walk.branches > 1 || stages.iter().any(|stage| stage.ended_by == StageEnd::RestitutionEnds) {
            continue;
        }
        several += usize::from(stages.len() > 1);
        let seen: Vec<Seen> = stages.iter().map(|stage| Seen::new(&body, stage)).collect();
        let size = walk.now.impulse.iter().flatten().fold(0.0, |m: f64, p| m.max(p.abs()));
        for i in 0..3 {
            if !walk.open[i] {
                let closed = seen.iter().map(|s| s.range(i)).all(|[least, most]| most - least <= SAME * size);
                assert!(closed, "{seed}: the share of contact {i} is open, and nothing says so");
                continue;
            }
            open += 1;
            for (k, share) in [Share::Least(i), Share::Most(i)].into_iter().enumerate() {
                let ours = compressed(&set, share).unwrap().0.now;
                // The motion is that of every share.
                let moved = ours.velocity.iter().flatten().zip(walk.now.velocity.iter().flatten());
                assert!(
                    moved.clone().all(|(u, v)| (u - v).abs() < 1e-9),
                    "{seed}: {share:?} moves otherwise"
                );
                let total: f64 = seen.iter().map(|s| s.range(i)[k]).sum();
                let size = ours.impulse.iter().flatten().fold(0.0, |m: f64, p| m.max(p.abs()));
                // Where nothing bounds the largest, the walk takes some more than it must.
                if total == f64::INFINITY {
                    wedged += 1;
                    continue;
                }
                ends += 1;
                let off = (ours.impulse[i][1] - total).abs();
                assert!(off <= SAME * size, "{seed}: {share:?} {} against {total}", ours.impulse[i][1]);
            }
        }
    }
    assert!(
        open > 100 && ends > 2 * open - wedged - 1 && several > 500,
        "{open} open, {ends} ends compared, {wedged} without bound, {several} walks of several stages"
    );
}

#[test]
fn a_share_that_is_open_leaves_a_range_of_motions() {
    let touch = |x, y, normal_x, normal_y, friction, restitution| Touch {
        arm: Vec2::new(x, y),
        normal: Vec2::new(normal_x, normal_y),
        friction,
        restitution,
    };
    let touches = [
        touch(
            0.8032808772648747,
            0.5692943658393117,
            -0.8488931249488,
            -0.5285645300383494,
            0.7458036012342893,
            0.6258807679737234,
        ),
        touch(
            -0.9971720027403428,
            0.036780201020549345,
            0.8577632972286328,
            -0.5140448676209736,
            0.07488900233497382,
            0.1627610472177513,
        ),
        touch(
            0.9187540269144698,
            0.09109346904880782,
            -0.36251373102784945,
            -0.9319784304458274,
            0.20276190494231788,
            0.0,
        ),
    ];
    let velocity = Vec2::new(-0.13605137254469815, 1.2151866213960754);
    let body = Body { mass: 1.0, inertia: 0.2435755734797961, velocity, spin: 0.487069561624211, touches };
    let set = body.set();
    let taken = staged::resolve(&set, Law::Poisson).unwrap();
    assert_eq!(taken.open_share, [true, true, false, false, false, false], "contacts that return something");
    // Source: an independent enumeration of the impulses that stop the body, to five digits.
    let expected = [[-0.25886, -0.31383, 0.13185], [-0.28579, -0.34326, 0.14279]];
    let found = outcomes(&set, Law::Poisson).unwrap();
    assert_eq!(found.len(), 2, "two ends of a line of shares");
    for ((share, out), expected) in found.iter().zip(expected) {
        let after = body.after(&out.impulse);
        assert!(
            after.iter().zip(expected).all(|(a, b)| (a - b).abs() < 6e-6),
            "{share:?}: {after:?} {expected:?}"
        );
    }
    // What is taken lies between.
    let (taken, first, last) =
        (body.after(&taken.impulse), body.after(&found[0].1.impulse), body.after(&found[1].1.impulse));
    assert!((0..3).all(|k| (taken[k] - first[k]) * (taken[k] - last[k]) < 0.0), "{taken:?}");
}
