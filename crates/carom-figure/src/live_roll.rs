//! The report of a roll piece by piece, for a page that stays open while the file changes.

use crate::live::FILLED;
use crate::markup::{html, notes};
use crate::roll::{RollFigure, in_full, strikes_table};
use crate::view::View;
use crate::{player, roll_scene};

/// What the report of a roll shows.
#[derive(Clone, Debug, PartialEq)]
pub struct LiveRoll {
    /// What moves and what it moves among: the children of an SVG of the class `fig scene`.
    pub scene: String,
    /// The motion, as the player of the reports reads it.
    pub motion: String,
    /// Clock, ribbon and buttons of the player, as HTML.
    pub controls: String,
    /// The sentence below the verdict, and sentences on the law.
    pub said: String,
    /// The strikes in a table, as HTML.
    pub strikes: String,
    /// Each strike with its contacts and hypotheses, as HTML.
    pub hypotheses: String,
}

/// The window of a page that shows a roll: `width` × `height` pixels, with its motion inside.
pub fn live_roll_view(figure: &RollFigure<'_>, [width, height]: [f64; 2]) -> View {
    roll_scene::view_of(figure, [FILLED * width, FILLED * height]).filling(width, height)
}

/// The pieces of the report of a roll, its picture in a window.
pub fn live_roll(figure: &RollFigure<'_>, view: &View) -> LiveRoll {
    LiveRoll {
        scene: roll_scene::inside(figure, view, roll_scene::moves(figure)).into_string(),
        motion: roll_scene::numbers(figure, view),
        controls: player::controls(roll_scene::SPEED).into_string(),
        said: html! { p.lead { (figure.lead) } (notes(figure.notes)) }.into_string(),
        strikes: strikes_table(figure.strikes).into_string(),
        hypotheses: in_full(figure.strikes).into_string(),
    }
}
