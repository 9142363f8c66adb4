//! One problem a line in, one answer a line out: how a program asks for many things at once.

use crate::failure::Failure;
use carom_scene::LineError;
use std::io::{BufRead, Write};
use std::path::Path;

/// Answers every line that is not empty, in order. A line with problems is answered by a [`LineError`] and the rest go on;
/// the exit code says in the end that there were such lines.
///
/// `answer` is given the name of the line, under which its problems are reported, and its text.
pub(crate) fn answer_lines(
    input: &mut impl BufRead,
    out: &mut impl Write,
    answer: impl Fn(&str, &str) -> Result<String, Failure>,
) -> Result<(), Failure> {
    let mut bad = 0usize;
    // A bad line is answered in its place: the program that asks counts on one answer a line.
    for (i, line) in input.lines().enumerate() {
        let line = line.map_err(|error| Failure::file("read", Path::new("stdin"), &error))?;
        if line.trim().is_empty() {
            continue;
        }
        let text = match answer(&format!("line {}", i + 1), &line) {
            Ok(text) => text,
            Err(Failure::Input(list)) => {
                bad += 1;
                serde_json::to_string(&LineError::of_input(i + 1, &list))?
            }
            Err(Failure::Undone(message) | Failure::Usage(message)) => {
                bad += 1;
                serde_json::to_string(&LineError::of_failure(i + 1, message))?
            }
            Err(other) => return Err(other),
        };
        writeln!(out, "{text}")?;
    }
    match bad {
        0 => Ok(()),
        1 => Err(Failure::Usage("1 line has problems".into())),
        bad => Err(Failure::Usage(format!("{bad} lines have problems"))),
    }
}
