//! The reports of motions in space piece by piece, for a page that stays open while the file changes.

use crate::live::LiveSections;
use crate::markup::{html, notes};
use crate::solid::SolidFigure;
use crate::space_report::{self, SpaceFigure};
use crate::space_scene::SpaceScene;
use crate::{solid_scene, solid_tables, space_tables, tilt_chart};

/// What the report of a motion in space shows, and says beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct LiveSolid {
    /// The canvas and what plays it, as HTML.
    pub player: String,
    /// Body and motion, as the player of the reports reads them.
    pub motion: String,
    /// The tilt against time, as HTML.
    pub chart: String,
    /// What is said of it.
    pub sections: LiveSections,
}

/// The pieces of the report of a body in space.
pub fn live_solid(figure: &SolidFigure<'_>) -> LiveSolid {
    let (strikes, series) = (solid_tables::strikes(figure.strikes), solid_tables::series(figure.series));
    LiveSolid {
        player: solid_scene::player(figure).into_string(),
        motion: solid_scene::numbers(figure),
        chart: tilt_chart::section(figure).into_string(),
        sections: LiveSections {
            verdict: html! { p.lead { (figure.lead) } (notes(figure.notes)) }.into_string(),
            timeline: html! { (strikes) (series) }.into_string(),
            part: String::new(),
            stages: String::new(),
            model: solid_tables::in_full(figure.strikes).into_string(),
        },
    }
}

/// The pieces of the report of a run in space.
///
/// # Example
/// ```
/// use carom_figure::{SpaceFigure, live_space};
/// let feeder = carom_feeder::spatial::examples::two_plates();
/// let run = feeder.run()?;
/// let live = live_space(&SpaceFigure {
///     title: "",
///     feeder: &feeder,
///     run: &run,
///     wanted: &[],
///     margins: &[],
///     limits: &[],
///     approximations: &[],
///     notes: &[],
///     source: "",
///     made_by: "",
/// });
/// assert!(live.motion.contains("\"plates\":[") && live.sections.part.contains("face 0"));
/// # Ok::<(), carom_feeder::RunError>(())
/// ```
pub fn live_space(figure: &SpaceFigure<'_>) -> LiveSolid {
    let SpaceFigure { feeder, run, .. } = *figure;
    let scene = SpaceScene::new(feeder, run);
    let shown = scene.figure(feeder);
    LiveSolid {
        player: html! { (solid_scene::player(&shown)) (space_report::caption(figure, &scene)) }.into_string(),
        motion: solid_scene::numbers(&shown),
        chart: space_report::chart(&shown).into_string(),
        sections: LiveSections {
            verdict: space_report::verdict(figure).into_string(),
            timeline: space_tables::stages(feeder, run).into_string(),
            part: space_tables::faces(feeder, run, figure.margins).into_string(),
            stages: html! { (space_tables::strikes(feeder, run)) (space_report::plates(feeder)) }
                .into_string(),
            model: html! {
                section id="model" { h2 { "Law and model" } (notes(&space_report::law(figure))) }
            }
            .into_string(),
        },
    }
}
