//! Plates, walls and the path of the mass centre: what the layout and the animation both show.

use crate::markup::{Markup, html, joined};
use crate::motion::{Moment, around_part, corners, instants, own, own_each, poses, poses_each};
use crate::outline::path;
use crate::senses::{obstacle_ends, upward};
use crate::sight::seen;
use crate::svg;
use crate::text::px;
use crate::view::{Extent, View};
use carom_feeder::{Feeder, Plate, Run};
use carom_motion::planar::trace::{Piece, PieceEnd};
use carom_motion::planar::{Pose, Shape};
use carom_num::Vec2;
use carom_words::Words;

/// Pixels between two strokes of the hatching, and their length.
const HATCH: (f64, f64) = (9.0, 6.5);

/// Samples that the path of a run goes through, which pieces that are many share, and those of one piece.
const MOST_OF_PATH: (usize, usize) = (1 << 13, 160);

/// A segment as drawn: on paper, with `true` for each end that was cut, and the side its hatching lies on.
pub(crate) struct Drawn {
    /// Uphill end, or one end of a wall.
    pub(crate) from: Vec2,
    /// Free edge, or the other end.
    pub(crate) to: Vec2,
    /// Cut at the border of the view.
    pub(crate) cut: [bool; 2],
    /// Unit normal on paper, away from the side that the part uses.
    pub(crate) back: Vec2,
}

/// The view that holds the motion of all these runs, the bounded plates and the near pieces of the others.
pub(crate) fn view_of(feeder: &Feeder, runs: &[&Run], width: f64, height: f64) -> View {
    let shape = &feeder.part.body.shape;
    let size = shape.size();
    let mut extent: Extent = corners(shape, feeder.start_state().pose).collect();
    extend_by_motion(&mut extent, shape, runs);
    for (i, plate) in feeder.plates.iter().enumerate() {
        if !plate.unbounded {
            extent.extend(plate.pieces().into_iter().flat_map(|(from, to)| [from, to]));
        } else if i == 0 {
            extent.extend([plate.edge]);
        } else if !runs.iter().any(|run| has_motion(run)) {
            extent.extend(near_pieces(feeder, i));
        }
    }
    let known = extent.corners();
    let centre = known.map_or(Vec2::ZERO, |(low, high)| (low + high) * 0.5);
    let reach = known.map_or(size, |(low, high)| (high - low).norm());
    for wall in &feeder.walls {
        let near = nearest_on(wall.from, wall.to, centre);
        if (near - centre).norm() < 2.0 * reach {
            extent.extend([near]);
        }
    }
    View::around(&extent, 0.35 * size + shape.radius(), width, height)
}

/// The corners of every pose; of a part that flies away only the first stretch.
fn extend_by_motion(extent: &mut Extent, shape: &Shape, runs: &[&Run]) {
    let endless = |p: &Piece| matches!(p.ended_by, PieceEnd::FliesAway | PieceEnd::TimeUp);
    let pieces = || runs.iter().flat_map(|run| &run.trace.pieces);
    let each = poses_each(pieces());
    for piece in pieces() {
        let start = piece.start.pose.centre;
        let shown = |p: &Pose| !endless(piece) || (p.centre - start).norm() < 4.0 * shape.size();
        for pose in poses(piece, each).filter(shown) {
            extent.extend(corners(shape, pose));
        }
    }
}

/// Where an endless plate is nearest to the free edge before it, and straight below that.
fn near_pieces(feeder: &Feeder, plate: usize) -> Vec<Vec2> {
    let (Some(before), Some(this)) = (feeder.plates.get(plate - 1), feeder.plates.get(plate)) else {
        return vec![];
    };
    let near = nearest_on(this.uphill, this.edge, before.edge);
    let below = plumb(feeder, plate, before.edge);
    let along = (this.edge - this.uphill).unit().unwrap_or_default();
    let on = near + along * (1.5 * feeder.part.body.shape.size());
    [Some(near), below, Some(on)].into_iter().flatten().flat_map(|p| around_part(feeder, p)).collect()
}

fn nearest_on(from: Vec2, to: Vec2, p: Vec2) -> Vec2 {
    let d = to - from;
    let along = if d.dot(d) > 0.0 { ((p - from).dot(d) / d.dot(d)).clamp(0.0, 1.0) } else { 0.0 };
    from + d * along
}

/// The point of a plate straight below `p`, if there is one.
pub(crate) fn plumb(feeder: &Feeder, plate: usize, p: Vec2) -> Option<Vec2> {
    seen(feeder, plate, p, Vec2::new(0.0, -1.0))
}

/// The longest straight piece of a course; an arc is many short ones.
fn longest(pieces: Vec<(Vec2, Vec2)>) -> Option<(Vec2, Vec2)> {
    pieces.into_iter().max_by(|a, b| (a.1 - a.0).norm().total_cmp(&(b.1 - b.0).norm()))
}

/// An obstacle on paper, of a bent one its longest straight piece; `None` where it lies outside the view.
pub(crate) fn drawn(feeder: &Feeder, obstacle: usize, view: &View) -> Option<Drawn> {
    let bent = feeder.plates.get(obstacle).filter(|plate| !plate.form.course.is_empty());
    let (from, to) = bent.and_then(|plate| longest(plate.pieces())).or(obstacle_ends(feeder, obstacle))?;
    let (a, b, cut) = view.clip(from, to)?;
    let along = (to - from).unit()?;
    let back = if obstacle < feeder.plates.len() {
        -upward(along)
    } else {
        let middle = (view.low + view.high) * 0.5;
        let left = along.turned_left();
        if (middle - a).dot(left) > 0.0 { -left } else { left }
    };
    Some(Drawn { from: view.at(a), to: view.at(b), cut, back: Vec2::new(back.x, -back.y) })
}

/// Every plate and wall with its hatching.
pub(crate) fn obstacles_svg(feeder: &Feeder, view: &View) -> Markup {
    let all = feeder.plates.len() + feeder.walls.len();
    joined((0..all).filter_map(|i| {
        let d = drawn(feeder, i, view)?;
        Some(bent_svg(feeder, i, view).unwrap_or_else(|| obstacle_svg(&d)))
    }))
}

/// An obstacle that is bent or has rounded edges: its outline, hatched along its course; none for a plain one.
fn bent_svg(feeder: &Feeder, obstacle: usize, view: &View) -> Option<Markup> {
    let plate = feeder.plates.get(obstacle);
    let walls = || feeder.walls.get(obstacle.checked_sub(feeder.plates.len())?).map(|wall| &wall.form);
    let form = plate.map(|plate| &plate.form).or_else(walls)?;
    if form.is_plain() {
        return None;
    }
    let obstacle = feeder.obstacle(obstacle).ok()??;
    let mut strokes = String::new();
    let mut next = HATCH.0;
    for (from, to) in plate.map(Plate::pieces).unwrap_or_default() {
        let (from, to) = (view.at(from), view.at(to));
        let Some(along) = (to - from).unit() else { continue };
        let left = along.turned_left();
        // On paper y points down: what looks down there is below.
        let back = if left.y < 0.0 { -left } else { left };
        let slant = (back - along) * (0.707 * HATCH.1);
        let length = (to - from).norm();
        while next < length {
            let p = from + along * next;
            strokes += &format!("M{} {}l{} {}", px(p.x), px(p.y), px(slant.x), px(slant.y));
            next += HATCH.0;
        }
        next -= length;
    }
    let shape = path(obstacle.shape(), view.scale, &|p| view.at(p));
    Some(html! { (svg::path("hatch", &strokes)) (svg::path("plate", &shape)) })
}

pub(crate) fn obstacle_svg(d: &Drawn) -> Markup {
    let length = (d.to - d.from).norm();
    let Some(along) = (d.to - d.from).unit() else { return html! {} };
    let mut strokes = String::new();
    let slant = (d.back - along) * (0.707 * HATCH.1);
    let mut s = HATCH.0;
    while s < length {
        let p = d.from + along * s;
        strokes += &format!("M{} {}l{} {}", px(p.x), px(p.y), px(slant.x), px(slant.y));
        s += HATCH.0;
    }
    let cut = [d.from, d.to].into_iter().zip(d.cut).filter(|(_, cut)| *cut);
    html! {
        (svg::path("hatch", &strokes))
        (svg::line("plate", svg::xy(d.from), svg::xy(d.to)))
        (joined(cut.map(|(end, _)| break_mark(end, along, d.back))))
    }
}

/// The zigzag of a drawing that says: it goes on.
fn break_mark(at: Vec2, along: Vec2, back: Vec2) -> Markup {
    let mut data = String::new();
    for (a, b) in [(0.0, -9.0), (-3.0, -2.0), (3.0, 2.0), (0.0, 9.0)] {
        svg::to(&mut data, svg::xy(at + along * a + back * b));
    }
    svg::path("break", &data)
}

/// The path of the mass centre, one cubic for each pair of samples, coloured by stage.
pub(crate) fn path_svg(run: &Run, view: &View) -> Markup {
    let mut out: Vec<Markup> = vec![];
    let each = path_each(&run.trace.pieces);
    for stage in &run.stages {
        let mut d = String::new();
        for piece in run.trace.pieces.get(stage.pieces.clone()).unwrap_or_default() {
            d += &piece_path(piece, each, view);
        }
        if !d.is_empty() {
            out.push(svg::path(&format!("path {}", stage.name.word()), &d));
        }
    }
    joined(out)
}

/// How many samples of each piece its path goes through.
pub(crate) fn path_each(pieces: &[Piece]) -> usize {
    own_each(pieces, MOST_OF_PATH.0, MOST_OF_PATH.1)
}

/// The path of one piece through `most` of its samples.
pub(crate) fn piece_path(piece: &Piece, most: usize, view: &View) -> String {
    let at = |p: Vec2| {
        let q = view.at(p);
        format!("{} {}", px(q.x), px(q.y))
    };
    let mut d = String::new();
    let mut last: Option<Moment<'_>> = None;
    for to in own(piece, most) {
        let b = to.state;
        d += &match last.replace(to) {
            None => format!("M{}", at(b.pose.centre)),
            Some(from) => {
                let third = (to.time - from.time) / 3.0;
                let c0 = from.state.pose.centre + from.state.twist.velocity * third;
                let c1 = b.pose.centre - b.twist.velocity * third;
                format!("C{},{},{}", at(c0), at(c1), at(b.pose.centre))
            }
        };
    }
    d
}

/// Where the part ends up, if the run kept a trace.
pub(crate) fn has_motion(run: &Run) -> bool {
    let moves = run.trace.pieces.iter().any(|piece| piece.end_time > piece.start_time);
    moves && run.trace.pieces.iter().any(|piece| instants(piece).next().is_some())
}
