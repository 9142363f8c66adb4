//! `carom validate`: published results beside what the engine computes.

use crate::args::{Format, Output};
use crate::failure::Failure;
use crate::files;
use crate::printed::tell;
use carom_figure::{ValidatedResult, ValidatedRow, ValidatedValue, ValidationFigure};
use carom_validation::{OursReport, ResultReport, RowReport, ValidationError, ValidationReport, Verdict};
use carom_words::aligned;
use clap::Args;
use std::fmt::Write as _;
use std::io::Write;

/// What validation means, for those who see it first.
pub(crate) const VALIDATE_HELP: &str = "\
Every entry has a declared verdict: agrees, coarse in print, misprint, wrong in print, beyond the model. The numbers must
bear it out; where they do not, the exit code is 1. The page, with errata, goes to out/validation/report.html.";

#[derive(Args, Debug)]
pub(crate) struct ValidateOptions {
    /// Results by name [default: all].
    #[arg(value_name = "NAME")]
    pub(crate) names: Vec<String>,
    /// Print the names of all results, and no more.
    #[arg(long, conflicts_with = "names")]
    pub(crate) list: bool,
    /// Print every entry, not only those that do not simply agree.
    #[arg(long)]
    pub(crate) all: bool,
    /// Open the page when it is written.
    #[arg(long)]
    pub(crate) open: bool,
}

/// Significant digits of ours in the table.
const DIGITS: usize = 10;

pub(crate) fn validate(
    options: &ValidateOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    if options.list {
        for name in carom_validation::names() {
            let table = carom_validation::table(name).map_err(failure)?;
            writeln!(out, "{name:<24} {}", table.title)?;
        }
        return Ok(());
    }
    let names: Vec<&str> = options.names.iter().map(String::as_str).collect();
    let report = carom_validation::validate(&names).map_err(failure)?;
    let json = format!("{}\n", serde_json::to_string_pretty(&report)?);
    match output.format {
        Format::Text => out.write_all(text(&report, options.all).as_bytes())?,
        Format::Json => out.write_all(json.as_bytes())?,
    }
    let folder = output.folder("validation");
    files::write(&folder, "validation.json", &json)?;
    let path = files::write(&folder, "report.html", &page(&report))?;
    match output.format {
        Format::Text => writeln!(out, "report {}", path.display())?,
        // Stdout is the result's alone.
        Format::Json => tell(&format!("report {}", path.display())),
    }
    if options.open {
        files::open(&path)?;
    }
    if report.is_as_declared() {
        return Ok(());
    }
    out.flush()?;
    Err(Failure::Undone(format!("{} printed entries are not as declared", undeclared(&report))))
}

fn failure(error: ValidationError) -> Failure {
    match error {
        ValidationError::Unknown { .. } => Failure::Usage(error.to_string()),
        _ => Failure::Undone(error.to_string()),
    }
}

fn rows(report: &ValidationReport) -> impl Iterator<Item = &RowReport> {
    report.results.iter().flat_map(|result| &result.rows)
}

fn undeclared(report: &ValidationReport) -> usize {
    rows(report).filter(|row| !row.as_declared).count()
}

/// The verdict, then each result with its counts and the entries that do not simply agree.
fn text(report: &ValidationReport, all: bool) -> String {
    let count = rows(report).count();
    let mut text = match undeclared(report) {
        0 => format!("AS DECLARED   {count} printed entries"),
        off => format!("NOT AS DECLARED   {off} of {count} printed entries"),
    };
    for (verdict, count) in &report.verdicts {
        let _ = write!(text, "   {count} {verdict}");
    }
    text.push('\n');
    for result in &report.results {
        text.push_str(&result_text(result, all));
    }
    text
}

fn result_text(result: &ResultReport, all: bool) -> String {
    let counts: Vec<String> =
        result.verdicts.iter().map(|(verdict, count)| format!("{count} {verdict}")).collect();
    let mut text = format!("\n{}\n  {}\n  {}", result.title, result.citation, counts.join(", "));
    let within = result.rows.iter().filter(|row| row.tolerance.is_some()).count();
    if within > 0 {
        let _ = write!(
            text,
            "; {within} within a tolerance of their own{}",
            if all { "" } else { " (--all says why)" }
        );
    }
    text.push('\n');
    if let Some(why) = &result.failure {
        let _ = writeln!(text, "  nothing was computed: {why}");
    }
    let head = ["  entry", "unit", "printed", "ours", "off", "verdict", "why"].map(str::to_owned).to_vec();
    let shown = result.rows.iter().filter(|row| all || row.verdict != Verdict::Agrees || !row.as_declared);
    let lines: Vec<Vec<String>> = std::iter::once(head).chain(shown.map(line)).collect();
    if lines.len() > 1 {
        text.push_str(&aligned(&lines));
    }
    for unchecked in &result.cannot_be_checked {
        let _ = writeln!(text, "  cannot be checked: {unchecked}");
    }
    text
}

fn line(row: &RowReport) -> Vec<String> {
    let mut why = row.reason.clone();
    if let (Some(meant), Verdict::Wrong) = (&row.meant, row.verdict) {
        why = format!("{why}; right: {meant}");
    }
    if let (true, Some(tolerance)) = (why.is_empty(), &row.tolerance) {
        why = format!("within {tolerance}");
    }
    let declared = if row.as_declared { String::new() } else { format!(", declared {}", row.declared) };
    vec![
        format!("  {}", row.what),
        row.unit.clone(),
        row.printed.clone(),
        match &row.ours {
            Some(OursReport::Number(number)) => significant(*number),
            Some(OursReport::Word(word)) => word.clone(),
            None => "-".to_owned(),
        },
        row.share.map_or(String::new(), |share| format!("{:.1e}", share.abs())),
        format!("{}{declared}", row.verdict),
        why,
    ]
}

/// To ten digits, without zeros at the end.
fn significant(number: f64) -> String {
    let exponent = format!("{number:.*e}", DIGITS - 1);
    let power: i32 = exponent.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0);
    if number == 0.0 || power < -9 {
        return if number == 0.0 { "0".to_owned() } else { format!("{number:.1e}") };
    }
    let decimals = usize::try_from(DIGITS as i32 - 1 - power).unwrap_or(0);
    let text = format!("{number:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

fn page(report: &ValidationReport) -> String {
    let results: Vec<ValidatedResult> = report.results.iter().map(shown).collect();
    carom_figure::validation_report(&ValidationFigure {
        results: &results,
        verdicts: &Verdict::ALL.map(Verdict::word),
        made_by: concat!("carom ", env!("CARGO_PKG_VERSION")),
    })
}

fn shown(result: &ResultReport) -> ValidatedResult {
    let row = |row: &RowReport| ValidatedRow {
        letter: row.letter.clone(),
        what: row.what.clone(),
        unit: row.unit.clone(),
        printed: row.printed.clone(),
        ours: match &row.ours {
            Some(OursReport::Number(number)) => ValidatedValue::Number(*number),
            Some(OursReport::Word(word)) => ValidatedValue::Word(word.clone()),
            None => ValidatedValue::Nothing,
        },
        share: row.share,
        verdict: row.verdict.word().to_owned(),
        as_declared: row.as_declared,
        reason: row.reason.clone(),
        meant: row.meant.clone(),
        tolerance: row.tolerance.clone(),
    };
    ValidatedResult {
        name: result.name.clone(),
        title: result.title.clone(),
        citation: result.citation.clone(),
        went_in: result.went_in.clone(),
        cannot_be_checked: result.cannot_be_checked.clone(),
        failure: result.failure.clone(),
        rows: result.rows.iter().map(row).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::significant;

    #[test]
    fn ten_digits_and_no_zeros_after_them() {
        assert_eq!(significant(0.625), "0.625", "exact");
        assert_eq!(significant(-31.857_953_768_93), "-31.85795377", "rounded");
        assert_eq!(significant(1200.0), "1200", "whole");
        assert_eq!(significant(3e-17), "3.0e-17", "rounding errors stay small");
        assert_eq!(significant(0.0), "0", "zero");
    }
}
