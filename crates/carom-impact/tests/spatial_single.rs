//! One contact with friction in space: worked numbers, limits and laws.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_impact::Law;
use carom_impact::planar;
use carom_impact::spatial::{Contact, ContactSet, RigidBody, Slip, Touch};
use carom_num::{Mat3, Rotation, Vec3};
use random::numbers;

/// What the independent integration is known to [N s, m/s].
const INTEGRATED: f64 = 1e-8;
/// A walk of some hundred steps, each with the rounding of its velocities.
const ROUNDING: f64 = 1e-12;

/// A random contact of a random body.
fn random_contact(case: u32) -> Contact {
    let random = numbers(case);
    let vector =
        |k: usize| Vec3::new(random(k), random(k + 1), random(k + 2)) * 2.0 - Vec3::new(1.0, 1.0, 1.0);
    let [a, b] = [0.3 + random(0), 0.3 + random(1)];
    let third = (a - b).abs() + (a + b - (a - b).abs()) * (0.05 + 0.9 * random(2));
    let turned = Rotation::by(vector(3) * 3.0);
    let mut velocity = vector(6);
    velocity.z = -velocity.z.abs() - 0.05;
    let body = RigidBody {
        mass: 0.5 + random(9),
        inertia: turned.turn(Mat3::diagonal(a, b, third)) * 0.3,
        velocity,
        spin: Vec3::ZERO,
    };
    let touch =
        Touch { arm: vector(10), normal: Vec3::Z, friction: 1.5 * random(13), restitution: random(14) };
    let set = ContactSet::<1>::of_free_body(&body, &[touch]).unwrap();
    Contact {
        operator: set.operator[0][0],
        velocity: set.velocity[0],
        friction: touch.friction,
        restitution: touch.restitution,
    }
}

/// The contact with its tangent axes turned by an angle.
fn turned(c: &Contact, angle: f64) -> Contact {
    let about = Rotation::by(Vec3::Z * angle);
    Contact { operator: about.turn(c.operator), velocity: about.apply(c.velocity), ..*c }
}

/// A cube of edge 0.2 m and 1 kg that turns about one corner strikes with a second: the first one is let go.
#[test]
fn a_spinning_cube_strikes_as_an_independent_integration_says() {
    let centre = Vec3::new(-0.139_069_480_670_103_6, -0.020_258_199_379_466_105, 0.101_238_751_987_810_93);
    let corner = Vec3::new(-0.120_568_168_235_857_76, -0.159_572_292_604_679_9, 0.0);
    let spin = Vec3::new(0.341_575_856_878_327_8, -2.609_971_720_628_026_4, 1.922_479_739_356_104);
    let third = 0.02 / 3.0;
    let body = RigidBody {
        mass: 1.0,
        inertia: Mat3::diagonal(third, third, third),
        velocity: spin.cross(centre),
        spin,
    };
    let cases = [
        (0.3, 0.107_752_156_864_049_38, [0.233_917_504_888_383_78, -0.404_129_618_137_427_4]),
        (0.6, 0.130_413_050_645_522_36, [0.133_506_356_487_070_68, -0.358_552_118_422_110_54]),
    ];
    for (friction, impulse, slip) in cases {
        let touch = Touch { arm: corner - centre, normal: Vec3::Z, friction, restitution: 0.0 };
        let set = ContactSet::<1>::of_free_body(&body, &[touch]).unwrap();
        let contact =
            Contact { operator: set.operator[0][0], velocity: set.velocity[0], friction, restitution: 0.0 };
        let out = contact.resolve(Law::Poisson).unwrap();
        let world = set.frame[0].transposed() * out.velocity;
        println!("mu {friction}: N {:.14} slip {:.14} {:.14}", out.impulse.z, world.x, world.y);
        assert!((out.impulse.z - impulse).abs() < INTEGRATED, "{out:?}");
        assert!((world.x - slip[0]).abs() < INTEGRATED && (world.y - slip[1]).abs() < INTEGRATED, "{out:?}");
    }
    // Rough enough it stops slipping before the end of compression, and takes this much until then.
    let touch = Touch { arm: corner - centre, normal: Vec3::Z, friction: 1.5, restitution: 0.0 };
    let set = ContactSet::<1>::of_free_body(&body, &[touch]).unwrap();
    let contact =
        Contact { operator: set.operator[0][0], velocity: set.velocity[0], friction: 1.5, restitution: 0.0 };
    let first = contact.resolve(Law::Poisson).unwrap().stages[0];
    println!("mu 1.5: stops at N {:.14}, u_n {:.14}", first.impulse.z, first.velocity.z);
    assert!((first.impulse.z - 0.180_107_910_487_578_9).abs() < INTEGRATED, "{first:?}");
    assert!((first.velocity.z + 0.206_014_590_684_272_08).abs() < INTEGRATED, "{first:?}");
}

#[test]
fn friction_and_restitution_never_add_energy_under_poisson_and_stronge() {
    let mut stages = [0; 3];
    let mut greatest = f64::NEG_INFINITY;
    for case in 0..20_000 {
        let contact = random_contact(case);
        let energy = |v: Vec3| 0.5 * v.dot(contact.operator.inverse().unwrap() * v);
        for law in [Law::Poisson, Law::Stronge] {
            let out = contact.resolve(law).unwrap();
            let gained = (energy(out.velocity) - energy(contact.velocity)) / energy(contact.velocity);
            greatest = greatest.max(gained);
            assert!(gained <= ROUNDING, "{law:?} {contact:?} {out:?}");
            assert!(out.velocity.z >= -ROUNDING, "{law:?} {contact:?} {out:?}");
            let balance = out.velocity - contact.velocity - contact.operator * out.impulse;
            assert!(
                balance.norm() < ROUNDING * (1.0 + contact.operator.rows[2].norm()),
                "{balance:?} {contact:?}"
            );
            let tangential = (out.impulse.x * out.impulse.x + out.impulse.y * out.impulse.y).sqrt();
            assert!(tangential <= (1.0 + ROUNDING) * contact.friction * out.impulse.z, "{contact:?} {out:?}");
            for stage in &out.stages {
                stages[match stage.slip {
                    Slip::Slips => 0,
                    Slip::Sticks => 1,
                    Slip::SlipsOn => 2,
                }] += 1;
            }
        }
    }
    println!("stages that slip, stick, slip on: {stages:?}; greatest gain {greatest:.2e}");
    assert!(stages.iter().all(|n| *n > 100), "{stages:?}");
}

#[test]
fn the_frame_does_not_matter() {
    let mut worst = 0.0_f64;
    for case in 0..3000 {
        let (contact, angle) = (random_contact(case), 6.3 * numbers(case)(15));
        let (out, other) =
            (contact.resolve(Law::Stronge).unwrap(), turned(&contact, angle).resolve(Law::Stronge).unwrap());
        let back = Rotation::by(Vec3::Z * -angle);
        worst = worst.max((back.apply(other.velocity) - out.velocity).norm());
        worst = worst.max((back.apply(other.impulse) - out.impulse).norm() / (1.0 + out.impulse.norm()));
    }
    println!("3000 contacts turned about their normals: {worst:.1e}");
    assert!(worst < 1e-10, "{worst:e}");
}

/// Where nothing couples to the second tangent, the plane's walk is the answer.
#[test]
fn in_a_plane_it_is_the_walk_of_the_plane() {
    let mut worst = 0.0_f64;
    for case in 0..5000 {
        let random = numbers(case);
        let (tt, nn) = (0.5 + random(0), 0.5 + random(1));
        let tn = 0.98 * (2.0 * random(2) - 1.0) * (tt * nn).sqrt();
        let (slip, normal) = (2.0 * random(3) - 1.0, -0.05 - random(4));
        let (friction, restitution) = (1.5 * random(5), random(6));
        let operator = Mat3 {
            rows: [Vec3::new(tt, 0.0, tn), Vec3::new(0.0, 0.3 + random(7), 0.0), Vec3::new(tn, 0.0, nn)],
        };
        let space = Contact { operator, velocity: Vec3::new(slip, 0.0, normal), friction, restitution };
        let angle = 6.3 * random(8);
        let plane =
            planar::single::Contact { w_tt: tt, w_tn: tn, w_nn: nn, slip, normal, friction, restitution };
        for law in [Law::Poisson, Law::Stronge, Law::Newton] {
            let (Ok(flat), Ok(out)) =
                (planar::single::resolve(&plane, law), turned(&space, angle).resolve(law))
            else {
                panic!("{plane:?} {:?}", turned(&space, angle).resolve(law))
            };
            let back = Rotation::by(Vec3::Z * -angle);
            let (v, p) = (back.apply(out.velocity), back.apply(out.impulse));
            let wanted = [
                (v.x, flat.slip),
                (v.y, 0.0),
                (v.z, flat.normal),
                (p.x, flat.tangential_impulse),
                (p.y, 0.0),
                (p.z, flat.normal_impulse),
            ];
            for (ours, theirs) in wanted {
                worst = worst.max((ours - theirs).abs() / (1.0 + theirs.abs()));
            }
            assert!(worst < 1e-9, "{law:?} {plane:?}: {flat:?} {out:?}");
        }
    }
    println!("5000 contacts of the plane under three laws: {worst:.1e}");
    assert!(worst < 1e-10, "{worst:e}");
}

#[test]
fn without_friction_nothing_acts_across_and_with_much_it_stops_at_once() {
    let mut stopped = 0;
    for case in 0..1000 {
        let contact = random_contact(case);
        let smooth = Contact { friction: 0.0, ..contact }.resolve(Law::Poisson).unwrap();
        assert_eq!((smooth.impulse.x, smooth.impulse.y), (0.0, 0.0), "{contact:?}");
        let wanted = -(1.0 + contact.restitution) * contact.velocity.z / contact.operator.rows[2].z;
        assert!((smooth.impulse.z - wanted).abs() < ROUNDING * wanted, "{smooth:?}");
        // Almost no normal impulse stops the slip: the plastic end has no velocity at all, unless friction alone turns the approach back before.
        let rough = Contact { friction: 1e6, restitution: 0.0, ..contact };
        let out = rough.resolve(Law::Poisson).unwrap();
        let turned_back = out.stages.len() == 1 && out.impulse.z < 1e-5 * out.impulse.norm();
        stopped += u32::from(!turned_back);
        assert!(turned_back || out.velocity.norm() < 1e-5 * contact.velocity.norm(), "{contact:?} {out:?}");
    }
    println!("1000 rough contacts: {stopped} stop");
    assert!(stopped > 500);
}
