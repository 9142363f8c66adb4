//! The referee's cases: one case a line from stdin, one answer a line to stdout (`carom cases`, `carom judge`).
//!
//! A contact is a small ball on the body that meets its own obstacle alone: a half-space, or the ball of another body. Lengths ×100, steps of
//! 0.01 ms, no contact recycling, friction in the bias pass; more iterations, and friction in the other pass, were no nearer. Restitution and
//! friction of both that touch are the contact's.
//!
//! What it does where a body rebounds: friction takes no more than its coefficient times the normal impulse of compression, that of restitution
//! is added without friction.

use crate::model::{FINE, Setting};
use rapier2d_f64::prelude::*;
use serde_json::{Value, json};
use std::io::{BufRead, Write};

const STEP: f64 = 1e-5;
/// Radius [m] of the balls at contacts.
const RADIUS: f64 = 0.005;
const MOST_STEPS: usize = 2000;
/// Steps in which a contact that closes no more may close again.
const PATIENCE: usize = 20;
/// A contact is over where it closes with less than this share of the fastest before.
const SLOW: f64 = 1e-3;

/// Answers every line.
pub fn answer_lines() -> Result<(), String> {
    let mut out = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        let line = line.map_err(|problem| problem.to_string())?;
        let case: Value = serde_json::from_str(&line).map_err(|problem| problem.to_string())?;
        let mut answer = match case.get("impact").map(struck) {
            Some(Ok(bodies)) => json!({ "bodies": bodies }),
            Some(Err(why)) => json!({ "refused": why }),
            None => json!({ "refused": "drops are compared by run.py" }),
        };
        answer["case"] = case["case"].clone();
        writeln!(out, "{answer}").map_err(|problem| problem.to_string())?;
    }
    Ok(())
}

/// A contact: the body that its normal points into, the other one, where, how.
struct Contact {
    into: usize,
    out_of: Option<usize>,
    point: Vector,
    normal: Vector,
    friction: f64,
    restitution: f64,
}

fn vector(of: &Value) -> Vector {
    Vector::new(of[0].as_f64().unwrap_or(0.0), of[1].as_f64().unwrap_or(0.0))
}

/// The bodies after an impact.
fn struck(impact: &Value) -> Result<Vec<Value>, String> {
    let listed: Vec<&Value> = match &impact["body"] {
        Value::Array(list) => list.iter().collect(),
        one => vec![one],
    };
    if listed.iter().any(|body| body["velocity"].as_array().is_none_or(|v| v.len() != 2)) {
        return Err("it knows the plane only here".to_owned());
    }
    let index = |name: &Value| listed.iter().position(|body| body["name"] == *name);
    let contacts: Vec<Contact> = impact["contact"]
        .as_array()
        .into_iter()
        .flatten()
        .map(|of| Contact {
            into: index(&of["between"][0]).unwrap_or(0),
            out_of: of.get("between").and_then(|pair| index(&pair[1])),
            point: vector(&of["point"]),
            normal: vector(&of["normal"]).normalize(),
            friction: of["friction"].as_f64().unwrap_or(0.0),
            restitution: of["restitution"].as_f64().unwrap_or(0.0),
        })
        .collect();
    if contacts.len() > 31 {
        return Err("more than 31 contacts cannot be kept apart".to_owned());
    }
    let setting = Setting { step: STEP, ..FINE };
    let k = setting.scale;
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::new(0.0, 0.0);
    world.integration_parameters.dt = STEP;
    world.integration_parameters.contact_recycling = setting.recycling;
    world.integration_parameters.friction_in_bias_pass = setting.friction_in_bias_pass;
    let centres: Vec<Vector> = listed.iter().map(|body| vector(&body["centre"])).collect();
    let handles: Vec<RigidBodyHandle> = listed
        .iter()
        .zip(&centres)
        .map(|(body, centre)| {
            let (velocity, spin) = (vector(&body["velocity"]), body["spin"].as_f64().unwrap_or(0.0));
            let (mass, inertia) =
                (body["mass"].as_f64().unwrap_or(1.0), body["inertia"].as_f64().unwrap_or(1.0));
            let made = RigidBodyBuilder::dynamic()
                .translation((*centre - velocity * STEP) * k)
                .rotation(-spin * STEP)
                .linvel(velocity * k)
                .angvel(spin)
                .additional_mass_properties(MassProperties::new(Vector::ZERO, mass, inertia * k * k))
                .can_sleep(false);
            world.insert_body(made)
        })
        .collect();
    for (i, contact) in contacts.iter().enumerate() {
        let own = |shape: ColliderBuilder| {
            let group = Group::from_bits_truncate(1 << i);
            shape
                .density(0.0)
                .friction(contact.friction)
                .restitution(contact.restitution)
                .collision_groups(InteractionGroups::new(group, group, InteractionTestMode::And))
        };
        let ball = |body: usize, side: f64| {
            let at = (contact.point + contact.normal * (side * RADIUS) - centres[body]) * k;
            own(ColliderBuilder::ball(RADIUS * k)).translation(at)
        };
        world.insert_collider(ball(contact.into, 1.0), Some(handles[contact.into]));
        match contact.out_of {
            Some(other) => {
                world.insert_collider(ball(other, -1.0), Some(handles[other]));
            }
            None => {
                let ground = own(ColliderBuilder::new(SharedShape::halfspace(contact.normal)));
                world.insert_collider(ground.translation(contact.point * k), None);
            }
        }
    }
    Ok(stepped(&mut world, &handles, (&contacts, &centres), k))
}

/// Steps until the contacts have done their work.
fn stepped(
    world: &mut PhysicsWorld,
    handles: &[RigidBodyHandle],
    (contacts, centres): (&[Contact], &[Vector]),
    k: f64,
) -> Vec<Value> {
    let moving = |world: &PhysicsWorld, i: usize| {
        let body = &world.bodies[handles[i]];
        (body.linvel() / k, body.angvel())
    };
    let closing = |world: &PhysicsWorld| -> f64 {
        let at = |i: usize, point: Vector| {
            let ((v, w), arm) = (moving(world, i), point - centres[i]);
            Vector::new(v.x - w * arm.y, v.y + w * arm.x)
        };
        let speeds = contacts.iter().map(|contact| {
            let beyond = contact.out_of.map_or(Vector::ZERO, |other| at(other, contact.point));
            (at(contact.into, contact.point) - beyond).dot(contact.normal)
        });
        speeds.fold(f64::INFINITY, f64::min)
    };
    let slow = SLOW * closing(world);
    let mut waited = 0;
    for _ in 0..MOST_STEPS {
        world.step();
        waited = if closing(world) < slow { 0 } else { waited + 1 };
        if waited > PATIENCE {
            break;
        }
    }
    let written = |i: usize| {
        let (v, w) = moving(world, i);
        json!({ "velocity_m_s": [v.x, v.y], "spin_rad_s": w })
    };
    (0..handles.len()).map(written).collect()
}
