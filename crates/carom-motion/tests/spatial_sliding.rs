//! Bodies that slide in space, against closed forms, without sliding where nothing slides, and among each other.

#![allow(clippy::print_stdout, reason = "how far results are from closed forms is a measurement")]

use carom_motion::spatial::{
    Body, End, Friction, Mode, Options, Run, Samples, State, Supports, World, forces, run,
};
use carom_num::elementary::{atan2, cos, sin_cos};
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::falling_stick::{floor_force_foot_fixed, spin_squared_foot_fixed};
use carom_theory::spatial::FlatSlide;
use std::f64::consts::TAU;

/// A slide without turning is a parabola, and without friction nothing pushes sideways: rounding of shares, energies [J] and speeds [m/s] of order 1.
const STRAIGHT: f64 = 1e-13;
/// What a run at the tolerance 1e-14 leaves of forces [N], places [m] and shares of an energy.
const FOLLOWED: f64 = 1e-12;
const G: f64 = 9.81;

fn table(slide: &FlatSlide) -> World {
    let leg = |k: u32| {
        let (sin, cos) = sin_cos(0.3 + TAU * f64::from(k) / f64::from(slide.feet));
        Vec3::new(slide.circle_radius * cos, slide.circle_radius * sin, -slide.centre_height)
    };
    let inertia = Mat3::diagonal(0.8 * slide.inertia, 0.8 * slide.inertia, slide.inertia);
    let body = Body::new(slide.mass, inertia, (0..slide.feet).map(leg).collect()).unwrap();
    rough(body, slide.friction)
}

fn rough(body: Body, friction: f64) -> World {
    World::new(body, Vec3::Z * -G).unwrap().with_friction(Friction::new(friction)).unwrap()
}

fn flat(world: &World, velocity: Vec3, spin: f64) -> State {
    let low = world.body().supports()[0].z;
    State { centre: Vec3::Z * -low, attitude: Rotation::NONE, velocity, spin: Vec3::Z * spin }
}

fn slides() -> impl Iterator<Item = FlatSlide> {
    [(3, 0.05), (3, 0.4), (4, 0.2), (4, 0.6), (6, 0.3), (8, 0.5)].into_iter().map(|(feet, friction)| {
        FlatSlide {
            feet,
            circle_radius: 0.2,
            centre_height: 0.05,
            mass: 1.3,
            inertia: 0.03,
            friction,
            gravity: G,
        }
    })
}

fn ran(world: &World, start: &State, most_time: f64) -> (Run, Samples) {
    let mut samples = Samples::default();
    let out = run(world, start, &Options { most_time, ..Options::default() }, &mut samples).unwrap();
    (out, samples)
}

#[test]
fn a_table_slides_straight_to_rest() {
    let mut worst = [0.0_f64; 2];
    for slide in slides() {
        let world = table(&slide);
        let velocity = Vec3::new(0.8, -0.6, 0.0);
        let start = flat(&world, velocity, 0.0);
        let (out, samples) = ran(&world, &start, 60.0);
        let wanted = slide.straight(1.0).unwrap();
        assert!(matches!(out.end, End::AtRest { .. }), "{:?}", out.end);
        assert!(matches!(samples.pieces[0].mode, Mode::Slides { .. }) && samples.pieces.len() == 1);
        let gone = out.state.centre - start.centre;
        worst[0] = worst[0].max((out.time - wanted.time).abs() / wanted.time);
        worst[1] = worst[1].max((gone - velocity * wanted.way).norm() / wanted.way);
        assert!((out.friction_work + 0.5 * slide.mass).abs() < STRAIGHT, "{}", out.friction_work);
        let held = forces(&world, samples.pieces[0].mode, &start).unwrap().unwrap();
        let heading = atan2(velocity.y, velocity.x);
        for (j, force) in held.forces {
            #[allow(clippy::cast_precision_loss, reason = "a handful")]
            let angle = 0.3 + TAU * j as f64 / f64::from(slide.feet) - heading;
            let load = slide.load(angle).unwrap() * slide.mass * G;
            assert!((force.z - load).abs() < FOLLOWED, "{j}: {} {load}", force.z);
        }
    }
    println!("straight: times to {:e}, ways to {:e}", worst[0], worst[1]);
    assert!(worst[0] < STRAIGHT && worst[1] < STRAIGHT, "{worst:?}");
}

#[test]
fn a_table_turns_in_place_to_rest() {
    let mut worst = [0.0_f64; 2];
    for slide in slides() {
        let world = table(&slide);
        let (out, _) = ran(&world, &flat(&world, Vec3::ZERO, -4.0), 60.0);
        let wanted = slide.turning(-4.0).unwrap();
        assert!(matches!(out.end, End::AtRest { .. }), "{:?}", out.end);
        let turned = out.state.attitude.apply(Vec3::X);
        let (sin, cos) = sin_cos(wanted.way);
        worst[0] = worst[0].max((out.time - wanted.time).abs() / wanted.time);
        worst[1] = worst[1].max((turned - Vec3::new(cos, sin, 0.0)).norm());
    }
    println!("turning: times to {:e}, turns to {:e}", worst[0], worst[1]);
    assert!(worst[0] < FOLLOWED && worst[1] < FOLLOWED, "{worst:?}");
}

/// Sliding and turning end together, and on the way energy and friction balance.
#[test]
fn sliding_and_turning_end_together() {
    for slide in slides() {
        let world = table(&slide);
        for spin in [0.5, 3.0, 12.0] {
            let start = flat(&world, Vec3::new(0.4, 0.3, 0.0), spin);
            let (out, _) = ran(&world, &start, 60.0);
            assert!(matches!(out.end, End::AtRest { .. }), "{:?}", out.end);
            let lost = start.kinetic(world.body()) + out.friction_work;
            assert!(lost.abs() < 1e-11 && out.drift < FOLLOWED, "{lost:e} {:e}", out.drift);
            assert_eq!(out.state.kinetic(world.body()), 0.0);
        }
    }
}

fn stick() -> Body {
    let third = 1.0 / 12.0;
    Body::new(1.0, Mat3::diagonal(third, third, 1e-3), vec![Vec3::Z * -0.5]).unwrap()
}

#[test]
fn a_falling_stick_starts_to_slip_where_its_foot_force_leaves_the_cone() {
    for (friction, heading) in [(0.1, 0.4), (0.25, -2.0), (0.35, 1.0), (0.7, 2.5)] {
        let (sin, cos) = sin_cos(heading);
        let axis = Vec3::new(cos, sin, 0.0);
        let lean = 0.02;
        let spin = spin_squared_foot_fixed(G, 1.0, 0.0, lean).sqrt();
        let body = stick();
        let start = State::standing(&body, 0, Rotation::by(axis * lean), axis * spin);
        let (_, samples) = ran(&rough(body, friction), &start, 5.0);
        let [first, second] = &samples.pieces[..2] else { panic!("it sticks, then slips") };
        assert!(matches!(first.mode, Mode::Pivot { support: 0, .. }));
        assert_eq!(second.mode, Mode::Slides { sticking: Supports::NONE, slipping: Supports::one(0) });
        let tilt = first.end.tilt(Vec3::Z);
        let (forward, upward) = floor_force_foot_fixed(tilt);
        let off = forward.abs() - friction * upward;
        println!("μ = {friction}: slips at {tilt}, where the cone is missed by {off:e}");
        assert!(off.abs() < FOLLOWED, "{off:e}");
        // Below μ = 0.37 it slips backward, above forward.
        let foot = second.end.place(Vec3::Z * -0.5) - second.start.place(Vec3::Z * -0.5);
        let ahead = axis.cross(Vec3::Z);
        assert_eq!(foot.dot(ahead) < 0.0, friction < 0.37, "{foot:?}");
    }
}

/// A body on one support that slides while it spins: what friction takes is what energy loses, at every tolerance met.
#[test]
fn a_sliding_point_balances_its_energy() {
    let arm = Vec3::new(0.02, 0.01, -0.2);
    let body = Body::new(1.0, Mat3::diagonal(0.02, 0.03, 0.01), vec![arm]).unwrap();
    let attitude = Rotation::by(Vec3::new(0.2, 0.3, 0.1));
    for friction in [0.02, 0.1, 0.3, 0.6, 1.0] {
        let mut start = State::standing(&body, 0, attitude, Vec3::new(0.4, -0.3, 9.0));
        start.velocity += Vec3::new(0.5, 0.1, 0.0);
        let world = rough(body.clone(), friction);
        let (out, samples) = ran(&world, &start, 1.0);
        let energy = |s: &State| s.kinetic(world.body()) + s.potential(&world);
        let slid = samples.pieces.iter().filter(|p| matches!(p.mode, Mode::Slides { .. }));
        assert!(slid.clone().all(|p| energy(&p.end) < energy(&p.start)), "friction only takes");
        assert!(slid.count() > 0 && out.drift < FOLLOWED, "μ = {friction}: {:e}", out.drift);
        println!("μ = {friction}: {} pieces, drift {:e}", samples.pieces.len(), out.drift);
    }
}

#[test]
fn without_friction_nothing_pushes_sideways() {
    let body = Body::new(
        0.7,
        Mat3::diagonal(0.004, 0.006, 0.005),
        vec![Vec3::new(0.1, 0.0, -0.1), Vec3::new(-0.1, 0.1, -0.1), Vec3::new(-0.1, -0.1, -0.1)],
    )
    .unwrap();
    let mut start =
        State::standing(&body, 0, Rotation::by(Vec3::new(0.3, 0.2, 0.0)), Vec3::new(1.0, 0.5, 2.0));
    start.centre.z += 0.1;
    start.velocity = Vec3::new(0.3, -0.4, 0.0);
    let (out, samples) = ran(&rough(body, 0.0), &start, 1.0);
    assert!(samples.pieces.len() > 2 && out.friction_work == 0.0);
    let sideways = out.state.velocity - start.velocity;
    assert!(sideways.x.abs() < STRAIGHT && sideways.y.abs() < STRAIGHT, "{sideways:?}");
}

/// A top on rough ground neither slides nor strikes: it moves as if nothing could slide.
#[test]
fn a_top_on_rough_ground_does_not_slide() {
    let body = Body::new(0.5, Mat3::diagonal(0.004, 0.004, 0.003), vec![Vec3::Z * -0.08]).unwrap();
    let start = State::standing(&body, 0, Rotation::by(Vec3::X * 0.2), Vec3::new(0.2, 0.0, 60.0));
    let held = World::new(body.clone(), Vec3::Z * -G).unwrap();
    let options = Options { most_time: 2.0, ..Options::default() };
    let stuck = run(&held, &start, &options, &mut ()).unwrap();
    let (free, samples) = ran(&rough(body, 20.0), &start, 2.0);
    assert_eq!(samples.pieces.len(), 1);
    assert_eq!((stuck.state, stuck.time), (free.state, free.time));
}

#[test]
fn a_run_does_not_know_north() {
    let supports = vec![
        Vec3::new(0.1, 0.02, -0.1),
        Vec3::new(-0.08, 0.1, -0.1),
        Vec3::new(-0.1, -0.09, -0.1),
        Vec3::new(0.03, 0.0, 0.15),
    ];
    let body = Body::new(0.7, Mat3::diagonal(0.004, 0.006, 0.005), supports).unwrap();
    let (mut worst, mut slid) = ([0.0_f64; 2], 0);
    for (friction, turn) in [(0.15, 1.0), (0.3, 2.2), (0.5, -0.7), (0.8, 3.0)] {
        let world = rough(body.clone(), friction);
        let mut start =
            State::standing(&body, 0, Rotation::by(Vec3::new(0.5, 0.3, 0.0)), Vec3::new(1.0, 0.5, 3.0));
        start.centre.z += 0.05;
        start.velocity = Vec3::new(0.6, -0.4, 0.0);
        let about = Rotation::by(Vec3::Z * turn);
        let turned = State {
            centre: about.apply(start.centre),
            attitude: about.after(start.attitude),
            velocity: about.apply(start.velocity),
            spin: start.spin,
        };
        let ((a, seen), (b, _)) = (ran(&world, &start, 0.35), ran(&world, &turned, 0.35));
        assert_eq!(a.impacts.len(), b.impacts.len());
        slid += seen.pieces.iter().filter(|p| matches!(p.mode, Mode::Slides { .. })).count();
        worst[0] = worst[0].max((about.apply(a.state.centre) - b.state.centre).norm());
        worst[1] = worst[1].max((a.state.spin - b.state.spin).norm());
    }
    println!("turned: {slid} slides, places to {:e}, spins to {:e}", worst[0], worst[1]);
    assert!(slid > 4 && worst[0] < 1e-10 && worst[1] < 1e-9, "{worst:?}");
}

#[test]
fn a_block_on_a_slope_starts_to_slide_where_its_friction_ends() {
    let slope: f64 = 0.4;
    let (sin, cosine) = sin_cos(slope);
    let corners = [(-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)].map(|(x, y)| Vec3::new(x, y, -0.03));
    let body = Body::new(1.0, Mat3::diagonal(0.004, 0.004, 0.007), corners.to_vec()).unwrap();
    for friction in [0.3, 0.42, 0.43, 0.6] {
        let gravity = Vec3::new(0.6 * sin, -0.8 * sin, -cosine) * G;
        let world =
            World::new(body.clone(), gravity).unwrap().with_friction(Friction::new(friction)).unwrap();
        let start = flat(&world, Vec3::ZERO, 0.0);
        let (out, _) = ran(&world, &start, 0.5);
        if friction > sin / cos(slope) {
            assert!(matches!(out.end, End::AtRest { .. }) && out.time == 0.0);
        } else {
            let pull = G * (sin - friction * cosine);
            let gone = out.state.centre - start.centre;
            let wanted = Vec3::new(0.6, -0.8, 0.0) * (0.5 * pull * 0.25);
            assert!((gone - wanted).norm() < FOLLOWED, "{gone:?} {wanted:?}");
        }
    }
}
