//! Entities of an XML file: how long its text is once every reference to one is replaced.

use std::collections::BTreeMap;

/// What begins the declaration of an entity.
const DECLARATION: &str = "<!ENTITY";
/// References within references that the reader of XML follows; it refuses more.
const DEEPEST: usize = 10;

/// The entities that a file declares: the text of each as it is written.
struct Entities<'t>(BTreeMap<&'t str, &'t str>);

impl<'t> Entities<'t> {
    fn of(text: &'t str) -> Self {
        let mut found = BTreeMap::new();
        for (at, _) in text.match_indices(DECLARATION) {
            if let Some((name, value)) = declared(&text[at + DECLARATION.len()..]) {
                // Of two with one name the first holds.
                found.entry(name).or_insert(value);
            }
        }
        Self(found)
    }

    /// The length of each entity with the references in it replaced, as deep as they are followed.
    fn lengths(&self) -> BTreeMap<&'t str, u64> {
        let mut lengths: BTreeMap<&str, u64> = self.0.iter().map(|(k, v)| (*k, v.len() as u64)).collect();
        for _ in 0..DEEPEST {
            lengths = self.0.iter().map(|(name, value)| (*name, replaced(value, &lengths))).collect();
        }
        lengths
    }
}

/// A bound on the length of a text in bytes once its references to entities are replaced.
pub(super) fn expanded_length(text: &str) -> u64 {
    let entities = Entities::of(text);
    if entities.0.is_empty() { text.len() as u64 } else { replaced(text, &entities.lengths()) }
}

/// The name and the text of a declaration; none for those of other files and of DTDs.
fn declared(after: &str) -> Option<(&str, &str)> {
    // No name holds a "<"; to stop there keeps the search short in a file that is no XML.
    let (name, rest) = after.trim_start().split_once(|c: char| c.is_whitespace() || c == '<')?;
    let rest = rest.trim_start();
    let quote = rest.chars().next().filter(|first| ['"', '\''].contains(first))?;
    rest[1..].split_once(quote).map(|(value, _)| (name, value))
}

/// The length of a text where each reference is as long as what it stands for.
fn replaced(text: &str, lengths: &BTreeMap<&str, u64>) -> u64 {
    let references = text.split('&').skip(1).filter_map(|after| after.split_once(';'));
    references
        .filter_map(|(name, _)| lengths.get(name))
        .fold(text.len() as u64, |length, of_one| length.saturating_add(*of_one))
}

#[cfg(test)]
mod tests {
    use super::expanded_length;

    #[test]
    fn a_reference_is_as_long_as_what_it_stands_for() {
        let text = "<!DOCTYPE svg [<!ENTITY a \"12345\"><!ENTITY b '&a;&a;'>]><svg>&b;&a;&amp;</svg>";
        // The references within the declaration of b are counted there as well.
        let (in_b, in_svg) = (2 * 5, (6 + 2 * 5) + 5);
        assert_eq!(expanded_length(text), (text.len() + in_b + in_svg) as u64, "all references replaced");
        let plain = "<svg>&lt;&#65;&unknown;</svg>";
        assert_eq!(expanded_length(plain), plain.len() as u64, "nothing is declared here");
    }

    #[test]
    fn entities_within_entities_multiply_and_circles_end() {
        let level = |k: usize| format!("<!ENTITY e{} \"{}\">", k + 1, format!("&e{k};").repeat(10));
        let bomb: String = (0..9).map(level).collect();
        let text = format!("<!DOCTYPE svg [<!ENTITY e0 \"laughs\">{bomb}]><svg>&e9;</svg>");
        assert!(expanded_length(&text) > 6_000_000_000, "ten to the ninth words of six letters");
        let circle = "<!DOCTYPE svg [<!ENTITY a \"&b;\"><!ENTITY b \"&a;\">]><svg>&a;</svg>";
        assert!(expanded_length(circle) < 1000, "a circle is not followed without end");
    }
}
