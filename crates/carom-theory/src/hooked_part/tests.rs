use super::*;

/// Rounding of a few operations on numbers of size 1.
const ROUNDING: f64 = 1e-13;
/// Steps of a swing that is followed step by step.
const STEPS: u32 = 2000;
/// What such steps of order 4 leave [s].
const STEPPED: f64 = 1e-12;

fn hangs() -> HookedPart {
    HookedPart { mass: 2.0, inertia: 0.7, arm: 0.8, normals: [0.9, 0.5], gravity: 9.81 }
}

#[test]
fn an_l_is_two_rectangles() {
    let (p, q, w) = (0.3, 0.5, 0.1);
    // Mass centre of each from the corner, length along x and along y.
    let legs = [([0.5 * (w - p), 0.5 * w], [p + w, w]), ([0.5 * w, -0.5 * q], [w, q])];
    let mass = 3.0;
    let share = |sides: [f64; 2]| mass * sides[0] * sides[1] / (w * (p + q + w));
    let centre = [0, 1].map(|i| legs.iter().map(|(at, sides)| share(*sides) * at[i]).sum::<f64>() / mass);
    let about = |(at, sides): &([f64; 2], [f64; 2])| {
        let own = (sides[0] * sides[0] + sides[1] * sides[1]) / 12.0;
        share(*sides) * (own + at[0] * at[0] + at[1] * at[1])
    };
    let part = HookedPart::of_l(mass, [p, q], w, 9.81);
    assert!((part.arm - libm::hypot(centre[0], centre[1])).abs() < ROUNDING, "{} {centre:?}", part.arm);
    let inertia: f64 = legs.iter().map(about).sum();
    assert!((part.inertia_about_edge() - inertia).abs() < ROUNDING, "{}", part.inertia_about_edge());
    // u points from the centre to the corner, the left face's normal up.
    let [x, y] = centre.map(|c| -c / part.arm);
    assert!((libm::cos(part.normals[0]) - y).abs() < ROUNDING, "{:?}", part.normals);
    assert!((libm::sin(part.normals[0]) - x).abs() < ROUNDING, "{:?}", part.normals);
    assert_eq!(part.check(), Ok(()), "an L is in the domain");
    let mirrored = HookedPart::of_l(mass, [q, p], w, 9.81);
    assert!((mirrored.normals[0] - part.normals[1]).abs() < ROUNDING, "its legs exchanged");
    assert!((mirrored.inertia - part.inertia).abs() < ROUNDING, "its legs exchanged");
}

#[test]
fn the_force_turns_the_part_and_carries_it() {
    let part = hangs();
    for state in [[0.0, 0.0], [0.4, 1.3], [-1.2, 2.0]] {
        let [along, across] = part.edge_force(state);
        let turning = -part.stiffness() * libm::sin(state[0]);
        assert!((part.inertia * turning + part.arm * across).abs() < ROUNDING, "moment about C at {state:?}");
        // Weight and force leave the acceleration of C, h(φ̈ e + φ̇² u).
        let weight = part.mass * part.gravity;
        let along_e = across - weight * libm::sin(state[0]);
        let along_u = along - weight * libm::cos(state[0]);
        assert!((along_e - part.mass * part.arm * turning).abs() < ROUNDING, "along e at {state:?}");
        assert!(
            (along_u - part.mass * part.arm * state[1] * state[1]).abs() < ROUNDING,
            "along u at {state:?}"
        );
        let [left, right] = part.face_forces([along, across]);
        let [l, r] = part.normals.map(libm::sincos);
        assert!((left * l.1 + right * r.1 - along).abs() < ROUNDING, "both faces along u at {state:?}");
        assert!((right * r.0 - left * l.0 - across).abs() < ROUNDING, "both faces along e at {state:?}");
    }
}

/// Time of a swing to a tilt, step by step in the tilt (Simpson's rule on dt = dφ/φ̇).
fn stepped(part: &HookedPart, start: [f64; 2], to: f64) -> f64 {
    let step = (to - start[0]) / f64::from(STEPS);
    let slowness = |i: u32| part.rate_squared(start, start[0] + step * f64::from(i)).sqrt().recip();
    let weight = |i: u32| if i == 0 || i == STEPS { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
    (0..=STEPS).map(|i| weight(i) * slowness(i)).sum::<f64>() * step.abs() / 3.0
}

#[test]
fn times_are_those_of_the_rate() {
    let part = hangs();
    for (start, to) in [([0.2, 3.0], 0.6), ([0.6, -1.0], -0.5), ([-0.9, 7.5], 3.0)] {
        let (ours, simple) = (part.time_between(start, to).expect("ahead"), stepped(&part, start, to));
        assert!((ours - simple).abs() < STEPPED, "{start:?} to {to}: {ours} not {simple}");
    }
    assert_eq!(part.time_between([0.2, 1.0], 2.0), None, "it turns before");
    // There and back: what is left of the period is the way through the bottom.
    let start = [0.3, 1.1];
    let amplitude = part.amplitude(start).expect("it turns");
    let period = part.period(amplitude).expect("below the top");
    let out = part.time_to_return(start).expect("it turns");
    let back = part.time_to_return([0.3, -1.1]).expect("it turns");
    assert!((out + back - period).abs() < ROUNDING, "{out} + {back} = {period}");
    let through = part.time_between([0.3, -1.1], -0.3).expect("ahead");
    assert!((back - out - 2.0 * through).abs() < ROUNDING, "{back} − {out} = 2 · {through}");
}

#[test]
fn small_swings_are_harmonic() {
    let part = hangs();
    let harmonic = 2.0 * PI * (part.inertia_about_edge() / (part.mass * part.gravity * part.arm)).sqrt();
    // T = T₀ (1 + A²/16 + …)
    for amplitude in [1e-3f64, 1e-2] {
        let ours = part.period(amplitude).expect("below the top") / harmonic - 1.0;
        let next = amplitude * amplitude / 16.0;
        assert!(
            (ours - next).abs() < next * amplitude * amplitude + ROUNDING,
            "{amplitude}: {ours} not {next}"
        );
    }
}

#[test]
fn it_slips_out_where_the_force_leaves_the_cones() {
    let part = hangs();
    for (start, friction) in [([0.0, 5.0], 0.0), ([0.0, 5.2], 0.1), ([1.4, 0.0], 0.05), ([0.1, -4.5], 0.2)] {
        let tilts = part.slipping_tilts(start, friction);
        for (face, tilt) in tilts.into_iter().enumerate() {
            let Some(tilt) = tilt else { continue };
            let holds = |factor: f64| {
                let rate = part.rate_squared(start, factor * tilt).sqrt();
                part.holds(part.edge_force([factor * tilt, rate]), friction)
            };
            assert!(holds(0.5) && holds(1.0 - ROUNDING) && !holds(1.0 + ROUNDING), "{tilt} from {start:?}");
            // There the face that slides carries all: nothing moves yet, and it is about to open.
            let (board, at) =
                part.slipping(face, [tilt, part.rate_squared(start, tilt).sqrt().copysign(tilt)], friction);
            let motion = board.motion(&at);
            assert!(motion.slip_rate.abs() < 1e2 * ROUNDING && motion.normal_force > 0.0, "{motion:?}");
            let expected = part.stiffness() * libm::sin(tilt.abs());
            assert!(
                (motion.tilt_acceleration + expected).abs() < 1e2 * ROUNDING,
                "{motion:?} not −{expected}"
            );
        }
        assert!(tilts[1].is_some(), "the normal to the right is the nearer one");
    }
    let limit = part.largest_amplitude(0.1).expect("no wedge");
    assert_eq!(part.slipping_tilts([limit - 1e-6, 0.0], 0.1), [None; 2], "it turns before");
    assert!(part.slipping_tilts([limit + 1e-6, 0.0], 0.1)[1].is_some(), "it slips out before the turn");
    // The hollow is open by π − 1.4; from half of that on as friction it is a wedge.
    let wedge = libm::tan(0.5 * (PI - 1.4)) + ROUNDING;
    assert_eq!(part.slipping_tilts([2.0, 0.0], wedge), [None; 2], "every force can be held");
    assert_eq!(part.largest_amplitude(wedge), None, "at any amplitude");
}

#[test]
fn what_is_caught_keeps_its_moment_about_the_edge() {
    let part = hangs();
    let (tilt, velocity, spin) = (0.7, [1.5, -2.0], 0.4);
    let caught = part.caught(tilt, velocity, spin);
    let (sin, cos) = libm::sincos(tilt);
    // The impulse changes the velocity to that of a turn about the edge, and its moment about C the spin.
    let [along, across] = caught.impulse.map(|p| p / part.mass);
    let after = [velocity[0] - along * sin + across * cos, velocity[1] + along * cos + across * sin];
    let turning = part.arm * caught.tilt_rate;
    assert!(
        (after[0] - turning * cos).abs() < ROUNDING && (after[1] - turning * sin).abs() < ROUNDING,
        "{after:?}"
    );
    let change = part.inertia * (caught.tilt_rate - spin);
    assert!((change + part.arm * caught.impulse[1]).abs() < ROUNDING, "{change}");
    // Caught as it turns about the edge already, nothing happens.
    let again = part.caught(tilt, after, caught.tilt_rate);
    assert!(again.impulse.iter().all(|p| p.abs() < ROUNDING), "{again:?}");
    let energy = |v: [f64; 2], w: f64| part.mass * (v[0] * v[0] + v[1] * v[1]) + part.inertia * w * w;
    assert!(energy(after, caught.tilt_rate) < energy(velocity, spin), "nothing rebounds");
}
