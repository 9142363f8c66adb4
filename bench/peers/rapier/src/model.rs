//! The drop in Rapier (crate `rapier2d-f64`): one box 1 mm thick over a cuboid with a free edge and a half-space.
//!
//! | setting | lengths | step | contact recycling | friction in the bias pass |
//! |---|---|---|---|---|
//! | `default` | in metres | 1/60 s | yes | no |
//! | `fast` | ×100, so that the engine's own tolerances (5 mm, 20 mm) become 0.05 mm and 0.2 mm | 1 ms | no | yes |
//! | `fine` | ×100 | 0.1 ms | no | yes |
//!
//! Everything else is the vendor's default; bodies never sleep.

use crate::drop::{
    Design, FRICTION, GRAVITY, INERTIA, LENGTH, LIMIT, LOOK_EVERY, MASS, Strike, THICKNESS, Watch,
};
use rapier2d_f64::prelude::*;

/// How the engine is used.
#[derive(Clone, Copy)]
pub struct Setting {
    pub scale: f64,
    pub step: f64,
    pub recycling: bool,
    pub friction_in_bias_pass: bool,
}

pub const DEFAULT: Setting =
    Setting { scale: 1.0, step: 1.0 / 60.0, recycling: true, friction_in_bias_pass: false };
pub const FAST: Setting = Setting { scale: 100.0, step: 1e-3, recycling: false, friction_in_bias_pass: true };
pub const FINE: Setting = Setting { scale: 100.0, step: 1e-4, recycling: false, friction_in_bias_pass: true };

/// Half the extent [m] of the plates away from the part.
const REACH: f64 = 0.25;

fn world(design: Design, setting: Setting, gravity: f64) -> PhysicsWorld {
    let k = setting.scale;
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::new(0.0, -gravity * k);
    world.integration_parameters.dt = setting.step;
    world.integration_parameters.contact_recycling = setting.recycling;
    world.integration_parameters.friction_in_bias_pass = setting.friction_in_bias_pass;
    let (x, y) = design.lower_point();
    let (s, c) = design.lower_angle().sin_cos();
    let ground = RigidBodyBuilder::fixed().translation(Vector::new(k * x, k * y));
    let plate = SharedShape::halfspace(Vector::new(-s, c));
    world.insert(ground, ColliderBuilder::new(plate).friction(FRICTION));
    world
}

/// The upper plate: a cuboid whose top face ends at the edge.
fn upper_plate(world: &mut PhysicsWorld, design: Design, k: f64) -> RigidBodyHandle {
    let (x, y) = design.to_world(-REACH, REACH);
    let body = RigidBodyBuilder::fixed().translation(Vector::new(k * x, k * y)).rotation(-design.slope);
    let (handle, _) = world.insert(body, ColliderBuilder::cuboid(k * REACH, k * REACH).friction(FRICTION));
    handle
}

fn part(world: &mut PhysicsWorld, k: f64, centre: (f64, f64), angle: f64) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(k * centre.0, k * centre.1))
        .rotation(angle)
        .can_sleep(false);
    let shape = ColliderBuilder::cuboid(k * LENGTH / 2.0, k * THICKNESS / 2.0)
        .friction(FRICTION)
        .mass_properties(MassProperties::new(Vector::ZERO, MASS, INERTIA * k * k));
    let (handle, _) = world.insert(body, shape);
    handle
}

/// The verdict of one drop; "none" where it has none in time.
pub fn drop_part(design: Design, setting: Setting) -> &'static str {
    let k = setting.scale;
    let mut world = world(design, setting, GRAVITY);
    let upper = upper_plate(&mut world, design, k);
    let (x, y, angle) = design.start();
    let part = part(&mut world, k, (x, y), angle);
    let mut watch = Watch::new(design);
    let steps = (LOOK_EVERY / setting.step).round().max(1.0) as u32;
    let looks = (LIMIT / (f64::from(steps) * setting.step)).round() as u32;
    for _ in 0..looks {
        for _ in 0..steps {
            world.step();
        }
        let body = &world.bodies[part];
        let (centre, angle, spin) = (body.translation() / k, body.rotation().angle(), body.angvel());
        if let Some(verdict) = watch.sees_verdict(angle, spin) {
            return verdict;
        }
        if watch.sees_release(centre.x, centre.y, angle) {
            world.remove_body(upper);
        }
    }
    "none"
}

/// The spin after an isolated impact, without gravity, at the setting with another step.
pub fn strike(strike: Strike, setting: Setting, step: f64) -> f64 {
    let k = setting.scale;
    let mut world = world(strike.design, Setting { step, ..setting }, 0.0);
    let (vx, vy) = strike.velocity;
    let before = (strike.centre.0 - vx * step, strike.centre.1 - vy * step);
    let part = part(&mut world, k, before, strike.angle - strike.spin * step);
    let body = &mut world.bodies[part];
    body.set_linvel(Vector::new(k * vx, k * vy), true);
    body.set_angvel(strike.spin, true);
    for _ in 0..1000 {
        world.step();
        let body = &world.bodies[part];
        let velocity = body.linvel() / k;
        let approach = strike.approach(body.rotation().angle(), (velocity.x, velocity.y), body.angvel());
        if strike.is_over(approach) {
            break;
        }
    }
    world.bodies[part].angvel()
}
