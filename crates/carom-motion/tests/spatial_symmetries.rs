//! Runs that are one another's images: mirrored, turned about the vertical, moved, renumbered, in other units.

#![allow(clippy::print_stdout, reason = "how far two runs differ is a measurement")]

use crate::bodies;
use crate::stools;

use carom_motion::spatial::{Body, End, Impact, Options, Run, State, Supports, World, run};
use carom_num::{Mat3, Rotation, Vec3};
use stools::runs;

/// Spins, of the largest of their run: a run of impacts amplifies rounding.
const SPIN: f64 = 1e-9;
/// Times, in the world's time.
const TIME: f64 = 1e-9;
/// Hops shorter than this, in the world's time, are of the height of rounding: their impacts, and what follows, are not compared.
const SHORT: f64 = 1e-5;
/// Impacts that are compared.
const MOST: u64 = 20;

fn options() -> Options {
    Options { most_impacts: MOST, most_time: 10.0, ..Options::default() }
}

/// Stools of the reference, and random bodies that strike and do not slide.
fn scenes() -> Vec<(World, State)> {
    let stools = runs().into_iter().map(|s| (World::new(s.body(), s.gravity()).unwrap(), s.start()));
    stools.chain((0..100).map(bodies::drawn)).collect()
}

fn body(of: &Body, change: impl Fn(Vec3) -> Vec3, inertia: Mat3) -> Body {
    Body::new(of.mass(), inertia, of.supports().iter().map(|r| change(*r)).collect()).unwrap()
}

/// How many impacts there are before the first that follows another too closely.
fn clear(world: &World, run: &Run) -> usize {
    let short = |pair: &[Impact]| pair[1].time - pair[0].time < SHORT * world.scales().time;
    run.impacts.windows(2).position(short).map_or(run.impacts.len(), |first| first + 1)
}

/// The largest differences of time and spin; `spin` and `kept` take those of the first run to the second's.
fn apart(
    world: &World,
    [a, b]: [&Run; 2],
    spin: impl Fn(Vec3) -> Vec3,
    kept: impl Fn(Supports) -> Supports,
) -> [f64; 2] {
    let count = clear(world, a);
    let mut worst = [0.0_f64; 2];
    if count == a.impacts.len() {
        assert_eq!((a.impacts.len(), name(&a.end)), (b.impacts.len(), name(&b.end)), "they end alike");
        worst[0] = (a.time - b.time).abs() / world.scales().time;
    }
    let largest = a.impacts.iter().map(|i| i.spin_before.norm()).fold(0.0, f64::max);
    for (a, b) in a.impacts[..count].iter().zip(&b.impacts) {
        assert_eq!(kept(a.kept), b.kept, "the same supports are kept");
        worst[0] = worst[0].max((a.time - b.time).abs() / world.scales().time);
        worst[1] = worst[1].max((spin(a.spin_after) - b.spin_after).norm() / largest);
    }
    worst
}

fn name(end: &End) -> std::mem::Discriminant<End> {
    std::mem::discriminant(end)
}

fn close(what: &str, all: impl Iterator<Item = [f64; 2]>) {
    let worst = all.fold([0.0_f64; 2], |w, a| [w[0].max(a[0]), w[1].max(a[1])]);
    println!("{what}: times to {:e}, spins to {:e}", worst[0], worst[1]);
    assert!(worst[0] < TIME && worst[1] < SPIN, "{what}: {worst:?}");
}

#[test]
fn a_mirrored_run_is_the_mirror_image() {
    let across = |r: Vec3| Vec3::new(r.x, -r.y, r.z);
    let axial = |w: Vec3| Vec3::new(-w.x, w.y, -w.z);
    let mirror = Mat3::diagonal(1.0, -1.0, 1.0);
    let all = scenes().into_iter().map(|(world, start)| {
        let inertia = mirror.product(world.body().inertia()).product(mirror);
        let image = World::new(body(world.body(), across, inertia), across(world.gravity())).unwrap();
        let begin = State {
            centre: across(start.centre),
            attitude: Rotation { w: start.attitude.w, v: axial(start.attitude.v) },
            velocity: across(start.velocity),
            spin: axial(start.spin),
        };
        let ours = run(&world, &start, &options(), &mut ()).unwrap();
        let theirs = run(&image, &begin, &options(), &mut ()).unwrap();
        apart(&world, [&ours, &theirs], axial, |kept| kept)
    });
    close("mirrored", all);
}

#[test]
fn a_run_does_not_know_north_nor_where_it_is() {
    let turn = Rotation::by(Vec3::Z * 2.1);
    let all = scenes().into_iter().map(|(world, start)| {
        let begin = State {
            centre: turn.apply(start.centre) + Vec3::new(3.0, -0.7, 0.0),
            attitude: turn.after(start.attitude),
            velocity: turn.apply(start.velocity),
            spin: start.spin,
        };
        let ours = run(&world, &start, &options(), &mut ()).unwrap();
        let theirs = run(&world, &begin, &options(), &mut ()).unwrap();
        apart(&world, [&ours, &theirs], |w| w, |kept| kept)
    });
    close("turned and moved", all);
}

#[test]
fn other_body_axes_and_numbers_of_supports_make_no_difference() {
    let turn = Rotation::by(Vec3::new(0.4, -1.3, 0.8));
    let all = scenes().into_iter().map(|(world, start)| {
        let own = world.body();
        let mut supports: Vec<Vec3> = own.supports().iter().map(|r| turn.apply(*r)).collect();
        supports.reverse();
        let inertia = turn.turn(own.inertia());
        let inertia = (inertia + inertia.transposed()) * 0.5;
        let image = World::new(Body::new(own.mass(), inertia, supports).unwrap(), world.gravity()).unwrap();
        let begin =
            State { attitude: start.attitude.after(turn.inverse()), spin: turn.apply(start.spin), ..start };
        let ours = run(&world, &start, &options(), &mut ()).unwrap();
        let theirs = run(&image, &begin, &options(), &mut ()).unwrap();
        let last = own.supports().len() - 1;
        let renumbered = |kept: Supports| kept.iter().map(|i| last - i).collect();
        apart(&world, [&ours, &theirs], |w| turn.apply(w), renumbered)
    });
    close("other axes", all);
}

#[test]
fn units_scale_out_to_the_last_bit() {
    // Four times the length under the same gravity: twice the time, half the spin. All are powers of two.
    for (world, start) in scenes() {
        let own = world.body();
        let large = Body::new(
            own.mass() * 8.0,
            own.inertia() * (8.0 * 16.0),
            own.supports().iter().map(|r| *r * 4.0).collect(),
        );
        let image = World::new(large.unwrap(), world.gravity()).unwrap();
        let begin = State {
            centre: start.centre * 4.0,
            velocity: start.velocity * 2.0,
            spin: start.spin * 0.5,
            ..start
        };
        let longer = Options { most_time: 2.0 * options().most_time, ..options() };
        let ours = run(&world, &start, &options(), &mut ()).unwrap();
        let theirs = run(&image, &begin, &longer, &mut ()).unwrap();
        assert_eq!((ours.end, ours.time * 2.0, ours.effort), (theirs.end, theirs.time, theirs.effort));
        for (a, b) in ours.impacts.iter().zip(&theirs.impacts) {
            assert_eq!((a.time * 2.0, a.kept), (b.time, b.kept));
            assert_eq!(a.spin_after * 0.5, b.spin_after);
        }
    }
}
