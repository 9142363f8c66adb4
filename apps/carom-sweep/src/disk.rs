//! The calls that read and change files, in one place: tests can make each of them fail.

use carom::tasks::StudyError;
use carom_scene::{Problem, ProblemKind, Problems, input};
use std::cell::RefCell;
use std::fs::{File, OpenOptions};
use std::io::{Error, ErrorKind, Read, Result, Write};
use std::path::{Path, PathBuf};

/// Bytes that are handed to the system at once: between two pieces a disk may be found full.
const PIECE: usize = 1 << 14;

/// What is asked of the system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Call {
    /// A folder is made.
    MakeFolder,
    /// A file is begun.
    Create,
    /// A piece of it is written.
    Write,
    /// It is waited for until the file is on the disk.
    Sync,
    /// The file gets its name.
    Rename,
    /// A file is removed.
    Remove,
    /// It is waited for until the folder knows the name.
    SyncFolder,
    /// The entries of a folder are read.
    List,
    /// A file is opened.
    Open,
    /// A piece of it is read.
    Read,
}

/// Hears of each call before the system does, and may make it fail.
pub type Hear = Box<dyn FnMut(Call, &Path) -> Result<()>>;

thread_local! {
    /// Files are read and written on the thread that the work was begun on: every test has its own.
    static HEARS: RefCell<Option<Hear>> = const { RefCell::new(None) };
}

/// Lets somebody hear of the calls of this thread, or nobody any more; returns who did until now.
pub fn heard_by(hear: Option<Hear>) -> Option<Hear> {
    HEARS.replace(hear)
}

fn meet(call: Call, path: &Path) -> Result<()> {
    HEARS.with_borrow_mut(|hears| hears.as_mut().map_or(Ok(()), |hear| hear(call, path)))
}

/// Makes a folder and those it is in, where they are missing.
///
/// # Errors
/// The system's.
pub fn make_folder(folder: &Path) -> Result<()> {
    meet(Call::MakeFolder, folder)?;
    std::fs::create_dir_all(folder)
}

/// Writes a file as a whole or not at all: under another name first, renamed once it is on the disk.
///
/// # Errors
/// The system's. What was at `path` before is there still, and `part` is removed where that can be done.
pub fn replace(path: &Path, part: &Path, bytes: &[u8]) -> Result<()> {
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
pub fn add(path: &Path, part: &Path, bytes: &[u8]) -> Result<()> {
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
///
/// # Errors
/// The system's.
pub fn remove(path: &Path) -> Result<()> {
    meet(Call::Remove, path)?;
    std::fs::remove_file(path)
}

/// Waits until the folder of a file knows it by its name, where the system can.
///
/// # Errors
/// The system's.
#[cfg(unix)]
pub fn sync_folder_of(path: &Path) -> Result<()> {
    let Some(folder) = path.parent() else { return Ok(()) };
    meet(Call::SyncFolder, path)?;
    match File::open(folder)?.sync_all() {
        // Not every file system does that.
        Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => Ok(()),
        other => other,
    }
}

/// Nothing that could be done.
///
/// # Errors
/// The system's.
#[cfg(not(unix))]
pub fn sync_folder_of(_: &Path) -> Result<()> {
    Ok(())
}

/// Opens a file for a lock on it, new where it is missing.
///
/// # Errors
/// The system's.
pub fn open_lock(path: &Path) -> Result<File> {
    meet(Call::Create, path)?;
    OpenOptions::new().create(true).truncate(false).write(true).read(true).open(path)
}

/// The entries of a folder, by name.
///
/// # Errors
/// The system's.
pub fn list(folder: &Path) -> Result<Vec<(String, PathBuf)>> {
    meet(Call::List, folder)?;
    let entry = |entry: Result<std::fs::DirEntry>| {
        let entry = entry?;
        Ok((entry.file_name().to_string_lossy().into_owned(), entry.path()))
    };
    std::fs::read_dir(folder)?.map(entry).collect()
}

/// A file that is read from its beginning to its end.
#[derive(Debug)]
pub struct Reading {
    file: File,
    path: PathBuf,
}

/// Opens a file for reading.
///
/// # Errors
/// The system's.
pub fn open(path: &Path) -> Result<Reading> {
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
///
/// # Errors
/// The system's.
pub fn read(path: &Path) -> Result<Vec<u8>> {
    let mut bytes = vec![];
    open(path)?.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The bytes of an input, which may be anything and anyhow long.
///
/// # Errors
/// The system's.
pub fn read_input(path: &Path) -> Result<Vec<u8>> {
    input::whole(open(path)?)
}

/// The text of an input.
///
/// # Errors
/// The system's.
pub fn read_text(path: &Path) -> Result<String> {
    String::from_utf8(read_input(path)?).map_err(|_| Error::new(ErrorKind::InvalidData, "is not UTF-8 text"))
}

/// A file or folder with which something could not be done.
pub fn undone(doing: &str, path: &Path, error: &Error) -> StudyError {
    StudyError::Undone(format!("cannot {doing} {}: {error}", path.display()))
}

/// An input file that cannot be read.
pub fn unread(path: &Path, error: &Error) -> StudyError {
    let message = match error.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => error.to_string(),
    };
    let problem = Problem::new(ProblemKind::File, "", message, None);
    StudyError::from(Problems::new(&path.display().to_string(), "", vec![problem]))
}
