//! The functions of a file: how long they are, and what is written about them.

use super::doc_comments::doc_line;
use crate::source::{code_without_tests, is_word};

/// A function that has a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Function {
    pub(super) name: String,
    /// Where `fn` stands; from 1.
    pub(super) line: usize,
    /// From `fn` to the closing brace.
    pub(super) lines: usize,
    /// Lines of code in the body.
    pub(super) body_lines: usize,
    /// True where anyone may call it: `pub` without limits.
    pub(super) is_public: bool,
    /// Lines of doc comment above it.
    pub(super) doc_lines: usize,
    /// Lines of the body that are a `//` comment and nothing else.
    pub(super) comment_lines: usize,
}

/// Every function of a file outside its tests; inner ones count for themselves and for those around them.
pub(super) fn functions(text: &str) -> Vec<Function> {
    let code = code_without_tests(text);
    let written: Vec<&str> = text.lines().collect();
    let coded: Vec<&str> = code.lines().collect();
    let mut found = vec![];
    for (at, _) in code.match_indices("fn ") {
        let is_whole = !code[..at].chars().next_back().is_some_and(is_word);
        let name: String = code[at + 3..].chars().take_while(|c| is_word(*c)).collect();
        if !is_whole || name.is_empty() {
            continue;
        }
        let Some((open, close)) = body(&code, at) else { continue };
        let row = |at: usize| code[..at].matches('\n').count();
        let (first, last) = (row(at), row(close));
        let inside = row(open) + 1..last;
        found.push(Function {
            name,
            line: first + 1,
            lines: last - first + 1,
            body_lines: code[open + 1..close].lines().filter(|line| !line.trim().is_empty()).count(),
            is_public: coded[first].trim_start().starts_with("pub "),
            doc_lines: doc_lines(&written[..first]),
            comment_lines: inside.filter(|row| is_comment(written[*row], coded[*row])).count(),
        });
    }
    found
}

/// The braces of the body of the function whose `fn` stands at `at`; `None` where it has none.
fn body(code: &str, at: usize) -> Option<(usize, usize)> {
    let (mut depth, mut open) = (0_usize, None);
    for (n, c) in code[at..].char_indices() {
        match c {
            // `[f64; 3]` in the arguments ends nothing.
            ';' if depth == 0 && open.is_none() => return None,
            '{' if depth == 0 && open.is_none() => open = Some(at + n),
            '(' | '[' | '{' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            '}' if depth == 0 => return Some((open?, at + n)),
            '}' => depth -= 1,
            _ => {}
        }
    }
    None
}

/// True for a line with a comment and without code. Slashes in a string over several lines are none.
fn is_comment(written: &str, coded: &str) -> bool {
    let written = written.trim();
    written.starts_with("//") && doc_line(written).is_none() && coded.trim().is_empty()
}

/// The doc comment that ends these lines, attributes between it and the item left out.
fn doc_lines(above: &[&str]) -> usize {
    let mut found = 0;
    let mut within_attribute = false;
    for line in above.iter().rev().map(|line| line.trim()) {
        if doc_line(line).is_some() {
            found += 1;
        } else if line.starts_with("#[") {
            within_attribute = false;
        } else if line.ends_with(")]") {
            within_attribute = true;
        } else if !within_attribute {
            break;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_function_reaches_from_fn_to_its_closing_brace() {
        let text = "fn a(x: [f64; 3]) -> f64\nwhere\n{\n    if x[0] > 0.0 {\n        1.0\n    } else { 2.0 }\n}\nfn b() {}\n";
        let found = functions(text);
        let lines: Vec<(&str, usize, usize)> =
            found.iter().map(|f| (f.name.as_str(), f.line, f.lines)).collect();
        assert_eq!(lines, [("a", 1, 7), ("b", 8, 1)], "inner braces and the `;` of a type end nothing");
        assert_eq!(found[0].body_lines, 3, "what stands between the braces");
    }

    #[test]
    fn what_has_no_body_is_no_function() {
        let text = "trait A { fn a(&self) -> f64; }\ntype B = fn(f64) -> f64;\n#[cfg(test)]\nmod tests { fn c() {} }\n";
        assert!(functions(text).is_empty(), "a signature, a type, a test: {:?}", functions(text));
    }

    #[test]
    fn comments_of_their_own_line_are_counted_and_others_are_not() {
        let text = "// above\nfn a() {\n    let a = 1; // beside\n    // Why.\n    /// Doc.\n    fn b() {}\n    let c = \"\n    // a string\";\n}\n";
        let found = functions(text);
        assert_eq!(found[0].comment_lines, 1, "`Why.` alone");
    }

    #[test]
    fn docs_are_counted_through_attributes() {
        let text = "fn z() {}\n/// One.\n/// Two.\n#[must_use]\n#[expect(\n    clippy::panic,\n    reason = \"x\"\n)]\npub const fn a() -> f64 { 1.0 }\npub(crate) fn b() {}\n";
        let found = functions(text);
        assert_eq!((found[1].doc_lines, found[1].is_public), (2, true), "two lines above the attributes");
        assert_eq!((found[2].doc_lines, found[2].is_public), (0, false), "nothing above, and not for all");
    }
}
