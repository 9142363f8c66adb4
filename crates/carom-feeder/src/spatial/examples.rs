//! Small feeders in space that examples and tests share.

use super::feeder::{CrossSection, Feeder, Plate, Start};
use super::part::Part;
use crate::feeder::Stop;
use crate::tolerance::BOX_HULL;
use carom_motion::spatial::Polyhedron;
use carom_num::{Mat3, Vec2, Vec3};

/// A box with these edges along x, y and z, uniform [m, kg]; face 0 is its lower one. Faces of x come first: −x, −y, −z and so on are told apart by their normals.
///
/// # Panics
/// Never for edges and a mass above 0.
pub fn block(edges: Vec3, mass: f64) -> Part {
    let half = |i: u32, axis: u32, edge: f64| if i >> axis & 1 == 1 { 0.5 * edge } else { -0.5 * edge };
    let corner = |i: u32| Vec3::new(half(i, 0, edges.x), half(i, 1, edges.y), half(i, 2, edges.z));
    let corners: Vec<Vec3> = (0..8).map(corner).collect();
    let square = |a: f64, b: f64| mass * (a * a + b * b) / 12.0;
    let inertia =
        Mat3::diagonal(square(edges.y, edges.z), square(edges.x, edges.z), square(edges.x, edges.y));
    let hull = Polyhedron::of_points(&corners, BOX_HULL * edges.norm())
        .unwrap_or_else(|_| unreachable!("a box has a hull"));
    let mut part = Part::about((&hull, 0.0), Vec3::ZERO, (mass, inertia))
        .unwrap_or_else(|_| unreachable!("a box is a body"));
    let lowest = part.faces.iter().position(|face| face.normal.y < -0.5).unwrap_or_default();
    part.faces.swap(0, lowest);
    part
}

/// A bar of 40 mm × 10 mm × 20 mm slides down a plate, over its end and onto a plate that slopes the other way.
pub fn two_plates() -> Feeder {
    let plate = |name: &str, uphill: (f64, f64), edge: (f64, f64)| Plate {
        name: name.to_owned(),
        uphill: Vec2::new(uphill.0, uphill.1),
        edge: Vec2::new(edge.0, edge.1),
        width: None,
        roll: 0.0,
        cross_section: CrossSection::Flat,
        edge_radius: 0.0,
        friction: 0.15,
        restitution: 0.0,
        unbounded: false,
    };
    Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Default::default(),
        part: block(Vec3::new(0.04, 0.01, 0.02), 0.06),
        start: Start { to_edge: 0.1, aside: 0.0, turn: 0.0, speed: 0.0, face: 0 },
        plates: vec![plate("upper", (-0.29, 0.08), (0.0, 0.0)), plate("lower", (0.3, -0.16), (-0.2, -0.24))],
        walls: vec![],
    }
}
