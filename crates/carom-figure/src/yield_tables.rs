//! The tables of a yield study's page.

use crate::markup::{Markup, html, joined, table, unfolded};
use crate::text::{capitalised, fixed, percent, significant};
use crate::yield_page::{YieldFigure, YieldQuantity, YieldWorst};
use carom_impact::Law;
use carom_study::Ending;
use carom_study::yields::{Estimate, Recirculation, Transition};
use carom_words::{Words, study};
use std::collections::BTreeSet;

/// From plate to plate, with what probability which face follows on which; and what a loop of the rejected comes to.
pub(crate) fn transitions(figure: &YieldFigure<'_>) -> Markup {
    let found = &figure.found.transitions;
    let of = |plate: usize| found.iter().filter(|t| t.plate == plate).collect::<Vec<_>>();
    let mut out: Vec<Markup> = vec![];
    for (plate, pair) in figure.plates.windows(2).enumerate() {
        let own = of(plate + 1);
        if !own.is_empty() {
            out.push(html! { div { h3 { "From “" (pair[0]) "” to “" (pair[1]) "”" } (matrix(&own)) } });
        }
    }
    if out.is_empty() {
        return html! {};
    }
    html! {
        section id="transitions" {
            h2 { "From face to face" }
            p.note {
                "Rows: the face on which the part lies on the upper plate; columns: what becomes of it on the lower one. Percent of the row, the 95 % interval, and how many drops."
            }
            div.transitions { (joined(out)) }
            @if let Some(found) = &figure.found.recirculation { (recirculation(found)) }
        }
    }
}

fn recirculation(found: &Recirculation) -> Markup {
    let starts = found.starts.iter().map(|(face, share)| {
        html! { tr { th scope="row" { "face " (face) } td { (percent(share.share)) " %" } td { (interval(share)) } } }
    });
    html! {
        h3 { "When the rejected are thrown back" }
        p.note {
            "A loop that has run for long: each rejected part comes back on the face on which it lay, and for each part that leaves or is lost a new one comes in. In one pass "
            (percent(found.wanted.share)) " % of the parts end as wanted (" (interval(&found.wanted)) "): "
            (significant(found.passes, 3)) " passes for each good part. On these faces parts start:"
        }
        (table("matrix", &["", "share", "95 % interval"], starts))
    }
}

fn interval(share: &Estimate) -> String {
    format!("{} to {}", percent(share.low), percent(share.high))
}

fn matrix(transitions: &[&Transition]) -> Markup {
    let sorted = |of: fn(&Transition) -> Ending| {
        transitions.iter().map(|t| of(t)).collect::<BTreeSet<Ending>>().into_iter().collect::<Vec<_>>()
    };
    let (from, to) = (sorted(|t| t.from), sorted(|t| t.to));
    let row = |from: Ending| {
        let cell = |to: &Ending| match transitions.iter().find(|t| t.from == from && t.to == *to) {
            None => html! { td { "–" } },
            Some(Transition { share, .. }) => html! {
                td class={ "of-" (fixed(10.0 * share.share, 0)) } {
                    (percent(share.share)) " %" small { (interval(share)) } small { (share.count) }
                }
            },
        };
        let own = transitions.iter().filter(|t| t.from == from);
        let whole: u64 = own.map(|t| t.share.count).sum();
        html! { tr { th scope="row" { (study::ending(from)) } (joined(to.iter().map(cell))) td { (whole) } } }
    };
    let endings: Vec<String> = to.iter().copied().map(study::ending).collect();
    let heads: Vec<&str> =
        std::iter::once("").chain(endings.iter().map(String::as_str)).chain(["drops"]).collect();
    table("matrix", &heads, from.iter().copied().map(row))
}

/// The drops to look at, each with the command that replays it.
pub(crate) fn worst(figure: &YieldFigure<'_>) -> Markup {
    if figure.worst.is_empty() {
        return html! {};
    }
    html! {
        section id="worst" {
            h2 { "Drops to look at" }
            div.cases { @for (i, case) in figure.worst.iter().enumerate() { (case_of(figure, i, case)) } }
            details { summary { "Their values" } (values(figure)) }
        }
    }
}

fn case_of(figure: &YieldFigure<'_>, i: usize, case: &YieldWorst) -> Markup {
    // Of plates that the part does not come to lie on no strike is known.
    let speed = match case.impact_speed {
        Some(speed) if speed > 0.0 => format!("strikes at {} m/s", significant(speed, 4)),
        Some(_) => "lies down without a strike".to_owned(),
        None => "comes to lie on no further plate".to_owned(),
    };
    html! {
        article {
            h3 { (capitalised(&case.ending)) " " small { (speed) } }
            p { (capitalised(&case.why)) "." }
            @if figure.live { button type="button" data-case=(i) { "Open this drop" } } @else { pre { (case.command) } }
        }
    }
}

/// The values of what varies, a column for each drop.
fn values(figure: &YieldFigure<'_>) -> Markup {
    let row = |(i, quantity): (usize, &YieldQuantity)| {
        let values = figure.worst.iter().map(|case| case.values.get(i).map_or("–", String::as_str));
        html! {
            tr {
                th scope="row" { (quantity.path) }
                td { (quantity.middle) }
                @for value in values { td { (value) } }
            }
        }
    };
    let heads: Vec<&str> =
        ["quantity", "as drawn"].into_iter().chain(figure.worst.iter().map(case_name)).collect();
    table("small", &heads, figure.quantities.iter().enumerate().map(row))
}

/// A drop's name at the head of a column: its file's.
fn case_name(case: &YieldWorst) -> &str {
    let file = case.command.rsplit(['/', '\\', ' ']).next().unwrap_or_default();
    file.trim_matches(['\'', '"']).trim_start_matches("worst-").trim_end_matches(".toml")
}

/// Restitution by law.
pub(crate) fn laws(figure: &YieldFigure<'_>) -> Markup {
    let Some((first, ..)) = figure.laws.first() else { return html! {} };
    let restitutions = figure.laws.iter().filter(|(law, ..)| law == first).map(|(_, e, _)| *e);
    let mut laws: Vec<Law> = vec![];
    for (law, ..) in figure.laws {
        if !laws.contains(law) {
            laws.push(*law);
        }
    }
    let name = |law: &Law| capitalised(law.word());
    let row = |restitution: f64| {
        let cell = |law: &Law| {
            let found = figure.laws.iter().find(|(other, e, _)| other == law && *e == restitution);
            let differs = found.is_some_and(|(.., ending)| *ending != figure.drawn);
            let ending = found.map_or("–".to_owned(), |(.., ending)| study::ending(*ending));
            html! { td class=[differs.then_some("differs")] { (ending) } }
        };
        html! { tr { th scope="row" { (restitution) } (joined(laws.iter().map(cell))) } }
    };
    let names: Vec<String> = laws.iter().map(name).collect();
    let heads: Vec<&str> = std::iter::once("restitution").chain(names.iter().map(String::as_str)).collect();
    html! {
        section id="laws" {
            h2 { "What the impact law says" }
            p.note {
                "Nothing varies; restitution is the same on every plate and wall. As drawn, after "
                (name(&figure.law)) ", the drop ends " b { (study::ending(figure.drawn)) }
                "; what differs from that is marked."
            }
            (table("laws", &heads, restitutions.map(row)))
        }
    }
}

/// What varies, how it was sampled, and the scene.
pub(crate) fn inputs(figure: &YieldFigure<'_>) -> Markup {
    let row = |quantity: &YieldQuantity| {
        html! {
            tr { th scope="row" { (quantity.path) } td { (quantity.middle) } td { (quantity.tolerance) } }
        }
    };
    html! {
        section id="inputs" {
            h2 { "What varies" }
            (table("small", &["quantity", "as drawn", "tolerance"], figure.quantities.iter().map(row)))
            ul { @for note in figure.notes { li { (note) } } }
            @if !figure.source.is_empty() { (unfolded("The scene as written", figure.source)) }
        }
    }
}
