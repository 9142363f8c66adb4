//! Event functions that fall below zero and rise again within one step: both ends of the step see nothing.
//!
//! A stick that falls from the upright asks for most friction at cos θ = 9/11, and for less after that. With a little less friction than this its
//! foot slips backward there; with a little more it sticks on and slips forward, beyond cos θ = 2/3.

use carom_impact::Law;
use carom_motion::planar::trace::PieceEnd;
use carom_motion::planar::{self, Feature, Obstacle, Recorder, Shape, Twist, Walker};
use carom_motion::spatial::{self, Friction, Mode, Samples};
use carom_num::elementary::cos;
use carom_num::{Mat3, Rotation, Vec2, Vec3};
use carom_theory::falling_stick::{most_friction_behind, spin_squared_foot_fixed};

const G: f64 = 9.81;
const LEAN: f64 = 0.1;
/// How far friction is from its limit, as a fraction of it: the dip below zero is as deep, and as wide as the root of that.
const DEPTHS: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-8];
/// Where slip starts, for a dip as wide as the root of its depth [rad].
const NEAR: f64 = 3.0;

/// The tilt at which a stick of 1 m with this friction starts to slip.
type Slips = fn(f64) -> f64;

fn spin() -> f64 {
    spin_squared_foot_fixed(G, 1.0, 0.0, LEAN).sqrt()
}

/// In the plane, with its foot on this obstacle at the height 0.
fn in_the_plane(obstacle: Obstacle, of: fn(&Feature) -> bool) -> f64 {
    let half = Vec2::new(0.0, 0.5);
    let shape = Shape::new(vec![-half, half], 0.0).unwrap();
    let body = planar::Body { shape, mass: 1.0, inertia: 1.0 / 12.0 };
    let world = planar::World::of_one(Vec2::new(0.0, -G), body, vec![obstacle], Law::Poisson);
    // It falls to the right: its angle falls.
    let arm = Vec2::at_angle(std::f64::consts::FRAC_PI_2 - LEAN) * 0.5;
    let twist = Twist { velocity: arm.turned_left() * -spin(), spin: -spin() };
    let start = planar::State { pose: planar::Pose { centre: arm, angle: -LEAN }, twist };
    let mut walker = Walker::new(&world, start, vec![true], planar::Options::default()).unwrap();
    let mut recorder = Recorder::default();
    for _ in 0..2 {
        walker.advance(&mut recorder).unwrap();
    }
    let trace = recorder.into_trace();
    let piece = trace.pieces.iter().find(|piece| matches!(piece.ended_by, PieceEnd::StickLimit(_))).unwrap();
    let PieceEnd::StickLimit(held) = piece.ended_by else { panic!("it sticks until then") };
    assert!(of(&held.feature), "{:?}", held.feature);
    -piece.end.pose.angle
}

/// Its motion is known as a series in time.
fn on_a_floor(friction: f64) -> f64 {
    let floor = Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), friction, 0.0);
    in_the_plane(floor, |feature| matches!(feature, Feature::VertexOnFace { .. }))
}

/// On the round top of a post, where it stands on one point as well. Its motion is followed in steps.
fn on_a_post(friction: f64) -> f64 {
    let (radius, foot) = (0.01, Vec2::new(0.0, -2.0));
    let post = Shape::new(vec![foot, Vec2::new(0.0, -radius)], radius).unwrap();
    let post = Obstacle::of_shape(post, friction, 0.0);
    in_the_plane(post, |feature| matches!(feature, Feature::VertexOnEnd { .. }))
}

fn in_space(friction: f64) -> f64 {
    let third = 1.0 / 12.0;
    let inertia = Mat3::diagonal(third, third, 1e-3);
    let body = spatial::Body::new(1.0, inertia, vec![Vec3::Z * -0.5]).unwrap();
    let axis = Vec3::new(0.6, -0.8, 0.0);
    let start = spatial::State::standing(&body, 0, Rotation::by(axis * LEAN), axis * spin());
    let world =
        spatial::World::new(body, Vec3::Z * -G).unwrap().with_friction(Friction::new(friction)).unwrap();
    let mut samples = Samples::default();
    // Only the first piece is looked at: a slip that hardly starts is followed in many steps.
    let options = spatial::Options { most_time: 5.0, most_steps: 60, ..spatial::Options::default() };
    spatial::run(&world, &start, &options, &mut samples).unwrap();
    let first = &samples.pieces[0];
    assert!(matches!(first.mode, Mode::Pivot { .. }), "{:?}", first.mode);
    first.end.tilt(Vec3::Z)
}

#[test]
fn a_foot_slips_where_it_asks_for_a_little_more_friction_than_there_is() {
    let (tilt, most) = most_friction_behind();
    let walks: [(&str, Slips); 3] =
        [("along a series", on_a_floor), ("in steps", on_a_post), ("in space", in_space)];
    for (walk, slips) in walks {
        for depth in DEPTHS {
            let at = slips(most * (1.0 - depth));
            let before = tilt - at;
            assert!(before > 0.0 && before < NEAR * depth.sqrt(), "{walk}, {depth:e}: {at}, limit {tilt}");
            let beyond = slips(most * (1.0 + depth));
            assert!(cos(beyond) < 2.0 / 3.0, "{walk}, {depth:e}: {beyond}");
        }
    }
}
