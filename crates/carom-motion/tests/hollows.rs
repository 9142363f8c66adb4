//! A rod across the gap between two edges, of two obstacles and of one, against closed forms.

use crate::on_edge;
use crate::walk;

use carom_impact::Law;
use carom_motion::planar::trace::{ContactSample, Piece, PieceEnd, Sample, Trace};
use carom_motion::planar::{Body, ChainPoint, Happening, Obstacle, Pose, Shape, State, Twist, World};
use carom_num::Vec2;
use carom_theory::bridged_hollow::RodOnEdges;
use carom_theory::incline::Incline;
use carom_theory::rod_on_edge::{EdgeState, PartOnEdge};
use on_edge::{follow, pose};
use walk::followed;

const GRAVITY: f64 = 9.81;
const MASS: f64 = 0.3;
const HALF_LENGTH: f64 = 0.1;
const HALF_GAP: f64 = 0.03;
/// What is asked of the engine beside a closed form [m, rad, m/s, s, N].
const AS_THEORY: f64 = 1e-10;
/// How near to a border of its domain a rod is let go [m].
const BESIDE: f64 = 1e-8;

fn rod(half_length: f64, half_gap: f64, offset: f64) -> RodOnEdges {
    RodOnEdges { mass: MASS, half_length, half_gap, offset, gravity: GRAVITY }
}

/// Two segments by their ends.
fn segments(ends: [[(f64, f64); 2]; 2], friction: f64) -> Vec<Obstacle> {
    let at = |(x, y): (f64, f64)| Vec2::new(x, y);
    ends.map(|[from, to]| Obstacle::new(at(from), at(to), friction, 0.0)).to_vec()
}

/// A solid by the corners of its outline.
fn solid(corners: &[(f64, f64)], friction: f64) -> Vec<Obstacle> {
    let outline: Vec<_> = corners.iter().map(|(x, y)| ChainPoint::straight(Vec2::new(*x, *y))).collect();
    vec![Obstacle::of_shape(Shape::of_chain(&outline).unwrap(), friction, 0.0)]
}

/// Edges on which a rod lies with its side alone: two posts, and a trough whose sharp rims fall off outwards.
fn bare_edges(d: f64, friction: f64) -> [Vec<Obstacle>; 2] {
    let (down, deep, far) = (-0.5, -0.2, 2.0 * d);
    [
        segments([[(-d, down), (-d, 0.0)], [(d, 0.0), (d, down)]], friction),
        solid(&[(-far, down), (far, down), (d, 0.0), (d, deep), (-d, deep), (-d, 0.0)], friction),
    ]
}

/// Edges behind which level ground begins: two plates, and a block with a notch.
fn edges_of_ground(d: f64, friction: f64) -> [Vec<Obstacle>; 2] {
    let (far, deep, low) = (1.0, -0.2, -0.3);
    let block =
        [(-far, low), (far, low), (far, 0.0), (d, 0.0), (d, deep), (-d, deep), (-d, 0.0), (-far, 0.0)];
    [segments([[(-far, 0.0), (-d, 0.0)], [(d, 0.0), (far, 0.0)]], friction), solid(&block, friction)]
}

fn world(half_length: f64, obstacles: Vec<Obstacle>) -> World {
    let ends = vec![Vec2::new(-half_length, 0.0), Vec2::new(half_length, 0.0)];
    let inertia = MASS * half_length * half_length / 3.0;
    let body = Body { shape: Shape::new(ends, 0.0).unwrap(), mass: MASS, inertia };
    World::of_one(Vec2::new(0.0, -GRAVITY), body, obstacles, Law::Poisson)
}

fn level(offset: f64, speed: f64) -> State {
    let velocity = Vec2::new(speed, 0.0);
    State { pose: Pose { centre: Vec2::new(offset, 0.0), angle: 0.0 }, twist: Twist { velocity, spin: 0.0 } }
}

fn walk(world: &World, start: State, until: f64) -> (State, Trace, Happening) {
    // The rod is above what runs to the right, and above what runs to the left.
    let above = world.obstacles.iter().map(|o| o.direction().x >= 0.0).collect();
    followed(world, start, above, until)
}

/// Sum of the forces of a sample's contacts, and their moment about the rod's centre [N, N m].
fn resultant(sample: &Sample) -> [f64; 2] {
    let centre = sample.state.pose.centre;
    let moment = |c: &ContactSample| {
        let force = c.normal * c.normal_force + c.normal.turned_right() * c.tangential_force;
        (c.point - centre).cross(force)
    };
    [sample.contacts.iter().map(|c| c.normal_force).sum(), sample.contacts.iter().map(moment).sum()]
}

/// The rod tips about the edge at `d` from the middle as the equations of motion say, from the start of a piece to each of its samples.
fn tips_as_theory(piece: &Piece, (part, start): (&PartOnEdge, EdgeState), d: f64) {
    let left = piece.start.pose.centre.x < 0.0;
    let edge = Vec2::new(if left { -d } else { d }, 0.0);
    assert!(piece.samples.len() > 4, "{} samples", piece.samples.len());
    for sample in &piece.samples {
        let state = follow(part, start, sample.time - piece.start_time);
        let (place, ours) = (pose(part, &state, left), sample.state.pose);
        assert!((edge + place.centre - ours.centre).norm() < AS_THEORY, "{ours:?} not {place:?}");
        assert!((place.angle - ours.angle).abs() < AS_THEORY, "{ours:?} not {place:?}");
        let (force, expected) = (sample.contacts[0].normal_force, part.motion(&state).normal_force);
        assert!((force - expected).abs() < AS_THEORY, "{force} not {expected}");
        assert_eq!(sample.contacts.len(), 1, "on one edge");
    }
}

#[test]
fn a_rod_rests_across_a_gap_up_to_the_ends_of_its_domain() {
    // Up to where its centre is over an edge, and up to where its end lies on one.
    for (half_length, limit) in [(HALF_LENGTH, HALF_GAP), (0.05, 0.02)] {
        for offset in [limit - BESIDE, limit + BESIDE, BESIDE - limit, -BESIDE - limit] {
            let theory = rod(half_length, HALF_GAP, offset);
            for edges in bare_edges(HALF_GAP, 0.3) {
                let (_, trace, end) = walk(&world(half_length, edges), level(offset, 0.0), 0.01);
                assert_eq!(end == Happening::Rests, theory.rests(), "{half_length} {offset}: {end:?}");
                assert!(trace.impacts.is_empty(), "nothing strikes");
            }
        }
    }
}

#[test]
fn a_rod_that_slides_across_a_gap_presses_each_edge_as_theory_says() {
    let (friction, speed) = (0.3, 0.3);
    let way = speed * speed / (2.0 * friction * GRAVITY);
    for (offset, sign) in [(-0.02, 1.0), (0.0, 1.0), (0.02, -1.0)] {
        for edges in bare_edges(HALF_GAP, friction) {
            let (end, trace, happening) = walk(&world(HALF_LENGTH, edges), level(offset, sign * speed), 1.0);
            assert_eq!(happening, Happening::Rests, "between the edges");
            assert!((end.pose.centre - Vec2::new(offset + sign * way, 0.0)).norm() < AS_THEORY, "{end:?}");
            assert!((trace.pieces[0].end_time - speed / (friction * GRAVITY)).abs() < AS_THEORY, "it stops");
            for sample in &trace.pieces[0].samples {
                let expected = rod(HALF_LENGTH, HALF_GAP, sample.state.pose.centre.x).forces();
                for contact in &sample.contacts {
                    let theory = expected[usize::from(contact.point.x > 0.0)];
                    let drag = -sign * friction * contact.normal_force;
                    assert!((contact.normal_force - theory).abs() < AS_THEORY, "{contact:?} not {theory}");
                    assert!((contact.tangential_force - drag).abs() < AS_THEORY, "{contact:?} not {drag}");
                }
                assert_eq!(sample.contacts.len(), 2, "it lies on both edges");
            }
        }
    }
}

#[test]
fn a_rod_whose_centre_passes_an_edge_tips_over_it() {
    let friction = 0.3;
    let brakes = Incline { slope: 0.0, friction, gravity: GRAVITY };
    for (from, speed) in [(0.0, 0.6), (0.02, 0.6), (-0.01, -0.7)] {
        let passes = brakes.slide(f64::abs(speed), HALF_GAP - f64::abs(from)).unwrap().unwrap();
        for edges in bare_edges(HALF_GAP, friction) {
            let (_, trace, _) = walk(&world(HALF_LENGTH, edges), level(from, speed), 0.2);
            let [slides, tips] = &trace.pieces[..2] else { panic!("{:?}", trace.pieces) };
            assert!(matches!(slides.ended_by, PieceEnd::ForceZero(_)), "{:?}", slides.ended_by);
            assert!((slides.end_time - passes.time).abs() < AS_THEORY, "{} not {passes:?}", slides.end_time);
            assert!(trace.impacts.is_empty(), "nothing strikes");
            let beyond = rod(HALF_LENGTH, HALF_GAP, HALF_GAP.next_up());
            let (part, start) = beyond.tipping(friction).unwrap();
            tips_as_theory(tips, (&part, EdgeState { slip: passes.speed, ..start }), HALF_GAP);
        }
    }
}

#[test]
fn a_rod_that_is_let_go_where_it_does_not_rest_tips_out_of_the_gap_or_into_it() {
    // Its centre beyond an edge; and its end short of the other edge.
    for (half_length, offset) in [(HALF_LENGTH, 0.05), (HALF_LENGTH, -0.04), (0.05, 0.025), (0.05, -0.025)] {
        let (part, start) = rod(half_length, HALF_GAP, offset).tipping(0.0).unwrap();
        assert_eq!(start.reach > 0.0, offset.abs() > HALF_GAP, "out of the gap");
        for edges in bare_edges(HALF_GAP, 0.0) {
            let (_, trace, _) = walk(&world(half_length, edges), level(offset, 0.0), 0.05);
            assert!(trace.impacts.is_empty(), "nothing strikes yet");
            let tips = trace.pieces.last().unwrap();
            assert!(tips.start_time == 0.0, "from the start, whichever way it begins to slip");
            assert!(trace.pieces.len() <= 2, "of two ways to slip one is right: {}", trace.pieces.len());
            tips_as_theory(tips, (&part, start), HALF_GAP);
        }
    }
}

#[test]
fn a_rod_that_is_pushed_over_a_gap_bridges_it_if_it_is_as_long_as_two() {
    let (friction, from, speed) = (0.3, -0.2, 1.2);
    let brakes = Incline { slope: 0.0, friction, gravity: GRAVITY };
    for half_length in [0.055, 0.065] {
        let theory = rod(half_length, HALF_GAP, from);
        for ground in edges_of_ground(HALF_GAP, friction) {
            let world = world(half_length, ground);
            if theory.bridges() {
                let way = speed * speed / (2.0 * friction * GRAVITY);
                let (end, trace, happening) = walk(&world, level(from, speed), 1.0);
                assert_eq!((happening, trace.impacts.len()), (Happening::Rests, 0), "on the other side");
                assert!((end.pose.centre - Vec2::new(from + way, 0.0)).norm() < AS_THEORY, "{end:?}");
                // On level ground up to four contacts share the weight: how, statics alone does not say.
                for sample in trace.pieces.iter().flat_map(|p| &p.samples) {
                    let [force, moment] = resultant(sample);
                    assert!((force - MASS * GRAVITY).abs() < AS_THEORY, "{force} carries it");
                    // That its front has come to lie on the other side it notes as it begins to tip, and stops.
                    assert!(moment.abs() < AS_THEORY || sample.contacts.len() == 1, "{moment} turns it");
                }
                continue;
            }
            let passes = brakes.slide(speed, -HALF_GAP - from).unwrap().unwrap();
            let (_, trace, _) = walk(&world, level(from, speed), passes.time + 0.02);
            let tips = trace.pieces.iter().find(|p| p.start_time >= passes.time - AS_THEORY).unwrap();
            assert!((tips.start_time - passes.time).abs() < AS_THEORY, "{} not {passes:?}", tips.start_time);
            let (part, start) = rod(half_length, HALF_GAP, -HALF_GAP).tipping(friction).unwrap();
            tips_as_theory(tips, (&part, EdgeState { slip: -passes.speed, ..start }), HALF_GAP);
        }
    }
}
