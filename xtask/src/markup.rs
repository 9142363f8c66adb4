//! Pages and drawings are put together of elements, never of escaped text: a place that forgets to escape is found by whoever calls a
//! plate `<script>`.

use crate::source;

/// Calls and definitions of a function that escapes, in the sources of libraries and programs.
pub(crate) fn escapes(path: &str, text: &str) -> Vec<String> {
    let ours = path.starts_with("crates/") || path.starts_with("apps/");
    if !ours || !path.ends_with(".rs") {
        return vec![];
    }
    let code = source::code(text);
    let by_hand = code.lines().enumerate().filter(|(_, line)| names_escape(line));
    let why = "text is escaped by hand: write elements with maud's `html!`, which escapes all of it";
    by_hand.map(|(n, _)| format!("{path}:{}: {why} (decision 14)", n + 1)).collect()
}

/// True where `escape(` stands in a line as a word of its own, or as the end of one (`html_escape(`).
fn names_escape(line: &str) -> bool {
    line.match_indices("escape").any(|(at, word)| {
        let before = line[..at].chars().next_back();
        let own = before.is_none_or(|c| c == '_' || !source::is_word(c));
        own && line[at + word.len()..].trim_start().starts_with('(')
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_escape_by_hand_is_refused_with_its_reason() {
        for line in ["format!(\"<b>{}</b>\", escape(name))", "fn escape(text: &str) {}", "html_escape (x)"] {
            let found = escapes("crates/carom-figure/src/page.rs", &format!("\n{line}"));
            let [fault] = &found[..] else { panic!("{line}: {found:?}") };
            assert!(
                fault.starts_with("crates/carom-figure/src/page.rs:2:") && fault.contains("maud"),
                "{fault}"
            );
        }
    }

    #[test]
    fn other_words_comments_and_other_places_are_free() {
        for line in
            ["// escape(name)", "let s = \"escape(\";", "part.escapes(now)", "let escape = 3;", "scape(x)"]
        {
            assert!(escapes("apps/carom-cli/src/main.rs", line).is_empty(), "{line}");
        }
        assert!(escapes("xtask/src/links.rs", "escape(x)").is_empty(), "a chore makes no pages");
        assert!(escapes("crates/carom/README.md", "escape(x)").is_empty(), "no source");
    }
}
