//! The page of published results beside ours.

use crate::FIGURE_CSS;
use crate::markup::{Markup, html, joined, table};
use crate::page::Page;
use crate::report::REPORT_CSS;
use crate::text::{significant, trimmed};

const VALIDATION_CSS: &str = include_str!("validation.css");

/// Digits of a value of ours beside a printed one.
const DIGITS: usize = 10;

/// A value of ours.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum ValidatedValue {
    /// In the row's unit.
    Number(f64),
    /// An outcome by its name.
    Word(String),
    /// The engine says nothing of it.
    #[default]
    Nothing,
}

/// A printed entry beside ours.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ValidatedRow {
    /// The source's letter; empty where it has none.
    pub letter: String,
    /// What it is.
    pub what: String,
    /// Its unit; empty of pure numbers and of words.
    pub unit: String,
    /// As it is printed.
    pub printed: String,
    /// What the engine says.
    pub ours: ValidatedValue,
    /// Ours less what is printed, as a share of the larger of the two.
    pub share: Option<f64>,
    /// agrees, coarse in print, misprint, wrong in print, beyond the model or fails.
    pub verdict: String,
    /// True where the verdict is the declared one.
    pub as_declared: bool,
    /// Why; empty where it agrees.
    pub reason: String,
    /// What is right instead, where that is known apart from ours.
    pub meant: Option<String>,
    /// What ours may be off, and why, where that is not half of the last printed digit.
    pub tolerance: Option<String>,
}

/// A published result.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ValidatedResult {
    /// Its name, by which it is validated alone.
    pub name: String,
    /// In a few words.
    pub title: String,
    /// Where it is published.
    pub citation: String,
    /// What went in.
    pub went_in: Vec<String>,
    /// What cannot be checked.
    pub cannot_be_checked: Vec<String>,
    /// Why nothing was computed.
    pub failure: Option<String>,
    /// The printed entries.
    pub rows: Vec<ValidatedRow>,
}

/// What the page shows.
#[derive(Clone, Copy, Debug)]
pub struct ValidationFigure<'a> {
    /// The results.
    pub results: &'a [ValidatedResult],
    /// The verdicts in their order, best first.
    pub verdicts: &'a [&'a str],
    /// What made the page, with its version.
    pub made_by: &'a str,
}

/// One self-contained HTML page on published results; it needs no network.
///
/// # Example
/// Printed is 2.0, ours is 2.5: that is off by 20 % of the larger one. What is not as it was declared comes first.
/// ```
/// use carom_figure::{ValidatedResult, ValidatedRow, ValidatedValue, ValidationFigure, validation_report};
/// let row = ValidatedRow {
///     printed: "2.0".to_owned(),
///     ours: ValidatedValue::Number(2.5),
///     share: Some(0.2),
///     verdict: "misprint".to_owned(),
///     as_declared: true,
///     ..ValidatedRow::default()
/// };
/// let off = ValidatedRow { as_declared: false, ..row.clone() };
/// let result = ValidatedResult { rows: vec![row, off], ..ValidatedResult::default() };
/// let figure = ValidationFigure { results: &[result], verdicts: &["agrees", "misprint"], made_by: "" };
/// let page = validation_report(&figure);
/// assert!(page.contains("One of 2 verdicts does not hold") && page.contains("2 misprint"));
/// assert!(page.contains("<td>2.0</td><td>2.5</td><td>20.0 %</td><td class=\"verdict-word\">misprint</td>"));
/// ```
pub fn validation_report(figure: &ValidationFigure<'_>) -> String {
    let body = html! {
        (verdict(figure))
        (overview(figure))
        (errata(figure))
        @for result in figure.results { (section(result)) }
    };
    Page {
        title: "carom validate",
        heading: "Published results beside ours",
        styles: &[FIGURE_CSS, REPORT_CSS, VALIDATION_CSS],
        body,
        script: None,
        made_by: figure.made_by,
    }
    .html()
}

fn verdict(figure: &ValidationFigure<'_>) -> Markup {
    let rows = || figure.results.iter().flat_map(|result| &result.rows);
    let (all, off) = (rows().count(), rows().filter(|row| !row.as_declared).count());
    let (class, headline) = match off {
        0 => ("wanted", format!("All {all} verdicts hold")),
        1 => ("unwanted", format!("One of {all} verdicts does not hold")),
        _ => ("unwanted", format!("{off} of {all} verdicts do not hold")),
    };
    let counts: Vec<String> = figure
        .verdicts
        .iter()
        .map(|word| (word, rows().filter(|row| row.verdict == **word).count()))
        .filter(|(_, count)| *count > 0)
        .map(|(word, count)| format!("{count} {word}"))
        .collect();
    html! {
        section id="verdict" class={ "verdict " (class) } {
            p.headline { strong { (headline) } }
            p.lead { (counts.join(" · ")) }
            p.note {
                "This project gives each printed entry a verdict; the numbers must bear it out. Ours comes from runs and impacts of the engine; of a formula the printed entry is its value. "
                em { "Agrees" }
                " is to the last printed digit or within the tolerance that the row names; "
                em { "coarse" }
                " within the share that the table states; a "
                em { "misprint" }
                " disagrees as it is printed, and what is meant agrees; what is "
                em { "wrong in print" }
                " does not follow from the source's own assumptions; what is "
                em { "beyond the model" }
                " was measured on bodies that are not as rigid as the model takes them for."
            }
        }
    }
}

/// One line a result, with its counts.
fn overview(figure: &ValidationFigure<'_>) -> Markup {
    let line = |result: &ValidatedResult| {
        let count = |word: &&str| result.rows.iter().filter(|row| row.verdict == *word).count();
        html! {
            tr {
                th scope="row" { a href={ "#" (result.name) } { (result.title) } }
                @for count in figure.verdicts.iter().map(count) { td { @if count > 0 { (count) } } }
            }
        }
    };
    let heads = [&[""], figure.verdicts].concat();
    html! {
        section id="overview" {
            h2 { "Results" }
            (table("validation", &heads, figure.results.iter().map(line)))
        }
    }
}

/// What is misprinted or wrong, in one list.
fn errata(figure: &ValidationFigure<'_>) -> Markup {
    let faulty = |row: &&ValidatedRow| matches!(row.verdict.as_str(), "misprint" | "wrong in print");
    let of = |result: &ValidatedResult| {
        let item = |row: &ValidatedRow| {
            html! {
                tr {
                    td.words { (result.title) ": " (row.what) }
                    td { (row.printed) }
                    td { (ours(&row.ours)) }
                    td.verdict-word { (row.verdict) }
                    td.words { (row.reason) }
                }
            }
        };
        result.rows.iter().filter(faulty).map(item).collect::<Vec<_>>()
    };
    let items: Vec<Markup> = figure.results.iter().flat_map(of).collect();
    if items.is_empty() {
        return html! {};
    }
    html! {
        section id="errata" {
            h2 { "Errata" }
            details {
                summary { "Every entry that is misprinted or wrong" }
                div.wide tabindex="0" {
                    table.validation {
                        thead {
                            tr {
                                th { "entry" }
                                th { "printed" }
                                th { "ours" }
                                th.verdict-word { "verdict" }
                                th { "why" }
                            }
                        }
                        tbody { (joined(items)) }
                    }
                }
            }
        }
    }
}

fn section(result: &ValidatedResult) -> Markup {
    let list = |words: &[String]| html! { ul { @for word in words { li { (word) } } } };
    html! {
        section id=(result.name) {
            h2 { (result.title) }
            p.note { (result.citation) }
            @if let Some(why) = &result.failure { p.note.warn { "Nothing was computed: " (why) } }
            h3 { "What went in" }
            (list(&result.went_in))
            @if !result.cannot_be_checked.is_empty() {
                h3 { "Cannot be checked" }
                (list(&result.cannot_be_checked))
            }
            div.wide tabindex="0" {
                table.validation {
                    thead {
                        tr {
                            th { "entry" }
                            th {}
                            th { "unit" }
                            th { "printed" }
                            th { "ours" }
                            th { "difference" }
                            th.verdict-word { "verdict" }
                            th { "why" }
                        }
                    }
                    tbody { @for entry in &result.rows { (row(entry)) } }
                }
            }
        }
    }
}

fn row(row: &ValidatedRow) -> Markup {
    let class = if row.as_declared { row.verdict.split(' ').next().unwrap_or_default() } else { "fails" };
    let meant = row.meant.as_ref().filter(|_| row.verdict == "wrong in print");
    html! {
        tr class=(class) {
            td.words { (row.what) }
            td { (row.letter) }
            td.u { (row.unit) }
            td { (row.printed.replace('-', "−")) }
            td { (ours(&row.ours)) }
            td { (row.share.map(share).unwrap_or_default()) }
            td.verdict-word { (row.verdict) @if !row.as_declared { " (not as declared)" } }
            td.words {
                (row.reason)
                @if let Some(meant) = meant { ". Right: " (meant) "." }
                @if let Some(tolerance) = &row.tolerance { small.within { "within " (tolerance) } }
            }
        }
    }
}

fn ours(value: &ValidatedValue) -> String {
    match value {
        ValidatedValue::Number(number) => trimmed(*number, DIGITS),
        ValidatedValue::Word(word) => word.clone(),
        ValidatedValue::Nothing => "–".to_owned(),
    }
}

/// Below this \[%\] a share is what rounding leaves: one digit says its size.
const ROUGHLY: f64 = 1e-3;

/// A share in per cent; what is only rounding as a power of ten.
fn share(share: f64) -> String {
    let size = 100.0 * share.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    format!("{} %", significant(100.0 * share, if size < ROUGHLY { 1 } else { 3 }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn result(verdict: &str, as_declared: bool) -> ValidatedResult {
        let row = ValidatedRow {
            letter: "ω".to_owned(),
            what: "spin <after>".to_owned(),
            unit: "1/s".to_owned(),
            printed: "-11.7".to_owned(),
            ours: ValidatedValue::Number(-10.786),
            share: Some(0.085),
            verdict: verdict.to_owned(),
            as_declared,
            reason: "breaks a balance".to_owned(),
            meant: Some("-10.786".to_owned()),
            tolerance: Some("1e-9 m: rounding".to_owned()),
        };
        ValidatedResult {
            name: "table".to_owned(),
            title: "A table".to_owned(),
            citation: "Someone".to_owned(),
            went_in: vec!["a rod".to_owned()],
            cannot_be_checked: vec!["what was measured".to_owned()],
            failure: None,
            rows: vec![row],
        }
    }

    fn page(result: ValidatedResult) -> String {
        let verdicts = ["agrees", "wrong in print", "fails"];
        validation_report(&ValidationFigure { results: &[result], verdicts: &verdicts, made_by: "carom" })
    }

    #[test]
    fn an_error_in_print_stands_in_the_errata_with_what_is_right() {
        let page = page(result("wrong in print", true));
        assert!(page.contains("All 1 verdicts hold"), "the verdict");
        assert!(page.contains("1 wrong in print"), "the counts");
        assert!(page.contains("id=\"errata\"") && page.contains("Right: -10.786."), "the errata");
        assert!(page.contains("spin &lt;after&gt;") && page.contains("8.50 %"), "the row");
        assert!(page.contains("within 1e-9 m: rounding"), "the tolerance");
    }

    #[test]
    fn what_is_not_as_declared_is_said_first() {
        let page = page(result("fails", false));
        assert!(page.contains("One of 1 verdicts does not hold"), "the verdict");
        assert!(page.contains("verdict unwanted") && page.contains("(not as declared)"), "the row");
    }

    #[test]
    fn what_is_not_known_is_a_dash_and_a_failure_is_said() {
        let shown = |ours| {
            let row = ValidatedRow { ours, ..result("agrees", true).rows.remove(0) };
            page(ValidatedResult { rows: vec![row], ..result("agrees", true) })
        };
        assert!(shown(ValidatedValue::Number(2.5)).contains("<td>2.5</td>"), "a number");
        assert!(
            shown(ValidatedValue::Word("<turned>".to_owned())).contains("<td>&lt;turned&gt;</td>"),
            "a word"
        );
        assert!(shown(ValidatedValue::Nothing).contains("<td>–</td>"), "nothing");
        let failure = Some("no such file".to_owned());
        let failed = page(ValidatedResult { failure, rows: vec![], ..result("agrees", true) });
        assert!(failed.contains("<h2>A table</h2>"), "its section");
        assert!(failed.contains("Nothing was computed: no such file"), "its failure");
    }
}
