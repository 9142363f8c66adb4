//! The frame that every page has: head, heading, footer; and the section that shows what went in.

use crate::markup::{DOCTYPE, Markup, PreEscaped, document, html, notes, unfolded};

/// A page without its frame.
pub(crate) struct Page<'a> {
    /// In the window's title.
    pub(crate) title: &'a str,
    pub(crate) heading: &'a str,
    /// Style sheets, in their order.
    pub(crate) styles: &'a [&'a str],
    pub(crate) body: Markup,
    /// After the body: the source of a script, or nothing.
    pub(crate) script: Option<&'a str>,
    /// What made the page, with its version; nothing where that is not said.
    pub(crate) made_by: &'a str,
}

impl Page<'_> {
    /// One self-contained HTML page.
    pub(crate) fn html(&self) -> String {
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    title { (self.title) }
                    style { "\n" (PreEscaped(self.styles.join("\n"))) "\n" }
                }
                body {
                    main {
                        header { h1 { (self.heading) } }
                        (self.body)
                        @if !self.made_by.is_empty() { footer { (self.made_by) } }
                    }
                    @if let Some(script) = self.script { script { (PreEscaped(script)) } }
                }
            }
        };
        document(page) + "\n"
    }
}

/// Sentences on the law and the model, and the file as written, where there is one.
pub(crate) fn law_and_input(sentences: &[String], source: &str) -> Markup {
    html! { section id="model" { h2 { "Law and input" } (notes(sentences)) (as_written(source)) } }
}

/// The file as written, to unfold; nothing where there is none.
pub(crate) fn as_written(source: &str) -> Markup {
    html! { @if !source.trim().is_empty() { (unfolded("The file as written", source)) } }
}
