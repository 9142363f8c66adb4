//! What goes to stdout: all of it after the files are written, and nothing in it that a terminal obeys.

use serde::Serialize;
use std::borrow::Cow;
use std::fmt::Write as _;
use std::io::{Result, Write};
use std::path::PathBuf;

/// The text with every control character but the ends of lines and tabs written out as TOML and JSON write it: a name is shown, not obeyed.
pub(crate) fn visible(text: &str) -> Cow<'_, str> {
    let obeyed = |c: char| c.is_control() && !matches!(c, '\n' | '\t');
    if !text.contains(obeyed) {
        return Cow::Borrowed(text);
    }
    let shown = text.chars().map(|c| match c {
        c if obeyed(c) => format!("\\u{:04X}", u32::from(c)),
        c => c.to_string(),
    });
    Cow::Owned(shown.collect())
}

/// The notes of a scene, a line each.
pub(crate) fn notes(notes: &[String]) -> String {
    notes.iter().map(|note| format!("note: {note}\n")).collect()
}

/// A text, and below it the files that were written.
pub(crate) fn with_files(mut text: String, files: &[PathBuf]) -> String {
    for file in files {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{}", file.display());
    }
    text
}

/// Results as JSON: one scene is an object, several are a list of them.
pub(crate) fn results<R: Serialize>(reports: &[R]) -> serde_json::Result<String> {
    match reports {
        [one] => serde_json::to_string_pretty(one),
        several => serde_json::to_string_pretty(several),
    }
}

/// A folder for each of these scenes: scenes of one name from several folders must not write over each other.
pub(crate) fn folders<'n>(names: impl Iterator<Item = &'n str>) -> Vec<String> {
    let names: Vec<&str> = names.collect();
    let folder = |(i, name): (usize, &&str)| match names[..i].iter().filter(|other| *other == name).count() {
        0 => (*name).to_owned(),
        before => format!("{name}-{}", before + 1),
    };
    names.iter().enumerate().map(folder).collect()
}

/// An output for people, on which every text is [`visible`].
pub(crate) struct Visible<W>(pub(crate) W);

impl<W: Write> Write for Visible<W> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        // Texts come whole; what is no text has no control characters that are read as such.
        match std::str::from_utf8(bytes) {
            Ok(text) => self.0.write_all(visible(text).as_bytes())?,
            Err(_) => self.0.write_all(bytes)?,
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<()> {
        self.0.flush()
    }
}

/// Writes a line to stderr; there is nowhere to report that it is closed.
pub(crate) fn tell(line: &str) {
    let _ = writeln!(std::io::stderr(), "{}", visible(line.trim_end()));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_of_one_name_have_folders_of_their_own() {
        assert_eq!(folders(["a", "b", "a", "a"].into_iter()), ["a", "b", "a-2", "a-3"]);
    }

    #[test]
    fn a_terminal_is_told_nothing_by_a_name() {
        assert_eq!(
            visible("plate \u{1b}[31mred\u{9b}0m\r\n"),
            "plate \\u001B[31mred\\u009B0m\\u000D\n",
            "escaped"
        );
        assert_eq!(visible("µ\tΔ\n"), "µ\tΔ\n", "as it is");
        let mut out = Visible(vec![]);
        write!(out, "{}°", char::from(7)).unwrap();
        assert_eq!(out.0, "\\u0007°".as_bytes(), "on the way out");
    }
}
