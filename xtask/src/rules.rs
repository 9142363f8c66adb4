//! What the project's files may contain.

use crate::{house, links, markup, paths, source, tree};
use std::path::Path;

/// Longest source file [lines].
const LONGEST: usize = 400;
/// Names that say nothing about what a module holds.
const EMPTY_NAMES: [&str; 8] =
    ["common", "handlers", "helper", "helpers", "manager", "misc", "util", "utils"];

/// Something that only some crates below `apps/` may do.
struct Reserved {
    what: &'static str,
    named: &'static [&'static str],
    home: Option<&'static str>,
}

const RESERVED: [Reserved; 5] = [
    Reserved {
        what: "prints",
        named: &[
            "print!",
            "println!",
            "eprint!",
            "eprintln!",
            "std::io::stdout",
            "std::io::stderr",
            "io::stdout",
            "io::stderr",
        ],
        home: None,
    },
    Reserved { what: "touches files", named: &["std::fs", "fs"], home: Some("carom-scene") },
    Reserved {
        what: "starts threads",
        named: &["std::thread", "thread", "rayon"],
        home: Some("carom-study"),
    },
    Reserved {
        what: "reads a clock",
        named: &["std::time", "core::time", "Instant", "SystemTime"],
        home: None,
    },
    Reserved {
        what: "asks the system",
        named: &["std::env", "std::net", "std::process", "env::var", "env::args"],
        home: None,
    },
];

/// The one file that may allow what counts as unsafe: the names that the module of the studio exports and imports.
const EXPORTED_NAMES: &str = "apps/carom-web/src/abi.rs";
/// The one file that may follow pointers: the functions that C calls.
const POINTERS: &str = "apps/carom-c/src/abi.rs";

/// Places on the machine of whoever wrote a file, in two halves so that this list does not find itself.
const MACHINE_PATHS: [(&str, &str); 6] =
    [("/ho", "me/"), ("/ro", "ot/"), ("/Us", "ers/"), ("/tm", "p/"), ("/wo", "rk/"), (":\\Us", "ers\\")];

/// Checks every file of the project.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    let files = tree::files(root)?;
    let mut found = vec![];
    let mut longest = (0, "");
    for path in &files {
        let Some(text) = tree::text(root, path)? else { continue };
        found.extend(faults(path, &text));
        if path.ends_with(".md") {
            found.extend(links::broken(path, &text, &files));
        }
        let lines = text.lines().count();
        if is_source(path) && lines > longest.0 {
            longest = (lines, path);
        }
    }
    found.extend(house::faults(root)?);
    if found.is_empty() {
        Ok(format!("{} files; the longest source file is {} ({} lines)", files.len(), longest.1, longest.0))
    } else {
        Err(found.join("\n"))
    }
}

/// Everything that is wrong with one file, each with its place.
fn faults(path: &str, text: &str) -> Vec<String> {
    let mut found = machine_paths(path, text);
    if path.ends_with(".rs") {
        found.extend(ignored_tests(path, text));
        found.extend(unchecked(path, text));
        found.extend(markup::escapes(path, text));
    }
    if is_source(path) {
        found.extend(too_long(path, text));
        found.extend(empty_name(path));
        found.extend(reserved_deeds(path, text));
    }
    if path.ends_with("Cargo.toml") && !is_workspace(text) {
        found.extend(manifest_faults(path, text));
    }
    found
}

/// True for a manifest that is a workspace itself: the root's, and those of what is kept apart from the project.
fn is_workspace(manifest: &str) -> bool {
    manifest.lines().any(|line| line.trim() == "[workspace]")
}

fn is_source(path: &str) -> bool {
    path.ends_with(".rs") && path.contains("/src/")
}

/// The crate below `apps/` that a source file belongs to.
fn engine_crate(path: &str) -> Option<&str> {
    let (name, inside) = path.strip_prefix("crates/")?.split_once('/')?;
    let for_tests = inside.ends_with("/tests.rs") || inside.contains("/tests/");
    (inside.starts_with("src/") && !for_tests).then_some(name)
}

fn reserved_deeds(path: &str, text: &str) -> Vec<String> {
    let Some(name) = engine_crate(path) else { return vec![] };
    let mut found = vec![];
    for named in paths::named(&source::code_without_tests(text)) {
        for deed in RESERVED.iter().filter(|deed| deed.home != Some(name)) {
            if deed.named.iter().any(|wanted| is_deed(&named, wanted)) {
                let home = deed.home.unwrap_or("apps/");
                found.push(format!("{path}:{}: {} {} (its home: {home})", named.line, named.path, deed.what));
            }
        }
    }
    found
}

/// A lone word such as `fs` is the module only where something of it is named: a variable may be called so.
fn is_deed(named: &paths::Named, wanted: &str) -> bool {
    let lone_module =
        !wanted.contains("::") && !wanted.ends_with('!') && wanted.starts_with(char::is_lowercase);
    named.is_in(wanted) && !(lone_module && named.path == wanted)
}

fn too_long(path: &str, text: &str) -> Option<String> {
    let lines = text.lines().count();
    (lines > LONGEST).then(|| format!("{path}: {lines} lines, {LONGEST} allowed: it is two files"))
}

fn empty_name(path: &str) -> Option<String> {
    let inside = path.split_once("/src/").map_or(path, |(_, inside)| inside);
    let empty = inside.trim_end_matches(".rs").split('/').find(|part| EMPTY_NAMES.contains(part))?;
    Some(format!("{path}: `{empty}` does not say what the module holds"))
}

/// The lints deny it everywhere and can be told otherwise; here nothing but exported and imported names is, in one place, and what C hands
/// over, in another.
fn unchecked(path: &str, text: &str) -> Vec<String> {
    if path == POINTERS {
        return vec![];
    }
    // The block of imported names says the word once; each of them is declared safe.
    let imports = concat!("un", "safe extern ");
    let name = |line: &str| line.starts_with("#[") || line.starts_with(imports);
    let attribute = |line: &str| path == EXPORTED_NAMES && name(line.trim_start());
    let code = source::code(text);
    let says = |line: &str| line.split(|c: char| !source::is_word(c)).any(|word| word == "unsafe");
    let found = code.lines().enumerate().filter(|(_, line)| says(line) && !attribute(line));
    found.map(|(n, _)| format!("{path}:{}: unsafe code", n + 1)).collect()
}

fn ignored_tests(path: &str, text: &str) -> Vec<String> {
    let code = source::code(text);
    let ignored = code.lines().enumerate().filter(|(_, line)| line.replace(' ', "").contains("#[ignore"));
    ignored.map(|(n, _)| format!("{path}:{}: an ignored test", n + 1)).collect()
}

fn machine_paths(path: &str, text: &str) -> Vec<String> {
    let wanted: Vec<String> = MACHINE_PATHS.iter().map(|(a, b)| format!("{a}{b}")).collect();
    let names_one = |line: &str| wanted.iter().any(|place| has_root(line, place));
    let lines = text.lines().enumerate().filter(|(_, line)| names_one(line));
    lines.map(|(n, _)| format!("{path}:{}: a path of one machine", n + 1)).collect()
}

/// True where `place` stands in `line` as the root of a path, not inside a longer path or address.
fn has_root(line: &str, place: &str) -> bool {
    line.match_indices(place).any(|(at, _)| {
        let before = line[..at].chars().next_back();
        place.starts_with(':') || !before.is_some_and(|c| source::is_word(c) || "./-~*}>".contains(c))
    })
}

/// Every member takes the workspace's lints, and its dependencies' versions from the root manifest.
fn manifest_faults(path: &str, text: &str) -> Vec<String> {
    let mut found = vec![];
    let (mut section, mut lints) = (String::new(), false);
    for (n, line) in text.lines().enumerate() {
        let line = line.trim();
        if let Some(name) = line.strip_prefix('[') {
            section = name.trim_end_matches(']').to_owned();
        } else if section == "lints" && line.replace(' ', "") == "workspace=true" {
            lints = true;
        } else if section.ends_with("dependencies") && !line.is_empty() && !line.starts_with('#') {
            let inherited = line.replace(' ', "").contains("workspace=true");
            if !inherited {
                found.push(format!("{path}:{}: versions stand in the root Cargo.toml: {line}", n + 1));
            }
        }
    }
    if !lints {
        found.push(format!("{path}: [lints] workspace = true is missing"));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINTS: &str = "[lints]\nworkspace = true\n";

    #[test]
    fn unchecked_code_is_found_wherever_it_is() {
        let block = "fn f() { un".to_owned() + "safe { g() } }";
        assert_eq!(unchecked("crates/carom/src/lib.rs", &block).len(), 1, "a block");
        assert_eq!(unchecked(EXPORTED_NAMES, &block).len(), 1, "a block beside exported names");
        let name = "#[un".to_owned() + "safe(no_mangle)]";
        assert_eq!(unchecked("crates/carom/src/lib.rs", &name).len(), 1, "a name elsewhere");
        assert!(unchecked(EXPORTED_NAMES, &name).is_empty(), "an exported name");
        assert!(unchecked(POINTERS, &block).is_empty(), "what C hands over");
        assert_eq!(unchecked("apps/carom-c/src/text.rs", &block).len(), 1, "beside that");
    }

    #[test]
    fn the_engine_neither_prints_nor_reads_nor_waits() {
        for line in [
            "println!(\"x\");",
            "use std::{fs, path::Path};",
            "let t = std::time::Instant::now();",
            "thread::spawn(f);",
            "fs::read(p)",
            "rayon::join(a, b)",
        ] {
            assert_eq!(faults("crates/carom-motion/src/walk.rs", line).len(), 1, "{line}");
            assert!(faults("apps/carom-cli/src/main.rs", line).is_empty(), "an app may: {line}");
            assert!(faults("crates/carom-motion/tests/walk.rs", line).is_empty(), "a test may: {line}");
        }
    }

    #[test]
    fn what_is_reserved_is_free_at_home_and_in_tests() {
        assert!(faults("crates/carom-scene/src/read.rs", "std::fs::read(p)").is_empty(), "scene reads files");
        assert_eq!(
            faults("crates/carom-scene/src/read.rs", "std::thread::spawn(f)").len(),
            1,
            "but starts no thread"
        );
        assert!(
            faults("crates/carom-study/src/sweep.rs", "rayon::join(a, b)").is_empty(),
            "study starts threads"
        );
        let test = "fn a() {}\n#[cfg(test)]\nmod tests { fn b() { println!(); } }";
        assert!(faults("crates/carom-num/src/ode.rs", test).is_empty(), "test modules are free");
        let words = "// println!(\"x\")\nconst A: &str = \"std::fs\";\nlet thread = fs + 1;";
        assert!(
            faults("crates/carom-num/src/ode.rs", words).is_empty(),
            "comments, strings and names are not deeds"
        );
    }

    #[test]
    fn the_line_of_a_fault_is_named() {
        let found = faults(
            "crates/carom-num/src/ode.rs",
            "fn a() {\n    let s = \"\n\";\n    dbg();\n    print!(s);\n}",
        );
        assert_eq!(found, ["crates/carom-num/src/ode.rs:5: print! prints (its home: apps/)"], "line 5");
    }

    #[test]
    fn a_file_of_401_lines_is_two_files() {
        assert!(faults("xtask/src/a.rs", &"\n".repeat(LONGEST)).is_empty(), "400 lines");
        assert_eq!(faults("xtask/src/a.rs", &"\n".repeat(LONGEST + 1)).len(), 1, "401 lines");
        assert!(
            faults("crates/carom/tests/a.rs", &"\n".repeat(LONGEST + 1)).is_empty(),
            "tests may be longer"
        );
    }

    #[test]
    fn modules_have_names_that_say_something() {
        assert_eq!(faults("crates/carom/src/utils.rs", "").len(), 1, "a file");
        assert_eq!(faults("crates/carom/src/helpers/mod.rs", "").len(), 1, "a folder");
        assert!(faults("crates/carom/src/commonality.rs", "").is_empty(), "a longer word");
    }

    #[test]
    fn ignored_tests_are_found_in_code_only() {
        let ignored = ["#[", "ignore]\nfn a() {}"].concat();
        assert_eq!(faults("crates/carom/tests/a.rs", &ignored).len(), 1, "ignored");
        assert!(faults("crates/carom/tests/a.rs", &format!("// {ignored}")).is_empty(), "in a comment");
    }

    #[test]
    fn machine_paths_are_found_and_addresses_are_not() {
        for (a, b) in MACHINE_PATHS {
            let line = format!("see C{a}{b}x").replace("C/", "/");
            assert_eq!(faults("docs/a.md", &line).len(), 1, "{line}");
        }
        let address = ["https://example.org/ho", "me/page"].concat();
        assert!(faults("docs/a.md", &address).is_empty(), "an address is not a machine's path");
    }

    #[test]
    fn members_take_lints_and_versions_from_the_root() {
        let good = format!("{LINTS}[dependencies]\nlibm.workspace = true\nrand = {{ workspace = true }}\n");
        assert!(faults("crates/carom/Cargo.toml", &good).is_empty(), "inherited");
        let own_version = format!("{LINTS}[dev-dependencies]\nrand = \"0.10\"\n");
        assert_eq!(faults("crates/carom/Cargo.toml", &own_version).len(), 1, "a version of its own");
        assert_eq!(faults("crates/carom/Cargo.toml", "[dependencies]\n").len(), 1, "no lints");
        let apart = "[workspace]\n[dependencies]\nrand = \"0.10\"\n";
        assert!(faults("bench/a/Cargo.toml", apart).is_empty(), "a workspace of its own");
    }
}
