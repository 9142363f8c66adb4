//! The page of a yield study: how surely drops end as wanted, how else, at what speeds, and which tolerance decides.

use crate::FIGURE_CSS;
use crate::bars::{Bar, bars, enlarged};
use crate::histogram::Measure;
use crate::markup::{Markup, fact, html, joined};
use crate::page::Page;
use crate::report::REPORT_CSS;
use crate::text::{capitalised, fixed, percent, significant};
use crate::yield_tables::{inputs, laws, transitions, worst};
use carom_impact::Law;
use carom_study::Ending;
use carom_study::yields::{Estimate, PlateSpread, Sensitivity, Spread, Yield};
use carom_words::study;

pub(crate) const YIELD_CSS: &str = include_str!("yield.css");
/// Above this share nobody says one in so many.
const OFTEN: f64 = 0.2;
/// Below this share endings get a second picture, in which they can be seen.
const RARE: f64 = 0.02;

/// A quantity that varies.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct YieldQuantity {
    /// Its path.
    pub path: String,
    /// Its middle, with unit.
    pub middle: String,
    /// How it varies: `± 0.5 deg`.
    pub tolerance: String,
}

/// A drop to look at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct YieldWorst {
    /// How it ends.
    pub ending: String,
    /// Why it is here.
    pub why: String,
    /// Largest speed of a first strike on the plates that the part comes to lie on [m/s]; `None` where it comes to lie on none but the one it
    /// starts on.
    pub impact_speed: Option<f64>,
    /// The command that replays it.
    pub command: String,
    /// The values of the quantities that vary, with units, in their order.
    pub values: Vec<String>,
}

/// What the page of a yield study shows.
#[derive(Clone, Copy, Debug)]
pub struct YieldFigure<'a> {
    /// Heading of the page.
    pub title: &'a str,
    /// How the part moves: `plane motion`.
    pub motion: &'a str,
    /// What is wanted, in words.
    pub wanted: &'a str,
    /// Whether the scene's design has limits that are kept or not: then the share within them is shown as well.
    pub limited: bool,
    /// The plate whose endings are told apart.
    pub plate: &'a str,
    /// Names of the plates.
    pub plates: &'a [String],
    /// What was found.
    pub found: &'a Yield,
    /// Which quantity decides, the largest first; or why that is not known.
    pub deciders: Result<&'a [(String, Sensitivity)], &'a str>,
    /// How the drop of the middle of all tolerances ends under a law, with a restitution: in the order of laws.
    pub laws: &'a [(Law, f64, Ending)],
    /// How it ends as it is drawn.
    pub drawn: Ending,
    /// The law it is drawn with.
    pub law: Law,
    /// What varies.
    pub quantities: &'a [YieldQuantity],
    /// Drops to look at.
    pub worst: &'a [YieldWorst],
    /// How it was sampled, in sentences.
    pub notes: &'a [String],
    /// True on a page that can open a drop itself: then it has a button in place of the command.
    pub live: bool,
    /// The scene as written.
    pub source: &'a str,
    /// What made the page, with its version.
    pub made_by: &'a str,
}

/// One self-contained HTML page on a yield study; as the report of a run, it needs no network.
///
/// # Example
/// Why it is not known what decides is said.
/// ```
/// # use carom_figure::{YieldFigure, YieldQuantity, YieldWorst, yield_report};
/// # use carom_impact::Law;
/// # use carom_study::{Ending, yields::{Estimate, Yield}};
/// # let share = Estimate { share: 0.75, low: 0.65, high: 0.83, count: 75 };
/// # let found = Yield {
/// #     wanted: share, kept: share, endings: vec![], transitions: vec![], recirculation: None, plates: vec![], time: None,
/// #     worst: vec![], drops: 100,
/// # };
/// # let figure = YieldFigure {
/// #     title: "a feeder", motion: "plane motion", wanted: "turned", limited: false, plate: "lower", plates: &[], found: &found,
/// #     deciders: Err("not asked"), laws: &[], drawn: Ending::Stays, law: Law::Poisson, quantities: &[],
/// #     worst: &[], notes: &[], live: false, source: "", made_by: "",
/// # };
/// let page = yield_report(&YieldFigure { deciders: Err("no drop failed"), ..figure });
/// assert!(page.contains("<h1>a feeder: how surely</h1>") && page.contains("Not known: no drop failed."));
/// ```
pub fn yield_report(figure: &YieldFigure<'_>) -> String {
    let body = yield_body(figure);
    Page {
        title: &format!("{}: yield", figure.title),
        heading: &format!("{}: how surely", figure.title),
        styles: &[FIGURE_CSS, REPORT_CSS, YIELD_CSS],
        body,
        script: None,
        made_by: figure.made_by,
    }
    .html()
}

/// The page's sections without their frame, for a page that stays open.
pub fn live_yield(figure: &YieldFigure<'_>) -> String {
    yield_body(figure).into_string()
}

fn yield_body(figure: &YieldFigure<'_>) -> Markup {
    html! {
        (verdict(figure))
        (endings(figure))
        (deciders(figure))
        (worst(figure))
        (transitions(figure))
        (distributions(figure))
        (laws(figure))
        (inputs(figure))
    }
}

/// `1 in 32`, of a share that is not zero; in percent where that says less.
fn one_in(share: f64) -> String {
    if share > OFTEN {
        return format!("{} %", percent(share));
    }
    format!("1 in {}", significant(1.0 / share, if share > 0.01 { 2 } else { 3 }))
}

fn verdict(figure: &YieldFigure<'_>) -> Markup {
    let (found, kept) = (&figure.found.wanted, &figure.found.kept);
    html! {
        section.verdict {
            p.headline { strong { (percent(found.share)) " %" } " end as wanted" }
            p.lead {
                (capitalised(figure.wanted)) ". The share of all parts is between " (percent(found.low))
                " and " (percent(found.high)) " %, with 95 % confidence."
            }
            @if figure.limited {
                p.lead {
                    b { (percent(kept.share)) " %" }
                    " end as wanted within the limits of [design] ("
                    (percent(kept.low)) " to " (percent(kept.high)) " %)."
                }
            }
            @if found.count == 0 || (figure.limited && kept.count == 0) {
                p.note.warn {
                    "No drop does: " code { "carom design" }
                    " looks for a layout whose drops do, within what [design] leaves free."
                }
            }
            p.note {
                "Computed for a rigid part in " (figure.motion)
                " with Coulomb friction, one part at a time, with the tolerances that the scene writes: "
                a href="#inputs" { "what varies, and how it was sampled" } "."
            }
            dl.facts { (facts(figure)) }
        }
    }
}

/// The numbers that matter.
fn facts(figure: &YieldFigure<'_>) -> Markup {
    let found = figure.found;
    let mut out = vec![otherwise(&found.wanted, found.drops)];
    if let Some(time) = &found.time {
        let more = format!("one at a time: {} s each on average", fixed(time.mean, 3));
        out.push(fact("parts a minute", &fixed(60.0 / time.mean, 1), &more));
    }
    let hard = found.plates.iter().filter_map(|plate| plate.impact_speed.as_ref());
    if let Some(hardest) = hard.max_by(|a, b| a.high.total_cmp(&b.high)) {
        let more = format!(
            "the hardest first strike on a plate that the part comes to lie on; 99 % are below {} m/s",
            significant(hardest.p99, 4)
        );
        out.push(fact("struck at up to", &format!("{} m/s", significant(hardest.high, 4)), &more));
    }
    // An estimate of a share can lie outside of 0 to 1; as a share of the variance it cannot be told so.
    if let Ok([(path, first), ..]) = figure.deciders {
        let more = format!(
            "{} % of the variance alone, {} % with others",
            fixed(100.0 * first.first.clamp(0.0, 1.0), 0),
            fixed(100.0 * first.total.clamp(0.0, 1.0), 0)
        );
        out.push(fact("decides most", path, &more));
    }
    joined(out)
}

/// How many do not end as wanted.
fn otherwise(found: &Estimate, drops: u64) -> Markup {
    let (share, low, high) = (1.0 - found.share, 1.0 - found.high, 1.0 - found.low);
    if found.count == drops {
        return fact("end otherwise", &format!("none of {drops}"), &format!("at most {}", one_in(high)));
    }
    // One in few is more than one in many: the order is that of the numbers.
    let more = if low > OFTEN {
        format!("{} to {}", one_in(low), one_in(high))
    } else if low > 0.0 {
        format!("{} to {}", one_in(high), one_in(low))
    } else {
        format!("at most {}", one_in(high))
    };
    fact("end otherwise", &one_in(share), &more)
}

/// Class and words of an ending: every drop that ends so may be as wanted, or none, or some where other plates have a say.
fn as_wanted(found: &Yield, ending: Ending, estimate: &Estimate) -> (&'static str, &'static str) {
    match found.worst.iter().find(|worst| !worst.hardest && worst.ending == ending) {
        None => ("wanted", "as wanted"),
        Some(worst) if worst.among == estimate.count => ("unwanted", "not as wanted"),
        Some(_) => ("partly", "partly as wanted"),
    }
}

/// What the colours of the bars say.
fn legend(found: &Yield) -> Markup {
    let mut known: Vec<_> =
        found.endings.iter().map(|(ending, estimate)| as_wanted(found, *ending, estimate)).collect();
    known.sort_unstable();
    known.dedup();
    html! {
        p.note {
            @for (class, words) in known.into_iter().rev() {
                span.legend { span class={ "key " (class) } {} (words) } " "
            }
        }
    }
}

/// How drops end, as bars; the rare endings once more, enlarged.
fn endings(figure: &YieldFigure<'_>) -> Markup {
    let bar = |(ending, estimate): &(Ending, Estimate)| Bar {
        class: as_wanted(figure.found, *ending, estimate).0,
        name: study::ending(*ending),
        ..Bar::of(estimate, "drops")
    };
    let found = &figure.found.endings;
    let all: Vec<Bar> = found.iter().map(bar).collect();
    let rare: Vec<Bar> = found.iter().filter(|(_, e)| e.high < RARE).map(bar).collect();
    let most = found.iter().map(|(_, e)| e.high).filter(|high| *high < RARE).fold(0.0, f64::max);
    html! {
        section id="endings" {
            h2 { "How drops end on “" (figure.plate) "”" }
            (legend(figure.found))
            (bars(&all, 1.0))
            @if !rare.is_empty() && most > 0.0 { (enlarged("The rare ones, enlarged", &rare, most, 2)) }
            p.note { "Bars: the share of the drops. Brackets: the 95 % interval of the share of all parts." }
        }
    }
}

/// Which tolerance decides.
fn deciders(figure: &YieldFigure<'_>) -> Markup {
    let bar = |(path, found): &(String, Sensitivity)| {
        let tolerance = figure.quantities.iter().find(|quantity| quantity.path == *path);
        Bar {
            name: match tolerance {
                Some(quantity) => format!("{path}  {} {}", quantity.middle, quantity.tolerance),
                None => path.clone(),
            },
            share: found.first.max(0.0),
            behind: Some(found.total.max(0.0)),
            interval: Some([found.first - found.first_error, found.first + found.first_error]),
            behind_interval: Some([found.total - found.total_error, found.total + found.total_error]),
            numbers: format!(
                "{} ± {} alone, {} ± {} with others",
                fixed(found.first, 2),
                fixed(found.first_error, 2),
                fixed(found.total, 2),
                fixed(found.total_error, 2)
            ),
            ..Bar::default()
        }
    };
    html! {
        section id="deciders" {
            h2 { "Which tolerance decides" }
            @match figure.deciders {
                Err(why) => { p { "Not known: " (why) "." } },
                Ok(ranked) => {
                    (bars(&ranked.iter().map(bar).collect::<Vec<_>>(), 1.0))
                    p.note {
                        "Sobol’s indices: what share of the variance of " i { "ends as wanted or not" }
                        " a quantity explains by itself (strong), and together with others (faint); brackets: 95 % intervals, the upper ones of what it explains by itself. An estimate below zero is no more than chance. To make drops surer, narrow the tolerance at the top or move its middle."
                    }
                },
            }
        }
    }
}

/// Speeds and times on each plate, and when all is over.
fn distributions(figure: &YieldFigure<'_>) -> Markup {
    let measure = |name, unit, spread: Option<&Spread>| Measure { name, unit, spread: spread? }.figure();
    let of_plate = |(name, plate): (&String, &PlateSpread)| {
        let plots = [
            measure("impact speed", "m/s", plate.impact_speed.as_ref()),
            measure("fastest slip", "m/s", plate.sliding_speed.as_ref()),
            measure("lies flat after", "s", plate.flat.as_ref()),
        ];
        let plots: Vec<Markup> = plots.into_iter().flatten().collect();
        (!plots.is_empty()).then(|| html! { h3 { "On “" (name) "”" } div.plots { (joined(plots)) } })
    };
    let mut out: Vec<Markup> = figure.plates.iter().zip(&figure.found.plates).filter_map(of_plate).collect();
    if let Some(plot) = measure("time from start to end", "s", figure.found.time.as_ref()) {
        out.push(html! { h3 { "Drops that end as wanted" } div.plots { (plot) } });
    }
    if out.is_empty() {
        return html! {};
    }
    html! {
        section id="distributions" {
            h2 { "Speeds and times" }
            p.note {
                "Of the drops that come to lie on the plate. Impact speed is that of the striking point at the first strike. Shaded: 5 to 95 % of the drops; line: the median."
            }
            (joined(out))
        }
    }
}
