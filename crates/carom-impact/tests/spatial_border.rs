//! Impacts that steps of a walk come to the end of only where they are told what is rounding: friction that is just about what holds a contact, and feet that come
//! down while others slide, slowly beside what they slide.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_impact::Law;
use carom_impact::spatial::{Contact, ContactSet, Preference, RigidBody, Touch, staged};
use carom_num::{Mat3, Rotation, Vec3};
use random::numbers;

/// The friction by which it is off what would hold the contact, relatively: the border itself in the middle.
const OFF: [f64; 13] = [-1e-2, -1e-3, -1e-4, -1e-6, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2];

/// A random body that strikes with one contact, and the friction that would just hold it.
fn random_strike(case: u32) -> (RigidBody, Touch, f64) {
    let random = numbers(case);
    let vector =
        |k: usize| Vec3::new(random(k), random(k + 1), random(k + 2)) * 2.0 - Vec3::new(1.0, 1.0, 1.0);
    let turned = Rotation::by(vector(3) * 3.0);
    let mut velocity = vector(6);
    velocity.z = -velocity.z.abs() - 0.05;
    let [a, b] = [0.3 + random(0), 0.3 + random(1)];
    let third = (a - b).abs() + (a + b - (a - b).abs()) * (0.05 + 0.9 * random(2));
    let body = RigidBody {
        mass: 0.5 + random(9),
        inertia: turned.turn(Mat3::diagonal(a, b, third)) * 0.3,
        velocity,
        spin: Vec3::ZERO,
    };
    let touch = Touch { arm: vector(10), normal: Vec3::Z, friction: 0.0, restitution: random(14) };
    let set = ContactSet::<1>::of_free_body(&body, &[touch]).unwrap();
    let [x, y, _] = set.operator[0][0].rows;
    let determinant = x.x * y.y - x.y * y.x;
    let held = [x.y * y.z - y.y * x.z, y.x * x.z - x.x * y.z].map(|p| p / determinant);
    (body, touch, (held[0] * held[0] + held[1] * held[1]).sqrt())
}

#[test]
fn friction_that_just_about_holds_leads_to_an_outcome() {
    let (mut apart, mut jump): (f64, f64) = (0.0, 0.0);
    for case in 0..400 {
        let (body, touch, held) = random_strike(case);
        let outcomes = OFF.map(|off| {
            let touch = Touch { friction: held * (1.0 + off), ..touch };
            let set = ContactSet::<1>::of_free_body(&body, &[touch]).unwrap();
            let one = Contact {
                operator: set.operator[0][0],
                velocity: set.velocity[0],
                friction: touch.friction,
                restitution: touch.restitution,
            };
            let alone = one.resolve(Law::Poisson).unwrap_or_else(|e| panic!("{case}, {off:e}: {e:?}"));
            let walked =
                staged::resolve(&set, Law::Poisson).unwrap_or_else(|e| panic!("{case}, {off:e}: {e:?}"));
            let size = set.velocity[0].norm();
            apart = apart.max((alone.velocity - walked.velocity[0]).norm() / size);
            alone.velocity * (1.0 / size)
        });
        // An outcome that hangs on friction does so steadily.
        let middle = outcomes[6];
        for (off, outcome) in OFF.iter().zip(outcomes).filter(|(off, _)| off.abs() <= 1e-9) {
            jump = jump.max((outcome - middle).norm() - 100.0 * off.abs());
        }
    }
    println!("both walks apart {apart:.1e}, a jump of {jump:.1e}");
    assert!(apart < 1e-11 && jump < 1e-11, "{apart:e} {jump:e}");
}

/// A die of 12 × 12 × 9.72 mm that slides on two corners while two more come down, at 10⁻⁷ of its speed: how four feet share a load hangs on rounding, and their
/// rates are known to 10⁻¹⁰ only.
#[test]
fn feet_that_come_down_slowly_are_stopped() {
    let lines = include_str!("four_feet.txt").lines().filter(|line| !line.starts_with('#'));
    let rows: Vec<Vec<f64>> = lines.map(|l| l.split(' ').map(|x| x.parse().unwrap()).collect()).collect();
    let vector = |v: &[f64]| Vec3::new(v[0], v[1], v[2]);
    let block = |v: &[f64]| Mat3 { rows: [vector(v), vector(&v[3..]), vector(&v[6..])] };
    let identity = Mat3::diagonal(1.0, 1.0, 1.0);
    let set = ContactSet::<4> {
        count: 4,
        frame: [identity; 4],
        velocity: std::array::from_fn(|i| vector(&rows[i])),
        operator: std::array::from_fn(|i| std::array::from_fn(|j| block(&rows[4 + 4 * i + j]))),
        friction: [0.3; 4],
        restitution: [0.3; 4],
    };
    for preference in [Preference::MostKept, Preference::MostOpen] {
        let out = staged::resolve_preferring(&set, Law::Poisson, preference).unwrap();
        let lowest = out.velocity.iter().map(|u| u.z).fold(f64::INFINITY, f64::min);
        let moved = out.velocity.iter().zip(set.velocity).map(|(after, before)| (*after - before).norm());
        let moved = moved.fold(0.0, f64::max);
        println!("{preference:?}: lowest {lowest:.1e} m/s, slips changed by {moved:.1e} m/s");
        assert!(lowest > -1e-15 && moved < 1e-6, "{preference:?}: {lowest:e} {moved:e}");
    }
}
