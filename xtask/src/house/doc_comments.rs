//! Lines of doc comments that a reader of the pages does not see.

/// Words after a fence that leave the block Rust code.
const RUST_WORDS: [&str; 6] = ["rust", "no_run", "should_panic", "compile_fail", "ignore", "test_harness"];

/// How many lines of the doc comments are hidden: lines of Rust code blocks that are `#` or start with `# `.
///
/// A heading outside code is none, nor is a line that starts with `##`, which shows as `#`.
pub(super) fn hidden_lines(text: &str) -> usize {
    let mut hidden = 0;
    // Within a code block: is it Rust?
    let mut block: Option<bool> = None;
    for line in text.lines() {
        let Some(doc) = doc_line(line) else {
            // A comment that ends leaves no block open for the next one.
            block = None;
            continue;
        };
        if let Some(words) = doc.strip_prefix("```") {
            block = if block.is_some() { None } else { Some(is_rust(words)) };
        } else if block == Some(true) && (doc == "#" || doc.starts_with("# ")) {
            hidden += 1;
        }
    }
    hidden
}

/// What a line of a doc comment says.
pub(super) fn doc_line(line: &str) -> Option<&str> {
    let line = line.trim();
    let doc = line.strip_prefix("//!").or_else(|| line.strip_prefix("///"))?;
    // Four slashes make an ordinary comment.
    (!doc.starts_with('/')).then(|| doc.trim())
}

fn is_rust(words: &str) -> bool {
    words.split(',').map(str::trim).all(|word| {
        word.is_empty()
            || RUST_WORDS.contains(&word)
            || word.starts_with("edition")
            || word.starts_with("ignore-")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hidden_lines_stand_in_rust_code_alone() {
        let text = "\
            /// # Example\n///\n/// ```\n/// # fn main() {\n/// #\n/// let a = 1; // # shown\n/// #[inline]\n/// ## shown\n/// # }\n/// ```\n\
            ///\n/// # Source\nfn a() {}\n\
            /// ```text\n/// # not Rust\n/// ```\n/// ```rust,no_run\n/// # let b = 2;\n/// ```\n";
        assert_eq!(hidden_lines(text), 4, "the two of `main`, the empty one and `let b`");
    }

    #[test]
    fn an_open_block_ends_with_its_comment() {
        let text = "//! ```\n//! # hidden\n\n// # plain\n/// # Heading\nfn a() {}\n";
        assert_eq!(hidden_lines(text), 1, "a heading of the next comment is none");
    }
}
