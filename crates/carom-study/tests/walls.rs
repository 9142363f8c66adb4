//! A layout may be asked to work without its walls.

use carom_feeder::{Feeder, Part, PartKind, Plate, Start, Stop, Wall};
use carom_impact::Law;
use carom_motion::planar::{Body, Shape};
use carom_num::Vec2;
use carom_study::design::{Aim, Demand, Goal, Limits};

/// A disc that slides 2 m down a slope of 3 in 4 without friction, then falls 1.25 m onto a tray.
fn disc(walls: &[f64]) -> Feeder {
    let shape = Shape::new(vec![Vec2::ZERO], 0.06).unwrap();
    let plate = |name: &str, uphill, edge| Plate {
        name: name.into(),
        uphill,
        edge,
        friction: 0.0,
        restitution: 0.0,
        unbounded: false,
        form: Default::default(),
    };
    let wall = |x: &f64| Wall {
        name: format!("wall at {x}"),
        from: Vec2::new(*x, 1.0),
        to: Vec2::new(*x, -2.0),
        friction: 0.0,
        restitution: 0.3,
        form: Default::default(),
    };
    Feeder {
        gravity: 10.0,
        stop: Stop::Landed,
        law: Law::Poisson,
        part: Part { kind: PartKind::Disc, body: Body { shape, mass: 1.0, inertia: 0.0018 } },
        start: Start { to_edge: 2.0, speed: 0.0, face: 0 },
        plates: vec![
            plate("slope", Vec2::new(-4.0, 3.0), Vec2::ZERO),
            plate("tray", Vec2::new(-1.0, -1.262), Vec2::new(9.0, -1.262)),
        ],
        walls: walls.iter().map(wall).collect(),
    }
}

/// From the edge it flies 0.8·√24 m/s across, and falls with 0.6·√24 m/s at first: 1.25 m take 0.286 s, in which it comes 1.12 m far. A wall
/// at 0.7 m is in its way, one at 5 m is not.
#[test]
fn a_wall_that_is_struck_is_touched_and_no_other() {
    let goal = |no_wall: bool| {
        let limits = Limits { no_wall, ..Limits::default() };
        Goal { limits, aim: Aim::Yield, seed: 1, scanned: 16, confirming: 1 }
    };
    for (walls, touched) in [(vec![5.0], vec![]), (vec![5.0, 0.7], vec![1]), (vec![], vec![])] {
        let feeder = disc(&walls);
        let run = feeder.run_untraced().unwrap();
        assert_eq!(run.walls_touched, touched, "walls at {walls:?}");
        assert_eq!(feeder.run().unwrap().walls_touched, touched, "with a trace too");
        let keeps = touched.is_empty();
        assert_eq!(goal(true).limits.keeps(&run), keeps, "walls at {walls:?} under tolerances");
        assert!(goal(false).limits.keeps(&run), "nobody asks");
        let failed = |no_wall: bool| goal(no_wall).judged(&feeder, [13.0, 4.262], &run, true).failed;
        let expected = if keeps { vec![] } else { vec![Demand::Walls] };
        assert_eq!(failed(true), expected, "walls at {walls:?} where nothing varies");
        assert!(failed(false).is_empty(), "nobody asks");
    }
}
