//! Single judgements of a course.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;
use crate::feeder::{Feeder, Part, Plate, Start};
use carom_impact::planar::Slip;
use carom_motion::planar::{Effort, Feature, Margin, MarginOf, Obstacle, Options, Pose, Twist};

/// A part that is where and as it is told.
struct Told {
    state: State,
    /// Each obstacle it touches, and the face that lies there.
    held: Vec<(usize, Option<usize>)>,
}

impl PartView for Told {
    fn time(&self) -> f64 {
        1.0
    }

    fn state(&self) -> State {
        self.state
    }

    fn each_held(&self, look: &mut dyn FnMut(HeldContact)) {
        let feature = Feature::VertexOnFace { vertex: 0, face: Obstacle::LEFT };
        self.held
            .iter()
            .for_each(|(obstacle, _)| look(HeldContact { obstacle: *obstacle, feature, slip: Slip::Sticks }));
    }

    fn flat_on(&self, obstacle: usize) -> Option<usize> {
        self.held.iter().find(|(on, _)| *on == obstacle)?.1
    }

    fn outlook(&self) -> Outlook {
        Outlook::Bound
    }

    fn effort(&self) -> Effort {
        Effort::default()
    }

    fn margin(&self) -> Margin {
        Margin { value: f64::INFINITY, of: MarginOf::Nothing, time: 0.0 }
    }
}

/// Two plates, the last of which falls 3 in 4 to the right and ends at the origin.
fn feeder() -> Feeder {
    let plate = |name: &str, uphill: (f64, f64), edge: (f64, f64)| Plate {
        name: name.to_owned(),
        uphill: Vec2::new(uphill.0, uphill.1),
        edge: Vec2::new(edge.0, edge.1),
        friction: 0.2,
        restitution: 0.0,
        unbounded: false,
        form: Default::default(),
    };
    Feeder {
        gravity: 9.81,
        stop: Stop::Delivered,
        law: Default::default(),
        part: Part::rectangle(0.1, 0.02, 0.3, 2.5e-4).unwrap(),
        start: Start { to_edge: 0.2, speed: 0.0, face: 0 },
        plates: vec![plate("upper", (-1.0, 1.6), (-0.5, 1.4)), plate("last", (-0.8, 0.6), (0.0, 0.0))],
        walls: vec![],
    }
}

/// Beyond the last plate's edge, in free motion with this velocity.
fn beyond(velocity: (f64, f64)) -> Told {
    let pose = Pose { centre: Vec2::new(0.08, -0.05), angle: 0.0 };
    let twist = Twist { velocity: Vec2::new(velocity.0, velocity.1), spin: 0.0 };
    Told { state: State { pose, twist }, held: vec![] }
}

#[test]
fn a_part_beyond_the_edge_leaves_only_while_it_moves_downhill() {
    let feeder = feeder();
    let prepared = feeder.prepare(Options::default()).unwrap();
    let mut nobody = ();
    let mut watcher = Watcher::new(&prepared, 0.0, &mut nobody);
    watcher.plates[1].first_touch = Some(0.5);
    let leaves = |part: &Told| {
        let mut course = Course::new(&prepared);
        course.note_leaving(part, &watcher);
        course.left.is_some()
    };
    assert!(leaves(&beyond((0.8, -0.6))), "downhill");
    assert!(!leaves(&beyond((-0.8, 0.6))), "back uphill: it comes back over the edge");
    assert!(!leaves(&beyond((0.0, 0.0))), "at the top of its way");
}

#[test]
fn a_part_whose_one_face_lies_across_two_plates_is_stuck_not_jammed() {
    let feeder = feeder();
    let prepared = feeder.prepare(Options::default()).unwrap();
    let rests = |held: &[(usize, Option<usize>)]| {
        let part = Told { held: held.to_vec(), ..beyond((0.0, 0.0)) };
        Course::new(&prepared).resting(&part)
    };
    assert_eq!(rests(&[(1, Some(0))]), Outcome::Stuck, "a face on one plate");
    assert_eq!(rests(&[(0, Some(0)), (1, Some(0))]), Outcome::Stuck, "the same face on two in line");
    assert_eq!(rests(&[(0, Some(0)), (1, Some(2))]), Outcome::Jammed, "between two plates");
    assert_eq!(rests(&[(0, Some(0)), (1, None)]), Outcome::Jammed, "a face on one, a corner on the other");
    assert_eq!(rests(&[(1, Some(1))]), Outcome::OnEnd, "a short face");
}
