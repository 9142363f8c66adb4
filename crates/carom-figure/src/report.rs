//! The report: one HTML file that says first what happened, then shows it.

use crate::draft::Draft;
use crate::joint_drawing::JOINT_CSS;
use crate::layout::{layout, millimetres, wall_beside};
use crate::mechanism::plumb;
use crate::page::Page;
use crate::text::{capitalised, escape, fixed, trimmed};
use crate::words::slope;
use crate::{FIGURE_CSS, course, part_picture, player, stage_table, strikes, verdict};
use carom_feeder::{Feeder, Outcome, PartKind, Run};
use carom_motion::planar::Shape;
use carom_num::Vec2;

pub(crate) const REPORT_CSS: &str = include_str!("report.css");

/// How far one quantity may move alone before the verdict flips, in the unit given.
///
/// # Example
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::{Extra, QuantityLimit, report};
/// let limits = vec![QuantityLimit {
///     quantity: "plate.upper.slope".to_owned(), unit: "°".to_owned(),
///     value: 25.0, low: Some(21.3), high: None,
/// }];
/// let page = report(&feeder, &feeder.run().unwrap(), "", &Extra { limits, ..Extra::default() });
/// assert!(page.contains("plate.upper.slope</th><td>21.3°</td><td>25°</td><td>–</td>"));
/// ```
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
}

/// What a scene wants on a plate.
///
/// # Example
/// A verdict is green with a tick where it is as wanted, red with a cross where it is not.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::{Extra, Wish, report};
/// let wanted = vec![Wish { plate: "lower".to_owned(), want: "turned".to_owned(), met: false }];
/// let page = report(&feeder, &feeder.run().unwrap(), "", &Extra { wanted, ..Extra::default() });
/// assert!(page.contains("Not as wanted: turned on “lower”"));
/// ```
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
///
/// # Example
/// The scene is shown as it was written, but for the characters that HTML reserves.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::{Extra, report};
/// let extra = Extra { scene: Some("friction = 0.5 # < 1".to_owned()), ..Extra::default() };
/// let page = report(&feeder, &feeder.run().unwrap(), "", &extra);
/// assert!(page.contains("<pre>friction = 0.5 # &lt; 1</pre>"));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Extra {
    /// What made the report, with its version (`carom 0.1.0`).
    pub made_by: String,
    /// The scene file as the user wrote it, shown folded.
    pub scene: Option<String>,
    /// How far each quantity may move before the verdict flips.
    pub limits: Vec<QuantityLimit>,
    /// What stands above the verdict: that the part computed is not the part drawn. In sentences without a full stop.
    pub warnings: Vec<String>,
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
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::{Extra, report};
/// let page = report(&feeder, &feeder.run().unwrap(), "a & b", &Extra::default());
/// assert!(page.contains("<h1>a &amp; b</h1>") && page.contains("upper</th><td>36.87°</td>"));
/// ```
pub fn report(feeder: &Feeder, run: &Run, title: &str, extra: &Extra) -> String {
    let body = [
        verdict::section(feeder, run, &extra.wanted),
        notes(run, extra),
        pictures(feeder, run, &extra.draft),
        limits(&extra.limits),
        stage_table::section(feeder, run),
        course::section(feeder, run),
        strikes::section(feeder, run),
        model(feeder, run, &extra.warnings),
        inputs(feeder, run, extra),
    ]
    .concat();
    let script = if body.contains("id=\"player\"") { player::script() } else { String::new() };
    Page {
        title,
        heading: title,
        warnings: &extra.warnings,
        styles: &[FIGURE_CSS, JOINT_CSS, REPORT_CSS],
        body: &body,
        script: &script,
        made_by: &extra.made_by,
    }
    .html()
}

fn notes(run: &Run, extra: &Extra) -> String {
    let mut out: String =
        extra.notes.iter().map(|n| format!("<p class=\"note\">{}</p>", escape(n))).collect();
    if run.stages.is_empty() && run.trace.pieces.is_empty() {
        let why = if run.outcome == Outcome::Stuck { "Nothing moved" } else { "The run kept no trace" };
        out += &format!("<p class=\"note\">{why}: there are no stages, plots or strikes to show.</p>");
    }
    out
}

fn limits(limits: &[QuantityLimit]) -> String {
    if limits.is_empty() {
        return String::new();
    }
    let mut out = String::from(
        "<section id=\"limits\"><h2>How far it may move</h2><div class=\"wide\"><table><thead><tr><th>quantity</th><th>flips below</th><th>now</th><th>flips above</th></tr></thead><tbody>",
    );
    for l in limits {
        let gap = if l.unit.is_empty() || l.unit == "°" { "" } else { " " };
        let number = |x: f64| format!("{}{gap}{}", trimmed(x, 4), escape(&l.unit));
        let edge = |x: Option<f64>| x.map_or("–".to_owned(), number);
        out += &format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>",
            escape(&l.quantity),
            edge(l.low),
            number(l.value),
            edge(l.high)
        );
    }
    out + "</tbody></table></div><p class=\"note\">Each quantity alone, all others as they are. A dash: the verdict does not flip in the range searched.</p></section>"
}

/// Layout and animation side by side where there is room, and the table of plates under them.
fn pictures(feeder: &Feeder, run: &Run, draft: &Draft) -> String {
    let (layout, player) = (layout_section(feeder, run, draft), player::section(feeder, run, draft));
    let part = part_picture::figure(feeder, Some(run), draft);
    format!("<div class=\"pictures\">{layout}{player}</div>{part}{}", plates(feeder, draft))
}

fn layout_section(feeder: &Feeder, run: &Run, draft: &Draft) -> String {
    let picture = layout(feeder, Some(run), draft, false);
    let mut out = format!("<section id=\"layout\"><h2>Layout</h2><figure>{picture}");
    if run.trace.pieces.is_empty() {
        out +=
            "<figcaption>To scale. The part as it starts; its coloured side is down.</figcaption></figure>";
    } else {
        out += &format!(
            "<figcaption>To scale. Numbers: where the stages of the table begin. The coloured side of the part was down at the start. {}</figcaption></figure>",
            legend(run)
        );
    }
    out + "</section>"
}

/// The colours of the stages that there are.
fn legend(run: &Run) -> String {
    let mut names: Vec<&str> = vec![];
    for stage in &run.stages {
        if !names.contains(&stage.name.word()) {
            names.push(stage.name.word());
        }
    }
    if !run.trace.impacts.is_empty() {
        names.push("strike");
    }
    let keys: Vec<String> = names.iter().map(|name| format!("<i class=\"key {name}\"></i>{name}")).collect();
    format!("<span class=\"legend\">{}</span>", keys.join(" "))
}

fn plates(feeder: &Feeder, draft: &Draft) -> String {
    let said = if draft.measures.is_empty() { "" } else { "<th class=\"words\">as the scene has it</th>" };
    let mut out = format!(
        "<div class=\"wide\"><table class=\"small plates\"><thead><tr><th>plate</th>{said}<th>slope</th><th>length</th><th>plumb drop to the next, from edge to plate</th><th>edge to wall</th><th>friction</th><th>restitution</th></tr></thead><tbody>",
    );
    for (i, p) in feeder.plates.iter().enumerate() {
        let own = draft.measures.iter().filter(|measure| measure.plate == Some(i));
        let own: Vec<String> = own.map(|m| format!("{} {}", m.name, m.text)).collect();
        let own = match said {
            "" => String::new(),
            _ => format!("<td class=\"words\">{}</td>", escape(&own.join(", "))),
        };
        let length =
            if p.unbounded { "as needed".to_owned() } else { millimetres((p.edge - p.uphill).norm()) };
        let drop = feeder
            .plates
            .get(i + 1)
            .and_then(|next| plumb(p.edge, next.uphill, next.edge))
            .map_or("–".to_owned(), |foot| millimetres(p.edge.y - foot.y));
        let gap = wall_beside(feeder, i).map_or("–".to_owned(), |side| millimetres((side - p.edge).norm()));
        out += &format!(
            "<tr><th scope=\"row\">{}</th>{own}<td>{}°</td><td>{length}</td><td>{drop}</td><td>{gap}</td><td>{}</td><td>{}</td></tr>",
            escape(&p.name),
            fixed(slope(p.uphill, p.edge).to_degrees(), 2),
            trimmed(p.friction, 4),
            trimmed(p.restitution, 4)
        );
    }
    out + "</tbody></table></div>"
}

fn model(feeder: &Feeder, run: &Run, warnings: &[String]) -> String {
    let warned: String = warnings.iter().map(|w| format!("<li>{}.</li>", escape(&capitalised(w)))).collect();
    let mut out = format!(
        "<section id=\"model\"><h2>What the model leaves out</h2><ul>{warned}<li>Plane motion: the groove in the plates keeps the part in one plane; what happens across it is not computed.</li><li>Rigid part and plates: no bending, no vibration, no dent. Contacts are points; a strike takes no time.</li><li>Dry friction after Coulomb, one coefficient for sticking and sliding at each plate.</li><li>Restitution after {}, one coefficient at each plate whatever the speed.</li><li>No air, no dust, no oil; other parts do not touch this one.</li></ul>",
        match feeder.law {
            carom_impact::planar::Law::Poisson => "Poisson",
            carom_impact::planar::Law::Stronge => "Stronge",
            carom_impact::planar::Law::Newton => "Newton",
        }
    );
    // A face that comes to lie closes a series at each of its ends: one sentence says both.
    let mut closed: Vec<_> = run.trace.accumulations.iter().collect();
    closed.dedup();
    for (from, to) in closed.into_iter().take(20) {
        out += &format!(
            "<p class=\"note\">From {} s on the strikes follow each other without end; they were closed at their limit, {} s.</p>",
            fixed(*from, 5),
            fixed(*to, 5)
        );
    }
    out + "</section>"
}

/// The largest distance of two points of a shape \[m\].
fn diameter(shape: &Shape) -> f64 {
    let corners = shape.vertices();
    let from = |a: &Vec2| corners.iter().map(|b| (*b - *a).norm()).fold(0.0, f64::max);
    corners.iter().map(from).fold(0.0, f64::max) + 2.0 * shape.radius()
}

fn inputs(feeder: &Feeder, run: &Run, extra: &Extra) -> String {
    let part = &feeder.part;
    let kind = match part.kind {
        PartKind::Rod => "thin rod",
        PartKind::Box => "box",
        PartKind::Polygon => "polygon",
        PartKind::Disc => "disc",
    };
    let line = |label: &str, value: String| format!("<div><dt>{label}</dt><dd>{}</dd></div>", escape(&value));
    let mut out = String::from("<section id=\"inputs\"><h2>Input</h2><dl class=\"inputs\">");
    out += &line("part", format!("{kind}, {} across", millimetres(diameter(&part.body.shape))));
    out += &line("mass", format!("{} g", trimmed(1e3 * part.body.mass, 5)));
    out += &line("moment of inertia", format!("{} kg m²", trimmed(part.body.inertia, 5)));
    out += &line("gravity", format!("{} m/s²", trimmed(feeder.gravity, 6)));
    out += &line("starts before the edge", millimetres(feeder.start.to_edge));
    out += &line("starting speed", format!("{} m/s", trimmed(feeder.start.speed, 4)));
    out += &line("law of restitution", feeder.law.to_string());
    let work = run.work;
    out += &line(
        "work",
        format!("{} evaluations, {} events, {} strikes", work.rhs_evaluations, work.events, work.impacts),
    );
    out += "</dl>";
    if let Some(scene) = &extra.scene {
        out += &format!(
            "<details><summary>The scene as written</summary><pre>{}</pre></details>",
            escape(scene)
        );
    }
    out + "</section>"
}
