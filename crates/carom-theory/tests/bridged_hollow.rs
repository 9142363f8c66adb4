//! A rod across a hollow: closed forms against balances, against small steps in the fixed frame, and against all pairs of forces.

use crate::integrate;

use carom_theory::bridged_hollow::{RodInHollow, RodOnEdges};
use integrate::until;

/// Some tens of roundings, as a fraction of the terms.
const ROUNDING: f64 = 1e-13;
/// What a closed form and an integration in thousands of steps may differ by, as a fraction.
const AGREEMENT: f64 = 1e-10;
/// Steps of the integrations [s]: their error, of the fourth power, is below rounding.
const STEP: f64 = 1e-4;
/// To either side of a border, as a fraction.
const ASIDE: f64 = 1e-9;

const ON_EDGES: RodOnEdges =
    RodOnEdges { mass: 1.3, half_length: 0.5, half_gap: 0.2, offset: 0.0, gravity: 9.81 };

fn in_hollow() -> RodInHollow {
    RodInHollow::uniform(1.3, 0.4, 0.5, 9.81)
}

fn close(ours: f64, theirs: f64, scale: f64, allowed: f64, what: &str) {
    assert!((ours - theirs).abs() <= allowed * scale, "{what}: {ours} {theirs}");
}

#[test]
fn two_edges_balance_the_weight_and_its_moment() {
    for i in -40..=40 {
        let rod = RodOnEdges { offset: 0.01 * f64::from(i), ..ON_EDGES };
        let [left, right] = rod.forces();
        let weight = rod.mass * rod.gravity;
        close(left + right, weight, weight, ROUNDING, "weight");
        close(
            (right - left) * rod.half_gap,
            weight * rod.offset,
            weight,
            ROUNDING,
            "moment about the middle",
        );
        let lies_on_both = rod.half_gap + rod.offset.abs() <= rod.half_length;
        assert_eq!(rod.rests(), lies_on_both && left >= 0.0 && right >= 0.0, "{rod:?}");
        assert_eq!(rod.rests(), rod.tipping(0.3).is_none(), "else it tips: {rod:?}");
    }
}

#[test]
fn beyond_an_edge_the_rod_tips_as_on_the_edge_of_a_plate() {
    for offset in [0.2 * (1.0 + ASIDE), 0.35, -0.35, -0.6] {
        let rod = RodOnEdges { offset, ..ON_EDGES };
        let (part, state) = rod.tipping(0.3).expect("its centre is beyond");
        let motion = part.motion(&state);
        let (m, r) = (rod.mass, offset.abs() - rod.half_gap);
        let j = m * rod.half_length * rod.half_length / 3.0;
        close(
            motion.tilt_acceleration,
            m * rod.gravity * r / (j + m * r * r),
            10.0,
            ROUNDING,
            "about the edge",
        );
        close(motion.normal_force, m * rod.gravity * j / (j + m * r * r), 10.0, ROUNDING, "N");
        assert!(motion.tilt_acceleration > 0.0, "outwards");
    }
    let short = RodOnEdges { half_length: 0.25, offset: 0.1, ..ON_EDGES };
    let (part, state) = short.tipping(0.3).expect("its left end is over the gap");
    assert!(part.motion(&state).tilt_acceleration < 0.0, "into the gap");
    assert_eq!(RodOnEdges { half_length: 0.05, ..short }.tipping(0.3), None, "over the gap, on no edge");
    assert_eq!(RodOnEdges { offset: 0.9, ..ON_EDGES }.tipping(0.3), None, "past the edge, as a whole");
}

#[test]
fn a_rod_bridges_a_gap_that_its_tip_crosses_before_its_centre_is_over_the_edge() {
    for (half_length, bridges) in [(0.41, true), (0.4, true), (0.39, false)] {
        let tips = RodOnEdges { half_length, offset: -ON_EDGES.half_gap, ..ON_EDGES };
        let tip = tips.offset + half_length;
        assert_eq!(tips.bridges(), bridges, "half length {half_length}");
        assert_eq!(tip >= ON_EDGES.half_gap, bridges, "where the tip is: {tip}");
    }
}

/// Place and tilt of the rod's centre from O and their rates: x, y, α, ẋ, ẏ, α̇.
type Pose = [f64; 6];

fn pose(rod: &RodInHollow, [tilt, rate]: [f64; 2]) -> Pose {
    let (sin, cos) = libm::sincos(tilt);
    let h = rod.depth();
    [h * sin, -h * cos, tilt, h * rate * cos, h * rate * sin, rate]
}

/// The forces at A and B towards O that keep both ends on the hollow, and the accelerations: the second derivatives of the squared
/// distances of the ends from O vanish.
fn newton_euler(rod: &RodInHollow, y: &Pose) -> ([f64; 2], [f64; 3]) {
    let (sin, cos) = libm::sincos(y[2]);
    let spin = y[5];
    let ends = [-1.0, 1.0].map(|side| {
        let arm = [side * rod.half_length * cos, side * rod.half_length * sin];
        (arm, [y[0] + arm[0], y[1] + arm[1]])
    });
    let under = |forces: [f64; 2]| {
        let mut a = [0.0, -rod.gravity, 0.0];
        for ((arm, end), force) in ends.iter().zip(forces) {
            let pull = [-force * end[0] / rod.hollow_radius, -force * end[1] / rod.hollow_radius];
            a[0] += pull[0] / rod.mass;
            a[1] += pull[1] / rod.mass;
            a[2] += (arm[0] * pull[1] - arm[1] * pull[0]) / rod.inertia;
        }
        a
    };
    let residuals = |forces: [f64; 2]| {
        let a = under(forces);
        ends.map(|(arm, end)| {
            let v = [y[3] - spin * arm[1], y[4] + spin * arm[0]];
            let of_end =
                [a[0] - a[2] * arm[1] - spin * spin * arm[0], a[1] + a[2] * arm[0] - spin * spin * arm[1]];
            end[0] * of_end[0] + end[1] * of_end[1] + v[0] * v[0] + v[1] * v[1]
        })
    };
    let base = residuals([0.0, 0.0]);
    let [p, q] = [residuals([1.0, 0.0]), residuals([0.0, 1.0])].map(|r| [r[0] - base[0], r[1] - base[1]]);
    let determinant = p[0] * q[1] - p[1] * q[0];
    let forces =
        [(q[0] * base[1] - q[1] * base[0]) / determinant, (p[1] * base[0] - p[0] * base[1]) / determinant];
    (forces, under(forces))
}

fn rate(rod: &RodInHollow, y: &Pose) -> Pose {
    let (_, a) = newton_euler(rod, y);
    [y[3], y[4], y[5], a[0], a[1], a[2]]
}

#[test]
fn a_smooth_hollow_swings_the_rod_as_integrated() {
    let uniform = in_hollow();
    for rod in [uniform, RodInHollow { inertia: 0.2, ..uniform }] {
        for (start, end) in [([1.0, 0.0], -0.5), ([0.2, 1.5], 0.3), ([0.0, -2.0], -0.3)] {
            let y = pose(&rod, start);
            let sign = f64::signum(end - start[0]);
            let (_, there) = until(y, STEP, &|y| rate(&rod, y), &|y| (end - y[2]) * sign);
            let square = rod.rate_squared(start, end);
            close(square, there[5] * there[5], square, AGREEMENT, "α̇²");
            let ([a, b], [.., turning]) = newton_euler(&rod, &there);
            let forces = rod.forces(end, there[5]);
            close(forces[0], a, 10.0, AGREEMENT, "A");
            close(forces[1], b, 10.0, AGREEMENT, "B");
            close(turning, -rod.stiffness() * libm::sin(end), 10.0, AGREEMENT, "α̈");
            let energy = |y: &Pose| {
                let kinetic = rod.mass * (y[3] * y[3] + y[4] * y[4]) + rod.inertia * y[5] * y[5];
                0.5 * kinetic + rod.mass * rod.gravity * y[1]
            };
            close(energy(&there), energy(&y), 10.0, AGREEMENT, "energy");
            close(libm::hypot(there[0], there[1]), rod.depth(), 1.0, AGREEMENT, "distance from O");
        }
        for amplitude in [1e-3, 0.6, 1.3] {
            let period = rod.period(amplitude).expect("below 180°");
            let (quarter, _) = until(pose(&rod, [amplitude, 0.0]), STEP, &|y| rate(&rod, y), &|y| y[2]);
            close(period, 4.0 * quarter, period, AGREEMENT, "period");
        }
    }
}

#[test]
fn the_upper_end_lifts_first_from_the_lifting_amplitude_on() {
    let rod = in_hollow();
    let limit = rod.lifting_amplitude();
    for (amplitude, stays) in
        [(0.5 * limit, true), (limit * (1.0 - ASIDE), true), (limit * (1.0 + ASIDE), false)]
    {
        let least = |end: usize| {
            (0..=1000_u32)
                .map(|i| {
                    let tilt = amplitude * f64::from(i) / 1000.0;
                    let rate = rod.rate_squared([amplitude, 0.0], tilt).sqrt();
                    rod.forces(tilt, rate)[end]
                })
                .fold(f64::INFINITY, f64::min)
        };
        assert_eq!(least(1) >= 0.0, stays, "the upper end, {amplitude}: {}", least(1));
        assert!(least(0) > 0.0, "the lower end, {amplitude}: {}", least(0));
    }
}

/// True if some pair of forces within the friction cones holds the rod: for each inclination of the force at A the balance leaves one
/// force at B, and the borders of what is possible belong to the sides of A's cone.
fn some_forces_hold(rod: &RodInHollow, tilt: f64, friction: f64) -> bool {
    let (l, r, h) = (rod.half_length, rod.hollow_radius, rod.depth());
    // Along the rod and to O: normals and tangents of the ends.
    let (n_a, n_b) = ([l / r, h / r], [-l / r, h / r]);
    let turned = |n: [f64; 2]| [n[1], -n[0]];
    let (sin, cos) = libm::sincos(tilt);
    (0..=2000_u32).any(|i| {
        let share = friction * (f64::from(i) / 1000.0 - 1.0);
        let along_a = [n_a[0] + share * turned(n_a)[0], n_a[1] + share * turned(n_a)[1]];
        // Moments about B, then the rest of the forces: weight (−sin α, −cos α) at 0, A at −l, B at l.
        let a = cos / (2.0 * along_a[1]);
        let b = [sin - a * along_a[0], cos - a * along_a[1]];
        let normal = b[0] * n_b[0] + b[1] * n_b[1];
        let tangential = b[0] * turned(n_b)[0] + b[1] * turned(n_b)[1];
        a >= 0.0 && normal >= 0.0 && tangential.abs() <= friction * normal
    })
}

#[test]
fn the_rod_rests_up_to_the_resting_tilt_and_no_farther() {
    for half_length in [0.05, 0.2, 0.4, 0.45] {
        let rod = RodInHollow::uniform(1.3, half_length, 0.5, 9.81);
        let holds_itself = rod.depth() / half_length;
        for share in [0.01, 0.2, 0.5, 0.9, 0.99] {
            let friction = share * holds_itself;
            let limit = rod.resting_tilt(friction).expect("below cot β");
            for side in [1.0, -1.0] {
                assert!(some_forces_hold(&rod, side * limit * (1.0 - ASIDE), friction), "{rod:?} {friction}");
                assert!(
                    !some_forces_hold(&rod, side * limit * (1.0 + ASIDE), friction),
                    "{rod:?} {friction}"
                );
                let needed = rod.friction_to_rest(side * limit).expect("below 90°");
                close(needed, friction, friction, AGREEMENT, "least friction");
            }
            for part in [0.0, 0.3, 0.7] {
                assert!(some_forces_hold(&rod, part * limit, friction), "{part} of {limit}");
            }
            let angles = [libm::asin(half_length / 0.5), libm::atan(friction)];
            let by_angles = 0.5 * (libm::tan(angles[0] + angles[1]) - libm::tan(angles[0] - angles[1]));
            close(libm::tan(limit), by_angles, by_angles, AGREEMENT, "by the angles of the cones");
        }
        assert_eq!(rod.resting_tilt(holds_itself * (1.0 + ASIDE)), None, "it holds itself");
        for tilt in [0.5, 1.5, 2.5, -3.1] {
            assert!(some_forces_hold(&rod, tilt, 1.2 * holds_itself), "at every tilt: {tilt}");
        }
    }
    let point = RodInHollow::uniform(1.3, 1e-6, 0.5, 9.81);
    close(libm::tan(point.resting_tilt(0.3).expect("short")), 0.3, 1.0, AGREEMENT, "a short rod is a point");
}
