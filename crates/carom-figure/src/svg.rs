//! What drawings are made of: lines, circles, rectangles, paths and texts, each with the class that styles it. Numbers have one format.

use crate::markup::{Markup, PreEscaped, html, joined};
use crate::text::px;
use carom_num::Vec2;
use std::fmt::Write;

/// A drawing of this size [px] that can stand alone.
pub(crate) fn drawing(class: &str, [width, height]: [f64; 2], label: &str, inside: Markup) -> Markup {
    let [width, height] = [width, height].map(px);
    html! {
        svg xmlns="http://www.w3.org/2000/svg" class=(class) viewBox={ "0 0 " (width) " " (height) }
            width=(width) height=(height) role="img" aria-label=(label) { (inside) }
    }
}

/// What a drawing that stands alone begins with: its style, and paper under it.
pub(crate) fn styled([width, height]: [f64; 2], styles: &[&str]) -> Markup {
    html! {
        style { @for style in styles { (PreEscaped(style)) } }
        rect.paper width=(px(width)) height=(px(height)) {}
    }
}

pub(crate) fn line(class: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> Markup {
    html! { line class=(class) x1=(px(x1)) y1=(px(y1)) x2=(px(x2)) y2=(px(y2)) {} }
}

pub(crate) fn circle(class: &str, [x, y]: [f64; 2], radius: f64) -> Markup {
    html! { circle class=(class) cx=(px(x)) cy=(px(y)) r=(px(radius)) {} }
}

pub(crate) fn rect(class: &str, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> Markup {
    html! { rect class=(class) x=(px(x)) y=(px(y)) width=(px(width)) height=(px(height)) {} }
}

pub(crate) fn path(class: &str, data: &str) -> Markup {
    html! { path class=(class) d=(data) {} }
}

/// A text; lowered letters are small `tspan`s, as few fonts have the characters.
pub(crate) fn text(class: &str, [x, y]: [f64; 2], anchor: &str, words: &str) -> Markup {
    html! { text class=(class) x=(px(x)) y=(px(y)) text-anchor=(anchor) { (lowered(words)) } }
}

fn lowered(words: &str) -> Markup {
    joined(words.split_inclusive(['\u{209c}', '\u{2099}']).map(|piece| {
        let small = [('\u{209c}', "t"), ('\u{2099}', "n")];
        let ends = small.into_iter().find_map(|(c, small)| Some((piece.strip_suffix(c)?, small)));
        match ends {
            Some((before, small)) => html! { (before) (index(small)) },
            None => html! { (piece) },
        }
    }))
}

/// A lowered small `tspan`, which every viewer shows alike.
pub(crate) fn index(small: &str) -> Markup {
    html! { tspan dy="3" font-size="78%" { (small) } tspan dy="-3" { "\u{200b}" } }
}

/// A point on paper as two numbers.
pub(crate) fn xy(p: Vec2) -> [f64; 2] {
    [p.x, p.y]
}

/// Where a text stands that runs along a direction on paper: the value of its `transform`.
pub(crate) fn placed(at: Vec2, along: Vec2) -> String {
    let angle = carom_num::elementary::atan2(along.y, along.x).to_degrees();
    format!("translate({} {}) rotate({})", px(at.x), px(at.y), px(angle))
}

/// Adds a corner to the data of a path: it moves to the first one, and draws lines to the others.
pub(crate) fn to(data: &mut String, [x, y]: [f64; 2]) {
    let word = if data.is_empty() { 'M' } else { 'L' };
    // A string takes all that is written into it.
    let _ = write!(data, "{word}{} {}", px(x), px(y));
}
