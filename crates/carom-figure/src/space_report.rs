//! The report of a run in space: one HTML file that says first what happened, then shows it.

use crate::layout::millimetres;
use crate::markup::{Markup, fact, html, joined, notes, table};
use crate::page::{Page, law_and_input};
use crate::report::{QuantityLimit, REPORT_CSS, Wish, limits};
use crate::solid::{SOLID_CSS, SolidFigure};
use crate::space_rows::space_energy_change;
use crate::space_scene::SpaceScene;
use crate::text::{capitalised, fixed, significant, trimmed};
use crate::verdict::standing;
use crate::{FIGURE_CSS, solid_scene, space_tables, tilt_chart};
use carom_feeder::Landing;
use carom_feeder::spatial::{Feeder, Plate, Run, Wall, WallForm};
use carom_words::{Words, part, run as run_words};

/// What the report of a run in space shows.
///
/// # Example
/// As [`space_report`].
#[derive(Clone, Copy, Debug)]
pub struct SpaceFigure<'a> {
    /// Heading of the page.
    pub title: &'a str,
    /// The device.
    pub feeder: &'a Feeder,
    /// The run, with its trace.
    pub run: &'a Run,
    /// What is wanted on the plates, and whether the run has it.
    pub wanted: &'a [Wish],
    /// For each face how far inside it the mass centre's projection is [m]; empty where that is not known.
    pub margins: &'a [f64],
    /// How far each quantity may move before the verdict flips; empty where that was not asked.
    pub limits: &'a [QuantityLimit],
    /// How the computed part differs from the drawn one.
    pub approximations: &'a [String],
    /// What was done to the drawing that its author should know.
    pub notes: &'a [String],
    /// The scene as written; empty where there is none.
    pub source: &'a str,
    /// What made the report, with its version.
    pub made_by: &'a str,
}

/// One self-contained HTML page on a run in space: the verdict, an animation that can be turned, stages and strikes, every strike with its impulses, and the faces of the part by
/// their numbers.
///
/// It needs no network and prints. Every name is escaped; a number that is not finite shows as a dash.
///
/// # Example
/// ```
/// use carom_figure::{SpaceFigure, space_report};
/// let feeder = carom_feeder::spatial::examples::two_plates();
/// let page = space_report(&SpaceFigure {
///     title: "a & b",
///     feeder: &feeder,
///     run: &feeder.run()?,
///     wanted: &[],
///     margins: &[],
///     limits: &[],
///     approximations: &["the part touches with its hull".to_owned()],
///     notes: &[],
///     source: "",
///     made_by: "",
/// });
/// assert!(page.contains("<h1>a &amp; b</h1>") && page.contains("The part touches with its hull."));
/// # Ok::<(), carom_feeder::RunError>(())
/// ```
pub fn space_report(figure: &SpaceFigure<'_>) -> String {
    let scene = SpaceScene::new(figure.feeder, figure.run);
    let shown = scene.figure(figure.feeder);
    let body = html! {
        (verdict(figure))
        (solid_scene::section(&shown))
        (caption(figure, &scene))
        (space_tables::stages(figure.feeder, figure.run))
        (chart(&shown))
        (space_tables::strikes(figure.feeder, figure.run))
        (space_tables::faces(figure.feeder, figure.run, figure.margins))
        (limits(figure.limits))
        (plates(figure.feeder))
        (law_and_input(&law(figure), figure.source))
    };
    Page {
        title: figure.title,
        heading: figure.title,
        styles: &[FIGURE_CSS, REPORT_CSS, SOLID_CSS],
        body,
        script: Some(solid_scene::SCRIPT),
        made_by: figure.made_by,
    }
    .html()
}

/// The tilt against time.
pub(crate) fn chart(shown: &SolidFigure<'_>) -> Markup {
    tilt_chart::section_of(
        shown,
        "The angle from level of the face that was down at the start. Red: strikes, by their numbers.",
    )
}

/// A sentence of a text that may begin with a small letter and have no end.
fn sentence(text: &str) -> String {
    let end = if text.ends_with(['.', '!', '?']) { "" } else { "." };
    format!("{}{end}", capitalised(text))
}

/// The section that opens the report, with all that limits what it claims.
pub(crate) fn verdict(figure: &SpaceFigure<'_>) -> Markup {
    let SpaceFigure { feeder, run, .. } = *figure;
    let headline = run_words::headline_in_space(feeder, run);
    let (class, sign, says) = standing(figure.wanted);
    html! {
        section id="verdict" class={ "verdict " (class) } {
            p.headline {
                strong { (sign) (capitalised(&headline.word)) } " "
                @if let Some(plate) = &headline.plate { "on “" (plate) "”" }
            }
            @if let Some(says) = says { p.as-wanted { (says) } }
            @if !headline.because.is_empty() { p.lead { (sentence(&headline.because)) } }
            @for approximation in figure.approximations {
                p.approximation { strong { "Approximation. " } (sentence(approximation)) }
            }
            (forks(run))
            (notes(&figure.notes.iter().map(|note| sentence(note)).collect::<Vec<_>>()))
            p.note {
                "Computed in space, for a rigid part with Coulomb friction: "
                a href="#model" { "what the model leaves out" } ". Faces go by their numbers: "
                a href="#faces" { "the faces of the part" } "."
            }
            dl.facts { (facts(figure)) }
            @if !run.landings.is_empty() { (landings(feeder, run)) }
        }
    }
}

/// Strikes that could have gone on otherwise.
fn forks(run: &Run) -> Markup {
    html! {
        @if run.forks > 0 {
            p.approximation {
                strong { "Several outcomes. " }
                (run.forks) " of " (run.impacts.len()) @if run.impacts.len() == 1 { " strike" } @else { " strikes" }
                @if run.forks == 1 { " has" } @else { " have" }
                " several consistent outcomes: the one that keeps the most contacts is followed. Another one can lead to another verdict."
            }
        }
    }
}

/// The numbers that matter.
fn facts(figure: &SpaceFigure<'_>) -> Markup {
    let SpaceFigure { feeder, run, .. } = *figure;
    let mut out = vec![];
    match run.final_landing().and_then(|landing| landing.flat) {
        Some(flat) => out.push(fact("flat after", &format!("{} s", fixed(flat, 3)), "from the start")),
        None => out.push(fact("ended after", &format!("{} s", fixed(run.end_time, 3)), "from the start")),
    }
    if let Some(k) = run.deciding_strike() {
        let on = run.struck.get(k).map(|on| part::obstacle(feeder, *on)).unwrap_or_default();
        let speed = run.struck_at.get(k).map_or(f64::NAN, |speed| *speed);
        let which = format!("strike {}, on “{on}”", k + 1);
        out.push(fact("struck at", &format!("{} m/s", fixed(speed, 2)), &which));
        if let Some((impact, change)) = run.impacts.get(k).and_then(|i| Some((i, space_energy_change(i)?))) {
            let energy = |joules: f64| significant(1e3 * joules, 3);
            let more = format!(
                "{} → {} mJ in strike {}",
                energy(impact.kinetic_before),
                energy(impact.kinetic_after),
                k + 1
            );
            out.push(fact("kinetic energy", &format!("{} %", fixed(change, 0)), &more));
        }
    }
    let walls: Vec<String> =
        run.walls_touched.iter().map(|wall| part::obstacle(feeder, feeder.plates.len() + wall)).collect();
    let more = if walls.is_empty() { String::new() } else { format!("touches {}", walls.join(", ")) };
    out.push(fact("strikes", &run.impacts.len().to_string(), &more));
    joined(out)
}

/// Where the part came to lie flat.
fn landings(feeder: &Feeder, run: &Run) -> Markup {
    let row = |landing: &Landing| {
        let here =
            landing.turned_here.map_or("–", |turned| if turned { "another face" } else { "the same face" });
        html! {
            tr {
                th scope="row" { (part::obstacle(feeder, landing.plate)) }
                td { (landing.face.map_or("–".to_owned(), |face| face.to_string())) }
                td { (landing.verdict.map_or("–".to_owned(), run_words::side)) }
                td { (here) }
                td { (fixed(landing.first_touch, 4)) }
                td { (landing.flat.map_or("–".to_owned(), |flat| fixed(flat, 4))) }
                td { (significant(landing.impact_speed, 3)) }
                td { (significant(landing.max_sliding_speed, 3)) }
            }
        }
    };
    let heads = [
        "plate",
        "face that is down",
        "against the start",
        "against the plate before",
        "first touch [s]",
        "flat [s]",
        "struck at [m/s]",
        "fastest slip [m/s]",
    ];
    table("", &heads, run.landings.iter().map(row))
}

/// What the picture shows, and what it leaves out.
pub(crate) fn caption(figure: &SpaceFigure<'_>, scene: &SpaceScene) -> Markup {
    html! {
        p.note {
            "To scale. Thin outlines: the part where stages begin. Red rings: strikes. Blue: the way of the mass centre. The part alone is shown larger, with the numbers of its faces (bold) and corners."
            @if !figure.approximations.is_empty() { " It is drawn as it is computed." }
            @if let Some(end) = scene.ends {
                " After " (fixed(end, 3)) " s the part only falls: the picture ends there."
            }
            @if !scene.far.is_empty() { " Too far away to be shown: " (scene.far.join(", ")) "." }
        }
    }
}

/// The plates and walls as they are computed.
pub(crate) fn plates(feeder: &Feeder) -> Markup {
    let degrees = |angle: f64| format!("{}°", trimmed(angle.to_degrees(), 5));
    let surface = |friction: f64, restitution: f64| {
        html! { td { (trimmed(friction, 4)) } td { (trimmed(restitution, 4)) } }
    };
    let or_none = |length: f64| if length > 0.0 { millimetres(length) } else { "–".to_owned() };
    let plate = |(i, plate): (usize, &Plate)| {
        // What the drawing leaves open has a length in the model, which nobody asked for.
        let length = if plate.unbounded { None } else { Some((plate.edge - plate.uphill).norm()) };
        html! {
            tr {
                th scope="row" { (part::obstacle(feeder, i)) }
                td { (degrees(crate::senses::slope(plate.uphill, plate.edge))) }
                td { (degrees(plate.roll)) }
                td { (length.map_or("as needed".to_owned(), millimetres)) }
                td { (plate.width.map_or("as needed".to_owned(), millimetres)) }
                td { (part::sides(plate, millimetres, degrees)) }
                td { (or_none(plate.edge_radius)) }
                (surface(plate.friction, plate.restitution))
            }
        }
    };
    let wall = |(i, wall): (usize, &Wall)| {
        let needed = || "as needed".to_owned();
        let (length, width, radius) = match wall.form {
            WallForm::Across { from, to, edge_radius } => {
                (millimetres((to - from).norm()), needed(), edge_radius)
            }
            WallForm::Pin { ends: [from, to], radius } => {
                (millimetres((to - from).norm() + 2.0 * radius), millimetres(2.0 * radius), radius)
            }
            WallForm::Beside { .. } => ("without ends".to_owned(), needed(), 0.0),
        };
        html! {
            tr {
                th scope="row" { (part::obstacle(feeder, feeder.plates.len() + i)) }
                td { "–" }
                td { "–" }
                td { (length) }
                td { (width) }
                td { "–" }
                td { (or_none(radius)) }
                (surface(wall.friction, wall.restitution))
            }
        }
    };
    let rows = feeder.plates.iter().enumerate().map(plate).chain(feeder.walls.iter().enumerate().map(wall));
    let heads =
        ["plate", "slope", "roll", "length", "width", "sides", "edge radius", "friction", "restitution"];
    html! { section id="plates" { h2 { "Plates and walls" } (table("small", &heads, rows)) } }
}

/// Sentences on the model and on what went in.
pub(crate) fn law(figure: &SpaceFigure<'_>) -> Vec<String> {
    let SpaceFigure { feeder, run, .. } = *figure;
    let (start, body) = (feeder.start, &feeder.part.body);
    let mut said = vec![
        "Part, plates and walls are rigid: they do not bend, vibrate or dent. Plates and walls have no thickness, but for those with an edge radius. Contacts are points; a strike takes no time.".to_owned(),
        "Friction is dry, after Coulomb: at each plate one coefficient, the same for sticking and sliding and in all directions.".to_owned(),
        format!("Restitution after {}: at each plate one coefficient, whatever the speed.", capitalised(feeder.law.word())),
        "There is no air, no dust and no oil; other parts do not touch this one.".to_owned(),
        "Axes: x to the right, y up, z towards the viewer. Spins are in the axes of the part, impulses in those of the world.".to_owned(),
        format!(
            "The part has {} g. Gravity is {} m/s². The part starts on its face {}, {} before the edge of “{}”{}, at {} m/s.",
            trimmed(1e3 * body.mass(), 5),
            trimmed(feeder.gravity, 6),
            start.face,
            millimetres(start.to_edge),
            part::obstacle(feeder, 0),
            set_down(start.turn, start.aside),
            trimmed(start.speed, 4),
        ),
    ];
    // A face that comes to lie closes a series at each of its corners: what is the same is said once.
    for closing in run.closings.iter().take(20) {
        said.push(format!(
            "From {} s on the strikes follow each other without end; they were closed at their limit, {} s.",
            fixed(closing.time, 5),
            fixed(closing.limit, 5)
        ));
    }
    said.dedup();
    said
}

/// How the part is turned and moved across the plate, where it is.
fn set_down(turn: f64, aside: f64) -> String {
    let turned = (turn != 0.0).then(|| format!(", turned by {}°", trimmed(turn.to_degrees(), 5)));
    let moved = (aside != 0.0).then(|| format!(", {} from its middle", millimetres(aside)));
    [turned, moved].into_iter().flatten().collect()
}
