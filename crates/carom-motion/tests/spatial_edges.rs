//! Bodies on the edges and corners of plates and solids, against closed forms.

use crate::bodies::ran;
use carom_motion::MotionError;
use carom_motion::spatial::{
    Body, Budget, End, Friction, Mode, Obstacle, Options, Plane, Polyhedron, Run, Samples, State, World, run,
};
use carom_num::elementary::{cos, sin};
use carom_num::quadrature::GAUSS_LEGENDRE_8;
use carom_num::{Mat3, Rotation, Vec3};
use carom_theory::spatial::{EdgeOverEdge, SlidingOver};

const G: f64 = 9.81;
/// Half the length of the prism's lower edge.
const HALF: f64 = 0.4;

/// A prism with its mass centre in the middle of its lower edge, which lies along x.
fn prism(inertia: Mat3) -> Body {
    let ends = [-HALF, HALF];
    let section = [(0.0, 0.0), (-0.05, 0.1), (0.05, 0.1)];
    let points = ends.iter().flat_map(|x| section.map(|(y, z)| Vec3::new(*x, y, z))).collect();
    Body::new(2.0, inertia, points).unwrap()
}

/// An upright thin plate whose upper edge is the y axis.
fn rail() -> Obstacle {
    let corner = |y: f64, z: f64| Vec3::new(0.0, y, z);
    Obstacle::plate(&[corner(-9.0, 0.0), corner(9.0, 0.0), corner(9.0, -1.0), corner(-9.0, -1.0)]).unwrap()
}

/// A body among obstacles.
fn around(body: Body, gravity: Vec3, friction: f64, obstacles: Vec<Obstacle>) -> World {
    World::new(body, gravity)
        .unwrap()
        .with_friction(Friction::new(friction))
        .unwrap()
        .among(obstacles)
        .unwrap()
}

/// An integral over many short parts.
fn integral([from, to]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    let parts = 64;
    let width = (to - from) / f64::from(parts);
    let part = |k: i32| {
        let middle = from + width * (f64::from(k) + 0.5);
        let both = |x: f64| of(middle + 0.5 * width * x) + of(middle - 0.5 * width * x);
        GAUSS_LEGENDRE_8.iter().map(|(x, weight)| weight * both(*x)).sum::<f64>() * 0.5 * width
    };
    (0..parts).map(part).sum()
}

/// A prism on the rail with its mass centre so far beyond it, at an angle from level.
fn over_the_rail(distance: f64, angle: f64, speed: f64, turns: f64) -> State {
    let (along, across) = (Vec3::new(cos(angle), 0.0, sin(angle)), Vec3::new(-sin(angle), 0.0, cos(angle)));
    State {
        centre: along * distance,
        attitude: Rotation::by(Vec3::Y * -angle),
        velocity: along * speed + across * (distance * turns),
        spin: Vec3::Y * -turns,
    }
}

fn theory(distance: f64, speed: f64, turns: f64) -> SlidingOver {
    EdgeOverEdge { mass: 2.0, inertia: 0.12 }.kept(distance, speed, turns).unwrap()
}

#[test]
fn an_edge_slides_over_an_edge_and_off_its_end() {
    for (distance, angle, speed, turns) in
        [(0.05, 0.0, 1.0, 2.0), (-0.2, -0.3, 0.7, 1.0), (0.0, 0.2, 2.0, 0.1), (0.1, -0.5, 0.4, 4.0)]
    {
        let world = around(prism(Mat3::diagonal(0.03, 0.12, 0.1)), Vec3::Y * -G, 0.0, vec![rail()]);
        let kept = theory(distance, speed, turns);
        assert!(kept.force(distance).unwrap() > 0.0, "{distance}: the rail would pull");
        let start = over_the_rail(distance, angle, speed, turns);
        // To a place on the way, and to the end of the edge.
        let there = distance + 0.6 * (HALF - distance);
        let time = integral([distance, there], |s| 1.0 / kept.speed(s).unwrap());
        let (end, _) = ran(&world, &start, time);
        assert_eq!(end.end, End::BudgetSpent(Budget::Time), "{distance}");
        let turned = angle + integral([distance, there], |s| kept.turns(s).unwrap() / kept.speed(s).unwrap());
        let (along, across) =
            (Vec3::new(cos(turned), 0.0, sin(turned)), Vec3::new(-sin(turned), 0.0, cos(turned)));
        let (moves, turns) = (kept.speed(there).unwrap(), kept.turns(there).unwrap());
        let falls = Vec3::Y * (-0.5 * G * time * time);
        let place = (end.state.centre - along * there - falls).norm();
        let velocity = along * moves + across * (there * turns) - Vec3::Y * (G * time);
        let off = (end.state.velocity - velocity).norm().max((end.state.spin + Vec3::Y * turns).norm());
        assert!(place < 1e-10 && off < 1e-10, "{distance}: {place:e} {off:e}");
        let leaves = integral([distance, HALF], |s| 1.0 / kept.speed(s).unwrap());
        let (_, samples) = ran(&world, &start, leaves + 0.01);
        let last = samples.pieces.last().unwrap();
        assert_eq!(last.mode, Mode::Flight, "{distance}: {:?}", samples.pieces);
        assert!((last.start_time - leaves).abs() < 1e-10, "{distance}: {} {leaves}", last.start_time);
    }
}

/// Where the body is after a time on which nothing happens but that it turns about the origin.
fn turned_for(world: &World, start: &State, time: f64) -> (State, Vec<Mode>) {
    let (end, samples) = ran(world, start, time);
    assert_eq!(end.end, End::BudgetSpent(Budget::Time), "{:?}", end.impacts);
    assert!(end.impacts.is_empty(), "{:?}", end.impacts);
    (end.state, samples.pieces.iter().map(|p| p.mode).collect())
}

/// Nothing is told apart of a body that turns about a point of its own on a plane, and of one whose edge sticks across a rail: a spatial pendulum.
#[test]
fn an_edge_that_sticks_on_an_edge_turns_as_about_a_point() {
    let inertia = Mat3::diagonal(0.05, 0.12, 0.1);
    for (shift, spin) in [(0.06, Vec3::new(0.4, -0.3, 0.8)), (-0.1, Vec3::new(-0.2, 0.5, -1.5))] {
        // The mass centre is beside the edge, and the edge across the rail but not at a right angle.
        let points: Vec<Vec3> =
            prism(inertia).supports().iter().map(|r| *r + Vec3::new(shift, 0.01, -0.15)).collect();
        let edge = Vec3::new(0.0, 0.01, -0.15);
        let attitude = Rotation::by(Vec3::new(0.05, -0.1, 0.4));
        let start = State {
            centre: -attitude.apply(edge),
            attitude,
            velocity: attitude.apply(edge.cross(spin)),
            spin,
        };
        let body = Body::new(2.0, inertia, points).unwrap();
        let on_rail = around(body, Vec3::Z * -G, 30.0, vec![rail()]);
        let point = Body::new(2.0, inertia, vec![edge]).unwrap();
        let on_point = around(point, Vec3::Z * -G, 30.0, vec![Plane::FLOOR.into()]);
        let (one, modes) = turned_for(&on_rail, &start, 0.08);
        let (other, _) = turned_for(&on_point, &start, 0.08);
        assert!(matches!(modes[..], [Mode::Slides { .. }]), "{shift}: {modes:?}");
        let apart = (one.centre - other.centre).norm().max((one.spin - other.spin).norm());
        assert!(apart < 1e-10, "{shift}: {apart:e}");
    }
}

/// A pointed block with its tip at a place.
fn spike(tip: Vec3) -> Obstacle {
    let foot = |x: f64, y: f64| tip + Vec3::new(x, y, -0.1);
    let points = [tip, foot(-0.02, -0.02), foot(0.03, -0.02), foot(0.0, 0.03)];
    Obstacle::solid(&Polyhedron::of_points(&points, 1e-12).unwrap())
}

/// A square plate of 2 kg, 1 cm thick, on three tips around its middle.
fn on_three_tips(radius: f64, friction: f64) -> (World, State) {
    let third = std::f64::consts::TAU / 3.0;
    let tip = |k: i32| Vec3::new(cos(third * f64::from(k)), sin(third * f64::from(k)), 0.0) * radius;
    let mut points = vec![];
    for (x, y) in [(-0.3, -0.3), (0.3, -0.3), (0.3, 0.3), (-0.3, 0.3)] {
        points.extend([Vec3::new(x, y, 0.005), Vec3::new(x, y, -0.005)]);
    }
    let body = Body::new(2.0, Mat3::diagonal(0.06, 0.06, 0.12), points).unwrap();
    let world = around(body, Vec3::Z * -G, friction, (0..3).map(|k| spike(tip(k))).collect());
    let centre = Vec3::Z * 0.005;
    let start = State { centre, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    (world, start)
}

#[test]
fn a_plate_that_spins_on_three_tips_comes_to_rest() {
    let (radius, friction, spin) = (0.1, 0.4, 3.0);
    let (world, start) = on_three_tips(radius, friction);
    let start = State { spin: Vec3::Z * spin, ..start };
    // Each tip carries a third of the weight.
    let slower = friction * 2.0 * G * radius / 0.12;
    let stops = spin / slower;
    let (half, _) = ran(&world, &start, 0.5 * stops);
    assert!((half.state.spin.z - 0.5 * spin).abs() < 1e-10, "{}", half.state.spin.z);
    let (end, _) = ran(&world, &start, 2.0 * stops);
    assert!(matches!(end.end, End::AtRest { .. }), "{:?}", end.end);
    assert!((end.time - stops).abs() < 1e-10, "{} {stops}", end.time);
    let turned = 2.0 * carom_num::elementary::atan2(end.state.attitude.v.z, end.state.attitude.w);
    assert!((turned - 0.5 * spin * stops).abs() < 1e-9, "{turned}");
}

#[test]
fn a_plate_slides_level_over_three_tips() {
    let (world, start) = on_three_tips(0.1, 0.2);
    let start = State { velocity: Vec3::new(0.3, 0.1, 0.0), ..start };
    let (end, samples) = ran(&world, &start, 0.1);
    assert!(samples.pieces.iter().all(|p| matches!(p.mode, Mode::Slides { .. })), "{:?}", samples.pieces);
    let fell = (end.state.centre.z - start.centre.z).abs();
    assert!(fell < 1e-13 && end.drift < 1e-12, "{fell:e} {:e}", end.drift);
    // No more than all of the weight slows it.
    let (slowed, most) = (start.velocity.norm() - end.state.velocity.norm(), 0.2 * G * 0.1);
    assert!(slowed > 0.9 * most && slowed < most * (1.0 + 1e-12), "{slowed} {most}");
}

/// Where a box comes to rest that falls on a block, in a world that is turned and moved.
fn fallen(turn: Rotation, shift: Vec3) -> Run {
    let block: Vec<Vec3> =
        corners(Vec3::new(0.1, 0.15, 0.05)).into_iter().map(|r| turn.apply(r) + shift).collect();
    let block = Obstacle::solid(&Polyhedron::of_points(&block, 1e-12).unwrap());
    let up = turn.apply(Vec3::Z);
    let floor = Plane::new(up, up.dot(shift) - 0.05).unwrap();
    let body = Body::new(1.0, Mat3::diagonal(0.002, 0.003, 0.004), corners(Vec3::new(0.06, 0.05, 0.03)));
    let world = around(body.unwrap(), up * -G, 0.3, vec![block, floor.into()]);
    let start = State {
        centre: turn.apply(Vec3::new(0.12, 0.02, 0.3)) + shift,
        attitude: turn.after(Rotation::by(Vec3::new(0.4, 0.9, -0.3))),
        velocity: turn.apply(Vec3::new(-0.1, 0.05, 0.0)),
        spin: Vec3::new(1.0, -2.0, 0.5),
    };
    run(&world, &start, &Options::default(), &mut Samples::default()).unwrap()
}

#[test]
fn a_world_with_a_block_may_be_turned_and_moved() {
    let (turn, shift) = (Rotation::by(Vec3::new(0.7, -1.1, 2.0)), Vec3::new(0.3, -0.2, 0.5));
    let (plain, turned) = (fallen(Rotation::NONE, Vec3::ZERO), fallen(turn, shift));
    assert_eq!(plain.end, turned.end);
    assert_eq!(plain.impacts.len(), turned.impacts.len());
    for (a, b) in plain.impacts.iter().zip(&turned.impacts) {
        assert_eq!((a.touching, a.kept), (b.touching, b.kept));
        assert!((a.time - b.time).abs() < 1e-9, "{} {}", a.time, b.time);
    }
    let apart = (turn.apply(plain.state.centre) + shift - turned.state.centre).norm();
    assert!(apart < 1e-9, "{apart:e}");
}

/// The corners of a box about its middle.
fn corners(half: Vec3) -> Vec<Vec3> {
    let side = |i: u32, bit: u32, x: f64| if i >> bit & 1 == 1 { x } else { -x };
    (0..8).map(|i| Vec3::new(side(i, 0, half.x), side(i, 1, half.y), side(i, 2, half.z))).collect()
}

/// A box of 12 by 8 by 6 cm on a block, its middle this far from the block's, at rest.
fn lies_on(block: Vec3, beside: Vec3) -> Run {
    let half = Vec3::new(0.06, 0.04, 0.03);
    let body = Body::new(1.0, Mat3::diagonal(0.0009, 0.0015, 0.0018), corners(half)).unwrap();
    let block = corners(block).into_iter().map(|r| r - Vec3::Z * block.z).collect::<Vec<_>>();
    let block = Obstacle::solid(&Polyhedron::of_points(&block, 1e-12).unwrap());
    let floor = Plane::new(Vec3::Z, -1.0).unwrap();
    let world = around(body, Vec3::Z * -G, 0.5, vec![block, floor.into()]);
    let centre = beside + Vec3::Z * half.z;
    let start = State { centre, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    run(&world, &start, &Options::default(), &mut ()).unwrap()
}

#[test]
fn a_box_rests_on_a_block_as_long_as_its_middle_is_over_it() {
    let wide = Vec3::new(0.1, 0.1, 0.05);
    // Over the middle, over one end, over a corner, on a block of its own size, and on one that is smaller.
    let half = Vec3::new(0.06, 0.04, 0.03);
    let small = Vec3::new(0.03, 0.02, 0.02);
    for (block, beside) in [
        (wide, Vec3::ZERO),
        (wide, Vec3::X * 0.099),
        (wide, Vec3::new(0.09, -0.09, 0.0)),
        (wide, Vec3::new(0.04, 0.06, 0.0)),
        (half, Vec3::ZERO),
        (half, Vec3::new(0.02, 0.01, 0.0)),
        (small, Vec3::ZERO),
        (small, Vec3::new(0.02, 0.0, 0.0)),
    ] {
        let rests = lies_on(block, beside);
        assert!(matches!(rests.end, End::AtRest { .. }), "{block:?} {beside:?}: {:?}", rests.end);
        assert_eq!((rests.time, rests.impacts.len()), (0.0, 0), "{block:?} {beside:?}");
    }
    for beside in [Vec3::X * 0.101, Vec3::new(0.11, -0.09, 0.0)] {
        let tips = lies_on(wide, beside);
        assert!(matches!(tips.end, End::AtRest { .. }), "{beside:?}: {:?}", tips.end);
        assert!(tips.state.centre.z < -0.9, "{beside:?}: it lies at {:?}", tips.state.centre);
    }
}

#[test]
fn a_body_that_starts_in_a_block_is_refused() {
    let (world, start) = on_three_tips(0.1, 0.2);
    let sunk = State { centre: start.centre - Vec3::Z * 0.002, ..start };
    let error = run(&world, &sunk, &Options::default(), &mut ()).unwrap_err();
    let MotionError::Overlaps { obstacle, depth } = error else { panic!("{error}") };
    assert!(obstacle == 0 && (depth - 0.002).abs() < 1e-12, "{error}");
}

/// A level plate from one x to another, so wide to both sides.
fn level([from, to]: [f64; 2], wide: f64) -> Obstacle {
    let corner = |x: f64, y: f64| Vec3::new(x, y, 0.0);
    Obstacle::plate(&[corner(from, -wide), corner(to, -wide), corner(to, wide), corner(from, wide)]).unwrap()
}

/// A cube of 20 cm that slides along x on plates, for a time.
fn slid(plates: Vec<Obstacle>, from: Vec3, speed: f64, time: f64) -> Run {
    let body =
        Body::new(1.0, Mat3::diagonal(0.0067, 0.0067, 0.0067), corners(Vec3::new(0.1, 0.1, 0.1))).unwrap();
    let world = around(body, Vec3::Z * -G, 0.3, plates);
    let (centre, velocity) = (from + Vec3::Z * 0.1, Vec3::X * speed);
    ran(&world, &State { centre, attitude: Rotation::NONE, velocity, spin: Vec3::ZERO }, time).0
}

#[test]
fn a_box_slides_over_the_seam_of_two_plates() {
    let out = slid(vec![level([-1.0, 0.0], 0.5), level([0.0, 1.0], 0.5)], Vec3::X * -0.3, 1.5, 2.0);
    assert!(
        matches!(out.end, End::AtRest { .. }) && out.impacts.is_empty(),
        "{:?} {:?}",
        out.end,
        out.impacts
    );
    let way = 1.5 * 1.5 / (2.0 * 0.3 * G);
    assert!((out.state.centre.x + 0.3 - way).abs() < 1e-10, "{} {way}", out.state.centre.x + 0.3);
}

/// What of a plate's end is under a box makes no difference to how it tips over that: its edges, or the plate's corners under its face.
#[test]
fn a_box_tips_over_an_end_that_is_narrower_than_it_as_over_a_wide_one() {
    let over =
        |wide: f64, beside: f64| slid(vec![level([-1.0, 1.0], wide)], Vec3::new(0.5, beside, 0.0), 3.0, 0.4);
    let wide = over(0.7, 0.0);
    assert!(wide.impacts.is_empty() && wide.state.centre.z < -0.1, "{:?}", wide.state);
    for (plate, beside) in [(0.05, 0.0), (0.07, 0.01), (0.15, 0.1)] {
        let out = over(plate, beside);
        assert!(out.impacts.is_empty(), "{plate}: {:?}", out.impacts);
        let off = (out.state.centre - wide.state.centre - Vec3::Y * beside).norm();
        let spin = (out.state.spin - wide.state.spin).norm();
        assert!(off < 1e-10 && spin < 1e-9, "{plate} {beside}: {off:e} {spin:e}");
    }
}

/// Its mass hangs under the plate on which its corners stand.
#[test]
fn a_weight_that_hangs_through_a_plate_stands_on_it() {
    let points = corners(Vec3::new(0.1, 0.1, 0.02)).into_iter().map(|r| r + Vec3::Z * 0.3).collect();
    let body = Body::new(1.0, Mat3::diagonal(0.004, 0.004, 0.004), points).unwrap();
    let floor = Plane::new(Vec3::Z, -2.0).unwrap();
    let world = around(body, Vec3::Z * -G, 0.3, vec![level([-0.3, 0.3], 0.3), floor.into()]);
    let start =
        State { centre: Vec3::Z * -0.2, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    let out = run(&world, &start, &Options::default(), &mut ()).unwrap();
    assert!(matches!(out.end, End::AtRest { .. }), "{:?}", out.end);
    assert!((out.state.centre.z + 0.28).abs() < 1e-12, "{}", out.state.centre.z);
}
