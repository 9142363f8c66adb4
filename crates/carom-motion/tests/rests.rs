//! What random parts of arcs and segments can lie on, against the outline itself.

use carom_motion::planar::{Body, ChainPoint, MassProperties, Obstacle, Pose, RestKind, Shape, State, World};
use carom_num::Vec2;
use carom_num::elementary::sin_cos;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::{PI, TAU};

/// Parts of the test.
const PARTS: u64 = 600;
/// Of the part's size: rounding.
const ROUNDING: f64 = 1e-9;
/// Directions in which it is asked how high the mass centre is.
const DIRECTIONS: u32 = 3600;
/// Directions on both sides of a lowest height that are looked at.
const WINDOW: u32 = 20;
/// How much chords may add to a height, of the size.
const CHORDS: f64 = 1e-4;
/// Points of an edge.
const PLACES: u32 = 200;

/// A star of random rays whose edges are bent either way, or a bar with a round nose and a notch; about its mass centre.
fn chain(of: &mut impl FnMut(f64, f64) -> f64) -> Option<Vec<ChainPoint>> {
    let mut points = vec![];
    if of(0.0, 1.0) < 0.5 {
        let rays = of(3.0, 9.0).floor();
        let mut ray = 0.0;
        while ray < rays {
            let (sin, cos) = sin_cos(TAU * (ray + of(-0.3, 0.3)) / rays);
            let sweep = if of(0.0, 1.0) < 0.5 { 0.0 } else { of(-0.6, 0.9) };
            points.push(ChainPoint { at: Vec2::new(cos, sin) * of(0.04, 0.1), sweep });
            ray += 1.0;
        }
    } else {
        let (length, half, (sin, cos)) = (of(0.03, 0.1), of(0.005, 0.03), sin_cos(of(-PI, PI)));
        let mut add = |x: f64, y: f64, sweep: f64| {
            points.push(ChainPoint { at: Vec2::new(x, y).rotated(cos, sin), sweep });
        };
        add(0.0, -half, 0.0);
        // A nose of half a turn, or of a little less or more.
        add(length, -half, PI * [1.0, of(0.8, 1.0), of(1.0, 1.2)][of(0.0, 3.0) as usize]);
        add(length, half, 0.0);
        let notch = [of(0.3, 0.4), of(0.45, 0.55), of(0.6, 0.7)].map(|share| share * length);
        add(notch[2], half, 0.0);
        add(notch[1], -of(0.0, 0.9) * half, 0.0);
        add(notch[0], half, 0.0);
        add(0.0, half, [0.0, PI, of(0.1, 3.0)][of(0.0, 3.0) as usize]);
    }
    let about = MassProperties::of(&Shape::of_chain(&points).ok()?).centroid;
    points.iter_mut().for_each(|p| p.at -= about);
    Some(points)
}

/// Points along a closed chain.
fn outline(chain: &[ChainPoint]) -> Vec<Vec2> {
    let each = chain.iter().zip(chain.iter().cycle().skip(1));
    let along = |(from, to): (&ChainPoint, &ChainPoint)| {
        let (arc, from, to, sweep) = (from.arc_to(to.at), from.at, to.at, from.sweep);
        (0..PLACES).map(move |i| {
            let share = f64::from(i) / f64::from(PLACES);
            let Some((centre, _)) = arc else { return from + (to - from) * share };
            let (sin, cos) = sin_cos(sweep * share);
            centre + (from - centre).rotated(cos, sin)
        })
    };
    each.flat_map(along).collect()
}

/// The lowest heights of the mass centre on level ground, as directions out of the part that point down, by looking all round.
fn lowest(points: &[Vec2]) -> Vec<Vec2> {
    let direction = |i: u32| {
        let (sin, cos) = sin_cos(TAU * f64::from(i) / f64::from(DIRECTIONS));
        Vec2::new(cos, sin)
    };
    let height = |n: Vec2| points.iter().map(|p| n.dot(*p)).fold(f64::NEG_INFINITY, f64::max);
    let heights: Vec<f64> = (0..DIRECTIONS).map(|i| height(direction(i))).collect();
    let at = |i: u32| heights[(i % DIRECTIONS) as usize];
    // Chords of an arc have heights of their own, by this much of the size.
    let size = points.iter().map(|p| p.norm()).fold(0.0, f64::max);
    let beside = |i: &u32| at(i + DIRECTIONS - WINDOW).min(at(i + WINDOW)) - CHORDS * size;
    let is_lowest =
        |i: &u32| at(*i) < beside(i) && (1..WINDOW).all(|j| at(*i) <= at(i + j).min(at(i + DIRECTIONS - j)));
    (0..DIRECTIONS).filter(is_lowest).map(direction).collect()
}

#[test]
fn a_part_lies_on_lines_and_arcs_beyond_which_nothing_of_it_is() {
    let (mut judged, mut arcs, mut bridges) = (0, 0, 0);
    for seed in 0..PARTS {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let mut of = |low: f64, high: f64| random.random_range(low..high);
        let Some(chain) = chain(&mut of) else { continue };
        let (shape, points) = (Shape::of_chain(&chain).unwrap(), outline(&chain));
        let near = ROUNDING * shape.size();
        let hull = shape.hull();
        for face in 0..hull.faces() {
            let (n, on) = (hull.face_normal(face), hull.face(face).0);
            let beyond = points.iter().map(|p| n.dot(*p - on)).fold(f64::NEG_INFINITY, f64::max);
            assert!(beyond <= hull.radius() + near, "{seed}: the hull leaves out {beyond:e}");
        }
        let rests = shape.rests();
        for rest in rests {
            let beyond = points.iter().map(|p| rest.normal.dot(*p)).fold(f64::NEG_INFINITY, f64::max);
            assert!((beyond - rest.depth).abs() <= CHORDS * shape.size(), "{seed}: {beyond} not {rest:?}");
            assert!(beyond <= rest.depth + near, "{seed}: {rest:?} cuts through the part");
            arcs += u32::from(rest.kind == RestKind::Arc);
            bridges += u32::from(rest.kind == RestKind::Across);
        }
        let shares: f64 = rests.iter().map(|rest| rest.share()).sum();
        assert!((shares - 1.0).abs() <= ROUNDING, "{seed}: {shares}, {rests:?}");
        // Every lowest height that is seen all round is one of the rests on which it stays.
        let stays = |n: Vec2| rests.iter().any(|rest| rest.share() > 0.0 && rest.normal.dot(n) > 0.9999);
        for n in lowest(&points) {
            assert!(stays(n), "{seed}: {n:?} is none of {rests:?}");
        }
        judged += 1;
    }
    assert!(
        judged > PARTS / 2 && arcs > 10 && bridges > 100,
        "{judged} parts, {arcs} arcs, {bridges} bridges"
    );
}

/// The distance of two parts, one of them as an obstacle, is the least distance of any two points of their outlines.
#[test]
fn the_distance_of_two_outlines_is_that_of_their_nearest_points() {
    let mut rng = Pcg64Mcg::seed_from_u64(11);
    let mut of = |low: f64, high: f64| rng.random_range(low..high);
    let (mut judged, mut curved) = (0, 0);
    for number in 0..PARTS {
        let Some((body, obstacle)) = chain(&mut of).zip(chain(&mut of)) else { continue };
        let (angle, centre) = (of(-PI, PI), Vec2::at_angle(of(-PI, PI)) * of(0.12, 0.3));
        let turn = Vec2::at_angle(angle);
        let shape = Shape::of_chain(&body).unwrap();
        let fixed = Obstacle::of_shape(Shape::of_chain(&obstacle).unwrap(), 0.1, 0.0);
        let world = World::of_one(
            Vec2::ZERO,
            Body { shape, mass: 1.0, inertia: 1e-3 },
            vec![fixed],
            Default::default(),
        );
        let state = State { pose: Pose { centre, angle }, ..State::default() };
        if world.overlap(0, &state, 0) > -1e-3 {
            continue;
        }
        let placed: Vec<Vec2> = outline(&body).iter().map(|p| centre + p.rotated(turn.x, turn.y)).collect();
        let points = outline(&obstacle);
        let nearest = |p: &Vec2| points.iter().map(|q| (*q - *p).norm()).fold(f64::INFINITY, f64::min);
        let seen = placed.iter().map(nearest).fold(f64::INFINITY, f64::min);
        let found = world.distance(0, &state, 0);
        // Points of an outline are at most 0.2 mm apart, so the nearest two of them are little farther apart than the outlines.
        assert!(found <= seen + ROUNDING && found > seen - 2e-4, "{number}: {found} m, seen {seen} m");
        judged += 1;
        curved += u32::from(body.iter().chain(&obstacle).any(|p| p.sweep != 0.0));
    }
    assert!(judged > 200 && curved > 100, "{judged} pairs, {curved} of them with arcs");
}

/// What a part can lie on is kept once it is found; about another mass centre it is another.
#[test]
fn a_shape_that_is_shifted_lies_as_one_that_was_never_asked() {
    let corners = [(-0.03, -0.01), (0.03, -0.01), (0.03, 0.01), (-0.03, 0.01)].map(|(x, y)| Vec2::new(x, y));
    let (asked, by) = (Shape::new(corners.to_vec(), 0.002).unwrap(), Vec2::new(0.01, -0.004));
    let before = asked.rests().to_vec();
    let shifted = asked.shifted(by);
    assert_eq!(shifted.rests(), Shape::new(corners.to_vec(), 0.002).unwrap().shifted(by).rests());
    assert_ne!(shifted.rests(), before, "its mass centre is elsewhere");
    assert_eq!(asked.clone().rests(), before, "a copy lies as it does");
}
