//! The reference page of the contacts that go by the names of their materials, from the table that the program reads.

/// The page: a row for each contact.
pub(crate) fn page(table: &str) -> String {
    let mut out = "# Contacts of two materials\n\n".to_owned();
    out.push_str(
        "What `contact = \"steel on steel, dry\"` stands for in a scene: a range of friction and one of restitution, every value equally likely. \
         A run takes the middles.\n\n",
    );
    out.push_str("| contact | friction | from | restitution | from |\n|---|---|---|---|---|\n");
    for contact in table.split("[[contact]]\n").skip(1) {
        let of = |key: &str| {
            let line = contact.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = "));
            line.unwrap_or_default().trim_matches(['"', '[', ']']).to_owned()
        };
        let range = |key: &str| of(key).replace(", ", " to ");
        out.push_str(&format!(
            "| `{}` | {} | {} | {} | {} |\n",
            of("name"),
            range("friction"),
            of("friction_source"),
            range("restitution"),
            of("restitution_source")
        ));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_contact_is_a_row() {
        let table = "# words\n[[contact]]\nname = \"a on b, dry\"\nfriction = [0.1, 0.2]\nfriction_source = \"book\"\nrestitution = [0.3, 0.4]\nrestitution_source = \"estimate\"\n";
        let page = page(table);
        assert!(page.ends_with("| `a on b, dry` | 0.1 to 0.2 | book | 0.3 to 0.4 | estimate |\n"), "{page}");
    }
}
