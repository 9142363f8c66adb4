//! A disc in a circular chute: closed forms against Newton's and Euler's laws in the fixed frame, integrated with small steps.

use crate::integrate;

use carom_theory::circular_chute::CircularChute;
use integrate::until;

/// Some tens of roundings, as a fraction of the terms.
const ROUNDING: f64 = 1e-13;
/// What a closed form and an integration in thousands of steps may differ by, as a fraction.
const AGREEMENT: f64 = 1e-10;
/// Steps of the integrations [s]: their error, of the fourth power, is below rounding.
const STEP: f64 = 1e-4;
/// Half the width of a central difference [rad].
const HALF_WIDTH: f64 = 1e-5;
/// The error of such a difference: of the square of its half width, and rounding by it.
const OF_A_DIFFERENCE: f64 = 1e-9;

const CHUTE: CircularChute =
    CircularChute { mass: 0.7, inertia: 0.003, radius: 0.1, chute_radius: 0.6, gravity: 9.81 };

/// Centre of the disc from O, its velocity, and its spin: x, y, ẋ, ẏ, ω.
type Disc = [f64; 5];

fn disc(angle: f64, rate: f64, spin: f64) -> Disc {
    let (sin, cos) = libm::sincos(angle);
    let length = CHUTE.chute_radius - CHUTE.radius;
    [length * sin, -length * cos, length * rate * cos, length * rate * sin, spin]
}

fn angle_of(y: &Disc) -> f64 {
    libm::atan2(y[0], -y[1])
}

/// N and F that keep the centre at its distance from O, with a drag or (`None`) without a slip of the rim.
fn forces(y: &Disc, drag: Option<f64>) -> (f64, f64) {
    let length = libm::hypot(y[0], y[1]);
    // To the centre of the chute, and that turned 90° clockwise.
    let n = [-y[0] / length, -y[1] / length];
    let t = [n[1], -n[0]];
    let (m, a, g) = (CHUTE.mass, CHUTE.radius, CHUTE.gravity);
    let normal = m * ((y[2] * y[2] + y[3] * y[3]) / length + g * n[1]);
    // The rim's acceleration along t vanishes: F/m − g t_y + a²F/J = 0, since t turns with φ̇ and the way is along t.
    let friction = match drag {
        Some(drag) => -drag * normal,
        None => m * g * t[1] / (1.0 + m * a * a / CHUTE.inertia),
    };
    (normal, friction)
}

fn rate(y: &Disc, drag: Option<f64>) -> Disc {
    let (normal, friction) = forces(y, drag);
    let length = libm::hypot(y[0], y[1]);
    let n = [-y[0] / length, -y[1] / length];
    let force = [normal * n[0] + friction * n[1], normal * n[1] - friction * n[0]];
    // From the centre to the contact.
    let arm = [-CHUTE.radius * n[0], -CHUTE.radius * n[1]];
    let moment = arm[0] * force[1] - arm[1] * force[0];
    [y[2], y[3], force[0] / CHUTE.mass, force[1] / CHUTE.mass - CHUTE.gravity, moment / CHUTE.inertia]
}

fn close(ours: f64, theirs: f64, scale: f64, allowed: f64, what: &str) {
    assert!((ours - theirs).abs() <= allowed * scale, "{what}: {ours}, by steps {theirs}");
}

fn rate_squared(y: &Disc) -> f64 {
    let length = CHUTE.way_radius();
    (y[2] * y[2] + y[3] * y[3]) / (length * length)
}

fn energy(y: &Disc) -> f64 {
    let kinetic = CHUTE.mass * (y[2] * y[2] + y[3] * y[3]) + CHUTE.inertia * y[4] * y[4];
    0.5 * kinetic + CHUTE.mass * CHUTE.gravity * y[1]
}

#[test]
fn a_rolling_disc_has_the_rates_forces_and_energy_of_an_integration() {
    for (start, end) in [([1.1, 0.0], -0.4), ([0.2, -4.0], -1.0), ([-0.3, 2.5], 0.6)] {
        let y = disc(start[0], start[1], CHUTE.rolling_spin(start[1]));
        let sign = f64::signum(end - start[0]);
        let (_, there) = until(y, STEP, &|y| rate(y, None), &|y| (end - angle_of(y)) * sign);
        let square = CHUTE.rolling_rate_squared(start, end);
        close(square, rate_squared(&there), square, AGREEMENT, "φ̇²");
        let turning = sign * square.sqrt();
        let motion = CHUTE.rolling(end, turning);
        let (normal, friction) = forces(&there, None);
        close(motion.normal_force, normal, normal, AGREEMENT, "N");
        close(motion.friction_force, friction, normal, AGREEMENT, "F");
        close(CHUTE.friction_needed(start, end), friction.abs() / normal, 1.0, AGREEMENT, "|F|/N");
        close(CHUTE.rolling_spin(turning), there[4], 10.0, AGREEMENT, "ω");
        close(CHUTE.slip(turning, there[4]), 0.0, 1.0, AGREEMENT, "the rim does not slip");
        close(motion.spin_acceleration, rate(&there, None)[4], 100.0, AGREEMENT, "ω̇");
        close(CHUTE.energy(end, turning, there[4]), energy(&y), 1.0, AGREEMENT, "energy");
    }
}

#[test]
fn swings_of_any_amplitude_take_their_period() {
    for amplitude in [1e-3, 0.5, 1.2, 1.57] {
        for (drag, period) in
            [(None, CHUTE.rolling_period(amplitude)), (Some(0.0), CHUTE.smooth_period(amplitude))]
        {
            let period = period.expect("below 180°");
            let y = disc(amplitude, 0.0, 0.0);
            let (quarter, _) = until(y, STEP, &|y| rate(y, drag), &angle_of);
            close(period, 4.0 * quarter, period, AGREEMENT, "period");
        }
        let ratio = CHUTE.rolling_period(amplitude).expect("a period")
            / CHUTE.smooth_period(amplitude).expect("a period");
        close(ratio * ratio, 1.0 + CHUTE.inertia_ratio(), 1.0, ROUNDING, "rolling is slower");
    }
    let all_around = CHUTE.rolling_period(core::f64::consts::PI).expect_err("never comes back");
    assert_eq!(all_around.quantity, "amplitude", "the domain");
}

#[test]
fn a_sliding_disc_has_the_rates_of_an_integration_and_loses_the_work_of_friction() {
    for (start, end, spin, drag) in [
        ([0.0, 6.0], 0.9, 100.0, 0.3),
        ([0.8, -1.0], -0.1, -100.0, -0.25),
        // Driven by its spin against its way.
        ([0.3, -2.0], -0.3, 300.0, 0.2),
        ([0.5, 0.0], -0.4, 0.0, 0.0),
    ] {
        let y = disc(start[0], start[1], spin);
        let with_work = [y[0], y[1], y[2], y[3], y[4], 0.0];
        let sign = f64::signum(end - start[0]);
        let of = |y: &[f64; 6]| -> Disc { std::array::from_fn(|i| y[i]) };
        let slip = |y: &Disc| CHUTE.slip((y[3] * y[0] - y[2] * y[1]) / (y[0] * y[0] + y[1] * y[1]), y[4]);
        let (_, there) = until(
            with_work,
            STEP,
            &|y| {
                let disc = of(y);
                let k = rate(&disc, Some(drag));
                [k[0], k[1], k[2], k[3], k[4], -forces(&disc, Some(drag)).1 * slip(&disc)]
            },
            &|y| (end - angle_of(&of(y))) * sign,
        );
        let there_disc = of(&there);
        assert!(slip(&there_disc) * drag >= 0.0, "it slips to the end: {there:?}");
        let square = CHUTE.sliding_rate_squared(start, end, drag);
        close(square, rate_squared(&there_disc), square, AGREEMENT, "φ̇²");
        let turning = sign * square.sqrt();
        let motion = CHUTE.sliding(end, turning, drag);
        let (normal, friction) = forces(&there_disc, Some(drag));
        close(motion.normal_force, normal, normal, AGREEMENT, "N");
        close(motion.friction_force, friction, normal, AGREEMENT, "F");
        close(motion.spin_acceleration, rate(&there_disc, Some(drag))[4], 100.0, AGREEMENT, "ω̇");
        let before = CHUTE.energy(start[0], start[1], spin);
        let lost = before - CHUTE.energy(end, turning, there[4]);
        close(lost, there[5], before.abs(), AGREEMENT, "lost energy");
    }
}

#[test]
fn accelerations_are_the_derivatives_of_the_squared_rates() {
    // φ̈ = (dφ̇²/dφ)/2
    let (start, width) = ([0.4, 8.0], HALF_WIDTH);
    for angle in [-0.6, 0.1, 0.7] {
        for drag in [None, Some(0.35), Some(-0.35), Some(0.0)] {
            let square = |at: f64| match drag {
                Some(drag) => CHUTE.sliding_rate_squared(start, at, drag),
                None => CHUTE.rolling_rate_squared(start, at),
            };
            let rate = square(angle).max(0.0).sqrt();
            let motion =
                drag.map_or_else(|| CHUTE.rolling(angle, rate), |drag| CHUTE.sliding(angle, rate, drag));
            let slope = (square(angle + width) - square(angle - width)) / (2.0 * width);
            close(motion.angle_acceleration, 0.5 * slope, 100.0, OF_A_DIFFERENCE, "φ̈");
        }
    }
}

#[test]
fn a_swing_needs_most_friction_at_its_ends() {
    for friction in [0.05, 0.3, 2.0] {
        let amplitude = CHUTE.largest_amplitude(friction);
        let needed = |share: f64| CHUTE.friction_needed([amplitude, 0.0], share * amplitude);
        close(needed(1.0), friction, friction, ROUNDING, "at the end");
        close(needed(-1.0), friction, friction, ROUNDING, "at the other end");
        for i in 0..100_u32 {
            let [before, after] = [i, i + 1].map(|i| needed(f64::from(i) / 100.0));
            assert!(before < after, "it grows with the angle, {i}: {before} {after}");
        }
    }
    assert_eq!(CHUTE.largest_amplitude(0.0), 0.0, "no friction, no rolling");
}

#[test]
fn a_disc_rolls_from_plate_through_chute_to_plate_without_loss() {
    // Into the chute at φ = −0.5, out at 0.3: the plates are its tangents there.
    let (into, out, speed) = (-0.5, 0.3, 1.2);
    let length = CHUTE.way_radius();
    let descent = length * (libm::cos(out) - libm::cos(into));
    let after = CHUTE.speed_after(speed, descent).expect("it is fast enough");
    let start = [into, speed / length];
    close(after, length * CHUTE.rolling_rate_squared(start, out).sqrt(), after, ROUNDING, "speed");
    let y = disc(into, speed / length, CHUTE.rolling_spin(speed / length));
    let (_, there) = until(y, STEP, &|y| rate(y, None), &|y| out - angle_of(y));
    close(after, libm::hypot(there[2], there[3]), after, AGREEMENT, "by steps");
    let on_plate = CHUTE.mass * CHUTE.gravity * libm::cos(into);
    let jump = CHUTE.rolling(into, start[1]).normal_force - on_plate;
    close(CHUTE.joint_jump(speed), jump, jump, ROUNDING, "N at the joint");
    assert_eq!(CHUTE.speed_after(0.5, -1.0), None, "too slow to get up");
}
