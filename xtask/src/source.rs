//! Rust text without its comments, literals and test modules, so that a search finds code and nothing else.

/// The code of a file: comments and literals become blanks, so lines and columns stay where they are.
pub(crate) fn code(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    while at < bytes.len() {
        let skipped = comment(bytes, at).or_else(|| literal(text, at));
        let end = match skipped {
            Some(end) => {
                blank(&text[at..end], &mut out);
                end
            }
            None => {
                let end = at + token_length(text, at);
                out.push_str(&text[at..end]);
                end
            }
        };
        at = end;
    }
    out
}

/// The same without items marked `#[cfg(test)]`.
pub(crate) fn code_without_tests(text: &str) -> String {
    const MARK: &str = "#[cfg(test)]";
    let mut rest = code(text);
    while let Some(start) = rest.find(MARK) {
        let end = item_end(&rest, start + MARK.len());
        let mut without = rest[..start].to_owned();
        blank(&rest[start..end], &mut without);
        without.push_str(&rest[end..]);
        rest = without;
    }
    rest
}

/// A word is taken whole, so that the `r` of `for` or the `b` of `b"…"` is looked at only where a token starts.
fn token_length(text: &str, at: usize) -> usize {
    let rest = &text[at..];
    let word: usize = rest.chars().take_while(|c| is_word(*c)).map(char::len_utf8).sum();
    if word > 0 { word } else { rest.chars().next().map_or(1, char::len_utf8) }
}

/// True for the characters of identifiers.
pub(crate) fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn blank(skipped: &str, out: &mut String) {
    out.extend(skipped.chars().map(|c| if c == '\n' { '\n' } else { ' ' }));
}

/// Where a comment that starts at `at` ends; block comments nest.
fn comment(bytes: &[u8], at: usize) -> Option<usize> {
    if bytes[at..].starts_with(b"//") {
        return Some(bytes[at..].iter().position(|b| *b == b'\n').map_or(bytes.len(), |n| at + n));
    }
    if !bytes[at..].starts_with(b"/*") {
        return None;
    }
    let (mut depth, mut i) = (0_usize, at);
    while i < bytes.len() {
        if bytes[i..].starts_with(b"/*") {
            depth += 1;
            i += 2;
        } else if bytes[i..].starts_with(b"*/") {
            depth -= 1;
            i += 2;
            if depth == 0 {
                return Some(i);
            }
        } else {
            i += 1;
        }
    }
    Some(bytes.len())
}

/// Where a string or character literal that starts at `at` ends. A lifetime is none.
fn literal(text: &str, at: usize) -> Option<usize> {
    let rest = &text[at..];
    let prefix = ["br", "cr", "b", "c", "r"].into_iter().find(|p| {
        let after = &rest.as_bytes()[p.len().min(rest.len())..];
        rest.starts_with(p) && matches!(after.first(), Some(b'"' | b'#' | b'\''))
    });
    let start = at + prefix.map_or(0, str::len);
    let raw = prefix.is_some_and(|p| p.ends_with('r'));
    let body = &text[start..];
    if raw {
        let hashes = body.bytes().take_while(|b| *b == b'#').count();
        let open = body[hashes..].strip_prefix('"')?;
        let close = format!("\"{}", "#".repeat(hashes));
        return Some(open.find(&close).map_or(text.len(), |n| start + hashes + 1 + n + close.len()));
    }
    match body.bytes().next()? {
        b'"' => Some(start + quoted(body, '"')),
        b'\'' if is_character(body) => Some(start + quoted(body, '\'')),
        _ => None,
    }
}

/// `'x'` or `'\n'`, but not the lifetime `'x`.
fn is_character(body: &str) -> bool {
    let mut inside = body.chars().skip(1);
    match inside.next() {
        Some('\\') => true,
        Some(_) => inside.next() == Some('\''),
        None => false,
    }
}

/// The length of a quoted literal with backslash escapes.
fn quoted(body: &str, quote: char) -> usize {
    let mut escaped = false;
    for (n, c) in body.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            _ if c == quote => return n + c.len_utf8(),
            _ => {}
        }
    }
    body.len()
}

/// Where an item ends: at its first `;`, or at the brace that closes its first `{`.
fn item_end(code: &str, start: usize) -> usize {
    let mut depth = 0_usize;
    for (n, c) in code[start..].char_indices() {
        match c {
            ';' if depth == 0 => return start + n + 1,
            '{' => depth += 1,
            '}' => {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    return start + n + 1;
                }
            }
            _ => {}
        }
    }
    code.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_literals_become_blanks_of_their_length() {
        let text = "let a = \"x\\\"y\"; // end\n/* a /* b */ c */ let b = 'q';";
        let expected = "let a =       ;       \n                  let b =    ;";
        assert_eq!(code(text), expected, "lines and columns stay");
    }

    #[test]
    fn raw_strings_end_at_their_own_hashes() {
        assert_eq!(code("f(r#\"a\"b\"#, x)").replace(' ', ""), "f(,x)", "the inner quote does not end it");
        assert_eq!(code("f(br\"a\\\", x)").replace(' ', ""), "f(,x)", "no escapes in a raw string");
    }

    #[test]
    fn lifetimes_and_words_that_end_in_a_prefix_stay() {
        for text in ["fn f<'a>(x: &'a str) -> &'a str { x }", "for x in y {}", "let r = b;"] {
            assert_eq!(code(text), text, "nothing to blank");
        }
        assert_eq!(code("('\\'', 'a')").replace(' ', ""), "(,)", "an escaped quote is a character");
    }

    #[test]
    fn an_unfinished_text_ends_quietly() {
        for text in ["/* never closed", "\"never closed", "r#\"never closed\"", "'"] {
            assert_eq!(code(text).chars().count(), text.chars().count(), "{text} keeps its length");
        }
    }

    #[test]
    fn test_modules_are_left_out() {
        let text = "fn a() {}\n#[cfg(test)]\nmod tests { fn b() { {} } }\nfn c() {}\n#[cfg(test)]\nmod more;\nfn d() {}";
        let kept = code_without_tests(text);
        for (word, expected) in [("a()", true), ("b()", false), ("c()", true), ("more", false), ("d()", true)]
        {
            assert_eq!(kept.contains(word), expected, "{word}");
        }
        assert_eq!(kept.lines().count(), text.lines().count(), "lines stay where they are");
    }
}
