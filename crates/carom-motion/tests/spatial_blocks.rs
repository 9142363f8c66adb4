//! Random convex bodies that fall on plates and blocks, sharp and rounded: whether two convex solids overlap is told by separating axes, of which the engine knows nothing, and how far those
//! are apart that are rounded by the distances of all corners, edges and faces.

use carom_motion::spatial::{
    Body, Feature, Friction, Mode, Observer, Obstacle, Options, Piece, Plane, Polyhedron, State, World, run,
};
use carom_num::elementary::sin_cos;
use carom_num::segment::distance;
use carom_num::{Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

const CASES: u64 = 60;
const FLOOR: f64 = -0.4;
/// How deep one may be in the other, in units of the body's reach.
const DEPTH: f64 = 1e-9;
const DRIFT: f64 = 1e-10;

fn vector(rng: &mut Pcg64, size: f64) -> Vec3 {
    let mut one = || rng.random_range(-size..size);
    Vec3::new(one(), one(), one())
}

/// A convex solid, or a flat plate.
struct Solid {
    corners: Vec<Vec3>,
    normals: Vec<Vec3>,
    edges: Vec<Vec3>,
    /// The corners of each face, in their order.
    faces: Vec<Vec<Vec3>>,
}

impl Solid {
    fn of(shape: &Polyhedron) -> Self {
        let corners = shape.vertices().to_vec();
        let of = |face: &carom_motion::spatial::Face| face.corners.iter().map(|i| corners[*i]).collect();
        let faces: Vec<Vec<Vec3>> = shape.faces().iter().map(of).collect();
        let edges = faces.iter().flat_map(|face| sides(face)).map(|[a, b]| b - a).collect();
        Self { normals: shape.faces().iter().map(|face| face.normal).collect(), edges, corners, faces }
    }

    fn plate(corners: &[Vec3]) -> Self {
        let edges: Vec<Vec3> = sides(corners).map(|[a, b]| b - a).collect();
        let normals = vec![edges[0].cross(edges[1]).unit().unwrap()];
        Self { normals, edges, corners: corners.to_vec(), faces: vec![corners.to_vec()] }
    }

    /// How far two that are apart are from each other.
    fn distance(&self, other: &Self, state: &State) -> f64 {
        let placed = |face: &Vec<Vec3>| face.iter().map(|r| state.place(*r)).collect::<Vec<_>>();
        let own: Vec<Vec<Vec3>> = self.faces.iter().map(placed).collect();
        let corners: Vec<Vec3> = self.corners.iter().map(|r| state.place(*r)).collect();
        let mut least = f64::INFINITY;
        for (one, two) in own.iter().flat_map(|one| other.faces.iter().map(move |two| (one, two))) {
            let of_sides = sides(one).flat_map(|a| sides(two).map(move |b| distance(a, b)));
            least = of_sides.fold(least, f64::min);
        }
        let above = |faces: &[Vec<Vec3>], corners: &[Vec3]| {
            let pairs = faces.iter().flat_map(|face| corners.iter().map(move |r| over(face, *r)));
            pairs.fold(f64::INFINITY, f64::min)
        };
        least.min(above(&other.faces, &corners)).min(above(&own, &other.corners))
    }

    /// By how much they overlap, along the axis along which they do least: negative where they are apart.
    fn overlap(&self, other: &Self, state: &State) -> f64 {
        let own: Vec<Vec3> = self.corners.iter().map(|r| state.place(*r)).collect();
        let turned = |v: &Vec3| state.attitude.apply(*v);
        let crossed = self.edges.iter().flat_map(|a| other.edges.iter().map(move |b| (turned(a), *b)));
        let crossed = crossed.filter(|(a, b)| a.cross(*b).norm() > 1e-6 * a.norm() * b.norm());
        let across = crossed.filter_map(|(a, b)| a.cross(b).unit());
        let axes = self.normals.iter().map(turned).chain(other.normals.iter().copied()).chain(across);
        let range = |corners: &[Vec3], axis: Vec3| {
            let along = corners.iter().map(|r| axis.dot(*r));
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let overlap = |axis: Vec3| {
            let ([a, b], [c, d]) = (range(&own, axis), range(&other.corners, axis));
            (b - c).min(d - a)
        };
        axes.map(overlap).fold(f64::INFINITY, f64::min)
    }
}

fn sides(corners: &[Vec3]) -> impl Iterator<Item = [Vec3; 2]> {
    (0..corners.len()).map(|k| [corners[k], corners[(k + 1) % corners.len()]])
}

/// How far a place is from a face that it is above or below; infinite of others.
fn over(face: &[Vec3], place: Vec3) -> f64 {
    let normal = (face[1] - face[0]).cross(face[2] - face[1]).unit().unwrap();
    let inside = sides(face).all(|[a, b]| normal.cross(b - a).dot(place - a) >= 0.0);
    if inside { normal.dot(place - face[0]).abs() } else { f64::INFINITY }
}

/// How deep the body has come at most.
struct Deepest<'s> {
    own: &'s Solid,
    /// Of the balls about its corners.
    radius: f64,
    other: &'s Solid,
    deepest: f64,
    slides: usize,
}

impl Deepest<'_> {
    fn look(&mut self, state: &State) {
        let low = self.own.corners.iter().map(|r| state.place(*r).z).fold(f64::INFINITY, f64::min);
        let mut deep = self.own.overlap(self.other, state);
        if deep < 0.0 {
            deep = -self.own.distance(self.other, state);
        }
        self.deepest = self.deepest.max(deep + self.radius).max(FLOOR - low + self.radius);
    }
}

impl Observer for Deepest<'_> {
    fn sample(&mut self, _: f64, _: Mode, state: &State) {
        self.look(state);
    }

    fn piece(&mut self, piece: &Piece) {
        self.slides += usize::from(matches!(piece.mode, Mode::Slides { .. }));
    }

    fn is_dense(&self) -> bool {
        true
    }
}

/// Points of a box, of a prism or anywhere.
fn points(case: u64, rng: &mut Pcg64) -> Vec<Vec3> {
    let half = [0; 3].map(|_| rng.random_range(0.02..0.1));
    let side = |i: u32, bit: u32| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
    match case % 3 {
        0 => (0..8)
            .map(|i| Vec3::new(half[0] * side(i, 0), half[1] * side(i, 1), half[2] * side(i, 2)))
            .collect(),
        1 => (0..6).map(|_| vector(rng, 0.1)).collect(),
        _ => (0..10)
            .map(|i: u32| {
                let (sine, cosine) = sin_cos(std::f64::consts::TAU / 5.0 * f64::from(i / 2));
                Vec3::new(half[0] * cosine, half[0] * sine, half[1] * side(i, 0))
            })
            .collect(),
    }
}

/// A plate or a block.
fn obstacle(case: u64, rng: &mut Pcg64) -> (Obstacle, Solid) {
    if case.is_multiple_of(2) {
        let turn = Rotation::by(vector(rng, 0.5));
        let [w, h] = [0; 2].map(|_| rng.random_range(0.05..0.3));
        let corners = [(-w, -h), (w, -h), (w, h), (-w, h)].map(|(x, y)| turn.apply(Vec3::new(x, y, 0.0)));
        return (Obstacle::plate(&corners).unwrap(), Solid::plate(&corners));
    }
    let corners: Vec<Vec3> = (0..7).map(|_| vector(rng, 0.15)).collect();
    let block = Polyhedron::of_points(&corners, 1e-9).unwrap();
    (Obstacle::solid(&block), Solid::of(&block))
}

/// How deep, how far the energy drifts, how many impacts and slides.
fn falls(case: u64, rounded: bool) -> (f64, f64, usize, usize) {
    let mut rng = Pcg64::seed_from_u64(case + 44_000);
    let drawn = points(case, &mut rng);
    let solid = Polyhedron::of_points(&drawn, 1e-9).unwrap().solid().unwrap();
    let drawn: Vec<Vec3> = drawn.iter().map(|r| *r - solid.centre).collect();
    let own = Solid::of(&Polyhedron::of_points(&drawn, 1e-9).unwrap());
    let density = 0.5 / solid.volume;
    let radius = if rounded { rng.random_range(0.005..0.05) } else { 0.0 };
    let features = drawn.into_iter().map(|r| Feature::point(r).rounded(radius)).collect();
    let body = Body::of(0.5, solid.inertia * density, features).unwrap();
    let reach = body.reach();
    let friction = Friction::new(rng.random_range(0.0..0.8)).with_restitution(rng.random_range(0.0..0.5));
    let (obstacle, other) = obstacle(case, &mut rng);
    let floor = Plane::new(Vec3::Z, FLOOR).unwrap();
    let world = World::new(body, Vec3::Z * -9.81).unwrap().with_friction(friction).unwrap();
    let world = world.among(vec![obstacle, floor.into()]).unwrap();
    let start = State {
        centre: vector(&mut rng, 0.1) + Vec3::Z * 0.4,
        attitude: Rotation::by(vector(&mut rng, 3.0)),
        velocity: vector(&mut rng, 0.5),
        spin: vector(&mut rng, 8.0),
    };
    let mut seen = Deepest { own: &own, radius, other: &other, deepest: f64::NEG_INFINITY, slides: 0 };
    let options = Options { most_time: 0.6, ..Options::default() };
    let out = run(&world, &start, &options, &mut seen).unwrap_or_else(|e| panic!("case {case}: {e}"));
    for impact in &out.impacts {
        let gain = impact.kinetic_after / impact.kinetic_before - 1.0;
        assert!(gain < 1e-9, "case {case}: an impact at {} gains {gain:e}", impact.time);
    }
    (seen.deepest / reach, out.drift, out.impacts.len(), seen.slides)
}

fn none_comes_into_another(rounded: bool, [least_impacts, least_slides]: [usize; 2]) {
    let all: Vec<_> = (0..CASES).into_par_iter().map(|case| falls(case, rounded)).collect();
    for (case, (deepest, drift, ..)) in all.iter().enumerate() {
        assert!(*deepest < DEPTH, "case {case}: {deepest:e} deep");
        assert!(*drift < DRIFT, "case {case}: the energy drifts by {drift:e}");
    }
    let (impacts, slides) = all.iter().fold((0, 0), |(a, b), (_, _, i, s)| (a + i, b + s));
    assert!(impacts > least_impacts && slides > least_slides, "{impacts} impacts, {slides} slides");
}

#[test]
fn no_body_comes_into_a_plate_or_a_block() {
    none_comes_into_another(false, [1000, 100]);
}

#[test]
fn no_rounded_body_comes_into_a_plate_or_a_block() {
    none_comes_into_another(true, [1000, 100]);
}
