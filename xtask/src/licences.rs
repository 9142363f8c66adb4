//! Licences and origins of all that is built, on any target: what `deny.toml` allows.
//!
//! `cargo deny` holds the same and more. This needs nothing that does not come with Rust, so it is a step of every check.

use crate::metadata;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

/// Where the list of licences stands.
const LIST: &str = "deny.toml";
/// Where every package from outside comes from.
const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// Checks every package that the lock file names.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    let list = std::fs::read_to_string(root.join(LIST)).map_err(|problem| format!("{LIST}: {problem}"))?;
    let allowed = allowed(&list).ok_or_else(|| format!("{LIST} has no list `allow` of licences"))?;
    let excepted = excepted(&list);
    let json = metadata::of_cargo(root, &["--all-features", "--locked"])?;
    let packages = json["packages"].as_array().ok_or("cargo metadata does not look as it used to")?;
    let faults: Vec<String> =
        packages.iter().filter_map(|package| fault(package, &allowed, &excepted)).collect();
    if faults.is_empty() { Ok(format!("{} packages", packages.len())) } else { Err(faults.join("\n")) }
}

/// The licences that `[licenses]` allows.
fn allowed(list: &str) -> Option<BTreeSet<&str>> {
    let (_, section) = list.split_once("[licenses]")?;
    let (_, from) = section.split_once("allow = [")?;
    let (names, _) = from.split_once(']')?;
    // Between quotes is every other piece.
    Some(names.split('"').skip(1).step_by(2).collect())
}

/// What `[licenses]` allows single packages beside that: a name and a licence for each, on the line of `exceptions`.
fn excepted(list: &str) -> BTreeSet<(&str, &str)> {
    let section = list.split_once("[licenses]").map_or("", |(_, section)| section);
    let line = section.lines().find_map(|line| line.strip_prefix("exceptions = "));
    let tables = line.into_iter().flat_map(|line| line.split('{').skip(1));
    tables
        .flat_map(|table| {
            let mut names = table.split('"').skip(1).step_by(2);
            let name = names.next().unwrap_or_default();
            names.map(move |licence| (name, licence))
        })
        .collect()
}

/// What is wrong with a package.
fn fault(package: &Value, allowed: &BTreeSet<&str>, excepted: &BTreeSet<(&str, &str)>) -> Option<String> {
    let own = package["name"].as_str()?;
    let name = format!("{own} {}", package["version"].as_str()?);
    // Our own packages have no source.
    if let Some(source) = package["source"].as_str()
        && source != REGISTRY
    {
        return Some(format!("{name}: it comes from {source}"));
    }
    match package["license"].as_str() {
        None => Some(format!("{name}: it names no licence")),
        Some(licence) if is_allowed(licence, allowed) || excepted.contains(&(own, licence)) => None,
        Some(licence) => Some(format!("{name}: {licence} is not allowed by {LIST}")),
    }
}

/// True where an expression of licences can be met with these; one that cannot be read cannot be met.
///
/// # Source
/// *SPDX Specification*, annex "License expressions": AND binds closer than OR. Older manifests write OR as a slash.
fn is_allowed(expression: &str, allowed: &BTreeSet<&str>) -> bool {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut rest = &words[..];
    any_of(&mut rest, allowed) == Some(true) && rest.is_empty()
}

/// Terms with OR between them; `None` where they cannot be read.
fn any_of(words: &mut &[&str], allowed: &BTreeSet<&str>) -> Option<bool> {
    let mut met = all_of(words, allowed)?;
    while let ["OR", rest @ ..] = *words {
        *words = rest;
        met |= all_of(words, allowed)?;
    }
    Some(met)
}

/// Terms with AND between them.
fn all_of(words: &mut &[&str], allowed: &BTreeSet<&str>) -> Option<bool> {
    let mut met = one(words, allowed)?;
    while let ["AND", rest @ ..] = *words {
        *words = rest;
        met &= one(words, allowed)?;
    }
    Some(met)
}

/// A licence, one with an exception to it, or terms in brackets.
fn one(words: &mut &[&str], allowed: &BTreeSet<&str>) -> Option<bool> {
    match **words {
        ["(", ref rest @ ..] => {
            *words = rest;
            let met = any_of(words, allowed)?;
            let [")", rest @ ..] = *words else { return None };
            *words = rest;
            Some(met)
        }
        [licence, "WITH", exception, ref rest @ ..] => {
            *words = rest;
            // With an exception it is a licence of its own, and the list would name both.
            Some(allowed.contains(&*format!("{licence} WITH {exception}")))
        }
        [licence, ref rest @ ..] if ![")", "AND", "OR", "WITH"].contains(&licence) => {
            *words = rest;
            Some(allowed.contains(licence))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn list() -> BTreeSet<&'static str> {
        BTreeSet::from(["MIT", "Apache-2.0", "Zlib"])
    }

    #[test]
    fn the_list_is_read_from_its_own_section() {
        let text = "[graph]\nallow = [\"GPL-3.0\"]\n[licenses]\nallow = [\n    \"MIT\", # ours\n    \"Zlib\",\n]\n[bans]\n";
        let expected = BTreeSet::from(["MIT", "Zlib"]);
        assert_eq!(allowed(text), Some(expected), "what stands between quotes");
        assert_eq!(allowed("[licenses]\n"), None, "no list");
    }

    #[test]
    fn one_licence_of_several_is_enough_and_of_all_none_may_lack() {
        for (expression, expected) in [
            ("MIT", true),
            ("GPL-3.0", false),
            ("GPL-3.0 OR MIT", true),
            ("GPL-3.0/MIT", true),
            ("GPL-3.0 AND MIT", false),
            ("MIT AND Zlib", true),
            ("GPL-3.0 OR MIT AND Zlib", true),
            ("GPL-3.0 AND MIT OR Zlib", true),
            ("(GPL-3.0 OR MIT) AND Zlib", true),
            ("GPL-3.0 AND (MIT OR Zlib)", false),
            ("Apache-2.0 WITH LLVM-exception", false),
            ("Apache-2.0 WITH LLVM-exception OR MIT", true),
        ] {
            assert_eq!(is_allowed(expression, &list()), expected, "{expression}");
        }
    }

    #[test]
    fn what_cannot_be_read_is_not_allowed() {
        for expression in ["", "MIT OR", "OR MIT", "(MIT", "MIT)", "MIT Zlib", "MIT WITH"] {
            assert!(!is_allowed(expression, &list()), "{expression:?}");
        }
    }

    #[test]
    fn an_exception_is_for_one_package() {
        let text = "[licenses]\nallow = [\"MIT\"]\nexceptions = [{ crate = \"a\", allow = [\"X\", \"Y\"] }, { crate = \"b\", allow = [\"Z\"] }]\n";
        let excepted = excepted(text);
        assert_eq!(excepted, BTreeSet::from([("a", "X"), ("a", "Y"), ("b", "Z")]), "by package and licence");
        let said = |name: &str| {
            let package = json!({ "name": name, "version": "1.0.0", "license": "X", "source": REGISTRY });
            fault(&package, &list(), &excepted)
        };
        assert_eq!(said("a"), None, "excepted");
        assert_eq!(said("b"), Some("b 1.0.0: X is not allowed by deny.toml".to_owned()), "another package");
    }

    #[test]
    fn a_package_without_a_licence_or_from_elsewhere_is_refused() {
        let package = |licence: Value, source: Value| json!({ "name": "a", "version": "1.0.0", "license": licence, "source": source });
        let said =
            |licence: Value, source: Value| fault(&package(licence, source), &list(), &BTreeSet::new());
        assert_eq!(said(json!("MIT"), json!(REGISTRY)), None, "from the registry");
        assert_eq!(said(json!("MIT"), Value::Null), None, "our own");
        assert_eq!(said(Value::Null, Value::Null), Some("a 1.0.0: it names no licence".to_owned()), "none");
        let elsewhere = Some("a 1.0.0: it comes from git+https://example.org/a".to_owned());
        assert_eq!(said(json!("MIT"), json!("git+https://example.org/a")), elsewhere, "a repository");
    }
}
