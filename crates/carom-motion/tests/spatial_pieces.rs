//! Bodies of several convex pieces, against closed forms, and against the same bodies of one.

use crate::bodies::ran;
use carom_motion::spatial::{Body, Friction, Mesh, Obstacle, Plane, Polyhedron, Run, State, World};
use carom_num::elementary::{cos, sin};
use carom_num::{Rotation, Vec3};
use carom_theory::hooked_part::HookedPart;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

const G: f64 = 9.81;
const MASS: f64 = 0.3;
/// Of both legs of an L \[m\].
const THICK: f64 = 0.008;
/// Between closed forms and the engine \[m, rad\].
const AS_THEORY: f64 = 1e-9;

/// A prism over a polygon in the plane of x and z, counter-clockwise as seen against y, cut into triangles: from −y to y.
fn prism(profile: &[(f64, f64)], triangles: &[[usize; 3]], y: f64) -> Mesh {
    let n = profile.len();
    let at = |y: f64| profile.iter().map(move |&(x, z)| Vec3::new(x, y, z));
    let mut facets: Vec<[usize; 3]> =
        triangles.iter().flat_map(|&[a, b, c]| [[a, b, c], [a + n, c + n, b + n]]).collect();
    for k in 0..n {
        let next = (k + 1) % n;
        facets.extend([[k, k + n, next], [next, k + n, next + n]]);
    }
    Mesh { vertices: at(-y).chain(at(y)).collect(), facets }
}

/// The body that fills a surface, cut into pieces; its mass centre in the axes of the surface.
fn filled(mesh: &Mesh, mass: f64) -> (Body, Vec3) {
    let solid = mesh.solid().unwrap();
    let vertices = mesh.vertices.iter().map(|r| *r - solid.centre).collect();
    let pieces = Mesh { vertices, facets: mesh.facets.clone() }.pieces(1e-12, 16).unwrap();
    (Body::of_pieces(mass, solid.inertia * (mass / solid.volume), &pieces, &[]).unwrap(), solid.centre)
}

/// The L of [`HookedPart::of_l`], drawn as there with z upwards, 20 mm deep.
fn l([p, q]: [f64; 2]) -> (Body, Vec3) {
    let w = THICK;
    let profile = [(0.0, -q), (w, -q), (w, w), (-p, w), (-p, 0.0), (0.0, 0.0)];
    filled(&prism(&profile, &[[0, 1, 2], [0, 2, 5], [2, 3, 5], [3, 4, 5]], 0.01), MASS)
}

fn among(body: Body, friction: f64, obstacles: Vec<Obstacle>) -> World {
    let world = World::new(body, Vec3::Z * -G).unwrap().with_friction(Friction::new(friction)).unwrap();
    world.among(obstacles).unwrap()
}

/// A thin plate below the y axis, turned from straight down towards x.
fn blade(angle: f64, half: f64) -> Obstacle {
    let down = Vec3::new(sin(angle), 0.0, -cos(angle)) * 0.1;
    let end = |y: f64| Vec3::Y * y;
    Obstacle::plate(&[end(-half), end(half), end(half) + down, end(-half) + down]).unwrap()
}

/// The L with its inner corner on the edge, at a tilt and at rest.
fn hanging(part: &HookedPart, tilt: f64) -> State {
    let centre = Vec3::new(sin(tilt), 0.0, -cos(tilt)) * part.arm;
    let attitude = Rotation::by(Vec3::Y * -(tilt + part.normals[0]));
    State { centre, attitude, velocity: Vec3::ZERO, spin: Vec3::ZERO }
}

#[test]
fn an_l_swings_about_the_edge_in_its_corner_like_a_pendulum() {
    for (legs, at, amplitudes) in
        [([0.06, 0.06], 0.0, [1e-4, 0.3, 0.7]), ([0.05, 0.09], -0.3, [1e-4, 0.1, 0.3])]
    {
        let part = HookedPart::of_l(MASS, legs, THICK, G);
        let (body, centre) = l(legs);
        assert!((centre.norm() - part.arm).abs() < 1e-15);
        assert!((body.inertia().rows[1].y - part.inertia).abs() < 1e-15);
        // The edge reaches out of the corner on both sides, or ends within it.
        for (friction, half) in [(0.0, 0.05), (0.3, 0.05), (0.0, 0.006), (0.3, 0.006)] {
            for amplitude in amplitudes {
                let period = part.period(amplitude).unwrap();
                let world = among(body.clone(), friction, vec![blade(at, half)]);
                for (share, back) in [(0.5, -amplitude), (1.0, amplitude)] {
                    let (run, samples) = ran(&world, &hanging(&part, amplitude), share * period);
                    let expected = hanging(&part, back);
                    let apart = (run.state.centre - expected.centre).norm();
                    let what = format!("{legs:?} {friction} {half} {amplitude}: {apart:e} {:?}", run.end);
                    assert!(apart < AS_THEORY && run.impacts.is_empty(), "{what}");
                    assert_eq!(samples.pieces.len(), 1, "{what}");
                }
            }
        }
    }
}

/// A T that hangs with its head on two rails, its stem between them, slides down as a block does on one plane.
#[test]
fn what_hangs_by_its_head_slides_down_two_rails() {
    let (slope, friction, time) = (0.4, 0.2, 0.3);
    let profile = [
        (-0.004, -0.03),
        (0.004, -0.03),
        (0.004, 0.0),
        (0.012, 0.0),
        (0.012, 0.006),
        (-0.012, 0.006),
        (-0.012, 0.0),
        (-0.004, 0.0),
    ];
    let triangles = [[0, 1, 2], [0, 2, 7], [3, 4, 2], [2, 4, 7], [7, 4, 5], [7, 5, 6]];
    let (body, centre) = filled(&prism(&profile, &triangles, 0.01), MASS);
    assert_eq!(body.supports().len(), 12, "eight of its head, four of its stem");
    let rail = |side: f64| {
        let end = |x: f64, y: f64| Vec3::new(side * x, y, 0.0);
        Obstacle::plate(&[end(0.005, -9.0), end(0.03, -9.0), end(0.03, 9.0), end(0.005, 9.0)]).unwrap()
    };
    let down = Vec3::new(0.0, -sin(slope), -cos(slope));
    let world = World::new(body, down * G).unwrap().with_friction(Friction::new(friction)).unwrap();
    let world = world.among(vec![rail(1.0), rail(-1.0)]).unwrap();
    let start = State { centre, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    let (run, samples) = ran(&world, &start, time);
    let way = 0.5 * G * (sin(slope) - friction * cos(slope)) * time * time;
    assert!((run.state.centre - centre + Vec3::Y * way).norm() < 1e-12, "{:?}", run.state);
    assert!(run.impacts.is_empty() && samples.pieces.len() == 1, "{:?}", samples.pieces);
}

/// A hull that comes down on the end of a plate, whole and cut by planes that go anywhere: where the cuts come out its faces are flush and its edges straight on.
#[test]
fn a_hull_that_is_cut_moves_as_the_whole_one() {
    let cases = 300;
    let compared = (0..cases).into_par_iter().map(|case| {
        let mut rng = Pcg64::seed_from_u64(case);
        let mut within = |low: f64, high: f64| rng.random_range(low..=high);
        let mut place = |x: f64, y: f64, z: f64| Vec3::new(within(-x, x), within(-y, y), within(-z, z));
        let points: Vec<Vec3> = (0..8).map(|_| place(0.03, 0.02, 0.01)).collect();
        let hull = Polyhedron::of_points(&points, 1e-12).unwrap();
        let Ok(solid) = hull.solid() else { return 0 };
        let hull = hull.moved_by(-solid.centre);
        let mut pieces = vec![hull.clone()];
        for _ in 0..1 + case % 3 {
            let normal = place(1.0, 1.0, 1.0).unit().unwrap();
            let cut = Plane::new(normal, place(0.003, 0.0, 0.0).x).unwrap();
            let back = Plane::new(-normal, cut.height(Vec3::ZERO)).unwrap();
            pieces = pieces
                .iter()
                .flat_map(|p| [cut, back].map(|half| p.behind(&half, 1e-12)))
                .flatten()
                .collect();
        }
        let inertia = solid.inertia * (MASS / solid.volume);
        let attitude = Rotation::by(place(3.0, 3.0, 3.0));
        let (velocity, spin) = (place(0.3, 0.3, 0.0), place(5.0, 5.0, 5.0));
        let start = State { centre: Vec3::new(place(0.02, 0.0, 0.0).x, 0.0, 0.05), attitude, velocity, spin };
        let friction =
            Friction::new(place(0.3, 0.0, 0.0).x + 0.3).with_restitution(0.2 + place(0.2, 0.0, 0.0).x);
        let moved = |pieces: &[Polyhedron]| {
            let body = Body::of_pieces(MASS, inertia, pieces, hull.vertices()).unwrap();
            let world = World::new(body, Vec3::Z * -G).unwrap().with_friction(friction.clone()).unwrap();
            let corners = [(-0.05, -0.05), (0.0, -0.05), (0.0, 0.05), (-0.05, 0.05)];
            let slope = Rotation::by(Vec3::Y * 0.3);
            let plate = Obstacle::plate(&corners.map(|(x, y)| slope.apply(Vec3::new(x, y, 0.0)))).unwrap();
            ran(&world.among(vec![plate]).unwrap(), &start, 0.25).0
        };
        let [whole, cut] = [moved(std::slice::from_ref(&hull)), moved(&pieces)];
        // Later ones go by what rounding leaves.
        let first = |run: &Run| run.impacts.iter().take(4).map(|impact| impact.time).collect::<Vec<_>>();
        let [a, b] = [first(&whole), first(&cut)];
        assert_eq!(a.len(), b.len(), "case {case}: {a:?} {b:?}");
        for (a, b) in a.iter().zip(&b) {
            assert!((a - b).abs() < AS_THEORY, "case {case}, {} pieces: {a} {b}", pieces.len());
        }
        a.len()
    });
    let impacts: usize = compared.sum();
    assert!(impacts > 2 * cases as usize, "{impacts}");
}
