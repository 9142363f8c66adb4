//! The report: one HTML file that says first what happened, then shows it.

use crate::draft::Draft;
use crate::joint_drawing::JOINT_CSS;
use crate::layout::{layout, millimetres, wall_beside};
use crate::markup::{Markup, html, joined, notes, table, unfolded};
use crate::mechanism::plumb;
use crate::page::Page;
use crate::senses::slopes_text;
use crate::text::{capitalised, fixed, trimmed};
use crate::{FIGURE_CSS, course, part_faces, part_picture, player, stage_table, strikes, verdict};
use carom_feeder::{Feeder, Outcome, PartKind, Plate, Run};
use carom_motion::planar::Shape;
use carom_num::Vec2;
use carom_words::Words;

pub(crate) const REPORT_CSS: &str = include_str!("report.css");

/// How far one quantity may move alone before the verdict flips, in the unit given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct QuantityLimit {
    /// Its path (`plate.lower.slope`).
    pub quantity: String,
    /// Unit of the three numbers; empty for a pure number.
    pub unit: String,
    /// Where it stands.
    pub value: f64,
    /// Below this the verdict flips; `None` where it does not in the range searched.
    pub low: Option<f64>,
    /// Above this the verdict flips.
    pub high: Option<f64>,
    /// Where it does not flip before: below and above this there is no such feeder.
    pub possible: [Option<f64>; 2],
}

/// What a scene wants on a plate.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wish {
    /// Name of the plate.
    pub plate: String,
    /// `same`, `turned` or `face` and its number.
    pub want: String,
    /// Whether the run has it.
    pub met: bool,
}

/// What a report shows beside the run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Extra {
    /// What made the report, with its version (`carom 0.1.0`).
    pub made_by: String,
    /// The scene file as the user wrote it, shown folded.
    pub scene: Option<String>,
    /// How far each quantity may move before the verdict flips.
    pub limits: Vec<QuantityLimit>,
    /// What the scene wants on its plates, and whether the run has it; empty where it wants nothing.
    pub wanted: Vec<Wish>,
    /// Sentences for the reader, such as what was done to an outline.
    pub notes: Vec<String>,
    /// What the scene's author drew and wrote.
    pub draft: Draft,
}

/// One self-contained HTML page on a run: verdict, layout, animation, stages, plots of every stage, strikes, limits of the model, inputs.
///
/// It needs no network and prints. Every name is escaped; a number that is not finite shows as a dash. A run without a trace gets the
/// verdict, the layout and the inputs.
///
/// # Example
/// Of a plate that falls 3 in 4 the slope is atan(3/4) = 36.87°.
/// ```
/// # use carom_feeder::{Feeder, Part, Plate, Start, Stop};
/// # use carom_impact::Law;
/// # use carom_num::Vec2;
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded, form: Default::default() }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::{Extra, report};
/// let page = report(&feeder, &feeder.run().unwrap(), "a & b", &Extra::default());
/// assert!(page.contains("<h1>a &amp; b</h1>") && page.contains("upper</th><td>36.87°</td>"));
/// ```
pub fn report(feeder: &Feeder, run: &Run, title: &str, extra: &Extra) -> String {
    let player = player::section(feeder, run, &extra.draft);
    let script = player.is_some().then_some(player::SCRIPT);
    let body = html! {
        (verdict::section(feeder, run, &extra.wanted))
        (told(run, extra))
        (pictures(feeder, run, &extra.draft, player))
        (limits(&extra.limits))
        (stage_table::section(feeder, run))
        (course::section(feeder, run))
        (strikes::section(feeder, run))
        (model(feeder, run))
        (inputs(feeder, run, extra))
    };
    Page {
        title,
        heading: title,
        styles: &[FIGURE_CSS, JOINT_CSS, REPORT_CSS],
        body,
        script,
        made_by: &extra.made_by,
    }
    .html()
}

pub(crate) fn told(run: &Run, extra: &Extra) -> Markup {
    let nothing = run.stages.is_empty() && run.trace.pieces.is_empty();
    let why = if run.outcome == Outcome::Stuck { "Nothing moved" } else { "The run kept no trace" };
    html! {
        (notes(&extra.notes))
        @if nothing { p.note { (why) ": there are no stages, plots or strikes to show." } }
    }
}

pub(crate) fn limits(limits: &[QuantityLimit]) -> Markup {
    if limits.is_empty() {
        return html! {};
    }
    let row = |l: &QuantityLimit| {
        let gap = if l.unit.is_empty() || l.unit == "°" { "" } else { " " };
        let number = |x: f64| format!("{}{gap}{}", trimmed(x, 4), l.unit);
        let edge = |flips: Option<f64>, possible: Option<f64>| {
            let possible = possible.map(|x| format!("({})", number(x)));
            flips.map(number).or(possible).unwrap_or("–".to_owned())
        };
        let [lowest, highest] = l.possible;
        html! {
            tr {
                th scope="row" { (l.quantity) }
                td { (edge(l.low, lowest)) }
                td { (number(l.value)) }
                td { (edge(l.high, highest)) }
            }
        }
    };
    html! {
        section id="limits" {
            h2 { "How far it may move" }
            (table("", &["quantity", "flips below", "now", "flips above"], limits.iter().map(row)))
            p.note {
                "Each quantity alone, all others as they are. In parentheses: the verdict does not flip, but beyond this value there is no such feeder. A dash: it does not flip in the range searched, from a thousandth of the value to 128 times it."
            }
        }
    }
}

/// Layout and animation side by side where there is room, and the table of plates under them.
fn pictures(feeder: &Feeder, run: &Run, draft: &Draft, player: Option<Markup>) -> Markup {
    html! {
        div.pictures { (layout_section(feeder, run, draft)) @if let Some(player) = player { (player) } }
        (part_picture::figure(feeder, Some(run), draft))
        (part_faces::section(&feeder.part.body.shape))
        (plates(feeder, draft))
    }
}

fn layout_section(feeder: &Feeder, run: &Run, draft: &Draft) -> Markup {
    html! {
        section id="layout" {
            h2 { "Layout" }
            figure {
                (layout(feeder, Some(run), draft, false))
                @if run.trace.pieces.is_empty() {
                    figcaption { "To scale. The part as it starts; its coloured side is down." }
                } @else {
                    figcaption {
                        "To scale. Numbers: where the stages of the table begin. The coloured side of the part was down at the start. "
                        (legend(run))
                    }
                }
            }
        }
    }
}

/// The colours of the stages that there are.
fn legend(run: &Run) -> Markup {
    let mut names: Vec<&str> = vec![];
    for stage in &run.stages {
        if !names.contains(&stage.name.word()) {
            names.push(stage.name.word());
        }
    }
    if !run.trace.impacts.is_empty() {
        names.push("strike");
    }
    html! {
        span.legend {
            @for (i, name) in names.iter().enumerate() {
                @if i > 0 { " " }
                i class={ "key " (name) } {}
                (name)
            }
        }
    }
}

fn plates(feeder: &Feeder, draft: &Draft) -> Markup {
    let said = !draft.measures.is_empty();
    let row = |(i, p): (usize, &Plate)| {
        let own = draft.measures.iter().filter(|measure| measure.plate == Some(i));
        let own: Vec<String> = own.map(|m| format!("{} {}", m.name, m.text)).collect();
        let length = if p.unbounded { "as needed".to_owned() } else { millimetres(p.length()) };
        let drop = feeder
            .plates
            .get(i + 1)
            .and_then(|_| plumb(feeder, i + 1, p.edge))
            .map_or("–".to_owned(), |foot| millimetres(p.edge.y - foot.y));
        let gap = wall_beside(feeder, i).map_or("–".to_owned(), |side| millimetres((side - p.edge).norm()));
        html! {
            tr {
                th scope="row" { (p.name) }
                @if said { td.words { (own.join(", ")) } }
                td { (slopes_text(p, 2)) }
                td { (length) }
                td { (drop) }
                td { (gap) }
                td { (trimmed(p.friction, 4)) }
                td { (trimmed(p.restitution, 4)) }
            }
        }
    };
    html! {
        div.wide tabindex="0" {
            table.small.plates {
                thead {
                    tr {
                        th { "plate" }
                        @if said { th.words { "as the scene has it" } }
                        th { "slope" }
                        th { "length" }
                        th { "plumb drop to the next, from edge to plate" }
                        th { "edge to wall" }
                        th { "friction" }
                        th { "restitution" }
                    }
                }
                tbody { (joined(feeder.plates.iter().enumerate().map(row))) }
            }
        }
    }
}

pub(crate) fn model(feeder: &Feeder, run: &Run) -> Markup {
    // A face that comes to lie closes a series at each of its ends: one sentence says both, where it would be the same.
    let told = |(from, to): &(f64, f64)| [fixed(*from, 5), fixed(*to, 5)];
    let mut closed: Vec<[String; 2]> = run.trace.accumulations.iter().map(told).collect();
    closed.dedup();
    html! {
        section id="model" {
            h2 { "What the model leaves out" }
            ul {
                li {
                    "Plane motion: the groove in the plates keeps the part in one plane; what happens across it is not computed."
                }
                li {
                    "Rigid part and plates: no bending, no vibration, no dent. Contacts are points; a strike takes no time."
                }
                li { "Dry friction after Coulomb, one coefficient for sticking and sliding at each plate." }
                li {
                    "Restitution after " (capitalised(feeder.law.word()))
                    ", one coefficient at each plate whatever the speed."
                }
                li { "No air, no dust, no oil; other parts do not touch this one." }
            }
            @for [from, to] in closed.into_iter().take(20) {
                p.note {
                    "From " (from)
                    " s on the strikes follow each other without end; they were closed at their limit, "
                    (to) " s."
                }
            }
        }
    }
}

/// The largest distance of two points of a shape \[m\].
fn diameter(shape: &Shape) -> f64 {
    let shape = shape.hull();
    let corners = shape.vertices();
    let from = |a: &Vec2| corners.iter().map(|b| (*b - *a).norm()).fold(0.0, f64::max);
    corners.iter().map(from).fold(0.0, f64::max) + 2.0 * shape.radius()
}

fn inputs(feeder: &Feeder, run: &Run, extra: &Extra) -> Markup {
    let part = &feeder.part;
    let kind = match part.kind {
        PartKind::Rod => "thin rod",
        PartKind::Box => "box",
        PartKind::Polygon => "polygon",
        PartKind::Disc => "disc",
    };
    let effort = run.effort;
    let done = format!(
        "{} evaluations, {} events, {} strikes",
        effort.rhs_evaluations, effort.events, effort.impacts
    );
    let lines = [
        ("part", format!("{kind}, {} across", millimetres(diameter(&part.body.shape)))),
        ("mass", format!("{} g", trimmed(1e3 * part.body.mass, 5))),
        ("moment of inertia", format!("{} kg m²", trimmed(part.body.inertia, 5))),
        ("gravity", format!("{} m/s²", trimmed(feeder.gravity, 6))),
        ("starts before the edge", millimetres(feeder.start.to_edge)),
        ("starting speed", format!("{} m/s", trimmed(feeder.start.speed, 4))),
        ("law of restitution", feeder.law.word().to_owned()),
        ("work", done),
    ];
    html! {
        section id="inputs" {
            h2 { "Input" }
            dl.inputs { @for (label, value) in lines { div { dt { (label) } dd { (value) } } } }
            @if let Some(scene) = &extra.scene { (unfolded("The scene as written", scene)) }
        }
    }
}
