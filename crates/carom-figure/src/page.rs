//! The frame that every page has: head, heading, footer; and the section that shows what went in.

use crate::text::escape;

/// A page without its frame.
pub(crate) struct Page<'a> {
    /// In the window's title; not escaped yet, as the heading.
    pub(crate) title: &'a str,
    pub(crate) heading: &'a str,
    /// What the reader must know before any verdict: that the part computed is not the part drawn. In sentences.
    pub(crate) warnings: &'a [String],
    /// Style sheets, in their order.
    pub(crate) styles: &'a [&'a str],
    /// HTML.
    pub(crate) body: &'a str,
    /// HTML after the body: a script, or nothing.
    pub(crate) script: &'a str,
    /// What made the page, with its version; nothing where that is not said.
    pub(crate) made_by: &'a str,
}

impl Page<'_> {
    /// One self-contained HTML page.
    pub(crate) fn html(&self) -> String {
        let footer = if self.made_by.is_empty() {
            String::new()
        } else {
            format!("<footer>{}</footer>\n", escape(self.made_by))
        };
        let warnings: String = self
            .warnings
            .iter()
            .map(|warning| {
                format!("<p class=\"warning\" role=\"alert\"><b>Warning:</b> {}.</p>\n", escape(warning))
            })
            .collect();
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n<style>\n{}\n</style>\n</head>\n<body>\n<main>\n<header><h1>{}</h1></header>\n{warnings}{}\n{footer}</main>\n{}\n</body>\n</html>\n",
            escape(self.title),
            self.styles.join("\n"),
            escape(self.heading),
            self.body,
            self.script
        )
    }
}

/// Sentences on the law and the model, and the file as written, where there is one.
pub(crate) fn law_and_input(notes: &[String], source: &str) -> String {
    let notes: String = notes.iter().map(|note| format!("<p class=\"note\">{}</p>", escape(note))).collect();
    format!("<section id=\"model\"><h2>Law and input</h2>{notes}{}</section>", as_written(source))
}

/// The file as written, to unfold; nothing where there is none.
pub(crate) fn as_written(source: &str) -> String {
    if source.trim().is_empty() {
        return String::new();
    }
    format!("<details><summary>The file as written</summary><pre>{}</pre></details>", escape(source))
}
