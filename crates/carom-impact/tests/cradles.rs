//! Newton's cradle without friction, two to five balls, under every convention on sharing.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use carom_impact::Law;
use carom_impact::planar::sharing::{self, Sharing};
use carom_impact::planar::{ContactSet6, Meeting, RigidBody, struck};
use carom_num::Vec2;
use carom_num::elementary::pow;

/// Some ten roundings of velocities of order one.
const ROUNDING: f64 = 1e-14;

/// Equal balls of 1 kg and radius 1 m in a row; the first strikes with 1 m/s.
fn cradle(balls: u32, restitution: f64) -> (Vec<RigidBody>, Vec<Meeting>) {
    let ball = |i: u32| RigidBody {
        mass: 1.0,
        inertia: 0.4,
        centre: Vec2::new(2.0 * f64::from(i), 0.0),
        velocity: Vec2::new(if i == 0 { 1.0 } else { 0.0 }, 0.0),
        spin: 0.0,
    };
    let meeting = |i: u32| Meeting {
        into: i as usize + 1,
        out_of: i as usize,
        point: Vec2::new(2.0 * f64::from(i) + 1.0, 0.0),
        normal: Vec2::new(1.0, 0.0),
        friction: 0.0,
        restitution,
    };
    ((0..balls).map(ball).collect(), (0..balls - 1).map(meeting).collect())
}

/// Velocities of the balls after.
fn velocities(balls: u32, restitution: f64, sharing: &Sharing<6>) -> Vec<f64> {
    let (bodies, meetings) = cradle(balls, restitution);
    let set = ContactSet6::of_bodies(&bodies, &meetings).unwrap();
    let out = sharing::resolve(&set, Law::Poisson, sharing).unwrap();
    struck(&bodies, &meetings, &out.impulse).unwrap().iter().map(|b| b.velocity.x).collect()
}

/// The same balls with springs `F = δ^exponent` between them, by small steps in time: an independent program (velocity Verlet).
fn springs_in_time(balls: u32, exponent: f64) -> Vec<f64> {
    let n = balls as usize;
    let (mut x, mut v) = (vec![0.0; n], vec![0.0; n]);
    v[0] = 1.0;
    let force = |x: &[f64]| {
        let mut f = vec![0.0; n];
        for i in 0..n - 1 {
            let squeezed: f64 = x[i] - x[i + 1];
            if squeezed > 0.0 {
                let p = pow(squeezed, exponent);
                f[i] -= p;
                f[i + 1] += p;
            }
        }
        f
    };
    let (step, mut f) = (2e-4, force(&x));
    for _ in 0..200_000 {
        for i in 0..n {
            v[i] += 0.5 * step * f[i];
            x[i] += step * v[i];
        }
        f = force(&x);
        for i in 0..n {
            v[i] += 0.5 * step * f[i];
        }
    }
    v
}

fn assert_near(ours: &[f64], theirs: &[f64], close: f64, what: &str) {
    println!("{what}: {ours:.6?}");
    for (a, b) in ours.iter().zip(theirs) {
        assert!((a - b).abs() < close, "{what}: {ours:?} is not {theirs:?}");
    }
}

#[test]
fn together_all_but_the_first_leave_alike() {
    // Simultaneous Poisson (Glocker and Pfeiffer): v₁ = (1 + e)/n − e, the others (1 + e)/n.
    for balls in 2..=5_u32 {
        for e in [1.0, 0.6] {
            let share = (1.0 + e) / f64::from(balls);
            let theirs: Vec<f64> = (0..balls).map(|i| if i == 0 { share - e } else { share }).collect();
            let ours = velocities(balls, e, &Sharing::Together);
            assert_near(&ours, &theirs, ROUNDING, &format!("together, {balls} balls, e = {e}"));
        }
    }
}

#[test]
fn in_sequence_the_last_leaves_with_all() {
    for balls in 2..=5_u32 {
        let theirs: Vec<f64> = (0..balls).map(|i| if i + 1 == balls { 1.0 } else { 0.0 }).collect();
        let ours = velocities(balls, 1.0, &Sharing::InSequence);
        assert_near(&ours, &theirs, ROUNDING, &format!("in sequence, {balls} balls, e = 1"));
    }
    // Each ball keeps (1 − e)/2 of what it was given and passes on (1 + e)/2: 0.2, 0.16, 0.128, 0.512. The first catches up with the second
    // (0.168, 0.192), the second with the third (0.1408, 0.1792), and the first with the second once more.
    let ours = velocities(4, 0.6, &Sharing::InSequence);
    assert_near(&ours, &[0.14624, 0.16256, 0.1792, 0.512], ROUNDING, "in sequence, 4 balls, e = 0.6");
}

#[test]
fn by_stiffness_the_balls_move_as_springs_in_time_do() {
    for exponent in [1.0, 1.5] {
        for balls in 2..=5_u32 {
            let sharing = Sharing::ByStiffness { stiffness: [1.0; 6], exponent };
            let (ours, theirs) = (velocities(balls, 1.0, &sharing), springs_in_time(balls, exponent));
            let what = format!("equal springs of exponent {exponent}, {balls} balls");
            assert_near(&ours, &theirs, 1e-6, &what);
            let energy: f64 = ours.iter().map(|v| v * v).sum();
            assert!((energy - 1.0).abs() < 1e-9, "{what}: energy {energy}");
        }
    }
}

#[test]
fn every_reaches_what_the_conventions_say_of_a_cradle_without_restitution() {
    let (bodies, meetings) = cradle(4, 0.0);
    let set = ContactSet6::of_bodies(&bodies, &meetings).unwrap();
    let all = sharing::every(&set, 200).unwrap();
    let together = sharing::resolve(&set, Law::Poisson, &Sharing::Together).unwrap();
    println!("every, 4 balls, e = 0: {} outcomes", all.len());
    assert!(all.iter().any(|out| sharing::alike(&set, out, &together)), "{} outcomes", all.len());
    for out in &all {
        let v = struck(&bodies, &meetings, &out.impulse).unwrap();
        let momentum: f64 = v.iter().map(|b| b.velocity.x).sum();
        assert!((momentum - 1.0).abs() < ROUNDING, "{momentum}");
        assert!(v.windows(2).all(|w| w[0].velocity.x <= w[1].velocity.x + 1e-12), "{v:?}");
    }
}
