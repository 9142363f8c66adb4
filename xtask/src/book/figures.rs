//! Drawings of the book: what the program drew, as a file that stands alone.

/// The drawing with this label on a page, or the whole of an SVG file, as a lighter file of its own.
///
/// Colours for dark screens are left out: the book's own theme decides what is behind a drawing.
pub(crate) fn drawing(text: &str, label: Option<&str>) -> Option<String> {
    let Some(label) = label else { return Some(without_dark(text)) };
    let wanted = format!("aria-label=\"{label}\"");
    let mut rest = text;
    while let Some(at) = rest.find("<svg") {
        let end = at + rest[at..].find("</svg>")? + "</svg>".len();
        let svg = &rest[at..end];
        let head_end = svg.find('>')?;
        if svg[..head_end].contains(&wanted) {
            return Some(alone(&svg[..head_end], &svg[head_end + 1..], &style(text)));
        }
        rest = &rest[end..];
    }
    None
}

/// A drawing of a page with the name space, the size and the style that it needs outside the page.
fn alone(head: &str, body: &str, style: &str) -> String {
    let space = if head.contains("xmlns=") { "" } else { " xmlns=\"http://www.w3.org/2000/svg\"" };
    let size = if head.contains(" width=") { None } else { size(head) };
    let size = size.map_or_else(String::new, |[w, h]| format!(" width=\"{w}\" height=\"{h}\""));
    format!("{head}{space}{size}><style>\n{style}</style>{body}\n")
}

/// Width and height of a drawing's view.
fn size(head: &str) -> Option<[&str; 2]> {
    let view = head.split_once("viewBox=\"")?.1.split('"').next()?;
    let mut numbers = view.split(' ').skip(2);
    Some([numbers.next()?, numbers.next()?])
}

/// The rules of a page's styles that are about figures.
fn style(page: &str) -> String {
    let light = without_dark(page);
    let rules = light.lines().filter(|line| line.starts_with(".fig") && line.ends_with('}'));
    rules.map(|line| format!("{line}\n")).collect()
}

/// The same without blocks `@media … (prefers-color-scheme: dark) { … }`, and without space at line ends.
fn without_dark(text: &str) -> String {
    let mut out = String::new();
    let mut depth: Option<i32> = None;
    for line in text.lines() {
        if depth.is_none() && line.starts_with("@media") && line.contains("prefers-color-scheme: dark") {
            depth = Some(0);
        }
        let Some(open) = depth.as_mut() else {
            out.push_str(line.trim_end());
            out.push('\n');
            continue;
        };
        let count = |c: char| i32::try_from(line.matches(c).count()).unwrap_or(0);
        *open += count('{') - count('}');
        if *open <= 0 {
            depth = None;
            // What stands behind the block on its last line goes on.
            if let Some(after) =
                line.rsplit_once('}').map(|(_, after)| after).filter(|after| !after.is_empty())
            {
                out.push_str(after);
                out.push('\n');
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "<style>\n.fig { a: b; }\n@media screen and (prefers-color-scheme: dark) {\n  .fig { a: c; }\n}\n\
                        .other { d: e; }\n</style>\n<svg class=\"fig\" viewBox=\"0 0 36 22\" aria-label=\"One\"><path/></svg>\n\
                        <svg aria-label=\"Two\"><g/></svg>";

    #[test]
    fn a_drawing_of_a_page_stands_alone() {
        let one = drawing(PAGE, Some("One")).expect("it is there");
        assert_eq!(
            one,
            "<svg class=\"fig\" viewBox=\"0 0 36 22\" aria-label=\"One\" xmlns=\"http://www.w3.org/2000/svg\" \
             width=\"36\" height=\"22\"><style>\n\
             .fig { a: b; }\n</style><path/></svg>\n",
            "its style, its name space and its size"
        );
        assert!(drawing(PAGE, Some("Two")).is_some_and(|svg| svg.contains("<g/>")), "the second one");
        assert!(drawing(PAGE, Some("Three")).is_none(), "not there");
    }

    #[test]
    fn a_file_loses_its_colours_for_the_dark() {
        let text = "<svg><style>.fig { a: b; }\n@media screen and (prefers-color-scheme: dark) {\n.fig { a: c; }\n}</style>x</svg>";
        assert_eq!(
            drawing(text, None).as_deref(),
            Some("<svg><style>.fig { a: b; }\n</style>x</svg>\n"),
            "one rule is left"
        );
    }
}
