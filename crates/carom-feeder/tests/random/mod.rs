//! Random feeders: convex parts of any kind, two to six plates, walls, any friction and restitution.

use carom_feeder::{Feeder, Part, PartKind, Plate, Start, Stop, Wall};
use carom_impact::Law;
use carom_motion::planar::{Body, Shape};
use carom_num::Vec2;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// A random convex polygon about its mass centre: points on a stretched circle, sorted by angle.
fn polygon(rng: &mut Pcg64, size: f64) -> Option<Shape> {
    let k = rng.random_range(3..9);
    let stretch = rng.random_range(0.02..1.0);
    let mut angles: Vec<f64> = (0..k).map(|_| rng.random_range(0.0..std::f64::consts::TAU)).collect();
    angles.sort_by(f64::total_cmp);
    let points: Vec<Vec2> = angles
        .iter()
        .map(|a| Vec2::at_angle(*a))
        .map(|p| Vec2::new(p.x * size, p.y * size * stretch))
        .collect();
    let area = |i: usize| points[i].cross(points[(i + 1) % k]);
    let total: f64 = (0..k).map(area).sum();
    let centroid =
        (0..k).fold(Vec2::ZERO, |c, i| c + (points[i] + points[(i + 1) % k]) * (area(i) / (3.0 * total)));
    let radius = if rng.random_bool(0.3) { size * rng.random_range(0.001..0.2) } else { 0.0 };
    let shape = Shape::new(points.iter().map(|p| *p - centroid).collect(), radius).ok()?;
    let smallest = (0..k).map(|i| shape.face(i)).map(|(a, b)| (b - a).norm()).fold(f64::INFINITY, f64::min);
    (smallest > 1e-3 * size && total > 1e-3 * size * size).then_some(shape)
}

fn part(rng: &mut Pcg64) -> Part {
    let size = rng.random_range(0.01..0.1);
    let mass = rng.random_range(0.01..1.0);
    let (kind, shape) = match rng.random_range(0..6) {
        0 => (PartKind::Rod, Shape::new(vec![Vec2::new(-size, 0.0), Vec2::new(size, 0.0)], 0.0).ok()),
        1 => (PartKind::Disc, Shape::new(vec![Vec2::ZERO], size).ok()),
        2 => {
            let h = size * rng.random_range(0.01..1.0);
            let corners = [(-size, -h), (size, -h), (size, h), (-size, h)].map(|(x, y)| Vec2::new(x, y));
            (PartKind::Box, Shape::new(corners.to_vec(), 0.0).ok())
        }
        3 => {
            let radius = size * rng.random_range(0.05..0.5);
            (PartKind::Rod, Shape::new(vec![Vec2::new(-size, 0.0), Vec2::new(size, 0.0)], radius).ok())
        }
        _ => (PartKind::Polygon, polygon(rng, size)),
    };
    match shape {
        Some(shape) => {
            let inertia = mass * shape.size().powi(2) * rng.random_range(0.1..0.5);
            Part { kind, body: Body { shape, mass, inertia } }
        }
        None => part(rng),
    }
}

/// A feeder from a seed: the same for the same seed.
pub(crate) fn feeder(seed: u64) -> Feeder {
    let rng = &mut Pcg64::seed_from_u64(seed);
    let part = part(rng);
    let size = part.body.shape.size();
    let bouncy = rng.random_bool(0.5);
    let surface =
        |rng: &mut Pcg64| (rng.random_range(0.0..1.0), if bouncy { rng.random_range(0.0..1.0) } else { 0.0 });
    let count = rng.random_range(2..7);
    let (mut plates, mut walls) = (vec![], vec![]);
    let mut right = true;
    let mut edge = Vec2::ZERO;
    for i in 0..count {
        let slope: f64 = rng.random_range(0.05..1.0);
        let down = Vec2::at_angle(if right { -slope } else { std::f64::consts::PI + slope });
        let length = size * rng.random_range(3.0..12.0);
        if i > 0 {
            let drop = size * rng.random_range(2.1..8.0);
            let beyond = size * rng.random_range(0.5..3.0);
            let hit = edge + Vec2::new(if right { -beyond } else { beyond }, -drop);
            edge = hit + down * (length * rng.random_range(0.3..0.9));
        }
        let (friction, restitution) = surface(rng);
        plates.push(Plate {
            name: format!("p{i}"),
            uphill: edge - down * length,
            edge,
            friction,
            restitution,
            unbounded: false,
            form: Default::default(),
        });
        right = !right;
    }
    if rng.random_bool(0.6) {
        let lowest = plates.iter().map(|p| p.edge.y).fold(0.0, f64::min) - 3.0 * size;
        let highest = plates[0].uphill.y + 5.0 * size;
        let far = |side: f64| {
            plates.iter().flat_map(|p| [p.uphill.x, p.edge.x]).map(|x| x * side).fold(0.0, f64::max) * side
        };
        for side in [-1.0, 1.0] {
            let x = far(side) + side * size * rng.random_range(0.0..3.0);
            let (friction, restitution) = surface(rng);
            walls.push(Wall {
                name: format!("w{side}"),
                from: Vec2::new(x, lowest),
                to: Vec2::new(x, highest),
                friction,
                restitution,
                form: Default::default(),
            });
        }
    }
    let faces = part.body.shape.faces().max(1);
    let to_edge = (plates[0].edge - plates[0].uphill).norm() * rng.random_range(0.2..0.8);
    let start = Start { to_edge, speed: rng.random_range(0.0..1.0), face: rng.random_range(0..faces) };
    let law = [Law::Poisson, Law::Stronge][(rng.next_u32() % 2) as usize];
    let stop = if rng.random_bool(0.5) { Stop::Landed } else { Stop::Delivered };
    Feeder { gravity: 9.81, stop, law, part, start, plates, walls }
}
