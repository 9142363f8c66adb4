//! Changing the text of a file: tables that come, go and are replaced, and single values. What else the text holds, comments too, stays. The text is
//! not read: who reads it is told where it makes no scene.

use crate::node::{Entry, Node, Value, from_toml};
use std::ops::Range;

/// The text with one more `[[table]]` at its end; `lines` are its keys, as TOML.
///
/// # Example
/// ```
/// use carom_scene::{Scene, editing};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let lines = "name = \"stop\"\nfrom = [\"0.5 m\", \"0 m\"]\nto = [\"0.5 m\", \"-0.6 m\"]";
/// let text = editing::adding(scene.source(), "wall", lines);
/// assert_eq!(Scene::parse("walled.toml", &text)?.feeder().walls[0].name, "stop");
/// # Ok::<(), carom_scene::Problems>(())
/// ```
pub fn adding(text: &str, table: &str, lines: &str) -> String {
    ended_as(text, format!("{}\n\n[[{table}]]\n{}\n", text.trim_end(), lines.trim_end()))
}

/// A changed text whose lines end as those of the text before.
fn ended_as(before: &str, text: String) -> String {
    if before.contains("\r\n") { text.replace("\r\n", "\n").replace('\n', "\r\n") } else { text }
}

/// The text without its `[[table]]` of this number from 0; `None` where it has no table of its own, as the plates of a zig-zag.
///
/// # Example
/// ```
/// use carom_scene::{Scene, editing};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let text = editing::without(scene.source(), "plate", 1).unwrap();
/// assert_eq!(Scene::parse("short.toml", &text)?.feeder().plates.len(), 1);
/// assert_eq!(editing::without(scene.source(), "plate", 2), None);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
pub fn without(text: &str, table: &str, number: usize) -> Option<String> {
    let place = blocks(text, &format!("[[{table}]]")).into_iter().nth(number)?;
    let [before, after] = [&text[..place.start], &text[place.end..]];
    let gap = if after.is_empty() { "" } else { "\n" };
    Some(ended_as(text, format!("{}\n{gap}{after}", before.trim_end())))
}

/// The text with another value of a key: of a table `body`, of a list of tables `contact.0`, or at the top where the table is empty. The value is
/// written as a person types it: `0.2`, `25 deg`, `[0, 1]`. An empty one takes the key away. `None` where there is no such table.
///
/// # Example
/// ```
/// use carom_scene::{Scene, Want, editing};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let wanted = editing::setting(scene.source(), "plate.1", "want", "turned").unwrap();
/// assert_eq!(Scene::parse("wanted.toml", &wanted)?.wants(), [None, Some(Want::Turned)]);
/// assert_eq!(editing::setting(&wanted, "plate.1", "want", ""), Some(scene.source().to_owned()));
/// assert_eq!(editing::setting(&wanted, "plate.2", "want", "same"), None);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
pub fn setting(text: &str, table: &str, key: &str, value: &str) -> Option<String> {
    let (tree, _) = from_toml(text);
    let entries = table_at(&tree, table)?;
    let own = entries.iter().find(|entry| entry.key == key);
    let value = as_toml(value);
    let changed = match own {
        Some(entry) if value.is_empty() => removed(text, entry),
        Some(entry) => {
            let Range { start, end } = entry.node.span.clone();
            format!("{}{value}{}", &text[..start], &text[end..])
        }
        None if value.is_empty() => text.to_owned(),
        None => {
            let inner = |entry: &&Entry| {
                !matches!(&entry.node.value, Value::Table(_))
                    && !matches!(&entry.node.value, Value::List(list) if list.iter().any(|node| matches!(node.value, Value::Table(_))))
            };
            let last = entries.iter().filter(inner).max_by_key(|entry| entry.node.span.end);
            let (at, line) = match last {
                Some(last) => {
                    after(text, last.node.span.end, &format!("{}{key}", before_key(text, last)), &value)
                }
                None => (head_end(text, table)?, format!("{key} = {value}\n")),
            };
            format!("{}{line}{}", &text[..at], &text[at..])
        }
    };
    Some(ended_as(text, changed))
}

/// What stands before a key that is written with its table, `body.` of `body.mass`; else nothing.
fn before_key<'t>(text: &'t str, entry: &Entry) -> &'t str {
    let start = text[..entry.key_span.start].rfind(['\n', ',', '{']).map_or(0, |at| at + 1);
    let before = text[start..entry.key_span.start].trim_start();
    if before.trim_end().ends_with('.') { before } else { "" }
}

/// The entries of a table by its path; numbers count lists.
fn table_at<'n>(tree: &'n Node, path: &str) -> Option<&'n [Entry]> {
    let mut node = tree;
    for part in path.split('.').filter(|part| !part.is_empty()) {
        node = match &node.value {
            Value::Table(entries) => &entries.iter().find(|entry| entry.key == part)?.node,
            Value::List(list) => list.get(part.parse::<usize>().ok()?)?,
            _ => return None,
        };
    }
    match &node.value {
        Value::Table(entries) => Some(entries),
        _ => None,
    }
}

/// The text without an entry: its line, or its place in a table of one line.
fn removed(text: &str, entry: &Entry) -> String {
    let (start, end) = (entry.key_span.start - before_key(text, entry).len(), entry.node.span.end);
    let line = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
    let rest = text[end..].find('\n').map_or(text.len(), |newline| end + newline + 1);
    let alone = text[line..start].trim().is_empty()
        && text[end..rest].split('#').next().is_some_and(|rest| rest.trim().is_empty());
    if alone {
        return format!("{}{}", &text[..line], &text[rest..]);
    }
    // With the comma before it, or after it where it is the first.
    let before = text[..start].trim_end();
    match before.strip_suffix(',') {
        Some(before) => format!("{before}{}", &text[end..]),
        None => format!("{}{}", &text[..start], text[end..].trim_start_matches([',', ' '])),
    }
}

/// Where the lines of a table without values begin.
fn head_end(text: &str, table: &str) -> Option<usize> {
    let (head, number) = match table.rsplit_once('.').and_then(|(list, n)| Some((list, n.parse().ok()?))) {
        Some((list, number)) => (format!("[[{list}]]"), number),
        None => (format!("[{table}]"), 0),
    };
    if table.is_empty() {
        return Some(0);
    }
    let block = blocks(text, &head).into_iter().nth(number)?;
    Some(text[block.start..].find('\n').map_or(text.len(), |newline| block.start + newline + 1))
}

/// Where a key that is not written yet comes, after the value that ends at `last`, and the text that is put there.
pub(crate) fn after(text: &str, last: usize, key: &str, value: &str) -> (usize, String) {
    let rest = text[last..].lines().next().unwrap_or_default();
    let ends_line = rest.trim_start().is_empty() || rest.trim_start().starts_with('#');
    if !ends_line {
        // A table in one line.
        return (last, format!(", {key} = {value}"));
    }
    let end = last + rest.len();
    let newline = if text[end..].starts_with("\r\n") { 2 } else { usize::from(end < text.len()) };
    let before = if newline == 0 { "\n" } else { "" };
    (end + newline, format!("{before}{key} = {value}\n"))
}

/// A number, a flag, a table or a list as it stands; all else is a string.
pub(crate) fn as_toml(typed: &str) -> String {
    let typed = typed.trim();
    let is_toml = |text: &str| toml::from_str::<toml::Table>(&format!("value = {text}")).is_ok();
    let number = typed.parse::<f64>().ok().filter(|number| number.is_finite());
    match number {
        Some(_) if is_toml(typed) => return typed.to_owned(),
        // `.5` and `5.` are numbers to who types them.
        Some(number) => return format!("{number:?}"),
        None if typed.is_empty() || ["true", "false"].contains(&typed) => return typed.to_owned(),
        // What begins a list or a table and does not end it would take in the rest of the file.
        None if typed.starts_with(['{', '[', '"', '\'']) && is_toml(typed) => return typed.to_owned(),
        None => {}
    }
    toml::Value::String(typed.to_owned()).to_string()
}

/// The text with other keys in a table, `[part]` say; what is written there goes, comments above it stay. A table that is not there comes at
/// the end.
///
/// # Example
/// ```
/// use carom_scene::{Scene, editing};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let lines = "shape = \"box\"\nlength = \"80 mm\"\nheight = \"10 mm\"\nmass = \"0.2 kg\"";
/// let text = editing::replacing(scene.source(), "part", lines);
/// assert_eq!(Scene::parse("box.toml", &text)?.feeder().part.body.mass, 0.2);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
pub fn replacing(text: &str, table: &str, lines: &str) -> String {
    ended_as(text, replaced(&without_inner(text, table), table, lines))
}

/// The text without the tables within a table: `[design.free]` of `design`.
fn without_inner(text: &str, table: &str) -> String {
    let inner = format!("[{table}.");
    let mut rest = text.to_owned();
    while let Some(head) = heads(&rest).into_iter().find(|head| head.starts_with(&inner)) {
        match blocks(&rest, &head).into_iter().next() {
            Some(place) => rest.replace_range(place, ""),
            None => break,
        }
    }
    rest
}

fn replaced(text: &str, table: &str, lines: &str) -> String {
    let head = format!("[{table}]");
    let body = format!("{head}\n{}\n", lines.trim_end());
    if let Some(place) = blocks(text, &head).into_iter().next() {
        let after = &text[place.end..];
        let gap = if after.is_empty() { "" } else { "\n" };
        return format!("{}{body}{gap}{after}", &text[..place.start]);
    }
    // In one line: `part = { … }`.
    let begins = |line: &str| line.split_once('=').is_some_and(|(key, _)| key.trim() == table);
    match lines_of(text).find(|place| begins(&text[place.clone()])) {
        Some(place) => {
            let rest = text[place.end..].trim_start_matches('\n').trim_end();
            format!("{}{rest}\n{body}", &text[..place.start])
        }
        None => format!("{}\n\n{body}", text.trim_end()),
    }
}

/// The places of the lines of a text, without their ends.
fn lines_of(text: &str) -> impl Iterator<Item = Range<usize>> {
    let mut start = 0;
    text.split_inclusive('\n').map(move |line| {
        let place = start..start + line.trim_end_matches(['\n', '\r']).len();
        start += line.len();
        place
    })
}

/// What stands on a line, without a remark.
fn said(text: &str) -> String {
    // `[part] # the part`.
    text.trim().split('#').next().unwrap_or_default().trim().replace(' ', "")
}

/// Whether a line is the head of a table, and no list that goes on over lines.
fn is_head(said: &str) -> bool {
    let name = said.trim_matches(['[', ']']);
    let named = name.chars().next().is_some_and(|first| !first.is_ascii_digit() && !"-+.".contains(first));
    said.starts_with('[') && said.ends_with(']') && named && !said.contains([',', '"'])
}

/// The heads of all tables, in their order.
fn heads(text: &str) -> Vec<String> {
    lines_of(text).map(|place| said(&text[place])).filter(|said| is_head(said)).collect()
}

/// The tables under this head, each from its head to the next one's; comments right above the next head are that one's.
fn blocks(text: &str, head: &str) -> Vec<Range<usize>> {
    let lines: Vec<Range<usize>> = lines_of(text).collect();
    let heads_at = |place: &Range<usize>| is_head(&said(&text[place.clone()]));
    let mut found = vec![];
    for (i, place) in lines.iter().enumerate() {
        if said(&text[place.clone()]) != head {
            continue;
        }
        let next = lines[i + 1..].iter().position(heads_at).map_or(lines.len(), |more| i + 1 + more);
        let mut end = next;
        while end > i + 1 && next < lines.len() && text[lines[end - 1].clone()].trim_start().starts_with('#')
        {
            end -= 1;
        }
        found.push(place.start..lines.get(end).map_or(text.len(), |next| next.start));
    }
    found
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::scene::Scene;

    fn designer() -> Scene {
        Scene::read("../../examples/designer.toml".as_ref()).unwrap()
    }

    #[test]
    fn a_plate_that_was_added_can_be_taken_away_again() {
        let scene = designer();
        let line = "name = \"third\"\nfrom = [\"0.3 m\", \"-0.5 m\"]\nto = [\"0.1 m\", \"-0.6 m\"]";
        let more = Scene::parse("more.toml", &adding(scene.source(), "plate", line)).unwrap();
        assert_eq!(more.feeder().plates.len(), scene.feeder().plates.len() + 1, "{}", more.source());
        let again = Scene::parse("again.toml", &without(more.source(), "plate", 2).unwrap()).unwrap();
        assert_eq!(again.feeder(), scene.feeder(), "{}", again.source());
    }

    #[test]
    fn comments_above_the_next_table_stay() {
        let text = "[part] # what\nshape = \"rod\"\nlength = \"0.1 m\"\nmass = \"1 kg\"\n\n# how rough\n[contact]\nfriction = 0.1\n\n\
                    [start]\nto_edge = \"0.1 m\"\n\n[[plate]]\nslope = \"15 deg\"\n";
        let scene = Scene::parse("told.toml", text).unwrap();
        let now = replacing(scene.source(), "part", "shape = \"disc\"\nradius = \"20 mm\"\nmass = \"1 kg\"");
        assert!(
            now.starts_with("[part]\nshape = \"disc\"") && now.contains("\n# how rough\n[contact]"),
            "{now}"
        );
        assert!(Scene::parse("now.toml", &now).is_ok(), "{now}");
    }

    #[test]
    fn a_part_in_one_line_is_replaced_by_a_table() {
        let text = "part = { shape = 'rod', length = '40 mm', mass = '0.1 kg' }\ncontact = { friction = 0.15 }\n\
                    start = { to_edge = '60 mm' }\nplate = [{ slope = '25 deg' }]\n";
        let scene = Scene::parse("lines.toml", text).unwrap();
        let now = replacing(scene.source(), "part", "shape = \"disc\"\nradius = \"20 mm\"\nmass = \"1 kg\"");
        assert_eq!(Scene::parse("now.toml", &now).unwrap().feeder().part.body.mass, 1.0, "{now}");
        assert_eq!(without(scene.source(), "plate", 0), None, "a list in one line has no table to take away");
    }

    #[test]
    fn a_value_is_set_where_its_key_is_or_after_the_last_one() {
        let text = "law = \"poisson\"\n\n[body]\nmass = \"1 kg\" # heavy\n\n[[contact]]\npoint = [0, 1]\n\n[[contact]]\npoint = [1, 1]\n";
        let set = |table: &str, key: &str, value: &str| setting(text, table, key, value).unwrap_or_default();
        assert!(set("", "law", "stronge").starts_with("law = \"stronge\"\n"), "at the top");
        assert!(
            set("", "sharing", "together").starts_with("law = \"poisson\"\nsharing = \"together\"\n"),
            "a new one"
        );
        assert!(
            set("body", "spin", "3 rad/s").contains("# heavy\nspin = \"3 rad/s\"\n\n"),
            "after the comment"
        );
        assert!(set("contact.1", "point", "[2, 2]").ends_with("point = [2, 2]\n"), "of a list");
        assert!(
            set("contact.0", "friction", "0.1").contains("point = [0, 1]\nfriction = 0.1\n"),
            "of the first"
        );
        assert_eq!(setting(text, "contact.2", "friction", "0.1"), None, "no such table");
    }

    #[test]
    fn a_key_is_taken_away_with_its_line_or_its_comma() {
        let text = "a = 1\nb = { c = 2, d = 3 }\ne = []\n";
        let gone = |table: &str, key: &str| setting(text, table, key, "").unwrap_or_default();
        assert_eq!(gone("", "a"), "b = { c = 2, d = 3 }\ne = []\n");
        assert_eq!(gone("b", "c"), "a = 1\nb = { d = 3 }\ne = []\n");
        assert_eq!(gone("b", "d"), "a = 1\nb = { c = 2 }\ne = []\n");
        assert_eq!(setting("[b]\n\n[c]\n", "b", "d", "1").as_deref(), Some("[b]\nd = 1\n\n[c]\n"));
    }

    #[test]
    fn keys_with_their_table_before_them_stay_so() {
        let text = "body.mass = \"1 kg\"\nbody.velocity = [0, -1]\n";
        assert_eq!(
            setting(text, "body", "spin", "1").as_deref(),
            Some("body.mass = \"1 kg\"\nbody.velocity = [0, -1]\nbody.spin = 1\n")
        );
        assert_eq!(setting(text, "body", "velocity", "").as_deref(), Some("body.mass = \"1 kg\"\n"));
    }

    #[test]
    fn lines_end_as_they_did() {
        let text = "[body]\r\nmass = 1\r\n";
        assert_eq!(setting(text, "body", "spin", "2").as_deref(), Some("[body]\r\nmass = 1\r\nspin = 2\r\n"));
        assert!(
            adding(text, "contact", "friction = 0.1").ends_with("\r\n[[contact]]\r\nfriction = 0.1\r\n"),
            "added"
        );
    }

    #[test]
    fn the_tables_within_a_replaced_one_go_with_it() {
        let text = "[design]\nmax_height = 1\n\n[design.free]\n\"a.b\" = \"1..2\"\n\n[part]\nmass = 1\n";
        let now = replacing(text, "design", "aim = \"time\"");
        assert_eq!(now, "[design]\naim = \"time\"\n\n[part]\nmass = 1\n");
    }

    #[test]
    fn what_is_typed_is_toml_by_itself() {
        for (typed, written) in [
            (".5", "0.5"),
            ("5.", "5.0"),
            ("01", "1.0"),
            ("0.25", "0.25"),
            ("[1, 2]", "[1, 2]"),
            ("true", "true"),
        ] {
            assert_eq!(as_toml(typed), written, "{typed}");
        }
        assert_eq!(as_toml("[1,2"), "\"[1,2\"", "a list without its end is a text");
        assert_eq!(as_toml("5 mm"), "\"5 mm\"");
    }
}
