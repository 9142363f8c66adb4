//! The strikes on two points against a walk that tries every state of both contacts in every stage.

use crate::oracle;

use carom_theory::rocking::{
    Cylinder, CylinderRegions, CylinderState, Pivoting, Prism, PrismState, RodState, Strike, SupportedRod,
    Tangential, cylinder_ratio, cylinder_sticking_friction, housner_ratio, housner_sticking_friction,
    rimless_wheel_ratio, rimless_wheel_speed, rimless_wheel_sticking_friction, solid_polygon_inertia_ratio,
};
use oracle::Stream;
use oracle::two_points::{Scene, Walked};

/// Some ten roundings, as a fraction of the terms.
const ROUNDING: f64 = 1e-14;
/// What an inequality that holds with equality may be broken by, as a fraction of its terms.
const AT_BORDER: f64 = 1e-12;

/// Both sides are of order one and take some fifty roundings, more where two contacts nearly share one line of action.
const AGREEMENT: f64 = 1e-9;

fn assert_near(name: &str, ours: f64, walked: f64, case: &dyn std::fmt::Debug) {
    let scale = 1.0 + walked.abs();
    assert!((ours - walked).abs() <= AGREEMENT * scale, "{name}: {ours} against {walked} in {case:?}");
}

fn assert_same(strike: &Strike, walked: &Walked, case: &dyn std::fmt::Debug) {
    assert_near("v_x", strike.velocity[0], walked.q[0], case);
    assert_near("v_y", strike.velocity[1], walked.q[1], case);
    assert_near("roll rate", strike.roll_rate, walked.q[2], case);
    assert_near("N_A", strike.normal[0], walked.p[0], case);
    assert_near("N_K", strike.normal[1], walked.p[2], case);
    match strike.tangential {
        Tangential::Each([a, k]) => {
            assert_near("T_A", a, walked.p[1], case);
            assert_near("T_K", k, walked.p[3], case);
        }
        Tangential::Sum(sum) => assert_near("T_A + T_K", sum, walked.p[1] + walked.p[3], case),
    }
}

fn cylinder_scene(cylinder: &Cylinder) -> Scene {
    let (s, c) = libm::sincos(2.0 * cylinder.half_angle);
    Scene {
        rows: [[0.0, 1.0, 0.0], [1.0, 0.0, -1.0], [-s, c, 0.0], [c, s, -1.0]],
        inertia: cylinder.inertia_ratio,
        friction: cylinder.friction,
    }
}

#[test]
fn the_cylinder_ends_in_the_state_that_the_walk_reaches() {
    let mut stream = Stream(1863);
    let mut seen = [0; 6];
    for _ in 0..60_000 {
        let cylinder = Cylinder {
            mass: 1.0,
            radius: 1.0,
            inertia_ratio: stream.one_of([1.0, 0.5, 0.4, stream.0 as f64 / u64::MAX as f64 * 0.95 + 0.05]),
            friction: stream.within(0.0, 2.0) * stream.one_of([0.3, 1.0]),
            half_angle: stream.within(1.0, 89.0).to_radians(),
        };
        let (state, strike) = cylinder.strike(1.0).expect("in the domain");
        let walked = cylinder_scene(&cylinder).walk([1.0, 0.0, 1.0]);
        assert_same(&strike, &walked.expect("every stage has a solution"), &(state, cylinder));
        seen[state as usize] += 1;
    }
    assert!(seen.iter().all(|&n| n > 300), "every state is met: {seen:?}");
}

/// Is there an n = N_K for which the impulses that stop the cylinder obey both cones? Each condition is linear in n.
fn rest_is_possible(cylinder: &Cylinder) -> bool {
    let (s, c) = libm::sincos(2.0 * cylinder.half_angle);
    let (b, f) = (cylinder.inertia_ratio, cylinder.friction);
    // Pairs (constant, slope) in n, from the balances of momentum and spin.
    let struck = [(1.0 + b) / (1.0 - c), -s / (1.0 - c)];
    let held = [b - struck[0], -struck[1]];
    let pressed = [-s * struck[0], -c - s * struck[1]];
    let plus = |x: [f64; 2], y: [f64; 2], by: f64| [x[0] + by * y[0], x[1] + by * y[1]];
    let cone = |normal: [f64; 2]| [f * normal[0], f * normal[1]];
    let conditions = [
        plus(cone([0.0, 1.0]), struck, 1.0),
        plus(cone([0.0, 1.0]), struck, -1.0),
        plus(cone(pressed), held, 1.0),
        plus(cone(pressed), held, -1.0),
        pressed,
    ];
    let (mut low, mut high) = (0.0f64, f64::INFINITY);
    for [constant, slope] in conditions {
        let bound = -constant / slope;
        if slope > 0.0 { low = low.max(bound) } else { high = high.min(bound) }
    }
    low <= high
}

#[test]
fn the_cylinder_may_wedge_exactly_where_both_cones_allow_rest() {
    let mut stream = Stream(2026);
    let mut wedged = 0;
    for _ in 0..60_000 {
        let cylinder = Cylinder {
            mass: 1.0,
            radius: 1.0,
            inertia_ratio: stream.within(0.05, 1.0),
            friction: stream.within(0.01, 2.0),
            half_angle: stream.within(1.0, 89.0).to_radians(),
        };
        let rests = cylinder.state().number() == 4;
        assert_eq!(rest_is_possible(&cylinder), rests || cylinder.may_wedge(), "{cylinder:?}");
        wedged += usize::from(cylinder.may_wedge());
    }
    assert!(wedged > 5000, "it is common: {wedged}");
}

#[test]
fn the_prism_ends_in_the_state_that_the_walk_reaches() {
    let mut stream = Stream(1953);
    let mut seen = [0; 5];
    for _ in 0..60_000 {
        let prism = Prism {
            mass: 1.0,
            inertia: stream.decades(-2.0, 0.5),
            to_centre: stream.within(0.05, 2.0),
            to_k: stream.within(0.05, 2.0),
            height: stream.within(0.05, 2.0),
            friction: stream.within(0.0, 2.0),
        };
        let (state, strike) = prism.strike(1.0).expect("in the domain");
        let Prism { to_centre, to_k, height, .. } = prism;
        let scene = Scene {
            rows: [[0.0, 1.0, to_centre], [1.0, 0.0, -height], [0.0, 1.0, -to_k], [1.0, 0.0, -height]],
            inertia: prism.inertia,
            friction: prism.friction,
        };
        seen[usize::from(state.number())] += 1;
        if state == PrismState::Stops {
            // Both stick: the walk's equations are singular. The end state is checked instead.
            assert_stopped(&prism, &strike);
            continue;
        }
        let walked = scene.walk([height, -to_centre, 1.0]);
        assert_same(&strike, &walked.expect("every stage has a solution"), &(state, prism));
    }
    assert!(seen[1..].iter().all(|&n| n > 300), "every state is met: {seen:?}");
}

/// Balance of momentum and spin, pressing normal impulses, and a tangential sum within the cones.
fn assert_stopped(prism: &Prism, strike: &Strike) {
    let ([n_a, n_k], Tangential::Sum(sum)) = (strike.normal, strike.tangential) else {
        panic!("only the sum is determined: {strike:?}");
    };
    assert!(n_a >= 0.0 && n_k > 0.0, "{strike:?}");
    assert!(sum.abs() <= prism.friction * (n_a + n_k) * (1.0 + AT_BORDER), "{strike:?}");
    assert_near("momentum", n_a + n_k, prism.mass * prism.to_centre, prism);
    let turned = n_k * prism.to_k - n_a * prism.to_centre + sum * prism.height;
    assert_near("spin", turned, prism.inertia, prism);
}

#[test]
fn the_rod_obeys_signorini_at_both_supports() {
    let mut stream = Stream(12);
    for _ in 0..20_000 {
        let (mass, length) = (stream.decades(-1.0, 1.0), stream.decades(-1.0, 1.0));
        let half = 0.5 * length;
        let supports = [stream.within(0.0, half), stream.within(0.01 * half, half)];
        let rod = SupportedRod::uniform(mass, length, supports);
        let (state, strike) = rod.strike(2.0).expect("in the domain");
        let [a, b] = supports;
        let ([n_a, n_b], rate, rise) = (strike.normal, strike.roll_rate, strike.velocity[1]);
        let scale = mass * 2.0 * length;
        assert!((mass * (rise + 2.0 * a) - n_a - n_b).abs() <= ROUNDING * scale, "momentum {rod:?}");
        let spin = rod.inertia * (2.0 - rate) - (n_b * b - n_a * a);
        assert!(spin.abs() <= ROUNDING * scale * length, "spin {rod:?}");
        assert!((rise - b * rate).abs() <= ROUNDING * length, "B stays {rod:?}");
        let opening = rise + a * rate;
        assert!(n_a >= 0.0 && opening >= 0.0 && n_a * opening == 0.0, "A {rod:?} {strike:?}");
        assert_eq!(state == RodState::Stops, 12.0 * a * b >= length * length, "{rod:?}");
    }
}

#[test]
fn restitution_repeats_the_rods_impulses() {
    let rod = SupportedRod::uniform(1.0, 1.0, [0.2, 0.3]);
    let (state, plastic) = rod.strike(1.0).expect("in the domain");
    assert_eq!(state, RodState::TurnsAboutB);
    let k = (1.0 - 0.72) / (1.0 + 1.08);
    for restitution in [0.0, 0.3, 1.0] {
        let strike = plastic.with_restitution(restitution);
        assert!((strike.roll_rate - (k - restitution * (1.0 - k))).abs() < 1e-15, "spin, R {restitution}");
        let rise = k * 0.3 + restitution * (k * 0.3 + 0.2);
        assert!((strike.velocity[1] - rise).abs() < 1e-15, "rise, R {restitution}");
    }
    let elastic = plastic.with_restitution(1.0);
    assert!((elastic.energy_ratio(1.0 / 12.0) - 1.0).abs() < ROUNDING, "R = 1 keeps the energy");
}

#[test]
fn classical_ratios_are_special_strikes() {
    for degrees in [5.0, 20.0, 45.0, 54.0] {
        let alpha = f64::to_radians(degrees);
        let (sin, cos) = libm::sincos(alpha);
        let block = Prism {
            mass: 2.0,
            inertia: 2.0 / 3.0,
            to_centre: sin,
            to_k: sin,
            height: cos,
            friction: housner_sticking_friction(alpha) * (1.0 + AT_BORDER),
        };
        let (state, strike) = block.strike(3.0).expect("in the domain");
        assert_eq!(state, PrismState::RollsOn, "Housner's block at {degrees}°");
        assert!((strike.roll_rate / 3.0 - housner_ratio(alpha)).abs() < ROUNDING, "{degrees}°");
    }
    for sides in 4..12 {
        let ratio = solid_polygon_inertia_ratio(sides);
        let needed = rimless_wheel_sticking_friction(sides, ratio);
        let prism = Prism::regular(sides, 0.7, 1.3, needed * (1.0 + AT_BORDER));
        let (state, strike) = prism.strike(1.0).expect("in the domain");
        assert_eq!(state, PrismState::RollsOn, "{sides} sides");
        assert!((strike.roll_rate - rimless_wheel_ratio(sides, ratio)).abs() < ROUNDING, "{sides} sides");
    }
    let half_angle = 0.4;
    let friction = cylinder_sticking_friction(0.5, half_angle) * (1.0 + AT_BORDER);
    let disc = Cylinder { mass: 2.0, radius: 0.3, inertia_ratio: 0.5, friction, half_angle };
    let (state, strike) = disc.strike(4.0).expect("in the domain");
    assert_eq!(state, CylinderState::RollsOver);
    assert!((strike.roll_rate - 4.0 * cylinder_ratio(0.5, half_angle)).abs() < ROUNDING, "the disc");
    assert!((strike.velocity[0] - 0.3 * strike.roll_rate * libm::cos(0.8)).abs() < ROUNDING, "SI units");
}

#[test]
fn strikes_outside_the_domain_are_refused_by_name() {
    let rod = SupportedRod::uniform(1.0, 1.0, [0.0, 0.0]);
    assert_eq!(rod.strike(1.0).expect_err("no span").quantity, "to_a + to_b");
    assert_eq!(Prism::regular(4, 1.0, 1.0, 0.5).strike(-1.0).expect_err("backward").quantity, "roll rate");
    let flat = Cylinder { mass: 1.0, radius: 1.0, inertia_ratio: 0.5, friction: 0.1, half_angle: 0.0 };
    assert_eq!(flat.strike(1.0).expect_err("one contact").quantity, "half angle");
}

#[test]
fn restitution_repeats_the_prisms_impulses_without_gaining_energy() {
    let mut stream = Stream(58);
    for _ in 0..20_000 {
        let prism = Prism {
            mass: 1.0,
            inertia: stream.decades(-2.0, 0.5),
            to_centre: stream.within(0.05, 2.0),
            to_k: stream.within(0.05, 2.0),
            height: stream.within(0.05, 2.0),
            friction: stream.within(0.0, 2.0),
        };
        let restitution = stream.within(0.0, 1.0);
        let (state, plastic) = prism.strike(1.0).expect("in the domain");
        let strike = plastic.with_restitution(restitution);
        let Prism { to_centre, to_k, height, .. } = prism;
        let [x, y] = strike.velocity;
        let (rise_a, rise_k) = (y + strike.roll_rate * to_centre, y - strike.roll_rate * to_k);
        let slip = x - height * strike.roll_rate;
        assert!(rise_a >= -1e-13, "A does not sink in: {rise_a} {state:?} {prism:?}");
        assert!((rise_k - restitution * (to_centre + to_k)).abs() < AT_BORDER, "K leaves with R {prism:?}");
        assert!(slip >= -AT_BORDER, "it slides forward or sticks: {slip} {state:?} {prism:?}");
        assert!(strike.energy_ratio(prism.inertia) <= 1.0 + 1e-13, "{state:?} {prism:?}");
    }
}

/// Time in which φ̈ = p² sin φ leads from (α, −ω) back to α, by Runge–Kutta's method of order 4 and a last step of the length that is left.
fn swing_by_steps(stiffness: f64, alpha: f64, rate: f64, step: f64) -> f64 {
    let go = |[phi, u]: [f64; 2], h: f64| {
        let slope = |s: [f64; 2]| [s[1], stiffness * libm::sin(s[0])];
        let at = |k: [f64; 2], h: f64| [phi + h * k[0], u + h * k[1]];
        let first = slope([phi, u]);
        let second = slope(at(first, 0.5 * h));
        let third = slope(at(second, 0.5 * h));
        let last = slope(at(third, h));
        let mean = [0, 1].map(|i| (first[i] + 2.0 * (second[i] + third[i]) + last[i]) / 6.0);
        at(mean, h)
    };
    let (mut time, mut now) = (0.0, [alpha, -rate]);
    loop {
        let next = go(now, step);
        if next[0] >= alpha {
            break;
        }
        (time, now) = (time + step, next);
    }
    // Newton's method for the rest of the way.
    let mut left = 0.0;
    for _ in 0..20 {
        let [phi, u] = go(now, left);
        left += (alpha - phi) / u;
    }
    time + left
}

#[test]
fn a_swing_takes_the_time_that_small_steps_take() {
    let body = Pivoting { mass: 3.0, inertia: 1.0, reach: 1.0, gravity: 9.81 };
    for (alpha, tilt) in [(0.2, 0.01), (0.2, 0.15), (0.5, 0.3), (1.2, 1.0), (0.35, 0.33)] {
        let rate = body.falling_rate(alpha, tilt);
        let time = body.swing_time(alpha, rate).expect("it does not overturn");
        let steps = swing_by_steps(body.stiffness(), alpha, rate, time / 4000.0);
        assert!((time / steps - 1.0).abs() < 1e-11, "α {alpha}, tilt {tilt}: {time}, by steps {steps}");
    }
    let over = body.falling_rate(0.4, 0.4) * (1.0 + AT_BORDER);
    assert_eq!(body.swing_time(0.4, over).expect_err("it overturns").quantity, "roll rate");
}

#[test]
fn more_strikes_outside_the_domain_are_refused_by_name() {
    let disc = Cylinder { mass: 1.0, radius: 1.0, inertia_ratio: 0.5, friction: 0.8, half_angle: 1.2 };
    assert_eq!(disc.elastic_strike(1.0, 1.5).expect_err("R > 1").quantity, "restitution");
    assert_eq!(disc.elastic_strike(-1.0, 0.5).expect_err("backward").quantity, "roll rate");
    assert_eq!(disc.sliding_strike(0.0, 1.0).expect_err("no approach").quantity, "speed");
    assert_eq!(disc.sliding_strike(1.0, 1.0).expect_err("it stops").quantity, "friction");
    assert_eq!(CylinderRegions::new(1.5).expect_err("no such body").quantity, "inertia ratio");
    let level = rimless_wheel_speed(6, 0.4, [1.0, 9.81], 0.01).expect_err("it stays");
    assert_eq!(level.quantity, "slope");
}
