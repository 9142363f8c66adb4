//! A disc on a fixed disc: closed forms against Newton's and Euler's laws in the fixed frame, integrated with small steps.

use crate::integrate;

use carom_theory::disc_on_disc::DiscOnDisc;
use integrate::until;

/// Some tens of roundings, as a fraction of the terms.
const ROUNDING: f64 = 1e-13;
/// What a closed form and an integration in thousands of steps may differ by, as a fraction.
const AGREEMENT: f64 = 1e-10;
/// Steps of the integrations [s]: their error, of the fourth power, is below rounding.
const STEP: f64 = 1e-4;

const DISCS: DiscOnDisc =
    DiscOnDisc { mass: 0.7, inertia: 0.003, radius: 0.1, fixed_radius: 0.4, gravity: 9.81 };

/// Centre of the disc from O, its velocity, its spin, and the work that friction has taken.
type Disc = [f64; 6];

fn disc([angle, rate]: [f64; 2], spin: f64) -> Disc {
    let (sin, cos) = libm::sincos(angle);
    let length = DISCS.radius + DISCS.fixed_radius;
    [length * sin, length * cos, length * rate * cos, -length * rate * sin, spin, 0.0]
}

fn angle_of(y: &Disc) -> f64 {
    libm::atan2(y[0], y[1])
}

fn rate_of(y: &Disc) -> f64 {
    (y[2] * y[1] - y[3] * y[0]) / (y[0] * y[0] + y[1] * y[1])
}

/// The normal out of the fixed disc, and that turned 90° clockwise.
fn frame(y: &Disc) -> ([f64; 2], [f64; 2]) {
    let length = libm::hypot(y[0], y[1]);
    let n = [y[0] / length, y[1] / length];
    (n, [n[1], -n[0]])
}

/// N and F that keep the centre at its distance from O, with a drag or (`None`) without a slip of the rim.
fn forces(y: &Disc, drag: Option<f64>) -> (f64, f64) {
    let (n, t) = frame(y);
    let (m, a, g) = (DISCS.mass, DISCS.radius, DISCS.gravity);
    let normal = m * (g * n[1] - (y[2] * y[2] + y[3] * y[3]) / libm::hypot(y[0], y[1]));
    let friction = match drag {
        Some(drag) => -drag * normal,
        // The rim's acceleration along t vanishes: F/m − g t_y + a²F/J = 0.
        None => m * g * t[1] / (1.0 + m * a * a / DISCS.inertia),
    };
    (normal, friction)
}

fn rate(y: &Disc, drag: Option<f64>) -> Disc {
    let (normal, friction) = forces(y, drag);
    let (n, t) = frame(y);
    let force = [0, 1].map(|i| normal * n[i] + friction * t[i]);
    // From the centre to the contact; the rim there moves with v + ω × arm.
    let arm = n.map(|x| -DISCS.radius * x);
    let moment = arm[0] * force[1] - arm[1] * force[0];
    let rim = [y[2] - y[4] * arm[1], y[3] + y[4] * arm[0]];
    let work = -friction * (rim[0] * t[0] + rim[1] * t[1]);
    [y[2], y[3], force[0] / DISCS.mass, force[1] / DISCS.mass - DISCS.gravity, moment / DISCS.inertia, work]
}

fn close(ours: f64, theirs: f64, scale: f64, allowed: f64, what: &str) {
    assert!((ours - theirs).abs() <= allowed * scale, "{what}: {ours}, by steps {theirs}");
}

fn rolling(start: [f64; 2]) -> Disc {
    disc(start, DISCS.rolling_spin(start[1]))
}

#[test]
fn a_rolling_disc_has_the_rates_forces_and_energy_of_an_integration() {
    for (start, end) in [([0.1, 0.0], 0.7), ([0.0, 1.5], 0.6), ([0.5, 0.3], 0.8)] {
        let y = rolling(start);
        let (_, there) = until(y, STEP, &|y| rate(y, None), &|y| end - angle_of(y));
        let turning = DISCS.rolling_rate_squared(start, end).sqrt();
        close(turning, rate_of(&there), turning, AGREEMENT, "φ̇");
        let motion = DISCS.rolling(end, turning);
        let (normal, friction) = forces(&there, None);
        close(motion.normal_force, normal, 1.0, AGREEMENT, "N");
        close(motion.friction_force, friction, 1.0, AGREEMENT, "F");
        close(motion.spin_acceleration, rate(&there, None)[4], 100.0, AGREEMENT, "ω̇");
        close(
            motion.angle_acceleration * DISCS.way_radius(),
            -motion.spin_acceleration * DISCS.radius,
            10.0,
            ROUNDING,
            "it rolls",
        );
        close(DISCS.friction_needed(start, end), friction.abs() / normal, 1.0, AGREEMENT, "|F|/N");
        close(DISCS.rolling_spin(turning), there[4], 10.0, AGREEMENT, "ω");
        let before = DISCS.energy(start[0], start[1], y[4]);
        close(DISCS.energy(end, turning, there[4]), before, before, AGREEMENT, "energy");
    }
}

#[test]
fn discs_lift_off_where_an_integration_loses_the_contact() {
    for start in [[0.01, 0.0], [0.0, 2.0], [0.6, 0.5]] {
        let y = rolling(start);
        let (_, there) = until(y, STEP, &|y| rate(y, None), &|y| forces(y, None).0);
        close(DISCS.rolling_lift_off(start), angle_of(&there), 1.0, AGREEMENT, "rolling");
        let speed = libm::hypot(there[2], there[3]);
        close(DISCS.lift_off_speed(angle_of(&there)), speed, speed, AGREEMENT, "speed");
        let (_, there) = until(disc(start, 0.0), STEP, &|y| rate(y, Some(0.0)), &|y| forces(y, Some(0.0)).0);
        close(DISCS.smooth_lift_off(start), angle_of(&there), 1.0, AGREEMENT, "without friction");
        let sliding = DISCS.sliding_lift_off(start, 0.0).expect("nothing stops it");
        close(sliding, DISCS.smooth_lift_off(start), 1.0, ROUNDING, "the same as a root");
    }
    let hoop = DiscOnDisc { inertia: DISCS.mass * DISCS.radius * DISCS.radius, ..DISCS };
    close(libm::cos(hoop.rolling_lift_off([0.0, 0.0])), 0.5, 1.0, ROUNDING, "a hoop at 60°");
    let fast = [0.2, 1.001 * DISCS.lift_off_speed(0.2) / DISCS.way_radius()];
    assert_eq!(DISCS.rolling_lift_off(fast), 0.2, "at once");
    assert_eq!(DISCS.smooth_lift_off(fast), 0.2, "at once without friction");
    assert_eq!(DISCS.sliding_lift_off(fast, 0.3), Some(0.2), "at once with friction");
    assert_eq!(DISCS.slip_angle(fast, 0.3), 0.2, "and no friction holds it");
}

#[test]
fn a_sliding_disc_has_the_rates_of_an_integration_and_loses_the_work_of_friction() {
    for (start, spin, end, drag) in [
        ([0.0, 2.5], 0.0, 0.3, 0.3),
        ([0.5, 0.0], 40.0, 0.8, 0.25),
        // Driven by its spin.
        ([0.1, 1.0], -300.0, 0.5, -0.4),
    ] {
        let y = disc(start, spin);
        let (_, there) = until(y, STEP, &|y| rate(y, Some(drag)), &|y| end - angle_of(y));
        assert!(DISCS.slip(rate_of(&there), there[4]) * drag > 0.0, "it slips to the end: {there:?}");
        let square = DISCS.sliding_rate_squared(start, end, drag);
        close(square, rate_of(&there) * rate_of(&there), square, AGREEMENT, "φ̇²");
        let motion = DISCS.sliding(end, square.sqrt(), drag);
        let (normal, friction) = forces(&there, Some(drag));
        close(motion.normal_force, normal, 1.0, AGREEMENT, "N");
        close(motion.friction_force, friction, 1.0, AGREEMENT, "F");
        close(motion.spin_acceleration, rate(&there, Some(drag))[4], 100.0, AGREEMENT, "ω̇");
        let k = rate(&there, Some(drag));
        let (_, t) = frame(&there);
        close(
            motion.angle_acceleration * DISCS.way_radius(),
            k[2] * t[0] + k[3] * t[1],
            10.0,
            AGREEMENT,
            "Lφ̈",
        );
        let before = DISCS.energy(start[0], start[1], spin);
        let lost = before - DISCS.energy(end, square.sqrt(), there[4]);
        close(lost, there[5], before, AGREEMENT, "lost energy");
        assert!(there[5] > 0.01, "friction has worked: {}", there[5]);
    }
}

#[test]
fn a_disc_rolls_then_slips_then_leaves_as_integrated() {
    for (start, friction) in [([0.02, 0.0], 0.1), ([0.02, 0.0], 0.5), ([0.0, 1.8], 0.3), ([0.7, 0.0], 0.1)] {
        let end = DISCS.lift_off(start, friction).expect("it leaves");
        let left = |y: &Disc| {
            let (normal, force) = forces(y, None);
            friction * normal - force.abs()
        };
        let y = rolling(start);
        let slips = if left(&y) > 0.0 { until(y, STEP, &|y| rate(y, None), &left).1 } else { y };
        close(end.slip_angle, angle_of(&slips), 1.0, AGREEMENT, "it slips");
        let (_, there) = until(slips, STEP, &|y| rate(y, Some(friction)), &|y| forces(y, None).0);
        close(end.angle, angle_of(&there), 1.0, AGREEMENT, "it lifts off");
        close(end.rate, rate_of(&there), 1.0, AGREEMENT, "its rate");
        assert!(DISCS.slip(rate_of(&there), there[4]) > 0.0, "ahead of the rolling: {there:?}");
        let (rolls, smooth) = (DISCS.rolling_lift_off(start), DISCS.smooth_lift_off(start));
        assert!(end.slip_angle < end.angle, "it slips before: {end:?}");
        assert!(end.angle > smooth, "friction keeps it on longer: {} {smooth} {rolls}", end.angle);
    }
}

#[test]
fn rolling_needs_more_and_more_friction_on_the_way_down() {
    for start in [[0.0, 0.0], [0.2, 1.0]] {
        let lift_off = DISCS.rolling_lift_off(start);
        let needed =
            |i: u32| DISCS.friction_needed(start, start[0] + (lift_off - start[0]) * f64::from(i) / 100.0);
        for i in 0..99 {
            assert!(needed(i) < needed(i + 1), "it grows, {i}: {} {}", needed(i), needed(i + 1));
        }
        for friction in [0.1, 1.0, 10.0] {
            let angle = DISCS.slip_angle(start, friction);
            close(DISCS.friction_needed(start, angle), friction, friction, AGREEMENT, "at the slip");
        }
        assert_eq!(DISCS.friction_needed(start, lift_off + 0.01), f64::INFINITY, "beyond the lift-off");
    }
}

#[test]
fn friction_stops_a_slow_disc_before_the_slope_of_friction_alone() {
    // The border: φ̇² vanishes where tan φ = q.
    let drag = 0.5;
    let square = |rate: f64| DISCS.sliding_rate_squared([0.0, rate], libm::atan(drag), drag);
    let border = (-square(0.0) / (square(1.0) - square(0.0))).sqrt();
    assert_eq!(DISCS.sliding_lift_off([0.0, 0.999 * border], drag), None, "stops");
    let angle = DISCS.sliding_lift_off([0.0, 1.001 * border], drag).expect("goes on");
    assert!(angle > libm::atan(drag), "{angle}");
    let (_, there) =
        until(disc([0.0, 1.001 * border], 0.0), STEP, &|y| rate(y, Some(drag)), &|y| forces(y, None).0);
    close(angle, angle_of(&there), 1.0, AGREEMENT, "by steps");
}

#[test]
fn a_rounded_end_takes_its_share_of_the_force_at_the_joint() {
    let (slope, speed) = (0.3, 1.4);
    let on_plate = DISCS.mass * DISCS.gravity * libm::cos(slope);
    let on_arc = DISCS.rolling(slope, speed / DISCS.way_radius()).normal_force;
    close(DISCS.joint_drop(speed), on_plate - on_arc, on_plate, ROUNDING, "mv²/L");
    let fastest = DISCS.lift_off_speed(slope);
    close(
        DISCS.joint_drop(fastest),
        on_plate,
        on_plate,
        ROUNDING,
        "nothing is left at the speed of lifting off",
    );
}
