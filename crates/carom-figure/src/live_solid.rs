//! The report of a body in space piece by piece, for a page that stays open while the file changes.

use crate::markup::{html, notes};
use crate::solid::SolidFigure;
use crate::{solid_scene, solid_tables, tilt_chart};

/// What the report of a body in space shows.
#[derive(Clone, Debug, PartialEq)]
pub struct LiveSolid {
    /// The canvas and what plays it, as HTML.
    pub player: String,
    /// Body and motion, as the player of the reports reads them.
    pub motion: String,
    /// The tilt against time, as HTML.
    pub chart: String,
    /// The sentence below the verdict, and sentences on the law.
    pub said: String,
    /// The strikes in a table, and series of them, as HTML.
    pub strikes: String,
    /// Each strike with its states, as HTML.
    pub states: String,
}

/// The pieces of the report of a body in space.
pub fn live_solid(figure: &SolidFigure<'_>) -> LiveSolid {
    let (strikes, series) = (solid_tables::strikes(figure.strikes), solid_tables::series(figure.series));
    LiveSolid {
        player: solid_scene::player(figure).into_string(),
        motion: solid_scene::numbers(figure),
        chart: tilt_chart::section(figure).into_string(),
        said: html! { p.lead { (figure.lead) } (notes(figure.notes)) }.into_string(),
        strikes: html! { (strikes) (series) }.into_string(),
        states: solid_tables::in_full(figure.strikes).into_string(),
    }
}
