//! Contacts of one face: how they share what they carry, and that they have one way on.

use carom_impact::spatial::{ContactSet, Freedom, Mode, RateProblem, RigidBody, Touch, staged};
use carom_impact::{Law, Load};
use carom_num::elementary::sin_cos;
use carom_num::{Mat3, Vec3};
use carom_theory::spatial::ThreeFeet;

/// Feet at these places on one plane, from below the mass centre [m].
fn standing<const N: usize>(feet: [[f64; 2]; N], friction: f64) -> ContactSet<N> {
    let inertia = Mat3::diagonal(0.3, 0.4, 0.5);
    let body = RigidBody { mass: 1.0, inertia, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    let touch =
        |[x, y]: [f64; 2]| Touch { arm: Vec3::new(x, y, -0.2), normal: Vec3::Z, friction, restitution: 0.0 };
    ContactSet::of_free_body(&body, &feet.map(touch)).unwrap()
}

/// Normal forces under a weight of 1 N, and what they leave open.
fn carried<const N: usize>(set: &ContactSet<N>, slip: [[f64; 2]; N]) -> ([f64; N], Freedom) {
    let problem = RateProblem {
        count: N,
        operator: &set.operator,
        friction: &set.friction,
        drive: [Vec3::Z * -1.0; N],
        slip,
        load: [Load::Touching(0.0); N],
    };
    let answer = problem.solve();
    assert_eq!(answer.count, 1, "one motion: {answer:?}");
    let solution = answer.solutions[0].unwrap();
    (solution.rates.map(|p| p.z), solution.freedom)
}

/// Feet of equal stiffness carry in proportion to how far each sinks in: `1/3 + x/2 · foot`, and from `x = 2/3` on the far one would pull, so that two
/// feet carry by the lever alone.
#[test]
fn of_three_feet_in_a_row_none_pulls() {
    for step in 0..=20 {
        let x = f64::from(step) / 20.0;
        let set = standing([-1.0, 0.0, 1.0].map(|foot| [foot - x, 0.0]), 0.0);
        let (forces, freedom) = carried(&set, [[0.0; 2]; 3]);
        let expected = if x < 2.0 / 3.0 {
            [-1.0, 0.0, 1.0].map(|foot| 1.0 / 3.0 + 0.5 * x * foot)
        } else {
            [0.0, 1.0 - x, x]
        };
        let off = forces.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-13, "weight at {x}: {forces:?} instead of {expected:?}");
        assert_eq!(freedom, Freedom::Rates, "weight at {x}");
    }
}

/// Feet that slide along their row, each with a friction of its own, share as equal springs: in proportion to how far the body sinks in, whatever friction
/// does to a push.
#[test]
fn feet_of_different_friction_share_as_equal_springs() {
    let mut lifted = 0;
    for step in 0..100 {
        let part = |n: u32| f64::from(step * n % 101) / 101.0;
        let (ahead, friction) = (1.6 * part(37) - 0.8, [0.9 * part(13), 0.9 * part(29), 0.9 * part(71)]);
        let expected = ThreeFeet { apart: 1.0, ahead, height: 0.2, friction }.carried().unwrap();
        let body = RigidBody {
            mass: 1.0,
            inertia: Mat3::diagonal(0.3, 0.4, 0.5),
            velocity: Vec3::ZERO,
            spin: Vec3::ZERO,
        };
        let touch = |k: usize| Touch {
            arm: Vec3::new([-1.0, 0.0, 1.0][k] - ahead, 0.0, -0.2),
            normal: Vec3::Z,
            friction: friction[k],
            restitution: 0.0,
        };
        let set = ContactSet::<3>::of_free_body(&body, &[touch(0), touch(1), touch(2)]).unwrap();
        let (forces, _) = carried(&set, [[1.0, 0.0]; 3]);
        let off = forces.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-13, "{friction:?} at {ahead}: {forces:?} instead of {expected:?}");
        lifted += u32::from(expected.contains(&0.0));
    }
    assert!(lifted > 3, "{lifted} of 100 stand on two");
}

/// A face that slides without turning feels one force at its pressure's centre, `N μ` against the slip: the motion does not depend on how its feet share.
#[test]
fn a_face_that_slides_straight_carries_at_one_place() {
    let (friction, height) = (0.3, 0.2);
    let feet = [[0.5, 0.4], [-0.3, 0.6], [-0.6, -0.2], [0.1, -0.5], [0.7, -0.1], [-0.1, 0.1]];
    let set = standing(feet, friction);
    let (forces, freedom) = carried(&set, [[1.0, 0.0]; 6]);
    let sum = |by: fn(&[f64; 2]) -> f64| forces.iter().zip(&feet).map(|(n, foot)| n * by(foot)).sum::<f64>();
    let centre = [sum(|_| 1.0), sum(|foot| foot[0]), sum(|foot| foot[1])];
    // Friction below the mass centre presses the front.
    let expected = [1.0, friction * height, 0.0];
    let off = centre.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 1e-13 && forces.iter().all(|n| *n >= 0.0), "{forces:?}: {centre:?}");
    assert_eq!(freedom, Freedom::Rates);
}

/// A plate on feet all around it, its weight beyond half of them: one face, one motion, whichever foot is named first.
#[test]
fn hypotheses_that_say_the_same_of_a_face_are_asked_once() {
    let feet = [[0.9, 0.1], [0.5, 0.8], [-0.4, 0.9], [-0.9, 0.1], [-0.5, -0.8], [0.4, -0.9]];
    let moved = feet.map(|[x, y]| [x - 0.6, y]);
    let set = standing(moved, 0.5);
    let (mut asked, mut holding) = (0, vec![]);
    let problem = RateProblem {
        count: 6,
        operator: &set.operator,
        friction: &set.friction,
        drive: [Vec3::Z * -1.0; 6],
        slip: [[0.0; 2]; 6],
        load: [Load::Touching(0.0); 6],
    };
    let answer = problem.solve_observed(&mut |guess, _, _| {
        asked += 1;
        holding.push(guess.iter().filter(|g| g.mode != Mode::Open).count());
    });
    assert_eq!(answer.count, 1, "it rests: {answer:?}");
    assert!(holding.iter().all(|n| *n <= 2 || *n == 6), "corners, edges and the whole: {holding:?}");
    // Nothing: 1; corners: 6 · 2; edges: 6 · 4; the whole, of which one sticks: 6. Beside a solution slips that all start are not looked for.
    assert_eq!(asked, 1 + 12 + 24 + 6, "of 729, beside the one in which all stick");
}

/// A face falls on one of its edges, and its other feet join it. With rates that no springs make the edge and the whole face took turns faster and faster, and
/// the impact did not end; so they did for a whole neighbourhood of these velocities.
#[test]
fn a_face_that_falls_on_its_edge_comes_to_rest_on_it() {
    let body = RigidBody {
        mass: 1.8255,
        inertia: Mat3::diagonal(0.62714, 0.45675, 0.22064),
        velocity: Vec3::new(0.8778, 0.3851, -1.0),
        spin: Vec3::new(0.4984, 0.086, -0.3575),
    };
    let feet = [[0.3143, 0.0354], [0.3143, 0.9781], [0.3143, -0.6187], [0.3143, -0.9379], [0.7701, -0.554]];
    let touch = |[x, y]: [f64; 2]| Touch {
        arm: Vec3::new(x, y, -0.9153),
        normal: Vec3::Z,
        friction: 0.7359,
        restitution: 0.0,
    };
    for step in 0..9 {
        let moved = Vec3::new(f64::from(step % 3 - 1), f64::from(step / 3 - 1), 0.0) * 1e-3;
        let body = RigidBody { velocity: body.velocity + moved, ..body };
        let set: ContactSet<5> = ContactSet::of_free_body(&body, &feet.map(touch)).unwrap();
        let outcome = staged::resolve(&set, Law::Poisson).unwrap_or_else(|why| panic!("{moved:?}: {why}"));
        assert!(outcome.stages <= 8, "{moved:?}: {} stages", outcome.stages);
        let left = outcome.velocity.map(|u| u.z.abs()).into_iter().fold(0.0, f64::max);
        assert!(left < 1e-12, "{moved:?}: it rests on its whole face but for {left}");
    }
}

/// A body whose mass centre is above a row of three of its feet falls flat: the two others carry nothing but rounding, which must not decide who does.
#[test]
fn feet_that_carry_nothing_do_not_decide_how_others_share() {
    let body = RigidBody {
        mass: 1.0,
        inertia: Mat3::diagonal(0.1, 0.12, 0.15),
        velocity: -Vec3::Z,
        spin: Vec3::ZERO,
    };
    let feet = [[0.0, -0.3], [0.0, 0.05], [0.0, 0.4], [-0.3, -0.3], [-0.3, 0.4]];
    let after = |order: [usize; 5]| {
        let touch = |i: usize| Touch {
            arm: Vec3::new(feet[i][0], feet[i][1], -0.9246),
            normal: Vec3::Z,
            friction: 0.3,
            restitution: [0.9, 0.1, 0.5, 0.0, 0.0][i],
        };
        let set: ContactSet<5> = ContactSet::of_free_body(&body, &order.map(touch)).unwrap();
        let outcome = staged::resolve(&set, Law::Poisson).unwrap();
        let mut rises = [0.0; 5];
        order.iter().zip(outcome.velocity).for_each(|(i, u)| rises[*i] = u.z);
        rises
    };
    let first = after([0, 1, 2, 3, 4]);
    for order in [[0, 2, 1, 4, 3], [4, 3, 2, 1, 0], [3, 1, 4, 0, 2], [1, 4, 0, 3, 2]] {
        let off = after(order).iter().zip(first).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-12, "in the order {order:?} it rises otherwise by {off}");
    }
}

/// A bar in an inclined V groove of a right angle: each side carries √½ of what presses it in, and it starts to slide along the groove with
/// `g (sin α − √2 μ cos α)`, all of its contacts together, however many they are.
fn starts_along_a_groove<const N: usize>() {
    let (friction, slope) = (0.05, 0.5);
    let c = 0.5_f64.sqrt();
    let body = RigidBody {
        mass: 1.0,
        inertia: Mat3::diagonal(0.09, 0.01, 0.09),
        velocity: Vec3::ZERO,
        spin: Vec3::ZERO,
    };
    let touches: [Touch; N] = std::array::from_fn(|k| {
        let side = if k % 2 == 0 { 1.0 } else { -1.0 };
        let y = f64::from(u32::try_from(k / 2).unwrap()) / f64::from(u32::try_from(N / 2 - 1).unwrap()) - 0.5;
        let arm = Vec3::new(0.1 * side * c, y, -0.1 * c);
        Touch { arm, normal: Vec3::new(-side * c, 0.0, c), friction, restitution: 0.0 }
    });
    let set: ContactSet<N> = ContactSet::of_free_body(&body, &touches).unwrap();
    set.check().unwrap();
    let (sin, cos) = sin_cos(slope);
    let weight = Vec3::new(0.0, sin, -cos) * 9.81;
    let problem = RateProblem {
        count: N,
        operator: &set.operator,
        friction: &set.friction,
        drive: set.frame.map(|frame| frame * weight),
        slip: [[0.0; 2]; N],
        load: [Load::Touching(0.0); N],
    };
    let answer = problem.solve_first();
    assert_eq!(answer.count, 1, "{answer:?}");
    let solution = answer.solutions[0].unwrap();
    assert_eq!(solution.guess.map(|g| g.mode), [Mode::Starts; N], "all of it slides");
    let expected = 9.81 * (sin - 2.0_f64.sqrt() * friction * cos);
    for (i, response) in solution.response.iter().enumerate() {
        let along = (set.frame[i].transposed() * *response).y;
        assert!((along - expected).abs() < 1e-12, "contact {i}: {along} instead of {expected}");
    }
}

#[test]
fn a_bar_starts_to_slide_along_a_groove() {
    starts_along_a_groove::<6>();
    starts_along_a_groove::<8>();
    starts_along_a_groove::<10>();
    starts_along_a_groove::<16>();
}

/// A bar that strikes a groove with five feet on each side, askew and turning, comes to a motion in which none of them approaches.
#[test]
fn many_feet_strike_a_groove() {
    let c = 0.5_f64.sqrt();
    for case in 0..6_u32 {
        let part = |n: u32| f64::from((case + 1) * n % 101) / 101.0 - 0.5;
        let body = RigidBody {
            mass: 1.0,
            inertia: Mat3::diagonal(0.09, 0.02, 0.1),
            velocity: Vec3::new(0.3 * part(37), 2.0 * part(13), -1.0),
            spin: Vec3::new(part(29), part(71), part(53)),
        };
        let touches: Vec<Touch> = (0..10)
            .map(|k| {
                let side = if k % 2 == 0 { 1.0 } else { -1.0 };
                let (along, up) = (0.25 * f64::from(k / 2) - 0.5, 0.02 * f64::from(k * k % 7));
                let arm = Vec3::new((0.1 + up) * side * c, along, (up - 0.1) * c);
                Touch { arm, normal: Vec3::new(-side * c, 0.0, c), friction: 0.3, restitution: 0.2 }
            })
            .collect();
        let set = ContactSet::<10>::of_free_body(&body, &touches).unwrap();
        let out = staged::resolve(&set, Law::Poisson).unwrap();
        for (i, after) in set.after(&out.impulse).iter().enumerate() {
            assert!(after.z > -1e-9, "{case}: contact {i} approaches with {}", after.z);
        }
    }
}
