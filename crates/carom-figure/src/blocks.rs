//! A scene as convex blocks, for simulators that know no other solids.

use crate::outline::sides;
use carom_feeder::{Feeder, Form, PartKind};
use carom_motion::planar::Shape;
use carom_num::Vec2;
use carom_num::elementary::atan2;
use earcut::Earcut;
use std::f64::consts::TAU;

/// Chords of a whole turn, by which arcs are replaced.
const CHORDS: f64 = 64.0;
/// Thickness of plates and walls that are drawn thin, as a share of the part's size.
const THIN: f64 = 0.1;
/// Thickness of a part that has none, as a share of its length.
const THIN_PART: f64 = 0.01;
/// Half the width of all blocks, out of the plane, as a share of the part's size.
const HALF_WIDTH: f64 = 0.1;

/// A solid out of the plane: a convex polygon or a circle that is drawn out of the plane.
pub(crate) enum Block {
    /// A rectangle: its middle, the direction of its first side [rad], half its sides [m].
    Box { middle: Vec2, angle: f64, half: [f64; 2] },
    /// Corners, counter-clockwise [m].
    Prism(Vec<Vec2>),
    /// Middle and radius [m].
    Disc(Vec2, f64),
}

/// A plate or a wall.
pub(crate) struct Standing {
    pub(crate) name: String,
    pub(crate) friction: f64,
    pub(crate) restitution: f64,
    pub(crate) blocks: Vec<Block>,
}

/// A feeder made of blocks.
pub(crate) struct Blocks {
    /// About the part's mass centre, not yet turned.
    pub(crate) part: Vec<Block>,
    /// Where it starts: its mass centre [m] and its angle [rad].
    pub(crate) start: (Vec2, f64),
    pub(crate) standing: Vec<Standing>,
    /// Half the width of all of it [m].
    pub(crate) half_width: f64,
    /// What differs from the scene.
    pub(crate) notes: Vec<String>,
}

pub(crate) fn blocks(feeder: &Feeder) -> Blocks {
    let shape = &feeder.part.body.shape;
    let (size, state) = (shape.size(), feeder.start_state());
    let mut notes = vec![];
    let mut centre = state.pose.centre;
    let part = if feeder.part.kind == PartKind::Rod {
        let (from, to) = (shape.vertices()[0], shape.vertices()[1]);
        let half = [0.5 * (to - from).norm(), 0.5 * THIN_PART * (to - from).norm()];
        // It lies on its lower side, which is half its thickness below.
        centre += up_from_first_plate(feeder) * half[1];
        notes.push(format!("The part has no thickness: here it is {} m thick", 2.0 * half[1]));
        vec![Block::Box { middle: (from + to) * 0.5, angle: atan2((to - from).y, (to - from).x), half }]
    } else {
        solid(shape, &mut notes)
    };
    let mut standing = vec![];
    for plate in &feeder.plates {
        let below = if plate.form.edge_radius > 0.0 { 2.0 * plate.form.edge_radius } else { THIN * size };
        let blocks = plate.pieces().into_iter().map(|(from, to)| sheet(from, to, below)).collect();
        standing.push(Standing {
            name: plate.name.clone(),
            friction: plate.friction,
            restitution: plate.restitution,
            blocks,
        });
    }
    for wall in &feeder.walls {
        let Form { edge_radius, .. } = wall.form;
        let half = if edge_radius > 0.0 { edge_radius } else { 0.5 * THIN * size };
        let pieces = wall.form.pieces(wall.from, wall.to).into_iter();
        let blocks = pieces.map(|(from, to)| slab(from, to, half)).collect();
        let (friction, restitution) = (wall.friction, wall.restitution);
        standing.push(Standing { name: wall.name.clone(), friction, restitution, blocks });
    }
    notes.push(format!(
        "Plates and walls that are drawn thin are {} m thick here, plates below their upper side; round edges and bends are straight pieces",
        THIN * size
    ));
    Blocks { part, start: (centre, state.pose.angle), standing, half_width: HALF_WIDTH * size, notes }
}

/// The direction out of the first plate, upwards.
fn up_from_first_plate(feeder: &Feeder) -> Vec2 {
    let left = feeder.start_place().map_or(Vec2::new(1.0, 0.0), |(_, downhill)| downhill).turned_left();
    if left.y >= 0.0 { left } else { -left }
}

/// A plate from one end to the other, so thick below its upper side.
fn sheet(from: Vec2, to: Vec2, thick: f64) -> Block {
    let (from, to) = if to.x >= from.x { (from, to) } else { (to, from) };
    let along = to - from;
    let down = along.turned_left() * (-0.5 * thick / along.norm());
    Block::Box {
        middle: (from + to) * 0.5 + down,
        angle: atan2(along.y, along.x),
        half: [0.5 * along.norm(), 0.5 * thick],
    }
}

/// A wall about its line.
fn slab(from: Vec2, to: Vec2, half: f64) -> Block {
    let along = to - from;
    Block::Box { middle: (from + to) * 0.5, angle: atan2(along.y, along.x), half: [0.5 * along.norm(), half] }
}

/// A part: a disc, one convex prism, or triangles.
fn solid(shape: &Shape, notes: &mut Vec<String>) -> Vec<Block> {
    if shape.faces() == 0 {
        return vec![Block::Disc(shape.vertices()[0], shape.radius_of(0))];
    }
    let (corners, rounded) = corners(shape);
    if rounded {
        notes.push(format!("Arcs of the part are replaced by chords, {CHORDS} to a turn"));
    }
    let count = corners.len();
    let turns_left = |i: usize| {
        let (a, b, c) = (corners[i], corners[(i + 1) % count], corners[(i + 2) % count]);
        (b - a).cross(c - b) >= 0.0
    };
    if (0..count).all(turns_left) {
        return vec![Block::Prism(corners)];
    }
    let mut found: Vec<usize> = vec![];
    Earcut::new().earcut(corners.iter().map(|p| [p.x, p.y]), &[], &mut found);
    notes.push("The part has hollows: it is made of triangles".to_owned());
    let triangle = |of: &[usize]| {
        let [a, b, c] = [corners[of[0]], corners[of[1]], corners[of[2]]];
        Block::Prism(if (b - a).cross(c - a) >= 0.0 { vec![a, b, c] } else { vec![a, c, b] })
    };
    found.chunks_exact(3).map(triangle).collect()
}

/// The corners of an outline, counter-clockwise, and whether chords stand for arcs.
fn corners(shape: &Shape) -> (Vec<Vec2>, bool) {
    let (mut corners, mut rounded) = (vec![], false);
    for side in sides(shape) {
        corners.push(side.to);
        let Some(bend) = side.arc else { continue };
        rounded = true;
        let [from, to] = bend.normals.map(|n| atan2(n.y, n.x));
        // Against the clock about an arc that bulges, with it about a hollow.
        let sweep =
            if bend.radius > 0.0 { (to - from).rem_euclid(TAU) } else { -(from - to).rem_euclid(TAU) };
        let count = (sweep.abs() / TAU * CHORDS).ceil().max(1.0) as u32;
        let on = |i: u32| {
            bend.centre + Vec2::at_angle(from + sweep * f64::from(i) / f64::from(count)) * bend.radius
        };
        corners.extend((1..count).map(on));
        corners.push(on(count));
    }
    corners.dedup_by(|b, a| (*b - *a).norm() <= f64::EPSILON * shape.size());
    if corners.len() > 1 && (corners[0] - corners[corners.len() - 1]).norm() <= f64::EPSILON * shape.size() {
        corners.pop();
    }
    (corners, rounded)
}
