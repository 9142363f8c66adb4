//! Small numbers without a name.

use crate::source::is_word;

/// A number with an exponent of this or less is a tolerance, or looks like one.
const LARGEST_EXPONENT: i32 = -3;

/// A literal such as `1e-9` that has no name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Bare {
    /// From 1.
    pub(super) line: usize,
    pub(super) literal: String,
}

/// Every literal with an exponent of −3 or less in `code` (text without comments, literals and tests) that stands in no `const` or `static` item.
pub(super) fn bare(code: &str) -> Vec<Bare> {
    let mut found = vec![];
    let (mut line, mut at) = (1, 0);
    // The code before, for what a word follows.
    let mut before = None;
    while let Some(c) = code[at..].chars().next() {
        let end = if is_word(c) { word_end(code, at) } else { at + c.len_utf8() };
        let token = &code[at..end];
        let mut next = end;
        if starts_item(token, before, &code[end..]) {
            next = item_end(code, end);
        } else if is_small(token) {
            found.push(Bare { line, literal: token.to_owned() });
        }
        line += code[at..next].matches('\n').count();
        if !c.is_whitespace() {
            before = code[at..next].chars().next_back();
        }
        at = next;
    }
    found
}

/// Where a word or a number ends; a number takes its point and the sign of its exponent along.
fn word_end(code: &str, at: usize) -> usize {
    let bytes = code.as_bytes();
    let is_number = bytes[at].is_ascii_digit();
    let mut end = at;
    while let Some(c) = code[end..].chars().next() {
        let is_point = c == '.'
            && is_number
            && !code[at..end].contains('.')
            && bytes.get(end + 1).is_some_and(u8::is_ascii_digit);
        let is_sign = matches!(c, '-' | '+') && is_number && ends_with_exponent(&code[at..end]);
        if !(is_word(c) || is_point || is_sign) {
            break;
        }
        end += c.len_utf8();
    }
    end
}

/// True after `1e`, but not after `0xe`.
fn ends_with_exponent(number: &str) -> bool {
    number
        .strip_suffix(['e', 'E'])
        .is_some_and(|mantissa| mantissa.bytes().all(|b| b.is_ascii_digit() || b == b'.' || b == b'_'))
}

fn is_small(token: &str) -> bool {
    if !token.starts_with(|c: char| c.is_ascii_digit()) {
        return false;
    }
    let Some((_, exponent)) = token.split_once(['e', 'E']) else { return false };
    let digits = exponent.trim_end_matches("f64").trim_end_matches("f32").replace('_', "");
    digits.parse::<i32>().is_ok_and(|exponent| exponent <= LARGEST_EXPONENT)
}

/// True for the `const` or `static` of an item: not of `const fn`, `&'static`, `<const N: usize>` or `*const T`.
fn starts_item(token: &str, before: Option<char>, after: &str) -> bool {
    if !matches!(token, "const" | "static") {
        return false;
    }
    // An item follows an item, an attribute, a visibility or the brace that opens its block.
    let in_place = before.is_none_or(|c| matches!(c, ';' | '{' | '}' | ']' | ')') || is_word(c));
    let next = after.trim_start();
    let is_function = ["fn ", "unsafe ", "extern ", "{"].iter().any(|word| next.starts_with(word));
    in_place && !is_function
}

/// Where an item that ends with `;` ends; one inside brackets belongs to a type or a block.
fn item_end(code: &str, start: usize) -> usize {
    let mut depth = 0_i32;
    for (n, c) in code[start..].char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ';' if depth <= 0 => return start + n + 1,
            _ => {}
        }
    }
    code.len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::code_without_tests;

    fn literals(text: &str) -> Vec<String> {
        bare(&code_without_tests(text)).into_iter().map(|bare| bare.literal).collect()
    }

    #[test]
    fn a_small_number_in_an_expression_is_bare() {
        for (text, literal) in [
            ("fn a() -> bool { x < 1e-9 }", "1e-9"),
            ("let a = 2.5e-12 * b;", "2.5e-12"),
            ("f(1_0.0E-3_f64)", "1_0.0E-3_f64"),
            ("const fn a() -> f64 { 1e-6 }", "1e-6"),
            ("fn a<const N: usize>(x: &'static str) -> f64 { 1e-6 }", "1e-6"),
            ("fn a(x: *const f64) -> f64 { 1e-6 }", "1e-6"),
            ("const A: f64 = 1.0; fn a() -> f64 { 1e-6 }", "1e-6"),
            ("let a = const { 1e-6 };", "1e-6"),
        ] {
            assert_eq!(literals(text), [literal], "{text}");
        }
    }

    #[test]
    fn named_numbers_large_ones_tests_and_words_are_free() {
        for text in [
            "const STILL: f64 = 1e-9;",
            "pub(crate) const A: [f64; 2] = [1e-9, 2e-9];",
            "#[doc(hidden)]\nstatic A: Limits = Limits { small: { 1e-9 } };",
            "impl A { const A: f64 = 1e-9; }",
            "fn a() { const A: f64 = 1e-9; }",
            "/// Less than 1e-9.\nfn a() {} // 1e-9",
            "#[cfg(test)]\nmod tests { fn a() -> f64 { 1e-9 } }",
            "let a = \"1e-9\";",
            "let a = 1e-2 + 1e9 + 1e+9 + 0xe-9 + x.0 - 9.0;",
            "let a = 1..9; let e = one_1e-9;",
        ] {
            assert!(literals(text).is_empty(), "{text}: {:?}", literals(text));
        }
    }

    #[test]
    fn a_bare_number_comes_with_its_line() {
        let found = bare("const A: f64 = [\n1e-9,\n][0];\nlet a =\n1e-9;");
        assert_eq!(found, [Bare { line: 5, literal: "1e-9".to_owned() }], "lines of the item before count");
    }
}
