//! Every evaluation of a run in space, put out of being a number in its turn, alone and with all that follow: an error by name, never a panic, an endless search or a
//! result. Where it was lost alone, in a step that was tried and was not taken, the run ends as it would have.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::{Body, Friction, Options, Run, State, World, run};
use crate::MotionError;
use crate::evaluated::Quantity;
use crate::evaluated::faults::{Fault, during};
use carom_num::{Mat3, Rotation, Vec3};

/// Impacts of a run.
const MOST_IMPACTS: u64 = 4;
/// How far [m, rad, m/s, rad/s] two runs end from each other that differ in the length of a step.
const SAME: f64 = 1e-6;
/// How often as many evaluations a spoiled run may make as the run itself, and how many more a search may make that gives up.
const MOST_TIMES: u64 = 40;
const MOST_IN_VAIN: u64 = 1_000_000;

struct Case {
    name: &'static str,
    world: World,
    start: State,
}

/// A body of 1 kg, as wide as a unit cube in every direction, on these corners.
fn body(corners: &[Vec3]) -> Body {
    let moment = 1.0 / 6.0;
    Body::new(1.0, Mat3::diagonal(moment, moment, moment), corners.to_vec()).unwrap()
}

fn world(body: Body, friction: Option<Friction>) -> World {
    let world = World::new(body, Vec3::Z * -9.81).unwrap();
    match friction {
        Some(friction) => world.with_friction(friction).unwrap(),
        None => world,
    }
}

/// A stool that is let go from a tilt and nothing of which slides; the same with little friction and a spin; a cube that is thrown and rebounds.
fn cases() -> Vec<Case> {
    let corner = |k: u8, z: f64| {
        let sign = |bit: u8| if k >> bit & 1 == 1 { 0.5 } else { -0.5 };
        Vec3::new(sign(0), sign(1), z)
    };
    let feet: Vec<Vec3> = (0..4).map(|k| corner(k, -0.5)).collect();
    let stool = body(&feet);
    let tilted = Rotation::by(Vec3::new(0.1, -0.05, 0.0));
    let standing = State::standing(&stool, 0, tilted, Vec3::ZERO);
    let turning = State::standing(&stool, 0, tilted, Vec3::new(0.0, 0.0, 0.5));
    let corners: Vec<Vec3> = (0..8).map(|k| corner(k, if k < 4 { -0.5 } else { 0.5 })).collect();
    let thrown = State {
        centre: Vec3::Z * 1.2,
        attitude: Rotation::by(Vec3::new(0.5, 0.3, 0.2)),
        velocity: Vec3::new(0.5, 0.0, -1.0),
        spin: Vec3::new(0.3, -0.4, 0.2),
    };
    vec![
        Case { name: "held", world: world(stool.clone(), None), start: standing },
        Case { name: "sliding", world: world(stool, Some(Friction::new(0.2))), start: turning },
        Case {
            name: "thrown",
            world: world(body(&corners), Some(Friction::new(0.3).with_restitution(0.4))),
            start: thrown,
        },
    ]
}

fn moved(case: &Case) -> Result<Run, MotionError> {
    let options = Options { most_impacts: MOST_IMPACTS, ..Options::default() };
    run(&case.world, &case.start, &options, &mut ())
}

/// The same impacts and the same end, but for the accuracy of a step.
fn alike(a: &Run, b: &Run) -> bool {
    let turned = (a.state.attitude.v - b.state.attitude.v).norm();
    let apart =
        [a.state.centre - b.state.centre, a.state.velocity - b.state.velocity, a.state.spin - b.state.spin];
    let near = apart.iter().all(|d| d.norm() <= SAME) && turned <= SAME;
    near && a.end == b.end && a.impacts.len() == b.impacts.len() && a.state.is_finite()
}

/// Spoils every evaluation of a quantity in every run; returns how many there were.
fn spoil(of: Quantity) -> u64 {
    let (mut all, mut recovered) = (0, 0);
    for case in cases() {
        let (whole, count) = during(of, Fault::Never, u64::MAX, || moved(&case));
        let whole = whole.unwrap();
        assert_eq!(
            whole.friction_work < 0.0,
            case.name == "sliding",
            "{}: what it does between impacts",
            case.name
        );
        for k in 0..count {
            let with = |fault| during(of, fault, MOST_TIMES * count + MOST_IN_VAIN, || moved(&case)).0;
            let told = with(Fault::From(k));
            assert!(told.is_err(), "{}: {of:?} from {k} of {count} on is not told: {told:?}", case.name);
            let once = with(Fault::At(k));
            let (told, harmless) = (once.is_err(), once.as_ref().is_ok_and(|o| alike(o, &whole)));
            assert!(told || harmless, "{}: {of:?} {k} of {count} is not told: {once:?}", case.name);
            recovered += u64::from(harmless);
        }
        let (again, _) = during(of, Fault::Never, u64::MAX, || moved(&case));
        assert!(again == Ok(whole), "{}: what was lost is in the way of the next run", case.name);
        all += count;
    }
    assert!(recovered < all, "none of {all} is told");
    all
}

#[test]
fn lost_heights_are_told() {
    assert!(spoil(Quantity::Gap) >= 100);
}

#[test]
fn lost_rates_are_told() {
    assert!(spoil(Quantity::Acceleration) >= 100);
}

#[test]
fn lost_event_functions_are_told() {
    assert!(spoil(Quantity::Event) >= 100);
}
