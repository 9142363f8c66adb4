//! What holds for every strike of a rocking body.

use crate::rocking_bodies;

use carom_impact::planar::{Slip, Touch, staged};
use carom_impact::{Law, Phase};
use carom_num::Vec2;
use carom_num::elementary::pow;
use carom_theory::rocking::{Cylinder, Prism, SupportedRod};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rocking_bodies::Rocking;
use rocking_bodies::draw::{cylinder, restitution, rod};

/// A few roundings, in units of the motion before.
const ROUNDING: f64 = 1e-13;

#[test]
fn mass_and_speed_do_not_matter_for_the_rod() {
    let mut rng = Pcg64::seed_from_u64(11);
    for _ in 0..20_000 {
        let supports = [rng.random_range(0.01..0.5), rng.random_range(0.01..0.5)];
        let e = rng.random_range(0.0..1.0);
        let after = |mass: f64, roll_rate: f64| {
            let rod = SupportedRod::uniform(mass, 1.0, supports);
            let body = Rocking::rod(&rod, roll_rate, e);
            body.after(&body.strike().impulse).map(|v| v / roll_rate)
        };
        let unit = after(1.0, 1.0);
        assert_eq!(after(8.0, 1.0), unit, "eight times the mass: {supports:?} e {e}");
        assert_eq!(after(1.0, 0.125), unit, "an eighth of the speed: {supports:?} e {e}");
        let (mass, roll_rate) =
            (pow(10.0, rng.random_range(-6.0..6.0)), pow(10.0, rng.random_range(-6.0..6.0)));
        for (any, expected) in after(mass, roll_rate).into_iter().zip(unit) {
            assert!((any - expected).abs() < ROUNDING, "m {mass} ω {roll_rate}: {supports:?} e {e}");
        }
    }
}

/// Whether K is loaded in the first stage of compression, and stays loaded to its end.
fn holds_the_new_contact(body: &Rocking) -> bool {
    let (mut held, mut first) = (true, true);
    staged::resolve_observed(&body.set(), Law::Poisson, &mut |stage| {
        if stage.phase == Phase::Compression {
            let (before, after) = (stage.start.impulse[1][1], stage.end.impulse[1][1]);
            held &= stage.slip[1] != Slip::Open && after > before && (!first || before == 0.0);
            first = false;
        }
    })
    .unwrap();
    held && !first
}

/// A cylinder of unit mass and radius.
fn unit_cylinder(rng: &mut Pcg64) -> Cylinder {
    Cylinder {
        mass: 1.0,
        radius: 1.0,
        inertia_ratio: rng.random_range(0.02..1.0),
        friction: rng.random_range(0.0..2.0),
        half_angle: rng.random_range(0.5f64..89.5).to_radians(),
    }
}

#[test]
fn the_new_contact_never_separates_at_the_beginning() {
    let mut rng = Pcg64::seed_from_u64(12);
    for _ in 0..50_000 {
        let cylinder = unit_cylinder(&mut rng);
        let e = rng.random_range(0.0..1.0);
        assert!(holds_the_new_contact(&Rocking::cylinder(&cylinder, 1.0, e)), "{cylinder:?} e {e}");
        let prism = Prism {
            mass: 1.0,
            inertia: pow(10.0, rng.random_range(-2.0..1.0)),
            to_centre: rng.random_range(0.05..2.0),
            to_k: rng.random_range(0.05..2.0),
            height: rng.random_range(0.05..2.0),
            friction: rng.random_range(0.0..2.0),
        };
        assert!(holds_the_new_contact(&Rocking::prism(&prism, 1.0, e)), "{prism:?} e {e}");
    }
}

#[test]
fn rocking_never_gains_energy() {
    let mut rng = Pcg64::seed_from_u64(13);
    for _ in 0..50_000 {
        let cylinder = unit_cylinder(&mut rng);
        let e = rng.random_range(0.0..1.0);
        let body = Rocking::cylinder(&cylinder, 1.0, e);
        let out = body.strike();
        assert!(!out.gained_energy && out.restitution_scaled == 1.0, "{cylinder:?} e {e} {out:?}");
        assert!(out.velocity.iter().all(|u| u[1] >= 0.0), "nothing sinks in: {cylinder:?} e {e} {out:?}");
    }
}

/// The same body seen from behind: x turned round.
fn mirrored(body: &Rocking) -> Rocking {
    let turn = |v: Vec2| Vec2::new(-v.x, v.y);
    let [x, y, w] = body.before;
    Rocking {
        touches: body.touches.map(|t| Touch { arm: turn(t.arm), normal: turn(t.normal), ..t }),
        before: [-x, y, -w],
        ..*body
    }
}

#[test]
fn mirror_images_and_the_order_of_contacts_change_nothing() {
    let mut rng = Pcg64::seed_from_u64(14);
    for _ in 0..30_000 {
        let (c, e) = (cylinder(&mut rng), restitution(&mut rng));
        let body = Rocking::cylinder(&c, 1.0, e);
        let [x, y, w] = body.after(&body.strike().impulse);
        let image = mirrored(&body);
        let swapped = Rocking { touches: [body.touches[1], body.touches[0]], ..body };
        let motions = [image.after(&image.strike().impulse), swapped.after(&swapped.strike().impulse)];
        let within = 1e-10 * (body.speed() + body.speed() / c.radius);
        for (motion, expected) in motions.iter().zip([[-x, y, -w], [x, y, w]]) {
            for (ours, other) in motion.iter().zip(expected) {
                assert!((ours - other).abs() <= within, "{c:?} e {e}: {motions:?}, not {expected:?}");
            }
        }
    }
}

#[test]
fn the_three_laws_agree_on_the_rod() {
    let mut rng = Pcg64::seed_from_u64(15);
    for _ in 0..30_000 {
        let (rod, e) = (rod(&mut rng), restitution(&mut rng));
        let set = Rocking::rod(&rod, 1.0, e).set();
        let poisson = staged::resolve(&set, Law::Poisson).unwrap();
        for law in [Law::Stronge, Law::Newton] {
            let out = staged::resolve(&set, law).unwrap();
            for i in 0..2 {
                let off = (out.velocity[i][1] - poisson.velocity[i][1]).abs();
                assert!(off <= 1e-12 * (rod.to_a + rod.to_b), "{law:?} {rod:?} e {e}: {out:?} {poisson:?}");
            }
        }
    }
}
