//! A part on a plate that is bent a little, beside the same plate where it is straight or has a thickness.

use carom_feeder::{Feeder, Form, Outcome, Part, Plate, Start, Stop};
use carom_motion::planar::ChainPoint;
use carom_num::Vec2;

/// Sizes of the part [m].
const LENGTH: f64 = 0.1;
/// How long a run may take longer over hardly bent joints than over none [s]: each costs a little speed.
const HARDLY_LONGER: f64 = 1e-4;

fn plate(name: &str, course: &[Vec2], edge_radius: f64) -> Plate {
    let straight = course.len() == 2;
    let form = course.iter().map(|at| ChainPoint::straight(*at)).collect();
    Plate {
        name: name.to_owned(),
        uphill: course[0],
        edge: course[course.len() - 1],
        friction: 0.12,
        restitution: 0.3,
        unbounded: false,
        form: Form { course: if straight { vec![] } else { form }, edge_radius },
    }
}

/// A feeder of an upper plate of this course and a straight lower one.
fn feeder(part: Part, course: &[Vec2], edge_radius: f64, to_edge: f64) -> Feeder {
    let lower = plate("lower", &[Vec2::new(0.25, -0.05), Vec2::new(-0.3, -0.16)], 0.0);
    Feeder {
        gravity: 9.81,
        stop: Stop::Landed,
        law: Default::default(),
        part,
        start: Start { to_edge, speed: 0.0, face: 0 },
        plates: vec![plate("upper", course, edge_radius), lower],
        walls: vec![],
    }
}

fn rod() -> Part {
    Part::rod(LENGTH, 0.3, 0.3 * LENGTH * LENGTH / 12.0).unwrap()
}

/// A course down to the origin with a joint at each share of it, beside its line by this much, in turn above and below [m].
fn course(joints: &[f64], beside: f64) -> Vec<Vec2> {
    let (uphill, up) = (Vec2::new(-0.26, 0.15), Vec2::new(0.5, 0.86));
    let joint =
        |(i, share): (usize, &f64)| uphill * (1.0 - share) + up * (if i % 2 == 0 { -beside } else { beside });
    let joints = joints.iter().enumerate().map(joint);
    [uphill].into_iter().chain(joints).chain([Vec2::ZERO]).collect()
}

#[test]
fn a_rod_passes_joints_that_are_hardly_bent_as_if_there_were_none() {
    let straight = feeder(rod(), &course(&[], 0.0), 0.0, 0.22).run_untraced().unwrap();
    assert_eq!(straight.outcome, Outcome::Landed);
    for exponent in 2..14 {
        for joints in [&[0.5][..], &[0.47, 0.6], &[0.5, 0.65, 0.8]] {
            let beside = 10f64.powi(-exponent) * 1e-3;
            let bent = feeder(rod(), &course(joints, beside), 0.0, 0.22).run_untraced().unwrap();
            assert_eq!(bent.outcome, Outcome::Landed, "{joints:?} beside the line by {beside:e} m");
            let longer = bent.end_time - straight.end_time;
            assert!(longer.abs() < HARDLY_LONGER + 30.0 * beside, "{joints:?}, {beside:e} m: {longer:e} s");
        }
    }
}

#[test]
fn a_flush_part_may_overhang_the_uphill_end_of_a_thick_plate() {
    let convex = [Vec2::new(-0.4, 0.1), Vec2::new(-0.2, 0.06), Vec2::new(0.0, -0.06)];
    for millimetres in 1..40 {
        let part = Part::rectangle(LENGTH, 0.02, 0.3, 0.3 * (LENGTH * LENGTH + 0.02 * 0.02) / 12.0).unwrap();
        let length = (convex[1] - convex[0]).norm() + (convex[2] - convex[1]).norm();
        let start = length - f64::from(millimetres) * 1e-3;
        let ready = feeder(part, &convex, 1e-3, start);
        let refused = ready.prepare(Default::default()).err();
        assert!(refused.is_none(), "{millimetres} mm below the end: {refused:?}");
    }
}

#[test]
fn a_rod_on_a_bent_plate_without_thickness_moves_as_on_a_thin_sheet() {
    for (i, beside) in [0.03, -0.03, 0.01, -0.01, 0.003, -0.003].into_iter().enumerate() {
        let bent = course(&[0.5], beside);
        let [thin, sheet] = [0.0, 1e-6].map(|edge_radius| {
            let run = feeder(rod(), &bent, edge_radius, 0.21).run_untraced().unwrap();
            (run.outcome, run.end_time)
        });
        assert_eq!(thin.0, sheet.0, "{i}");
        assert!((thin.1 - sheet.1).abs() < HARDLY_LONGER, "{beside} m beside: {thin:?}, {sheet:?}");
    }
}

/// Where the front runs off over the last end, the rod lies on the end and on a joint before it, and is parted from each by hundreds of nanometres at most.
#[test]
fn a_rod_whose_front_runs_off_an_almost_straight_sheet_goes_on() {
    let at = |x, y| Vec2::new(x, y);
    let sheet = [
        at(-0.284_831_806_580_228_9, 0.094_185_147_237_996_51),
        at(-0.220_023_604_966_685_52, 0.072_755_794_232_306_53),
        at(-0.059_039_629_073_508_65, 0.019_523_328_186_818_85),
        at(-0.046_609_051_899_600_28, 0.015_411_452_069_716_882),
        Vec2::ZERO,
    ];
    for half_millimetres in 320..340 {
        let to_edge = f64::from(half_millimetres) * 5e-4;
        let run = feeder(rod(), &sheet, 5e-7, to_edge).run_untraced().unwrap();
        assert_eq!(run.outcome, Outcome::Landed, "from {to_edge} m");
    }
}
