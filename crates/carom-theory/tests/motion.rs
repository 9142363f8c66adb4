//! Sliding, tipping and falling: the equations of motion against energy, against each other and against the feeder of the literature.

use crate::integrate;
use crate::oracle;

use carom_theory::falling_stick::{
    floor_force_foot_fixed, floor_force_smooth, spin_squared_foot_fixed, spin_squared_smooth_floor,
};
use carom_theory::free_body::{FreeBody, PlanarVelocity, contact_velocity};
use carom_theory::incline::{Incline, tipping_offset_sliding};
use carom_theory::painleve::{critical_friction, window};
use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};
use carom_theory::rod_on_plate::{EndState, SlidingEnd};
use integrate::{step, until};
use oracle::Stream;

/// Some ten roundings, as a fraction of the terms.
const ROUNDING: f64 = 1e-14;
/// Steps of the classical Runge–Kutta method [s]: its error, of the fourth power of it, is below rounding.
const STEP: f64 = 1e-5;

/// The part of the published feeder, first case: 0.3 kg, 100 mm, 15°, friction 0.15.
fn feeder_part(thickness: f64) -> PartOnEdge {
    PartOnEdge {
        mass: 0.3,
        inertia: 2.5e-4,
        half_thickness: 0.5 * thickness,
        friction: 0.15,
        slope: f64::to_radians(15.0),
        gravity: 9.81,
    }
}

/// r, φ, ṙ, φ̇ and the work of friction.
fn edge_rate(part: &PartOnEdge, y: &[f64; 5]) -> [f64; 5] {
    let state = EdgeState { reach: y[0], tilt: y[1], slip: y[2], tilt_rate: y[3] };
    let motion = part.motion(&state);
    let dissipated = part.friction * motion.normal_force * y[2].abs();
    [y[2], y[3], motion.slip_rate, motion.tilt_acceleration, dissipated]
}

/// Slides 100 mm to the edge and tips until the trailing end arrives there: time of tipping, and the state.
fn tip(thickness: f64) -> (f64, [f64; 5]) {
    let part = feeder_part(thickness);
    let plate = Incline { slope: part.slope, friction: part.friction, gravity: part.gravity };
    let offset = tipping_offset_sliding(thickness, part.friction);
    let arrival = plate.slide(0.0, 0.1 - offset).expect("in the domain").expect("it slides");
    let start = [-offset, 0.0, arrival.speed, 0.0, 0.0];
    until(start, STEP, &|y| edge_rate(&part, y), &|y| 0.05 - y[0])
}

#[test]
fn the_published_part_slides_and_tips_as_integrated_elsewhere() {
    // Another program's integration of the same motion to ten digits; printed: 0.0879 s.
    for (thickness, seconds, degrees, slip, spin) in [
        (0.0, 0.087_840_508_373_9, 15.365_112_126_32, 0.750_144_811_721, 5.476_489_007_81),
        (0.001, 0.088_148_547_113_0, 15.478_657_153_25, 0.749_082_380_617, 5.486_946_143_13),
    ] {
        let (time, y) = tip(thickness);
        assert!((time - seconds).abs() < 1e-10, "{thickness} m: {time} s");
        assert!((y[1].to_degrees() - degrees).abs() < 1e-8, "{thickness} m: {}°", y[1].to_degrees());
        assert!((y[2] - slip).abs() < 1e-9 && (y[3] - spin).abs() < 1e-8, "{thickness} m: {y:?}");
    }
}

#[test]
fn friction_takes_the_energy_that_a_tipping_part_loses() {
    for thickness in [0.0, 0.001, 0.02] {
        let part = feeder_part(thickness);
        let energy =
            |y: &[f64; 5]| part.energy(&EdgeState { reach: y[0], tilt: y[1], slip: y[2], tilt_rate: y[3] });
        let start = [-0.5 * thickness * part.friction, 0.0, 0.4, 0.0, 0.0];
        let mut y = start;
        for _ in 0..8000 {
            y = step(y, STEP, &|y| edge_rate(&part, y));
        }
        let lost = energy(&start) - energy(&y);
        assert!(y[4] > 1e-3, "friction has worked: {}", y[4]);
        assert!((lost - y[4]).abs() < 1e-12, "{thickness} m: lost {lost}, friction {}", y[4]);
    }
}

#[test]
fn a_part_is_balanced_where_it_begins_to_tip() {
    let part = feeder_part(0.02);
    let at = |reach| part.motion(&EdgeState { reach, tilt: 0.0, slip: 0.4, tilt_rate: 0.0 });
    let offset = tipping_offset_sliding(0.02, part.friction);
    assert_eq!(at(-offset).tilt_acceleration, 0.0, "balanced");
    assert!(at(-offset + 1e-6).tilt_acceleration > 0.0, "tips beyond");
    assert!(at(-offset - 1e-6).tilt_acceleration < 0.0, "the plate holds it before");
    let plate = Incline { slope: part.slope, friction: part.friction, gravity: part.gravity };
    let difference = at(-offset).slip_rate - plate.sliding_acceleration();
    assert!(difference.abs() < 1e-15, "and it still slides as before: {difference:e}");
}

#[test]
fn arrival_obeys_uniform_acceleration_or_friction_stops_it() {
    let mut stream = Stream(15);
    let mut stopped = 0;
    for _ in 0..10_000 {
        let plate =
            Incline { slope: stream.within(0.0, 1.0), friction: stream.within(0.0, 1.0), gravity: 9.81 };
        let (speed, distance) = (stream.within(0.0, 2.0), stream.decades(-3.0, 1.0));
        let a = plate.sliding_acceleration();
        match plate.slide(speed, distance).expect("in the domain") {
            Some(there) => {
                let way = speed * there.time + 0.5 * a * there.time * there.time;
                // Close to the stop the time is a root of a small difference.
                assert!((way - distance).abs() <= 1e-13 * distance, "{way} {distance} {plate:?}");
                assert!((there.speed - speed - a * there.time).abs() <= 1e-12 * (speed + there.speed));
            }
            None => {
                assert!(speed * speed + 2.0 * a * distance <= 0.0, "{plate:?} {speed} {distance}");
                stopped += 1;
            }
        }
    }
    assert!(stopped > 1000, "both happen: {stopped}");
}

#[test]
fn the_response_of_a_sliding_end_is_that_of_a_free_body() {
    let mut stream = Stream(1895);
    for _ in 0..10_000 {
        let (mass, inertia, arm) =
            (stream.decades(-1.0, 1.0), stream.decades(-2.0, 1.0), stream.within(0.1, 2.0));
        let end = SlidingEnd { mass, inertia, arm, friction: stream.within(0.0, 3.0), gravity: [0.0, 9.81] };
        let state = EndState { angle: stream.within(-3.0, 3.0), spin: 0.0, slip: stream.sign() };
        let (sin, cos) = libm::sincos(state.angle);
        let w = FreeBody { mass, inertia }.operator([-arm * cos, -arm * sin]);
        let response = w.nn - state.slip * end.friction * w.tn;
        let scale = w.nn + end.friction * w.tn.abs();
        assert!((end.normal_response(&state) - response).abs() <= ROUNDING * scale, "{end:?} {state:?}");
    }
}

#[test]
fn a_sliding_end_loses_what_friction_takes() {
    let rod = SlidingEnd {
        mass: 0.3,
        inertia: 2.5e-4,
        arm: 0.05,
        friction: 0.3,
        gravity: [9.81 * 0.2, 9.81 * 0.9],
    };
    // x_K, θ, slip, spin, work of friction.
    let rate = |y: &[f64; 5]| {
        let motion = rod.motion(&EndState { angle: y[1], spin: y[3], slip: y[2] });
        let dissipated = rod.friction * motion.normal_force * y[2].abs();
        [y[2], y[3], motion.slip_rate, motion.spin_rate, dissipated]
    };
    let energy = |y: &[f64; 5]| {
        let (sin, cos) = libm::sincos(y[1]);
        let (vx, vy) = (y[2] - rod.arm * sin * y[3], rod.arm * cos * y[3]);
        let height = rod.arm * sin * rod.gravity[1] - (y[0] + rod.arm * cos) * rod.gravity[0];
        0.5 * rod.mass * (vx * vx + vy * vy) + 0.5 * rod.inertia * y[3] * y[3] + rod.mass * height
    };
    let start = [0.0, 1.2, 2.0, -1.0, 0.0];
    let mut y = start;
    for _ in 0..5000 {
        y = step(y, STEP, &rate);
    }
    assert!(y[2] > 0.0 && y[4] > 1e-2, "it still slides, and friction has worked: {y:?}");
    let lost = energy(&start) - energy(&y);
    assert!((lost - y[4]).abs() < 1e-11, "lost {lost}, friction {}", y[4]);
}

#[test]
fn the_response_vanishes_at_the_ends_of_painleves_window() {
    let mut stream = Stream(4);
    for _ in 0..1000 {
        let gyration = stream.decades(-2.0, 0.0);
        let friction = critical_friction(gyration) * stream.within(1.01, 3.0);
        let end = SlidingEnd { mass: 1.0, inertia: gyration, arm: 1.0, friction, gravity: [0.0, 9.81] };
        let response = |angle| end.normal_response(&EndState { angle, spin: 0.0, slip: -1.0 });
        let (low, high) = window(gyration, friction).expect("above the critical friction");
        let scale = 1.0 + (1.0 + friction) / gyration;
        assert!(response(low).abs() <= ROUNDING * scale, "{} {end:?}", response(low));
        assert!(response(high).abs() <= ROUNDING * scale, "{} {end:?}", response(high));
        assert!(response(0.5 * (low + high)) < 0.0, "inside {end:?}");
        assert!(response(low - 0.01) > 0.0 && response(high + 0.01) > 0.0, "outside {end:?}");
        assert_eq!(window(gyration, 0.999 * critical_friction(gyration)), None, "below");
    }
}

#[test]
fn a_falling_stick_obeys_the_equations_of_its_motion() {
    let (gravity, length) = (9.81, 0.7);
    let stick = SlidingEnd {
        mass: 2.0,
        inertia: 2.0 * length * length / 12.0,
        arm: 0.5 * length,
        friction: 0.0,
        gravity: [0.0, gravity],
    };
    for i in 1..30 {
        let tilt = 0.05 * f64::from(i);
        let spin = spin_squared_smooth_floor(gravity, length, 0.02, tilt).sqrt();
        let state = EndState { angle: core::f64::consts::FRAC_PI_2 - tilt, spin: -spin, slip: 0.0 };
        let weight = stick.mass * gravity;
        let force = floor_force_smooth(gravity, length, tilt, spin * spin);
        let general = stick.motion(&state).normal_force / weight;
        assert!((force - general).abs() < ROUNDING, "smooth floor at {tilt}: {force} {general}");

        // Foot fixed: the accelerations of the middle from θ̈ = (3g/2L) sin θ and θ̇².
        let (sin, cos) = libm::sincos(tilt);
        let squared = spin_squared_foot_fixed(gravity, length, 0.0, tilt);
        let turning = 1.5 * gravity / length * sin;
        let forward = 0.5 * length * (cos * turning - sin * squared) / gravity;
        let upward = 1.0 - 0.5 * length * (sin * turning + cos * squared) / gravity;
        let ours = floor_force_foot_fixed(tilt);
        assert!((ours.0 - forward).abs() < ROUNDING && (ours.1 - upward).abs() < ROUNDING, "at {tilt}");
    }
}

#[test]
fn an_impulse_changes_the_contact_velocity_by_the_operator() {
    let mut stream = Stream(3);
    for _ in 0..10_000 {
        let body = FreeBody { mass: stream.decades(-1.0, 1.0), inertia: stream.decades(-1.0, 1.0) };
        let mut pair = || [stream.within(-1.0, 1.0), stream.within(-1.0, 1.0)];
        let (arm, impulse, velocity) = (pair(), pair(), pair());
        let before = PlanarVelocity { first: velocity[0], second: velocity[1], spin: 0.7 };
        let after = body.after_impulse(before, arm, impulse);
        let change = body.operator(arm).velocity_change(impulse[0], impulse[1]);
        let (u, v) = (contact_velocity(before, arm), contact_velocity(after, arm));
        assert!((v[0] - u[0] - change.0).abs() < 1e-13, "t of {body:?}");
        assert!((v[1] - u[1] - change.1).abs() < 1e-13, "n of {body:?}");
        let gained = body.kinetic_energy(after) - body.kinetic_energy(before);
        let work = 0.5 * (impulse[0] * (u[0] + v[0]) + impulse[1] * (u[1] + v[1]));
        assert!((gained - work).abs() < 1e-12, "energy of {body:?}");
    }
}
