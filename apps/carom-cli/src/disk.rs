//! The calls that read and change files, in one place: in tests each of them can be made to fail.

use carom_scene::input;
use std::fs::{File, OpenOptions};
use std::io::{Error, ErrorKind, Read, Result, Write};
use std::path::{Path, PathBuf};

#[cfg(test)]
pub(crate) mod faults;
#[cfg(test)]
use faults::meet;

/// Bytes that are handed to the system at once: between two pieces a disk may be found full.
const PIECE: usize = 1 << 14;

/// What is asked of the system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Call {
    MakeFolder,
    Create,
    Write,
    Sync,
    Rename,
    Remove,
    SyncFolder,
    List,
    Open,
    Read,
}

/// Nothing but the system itself makes a call fail.
#[cfg(not(test))]
fn meet(_: Call, _: &Path) -> Result<()> {
    Ok(())
}

/// Makes a folder and those it is in, where they are missing.
pub(crate) fn make_folder(folder: &Path) -> Result<()> {
    meet(Call::MakeFolder, folder)?;
    std::fs::create_dir_all(folder)
}

/// Writes a file as a whole or not at all: under another name first, renamed once it is on the disk.
///
/// # Errors
/// The system's. What was at `path` before is there still, and `part` is removed where that can be done.
pub(crate) fn replace(path: &Path, part: &Path, bytes: &[u8]) -> Result<()> {
    let written = fill(path, part, bytes).and_then(|()| {
        meet(Call::Rename, path)?;
        std::fs::rename(part, path)
    });
    written.inspect_err(|_| discard(part))
}

/// Writes a file as [`replace`] does where there is none of that name.
///
/// # Errors
/// [`ErrorKind::AlreadyExists`] where there is one, which is left as it is; otherwise as [`replace`].
pub(crate) fn add(path: &Path, part: &Path, bytes: &[u8]) -> Result<()> {
    if path.symlink_metadata().is_ok() {
        return Err(ErrorKind::AlreadyExists.into());
    }
    fill(path, part, bytes).and_then(|()| name_new(path, part)).inspect_err(|_| discard(part))
}

/// Gives a file that is written its own name, which nobody must have taken meanwhile.
fn name_new(path: &Path, part: &Path) -> Result<()> {
    meet(Call::Rename, path)?;
    match std::fs::hard_link(part, path) {
        Ok(()) => {
            discard(part);
            Ok(())
        }
        Err(error) if error.kind() == ErrorKind::AlreadyExists => Err(error),
        // Not every file system has a file under two names.
        Err(_) => std::fs::rename(part, path),
    }
}

/// Writes what is to become the file `path`, and waits until it is on the disk.
fn fill(path: &Path, part: &Path, bytes: &[u8]) -> Result<()> {
    meet(Call::Create, path)?;
    let mut file = File::create(part)?;
    for piece in bytes.chunks(PIECE) {
        meet(Call::Write, path)?;
        file.write_all(piece)?;
    }
    meet(Call::Sync, path)?;
    file.sync_all()
}

/// Removes what is left of a write, if that can be done: it is in nobody's way.
fn discard(part: &Path) {
    let _ = remove(part);
}

/// Removes a file.
pub(crate) fn remove(path: &Path) -> Result<()> {
    meet(Call::Remove, path)?;
    std::fs::remove_file(path)
}

/// Waits until the folder of a file knows it by its name, where the system can.
#[cfg(unix)]
pub(crate) fn sync_folder_of(path: &Path) -> Result<()> {
    let Some(folder) = path.parent() else { return Ok(()) };
    meet(Call::SyncFolder, path)?;
    match File::open(folder)?.sync_all() {
        // Not every file system does that.
        Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => Ok(()),
        other => other,
    }
}

/// Nothing that could be done.
#[cfg(not(unix))]
pub(crate) fn sync_folder_of(_: &Path) -> Result<()> {
    Ok(())
}

/// Opens a file for a lock on it, new where it is missing.
pub(crate) fn open_lock(path: &Path) -> Result<File> {
    meet(Call::Create, path)?;
    OpenOptions::new().create(true).truncate(false).write(true).read(true).open(path)
}

/// The entries of a folder, by name.
pub(crate) fn list(folder: &Path) -> Result<Vec<(String, PathBuf)>> {
    meet(Call::List, folder)?;
    let entry = |entry: Result<std::fs::DirEntry>| {
        let entry = entry?;
        Ok((entry.file_name().to_string_lossy().into_owned(), entry.path()))
    };
    std::fs::read_dir(folder)?.map(entry).collect()
}

/// A file that is read from its beginning to its end.
pub(crate) struct Reading {
    file: File,
    path: PathBuf,
}

/// Opens a file for reading.
pub(crate) fn open(path: &Path) -> Result<Reading> {
    meet(Call::Open, path)?;
    Ok(Reading { file: input::open(path)?, path: path.to_owned() })
}

impl Read for Reading {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        meet(Call::Read, &self.path)?;
        self.file.read(buffer)
    }
}

/// The bytes of a file that a command wrote.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>> {
    let mut bytes = vec![];
    open(path)?.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The bytes of an input, which may be anything and anyhow long.
pub(crate) fn read_input(path: &Path) -> Result<Vec<u8>> {
    input::whole(open(path)?)
}

/// The text of an input.
pub(crate) fn read_text(path: &Path) -> Result<String> {
    String::from_utf8(read_input(path)?).map_err(|_| Error::new(ErrorKind::InvalidData, "is not UTF-8 text"))
}
