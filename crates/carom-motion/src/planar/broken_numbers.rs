//! Every evaluation of a run, put out of being a number in its turn, alone and with all that follow: an error by name, never a panic, an endless search
//! or a result. Where it was lost alone, in a step that was tried and was not taken, the run ends as it would have.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::MotionError;
use crate::evaluated::Quantity;
use crate::evaluated::faults::{Fault, during};
use crate::planar::{
    contact::World,
    geometry::{Body, Obstacle, Pose, Shape, State, Surface, Twist},
    record::Recorder,
    several::Crowd,
    walk::{Happening, Options, Walker},
};
use carom_impact::Law;
use carom_num::Vec2;

/// Simulated time [s], and events, of a run.
const MOST_TIME: f64 = 1.0;
const MOST_EVENTS: u64 = 25;
/// How far [m, rad] two runs end from each other that differ in the length of a step.
const SAME: f64 = 1e-6;
/// How often as many evaluations a spoiled run may make as the run itself.
const MOST_TIMES: u64 = 40;
/// A search gives up after some thousand steps of some hundred evaluations.
const MOST_IN_VAIN: u64 = 1_000_000;

struct Case {
    name: &'static str,
    world: World,
    /// One for each body.
    starts: Vec<State>,
    tolerance: f64,
}

fn segment(from: (f64, f64), to: (f64, f64), friction: f64, restitution: f64) -> Obstacle {
    Obstacle::new(Vec2::new(from.0, from.1), Vec2::new(to.0, to.1), friction, restitution)
}

fn body(corners: &[(f64, f64)], radius: f64) -> Body {
    let shape = Shape::new(corners.iter().map(|(x, y)| Vec2::new(*x, *y)).collect(), radius).unwrap();
    Body { shape, mass: 0.3, inertia: 2.5e-4 }
}

fn at(x: f64, y: f64, angle: f64, velocity: (f64, f64), spin: f64) -> State {
    State {
        pose: Pose { centre: Vec2::new(x, y), angle },
        twist: Twist { velocity: Vec2::new(velocity.0, velocity.1), spin },
    }
}

const GRAVITY: Vec2 = Vec2::new(0.0, -9.81);
const CORNERS: [(f64, f64); 4] = [(-0.04, -0.02), (0.04, -0.02), (0.04, 0.02), (-0.04, 0.02)];

/// A floor and a wall.
fn room() -> Vec<Obstacle> {
    vec![segment((-2.0, 0.0), (2.0, 0.0), 0.2, 0.5), segment((0.3, 0.0), (0.3, 1.0), 0.2, 0.5)]
}

/// A rod on a plate that slopes to the right by the arc tangent of 3/8, short of its end; below it a second plate and a wall.
fn feeder() -> Case {
    let slope = Vec2::new(8.0, -3.0) / 73.0_f64.sqrt();
    let end = slope * 0.14;
    let obstacles = vec![
        segment((0.0, 0.0), (end.x, end.y), 0.1, 0.1),
        segment((0.4, -0.3), (0.05, -0.3), 0.3, 0.1),
        segment((0.4, -0.6), (0.4, 0.3), 0.2, 0.1),
    ];
    let world = World::of_one(GRAVITY, body(&[(-0.05, 0.0), (0.05, 0.0)], 0.0), obstacles, Law::Poisson);
    let angle = carom_num::elementary::atan2(slope.y, slope.x);
    let centre = slope * 0.06;
    let starts = vec![at(centre.x, centre.y, angle, (0.0, 0.0), 0.0)];
    Case { name: "feeder", world, starts, tolerance: 1e-11 }
}

/// A part that slides off a plate, tips, falls and lands; a ball that bounces; boxes that are thrown; rods that tip over a plate's end and slip down a wall; two boxes of
/// which one falls on the other.
fn cases() -> Vec<Case> {
    let ball = World::of_one(GRAVITY, body(&[(0.0, 0.0)], 0.03), room(), Law::Poisson);
    let thrown = World::of_one(GRAVITY, body(&CORNERS, 0.0), room(), Law::Stronge);
    let rounded = World::of_one(GRAVITY, body(&CORNERS, 0.004), room(), Law::Newton);
    let edge = vec![segment((-0.5, 0.0), (0.0, 0.0), 0.2, 0.0)];
    let tipping = World::of_one(GRAVITY, body(&[(-0.05, 0.0), (0.05, 0.0)], 0.005), edge, Law::Poisson);
    // Its ends touch the floor and the wall, and too little friction holds them: the arc cosine of 3/5 is less steep than that takes.
    let leaning = World::of_one(GRAVITY, body(&[(-0.05, 0.0), (0.05, 0.0)], 0.0), room(), Law::Poisson);
    let lean = at(0.27, 0.04, carom_num::elementary::atan2(4.0, 3.0), (0.0, 0.0), 0.0);
    vec![
        feeder(),
        Case {
            name: "ball",
            world: ball,
            starts: vec![at(0.0, 0.1, 0.0, (0.6, 0.0), 1.0)],
            tolerance: 1e-11,
        },
        Case {
            name: "box",
            world: thrown,
            starts: vec![at(0.1, 0.1, 0.4, (0.8, -0.3), 5.0)],
            tolerance: 1e-8,
        },
        Case {
            name: "rounded",
            world: rounded,
            starts: vec![at(0.1, 0.08, 1.0, (0.5, 0.0), -3.0)],
            tolerance: 1e-11,
        },
        Case {
            name: "tipping",
            world: tipping,
            starts: vec![at(0.01, 0.005, 0.0, (0.0, 0.0), 0.0)],
            tolerance: 1e-9,
        },
        Case { name: "leaning", world: leaning, starts: vec![lean], tolerance: 1e-9 },
        two(),
    ]
}

/// A box that falls askew on one at rest.
fn two() -> Case {
    let world = World {
        gravity: GRAVITY,
        bodies: vec![body(&CORNERS, 0.0), body(&CORNERS, 0.0)],
        obstacles: room(),
        between: Surface { friction: 0.3, restitution: 0.2 },
        law: Law::Poisson,
    };
    let starts = vec![at(0.0, 0.02, 0.0, (0.0, 0.0), 0.0), at(0.03, 0.09, 0.3, (0.1, 0.0), 0.0)];
    Case { name: "two", world, starts, tolerance: 1e-9 }
}

/// What a run comes to: all of it in words, and the pieces and impacts of each body and where it is at last.
#[derive(Debug, PartialEq)]
struct Outcome {
    words: String,
    bodies: Vec<(usize, usize, State)>,
}

impl Outcome {
    fn of(recorders: &[Recorder]) -> Self {
        let traces: Vec<_> = recorders.iter().map(Recorder::trace).collect();
        let bodies = traces.iter().map(|t| (t.pieces.len(), t.impacts.len(), t.pieces.last().unwrap().end));
        Self { words: format!("{traces:?}"), bodies: bodies.collect() }
    }

    /// The same pieces and impacts, and the same end but for the accuracy of a step.
    fn is_as(&self, other: &Self) -> bool {
        let near = |a: &State, b: &State| {
            (a.pose.centre - b.pose.centre).norm() <= SAME && (a.pose.angle - b.pose.angle).abs() <= SAME
        };
        let all = |(a, b): (&(usize, usize, State), &(usize, usize, State))| {
            (a.0, a.1) == (b.0, b.1) && near(&a.2, &b.2)
        };
        !self.words.contains("NaN") && self.bodies.iter().zip(&other.bodies).all(all)
    }
}

fn run(case: &Case) -> Result<Outcome, MotionError> {
    let options = Options { tolerance: case.tolerance, most_time: MOST_TIME, most_events: MOST_EVENTS };
    let sides = vec![true; case.world.obstacles.len()];
    let mut recorders = vec![Recorder::default(); case.starts.len()];
    if let [start] = case.starts[..] {
        let mut walker = Walker::new(&case.world, start, sides, options)?;
        while walker.advance(&mut recorders[0])? == Happening::Moves {}
        return Ok(Outcome::of(&recorders));
    }
    let mut crowd = Crowd::new(&case.world, options);
    for (body, start) in case.starts.iter().enumerate() {
        crowd.enter(body, *start, sides.clone())?;
    }
    // One that rests may be struck by the other.
    while crowd.advance(MOST_TIME, &mut recorders)?.happening != Happening::BudgetSpent
        && crowd.time() < MOST_TIME
    {}
    Ok(Outcome::of(&recorders))
}

/// Spoils every evaluation of a quantity in every run; returns how many there were.
fn spoil(of: Quantity) -> u64 {
    let (mut all, mut recovered) = (0, 0);
    for case in cases() {
        let (whole, count) = during(of, Fault::Never, u64::MAX, || run(&case));
        let whole = whole.unwrap();
        let words = &whole.words;
        assert!(!words.contains("NaN") && !words.contains("inf"), "{}: {words}", case.name);
        for k in 0..count {
            let with = |fault| during(of, fault, MOST_TIMES * count + MOST_IN_VAIN, || run(&case)).0;
            let told = with(Fault::From(k));
            assert!(told.is_err(), "{}: {of:?} from {k} of {count} on is not told", case.name);
            let once = with(Fault::At(k));
            let (told, harmless) = (once.is_err(), once.is_ok_and(|o| o.is_as(&whole)));
            assert!(told || harmless, "{}: {of:?} {k} of {count} is not told", case.name);
            recovered += u64::from(harmless);
        }
        let (again, _) = during(of, Fault::Never, u64::MAX, || run(&case));
        assert!(again == Ok(whole), "{}: what was lost is in the way of the next run", case.name);
        all += count;
    }
    assert!(recovered < all, "none of {all} is told");
    all
}

macro_rules! told {
    ($($name:ident: $of:ident, $least:literal;)*) => { $(
        #[test]
        fn $name() {
            let count = spoil(Quantity::$of);
            assert!(count >= $least, "{count} evaluations");
        }
    )* };
}

told! {
    lost_turns_are_told: Turn, 1000;
    lost_gaps_are_told: Gap, 1000;
    lost_distances_are_told: Distance, 100;
    lost_accelerations_are_told: Acceleration, 100;
    lost_coefficients_are_told: Coefficient, 10;
    lost_flights_are_told: Flight, 1000;
    lost_event_functions_are_told: Event, 100;
}

#[test]
fn what_has_lost_a_number_goes_nowhere() {
    let case = feeder();
    let mut walker = Walker::new(&case.world, case.starts[0], vec![], Options::default()).unwrap();
    let (first, _) = during(Quantity::Gap, Fault::At(0), u64::MAX, || walker.advance(&mut ()));
    assert!(matches!(first, Err(MotionError::NotFinite { .. })), "{first:?}");
    let again = walker.advance(&mut ());
    assert!(matches!(again, Err(MotionError::NotFinite { .. })), "without the fault: {again:?}");
}
