//! The book: what it shows of the program is made by running the program, and held to it.

mod commands;
mod contacts;
mod figures;
mod pages;
mod places;
mod schemas;
mod transcripts;

use crate::{examples, metadata, steps, tree};
use commands::{Step, Transcript};
use pages::MADE;
use std::fs;
use std::path::Path;
use transcripts::Desk;

/// Where the schemas are, for editors and other programs.
const SCHEMAS: &str = "schemas/";

/// The contacts that go by the names of their materials.
const CONTACTS: &str = "crates/carom-scene/src/contacts.toml";

/// A drawing is no larger than this, and all that is made together no larger than the second number [bytes].
const LARGEST: (usize, usize) = (100_000, 1_000_000);

/// A file that the program made: of the book, or a schema. Its path is that in the project.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Made {
    pub(crate) path: String,
    pub(crate) text: String,
}

/// Makes everything anew and says what differs from what is there, and what is wrong with the pages.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    let list = list(root)?;
    let made = make(root, &list)?;
    let mut found = vec![];
    for file in &made {
        let path = &file.path;
        match fs::read_to_string(root.join(path)) {
            Ok(there) if there == file.text => {}
            Ok(there) => found.push(difference(path, &there, &file.text)),
            Err(_) => found.push(format!("{path}: it is not there")),
        }
    }
    found.extend(left_over(root, &made)?.into_iter().map(|path| format!("{path}: nothing makes it")));
    if !found.is_empty() {
        found.push("`cargo xtask book` makes them anew".to_owned());
    }
    found.extend(pages::faults(root, &lines(&list, &made))?);
    let size: usize = made.iter().map(|file| file.text.len()).sum();
    if found.is_empty() {
        Ok(format!("{} files of the book and schemas, {} kB", made.len(), size.div_ceil(1000)))
    } else {
        Err(found.join("\n"))
    }
}

/// Makes everything anew, writes it, and removes what is left over.
pub(crate) fn write(root: &Path) -> Result<String, String> {
    let list = list(root)?;
    let made = make(root, &list)?;
    for path in left_over(root, &made)? {
        fs::remove_file(root.join(&path)).map_err(|problem| format!("{path}: {problem}"))?;
    }
    for file in &made {
        let path = root.join(&file.path);
        let folder = path.parent().unwrap_or(root);
        fs::create_dir_all(folder)
            .and_then(|()| fs::write(&path, &file.text))
            .map_err(|problem| format!("{}: {problem}", path.display()))?;
    }
    let faults = pages::faults(root, &lines(&list, &made))?;
    if faults.is_empty() { Ok(format!("{} files of the book", made.len())) } else { Err(faults.join("\n")) }
}

fn list(root: &Path) -> Result<Vec<Transcript>, String> {
    let path = "book/commands.txt";
    let text = fs::read_to_string(root.join(path)).map_err(|problem| format!("{path}: {problem}"))?;
    commands::parse(&text).map_err(|problem| format!("{path}:\n{problem}"))
}

/// Every command line that is run, those for the reference pages among them.
fn lines(list: &[Transcript], made: &[Made]) -> Vec<String> {
    let pages = made
        .iter()
        .filter_map(|file| file.path.strip_prefix(MADE)?.strip_prefix("reference/")?.strip_suffix(".md"));
    let schemas = pages.map(|name| format!("carom schema {name}"));
    let steps = list.iter().flat_map(|transcript| &transcript.steps);
    let commands = steps.filter_map(|step| match step {
        Step::Run { line, .. } => Some(line.clone()),
        Step::Figure { .. } | Step::Keep(_) => None,
    });
    commands.chain(schemas).collect()
}

/// Everything that is made, in order of its path.
fn make(root: &Path, list: &[Transcript]) -> Result<Vec<Made>, String> {
    steps::cargo(root, &["build", "--release", "--package", "carom-cli"])?;
    let target = metadata::workspace(root)?.target;
    let program = target.join("release").join(format!("carom{}", std::env::consts::EXE_SUFFIX));
    let desk = Desk::lay_out(root, program, target.join("book"))?;
    let mut made = reference(root, &desk)?;
    for transcript in list {
        let files = transcripts::make(&desk, transcript)?.into_iter();
        made.extend(files.map(|file| Made { path: format!("{MADE}{}", file.path), ..file }));
    }
    made.sort_by(|a, b| a.path.cmp(&b.path));
    match too_large(&made) {
        None => Ok(made),
        Some(problem) => Err(problem),
    }
}

/// The reference pages: one for each schema, one of all commands, the tables of the examples and of the contacts.
fn reference(root: &Path, desk: &Desk) -> Result<Vec<Made>, String> {
    let mut helps = vec![];
    for command in schemas::commands(&desk.ask("carom help")?.0) {
        helps.push((command.clone(), desk.ask(&format!("carom help {command}"))?.0));
    }
    let mut made = vec![Made { path: format!("{MADE}reference/options.md"), text: schemas::options(&helps) }];
    let mut shipped = vec![];
    for path in tree::files(root)?.into_iter().filter(|path| examples::is_example(path)) {
        let text = tree::text(root, &path)?.unwrap_or_default();
        shipped.push((path, text));
    }
    made.push(Made { path: format!("{MADE}reference/examples.md"), text: schemas::examples(&shipped) });
    let named = tree::text(root, CONTACTS)?.unwrap_or_default();
    made.push(Made { path: format!("{MADE}reference/contacts.md"), text: contacts::page(&named) });
    for name in schemas::values(&desk.ask("carom help schema")?.0) {
        let (said, _) = desk.ask(&format!("carom schema {name}"))?;
        let schema = serde_json::from_str(&said).map_err(|problem| format!("schema {name}: {problem}"))?;
        made.push(Made { path: format!("{MADE}reference/{name}.md"), text: schemas::page(&name, &schema) });
        made.push(Made { path: format!("{SCHEMAS}carom-{name}.schema.json"), text: said });
    }
    Ok(made)
}

fn too_large(made: &[Made]) -> Option<String> {
    if let Some(file) = made.iter().find(|file| file.path.ends_with(".svg") && file.text.len() > LARGEST.0) {
        return Some(format!("{}: {} bytes, {} allowed", file.path, file.text.len(), LARGEST.0));
    }
    let of_book = made.iter().filter(|file| file.path.starts_with(MADE));
    let size: usize = of_book.map(|file| file.text.len()).sum();
    (size > LARGEST.1).then(|| format!("{size} bytes are made, {} allowed", LARGEST.1))
}

/// Files among those that are made which are not.
fn left_over(root: &Path, made: &[Made]) -> Result<Vec<String>, String> {
    let files = tree::files(root)?;
    let is_made = |path: &str| made.iter().any(|file| file.path == path);
    let is_ours = |path: &str| path.starts_with(MADE) || path.starts_with(SCHEMAS);
    Ok(files.into_iter().filter(|path| is_ours(path) && !is_made(path)).collect())
}

/// The first line in which two texts differ, as a person looks for it.
fn difference(path: &str, there: &str, made: &str) -> String {
    let mut number = 1;
    let (mut old, mut new) = (there.lines(), made.lines());
    loop {
        match (old.next(), new.next()) {
            (Some(a), Some(b)) if a == b => number += 1,
            (a, b) => {
                let shown =
                    |line: Option<&str>| line.unwrap_or("(its end)").chars().take(160).collect::<String>();
                return format!(
                    "{path}:{number}: not what the program makes now\n  there  {}\n  now    {}",
                    shown(a),
                    shown(b)
                );
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_line_that_differs_is_named() {
        let said = difference("a.txt", "one\ntwo\n", "one\nthree\n");
        assert!(said.starts_with("a.txt:2:") && said.contains("two") && said.contains("three"), "{said}");
        assert!(difference("a.txt", "one\n", "one\ntwo\n").contains("(its end)"), "a line more");
    }

    #[test]
    fn drawings_and_the_whole_have_a_size() {
        let file = |path: &str, size: usize| Made { path: path.to_owned(), text: "x".repeat(size) };
        assert!(too_large(&[file("figures/a.svg", LARGEST.0)]).is_none(), "just so large");
        assert!(too_large(&[file("figures/a.svg", LARGEST.0 + 1)]).is_some(), "a drawing");
        assert!(too_large(&[file(&format!("{MADE}a.txt"), LARGEST.1 + 1)]).is_some(), "all together");
        assert!(
            too_large(&[file("schemas/a.json", LARGEST.1 + 1)]).is_none(),
            "schemas are none of the book"
        );
    }
}
