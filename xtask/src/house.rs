//! What a newcomer meets in the sources: hidden lines in the docs, long functions without a word of why, small numbers without a name.

mod doc_comments;
mod functions;
mod tolerances;

use crate::{source, tree};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::AddAssign;
use std::path::Path;

/// A function of this length needs a comment that says why [lines].
const LONG: usize = 30;
/// Fewer lines of the docs than this are hidden.
const HIDDEN_BELOW: usize = 500;
/// At least this share of long functions has a comment of its own line [%].
const WHYS_LEAST: usize = 70;

/// What is counted, of one crate or of all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Counts {
    hidden: usize,
    long: usize,
    explained: usize,
    bare: usize,
    one_line: usize,
    docs_of_one_line: usize,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.hidden += other.hidden;
        self.long += other.long;
        self.explained += other.explained;
        self.bare += other.bare;
        self.one_line += other.one_line;
        self.docs_of_one_line += other.docs_of_one_line;
    }
}

impl Counts {
    /// Long functions with a comment, in whole percent, rounded down; all of none.
    fn whys(&self) -> usize {
        (100 * self.explained).checked_div(self.long).unwrap_or(100)
    }
}

/// The figures of every crate, and each place behind them.
struct House {
    crates: BTreeMap<String, Counts>,
    /// Long functions without a comment.
    unexplained: Vec<String>,
    bare: Vec<String>,
}

/// The figures as a table; with `list` each long function without a comment and each bare tolerance too.
pub(crate) fn report(root: &Path, list: bool) -> Result<String, String> {
    let house = read(root)?;
    let mut out = format!(
        "{:<18}{:>8}{:>8}{:>10}{:>7}{:>7}{:>10}{:>12}\n",
        "crate", "hidden", "long", "explained", "whys", "bare", "one-line", "their docs"
    );
    let all = ("all".to_owned(), house.all());
    for (name, counts) in house.crates.iter().map(|(name, counts)| (name.clone(), *counts)).chain([all]) {
        let Counts { hidden, long, explained, bare, one_line, docs_of_one_line } = counts;
        let whys = counts.whys();
        let row = format!(
            "{name:<18}{hidden:>8}{long:>8}{explained:>10}{whys:>5} %{bare:>7}{one_line:>10}{docs_of_one_line:>12}"
        );
        // Writing to a string cannot fail.
        let _written = writeln!(out, "{row}");
    }
    if list {
        for place in house.unexplained.iter().chain(&house.bare) {
            let _written = writeln!(out, "{place}");
        }
    }
    Ok(out)
}

/// What breaks a limit, for the step `rules`.
pub(crate) fn faults(root: &Path) -> Result<Vec<String>, String> {
    let house = read(root)?;
    let mut found: Vec<String> = house.bare.clone();
    let all = house.all();
    if all.hidden >= HIDDEN_BELOW {
        found.push(format!(
            "{} hidden lines in doc examples, fewer than {HIDDEN_BELOW} allowed: show the set-up, shorten it or leave the example out",
            all.hidden
        ));
    }
    if all.whys() < WHYS_LEAST {
        found.push(format!(
            "{} % of the functions of {LONG} lines and more say why, {WHYS_LEAST} % at least: `cargo xtask house --list` names the others",
            all.whys()
        ));
    }
    Ok(found)
}

impl House {
    fn all(&self) -> Counts {
        self.crates.values().fold(Counts::default(), |mut sum, counts| {
            sum += *counts;
            sum
        })
    }

    fn take(&mut self, path: &str, text: &str) {
        let Some(name) = crate_of(path) else { return };
        let functions = functions::functions(text);
        let long: Vec<_> = functions.iter().filter(|function| function.lines >= LONG).collect();
        let silent: Vec<_> = long.iter().filter(|function| function.comment_lines == 0).collect();
        let one_line: Vec<_> =
            functions.iter().filter(|function| function.is_public && function.body_lines == 1).collect();
        let bare = tolerances::bare(&source::code_without_tests(text));
        *self.crates.entry(name.to_owned()).or_default() += Counts {
            hidden: doc_comments::hidden_lines(text),
            long: long.len(),
            explained: long.len() - silent.len(),
            bare: bare.len(),
            one_line: one_line.len(),
            docs_of_one_line: one_line.iter().map(|function| function.doc_lines).sum(),
        };
        self.unexplained.extend(silent.iter().map(|function| {
            format!("{path}:{}: `{}` has {} lines and no why", function.line, function.name, function.lines)
        }));
        self.bare.extend(bare.iter().map(|bare| {
            format!(
                "{path}:{}: {} has no name: put a constant into the crate's `tolerance` module, with unit and reason",
                bare.line, bare.literal
            )
        }));
    }
}

fn read(root: &Path) -> Result<House, String> {
    let mut texts = vec![];
    for path in tree::files(root)? {
        if crate_of(&path).is_some()
            && let Some(text) = tree::text(root, &path)?
        {
            texts.push((path, text));
        }
    }
    let for_tests: Vec<String> = texts.iter().flat_map(|(path, text)| test_modules(path, text)).collect();
    let mut house = House { crates: BTreeMap::new(), unexplained: vec![], bare: vec![] };
    for (path, text) in &texts {
        let module = path.trim_end_matches(".rs").trim_end_matches("/mod");
        if !for_tests.iter().any(|test| is_in(module, test)) {
            house.take(path, text);
        }
    }
    Ok(house)
}

/// The crate of a source file in `crates/` or `apps/`; `None` for its tests and examples, and for other files.
fn crate_of(path: &str) -> Option<&str> {
    let rest = path.strip_prefix("crates/").or_else(|| path.strip_prefix("apps/"))?;
    let (name, inside) = rest.split_once('/')?;
    (inside.starts_with("src/") && inside.ends_with(".rs")).then_some(name)
}

/// Paths without ending of the modules that a file includes for its tests alone: `#[cfg(test)] mod tests;`.
fn test_modules(path: &str, text: &str) -> Vec<String> {
    let stem = path.trim_end_matches(".rs");
    let folder = ["/mod", "/lib", "/main"].iter().find_map(|root| stem.strip_suffix(root)).unwrap_or(stem);
    let code = source::code(text);
    let marked = code.match_indices("#[cfg(test)]").map(|(at, mark)| code[at + mark.len()..].trim_start());
    let declared = marked.filter_map(|item| {
        let (head, _) = item.split_once([';', '{'])?;
        let name = head.rsplit_once("mod ")?.1.trim();
        Some(format!("{folder}/{name}"))
    });
    declared.collect()
}

fn is_in(module: &str, folder: &str) -> bool {
    module.strip_prefix(folder).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}

#[cfg(test)]
mod tests {
    use super::*;

    const PATH: &str = "crates/carom-num/src/a.rs";

    fn house(text: &str) -> House {
        let mut house = House { crates: BTreeMap::new(), unexplained: vec![], bare: vec![] };
        house.take(PATH, text);
        house
    }

    fn function_of(lines: usize, comment: &str) -> String {
        format!("fn a() {{\n{comment}{}}}\n", "    b();\n".repeat(lines - 2 - comment.lines().count()))
    }

    #[test]
    fn long_functions_without_a_why_are_listed() {
        let silent = house(&function_of(LONG, ""));
        assert_eq!(silent.unexplained.len(), 1, "thirty lines and no comment");
        assert!(silent.unexplained[0].starts_with("crates/carom-num/src/a.rs:1: `a`"), "with its place");
        assert_eq!(silent.all().whys(), 0, "none of one");
        assert_eq!(house(&function_of(LONG, "    // Why.\n")).all().whys(), 100, "one of one");
        assert_eq!(house(&function_of(LONG - 1, "")).all().long, 0, "29 lines are not long");
    }

    #[test]
    fn bare_tolerances_are_listed_with_what_to_do() {
        let found = house("fn a() -> bool {\n    x < 1e-9\n}\n").bare;
        assert_eq!(found.len(), 1, "one literal");
        assert!(
            found[0].starts_with("crates/carom-num/src/a.rs:2: 1e-9 has no name"),
            "its place: {}",
            found[0]
        );
    }

    #[test]
    fn tests_and_other_files_are_left_out() {
        for path in ["crates/carom-num/tests/a.rs", "crates/carom-num/Cargo.toml", "xtask/src/main.rs"] {
            assert_eq!(crate_of(path), None, "{path}");
        }
        let included = test_modules("crates/a/src/b.rs", "#[cfg(test)]\npub(crate) mod faults;\nmod c;\n");
        assert_eq!(included, ["crates/a/src/b/faults"], "the module that is for tests");
        assert_eq!(
            test_modules("crates/a/src/mod.rs", "#[cfg(test)] mod tests;"),
            ["crates/a/src/tests"],
            "of a root"
        );
        assert!(is_in("crates/a/src/tests/more", "crates/a/src/tests"), "what lies in it too");
        assert!(!is_in("crates/a/src/tests_of", "crates/a/src/tests"), "another name is another module");
    }
}
