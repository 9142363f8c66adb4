//! Bodies that roll on circles: discs, coins and cylinders, against closed forms.

use crate::bodies::{on, ran};

use carom_motion::spatial::{
    Body, Budget, End, Feature, Friction, Mode, Options, Samples, State, Supports, World, run,
};
use carom_num::elementary::{cos, sin};
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::spatial::{Ball, RollingDisc};
use std::f64::consts::TAU;

const G: f64 = 9.81;
const COIN: RollingDisc =
    RollingDisc { mass: 0.0075, radius: 0.0115, axial: 4.96e-7, across: 2.48e-7, gravity: G };

/// A body without thickness, on a circle about its mass centre.
fn disc(RollingDisc { mass, radius, axial, across, .. }: RollingDisc) -> Body {
    let inertia = Mat3::diagonal(across, across, axial);
    Body::of(mass, inertia, vec![Feature::circle(Vec3::ZERO, Vec3::Z, radius)]).unwrap()
}

/// A disc on its lowest place, that is turned about x by θ, with a spin in world axes.
fn leaning(body: &Body, tilt: f64, spin: Vec3) -> State {
    let attitude = Rotation::by(Vec3::X * tilt);
    State::standing(body, 0, attitude, attitude.undo(spin))
}

#[test]
fn a_disc_whirls_about_a_centre_that_stays() {
    let world = on(disc(COIN), Vec3::Z * -G, 20.0);
    for tilt in [0.02_f64, 0.1, 0.5, 1.0] {
        let rate = COIN.whirls(tilt).unwrap();
        let axis = Rotation::by(Vec3::X * tilt).apply(Vec3::Z);
        // The spin along the diameter to what touches: that of the normal, less its part along the axis.
        let spin = (Vec3::Z - axis * cos(tilt)) * rate;
        let start = leaning(world.body(), tilt, spin);
        let period = TAU / rate;
        let (end, samples) = ran(&world, &start, 3.0 * period);
        assert_eq!(end.end, End::BudgetSpent(Budget::Time), "{tilt}");
        let rolls = Mode::Slides { sticking: Supports::one(0), slipping: Supports::NONE };
        assert!(samples.pieces.iter().all(|p| p.mode == rolls), "{tilt}: {:?}", samples.pieces);
        let (gone, now) = ((end.state.centre - start.centre).norm(), end.state.attitude.apply(Vec3::Z));
        assert!(gone < 1e-9 * COIN.radius, "{tilt}: {gone:e}");
        // After whole periods the axis is where it was.
        assert!((now - axis).norm() < 1e-9, "{tilt}: {:e}", (now - axis).norm());
        assert!(end.drift < 1e-11, "{tilt}: {:e}", end.drift);
    }
}

#[test]
fn a_coin_rolls_on_its_rim_around_a_circle() {
    let world = on(disc(COIN), Vec3::Z * -G, 20.0);
    for (tilt, rate) in [(1.2_f64, 9.0), (0.9, 25.0), (1.5, -4.0), (0.4, 60.0)] {
        let own = COIN.axial_spin(tilt, rate).unwrap();
        let axis = Rotation::by(Vec3::X * tilt).apply(Vec3::Z);
        let spin = (Vec3::Z - axis * cos(tilt)) * rate + axis * own;
        let start = leaning(world.body(), tilt, spin);
        let (period, part) = (TAU / rate.abs(), 0.37);
        let (end, _) = ran(&world, &start, part * period);
        let around = Rotation::by(Vec3::Z * (part * TAU * rate.signum()));
        // The centre of the circle, from that of the disc.
        let to_middle = Vec3::Z.cross(start.velocity) / rate;
        let expected = start.centre + to_middle - around.apply(to_middle);
        let off = (end.state.centre - expected).norm() / COIN.radius;
        let leans = (end.state.attitude.apply(Vec3::Z) - around.apply(axis)).norm();
        assert!(off < 1e-9 && leans < 1e-9, "{tilt}, {rate}: {off:e}, {leans:e}");
        assert!((to_middle.norm() - (COIN.radius * own / rate).abs()).abs() < 1e-12, "{tilt}, {rate}");
    }
}

/// A cylinder across a slope, and askew on it: it rolls along its own direction, and the rest of gravity is held.
#[test]
fn a_cylinder_rolls_down_a_slope() {
    let (mass, radius, half) = (0.4, 0.02, 0.05);
    let axial = 0.5 * mass * radius * radius;
    let across = 0.5 * axial + mass * half * half / 3.0;
    let inertia = Mat3::diagonal(across, axial, across);
    let features = [-half, half].map(|y| Feature::circle(Vec3::Y * y, Vec3::Y, radius)).to_vec();
    let theory = Ball { radius, share: 0.5, friction: 0.6, gravity: G };
    for (slope, askew) in [(0.1_f64, 0.0), (0.4, 0.3), (0.3, -1.2), (0.4, 0.9)] {
        let body = Body::of(mass, inertia, features.clone()).unwrap();
        let gravity = Vec3::new(sin(slope), 0.0, -cos(slope)) * G;
        let world = on(body, gravity, theory.friction);
        let attitude = Rotation::by(Vec3::Z * askew).after(Rotation::by(Vec3::Y * 0.7));
        let start = State::standing(world.body(), 0, attitude, Vec3::ZERO);
        let (end, samples) = ran(&world, &start, 0.8);
        let both = Mode::Slides { sticking: (0..2).collect(), slipping: Supports::NONE };
        assert!(samples.pieces.iter().all(|p| p.mode == both), "{slope}, {askew}: {:?}", samples.pieces);
        let down = theory.rolls_down(0.0, slope).unwrap() * cos(askew);
        let along = Rotation::by(Vec3::Z * askew).apply(Vec3::X);
        let off = end.state.centre - start.centre - along * (0.5 * down * 0.64);
        let spin = end.state.spin - Vec3::Y * (down * 0.8 / radius);
        assert!(off.norm() < 1e-10 && spin.norm() < 1e-9, "{slope}, {askew}: {off:?}, {spin:?}");
    }
}

/// Energy stays while a coin tumbles on its rim, and no place of the rim is ever under the plane.
#[test]
fn a_thrown_coin_stays_above_the_plane() {
    let (half, rim) = (0.0012, COIN.radius);
    let features = [-half, half].map(|z| Feature::circle(Vec3::Z * z, Vec3::Z, rim)).to_vec();
    let inertia = Mat3::diagonal(COIN.across, COIN.across, COIN.axial);
    let body = Body::of(COIN.mass, inertia, features).unwrap();
    let friction = Friction::new(0.3).with_restitution(0.5);
    let world = World::new(body, Vec3::Z * -G).unwrap().with_friction(friction).unwrap();
    let mut ends = vec![];
    for case in 0..60u32 {
        let one = |k: f64| 2.0 * (k * f64::from(case + 1)).fract() - 1.0;
        let start = State {
            centre: Vec3::Z * 0.05,
            attitude: Rotation::by(Vec3::new(one(0.618), one(0.414), one(0.732)) * 2.0),
            velocity: Vec3::new(one(0.236), one(0.302), one(0.645)),
            spin: Vec3::new(one(0.123), one(0.541), one(0.872)) * 60.0,
        };
        let mut samples = Samples::default();
        let options = Options { most_time: 0.4, most_impacts: 60, most_steps: 20_000, ..Options::default() };
        let out = run(&world, &start, &options, &mut samples).unwrap();
        assert!(out.drift < 1e-10, "{case}: {:e}", out.drift);
        let lowest = |state: &State| {
            let up = state.attitude.undo(Vec3::Z);
            let sine = up.cross(Vec3::Z).norm();
            state.centre.z - half * up.z.abs() - rim * sine
        };
        let deepest = samples.instants.iter().map(|(_, _, s)| lowest(s)).fold(0.0, f64::min);
        assert!(deepest > -1e-9 * rim, "{case}: {deepest:e}");
        ends.push((case, out.impacts.len(), out.end));
    }
    let upright = ends.iter().filter(|(.., end)| matches!(end, End::NoConsistentOutcome(_))).count();
    assert!(upright == 0, "{ends:?}");
}
