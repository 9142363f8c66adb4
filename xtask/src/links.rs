//! Links from one page of the project to another file of it.

/// Every relative link of a Markdown page that leads to no file in `files`, with its place.
pub(crate) fn broken(page: &str, text: &str, files: &[String]) -> Vec<String> {
    let mut found = vec![];
    let mut in_code = false;
    for (n, line) in text.lines().enumerate() {
        in_code ^= line.trim_start().starts_with("```");
        if in_code {
            continue;
        }
        for target in targets(line) {
            let leads = leads_to(page, target);
            let folder = format!("{}/", leads.trim_end_matches('/'));
            if !files.iter().any(|file| *file == leads || file.starts_with(&folder)) {
                found.push(format!("{page}:{}: a link to {target}, which is not there", n + 1));
            }
        }
    }
    found
}

/// The targets of `[…](target)` on a line, without web addresses and places on the same page.
fn targets(line: &str) -> impl Iterator<Item = &str> {
    line.split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .map(|target| target.split('#').next().unwrap_or_default())
        .filter(|target| !target.is_empty() && !target.contains("://") && !target.starts_with("mailto:"))
}

/// The path of a link's target, as the list of files spells it.
pub(crate) fn leads_to(page: &str, target: &str) -> String {
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in target.split('/') {
        match part {
            "." => {}
            ".." => {
                parts.pop();
            }
            other => parts.push(other),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn broken_in(page: &str, text: &str) -> usize {
        let files = ["README.md", "docs/notation.md", "docs/decisions/0001-x.md"].map(str::to_owned);
        broken(page, text, &files).len()
    }

    #[test]
    fn links_are_followed_from_their_page() {
        assert_eq!(
            broken_in("README.md", "[a](docs/notation.md#frames) and [b](docs/decisions/)"),
            0,
            "from the root"
        );
        assert_eq!(
            broken_in("docs/decisions/0001-x.md", "[a](../notation.md), [b](../../README.md)"),
            0,
            "upwards"
        );
        assert_eq!(
            broken_in("docs/notation.md", "[a](notation.md)\n[b](decisions/0002-y.md)"),
            1,
            "one is not there"
        );
    }

    #[test]
    fn addresses_places_and_code_are_not_followed() {
        let text = "[a](https://example.org/x) [b](#frames)\n```\n[c](nowhere.md)\n```\n[d](nowhere.md)";
        assert_eq!(broken_in("README.md", text), 1, "only the last leads to a file");
    }
}
