//! What a new file says of its keys, beside their values.

use super::{Holds, Table, Tables};

/// What a key may hold or means, by its path without the names of plates: `plate.drop`. `None` where the grammar knows no such key.
pub(crate) fn comment_of(table: &Table, path: &str) -> Option<String> {
    let (first, rest) = path.split_once('.').map_or((path, None), |(first, rest)| (first, Some(rest)));
    let key = table.key(first)?;
    match (rest, &key.holds) {
        (None, Holds::Words(words)) => Some(words().join(" | ")),
        (None, _) => Some(key.about.trim_end_matches('.').to_owned()),
        (Some(rest), Holds::Either(choices)) => choices.iter().find_map(|choice| match choice {
            Holds::Table(table) => comment_of(table, rest),
            _ => None,
        }),
        (Some(rest), Holds::Table(table) | Holds::Tables(Tables { of: table, .. })) => {
            comment_of(table, rest)
        }
        (Some(_), _) => None,
    }
}
