//! `carom new`: a scene to start from.

use crate::args::{Format, NewOptions, Output};
use crate::failure::Failure;
use crate::{disk, files};
use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;

const HEAD: &str = r#"# A gravity-impact part feeder. Quantities have units; "15 ± 0.5 deg" is a tolerance.
# Run it with `carom run FILE`, look at it with `carom draw FILE`.

[part]
shape  = "box"        # rod | box | polygon | disc | outline (from a DXF or SVG file)
length = "60 mm"
height = "3 mm"
depth  = "25 mm"
density = "7800 kg/m^3"   # or mass

[contact]
friction    = 0.2
restitution = 0.1

[start]               # lying flat on the first plate
to_edge = "60 mm"     # from the mass centre to the plate's free edge

[channel]             # two vertical walls
width = "220 mm"
"#;

/// A scene with so many plates, hinged by turns at the left and the right wall.
pub(crate) fn scene(plates: u32) -> String {
    let mut text = HEAD.to_owned();
    for i in 0..plates {
        let wall = if i % 2 == 0 { "left" } else { "right" };
        let level = if i == 0 {
            "height = \"0 mm\"       # of the hinge"
        } else if i == 1 {
            "drop   = \"110 mm\"     # of the hinge, below the one before"
        } else {
            "drop   = \"110 mm\""
        };
        // Writing to a String cannot fail.
        let _ = write!(
            text,
            "\n[[plate]]\nname   = \"plate {}\"\nwall   = \"{wall}\"\n{level}\nslope  = \"22 deg\"\ngap    = \"80 mm\"",
            i + 1
        );
        text.push_str(if i == 0 { "      # from its free edge to the other wall\n" } else { "\n" });
    }
    text
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
    fn every_new_scene_is_a_scene() {
        for plates in [1, 2, 3, 50] {
            let scene =
                Scene::parse("new.toml", &scene(plates)).unwrap_or_else(|problems| panic!("{problems}"));
            assert_eq!(scene.feeder().plates.len(), plates as usize);
        }
    }
}
