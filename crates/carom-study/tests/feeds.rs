//! feeds
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::print_stdout, reason = "measure")]
use carom_feeder::{Feed, Feeder, Part, Plate, Start, Stop};
use carom_impact::planar::Law;
use carom_motion::planar::Surface;
use carom_num::Vec2;
use carom_study::feeds::{Plan, search};

fn slope(downhill_left: bool, degrees: f64, edge: (f64, f64), length: f64) -> (Vec2, Vec2) {
    let angle = degrees.to_radians();
    let along = Vec2::at_angle(if downhill_left { std::f64::consts::PI + angle } else { -angle });
    let edge = Vec2::new(edge.0, edge.1);
    (edge - along * length, edge)
}

fn example() -> Feeder {
    let plate = |name: &str, (uphill, edge): (Vec2, Vec2)| Plate {
        name: name.into(),
        uphill,
        edge,
        friction: 0.3,
        restitution: 0.1,
        unbounded: false,
    };
    Feeder {
        gravity: 9.81,
        stop: Stop::Delivered,
        law: Law::Poisson,
        part: Part::rectangle(0.06, 0.02, 0.1, 0.1 * (0.06f64.powi(2) + 0.02f64.powi(2)) / 12.0).unwrap(),
        start: Start { to_edge: 0.12, speed: 0.0, face: 0 },
        plates: vec![
            plate("upper", slope(false, 30.0, (0.0, 0.0), 0.2)),
            plate("lower", slope(true, 14.0, (-0.18, -0.19), 0.44)),
        ],
        walls: vec![],
    }
}

#[test]
fn first_look() {
    let feed = Feed { parts: 3, interval: 1.0, between: Surface { friction: 0.2, restitution: 0.2 } };
    for degrees in [14.0, 25.0] {
        let mut f = example();
        let (u, e) = slope(true, degrees, (-0.18, -0.19), 0.44);
        f.plates[1].uphill = u;
        f.plates[1].edge = e;
        let t = std::time::Instant::now();
        match search(&f, &feed, &Plan::default(), |_| None, || ()) {
            Ok(found) => {
                println!(
                    "{:?} {} longest {:?} smallest {:?} unres {} runs {} pieces {} {:?}",
                    found.alone.outcome,
                    found.alone.end_time,
                    found.longest,
                    found.smallest,
                    found.unresolved,
                    found.runs,
                    found.stretches.len(),
                    t.elapsed()
                );
            }
            Err(e) => println!("{e}"),
        }
    }
}
