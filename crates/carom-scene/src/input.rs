//! Input files: read whole and once, never without end.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::{Path, PathBuf};

/// Longest input that is read into memory, in bytes.
pub const LONGEST: u64 = 64 << 20;

/// Where the files come from that a scene names.
///
/// # Example
/// A page in a browser has no disk: it holds the files that were dropped on it.
/// ```
/// use carom_scene::{Scene, input::{Files, InMemory}};
/// let mut dropped = InMemory::default();
/// dropped.insert("bracket.dxf".into(), std::fs::read("../../examples/bracket.dxf")?);
/// let text = std::fs::read_to_string("../../examples/bracket.toml")?;
/// let scene = Scene::parse_with("bracket.toml", &text, &dropped)?;
/// assert_eq!(scene.feeder(), Scene::read("../../examples/bracket.toml".as_ref())?.feeder());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Files {
    /// The bytes of a file.
    ///
    /// # Errors
    /// As [`bytes()`].
    fn bytes(&self, path: &Path) -> Result<Vec<u8>>;
}

/// The files of this machine.
///
/// # Example
/// ```
/// use carom_scene::input::{Disk, Files};
/// assert!(Disk.bytes("../../examples/case_1.toml".as_ref()).is_ok());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Disk;

impl Files for Disk {
    fn bytes(&self, path: &Path) -> Result<Vec<u8>> {
        bytes(path)
    }
}

/// Files by their paths, none of them on a disk.
///
/// # Example
/// ```
/// use carom_scene::input::{Files, InMemory};
/// assert!(InMemory::default().bytes("nowhere.dxf".as_ref()).is_err());
/// ```
pub type InMemory = BTreeMap<PathBuf, Vec<u8>>;

impl Files for InMemory {
    fn bytes(&self, path: &Path) -> Result<Vec<u8>> {
        self.get(path).cloned().ok_or_else(|| Error::from(ErrorKind::NotFound))
    }
}

/// The files beside a scene.
#[derive(Clone, Copy)]
pub(crate) struct Beside<'f> {
    /// The folder of the scene.
    pub(crate) folder: &'f Path,
    pub(crate) files: &'f dyn Files,
}

/// Opens a file that is to be read from its beginning to its end. A pipe with a name, which may wait for a writer forever, is refused;
/// one that the shell has opened (`/dev/stdin`, `<(…)`) is read.
///
/// # Errors
/// The system's, and [`ErrorKind::InvalidInput`] for a folder or a pipe.
///
/// # Example
/// ```
/// use carom_scene::input;
/// assert!(input::open("../../examples/case_1.toml".as_ref()).is_ok());
/// assert!(input::open("../../examples".as_ref()).is_err());
/// ```
pub fn open(path: &Path) -> Result<File> {
    let metadata = std::fs::metadata(path)?;
    if metadata.is_dir() {
        return Err(Error::new(ErrorKind::InvalidInput, "is a folder"));
    }
    if is_pipe(&metadata) && !is_open_already(path) {
        let why = "is a pipe that may never end: give a file, or /dev/stdin";
        return Err(Error::new(ErrorKind::InvalidInput, why));
    }
    File::open(path)
}

/// True where a file can be read as often as one likes, and its length is known.
///
/// # Example
/// ```
/// use carom_scene::input;
/// assert!(input::is_lasting("../../examples/case_1.toml".as_ref()));
/// assert!(!input::is_lasting("/dev/null".as_ref()));
/// ```
pub fn is_lasting(path: &Path) -> bool {
    std::fs::metadata(path).is_ok_and(|metadata| metadata.is_file())
}

/// The bytes of an input.
///
/// # Errors
/// As [`open`], and [`ErrorKind::FileTooLarge`] where it is longer than [`LONGEST`].
///
/// # Example
/// ```
/// use carom_scene::input;
/// assert!(input::bytes("../../examples/case_1.toml".as_ref())?.starts_with(b"#"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn bytes(path: &Path) -> Result<Vec<u8>> {
    whole(open(path)?)
}

/// The bytes of something that is open.
///
/// # Errors
/// The system's, and [`ErrorKind::FileTooLarge`] where it is longer than [`LONGEST`].
///
/// # Example
/// ```
/// use carom_scene::input;
/// assert_eq!(input::whole(&b"mass = 1"[..])?, b"mass = 1");
/// assert!(input::whole(std::io::repeat(0)).unwrap_err().to_string().contains("longer than 64 MiB"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn whole(from: impl Read) -> Result<Vec<u8>> {
    let mut bytes = vec![];
    from.take(LONGEST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LONGEST {
        let why = format!("is longer than {} MiB", LONGEST >> 20);
        return Err(Error::new(ErrorKind::FileTooLarge, why));
    }
    Ok(bytes)
}

/// The text of an input.
///
/// # Errors
/// As [`bytes()`], and [`ErrorKind::InvalidData`] where it is not UTF-8.
///
/// # Example
/// ```
/// use carom_scene::input;
/// assert!(input::text("../../examples/case_1.toml".as_ref())?.contains("[part]"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn text(path: &Path) -> Result<String> {
    String::from_utf8(bytes(path)?).map_err(|_| Error::new(ErrorKind::InvalidData, "is not UTF-8 text"))
}

/// True for what this process was given open: nobody has to come to its other end.
fn is_open_already(path: &Path) -> bool {
    ["/dev/fd", "/dev/stdin", "/proc/self/fd"].iter().any(|place| path.starts_with(place))
}

#[cfg(unix)]
fn is_pipe(metadata: &std::fs::Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt;
    metadata.file_type().is_fifo() || metadata.file_type().is_socket()
}

#[cfg(not(unix))]
fn is_pipe(_: &std::fs::Metadata) -> bool {
    false
}
