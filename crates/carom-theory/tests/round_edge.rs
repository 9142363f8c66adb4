//! A part on a round edge: closed forms against Newton's and Euler's laws in the fixed frame, integrated with small steps.

use crate::integrate;

use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};
use carom_theory::round_edge::{RoundEdge, RoundEdgeMotion, RoundEdgeState};
use integrate::{step, until};

/// Some tens of roundings, as a fraction of the terms.
const ROUNDING: f64 = 1e-13;
/// What a closed form and an integration in thousands of steps may differ by, as a fraction.
const AGREEMENT: f64 = 1e-10;
/// Steps of the integrations [s]: their error, of the fourth power, is below rounding.
const STEP: f64 = 1e-4;
/// A small swing [rad]: its square is below what follows.
const SWING: f64 = 1e-6;
/// What the rounding of a pose leaves of so small a swing, as a fraction.
const OF_A_SWING: f64 = 1e-8;

const PART: RoundEdge =
    RoundEdge { mass: 1.3, inertia: 0.4, half_thickness: 0.2, edge_radius: 0.5, gravity: 9.81 };

/// Place and tilt of the mass centre in the frame of O, and their rates: x, y, θ, ẋ, ẏ, ω.
type Pose = [f64; 6];

/// What holds the part: friction opposite to its slip, as a share of N, or no slip.
#[derive(Clone, Copy)]
enum Hold {
    Drag(f64),
    Rolls,
}

fn pose(part: &RoundEdge, state: &RoundEdgeState) -> Pose {
    let (sin, cos) = libm::sincos(state.tilt);
    let up = part.edge_radius + part.half_thickness;
    let (along, across) = (state.offset_rate - up * state.tilt_rate, state.offset * state.tilt_rate);
    [
        -up * sin + state.offset * cos,
        up * cos + state.offset * sin,
        state.tilt,
        along * cos - across * sin,
        along * sin + across * cos,
        state.tilt_rate,
    ]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// N, F, the acceleration of the mass centre and the angular one, such that the lower face stays on the cylinder: the second
/// derivative of C·n vanishes, and where the part rolls that of the way of its lower face too. Solved by Cramer's rule from three
/// trials of the forces.
fn newton_euler(part: &RoundEdge, y: &Pose, hold: Hold) -> (f64, f64, [f64; 2], f64) {
    let (sin, cos) = libm::sincos(y[2]);
    let (n, t) = ([-sin, cos], [cos, sin]);
    let (centre, v, spin) = ([y[0], y[1]], [y[3], y[4]], y[5]);
    let arm = [part.edge_radius * n[0] - centre[0], part.edge_radius * n[1] - centre[1]];
    let under = |normal: f64, friction: f64| {
        let force = [0, 1].map(|i| normal * n[i] + friction * t[i]);
        let a = [force[0] / part.mass, force[1] / part.mass - part.gravity];
        (a, (arm[0] * force[1] - arm[1] * force[0]) / part.inertia)
    };
    let residuals = |normal: f64, friction: f64| {
        let (a, turning) = under(normal, friction);
        let gap =
            dot(a, n) - 2.0 * spin * dot(v, t) - turning * dot(centre, t) - spin * spin * dot(centre, n);
        let slip = match hold {
            Hold::Rolls => dot(a, t) + spin * dot(v, n) + part.half_thickness * turning,
            Hold::Drag(drag) => friction + drag * normal,
        };
        [gap, slip]
    };
    let base = residuals(0.0, 0.0);
    let [by_n, by_f] = [residuals(1.0, 0.0), residuals(0.0, 1.0)].map(|r| [r[0] - base[0], r[1] - base[1]]);
    let determinant = by_n[0] * by_f[1] - by_n[1] * by_f[0];
    let normal = (by_f[0] * base[1] - by_f[1] * base[0]) / determinant;
    let friction = (by_n[1] * base[0] - by_n[0] * base[1]) / determinant;
    let (a, turning) = under(normal, friction);
    (normal, friction, a, turning)
}

fn rate(part: &RoundEdge, y: &Pose, hold: Hold) -> Pose {
    let (_, _, a, turning) = newton_euler(part, y, hold);
    [y[3], y[4], y[5], a[0], a[1], turning]
}

fn close(ours: f64, theirs: f64, scale: f64, allowed: f64, what: &str) {
    assert!((ours - theirs).abs() <= allowed * scale, "{what}: {ours}, by steps {theirs}");
}

#[test]
fn forces_and_accelerations_obey_newton_and_euler_in_the_fixed_frame() {
    for i in 0..200_u32 {
        let wave = |k: f64| libm::sin(k * f64::from(i + 1));
        let tilt_rate = 2.0 * wave(1.3);
        let sliding =
            RoundEdgeState { offset: wave(0.7), tilt: wave(0.9), offset_rate: wave(1.1), tilt_rate };
        let rolling = RoundEdgeState { offset_rate: PART.edge_radius * tilt_rate, ..sliding };
        let drag = 0.4 * wave(1.7);
        for (state, hold, motion) in [
            (sliding, Hold::Drag(drag), PART.sliding(&sliding, drag)),
            (rolling, Hold::Rolls, PART.rolling(&rolling)),
        ] {
            let y = pose(&PART, &state);
            let (normal, friction, a, turning) = newton_euler(&PART, &y, hold);
            let (sin, cos) = libm::sincos(state.tilt);
            let (n, t) = ([-sin, cos], [cos, sin]);
            let (centre, v) = ([y[0], y[1]], [y[3], y[4]]);
            // s̈ is the second derivative of C·t.
            let along = dot(a, t) + 2.0 * tilt_rate * dot(v, n) + turning * dot(centre, n)
                - tilt_rate * tilt_rate * dot(centre, t);
            close(motion.normal_force, normal, 100.0, ROUNDING, "N");
            close(motion.friction_force, friction, 100.0, ROUNDING, "F");
            close(motion.tilt_acceleration, turning, 100.0, ROUNDING, "ω̇");
            close(motion.offset_acceleration, along, 100.0, ROUNDING, "s̈");
        }
    }
}

#[test]
fn a_part_that_rolls_has_the_spin_and_the_forces_of_an_integration() {
    for (offset, tilt_rate, end) in [(0.3, 0.0, -0.9), (0.4, 0.5, -1.2), (-0.5, 0.0, 0.8), (0.05, -1.0, -0.3)]
    {
        let start =
            RoundEdgeState { offset, tilt: 0.0, offset_rate: PART.edge_radius * tilt_rate, tilt_rate };
        let left = |y: &Pose| (end - y[2]) * end.signum();
        let (_, y) = until(pose(&PART, &start), STEP, &|y| rate(&PART, y, Hold::Rolls), &left);
        let spin_squared = y[5] * y[5];
        close(PART.rolling_rate_squared(&start, end), spin_squared, spin_squared, AGREEMENT, "ω²");
        let motion: RoundEdgeMotion = PART.rolling_at(&start, end);
        let (normal, friction, _, turning) = newton_euler(&PART, &y, Hold::Rolls);
        close(motion.normal_force, normal, 10.0, AGREEMENT, "N");
        close(motion.friction_force, friction, 10.0, AGREEMENT, "F");
        close(motion.tilt_acceleration, turning, 10.0, AGREEMENT, "ω̇");
        let there = RoundEdgeState {
            offset: PART.rolling_offset(&start, end),
            tilt: end,
            offset_rate: PART.edge_radius * y[5],
            tilt_rate: y[5],
        };
        for (ours, theirs) in pose(&PART, &there).iter().zip(&y) {
            close(*ours, *theirs, 1.0, AGREEMENT, "the pose");
        }
        close(PART.energy(&there), PART.energy(&start), PART.energy(&start), AGREEMENT, "energy");
    }
}

#[test]
fn friction_takes_the_energy_that_a_sliding_part_loses() {
    for (offset_rate, drag) in [(0.8, 0.3), (-0.8, -0.3), (0.8, 0.0)] {
        let start = RoundEdgeState { offset: 0.1, tilt: -0.2, offset_rate, tilt_rate: 0.0 };
        let of =
            |y: &[f64; 5]| RoundEdgeState { offset: y[0], tilt: y[1], offset_rate: y[2], tilt_rate: y[3] };
        let mut y = [start.offset, start.tilt, start.offset_rate, start.tilt_rate, 0.0];
        for _ in 0..1000 {
            y = step(y, STEP, &|y| {
                let (state, motion) = (of(y), PART.sliding(&of(y), drag));
                let work = -motion.friction_force * PART.slip(&state);
                [y[2], y[3], motion.offset_acceleration, motion.tilt_acceleration, work]
            });
        }
        assert!(PART.slip(&of(&y)) * offset_rate > 0.0, "it still slides: {y:?}");
        let lost = PART.energy(&start) - PART.energy(&of(&y));
        close(lost, y[4], PART.energy(&start), AGREEMENT, "lost energy");
        assert!(drag == 0.0 || y[4] > 0.1, "friction has worked: {}", y[4]);
    }
}

#[test]
fn a_sharp_edge_is_the_edge_of_a_plate() {
    let sharp = RoundEdge { edge_radius: 0.0, ..PART };
    let friction = 0.35;
    for (offset, tilt, offset_rate, tilt_rate) in
        [(0.2, -0.3, 0.7, -1.1), (0.4, 0.2, -0.7, 0.6), (-0.2, -0.6, 0.3, 1.4), (0.0, 0.0, -0.2, 0.0)]
    {
        let state = RoundEdgeState { offset, tilt, offset_rate, tilt_rate };
        let plate = PartOnEdge {
            mass: sharp.mass,
            inertia: sharp.inertia,
            half_thickness: sharp.half_thickness,
            friction,
            slope: 0.0,
            gravity: sharp.gravity,
        };
        let same = EdgeState { reach: offset, tilt: -tilt, slip: offset_rate, tilt_rate: -tilt_rate };
        let (ours, theirs) = (sharp.sliding(&state, friction.copysign(offset_rate)), plate.motion(&same));
        close(ours.normal_force, theirs.normal_force, 10.0, ROUNDING, "N");
        close(ours.offset_acceleration, theirs.slip_rate, 10.0, ROUNDING, "s̈ = r̈");
        close(ours.tilt_acceleration, -theirs.tilt_acceleration, 10.0, ROUNDING, "ω̇ = −φ̈");
        close(sharp.energy(&state), plate.energy(&same), 10.0, ROUNDING, "energy");
    }
}

#[test]
fn mirror_images_move_as_mirror_images() {
    let state = RoundEdgeState { offset: 0.3, tilt: -0.4, offset_rate: 0.7, tilt_rate: -0.9 };
    let mirrored = RoundEdgeState { offset: -0.3, tilt: 0.4, offset_rate: -0.7, tilt_rate: 0.9 };
    for (one, other) in [
        (PART.sliding(&state, 0.3), PART.sliding(&mirrored, -0.3)),
        (PART.rolling(&state), PART.rolling(&mirrored)),
    ] {
        assert_eq!(one.normal_force, other.normal_force, "N");
        assert_eq!(one.friction_force, -other.friction_force, "F");
        assert_eq!(one.tilt_acceleration, -other.tilt_acceleration, "ω̇");
        assert_eq!(one.offset_acceleration, -other.offset_acceleration, "s̈");
    }
}

#[test]
fn rolling_ends_where_the_needed_friction_reaches_what_there_is() {
    let start = RoundEdgeState { offset: 0.3, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    for friction in [0.25, 0.5, 1.0] {
        let tilt = PART.slip_tilt(&start, -1.5, friction).expect("it slips");
        close(PART.friction_needed(&start, tilt), friction, 1.0, ROUNDING, "needed there");
        let left = |y: &Pose| {
            let (normal, force, ..) = newton_euler(&PART, y, Hold::Rolls);
            friction * normal - force.abs()
        };
        let (_, y) = until(pose(&PART, &start), STEP, &|y| rate(&PART, y, Hold::Rolls), &left);
        close(tilt, y[2], 1.0, AGREEMENT, "the first tilt where it slips");
    }
    assert_eq!(PART.slip_tilt(&start, -1.5, 0.1), Some(0.0), "too little friction to begin with");
    let near = RoundEdgeState { offset: 0.05, ..start };
    assert_eq!(PART.slip_tilt(&near, -1.5, 1.0), None, "it turns back before");
    assert_eq!(PART.slip_tilt(&start, -0.1, 1.0), None, "not yet");
}

#[test]
fn small_oscillations_about_a_balance_take_their_time() {
    for tilt in [0.0, 0.3, -0.6] {
        let rate_squared = PART.rocking_rate_squared(tilt);
        let offset = PART.balance_offset(tilt) + PART.edge_radius * SWING;
        let start = RoundEdgeState { offset, tilt: tilt + SWING, offset_rate: 0.0, tilt_rate: 0.0 };
        // Half a period: unlike a quarter, the same to the first order of the swing.
        let (time, y) = until(
            step(pose(&PART, &start), STEP, &|y| rate(&PART, y, Hold::Rolls)),
            STEP,
            &|y| rate(&PART, y, Hold::Rolls),
            &|y| -y[5],
        );
        close(rate_squared.sqrt() * (time + STEP), core::f64::consts::PI, 1.0, OF_A_SWING, "half a period");
        close(y[2], tilt - SWING, SWING, 10.0 * SWING, "as far to the other side");
    }
    let thick = RoundEdge { half_thickness: 0.6, ..PART };
    assert!(thick.rocking_rate_squared(0.0) < 0.0, "thicker than the edge is round");
    assert!(PART.balance_stiffness(0.9) < 0.0 && PART.balance_stiffness(0.8) > 0.0, "cos²θ = c/ρ between");
}

#[test]
fn a_part_turns_back_below_the_largest_returning_offset_alone() {
    let limit = PART.largest_returning_offset().expect("it is thin");
    let level = |offset: f64| RoundEdgeState { offset, tilt: 0.0, offset_rate: 0.0, tilt_rate: 0.0 };
    for share in [0.1, 0.5, 0.9, 0.999] {
        for offset in [share * limit, -share * limit] {
            let tilt = PART.returning_tilt(offset).expect("it returns");
            assert!(tilt * offset < 0.0, "it rolls down: {tilt}");
            close(PART.rolling_rate_squared(&level(offset), tilt), 0.0, 1.0, ROUNDING, "it stops there");
            for part_of_the_way in [0.01, 0.3, 0.7, 0.99] {
                let spin = PART.rolling_rate_squared(&level(offset), part_of_the_way * tilt);
                assert!(spin > 0.0, "and not before: {spin}");
            }
        }
    }
    let over = level(limit * 1.001);
    assert_eq!(PART.returning_tilt(over.offset), None, "beyond the limit");
    for i in 1..=150_u32 {
        let spin = PART.rolling_rate_squared(&over, -0.01 * f64::from(i));
        assert!(spin > 0.0, "it goes on at {i}: {spin}");
    }
    let thick = RoundEdge { half_thickness: 0.5, ..PART };
    assert_eq!((thick.largest_returning_offset(), thick.overturning_tilt()), (None, None), "c = ρ");
}

#[test]
fn a_balanced_part_rolls_back_from_below_the_overturning_tilt() {
    let over = PART.overturning_tilt().expect("stable");
    let acceleration = |tilt: f64| {
        let offset = PART.edge_radius * tilt;
        PART.rolling(&RoundEdgeState { offset, tilt, offset_rate: 0.0, tilt_rate: 0.0 }).tilt_acceleration
    };
    for i in 1..100_u32 {
        assert!(acceleration(over * f64::from(i) / 100.0) < 0.0, "back, {i}");
    }
    close(acceleration(over), 0.0, 10.0, ROUNDING, "balanced");
    assert!(acceleration(over * 1.001) > 0.0, "and on");
}
