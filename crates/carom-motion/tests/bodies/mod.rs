//! Random bodies over a plane.

use carom_motion::spatial::{Body, Friction, Options, Plane, Run, Samples, State, World, run};
use carom_num::elementary::{cos, sin};
use carom_num::{Mat3, Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

fn vector(rng: &mut Pcg64, size: f64) -> Vec3 {
    let mut one = || rng.random_range(-size..size);
    Vec3::new(one(), one(), one())
}

/// A body on one to eight supports anywhere: every other one stands on its lowest support, the rest are thrown; every third one spins fast.
pub(crate) fn drawn(case: u64) -> (World, State) {
    let mut rng = Pcg64::seed_from_u64(case);
    let count = rng.random_range(1..9);
    let reach = rng.random_range(0.1..0.5);
    let supports: Vec<Vec3> = (0..count).map(|_| vector(&mut rng, reach)).collect();
    let mass = rng.random_range(0.5..2.0);
    // A cloud of mass with these mean squares along its axes.
    let [x, y, z] = [0; 3].map(|_| reach * reach * rng.random_range(0.02..0.5));
    let turned = Rotation::by(vector(&mut rng, 2.0)).turn(Mat3::diagonal(y + z, z + x, x + y)) * mass;
    let inertia = (turned + turned.transposed()) * 0.5;
    let body = Body::new(mass, inertia, supports.clone()).unwrap();
    let attitude = Rotation::by(vector(&mut rng, 3.0));
    let height = |i: usize| attitude.apply(supports[i]).z;
    let lowest = (0..count).min_by(|a, b| height(*a).total_cmp(&height(*b))).unwrap();
    let spin = vector(&mut rng, if case.is_multiple_of(3) { 8.0 } else { 1.0 });
    let mut state = State::standing(&body, lowest, attitude, spin);
    if case.is_multiple_of(2) {
        state.centre.z += rng.random_range(0.0..0.3);
        state.velocity = vector(&mut rng, 0.5);
    }
    (World::new(body, Vec3::Z * -9.81).unwrap(), state)
}

/// A plane that rises by `tilt` against a direction.
pub(crate) fn rising(tilt: f64, against: f64, offset: f64) -> Plane {
    Plane::new(Vec3::new(sin(tilt) * cos(against), sin(tilt) * sin(against), cos(tilt)), offset).unwrap()
}

/// A body over the plane z = 0, with friction.
pub(crate) fn on(body: Body, gravity: Vec3, friction: f64) -> World {
    World::new(body, gravity).unwrap().with_friction(Friction::new(friction)).unwrap()
}

/// A run for a time, and what is seen of it.
pub(crate) fn ran(world: &World, start: &State, time: f64) -> (Run, Samples) {
    let mut samples = Samples::default();
    let options = Options { most_time: time, ..Options::default() };
    let out = run(world, start, &options, &mut samples).unwrap();
    (out, samples)
}
