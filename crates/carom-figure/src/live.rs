//! The report piece by piece, for a page that stays open while its scene changes.

use crate::draft::Draft;
use crate::labels::Labels;
use crate::layout::{ghost, names_and_slopes};
use crate::markup::{Markup, html, joined};
use crate::mechanism::{drawn, obstacles_svg, path_svg, view_of};
use crate::outline::outline_at_rest;
use crate::report::{Extra, Wish};
use crate::text::px;
use crate::view::View;
use crate::{part_faces, part_picture, player, report, stage_table, strikes, svg, timeline, verdict};
use carom_feeder::{Feeder, Run};
use carom_num::Vec2;
use carom_words::{part, run as run_words};

/// Pixels from a plate to its badge, and shares of its length, in the order in which they are tried.
const BADGE_OFF: [f64; 4] = [24.0, 44.0, 64.0, -30.0];
const SHARES: [f64; 5] = [0.5, 0.3, 0.7, 0.1, 0.9];
/// The letters of a badge beside those of a label, and from the middle of a line to its base [px].
const LARGER: f64 = 1.3;
const BASE: f64 = 5.0;

/// The window of a page that shows a feeder with its run: `width` × `height` pixels, with all of the motion inside.
///
/// # Example
/// ```
/// # let feeder = carom_feeder::examples::disc_above_a_tray();
/// let view = carom_figure::live_view(&feeder, None, [800.0, 600.0]);
/// let pixels = (view.high - view.low) * view.scale;
/// assert!((pixels.x - 800.0).abs() < 1e-9 && (pixels.y - 600.0).abs() < 1e-9);
/// ```
pub fn live_view(feeder: &Feeder, run: Option<&Run>, [width, height]: [f64; 2]) -> View {
    view_of(feeder, run.as_slice(), FILLED * width, FILLED * height).filling(width, height)
}

/// The share of a window that the motion fills: names and handles need the rest.
pub(crate) const FILLED: f64 = 0.86;

/// The two ends of what is seen of a plate or wall [m], and which of them the window's border cuts; `None` where it lies outside.
///
/// # Example
/// ```
/// # let feeder = carom_feeder::examples::disc_above_a_tray();
/// let view = carom_figure::live_view(&feeder, None, [800.0, 600.0]);
/// assert!(carom_figure::live_ends(&feeder, 0, &view).is_some());
/// assert!(carom_figure::live_ends(&feeder, 99, &view).is_none());
/// ```
pub fn live_ends(feeder: &Feeder, obstacle: usize, view: &View) -> Option<([Vec2; 2], [bool; 2])> {
    let seen = drawn(feeder, obstacle, view)?;
    Some(([view.of(seen.from), view.of(seen.to)], seen.cut))
}

/// What moves and what it moves among, as the children of an SVG of the class `fig scene layout`; and the motion, as the player of the
/// reports reads it. Without a run the part stands where it starts.
#[derive(Clone, Debug, PartialEq)]
pub struct LiveScene {
    /// SVG.
    pub scene: String,
    /// JSON.
    pub motion: String,
}

/// The moving picture of a feeder in a window; `wanted` is what the scene wants on its plates.
///
/// # Example
/// ```
/// # let feeder = carom_feeder::examples::disc_above_a_tray();
/// let run = feeder.run().unwrap();
/// let view = carom_figure::live_view(&feeder, Some(&run), [800.0, 600.0]);
/// let shown = carom_figure::live_scene(&feeder, Some(&run), &Default::default(), &[], &view);
/// assert!(shown.scene.contains("id=\"part\"") && shown.motion.starts_with("{\"samples\":[["));
/// ```
pub fn live_scene(
    feeder: &Feeder,
    run: Option<&Run>,
    draft: &Draft,
    wanted: &[Wish],
    view: &View,
) -> LiveScene {
    let size = Vec2::new(view.width(), view.height());
    let mut labels = Labels::within(Vec2::ZERO, size);
    let names = names_and_slopes(feeder, draft, view, &mut labels);
    let scene = match run {
        Some(run) => html! {
            (end(feeder, run, draft, view))
            (player::scene(feeder, run, draft, view))
            (strike_places(run, view))
            (badges(feeder, run, wanted, view, &mut labels))
        },
        None => html! {
            (obstacles_svg(feeder, view))
            g id="forces" {}
            g id="part" { (outline_at_rest(feeder, draft, view).svg()) }
        },
    };
    let motion = match run {
        Some(run) => player::numbers(feeder, run, view),
        None => player::standing(feeder, view),
    };
    LiveScene { scene: html! { (names) (scene) }.into_string(), motion }
}

/// A small picture of a layout, one of many on a page: plates, the way of the part, where it starts and how it ends; no names. Children of an
/// SVG of the class `fig scene layout`.
///
/// # Example
/// ```
/// # let feeder = carom_feeder::examples::disc_above_a_tray();
/// let run = feeder.run().unwrap();
/// let view = carom_figure::live_view(&feeder, Some(&run), [280.0, 200.0]);
/// let small = carom_figure::live_small(&feeder, &run, &Default::default(), &view);
/// assert!(!small.contains("<text") && !small.contains("id="));
/// ```
pub fn live_small(feeder: &Feeder, run: &Run, draft: &Draft, view: &View) -> String {
    let start = ghost(feeder, draft, feeder.start_state().pose, view, "ghost stage");
    html! { (obstacles_svg(feeder, view)) (path_svg(run, view)) (start) (end(feeder, run, draft, view)) }
        .into_string()
}

/// The part as it ends.
fn end(feeder: &Feeder, run: &Run, draft: &Draft, view: &View) -> Markup {
    let last = run.stages.last().map(|stage| stage.end).filter(|end| end.is_finite());
    html! { @if let Some(end) = last { (ghost(feeder, draft, end.pose, view, "ghost stage end")) } }
}

fn strike_places(run: &Run, view: &View) -> Markup {
    let struck = run.trace.impacts.iter().filter_map(|impact| impact.contacts.first());
    let places = struck.map(|contact| contact.point).filter(|point| point.is_finite());
    joined(places.map(|point| svg::circle("strike", svg::xy(view.at(point)), 4.5)))
}

/// How the part came to lie on each plate; a sign and a colour say whether that is wanted.
fn badges(feeder: &Feeder, run: &Run, wanted: &[Wish], view: &View, labels: &mut Labels) -> Markup {
    joined(run.landings.iter().filter_map(|landing| {
        let seen = drawn(feeder, landing.plate, view)?;
        let word = landing.verdict.map(run_words::side)?;
        let name = part::obstacle(feeder, landing.plate);
        let met = wanted.iter().find(|wish| wish.plate == name).map(|wish| wish.met);
        let (class, sign) = match met {
            Some(true) => ("badge wanted", "✓ "),
            Some(false) => ("badge unwanted", "✗ "),
            None => ("badge", ""),
        };
        let text = format!("{sign}{word}");
        let room = Labels::room(&text, Vec2::new(1.0, 0.0)) * LARGER;
        let places = BADGE_OFF
            .into_iter()
            .flat_map(|off| SHARES.map(|share| seen.from + (seen.to - seen.from) * share + seen.back * off));
        let at = labels.place(room, places);
        Some(html! { text class=(class) x=(px(at.x)) y=(px(at.y + BASE)) text-anchor="middle" { (text) } })
    }))
}

/// Clock, ribbon of stages and buttons under the moving picture.
///
/// # Example
/// ```
/// assert!(carom_figure::live_controls().contains("id=\"play\""));
/// ```
pub fn live_controls() -> String {
    player::controls(player::SPEED).into_string()
}

/// What a report says beside its pictures, section by section, as HTML.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LiveSections {
    /// How it came out, and the numbers that matter.
    pub verdict: String,
    /// Stages and strikes in order of time, each in one sentence.
    pub timeline: String,
    /// The part enlarged, with its faces and their table.
    pub part: String,
    /// The table of stages.
    pub stages: String,
    /// What the model leaves out.
    pub model: String,
}

/// The sections of the report of a run.
///
/// # Example
/// ```
/// # let feeder = carom_feeder::examples::disc_above_a_tray();
/// let run = feeder.run().unwrap();
/// let sections = carom_figure::live_sections(&feeder, &run, &Default::default());
/// assert!(sections.verdict.contains("class=\"headline\"") && sections.timeline.contains("data-t="));
/// ```
pub fn live_sections(feeder: &Feeder, run: &Run, extra: &Extra) -> LiveSections {
    LiveSections {
        verdict: html! { (verdict::section(feeder, run, &extra.wanted)) (report::told(run, extra)) }
            .into_string(),
        timeline: timeline::list(feeder, run).into_string(),
        part: html! {
            (part_picture::figure(feeder, Some(run), &extra.draft))
            (part_faces::section(&feeder.part.body.shape))
        }
        .into_string(),
        stages: stage_table::section(feeder, run).into_string(),
        model: report::model(feeder, run).into_string(),
    }
}

/// One strike in full, as a report has it: what came of it, its impulse diagram, its contacts; empty where there is no such strike.
///
/// # Example
/// ```
/// # let feeder = carom_feeder::examples::disc_above_a_tray();
/// let run = feeder.run().unwrap();
/// assert!(carom_figure::live_strike(&feeder, &run, 0).contains("Strike 1 on"));
/// assert!(carom_figure::live_strike(&feeder, &run, 999).is_empty());
/// ```
pub fn live_strike(feeder: &Feeder, run: &Run, strike: usize) -> String {
    let impact = run.trace.impacts.get(strike);
    impact.map_or(String::new(), |impact| strikes::in_full(feeder, run, strike, impact).into_string())
}
