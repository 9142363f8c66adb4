//! Rounded bodies: balls, capsules and tops that slide and roll, against closed forms.

use crate::bodies::{on, ran};

use carom_motion::spatial::{Body, Feature, Mode, Plane, State, Supports};
use carom_num::elementary::{atan2, cos, sin};
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::spatial::{Ball, TippeTop};

const G: f64 = 9.81;
const SOLID: Ball = Ball { radius: 0.07, share: 0.4, friction: 0.3, gravity: G };

fn ball(Ball { radius, share, .. }: Ball, mass: f64) -> Body {
    let moment = share * mass * radius * radius;
    let inertia = Mat3::diagonal(moment, moment, moment);
    Body::of(mass, inertia, vec![Feature::point(Vec3::ZERO).rounded(radius)]).unwrap()
}

/// Gravity over the plane z = 0 that descends along x.
fn sloping(slope: f64) -> Vec3 {
    Vec3::new(sin(slope), 0.0, -cos(slope)) * G
}

#[test]
fn a_ball_rolls_or_slides_down_a_plane() {
    let theory = SOLID;
    let steepest = atan2(theory.steepest(0.0).unwrap(), 1.0);
    for slope in [0.1, 0.5, steepest - 1e-6, steepest + 1e-6, 1.0, 1.4] {
        let world = on(ball(theory, 1.3), sloping(slope), theory.friction);
        let start = State::standing(world.body(), 0, Rotation::by(Vec3::new(0.3, 1.0, -2.0)), Vec3::ZERO);
        let (end, samples) = ran(&world, &start, 1.0);
        let (rolls, down) = if slope < steepest {
            (true, theory.rolls_down(0.0, slope).unwrap())
        } else {
            (false, G * (sin(slope) - theory.friction * cos(slope)))
        };
        let one = Supports::one(0);
        let expected = if rolls {
            Mode::Slides { sticking: one, slipping: Supports::NONE }
        } else {
            Mode::Slides { sticking: Supports::NONE, slipping: one }
        };
        assert!(samples.pieces.iter().all(|p| p.mode == expected), "slope {slope}: {:?}", samples.pieces);
        let off = end.state.centre - start.centre - Vec3::X * (0.5 * down);
        assert!(off.norm() < 1e-11, "slope {slope}: {off:?}");
        let turning = if rolls {
            down / theory.radius
        } else {
            theory.friction * G * cos(slope) / (0.4 * theory.radius)
        };
        let spin = end.state.attitude.apply(end.state.spin) - Vec3::Y * turning;
        assert!(spin.norm() < 1e-9, "slope {slope}: {spin:?}");
    }
}

/// Its slip keeps its direction and slows down evenly until it rolls; its middle goes along a parabola meanwhile, and straight on after.
#[test]
fn a_thrown_ball_grips_after_a_parabola() {
    let theory = Ball { share: 0.45, friction: 0.2, ..SOLID };
    let world = on(ball(theory, 0.8), Vec3::Z * -G, theory.friction);
    for (velocity, spin) in [
        (Vec3::X * 3.0, Vec3::ZERO),
        (Vec3::X * 2.0, Vec3::new(40.0, -90.0, 30.0)),
        (Vec3::new(0.0, -1.0, 0.0), Vec3::new(-80.0, 10.0, 0.0)),
    ] {
        let attitude = Rotation::by(Vec3::new(1.0, -2.0, 0.4));
        let still = State::standing(world.body(), 0, attitude, Vec3::ZERO);
        let start = State { velocity, spin: attitude.undo(spin), ..still };
        let slip = velocity + spin.cross(Vec3::Z * -theory.radius);
        let (along, time) = (slip.unit().unwrap(), theory.grips_after(slip.norm()).unwrap());
        let brakes = along * (theory.friction * G);
        let (_, samples) = ran(&world, &start, 2.0 * time);
        let [slides, rolls] = &samples.pieces[..] else { panic!("{:?}", samples.pieces) };
        assert!((slides.end_time - time).abs() < 1e-11, "{} and {time}", slides.end_time);
        let gone = slides.end.centre - start.centre - velocity * time + brakes * (0.5 * time * time);
        assert!(gone.norm() < 1e-10, "{gone:?}");
        let after = velocity - brakes * time;
        let on = rolls.end.centre - slides.end.centre - after * (rolls.end_time - slides.end_time);
        assert!(on.norm() < 1e-10 && (rolls.end.velocity - after).norm() < 1e-10, "{on:?}");
        // What spins about the normal goes on.
        let yaw = rolls.end.attitude.apply(rolls.end.spin).z - spin.z;
        assert!(yaw.abs() < 1e-9, "{yaw}");
    }
}

#[test]
fn a_ball_rolls_down_a_groove() {
    let theory = Ball { friction: 0.5, ..SOLID };
    for flank in [0.2_f64, 0.7, 1.0] {
        let flanks =
            [1.0, -1.0].map(|y| Plane::new(Vec3::new(0.0, y * sin(flank), cos(flank)), 0.0).unwrap());
        let steepest = theory.steepest(flank).unwrap();
        for slope in [0.1, 0.4, atan2(steepest, 1.0) - 1e-6] {
            let world =
                on(ball(theory, 0.3), sloping(slope), theory.friction).among(flanks.to_vec()).unwrap();
            let attitude = Rotation::by(Vec3::new(0.2, 0.9, -0.5));
            let (centre, still) = (Vec3::Z * (theory.radius / cos(flank)), Vec3::ZERO);
            let start = State { centre, attitude, velocity: still, spin: still };
            let (end, samples) = ran(&world, &start, 0.7);
            let both = Mode::Slides { sticking: (0..2).collect(), slipping: Supports::NONE };
            assert!(samples.pieces.iter().all(|p| p.mode == both), "{flank}, {slope}: {:?}", samples.pieces);
            let down = theory.rolls_down(flank, slope).unwrap();
            let off = end.state.centre - centre - Vec3::X * (0.5 * down * 0.49);
            let turned = down * 0.7 / theory.lever(flank).unwrap();
            let spin = end.state.attitude.apply(end.state.spin) - Vec3::Y * turned;
            assert!(off.norm() < 1e-11 && spin.norm() < 1e-9, "{flank}, {slope}: {off:?}, {spin:?}");
        }
    }
}

/// A top whose mass centre is under the middle of its ball.
fn top(theory: &TippeTop) -> Body {
    let inertia = Mat3::diagonal(theory.across, theory.across, theory.axial);
    let ball = Feature::point(Vec3::Z * theory.offset).rounded(theory.radius);
    Body::of(theory.mass, inertia, vec![ball]).unwrap()
}

#[test]
fn a_top_keeps_what_jellett_and_routh_say() {
    let theory = TippeTop { mass: 0.02, radius: 0.02, offset: 0.004, axial: 3.1e-6, across: 2.7e-6 };
    for (friction, tilt, spin, rolls) in [
        (0.3, 0.1, Vec3::new(3.0, -2.0, 200.0), false),
        (10.0, 0.8, Vec3::new(10.0, 20.0, 40.0), true),
        (10.0, 2.0, Vec3::new(-5.0, 1.0, -30.0), true),
    ] {
        let world = on(top(&theory), Vec3::Z * -G, friction);
        let attitude = Rotation::by(Vec3::X * tilt);
        let start = State::standing(world.body(), 0, attitude, spin);
        let start = if rolls { start } else { State { velocity: Vec3::ZERO, ..start } };
        let (end, samples) = ran(&world, &start, 1.0);
        let kept = |state: &State| {
            let (s, u) = (state.spin, state.up());
            let (s, u) = ([s.x, s.y, s.z], [u.x, u.y, u.z]);
            [theory.jellett(s, u).unwrap(), theory.routh(s, u).unwrap()]
        };
        let ([jellett, routh], first) = (kept(&end.state), kept(&start));
        assert!((jellett / first[0] - 1.0).abs() < 1e-9, "Jellett {jellett:e}, {:e}", first[0]);
        assert!(end.drift < 1e-10, "{:e}", end.drift);
        let slid = samples
            .pieces
            .iter()
            .any(|p| matches!(p.mode, Mode::Slides { slipping, .. } if !slipping.is_empty()));
        assert_eq!(slid, !rolls, "{:?}", samples.pieces);
        if rolls {
            assert!((routh / first[1] - 1.0).abs() < 1e-9, "Routh {routh:e}, {:e}", first[1]);
        }
    }
}
