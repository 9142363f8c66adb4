//! The paths and macros that Rust code names, with grouped imports spelled out.

use crate::source::is_word;
use std::iter::Peekable;
use std::str::Chars;

/// A path as code names it, and the line it stands on (from 1). A macro keeps its exclamation mark.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Named {
    pub(crate) line: usize,
    pub(crate) path: String,
}

impl Named {
    /// True where the path is `wanted` or lies inside it; a macro may be named with its path.
    pub(crate) fn is_in(&self, wanted: &str) -> bool {
        if wanted.ends_with('!') {
            return self.path.rsplit("::").next() == Some(wanted);
        }
        self.path.strip_prefix(wanted).is_some_and(|rest| rest.is_empty() || rest.starts_with("::"))
    }
}

/// Every path in `code` (text without comments and literals): `use std::{fs, io::Read}` names `std::fs` and `std::io::Read`.
pub(crate) fn named(code: &str) -> Vec<Named> {
    let mut reader = Reader { rest: code.chars().peekable(), line: 1, found: vec![] };
    while let Some(c) = reader.peek() {
        if is_word(c) {
            reader.path("");
        } else {
            reader.next();
        }
    }
    reader.found
}

struct Reader<'a> {
    rest: Peekable<Chars<'a>>,
    line: usize,
    found: Vec<Named>,
}

impl Reader<'_> {
    fn peek(&mut self) -> Option<char> {
        self.rest.peek().copied()
    }

    fn next(&mut self) -> Option<char> {
        let c = self.rest.next();
        self.line += usize::from(c == Some('\n'));
        c
    }

    fn skip_blanks(&mut self) {
        while self.peek().is_some_and(char::is_whitespace) {
            self.next();
        }
    }

    fn word(&mut self) -> String {
        let mut word = String::new();
        while let Some(c) = self.peek().filter(|c| is_word(*c)) {
            word.push(c);
            self.next();
        }
        word
    }

    /// Eats `::` where it comes next.
    fn colons(&mut self) -> bool {
        let mut ahead = self.rest.clone().skip_while(|c| c.is_whitespace());
        if ahead.next() != Some(':') || ahead.next() != Some(':') {
            return false;
        }
        self.skip_blanks();
        self.next();
        self.next();
        self.skip_blanks();
        true
    }

    /// Reads a path that starts with a word; a group in braces is read as a path for each of its members.
    fn path(&mut self, inside: &str) {
        let line = self.line;
        let mut path = inside.to_owned();
        loop {
            let word = self.word();
            if !word.is_empty() && word != "self" {
                if !path.is_empty() {
                    path.push_str("::");
                }
                path.push_str(&word);
            }
            if word.is_empty() || !self.colons() {
                break;
            }
            if self.peek() == Some('{') {
                self.next();
                self.group(&path);
                return;
            }
        }
        if self.peek() == Some('!') {
            path.push('!');
        }
        if !path.is_empty() {
            self.found.push(Named { line, path });
        }
    }

    fn group(&mut self, inside: &str) {
        while let Some(c) = self.peek() {
            if c == '}' {
                self.next();
                return;
            }
            if is_word(c) {
                self.path(inside);
            } else {
                self.next();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paths(code: &str) -> Vec<String> {
        named(code).into_iter().map(|named| named.path).collect()
    }

    #[test]
    fn grouped_imports_are_spelled_out() {
        let found = paths("use std::{fs, io::{self, Read}, thread};");
        assert_eq!(
            found,
            ["use", "std::fs", "std::io", "std::io::Read", "std::thread"],
            "each member with its path"
        );
    }

    #[test]
    fn paths_in_expressions_keep_their_lines() {
        let found = named("a();\nlet t = std :: time\n  ::Instant::now();");
        assert!(
            found.contains(&Named { line: 2, path: "std::time::Instant::now".to_owned() }),
            "blanks and line ends inside a path: {found:?}"
        );
    }

    #[test]
    fn a_macro_keeps_its_mark() {
        assert_eq!(paths("println!(x)")[0], "println!", "a macro");
        assert!(named("std::println!(x)")[0].is_in("println!"), "a macro with its path");
        assert!(!named("println(x)")[0].is_in("println!"), "a function is no macro");
    }

    #[test]
    fn a_path_lies_inside_its_module_and_not_beside_it() {
        let inside = |path: &str| named(path)[0].is_in("std::fs");
        assert!(inside("std::fs") && inside("std::fs::File"), "the module and what is in it");
        assert!(!inside("std::fsx") && !inside("my::std::fs"), "neither a longer name nor another root");
    }

    #[test]
    fn turbofish_and_globs_end_quietly() {
        assert_eq!(paths("Vec::<f64>::new()"), ["Vec", "f64", "new"], "generic arguments");
        assert_eq!(paths("use std::fs::*;"), ["use", "std::fs"], "a glob names its module");
    }
}
