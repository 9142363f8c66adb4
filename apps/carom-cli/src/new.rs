//! `carom new`: a scene to start from.

use crate::args::{Format, NewOptions, Output};
use crate::failure::Failure;
use crate::files;
use carom_scene::Form;
use carom_sweep::disk;
use std::io::Write;
use std::path::Path;

const HEAD: &str = r#"# A gravity-impact part feeder. Quantities have units; "15 ± 0.5 deg" is a tolerance.
# Run it with `carom run FILE`, look at it with `carom draw FILE`.
"#;

/// The tables of a new scene before its plates; what each key means comes from the grammar of scenes.
const TABLES: [(&str, &[(&str, &str)]); 4] = [
    (
        "part",
        &[
            ("shape", "\"box\""),
            ("length", "\"60 mm\""),
            ("height", "\"3 mm\""),
            ("depth", "\"25 mm\""),
            ("density", "\"7800 kg/m^3\""),
        ],
    ),
    ("contact", &[("friction", "0.2"), ("restitution", "0.1")]),
    ("start", &[("to_edge", "\"60 mm\"")]),
    ("channel", &[("width", "\"220 mm\"")]),
];

/// A scene with so many plates, hinged by turns at the left and the right wall.
pub(crate) fn scene(plates: u32) -> String {
    let mut text = HEAD.to_owned();
    for (table, keys) in TABLES {
        text.push_str(&format!("\n[{table}]\n"));
        keys.iter().for_each(|(key, value)| text.push_str(&line(table, key, value, true)));
    }
    let names = names(plates);
    for (i, name) in names.iter().enumerate() {
        let wall = if i % 2 == 0 { "\"left\"" } else { "\"right\"" };
        let level = if i == 0 { ("height", "\"0 mm\"") } else { ("drop", "\"110 mm\"") };
        let name = format!("\"{name}\"");
        let keys =
            [("name", name.as_str()), ("wall", wall), level, ("slope", "\"22 deg\""), ("gap", "\"80 mm\"")];
        text.push_str("\n[[plate]]\n");
        for (key, value) in keys {
            // Said once: the first plate shows all keys but its drop, the second that.
            text.push_str(&line("plate", key, value, i == 0 || (i == 1 && key == "drop")));
        }
    }
    text
}

/// Names that say where a plate is, and do not look like the numbers that paths have.
fn names(plates: u32) -> Vec<String> {
    const FEW: [&[&str]; 4] = [&[], &["upper"], &["upper", "lower"], &["upper", "middle", "lower"]];
    const ORDER: [&str; 10] =
        ["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"];
    let plates = plates as usize;
    if let Some(few) = FEW.get(plates) {
        return few.iter().map(|name| (*name).to_owned()).collect();
    }
    let beyond = |i: usize| match (i + 1) % 10 {
        1 if i > 10 => format!("{}st", i + 1),
        2 if i > 11 => format!("{}nd", i + 1),
        3 if i > 12 => format!("{}rd", i + 1),
        _ => format!("{}th", i + 1),
    };
    (0..plates).map(|i| ORDER.get(i).map_or_else(|| beyond(i), |name| (*name).to_owned())).collect()
}

/// A key with its value and, where that is asked for, what it means.
fn line(table: &str, key: &str, value: &str, explained: bool) -> String {
    let comment = Form::Scene.comment(&format!("{table}.{key}")).filter(|_| explained);
    let comment = comment.map_or(String::new(), |comment| format!("# {comment}"));
    format!("{}\n", format!("{key:<11} = {value:<15} {comment}").trim_end())
}

pub(crate) fn new(options: &NewOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let text = scene(options.plates);
    if options.file == Path::new("-") {
        return Ok(out.write_all(text.as_bytes())?);
    }
    let folder = output.out.as_deref().unwrap_or(Path::new(""));
    let path = &folder.join(&options.file);
    if !folder.as_os_str().is_empty() {
        disk::make_folder(folder).map_err(|error| Failure::file("make the folder", folder, &error))?;
    }
    let last = path.file_name().map(|last| last.to_string_lossy().into_owned()).unwrap_or_default();
    let part = files::part_of(path.parent().unwrap_or(folder), &last);
    let written = disk::add(path, &part, text.as_bytes());
    written.map_err(|error| match error.kind() {
        std::io::ErrorKind::AlreadyExists => {
            Failure::Undone(format!("{} is there already: it is left as it is", path.display()))
        }
        _ => Failure::file("write", path, &error),
    })?;
    let path = path.display().to_string();
    match output.format {
        Format::Text => writeln!(out, "{path} written: `carom run {path}` runs it")?,
        Format::Json => writeln!(out, "{}", serde_json::json!({ "written": path }))?,
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_scene::Scene;

    #[test]
    fn every_key_of_a_new_scene_is_explained() {
        let text = scene(2);
        for (table, keys) in TABLES {
            for (key, _) in keys {
                assert!(
                    Form::Scene.comment(&format!("{table}.{key}")).is_some(),
                    "{table}.{key} means something"
                );
            }
        }
        assert!(text.contains("# Drop of the hinge, below the previous plate's hinge"), "{text}");
        assert!(text.contains("# rod | box | polygon | "), "{text}");
    }

    #[test]
    fn plates_of_a_new_scene_are_named_by_where_they_are() {
        assert_eq!((names(1), names(2)), (vec!["upper".into()], vec!["upper".into(), "lower".into()]));
        assert_eq!(names(3), ["upper", "middle", "lower"]);
        assert_eq!(names(4), ["first", "second", "third", "fourth"]);
        assert_eq!(names(50)[9..13], ["tenth", "11th", "12th", "13th"]);
        assert_eq!(names(50)[20..24], ["21st", "22nd", "23rd", "24th"]);
        assert!(scene(2).contains("name        = \"lower\""), "{}", scene(2));
    }

    #[test]
    fn every_new_scene_is_a_scene() {
        for plates in [1, 2, 3, 50] {
            let scene =
                Scene::parse("new.toml", &scene(plates)).unwrap_or_else(|problems| panic!("{problems}"));
            assert_eq!(scene.feeder().plates.len(), plates as usize);
        }
    }
}
