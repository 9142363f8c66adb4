//! A cube that lands flat on a whole face rebounds as its restitution says, however its attitude is rounded.

use carom_impact::Law;
use carom_impact::spatial::staged;
use carom_motion::spatial::{Body, Friction, State, Supports, World, frictional_contacts};
use carom_num::elementary::sin_cos;
use carom_num::{Mat3, Rotation, Vec3};

const HALF: f64 = 0.05;
const MASS: f64 = 0.4;

fn cube(restitution: f64) -> World {
    let signs = [-HALF, HALF];
    let corners =
        signs.iter().flat_map(|&z| signs.iter().flat_map(move |&y| signs.map(|x| Vec3::new(x, y, z))));
    let moment = MASS * 4.0 * HALF * HALF / 6.0;
    let body = Body::new(MASS, Mat3::diagonal(moment, moment, moment), corners.collect()).unwrap();
    let world = World::new(body, Vec3::Z * -9.81).unwrap();
    world.with_friction(Friction::new(0.2).with_restitution(restitution)).unwrap()
}

/// Loads of four corners turn the cube by nothing but their rounding, in equations that are nearly the same four times over: they must not contradict each
/// other.
#[test]
fn four_corners_rebound_together_in_any_rounded_attitude() {
    for restitution in [0.3, 0.9, 1.0] {
        let world = cube(restitution);
        let velocity = Vec3::new(3.9e-16, 4.5e-16, -1.7);
        for k in 0..200 {
            // From rounding to what a body may be off after a long fall.
            let size = 10f64.powi(-16 + k % 5);
            let [(a, b), (c, _)] = [1.7, 0.9].map(|rate| sin_cos(rate * f64::from(k)));
            let turn = Vec3::new(a, b, c);
            let attitude = Rotation::by(turn * size);
            let state = State { centre: Vec3::Z * HALF, attitude, velocity, spin: turn * 1e-15 };
            let set = frictional_contacts::<4>(&world, &state, (0..4).collect(), Supports::NONE).unwrap();
            for law in [Law::Poisson, Law::Stronge] {
                let out = staged::resolve(&set, law).unwrap();
                for after in out.velocity {
                    let apart = (after.z - restitution * 1.7).abs();
                    assert!(
                        apart < 1e-10,
                        "{law:?}, e = {restitution}, turn {turn:?} times {size:e}: {after:?}"
                    );
                }
            }
        }
    }
}
