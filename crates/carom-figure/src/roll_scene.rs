//! The picture of a roll: obstacles, the path of the mass centre, the body at its strikes, and the player.

use crate::markup::{Markup, html, joined};
use crate::mechanism::{Drawn, obstacle_svg, path_each, piece_path};
use crate::motion::{corners, poses, poses_each};
use crate::outline::path;
use crate::player::{self, MOST_SAMPLES, all_samples, json_text};
use crate::roll::RollFigure;
use crate::svg;
use crate::text::px;
use crate::view::{Extent, View};
use carom_impact::planar::Slip;
use carom_motion::planar::trace::{Piece, PieceEnd};
use carom_motion::planar::{Obstacle, Pose, Shape};
use carom_num::Vec2;

const WIDTH: f64 = 1000.0;
const HEIGHT: f64 = 440.0;
/// Paper around the scene, for the marks at its border.
const FRAME: f64 = 16.0;
/// How far from its start the body is followed by the view, in sizes of the body.
const FAR: f64 = 14.0;
/// Strikes at which the body is drawn.
const MOST_GHOSTS: usize = 12;
/// Pixels that the mark stands off a thin rod's line.
const MARK_OFFSET: f64 = 2.6;
/// The speed at which a body is played first: what rolls is slower to follow than what falls.
pub(crate) const SPEED: f64 = 0.1;
/// Pieces that the player names.
const MOST_STAGES: usize = 1000;

/// The section with the picture; it plays where something moves.
pub(crate) fn section(figure: &RollFigure<'_>) -> Markup {
    let view = view_of(figure, [WIDTH, HEIGHT]);
    let moves = moves(figure);
    let drawing = scene(figure, &view, moves);
    let caption = html! {
        figcaption { "To scale. The body faintly as it is at its first strikes; forces as arrows." }
    };
    if !moves {
        return html! { section id="motion" { h2 { "Picture" } figure { (drawing) (caption) } } };
    }
    html! {
        section id="motion" {
            h2 { "Motion" }
            div id="player" class="player" style="max-width:none" tabindex="0" role="group"
                aria-label="Animation of the body" { (drawing) (player::controls(SPEED)) }
            (caption)
            noscript { p.note { "The animation needs JavaScript." } }
            (player::numbers_element("motion-numbers", numbers(figure, &view)))
        }
    }
}

/// Whether anything moves: then the picture plays.
pub(crate) fn moves(figure: &RollFigure<'_>) -> bool {
    figure.trace.pieces.iter().any(|piece| piece.end_time > piece.start_time)
}

/// The view of the motion, at most so many pixels wide and high.
pub(crate) fn view_of(figure: &RollFigure<'_>, [width, height]: [f64; 2]) -> View {
    let shape = &figure.world.bodies[0].shape;
    let (size, start) = (shape.size(), figure.start.pose);
    let mut extent: Extent = corners(shape, start).collect();
    let pieces = &figure.trace.pieces;
    let each = poses_each(pieces.iter());
    let near = |pose: &Pose| (pose.centre - start.centre).norm() < FAR * size;
    for pose in pieces.iter().flat_map(|piece| poses(piece, each)).filter(near) {
        extent.extend(corners(shape, pose));
    }
    let strikes = figure.trace.impacts.iter().take(MOST_GHOSTS).flat_map(|impact| &impact.contacts);
    extent.extend(strikes.map(|contact| contact.point));
    View::around(&extent, 0.3 * size + shape.radius(), width, height)
}

fn scene(figure: &RollFigure<'_>, view: &View, moves: bool) -> Markup {
    let width = px(view.width() + 2.0 * FRAME);
    html! {
        svg.fig.scene style={ "width:" (width) "px" } viewBox=(view.framed(FRAME)) role="img"
            aria-label="The body and what it rolls on" { (inside(figure, view, moves)) }
    }
}

/// The children of the picture.
pub(crate) fn inside(figure: &RollFigure<'_>, view: &View, moves: bool) -> Markup {
    let shape = &figure.world.bodies[0].shape;
    let shown = &figure.trace.pieces[..figure.trace.pieces.len().min(MOST_STAGES)];
    let each = path_each(shown);
    let first = figure.trace.impacts.iter().take(MOST_GHOSTS);
    let last = figure.trace.pieces.last().map_or(figure.start.pose, |piece| piece.end.pose);
    html! {
        @for obstacle in &figure.world.obstacles {
            @if let Some(d) = drawn(obstacle, figure.start.pose.centre, view) { (obstacle_svg(&d)) }
        }
        @for [from, to] in figure.unreached {
            (svg::line("plate", svg::xy(view.at(*from)), svg::xy(view.at(*to))))
        }
        @for piece in shown {
            path class={ "path " (word(piece)) } d=(piece_path(piece, each, view)) {}
        }
        @for pose in std::iter::once(figure.start.pose).chain(first.map(|impact| impact.pose)) {
            g.ghost transform=(placed(view, pose)) { (outline(shape, view)) }
        }
        g id="forces" {}
        g id="part" transform=(placed(view, if moves { figure.start.pose } else { last })) {
            (outline(shape, view))
            circle.centre r="2.6" {}
        }
        (labels(figure, view))
    }
}

/// The pose as SVG: angles turn clockwise there.
fn placed(view: &View, pose: Pose) -> String {
    let at = view.at(pose.centre);
    format!("translate({} {}) rotate({})", px(at.x), px(at.y), px(-pose.angle.to_degrees()))
}

/// The outline at angle zero about the paper's origin, with the mark that shows how it turns.
fn outline(shape: &Shape, view: &View) -> Markup {
    let (from, to) = if shape.faces() == 0 {
        (Vec2::ZERO, Vec2::new(shape.radius(), 0.0))
    } else {
        let (a, b) = shape.face(0);
        // On a rod's own line the mark could not be told from the rod.
        let off = if shape.faces() == 2 { MARK_OFFSET / view.scale } else { 0.0 };
        let n = shape.face_normal(0) * (shape.radius() + off);
        (a + n, b + n)
    };
    let mut mark = String::new();
    [from, to].into_iter().for_each(|p| svg::to(&mut mark, svg::xy(view.along(p))));
    html! { (svg::path("body", &path(shape, view.scale, &|p| view.along(p)))) (svg::path("mark", &mark)) }
}

/// An obstacle on paper, hatched on the side that the body does not start on.
fn drawn(obstacle: &Obstacle, body: Vec2, view: &View) -> Option<Drawn> {
    let (a, b, cut) = view.clip(obstacle.from(), obstacle.to())?;
    let left = obstacle.direction().turned_left();
    let back = if left.dot(body - obstacle.from()) > 0.0 { -left } else { left };
    Some(Drawn { from: view.at(a), to: view.at(b), cut, back: Vec2::new(back.x, -back.y) })
}

/// Names at the contacts of the first strike.
fn labels(figure: &RollFigure<'_>, view: &View) -> Markup {
    let (Some(impact), Some(strike)) = (figure.trace.impacts.first(), figure.strikes.first()) else {
        return html! {};
    };
    let mut contacts: Vec<_> = impact.contacts.iter().collect();
    // As the strike lists them: those touched before it first.
    contacts.sort_by(|a, b| {
        (a.before.normal < 0.0, a.obstacle)
            .cmp(&(b.before.normal < 0.0, b.obstacle))
            .then(a.point.x.total_cmp(&b.point.x))
    });
    let label = |(contact, name): (&&carom_motion::planar::trace::ImpactContact, &String)| {
        // Beside the contact and below it: a post stands straight below.
        let at = view.at(contact.point - contact.normal * (14.0 / view.scale)) + Vec2::new(11.0, 7.0);
        html! {
            (svg::circle("strike", svg::xy(view.at(contact.point)), 4.0))
            text.name x=(px(at.x)) y=(px(at.y)) text-anchor="middle" dominant-baseline="middle" { (name) }
        }
    };
    joined(contacts.iter().zip(strike.contacts.iter().map(|c| &c.name)).map(label))
}

/// What the body does in a piece, in the words that the styles know.
fn word(piece: &Piece) -> &'static str {
    let turns = piece.start.twist.spin != 0.0 || piece.end.twist.spin != 0.0;
    let slips = piece.held.iter().any(|held| held.slip != Slip::Sticks);
    match (piece.ended_by, piece.held.is_empty()) {
        (PieceEnd::Rests, _) => "rest",
        (_, true) => "flight",
        _ if turns && !slips => "roll",
        _ if turns => "tip",
        _ => "slide",
    }
}

/// The motion as JSON, in the scene's pixels and degrees (clockwise, as SVG turns).
pub(crate) fn numbers(figure: &RollFigure<'_>, view: &View) -> String {
    let pieces = &figure.trace.pieces;
    let weight = figure.world.bodies[0].mass * figure.world.gravity.norm();
    let samples = all_samples(pieces, MOST_SAMPLES, view, weight);
    let stage = |piece: &Piece| {
        let on: Vec<&str> =
            piece.held.iter().filter_map(|h| figure.obstacles.get(h.obstacle)).map(String::as_str).collect();
        let name = if word(piece) == "tip" { "turn and slide" } else { word(piece) };
        format!(
            "[{},{},{},{}]",
            json_text(name),
            json_text(&on.join(" and ")),
            piece.start_time,
            piece.end_time
        )
    };
    let finite = |piece: &&Piece| piece.start_time.is_finite() && piece.end_time.is_finite();
    let stages: Vec<String> = pieces.iter().filter(finite).take(MOST_STAGES).map(stage).collect();
    let strikes = figure.trace.impacts.iter().filter(|i| i.time.is_finite()).take(MOST_STAGES);
    let strikes: Vec<String> = strikes.map(|i| format!("{}", i.time)).collect();
    format!(
        "{{\"samples\":[{samples}],\"stages\":[{}],\"strikes\":[{}]}}",
        stages.join(","),
        strikes.join(",")
    )
}
