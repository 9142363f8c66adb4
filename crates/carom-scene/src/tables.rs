//! Adding, removing and replacing whole tables in the text of a scene.

use crate::scene::Scene;
use std::ops::Range;

impl Scene {
    /// The text of the scene with one more `[[plate]]` or `[[wall]]` at its end; `lines` are its keys, as TOML. The text is not read: who
    /// reads it is told where that makes no scene.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Scene;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let text = scene.text_adding("wall", "name = \"stop\"\nfrom = [\"0.5 m\", \"0 m\"]\nto = [\"0.5 m\", \"-0.6 m\"]");
    /// assert_eq!(Scene::parse("walled.toml", &text)?.feeder().walls[0].name, "stop");
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text_adding(&self, table: &str, lines: &str) -> String {
        format!("{}\n\n[[{table}]]\n{}\n", self.source().trim_end(), lines.trim_end())
    }

    /// The text of the scene without its `[[plate]]` or `[[wall]]` of this number from 0; `None` where it has no table of its own, as those of
    /// a zig-zag.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Scene;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let text = scene.text_without("plate", 1).unwrap();
    /// assert_eq!(Scene::parse("short.toml", &text)?.feeder().plates.len(), 1);
    /// assert_eq!(scene.text_without("plate", 2), None);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text_without(&self, table: &str, number: usize) -> Option<String> {
        let text = self.source();
        let place = blocks(text, &format!("[[{table}]]")).into_iter().nth(number)?;
        let [before, after] = [&text[..place.start], &text[place.end..]];
        Some(format!("{}\n{}{}", before.trim_end(), if after.is_empty() { "" } else { "\n" }, after))
    }

    /// The text of the scene with this wanted on the plate of this number from 0: `turned`, `same`, `any` or a face's number; nothing where it is
    /// empty. `None` where the plate has no table of its own.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{Scene, Want};
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let wanted = scene.text_wanting(1, "turned").unwrap();
    /// assert_eq!(Scene::parse("wanted.toml", &wanted)?.wants(), [None, Some(Want::Turned)]);
    /// assert_eq!(scene.text_wanting(2, "turned"), None);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text_wanting(&self, plate: usize, want: &str) -> Option<String> {
        let text = self.source();
        let block = blocks(text, "[[plate]]").into_iter().nth(plate)?;
        let number = want.parse::<usize>().is_ok();
        let line = match want {
            "" => String::new(),
            _ if number => format!("want = {want}\n"),
            _ => format!("want = {}\n", toml::Value::String(want.to_owned())),
        };
        let begins = |line: &str| line.split_once('=').is_some_and(|(key, _)| key.trim() == "want");
        let own = lines_of(&text[block.clone()]).find(|place| begins(&text[block.clone()][place.clone()]));
        let place = match own {
            Some(own) => {
                let end = block.start + own.end;
                let newline = text[end..].find('\n').map_or(0, |newline| newline + 1);
                block.start + own.start..end + newline
            }
            // After its last key: what stands below may be another table's.
            None => {
                let end = block.start + text[block.clone()].trim_end().len();
                let newline = text[end..].find('\n').map_or(0, |newline| newline + 1);
                end + newline..end + newline
            }
        };
        let before = &text[..place.start];
        let gap = if before.is_empty() || before.ends_with('\n') { "" } else { "\n" };
        Some(format!("{before}{gap}{line}{}", &text[place.end..]))
    }

    /// The text of the scene with other keys in a table, `[part]` say; what is written there goes, comments above it stay. A table that is not
    /// there comes at the end.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Scene;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let text = scene.text_replacing("part", "shape = \"box\"\nlength = \"80 mm\"\nheight = \"10 mm\"\nmass = \"0.2 kg\"");
    /// assert_eq!(Scene::parse("box.toml", &text)?.feeder().part.body.mass, 0.2);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text_replacing(&self, table: &str, lines: &str) -> String {
        let text = self.source();
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
            Some(place) => format!(
                "{}{}\n{body}",
                &text[..place.start],
                text[place.end..].trim_start_matches('\n').trim_end()
            ),
            None => format!("{}\n\n{body}", text.trim_end()),
        }
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

/// The tables under this head, each from its head to the next one's; comments right above the next head are that one's.
fn blocks(text: &str, head: &str) -> Vec<Range<usize>> {
    let lines: Vec<Range<usize>> = lines_of(text).collect();
    let said = |place: &Range<usize>| {
        let line = text[place.clone()].trim();
        // `[part] # the part`, but no list that goes on over lines.
        line.split('#').next().unwrap_or_default().trim().to_owned()
    };
    let is_head = |place: &Range<usize>| {
        let said = said(place);
        said.starts_with('[') && said.ends_with(']') && !said.contains(',') && !said.contains('"')
    };
    let mut found = vec![];
    for (i, place) in lines.iter().enumerate() {
        if said(place).replace(' ', "") != head {
            continue;
        }
        let next = lines[i + 1..].iter().position(is_head).map_or(lines.len(), |more| i + 1 + more);
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

    fn designer() -> Scene {
        Scene::read("../../examples/designer.toml".as_ref()).unwrap()
    }

    #[test]
    fn a_plate_that_was_added_can_be_taken_away_again() {
        let scene = designer();
        let line = "name = \"third\"\nfrom = [\"0.3 m\", \"-0.5 m\"]\nto = [\"0.1 m\", \"-0.6 m\"]";
        let more = Scene::parse("more.toml", &scene.text_adding("plate", line)).unwrap();
        assert_eq!(more.feeder().plates.len(), scene.feeder().plates.len() + 1, "{}", more.source());
        let again = Scene::parse("again.toml", &more.text_without("plate", 2).unwrap()).unwrap();
        assert_eq!(again.feeder(), scene.feeder(), "{}", again.source());
    }

    #[test]
    fn comments_above_the_next_table_stay() {
        let text = "[part] # what\nshape = \"rod\"\nlength = \"0.1 m\"\nmass = \"1 kg\"\n\n# how rough\n[contact]\nfriction = 0.1\n\n\
                    [start]\nto_edge = \"0.1 m\"\n\n[[plate]]\nslope = \"15 deg\"\n";
        let scene = Scene::parse("told.toml", text).unwrap();
        let now = scene.text_replacing("part", "shape = \"disc\"\nradius = \"20 mm\"\nmass = \"1 kg\"");
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
        let now = scene.text_replacing("part", "shape = \"disc\"\nradius = \"20 mm\"\nmass = \"1 kg\"");
        assert_eq!(Scene::parse("now.toml", &now).unwrap().feeder().part.body.mass, 1.0, "{now}");
        assert_eq!(scene.text_without("plate", 0), None, "a list in one line has no table to take away");
    }
}
