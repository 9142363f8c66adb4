//! The part by itself, enlarged, as it starts and as it ends, with the numbers of its faces.

use crate::draft::Draft;
use crate::layout::ghost;
use crate::markup::{Markup, html, joined};
use crate::mechanism::obstacles_svg;
use crate::motion::around_part;
use crate::svg;
use crate::text::px;
use crate::view::View;
use carom_feeder::{Feeder, Run};
use carom_motion::planar::{Pose, RestKind};
use carom_num::Vec2;

/// One picture [px].
const SIDE: f64 = 230.0;
/// How far the view reaches beyond the part, as a share of its size.
const BEYOND: f64 = 0.28;
/// Pixels from a face to its number.
const OFF: f64 = 11.0;
/// Faces shorter than this have no room for a number [px], unless the part starts or ends on them.
const SHORTEST: f64 = 10.0;

/// The figure; empty for a disc, which has no faces.
pub(crate) fn figure(feeder: &Feeder, run: Option<&Run>, draft: &Draft) -> Markup {
    let shape = &feeder.part.body.shape;
    if shape.rests().is_empty() {
        return html! {};
    }
    let end = run.and_then(|run| run.stages.last()).map(|stage| stage.end).filter(|end| end.is_finite());
    let ends_on = run.and_then(|run| run.landings.last()).and_then(|landing| landing.face);
    let on = ends_on.map(|face| format!(", on face {face}")).unwrap_or_default();
    let picture = |pose: Pose, words: &str| {
        let named = [Some(feeder.start.face), ends_on];
        html! { div { (pose_svg(feeder, draft, pose, &named)) p.note { (words) } } }
    };
    let drawn =
        if draft.outline.is_empty() { "" } else { " Filled: what its file draws; dashed: what touches." };
    let across = shape.rests().iter().any(|rest| rest.kind == RestKind::Across);
    let lies = if across {
        " A number in parentheses: there the part lies on two points, across a hollow."
    } else {
        ""
    };
    html! {
        figure id="part-faces" {
            div.poses {
                (picture(feeder.start_state().pose, &format!("at the start, on face {}", feeder.start.face)))
                @if let Some(end) = end { (picture(end.pose, &format!("at the end{on}"))) }
            }
            figcaption {
                "The part, enlarged: the numbers of its faces. The coloured side was down at the start." (drawn) (lies)
            }
        }
    }
}

fn pose_svg(feeder: &Feeder, draft: &Draft, pose: Pose, named: &[Option<usize>]) -> Markup {
    let margin = BEYOND * feeder.part.body.shape.size();
    let view = View::around(&around_part(feeder, pose.centre).into_iter().collect(), margin, SIDE, SIDE);
    let shape = &feeder.part.body.shape;
    let turn = Vec2::at_angle(pose.angle);
    let mut numbers = vec![];
    for (face, rest) in shape.rests().iter().enumerate() {
        let short = rest.kind != RestKind::Arc && (rest.to - rest.from).norm() * view.scale < SHORTEST;
        if short && !named.contains(&Some(face)) {
            continue;
        }
        let middle = (rest.from + rest.to) * 0.5;
        let direction = rest.normal.rotated(turn.x, turn.y);
        let at = view.at(pose.centre + middle.rotated(turn.x, turn.y))
            + Vec2::new(direction.x, -direction.y) * OFF;
        // Across a hollow the part lies on two points.
        let number = if rest.kind == RestKind::Across { format!("({face})") } else { face.to_string() };
        numbers.push(svg::text("face", [at.x, at.y + 4.5], "middle", &number));
    }
    let side = px(SIDE);
    html! {
        svg.fig.faces viewBox=(format!("0 0 {side} {side}")) width=(side) height=(side) role="img"
            aria-label="The part with the numbers of its faces" {
            (obstacles_svg(feeder, &view))
            (ghost(feeder, draft, pose, &view, "ghost stage"))
            (svg::circle("centre", svg::xy(view.at(pose.centre)), 2.6))
            (joined(numbers))
        }
    }
}
