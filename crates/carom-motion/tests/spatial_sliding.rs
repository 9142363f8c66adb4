//! Bodies that slide, against closed forms and against the plane.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::print_stdout, reason = "how far results are from closed forms is a measurement")]

use carom_motion::spatial::{Body, End, Friction, Mode, Options, Samples, State, World, run};
use carom_num::{Mat3, Rotation, Vec3};

const G: f64 = 9.81;

fn block(supports: Vec<Vec3>) -> Body {
    Body::new(1.3, Mat3::diagonal(0.01, 0.02, 0.025), supports).unwrap()
}

fn legs(count: u32, radius: f64, height: f64) -> Vec<Vec3> {
    let leg = |k: u32| {
        let (sin, cos) =
            carom_num::elementary::sin_cos(std::f64::consts::TAU * f64::from(k) / f64::from(count));
        Vec3::new(radius * cos, radius * sin, -height)
    };
    (0..count).map(leg).collect()
}

fn flat(body: &Body, velocity: Vec3, spin: f64) -> State {
    let low = body.supports()[0].z;
    State { centre: Vec3::Z * -low, attitude: Rotation::NONE, velocity, spin: Vec3::Z * spin }
}

fn rough(body: Body, friction: f64) -> World {
    World::new(body, Vec3::Z * -G).unwrap().with_friction(Friction::new(friction)).unwrap()
}

#[test]
fn a_block_slides_to_rest() {
    for count in [3, 4, 6] {
        for friction in [0.05, 0.3, 0.6] {
            let world = rough(block(legs(count, 0.2, 0.1)), friction);
            let velocity = Vec3::new(0.8, -0.6, 0.0);
            let start = flat(world.body(), velocity, 0.0);
            let mut samples = Samples::default();
            let out = run(&world, &start, &Options::default(), &mut samples).unwrap();
            println!("{count} {friction}: {:?} {} {:?}", out.end, out.time, out.effort);
            for p in &samples.pieces {
                println!("   {:?} {} {}", p.mode, p.start_time, p.end_time);
            }
            assert!(matches!(out.end, End::AtRest { .. }), "{:?}", out.end);
            let gone = out.state.centre - start.centre;
            let wanted = velocity / (2.0 * friction * G);
            println!("   {:e} {:e}", (gone - wanted).norm(), out.time - 1.0 / (friction * G));
            assert!((gone - wanted).norm() < 1e-13);
            let Mode::Slides { .. } = samples.pieces[0].mode else { panic!("it slides") };
        }
    }
}

#[test]
fn a_point_slides() {
    let body = Body::new(1.0, Mat3::diagonal(0.02, 0.03, 0.01), vec![Vec3::new(0.02, 0.01, -0.2)]).unwrap();
    let attitude = Rotation::by(Vec3::new(0.2, 0.3, 0.1));
    let spin = Vec3::new(0.4, -0.3, 60.0);
    let mut start = State::standing(&body, 0, attitude, spin);
    start.velocity += Vec3::new(0.5, 0.1, 0.0);
    let world = rough(body, 0.3);
    let mut samples = Samples::default();
    let options = Options { most_time: 2.0, ..Options::default() };
    let out = run(&world, &start, &options, &mut samples).unwrap();
    for p in &samples.pieces {
        println!("   {:?} {} {}", p.mode, p.start_time, p.end_time);
    }
    println!("{:?} {} {:e} work {} {:?}", out.end, out.time, out.drift, out.friction_work, out.effort);
    assert!(out.drift < 1e-12);
}
