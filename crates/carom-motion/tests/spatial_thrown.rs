//! Throws that once never ended: bodies that chatter on to a face, slips that hardly stop, a slip that starts slowly.

use crate::thrown;

use carom_motion::spatial::{Budget, End, Mode, Options, Samples, State, World, forces, run};
use carom_num::elementary::{atan2, sin_cos};
use carom_num::{Mat3, Rotation, Vec3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;
use thrown::{Throw, Thrown};

/// What a closed series may be wrong by, in the world's time: a thousandth of 1e-5, which may be left of it.
const CLOSED: f64 = 1e-8;
/// Impacts after which none of these bodies still chatters.
const MOST_IMPACTS: usize = 600;
/// By what a slip lasts longer or shorter than by hand, as a fraction: its direction lags behind the one that friction lets it keep by some 1e-6 rad.
const LASTS: f64 = 1e-5;
/// Steps of the integration by hand [s]: a seven-hundredth of the slip that it follows.
const BY_HAND: f64 = 2e-6;
/// Directions closer than this are one, and what turns a slip less than this share of its growth does not [rad, 1]: what halvings leave.
const ONE_WAY: f64 = 1e-6;
/// How long a slip that starts is left alone before it is looked at \[s\]: a motion changes little by then.
const STARTED: f64 = 1e-6;
/// Direction and growth of a slip change with the motion, in so many units of its time by themselves.
const CHANGES: f64 = 100.0;
/// Random bodies that are thrown.
const THROWS: u64 = 60;

/// Corners numbered from another one on, and backwards: rounding alone differs.
#[test]
fn what_chatters_on_to_a_face_rests_on_it_however_its_corners_are_numbered() {
    let names = [
        "ellipsoid_of_27_corners",
        "pyramid_of_four_sides",
        "tetrahedron_that_bounces",
        "ellipsoid_of_21_corners",
        "pyramid_of_eight_sides",
        "cube_that_slips_a_little",
        "tetrahedron_that_starts_to_slip",
    ];
    for name in names {
        let mut first: Option<(f64, Vec<[f64; 3]>)> = None;
        for from in 0..2 {
            let thrown = Throw::named(name).renumbered(from).ready();
            let run = run(&thrown.world, &thrown.start, &Options::default(), &mut ()).unwrap();
            let End::AtRest { held } = run.end else { panic!("{name} from {from}: {:?}", run.end) };
            assert!(run.impacts.len() < MOST_IMPACTS, "{name}: {} impacts", run.impacts.len());
            let places = thrown.places(held);
            let (time, face) = first.get_or_insert((run.time, places.clone()));
            let apart = (run.time - *time).abs() / thrown.world.scales().time;
            // Each closing may be wrong by as much.
            let most = CLOSED * run.closings.len().max(1) as f64;
            assert!(apart <= most, "{name} from {from}: rests {apart:e} of the world's time away");
            assert_eq!(places, *face, "{name} from {from}: it lies on the same corners");
        }
    }
}

/// A pyramid rocks on the two slant edges of one side. Between two strikes its foot slides, sticks, and the next edge takes over: all of it in times that
/// shrink from strike to strike by one ratio, which its strikes alone say, with no series closed.
#[test]
fn slips_that_start_and_stop_between_strikes_do_not_hide_a_series() {
    let Thrown { world, start, .. } = Throw::named("pyramid_of_four_sides").ready();
    let unit = world.scales().time;
    let open = Options { closing: 1e-12, most_impacts: 17, ..Options::default() };
    let raw = run(&world, &start, &open, &mut ()).unwrap();
    assert!(raw.closings.is_empty() && raw.end == End::BudgetSpent(Budget::Impacts), "{:?}", raw.end);
    // The limit of a geometric series from its last three members (Aitken).
    let times: Vec<f64> = raw.impacts.iter().rev().take(3).map(|i| i.time).collect();
    let (late, early) = (times[0] - times[1], times[1] - times[2]);
    let limit = times[0] + late * late / (early - late);
    let closed = run(&world, &start, &Options::default(), &mut ()).unwrap();
    assert!(matches!(closed.end, End::AtRest { .. }), "{:?}", closed.end);
    let apart = (closed.time - limit).abs() / unit;
    assert!(apart < CLOSED, "{} and {limit}: {apart:e}", closed.time);
}

/// A coin of nine corners clatters to rest on its side: it lies on all nine, though no series of strikes has met them all.
#[test]
fn a_coin_rests_on_all_corners_of_its_side() {
    let ring = |z: f64| {
        (0..9).map(move |j| {
            let (sin, cos) = sin_cos(std::f64::consts::TAU * f64::from(j) / 9.0);
            Vec3::new(0.012 * cos, 0.012 * sin, z)
        })
    };
    let coin = Throw {
        friction: 0.3,
        restitution: 0.0,
        mass: 0.01,
        attitude: Rotation::by(Vec3::new(1.0, 0.3, 0.2).unit().unwrap() * 0.4),
        height: 0.01,
        velocity: Vec3::ZERO,
        spin: Vec3::ZERO,
        corners: ring(-0.001).chain(ring(0.001)).collect(),
    };
    let Thrown { hull, world, start } = coin.ready();
    let run = run(&world, &start, &Options::default(), &mut ()).unwrap();
    let End::AtRest { held } = run.end else { panic!("{:?}", run.end) };
    let mut corners: Vec<usize> = held.iter().collect();
    corners.sort_unstable();
    let sides = hull.faces().iter().map(|face| {
        let mut own = face.corners.clone();
        own.sort_unstable();
        own
    });
    assert!(corners.len() == 9 && sides.into_iter().any(|own| own == corners), "{corners:?}");
}

/// How a support of the free body accelerates by a force on it, and without any, world axes.
struct Foot {
    mass: f64,
    mobility: Mat3,
    arm: Vec3,
    free: Vec3,
    friction: f64,
}

impl Foot {
    fn of(world: &World, state: &State, support: usize) -> Self {
        let (body, turn) = (world.body(), state.attitude);
        let arm = turn.apply(body.supports()[support]);
        let spin = turn.apply(state.spin);
        let gyration = turn.apply(body.mobility() * -state.spin.cross(body.inertia() * state.spin));
        let free = world.gravity() + gyration.cross(arm) + spin.cross(spin.cross(arm));
        let friction = world.friction().unwrap().coefficient(support);
        Self { mass: body.mass(), mobility: turn.turn(body.mobility()), arm, free, friction }
    }

    fn by(&self, force: Vec3) -> Vec3 {
        force / self.mass + (self.mobility * self.arm.cross(force)).cross(self.arm)
    }

    /// Normal force, acceleration along the slip and across it, where it slips in this direction.
    fn slipping(&self, angle: f64) -> [f64; 3] {
        let (sin, cos) = sin_cos(angle);
        let (along, across) = (Vec3::new(cos, sin, 0.0), Vec3::new(-sin, cos, 0.0));
        let push = self.by(Vec3::Z - along * self.friction);
        let normal = -self.free.z / push.z;
        let acceleration = self.free + push * normal;
        [normal, acceleration.dot(along), acceleration.dot(across)]
    }

    /// The direction near this one, within a tenth of a radian, in which nothing turns the slip: halving.
    fn kept_direction(&self, near: f64) -> f64 {
        let (mut low, mut high) = (near - 0.1, near + 0.1);
        let rising = self.slipping(high)[2] > self.slipping(low)[2];
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if (self.slipping(middle)[2] > 0.0) == rising { high = middle } else { low = middle }
        }
        0.5 * (low + high)
    }
}

/// Attitude, spin in body axes and the speed of a slip.
type Sliding = [[f64; 4]; 2];

/// The rate of a motion on one foot that slides in the direction that it keeps, and that direction; it is near another.
fn slid(world: &World, support: usize, y: &Sliding, near: f64) -> (Sliding, f64) {
    let (body, attitude) = (world.body(), Rotation::of(y[0]).unwrap());
    let spin = Vec3::new(y[1][0], y[1][1], y[1][2]);
    let foot = Foot::of(world, &State::standing(body, support, attitude, spin), support);
    let angle = foot.kept_direction(near);
    let [normal, growth, _] = foot.slipping(angle);
    let (sin, cos) = sin_cos(angle);
    let force = attitude.undo((Vec3::Z - Vec3::new(cos, sin, 0.0) * foot.friction) * normal);
    let moment = body.supports()[support].cross(force) - spin.cross(body.inertia() * spin);
    let turning = body.mobility() * moment;
    ([attitude.rate(spin), [turning.x, turning.y, turning.z, growth]], angle)
}

fn runge_kutta(y: &Sliding, step: f64, rate: &mut impl FnMut(&Sliding) -> Sliding) -> Sliding {
    let moved = |k: &Sliding, h: f64| -> Sliding {
        std::array::from_fn(|i| std::array::from_fn(|j| y[i][j] + h * k[i][j]))
    };
    let a = rate(y);
    let b = rate(&moved(&a, 0.5 * step));
    let c = rate(&moved(&b, 0.5 * step));
    let d = rate(&moved(&c, step));
    let mean = |i: usize, j: usize| (a[i][j] + 2.0 * (b[i][j] + c[i][j]) + d[i][j]) / 6.0;
    std::array::from_fn(|i| std::array::from_fn(|j| y[i][j] + step * mean(i, j)))
}

/// A cube's foot comes to the edge of its cone, slips by less than a nanometre, and stops where friction holds it again by a thousandth.
///
/// Friction keeps a slip so slow in the one direction in which nothing turns it, whatever its speed: that leaves ordinary equations.
#[test]
fn a_slip_that_friction_only_just_stops_stops_for_good() {
    let Thrown { world, start, .. } = Throw::named("cube_that_slips_a_little").ready();
    let mut samples = Samples::default();
    run(&world, &start, &Options::default(), &mut samples).unwrap();
    let first = samples.pieces.iter().position(|p| matches!(p.mode, Mode::Pivot { .. })).unwrap();
    let [slips, after] = [&samples.pieces[first + 1], &samples.pieces[first + 2]];
    let Mode::Pivot { support, held: foot } = samples.pieces[first].mode else {
        panic!("it turns about a foot")
    };
    assert!(matches!(slips.mode, Mode::Slides { .. }), "it slips: {slips:?}");
    assert_eq!(after.mode, Mode::Pivot { support, held: foot }, "and sticks again");
    let held = forces(&world, after.mode, &after.start).unwrap().unwrap().friction_demand;
    assert!(held < 0.5 && held > 0.499, "friction 0.5 holds it, hardly: {held}");

    let needed =
        forces(&world, Mode::Pivot { support, held: foot }, &slips.start).unwrap().unwrap().forces[0].1;
    let mut angle = atan2(-needed.y, -needed.x);
    let start = slips.start;
    let mut y = [start.attitude.to_array(), [start.spin.x, start.spin.y, start.spin.z, 0.0]];
    let (mut time, step) = (0.0, BY_HAND);
    let stop = loop {
        let before = y;
        let mut rate = |y: &Sliding| {
            let (rate, kept) = slid(&world, support, y, angle);
            angle = kept;
            rate
        };
        y = runge_kutta(&y, step, &mut rate);
        let [_, [.., slow]] = y;
        if slow < 0.0 && time > 10.0 * step {
            break time + step * before[1][3] / (before[1][3] - slow);
        }
        time += step;
        assert!(time < 1e-2, "it never stops: {slow}");
    };
    let lasted = slips.end_time - slips.start_time;
    assert!((lasted - stop).abs() < LASTS * stop, "it slips for {lasted} s, by hand {stop}");
}

/// After its first strike the foot of a tetrahedron is at rest and friction cannot hold it. Of the directions in which nothing would turn its slip two let it
/// grow, one of which would need the plane to pull: it goes the other way.
#[test]
fn a_slip_starts_where_friction_lets_it_grow_and_the_plane_pushes() {
    let Thrown { world, start, .. } = Throw::named("tetrahedron_that_starts_to_slip").ready();
    let mut samples = Samples::default();
    let whole = run(&world, &start, &Options::default(), &mut samples).unwrap();
    assert!(matches!(whole.end, End::AtRest { .. }) && whole.impacts.len() < 10, "{:?}", whole.end);
    let piece = &samples.pieces[1];
    let Mode::Slides { slipping, .. } = piece.mode else { panic!("it slides: {piece:?}") };
    let support = slipping.iter().next().unwrap();
    let foot = Foot::of(&world, &piece.start, support);
    let mut ways = vec![];
    let steps = 720;
    for k in 0..steps {
        let near = std::f64::consts::TAU * f64::from(k) / f64::from(steps);
        let angle = foot.kept_direction(near);
        let [normal, growth, across] = foot.slipping(angle);
        let fresh = ways.iter().all(|(a, _): &(f64, f64)| (a - angle).abs() > ONE_WAY);
        if fresh && across.abs() < ONE_WAY * growth.abs() && growth > 0.0 && normal > 0.0 {
            ways.push((angle, growth));
        }
    }
    let [(angle, growth)] = ways[..] else { panic!("one way on: {ways:?}") };
    let (time, _, state) =
        samples.instants.iter().find(|(time, ..)| *time > piece.start_time + STARTED).unwrap();
    let slip = state.velocity_of(world.body().supports()[support]);
    let turned = atan2(slip.y, slip.x) - angle;
    let (sin, cos) = sin_cos(turned);
    let elapsed = time - piece.start_time;
    let near = CHANGES * elapsed / world.scales().time;
    assert!(atan2(sin, cos).abs() < near, "it goes {turned} rad beside {angle}, after {elapsed} s");
    assert!(
        (slip.norm() / elapsed / growth - 1.0).abs() < near,
        "{} m/s after {elapsed} s, {growth}",
        slip.norm()
    );
}

/// Bodies that are thrown: boxes, pyramids, prisms, and hulls of random points.
fn drawn(case: u64) -> Throw {
    let mut rng = Pcg64::seed_from_u64(case);
    let size = rng.random_range(0.01..0.05);
    let height = size * rng.random_range(0.3..1.5);
    let sides: u32 = rng.random_range(3..8);
    let mut vector = |size: f64| Vec3::from_array(std::array::from_fn(|_| rng.random_range(-size..size)));
    let ring = |z: f64| {
        (0..sides).map(move |j| {
            let (sin, cos) = sin_cos(std::f64::consts::TAU * f64::from(j) / f64::from(sides));
            Vec3::new(size * cos, size * sin, z)
        })
    };
    let corners: Vec<Vec3> = match case % 4 {
        0 => ring(0.0).chain([Vec3::Z * height]).collect(),
        1 => ring(0.0).chain(ring(height)).collect(),
        2 => (0..6).map(|_| vector(size)).collect(),
        _ => (0..20)
            .filter_map(|_| vector(1.0).unit())
            .map(|r| Vec3::new(r.x, 0.7 * r.y, 0.4 * r.z) * size)
            .collect(),
    };
    let (attitude, velocity, spin) = (Rotation::by(vector(3.0)), vector(0.7), vector(20.0));
    Throw {
        friction: rng.random_range(0.02..1.2),
        restitution: if case.is_multiple_of(3) { rng.random_range(0.0..0.6) } else { 0.0 },
        mass: 0.1,
        attitude,
        height: rng.random_range(0.0..0.1),
        velocity,
        spin,
        corners,
    }
}

#[test]
fn random_polyhedra_come_to_rest_before_their_budget_is_spent() {
    let restless: Vec<String> = (0..THROWS)
        .into_par_iter()
        .filter_map(|case| {
            let Thrown { world, start, .. } = drawn(case).ready();
            let run = run(&world, &start, &Options::default(), &mut ()).unwrap();
            // An impact whose walk is given up has a name of its own.
            let told =
                matches!(run.end, End::AtRest { .. } | End::NoConsistentOutcome(_) | End::Balanced { .. });
            (!told).then(|| format!("{case}: {:?} after {} impacts", run.end, run.impacts.len()))
        })
        .collect();
    assert!(restless.is_empty(), "{restless:?}");
}
