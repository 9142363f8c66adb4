//! The tables of a yield study's page.

use crate::markup::{Markup, html, joined, table, unfolded};
use crate::text::{capitalised, fixed, percent, significant};
use crate::yield_page::{YieldFigure, YieldQuantity, YieldWorst};
use carom_impact::planar::Law;
use carom_study::Ending;
use carom_study::yields::Passage;
use carom_words::{Words, study};

/// From plate to plate: which side becomes which.
pub(crate) fn passages(figure: &YieldFigure<'_>) -> Markup {
    let mut out: Vec<Markup> = vec![];
    let mut before = figure.plates.first();
    for (name, passages) in figure.plates.iter().zip(&figure.found.passages).skip(1) {
        if !passages.is_empty() {
            let from = before.map(String::as_str).unwrap_or_default();
            out.push(html! {
                div { h3 { "From “" (from) "” to “" (name) "”" } (matrix(passages, figure.found.drops)) }
            });
        }
        before = Some(name);
    }
    if out.is_empty() {
        return html! {};
    }
    html! {
        section id="passages" {
            h2 { "From plate to plate" }
            p.note {
                "Rows: how the part lies on the upper plate; columns: how it comes to lie on the lower one. Percent of the row, and how many drops. Sides count from the start."
            }
            div.passages { (joined(out)) }
        }
    }
}

fn matrix(passages: &[Passage], drops: u64) -> Markup {
    let mut from: Vec<Option<Ending>> = passages.iter().map(|passage| passage.from).collect();
    let mut to: Vec<Ending> = passages.iter().map(|passage| passage.to).collect();
    from.dedup();
    to.sort();
    to.dedup();
    let row = |row: Option<Ending>| {
        let of = |ending: Option<Ending>| {
            let same = passages
                .iter()
                .filter(|passage| passage.from == row && ending.is_none_or(|ending| passage.to == ending));
            same.map(|passage| passage.count).sum::<u64>()
        };
        let whole = of(None);
        let cell = |ending: &Ending| match of(Some(*ending)) {
            0 => html! { td { "–" } },
            count => {
                let share = count as f64 / whole.max(1) as f64;
                html! { td style={ "--share:" (fixed(share, 3)) } { (percent(share)) " %" small { (count) } } }
            }
        };
        let name = row.map_or("at the start".to_owned(), study::ending);
        html! { tr { th scope="row" { (name) } (joined(to.iter().map(cell))) td { (whole) } } }
    };
    let followed: u64 = passages.iter().map(|passage| passage.count).sum();
    let endings: Vec<String> = to.iter().copied().map(study::ending).collect();
    let heads: Vec<&str> =
        std::iter::once("").chain(endings.iter().map(String::as_str)).chain(["drops"]).collect();
    html! {
        (table("matrix", &heads, from.into_iter().map(row)))
        @if followed < drops { p.note { (drops - followed) " drops could not be followed." } }
    }
}

/// The drops to look at, each with the command that replays it.
pub(crate) fn worst(figure: &YieldFigure<'_>) -> Markup {
    if figure.worst.is_empty() {
        return html! {};
    }
    html! {
        section id="worst" {
            h2 { "Drops to look at" }
            div.cases { @for case in figure.worst { (case_of(case)) } }
            details { summary { "Their values" } (values(figure)) }
        }
    }
}

fn case_of(case: &YieldWorst) -> Markup {
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
            pre { (case.command) }
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
