//! Files that a command reads and writes, and opening them.

use crate::failure::Failure;
use crate::printed::tell;
use carom_scene::Drawn;
use carom_scene::columns::ColumnsError;
use carom_sweep::disk;
use std::path::{Component, Path, PathBuf};
use std::process::{Command, Stdio};

/// Pixels of a PNG for one of its drawing: sharp on paper and on dense screens.
#[cfg(feature = "png")]
const PIXELS: f64 = 2.0;

/// The text of an input file.
pub(crate) fn read_input(path: &Path) -> Result<String, Failure> {
    disk::read_text(path).map_err(|error| Failure::unread(path, &error))
}

/// Writes a file into a folder, which is made where it is missing; returns its path.
///
/// The text goes to a file of another name first, so that a broken write leaves the old file whole.
pub(crate) fn write(folder: &Path, name: &str, text: &str) -> Result<PathBuf, Failure> {
    write_bytes(folder, name, text.as_bytes())
}

/// As [`write`], of what is no text.
pub(crate) fn write_bytes(folder: &Path, name: &str, bytes: &[u8]) -> Result<PathBuf, Failure> {
    disk::make_folder(folder).map_err(|error| Failure::file("make the folder", folder, &error))?;
    let path = folder.join(name);
    let part = part_of(folder, name);
    disk::replace(&path, &part, bytes).map_err(|error| Failure::file("write", &path, &error))?;
    Ok(path)
}

/// The name under which a file is written.
pub(crate) fn part_of(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!(".{name}.part"))
}

/// Writes a drawing as SVG and, in a build that has PNG, twice as large as PNG; returns the paths.
pub(crate) fn write_drawing(folder: &Path, name: &str, svg: &str) -> Result<Vec<PathBuf>, Failure> {
    #[cfg(feature = "png")]
    let png =
        carom_figure::png(svg, PIXELS).map_err(|error| Failure::Undone(format!("{name}.png: {error}")))?;
    Ok(vec![
        write(folder, &format!("{name}.svg"), svg)?,
        #[cfg(feature = "png")]
        write_bytes(folder, &format!("{name}.png"), &png)?,
    ])
}

/// Writes a table into a Parquet file. A build without Parquet says that it leaves the file out: the other files hold the result as well.
pub(crate) fn write_table(
    folder: &Path,
    name: &str,
    table: Result<Vec<u8>, ColumnsError>,
) -> Result<Option<PathBuf>, Failure> {
    match table {
        Ok(bytes) => write_bytes(folder, name, &bytes).map(Some),
        Err(error @ ColumnsError::NoParquet) => {
            tell(&format!("{name} is left out: {error}"));
            Ok(None)
        }
        #[cfg(feature = "parquet")]
        Err(error @ ColumnsError::Parquet(_)) => Err(Failure::Undone(format!("{name}: {error}"))),
    }
}

/// Copies the file that draws a scene's part into a folder in which scenes of it are saved: they name it as the scene does.
pub(crate) fn bring_outline(scene: &impl Drawn, folder: &Path) -> Result<(), Failure> {
    let Some((name, file)) = scene.part_file() else { return Ok(()) };
    let inside =
        Path::new(name).components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    if Path::new(name).is_absolute() {
        return Ok(());
    }
    if !inside {
        tell(&format!(
            "saved scenes name {name}, which is outside {}: they run where that leads to the file",
            folder.display()
        ));
        return Ok(());
    }
    let bytes = disk::read_input(&file).map_err(|error| Failure::file("read", &file, &error))?;
    let place = folder.join(name);
    let parent = place.parent().unwrap_or(folder);
    let last = place.file_name().map(|last| last.to_string_lossy().into_owned()).unwrap_or_default();
    write_bytes(parent, &last, &bytes).map(drop)
}

/// Removes files of an earlier result, where they are.
pub(crate) fn remove(folder: &Path, names: &[&str]) -> Result<(), Failure> {
    for name in names {
        let path = folder.join(name);
        match disk::remove(&path) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                return Err(Failure::file("remove", &path, &error));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Removes every file of an earlier result that is known by its name.
pub(crate) fn remove_known(folder: &Path, known: impl Fn(&str) -> bool) -> Result<(), Failure> {
    let entries = disk::list(folder).map_err(|error| Failure::file("read", folder, &error))?;
    let names: Vec<String> = entries.into_iter().map(|(name, _)| name).filter(|name| known(name)).collect();
    remove(folder, &names.iter().map(String::as_str).collect::<Vec<_>>())
}

/// Opens a file with the program the desktop has for it.
pub(crate) fn open(path: &Path) -> Result<(), Failure> {
    let (program, first): (&str, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(target_os = "windows") {
        ("cmd", &["/C", "start", ""])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(first).arg(path).stdout(Stdio::null()).stderr(Stdio::null());
    let started = command.spawn().map(drop);
    started
        .map_err(|error| Failure::Undone(format!("cannot open {} with {program}: {error}", path.display())))
}
