//! What contacts can press at the most, and that what is refused as jammed is held by contacts that can press without end.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::obstacles;

use carom_impact::planar::{ContactSet6, Touch, staged};
use carom_impact::{ImpactError, Law};
use carom_num::Vec2;
use carom_theory::wedging::{PushedPoint, least_wrench, most_pressed};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

const BODIES: u32 = 20_000;
const MASS: f64 = 1.0;

struct Struck {
    touches: Vec<Touch>,
    inertia: f64,
    velocity: Vec2,
    spin: f64,
    law: Law,
}

impl Struck {
    fn drawn(rng: &mut Pcg64) -> Self {
        Self {
            touches: obstacles::touches(rng),
            inertia: rng.random_range(0.05..1.0),
            velocity: Vec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0)),
            spin: rng.random_range(-2.0..2.0),
            law: [Law::Poisson, Law::Stronge][rng.random_range(0..2)],
        }
    }

    fn set(&self) -> ContactSet6 {
        ContactSet6::of_free_body(MASS, self.inertia, self.velocity, self.spin, &self.touches).unwrap()
    }

    fn radius_of_gyration(&self) -> f64 {
        (self.inertia / MASS).sqrt()
    }

    fn momentum(&self) -> f64 {
        let turning = self.radius_of_gyration() * self.spin;
        MASS * (self.velocity.dot(self.velocity) + turning * turning).sqrt()
    }

    fn points(&self) -> Vec<PushedPoint> {
        let point = |t: &Touch| PushedPoint {
            arm: [t.arm.x, t.arm.y],
            normal: [t.normal.x, t.normal.y],
            friction: t.friction,
        };
        self.touches.iter().map(point).collect()
    }
}

#[test]
fn contacts_at_rest_press_no_more_than_the_body_can_take() {
    let mut rng = Pcg64::seed_from_u64(21);
    let (mut worst, mut held) = (0.0_f64, 0);
    for _ in 0..BODIES {
        let body = Struck::drawn(&mut rng);
        let most = most_pressed(&body.points(), body.radius_of_gyration(), body.momentum());
        if let Ok(out) = staged::resolve(&body.set(), body.law) {
            let pressed: f64 = out.impulse.iter().map(|p| p[1]).sum();
            assert!(pressed <= most * (1.0 + 1e-9), "{pressed:e} {most:e} {out:?}");
            worst = worst.max(pressed / most);
            held += u32::from(pressed > 0.0 && most > 1e12);
        }
    }
    println!("at most {worst:.3} of the bound; {held} resolved although a load holds itself");
    assert!(worst > 0.5 && held > 1000, "{worst} {held}");
}

/// Obstacles that move have no bound on what they press, unless the contacts cannot be wedged.
#[test]
fn what_jams_between_moving_obstacles_is_held_by_a_load_that_holds_itself() {
    let mut rng = Pcg64::seed_from_u64(22);
    let mut jammed = 0;
    for _ in 0..BODIES {
        let body = Struck::drawn(&mut rng);
        let mut set = body.set();
        obstacles::let_move(&mut rng, &mut set);
        if staged::resolve(&set, body.law) == Err(ImpactError::Jammed) {
            let z = least_wrench(&body.points(), body.radius_of_gyration());
            assert!(z < 1e-12, "{z:e} {set:?}");
            jammed += 1;
        }
    }
    println!("{jammed} of {BODIES} jammed");
    assert!(jammed > 1000, "{jammed}");
}
