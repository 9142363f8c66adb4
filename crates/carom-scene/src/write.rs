//! Writing one value into the text of a scene, as a person types it.

use crate::drawn::Drawn;
use crate::editing::{after, as_toml};
use crate::problem::{Problem, ProblemKind, Problems};
use crate::scene::{NamedQuantity, Scene};
use crate::space::SpaceScene;
use crate::visit::unknown;
use std::ops::Range;

impl Scene {
    /// The text of the scene with a quantity written as somebody typed it: `0.2`, `25 ± 0.5 deg`, `{ low = "1 mm", high = "2 mm" }`. What the
    /// file does not write yet comes after the last value of its table; comments and all else stay. The text is not read: who reads it
    /// is told what is wrong with the value, and where.
    ///
    /// # Errors
    /// No such quantity.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Scene;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let steeper = scene.text_writing("plate.upper.slope", "12 ± 0.5 deg")?;
    /// assert!(steeper.contains("slope = \"12 ± 0.5 deg\""));
    /// let faster = scene.text_writing("start.speed", "0.1 m/s")?;
    /// assert!(faster.contains("to_edge = \"100 mm\"\nspeed = \"0.1 m/s\"\n"), "{faster}");
    /// assert_eq!(Scene::parse("faster.toml", &faster)?.feeder().start.speed, 0.1);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text_writing(&self, path: &str, value: &str) -> Result<String, Problems> {
        self.text_writing_all(&[(path, value)])
    }

    /// As [`Scene::text_writing`], with several quantities at once: what belongs together need not be right one by one.
    ///
    /// # Errors
    /// Every path that the scene does not have, and every one that is named twice.
    ///
    /// # Example
    /// A shorter rod needs a smaller inertia.
    /// ```
    /// use carom_scene::Scene;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let text = scene.text_writing_all(&[("part.length", "50 mm"), ("part.inertia", "6e-5 kg m^2")])?;
    /// assert!(Scene::parse("short.toml", &text).is_ok());
    /// assert!(Scene::parse("short.toml", &scene.text_writing("part.length", "50 mm")?).is_err());
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn text_writing_all(&self, values: &[(&str, &str)]) -> Result<String, Problems> {
        written_all(self, values)
    }
}

impl SpaceScene {
    /// As [`Scene::text_writing_all`].
    ///
    /// # Errors
    /// As there.
    ///
    /// # Example
    /// ```
    /// use carom_scene::SpaceScene;
    /// let text = std::fs::read_to_string("../../examples/solid.toml")?;
    /// let scene = SpaceScene::parse("solid.toml", &text)?;
    /// let text = scene.text_writing_all(&[("start.aside", "2 mm"), ("contact.restitution", "0.2")])?;
    /// assert_eq!(SpaceScene::parse("aside.toml", &text)?.feeder().start.aside, 2e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn text_writing_all(&self, values: &[(&str, &str)]) -> Result<String, Problems> {
        written_all(self, values)
    }
}

fn written_all(scene: &impl Drawn, values: &[(&str, &str)]) -> Result<String, Problems> {
    let all = scene.quantities();
    let paths: Vec<&str> = all.iter().map(|quantity| quantity.path.as_str()).collect();
    let (mut problems, mut edits): (Vec<Problem>, Vec<(Range<usize>, String)>) = (vec![], vec![]);
    for (k, (path, value)) in values.iter().enumerate() {
        let Some(quantity) = all.iter().find(|quantity| quantity.path == *path) else {
            problems.push(unknown(path, &paths));
            continue;
        };
        if values[..k].iter().any(|(other, _)| other == path) {
            problems.push(Problem::new(ProblemKind::Conflict, *path, "is named twice", None));
        }
        let value = as_toml(value);
        edits.push(match &quantity.span {
            Some(span) => (span.clone(), value),
            None => {
                let (at, line) = place_of(scene.source(), quantity, &all, &value);
                (at..at, line)
            }
        });
    }
    if !problems.is_empty() {
        return Err(Problems::new(scene.file(), scene.source(), problems));
    }
    // From the end to the beginning, so that places before stay where they are; what comes to one place comes in its order.
    edits.reverse();
    edits.sort_by_key(|(place, _)| std::cmp::Reverse(place.start));
    let mut text = scene.source().to_owned();
    for (place, new) in edits {
        // A table that was begun for another value is not begun again.
        let begun = new.strip_prefix('\n').and_then(|new| new.split_once('\n'));
        match begun.filter(|(head, _)| head.starts_with('[') && text[place.start..].contains(*head)) {
            Some((head, line)) => {
                let at = place.start + text[place.start..].find(head).unwrap_or(0) + head.len() + 1;
                text.insert_str(at, line);
            }
            None => text.replace_range(place, &new),
        }
    }
    Ok(text)
}

/// Where a quantity that is not written comes, and the text that is put there.
fn place_of(text: &str, quantity: &NamedQuantity, all: &[NamedQuantity], value: &str) -> (usize, String) {
    let (table, key) = quantity.path.rsplit_once('.').unwrap_or(("", &quantity.path));
    let beside = |other: &&NamedQuantity| other.path.rsplit_once('.').map(|(table, _)| table) == Some(table);
    let last = all.iter().filter(beside).filter_map(|other| other.span.clone()).max_by_key(|span| span.end);
    let Some(last) = last else {
        // Of the root's own tables come later; another table is begun at the end.
        return match table {
            "" => (0, format!("{key} = {value}\n")),
            _ => (text.len(), format!("\n[{table}]\n{key} = {value}\n")),
        };
    };
    after(text, last.end, key, value)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;

    fn case_2() -> Scene {
        Scene::read("../../examples/case_2.toml".as_ref()).unwrap()
    }

    #[test]
    fn every_quantity_can_be_written_and_is_read_back() {
        let scene = case_2();
        for quantity in scene.quantities() {
            let dimension = quantity.kind.dimension;
            let value = format!("{:?} {}", quantity.value, dimension.si());
            let text = scene.text_writing(&quantity.path, &value).unwrap();
            let again = Scene::parse("again.toml", &text).unwrap_or_else(|problems| panic!("{problems}"));
            let now = again.quantities().into_iter().find(|other| other.path == quantity.path).unwrap();
            assert_eq!((now.value, now.written), (quantity.value, true), "{} in\n{text}", quantity.path);
        }
    }

    #[test]
    fn all_quantities_can_be_written_at_once() {
        let scene = case_2();
        let all = scene.quantities();
        let texts: Vec<String> =
            all.iter().map(|of| format!("{:?} {}", of.value, of.kind.dimension.si())).collect();
        let values: Vec<(&str, &str)> =
            all.iter().zip(&texts).map(|(of, text)| (of.path.as_str(), text.as_str())).collect();
        for values in [values.clone(), values.into_iter().rev().collect()] {
            let text = scene.text_writing_all(&values).unwrap();
            let again = Scene::parse("again.toml", &text).unwrap_or_else(|problems| panic!("{problems}"));
            let now = again.quantities();
            assert!(now.iter().all(|of| of.written), "all of them:\n{text}");
            assert!(now.iter().zip(&all).all(|(now, of)| now.value == of.value), "as they were:\n{text}");
        }
        let problems =
            scene.text_writing_all(&[("a", "1"), ("part.mass", "1"), ("part.mass", "2"), ("b", "1")]);
        assert_eq!(problems.unwrap_err().list.len(), 3, "two that are not there, and one twice");
    }

    #[test]
    fn a_table_in_one_line_stays_in_one_line() {
        let text = "part = { shape = 'rod', length = '40 mm', mass = '0.1 kg' }\ncontact = { friction = 0.15 }\n\
                    start = { to_edge = '60 mm' }\nplate = [{ slope = '25 deg' }]\n";
        let scene = Scene::parse("lines.toml", text).unwrap();
        let now = scene.text_writing("start.speed", "1 m/s").unwrap();
        assert!(now.contains("start = { to_edge = '60 mm', speed = \"1 m/s\" }\n"), "{now}");
    }

    #[test]
    fn a_last_line_without_an_end_gets_one() {
        let text = case_2()
            .source()
            .trim_end()
            .replace("line     = { along = \"428 mm\", normal = \"300 mm\" }", "");
        let scene =
            Scene::parse("cut.toml", &format!("{text}\nline = {{ along = '428 mm', normal = '300 mm' }}"))
                .unwrap();
        let now = scene.text_writing("contact.restitution", "0.1").unwrap();
        assert_eq!(Scene::parse("cut.toml", &now).unwrap().feeder().plates[0].restitution, 0.1, "{now}");
    }

    #[test]
    fn what_is_typed_is_told_as_typed_where_it_is_wrong() {
        let text = case_2().text_writing("plate.upper.slope", "12 \"deg").unwrap();
        let problems = Scene::parse("typed.toml", &text).unwrap_err();
        assert_eq!(problems.list[0].path, "plate.upper.slope", "{problems}");
    }
}
