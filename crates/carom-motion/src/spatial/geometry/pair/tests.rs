//! Rates against differences.

use super::*;
use carom_num::Rotation;

const STEP: f64 = 1e-6;

/// Moves with a constant acceleration and a constant angular acceleration in body axes.
fn moved(from: &Moving, time: f64) -> State {
    let State { centre, attitude, velocity, spin } = from.state;
    State {
        centre: centre + velocity * time + from.acceleration * (0.5 * time * time),
        // To second order: what the spin turns meanwhile adds to the turn.
        attitude: attitude.after(Rotation::by(spin * time + from.turning * (0.5 * time * time))),
        velocity: velocity + from.acceleration * time,
        spin: spin + from.turning * time,
    }
}

/// The change of a quantity per second.
fn rate<T>(from: &Moving, of: impl Fn(&State) -> T) -> T
where
    T: std::ops::Sub<Output = T> + std::ops::Div<f64, Output = T>,
{
    (of(&moved(from, STEP)) - of(&moved(from, -STEP))) / (2.0 * STEP)
}

/// An edge of a wedge across an edge of another one, and a face of it above a corner.
fn pairs() -> Vec<Pair> {
    let edge = |from: Vec3, along: Vec3, outward: Vec3| {
        let along = along.unit().unwrap();
        Edge {
            from,
            along,
            length: 0.7,
            sides: [along.cross(outward), outward.cross(along)],
            outward,
            corners: [true; 2],
        }
    };
    let own = edge(Vec3::new(-0.3, 0.05, -0.1), Vec3::new(1.0, 0.1, -0.2), -Vec3::Z);
    let other = edge(Vec3::new(0.1, -0.4, 0.0), Vec3::new(0.2, 1.0, 0.1), Vec3::Z);
    let corners = [(-0.3, -0.2), (0.3, -0.2), (0.3, 0.2), (-0.3, 0.2)];
    let corners: Vec<Vec3> = corners.iter().rev().map(|(x, y)| Vec3::new(*x, *y, -0.1)).collect();
    let face = Facet::of(-Vec3::Z, &corners);
    let corner = Vec3::new(0.05, -0.03, -0.02);
    let round = |own: Span, other: Span| {
        let (inner, outer) = (vec![Vec3::X, Vec3::new(0.0, 0.6, 0.8)], vec![-Vec3::Y]);
        Pair::Round(Nearest { own, other, radius: 0.05, own_radius: 0.03, inner, outer })
    };
    let point = Vec3::new(-0.1, 0.05, -0.1);
    vec![
        Pair::Cross(Crossing { own, other, radius: 0.0, own_radius: 0.0 }),
        Pair::Cross(Crossing { own, other, radius: 0.04, own_radius: 0.04 }),
        Pair::Cross(Crossing { own, other, radius: 0.05, own_radius: 0.02 }),
        Pair::Corner { face: face.clone(), radius: 0.0, corner, spokes: vec![] },
        Pair::Corner { face: face.raised(0.04), radius: 0.03, corner, spokes: vec![] },
        round(Span::point(point), Span::edge(&other)),
        round(Span::edge(&own), Span::point(corner)),
        round(Span::point(point), Span::point(corner)),
    ]
}

fn moving() -> Moving {
    let state = State {
        centre: Vec3::new(0.03, 0.02, 0.12),
        attitude: Rotation::by(Vec3::new(0.2, -0.3, 0.4)),
        velocity: Vec3::new(0.5, -0.3, -0.8),
        spin: Vec3::new(1.0, -2.0, 0.7),
    };
    Moving { state, acceleration: Vec3::new(0.3, 1.0, -2.0), turning: Vec3::new(-3.0, 1.0, 2.0) }
}

#[test]
fn rates_are_those_of_differences() {
    let from = moving();
    for pair in pairs() {
        let passing = pair.passing(&from.state);
        let place = rate(&from, |s| pair.meeting(s.pose()).place);
        let normal = rate(&from, |s| pair.meeting(s.pose()).normal);
        // Where the two are apart the place of a corner is the corner's, and of edges the body's.
        assert!((passing.place - place).norm() < 1e-8, "{pair:?}: {:?} {place:?}", passing.place);
        assert!((passing.normal - normal).norm() < 1e-8, "{pair:?}: {:?} {normal:?}", passing.normal);
        let approach = rate(&from, |s| pair.approach(s, 0.0)[0]);
        assert!((pair.approach(&from.state, 0.0)[1] - approach).abs() < 1e-8, "{pair:?}");
        for limit in 0..pair.limits() {
            let margin = rate(&from, |s| pair.margin(limit, s.pose()));
            let own = pair.margin_rate(limit, &from.state);
            assert!((own - margin).abs() < 1e-8, "{pair:?} {limit}: {own} {margin}");
            let beyond = rate(&from, |s| pair.beyond(limit, s, 0.02)[0]);
            let [value, own] = pair.beyond(limit, &from.state, 0.02);
            assert!((own - beyond).abs() < 1e-8, "{pair:?} {limit}: {own} {beyond}");
            let scaled = -(pair.margin(limit, from.state.pose()) + 0.02) * pair.scale(from.state.pose());
            assert!((value - scaled).abs() < 1e-14, "{pair:?} {limit}: {value} {scaled}");
        }
    }
}

#[test]
fn the_gap_changes_as_its_derivatives_say() {
    let mut from = moving();
    for pair in pairs() {
        // Brought to where the two touch: the rate of the gap is that of the material there.
        let Meeting { normal, gap, .. } = pair.meeting(from.state.pose());
        from.state.centre -= normal * gap;
        let Height { value, rate: falls, second } = pair.height(&from);
        let gap = rate(&from, |s| pair.meeting(s.pose()).gap);
        let bent = rate(&from, |s| pair.height(&Moving { state: *s, ..from }).rate);
        assert!(value.abs() < 1e-15 && (falls - gap).abs() < 1e-8, "{pair:?}: {value:e} {falls} {gap}");
        assert!((second - bent).abs() < 1e-7, "{pair:?}: {second} {bent}");
    }
}

#[test]
fn nothing_bends_more_than_its_bound() {
    let from = moving();
    let (time, parts) = (0.05, 50);
    let spin = from.state.spin.norm() + from.turning.norm() * time;
    let most = Most { spin, turning: from.turning.norm(), acceleration: from.acceleration.norm() };
    for pair in pairs() {
        let [own, ends] = pair.bend(&from.state, &most, time);
        let (mut largest, mut largest_end) = (0.0_f64, 0.0_f64);
        for k in 0..parts {
            let state = moved(&from, time * f64::from(k) / f64::from(parts));
            let then = Moving { state, ..from };
            largest = largest.max(rate(&then, |s| pair.approach(s, 0.0)[1]).abs());
            for limit in 0..pair.limits() {
                largest_end = largest_end.max(rate(&then, |s| pair.beyond(limit, s, 0.0)[1]).abs());
            }
        }
        assert!(largest < own && largest > 0.02 * own, "{pair:?}: {largest} {own}");
        assert!(largest_end < ends && largest_end > 0.01 * ends, "{pair:?}: {largest_end} {ends}");
    }
}

/// A knife's edge of a body that turns about above the edge of a thin plate: the perpendicular changes its side many times.
#[test]
fn what_is_turned_away_stays_so_for_as_long_as_is_said() {
    let along = Vec3::X;
    let own = Edge {
        from: Vec3::ZERO,
        along,
        length: 1.0,
        sides: [Vec3::new(0.0, 0.3, 1.0).unit().unwrap(), Vec3::new(0.0, -0.2, 1.0).unit().unwrap()],
        outward: -Vec3::Z,
        corners: [true; 2],
    };
    let other = Edge::of_plate(Vec3::ZERO, Vec3::Y, Vec3::Z).unwrap();
    let pair = Pair::Cross(Crossing { own, other, radius: 0.0, own_radius: 0.0 });
    let spin = Vec3::new(2.0, -1.0, 0.6);
    let pose = |time: f64| Pose { centre: Vec3::ZERO, attitude: Rotation::by(spin * time) };
    let (step, count) = (1e-3, 6000_u32);
    let mut touches = 0;
    for k in 0..count {
        let time = step * f64::from(k);
        let [away, least] = pair.turned_away(pose(time));
        assert!(least <= away, "{time}: {least} {away}");
        touches += u32::from(away <= 0.0);
        let mut ahead = time + 0.5 * step;
        while ahead < time + least / (2.0 * spin.norm()) {
            assert!(pair.turned_away(pose(ahead))[0] > 0.0, "{time}: {least} is too long at {ahead}");
            ahead += step;
        }
    }
    assert!(touches > 100 && touches < count - 100, "{touches}");
}
