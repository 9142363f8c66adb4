//! Painlevé's paradox in space: contacts that friction drives in together.

use carom_impact::spatial::{ContactSet, RigidBody, Touch, staged};
use carom_impact::{Law, planar};
use carom_num::{Mat3, Vec2, Vec3};

/// Half the length, the width and the height of a box of 1 kg [m], and its moment of inertia about the axis across.
const HALF: Vec3 = Vec3::new(1.0, 0.7, 1.0);
const ACROSS: f64 = (HALF.x * HALF.x + HALF.z * HALF.z) / 3.0;

/// A box that slides on its face with 1 m/s.
fn sliding(friction: f64) -> ContactSet<4> {
    let Vec3 { x, y, z } = HALF;
    let inertia = Mat3::diagonal((y * y + z * z) / 3.0, ACROSS, (x * x + y * y) / 3.0);
    let body = RigidBody { mass: 1.0, inertia, velocity: Vec3::X, spin: Vec3::ZERO };
    let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]];
    let touch = |[a, b]: [f64; 2]| Touch {
        arm: Vec3::new(a * x, b * y, -z),
        normal: Vec3::Z,
        friction,
        restitution: 0.2,
    };
    ContactSet::of_free_body(&body, &corners.map(touch)).unwrap()
}

/// The same in the plane: its rear and its front.
fn in_the_plane(friction: f64) -> planar::ContactSet2 {
    let touch = |x: f64| planar::Touch {
        arm: Vec2::new(x * HALF.x, -HALF.z),
        normal: Vec2::new(0.0, 1.0),
        friction,
        restitution: 0.2,
    };
    let velocity = Vec2::new(1.0, 0.0);
    planar::ContactSet2::of_free_body(1.0, ACROSS, velocity, 0.0, &[touch(-1.0), touch(1.0)]).unwrap()
}

/// A box that trips over its front edge: both corners of the edge take what the one front takes in the plane, half of it each.
#[test]
fn both_corners_of_an_edge_are_driven_in() {
    for friction in [1.7, 2.0, 3.0, 4.0, 9.0] {
        let flat = planar::staged::resolve(&in_the_plane(friction), Law::Poisson).unwrap();
        let solid = staged::resolve(&sliding(friction), Law::Poisson).unwrap();
        assert!(flat.impulse[1][1] > 0.1, "friction {friction}: {:?}", flat.impulse);
        for (k, p) in solid.impulse.iter().enumerate() {
            let [x, y] = flat.impulse[k / 2];
            let off = (p.z - 0.5 * y).abs().max(((p.x * p.x + p.y * p.y).sqrt() - 0.5 * x.abs()).abs());
            assert!(off < 1e-12, "friction {friction}, corner {k}: {p:?} of {x} {y}");
        }
    }
}
