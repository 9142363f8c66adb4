//! Pyramids that roll over a lateral edge onto the next face, against the closed forms.

#![allow(clippy::print_stdout, reason = "how far two computations differ is a measurement")]

use carom_motion::spatial::{Body, End, Impact, Mode, Options, Samples, State, Supports, World, run};
use carom_num::elementary::{atan2, cos, sin_cos};
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::spatial::{Kept, Pyramid};
use std::f64::consts::PI;

const G: f64 = 9.81;
/// Relative to the roll rate.
const SPIN: f64 = 1e-12;
/// What the least friction of a family of impulses is good for.
const DEMAND: f64 = 1e-9;
/// Relative to the largest normal impulse.
const IMPULSE: f64 = 1e-10;
/// Supports: the apex, and the corners of the base; A and K are the first two.
const APEX: usize = 0;
const A: usize = 1;
const K: usize = 2;

/// The body in the axes of the closed form, but for the origin.
fn body(pyramid: &Pyramid) -> Body {
    let (h, a) = (pyramid.height, pyramid.circumradius);
    let corner = |j: u32| {
        let (sin, cos) = sin_cos(PI / f64::from(pyramid.sides) * (2.0 * f64::from(j) - 1.0));
        Vec3::new(a * cos, a * sin, 0.25 * h)
    };
    let supports = std::iter::once(Vec3::Z * (-0.75 * h)).chain((0..pyramid.sides).map(corner)).collect();
    let [across, along] = pyramid.inertia();
    Body::new(pyramid.mass, Mat3::diagonal(across, across, along), supports).unwrap()
}

/// The unit normal of the plane on which the face lies, into the body.
fn face_normal(pyramid: &Pyramid) -> Vec3 {
    let (h, inner) = (pyramid.height, pyramid.circumradius * cos(PI / f64::from(pyramid.sides)));
    Vec3::new(-h, 0.0, inner).unit().unwrap()
}

/// On the edge OA, the face lifted by an angle, rolling down at a rate.
fn on_edge(pyramid: &Pyramid, body: &Body, lifted: f64, rate: f64) -> State {
    let normal = face_normal(pyramid);
    let across = normal.cross(Vec3::Z);
    let angle = atan2(across.norm(), normal.z);
    let flat = Rotation::by(across.unit().unwrap() * angle);
    let edge = (body.supports()[A] - body.supports()[APEX]).unit().unwrap();
    let attitude = Rotation::by(flat.apply(edge) * lifted).after(flat);
    State::standing(body, APEX, attitude, edge * -rate)
}

/// The first impact of a pyramid, and the roll rate that its energy lets one expect there.
fn first_impact(pyramid: &Pyramid) -> (Impact, f64) {
    let body = body(pyramid);
    let start = on_edge(pyramid, &body, 0.2, 1.0);
    let world = World::new(body, Vec3::Z * -G).unwrap();
    let mut samples = Samples::default();
    let options = Options { most_impacts: 1, ..Options::default() };
    let run = run(&world, &start, &options, &mut samples).unwrap();
    let body = world.body();
    let edge = match samples.pieces[0].mode {
        Mode::Edge { ends: [APEX, A], along, .. } => Some(along),
        _ => None,
    };
    let along = edge.unwrap();
    let moment = along.dot(body.inertia_about(body.supports()[APEX]) * along);
    let flat_height = -face_normal(pyramid).dot(body.supports()[APEX]);
    let gained = body.mass() * G * (start.centre.z - flat_height);
    (run.impacts[0].clone(), (1.0 + 2.0 * gained / moment).sqrt())
}

fn kept(pyramid: &Pyramid) -> Supports {
    let kept: &[usize] = match pyramid.kept() {
        Kept::ApexAndNext => &[APEX, K],
        Kept::Next => &[K],
        Kept::All => &[APEX, A, K],
        Kept::BaseEdge => &[A, K],
    };
    kept.iter().copied().collect()
}

fn pyramids() -> Vec<Pyramid> {
    let heights = [0.25, 0.5, 0.7, 0.8, 0.9, 1.0, 1.5, 2.0, 3.0];
    let of = |sides: u32| {
        heights.map(|h| Pyramid { sides, height: 0.3 * h, circumradius: 0.3, mass: 1.7 }).into_iter()
    };
    [3, 4, 5, 6, 8].into_iter().flat_map(of).collect()
}

#[test]
fn the_roll_to_the_next_face_and_its_impact_are_the_closed_forms() {
    let mut worst = [0.0_f64; 3];
    for pyramid in pyramids() {
        let (impact, rate) = first_impact(&pyramid);
        assert_eq!(impact.touching, [APEX, A, K].into_iter().collect(), "{pyramid:?}");
        assert_eq!(impact.striking, Supports::one(K), "{pyramid:?}");
        assert_eq!(impact.kept, kept(&pyramid), "{pyramid:?}");
        let theory = pyramid.strike(rate).unwrap();
        let spin = (impact.spin_after - Vec3::from_array(theory.spin)).norm() / rate;
        let before = (impact.spin_before.norm() / rate - 1.0).abs();
        let largest = theory.normal.iter().fold(0.0, |m: f64, n| m.max(*n));
        let normal = |(i, p): &(usize, Vec3)| (p.z - theory.normal[*i]).abs() / largest;
        let impulse = impact.impulses.iter().map(normal).fold(0.0, f64::max);
        worst = [worst[0].max(before), worst[1].max(spin), worst[2].max(impulse)];
        let ratio = impact.kinetic_after / impact.kinetic_before;
        assert!((ratio - theory.energy_ratio).abs() < SPIN, "{pyramid:?}: {ratio}");
    }
    println!("roll rates to {:e}, spins to {:e}, normal impulses to {:e}", worst[0], worst[1], worst[2]);
    assert!(worst[0] < SPIN && worst[1] < SPIN && worst[2] < IMPULSE, "{worst:?}");
}

/// A long pyramid keeps its apex: from face to face it loses the same part of its roll rate.
#[test]
fn a_pyramid_rolls_on_over_its_lateral_edges() {
    let pyramid = Pyramid { sides: 8, height: 0.9, circumradius: 0.3, mass: 1.7 };
    let body = body(&pyramid);
    let start = on_edge(&pyramid, &body, 0.2, 6.0);
    let world = World::new(body, Vec3::Z * -G).unwrap();
    let run = run(&world, &start, &Options { most_impacts: 3, ..Options::default() }, &mut ()).unwrap();
    let theory = pyramid.roll_ratio();
    for (impact, next) in run.impacts.iter().zip([2, 3, 4]) {
        assert_eq!(impact.kept, [APEX, next].into_iter().collect(), "from face to face");
        let ratio = impact.spin_after.norm() / impact.spin_before.norm();
        assert!((ratio - theory).abs() < SPIN, "{ratio} {theory}");
    }
    assert_eq!(run.impacts.len(), 3, "it has rolled over three edges");
}

/// A regular tetrahedron rocks about an edge of its base and strikes with the third corner, where it stays. The edge is d = R/2 from the middle of the base, R its
/// circumradius, the centre h = R/√8 above it: it comes down along (h, d), and the impulses stop it. Their sum needs friction h/d, and that is enough where each
/// corner takes its share along; the three corners can also squeeze each other at will.
#[test]
fn a_tetrahedron_that_falls_flat_needs_friction_by_the_way_of_its_centre() {
    let (sin, cos) = carom_num::elementary::sin_cos(std::f64::consts::FRAC_PI_3);
    let height = 0.125_f64.sqrt();
    let supports =
        vec![Vec3::new(1.0, 0.0, -height), Vec3::new(-cos, sin, -height), Vec3::new(-cos, -sin, -height)];
    // Edges of √3: m a²/20.
    let moment = 0.15;
    let body = Body::new(1.0, Mat3::diagonal(moment, moment, moment), supports).unwrap();
    let start = State::standing(&body, 1, Rotation::by(Vec3::Y * -0.1), Vec3::ZERO);
    let world = World::new(body, Vec3::Z * -9.81).unwrap();
    let run = run(&world, &start, &Options::default(), &mut ()).unwrap();
    let strike = &run.impacts[0];
    assert_eq!((strike.kept.len(), run.end), (3, End::AtRest { held: (0..3).collect() }));
    let least = 0.5_f64.sqrt();
    assert!((strike.friction_demand - least).abs() < DEMAND, "{} {least}", strike.friction_demand);
}
