//! The faces of a part as a table: what lies below, and how surely the part stays there.

use crate::markup::{Markup, html, table};
use crate::text::{fixed, percent};
use carom_motion::planar::{Rest, RestKind, Shape};
use carom_words::Words;

/// Decimals of lengths in millimetres.
const DECIMALS: usize = 2;

/// The table; empty for a disc, which has no faces.
pub(crate) fn section(shape: &Shape) -> Markup {
    let rests = shape.rests();
    let heads = [
        "face",
        "lies on",
        "width [mm]",
        "mass centre above it [mm]",
        "inside the ends by [mm]",
        "tips after",
        "tips onto it gently",
    ];
    html! {
        @if !rests.is_empty() {
            section id="faces" {
                h2 { "Faces" }
                (table("", &heads, rests.iter().enumerate().map(row)))
                p.note {
                    "On level ground, at rest. Where two numbers stand, the first is towards the end that comes first counter-clockwise, or for a clockwise tilt. The last column: the share of all attitudes from which the part tips onto the face so slowly that it never swings on."
                }
            }
        }
    }
}

fn row((face, rest): (usize, &Rest)) -> Markup {
    let millimetres = |length: f64| fixed(1e3 * length, DECIMALS);
    let degrees = |angle: f64| format!("{}°", fixed(angle.to_degrees(), 1));
    let [first, second] = rest.inside();
    let arc = rest.kind == RestKind::Arc;
    let ends =
        if arc { "–".to_owned() } else { format!("{} | {}", millimetres(first), millimetres(second)) };
    let stays = rest.share() > 0.0;
    html! {
        tr {
            th scope="row" { (face) }
            td { (rest.kind.word()) }
            td { @if arc { "–" } @else { (millimetres((rest.to - rest.from).norm())) } }
            td { (millimetres(rest.depth)) }
            td { (ends) }
            td {
                @if stays { (degrees(rest.basin[0])) " | " (degrees(rest.basin[1])) } @else { "does not stay" }
            }
            td { (percent(rest.share())) " %" }
        }
    }
}
