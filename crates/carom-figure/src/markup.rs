//! Markup that is put together of elements, never of text: maud escapes every text and every attribute. What stands in a page unescaped is
//! a style, a script or numbers of ours, and is wrapped as [`PreEscaped`] where it comes from.

pub(crate) use maud::{DOCTYPE, Markup, PreEscaped, html};

/// Pieces of markup, one after the other.
pub(crate) fn joined(pieces: impl IntoIterator<Item = Markup>) -> Markup {
    PreEscaped(pieces.into_iter().map(PreEscaped::into_string).collect())
}

/// The finished document as text.
///
/// HTML's reserved characters are escaped by then. XML allows no control characters and neither U+FFFE nor U+FFFF, escaped or not, and a name
/// may have them: they are taken out of the whole, so that no place can be forgotten.
pub(crate) fn document(markup: Markup) -> String {
    let allowed = |c: char| match c {
        '\n' | '\t' => Some(c),
        '\u{FFFE}' | '\u{FFFF}' => Some(char::REPLACEMENT_CHARACTER),
        c => (!c.is_control()).then_some(c),
    };
    markup.into_string().chars().filter_map(allowed).collect()
}

/// A table with its heads and rows, which scrolls where the page is too narrow. In a head `at [s]` the unit is set apart.
pub(crate) fn table(class: &str, heads: &[&str], rows: impl IntoIterator<Item = Markup>) -> Markup {
    html! {
        div.wide tabindex="0" {
            table class=[(!class.is_empty()).then_some(class)] {
                @if !heads.is_empty() { thead { tr { @for head in heads { (self::head(head)) } } } }
                tbody { (joined(rows)) }
            }
        }
    }
}

fn head(words: &str) -> Markup {
    match words.strip_suffix(']').and_then(|words| words.split_once('[')) {
        Some((name, unit)) => html! { th { (name) span.u { (unit) } } },
        // A head without words is none: who hears the table is told of no column.
        None if words.is_empty() => html! { td {} },
        None => html! { th { (words) } },
    }
}

/// Sentences, each as a note.
pub(crate) fn notes(sentences: &[String]) -> Markup {
    html! { @for sentence in sentences { p.note { (sentence) } } }
}

/// A number that matters: what it is, its value, more on it.
pub(crate) fn fact(label: &str, value: &str, more: &str) -> Markup {
    html! { div { dt { (label) } dd { (value) small { (more) } } } }
}

/// A text to unfold that is shown as it was written.
pub(crate) fn unfolded(summary: &str, text: &str) -> Markup {
    html! { details { summary { (summary) } pre { (text) } } }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved_characters_are_escaped_and_those_that_xml_has_not_are_gone() {
        let name = "<b a='1'>&\"\u{0}";
        let page = document(html! { b title=(name) { (name) } });
        assert_eq!(page, "<b title=\"&lt;b a='1'&gt;&amp;&quot;\">&lt;b a='1'&gt;&amp;&quot;</b>", "both");
        let strange = document(html! { "a\u{FFFE}b\u{FFFF}\u{1FFFE}" });
        assert_eq!(strange, "a\u{FFFD}b\u{FFFD}\u{1FFFE}", "no characters of XML");
    }

    #[test]
    fn a_unit_in_a_head_is_set_apart() {
        let rows = [html! { tr { td { "1" } } }];
        let expected = "<div class=\"wide\" tabindex=\"0\"><table><thead><tr><th>#</th><th>at <span class=\"u\">s</span></th></tr></thead><tbody><tr><td>1</td></tr></tbody></table></div>";
        assert_eq!(table("", &["#", "at [s]"], rows).into_string(), expected, "heads and rows");
    }
}
