//! Which room of a crate may use which: arrows within crates.
//!
//! A room is a folder, and stands at a height; what it names by `crate::` stands lower, or is itself. It names one thing after the other from the
//! house on, so that a reader sees the room: neither all that there is, nor by another name, nor by `super::` out of its own room. Tests may look
//! anywhere.

use crate::{source, tree};
use std::path::Path;

/// A crate, or a room of one, that is made of rooms.
struct House {
    folder: &'static str,
    /// How code names what is in it.
    path: &'static str,
    /// Its rooms by height.
    rooms: &'static [(&'static str, u8)],
    /// What else it names that is no room: below all of them.
    ground: &'static [&'static str],
}

const HOUSES: [House; 5] = [
    House {
        folder: "crates/carom-impact/src",
        path: "crate::",
        rooms: &[("planar", 1), ("spatial", 1)],
        ground: &[
            "error",
            "faults",
            "law",
            "load",
            "subsets",
            "tolerance",
            "Faults",
            "ImpactError",
            "Law",
            "Load",
            "Phase",
        ],
    },
    House {
        folder: "crates/carom-impact/src/planar",
        path: "crate::planar::",
        rooms: &[("contacts", 0), ("rates", 1), ("stages", 2), ("ends", 2)],
        ground: &[],
    },
    House {
        folder: "crates/carom-impact/src/spatial",
        path: "crate::spatial::",
        rooms: &[("contacts", 0), ("rates", 1), ("ends", 1), ("stages", 2)],
        ground: &[],
    },
    House {
        folder: "crates/carom-motion/src/planar",
        path: "crate::planar::",
        rooms: &[("geometry", 0), ("record", 1), ("contact", 1), ("modes", 2), ("walk", 3), ("several", 4)],
        ground: &[],
    },
    House {
        folder: "crates/carom-motion/src/spatial",
        path: "crate::spatial::",
        rooms: &[("geometry", 0), ("modes", 1), ("record", 2), ("walk", 3)],
        ground: &["terms"],
    },
];

/// Checks every file of every room.
pub(crate) fn faults(root: &Path) -> Result<Vec<String>, String> {
    let mut found = vec![];
    let files = tree::files(root)?;
    for house in &HOUSES {
        for (file, place) in files.iter().filter_map(|file| Some((file, house.place(file)?))) {
            let text = tree::text(root, file)?.unwrap_or_default();
            found.extend(house.faults(place, &text).into_iter().map(|fault| format!("{file}: {fault}")));
        }
    }
    Ok(found)
}

impl House {
    /// The room that a file is in, and how deep. Files beside the rooms open them to the outside, and name what they like; so do tests.
    fn place<'f>(&self, file: &'f str) -> Option<(&'f str, usize)> {
        let within = file.strip_prefix(self.folder)?.strip_prefix('/')?;
        let (room, rest) = within.split_once('/')?;
        let folders = rest.matches('/').count();
        let is_test = rest.ends_with("tests.rs") || rest.contains("tests/");
        // A folder's own file is the folder.
        let depth = if rest.ends_with("mod.rs") { folders } else { folders + 1 };
        (file.ends_with(".rs") && !is_test).then_some((room, depth))
    }

    fn faults(&self, (room, depth): (&str, usize), text: &str) -> Vec<String> {
        let Some((_, height)) = self.rooms.iter().find(|(name, _)| *name == room) else {
            return vec![format!(
                "{room} is no room of {}: give it a height in xtask/src/rooms.rs",
                self.folder
            )];
        };
        let height = *height;
        let code = source::code_without_tests(text);
        if let Some(why) = self.roundabout(depth, &code) {
            return vec![why];
        }
        let named = named_after(&code, self.path);
        let fault = |name: &&str| match self.rooms.iter().find(|(other, _)| other == name) {
            Some((other, _)) if *other == room => None,
            Some((_, below)) if *below < height => None,
            Some((other, _)) => Some(format!("{room} -> {other}: the arrow points up or sideways")),
            None if self.ground.contains(name) => None,
            None => Some(format!("{room} -> {name}: name the room that it is in")),
        };
        named.iter().filter_map(fault).collect()
    }

    /// A way of naming things by which the room does not show.
    fn roundabout(&self, depth: usize, code: &str) -> Option<String> {
        let closed = self.path.trim_end_matches("::");
        let out = "super::".repeat(depth + 1);
        let whole = ["::*", " as ", ";"].map(|end| format!("{closed}{end}"));
        let in_group = closed.strip_prefix("crate::").is_some_and(|name| {
            code.split("crate::{").skip(1).any(|group| first_words(group).contains(&name))
        });
        if code.contains(&out) {
            return Some("super:: leads out of the room: name the other by crate::".to_owned());
        }
        if in_group || whole.iter().any(|taken| code.contains(taken.as_str())) {
            return Some(format!("{closed} is taken as a whole: name what is used, room by room"));
        }
        None
    }
}

/// The first names after a path: that of a name, those of a group.
fn named_after<'c>(code: &'c str, path: &str) -> Vec<&'c str> {
    let mut names = vec![];
    for (at, _) in code.match_indices(path) {
        // `crate::` is a path of its own, and no part of `$crate::` or of another word.
        if code[..at].ends_with(|c| source::is_word(c) || c == '$' || c == ':') {
            continue;
        }
        let rest = &code[at + path.len()..];
        match rest.strip_prefix('{') {
            Some(group) => names.extend(first_words(group)),
            None => names.extend(word(rest)),
        }
    }
    names
}

/// The first word of each member of a group, whose opening brace has been read.
fn first_words(group: &str) -> Vec<&str> {
    let (mut depth, mut names, mut begins) = (0, vec![], true);
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => begins = true,
            c if begins && source::is_word(c) => {
                names.extend(word(&group[at..]));
                begins = false;
            }
            _ => {}
        }
    }
    names
}

fn word(text: &str) -> Option<&str> {
    let end = text.find(|c| !source::is_word(c)).unwrap_or(text.len());
    Some(&text[..end]).filter(|word| !word.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn planar(room: &str, text: &str) -> Vec<String> {
        let house = house("crates/carom-motion/src/planar");
        house.faults((room, 1), text)
    }

    fn house(folder: &str) -> &'static House {
        HOUSES.iter().find(|house| house.folder == folder).unwrap()
    }

    #[test]
    fn a_room_uses_itself_and_what_stands_lower() {
        let text = "use crate::planar::{contact::{World, touching::Few}, geometry::State};\nuse crate::planar::walk::Walker;";
        assert!(planar("walk", text).is_empty(), "{:?}", planar("walk", text));
        assert_eq!(planar("modes", text).len(), 1, "a mode knows no walker");
        assert_eq!(planar("contact", text).len(), 1, "nor does a gap");
        assert_eq!(planar("contact", "use crate::planar::record::Observer;").len(), 1, "sideways");
    }

    #[test]
    fn comments_and_tests_may_name_anything() {
        let text = "/// See [`Walker`](crate::planar::walk::Walker).\n#[cfg(test)]\nmod tests {\n    use crate::planar::several::Crowd;\n}";
        assert!(planar("geometry", text).is_empty(), "{:?}", planar("geometry", text));
    }

    #[test]
    fn a_name_of_the_whole_house_is_no_room() {
        assert_eq!(planar("walk", "fn a(of: &crate::planar::World) {}").len(), 1, "the room is contact");
    }

    #[test]
    fn space_does_not_know_the_plane() {
        let house = house("crates/carom-impact/src");
        let spatial = house.place("crates/carom-impact/src/spatial/walk.rs").unwrap();
        assert!(
            house.faults(spatial, "use crate::{Law, spatial::Contact, tolerance::RANK};").is_empty(),
            "its own"
        );
        assert_eq!(house.faults(spatial, "use crate::planar::Slip;").len(), 1, "the plane's");
    }

    #[test]
    fn no_way_round_shows_less() {
        for text in [
            "use crate::planar::*;",
            "use crate::planar as plane;",
            "use crate::planar;",
            "use crate::{planar::several::Crowd, tolerance::INSTANT};",
            "use super::super::several::Crowd;",
        ] {
            assert_eq!(planar("geometry", text).len(), 1, "{text}");
        }
        assert!(
            planar("geometry", "use crate::planar::geometry::State;\nuse crate::{evaluated::lost, tolerance::INSTANT};\nuse super::Shape;")
                .is_empty(),
            "its own"
        );
        let house = house("crates/carom-motion/src/planar");
        assert_eq!(house.place("crates/carom-motion/src/planar/walk/series/along.rs"), Some(("walk", 2)));
        assert_eq!(
            house.place("crates/carom-motion/src/planar/walk/series/tests.rs"),
            None,
            "tests look anywhere"
        );
        assert_eq!(house.faults(("cellar", 1), "").len(), 1, "a folder without a height");
    }
}
