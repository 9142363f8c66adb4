//! Obstacles that move against each other: the load may go round for ever, and is then refused by name.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::obstacles;

use carom_impact::planar::{ContactSet6, Touch, staged};
use carom_impact::{ImpactError, Law};
use carom_num::Vec2;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::collections::BTreeMap;

const SETS: u32 = 4000;
/// Residuals against the sum of their terms.
const CLOSE: f64 = 1e-9;

#[test]
fn what_is_squeezed_between_a_floor_and_a_ceiling_is_jammed() {
    // Floor and ceiling approach each other with v₁ + v₂ whatever the ball does: no impulse lets both come to rest.
    let touch = |y: f64, friction: f64| Touch {
        arm: Vec2::new(0.0, y),
        normal: Vec2::new(0.0, -y.signum()),
        friction,
        restitution: 0.5,
    };
    let ball = |friction: f64, normal: [f64; 2]| {
        let touches = [touch(-1.0, friction), touch(1.0, friction)];
        let mut set = ContactSet6::of_free_body(1.0, 0.4, Vec2::new(0.3, 0.0), 0.2, &touches).unwrap();
        set.normal[..2].copy_from_slice(&normal);
        set
    };
    for law in [Law::Newton, Law::Poisson, Law::Stronge] {
        for normal in [[-1.0, -1.0], [-2.0, -0.5], [-1e-6, -3.0]] {
            for friction in [0.0, 0.4, 3.0] {
                let out = staged::resolve(&ball(friction, normal), law);
                assert_eq!(out, Err(ImpactError::Jammed), "{law:?} {normal:?} {friction}");
            }
        }
    }
    // A ceiling that goes away: nothing is squeezed.
    let out = staged::resolve(&ball(0.0, [-1.0, 2.0]), Law::Poisson).unwrap();
    assert_eq!(out.velocity[0][1], 0.5, "{out:?}");
    assert_eq!(out.velocity[1][1], 0.5, "{out:?}");
}

#[test]
fn rounds_that_stop_a_large_approach_by_little_are_passed_over() {
    // A block on two feet, mass centre 0.68 above them, rocks over from one to the other. Its feet slip by s against each other, as no
    // rigid ones do on rigid ground: each stops in turn and starts again, and a round takes some s of the approach.
    let foot = |x: f64| Touch {
        arm: Vec2::new(x, -0.68),
        normal: Vec2::new(0.0, 1.0),
        friction: 9.7,
        restitution: 0.6,
    };
    let outcome = |law: Law, apart: f64| {
        let mut set =
            ContactSet6::of_free_body(2.8, 1.37, Vec2::ZERO, 0.0, &[foot(-1.0), foot(1.0)]).unwrap();
        set.normal[..2].copy_from_slice(&[0.0, -1.0]);
        set.slip[..2].copy_from_slice(&[0.0, apart]);
        let mut stages = 0;
        let out = staged::resolve_observed(&set, law, &mut |_: &_| stages += 1).unwrap();
        assert!(stages < 200, "{law:?} {apart}: {stages} stages");
        let worst = residuals(&set, &out).into_iter().fold(0.0, f64::max);
        assert!(worst < 1e-10, "{law:?} {apart}: {worst:e}");
        out
    };
    for law in [Law::Poisson, Law::Stronge] {
        // Some 10⁹ rounds; one contact closes, so both laws agree but for terms of s.
        let limit = outcome(law, 1e-9);
        assert!((limit.velocity[1][1] - 0.6).abs() < 1e-8, "{law:?} {limit:?}");
        for apart in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
            let out = outcome(law, apart);
            for i in 0..2 {
                for axis in 0..2 {
                    let velocity = (out.velocity[i][axis] - limit.velocity[i][axis]).abs();
                    let impulse = (out.impulse[i][axis] - limit.impulse[i][axis]).abs();
                    assert!(velocity <= 10.0 * apart && impulse <= 10.0 * apart, "{law:?} {apart} {out:?}");
                }
            }
        }
    }
}

/// A body at two to four contacts, every obstacle with a velocity of its own.
fn random_set(rng: &mut Pcg64) -> ContactSet6 {
    let touches = obstacles::touches(rng);
    let velocity = Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
    let mut set =
        ContactSet6::of_free_body(1.0, rng.random_range(0.05..1.0), velocity, 0.5, &touches).unwrap();
    obstacles::let_move(rng, &mut set);
    set
}

/// What becomes of impacts, and the largest residual of each law where they are resolved.
#[derive(Default)]
struct Met {
    counts: BTreeMap<&'static str, u32>,
    worst: [f64; 4],
}

impl Met {
    fn take(&mut self, set: &ContactSet6, law: Law) {
        let mut stages: Vec<staged::Stage<6>> = vec![];
        let out = staged::resolve_observed(set, law, &mut |stage: &_| stages.push(*stage));
        let what = match &out {
            Ok(_) if stages.len() > 100 => "resolved in more than 100 stages",
            Ok(_) => "resolved",
            Err(ImpactError::Circling { stages: round }) => {
                circles(set, &stages[stages.len() - round - 1..]);
                "circling"
            }
            Err(ImpactError::Jammed) => "jammed",
            Err(ImpactError::Unending { .. }) => "unending",
            Err(error) => panic!("{error}: {set:?}"),
        };
        *self.counts.entry(what).or_default() += 1;
        if let Ok(out) = out {
            for pair in stages.windows(2) {
                assert_eq!(pair[0].end, pair[1].start, "a stage goes on where the last ended: {set:?}");
            }
            for (worst, here) in self.worst.iter_mut().zip(residuals(set, &out)) {
                assert!(here <= CLOSE, "{here:e} {set:?} {out:?}");
                *worst = worst.max(here);
            }
        }
    }

    fn and(mut self, other: &Self) -> Self {
        for (what, count) in &other.counts {
            *self.counts.entry(what).or_default() += count;
        }
        for (worst, here) in self.worst.iter_mut().zip(other.worst) {
            *worst = worst.max(here);
        }
        self
    }
}

#[test]
fn impacts_between_moving_obstacles_obey_every_law_or_are_refused_by_name() {
    let mut rng = Pcg64::seed_from_u64(5);
    let drawn: Vec<(ContactSet6, Law)> = (0..SETS)
        .map(|_| (random_set(&mut rng), [Law::Poisson, Law::Stronge][rng.random_range(0..2)]))
        .collect();
    let met = std::thread::scope(|scope| {
        let parts = drawn.chunks(drawn.len() / 4).map(|part| {
            scope.spawn(|| {
                let mut met = Met::default();
                part.iter().for_each(|(set, law)| met.take(set, *law));
                met
            })
        });
        let parts: Vec<_> = parts.collect();
        parts.into_iter().fold(Met::default(), |met, part| met.and(&part.join().unwrap()))
    });
    let (counts, worst) = (met.counts, met.worst);
    println!("{counts:?}; pull, cone, balance, work at most {worst:?}");
    assert!(counts["circling"] > 10, "{counts:?}");
    assert!(counts.get("unending").is_none_or(|n| *n <= SETS / 500), "{counts:?}");
}

/// A circle leads back to its velocities, with impulses that have grown, and takes no energy that the body would have.
fn circles(set: &ContactSet6, round: &[staged::Stage<6>]) {
    let (start, end) = (&round[0].end, &round[round.len() - 1].end);
    let speed = start.velocity.iter().flatten().fold(0.0, |m: f64, u| m.max(u.abs()));
    let mut grown = 0.0;
    for i in 0..set.count {
        for axis in 0..2 {
            let off = (end.velocity[i][axis] - start.velocity[i][axis]).abs();
            assert!(off <= 1e-9 * speed, "{off:e} {speed:e} {set:?}");
        }
        grown += end.impulse[i][1] - start.impulse[i][1];
    }
    assert!(grown > 0.0, "{grown:e} {set:?}");
}

/// Of pushing and not approaching, of Coulomb's cone, of the balance `u⁺ = u⁻ + W p`, and of the work, whose sum is `½ (u⁻ + u⁺)ᵀ p`
/// however the impulse came about, W being symmetric.
fn residuals(set: &ContactSet6, out: &staged::StagedOutcome<6>) -> [f64; 4] {
    let n = set.count;
    let push: f64 = out.impulse[..n].iter().flatten().map(|p| p.abs()).sum();
    let entry = set.operator[..n].iter().flatten().fold(0.0, |m: f64, b| m.max(b.tt).max(b.nn));
    let before = set.slip[..n].iter().chain(&set.normal[..n]);
    let speed: f64 = before.chain(out.velocity[..n].iter().flatten()).map(|u| u.abs()).sum();
    if push == 0.0 {
        return [0.0; 4];
    }
    let scale = speed + entry * push;
    let [mut pull, mut cone, mut balance, mut work, mut size] = [0.0_f64; 5];
    for i in 0..n {
        let ([q, p], u) = (out.impulse[i], out.velocity[i]);
        let was = [set.slip[i], set.normal[i]];
        pull = pull.max(-p / push);
        cone = cone.max((q.abs() - set.friction[i] * p) / (push * (1.0 + set.friction[i])));
        let mut now = was;
        for (b, [q, p]) in set.operator[i].iter().zip(&out.impulse).take(n) {
            now[0] += b.tt * q + b.tn * p;
            now[1] += b.nt * q + b.nn * p;
        }
        for axis in 0..2 {
            let mean = 0.5 * (was[axis] + u[axis]) * out.impulse[i][axis];
            work += out.work[i][axis] - mean;
            size += out.work[i][axis].abs() + mean.abs();
            balance = balance.max((now[axis] - u[axis]).abs() / scale);
        }
        if was[1] <= 0.0 {
            pull = pull.max(-u[1] / scale);
        }
    }
    // Works of single stages may be larger than their sums.
    [pull, cone, balance, work.abs() / (size + scale * push)]
}
