//! The report of one impact: what its contacts do, the walk, what other conventions say, and what rejects the other ends.

use crate::impulse::ImpulsePlane;
use crate::impulse_drawing::drawing;
use crate::joint::JointWalk;
use crate::joint_drawing::{JOINT_CSS, joint_drawing};
use crate::page::{Page, as_written};
use crate::report::REPORT_CSS;
use crate::roll::RollContact;
use crate::text::{escape, significant};
use crate::{FIGURE_CSS, text};

/// Digits of a number in a table.
const DIGITS: usize = 6;
/// Hypotheses that are listed; six contacts have thousands.
const MOST_REJECTED: usize = 400;

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
///
/// # Example
/// A walk of two stages has three corners, the origin one of them.
/// ```
/// # use {carom_figure::{ImpulsePlane, ImpulsePoint}, carom_impact::planar::Phase};
/// # let point = |normal, tangential, label: &str| ImpulsePoint {
/// #     normal, tangential, phase: Phase::Compression, label: label.to_owned(),
/// # };
/// # let plane = ImpulsePlane {
/// #     operator: Some([3.5, 0.0, 1.0]), slip: 1.05, approach: -2.0, friction: 0.3,
/// #     points: vec![point(1.0, -0.3, "its slip stops"), point(2.0, -0.3, "compression ends")],
/// # };
/// use carom_figure::{ImpactFigure, ImpactPicture, impact_report};
/// let picture = Some(ImpactPicture::Plane(plane));
/// let page = impact_report(&ImpactFigure { picture, ..ImpactFigure::default() });
/// assert_eq!(page.matches("<circle class=\"dot\"").count(), 3);
/// ```
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
    /// The walk.
    pub picture: Option<ImpactPicture>,
    /// What other conventions on sharing say.
    pub shared: Vec<ImpactShared>,
    /// The end states that were found.
    pub found: Vec<String>,
    /// The other hypotheses, each with what rejects it; `None` where they were not examined.
    pub rejected: Option<Vec<[String; 2]>>,
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
    let notes: String =
        figure.notes.iter().map(|note| format!("<p class=\"note\">{}</p>", escape(note))).collect();
    let ends = match &figure.rejected {
        Some(rejected) => format!(
            "<section id=\"hypotheses\"><h2>End states</h2>{}</section>",
            hypotheses(&figure.found, rejected)
        ),
        None => String::new(),
    };
    let verdict = format!(
        "<section id=\"verdict\" class=\"verdict\"><p class=\"headline\"><strong>{}</strong></p><p class=\"lead\">{}</p>{notes}</section>\n",
        escape(&text::capitalised(&figure.verdict)),
        escape(&figure.lead)
    );
    let parts =
        [verdict, after(figure), picture(figure), shared(&figure.shared), ends, source(&figure.source)];
    Page {
        title: &figure.title,
        heading: &figure.title,
        warnings: &[],
        styles: &[FIGURE_CSS, JOINT_CSS, REPORT_CSS],
        body: &parts.concat(),
        script: "",
        made_by: &figure.made_by,
    }
    .html()
}

fn after(figure: &ImpactFigure) -> String {
    if figure.contacts.is_empty() {
        return String::new();
    }
    let mut out =
        format!("<section id=\"after\"><h2>After the impact</h2>{}", contacts_table(&figure.contacts));
    if !figure.bodies.is_empty() {
        out += "<div class=\"wide\"><table class=\"small\"><thead><tr><th>body</th><th>velocity, x <span class=\"u\">m/s</span></th><th>y <span class=\"u\">m/s</span></th><th>spin <span class=\"u\">1/s</span></th></tr></thead><tbody>";
        for body in &figure.bodies {
            let [x, y] = body.velocity.map(|v| significant(v, DIGITS));
            let spin = significant(body.spin, DIGITS);
            let name = escape(&body.name);
            out += &format!("<tr><th scope=\"row\">{name}</th><td>{x}</td><td>{y}</td><td>{spin}</td></tr>");
        }
        out += "</tbody></table></div>";
    }
    if let Some([before, after]) = figure.energy.map(|energy| energy.map(|e| significant(e, DIGITS))) {
        out += &format!("<p class=\"note\">Kinetic energy {before} → {after} J.</p>");
    }
    out + "</section>"
}

/// The contacts at the end, a row each.
pub(crate) fn contacts_table(contacts: &[RollContact]) -> String {
    let mut out = String::from(
        "<div class=\"wide\"><table class=\"small\"><thead><tr><th>contact</th><th>afterwards</th><th>impulse, normal <span class=\"u\">N s</span></th><th>tangential <span class=\"u\">N s</span></th><th>normal velocity <span class=\"u\">m/s</span></th><th>slip <span class=\"u\">m/s</span></th></tr></thead><tbody>",
    );
    let number = |x: f64| significant(x, DIGITS);
    for c in contacts {
        out += &format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escape(&c.name),
            escape(&c.state),
            number(c.impulse[0]),
            number(c.impulse[1]),
            number(c.velocity[0]),
            number(c.velocity[1])
        );
    }
    out + "</tbody></table></div>"
}

fn picture(figure: &ImpactFigure) -> String {
    let svg = match &figure.picture {
        Some(ImpactPicture::Walk(walk)) => joint_drawing(walk, false),
        Some(ImpactPicture::Plane(plane)) => drawing(plane, false),
        None => String::new(),
    };
    if svg.is_empty() {
        return svg;
    }
    format!(
        "<section id=\"walk\"><h2>The walk in impulse space</h2><figure class=\"wide\">{svg}</figure></section>"
    )
}

fn shared(shared: &[ImpactShared]) -> String {
    if shared.is_empty() {
        return String::new();
    }
    let mut out = String::from(
        "<section id=\"sharing\"><h2>How the contacts share it</h2><p class=\"note\">Rigid bodies leave open how contacts that close together share an impact. Each convention says:</p><div class=\"wide\"><table class=\"small\"><tbody>",
    );
    for one in shared {
        out += &format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"words\">{}</td></tr>",
            escape(&one.name),
            escape(&one.verdict),
            escape(&one.said)
        );
    }
    out + "</tbody></table></div></section>"
}

/// The end states and what rejects the others.
pub(crate) fn hypotheses(found: &[String], rejected: &[[String; 2]]) -> String {
    let ends = match found.len() {
        0 => "No end state is consistent".to_owned(),
        1 => "One end state is consistent".to_owned(),
        n => format!("{n} end states are consistent"),
    };
    let mut out = format!(
        "<details{}><summary>{ends}, {} hypotheses are rejected</summary><div class=\"wide\"><table class=\"small\"><tbody>",
        if found.len() == 1 { "" } else { " open" },
        rejected.len()
    );
    for found in found {
        out +=
            &format!("<tr><th scope=\"row\">{}</th><td class=\"words\">consistent</td></tr>", escape(found));
    }
    for [hypothesis, because] in rejected.iter().take(MOST_REJECTED) {
        out +=
            &format!("<tr><td>{}</td><td class=\"words\">{}</td></tr>", escape(hypothesis), escape(because));
    }
    out += "</tbody></table></div>";
    if rejected.len() > MOST_REJECTED {
        out += &format!("<p class=\"note\">and {} more.</p>", rejected.len() - MOST_REJECTED);
    }
    out + "</details>"
}

fn source(source: &str) -> String {
    match as_written(source) {
        none if none.is_empty() => none,
        file => format!("<section id=\"model\"><h2>Input</h2>{file}</section>"),
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
