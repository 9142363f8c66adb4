//! Headings of pages, and links that lead to them.

use crate::links;

/// The places of a page that a link may name behind `#`: its headings, as mdBook and GitHub spell them.
pub(crate) fn places(text: &str) -> Vec<String> {
    let mut found: Vec<String> = vec![];
    for line in outside_code(text).map(|(_, line)| line) {
        let depth = line.chars().take_while(|c| *c == '#').count();
        if let Some(heading) = line[depth..].strip_prefix(' ').filter(|_| depth > 0) {
            let place = spelled(heading);
            let times = found.iter().filter(|before| **before == place).count();
            found.push(if times == 0 { place } else { format!("{place}-{times}") });
        }
    }
    found
}

/// A heading in small letters, with hyphens for spaces and nothing but them, letters, digits and underscores.
fn spelled(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

/// A link with a place: where it stands, the page that it leads to and the place on it.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Link {
    pub(crate) line: usize,
    pub(crate) page: String,
    pub(crate) place: String,
}

/// Every link of a page that names a place, on itself or on another page of the project.
pub(crate) fn links(page: &str, text: &str) -> Vec<Link> {
    let mut found = vec![];
    for (line, words) in outside_code(text) {
        for target in words.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let Some((file, place)) = target.split_once('#').filter(|_| !target.contains("://")) else {
                continue;
            };
            let leads = if file.is_empty() { page.to_owned() } else { links::leads_to(page, file) };
            found.push(Link { line, page: leads, place: place.to_owned() });
        }
    }
    found
}

/// The lines of a page outside blocks of code, with their numbers.
fn outside_code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut in_code = false;
    text.lines().enumerate().filter_map(move |(n, line)| {
        let is_fence = line.trim_start().starts_with("```");
        in_code ^= is_fence;
        (!is_fence && !in_code).then_some((n + 1, line))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_are_spelled_as_in_a_browser() {
        let text = "# `carom map`: which outcome where\n```\n# no heading\n```\n## In space\n## In space\n#no\n### Two-point strikes";
        assert_eq!(
            places(text),
            ["carom-map-which-outcome-where", "in-space", "in-space-1", "two-point-strikes"],
            "four headings"
        );
    }

    #[test]
    fn links_to_places_are_found() {
        let text = "[a](b.md#c) and [d](#e)\n[f](g.md) [h](https://x.org/y#z)";
        let link = |page: &str, place: &str| Link { line: 1, page: page.to_owned(), place: place.to_owned() };
        assert_eq!(links("docs/a.md", text), [link("docs/b.md", "c"), link("docs/a.md", "e")], "two of four");
    }
}
