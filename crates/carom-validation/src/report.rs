//! What a validation says, as JSON.

use crate::failure::ValidationError;
use crate::judge::compare;
use crate::table::{Row, Table, Verdict};
use crate::value::{Value, Values};
use schemars::{JsonSchema, Schema};
use serde::Serialize;
use std::collections::BTreeMap;

/// A value of ours: a number in the row's unit, or an outcome by its name.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OursReport {
    /// In the row's unit.
    Number(f64),
    /// By its name.
    Word(String),
}

/// One printed entry beside ours.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RowReport {
    /// Its name.
    pub key: String,
    /// The source's letter for it; empty where it has none.
    pub letter: String,
    /// What it is.
    pub what: String,
    /// Unit of what is printed and of ours; empty of pure numbers and of words.
    pub unit: String,
    /// As it is printed; of a formula its value.
    pub printed: String,
    /// What the engine says; null where it says nothing.
    pub ours: Option<OursReport>,
    /// Ours less what is printed; null of words.
    pub difference: Option<f64>,
    /// The difference as a share of the larger of the two; null of words, and where zero is printed and meant.
    pub share: Option<f64>,
    /// What the numbers say: agrees, coarse in print, misprint, wrong in print, beyond the model or fails.
    #[schemars(with = "String")]
    pub verdict: Verdict,
    /// What the table declares.
    #[schemars(with = "String")]
    pub declared: Verdict,
    /// True where the two are the same.
    pub as_declared: bool,
    /// What is meant or right instead, where the table says so.
    pub meant: Option<String>,
    /// Why; empty where it agrees.
    pub reason: String,
    /// What ours may be off, and why, where that is not half of the last printed digit.
    pub tolerance: Option<String>,
}

/// A published result beside ours.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ResultReport {
    /// Its name: the folder in `validation/`.
    pub name: String,
    /// In a few words.
    pub title: String,
    /// Where it is published.
    pub citation: String,
    /// What went in, SI.
    pub went_in: Vec<String>,
    /// What of it cannot be checked, and why.
    pub cannot_be_checked: Vec<String>,
    /// Why the engine computed nothing; null where it did.
    pub failure: Option<String>,
    /// How many rows there are of each verdict.
    #[schemars(with = "BTreeMap<String, usize>")]
    pub verdicts: BTreeMap<Verdict, usize>,
    /// True where every row is as it is declared.
    pub as_declared: bool,
    /// The printed entries.
    pub rows: Vec<RowReport>,
}

/// Published results beside ours.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom validate")]
pub struct ValidationReport {
    /// as declared, or not as declared.
    pub outcome: &'static str,
    /// How many rows there are of each verdict.
    #[schemars(with = "BTreeMap<String, usize>")]
    pub verdicts: BTreeMap<Verdict, usize>,
    /// The results.
    pub results: Vec<ResultReport>,
}

/// The JSON Schema of a [`ValidationReport`].
pub fn schema() -> Schema {
    carom_scene::schema::of::<ValidationReport>()
}

impl ValidationReport {
    pub(crate) fn new(results: Vec<ResultReport>) -> Self {
        let all = results.iter().all(|result| result.as_declared);
        Self {
            outcome: if all { "as declared" } else { "not as declared" },
            verdicts: counted(results.iter().flat_map(|result| &result.rows)),
            results,
        }
    }

    /// True where every row of every result is as it is declared.
    pub fn is_as_declared(&self) -> bool {
        self.results.iter().all(|result| result.as_declared)
    }
}

impl ResultReport {
    /// Joins a table with what the engine says.
    pub(crate) fn new(name: &str, table: Table, computed: Result<Values, ValidationError>) -> Self {
        let failure = match &computed {
            Err(error) => Some(error.to_string()),
            Ok(values) => unasked(&table, values),
        };
        let values = computed.unwrap_or_default();
        let rows: Vec<RowReport> =
            table.rows.iter().map(|row| row_report(row, &table, values.get(&row.key))).collect();
        Self {
            name: name.to_owned(),
            title: table.title,
            citation: table.citation,
            went_in: table.went_in,
            cannot_be_checked: table.cannot_be_checked,
            verdicts: counted(&rows),
            as_declared: failure.is_none() && rows.iter().all(|row| row.as_declared),
            failure,
            rows,
        }
    }
}

/// What was computed though no row asks for it, or two rows do.
fn unasked(table: &Table, values: &Values) -> Option<String> {
    let rows = |key: &str| table.rows.iter().filter(|row| row.key == key).count();
    let odd: Vec<&str> = values.keys().filter(|key| rows(key) != 1).collect();
    (!odd.is_empty()).then(|| format!("not asked for by one row each: {}", odd.join(", ")))
}

fn counted<'r>(rows: impl IntoIterator<Item = &'r RowReport>) -> BTreeMap<Verdict, usize> {
    let mut counts = BTreeMap::new();
    for row in rows {
        *counts.entry(row.verdict).or_default() += 1;
    }
    counts
}

fn row_report(row: &Row, table: &Table, ours: Option<&Value>) -> RowReport {
    let compared = ours.map(|ours| compare(row, table.coarse.as_ref(), ours));
    let verdict = compared.as_ref().map_or(Verdict::Fails, |found| found.verdict);
    let difference = compared.as_ref().and_then(|found| found.difference);
    let share = match (difference, ours) {
        (Some(difference), Some(Value::Number(ours))) => {
            let printed = ours - difference;
            // Of what is zero in print, rounding would be the whole.
            let is_zero = printed == 0.0 && verdict == Verdict::Agrees;
            if is_zero { None } else { Some(difference / ours.abs().max(printed.abs())) }
        }
        _ => None,
    };
    RowReport {
        key: row.key.clone(),
        letter: row.letter.clone(),
        what: row.what.clone(),
        unit: row.unit.clone(),
        printed: row.printed.clone(),
        ours: ours.map(|ours| match ours {
            Value::Number(number) => OursReport::Number(*number),
            Value::Word(word) => OursReport::Word(word.clone()),
        }),
        difference,
        share,
        verdict,
        declared: row.expected,
        as_declared: verdict == row.expected,
        meant: row.meant.clone(),
        reason: compared.map_or("the engine says nothing of it".to_owned(), |found| found.reason),
        tolerance: row.tolerance.as_ref().map(|t| {
            let unit = if row.unit.is_empty() { String::new() } else { format!(" {}", row.unit) };
            format!("{}{unit}: {}", t.within, t.why)
        }),
    }
}
