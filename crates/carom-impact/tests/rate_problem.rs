//! The rate problem where its answer is known: one motion, several, none, and forces that are not determined.

use carom_impact::Load;
use carom_impact::planar::rate::RateProblem;
use carom_impact::planar::{Answer, Condition, ContactSet2, Slip, Touch};
use carom_num::Vec2;

/// Some hundred roundings of forces of order ten.
const ROUNDING: f64 = 1e-13;

/// Gravity of 10 m/s² along `down` on touching contacts of a body of 1 kg.
fn ask(inertia: f64, touches: &[Touch], down: Vec2, slip: f64) -> (Answer<2>, Vec<Condition>) {
    let set = ContactSet2::of_free_body(1.0, inertia, Vec2::ZERO, 0.0, touches).unwrap();
    let (mut drive, mut load) = ([[0.0; 2]; 2], [Load::Absent; 2]);
    for (i, t) in touches.iter().enumerate() {
        drive[i] = [10.0 * t.normal.turned_right().dot(down), 10.0 * t.normal.dot(down)];
        load[i] = Load::Touching(0.0);
    }
    let problem = RateProblem::<2, 4> {
        count: set.count,
        operator: &set.operator,
        friction: &set.friction,
        drive,
        slip: [slip; 2],
        load,
    };
    let mut rejected = vec![];
    let answer = problem.solve_observed(&mut |_, broken| rejected.push(broken.condition));
    (answer, rejected)
}

fn on_floor(x: f64, y: f64, friction: f64) -> Touch {
    Touch { arm: Vec2::new(x, y), normal: Vec2::new(0.0, 1.0), friction, restitution: 0.0 }
}

/// A uniform rod of length 2 m whose lower end touches, 45° from the floor: W_nn = 1 + 3/2, W_tn = −(−½)·3 in magnitude.
fn leaning_rod(friction: f64, slip: f64) -> (Answer<2>, Vec<Condition>) {
    let half = 0.5f64.sqrt();
    ask(1.0 / 3.0, &[on_floor(-half, -half, friction)], Vec2::new(0.0, -1.0), slip)
}

#[test]
fn a_block_on_an_incline_holds_below_the_friction_angle_only() {
    // One contact below the mass centre, without turning: an inertia that no force turns.
    for (slope, expected) in [(0.29, Slip::Sticks), (0.31, Slip::Forward)] {
        let down = Vec2::new(slope, -1.0) / Vec2::new(slope, 1.0).norm();
        let (answer, rejected) = ask(f64::INFINITY, &[on_floor(0.0, -0.5, 0.3)], down, 0.0);
        assert_eq!(answer.count, 1, "unique at slope {slope}");
        let solution = answer.solutions[0].unwrap();
        assert_eq!(solution.guess[0].slip, expected, "slope {slope}");
        assert!((solution.rates[0][1] - 10.0 * -down.y).abs() < 1e-14, "N = m g cos");
        assert_eq!(rejected.len(), 3, "open, and the two that are not so, are rejected: {rejected:?}");
        assert!(rejected.contains(&Condition::Opens(0)), "without a force it would fall in: {rejected:?}");
    }
}

#[test]
fn a_rod_that_slips_into_its_lean_has_no_motion_beyond_painleves_friction() {
    // W_nn − sμW_tn = 5/2 − 3/2 μ for the slip that digs in.
    let digging = |friction: f64| [1.0, -1.0].map(|slip| leaning_rod(friction, slip).0.count);
    assert_eq!(digging(1.6).iter().filter(|&&n| n == 1).count(), 2, "below 5/3 both slips have one motion");
    assert_eq!(digging(1.7).iter().filter(|&&n| n == 0).count(), 1, "above 5/3 one slip has none");
}

#[test]
fn a_rod_pulled_off_may_leave_or_jam_beyond_painleves_friction() {
    let half = 0.5f64.sqrt();
    let pulled = |slip| ask(1.0 / 3.0, &[on_floor(-half, -half, 1.7)], Vec2::new(0.0, 1.0), slip).0;
    let counts = [1.0, -1.0].map(|slip| pulled(slip).count);
    assert!(
        counts.contains(&2) && counts.contains(&1),
        "leaves, or is also held by its friction: {counts:?}"
    );
}

#[test]
fn a_box_at_rest_on_two_corners_has_one_motion_and_undetermined_forces() {
    let corners = [on_floor(-1.0, -0.5, 0.5), on_floor(1.0, -0.5, 0.5)];
    let (answer, _) = ask(0.5, &corners, Vec2::new(0.0, -1.0), 0.0);
    assert_eq!(answer.count, 1, "{answer:?}");
    let solution = answer.solutions[0].unwrap();
    assert!(solution.response.iter().flatten().all(|w| w.abs() < ROUNDING), "it rests: {solution:?}");
    assert!(solution.indeterminate, "its corners may press sideways against each other: {solution:?}");
    let [a, b] = solution.rates;
    assert!(
        (a[1] - 5.0).abs() < ROUNDING && (b[1] - 5.0).abs() < ROUNDING,
        "half the weight each: {solution:?}"
    );
    assert!((a[0] + b[0]).abs() < ROUNDING, "friction cancels: {solution:?}");
}

#[test]
fn a_drive_that_is_no_number_has_no_solution() {
    let (answer, _) = ask(1.0, &[on_floor(0.0, -1.0, 0.5)], Vec2::new(f64::NAN, -1.0), 0.0);
    assert_eq!(answer.count, 0, "{answer:?}");
}
