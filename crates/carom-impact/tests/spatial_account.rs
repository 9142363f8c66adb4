//! Bodies that are caught between surfaces in space: what comes out is what the impulses make of what went in.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use carom_impact::Law;
use carom_impact::spatial::{ContactSet, RigidBody, StagedOutcome, Touch, staged};
use carom_num::{Mat3, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Slips below this share of the fastest motion a walk takes from their own equations: by so much a velocity may differ from what its impulses make of it.
const BALANCES: f64 = 1e-6;

/// Two or three surfaces about a body, rough ones, half of them nearly opposite each other.
fn caught(seed: u64) -> (ContactSet<3>, Law) {
    let mut random = Pcg64::seed_from_u64(seed);
    let mut number = |low: f64, high: f64| random.random_range(low..high);
    let count = if number(0.0, 1.0) < 0.6 { 2 } else { 3 };
    let inertia = Mat3::diagonal(number(0.1, 0.2), number(0.1, 0.2), number(0.1, 0.2));
    let mut vector = |size: f64| Vec3::new(number(-size, size), number(-size, size), number(-size, size));
    let (velocity, spin, along) = (vector(1.0), vector(1.0), vector(1.0).unit().unwrap());
    let (spread, opposite) = (number(0.0, 0.3), number(0.0, 1.0) < 0.5);
    let touches: Vec<Touch> = (0..count)
        .map(|i| {
            let aside = Vec3::new(number(-1.0, 1.0), number(-1.0, 1.0), number(-1.0, 1.0));
            let side = if i % 2 == 0 { 1.0 } else { -1.0 };
            let normal = if opposite { along * side + aside * spread } else { aside }.unit().unwrap();
            let reach = number(0.3, 1.0);
            let off = Vec3::new(number(-0.3, 0.3), number(-0.3, 0.3), number(-0.3, 0.3));
            let friction = number(0.5, 3.0);
            let restitution = if number(0.0, 1.0) < 0.5 { 0.0 } else { number(0.0, 1.0) };
            Touch { arm: off - normal * reach, normal, friction, restitution }
        })
        .collect();
    let law = if number(0.0, 1.0) < 0.5 { Law::Poisson } else { Law::Stronge };
    let body = RigidBody { mass: 1.0, inertia, velocity, spin };
    (ContactSet::of_free_body(&body, &touches).unwrap(), law)
}

/// By how much `u⁺ = u⁻ + W p` and the work `½ (u⁻ + u⁺) · p` are open, as shares of their terms.
fn open(set: &ContactSet<3>, out: &StagedOutcome<3>) -> [f64; 2] {
    let fastest = set.velocity.iter().map(|u| u.norm()).fold(0.0, f64::max);
    let (mut balance, mut work, mut works) = (0.0_f64, 0.0, f64::MIN_POSITIVE);
    for i in 0..set.count {
        let (mut made, mut size) = (set.velocity[i], fastest);
        for j in 0..set.count {
            let by = set.operator[i][j] * out.impulse[j];
            made += by;
            size += set.operator[i][j].rows.iter().map(|row| row.norm()).fold(0.0, f64::max)
                * out.impulse[j].norm();
        }
        balance = balance.max((made - out.velocity[i]).norm() / size);
        let mean = (set.velocity[i] + out.velocity[i]) * 0.5;
        work += mean.dot(out.impulse[i]);
        works += mean.norm() * out.impulse[i].norm();
    }
    [balance, (work - out.total_work()).abs() / works]
}

#[test]
fn what_comes_out_is_what_the_impulses_make_of_what_went_in() {
    let (mut resolved, mut refused, mut worst) = (0, 0, [0.0_f64; 2]);
    // Among these are bodies whose slips start and stop at once, of which a walk loses what they have moved by.
    for seed in (1400..1460).chain(2250..2270).chain(4390..4420) {
        let (set, law) = caught(seed);
        let Ok(out) = staged::resolve(&set, law) else {
            refused += 1;
            continue;
        };
        let [balance, work] = open(&set, &out);
        assert!(balance < BALANCES, "seed {seed}: velocities are open by {balance:e}: {out:?}");
        assert!(work < BALANCES, "seed {seed}: works are open by {work:e}: {out:?}");
        worst = [worst[0].max(balance), worst[1].max(work)];
        resolved += 1;
    }
    println!("{resolved} resolved, open by {worst:?} at most; {refused} refused");
    assert!(refused * 20 < resolved, "{refused} of {resolved} are refused");
}
