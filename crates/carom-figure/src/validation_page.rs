//! The page of published results beside ours.

use crate::FIGURE_CSS;
use crate::page::Page;
use crate::report::REPORT_CSS;
use crate::text::{escape, significant, trimmed};

const VALIDATION_CSS: &str = include_str!("validation.css");

/// Digits of a value of ours beside a printed one.
const DIGITS: usize = 10;

/// A value of ours.
///
/// # Example
/// ```
/// # use carom_figure::{ValidatedResult, ValidatedRow, ValidatedValue, ValidationFigure, validation_report};
/// # let row = ValidatedRow {
/// #     letter: "v".to_owned(), what: "speed".to_owned(), unit: "m/s".to_owned(), printed: "2.0".to_owned(),
/// #     ours: ValidatedValue::Number(2.5), share: Some(0.2), verdict: "misprint".to_owned(),
/// #     as_declared: true, reason: "digits exchanged".to_owned(), meant: None, tolerance: None,
/// # };
/// # let result = ValidatedResult {
/// #     name: "table".to_owned(), title: "A table".to_owned(), citation: "Someone".to_owned(),
/// #     went_in: vec![], cannot_be_checked: vec![], failure: None, rows: vec![row.clone(), row.clone()],
/// # };
/// # let verdicts = ["agrees", "misprint"];
/// # let page = |results: &[ValidatedResult]| {
/// #     validation_report(&ValidationFigure { results, verdicts: &verdicts, made_by: "" })
/// # };
/// let shown = |ours| {
///     let rows = vec![ValidatedRow { ours, ..row.clone() }];
///     page(&[ValidatedResult { rows, ..result.clone() }])
/// };
/// assert!(shown(ValidatedValue::Number(2.5)).contains("<td>2.5</td>"));
/// assert!(shown(ValidatedValue::Word("turned".to_owned())).contains("<td>turned</td>"));
/// assert!(shown(ValidatedValue::Nothing).contains("<td>–</td>"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum ValidatedValue {
    /// In the row's unit.
    Number(f64),
    /// An outcome by its name.
    Word(String),
    /// The engine says nothing of it.
    Nothing,
}

/// A printed entry beside ours.
///
/// # Example
/// Printed is 2.0, ours is 2.5: that is off by 20 % of the larger one.
/// ```
/// # use carom_figure::{ValidatedResult, ValidatedRow, ValidatedValue, ValidationFigure, validation_report};
/// # let row = ValidatedRow {
/// #     letter: "v".to_owned(), what: "speed".to_owned(), unit: "m/s".to_owned(), printed: "2.0".to_owned(),
/// #     ours: ValidatedValue::Number(2.5), share: Some(0.2), verdict: "misprint".to_owned(),
/// #     as_declared: true, reason: "digits exchanged".to_owned(), meant: None, tolerance: None,
/// # };
/// # let result = ValidatedResult {
/// #     name: "table".to_owned(), title: "A table".to_owned(), citation: "Someone".to_owned(),
/// #     went_in: vec![], cannot_be_checked: vec![], failure: None, rows: vec![row.clone(), row.clone()],
/// # };
/// # let verdicts = ["agrees", "misprint"];
/// # let page = |results: &[ValidatedResult]| {
/// #     validation_report(&ValidationFigure { results, verdicts: &verdicts, made_by: "" })
/// # };
/// let html = page(&[result.clone()]);
/// assert!(html.contains("<td>2.0</td><td>2.5</td><td>20.0 %</td><td class=\"verdict-word\">misprint</td>"));
/// ```
#[derive(Clone, Debug, PartialEq)]
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
///
/// # Example
/// ```
/// # use carom_figure::{ValidatedResult, ValidatedRow, ValidatedValue, ValidationFigure, validation_report};
/// # let row = ValidatedRow {
/// #     letter: "v".to_owned(), what: "speed".to_owned(), unit: "m/s".to_owned(), printed: "2.0".to_owned(),
/// #     ours: ValidatedValue::Number(2.5), share: Some(0.2), verdict: "misprint".to_owned(),
/// #     as_declared: true, reason: "digits exchanged".to_owned(), meant: None, tolerance: None,
/// # };
/// # let result = ValidatedResult {
/// #     name: "table".to_owned(), title: "A table".to_owned(), citation: "Someone".to_owned(),
/// #     went_in: vec![], cannot_be_checked: vec![], failure: None, rows: vec![row.clone(), row.clone()],
/// # };
/// # let verdicts = ["agrees", "misprint"];
/// # let page = |results: &[ValidatedResult]| {
/// #     validation_report(&ValidationFigure { results, verdicts: &verdicts, made_by: "" })
/// # };
/// let failure = Some("no such file".to_owned());
/// let html = page(&[ValidatedResult { failure, rows: vec![], ..result.clone() }]);
/// assert!(html.contains("<h2>A table</h2>") && html.contains("Nothing was computed: no such file"));
/// ```
#[derive(Clone, Debug, PartialEq)]
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
///
/// # Example
/// Two results with two entries each.
/// ```
/// # use carom_figure::{ValidatedResult, ValidatedRow, ValidatedValue, ValidationFigure, validation_report};
/// # let row = ValidatedRow {
/// #     letter: "v".to_owned(), what: "speed".to_owned(), unit: "m/s".to_owned(), printed: "2.0".to_owned(),
/// #     ours: ValidatedValue::Number(2.5), share: Some(0.2), verdict: "misprint".to_owned(),
/// #     as_declared: true, reason: "digits exchanged".to_owned(), meant: None, tolerance: None,
/// # };
/// # let result = ValidatedResult {
/// #     name: "table".to_owned(), title: "A table".to_owned(), citation: "Someone".to_owned(),
/// #     went_in: vec![], cannot_be_checked: vec![], failure: None, rows: vec![row.clone(), row.clone()],
/// # };
/// # let verdicts = ["agrees", "misprint"];
/// # let page = |results: &[ValidatedResult]| {
/// #     validation_report(&ValidationFigure { results, verdicts: &verdicts, made_by: "" })
/// # };
/// let figure = ValidationFigure { results: &[result.clone(), result], verdicts: &verdicts, made_by: "" };
/// let html = validation_report(&figure);
/// assert!(html.contains("All 4 verdicts hold") && html.contains("4 misprint"));
/// ```
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
/// What is not as it was declared comes first.
/// ```
/// # use carom_figure::{ValidatedResult, ValidatedRow, ValidatedValue, ValidationFigure, validation_report};
/// # let row = ValidatedRow {
/// #     letter: "v".to_owned(), what: "speed".to_owned(), unit: "m/s".to_owned(), printed: "2.0".to_owned(),
/// #     ours: ValidatedValue::Number(2.5), share: Some(0.2), verdict: "misprint".to_owned(),
/// #     as_declared: true, reason: "digits exchanged".to_owned(), meant: None, tolerance: None,
/// # };
/// # let result = ValidatedResult {
/// #     name: "table".to_owned(), title: "A table".to_owned(), citation: "Someone".to_owned(),
/// #     went_in: vec![], cannot_be_checked: vec![], failure: None, rows: vec![row.clone(), row.clone()],
/// # };
/// # let verdicts = ["agrees", "misprint"];
/// # let page = |results: &[ValidatedResult]| {
/// #     validation_report(&ValidationFigure { results, verdicts: &verdicts, made_by: "" })
/// # };
/// let off = ValidatedRow { as_declared: false, ..row.clone() };
/// let html = page(&[ValidatedResult { rows: vec![off, row.clone()], ..result.clone() }]);
/// assert!(html.contains("One of 2 verdicts does not hold"));
/// ```
pub fn validation_report(figure: &ValidationFigure<'_>) -> String {
    let sections: String = figure.results.iter().map(section).collect();
    let body = [verdict(figure), overview(figure), errata(figure), sections].concat();
    Page {
        title: "carom validate",
        heading: "Published results beside ours",
        warnings: &[],
        styles: &[FIGURE_CSS, REPORT_CSS, VALIDATION_CSS],
        body: &body,
        script: "",
        made_by: figure.made_by,
    }
    .html()
}

fn verdict(figure: &ValidationFigure<'_>) -> String {
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
        .map(|(word, count)| format!("{count} {}", escape(word)))
        .collect();
    format!(
        "<section id=\"verdict\" class=\"verdict {class}\"><p class=\"headline\"><strong>{headline}</strong></p><p class=\"lead\">{}</p><p class=\"note\">This project gives each printed entry a verdict; the numbers must bear it out. Ours comes from runs and impacts of the engine; of a formula the printed entry is its value. <em>Agrees</em> is to the last printed digit or within the tolerance that the row names; <em>coarse</em> within the share that the table states; a <em>misprint</em> disagrees as it is printed, and what is meant agrees; what is <em>wrong in print</em> does not follow from the source's own assumptions; what is <em>beyond the model</em> was measured on bodies that are not as rigid as the model takes them for.</p></section>",
        counts.join(" · ")
    )
}

/// One line a result, with its counts.
fn overview(figure: &ValidationFigure<'_>) -> String {
    let heads: String = figure.verdicts.iter().map(|word| format!("<th>{}</th>", escape(word))).collect();
    let line = |result: &ValidatedResult| {
        let counts: String = figure
            .verdicts
            .iter()
            .map(|word| result.rows.iter().filter(|row| row.verdict == **word).count())
            .map(|count| if count == 0 { "<td></td>".to_owned() } else { format!("<td>{count}</td>") })
            .collect();
        format!(
            "<tr><th scope=\"row\"><a href=\"#{}\">{}</a></th>{counts}</tr>",
            escape(&result.name),
            escape(&result.title)
        )
    };
    let lines: String = figure.results.iter().map(line).collect();
    format!(
        "<section id=\"overview\"><h2>Results</h2><div class=\"wide\"><table class=\"validation\"><thead><tr><th></th>{heads}</tr></thead><tbody>{lines}</tbody></table></div></section>"
    )
}

/// What is misprinted or wrong, in one list.
fn errata(figure: &ValidationFigure<'_>) -> String {
    let faulty = |row: &&ValidatedRow| matches!(row.verdict.as_str(), "misprint" | "wrong in print");
    let mut items = String::new();
    for result in figure.results {
        for row in result.rows.iter().filter(faulty) {
            items += &format!(
                "<tr><td class=\"words\">{}: {}</td><td>{}</td><td>{}</td><td class=\"verdict-word\">{}</td><td class=\"words\">{}</td></tr>",
                escape(&result.title),
                escape(&row.what),
                escape(&row.printed),
                ours(&row.ours),
                escape(&row.verdict),
                escape(&row.reason)
            );
        }
    }
    if items.is_empty() {
        return items;
    }
    format!(
        "<section id=\"errata\"><h2>Errata</h2><details><summary>Every entry that is misprinted or wrong</summary><div class=\"wide\"><table class=\"validation\"><thead><tr><th>entry</th><th>printed</th><th>ours</th><th class=\"verdict-word\">verdict</th><th>why</th></tr></thead><tbody>{items}</tbody></table></div></details></section>"
    )
}

fn section(result: &ValidatedResult) -> String {
    let list = |words: &[String]| -> String {
        words.iter().map(|word| format!("<li>{}</li>", escape(word))).collect()
    };
    let unchecked = if result.cannot_be_checked.is_empty() {
        String::new()
    } else {
        format!("<h3>Cannot be checked</h3><ul>{}</ul>", list(&result.cannot_be_checked))
    };
    let failure = result.failure.as_ref().map_or(String::new(), |why| {
        format!("<p class=\"note warn\">Nothing was computed: {}</p>", escape(why))
    });
    let rows: String = result.rows.iter().map(row).collect();
    format!(
        "<section id=\"{}\"><h2>{}</h2><p class=\"note\">{}</p>{failure}<h3>What went in</h3><ul>{}</ul>{unchecked}<div class=\"wide\"><table class=\"validation\"><thead><tr><th>entry</th><th></th><th>unit</th><th>printed</th><th>ours</th><th>difference</th><th class=\"verdict-word\">verdict</th><th>why</th></tr></thead><tbody>{rows}</tbody></table></div></section>",
        escape(&result.name),
        escape(&result.title),
        escape(&result.citation),
        list(&result.went_in)
    )
}

fn row(row: &ValidatedRow) -> String {
    let class = if row.as_declared { row.verdict.split(' ').next().unwrap_or_default() } else { "fails" };
    let meant = match &row.meant {
        Some(meant) if row.verdict == "wrong in print" => format!(". Right: {}.", escape(meant)),
        _ => String::new(),
    };
    let within = row.tolerance.as_ref().map_or(String::new(), |tolerance| {
        format!("<small class=\"within\">within {}</small>", escape(tolerance))
    });
    let undeclared = if row.as_declared { "" } else { " (not as declared)" };
    format!(
        "<tr class=\"{class}\"><td class=\"words\">{}</td><td>{}</td><td class=\"u\">{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"verdict-word\">{}{undeclared}</td><td class=\"words\">{}{meant}{within}</td></tr>",
        escape(&row.what),
        escape(&row.letter),
        escape(&row.unit),
        escape(&row.printed.replace('-', "−")),
        ours(&row.ours),
        row.share.map_or(String::new(), share),
        escape(&row.verdict),
        escape(&row.reason)
    )
}

fn ours(value: &ValidatedValue) -> String {
    match value {
        ValidatedValue::Number(number) => trimmed(*number, DIGITS),
        ValidatedValue::Word(word) => escape(word),
        ValidatedValue::Nothing => "–".to_owned(),
    }
}

/// A share in per cent; what is only rounding as a power of ten.
fn share(share: f64) -> String {
    let size = 100.0 * share.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    format!("{} %", significant(100.0 * share, if size < 1e-3 { 1 } else { 3 }))
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
}
