//! The pages of the book as they are written: what they include, what they show, where they lead.

use super::places;
use crate::{links, tree};
use std::collections::BTreeMap;
use std::path::Path;

/// Where the pages stand.
pub(crate) const SOURCE: &str = "book/src/";
/// What is made, and by no hand.
pub(crate) const MADE: &str = "book/src/generated/";

/// A file or a part of it in the place of a line `{{#include FILE:PART}}`.
#[derive(Debug, PartialEq, Eq)]
struct Inclusion<'t> {
    line: usize,
    file: String,
    part: &'t str,
}

/// Everything that is wrong with the pages, each with its place; `run` are the commands that are run.
pub(crate) fn faults(root: &Path, run: &[String]) -> Result<Vec<String>, String> {
    let files = tree::files(root)?;
    let mut written = BTreeMap::new();
    for page in files.iter().filter(|path| path.starts_with(SOURCE) && path.ends_with(".md")) {
        written.insert(page.as_str(), tree::text(root, page)?.unwrap_or_default());
    }
    let mut found = vec![];
    let mut whole = BTreeMap::new();
    for (page, text) in &written {
        let mut complete = text.clone();
        for inclusion in includes(page, text) {
            match tree::text(root, &inclusion.file) {
                Ok(Some(included)) => {
                    found.extend(is_empty(page, &inclusion, &included));
                    if inclusion.file.ends_with(".md") {
                        complete.push_str(&included);
                    }
                }
                _ => found.push(format!("{page}:{}: {} is not there", inclusion.line, inclusion.file)),
            }
        }
        if !page.starts_with(MADE) {
            found.extend(typed_code(page, text, run));
        }
        whole.insert(*page, complete);
    }
    found.extend(astray(&whole, &files));
    found.extend(unseen(&written, &files));
    Ok(found)
}

/// Links of the pages, included ones in their places, that lead to no page of the book or to no heading there.
///
/// A page of the book leads to pages of the book: nothing else is published with it.
fn astray(whole: &BTreeMap<&str, String>, files: &[String]) -> Vec<String> {
    let in_book: Vec<String> = files.iter().filter(|path| path.starts_with(SOURCE)).cloned().collect();
    let mut found = vec![];
    for (page, text) in whole {
        found.extend(links::broken(page, text, &in_book));
        for link in places::links(page, text) {
            let there =
                whole.get(link.page.as_str()).is_some_and(|to| places::places(to).contains(&link.place));
            if !there {
                found.push(format!("{page}:{}: {} has no heading #{}", link.line, link.page, link.place));
            }
        }
    }
    found
}

/// Pages that the summary does not name, and files that were made and are shown by no page.
fn unseen(written: &BTreeMap<&str, String>, files: &[String]) -> Vec<String> {
    let shown: String = written.values().map(String::as_str).collect();
    let summary = written.get("book/src/SUMMARY.md").map_or("", String::as_str);
    let mut found = vec![];
    for page in written.keys().map(|page| page.trim_start_matches(SOURCE)) {
        let is_part = shown.contains(&format!("{{{{#include ../{page}}}}}"));
        if page != "SUMMARY.md" && !is_part && !summary.contains(&format!("]({page})")) {
            found.push(format!("{SOURCE}{page}: SUMMARY.md does not name it"));
        }
    }
    let made = files.iter().filter(|file| file.starts_with(MADE) && !file.ends_with(".md"));
    let unused = made.filter(|file| !shown.contains(file.trim_start_matches(MADE)));
    found.extend(unused.map(|file| format!("{file}: no page shows it")));
    found
}

fn includes<'t>(page: &str, text: &'t str) -> impl Iterator<Item = Inclusion<'t>> {
    text.lines().enumerate().filter_map(move |(n, line)| {
        let inside = line.trim().strip_prefix("{{#include ")?.strip_suffix("}}")?.trim();
        let (file, part) = inside.split_once(':').unwrap_or((inside, ""));
        Some(Inclusion { line: n + 1, file: links::leads_to(page, file), part })
    })
}

/// A part that begins behind the end of its file or with an empty line, or whose name is not in it: the page would
/// show nothing, or not what was meant.
fn is_empty(page: &str, inclusion: &Inclusion, text: &str) -> Option<String> {
    let first = inclusion.part.split(':').next().unwrap_or_default();
    let holds = match first.parse::<usize>() {
        _ if first.is_empty() => true,
        Ok(line) => text.lines().nth(line.saturating_sub(1)).is_some_and(|line| !line.trim().is_empty()),
        // The mark ends its line, but for the end of a comment.
        Err(_) => text.lines().any(|line| {
            let line = line.trim_end().trim_end_matches("-->").trim_end();
            line.strip_suffix(first).is_some_and(|before| before.ends_with("ANCHOR: "))
        }),
    };
    (!holds).then(|| format!("{page}:{}: {} has no part {first}", inclusion.line, inclusion.file))
}

/// Code that stands in a page and in no tested file.
///
/// Blocks hold an inclusion and nothing else. What a reader types into a shell may stand there, where each command of
/// ours is one that is run.
fn typed_code(page: &str, text: &str, run: &[String]) -> Vec<String> {
    let mut found = vec![];
    let mut block: Option<&str> = None;
    for (n, line) in text.lines().enumerate() {
        if let Some(kind) = line.trim_start().strip_prefix("```") {
            block = if block.is_some() { None } else { Some(kind) };
            continue;
        }
        let Some(kind) = block else { continue };
        let line = line.trim();
        let is_fine = match kind {
            "sh" => !line.starts_with("carom ") || run.iter().any(|known| known == line),
            _ => line.starts_with("{{#include ") && line.ends_with("}}"),
        };
        if !is_fine {
            found.push(format!("{page}:{}: code that no test runs: {line}", n + 1));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_is_included_or_run() {
        let run = ["carom run a.toml".to_owned()];
        let fine = "```text\n{{#include a.txt}}\n```\n```sh\ncargo build\ncarom run a.toml\n```\n";
        assert!(typed_code("book/src/a.md", fine, &run).is_empty(), "included, or run");
        let typed = "```toml\nmass = 1\n```\n```sh\ncarom run b.toml\n```\nmass = 1\n";
        assert_eq!(typed_code("book/src/a.md", typed, &run).len(), 2, "typed, and not run");
    }

    #[test]
    fn inclusions_are_followed_from_their_page() {
        let text = "{{#include ../../examples/a.toml}}\n  {{#include generated/b.txt:1:3}}\n";
        let found: Vec<Inclusion> = includes("book/src/a.md", text).collect();
        assert_eq!(found[0].file, "examples/a.toml", "from the page's folder");
        assert_eq!((found[1].file.as_str(), found[1].part), ("book/src/generated/b.txt", "1:3"), "its lines");
    }

    #[test]
    fn parts_that_are_not_there_are_found() {
        let text = "one\n# ANCHOR: two\nthree\n\n";
        let is_there =
            |part| is_empty("a.md", &Inclusion { line: 1, file: "b".to_owned(), part }, text).is_none();
        for part in ["", "3:", ":2", "two"] {
            assert!(is_there(part), "{part} is there");
        }
        for part in ["4:", "tw", "one"] {
            assert!(!is_there(part), "{part} is not");
        }
    }

    #[test]
    fn pages_lead_to_pages_and_headings() {
        let pages = BTreeMap::from([
            ("book/src/a.md", "# One\n[x](b.md#two) [y](#one)".to_owned()),
            ("book/src/b.md", "# Two\n[x](a.md#two) [y](../../README.md)".to_owned()),
        ]);
        let files = ["README.md", "book/src/a.md", "book/src/b.md"].map(str::to_owned);
        assert_eq!(
            astray(&pages, &files).len(),
            2,
            "a heading that is not there, and a page outside the book"
        );
    }

    #[test]
    fn every_page_and_every_figure_is_seen() {
        let summary = "[A](a.md)".to_owned();
        let pages = BTreeMap::from([
            ("book/src/SUMMARY.md", summary),
            ("book/src/a.md", "![x](generated/figures/a.svg)".to_owned()),
            ("book/src/b.md", String::new()),
        ]);
        let files =
            ["book/src/generated/figures/a.svg", "book/src/generated/figures/b.svg"].map(str::to_owned);
        assert_eq!(unseen(&pages, &files).len(), 2, "b.md and b.svg");
    }
}
