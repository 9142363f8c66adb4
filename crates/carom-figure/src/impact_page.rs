//! The report of one impact: what its contacts do, the walk, what other conventions say, and what rejects the other ends.

use crate::impact_sketch::{ImpactSketch, sketch};
use crate::impulse::ImpulsePlane;
use crate::impulse_drawing::drawing;
use crate::joint::JointWalk;
use crate::joint_drawing::{JOINT_CSS, joint_drawing};
use crate::markup::{Markup, html, notes, table};
use crate::page::{Page, as_written};
use crate::report::REPORT_CSS;
use crate::roll::RollContact;
use crate::text::significant;
use crate::{FIGURE_CSS, text};

/// Digits of a number in a table.
const DIGITS: usize = 6;
/// Hypotheses that are listed; six contacts have thousands.
const MOST_REJECTED: usize = 400;
/// What the page of an impact has beside the style of reports.
const IMPACT_CSS: &str = include_str!("impact.css");

/// A body after an impact.
///
/// # Example
/// ```
/// use carom_figure::{ImpactFigure, ImpactedBody, RollContact, impact_report};
/// let ball = ImpactedBody { name: "ball".to_owned(), velocity: [1.5, -2.0], spin: 3.0 };
/// let contacts = vec![RollContact::default()];
/// let page = impact_report(&ImpactFigure { bodies: vec![ball], contacts, ..ImpactFigure::default() });
/// assert!(page.contains("ball</th><td>1.50000</td><td>−2.00000</td><td>3.00000</td>"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactedBody {
    /// Its name.
    pub name: String,
    /// Velocity of its mass centre [m/s].
    pub velocity: [f64; 2],
    /// Spin, counter-clockwise [rad/s].
    pub spin: f64,
}

/// What one convention on sharing says.
///
/// # Example
/// ```
/// use carom_figure::{ImpactFigure, ImpactShared, impact_report};
/// let said = "the last ball leaves".to_owned();
/// let shared = vec![ImpactShared { name: "in sequence".to_owned(), verdict: "differs".to_owned(), said }];
/// let page = impact_report(&ImpactFigure { shared, ..ImpactFigure::default() });
/// assert!(page.contains("in sequence</th><td>differs</td><td class=\"words\">the last ball leaves</td>"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactShared {
    /// Its name.
    pub name: String,
    /// What it says of the answer: agrees, differs, does not apply or no answer.
    pub verdict: String,
    /// Where it ends, or why it has no answer.
    pub said: String,
}

/// The walk in impulse space.
#[derive(Clone, Debug, PartialEq)]
pub enum ImpactPicture {
    /// Several contacts.
    Walk(JointWalk),
    /// One contact.
    Plane(ImpulsePlane),
}

/// What the report of an impact shows.
///
/// # Example
/// A ball that rises with half of its speed has a quarter of its energy.
/// ```
/// use carom_figure::{ImpactFigure, RollContact, impact_report};
/// let contacts = vec![RollContact { name: "floor".to_owned(), ..RollContact::default() }];
/// let figure = ImpactFigure { contacts, energy: Some([2.0, 0.5]), ..ImpactFigure::default() };
/// assert!(impact_report(&figure).contains("Kinetic energy 2.00000 → 0.500000 J."));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImpactFigure {
    /// Heading of the page.
    pub title: String,
    /// What happens, in a few words.
    pub verdict: String,
    /// The sentence below it: end states and law.
    pub lead: String,
    /// Sentences that must not be missed: what was not examined.
    pub notes: Vec<String>,
    /// The contacts at the end.
    pub contacts: Vec<RollContact>,
    /// The bodies after; empty where only the operator is known.
    pub bodies: Vec<ImpactedBody>,
    /// Kinetic energy before and after [J].
    pub energy: Option<[f64; 2]>,
    /// The body before the impact, where it is a free one in the plane.
    pub sketch: Option<ImpactSketch>,
    /// The walk.
    pub picture: Option<ImpactPicture>,
    /// What other conventions on sharing say.
    pub shared: Vec<ImpactShared>,
    /// The end states that were found, or the ways on at the stages.
    pub found: Vec<String>,
    /// How many stages the hypotheses are of, where they are ways on at stages and not end states.
    pub stages: Option<usize>,
    /// The other hypotheses, each with what rejects it; `None` where they were not examined.
    pub rejected: Option<Vec<[String; 2]>>,
    /// Rejected hypotheses beyond these.
    pub left_out: usize,
    /// The file as written.
    pub source: String,
    /// What made the report, with its version.
    pub made_by: String,
}

/// One self-contained HTML page on an impact.
///
/// It needs no network and prints. Every name is escaped; a number that is not finite shows as a dash.
///
/// # Example
/// Names are escaped, and ends are counted.
/// ```
/// use carom_figure::{ImpactFigure, impact_report};
/// let figure = ImpactFigure {
///     title: "a & b".to_owned(),
///     found: vec!["it sticks".to_owned()],
///     rejected: Some(vec![["it slips".to_owned(), "too rough".to_owned()]]),
///     ..ImpactFigure::default()
/// };
/// let page = impact_report(&figure);
/// assert!(page.contains("<h1>a &amp; b</h1>"));
/// assert!(page.contains("One end state is consistent, 1 hypotheses are rejected"));
/// ```
pub fn impact_report(figure: &ImpactFigure) -> String {
    let body = html! {
        section id="verdict" class="verdict" {
            p.headline { strong { (text::capitalised(&figure.verdict)) } }
            p.lead { (figure.lead) }
            (notes(&figure.notes))
        }
        (after(figure))
        (picture(figure))
        (shared(&figure.shared))
        (examined(figure))
        (source(&figure.source))
    };
    Page {
        title: &figure.title,
        heading: &figure.title,
        styles: &[FIGURE_CSS, JOINT_CSS, REPORT_CSS, IMPACT_CSS],
        body,
        script: None,
        made_by: &figure.made_by,
    }
    .html()
}

/// The hypotheses, where they were examined.
pub(crate) fn examined(figure: &ImpactFigure) -> Markup {
    html! {
        @if let Some(rejected) = &figure.rejected {
            section id="hypotheses" {
                h2 { @if figure.stages.is_some() { "Ways on, stage by stage" } @else { "End states" } }
                (hypotheses(&figure.found, figure.stages, (rejected, figure.left_out)))
            }
        }
    }
}

pub(crate) fn after(figure: &ImpactFigure) -> Markup {
    if figure.contacts.is_empty() {
        return html! {};
    }
    let row = |body: &ImpactedBody| {
        let [x, y] = body.velocity.map(|v| significant(v, DIGITS));
        html! {
            tr { th scope="row" { (body.name) } td { (x) } td { (y) } td { (significant(body.spin, DIGITS)) } }
        }
    };
    let heads = ["body", "velocity, x [m/s]", "y [m/s]", "spin [1/s]"];
    html! {
        section id="after" {
            h2 { "After the impact" }
            (contacts_table(&figure.contacts))
            @if !figure.bodies.is_empty() { (table("small", &heads, figure.bodies.iter().map(row))) }
            @if let Some([before, after]) = figure.energy.map(|energy| energy.map(|e| significant(e, DIGITS))) {
                p.note { "Kinetic energy " (before) " → " (after) " J." }
            }
        }
    }
}

/// The contacts at the end, a row each.
pub(crate) fn contacts_table(contacts: &[RollContact]) -> Markup {
    let row = |c: &RollContact| {
        let numbers = [c.impulse, c.velocity].concat();
        html! {
            tr {
                th scope="row" { (c.name) }
                td { (c.state) }
                @for number in numbers { td { (significant(number, DIGITS)) } }
            }
        }
    };
    let heads = [
        "contact",
        "afterwards",
        "impulse, normal [N s]",
        "tangential [N s]",
        "normal velocity [m/s]",
        "slip [m/s]",
    ];
    table("small", &heads, contacts.iter().map(row))
}

fn picture(figure: &ImpactFigure) -> Markup {
    let picture = match &figure.picture {
        Some(ImpactPicture::Walk(walk)) => joint_drawing(walk, false),
        Some(ImpactPicture::Plane(plane)) => drawing(plane, false),
        None => None,
    };
    let sketch = figure.sketch.as_ref().and_then(sketch).map(|drawing| {
        html! {
            figure {
                (drawing)
                figcaption {
                    "Before the impact, to scale: each mass centre with its velocity and its spin, and each contact with its normal n and its tangent t."
                }
            }
        }
    });
    match (sketch, picture) {
        (None, None) => html! {},
        (Some(sketch), Some(picture)) => html! {
            section id="walk" {
                h2 { "The walk in impulse space" }
                div.walked { (sketch) figure.wide { (picture) } }
            }
        },
        (Some(sketch), None) => html! { section id="sketch" { h2 { "The body" } div.walked { (sketch) } } },
        (None, Some(picture)) => html! {
            section id="walk" { h2 { "The walk in impulse space" } figure.wide.alone { (picture) } }
        },
    }
}

pub(crate) fn shared(shared: &[ImpactShared]) -> Markup {
    if shared.is_empty() {
        return html! {};
    }
    let row = |one: &ImpactShared| {
        html! { tr { th scope="row" { (one.name) } td { (one.verdict) } td.words { (one.said) } } }
    };
    html! {
        section id="sharing" {
            h2 { "How the contacts share it" }
            p.note {
                "Rigid bodies leave open how contacts that close together share an impact. Each convention says:"
            }
            (table("small", &[], shared.iter().map(row)))
        }
    }
}

/// The end states and what rejects the others, of which so many are left out.
pub(crate) fn hypotheses(
    found: &[String],
    stages: Option<usize>,
    (rejected, left_out): (&[[String; 2]], usize),
) -> Markup {
    let what = if stages.is_some() { "way on" } else { "end state" };
    let mut ends = match found.len() {
        0 => format!("No {what} is consistent"),
        1 => format!("One {what} is consistent"),
        n if stages.is_some() => format!("{n} ways on are consistent"),
        n => format!("{n} end states are consistent"),
    };
    // A walk of several stages has a way on at each: their number says nothing of how many answers there are.
    match stages {
        Some(1) => ends += " at one stage",
        Some(stages) => ends += &format!(" at {stages} stages"),
        None => {}
    }
    let consistent =
        found.iter().map(|found| html! { tr { th scope="row" { (found) } td.words { "consistent" } } });
    let refused = rejected.iter().take(MOST_REJECTED).map(refused);
    let more = rejected.len().saturating_sub(MOST_REJECTED) + left_out;
    html! {
        details open[found.len() != 1] {
            summary { (ends) ", " (rejected.len() + left_out) " hypotheses are rejected" }
            (table("small", &[], consistent.chain(refused)))
            @if more > 0 { p.note { "and " (more) " more." } }
        }
    }
}

/// A hypothesis, and what refuses it.
pub(crate) fn refused([hypothesis, because]: &[String; 2]) -> Markup {
    html! { tr { td { (hypothesis) } td.words { (because) } } }
}

fn source(source: &str) -> Markup {
    html! {
        @if !source.trim().is_empty() { section id="model" { h2 { "Input" } (as_written(source)) } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_escaped_and_what_was_not_examined_is_said() {
        let contact =
            RollContact { name: "<A>".to_owned(), state: "slips".to_owned(), ..RollContact::default() };
        let figure = ImpactFigure {
            title: "a & b".to_owned(),
            verdict: "one of <many>".to_owned(),
            notes: vec!["Others were not searched for.".to_owned()],
            contacts: vec![contact],
            energy: Some([2.0, f64::NAN]),
            found: vec!["<A> slips".to_owned()],
            ..ImpactFigure::default()
        };
        let page = impact_report(&figure);
        assert!(page.contains("a &amp; b") && page.contains("One of &lt;many&gt;"), "escaped");
        assert!(
            page.contains("Others were not searched for.") && !page.contains("id=\"hypotheses\""),
            "honest"
        );
        assert!(page.contains("2.00000 → – J") && !page.contains("NaN"), "no number that is none");
        let examined = ImpactFigure { rejected: Some(vec![["A sticks".into(), "no".into()]]), ..figure };
        assert!(impact_report(&examined).contains("One end state is consistent, 1 hypotheses"), "counted");
    }
}
