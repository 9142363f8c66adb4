//! On which faces boxes come to rest, and that no throw is lost.

#![allow(clippy::print_stdout, reason = "how often boxes rest on which face is a measurement")]

use carom_motion::spatial::{Body, Options, Polyhedron, State, Supports, World};
use carom_num::Vec3;
use carom_study::poses::{Plan, Pose, Poses, PosesError, attitude, direction, sample, thrown_in_space};

/// Of the lowest corner above the plane, by the shortest side.
const HEIGHT: f64 = 1.0;

struct Boxed {
    hull: Polyhedron,
    world: World,
}

fn boxed(sides: [f64; 3]) -> Boxed {
    let sign = |i: u32, k: u32| f64::from(2 * (i >> k & 1)) - 1.0;
    let corner = |i: u32| Vec3::from_array(std::array::from_fn(|k| 0.5 * sides[k] * sign(i, k as u32)));
    let hull = Polyhedron::of_points(&(0..8).map(corner).collect::<Vec<_>>(), 1e-10).unwrap();
    let solid = hull.solid().unwrap();
    let body = Body::new(solid.volume, solid.inertia, hull.vertices().to_vec()).unwrap();
    Boxed { hull, world: World::new(body, Vec3::Z * -1.0).unwrap() }
}

impl Boxed {
    fn release(&self, point: &[f64]) -> State {
        let attitude = attitude([point[0], point[1], point[2]]);
        let lowest =
            self.world.body().supports().iter().map(|r| attitude.apply(*r).z).fold(f64::INFINITY, f64::min);
        let spin = direction([point[3], point[4]]) * 0.5;
        State { centre: Vec3::Z * (HEIGHT - lowest), attitude, velocity: Vec3::ZERO, spin }
    }

    fn face_of(&self, held: Supports) -> Option<usize> {
        self.hull.faces().iter().position(|face| held.iter().all(|i| face.corners.contains(&i)))
    }

    fn thrown(&self, throws: u64, seed: u64) -> Poses {
        let plan = Plan { dimensions: 5, throws, seed };
        let options = Options { most_impacts: 1000, ..Options::default() };
        let faces: Vec<usize> = (0..6).collect();
        let throw = |point: &[f64]| {
            thrown_in_space((&self.world, &options), &self.release(point), |held| self.face_of(held))
        };
        sample(&plan, throw, &faces, || ()).unwrap()
    }

    /// Counts on the faces whose normals are along each axis, towards − and +.
    fn by_axis(&self, found: &Poses) -> [[u64; 2]; 3] {
        let mut counts = [[0; 2]; 3];
        for end in &found.ends {
            let Pose::Face(face) = end.pose else { continue };
            let normal = self.hull.faces()[face].normal.to_array();
            let axis = (0..3).max_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs())).unwrap();
            counts[axis][usize::from(normal[axis] > 0.0)] += end.probability.count;
        }
        counts
    }
}

/// True where counts that should be alike differ by no more than those of independent throws do: Sobol's points spread less.
fn alike(counts: &[u64]) -> bool {
    let mean = counts.iter().sum::<u64>() as f64 / counts.len() as f64;
    counts.iter().all(|count| (*count as f64 - mean).abs() <= 4.0 * mean.sqrt())
}

#[test]
fn a_cube_rests_on_every_face_alike() {
    let cube = boxed([1.0; 3]);
    let found = cube.thrown(128, 1);
    let counts: Vec<u64> = found.ends.iter().map(|end| end.probability.count).collect();
    println!(
        "cube, {} throws: {:?} {counts:?}",
        found.throws,
        found.ends.iter().map(|e| e.pose).collect::<Vec<_>>()
    );
    assert_eq!((found.throws, counts.iter().sum::<u64>()), (2048, 2048), "no throw is lost");
    let rest = found.resting.count;
    assert!(rest > 300, "{rest} come to rest");
    for end in found.ends.iter().take(6) {
        assert!(end.pose.is_face(), "{end:?}");
        // Independent throws would have this spread; Sobol's points have less.
        let mean = rest as f64 / 6.0;
        let off = (end.probability.count as f64 - mean).abs();
        assert!(off < 4.0 * (mean * 5.0 / 6.0).sqrt(), "{end:?} of {rest}");
        let of = end.of_resting.unwrap();
        assert!(of.low < of.share && of.share < of.high, "{of:?}");
        println!("  {:?}: {:.3} ({:.3} to {:.3}) of those at rest", end.pose, of.share, of.low, of.high);
    }
}

#[test]
fn a_cuboid_rests_on_faces_that_are_alike_alike() {
    for h in [0.25, 0.5, 1.0, 2.0] {
        let cuboid = boxed([1.0, 1.0, h]);
        let found = cuboid.thrown(64, 1);
        let [x, y, z] = cuboid.by_axis(&found);
        let rest: u64 = [x, y, z].concat().iter().sum();
        let share = z.iter().sum::<u64>() as f64 / rest as f64;
        println!(
            "1 × 1 × {h}: {rest} of {} throws at rest, {share:.3} of these on the two square faces",
            found.throws
        );
        assert_eq!(rest, found.resting.count, "every rest is on a face");
        assert_eq!(
            found.ends.iter().map(|end| end.probability.count).sum::<u64>(),
            found.throws,
            "none is lost"
        );
        assert!(alike(&z) && alike(&[x, y].concat()), "1 × 1 × {h}: {x:?} {y:?} {z:?}");
    }
}

#[test]
fn the_result_depends_on_the_seed_and_not_on_the_threads() {
    let brick = boxed([1.0, 0.7, 0.4]);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| brick.thrown(8, 3))
    };
    assert_eq!(on(1), on(3));
    assert_ne!(on(1), brick.thrown(8, 4), "another seed");
}

#[test]
fn plans_that_cannot_be_sampled_are_refused() {
    let cube = boxed([1.0; 3]);
    let sampled = |plan: &Plan| {
        let throw = |point: &[f64]| {
            thrown_in_space((&cube.world, &Options::default()), &cube.release(point), |_| None)
        };
        sample(plan, throw, &[], || ()).unwrap_err()
    };
    let plan = Plan { dimensions: 5, throws: 0, seed: 1 };
    assert_eq!(sampled(&plan), PosesError::Throws { found: 0, most: 1 << 24 });
    assert_eq!(sampled(&Plan { dimensions: 0, throws: 1, ..plan }), PosesError::Dimensions { found: 0 });
}
