//! What the engine's answers are called, and what is said of them in a sentence.
//!
//! The engine answers in types: outcomes, ends of stages, rejected hypotheses. Here each of them gets its word or its sentence, once. Results in JSON,
//! pages, drawings and the terminal all take it from here, so that they say the same.
//!
//! - [`Words`]: the enums whose values have one word each, as files and tables have it;
//! - [`part`]: names of plates, walls and of the features of a part; [`run`]: the verdict of a run and why its stages end;
//! - [`impact`], [`impact_space`]: what contacts do in an impact, why its stages end and why hypotheses fail;
//! - [`roll_space`]: what bodies in space do that roll, rock and rest;
//! - [`study`]: how drops end, as maps and yields name it; [`number`]: numbers as text.

mod enums;
pub mod impact;
pub mod impact_space;
pub mod number;
pub mod part;
pub mod roll_space;
pub mod run;
pub mod study;

pub use enums::Words;

/// "A", "A and B", "A, B and C"; `none` where there is nothing to list.
///
/// # Example
/// ```
/// assert_eq!(carom_words::list(&["A", "B", "C"], "none"), "A, B and C");
/// assert_eq!(carom_words::list::<&str>(&[], "none"), "none");
/// ```
pub fn list<T: AsRef<str>>(items: &[T], none: &str) -> String {
    let text = |items: &[T]| items.iter().map(AsRef::as_ref).collect::<Vec<_>>().join(", ");
    match items {
        [] => none.to_owned(),
        [one] => one.as_ref().to_owned(),
        [first @ .., last] => format!("{} and {}", text(first), last.as_ref()),
    }
}

/// Rows with their columns aligned, two blanks between.
///
/// # Example
/// ```
/// let rows = [["plate", "m/s"], ["upper", "0.5"]].map(|row| row.map(str::to_owned).to_vec());
/// assert_eq!(carom_words::aligned(&rows), "plate  m/s\nupper  0.5\n");
/// ```
pub fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let cells = row.iter().zip(&widths).map(|(cell, width)| {
            let blank = width - cell.chars().count();
            format!("{cell}{}", " ".repeat(blank))
        });
        text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
        text.push('\n');
    }
    text
}

/// The name of contact `i`; "?" where there is no such contact.
fn named<T: AsRef<str>>(names: &[T], i: usize) -> &str {
    names.get(i).map_or("?", AsRef::as_ref)
}
